// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 27 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2498 bits, pipeline 7531 bits, memories 87744 bits.
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
  logic [5:0] sum_1282;
  assign sum_1282 = {1'b0, cfg_width_i[10:6]} + 6'h1;
  logic [6:0] sum_1286;
  assign sum_1286 = {1'b0, cfg_width_i[10:5]} + 7'h11;
  logic [6:0] sum_1301;
  assign sum_1301 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] difference_1727;
  assign difference_1727 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_1886;
  assign less_1886 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_1887;
  assign sum_1887 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_1905;
  assign not_1905 = ~cfg_prove_i;

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
  logic averager_running_mask_q;
  logic [13:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_300;
  assign select_300 = marks_first_i ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);
  // hls/stages/census.hpp:88
  logic equal_301;
  assign equal_301 = select_300[1:0] == 2'h0;
  // hls/stages/census.hpp:35
  logic [6:0] select_303;
  assign select_303 = marks_first_i ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [8:0] select_306;
  assign select_306 = ({select_303, select_300} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:40
  logic or_308;
  assign or_308 = marks_first_i | raster_at_live_q;
  logic [3:0] select_320;
  assign select_320 = marks_first_i ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:174
  logic whole;
  assign whole = equal_301 ? present_i : (present_i & averager_running_mask_q);
  // hls/stages/census.hpp:45
  logic equal_336;
  assign equal_336 = select_300 == 4'hf;
  // hls/stages/census.hpp:48
  logic equal_337;
  assign equal_337 = select_320 == 4'hf;
  // hls/stages/census.hpp:40
  logic [6:0] row;
  assign row = marks_first_i ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:698
  logic or_943;
  assign or_943 = marks_first_i | raster_row_ended_q;
  // hls/stages/agreement.hpp:700
  logic [13:0] select_945;
  assign select_945 = marks_first_i ? 14'h1 : (or_943 ? {rows_passed_q[12:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:699
  logic [8:0] select_947;
  assign select_947 = or_943 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:707
  logic select_949;
  assign select_949 = cfg_compete_i ? (or_943 & select_945[13]) : (select_947[8] & select_945[9]);
  // hls/stages/census.hpp:44
  logic [10:0] select_1057;
  assign select_1057 = marks_first_i ? cfg_height_i : (raster_rows_left_q - {10'h0, marks_last_i});

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
      averager_running_mask_q <= 1'b0;
      rows_passed_q <= 14'h0;
      columns_passed_q <= 9'h0;
    end else if (s0_en) begin
      raster_at_x_q <= select_300 + 4'h1;
      raster_at_y_q <= marks_last_i ? (select_320 + 4'h1) : select_320;
      raster_at_column_q <= select_303 + {6'h0, equal_336};
      raster_at_row_q <= marks_last_i ? (row + {6'h0, equal_337}) : row;
      raster_at_live_q <= marks_last_i ? (or_308 & (~raster_final_row_q)) : or_308;
      raster_rows_left_q <= select_1057;
      raster_row_ended_q <= marks_last_i;
      raster_final_row_q <= raster_rows_left_q == 11'h1;
      averager_place_q <= equal_301 ? select_306 : averager_place_q;
      averager_running_mask_q <= whole;
      rows_passed_q <= select_945;
      columns_passed_q <= {select_947[7:0], or_943};
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic equal_301_s1_q;
  logic [6:0] select_303_s1_q;
  logic not_313_s1_q;
  logic equal_321_s1_q;
  logic equal_336_s1_q;
  logic equal_337_s1_q;
  logic equal_342_s1_q;
  logic [6:0] row_s1_q;
  logic select_949_s1_q;
  logic [7:0] sum_1297_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      equal_301_s1_q <= equal_301;
      select_303_s1_q <= select_303;
      not_313_s1_q <= ~((~or_308) | (~(select_300[1:0] == 2'h3)));
      equal_321_s1_q <= select_320 == 4'h0;
      equal_336_s1_q <= equal_336;
      equal_337_s1_q <= equal_337;
      equal_342_s1_q <= select_300 == 4'h3;
      row_s1_q <= row;
      select_949_s1_q <= select_949;
      sum_1297_s1_q <= {1'b0, row} + 8'h1;
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
  // hls/stages/agreement.hpp:174
  logic and_316;
  assign and_316 = not_313_s1_q & (~(averager_place_q[8:5] == 4'hf));
  // hls/stages/census.hpp:105
  logic and_338;
  assign and_338 = equal_337_s1_q & and_316;
  // hls/stages/census.hpp:106
  logic and_339;
  assign and_339 = equal_336_s1_q & and_338;
  // hls/stages/agreement.hpp:334
  logic equal_354;
  assign equal_354 = run_phase_q == 3'h3;
  logic equal_356;
  assign equal_356 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:392
  logic less_357;
  assign less_357 = run_highest_q < x_q;
  // hls/stages/agreement.hpp:396
  logic not_358;
  assign not_358 = ~less_357;
  // hls/stages/agreement.hpp:640
  logic drew;
  assign drew = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:299
  logic [6:0] select_474;
  assign select_474 = equal_354 ? ({run_shift_q[5], run_shift_q} + x_q[6:0]) : x_q[6:0];
  // hls/stages/agreement.hpp:411
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1040;
  assign sum_1040 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:245
  logic equal_1214;
  assign equal_1214 = {last[7], select_303_s1_q} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:173
  logic [2:0] select_1215;
  assign select_1215 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1218;
  assign select_1218 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1221;
  assign select_1221 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1224;
  assign select_1224 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1227;
  assign select_1227 = ends_q ? following_shift_q : run_shift_q;
  logic select_1230;
  assign select_1230 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:246
  logic not_1231;
  assign not_1231 = ~equal_1214;
  // hls/stages/agreement.hpp:326
  logic not_1234;
  assign not_1234 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:334
  logic equal_1235;
  assign equal_1235 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:153
  logic or_1236;
  assign or_1236 = equal_1235 | equal_356;
  logic [2:0] select_1237;
  assign select_1237 = equal_354 ? {run_last_shift_q, {2{not_1234}}} : {1'b0, or_1236, equal_356};
  logic [7:0] select_1240;
  assign select_1240 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1241;
  assign select_1241 = equal_356 ? least_q : 7'h0;
  logic [7:0] select_1245;
  assign select_1245 = run_last_shift_q ? {1'b0, last_q} : (run_shift_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1247;
  assign select_1247 = equal_356 ? last_q : (equal_1235 ? last_q : 7'h0);
  logic [7:0] select_1253;
  assign select_1253 = equal_354 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_356 ? first_beats_q : (equal_1235 ? whole_beats_q : 8'h0));
  logic [5:0] select_1258;
  assign select_1258 = equal_354 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_356 ? (6'h0 - least_q[5:0]) : 6'h0);
  // hls/stages/agreement.hpp:136
  logic not_1260;
  assign not_1260 = ~drew;
  // hls/stages/agreement.hpp:153
  logic select_1264;
  assign select_1264 = equal_354 ? (next_last_shift_q & not_1234) : (equal_356 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1267;
  assign select_1267 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1271;
  assign select_1271 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:252
  logic less_1278;
  assign less_1278 = 6'he < select_303_s1_q[6:1];
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1281;
  assign select_1281 = and_339 ? (equal_1214 ? (less_1278 ? 7'h1e : select_303_s1_q) : least_q) : least_q;
  // hls/stages/agreement.hpp:246
  logic [7:0] select_1284;
  assign select_1284 = equal_1214 ? (less_1278 ? {sum_1282, cfg_width_i[5:4]} : 8'h23) : first_beats_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1288;
  assign select_1288 = and_339 ? (equal_1214 ? {sum_1286, cfg_width_i[4]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:302
  logic not_1289;
  assign not_1289 = ~ends_q;
  // hls/stages/agreement.hpp:173
  logic and_1294;
  assign and_1294 = not_1289 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:262
  logic equal_1298;
  assign equal_1298 = {sum_1297_s1_q[7], cfg_height_i[10:4]} == {1'b0, sum_1297_s1_q[6:0]};
  // hls/stages/agreement.hpp:512
  logic [5:0] sum_1433;
  assign sum_1433 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:146
  logic not_1789;
  assign not_1789 = ~run_shift_q[5];

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
      run_phase_q <= and_339 ? (equal_1214 ? 3'h1 : select_1215) : select_1215;
      run_lowest_q <= and_339 ? (equal_1214 ? 8'h0 : select_1218) : select_1218;
      run_highest_q <= and_339 ? (equal_1214 ? 8'h0 : select_1221) : select_1221;
      run_beats_q <= and_339 ? (equal_1214 ? 8'h20 : select_1224) : select_1224;
      run_shift_q <= and_339 ? (equal_1214 ? 6'h0 : select_1227) : select_1227;
      run_last_shift_q <= and_339 ? (select_1230 & not_1231) : select_1230;
      following_phase_q <= drew ? {final_row_q, 1'b0, final_row_q} : select_1237;
      following_lowest_q <= drew ? 8'h0 : (equal_354 ? select_1240 : {1'b0, select_1241});
      following_highest_q <= drew ? 8'h0 : (equal_354 ? select_1245 : {1'b0, select_1247});
      following_beats_q <= drew ? 8'h3f : select_1253;
      following_shift_q <= drew ? 6'h0 : select_1258;
      following_last_shift_q <= not_1260 & select_1264;
      x_q <= and_339 ? (equal_1214 ? 8'h0 : select_1267) : select_1267;
      beats_left_q <= and_339 ? (equal_1214 ? 8'h20 : select_1271) : select_1271;
      last_q <= and_339 ? (equal_1214 ? select_303_s1_q : last_q) : last_q;
      least_q <= select_1281;
      first_beats_q <= and_339 ? select_1284 : first_beats_q;
      whole_beats_q <= select_1288;
      ends_q <= and_339 ? (and_1294 & not_1231) : and_1294;
      final_row_q <= and_339 ? (equal_1214 ? equal_1298 : final_row_q) : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1789}}, 1'b1} + run_beats_q;
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
  logic equal_301_s2_q;
  logic [6:0] select_303_s2_q;
  logic [8:0] select_307_s2_q;
  logic and_316_s2_q;
  logic equal_321_s2_q;
  logic whole_s2_q;
  logic and_338_s2_q;
  logic and_339_s2_q;
  logic equal_342_s2_q;
  logic equal_354_s2_q;
  logic equal_356_s2_q;
  logic less_357_s2_q;
  logic not_358_s2_q;
  logic [6:0] row_s2_q;
  logic drew_s2_q;
  logic and_444_s2_q;
  logic [6:0] select_474_s2_q;
  logic [6:0] x_s2_2_q;
  logic not_497_s2_q;
  logic equal_504_s2_q;
  logic equal_571_s2_q;
  logic equal_808_s2_q;
  logic equal_872_s2_q;
  logic equal_895_s2_q;
  logic equal_898_s2_q;
  logic select_949_s2_q;
  logic not_1042_s2_q;
  logic equal_1214_s2_q;
  logic not_1260_s2_q;
  logic not_1289_s2_q;
  logic less_1434_s2_q;
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
      equal_301_s2_q <= equal_301_s1_q;
      select_303_s2_q <= select_303_s1_q;
      select_307_s2_q <= averager_place_q;
      and_316_s2_q <= and_316;
      equal_321_s2_q <= equal_321_s1_q;
      whole_s2_q <= averager_running_mask_q;
      and_338_s2_q <= and_338;
      and_339_s2_q <= and_339;
      equal_342_s2_q <= equal_342_s1_q;
      equal_354_s2_q <= equal_354;
      equal_356_s2_q <= equal_356;
      less_357_s2_q <= less_357;
      not_358_s2_q <= not_358;
      row_s2_q <= row_s1_q;
      drew_s2_q <= drew;
      and_444_s2_q <= drew & not_358;
      select_474_s2_q <= select_474;
      x_s2_2_q <= x[6:0];
      not_497_s2_q <= ~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q});
      equal_504_s2_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_571_s2_q <= run_lowest_q == x_q;
      equal_808_s2_q <= run_lowest_q == x;
      equal_872_s2_q <= run_highest_q == x;
      equal_895_s2_q <= x_q == {1'b0, last_q};
      equal_898_s2_q <= run_phase_q == 3'h5;
      select_949_s2_q <= select_949_s1_q;
      not_1042_s2_q <= ~({sum_1040, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1214_s2_q <= equal_1214;
      not_1260_s2_q <= not_1260;
      not_1289_s2_q <= not_1289;
      less_1434_s2_q <= {1'b0, sum_1433, last_q[1]} < x_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:299
  logic and_359;
  assign and_359 = equal_356_s2_q & not_358_s2_q;
  logic select_446;
  assign select_446 = equal_354_s2_q ? not_358_s2_q : (equal_356_s2_q ? not_358_s2_q : and_444_s2_q);
  // hls/stages/agreement.hpp:173
  logic [5:0] select_1290;
  assign select_1290 = ends_s2_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1292;
  assign select_1292 = and_339_s2_q ? (equal_1214_s2_q ? 7'h0 : {select_1290, not_1289_s2_q}) : {select_1290, not_1289_s2_q};

  // Memory left, 120 x 77, DISTANCE 32, hls/stages/agreement.hpp:766; read in stage 2, written in stage 5: 2 < 5 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s2_q[6:0];
  logic left_re;
  assign left_re = s2_en & select_446;
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 32, hls/stages/agreement.hpp:767; read in stage 2, written in stage 5: 2 < 5 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_474_s2_q;
  logic right_codes_re;
  assign right_codes_re = s2_en & (equal_354_s2_q ? not_358_s2_q : and_359);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s2_en) begin
      age_q <= select_1292;
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
  logic equal_301_s3_q;
  logic [6:0] select_303_s3_q;
  logic [8:0] select_307_s3_q;
  logic and_316_s3_q;
  logic equal_321_s3_q;
  logic whole_s3_q;
  logic and_338_s3_q;
  logic and_339_s3_q;
  logic equal_342_s3_q;
  logic equal_354_s3_q;
  logic equal_356_s3_q;
  logic less_357_s3_q;
  logic not_358_s3_q;
  logic and_359_s3_q;
  logic [6:0] row_s3_q;
  logic drew_s3_q;
  logic and_444_s3_q;
  logic [6:0] x_s3_2_q;
  logic and_498_s3_q;
  logic equal_504_s3_q;
  logic equal_571_s3_q;
  logic equal_808_s3_q;
  logic equal_872_s3_q;
  logic equal_895_s3_q;
  logic equal_898_s3_q;
  logic select_949_s3_q;
  logic not_1042_s3_q;
  logic equal_1214_s3_q;
  logic not_1260_s3_q;
  logic less_1434_s3_q;
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
      equal_301_s3_q <= equal_301_s2_q;
      select_303_s3_q <= select_303_s2_q;
      select_307_s3_q <= select_307_s2_q;
      and_316_s3_q <= and_316_s2_q;
      equal_321_s3_q <= equal_321_s2_q;
      whole_s3_q <= whole_s2_q;
      and_338_s3_q <= and_338_s2_q;
      and_339_s3_q <= and_339_s2_q;
      equal_342_s3_q <= equal_342_s2_q;
      equal_354_s3_q <= equal_354_s2_q;
      equal_356_s3_q <= equal_356_s2_q;
      less_357_s3_q <= less_357_s2_q;
      not_358_s3_q <= not_358_s2_q;
      and_359_s3_q <= and_359;
      row_s3_q <= row_s2_q;
      drew_s3_q <= drew_s2_q;
      and_444_s3_q <= and_444_s2_q;
      x_s3_2_q <= x_s2_2_q;
      and_498_s3_q <= age_q[2] & not_497_s2_q;
      equal_504_s3_q <= equal_504_s2_q;
      equal_571_s3_q <= equal_571_s2_q;
      equal_808_s3_q <= equal_808_s2_q;
      equal_872_s3_q <= equal_872_s2_q;
      equal_895_s3_q <= equal_895_s2_q;
      equal_898_s3_q <= equal_898_s2_q;
      select_949_s3_q <= select_949_s2_q;
      not_1042_s3_q <= not_1042_s2_q;
      equal_1214_s3_q <= equal_1214_s2_q;
      not_1260_s3_q <= not_1260_s2_q;
      less_1434_s3_q <= less_1434_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:321
  logic not_355;
  assign not_355 = ~equal_354_s3_q;
  // hls/stages/agreement.hpp:299
  logic and_360;
  assign and_360 = not_355 & and_359_s3_q;

  // Memory fresh, 120 x 29, DISTANCE 32, hls/stages/agreement.hpp:765; read in stage 3, written in stage 25: 3 < 25 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s3_q[6:0];
  logic fresh_re;
  assign fresh_re = s3_en & and_360;
  logic [28:0] fresh_rdata_q;
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
  logic equal_301_s4_q;
  logic [6:0] select_303_s4_q;
  logic [8:0] select_307_s4_q;
  logic and_316_s4_q;
  logic equal_321_s4_q;
  logic whole_s4_q;
  logic and_338_s4_q;
  logic and_339_s4_q;
  logic equal_342_s4_q;
  logic equal_354_s4_q;
  logic not_355_s4_q;
  logic equal_356_s4_q;
  logic less_357_s4_q;
  logic not_358_s4_q;
  logic and_360_s4_q;
  logic [6:0] row_s4_q;
  logic drew_s4_q;
  logic and_444_s4_q;
  logic [76:0] left_rdata_s4_q;
  logic [90:0] right_codes_rdata_s4_q;
  logic [6:0] x_s4_2_q;
  logic and_498_s4_q;
  logic equal_504_s4_q;
  logic equal_571_s4_q;
  logic equal_808_s4_q;
  logic equal_872_s4_q;
  logic equal_895_s4_q;
  logic equal_898_s4_q;
  logic select_949_s4_q;
  logic not_1042_s4_q;
  logic equal_1214_s4_q;
  logic not_1260_s4_q;
  logic less_1434_s4_q;
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
      equal_301_s4_q <= equal_301_s3_q;
      select_303_s4_q <= select_303_s3_q;
      select_307_s4_q <= select_307_s3_q;
      and_316_s4_q <= and_316_s3_q;
      equal_321_s4_q <= equal_321_s3_q;
      whole_s4_q <= whole_s3_q;
      and_338_s4_q <= and_338_s3_q;
      and_339_s4_q <= and_339_s3_q;
      equal_342_s4_q <= equal_342_s3_q;
      equal_354_s4_q <= equal_354_s3_q;
      not_355_s4_q <= not_355;
      equal_356_s4_q <= equal_356_s3_q;
      less_357_s4_q <= less_357_s3_q;
      not_358_s4_q <= not_358_s3_q;
      and_360_s4_q <= and_360;
      row_s4_q <= row_s3_q;
      drew_s4_q <= drew_s3_q;
      and_444_s4_q <= and_444_s3_q;
      left_rdata_s4_q <= left_rdata_q;
      right_codes_rdata_s4_q <= right_codes_rdata_q;
      x_s4_2_q <= x_s3_2_q;
      and_498_s4_q <= and_498_s3_q;
      equal_504_s4_q <= equal_504_s3_q;
      equal_571_s4_q <= equal_571_s3_q;
      equal_808_s4_q <= equal_808_s3_q;
      equal_872_s4_q <= equal_872_s3_q;
      equal_895_s4_q <= equal_895_s3_q;
      equal_898_s4_q <= equal_898_s3_q;
      select_949_s4_q <= select_949_s3_q;
      not_1042_s4_q <= not_1042_s3_q;
      equal_1214_s4_q <= equal_1214_s3_q;
      not_1260_s4_q <= not_1260_s3_q;
      less_1434_s4_q <= less_1434_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:367
  logic equal_448;
  assign equal_448 = row_q == 7'h0;
  logic not_450;
  assign not_450 = ~equal_448;
  logic equal_455;
  assign equal_455 = row_q[6:1] == 6'h0;
  logic not_457;
  assign not_457 = ~equal_455;
  logic less_462;
  assign less_462 = row_q < 7'h3;
  logic not_464;
  assign not_464 = ~less_462;
  logic equal_469;
  assign equal_469 = row_q[6:2] == 5'h0;
  logic not_471;
  assign not_471 = ~equal_469;
  // hls/stages/agreement.hpp:368
  logic less_485;
  assign less_485 = row_q < 7'h5;
  logic less_489;
  assign less_489 = row_q[6:1] < 6'h3;
  // hls/stages/agreement.hpp:162
  logic and_510;
  assign and_510 = left_rdata_s4_q[44] & not_358_s4_q;
  logic [11:0] a;
  assign a = less_357_s4_q ? 12'h0 : left_rdata_s4_q[43:32];
  logic [11:0] b;
  assign b = less_357_s4_q ? 12'h0 : right_codes_rdata_s4_q[37:26];
  logic [11:0] a_2;
  assign a_2 = less_357_s4_q ? 12'h0 : left_rdata_s4_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_357_s4_q ? 12'h0 : right_codes_rdata_s4_q[50:39];
  logic and_549;
  assign and_549 = left_rdata_s4_q[76] & not_358_s4_q;
  logic [11:0] a_3;
  assign a_3 = less_357_s4_q ? 12'h0 : left_rdata_s4_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_357_s4_q ? 12'h0 : right_codes_rdata_s4_q[63:52];
  logic [11:0] b_4;
  assign b_4 = less_357_s4_q ? 12'h0 : right_codes_rdata_s4_q[76:65];
  logic [11:0] b_5;
  assign b_5 = less_357_s4_q ? 12'h0 : right_codes_rdata_s4_q[24:13];
  logic [11:0] b_6;
  assign b_6 = less_357_s4_q ? 12'h0 : right_codes_rdata_s4_q[89:78];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_721;
  assign not_721 = ~(a_3 ^ b_6);
  // hls/stages/agreement.hpp:162
  logic [11:0] b_7;
  assign b_7 = less_357_s4_q ? 12'h0 : right_codes_rdata_s4_q[11:0];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_750;
  assign not_750 = ~(a ^ b_7);
  // hls/stages/agreement.hpp:504
  logic not_907;
  assign not_907 = ~(row_q[6:3] == 4'h0);
  // hls/stages/agreement.hpp:299
  logic and_1044;
  assign and_1044 = drew_s4_q & (((7'h6 < row_q) & (~(x_s4_q[7:2] == 6'h0))) & not_1042_s4_q);
  // hls/stages/agreement.hpp:246
  logic select_1304;
  assign select_1304 = equal_1214_s4_q ? (~({row_s4_q, 1'b0} < {sum_1301, cfg_height_i[4]})) : lower_half_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s4_en) begin
      row_q <= and_339_s4_q ? (equal_1214_s4_q ? row_s4_q : row_q) : row_q;
      lower_half_q <= and_339_s4_q ? select_1304 : lower_half_q;
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
  logic equal_301_s5_q;
  logic [6:0] select_303_s5_q;
  logic [8:0] select_307_s5_q;
  logic and_316_s5_q;
  logic equal_321_s5_q;
  logic whole_s5_q;
  logic and_338_s5_q;
  logic and_339_s5_q;
  logic equal_342_s5_q;
  logic equal_354_s5_q;
  logic not_355_s5_q;
  logic equal_356_s5_q;
  logic less_357_s5_q;
  logic not_358_s5_q;
  logic and_360_s5_q;
  logic [28:0] fresh_rdata_s5_q;
  logic equal_388_s5_q;
  logic drew_s5_q;
  logic and_444_s5_q;
  logic left_rdata_s5_q;
  logic [11:0] select_449_s5_q;
  logic and_451_s5_q;
  logic and_452_s5_q;
  logic and_453_s5_q;
  logic and_454_s5_q;
  logic [11:0] select_456_s5_q;
  logic and_458_s5_q;
  logic and_459_s5_q;
  logic and_460_s5_q;
  logic and_461_s5_q;
  logic [11:0] select_463_s5_q;
  logic and_465_s5_q;
  logic and_466_s5_q;
  logic and_467_s5_q;
  logic and_468_s5_q;
  logic [11:0] select_470_s5_q;
  logic and_472_s5_q;
  logic [11:0] select_477_s5_q;
  logic and_478_s5_q;
  logic [11:0] select_479_s5_q;
  logic and_480_s5_q;
  logic [11:0] select_481_s5_q;
  logic and_482_s5_q;
  logic [11:0] select_483_s5_q;
  logic and_484_s5_q;
  logic [11:0] select_486_s5_q;
  logic and_488_s5_q;
  logic [11:0] select_490_s5_q;
  logic and_492_s5_q;
  logic [6:0] x_s5_2_q;
  logic and_498_s5_q;
  logic equal_504_s5_q;
  logic and_510_s5_q;
  logic and_511_s5_q;
  logic [11:0] a_s5_q;
  logic [11:0] b_s5_q;
  logic and_529_s5_q;
  logic and_530_s5_q;
  logic [11:0] a_2_s5_q;
  logic [11:0] b_2_s5_q;
  logic and_549_s5_q;
  logic and_550_s5_q;
  logic [11:0] a_3_s5_q;
  logic [11:0] b_3_s5_q;
  logic equal_571_s5_q;
  logic and_605_s5_q;
  logic [11:0] b_4_s5_q;
  logic and_629_s5_q;
  logic [11:0] b_5_s5_q;
  logic and_718_s5_q;
  logic [9:0] not_721_s5_q;
  logic [1:0] sum_722_s5_q;
  logic and_747_s5_q;
  logic [9:0] not_750_s5_q;
  logic [1:0] sum_751_s5_q;
  logic equal_808_s5_q;
  logic equal_872_s5_q;
  logic equal_895_s5_q;
  logic equal_898_s5_q;
  logic and_909_s5_q;
  logic select_949_s5_q;
  logic and_1044_s5_q;
  logic equal_1163_s5_q;
  logic equal_1214_s5_q;
  logic not_1260_s5_q;
  logic and_1348_s5_q;
  logic less_1431_s5_q;
  logic less_1434_s5_q;
  logic equal_1696_s5_q;
  logic less_1707_s5_q;
  logic equal_1864_s5_q;
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
      equal_301_s5_q <= equal_301_s4_q;
      select_303_s5_q <= select_303_s4_q;
      select_307_s5_q <= select_307_s4_q;
      and_316_s5_q <= and_316_s4_q;
      equal_321_s5_q <= equal_321_s4_q;
      whole_s5_q <= whole_s4_q;
      and_338_s5_q <= and_338_s4_q;
      and_339_s5_q <= and_339_s4_q;
      equal_342_s5_q <= equal_342_s4_q;
      equal_354_s5_q <= equal_354_s4_q;
      not_355_s5_q <= not_355_s4_q;
      equal_356_s5_q <= equal_356_s4_q;
      less_357_s5_q <= less_357_s4_q;
      not_358_s5_q <= not_358_s4_q;
      and_360_s5_q <= and_360_s4_q;
      fresh_rdata_s5_q <= fresh_rdata_q;
      equal_388_s5_q <= row_s4_q == 7'h0;
      drew_s5_q <= drew_s4_q;
      and_444_s5_q <= and_444_s4_q;
      left_rdata_s5_q <= left_rdata_s4_q[63];
      select_449_s5_q <= equal_448 ? 12'h0 : left_rdata_s4_q[11:0];
      and_451_s5_q <= left_rdata_s4_q[12] & not_450;
      and_452_s5_q <= left_rdata_s4_q[13] & not_450;
      and_453_s5_q <= left_rdata_s4_q[14] & not_450;
      and_454_s5_q <= left_rdata_s4_q[15] & not_450;
      select_456_s5_q <= equal_455 ? 12'h0 : left_rdata_s4_q[27:16];
      and_458_s5_q <= left_rdata_s4_q[28] & not_457;
      and_459_s5_q <= left_rdata_s4_q[29] & not_457;
      and_460_s5_q <= left_rdata_s4_q[30] & not_457;
      and_461_s5_q <= left_rdata_s4_q[31] & not_457;
      select_463_s5_q <= less_462 ? 12'h0 : left_rdata_s4_q[43:32];
      and_465_s5_q <= left_rdata_s4_q[44] & not_464;
      and_466_s5_q <= left_rdata_s4_q[45] & not_464;
      and_467_s5_q <= left_rdata_s4_q[46] & not_464;
      and_468_s5_q <= left_rdata_s4_q[47] & not_464;
      select_470_s5_q <= equal_469 ? 12'h0 : left_rdata_s4_q[59:48];
      and_472_s5_q <= left_rdata_s4_q[60] & not_471;
      select_477_s5_q <= equal_448 ? 12'h0 : right_codes_rdata_s4_q[11:0];
      and_478_s5_q <= right_codes_rdata_s4_q[12] & not_450;
      select_479_s5_q <= equal_455 ? 12'h0 : right_codes_rdata_s4_q[24:13];
      and_480_s5_q <= right_codes_rdata_s4_q[25] & not_457;
      select_481_s5_q <= less_462 ? 12'h0 : right_codes_rdata_s4_q[37:26];
      and_482_s5_q <= right_codes_rdata_s4_q[38] & not_464;
      select_483_s5_q <= equal_469 ? 12'h0 : right_codes_rdata_s4_q[50:39];
      and_484_s5_q <= right_codes_rdata_s4_q[51] & not_471;
      select_486_s5_q <= less_485 ? 12'h0 : right_codes_rdata_s4_q[63:52];
      and_488_s5_q <= right_codes_rdata_s4_q[64] & (~less_485);
      select_490_s5_q <= less_489 ? 12'h0 : right_codes_rdata_s4_q[76:65];
      and_492_s5_q <= right_codes_rdata_s4_q[77] & (~less_489);
      x_s5_2_q <= x_s4_2_q;
      and_498_s5_q <= and_498_s4_q;
      equal_504_s5_q <= equal_504_s4_q;
      and_510_s5_q <= and_510;
      and_511_s5_q <= right_codes_rdata_s4_q[38] & not_358_s4_q;
      a_s5_q <= a;
      b_s5_q <= b;
      and_529_s5_q <= left_rdata_s4_q[60] & not_358_s4_q;
      and_530_s5_q <= right_codes_rdata_s4_q[51] & not_358_s4_q;
      a_2_s5_q <= a_2;
      b_2_s5_q <= b_2;
      and_549_s5_q <= and_549;
      and_550_s5_q <= right_codes_rdata_s4_q[64] & not_358_s4_q;
      a_3_s5_q <= a_3;
      b_3_s5_q <= b_3;
      equal_571_s5_q <= equal_571_s4_q;
      and_605_s5_q <= right_codes_rdata_s4_q[77] & not_358_s4_q;
      b_4_s5_q <= b_4;
      and_629_s5_q <= right_codes_rdata_s4_q[25] & not_358_s4_q;
      b_5_s5_q <= b_5;
      and_718_s5_q <= and_549 & (right_codes_rdata_s4_q[90] & not_358_s4_q);
      not_721_s5_q <= not_721[11:2];
      sum_722_s5_q <= {1'b0, not_721[0]} + {1'b0, not_721[1]};
      and_747_s5_q <= and_510 & (right_codes_rdata_s4_q[12] & not_358_s4_q);
      not_750_s5_q <= not_750[11:2];
      sum_751_s5_q <= {1'b0, not_750[0]} + {1'b0, not_750[1]};
      equal_808_s5_q <= equal_808_s4_q;
      equal_872_s5_q <= equal_872_s4_q;
      equal_895_s5_q <= equal_895_s4_q;
      equal_898_s5_q <= equal_898_s4_q;
      and_909_s5_q <= left_rdata_s4_q[61] & (left_rdata_s4_q[62] & not_907);
      select_949_s5_q <= select_949_s4_q;
      and_1044_s5_q <= and_1044;
      equal_1163_s5_q <= (select_303_s4_q | row_s4_q) == 7'h0;
      equal_1214_s5_q <= equal_1214_s4_q;
      not_1260_s5_q <= not_1260_s4_q;
      and_1348_s5_q <= left_rdata_s4_q[61] & not_907;
      less_1431_s5_q <= 6'h4 < row_q[6:1];
      less_1434_s5_q <= less_1434_s4_q;
      equal_1696_s5_q <= row_s4_q[6:2] == 5'h0;
      less_1707_s5_q <= 6'h2 < row_s4_q[6:1];
      equal_1864_s5_q <= row_s4_q[6:3] == 4'h0;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:377
  logic [11:0] not_516;
  assign not_516 = ~(a_s5_q ^ b_s5_q);
  logic [1:0] sum_518;
  assign sum_518 = {1'b0, not_516[2]} + ({1'b0, not_516[0]} + {1'b0, not_516[1]});
  logic [11:0] not_535;
  assign not_535 = ~(a_2_s5_q ^ b_2_s5_q);
  logic [1:0] sum_537;
  assign sum_537 = {1'b0, not_535[2]} + ({1'b0, not_535[0]} + {1'b0, not_535[1]});
  logic [11:0] not_555;
  assign not_555 = ~(a_3_s5_q ^ b_3_s5_q);
  logic [1:0] sum_557;
  assign sum_557 = {1'b0, not_555[2]} + ({1'b0, not_555[0]} + {1'b0, not_555[1]});
  logic [11:0] not_576;
  assign not_576 = ~(a_s5_q ^ b_2_s5_q);
  logic [1:0] sum_578;
  assign sum_578 = {1'b0, not_576[2]} + ({1'b0, not_576[0]} + {1'b0, not_576[1]});
  logic [11:0] not_591;
  assign not_591 = ~(a_2_s5_q ^ b_3_s5_q);
  logic [1:0] sum_593;
  assign sum_593 = {1'b0, not_591[2]} + ({1'b0, not_591[0]} + {1'b0, not_591[1]});
  logic [11:0] not_609;
  assign not_609 = ~(a_3_s5_q ^ b_4_s5_q);
  logic [1:0] sum_611;
  assign sum_611 = {1'b0, not_609[2]} + ({1'b0, not_609[0]} + {1'b0, not_609[1]});
  logic [11:0] not_633;
  assign not_633 = ~(a_s5_q ^ b_5_s5_q);
  logic [1:0] sum_635;
  assign sum_635 = {1'b0, not_633[2]} + ({1'b0, not_633[0]} + {1'b0, not_633[1]});
  logic [11:0] not_648;
  assign not_648 = ~(a_2_s5_q ^ b_s5_q);
  logic [1:0] sum_650;
  assign sum_650 = {1'b0, not_648[2]} + ({1'b0, not_648[0]} + {1'b0, not_648[1]});
  logic [11:0] not_664;
  assign not_664 = ~(a_3_s5_q ^ b_2_s5_q);
  logic [1:0] sum_666;
  assign sum_666 = {1'b0, not_664[2]} + ({1'b0, not_664[0]} + {1'b0, not_664[1]});
  logic [11:0] not_688;
  assign not_688 = ~(a_s5_q ^ b_3_s5_q);
  logic [1:0] sum_690;
  assign sum_690 = {1'b0, not_688[2]} + ({1'b0, not_688[0]} + {1'b0, not_688[1]});
  logic [11:0] not_703;
  assign not_703 = ~(a_2_s5_q ^ b_4_s5_q);
  logic [1:0] sum_705;
  assign sum_705 = {1'b0, not_703[2]} + ({1'b0, not_703[0]} + {1'b0, not_703[1]});
  logic [1:0] sum_723;
  assign sum_723 = {1'b0, not_721_s5_q[0]} + sum_722_s5_q;
  logic [1:0] sum_752;
  assign sum_752 = {1'b0, not_750_s5_q[0]} + sum_751_s5_q;
  logic [11:0] not_765;
  assign not_765 = ~(a_2_s5_q ^ b_5_s5_q);
  logic [1:0] sum_767;
  assign sum_767 = {1'b0, not_765[2]} + ({1'b0, not_765[0]} + {1'b0, not_765[1]});
  logic [11:0] not_781;
  assign not_781 = ~(a_3_s5_q ^ b_s5_q);
  logic [1:0] sum_783;
  assign sum_783 = {1'b0, not_781[2]} + ({1'b0, not_781[0]} + {1'b0, not_781[1]});

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s5_q[6:0];
  logic left_we;
  assign left_we = s5_en & and_360_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_472_s5_q, select_470_s5_q, and_468_s5_q, and_467_s5_q, and_466_s5_q, and_465_s5_q, select_463_s5_q, and_461_s5_q, and_460_s5_q, and_459_s5_q, and_458_s5_q, select_456_s5_q, and_454_s5_q, and_453_s5_q, and_452_s5_q, and_451_s5_q, select_449_s5_q, fresh_rdata_s5_q[28:26], fresh_rdata_s5_q[24], fresh_rdata_s5_q[11:0]};
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
  assign right_codes_we = s5_en & and_360_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_492_s5_q, select_490_s5_q, and_488_s5_q, select_486_s5_q, and_484_s5_q, select_483_s5_q, and_482_s5_q, select_481_s5_q, and_480_s5_q, select_479_s5_q, and_478_s5_q, select_477_s5_q, fresh_rdata_s5_q[25], fresh_rdata_s5_q[23:12]};
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
  logic equal_301_s6_q;
  logic [6:0] select_303_s6_q;
  logic [8:0] select_307_s6_q;
  logic and_316_s6_q;
  logic equal_321_s6_q;
  logic whole_s6_q;
  logic and_338_s6_q;
  logic and_339_s6_q;
  logic equal_342_s6_q;
  logic equal_354_s6_q;
  logic not_355_s6_q;
  logic equal_356_s6_q;
  logic less_357_s6_q;
  logic not_358_s6_q;
  logic equal_388_s6_q;
  logic drew_s6_q;
  logic and_444_s6_q;
  logic left_rdata_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_498_s6_q;
  logic equal_504_s6_q;
  logic and_510_s6_q;
  logic and_511_s6_q;
  logic [7:0] not_516_s6_q;
  logic [2:0] sum_519_s6_q;
  logic and_529_s6_q;
  logic and_530_s6_q;
  logic [7:0] not_535_s6_q;
  logic [2:0] sum_538_s6_q;
  logic and_549_s6_q;
  logic and_550_s6_q;
  logic [7:0] not_555_s6_q;
  logic [2:0] sum_558_s6_q;
  logic equal_571_s6_q;
  logic [7:0] not_576_s6_q;
  logic [2:0] sum_579_s6_q;
  logic [7:0] not_591_s6_q;
  logic [2:0] sum_594_s6_q;
  logic and_605_s6_q;
  logic [7:0] not_609_s6_q;
  logic [2:0] sum_612_s6_q;
  logic and_629_s6_q;
  logic [7:0] not_633_s6_q;
  logic [2:0] sum_636_s6_q;
  logic [7:0] not_648_s6_q;
  logic [2:0] sum_651_s6_q;
  logic [7:0] not_664_s6_q;
  logic [2:0] sum_667_s6_q;
  logic [7:0] not_688_s6_q;
  logic [2:0] sum_691_s6_q;
  logic [7:0] not_703_s6_q;
  logic [2:0] sum_706_s6_q;
  logic and_718_s6_q;
  logic [7:0] not_721_s6_q;
  logic [2:0] sum_724_s6_q;
  logic and_747_s6_q;
  logic [7:0] not_750_s6_q;
  logic [2:0] sum_753_s6_q;
  logic [7:0] not_765_s6_q;
  logic [2:0] sum_768_s6_q;
  logic [7:0] not_781_s6_q;
  logic [2:0] sum_784_s6_q;
  logic equal_808_s6_q;
  logic equal_872_s6_q;
  logic equal_895_s6_q;
  logic equal_898_s6_q;
  logic and_909_s6_q;
  logic select_949_s6_q;
  logic and_1044_s6_q;
  logic equal_1163_s6_q;
  logic equal_1214_s6_q;
  logic not_1260_s6_q;
  logic and_1348_s6_q;
  logic less_1431_s6_q;
  logic less_1434_s6_q;
  logic equal_1696_s6_q;
  logic less_1707_s6_q;
  logic equal_1864_s6_q;
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
      equal_301_s6_q <= equal_301_s5_q;
      select_303_s6_q <= select_303_s5_q;
      select_307_s6_q <= select_307_s5_q;
      and_316_s6_q <= and_316_s5_q;
      equal_321_s6_q <= equal_321_s5_q;
      whole_s6_q <= whole_s5_q;
      and_338_s6_q <= and_338_s5_q;
      and_339_s6_q <= and_339_s5_q;
      equal_342_s6_q <= equal_342_s5_q;
      equal_354_s6_q <= equal_354_s5_q;
      not_355_s6_q <= not_355_s5_q;
      equal_356_s6_q <= equal_356_s5_q;
      less_357_s6_q <= less_357_s5_q;
      not_358_s6_q <= not_358_s5_q;
      equal_388_s6_q <= equal_388_s5_q;
      drew_s6_q <= drew_s5_q;
      and_444_s6_q <= and_444_s5_q;
      left_rdata_s6_q <= left_rdata_s5_q;
      x_s6_2_q <= x_s5_2_q;
      and_498_s6_q <= and_498_s5_q;
      equal_504_s6_q <= equal_504_s5_q;
      and_510_s6_q <= and_510_s5_q;
      and_511_s6_q <= and_511_s5_q;
      not_516_s6_q <= not_516[11:4];
      sum_519_s6_q <= {2'h0, not_516[3]} + {1'b0, sum_518};
      and_529_s6_q <= and_529_s5_q;
      and_530_s6_q <= and_530_s5_q;
      not_535_s6_q <= not_535[11:4];
      sum_538_s6_q <= {2'h0, not_535[3]} + {1'b0, sum_537};
      and_549_s6_q <= and_549_s5_q;
      and_550_s6_q <= and_550_s5_q;
      not_555_s6_q <= not_555[11:4];
      sum_558_s6_q <= {2'h0, not_555[3]} + {1'b0, sum_557};
      equal_571_s6_q <= equal_571_s5_q;
      not_576_s6_q <= not_576[11:4];
      sum_579_s6_q <= {2'h0, not_576[3]} + {1'b0, sum_578};
      not_591_s6_q <= not_591[11:4];
      sum_594_s6_q <= {2'h0, not_591[3]} + {1'b0, sum_593};
      and_605_s6_q <= and_605_s5_q;
      not_609_s6_q <= not_609[11:4];
      sum_612_s6_q <= {2'h0, not_609[3]} + {1'b0, sum_611};
      and_629_s6_q <= and_629_s5_q;
      not_633_s6_q <= not_633[11:4];
      sum_636_s6_q <= {2'h0, not_633[3]} + {1'b0, sum_635};
      not_648_s6_q <= not_648[11:4];
      sum_651_s6_q <= {2'h0, not_648[3]} + {1'b0, sum_650};
      not_664_s6_q <= not_664[11:4];
      sum_667_s6_q <= {2'h0, not_664[3]} + {1'b0, sum_666};
      not_688_s6_q <= not_688[11:4];
      sum_691_s6_q <= {2'h0, not_688[3]} + {1'b0, sum_690};
      not_703_s6_q <= not_703[11:4];
      sum_706_s6_q <= {2'h0, not_703[3]} + {1'b0, sum_705};
      and_718_s6_q <= and_718_s5_q;
      not_721_s6_q <= not_721_s5_q[9:2];
      sum_724_s6_q <= {2'h0, not_721_s5_q[1]} + {1'b0, sum_723};
      and_747_s6_q <= and_747_s5_q;
      not_750_s6_q <= not_750_s5_q[9:2];
      sum_753_s6_q <= {2'h0, not_750_s5_q[1]} + {1'b0, sum_752};
      not_765_s6_q <= not_765[11:4];
      sum_768_s6_q <= {2'h0, not_765[3]} + {1'b0, sum_767};
      not_781_s6_q <= not_781[11:4];
      sum_784_s6_q <= {2'h0, not_781[3]} + {1'b0, sum_783};
      equal_808_s6_q <= equal_808_s5_q;
      equal_872_s6_q <= equal_872_s5_q;
      equal_895_s6_q <= equal_895_s5_q;
      equal_898_s6_q <= equal_898_s5_q;
      and_909_s6_q <= and_909_s5_q;
      select_949_s6_q <= select_949_s5_q;
      and_1044_s6_q <= and_1044_s5_q;
      equal_1163_s6_q <= equal_1163_s5_q;
      equal_1214_s6_q <= equal_1214_s5_q;
      not_1260_s6_q <= not_1260_s5_q;
      and_1348_s6_q <= and_1348_s5_q;
      less_1431_s6_q <= less_1431_s5_q;
      less_1434_s6_q <= less_1434_s5_q;
      equal_1696_s6_q <= equal_1696_s5_q;
      less_1707_s6_q <= less_1707_s5_q;
      equal_1864_s6_q <= equal_1864_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:377
  logic [2:0] sum_521;
  assign sum_521 = {2'h0, not_516_s6_q[1]} + ({2'h0, not_516_s6_q[0]} + sum_519_s6_q);
  logic [2:0] sum_540;
  assign sum_540 = {2'h0, not_535_s6_q[1]} + ({2'h0, not_535_s6_q[0]} + sum_538_s6_q);
  logic [2:0] sum_560;
  assign sum_560 = {2'h0, not_555_s6_q[1]} + ({2'h0, not_555_s6_q[0]} + sum_558_s6_q);
  logic [2:0] sum_581;
  assign sum_581 = {2'h0, not_576_s6_q[1]} + ({2'h0, not_576_s6_q[0]} + sum_579_s6_q);
  logic [2:0] sum_596;
  assign sum_596 = {2'h0, not_591_s6_q[1]} + ({2'h0, not_591_s6_q[0]} + sum_594_s6_q);
  logic [2:0] sum_614;
  assign sum_614 = {2'h0, not_609_s6_q[1]} + ({2'h0, not_609_s6_q[0]} + sum_612_s6_q);
  logic [2:0] sum_638;
  assign sum_638 = {2'h0, not_633_s6_q[1]} + ({2'h0, not_633_s6_q[0]} + sum_636_s6_q);
  logic [2:0] sum_653;
  assign sum_653 = {2'h0, not_648_s6_q[1]} + ({2'h0, not_648_s6_q[0]} + sum_651_s6_q);
  logic [2:0] sum_669;
  assign sum_669 = {2'h0, not_664_s6_q[1]} + ({2'h0, not_664_s6_q[0]} + sum_667_s6_q);
  logic [2:0] sum_693;
  assign sum_693 = {2'h0, not_688_s6_q[1]} + ({2'h0, not_688_s6_q[0]} + sum_691_s6_q);
  logic [2:0] sum_708;
  assign sum_708 = {2'h0, not_703_s6_q[1]} + ({2'h0, not_703_s6_q[0]} + sum_706_s6_q);
  logic [2:0] sum_726;
  assign sum_726 = {2'h0, not_721_s6_q[1]} + ({2'h0, not_721_s6_q[0]} + sum_724_s6_q);
  logic [2:0] sum_755;
  assign sum_755 = {2'h0, not_750_s6_q[1]} + ({2'h0, not_750_s6_q[0]} + sum_753_s6_q);
  logic [2:0] sum_770;
  assign sum_770 = {2'h0, not_765_s6_q[1]} + ({2'h0, not_765_s6_q[0]} + sum_768_s6_q);
  logic [2:0] sum_786;
  assign sum_786 = {2'h0, not_781_s6_q[1]} + ({2'h0, not_781_s6_q[0]} + sum_784_s6_q);

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
  logic equal_301_s7_q;
  logic [6:0] select_303_s7_q;
  logic [8:0] select_307_s7_q;
  logic and_316_s7_q;
  logic equal_321_s7_q;
  logic whole_s7_q;
  logic and_338_s7_q;
  logic and_339_s7_q;
  logic equal_342_s7_q;
  logic equal_354_s7_q;
  logic not_355_s7_q;
  logic equal_356_s7_q;
  logic less_357_s7_q;
  logic not_358_s7_q;
  logic equal_388_s7_q;
  logic drew_s7_q;
  logic and_444_s7_q;
  logic left_rdata_s7_q;
  logic [6:0] x_s7_2_q;
  logic and_498_s7_q;
  logic equal_504_s7_q;
  logic and_510_s7_q;
  logic and_511_s7_q;
  logic [5:0] not_516_s7_q;
  logic [2:0] sum_521_s7_q;
  logic and_529_s7_q;
  logic and_530_s7_q;
  logic [5:0] not_535_s7_q;
  logic [2:0] sum_540_s7_q;
  logic and_549_s7_q;
  logic and_550_s7_q;
  logic [5:0] not_555_s7_q;
  logic [2:0] sum_560_s7_q;
  logic equal_571_s7_q;
  logic [5:0] not_576_s7_q;
  logic [2:0] sum_581_s7_q;
  logic [5:0] not_591_s7_q;
  logic [2:0] sum_596_s7_q;
  logic and_605_s7_q;
  logic [5:0] not_609_s7_q;
  logic [2:0] sum_614_s7_q;
  logic and_629_s7_q;
  logic [5:0] not_633_s7_q;
  logic [2:0] sum_638_s7_q;
  logic [5:0] not_648_s7_q;
  logic [2:0] sum_653_s7_q;
  logic [5:0] not_664_s7_q;
  logic [2:0] sum_669_s7_q;
  logic [5:0] not_688_s7_q;
  logic [2:0] sum_693_s7_q;
  logic [5:0] not_703_s7_q;
  logic [2:0] sum_708_s7_q;
  logic and_718_s7_q;
  logic [5:0] not_721_s7_q;
  logic [2:0] sum_726_s7_q;
  logic and_747_s7_q;
  logic [5:0] not_750_s7_q;
  logic [2:0] sum_755_s7_q;
  logic [5:0] not_765_s7_q;
  logic [2:0] sum_770_s7_q;
  logic [5:0] not_781_s7_q;
  logic [2:0] sum_786_s7_q;
  logic equal_808_s7_q;
  logic equal_872_s7_q;
  logic equal_895_s7_q;
  logic equal_898_s7_q;
  logic and_909_s7_q;
  logic select_949_s7_q;
  logic and_1044_s7_q;
  logic equal_1163_s7_q;
  logic equal_1214_s7_q;
  logic not_1260_s7_q;
  logic and_1348_s7_q;
  logic less_1431_s7_q;
  logic less_1434_s7_q;
  logic equal_1696_s7_q;
  logic less_1707_s7_q;
  logic equal_1864_s7_q;
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
      equal_301_s7_q <= equal_301_s6_q;
      select_303_s7_q <= select_303_s6_q;
      select_307_s7_q <= select_307_s6_q;
      and_316_s7_q <= and_316_s6_q;
      equal_321_s7_q <= equal_321_s6_q;
      whole_s7_q <= whole_s6_q;
      and_338_s7_q <= and_338_s6_q;
      and_339_s7_q <= and_339_s6_q;
      equal_342_s7_q <= equal_342_s6_q;
      equal_354_s7_q <= equal_354_s6_q;
      not_355_s7_q <= not_355_s6_q;
      equal_356_s7_q <= equal_356_s6_q;
      less_357_s7_q <= less_357_s6_q;
      not_358_s7_q <= not_358_s6_q;
      equal_388_s7_q <= equal_388_s6_q;
      drew_s7_q <= drew_s6_q;
      and_444_s7_q <= and_444_s6_q;
      left_rdata_s7_q <= left_rdata_s6_q;
      x_s7_2_q <= x_s6_2_q;
      and_498_s7_q <= and_498_s6_q;
      equal_504_s7_q <= equal_504_s6_q;
      and_510_s7_q <= and_510_s6_q;
      and_511_s7_q <= and_511_s6_q;
      not_516_s7_q <= not_516_s6_q[7:2];
      sum_521_s7_q <= sum_521;
      and_529_s7_q <= and_529_s6_q;
      and_530_s7_q <= and_530_s6_q;
      not_535_s7_q <= not_535_s6_q[7:2];
      sum_540_s7_q <= sum_540;
      and_549_s7_q <= and_549_s6_q;
      and_550_s7_q <= and_550_s6_q;
      not_555_s7_q <= not_555_s6_q[7:2];
      sum_560_s7_q <= sum_560;
      equal_571_s7_q <= equal_571_s6_q;
      not_576_s7_q <= not_576_s6_q[7:2];
      sum_581_s7_q <= sum_581;
      not_591_s7_q <= not_591_s6_q[7:2];
      sum_596_s7_q <= sum_596;
      and_605_s7_q <= and_605_s6_q;
      not_609_s7_q <= not_609_s6_q[7:2];
      sum_614_s7_q <= sum_614;
      and_629_s7_q <= and_629_s6_q;
      not_633_s7_q <= not_633_s6_q[7:2];
      sum_638_s7_q <= sum_638;
      not_648_s7_q <= not_648_s6_q[7:2];
      sum_653_s7_q <= sum_653;
      not_664_s7_q <= not_664_s6_q[7:2];
      sum_669_s7_q <= sum_669;
      not_688_s7_q <= not_688_s6_q[7:2];
      sum_693_s7_q <= sum_693;
      not_703_s7_q <= not_703_s6_q[7:2];
      sum_708_s7_q <= sum_708;
      and_718_s7_q <= and_718_s6_q;
      not_721_s7_q <= not_721_s6_q[7:2];
      sum_726_s7_q <= sum_726;
      and_747_s7_q <= and_747_s6_q;
      not_750_s7_q <= not_750_s6_q[7:2];
      sum_755_s7_q <= sum_755;
      not_765_s7_q <= not_765_s6_q[7:2];
      sum_770_s7_q <= sum_770;
      not_781_s7_q <= not_781_s6_q[7:2];
      sum_786_s7_q <= sum_786;
      equal_808_s7_q <= equal_808_s6_q;
      equal_872_s7_q <= equal_872_s6_q;
      equal_895_s7_q <= equal_895_s6_q;
      equal_898_s7_q <= equal_898_s6_q;
      and_909_s7_q <= and_909_s6_q;
      select_949_s7_q <= select_949_s6_q;
      and_1044_s7_q <= and_1044_s6_q;
      equal_1163_s7_q <= equal_1163_s6_q;
      equal_1214_s7_q <= equal_1214_s6_q;
      not_1260_s7_q <= not_1260_s6_q;
      and_1348_s7_q <= and_1348_s6_q;
      less_1431_s7_q <= less_1431_s6_q;
      less_1434_s7_q <= less_1434_s6_q;
      equal_1696_s7_q <= equal_1696_s6_q;
      less_1707_s7_q <= less_1707_s6_q;
      equal_1864_s7_q <= equal_1864_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:377
  logic [2:0] sum_522;
  assign sum_522 = {2'h0, not_516_s7_q[0]} + sum_521_s7_q;
  logic [2:0] sum_541;
  assign sum_541 = {2'h0, not_535_s7_q[0]} + sum_540_s7_q;
  logic [2:0] sum_561;
  assign sum_561 = {2'h0, not_555_s7_q[0]} + sum_560_s7_q;
  logic [2:0] sum_582;
  assign sum_582 = {2'h0, not_576_s7_q[0]} + sum_581_s7_q;
  logic [2:0] sum_597;
  assign sum_597 = {2'h0, not_591_s7_q[0]} + sum_596_s7_q;
  logic [2:0] sum_615;
  assign sum_615 = {2'h0, not_609_s7_q[0]} + sum_614_s7_q;
  logic [2:0] sum_639;
  assign sum_639 = {2'h0, not_633_s7_q[0]} + sum_638_s7_q;
  logic [2:0] sum_654;
  assign sum_654 = {2'h0, not_648_s7_q[0]} + sum_653_s7_q;
  logic [2:0] sum_670;
  assign sum_670 = {2'h0, not_664_s7_q[0]} + sum_669_s7_q;
  logic [2:0] sum_694;
  assign sum_694 = {2'h0, not_688_s7_q[0]} + sum_693_s7_q;
  logic [2:0] sum_709;
  assign sum_709 = {2'h0, not_703_s7_q[0]} + sum_708_s7_q;
  logic [2:0] sum_727;
  assign sum_727 = {2'h0, not_721_s7_q[0]} + sum_726_s7_q;
  logic [2:0] sum_756;
  assign sum_756 = {2'h0, not_750_s7_q[0]} + sum_755_s7_q;
  logic [2:0] sum_771;
  assign sum_771 = {2'h0, not_765_s7_q[0]} + sum_770_s7_q;
  logic [2:0] sum_787;
  assign sum_787 = {2'h0, not_781_s7_q[0]} + sum_786_s7_q;

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
  logic equal_301_s8_q;
  logic [6:0] select_303_s8_q;
  logic [8:0] select_307_s8_q;
  logic and_316_s8_q;
  logic equal_321_s8_q;
  logic whole_s8_q;
  logic and_338_s8_q;
  logic and_339_s8_q;
  logic equal_342_s8_q;
  logic equal_354_s8_q;
  logic not_355_s8_q;
  logic equal_356_s8_q;
  logic less_357_s8_q;
  logic not_358_s8_q;
  logic equal_388_s8_q;
  logic drew_s8_q;
  logic and_444_s8_q;
  logic left_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic and_498_s8_q;
  logic equal_504_s8_q;
  logic and_510_s8_q;
  logic and_511_s8_q;
  logic [3:0] not_516_s8_q;
  logic [3:0] sum_523_s8_q;
  logic and_529_s8_q;
  logic and_530_s8_q;
  logic [3:0] not_535_s8_q;
  logic [3:0] sum_542_s8_q;
  logic and_549_s8_q;
  logic and_550_s8_q;
  logic [3:0] not_555_s8_q;
  logic [3:0] sum_562_s8_q;
  logic equal_571_s8_q;
  logic [3:0] not_576_s8_q;
  logic [3:0] sum_583_s8_q;
  logic [3:0] not_591_s8_q;
  logic [3:0] sum_598_s8_q;
  logic and_605_s8_q;
  logic [3:0] not_609_s8_q;
  logic [3:0] sum_616_s8_q;
  logic and_629_s8_q;
  logic [3:0] not_633_s8_q;
  logic [3:0] sum_640_s8_q;
  logic [3:0] not_648_s8_q;
  logic [3:0] sum_655_s8_q;
  logic [3:0] not_664_s8_q;
  logic [3:0] sum_671_s8_q;
  logic [3:0] not_688_s8_q;
  logic [3:0] sum_695_s8_q;
  logic [3:0] not_703_s8_q;
  logic [3:0] sum_710_s8_q;
  logic and_718_s8_q;
  logic [3:0] not_721_s8_q;
  logic [3:0] sum_728_s8_q;
  logic and_747_s8_q;
  logic [3:0] not_750_s8_q;
  logic [3:0] sum_757_s8_q;
  logic [3:0] not_765_s8_q;
  logic [3:0] sum_772_s8_q;
  logic [3:0] not_781_s8_q;
  logic [3:0] sum_788_s8_q;
  logic equal_808_s8_q;
  logic equal_872_s8_q;
  logic equal_895_s8_q;
  logic equal_898_s8_q;
  logic and_909_s8_q;
  logic select_949_s8_q;
  logic and_1044_s8_q;
  logic equal_1163_s8_q;
  logic equal_1214_s8_q;
  logic not_1260_s8_q;
  logic and_1348_s8_q;
  logic less_1431_s8_q;
  logic less_1434_s8_q;
  logic equal_1696_s8_q;
  logic less_1707_s8_q;
  logic equal_1864_s8_q;
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
      equal_301_s8_q <= equal_301_s7_q;
      select_303_s8_q <= select_303_s7_q;
      select_307_s8_q <= select_307_s7_q;
      and_316_s8_q <= and_316_s7_q;
      equal_321_s8_q <= equal_321_s7_q;
      whole_s8_q <= whole_s7_q;
      and_338_s8_q <= and_338_s7_q;
      and_339_s8_q <= and_339_s7_q;
      equal_342_s8_q <= equal_342_s7_q;
      equal_354_s8_q <= equal_354_s7_q;
      not_355_s8_q <= not_355_s7_q;
      equal_356_s8_q <= equal_356_s7_q;
      less_357_s8_q <= less_357_s7_q;
      not_358_s8_q <= not_358_s7_q;
      equal_388_s8_q <= equal_388_s7_q;
      drew_s8_q <= drew_s7_q;
      and_444_s8_q <= and_444_s7_q;
      left_rdata_s8_q <= left_rdata_s7_q;
      x_s8_2_q <= x_s7_2_q;
      and_498_s8_q <= and_498_s7_q;
      equal_504_s8_q <= equal_504_s7_q;
      and_510_s8_q <= and_510_s7_q;
      and_511_s8_q <= and_511_s7_q;
      not_516_s8_q <= not_516_s7_q[5:2];
      sum_523_s8_q <= {3'h0, not_516_s7_q[1]} + {1'b0, sum_522};
      and_529_s8_q <= and_529_s7_q;
      and_530_s8_q <= and_530_s7_q;
      not_535_s8_q <= not_535_s7_q[5:2];
      sum_542_s8_q <= {3'h0, not_535_s7_q[1]} + {1'b0, sum_541};
      and_549_s8_q <= and_549_s7_q;
      and_550_s8_q <= and_550_s7_q;
      not_555_s8_q <= not_555_s7_q[5:2];
      sum_562_s8_q <= {3'h0, not_555_s7_q[1]} + {1'b0, sum_561};
      equal_571_s8_q <= equal_571_s7_q;
      not_576_s8_q <= not_576_s7_q[5:2];
      sum_583_s8_q <= {3'h0, not_576_s7_q[1]} + {1'b0, sum_582};
      not_591_s8_q <= not_591_s7_q[5:2];
      sum_598_s8_q <= {3'h0, not_591_s7_q[1]} + {1'b0, sum_597};
      and_605_s8_q <= and_605_s7_q;
      not_609_s8_q <= not_609_s7_q[5:2];
      sum_616_s8_q <= {3'h0, not_609_s7_q[1]} + {1'b0, sum_615};
      and_629_s8_q <= and_629_s7_q;
      not_633_s8_q <= not_633_s7_q[5:2];
      sum_640_s8_q <= {3'h0, not_633_s7_q[1]} + {1'b0, sum_639};
      not_648_s8_q <= not_648_s7_q[5:2];
      sum_655_s8_q <= {3'h0, not_648_s7_q[1]} + {1'b0, sum_654};
      not_664_s8_q <= not_664_s7_q[5:2];
      sum_671_s8_q <= {3'h0, not_664_s7_q[1]} + {1'b0, sum_670};
      not_688_s8_q <= not_688_s7_q[5:2];
      sum_695_s8_q <= {3'h0, not_688_s7_q[1]} + {1'b0, sum_694};
      not_703_s8_q <= not_703_s7_q[5:2];
      sum_710_s8_q <= {3'h0, not_703_s7_q[1]} + {1'b0, sum_709};
      and_718_s8_q <= and_718_s7_q;
      not_721_s8_q <= not_721_s7_q[5:2];
      sum_728_s8_q <= {3'h0, not_721_s7_q[1]} + {1'b0, sum_727};
      and_747_s8_q <= and_747_s7_q;
      not_750_s8_q <= not_750_s7_q[5:2];
      sum_757_s8_q <= {3'h0, not_750_s7_q[1]} + {1'b0, sum_756};
      not_765_s8_q <= not_765_s7_q[5:2];
      sum_772_s8_q <= {3'h0, not_765_s7_q[1]} + {1'b0, sum_771};
      not_781_s8_q <= not_781_s7_q[5:2];
      sum_788_s8_q <= {3'h0, not_781_s7_q[1]} + {1'b0, sum_787};
      equal_808_s8_q <= equal_808_s7_q;
      equal_872_s8_q <= equal_872_s7_q;
      equal_895_s8_q <= equal_895_s7_q;
      equal_898_s8_q <= equal_898_s7_q;
      and_909_s8_q <= and_909_s7_q;
      select_949_s8_q <= select_949_s7_q;
      and_1044_s8_q <= and_1044_s7_q;
      equal_1163_s8_q <= equal_1163_s7_q;
      equal_1214_s8_q <= equal_1214_s7_q;
      not_1260_s8_q <= not_1260_s7_q;
      and_1348_s8_q <= and_1348_s7_q;
      less_1431_s8_q <= less_1431_s7_q;
      less_1434_s8_q <= less_1434_s7_q;
      equal_1696_s8_q <= equal_1696_s7_q;
      less_1707_s8_q <= less_1707_s7_q;
      equal_1864_s8_q <= equal_1864_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:377
  logic [3:0] sum_525;
  assign sum_525 = {3'h0, not_516_s8_q[1]} + ({3'h0, not_516_s8_q[0]} + sum_523_s8_q);
  logic [3:0] sum_544;
  assign sum_544 = {3'h0, not_535_s8_q[1]} + ({3'h0, not_535_s8_q[0]} + sum_542_s8_q);
  logic [3:0] sum_564;
  assign sum_564 = {3'h0, not_555_s8_q[1]} + ({3'h0, not_555_s8_q[0]} + sum_562_s8_q);
  logic [3:0] sum_585;
  assign sum_585 = {3'h0, not_576_s8_q[1]} + ({3'h0, not_576_s8_q[0]} + sum_583_s8_q);
  logic [3:0] sum_600;
  assign sum_600 = {3'h0, not_591_s8_q[1]} + ({3'h0, not_591_s8_q[0]} + sum_598_s8_q);
  logic [3:0] sum_618;
  assign sum_618 = {3'h0, not_609_s8_q[1]} + ({3'h0, not_609_s8_q[0]} + sum_616_s8_q);
  logic [3:0] sum_642;
  assign sum_642 = {3'h0, not_633_s8_q[1]} + ({3'h0, not_633_s8_q[0]} + sum_640_s8_q);
  logic [3:0] sum_657;
  assign sum_657 = {3'h0, not_648_s8_q[1]} + ({3'h0, not_648_s8_q[0]} + sum_655_s8_q);
  logic [3:0] sum_673;
  assign sum_673 = {3'h0, not_664_s8_q[1]} + ({3'h0, not_664_s8_q[0]} + sum_671_s8_q);
  logic [3:0] sum_697;
  assign sum_697 = {3'h0, not_688_s8_q[1]} + ({3'h0, not_688_s8_q[0]} + sum_695_s8_q);
  logic [3:0] sum_712;
  assign sum_712 = {3'h0, not_703_s8_q[1]} + ({3'h0, not_703_s8_q[0]} + sum_710_s8_q);
  logic [3:0] sum_730;
  assign sum_730 = {3'h0, not_721_s8_q[1]} + ({3'h0, not_721_s8_q[0]} + sum_728_s8_q);
  logic [3:0] sum_759;
  assign sum_759 = {3'h0, not_750_s8_q[1]} + ({3'h0, not_750_s8_q[0]} + sum_757_s8_q);
  logic [3:0] sum_774;
  assign sum_774 = {3'h0, not_765_s8_q[1]} + ({3'h0, not_765_s8_q[0]} + sum_772_s8_q);
  logic [3:0] sum_790;
  assign sum_790 = {3'h0, not_781_s8_q[1]} + ({3'h0, not_781_s8_q[0]} + sum_788_s8_q);

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
  logic equal_301_s9_q;
  logic [6:0] select_303_s9_q;
  logic [8:0] select_307_s9_q;
  logic and_316_s9_q;
  logic equal_321_s9_q;
  logic whole_s9_q;
  logic and_338_s9_q;
  logic and_339_s9_q;
  logic equal_342_s9_q;
  logic equal_354_s9_q;
  logic not_355_s9_q;
  logic equal_356_s9_q;
  logic less_357_s9_q;
  logic not_358_s9_q;
  logic equal_388_s9_q;
  logic drew_s9_q;
  logic and_444_s9_q;
  logic left_rdata_s9_q;
  logic [6:0] x_s9_2_q;
  logic and_498_s9_q;
  logic equal_504_s9_q;
  logic and_510_s9_q;
  logic and_511_s9_q;
  logic [1:0] not_516_s9_q;
  logic [3:0] sum_525_s9_q;
  logic and_529_s9_q;
  logic and_530_s9_q;
  logic [1:0] not_535_s9_q;
  logic [3:0] sum_544_s9_q;
  logic and_549_s9_q;
  logic and_550_s9_q;
  logic [1:0] not_555_s9_q;
  logic [3:0] sum_564_s9_q;
  logic equal_571_s9_q;
  logic [1:0] not_576_s9_q;
  logic [3:0] sum_585_s9_q;
  logic [1:0] not_591_s9_q;
  logic [3:0] sum_600_s9_q;
  logic and_605_s9_q;
  logic [1:0] not_609_s9_q;
  logic [3:0] sum_618_s9_q;
  logic and_629_s9_q;
  logic [1:0] not_633_s9_q;
  logic [3:0] sum_642_s9_q;
  logic [1:0] not_648_s9_q;
  logic [3:0] sum_657_s9_q;
  logic [1:0] not_664_s9_q;
  logic [3:0] sum_673_s9_q;
  logic [1:0] not_688_s9_q;
  logic [3:0] sum_697_s9_q;
  logic [1:0] not_703_s9_q;
  logic [3:0] sum_712_s9_q;
  logic and_718_s9_q;
  logic [1:0] not_721_s9_q;
  logic [3:0] sum_730_s9_q;
  logic and_747_s9_q;
  logic [1:0] not_750_s9_q;
  logic [3:0] sum_759_s9_q;
  logic [1:0] not_765_s9_q;
  logic [3:0] sum_774_s9_q;
  logic [1:0] not_781_s9_q;
  logic [3:0] sum_790_s9_q;
  logic equal_808_s9_q;
  logic equal_872_s9_q;
  logic equal_895_s9_q;
  logic equal_898_s9_q;
  logic and_909_s9_q;
  logic select_949_s9_q;
  logic and_1044_s9_q;
  logic equal_1163_s9_q;
  logic equal_1214_s9_q;
  logic not_1260_s9_q;
  logic and_1348_s9_q;
  logic less_1431_s9_q;
  logic less_1434_s9_q;
  logic equal_1696_s9_q;
  logic less_1707_s9_q;
  logic equal_1864_s9_q;
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
      equal_301_s9_q <= equal_301_s8_q;
      select_303_s9_q <= select_303_s8_q;
      select_307_s9_q <= select_307_s8_q;
      and_316_s9_q <= and_316_s8_q;
      equal_321_s9_q <= equal_321_s8_q;
      whole_s9_q <= whole_s8_q;
      and_338_s9_q <= and_338_s8_q;
      and_339_s9_q <= and_339_s8_q;
      equal_342_s9_q <= equal_342_s8_q;
      equal_354_s9_q <= equal_354_s8_q;
      not_355_s9_q <= not_355_s8_q;
      equal_356_s9_q <= equal_356_s8_q;
      less_357_s9_q <= less_357_s8_q;
      not_358_s9_q <= not_358_s8_q;
      equal_388_s9_q <= equal_388_s8_q;
      drew_s9_q <= drew_s8_q;
      and_444_s9_q <= and_444_s8_q;
      left_rdata_s9_q <= left_rdata_s8_q;
      x_s9_2_q <= x_s8_2_q;
      and_498_s9_q <= and_498_s8_q;
      equal_504_s9_q <= equal_504_s8_q;
      and_510_s9_q <= and_510_s8_q;
      and_511_s9_q <= and_511_s8_q;
      not_516_s9_q <= not_516_s8_q[3:2];
      sum_525_s9_q <= sum_525;
      and_529_s9_q <= and_529_s8_q;
      and_530_s9_q <= and_530_s8_q;
      not_535_s9_q <= not_535_s8_q[3:2];
      sum_544_s9_q <= sum_544;
      and_549_s9_q <= and_549_s8_q;
      and_550_s9_q <= and_550_s8_q;
      not_555_s9_q <= not_555_s8_q[3:2];
      sum_564_s9_q <= sum_564;
      equal_571_s9_q <= equal_571_s8_q;
      not_576_s9_q <= not_576_s8_q[3:2];
      sum_585_s9_q <= sum_585;
      not_591_s9_q <= not_591_s8_q[3:2];
      sum_600_s9_q <= sum_600;
      and_605_s9_q <= and_605_s8_q;
      not_609_s9_q <= not_609_s8_q[3:2];
      sum_618_s9_q <= sum_618;
      and_629_s9_q <= and_629_s8_q;
      not_633_s9_q <= not_633_s8_q[3:2];
      sum_642_s9_q <= sum_642;
      not_648_s9_q <= not_648_s8_q[3:2];
      sum_657_s9_q <= sum_657;
      not_664_s9_q <= not_664_s8_q[3:2];
      sum_673_s9_q <= sum_673;
      not_688_s9_q <= not_688_s8_q[3:2];
      sum_697_s9_q <= sum_697;
      not_703_s9_q <= not_703_s8_q[3:2];
      sum_712_s9_q <= sum_712;
      and_718_s9_q <= and_718_s8_q;
      not_721_s9_q <= not_721_s8_q[3:2];
      sum_730_s9_q <= sum_730;
      and_747_s9_q <= and_747_s8_q;
      not_750_s9_q <= not_750_s8_q[3:2];
      sum_759_s9_q <= sum_759;
      not_765_s9_q <= not_765_s8_q[3:2];
      sum_774_s9_q <= sum_774;
      not_781_s9_q <= not_781_s8_q[3:2];
      sum_790_s9_q <= sum_790;
      equal_808_s9_q <= equal_808_s8_q;
      equal_872_s9_q <= equal_872_s8_q;
      equal_895_s9_q <= equal_895_s8_q;
      equal_898_s9_q <= equal_898_s8_q;
      and_909_s9_q <= and_909_s8_q;
      select_949_s9_q <= select_949_s8_q;
      and_1044_s9_q <= and_1044_s8_q;
      equal_1163_s9_q <= equal_1163_s8_q;
      equal_1214_s9_q <= equal_1214_s8_q;
      not_1260_s9_q <= not_1260_s8_q;
      and_1348_s9_q <= and_1348_s8_q;
      less_1431_s9_q <= less_1431_s8_q;
      less_1434_s9_q <= less_1434_s8_q;
      equal_1696_s9_q <= equal_1696_s8_q;
      less_1707_s9_q <= less_1707_s8_q;
      equal_1864_s9_q <= equal_1864_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [23:0] registration_next_slope_row_q;
  logic [27:0] registration_next_slope_change_q;
  // hls/stages/agreement.hpp:319
  logic not_499;
  assign not_499 = ~equal_356_s9_q;
  // hls/stages/agreement.hpp:299
  logic and_500;
  assign and_500 = not_499 & and_444_s9_q;
  logic select_501;
  assign select_501 = equal_354_s9_q ? and_498_s9_q : and_500;
  // hls/stages/agreement.hpp:377
  logic [3:0] sum_527;
  assign sum_527 = {3'h0, not_516_s9_q[1]} + ({3'h0, not_516_s9_q[0]} + sum_525_s9_q);
  logic [3:0] column;
  assign column = (and_510_s9_q & and_511_s9_q) ? sum_527 : 4'h0;
  logic [3:0] sum_546;
  assign sum_546 = {3'h0, not_535_s9_q[1]} + ({3'h0, not_535_s9_q[0]} + sum_544_s9_q);
  logic [3:0] sum_566;
  assign sum_566 = {3'h0, not_555_s9_q[1]} + ({3'h0, not_555_s9_q[0]} + sum_564_s9_q);
  logic [3:0] sum_587;
  assign sum_587 = {3'h0, not_576_s9_q[1]} + ({3'h0, not_576_s9_q[0]} + sum_585_s9_q);
  logic [3:0] column_4;
  assign column_4 = (and_510_s9_q & and_530_s9_q) ? sum_587 : 4'h0;
  logic [3:0] sum_602;
  assign sum_602 = {3'h0, not_591_s9_q[1]} + ({3'h0, not_591_s9_q[0]} + sum_600_s9_q);
  logic [3:0] sum_620;
  assign sum_620 = {3'h0, not_609_s9_q[1]} + ({3'h0, not_609_s9_q[0]} + sum_618_s9_q);
  logic [3:0] sum_644;
  assign sum_644 = {3'h0, not_633_s9_q[1]} + ({3'h0, not_633_s9_q[0]} + sum_642_s9_q);
  logic [3:0] column_7;
  assign column_7 = (and_510_s9_q & and_629_s9_q) ? sum_644 : 4'h0;
  logic [3:0] sum_659;
  assign sum_659 = {3'h0, not_648_s9_q[1]} + ({3'h0, not_648_s9_q[0]} + sum_657_s9_q);
  logic [3:0] sum_675;
  assign sum_675 = {3'h0, not_664_s9_q[1]} + ({3'h0, not_664_s9_q[0]} + sum_673_s9_q);
  logic [3:0] sum_699;
  assign sum_699 = {3'h0, not_688_s9_q[1]} + ({3'h0, not_688_s9_q[0]} + sum_697_s9_q);
  logic [3:0] column_10;
  assign column_10 = (and_510_s9_q & and_550_s9_q) ? sum_699 : 4'h0;
  logic [3:0] sum_714;
  assign sum_714 = {3'h0, not_703_s9_q[1]} + ({3'h0, not_703_s9_q[0]} + sum_712_s9_q);
  logic [3:0] sum_732;
  assign sum_732 = {3'h0, not_721_s9_q[1]} + ({3'h0, not_721_s9_q[0]} + sum_730_s9_q);
  logic [3:0] sum_761;
  assign sum_761 = {3'h0, not_750_s9_q[1]} + ({3'h0, not_750_s9_q[0]} + sum_759_s9_q);
  logic [3:0] column_13;
  assign column_13 = and_747_s9_q ? sum_761 : 4'h0;
  logic [3:0] sum_776;
  assign sum_776 = {3'h0, not_765_s9_q[1]} + ({3'h0, not_765_s9_q[0]} + sum_774_s9_q);
  logic [3:0] sum_792;
  assign sum_792 = {3'h0, not_781_s9_q[1]} + ({3'h0, not_781_s9_q[0]} + sum_790_s9_q);
  // hls/stages/registration.hpp:158
  logic [16:0] select_1439;
  assign select_1439 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/registration.hpp:57
  logic [23:0] select_1697;
  assign select_1697 = equal_1696_s9_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1699;
  assign select_1699 = and_339_s9_q ? (equal_1214_s9_q ? select_1697 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1700;
  assign select_1700 = equal_1696_s9_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:176
  logic [27:0] select_1702;
  assign select_1702 = and_339_s9_q ? (equal_1214_s9_q ? select_1700 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1704;
  assign select_1704 = drew_s9_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1705;
  assign sum_1705 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1706;
  assign sum_1706 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

  // Memory best_left, 120 x 22, DISTANCE 32, hls/stages/agreement.hpp:768; read in stage 9, written in stage 26: 9 < 26 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 22'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = equal_354_s9_q ? x_s9_2_q : x_s9_q[6:0];
  logic best_left_re;
  assign best_left_re = s9_en & select_501;
  logic [21:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      registration_next_slope_row_q <= 24'h0;
      registration_next_slope_change_q <= 28'h0;
    end else if (s9_en) begin
      registration_slope_row_q <= select_1699;
      registration_slope_change_q <= select_1702;
      registration_slope_q <= select_1704;
      registration_next_slope_row_q <= sum_1705;
      registration_next_slope_change_q <= sum_1706;
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
  logic [11:0] registration_slope_s10_q;
  logic equal_301_s10_q;
  logic [6:0] select_303_s10_q;
  logic [8:0] select_307_s10_q;
  logic and_316_s10_q;
  logic equal_321_s10_q;
  logic whole_s10_q;
  logic and_338_s10_q;
  logic and_339_s10_q;
  logic equal_342_s10_q;
  logic equal_354_s10_q;
  logic not_355_s10_q;
  logic equal_356_s10_q;
  logic less_357_s10_q;
  logic not_358_s10_q;
  logic equal_388_s10_q;
  logic drew_s10_q;
  logic left_rdata_s10_q;
  logic [6:0] x_s10_2_q;
  logic not_499_s10_q;
  logic select_501_s10_q;
  logic equal_504_s10_q;
  logic [3:0] column_s10_q;
  logic [3:0] select_547_s10_q;
  logic [3:0] select_567_s10_q;
  logic equal_571_s10_q;
  logic [3:0] column_4_s10_q;
  logic [3:0] select_603_s10_q;
  logic [3:0] select_621_s10_q;
  logic [3:0] column_7_s10_q;
  logic [3:0] select_660_s10_q;
  logic [3:0] select_676_s10_q;
  logic [3:0] column_10_s10_q;
  logic [3:0] select_715_s10_q;
  logic [3:0] select_733_s10_q;
  logic [3:0] column_13_s10_q;
  logic [3:0] select_777_s10_q;
  logic [3:0] select_793_s10_q;
  logic equal_808_s10_q;
  logic and_866_s10_q;
  logic equal_872_s10_q;
  logic equal_895_s10_q;
  logic equal_898_s10_q;
  logic and_909_s10_q;
  logic and_940_s10_q;
  logic select_949_s10_q;
  logic and_1046_s10_q;
  logic equal_1163_s10_q;
  logic equal_1214_s10_q;
  logic not_1260_s10_q;
  logic and_1348_s10_q;
  logic less_1431_s10_q;
  logic less_1434_s10_q;
  logic [16:0] select_1439_s10_q;
  logic less_1707_s10_q;
  logic equal_1864_s10_q;
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
      registration_slope_s10_q <= registration_slope_q[27:16];
      equal_301_s10_q <= equal_301_s9_q;
      select_303_s10_q <= select_303_s9_q;
      select_307_s10_q <= select_307_s9_q;
      and_316_s10_q <= and_316_s9_q;
      equal_321_s10_q <= equal_321_s9_q;
      whole_s10_q <= whole_s9_q;
      and_338_s10_q <= and_338_s9_q;
      and_339_s10_q <= and_339_s9_q;
      equal_342_s10_q <= equal_342_s9_q;
      equal_354_s10_q <= equal_354_s9_q;
      not_355_s10_q <= not_355_s9_q;
      equal_356_s10_q <= equal_356_s9_q;
      less_357_s10_q <= less_357_s9_q;
      not_358_s10_q <= not_358_s9_q;
      equal_388_s10_q <= equal_388_s9_q;
      drew_s10_q <= drew_s9_q;
      left_rdata_s10_q <= left_rdata_s9_q;
      x_s10_2_q <= x_s9_2_q;
      not_499_s10_q <= not_499;
      select_501_s10_q <= select_501;
      equal_504_s10_q <= equal_504_s9_q;
      column_s10_q <= column;
      select_547_s10_q <= (and_529_s9_q & and_530_s9_q) ? sum_546 : 4'h0;
      select_567_s10_q <= (and_549_s9_q & and_550_s9_q) ? sum_566 : 4'h0;
      equal_571_s10_q <= equal_571_s9_q;
      column_4_s10_q <= column_4;
      select_603_s10_q <= (and_529_s9_q & and_550_s9_q) ? sum_602 : 4'h0;
      select_621_s10_q <= (and_549_s9_q & and_605_s9_q) ? sum_620 : 4'h0;
      column_7_s10_q <= column_7;
      select_660_s10_q <= (and_529_s9_q & and_511_s9_q) ? sum_659 : 4'h0;
      select_676_s10_q <= (and_549_s9_q & and_530_s9_q) ? sum_675 : 4'h0;
      column_10_s10_q <= column_10;
      select_715_s10_q <= (and_529_s9_q & and_605_s9_q) ? sum_714 : 4'h0;
      select_733_s10_q <= and_718_s9_q ? sum_732 : 4'h0;
      column_13_s10_q <= column_13;
      select_777_s10_q <= (and_529_s9_q & and_629_s9_q) ? sum_776 : 4'h0;
      select_793_s10_q <= (and_549_s9_q & and_511_s9_q) ? sum_792 : 4'h0;
      equal_808_s10_q <= equal_808_s9_q;
      and_866_s10_q <= equal_354_s9_q & and_498_s9_q;
      equal_872_s10_q <= equal_872_s9_q;
      equal_895_s10_q <= equal_895_s9_q;
      equal_898_s10_q <= equal_898_s9_q;
      and_909_s10_q <= and_909_s9_q;
      and_940_s10_q <= not_355_s9_q & and_500;
      select_949_s10_q <= select_949_s9_q;
      and_1046_s10_q <= not_355_s9_q & (not_499 & and_1044_s9_q);
      equal_1163_s10_q <= equal_1163_s9_q;
      equal_1214_s10_q <= equal_1214_s9_q;
      not_1260_s10_q <= not_1260_s9_q;
      and_1348_s10_q <= and_1348_s9_q;
      less_1431_s10_q <= less_1431_s9_q;
      less_1434_s10_q <= less_1434_s9_q;
      select_1439_s10_q <= select_1439;
      less_1707_s10_q <= less_1707_s9_q;
      equal_1864_s10_q <= equal_1864_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:405
  logic [4:0] column_2;
  assign column_2 = {1'b0, column_s10_q} + {1'b0, select_547_s10_q};
  logic [5:0] column_3;
  assign column_3 = {1'b0, column_2} + {2'h0, select_567_s10_q};
  logic [4:0] column_5;
  assign column_5 = {1'b0, column_4_s10_q} + {1'b0, select_603_s10_q};
  logic [5:0] column_6;
  assign column_6 = {1'b0, column_5} + {2'h0, select_621_s10_q};
  logic [4:0] column_8;
  assign column_8 = {1'b0, column_7_s10_q} + {1'b0, select_660_s10_q};
  logic [5:0] column_9;
  assign column_9 = {1'b0, column_8} + {2'h0, select_676_s10_q};
  logic [4:0] column_11;
  assign column_11 = {1'b0, column_10_s10_q} + {1'b0, select_715_s10_q};
  logic [5:0] column_12;
  assign column_12 = {1'b0, column_11} + {2'h0, select_733_s10_q};
  logic [4:0] column_14;
  assign column_14 = {1'b0, column_13_s10_q} + {1'b0, select_777_s10_q};
  logic [5:0] column_15;
  assign column_15 = {1'b0, column_14} + {2'h0, select_793_s10_q};
  // hls/stages/registration.hpp:158
  logic [13:0] select_1441;
  assign select_1441 = ($signed(10'h0) < $signed(select_1439_s10_q[16:7])) ? 14'h7f : select_1439_s10_q[13:0];

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
  logic [11:0] registration_slope_s11_q;
  logic equal_301_s11_q;
  logic [6:0] select_303_s11_q;
  logic [8:0] select_307_s11_q;
  logic and_316_s11_q;
  logic equal_321_s11_q;
  logic whole_s11_q;
  logic and_338_s11_q;
  logic and_339_s11_q;
  logic equal_342_s11_q;
  logic equal_354_s11_q;
  logic not_355_s11_q;
  logic equal_356_s11_q;
  logic less_357_s11_q;
  logic not_358_s11_q;
  logic equal_388_s11_q;
  logic drew_s11_q;
  logic left_rdata_s11_q;
  logic [6:0] x_s11_2_q;
  logic not_499_s11_q;
  logic select_501_s11_q;
  logic [21:0] best_left_rdata_s11_q;
  logic equal_504_s11_q;
  logic [5:0] column_3_s11_q;
  logic equal_571_s11_q;
  logic [5:0] column_6_s11_q;
  logic [5:0] column_9_s11_q;
  logic [5:0] column_12_s11_q;
  logic [5:0] column_15_s11_q;
  logic equal_808_s11_q;
  logic and_866_s11_q;
  logic equal_872_s11_q;
  logic equal_895_s11_q;
  logic equal_898_s11_q;
  logic and_909_s11_q;
  logic and_940_s11_q;
  logic select_949_s11_q;
  logic and_1046_s11_q;
  logic equal_1163_s11_q;
  logic equal_1214_s11_q;
  logic not_1260_s11_q;
  logic and_1348_s11_q;
  logic less_1431_s11_q;
  logic less_1434_s11_q;
  logic [13:0] select_1441_s11_q;
  logic less_1707_s11_q;
  logic equal_1864_s11_q;
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
      registration_slope_s11_q <= registration_slope_s10_q;
      equal_301_s11_q <= equal_301_s10_q;
      select_303_s11_q <= select_303_s10_q;
      select_307_s11_q <= select_307_s10_q;
      and_316_s11_q <= and_316_s10_q;
      equal_321_s11_q <= equal_321_s10_q;
      whole_s11_q <= whole_s10_q;
      and_338_s11_q <= and_338_s10_q;
      and_339_s11_q <= and_339_s10_q;
      equal_342_s11_q <= equal_342_s10_q;
      equal_354_s11_q <= equal_354_s10_q;
      not_355_s11_q <= not_355_s10_q;
      equal_356_s11_q <= equal_356_s10_q;
      less_357_s11_q <= less_357_s10_q;
      not_358_s11_q <= not_358_s10_q;
      equal_388_s11_q <= equal_388_s10_q;
      drew_s11_q <= drew_s10_q;
      left_rdata_s11_q <= left_rdata_s10_q;
      x_s11_2_q <= x_s10_2_q;
      not_499_s11_q <= not_499_s10_q;
      select_501_s11_q <= select_501_s10_q;
      best_left_rdata_s11_q <= best_left_rdata_q;
      equal_504_s11_q <= equal_504_s10_q;
      column_3_s11_q <= column_3;
      equal_571_s11_q <= equal_571_s10_q;
      column_6_s11_q <= column_6;
      column_9_s11_q <= column_9;
      column_12_s11_q <= column_12;
      column_15_s11_q <= column_15;
      equal_808_s11_q <= equal_808_s10_q;
      and_866_s11_q <= and_866_s10_q;
      equal_872_s11_q <= equal_872_s10_q;
      equal_895_s11_q <= equal_895_s10_q;
      equal_898_s11_q <= equal_898_s10_q;
      and_909_s11_q <= and_909_s10_q;
      and_940_s11_q <= and_940_s10_q;
      select_949_s11_q <= select_949_s10_q;
      and_1046_s11_q <= and_1046_s10_q;
      equal_1163_s11_q <= equal_1163_s10_q;
      equal_1214_s11_q <= equal_1214_s10_q;
      not_1260_s11_q <= not_1260_s10_q;
      and_1348_s11_q <= and_1348_s10_q;
      less_1431_s11_q <= less_1431_s10_q;
      less_1434_s11_q <= less_1434_s10_q;
      select_1441_s11_q <= select_1441;
      less_1707_s11_q <= less_1707_s10_q;
      equal_1864_s11_q <= equal_1864_s10_q;
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
  logic [7:0] sums_3_columns_values_0_q;
  logic [7:0] sums_3_columns_values_1_q;
  logic [7:0] sums_3_columns_values_2_q;
  logic [7:0] sums_3_columns_values_3_q;
  logic [7:0] sums_3_columns_values_4_q;
  logic [7:0] sums_3_columns_values_5_q;
  logic [7:0] sums_3_columns_values_6_q;
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_570;
  assign difference_570 = {2'h0, column_3_s11_q} - (age_s11_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] difference_624;
  assign difference_624 = {2'h0, column_6_s11_q} - (age_s11_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] difference_679;
  assign difference_679 = {2'h0, column_9_s11_q} - (age_s11_q[1] ? sums_3_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1314;
  assign select_1314 = equal_354_s11_q ? {2'h0, column_6_s11_q} : sums_1_columns_values_0_q;
  logic [7:0] select_1315;
  assign select_1315 = equal_354_s11_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1316;
  assign select_1316 = equal_354_s11_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1317;
  assign select_1317 = equal_354_s11_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1318;
  assign select_1318 = equal_354_s11_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1319;
  assign select_1319 = equal_354_s11_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1320;
  assign select_1320 = equal_354_s11_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1322;
  assign select_1322 = equal_354_s11_q ? {2'h0, column_3_s11_q} : sums_2_columns_values_0_q;
  logic [7:0] select_1323;
  assign select_1323 = equal_354_s11_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1324;
  assign select_1324 = equal_354_s11_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1325;
  assign select_1325 = equal_354_s11_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1326;
  assign select_1326 = equal_354_s11_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1327;
  assign select_1327 = equal_354_s11_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1328;
  assign select_1328 = equal_354_s11_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1330;
  assign select_1330 = equal_354_s11_q ? {2'h0, column_9_s11_q} : sums_3_columns_values_0_q;
  logic [7:0] select_1331;
  assign select_1331 = equal_354_s11_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1332;
  assign select_1332 = equal_354_s11_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1333;
  assign select_1333 = equal_354_s11_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1334;
  assign select_1334 = equal_354_s11_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1335;
  assign select_1335 = equal_354_s11_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1336;
  assign select_1336 = equal_354_s11_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  // hls/stages/registration.hpp:153
  logic [9:0] select_1442;
  assign select_1442 = best_left_rdata_s11_q[12] ? select_1441_s11_q[9:0] : 10'h0;
  logic [8:0] difference_1444;
  assign difference_1444 = select_1442[9:1] - (best_left_rdata_s11_q[13] ? select_1441_s11_q[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1447;
  assign sum_1447 = (best_left_rdata_s11_q[8] ? select_1441_s11_q[13:1] : 13'h0) + (best_left_rdata_s11_q[9] ? select_1441_s11_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1448;
  assign select_1448 = best_left_rdata_s11_q[10] ? select_1441_s11_q[11:0] : 12'h0;
  logic [10:0] sum_1450;
  assign sum_1450 = select_1448[11:1] + (best_left_rdata_s11_q[11] ? select_1441_s11_q[10:0] : 11'h0);

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
    sums_3_columns_values_0_q = 8'h0;
    sums_3_columns_values_1_q = 8'h0;
    sums_3_columns_values_2_q = 8'h0;
    sums_3_columns_values_3_q = 8'h0;
    sums_3_columns_values_4_q = 8'h0;
    sums_3_columns_values_5_q = 8'h0;
    sums_3_columns_values_6_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s11_en) begin
      sums_1_columns_values_0_q <= select_1314;
      sums_1_columns_values_1_q <= select_1315;
      sums_1_columns_values_2_q <= select_1316;
      sums_1_columns_values_3_q <= select_1317;
      sums_1_columns_values_4_q <= select_1318;
      sums_1_columns_values_5_q <= select_1319;
      sums_1_columns_values_6_q <= select_1320;
      sums_2_columns_values_0_q <= select_1322;
      sums_2_columns_values_1_q <= select_1323;
      sums_2_columns_values_2_q <= select_1324;
      sums_2_columns_values_3_q <= select_1325;
      sums_2_columns_values_4_q <= select_1326;
      sums_2_columns_values_5_q <= select_1327;
      sums_2_columns_values_6_q <= select_1328;
      sums_3_columns_values_0_q <= select_1330;
      sums_3_columns_values_1_q <= select_1331;
      sums_3_columns_values_2_q <= select_1332;
      sums_3_columns_values_3_q <= select_1333;
      sums_3_columns_values_4_q <= select_1334;
      sums_3_columns_values_5_q <= select_1335;
      sums_3_columns_values_6_q <= select_1336;
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
  logic [11:0] registration_slope_s12_q;
  logic equal_301_s12_q;
  logic [6:0] select_303_s12_q;
  logic [8:0] select_307_s12_q;
  logic and_316_s12_q;
  logic equal_321_s12_q;
  logic whole_s12_q;
  logic and_338_s12_q;
  logic and_339_s12_q;
  logic equal_342_s12_q;
  logic equal_354_s12_q;
  logic not_355_s12_q;
  logic equal_356_s12_q;
  logic less_357_s12_q;
  logic not_358_s12_q;
  logic equal_388_s12_q;
  logic drew_s12_q;
  logic left_rdata_s12_q;
  logic [6:0] x_s12_2_q;
  logic not_499_s12_q;
  logic select_501_s12_q;
  logic [21:0] best_left_rdata_s12_q;
  logic equal_504_s12_q;
  logic [7:0] difference_570_s12_q;
  logic equal_571_s12_q;
  logic [7:0] difference_624_s12_q;
  logic [7:0] difference_679_s12_q;
  logic [5:0] column_12_s12_q;
  logic [5:0] column_15_s12_q;
  logic equal_808_s12_q;
  logic and_866_s12_q;
  logic equal_872_s12_q;
  logic equal_895_s12_q;
  logic equal_898_s12_q;
  logic and_909_s12_q;
  logic and_940_s12_q;
  logic select_949_s12_q;
  logic and_1046_s12_q;
  logic equal_1163_s12_q;
  logic equal_1214_s12_q;
  logic not_1260_s12_q;
  logic and_1348_s12_q;
  logic less_1431_s12_q;
  logic less_1434_s12_q;
  logic select_1442_s12_q;
  logic [8:0] difference_1444_s12_q;
  logic [11:0] sum_1447_s12_q;
  logic select_1448_s12_q;
  logic [10:0] sum_1450_s12_q;
  logic less_1707_s12_q;
  logic equal_1864_s12_q;
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
      registration_slope_s12_q <= registration_slope_s11_q;
      equal_301_s12_q <= equal_301_s11_q;
      select_303_s12_q <= select_303_s11_q;
      select_307_s12_q <= select_307_s11_q;
      and_316_s12_q <= and_316_s11_q;
      equal_321_s12_q <= equal_321_s11_q;
      whole_s12_q <= whole_s11_q;
      and_338_s12_q <= and_338_s11_q;
      and_339_s12_q <= and_339_s11_q;
      equal_342_s12_q <= equal_342_s11_q;
      equal_354_s12_q <= equal_354_s11_q;
      not_355_s12_q <= not_355_s11_q;
      equal_356_s12_q <= equal_356_s11_q;
      less_357_s12_q <= less_357_s11_q;
      not_358_s12_q <= not_358_s11_q;
      equal_388_s12_q <= equal_388_s11_q;
      drew_s12_q <= drew_s11_q;
      left_rdata_s12_q <= left_rdata_s11_q;
      x_s12_2_q <= x_s11_2_q;
      not_499_s12_q <= not_499_s11_q;
      select_501_s12_q <= select_501_s11_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      equal_504_s12_q <= equal_504_s11_q;
      difference_570_s12_q <= difference_570;
      equal_571_s12_q <= equal_571_s11_q;
      difference_624_s12_q <= difference_624;
      difference_679_s12_q <= difference_679;
      column_12_s12_q <= column_12_s11_q;
      column_15_s12_q <= column_15_s11_q;
      equal_808_s12_q <= equal_808_s11_q;
      and_866_s12_q <= and_866_s11_q;
      equal_872_s12_q <= equal_872_s11_q;
      equal_895_s12_q <= equal_895_s11_q;
      equal_898_s12_q <= equal_898_s11_q;
      and_909_s12_q <= and_909_s11_q;
      and_940_s12_q <= and_940_s11_q;
      select_949_s12_q <= select_949_s11_q;
      and_1046_s12_q <= and_1046_s11_q;
      equal_1163_s12_q <= equal_1163_s11_q;
      equal_1214_s12_q <= equal_1214_s11_q;
      not_1260_s12_q <= not_1260_s11_q;
      and_1348_s12_q <= and_1348_s11_q;
      less_1431_s12_q <= less_1431_s11_q;
      less_1434_s12_q <= less_1434_s11_q;
      select_1442_s12_q <= select_1442[0];
      difference_1444_s12_q <= difference_1444;
      sum_1447_s12_q <= sum_1447[12:1];
      select_1448_s12_q <= select_1448[0];
      sum_1450_s12_q <= sum_1450;
      less_1707_s12_q <= less_1707_s11_q;
      equal_1864_s12_q <= equal_1864_s11_q;
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
  logic [7:0] sums_3_sum_sums_values_0_q;
  logic [7:0] sums_4_columns_values_0_q;
  logic [7:0] sums_4_columns_values_1_q;
  logic [7:0] sums_4_columns_values_2_q;
  logic [7:0] sums_4_columns_values_3_q;
  logic [7:0] sums_4_columns_values_4_q;
  logic [7:0] sums_4_columns_values_5_q;
  logic [7:0] sums_4_columns_values_6_q;
  // hls/stages/agreement.hpp:407
  logic [7:0] sum_573;
  assign sum_573 = difference_570_s12_q + (equal_571_s12_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  logic [7:0] sum_626;
  assign sum_626 = difference_624_s12_q + (equal_571_s12_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  logic [7:0] sum_681;
  assign sum_681 = difference_679_s12_q + (equal_571_s12_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  logic [7:0] difference_736;
  assign difference_736 = {2'h0, column_12_s12_q} - (age_s12_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] difference_796;
  assign difference_796 = {2'h0, column_15_s12_q} - (age_s12_q[1] ? sums_4_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1306;
  assign select_1306 = equal_354_s12_q ? {2'h0, column_12_s12_q} : sums_0_columns_values_0_q;
  logic [7:0] select_1307;
  assign select_1307 = equal_354_s12_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1308;
  assign select_1308 = equal_354_s12_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1309;
  assign select_1309 = equal_354_s12_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1310;
  assign select_1310 = equal_354_s12_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1311;
  assign select_1311 = equal_354_s12_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1312;
  assign select_1312 = equal_354_s12_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1338;
  assign select_1338 = equal_354_s12_q ? {2'h0, column_15_s12_q} : sums_4_columns_values_0_q;
  logic [7:0] select_1339;
  assign select_1339 = equal_354_s12_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1340;
  assign select_1340 = equal_354_s12_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1341;
  assign select_1341 = equal_354_s12_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1342;
  assign select_1342 = equal_354_s12_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1343;
  assign select_1343 = equal_354_s12_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1344;
  assign select_1344 = equal_354_s12_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1451;
  assign sum_1451 = sum_1447_s12_q + {sum_1450_s12_q, select_1448_s12_q};
  logic [9:0] sum_1452;
  assign sum_1452 = {difference_1444_s12_q, select_1442_s12_q} + sum_1451[11:2];

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
    sums_3_sum_sums_values_0_q = 8'h0;
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
      sums_0_columns_values_0_q <= select_1306;
      sums_0_columns_values_1_q <= select_1307;
      sums_0_columns_values_2_q <= select_1308;
      sums_0_columns_values_3_q <= select_1309;
      sums_0_columns_values_4_q <= select_1310;
      sums_0_columns_values_5_q <= select_1311;
      sums_0_columns_values_6_q <= select_1312;
      sums_1_sum_sums_values_0_q <= equal_354_s12_q ? sum_626 : sums_1_sum_sums_values_0_q;
      sums_2_sum_sums_values_0_q <= equal_354_s12_q ? sum_573 : sums_2_sum_sums_values_0_q;
      sums_3_sum_sums_values_0_q <= equal_354_s12_q ? sum_681 : sums_3_sum_sums_values_0_q;
      sums_4_columns_values_0_q <= select_1338;
      sums_4_columns_values_1_q <= select_1339;
      sums_4_columns_values_2_q <= select_1340;
      sums_4_columns_values_3_q <= select_1341;
      sums_4_columns_values_4_q <= select_1342;
      sums_4_columns_values_5_q <= select_1343;
      sums_4_columns_values_6_q <= select_1344;
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
  logic [11:0] registration_slope_s13_q;
  logic equal_301_s13_q;
  logic [6:0] select_303_s13_q;
  logic [8:0] select_307_s13_q;
  logic and_316_s13_q;
  logic equal_321_s13_q;
  logic whole_s13_q;
  logic and_338_s13_q;
  logic and_339_s13_q;
  logic equal_342_s13_q;
  logic equal_354_s13_q;
  logic not_355_s13_q;
  logic equal_356_s13_q;
  logic less_357_s13_q;
  logic not_358_s13_q;
  logic equal_388_s13_q;
  logic drew_s13_q;
  logic left_rdata_s13_q;
  logic [6:0] x_s13_2_q;
  logic not_499_s13_q;
  logic select_501_s13_q;
  logic [21:0] best_left_rdata_s13_q;
  logic equal_504_s13_q;
  logic equal_571_s13_q;
  logic [7:0] sum_573_s13_q;
  logic [7:0] sum_626_s13_q;
  logic less_627_s13_q;
  logic [7:0] sum_681_s13_q;
  logic [7:0] difference_736_s13_q;
  logic [7:0] difference_796_s13_q;
  logic equal_808_s13_q;
  logic and_866_s13_q;
  logic equal_872_s13_q;
  logic equal_895_s13_q;
  logic equal_898_s13_q;
  logic and_909_s13_q;
  logic and_940_s13_q;
  logic select_949_s13_q;
  logic and_1046_s13_q;
  logic equal_1163_s13_q;
  logic equal_1214_s13_q;
  logic not_1260_s13_q;
  logic and_1348_s13_q;
  logic less_1431_s13_q;
  logic less_1434_s13_q;
  logic [7:0] sum_1452_s13_q;
  logic less_1707_s13_q;
  logic equal_1864_s13_q;
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
      registration_slope_s13_q <= registration_slope_s12_q;
      equal_301_s13_q <= equal_301_s12_q;
      select_303_s13_q <= select_303_s12_q;
      select_307_s13_q <= select_307_s12_q;
      and_316_s13_q <= and_316_s12_q;
      equal_321_s13_q <= equal_321_s12_q;
      whole_s13_q <= whole_s12_q;
      and_338_s13_q <= and_338_s12_q;
      and_339_s13_q <= and_339_s12_q;
      equal_342_s13_q <= equal_342_s12_q;
      equal_354_s13_q <= equal_354_s12_q;
      not_355_s13_q <= not_355_s12_q;
      equal_356_s13_q <= equal_356_s12_q;
      less_357_s13_q <= less_357_s12_q;
      not_358_s13_q <= not_358_s12_q;
      equal_388_s13_q <= equal_388_s12_q;
      drew_s13_q <= drew_s12_q;
      left_rdata_s13_q <= left_rdata_s12_q;
      x_s13_2_q <= x_s12_2_q;
      not_499_s13_q <= not_499_s12_q;
      select_501_s13_q <= select_501_s12_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      equal_504_s13_q <= equal_504_s12_q;
      equal_571_s13_q <= equal_571_s12_q;
      sum_573_s13_q <= sum_573;
      sum_626_s13_q <= sum_626;
      less_627_s13_q <= sum_573 < sum_626;
      sum_681_s13_q <= sum_681;
      difference_736_s13_q <= difference_736;
      difference_796_s13_q <= difference_796;
      equal_808_s13_q <= equal_808_s12_q;
      and_866_s13_q <= and_866_s12_q;
      equal_872_s13_q <= equal_872_s12_q;
      equal_895_s13_q <= equal_895_s12_q;
      equal_898_s13_q <= equal_898_s12_q;
      and_909_s13_q <= and_909_s12_q;
      and_940_s13_q <= and_940_s12_q;
      select_949_s13_q <= select_949_s12_q;
      and_1046_s13_q <= and_1046_s12_q;
      equal_1163_s13_q <= equal_1163_s12_q;
      equal_1214_s13_q <= equal_1214_s12_q;
      not_1260_s13_q <= not_1260_s12_q;
      and_1348_s13_q <= and_1348_s12_q;
      less_1431_s13_q <= less_1431_s12_q;
      less_1434_s13_q <= less_1434_s12_q;
      sum_1452_s13_q <= sum_1452[9:2];
      less_1707_s13_q <= less_1707_s12_q;
      equal_1864_s13_q <= equal_1864_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_4_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:420
  logic not_683;
  assign not_683 = ~less_627_s13_q;
  logic [1:0] best;
  assign best = ((less_627_s13_q ? sum_626_s13_q : sum_573_s13_q) < sum_681_s13_q) ? 2'h3 : {not_683, less_627_s13_q};
  // hls/stages/agreement.hpp:407
  logic [7:0] sum_738;
  assign sum_738 = difference_736_s13_q + (equal_571_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  logic [7:0] sum_798;
  assign sum_798 = difference_796_s13_q + (equal_571_s13_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:432
  logic [6:0] partner;
  assign partner = {run_shift_s13_q[5], run_shift_s13_q} + x_s13_2_q;
  // hls/stages/agreement.hpp:503
  logic [6:0] sum_868;
  assign sum_868 = x_s13_q[6:0] + {best_left_rdata_s13_q[13], best_left_rdata_s13_q[13:8]};
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1453;
  assign sum_1453 = {registration_slope_s13_q[11], registration_slope_s13_q} + {{5{sum_1452_s13_q[7]}}, sum_1452_s13_q};

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_4_sum_sums_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s13_en) begin
      sums_0_sum_sums_values_0_q <= equal_354_s13_q ? sum_738 : sums_0_sum_sums_values_0_q;
      sums_4_sum_sums_values_0_q <= equal_354_s13_q ? sum_798 : sums_4_sum_sums_values_0_q;
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
  logic equal_301_s14_q;
  logic [6:0] select_303_s14_q;
  logic [8:0] select_307_s14_q;
  logic and_316_s14_q;
  logic equal_321_s14_q;
  logic whole_s14_q;
  logic and_338_s14_q;
  logic and_339_s14_q;
  logic equal_342_s14_q;
  logic equal_354_s14_q;
  logic not_355_s14_q;
  logic equal_356_s14_q;
  logic less_357_s14_q;
  logic not_358_s14_q;
  logic equal_388_s14_q;
  logic drew_s14_q;
  logic left_rdata_s14_q;
  logic [6:0] x_s14_2_q;
  logic not_499_s14_q;
  logic select_501_s14_q;
  logic [21:0] best_left_rdata_s14_q;
  logic equal_504_s14_q;
  logic [7:0] sum_573_s14_q;
  logic [7:0] sum_626_s14_q;
  logic [7:0] sum_681_s14_q;
  logic [1:0] best_s14_q;
  logic [7:0] select_685_s14_q;
  logic [7:0] sum_738_s14_q;
  logic [7:0] select_739_s14_q;
  logic [7:0] sum_798_s14_q;
  logic equal_808_s14_q;
  logic and_866_s14_q;
  logic [6:0] partner_s14_q;
  logic [6:0] select_869_s14_q;
  logic equal_872_s14_q;
  logic equal_895_s14_q;
  logic equal_898_s14_q;
  logic and_909_s14_q;
  logic and_940_s14_q;
  logic select_949_s14_q;
  logic and_1046_s14_q;
  logic equal_1163_s14_q;
  logic equal_1214_s14_q;
  logic not_1260_s14_q;
  logic and_1348_s14_q;
  logic less_1431_s14_q;
  logic less_1434_s14_q;
  logic [7:0] sum_1453_s14_q;
  logic less_1454_s14_q;
  logic less_1455_s14_q;
  logic less_1707_s14_q;
  logic equal_1864_s14_q;
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
      equal_301_s14_q <= equal_301_s13_q;
      select_303_s14_q <= select_303_s13_q;
      select_307_s14_q <= select_307_s13_q;
      and_316_s14_q <= and_316_s13_q;
      equal_321_s14_q <= equal_321_s13_q;
      whole_s14_q <= whole_s13_q;
      and_338_s14_q <= and_338_s13_q;
      and_339_s14_q <= and_339_s13_q;
      equal_342_s14_q <= equal_342_s13_q;
      equal_354_s14_q <= equal_354_s13_q;
      not_355_s14_q <= not_355_s13_q;
      equal_356_s14_q <= equal_356_s13_q;
      less_357_s14_q <= less_357_s13_q;
      not_358_s14_q <= not_358_s13_q;
      equal_388_s14_q <= equal_388_s13_q;
      drew_s14_q <= drew_s13_q;
      left_rdata_s14_q <= left_rdata_s13_q;
      x_s14_2_q <= x_s13_2_q;
      not_499_s14_q <= not_499_s13_q;
      select_501_s14_q <= select_501_s13_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      equal_504_s14_q <= equal_504_s13_q;
      sum_573_s14_q <= sum_573_s13_q;
      sum_626_s14_q <= sum_626_s13_q;
      sum_681_s14_q <= sum_681_s13_q;
      best_s14_q <= best;
      select_685_s14_q <= best[0] ? sum_681_s13_q : sum_573_s13_q;
      sum_738_s14_q <= sum_738;
      select_739_s14_q <= best[0] ? sum_626_s13_q : sum_738;
      sum_798_s14_q <= sum_798;
      equal_808_s14_q <= equal_808_s13_q;
      and_866_s14_q <= and_866_s13_q;
      partner_s14_q <= partner;
      select_869_s14_q <= equal_354_s13_q ? partner : sum_868;
      equal_872_s14_q <= equal_872_s13_q;
      equal_895_s14_q <= equal_895_s13_q;
      equal_898_s14_q <= equal_898_s13_q;
      and_909_s14_q <= and_909_s13_q;
      and_940_s14_q <= and_940_s13_q;
      select_949_s14_q <= select_949_s13_q;
      and_1046_s14_q <= and_1046_s13_q;
      equal_1163_s14_q <= equal_1163_s13_q;
      equal_1214_s14_q <= equal_1214_s13_q;
      not_1260_s14_q <= not_1260_s13_q;
      and_1348_s14_q <= and_1348_s13_q;
      less_1431_s14_q <= less_1431_s13_q;
      less_1434_s14_q <= less_1434_s13_q;
      sum_1453_s14_q <= sum_1453[7:0];
      less_1454_s14_q <= $signed(6'h0) < $signed(sum_1453[12:7]);
      less_1455_s14_q <= $signed(sum_1453[12:7]) < $signed(6'h3f);
      less_1707_s14_q <= less_1707_s13_q;
      equal_1864_s14_q <= equal_1864_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:420
  logic less_741;
  assign less_741 = (best_s14_q[1] ? select_685_s14_q : select_739_s14_q) < sum_738_s14_q;
  logic [1:0] best_2;
  assign best_2 = less_741 ? 2'h0 : best_s14_q;
  // hls/stages/registration.hpp:151
  logic [7:0] slope;
  assign slope = less_1454_s14_q ? 8'h7f : (less_1455_s14_q ? 8'h80 : sum_1453_s14_q);
  logic [6:0] select_1458;
  assign select_1458 = best_left_rdata_s14_q[8] ? slope[7:1] : 7'h0;
  logic [7:0] select_1459;
  assign select_1459 = best_left_rdata_s14_q[9] ? slope : 8'h0;
  logic [8:0] sum_1460;
  assign sum_1460 = {{2{select_1458[6]}}, select_1458} + {select_1459[7], select_1459};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1461;
  assign select_1461 = best_left_rdata_s14_q[10] ? slope : 8'h0;
  logic [7:0] select_1462;
  assign select_1462 = best_left_rdata_s14_q[11] ? slope : 8'h0;
  logic [8:0] sum_1463;
  assign sum_1463 = {{2{select_1461[7]}}, select_1461[7:1]} + {select_1462[7], select_1462};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1465;
  assign select_1465 = best_left_rdata_s14_q[12] ? slope : 8'h0;
  logic [7:0] select_1466;
  assign select_1466 = best_left_rdata_s14_q[13] ? slope : 8'h0;
  logic [8:0] difference_1467;
  assign difference_1467 = {{2{select_1465[7]}}, select_1465[7:1]} - {select_1466[7], select_1466};

  // Memory best_right, 120 x 15, DISTANCE 32, hls/stages/agreement.hpp:769; read in stage 14, written in stage 18: 14 < 18 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 15'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = select_869_s14_q;
  logic best_right_re;
  assign best_right_re = s14_en & select_501_s14_q;
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
  logic equal_301_s15_q;
  logic [6:0] select_303_s15_q;
  logic [8:0] select_307_s15_q;
  logic and_316_s15_q;
  logic equal_321_s15_q;
  logic whole_s15_q;
  logic and_338_s15_q;
  logic and_339_s15_q;
  logic equal_342_s15_q;
  logic equal_354_s15_q;
  logic not_355_s15_q;
  logic equal_356_s15_q;
  logic less_357_s15_q;
  logic not_358_s15_q;
  logic equal_388_s15_q;
  logic drew_s15_q;
  logic left_rdata_s15_q;
  logic [6:0] x_s15_2_q;
  logic not_499_s15_q;
  logic [21:0] best_left_rdata_s15_q;
  logic equal_504_s15_q;
  logic [7:0] sum_573_s15_q;
  logic [7:0] sum_626_s15_q;
  logic [7:0] sum_681_s15_q;
  logic [7:0] sum_738_s15_q;
  logic [1:0] best_2_s15_q;
  logic [7:0] select_743_s15_q;
  logic [7:0] select_744_s15_q;
  logic [7:0] sum_798_s15_q;
  logic equal_808_s15_q;
  logic and_866_s15_q;
  logic [6:0] partner_s15_q;
  logic equal_872_s15_q;
  logic equal_895_s15_q;
  logic equal_898_s15_q;
  logic and_909_s15_q;
  logic and_940_s15_q;
  logic select_949_s15_q;
  logic and_1046_s15_q;
  logic equal_1163_s15_q;
  logic equal_1214_s15_q;
  logic not_1260_s15_q;
  logic and_1348_s15_q;
  logic less_1431_s15_q;
  logic less_1434_s15_q;
  logic [7:0] sum_1460_s15_q;
  logic select_1461_s15_q;
  logic [8:0] sum_1463_s15_q;
  logic select_1465_s15_q;
  logic [8:0] difference_1467_s15_q;
  logic less_1707_s15_q;
  logic equal_1864_s15_q;
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
      equal_301_s15_q <= equal_301_s14_q;
      select_303_s15_q <= select_303_s14_q;
      select_307_s15_q <= select_307_s14_q;
      and_316_s15_q <= and_316_s14_q;
      equal_321_s15_q <= equal_321_s14_q;
      whole_s15_q <= whole_s14_q;
      and_338_s15_q <= and_338_s14_q;
      and_339_s15_q <= and_339_s14_q;
      equal_342_s15_q <= equal_342_s14_q;
      equal_354_s15_q <= equal_354_s14_q;
      not_355_s15_q <= not_355_s14_q;
      equal_356_s15_q <= equal_356_s14_q;
      less_357_s15_q <= less_357_s14_q;
      not_358_s15_q <= not_358_s14_q;
      equal_388_s15_q <= equal_388_s14_q;
      drew_s15_q <= drew_s14_q;
      left_rdata_s15_q <= left_rdata_s14_q;
      x_s15_2_q <= x_s14_2_q;
      not_499_s15_q <= not_499_s14_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      equal_504_s15_q <= equal_504_s14_q;
      sum_573_s15_q <= sum_573_s14_q;
      sum_626_s15_q <= sum_626_s14_q;
      sum_681_s15_q <= sum_681_s14_q;
      sum_738_s15_q <= sum_738_s14_q;
      best_2_s15_q <= best_2;
      select_743_s15_q <= best_2[0] ? sum_681_s14_q : sum_573_s14_q;
      select_744_s15_q <= best_2[0] ? sum_626_s14_q : sum_738_s14_q;
      sum_798_s15_q <= sum_798_s14_q;
      equal_808_s15_q <= equal_808_s14_q;
      and_866_s15_q <= and_866_s14_q;
      partner_s15_q <= partner_s14_q;
      equal_872_s15_q <= equal_872_s14_q;
      equal_895_s15_q <= equal_895_s14_q;
      equal_898_s15_q <= equal_898_s14_q;
      and_909_s15_q <= and_909_s14_q;
      and_940_s15_q <= and_940_s14_q;
      select_949_s15_q <= select_949_s14_q;
      and_1046_s15_q <= and_1046_s14_q;
      equal_1163_s15_q <= equal_1163_s14_q;
      equal_1214_s15_q <= equal_1214_s14_q;
      not_1260_s15_q <= not_1260_s14_q;
      and_1348_s15_q <= and_1348_s14_q;
      less_1431_s15_q <= less_1431_s14_q;
      less_1434_s15_q <= less_1434_s14_q;
      sum_1460_s15_q <= sum_1460[8:1];
      select_1461_s15_q <= select_1461[0];
      sum_1463_s15_q <= sum_1463;
      select_1465_s15_q <= select_1465[0];
      difference_1467_s15_q <= difference_1467;
      less_1707_s15_q <= less_1707_s14_q;
      equal_1864_s15_q <= equal_1864_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:412
  logic less_505;
  assign less_505 = $signed(run_shift_s15_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_507;
  assign less_507 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s15_q);
  // hls/stages/agreement.hpp:420
  logic less_799;
  assign less_799 = (best_2_s15_q[1] ? select_743_s15_q : select_744_s15_q) < sum_798_s15_q;
  logic [1:0] select_800;
  assign select_800 = less_799 ? 2'h0 : best_2_s15_q;
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1464;
  assign sum_1464 = {{3{sum_1460_s15_q[7]}}, sum_1460_s15_q} + {sum_1463_s15_q[8], sum_1463_s15_q, select_1461_s15_q};
  logic [9:0] sum_1468;
  assign sum_1468 = {difference_1467_s15_q, select_1465_s15_q} + {sum_1464[10], sum_1464[10:2]};

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:146; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_307_s15_q;
  logic averager_memory_re;
  assign averager_memory_re = s15_en & and_316_s15_q;
  logic [29:0] averager_memory_rdata_q;
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
  logic equal_301_s16_q;
  logic [6:0] select_303_s16_q;
  logic [8:0] select_307_s16_q;
  logic and_316_s16_q;
  logic equal_321_s16_q;
  logic whole_s16_q;
  logic and_338_s16_q;
  logic and_339_s16_q;
  logic equal_342_s16_q;
  logic equal_354_s16_q;
  logic not_355_s16_q;
  logic equal_356_s16_q;
  logic less_357_s16_q;
  logic not_358_s16_q;
  logic equal_388_s16_q;
  logic drew_s16_q;
  logic left_rdata_s16_q;
  logic [6:0] x_s16_2_q;
  logic not_499_s16_q;
  logic [21:0] best_left_rdata_s16_q;
  logic equal_504_s16_q;
  logic and_509_s16_q;
  logic [7:0] sum_573_s16_q;
  logic [7:0] sum_626_s16_q;
  logic [7:0] sum_681_s16_q;
  logic [7:0] sum_738_s16_q;
  logic [7:0] sum_798_s16_q;
  logic less_799_s16_q;
  logic [1:0] select_800_s16_q;
  logic [7:0] select_801_s16_q;
  logic [7:0] select_802_s16_q;
  logic equal_808_s16_q;
  logic equal_819_s16_q;
  logic and_866_s16_q;
  logic [6:0] partner_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic equal_872_s16_q;
  logic equal_895_s16_q;
  logic equal_898_s16_q;
  logic and_909_s16_q;
  logic and_940_s16_q;
  logic select_949_s16_q;
  logic and_1046_s16_q;
  logic equal_1163_s16_q;
  logic equal_1214_s16_q;
  logic not_1260_s16_q;
  logic and_1348_s16_q;
  logic less_1431_s16_q;
  logic less_1434_s16_q;
  logic sum_1464_s16_q;
  logic [9:0] sum_1468_s16_q;
  logic less_1707_s16_q;
  logic equal_1864_s16_q;
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
      equal_301_s16_q <= equal_301_s15_q;
      select_303_s16_q <= select_303_s15_q;
      select_307_s16_q <= select_307_s15_q;
      and_316_s16_q <= and_316_s15_q;
      equal_321_s16_q <= equal_321_s15_q;
      whole_s16_q <= whole_s15_q;
      and_338_s16_q <= and_338_s15_q;
      and_339_s16_q <= and_339_s15_q;
      equal_342_s16_q <= equal_342_s15_q;
      equal_354_s16_q <= equal_354_s15_q;
      not_355_s16_q <= not_355_s15_q;
      equal_356_s16_q <= equal_356_s15_q;
      less_357_s16_q <= less_357_s15_q;
      not_358_s16_q <= not_358_s15_q;
      equal_388_s16_q <= equal_388_s15_q;
      drew_s16_q <= drew_s15_q;
      left_rdata_s16_q <= left_rdata_s15_q;
      x_s16_2_q <= x_s15_2_q;
      not_499_s16_q <= not_499_s15_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      equal_504_s16_q <= equal_504_s15_q;
      and_509_s16_q <= (~less_505) & (~less_507);
      sum_573_s16_q <= sum_573_s15_q;
      sum_626_s16_q <= sum_626_s15_q;
      sum_681_s16_q <= sum_681_s15_q;
      sum_738_s16_q <= sum_738_s15_q;
      sum_798_s16_q <= sum_798_s15_q;
      less_799_s16_q <= less_799;
      select_800_s16_q <= select_800;
      select_801_s16_q <= select_800[0] ? sum_681_s15_q : sum_573_s15_q;
      select_802_s16_q <= select_800[0] ? sum_626_s15_q : sum_738_s15_q;
      equal_808_s16_q <= equal_808_s15_q;
      equal_819_s16_q <= {less_799, select_800} == 3'h0;
      and_866_s16_q <= and_866_s15_q;
      partner_s16_q <= partner_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_q;
      equal_872_s16_q <= equal_872_s15_q;
      equal_895_s16_q <= equal_895_s15_q;
      equal_898_s16_q <= equal_898_s15_q;
      and_909_s16_q <= and_909_s15_q;
      and_940_s16_q <= and_940_s15_q;
      select_949_s16_q <= select_949_s15_q;
      and_1046_s16_q <= and_1046_s15_q;
      equal_1163_s16_q <= equal_1163_s15_q;
      equal_1214_s16_q <= equal_1214_s15_q;
      not_1260_s16_q <= not_1260_s15_q;
      and_1348_s16_q <= and_1348_s15_q;
      less_1431_s16_q <= less_1431_s15_q;
      less_1434_s16_q <= less_1434_s15_q;
      sum_1464_s16_q <= sum_1464[1];
      sum_1468_s16_q <= sum_1468;
      less_1707_s16_q <= less_1707_s15_q;
      equal_1864_s16_q <= equal_1864_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/census.hpp:91
  logic [13:0] select_319;
  assign select_319 = equal_301_s16_q ? {6'h0, pixel_0_s16_q} : ({6'h0, pixel_0_s16_q} + averager_running_0_q);
  logic [13:0] sum_325;
  assign sum_325 = {6'h0, pixel_1_s16_q} + (equal_301_s16_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:174
  logic all_of_skin;
  assign all_of_skin = equal_301_s16_q ? mask_s16_q : (mask_s16_q & averager_running_of_skin_q);
  // hls/stages/agreement.hpp:422
  logic [7:0] of_best;
  assign of_best = less_799_s16_q ? sum_798_s16_q : (select_800_s16_q[1] ? select_801_s16_q : select_802_s16_q);
  logic [7:0] of_best_2;
  assign of_best_2 = and_509_s16_q ? of_best : 8'h0;
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_799_s16_q, select_800_s16_q} == 3'h4) ? 3'h3 : (equal_819_s16_q ? 3'h1 : {less_799_s16_q, select_800_s16_q});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_823;
  assign sum_823 = near_best + 3'h1;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_828;
  assign sum_828 = near_best + 3'h7;
  // hls/stages/registration.hpp:26
  logic [7:0] select_837;
  assign select_837 = near_best[1] ? (near_best[0] ? sum_681_s16_q : sum_573_s16_q) : (near_best[0] ? sum_626_s16_q : sum_738_s16_q);
  // hls/stages/division.hpp:18
  logic [5:0] sum_893;
  assign sum_893 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:505
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_s16_q[14:8]} - {1'b0, x_s16_q};
  // hls/stages/agreement.hpp:509
  logic and_928;
  assign and_928 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s16_q[13:8]));
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1469;
  assign difference_1469 = {{4{best_left_rdata_s16_q[21]}}, best_left_rdata_s16_q[21:14]} - {sum_1468_s16_q[9], sum_1468_s16_q, sum_1464_s16_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_1717;
  assign sum_1717 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1718;
  assign select_1718 = sum_893[5] ? {1'b1, sum_893[4:0], region_across_rest_q[2:0]} : sum_1717;
  // hls/stages/agreement.hpp:246
  logic [8:0] select_1722;
  assign select_1722 = equal_1214_s16_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_1725;
  assign select_1725 = equal_1214_s16_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_running_of_skin_q <= 1'b0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s16_en) begin
      averager_running_of_skin_q <= all_of_skin;
      region_across_rest_q <= drew_s16_q ? select_1718 : columns_begin_rest_q;
      region_across_back_q <= drew_s16_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_339_s16_q ? select_1722 : columns_begin_rest_q;
      columns_begin_back_q <= and_339_s16_q ? select_1725 : columns_begin_back_q;
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
      averager_running_0_q <= select_319;
      averager_running_1_q <= sum_325;
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
  logic [6:0] select_303_s17_q;
  logic [8:0] select_307_s17_q;
  logic and_316_s17_q;
  logic [29:0] averager_memory_rdata_s17_q;
  logic equal_321_s17_q;
  logic whole_s17_q;
  logic and_338_s17_q;
  logic and_339_s17_q;
  logic equal_342_s17_q;
  logic equal_354_s17_q;
  logic not_355_s17_q;
  logic equal_356_s17_q;
  logic less_357_s17_q;
  logic not_358_s17_q;
  logic equal_388_s17_q;
  logic drew_s17_q;
  logic left_rdata_s17_q;
  logic [6:0] x_s17_2_q;
  logic not_499_s17_q;
  logic [21:0] best_left_rdata_s17_q;
  logic equal_504_s17_q;
  logic [7:0] sum_798_s17_q;
  logic select_800_s17_q;
  logic [7:0] of_best_2_s17_q;
  logic less_807_s17_q;
  logic equal_808_s17_q;
  logic equal_822_s17_q;
  logic [1:0] sum_823_s17_q;
  logic [7:0] select_824_s17_q;
  logic [7:0] select_825_s17_q;
  logic [1:0] sum_828_s17_q;
  logic [7:0] select_829_s17_q;
  logic [7:0] select_830_s17_q;
  logic [1:0] sum_834_s17_q;
  logic [7:0] select_838_s17_q;
  logic and_866_s17_q;
  logic [6:0] partner_s17_q;
  logic [14:0] best_right_rdata_s17_q;
  logic less_871_s17_q;
  logic equal_872_s17_q;
  logic sum_893_s17_q;
  logic equal_895_s17_q;
  logic equal_898_s17_q;
  logic and_909_s17_q;
  logic [8:0] way_s17_q;
  logic and_928_s17_q;
  logic and_940_s17_q;
  logic select_949_s17_q;
  logic and_1046_s17_q;
  logic equal_1163_s17_q;
  logic equal_1214_s17_q;
  logic not_1260_s17_q;
  logic and_1348_s17_q;
  logic less_1431_s17_q;
  logic less_1434_s17_q;
  logic [11:0] difference_1469_s17_q;
  logic less_1707_s17_q;
  logic equal_1864_s17_q;
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
      select_303_s17_q <= select_303_s16_q;
      select_307_s17_q <= select_307_s16_q;
      and_316_s17_q <= and_316_s16_q;
      averager_memory_rdata_s17_q <= averager_memory_rdata_q;
      equal_321_s17_q <= equal_321_s16_q;
      whole_s17_q <= whole_s16_q;
      and_338_s17_q <= and_338_s16_q;
      and_339_s17_q <= and_339_s16_q;
      equal_342_s17_q <= equal_342_s16_q;
      equal_354_s17_q <= equal_354_s16_q;
      not_355_s17_q <= not_355_s16_q;
      equal_356_s17_q <= equal_356_s16_q;
      less_357_s17_q <= less_357_s16_q;
      not_358_s17_q <= not_358_s16_q;
      equal_388_s17_q <= equal_388_s16_q;
      drew_s17_q <= drew_s16_q;
      left_rdata_s17_q <= left_rdata_s16_q;
      x_s17_2_q <= x_s16_2_q;
      not_499_s17_q <= not_499_s16_q;
      best_left_rdata_s17_q <= best_left_rdata_s16_q;
      equal_504_s17_q <= equal_504_s16_q;
      sum_798_s17_q <= sum_798_s16_q;
      select_800_s17_q <= select_800_s16_q[0];
      of_best_2_s17_q <= of_best_2;
      less_807_s17_q <= best_left_rdata_s16_q[7:0] < of_best_2;
      equal_808_s17_q <= equal_808_s16_q;
      equal_822_s17_q <= {less_799_s16_q, select_800_s16_q} == near_best;
      sum_823_s17_q <= sum_823[2:1];
      select_824_s17_q <= sum_823[0] ? sum_681_s16_q : sum_573_s16_q;
      select_825_s17_q <= sum_823[0] ? sum_626_s16_q : sum_738_s16_q;
      sum_828_s17_q <= sum_828[2:1];
      select_829_s17_q <= sum_828[0] ? sum_681_s16_q : sum_573_s16_q;
      select_830_s17_q <= sum_828[0] ? sum_626_s16_q : sum_738_s16_q;
      sum_834_s17_q <= {less_799_s16_q, select_800_s16_q[1]} + 2'h3;
      select_838_s17_q <= near_best[2] ? sum_798_s16_q : select_837;
      and_866_s17_q <= and_866_s16_q;
      partner_s17_q <= partner_s16_q;
      best_right_rdata_s17_q <= best_right_rdata_s16_q;
      less_871_s17_q <= best_right_rdata_s16_q[7:0] < of_best_2;
      equal_872_s17_q <= equal_872_s16_q;
      sum_893_s17_q <= sum_893[5];
      equal_895_s17_q <= equal_895_s16_q;
      equal_898_s17_q <= equal_898_s16_q;
      and_909_s17_q <= and_909_s16_q;
      way_s17_q <= way;
      and_928_s17_q <= and_928;
      and_940_s17_q <= and_940_s16_q;
      select_949_s17_q <= select_949_s16_q;
      and_1046_s17_q <= and_1046_s16_q;
      equal_1163_s17_q <= equal_1163_s16_q;
      equal_1214_s17_q <= equal_1214_s16_q;
      not_1260_s17_q <= not_1260_s16_q;
      and_1348_s17_q <= and_1348_s16_q;
      less_1431_s17_q <= less_1431_s16_q;
      less_1434_s17_q <= less_1434_s16_q;
      difference_1469_s17_q <= difference_1469;
      less_1707_s17_q <= less_1707_s16_q;
      equal_1864_s17_q <= equal_1864_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  // hls/stages/census.hpp:100
  logic [13:0] sum_323;
  assign sum_323 = averager_running_0_q + (equal_321_s17_q ? 14'h0 : averager_memory_rdata_s17_q[13:0]);
  logic [13:0] sum_327;
  assign sum_327 = averager_running_1_q + (equal_321_s17_q ? 14'h0 : averager_memory_rdata_s17_q[27:14]);
  // hls/stages/census.hpp:101
  logic and_331;
  assign and_331 = whole_s17_q & (averager_memory_rdata_s17_q[28] | equal_321_s17_q);
  // hls/stages/census.hpp:102
  logic and_335;
  assign and_335 = averager_running_of_skin_q & (averager_memory_rdata_s17_q[29] | equal_321_s17_q);
  // hls/stages/agreement.hpp:424
  logic less_806;
  assign less_806 = $signed(run_shift_s17_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:427
  logic or_809;
  assign or_809 = less_807_s17_q | equal_808_s17_q;
  // hls/stages/agreement.hpp:430
  logic [7:0] select_812;
  assign select_812 = less_806 ? (or_809 ? of_best_2_s17_q : best_left_rdata_s17_q[7:0]) : (less_807_s17_q ? of_best_2_s17_q : best_left_rdata_s17_q[7:0]);
  logic [5:0] select_816;
  assign select_816 = less_806 ? (or_809 ? run_shift_s17_q : best_left_rdata_s17_q[13:8]) : (less_807_s17_q ? run_shift_s17_q : best_left_rdata_s17_q[13:8]);
  // hls/stages/registration.hpp:23
  logic [7:0] below;
  assign below = sum_823_s17_q[1] ? sum_798_s17_q : (sum_823_s17_q[0] ? select_824_s17_q : select_825_s17_q);
  // hls/stages/registration.hpp:22
  logic [7:0] above;
  assign above = sum_828_s17_q[1] ? sum_798_s17_q : (sum_828_s17_q[0] ? select_829_s17_q : select_830_s17_q);
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/agreement.hpp:434
  logic or_873;
  assign or_873 = less_871_s17_q | equal_872_s17_q;
  // hls/stages/agreement.hpp:435
  logic [7:0] select_876;
  assign select_876 = less_806 ? (or_873 ? of_best_2_s17_q : best_right_rdata_s17_q[7:0]) : (less_871_s17_q ? of_best_2_s17_q : best_right_rdata_s17_q[7:0]);
  logic [6:0] select_880;
  assign select_880 = less_806 ? (or_873 ? x_s17_2_q : best_right_rdata_s17_q[14:8]) : (less_871_s17_q ? x_s17_2_q : best_right_rdata_s17_q[14:8]);
  // hls/stages/agreement.hpp:140
  logic [7:0] select_882;
  assign select_882 = drew_s17_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:538
  logic or_885;
  assign or_885 = select_882[7] | (~({select_882[5], select_882[3], select_882[1]} == 3'h0));
  // hls/stages/agreement.hpp:546
  logic or_896;
  assign or_896 = (~sum_893_s17_q) | equal_895_s17_q;
  // hls/stages/agreement.hpp:516
  logic and_897;
  assign and_897 = not_358_s17_q & or_896;
  // hls/stages/agreement.hpp:606
  logic equal_899;
  assign equal_899 = x_s17_q[5:4] == 2'h3;
  // hls/stages/agreement.hpp:299
  logic and_901;
  assign and_901 = equal_898_s17_q & (~equal_899);
  logic and_904;
  assign and_904 = not_355_s17_q & (not_499_s17_q & (drew_s17_q ? and_897 : and_901));
  // hls/stages/agreement.hpp:507
  logic [9:0] sum_918;
  assign sum_918 = {way_s17_q[8], way_s17_q} + 10'h1;
  // hls/stages/agreement.hpp:516
  logic [7:0] select_990;
  assign select_990 = less_357_s17_q ? select_882 : (sum_893_s17_q ? select_882 : {select_882[6:0], 1'b0});
  // hls/stages/agreement.hpp:538
  logic or_993;
  assign or_993 = select_990[7] | (~({select_990[5], select_990[3], select_990[1]} == 3'h0));
  // hls/stages/registration.hpp:158
  logic [11:0] select_1471;
  assign select_1471 = ($signed(difference_1469_s17_q[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1469_s17_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_1708;
  assign sum_1708 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1716;
  assign select_1716 = equal_354_s17_q ? select_882 : (equal_356_s17_q ? select_882 : (drew_s17_q ? select_990 : 8'h1));
  // hls/stages/agreement.hpp:246
  logic [8:0] select_1729;
  assign select_1729 = equal_388_s17_q ? {difference_1727[7], difference_1727} : (less_1707_s17_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1731;
  assign select_1731 = and_339_s17_q ? (equal_1214_s17_q ? select_1729 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:246
  logic [7:0] select_1733;
  assign select_1733 = equal_388_s17_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1735;
  assign select_1735 = and_339_s17_q ? (equal_1214_s17_q ? select_1733 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_1737;
  assign select_1737 = sum_1708[7] ? {1'b1, sum_1708[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:254; read in stage 17, written in stage 19: 17 < 19 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = select_303_s17_q;
  logic census_memory_re;
  assign census_memory_re = s17_en & and_339_s17_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory seen_columns, 120 x 12, DISTANCE 32, hls/stages/agreement.hpp:797; read in stage 17, written in stage 19: 17 < 19 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [11:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 12'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s17_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s17_en & and_940_s17_q;
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
      region_columns_q <= select_1716;
      region_down_rest_q <= select_1731;
      region_down_back_q <= select_1735;
      region_down_next_q <= select_1737;
    end
  end

  logic [7:0] pixel_0_s18_q;
  logic [7:0] pixel_1_s18_q;
  logic saturated_s18_q;
  logic mask_s18_q;
  logic marks_first_s18_q;
  logic marks_last_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic lower_half_s18_q;
  logic [6:0] select_303_s18_q;
  logic [8:0] select_307_s18_q;
  logic and_316_s18_q;
  logic [13:0] sum_323_s18_q;
  logic [13:0] sum_327_s18_q;
  logic and_331_s18_q;
  logic and_335_s18_q;
  logic and_338_s18_q;
  logic and_339_s18_q;
  logic equal_342_s18_q;
  logic equal_354_s18_q;
  logic not_355_s18_q;
  logic equal_356_s18_q;
  logic less_357_s18_q;
  logic not_358_s18_q;
  logic equal_388_s18_q;
  logic drew_s18_q;
  logic left_rdata_s18_q;
  logic [6:0] x_s18_2_q;
  logic not_499_s18_q;
  logic [7:0] best_left_rdata_s18_q;
  logic equal_504_s18_q;
  logic select_800_s18_q;
  logic less_806_s18_q;
  logic less_807_s18_q;
  logic or_809_s18_q;
  logic [7:0] select_813_s18_q;
  logic [5:0] select_817_s18_q;
  logic equal_822_s18_q;
  logic [7:0] below_s18_q;
  logic [7:0] above_s18_q;
  logic rise_s18_q;
  logic [1:0] sum_834_s18_q;
  logic [7:0] select_838_s18_q;
  logic [7:0] xor_842_s18_q;
  logic and_866_s18_q;
  logic [6:0] partner_s18_q;
  logic [7:0] select_877_s18_q;
  logic [6:0] select_881_s18_q;
  logic or_885_s18_q;
  logic or_888_s18_q;
  logic or_891_s18_q;
  logic equal_898_s18_q;
  logic equal_899_s18_q;
  logic and_904_s18_q;
  logic and_909_s18_q;
  logic and_916_s18_q;
  logic less_919_s18_q;
  logic or_929_s18_q;
  logic and_939_s18_q;
  logic and_940_s18_q;
  logic select_949_s18_q;
  logic or_993_s18_q;
  logic or_996_s18_q;
  logic or_999_s18_q;
  logic and_1046_s18_q;
  logic equal_1163_s18_q;
  logic equal_1214_s18_q;
  logic not_1260_s18_q;
  logic and_1348_s18_q;
  logic less_1431_s18_q;
  logic less_1434_s18_q;
  logic [11:0] select_1471_s18_q;
  logic less_1472_s18_q;
  logic less_1707_s18_q;
  logic sum_1708_s18_q;
  logic select_1748_s18_q;
  logic equal_1864_s18_q;
  logic and_2142_s18_q;
  always_ff @(posedge clk_i) begin
    if (s17_en) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      select_303_s18_q <= select_303_s17_q;
      select_307_s18_q <= select_307_s17_q;
      and_316_s18_q <= and_316_s17_q;
      sum_323_s18_q <= sum_323;
      sum_327_s18_q <= sum_327;
      and_331_s18_q <= and_331;
      and_335_s18_q <= and_335;
      and_338_s18_q <= and_338_s17_q;
      and_339_s18_q <= and_339_s17_q;
      equal_342_s18_q <= equal_342_s17_q;
      equal_354_s18_q <= equal_354_s17_q;
      not_355_s18_q <= not_355_s17_q;
      equal_356_s18_q <= equal_356_s17_q;
      less_357_s18_q <= less_357_s17_q;
      not_358_s18_q <= not_358_s17_q;
      equal_388_s18_q <= equal_388_s17_q;
      drew_s18_q <= drew_s17_q;
      left_rdata_s18_q <= left_rdata_s17_q;
      x_s18_2_q <= x_s17_2_q;
      not_499_s18_q <= not_499_s17_q;
      best_left_rdata_s18_q <= best_left_rdata_s17_q[21:14];
      equal_504_s18_q <= equal_504_s17_q;
      select_800_s18_q <= select_800_s17_q;
      less_806_s18_q <= less_806;
      less_807_s18_q <= less_807_s17_q;
      or_809_s18_q <= or_809;
      select_813_s18_q <= equal_504_s17_q ? of_best_2_s17_q : select_812;
      select_817_s18_q <= equal_504_s17_q ? run_shift_s17_q : select_816;
      equal_822_s18_q <= equal_822_s17_q;
      below_s18_q <= below;
      above_s18_q <= above;
      rise_s18_q <= rise[8];
      sum_834_s18_q <= sum_834_s17_q;
      select_838_s18_q <= select_838_s17_q;
      xor_842_s18_q <= rise[7:0] ^ {8{rise[8]}};
      and_866_s18_q <= and_866_s17_q;
      partner_s18_q <= partner_s17_q;
      select_877_s18_q <= equal_504_s17_q ? of_best_2_s17_q : select_876;
      select_881_s18_q <= equal_504_s17_q ? x_s17_2_q : select_880;
      or_885_s18_q <= or_885;
      or_888_s18_q <= select_882[7] | (~({select_882[6], select_882[3:2]} == 3'h0));
      or_891_s18_q <= select_882[7] | (~(select_882[6:4] == 3'h0));
      equal_898_s18_q <= equal_898_s17_q;
      equal_899_s18_q <= equal_899;
      and_904_s18_q <= and_904;
      and_909_s18_q <= and_909_s17_q;
      and_916_s18_q <= and_909_s17_q & (8'hb6 < best_left_rdata_s17_q[7:0]);
      less_919_s18_q <= {{6{sum_918[9]}}, sum_918} < 16'h3;
      or_929_s18_q <= (cfg_nearer_below_i & best_left_rdata_s17_q[13]) | and_928_s17_q;
      and_939_s18_q <= not_355_s17_q & (not_499_s17_q & (drew_s17_q & and_897));
      and_940_s18_q <= and_940_s17_q;
      select_949_s18_q <= select_949_s17_q;
      or_993_s18_q <= or_993;
      or_996_s18_q <= select_990[7] | (~({select_990[6], select_990[3:2]} == 3'h0));
      or_999_s18_q <= select_990[7] | (~(select_990[6:4] == 3'h0));
      and_1046_s18_q <= and_1046_s17_q;
      equal_1163_s18_q <= equal_1163_s17_q;
      equal_1214_s18_q <= equal_1214_s17_q;
      not_1260_s18_q <= not_1260_s17_q;
      and_1348_s18_q <= and_1348_s17_q;
      less_1431_s18_q <= less_1431_s17_q;
      less_1434_s18_q <= less_1434_s17_q;
      select_1471_s18_q <= select_1471;
      less_1472_s18_q <= $signed(5'h0) < $signed(select_1471[11:7]);
      less_1707_s18_q <= less_1707_s17_q;
      sum_1708_s18_q <= sum_1708[7];
      select_1748_s18_q <= sum_893_s17_q ? (equal_895_s17_q & or_896) : or_896;
      equal_1864_s18_q <= equal_1864_s17_q;
      and_2142_s18_q <= not_355_s17_q & (not_499_s17_q & (not_1260_s17_q & and_901));
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [2:0] region_row_q;
  logic region_fresh_q;
  logic segment_starts_q;
  logic [2:0] next_region_row_q;
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_316_s18_q ? sum_323_s18_q[13:5] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_342_s18_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey_2;
  assign grey_2 = and_316_s18_q ? sum_327_s18_q[13:5] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_342_s18_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:126
  logic and_348;
  assign and_348 = and_316_s18_q & and_331_s18_q;
  // hls/stages/census.hpp:105
  logic whole_2;
  assign whole_2 = equal_342_s18_q ? and_348 : (averager_mask_q & and_348);
  // hls/stages/census.hpp:126
  logic and_351;
  assign and_351 = and_316_s18_q & and_335_s18_q;
  // hls/stages/census.hpp:105
  logic select_353;
  assign select_353 = equal_342_s18_q ? and_351 : (averager_of_skin_q & and_351);
  // hls/stages/registration.hpp:26
  logic [7:0] select_839;
  assign select_839 = rise_s18_q ? below_s18_q : above_s18_q;
  logic [8:0] fall;
  assign fall = {1'b0, select_838_s18_q} - {1'b0, select_839};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [8:0] size;
  assign size = {8'h0, rise_s18_q} + {1'b0, xor_842_s18_q};
  // hls/stages/agreement.hpp:299
  logic [5:0] select_892;
  assign select_892 = drew_s18_q ? {region_row_q, or_891_s18_q, or_888_s18_q, or_885_s18_q} : x_s18_q[5:0];
  // hls/stages/agreement.hpp:507
  logic and_920;
  assign and_920 = and_916_s18_q & less_919_s18_q;
  // hls/stages/agreement.hpp:165
  logic and_930;
  assign and_930 = and_920 & or_929_s18_q;
  // hls/stages/agreement.hpp:299
  logic and_1352;
  assign and_1352 = not_355_s18_q & (not_499_s18_q & (drew_s18_q & (not_358_s18_q & and_1348_s18_q)));
  // hls/stages/agreement.hpp:511
  logic and_1432;
  assign and_1432 = and_920 & less_1431_s18_q;
  // hls/stages/registration.hpp:73
  logic equal_1435;
  assign equal_1435 = {lower_half_s18_q, less_1434_s18_q} == 2'h3;
  logic equal_1436;
  assign equal_1436 = {lower_half_s18_q, less_1434_s18_q} == 2'h2;
  logic equal_1437;
  assign equal_1437 = {lower_half_s18_q, less_1434_s18_q} == 2'h1;
  // hls/stages/registration.hpp:158
  logic [11:0] residual;
  assign residual = less_1472_s18_q ? 12'h7f : select_1471_s18_q;
  // hls/stages/registration.hpp:73
  logic not_1511;
  assign not_1511 = ~equal_1435;
  logic not_1512;
  assign not_1512 = ~equal_1436;
  // hls/stages/agreement.hpp:165
  logic and_1517;
  assign and_1517 = not_358_s18_q & (and_1432 & (not_1511 & (not_1512 & (~equal_1437))));
  logic and_1526;
  assign and_1526 = not_358_s18_q & (and_1432 & (not_1511 & (equal_1437 & not_1512)));
  // hls/stages/agreement.hpp:299
  logic and_1535;
  assign and_1535 = drew_s18_q & (not_358_s18_q & (and_1432 & (equal_1436 & not_1511)));
  logic and_1543;
  assign and_1543 = not_499_s18_q & (drew_s18_q & (not_358_s18_q & (and_1432 & equal_1435)));
  // hls/stages/agreement.hpp:246
  logic [2:0] select_1710;
  assign select_1710 = less_1707_s18_q ? (sum_1708_s18_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1712;
  assign select_1712 = equal_1214_s18_q ? (equal_388_s18_q ? 3'h0 : select_1710) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1708_s18_q;
  // hls/stages/agreement.hpp:246
  logic select_1741;
  assign select_1741 = equal_1214_s18_q ? (equal_388_s18_q | (less_1707_s18_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:140
  logic or_1746;
  assign or_1746 = segment_starts_q | not_1260_s18_q;
  // hls/stages/agreement.hpp:299
  logic select_1750;
  assign select_1750 = drew_s18_q ? (less_357_s18_q ? or_1746 : select_1748_s18_q) : or_1746;
  logic select_1752;
  assign select_1752 = equal_354_s18_q ? or_1746 : (equal_356_s18_q ? or_1746 : select_1750);

  // Memory regions, 64 x 36, DISTANCE 32, hls/stages/agreement.hpp:782; read in stage 18, written in stage 21: 18 < 21 < 18 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_892;
  logic regions_re;
  assign regions_re = s18_en & and_904_s18_q;
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_307_s18_q;
  logic averager_memory_we;
  assign averager_memory_we = s18_en & and_316_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_335_s18_q, and_331_s18_q, sum_327_s18_q, sum_323_s18_q};
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

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = partner_s18_q;
  logic best_right_we;
  assign best_right_we = s18_en & and_866_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_881_s18_q, select_877_s18_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_right_raddr_s15_sim;
  logic best_right_re_s15_sim;
  logic [6:0] best_right_raddr_s16_sim;
  logic best_right_re_s16_sim;
  logic [6:0] best_right_raddr_s17_sim;
  logic best_right_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s15_sim <= 1'b0;
      best_right_re_s16_sim <= 1'b0;
      best_right_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      best_right_re_s15_sim <= best_right_re;
      best_right_raddr_s15_sim <= best_right_raddr;
      best_right_re_s16_sim <= best_right_re_s15_sim;
      best_right_raddr_s16_sim <= best_right_raddr_s15_sim;
      best_right_re_s17_sim <= best_right_re_s16_sim;
      best_right_raddr_s17_sim <= best_right_raddr_s16_sim;
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
      if (best_right_waddr >= 7'd120) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd120) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      next_region_row_q <= 3'h0;
    end else if (s18_en) begin
      averager_mask_q <= and_338_s18_q ? whole_2 : averager_mask_q;
      averager_of_skin_q <= and_338_s18_q ? select_353 : averager_of_skin_q;
      region_row_q <= and_339_s18_q ? select_1712 : region_row_q;
      region_fresh_q <= and_339_s18_q ? select_1741 : region_fresh_q;
      segment_starts_q <= select_1752;
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
      averager_total_0_q <= and_338_s18_q ? total : averager_total_0_q;
      averager_total_1_q <= and_338_s18_q ? total_2 : averager_total_1_q;
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
  logic [6:0] select_303_s19_q;
  logic and_338_s19_q;
  logic and_339_s19_q;
  logic [77:0] census_memory_rdata_s19_q;
  logic [8:0] grey_s19_q;
  logic equal_342_s19_q;
  logic [8:0] total_s19_q;
  logic [8:0] grey_2_s19_q;
  logic [8:0] total_2_s19_q;
  logic whole_2_s19_q;
  logic select_353_s19_q;
  logic equal_354_s19_q;
  logic not_355_s19_q;
  logic equal_356_s19_q;
  logic less_357_s19_q;
  logic not_358_s19_q;
  logic equal_388_s19_q;
  logic drew_s19_q;
  logic [6:0] x_s19_2_q;
  logic not_499_s19_q;
  logic [7:0] best_left_rdata_s19_q;
  logic equal_504_s19_q;
  logic select_800_s19_q;
  logic less_806_s19_q;
  logic less_807_s19_q;
  logic or_809_s19_q;
  logic [7:0] select_813_s19_q;
  logic [5:0] select_817_s19_q;
  logic equal_822_s19_q;
  logic rise_s19_q;
  logic [1:0] sum_834_s19_q;
  logic [7:0] twice_s19_q;
  logic [8:0] size_s19_q;
  logic and_866_s19_q;
  logic or_885_s19_q;
  logic or_888_s19_q;
  logic or_891_s19_q;
  logic equal_898_s19_q;
  logic equal_899_s19_q;
  logic and_909_s19_q;
  logic and_920_s19_q;
  logic and_930_s19_q;
  logic and_932_s19_q;
  logic and_939_s19_q;
  logic and_940_s19_q;
  logic [11:0] seen_columns_rdata_s19_q;
  logic select_949_s19_q;
  logic or_993_s19_q;
  logic or_996_s19_q;
  logic or_999_s19_q;
  logic and_1046_s19_q;
  logic equal_1163_s19_q;
  logic equal_1214_s19_q;
  logic not_1260_s19_q;
  logic and_1352_s19_q;
  logic and_1422_s19_q;
  logic and_1432_s19_q;
  logic less_1434_s19_q;
  logic equal_1435_s19_q;
  logic equal_1436_s19_q;
  logic equal_1437_s19_q;
  logic [7:0] residual_s19_q;
  logic and_1518_s19_q;
  logic and_1527_s19_q;
  logic and_1536_s19_q;
  logic and_1544_s19_q;
  logic [12:0] difference_1555_s19_q;
  logic equal_1864_s19_q;
  logic and_2142_s19_q;
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
      select_303_s19_q <= select_303_s18_q;
      and_338_s19_q <= and_338_s18_q;
      and_339_s19_q <= and_339_s18_q;
      census_memory_rdata_s19_q <= census_memory_rdata_q;
      grey_s19_q <= grey;
      equal_342_s19_q <= equal_342_s18_q;
      total_s19_q <= total[10:2];
      grey_2_s19_q <= grey_2;
      total_2_s19_q <= total_2[10:2];
      whole_2_s19_q <= whole_2;
      select_353_s19_q <= select_353;
      equal_354_s19_q <= equal_354_s18_q;
      not_355_s19_q <= not_355_s18_q;
      equal_356_s19_q <= equal_356_s18_q;
      less_357_s19_q <= less_357_s18_q;
      not_358_s19_q <= not_358_s18_q;
      equal_388_s19_q <= equal_388_s18_q;
      drew_s19_q <= drew_s18_q;
      x_s19_2_q <= x_s18_2_q;
      not_499_s19_q <= not_499_s18_q;
      best_left_rdata_s19_q <= best_left_rdata_s18_q;
      equal_504_s19_q <= equal_504_s18_q;
      select_800_s19_q <= select_800_s18_q;
      less_806_s19_q <= less_806_s18_q;
      less_807_s19_q <= less_807_s18_q;
      or_809_s19_q <= or_809_s18_q;
      select_813_s19_q <= select_813_s18_q;
      select_817_s19_q <= select_817_s18_q;
      equal_822_s19_q <= equal_822_s18_q;
      rise_s19_q <= rise_s18_q;
      sum_834_s19_q <= sum_834_s18_q;
      twice_s19_q <= twice;
      size_s19_q <= size;
      and_866_s19_q <= and_866_s18_q;
      or_885_s19_q <= or_885_s18_q;
      or_888_s19_q <= or_888_s18_q;
      or_891_s19_q <= or_891_s18_q;
      equal_898_s19_q <= equal_898_s18_q;
      equal_899_s19_q <= equal_899_s18_q;
      and_909_s19_q <= and_909_s18_q;
      and_920_s19_q <= and_920;
      and_930_s19_q <= and_930;
      and_932_s19_q <= not_358_s18_q & (left_rdata_s18_q & and_930);
      and_939_s19_q <= and_939_s18_q;
      and_940_s19_q <= and_940_s18_q;
      seen_columns_rdata_s19_q <= seen_columns_rdata_q;
      select_949_s19_q <= select_949_s18_q;
      or_993_s19_q <= or_993_s18_q;
      or_996_s19_q <= or_996_s18_q;
      or_999_s19_q <= or_999_s18_q;
      and_1046_s19_q <= and_1046_s18_q;
      equal_1163_s19_q <= equal_1163_s18_q;
      equal_1214_s19_q <= equal_1214_s18_q;
      not_1260_s19_q <= not_1260_s18_q;
      and_1352_s19_q <= and_1352;
      and_1422_s19_q <= left_rdata_s18_q & and_1348_s18_q;
      and_1432_s19_q <= and_1432;
      less_1434_s19_q <= less_1434_s18_q;
      equal_1435_s19_q <= equal_1435;
      equal_1436_s19_q <= equal_1436;
      equal_1437_s19_q <= equal_1437;
      residual_s19_q <= residual[7:0];
      and_1518_s19_q <= drew_s18_q & and_1517;
      and_1527_s19_q <= drew_s18_q & and_1526;
      and_1536_s19_q <= not_499_s18_q & and_1535;
      and_1544_s19_q <= not_355_s18_q & and_1543;
      difference_1555_s19_q <= 13'h0 - {residual[11], residual};
      equal_1864_s19_q <= equal_1864_s18_q;
      and_2142_s19_q <= and_2142_s18_q;
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
  logic census_columns_values_0_cell_2_of_skin_q;
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
  logic census_columns_values_1_cell_2_of_skin_q;
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
  logic [11:0] registration_counts_measured_0_q;
  logic [11:0] registration_counts_measured_1_q;
  logic [11:0] registration_counts_measured_2_q;
  logic [11:0] registration_counts_measured_3_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
  logic segment_started_q;
  // hls/stages/census.hpp:214
  logic less_362;
  assign less_362 = census_memory_rdata_s19_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_363;
  assign less_363 = census_memory_rdata_s19_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_364;
  assign less_364 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_365;
  assign less_365 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_366;
  assign less_366 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_367;
  assign less_367 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_368;
  assign less_368 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_369;
  assign less_369 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_370;
  assign less_370 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_371;
  assign less_371 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_372;
  assign less_372 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_373;
  assign less_373 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_374;
  assign less_374 = census_memory_rdata_s19_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_375;
  assign less_375 = census_memory_rdata_s19_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_376;
  assign less_376 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_377;
  assign less_377 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_378;
  assign less_378 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_379;
  assign less_379 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_380;
  assign less_380 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_381;
  assign less_381 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_382;
  assign less_382 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_383;
  assign less_383 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_384;
  assign less_384 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_385;
  assign less_385 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:241
  logic equal_386;
  assign equal_386 = select_303_s19_q == 7'h0;
  logic [3:0] select_389;
  assign select_389 = equal_388_s19_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:242
  logic [4:0] select_390;
  assign select_390 = equal_386 ? {select_389, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_391;
  assign select_391 = equal_386 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:206
  logic and_394;
  assign and_394 = census_memory_rdata_s19_q[38] & (census_memory_rdata_s19_q[18] & whole_2_s19_q);
  logic and_396;
  assign and_396 = census_memory_rdata_s19_q[77] & (census_memory_rdata_s19_q[58] & and_394);
  // hls/stages/census.hpp:190
  logic [9:0] difference_419;
  assign difference_419 = {1'b0, total_s19_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_422;
  assign difference_422 = {1'b0, census_memory_rdata_s19_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_426;
  assign difference_426 = {1'b0, census_memory_rdata_s19_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_430;
  assign difference_430 = {1'b0, census_memory_rdata_s19_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_434;
  assign difference_434 = {1'b0, census_memory_rdata_s19_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/registration.hpp:28
  logic [8:0] select_845;
  assign select_845 = ({twice_s19_q, 1'b0} < size_s19_q) ? {twice_s19_q, 1'b0} : size_s19_q;
  // hls/stages/agreement.hpp:165
  logic textured;
  assign textured = not_358_s19_q & and_909_s19_q;
  // hls/stages/agreement.hpp:464
  logic [6:0] select_911;
  assign select_911 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:165
  logic explained;
  assign explained = not_358_s19_q & and_920_s19_q;
  // hls/stages/agreement.hpp:464
  logic [6:0] select_922;
  assign select_922 = segment_started_q ? segment_explained_q : 7'h0;
  logic [6:0] select_933;
  assign select_933 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:165
  logic near;
  assign near = not_358_s19_q & and_930_s19_q;
  // hls/stages/agreement.hpp:516
  logic and_977;
  assign and_977 = seen_columns_rdata_s19_q[3] & not_358_s19_q;
  logic and_978;
  assign and_978 = seen_columns_rdata_s19_q[0] & not_358_s19_q;
  logic and_1010;
  assign and_1010 = seen_columns_rdata_s19_q[4] & not_358_s19_q;
  logic and_1011;
  assign and_1011 = seen_columns_rdata_s19_q[1] & not_358_s19_q;
  logic and_1024;
  assign and_1024 = seen_columns_rdata_s19_q[5] & not_358_s19_q;
  logic and_1025;
  assign and_1025 = seen_columns_rdata_s19_q[2] & not_358_s19_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1065;
  assign sum_1065 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s19_q};
  logic [9:0] sum_1072;
  assign sum_1072 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s19_q};
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1081;
  assign select_1081 = and_339_s19_q ? total_s19_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1082;
  assign select_1082 = and_339_s19_q ? total_2_s19_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1084;
  assign select_1084 = and_339_s19_q ? census_memory_rdata_s19_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1085;
  assign select_1085 = and_339_s19_q ? census_memory_rdata_s19_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1086;
  assign select_1086 = and_339_s19_q ? census_memory_rdata_s19_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1087;
  assign select_1087 = and_339_s19_q ? census_memory_rdata_s19_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1088;
  assign select_1088 = and_339_s19_q ? census_memory_rdata_s19_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1089;
  assign select_1089 = and_339_s19_q ? census_memory_rdata_s19_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1090;
  assign select_1090 = and_339_s19_q ? census_memory_rdata_s19_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1091;
  assign select_1091 = and_339_s19_q ? census_memory_rdata_s19_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1092;
  assign select_1092 = and_339_s19_q ? census_memory_rdata_s19_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1093;
  assign select_1093 = and_339_s19_q ? census_memory_rdata_s19_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1094;
  assign select_1094 = and_339_s19_q ? census_memory_rdata_s19_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1095;
  assign select_1095 = and_339_s19_q ? census_memory_rdata_s19_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1096;
  assign select_1096 = and_339_s19_q ? census_memory_rdata_s19_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1097;
  assign select_1097 = and_339_s19_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1098;
  assign select_1098 = and_339_s19_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1100;
  assign select_1100 = and_339_s19_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1101;
  assign select_1101 = and_339_s19_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1103;
  assign select_1103 = and_339_s19_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1104;
  assign select_1104 = and_339_s19_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1106;
  assign select_1106 = and_339_s19_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1107;
  assign select_1107 = and_339_s19_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1108;
  assign select_1108 = and_339_s19_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1110;
  assign select_1110 = and_339_s19_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1111;
  assign select_1111 = and_339_s19_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1113;
  assign select_1113 = and_339_s19_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1114;
  assign select_1114 = and_339_s19_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1116;
  assign select_1116 = and_339_s19_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1117;
  assign select_1117 = and_339_s19_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1119;
  assign select_1119 = and_339_s19_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1120;
  assign select_1120 = and_339_s19_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1122;
  assign select_1122 = and_339_s19_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1123;
  assign select_1123 = and_339_s19_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1125;
  assign select_1125 = and_339_s19_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1126;
  assign select_1126 = and_339_s19_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1129;
  assign select_1129 = and_339_s19_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1130;
  assign select_1130 = and_339_s19_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1133;
  assign select_1133 = and_339_s19_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1134;
  assign select_1134 = and_339_s19_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1138;
  assign difference_1138 = {1'b0, total_2_s19_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_1141;
  assign difference_1141 = {1'b0, census_memory_rdata_s19_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_1145;
  assign difference_1145 = {1'b0, census_memory_rdata_s19_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_1149;
  assign difference_1149 = {1'b0, census_memory_rdata_s19_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_1153;
  assign difference_1153 = {1'b0, census_memory_rdata_s19_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1182;
  assign difference_1182 = {1'b0, total_s19_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_1193;
  assign difference_1193 = {1'b0, total_2_s19_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:176
  logic and_1347;
  assign and_1347 = and_339_s19_q & (equal_388_s19_q & equal_1214_s19_q);
  // hls/stages/agreement.hpp:299
  logic and_1357;
  assign and_1357 = not_355_s19_q & (not_499_s19_q & (drew_s19_q & textured));
  logic and_1362;
  assign and_1362 = not_355_s19_q & (not_499_s19_q & (drew_s19_q & explained));
  logic and_1367;
  assign and_1367 = not_355_s19_q & (not_499_s19_q & (drew_s19_q & and_932_s19_q));
  // hls/stages/agreement.hpp:165
  logic [8:0] select_1397;
  assign select_1397 = less_357_s19_q ? 9'h0 : (and_909_s19_q ? {and_920_s19_q, cfg_explained_limit_i} : 9'h0);
  // hls/stages/agreement.hpp:299
  logic [8:0] select_1400;
  assign select_1400 = equal_354_s19_q ? 9'h0 : (equal_356_s19_q ? 9'h0 : (drew_s19_q ? select_1397 : 9'h0));
  // hls/stages/agreement.hpp:511
  logic [9:0] select_1424;
  assign select_1424 = and_1422_s19_q ? ({1'b0, and_930_s19_q, 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:299
  logic [9:0] select_1427;
  assign select_1427 = equal_356_s19_q ? 10'h0 : (drew_s19_q ? (less_357_s19_q ? 10'h0 : select_1424) : 10'h0);
  logic and_1520;
  assign and_1520 = not_355_s19_q & (not_499_s19_q & and_1518_s19_q);
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1522;
  assign select_1522 = and_1347 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1520});
  // hls/stages/agreement.hpp:299
  logic and_1529;
  assign and_1529 = not_355_s19_q & (not_499_s19_q & and_1527_s19_q);
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1531;
  assign select_1531 = and_1347 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1529});
  // hls/stages/agreement.hpp:299
  logic and_1537;
  assign and_1537 = not_355_s19_q & and_1536_s19_q;
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1539;
  assign select_1539 = and_1347 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1537});
  logic [11:0] select_1546;
  assign select_1546 = and_1347 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1544_s19_q});
  // hls/stages/registration.hpp:146
  logic less_1556;
  assign less_1556 = $signed(difference_1555_s19_q) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:165
  logic and_1557;
  assign and_1557 = and_1432_s19_q & less_1556;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1559;
  assign select_1559 = drew_s19_q ? (less_357_s19_q ? 2'h0 : {and_1557, and_1432_s19_q}) : 2'h0;
  // hls/stages/registration.hpp:80
  logic not_1564;
  assign not_1564 = ~less_1434_s19_q;
  // hls/stages/registration.hpp:146
  logic less_1639;
  assign less_1639 = $signed(difference_1555_s19_q) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1640;
  assign and_1640 = not_1564 & less_1639;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1642;
  assign select_1642 = less_357_s19_q ? 2'h0 : (and_1432_s19_q ? {and_1640, not_1564} : 2'h0);
  // hls/stages/registration.hpp:79
  logic and_1656;
  assign and_1656 = less_1434_s19_q & less_1639;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1658;
  assign select_1658 = less_357_s19_q ? 2'h0 : (and_1432_s19_q ? {and_1656, less_1434_s19_q} : 2'h0);
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_1966;
  assign sum_1966 = {1'b0, upper} + {1'b0, lower};
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = select_303_s19_q;
  logic census_memory_we;
  assign census_memory_we = s19_en & and_339_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s19_q[58:40], census_memory_rdata_s19_q[38:0], select_353_s19_q, whole_2_s19_q, total_2_s19_q, total_s19_q};
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

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s19_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s19_en & and_940_s19_q;
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
      registration_counts_measured_0_q <= 12'h0;
      registration_counts_measured_1_q <= 12'h0;
      registration_counts_measured_2_q <= 12'h0;
      registration_counts_measured_3_q <= 12'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      segment_started_q <= 1'b0;
    end else if (s19_en) begin
      census_filled_q <= and_339_s19_q ? {select_391[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_339_s19_q ? select_390 : rows_passed_above_q;
      registration_counts_measured_0_q <= select_1522;
      registration_counts_measured_1_q <= select_1531;
      registration_counts_measured_2_q <= select_1539;
      registration_counts_measured_3_q <= select_1546;
      segment_textured_q <= select_911 + {6'h0, and_1357};
      segment_explained_q <= select_922 + {6'h0, and_1362};
      segment_nearer_q <= select_933 + {6'h0, and_1367};
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
    census_columns_values_0_cell_2_of_skin_q = 1'b0;
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
    census_columns_values_1_cell_2_of_skin_q = 1'b0;
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
      averager_quarter_1_0_q <= and_338_s19_q ? grey_s19_q : averager_quarter_1_0_q;
      averager_quarter_1_1_q <= and_338_s19_q ? grey_2_s19_q : averager_quarter_1_1_q;
      averager_quarter_2_0_q <= and_338_s19_q ? averager_quarter_1_0_q : averager_quarter_2_0_q;
      averager_quarter_2_1_q <= and_338_s19_q ? averager_quarter_1_1_q : averager_quarter_2_1_q;
      census_columns_values_0_cell_0_left_q <= select_1081;
      census_columns_values_0_cell_0_right_q <= select_1082;
      census_columns_values_0_cell_1_left_q <= select_1084;
      census_columns_values_0_cell_1_right_q <= select_1085;
      census_columns_values_0_cell_1_mask_q <= select_1086;
      census_columns_values_0_cell_2_left_q <= select_1087;
      census_columns_values_0_cell_2_right_q <= select_1088;
      census_columns_values_0_cell_2_mask_q <= select_1089;
      census_columns_values_0_cell_2_of_skin_q <= select_1090;
      census_columns_values_0_cell_3_left_q <= select_1091;
      census_columns_values_0_cell_3_right_q <= select_1092;
      census_columns_values_0_cell_3_mask_q <= select_1093;
      census_columns_values_0_cell_4_left_q <= select_1094;
      census_columns_values_0_cell_4_right_q <= select_1095;
      census_columns_values_0_cell_4_mask_q <= select_1096;
      census_columns_values_1_cell_0_left_q <= select_1097;
      census_columns_values_1_cell_0_right_q <= select_1098;
      census_columns_values_1_cell_1_left_q <= select_1100;
      census_columns_values_1_cell_1_right_q <= select_1101;
      census_columns_values_1_cell_2_left_q <= select_1103;
      census_columns_values_1_cell_2_right_q <= select_1104;
      census_columns_values_1_cell_2_of_skin_q <= select_1106;
      census_columns_values_1_cell_3_left_q <= select_1107;
      census_columns_values_1_cell_3_right_q <= select_1108;
      census_columns_values_1_cell_4_left_q <= select_1110;
      census_columns_values_1_cell_4_right_q <= select_1111;
      census_columns_values_2_cell_0_left_q <= select_1113;
      census_columns_values_2_cell_0_right_q <= select_1114;
      census_columns_values_2_cell_1_left_q <= select_1116;
      census_columns_values_2_cell_1_right_q <= select_1117;
      census_columns_values_2_cell_2_left_q <= select_1119;
      census_columns_values_2_cell_2_right_q <= select_1120;
      census_columns_values_2_cell_3_left_q <= select_1122;
      census_columns_values_2_cell_3_right_q <= select_1123;
      census_columns_values_2_cell_4_left_q <= select_1125;
      census_columns_values_2_cell_4_right_q <= select_1126;
      census_columns_values_3_cell_1_left_q <= select_1129;
      census_columns_values_3_cell_1_right_q <= select_1130;
      census_columns_values_3_cell_3_left_q <= select_1133;
      census_columns_values_3_cell_3_right_q <= select_1134;
      sharpness_last_mean_0_q <= and_339_s19_q ? total_s19_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_339_s19_q ? total_2_s19_q : sharpness_last_mean_1_q;
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
  logic census_columns_values_1_cell_2_of_skin_s20_q;
  logic [7:0] x_s20_q;
  logic age_s20_q;
  logic lower_half_s20_q;
  logic [11:0] registration_counts_measured_0_s20_q;
  logic [11:0] registration_counts_measured_1_s20_q;
  logic [11:0] registration_counts_measured_2_s20_q;
  logic [11:0] registration_counts_measured_3_s20_q;
  logic [2:0] region_row_s20_q;
  logic region_fresh_s20_q;
  logic [6:0] select_303_s20_q;
  logic and_338_s20_q;
  logic and_339_s20_q;
  logic equal_342_s20_q;
  logic whole_2_s20_q;
  logic equal_354_s20_q;
  logic not_355_s20_q;
  logic equal_356_s20_q;
  logic less_357_s20_q;
  logic not_358_s20_q;
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
  logic less_374_s20_q;
  logic less_375_s20_q;
  logic less_376_s20_q;
  logic less_377_s20_q;
  logic less_378_s20_q;
  logic less_379_s20_q;
  logic less_380_s20_q;
  logic less_381_s20_q;
  logic less_382_s20_q;
  logic less_383_s20_q;
  logic less_384_s20_q;
  logic less_385_s20_q;
  logic and_392_s20_q;
  logic and_396_s20_q;
  logic difference_419_s20_q;
  logic [8:0] xor_420_s20_q;
  logic difference_422_s20_q;
  logic [8:0] xor_423_s20_q;
  logic difference_426_s20_q;
  logic [8:0] xor_427_s20_q;
  logic difference_430_s20_q;
  logic [8:0] xor_431_s20_q;
  logic difference_434_s20_q;
  logic [8:0] xor_435_s20_q;
  logic drew_s20_q;
  logic [6:0] x_s20_2_q;
  logic not_499_s20_q;
  logic [7:0] best_left_rdata_s20_q;
  logic equal_504_s20_q;
  logic select_800_s20_q;
  logic less_806_s20_q;
  logic less_807_s20_q;
  logic or_809_s20_q;
  logic [7:0] select_813_s20_q;
  logic [5:0] select_817_s20_q;
  logic equal_822_s20_q;
  logic rise_s20_q;
  logic [1:0] sum_834_s20_q;
  logic [7:0] twice_s20_q;
  logic [8:0] select_845_s20_q;
  logic and_866_s20_q;
  logic or_885_s20_q;
  logic or_888_s20_q;
  logic or_891_s20_q;
  logic equal_898_s20_q;
  logic equal_899_s20_q;
  logic [35:0] regions_rdata_s20_q;
  logic and_909_s20_q;
  logic [6:0] sum_912_s20_q;
  logic [6:0] sum_923_s20_q;
  logic [6:0] sum_934_s20_q;
  logic and_939_s20_q;
  logic select_949_s20_q;
  logic [3:0] select_975_s20_q;
  logic and_976_s20_q;
  logic and_977_s20_q;
  logic [1:0] sum_980_s20_q;
  logic or_993_s20_q;
  logic or_996_s20_q;
  logic or_999_s20_q;
  logic and_1009_s20_q;
  logic [1:0] sum_1013_s20_q;
  logic [1:0] sum_1027_s20_q;
  logic and_1046_s20_q;
  logic sum_1065_s20_q;
  logic [9:0] difference_1066_s20_q;
  logic sum_1072_s20_q;
  logic [9:0] difference_1073_s20_q;
  logic difference_1138_s20_q;
  logic [8:0] xor_1139_s20_q;
  logic difference_1141_s20_q;
  logic [8:0] xor_1142_s20_q;
  logic difference_1145_s20_q;
  logic [8:0] xor_1146_s20_q;
  logic difference_1149_s20_q;
  logic [8:0] xor_1150_s20_q;
  logic difference_1153_s20_q;
  logic [8:0] xor_1154_s20_q;
  logic equal_1163_s20_q;
  logic difference_1182_s20_q;
  logic [8:0] xor_1183_s20_q;
  logic difference_1193_s20_q;
  logic [8:0] xor_1194_s20_q;
  logic equal_1214_s20_q;
  logic not_1260_s20_q;
  logic and_1347_s20_q;
  logic and_1352_s20_q;
  logic and_1357_s20_q;
  logic and_1362_s20_q;
  logic and_1367_s20_q;
  logic [8:0] select_1400_s20_q;
  logic [9:0] select_1427_s20_q;
  logic and_1432_s20_q;
  logic less_1434_s20_q;
  logic equal_1435_s20_q;
  logic equal_1436_s20_q;
  logic equal_1437_s20_q;
  logic [7:0] residual_s20_q;
  logic less_1556_s20_q;
  logic [1:0] select_1560_s20_q;
  logic not_1564_s20_q;
  logic less_1639_s20_q;
  logic [1:0] select_1643_s20_q;
  logic [1:0] select_1659_s20_q;
  logic equal_1864_s20_q;
  logic [10:0] sum_1966_s20_q;
  logic less_1970_s20_q;
  logic less_1981_s20_q;
  logic less_1993_s20_q;
  logic and_2142_s20_q;
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
      census_columns_values_1_cell_2_of_skin_s20_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s20_q <= x_s19_q;
      age_s20_q <= age_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      registration_counts_measured_0_s20_q <= registration_counts_measured_0_q;
      registration_counts_measured_1_s20_q <= registration_counts_measured_1_q;
      registration_counts_measured_2_s20_q <= registration_counts_measured_2_q;
      registration_counts_measured_3_s20_q <= registration_counts_measured_3_q;
      region_row_s20_q <= region_row_s19_q;
      region_fresh_s20_q <= region_fresh_s19_q;
      select_303_s20_q <= select_303_s19_q;
      and_338_s20_q <= and_338_s19_q;
      and_339_s20_q <= and_339_s19_q;
      equal_342_s20_q <= equal_342_s19_q;
      whole_2_s20_q <= whole_2_s19_q;
      equal_354_s20_q <= equal_354_s19_q;
      not_355_s20_q <= not_355_s19_q;
      equal_356_s20_q <= equal_356_s19_q;
      less_357_s20_q <= less_357_s19_q;
      not_358_s20_q <= not_358_s19_q;
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
      less_374_s20_q <= less_374;
      less_375_s20_q <= less_375;
      less_376_s20_q <= less_376;
      less_377_s20_q <= less_377;
      less_378_s20_q <= less_378;
      less_379_s20_q <= less_379;
      less_380_s20_q <= less_380;
      less_381_s20_q <= less_381;
      less_382_s20_q <= less_382;
      less_383_s20_q <= less_383;
      less_384_s20_q <= less_384;
      less_385_s20_q <= less_385;
      and_392_s20_q <= select_390[4] & select_391[3];
      and_396_s20_q <= and_396;
      difference_419_s20_q <= difference_419[9];
      xor_420_s20_q <= difference_419[8:0] ^ {9{difference_419[9]}};
      difference_422_s20_q <= difference_422[9];
      xor_423_s20_q <= difference_422[8:0] ^ {9{difference_422[9]}};
      difference_426_s20_q <= difference_426[9];
      xor_427_s20_q <= difference_426[8:0] ^ {9{difference_426[9]}};
      difference_430_s20_q <= difference_430[9];
      xor_431_s20_q <= difference_430[8:0] ^ {9{difference_430[9]}};
      difference_434_s20_q <= difference_434[9];
      xor_435_s20_q <= difference_434[8:0] ^ {9{difference_434[9]}};
      drew_s20_q <= drew_s19_q;
      x_s20_2_q <= x_s19_2_q;
      not_499_s20_q <= not_499_s19_q;
      best_left_rdata_s20_q <= best_left_rdata_s19_q;
      equal_504_s20_q <= equal_504_s19_q;
      select_800_s20_q <= select_800_s19_q;
      less_806_s20_q <= less_806_s19_q;
      less_807_s20_q <= less_807_s19_q;
      or_809_s20_q <= or_809_s19_q;
      select_813_s20_q <= select_813_s19_q;
      select_817_s20_q <= select_817_s19_q;
      equal_822_s20_q <= equal_822_s19_q;
      rise_s20_q <= rise_s19_q;
      sum_834_s20_q <= sum_834_s19_q;
      twice_s20_q <= twice_s19_q;
      select_845_s20_q <= select_845;
      and_866_s20_q <= and_866_s19_q;
      or_885_s20_q <= or_885_s19_q;
      or_888_s20_q <= or_888_s19_q;
      or_891_s20_q <= or_891_s19_q;
      equal_898_s20_q <= equal_898_s19_q;
      equal_899_s20_q <= equal_899_s19_q;
      regions_rdata_s20_q <= regions_rdata_q;
      and_909_s20_q <= and_909_s19_q;
      sum_912_s20_q <= {6'h0, textured} + select_911;
      sum_923_s20_q <= {6'h0, explained} + select_922;
      sum_934_s20_q <= {6'h0, and_932_s19_q} + select_933;
      and_939_s20_q <= and_939_s19_q;
      select_949_s20_q <= select_949_s19_q;
      select_975_s20_q <= less_357_s19_q ? 4'h0 : seen_columns_rdata_s19_q[11:8];
      and_976_s20_q <= seen_columns_rdata_s19_q[6] & not_358_s19_q;
      and_977_s20_q <= and_977;
      sum_980_s20_q <= {1'b0, and_977} + ({1'b0, textured} + {1'b0, and_978});
      or_993_s20_q <= or_993_s19_q;
      or_996_s20_q <= or_996_s19_q;
      or_999_s20_q <= or_999_s19_q;
      and_1009_s20_q <= seen_columns_rdata_s19_q[7] & not_358_s19_q;
      sum_1013_s20_q <= {1'b0, and_1010} + ({1'b0, explained} + {1'b0, and_1011});
      sum_1027_s20_q <= {1'b0, and_1024} + ({1'b0, near} + {1'b0, and_1025});
      and_1046_s20_q <= and_1046_s19_q;
      sum_1065_s20_q <= sum_1065[0];
      difference_1066_s20_q <= {1'b0, sum_1065[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_1072_s20_q <= sum_1072[0];
      difference_1073_s20_q <= {1'b0, sum_1072[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_1138_s20_q <= difference_1138[9];
      xor_1139_s20_q <= difference_1138[8:0] ^ {9{difference_1138[9]}};
      difference_1141_s20_q <= difference_1141[9];
      xor_1142_s20_q <= difference_1141[8:0] ^ {9{difference_1141[9]}};
      difference_1145_s20_q <= difference_1145[9];
      xor_1146_s20_q <= difference_1145[8:0] ^ {9{difference_1145[9]}};
      difference_1149_s20_q <= difference_1149[9];
      xor_1150_s20_q <= difference_1149[8:0] ^ {9{difference_1149[9]}};
      difference_1153_s20_q <= difference_1153[9];
      xor_1154_s20_q <= difference_1153[8:0] ^ {9{difference_1153[9]}};
      equal_1163_s20_q <= equal_1163_s19_q;
      difference_1182_s20_q <= difference_1182[9];
      xor_1183_s20_q <= difference_1182[8:0] ^ {9{difference_1182[9]}};
      difference_1193_s20_q <= difference_1193[9];
      xor_1194_s20_q <= difference_1193[8:0] ^ {9{difference_1193[9]}};
      equal_1214_s20_q <= equal_1214_s19_q;
      not_1260_s20_q <= not_1260_s19_q;
      and_1347_s20_q <= and_1347;
      and_1352_s20_q <= and_1352_s19_q;
      and_1357_s20_q <= and_1357;
      and_1362_s20_q <= and_1362;
      and_1367_s20_q <= and_1367;
      select_1400_s20_q <= select_1400;
      select_1427_s20_q <= select_1427;
      and_1432_s20_q <= and_1432_s19_q;
      less_1434_s20_q <= less_1434_s19_q;
      equal_1435_s20_q <= equal_1435_s19_q;
      equal_1436_s20_q <= equal_1436_s19_q;
      equal_1437_s20_q <= equal_1437_s19_q;
      residual_s20_q <= residual_s19_q;
      less_1556_s20_q <= less_1556;
      select_1560_s20_q <= equal_356_s19_q ? 2'h0 : select_1559;
      not_1564_s20_q <= not_1564;
      less_1639_s20_q <= less_1639;
      select_1643_s20_q <= drew_s19_q ? select_1642 : 2'h0;
      select_1659_s20_q <= drew_s19_q ? select_1658 : 2'h0;
      equal_1864_s20_q <= equal_1864_s19_q;
      sum_1966_s20_q <= sum_1966[13:3];
      less_1970_s20_q <= 11'he < left[12:2];
      less_1981_s20_q <= 11'he < upper[12:2];
      less_1993_s20_q <= 11'he < lower[12:2];
      and_2142_s20_q <= and_2142_s19_q;
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
  logic [14:0] registration_counts_votes_0_up_q;
  logic [14:0] registration_counts_half_votes_0_up_q;
  logic [14:0] registration_counts_half_votes_1_up_q;
  logic centres_values_0_q;
  logic centres_values_1_q;
  // hls/stages/agreement.hpp:242
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_396_s20_q;
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
  // hls/stages/census.hpp:190
  logic [9:0] sum_421;
  assign sum_421 = {9'h0, difference_419_s20_q} + {1'b0, xor_420_s20_q};
  logic [9:0] sum_424;
  assign sum_424 = {9'h0, difference_422_s20_q} + {1'b0, xor_423_s20_q};
  // hls/stages/agreement.hpp:549
  logic [11:0] sum_914;
  assign sum_914 = {5'h0, sum_912_s20_q} + (region_fresh_s20_q ? 12'h0 : regions_rdata_s20_q[11:0]);
  // hls/stages/agreement.hpp:550
  logic [11:0] sum_925;
  assign sum_925 = {5'h0, sum_923_s20_q} + (region_fresh_s20_q ? 12'h0 : regions_rdata_s20_q[23:12]);
  // hls/stages/agreement.hpp:551
  logic [11:0] sum_936;
  assign sum_936 = {5'h0, sum_934_s20_q} + (region_fresh_s20_q ? 12'h0 : regions_rdata_s20_q[35:24]);
  // hls/stages/agreement.hpp:569
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, select_975_s20_q[1]} + ({2'h0, and_976_s20_q} + {1'b0, sum_980_s20_q});
  // hls/stages/agreement.hpp:570
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, select_975_s20_q[2]} + ({2'h0, and_1009_s20_q} + {1'b0, sum_1013_s20_q});
  // hls/stages/agreement.hpp:571
  logic [2:0] near_2;
  assign near_2 = {2'h0, select_975_s20_q[3]} + ({2'h0, select_975_s20_q[0]} + {1'b0, sum_1027_s20_q});
  // hls/stages/census.hpp:129
  logic [9:0] xor_1067;
  assign xor_1067 = {difference_1066_s20_q[8:0], sum_1065_s20_q} ^ {10{difference_1066_s20_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1066_s20_q[9]} + {1'b0, xor_1067};
  logic [9:0] xor_1074;
  assign xor_1074 = {difference_1073_s20_q[8:0], sum_1072_s20_q} ^ {10{difference_1073_s20_q[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1073_s20_q[9]} + {1'b0, xor_1074};
  // hls/stages/agreement.hpp:176
  logic select_1083;
  assign select_1083 = and_339_s20_q ? whole_2_s20_q : census_columns_values_0_cell_0_mask_q;
  logic select_1099;
  assign select_1099 = and_339_s20_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_1102;
  assign select_1102 = and_339_s20_q ? census_columns_values_0_cell_1_mask_s20_q : census_columns_values_1_cell_1_mask_q;
  logic select_1105;
  assign select_1105 = and_339_s20_q ? census_columns_values_0_cell_2_mask_s20_q : census_columns_values_1_cell_2_mask_q;
  logic select_1109;
  assign select_1109 = and_339_s20_q ? census_columns_values_0_cell_3_mask_s20_q : census_columns_values_1_cell_3_mask_q;
  logic select_1112;
  assign select_1112 = and_339_s20_q ? census_columns_values_0_cell_4_mask_s20_q : census_columns_values_1_cell_4_mask_q;
  logic select_1115;
  assign select_1115 = and_339_s20_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_1118;
  assign select_1118 = and_339_s20_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] sum_1140;
  assign sum_1140 = {9'h0, difference_1138_s20_q} + {1'b0, xor_1139_s20_q};
  logic [9:0] sum_1143;
  assign sum_1143 = {9'h0, difference_1141_s20_q} + {1'b0, xor_1142_s20_q};
  // hls/stages/census.hpp:273
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1182_s20_q} + xor_1183_s20_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1193_s20_q} + xor_1194_s20_q;
  // hls/stages/agreement.hpp:608
  logic less_1380;
  assign less_1380 = region_row_s20_q < x_s20_q[5:3];
  logic [11:0] select_1384;
  assign select_1384 = less_1380 ? 12'h0 : regions_rdata_s20_q[23:12];
  // hls/stages/agreement.hpp:480
  logic [23:0] sum_1401;
  assign sum_1401 = counts_too_little_explained_q + {{15{select_1400_s20_q[8]}}, select_1400_s20_q};
  // hls/stages/agreement.hpp:299
  logic [9:0] select_1428;
  assign select_1428 = equal_354_s20_q ? 10'h0 : select_1427_s20_q;
  // hls/stages/agreement.hpp:484
  logic [23:0] select_1430;
  assign select_1430 = and_1347_s20_q ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1428[9]}}, select_1428});
  // hls/stages/registration.hpp:146
  logic less_1547;
  assign less_1547 = $signed(residual_s20_q) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1561;
  assign select_1561 = equal_354_s20_q ? 2'h0 : select_1560_s20_q;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1562;
  assign sum_1562 = registration_counts_votes_0_up_q + {{13{select_1561[1]}}, select_1561};
  // hls/stages/registration.hpp:80
  logic not_1597;
  assign not_1597 = ~lower_half_s20_q;
  // hls/stages/agreement.hpp:165
  logic and_1598;
  assign and_1598 = less_1547 & not_1597;
  logic [1:0] select_1600;
  assign select_1600 = less_357_s20_q ? 2'h0 : (and_1432_s20_q ? {and_1598, not_1597} : 2'h0);
  logic and_1606;
  assign and_1606 = less_1556_s20_q & not_1597;
  logic [1:0] select_1608;
  assign select_1608 = less_357_s20_q ? 2'h0 : (and_1432_s20_q ? {and_1606, not_1597} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1611;
  assign select_1611 = equal_354_s20_q ? 2'h0 : (equal_356_s20_q ? 2'h0 : (drew_s20_q ? select_1608 : 2'h0));
  // hls/stages/agreement.hpp:165
  logic and_1614;
  assign and_1614 = lower_half_s20_q & less_1547;
  logic [1:0] select_1616;
  assign select_1616 = less_357_s20_q ? 2'h0 : (and_1432_s20_q ? {and_1614, lower_half_s20_q} : 2'h0);
  logic and_1622;
  assign and_1622 = lower_half_s20_q & less_1556_s20_q;
  logic [1:0] select_1624;
  assign select_1624 = less_357_s20_q ? 2'h0 : (and_1432_s20_q ? {and_1622, lower_half_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1627;
  assign select_1627 = equal_354_s20_q ? 2'h0 : (equal_356_s20_q ? 2'h0 : (drew_s20_q ? select_1624 : 2'h0));
  logic [1:0] select_1645;
  assign select_1645 = equal_354_s20_q ? 2'h0 : (equal_356_s20_q ? 2'h0 : select_1643_s20_q);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1646;
  assign sum_1646 = registration_counts_half_votes_0_up_q + {{13{select_1645[1]}}, select_1645};
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1661;
  assign select_1661 = equal_354_s20_q ? 2'h0 : (equal_356_s20_q ? 2'h0 : select_1659_s20_q);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1662;
  assign sum_1662 = registration_counts_half_votes_1_up_q + {{13{select_1661[1]}}, select_1661};
  // hls/stages/agreement.hpp:165
  logic and_1672;
  assign and_1672 = less_1639_s20_q & not_1597;
  logic [1:0] select_1674;
  assign select_1674 = less_357_s20_q ? 2'h0 : (and_1432_s20_q ? {and_1672, not_1597} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1677;
  assign select_1677 = equal_354_s20_q ? 2'h0 : (equal_356_s20_q ? 2'h0 : (drew_s20_q ? select_1674 : 2'h0));
  // hls/stages/agreement.hpp:165
  logic and_1688;
  assign and_1688 = lower_half_s20_q & less_1639_s20_q;
  logic [1:0] select_1690;
  assign select_1690 = less_357_s20_q ? 2'h0 : (and_1432_s20_q ? {and_1688, lower_half_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1693;
  assign select_1693 = equal_354_s20_q ? 2'h0 : (equal_356_s20_q ? 2'h0 : (drew_s20_q ? select_1690 : 2'h0));
  logic select_1859;
  assign select_1859 = equal_356_s20_q ? centres_values_0_q : (drew_s20_q ? and_977_s20_q : centres_values_0_q);
  logic select_1862;
  assign select_1862 = equal_356_s20_q ? centres_values_1_q : (drew_s20_q ? centres_values_0_q : centres_values_1_q);
  // hls/stages/registration.hpp:119
  logic less_1972;
  assign less_1972 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_1973;
  assign or_1973 = (~less_1970_s20_q) | less_1972;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_s20_q} + {1'b0, registration_counts_measured_3_s20_q};
  // hls/stages/registration.hpp:119
  logic less_1977;
  assign less_1977 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/agreement.hpp:619
  logic [11:0] select_2159;
  assign select_2159 = equal_899_s20_q ? 12'h0 : (less_1380 ? 12'h0 : regions_rdata_s20_q[35:24]);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_too_little_explained_q <= 24'h0;
      counts_too_much_hidden_q <= 24'h0;
      registration_counts_votes_0_up_q <= 15'h0;
      registration_counts_half_votes_0_up_q <= 15'h0;
      registration_counts_half_votes_1_up_q <= 15'h0;
      centres_values_0_q <= 1'b0;
      centres_values_1_q <= 1'b0;
    end else if (s20_en) begin
      counts_too_little_explained_q <= and_1347_s20_q ? 24'h0 : sum_1401;
      counts_too_much_hidden_q <= select_1430;
      registration_counts_votes_0_up_q <= and_1347_s20_q ? 15'h0 : sum_1562;
      registration_counts_half_votes_0_up_q <= and_1347_s20_q ? 15'h0 : sum_1646;
      registration_counts_half_votes_1_up_q <= and_1347_s20_q ? 15'h0 : sum_1662;
      centres_values_0_q <= equal_354_s20_q ? centres_values_0_q : select_1859;
      centres_values_1_q <= equal_354_s20_q ? centres_values_1_q : select_1862;
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
      census_columns_values_0_cell_0_mask_q <= select_1083;
      census_columns_values_1_cell_0_mask_q <= select_1099;
      census_columns_values_1_cell_1_mask_q <= select_1102;
      census_columns_values_1_cell_2_mask_q <= select_1105;
      census_columns_values_1_cell_3_mask_q <= select_1109;
      census_columns_values_1_cell_4_mask_q <= select_1112;
      census_columns_values_2_cell_0_mask_q <= select_1115;
      census_columns_values_2_cell_1_mask_q <= select_1118;
    end
  end

  logic [7:0] pixel_0_s21_q;
  logic [7:0] pixel_1_s21_q;
  logic saturated_s21_q;
  logic mask_s21_q;
  logic marks_first_s21_q;
  logic marks_last_s21_q;
  logic census_columns_values_1_cell_2_mask_s21_q;
  logic census_columns_values_1_cell_2_of_skin_s21_q;
  logic census_columns_values_1_cell_3_mask_s21_q;
  logic census_columns_values_1_cell_4_mask_s21_q;
  logic census_columns_values_2_cell_0_mask_s21_q;
  logic census_columns_values_2_cell_1_mask_s21_q;
  logic [7:0] x_s21_q;
  logic age_s21_q;
  logic lower_half_s21_q;
  logic [11:0] registration_counts_measured_0_s21_q;
  logic [11:0] registration_counts_measured_1_s21_q;
  logic [11:0] registration_counts_measured_2_s21_q;
  logic [11:0] registration_counts_measured_3_s21_q;
  logic [2:0] region_row_s21_q;
  logic [6:0] select_303_s21_q;
  logic and_338_s21_q;
  logic and_339_s21_q;
  logic equal_342_s21_q;
  logic whole_2_s21_q;
  logic equal_354_s21_q;
  logic not_355_s21_q;
  logic equal_356_s21_q;
  logic less_357_s21_q;
  logic not_358_s21_q;
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
  logic less_374_s21_q;
  logic less_375_s21_q;
  logic less_376_s21_q;
  logic less_377_s21_q;
  logic less_378_s21_q;
  logic less_379_s21_q;
  logic less_380_s21_q;
  logic less_381_s21_q;
  logic less_382_s21_q;
  logic less_383_s21_q;
  logic less_384_s21_q;
  logic less_385_s21_q;
  logic and_392_s21_q;
  logic whole_9_s21_q;
  logic [10:0] sum_425_s21_q;
  logic [9:0] sum_428_s21_q;
  logic [9:0] sum_432_s21_q;
  logic [9:0] sum_436_s21_q;
  logic drew_s21_q;
  logic [6:0] x_s21_2_q;
  logic not_499_s21_q;
  logic [7:0] best_left_rdata_s21_q;
  logic equal_504_s21_q;
  logic select_800_s21_q;
  logic less_806_s21_q;
  logic less_807_s21_q;
  logic or_809_s21_q;
  logic [7:0] select_813_s21_q;
  logic [5:0] select_817_s21_q;
  logic equal_822_s21_q;
  logic rise_s21_q;
  logic [1:0] sum_834_s21_q;
  logic [7:0] twice_s21_q;
  logic [8:0] difference_846_s21_q;
  logic and_866_s21_q;
  logic or_885_s21_q;
  logic or_888_s21_q;
  logic or_891_s21_q;
  logic equal_898_s21_q;
  logic equal_899_s21_q;
  logic and_909_s21_q;
  logic [11:0] sum_914_s21_q;
  logic [11:0] sum_925_s21_q;
  logic [11:0] sum_936_s21_q;
  logic and_939_s21_q;
  logic select_949_s21_q;
  logic [2:0] textured_2_s21_q;
  logic or_993_s21_q;
  logic or_996_s21_q;
  logic or_999_s21_q;
  logic [2:0] explained_2_s21_q;
  logic [2:0] near_2_s21_q;
  logic and_1046_s21_q;
  logic [10:0] size_2_s21_q;
  logic [10:0] size_3_s21_q;
  logic [10:0] sum_1144_s21_q;
  logic [9:0] sum_1147_s21_q;
  logic [9:0] sum_1151_s21_q;
  logic [9:0] sum_1155_s21_q;
  logic equal_1163_s21_q;
  logic [8:0] contrast_s21_q;
  logic [8:0] contrast_2_s21_q;
  logic equal_1214_s21_q;
  logic not_1260_s21_q;
  logic and_1347_s21_q;
  logic and_1352_s21_q;
  logic and_1357_s21_q;
  logic and_1362_s21_q;
  logic and_1367_s21_q;
  logic or_1372_s21_q;
  logic [11:0] select_1381_s21_q;
  logic [11:0] select_1384_s21_q;
  logic and_1432_s21_q;
  logic less_1434_s21_q;
  logic equal_1435_s21_q;
  logic equal_1436_s21_q;
  logic equal_1437_s21_q;
  logic [7:0] residual_s21_q;
  logic less_1547_s21_q;
  logic less_1556_s21_q;
  logic not_1564_s21_q;
  logic not_1597_s21_q;
  logic [1:0] select_1601_s21_q;
  logic [1:0] select_1611_s21_q;
  logic [1:0] select_1617_s21_q;
  logic [1:0] select_1627_s21_q;
  logic [1:0] select_1677_s21_q;
  logic [1:0] select_1693_s21_q;
  logic less_1760_s21_q;
  logic [12:0] sum_1763_s21_q;
  logic less_1777_s21_q;
  logic equal_1864_s21_q;
  logic less_1967_s21_q;
  logic less_1970_s21_q;
  logic or_1973_s21_q;
  logic less_1975_s21_q;
  logic less_1977_s21_q;
  logic select_1978_s21_q;
  logic less_1981_s21_q;
  logic less_1983_s21_q;
  logic less_1993_s21_q;
  logic and_2142_s21_q;
  logic [11:0] select_2161_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= pixel_0_s20_q;
      pixel_1_s21_q <= pixel_1_s20_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= mask_s20_q;
      marks_first_s21_q <= marks_first_s20_q;
      marks_last_s21_q <= marks_last_s20_q;
      census_columns_values_1_cell_2_mask_s21_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s21_q <= census_columns_values_1_cell_2_of_skin_s20_q;
      census_columns_values_1_cell_3_mask_s21_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s21_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s21_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s21_q <= census_columns_values_2_cell_1_mask_q;
      x_s21_q <= x_s20_q;
      age_s21_q <= age_s20_q;
      lower_half_s21_q <= lower_half_s20_q;
      registration_counts_measured_0_s21_q <= registration_counts_measured_0_s20_q;
      registration_counts_measured_1_s21_q <= registration_counts_measured_1_s20_q;
      registration_counts_measured_2_s21_q <= registration_counts_measured_2_s20_q;
      registration_counts_measured_3_s21_q <= registration_counts_measured_3_s20_q;
      region_row_s21_q <= region_row_s20_q;
      select_303_s21_q <= select_303_s20_q;
      and_338_s21_q <= and_338_s20_q;
      and_339_s21_q <= and_339_s20_q;
      equal_342_s21_q <= equal_342_s20_q;
      whole_2_s21_q <= whole_2_s20_q;
      equal_354_s21_q <= equal_354_s20_q;
      not_355_s21_q <= not_355_s20_q;
      equal_356_s21_q <= equal_356_s20_q;
      less_357_s21_q <= less_357_s20_q;
      not_358_s21_q <= not_358_s20_q;
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
      less_374_s21_q <= less_374_s20_q;
      less_375_s21_q <= less_375_s20_q;
      less_376_s21_q <= less_376_s20_q;
      less_377_s21_q <= less_377_s20_q;
      less_378_s21_q <= less_378_s20_q;
      less_379_s21_q <= less_379_s20_q;
      less_380_s21_q <= less_380_s20_q;
      less_381_s21_q <= less_381_s20_q;
      less_382_s21_q <= less_382_s20_q;
      less_383_s21_q <= less_383_s20_q;
      less_384_s21_q <= less_384_s20_q;
      less_385_s21_q <= less_385_s20_q;
      and_392_s21_q <= and_392_s20_q;
      whole_9_s21_q <= whole_9;
      sum_425_s21_q <= {1'b0, sum_421} + {1'b0, sum_424};
      sum_428_s21_q <= {9'h0, difference_426_s20_q} + {1'b0, xor_427_s20_q};
      sum_432_s21_q <= {9'h0, difference_430_s20_q} + {1'b0, xor_431_s20_q};
      sum_436_s21_q <= {9'h0, difference_434_s20_q} + {1'b0, xor_435_s20_q};
      drew_s21_q <= drew_s20_q;
      x_s21_2_q <= x_s20_2_q;
      not_499_s21_q <= not_499_s20_q;
      best_left_rdata_s21_q <= best_left_rdata_s20_q;
      equal_504_s21_q <= equal_504_s20_q;
      select_800_s21_q <= select_800_s20_q;
      less_806_s21_q <= less_806_s20_q;
      less_807_s21_q <= less_807_s20_q;
      or_809_s21_q <= or_809_s20_q;
      select_813_s21_q <= select_813_s20_q;
      select_817_s21_q <= select_817_s20_q;
      equal_822_s21_q <= equal_822_s20_q;
      rise_s21_q <= rise_s20_q;
      sum_834_s21_q <= sum_834_s20_q;
      twice_s21_q <= twice_s20_q;
      difference_846_s21_q <= {1'b0, twice_s20_q} - select_845_s20_q;
      and_866_s21_q <= and_866_s20_q;
      or_885_s21_q <= or_885_s20_q;
      or_888_s21_q <= or_888_s20_q;
      or_891_s21_q <= or_891_s20_q;
      equal_898_s21_q <= equal_898_s20_q;
      equal_899_s21_q <= equal_899_s20_q;
      and_909_s21_q <= and_909_s20_q;
      sum_914_s21_q <= sum_914;
      sum_925_s21_q <= sum_925;
      sum_936_s21_q <= sum_936;
      and_939_s21_q <= and_939_s20_q;
      select_949_s21_q <= select_949_s20_q;
      textured_2_s21_q <= textured_2;
      or_993_s21_q <= or_993_s20_q;
      or_996_s21_q <= or_996_s20_q;
      or_999_s21_q <= or_999_s20_q;
      explained_2_s21_q <= explained_2;
      near_2_s21_q <= near_2;
      and_1046_s21_q <= and_1046_s20_q;
      size_2_s21_q <= size_2;
      size_3_s21_q <= size_3;
      sum_1144_s21_q <= {1'b0, sum_1140} + {1'b0, sum_1143};
      sum_1147_s21_q <= {9'h0, difference_1145_s20_q} + {1'b0, xor_1146_s20_q};
      sum_1151_s21_q <= {9'h0, difference_1149_s20_q} + {1'b0, xor_1150_s20_q};
      sum_1155_s21_q <= {9'h0, difference_1153_s20_q} + {1'b0, xor_1154_s20_q};
      equal_1163_s21_q <= equal_1163_s20_q;
      contrast_s21_q <= contrast;
      contrast_2_s21_q <= contrast_2;
      equal_1214_s21_q <= equal_1214_s20_q;
      not_1260_s21_q <= not_1260_s20_q;
      and_1347_s21_q <= and_1347_s20_q;
      and_1352_s21_q <= and_1352_s20_q;
      and_1357_s21_q <= and_1357_s20_q;
      and_1362_s21_q <= and_1362_s20_q;
      and_1367_s21_q <= and_1367_s20_q;
      or_1372_s21_q <= (x_s20_q[7:1] == 7'h0) | (~centres_values_1_q);
      select_1381_s21_q <= less_1380 ? 12'h0 : regions_rdata_s20_q[11:0];
      select_1384_s21_q <= select_1384;
      and_1432_s21_q <= and_1432_s20_q;
      less_1434_s21_q <= less_1434_s20_q;
      equal_1435_s21_q <= equal_1435_s20_q;
      equal_1436_s21_q <= equal_1436_s20_q;
      equal_1437_s21_q <= equal_1437_s20_q;
      residual_s21_q <= residual_s20_q;
      less_1547_s21_q <= less_1547;
      less_1556_s21_q <= less_1556_s20_q;
      not_1564_s21_q <= not_1564_s20_q;
      not_1597_s21_q <= not_1597;
      select_1601_s21_q <= drew_s20_q ? select_1600 : 2'h0;
      select_1611_s21_q <= select_1611;
      select_1617_s21_q <= drew_s20_q ? select_1616 : 2'h0;
      select_1627_s21_q <= select_1627;
      select_1677_s21_q <= select_1677;
      select_1693_s21_q <= select_1693;
      less_1760_s21_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      sum_1763_s21_q <= {1'b0, select_1384} + {2'h0, select_1384[11:1]};
      less_1777_s21_q <= $signed(24'h0) < $signed(counts_too_much_hidden_q);
      equal_1864_s21_q <= equal_1864_s20_q;
      less_1967_s21_q <= 11'h4 < sum_1966_s20_q;
      less_1970_s21_q <= less_1970_s20_q;
      or_1973_s21_q <= or_1973;
      less_1975_s21_q <= 11'he < right[12:2];
      less_1977_s21_q <= less_1977;
      select_1978_s21_q <= or_1973 ? less_1972 : less_1977;
      less_1981_s21_q <= less_1981_s20_q;
      less_1983_s21_q <= $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
      less_1993_s21_q <= less_1993_s20_q;
      and_2142_s21_q <= and_2142_s20_q;
      select_2161_s21_q <= drew_s20_q ? 12'h0 : (equal_898_s20_q ? select_2159 : 12'h0);
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
  logic [14:0] registration_counts_votes_3_down_q;
  logic [14:0] registration_counts_votes_3_up_q;
  logic [14:0] registration_counts_votes_4_down_q;
  logic [14:0] registration_counts_votes_4_up_q;
  logic [14:0] registration_counts_half_votes_2_up_q;
  logic [14:0] registration_counts_half_votes_3_up_q;
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
  // hls/stages/agreement.hpp:242
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
  // hls/stages/census.hpp:190
  logic [10:0] sum_429;
  assign sum_429 = sum_425_s21_q + {1'b0, sum_428_s21_q};
  // hls/stages/registration.hpp:28
  logic not_847;
  assign not_847 = ~difference_846_s21_q[8];
  logic [7:0] xor_848;
  assign xor_848 = twice_s21_q ^ {8{not_847}};
  logic [9:0] sum_849;
  assign sum_849 = {difference_846_s21_q[7:0], 1'b0, not_847} + {not_847, xor_848, not_847};
  // hls/stages/agreement.hpp:176
  logic next_row;
  assign next_row = select_949_s21_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:714
  logic [6:0] select_952;
  assign select_952 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:724
  logic equal_955;
  assign equal_955 = seen_x_q == 4'hf;
  // hls/stages/census.hpp:31
  logic not_962;
  assign not_962 = ~marks_first_s21_q;
  // hls/stages/agreement.hpp:575
  logic [4:0] difference_984;
  assign difference_984 = {2'h0, textured_2_s21_q} - (age_s21_q ? box_textured_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:576
  logic [4:0] difference_1017;
  assign difference_1017 = {2'h0, explained_2_s21_q} - (age_s21_q ? box_explained_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:577
  logic [4:0] difference_1031;
  assign difference_1031 = {2'h0, near_2_s21_q} - (age_s21_q ? box_nearer_columns_values_4_q : 5'h0);
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2_s21_q} + (equal_342_s21_q ? 14'h0 : averager_detail_0_q);
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3_s21_q} + (equal_342_s21_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:176
  logic select_1121;
  assign select_1121 = and_339_s21_q ? census_columns_values_1_cell_2_mask_s21_q : census_columns_values_2_cell_2_mask_q;
  logic select_1124;
  assign select_1124 = and_339_s21_q ? census_columns_values_1_cell_3_mask_s21_q : census_columns_values_2_cell_3_mask_q;
  logic select_1127;
  assign select_1127 = and_339_s21_q ? census_columns_values_1_cell_4_mask_s21_q : census_columns_values_2_cell_4_mask_q;
  logic select_1128;
  assign select_1128 = and_339_s21_q ? census_columns_values_2_cell_0_mask_s21_q : census_columns_values_3_cell_0_mask_q;
  logic select_1131;
  assign select_1131 = and_339_s21_q ? census_columns_values_2_cell_1_mask_s21_q : census_columns_values_3_cell_1_mask_q;
  logic select_1132;
  assign select_1132 = and_339_s21_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_1135;
  assign select_1135 = and_339_s21_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:192
  logic [10:0] sum_1148;
  assign sum_1148 = sum_1144_s21_q + {1'b0, sum_1147_s21_q};
  // hls/stages/agreement.hpp:484
  logic [13:0] select_1354;
  assign select_1354 = and_1347_s21_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1352_s21_q});
  logic [13:0] select_1359;
  assign select_1359 = and_1347_s21_q ? 14'h0 : (counts_textured_q + {13'h0, and_1357_s21_q});
  // hls/stages/registration.hpp:79
  logic and_1573;
  assign and_1573 = less_1556_s21_q & not_1564_s21_q;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1575;
  assign select_1575 = less_357_s21_q ? 2'h0 : (and_1432_s21_q ? {and_1573, not_1564_s21_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1578;
  assign select_1578 = equal_354_s21_q ? 2'h0 : (equal_356_s21_q ? 2'h0 : (drew_s21_q ? select_1575 : 2'h0));
  // hls/stages/registration.hpp:79
  logic and_1581;
  assign and_1581 = less_1434_s21_q & less_1547_s21_q;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1583;
  assign select_1583 = less_357_s21_q ? 2'h0 : (and_1432_s21_q ? {and_1581, less_1434_s21_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1586;
  assign select_1586 = equal_354_s21_q ? 2'h0 : (equal_356_s21_q ? 2'h0 : (drew_s21_q ? select_1583 : 2'h0));
  // hls/stages/registration.hpp:79
  logic and_1589;
  assign and_1589 = less_1434_s21_q & less_1556_s21_q;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1591;
  assign select_1591 = less_357_s21_q ? 2'h0 : (and_1432_s21_q ? {and_1589, less_1434_s21_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1594;
  assign select_1594 = equal_354_s21_q ? 2'h0 : (equal_356_s21_q ? 2'h0 : (drew_s21_q ? select_1591 : 2'h0));
  logic [1:0] select_1603;
  assign select_1603 = equal_354_s21_q ? 2'h0 : (equal_356_s21_q ? 2'h0 : select_1601_s21_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1604;
  assign sum_1604 = registration_counts_votes_3_down_q + {{13{select_1603[1]}}, select_1603};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1612;
  assign sum_1612 = registration_counts_votes_3_up_q + {{13{select_1611_s21_q[1]}}, select_1611_s21_q};
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1619;
  assign select_1619 = equal_354_s21_q ? 2'h0 : (equal_356_s21_q ? 2'h0 : select_1617_s21_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1620;
  assign sum_1620 = registration_counts_votes_4_down_q + {{13{select_1619[1]}}, select_1619};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1628;
  assign sum_1628 = registration_counts_votes_4_up_q + {{13{select_1627_s21_q[1]}}, select_1627_s21_q};
  logic [14:0] sum_1678;
  assign sum_1678 = registration_counts_half_votes_2_up_q + {{13{select_1677_s21_q[1]}}, select_1677_s21_q};
  logic [14:0] sum_1694;
  assign sum_1694 = registration_counts_half_votes_3_up_q + {{13{select_1693_s21_q[1]}}, select_1693_s21_q};
  // hls/stages/agreement.hpp:604
  logic and_1759;
  assign and_1759 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:611
  logic less_1764;
  assign less_1764 = {sum_1763_s21_q, select_1384_s21_q[0]} < {2'h0, select_1381_s21_q};
  logic select_1766;
  assign select_1766 = (select_1381_s21_q[11:3] == 9'h0) ? (and_1759 & (~less_1760_s21_q)) : (~less_1764);
  // hls/stages/agreement.hpp:299
  logic [4:0] select_1804;
  assign select_1804 = drew_s21_q ? {2'h0, textured_2_s21_q} : box_textured_columns_values_0_q;
  logic [4:0] select_1806;
  assign select_1806 = equal_354_s21_q ? box_textured_columns_values_0_q : (equal_356_s21_q ? box_textured_columns_values_0_q : select_1804);
  logic [4:0] select_1807;
  assign select_1807 = drew_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1809;
  assign select_1809 = equal_354_s21_q ? box_textured_columns_values_1_q : (equal_356_s21_q ? box_textured_columns_values_1_q : select_1807);
  logic [4:0] select_1810;
  assign select_1810 = drew_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1812;
  assign select_1812 = equal_354_s21_q ? box_textured_columns_values_2_q : (equal_356_s21_q ? box_textured_columns_values_2_q : select_1810);
  logic [4:0] select_1813;
  assign select_1813 = drew_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1815;
  assign select_1815 = equal_354_s21_q ? box_textured_columns_values_3_q : (equal_356_s21_q ? box_textured_columns_values_3_q : select_1813);
  logic [4:0] select_1816;
  assign select_1816 = drew_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1818;
  assign select_1818 = equal_354_s21_q ? box_textured_columns_values_4_q : (equal_356_s21_q ? box_textured_columns_values_4_q : select_1816);
  logic [4:0] select_1822;
  assign select_1822 = drew_s21_q ? {2'h0, explained_2_s21_q} : box_explained_columns_values_0_q;
  logic [4:0] select_1824;
  assign select_1824 = equal_354_s21_q ? box_explained_columns_values_0_q : (equal_356_s21_q ? box_explained_columns_values_0_q : select_1822);
  logic [4:0] select_1825;
  assign select_1825 = drew_s21_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1827;
  assign select_1827 = equal_354_s21_q ? box_explained_columns_values_1_q : (equal_356_s21_q ? box_explained_columns_values_1_q : select_1825);
  logic [4:0] select_1828;
  assign select_1828 = drew_s21_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1830;
  assign select_1830 = equal_354_s21_q ? box_explained_columns_values_2_q : (equal_356_s21_q ? box_explained_columns_values_2_q : select_1828);
  logic [4:0] select_1831;
  assign select_1831 = drew_s21_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1833;
  assign select_1833 = equal_354_s21_q ? box_explained_columns_values_3_q : (equal_356_s21_q ? box_explained_columns_values_3_q : select_1831);
  logic [4:0] select_1834;
  assign select_1834 = drew_s21_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1836;
  assign select_1836 = equal_354_s21_q ? box_explained_columns_values_4_q : (equal_356_s21_q ? box_explained_columns_values_4_q : select_1834);
  logic [4:0] select_1840;
  assign select_1840 = drew_s21_q ? {2'h0, near_2_s21_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_1842;
  assign select_1842 = equal_354_s21_q ? box_nearer_columns_values_0_q : (equal_356_s21_q ? box_nearer_columns_values_0_q : select_1840);
  logic [4:0] select_1843;
  assign select_1843 = drew_s21_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1845;
  assign select_1845 = equal_354_s21_q ? box_nearer_columns_values_1_q : (equal_356_s21_q ? box_nearer_columns_values_1_q : select_1843);
  logic [4:0] select_1846;
  assign select_1846 = drew_s21_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1848;
  assign select_1848 = equal_354_s21_q ? box_nearer_columns_values_2_q : (equal_356_s21_q ? box_nearer_columns_values_2_q : select_1846);
  logic [4:0] select_1849;
  assign select_1849 = drew_s21_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1851;
  assign select_1851 = equal_354_s21_q ? box_nearer_columns_values_3_q : (equal_356_s21_q ? box_nearer_columns_values_3_q : select_1849);
  logic [4:0] select_1852;
  assign select_1852 = drew_s21_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_1854;
  assign select_1854 = equal_354_s21_q ? box_nearer_columns_values_4_q : (equal_356_s21_q ? box_nearer_columns_values_4_q : select_1852);
  // hls/stages/agreement.hpp:723
  logic [3:0] select_1884;
  assign select_1884 = select_949_s21_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1890;
  assign select_1890 = marks_first_s21_q ? (less_1886 ? {sum_1887, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:104
  logic select_1979;
  assign select_1979 = less_1967_s21_q ? select_1978_s21_q : less_1977_s21_q;
  logic or_1980;
  assign or_1980 = (~less_1975_s21_q) | select_1979;
  logic select_1984;
  assign select_1984 = or_1980 ? select_1979 : less_1983_s21_q;
  logic select_1986;
  assign select_1986 = less_1967_s21_q ? select_1984 : (less_1970_s21_q ? select_1984 : less_1983_s21_q);
  // hls/stages/agreement.hpp:623
  logic and_2012;
  assign and_2012 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2013;
  assign or_2013 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2012;
  logic select_2014;
  assign select_2014 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2013 : and_2012;
  // hls/stages/agreement.hpp:299
  logic [11:0] select_2163;
  assign select_2163 = equal_354_s21_q ? 12'h0 : (equal_356_s21_q ? 12'h0 : select_2161_s21_q);

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s21_q, or_891_s21_q, or_888_s21_q, or_885_s21_q};
  logic regions_we;
  assign regions_we = s21_en & and_939_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_936_s21_q, sum_925_s21_q, sum_914_s21_q};
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
      registration_counts_votes_3_down_q <= 15'h0;
      registration_counts_votes_3_up_q <= 15'h0;
      registration_counts_votes_4_down_q <= 15'h0;
      registration_counts_votes_4_up_q <= 15'h0;
      registration_counts_half_votes_2_up_q <= 15'h0;
      registration_counts_half_votes_3_up_q <= 15'h0;
      began_q <= 1'b0;
      seen_x_q <= 4'h0;
      seen_y_q <= 4'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 13'h0;
    end else if (s21_en) begin
      counts_supervised_q <= select_1354;
      counts_textured_q <= select_1359;
      registration_counts_votes_3_down_q <= and_1347_s21_q ? 15'h0 : sum_1604;
      registration_counts_votes_3_up_q <= and_1347_s21_q ? 15'h0 : sum_1612;
      registration_counts_votes_4_down_q <= and_1347_s21_q ? 15'h0 : sum_1620;
      registration_counts_votes_4_up_q <= and_1347_s21_q ? 15'h0 : sum_1628;
      registration_counts_half_votes_2_up_q <= and_1347_s21_q ? 15'h0 : sum_1678;
      registration_counts_half_votes_3_up_q <= and_1347_s21_q ? 15'h0 : sum_1694;
      began_q <= not_962 & (began_q | select_949_s21_q);
      seen_x_q <= select_949_s21_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s21_q ? 4'h0 : select_1884;
      seen_column_q <= select_949_s21_q ? 8'h0 : (seen_column_q + {7'h0, equal_955});
      seen_rows_left_q <= select_1890;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s21_q ? 13'h0 : (seen_base_q + {6'h0, select_952});
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
      averager_detail_0_q <= and_338_s21_q ? detail : averager_detail_0_q;
      averager_detail_1_q <= and_338_s21_q ? detail_2 : averager_detail_1_q;
      census_columns_values_2_cell_2_mask_q <= select_1121;
      census_columns_values_2_cell_3_mask_q <= select_1124;
      census_columns_values_2_cell_4_mask_q <= select_1127;
      census_columns_values_3_cell_0_mask_q <= select_1128;
      census_columns_values_3_cell_1_mask_q <= select_1131;
      census_columns_values_3_cell_2_mask_q <= select_1132;
      census_columns_values_3_cell_3_mask_q <= select_1135;
      box_textured_columns_values_0_q <= select_1806;
      box_textured_columns_values_1_q <= select_1809;
      box_textured_columns_values_2_q <= select_1812;
      box_textured_columns_values_3_q <= select_1815;
      box_textured_columns_values_4_q <= select_1818;
      box_explained_columns_values_0_q <= select_1824;
      box_explained_columns_values_1_q <= select_1827;
      box_explained_columns_values_2_q <= select_1830;
      box_explained_columns_values_3_q <= select_1833;
      box_explained_columns_values_4_q <= select_1836;
      box_nearer_columns_values_0_q <= select_1842;
      box_nearer_columns_values_1_q <= select_1845;
      box_nearer_columns_values_2_q <= select_1848;
      box_nearer_columns_values_3_q <= select_1851;
      box_nearer_columns_values_4_q <= select_1854;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic census_columns_values_2_cell_4_mask_s22_q;
  logic census_columns_values_3_cell_0_mask_s22_q;
  logic census_columns_values_3_cell_1_mask_s22_q;
  logic census_columns_values_3_cell_2_mask_s22_q;
  logic census_columns_values_3_cell_3_mask_s22_q;
  logic [5:0] x_s22_q;
  logic lower_half_s22_q;
  logic [13:0] counts_supervised_s22_q;
  logic [13:0] counts_textured_s22_q;
  logic [11:0] registration_counts_measured_0_s22_q;
  logic [11:0] registration_counts_measured_1_s22_q;
  logic [11:0] registration_counts_measured_2_s22_q;
  logic [11:0] registration_counts_measured_3_s22_q;
  logic [2:0] region_row_s22_q;
  logic [6:0] select_303_s22_q;
  logic and_339_s22_q;
  logic whole_2_s22_q;
  logic equal_354_s22_q;
  logic not_355_s22_q;
  logic equal_356_s22_q;
  logic less_357_s22_q;
  logic not_358_s22_q;
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
  logic less_374_s22_q;
  logic less_375_s22_q;
  logic less_376_s22_q;
  logic less_377_s22_q;
  logic less_378_s22_q;
  logic less_379_s22_q;
  logic less_380_s22_q;
  logic less_381_s22_q;
  logic less_382_s22_q;
  logic less_383_s22_q;
  logic less_384_s22_q;
  logic less_385_s22_q;
  logic and_392_s22_q;
  logic whole_16_s22_q;
  logic and_418_s22_q;
  logic [11:0] sum_433_s22_q;
  logic [9:0] sum_436_s22_q;
  logic drew_s22_q;
  logic [6:0] x_s22_2_q;
  logic not_499_s22_q;
  logic [7:0] best_left_rdata_s22_q;
  logic equal_504_s22_q;
  logic select_800_s22_q;
  logic less_806_s22_q;
  logic less_807_s22_q;
  logic or_809_s22_q;
  logic [7:0] select_813_s22_q;
  logic [5:0] select_817_s22_q;
  logic equal_822_s22_q;
  logic rise_s22_q;
  logic [1:0] sum_834_s22_q;
  logic [7:0] twice_s22_q;
  logic difference_846_s22_q;
  logic [9:0] sum_849_s22_q;
  logic and_866_s22_q;
  logic equal_898_s22_q;
  logic equal_899_s22_q;
  logic and_909_s22_q;
  logic not_962_s22_q;
  logic [7:0] sum_972_s22_q;
  logic [4:0] difference_984_s22_q;
  logic equal_985_s22_q;
  logic or_993_s22_q;
  logic or_996_s22_q;
  logic or_999_s22_q;
  logic [4:0] difference_1017_s22_q;
  logic [4:0] difference_1031_s22_q;
  logic and_1046_s22_q;
  logic [13:0] detail_s22_q;
  logic [13:0] detail_2_s22_q;
  logic [11:0] sum_1152_s22_q;
  logic [9:0] sum_1155_s22_q;
  logic equal_1163_s22_q;
  logic [8:0] contrast_s22_q;
  logic [8:0] contrast_2_s22_q;
  logic equal_1214_s22_q;
  logic not_1260_s22_q;
  logic and_1347_s22_q;
  logic and_1362_s22_q;
  logic and_1367_s22_q;
  logic or_1372_s22_q;
  logic [11:0] select_1381_s22_q;
  logic [11:0] select_1384_s22_q;
  logic and_1432_s22_q;
  logic less_1434_s22_q;
  logic equal_1435_s22_q;
  logic equal_1436_s22_q;
  logic equal_1437_s22_q;
  logic [7:0] residual_s22_q;
  logic less_1547_s22_q;
  logic not_1564_s22_q;
  logic [1:0] select_1578_s22_q;
  logic [1:0] select_1586_s22_q;
  logic [1:0] select_1594_s22_q;
  logic not_1597_s22_q;
  logic and_1759_s22_q;
  logic less_1760_s22_q;
  logic select_1766_s22_q;
  logic less_1777_s22_q;
  logic equal_1864_s22_q;
  logic less_1967_s22_q;
  logic less_1970_s22_q;
  logic or_1973_s22_q;
  logic less_1975_s22_q;
  logic or_1980_s22_q;
  logic less_1981_s22_q;
  logic select_1986_s22_q;
  logic less_1988_s22_q;
  logic less_1993_s22_q;
  logic less_1996_s22_q;
  logic select_2014_s22_q;
  logic and_2142_s22_q;
  logic [11:0] select_2163_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_s21_q;
      census_columns_values_2_cell_4_mask_s22_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s22_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s22_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s22_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s22_q <= census_columns_values_3_cell_3_mask_q;
      x_s22_q <= x_s21_q[5:0];
      lower_half_s22_q <= lower_half_s21_q;
      counts_supervised_s22_q <= counts_supervised_q;
      counts_textured_s22_q <= counts_textured_q;
      registration_counts_measured_0_s22_q <= registration_counts_measured_0_s21_q;
      registration_counts_measured_1_s22_q <= registration_counts_measured_1_s21_q;
      registration_counts_measured_2_s22_q <= registration_counts_measured_2_s21_q;
      registration_counts_measured_3_s22_q <= registration_counts_measured_3_s21_q;
      region_row_s22_q <= region_row_s21_q;
      select_303_s22_q <= select_303_s21_q;
      and_339_s22_q <= and_339_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      equal_354_s22_q <= equal_354_s21_q;
      not_355_s22_q <= not_355_s21_q;
      equal_356_s22_q <= equal_356_s21_q;
      less_357_s22_q <= less_357_s21_q;
      not_358_s22_q <= not_358_s21_q;
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
      less_374_s22_q <= less_374_s21_q;
      less_375_s22_q <= less_375_s21_q;
      less_376_s22_q <= less_376_s21_q;
      less_377_s22_q <= less_377_s21_q;
      less_378_s22_q <= less_378_s21_q;
      less_379_s22_q <= less_379_s21_q;
      less_380_s22_q <= less_380_s21_q;
      less_381_s22_q <= less_381_s21_q;
      less_382_s22_q <= less_382_s21_q;
      less_383_s22_q <= less_383_s21_q;
      less_384_s22_q <= less_384_s21_q;
      less_385_s22_q <= less_385_s21_q;
      and_392_s22_q <= and_392_s21_q;
      whole_16_s22_q <= whole_16;
      and_418_s22_q <= census_columns_values_1_cell_2_mask_s21_q & and_392_s21_q;
      sum_433_s22_q <= {1'b0, sum_429} + {2'h0, sum_432_s21_q};
      sum_436_s22_q <= sum_436_s21_q;
      drew_s22_q <= drew_s21_q;
      x_s22_2_q <= x_s21_2_q;
      not_499_s22_q <= not_499_s21_q;
      best_left_rdata_s22_q <= best_left_rdata_s21_q;
      equal_504_s22_q <= equal_504_s21_q;
      select_800_s22_q <= select_800_s21_q;
      less_806_s22_q <= less_806_s21_q;
      less_807_s22_q <= less_807_s21_q;
      or_809_s22_q <= or_809_s21_q;
      select_813_s22_q <= select_813_s21_q;
      select_817_s22_q <= select_817_s21_q;
      equal_822_s22_q <= equal_822_s21_q;
      rise_s22_q <= rise_s21_q;
      sum_834_s22_q <= sum_834_s21_q;
      twice_s22_q <= twice_s21_q;
      difference_846_s22_q <= difference_846_s21_q[8];
      sum_849_s22_q <= sum_849;
      and_866_s22_q <= and_866_s21_q;
      equal_898_s22_q <= equal_898_s21_q;
      equal_899_s22_q <= equal_899_s21_q;
      and_909_s22_q <= and_909_s21_q;
      not_962_s22_q <= not_962;
      sum_972_s22_q <= {2'h0, x_s21_q[7:2]} + 8'hff;
      difference_984_s22_q <= difference_984;
      equal_985_s22_q <= x_s21_q == 8'h0;
      or_993_s22_q <= or_993_s21_q;
      or_996_s22_q <= or_996_s21_q;
      or_999_s22_q <= or_999_s21_q;
      difference_1017_s22_q <= difference_1017;
      difference_1031_s22_q <= difference_1031;
      and_1046_s22_q <= and_1046_s21_q;
      detail_s22_q <= detail;
      detail_2_s22_q <= detail_2;
      sum_1152_s22_q <= {1'b0, sum_1148} + {2'h0, sum_1151_s21_q};
      sum_1155_s22_q <= sum_1155_s21_q;
      equal_1163_s22_q <= equal_1163_s21_q;
      contrast_s22_q <= contrast_s21_q;
      contrast_2_s22_q <= contrast_2_s21_q;
      equal_1214_s22_q <= equal_1214_s21_q;
      not_1260_s22_q <= not_1260_s21_q;
      and_1347_s22_q <= and_1347_s21_q;
      and_1362_s22_q <= and_1362_s21_q;
      and_1367_s22_q <= and_1367_s21_q;
      or_1372_s22_q <= or_1372_s21_q;
      select_1381_s22_q <= select_1381_s21_q;
      select_1384_s22_q <= select_1384_s21_q;
      and_1432_s22_q <= and_1432_s21_q;
      less_1434_s22_q <= less_1434_s21_q;
      equal_1435_s22_q <= equal_1435_s21_q;
      equal_1436_s22_q <= equal_1436_s21_q;
      equal_1437_s22_q <= equal_1437_s21_q;
      residual_s22_q <= residual_s21_q;
      less_1547_s22_q <= less_1547_s21_q;
      not_1564_s22_q <= not_1564_s21_q;
      select_1578_s22_q <= select_1578;
      select_1586_s22_q <= select_1586;
      select_1594_s22_q <= select_1594;
      not_1597_s22_q <= not_1597_s21_q;
      and_1759_s22_q <= and_1759;
      less_1760_s22_q <= less_1760_s21_q;
      select_1766_s22_q <= select_1766;
      less_1777_s22_q <= less_1777_s21_q;
      equal_1864_s22_q <= equal_1864_s21_q;
      less_1967_s22_q <= less_1967_s21_q;
      less_1970_s22_q <= less_1970_s21_q;
      or_1973_s22_q <= or_1973_s21_q;
      less_1975_s22_q <= less_1975_s21_q;
      or_1980_s22_q <= or_1980;
      less_1981_s22_q <= less_1981_s21_q;
      select_1986_s22_q <= select_1986;
      less_1988_s22_q <= $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
      less_1993_s22_q <= less_1993_s21_q;
      less_1996_s22_q <= $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
      select_2014_s22_q <= select_2014;
      and_2142_s22_q <= and_2142_s21_q;
      select_2163_s22_q <= select_2163;
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
  logic [14:0] registration_counts_votes_1_up_q;
  logic [14:0] registration_counts_votes_2_down_q;
  logic [14:0] registration_counts_votes_2_up_q;
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
  // hls/stages/agreement.hpp:242
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
  // hls/stages/census.hpp:190
  logic [11:0] texture;
  assign texture = sum_433_s22_q + {2'h0, sum_436_s22_q};
  // hls/stages/registration.hpp:28
  logic not_850;
  assign not_850 = ~sum_849_s22_q[9];
  logic [7:0] xor_851;
  assign xor_851 = twice_s22_q ^ {8{not_850}};
  // hls/stages/agreement.hpp:727
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:698
  logic select_960;
  assign select_960 = marks_first_s22_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:684
  logic [10:0] sum_961;
  assign sum_961 = {1'b0, {5{select_960}}, 1'b0, {2{select_960}}, 1'b0, select_960} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:589
  logic [12:0] index_2;
  assign index_2 = {{3{sum_972_s22_q[7]}}, sum_972_s22_q, x_s22_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:684
  logic [10:0] sum_974;
  assign sum_974 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:575
  logic [4:0] t;
  assign t = difference_984_s22_q + (equal_985_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:581
  logic not_1000;
  assign not_1000 = ~region_row_s22_q[2];
  logic [2:0] select_1001;
  assign select_1001 = region_row_s22_q[1] ? {1'b0, not_1000, 1'b0} : {region_row_s22_q[2], 1'b0, not_1000};
  logic [5:0] select_1002;
  assign select_1002 = region_row_s22_q[0] ? {select_1001[2], 1'b0, select_1001[1], 1'b0, select_1001[0], 1'b0} : {1'b0, select_1001[2], 1'b0, select_1001[1], 1'b0, select_1001[0]};
  logic [11:0] select_1003;
  assign select_1003 = or_999_s22_q ? {select_1002[5], 1'b0, select_1002[4], 1'b0, select_1002[3], 1'b0, select_1002[2], 1'b0, select_1002[1], 1'b0, select_1002[0], 1'b0} : {1'b0, select_1002[5], 1'b0, select_1002[4], 1'b0, select_1002[3], 1'b0, select_1002[2], 1'b0, select_1002[1], 1'b0, select_1002[0]};
  logic [23:0] select_1004;
  assign select_1004 = or_996_s22_q ? {select_1003[11], 1'b0, select_1003[10], 1'b0, select_1003[9], 1'b0, select_1003[8], 1'b0, select_1003[7], 1'b0, select_1003[6], 1'b0, select_1003[5], 1'b0, select_1003[4], 1'b0, select_1003[3], 1'b0, select_1003[2], 1'b0, select_1003[1], 1'b0, select_1003[0], 1'b0} : {1'b0, select_1003[11], 1'b0, select_1003[10], 1'b0, select_1003[9], 1'b0, select_1003[8], 1'b0, select_1003[7], 1'b0, select_1003[6], 1'b0, select_1003[5], 1'b0, select_1003[4], 1'b0, select_1003[3], 1'b0, select_1003[2], 1'b0, select_1003[1], 1'b0, select_1003[0]};
  // hls/stages/agreement.hpp:576
  logic [4:0] e;
  assign e = difference_1017_s22_q + (equal_985_s22_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:577
  logic [4:0] n;
  assign n = difference_1031_s22_q + (equal_985_s22_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:176
  logic select_1136;
  assign select_1136 = and_339_s22_q ? census_columns_values_2_cell_4_mask_s22_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [11:0] sum_1156;
  assign sum_1156 = sum_1152_s22_q + {2'h0, sum_1155_s22_q};
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1158;
  assign select_1158 = and_339_s22_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1159;
  assign select_1159 = and_339_s22_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/census.hpp:275
  logic and_1181;
  assign and_1181 = whole_2_s22_q & (~(select_303_s22_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:243
  logic and_1187;
  assign and_1187 = and_1181 & (sharpness_last_mask_q & (7'h2 < contrast_s22_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, detail_s22_q};
  // hls/stages/agreement.hpp:243
  logic and_1198;
  assign and_1198 = and_1181 & (sharpness_last_mask_q & (7'h2 < contrast_2_s22_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, detail_2_s22_q};
  // hls/stages/agreement.hpp:609
  logic [12:0] sum_1385;
  assign sum_1385 = {1'b0, select_1384_s22_q} + {3'h0, select_1384_s22_q[11:2]};
  // hls/stages/agreement.hpp:165
  logic and_1548;
  assign and_1548 = and_1432_s22_q & less_1547_s22_q;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1550;
  assign select_1550 = drew_s22_q ? (less_357_s22_q ? 2'h0 : {and_1548, and_1432_s22_q}) : 2'h0;
  // hls/stages/registration.hpp:79
  logic and_1565;
  assign and_1565 = less_1547_s22_q & not_1564_s22_q;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1567;
  assign select_1567 = less_357_s22_q ? 2'h0 : (and_1432_s22_q ? {and_1565, not_1564_s22_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1570;
  assign select_1570 = equal_354_s22_q ? 2'h0 : (equal_356_s22_q ? 2'h0 : (drew_s22_q ? select_1567 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1579;
  assign sum_1579 = registration_counts_votes_1_up_q + {{13{select_1578_s22_q[1]}}, select_1578_s22_q};
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1587;
  assign sum_1587 = registration_counts_votes_2_down_q + {{13{select_1586_s22_q[1]}}, select_1586_s22_q};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1595;
  assign sum_1595 = registration_counts_votes_2_up_q + {{13{select_1594_s22_q[1]}}, select_1594_s22_q};
  // hls/stages/registration.hpp:146
  logic less_1630;
  assign less_1630 = $signed(residual_s22_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1631;
  assign and_1631 = not_1564_s22_q & less_1630;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1633;
  assign select_1633 = less_357_s22_q ? 2'h0 : (and_1432_s22_q ? {and_1631, not_1564_s22_q} : 2'h0);
  // hls/stages/registration.hpp:79
  logic and_1648;
  assign and_1648 = less_1434_s22_q & less_1630;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1650;
  assign select_1650 = less_357_s22_q ? 2'h0 : (and_1432_s22_q ? {and_1648, less_1434_s22_q} : 2'h0);
  logic and_1664;
  assign and_1664 = less_1630 & not_1597_s22_q;
  logic [1:0] select_1666;
  assign select_1666 = less_357_s22_q ? 2'h0 : (and_1432_s22_q ? {and_1664, not_1597_s22_q} : 2'h0);
  logic and_1680;
  assign and_1680 = lower_half_s22_q & less_1630;
  logic [1:0] select_1682;
  assign select_1682 = less_357_s22_q ? 2'h0 : (and_1432_s22_q ? {and_1680, lower_half_s22_q} : 2'h0);
  // hls/stages/agreement.hpp:619
  logic equal_1754;
  assign equal_1754 = x_s22_q == 6'h3f;
  logic [47:0] select_1767;
  assign select_1767 = equal_899_s22_q ? good_next_q : {select_1766_s22_q, good_next_q[47:1]};
  // hls/stages/agreement.hpp:299
  logic [47:0] select_1774;
  assign select_1774 = drew_s22_q ? good_next_q : (equal_898_s22_q ? select_1767 : good_next_q);
  logic [47:0] select_1776;
  assign select_1776 = equal_354_s22_q ? good_next_q : (equal_356_s22_q ? good_next_q : select_1774);
  logic [4:0] select_1820;
  assign select_1820 = equal_356_s22_q ? box_textured_sum_sums_values_0_q : (drew_s22_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1838;
  assign select_1838 = equal_356_s22_q ? box_explained_sum_sums_values_0_q : (drew_s22_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1839;
  assign select_1839 = equal_354_s22_q ? box_explained_sum_sums_values_0_q : select_1838;
  logic [4:0] select_1856;
  assign select_1856 = equal_356_s22_q ? box_nearer_sum_sums_values_0_q : (drew_s22_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:246
  logic [12:0] select_1867;
  assign select_1867 = equal_1214_s22_q ? (equal_1864_s22_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1870;
  assign select_1870 = and_339_s22_q ? (equal_1214_s22_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:299
  logic and_1880;
  assign and_1880 = not_499_s22_q & (not_1260_s22_q & (equal_898_s22_q & equal_1754));
  logic [13:0] select_1909;
  assign select_1909 = equal_898_s22_q ? (equal_1754 ? counts_supervised_s22_q : 14'h0) : 14'h0;
  logic [13:0] select_1912;
  assign select_1912 = equal_354_s22_q ? 14'h0 : (equal_356_s22_q ? 14'h0 : (drew_s22_q ? 14'h0 : select_1909));
  logic [13:0] select_1914;
  assign select_1914 = equal_898_s22_q ? (equal_1754 ? counts_textured_s22_q : 14'h0) : 14'h0;
  logic [13:0] select_1917;
  assign select_1917 = equal_354_s22_q ? 14'h0 : (equal_356_s22_q ? 14'h0 : (drew_s22_q ? 14'h0 : select_1914));
  // hls/stages/registration.hpp:104
  logic or_1987;
  assign or_1987 = (~less_1981_s22_q) | select_1986_s22_q;
  logic select_1989;
  assign select_1989 = or_1987 ? select_1986_s22_q : less_1988_s22_q;
  logic select_1991;
  assign select_1991 = less_1970_s22_q ? select_1989 : (less_1975_s22_q ? select_1989 : less_1988_s22_q);
  // hls/stages/agreement.hpp:623
  logic and_2015;
  assign and_2015 = (less_1981_s22_q & less_1993_s22_q) & select_2014_s22_q;
  logic or_2016;
  assign or_2016 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2015;
  logic select_2017;
  assign select_2017 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2016 : and_2015;
  logic or_2018;
  assign or_2018 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2017;
  // hls/stages/agreement.hpp:299
  logic [11:0] select_2101;
  assign select_2101 = equal_898_s22_q ? (equal_1754 ? registration_counts_measured_0_s22_q : 12'h0) : 12'h0;
  logic [11:0] select_2104;
  assign select_2104 = equal_354_s22_q ? 12'h0 : (equal_356_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2101));
  logic [11:0] select_2106;
  assign select_2106 = equal_898_s22_q ? (equal_1754 ? registration_counts_measured_1_s22_q : 12'h0) : 12'h0;
  logic [11:0] select_2109;
  assign select_2109 = equal_354_s22_q ? 12'h0 : (equal_356_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2106));
  logic [11:0] select_2111;
  assign select_2111 = equal_898_s22_q ? (equal_1754 ? registration_counts_measured_2_s22_q : 12'h0) : 12'h0;
  logic [11:0] select_2114;
  assign select_2114 = equal_354_s22_q ? 12'h0 : (equal_356_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2111));
  logic [11:0] select_2116;
  assign select_2116 = equal_898_s22_q ? (equal_1754 ? registration_counts_measured_3_s22_q : 12'h0) : 12'h0;
  logic [11:0] select_2119;
  assign select_2119 = equal_354_s22_q ? 12'h0 : (equal_356_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2116));
  logic [5:0] select_2145;
  assign select_2145 = drew_s22_q ? 6'h0 : (equal_898_s22_q ? (equal_899_s22_q ? 6'h0 : x_s22_q) : 6'h0);
  logic [11:0] select_2154;
  assign select_2154 = equal_898_s22_q ? (equal_899_s22_q ? 12'h0 : select_1384_s22_q) : 12'h0;
  logic [11:0] select_2157;
  assign select_2157 = equal_354_s22_q ? 12'h0 : (equal_356_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2154));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_counts_votes_1_up_q <= 15'h0;
      registration_counts_votes_2_down_q <= 15'h0;
      registration_counts_votes_2_up_q <= 15'h0;
      good_next_q <= 48'h0;
      begins_product_q <= 1'b0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s22_en) begin
      registration_counts_votes_1_up_q <= and_1347_s22_q ? 15'h0 : sum_1579;
      registration_counts_votes_2_down_q <= and_1347_s22_q ? 15'h0 : sum_1587;
      registration_counts_votes_2_up_q <= and_1347_s22_q ? 15'h0 : sum_1595;
      good_next_q <= select_1776;
      begins_product_q <= drew_s22_q;
      map_row_q <= and_339_s22_q ? select_1867 : map_row_q;
      map_width_q <= select_1870;
      write_half_q <= marks_first_s22_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_960;
      done_q <= not_962_s22_q & ((~begins_product_q) & (done_q | said_q));
      said_q <= not_355_s22_q & and_1880;
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
      census_columns_values_3_cell_4_mask_q <= select_1136;
      census_changes_values_0_left_q <= and_339_s22_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_339_s22_q ? sum_1156 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1158;
      census_changes_values_1_right_q <= select_1159;
      sharpness_last_mask_q <= and_339_s22_q ? whole_2_s22_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_339_s22_q ? detail_s22_q : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_339_s22_q ? detail_2_s22_q : sharpness_last_detail_1_q;
      box_textured_sum_sums_values_0_q <= equal_354_s22_q ? box_textured_sum_sums_values_0_q : select_1820;
      box_explained_sum_sums_values_0_q <= select_1839;
      box_nearer_sum_sums_values_0_q <= equal_354_s22_q ? box_nearer_sum_sums_values_0_q : select_1856;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic [11:0] census_changes_values_1_left_s23_q;
  logic [11:0] census_changes_values_1_right_s23_q;
  logic begins_product_s23_q;
  logic done_s23_q;
  logic [6:0] select_303_s23_q;
  logic and_339_s23_q;
  logic equal_354_s23_q;
  logic not_355_s23_q;
  logic equal_356_s23_q;
  logic less_357_s23_q;
  logic not_358_s23_q;
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
  logic less_374_s23_q;
  logic less_375_s23_q;
  logic less_376_s23_q;
  logic less_377_s23_q;
  logic less_378_s23_q;
  logic less_379_s23_q;
  logic less_380_s23_q;
  logic less_381_s23_q;
  logic less_382_s23_q;
  logic less_383_s23_q;
  logic less_384_s23_q;
  logic less_385_s23_q;
  logic and_392_s23_q;
  logic and_417_s23_q;
  logic and_418_s23_q;
  logic [12:0] sum_438_s23_q;
  logic [6:0] x_s23_q;
  logic not_499_s23_q;
  logic [7:0] best_left_rdata_s23_q;
  logic equal_504_s23_q;
  logic select_800_s23_q;
  logic less_806_s23_q;
  logic less_807_s23_q;
  logic or_809_s23_q;
  logic [7:0] select_813_s23_q;
  logic [5:0] select_817_s23_q;
  logic equal_822_s23_q;
  logic rise_s23_q;
  logic [1:0] sum_834_s23_q;
  logic [7:0] twice_s23_q;
  logic difference_846_s23_q;
  logic sum_849_s23_q;
  logic [9:0] sum_852_s23_q;
  logic and_866_s23_q;
  logic equal_898_s23_q;
  logic equal_899_s23_q;
  logic and_909_s23_q;
  logic [2:0] index_s23_q;
  logic [10:0] sum_961_s23_q;
  logic and_968_s23_q;
  logic less_969_s23_q;
  logic [2:0] index_2_s23_q;
  logic [10:0] sum_974_s23_q;
  logic [4:0] t_s23_q;
  logic or_993_s23_q;
  logic [23:0] select_1004_s23_q;
  logic [4:0] e_s23_q;
  logic less_1034_s23_q;
  logic and_1046_s23_q;
  logic equal_1163_s23_q;
  logic [12:0] sum_1164_s23_q;
  logic [12:0] select_1189_s23_q;
  logic [12:0] select_1200_s23_q;
  logic [8:0] select_1205_s23_q;
  logic [8:0] select_1209_s23_q;
  logic not_1260_s23_q;
  logic and_1347_s23_q;
  logic and_1362_s23_q;
  logic and_1367_s23_q;
  logic or_1372_s23_q;
  logic [11:0] select_1381_s23_q;
  logic less_1386_s23_q;
  logic and_1432_s23_q;
  logic equal_1435_s23_q;
  logic equal_1436_s23_q;
  logic equal_1437_s23_q;
  logic [7:0] residual_s23_q;
  logic [1:0] select_1552_s23_q;
  logic [1:0] select_1570_s23_q;
  logic [1:0] select_1634_s23_q;
  logic [1:0] select_1651_s23_q;
  logic [1:0] select_1667_s23_q;
  logic [1:0] select_1683_s23_q;
  logic equal_1754_s23_q;
  logic and_1759_s23_q;
  logic less_1760_s23_q;
  logic [47:0] select_1767_s23_q;
  logic less_1777_s23_q;
  logic [13:0] select_1912_s23_q;
  logic [13:0] select_1917_s23_q;
  logic less_1967_s23_q;
  logic less_1970_s23_q;
  logic or_1973_s23_q;
  logic less_1975_s23_q;
  logic or_1980_s23_q;
  logic less_1981_s23_q;
  logic or_1987_s23_q;
  logic select_1992_s23_q;
  logic less_1993_s23_q;
  logic less_1996_s23_q;
  logic and_2015_s23_q;
  logic select_2017_s23_q;
  logic or_2018_s23_q;
  logic [11:0] select_2104_s23_q;
  logic [11:0] select_2109_s23_q;
  logic [11:0] select_2114_s23_q;
  logic [11:0] select_2119_s23_q;
  logic and_2142_s23_q;
  logic [5:0] select_2147_s23_q;
  logic [11:0] select_2157_s23_q;
  logic [11:0] select_2163_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_s22_q;
      census_changes_values_1_left_s23_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s23_q <= census_changes_values_1_right_q;
      begins_product_s23_q <= begins_product_q;
      done_s23_q <= done_q;
      select_303_s23_q <= select_303_s22_q;
      and_339_s23_q <= and_339_s22_q;
      equal_354_s23_q <= equal_354_s22_q;
      not_355_s23_q <= not_355_s22_q;
      equal_356_s23_q <= equal_356_s22_q;
      less_357_s23_q <= less_357_s22_q;
      not_358_s23_q <= not_358_s22_q;
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
      less_374_s23_q <= less_374_s22_q;
      less_375_s23_q <= less_375_s22_q;
      less_376_s23_q <= less_376_s22_q;
      less_377_s23_q <= less_377_s22_q;
      less_378_s23_q <= less_378_s22_q;
      less_379_s23_q <= less_379_s22_q;
      less_380_s23_q <= less_380_s22_q;
      less_381_s23_q <= less_381_s22_q;
      less_382_s23_q <= less_382_s22_q;
      less_383_s23_q <= less_383_s22_q;
      less_384_s23_q <= less_384_s22_q;
      less_385_s23_q <= less_385_s22_q;
      and_392_s23_q <= and_392_s22_q;
      and_417_s23_q <= whole_22 & and_392_s22_q;
      and_418_s23_q <= and_418_s22_q;
      sum_438_s23_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      x_s23_q <= x_s22_2_q;
      not_499_s23_q <= not_499_s22_q;
      best_left_rdata_s23_q <= best_left_rdata_s22_q;
      equal_504_s23_q <= equal_504_s22_q;
      select_800_s23_q <= select_800_s22_q;
      less_806_s23_q <= less_806_s22_q;
      less_807_s23_q <= less_807_s22_q;
      or_809_s23_q <= or_809_s22_q;
      select_813_s23_q <= select_813_s22_q;
      select_817_s23_q <= select_817_s22_q;
      equal_822_s23_q <= equal_822_s22_q;
      rise_s23_q <= rise_s22_q;
      sum_834_s23_q <= sum_834_s22_q;
      twice_s23_q <= twice_s22_q;
      difference_846_s23_q <= difference_846_s22_q;
      sum_849_s23_q <= sum_849_s22_q[9];
      sum_852_s23_q <= {sum_849_s22_q[8:0], not_850} + {not_850, xor_851, not_850};
      and_866_s23_q <= and_866_s22_q;
      equal_898_s23_q <= equal_898_s22_q;
      equal_899_s23_q <= equal_899_s22_q;
      and_909_s23_q <= and_909_s22_q;
      index_s23_q <= index[2:0];
      sum_961_s23_q <= sum_961;
      and_968_s23_q <= began_q & (seen_x_q == 4'h0);
      less_969_s23_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s23_q <= index_2[2:0];
      sum_974_s23_q <= sum_974;
      t_s23_q <= t;
      or_993_s23_q <= or_993_s22_q;
      select_1004_s23_q <= select_1004;
      e_s23_q <= e;
      less_1034_s23_q <= {1'b0, e[4:1]} < n;
      and_1046_s23_q <= and_1046_s22_q;
      equal_1163_s23_q <= equal_1163_s22_q;
      sum_1164_s23_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1156};
      select_1189_s23_q <= and_1187 ? detail_3[14:2] : 13'h0;
      select_1200_s23_q <= and_1198 ? detail_4[14:2] : 13'h0;
      select_1205_s23_q <= and_1187 ? contrast_s22_q : 9'h0;
      select_1209_s23_q <= and_1198 ? contrast_2_s22_q : 9'h0;
      not_1260_s23_q <= not_1260_s22_q;
      and_1347_s23_q <= and_1347_s22_q;
      and_1362_s23_q <= and_1362_s22_q;
      and_1367_s23_q <= and_1367_s22_q;
      or_1372_s23_q <= or_1372_s22_q;
      select_1381_s23_q <= select_1381_s22_q;
      less_1386_s23_q <= {sum_1385, select_1384_s22_q[1:0]} < {3'h0, select_1381_s22_q};
      and_1432_s23_q <= and_1432_s22_q;
      equal_1435_s23_q <= equal_1435_s22_q;
      equal_1436_s23_q <= equal_1436_s22_q;
      equal_1437_s23_q <= equal_1437_s22_q;
      residual_s23_q <= residual_s22_q;
      select_1552_s23_q <= equal_354_s22_q ? 2'h0 : (equal_356_s22_q ? 2'h0 : select_1550);
      select_1570_s23_q <= select_1570;
      select_1634_s23_q <= drew_s22_q ? select_1633 : 2'h0;
      select_1651_s23_q <= drew_s22_q ? select_1650 : 2'h0;
      select_1667_s23_q <= drew_s22_q ? select_1666 : 2'h0;
      select_1683_s23_q <= drew_s22_q ? select_1682 : 2'h0;
      equal_1754_s23_q <= equal_1754;
      and_1759_s23_q <= and_1759_s22_q;
      less_1760_s23_q <= less_1760_s22_q;
      select_1767_s23_q <= select_1767;
      less_1777_s23_q <= less_1777_s22_q;
      select_1912_s23_q <= select_1912;
      select_1917_s23_q <= select_1917;
      less_1967_s23_q <= less_1967_s22_q;
      less_1970_s23_q <= less_1970_s22_q;
      or_1973_s23_q <= or_1973_s22_q;
      less_1975_s23_q <= less_1975_s22_q;
      or_1980_s23_q <= or_1980_s22_q;
      less_1981_s23_q <= less_1981_s22_q;
      or_1987_s23_q <= or_1987;
      select_1992_s23_q <= less_1967_s22_q ? select_1989 : select_1991;
      less_1993_s23_q <= less_1993_s22_q;
      less_1996_s23_q <= less_1996_s22_q;
      and_2015_s23_q <= and_2015;
      select_2017_s23_q <= select_2017;
      or_2018_s23_q <= or_2018;
      select_2104_s23_q <= select_2104;
      select_2109_s23_q <= select_2109;
      select_2114_s23_q <= select_2114;
      select_2119_s23_q <= select_2119;
      and_2142_s23_q <= and_2142_s22_q;
      select_2147_s23_q <= equal_354_s22_q ? 6'h0 : (equal_356_s22_q ? 6'h0 : select_2145);
      select_2157_s23_q <= select_2157;
      select_2163_s23_q <= select_2163_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [14:0] registration_counts_votes_0_down_q;
  logic [14:0] registration_counts_votes_1_down_q;
  logic [14:0] registration_counts_half_votes_0_down_q;
  logic [14:0] registration_counts_half_votes_1_down_q;
  logic [14:0] registration_counts_half_votes_2_down_q;
  logic [14:0] registration_counts_half_votes_3_down_q;
  logic [47:0] good_q;
  logic [7:0] hidden_for_q;
  logic [7:0] next_hidden_for_q;
  logic [35:0] product_0_q;
  logic [35:0] product_1_q;
  logic [34:0] addend_0_q;
  logic [34:0] addend_1_q;
  logic [17:0] multiplier_0_q;
  logic [17:0] multiplier_1_q;
  // hls/stages/census.hpp:201
  logic [13:0] sum_439;
  assign sum_439 = {2'h0, census_changes_values_1_left_s23_q} + {1'b0, sum_438_s23_q};
  logic [13:0] sum_440;
  assign sum_440 = {2'h0, census_changes_values_2_left_q} + sum_439;
  // hls/stages/registration.hpp:28
  logic not_853;
  assign not_853 = ~sum_852_s23_q[9];
  logic [7:0] xor_854;
  assign xor_854 = twice_s23_q ^ {8{not_853}};
  logic [9:0] sum_855;
  assign sum_855 = {sum_852_s23_q[8:0], not_853} + {not_853, xor_854, not_853};
  logic not_856;
  assign not_856 = ~sum_855[9];
  // hls/stages/agreement.hpp:581
  logic [47:0] select_1005;
  assign select_1005 = or_993_s23_q ? {select_1004_s23_q[23], 1'b0, select_1004_s23_q[22], 1'b0, select_1004_s23_q[21], 1'b0, select_1004_s23_q[20], 1'b0, select_1004_s23_q[19], 1'b0, select_1004_s23_q[18], 1'b0, select_1004_s23_q[17], 1'b0, select_1004_s23_q[16], 1'b0, select_1004_s23_q[15], 1'b0, select_1004_s23_q[14], 1'b0, select_1004_s23_q[13], 1'b0, select_1004_s23_q[12], 1'b0, select_1004_s23_q[11], 1'b0, select_1004_s23_q[10], 1'b0, select_1004_s23_q[9], 1'b0, select_1004_s23_q[8], 1'b0, select_1004_s23_q[7], 1'b0, select_1004_s23_q[6], 1'b0, select_1004_s23_q[5], 1'b0, select_1004_s23_q[4], 1'b0, select_1004_s23_q[3], 1'b0, select_1004_s23_q[2], 1'b0, select_1004_s23_q[1], 1'b0, select_1004_s23_q[0], 1'b0} : {1'b0, select_1004_s23_q[23], 1'b0, select_1004_s23_q[22], 1'b0, select_1004_s23_q[21], 1'b0, select_1004_s23_q[20], 1'b0, select_1004_s23_q[19], 1'b0, select_1004_s23_q[18], 1'b0, select_1004_s23_q[17], 1'b0, select_1004_s23_q[16], 1'b0, select_1004_s23_q[15], 1'b0, select_1004_s23_q[14], 1'b0, select_1004_s23_q[13], 1'b0, select_1004_s23_q[12], 1'b0, select_1004_s23_q[11], 1'b0, select_1004_s23_q[10], 1'b0, select_1004_s23_q[9], 1'b0, select_1004_s23_q[8], 1'b0, select_1004_s23_q[7], 1'b0, select_1004_s23_q[6], 1'b0, select_1004_s23_q[5], 1'b0, select_1004_s23_q[4], 1'b0, select_1004_s23_q[3], 1'b0, select_1004_s23_q[2], 1'b0, select_1004_s23_q[1], 1'b0, select_1004_s23_q[0]};
  // hls/stages/agreement.hpp:582
  logic [5:0] sum_1020;
  assign sum_1020 = {1'b0, e_s23_q} + {2'h0, e_s23_q[4:1]};
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1160;
  assign select_1160 = and_339_s23_q ? census_changes_values_1_left_s23_q : census_changes_values_2_left_q;
  logic [11:0] select_1161;
  assign select_1161 = and_339_s23_q ? census_changes_values_1_right_s23_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [13:0] sum_1165;
  assign sum_1165 = {2'h0, census_changes_values_1_right_s23_q} + {1'b0, sum_1164_s23_q};
  logic [13:0] sum_1166;
  assign sum_1166 = {2'h0, census_changes_values_2_right_q} + sum_1165;
  // hls/stages/census.hpp:277
  logic [23:0] select_1191;
  assign select_1191 = equal_1163_s23_q ? {11'h0, select_1189_s23_q} : (sharpness_sums_detail_0_q + {11'h0, select_1189_s23_q});
  logic [23:0] select_1202;
  assign select_1202 = equal_1163_s23_q ? {11'h0, select_1200_s23_q} : (sharpness_sums_detail_1_q + {11'h0, select_1200_s23_q});
  logic [23:0] sum_1206;
  assign sum_1206 = (equal_1163_s23_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1205_s23_q};
  logic [23:0] sum_1210;
  assign sum_1210 = (equal_1163_s23_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1209_s23_q};
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1553;
  assign sum_1553 = registration_counts_votes_0_down_q + {{13{select_1552_s23_q[1]}}, select_1552_s23_q};
  logic [14:0] sum_1571;
  assign sum_1571 = registration_counts_votes_1_down_q + {{13{select_1570_s23_q[1]}}, select_1570_s23_q};
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1636;
  assign select_1636 = equal_354_s23_q ? 2'h0 : (equal_356_s23_q ? 2'h0 : select_1634_s23_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1637;
  assign sum_1637 = registration_counts_half_votes_0_down_q + {{13{select_1636[1]}}, select_1636};
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1653;
  assign select_1653 = equal_354_s23_q ? 2'h0 : (equal_356_s23_q ? 2'h0 : select_1651_s23_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1654;
  assign sum_1654 = registration_counts_half_votes_1_down_q + {{13{select_1653[1]}}, select_1653};
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1669;
  assign select_1669 = equal_354_s23_q ? 2'h0 : (equal_356_s23_q ? 2'h0 : select_1667_s23_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1670;
  assign sum_1670 = registration_counts_half_votes_2_down_q + {{13{select_1669[1]}}, select_1669};
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1685;
  assign select_1685 = equal_354_s23_q ? 2'h0 : (equal_356_s23_q ? 2'h0 : select_1683_s23_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1686;
  assign sum_1686 = registration_counts_half_votes_3_down_q + {{13{select_1685[1]}}, select_1685};
  // hls/stages/agreement.hpp:299
  logic [47:0] select_1769;
  assign select_1769 = equal_898_s23_q ? (equal_1754_s23_q ? select_1767_s23_q : good_q) : good_q;
  logic [47:0] select_1771;
  assign select_1771 = equal_356_s23_q ? good_q : (begins_product_q ? good_q : select_1769);
  // hls/stages/agreement.hpp:621
  logic [7:0] select_1778;
  assign select_1778 = less_1777_s23_q ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1780;
  assign select_1780 = equal_898_s23_q ? (equal_1754_s23_q ? select_1778 : hidden_for_q) : hidden_for_q;
  logic [7:0] select_1782;
  assign select_1782 = equal_356_s23_q ? hidden_for_q : (begins_product_q ? hidden_for_q : select_1780);
  // hls/stages/agreement.hpp:142
  logic not_1784;
  assign not_1784 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:636
  logic [35:0] select_1795;
  assign select_1795 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:630
  logic [35:0] detail_left;
  assign detail_left = begins_product_s23_q ? 36'h0 : select_1795;
  // hls/stages/agreement.hpp:636
  logic [35:0] select_1798;
  assign select_1798 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:640
  logic [35:0] detail_right;
  assign detail_right = begins_product_s23_q ? 36'h0 : select_1798;
  // hls/stages/agreement.hpp:630
  logic [34:0] select_1800;
  assign select_1800 = begins_product_s23_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:640
  logic [34:0] select_1801;
  assign select_1801 = begins_product_s23_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:630
  logic [17:0] select_1802;
  assign select_1802 = begins_product_s23_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:640
  logic [17:0] select_1803;
  assign select_1803 = begins_product_s23_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:727
  logic and_1896;
  assign and_1896 = and_1046_s23_q & ({sum_974_s23_q, index_2_s23_q} == {sum_961_s23_q, index_s23_q});
  // hls/stages/registration.hpp:104
  logic or_1995;
  assign or_1995 = select_1992_s23_q | (~less_1993_s23_q);
  // hls/stages/registration.hpp:105
  logic select_1997;
  assign select_1997 = or_1995 ? select_1992_s23_q : less_1996_s23_q;
  logic select_1999;
  assign select_1999 = less_1975_s23_q ? select_1997 : (less_1981_s23_q ? select_1997 : less_1996_s23_q);
  // hls/stages/agreement.hpp:623
  logic select_2019;
  assign select_2019 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2018_s23_q : select_2017_s23_q;
  logic select_2020;
  assign select_2020 = (less_1970_s23_q & less_1975_s23_q) ? select_2019 : and_2015_s23_q;
  // hls/stages/registration.hpp:119
  logic less_2022;
  assign less_2022 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  logic less_2025;
  assign less_2025 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2028;
  assign less_2028 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2031;
  assign less_2031 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:623
  logic and_2073;
  assign and_2073 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1778 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:299
  logic [23:0] select_2121;
  assign select_2121 = equal_898_s23_q ? (equal_1754_s23_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2123;
  assign select_2123 = equal_356_s23_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2121);
  logic [23:0] select_2126;
  assign select_2126 = equal_898_s23_q ? (equal_1754_s23_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2128;
  assign select_2128 = equal_356_s23_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2126);

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:801; read in stage 23, written in stage 24: 23 < 24 < 23 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_961_s23_q, index_s23_q};
  logic map_re;
  assign map_re = s23_en & (and_968_s23_q & less_969_s23_q);
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
      registration_counts_votes_0_down_q <= 15'h0;
      registration_counts_votes_1_down_q <= 15'h0;
      registration_counts_half_votes_0_down_q <= 15'h0;
      registration_counts_half_votes_1_down_q <= 15'h0;
      registration_counts_half_votes_2_down_q <= 15'h0;
      registration_counts_half_votes_3_down_q <= 15'h0;
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
      sharpness_sums_detail_0_q <= and_339_s23_q ? select_1191 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_339_s23_q ? select_1202 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_339_s23_q ? sum_1206 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_339_s23_q ? sum_1210 : sharpness_sums_contrast_1_q;
      registration_counts_votes_0_down_q <= and_1347_s23_q ? 15'h0 : sum_1553;
      registration_counts_votes_1_down_q <= and_1347_s23_q ? 15'h0 : sum_1571;
      registration_counts_half_votes_0_down_q <= and_1347_s23_q ? 15'h0 : sum_1637;
      registration_counts_half_votes_1_down_q <= and_1347_s23_q ? 15'h0 : sum_1654;
      registration_counts_half_votes_2_down_q <= and_1347_s23_q ? 15'h0 : sum_1670;
      registration_counts_half_votes_3_down_q <= and_1347_s23_q ? 15'h0 : sum_1686;
      good_q <= equal_354_s23_q ? good_q : select_1771;
      hidden_for_q <= equal_354_s23_q ? hidden_for_q : select_1782;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1784};
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1800;
      addend_1_q <= select_1801;
      multiplier_0_q <= select_1802;
      multiplier_1_q <= select_1803;
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
      census_changes_values_2_left_q <= select_1160;
      census_changes_values_2_right_q <= select_1161;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic census_columns_values_1_cell_2_of_skin_s24_q;
  logic [23:0] sharpness_sums_contrast_0_s24_q;
  logic [23:0] sharpness_sums_contrast_1_s24_q;
  logic done_s24_q;
  logic [6:0] select_303_s24_q;
  logic and_339_s24_q;
  logic equal_354_s24_q;
  logic not_355_s24_q;
  logic equal_356_s24_q;
  logic less_357_s24_q;
  logic not_358_s24_q;
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
  logic less_374_s24_q;
  logic less_375_s24_q;
  logic less_376_s24_q;
  logic less_377_s24_q;
  logic less_378_s24_q;
  logic less_379_s24_q;
  logic less_380_s24_q;
  logic less_381_s24_q;
  logic less_382_s24_q;
  logic less_383_s24_q;
  logic less_384_s24_q;
  logic less_385_s24_q;
  logic and_392_s24_q;
  logic and_417_s24_q;
  logic and_418_s24_q;
  logic [8:0] sum_440_s24_q;
  logic drew_s24_q;
  logic [6:0] x_s24_q;
  logic not_499_s24_q;
  logic [7:0] best_left_rdata_s24_q;
  logic equal_504_s24_q;
  logic select_800_s24_q;
  logic less_806_s24_q;
  logic less_807_s24_q;
  logic or_809_s24_q;
  logic [7:0] select_813_s24_q;
  logic [5:0] select_817_s24_q;
  logic equal_822_s24_q;
  logic rise_s24_q;
  logic [1:0] sum_834_s24_q;
  logic difference_846_s24_q;
  logic sum_849_s24_q;
  logic sum_852_s24_q;
  logic [9:0] sum_855_s24_q;
  logic not_856_s24_q;
  logic [7:0] xor_857_s24_q;
  logic and_866_s24_q;
  logic equal_898_s24_q;
  logic equal_899_s24_q;
  logic and_909_s24_q;
  logic and_968_s24_q;
  logic less_969_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_974_s24_q;
  logic equal_988_s24_q;
  logic not_1008_s24_q;
  logic not_1022_s24_q;
  logic less_1034_s24_q;
  logic and_1046_s24_q;
  logic equal_1163_s24_q;
  logic [8:0] sum_1166_s24_q;
  logic not_1260_s24_q;
  logic and_1347_s24_q;
  logic and_1362_s24_q;
  logic and_1367_s24_q;
  logic or_1372_s24_q;
  logic [11:0] select_1381_s24_q;
  logic and_1387_s24_q;
  logic and_1432_s24_q;
  logic equal_1435_s24_q;
  logic equal_1436_s24_q;
  logic equal_1437_s24_q;
  logic [7:0] residual_s24_q;
  logic equal_1754_s24_q;
  logic and_1759_s24_q;
  logic less_1760_s24_q;
  logic and_1881_s24_q;
  logic and_1896_s24_q;
  logic [13:0] select_1912_s24_q;
  logic [13:0] select_1917_s24_q;
  logic less_1967_s24_q;
  logic less_1968_s24_q;
  logic less_1970_s24_q;
  logic or_1973_s24_q;
  logic less_1975_s24_q;
  logic or_1980_s24_q;
  logic less_1981_s24_q;
  logic or_1987_s24_q;
  logic less_1993_s24_q;
  logic or_1995_s24_q;
  logic select_1997_s24_q;
  logic select_2000_s24_q;
  logic select_2020_s24_q;
  logic less_2022_s24_q;
  logic less_2025_s24_q;
  logic less_2028_s24_q;
  logic less_2031_s24_q;
  logic and_2075_s24_q;
  logic [11:0] select_2104_s24_q;
  logic [11:0] select_2109_s24_q;
  logic [11:0] select_2114_s24_q;
  logic [11:0] select_2119_s24_q;
  logic [23:0] select_2124_s24_q;
  logic [23:0] select_2129_s24_q;
  logic and_2142_s24_q;
  logic [5:0] select_2147_s24_q;
  logic [11:0] select_2157_s24_q;
  logic [11:0] select_2163_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      census_columns_values_1_cell_2_of_skin_s24_q <= census_columns_values_1_cell_2_of_skin_s23_q;
      sharpness_sums_contrast_0_s24_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s24_q <= sharpness_sums_contrast_1_q;
      done_s24_q <= done_s23_q;
      select_303_s24_q <= select_303_s23_q;
      and_339_s24_q <= and_339_s23_q;
      equal_354_s24_q <= equal_354_s23_q;
      not_355_s24_q <= not_355_s23_q;
      equal_356_s24_q <= equal_356_s23_q;
      less_357_s24_q <= less_357_s23_q;
      not_358_s24_q <= not_358_s23_q;
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
      less_374_s24_q <= less_374_s23_q;
      less_375_s24_q <= less_375_s23_q;
      less_376_s24_q <= less_376_s23_q;
      less_377_s24_q <= less_377_s23_q;
      less_378_s24_q <= less_378_s23_q;
      less_379_s24_q <= less_379_s23_q;
      less_380_s24_q <= less_380_s23_q;
      less_381_s24_q <= less_381_s23_q;
      less_382_s24_q <= less_382_s23_q;
      less_383_s24_q <= less_383_s23_q;
      less_384_s24_q <= less_384_s23_q;
      less_385_s24_q <= less_385_s23_q;
      and_392_s24_q <= and_392_s23_q;
      and_417_s24_q <= and_417_s23_q;
      and_418_s24_q <= and_418_s23_q;
      sum_440_s24_q <= sum_440[13:5];
      drew_s24_q <= begins_product_q;
      x_s24_q <= x_s23_q;
      not_499_s24_q <= not_499_s23_q;
      best_left_rdata_s24_q <= best_left_rdata_s23_q;
      equal_504_s24_q <= equal_504_s23_q;
      select_800_s24_q <= select_800_s23_q;
      less_806_s24_q <= less_806_s23_q;
      less_807_s24_q <= less_807_s23_q;
      or_809_s24_q <= or_809_s23_q;
      select_813_s24_q <= select_813_s23_q;
      select_817_s24_q <= select_817_s23_q;
      equal_822_s24_q <= equal_822_s23_q;
      rise_s24_q <= rise_s23_q;
      sum_834_s24_q <= sum_834_s23_q;
      difference_846_s24_q <= difference_846_s23_q;
      sum_849_s24_q <= sum_849_s23_q;
      sum_852_s24_q <= sum_852_s23_q[9];
      sum_855_s24_q <= sum_855;
      not_856_s24_q <= not_856;
      xor_857_s24_q <= twice_s23_q ^ {8{not_856}};
      and_866_s24_q <= and_866_s23_q;
      equal_898_s24_q <= equal_898_s23_q;
      equal_899_s24_q <= equal_899_s23_q;
      and_909_s24_q <= and_909_s23_q;
      and_968_s24_q <= and_968_s23_q;
      less_969_s24_q <= less_969_s23_q;
      index_2_s24_q <= index_2_s23_q;
      sum_974_s24_q <= sum_974_s23_q;
      equal_988_s24_q <= t_s23_q[4:1] == 4'h0;
      not_1008_s24_q <= ~((good_q & select_1005) == 48'h0);
      not_1022_s24_q <= ~({sum_1020, e_s23_q[0]} < {2'h0, t_s23_q});
      less_1034_s24_q <= less_1034_s23_q;
      and_1046_s24_q <= and_1046_s23_q;
      equal_1163_s24_q <= equal_1163_s23_q;
      sum_1166_s24_q <= sum_1166[13:5];
      not_1260_s24_q <= not_1260_s23_q;
      and_1347_s24_q <= and_1347_s23_q;
      and_1362_s24_q <= and_1362_s23_q;
      and_1367_s24_q <= and_1367_s23_q;
      or_1372_s24_q <= or_1372_s23_q;
      select_1381_s24_q <= select_1381_s23_q;
      and_1387_s24_q <= (~(select_1381_s23_q[11:4] == 8'h0)) & less_1386_s23_q;
      and_1432_s24_q <= and_1432_s23_q;
      equal_1435_s24_q <= equal_1435_s23_q;
      equal_1436_s24_q <= equal_1436_s23_q;
      equal_1437_s24_q <= equal_1437_s23_q;
      residual_s24_q <= residual_s23_q;
      equal_1754_s24_q <= equal_1754_s23_q;
      and_1759_s24_q <= and_1759_s23_q;
      less_1760_s24_q <= less_1760_s23_q;
      and_1881_s24_q <= said_q;
      and_1896_s24_q <= and_1896;
      select_1912_s24_q <= select_1912_s23_q;
      select_1917_s24_q <= select_1917_s23_q;
      less_1967_s24_q <= less_1967_s23_q;
      less_1968_s24_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_1970_s24_q <= less_1970_s23_q;
      or_1973_s24_q <= or_1973_s23_q;
      less_1975_s24_q <= less_1975_s23_q;
      or_1980_s24_q <= or_1980_s23_q;
      less_1981_s24_q <= less_1981_s23_q;
      or_1987_s24_q <= or_1987_s23_q;
      less_1993_s24_q <= less_1993_s23_q;
      or_1995_s24_q <= or_1995;
      select_1997_s24_q <= select_1997;
      select_2000_s24_q <= less_1970_s23_q ? select_1997 : select_1999;
      select_2020_s24_q <= select_2020;
      less_2022_s24_q <= less_2022;
      less_2025_s24_q <= less_2025;
      less_2028_s24_q <= less_2028;
      less_2031_s24_q <= less_2031;
      and_2075_s24_q <= equal_1754_s23_q & (cfg_prove_i & and_2073);
      select_2104_s24_q <= select_2104_s23_q;
      select_2109_s24_q <= select_2109_s23_q;
      select_2114_s24_q <= select_2114_s23_q;
      select_2119_s24_q <= select_2119_s23_q;
      select_2124_s24_q <= equal_354_s23_q ? 24'h0 : select_2123;
      select_2129_s24_q <= equal_354_s23_q ? 24'h0 : select_2128;
      and_2142_s24_q <= and_2142_s23_q;
      select_2147_s24_q <= select_2147_s23_q;
      select_2157_s24_q <= select_2157_s23_q;
      select_2163_s24_q <= select_2163_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic proven_q;
  // hls/stages/registration.hpp:28
  logic [9:0] sum_858;
  assign sum_858 = {sum_855_s24_q[8:0], not_856_s24_q} + {not_856_s24_q, xor_857_s24_q, not_856_s24_q};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_859;
  assign difference_859 = {sum_834_s24_q, select_800_s24_q, 5'h0} - {3'h0, difference_846_s24_q, sum_849_s24_q, sum_852_s24_q, sum_855_s24_q[9], sum_858[9]};
  // hls/stages/agreement.hpp:582
  logic is_seen;
  assign is_seen = equal_988_s24_q ? not_1008_s24_q : not_1022_s24_q;
  // hls/stages/agreement.hpp:590
  logic and_1035;
  assign and_1035 = is_seen & less_1034_s24_q;
  // hls/stages/agreement.hpp:584
  logic or_1373;
  assign or_1373 = is_seen | or_1372_s24_q;
  // hls/stages/agreement.hpp:619
  logic [11:0] select_1389;
  assign select_1389 = equal_899_s24_q ? 12'h0 : (and_1387_s24_q ? select_1381_s24_q : 12'h0);
  // hls/stages/agreement.hpp:299
  logic [11:0] select_1390;
  assign select_1390 = equal_898_s24_q ? select_1389 : 12'h0;
  logic [11:0] select_1393;
  assign select_1393 = equal_354_s24_q ? 12'h0 : (equal_356_s24_q ? 12'h0 : (drew_s24_q ? 12'h0 : select_1390));
  // hls/stages/agreement.hpp:165
  logic [8:0] select_1405;
  assign select_1405 = less_357_s24_q ? 9'h0 : (and_909_s24_q ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0);
  // hls/stages/agreement.hpp:299
  logic [20:0] select_1406;
  assign select_1406 = drew_s24_q ? {{12{select_1405[8]}}, select_1405} : {1'b0, select_1390, 8'h0};
  logic [20:0] select_1408;
  assign select_1408 = equal_354_s24_q ? 21'h0 : (equal_356_s24_q ? 21'h0 : select_1406);
  // hls/stages/agreement.hpp:530
  logic [8:0] select_1412;
  assign select_1412 = and_909_s24_q ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1413;
  assign select_1413 = less_357_s24_q ? 8'h0 : select_1412[7:0];
  // hls/stages/agreement.hpp:165
  logic and_1414;
  assign and_1414 = not_358_s24_q & select_1412[8];
  // hls/stages/agreement.hpp:588
  logic [2:0] select_1416;
  assign select_1416 = or_1373 ? {3{and_1414}} : ({3{and_1414}} + 3'h1);
  // hls/stages/agreement.hpp:299
  logic and_1941;
  assign and_1941 = equal_898_s24_q & (equal_1754_s24_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:623
  logic or_2021;
  assign or_2021 = (less_1967_s24_q ? select_1997_s24_q : select_2000_s24_q) | select_2020_s24_q;
  logic or_2023;
  assign or_2023 = less_2022_s24_q | or_2021;
  logic select_2024;
  assign select_2024 = or_1995_s24_q ? or_2021 : or_2023;
  logic or_2026;
  assign or_2026 = less_2025_s24_q | select_2024;
  logic select_2036;
  assign select_2036 = less_1981_s24_q ? or_2026 : (less_1993_s24_q ? or_2023 : select_2020_s24_q);
  // hls/stages/agreement.hpp:299
  logic and_2078;
  assign and_2078 = not_499_s24_q & (not_1260_s24_q & (equal_898_s24_q & and_2075_s24_q));
  logic [11:0] select_2149;
  assign select_2149 = equal_898_s24_q ? (equal_899_s24_q ? 12'h0 : select_1381_s24_q) : 12'h0;
  logic [11:0] select_2152;
  assign select_2152 = equal_354_s24_q ? 12'h0 : (equal_356_s24_q ? 12'h0 : (drew_s24_q ? 12'h0 : select_2149));

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_974_s24_q, index_2_s24_q};
  logic map_we;
  assign map_we = s24_en & and_1046_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1035, is_seen};
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
  logic census_columns_values_1_cell_2_of_skin_s25_q;
  logic [23:0] sharpness_sums_contrast_0_s25_q;
  logic [23:0] sharpness_sums_contrast_1_s25_q;
  logic [6:0] select_303_s25_q;
  logic and_339_s25_q;
  logic equal_354_s25_q;
  logic not_355_s25_q;
  logic equal_356_s25_q;
  logic less_357_s25_q;
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
  logic less_374_s25_q;
  logic less_375_s25_q;
  logic less_376_s25_q;
  logic less_377_s25_q;
  logic less_378_s25_q;
  logic less_379_s25_q;
  logic less_380_s25_q;
  logic less_381_s25_q;
  logic less_382_s25_q;
  logic less_383_s25_q;
  logic less_384_s25_q;
  logic less_385_s25_q;
  logic and_392_s25_q;
  logic and_417_s25_q;
  logic and_418_s25_q;
  logic less_441_s25_q;
  logic drew_s25_q;
  logic [6:0] x_s25_q;
  logic not_499_s25_q;
  logic [7:0] best_left_rdata_s25_q;
  logic equal_504_s25_q;
  logic select_800_s25_q;
  logic less_806_s25_q;
  logic less_807_s25_q;
  logic or_809_s25_q;
  logic [7:0] select_813_s25_q;
  logic [5:0] select_817_s25_q;
  logic equal_822_s25_q;
  logic rise_s25_q;
  logic [1:0] sum_834_s25_q;
  logic difference_846_s25_q;
  logic sum_849_s25_q;
  logic sum_852_s25_q;
  logic sum_855_s25_q;
  logic sum_858_s25_q;
  logic [7:0] difference_859_s25_q;
  logic and_866_s25_q;
  logic equal_898_s25_q;
  logic and_968_s25_q;
  logic less_969_s25_q;
  logic [1:0] map_rdata_s25_q;
  logic is_seen_s25_q;
  logic and_1035_s25_q;
  logic equal_1163_s25_q;
  logic and_1168_s25_q;
  logic not_1260_s25_q;
  logic and_1347_s25_q;
  logic and_1362_s25_q;
  logic and_1367_s25_q;
  logic and_1377_s25_q;
  logic [11:0] select_1393_s25_q;
  logic [20:0] select_1408_s25_q;
  logic [10:0] select_1417_s25_q;
  logic and_1432_s25_q;
  logic equal_1435_s25_q;
  logic equal_1436_s25_q;
  logic equal_1437_s25_q;
  logic [7:0] residual_s25_q;
  logic equal_1754_s25_q;
  logic and_1759_s25_q;
  logic less_1760_s25_q;
  logic [35:0] detail_left_s25_q;
  logic [35:0] detail_right_s25_q;
  logic and_1881_s25_q;
  logic and_1896_s25_q;
  logic [13:0] select_1912_s25_q;
  logic [13:0] select_1917_s25_q;
  logic and_1944_s25_q;
  logic less_1967_s25_q;
  logic less_1968_s25_q;
  logic less_1970_s25_q;
  logic or_1973_s25_q;
  logic less_1975_s25_q;
  logic or_1980_s25_q;
  logic select_2027_s25_q;
  logic less_2028_s25_q;
  logic less_2031_s25_q;
  logic select_2036_s25_q;
  logic [36:0] sum_2047_s25_q;
  logic [36:0] sum_2059_s25_q;
  logic and_2079_s25_q;
  logic [11:0] select_2104_s25_q;
  logic [11:0] select_2109_s25_q;
  logic [11:0] select_2114_s25_q;
  logic [11:0] select_2119_s25_q;
  logic [23:0] select_2124_s25_q;
  logic [23:0] select_2129_s25_q;
  logic and_2142_s25_q;
  logic [5:0] select_2147_s25_q;
  logic [11:0] select_2152_s25_q;
  logic [11:0] select_2157_s25_q;
  logic [11:0] select_2163_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      census_columns_values_1_cell_2_of_skin_s25_q <= census_columns_values_1_cell_2_of_skin_s24_q;
      sharpness_sums_contrast_0_s25_q <= sharpness_sums_contrast_0_s24_q;
      sharpness_sums_contrast_1_s25_q <= sharpness_sums_contrast_1_s24_q;
      select_303_s25_q <= select_303_s24_q;
      and_339_s25_q <= and_339_s24_q;
      equal_354_s25_q <= equal_354_s24_q;
      not_355_s25_q <= not_355_s24_q;
      equal_356_s25_q <= equal_356_s24_q;
      less_357_s25_q <= less_357_s24_q;
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
      less_374_s25_q <= less_374_s24_q;
      less_375_s25_q <= less_375_s24_q;
      less_376_s25_q <= less_376_s24_q;
      less_377_s25_q <= less_377_s24_q;
      less_378_s25_q <= less_378_s24_q;
      less_379_s25_q <= less_379_s24_q;
      less_380_s25_q <= less_380_s24_q;
      less_381_s25_q <= less_381_s24_q;
      less_382_s25_q <= less_382_s24_q;
      less_383_s25_q <= less_383_s24_q;
      less_384_s25_q <= less_384_s24_q;
      less_385_s25_q <= less_385_s24_q;
      and_392_s25_q <= and_392_s24_q;
      and_417_s25_q <= and_417_s24_q;
      and_418_s25_q <= and_418_s24_q;
      less_441_s25_q <= 9'h4 < sum_440_s24_q;
      drew_s25_q <= drew_s24_q;
      x_s25_q <= x_s24_q;
      not_499_s25_q <= not_499_s24_q;
      best_left_rdata_s25_q <= best_left_rdata_s24_q;
      equal_504_s25_q <= equal_504_s24_q;
      select_800_s25_q <= select_800_s24_q;
      less_806_s25_q <= less_806_s24_q;
      less_807_s25_q <= less_807_s24_q;
      or_809_s25_q <= or_809_s24_q;
      select_813_s25_q <= select_813_s24_q;
      select_817_s25_q <= select_817_s24_q;
      equal_822_s25_q <= equal_822_s24_q;
      rise_s25_q <= rise_s24_q;
      sum_834_s25_q <= sum_834_s24_q;
      difference_846_s25_q <= difference_846_s24_q;
      sum_849_s25_q <= sum_849_s24_q;
      sum_852_s25_q <= sum_852_s24_q;
      sum_855_s25_q <= sum_855_s24_q[9];
      sum_858_s25_q <= sum_858[9];
      difference_859_s25_q <= difference_859;
      and_866_s25_q <= and_866_s24_q;
      equal_898_s25_q <= equal_898_s24_q;
      and_968_s25_q <= and_968_s24_q;
      less_969_s25_q <= less_969_s24_q;
      map_rdata_s25_q <= map_rdata_q;
      is_seen_s25_q <= is_seen;
      and_1035_s25_q <= and_1035;
      equal_1163_s25_q <= equal_1163_s24_q;
      and_1168_s25_q <= and_417_s24_q & (9'h4 < sum_1166_s24_q);
      not_1260_s25_q <= not_1260_s24_q;
      and_1347_s25_q <= and_1347_s24_q;
      and_1362_s25_q <= and_1362_s24_q;
      and_1367_s25_q <= and_1367_s24_q;
      and_1377_s25_q <= not_355_s24_q & (not_499_s24_q & (drew_s24_q & (~or_1373)));
      select_1393_s25_q <= select_1393;
      select_1408_s25_q <= select_1408;
      select_1417_s25_q <= drew_s24_q ? {select_1416, select_1413} : 11'h0;
      and_1432_s25_q <= and_1432_s24_q;
      equal_1435_s25_q <= equal_1435_s24_q;
      equal_1436_s25_q <= equal_1436_s24_q;
      equal_1437_s25_q <= equal_1437_s24_q;
      residual_s25_q <= residual_s24_q;
      equal_1754_s25_q <= equal_1754_s24_q;
      and_1759_s25_q <= and_1759_s24_q;
      less_1760_s25_q <= less_1760_s24_q;
      detail_left_s25_q <= product_0_q;
      detail_right_s25_q <= product_1_q;
      and_1881_s25_q <= and_1881_s24_q;
      and_1896_s25_q <= and_1896_s24_q;
      select_1912_s25_q <= select_1912_s24_q;
      select_1917_s25_q <= select_1917_s24_q;
      and_1944_s25_q <= not_355_s24_q & (not_499_s24_q & (not_1260_s24_q & and_1941));
      less_1967_s25_q <= less_1967_s24_q;
      less_1968_s25_q <= less_1968_s24_q;
      less_1970_s25_q <= less_1970_s24_q;
      or_1973_s25_q <= or_1973_s24_q;
      less_1975_s25_q <= less_1975_s24_q;
      or_1980_s25_q <= or_1980_s24_q;
      select_2027_s25_q <= or_1987_s24_q ? select_2024 : or_2026;
      less_2028_s25_q <= less_2028_s24_q;
      less_2031_s25_q <= less_2031_s24_q;
      select_2036_s25_q <= select_2036;
      sum_2047_s25_q <= {1'b0, product_1_q} + {3'h0, product_1_q[35:2]};
      sum_2059_s25_q <= {1'b0, product_0_q} + {3'h0, product_0_q[35:2]};
      and_2079_s25_q <= not_355_s24_q & and_2078;
      select_2104_s25_q <= select_2104_s24_q;
      select_2109_s25_q <= select_2109_s24_q;
      select_2114_s25_q <= select_2114_s24_q;
      select_2119_s25_q <= select_2119_s24_q;
      select_2124_s25_q <= select_2124_s24_q;
      select_2129_s25_q <= select_2129_s24_q;
      and_2142_s25_q <= and_2142_s24_q;
      select_2147_s25_q <= select_2147_s24_q;
      select_2152_s25_q <= select_2152;
      select_2157_s25_q <= select_2157_s24_q;
      select_2163_s25_q <= select_2163_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [23:0] counts_too_many_bad_q;
  logic [23:0] counts_too_much_unproven_q;
  // hls/stages/census.hpp:223
  logic and_442;
  assign and_442 = and_392_s25_q & less_441_s25_q;
  // hls/stages/agreement.hpp:428
  logic [7:0] select_860;
  assign select_860 = rise_s25_q ? difference_859_s25_q : {sum_834_s25_q, select_800_s25_q, difference_846_s25_q, sum_849_s25_q, sum_852_s25_q, sum_855_s25_q, sum_858_s25_q};
  logic [7:0] select_861;
  assign select_861 = equal_822_s25_q ? select_860 : {sum_834_s25_q, select_800_s25_q, 5'h0};
  // hls/stages/agreement.hpp:430
  logic [7:0] select_864;
  assign select_864 = less_806_s25_q ? (or_809_s25_q ? select_861 : best_left_rdata_s25_q) : (less_807_s25_q ? select_861 : best_left_rdata_s25_q);
  // hls/stages/census.hpp:226
  logic and_1169;
  assign and_1169 = and_417_s25_q & less_441_s25_q;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1170;
  assign sum_1170 = census_left_misses_q + {{17{and_1169}}, and_1168_s25_q, 1'b0, and_1168_s25_q};
  // hls/stages/agreement.hpp:176
  logic [19:0] select_1172;
  assign select_1172 = and_339_s25_q ? (equal_1163_s25_q ? 20'h0 : sum_1170) : census_left_misses_q;
  // hls/stages/agreement.hpp:481
  logic [23:0] sum_1409;
  assign sum_1409 = counts_too_many_bad_q + {{3{select_1408_s25_q[20]}}, select_1408_s25_q};
  // hls/stages/agreement.hpp:299
  logic [10:0] select_1419;
  assign select_1419 = equal_354_s25_q ? 11'h0 : (equal_356_s25_q ? 11'h0 : select_1417_s25_q);
  // hls/stages/agreement.hpp:482
  logic [23:0] sum_1420;
  assign sum_1420 = counts_too_much_unproven_q + {{13{select_1419[10]}}, select_1419};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1475;
  assign select_1475 = equal_1436_s25_q ? 8'h0 : (equal_1437_s25_q ? 8'h0 : residual_s25_q);
  // hls/stages/agreement.hpp:165
  logic [7:0] select_1478;
  assign select_1478 = less_357_s25_q ? 8'h0 : (and_1432_s25_q ? (equal_1435_s25_q ? 8'h0 : select_1475) : 8'h0);
  // hls/stages/registration.hpp:80
  logic [7:0] select_1485;
  assign select_1485 = equal_1436_s25_q ? 8'h0 : (equal_1437_s25_q ? residual_s25_q : 8'h0);
  // hls/stages/agreement.hpp:165
  logic [7:0] select_1488;
  assign select_1488 = less_357_s25_q ? 8'h0 : (and_1432_s25_q ? (equal_1435_s25_q ? 8'h0 : select_1485) : 8'h0);
  // hls/stages/registration.hpp:80
  logic [7:0] select_1495;
  assign select_1495 = equal_1435_s25_q ? 8'h0 : (equal_1436_s25_q ? residual_s25_q : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1498;
  assign select_1498 = drew_s25_q ? (less_357_s25_q ? 8'h0 : (and_1432_s25_q ? select_1495 : 8'h0)) : 8'h0;
  // hls/stages/agreement.hpp:165
  logic [7:0] select_1504;
  assign select_1504 = and_1432_s25_q ? (equal_1435_s25_q ? residual_s25_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1507;
  assign select_1507 = equal_356_s25_q ? 8'h0 : (drew_s25_q ? (less_357_s25_q ? 8'h0 : select_1504) : 8'h0);
  // hls/stages/agreement.hpp:727
  logic [1:0] select_1897;
  assign select_1897 = and_1896_s25_q ? {and_1035_s25_q, is_seen_s25_q} : map_rdata_s25_q;
  // hls/stages/agreement.hpp:728
  logic and_1898;
  assign and_1898 = proven_q & less_1886;
  // hls/stages/agreement.hpp:656
  logic not_1945;
  assign not_1945 = ~and_1759_s25_q;
  // hls/stages/agreement.hpp:299
  logic and_1949;
  assign and_1949 = not_1260_s25_q & (equal_898_s25_q & (equal_1754_s25_q & (cfg_prove_i & not_1945)));
  // hls/stages/agreement.hpp:657
  logic or_1952;
  assign or_1952 = not_1905 | not_1945;
  // hls/stages/agreement.hpp:623
  logic or_1957;
  assign or_1957 = ($signed(24'h0) < $signed(counts_too_many_bad_q)) | ($signed(24'h0) < $signed(counts_too_much_unproven_q));
  logic or_2029;
  assign or_2029 = less_2028_s25_q | select_2027_s25_q;
  logic select_2030;
  assign select_2030 = or_1980_s25_q ? select_2027_s25_q : or_2029;
  logic or_2032;
  assign or_2032 = less_2031_s25_q | select_2030;
  logic select_2038;
  assign select_2038 = less_1970_s25_q ? or_2032 : (less_1975_s25_q ? or_2029 : select_2036_s25_q);
  logic select_2039;
  assign select_2039 = less_1967_s25_q ? (less_1968_s25_q | (or_1973_s25_q ? select_2030 : or_2032)) : select_2038;
  // hls/stages/agreement.hpp:663
  logic and_2046;
  assign and_2046 = cfg_prove_i & and_1759_s25_q;
  // hls/stages/agreement.hpp:664
  logic less_2048;
  assign less_2048 = {detail_left_s25_q, 3'h0} < {sum_2047_s25_q, detail_right_s25_q[1:0]};
  logic less_2049;
  assign less_2049 = {sharpness_sums_contrast_0_s25_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_s25_q};
  // hls/stages/agreement.hpp:623
  logic or_2052;
  assign or_2052 = less_2048 | (less_2049 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:667
  logic less_2060;
  assign less_2060 = {detail_right_s25_q, 3'h0} < {sum_2059_s25_q, detail_left_s25_q[1:0]};
  logic less_2061;
  assign less_2061 = {sharpness_sums_contrast_1_s25_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_s25_q};
  // hls/stages/agreement.hpp:299
  logic [23:0] select_2131;
  assign select_2131 = equal_898_s25_q ? (equal_1754_s25_q ? sharpness_sums_contrast_0_s25_q : 24'h0) : 24'h0;
  logic [23:0] select_2134;
  assign select_2134 = equal_354_s25_q ? 24'h0 : (equal_356_s25_q ? 24'h0 : (drew_s25_q ? 24'h0 : select_2131));
  logic [23:0] select_2136;
  assign select_2136 = equal_898_s25_q ? (equal_1754_s25_q ? sharpness_sums_contrast_1_s25_q : 24'h0) : 24'h0;
  logic [23:0] select_2139;
  assign select_2139 = equal_354_s25_q ? 24'h0 : (equal_356_s25_q ? 24'h0 : (drew_s25_q ? 24'h0 : select_2136));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = select_303_s25_q;
  logic fresh_we;
  assign fresh_we = s25_en & and_339_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s25_q, and_442, and_418_s25_q, and_417_s25_q, and_392_s25_q, less_385_s25_q, less_384_s25_q, less_383_s25_q, less_382_s25_q, less_381_s25_q, less_380_s25_q, less_379_s25_q, less_378_s25_q, less_377_s25_q, less_376_s25_q, less_375_s25_q, less_374_s25_q, less_373_s25_q, less_372_s25_q, less_371_s25_q, less_370_s25_q, less_369_s25_q, less_368_s25_q, less_367_s25_q, less_366_s25_q, less_365_s25_q, less_364_s25_q, less_363_s25_q, less_362_s25_q};
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
    end else if (s25_en) begin
      census_left_misses_q <= select_1172;
      counts_too_many_bad_q <= and_1347_s25_q ? 24'h0 : sum_1409;
      counts_too_much_unproven_q <= and_1347_s25_q ? 24'h0 : sum_1420;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic equal_354_s26_q;
  logic not_355_s26_q;
  logic equal_356_s26_q;
  logic drew_s26_q;
  logic [6:0] x_s26_q;
  logic not_499_s26_q;
  logic [7:0] select_813_s26_q;
  logic [5:0] select_817_s26_q;
  logic [7:0] select_865_s26_q;
  logic and_866_s26_q;
  logic equal_898_s26_q;
  logic and_968_s26_q;
  logic less_969_s26_q;
  logic not_1260_s26_q;
  logic and_1347_s26_q;
  logic and_1362_s26_q;
  logic and_1367_s26_q;
  logic and_1377_s26_q;
  logic [11:0] select_1393_s26_q;
  logic [7:0] select_1480_s26_q;
  logic [7:0] select_1490_s26_q;
  logic [7:0] select_1500_s26_q;
  logic [7:0] select_1508_s26_q;
  logic equal_1754_s26_q;
  logic and_1881_s26_q;
  logic and_1899_s26_q;
  logic and_1902_s26_q;
  logic [13:0] select_1912_s26_q;
  logic [13:0] select_1917_s26_q;
  logic and_1944_s26_q;
  logic and_1951_s26_q;
  logic select_1958_s26_q;
  logic select_2039_s26_q;
  logic and_2053_s26_q;
  logic and_2063_s26_q;
  logic and_2079_s26_q;
  logic [11:0] select_2104_s26_q;
  logic [11:0] select_2109_s26_q;
  logic [11:0] select_2114_s26_q;
  logic [11:0] select_2119_s26_q;
  logic [23:0] select_2124_s26_q;
  logic [23:0] select_2129_s26_q;
  logic [23:0] select_2134_s26_q;
  logic [23:0] select_2139_s26_q;
  logic and_2142_s26_q;
  logic [5:0] select_2147_s26_q;
  logic [11:0] select_2152_s26_q;
  logic [11:0] select_2157_s26_q;
  logic [11:0] select_2163_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      equal_354_s26_q <= equal_354_s25_q;
      not_355_s26_q <= not_355_s25_q;
      equal_356_s26_q <= equal_356_s25_q;
      drew_s26_q <= drew_s25_q;
      x_s26_q <= x_s25_q;
      not_499_s26_q <= not_499_s25_q;
      select_813_s26_q <= select_813_s25_q;
      select_817_s26_q <= select_817_s25_q;
      select_865_s26_q <= equal_504_s25_q ? select_861 : select_864;
      and_866_s26_q <= and_866_s25_q;
      equal_898_s26_q <= equal_898_s25_q;
      and_968_s26_q <= and_968_s25_q;
      less_969_s26_q <= less_969_s25_q;
      not_1260_s26_q <= not_1260_s25_q;
      and_1347_s26_q <= and_1347_s25_q;
      and_1362_s26_q <= and_1362_s25_q;
      and_1367_s26_q <= and_1367_s25_q;
      and_1377_s26_q <= and_1377_s25_q;
      select_1393_s26_q <= select_1393_s25_q;
      select_1480_s26_q <= equal_356_s25_q ? 8'h0 : (drew_s25_q ? select_1478 : 8'h0);
      select_1490_s26_q <= equal_356_s25_q ? 8'h0 : (drew_s25_q ? select_1488 : 8'h0);
      select_1500_s26_q <= equal_354_s25_q ? 8'h0 : (equal_356_s25_q ? 8'h0 : select_1498);
      select_1508_s26_q <= equal_354_s25_q ? 8'h0 : select_1507;
      equal_1754_s26_q <= equal_1754_s25_q;
      and_1881_s26_q <= and_1881_s25_q;
      and_1899_s26_q <= select_1897[0] & and_1898;
      and_1902_s26_q <= select_1897[1] & and_1898;
      select_1912_s26_q <= select_1912_s25_q;
      select_1917_s26_q <= select_1917_s25_q;
      and_1944_s26_q <= and_1944_s25_q;
      and_1951_s26_q <= not_355_s25_q & (not_499_s25_q & and_1949);
      select_1958_s26_q <= (less_1760_s25_q | or_1952) ? (~or_1952) : or_1957;
      select_2039_s26_q <= select_2039;
      and_2053_s26_q <= and_2046 & or_2052;
      and_2063_s26_q <= and_2046 & (less_2060 | less_2061);
      and_2079_s26_q <= and_2079_s25_q;
      select_2104_s26_q <= select_2104_s25_q;
      select_2109_s26_q <= select_2109_s25_q;
      select_2114_s26_q <= select_2114_s25_q;
      select_2119_s26_q <= select_2119_s25_q;
      select_2124_s26_q <= select_2124_s25_q;
      select_2129_s26_q <= select_2129_s25_q;
      select_2134_s26_q <= select_2134;
      select_2139_s26_q <= select_2139;
      and_2142_s26_q <= and_2142_s25_q;
      select_2147_s26_q <= select_2147_s25_q;
      select_2152_s26_q <= select_2152_s25_q;
      select_2157_s26_q <= select_2157_s25_q;
      select_2163_s26_q <= select_2163_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic [13:0] counts_explained_q;
  logic [13:0] counts_nearer_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [19:0] registration_counts_across_0_q;
  logic [19:0] registration_counts_across_1_q;
  logic [19:0] registration_counts_across_2_q;
  logic [19:0] registration_counts_across_3_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/agreement.hpp:484
  logic [13:0] select_1364;
  assign select_1364 = and_1347_s26_q ? 14'h0 : (counts_explained_q + {13'h0, and_1362_s26_q});
  logic [13:0] select_1369;
  assign select_1369 = and_1347_s26_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1367_s26_q});
  logic [13:0] select_1379;
  assign select_1379 = and_1347_s26_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1377_s26_q});
  logic [13:0] select_1395;
  assign select_1395 = and_1347_s26_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1393_s26_q});
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1481;
  assign select_1481 = equal_354_s26_q ? 8'h0 : select_1480_s26_q;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1482;
  assign sum_1482 = registration_counts_across_0_q + {{12{select_1481[7]}}, select_1481};
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1491;
  assign select_1491 = equal_354_s26_q ? 8'h0 : select_1490_s26_q;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1492;
  assign sum_1492 = registration_counts_across_1_q + {{12{select_1491[7]}}, select_1491};
  logic [19:0] sum_1501;
  assign sum_1501 = registration_counts_across_2_q + {{12{select_1500_s26_q[7]}}, select_1500_s26_q};
  logic [19:0] sum_1509;
  assign sum_1509 = registration_counts_across_3_q + {{12{select_1508_s26_q[7]}}, select_1508_s26_q};
  // hls/stages/agreement.hpp:179
  logic select_1901;
  assign select_1901 = and_968_s26_q ? (less_969_s26_q ? and_1899_s26_q : seen_q) : seen_q;
  logic select_1904;
  assign select_1904 = and_968_s26_q ? (less_969_s26_q ? and_1902_s26_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:299
  logic [13:0] select_1919;
  assign select_1919 = equal_898_s26_q ? (equal_1754_s26_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_1922;
  assign select_1922 = equal_354_s26_q ? 14'h0 : (equal_356_s26_q ? 14'h0 : (drew_s26_q ? 14'h0 : select_1919));
  logic [13:0] select_1924;
  assign select_1924 = equal_898_s26_q ? (equal_1754_s26_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_1927;
  assign select_1927 = equal_354_s26_q ? 14'h0 : (equal_356_s26_q ? 14'h0 : (drew_s26_q ? 14'h0 : select_1924));
  logic [13:0] select_1929;
  assign select_1929 = equal_898_s26_q ? (equal_1754_s26_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_1932;
  assign select_1932 = equal_354_s26_q ? 14'h0 : (equal_356_s26_q ? 14'h0 : (drew_s26_q ? 14'h0 : select_1929));
  logic [13:0] select_1934;
  assign select_1934 = equal_898_s26_q ? (equal_1754_s26_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic [13:0] select_1937;
  assign select_1937 = equal_354_s26_q ? 14'h0 : (equal_356_s26_q ? 14'h0 : (drew_s26_q ? 14'h0 : select_1934));
  logic and_1961;
  assign and_1961 = not_1260_s26_q & (equal_898_s26_q & (equal_1754_s26_q & select_1958_s26_q));
  logic and_2042;
  assign and_2042 = equal_898_s26_q & (equal_1754_s26_q & (cfg_prove_i & select_2039_s26_q));
  logic and_2056;
  assign and_2056 = not_1260_s26_q & (equal_898_s26_q & (equal_1754_s26_q & and_2053_s26_q));
  logic and_2066;
  assign and_2066 = not_1260_s26_q & (equal_898_s26_q & (equal_1754_s26_q & and_2063_s26_q));
  logic [19:0] select_2081;
  assign select_2081 = equal_898_s26_q ? (equal_1754_s26_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2084;
  assign select_2084 = equal_354_s26_q ? 20'h0 : (equal_356_s26_q ? 20'h0 : (drew_s26_q ? 20'h0 : select_2081));
  logic [19:0] select_2086;
  assign select_2086 = equal_898_s26_q ? (equal_1754_s26_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2089;
  assign select_2089 = equal_354_s26_q ? 20'h0 : (equal_356_s26_q ? 20'h0 : (drew_s26_q ? 20'h0 : select_2086));
  logic [19:0] select_2091;
  assign select_2091 = equal_898_s26_q ? (equal_1754_s26_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2094;
  assign select_2094 = equal_354_s26_q ? 20'h0 : (equal_356_s26_q ? 20'h0 : (drew_s26_q ? 20'h0 : select_2091));
  logic [19:0] select_2096;
  assign select_2096 = equal_898_s26_q ? (equal_1754_s26_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [19:0] select_2099;
  assign select_2099 = equal_354_s26_q ? 20'h0 : (equal_356_s26_q ? 20'h0 : (drew_s26_q ? 20'h0 : select_2096));

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s26_q;
  logic best_left_we;
  assign best_left_we = s26_en & and_866_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_865_s26_q, select_817_s26_q, select_813_s26_q};
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
      registration_counts_across_0_q <= 20'h0;
      registration_counts_across_1_q <= 20'h0;
      registration_counts_across_2_q <= 20'h0;
      registration_counts_across_3_q <= 20'h0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s26_en) begin
      counts_explained_q <= select_1364;
      counts_nearer_q <= select_1369;
      counts_unproven_q <= select_1379;
      counts_regions_bad_q <= select_1395;
      registration_counts_across_0_q <= and_1347_s26_q ? 20'h0 : sum_1482;
      registration_counts_across_1_q <= and_1347_s26_q ? 20'h0 : sum_1492;
      registration_counts_across_2_q <= and_1347_s26_q ? 20'h0 : sum_1501;
      registration_counts_across_3_q <= and_1347_s26_q ? 20'h0 : sum_1509;
      seen_q <= select_1901;
      nearer_q <= select_1904;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic and_1881_s27_q;
  logic or_1906_s27_q;
  logic and_1907_s27_q;
  logic [13:0] select_1912_s27_q;
  logic [13:0] select_1917_s27_q;
  logic [13:0] select_1922_s27_q;
  logic [13:0] select_1927_s27_q;
  logic [13:0] select_1932_s27_q;
  logic [13:0] select_1937_s27_q;
  logic and_1944_s27_q;
  logic and_1951_s27_q;
  logic and_1963_s27_q;
  logic and_2045_s27_q;
  logic and_2058_s27_q;
  logic and_2068_s27_q;
  logic and_2079_s27_q;
  logic [19:0] select_2084_s27_q;
  logic [19:0] select_2089_s27_q;
  logic [19:0] select_2094_s27_q;
  logic [19:0] select_2099_s27_q;
  logic [11:0] select_2104_s27_q;
  logic [11:0] select_2109_s27_q;
  logic [11:0] select_2114_s27_q;
  logic [11:0] select_2119_s27_q;
  logic [23:0] select_2124_s27_q;
  logic [23:0] select_2129_s27_q;
  logic [23:0] select_2134_s27_q;
  logic [23:0] select_2139_s27_q;
  logic and_2142_s27_q;
  logic [5:0] select_2147_s27_q;
  logic [11:0] select_2152_s27_q;
  logic [11:0] select_2157_s27_q;
  logic [11:0] select_2163_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      and_1881_s27_q <= and_1881_s26_q;
      or_1906_s27_q <= not_1905 | select_1901;
      and_1907_s27_q <= cfg_prove_i & select_1904;
      select_1912_s27_q <= select_1912_s26_q;
      select_1917_s27_q <= select_1917_s26_q;
      select_1922_s27_q <= select_1922;
      select_1927_s27_q <= select_1927;
      select_1932_s27_q <= select_1932;
      select_1937_s27_q <= select_1937;
      and_1944_s27_q <= and_1944_s26_q;
      and_1951_s27_q <= and_1951_s26_q;
      and_1963_s27_q <= not_355_s26_q & (not_499_s26_q & and_1961);
      and_2045_s27_q <= not_355_s26_q & (not_499_s26_q & (not_1260_s26_q & and_2042));
      and_2058_s27_q <= not_355_s26_q & (not_499_s26_q & and_2056);
      and_2068_s27_q <= not_355_s26_q & (not_499_s26_q & and_2066);
      and_2079_s27_q <= and_2079_s26_q;
      select_2084_s27_q <= select_2084;
      select_2089_s27_q <= select_2089;
      select_2094_s27_q <= select_2094;
      select_2099_s27_q <= select_2099;
      select_2104_s27_q <= select_2104_s26_q;
      select_2109_s27_q <= select_2109_s26_q;
      select_2114_s27_q <= select_2114_s26_q;
      select_2119_s27_q <= select_2119_s26_q;
      select_2124_s27_q <= select_2124_s26_q;
      select_2129_s27_q <= select_2129_s26_q;
      select_2134_s27_q <= select_2134_s26_q;
      select_2139_s27_q <= select_2139_s26_q;
      and_2142_s27_q <= and_2142_s26_q;
      select_2147_s27_q <= select_2147_s26_q;
      select_2152_s27_q <= select_2152_s26_q;
      select_2157_s27_q <= select_2157_s26_q;
      select_2163_s27_q <= select_2163_s26_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s27_q;
  assign pixel_1_o = pixel_1_s27_q;
  assign saturated_o = saturated_s27_q;
  assign mask_o = mask_s27_q;
  assign marks_first_o = marks_first_s27_q;
  assign marks_last_o = marks_last_s27_q;
  assign marks_seen_o = or_1906_s27_q;
  assign marks_nearer_o = and_1907_s27_q;
  assign verdict_valid_o = and_1881_s27_q;
  assign verdict_supervised_o = {2'h0, select_1912_s27_q};
  assign verdict_textured_o = {2'h0, select_1917_s27_q};
  assign verdict_explained_o = {2'h0, select_1922_s27_q};
  assign verdict_nearer_o = {2'h0, select_1927_s27_q};
  assign verdict_unproven_o = {2'h0, select_1932_s27_q};
  assign verdict_regions_bad_o = {2'h0, select_1937_s27_q};
  assign verdict_unproven_yet_o = and_1944_s27_q;
  assign verdict_untextured_o = and_1951_s27_q;
  assign verdict_disagree_o = and_1963_s27_q;
  assign verdict_moved_o = and_2045_s27_q;
  assign verdict_unsharp_left_o = and_2058_s27_q;
  assign verdict_unsharp_right_o = and_2068_s27_q;
  assign verdict_hidden_o = and_2079_s27_q;
  assign verdict_across_0_o = select_2084_s27_q;
  assign verdict_across_1_o = select_2089_s27_q;
  assign verdict_across_2_o = select_2094_s27_q;
  assign verdict_across_3_o = select_2099_s27_q;
  assign verdict_measured_0_o = select_2104_s27_q;
  assign verdict_measured_1_o = select_2109_s27_q;
  assign verdict_measured_2_o = select_2114_s27_q;
  assign verdict_measured_3_o = select_2119_s27_q;
  assign verdict_detail_0_o = select_2124_s27_q;
  assign verdict_detail_1_o = select_2129_s27_q;
  assign verdict_contrast_0_o = select_2134_s27_q;
  assign verdict_contrast_1_o = select_2139_s27_q;
  assign region_valid_o = and_2142_s27_q;
  assign region_region_o = select_2147_s27_q;
  assign region_textured_o = select_2152_s27_q;
  assign region_explained_o = select_2157_s27_q;
  assign region_nearer_o = select_2163_s27_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_1966[2:0], sum_1464[0], sum_1460[0], sum_1452[1:0], sum_1451[1:0], sum_1447[0], detail_4[1:0], detail_3[1:0], sum_1166[4:0], sum_858[8:0], sum_440[4:0], cfg_width_i[3:0]};

endmodule
