// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 29 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2546 bits, pipeline 7681 bits, memories 87984 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q, valid_s27_q, valid_s28_q, valid_s29_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en, s26_en, s27_en, s28_en;
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
  assign s27_en = en_i & valid_s27_q;
  assign s28_en = en_i & valid_s28_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [5:0] sum_1320;
  assign sum_1320 = {1'b0, cfg_width_i[10:6]} + 6'h1;
  logic [6:0] sum_1324;
  assign sum_1324 = {1'b0, cfg_width_i[10:5]} + 7'h11;
  logic [6:0] sum_1339;
  assign sum_1339 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] difference_1776;
  assign difference_1776 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_1943;
  assign less_1943 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_1944;
  assign sum_1944 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_1962;
  assign not_1962 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic [3:0] raster_at_y_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_312;
  assign select_312 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);
  // hls/stages/census.hpp:40
  logic [3:0] select_333;
  assign select_333 = sample_pair_first_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:183
  logic [3:0] select_1065;
  assign select_1065 = sample_pair_whole_q ? (sample_last_q ? (select_333 + 4'h1) : select_333) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 4'h0;
      raster_at_y_q <= 4'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_312 + 4'h1) : raster_at_x_q;
      raster_at_y_q <= select_1065;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic sample_pair_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_last_s1_q;
  logic sample_present_s1_q;
  logic raster_row_ended_s1_q;
  logic [3:0] select_312_s1_q;
  logic equal_334_s1_q;
  logic equal_351_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      sample_pair_first_s1_q <= sample_pair_first_q;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      sample_last_s1_q <= sample_last_q;
      sample_present_s1_q <= sample_present_q;
      raster_row_ended_s1_q <= raster_row_ended_q;
      select_312_s1_q <= select_312;
      equal_334_s1_q <= select_333 == 4'h0;
      equal_351_s1_q <= select_333 == 4'hf;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  logic averager_running_mask_q;
  // hls/stages/census.hpp:88
  logic equal_313;
  assign equal_313 = select_312_s1_q[1:0] == 2'h0;
  // hls/stages/census.hpp:35
  logic [6:0] select_315;
  assign select_315 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:40
  logic or_320;
  assign or_320 = sample_pair_first_s1_q | raster_at_live_q;
  // hls/stages/agreement.hpp:181
  logic whole;
  assign whole = equal_313 ? sample_present_s1_q : (sample_present_s1_q & averager_running_mask_q);
  // hls/stages/agreement.hpp:183
  logic [6:0] column;
  assign column = sample_pair_whole_s1_q ? select_315 : 7'h0;
  // hls/stages/census.hpp:45
  logic equal_350;
  assign equal_350 = select_312_s1_q == 4'hf;
  // hls/stages/census.hpp:40
  logic [6:0] select_406;
  assign select_406 = sample_pair_first_s1_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:183
  logic [6:0] row;
  assign row = sample_pair_whole_s1_q ? select_406 : 7'h0;
  logic [6:0] select_1067;
  assign select_1067 = sample_pair_whole_s1_q ? (select_315 + {6'h0, equal_350}) : raster_at_column_q;
  // hls/stages/census.hpp:52
  logic [6:0] select_1069;
  assign select_1069 = sample_last_s1_q ? (select_406 + {6'h0, equal_351_s1_q}) : select_406;
  // hls/stages/agreement.hpp:183
  logic select_1074;
  assign select_1074 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_320 & (~raster_final_row_q)) : or_320) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [10:0] select_1076;
  assign select_1076 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:183
  logic select_1080;
  assign select_1080 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
    end else if (s1_en) begin
      raster_at_column_q <= select_1067;
      raster_at_row_q <= sample_pair_whole_s1_q ? select_1069 : raster_at_row_q;
      raster_at_live_q <= select_1074;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_1076 : raster_rows_left_q;
      raster_final_row_q <= select_1080;
      averager_running_mask_q <= sample_pair_whole_s1_q ? whole : averager_running_mask_q;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic sample_pair_whole_s2_q;
  logic equal_313_s2_q;
  logic equal_316_s2_q;
  logic not_325_s2_q;
  logic equal_334_s2_q;
  logic whole_s2_q;
  logic [6:0] column_s2_q;
  logic equal_350_s2_q;
  logic equal_351_s2_q;
  logic equal_357_s2_q;
  logic [6:0] row_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      equal_313_s2_q <= equal_313;
      equal_316_s2_q <= {select_315, select_312_s1_q} == 11'h0;
      not_325_s2_q <= ~((~or_320) | (~(select_312_s1_q[1:0] == 2'h3)));
      equal_334_s2_q <= equal_334_s1_q;
      whole_s2_q <= whole;
      column_s2_q <= column;
      equal_350_s2_q <= equal_350;
      equal_351_s2_q <= equal_351_s1_q;
      equal_357_s2_q <= select_312_s1_q == 4'h3;
      row_s2_q <= row;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:95
  logic [8:0] select_319;
  assign select_319 = equal_313_s2_q ? (equal_316_s2_q ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/agreement.hpp:280
  logic [7:0] sum_1335;
  assign sum_1335 = {1'b0, row_s2_q} + 8'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      averager_place_q <= sample_pair_whole_s2_q ? select_319 : averager_place_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic equal_313_s3_q;
  logic [8:0] select_319_s3_q;
  logic not_325_s3_q;
  logic equal_334_s3_q;
  logic whole_s3_q;
  logic [6:0] column_s3_q;
  logic equal_350_s3_q;
  logic equal_351_s3_q;
  logic equal_357_s3_q;
  logic [6:0] row_s3_q;
  logic equal_1336_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      equal_313_s3_q <= equal_313_s2_q;
      select_319_s3_q <= select_319;
      not_325_s3_q <= not_325_s2_q;
      equal_334_s3_q <= equal_334_s2_q;
      whole_s3_q <= whole_s2_q;
      column_s3_q <= column_s2_q;
      equal_350_s3_q <= equal_350_s2_q;
      equal_351_s3_q <= equal_351_s2_q;
      equal_357_s3_q <= equal_357_s2_q;
      row_s3_q <= row_s2_q;
      equal_1336_s3_q <= {sum_1335[7], cfg_height_i[10:4]} == {1'b0, sum_1335[6:0]};
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:181
  logic and_328;
  assign and_328 = not_325_s3_q & (~(select_319_s3_q[8:5] == 4'hf));
  // hls/stages/census.hpp:105
  logic and_352;
  assign and_352 = equal_351_s3_q & and_328;
  // hls/stages/agreement.hpp:183
  logic and_354;
  assign and_354 = sample_pair_whole_s3_q & (equal_350_s3_q & and_352);
  // hls/stages/agreement.hpp:352
  logic equal_373;
  assign equal_373 = run_phase_q == 3'h3;
  logic equal_375;
  assign equal_375 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:410
  logic less_376;
  assign less_376 = run_highest_q < x_q;
  // hls/stages/agreement.hpp:414
  logic not_377;
  assign not_377 = ~less_376;
  // hls/stages/agreement.hpp:675
  logic drew;
  assign drew = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:317
  logic [6:0] select_494;
  assign select_494 = equal_373 ? ({run_shift_q[5], run_shift_q} + x_q[6:0]) : x_q[6:0];
  // hls/stages/agreement.hpp:429
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:623
  logic [6:0] sum_1054;
  assign sum_1054 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:263
  logic equal_1252;
  assign equal_1252 = {last[7], column_s3_q} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:179
  logic [2:0] select_1253;
  assign select_1253 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1256;
  assign select_1256 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1259;
  assign select_1259 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1262;
  assign select_1262 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1265;
  assign select_1265 = ends_q ? following_shift_q : run_shift_q;
  logic select_1268;
  assign select_1268 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:264
  logic not_1269;
  assign not_1269 = ~equal_1252;
  // hls/stages/agreement.hpp:344
  logic not_1272;
  assign not_1272 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:352
  logic equal_1273;
  assign equal_1273 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:155
  logic or_1274;
  assign or_1274 = equal_1273 | equal_375;
  logic [2:0] select_1275;
  assign select_1275 = equal_373 ? {run_last_shift_q, {2{not_1272}}} : {1'b0, or_1274, equal_375};
  logic [7:0] select_1278;
  assign select_1278 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1279;
  assign select_1279 = equal_375 ? least_q : 7'h0;
  logic [7:0] select_1283;
  assign select_1283 = run_last_shift_q ? {1'b0, last_q} : (run_shift_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1285;
  assign select_1285 = equal_375 ? last_q : (equal_1273 ? last_q : 7'h0);
  logic [7:0] select_1291;
  assign select_1291 = equal_373 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_375 ? first_beats_q : (equal_1273 ? whole_beats_q : 8'h0));
  logic [5:0] select_1296;
  assign select_1296 = equal_373 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_375 ? (6'h0 - least_q[5:0]) : 6'h0);
  // hls/stages/agreement.hpp:138
  logic not_1298;
  assign not_1298 = ~drew;
  // hls/stages/agreement.hpp:155
  logic select_1302;
  assign select_1302 = equal_373 ? (next_last_shift_q & not_1272) : (equal_375 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:179
  logic [7:0] select_1305;
  assign select_1305 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1309;
  assign select_1309 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:270
  logic less_1316;
  assign less_1316 = 6'he < column_s3_q[6:1];
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1319;
  assign select_1319 = and_354 ? (equal_1252 ? (less_1316 ? 7'h1e : column_s3_q) : least_q) : least_q;
  // hls/stages/agreement.hpp:264
  logic [7:0] select_1322;
  assign select_1322 = equal_1252 ? (less_1316 ? {sum_1320, cfg_width_i[5:4]} : 8'h23) : first_beats_q;
  // hls/stages/agreement.hpp:184
  logic [7:0] select_1326;
  assign select_1326 = and_354 ? (equal_1252 ? {sum_1324, cfg_width_i[4]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:320
  logic not_1327;
  assign not_1327 = ~ends_q;
  // hls/stages/agreement.hpp:179
  logic and_1332;
  assign and_1332 = not_1327 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:184
  logic select_1338;
  assign select_1338 = and_354 ? (equal_1252 ? equal_1336_s3_q : final_row_q) : final_row_q;
  // hls/stages/agreement.hpp:538
  logic [5:0] sum_1482;
  assign sum_1482 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:148
  logic not_1838;
  assign not_1838 = ~run_shift_q[5];

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
    end else if (s3_en) begin
      run_phase_q <= and_354 ? (equal_1252 ? 3'h1 : select_1253) : select_1253;
      run_lowest_q <= and_354 ? (equal_1252 ? 8'h0 : select_1256) : select_1256;
      run_highest_q <= and_354 ? (equal_1252 ? 8'h0 : select_1259) : select_1259;
      run_beats_q <= and_354 ? (equal_1252 ? 8'h20 : select_1262) : select_1262;
      run_shift_q <= and_354 ? (equal_1252 ? 6'h0 : select_1265) : select_1265;
      run_last_shift_q <= and_354 ? (select_1268 & not_1269) : select_1268;
      following_phase_q <= drew ? {final_row_q, 1'b0, final_row_q} : select_1275;
      following_lowest_q <= drew ? 8'h0 : (equal_373 ? select_1278 : {1'b0, select_1279});
      following_highest_q <= drew ? 8'h0 : (equal_373 ? select_1283 : {1'b0, select_1285});
      following_beats_q <= drew ? 8'h3f : select_1291;
      following_shift_q <= drew ? 6'h0 : select_1296;
      following_last_shift_q <= not_1298 & select_1302;
      x_q <= and_354 ? (equal_1252 ? 8'h0 : select_1305) : select_1305;
      beats_left_q <= and_354 ? (equal_1252 ? 8'h20 : select_1309) : select_1309;
      last_q <= and_354 ? (equal_1252 ? column_s3_q : last_q) : last_q;
      least_q <= select_1319;
      first_beats_q <= and_354 ? select_1322 : first_beats_q;
      whole_beats_q <= select_1326;
      ends_q <= and_354 ? (and_1332 & not_1269) : and_1332;
      final_row_q <= select_1338;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1838}}, 1'b1} + run_beats_q;
      next_shift_q <= run_shift_q + 6'h1;
      next_last_shift_q <= {{3{run_shift_q[5]}}, run_shift_q} == ({2'h0, least_q} + 9'h1ff);
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic sample_pair_whole_s4_q;
  logic [5:0] run_shift_s4_q;
  logic [7:0] x_s4_q;
  logic ends_s4_q;
  logic equal_313_s4_q;
  logic [8:0] select_319_s4_q;
  logic and_328_s4_q;
  logic equal_334_s4_q;
  logic whole_s4_q;
  logic [6:0] column_s4_q;
  logic and_352_s4_q;
  logic and_354_s4_q;
  logic equal_357_s4_q;
  logic equal_373_s4_q;
  logic equal_375_s4_q;
  logic less_376_s4_q;
  logic not_377_s4_q;
  logic [6:0] row_s4_q;
  logic drew_s4_q;
  logic and_464_s4_q;
  logic [6:0] select_494_s4_q;
  logic [6:0] x_s4_2_q;
  logic not_517_s4_q;
  logic equal_524_s4_q;
  logic equal_591_s4_q;
  logic equal_828_s4_q;
  logic equal_892_s4_q;
  logic equal_915_s4_q;
  logic equal_918_s4_q;
  logic not_1056_s4_q;
  logic equal_1252_s4_q;
  logic not_1298_s4_q;
  logic not_1327_s4_q;
  logic less_1483_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      run_shift_s4_q <= run_shift_q;
      x_s4_q <= x_q;
      ends_s4_q <= ends_q;
      equal_313_s4_q <= equal_313_s3_q;
      select_319_s4_q <= select_319_s3_q;
      and_328_s4_q <= and_328;
      equal_334_s4_q <= equal_334_s3_q;
      whole_s4_q <= whole_s3_q;
      column_s4_q <= column_s3_q;
      and_352_s4_q <= and_352;
      and_354_s4_q <= and_354;
      equal_357_s4_q <= equal_357_s3_q;
      equal_373_s4_q <= equal_373;
      equal_375_s4_q <= equal_375;
      less_376_s4_q <= less_376;
      not_377_s4_q <= not_377;
      row_s4_q <= row_s3_q;
      drew_s4_q <= drew;
      and_464_s4_q <= drew & not_377;
      select_494_s4_q <= select_494;
      x_s4_2_q <= x[6:0];
      not_517_s4_q <= ~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q});
      equal_524_s4_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_591_s4_q <= run_lowest_q == x_q;
      equal_828_s4_q <= run_lowest_q == x;
      equal_892_s4_q <= run_highest_q == x;
      equal_915_s4_q <= x_q == {1'b0, last_q};
      equal_918_s4_q <= run_phase_q == 3'h5;
      not_1056_s4_q <= ~({sum_1054, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1252_s4_q <= equal_1252;
      not_1298_s4_q <= not_1298;
      not_1327_s4_q <= not_1327;
      less_1483_s4_q <= {1'b0, sum_1482, last_q[1]} < x_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:317
  logic and_378;
  assign and_378 = equal_375_s4_q & not_377_s4_q;
  logic select_466;
  assign select_466 = equal_373_s4_q ? not_377_s4_q : (equal_375_s4_q ? not_377_s4_q : and_464_s4_q);
  // hls/stages/agreement.hpp:179
  logic [5:0] select_1328;
  assign select_1328 = ends_s4_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1330;
  assign select_1330 = and_354_s4_q ? (equal_1252_s4_q ? 7'h0 : {select_1328, not_1327_s4_q}) : {select_1328, not_1327_s4_q};

  // Memory left, 120 x 77, DISTANCE 32, hls/stages/agreement.hpp:803; read in stage 4, written in stage 7: 4 < 7 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s4_q[6:0];
  logic left_re;
  assign left_re = s4_en & select_466;
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 32, hls/stages/agreement.hpp:804; read in stage 4, written in stage 7: 4 < 7 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_494_s4_q;
  logic right_codes_re;
  assign right_codes_re = s4_en & (equal_373_s4_q ? not_377_s4_q : and_378);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s4_en) begin
      age_q <= select_1330;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic sample_pair_whole_s5_q;
  logic [5:0] run_shift_s5_q;
  logic [7:0] x_s5_q;
  logic [1:0] age_s5_q;
  logic equal_313_s5_q;
  logic [8:0] select_319_s5_q;
  logic and_328_s5_q;
  logic equal_334_s5_q;
  logic whole_s5_q;
  logic [6:0] column_s5_q;
  logic and_352_s5_q;
  logic and_354_s5_q;
  logic equal_357_s5_q;
  logic equal_373_s5_q;
  logic equal_375_s5_q;
  logic less_376_s5_q;
  logic not_377_s5_q;
  logic and_378_s5_q;
  logic [6:0] row_s5_q;
  logic drew_s5_q;
  logic and_464_s5_q;
  logic [6:0] x_s5_2_q;
  logic and_518_s5_q;
  logic equal_524_s5_q;
  logic equal_591_s5_q;
  logic equal_828_s5_q;
  logic equal_892_s5_q;
  logic equal_915_s5_q;
  logic equal_918_s5_q;
  logic not_1056_s5_q;
  logic equal_1252_s5_q;
  logic not_1298_s5_q;
  logic less_1483_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      sample_pair_whole_s5_q <= sample_pair_whole_s4_q;
      run_shift_s5_q <= run_shift_s4_q;
      x_s5_q <= x_s4_q;
      age_s5_q <= {age_q[6], age_q[4]};
      equal_313_s5_q <= equal_313_s4_q;
      select_319_s5_q <= select_319_s4_q;
      and_328_s5_q <= and_328_s4_q;
      equal_334_s5_q <= equal_334_s4_q;
      whole_s5_q <= whole_s4_q;
      column_s5_q <= column_s4_q;
      and_352_s5_q <= and_352_s4_q;
      and_354_s5_q <= and_354_s4_q;
      equal_357_s5_q <= equal_357_s4_q;
      equal_373_s5_q <= equal_373_s4_q;
      equal_375_s5_q <= equal_375_s4_q;
      less_376_s5_q <= less_376_s4_q;
      not_377_s5_q <= not_377_s4_q;
      and_378_s5_q <= and_378;
      row_s5_q <= row_s4_q;
      drew_s5_q <= drew_s4_q;
      and_464_s5_q <= and_464_s4_q;
      x_s5_2_q <= x_s4_2_q;
      and_518_s5_q <= age_q[2] & not_517_s4_q;
      equal_524_s5_q <= equal_524_s4_q;
      equal_591_s5_q <= equal_591_s4_q;
      equal_828_s5_q <= equal_828_s4_q;
      equal_892_s5_q <= equal_892_s4_q;
      equal_915_s5_q <= equal_915_s4_q;
      equal_918_s5_q <= equal_918_s4_q;
      not_1056_s5_q <= not_1056_s4_q;
      equal_1252_s5_q <= equal_1252_s4_q;
      not_1298_s5_q <= not_1298_s4_q;
      less_1483_s5_q <= less_1483_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:339
  logic not_374;
  assign not_374 = ~equal_373_s5_q;
  // hls/stages/agreement.hpp:317
  logic and_379;
  assign and_379 = not_374 & and_378_s5_q;

  // Memory fresh, 120 x 29, DISTANCE 32, hls/stages/agreement.hpp:802; read in stage 5, written in stage 27: 5 < 27 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s5_q[6:0];
  logic fresh_re;
  assign fresh_re = s5_en & and_379;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  logic [7:0] pixel_0_s6_q;
  logic [7:0] pixel_1_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic sample_pair_whole_s6_q;
  logic [5:0] run_shift_s6_q;
  logic [7:0] x_s6_q;
  logic [1:0] age_s6_q;
  logic equal_313_s6_q;
  logic [8:0] select_319_s6_q;
  logic and_328_s6_q;
  logic equal_334_s6_q;
  logic whole_s6_q;
  logic [6:0] column_s6_q;
  logic and_352_s6_q;
  logic and_354_s6_q;
  logic equal_357_s6_q;
  logic equal_373_s6_q;
  logic not_374_s6_q;
  logic equal_375_s6_q;
  logic less_376_s6_q;
  logic not_377_s6_q;
  logic and_379_s6_q;
  logic [6:0] row_s6_q;
  logic drew_s6_q;
  logic and_464_s6_q;
  logic [76:0] left_rdata_s6_q;
  logic [90:0] right_codes_rdata_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_518_s6_q;
  logic equal_524_s6_q;
  logic equal_591_s6_q;
  logic equal_828_s6_q;
  logic equal_892_s6_q;
  logic equal_915_s6_q;
  logic equal_918_s6_q;
  logic not_1056_s6_q;
  logic equal_1252_s6_q;
  logic not_1298_s6_q;
  logic less_1483_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      pixel_1_s6_q <= pixel_1_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      sample_pair_whole_s6_q <= sample_pair_whole_s5_q;
      run_shift_s6_q <= run_shift_s5_q;
      x_s6_q <= x_s5_q;
      age_s6_q <= age_s5_q;
      equal_313_s6_q <= equal_313_s5_q;
      select_319_s6_q <= select_319_s5_q;
      and_328_s6_q <= and_328_s5_q;
      equal_334_s6_q <= equal_334_s5_q;
      whole_s6_q <= whole_s5_q;
      column_s6_q <= column_s5_q;
      and_352_s6_q <= and_352_s5_q;
      and_354_s6_q <= and_354_s5_q;
      equal_357_s6_q <= equal_357_s5_q;
      equal_373_s6_q <= equal_373_s5_q;
      not_374_s6_q <= not_374;
      equal_375_s6_q <= equal_375_s5_q;
      less_376_s6_q <= less_376_s5_q;
      not_377_s6_q <= not_377_s5_q;
      and_379_s6_q <= and_379;
      row_s6_q <= row_s5_q;
      drew_s6_q <= drew_s5_q;
      and_464_s6_q <= and_464_s5_q;
      left_rdata_s6_q <= left_rdata_q;
      right_codes_rdata_s6_q <= right_codes_rdata_q;
      x_s6_2_q <= x_s5_2_q;
      and_518_s6_q <= and_518_s5_q;
      equal_524_s6_q <= equal_524_s5_q;
      equal_591_s6_q <= equal_591_s5_q;
      equal_828_s6_q <= equal_828_s5_q;
      equal_892_s6_q <= equal_892_s5_q;
      equal_915_s6_q <= equal_915_s5_q;
      equal_918_s6_q <= equal_918_s5_q;
      not_1056_s6_q <= not_1056_s5_q;
      equal_1252_s6_q <= equal_1252_s5_q;
      not_1298_s6_q <= not_1298_s5_q;
      less_1483_s6_q <= less_1483_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:385
  logic equal_468;
  assign equal_468 = row_q == 7'h0;
  logic not_470;
  assign not_470 = ~equal_468;
  logic equal_475;
  assign equal_475 = row_q[6:1] == 6'h0;
  logic not_477;
  assign not_477 = ~equal_475;
  logic less_482;
  assign less_482 = row_q < 7'h3;
  logic not_484;
  assign not_484 = ~less_482;
  logic equal_489;
  assign equal_489 = row_q[6:2] == 5'h0;
  logic not_491;
  assign not_491 = ~equal_489;
  // hls/stages/agreement.hpp:386
  logic less_505;
  assign less_505 = row_q < 7'h5;
  logic less_509;
  assign less_509 = row_q[6:1] < 6'h3;
  // hls/stages/agreement.hpp:167
  logic and_530;
  assign and_530 = left_rdata_s6_q[44] & not_377_s6_q;
  logic [11:0] a;
  assign a = less_376_s6_q ? 12'h0 : left_rdata_s6_q[43:32];
  logic [11:0] b;
  assign b = less_376_s6_q ? 12'h0 : right_codes_rdata_s6_q[37:26];
  logic [11:0] a_2;
  assign a_2 = less_376_s6_q ? 12'h0 : left_rdata_s6_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_376_s6_q ? 12'h0 : right_codes_rdata_s6_q[50:39];
  logic and_569;
  assign and_569 = left_rdata_s6_q[76] & not_377_s6_q;
  logic [11:0] a_3;
  assign a_3 = less_376_s6_q ? 12'h0 : left_rdata_s6_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_376_s6_q ? 12'h0 : right_codes_rdata_s6_q[63:52];
  logic [11:0] b_4;
  assign b_4 = less_376_s6_q ? 12'h0 : right_codes_rdata_s6_q[76:65];
  logic [11:0] b_5;
  assign b_5 = less_376_s6_q ? 12'h0 : right_codes_rdata_s6_q[24:13];
  logic [11:0] b_6;
  assign b_6 = less_376_s6_q ? 12'h0 : right_codes_rdata_s6_q[89:78];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_741;
  assign not_741 = ~(a_3 ^ b_6);
  // hls/stages/agreement.hpp:167
  logic [11:0] b_7;
  assign b_7 = less_376_s6_q ? 12'h0 : right_codes_rdata_s6_q[11:0];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_770;
  assign not_770 = ~(a ^ b_7);
  // hls/stages/agreement.hpp:529
  logic not_927;
  assign not_927 = ~(row_q[6:3] == 4'h0);
  // hls/stages/agreement.hpp:317
  logic and_1058;
  assign and_1058 = drew_s6_q & (((7'h6 < row_q) & (~(x_s6_q[7:2] == 6'h0))) & not_1056_s6_q);
  // hls/stages/agreement.hpp:264
  logic select_1342;
  assign select_1342 = equal_1252_s6_q ? (~({row_s6_q, 1'b0} < {sum_1339, cfg_height_i[4]})) : lower_half_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s6_en) begin
      row_q <= and_354_s6_q ? (equal_1252_s6_q ? row_s6_q : row_q) : row_q;
      lower_half_q <= and_354_s6_q ? select_1342 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s7_q;
  logic [7:0] pixel_1_s7_q;
  logic saturated_s7_q;
  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic sample_pair_whole_s7_q;
  logic [5:0] run_shift_s7_q;
  logic [7:0] x_s7_q;
  logic [1:0] age_s7_q;
  logic lower_half_s7_q;
  logic equal_313_s7_q;
  logic [8:0] select_319_s7_q;
  logic and_328_s7_q;
  logic equal_334_s7_q;
  logic whole_s7_q;
  logic [6:0] column_s7_q;
  logic and_352_s7_q;
  logic and_354_s7_q;
  logic equal_357_s7_q;
  logic equal_373_s7_q;
  logic not_374_s7_q;
  logic equal_375_s7_q;
  logic less_376_s7_q;
  logic not_377_s7_q;
  logic and_379_s7_q;
  logic [28:0] fresh_rdata_s7_q;
  logic equal_408_s7_q;
  logic drew_s7_q;
  logic and_464_s7_q;
  logic left_rdata_s7_q;
  logic [11:0] select_469_s7_q;
  logic and_471_s7_q;
  logic and_472_s7_q;
  logic and_473_s7_q;
  logic and_474_s7_q;
  logic [11:0] select_476_s7_q;
  logic and_478_s7_q;
  logic and_479_s7_q;
  logic and_480_s7_q;
  logic and_481_s7_q;
  logic [11:0] select_483_s7_q;
  logic and_485_s7_q;
  logic and_486_s7_q;
  logic and_487_s7_q;
  logic and_488_s7_q;
  logic [11:0] select_490_s7_q;
  logic and_492_s7_q;
  logic [11:0] select_497_s7_q;
  logic and_498_s7_q;
  logic [11:0] select_499_s7_q;
  logic and_500_s7_q;
  logic [11:0] select_501_s7_q;
  logic and_502_s7_q;
  logic [11:0] select_503_s7_q;
  logic and_504_s7_q;
  logic [11:0] select_506_s7_q;
  logic and_508_s7_q;
  logic [11:0] select_510_s7_q;
  logic and_512_s7_q;
  logic [6:0] x_s7_2_q;
  logic and_518_s7_q;
  logic equal_524_s7_q;
  logic and_530_s7_q;
  logic and_531_s7_q;
  logic [11:0] a_s7_q;
  logic [11:0] b_s7_q;
  logic and_549_s7_q;
  logic and_550_s7_q;
  logic [11:0] a_2_s7_q;
  logic [11:0] b_2_s7_q;
  logic and_569_s7_q;
  logic and_570_s7_q;
  logic [11:0] a_3_s7_q;
  logic [11:0] b_3_s7_q;
  logic equal_591_s7_q;
  logic and_625_s7_q;
  logic [11:0] b_4_s7_q;
  logic and_649_s7_q;
  logic [11:0] b_5_s7_q;
  logic and_738_s7_q;
  logic [9:0] not_741_s7_q;
  logic [1:0] sum_742_s7_q;
  logic and_767_s7_q;
  logic [9:0] not_770_s7_q;
  logic [1:0] sum_771_s7_q;
  logic equal_828_s7_q;
  logic equal_892_s7_q;
  logic equal_915_s7_q;
  logic equal_918_s7_q;
  logic and_929_s7_q;
  logic and_1058_s7_q;
  logic equal_1200_s7_q;
  logic equal_1252_s7_q;
  logic not_1298_s7_q;
  logic and_1386_s7_q;
  logic less_1480_s7_q;
  logic less_1483_s7_q;
  logic equal_1745_s7_q;
  logic less_1756_s7_q;
  logic equal_1921_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      pixel_0_s7_q <= pixel_0_s6_q;
      pixel_1_s7_q <= pixel_1_s6_q;
      saturated_s7_q <= saturated_s6_q;
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      sample_pair_whole_s7_q <= sample_pair_whole_s6_q;
      run_shift_s7_q <= run_shift_s6_q;
      x_s7_q <= x_s6_q;
      age_s7_q <= age_s6_q;
      lower_half_s7_q <= lower_half_q;
      equal_313_s7_q <= equal_313_s6_q;
      select_319_s7_q <= select_319_s6_q;
      and_328_s7_q <= and_328_s6_q;
      equal_334_s7_q <= equal_334_s6_q;
      whole_s7_q <= whole_s6_q;
      column_s7_q <= column_s6_q;
      and_352_s7_q <= and_352_s6_q;
      and_354_s7_q <= and_354_s6_q;
      equal_357_s7_q <= equal_357_s6_q;
      equal_373_s7_q <= equal_373_s6_q;
      not_374_s7_q <= not_374_s6_q;
      equal_375_s7_q <= equal_375_s6_q;
      less_376_s7_q <= less_376_s6_q;
      not_377_s7_q <= not_377_s6_q;
      and_379_s7_q <= and_379_s6_q;
      fresh_rdata_s7_q <= fresh_rdata_q;
      equal_408_s7_q <= row_s6_q == 7'h0;
      drew_s7_q <= drew_s6_q;
      and_464_s7_q <= and_464_s6_q;
      left_rdata_s7_q <= left_rdata_s6_q[63];
      select_469_s7_q <= equal_468 ? 12'h0 : left_rdata_s6_q[11:0];
      and_471_s7_q <= left_rdata_s6_q[12] & not_470;
      and_472_s7_q <= left_rdata_s6_q[13] & not_470;
      and_473_s7_q <= left_rdata_s6_q[14] & not_470;
      and_474_s7_q <= left_rdata_s6_q[15] & not_470;
      select_476_s7_q <= equal_475 ? 12'h0 : left_rdata_s6_q[27:16];
      and_478_s7_q <= left_rdata_s6_q[28] & not_477;
      and_479_s7_q <= left_rdata_s6_q[29] & not_477;
      and_480_s7_q <= left_rdata_s6_q[30] & not_477;
      and_481_s7_q <= left_rdata_s6_q[31] & not_477;
      select_483_s7_q <= less_482 ? 12'h0 : left_rdata_s6_q[43:32];
      and_485_s7_q <= left_rdata_s6_q[44] & not_484;
      and_486_s7_q <= left_rdata_s6_q[45] & not_484;
      and_487_s7_q <= left_rdata_s6_q[46] & not_484;
      and_488_s7_q <= left_rdata_s6_q[47] & not_484;
      select_490_s7_q <= equal_489 ? 12'h0 : left_rdata_s6_q[59:48];
      and_492_s7_q <= left_rdata_s6_q[60] & not_491;
      select_497_s7_q <= equal_468 ? 12'h0 : right_codes_rdata_s6_q[11:0];
      and_498_s7_q <= right_codes_rdata_s6_q[12] & not_470;
      select_499_s7_q <= equal_475 ? 12'h0 : right_codes_rdata_s6_q[24:13];
      and_500_s7_q <= right_codes_rdata_s6_q[25] & not_477;
      select_501_s7_q <= less_482 ? 12'h0 : right_codes_rdata_s6_q[37:26];
      and_502_s7_q <= right_codes_rdata_s6_q[38] & not_484;
      select_503_s7_q <= equal_489 ? 12'h0 : right_codes_rdata_s6_q[50:39];
      and_504_s7_q <= right_codes_rdata_s6_q[51] & not_491;
      select_506_s7_q <= less_505 ? 12'h0 : right_codes_rdata_s6_q[63:52];
      and_508_s7_q <= right_codes_rdata_s6_q[64] & (~less_505);
      select_510_s7_q <= less_509 ? 12'h0 : right_codes_rdata_s6_q[76:65];
      and_512_s7_q <= right_codes_rdata_s6_q[77] & (~less_509);
      x_s7_2_q <= x_s6_2_q;
      and_518_s7_q <= and_518_s6_q;
      equal_524_s7_q <= equal_524_s6_q;
      and_530_s7_q <= and_530;
      and_531_s7_q <= right_codes_rdata_s6_q[38] & not_377_s6_q;
      a_s7_q <= a;
      b_s7_q <= b;
      and_549_s7_q <= left_rdata_s6_q[60] & not_377_s6_q;
      and_550_s7_q <= right_codes_rdata_s6_q[51] & not_377_s6_q;
      a_2_s7_q <= a_2;
      b_2_s7_q <= b_2;
      and_569_s7_q <= and_569;
      and_570_s7_q <= right_codes_rdata_s6_q[64] & not_377_s6_q;
      a_3_s7_q <= a_3;
      b_3_s7_q <= b_3;
      equal_591_s7_q <= equal_591_s6_q;
      and_625_s7_q <= right_codes_rdata_s6_q[77] & not_377_s6_q;
      b_4_s7_q <= b_4;
      and_649_s7_q <= right_codes_rdata_s6_q[25] & not_377_s6_q;
      b_5_s7_q <= b_5;
      and_738_s7_q <= and_569 & (right_codes_rdata_s6_q[90] & not_377_s6_q);
      not_741_s7_q <= not_741[11:2];
      sum_742_s7_q <= {1'b0, not_741[0]} + {1'b0, not_741[1]};
      and_767_s7_q <= and_530 & (right_codes_rdata_s6_q[12] & not_377_s6_q);
      not_770_s7_q <= not_770[11:2];
      sum_771_s7_q <= {1'b0, not_770[0]} + {1'b0, not_770[1]};
      equal_828_s7_q <= equal_828_s6_q;
      equal_892_s7_q <= equal_892_s6_q;
      equal_915_s7_q <= equal_915_s6_q;
      equal_918_s7_q <= equal_918_s6_q;
      and_929_s7_q <= left_rdata_s6_q[61] & (left_rdata_s6_q[62] & not_927);
      and_1058_s7_q <= and_1058;
      equal_1200_s7_q <= (column_s6_q | row_s6_q) == 7'h0;
      equal_1252_s7_q <= equal_1252_s6_q;
      not_1298_s7_q <= not_1298_s6_q;
      and_1386_s7_q <= left_rdata_s6_q[61] & not_927;
      less_1480_s7_q <= 6'h4 < row_q[6:1];
      less_1483_s7_q <= less_1483_s6_q;
      equal_1745_s7_q <= row_s6_q[6:2] == 5'h0;
      less_1756_s7_q <= 6'h2 < row_s6_q[6:1];
      equal_1921_s7_q <= row_s6_q[6:3] == 4'h0;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:395
  logic [11:0] not_536;
  assign not_536 = ~(a_s7_q ^ b_s7_q);
  logic [1:0] sum_538;
  assign sum_538 = {1'b0, not_536[2]} + ({1'b0, not_536[0]} + {1'b0, not_536[1]});
  logic [11:0] not_555;
  assign not_555 = ~(a_2_s7_q ^ b_2_s7_q);
  logic [1:0] sum_557;
  assign sum_557 = {1'b0, not_555[2]} + ({1'b0, not_555[0]} + {1'b0, not_555[1]});
  logic [11:0] not_575;
  assign not_575 = ~(a_3_s7_q ^ b_3_s7_q);
  logic [1:0] sum_577;
  assign sum_577 = {1'b0, not_575[2]} + ({1'b0, not_575[0]} + {1'b0, not_575[1]});
  logic [11:0] not_596;
  assign not_596 = ~(a_s7_q ^ b_2_s7_q);
  logic [1:0] sum_598;
  assign sum_598 = {1'b0, not_596[2]} + ({1'b0, not_596[0]} + {1'b0, not_596[1]});
  logic [11:0] not_611;
  assign not_611 = ~(a_2_s7_q ^ b_3_s7_q);
  logic [1:0] sum_613;
  assign sum_613 = {1'b0, not_611[2]} + ({1'b0, not_611[0]} + {1'b0, not_611[1]});
  logic [11:0] not_629;
  assign not_629 = ~(a_3_s7_q ^ b_4_s7_q);
  logic [1:0] sum_631;
  assign sum_631 = {1'b0, not_629[2]} + ({1'b0, not_629[0]} + {1'b0, not_629[1]});
  logic [11:0] not_653;
  assign not_653 = ~(a_s7_q ^ b_5_s7_q);
  logic [1:0] sum_655;
  assign sum_655 = {1'b0, not_653[2]} + ({1'b0, not_653[0]} + {1'b0, not_653[1]});
  logic [11:0] not_668;
  assign not_668 = ~(a_2_s7_q ^ b_s7_q);
  logic [1:0] sum_670;
  assign sum_670 = {1'b0, not_668[2]} + ({1'b0, not_668[0]} + {1'b0, not_668[1]});
  logic [11:0] not_684;
  assign not_684 = ~(a_3_s7_q ^ b_2_s7_q);
  logic [1:0] sum_686;
  assign sum_686 = {1'b0, not_684[2]} + ({1'b0, not_684[0]} + {1'b0, not_684[1]});
  logic [11:0] not_708;
  assign not_708 = ~(a_s7_q ^ b_3_s7_q);
  logic [1:0] sum_710;
  assign sum_710 = {1'b0, not_708[2]} + ({1'b0, not_708[0]} + {1'b0, not_708[1]});
  logic [11:0] not_723;
  assign not_723 = ~(a_2_s7_q ^ b_4_s7_q);
  logic [1:0] sum_725;
  assign sum_725 = {1'b0, not_723[2]} + ({1'b0, not_723[0]} + {1'b0, not_723[1]});
  logic [1:0] sum_743;
  assign sum_743 = {1'b0, not_741_s7_q[0]} + sum_742_s7_q;
  logic [1:0] sum_772;
  assign sum_772 = {1'b0, not_770_s7_q[0]} + sum_771_s7_q;
  logic [11:0] not_785;
  assign not_785 = ~(a_2_s7_q ^ b_5_s7_q);
  logic [1:0] sum_787;
  assign sum_787 = {1'b0, not_785[2]} + ({1'b0, not_785[0]} + {1'b0, not_785[1]});
  logic [11:0] not_801;
  assign not_801 = ~(a_3_s7_q ^ b_s7_q);
  logic [1:0] sum_803;
  assign sum_803 = {1'b0, not_801[2]} + ({1'b0, not_801[0]} + {1'b0, not_801[1]});

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s7_q[6:0];
  logic left_we;
  assign left_we = s7_en & and_379_s7_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_492_s7_q, select_490_s7_q, and_488_s7_q, and_487_s7_q, and_486_s7_q, and_485_s7_q, select_483_s7_q, and_481_s7_q, and_480_s7_q, and_479_s7_q, and_478_s7_q, select_476_s7_q, and_474_s7_q, and_473_s7_q, and_472_s7_q, and_471_s7_q, select_469_s7_q, fresh_rdata_s7_q[28:26], fresh_rdata_s7_q[24], fresh_rdata_s7_q[11:0]};
  end
`ifndef SYNTHESIS
  logic [6:0] left_raddr_s5_sim;
  logic left_re_s5_sim;
  logic [6:0] left_raddr_s6_sim;
  logic left_re_s6_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_re_s5_sim <= 1'b0;
      left_re_s6_sim <= 1'b0;
    end else if (en_i) begin
      left_re_s5_sim <= left_re;
      left_raddr_s5_sim <= left_raddr;
      left_re_s6_sim <= left_re_s5_sim;
      left_raddr_s6_sim <= left_raddr_s5_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s5_sim && left_raddr_s5_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s6_sim && left_raddr_s6_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 7'd120) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 7'd120) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [6:0] right_codes_waddr;
  assign right_codes_waddr = x_s7_q[6:0];
  logic right_codes_we;
  assign right_codes_we = s7_en & and_379_s7_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_512_s7_q, select_510_s7_q, and_508_s7_q, select_506_s7_q, and_504_s7_q, select_503_s7_q, and_502_s7_q, select_501_s7_q, and_500_s7_q, select_499_s7_q, and_498_s7_q, select_497_s7_q, fresh_rdata_s7_q[25], fresh_rdata_s7_q[23:12]};
  end
`ifndef SYNTHESIS
  logic [6:0] right_codes_raddr_s5_sim;
  logic right_codes_re_s5_sim;
  logic [6:0] right_codes_raddr_s6_sim;
  logic right_codes_re_s6_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_codes_re_s5_sim <= 1'b0;
      right_codes_re_s6_sim <= 1'b0;
    end else if (en_i) begin
      right_codes_re_s5_sim <= right_codes_re;
      right_codes_raddr_s5_sim <= right_codes_raddr;
      right_codes_re_s6_sim <= right_codes_re_s5_sim;
      right_codes_raddr_s6_sim <= right_codes_raddr_s5_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s5_sim && right_codes_raddr_s5_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s6_sim && right_codes_raddr_s6_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 7'd120) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 7'd120) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  logic [7:0] pixel_0_s8_q;
  logic [7:0] pixel_1_s8_q;
  logic saturated_s8_q;
  logic mask_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic sample_pair_whole_s8_q;
  logic [5:0] run_shift_s8_q;
  logic [7:0] x_s8_q;
  logic [1:0] age_s8_q;
  logic lower_half_s8_q;
  logic equal_313_s8_q;
  logic [8:0] select_319_s8_q;
  logic and_328_s8_q;
  logic equal_334_s8_q;
  logic whole_s8_q;
  logic [6:0] column_s8_q;
  logic and_352_s8_q;
  logic and_354_s8_q;
  logic equal_357_s8_q;
  logic equal_373_s8_q;
  logic not_374_s8_q;
  logic equal_375_s8_q;
  logic less_376_s8_q;
  logic not_377_s8_q;
  logic equal_408_s8_q;
  logic drew_s8_q;
  logic and_464_s8_q;
  logic left_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic and_518_s8_q;
  logic equal_524_s8_q;
  logic and_530_s8_q;
  logic and_531_s8_q;
  logic [7:0] not_536_s8_q;
  logic [2:0] sum_539_s8_q;
  logic and_549_s8_q;
  logic and_550_s8_q;
  logic [7:0] not_555_s8_q;
  logic [2:0] sum_558_s8_q;
  logic and_569_s8_q;
  logic and_570_s8_q;
  logic [7:0] not_575_s8_q;
  logic [2:0] sum_578_s8_q;
  logic equal_591_s8_q;
  logic [7:0] not_596_s8_q;
  logic [2:0] sum_599_s8_q;
  logic [7:0] not_611_s8_q;
  logic [2:0] sum_614_s8_q;
  logic and_625_s8_q;
  logic [7:0] not_629_s8_q;
  logic [2:0] sum_632_s8_q;
  logic and_649_s8_q;
  logic [7:0] not_653_s8_q;
  logic [2:0] sum_656_s8_q;
  logic [7:0] not_668_s8_q;
  logic [2:0] sum_671_s8_q;
  logic [7:0] not_684_s8_q;
  logic [2:0] sum_687_s8_q;
  logic [7:0] not_708_s8_q;
  logic [2:0] sum_711_s8_q;
  logic [7:0] not_723_s8_q;
  logic [2:0] sum_726_s8_q;
  logic and_738_s8_q;
  logic [7:0] not_741_s8_q;
  logic [2:0] sum_744_s8_q;
  logic and_767_s8_q;
  logic [7:0] not_770_s8_q;
  logic [2:0] sum_773_s8_q;
  logic [7:0] not_785_s8_q;
  logic [2:0] sum_788_s8_q;
  logic [7:0] not_801_s8_q;
  logic [2:0] sum_804_s8_q;
  logic equal_828_s8_q;
  logic equal_892_s8_q;
  logic equal_915_s8_q;
  logic equal_918_s8_q;
  logic and_929_s8_q;
  logic and_1058_s8_q;
  logic equal_1200_s8_q;
  logic equal_1252_s8_q;
  logic not_1298_s8_q;
  logic and_1386_s8_q;
  logic less_1480_s8_q;
  logic less_1483_s8_q;
  logic equal_1745_s8_q;
  logic less_1756_s8_q;
  logic equal_1921_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      pixel_0_s8_q <= pixel_0_s7_q;
      pixel_1_s8_q <= pixel_1_s7_q;
      saturated_s8_q <= saturated_s7_q;
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      sample_pair_whole_s8_q <= sample_pair_whole_s7_q;
      run_shift_s8_q <= run_shift_s7_q;
      x_s8_q <= x_s7_q;
      age_s8_q <= age_s7_q;
      lower_half_s8_q <= lower_half_s7_q;
      equal_313_s8_q <= equal_313_s7_q;
      select_319_s8_q <= select_319_s7_q;
      and_328_s8_q <= and_328_s7_q;
      equal_334_s8_q <= equal_334_s7_q;
      whole_s8_q <= whole_s7_q;
      column_s8_q <= column_s7_q;
      and_352_s8_q <= and_352_s7_q;
      and_354_s8_q <= and_354_s7_q;
      equal_357_s8_q <= equal_357_s7_q;
      equal_373_s8_q <= equal_373_s7_q;
      not_374_s8_q <= not_374_s7_q;
      equal_375_s8_q <= equal_375_s7_q;
      less_376_s8_q <= less_376_s7_q;
      not_377_s8_q <= not_377_s7_q;
      equal_408_s8_q <= equal_408_s7_q;
      drew_s8_q <= drew_s7_q;
      and_464_s8_q <= and_464_s7_q;
      left_rdata_s8_q <= left_rdata_s7_q;
      x_s8_2_q <= x_s7_2_q;
      and_518_s8_q <= and_518_s7_q;
      equal_524_s8_q <= equal_524_s7_q;
      and_530_s8_q <= and_530_s7_q;
      and_531_s8_q <= and_531_s7_q;
      not_536_s8_q <= not_536[11:4];
      sum_539_s8_q <= {2'h0, not_536[3]} + {1'b0, sum_538};
      and_549_s8_q <= and_549_s7_q;
      and_550_s8_q <= and_550_s7_q;
      not_555_s8_q <= not_555[11:4];
      sum_558_s8_q <= {2'h0, not_555[3]} + {1'b0, sum_557};
      and_569_s8_q <= and_569_s7_q;
      and_570_s8_q <= and_570_s7_q;
      not_575_s8_q <= not_575[11:4];
      sum_578_s8_q <= {2'h0, not_575[3]} + {1'b0, sum_577};
      equal_591_s8_q <= equal_591_s7_q;
      not_596_s8_q <= not_596[11:4];
      sum_599_s8_q <= {2'h0, not_596[3]} + {1'b0, sum_598};
      not_611_s8_q <= not_611[11:4];
      sum_614_s8_q <= {2'h0, not_611[3]} + {1'b0, sum_613};
      and_625_s8_q <= and_625_s7_q;
      not_629_s8_q <= not_629[11:4];
      sum_632_s8_q <= {2'h0, not_629[3]} + {1'b0, sum_631};
      and_649_s8_q <= and_649_s7_q;
      not_653_s8_q <= not_653[11:4];
      sum_656_s8_q <= {2'h0, not_653[3]} + {1'b0, sum_655};
      not_668_s8_q <= not_668[11:4];
      sum_671_s8_q <= {2'h0, not_668[3]} + {1'b0, sum_670};
      not_684_s8_q <= not_684[11:4];
      sum_687_s8_q <= {2'h0, not_684[3]} + {1'b0, sum_686};
      not_708_s8_q <= not_708[11:4];
      sum_711_s8_q <= {2'h0, not_708[3]} + {1'b0, sum_710};
      not_723_s8_q <= not_723[11:4];
      sum_726_s8_q <= {2'h0, not_723[3]} + {1'b0, sum_725};
      and_738_s8_q <= and_738_s7_q;
      not_741_s8_q <= not_741_s7_q[9:2];
      sum_744_s8_q <= {2'h0, not_741_s7_q[1]} + {1'b0, sum_743};
      and_767_s8_q <= and_767_s7_q;
      not_770_s8_q <= not_770_s7_q[9:2];
      sum_773_s8_q <= {2'h0, not_770_s7_q[1]} + {1'b0, sum_772};
      not_785_s8_q <= not_785[11:4];
      sum_788_s8_q <= {2'h0, not_785[3]} + {1'b0, sum_787};
      not_801_s8_q <= not_801[11:4];
      sum_804_s8_q <= {2'h0, not_801[3]} + {1'b0, sum_803};
      equal_828_s8_q <= equal_828_s7_q;
      equal_892_s8_q <= equal_892_s7_q;
      equal_915_s8_q <= equal_915_s7_q;
      equal_918_s8_q <= equal_918_s7_q;
      and_929_s8_q <= and_929_s7_q;
      and_1058_s8_q <= and_1058_s7_q;
      equal_1200_s8_q <= equal_1200_s7_q;
      equal_1252_s8_q <= equal_1252_s7_q;
      not_1298_s8_q <= not_1298_s7_q;
      and_1386_s8_q <= and_1386_s7_q;
      less_1480_s8_q <= less_1480_s7_q;
      less_1483_s8_q <= less_1483_s7_q;
      equal_1745_s8_q <= equal_1745_s7_q;
      less_1756_s8_q <= less_1756_s7_q;
      equal_1921_s8_q <= equal_1921_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:395
  logic [2:0] sum_541;
  assign sum_541 = {2'h0, not_536_s8_q[1]} + ({2'h0, not_536_s8_q[0]} + sum_539_s8_q);
  logic [2:0] sum_560;
  assign sum_560 = {2'h0, not_555_s8_q[1]} + ({2'h0, not_555_s8_q[0]} + sum_558_s8_q);
  logic [2:0] sum_580;
  assign sum_580 = {2'h0, not_575_s8_q[1]} + ({2'h0, not_575_s8_q[0]} + sum_578_s8_q);
  logic [2:0] sum_601;
  assign sum_601 = {2'h0, not_596_s8_q[1]} + ({2'h0, not_596_s8_q[0]} + sum_599_s8_q);
  logic [2:0] sum_616;
  assign sum_616 = {2'h0, not_611_s8_q[1]} + ({2'h0, not_611_s8_q[0]} + sum_614_s8_q);
  logic [2:0] sum_634;
  assign sum_634 = {2'h0, not_629_s8_q[1]} + ({2'h0, not_629_s8_q[0]} + sum_632_s8_q);
  logic [2:0] sum_658;
  assign sum_658 = {2'h0, not_653_s8_q[1]} + ({2'h0, not_653_s8_q[0]} + sum_656_s8_q);
  logic [2:0] sum_673;
  assign sum_673 = {2'h0, not_668_s8_q[1]} + ({2'h0, not_668_s8_q[0]} + sum_671_s8_q);
  logic [2:0] sum_689;
  assign sum_689 = {2'h0, not_684_s8_q[1]} + ({2'h0, not_684_s8_q[0]} + sum_687_s8_q);
  logic [2:0] sum_713;
  assign sum_713 = {2'h0, not_708_s8_q[1]} + ({2'h0, not_708_s8_q[0]} + sum_711_s8_q);
  logic [2:0] sum_728;
  assign sum_728 = {2'h0, not_723_s8_q[1]} + ({2'h0, not_723_s8_q[0]} + sum_726_s8_q);
  logic [2:0] sum_746;
  assign sum_746 = {2'h0, not_741_s8_q[1]} + ({2'h0, not_741_s8_q[0]} + sum_744_s8_q);
  logic [2:0] sum_775;
  assign sum_775 = {2'h0, not_770_s8_q[1]} + ({2'h0, not_770_s8_q[0]} + sum_773_s8_q);
  logic [2:0] sum_790;
  assign sum_790 = {2'h0, not_785_s8_q[1]} + ({2'h0, not_785_s8_q[0]} + sum_788_s8_q);
  logic [2:0] sum_806;
  assign sum_806 = {2'h0, not_801_s8_q[1]} + ({2'h0, not_801_s8_q[0]} + sum_804_s8_q);

  logic [7:0] pixel_0_s9_q;
  logic [7:0] pixel_1_s9_q;
  logic saturated_s9_q;
  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic sample_pair_whole_s9_q;
  logic [5:0] run_shift_s9_q;
  logic [7:0] x_s9_q;
  logic [1:0] age_s9_q;
  logic lower_half_s9_q;
  logic equal_313_s9_q;
  logic [8:0] select_319_s9_q;
  logic and_328_s9_q;
  logic equal_334_s9_q;
  logic whole_s9_q;
  logic [6:0] column_s9_q;
  logic and_352_s9_q;
  logic and_354_s9_q;
  logic equal_357_s9_q;
  logic equal_373_s9_q;
  logic not_374_s9_q;
  logic equal_375_s9_q;
  logic less_376_s9_q;
  logic not_377_s9_q;
  logic equal_408_s9_q;
  logic drew_s9_q;
  logic and_464_s9_q;
  logic left_rdata_s9_q;
  logic [6:0] x_s9_2_q;
  logic and_518_s9_q;
  logic equal_524_s9_q;
  logic and_530_s9_q;
  logic and_531_s9_q;
  logic [5:0] not_536_s9_q;
  logic [2:0] sum_541_s9_q;
  logic and_549_s9_q;
  logic and_550_s9_q;
  logic [5:0] not_555_s9_q;
  logic [2:0] sum_560_s9_q;
  logic and_569_s9_q;
  logic and_570_s9_q;
  logic [5:0] not_575_s9_q;
  logic [2:0] sum_580_s9_q;
  logic equal_591_s9_q;
  logic [5:0] not_596_s9_q;
  logic [2:0] sum_601_s9_q;
  logic [5:0] not_611_s9_q;
  logic [2:0] sum_616_s9_q;
  logic and_625_s9_q;
  logic [5:0] not_629_s9_q;
  logic [2:0] sum_634_s9_q;
  logic and_649_s9_q;
  logic [5:0] not_653_s9_q;
  logic [2:0] sum_658_s9_q;
  logic [5:0] not_668_s9_q;
  logic [2:0] sum_673_s9_q;
  logic [5:0] not_684_s9_q;
  logic [2:0] sum_689_s9_q;
  logic [5:0] not_708_s9_q;
  logic [2:0] sum_713_s9_q;
  logic [5:0] not_723_s9_q;
  logic [2:0] sum_728_s9_q;
  logic and_738_s9_q;
  logic [5:0] not_741_s9_q;
  logic [2:0] sum_746_s9_q;
  logic and_767_s9_q;
  logic [5:0] not_770_s9_q;
  logic [2:0] sum_775_s9_q;
  logic [5:0] not_785_s9_q;
  logic [2:0] sum_790_s9_q;
  logic [5:0] not_801_s9_q;
  logic [2:0] sum_806_s9_q;
  logic equal_828_s9_q;
  logic equal_892_s9_q;
  logic equal_915_s9_q;
  logic equal_918_s9_q;
  logic and_929_s9_q;
  logic and_1058_s9_q;
  logic equal_1200_s9_q;
  logic equal_1252_s9_q;
  logic not_1298_s9_q;
  logic and_1386_s9_q;
  logic less_1480_s9_q;
  logic less_1483_s9_q;
  logic equal_1745_s9_q;
  logic less_1756_s9_q;
  logic equal_1921_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      pixel_0_s9_q <= pixel_0_s8_q;
      pixel_1_s9_q <= pixel_1_s8_q;
      saturated_s9_q <= saturated_s8_q;
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      sample_pair_whole_s9_q <= sample_pair_whole_s8_q;
      run_shift_s9_q <= run_shift_s8_q;
      x_s9_q <= x_s8_q;
      age_s9_q <= age_s8_q;
      lower_half_s9_q <= lower_half_s8_q;
      equal_313_s9_q <= equal_313_s8_q;
      select_319_s9_q <= select_319_s8_q;
      and_328_s9_q <= and_328_s8_q;
      equal_334_s9_q <= equal_334_s8_q;
      whole_s9_q <= whole_s8_q;
      column_s9_q <= column_s8_q;
      and_352_s9_q <= and_352_s8_q;
      and_354_s9_q <= and_354_s8_q;
      equal_357_s9_q <= equal_357_s8_q;
      equal_373_s9_q <= equal_373_s8_q;
      not_374_s9_q <= not_374_s8_q;
      equal_375_s9_q <= equal_375_s8_q;
      less_376_s9_q <= less_376_s8_q;
      not_377_s9_q <= not_377_s8_q;
      equal_408_s9_q <= equal_408_s8_q;
      drew_s9_q <= drew_s8_q;
      and_464_s9_q <= and_464_s8_q;
      left_rdata_s9_q <= left_rdata_s8_q;
      x_s9_2_q <= x_s8_2_q;
      and_518_s9_q <= and_518_s8_q;
      equal_524_s9_q <= equal_524_s8_q;
      and_530_s9_q <= and_530_s8_q;
      and_531_s9_q <= and_531_s8_q;
      not_536_s9_q <= not_536_s8_q[7:2];
      sum_541_s9_q <= sum_541;
      and_549_s9_q <= and_549_s8_q;
      and_550_s9_q <= and_550_s8_q;
      not_555_s9_q <= not_555_s8_q[7:2];
      sum_560_s9_q <= sum_560;
      and_569_s9_q <= and_569_s8_q;
      and_570_s9_q <= and_570_s8_q;
      not_575_s9_q <= not_575_s8_q[7:2];
      sum_580_s9_q <= sum_580;
      equal_591_s9_q <= equal_591_s8_q;
      not_596_s9_q <= not_596_s8_q[7:2];
      sum_601_s9_q <= sum_601;
      not_611_s9_q <= not_611_s8_q[7:2];
      sum_616_s9_q <= sum_616;
      and_625_s9_q <= and_625_s8_q;
      not_629_s9_q <= not_629_s8_q[7:2];
      sum_634_s9_q <= sum_634;
      and_649_s9_q <= and_649_s8_q;
      not_653_s9_q <= not_653_s8_q[7:2];
      sum_658_s9_q <= sum_658;
      not_668_s9_q <= not_668_s8_q[7:2];
      sum_673_s9_q <= sum_673;
      not_684_s9_q <= not_684_s8_q[7:2];
      sum_689_s9_q <= sum_689;
      not_708_s9_q <= not_708_s8_q[7:2];
      sum_713_s9_q <= sum_713;
      not_723_s9_q <= not_723_s8_q[7:2];
      sum_728_s9_q <= sum_728;
      and_738_s9_q <= and_738_s8_q;
      not_741_s9_q <= not_741_s8_q[7:2];
      sum_746_s9_q <= sum_746;
      and_767_s9_q <= and_767_s8_q;
      not_770_s9_q <= not_770_s8_q[7:2];
      sum_775_s9_q <= sum_775;
      not_785_s9_q <= not_785_s8_q[7:2];
      sum_790_s9_q <= sum_790;
      not_801_s9_q <= not_801_s8_q[7:2];
      sum_806_s9_q <= sum_806;
      equal_828_s9_q <= equal_828_s8_q;
      equal_892_s9_q <= equal_892_s8_q;
      equal_915_s9_q <= equal_915_s8_q;
      equal_918_s9_q <= equal_918_s8_q;
      and_929_s9_q <= and_929_s8_q;
      and_1058_s9_q <= and_1058_s8_q;
      equal_1200_s9_q <= equal_1200_s8_q;
      equal_1252_s9_q <= equal_1252_s8_q;
      not_1298_s9_q <= not_1298_s8_q;
      and_1386_s9_q <= and_1386_s8_q;
      less_1480_s9_q <= less_1480_s8_q;
      less_1483_s9_q <= less_1483_s8_q;
      equal_1745_s9_q <= equal_1745_s8_q;
      less_1756_s9_q <= less_1756_s8_q;
      equal_1921_s9_q <= equal_1921_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:395
  logic [2:0] sum_542;
  assign sum_542 = {2'h0, not_536_s9_q[0]} + sum_541_s9_q;
  logic [2:0] sum_561;
  assign sum_561 = {2'h0, not_555_s9_q[0]} + sum_560_s9_q;
  logic [2:0] sum_581;
  assign sum_581 = {2'h0, not_575_s9_q[0]} + sum_580_s9_q;
  logic [2:0] sum_602;
  assign sum_602 = {2'h0, not_596_s9_q[0]} + sum_601_s9_q;
  logic [2:0] sum_617;
  assign sum_617 = {2'h0, not_611_s9_q[0]} + sum_616_s9_q;
  logic [2:0] sum_635;
  assign sum_635 = {2'h0, not_629_s9_q[0]} + sum_634_s9_q;
  logic [2:0] sum_659;
  assign sum_659 = {2'h0, not_653_s9_q[0]} + sum_658_s9_q;
  logic [2:0] sum_674;
  assign sum_674 = {2'h0, not_668_s9_q[0]} + sum_673_s9_q;
  logic [2:0] sum_690;
  assign sum_690 = {2'h0, not_684_s9_q[0]} + sum_689_s9_q;
  logic [2:0] sum_714;
  assign sum_714 = {2'h0, not_708_s9_q[0]} + sum_713_s9_q;
  logic [2:0] sum_729;
  assign sum_729 = {2'h0, not_723_s9_q[0]} + sum_728_s9_q;
  logic [2:0] sum_747;
  assign sum_747 = {2'h0, not_741_s9_q[0]} + sum_746_s9_q;
  logic [2:0] sum_776;
  assign sum_776 = {2'h0, not_770_s9_q[0]} + sum_775_s9_q;
  logic [2:0] sum_791;
  assign sum_791 = {2'h0, not_785_s9_q[0]} + sum_790_s9_q;
  logic [2:0] sum_807;
  assign sum_807 = {2'h0, not_801_s9_q[0]} + sum_806_s9_q;

  logic [7:0] pixel_0_s10_q;
  logic [7:0] pixel_1_s10_q;
  logic saturated_s10_q;
  logic mask_s10_q;
  logic marks_first_s10_q;
  logic marks_last_s10_q;
  logic sample_pair_whole_s10_q;
  logic [5:0] run_shift_s10_q;
  logic [7:0] x_s10_q;
  logic [1:0] age_s10_q;
  logic lower_half_s10_q;
  logic equal_313_s10_q;
  logic [8:0] select_319_s10_q;
  logic and_328_s10_q;
  logic equal_334_s10_q;
  logic whole_s10_q;
  logic [6:0] column_s10_q;
  logic and_352_s10_q;
  logic and_354_s10_q;
  logic equal_357_s10_q;
  logic equal_373_s10_q;
  logic not_374_s10_q;
  logic equal_375_s10_q;
  logic less_376_s10_q;
  logic not_377_s10_q;
  logic equal_408_s10_q;
  logic drew_s10_q;
  logic and_464_s10_q;
  logic left_rdata_s10_q;
  logic [6:0] x_s10_2_q;
  logic and_518_s10_q;
  logic equal_524_s10_q;
  logic and_530_s10_q;
  logic and_531_s10_q;
  logic [3:0] not_536_s10_q;
  logic [3:0] sum_543_s10_q;
  logic and_549_s10_q;
  logic and_550_s10_q;
  logic [3:0] not_555_s10_q;
  logic [3:0] sum_562_s10_q;
  logic and_569_s10_q;
  logic and_570_s10_q;
  logic [3:0] not_575_s10_q;
  logic [3:0] sum_582_s10_q;
  logic equal_591_s10_q;
  logic [3:0] not_596_s10_q;
  logic [3:0] sum_603_s10_q;
  logic [3:0] not_611_s10_q;
  logic [3:0] sum_618_s10_q;
  logic and_625_s10_q;
  logic [3:0] not_629_s10_q;
  logic [3:0] sum_636_s10_q;
  logic and_649_s10_q;
  logic [3:0] not_653_s10_q;
  logic [3:0] sum_660_s10_q;
  logic [3:0] not_668_s10_q;
  logic [3:0] sum_675_s10_q;
  logic [3:0] not_684_s10_q;
  logic [3:0] sum_691_s10_q;
  logic [3:0] not_708_s10_q;
  logic [3:0] sum_715_s10_q;
  logic [3:0] not_723_s10_q;
  logic [3:0] sum_730_s10_q;
  logic and_738_s10_q;
  logic [3:0] not_741_s10_q;
  logic [3:0] sum_748_s10_q;
  logic and_767_s10_q;
  logic [3:0] not_770_s10_q;
  logic [3:0] sum_777_s10_q;
  logic [3:0] not_785_s10_q;
  logic [3:0] sum_792_s10_q;
  logic [3:0] not_801_s10_q;
  logic [3:0] sum_808_s10_q;
  logic equal_828_s10_q;
  logic equal_892_s10_q;
  logic equal_915_s10_q;
  logic equal_918_s10_q;
  logic and_929_s10_q;
  logic and_1058_s10_q;
  logic equal_1200_s10_q;
  logic equal_1252_s10_q;
  logic not_1298_s10_q;
  logic and_1386_s10_q;
  logic less_1480_s10_q;
  logic less_1483_s10_q;
  logic equal_1745_s10_q;
  logic less_1756_s10_q;
  logic equal_1921_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      pixel_0_s10_q <= pixel_0_s9_q;
      pixel_1_s10_q <= pixel_1_s9_q;
      saturated_s10_q <= saturated_s9_q;
      mask_s10_q <= mask_s9_q;
      marks_first_s10_q <= marks_first_s9_q;
      marks_last_s10_q <= marks_last_s9_q;
      sample_pair_whole_s10_q <= sample_pair_whole_s9_q;
      run_shift_s10_q <= run_shift_s9_q;
      x_s10_q <= x_s9_q;
      age_s10_q <= age_s9_q;
      lower_half_s10_q <= lower_half_s9_q;
      equal_313_s10_q <= equal_313_s9_q;
      select_319_s10_q <= select_319_s9_q;
      and_328_s10_q <= and_328_s9_q;
      equal_334_s10_q <= equal_334_s9_q;
      whole_s10_q <= whole_s9_q;
      column_s10_q <= column_s9_q;
      and_352_s10_q <= and_352_s9_q;
      and_354_s10_q <= and_354_s9_q;
      equal_357_s10_q <= equal_357_s9_q;
      equal_373_s10_q <= equal_373_s9_q;
      not_374_s10_q <= not_374_s9_q;
      equal_375_s10_q <= equal_375_s9_q;
      less_376_s10_q <= less_376_s9_q;
      not_377_s10_q <= not_377_s9_q;
      equal_408_s10_q <= equal_408_s9_q;
      drew_s10_q <= drew_s9_q;
      and_464_s10_q <= and_464_s9_q;
      left_rdata_s10_q <= left_rdata_s9_q;
      x_s10_2_q <= x_s9_2_q;
      and_518_s10_q <= and_518_s9_q;
      equal_524_s10_q <= equal_524_s9_q;
      and_530_s10_q <= and_530_s9_q;
      and_531_s10_q <= and_531_s9_q;
      not_536_s10_q <= not_536_s9_q[5:2];
      sum_543_s10_q <= {3'h0, not_536_s9_q[1]} + {1'b0, sum_542};
      and_549_s10_q <= and_549_s9_q;
      and_550_s10_q <= and_550_s9_q;
      not_555_s10_q <= not_555_s9_q[5:2];
      sum_562_s10_q <= {3'h0, not_555_s9_q[1]} + {1'b0, sum_561};
      and_569_s10_q <= and_569_s9_q;
      and_570_s10_q <= and_570_s9_q;
      not_575_s10_q <= not_575_s9_q[5:2];
      sum_582_s10_q <= {3'h0, not_575_s9_q[1]} + {1'b0, sum_581};
      equal_591_s10_q <= equal_591_s9_q;
      not_596_s10_q <= not_596_s9_q[5:2];
      sum_603_s10_q <= {3'h0, not_596_s9_q[1]} + {1'b0, sum_602};
      not_611_s10_q <= not_611_s9_q[5:2];
      sum_618_s10_q <= {3'h0, not_611_s9_q[1]} + {1'b0, sum_617};
      and_625_s10_q <= and_625_s9_q;
      not_629_s10_q <= not_629_s9_q[5:2];
      sum_636_s10_q <= {3'h0, not_629_s9_q[1]} + {1'b0, sum_635};
      and_649_s10_q <= and_649_s9_q;
      not_653_s10_q <= not_653_s9_q[5:2];
      sum_660_s10_q <= {3'h0, not_653_s9_q[1]} + {1'b0, sum_659};
      not_668_s10_q <= not_668_s9_q[5:2];
      sum_675_s10_q <= {3'h0, not_668_s9_q[1]} + {1'b0, sum_674};
      not_684_s10_q <= not_684_s9_q[5:2];
      sum_691_s10_q <= {3'h0, not_684_s9_q[1]} + {1'b0, sum_690};
      not_708_s10_q <= not_708_s9_q[5:2];
      sum_715_s10_q <= {3'h0, not_708_s9_q[1]} + {1'b0, sum_714};
      not_723_s10_q <= not_723_s9_q[5:2];
      sum_730_s10_q <= {3'h0, not_723_s9_q[1]} + {1'b0, sum_729};
      and_738_s10_q <= and_738_s9_q;
      not_741_s10_q <= not_741_s9_q[5:2];
      sum_748_s10_q <= {3'h0, not_741_s9_q[1]} + {1'b0, sum_747};
      and_767_s10_q <= and_767_s9_q;
      not_770_s10_q <= not_770_s9_q[5:2];
      sum_777_s10_q <= {3'h0, not_770_s9_q[1]} + {1'b0, sum_776};
      not_785_s10_q <= not_785_s9_q[5:2];
      sum_792_s10_q <= {3'h0, not_785_s9_q[1]} + {1'b0, sum_791};
      not_801_s10_q <= not_801_s9_q[5:2];
      sum_808_s10_q <= {3'h0, not_801_s9_q[1]} + {1'b0, sum_807};
      equal_828_s10_q <= equal_828_s9_q;
      equal_892_s10_q <= equal_892_s9_q;
      equal_915_s10_q <= equal_915_s9_q;
      equal_918_s10_q <= equal_918_s9_q;
      and_929_s10_q <= and_929_s9_q;
      and_1058_s10_q <= and_1058_s9_q;
      equal_1200_s10_q <= equal_1200_s9_q;
      equal_1252_s10_q <= equal_1252_s9_q;
      not_1298_s10_q <= not_1298_s9_q;
      and_1386_s10_q <= and_1386_s9_q;
      less_1480_s10_q <= less_1480_s9_q;
      less_1483_s10_q <= less_1483_s9_q;
      equal_1745_s10_q <= equal_1745_s9_q;
      less_1756_s10_q <= less_1756_s9_q;
      equal_1921_s10_q <= equal_1921_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:395
  logic [3:0] sum_545;
  assign sum_545 = {3'h0, not_536_s10_q[1]} + ({3'h0, not_536_s10_q[0]} + sum_543_s10_q);
  logic [3:0] sum_564;
  assign sum_564 = {3'h0, not_555_s10_q[1]} + ({3'h0, not_555_s10_q[0]} + sum_562_s10_q);
  logic [3:0] sum_584;
  assign sum_584 = {3'h0, not_575_s10_q[1]} + ({3'h0, not_575_s10_q[0]} + sum_582_s10_q);
  logic [3:0] sum_605;
  assign sum_605 = {3'h0, not_596_s10_q[1]} + ({3'h0, not_596_s10_q[0]} + sum_603_s10_q);
  logic [3:0] sum_620;
  assign sum_620 = {3'h0, not_611_s10_q[1]} + ({3'h0, not_611_s10_q[0]} + sum_618_s10_q);
  logic [3:0] sum_638;
  assign sum_638 = {3'h0, not_629_s10_q[1]} + ({3'h0, not_629_s10_q[0]} + sum_636_s10_q);
  logic [3:0] sum_662;
  assign sum_662 = {3'h0, not_653_s10_q[1]} + ({3'h0, not_653_s10_q[0]} + sum_660_s10_q);
  logic [3:0] sum_677;
  assign sum_677 = {3'h0, not_668_s10_q[1]} + ({3'h0, not_668_s10_q[0]} + sum_675_s10_q);
  logic [3:0] sum_693;
  assign sum_693 = {3'h0, not_684_s10_q[1]} + ({3'h0, not_684_s10_q[0]} + sum_691_s10_q);
  logic [3:0] sum_717;
  assign sum_717 = {3'h0, not_708_s10_q[1]} + ({3'h0, not_708_s10_q[0]} + sum_715_s10_q);
  logic [3:0] sum_732;
  assign sum_732 = {3'h0, not_723_s10_q[1]} + ({3'h0, not_723_s10_q[0]} + sum_730_s10_q);
  logic [3:0] sum_750;
  assign sum_750 = {3'h0, not_741_s10_q[1]} + ({3'h0, not_741_s10_q[0]} + sum_748_s10_q);
  logic [3:0] sum_779;
  assign sum_779 = {3'h0, not_770_s10_q[1]} + ({3'h0, not_770_s10_q[0]} + sum_777_s10_q);
  logic [3:0] sum_794;
  assign sum_794 = {3'h0, not_785_s10_q[1]} + ({3'h0, not_785_s10_q[0]} + sum_792_s10_q);
  logic [3:0] sum_810;
  assign sum_810 = {3'h0, not_801_s10_q[1]} + ({3'h0, not_801_s10_q[0]} + sum_808_s10_q);

  logic [7:0] pixel_0_s11_q;
  logic [7:0] pixel_1_s11_q;
  logic saturated_s11_q;
  logic mask_s11_q;
  logic marks_first_s11_q;
  logic marks_last_s11_q;
  logic sample_pair_whole_s11_q;
  logic [5:0] run_shift_s11_q;
  logic [7:0] x_s11_q;
  logic [1:0] age_s11_q;
  logic lower_half_s11_q;
  logic equal_313_s11_q;
  logic [8:0] select_319_s11_q;
  logic and_328_s11_q;
  logic equal_334_s11_q;
  logic whole_s11_q;
  logic [6:0] column_s11_q;
  logic and_352_s11_q;
  logic and_354_s11_q;
  logic equal_357_s11_q;
  logic equal_373_s11_q;
  logic not_374_s11_q;
  logic equal_375_s11_q;
  logic less_376_s11_q;
  logic not_377_s11_q;
  logic equal_408_s11_q;
  logic drew_s11_q;
  logic and_464_s11_q;
  logic left_rdata_s11_q;
  logic [6:0] x_s11_2_q;
  logic and_518_s11_q;
  logic equal_524_s11_q;
  logic and_530_s11_q;
  logic and_531_s11_q;
  logic [1:0] not_536_s11_q;
  logic [3:0] sum_545_s11_q;
  logic and_549_s11_q;
  logic and_550_s11_q;
  logic [1:0] not_555_s11_q;
  logic [3:0] sum_564_s11_q;
  logic and_569_s11_q;
  logic and_570_s11_q;
  logic [1:0] not_575_s11_q;
  logic [3:0] sum_584_s11_q;
  logic equal_591_s11_q;
  logic [1:0] not_596_s11_q;
  logic [3:0] sum_605_s11_q;
  logic [1:0] not_611_s11_q;
  logic [3:0] sum_620_s11_q;
  logic and_625_s11_q;
  logic [1:0] not_629_s11_q;
  logic [3:0] sum_638_s11_q;
  logic and_649_s11_q;
  logic [1:0] not_653_s11_q;
  logic [3:0] sum_662_s11_q;
  logic [1:0] not_668_s11_q;
  logic [3:0] sum_677_s11_q;
  logic [1:0] not_684_s11_q;
  logic [3:0] sum_693_s11_q;
  logic [1:0] not_708_s11_q;
  logic [3:0] sum_717_s11_q;
  logic [1:0] not_723_s11_q;
  logic [3:0] sum_732_s11_q;
  logic and_738_s11_q;
  logic [1:0] not_741_s11_q;
  logic [3:0] sum_750_s11_q;
  logic and_767_s11_q;
  logic [1:0] not_770_s11_q;
  logic [3:0] sum_779_s11_q;
  logic [1:0] not_785_s11_q;
  logic [3:0] sum_794_s11_q;
  logic [1:0] not_801_s11_q;
  logic [3:0] sum_810_s11_q;
  logic equal_828_s11_q;
  logic equal_892_s11_q;
  logic equal_915_s11_q;
  logic equal_918_s11_q;
  logic and_929_s11_q;
  logic and_1058_s11_q;
  logic equal_1200_s11_q;
  logic equal_1252_s11_q;
  logic not_1298_s11_q;
  logic and_1386_s11_q;
  logic less_1480_s11_q;
  logic less_1483_s11_q;
  logic equal_1745_s11_q;
  logic less_1756_s11_q;
  logic equal_1921_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      pixel_0_s11_q <= pixel_0_s10_q;
      pixel_1_s11_q <= pixel_1_s10_q;
      saturated_s11_q <= saturated_s10_q;
      mask_s11_q <= mask_s10_q;
      marks_first_s11_q <= marks_first_s10_q;
      marks_last_s11_q <= marks_last_s10_q;
      sample_pair_whole_s11_q <= sample_pair_whole_s10_q;
      run_shift_s11_q <= run_shift_s10_q;
      x_s11_q <= x_s10_q;
      age_s11_q <= age_s10_q;
      lower_half_s11_q <= lower_half_s10_q;
      equal_313_s11_q <= equal_313_s10_q;
      select_319_s11_q <= select_319_s10_q;
      and_328_s11_q <= and_328_s10_q;
      equal_334_s11_q <= equal_334_s10_q;
      whole_s11_q <= whole_s10_q;
      column_s11_q <= column_s10_q;
      and_352_s11_q <= and_352_s10_q;
      and_354_s11_q <= and_354_s10_q;
      equal_357_s11_q <= equal_357_s10_q;
      equal_373_s11_q <= equal_373_s10_q;
      not_374_s11_q <= not_374_s10_q;
      equal_375_s11_q <= equal_375_s10_q;
      less_376_s11_q <= less_376_s10_q;
      not_377_s11_q <= not_377_s10_q;
      equal_408_s11_q <= equal_408_s10_q;
      drew_s11_q <= drew_s10_q;
      and_464_s11_q <= and_464_s10_q;
      left_rdata_s11_q <= left_rdata_s10_q;
      x_s11_2_q <= x_s10_2_q;
      and_518_s11_q <= and_518_s10_q;
      equal_524_s11_q <= equal_524_s10_q;
      and_530_s11_q <= and_530_s10_q;
      and_531_s11_q <= and_531_s10_q;
      not_536_s11_q <= not_536_s10_q[3:2];
      sum_545_s11_q <= sum_545;
      and_549_s11_q <= and_549_s10_q;
      and_550_s11_q <= and_550_s10_q;
      not_555_s11_q <= not_555_s10_q[3:2];
      sum_564_s11_q <= sum_564;
      and_569_s11_q <= and_569_s10_q;
      and_570_s11_q <= and_570_s10_q;
      not_575_s11_q <= not_575_s10_q[3:2];
      sum_584_s11_q <= sum_584;
      equal_591_s11_q <= equal_591_s10_q;
      not_596_s11_q <= not_596_s10_q[3:2];
      sum_605_s11_q <= sum_605;
      not_611_s11_q <= not_611_s10_q[3:2];
      sum_620_s11_q <= sum_620;
      and_625_s11_q <= and_625_s10_q;
      not_629_s11_q <= not_629_s10_q[3:2];
      sum_638_s11_q <= sum_638;
      and_649_s11_q <= and_649_s10_q;
      not_653_s11_q <= not_653_s10_q[3:2];
      sum_662_s11_q <= sum_662;
      not_668_s11_q <= not_668_s10_q[3:2];
      sum_677_s11_q <= sum_677;
      not_684_s11_q <= not_684_s10_q[3:2];
      sum_693_s11_q <= sum_693;
      not_708_s11_q <= not_708_s10_q[3:2];
      sum_717_s11_q <= sum_717;
      not_723_s11_q <= not_723_s10_q[3:2];
      sum_732_s11_q <= sum_732;
      and_738_s11_q <= and_738_s10_q;
      not_741_s11_q <= not_741_s10_q[3:2];
      sum_750_s11_q <= sum_750;
      and_767_s11_q <= and_767_s10_q;
      not_770_s11_q <= not_770_s10_q[3:2];
      sum_779_s11_q <= sum_779;
      not_785_s11_q <= not_785_s10_q[3:2];
      sum_794_s11_q <= sum_794;
      not_801_s11_q <= not_801_s10_q[3:2];
      sum_810_s11_q <= sum_810;
      equal_828_s11_q <= equal_828_s10_q;
      equal_892_s11_q <= equal_892_s10_q;
      equal_915_s11_q <= equal_915_s10_q;
      equal_918_s11_q <= equal_918_s10_q;
      and_929_s11_q <= and_929_s10_q;
      and_1058_s11_q <= and_1058_s10_q;
      equal_1200_s11_q <= equal_1200_s10_q;
      equal_1252_s11_q <= equal_1252_s10_q;
      not_1298_s11_q <= not_1298_s10_q;
      and_1386_s11_q <= and_1386_s10_q;
      less_1480_s11_q <= less_1480_s10_q;
      less_1483_s11_q <= less_1483_s10_q;
      equal_1745_s11_q <= equal_1745_s10_q;
      less_1756_s11_q <= less_1756_s10_q;
      equal_1921_s11_q <= equal_1921_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [23:0] registration_next_slope_row_q;
  logic [27:0] registration_next_slope_change_q;
  // hls/stages/agreement.hpp:337
  logic not_519;
  assign not_519 = ~equal_375_s11_q;
  // hls/stages/agreement.hpp:317
  logic and_520;
  assign and_520 = not_519 & and_464_s11_q;
  logic select_521;
  assign select_521 = equal_373_s11_q ? and_518_s11_q : and_520;
  // hls/stages/agreement.hpp:395
  logic [3:0] sum_547;
  assign sum_547 = {3'h0, not_536_s11_q[1]} + ({3'h0, not_536_s11_q[0]} + sum_545_s11_q);
  logic [3:0] column_2;
  assign column_2 = (and_530_s11_q & and_531_s11_q) ? sum_547 : 4'h0;
  logic [3:0] sum_566;
  assign sum_566 = {3'h0, not_555_s11_q[1]} + ({3'h0, not_555_s11_q[0]} + sum_564_s11_q);
  logic [3:0] sum_586;
  assign sum_586 = {3'h0, not_575_s11_q[1]} + ({3'h0, not_575_s11_q[0]} + sum_584_s11_q);
  logic [3:0] sum_607;
  assign sum_607 = {3'h0, not_596_s11_q[1]} + ({3'h0, not_596_s11_q[0]} + sum_605_s11_q);
  logic [3:0] column_5;
  assign column_5 = (and_530_s11_q & and_550_s11_q) ? sum_607 : 4'h0;
  logic [3:0] sum_622;
  assign sum_622 = {3'h0, not_611_s11_q[1]} + ({3'h0, not_611_s11_q[0]} + sum_620_s11_q);
  logic [3:0] sum_640;
  assign sum_640 = {3'h0, not_629_s11_q[1]} + ({3'h0, not_629_s11_q[0]} + sum_638_s11_q);
  logic [3:0] sum_664;
  assign sum_664 = {3'h0, not_653_s11_q[1]} + ({3'h0, not_653_s11_q[0]} + sum_662_s11_q);
  logic [3:0] column_8;
  assign column_8 = (and_530_s11_q & and_649_s11_q) ? sum_664 : 4'h0;
  logic [3:0] sum_679;
  assign sum_679 = {3'h0, not_668_s11_q[1]} + ({3'h0, not_668_s11_q[0]} + sum_677_s11_q);
  logic [3:0] sum_695;
  assign sum_695 = {3'h0, not_684_s11_q[1]} + ({3'h0, not_684_s11_q[0]} + sum_693_s11_q);
  logic [3:0] sum_719;
  assign sum_719 = {3'h0, not_708_s11_q[1]} + ({3'h0, not_708_s11_q[0]} + sum_717_s11_q);
  logic [3:0] column_11;
  assign column_11 = (and_530_s11_q & and_570_s11_q) ? sum_719 : 4'h0;
  logic [3:0] sum_734;
  assign sum_734 = {3'h0, not_723_s11_q[1]} + ({3'h0, not_723_s11_q[0]} + sum_732_s11_q);
  logic [3:0] sum_752;
  assign sum_752 = {3'h0, not_741_s11_q[1]} + ({3'h0, not_741_s11_q[0]} + sum_750_s11_q);
  logic [3:0] sum_781;
  assign sum_781 = {3'h0, not_770_s11_q[1]} + ({3'h0, not_770_s11_q[0]} + sum_779_s11_q);
  logic [3:0] column_14;
  assign column_14 = and_767_s11_q ? sum_781 : 4'h0;
  logic [3:0] sum_796;
  assign sum_796 = {3'h0, not_785_s11_q[1]} + ({3'h0, not_785_s11_q[0]} + sum_794_s11_q);
  logic [3:0] sum_812;
  assign sum_812 = {3'h0, not_801_s11_q[1]} + ({3'h0, not_801_s11_q[0]} + sum_810_s11_q);
  // hls/stages/registration.hpp:158
  logic [16:0] select_1488;
  assign select_1488 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/registration.hpp:57
  logic [23:0] select_1746;
  assign select_1746 = equal_1745_s11_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:184
  logic [23:0] select_1748;
  assign select_1748 = and_354_s11_q ? (equal_1252_s11_q ? select_1746 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1749;
  assign select_1749 = equal_1745_s11_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:184
  logic [27:0] select_1751;
  assign select_1751 = and_354_s11_q ? (equal_1252_s11_q ? select_1749 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1753;
  assign select_1753 = drew_s11_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1754;
  assign sum_1754 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1755;
  assign sum_1755 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

  // Memory best_left, 120 x 22, DISTANCE 32, hls/stages/agreement.hpp:805; read in stage 11, written in stage 28: 11 < 28 < 11 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 22'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = equal_373_s11_q ? x_s11_2_q : x_s11_q[6:0];
  logic best_left_re;
  assign best_left_re = s11_en & select_521;
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
    end else if (s11_en) begin
      registration_slope_row_q <= select_1748;
      registration_slope_change_q <= select_1751;
      registration_slope_q <= select_1753;
      registration_next_slope_row_q <= sum_1754;
      registration_next_slope_change_q <= sum_1755;
    end
  end

  logic [7:0] pixel_0_s12_q;
  logic [7:0] pixel_1_s12_q;
  logic saturated_s12_q;
  logic mask_s12_q;
  logic marks_first_s12_q;
  logic marks_last_s12_q;
  logic sample_pair_whole_s12_q;
  logic [5:0] run_shift_s12_q;
  logic [7:0] x_s12_q;
  logic [1:0] age_s12_q;
  logic lower_half_s12_q;
  logic [11:0] registration_slope_s12_q;
  logic equal_313_s12_q;
  logic [8:0] select_319_s12_q;
  logic and_328_s12_q;
  logic equal_334_s12_q;
  logic whole_s12_q;
  logic [6:0] column_s12_q;
  logic and_352_s12_q;
  logic and_354_s12_q;
  logic equal_357_s12_q;
  logic equal_373_s12_q;
  logic not_374_s12_q;
  logic equal_375_s12_q;
  logic less_376_s12_q;
  logic not_377_s12_q;
  logic equal_408_s12_q;
  logic drew_s12_q;
  logic left_rdata_s12_q;
  logic [6:0] x_s12_2_q;
  logic not_519_s12_q;
  logic select_521_s12_q;
  logic equal_524_s12_q;
  logic [3:0] column_2_s12_q;
  logic [3:0] select_567_s12_q;
  logic [3:0] select_587_s12_q;
  logic equal_591_s12_q;
  logic [3:0] column_5_s12_q;
  logic [3:0] select_623_s12_q;
  logic [3:0] select_641_s12_q;
  logic [3:0] column_8_s12_q;
  logic [3:0] select_680_s12_q;
  logic [3:0] select_696_s12_q;
  logic [3:0] column_11_s12_q;
  logic [3:0] select_735_s12_q;
  logic [3:0] select_753_s12_q;
  logic [3:0] column_14_s12_q;
  logic [3:0] select_797_s12_q;
  logic [3:0] select_813_s12_q;
  logic equal_828_s12_q;
  logic and_886_s12_q;
  logic equal_892_s12_q;
  logic equal_915_s12_q;
  logic equal_918_s12_q;
  logic and_929_s12_q;
  logic and_960_s12_q;
  logic and_1060_s12_q;
  logic equal_1200_s12_q;
  logic equal_1252_s12_q;
  logic not_1298_s12_q;
  logic and_1386_s12_q;
  logic less_1480_s12_q;
  logic less_1483_s12_q;
  logic [16:0] select_1488_s12_q;
  logic less_1756_s12_q;
  logic equal_1921_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
      pixel_0_s12_q <= pixel_0_s11_q;
      pixel_1_s12_q <= pixel_1_s11_q;
      saturated_s12_q <= saturated_s11_q;
      mask_s12_q <= mask_s11_q;
      marks_first_s12_q <= marks_first_s11_q;
      marks_last_s12_q <= marks_last_s11_q;
      sample_pair_whole_s12_q <= sample_pair_whole_s11_q;
      run_shift_s12_q <= run_shift_s11_q;
      x_s12_q <= x_s11_q;
      age_s12_q <= age_s11_q;
      lower_half_s12_q <= lower_half_s11_q;
      registration_slope_s12_q <= registration_slope_q[27:16];
      equal_313_s12_q <= equal_313_s11_q;
      select_319_s12_q <= select_319_s11_q;
      and_328_s12_q <= and_328_s11_q;
      equal_334_s12_q <= equal_334_s11_q;
      whole_s12_q <= whole_s11_q;
      column_s12_q <= column_s11_q;
      and_352_s12_q <= and_352_s11_q;
      and_354_s12_q <= and_354_s11_q;
      equal_357_s12_q <= equal_357_s11_q;
      equal_373_s12_q <= equal_373_s11_q;
      not_374_s12_q <= not_374_s11_q;
      equal_375_s12_q <= equal_375_s11_q;
      less_376_s12_q <= less_376_s11_q;
      not_377_s12_q <= not_377_s11_q;
      equal_408_s12_q <= equal_408_s11_q;
      drew_s12_q <= drew_s11_q;
      left_rdata_s12_q <= left_rdata_s11_q;
      x_s12_2_q <= x_s11_2_q;
      not_519_s12_q <= not_519;
      select_521_s12_q <= select_521;
      equal_524_s12_q <= equal_524_s11_q;
      column_2_s12_q <= column_2;
      select_567_s12_q <= (and_549_s11_q & and_550_s11_q) ? sum_566 : 4'h0;
      select_587_s12_q <= (and_569_s11_q & and_570_s11_q) ? sum_586 : 4'h0;
      equal_591_s12_q <= equal_591_s11_q;
      column_5_s12_q <= column_5;
      select_623_s12_q <= (and_549_s11_q & and_570_s11_q) ? sum_622 : 4'h0;
      select_641_s12_q <= (and_569_s11_q & and_625_s11_q) ? sum_640 : 4'h0;
      column_8_s12_q <= column_8;
      select_680_s12_q <= (and_549_s11_q & and_531_s11_q) ? sum_679 : 4'h0;
      select_696_s12_q <= (and_569_s11_q & and_550_s11_q) ? sum_695 : 4'h0;
      column_11_s12_q <= column_11;
      select_735_s12_q <= (and_549_s11_q & and_625_s11_q) ? sum_734 : 4'h0;
      select_753_s12_q <= and_738_s11_q ? sum_752 : 4'h0;
      column_14_s12_q <= column_14;
      select_797_s12_q <= (and_549_s11_q & and_649_s11_q) ? sum_796 : 4'h0;
      select_813_s12_q <= (and_569_s11_q & and_531_s11_q) ? sum_812 : 4'h0;
      equal_828_s12_q <= equal_828_s11_q;
      and_886_s12_q <= equal_373_s11_q & and_518_s11_q;
      equal_892_s12_q <= equal_892_s11_q;
      equal_915_s12_q <= equal_915_s11_q;
      equal_918_s12_q <= equal_918_s11_q;
      and_929_s12_q <= and_929_s11_q;
      and_960_s12_q <= not_374_s11_q & and_520;
      and_1060_s12_q <= not_374_s11_q & (not_519 & and_1058_s11_q);
      equal_1200_s12_q <= equal_1200_s11_q;
      equal_1252_s12_q <= equal_1252_s11_q;
      not_1298_s12_q <= not_1298_s11_q;
      and_1386_s12_q <= and_1386_s11_q;
      less_1480_s12_q <= less_1480_s11_q;
      less_1483_s12_q <= less_1483_s11_q;
      select_1488_s12_q <= select_1488;
      less_1756_s12_q <= less_1756_s11_q;
      equal_1921_s12_q <= equal_1921_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:423
  logic [4:0] column_3;
  assign column_3 = {1'b0, column_2_s12_q} + {1'b0, select_567_s12_q};
  logic [5:0] column_4;
  assign column_4 = {1'b0, column_3} + {2'h0, select_587_s12_q};
  logic [4:0] column_6;
  assign column_6 = {1'b0, column_5_s12_q} + {1'b0, select_623_s12_q};
  logic [5:0] column_7;
  assign column_7 = {1'b0, column_6} + {2'h0, select_641_s12_q};
  logic [4:0] column_9;
  assign column_9 = {1'b0, column_8_s12_q} + {1'b0, select_680_s12_q};
  logic [5:0] column_10;
  assign column_10 = {1'b0, column_9} + {2'h0, select_696_s12_q};
  logic [4:0] column_12;
  assign column_12 = {1'b0, column_11_s12_q} + {1'b0, select_735_s12_q};
  logic [5:0] column_13;
  assign column_13 = {1'b0, column_12} + {2'h0, select_753_s12_q};
  logic [4:0] column_15;
  assign column_15 = {1'b0, column_14_s12_q} + {1'b0, select_797_s12_q};
  logic [5:0] column_16;
  assign column_16 = {1'b0, column_15} + {2'h0, select_813_s12_q};
  // hls/stages/registration.hpp:158
  logic [13:0] select_1490;
  assign select_1490 = ($signed(10'h0) < $signed(select_1488_s12_q[16:7])) ? 14'h7f : select_1488_s12_q[13:0];

  logic [7:0] pixel_0_s13_q;
  logic [7:0] pixel_1_s13_q;
  logic saturated_s13_q;
  logic mask_s13_q;
  logic marks_first_s13_q;
  logic marks_last_s13_q;
  logic sample_pair_whole_s13_q;
  logic [5:0] run_shift_s13_q;
  logic [7:0] x_s13_q;
  logic [1:0] age_s13_q;
  logic lower_half_s13_q;
  logic [11:0] registration_slope_s13_q;
  logic equal_313_s13_q;
  logic [8:0] select_319_s13_q;
  logic and_328_s13_q;
  logic equal_334_s13_q;
  logic whole_s13_q;
  logic [6:0] column_s13_q;
  logic and_352_s13_q;
  logic and_354_s13_q;
  logic equal_357_s13_q;
  logic equal_373_s13_q;
  logic not_374_s13_q;
  logic equal_375_s13_q;
  logic less_376_s13_q;
  logic not_377_s13_q;
  logic equal_408_s13_q;
  logic drew_s13_q;
  logic left_rdata_s13_q;
  logic [6:0] x_s13_2_q;
  logic not_519_s13_q;
  logic select_521_s13_q;
  logic [21:0] best_left_rdata_s13_q;
  logic equal_524_s13_q;
  logic [5:0] column_4_s13_q;
  logic equal_591_s13_q;
  logic [5:0] column_7_s13_q;
  logic [5:0] column_10_s13_q;
  logic [5:0] column_13_s13_q;
  logic [5:0] column_16_s13_q;
  logic equal_828_s13_q;
  logic and_886_s13_q;
  logic equal_892_s13_q;
  logic equal_915_s13_q;
  logic equal_918_s13_q;
  logic and_929_s13_q;
  logic and_960_s13_q;
  logic and_1060_s13_q;
  logic equal_1200_s13_q;
  logic equal_1252_s13_q;
  logic not_1298_s13_q;
  logic and_1386_s13_q;
  logic less_1480_s13_q;
  logic less_1483_s13_q;
  logic [13:0] select_1490_s13_q;
  logic less_1756_s13_q;
  logic equal_1921_s13_q;
  always_ff @(posedge clk_i) begin
    if (s12_en) begin
      pixel_0_s13_q <= pixel_0_s12_q;
      pixel_1_s13_q <= pixel_1_s12_q;
      saturated_s13_q <= saturated_s12_q;
      mask_s13_q <= mask_s12_q;
      marks_first_s13_q <= marks_first_s12_q;
      marks_last_s13_q <= marks_last_s12_q;
      sample_pair_whole_s13_q <= sample_pair_whole_s12_q;
      run_shift_s13_q <= run_shift_s12_q;
      x_s13_q <= x_s12_q;
      age_s13_q <= age_s12_q;
      lower_half_s13_q <= lower_half_s12_q;
      registration_slope_s13_q <= registration_slope_s12_q;
      equal_313_s13_q <= equal_313_s12_q;
      select_319_s13_q <= select_319_s12_q;
      and_328_s13_q <= and_328_s12_q;
      equal_334_s13_q <= equal_334_s12_q;
      whole_s13_q <= whole_s12_q;
      column_s13_q <= column_s12_q;
      and_352_s13_q <= and_352_s12_q;
      and_354_s13_q <= and_354_s12_q;
      equal_357_s13_q <= equal_357_s12_q;
      equal_373_s13_q <= equal_373_s12_q;
      not_374_s13_q <= not_374_s12_q;
      equal_375_s13_q <= equal_375_s12_q;
      less_376_s13_q <= less_376_s12_q;
      not_377_s13_q <= not_377_s12_q;
      equal_408_s13_q <= equal_408_s12_q;
      drew_s13_q <= drew_s12_q;
      left_rdata_s13_q <= left_rdata_s12_q;
      x_s13_2_q <= x_s12_2_q;
      not_519_s13_q <= not_519_s12_q;
      select_521_s13_q <= select_521_s12_q;
      best_left_rdata_s13_q <= best_left_rdata_q;
      equal_524_s13_q <= equal_524_s12_q;
      column_4_s13_q <= column_4;
      equal_591_s13_q <= equal_591_s12_q;
      column_7_s13_q <= column_7;
      column_10_s13_q <= column_10;
      column_13_s13_q <= column_13;
      column_16_s13_q <= column_16;
      equal_828_s13_q <= equal_828_s12_q;
      and_886_s13_q <= and_886_s12_q;
      equal_892_s13_q <= equal_892_s12_q;
      equal_915_s13_q <= equal_915_s12_q;
      equal_918_s13_q <= equal_918_s12_q;
      and_929_s13_q <= and_929_s12_q;
      and_960_s13_q <= and_960_s12_q;
      and_1060_s13_q <= and_1060_s12_q;
      equal_1200_s13_q <= equal_1200_s12_q;
      equal_1252_s13_q <= equal_1252_s12_q;
      not_1298_s13_q <= not_1298_s12_q;
      and_1386_s13_q <= and_1386_s12_q;
      less_1480_s13_q <= less_1480_s12_q;
      less_1483_s13_q <= less_1483_s12_q;
      select_1490_s13_q <= select_1490;
      less_1756_s13_q <= less_1756_s12_q;
      equal_1921_s13_q <= equal_1921_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_590;
  assign difference_590 = {2'h0, column_4_s13_q} - (age_s13_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] difference_644;
  assign difference_644 = {2'h0, column_7_s13_q} - (age_s13_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] difference_699;
  assign difference_699 = {2'h0, column_10_s13_q} - (age_s13_q[1] ? sums_3_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1352;
  assign select_1352 = equal_373_s13_q ? {2'h0, column_7_s13_q} : sums_1_columns_values_0_q;
  logic [7:0] select_1353;
  assign select_1353 = equal_373_s13_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1354;
  assign select_1354 = equal_373_s13_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1355;
  assign select_1355 = equal_373_s13_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1356;
  assign select_1356 = equal_373_s13_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1357;
  assign select_1357 = equal_373_s13_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1358;
  assign select_1358 = equal_373_s13_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1360;
  assign select_1360 = equal_373_s13_q ? {2'h0, column_4_s13_q} : sums_2_columns_values_0_q;
  logic [7:0] select_1361;
  assign select_1361 = equal_373_s13_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1362;
  assign select_1362 = equal_373_s13_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1363;
  assign select_1363 = equal_373_s13_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1364;
  assign select_1364 = equal_373_s13_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1365;
  assign select_1365 = equal_373_s13_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1366;
  assign select_1366 = equal_373_s13_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1368;
  assign select_1368 = equal_373_s13_q ? {2'h0, column_10_s13_q} : sums_3_columns_values_0_q;
  logic [7:0] select_1369;
  assign select_1369 = equal_373_s13_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1370;
  assign select_1370 = equal_373_s13_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1371;
  assign select_1371 = equal_373_s13_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1372;
  assign select_1372 = equal_373_s13_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1373;
  assign select_1373 = equal_373_s13_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1374;
  assign select_1374 = equal_373_s13_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  // hls/stages/registration.hpp:153
  logic [9:0] select_1491;
  assign select_1491 = best_left_rdata_s13_q[12] ? select_1490_s13_q[9:0] : 10'h0;
  logic [8:0] difference_1493;
  assign difference_1493 = select_1491[9:1] - (best_left_rdata_s13_q[13] ? select_1490_s13_q[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1496;
  assign sum_1496 = (best_left_rdata_s13_q[8] ? select_1490_s13_q[13:1] : 13'h0) + (best_left_rdata_s13_q[9] ? select_1490_s13_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1497;
  assign select_1497 = best_left_rdata_s13_q[10] ? select_1490_s13_q[11:0] : 12'h0;
  logic [10:0] sum_1499;
  assign sum_1499 = select_1497[11:1] + (best_left_rdata_s13_q[11] ? select_1490_s13_q[10:0] : 11'h0);

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
    if (s13_en) begin
      sums_1_columns_values_0_q <= select_1352;
      sums_1_columns_values_1_q <= select_1353;
      sums_1_columns_values_2_q <= select_1354;
      sums_1_columns_values_3_q <= select_1355;
      sums_1_columns_values_4_q <= select_1356;
      sums_1_columns_values_5_q <= select_1357;
      sums_1_columns_values_6_q <= select_1358;
      sums_2_columns_values_0_q <= select_1360;
      sums_2_columns_values_1_q <= select_1361;
      sums_2_columns_values_2_q <= select_1362;
      sums_2_columns_values_3_q <= select_1363;
      sums_2_columns_values_4_q <= select_1364;
      sums_2_columns_values_5_q <= select_1365;
      sums_2_columns_values_6_q <= select_1366;
      sums_3_columns_values_0_q <= select_1368;
      sums_3_columns_values_1_q <= select_1369;
      sums_3_columns_values_2_q <= select_1370;
      sums_3_columns_values_3_q <= select_1371;
      sums_3_columns_values_4_q <= select_1372;
      sums_3_columns_values_5_q <= select_1373;
      sums_3_columns_values_6_q <= select_1374;
    end
  end

  logic [7:0] pixel_0_s14_q;
  logic [7:0] pixel_1_s14_q;
  logic saturated_s14_q;
  logic mask_s14_q;
  logic marks_first_s14_q;
  logic marks_last_s14_q;
  logic sample_pair_whole_s14_q;
  logic [5:0] run_shift_s14_q;
  logic [7:0] x_s14_q;
  logic [1:0] age_s14_q;
  logic lower_half_s14_q;
  logic [11:0] registration_slope_s14_q;
  logic equal_313_s14_q;
  logic [8:0] select_319_s14_q;
  logic and_328_s14_q;
  logic equal_334_s14_q;
  logic whole_s14_q;
  logic [6:0] column_s14_q;
  logic and_352_s14_q;
  logic and_354_s14_q;
  logic equal_357_s14_q;
  logic equal_373_s14_q;
  logic not_374_s14_q;
  logic equal_375_s14_q;
  logic less_376_s14_q;
  logic not_377_s14_q;
  logic equal_408_s14_q;
  logic drew_s14_q;
  logic left_rdata_s14_q;
  logic [6:0] x_s14_2_q;
  logic not_519_s14_q;
  logic select_521_s14_q;
  logic [21:0] best_left_rdata_s14_q;
  logic equal_524_s14_q;
  logic [7:0] difference_590_s14_q;
  logic equal_591_s14_q;
  logic [7:0] difference_644_s14_q;
  logic [7:0] difference_699_s14_q;
  logic [5:0] column_13_s14_q;
  logic [5:0] column_16_s14_q;
  logic equal_828_s14_q;
  logic and_886_s14_q;
  logic equal_892_s14_q;
  logic equal_915_s14_q;
  logic equal_918_s14_q;
  logic and_929_s14_q;
  logic and_960_s14_q;
  logic and_1060_s14_q;
  logic equal_1200_s14_q;
  logic equal_1252_s14_q;
  logic not_1298_s14_q;
  logic and_1386_s14_q;
  logic less_1480_s14_q;
  logic less_1483_s14_q;
  logic select_1491_s14_q;
  logic [8:0] difference_1493_s14_q;
  logic [11:0] sum_1496_s14_q;
  logic select_1497_s14_q;
  logic [10:0] sum_1499_s14_q;
  logic less_1756_s14_q;
  logic equal_1921_s14_q;
  always_ff @(posedge clk_i) begin
    if (s13_en) begin
      pixel_0_s14_q <= pixel_0_s13_q;
      pixel_1_s14_q <= pixel_1_s13_q;
      saturated_s14_q <= saturated_s13_q;
      mask_s14_q <= mask_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      sample_pair_whole_s14_q <= sample_pair_whole_s13_q;
      run_shift_s14_q <= run_shift_s13_q;
      x_s14_q <= x_s13_q;
      age_s14_q <= age_s13_q;
      lower_half_s14_q <= lower_half_s13_q;
      registration_slope_s14_q <= registration_slope_s13_q;
      equal_313_s14_q <= equal_313_s13_q;
      select_319_s14_q <= select_319_s13_q;
      and_328_s14_q <= and_328_s13_q;
      equal_334_s14_q <= equal_334_s13_q;
      whole_s14_q <= whole_s13_q;
      column_s14_q <= column_s13_q;
      and_352_s14_q <= and_352_s13_q;
      and_354_s14_q <= and_354_s13_q;
      equal_357_s14_q <= equal_357_s13_q;
      equal_373_s14_q <= equal_373_s13_q;
      not_374_s14_q <= not_374_s13_q;
      equal_375_s14_q <= equal_375_s13_q;
      less_376_s14_q <= less_376_s13_q;
      not_377_s14_q <= not_377_s13_q;
      equal_408_s14_q <= equal_408_s13_q;
      drew_s14_q <= drew_s13_q;
      left_rdata_s14_q <= left_rdata_s13_q;
      x_s14_2_q <= x_s13_2_q;
      not_519_s14_q <= not_519_s13_q;
      select_521_s14_q <= select_521_s13_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      equal_524_s14_q <= equal_524_s13_q;
      difference_590_s14_q <= difference_590;
      equal_591_s14_q <= equal_591_s13_q;
      difference_644_s14_q <= difference_644;
      difference_699_s14_q <= difference_699;
      column_13_s14_q <= column_13_s13_q;
      column_16_s14_q <= column_16_s13_q;
      equal_828_s14_q <= equal_828_s13_q;
      and_886_s14_q <= and_886_s13_q;
      equal_892_s14_q <= equal_892_s13_q;
      equal_915_s14_q <= equal_915_s13_q;
      equal_918_s14_q <= equal_918_s13_q;
      and_929_s14_q <= and_929_s13_q;
      and_960_s14_q <= and_960_s13_q;
      and_1060_s14_q <= and_1060_s13_q;
      equal_1200_s14_q <= equal_1200_s13_q;
      equal_1252_s14_q <= equal_1252_s13_q;
      not_1298_s14_q <= not_1298_s13_q;
      and_1386_s14_q <= and_1386_s13_q;
      less_1480_s14_q <= less_1480_s13_q;
      less_1483_s14_q <= less_1483_s13_q;
      select_1491_s14_q <= select_1491[0];
      difference_1493_s14_q <= difference_1493;
      sum_1496_s14_q <= sum_1496[12:1];
      select_1497_s14_q <= select_1497[0];
      sum_1499_s14_q <= sum_1499;
      less_1756_s14_q <= less_1756_s13_q;
      equal_1921_s14_q <= equal_1921_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:425
  logic [7:0] sum_593;
  assign sum_593 = difference_590_s14_q + (equal_591_s14_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  logic [7:0] sum_646;
  assign sum_646 = difference_644_s14_q + (equal_591_s14_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  logic [7:0] sum_701;
  assign sum_701 = difference_699_s14_q + (equal_591_s14_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  logic [7:0] difference_756;
  assign difference_756 = {2'h0, column_13_s14_q} - (age_s14_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] difference_816;
  assign difference_816 = {2'h0, column_16_s14_q} - (age_s14_q[1] ? sums_4_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1344;
  assign select_1344 = equal_373_s14_q ? {2'h0, column_13_s14_q} : sums_0_columns_values_0_q;
  logic [7:0] select_1345;
  assign select_1345 = equal_373_s14_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1346;
  assign select_1346 = equal_373_s14_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1347;
  assign select_1347 = equal_373_s14_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1348;
  assign select_1348 = equal_373_s14_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1349;
  assign select_1349 = equal_373_s14_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1350;
  assign select_1350 = equal_373_s14_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1376;
  assign select_1376 = equal_373_s14_q ? {2'h0, column_16_s14_q} : sums_4_columns_values_0_q;
  logic [7:0] select_1377;
  assign select_1377 = equal_373_s14_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1378;
  assign select_1378 = equal_373_s14_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1379;
  assign select_1379 = equal_373_s14_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1380;
  assign select_1380 = equal_373_s14_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1381;
  assign select_1381 = equal_373_s14_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1382;
  assign select_1382 = equal_373_s14_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1500;
  assign sum_1500 = sum_1496_s14_q + {sum_1499_s14_q, select_1497_s14_q};
  logic [9:0] sum_1501;
  assign sum_1501 = {difference_1493_s14_q, select_1491_s14_q} + sum_1500[11:2];

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
    if (s14_en) begin
      sums_0_columns_values_0_q <= select_1344;
      sums_0_columns_values_1_q <= select_1345;
      sums_0_columns_values_2_q <= select_1346;
      sums_0_columns_values_3_q <= select_1347;
      sums_0_columns_values_4_q <= select_1348;
      sums_0_columns_values_5_q <= select_1349;
      sums_0_columns_values_6_q <= select_1350;
      sums_1_sum_sums_values_0_q <= equal_373_s14_q ? sum_646 : sums_1_sum_sums_values_0_q;
      sums_2_sum_sums_values_0_q <= equal_373_s14_q ? sum_593 : sums_2_sum_sums_values_0_q;
      sums_3_sum_sums_values_0_q <= equal_373_s14_q ? sum_701 : sums_3_sum_sums_values_0_q;
      sums_4_columns_values_0_q <= select_1376;
      sums_4_columns_values_1_q <= select_1377;
      sums_4_columns_values_2_q <= select_1378;
      sums_4_columns_values_3_q <= select_1379;
      sums_4_columns_values_4_q <= select_1380;
      sums_4_columns_values_5_q <= select_1381;
      sums_4_columns_values_6_q <= select_1382;
    end
  end

  logic [7:0] pixel_0_s15_q;
  logic [7:0] pixel_1_s15_q;
  logic saturated_s15_q;
  logic mask_s15_q;
  logic marks_first_s15_q;
  logic marks_last_s15_q;
  logic sample_pair_whole_s15_q;
  logic [5:0] run_shift_s15_q;
  logic [7:0] x_s15_q;
  logic age_s15_q;
  logic lower_half_s15_q;
  logic [11:0] registration_slope_s15_q;
  logic equal_313_s15_q;
  logic [8:0] select_319_s15_q;
  logic and_328_s15_q;
  logic equal_334_s15_q;
  logic whole_s15_q;
  logic [6:0] column_s15_q;
  logic and_352_s15_q;
  logic and_354_s15_q;
  logic equal_357_s15_q;
  logic equal_373_s15_q;
  logic not_374_s15_q;
  logic equal_375_s15_q;
  logic less_376_s15_q;
  logic not_377_s15_q;
  logic equal_408_s15_q;
  logic drew_s15_q;
  logic left_rdata_s15_q;
  logic [6:0] x_s15_2_q;
  logic not_519_s15_q;
  logic select_521_s15_q;
  logic [21:0] best_left_rdata_s15_q;
  logic equal_524_s15_q;
  logic equal_591_s15_q;
  logic [7:0] sum_593_s15_q;
  logic [7:0] sum_646_s15_q;
  logic less_647_s15_q;
  logic [7:0] sum_701_s15_q;
  logic [7:0] difference_756_s15_q;
  logic [7:0] difference_816_s15_q;
  logic equal_828_s15_q;
  logic and_886_s15_q;
  logic equal_892_s15_q;
  logic equal_915_s15_q;
  logic equal_918_s15_q;
  logic and_929_s15_q;
  logic and_960_s15_q;
  logic and_1060_s15_q;
  logic equal_1200_s15_q;
  logic equal_1252_s15_q;
  logic not_1298_s15_q;
  logic and_1386_s15_q;
  logic less_1480_s15_q;
  logic less_1483_s15_q;
  logic [7:0] sum_1501_s15_q;
  logic less_1756_s15_q;
  logic equal_1921_s15_q;
  always_ff @(posedge clk_i) begin
    if (s14_en) begin
      pixel_0_s15_q <= pixel_0_s14_q;
      pixel_1_s15_q <= pixel_1_s14_q;
      saturated_s15_q <= saturated_s14_q;
      mask_s15_q <= mask_s14_q;
      marks_first_s15_q <= marks_first_s14_q;
      marks_last_s15_q <= marks_last_s14_q;
      sample_pair_whole_s15_q <= sample_pair_whole_s14_q;
      run_shift_s15_q <= run_shift_s14_q;
      x_s15_q <= x_s14_q;
      age_s15_q <= age_s14_q[0];
      lower_half_s15_q <= lower_half_s14_q;
      registration_slope_s15_q <= registration_slope_s14_q;
      equal_313_s15_q <= equal_313_s14_q;
      select_319_s15_q <= select_319_s14_q;
      and_328_s15_q <= and_328_s14_q;
      equal_334_s15_q <= equal_334_s14_q;
      whole_s15_q <= whole_s14_q;
      column_s15_q <= column_s14_q;
      and_352_s15_q <= and_352_s14_q;
      and_354_s15_q <= and_354_s14_q;
      equal_357_s15_q <= equal_357_s14_q;
      equal_373_s15_q <= equal_373_s14_q;
      not_374_s15_q <= not_374_s14_q;
      equal_375_s15_q <= equal_375_s14_q;
      less_376_s15_q <= less_376_s14_q;
      not_377_s15_q <= not_377_s14_q;
      equal_408_s15_q <= equal_408_s14_q;
      drew_s15_q <= drew_s14_q;
      left_rdata_s15_q <= left_rdata_s14_q;
      x_s15_2_q <= x_s14_2_q;
      not_519_s15_q <= not_519_s14_q;
      select_521_s15_q <= select_521_s14_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      equal_524_s15_q <= equal_524_s14_q;
      equal_591_s15_q <= equal_591_s14_q;
      sum_593_s15_q <= sum_593;
      sum_646_s15_q <= sum_646;
      less_647_s15_q <= sum_593 < sum_646;
      sum_701_s15_q <= sum_701;
      difference_756_s15_q <= difference_756;
      difference_816_s15_q <= difference_816;
      equal_828_s15_q <= equal_828_s14_q;
      and_886_s15_q <= and_886_s14_q;
      equal_892_s15_q <= equal_892_s14_q;
      equal_915_s15_q <= equal_915_s14_q;
      equal_918_s15_q <= equal_918_s14_q;
      and_929_s15_q <= and_929_s14_q;
      and_960_s15_q <= and_960_s14_q;
      and_1060_s15_q <= and_1060_s14_q;
      equal_1200_s15_q <= equal_1200_s14_q;
      equal_1252_s15_q <= equal_1252_s14_q;
      not_1298_s15_q <= not_1298_s14_q;
      and_1386_s15_q <= and_1386_s14_q;
      less_1480_s15_q <= less_1480_s14_q;
      less_1483_s15_q <= less_1483_s14_q;
      sum_1501_s15_q <= sum_1501[9:2];
      less_1756_s15_q <= less_1756_s14_q;
      equal_1921_s15_q <= equal_1921_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_4_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:438
  logic not_703;
  assign not_703 = ~less_647_s15_q;
  logic [1:0] best;
  assign best = ((less_647_s15_q ? sum_646_s15_q : sum_593_s15_q) < sum_701_s15_q) ? 2'h3 : {not_703, less_647_s15_q};
  // hls/stages/agreement.hpp:425
  logic [7:0] sum_758;
  assign sum_758 = difference_756_s15_q + (equal_591_s15_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  logic [7:0] sum_818;
  assign sum_818 = difference_816_s15_q + (equal_591_s15_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:450
  logic [6:0] partner;
  assign partner = {run_shift_s15_q[5], run_shift_s15_q} + x_s15_2_q;
  // hls/stages/agreement.hpp:528
  logic [6:0] sum_888;
  assign sum_888 = x_s15_q[6:0] + {best_left_rdata_s15_q[13], best_left_rdata_s15_q[13:8]};
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1502;
  assign sum_1502 = {registration_slope_s15_q[11], registration_slope_s15_q} + {{5{sum_1501_s15_q[7]}}, sum_1501_s15_q};

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_4_sum_sums_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s15_en) begin
      sums_0_sum_sums_values_0_q <= equal_373_s15_q ? sum_758 : sums_0_sum_sums_values_0_q;
      sums_4_sum_sums_values_0_q <= equal_373_s15_q ? sum_818 : sums_4_sum_sums_values_0_q;
    end
  end

  logic [7:0] pixel_0_s16_q;
  logic [7:0] pixel_1_s16_q;
  logic saturated_s16_q;
  logic mask_s16_q;
  logic marks_first_s16_q;
  logic marks_last_s16_q;
  logic sample_pair_whole_s16_q;
  logic [5:0] run_shift_s16_q;
  logic [7:0] x_s16_q;
  logic age_s16_q;
  logic lower_half_s16_q;
  logic equal_313_s16_q;
  logic [8:0] select_319_s16_q;
  logic and_328_s16_q;
  logic equal_334_s16_q;
  logic whole_s16_q;
  logic [6:0] column_s16_q;
  logic and_352_s16_q;
  logic and_354_s16_q;
  logic equal_357_s16_q;
  logic equal_373_s16_q;
  logic not_374_s16_q;
  logic equal_375_s16_q;
  logic less_376_s16_q;
  logic not_377_s16_q;
  logic equal_408_s16_q;
  logic drew_s16_q;
  logic left_rdata_s16_q;
  logic [6:0] x_s16_2_q;
  logic not_519_s16_q;
  logic select_521_s16_q;
  logic [21:0] best_left_rdata_s16_q;
  logic equal_524_s16_q;
  logic [7:0] sum_593_s16_q;
  logic [7:0] sum_646_s16_q;
  logic [7:0] sum_701_s16_q;
  logic [1:0] best_s16_q;
  logic [7:0] select_705_s16_q;
  logic [7:0] sum_758_s16_q;
  logic [7:0] select_759_s16_q;
  logic [7:0] sum_818_s16_q;
  logic equal_828_s16_q;
  logic and_886_s16_q;
  logic [6:0] partner_s16_q;
  logic [6:0] select_889_s16_q;
  logic equal_892_s16_q;
  logic equal_915_s16_q;
  logic equal_918_s16_q;
  logic and_929_s16_q;
  logic and_960_s16_q;
  logic and_1060_s16_q;
  logic equal_1200_s16_q;
  logic equal_1252_s16_q;
  logic not_1298_s16_q;
  logic and_1386_s16_q;
  logic less_1480_s16_q;
  logic less_1483_s16_q;
  logic [7:0] sum_1502_s16_q;
  logic less_1503_s16_q;
  logic less_1504_s16_q;
  logic less_1756_s16_q;
  logic equal_1921_s16_q;
  always_ff @(posedge clk_i) begin
    if (s15_en) begin
      pixel_0_s16_q <= pixel_0_s15_q;
      pixel_1_s16_q <= pixel_1_s15_q;
      saturated_s16_q <= saturated_s15_q;
      mask_s16_q <= mask_s15_q;
      marks_first_s16_q <= marks_first_s15_q;
      marks_last_s16_q <= marks_last_s15_q;
      sample_pair_whole_s16_q <= sample_pair_whole_s15_q;
      run_shift_s16_q <= run_shift_s15_q;
      x_s16_q <= x_s15_q;
      age_s16_q <= age_s15_q;
      lower_half_s16_q <= lower_half_s15_q;
      equal_313_s16_q <= equal_313_s15_q;
      select_319_s16_q <= select_319_s15_q;
      and_328_s16_q <= and_328_s15_q;
      equal_334_s16_q <= equal_334_s15_q;
      whole_s16_q <= whole_s15_q;
      column_s16_q <= column_s15_q;
      and_352_s16_q <= and_352_s15_q;
      and_354_s16_q <= and_354_s15_q;
      equal_357_s16_q <= equal_357_s15_q;
      equal_373_s16_q <= equal_373_s15_q;
      not_374_s16_q <= not_374_s15_q;
      equal_375_s16_q <= equal_375_s15_q;
      less_376_s16_q <= less_376_s15_q;
      not_377_s16_q <= not_377_s15_q;
      equal_408_s16_q <= equal_408_s15_q;
      drew_s16_q <= drew_s15_q;
      left_rdata_s16_q <= left_rdata_s15_q;
      x_s16_2_q <= x_s15_2_q;
      not_519_s16_q <= not_519_s15_q;
      select_521_s16_q <= select_521_s15_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      equal_524_s16_q <= equal_524_s15_q;
      sum_593_s16_q <= sum_593_s15_q;
      sum_646_s16_q <= sum_646_s15_q;
      sum_701_s16_q <= sum_701_s15_q;
      best_s16_q <= best;
      select_705_s16_q <= best[0] ? sum_701_s15_q : sum_593_s15_q;
      sum_758_s16_q <= sum_758;
      select_759_s16_q <= best[0] ? sum_646_s15_q : sum_758;
      sum_818_s16_q <= sum_818;
      equal_828_s16_q <= equal_828_s15_q;
      and_886_s16_q <= and_886_s15_q;
      partner_s16_q <= partner;
      select_889_s16_q <= equal_373_s15_q ? partner : sum_888;
      equal_892_s16_q <= equal_892_s15_q;
      equal_915_s16_q <= equal_915_s15_q;
      equal_918_s16_q <= equal_918_s15_q;
      and_929_s16_q <= and_929_s15_q;
      and_960_s16_q <= and_960_s15_q;
      and_1060_s16_q <= and_1060_s15_q;
      equal_1200_s16_q <= equal_1200_s15_q;
      equal_1252_s16_q <= equal_1252_s15_q;
      not_1298_s16_q <= not_1298_s15_q;
      and_1386_s16_q <= and_1386_s15_q;
      less_1480_s16_q <= less_1480_s15_q;
      less_1483_s16_q <= less_1483_s15_q;
      sum_1502_s16_q <= sum_1502[7:0];
      less_1503_s16_q <= $signed(6'h0) < $signed(sum_1502[12:7]);
      less_1504_s16_q <= $signed(sum_1502[12:7]) < $signed(6'h3f);
      less_1756_s16_q <= less_1756_s15_q;
      equal_1921_s16_q <= equal_1921_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:438
  logic less_761;
  assign less_761 = (best_s16_q[1] ? select_705_s16_q : select_759_s16_q) < sum_758_s16_q;
  logic [1:0] best_2;
  assign best_2 = less_761 ? 2'h0 : best_s16_q;
  // hls/stages/registration.hpp:151
  logic [7:0] slope;
  assign slope = less_1503_s16_q ? 8'h7f : (less_1504_s16_q ? 8'h80 : sum_1502_s16_q);
  logic [6:0] select_1507;
  assign select_1507 = best_left_rdata_s16_q[8] ? slope[7:1] : 7'h0;
  logic [7:0] select_1508;
  assign select_1508 = best_left_rdata_s16_q[9] ? slope : 8'h0;
  logic [8:0] sum_1509;
  assign sum_1509 = {{2{select_1507[6]}}, select_1507} + {select_1508[7], select_1508};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1510;
  assign select_1510 = best_left_rdata_s16_q[10] ? slope : 8'h0;
  logic [7:0] select_1511;
  assign select_1511 = best_left_rdata_s16_q[11] ? slope : 8'h0;
  logic [8:0] sum_1512;
  assign sum_1512 = {{2{select_1510[7]}}, select_1510[7:1]} + {select_1511[7], select_1511};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1514;
  assign select_1514 = best_left_rdata_s16_q[12] ? slope : 8'h0;
  logic [7:0] select_1515;
  assign select_1515 = best_left_rdata_s16_q[13] ? slope : 8'h0;
  logic [8:0] difference_1516;
  assign difference_1516 = {{2{select_1514[7]}}, select_1514[7:1]} - {select_1515[7], select_1515};

  // Memory best_right, 120 x 15, DISTANCE 32, hls/stages/agreement.hpp:806; read in stage 16, written in stage 20: 16 < 20 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 15'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = select_889_s16_q;
  logic best_right_re;
  assign best_right_re = s16_en & select_521_s16_q;
  logic [14:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  logic [7:0] pixel_0_s17_q;
  logic [7:0] pixel_1_s17_q;
  logic saturated_s17_q;
  logic mask_s17_q;
  logic marks_first_s17_q;
  logic marks_last_s17_q;
  logic sample_pair_whole_s17_q;
  logic [5:0] run_shift_s17_q;
  logic [7:0] x_s17_q;
  logic age_s17_q;
  logic lower_half_s17_q;
  logic equal_313_s17_q;
  logic [8:0] select_319_s17_q;
  logic and_328_s17_q;
  logic equal_334_s17_q;
  logic whole_s17_q;
  logic [6:0] column_s17_q;
  logic and_352_s17_q;
  logic and_354_s17_q;
  logic equal_357_s17_q;
  logic equal_373_s17_q;
  logic not_374_s17_q;
  logic equal_375_s17_q;
  logic less_376_s17_q;
  logic not_377_s17_q;
  logic equal_408_s17_q;
  logic drew_s17_q;
  logic left_rdata_s17_q;
  logic [6:0] x_s17_2_q;
  logic not_519_s17_q;
  logic [21:0] best_left_rdata_s17_q;
  logic equal_524_s17_q;
  logic [7:0] sum_593_s17_q;
  logic [7:0] sum_646_s17_q;
  logic [7:0] sum_701_s17_q;
  logic [7:0] sum_758_s17_q;
  logic [1:0] best_2_s17_q;
  logic [7:0] select_763_s17_q;
  logic [7:0] select_764_s17_q;
  logic [7:0] sum_818_s17_q;
  logic equal_828_s17_q;
  logic and_886_s17_q;
  logic [6:0] partner_s17_q;
  logic equal_892_s17_q;
  logic equal_915_s17_q;
  logic equal_918_s17_q;
  logic and_929_s17_q;
  logic and_960_s17_q;
  logic and_1060_s17_q;
  logic equal_1200_s17_q;
  logic equal_1252_s17_q;
  logic not_1298_s17_q;
  logic and_1386_s17_q;
  logic less_1480_s17_q;
  logic less_1483_s17_q;
  logic [7:0] sum_1509_s17_q;
  logic select_1510_s17_q;
  logic [8:0] sum_1512_s17_q;
  logic select_1514_s17_q;
  logic [8:0] difference_1516_s17_q;
  logic less_1756_s17_q;
  logic equal_1921_s17_q;
  always_ff @(posedge clk_i) begin
    if (s16_en) begin
      pixel_0_s17_q <= pixel_0_s16_q;
      pixel_1_s17_q <= pixel_1_s16_q;
      saturated_s17_q <= saturated_s16_q;
      mask_s17_q <= mask_s16_q;
      marks_first_s17_q <= marks_first_s16_q;
      marks_last_s17_q <= marks_last_s16_q;
      sample_pair_whole_s17_q <= sample_pair_whole_s16_q;
      run_shift_s17_q <= run_shift_s16_q;
      x_s17_q <= x_s16_q;
      age_s17_q <= age_s16_q;
      lower_half_s17_q <= lower_half_s16_q;
      equal_313_s17_q <= equal_313_s16_q;
      select_319_s17_q <= select_319_s16_q;
      and_328_s17_q <= and_328_s16_q;
      equal_334_s17_q <= equal_334_s16_q;
      whole_s17_q <= whole_s16_q;
      column_s17_q <= column_s16_q;
      and_352_s17_q <= and_352_s16_q;
      and_354_s17_q <= and_354_s16_q;
      equal_357_s17_q <= equal_357_s16_q;
      equal_373_s17_q <= equal_373_s16_q;
      not_374_s17_q <= not_374_s16_q;
      equal_375_s17_q <= equal_375_s16_q;
      less_376_s17_q <= less_376_s16_q;
      not_377_s17_q <= not_377_s16_q;
      equal_408_s17_q <= equal_408_s16_q;
      drew_s17_q <= drew_s16_q;
      left_rdata_s17_q <= left_rdata_s16_q;
      x_s17_2_q <= x_s16_2_q;
      not_519_s17_q <= not_519_s16_q;
      best_left_rdata_s17_q <= best_left_rdata_s16_q;
      equal_524_s17_q <= equal_524_s16_q;
      sum_593_s17_q <= sum_593_s16_q;
      sum_646_s17_q <= sum_646_s16_q;
      sum_701_s17_q <= sum_701_s16_q;
      sum_758_s17_q <= sum_758_s16_q;
      best_2_s17_q <= best_2;
      select_763_s17_q <= best_2[0] ? sum_701_s16_q : sum_593_s16_q;
      select_764_s17_q <= best_2[0] ? sum_646_s16_q : sum_758_s16_q;
      sum_818_s17_q <= sum_818_s16_q;
      equal_828_s17_q <= equal_828_s16_q;
      and_886_s17_q <= and_886_s16_q;
      partner_s17_q <= partner_s16_q;
      equal_892_s17_q <= equal_892_s16_q;
      equal_915_s17_q <= equal_915_s16_q;
      equal_918_s17_q <= equal_918_s16_q;
      and_929_s17_q <= and_929_s16_q;
      and_960_s17_q <= and_960_s16_q;
      and_1060_s17_q <= and_1060_s16_q;
      equal_1200_s17_q <= equal_1200_s16_q;
      equal_1252_s17_q <= equal_1252_s16_q;
      not_1298_s17_q <= not_1298_s16_q;
      and_1386_s17_q <= and_1386_s16_q;
      less_1480_s17_q <= less_1480_s16_q;
      less_1483_s17_q <= less_1483_s16_q;
      sum_1509_s17_q <= sum_1509[8:1];
      select_1510_s17_q <= select_1510[0];
      sum_1512_s17_q <= sum_1512;
      select_1514_s17_q <= select_1514[0];
      difference_1516_s17_q <= difference_1516;
      less_1756_s17_q <= less_1756_s16_q;
      equal_1921_s17_q <= equal_1921_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:98
  logic and_329;
  assign and_329 = sample_pair_whole_s17_q & and_328_s17_q;
  // hls/stages/agreement.hpp:430
  logic less_525;
  assign less_525 = $signed(run_shift_s17_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_527;
  assign less_527 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s17_q);
  // hls/stages/agreement.hpp:438
  logic less_819;
  assign less_819 = (best_2_s17_q[1] ? select_763_s17_q : select_764_s17_q) < sum_818_s17_q;
  logic [1:0] select_820;
  assign select_820 = less_819 ? 2'h0 : best_2_s17_q;
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1513;
  assign sum_1513 = {{3{sum_1509_s17_q[7]}}, sum_1509_s17_q} + {sum_1512_s17_q[8], sum_1512_s17_q, select_1510_s17_q};
  logic [9:0] sum_1517;
  assign sum_1517 = {difference_1516_s17_q, select_1514_s17_q} + {sum_1513[10], sum_1513[10:2]};

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:146; read in stage 17, written in stage 20: 17 < 20 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_319_s17_q;
  logic averager_memory_re;
  assign averager_memory_re = s17_en & and_329;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  logic [7:0] pixel_0_s18_q;
  logic [7:0] pixel_1_s18_q;
  logic saturated_s18_q;
  logic mask_s18_q;
  logic marks_first_s18_q;
  logic marks_last_s18_q;
  logic sample_pair_whole_s18_q;
  logic [5:0] run_shift_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic lower_half_s18_q;
  logic equal_313_s18_q;
  logic [8:0] select_319_s18_q;
  logic and_328_s18_q;
  logic and_329_s18_q;
  logic equal_334_s18_q;
  logic whole_s18_q;
  logic [6:0] column_s18_q;
  logic and_352_s18_q;
  logic and_354_s18_q;
  logic equal_357_s18_q;
  logic equal_373_s18_q;
  logic not_374_s18_q;
  logic equal_375_s18_q;
  logic less_376_s18_q;
  logic not_377_s18_q;
  logic equal_408_s18_q;
  logic drew_s18_q;
  logic left_rdata_s18_q;
  logic [6:0] x_s18_2_q;
  logic not_519_s18_q;
  logic [21:0] best_left_rdata_s18_q;
  logic equal_524_s18_q;
  logic and_529_s18_q;
  logic [7:0] sum_593_s18_q;
  logic [7:0] sum_646_s18_q;
  logic [7:0] sum_701_s18_q;
  logic [7:0] sum_758_s18_q;
  logic [7:0] sum_818_s18_q;
  logic less_819_s18_q;
  logic [1:0] select_820_s18_q;
  logic [7:0] select_821_s18_q;
  logic [7:0] select_822_s18_q;
  logic equal_828_s18_q;
  logic equal_839_s18_q;
  logic and_886_s18_q;
  logic [6:0] partner_s18_q;
  logic [14:0] best_right_rdata_s18_q;
  logic equal_892_s18_q;
  logic equal_915_s18_q;
  logic equal_918_s18_q;
  logic and_929_s18_q;
  logic and_960_s18_q;
  logic and_1060_s18_q;
  logic equal_1200_s18_q;
  logic equal_1252_s18_q;
  logic not_1298_s18_q;
  logic and_1386_s18_q;
  logic less_1480_s18_q;
  logic less_1483_s18_q;
  logic sum_1513_s18_q;
  logic [9:0] sum_1517_s18_q;
  logic less_1756_s18_q;
  logic equal_1921_s18_q;
  always_ff @(posedge clk_i) begin
    if (s17_en) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      run_shift_s18_q <= run_shift_s17_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      equal_313_s18_q <= equal_313_s17_q;
      select_319_s18_q <= select_319_s17_q;
      and_328_s18_q <= and_328_s17_q;
      and_329_s18_q <= and_329;
      equal_334_s18_q <= equal_334_s17_q;
      whole_s18_q <= whole_s17_q;
      column_s18_q <= column_s17_q;
      and_352_s18_q <= and_352_s17_q;
      and_354_s18_q <= and_354_s17_q;
      equal_357_s18_q <= equal_357_s17_q;
      equal_373_s18_q <= equal_373_s17_q;
      not_374_s18_q <= not_374_s17_q;
      equal_375_s18_q <= equal_375_s17_q;
      less_376_s18_q <= less_376_s17_q;
      not_377_s18_q <= not_377_s17_q;
      equal_408_s18_q <= equal_408_s17_q;
      drew_s18_q <= drew_s17_q;
      left_rdata_s18_q <= left_rdata_s17_q;
      x_s18_2_q <= x_s17_2_q;
      not_519_s18_q <= not_519_s17_q;
      best_left_rdata_s18_q <= best_left_rdata_s17_q;
      equal_524_s18_q <= equal_524_s17_q;
      and_529_s18_q <= (~less_525) & (~less_527);
      sum_593_s18_q <= sum_593_s17_q;
      sum_646_s18_q <= sum_646_s17_q;
      sum_701_s18_q <= sum_701_s17_q;
      sum_758_s18_q <= sum_758_s17_q;
      sum_818_s18_q <= sum_818_s17_q;
      less_819_s18_q <= less_819;
      select_820_s18_q <= select_820;
      select_821_s18_q <= select_820[0] ? sum_701_s17_q : sum_593_s17_q;
      select_822_s18_q <= select_820[0] ? sum_646_s17_q : sum_758_s17_q;
      equal_828_s18_q <= equal_828_s17_q;
      equal_839_s18_q <= {less_819, select_820} == 3'h0;
      and_886_s18_q <= and_886_s17_q;
      partner_s18_q <= partner_s17_q;
      best_right_rdata_s18_q <= best_right_rdata_q;
      equal_892_s18_q <= equal_892_s17_q;
      equal_915_s18_q <= equal_915_s17_q;
      equal_918_s18_q <= equal_918_s17_q;
      and_929_s18_q <= and_929_s17_q;
      and_960_s18_q <= and_960_s17_q;
      and_1060_s18_q <= and_1060_s17_q;
      equal_1200_s18_q <= equal_1200_s17_q;
      equal_1252_s18_q <= equal_1252_s17_q;
      not_1298_s18_q <= not_1298_s17_q;
      and_1386_s18_q <= and_1386_s17_q;
      less_1480_s18_q <= less_1480_s17_q;
      less_1483_s18_q <= less_1483_s17_q;
      sum_1513_s18_q <= sum_1513[1];
      sum_1517_s18_q <= sum_1517;
      less_1756_s18_q <= less_1756_s17_q;
      equal_1921_s18_q <= equal_1921_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/census.hpp:91
  logic [13:0] select_332;
  assign select_332 = equal_313_s18_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_338;
  assign sum_338 = {6'h0, sample_pair_pixel_1_q} + (equal_313_s18_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:181
  logic all_of_skin;
  assign all_of_skin = equal_313_s18_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/agreement.hpp:440
  logic [7:0] of_best;
  assign of_best = less_819_s18_q ? sum_818_s18_q : (select_820_s18_q[1] ? select_821_s18_q : select_822_s18_q);
  logic [7:0] of_best_2;
  assign of_best_2 = and_529_s18_q ? of_best : 8'h0;
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_819_s18_q, select_820_s18_q} == 3'h4) ? 3'h3 : (equal_839_s18_q ? 3'h1 : {less_819_s18_q, select_820_s18_q});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_843;
  assign sum_843 = near_best + 3'h1;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_848;
  assign sum_848 = near_best + 3'h7;
  // hls/stages/registration.hpp:26
  logic [7:0] select_857;
  assign select_857 = near_best[1] ? (near_best[0] ? sum_701_s18_q : sum_593_s18_q) : (near_best[0] ? sum_646_s18_q : sum_758_s18_q);
  // hls/stages/division.hpp:18
  logic [5:0] sum_913;
  assign sum_913 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:530
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_s18_q[14:8]} - {1'b0, x_s18_q};
  // hls/stages/agreement.hpp:535
  logic and_948;
  assign and_948 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s18_q[13:8]));
  // hls/stages/agreement.hpp:183
  logic select_1113;
  assign select_1113 = sample_pair_whole_s18_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1518;
  assign difference_1518 = {{4{best_left_rdata_s18_q[21]}}, best_left_rdata_s18_q[21:14]} - {sum_1517_s18_q[9], sum_1517_s18_q, sum_1513_s18_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_1766;
  assign sum_1766 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1767;
  assign select_1767 = sum_913[5] ? {1'b1, sum_913[4:0], region_across_rest_q[2:0]} : sum_1766;
  // hls/stages/agreement.hpp:264
  logic [8:0] select_1771;
  assign select_1771 = equal_1252_s18_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_1774;
  assign select_1774 = equal_1252_s18_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      sample_of_skin_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s18_en) begin
      sample_pair_pixel_0_q <= pixel_0_s18_q;
      sample_pair_pixel_1_q <= pixel_1_s18_q;
      sample_of_skin_q <= mask_s18_q;
      averager_running_of_skin_q <= select_1113;
      region_across_rest_q <= drew_s18_q ? select_1767 : columns_begin_rest_q;
      region_across_back_q <= drew_s18_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_354_s18_q ? select_1771 : columns_begin_rest_q;
      columns_begin_back_q <= and_354_s18_q ? select_1774 : columns_begin_back_q;
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
    if (s18_en) begin
      averager_running_0_q <= sample_pair_whole_s18_q ? select_332 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s18_q ? sum_338 : averager_running_1_q;
    end
  end

  logic saturated_s19_q;
  logic marks_first_s19_q;
  logic marks_last_s19_q;
  logic sample_pair_whole_s19_q;
  logic [5:0] run_shift_s19_q;
  logic [7:0] x_s19_q;
  logic age_s19_q;
  logic lower_half_s19_q;
  logic [8:0] select_319_s19_q;
  logic and_328_s19_q;
  logic and_329_s19_q;
  logic [29:0] averager_memory_rdata_s19_q;
  logic [13:0] select_332_s19_q;
  logic equal_334_s19_q;
  logic [13:0] sum_338_s19_q;
  logic whole_s19_q;
  logic all_of_skin_s19_q;
  logic [6:0] column_s19_q;
  logic and_352_s19_q;
  logic and_354_s19_q;
  logic equal_357_s19_q;
  logic equal_373_s19_q;
  logic not_374_s19_q;
  logic equal_375_s19_q;
  logic less_376_s19_q;
  logic not_377_s19_q;
  logic equal_408_s19_q;
  logic drew_s19_q;
  logic left_rdata_s19_q;
  logic [6:0] x_s19_2_q;
  logic not_519_s19_q;
  logic [21:0] best_left_rdata_s19_q;
  logic equal_524_s19_q;
  logic [7:0] sum_818_s19_q;
  logic select_820_s19_q;
  logic [7:0] of_best_2_s19_q;
  logic less_827_s19_q;
  logic equal_828_s19_q;
  logic equal_842_s19_q;
  logic [1:0] sum_843_s19_q;
  logic [7:0] select_844_s19_q;
  logic [7:0] select_845_s19_q;
  logic [1:0] sum_848_s19_q;
  logic [7:0] select_849_s19_q;
  logic [7:0] select_850_s19_q;
  logic [1:0] sum_854_s19_q;
  logic [7:0] select_858_s19_q;
  logic and_886_s19_q;
  logic [6:0] partner_s19_q;
  logic [14:0] best_right_rdata_s19_q;
  logic less_891_s19_q;
  logic equal_892_s19_q;
  logic sum_913_s19_q;
  logic equal_915_s19_q;
  logic equal_918_s19_q;
  logic and_929_s19_q;
  logic [8:0] way_s19_q;
  logic and_948_s19_q;
  logic and_960_s19_q;
  logic and_1060_s19_q;
  logic equal_1200_s19_q;
  logic equal_1252_s19_q;
  logic not_1298_s19_q;
  logic and_1386_s19_q;
  logic less_1480_s19_q;
  logic less_1483_s19_q;
  logic [11:0] difference_1518_s19_q;
  logic less_1756_s19_q;
  logic equal_1921_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      saturated_s19_q <= saturated_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
      sample_pair_whole_s19_q <= sample_pair_whole_s18_q;
      run_shift_s19_q <= run_shift_s18_q;
      x_s19_q <= x_s18_q;
      age_s19_q <= age_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      select_319_s19_q <= select_319_s18_q;
      and_328_s19_q <= and_328_s18_q;
      and_329_s19_q <= and_329_s18_q;
      averager_memory_rdata_s19_q <= averager_memory_rdata_q;
      select_332_s19_q <= select_332;
      equal_334_s19_q <= equal_334_s18_q;
      sum_338_s19_q <= sum_338;
      whole_s19_q <= whole_s18_q;
      all_of_skin_s19_q <= all_of_skin;
      column_s19_q <= column_s18_q;
      and_352_s19_q <= and_352_s18_q;
      and_354_s19_q <= and_354_s18_q;
      equal_357_s19_q <= equal_357_s18_q;
      equal_373_s19_q <= equal_373_s18_q;
      not_374_s19_q <= not_374_s18_q;
      equal_375_s19_q <= equal_375_s18_q;
      less_376_s19_q <= less_376_s18_q;
      not_377_s19_q <= not_377_s18_q;
      equal_408_s19_q <= equal_408_s18_q;
      drew_s19_q <= drew_s18_q;
      left_rdata_s19_q <= left_rdata_s18_q;
      x_s19_2_q <= x_s18_2_q;
      not_519_s19_q <= not_519_s18_q;
      best_left_rdata_s19_q <= best_left_rdata_s18_q;
      equal_524_s19_q <= equal_524_s18_q;
      sum_818_s19_q <= sum_818_s18_q;
      select_820_s19_q <= select_820_s18_q[0];
      of_best_2_s19_q <= of_best_2;
      less_827_s19_q <= best_left_rdata_s18_q[7:0] < of_best_2;
      equal_828_s19_q <= equal_828_s18_q;
      equal_842_s19_q <= {less_819_s18_q, select_820_s18_q} == near_best;
      sum_843_s19_q <= sum_843[2:1];
      select_844_s19_q <= sum_843[0] ? sum_701_s18_q : sum_593_s18_q;
      select_845_s19_q <= sum_843[0] ? sum_646_s18_q : sum_758_s18_q;
      sum_848_s19_q <= sum_848[2:1];
      select_849_s19_q <= sum_848[0] ? sum_701_s18_q : sum_593_s18_q;
      select_850_s19_q <= sum_848[0] ? sum_646_s18_q : sum_758_s18_q;
      sum_854_s19_q <= {less_819_s18_q, select_820_s18_q[1]} + 2'h3;
      select_858_s19_q <= near_best[2] ? sum_818_s18_q : select_857;
      and_886_s19_q <= and_886_s18_q;
      partner_s19_q <= partner_s18_q;
      best_right_rdata_s19_q <= best_right_rdata_s18_q;
      less_891_s19_q <= best_right_rdata_s18_q[7:0] < of_best_2;
      equal_892_s19_q <= equal_892_s18_q;
      sum_913_s19_q <= sum_913[5];
      equal_915_s19_q <= equal_915_s18_q;
      equal_918_s19_q <= equal_918_s18_q;
      and_929_s19_q <= and_929_s18_q;
      way_s19_q <= way;
      and_948_s19_q <= and_948;
      and_960_s19_q <= and_960_s18_q;
      and_1060_s19_q <= and_1060_s18_q;
      equal_1200_s19_q <= equal_1200_s18_q;
      equal_1252_s19_q <= equal_1252_s18_q;
      not_1298_s19_q <= not_1298_s18_q;
      and_1386_s19_q <= and_1386_s18_q;
      less_1480_s19_q <= less_1480_s18_q;
      less_1483_s19_q <= less_1483_s18_q;
      difference_1518_s19_q <= difference_1518;
      less_1756_s19_q <= less_1756_s18_q;
      equal_1921_s19_q <= equal_1921_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  // hls/stages/census.hpp:100
  logic [13:0] sum_336;
  assign sum_336 = select_332_s19_q + (equal_334_s19_q ? 14'h0 : averager_memory_rdata_s19_q[13:0]);
  logic [13:0] sum_340;
  assign sum_340 = sum_338_s19_q + (equal_334_s19_q ? 14'h0 : averager_memory_rdata_s19_q[27:14]);
  // hls/stages/census.hpp:101
  logic and_344;
  assign and_344 = whole_s19_q & (averager_memory_rdata_s19_q[28] | equal_334_s19_q);
  // hls/stages/census.hpp:102
  logic and_348;
  assign and_348 = all_of_skin_s19_q & (averager_memory_rdata_s19_q[29] | equal_334_s19_q);
  // hls/stages/agreement.hpp:442
  logic less_826;
  assign less_826 = $signed(run_shift_s19_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:445
  logic or_829;
  assign or_829 = less_827_s19_q | equal_828_s19_q;
  // hls/stages/agreement.hpp:448
  logic [7:0] select_832;
  assign select_832 = less_826 ? (or_829 ? of_best_2_s19_q : best_left_rdata_s19_q[7:0]) : (less_827_s19_q ? of_best_2_s19_q : best_left_rdata_s19_q[7:0]);
  logic [5:0] select_836;
  assign select_836 = less_826 ? (or_829 ? run_shift_s19_q : best_left_rdata_s19_q[13:8]) : (less_827_s19_q ? run_shift_s19_q : best_left_rdata_s19_q[13:8]);
  // hls/stages/registration.hpp:23
  logic [7:0] below;
  assign below = sum_843_s19_q[1] ? sum_818_s19_q : (sum_843_s19_q[0] ? select_844_s19_q : select_845_s19_q);
  // hls/stages/registration.hpp:22
  logic [7:0] above;
  assign above = sum_848_s19_q[1] ? sum_818_s19_q : (sum_848_s19_q[0] ? select_849_s19_q : select_850_s19_q);
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/agreement.hpp:452
  logic or_893;
  assign or_893 = less_891_s19_q | equal_892_s19_q;
  // hls/stages/agreement.hpp:453
  logic [7:0] select_896;
  assign select_896 = less_826 ? (or_893 ? of_best_2_s19_q : best_right_rdata_s19_q[7:0]) : (less_891_s19_q ? of_best_2_s19_q : best_right_rdata_s19_q[7:0]);
  logic [6:0] select_900;
  assign select_900 = less_826 ? (or_893 ? x_s19_2_q : best_right_rdata_s19_q[14:8]) : (less_891_s19_q ? x_s19_2_q : best_right_rdata_s19_q[14:8]);
  // hls/stages/agreement.hpp:142
  logic [7:0] select_902;
  assign select_902 = drew_s19_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:564
  logic or_905;
  assign or_905 = select_902[7] | (~({select_902[5], select_902[3], select_902[1]} == 3'h0));
  // hls/stages/agreement.hpp:572
  logic or_916;
  assign or_916 = (~sum_913_s19_q) | equal_915_s19_q;
  // hls/stages/agreement.hpp:542
  logic and_917;
  assign and_917 = not_377_s19_q & or_916;
  // hls/stages/agreement.hpp:641
  logic equal_919;
  assign equal_919 = x_s19_q[5:4] == 2'h3;
  // hls/stages/agreement.hpp:317
  logic and_921;
  assign and_921 = equal_918_s19_q & (~equal_919);
  logic and_924;
  assign and_924 = not_374_s19_q & (not_519_s19_q & (drew_s19_q ? and_917 : and_921));
  // hls/stages/agreement.hpp:533
  logic [9:0] sum_938;
  assign sum_938 = {way_s19_q[8], way_s19_q} + 10'h1;
  // hls/stages/agreement.hpp:542
  logic [7:0] select_1009;
  assign select_1009 = less_376_s19_q ? select_902 : (sum_913_s19_q ? select_902 : {select_902[6:0], 1'b0});
  // hls/stages/agreement.hpp:564
  logic or_1012;
  assign or_1012 = select_1009[7] | (~({select_1009[5], select_1009[3], select_1009[1]} == 3'h0));
  // hls/stages/registration.hpp:158
  logic [11:0] select_1520;
  assign select_1520 = ($signed(difference_1518_s19_q[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1518_s19_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_1757;
  assign sum_1757 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1765;
  assign select_1765 = equal_373_s19_q ? select_902 : (equal_375_s19_q ? select_902 : (drew_s19_q ? select_1009 : 8'h1));
  // hls/stages/agreement.hpp:264
  logic [8:0] select_1778;
  assign select_1778 = equal_408_s19_q ? {difference_1776[7], difference_1776} : (less_1756_s19_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:184
  logic [8:0] select_1780;
  assign select_1780 = and_354_s19_q ? (equal_1252_s19_q ? select_1778 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:264
  logic [7:0] select_1782;
  assign select_1782 = equal_408_s19_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:184
  logic [7:0] select_1784;
  assign select_1784 = and_354_s19_q ? (equal_1252_s19_q ? select_1782 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_1786;
  assign select_1786 = sum_1757[7] ? {1'b1, sum_1757[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:254; read in stage 19, written in stage 21: 19 < 21 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s19_q;
  logic census_memory_re;
  assign census_memory_re = s19_en & and_354_s19_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory seen_columns, 120 x 14, DISTANCE 32, hls/stages/agreement.hpp:837; read in stage 19, written in stage 21: 19 < 21 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [13:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 14'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s19_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s19_en & and_960_s19_q;
  logic [13:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
    end else if (s19_en) begin
      region_columns_q <= select_1765;
      region_down_rest_q <= select_1780;
      region_down_back_q <= select_1784;
      region_down_next_q <= select_1786;
    end
  end

  logic [7:0] pixel_0_s20_q;
  logic [7:0] pixel_1_s20_q;
  logic saturated_s20_q;
  logic mask_s20_q;
  logic marks_first_s20_q;
  logic marks_last_s20_q;
  logic sample_pair_whole_s20_q;
  logic [7:0] x_s20_q;
  logic age_s20_q;
  logic lower_half_s20_q;
  logic [8:0] select_319_s20_q;
  logic and_328_s20_q;
  logic and_329_s20_q;
  logic [13:0] sum_336_s20_q;
  logic [13:0] sum_340_s20_q;
  logic and_344_s20_q;
  logic and_348_s20_q;
  logic [6:0] column_s20_q;
  logic and_352_s20_q;
  logic and_354_s20_q;
  logic equal_357_s20_q;
  logic equal_373_s20_q;
  logic not_374_s20_q;
  logic equal_375_s20_q;
  logic less_376_s20_q;
  logic not_377_s20_q;
  logic equal_408_s20_q;
  logic drew_s20_q;
  logic left_rdata_s20_q;
  logic [6:0] x_s20_2_q;
  logic not_519_s20_q;
  logic [7:0] best_left_rdata_s20_q;
  logic equal_524_s20_q;
  logic select_820_s20_q;
  logic less_826_s20_q;
  logic less_827_s20_q;
  logic or_829_s20_q;
  logic [7:0] select_833_s20_q;
  logic [5:0] select_837_s20_q;
  logic equal_842_s20_q;
  logic [7:0] below_s20_q;
  logic [7:0] above_s20_q;
  logic rise_s20_q;
  logic [1:0] sum_854_s20_q;
  logic [7:0] select_858_s20_q;
  logic [7:0] xor_862_s20_q;
  logic and_886_s20_q;
  logic [6:0] partner_s20_q;
  logic [7:0] select_897_s20_q;
  logic [6:0] select_901_s20_q;
  logic or_905_s20_q;
  logic or_908_s20_q;
  logic or_911_s20_q;
  logic equal_918_s20_q;
  logic equal_919_s20_q;
  logic and_924_s20_q;
  logic and_929_s20_q;
  logic and_936_s20_q;
  logic less_939_s20_q;
  logic or_949_s20_q;
  logic and_959_s20_q;
  logic and_960_s20_q;
  logic or_1012_s20_q;
  logic or_1015_s20_q;
  logic or_1018_s20_q;
  logic and_1060_s20_q;
  logic equal_1200_s20_q;
  logic equal_1252_s20_q;
  logic not_1298_s20_q;
  logic and_1386_s20_q;
  logic less_1480_s20_q;
  logic less_1483_s20_q;
  logic [11:0] select_1520_s20_q;
  logic less_1521_s20_q;
  logic less_1756_s20_q;
  logic sum_1757_s20_q;
  logic select_1797_s20_q;
  logic equal_1921_s20_q;
  logic and_2201_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      pixel_0_s20_q <= sample_pair_pixel_0_q;
      pixel_1_s20_q <= sample_pair_pixel_1_q;
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= sample_of_skin_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      sample_pair_whole_s20_q <= sample_pair_whole_s19_q;
      x_s20_q <= x_s19_q;
      age_s20_q <= age_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      select_319_s20_q <= select_319_s19_q;
      and_328_s20_q <= and_328_s19_q;
      and_329_s20_q <= and_329_s19_q;
      sum_336_s20_q <= sum_336;
      sum_340_s20_q <= sum_340;
      and_344_s20_q <= and_344;
      and_348_s20_q <= and_348;
      column_s20_q <= column_s19_q;
      and_352_s20_q <= and_352_s19_q;
      and_354_s20_q <= and_354_s19_q;
      equal_357_s20_q <= equal_357_s19_q;
      equal_373_s20_q <= equal_373_s19_q;
      not_374_s20_q <= not_374_s19_q;
      equal_375_s20_q <= equal_375_s19_q;
      less_376_s20_q <= less_376_s19_q;
      not_377_s20_q <= not_377_s19_q;
      equal_408_s20_q <= equal_408_s19_q;
      drew_s20_q <= drew_s19_q;
      left_rdata_s20_q <= left_rdata_s19_q;
      x_s20_2_q <= x_s19_2_q;
      not_519_s20_q <= not_519_s19_q;
      best_left_rdata_s20_q <= best_left_rdata_s19_q[21:14];
      equal_524_s20_q <= equal_524_s19_q;
      select_820_s20_q <= select_820_s19_q;
      less_826_s20_q <= less_826;
      less_827_s20_q <= less_827_s19_q;
      or_829_s20_q <= or_829;
      select_833_s20_q <= equal_524_s19_q ? of_best_2_s19_q : select_832;
      select_837_s20_q <= equal_524_s19_q ? run_shift_s19_q : select_836;
      equal_842_s20_q <= equal_842_s19_q;
      below_s20_q <= below;
      above_s20_q <= above;
      rise_s20_q <= rise[8];
      sum_854_s20_q <= sum_854_s19_q;
      select_858_s20_q <= select_858_s19_q;
      xor_862_s20_q <= rise[7:0] ^ {8{rise[8]}};
      and_886_s20_q <= and_886_s19_q;
      partner_s20_q <= partner_s19_q;
      select_897_s20_q <= equal_524_s19_q ? of_best_2_s19_q : select_896;
      select_901_s20_q <= equal_524_s19_q ? x_s19_2_q : select_900;
      or_905_s20_q <= or_905;
      or_908_s20_q <= select_902[7] | (~({select_902[6], select_902[3:2]} == 3'h0));
      or_911_s20_q <= select_902[7] | (~(select_902[6:4] == 3'h0));
      equal_918_s20_q <= equal_918_s19_q;
      equal_919_s20_q <= equal_919;
      and_924_s20_q <= and_924;
      and_929_s20_q <= and_929_s19_q;
      and_936_s20_q <= and_929_s19_q & (8'hb6 < best_left_rdata_s19_q[7:0]);
      less_939_s20_q <= {{6{sum_938[9]}}, sum_938} < 16'h3;
      or_949_s20_q <= (cfg_nearer_below_i & best_left_rdata_s19_q[13]) | and_948_s19_q;
      and_959_s20_q <= not_374_s19_q & (not_519_s19_q & (drew_s19_q & and_917));
      and_960_s20_q <= and_960_s19_q;
      or_1012_s20_q <= or_1012;
      or_1015_s20_q <= select_1009[7] | (~({select_1009[6], select_1009[3:2]} == 3'h0));
      or_1018_s20_q <= select_1009[7] | (~(select_1009[6:4] == 3'h0));
      and_1060_s20_q <= and_1060_s19_q;
      equal_1200_s20_q <= equal_1200_s19_q;
      equal_1252_s20_q <= equal_1252_s19_q;
      not_1298_s20_q <= not_1298_s19_q;
      and_1386_s20_q <= and_1386_s19_q;
      less_1480_s20_q <= less_1480_s19_q;
      less_1483_s20_q <= less_1483_s19_q;
      select_1520_s20_q <= select_1520;
      less_1521_s20_q <= $signed(5'h0) < $signed(select_1520[11:7]);
      less_1756_s20_q <= less_1756_s19_q;
      sum_1757_s20_q <= sum_1757[7];
      select_1797_s20_q <= sum_913_s19_q ? (equal_915_s19_q & or_916) : or_916;
      equal_1921_s20_q <= equal_1921_s19_q;
      and_2201_s20_q <= not_374_s19_q & (not_519_s19_q & (not_1298_s19_q & and_921));
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
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
  assign grey = and_328_s20_q ? sum_336_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_357_s20_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey_2;
  assign grey_2 = and_328_s20_q ? sum_340_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_357_s20_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:126
  logic and_365;
  assign and_365 = and_328_s20_q & and_344_s20_q;
  // hls/stages/census.hpp:105
  logic select_367;
  assign select_367 = equal_357_s20_q ? and_365 : (averager_mask_q & and_365);
  // hls/stages/agreement.hpp:183
  logic whole_2;
  assign whole_2 = sample_pair_whole_s20_q & select_367;
  // hls/stages/census.hpp:126
  logic and_369;
  assign and_369 = and_328_s20_q & and_348_s20_q;
  // hls/stages/census.hpp:105
  logic select_371;
  assign select_371 = equal_357_s20_q ? and_369 : (averager_of_skin_q & and_369);
  // hls/stages/registration.hpp:26
  logic [7:0] select_859;
  assign select_859 = rise_s20_q ? below_s20_q : above_s20_q;
  logic [8:0] fall;
  assign fall = {1'b0, select_858_s20_q} - {1'b0, select_859};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [8:0] size;
  assign size = {8'h0, rise_s20_q} + {1'b0, xor_862_s20_q};
  // hls/stages/agreement.hpp:317
  logic [5:0] select_912;
  assign select_912 = drew_s20_q ? {region_row_q, or_911_s20_q, or_908_s20_q, or_905_s20_q} : x_s20_q[5:0];
  // hls/stages/agreement.hpp:533
  logic and_940;
  assign and_940 = and_936_s20_q & less_939_s20_q;
  // hls/stages/agreement.hpp:170
  logic and_950;
  assign and_950 = and_940 & or_949_s20_q;
  // hls/stages/agreement.hpp:183
  logic [10:0] select_1092;
  assign select_1092 = sample_pair_whole_s20_q ? (and_352_s20_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1094;
  assign select_1094 = sample_pair_whole_s20_q ? (and_352_s20_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_1115;
  assign select_1115 = sample_pair_whole_s20_q ? (and_352_s20_q ? select_367 : averager_mask_q) : averager_mask_q;
  logic select_1117;
  assign select_1117 = sample_pair_whole_s20_q ? (and_352_s20_q ? select_371 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:317
  logic and_1390;
  assign and_1390 = not_374_s20_q & (not_519_s20_q & (drew_s20_q & (not_377_s20_q & and_1386_s20_q)));
  // hls/stages/agreement.hpp:537
  logic and_1481;
  assign and_1481 = and_940 & less_1480_s20_q;
  // hls/stages/registration.hpp:73
  logic equal_1484;
  assign equal_1484 = {lower_half_s20_q, less_1483_s20_q} == 2'h3;
  logic equal_1485;
  assign equal_1485 = {lower_half_s20_q, less_1483_s20_q} == 2'h2;
  logic equal_1486;
  assign equal_1486 = {lower_half_s20_q, less_1483_s20_q} == 2'h1;
  // hls/stages/registration.hpp:158
  logic [11:0] residual;
  assign residual = less_1521_s20_q ? 12'h7f : select_1520_s20_q;
  // hls/stages/registration.hpp:73
  logic not_1560;
  assign not_1560 = ~equal_1484;
  logic not_1561;
  assign not_1561 = ~equal_1485;
  // hls/stages/agreement.hpp:170
  logic and_1566;
  assign and_1566 = not_377_s20_q & (and_1481 & (not_1560 & (not_1561 & (~equal_1486))));
  logic and_1575;
  assign and_1575 = not_377_s20_q & (and_1481 & (not_1560 & (equal_1486 & not_1561)));
  // hls/stages/agreement.hpp:317
  logic and_1584;
  assign and_1584 = drew_s20_q & (not_377_s20_q & (and_1481 & (equal_1485 & not_1560)));
  logic and_1592;
  assign and_1592 = not_519_s20_q & (drew_s20_q & (not_377_s20_q & (and_1481 & equal_1484)));
  // hls/stages/agreement.hpp:264
  logic [2:0] select_1759;
  assign select_1759 = less_1756_s20_q ? (sum_1757_s20_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1761;
  assign select_1761 = equal_1252_s20_q ? (equal_408_s20_q ? 3'h0 : select_1759) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1757_s20_q;
  // hls/stages/agreement.hpp:264
  logic select_1790;
  assign select_1790 = equal_1252_s20_q ? (equal_408_s20_q | (less_1756_s20_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:142
  logic or_1795;
  assign or_1795 = segment_starts_q | not_1298_s20_q;
  // hls/stages/agreement.hpp:317
  logic select_1799;
  assign select_1799 = drew_s20_q ? (less_376_s20_q ? or_1795 : select_1797_s20_q) : or_1795;
  logic select_1801;
  assign select_1801 = equal_373_s20_q ? or_1795 : (equal_375_s20_q ? or_1795 : select_1799);

  // Memory regions, 64 x 36, DISTANCE 32, hls/stages/agreement.hpp:822; read in stage 20, written in stage 23: 20 < 23 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_912;
  logic regions_re;
  assign regions_re = s20_en & and_924_s20_q;
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_319_s20_q;
  logic averager_memory_we;
  assign averager_memory_we = s20_en & and_329_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_348_s20_q, and_344_s20_q, sum_340_s20_q, sum_336_s20_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s18_sim;
  logic averager_memory_re_s18_sim;
  logic [8:0] averager_memory_raddr_s19_sim;
  logic averager_memory_re_s19_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s18_sim <= 1'b0;
      averager_memory_re_s19_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s18_sim <= averager_memory_re;
      averager_memory_raddr_s18_sim <= averager_memory_raddr;
      averager_memory_re_s19_sim <= averager_memory_re_s18_sim;
      averager_memory_raddr_s19_sim <= averager_memory_raddr_s18_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s18_sim && averager_memory_raddr_s18_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s19_sim && averager_memory_raddr_s19_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd480) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd480) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = partner_s20_q;
  logic best_right_we;
  assign best_right_we = s20_en & and_886_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_901_s20_q, select_897_s20_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_right_raddr_s17_sim;
  logic best_right_re_s17_sim;
  logic [6:0] best_right_raddr_s18_sim;
  logic best_right_re_s18_sim;
  logic [6:0] best_right_raddr_s19_sim;
  logic best_right_re_s19_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s17_sim <= 1'b0;
      best_right_re_s18_sim <= 1'b0;
      best_right_re_s19_sim <= 1'b0;
    end else if (en_i) begin
      best_right_re_s17_sim <= best_right_re;
      best_right_raddr_s17_sim <= best_right_raddr;
      best_right_re_s18_sim <= best_right_re_s17_sim;
      best_right_raddr_s18_sim <= best_right_raddr_s17_sim;
      best_right_re_s19_sim <= best_right_re_s18_sim;
      best_right_raddr_s19_sim <= best_right_raddr_s18_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s17_sim && best_right_raddr_s17_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s18_sim && best_right_raddr_s18_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s19_sim && best_right_raddr_s19_sim == best_right_waddr) begin
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
    end else if (s20_en) begin
      averager_mask_q <= select_1115;
      averager_of_skin_q <= select_1117;
      region_row_q <= and_354_s20_q ? select_1761 : region_row_q;
      region_fresh_q <= and_354_s20_q ? select_1790 : region_fresh_q;
      segment_starts_q <= select_1801;
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
    if (s20_en) begin
      averager_total_0_q <= select_1092;
      averager_total_1_q <= select_1094;
    end
  end

  logic [7:0] pixel_0_s21_q;
  logic [7:0] pixel_1_s21_q;
  logic saturated_s21_q;
  logic mask_s21_q;
  logic marks_first_s21_q;
  logic marks_last_s21_q;
  logic sample_pair_whole_s21_q;
  logic [7:0] x_s21_q;
  logic age_s21_q;
  logic lower_half_s21_q;
  logic [2:0] region_row_s21_q;
  logic region_fresh_s21_q;
  logic [6:0] column_s21_q;
  logic and_352_s21_q;
  logic and_354_s21_q;
  logic [77:0] census_memory_rdata_s21_q;
  logic [8:0] grey_s21_q;
  logic equal_357_s21_q;
  logic [8:0] select_360_s21_q;
  logic [8:0] grey_2_s21_q;
  logic [8:0] select_364_s21_q;
  logic whole_2_s21_q;
  logic and_372_s21_q;
  logic equal_373_s21_q;
  logic not_374_s21_q;
  logic equal_375_s21_q;
  logic less_376_s21_q;
  logic not_377_s21_q;
  logic equal_408_s21_q;
  logic drew_s21_q;
  logic [6:0] x_s21_2_q;
  logic not_519_s21_q;
  logic [7:0] best_left_rdata_s21_q;
  logic equal_524_s21_q;
  logic select_820_s21_q;
  logic less_826_s21_q;
  logic less_827_s21_q;
  logic or_829_s21_q;
  logic [7:0] select_833_s21_q;
  logic [5:0] select_837_s21_q;
  logic equal_842_s21_q;
  logic rise_s21_q;
  logic [1:0] sum_854_s21_q;
  logic [7:0] twice_s21_q;
  logic [8:0] size_s21_q;
  logic and_886_s21_q;
  logic or_905_s21_q;
  logic or_908_s21_q;
  logic or_911_s21_q;
  logic equal_918_s21_q;
  logic equal_919_s21_q;
  logic and_929_s21_q;
  logic and_940_s21_q;
  logic and_950_s21_q;
  logic and_952_s21_q;
  logic and_959_s21_q;
  logic and_960_s21_q;
  logic [13:0] seen_columns_rdata_s21_q;
  logic and_962_s21_q;
  logic or_1012_s21_q;
  logic or_1015_s21_q;
  logic or_1018_s21_q;
  logic and_1060_s21_q;
  logic equal_1200_s21_q;
  logic equal_1252_s21_q;
  logic not_1298_s21_q;
  logic and_1390_s21_q;
  logic and_1471_s21_q;
  logic and_1481_s21_q;
  logic less_1483_s21_q;
  logic equal_1484_s21_q;
  logic equal_1485_s21_q;
  logic equal_1486_s21_q;
  logic [7:0] residual_s21_q;
  logic and_1567_s21_q;
  logic and_1576_s21_q;
  logic and_1585_s21_q;
  logic and_1593_s21_q;
  logic [12:0] difference_1604_s21_q;
  logic equal_1921_s21_q;
  logic and_2201_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= pixel_0_s20_q;
      pixel_1_s21_q <= pixel_1_s20_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= mask_s20_q;
      marks_first_s21_q <= marks_first_s20_q;
      marks_last_s21_q <= marks_last_s20_q;
      sample_pair_whole_s21_q <= sample_pair_whole_s20_q;
      x_s21_q <= x_s20_q;
      age_s21_q <= age_s20_q;
      lower_half_s21_q <= lower_half_s20_q;
      region_row_s21_q <= region_row_q;
      region_fresh_s21_q <= region_fresh_q;
      column_s21_q <= column_s20_q;
      and_352_s21_q <= and_352_s20_q;
      and_354_s21_q <= and_354_s20_q;
      census_memory_rdata_s21_q <= census_memory_rdata_q;
      grey_s21_q <= grey;
      equal_357_s21_q <= equal_357_s20_q;
      select_360_s21_q <= sample_pair_whole_s20_q ? total[10:2] : 9'h0;
      grey_2_s21_q <= grey_2;
      select_364_s21_q <= sample_pair_whole_s20_q ? total_2[10:2] : 9'h0;
      whole_2_s21_q <= whole_2;
      and_372_s21_q <= sample_pair_whole_s20_q & select_371;
      equal_373_s21_q <= equal_373_s20_q;
      not_374_s21_q <= not_374_s20_q;
      equal_375_s21_q <= equal_375_s20_q;
      less_376_s21_q <= less_376_s20_q;
      not_377_s21_q <= not_377_s20_q;
      equal_408_s21_q <= equal_408_s20_q;
      drew_s21_q <= drew_s20_q;
      x_s21_2_q <= x_s20_2_q;
      not_519_s21_q <= not_519_s20_q;
      best_left_rdata_s21_q <= best_left_rdata_s20_q;
      equal_524_s21_q <= equal_524_s20_q;
      select_820_s21_q <= select_820_s20_q;
      less_826_s21_q <= less_826_s20_q;
      less_827_s21_q <= less_827_s20_q;
      or_829_s21_q <= or_829_s20_q;
      select_833_s21_q <= select_833_s20_q;
      select_837_s21_q <= select_837_s20_q;
      equal_842_s21_q <= equal_842_s20_q;
      rise_s21_q <= rise_s20_q;
      sum_854_s21_q <= sum_854_s20_q;
      twice_s21_q <= twice;
      size_s21_q <= size;
      and_886_s21_q <= and_886_s20_q;
      or_905_s21_q <= or_905_s20_q;
      or_908_s21_q <= or_908_s20_q;
      or_911_s21_q <= or_911_s20_q;
      equal_918_s21_q <= equal_918_s20_q;
      equal_919_s21_q <= equal_919_s20_q;
      and_929_s21_q <= and_929_s20_q;
      and_940_s21_q <= and_940;
      and_950_s21_q <= and_950;
      and_952_s21_q <= not_377_s20_q & (left_rdata_s20_q & and_950);
      and_959_s21_q <= and_959_s20_q;
      and_960_s21_q <= and_960_s20_q;
      seen_columns_rdata_s21_q <= seen_columns_rdata_q;
      and_962_s21_q <= left_rdata_s20_q & not_377_s20_q;
      or_1012_s21_q <= or_1012_s20_q;
      or_1015_s21_q <= or_1015_s20_q;
      or_1018_s21_q <= or_1018_s20_q;
      and_1060_s21_q <= and_1060_s20_q;
      equal_1200_s21_q <= equal_1200_s20_q;
      equal_1252_s21_q <= equal_1252_s20_q;
      not_1298_s21_q <= not_1298_s20_q;
      and_1390_s21_q <= and_1390;
      and_1471_s21_q <= left_rdata_s20_q & and_1386_s20_q;
      and_1481_s21_q <= and_1481;
      less_1483_s21_q <= less_1483_s20_q;
      equal_1484_s21_q <= equal_1484;
      equal_1485_s21_q <= equal_1485;
      equal_1486_s21_q <= equal_1486;
      residual_s21_q <= residual[7:0];
      and_1567_s21_q <= drew_s20_q & and_1566;
      and_1576_s21_q <= drew_s20_q & and_1575;
      and_1585_s21_q <= not_519_s20_q & and_1584;
      and_1593_s21_q <= not_374_s20_q & and_1592;
      difference_1604_s21_q <= 13'h0 - {residual[11], residual};
      equal_1921_s21_q <= equal_1921_s20_q;
      and_2201_s21_q <= and_2201_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
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
  logic less_381;
  assign less_381 = census_memory_rdata_s21_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_382;
  assign less_382 = census_memory_rdata_s21_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_383;
  assign less_383 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_384;
  assign less_384 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_385;
  assign less_385 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_386;
  assign less_386 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_387;
  assign less_387 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_388;
  assign less_388 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_389;
  assign less_389 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_390;
  assign less_390 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_391;
  assign less_391 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_392;
  assign less_392 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_393;
  assign less_393 = census_memory_rdata_s21_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_394;
  assign less_394 = census_memory_rdata_s21_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_395;
  assign less_395 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_396;
  assign less_396 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_397;
  assign less_397 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_398;
  assign less_398 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_399;
  assign less_399 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_400;
  assign less_400 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_401;
  assign less_401 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_402;
  assign less_402 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_403;
  assign less_403 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_404;
  assign less_404 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:259
  logic equal_405;
  assign equal_405 = column_s21_q == 7'h0;
  logic [3:0] select_409;
  assign select_409 = equal_408_s21_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:260
  logic [4:0] select_410;
  assign select_410 = equal_405 ? {select_409, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_411;
  assign select_411 = equal_405 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:206
  logic and_414;
  assign and_414 = census_memory_rdata_s21_q[38] & (census_memory_rdata_s21_q[18] & whole_2_s21_q);
  logic and_416;
  assign and_416 = census_memory_rdata_s21_q[77] & (census_memory_rdata_s21_q[58] & and_414);
  // hls/stages/census.hpp:190
  logic [9:0] difference_439;
  assign difference_439 = {1'b0, select_360_s21_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_442;
  assign difference_442 = {1'b0, census_memory_rdata_s21_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_446;
  assign difference_446 = {1'b0, census_memory_rdata_s21_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_450;
  assign difference_450 = {1'b0, census_memory_rdata_s21_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_454;
  assign difference_454 = {1'b0, census_memory_rdata_s21_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/registration.hpp:28
  logic [8:0] select_865;
  assign select_865 = ({twice_s21_q, 1'b0} < size_s21_q) ? {twice_s21_q, 1'b0} : size_s21_q;
  // hls/stages/agreement.hpp:170
  logic textured;
  assign textured = not_377_s21_q & and_929_s21_q;
  // hls/stages/agreement.hpp:484
  logic [6:0] select_931;
  assign select_931 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:170
  logic explained;
  assign explained = not_377_s21_q & and_940_s21_q;
  // hls/stages/agreement.hpp:484
  logic [6:0] select_942;
  assign select_942 = segment_started_q ? segment_explained_q : 7'h0;
  logic [6:0] select_953;
  assign select_953 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:170
  logic near;
  assign near = not_377_s21_q & and_950_s21_q;
  // hls/stages/agreement.hpp:542
  logic [5:0] select_997;
  assign select_997 = less_376_s21_q ? 6'h0 : {seen_columns_rdata_s21_q[7:6], seen_columns_rdata_s21_q[4:2], seen_columns_rdata_s21_q[0]};
  // hls/stages/agreement.hpp:600
  logic [1:0] sum_999;
  assign sum_999 = {1'b0, select_997[3]} + ({1'b0, textured} + {1'b0, select_997[0]});
  // hls/stages/agreement.hpp:601
  logic [1:0] sum_1029;
  assign sum_1029 = {1'b0, select_997[4]} + ({1'b0, explained} + {1'b0, select_997[1]});
  // hls/stages/agreement.hpp:183
  logic [8:0] select_1084;
  assign select_1084 = sample_pair_whole_s21_q ? (and_352_s21_q ? grey_s21_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1086;
  assign select_1086 = sample_pair_whole_s21_q ? (and_352_s21_q ? grey_2_s21_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1088;
  assign select_1088 = sample_pair_whole_s21_q ? (and_352_s21_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1090;
  assign select_1090 = sample_pair_whole_s21_q ? (and_352_s21_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1095;
  assign sum_1095 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s21_q};
  logic [9:0] sum_1103;
  assign sum_1103 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s21_q};
  // hls/stages/agreement.hpp:184
  logic [8:0] select_1118;
  assign select_1118 = and_354_s21_q ? select_360_s21_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1119;
  assign select_1119 = and_354_s21_q ? select_364_s21_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1121;
  assign select_1121 = and_354_s21_q ? census_memory_rdata_s21_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1122;
  assign select_1122 = and_354_s21_q ? census_memory_rdata_s21_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1123;
  assign select_1123 = and_354_s21_q ? census_memory_rdata_s21_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1124;
  assign select_1124 = and_354_s21_q ? census_memory_rdata_s21_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1125;
  assign select_1125 = and_354_s21_q ? census_memory_rdata_s21_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1126;
  assign select_1126 = and_354_s21_q ? census_memory_rdata_s21_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1127;
  assign select_1127 = and_354_s21_q ? census_memory_rdata_s21_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1128;
  assign select_1128 = and_354_s21_q ? census_memory_rdata_s21_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1129;
  assign select_1129 = and_354_s21_q ? census_memory_rdata_s21_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1130;
  assign select_1130 = and_354_s21_q ? census_memory_rdata_s21_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1131;
  assign select_1131 = and_354_s21_q ? census_memory_rdata_s21_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1132;
  assign select_1132 = and_354_s21_q ? census_memory_rdata_s21_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1133;
  assign select_1133 = and_354_s21_q ? census_memory_rdata_s21_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1134;
  assign select_1134 = and_354_s21_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1135;
  assign select_1135 = and_354_s21_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1137;
  assign select_1137 = and_354_s21_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1138;
  assign select_1138 = and_354_s21_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1140;
  assign select_1140 = and_354_s21_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1141;
  assign select_1141 = and_354_s21_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1143;
  assign select_1143 = and_354_s21_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1144;
  assign select_1144 = and_354_s21_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1145;
  assign select_1145 = and_354_s21_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1147;
  assign select_1147 = and_354_s21_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1148;
  assign select_1148 = and_354_s21_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1150;
  assign select_1150 = and_354_s21_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1151;
  assign select_1151 = and_354_s21_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1153;
  assign select_1153 = and_354_s21_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1154;
  assign select_1154 = and_354_s21_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1156;
  assign select_1156 = and_354_s21_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1157;
  assign select_1157 = and_354_s21_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1159;
  assign select_1159 = and_354_s21_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1160;
  assign select_1160 = and_354_s21_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1162;
  assign select_1162 = and_354_s21_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1163;
  assign select_1163 = and_354_s21_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1166;
  assign select_1166 = and_354_s21_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1167;
  assign select_1167 = and_354_s21_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1170;
  assign select_1170 = and_354_s21_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1171;
  assign select_1171 = and_354_s21_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1175;
  assign difference_1175 = {1'b0, select_364_s21_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_1178;
  assign difference_1178 = {1'b0, census_memory_rdata_s21_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_1182;
  assign difference_1182 = {1'b0, census_memory_rdata_s21_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_1186;
  assign difference_1186 = {1'b0, census_memory_rdata_s21_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_1190;
  assign difference_1190 = {1'b0, census_memory_rdata_s21_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1220;
  assign difference_1220 = {1'b0, select_360_s21_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_1231;
  assign difference_1231 = {1'b0, select_364_s21_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:184
  logic and_1385;
  assign and_1385 = and_354_s21_q & (equal_408_s21_q & equal_1252_s21_q);
  // hls/stages/agreement.hpp:317
  logic and_1395;
  assign and_1395 = not_374_s21_q & (not_519_s21_q & (drew_s21_q & textured));
  logic and_1400;
  assign and_1400 = not_374_s21_q & (not_519_s21_q & (drew_s21_q & explained));
  logic and_1405;
  assign and_1405 = not_374_s21_q & (not_519_s21_q & (drew_s21_q & and_952_s21_q));
  // hls/stages/agreement.hpp:170
  logic [8:0] select_1435;
  assign select_1435 = less_376_s21_q ? 9'h0 : (and_929_s21_q ? {and_940_s21_q, cfg_explained_limit_i} : 9'h0);
  // hls/stages/agreement.hpp:317
  logic [8:0] select_1438;
  assign select_1438 = equal_373_s21_q ? 9'h0 : (equal_375_s21_q ? 9'h0 : (drew_s21_q ? select_1435 : 9'h0));
  // hls/stages/agreement.hpp:537
  logic [9:0] select_1473;
  assign select_1473 = and_1471_s21_q ? ({1'b0, and_950_s21_q, 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:317
  logic [9:0] select_1476;
  assign select_1476 = equal_375_s21_q ? 10'h0 : (drew_s21_q ? (less_376_s21_q ? 10'h0 : select_1473) : 10'h0);
  logic and_1569;
  assign and_1569 = not_374_s21_q & (not_519_s21_q & and_1567_s21_q);
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1571;
  assign select_1571 = and_1385 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1569});
  // hls/stages/agreement.hpp:317
  logic and_1578;
  assign and_1578 = not_374_s21_q & (not_519_s21_q & and_1576_s21_q);
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1580;
  assign select_1580 = and_1385 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1578});
  // hls/stages/agreement.hpp:317
  logic and_1586;
  assign and_1586 = not_374_s21_q & and_1585_s21_q;
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1588;
  assign select_1588 = and_1385 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1586});
  logic [11:0] select_1595;
  assign select_1595 = and_1385 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1593_s21_q});
  // hls/stages/registration.hpp:146
  logic less_1605;
  assign less_1605 = $signed(difference_1604_s21_q) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:170
  logic and_1606;
  assign and_1606 = and_1481_s21_q & less_1605;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1608;
  assign select_1608 = drew_s21_q ? (less_376_s21_q ? 2'h0 : {and_1606, and_1481_s21_q}) : 2'h0;
  // hls/stages/registration.hpp:80
  logic not_1613;
  assign not_1613 = ~less_1483_s21_q;
  // hls/stages/registration.hpp:146
  logic less_1688;
  assign less_1688 = $signed(difference_1604_s21_q) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1689;
  assign and_1689 = not_1613 & less_1688;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1691;
  assign select_1691 = less_376_s21_q ? 2'h0 : (and_1481_s21_q ? {and_1689, not_1613} : 2'h0);
  // hls/stages/registration.hpp:79
  logic and_1705;
  assign and_1705 = less_1483_s21_q & less_1688;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1707;
  assign select_1707 = less_376_s21_q ? 2'h0 : (and_1481_s21_q ? {and_1705, less_1483_s21_q} : 2'h0);
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2025;
  assign sum_2025 = {1'b0, upper} + {1'b0, lower};
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s21_q;
  logic census_memory_we;
  assign census_memory_we = s21_en & and_354_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s21_q[58:40], census_memory_rdata_s21_q[38:0], and_372_s21_q, whole_2_s21_q, select_364_s21_q, select_360_s21_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s20_sim;
  logic census_memory_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s20_sim <= census_memory_re;
      census_memory_raddr_s20_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s20_sim && census_memory_raddr_s20_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s21_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s21_en & and_960_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s21_q[10:6], seen_columns_rdata_s21_q[4:0], near, explained, and_962_s21_q, textured};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s20_sim;
  logic seen_columns_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s20_sim <= seen_columns_re;
      seen_columns_raddr_s20_sim <= seen_columns_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s20_sim && seen_columns_raddr_s20_sim == seen_columns_waddr) begin
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
    end else if (s21_en) begin
      census_filled_q <= and_354_s21_q ? {select_411[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_354_s21_q ? select_410 : rows_passed_above_q;
      registration_counts_measured_0_q <= select_1571;
      registration_counts_measured_1_q <= select_1580;
      registration_counts_measured_2_q <= select_1588;
      registration_counts_measured_3_q <= select_1595;
      segment_textured_q <= select_931 + {6'h0, and_1395};
      segment_explained_q <= select_942 + {6'h0, and_1400};
      segment_nearer_q <= select_953 + {6'h0, and_1405};
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
    if (s21_en) begin
      averager_quarter_1_0_q <= select_1084;
      averager_quarter_1_1_q <= select_1086;
      averager_quarter_2_0_q <= select_1088;
      averager_quarter_2_1_q <= select_1090;
      census_columns_values_0_cell_0_left_q <= select_1118;
      census_columns_values_0_cell_0_right_q <= select_1119;
      census_columns_values_0_cell_1_left_q <= select_1121;
      census_columns_values_0_cell_1_right_q <= select_1122;
      census_columns_values_0_cell_1_mask_q <= select_1123;
      census_columns_values_0_cell_2_left_q <= select_1124;
      census_columns_values_0_cell_2_right_q <= select_1125;
      census_columns_values_0_cell_2_mask_q <= select_1126;
      census_columns_values_0_cell_2_of_skin_q <= select_1127;
      census_columns_values_0_cell_3_left_q <= select_1128;
      census_columns_values_0_cell_3_right_q <= select_1129;
      census_columns_values_0_cell_3_mask_q <= select_1130;
      census_columns_values_0_cell_4_left_q <= select_1131;
      census_columns_values_0_cell_4_right_q <= select_1132;
      census_columns_values_0_cell_4_mask_q <= select_1133;
      census_columns_values_1_cell_0_left_q <= select_1134;
      census_columns_values_1_cell_0_right_q <= select_1135;
      census_columns_values_1_cell_1_left_q <= select_1137;
      census_columns_values_1_cell_1_right_q <= select_1138;
      census_columns_values_1_cell_2_left_q <= select_1140;
      census_columns_values_1_cell_2_right_q <= select_1141;
      census_columns_values_1_cell_2_of_skin_q <= select_1143;
      census_columns_values_1_cell_3_left_q <= select_1144;
      census_columns_values_1_cell_3_right_q <= select_1145;
      census_columns_values_1_cell_4_left_q <= select_1147;
      census_columns_values_1_cell_4_right_q <= select_1148;
      census_columns_values_2_cell_0_left_q <= select_1150;
      census_columns_values_2_cell_0_right_q <= select_1151;
      census_columns_values_2_cell_1_left_q <= select_1153;
      census_columns_values_2_cell_1_right_q <= select_1154;
      census_columns_values_2_cell_2_left_q <= select_1156;
      census_columns_values_2_cell_2_right_q <= select_1157;
      census_columns_values_2_cell_3_left_q <= select_1159;
      census_columns_values_2_cell_3_right_q <= select_1160;
      census_columns_values_2_cell_4_left_q <= select_1162;
      census_columns_values_2_cell_4_right_q <= select_1163;
      census_columns_values_3_cell_1_left_q <= select_1166;
      census_columns_values_3_cell_1_right_q <= select_1167;
      census_columns_values_3_cell_3_left_q <= select_1170;
      census_columns_values_3_cell_3_right_q <= select_1171;
      sharpness_last_mean_0_q <= and_354_s21_q ? select_360_s21_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_354_s21_q ? select_364_s21_q : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic sample_pair_whole_s22_q;
  logic census_columns_values_0_cell_1_mask_s22_q;
  logic census_columns_values_0_cell_2_mask_s22_q;
  logic census_columns_values_0_cell_3_mask_s22_q;
  logic census_columns_values_0_cell_4_mask_s22_q;
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic [7:0] x_s22_q;
  logic age_s22_q;
  logic lower_half_s22_q;
  logic [11:0] registration_counts_measured_0_s22_q;
  logic [11:0] registration_counts_measured_1_s22_q;
  logic [11:0] registration_counts_measured_2_s22_q;
  logic [11:0] registration_counts_measured_3_s22_q;
  logic [2:0] region_row_s22_q;
  logic region_fresh_s22_q;
  logic [6:0] column_s22_q;
  logic and_352_s22_q;
  logic and_354_s22_q;
  logic equal_357_s22_q;
  logic whole_2_s22_q;
  logic equal_373_s22_q;
  logic not_374_s22_q;
  logic equal_375_s22_q;
  logic less_376_s22_q;
  logic not_377_s22_q;
  logic less_381_s22_q;
  logic less_382_s22_q;
  logic less_383_s22_q;
  logic less_384_s22_q;
  logic less_385_s22_q;
  logic less_386_s22_q;
  logic less_387_s22_q;
  logic less_388_s22_q;
  logic less_389_s22_q;
  logic less_390_s22_q;
  logic less_391_s22_q;
  logic less_392_s22_q;
  logic less_393_s22_q;
  logic less_394_s22_q;
  logic less_395_s22_q;
  logic less_396_s22_q;
  logic less_397_s22_q;
  logic less_398_s22_q;
  logic less_399_s22_q;
  logic less_400_s22_q;
  logic less_401_s22_q;
  logic less_402_s22_q;
  logic less_403_s22_q;
  logic less_404_s22_q;
  logic and_412_s22_q;
  logic and_416_s22_q;
  logic difference_439_s22_q;
  logic [8:0] xor_440_s22_q;
  logic difference_442_s22_q;
  logic [8:0] xor_443_s22_q;
  logic difference_446_s22_q;
  logic [8:0] xor_447_s22_q;
  logic difference_450_s22_q;
  logic [8:0] xor_451_s22_q;
  logic difference_454_s22_q;
  logic [8:0] xor_455_s22_q;
  logic drew_s22_q;
  logic [6:0] x_s22_2_q;
  logic not_519_s22_q;
  logic [7:0] best_left_rdata_s22_q;
  logic equal_524_s22_q;
  logic select_820_s22_q;
  logic less_826_s22_q;
  logic less_827_s22_q;
  logic or_829_s22_q;
  logic [7:0] select_833_s22_q;
  logic [5:0] select_837_s22_q;
  logic equal_842_s22_q;
  logic rise_s22_q;
  logic [1:0] sum_854_s22_q;
  logic [7:0] twice_s22_q;
  logic [8:0] select_865_s22_q;
  logic and_886_s22_q;
  logic or_905_s22_q;
  logic or_908_s22_q;
  logic or_911_s22_q;
  logic equal_918_s22_q;
  logic equal_919_s22_q;
  logic [35:0] regions_rdata_s22_q;
  logic and_929_s22_q;
  logic [6:0] sum_932_s22_q;
  logic [6:0] sum_943_s22_q;
  logic [6:0] sum_954_s22_q;
  logic and_959_s22_q;
  logic [5:0] select_996_s22_q;
  logic [1:0] sum_999_s22_q;
  logic or_1012_s22_q;
  logic or_1015_s22_q;
  logic or_1018_s22_q;
  logic [1:0] sum_1029_s22_q;
  logic [1:0] sum_1041_s22_q;
  logic and_1060_s22_q;
  logic sum_1095_s22_q;
  logic [9:0] difference_1096_s22_q;
  logic sum_1103_s22_q;
  logic [9:0] difference_1104_s22_q;
  logic difference_1175_s22_q;
  logic [8:0] xor_1176_s22_q;
  logic difference_1178_s22_q;
  logic [8:0] xor_1179_s22_q;
  logic difference_1182_s22_q;
  logic [8:0] xor_1183_s22_q;
  logic difference_1186_s22_q;
  logic [8:0] xor_1187_s22_q;
  logic difference_1190_s22_q;
  logic [8:0] xor_1191_s22_q;
  logic equal_1200_s22_q;
  logic difference_1220_s22_q;
  logic [8:0] xor_1221_s22_q;
  logic difference_1231_s22_q;
  logic [8:0] xor_1232_s22_q;
  logic equal_1252_s22_q;
  logic not_1298_s22_q;
  logic and_1385_s22_q;
  logic and_1390_s22_q;
  logic and_1395_s22_q;
  logic and_1400_s22_q;
  logic and_1405_s22_q;
  logic [8:0] select_1438_s22_q;
  logic [9:0] select_1476_s22_q;
  logic and_1481_s22_q;
  logic less_1483_s22_q;
  logic equal_1484_s22_q;
  logic equal_1485_s22_q;
  logic equal_1486_s22_q;
  logic [7:0] residual_s22_q;
  logic less_1605_s22_q;
  logic [1:0] select_1609_s22_q;
  logic not_1613_s22_q;
  logic less_1688_s22_q;
  logic [1:0] select_1692_s22_q;
  logic [1:0] select_1708_s22_q;
  logic and_1907_s22_q;
  logic and_1911_s22_q;
  logic equal_1921_s22_q;
  logic [10:0] sum_2025_s22_q;
  logic less_2029_s22_q;
  logic less_2040_s22_q;
  logic less_2052_s22_q;
  logic and_2201_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      sample_pair_whole_s22_q <= sample_pair_whole_s21_q;
      census_columns_values_0_cell_1_mask_s22_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s22_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s22_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s22_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s22_q <= x_s21_q;
      age_s22_q <= age_s21_q;
      lower_half_s22_q <= lower_half_s21_q;
      registration_counts_measured_0_s22_q <= registration_counts_measured_0_q;
      registration_counts_measured_1_s22_q <= registration_counts_measured_1_q;
      registration_counts_measured_2_s22_q <= registration_counts_measured_2_q;
      registration_counts_measured_3_s22_q <= registration_counts_measured_3_q;
      region_row_s22_q <= region_row_s21_q;
      region_fresh_s22_q <= region_fresh_s21_q;
      column_s22_q <= column_s21_q;
      and_352_s22_q <= and_352_s21_q;
      and_354_s22_q <= and_354_s21_q;
      equal_357_s22_q <= equal_357_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      equal_373_s22_q <= equal_373_s21_q;
      not_374_s22_q <= not_374_s21_q;
      equal_375_s22_q <= equal_375_s21_q;
      less_376_s22_q <= less_376_s21_q;
      not_377_s22_q <= not_377_s21_q;
      less_381_s22_q <= less_381;
      less_382_s22_q <= less_382;
      less_383_s22_q <= less_383;
      less_384_s22_q <= less_384;
      less_385_s22_q <= less_385;
      less_386_s22_q <= less_386;
      less_387_s22_q <= less_387;
      less_388_s22_q <= less_388;
      less_389_s22_q <= less_389;
      less_390_s22_q <= less_390;
      less_391_s22_q <= less_391;
      less_392_s22_q <= less_392;
      less_393_s22_q <= less_393;
      less_394_s22_q <= less_394;
      less_395_s22_q <= less_395;
      less_396_s22_q <= less_396;
      less_397_s22_q <= less_397;
      less_398_s22_q <= less_398;
      less_399_s22_q <= less_399;
      less_400_s22_q <= less_400;
      less_401_s22_q <= less_401;
      less_402_s22_q <= less_402;
      less_403_s22_q <= less_403;
      less_404_s22_q <= less_404;
      and_412_s22_q <= select_410[4] & select_411[3];
      and_416_s22_q <= and_416;
      difference_439_s22_q <= difference_439[9];
      xor_440_s22_q <= difference_439[8:0] ^ {9{difference_439[9]}};
      difference_442_s22_q <= difference_442[9];
      xor_443_s22_q <= difference_442[8:0] ^ {9{difference_442[9]}};
      difference_446_s22_q <= difference_446[9];
      xor_447_s22_q <= difference_446[8:0] ^ {9{difference_446[9]}};
      difference_450_s22_q <= difference_450[9];
      xor_451_s22_q <= difference_450[8:0] ^ {9{difference_450[9]}};
      difference_454_s22_q <= difference_454[9];
      xor_455_s22_q <= difference_454[8:0] ^ {9{difference_454[9]}};
      drew_s22_q <= drew_s21_q;
      x_s22_2_q <= x_s21_2_q;
      not_519_s22_q <= not_519_s21_q;
      best_left_rdata_s22_q <= best_left_rdata_s21_q;
      equal_524_s22_q <= equal_524_s21_q;
      select_820_s22_q <= select_820_s21_q;
      less_826_s22_q <= less_826_s21_q;
      less_827_s22_q <= less_827_s21_q;
      or_829_s22_q <= or_829_s21_q;
      select_833_s22_q <= select_833_s21_q;
      select_837_s22_q <= select_837_s21_q;
      equal_842_s22_q <= equal_842_s21_q;
      rise_s22_q <= rise_s21_q;
      sum_854_s22_q <= sum_854_s21_q;
      twice_s22_q <= twice_s21_q;
      select_865_s22_q <= select_865;
      and_886_s22_q <= and_886_s21_q;
      or_905_s22_q <= or_905_s21_q;
      or_908_s22_q <= or_908_s21_q;
      or_911_s22_q <= or_911_s21_q;
      equal_918_s22_q <= equal_918_s21_q;
      equal_919_s22_q <= equal_919_s21_q;
      regions_rdata_s22_q <= regions_rdata_q;
      and_929_s22_q <= and_929_s21_q;
      sum_932_s22_q <= {6'h0, textured} + select_931;
      sum_943_s22_q <= {6'h0, explained} + select_942;
      sum_954_s22_q <= {6'h0, and_952_s21_q} + select_953;
      and_959_s22_q <= and_959_s21_q;
      select_996_s22_q <= less_376_s21_q ? 6'h0 : seen_columns_rdata_s21_q[13:8];
      sum_999_s22_q <= sum_999;
      or_1012_s22_q <= or_1012_s21_q;
      or_1015_s22_q <= or_1015_s21_q;
      or_1018_s22_q <= or_1018_s21_q;
      sum_1029_s22_q <= sum_1029;
      sum_1041_s22_q <= {1'b0, select_997[5]} + ({1'b0, near} + {1'b0, select_997[2]});
      and_1060_s22_q <= and_1060_s21_q;
      sum_1095_s22_q <= sum_1095[0];
      difference_1096_s22_q <= {1'b0, sum_1095[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_1103_s22_q <= sum_1103[0];
      difference_1104_s22_q <= {1'b0, sum_1103[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_1175_s22_q <= difference_1175[9];
      xor_1176_s22_q <= difference_1175[8:0] ^ {9{difference_1175[9]}};
      difference_1178_s22_q <= difference_1178[9];
      xor_1179_s22_q <= difference_1178[8:0] ^ {9{difference_1178[9]}};
      difference_1182_s22_q <= difference_1182[9];
      xor_1183_s22_q <= difference_1182[8:0] ^ {9{difference_1182[9]}};
      difference_1186_s22_q <= difference_1186[9];
      xor_1187_s22_q <= difference_1186[8:0] ^ {9{difference_1186[9]}};
      difference_1190_s22_q <= difference_1190[9];
      xor_1191_s22_q <= difference_1190[8:0] ^ {9{difference_1190[9]}};
      equal_1200_s22_q <= equal_1200_s21_q;
      difference_1220_s22_q <= difference_1220[9];
      xor_1221_s22_q <= difference_1220[8:0] ^ {9{difference_1220[9]}};
      difference_1231_s22_q <= difference_1231[9];
      xor_1232_s22_q <= difference_1231[8:0] ^ {9{difference_1231[9]}};
      equal_1252_s22_q <= equal_1252_s21_q;
      not_1298_s22_q <= not_1298_s21_q;
      and_1385_s22_q <= and_1385;
      and_1390_s22_q <= and_1390_s21_q;
      and_1395_s22_q <= and_1395;
      and_1400_s22_q <= and_1400;
      and_1405_s22_q <= and_1405;
      select_1438_s22_q <= select_1438;
      select_1476_s22_q <= select_1476;
      and_1481_s22_q <= and_1481_s21_q;
      less_1483_s22_q <= less_1483_s21_q;
      equal_1484_s22_q <= equal_1484_s21_q;
      equal_1485_s22_q <= equal_1485_s21_q;
      equal_1486_s22_q <= equal_1486_s21_q;
      residual_s22_q <= residual_s21_q;
      less_1605_s22_q <= less_1605;
      select_1609_s22_q <= equal_375_s21_q ? 2'h0 : select_1608;
      not_1613_s22_q <= not_1613;
      less_1688_s22_q <= less_1688;
      select_1692_s22_q <= drew_s21_q ? select_1691 : 2'h0;
      select_1708_s22_q <= drew_s21_q ? select_1707 : 2'h0;
      and_1907_s22_q <= seen_columns_rdata_s21_q[4] & not_377_s21_q;
      and_1911_s22_q <= seen_columns_rdata_s21_q[5] & not_377_s21_q;
      equal_1921_s22_q <= equal_1921_s21_q;
      sum_2025_s22_q <= sum_2025[13:3];
      less_2029_s22_q <= 11'he < left[12:2];
      less_2040_s22_q <= 11'he < upper[12:2];
      less_2052_s22_q <= 11'he < lower[12:2];
      and_2201_s22_q <= and_2201_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
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
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  logic [13:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  // hls/stages/agreement.hpp:260
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_416_s22_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s22_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s22_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s22_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s22_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:190
  logic [9:0] sum_441;
  assign sum_441 = {9'h0, difference_439_s22_q} + {1'b0, xor_440_s22_q};
  logic [9:0] sum_444;
  assign sum_444 = {9'h0, difference_442_s22_q} + {1'b0, xor_443_s22_q};
  // hls/stages/agreement.hpp:575
  logic [11:0] sum_934;
  assign sum_934 = {5'h0, sum_932_s22_q} + (region_fresh_s22_q ? 12'h0 : regions_rdata_s22_q[11:0]);
  // hls/stages/agreement.hpp:576
  logic [11:0] sum_945;
  assign sum_945 = {5'h0, sum_943_s22_q} + (region_fresh_s22_q ? 12'h0 : regions_rdata_s22_q[23:12]);
  // hls/stages/agreement.hpp:577
  logic [11:0] sum_956;
  assign sum_956 = {5'h0, sum_954_s22_q} + (region_fresh_s22_q ? 12'h0 : regions_rdata_s22_q[35:24]);
  // hls/stages/agreement.hpp:734
  logic or_964;
  assign or_964 = marks_first_s22_q | line_ended_q;
  // hls/stages/agreement.hpp:736
  logic [13:0] select_966;
  assign select_966 = marks_first_s22_q ? 14'h1 : (or_964 ? {rows_passed_q[12:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:735
  logic [8:0] select_968;
  assign select_968 = or_964 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:743
  logic select_970;
  assign select_970 = cfg_compete_i ? (or_964 & select_966[13]) : (select_968[8] & select_966[9]);
  // hls/stages/agreement.hpp:600
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, select_996_s22_q[3]} + ({2'h0, select_996_s22_q[0]} + {1'b0, sum_999_s22_q});
  // hls/stages/agreement.hpp:601
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, select_996_s22_q[4]} + ({2'h0, select_996_s22_q[1]} + {1'b0, sum_1029_s22_q});
  // hls/stages/agreement.hpp:602
  logic [2:0] near_2;
  assign near_2 = {2'h0, select_996_s22_q[5]} + ({2'h0, select_996_s22_q[2]} + {1'b0, sum_1041_s22_q});
  // hls/stages/census.hpp:129
  logic [9:0] xor_1097;
  assign xor_1097 = {difference_1096_s22_q[8:0], sum_1095_s22_q} ^ {10{difference_1096_s22_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1096_s22_q[9]} + {1'b0, xor_1097};
  logic [9:0] xor_1105;
  assign xor_1105 = {difference_1104_s22_q[8:0], sum_1103_s22_q} ^ {10{difference_1104_s22_q[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1104_s22_q[9]} + {1'b0, xor_1105};
  // hls/stages/agreement.hpp:184
  logic select_1120;
  assign select_1120 = and_354_s22_q ? whole_2_s22_q : census_columns_values_0_cell_0_mask_q;
  logic select_1136;
  assign select_1136 = and_354_s22_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_1139;
  assign select_1139 = and_354_s22_q ? census_columns_values_0_cell_1_mask_s22_q : census_columns_values_1_cell_1_mask_q;
  logic select_1142;
  assign select_1142 = and_354_s22_q ? census_columns_values_0_cell_2_mask_s22_q : census_columns_values_1_cell_2_mask_q;
  logic select_1146;
  assign select_1146 = and_354_s22_q ? census_columns_values_0_cell_3_mask_s22_q : census_columns_values_1_cell_3_mask_q;
  logic select_1149;
  assign select_1149 = and_354_s22_q ? census_columns_values_0_cell_4_mask_s22_q : census_columns_values_1_cell_4_mask_q;
  logic select_1152;
  assign select_1152 = and_354_s22_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_1155;
  assign select_1155 = and_354_s22_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] sum_1177;
  assign sum_1177 = {9'h0, difference_1175_s22_q} + {1'b0, xor_1176_s22_q};
  logic [9:0] sum_1180;
  assign sum_1180 = {9'h0, difference_1178_s22_q} + {1'b0, xor_1179_s22_q};
  // hls/stages/census.hpp:273
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1220_s22_q} + xor_1221_s22_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1231_s22_q} + xor_1232_s22_q;
  // hls/stages/agreement.hpp:643
  logic less_1418;
  assign less_1418 = region_row_s22_q < x_s22_q[5:3];
  logic [11:0] select_1422;
  assign select_1422 = less_1418 ? 12'h0 : regions_rdata_s22_q[23:12];
  // hls/stages/agreement.hpp:503
  logic [23:0] sum_1439;
  assign sum_1439 = counts_too_little_explained_q + {{15{select_1438_s22_q[8]}}, select_1438_s22_q};
  // hls/stages/agreement.hpp:317
  logic [9:0] select_1477;
  assign select_1477 = equal_373_s22_q ? 10'h0 : select_1476_s22_q;
  // hls/stages/agreement.hpp:508
  logic [23:0] select_1479;
  assign select_1479 = and_1385_s22_q ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1477[9]}}, select_1477});
  // hls/stages/registration.hpp:146
  logic less_1596;
  assign less_1596 = $signed(residual_s22_q) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1610;
  assign select_1610 = equal_373_s22_q ? 2'h0 : select_1609_s22_q;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1611;
  assign sum_1611 = registration_counts_votes_0_up_q + {{13{select_1610[1]}}, select_1610};
  // hls/stages/registration.hpp:80
  logic not_1646;
  assign not_1646 = ~lower_half_s22_q;
  // hls/stages/agreement.hpp:170
  logic and_1647;
  assign and_1647 = less_1596 & not_1646;
  logic [1:0] select_1649;
  assign select_1649 = less_376_s22_q ? 2'h0 : (and_1481_s22_q ? {and_1647, not_1646} : 2'h0);
  logic and_1655;
  assign and_1655 = less_1605_s22_q & not_1646;
  logic [1:0] select_1657;
  assign select_1657 = less_376_s22_q ? 2'h0 : (and_1481_s22_q ? {and_1655, not_1646} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1660;
  assign select_1660 = equal_373_s22_q ? 2'h0 : (equal_375_s22_q ? 2'h0 : (drew_s22_q ? select_1657 : 2'h0));
  // hls/stages/agreement.hpp:170
  logic and_1663;
  assign and_1663 = lower_half_s22_q & less_1596;
  logic [1:0] select_1665;
  assign select_1665 = less_376_s22_q ? 2'h0 : (and_1481_s22_q ? {and_1663, lower_half_s22_q} : 2'h0);
  logic and_1671;
  assign and_1671 = lower_half_s22_q & less_1605_s22_q;
  logic [1:0] select_1673;
  assign select_1673 = less_376_s22_q ? 2'h0 : (and_1481_s22_q ? {and_1671, lower_half_s22_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1676;
  assign select_1676 = equal_373_s22_q ? 2'h0 : (equal_375_s22_q ? 2'h0 : (drew_s22_q ? select_1673 : 2'h0));
  logic [1:0] select_1694;
  assign select_1694 = equal_373_s22_q ? 2'h0 : (equal_375_s22_q ? 2'h0 : select_1692_s22_q);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1695;
  assign sum_1695 = registration_counts_half_votes_0_up_q + {{13{select_1694[1]}}, select_1694};
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1710;
  assign select_1710 = equal_373_s22_q ? 2'h0 : (equal_375_s22_q ? 2'h0 : select_1708_s22_q);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1711;
  assign sum_1711 = registration_counts_half_votes_1_up_q + {{13{select_1710[1]}}, select_1710};
  // hls/stages/agreement.hpp:170
  logic and_1721;
  assign and_1721 = less_1688_s22_q & not_1646;
  logic [1:0] select_1723;
  assign select_1723 = less_376_s22_q ? 2'h0 : (and_1481_s22_q ? {and_1721, not_1646} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1726;
  assign select_1726 = equal_373_s22_q ? 2'h0 : (equal_375_s22_q ? 2'h0 : (drew_s22_q ? select_1723 : 2'h0));
  // hls/stages/agreement.hpp:170
  logic and_1737;
  assign and_1737 = lower_half_s22_q & less_1688_s22_q;
  logic [1:0] select_1739;
  assign select_1739 = less_376_s22_q ? 2'h0 : (and_1481_s22_q ? {and_1737, lower_half_s22_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1742;
  assign select_1742 = equal_373_s22_q ? 2'h0 : (equal_375_s22_q ? 2'h0 : (drew_s22_q ? select_1739 : 2'h0));
  logic select_1909;
  assign select_1909 = equal_375_s22_q ? centres_values_0_textured_q : (drew_s22_q ? and_1907_s22_q : centres_values_0_textured_q);
  logic select_1913;
  assign select_1913 = equal_375_s22_q ? centres_values_0_of_skin_q : (drew_s22_q ? and_1911_s22_q : centres_values_0_of_skin_q);
  logic select_1915;
  assign select_1915 = drew_s22_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_1917;
  assign select_1917 = equal_373_s22_q ? centres_values_1_textured_q : (equal_375_s22_q ? centres_values_1_textured_q : select_1915);
  logic select_1918;
  assign select_1918 = drew_s22_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_1920;
  assign select_1920 = equal_373_s22_q ? centres_values_1_of_skin_q : (equal_375_s22_q ? centres_values_1_of_skin_q : select_1918);
  // hls/stages/registration.hpp:119
  logic less_2031;
  assign less_2031 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_2032;
  assign or_2032 = (~less_2029_s22_q) | less_2031;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_s22_q} + {1'b0, registration_counts_measured_3_s22_q};
  // hls/stages/registration.hpp:119
  logic less_2036;
  assign less_2036 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/agreement.hpp:654
  logic [11:0] select_2218;
  assign select_2218 = equal_919_s22_q ? 12'h0 : (less_1418 ? 12'h0 : regions_rdata_s22_q[35:24]);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_too_little_explained_q <= 24'h0;
      counts_too_much_hidden_q <= 24'h0;
      registration_counts_votes_0_up_q <= 15'h0;
      registration_counts_half_votes_0_up_q <= 15'h0;
      registration_counts_half_votes_1_up_q <= 15'h0;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
      rows_passed_q <= 14'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s22_en) begin
      counts_too_little_explained_q <= and_1385_s22_q ? 24'h0 : sum_1439;
      counts_too_much_hidden_q <= select_1479;
      registration_counts_votes_0_up_q <= and_1385_s22_q ? 15'h0 : sum_1611;
      registration_counts_half_votes_0_up_q <= and_1385_s22_q ? 15'h0 : sum_1695;
      registration_counts_half_votes_1_up_q <= and_1385_s22_q ? 15'h0 : sum_1711;
      centres_values_0_textured_q <= equal_373_s22_q ? centres_values_0_textured_q : select_1909;
      centres_values_0_of_skin_q <= equal_373_s22_q ? centres_values_0_of_skin_q : select_1913;
      centres_values_1_textured_q <= select_1917;
      centres_values_1_of_skin_q <= select_1920;
      rows_passed_q <= select_966;
      columns_passed_q <= {select_968[7:0], or_964};
      line_ended_q <= marks_last_s22_q;
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
    if (s22_en) begin
      census_columns_values_0_cell_0_mask_q <= select_1120;
      census_columns_values_1_cell_0_mask_q <= select_1136;
      census_columns_values_1_cell_1_mask_q <= select_1139;
      census_columns_values_1_cell_2_mask_q <= select_1142;
      census_columns_values_1_cell_3_mask_q <= select_1146;
      census_columns_values_1_cell_4_mask_q <= select_1149;
      census_columns_values_2_cell_0_mask_q <= select_1152;
      census_columns_values_2_cell_1_mask_q <= select_1155;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic sample_pair_whole_s23_q;
  logic census_columns_values_1_cell_2_mask_s23_q;
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic census_columns_values_1_cell_3_mask_s23_q;
  logic census_columns_values_1_cell_4_mask_s23_q;
  logic census_columns_values_2_cell_0_mask_s23_q;
  logic census_columns_values_2_cell_1_mask_s23_q;
  logic [7:0] x_s23_q;
  logic age_s23_q;
  logic lower_half_s23_q;
  logic [11:0] registration_counts_measured_0_s23_q;
  logic [11:0] registration_counts_measured_1_s23_q;
  logic [11:0] registration_counts_measured_2_s23_q;
  logic [11:0] registration_counts_measured_3_s23_q;
  logic [2:0] region_row_s23_q;
  logic centres_values_1_textured_s23_q;
  logic centres_values_1_of_skin_s23_q;
  logic [6:0] column_s23_q;
  logic and_352_s23_q;
  logic and_354_s23_q;
  logic equal_357_s23_q;
  logic whole_2_s23_q;
  logic equal_373_s23_q;
  logic not_374_s23_q;
  logic equal_375_s23_q;
  logic less_376_s23_q;
  logic not_377_s23_q;
  logic less_381_s23_q;
  logic less_382_s23_q;
  logic less_383_s23_q;
  logic less_384_s23_q;
  logic less_385_s23_q;
  logic less_386_s23_q;
  logic less_387_s23_q;
  logic less_388_s23_q;
  logic less_389_s23_q;
  logic less_390_s23_q;
  logic less_391_s23_q;
  logic less_392_s23_q;
  logic less_393_s23_q;
  logic less_394_s23_q;
  logic less_395_s23_q;
  logic less_396_s23_q;
  logic less_397_s23_q;
  logic less_398_s23_q;
  logic less_399_s23_q;
  logic less_400_s23_q;
  logic less_401_s23_q;
  logic less_402_s23_q;
  logic less_403_s23_q;
  logic less_404_s23_q;
  logic and_412_s23_q;
  logic whole_9_s23_q;
  logic [10:0] sum_445_s23_q;
  logic [9:0] sum_448_s23_q;
  logic [9:0] sum_452_s23_q;
  logic [9:0] sum_456_s23_q;
  logic drew_s23_q;
  logic [6:0] x_s23_2_q;
  logic not_519_s23_q;
  logic [7:0] best_left_rdata_s23_q;
  logic equal_524_s23_q;
  logic select_820_s23_q;
  logic less_826_s23_q;
  logic less_827_s23_q;
  logic or_829_s23_q;
  logic [7:0] select_833_s23_q;
  logic [5:0] select_837_s23_q;
  logic equal_842_s23_q;
  logic rise_s23_q;
  logic [1:0] sum_854_s23_q;
  logic [7:0] twice_s23_q;
  logic [8:0] difference_866_s23_q;
  logic and_886_s23_q;
  logic or_905_s23_q;
  logic or_908_s23_q;
  logic or_911_s23_q;
  logic equal_918_s23_q;
  logic equal_919_s23_q;
  logic and_929_s23_q;
  logic [11:0] sum_934_s23_q;
  logic [11:0] sum_945_s23_q;
  logic [11:0] sum_956_s23_q;
  logic and_959_s23_q;
  logic select_970_s23_q;
  logic [2:0] textured_2_s23_q;
  logic or_1012_s23_q;
  logic or_1015_s23_q;
  logic or_1018_s23_q;
  logic [2:0] explained_2_s23_q;
  logic [2:0] near_2_s23_q;
  logic and_1060_s23_q;
  logic [10:0] size_2_s23_q;
  logic [10:0] size_3_s23_q;
  logic [10:0] sum_1181_s23_q;
  logic [9:0] sum_1184_s23_q;
  logic [9:0] sum_1188_s23_q;
  logic [9:0] sum_1192_s23_q;
  logic equal_1200_s23_q;
  logic [8:0] contrast_s23_q;
  logic [8:0] contrast_2_s23_q;
  logic equal_1252_s23_q;
  logic not_1298_s23_q;
  logic and_1385_s23_q;
  logic and_1390_s23_q;
  logic and_1395_s23_q;
  logic and_1400_s23_q;
  logic and_1405_s23_q;
  logic [11:0] select_1419_s23_q;
  logic [11:0] select_1422_s23_q;
  logic and_1481_s23_q;
  logic less_1483_s23_q;
  logic equal_1484_s23_q;
  logic equal_1485_s23_q;
  logic equal_1486_s23_q;
  logic [7:0] residual_s23_q;
  logic less_1596_s23_q;
  logic less_1605_s23_q;
  logic not_1613_s23_q;
  logic not_1646_s23_q;
  logic [1:0] select_1650_s23_q;
  logic [1:0] select_1660_s23_q;
  logic [1:0] select_1666_s23_q;
  logic [1:0] select_1676_s23_q;
  logic [1:0] select_1726_s23_q;
  logic [1:0] select_1742_s23_q;
  logic less_1809_s23_q;
  logic [12:0] sum_1812_s23_q;
  logic less_1826_s23_q;
  logic equal_1921_s23_q;
  logic less_2026_s23_q;
  logic less_2029_s23_q;
  logic or_2032_s23_q;
  logic less_2034_s23_q;
  logic less_2036_s23_q;
  logic select_2037_s23_q;
  logic less_2040_s23_q;
  logic less_2042_s23_q;
  logic less_2052_s23_q;
  logic and_2201_s23_q;
  logic [11:0] select_2220_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      sample_pair_whole_s23_q <= sample_pair_whole_s22_q;
      census_columns_values_1_cell_2_mask_s23_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_s22_q;
      census_columns_values_1_cell_3_mask_s23_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s23_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s23_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s23_q <= census_columns_values_2_cell_1_mask_q;
      x_s23_q <= x_s22_q;
      age_s23_q <= age_s22_q;
      lower_half_s23_q <= lower_half_s22_q;
      registration_counts_measured_0_s23_q <= registration_counts_measured_0_s22_q;
      registration_counts_measured_1_s23_q <= registration_counts_measured_1_s22_q;
      registration_counts_measured_2_s23_q <= registration_counts_measured_2_s22_q;
      registration_counts_measured_3_s23_q <= registration_counts_measured_3_s22_q;
      region_row_s23_q <= region_row_s22_q;
      centres_values_1_textured_s23_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_q;
      column_s23_q <= column_s22_q;
      and_352_s23_q <= and_352_s22_q;
      and_354_s23_q <= and_354_s22_q;
      equal_357_s23_q <= equal_357_s22_q;
      whole_2_s23_q <= whole_2_s22_q;
      equal_373_s23_q <= equal_373_s22_q;
      not_374_s23_q <= not_374_s22_q;
      equal_375_s23_q <= equal_375_s22_q;
      less_376_s23_q <= less_376_s22_q;
      not_377_s23_q <= not_377_s22_q;
      less_381_s23_q <= less_381_s22_q;
      less_382_s23_q <= less_382_s22_q;
      less_383_s23_q <= less_383_s22_q;
      less_384_s23_q <= less_384_s22_q;
      less_385_s23_q <= less_385_s22_q;
      less_386_s23_q <= less_386_s22_q;
      less_387_s23_q <= less_387_s22_q;
      less_388_s23_q <= less_388_s22_q;
      less_389_s23_q <= less_389_s22_q;
      less_390_s23_q <= less_390_s22_q;
      less_391_s23_q <= less_391_s22_q;
      less_392_s23_q <= less_392_s22_q;
      less_393_s23_q <= less_393_s22_q;
      less_394_s23_q <= less_394_s22_q;
      less_395_s23_q <= less_395_s22_q;
      less_396_s23_q <= less_396_s22_q;
      less_397_s23_q <= less_397_s22_q;
      less_398_s23_q <= less_398_s22_q;
      less_399_s23_q <= less_399_s22_q;
      less_400_s23_q <= less_400_s22_q;
      less_401_s23_q <= less_401_s22_q;
      less_402_s23_q <= less_402_s22_q;
      less_403_s23_q <= less_403_s22_q;
      less_404_s23_q <= less_404_s22_q;
      and_412_s23_q <= and_412_s22_q;
      whole_9_s23_q <= whole_9;
      sum_445_s23_q <= {1'b0, sum_441} + {1'b0, sum_444};
      sum_448_s23_q <= {9'h0, difference_446_s22_q} + {1'b0, xor_447_s22_q};
      sum_452_s23_q <= {9'h0, difference_450_s22_q} + {1'b0, xor_451_s22_q};
      sum_456_s23_q <= {9'h0, difference_454_s22_q} + {1'b0, xor_455_s22_q};
      drew_s23_q <= drew_s22_q;
      x_s23_2_q <= x_s22_2_q;
      not_519_s23_q <= not_519_s22_q;
      best_left_rdata_s23_q <= best_left_rdata_s22_q;
      equal_524_s23_q <= equal_524_s22_q;
      select_820_s23_q <= select_820_s22_q;
      less_826_s23_q <= less_826_s22_q;
      less_827_s23_q <= less_827_s22_q;
      or_829_s23_q <= or_829_s22_q;
      select_833_s23_q <= select_833_s22_q;
      select_837_s23_q <= select_837_s22_q;
      equal_842_s23_q <= equal_842_s22_q;
      rise_s23_q <= rise_s22_q;
      sum_854_s23_q <= sum_854_s22_q;
      twice_s23_q <= twice_s22_q;
      difference_866_s23_q <= {1'b0, twice_s22_q} - select_865_s22_q;
      and_886_s23_q <= and_886_s22_q;
      or_905_s23_q <= or_905_s22_q;
      or_908_s23_q <= or_908_s22_q;
      or_911_s23_q <= or_911_s22_q;
      equal_918_s23_q <= equal_918_s22_q;
      equal_919_s23_q <= equal_919_s22_q;
      and_929_s23_q <= and_929_s22_q;
      sum_934_s23_q <= sum_934;
      sum_945_s23_q <= sum_945;
      sum_956_s23_q <= sum_956;
      and_959_s23_q <= and_959_s22_q;
      select_970_s23_q <= select_970;
      textured_2_s23_q <= textured_2;
      or_1012_s23_q <= or_1012_s22_q;
      or_1015_s23_q <= or_1015_s22_q;
      or_1018_s23_q <= or_1018_s22_q;
      explained_2_s23_q <= explained_2;
      near_2_s23_q <= near_2;
      and_1060_s23_q <= and_1060_s22_q;
      size_2_s23_q <= size_2;
      size_3_s23_q <= size_3;
      sum_1181_s23_q <= {1'b0, sum_1177} + {1'b0, sum_1180};
      sum_1184_s23_q <= {9'h0, difference_1182_s22_q} + {1'b0, xor_1183_s22_q};
      sum_1188_s23_q <= {9'h0, difference_1186_s22_q} + {1'b0, xor_1187_s22_q};
      sum_1192_s23_q <= {9'h0, difference_1190_s22_q} + {1'b0, xor_1191_s22_q};
      equal_1200_s23_q <= equal_1200_s22_q;
      contrast_s23_q <= contrast;
      contrast_2_s23_q <= contrast_2;
      equal_1252_s23_q <= equal_1252_s22_q;
      not_1298_s23_q <= not_1298_s22_q;
      and_1385_s23_q <= and_1385_s22_q;
      and_1390_s23_q <= and_1390_s22_q;
      and_1395_s23_q <= and_1395_s22_q;
      and_1400_s23_q <= and_1400_s22_q;
      and_1405_s23_q <= and_1405_s22_q;
      select_1419_s23_q <= less_1418 ? 12'h0 : regions_rdata_s22_q[11:0];
      select_1422_s23_q <= select_1422;
      and_1481_s23_q <= and_1481_s22_q;
      less_1483_s23_q <= less_1483_s22_q;
      equal_1484_s23_q <= equal_1484_s22_q;
      equal_1485_s23_q <= equal_1485_s22_q;
      equal_1486_s23_q <= equal_1486_s22_q;
      residual_s23_q <= residual_s22_q;
      less_1596_s23_q <= less_1596;
      less_1605_s23_q <= less_1605_s22_q;
      not_1613_s23_q <= not_1613_s22_q;
      not_1646_s23_q <= not_1646;
      select_1650_s23_q <= drew_s22_q ? select_1649 : 2'h0;
      select_1660_s23_q <= select_1660;
      select_1666_s23_q <= drew_s22_q ? select_1665 : 2'h0;
      select_1676_s23_q <= select_1676;
      select_1726_s23_q <= select_1726;
      select_1742_s23_q <= select_1742;
      less_1809_s23_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      sum_1812_s23_q <= {1'b0, select_1422} + {2'h0, select_1422[11:1]};
      less_1826_s23_q <= $signed(24'h0) < $signed(counts_too_much_hidden_q);
      equal_1921_s23_q <= equal_1921_s22_q;
      less_2026_s23_q <= 11'h4 < sum_2025_s22_q;
      less_2029_s23_q <= less_2029_s22_q;
      or_2032_s23_q <= or_2032;
      less_2034_s23_q <= 11'he < right[12:2];
      less_2036_s23_q <= less_2036;
      select_2037_s23_q <= or_2032 ? less_2031 : less_2036;
      less_2040_s23_q <= less_2040_s22_q;
      less_2042_s23_q <= $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
      less_2052_s23_q <= less_2052_s22_q;
      and_2201_s23_q <= and_2201_s22_q;
      select_2220_s23_q <= drew_s22_q ? 12'h0 : (equal_918_s22_q ? select_2218 : 12'h0);
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:260
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_s23_q & whole_9_s23_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s23_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s23_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s23_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s23_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:190
  logic [10:0] sum_449;
  assign sum_449 = sum_445_s23_q + {1'b0, sum_448_s23_q};
  // hls/stages/registration.hpp:28
  logic not_867;
  assign not_867 = ~difference_866_s23_q[8];
  logic [7:0] xor_868;
  assign xor_868 = twice_s23_q ^ {8{not_867}};
  logic [9:0] sum_869;
  assign sum_869 = {difference_866_s23_q[7:0], 1'b0, not_867} + {not_867, xor_868, not_867};
  // hls/stages/agreement.hpp:185
  logic next_row;
  assign next_row = select_970_s23_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:750
  logic [6:0] select_973;
  assign select_973 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:760
  logic equal_976;
  assign equal_976 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:733
  logic not_983;
  assign not_983 = ~marks_first_s23_q;
  // hls/stages/agreement.hpp:606
  logic [4:0] difference_1003;
  assign difference_1003 = {2'h0, textured_2_s23_q} - (age_s23_q ? box_textured_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:607
  logic [4:0] difference_1033;
  assign difference_1033 = {2'h0, explained_2_s23_q} - (age_s23_q ? box_explained_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:608
  logic [4:0] difference_1045;
  assign difference_1045 = {2'h0, near_2_s23_q} - (age_s23_q ? box_nearer_columns_values_4_q : 5'h0);
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2_s23_q} + (equal_357_s23_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:183
  logic [13:0] select_1102;
  assign select_1102 = sample_pair_whole_s23_q ? (and_352_s23_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3_s23_q} + (equal_357_s23_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:183
  logic [13:0] select_1110;
  assign select_1110 = sample_pair_whole_s23_q ? (and_352_s23_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:184
  logic select_1158;
  assign select_1158 = and_354_s23_q ? census_columns_values_1_cell_2_mask_s23_q : census_columns_values_2_cell_2_mask_q;
  logic select_1161;
  assign select_1161 = and_354_s23_q ? census_columns_values_1_cell_3_mask_s23_q : census_columns_values_2_cell_3_mask_q;
  logic select_1164;
  assign select_1164 = and_354_s23_q ? census_columns_values_1_cell_4_mask_s23_q : census_columns_values_2_cell_4_mask_q;
  logic select_1165;
  assign select_1165 = and_354_s23_q ? census_columns_values_2_cell_0_mask_s23_q : census_columns_values_3_cell_0_mask_q;
  logic select_1168;
  assign select_1168 = and_354_s23_q ? census_columns_values_2_cell_1_mask_s23_q : census_columns_values_3_cell_1_mask_q;
  logic select_1169;
  assign select_1169 = and_354_s23_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_1172;
  assign select_1172 = and_354_s23_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:192
  logic [10:0] sum_1185;
  assign sum_1185 = sum_1181_s23_q + {1'b0, sum_1184_s23_q};
  // hls/stages/agreement.hpp:508
  logic [13:0] select_1392;
  assign select_1392 = and_1385_s23_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1390_s23_q});
  logic [13:0] select_1397;
  assign select_1397 = and_1385_s23_q ? 14'h0 : (counts_textured_q + {13'h0, and_1395_s23_q});
  // hls/stages/registration.hpp:79
  logic and_1622;
  assign and_1622 = less_1605_s23_q & not_1613_s23_q;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1624;
  assign select_1624 = less_376_s23_q ? 2'h0 : (and_1481_s23_q ? {and_1622, not_1613_s23_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1627;
  assign select_1627 = equal_373_s23_q ? 2'h0 : (equal_375_s23_q ? 2'h0 : (drew_s23_q ? select_1624 : 2'h0));
  // hls/stages/registration.hpp:79
  logic and_1630;
  assign and_1630 = less_1483_s23_q & less_1596_s23_q;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1632;
  assign select_1632 = less_376_s23_q ? 2'h0 : (and_1481_s23_q ? {and_1630, less_1483_s23_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1635;
  assign select_1635 = equal_373_s23_q ? 2'h0 : (equal_375_s23_q ? 2'h0 : (drew_s23_q ? select_1632 : 2'h0));
  // hls/stages/registration.hpp:79
  logic and_1638;
  assign and_1638 = less_1483_s23_q & less_1605_s23_q;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1640;
  assign select_1640 = less_376_s23_q ? 2'h0 : (and_1481_s23_q ? {and_1638, less_1483_s23_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1643;
  assign select_1643 = equal_373_s23_q ? 2'h0 : (equal_375_s23_q ? 2'h0 : (drew_s23_q ? select_1640 : 2'h0));
  logic [1:0] select_1652;
  assign select_1652 = equal_373_s23_q ? 2'h0 : (equal_375_s23_q ? 2'h0 : select_1650_s23_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1653;
  assign sum_1653 = registration_counts_votes_3_down_q + {{13{select_1652[1]}}, select_1652};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1661;
  assign sum_1661 = registration_counts_votes_3_up_q + {{13{select_1660_s23_q[1]}}, select_1660_s23_q};
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1668;
  assign select_1668 = equal_373_s23_q ? 2'h0 : (equal_375_s23_q ? 2'h0 : select_1666_s23_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1669;
  assign sum_1669 = registration_counts_votes_4_down_q + {{13{select_1668[1]}}, select_1668};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1677;
  assign sum_1677 = registration_counts_votes_4_up_q + {{13{select_1676_s23_q[1]}}, select_1676_s23_q};
  logic [14:0] sum_1727;
  assign sum_1727 = registration_counts_half_votes_2_up_q + {{13{select_1726_s23_q[1]}}, select_1726_s23_q};
  logic [14:0] sum_1743;
  assign sum_1743 = registration_counts_half_votes_3_up_q + {{13{select_1742_s23_q[1]}}, select_1742_s23_q};
  // hls/stages/agreement.hpp:639
  logic and_1808;
  assign and_1808 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:646
  logic less_1813;
  assign less_1813 = {sum_1812_s23_q, select_1422_s23_q[0]} < {2'h0, select_1419_s23_q};
  logic select_1815;
  assign select_1815 = (select_1419_s23_q[11:3] == 9'h0) ? (and_1808 & (~less_1809_s23_q)) : (~less_1813);
  // hls/stages/agreement.hpp:317
  logic [4:0] select_1853;
  assign select_1853 = drew_s23_q ? {2'h0, textured_2_s23_q} : box_textured_columns_values_0_q;
  logic [4:0] select_1855;
  assign select_1855 = equal_373_s23_q ? box_textured_columns_values_0_q : (equal_375_s23_q ? box_textured_columns_values_0_q : select_1853);
  logic [4:0] select_1856;
  assign select_1856 = drew_s23_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1858;
  assign select_1858 = equal_373_s23_q ? box_textured_columns_values_1_q : (equal_375_s23_q ? box_textured_columns_values_1_q : select_1856);
  logic [4:0] select_1859;
  assign select_1859 = drew_s23_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1861;
  assign select_1861 = equal_373_s23_q ? box_textured_columns_values_2_q : (equal_375_s23_q ? box_textured_columns_values_2_q : select_1859);
  logic [4:0] select_1862;
  assign select_1862 = drew_s23_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1864;
  assign select_1864 = equal_373_s23_q ? box_textured_columns_values_3_q : (equal_375_s23_q ? box_textured_columns_values_3_q : select_1862);
  logic [4:0] select_1865;
  assign select_1865 = drew_s23_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1867;
  assign select_1867 = equal_373_s23_q ? box_textured_columns_values_4_q : (equal_375_s23_q ? box_textured_columns_values_4_q : select_1865);
  logic [4:0] select_1871;
  assign select_1871 = drew_s23_q ? {2'h0, explained_2_s23_q} : box_explained_columns_values_0_q;
  logic [4:0] select_1873;
  assign select_1873 = equal_373_s23_q ? box_explained_columns_values_0_q : (equal_375_s23_q ? box_explained_columns_values_0_q : select_1871);
  logic [4:0] select_1874;
  assign select_1874 = drew_s23_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1876;
  assign select_1876 = equal_373_s23_q ? box_explained_columns_values_1_q : (equal_375_s23_q ? box_explained_columns_values_1_q : select_1874);
  logic [4:0] select_1877;
  assign select_1877 = drew_s23_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1879;
  assign select_1879 = equal_373_s23_q ? box_explained_columns_values_2_q : (equal_375_s23_q ? box_explained_columns_values_2_q : select_1877);
  logic [4:0] select_1880;
  assign select_1880 = drew_s23_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1882;
  assign select_1882 = equal_373_s23_q ? box_explained_columns_values_3_q : (equal_375_s23_q ? box_explained_columns_values_3_q : select_1880);
  logic [4:0] select_1883;
  assign select_1883 = drew_s23_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1885;
  assign select_1885 = equal_373_s23_q ? box_explained_columns_values_4_q : (equal_375_s23_q ? box_explained_columns_values_4_q : select_1883);
  logic [4:0] select_1889;
  assign select_1889 = drew_s23_q ? {2'h0, near_2_s23_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_1891;
  assign select_1891 = equal_373_s23_q ? box_nearer_columns_values_0_q : (equal_375_s23_q ? box_nearer_columns_values_0_q : select_1889);
  logic [4:0] select_1892;
  assign select_1892 = drew_s23_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1894;
  assign select_1894 = equal_373_s23_q ? box_nearer_columns_values_1_q : (equal_375_s23_q ? box_nearer_columns_values_1_q : select_1892);
  logic [4:0] select_1895;
  assign select_1895 = drew_s23_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1897;
  assign select_1897 = equal_373_s23_q ? box_nearer_columns_values_2_q : (equal_375_s23_q ? box_nearer_columns_values_2_q : select_1895);
  logic [4:0] select_1898;
  assign select_1898 = drew_s23_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1900;
  assign select_1900 = equal_373_s23_q ? box_nearer_columns_values_3_q : (equal_375_s23_q ? box_nearer_columns_values_3_q : select_1898);
  logic [4:0] select_1901;
  assign select_1901 = drew_s23_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_1903;
  assign select_1903 = equal_373_s23_q ? box_nearer_columns_values_4_q : (equal_375_s23_q ? box_nearer_columns_values_4_q : select_1901);
  // hls/stages/agreement.hpp:759
  logic [3:0] select_1941;
  assign select_1941 = select_970_s23_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:185
  logic [7:0] select_1947;
  assign select_1947 = marks_first_s23_q ? (less_1943 ? {sum_1944, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:104
  logic select_2038;
  assign select_2038 = less_2026_s23_q ? select_2037_s23_q : less_2036_s23_q;
  logic or_2039;
  assign or_2039 = (~less_2034_s23_q) | select_2038;
  logic select_2043;
  assign select_2043 = or_2039 ? select_2038 : less_2042_s23_q;
  logic select_2045;
  assign select_2045 = less_2026_s23_q ? select_2043 : (less_2029_s23_q ? select_2043 : less_2042_s23_q);
  // hls/stages/agreement.hpp:658
  logic and_2071;
  assign and_2071 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2072;
  assign or_2072 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2071;
  logic select_2073;
  assign select_2073 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2072 : and_2071;
  // hls/stages/agreement.hpp:317
  logic [11:0] select_2222;
  assign select_2222 = equal_373_s23_q ? 12'h0 : (equal_375_s23_q ? 12'h0 : select_2220_s23_q);

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s23_q, or_911_s23_q, or_908_s23_q, or_905_s23_q};
  logic regions_we;
  assign regions_we = s23_en & and_959_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_956_s23_q, sum_945_s23_q, sum_934_s23_q};
  end
`ifndef SYNTHESIS
  logic [5:0] regions_raddr_s21_sim;
  logic regions_re_s21_sim;
  logic [5:0] regions_raddr_s22_sim;
  logic regions_re_s22_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      regions_re_s21_sim <= 1'b0;
      regions_re_s22_sim <= 1'b0;
    end else if (en_i) begin
      regions_re_s21_sim <= regions_re;
      regions_raddr_s21_sim <= regions_raddr;
      regions_re_s22_sim <= regions_re_s21_sim;
      regions_raddr_s22_sim <= regions_raddr_s21_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s21_sim && regions_raddr_s21_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s22_sim && regions_raddr_s22_sim == regions_waddr) begin
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
    end else if (s23_en) begin
      counts_supervised_q <= select_1392;
      counts_textured_q <= select_1397;
      registration_counts_votes_3_down_q <= and_1385_s23_q ? 15'h0 : sum_1653;
      registration_counts_votes_3_up_q <= and_1385_s23_q ? 15'h0 : sum_1661;
      registration_counts_votes_4_down_q <= and_1385_s23_q ? 15'h0 : sum_1669;
      registration_counts_votes_4_up_q <= and_1385_s23_q ? 15'h0 : sum_1677;
      registration_counts_half_votes_2_up_q <= and_1385_s23_q ? 15'h0 : sum_1727;
      registration_counts_half_votes_3_up_q <= and_1385_s23_q ? 15'h0 : sum_1743;
      began_q <= not_983 & (began_q | select_970_s23_q);
      seen_x_q <= select_970_s23_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s23_q ? 4'h0 : select_1941;
      seen_column_q <= select_970_s23_q ? 8'h0 : (seen_column_q + {7'h0, equal_976});
      seen_rows_left_q <= select_1947;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s23_q ? 13'h0 : (seen_base_q + {6'h0, select_973});
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
    if (s23_en) begin
      averager_detail_0_q <= select_1102;
      averager_detail_1_q <= select_1110;
      census_columns_values_2_cell_2_mask_q <= select_1158;
      census_columns_values_2_cell_3_mask_q <= select_1161;
      census_columns_values_2_cell_4_mask_q <= select_1164;
      census_columns_values_3_cell_0_mask_q <= select_1165;
      census_columns_values_3_cell_1_mask_q <= select_1168;
      census_columns_values_3_cell_2_mask_q <= select_1169;
      census_columns_values_3_cell_3_mask_q <= select_1172;
      box_textured_columns_values_0_q <= select_1855;
      box_textured_columns_values_1_q <= select_1858;
      box_textured_columns_values_2_q <= select_1861;
      box_textured_columns_values_3_q <= select_1864;
      box_textured_columns_values_4_q <= select_1867;
      box_explained_columns_values_0_q <= select_1873;
      box_explained_columns_values_1_q <= select_1876;
      box_explained_columns_values_2_q <= select_1879;
      box_explained_columns_values_3_q <= select_1882;
      box_explained_columns_values_4_q <= select_1885;
      box_nearer_columns_values_0_q <= select_1891;
      box_nearer_columns_values_1_q <= select_1894;
      box_nearer_columns_values_2_q <= select_1897;
      box_nearer_columns_values_3_q <= select_1900;
      box_nearer_columns_values_4_q <= select_1903;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic census_columns_values_1_cell_2_of_skin_s24_q;
  logic census_columns_values_2_cell_4_mask_s24_q;
  logic census_columns_values_3_cell_0_mask_s24_q;
  logic census_columns_values_3_cell_1_mask_s24_q;
  logic census_columns_values_3_cell_2_mask_s24_q;
  logic census_columns_values_3_cell_3_mask_s24_q;
  logic [5:0] x_s24_q;
  logic lower_half_s24_q;
  logic [13:0] counts_supervised_s24_q;
  logic [13:0] counts_textured_s24_q;
  logic [11:0] registration_counts_measured_0_s24_q;
  logic [11:0] registration_counts_measured_1_s24_q;
  logic [11:0] registration_counts_measured_2_s24_q;
  logic [11:0] registration_counts_measured_3_s24_q;
  logic [2:0] region_row_s24_q;
  logic centres_values_1_textured_s24_q;
  logic centres_values_1_of_skin_s24_q;
  logic [6:0] column_s24_q;
  logic and_354_s24_q;
  logic whole_2_s24_q;
  logic equal_373_s24_q;
  logic not_374_s24_q;
  logic equal_375_s24_q;
  logic less_376_s24_q;
  logic not_377_s24_q;
  logic less_381_s24_q;
  logic less_382_s24_q;
  logic less_383_s24_q;
  logic less_384_s24_q;
  logic less_385_s24_q;
  logic less_386_s24_q;
  logic less_387_s24_q;
  logic less_388_s24_q;
  logic less_389_s24_q;
  logic less_390_s24_q;
  logic less_391_s24_q;
  logic less_392_s24_q;
  logic less_393_s24_q;
  logic less_394_s24_q;
  logic less_395_s24_q;
  logic less_396_s24_q;
  logic less_397_s24_q;
  logic less_398_s24_q;
  logic less_399_s24_q;
  logic less_400_s24_q;
  logic less_401_s24_q;
  logic less_402_s24_q;
  logic less_403_s24_q;
  logic less_404_s24_q;
  logic and_412_s24_q;
  logic whole_16_s24_q;
  logic and_438_s24_q;
  logic [11:0] sum_453_s24_q;
  logic [9:0] sum_456_s24_q;
  logic drew_s24_q;
  logic [6:0] x_s24_2_q;
  logic not_519_s24_q;
  logic [7:0] best_left_rdata_s24_q;
  logic equal_524_s24_q;
  logic select_820_s24_q;
  logic less_826_s24_q;
  logic less_827_s24_q;
  logic or_829_s24_q;
  logic [7:0] select_833_s24_q;
  logic [5:0] select_837_s24_q;
  logic equal_842_s24_q;
  logic rise_s24_q;
  logic [1:0] sum_854_s24_q;
  logic [7:0] twice_s24_q;
  logic difference_866_s24_q;
  logic [9:0] sum_869_s24_q;
  logic and_886_s24_q;
  logic equal_918_s24_q;
  logic equal_919_s24_q;
  logic and_929_s24_q;
  logic not_983_s24_q;
  logic [7:0] sum_993_s24_q;
  logic [4:0] difference_1003_s24_q;
  logic equal_1004_s24_q;
  logic or_1012_s24_q;
  logic or_1015_s24_q;
  logic or_1018_s24_q;
  logic [4:0] difference_1033_s24_q;
  logic [4:0] difference_1045_s24_q;
  logic and_1060_s24_q;
  logic [11:0] sum_1189_s24_q;
  logic [9:0] sum_1192_s24_q;
  logic equal_1200_s24_q;
  logic [27:0] select_1214_s24_q;
  logic [8:0] contrast_s24_q;
  logic [8:0] contrast_2_s24_q;
  logic equal_1252_s24_q;
  logic not_1298_s24_q;
  logic and_1385_s24_q;
  logic and_1400_s24_q;
  logic and_1405_s24_q;
  logic equal_1408_s24_q;
  logic [11:0] select_1419_s24_q;
  logic [11:0] select_1422_s24_q;
  logic and_1481_s24_q;
  logic less_1483_s24_q;
  logic equal_1484_s24_q;
  logic equal_1485_s24_q;
  logic equal_1486_s24_q;
  logic [7:0] residual_s24_q;
  logic less_1596_s24_q;
  logic not_1613_s24_q;
  logic [1:0] select_1627_s24_q;
  logic [1:0] select_1635_s24_q;
  logic [1:0] select_1643_s24_q;
  logic not_1646_s24_q;
  logic and_1808_s24_q;
  logic less_1809_s24_q;
  logic select_1815_s24_q;
  logic less_1826_s24_q;
  logic equal_1921_s24_q;
  logic less_2026_s24_q;
  logic less_2029_s24_q;
  logic or_2032_s24_q;
  logic less_2034_s24_q;
  logic or_2039_s24_q;
  logic less_2040_s24_q;
  logic select_2045_s24_q;
  logic less_2047_s24_q;
  logic less_2052_s24_q;
  logic less_2055_s24_q;
  logic select_2073_s24_q;
  logic and_2201_s24_q;
  logic [11:0] select_2222_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= line_ended_q;
      census_columns_values_1_cell_2_of_skin_s24_q <= census_columns_values_1_cell_2_of_skin_s23_q;
      census_columns_values_2_cell_4_mask_s24_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s24_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s24_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s24_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s24_q <= census_columns_values_3_cell_3_mask_q;
      x_s24_q <= x_s23_q[5:0];
      lower_half_s24_q <= lower_half_s23_q;
      counts_supervised_s24_q <= counts_supervised_q;
      counts_textured_s24_q <= counts_textured_q;
      registration_counts_measured_0_s24_q <= registration_counts_measured_0_s23_q;
      registration_counts_measured_1_s24_q <= registration_counts_measured_1_s23_q;
      registration_counts_measured_2_s24_q <= registration_counts_measured_2_s23_q;
      registration_counts_measured_3_s24_q <= registration_counts_measured_3_s23_q;
      region_row_s24_q <= region_row_s23_q;
      centres_values_1_textured_s24_q <= centres_values_1_textured_s23_q;
      centres_values_1_of_skin_s24_q <= centres_values_1_of_skin_s23_q;
      column_s24_q <= column_s23_q;
      and_354_s24_q <= and_354_s23_q;
      whole_2_s24_q <= whole_2_s23_q;
      equal_373_s24_q <= equal_373_s23_q;
      not_374_s24_q <= not_374_s23_q;
      equal_375_s24_q <= equal_375_s23_q;
      less_376_s24_q <= less_376_s23_q;
      not_377_s24_q <= not_377_s23_q;
      less_381_s24_q <= less_381_s23_q;
      less_382_s24_q <= less_382_s23_q;
      less_383_s24_q <= less_383_s23_q;
      less_384_s24_q <= less_384_s23_q;
      less_385_s24_q <= less_385_s23_q;
      less_386_s24_q <= less_386_s23_q;
      less_387_s24_q <= less_387_s23_q;
      less_388_s24_q <= less_388_s23_q;
      less_389_s24_q <= less_389_s23_q;
      less_390_s24_q <= less_390_s23_q;
      less_391_s24_q <= less_391_s23_q;
      less_392_s24_q <= less_392_s23_q;
      less_393_s24_q <= less_393_s23_q;
      less_394_s24_q <= less_394_s23_q;
      less_395_s24_q <= less_395_s23_q;
      less_396_s24_q <= less_396_s23_q;
      less_397_s24_q <= less_397_s23_q;
      less_398_s24_q <= less_398_s23_q;
      less_399_s24_q <= less_399_s23_q;
      less_400_s24_q <= less_400_s23_q;
      less_401_s24_q <= less_401_s23_q;
      less_402_s24_q <= less_402_s23_q;
      less_403_s24_q <= less_403_s23_q;
      less_404_s24_q <= less_404_s23_q;
      and_412_s24_q <= and_412_s23_q;
      whole_16_s24_q <= whole_16;
      and_438_s24_q <= census_columns_values_1_cell_2_mask_s23_q & and_412_s23_q;
      sum_453_s24_q <= {1'b0, sum_449} + {2'h0, sum_452_s23_q};
      sum_456_s24_q <= sum_456_s23_q;
      drew_s24_q <= drew_s23_q;
      x_s24_2_q <= x_s23_2_q;
      not_519_s24_q <= not_519_s23_q;
      best_left_rdata_s24_q <= best_left_rdata_s23_q;
      equal_524_s24_q <= equal_524_s23_q;
      select_820_s24_q <= select_820_s23_q;
      less_826_s24_q <= less_826_s23_q;
      less_827_s24_q <= less_827_s23_q;
      or_829_s24_q <= or_829_s23_q;
      select_833_s24_q <= select_833_s23_q;
      select_837_s24_q <= select_837_s23_q;
      equal_842_s24_q <= equal_842_s23_q;
      rise_s24_q <= rise_s23_q;
      sum_854_s24_q <= sum_854_s23_q;
      twice_s24_q <= twice_s23_q;
      difference_866_s24_q <= difference_866_s23_q[8];
      sum_869_s24_q <= sum_869;
      and_886_s24_q <= and_886_s23_q;
      equal_918_s24_q <= equal_918_s23_q;
      equal_919_s24_q <= equal_919_s23_q;
      and_929_s24_q <= and_929_s23_q;
      not_983_s24_q <= not_983;
      sum_993_s24_q <= {2'h0, x_s23_q[7:2]} + 8'hff;
      difference_1003_s24_q <= difference_1003;
      equal_1004_s24_q <= x_s23_q == 8'h0;
      or_1012_s24_q <= or_1012_s23_q;
      or_1015_s24_q <= or_1015_s23_q;
      or_1018_s24_q <= or_1018_s23_q;
      difference_1033_s24_q <= difference_1033;
      difference_1045_s24_q <= difference_1045;
      and_1060_s24_q <= and_1060_s23_q;
      sum_1189_s24_q <= {1'b0, sum_1185} + {2'h0, sum_1188_s23_q};
      sum_1192_s24_q <= sum_1192_s23_q;
      equal_1200_s24_q <= equal_1200_s23_q;
      select_1214_s24_q <= sample_pair_whole_s23_q ? {detail_2, detail} : 28'h0;
      contrast_s24_q <= contrast_s23_q;
      contrast_2_s24_q <= contrast_2_s23_q;
      equal_1252_s24_q <= equal_1252_s23_q;
      not_1298_s24_q <= not_1298_s23_q;
      and_1385_s24_q <= and_1385_s23_q;
      and_1400_s24_q <= and_1400_s23_q;
      and_1405_s24_q <= and_1405_s23_q;
      equal_1408_s24_q <= x_s23_q[7:1] == 7'h0;
      select_1419_s24_q <= select_1419_s23_q;
      select_1422_s24_q <= select_1422_s23_q;
      and_1481_s24_q <= and_1481_s23_q;
      less_1483_s24_q <= less_1483_s23_q;
      equal_1484_s24_q <= equal_1484_s23_q;
      equal_1485_s24_q <= equal_1485_s23_q;
      equal_1486_s24_q <= equal_1486_s23_q;
      residual_s24_q <= residual_s23_q;
      less_1596_s24_q <= less_1596_s23_q;
      not_1613_s24_q <= not_1613_s23_q;
      select_1627_s24_q <= select_1627;
      select_1635_s24_q <= select_1635;
      select_1643_s24_q <= select_1643;
      not_1646_s24_q <= not_1646_s23_q;
      and_1808_s24_q <= and_1808;
      less_1809_s24_q <= less_1809_s23_q;
      select_1815_s24_q <= select_1815;
      less_1826_s24_q <= less_1826_s23_q;
      equal_1921_s24_q <= equal_1921_s23_q;
      less_2026_s24_q <= less_2026_s23_q;
      less_2029_s24_q <= less_2029_s23_q;
      or_2032_s24_q <= or_2032_s23_q;
      less_2034_s24_q <= less_2034_s23_q;
      or_2039_s24_q <= or_2039;
      less_2040_s24_q <= less_2040_s23_q;
      select_2045_s24_q <= select_2045;
      less_2047_s24_q <= $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
      less_2052_s24_q <= less_2052_s23_q;
      less_2055_s24_q <= $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
      select_2073_s24_q <= select_2073;
      and_2201_s24_q <= and_2201_s23_q;
      select_2222_s24_q <= select_2222;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:260
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s24_q & whole_16_s24_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s24_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s24_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s24_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s24_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:190
  logic [11:0] texture;
  assign texture = sum_453_s24_q + {2'h0, sum_456_s24_q};
  // hls/stages/registration.hpp:28
  logic not_870;
  assign not_870 = ~sum_869_s24_q[9];
  logic [7:0] xor_871;
  assign xor_871 = twice_s24_q ^ {8{not_870}};
  // hls/stages/agreement.hpp:763
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:734
  logic select_981;
  assign select_981 = marks_first_s24_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:720
  logic [10:0] sum_982;
  assign sum_982 = {1'b0, {5{select_981}}, 1'b0, {2{select_981}}, 1'b0, select_981} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:624
  logic [12:0] index_2;
  assign index_2 = {{3{sum_993_s24_q[7]}}, sum_993_s24_q, x_s24_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:720
  logic [10:0] sum_995;
  assign sum_995 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:606
  logic [4:0] t;
  assign t = difference_1003_s24_q + (equal_1004_s24_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:612
  logic not_1019;
  assign not_1019 = ~region_row_s24_q[2];
  logic [2:0] select_1020;
  assign select_1020 = region_row_s24_q[1] ? {1'b0, not_1019, 1'b0} : {region_row_s24_q[2], 1'b0, not_1019};
  logic [5:0] select_1021;
  assign select_1021 = region_row_s24_q[0] ? {select_1020[2], 1'b0, select_1020[1], 1'b0, select_1020[0], 1'b0} : {1'b0, select_1020[2], 1'b0, select_1020[1], 1'b0, select_1020[0]};
  logic [11:0] select_1022;
  assign select_1022 = or_1018_s24_q ? {select_1021[5], 1'b0, select_1021[4], 1'b0, select_1021[3], 1'b0, select_1021[2], 1'b0, select_1021[1], 1'b0, select_1021[0], 1'b0} : {1'b0, select_1021[5], 1'b0, select_1021[4], 1'b0, select_1021[3], 1'b0, select_1021[2], 1'b0, select_1021[1], 1'b0, select_1021[0]};
  logic [23:0] select_1023;
  assign select_1023 = or_1015_s24_q ? {select_1022[11], 1'b0, select_1022[10], 1'b0, select_1022[9], 1'b0, select_1022[8], 1'b0, select_1022[7], 1'b0, select_1022[6], 1'b0, select_1022[5], 1'b0, select_1022[4], 1'b0, select_1022[3], 1'b0, select_1022[2], 1'b0, select_1022[1], 1'b0, select_1022[0], 1'b0} : {1'b0, select_1022[11], 1'b0, select_1022[10], 1'b0, select_1022[9], 1'b0, select_1022[8], 1'b0, select_1022[7], 1'b0, select_1022[6], 1'b0, select_1022[5], 1'b0, select_1022[4], 1'b0, select_1022[3], 1'b0, select_1022[2], 1'b0, select_1022[1], 1'b0, select_1022[0]};
  logic [47:0] select_1024;
  assign select_1024 = or_1012_s24_q ? {select_1023[23], 1'b0, select_1023[22], 1'b0, select_1023[21], 1'b0, select_1023[20], 1'b0, select_1023[19], 1'b0, select_1023[18], 1'b0, select_1023[17], 1'b0, select_1023[16], 1'b0, select_1023[15], 1'b0, select_1023[14], 1'b0, select_1023[13], 1'b0, select_1023[12], 1'b0, select_1023[11], 1'b0, select_1023[10], 1'b0, select_1023[9], 1'b0, select_1023[8], 1'b0, select_1023[7], 1'b0, select_1023[6], 1'b0, select_1023[5], 1'b0, select_1023[4], 1'b0, select_1023[3], 1'b0, select_1023[2], 1'b0, select_1023[1], 1'b0, select_1023[0], 1'b0} : {1'b0, select_1023[23], 1'b0, select_1023[22], 1'b0, select_1023[21], 1'b0, select_1023[20], 1'b0, select_1023[19], 1'b0, select_1023[18], 1'b0, select_1023[17], 1'b0, select_1023[16], 1'b0, select_1023[15], 1'b0, select_1023[14], 1'b0, select_1023[13], 1'b0, select_1023[12], 1'b0, select_1023[11], 1'b0, select_1023[10], 1'b0, select_1023[9], 1'b0, select_1023[8], 1'b0, select_1023[7], 1'b0, select_1023[6], 1'b0, select_1023[5], 1'b0, select_1023[4], 1'b0, select_1023[3], 1'b0, select_1023[2], 1'b0, select_1023[1], 1'b0, select_1023[0]};
  // hls/stages/agreement.hpp:607
  logic [4:0] e;
  assign e = difference_1033_s24_q + (equal_1004_s24_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:608
  logic [4:0] n;
  assign n = difference_1045_s24_q + (equal_1004_s24_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:184
  logic select_1173;
  assign select_1173 = and_354_s24_q ? census_columns_values_2_cell_4_mask_s24_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [11:0] sum_1193;
  assign sum_1193 = sum_1189_s24_q + {2'h0, sum_1192_s24_q};
  // hls/stages/agreement.hpp:184
  logic [11:0] select_1195;
  assign select_1195 = and_354_s24_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1196;
  assign select_1196 = and_354_s24_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_1215;
  assign select_1215 = and_354_s24_q ? select_1214_s24_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_1216;
  assign select_1216 = and_354_s24_q ? select_1214_s24_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:275
  logic and_1219;
  assign and_1219 = whole_2_s24_q & (~(column_s24_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:261
  logic and_1225;
  assign and_1225 = and_1219 & (sharpness_last_mask_q & (7'h2 < contrast_s24_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1214_s24_q[13:0]};
  // hls/stages/agreement.hpp:261
  logic and_1236;
  assign and_1236 = and_1219 & (sharpness_last_mask_q & (7'h2 < contrast_2_s24_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1214_s24_q[27:14]};
  // hls/stages/agreement.hpp:644
  logic [12:0] sum_1423;
  assign sum_1423 = {1'b0, select_1422_s24_q} + {3'h0, select_1422_s24_q[11:2]};
  // hls/stages/agreement.hpp:170
  logic and_1597;
  assign and_1597 = and_1481_s24_q & less_1596_s24_q;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1599;
  assign select_1599 = drew_s24_q ? (less_376_s24_q ? 2'h0 : {and_1597, and_1481_s24_q}) : 2'h0;
  // hls/stages/registration.hpp:79
  logic and_1614;
  assign and_1614 = less_1596_s24_q & not_1613_s24_q;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1616;
  assign select_1616 = less_376_s24_q ? 2'h0 : (and_1481_s24_q ? {and_1614, not_1613_s24_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1619;
  assign select_1619 = equal_373_s24_q ? 2'h0 : (equal_375_s24_q ? 2'h0 : (drew_s24_q ? select_1616 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1628;
  assign sum_1628 = registration_counts_votes_1_up_q + {{13{select_1627_s24_q[1]}}, select_1627_s24_q};
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1636;
  assign sum_1636 = registration_counts_votes_2_down_q + {{13{select_1635_s24_q[1]}}, select_1635_s24_q};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1644;
  assign sum_1644 = registration_counts_votes_2_up_q + {{13{select_1643_s24_q[1]}}, select_1643_s24_q};
  // hls/stages/registration.hpp:146
  logic less_1679;
  assign less_1679 = $signed(residual_s24_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1680;
  assign and_1680 = not_1613_s24_q & less_1679;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1682;
  assign select_1682 = less_376_s24_q ? 2'h0 : (and_1481_s24_q ? {and_1680, not_1613_s24_q} : 2'h0);
  // hls/stages/registration.hpp:79
  logic and_1697;
  assign and_1697 = less_1483_s24_q & less_1679;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1699;
  assign select_1699 = less_376_s24_q ? 2'h0 : (and_1481_s24_q ? {and_1697, less_1483_s24_q} : 2'h0);
  logic and_1713;
  assign and_1713 = less_1679 & not_1646_s24_q;
  logic [1:0] select_1715;
  assign select_1715 = less_376_s24_q ? 2'h0 : (and_1481_s24_q ? {and_1713, not_1646_s24_q} : 2'h0);
  logic and_1729;
  assign and_1729 = lower_half_s24_q & less_1679;
  logic [1:0] select_1731;
  assign select_1731 = less_376_s24_q ? 2'h0 : (and_1481_s24_q ? {and_1729, lower_half_s24_q} : 2'h0);
  // hls/stages/agreement.hpp:654
  logic equal_1803;
  assign equal_1803 = x_s24_q == 6'h3f;
  logic [47:0] select_1816;
  assign select_1816 = equal_919_s24_q ? good_next_q : {select_1815_s24_q, good_next_q[47:1]};
  // hls/stages/agreement.hpp:317
  logic [47:0] select_1823;
  assign select_1823 = drew_s24_q ? good_next_q : (equal_918_s24_q ? select_1816 : good_next_q);
  logic [47:0] select_1825;
  assign select_1825 = equal_373_s24_q ? good_next_q : (equal_375_s24_q ? good_next_q : select_1823);
  logic [4:0] select_1869;
  assign select_1869 = equal_375_s24_q ? box_textured_sum_sums_values_0_q : (drew_s24_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1887;
  assign select_1887 = equal_375_s24_q ? box_explained_sum_sums_values_0_q : (drew_s24_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1888;
  assign select_1888 = equal_373_s24_q ? box_explained_sum_sums_values_0_q : select_1887;
  logic [4:0] select_1905;
  assign select_1905 = equal_375_s24_q ? box_nearer_sum_sums_values_0_q : (drew_s24_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:264
  logic [12:0] select_1924;
  assign select_1924 = equal_1252_s24_q ? (equal_1921_s24_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1927;
  assign select_1927 = and_354_s24_q ? (equal_1252_s24_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:317
  logic and_1937;
  assign and_1937 = not_519_s24_q & (not_1298_s24_q & (equal_918_s24_q & equal_1803));
  logic [13:0] select_1966;
  assign select_1966 = equal_918_s24_q ? (equal_1803 ? counts_supervised_s24_q : 14'h0) : 14'h0;
  logic [13:0] select_1969;
  assign select_1969 = equal_373_s24_q ? 14'h0 : (equal_375_s24_q ? 14'h0 : (drew_s24_q ? 14'h0 : select_1966));
  logic [13:0] select_1971;
  assign select_1971 = equal_918_s24_q ? (equal_1803 ? counts_textured_s24_q : 14'h0) : 14'h0;
  logic [13:0] select_1974;
  assign select_1974 = equal_373_s24_q ? 14'h0 : (equal_375_s24_q ? 14'h0 : (drew_s24_q ? 14'h0 : select_1971));
  // hls/stages/registration.hpp:104
  logic or_2046;
  assign or_2046 = (~less_2040_s24_q) | select_2045_s24_q;
  logic select_2048;
  assign select_2048 = or_2046 ? select_2045_s24_q : less_2047_s24_q;
  logic select_2050;
  assign select_2050 = less_2029_s24_q ? select_2048 : (less_2034_s24_q ? select_2048 : less_2047_s24_q);
  // hls/stages/agreement.hpp:658
  logic and_2074;
  assign and_2074 = (less_2040_s24_q & less_2052_s24_q) & select_2073_s24_q;
  logic or_2075;
  assign or_2075 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2074;
  logic select_2076;
  assign select_2076 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2075 : and_2074;
  logic or_2077;
  assign or_2077 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2076;
  // hls/stages/agreement.hpp:317
  logic [11:0] select_2160;
  assign select_2160 = equal_918_s24_q ? (equal_1803 ? registration_counts_measured_0_s24_q : 12'h0) : 12'h0;
  logic [11:0] select_2163;
  assign select_2163 = equal_373_s24_q ? 12'h0 : (equal_375_s24_q ? 12'h0 : (drew_s24_q ? 12'h0 : select_2160));
  logic [11:0] select_2165;
  assign select_2165 = equal_918_s24_q ? (equal_1803 ? registration_counts_measured_1_s24_q : 12'h0) : 12'h0;
  logic [11:0] select_2168;
  assign select_2168 = equal_373_s24_q ? 12'h0 : (equal_375_s24_q ? 12'h0 : (drew_s24_q ? 12'h0 : select_2165));
  logic [11:0] select_2170;
  assign select_2170 = equal_918_s24_q ? (equal_1803 ? registration_counts_measured_2_s24_q : 12'h0) : 12'h0;
  logic [11:0] select_2173;
  assign select_2173 = equal_373_s24_q ? 12'h0 : (equal_375_s24_q ? 12'h0 : (drew_s24_q ? 12'h0 : select_2170));
  logic [11:0] select_2175;
  assign select_2175 = equal_918_s24_q ? (equal_1803 ? registration_counts_measured_3_s24_q : 12'h0) : 12'h0;
  logic [11:0] select_2178;
  assign select_2178 = equal_373_s24_q ? 12'h0 : (equal_375_s24_q ? 12'h0 : (drew_s24_q ? 12'h0 : select_2175));
  logic [5:0] select_2204;
  assign select_2204 = drew_s24_q ? 6'h0 : (equal_918_s24_q ? (equal_919_s24_q ? 6'h0 : x_s24_q) : 6'h0);
  logic [11:0] select_2213;
  assign select_2213 = equal_918_s24_q ? (equal_919_s24_q ? 12'h0 : select_1422_s24_q) : 12'h0;
  logic [11:0] select_2216;
  assign select_2216 = equal_373_s24_q ? 12'h0 : (equal_375_s24_q ? 12'h0 : (drew_s24_q ? 12'h0 : select_2213));

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
    end else if (s24_en) begin
      registration_counts_votes_1_up_q <= and_1385_s24_q ? 15'h0 : sum_1628;
      registration_counts_votes_2_down_q <= and_1385_s24_q ? 15'h0 : sum_1636;
      registration_counts_votes_2_up_q <= and_1385_s24_q ? 15'h0 : sum_1644;
      good_next_q <= select_1825;
      begins_product_q <= drew_s24_q;
      map_row_q <= and_354_s24_q ? select_1924 : map_row_q;
      map_width_q <= select_1927;
      write_half_q <= marks_first_s24_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_981;
      done_q <= not_983_s24_q & ((~begins_product_q) & (done_q | said_q));
      said_q <= not_374_s24_q & and_1937;
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
    if (s24_en) begin
      census_columns_values_3_cell_4_mask_q <= select_1173;
      census_changes_values_0_left_q <= and_354_s24_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_354_s24_q ? sum_1193 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1195;
      census_changes_values_1_right_q <= select_1196;
      sharpness_last_mask_q <= and_354_s24_q ? whole_2_s24_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= select_1215;
      sharpness_last_detail_1_q <= select_1216;
      box_textured_sum_sums_values_0_q <= equal_373_s24_q ? box_textured_sum_sums_values_0_q : select_1869;
      box_explained_sum_sums_values_0_q <= select_1888;
      box_nearer_sum_sums_values_0_q <= equal_373_s24_q ? box_nearer_sum_sums_values_0_q : select_1905;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic census_columns_values_1_cell_2_of_skin_s25_q;
  logic [11:0] census_changes_values_1_left_s25_q;
  logic [11:0] census_changes_values_1_right_s25_q;
  logic begins_product_s25_q;
  logic centres_values_1_textured_s25_q;
  logic centres_values_1_of_skin_s25_q;
  logic done_s25_q;
  logic [6:0] column_s25_q;
  logic and_354_s25_q;
  logic equal_373_s25_q;
  logic not_374_s25_q;
  logic equal_375_s25_q;
  logic less_376_s25_q;
  logic not_377_s25_q;
  logic less_381_s25_q;
  logic less_382_s25_q;
  logic less_383_s25_q;
  logic less_384_s25_q;
  logic less_385_s25_q;
  logic less_386_s25_q;
  logic less_387_s25_q;
  logic less_388_s25_q;
  logic less_389_s25_q;
  logic less_390_s25_q;
  logic less_391_s25_q;
  logic less_392_s25_q;
  logic less_393_s25_q;
  logic less_394_s25_q;
  logic less_395_s25_q;
  logic less_396_s25_q;
  logic less_397_s25_q;
  logic less_398_s25_q;
  logic less_399_s25_q;
  logic less_400_s25_q;
  logic less_401_s25_q;
  logic less_402_s25_q;
  logic less_403_s25_q;
  logic less_404_s25_q;
  logic and_412_s25_q;
  logic and_437_s25_q;
  logic and_438_s25_q;
  logic [12:0] sum_458_s25_q;
  logic [6:0] x_s25_q;
  logic not_519_s25_q;
  logic [7:0] best_left_rdata_s25_q;
  logic equal_524_s25_q;
  logic select_820_s25_q;
  logic less_826_s25_q;
  logic less_827_s25_q;
  logic or_829_s25_q;
  logic [7:0] select_833_s25_q;
  logic [5:0] select_837_s25_q;
  logic equal_842_s25_q;
  logic rise_s25_q;
  logic [1:0] sum_854_s25_q;
  logic [7:0] twice_s25_q;
  logic difference_866_s25_q;
  logic sum_869_s25_q;
  logic [9:0] sum_872_s25_q;
  logic and_886_s25_q;
  logic equal_918_s25_q;
  logic equal_919_s25_q;
  logic and_929_s25_q;
  logic [2:0] index_s25_q;
  logic [10:0] sum_982_s25_q;
  logic and_989_s25_q;
  logic less_990_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_995_s25_q;
  logic [4:0] t_s25_q;
  logic [47:0] select_1024_s25_q;
  logic e_s25_q;
  logic [5:0] sum_1036_s25_q;
  logic less_1048_s25_q;
  logic and_1060_s25_q;
  logic equal_1200_s25_q;
  logic [12:0] sum_1201_s25_q;
  logic [12:0] select_1227_s25_q;
  logic [12:0] select_1238_s25_q;
  logic [8:0] select_1243_s25_q;
  logic [8:0] select_1247_s25_q;
  logic not_1298_s25_q;
  logic and_1385_s25_q;
  logic and_1400_s25_q;
  logic and_1405_s25_q;
  logic equal_1408_s25_q;
  logic [11:0] select_1419_s25_q;
  logic less_1424_s25_q;
  logic and_1481_s25_q;
  logic equal_1484_s25_q;
  logic equal_1485_s25_q;
  logic equal_1486_s25_q;
  logic [7:0] residual_s25_q;
  logic [1:0] select_1601_s25_q;
  logic [1:0] select_1619_s25_q;
  logic [1:0] select_1683_s25_q;
  logic [1:0] select_1700_s25_q;
  logic [1:0] select_1716_s25_q;
  logic [1:0] select_1732_s25_q;
  logic equal_1803_s25_q;
  logic and_1808_s25_q;
  logic less_1809_s25_q;
  logic [47:0] select_1816_s25_q;
  logic less_1826_s25_q;
  logic [13:0] select_1969_s25_q;
  logic [13:0] select_1974_s25_q;
  logic less_2026_s25_q;
  logic less_2029_s25_q;
  logic or_2032_s25_q;
  logic less_2034_s25_q;
  logic or_2039_s25_q;
  logic less_2040_s25_q;
  logic or_2046_s25_q;
  logic select_2051_s25_q;
  logic less_2052_s25_q;
  logic less_2055_s25_q;
  logic and_2074_s25_q;
  logic select_2076_s25_q;
  logic or_2077_s25_q;
  logic [11:0] select_2163_s25_q;
  logic [11:0] select_2168_s25_q;
  logic [11:0] select_2173_s25_q;
  logic [11:0] select_2178_s25_q;
  logic and_2201_s25_q;
  logic [5:0] select_2206_s25_q;
  logic [11:0] select_2216_s25_q;
  logic [11:0] select_2222_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      census_columns_values_1_cell_2_of_skin_s25_q <= census_columns_values_1_cell_2_of_skin_s24_q;
      census_changes_values_1_left_s25_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s25_q <= census_changes_values_1_right_q;
      begins_product_s25_q <= begins_product_q;
      centres_values_1_textured_s25_q <= centres_values_1_textured_s24_q;
      centres_values_1_of_skin_s25_q <= centres_values_1_of_skin_s24_q;
      done_s25_q <= done_q;
      column_s25_q <= column_s24_q;
      and_354_s25_q <= and_354_s24_q;
      equal_373_s25_q <= equal_373_s24_q;
      not_374_s25_q <= not_374_s24_q;
      equal_375_s25_q <= equal_375_s24_q;
      less_376_s25_q <= less_376_s24_q;
      not_377_s25_q <= not_377_s24_q;
      less_381_s25_q <= less_381_s24_q;
      less_382_s25_q <= less_382_s24_q;
      less_383_s25_q <= less_383_s24_q;
      less_384_s25_q <= less_384_s24_q;
      less_385_s25_q <= less_385_s24_q;
      less_386_s25_q <= less_386_s24_q;
      less_387_s25_q <= less_387_s24_q;
      less_388_s25_q <= less_388_s24_q;
      less_389_s25_q <= less_389_s24_q;
      less_390_s25_q <= less_390_s24_q;
      less_391_s25_q <= less_391_s24_q;
      less_392_s25_q <= less_392_s24_q;
      less_393_s25_q <= less_393_s24_q;
      less_394_s25_q <= less_394_s24_q;
      less_395_s25_q <= less_395_s24_q;
      less_396_s25_q <= less_396_s24_q;
      less_397_s25_q <= less_397_s24_q;
      less_398_s25_q <= less_398_s24_q;
      less_399_s25_q <= less_399_s24_q;
      less_400_s25_q <= less_400_s24_q;
      less_401_s25_q <= less_401_s24_q;
      less_402_s25_q <= less_402_s24_q;
      less_403_s25_q <= less_403_s24_q;
      less_404_s25_q <= less_404_s24_q;
      and_412_s25_q <= and_412_s24_q;
      and_437_s25_q <= whole_22 & and_412_s24_q;
      and_438_s25_q <= and_438_s24_q;
      sum_458_s25_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      x_s25_q <= x_s24_2_q;
      not_519_s25_q <= not_519_s24_q;
      best_left_rdata_s25_q <= best_left_rdata_s24_q;
      equal_524_s25_q <= equal_524_s24_q;
      select_820_s25_q <= select_820_s24_q;
      less_826_s25_q <= less_826_s24_q;
      less_827_s25_q <= less_827_s24_q;
      or_829_s25_q <= or_829_s24_q;
      select_833_s25_q <= select_833_s24_q;
      select_837_s25_q <= select_837_s24_q;
      equal_842_s25_q <= equal_842_s24_q;
      rise_s25_q <= rise_s24_q;
      sum_854_s25_q <= sum_854_s24_q;
      twice_s25_q <= twice_s24_q;
      difference_866_s25_q <= difference_866_s24_q;
      sum_869_s25_q <= sum_869_s24_q[9];
      sum_872_s25_q <= {sum_869_s24_q[8:0], not_870} + {not_870, xor_871, not_870};
      and_886_s25_q <= and_886_s24_q;
      equal_918_s25_q <= equal_918_s24_q;
      equal_919_s25_q <= equal_919_s24_q;
      and_929_s25_q <= and_929_s24_q;
      index_s25_q <= index[2:0];
      sum_982_s25_q <= sum_982;
      and_989_s25_q <= began_q & (seen_x_q == 4'h0);
      less_990_s25_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s25_q <= index_2[2:0];
      sum_995_s25_q <= sum_995;
      t_s25_q <= t;
      select_1024_s25_q <= select_1024;
      e_s25_q <= e[0];
      sum_1036_s25_q <= {1'b0, e} + {2'h0, e[4:1]};
      less_1048_s25_q <= {1'b0, e[4:1]} < n;
      and_1060_s25_q <= and_1060_s24_q;
      equal_1200_s25_q <= equal_1200_s24_q;
      sum_1201_s25_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1193};
      select_1227_s25_q <= and_1225 ? detail_3[14:2] : 13'h0;
      select_1238_s25_q <= and_1236 ? detail_4[14:2] : 13'h0;
      select_1243_s25_q <= and_1225 ? contrast_s24_q : 9'h0;
      select_1247_s25_q <= and_1236 ? contrast_2_s24_q : 9'h0;
      not_1298_s25_q <= not_1298_s24_q;
      and_1385_s25_q <= and_1385_s24_q;
      and_1400_s25_q <= and_1400_s24_q;
      and_1405_s25_q <= and_1405_s24_q;
      equal_1408_s25_q <= equal_1408_s24_q;
      select_1419_s25_q <= select_1419_s24_q;
      less_1424_s25_q <= {sum_1423, select_1422_s24_q[1:0]} < {3'h0, select_1419_s24_q};
      and_1481_s25_q <= and_1481_s24_q;
      equal_1484_s25_q <= equal_1484_s24_q;
      equal_1485_s25_q <= equal_1485_s24_q;
      equal_1486_s25_q <= equal_1486_s24_q;
      residual_s25_q <= residual_s24_q;
      select_1601_s25_q <= equal_373_s24_q ? 2'h0 : (equal_375_s24_q ? 2'h0 : select_1599);
      select_1619_s25_q <= select_1619;
      select_1683_s25_q <= drew_s24_q ? select_1682 : 2'h0;
      select_1700_s25_q <= drew_s24_q ? select_1699 : 2'h0;
      select_1716_s25_q <= drew_s24_q ? select_1715 : 2'h0;
      select_1732_s25_q <= drew_s24_q ? select_1731 : 2'h0;
      equal_1803_s25_q <= equal_1803;
      and_1808_s25_q <= and_1808_s24_q;
      less_1809_s25_q <= less_1809_s24_q;
      select_1816_s25_q <= select_1816;
      less_1826_s25_q <= less_1826_s24_q;
      select_1969_s25_q <= select_1969;
      select_1974_s25_q <= select_1974;
      less_2026_s25_q <= less_2026_s24_q;
      less_2029_s25_q <= less_2029_s24_q;
      or_2032_s25_q <= or_2032_s24_q;
      less_2034_s25_q <= less_2034_s24_q;
      or_2039_s25_q <= or_2039_s24_q;
      less_2040_s25_q <= less_2040_s24_q;
      or_2046_s25_q <= or_2046;
      select_2051_s25_q <= less_2026_s24_q ? select_2048 : select_2050;
      less_2052_s25_q <= less_2052_s24_q;
      less_2055_s25_q <= less_2055_s24_q;
      and_2074_s25_q <= and_2074;
      select_2076_s25_q <= select_2076;
      or_2077_s25_q <= or_2077;
      select_2163_s25_q <= select_2163;
      select_2168_s25_q <= select_2168;
      select_2173_s25_q <= select_2173;
      select_2178_s25_q <= select_2178;
      and_2201_s25_q <= and_2201_s24_q;
      select_2206_s25_q <= equal_373_s24_q ? 6'h0 : (equal_375_s24_q ? 6'h0 : select_2204);
      select_2216_s25_q <= select_2216;
      select_2222_s25_q <= select_2222_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
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
  logic [13:0] sum_459;
  assign sum_459 = {2'h0, census_changes_values_1_left_s25_q} + {1'b0, sum_458_s25_q};
  logic [13:0] sum_460;
  assign sum_460 = {2'h0, census_changes_values_2_left_q} + sum_459;
  // hls/stages/registration.hpp:28
  logic not_873;
  assign not_873 = ~sum_872_s25_q[9];
  logic [7:0] xor_874;
  assign xor_874 = twice_s25_q ^ {8{not_873}};
  logic [9:0] sum_875;
  assign sum_875 = {sum_872_s25_q[8:0], not_873} + {not_873, xor_874, not_873};
  logic not_876;
  assign not_876 = ~sum_875[9];
  // hls/stages/agreement.hpp:613
  logic is_seen;
  assign is_seen = (t_s25_q[4:1] == 4'h0) ? (~((good_q & select_1024_s25_q) == 48'h0)) : (~({sum_1036_s25_q, e_s25_q} < {2'h0, t_s25_q}));
  // hls/stages/agreement.hpp:184
  logic [11:0] select_1197;
  assign select_1197 = and_354_s25_q ? census_changes_values_1_left_s25_q : census_changes_values_2_left_q;
  logic [11:0] select_1198;
  assign select_1198 = and_354_s25_q ? census_changes_values_1_right_s25_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [13:0] sum_1202;
  assign sum_1202 = {2'h0, census_changes_values_1_right_s25_q} + {1'b0, sum_1201_s25_q};
  logic [13:0] sum_1203;
  assign sum_1203 = {2'h0, census_changes_values_2_right_q} + sum_1202;
  // hls/stages/census.hpp:277
  logic [23:0] select_1229;
  assign select_1229 = equal_1200_s25_q ? {11'h0, select_1227_s25_q} : (sharpness_sums_detail_0_q + {11'h0, select_1227_s25_q});
  logic [23:0] select_1240;
  assign select_1240 = equal_1200_s25_q ? {11'h0, select_1238_s25_q} : (sharpness_sums_detail_1_q + {11'h0, select_1238_s25_q});
  logic [23:0] sum_1244;
  assign sum_1244 = (equal_1200_s25_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1243_s25_q};
  logic [23:0] sum_1248;
  assign sum_1248 = (equal_1200_s25_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1247_s25_q};
  // hls/stages/agreement.hpp:556
  logic [8:0] select_1450;
  assign select_1450 = and_929_s25_q ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:170
  logic and_1452;
  assign and_1452 = not_377_s25_q & select_1450[8];
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1602;
  assign sum_1602 = registration_counts_votes_0_down_q + {{13{select_1601_s25_q[1]}}, select_1601_s25_q};
  logic [14:0] sum_1620;
  assign sum_1620 = registration_counts_votes_1_down_q + {{13{select_1619_s25_q[1]}}, select_1619_s25_q};
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1685;
  assign select_1685 = equal_373_s25_q ? 2'h0 : (equal_375_s25_q ? 2'h0 : select_1683_s25_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1686;
  assign sum_1686 = registration_counts_half_votes_0_down_q + {{13{select_1685[1]}}, select_1685};
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1702;
  assign select_1702 = equal_373_s25_q ? 2'h0 : (equal_375_s25_q ? 2'h0 : select_1700_s25_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1703;
  assign sum_1703 = registration_counts_half_votes_1_down_q + {{13{select_1702[1]}}, select_1702};
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1718;
  assign select_1718 = equal_373_s25_q ? 2'h0 : (equal_375_s25_q ? 2'h0 : select_1716_s25_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1719;
  assign sum_1719 = registration_counts_half_votes_2_down_q + {{13{select_1718[1]}}, select_1718};
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1734;
  assign select_1734 = equal_373_s25_q ? 2'h0 : (equal_375_s25_q ? 2'h0 : select_1732_s25_q);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1735;
  assign sum_1735 = registration_counts_half_votes_3_down_q + {{13{select_1734[1]}}, select_1734};
  // hls/stages/agreement.hpp:317
  logic [47:0] select_1818;
  assign select_1818 = equal_918_s25_q ? (equal_1803_s25_q ? select_1816_s25_q : good_q) : good_q;
  logic [47:0] select_1820;
  assign select_1820 = equal_375_s25_q ? good_q : (begins_product_q ? good_q : select_1818);
  // hls/stages/agreement.hpp:656
  logic [7:0] select_1827;
  assign select_1827 = less_1826_s25_q ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1829;
  assign select_1829 = equal_918_s25_q ? (equal_1803_s25_q ? select_1827 : hidden_for_q) : hidden_for_q;
  logic [7:0] select_1831;
  assign select_1831 = equal_375_s25_q ? hidden_for_q : (begins_product_q ? hidden_for_q : select_1829);
  // hls/stages/agreement.hpp:144
  logic not_1833;
  assign not_1833 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:671
  logic [35:0] select_1844;
  assign select_1844 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:665
  logic [35:0] detail_left;
  assign detail_left = begins_product_s25_q ? 36'h0 : select_1844;
  // hls/stages/agreement.hpp:671
  logic [35:0] select_1847;
  assign select_1847 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:675
  logic [35:0] detail_right;
  assign detail_right = begins_product_s25_q ? 36'h0 : select_1847;
  // hls/stages/agreement.hpp:665
  logic [34:0] select_1849;
  assign select_1849 = begins_product_s25_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:675
  logic [34:0] select_1850;
  assign select_1850 = begins_product_s25_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:665
  logic [17:0] select_1851;
  assign select_1851 = begins_product_s25_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:675
  logic [17:0] select_1852;
  assign select_1852 = begins_product_s25_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:763
  logic and_1953;
  assign and_1953 = and_1060_s25_q & ({sum_995_s25_q, index_2_s25_q} == {sum_982_s25_q, index_s25_q});
  // hls/stages/registration.hpp:104
  logic or_2054;
  assign or_2054 = select_2051_s25_q | (~less_2052_s25_q);
  // hls/stages/registration.hpp:105
  logic select_2056;
  assign select_2056 = or_2054 ? select_2051_s25_q : less_2055_s25_q;
  logic select_2058;
  assign select_2058 = less_2034_s25_q ? select_2056 : (less_2040_s25_q ? select_2056 : less_2055_s25_q);
  // hls/stages/agreement.hpp:658
  logic select_2078;
  assign select_2078 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2077_s25_q : select_2076_s25_q;
  logic select_2079;
  assign select_2079 = (less_2029_s25_q & less_2034_s25_q) ? select_2078 : and_2074_s25_q;
  // hls/stages/registration.hpp:119
  logic less_2081;
  assign less_2081 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  logic less_2084;
  assign less_2084 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2087;
  assign less_2087 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2090;
  assign less_2090 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:658
  logic and_2132;
  assign and_2132 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1827 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:317
  logic [23:0] select_2180;
  assign select_2180 = equal_918_s25_q ? (equal_1803_s25_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2182;
  assign select_2182 = equal_375_s25_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2180);
  logic [23:0] select_2185;
  assign select_2185 = equal_918_s25_q ? (equal_1803_s25_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2187;
  assign select_2187 = equal_375_s25_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2185);

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:841; read in stage 25, written in stage 26: 25 < 26 < 25 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_982_s25_q, index_s25_q};
  logic map_re;
  assign map_re = s25_en & (and_989_s25_q & less_990_s25_q);
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
    end else if (s25_en) begin
      sharpness_sums_detail_0_q <= and_354_s25_q ? select_1229 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_354_s25_q ? select_1240 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_354_s25_q ? sum_1244 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_354_s25_q ? sum_1248 : sharpness_sums_contrast_1_q;
      registration_counts_votes_0_down_q <= and_1385_s25_q ? 15'h0 : sum_1602;
      registration_counts_votes_1_down_q <= and_1385_s25_q ? 15'h0 : sum_1620;
      registration_counts_half_votes_0_down_q <= and_1385_s25_q ? 15'h0 : sum_1686;
      registration_counts_half_votes_1_down_q <= and_1385_s25_q ? 15'h0 : sum_1703;
      registration_counts_half_votes_2_down_q <= and_1385_s25_q ? 15'h0 : sum_1719;
      registration_counts_half_votes_3_down_q <= and_1385_s25_q ? 15'h0 : sum_1735;
      good_q <= equal_373_s25_q ? good_q : select_1820;
      hidden_for_q <= equal_373_s25_q ? hidden_for_q : select_1831;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1833};
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1849;
      addend_1_q <= select_1850;
      multiplier_0_q <= select_1851;
      multiplier_1_q <= select_1852;
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
    if (s25_en) begin
      census_changes_values_2_left_q <= select_1197;
      census_changes_values_2_right_q <= select_1198;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic census_columns_values_1_cell_2_of_skin_s26_q;
  logic [23:0] sharpness_sums_contrast_0_s26_q;
  logic [23:0] sharpness_sums_contrast_1_s26_q;
  logic centres_values_1_textured_s26_q;
  logic centres_values_1_of_skin_s26_q;
  logic done_s26_q;
  logic [6:0] column_s26_q;
  logic and_354_s26_q;
  logic equal_373_s26_q;
  logic not_374_s26_q;
  logic equal_375_s26_q;
  logic less_376_s26_q;
  logic less_381_s26_q;
  logic less_382_s26_q;
  logic less_383_s26_q;
  logic less_384_s26_q;
  logic less_385_s26_q;
  logic less_386_s26_q;
  logic less_387_s26_q;
  logic less_388_s26_q;
  logic less_389_s26_q;
  logic less_390_s26_q;
  logic less_391_s26_q;
  logic less_392_s26_q;
  logic less_393_s26_q;
  logic less_394_s26_q;
  logic less_395_s26_q;
  logic less_396_s26_q;
  logic less_397_s26_q;
  logic less_398_s26_q;
  logic less_399_s26_q;
  logic less_400_s26_q;
  logic less_401_s26_q;
  logic less_402_s26_q;
  logic less_403_s26_q;
  logic less_404_s26_q;
  logic and_412_s26_q;
  logic and_437_s26_q;
  logic and_438_s26_q;
  logic [8:0] sum_460_s26_q;
  logic drew_s26_q;
  logic [6:0] x_s26_q;
  logic not_519_s26_q;
  logic [7:0] best_left_rdata_s26_q;
  logic equal_524_s26_q;
  logic select_820_s26_q;
  logic less_826_s26_q;
  logic less_827_s26_q;
  logic or_829_s26_q;
  logic [7:0] select_833_s26_q;
  logic [5:0] select_837_s26_q;
  logic equal_842_s26_q;
  logic rise_s26_q;
  logic [1:0] sum_854_s26_q;
  logic difference_866_s26_q;
  logic sum_869_s26_q;
  logic sum_872_s26_q;
  logic [9:0] sum_875_s26_q;
  logic not_876_s26_q;
  logic [7:0] xor_877_s26_q;
  logic and_886_s26_q;
  logic equal_918_s26_q;
  logic equal_919_s26_q;
  logic and_929_s26_q;
  logic and_989_s26_q;
  logic less_990_s26_q;
  logic [2:0] index_2_s26_q;
  logic [10:0] sum_995_s26_q;
  logic is_seen_s26_q;
  logic less_1048_s26_q;
  logic and_1060_s26_q;
  logic equal_1200_s26_q;
  logic [8:0] sum_1203_s26_q;
  logic not_1298_s26_q;
  logic and_1385_s26_q;
  logic and_1400_s26_q;
  logic and_1405_s26_q;
  logic equal_1408_s26_q;
  logic [11:0] select_1419_s26_q;
  logic and_1425_s26_q;
  logic [7:0] select_1451_s26_q;
  logic and_1452_s26_q;
  logic [2:0] sum_1453_s26_q;
  logic and_1481_s26_q;
  logic equal_1484_s26_q;
  logic equal_1485_s26_q;
  logic equal_1486_s26_q;
  logic [7:0] residual_s26_q;
  logic equal_1803_s26_q;
  logic and_1808_s26_q;
  logic less_1809_s26_q;
  logic and_1938_s26_q;
  logic and_1953_s26_q;
  logic [13:0] select_1969_s26_q;
  logic [13:0] select_1974_s26_q;
  logic less_2026_s26_q;
  logic less_2027_s26_q;
  logic less_2029_s26_q;
  logic or_2032_s26_q;
  logic less_2034_s26_q;
  logic or_2039_s26_q;
  logic less_2040_s26_q;
  logic or_2046_s26_q;
  logic less_2052_s26_q;
  logic or_2054_s26_q;
  logic select_2056_s26_q;
  logic select_2059_s26_q;
  logic select_2079_s26_q;
  logic less_2081_s26_q;
  logic less_2084_s26_q;
  logic less_2087_s26_q;
  logic less_2090_s26_q;
  logic and_2134_s26_q;
  logic [11:0] select_2163_s26_q;
  logic [11:0] select_2168_s26_q;
  logic [11:0] select_2173_s26_q;
  logic [11:0] select_2178_s26_q;
  logic [23:0] select_2183_s26_q;
  logic [23:0] select_2188_s26_q;
  logic and_2201_s26_q;
  logic [5:0] select_2206_s26_q;
  logic [11:0] select_2216_s26_q;
  logic [11:0] select_2222_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      census_columns_values_1_cell_2_of_skin_s26_q <= census_columns_values_1_cell_2_of_skin_s25_q;
      sharpness_sums_contrast_0_s26_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s26_q <= sharpness_sums_contrast_1_q;
      centres_values_1_textured_s26_q <= centres_values_1_textured_s25_q;
      centres_values_1_of_skin_s26_q <= centres_values_1_of_skin_s25_q;
      done_s26_q <= done_s25_q;
      column_s26_q <= column_s25_q;
      and_354_s26_q <= and_354_s25_q;
      equal_373_s26_q <= equal_373_s25_q;
      not_374_s26_q <= not_374_s25_q;
      equal_375_s26_q <= equal_375_s25_q;
      less_376_s26_q <= less_376_s25_q;
      less_381_s26_q <= less_381_s25_q;
      less_382_s26_q <= less_382_s25_q;
      less_383_s26_q <= less_383_s25_q;
      less_384_s26_q <= less_384_s25_q;
      less_385_s26_q <= less_385_s25_q;
      less_386_s26_q <= less_386_s25_q;
      less_387_s26_q <= less_387_s25_q;
      less_388_s26_q <= less_388_s25_q;
      less_389_s26_q <= less_389_s25_q;
      less_390_s26_q <= less_390_s25_q;
      less_391_s26_q <= less_391_s25_q;
      less_392_s26_q <= less_392_s25_q;
      less_393_s26_q <= less_393_s25_q;
      less_394_s26_q <= less_394_s25_q;
      less_395_s26_q <= less_395_s25_q;
      less_396_s26_q <= less_396_s25_q;
      less_397_s26_q <= less_397_s25_q;
      less_398_s26_q <= less_398_s25_q;
      less_399_s26_q <= less_399_s25_q;
      less_400_s26_q <= less_400_s25_q;
      less_401_s26_q <= less_401_s25_q;
      less_402_s26_q <= less_402_s25_q;
      less_403_s26_q <= less_403_s25_q;
      less_404_s26_q <= less_404_s25_q;
      and_412_s26_q <= and_412_s25_q;
      and_437_s26_q <= and_437_s25_q;
      and_438_s26_q <= and_438_s25_q;
      sum_460_s26_q <= sum_460[13:5];
      drew_s26_q <= begins_product_q;
      x_s26_q <= x_s25_q;
      not_519_s26_q <= not_519_s25_q;
      best_left_rdata_s26_q <= best_left_rdata_s25_q;
      equal_524_s26_q <= equal_524_s25_q;
      select_820_s26_q <= select_820_s25_q;
      less_826_s26_q <= less_826_s25_q;
      less_827_s26_q <= less_827_s25_q;
      or_829_s26_q <= or_829_s25_q;
      select_833_s26_q <= select_833_s25_q;
      select_837_s26_q <= select_837_s25_q;
      equal_842_s26_q <= equal_842_s25_q;
      rise_s26_q <= rise_s25_q;
      sum_854_s26_q <= sum_854_s25_q;
      difference_866_s26_q <= difference_866_s25_q;
      sum_869_s26_q <= sum_869_s25_q;
      sum_872_s26_q <= sum_872_s25_q[9];
      sum_875_s26_q <= sum_875;
      not_876_s26_q <= not_876;
      xor_877_s26_q <= twice_s25_q ^ {8{not_876}};
      and_886_s26_q <= and_886_s25_q;
      equal_918_s26_q <= equal_918_s25_q;
      equal_919_s26_q <= equal_919_s25_q;
      and_929_s26_q <= and_929_s25_q;
      and_989_s26_q <= and_989_s25_q;
      less_990_s26_q <= less_990_s25_q;
      index_2_s26_q <= index_2_s25_q;
      sum_995_s26_q <= sum_995_s25_q;
      is_seen_s26_q <= is_seen;
      less_1048_s26_q <= less_1048_s25_q;
      and_1060_s26_q <= and_1060_s25_q;
      equal_1200_s26_q <= equal_1200_s25_q;
      sum_1203_s26_q <= sum_1203[13:5];
      not_1298_s26_q <= not_1298_s25_q;
      and_1385_s26_q <= and_1385_s25_q;
      and_1400_s26_q <= and_1400_s25_q;
      and_1405_s26_q <= and_1405_s25_q;
      equal_1408_s26_q <= equal_1408_s25_q;
      select_1419_s26_q <= select_1419_s25_q;
      and_1425_s26_q <= (~(select_1419_s25_q[11:4] == 8'h0)) & less_1424_s25_q;
      select_1451_s26_q <= less_376_s25_q ? 8'h0 : select_1450[7:0];
      and_1452_s26_q <= and_1452;
      sum_1453_s26_q <= {3{and_1452}} + 3'h1;
      and_1481_s26_q <= and_1481_s25_q;
      equal_1484_s26_q <= equal_1484_s25_q;
      equal_1485_s26_q <= equal_1485_s25_q;
      equal_1486_s26_q <= equal_1486_s25_q;
      residual_s26_q <= residual_s25_q;
      equal_1803_s26_q <= equal_1803_s25_q;
      and_1808_s26_q <= and_1808_s25_q;
      less_1809_s26_q <= less_1809_s25_q;
      and_1938_s26_q <= said_q;
      and_1953_s26_q <= and_1953;
      select_1969_s26_q <= select_1969_s25_q;
      select_1974_s26_q <= select_1974_s25_q;
      less_2026_s26_q <= less_2026_s25_q;
      less_2027_s26_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2029_s26_q <= less_2029_s25_q;
      or_2032_s26_q <= or_2032_s25_q;
      less_2034_s26_q <= less_2034_s25_q;
      or_2039_s26_q <= or_2039_s25_q;
      less_2040_s26_q <= less_2040_s25_q;
      or_2046_s26_q <= or_2046_s25_q;
      less_2052_s26_q <= less_2052_s25_q;
      or_2054_s26_q <= or_2054;
      select_2056_s26_q <= select_2056;
      select_2059_s26_q <= less_2029_s25_q ? select_2056 : select_2058;
      select_2079_s26_q <= select_2079;
      less_2081_s26_q <= less_2081;
      less_2084_s26_q <= less_2084;
      less_2087_s26_q <= less_2087;
      less_2090_s26_q <= less_2090;
      and_2134_s26_q <= equal_1803_s25_q & (cfg_prove_i & and_2132);
      select_2163_s26_q <= select_2163_s25_q;
      select_2168_s26_q <= select_2168_s25_q;
      select_2173_s26_q <= select_2173_s25_q;
      select_2178_s26_q <= select_2178_s25_q;
      select_2183_s26_q <= equal_373_s25_q ? 24'h0 : select_2182;
      select_2188_s26_q <= equal_373_s25_q ? 24'h0 : select_2187;
      and_2201_s26_q <= and_2201_s25_q;
      select_2206_s26_q <= select_2206_s25_q;
      select_2216_s26_q <= select_2216_s25_q;
      select_2222_s26_q <= select_2222_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic proven_q;
  // hls/stages/registration.hpp:28
  logic [9:0] sum_878;
  assign sum_878 = {sum_875_s26_q[8:0], not_876_s26_q} + {not_876_s26_q, xor_877_s26_q, not_876_s26_q};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_879;
  assign difference_879 = {sum_854_s26_q, select_820_s26_q, 5'h0} - {3'h0, difference_866_s26_q, sum_869_s26_q, sum_872_s26_q, sum_875_s26_q[9], sum_878[9]};
  // hls/stages/agreement.hpp:625
  logic and_1049;
  assign and_1049 = is_seen_s26_q & less_1048_s26_q;
  // hls/stages/agreement.hpp:617
  logic not_1410;
  assign not_1410 = ~is_seen_s26_q;
  // hls/stages/agreement.hpp:623
  logic and_1412;
  assign and_1412 = (~equal_1408_s26_q) & (centres_values_1_textured_s26_q & not_1410);
  // hls/stages/agreement.hpp:654
  logic [11:0] select_1427;
  assign select_1427 = equal_919_s26_q ? 12'h0 : (and_1425_s26_q ? select_1419_s26_q : 12'h0);
  // hls/stages/agreement.hpp:317
  logic [11:0] select_1428;
  assign select_1428 = equal_918_s26_q ? select_1427 : 12'h0;
  logic [11:0] select_1431;
  assign select_1431 = equal_373_s26_q ? 12'h0 : (equal_375_s26_q ? 12'h0 : (drew_s26_q ? 12'h0 : select_1428));
  // hls/stages/agreement.hpp:170
  logic [8:0] select_1443;
  assign select_1443 = less_376_s26_q ? 9'h0 : (and_929_s26_q ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0);
  // hls/stages/agreement.hpp:317
  logic [20:0] select_1444;
  assign select_1444 = drew_s26_q ? {{12{select_1443[8]}}, select_1443} : {1'b0, select_1428, 8'h0};
  logic [20:0] select_1446;
  assign select_1446 = equal_373_s26_q ? 21'h0 : (equal_375_s26_q ? 21'h0 : select_1444);
  // hls/stages/agreement.hpp:623
  logic [2:0] select_1455;
  assign select_1455 = centres_values_1_textured_s26_q ? (is_seen_s26_q ? {3{and_1452_s26_q}} : sum_1453_s26_q) : {3{and_1452_s26_q}};
  logic [2:0] select_1456;
  assign select_1456 = equal_1408_s26_q ? {3{and_1452_s26_q}} : select_1455;
  // hls/stages/agreement.hpp:317
  logic [10:0] select_1458;
  assign select_1458 = equal_375_s26_q ? 11'h0 : (drew_s26_q ? {select_1456, select_1451_s26_q} : 11'h0);
  // hls/stages/agreement.hpp:623
  logic [9:0] select_1463;
  assign select_1463 = centres_values_1_of_skin_s26_q ? ({1'b0, not_1410, 8'h0} - {2'h0, cfg_unproven_skin_limit_i}) : 10'h0;
  logic [9:0] select_1465;
  assign select_1465 = equal_1408_s26_q ? 10'h0 : (centres_values_1_textured_s26_q ? select_1463 : 10'h0);
  // hls/stages/agreement.hpp:317
  logic and_1998;
  assign and_1998 = equal_918_s26_q & (equal_1803_s26_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:658
  logic or_2080;
  assign or_2080 = (less_2026_s26_q ? select_2056_s26_q : select_2059_s26_q) | select_2079_s26_q;
  logic or_2082;
  assign or_2082 = less_2081_s26_q | or_2080;
  logic select_2083;
  assign select_2083 = or_2054_s26_q ? or_2080 : or_2082;
  logic or_2085;
  assign or_2085 = less_2084_s26_q | select_2083;
  logic select_2095;
  assign select_2095 = less_2040_s26_q ? or_2085 : (less_2052_s26_q ? or_2082 : select_2079_s26_q);
  // hls/stages/agreement.hpp:317
  logic and_2137;
  assign and_2137 = not_519_s26_q & (not_1298_s26_q & (equal_918_s26_q & and_2134_s26_q));
  logic [11:0] select_2208;
  assign select_2208 = equal_918_s26_q ? (equal_919_s26_q ? 12'h0 : select_1419_s26_q) : 12'h0;
  logic [11:0] select_2211;
  assign select_2211 = equal_373_s26_q ? 12'h0 : (equal_375_s26_q ? 12'h0 : (drew_s26_q ? 12'h0 : select_2208));

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_995_s26_q, index_2_s26_q};
  logic map_we;
  assign map_we = s26_en & and_1060_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1049, is_seen_s26_q};
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
    end else if (s26_en) begin
      proven_q <= marks_first_s26_q ? done_s26_q : proven_q;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic census_columns_values_1_cell_2_of_skin_s27_q;
  logic [23:0] sharpness_sums_contrast_0_s27_q;
  logic [23:0] sharpness_sums_contrast_1_s27_q;
  logic [6:0] column_s27_q;
  logic and_354_s27_q;
  logic equal_373_s27_q;
  logic not_374_s27_q;
  logic equal_375_s27_q;
  logic less_376_s27_q;
  logic less_381_s27_q;
  logic less_382_s27_q;
  logic less_383_s27_q;
  logic less_384_s27_q;
  logic less_385_s27_q;
  logic less_386_s27_q;
  logic less_387_s27_q;
  logic less_388_s27_q;
  logic less_389_s27_q;
  logic less_390_s27_q;
  logic less_391_s27_q;
  logic less_392_s27_q;
  logic less_393_s27_q;
  logic less_394_s27_q;
  logic less_395_s27_q;
  logic less_396_s27_q;
  logic less_397_s27_q;
  logic less_398_s27_q;
  logic less_399_s27_q;
  logic less_400_s27_q;
  logic less_401_s27_q;
  logic less_402_s27_q;
  logic less_403_s27_q;
  logic less_404_s27_q;
  logic and_412_s27_q;
  logic and_437_s27_q;
  logic and_438_s27_q;
  logic less_461_s27_q;
  logic drew_s27_q;
  logic [6:0] x_s27_q;
  logic not_519_s27_q;
  logic [7:0] best_left_rdata_s27_q;
  logic equal_524_s27_q;
  logic select_820_s27_q;
  logic less_826_s27_q;
  logic less_827_s27_q;
  logic or_829_s27_q;
  logic [7:0] select_833_s27_q;
  logic [5:0] select_837_s27_q;
  logic equal_842_s27_q;
  logic rise_s27_q;
  logic [1:0] sum_854_s27_q;
  logic difference_866_s27_q;
  logic sum_869_s27_q;
  logic sum_872_s27_q;
  logic sum_875_s27_q;
  logic sum_878_s27_q;
  logic [7:0] difference_879_s27_q;
  logic and_886_s27_q;
  logic equal_918_s27_q;
  logic and_989_s27_q;
  logic less_990_s27_q;
  logic [1:0] map_rdata_s27_q;
  logic is_seen_s27_q;
  logic and_1049_s27_q;
  logic equal_1200_s27_q;
  logic and_1205_s27_q;
  logic not_1298_s27_q;
  logic and_1385_s27_q;
  logic and_1400_s27_q;
  logic and_1405_s27_q;
  logic and_1415_s27_q;
  logic [11:0] select_1431_s27_q;
  logic [20:0] select_1446_s27_q;
  logic [10:0] select_1459_s27_q;
  logic [9:0] select_1466_s27_q;
  logic and_1481_s27_q;
  logic equal_1484_s27_q;
  logic equal_1485_s27_q;
  logic equal_1486_s27_q;
  logic [7:0] residual_s27_q;
  logic equal_1803_s27_q;
  logic and_1808_s27_q;
  logic less_1809_s27_q;
  logic [35:0] detail_left_s27_q;
  logic [35:0] detail_right_s27_q;
  logic and_1938_s27_q;
  logic and_1953_s27_q;
  logic [13:0] select_1969_s27_q;
  logic [13:0] select_1974_s27_q;
  logic and_2001_s27_q;
  logic less_2026_s27_q;
  logic less_2027_s27_q;
  logic less_2029_s27_q;
  logic or_2032_s27_q;
  logic less_2034_s27_q;
  logic or_2039_s27_q;
  logic select_2086_s27_q;
  logic less_2087_s27_q;
  logic less_2090_s27_q;
  logic select_2095_s27_q;
  logic [36:0] sum_2106_s27_q;
  logic [36:0] sum_2118_s27_q;
  logic and_2138_s27_q;
  logic [11:0] select_2163_s27_q;
  logic [11:0] select_2168_s27_q;
  logic [11:0] select_2173_s27_q;
  logic [11:0] select_2178_s27_q;
  logic [23:0] select_2183_s27_q;
  logic [23:0] select_2188_s27_q;
  logic and_2201_s27_q;
  logic [5:0] select_2206_s27_q;
  logic [11:0] select_2211_s27_q;
  logic [11:0] select_2216_s27_q;
  logic [11:0] select_2222_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      census_columns_values_1_cell_2_of_skin_s27_q <= census_columns_values_1_cell_2_of_skin_s26_q;
      sharpness_sums_contrast_0_s27_q <= sharpness_sums_contrast_0_s26_q;
      sharpness_sums_contrast_1_s27_q <= sharpness_sums_contrast_1_s26_q;
      column_s27_q <= column_s26_q;
      and_354_s27_q <= and_354_s26_q;
      equal_373_s27_q <= equal_373_s26_q;
      not_374_s27_q <= not_374_s26_q;
      equal_375_s27_q <= equal_375_s26_q;
      less_376_s27_q <= less_376_s26_q;
      less_381_s27_q <= less_381_s26_q;
      less_382_s27_q <= less_382_s26_q;
      less_383_s27_q <= less_383_s26_q;
      less_384_s27_q <= less_384_s26_q;
      less_385_s27_q <= less_385_s26_q;
      less_386_s27_q <= less_386_s26_q;
      less_387_s27_q <= less_387_s26_q;
      less_388_s27_q <= less_388_s26_q;
      less_389_s27_q <= less_389_s26_q;
      less_390_s27_q <= less_390_s26_q;
      less_391_s27_q <= less_391_s26_q;
      less_392_s27_q <= less_392_s26_q;
      less_393_s27_q <= less_393_s26_q;
      less_394_s27_q <= less_394_s26_q;
      less_395_s27_q <= less_395_s26_q;
      less_396_s27_q <= less_396_s26_q;
      less_397_s27_q <= less_397_s26_q;
      less_398_s27_q <= less_398_s26_q;
      less_399_s27_q <= less_399_s26_q;
      less_400_s27_q <= less_400_s26_q;
      less_401_s27_q <= less_401_s26_q;
      less_402_s27_q <= less_402_s26_q;
      less_403_s27_q <= less_403_s26_q;
      less_404_s27_q <= less_404_s26_q;
      and_412_s27_q <= and_412_s26_q;
      and_437_s27_q <= and_437_s26_q;
      and_438_s27_q <= and_438_s26_q;
      less_461_s27_q <= 9'h4 < sum_460_s26_q;
      drew_s27_q <= drew_s26_q;
      x_s27_q <= x_s26_q;
      not_519_s27_q <= not_519_s26_q;
      best_left_rdata_s27_q <= best_left_rdata_s26_q;
      equal_524_s27_q <= equal_524_s26_q;
      select_820_s27_q <= select_820_s26_q;
      less_826_s27_q <= less_826_s26_q;
      less_827_s27_q <= less_827_s26_q;
      or_829_s27_q <= or_829_s26_q;
      select_833_s27_q <= select_833_s26_q;
      select_837_s27_q <= select_837_s26_q;
      equal_842_s27_q <= equal_842_s26_q;
      rise_s27_q <= rise_s26_q;
      sum_854_s27_q <= sum_854_s26_q;
      difference_866_s27_q <= difference_866_s26_q;
      sum_869_s27_q <= sum_869_s26_q;
      sum_872_s27_q <= sum_872_s26_q;
      sum_875_s27_q <= sum_875_s26_q[9];
      sum_878_s27_q <= sum_878[9];
      difference_879_s27_q <= difference_879;
      and_886_s27_q <= and_886_s26_q;
      equal_918_s27_q <= equal_918_s26_q;
      and_989_s27_q <= and_989_s26_q;
      less_990_s27_q <= less_990_s26_q;
      map_rdata_s27_q <= map_rdata_q;
      is_seen_s27_q <= is_seen_s26_q;
      and_1049_s27_q <= and_1049;
      equal_1200_s27_q <= equal_1200_s26_q;
      and_1205_s27_q <= and_437_s26_q & (9'h4 < sum_1203_s26_q);
      not_1298_s27_q <= not_1298_s26_q;
      and_1385_s27_q <= and_1385_s26_q;
      and_1400_s27_q <= and_1400_s26_q;
      and_1405_s27_q <= and_1405_s26_q;
      and_1415_s27_q <= not_374_s26_q & (not_519_s26_q & (drew_s26_q & and_1412));
      select_1431_s27_q <= select_1431;
      select_1446_s27_q <= select_1446;
      select_1459_s27_q <= equal_373_s26_q ? 11'h0 : select_1458;
      select_1466_s27_q <= drew_s26_q ? select_1465 : 10'h0;
      and_1481_s27_q <= and_1481_s26_q;
      equal_1484_s27_q <= equal_1484_s26_q;
      equal_1485_s27_q <= equal_1485_s26_q;
      equal_1486_s27_q <= equal_1486_s26_q;
      residual_s27_q <= residual_s26_q;
      equal_1803_s27_q <= equal_1803_s26_q;
      and_1808_s27_q <= and_1808_s26_q;
      less_1809_s27_q <= less_1809_s26_q;
      detail_left_s27_q <= product_0_q;
      detail_right_s27_q <= product_1_q;
      and_1938_s27_q <= and_1938_s26_q;
      and_1953_s27_q <= and_1953_s26_q;
      select_1969_s27_q <= select_1969_s26_q;
      select_1974_s27_q <= select_1974_s26_q;
      and_2001_s27_q <= not_374_s26_q & (not_519_s26_q & (not_1298_s26_q & and_1998));
      less_2026_s27_q <= less_2026_s26_q;
      less_2027_s27_q <= less_2027_s26_q;
      less_2029_s27_q <= less_2029_s26_q;
      or_2032_s27_q <= or_2032_s26_q;
      less_2034_s27_q <= less_2034_s26_q;
      or_2039_s27_q <= or_2039_s26_q;
      select_2086_s27_q <= or_2046_s26_q ? select_2083 : or_2085;
      less_2087_s27_q <= less_2087_s26_q;
      less_2090_s27_q <= less_2090_s26_q;
      select_2095_s27_q <= select_2095;
      sum_2106_s27_q <= {1'b0, product_1_q} + {3'h0, product_1_q[35:2]};
      sum_2118_s27_q <= {1'b0, product_0_q} + {3'h0, product_0_q[35:2]};
      and_2138_s27_q <= not_374_s26_q & and_2137;
      select_2163_s27_q <= select_2163_s26_q;
      select_2168_s27_q <= select_2168_s26_q;
      select_2173_s27_q <= select_2173_s26_q;
      select_2178_s27_q <= select_2178_s26_q;
      select_2183_s27_q <= select_2183_s26_q;
      select_2188_s27_q <= select_2188_s26_q;
      and_2201_s27_q <= and_2201_s26_q;
      select_2206_s27_q <= select_2206_s26_q;
      select_2211_s27_q <= select_2211;
      select_2216_s27_q <= select_2216_s26_q;
      select_2222_s27_q <= select_2222_s26_q;
    end
  end

  // Stage 27 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [23:0] counts_too_many_bad_q;
  logic [23:0] counts_too_much_unproven_q;
  logic [23:0] counts_too_much_unseen_skin_q;
  // hls/stages/census.hpp:223
  logic and_462;
  assign and_462 = and_412_s27_q & less_461_s27_q;
  // hls/stages/agreement.hpp:446
  logic [7:0] select_880;
  assign select_880 = rise_s27_q ? difference_879_s27_q : {sum_854_s27_q, select_820_s27_q, difference_866_s27_q, sum_869_s27_q, sum_872_s27_q, sum_875_s27_q, sum_878_s27_q};
  logic [7:0] select_881;
  assign select_881 = equal_842_s27_q ? select_880 : {sum_854_s27_q, select_820_s27_q, 5'h0};
  // hls/stages/agreement.hpp:448
  logic [7:0] select_884;
  assign select_884 = less_826_s27_q ? (or_829_s27_q ? select_881 : best_left_rdata_s27_q) : (less_827_s27_q ? select_881 : best_left_rdata_s27_q);
  // hls/stages/census.hpp:226
  logic and_1206;
  assign and_1206 = and_437_s27_q & less_461_s27_q;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1207;
  assign sum_1207 = census_left_misses_q + {{17{and_1206}}, and_1205_s27_q, 1'b0, and_1205_s27_q};
  // hls/stages/agreement.hpp:184
  logic [19:0] select_1209;
  assign select_1209 = and_354_s27_q ? (equal_1200_s27_q ? 20'h0 : sum_1207) : census_left_misses_q;
  // hls/stages/agreement.hpp:504
  logic [23:0] sum_1447;
  assign sum_1447 = counts_too_many_bad_q + {{3{select_1446_s27_q[20]}}, select_1446_s27_q};
  // hls/stages/agreement.hpp:505
  logic [23:0] sum_1460;
  assign sum_1460 = counts_too_much_unproven_q + {{13{select_1459_s27_q[10]}}, select_1459_s27_q};
  // hls/stages/agreement.hpp:317
  logic [9:0] select_1468;
  assign select_1468 = equal_373_s27_q ? 10'h0 : (equal_375_s27_q ? 10'h0 : select_1466_s27_q);
  // hls/stages/agreement.hpp:506
  logic [23:0] sum_1469;
  assign sum_1469 = counts_too_much_unseen_skin_q + {{14{select_1468[9]}}, select_1468};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1524;
  assign select_1524 = equal_1485_s27_q ? 8'h0 : (equal_1486_s27_q ? 8'h0 : residual_s27_q);
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1527;
  assign select_1527 = less_376_s27_q ? 8'h0 : (and_1481_s27_q ? (equal_1484_s27_q ? 8'h0 : select_1524) : 8'h0);
  // hls/stages/registration.hpp:80
  logic [7:0] select_1534;
  assign select_1534 = equal_1485_s27_q ? 8'h0 : (equal_1486_s27_q ? residual_s27_q : 8'h0);
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1537;
  assign select_1537 = less_376_s27_q ? 8'h0 : (and_1481_s27_q ? (equal_1484_s27_q ? 8'h0 : select_1534) : 8'h0);
  // hls/stages/registration.hpp:80
  logic [7:0] select_1544;
  assign select_1544 = equal_1484_s27_q ? 8'h0 : (equal_1485_s27_q ? residual_s27_q : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1547;
  assign select_1547 = drew_s27_q ? (less_376_s27_q ? 8'h0 : (and_1481_s27_q ? select_1544 : 8'h0)) : 8'h0;
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1553;
  assign select_1553 = and_1481_s27_q ? (equal_1484_s27_q ? residual_s27_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1556;
  assign select_1556 = equal_375_s27_q ? 8'h0 : (drew_s27_q ? (less_376_s27_q ? 8'h0 : select_1553) : 8'h0);
  // hls/stages/agreement.hpp:763
  logic [1:0] select_1954;
  assign select_1954 = and_1953_s27_q ? {and_1049_s27_q, is_seen_s27_q} : map_rdata_s27_q;
  // hls/stages/agreement.hpp:764
  logic and_1955;
  assign and_1955 = proven_q & less_1943;
  // hls/stages/agreement.hpp:691
  logic not_2002;
  assign not_2002 = ~and_1808_s27_q;
  // hls/stages/agreement.hpp:317
  logic and_2006;
  assign and_2006 = not_1298_s27_q & (equal_918_s27_q & (equal_1803_s27_q & (cfg_prove_i & not_2002)));
  // hls/stages/agreement.hpp:692
  logic or_2009;
  assign or_2009 = not_1962 | not_2002;
  // hls/stages/agreement.hpp:658
  logic or_2015;
  assign or_2015 = ($signed(24'h0) < $signed(counts_too_much_unproven_q)) | ($signed(24'h0) < $signed(counts_too_much_unseen_skin_q));
  logic or_2088;
  assign or_2088 = less_2087_s27_q | select_2086_s27_q;
  logic select_2089;
  assign select_2089 = or_2039_s27_q ? select_2086_s27_q : or_2088;
  logic or_2091;
  assign or_2091 = less_2090_s27_q | select_2089;
  logic select_2097;
  assign select_2097 = less_2029_s27_q ? or_2091 : (less_2034_s27_q ? or_2088 : select_2095_s27_q);
  logic select_2098;
  assign select_2098 = less_2026_s27_q ? (less_2027_s27_q | (or_2032_s27_q ? select_2089 : or_2091)) : select_2097;
  // hls/stages/agreement.hpp:699
  logic and_2105;
  assign and_2105 = cfg_prove_i & and_1808_s27_q;
  // hls/stages/agreement.hpp:700
  logic less_2107;
  assign less_2107 = {detail_left_s27_q, 3'h0} < {sum_2106_s27_q, detail_right_s27_q[1:0]};
  logic less_2108;
  assign less_2108 = {sharpness_sums_contrast_0_s27_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_s27_q};
  // hls/stages/agreement.hpp:658
  logic or_2111;
  assign or_2111 = less_2107 | (less_2108 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:703
  logic less_2119;
  assign less_2119 = {detail_right_s27_q, 3'h0} < {sum_2118_s27_q, detail_left_s27_q[1:0]};
  logic less_2120;
  assign less_2120 = {sharpness_sums_contrast_1_s27_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_s27_q};
  // hls/stages/agreement.hpp:317
  logic [23:0] select_2190;
  assign select_2190 = equal_918_s27_q ? (equal_1803_s27_q ? sharpness_sums_contrast_0_s27_q : 24'h0) : 24'h0;
  logic [23:0] select_2193;
  assign select_2193 = equal_373_s27_q ? 24'h0 : (equal_375_s27_q ? 24'h0 : (drew_s27_q ? 24'h0 : select_2190));
  logic [23:0] select_2195;
  assign select_2195 = equal_918_s27_q ? (equal_1803_s27_q ? sharpness_sums_contrast_1_s27_q : 24'h0) : 24'h0;
  logic [23:0] select_2198;
  assign select_2198 = equal_373_s27_q ? 24'h0 : (equal_375_s27_q ? 24'h0 : (drew_s27_q ? 24'h0 : select_2195));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s27_q;
  logic fresh_we;
  assign fresh_we = s27_en & and_354_s27_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s27_q, and_462, and_438_s27_q, and_437_s27_q, and_412_s27_q, less_404_s27_q, less_403_s27_q, less_402_s27_q, less_401_s27_q, less_400_s27_q, less_399_s27_q, less_398_s27_q, less_397_s27_q, less_396_s27_q, less_395_s27_q, less_394_s27_q, less_393_s27_q, less_392_s27_q, less_391_s27_q, less_390_s27_q, less_389_s27_q, less_388_s27_q, less_387_s27_q, less_386_s27_q, less_385_s27_q, less_384_s27_q, less_383_s27_q, less_382_s27_q, less_381_s27_q};
  end
`ifndef SYNTHESIS
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
  logic [6:0] fresh_raddr_s25_sim;
  logic fresh_re_s25_sim;
  logic [6:0] fresh_raddr_s26_sim;
  logic fresh_re_s26_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      fresh_re_s25_sim <= 1'b0;
      fresh_re_s26_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s6_sim <= fresh_re;
      fresh_raddr_s6_sim <= fresh_raddr;
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
      fresh_re_s25_sim <= fresh_re_s24_sim;
      fresh_raddr_s25_sim <= fresh_raddr_s24_sim;
      fresh_re_s26_sim <= fresh_re_s25_sim;
      fresh_raddr_s26_sim <= fresh_raddr_s25_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && fresh_we) begin
      if (fresh_re && fresh_raddr == fresh_waddr) begin
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
      if (fresh_re_s25_sim && fresh_raddr_s25_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s26_sim && fresh_raddr_s26_sim == fresh_waddr) begin
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
      counts_too_much_unseen_skin_q <= 24'h0;
    end else if (s27_en) begin
      census_left_misses_q <= select_1209;
      counts_too_many_bad_q <= and_1385_s27_q ? 24'h0 : sum_1447;
      counts_too_much_unproven_q <= and_1385_s27_q ? 24'h0 : sum_1460;
      counts_too_much_unseen_skin_q <= and_1385_s27_q ? 24'h0 : sum_1469;
    end
  end

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic equal_373_s28_q;
  logic not_374_s28_q;
  logic equal_375_s28_q;
  logic drew_s28_q;
  logic [6:0] x_s28_q;
  logic not_519_s28_q;
  logic [7:0] select_833_s28_q;
  logic [5:0] select_837_s28_q;
  logic [7:0] select_885_s28_q;
  logic and_886_s28_q;
  logic equal_918_s28_q;
  logic and_989_s28_q;
  logic less_990_s28_q;
  logic not_1298_s28_q;
  logic and_1385_s28_q;
  logic and_1400_s28_q;
  logic and_1405_s28_q;
  logic and_1415_s28_q;
  logic [11:0] select_1431_s28_q;
  logic [7:0] select_1529_s28_q;
  logic [7:0] select_1539_s28_q;
  logic [7:0] select_1549_s28_q;
  logic [7:0] select_1557_s28_q;
  logic equal_1803_s28_q;
  logic and_1938_s28_q;
  logic and_1956_s28_q;
  logic and_1959_s28_q;
  logic [13:0] select_1969_s28_q;
  logic [13:0] select_1974_s28_q;
  logic and_2001_s28_q;
  logic and_2008_s28_q;
  logic or_2010_s28_q;
  logic not_2011_s28_q;
  logic or_2016_s28_q;
  logic select_2098_s28_q;
  logic and_2112_s28_q;
  logic and_2122_s28_q;
  logic and_2138_s28_q;
  logic [11:0] select_2163_s28_q;
  logic [11:0] select_2168_s28_q;
  logic [11:0] select_2173_s28_q;
  logic [11:0] select_2178_s28_q;
  logic [23:0] select_2183_s28_q;
  logic [23:0] select_2188_s28_q;
  logic [23:0] select_2193_s28_q;
  logic [23:0] select_2198_s28_q;
  logic and_2201_s28_q;
  logic [5:0] select_2206_s28_q;
  logic [11:0] select_2211_s28_q;
  logic [11:0] select_2216_s28_q;
  logic [11:0] select_2222_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      equal_373_s28_q <= equal_373_s27_q;
      not_374_s28_q <= not_374_s27_q;
      equal_375_s28_q <= equal_375_s27_q;
      drew_s28_q <= drew_s27_q;
      x_s28_q <= x_s27_q;
      not_519_s28_q <= not_519_s27_q;
      select_833_s28_q <= select_833_s27_q;
      select_837_s28_q <= select_837_s27_q;
      select_885_s28_q <= equal_524_s27_q ? select_881 : select_884;
      and_886_s28_q <= and_886_s27_q;
      equal_918_s28_q <= equal_918_s27_q;
      and_989_s28_q <= and_989_s27_q;
      less_990_s28_q <= less_990_s27_q;
      not_1298_s28_q <= not_1298_s27_q;
      and_1385_s28_q <= and_1385_s27_q;
      and_1400_s28_q <= and_1400_s27_q;
      and_1405_s28_q <= and_1405_s27_q;
      and_1415_s28_q <= and_1415_s27_q;
      select_1431_s28_q <= select_1431_s27_q;
      select_1529_s28_q <= equal_375_s27_q ? 8'h0 : (drew_s27_q ? select_1527 : 8'h0);
      select_1539_s28_q <= equal_375_s27_q ? 8'h0 : (drew_s27_q ? select_1537 : 8'h0);
      select_1549_s28_q <= equal_373_s27_q ? 8'h0 : (equal_375_s27_q ? 8'h0 : select_1547);
      select_1557_s28_q <= equal_373_s27_q ? 8'h0 : select_1556;
      equal_1803_s28_q <= equal_1803_s27_q;
      and_1938_s28_q <= and_1938_s27_q;
      and_1956_s28_q <= select_1954[0] & and_1955;
      and_1959_s28_q <= select_1954[1] & and_1955;
      select_1969_s28_q <= select_1969_s27_q;
      select_1974_s28_q <= select_1974_s27_q;
      and_2001_s28_q <= and_2001_s27_q;
      and_2008_s28_q <= not_374_s27_q & (not_519_s27_q & and_2006);
      or_2010_s28_q <= less_1809_s27_q | or_2009;
      not_2011_s28_q <= ~or_2009;
      or_2016_s28_q <= ($signed(24'h0) < $signed(counts_too_many_bad_q)) | or_2015;
      select_2098_s28_q <= select_2098;
      and_2112_s28_q <= and_2105 & or_2111;
      and_2122_s28_q <= and_2105 & (less_2119 | less_2120);
      and_2138_s28_q <= and_2138_s27_q;
      select_2163_s28_q <= select_2163_s27_q;
      select_2168_s28_q <= select_2168_s27_q;
      select_2173_s28_q <= select_2173_s27_q;
      select_2178_s28_q <= select_2178_s27_q;
      select_2183_s28_q <= select_2183_s27_q;
      select_2188_s28_q <= select_2188_s27_q;
      select_2193_s28_q <= select_2193;
      select_2198_s28_q <= select_2198;
      and_2201_s28_q <= and_2201_s27_q;
      select_2206_s28_q <= select_2206_s27_q;
      select_2211_s28_q <= select_2211_s27_q;
      select_2216_s28_q <= select_2216_s27_q;
      select_2222_s28_q <= select_2222_s27_q;
    end
  end

  // Stage 28 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:508
  logic [13:0] select_1402;
  assign select_1402 = and_1385_s28_q ? 14'h0 : (counts_explained_q + {13'h0, and_1400_s28_q});
  logic [13:0] select_1407;
  assign select_1407 = and_1385_s28_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1405_s28_q});
  logic [13:0] select_1417;
  assign select_1417 = and_1385_s28_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1415_s28_q});
  logic [13:0] select_1433;
  assign select_1433 = and_1385_s28_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1431_s28_q});
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1530;
  assign select_1530 = equal_373_s28_q ? 8'h0 : select_1529_s28_q;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1531;
  assign sum_1531 = registration_counts_across_0_q + {{12{select_1530[7]}}, select_1530};
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1540;
  assign select_1540 = equal_373_s28_q ? 8'h0 : select_1539_s28_q;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1541;
  assign sum_1541 = registration_counts_across_1_q + {{12{select_1540[7]}}, select_1540};
  logic [19:0] sum_1550;
  assign sum_1550 = registration_counts_across_2_q + {{12{select_1549_s28_q[7]}}, select_1549_s28_q};
  logic [19:0] sum_1558;
  assign sum_1558 = registration_counts_across_3_q + {{12{select_1557_s28_q[7]}}, select_1557_s28_q};
  // hls/stages/agreement.hpp:187
  logic select_1958;
  assign select_1958 = and_989_s28_q ? (less_990_s28_q ? and_1956_s28_q : seen_q) : seen_q;
  logic select_1961;
  assign select_1961 = and_989_s28_q ? (less_990_s28_q ? and_1959_s28_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:317
  logic [13:0] select_1976;
  assign select_1976 = equal_918_s28_q ? (equal_1803_s28_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_1979;
  assign select_1979 = equal_373_s28_q ? 14'h0 : (equal_375_s28_q ? 14'h0 : (drew_s28_q ? 14'h0 : select_1976));
  logic [13:0] select_1981;
  assign select_1981 = equal_918_s28_q ? (equal_1803_s28_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_1984;
  assign select_1984 = equal_373_s28_q ? 14'h0 : (equal_375_s28_q ? 14'h0 : (drew_s28_q ? 14'h0 : select_1981));
  logic [13:0] select_1986;
  assign select_1986 = equal_918_s28_q ? (equal_1803_s28_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_1989;
  assign select_1989 = equal_373_s28_q ? 14'h0 : (equal_375_s28_q ? 14'h0 : (drew_s28_q ? 14'h0 : select_1986));
  logic [13:0] select_1991;
  assign select_1991 = equal_918_s28_q ? (equal_1803_s28_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic [13:0] select_1994;
  assign select_1994 = equal_373_s28_q ? 14'h0 : (equal_375_s28_q ? 14'h0 : (drew_s28_q ? 14'h0 : select_1991));
  logic and_2018;
  assign and_2018 = equal_1803_s28_q & (or_2010_s28_q ? not_2011_s28_q : or_2016_s28_q);
  logic and_2022;
  assign and_2022 = not_374_s28_q & (not_519_s28_q & (not_1298_s28_q & (equal_918_s28_q & and_2018)));
  logic and_2101;
  assign and_2101 = equal_918_s28_q & (equal_1803_s28_q & (cfg_prove_i & select_2098_s28_q));
  logic and_2115;
  assign and_2115 = not_1298_s28_q & (equal_918_s28_q & (equal_1803_s28_q & and_2112_s28_q));
  logic and_2125;
  assign and_2125 = not_1298_s28_q & (equal_918_s28_q & (equal_1803_s28_q & and_2122_s28_q));
  logic [19:0] select_2140;
  assign select_2140 = equal_918_s28_q ? (equal_1803_s28_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2143;
  assign select_2143 = equal_373_s28_q ? 20'h0 : (equal_375_s28_q ? 20'h0 : (drew_s28_q ? 20'h0 : select_2140));
  logic [19:0] select_2145;
  assign select_2145 = equal_918_s28_q ? (equal_1803_s28_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2148;
  assign select_2148 = equal_373_s28_q ? 20'h0 : (equal_375_s28_q ? 20'h0 : (drew_s28_q ? 20'h0 : select_2145));
  logic [19:0] select_2150;
  assign select_2150 = equal_918_s28_q ? (equal_1803_s28_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2153;
  assign select_2153 = equal_373_s28_q ? 20'h0 : (equal_375_s28_q ? 20'h0 : (drew_s28_q ? 20'h0 : select_2150));
  logic [19:0] select_2155;
  assign select_2155 = equal_918_s28_q ? (equal_1803_s28_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [19:0] select_2158;
  assign select_2158 = equal_373_s28_q ? 20'h0 : (equal_375_s28_q ? 20'h0 : (drew_s28_q ? 20'h0 : select_2155));

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s28_q;
  logic best_left_we;
  assign best_left_we = s28_en & and_886_s28_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_885_s28_q, select_837_s28_q, select_833_s28_q};
  end
`ifndef SYNTHESIS
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
  logic [6:0] best_left_raddr_s26_sim;
  logic best_left_re_s26_sim;
  logic [6:0] best_left_raddr_s27_sim;
  logic best_left_re_s27_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      best_left_re_s26_sim <= 1'b0;
      best_left_re_s27_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s12_sim <= best_left_re;
      best_left_raddr_s12_sim <= best_left_raddr;
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
      best_left_re_s26_sim <= best_left_re_s25_sim;
      best_left_raddr_s26_sim <= best_left_raddr_s25_sim;
      best_left_re_s27_sim <= best_left_re_s26_sim;
      best_left_raddr_s27_sim <= best_left_raddr_s26_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
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
      if (best_left_re_s26_sim && best_left_raddr_s26_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s27_sim && best_left_raddr_s27_sim == best_left_waddr) begin
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
    end else if (s28_en) begin
      counts_explained_q <= select_1402;
      counts_nearer_q <= select_1407;
      counts_unproven_q <= select_1417;
      counts_regions_bad_q <= select_1433;
      registration_counts_across_0_q <= and_1385_s28_q ? 20'h0 : sum_1531;
      registration_counts_across_1_q <= and_1385_s28_q ? 20'h0 : sum_1541;
      registration_counts_across_2_q <= and_1385_s28_q ? 20'h0 : sum_1550;
      registration_counts_across_3_q <= and_1385_s28_q ? 20'h0 : sum_1558;
      seen_q <= select_1958;
      nearer_q <= select_1961;
    end
  end

  logic [7:0] pixel_0_s29_q;
  logic [7:0] pixel_1_s29_q;
  logic saturated_s29_q;
  logic mask_s29_q;
  logic marks_first_s29_q;
  logic marks_last_s29_q;
  logic and_1938_s29_q;
  logic or_1963_s29_q;
  logic and_1964_s29_q;
  logic [13:0] select_1969_s29_q;
  logic [13:0] select_1974_s29_q;
  logic [13:0] select_1979_s29_q;
  logic [13:0] select_1984_s29_q;
  logic [13:0] select_1989_s29_q;
  logic [13:0] select_1994_s29_q;
  logic and_2001_s29_q;
  logic and_2008_s29_q;
  logic and_2022_s29_q;
  logic and_2104_s29_q;
  logic and_2117_s29_q;
  logic and_2127_s29_q;
  logic and_2138_s29_q;
  logic [19:0] select_2143_s29_q;
  logic [19:0] select_2148_s29_q;
  logic [19:0] select_2153_s29_q;
  logic [19:0] select_2158_s29_q;
  logic [11:0] select_2163_s29_q;
  logic [11:0] select_2168_s29_q;
  logic [11:0] select_2173_s29_q;
  logic [11:0] select_2178_s29_q;
  logic [23:0] select_2183_s29_q;
  logic [23:0] select_2188_s29_q;
  logic [23:0] select_2193_s29_q;
  logic [23:0] select_2198_s29_q;
  logic and_2201_s29_q;
  logic [5:0] select_2206_s29_q;
  logic [11:0] select_2211_s29_q;
  logic [11:0] select_2216_s29_q;
  logic [11:0] select_2222_s29_q;
  always_ff @(posedge clk_i) begin
    if (s28_en) begin
      pixel_0_s29_q <= pixel_0_s28_q;
      pixel_1_s29_q <= pixel_1_s28_q;
      saturated_s29_q <= saturated_s28_q;
      mask_s29_q <= mask_s28_q;
      marks_first_s29_q <= marks_first_s28_q;
      marks_last_s29_q <= marks_last_s28_q;
      and_1938_s29_q <= and_1938_s28_q;
      or_1963_s29_q <= not_1962 | select_1958;
      and_1964_s29_q <= cfg_prove_i & select_1961;
      select_1969_s29_q <= select_1969_s28_q;
      select_1974_s29_q <= select_1974_s28_q;
      select_1979_s29_q <= select_1979;
      select_1984_s29_q <= select_1984;
      select_1989_s29_q <= select_1989;
      select_1994_s29_q <= select_1994;
      and_2001_s29_q <= and_2001_s28_q;
      and_2008_s29_q <= and_2008_s28_q;
      and_2022_s29_q <= and_2022;
      and_2104_s29_q <= not_374_s28_q & (not_519_s28_q & (not_1298_s28_q & and_2101));
      and_2117_s29_q <= not_374_s28_q & (not_519_s28_q & and_2115);
      and_2127_s29_q <= not_374_s28_q & (not_519_s28_q & and_2125);
      and_2138_s29_q <= and_2138_s28_q;
      select_2143_s29_q <= select_2143;
      select_2148_s29_q <= select_2148;
      select_2153_s29_q <= select_2153;
      select_2158_s29_q <= select_2158;
      select_2163_s29_q <= select_2163_s28_q;
      select_2168_s29_q <= select_2168_s28_q;
      select_2173_s29_q <= select_2173_s28_q;
      select_2178_s29_q <= select_2178_s28_q;
      select_2183_s29_q <= select_2183_s28_q;
      select_2188_s29_q <= select_2188_s28_q;
      select_2193_s29_q <= select_2193_s28_q;
      select_2198_s29_q <= select_2198_s28_q;
      and_2201_s29_q <= and_2201_s28_q;
      select_2206_s29_q <= select_2206_s28_q;
      select_2211_s29_q <= select_2211_s28_q;
      select_2216_s29_q <= select_2216_s28_q;
      select_2222_s29_q <= select_2222_s28_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s29_q;
  assign pixel_1_o = pixel_1_s29_q;
  assign saturated_o = saturated_s29_q;
  assign mask_o = mask_s29_q;
  assign marks_first_o = marks_first_s29_q;
  assign marks_last_o = marks_last_s29_q;
  assign marks_seen_o = or_1963_s29_q;
  assign marks_nearer_o = and_1964_s29_q;
  assign verdict_valid_o = and_1938_s29_q;
  assign verdict_supervised_o = {2'h0, select_1969_s29_q};
  assign verdict_textured_o = {2'h0, select_1974_s29_q};
  assign verdict_explained_o = {2'h0, select_1979_s29_q};
  assign verdict_nearer_o = {2'h0, select_1984_s29_q};
  assign verdict_unproven_o = {2'h0, select_1989_s29_q};
  assign verdict_regions_bad_o = {2'h0, select_1994_s29_q};
  assign verdict_unproven_yet_o = and_2001_s29_q;
  assign verdict_untextured_o = and_2008_s29_q;
  assign verdict_disagree_o = and_2022_s29_q;
  assign verdict_moved_o = and_2104_s29_q;
  assign verdict_unsharp_left_o = and_2117_s29_q;
  assign verdict_unsharp_right_o = and_2127_s29_q;
  assign verdict_hidden_o = and_2138_s29_q;
  assign verdict_across_0_o = select_2143_s29_q;
  assign verdict_across_1_o = select_2148_s29_q;
  assign verdict_across_2_o = select_2153_s29_q;
  assign verdict_across_3_o = select_2158_s29_q;
  assign verdict_measured_0_o = select_2163_s29_q;
  assign verdict_measured_1_o = select_2168_s29_q;
  assign verdict_measured_2_o = select_2173_s29_q;
  assign verdict_measured_3_o = select_2178_s29_q;
  assign verdict_detail_0_o = select_2183_s29_q;
  assign verdict_detail_1_o = select_2188_s29_q;
  assign verdict_contrast_0_o = select_2193_s29_q;
  assign verdict_contrast_1_o = select_2198_s29_q;
  assign region_valid_o = and_2201_s29_q;
  assign region_region_o = select_2206_s29_q;
  assign region_textured_o = select_2211_s29_q;
  assign region_explained_o = select_2216_s29_q;
  assign region_nearer_o = select_2222_s29_q;
  assign valid_o = valid_s29_q;

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
      valid_s28_q <= 1'b0;
      valid_s29_q <= 1'b0;
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
      valid_s28_q <= valid_s27_q;
      valid_s29_q <= valid_s28_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{right[1:0], left[1:0], sum_2025[2:0], sum_1513[0], sum_1509[0], sum_1501[1:0], sum_1500[1:0], sum_1496[0], detail_4[1:0], detail_3[1:0], sum_1203[4:0], sum_878[8:0], sum_460[4:0], cfg_width_i[3:0]};

endmodule
