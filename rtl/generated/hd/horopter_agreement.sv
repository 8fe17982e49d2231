// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 30 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2576 bits, pipeline 7887 bits, memories 88704 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q, valid_s27_q, valid_s28_q, valid_s29_q, valid_s30_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en, s26_en, s27_en, s28_en, s29_en;
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
  assign s29_en = en_i & valid_s29_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [6:0] sum_1370;
  assign sum_1370 = {1'b0, cfg_width_i[10:5]} + 7'h11;
  logic [6:0] sum_1385;
  assign sum_1385 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] difference_1863;
  assign difference_1863 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_2006;
  assign less_2006 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_2007;
  assign sum_2007 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_2025;
  assign not_2025 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic [3:0] raster_at_y_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_318;
  assign select_318 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);
  // hls/stages/census.hpp:40
  logic [3:0] select_339;
  assign select_339 = sample_pair_first_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:204
  logic [3:0] select_1105;
  assign select_1105 = sample_pair_whole_q ? (sample_last_q ? (select_339 + 4'h1) : select_339) : raster_at_y_q;

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
      raster_at_x_q <= sample_pair_whole_q ? (select_318 + 4'h1) : raster_at_x_q;
      raster_at_y_q <= select_1105;
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
  logic [3:0] select_318_s1_q;
  logic equal_340_s1_q;
  logic equal_357_s1_q;
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
      select_318_s1_q <= select_318;
      equal_340_s1_q <= select_339 == 4'h0;
      equal_357_s1_q <= select_339 == 4'hf;
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
  logic equal_319;
  assign equal_319 = select_318_s1_q[1:0] == 2'h0;
  // hls/stages/census.hpp:35
  logic [6:0] select_321;
  assign select_321 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:40
  logic or_326;
  assign or_326 = sample_pair_first_s1_q | raster_at_live_q;
  // hls/stages/agreement.hpp:202
  logic whole;
  assign whole = equal_319 ? sample_present_s1_q : (sample_present_s1_q & averager_running_mask_q);
  // hls/stages/agreement.hpp:204
  logic [6:0] column;
  assign column = sample_pair_whole_s1_q ? select_321 : 7'h0;
  // hls/stages/census.hpp:45
  logic equal_356;
  assign equal_356 = select_318_s1_q == 4'hf;
  // hls/stages/census.hpp:40
  logic [6:0] select_417;
  assign select_417 = sample_pair_first_s1_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:204
  logic [6:0] row;
  assign row = sample_pair_whole_s1_q ? select_417 : 7'h0;
  logic [6:0] select_1107;
  assign select_1107 = sample_pair_whole_s1_q ? (select_321 + {6'h0, equal_356}) : raster_at_column_q;
  // hls/stages/census.hpp:52
  logic [6:0] select_1109;
  assign select_1109 = sample_last_s1_q ? (select_417 + {6'h0, equal_357_s1_q}) : select_417;
  // hls/stages/agreement.hpp:204
  logic select_1114;
  assign select_1114 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_326 & (~raster_final_row_q)) : or_326) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [10:0] select_1116;
  assign select_1116 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:204
  logic select_1120;
  assign select_1120 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
    end else if (s1_en) begin
      raster_at_column_q <= select_1107;
      raster_at_row_q <= sample_pair_whole_s1_q ? select_1109 : raster_at_row_q;
      raster_at_live_q <= select_1114;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_1116 : raster_rows_left_q;
      raster_final_row_q <= select_1120;
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
  logic equal_319_s2_q;
  logic equal_322_s2_q;
  logic not_331_s2_q;
  logic equal_340_s2_q;
  logic whole_s2_q;
  logic [6:0] column_s2_q;
  logic equal_356_s2_q;
  logic equal_357_s2_q;
  logic equal_363_s2_q;
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
      equal_319_s2_q <= equal_319;
      equal_322_s2_q <= {select_321, select_318_s1_q} == 11'h0;
      not_331_s2_q <= ~((~or_326) | (~(select_318_s1_q[1:0] == 2'h3)));
      equal_340_s2_q <= equal_340_s1_q;
      whole_s2_q <= whole;
      column_s2_q <= column;
      equal_356_s2_q <= equal_356;
      equal_357_s2_q <= equal_357_s1_q;
      equal_363_s2_q <= select_318_s1_q == 4'h3;
      row_s2_q <= row;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:95
  logic [8:0] select_325;
  assign select_325 = equal_319_s2_q ? (equal_322_s2_q ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/agreement.hpp:302
  logic [7:0] sum_1381;
  assign sum_1381 = {1'b0, row_s2_q} + 8'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      averager_place_q <= sample_pair_whole_s2_q ? select_325 : averager_place_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic equal_319_s3_q;
  logic [8:0] select_325_s3_q;
  logic not_331_s3_q;
  logic equal_340_s3_q;
  logic whole_s3_q;
  logic [6:0] column_s3_q;
  logic equal_356_s3_q;
  logic equal_357_s3_q;
  logic equal_363_s3_q;
  logic [6:0] row_s3_q;
  logic equal_1382_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      equal_319_s3_q <= equal_319_s2_q;
      select_325_s3_q <= select_325;
      not_331_s3_q <= not_331_s2_q;
      equal_340_s3_q <= equal_340_s2_q;
      whole_s3_q <= whole_s2_q;
      column_s3_q <= column_s2_q;
      equal_356_s3_q <= equal_356_s2_q;
      equal_357_s3_q <= equal_357_s2_q;
      equal_363_s3_q <= equal_363_s2_q;
      row_s3_q <= row_s2_q;
      equal_1382_s3_q <= {sum_1381[7], cfg_height_i[10:4]} == {1'b0, sum_1381[6:0]};
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [2:0] run_phase_q;
  logic [7:0] run_beats_q;
  logic [5:0] run_shift_q;
  logic run_last_shift_q;
  logic [2:0] following_phase_q;
  logic [7:0] following_beats_q;
  logic [5:0] following_shift_q;
  logic following_last_shift_q;
  logic [7:0] beats_left_q;
  logic [6:0] least_q;
  logic [7:0] first_beats_q;
  logic [7:0] whole_beats_q;
  logic ends_q;
  logic final_row_q;
  logic [7:0] next_beats_q;
  logic [5:0] next_shift_q;
  logic next_last_shift_q;
  // hls/stages/agreement.hpp:202
  logic and_334;
  assign and_334 = not_331_s3_q & (~(select_325_s3_q[8:5] == 4'hf));
  // hls/stages/census.hpp:105
  logic and_358;
  assign and_358 = equal_357_s3_q & and_334;
  // hls/stages/agreement.hpp:204
  logic and_360;
  assign and_360 = sample_pair_whole_s3_q & (equal_356_s3_q & and_358);
  // hls/stages/agreement.hpp:743
  logic drew;
  assign drew = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:377
  logic equal_380;
  assign equal_380 = run_phase_q == 3'h4;
  logic equal_383;
  assign equal_383 = run_phase_q == 3'h3;
  logic equal_385;
  assign equal_385 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:143
  logic not_946;
  assign not_946 = ~drew;
  // hls/stages/agreement.hpp:285
  logic equal_1292;
  assign equal_1292 = {last[7], column_s3_q} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:200
  logic [2:0] select_1293;
  assign select_1293 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1302;
  assign select_1302 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1305;
  assign select_1305 = ends_q ? following_shift_q : run_shift_q;
  logic select_1308;
  assign select_1308 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:286
  logic not_1309;
  assign not_1309 = ~equal_1292;
  // hls/stages/agreement.hpp:367
  logic not_1312;
  assign not_1312 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:377
  logic equal_1313;
  assign equal_1313 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:160
  logic or_1314;
  assign or_1314 = equal_1313 | equal_385;
  logic [2:0] select_1315;
  assign select_1315 = equal_383 ? {run_last_shift_q, {2{not_1312}}} : {1'b0, or_1314, equal_385};
  logic [2:0] select_1317;
  assign select_1317 = drew ? {{2{final_row_q}}, 1'b0} : (equal_380 ? 3'h5 : select_1315);
  logic [7:0] select_1334;
  assign select_1334 = equal_383 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_385 ? first_beats_q : (equal_1313 ? whole_beats_q : 8'h0));
  logic [5:0] select_1340;
  assign select_1340 = equal_383 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_385 ? (6'h0 - least_q[5:0]) : 6'h0);
  logic select_1347;
  assign select_1347 = equal_383 ? (next_last_shift_q & not_1312) : (equal_385 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1355;
  assign select_1355 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:292
  logic less_1362;
  assign less_1362 = 7'h1c < column_s3_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1365;
  assign select_1365 = and_360 ? (equal_1292 ? (less_1362 ? 7'h1d : column_s3_q) : least_q) : least_q;
  // hls/stages/agreement.hpp:286
  logic [7:0] select_1368;
  assign select_1368 = equal_1292 ? (less_1362 ? ({1'b0, cfg_width_i[10:4]} + 8'h5) : 8'h23) : first_beats_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1372;
  assign select_1372 = and_360 ? (equal_1292 ? {sum_1370, cfg_width_i[4]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:342
  logic not_1373;
  assign not_1373 = ~ends_q;
  // hls/stages/agreement.hpp:200
  logic and_1378;
  assign and_1378 = not_1373 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:205
  logic select_1384;
  assign select_1384 = and_360 ? (equal_1292 ? equal_1382_s3_q : final_row_q) : final_row_q;
  // hls/stages/agreement.hpp:153
  logic not_1915;
  assign not_1915 = ~run_shift_q[5];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      run_phase_q <= 3'h0;
      run_beats_q <= 8'h0;
      run_shift_q <= 6'h0;
      run_last_shift_q <= 1'b0;
      following_phase_q <= 3'h0;
      following_beats_q <= 8'h0;
      following_shift_q <= 6'h0;
      following_last_shift_q <= 1'b0;
      beats_left_q <= 8'h0;
      least_q <= 7'h0;
      first_beats_q <= 8'h0;
      whole_beats_q <= 8'h0;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
      next_beats_q <= 8'h0;
      next_shift_q <= 6'h0;
      next_last_shift_q <= 1'b0;
    end else if (s3_en) begin
      run_phase_q <= and_360 ? (equal_1292 ? 3'h1 : select_1293) : select_1293;
      run_beats_q <= and_360 ? (equal_1292 ? 8'h20 : select_1302) : select_1302;
      run_shift_q <= and_360 ? (equal_1292 ? 6'h0 : select_1305) : select_1305;
      run_last_shift_q <= and_360 ? (select_1308 & not_1309) : select_1308;
      following_phase_q <= select_1317;
      following_beats_q <= drew ? 8'h3f : (equal_380 ? whole_beats_q : select_1334);
      following_shift_q <= drew ? 6'h0 : (equal_380 ? 6'h0 : select_1340);
      following_last_shift_q <= not_946 & ((~equal_380) & select_1347);
      beats_left_q <= and_360 ? (equal_1292 ? 8'h20 : select_1355) : select_1355;
      least_q <= select_1365;
      first_beats_q <= and_360 ? select_1368 : first_beats_q;
      whole_beats_q <= select_1372;
      ends_q <= and_360 ? (and_1378 & not_1309) : and_1378;
      final_row_q <= select_1384;
      next_beats_q <= {{7{not_1915}}, 1'b1} + run_beats_q;
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
  logic run_last_shift_s4_q;
  logic [6:0] least_s4_q;
  logic ends_s4_q;
  logic equal_319_s4_q;
  logic [8:0] select_325_s4_q;
  logic and_334_s4_q;
  logic equal_340_s4_q;
  logic whole_s4_q;
  logic [6:0] column_s4_q;
  logic and_358_s4_q;
  logic and_360_s4_q;
  logic equal_363_s4_q;
  logic drew_s4_q;
  logic equal_380_s4_q;
  logic equal_383_s4_q;
  logic equal_385_s4_q;
  logic [6:0] row_s4_q;
  logic equal_910_s4_q;
  logic not_946_s4_q;
  logic equal_1292_s4_q;
  logic equal_1313_s4_q;
  logic not_1373_s4_q;
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
      run_last_shift_s4_q <= run_last_shift_q;
      least_s4_q <= least_q;
      ends_s4_q <= ends_q;
      equal_319_s4_q <= equal_319_s3_q;
      select_325_s4_q <= select_325_s3_q;
      and_334_s4_q <= and_334;
      equal_340_s4_q <= equal_340_s3_q;
      whole_s4_q <= whole_s3_q;
      column_s4_q <= column_s3_q;
      and_358_s4_q <= and_358;
      and_360_s4_q <= and_360;
      equal_363_s4_q <= equal_363_s3_q;
      drew_s4_q <= drew;
      equal_380_s4_q <= equal_380;
      equal_383_s4_q <= equal_383;
      equal_385_s4_q <= equal_385;
      row_s4_q <= row_s3_q;
      equal_910_s4_q <= run_phase_q == 3'h6;
      not_946_s4_q <= not_946;
      equal_1292_s4_q <= equal_1292;
      equal_1313_s4_q <= equal_1313;
      not_1373_s4_q <= not_1373;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [7:0] run_lowest_q;
  logic [7:0] run_highest_q;
  logic [7:0] following_lowest_q;
  logic [7:0] following_highest_q;
  logic [7:0] x_q;
  logic [6:0] last_q;
  logic [7:0] next_lowest_q;
  logic [7:0] next_highest_q;
  // hls/stages/agreement.hpp:567
  logic less_386;
  assign less_386 = run_highest_q < x_q;
  logic not_387;
  assign not_387 = ~less_386;
  // hls/stages/agreement.hpp:181
  logic [6:0] select_503;
  assign select_503 = equal_383_s4_q ? ({run_shift_s4_q[5], run_shift_s4_q} + x_q[6:0]) : x_q[6:0];
  // hls/stages/agreement.hpp:454
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:466
  logic equal_532;
  assign equal_532 = {{2{run_shift_s4_q[5]}}, run_shift_s4_q} == (8'h0 - {1'b0, least_s4_q});
  // hls/stages/agreement.hpp:691
  logic [6:0] sum_1095;
  assign sum_1095 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1296;
  assign select_1296 = ends_s4_q ? following_lowest_q : run_lowest_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1298;
  assign select_1298 = and_360_s4_q ? (equal_1292_s4_q ? 8'h0 : select_1296) : select_1296;
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1299;
  assign select_1299 = ends_s4_q ? following_highest_q : run_highest_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1301;
  assign select_1301 = and_360_s4_q ? (equal_1292_s4_q ? 8'h0 : select_1299) : select_1299;
  // hls/stages/agreement.hpp:160
  logic [7:0] select_1319;
  assign select_1319 = run_last_shift_s4_q ? 8'h0 : (run_shift_s4_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1320;
  assign select_1320 = equal_385_s4_q ? least_s4_q : 7'h0;
  logic [7:0] select_1322;
  assign select_1322 = equal_380_s4_q ? 8'h0 : (equal_383_s4_q ? select_1319 : {1'b0, select_1320});
  logic [7:0] select_1325;
  assign select_1325 = run_last_shift_s4_q ? {1'b0, last_q} : (run_shift_s4_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1327;
  assign select_1327 = equal_385_s4_q ? last_q : (equal_1313_s4_q ? last_q : 7'h0);
  logic [7:0] select_1329;
  assign select_1329 = equal_380_s4_q ? {1'b0, last_q} : (equal_383_s4_q ? select_1325 : {1'b0, select_1327});
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1351;
  assign select_1351 = ends_s4_q ? following_lowest_q : (x_q + 8'h1);
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1353;
  assign select_1353 = and_360_s4_q ? (equal_1292_s4_q ? 8'h0 : select_1351) : select_1351;
  // hls/stages/agreement.hpp:601
  logic [5:0] sum_1570;
  assign sum_1570 = {1'b0, last_q[6:2]} + 6'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      run_lowest_q <= 8'h0;
      run_highest_q <= 8'h0;
      following_lowest_q <= 8'h0;
      following_highest_q <= 8'h0;
      x_q <= 8'h0;
      last_q <= 7'h0;
      next_lowest_q <= 8'h0;
      next_highest_q <= 8'h0;
    end else if (s4_en) begin
      run_lowest_q <= select_1298;
      run_highest_q <= select_1301;
      following_lowest_q <= drew_s4_q ? 8'h0 : select_1322;
      following_highest_q <= drew_s4_q ? 8'h0 : select_1329;
      x_q <= select_1353;
      last_q <= and_360_s4_q ? (equal_1292_s4_q ? column_s4_q : last_q) : last_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
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
  logic ends_s5_q;
  logic equal_319_s5_q;
  logic [8:0] select_325_s5_q;
  logic and_334_s5_q;
  logic equal_340_s5_q;
  logic whole_s5_q;
  logic [6:0] column_s5_q;
  logic and_358_s5_q;
  logic and_360_s5_q;
  logic equal_363_s5_q;
  logic drew_s5_q;
  logic equal_380_s5_q;
  logic equal_383_s5_q;
  logic less_386_s5_q;
  logic not_387_s5_q;
  logic and_388_s5_q;
  logic [6:0] row_s5_q;
  logic [6:0] select_503_s5_q;
  logic [6:0] x_s5_2_q;
  logic not_526_s5_q;
  logic equal_532_s5_q;
  logic equal_599_s5_q;
  logic equal_836_s5_q;
  logic equal_900_s5_q;
  logic equal_910_s5_q;
  logic not_946_s5_q;
  logic equal_966_s5_q;
  logic not_1097_s5_q;
  logic equal_1292_s5_q;
  logic not_1373_s5_q;
  logic less_1571_s5_q;
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
      x_s5_q <= x_q;
      ends_s5_q <= ends_s4_q;
      equal_319_s5_q <= equal_319_s4_q;
      select_325_s5_q <= select_325_s4_q;
      and_334_s5_q <= and_334_s4_q;
      equal_340_s5_q <= equal_340_s4_q;
      whole_s5_q <= whole_s4_q;
      column_s5_q <= column_s4_q;
      and_358_s5_q <= and_358_s4_q;
      and_360_s5_q <= and_360_s4_q;
      equal_363_s5_q <= equal_363_s4_q;
      drew_s5_q <= drew_s4_q;
      equal_380_s5_q <= equal_380_s4_q;
      equal_383_s5_q <= equal_383_s4_q;
      less_386_s5_q <= less_386;
      not_387_s5_q <= not_387;
      and_388_s5_q <= equal_385_s4_q & not_387;
      row_s5_q <= row_s4_q;
      select_503_s5_q <= select_503;
      x_s5_2_q <= x[6:0];
      not_526_s5_q <= ~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q});
      equal_532_s5_q <= equal_532;
      equal_599_s5_q <= run_lowest_q == x_q;
      equal_836_s5_q <= run_lowest_q == x;
      equal_900_s5_q <= run_highest_q == x;
      equal_910_s5_q <= equal_910_s4_q;
      not_946_s5_q <= not_946_s4_q;
      equal_966_s5_q <= x_q == {1'b0, last_q};
      not_1097_s5_q <= ~({sum_1095, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1292_s5_q <= equal_1292_s4_q;
      not_1373_s5_q <= not_1373_s4_q;
      less_1571_s5_q <= {1'b0, sum_1570, last_q[1]} < x_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:557
  logic or_381;
  assign or_381 = drew_s5_q | equal_380_s5_q;
  // hls/stages/agreement.hpp:435
  logic not_382;
  assign not_382 = ~or_381;
  // hls/stages/agreement.hpp:181
  logic select_474;
  assign select_474 = equal_383_s5_q ? not_387_s5_q : and_388_s5_q;
  logic and_528;
  assign and_528 = equal_383_s5_q & (age_q[2] & not_526_s5_q);
  // hls/stages/agreement.hpp:200
  logic [5:0] select_1374;
  assign select_1374 = ends_s5_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1376;
  assign select_1376 = and_360_s5_q ? (equal_1292_s5_q ? 7'h0 : {select_1374, not_1373_s5_q}) : {select_1374, not_1373_s5_q};

  // Memory left, 120 x 77, DISTANCE 32, hls/stages/agreement.hpp:872; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s5_q[6:0];
  logic left_re;
  assign left_re = s5_en & (or_381 ? not_387_s5_q : select_474);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 32, hls/stages/agreement.hpp:873; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_503_s5_q;
  logic right_codes_re;
  assign right_codes_re = s5_en & (not_382 & select_474);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_1376;
    end
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
  logic equal_319_s6_q;
  logic [8:0] select_325_s6_q;
  logic and_334_s6_q;
  logic equal_340_s6_q;
  logic whole_s6_q;
  logic [6:0] column_s6_q;
  logic and_358_s6_q;
  logic and_360_s6_q;
  logic equal_363_s6_q;
  logic drew_s6_q;
  logic equal_380_s6_q;
  logic or_381_s6_q;
  logic equal_383_s6_q;
  logic less_386_s6_q;
  logic not_387_s6_q;
  logic and_390_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic select_529_s6_q;
  logic equal_532_s6_q;
  logic equal_599_s6_q;
  logic equal_836_s6_q;
  logic and_894_s6_q;
  logic equal_900_s6_q;
  logic equal_910_s6_q;
  logic not_946_s6_q;
  logic equal_966_s6_q;
  logic not_1097_s6_q;
  logic equal_1292_s6_q;
  logic less_1571_s6_q;
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
      age_s6_q <= {age_q[6], age_q[4]};
      equal_319_s6_q <= equal_319_s5_q;
      select_325_s6_q <= select_325_s5_q;
      and_334_s6_q <= and_334_s5_q;
      equal_340_s6_q <= equal_340_s5_q;
      whole_s6_q <= whole_s5_q;
      column_s6_q <= column_s5_q;
      and_358_s6_q <= and_358_s5_q;
      and_360_s6_q <= and_360_s5_q;
      equal_363_s6_q <= equal_363_s5_q;
      drew_s6_q <= drew_s5_q;
      equal_380_s6_q <= equal_380_s5_q;
      or_381_s6_q <= or_381;
      equal_383_s6_q <= equal_383_s5_q;
      less_386_s6_q <= less_386_s5_q;
      not_387_s6_q <= not_387_s5_q;
      and_390_s6_q <= not_382 & ((~equal_383_s5_q) & and_388_s5_q);
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x_s5_2_q;
      select_529_s6_q <= or_381 ? not_387_s5_q : and_528;
      equal_532_s6_q <= equal_532_s5_q;
      equal_599_s6_q <= equal_599_s5_q;
      equal_836_s6_q <= equal_836_s5_q;
      and_894_s6_q <= not_382 & and_528;
      equal_900_s6_q <= equal_900_s5_q;
      equal_910_s6_q <= equal_910_s5_q;
      not_946_s6_q <= not_946_s5_q;
      equal_966_s6_q <= equal_966_s5_q;
      not_1097_s6_q <= not_1097_s5_q;
      equal_1292_s6_q <= equal_1292_s5_q;
      less_1571_s6_q <= less_1571_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------

  // Memory fresh, 120 x 29, DISTANCE 32, hls/stages/agreement.hpp:871; read in stage 6, written in stage 28: 6 < 28 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s6_q[6:0];
  logic fresh_re;
  assign fresh_re = s6_en & and_390_s6_q;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
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
  logic equal_319_s7_q;
  logic [8:0] select_325_s7_q;
  logic and_334_s7_q;
  logic equal_340_s7_q;
  logic whole_s7_q;
  logic [6:0] column_s7_q;
  logic and_358_s7_q;
  logic and_360_s7_q;
  logic equal_363_s7_q;
  logic drew_s7_q;
  logic equal_380_s7_q;
  logic or_381_s7_q;
  logic equal_383_s7_q;
  logic less_386_s7_q;
  logic not_387_s7_q;
  logic and_390_s7_q;
  logic [6:0] row_s7_q;
  logic [76:0] left_rdata_s7_q;
  logic [90:0] right_codes_rdata_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_529_s7_q;
  logic equal_532_s7_q;
  logic equal_599_s7_q;
  logic equal_836_s7_q;
  logic and_894_s7_q;
  logic equal_900_s7_q;
  logic equal_910_s7_q;
  logic not_946_s7_q;
  logic equal_966_s7_q;
  logic not_1097_s7_q;
  logic equal_1292_s7_q;
  logic less_1571_s7_q;
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
      equal_319_s7_q <= equal_319_s6_q;
      select_325_s7_q <= select_325_s6_q;
      and_334_s7_q <= and_334_s6_q;
      equal_340_s7_q <= equal_340_s6_q;
      whole_s7_q <= whole_s6_q;
      column_s7_q <= column_s6_q;
      and_358_s7_q <= and_358_s6_q;
      and_360_s7_q <= and_360_s6_q;
      equal_363_s7_q <= equal_363_s6_q;
      drew_s7_q <= drew_s6_q;
      equal_380_s7_q <= equal_380_s6_q;
      or_381_s7_q <= or_381_s6_q;
      equal_383_s7_q <= equal_383_s6_q;
      less_386_s7_q <= less_386_s6_q;
      not_387_s7_q <= not_387_s6_q;
      and_390_s7_q <= and_390_s6_q;
      row_s7_q <= row_s6_q;
      left_rdata_s7_q <= left_rdata_q;
      right_codes_rdata_s7_q <= right_codes_rdata_q;
      x_s7_2_q <= x_s6_2_q;
      select_529_s7_q <= select_529_s6_q;
      equal_532_s7_q <= equal_532_s6_q;
      equal_599_s7_q <= equal_599_s6_q;
      equal_836_s7_q <= equal_836_s6_q;
      and_894_s7_q <= and_894_s6_q;
      equal_900_s7_q <= equal_900_s6_q;
      equal_910_s7_q <= equal_910_s6_q;
      not_946_s7_q <= not_946_s6_q;
      equal_966_s7_q <= equal_966_s6_q;
      not_1097_s7_q <= not_1097_s6_q;
      equal_1292_s7_q <= equal_1292_s6_q;
      less_1571_s7_q <= less_1571_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:410
  logic equal_477;
  assign equal_477 = row_q == 7'h0;
  logic not_479;
  assign not_479 = ~equal_477;
  logic equal_484;
  assign equal_484 = row_q[6:1] == 6'h0;
  logic not_486;
  assign not_486 = ~equal_484;
  logic less_491;
  assign less_491 = row_q < 7'h3;
  logic not_493;
  assign not_493 = ~less_491;
  logic equal_498;
  assign equal_498 = row_q[6:2] == 5'h0;
  logic not_500;
  assign not_500 = ~equal_498;
  // hls/stages/agreement.hpp:411
  logic less_514;
  assign less_514 = row_q < 7'h5;
  logic less_518;
  assign less_518 = row_q[6:1] < 6'h3;
  // hls/stages/agreement.hpp:170
  logic and_538;
  assign and_538 = left_rdata_s7_q[44] & not_387_s7_q;
  logic [11:0] a;
  assign a = less_386_s7_q ? 12'h0 : left_rdata_s7_q[43:32];
  logic [11:0] b;
  assign b = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[37:26];
  logic [11:0] a_2;
  assign a_2 = less_386_s7_q ? 12'h0 : left_rdata_s7_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[50:39];
  logic and_577;
  assign and_577 = left_rdata_s7_q[76] & not_387_s7_q;
  logic [11:0] a_3;
  assign a_3 = less_386_s7_q ? 12'h0 : left_rdata_s7_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[63:52];
  logic [11:0] b_4;
  assign b_4 = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[76:65];
  logic [11:0] b_5;
  assign b_5 = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[24:13];
  logic [11:0] b_6;
  assign b_6 = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[89:78];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_749;
  assign not_749 = ~(a_3 ^ b_6);
  // hls/stages/agreement.hpp:170
  logic [11:0] b_7;
  assign b_7 = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[11:0];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_778;
  assign not_778 = ~(a ^ b_7);
  // hls/stages/agreement.hpp:339
  logic and_1099;
  assign and_1099 = drew_s7_q & (((7'h6 < row_q) & (~(x_s7_q[7:2] == 6'h0))) & not_1097_s7_q);
  // hls/stages/agreement.hpp:286
  logic select_1388;
  assign select_1388 = equal_1292_s7_q ? (~({row_s7_q, 1'b0} < {sum_1385, cfg_height_i[4]})) : lower_half_q;

  // Memory best_left, 120 x 22, DISTANCE 32, hls/stages/agreement.hpp:874; read in stage 7, written in stage 29: 7 < 29 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 22'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_381_s7_q ? x_s7_q[6:0] : x_s7_2_q;
  logic best_left_re;
  assign best_left_re = s7_en & select_529_s7_q;
  logic [21:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s7_en) begin
      row_q <= and_360_s7_q ? (equal_1292_s7_q ? row_s7_q : row_q) : row_q;
      lower_half_q <= and_360_s7_q ? select_1388 : lower_half_q;
    end
  end

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
  logic equal_319_s8_q;
  logic [8:0] select_325_s8_q;
  logic and_334_s8_q;
  logic equal_340_s8_q;
  logic whole_s8_q;
  logic [6:0] column_s8_q;
  logic and_358_s8_q;
  logic and_360_s8_q;
  logic equal_363_s8_q;
  logic drew_s8_q;
  logic equal_380_s8_q;
  logic or_381_s8_q;
  logic equal_383_s8_q;
  logic less_386_s8_q;
  logic not_387_s8_q;
  logic and_390_s8_q;
  logic [28:0] fresh_rdata_s8_q;
  logic equal_419_s8_q;
  logic left_rdata_s8_q;
  logic [11:0] select_478_s8_q;
  logic and_480_s8_q;
  logic and_481_s8_q;
  logic and_482_s8_q;
  logic and_483_s8_q;
  logic [11:0] select_485_s8_q;
  logic and_487_s8_q;
  logic and_488_s8_q;
  logic and_489_s8_q;
  logic and_490_s8_q;
  logic [11:0] select_492_s8_q;
  logic and_494_s8_q;
  logic and_495_s8_q;
  logic and_496_s8_q;
  logic and_497_s8_q;
  logic [11:0] select_499_s8_q;
  logic and_501_s8_q;
  logic [11:0] select_506_s8_q;
  logic and_507_s8_q;
  logic [11:0] select_508_s8_q;
  logic and_509_s8_q;
  logic [11:0] select_510_s8_q;
  logic and_511_s8_q;
  logic [11:0] select_512_s8_q;
  logic and_513_s8_q;
  logic [11:0] select_515_s8_q;
  logic and_517_s8_q;
  logic [11:0] select_519_s8_q;
  logic and_521_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_529_s8_q;
  logic equal_532_s8_q;
  logic and_538_s8_q;
  logic and_539_s8_q;
  logic [11:0] a_s8_q;
  logic [11:0] b_s8_q;
  logic and_557_s8_q;
  logic and_558_s8_q;
  logic [11:0] a_2_s8_q;
  logic [11:0] b_2_s8_q;
  logic and_577_s8_q;
  logic and_578_s8_q;
  logic [11:0] a_3_s8_q;
  logic [11:0] b_3_s8_q;
  logic equal_599_s8_q;
  logic and_633_s8_q;
  logic [11:0] b_4_s8_q;
  logic and_657_s8_q;
  logic [11:0] b_5_s8_q;
  logic and_746_s8_q;
  logic [9:0] not_749_s8_q;
  logic [1:0] sum_750_s8_q;
  logic and_775_s8_q;
  logic [9:0] not_778_s8_q;
  logic [1:0] sum_779_s8_q;
  logic equal_836_s8_q;
  logic and_894_s8_q;
  logic equal_900_s8_q;
  logic equal_910_s8_q;
  logic and_914_s8_q;
  logic and_925_s8_q;
  logic not_946_s8_q;
  logic equal_966_s8_q;
  logic and_1099_s8_q;
  logic equal_1240_s8_q;
  logic equal_1292_s8_q;
  logic less_1569_s8_q;
  logic less_1571_s8_q;
  logic equal_1833_s8_q;
  logic less_1844_s8_q;
  logic equal_1987_s8_q;
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
      lower_half_s8_q <= lower_half_q;
      equal_319_s8_q <= equal_319_s7_q;
      select_325_s8_q <= select_325_s7_q;
      and_334_s8_q <= and_334_s7_q;
      equal_340_s8_q <= equal_340_s7_q;
      whole_s8_q <= whole_s7_q;
      column_s8_q <= column_s7_q;
      and_358_s8_q <= and_358_s7_q;
      and_360_s8_q <= and_360_s7_q;
      equal_363_s8_q <= equal_363_s7_q;
      drew_s8_q <= drew_s7_q;
      equal_380_s8_q <= equal_380_s7_q;
      or_381_s8_q <= or_381_s7_q;
      equal_383_s8_q <= equal_383_s7_q;
      less_386_s8_q <= less_386_s7_q;
      not_387_s8_q <= not_387_s7_q;
      and_390_s8_q <= and_390_s7_q;
      fresh_rdata_s8_q <= fresh_rdata_q;
      equal_419_s8_q <= row_s7_q == 7'h0;
      left_rdata_s8_q <= left_rdata_s7_q[62];
      select_478_s8_q <= equal_477 ? 12'h0 : left_rdata_s7_q[11:0];
      and_480_s8_q <= left_rdata_s7_q[12] & not_479;
      and_481_s8_q <= left_rdata_s7_q[13] & not_479;
      and_482_s8_q <= left_rdata_s7_q[14] & not_479;
      and_483_s8_q <= left_rdata_s7_q[15] & not_479;
      select_485_s8_q <= equal_484 ? 12'h0 : left_rdata_s7_q[27:16];
      and_487_s8_q <= left_rdata_s7_q[28] & not_486;
      and_488_s8_q <= left_rdata_s7_q[29] & not_486;
      and_489_s8_q <= left_rdata_s7_q[30] & not_486;
      and_490_s8_q <= left_rdata_s7_q[31] & not_486;
      select_492_s8_q <= less_491 ? 12'h0 : left_rdata_s7_q[43:32];
      and_494_s8_q <= left_rdata_s7_q[44] & not_493;
      and_495_s8_q <= left_rdata_s7_q[45] & not_493;
      and_496_s8_q <= left_rdata_s7_q[46] & not_493;
      and_497_s8_q <= left_rdata_s7_q[47] & not_493;
      select_499_s8_q <= equal_498 ? 12'h0 : left_rdata_s7_q[59:48];
      and_501_s8_q <= left_rdata_s7_q[60] & not_500;
      select_506_s8_q <= equal_477 ? 12'h0 : right_codes_rdata_s7_q[11:0];
      and_507_s8_q <= right_codes_rdata_s7_q[12] & not_479;
      select_508_s8_q <= equal_484 ? 12'h0 : right_codes_rdata_s7_q[24:13];
      and_509_s8_q <= right_codes_rdata_s7_q[25] & not_486;
      select_510_s8_q <= less_491 ? 12'h0 : right_codes_rdata_s7_q[37:26];
      and_511_s8_q <= right_codes_rdata_s7_q[38] & not_493;
      select_512_s8_q <= equal_498 ? 12'h0 : right_codes_rdata_s7_q[50:39];
      and_513_s8_q <= right_codes_rdata_s7_q[51] & not_500;
      select_515_s8_q <= less_514 ? 12'h0 : right_codes_rdata_s7_q[63:52];
      and_517_s8_q <= right_codes_rdata_s7_q[64] & (~less_514);
      select_519_s8_q <= less_518 ? 12'h0 : right_codes_rdata_s7_q[76:65];
      and_521_s8_q <= right_codes_rdata_s7_q[77] & (~less_518);
      x_s8_2_q <= x_s7_2_q;
      select_529_s8_q <= select_529_s7_q;
      equal_532_s8_q <= equal_532_s7_q;
      and_538_s8_q <= and_538;
      and_539_s8_q <= right_codes_rdata_s7_q[38] & not_387_s7_q;
      a_s8_q <= a;
      b_s8_q <= b;
      and_557_s8_q <= left_rdata_s7_q[60] & not_387_s7_q;
      and_558_s8_q <= right_codes_rdata_s7_q[51] & not_387_s7_q;
      a_2_s8_q <= a_2;
      b_2_s8_q <= b_2;
      and_577_s8_q <= and_577;
      and_578_s8_q <= right_codes_rdata_s7_q[64] & not_387_s7_q;
      a_3_s8_q <= a_3;
      b_3_s8_q <= b_3;
      equal_599_s8_q <= equal_599_s7_q;
      and_633_s8_q <= right_codes_rdata_s7_q[77] & not_387_s7_q;
      b_4_s8_q <= b_4;
      and_657_s8_q <= right_codes_rdata_s7_q[25] & not_387_s7_q;
      b_5_s8_q <= b_5;
      and_746_s8_q <= and_577 & (right_codes_rdata_s7_q[90] & not_387_s7_q);
      not_749_s8_q <= not_749[11:2];
      sum_750_s8_q <= {1'b0, not_749[0]} + {1'b0, not_749[1]};
      and_775_s8_q <= and_538 & (right_codes_rdata_s7_q[12] & not_387_s7_q);
      not_778_s8_q <= not_778[11:2];
      sum_779_s8_q <= {1'b0, not_778[0]} + {1'b0, not_778[1]};
      equal_836_s8_q <= equal_836_s7_q;
      and_894_s8_q <= and_894_s7_q;
      equal_900_s8_q <= equal_900_s7_q;
      equal_910_s8_q <= equal_910_s7_q;
      and_914_s8_q <= left_rdata_s7_q[61] & (~(row_q[6:3] == 4'h0));
      and_925_s8_q <= left_rdata_s7_q[63] & not_387_s7_q;
      not_946_s8_q <= not_946_s7_q;
      equal_966_s8_q <= equal_966_s7_q;
      and_1099_s8_q <= and_1099;
      equal_1240_s8_q <= (column_s7_q | row_s7_q) == 7'h0;
      equal_1292_s8_q <= equal_1292_s7_q;
      less_1569_s8_q <= 6'h4 < row_q[6:1];
      less_1571_s8_q <= less_1571_s7_q;
      equal_1833_s8_q <= row_s7_q[6:2] == 5'h0;
      less_1844_s8_q <= 6'h2 < row_s7_q[6:1];
      equal_1987_s8_q <= row_s7_q[6:3] == 4'h0;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:420
  logic [11:0] not_544;
  assign not_544 = ~(a_s8_q ^ b_s8_q);
  logic [1:0] sum_546;
  assign sum_546 = {1'b0, not_544[2]} + ({1'b0, not_544[0]} + {1'b0, not_544[1]});
  logic [11:0] not_563;
  assign not_563 = ~(a_2_s8_q ^ b_2_s8_q);
  logic [1:0] sum_565;
  assign sum_565 = {1'b0, not_563[2]} + ({1'b0, not_563[0]} + {1'b0, not_563[1]});
  logic [11:0] not_583;
  assign not_583 = ~(a_3_s8_q ^ b_3_s8_q);
  logic [1:0] sum_585;
  assign sum_585 = {1'b0, not_583[2]} + ({1'b0, not_583[0]} + {1'b0, not_583[1]});
  logic [11:0] not_604;
  assign not_604 = ~(a_s8_q ^ b_2_s8_q);
  logic [1:0] sum_606;
  assign sum_606 = {1'b0, not_604[2]} + ({1'b0, not_604[0]} + {1'b0, not_604[1]});
  logic [11:0] not_619;
  assign not_619 = ~(a_2_s8_q ^ b_3_s8_q);
  logic [1:0] sum_621;
  assign sum_621 = {1'b0, not_619[2]} + ({1'b0, not_619[0]} + {1'b0, not_619[1]});
  logic [11:0] not_637;
  assign not_637 = ~(a_3_s8_q ^ b_4_s8_q);
  logic [1:0] sum_639;
  assign sum_639 = {1'b0, not_637[2]} + ({1'b0, not_637[0]} + {1'b0, not_637[1]});
  logic [11:0] not_661;
  assign not_661 = ~(a_s8_q ^ b_5_s8_q);
  logic [1:0] sum_663;
  assign sum_663 = {1'b0, not_661[2]} + ({1'b0, not_661[0]} + {1'b0, not_661[1]});
  logic [11:0] not_676;
  assign not_676 = ~(a_2_s8_q ^ b_s8_q);
  logic [1:0] sum_678;
  assign sum_678 = {1'b0, not_676[2]} + ({1'b0, not_676[0]} + {1'b0, not_676[1]});
  logic [11:0] not_692;
  assign not_692 = ~(a_3_s8_q ^ b_2_s8_q);
  logic [1:0] sum_694;
  assign sum_694 = {1'b0, not_692[2]} + ({1'b0, not_692[0]} + {1'b0, not_692[1]});
  logic [11:0] not_716;
  assign not_716 = ~(a_s8_q ^ b_3_s8_q);
  logic [1:0] sum_718;
  assign sum_718 = {1'b0, not_716[2]} + ({1'b0, not_716[0]} + {1'b0, not_716[1]});
  logic [11:0] not_731;
  assign not_731 = ~(a_2_s8_q ^ b_4_s8_q);
  logic [1:0] sum_733;
  assign sum_733 = {1'b0, not_731[2]} + ({1'b0, not_731[0]} + {1'b0, not_731[1]});
  logic [1:0] sum_751;
  assign sum_751 = {1'b0, not_749_s8_q[0]} + sum_750_s8_q;
  logic [1:0] sum_780;
  assign sum_780 = {1'b0, not_778_s8_q[0]} + sum_779_s8_q;
  logic [11:0] not_793;
  assign not_793 = ~(a_2_s8_q ^ b_5_s8_q);
  logic [1:0] sum_795;
  assign sum_795 = {1'b0, not_793[2]} + ({1'b0, not_793[0]} + {1'b0, not_793[1]});
  logic [11:0] not_809;
  assign not_809 = ~(a_3_s8_q ^ b_s8_q);
  logic [1:0] sum_811;
  assign sum_811 = {1'b0, not_809[2]} + ({1'b0, not_809[0]} + {1'b0, not_809[1]});

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s8_q[6:0];
  logic left_we;
  assign left_we = s8_en & and_390_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_501_s8_q, select_499_s8_q, and_497_s8_q, and_496_s8_q, and_495_s8_q, and_494_s8_q, select_492_s8_q, and_490_s8_q, and_489_s8_q, and_488_s8_q, and_487_s8_q, select_485_s8_q, and_483_s8_q, and_482_s8_q, and_481_s8_q, and_480_s8_q, select_478_s8_q, fresh_rdata_s8_q[28:26], fresh_rdata_s8_q[24], fresh_rdata_s8_q[11:0]};
  end
`ifndef SYNTHESIS
  logic [6:0] left_raddr_s6_sim;
  logic left_re_s6_sim;
  logic [6:0] left_raddr_s7_sim;
  logic left_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_re_s6_sim <= 1'b0;
      left_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      left_re_s6_sim <= left_re;
      left_raddr_s6_sim <= left_raddr;
      left_re_s7_sim <= left_re_s6_sim;
      left_raddr_s7_sim <= left_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s6_sim && left_raddr_s6_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s7_sim && left_raddr_s7_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 7'd120) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 7'd120) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [6:0] right_codes_waddr;
  assign right_codes_waddr = x_s8_q[6:0];
  logic right_codes_we;
  assign right_codes_we = s8_en & and_390_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_521_s8_q, select_519_s8_q, and_517_s8_q, select_515_s8_q, and_513_s8_q, select_512_s8_q, and_511_s8_q, select_510_s8_q, and_509_s8_q, select_508_s8_q, and_507_s8_q, select_506_s8_q, fresh_rdata_s8_q[25], fresh_rdata_s8_q[23:12]};
  end
`ifndef SYNTHESIS
  logic [6:0] right_codes_raddr_s6_sim;
  logic right_codes_re_s6_sim;
  logic [6:0] right_codes_raddr_s7_sim;
  logic right_codes_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_codes_re_s6_sim <= 1'b0;
      right_codes_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      right_codes_re_s6_sim <= right_codes_re;
      right_codes_raddr_s6_sim <= right_codes_raddr;
      right_codes_re_s7_sim <= right_codes_re_s6_sim;
      right_codes_raddr_s7_sim <= right_codes_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s6_sim && right_codes_raddr_s6_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s7_sim && right_codes_raddr_s7_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 7'd120) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 7'd120) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

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
  logic equal_319_s9_q;
  logic [8:0] select_325_s9_q;
  logic and_334_s9_q;
  logic equal_340_s9_q;
  logic whole_s9_q;
  logic [6:0] column_s9_q;
  logic and_358_s9_q;
  logic and_360_s9_q;
  logic equal_363_s9_q;
  logic drew_s9_q;
  logic equal_380_s9_q;
  logic or_381_s9_q;
  logic equal_383_s9_q;
  logic less_386_s9_q;
  logic not_387_s9_q;
  logic equal_419_s9_q;
  logic left_rdata_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_529_s9_q;
  logic [21:0] best_left_rdata_s9_q;
  logic equal_532_s9_q;
  logic and_538_s9_q;
  logic and_539_s9_q;
  logic [7:0] not_544_s9_q;
  logic [2:0] sum_547_s9_q;
  logic and_557_s9_q;
  logic and_558_s9_q;
  logic [7:0] not_563_s9_q;
  logic [2:0] sum_566_s9_q;
  logic and_577_s9_q;
  logic and_578_s9_q;
  logic [7:0] not_583_s9_q;
  logic [2:0] sum_586_s9_q;
  logic equal_599_s9_q;
  logic [7:0] not_604_s9_q;
  logic [2:0] sum_607_s9_q;
  logic [7:0] not_619_s9_q;
  logic [2:0] sum_622_s9_q;
  logic and_633_s9_q;
  logic [7:0] not_637_s9_q;
  logic [2:0] sum_640_s9_q;
  logic and_657_s9_q;
  logic [7:0] not_661_s9_q;
  logic [2:0] sum_664_s9_q;
  logic [7:0] not_676_s9_q;
  logic [2:0] sum_679_s9_q;
  logic [7:0] not_692_s9_q;
  logic [2:0] sum_695_s9_q;
  logic [7:0] not_716_s9_q;
  logic [2:0] sum_719_s9_q;
  logic [7:0] not_731_s9_q;
  logic [2:0] sum_734_s9_q;
  logic and_746_s9_q;
  logic [7:0] not_749_s9_q;
  logic [2:0] sum_752_s9_q;
  logic and_775_s9_q;
  logic [7:0] not_778_s9_q;
  logic [2:0] sum_781_s9_q;
  logic [7:0] not_793_s9_q;
  logic [2:0] sum_796_s9_q;
  logic [7:0] not_809_s9_q;
  logic [2:0] sum_812_s9_q;
  logic equal_836_s9_q;
  logic and_894_s9_q;
  logic equal_900_s9_q;
  logic equal_910_s9_q;
  logic and_914_s9_q;
  logic and_925_s9_q;
  logic not_946_s9_q;
  logic equal_966_s9_q;
  logic and_1099_s9_q;
  logic equal_1240_s9_q;
  logic equal_1292_s9_q;
  logic less_1569_s9_q;
  logic less_1571_s9_q;
  logic equal_1833_s9_q;
  logic less_1844_s9_q;
  logic equal_1987_s9_q;
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
      equal_319_s9_q <= equal_319_s8_q;
      select_325_s9_q <= select_325_s8_q;
      and_334_s9_q <= and_334_s8_q;
      equal_340_s9_q <= equal_340_s8_q;
      whole_s9_q <= whole_s8_q;
      column_s9_q <= column_s8_q;
      and_358_s9_q <= and_358_s8_q;
      and_360_s9_q <= and_360_s8_q;
      equal_363_s9_q <= equal_363_s8_q;
      drew_s9_q <= drew_s8_q;
      equal_380_s9_q <= equal_380_s8_q;
      or_381_s9_q <= or_381_s8_q;
      equal_383_s9_q <= equal_383_s8_q;
      less_386_s9_q <= less_386_s8_q;
      not_387_s9_q <= not_387_s8_q;
      equal_419_s9_q <= equal_419_s8_q;
      left_rdata_s9_q <= left_rdata_s8_q;
      x_s9_2_q <= x_s8_2_q;
      select_529_s9_q <= select_529_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_q;
      equal_532_s9_q <= equal_532_s8_q;
      and_538_s9_q <= and_538_s8_q;
      and_539_s9_q <= and_539_s8_q;
      not_544_s9_q <= not_544[11:4];
      sum_547_s9_q <= {2'h0, not_544[3]} + {1'b0, sum_546};
      and_557_s9_q <= and_557_s8_q;
      and_558_s9_q <= and_558_s8_q;
      not_563_s9_q <= not_563[11:4];
      sum_566_s9_q <= {2'h0, not_563[3]} + {1'b0, sum_565};
      and_577_s9_q <= and_577_s8_q;
      and_578_s9_q <= and_578_s8_q;
      not_583_s9_q <= not_583[11:4];
      sum_586_s9_q <= {2'h0, not_583[3]} + {1'b0, sum_585};
      equal_599_s9_q <= equal_599_s8_q;
      not_604_s9_q <= not_604[11:4];
      sum_607_s9_q <= {2'h0, not_604[3]} + {1'b0, sum_606};
      not_619_s9_q <= not_619[11:4];
      sum_622_s9_q <= {2'h0, not_619[3]} + {1'b0, sum_621};
      and_633_s9_q <= and_633_s8_q;
      not_637_s9_q <= not_637[11:4];
      sum_640_s9_q <= {2'h0, not_637[3]} + {1'b0, sum_639};
      and_657_s9_q <= and_657_s8_q;
      not_661_s9_q <= not_661[11:4];
      sum_664_s9_q <= {2'h0, not_661[3]} + {1'b0, sum_663};
      not_676_s9_q <= not_676[11:4];
      sum_679_s9_q <= {2'h0, not_676[3]} + {1'b0, sum_678};
      not_692_s9_q <= not_692[11:4];
      sum_695_s9_q <= {2'h0, not_692[3]} + {1'b0, sum_694};
      not_716_s9_q <= not_716[11:4];
      sum_719_s9_q <= {2'h0, not_716[3]} + {1'b0, sum_718};
      not_731_s9_q <= not_731[11:4];
      sum_734_s9_q <= {2'h0, not_731[3]} + {1'b0, sum_733};
      and_746_s9_q <= and_746_s8_q;
      not_749_s9_q <= not_749_s8_q[9:2];
      sum_752_s9_q <= {2'h0, not_749_s8_q[1]} + {1'b0, sum_751};
      and_775_s9_q <= and_775_s8_q;
      not_778_s9_q <= not_778_s8_q[9:2];
      sum_781_s9_q <= {2'h0, not_778_s8_q[1]} + {1'b0, sum_780};
      not_793_s9_q <= not_793[11:4];
      sum_796_s9_q <= {2'h0, not_793[3]} + {1'b0, sum_795};
      not_809_s9_q <= not_809[11:4];
      sum_812_s9_q <= {2'h0, not_809[3]} + {1'b0, sum_811};
      equal_836_s9_q <= equal_836_s8_q;
      and_894_s9_q <= and_894_s8_q;
      equal_900_s9_q <= equal_900_s8_q;
      equal_910_s9_q <= equal_910_s8_q;
      and_914_s9_q <= and_914_s8_q;
      and_925_s9_q <= and_925_s8_q;
      not_946_s9_q <= not_946_s8_q;
      equal_966_s9_q <= equal_966_s8_q;
      and_1099_s9_q <= and_1099_s8_q;
      equal_1240_s9_q <= equal_1240_s8_q;
      equal_1292_s9_q <= equal_1292_s8_q;
      less_1569_s9_q <= less_1569_s8_q;
      less_1571_s9_q <= less_1571_s8_q;
      equal_1833_s9_q <= equal_1833_s8_q;
      less_1844_s9_q <= less_1844_s8_q;
      equal_1987_s9_q <= equal_1987_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:420
  logic [2:0] sum_549;
  assign sum_549 = {2'h0, not_544_s9_q[1]} + ({2'h0, not_544_s9_q[0]} + sum_547_s9_q);
  logic [2:0] sum_568;
  assign sum_568 = {2'h0, not_563_s9_q[1]} + ({2'h0, not_563_s9_q[0]} + sum_566_s9_q);
  logic [2:0] sum_588;
  assign sum_588 = {2'h0, not_583_s9_q[1]} + ({2'h0, not_583_s9_q[0]} + sum_586_s9_q);
  logic [2:0] sum_609;
  assign sum_609 = {2'h0, not_604_s9_q[1]} + ({2'h0, not_604_s9_q[0]} + sum_607_s9_q);
  logic [2:0] sum_624;
  assign sum_624 = {2'h0, not_619_s9_q[1]} + ({2'h0, not_619_s9_q[0]} + sum_622_s9_q);
  logic [2:0] sum_642;
  assign sum_642 = {2'h0, not_637_s9_q[1]} + ({2'h0, not_637_s9_q[0]} + sum_640_s9_q);
  logic [2:0] sum_666;
  assign sum_666 = {2'h0, not_661_s9_q[1]} + ({2'h0, not_661_s9_q[0]} + sum_664_s9_q);
  logic [2:0] sum_681;
  assign sum_681 = {2'h0, not_676_s9_q[1]} + ({2'h0, not_676_s9_q[0]} + sum_679_s9_q);
  logic [2:0] sum_697;
  assign sum_697 = {2'h0, not_692_s9_q[1]} + ({2'h0, not_692_s9_q[0]} + sum_695_s9_q);
  logic [2:0] sum_721;
  assign sum_721 = {2'h0, not_716_s9_q[1]} + ({2'h0, not_716_s9_q[0]} + sum_719_s9_q);
  logic [2:0] sum_736;
  assign sum_736 = {2'h0, not_731_s9_q[1]} + ({2'h0, not_731_s9_q[0]} + sum_734_s9_q);
  logic [2:0] sum_754;
  assign sum_754 = {2'h0, not_749_s9_q[1]} + ({2'h0, not_749_s9_q[0]} + sum_752_s9_q);
  logic [2:0] sum_783;
  assign sum_783 = {2'h0, not_778_s9_q[1]} + ({2'h0, not_778_s9_q[0]} + sum_781_s9_q);
  logic [2:0] sum_798;
  assign sum_798 = {2'h0, not_793_s9_q[1]} + ({2'h0, not_793_s9_q[0]} + sum_796_s9_q);
  logic [2:0] sum_814;
  assign sum_814 = {2'h0, not_809_s9_q[1]} + ({2'h0, not_809_s9_q[0]} + sum_812_s9_q);
  // hls/stages/agreement.hpp:571
  logic [6:0] sum_895;
  assign sum_895 = x_s9_q[6:0] + {best_left_rdata_s9_q[13], best_left_rdata_s9_q[13:8]};
  // hls/stages/agreement.hpp:475
  logic [6:0] partner;
  assign partner = {run_shift_s9_q[5], run_shift_s9_q} + x_s9_2_q;

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
  logic equal_319_s10_q;
  logic [8:0] select_325_s10_q;
  logic and_334_s10_q;
  logic equal_340_s10_q;
  logic whole_s10_q;
  logic [6:0] column_s10_q;
  logic and_358_s10_q;
  logic and_360_s10_q;
  logic equal_363_s10_q;
  logic drew_s10_q;
  logic equal_380_s10_q;
  logic or_381_s10_q;
  logic equal_383_s10_q;
  logic less_386_s10_q;
  logic not_387_s10_q;
  logic equal_419_s10_q;
  logic left_rdata_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_529_s10_q;
  logic [21:0] best_left_rdata_s10_q;
  logic equal_532_s10_q;
  logic and_538_s10_q;
  logic and_539_s10_q;
  logic [5:0] not_544_s10_q;
  logic [2:0] sum_549_s10_q;
  logic and_557_s10_q;
  logic and_558_s10_q;
  logic [5:0] not_563_s10_q;
  logic [2:0] sum_568_s10_q;
  logic and_577_s10_q;
  logic and_578_s10_q;
  logic [5:0] not_583_s10_q;
  logic [2:0] sum_588_s10_q;
  logic equal_599_s10_q;
  logic [5:0] not_604_s10_q;
  logic [2:0] sum_609_s10_q;
  logic [5:0] not_619_s10_q;
  logic [2:0] sum_624_s10_q;
  logic and_633_s10_q;
  logic [5:0] not_637_s10_q;
  logic [2:0] sum_642_s10_q;
  logic and_657_s10_q;
  logic [5:0] not_661_s10_q;
  logic [2:0] sum_666_s10_q;
  logic [5:0] not_676_s10_q;
  logic [2:0] sum_681_s10_q;
  logic [5:0] not_692_s10_q;
  logic [2:0] sum_697_s10_q;
  logic [5:0] not_716_s10_q;
  logic [2:0] sum_721_s10_q;
  logic [5:0] not_731_s10_q;
  logic [2:0] sum_736_s10_q;
  logic and_746_s10_q;
  logic [5:0] not_749_s10_q;
  logic [2:0] sum_754_s10_q;
  logic and_775_s10_q;
  logic [5:0] not_778_s10_q;
  logic [2:0] sum_783_s10_q;
  logic [5:0] not_793_s10_q;
  logic [2:0] sum_798_s10_q;
  logic [5:0] not_809_s10_q;
  logic [2:0] sum_814_s10_q;
  logic equal_836_s10_q;
  logic and_894_s10_q;
  logic [6:0] sum_895_s10_q;
  logic [6:0] partner_s10_q;
  logic equal_900_s10_q;
  logic equal_910_s10_q;
  logic and_914_s10_q;
  logic and_925_s10_q;
  logic not_946_s10_q;
  logic equal_966_s10_q;
  logic and_1099_s10_q;
  logic equal_1240_s10_q;
  logic equal_1292_s10_q;
  logic less_1569_s10_q;
  logic less_1571_s10_q;
  logic equal_1833_s10_q;
  logic less_1844_s10_q;
  logic equal_1987_s10_q;
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
      equal_319_s10_q <= equal_319_s9_q;
      select_325_s10_q <= select_325_s9_q;
      and_334_s10_q <= and_334_s9_q;
      equal_340_s10_q <= equal_340_s9_q;
      whole_s10_q <= whole_s9_q;
      column_s10_q <= column_s9_q;
      and_358_s10_q <= and_358_s9_q;
      and_360_s10_q <= and_360_s9_q;
      equal_363_s10_q <= equal_363_s9_q;
      drew_s10_q <= drew_s9_q;
      equal_380_s10_q <= equal_380_s9_q;
      or_381_s10_q <= or_381_s9_q;
      equal_383_s10_q <= equal_383_s9_q;
      less_386_s10_q <= less_386_s9_q;
      not_387_s10_q <= not_387_s9_q;
      equal_419_s10_q <= equal_419_s9_q;
      left_rdata_s10_q <= left_rdata_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_529_s10_q <= select_529_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      equal_532_s10_q <= equal_532_s9_q;
      and_538_s10_q <= and_538_s9_q;
      and_539_s10_q <= and_539_s9_q;
      not_544_s10_q <= not_544_s9_q[7:2];
      sum_549_s10_q <= sum_549;
      and_557_s10_q <= and_557_s9_q;
      and_558_s10_q <= and_558_s9_q;
      not_563_s10_q <= not_563_s9_q[7:2];
      sum_568_s10_q <= sum_568;
      and_577_s10_q <= and_577_s9_q;
      and_578_s10_q <= and_578_s9_q;
      not_583_s10_q <= not_583_s9_q[7:2];
      sum_588_s10_q <= sum_588;
      equal_599_s10_q <= equal_599_s9_q;
      not_604_s10_q <= not_604_s9_q[7:2];
      sum_609_s10_q <= sum_609;
      not_619_s10_q <= not_619_s9_q[7:2];
      sum_624_s10_q <= sum_624;
      and_633_s10_q <= and_633_s9_q;
      not_637_s10_q <= not_637_s9_q[7:2];
      sum_642_s10_q <= sum_642;
      and_657_s10_q <= and_657_s9_q;
      not_661_s10_q <= not_661_s9_q[7:2];
      sum_666_s10_q <= sum_666;
      not_676_s10_q <= not_676_s9_q[7:2];
      sum_681_s10_q <= sum_681;
      not_692_s10_q <= not_692_s9_q[7:2];
      sum_697_s10_q <= sum_697;
      not_716_s10_q <= not_716_s9_q[7:2];
      sum_721_s10_q <= sum_721;
      not_731_s10_q <= not_731_s9_q[7:2];
      sum_736_s10_q <= sum_736;
      and_746_s10_q <= and_746_s9_q;
      not_749_s10_q <= not_749_s9_q[7:2];
      sum_754_s10_q <= sum_754;
      and_775_s10_q <= and_775_s9_q;
      not_778_s10_q <= not_778_s9_q[7:2];
      sum_783_s10_q <= sum_783;
      not_793_s10_q <= not_793_s9_q[7:2];
      sum_798_s10_q <= sum_798;
      not_809_s10_q <= not_809_s9_q[7:2];
      sum_814_s10_q <= sum_814;
      equal_836_s10_q <= equal_836_s9_q;
      and_894_s10_q <= and_894_s9_q;
      sum_895_s10_q <= sum_895;
      partner_s10_q <= partner;
      equal_900_s10_q <= equal_900_s9_q;
      equal_910_s10_q <= equal_910_s9_q;
      and_914_s10_q <= and_914_s9_q;
      and_925_s10_q <= and_925_s9_q;
      not_946_s10_q <= not_946_s9_q;
      equal_966_s10_q <= equal_966_s9_q;
      and_1099_s10_q <= and_1099_s9_q;
      equal_1240_s10_q <= equal_1240_s9_q;
      equal_1292_s10_q <= equal_1292_s9_q;
      less_1569_s10_q <= less_1569_s9_q;
      less_1571_s10_q <= less_1571_s9_q;
      equal_1833_s10_q <= equal_1833_s9_q;
      less_1844_s10_q <= less_1844_s9_q;
      equal_1987_s10_q <= equal_1987_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:420
  logic [2:0] sum_550;
  assign sum_550 = {2'h0, not_544_s10_q[0]} + sum_549_s10_q;
  logic [2:0] sum_569;
  assign sum_569 = {2'h0, not_563_s10_q[0]} + sum_568_s10_q;
  logic [2:0] sum_589;
  assign sum_589 = {2'h0, not_583_s10_q[0]} + sum_588_s10_q;
  logic [2:0] sum_610;
  assign sum_610 = {2'h0, not_604_s10_q[0]} + sum_609_s10_q;
  logic [2:0] sum_625;
  assign sum_625 = {2'h0, not_619_s10_q[0]} + sum_624_s10_q;
  logic [2:0] sum_643;
  assign sum_643 = {2'h0, not_637_s10_q[0]} + sum_642_s10_q;
  logic [2:0] sum_667;
  assign sum_667 = {2'h0, not_661_s10_q[0]} + sum_666_s10_q;
  logic [2:0] sum_682;
  assign sum_682 = {2'h0, not_676_s10_q[0]} + sum_681_s10_q;
  logic [2:0] sum_698;
  assign sum_698 = {2'h0, not_692_s10_q[0]} + sum_697_s10_q;
  logic [2:0] sum_722;
  assign sum_722 = {2'h0, not_716_s10_q[0]} + sum_721_s10_q;
  logic [2:0] sum_737;
  assign sum_737 = {2'h0, not_731_s10_q[0]} + sum_736_s10_q;
  logic [2:0] sum_755;
  assign sum_755 = {2'h0, not_749_s10_q[0]} + sum_754_s10_q;
  logic [2:0] sum_784;
  assign sum_784 = {2'h0, not_778_s10_q[0]} + sum_783_s10_q;
  logic [2:0] sum_799;
  assign sum_799 = {2'h0, not_793_s10_q[0]} + sum_798_s10_q;
  logic [2:0] sum_815;
  assign sum_815 = {2'h0, not_809_s10_q[0]} + sum_814_s10_q;

  // Memory best_right, 120 x 15, DISTANCE 32, hls/stages/agreement.hpp:875; read in stage 10, written in stage 21: 10 < 21 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 15'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_381_s10_q ? sum_895_s10_q : partner_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_529_s10_q;
  logic [14:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

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
  logic equal_319_s11_q;
  logic [8:0] select_325_s11_q;
  logic and_334_s11_q;
  logic equal_340_s11_q;
  logic whole_s11_q;
  logic [6:0] column_s11_q;
  logic and_358_s11_q;
  logic and_360_s11_q;
  logic equal_363_s11_q;
  logic drew_s11_q;
  logic equal_380_s11_q;
  logic or_381_s11_q;
  logic equal_383_s11_q;
  logic less_386_s11_q;
  logic not_387_s11_q;
  logic equal_419_s11_q;
  logic left_rdata_s11_q;
  logic [6:0] x_s11_2_q;
  logic [21:0] best_left_rdata_s11_q;
  logic equal_532_s11_q;
  logic and_538_s11_q;
  logic and_539_s11_q;
  logic [3:0] not_544_s11_q;
  logic [3:0] sum_551_s11_q;
  logic and_557_s11_q;
  logic and_558_s11_q;
  logic [3:0] not_563_s11_q;
  logic [3:0] sum_570_s11_q;
  logic and_577_s11_q;
  logic and_578_s11_q;
  logic [3:0] not_583_s11_q;
  logic [3:0] sum_590_s11_q;
  logic equal_599_s11_q;
  logic [3:0] not_604_s11_q;
  logic [3:0] sum_611_s11_q;
  logic [3:0] not_619_s11_q;
  logic [3:0] sum_626_s11_q;
  logic and_633_s11_q;
  logic [3:0] not_637_s11_q;
  logic [3:0] sum_644_s11_q;
  logic and_657_s11_q;
  logic [3:0] not_661_s11_q;
  logic [3:0] sum_668_s11_q;
  logic [3:0] not_676_s11_q;
  logic [3:0] sum_683_s11_q;
  logic [3:0] not_692_s11_q;
  logic [3:0] sum_699_s11_q;
  logic [3:0] not_716_s11_q;
  logic [3:0] sum_723_s11_q;
  logic [3:0] not_731_s11_q;
  logic [3:0] sum_738_s11_q;
  logic and_746_s11_q;
  logic [3:0] not_749_s11_q;
  logic [3:0] sum_756_s11_q;
  logic and_775_s11_q;
  logic [3:0] not_778_s11_q;
  logic [3:0] sum_785_s11_q;
  logic [3:0] not_793_s11_q;
  logic [3:0] sum_800_s11_q;
  logic [3:0] not_809_s11_q;
  logic [3:0] sum_816_s11_q;
  logic equal_836_s11_q;
  logic and_894_s11_q;
  logic [6:0] sum_895_s11_q;
  logic [6:0] partner_s11_q;
  logic equal_900_s11_q;
  logic equal_910_s11_q;
  logic and_914_s11_q;
  logic and_925_s11_q;
  logic not_946_s11_q;
  logic equal_966_s11_q;
  logic and_1099_s11_q;
  logic equal_1240_s11_q;
  logic equal_1292_s11_q;
  logic less_1569_s11_q;
  logic less_1571_s11_q;
  logic equal_1833_s11_q;
  logic less_1844_s11_q;
  logic equal_1987_s11_q;
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
      equal_319_s11_q <= equal_319_s10_q;
      select_325_s11_q <= select_325_s10_q;
      and_334_s11_q <= and_334_s10_q;
      equal_340_s11_q <= equal_340_s10_q;
      whole_s11_q <= whole_s10_q;
      column_s11_q <= column_s10_q;
      and_358_s11_q <= and_358_s10_q;
      and_360_s11_q <= and_360_s10_q;
      equal_363_s11_q <= equal_363_s10_q;
      drew_s11_q <= drew_s10_q;
      equal_380_s11_q <= equal_380_s10_q;
      or_381_s11_q <= or_381_s10_q;
      equal_383_s11_q <= equal_383_s10_q;
      less_386_s11_q <= less_386_s10_q;
      not_387_s11_q <= not_387_s10_q;
      equal_419_s11_q <= equal_419_s10_q;
      left_rdata_s11_q <= left_rdata_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      equal_532_s11_q <= equal_532_s10_q;
      and_538_s11_q <= and_538_s10_q;
      and_539_s11_q <= and_539_s10_q;
      not_544_s11_q <= not_544_s10_q[5:2];
      sum_551_s11_q <= {3'h0, not_544_s10_q[1]} + {1'b0, sum_550};
      and_557_s11_q <= and_557_s10_q;
      and_558_s11_q <= and_558_s10_q;
      not_563_s11_q <= not_563_s10_q[5:2];
      sum_570_s11_q <= {3'h0, not_563_s10_q[1]} + {1'b0, sum_569};
      and_577_s11_q <= and_577_s10_q;
      and_578_s11_q <= and_578_s10_q;
      not_583_s11_q <= not_583_s10_q[5:2];
      sum_590_s11_q <= {3'h0, not_583_s10_q[1]} + {1'b0, sum_589};
      equal_599_s11_q <= equal_599_s10_q;
      not_604_s11_q <= not_604_s10_q[5:2];
      sum_611_s11_q <= {3'h0, not_604_s10_q[1]} + {1'b0, sum_610};
      not_619_s11_q <= not_619_s10_q[5:2];
      sum_626_s11_q <= {3'h0, not_619_s10_q[1]} + {1'b0, sum_625};
      and_633_s11_q <= and_633_s10_q;
      not_637_s11_q <= not_637_s10_q[5:2];
      sum_644_s11_q <= {3'h0, not_637_s10_q[1]} + {1'b0, sum_643};
      and_657_s11_q <= and_657_s10_q;
      not_661_s11_q <= not_661_s10_q[5:2];
      sum_668_s11_q <= {3'h0, not_661_s10_q[1]} + {1'b0, sum_667};
      not_676_s11_q <= not_676_s10_q[5:2];
      sum_683_s11_q <= {3'h0, not_676_s10_q[1]} + {1'b0, sum_682};
      not_692_s11_q <= not_692_s10_q[5:2];
      sum_699_s11_q <= {3'h0, not_692_s10_q[1]} + {1'b0, sum_698};
      not_716_s11_q <= not_716_s10_q[5:2];
      sum_723_s11_q <= {3'h0, not_716_s10_q[1]} + {1'b0, sum_722};
      not_731_s11_q <= not_731_s10_q[5:2];
      sum_738_s11_q <= {3'h0, not_731_s10_q[1]} + {1'b0, sum_737};
      and_746_s11_q <= and_746_s10_q;
      not_749_s11_q <= not_749_s10_q[5:2];
      sum_756_s11_q <= {3'h0, not_749_s10_q[1]} + {1'b0, sum_755};
      and_775_s11_q <= and_775_s10_q;
      not_778_s11_q <= not_778_s10_q[5:2];
      sum_785_s11_q <= {3'h0, not_778_s10_q[1]} + {1'b0, sum_784};
      not_793_s11_q <= not_793_s10_q[5:2];
      sum_800_s11_q <= {3'h0, not_793_s10_q[1]} + {1'b0, sum_799};
      not_809_s11_q <= not_809_s10_q[5:2];
      sum_816_s11_q <= {3'h0, not_809_s10_q[1]} + {1'b0, sum_815};
      equal_836_s11_q <= equal_836_s10_q;
      and_894_s11_q <= and_894_s10_q;
      sum_895_s11_q <= sum_895_s10_q;
      partner_s11_q <= partner_s10_q;
      equal_900_s11_q <= equal_900_s10_q;
      equal_910_s11_q <= equal_910_s10_q;
      and_914_s11_q <= and_914_s10_q;
      and_925_s11_q <= and_925_s10_q;
      not_946_s11_q <= not_946_s10_q;
      equal_966_s11_q <= equal_966_s10_q;
      and_1099_s11_q <= and_1099_s10_q;
      equal_1240_s11_q <= equal_1240_s10_q;
      equal_1292_s11_q <= equal_1292_s10_q;
      less_1569_s11_q <= less_1569_s10_q;
      less_1571_s11_q <= less_1571_s10_q;
      equal_1833_s11_q <= equal_1833_s10_q;
      less_1844_s11_q <= less_1844_s10_q;
      equal_1987_s11_q <= equal_1987_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:420
  logic [3:0] sum_553;
  assign sum_553 = {3'h0, not_544_s11_q[1]} + ({3'h0, not_544_s11_q[0]} + sum_551_s11_q);
  logic [3:0] sum_572;
  assign sum_572 = {3'h0, not_563_s11_q[1]} + ({3'h0, not_563_s11_q[0]} + sum_570_s11_q);
  logic [3:0] sum_592;
  assign sum_592 = {3'h0, not_583_s11_q[1]} + ({3'h0, not_583_s11_q[0]} + sum_590_s11_q);
  logic [3:0] sum_613;
  assign sum_613 = {3'h0, not_604_s11_q[1]} + ({3'h0, not_604_s11_q[0]} + sum_611_s11_q);
  logic [3:0] sum_628;
  assign sum_628 = {3'h0, not_619_s11_q[1]} + ({3'h0, not_619_s11_q[0]} + sum_626_s11_q);
  logic [3:0] sum_646;
  assign sum_646 = {3'h0, not_637_s11_q[1]} + ({3'h0, not_637_s11_q[0]} + sum_644_s11_q);
  logic [3:0] sum_670;
  assign sum_670 = {3'h0, not_661_s11_q[1]} + ({3'h0, not_661_s11_q[0]} + sum_668_s11_q);
  logic [3:0] sum_685;
  assign sum_685 = {3'h0, not_676_s11_q[1]} + ({3'h0, not_676_s11_q[0]} + sum_683_s11_q);
  logic [3:0] sum_701;
  assign sum_701 = {3'h0, not_692_s11_q[1]} + ({3'h0, not_692_s11_q[0]} + sum_699_s11_q);
  logic [3:0] sum_725;
  assign sum_725 = {3'h0, not_716_s11_q[1]} + ({3'h0, not_716_s11_q[0]} + sum_723_s11_q);
  logic [3:0] sum_740;
  assign sum_740 = {3'h0, not_731_s11_q[1]} + ({3'h0, not_731_s11_q[0]} + sum_738_s11_q);
  logic [3:0] sum_758;
  assign sum_758 = {3'h0, not_749_s11_q[1]} + ({3'h0, not_749_s11_q[0]} + sum_756_s11_q);
  logic [3:0] sum_787;
  assign sum_787 = {3'h0, not_778_s11_q[1]} + ({3'h0, not_778_s11_q[0]} + sum_785_s11_q);
  logic [3:0] sum_802;
  assign sum_802 = {3'h0, not_793_s11_q[1]} + ({3'h0, not_793_s11_q[0]} + sum_800_s11_q);
  logic [3:0] sum_818;
  assign sum_818 = {3'h0, not_809_s11_q[1]} + ({3'h0, not_809_s11_q[0]} + sum_816_s11_q);

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
  logic equal_319_s12_q;
  logic [8:0] select_325_s12_q;
  logic and_334_s12_q;
  logic equal_340_s12_q;
  logic whole_s12_q;
  logic [6:0] column_s12_q;
  logic and_358_s12_q;
  logic and_360_s12_q;
  logic equal_363_s12_q;
  logic drew_s12_q;
  logic equal_380_s12_q;
  logic or_381_s12_q;
  logic equal_383_s12_q;
  logic less_386_s12_q;
  logic not_387_s12_q;
  logic equal_419_s12_q;
  logic left_rdata_s12_q;
  logic [6:0] x_s12_2_q;
  logic [21:0] best_left_rdata_s12_q;
  logic equal_532_s12_q;
  logic and_538_s12_q;
  logic and_539_s12_q;
  logic [1:0] not_544_s12_q;
  logic [3:0] sum_553_s12_q;
  logic and_557_s12_q;
  logic and_558_s12_q;
  logic [1:0] not_563_s12_q;
  logic [3:0] sum_572_s12_q;
  logic and_577_s12_q;
  logic and_578_s12_q;
  logic [1:0] not_583_s12_q;
  logic [3:0] sum_592_s12_q;
  logic equal_599_s12_q;
  logic [1:0] not_604_s12_q;
  logic [3:0] sum_613_s12_q;
  logic [1:0] not_619_s12_q;
  logic [3:0] sum_628_s12_q;
  logic and_633_s12_q;
  logic [1:0] not_637_s12_q;
  logic [3:0] sum_646_s12_q;
  logic and_657_s12_q;
  logic [1:0] not_661_s12_q;
  logic [3:0] sum_670_s12_q;
  logic [1:0] not_676_s12_q;
  logic [3:0] sum_685_s12_q;
  logic [1:0] not_692_s12_q;
  logic [3:0] sum_701_s12_q;
  logic [1:0] not_716_s12_q;
  logic [3:0] sum_725_s12_q;
  logic [1:0] not_731_s12_q;
  logic [3:0] sum_740_s12_q;
  logic and_746_s12_q;
  logic [1:0] not_749_s12_q;
  logic [3:0] sum_758_s12_q;
  logic and_775_s12_q;
  logic [1:0] not_778_s12_q;
  logic [3:0] sum_787_s12_q;
  logic [1:0] not_793_s12_q;
  logic [3:0] sum_802_s12_q;
  logic [1:0] not_809_s12_q;
  logic [3:0] sum_818_s12_q;
  logic equal_836_s12_q;
  logic and_894_s12_q;
  logic [6:0] sum_895_s12_q;
  logic [6:0] partner_s12_q;
  logic [14:0] best_right_rdata_s12_q;
  logic equal_900_s12_q;
  logic equal_910_s12_q;
  logic and_914_s12_q;
  logic and_925_s12_q;
  logic not_946_s12_q;
  logic equal_966_s12_q;
  logic and_1099_s12_q;
  logic equal_1240_s12_q;
  logic equal_1292_s12_q;
  logic less_1569_s12_q;
  logic less_1571_s12_q;
  logic equal_1833_s12_q;
  logic less_1844_s12_q;
  logic equal_1987_s12_q;
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
      equal_319_s12_q <= equal_319_s11_q;
      select_325_s12_q <= select_325_s11_q;
      and_334_s12_q <= and_334_s11_q;
      equal_340_s12_q <= equal_340_s11_q;
      whole_s12_q <= whole_s11_q;
      column_s12_q <= column_s11_q;
      and_358_s12_q <= and_358_s11_q;
      and_360_s12_q <= and_360_s11_q;
      equal_363_s12_q <= equal_363_s11_q;
      drew_s12_q <= drew_s11_q;
      equal_380_s12_q <= equal_380_s11_q;
      or_381_s12_q <= or_381_s11_q;
      equal_383_s12_q <= equal_383_s11_q;
      less_386_s12_q <= less_386_s11_q;
      not_387_s12_q <= not_387_s11_q;
      equal_419_s12_q <= equal_419_s11_q;
      left_rdata_s12_q <= left_rdata_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      equal_532_s12_q <= equal_532_s11_q;
      and_538_s12_q <= and_538_s11_q;
      and_539_s12_q <= and_539_s11_q;
      not_544_s12_q <= not_544_s11_q[3:2];
      sum_553_s12_q <= sum_553;
      and_557_s12_q <= and_557_s11_q;
      and_558_s12_q <= and_558_s11_q;
      not_563_s12_q <= not_563_s11_q[3:2];
      sum_572_s12_q <= sum_572;
      and_577_s12_q <= and_577_s11_q;
      and_578_s12_q <= and_578_s11_q;
      not_583_s12_q <= not_583_s11_q[3:2];
      sum_592_s12_q <= sum_592;
      equal_599_s12_q <= equal_599_s11_q;
      not_604_s12_q <= not_604_s11_q[3:2];
      sum_613_s12_q <= sum_613;
      not_619_s12_q <= not_619_s11_q[3:2];
      sum_628_s12_q <= sum_628;
      and_633_s12_q <= and_633_s11_q;
      not_637_s12_q <= not_637_s11_q[3:2];
      sum_646_s12_q <= sum_646;
      and_657_s12_q <= and_657_s11_q;
      not_661_s12_q <= not_661_s11_q[3:2];
      sum_670_s12_q <= sum_670;
      not_676_s12_q <= not_676_s11_q[3:2];
      sum_685_s12_q <= sum_685;
      not_692_s12_q <= not_692_s11_q[3:2];
      sum_701_s12_q <= sum_701;
      not_716_s12_q <= not_716_s11_q[3:2];
      sum_725_s12_q <= sum_725;
      not_731_s12_q <= not_731_s11_q[3:2];
      sum_740_s12_q <= sum_740;
      and_746_s12_q <= and_746_s11_q;
      not_749_s12_q <= not_749_s11_q[3:2];
      sum_758_s12_q <= sum_758;
      and_775_s12_q <= and_775_s11_q;
      not_778_s12_q <= not_778_s11_q[3:2];
      sum_787_s12_q <= sum_787;
      not_793_s12_q <= not_793_s11_q[3:2];
      sum_802_s12_q <= sum_802;
      not_809_s12_q <= not_809_s11_q[3:2];
      sum_818_s12_q <= sum_818;
      equal_836_s12_q <= equal_836_s11_q;
      and_894_s12_q <= and_894_s11_q;
      sum_895_s12_q <= sum_895_s11_q;
      partner_s12_q <= partner_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      equal_900_s12_q <= equal_900_s11_q;
      equal_910_s12_q <= equal_910_s11_q;
      and_914_s12_q <= and_914_s11_q;
      and_925_s12_q <= and_925_s11_q;
      not_946_s12_q <= not_946_s11_q;
      equal_966_s12_q <= equal_966_s11_q;
      and_1099_s12_q <= and_1099_s11_q;
      equal_1240_s12_q <= equal_1240_s11_q;
      equal_1292_s12_q <= equal_1292_s11_q;
      less_1569_s12_q <= less_1569_s11_q;
      less_1571_s12_q <= less_1571_s11_q;
      equal_1833_s12_q <= equal_1833_s11_q;
      less_1844_s12_q <= less_1844_s11_q;
      equal_1987_s12_q <= equal_1987_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [23:0] registration_next_slope_row_q;
  logic [27:0] registration_next_slope_change_q;
  // hls/stages/agreement.hpp:420
  logic [3:0] sum_555;
  assign sum_555 = {3'h0, not_544_s12_q[1]} + ({3'h0, not_544_s12_q[0]} + sum_553_s12_q);
  logic [3:0] column_2;
  assign column_2 = (and_538_s12_q & and_539_s12_q) ? sum_555 : 4'h0;
  logic [3:0] sum_574;
  assign sum_574 = {3'h0, not_563_s12_q[1]} + ({3'h0, not_563_s12_q[0]} + sum_572_s12_q);
  logic [3:0] sum_594;
  assign sum_594 = {3'h0, not_583_s12_q[1]} + ({3'h0, not_583_s12_q[0]} + sum_592_s12_q);
  logic [3:0] sum_615;
  assign sum_615 = {3'h0, not_604_s12_q[1]} + ({3'h0, not_604_s12_q[0]} + sum_613_s12_q);
  logic [3:0] column_5;
  assign column_5 = (and_538_s12_q & and_558_s12_q) ? sum_615 : 4'h0;
  logic [3:0] sum_630;
  assign sum_630 = {3'h0, not_619_s12_q[1]} + ({3'h0, not_619_s12_q[0]} + sum_628_s12_q);
  logic [3:0] sum_648;
  assign sum_648 = {3'h0, not_637_s12_q[1]} + ({3'h0, not_637_s12_q[0]} + sum_646_s12_q);
  logic [3:0] sum_672;
  assign sum_672 = {3'h0, not_661_s12_q[1]} + ({3'h0, not_661_s12_q[0]} + sum_670_s12_q);
  logic [3:0] column_8;
  assign column_8 = (and_538_s12_q & and_657_s12_q) ? sum_672 : 4'h0;
  logic [3:0] sum_687;
  assign sum_687 = {3'h0, not_676_s12_q[1]} + ({3'h0, not_676_s12_q[0]} + sum_685_s12_q);
  logic [3:0] sum_703;
  assign sum_703 = {3'h0, not_692_s12_q[1]} + ({3'h0, not_692_s12_q[0]} + sum_701_s12_q);
  logic [3:0] sum_727;
  assign sum_727 = {3'h0, not_716_s12_q[1]} + ({3'h0, not_716_s12_q[0]} + sum_725_s12_q);
  logic [3:0] column_11;
  assign column_11 = (and_538_s12_q & and_578_s12_q) ? sum_727 : 4'h0;
  logic [3:0] sum_742;
  assign sum_742 = {3'h0, not_731_s12_q[1]} + ({3'h0, not_731_s12_q[0]} + sum_740_s12_q);
  logic [3:0] sum_760;
  assign sum_760 = {3'h0, not_749_s12_q[1]} + ({3'h0, not_749_s12_q[0]} + sum_758_s12_q);
  logic [3:0] sum_789;
  assign sum_789 = {3'h0, not_778_s12_q[1]} + ({3'h0, not_778_s12_q[0]} + sum_787_s12_q);
  logic [3:0] column_14;
  assign column_14 = and_775_s12_q ? sum_789 : 4'h0;
  logic [3:0] sum_804;
  assign sum_804 = {3'h0, not_793_s12_q[1]} + ({3'h0, not_793_s12_q[0]} + sum_802_s12_q);
  logic [3:0] sum_820;
  assign sum_820 = {3'h0, not_809_s12_q[1]} + ({3'h0, not_809_s12_q[0]} + sum_818_s12_q);
  // hls/stages/agreement.hpp:574
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_s12_q[14:8]} - {1'b0, x_s12_q};
  // hls/stages/agreement.hpp:580
  logic and_932;
  assign and_932 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s12_q[13:8]));
  // hls/stages/registration.hpp:158
  logic [16:0] select_1576;
  assign select_1576 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/registration.hpp:57
  logic [23:0] select_1834;
  assign select_1834 = equal_1833_s12_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:205
  logic [23:0] select_1836;
  assign select_1836 = and_360_s12_q ? (equal_1292_s12_q ? select_1834 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1837;
  assign select_1837 = equal_1833_s12_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:205
  logic [27:0] select_1839;
  assign select_1839 = and_360_s12_q ? (equal_1292_s12_q ? select_1837 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1841;
  assign select_1841 = drew_s12_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1842;
  assign sum_1842 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1843;
  assign sum_1843 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      registration_next_slope_row_q <= 24'h0;
      registration_next_slope_change_q <= 28'h0;
    end else if (s12_en) begin
      registration_slope_row_q <= select_1836;
      registration_slope_change_q <= select_1839;
      registration_slope_q <= select_1841;
      registration_next_slope_row_q <= sum_1842;
      registration_next_slope_change_q <= sum_1843;
    end
  end

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
  logic equal_319_s13_q;
  logic [8:0] select_325_s13_q;
  logic and_334_s13_q;
  logic equal_340_s13_q;
  logic whole_s13_q;
  logic [6:0] column_s13_q;
  logic and_358_s13_q;
  logic and_360_s13_q;
  logic equal_363_s13_q;
  logic drew_s13_q;
  logic equal_380_s13_q;
  logic or_381_s13_q;
  logic equal_383_s13_q;
  logic less_386_s13_q;
  logic not_387_s13_q;
  logic equal_419_s13_q;
  logic left_rdata_s13_q;
  logic [6:0] x_s13_2_q;
  logic [21:0] best_left_rdata_s13_q;
  logic equal_532_s13_q;
  logic [3:0] column_2_s13_q;
  logic [3:0] select_575_s13_q;
  logic [3:0] select_595_s13_q;
  logic equal_599_s13_q;
  logic [3:0] column_5_s13_q;
  logic [3:0] select_631_s13_q;
  logic [3:0] select_649_s13_q;
  logic [3:0] column_8_s13_q;
  logic [3:0] select_688_s13_q;
  logic [3:0] select_704_s13_q;
  logic [3:0] column_11_s13_q;
  logic [3:0] select_743_s13_q;
  logic [3:0] select_761_s13_q;
  logic [3:0] column_14_s13_q;
  logic [3:0] select_805_s13_q;
  logic [3:0] select_821_s13_q;
  logic equal_836_s13_q;
  logic and_894_s13_q;
  logic [6:0] sum_895_s13_q;
  logic [6:0] partner_s13_q;
  logic [14:0] best_right_rdata_s13_q;
  logic equal_900_s13_q;
  logic equal_910_s13_q;
  logic and_914_s13_q;
  logic and_917_s13_q;
  logic [8:0] way_s13_q;
  logic and_925_s13_q;
  logic and_932_s13_q;
  logic not_946_s13_q;
  logic equal_966_s13_q;
  logic and_1099_s13_q;
  logic equal_1240_s13_q;
  logic equal_1292_s13_q;
  logic less_1569_s13_q;
  logic less_1571_s13_q;
  logic [16:0] select_1576_s13_q;
  logic less_1844_s13_q;
  logic equal_1987_s13_q;
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
      registration_slope_s13_q <= registration_slope_q[27:16];
      equal_319_s13_q <= equal_319_s12_q;
      select_325_s13_q <= select_325_s12_q;
      and_334_s13_q <= and_334_s12_q;
      equal_340_s13_q <= equal_340_s12_q;
      whole_s13_q <= whole_s12_q;
      column_s13_q <= column_s12_q;
      and_358_s13_q <= and_358_s12_q;
      and_360_s13_q <= and_360_s12_q;
      equal_363_s13_q <= equal_363_s12_q;
      drew_s13_q <= drew_s12_q;
      equal_380_s13_q <= equal_380_s12_q;
      or_381_s13_q <= or_381_s12_q;
      equal_383_s13_q <= equal_383_s12_q;
      less_386_s13_q <= less_386_s12_q;
      not_387_s13_q <= not_387_s12_q;
      equal_419_s13_q <= equal_419_s12_q;
      left_rdata_s13_q <= left_rdata_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      equal_532_s13_q <= equal_532_s12_q;
      column_2_s13_q <= column_2;
      select_575_s13_q <= (and_557_s12_q & and_558_s12_q) ? sum_574 : 4'h0;
      select_595_s13_q <= (and_577_s12_q & and_578_s12_q) ? sum_594 : 4'h0;
      equal_599_s13_q <= equal_599_s12_q;
      column_5_s13_q <= column_5;
      select_631_s13_q <= (and_557_s12_q & and_578_s12_q) ? sum_630 : 4'h0;
      select_649_s13_q <= (and_577_s12_q & and_633_s12_q) ? sum_648 : 4'h0;
      column_8_s13_q <= column_8;
      select_688_s13_q <= (and_557_s12_q & and_539_s12_q) ? sum_687 : 4'h0;
      select_704_s13_q <= (and_577_s12_q & and_558_s12_q) ? sum_703 : 4'h0;
      column_11_s13_q <= column_11;
      select_743_s13_q <= (and_557_s12_q & and_633_s12_q) ? sum_742 : 4'h0;
      select_761_s13_q <= and_746_s12_q ? sum_760 : 4'h0;
      column_14_s13_q <= column_14;
      select_805_s13_q <= (and_557_s12_q & and_657_s12_q) ? sum_804 : 4'h0;
      select_821_s13_q <= (and_577_s12_q & and_539_s12_q) ? sum_820 : 4'h0;
      equal_836_s13_q <= equal_836_s12_q;
      and_894_s13_q <= and_894_s12_q;
      sum_895_s13_q <= sum_895_s12_q;
      partner_s13_q <= partner_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      equal_900_s13_q <= equal_900_s12_q;
      equal_910_s13_q <= equal_910_s12_q;
      and_914_s13_q <= and_914_s12_q;
      and_917_s13_q <= left_rdata_s12_q & (8'hb6 < best_left_rdata_s12_q[7:0]);
      way_s13_q <= way;
      and_925_s13_q <= and_925_s12_q;
      and_932_s13_q <= and_932;
      not_946_s13_q <= not_946_s12_q;
      equal_966_s13_q <= equal_966_s12_q;
      and_1099_s13_q <= and_1099_s12_q;
      equal_1240_s13_q <= equal_1240_s12_q;
      equal_1292_s13_q <= equal_1292_s12_q;
      less_1569_s13_q <= less_1569_s12_q;
      less_1571_s13_q <= less_1571_s12_q;
      select_1576_s13_q <= select_1576;
      less_1844_s13_q <= less_1844_s12_q;
      equal_1987_s13_q <= equal_1987_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:448
  logic [4:0] column_3;
  assign column_3 = {1'b0, column_2_s13_q} + {1'b0, select_575_s13_q};
  logic [5:0] column_4;
  assign column_4 = {1'b0, column_3} + {2'h0, select_595_s13_q};
  logic [4:0] column_6;
  assign column_6 = {1'b0, column_5_s13_q} + {1'b0, select_631_s13_q};
  logic [5:0] column_7;
  assign column_7 = {1'b0, column_6} + {2'h0, select_649_s13_q};
  logic [4:0] column_9;
  assign column_9 = {1'b0, column_8_s13_q} + {1'b0, select_688_s13_q};
  logic [5:0] column_10;
  assign column_10 = {1'b0, column_9} + {2'h0, select_704_s13_q};
  logic [4:0] column_12;
  assign column_12 = {1'b0, column_11_s13_q} + {1'b0, select_743_s13_q};
  logic [5:0] column_13;
  assign column_13 = {1'b0, column_12} + {2'h0, select_761_s13_q};
  logic [4:0] column_15;
  assign column_15 = {1'b0, column_14_s13_q} + {1'b0, select_805_s13_q};
  logic [5:0] column_16;
  assign column_16 = {1'b0, column_15} + {2'h0, select_821_s13_q};
  // hls/stages/agreement.hpp:578
  logic and_920;
  assign and_920 = and_917_s13_q & ($signed(9'h1fe) < $signed(way_s13_q));
  logic and_921;
  assign and_921 = left_rdata_s13_q & and_914_s13_q;
  logic less_926;
  assign less_926 = $signed(way_s13_q[8:1]) < $signed(8'h1);
  // hls/stages/agreement.hpp:174
  logic and_934;
  assign and_934 = less_926 & ((cfg_nearer_below_i & best_left_rdata_s13_q[13]) | and_932_s13_q);
  // hls/stages/registration.hpp:158
  logic [13:0] select_1578;
  assign select_1578 = ($signed(10'h0) < $signed(select_1576_s13_q[16:7])) ? 14'h7f : select_1576_s13_q[13:0];

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
  logic equal_319_s14_q;
  logic [8:0] select_325_s14_q;
  logic and_334_s14_q;
  logic equal_340_s14_q;
  logic whole_s14_q;
  logic [6:0] column_s14_q;
  logic and_358_s14_q;
  logic and_360_s14_q;
  logic equal_363_s14_q;
  logic drew_s14_q;
  logic equal_380_s14_q;
  logic or_381_s14_q;
  logic equal_383_s14_q;
  logic less_386_s14_q;
  logic not_387_s14_q;
  logic equal_419_s14_q;
  logic [6:0] x_s14_2_q;
  logic [21:0] best_left_rdata_s14_q;
  logic equal_532_s14_q;
  logic [5:0] column_4_s14_q;
  logic equal_599_s14_q;
  logic [5:0] column_7_s14_q;
  logic [5:0] column_10_s14_q;
  logic [5:0] column_13_s14_q;
  logic [5:0] column_16_s14_q;
  logic equal_836_s14_q;
  logic and_894_s14_q;
  logic [6:0] sum_895_s14_q;
  logic [6:0] partner_s14_q;
  logic [14:0] best_right_rdata_s14_q;
  logic equal_900_s14_q;
  logic equal_910_s14_q;
  logic and_914_s14_q;
  logic select_923_s14_q;
  logic and_925_s14_q;
  logic and_929_s14_q;
  logic and_935_s14_q;
  logic [5:0] select_938_s14_q;
  logic not_946_s14_q;
  logic equal_966_s14_q;
  logic and_1099_s14_q;
  logic equal_1240_s14_q;
  logic equal_1292_s14_q;
  logic less_1569_s14_q;
  logic less_1571_s14_q;
  logic [13:0] select_1578_s14_q;
  logic less_1844_s14_q;
  logic equal_1987_s14_q;
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
      equal_319_s14_q <= equal_319_s13_q;
      select_325_s14_q <= select_325_s13_q;
      and_334_s14_q <= and_334_s13_q;
      equal_340_s14_q <= equal_340_s13_q;
      whole_s14_q <= whole_s13_q;
      column_s14_q <= column_s13_q;
      and_358_s14_q <= and_358_s13_q;
      and_360_s14_q <= and_360_s13_q;
      equal_363_s14_q <= equal_363_s13_q;
      drew_s14_q <= drew_s13_q;
      equal_380_s14_q <= equal_380_s13_q;
      or_381_s14_q <= or_381_s13_q;
      equal_383_s14_q <= equal_383_s13_q;
      less_386_s14_q <= less_386_s13_q;
      not_387_s14_q <= not_387_s13_q;
      equal_419_s14_q <= equal_419_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      equal_532_s14_q <= equal_532_s13_q;
      column_4_s14_q <= column_4;
      equal_599_s14_q <= equal_599_s13_q;
      column_7_s14_q <= column_7;
      column_10_s14_q <= column_10;
      column_13_s14_q <= column_13;
      column_16_s14_q <= column_16;
      equal_836_s14_q <= equal_836_s13_q;
      and_894_s14_q <= and_894_s13_q;
      sum_895_s14_q <= sum_895_s13_q;
      partner_s14_q <= partner_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      equal_900_s14_q <= equal_900_s13_q;
      equal_910_s14_q <= equal_910_s13_q;
      and_914_s14_q <= and_914_s13_q;
      select_923_s14_q <= and_914_s13_q ? (and_920 ? left_rdata_s13_q : and_921) : and_921;
      and_925_s14_q <= and_925_s13_q;
      and_929_s14_q <= not_387_s13_q & (and_914_s13_q & (and_920 & less_926));
      and_935_s14_q <= and_920 & and_934;
      select_938_s14_q <= less_386_s13_q ? 6'h0 : best_left_rdata_s13_q[13:8];
      not_946_s14_q <= not_946_s13_q;
      equal_966_s14_q <= equal_966_s13_q;
      and_1099_s14_q <= and_1099_s13_q;
      equal_1240_s14_q <= equal_1240_s13_q;
      equal_1292_s14_q <= equal_1292_s13_q;
      less_1569_s14_q <= less_1569_s13_q;
      less_1571_s14_q <= less_1571_s13_q;
      select_1578_s14_q <= select_1578;
      less_1844_s14_q <= less_1844_s13_q;
      equal_1987_s14_q <= equal_1987_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_598;
  assign difference_598 = {2'h0, column_4_s14_q} - (age_s14_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] difference_652;
  assign difference_652 = {2'h0, column_7_s14_q} - (age_s14_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] difference_707;
  assign difference_707 = {2'h0, column_10_s14_q} - (age_s14_q[1] ? sums_3_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:582
  logic and_915;
  assign and_915 = not_387_s14_q & and_914_s14_q;
  logic and_924;
  assign and_924 = not_387_s14_q & select_923_s14_q;
  logic and_937;
  assign and_937 = not_387_s14_q & (and_914_s14_q & and_935_s14_q);
  // hls/stages/agreement.hpp:181
  logic [11:0] select_939;
  assign select_939 = or_381_s14_q ? {select_938_s14_q, and_937, and_929_s14_q, and_925_s14_q, and_924, and_915, not_387_s14_q} : 12'h0;
  logic [7:0] select_1406;
  assign select_1406 = equal_383_s14_q ? {2'h0, column_7_s14_q} : sums_1_columns_values_0_q;
  logic [7:0] select_1408;
  assign select_1408 = equal_383_s14_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1410;
  assign select_1410 = equal_383_s14_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1412;
  assign select_1412 = equal_383_s14_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1414;
  assign select_1414 = equal_383_s14_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1416;
  assign select_1416 = equal_383_s14_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1418;
  assign select_1418 = equal_383_s14_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1422;
  assign select_1422 = equal_383_s14_q ? {2'h0, column_4_s14_q} : sums_2_columns_values_0_q;
  logic [7:0] select_1424;
  assign select_1424 = equal_383_s14_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1426;
  assign select_1426 = equal_383_s14_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1428;
  assign select_1428 = equal_383_s14_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1430;
  assign select_1430 = equal_383_s14_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1432;
  assign select_1432 = equal_383_s14_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1434;
  assign select_1434 = equal_383_s14_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1438;
  assign select_1438 = equal_383_s14_q ? {2'h0, column_10_s14_q} : sums_3_columns_values_0_q;
  logic [7:0] select_1440;
  assign select_1440 = equal_383_s14_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1442;
  assign select_1442 = equal_383_s14_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1444;
  assign select_1444 = equal_383_s14_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1446;
  assign select_1446 = equal_383_s14_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1448;
  assign select_1448 = equal_383_s14_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1450;
  assign select_1450 = equal_383_s14_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  // hls/stages/registration.hpp:153
  logic [9:0] select_1579;
  assign select_1579 = select_939[10] ? select_1578_s14_q[9:0] : 10'h0;
  logic [8:0] difference_1581;
  assign difference_1581 = select_1579[9:1] - (select_939[11] ? select_1578_s14_q[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1584;
  assign sum_1584 = (select_939[6] ? select_1578_s14_q[13:1] : 13'h0) + (select_939[7] ? select_1578_s14_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1585;
  assign select_1585 = select_939[8] ? select_1578_s14_q[11:0] : 12'h0;
  logic [10:0] sum_1587;
  assign sum_1587 = select_1585[11:1] + (select_939[9] ? select_1578_s14_q[10:0] : 11'h0);

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
    if (s14_en) begin
      sums_1_columns_values_0_q <= or_381_s14_q ? sums_1_columns_values_0_q : select_1406;
      sums_1_columns_values_1_q <= or_381_s14_q ? sums_1_columns_values_1_q : select_1408;
      sums_1_columns_values_2_q <= or_381_s14_q ? sums_1_columns_values_2_q : select_1410;
      sums_1_columns_values_3_q <= or_381_s14_q ? sums_1_columns_values_3_q : select_1412;
      sums_1_columns_values_4_q <= or_381_s14_q ? sums_1_columns_values_4_q : select_1414;
      sums_1_columns_values_5_q <= or_381_s14_q ? sums_1_columns_values_5_q : select_1416;
      sums_1_columns_values_6_q <= or_381_s14_q ? sums_1_columns_values_6_q : select_1418;
      sums_2_columns_values_0_q <= or_381_s14_q ? sums_2_columns_values_0_q : select_1422;
      sums_2_columns_values_1_q <= or_381_s14_q ? sums_2_columns_values_1_q : select_1424;
      sums_2_columns_values_2_q <= or_381_s14_q ? sums_2_columns_values_2_q : select_1426;
      sums_2_columns_values_3_q <= or_381_s14_q ? sums_2_columns_values_3_q : select_1428;
      sums_2_columns_values_4_q <= or_381_s14_q ? sums_2_columns_values_4_q : select_1430;
      sums_2_columns_values_5_q <= or_381_s14_q ? sums_2_columns_values_5_q : select_1432;
      sums_2_columns_values_6_q <= or_381_s14_q ? sums_2_columns_values_6_q : select_1434;
      sums_3_columns_values_0_q <= or_381_s14_q ? sums_3_columns_values_0_q : select_1438;
      sums_3_columns_values_1_q <= or_381_s14_q ? sums_3_columns_values_1_q : select_1440;
      sums_3_columns_values_2_q <= or_381_s14_q ? sums_3_columns_values_2_q : select_1442;
      sums_3_columns_values_3_q <= or_381_s14_q ? sums_3_columns_values_3_q : select_1444;
      sums_3_columns_values_4_q <= or_381_s14_q ? sums_3_columns_values_4_q : select_1446;
      sums_3_columns_values_5_q <= or_381_s14_q ? sums_3_columns_values_5_q : select_1448;
      sums_3_columns_values_6_q <= or_381_s14_q ? sums_3_columns_values_6_q : select_1450;
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
  logic [1:0] age_s15_q;
  logic lower_half_s15_q;
  logic [11:0] registration_slope_s15_q;
  logic equal_319_s15_q;
  logic [8:0] select_325_s15_q;
  logic and_334_s15_q;
  logic equal_340_s15_q;
  logic whole_s15_q;
  logic [6:0] column_s15_q;
  logic and_358_s15_q;
  logic and_360_s15_q;
  logic equal_363_s15_q;
  logic drew_s15_q;
  logic or_381_s15_q;
  logic equal_383_s15_q;
  logic less_386_s15_q;
  logic equal_419_s15_q;
  logic [6:0] x_s15_2_q;
  logic [21:0] best_left_rdata_s15_q;
  logic equal_532_s15_q;
  logic [7:0] difference_598_s15_q;
  logic equal_599_s15_q;
  logic [7:0] difference_652_s15_q;
  logic [7:0] difference_707_s15_q;
  logic [5:0] column_13_s15_q;
  logic [5:0] column_16_s15_q;
  logic equal_836_s15_q;
  logic and_894_s15_q;
  logic [6:0] sum_895_s15_q;
  logic [6:0] partner_s15_q;
  logic [14:0] best_right_rdata_s15_q;
  logic equal_900_s15_q;
  logic equal_910_s15_q;
  logic [11:0] select_939_s15_q;
  logic not_946_s15_q;
  logic select_949_s15_q;
  logic equal_966_s15_q;
  logic and_1099_s15_q;
  logic equal_1240_s15_q;
  logic equal_1292_s15_q;
  logic less_1569_s15_q;
  logic less_1571_s15_q;
  logic select_1579_s15_q;
  logic [8:0] difference_1581_s15_q;
  logic [11:0] sum_1584_s15_q;
  logic select_1585_s15_q;
  logic [10:0] sum_1587_s15_q;
  logic less_1844_s15_q;
  logic equal_1987_s15_q;
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
      age_s15_q <= age_s14_q;
      lower_half_s15_q <= lower_half_s14_q;
      registration_slope_s15_q <= registration_slope_s14_q;
      equal_319_s15_q <= equal_319_s14_q;
      select_325_s15_q <= select_325_s14_q;
      and_334_s15_q <= and_334_s14_q;
      equal_340_s15_q <= equal_340_s14_q;
      whole_s15_q <= whole_s14_q;
      column_s15_q <= column_s14_q;
      and_358_s15_q <= and_358_s14_q;
      and_360_s15_q <= and_360_s14_q;
      equal_363_s15_q <= equal_363_s14_q;
      drew_s15_q <= drew_s14_q;
      or_381_s15_q <= or_381_s14_q;
      equal_383_s15_q <= equal_383_s14_q;
      less_386_s15_q <= less_386_s14_q;
      equal_419_s15_q <= equal_419_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      equal_532_s15_q <= equal_532_s14_q;
      difference_598_s15_q <= difference_598;
      equal_599_s15_q <= equal_599_s14_q;
      difference_652_s15_q <= difference_652;
      difference_707_s15_q <= difference_707;
      column_13_s15_q <= column_13_s14_q;
      column_16_s15_q <= column_16_s14_q;
      equal_836_s15_q <= equal_836_s14_q;
      and_894_s15_q <= and_894_s14_q;
      sum_895_s15_q <= sum_895_s14_q;
      partner_s15_q <= partner_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      equal_900_s15_q <= equal_900_s14_q;
      equal_910_s15_q <= equal_910_s14_q;
      select_939_s15_q <= select_939;
      not_946_s15_q <= not_946_s14_q;
      select_949_s15_q <= drew_s14_q ? select_939[0] : (equal_380_s14_q & select_939[4]);
      equal_966_s15_q <= equal_966_s14_q;
      and_1099_s15_q <= and_1099_s14_q;
      equal_1240_s15_q <= equal_1240_s14_q;
      equal_1292_s15_q <= equal_1292_s14_q;
      less_1569_s15_q <= less_1569_s14_q;
      less_1571_s15_q <= less_1571_s14_q;
      select_1579_s15_q <= select_1579[0];
      difference_1581_s15_q <= difference_1581;
      sum_1584_s15_q <= sum_1584[12:1];
      select_1585_s15_q <= select_1585[0];
      sum_1587_s15_q <= sum_1587;
      less_1844_s15_q <= less_1844_s14_q;
      equal_1987_s15_q <= equal_1987_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:450
  logic [7:0] sum_601;
  assign sum_601 = difference_598_s15_q + (equal_599_s15_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  logic [7:0] sum_654;
  assign sum_654 = difference_652_s15_q + (equal_599_s15_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  logic [7:0] sum_709;
  assign sum_709 = difference_707_s15_q + (equal_599_s15_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  logic [7:0] difference_764;
  assign difference_764 = {2'h0, column_13_s15_q} - (age_s15_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] difference_824;
  assign difference_824 = {2'h0, column_16_s15_q} - (age_s15_q[1] ? sums_4_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1390;
  assign select_1390 = equal_383_s15_q ? {2'h0, column_13_s15_q} : sums_0_columns_values_0_q;
  logic [7:0] select_1392;
  assign select_1392 = equal_383_s15_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1394;
  assign select_1394 = equal_383_s15_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1396;
  assign select_1396 = equal_383_s15_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1398;
  assign select_1398 = equal_383_s15_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1400;
  assign select_1400 = equal_383_s15_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1402;
  assign select_1402 = equal_383_s15_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1421;
  assign select_1421 = or_381_s15_q ? sums_1_sum_sums_values_0_q : (equal_383_s15_q ? sum_654 : sums_1_sum_sums_values_0_q);
  logic [7:0] select_1437;
  assign select_1437 = or_381_s15_q ? sums_2_sum_sums_values_0_q : (equal_383_s15_q ? sum_601 : sums_2_sum_sums_values_0_q);
  logic [7:0] select_1453;
  assign select_1453 = or_381_s15_q ? sums_3_sum_sums_values_0_q : (equal_383_s15_q ? sum_709 : sums_3_sum_sums_values_0_q);
  logic [7:0] select_1454;
  assign select_1454 = equal_383_s15_q ? {2'h0, column_16_s15_q} : sums_4_columns_values_0_q;
  logic [7:0] select_1456;
  assign select_1456 = equal_383_s15_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1458;
  assign select_1458 = equal_383_s15_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1460;
  assign select_1460 = equal_383_s15_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1462;
  assign select_1462 = equal_383_s15_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1464;
  assign select_1464 = equal_383_s15_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1466;
  assign select_1466 = equal_383_s15_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1588;
  assign sum_1588 = sum_1584_s15_q + {sum_1587_s15_q, select_1585_s15_q};
  logic [9:0] sum_1589;
  assign sum_1589 = {difference_1581_s15_q, select_1579_s15_q} + sum_1588[11:2];

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
    if (s15_en) begin
      sums_0_columns_values_0_q <= or_381_s15_q ? sums_0_columns_values_0_q : select_1390;
      sums_0_columns_values_1_q <= or_381_s15_q ? sums_0_columns_values_1_q : select_1392;
      sums_0_columns_values_2_q <= or_381_s15_q ? sums_0_columns_values_2_q : select_1394;
      sums_0_columns_values_3_q <= or_381_s15_q ? sums_0_columns_values_3_q : select_1396;
      sums_0_columns_values_4_q <= or_381_s15_q ? sums_0_columns_values_4_q : select_1398;
      sums_0_columns_values_5_q <= or_381_s15_q ? sums_0_columns_values_5_q : select_1400;
      sums_0_columns_values_6_q <= or_381_s15_q ? sums_0_columns_values_6_q : select_1402;
      sums_1_sum_sums_values_0_q <= select_1421;
      sums_2_sum_sums_values_0_q <= select_1437;
      sums_3_sum_sums_values_0_q <= select_1453;
      sums_4_columns_values_0_q <= or_381_s15_q ? sums_4_columns_values_0_q : select_1454;
      sums_4_columns_values_1_q <= or_381_s15_q ? sums_4_columns_values_1_q : select_1456;
      sums_4_columns_values_2_q <= or_381_s15_q ? sums_4_columns_values_2_q : select_1458;
      sums_4_columns_values_3_q <= or_381_s15_q ? sums_4_columns_values_3_q : select_1460;
      sums_4_columns_values_4_q <= or_381_s15_q ? sums_4_columns_values_4_q : select_1462;
      sums_4_columns_values_5_q <= or_381_s15_q ? sums_4_columns_values_5_q : select_1464;
      sums_4_columns_values_6_q <= or_381_s15_q ? sums_4_columns_values_6_q : select_1466;
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
  logic [11:0] registration_slope_s16_q;
  logic equal_319_s16_q;
  logic [8:0] select_325_s16_q;
  logic and_334_s16_q;
  logic equal_340_s16_q;
  logic whole_s16_q;
  logic [6:0] column_s16_q;
  logic and_358_s16_q;
  logic and_360_s16_q;
  logic equal_363_s16_q;
  logic drew_s16_q;
  logic or_381_s16_q;
  logic equal_383_s16_q;
  logic less_386_s16_q;
  logic equal_419_s16_q;
  logic [6:0] x_s16_2_q;
  logic [21:0] best_left_rdata_s16_q;
  logic equal_532_s16_q;
  logic equal_599_s16_q;
  logic [7:0] sum_601_s16_q;
  logic [7:0] sum_654_s16_q;
  logic less_655_s16_q;
  logic [7:0] sum_709_s16_q;
  logic [7:0] difference_764_s16_q;
  logic [7:0] difference_824_s16_q;
  logic equal_836_s16_q;
  logic and_894_s16_q;
  logic [6:0] sum_895_s16_q;
  logic [6:0] partner_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic equal_900_s16_q;
  logic equal_910_s16_q;
  logic [11:0] select_939_s16_q;
  logic not_946_s16_q;
  logic select_949_s16_q;
  logic equal_966_s16_q;
  logic and_1099_s16_q;
  logic equal_1240_s16_q;
  logic equal_1292_s16_q;
  logic less_1569_s16_q;
  logic less_1571_s16_q;
  logic [7:0] sum_1589_s16_q;
  logic less_1844_s16_q;
  logic equal_1987_s16_q;
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
      age_s16_q <= age_s15_q[0];
      lower_half_s16_q <= lower_half_s15_q;
      registration_slope_s16_q <= registration_slope_s15_q;
      equal_319_s16_q <= equal_319_s15_q;
      select_325_s16_q <= select_325_s15_q;
      and_334_s16_q <= and_334_s15_q;
      equal_340_s16_q <= equal_340_s15_q;
      whole_s16_q <= whole_s15_q;
      column_s16_q <= column_s15_q;
      and_358_s16_q <= and_358_s15_q;
      and_360_s16_q <= and_360_s15_q;
      equal_363_s16_q <= equal_363_s15_q;
      drew_s16_q <= drew_s15_q;
      or_381_s16_q <= or_381_s15_q;
      equal_383_s16_q <= equal_383_s15_q;
      less_386_s16_q <= less_386_s15_q;
      equal_419_s16_q <= equal_419_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      equal_532_s16_q <= equal_532_s15_q;
      equal_599_s16_q <= equal_599_s15_q;
      sum_601_s16_q <= sum_601;
      sum_654_s16_q <= sum_654;
      less_655_s16_q <= sum_601 < sum_654;
      sum_709_s16_q <= sum_709;
      difference_764_s16_q <= difference_764;
      difference_824_s16_q <= difference_824;
      equal_836_s16_q <= equal_836_s15_q;
      and_894_s16_q <= and_894_s15_q;
      sum_895_s16_q <= sum_895_s15_q;
      partner_s16_q <= partner_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q;
      equal_900_s16_q <= equal_900_s15_q;
      equal_910_s16_q <= equal_910_s15_q;
      select_939_s16_q <= select_939_s15_q;
      not_946_s16_q <= not_946_s15_q;
      select_949_s16_q <= select_949_s15_q;
      equal_966_s16_q <= equal_966_s15_q;
      and_1099_s16_q <= and_1099_s15_q;
      equal_1240_s16_q <= equal_1240_s15_q;
      equal_1292_s16_q <= equal_1292_s15_q;
      less_1569_s16_q <= less_1569_s15_q;
      less_1571_s16_q <= less_1571_s15_q;
      sum_1589_s16_q <= sum_1589[9:2];
      less_1844_s16_q <= less_1844_s15_q;
      equal_1987_s16_q <= equal_1987_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_4_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:463
  logic not_711;
  assign not_711 = ~less_655_s16_q;
  logic [1:0] best;
  assign best = ((less_655_s16_q ? sum_654_s16_q : sum_601_s16_q) < sum_709_s16_q) ? 2'h3 : {not_711, less_655_s16_q};
  // hls/stages/agreement.hpp:450
  logic [7:0] sum_766;
  assign sum_766 = difference_764_s16_q + (equal_599_s16_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  logic [7:0] sum_826;
  assign sum_826 = difference_824_s16_q + (equal_599_s16_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1405;
  assign select_1405 = or_381_s16_q ? sums_0_sum_sums_values_0_q : (equal_383_s16_q ? sum_766 : sums_0_sum_sums_values_0_q);
  logic [7:0] select_1469;
  assign select_1469 = or_381_s16_q ? sums_4_sum_sums_values_0_q : (equal_383_s16_q ? sum_826 : sums_4_sum_sums_values_0_q);
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1590;
  assign sum_1590 = {registration_slope_s16_q[11], registration_slope_s16_q} + {{5{sum_1589_s16_q[7]}}, sum_1589_s16_q};

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_4_sum_sums_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s16_en) begin
      sums_0_sum_sums_values_0_q <= select_1405;
      sums_4_sum_sums_values_0_q <= select_1469;
    end
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
  logic equal_319_s17_q;
  logic [8:0] select_325_s17_q;
  logic and_334_s17_q;
  logic equal_340_s17_q;
  logic whole_s17_q;
  logic [6:0] column_s17_q;
  logic and_358_s17_q;
  logic and_360_s17_q;
  logic equal_363_s17_q;
  logic drew_s17_q;
  logic or_381_s17_q;
  logic less_386_s17_q;
  logic equal_419_s17_q;
  logic [6:0] x_s17_2_q;
  logic [21:0] best_left_rdata_s17_q;
  logic equal_532_s17_q;
  logic [7:0] sum_601_s17_q;
  logic [7:0] sum_654_s17_q;
  logic [7:0] sum_709_s17_q;
  logic [1:0] best_s17_q;
  logic [7:0] select_713_s17_q;
  logic [7:0] sum_766_s17_q;
  logic [7:0] select_767_s17_q;
  logic [7:0] sum_826_s17_q;
  logic equal_836_s17_q;
  logic and_894_s17_q;
  logic [6:0] sum_895_s17_q;
  logic [6:0] partner_s17_q;
  logic [14:0] best_right_rdata_s17_q;
  logic equal_900_s17_q;
  logic equal_910_s17_q;
  logic [11:0] select_939_s17_q;
  logic not_946_s17_q;
  logic select_949_s17_q;
  logic equal_966_s17_q;
  logic and_1099_s17_q;
  logic equal_1240_s17_q;
  logic equal_1292_s17_q;
  logic less_1569_s17_q;
  logic less_1571_s17_q;
  logic [7:0] sum_1590_s17_q;
  logic less_1591_s17_q;
  logic less_1592_s17_q;
  logic less_1844_s17_q;
  logic equal_1987_s17_q;
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
      equal_319_s17_q <= equal_319_s16_q;
      select_325_s17_q <= select_325_s16_q;
      and_334_s17_q <= and_334_s16_q;
      equal_340_s17_q <= equal_340_s16_q;
      whole_s17_q <= whole_s16_q;
      column_s17_q <= column_s16_q;
      and_358_s17_q <= and_358_s16_q;
      and_360_s17_q <= and_360_s16_q;
      equal_363_s17_q <= equal_363_s16_q;
      drew_s17_q <= drew_s16_q;
      or_381_s17_q <= or_381_s16_q;
      less_386_s17_q <= less_386_s16_q;
      equal_419_s17_q <= equal_419_s16_q;
      x_s17_2_q <= x_s16_2_q;
      best_left_rdata_s17_q <= best_left_rdata_s16_q;
      equal_532_s17_q <= equal_532_s16_q;
      sum_601_s17_q <= sum_601_s16_q;
      sum_654_s17_q <= sum_654_s16_q;
      sum_709_s17_q <= sum_709_s16_q;
      best_s17_q <= best;
      select_713_s17_q <= best[0] ? sum_709_s16_q : sum_601_s16_q;
      sum_766_s17_q <= sum_766;
      select_767_s17_q <= best[0] ? sum_654_s16_q : sum_766;
      sum_826_s17_q <= sum_826;
      equal_836_s17_q <= equal_836_s16_q;
      and_894_s17_q <= and_894_s16_q;
      sum_895_s17_q <= sum_895_s16_q;
      partner_s17_q <= partner_s16_q;
      best_right_rdata_s17_q <= best_right_rdata_s16_q;
      equal_900_s17_q <= equal_900_s16_q;
      equal_910_s17_q <= equal_910_s16_q;
      select_939_s17_q <= select_939_s16_q;
      not_946_s17_q <= not_946_s16_q;
      select_949_s17_q <= select_949_s16_q;
      equal_966_s17_q <= equal_966_s16_q;
      and_1099_s17_q <= and_1099_s16_q;
      equal_1240_s17_q <= equal_1240_s16_q;
      equal_1292_s17_q <= equal_1292_s16_q;
      less_1569_s17_q <= less_1569_s16_q;
      less_1571_s17_q <= less_1571_s16_q;
      sum_1590_s17_q <= sum_1590[7:0];
      less_1591_s17_q <= $signed(6'h0) < $signed(sum_1590[12:7]);
      less_1592_s17_q <= $signed(sum_1590[12:7]) < $signed(6'h3f);
      less_1844_s17_q <= less_1844_s16_q;
      equal_1987_s17_q <= equal_1987_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:463
  logic less_769;
  assign less_769 = (best_s17_q[1] ? select_713_s17_q : select_767_s17_q) < sum_766_s17_q;
  logic [1:0] best_2;
  assign best_2 = less_769 ? 2'h0 : best_s17_q;
  // hls/stages/registration.hpp:151
  logic [7:0] slope;
  assign slope = less_1591_s17_q ? 8'h7f : (less_1592_s17_q ? 8'h80 : sum_1590_s17_q);
  logic [6:0] select_1595;
  assign select_1595 = select_939_s17_q[6] ? slope[7:1] : 7'h0;
  logic [7:0] select_1596;
  assign select_1596 = select_939_s17_q[7] ? slope : 8'h0;
  logic [8:0] sum_1597;
  assign sum_1597 = {{2{select_1595[6]}}, select_1595} + {select_1596[7], select_1596};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1598;
  assign select_1598 = select_939_s17_q[8] ? slope : 8'h0;
  logic [7:0] select_1599;
  assign select_1599 = select_939_s17_q[9] ? slope : 8'h0;
  logic [8:0] sum_1600;
  assign sum_1600 = {{2{select_1598[7]}}, select_1598[7:1]} + {select_1599[7], select_1599};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1602;
  assign select_1602 = select_939_s17_q[10] ? slope : 8'h0;
  logic [7:0] select_1603;
  assign select_1603 = select_939_s17_q[11] ? slope : 8'h0;
  logic [8:0] difference_1604;
  assign difference_1604 = {{2{select_1602[7]}}, select_1602[7:1]} - {select_1603[7], select_1603};

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
  logic equal_319_s18_q;
  logic [8:0] select_325_s18_q;
  logic and_334_s18_q;
  logic equal_340_s18_q;
  logic whole_s18_q;
  logic [6:0] column_s18_q;
  logic and_358_s18_q;
  logic and_360_s18_q;
  logic equal_363_s18_q;
  logic drew_s18_q;
  logic or_381_s18_q;
  logic less_386_s18_q;
  logic equal_419_s18_q;
  logic [6:0] x_s18_2_q;
  logic [21:0] best_left_rdata_s18_q;
  logic equal_532_s18_q;
  logic [7:0] sum_601_s18_q;
  logic [7:0] sum_654_s18_q;
  logic [7:0] sum_709_s18_q;
  logic [7:0] sum_766_s18_q;
  logic [1:0] best_2_s18_q;
  logic [7:0] select_771_s18_q;
  logic [7:0] select_772_s18_q;
  logic [7:0] sum_826_s18_q;
  logic equal_836_s18_q;
  logic and_894_s18_q;
  logic [6:0] sum_895_s18_q;
  logic [6:0] partner_s18_q;
  logic [14:0] best_right_rdata_s18_q;
  logic equal_900_s18_q;
  logic equal_910_s18_q;
  logic [5:0] select_939_s18_q;
  logic not_946_s18_q;
  logic select_949_s18_q;
  logic equal_966_s18_q;
  logic and_1099_s18_q;
  logic equal_1240_s18_q;
  logic equal_1292_s18_q;
  logic less_1569_s18_q;
  logic less_1571_s18_q;
  logic [7:0] sum_1597_s18_q;
  logic select_1598_s18_q;
  logic [8:0] sum_1600_s18_q;
  logic select_1602_s18_q;
  logic [8:0] difference_1604_s18_q;
  logic less_1844_s18_q;
  logic equal_1987_s18_q;
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
      equal_319_s18_q <= equal_319_s17_q;
      select_325_s18_q <= select_325_s17_q;
      and_334_s18_q <= and_334_s17_q;
      equal_340_s18_q <= equal_340_s17_q;
      whole_s18_q <= whole_s17_q;
      column_s18_q <= column_s17_q;
      and_358_s18_q <= and_358_s17_q;
      and_360_s18_q <= and_360_s17_q;
      equal_363_s18_q <= equal_363_s17_q;
      drew_s18_q <= drew_s17_q;
      or_381_s18_q <= or_381_s17_q;
      less_386_s18_q <= less_386_s17_q;
      equal_419_s18_q <= equal_419_s17_q;
      x_s18_2_q <= x_s17_2_q;
      best_left_rdata_s18_q <= best_left_rdata_s17_q;
      equal_532_s18_q <= equal_532_s17_q;
      sum_601_s18_q <= sum_601_s17_q;
      sum_654_s18_q <= sum_654_s17_q;
      sum_709_s18_q <= sum_709_s17_q;
      sum_766_s18_q <= sum_766_s17_q;
      best_2_s18_q <= best_2;
      select_771_s18_q <= best_2[0] ? sum_709_s17_q : sum_601_s17_q;
      select_772_s18_q <= best_2[0] ? sum_654_s17_q : sum_766_s17_q;
      sum_826_s18_q <= sum_826_s17_q;
      equal_836_s18_q <= equal_836_s17_q;
      and_894_s18_q <= and_894_s17_q;
      sum_895_s18_q <= sum_895_s17_q;
      partner_s18_q <= partner_s17_q;
      best_right_rdata_s18_q <= best_right_rdata_s17_q;
      equal_900_s18_q <= equal_900_s17_q;
      equal_910_s18_q <= equal_910_s17_q;
      select_939_s18_q <= select_939_s17_q[5:0];
      not_946_s18_q <= not_946_s17_q;
      select_949_s18_q <= select_949_s17_q;
      equal_966_s18_q <= equal_966_s17_q;
      and_1099_s18_q <= and_1099_s17_q;
      equal_1240_s18_q <= equal_1240_s17_q;
      equal_1292_s18_q <= equal_1292_s17_q;
      less_1569_s18_q <= less_1569_s17_q;
      less_1571_s18_q <= less_1571_s17_q;
      sum_1597_s18_q <= sum_1597[8:1];
      select_1598_s18_q <= select_1598[0];
      sum_1600_s18_q <= sum_1600;
      select_1602_s18_q <= select_1602[0];
      difference_1604_s18_q <= difference_1604;
      less_1844_s18_q <= less_1844_s17_q;
      equal_1987_s18_q <= equal_1987_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:98
  logic and_335;
  assign and_335 = sample_pair_whole_s18_q & and_334_s18_q;
  // hls/stages/agreement.hpp:455
  logic less_533;
  assign less_533 = $signed(run_shift_s18_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_535;
  assign less_535 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s18_q);
  // hls/stages/agreement.hpp:463
  logic less_827;
  assign less_827 = (best_2_s18_q[1] ? select_771_s18_q : select_772_s18_q) < sum_826_s18_q;
  logic [1:0] select_828;
  assign select_828 = less_827 ? 2'h0 : best_2_s18_q;
  // hls/stages/agreement.hpp:591
  logic not_911;
  assign not_911 = ~equal_910_s18_q;
  // hls/stages/agreement.hpp:339
  logic and_941;
  assign and_941 = not_911 & (drew_s18_q & select_939_s18_q[0]);
  // hls/stages/agreement.hpp:181
  logic [14:0] select_943;
  assign select_943 = less_386_s18_q ? 15'h0 : {sum_895_s18_q, best_left_rdata_s18_q[21:14]};
  logic [14:0] select_944;
  assign select_944 = or_381_s18_q ? select_943 : 15'h0;
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1601;
  assign sum_1601 = {{3{sum_1597_s18_q[7]}}, sum_1597_s18_q} + {sum_1600_s18_q[8], sum_1600_s18_q, select_1598_s18_q};
  logic [9:0] sum_1605;
  assign sum_1605 = {difference_1604_s18_q, select_1602_s18_q} + {sum_1601[10], sum_1601[10:2]};

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:146; read in stage 18, written in stage 21: 18 < 21 < 18 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_325_s18_q;
  logic averager_memory_re;
  assign averager_memory_re = s18_en & and_335;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory shown_right, 120 x 2, DISTANCE 32, hls/stages/agreement.hpp:876; read in stage 18, written in stage 19: 18 < 19 < 18 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s18_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s18_en & and_941;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  logic [7:0] pixel_0_s19_q;
  logic [7:0] pixel_1_s19_q;
  logic saturated_s19_q;
  logic mask_s19_q;
  logic marks_first_s19_q;
  logic marks_last_s19_q;
  logic sample_pair_whole_s19_q;
  logic [5:0] run_shift_s19_q;
  logic [7:0] x_s19_q;
  logic age_s19_q;
  logic lower_half_s19_q;
  logic equal_319_s19_q;
  logic [8:0] select_325_s19_q;
  logic and_334_s19_q;
  logic and_335_s19_q;
  logic equal_340_s19_q;
  logic whole_s19_q;
  logic [6:0] column_s19_q;
  logic and_358_s19_q;
  logic and_360_s19_q;
  logic equal_363_s19_q;
  logic drew_s19_q;
  logic equal_419_s19_q;
  logic [6:0] x_s19_2_q;
  logic [21:0] best_left_rdata_s19_q;
  logic equal_532_s19_q;
  logic and_537_s19_q;
  logic [7:0] sum_601_s19_q;
  logic [7:0] sum_654_s19_q;
  logic [7:0] sum_709_s19_q;
  logic [7:0] sum_766_s19_q;
  logic [7:0] sum_826_s19_q;
  logic less_827_s19_q;
  logic [1:0] select_828_s19_q;
  logic [7:0] select_829_s19_q;
  logic [7:0] select_830_s19_q;
  logic equal_836_s19_q;
  logic equal_847_s19_q;
  logic and_894_s19_q;
  logic [6:0] partner_s19_q;
  logic [14:0] best_right_rdata_s19_q;
  logic equal_900_s19_q;
  logic equal_910_s19_q;
  logic not_911_s19_q;
  logic [5:0] select_939_s19_q;
  logic and_941_s19_q;
  logic [7:0] select_944_s19_q;
  logic [6:0] select_945_s19_q;
  logic not_946_s19_q;
  logic and_950_s19_q;
  logic equal_966_s19_q;
  logic and_1100_s19_q;
  logic equal_1240_s19_q;
  logic equal_1292_s19_q;
  logic less_1569_s19_q;
  logic less_1571_s19_q;
  logic sum_1601_s19_q;
  logic [9:0] sum_1605_s19_q;
  logic less_1844_s19_q;
  logic equal_1987_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      pixel_0_s19_q <= pixel_0_s18_q;
      pixel_1_s19_q <= pixel_1_s18_q;
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= mask_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
      sample_pair_whole_s19_q <= sample_pair_whole_s18_q;
      run_shift_s19_q <= run_shift_s18_q;
      x_s19_q <= x_s18_q;
      age_s19_q <= age_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      equal_319_s19_q <= equal_319_s18_q;
      select_325_s19_q <= select_325_s18_q;
      and_334_s19_q <= and_334_s18_q;
      and_335_s19_q <= and_335;
      equal_340_s19_q <= equal_340_s18_q;
      whole_s19_q <= whole_s18_q;
      column_s19_q <= column_s18_q;
      and_358_s19_q <= and_358_s18_q;
      and_360_s19_q <= and_360_s18_q;
      equal_363_s19_q <= equal_363_s18_q;
      drew_s19_q <= drew_s18_q;
      equal_419_s19_q <= equal_419_s18_q;
      x_s19_2_q <= x_s18_2_q;
      best_left_rdata_s19_q <= best_left_rdata_s18_q;
      equal_532_s19_q <= equal_532_s18_q;
      and_537_s19_q <= (~less_533) & (~less_535);
      sum_601_s19_q <= sum_601_s18_q;
      sum_654_s19_q <= sum_654_s18_q;
      sum_709_s19_q <= sum_709_s18_q;
      sum_766_s19_q <= sum_766_s18_q;
      sum_826_s19_q <= sum_826_s18_q;
      less_827_s19_q <= less_827;
      select_828_s19_q <= select_828;
      select_829_s19_q <= select_828[0] ? sum_709_s18_q : sum_601_s18_q;
      select_830_s19_q <= select_828[0] ? sum_654_s18_q : sum_766_s18_q;
      equal_836_s19_q <= equal_836_s18_q;
      equal_847_s19_q <= {less_827, select_828} == 3'h0;
      and_894_s19_q <= and_894_s18_q;
      partner_s19_q <= partner_s18_q;
      best_right_rdata_s19_q <= best_right_rdata_s18_q;
      equal_900_s19_q <= equal_900_s18_q;
      equal_910_s19_q <= equal_910_s18_q;
      not_911_s19_q <= not_911;
      select_939_s19_q <= select_939_s18_q;
      and_941_s19_q <= and_941;
      select_944_s19_q <= select_944[7:0];
      select_945_s19_q <= drew_s18_q ? x_s18_q[6:0] : select_944[14:8];
      not_946_s19_q <= not_946_s18_q;
      and_950_s19_q <= not_911 & select_949_s18_q;
      equal_966_s19_q <= equal_966_s18_q;
      and_1100_s19_q <= not_911 & and_1099_s18_q;
      equal_1240_s19_q <= equal_1240_s18_q;
      equal_1292_s19_q <= equal_1292_s18_q;
      less_1569_s19_q <= less_1569_s18_q;
      less_1571_s19_q <= less_1571_s18_q;
      sum_1601_s19_q <= sum_1601[1];
      sum_1605_s19_q <= sum_1605;
      less_1844_s19_q <= less_1844_s18_q;
      equal_1987_s19_q <= equal_1987_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  // hls/stages/census.hpp:91
  logic [13:0] select_338;
  assign select_338 = equal_319_s19_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_344;
  assign sum_344 = {6'h0, sample_pair_pixel_1_q} + (equal_319_s19_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:202
  logic all_of_skin;
  assign all_of_skin = equal_319_s19_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/agreement.hpp:465
  logic [7:0] of_best;
  assign of_best = less_827_s19_q ? sum_826_s19_q : (select_828_s19_q[1] ? select_829_s19_q : select_830_s19_q);
  logic [7:0] of_best_2;
  assign of_best_2 = and_537_s19_q ? of_best : 8'h0;
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_827_s19_q, select_828_s19_q} == 3'h4) ? 3'h3 : (equal_847_s19_q ? 3'h1 : {less_827_s19_q, select_828_s19_q});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_851;
  assign sum_851 = near_best + 3'h1;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_856;
  assign sum_856 = near_best + 3'h7;
  // hls/stages/registration.hpp:26
  logic [7:0] select_865;
  assign select_865 = near_best[1] ? (near_best[0] ? sum_709_s19_q : sum_601_s19_q) : (near_best[0] ? sum_654_s19_q : sum_766_s19_q);
  // hls/stages/agreement.hpp:339
  logic and_947;
  assign and_947 = not_946_s19_q & select_939_s19_q[5];
  // hls/stages/agreement.hpp:204
  logic select_1153;
  assign select_1153 = sample_pair_whole_s19_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1606;
  assign difference_1606 = {{4{select_944_s19_q[7]}}, select_944_s19_q} - {sum_1605_s19_q[9], sum_1605_s19_q, sum_1601_s19_q};
  // hls/stages/registration.hpp:158
  logic [11:0] select_1608;
  assign select_1608 = ($signed(difference_1606[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1606;

  // Memory seen_columns, 120 x 18, DISTANCE 32, hls/stages/agreement.hpp:907; read in stage 19, written in stage 21: 19 < 21 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s19_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s19_en & and_941_s19_q;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_945_s19_q;
  logic shown_right_we;
  assign shown_right_we = s19_en & and_950_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_947, not_946_s19_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 7'd120) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 7'd120) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      sample_of_skin_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
    end else if (s19_en) begin
      sample_pair_pixel_0_q <= pixel_0_s19_q;
      sample_pair_pixel_1_q <= pixel_1_s19_q;
      sample_of_skin_q <= mask_s19_q;
      averager_running_of_skin_q <= select_1153;
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
    if (s19_en) begin
      averager_running_0_q <= sample_pair_whole_s19_q ? select_338 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s19_q ? sum_344 : averager_running_1_q;
    end
  end

  logic saturated_s20_q;
  logic marks_first_s20_q;
  logic marks_last_s20_q;
  logic sample_pair_whole_s20_q;
  logic [5:0] run_shift_s20_q;
  logic [7:0] x_s20_q;
  logic age_s20_q;
  logic lower_half_s20_q;
  logic [8:0] select_325_s20_q;
  logic and_334_s20_q;
  logic and_335_s20_q;
  logic [29:0] averager_memory_rdata_s20_q;
  logic [13:0] select_338_s20_q;
  logic equal_340_s20_q;
  logic [13:0] sum_344_s20_q;
  logic whole_s20_q;
  logic all_of_skin_s20_q;
  logic [6:0] column_s20_q;
  logic and_358_s20_q;
  logic and_360_s20_q;
  logic equal_363_s20_q;
  logic drew_s20_q;
  logic equal_419_s20_q;
  logic [6:0] x_s20_2_q;
  logic [21:0] best_left_rdata_s20_q;
  logic equal_532_s20_q;
  logic [7:0] sum_826_s20_q;
  logic select_828_s20_q;
  logic [7:0] of_best_2_s20_q;
  logic less_835_s20_q;
  logic equal_836_s20_q;
  logic equal_850_s20_q;
  logic [1:0] sum_851_s20_q;
  logic [7:0] select_852_s20_q;
  logic [7:0] select_853_s20_q;
  logic [1:0] sum_856_s20_q;
  logic [7:0] select_857_s20_q;
  logic [7:0] select_858_s20_q;
  logic [1:0] sum_862_s20_q;
  logic [7:0] select_866_s20_q;
  logic and_894_s20_q;
  logic [6:0] partner_s20_q;
  logic [14:0] best_right_rdata_s20_q;
  logic less_899_s20_q;
  logic equal_900_s20_q;
  logic equal_910_s20_q;
  logic not_911_s20_q;
  logic [5:0] select_939_s20_q;
  logic and_941_s20_q;
  logic [1:0] shown_right_rdata_s20_q;
  logic not_946_s20_q;
  logic equal_966_s20_q;
  logic and_1100_s20_q;
  logic equal_1240_s20_q;
  logic equal_1292_s20_q;
  logic less_1569_s20_q;
  logic less_1571_s20_q;
  logic [11:0] select_1608_s20_q;
  logic less_1844_s20_q;
  logic equal_1987_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      saturated_s20_q <= saturated_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      sample_pair_whole_s20_q <= sample_pair_whole_s19_q;
      run_shift_s20_q <= run_shift_s19_q;
      x_s20_q <= x_s19_q;
      age_s20_q <= age_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      select_325_s20_q <= select_325_s19_q;
      and_334_s20_q <= and_334_s19_q;
      and_335_s20_q <= and_335_s19_q;
      averager_memory_rdata_s20_q <= averager_memory_rdata_q;
      select_338_s20_q <= select_338;
      equal_340_s20_q <= equal_340_s19_q;
      sum_344_s20_q <= sum_344;
      whole_s20_q <= whole_s19_q;
      all_of_skin_s20_q <= all_of_skin;
      column_s20_q <= column_s19_q;
      and_358_s20_q <= and_358_s19_q;
      and_360_s20_q <= and_360_s19_q;
      equal_363_s20_q <= equal_363_s19_q;
      drew_s20_q <= drew_s19_q;
      equal_419_s20_q <= equal_419_s19_q;
      x_s20_2_q <= x_s19_2_q;
      best_left_rdata_s20_q <= best_left_rdata_s19_q;
      equal_532_s20_q <= equal_532_s19_q;
      sum_826_s20_q <= sum_826_s19_q;
      select_828_s20_q <= select_828_s19_q[0];
      of_best_2_s20_q <= of_best_2;
      less_835_s20_q <= best_left_rdata_s19_q[7:0] < of_best_2;
      equal_836_s20_q <= equal_836_s19_q;
      equal_850_s20_q <= {less_827_s19_q, select_828_s19_q} == near_best;
      sum_851_s20_q <= sum_851[2:1];
      select_852_s20_q <= sum_851[0] ? sum_709_s19_q : sum_601_s19_q;
      select_853_s20_q <= sum_851[0] ? sum_654_s19_q : sum_766_s19_q;
      sum_856_s20_q <= sum_856[2:1];
      select_857_s20_q <= sum_856[0] ? sum_709_s19_q : sum_601_s19_q;
      select_858_s20_q <= sum_856[0] ? sum_654_s19_q : sum_766_s19_q;
      sum_862_s20_q <= {less_827_s19_q, select_828_s19_q[1]} + 2'h3;
      select_866_s20_q <= near_best[2] ? sum_826_s19_q : select_865;
      and_894_s20_q <= and_894_s19_q;
      partner_s20_q <= partner_s19_q;
      best_right_rdata_s20_q <= best_right_rdata_s19_q;
      less_899_s20_q <= best_right_rdata_s19_q[7:0] < of_best_2;
      equal_900_s20_q <= equal_900_s19_q;
      equal_910_s20_q <= equal_910_s19_q;
      not_911_s20_q <= not_911_s19_q;
      select_939_s20_q <= select_939_s19_q;
      and_941_s20_q <= and_941_s19_q;
      shown_right_rdata_s20_q <= shown_right_rdata_q;
      not_946_s20_q <= not_946_s19_q;
      equal_966_s20_q <= equal_966_s19_q;
      and_1100_s20_q <= and_1100_s19_q;
      equal_1240_s20_q <= equal_1240_s19_q;
      equal_1292_s20_q <= equal_1292_s19_q;
      less_1569_s20_q <= less_1569_s19_q;
      less_1571_s20_q <= less_1571_s19_q;
      select_1608_s20_q <= select_1608;
      less_1844_s20_q <= less_1844_s19_q;
      equal_1987_s20_q <= equal_1987_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/census.hpp:100
  logic [13:0] sum_342;
  assign sum_342 = select_338_s20_q + (equal_340_s20_q ? 14'h0 : averager_memory_rdata_s20_q[13:0]);
  logic [13:0] sum_346;
  assign sum_346 = sum_344_s20_q + (equal_340_s20_q ? 14'h0 : averager_memory_rdata_s20_q[27:14]);
  // hls/stages/census.hpp:101
  logic and_350;
  assign and_350 = whole_s20_q & (averager_memory_rdata_s20_q[28] | equal_340_s20_q);
  // hls/stages/census.hpp:102
  logic and_354;
  assign and_354 = all_of_skin_s20_q & (averager_memory_rdata_s20_q[29] | equal_340_s20_q);
  // hls/stages/agreement.hpp:467
  logic less_834;
  assign less_834 = $signed(run_shift_s20_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:470
  logic or_837;
  assign or_837 = less_835_s20_q | equal_836_s20_q;
  // hls/stages/agreement.hpp:473
  logic [7:0] select_840;
  assign select_840 = less_834 ? (or_837 ? of_best_2_s20_q : best_left_rdata_s20_q[7:0]) : (less_835_s20_q ? of_best_2_s20_q : best_left_rdata_s20_q[7:0]);
  logic [5:0] select_844;
  assign select_844 = less_834 ? (or_837 ? run_shift_s20_q : best_left_rdata_s20_q[13:8]) : (less_835_s20_q ? run_shift_s20_q : best_left_rdata_s20_q[13:8]);
  // hls/stages/registration.hpp:23
  logic [7:0] below;
  assign below = sum_851_s20_q[1] ? sum_826_s20_q : (sum_851_s20_q[0] ? select_852_s20_q : select_853_s20_q);
  // hls/stages/registration.hpp:22
  logic [7:0] above;
  assign above = sum_856_s20_q[1] ? sum_826_s20_q : (sum_856_s20_q[0] ? select_857_s20_q : select_858_s20_q);
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/agreement.hpp:477
  logic or_901;
  assign or_901 = less_899_s20_q | equal_900_s20_q;
  // hls/stages/agreement.hpp:478
  logic [7:0] select_904;
  assign select_904 = less_834 ? (or_901 ? of_best_2_s20_q : best_right_rdata_s20_q[7:0]) : (less_899_s20_q ? of_best_2_s20_q : best_right_rdata_s20_q[7:0]);
  logic [6:0] select_908;
  assign select_908 = less_834 ? (or_901 ? x_s20_2_q : best_right_rdata_s20_q[14:8]) : (less_899_s20_q ? x_s20_2_q : best_right_rdata_s20_q[14:8]);
  // hls/stages/division.hpp:18
  logic [5:0] sum_964;
  assign sum_964 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:636
  logic or_967;
  assign or_967 = (~sum_964[5]) | equal_966_s20_q;
  // hls/stages/agreement.hpp:186
  logic shown;
  assign shown = select_939_s20_q[0] & (shown_right_rdata_s20_q[0] | select_939_s20_q[4]);
  // hls/stages/agreement.hpp:598
  logic select_993;
  assign select_993 = select_939_s20_q[4] ? select_939_s20_q[5] : shown_right_rdata_s20_q[1];
  // hls/stages/agreement.hpp:186
  logic near;
  assign near = select_939_s20_q[0] & select_993;
  // hls/stages/registration.hpp:158
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1608_s20_q[11:7])) ? 12'h7f : select_1608_s20_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1853;
  assign sum_1853 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1854;
  assign select_1854 = sum_964[5] ? {1'b1, sum_964[4:0], region_across_rest_q[2:0]} : sum_1853;
  // hls/stages/agreement.hpp:286
  logic [8:0] select_1858;
  assign select_1858 = equal_1292_s20_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_1861;
  assign select_1861 = equal_1292_s20_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:254; read in stage 20, written in stage 22: 20 < 22 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s20_q;
  logic census_memory_re;
  assign census_memory_re = s20_en & and_360_s20_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s20_en) begin
      region_across_rest_q <= drew_s20_q ? select_1854 : columns_begin_rest_q;
      region_across_back_q <= drew_s20_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_360_s20_q ? select_1858 : columns_begin_rest_q;
      columns_begin_back_q <= and_360_s20_q ? select_1861 : columns_begin_back_q;
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
  logic [8:0] select_325_s21_q;
  logic and_334_s21_q;
  logic and_335_s21_q;
  logic [13:0] sum_342_s21_q;
  logic [13:0] sum_346_s21_q;
  logic and_350_s21_q;
  logic and_354_s21_q;
  logic [6:0] column_s21_q;
  logic and_358_s21_q;
  logic and_360_s21_q;
  logic equal_363_s21_q;
  logic drew_s21_q;
  logic equal_419_s21_q;
  logic [6:0] x_s21_2_q;
  logic [7:0] best_left_rdata_s21_q;
  logic equal_532_s21_q;
  logic select_828_s21_q;
  logic less_834_s21_q;
  logic less_835_s21_q;
  logic or_837_s21_q;
  logic [7:0] select_841_s21_q;
  logic [5:0] select_845_s21_q;
  logic equal_850_s21_q;
  logic [7:0] below_s21_q;
  logic [7:0] above_s21_q;
  logic rise_s21_q;
  logic [1:0] sum_862_s21_q;
  logic [7:0] select_866_s21_q;
  logic [7:0] xor_870_s21_q;
  logic and_894_s21_q;
  logic [6:0] partner_s21_q;
  logic [7:0] select_905_s21_q;
  logic [6:0] select_909_s21_q;
  logic equal_910_s21_q;
  logic not_911_s21_q;
  logic [5:0] select_939_s21_q;
  logic and_941_s21_q;
  logic not_946_s21_q;
  logic sum_964_s21_q;
  logic and_969_s21_q;
  logic [17:0] seen_columns_rdata_s21_q;
  logic shown_s21_q;
  logic near_s21_q;
  logic and_1100_s21_q;
  logic equal_1240_s21_q;
  logic equal_1292_s21_q;
  logic less_1569_s21_q;
  logic less_1571_s21_q;
  logic [11:0] residual_s21_q;
  logic less_1844_s21_q;
  logic select_1884_s21_q;
  logic equal_1987_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= sample_pair_pixel_0_q;
      pixel_1_s21_q <= sample_pair_pixel_1_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= sample_of_skin_q;
      marks_first_s21_q <= marks_first_s20_q;
      marks_last_s21_q <= marks_last_s20_q;
      sample_pair_whole_s21_q <= sample_pair_whole_s20_q;
      x_s21_q <= x_s20_q;
      age_s21_q <= age_s20_q;
      lower_half_s21_q <= lower_half_s20_q;
      select_325_s21_q <= select_325_s20_q;
      and_334_s21_q <= and_334_s20_q;
      and_335_s21_q <= and_335_s20_q;
      sum_342_s21_q <= sum_342;
      sum_346_s21_q <= sum_346;
      and_350_s21_q <= and_350;
      and_354_s21_q <= and_354;
      column_s21_q <= column_s20_q;
      and_358_s21_q <= and_358_s20_q;
      and_360_s21_q <= and_360_s20_q;
      equal_363_s21_q <= equal_363_s20_q;
      drew_s21_q <= drew_s20_q;
      equal_419_s21_q <= equal_419_s20_q;
      x_s21_2_q <= x_s20_2_q;
      best_left_rdata_s21_q <= best_left_rdata_s20_q[21:14];
      equal_532_s21_q <= equal_532_s20_q;
      select_828_s21_q <= select_828_s20_q;
      less_834_s21_q <= less_834;
      less_835_s21_q <= less_835_s20_q;
      or_837_s21_q <= or_837;
      select_841_s21_q <= equal_532_s20_q ? of_best_2_s20_q : select_840;
      select_845_s21_q <= equal_532_s20_q ? run_shift_s20_q : select_844;
      equal_850_s21_q <= equal_850_s20_q;
      below_s21_q <= below;
      above_s21_q <= above;
      rise_s21_q <= rise[8];
      sum_862_s21_q <= sum_862_s20_q;
      select_866_s21_q <= select_866_s20_q;
      xor_870_s21_q <= rise[7:0] ^ {8{rise[8]}};
      and_894_s21_q <= and_894_s20_q;
      partner_s21_q <= partner_s20_q;
      select_905_s21_q <= equal_532_s20_q ? of_best_2_s20_q : select_904;
      select_909_s21_q <= equal_532_s20_q ? x_s20_2_q : select_908;
      equal_910_s21_q <= equal_910_s20_q;
      not_911_s21_q <= not_911_s20_q;
      select_939_s21_q <= select_939_s20_q;
      and_941_s21_q <= and_941_s20_q;
      not_946_s21_q <= not_946_s20_q;
      sum_964_s21_q <= sum_964[5];
      and_969_s21_q <= drew_s20_q & (select_939_s20_q[0] & or_967);
      seen_columns_rdata_s21_q <= seen_columns_rdata_q;
      shown_s21_q <= shown;
      near_s21_q <= near;
      and_1100_s21_q <= and_1100_s20_q;
      equal_1240_s21_q <= equal_1240_s20_q;
      equal_1292_s21_q <= equal_1292_s20_q;
      less_1569_s21_q <= less_1569_s20_q;
      less_1571_s21_q <= less_1571_s20_q;
      residual_s21_q <= residual;
      less_1844_s21_q <= less_1844_s20_q;
      select_1884_s21_q <= sum_964[5] ? (equal_966_s20_q & or_967) : or_967;
      equal_1987_s21_q <= equal_1987_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic segment_starts_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_334_s21_q ? sum_342_s21_q[13:5] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_363_s21_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey_2;
  assign grey_2 = and_334_s21_q ? sum_346_s21_q[13:5] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_363_s21_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:126
  logic and_371;
  assign and_371 = and_334_s21_q & and_350_s21_q;
  // hls/stages/census.hpp:105
  logic select_373;
  assign select_373 = equal_363_s21_q ? and_371 : (averager_mask_q & and_371);
  // hls/stages/agreement.hpp:204
  logic whole_2;
  assign whole_2 = sample_pair_whole_s21_q & select_373;
  // hls/stages/census.hpp:126
  logic and_375;
  assign and_375 = and_334_s21_q & and_354_s21_q;
  // hls/stages/census.hpp:105
  logic select_377;
  assign select_377 = equal_363_s21_q ? and_375 : (averager_of_skin_q & and_375);
  // hls/stages/registration.hpp:26
  logic [7:0] select_867;
  assign select_867 = rise_s21_q ? below_s21_q : above_s21_q;
  logic [8:0] fall;
  assign fall = {1'b0, select_866_s21_q} - {1'b0, select_867};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [8:0] size;
  assign size = {8'h0, rise_s21_q} + {1'b0, xor_870_s21_q};
  // hls/stages/agreement.hpp:147
  logic [7:0] select_951;
  assign select_951 = drew_s21_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:628
  logic or_954;
  assign or_954 = select_951[7] | (~({select_951[5], select_951[3], select_951[1]} == 3'h0));
  // hls/stages/agreement.hpp:186
  logic textured;
  assign textured = select_939_s21_q[0] & select_939_s21_q[2];
  logic explained;
  assign explained = select_939_s21_q[0] & select_939_s21_q[4];
  logic and_990;
  assign and_990 = select_939_s21_q[0] & select_939_s21_q[3];
  // hls/stages/agreement.hpp:606
  logic and_1029;
  assign and_1029 = seen_columns_rdata_s21_q[5] & select_939_s21_q[0];
  logic and_1030;
  assign and_1030 = seen_columns_rdata_s21_q[0] & select_939_s21_q[0];
  logic [7:0] select_1042;
  assign select_1042 = select_939_s21_q[0] ? (sum_964_s21_q ? select_951 : {select_951[6:0], 1'b0}) : select_951;
  // hls/stages/agreement.hpp:628
  logic or_1045;
  assign or_1045 = select_1042[7] | (~({select_1042[5], select_1042[3], select_1042[1]} == 3'h0));
  // hls/stages/agreement.hpp:606
  logic and_1063;
  assign and_1063 = seen_columns_rdata_s21_q[8] & select_939_s21_q[0];
  logic and_1064;
  assign and_1064 = seen_columns_rdata_s21_q[3] & select_939_s21_q[0];
  logic and_1079;
  assign and_1079 = seen_columns_rdata_s21_q[9] & select_939_s21_q[0];
  logic and_1080;
  assign and_1080 = seen_columns_rdata_s21_q[4] & select_939_s21_q[0];
  // hls/stages/agreement.hpp:204
  logic [10:0] select_1132;
  assign select_1132 = sample_pair_whole_s21_q ? (and_358_s21_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1134;
  assign select_1134 = sample_pair_whole_s21_q ? (and_358_s21_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_1155;
  assign select_1155 = sample_pair_whole_s21_q ? (and_358_s21_q ? select_373 : averager_mask_q) : averager_mask_q;
  logic select_1157;
  assign select_1157 = sample_pair_whole_s21_q ? (and_358_s21_q ? select_377 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:606
  logic and_1493;
  assign and_1493 = seen_columns_rdata_s21_q[7] & select_939_s21_q[0];
  logic and_1494;
  assign and_1494 = seen_columns_rdata_s21_q[2] & select_939_s21_q[0];
  // hls/stages/registration.hpp:146
  logic [12:0] difference_1692;
  assign difference_1692 = 13'h0 - {residual_s21_q[11], residual_s21_q};
  logic less_1776;
  assign less_1776 = $signed(difference_1692) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/division.hpp:34
  logic [7:0] sum_1845;
  assign sum_1845 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:286
  logic [8:0] select_1865;
  assign select_1865 = equal_419_s21_q ? {difference_1863[7], difference_1863} : (less_1844_s21_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1867;
  assign select_1867 = and_360_s21_q ? (equal_1292_s21_q ? select_1865 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:286
  logic [7:0] select_1869;
  assign select_1869 = equal_419_s21_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1871;
  assign select_1871 = and_360_s21_q ? (equal_1292_s21_q ? select_1869 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_1873;
  assign select_1873 = sum_1845[7] ? {1'b1, sum_1845[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});
  // hls/stages/agreement.hpp:147
  logic or_1882;
  assign or_1882 = segment_starts_q | not_946_s21_q;
  // hls/stages/agreement.hpp:339
  logic select_1886;
  assign select_1886 = drew_s21_q ? (select_939_s21_q[0] ? select_1884_s21_q : or_1882) : or_1882;
  logic select_1979;
  assign select_1979 = equal_910_s21_q ? centres_values_0_textured_q : (drew_s21_q ? and_1029 : centres_values_0_textured_q);
  logic select_1981;
  assign select_1981 = drew_s21_q ? (seen_columns_rdata_s21_q[6] & select_939_s21_q[0]) : centres_values_0_of_skin_q;
  logic select_1983;
  assign select_1983 = drew_s21_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_1985;
  assign select_1985 = drew_s21_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_325_s21_q;
  logic averager_memory_we;
  assign averager_memory_we = s21_en & and_335_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_354_s21_q, and_350_s21_q, sum_346_s21_q, sum_342_s21_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s19_sim;
  logic averager_memory_re_s19_sim;
  logic [8:0] averager_memory_raddr_s20_sim;
  logic averager_memory_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s19_sim <= 1'b0;
      averager_memory_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s19_sim <= averager_memory_re;
      averager_memory_raddr_s19_sim <= averager_memory_raddr;
      averager_memory_re_s20_sim <= averager_memory_re_s19_sim;
      averager_memory_raddr_s20_sim <= averager_memory_raddr_s19_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s19_sim && averager_memory_raddr_s19_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s20_sim && averager_memory_raddr_s20_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd480) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd480) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = partner_s21_q;
  logic best_right_we;
  assign best_right_we = s21_en & and_894_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_909_s21_q, select_905_s21_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_right_raddr_s11_sim;
  logic best_right_re_s11_sim;
  logic [6:0] best_right_raddr_s12_sim;
  logic best_right_re_s12_sim;
  logic [6:0] best_right_raddr_s13_sim;
  logic best_right_re_s13_sim;
  logic [6:0] best_right_raddr_s14_sim;
  logic best_right_re_s14_sim;
  logic [6:0] best_right_raddr_s15_sim;
  logic best_right_re_s15_sim;
  logic [6:0] best_right_raddr_s16_sim;
  logic best_right_re_s16_sim;
  logic [6:0] best_right_raddr_s17_sim;
  logic best_right_re_s17_sim;
  logic [6:0] best_right_raddr_s18_sim;
  logic best_right_re_s18_sim;
  logic [6:0] best_right_raddr_s19_sim;
  logic best_right_re_s19_sim;
  logic [6:0] best_right_raddr_s20_sim;
  logic best_right_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s11_sim <= 1'b0;
      best_right_re_s12_sim <= 1'b0;
      best_right_re_s13_sim <= 1'b0;
      best_right_re_s14_sim <= 1'b0;
      best_right_re_s15_sim <= 1'b0;
      best_right_re_s16_sim <= 1'b0;
      best_right_re_s17_sim <= 1'b0;
      best_right_re_s18_sim <= 1'b0;
      best_right_re_s19_sim <= 1'b0;
      best_right_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      best_right_re_s11_sim <= best_right_re;
      best_right_raddr_s11_sim <= best_right_raddr;
      best_right_re_s12_sim <= best_right_re_s11_sim;
      best_right_raddr_s12_sim <= best_right_raddr_s11_sim;
      best_right_re_s13_sim <= best_right_re_s12_sim;
      best_right_raddr_s13_sim <= best_right_raddr_s12_sim;
      best_right_re_s14_sim <= best_right_re_s13_sim;
      best_right_raddr_s14_sim <= best_right_raddr_s13_sim;
      best_right_re_s15_sim <= best_right_re_s14_sim;
      best_right_raddr_s15_sim <= best_right_raddr_s14_sim;
      best_right_re_s16_sim <= best_right_re_s15_sim;
      best_right_raddr_s16_sim <= best_right_raddr_s15_sim;
      best_right_re_s17_sim <= best_right_re_s16_sim;
      best_right_raddr_s17_sim <= best_right_raddr_s16_sim;
      best_right_re_s18_sim <= best_right_re_s17_sim;
      best_right_raddr_s18_sim <= best_right_raddr_s17_sim;
      best_right_re_s19_sim <= best_right_re_s18_sim;
      best_right_raddr_s19_sim <= best_right_raddr_s18_sim;
      best_right_re_s20_sim <= best_right_re_s19_sim;
      best_right_raddr_s20_sim <= best_right_raddr_s19_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s11_sim && best_right_raddr_s11_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s12_sim && best_right_raddr_s12_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s13_sim && best_right_raddr_s13_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s14_sim && best_right_raddr_s14_sim == best_right_waddr) begin
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
      if (best_right_re_s19_sim && best_right_raddr_s19_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s20_sim && best_right_raddr_s20_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 7'd120) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd120) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s21_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s21_en & and_941_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s21_q[13:7], seen_columns_rdata_s21_q[5:0], near_s21_q, shown_s21_q, explained, and_990, textured};
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
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
      segment_starts_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
    end else if (s21_en) begin
      averager_mask_q <= select_1155;
      averager_of_skin_q <= select_1157;
      region_columns_q <= equal_910_s21_q ? select_951 : (drew_s21_q ? select_1042 : 8'h1);
      region_down_rest_q <= select_1867;
      region_down_back_q <= select_1871;
      region_down_next_q <= select_1873;
      segment_starts_q <= equal_910_s21_q ? or_1882 : select_1886;
      centres_values_0_textured_q <= select_1979;
      centres_values_0_of_skin_q <= equal_910_s21_q ? centres_values_0_of_skin_q : select_1981;
      centres_values_1_textured_q <= equal_910_s21_q ? centres_values_1_textured_q : select_1983;
      centres_values_1_of_skin_q <= equal_910_s21_q ? centres_values_1_of_skin_q : select_1985;
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
    if (s21_en) begin
      averager_total_0_q <= select_1132;
      averager_total_1_q <= select_1134;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic sample_pair_whole_s22_q;
  logic [7:0] x_s22_q;
  logic age_s22_q;
  logic lower_half_s22_q;
  logic centres_values_1_textured_s22_q;
  logic centres_values_1_of_skin_s22_q;
  logic [6:0] column_s22_q;
  logic and_358_s22_q;
  logic and_360_s22_q;
  logic [77:0] census_memory_rdata_s22_q;
  logic [8:0] grey_s22_q;
  logic equal_363_s22_q;
  logic [8:0] select_366_s22_q;
  logic [8:0] grey_2_s22_q;
  logic [8:0] select_370_s22_q;
  logic whole_2_s22_q;
  logic and_378_s22_q;
  logic drew_s22_q;
  logic equal_419_s22_q;
  logic [6:0] x_s22_2_q;
  logic [7:0] best_left_rdata_s22_q;
  logic equal_532_s22_q;
  logic select_828_s22_q;
  logic less_834_s22_q;
  logic less_835_s22_q;
  logic or_837_s22_q;
  logic [7:0] select_841_s22_q;
  logic [5:0] select_845_s22_q;
  logic equal_850_s22_q;
  logic rise_s22_q;
  logic [1:0] sum_862_s22_q;
  logic [7:0] twice_s22_q;
  logic [8:0] size_s22_q;
  logic and_894_s22_q;
  logic equal_910_s22_q;
  logic not_911_s22_q;
  logic [5:0] select_939_s22_q;
  logic or_954_s22_q;
  logic or_957_s22_q;
  logic or_960_s22_q;
  logic equal_962_s22_q;
  logic and_969_s22_q;
  logic textured_s22_q;
  logic explained_s22_q;
  logic and_1027_s22_q;
  logic and_1028_s22_q;
  logic [1:0] sum_1032_s22_q;
  logic or_1045_s22_q;
  logic or_1048_s22_q;
  logic or_1051_s22_q;
  logic and_1061_s22_q;
  logic and_1062_s22_q;
  logic [1:0] sum_1066_s22_q;
  logic and_1077_s22_q;
  logic and_1078_s22_q;
  logic [1:0] sum_1082_s22_q;
  logic and_1100_s22_q;
  logic equal_1240_s22_q;
  logic equal_1292_s22_q;
  logic and_1491_s22_q;
  logic and_1492_s22_q;
  logic [1:0] sum_1496_s22_q;
  logic less_1569_s22_q;
  logic less_1571_s22_q;
  logic [7:0] residual_s22_q;
  logic less_1693_s22_q;
  logic less_1776_s22_q;
  logic less_1844_s22_q;
  logic sum_1845_s22_q;
  logic equal_1987_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      sample_pair_whole_s22_q <= sample_pair_whole_s21_q;
      x_s22_q <= x_s21_q;
      age_s22_q <= age_s21_q;
      lower_half_s22_q <= lower_half_s21_q;
      centres_values_1_textured_s22_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s22_q <= centres_values_1_of_skin_q;
      column_s22_q <= column_s21_q;
      and_358_s22_q <= and_358_s21_q;
      and_360_s22_q <= and_360_s21_q;
      census_memory_rdata_s22_q <= census_memory_rdata_q;
      grey_s22_q <= grey;
      equal_363_s22_q <= equal_363_s21_q;
      select_366_s22_q <= sample_pair_whole_s21_q ? total[10:2] : 9'h0;
      grey_2_s22_q <= grey_2;
      select_370_s22_q <= sample_pair_whole_s21_q ? total_2[10:2] : 9'h0;
      whole_2_s22_q <= whole_2;
      and_378_s22_q <= sample_pair_whole_s21_q & select_377;
      drew_s22_q <= drew_s21_q;
      equal_419_s22_q <= equal_419_s21_q;
      x_s22_2_q <= x_s21_2_q;
      best_left_rdata_s22_q <= best_left_rdata_s21_q;
      equal_532_s22_q <= equal_532_s21_q;
      select_828_s22_q <= select_828_s21_q;
      less_834_s22_q <= less_834_s21_q;
      less_835_s22_q <= less_835_s21_q;
      or_837_s22_q <= or_837_s21_q;
      select_841_s22_q <= select_841_s21_q;
      select_845_s22_q <= select_845_s21_q;
      equal_850_s22_q <= equal_850_s21_q;
      rise_s22_q <= rise_s21_q;
      sum_862_s22_q <= sum_862_s21_q;
      twice_s22_q <= twice;
      size_s22_q <= size;
      and_894_s22_q <= and_894_s21_q;
      equal_910_s22_q <= equal_910_s21_q;
      not_911_s22_q <= not_911_s21_q;
      select_939_s22_q <= select_939_s21_q;
      or_954_s22_q <= or_954;
      or_957_s22_q <= select_951[7] | (~({select_951[6], select_951[3:2]} == 3'h0));
      or_960_s22_q <= select_951[7] | (~(select_951[6:4] == 3'h0));
      equal_962_s22_q <= x_s21_q[5:4] == 2'h3;
      and_969_s22_q <= and_969_s21_q;
      textured_s22_q <= textured;
      explained_s22_q <= explained;
      and_1027_s22_q <= seen_columns_rdata_s21_q[14] & select_939_s21_q[0];
      and_1028_s22_q <= seen_columns_rdata_s21_q[10] & select_939_s21_q[0];
      sum_1032_s22_q <= {1'b0, and_1029} + ({1'b0, textured} + {1'b0, and_1030});
      or_1045_s22_q <= or_1045;
      or_1048_s22_q <= select_1042[7] | (~({select_1042[6], select_1042[3:2]} == 3'h0));
      or_1051_s22_q <= select_1042[7] | (~(select_1042[6:4] == 3'h0));
      and_1061_s22_q <= seen_columns_rdata_s21_q[16] & select_939_s21_q[0];
      and_1062_s22_q <= seen_columns_rdata_s21_q[12] & select_939_s21_q[0];
      sum_1066_s22_q <= {1'b0, and_1063} + ({1'b0, shown_s21_q} + {1'b0, and_1064});
      and_1077_s22_q <= seen_columns_rdata_s21_q[17] & select_939_s21_q[0];
      and_1078_s22_q <= seen_columns_rdata_s21_q[13] & select_939_s21_q[0];
      sum_1082_s22_q <= {1'b0, and_1079} + ({1'b0, near_s21_q} + {1'b0, and_1080});
      and_1100_s22_q <= and_1100_s21_q;
      equal_1240_s22_q <= equal_1240_s21_q;
      equal_1292_s22_q <= equal_1292_s21_q;
      and_1491_s22_q <= seen_columns_rdata_s21_q[15] & select_939_s21_q[0];
      and_1492_s22_q <= seen_columns_rdata_s21_q[11] & select_939_s21_q[0];
      sum_1496_s22_q <= {1'b0, and_1493} + ({1'b0, explained} + {1'b0, and_1494});
      less_1569_s22_q <= less_1569_s21_q;
      less_1571_s22_q <= less_1571_s21_q;
      residual_s22_q <= residual_s21_q[7:0];
      less_1693_s22_q <= $signed(difference_1692) < $signed({7'h0, cfg_moved_limit_i});
      less_1776_s22_q <= less_1776;
      less_1844_s22_q <= less_1844_s21_q;
      sum_1845_s22_q <= sum_1845[7];
      equal_1987_s22_q <= equal_1987_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
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
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [2:0] region_row_q;
  logic region_fresh_q;
  logic segment_started_q;
  logic [2:0] next_region_row_q;
  // hls/stages/census.hpp:214
  logic less_392;
  assign less_392 = census_memory_rdata_s22_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_393;
  assign less_393 = census_memory_rdata_s22_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_394;
  assign less_394 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_395;
  assign less_395 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_396;
  assign less_396 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_397;
  assign less_397 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_398;
  assign less_398 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_399;
  assign less_399 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_400;
  assign less_400 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_401;
  assign less_401 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_402;
  assign less_402 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_403;
  assign less_403 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_404;
  assign less_404 = census_memory_rdata_s22_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_405;
  assign less_405 = census_memory_rdata_s22_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_406;
  assign less_406 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_407;
  assign less_407 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_408;
  assign less_408 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_409;
  assign less_409 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_410;
  assign less_410 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_411;
  assign less_411 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_412;
  assign less_412 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_413;
  assign less_413 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_414;
  assign less_414 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_415;
  assign less_415 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:206
  logic and_425;
  assign and_425 = census_memory_rdata_s22_q[38] & (census_memory_rdata_s22_q[18] & whole_2_s22_q);
  logic and_427;
  assign and_427 = census_memory_rdata_s22_q[77] & (census_memory_rdata_s22_q[58] & and_425);
  // hls/stages/census.hpp:190
  logic [9:0] difference_450;
  assign difference_450 = {1'b0, select_366_s22_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_453;
  assign difference_453 = {1'b0, census_memory_rdata_s22_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_457;
  assign difference_457 = {1'b0, census_memory_rdata_s22_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_461;
  assign difference_461 = {1'b0, census_memory_rdata_s22_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_465;
  assign difference_465 = {1'b0, census_memory_rdata_s22_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/registration.hpp:28
  logic [8:0] select_873;
  assign select_873 = ({twice_s22_q, 1'b0} < size_s22_q) ? {twice_s22_q, 1'b0} : size_s22_q;
  // hls/stages/agreement.hpp:339
  logic [5:0] select_961;
  assign select_961 = equal_910_s22_q ? x_s22_q[5:0] : {region_row_q, or_960_s22_q, or_957_s22_q, or_954_s22_q};
  // hls/stages/agreement.hpp:709
  logic not_963;
  assign not_963 = ~equal_962_s22_q;
  // hls/stages/agreement.hpp:186
  logic and_983;
  assign and_983 = select_939_s22_q[0] & ({select_939_s22_q[5], select_939_s22_q[3]} == 2'h3);
  // hls/stages/agreement.hpp:665
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1027_s22_q} + ({2'h0, and_1028_s22_q} + {1'b0, sum_1032_s22_q});
  // hls/stages/agreement.hpp:667
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1061_s22_q} + ({2'h0, and_1062_s22_q} + {1'b0, sum_1066_s22_q});
  // hls/stages/agreement.hpp:668
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1077_s22_q} + ({2'h0, and_1078_s22_q} + {1'b0, sum_1082_s22_q});
  // hls/stages/agreement.hpp:204
  logic [8:0] select_1124;
  assign select_1124 = sample_pair_whole_s22_q ? (and_358_s22_q ? grey_s22_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1126;
  assign select_1126 = sample_pair_whole_s22_q ? (and_358_s22_q ? grey_2_s22_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1128;
  assign select_1128 = sample_pair_whole_s22_q ? (and_358_s22_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1130;
  assign select_1130 = sample_pair_whole_s22_q ? (and_358_s22_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1135;
  assign sum_1135 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s22_q};
  logic [9:0] sum_1143;
  assign sum_1143 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s22_q};
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1158;
  assign select_1158 = and_360_s22_q ? select_366_s22_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1159;
  assign select_1159 = and_360_s22_q ? select_370_s22_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1161;
  assign select_1161 = and_360_s22_q ? census_memory_rdata_s22_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1162;
  assign select_1162 = and_360_s22_q ? census_memory_rdata_s22_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1163;
  assign select_1163 = and_360_s22_q ? census_memory_rdata_s22_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1164;
  assign select_1164 = and_360_s22_q ? census_memory_rdata_s22_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1165;
  assign select_1165 = and_360_s22_q ? census_memory_rdata_s22_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1166;
  assign select_1166 = and_360_s22_q ? census_memory_rdata_s22_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1167;
  assign select_1167 = and_360_s22_q ? census_memory_rdata_s22_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1168;
  assign select_1168 = and_360_s22_q ? census_memory_rdata_s22_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1169;
  assign select_1169 = and_360_s22_q ? census_memory_rdata_s22_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1170;
  assign select_1170 = and_360_s22_q ? census_memory_rdata_s22_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1171;
  assign select_1171 = and_360_s22_q ? census_memory_rdata_s22_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1172;
  assign select_1172 = and_360_s22_q ? census_memory_rdata_s22_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1173;
  assign select_1173 = and_360_s22_q ? census_memory_rdata_s22_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1174;
  assign select_1174 = and_360_s22_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1175;
  assign select_1175 = and_360_s22_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1177;
  assign select_1177 = and_360_s22_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1178;
  assign select_1178 = and_360_s22_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1180;
  assign select_1180 = and_360_s22_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1181;
  assign select_1181 = and_360_s22_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1183;
  assign select_1183 = and_360_s22_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1184;
  assign select_1184 = and_360_s22_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1185;
  assign select_1185 = and_360_s22_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1187;
  assign select_1187 = and_360_s22_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1188;
  assign select_1188 = and_360_s22_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1190;
  assign select_1190 = and_360_s22_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1191;
  assign select_1191 = and_360_s22_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1193;
  assign select_1193 = and_360_s22_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1194;
  assign select_1194 = and_360_s22_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1196;
  assign select_1196 = and_360_s22_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1197;
  assign select_1197 = and_360_s22_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1199;
  assign select_1199 = and_360_s22_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1200;
  assign select_1200 = and_360_s22_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1202;
  assign select_1202 = and_360_s22_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1203;
  assign select_1203 = and_360_s22_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1206;
  assign select_1206 = and_360_s22_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1207;
  assign select_1207 = and_360_s22_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1210;
  assign select_1210 = and_360_s22_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1211;
  assign select_1211 = and_360_s22_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1215;
  assign difference_1215 = {1'b0, select_370_s22_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_1218;
  assign difference_1218 = {1'b0, census_memory_rdata_s22_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_1222;
  assign difference_1222 = {1'b0, census_memory_rdata_s22_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_1226;
  assign difference_1226 = {1'b0, census_memory_rdata_s22_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_1230;
  assign difference_1230 = {1'b0, census_memory_rdata_s22_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1260;
  assign difference_1260 = {1'b0, select_366_s22_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_1271;
  assign difference_1271 = {1'b0, select_370_s22_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:339
  logic and_1474;
  assign and_1474 = not_911_s22_q & (drew_s22_q & (select_939_s22_q[0] & select_939_s22_q[1]));
  // hls/stages/agreement.hpp:666
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_1491_s22_q} + ({2'h0, and_1492_s22_q} + {1'b0, sum_1496_s22_q});
  // hls/stages/agreement.hpp:600
  logic [9:0] select_1563;
  assign select_1563 = ({select_939_s22_q[3], select_939_s22_q[1]} == 2'h3) ? ({1'b0, select_939_s22_q[5], 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:339
  logic [9:0] select_1566;
  assign select_1566 = equal_910_s22_q ? 10'h0 : (drew_s22_q ? (select_939_s22_q[0] ? select_1563 : 10'h0) : 10'h0);
  // hls/stages/registration.hpp:73
  logic equal_1572;
  assign equal_1572 = {lower_half_s22_q, less_1571_s22_q} == 2'h3;
  logic equal_1573;
  assign equal_1573 = {lower_half_s22_q, less_1571_s22_q} == 2'h2;
  logic equal_1574;
  assign equal_1574 = {lower_half_s22_q, less_1571_s22_q} == 2'h1;
  logic not_1648;
  assign not_1648 = ~equal_1572;
  logic not_1649;
  assign not_1649 = ~equal_1573;
  // hls/stages/agreement.hpp:186
  logic and_1654;
  assign and_1654 = select_939_s22_q[4] & (less_1569_s22_q & (not_1648 & (not_1649 & (~equal_1574))));
  logic and_1663;
  assign and_1663 = select_939_s22_q[4] & (less_1569_s22_q & (not_1648 & (equal_1574 & not_1649)));
  logic and_1671;
  assign and_1671 = select_939_s22_q[4] & (less_1569_s22_q & (equal_1573 & not_1648));
  logic and_1679;
  assign and_1679 = select_939_s22_q[0] & (select_939_s22_q[4] & (less_1569_s22_q & equal_1572));
  logic and_1694;
  assign and_1694 = less_1569_s22_q & less_1693_s22_q;
  logic [1:0] select_1696;
  assign select_1696 = select_939_s22_q[0] ? (select_939_s22_q[4] ? {and_1694, less_1569_s22_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:80
  logic not_1701;
  assign not_1701 = ~less_1571_s22_q;
  // hls/stages/registration.hpp:79
  logic and_1777;
  assign and_1777 = not_1701 & less_1776_s22_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1779;
  assign select_1779 = select_939_s22_q[4] ? (less_1569_s22_q ? {and_1777, not_1701} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1782;
  assign select_1782 = equal_910_s22_q ? 2'h0 : (drew_s22_q ? (select_939_s22_q[0] ? select_1779 : 2'h0) : 2'h0);
  // hls/stages/agreement.hpp:286
  logic [2:0] select_1847;
  assign select_1847 = less_1844_s22_q ? (sum_1845_s22_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1849;
  assign select_1849 = equal_1292_s22_q ? (equal_419_s22_q ? 3'h0 : select_1847) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1845_s22_q;
  // hls/stages/agreement.hpp:286
  logic select_1877;
  assign select_1877 = equal_1292_s22_q ? (equal_419_s22_q | (less_1844_s22_q ? next : region_fresh_q)) : region_fresh_q;

  // Memory regions, 64 x 36, DISTANCE 32, hls/stages/agreement.hpp:892; read in stage 22, written in stage 25: 22 < 25 < 22 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_961;
  logic regions_re;
  assign regions_re = s22_en & (equal_910_s22_q ? not_963 : and_969_s22_q);
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s22_q;
  logic census_memory_we;
  assign census_memory_we = s22_en & and_360_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s22_q[58:40], census_memory_rdata_s22_q[38:0], and_378_s22_q, whole_2_s22_q, select_370_s22_q, select_366_s22_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s21_sim;
  logic census_memory_re_s21_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s21_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s21_sim <= census_memory_re;
      census_memory_raddr_s21_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s21_sim && census_memory_raddr_s21_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      segment_started_q <= 1'b0;
      next_region_row_q <= 3'h0;
    end else if (s22_en) begin
      region_row_q <= and_360_s22_q ? select_1849 : region_row_q;
      region_fresh_q <= and_360_s22_q ? select_1877 : region_fresh_q;
      segment_started_q <= ~segment_starts_q;
      next_region_row_q <= region_row_q + 3'h1;
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
    if (s22_en) begin
      averager_quarter_1_0_q <= select_1124;
      averager_quarter_1_1_q <= select_1126;
      averager_quarter_2_0_q <= select_1128;
      averager_quarter_2_1_q <= select_1130;
      census_columns_values_0_cell_0_left_q <= select_1158;
      census_columns_values_0_cell_0_right_q <= select_1159;
      census_columns_values_0_cell_1_left_q <= select_1161;
      census_columns_values_0_cell_1_right_q <= select_1162;
      census_columns_values_0_cell_1_mask_q <= select_1163;
      census_columns_values_0_cell_2_left_q <= select_1164;
      census_columns_values_0_cell_2_right_q <= select_1165;
      census_columns_values_0_cell_2_mask_q <= select_1166;
      census_columns_values_0_cell_2_of_skin_q <= select_1167;
      census_columns_values_0_cell_3_left_q <= select_1168;
      census_columns_values_0_cell_3_right_q <= select_1169;
      census_columns_values_0_cell_3_mask_q <= select_1170;
      census_columns_values_0_cell_4_left_q <= select_1171;
      census_columns_values_0_cell_4_right_q <= select_1172;
      census_columns_values_0_cell_4_mask_q <= select_1173;
      census_columns_values_1_cell_0_left_q <= select_1174;
      census_columns_values_1_cell_0_right_q <= select_1175;
      census_columns_values_1_cell_1_left_q <= select_1177;
      census_columns_values_1_cell_1_right_q <= select_1178;
      census_columns_values_1_cell_2_left_q <= select_1180;
      census_columns_values_1_cell_2_right_q <= select_1181;
      census_columns_values_1_cell_2_of_skin_q <= select_1183;
      census_columns_values_1_cell_3_left_q <= select_1184;
      census_columns_values_1_cell_3_right_q <= select_1185;
      census_columns_values_1_cell_4_left_q <= select_1187;
      census_columns_values_1_cell_4_right_q <= select_1188;
      census_columns_values_2_cell_0_left_q <= select_1190;
      census_columns_values_2_cell_0_right_q <= select_1191;
      census_columns_values_2_cell_1_left_q <= select_1193;
      census_columns_values_2_cell_1_right_q <= select_1194;
      census_columns_values_2_cell_2_left_q <= select_1196;
      census_columns_values_2_cell_2_right_q <= select_1197;
      census_columns_values_2_cell_3_left_q <= select_1199;
      census_columns_values_2_cell_3_right_q <= select_1200;
      census_columns_values_2_cell_4_left_q <= select_1202;
      census_columns_values_2_cell_4_right_q <= select_1203;
      census_columns_values_3_cell_1_left_q <= select_1206;
      census_columns_values_3_cell_1_right_q <= select_1207;
      census_columns_values_3_cell_3_left_q <= select_1210;
      census_columns_values_3_cell_3_right_q <= select_1211;
      sharpness_last_mean_0_q <= and_360_s22_q ? select_366_s22_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_360_s22_q ? select_370_s22_q : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic sample_pair_whole_s23_q;
  logic census_columns_values_0_cell_1_mask_s23_q;
  logic census_columns_values_0_cell_2_mask_s23_q;
  logic census_columns_values_0_cell_3_mask_s23_q;
  logic census_columns_values_0_cell_4_mask_s23_q;
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic [7:0] x_s23_q;
  logic age_s23_q;
  logic lower_half_s23_q;
  logic [2:0] region_row_s23_q;
  logic region_fresh_s23_q;
  logic segment_started_s23_q;
  logic centres_values_1_textured_s23_q;
  logic centres_values_1_of_skin_s23_q;
  logic [6:0] column_s23_q;
  logic and_358_s23_q;
  logic and_360_s23_q;
  logic equal_363_s23_q;
  logic whole_2_s23_q;
  logic drew_s23_q;
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
  logic less_405_s23_q;
  logic less_406_s23_q;
  logic less_407_s23_q;
  logic less_408_s23_q;
  logic less_409_s23_q;
  logic less_410_s23_q;
  logic less_411_s23_q;
  logic less_412_s23_q;
  logic less_413_s23_q;
  logic less_414_s23_q;
  logic less_415_s23_q;
  logic equal_419_s23_q;
  logic and_427_s23_q;
  logic difference_450_s23_q;
  logic [8:0] xor_451_s23_q;
  logic difference_453_s23_q;
  logic [8:0] xor_454_s23_q;
  logic difference_457_s23_q;
  logic [8:0] xor_458_s23_q;
  logic difference_461_s23_q;
  logic [8:0] xor_462_s23_q;
  logic difference_465_s23_q;
  logic [8:0] xor_466_s23_q;
  logic [6:0] x_s23_2_q;
  logic [7:0] best_left_rdata_s23_q;
  logic equal_532_s23_q;
  logic select_828_s23_q;
  logic less_834_s23_q;
  logic less_835_s23_q;
  logic or_837_s23_q;
  logic [7:0] select_841_s23_q;
  logic [5:0] select_845_s23_q;
  logic equal_850_s23_q;
  logic rise_s23_q;
  logic [1:0] sum_862_s23_q;
  logic [7:0] twice_s23_q;
  logic [8:0] select_873_s23_q;
  logic and_894_s23_q;
  logic equal_910_s23_q;
  logic not_911_s23_q;
  logic [2:0] select_939_s23_q;
  logic or_954_s23_q;
  logic or_957_s23_q;
  logic or_960_s23_q;
  logic equal_962_s23_q;
  logic textured_s23_q;
  logic explained_s23_q;
  logic and_983_s23_q;
  logic and_988_s23_q;
  logic [2:0] textured_2_s23_q;
  logic or_1045_s23_q;
  logic or_1048_s23_q;
  logic or_1051_s23_q;
  logic [2:0] shown_2_s23_q;
  logic [2:0] near_2_s23_q;
  logic and_1100_s23_q;
  logic sum_1135_s23_q;
  logic [9:0] difference_1136_s23_q;
  logic sum_1143_s23_q;
  logic [9:0] difference_1144_s23_q;
  logic difference_1215_s23_q;
  logic [8:0] xor_1216_s23_q;
  logic difference_1218_s23_q;
  logic [8:0] xor_1219_s23_q;
  logic difference_1222_s23_q;
  logic [8:0] xor_1223_s23_q;
  logic difference_1226_s23_q;
  logic [8:0] xor_1227_s23_q;
  logic difference_1230_s23_q;
  logic [8:0] xor_1231_s23_q;
  logic equal_1240_s23_q;
  logic difference_1260_s23_q;
  logic [8:0] xor_1261_s23_q;
  logic difference_1271_s23_q;
  logic [8:0] xor_1272_s23_q;
  logic equal_1292_s23_q;
  logic and_1474_s23_q;
  logic [2:0] explained_2_s23_q;
  logic [9:0] select_1566_s23_q;
  logic less_1569_s23_q;
  logic less_1571_s23_q;
  logic equal_1572_s23_q;
  logic equal_1573_s23_q;
  logic equal_1574_s23_q;
  logic [7:0] residual_s23_q;
  logic and_1655_s23_q;
  logic and_1664_s23_q;
  logic and_1673_s23_q;
  logic and_1681_s23_q;
  logic less_1693_s23_q;
  logic [1:0] select_1698_s23_q;
  logic not_1701_s23_q;
  logic less_1776_s23_q;
  logic [1:0] select_1782_s23_q;
  logic equal_1987_s23_q;
  logic and_2187_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      sample_pair_whole_s23_q <= sample_pair_whole_s22_q;
      census_columns_values_0_cell_1_mask_s23_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s23_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s23_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s23_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s23_q <= x_s22_q;
      age_s23_q <= age_s22_q;
      lower_half_s23_q <= lower_half_s22_q;
      region_row_s23_q <= region_row_q;
      region_fresh_s23_q <= region_fresh_q;
      segment_started_s23_q <= segment_started_q;
      centres_values_1_textured_s23_q <= centres_values_1_textured_s22_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_s22_q;
      column_s23_q <= column_s22_q;
      and_358_s23_q <= and_358_s22_q;
      and_360_s23_q <= and_360_s22_q;
      equal_363_s23_q <= equal_363_s22_q;
      whole_2_s23_q <= whole_2_s22_q;
      drew_s23_q <= drew_s22_q;
      less_392_s23_q <= less_392;
      less_393_s23_q <= less_393;
      less_394_s23_q <= less_394;
      less_395_s23_q <= less_395;
      less_396_s23_q <= less_396;
      less_397_s23_q <= less_397;
      less_398_s23_q <= less_398;
      less_399_s23_q <= less_399;
      less_400_s23_q <= less_400;
      less_401_s23_q <= less_401;
      less_402_s23_q <= less_402;
      less_403_s23_q <= less_403;
      less_404_s23_q <= less_404;
      less_405_s23_q <= less_405;
      less_406_s23_q <= less_406;
      less_407_s23_q <= less_407;
      less_408_s23_q <= less_408;
      less_409_s23_q <= less_409;
      less_410_s23_q <= less_410;
      less_411_s23_q <= less_411;
      less_412_s23_q <= less_412;
      less_413_s23_q <= less_413;
      less_414_s23_q <= less_414;
      less_415_s23_q <= less_415;
      equal_419_s23_q <= equal_419_s22_q;
      and_427_s23_q <= and_427;
      difference_450_s23_q <= difference_450[9];
      xor_451_s23_q <= difference_450[8:0] ^ {9{difference_450[9]}};
      difference_453_s23_q <= difference_453[9];
      xor_454_s23_q <= difference_453[8:0] ^ {9{difference_453[9]}};
      difference_457_s23_q <= difference_457[9];
      xor_458_s23_q <= difference_457[8:0] ^ {9{difference_457[9]}};
      difference_461_s23_q <= difference_461[9];
      xor_462_s23_q <= difference_461[8:0] ^ {9{difference_461[9]}};
      difference_465_s23_q <= difference_465[9];
      xor_466_s23_q <= difference_465[8:0] ^ {9{difference_465[9]}};
      x_s23_2_q <= x_s22_2_q;
      best_left_rdata_s23_q <= best_left_rdata_s22_q;
      equal_532_s23_q <= equal_532_s22_q;
      select_828_s23_q <= select_828_s22_q;
      less_834_s23_q <= less_834_s22_q;
      less_835_s23_q <= less_835_s22_q;
      or_837_s23_q <= or_837_s22_q;
      select_841_s23_q <= select_841_s22_q;
      select_845_s23_q <= select_845_s22_q;
      equal_850_s23_q <= equal_850_s22_q;
      rise_s23_q <= rise_s22_q;
      sum_862_s23_q <= sum_862_s22_q;
      twice_s23_q <= twice_s22_q;
      select_873_s23_q <= select_873;
      and_894_s23_q <= and_894_s22_q;
      equal_910_s23_q <= equal_910_s22_q;
      not_911_s23_q <= not_911_s22_q;
      select_939_s23_q <= {select_939_s22_q[4], select_939_s22_q[2], select_939_s22_q[0]};
      or_954_s23_q <= or_954_s22_q;
      or_957_s23_q <= or_957_s22_q;
      or_960_s23_q <= or_960_s22_q;
      equal_962_s23_q <= equal_962_s22_q;
      textured_s23_q <= textured_s22_q;
      explained_s23_q <= explained_s22_q;
      and_983_s23_q <= and_983;
      and_988_s23_q <= not_911_s22_q & and_969_s22_q;
      textured_2_s23_q <= textured_2;
      or_1045_s23_q <= or_1045_s22_q;
      or_1048_s23_q <= or_1048_s22_q;
      or_1051_s23_q <= or_1051_s22_q;
      shown_2_s23_q <= shown_2;
      near_2_s23_q <= near_2;
      and_1100_s23_q <= and_1100_s22_q;
      sum_1135_s23_q <= sum_1135[0];
      difference_1136_s23_q <= {1'b0, sum_1135[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_1143_s23_q <= sum_1143[0];
      difference_1144_s23_q <= {1'b0, sum_1143[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_1215_s23_q <= difference_1215[9];
      xor_1216_s23_q <= difference_1215[8:0] ^ {9{difference_1215[9]}};
      difference_1218_s23_q <= difference_1218[9];
      xor_1219_s23_q <= difference_1218[8:0] ^ {9{difference_1218[9]}};
      difference_1222_s23_q <= difference_1222[9];
      xor_1223_s23_q <= difference_1222[8:0] ^ {9{difference_1222[9]}};
      difference_1226_s23_q <= difference_1226[9];
      xor_1227_s23_q <= difference_1226[8:0] ^ {9{difference_1226[9]}};
      difference_1230_s23_q <= difference_1230[9];
      xor_1231_s23_q <= difference_1230[8:0] ^ {9{difference_1230[9]}};
      equal_1240_s23_q <= equal_1240_s22_q;
      difference_1260_s23_q <= difference_1260[9];
      xor_1261_s23_q <= difference_1260[8:0] ^ {9{difference_1260[9]}};
      difference_1271_s23_q <= difference_1271[9];
      xor_1272_s23_q <= difference_1271[8:0] ^ {9{difference_1271[9]}};
      equal_1292_s23_q <= equal_1292_s22_q;
      and_1474_s23_q <= and_1474;
      explained_2_s23_q <= explained_2;
      select_1566_s23_q <= select_1566;
      less_1569_s23_q <= less_1569_s22_q;
      less_1571_s23_q <= less_1571_s22_q;
      equal_1572_s23_q <= equal_1572;
      equal_1573_s23_q <= equal_1573;
      equal_1574_s23_q <= equal_1574;
      residual_s23_q <= residual_s22_q;
      and_1655_s23_q <= select_939_s22_q[0] & and_1654;
      and_1664_s23_q <= select_939_s22_q[0] & and_1663;
      and_1673_s23_q <= drew_s22_q & (select_939_s22_q[0] & and_1671);
      and_1681_s23_q <= not_911_s22_q & (drew_s22_q & and_1679);
      less_1693_s23_q <= less_1693_s22_q;
      select_1698_s23_q <= equal_910_s22_q ? 2'h0 : (drew_s22_q ? select_1696 : 2'h0);
      not_1701_s23_q <= not_1701;
      less_1776_s23_q <= less_1776_s22_q;
      select_1782_s23_q <= select_1782;
      equal_1987_s23_q <= equal_1987_s22_q;
      and_2187_s23_q <= equal_910_s22_q & not_963;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [3:0] census_filled_q;
  logic [4:0] rows_passed_above_q;
  logic [23:0] counts_too_much_hidden_q;
  logic [11:0] registration_counts_measured_0_q;
  logic [11:0] registration_counts_measured_1_q;
  logic [11:0] registration_counts_measured_2_q;
  logic [11:0] registration_counts_measured_3_q;
  logic [14:0] registration_counts_votes_0_up_q;
  logic [14:0] registration_counts_half_votes_0_up_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
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
  logic [4:0] box_shown_columns_values_0_q;
  logic [4:0] box_shown_columns_values_1_q;
  logic [4:0] box_shown_columns_values_2_q;
  logic [4:0] box_shown_columns_values_3_q;
  logic [4:0] box_shown_columns_values_4_q;
  logic [4:0] box_nearer_columns_values_0_q;
  logic [4:0] box_nearer_columns_values_1_q;
  logic [4:0] box_nearer_columns_values_2_q;
  logic [4:0] box_nearer_columns_values_3_q;
  logic [4:0] box_nearer_columns_values_4_q;
  logic [13:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  // hls/stages/agreement.hpp:281
  logic equal_416;
  assign equal_416 = column_s23_q == 7'h0;
  logic [3:0] select_420;
  assign select_420 = equal_419_s23_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:282
  logic [4:0] select_421;
  assign select_421 = equal_416 ? {select_420, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_422;
  assign select_422 = equal_416 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:282
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_427_s23_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s23_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s23_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s23_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s23_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:190
  logic [9:0] sum_452;
  assign sum_452 = {9'h0, difference_450_s23_q} + {1'b0, xor_451_s23_q};
  logic [9:0] sum_455;
  assign sum_455 = {9'h0, difference_453_s23_q} + {1'b0, xor_454_s23_q};
  // hls/stages/agreement.hpp:509
  logic [6:0] select_973;
  assign select_973 = segment_started_s23_q ? segment_textured_q : 7'h0;
  logic [6:0] select_978;
  assign select_978 = segment_started_s23_q ? segment_explained_q : 7'h0;
  logic [6:0] select_984;
  assign select_984 = segment_started_s23_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:802
  logic or_995;
  assign or_995 = marks_first_s23_q | line_ended_q;
  // hls/stages/agreement.hpp:804
  logic [13:0] select_997;
  assign select_997 = marks_first_s23_q ? 14'h1 : (or_995 ? {rows_passed_q[12:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:803
  logic [8:0] select_999;
  assign select_999 = or_995 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:811
  logic select_1001;
  assign select_1001 = cfg_compete_i ? (or_995 & select_997[13]) : (select_999[8] & select_997[9]);
  // hls/stages/agreement.hpp:672
  logic [4:0] difference_1036;
  assign difference_1036 = {2'h0, textured_2_s23_q} - (age_s23_q ? box_textured_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:674
  logic [4:0] difference_1070;
  assign difference_1070 = {2'h0, shown_2_s23_q} - (age_s23_q ? box_shown_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:675
  logic [4:0] difference_1086;
  assign difference_1086 = {2'h0, near_2_s23_q} - (age_s23_q ? box_nearer_columns_values_4_q : 5'h0);
  // hls/stages/census.hpp:129
  logic [9:0] xor_1137;
  assign xor_1137 = {difference_1136_s23_q[8:0], sum_1135_s23_q} ^ {10{difference_1136_s23_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1136_s23_q[9]} + {1'b0, xor_1137};
  logic [9:0] xor_1145;
  assign xor_1145 = {difference_1144_s23_q[8:0], sum_1143_s23_q} ^ {10{difference_1144_s23_q[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1144_s23_q[9]} + {1'b0, xor_1145};
  // hls/stages/agreement.hpp:205
  logic select_1160;
  assign select_1160 = and_360_s23_q ? whole_2_s23_q : census_columns_values_0_cell_0_mask_q;
  logic select_1176;
  assign select_1176 = and_360_s23_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_1179;
  assign select_1179 = and_360_s23_q ? census_columns_values_0_cell_1_mask_s23_q : census_columns_values_1_cell_1_mask_q;
  logic select_1182;
  assign select_1182 = and_360_s23_q ? census_columns_values_0_cell_2_mask_s23_q : census_columns_values_1_cell_2_mask_q;
  logic select_1186;
  assign select_1186 = and_360_s23_q ? census_columns_values_0_cell_3_mask_s23_q : census_columns_values_1_cell_3_mask_q;
  logic select_1189;
  assign select_1189 = and_360_s23_q ? census_columns_values_0_cell_4_mask_s23_q : census_columns_values_1_cell_4_mask_q;
  logic select_1192;
  assign select_1192 = and_360_s23_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_1195;
  assign select_1195 = and_360_s23_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] sum_1217;
  assign sum_1217 = {9'h0, difference_1215_s23_q} + {1'b0, xor_1216_s23_q};
  logic [9:0] sum_1220;
  assign sum_1220 = {9'h0, difference_1218_s23_q} + {1'b0, xor_1219_s23_q};
  // hls/stages/census.hpp:273
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1260_s23_q} + xor_1261_s23_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1271_s23_q} + xor_1272_s23_q;
  // hls/stages/agreement.hpp:205
  logic and_1471;
  assign and_1471 = and_360_s23_q & (equal_419_s23_q & equal_1292_s23_q);
  // hls/stages/agreement.hpp:339
  logic and_1478;
  assign and_1478 = not_911_s23_q & (drew_s23_q & textured_s23_q);
  logic and_1482;
  assign and_1482 = not_911_s23_q & (drew_s23_q & explained_s23_q);
  logic and_1486;
  assign and_1486 = not_911_s23_q & (drew_s23_q & and_983_s23_q);
  // hls/stages/agreement.hpp:673
  logic [4:0] difference_1500;
  assign difference_1500 = {2'h0, explained_2_s23_q} - (age_s23_q ? box_explained_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:532
  logic [23:0] sum_1567;
  assign sum_1567 = counts_too_much_hidden_q + {{14{select_1566_s23_q[9]}}, select_1566_s23_q};
  // hls/stages/agreement.hpp:339
  logic and_1657;
  assign and_1657 = not_911_s23_q & (drew_s23_q & and_1655_s23_q);
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1659;
  assign select_1659 = and_1471 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1657});
  // hls/stages/agreement.hpp:339
  logic and_1666;
  assign and_1666 = not_911_s23_q & (drew_s23_q & and_1664_s23_q);
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1668;
  assign select_1668 = and_1471 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1666});
  // hls/stages/agreement.hpp:339
  logic and_1674;
  assign and_1674 = not_911_s23_q & and_1673_s23_q;
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1676;
  assign select_1676 = and_1471 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1674});
  logic [11:0] select_1683;
  assign select_1683 = and_1471 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1681_s23_q});
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1699;
  assign sum_1699 = registration_counts_votes_0_up_q + {{13{select_1698_s23_q[1]}}, select_1698_s23_q};
  logic [14:0] sum_1783;
  assign sum_1783 = registration_counts_half_votes_0_up_q + {{13{select_1782_s23_q[1]}}, select_1782_s23_q};
  // hls/stages/registration.hpp:79
  logic and_1793;
  assign and_1793 = less_1571_s23_q & less_1776_s23_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1795;
  assign select_1795 = select_939_s23_q[2] ? (less_1569_s23_q ? {and_1793, less_1571_s23_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1798;
  assign select_1798 = equal_910_s23_q ? 2'h0 : (drew_s23_q ? (select_939_s23_q[0] ? select_1795 : 2'h0) : 2'h0);
  logic [4:0] select_1930;
  assign select_1930 = drew_s23_q ? {2'h0, textured_2_s23_q} : box_textured_columns_values_0_q;
  logic [4:0] select_1932;
  assign select_1932 = drew_s23_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1934;
  assign select_1934 = drew_s23_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1936;
  assign select_1936 = drew_s23_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1938;
  assign select_1938 = drew_s23_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1942;
  assign select_1942 = drew_s23_q ? {2'h0, explained_2_s23_q} : box_explained_columns_values_0_q;
  logic [4:0] select_1944;
  assign select_1944 = drew_s23_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1946;
  assign select_1946 = drew_s23_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1948;
  assign select_1948 = drew_s23_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1950;
  assign select_1950 = drew_s23_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1954;
  assign select_1954 = drew_s23_q ? {2'h0, shown_2_s23_q} : box_shown_columns_values_0_q;
  logic [4:0] select_1956;
  assign select_1956 = drew_s23_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [4:0] select_1958;
  assign select_1958 = drew_s23_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [4:0] select_1960;
  assign select_1960 = drew_s23_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [4:0] select_1962;
  assign select_1962 = drew_s23_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [4:0] select_1966;
  assign select_1966 = drew_s23_q ? {2'h0, near_2_s23_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_1968;
  assign select_1968 = drew_s23_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1970;
  assign select_1970 = drew_s23_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1972;
  assign select_1972 = drew_s23_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1974;
  assign select_1974 = drew_s23_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2061;
  assign sum_2061 = {1'b0, upper} + {1'b0, lower};
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_q} + {1'b0, registration_counts_measured_3_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      counts_too_much_hidden_q <= 24'h0;
      registration_counts_measured_0_q <= 12'h0;
      registration_counts_measured_1_q <= 12'h0;
      registration_counts_measured_2_q <= 12'h0;
      registration_counts_measured_3_q <= 12'h0;
      registration_counts_votes_0_up_q <= 15'h0;
      registration_counts_half_votes_0_up_q <= 15'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      rows_passed_q <= 14'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s23_en) begin
      census_filled_q <= and_360_s23_q ? {select_422[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_360_s23_q ? select_421 : rows_passed_above_q;
      counts_too_much_hidden_q <= and_1471 ? 24'h0 : sum_1567;
      registration_counts_measured_0_q <= select_1659;
      registration_counts_measured_1_q <= select_1668;
      registration_counts_measured_2_q <= select_1676;
      registration_counts_measured_3_q <= select_1683;
      registration_counts_votes_0_up_q <= and_1471 ? 15'h0 : sum_1699;
      registration_counts_half_votes_0_up_q <= and_1471 ? 15'h0 : sum_1783;
      segment_textured_q <= select_973 + {6'h0, and_1478};
      segment_explained_q <= select_978 + {6'h0, and_1482};
      segment_nearer_q <= select_984 + {6'h0, and_1486};
      rows_passed_q <= select_997;
      columns_passed_q <= {select_999[7:0], or_995};
      line_ended_q <= marks_last_s23_q;
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
    box_shown_columns_values_0_q = 5'h0;
    box_shown_columns_values_1_q = 5'h0;
    box_shown_columns_values_2_q = 5'h0;
    box_shown_columns_values_3_q = 5'h0;
    box_shown_columns_values_4_q = 5'h0;
    box_nearer_columns_values_0_q = 5'h0;
    box_nearer_columns_values_1_q = 5'h0;
    box_nearer_columns_values_2_q = 5'h0;
    box_nearer_columns_values_3_q = 5'h0;
    box_nearer_columns_values_4_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s23_en) begin
      census_columns_values_0_cell_0_mask_q <= select_1160;
      census_columns_values_1_cell_0_mask_q <= select_1176;
      census_columns_values_1_cell_1_mask_q <= select_1179;
      census_columns_values_1_cell_2_mask_q <= select_1182;
      census_columns_values_1_cell_3_mask_q <= select_1186;
      census_columns_values_1_cell_4_mask_q <= select_1189;
      census_columns_values_2_cell_0_mask_q <= select_1192;
      census_columns_values_2_cell_1_mask_q <= select_1195;
      box_textured_columns_values_0_q <= equal_910_s23_q ? box_textured_columns_values_0_q : select_1930;
      box_textured_columns_values_1_q <= equal_910_s23_q ? box_textured_columns_values_1_q : select_1932;
      box_textured_columns_values_2_q <= equal_910_s23_q ? box_textured_columns_values_2_q : select_1934;
      box_textured_columns_values_3_q <= equal_910_s23_q ? box_textured_columns_values_3_q : select_1936;
      box_textured_columns_values_4_q <= equal_910_s23_q ? box_textured_columns_values_4_q : select_1938;
      box_explained_columns_values_0_q <= equal_910_s23_q ? box_explained_columns_values_0_q : select_1942;
      box_explained_columns_values_1_q <= equal_910_s23_q ? box_explained_columns_values_1_q : select_1944;
      box_explained_columns_values_2_q <= equal_910_s23_q ? box_explained_columns_values_2_q : select_1946;
      box_explained_columns_values_3_q <= equal_910_s23_q ? box_explained_columns_values_3_q : select_1948;
      box_explained_columns_values_4_q <= equal_910_s23_q ? box_explained_columns_values_4_q : select_1950;
      box_shown_columns_values_0_q <= equal_910_s23_q ? box_shown_columns_values_0_q : select_1954;
      box_shown_columns_values_1_q <= equal_910_s23_q ? box_shown_columns_values_1_q : select_1956;
      box_shown_columns_values_2_q <= equal_910_s23_q ? box_shown_columns_values_2_q : select_1958;
      box_shown_columns_values_3_q <= equal_910_s23_q ? box_shown_columns_values_3_q : select_1960;
      box_shown_columns_values_4_q <= equal_910_s23_q ? box_shown_columns_values_4_q : select_1962;
      box_nearer_columns_values_0_q <= equal_910_s23_q ? box_nearer_columns_values_0_q : select_1966;
      box_nearer_columns_values_1_q <= equal_910_s23_q ? box_nearer_columns_values_1_q : select_1968;
      box_nearer_columns_values_2_q <= equal_910_s23_q ? box_nearer_columns_values_2_q : select_1970;
      box_nearer_columns_values_3_q <= equal_910_s23_q ? box_nearer_columns_values_3_q : select_1972;
      box_nearer_columns_values_4_q <= equal_910_s23_q ? box_nearer_columns_values_4_q : select_1974;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic sample_pair_whole_s24_q;
  logic census_columns_values_1_cell_2_mask_s24_q;
  logic census_columns_values_1_cell_2_of_skin_s24_q;
  logic census_columns_values_1_cell_3_mask_s24_q;
  logic census_columns_values_1_cell_4_mask_s24_q;
  logic census_columns_values_2_cell_0_mask_s24_q;
  logic census_columns_values_2_cell_1_mask_s24_q;
  logic [7:0] x_s24_q;
  logic lower_half_s24_q;
  logic [11:0] registration_counts_measured_0_s24_q;
  logic [11:0] registration_counts_measured_1_s24_q;
  logic [11:0] registration_counts_measured_2_s24_q;
  logic [11:0] registration_counts_measured_3_s24_q;
  logic [2:0] region_row_s24_q;
  logic region_fresh_s24_q;
  logic centres_values_1_textured_s24_q;
  logic centres_values_1_of_skin_s24_q;
  logic [6:0] column_s24_q;
  logic and_358_s24_q;
  logic and_360_s24_q;
  logic equal_363_s24_q;
  logic whole_2_s24_q;
  logic drew_s24_q;
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
  logic less_405_s24_q;
  logic less_406_s24_q;
  logic less_407_s24_q;
  logic less_408_s24_q;
  logic less_409_s24_q;
  logic less_410_s24_q;
  logic less_411_s24_q;
  logic less_412_s24_q;
  logic less_413_s24_q;
  logic less_414_s24_q;
  logic less_415_s24_q;
  logic and_423_s24_q;
  logic whole_9_s24_q;
  logic [10:0] sum_456_s24_q;
  logic [9:0] sum_459_s24_q;
  logic [9:0] sum_463_s24_q;
  logic [9:0] sum_467_s24_q;
  logic [6:0] x_s24_2_q;
  logic [7:0] best_left_rdata_s24_q;
  logic equal_532_s24_q;
  logic select_828_s24_q;
  logic less_834_s24_q;
  logic less_835_s24_q;
  logic or_837_s24_q;
  logic [7:0] select_841_s24_q;
  logic [5:0] select_845_s24_q;
  logic equal_850_s24_q;
  logic rise_s24_q;
  logic [1:0] sum_862_s24_q;
  logic [7:0] twice_s24_q;
  logic [8:0] difference_874_s24_q;
  logic and_894_s24_q;
  logic equal_910_s24_q;
  logic not_911_s24_q;
  logic [2:0] select_939_s24_q;
  logic or_954_s24_q;
  logic or_957_s24_q;
  logic or_960_s24_q;
  logic equal_962_s24_q;
  logic [35:0] regions_rdata_s24_q;
  logic [6:0] sum_974_s24_q;
  logic [6:0] sum_979_s24_q;
  logic [6:0] sum_985_s24_q;
  logic and_988_s24_q;
  logic select_1001_s24_q;
  logic [4:0] difference_1036_s24_q;
  logic equal_1037_s24_q;
  logic or_1045_s24_q;
  logic or_1048_s24_q;
  logic or_1051_s24_q;
  logic [4:0] difference_1070_s24_q;
  logic [4:0] difference_1086_s24_q;
  logic and_1100_s24_q;
  logic [10:0] size_2_s24_q;
  logic [10:0] size_3_s24_q;
  logic [10:0] sum_1221_s24_q;
  logic [9:0] sum_1224_s24_q;
  logic [9:0] sum_1228_s24_q;
  logic [9:0] sum_1232_s24_q;
  logic equal_1240_s24_q;
  logic [8:0] contrast_s24_q;
  logic [8:0] contrast_2_s24_q;
  logic equal_1292_s24_q;
  logic and_1471_s24_q;
  logic and_1474_s24_q;
  logic and_1478_s24_q;
  logic and_1482_s24_q;
  logic and_1486_s24_q;
  logic [4:0] difference_1500_s24_q;
  logic less_1569_s24_q;
  logic less_1571_s24_q;
  logic equal_1572_s24_q;
  logic equal_1573_s24_q;
  logic equal_1574_s24_q;
  logic [7:0] residual_s24_q;
  logic less_1693_s24_q;
  logic not_1701_s24_q;
  logic less_1776_s24_q;
  logic [1:0] select_1798_s24_q;
  logic less_1906_s24_q;
  logic equal_1987_s24_q;
  logic [10:0] sum_2061_s24_q;
  logic less_2065_s24_q;
  logic less_2067_s24_q;
  logic less_2070_s24_q;
  logic less_2072_s24_q;
  logic less_2076_s24_q;
  logic less_2088_s24_q;
  logic and_2187_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      sample_pair_whole_s24_q <= sample_pair_whole_s23_q;
      census_columns_values_1_cell_2_mask_s24_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s24_q <= census_columns_values_1_cell_2_of_skin_s23_q;
      census_columns_values_1_cell_3_mask_s24_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s24_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s24_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s24_q <= census_columns_values_2_cell_1_mask_q;
      x_s24_q <= x_s23_q;
      lower_half_s24_q <= lower_half_s23_q;
      registration_counts_measured_0_s24_q <= registration_counts_measured_0_q;
      registration_counts_measured_1_s24_q <= registration_counts_measured_1_q;
      registration_counts_measured_2_s24_q <= registration_counts_measured_2_q;
      registration_counts_measured_3_s24_q <= registration_counts_measured_3_q;
      region_row_s24_q <= region_row_s23_q;
      region_fresh_s24_q <= region_fresh_s23_q;
      centres_values_1_textured_s24_q <= centres_values_1_textured_s23_q;
      centres_values_1_of_skin_s24_q <= centres_values_1_of_skin_s23_q;
      column_s24_q <= column_s23_q;
      and_358_s24_q <= and_358_s23_q;
      and_360_s24_q <= and_360_s23_q;
      equal_363_s24_q <= equal_363_s23_q;
      whole_2_s24_q <= whole_2_s23_q;
      drew_s24_q <= drew_s23_q;
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
      less_405_s24_q <= less_405_s23_q;
      less_406_s24_q <= less_406_s23_q;
      less_407_s24_q <= less_407_s23_q;
      less_408_s24_q <= less_408_s23_q;
      less_409_s24_q <= less_409_s23_q;
      less_410_s24_q <= less_410_s23_q;
      less_411_s24_q <= less_411_s23_q;
      less_412_s24_q <= less_412_s23_q;
      less_413_s24_q <= less_413_s23_q;
      less_414_s24_q <= less_414_s23_q;
      less_415_s24_q <= less_415_s23_q;
      and_423_s24_q <= select_421[4] & select_422[3];
      whole_9_s24_q <= whole_9;
      sum_456_s24_q <= {1'b0, sum_452} + {1'b0, sum_455};
      sum_459_s24_q <= {9'h0, difference_457_s23_q} + {1'b0, xor_458_s23_q};
      sum_463_s24_q <= {9'h0, difference_461_s23_q} + {1'b0, xor_462_s23_q};
      sum_467_s24_q <= {9'h0, difference_465_s23_q} + {1'b0, xor_466_s23_q};
      x_s24_2_q <= x_s23_2_q;
      best_left_rdata_s24_q <= best_left_rdata_s23_q;
      equal_532_s24_q <= equal_532_s23_q;
      select_828_s24_q <= select_828_s23_q;
      less_834_s24_q <= less_834_s23_q;
      less_835_s24_q <= less_835_s23_q;
      or_837_s24_q <= or_837_s23_q;
      select_841_s24_q <= select_841_s23_q;
      select_845_s24_q <= select_845_s23_q;
      equal_850_s24_q <= equal_850_s23_q;
      rise_s24_q <= rise_s23_q;
      sum_862_s24_q <= sum_862_s23_q;
      twice_s24_q <= twice_s23_q;
      difference_874_s24_q <= {1'b0, twice_s23_q} - select_873_s23_q;
      and_894_s24_q <= and_894_s23_q;
      equal_910_s24_q <= equal_910_s23_q;
      not_911_s24_q <= not_911_s23_q;
      select_939_s24_q <= select_939_s23_q;
      or_954_s24_q <= or_954_s23_q;
      or_957_s24_q <= or_957_s23_q;
      or_960_s24_q <= or_960_s23_q;
      equal_962_s24_q <= equal_962_s23_q;
      regions_rdata_s24_q <= regions_rdata_q;
      sum_974_s24_q <= {6'h0, textured_s23_q} + select_973;
      sum_979_s24_q <= {6'h0, explained_s23_q} + select_978;
      sum_985_s24_q <= {6'h0, and_983_s23_q} + select_984;
      and_988_s24_q <= and_988_s23_q;
      select_1001_s24_q <= select_1001;
      difference_1036_s24_q <= difference_1036;
      equal_1037_s24_q <= x_s23_q == 8'h0;
      or_1045_s24_q <= or_1045_s23_q;
      or_1048_s24_q <= or_1048_s23_q;
      or_1051_s24_q <= or_1051_s23_q;
      difference_1070_s24_q <= difference_1070;
      difference_1086_s24_q <= difference_1086;
      and_1100_s24_q <= and_1100_s23_q;
      size_2_s24_q <= size_2;
      size_3_s24_q <= size_3;
      sum_1221_s24_q <= {1'b0, sum_1217} + {1'b0, sum_1220};
      sum_1224_s24_q <= {9'h0, difference_1222_s23_q} + {1'b0, xor_1223_s23_q};
      sum_1228_s24_q <= {9'h0, difference_1226_s23_q} + {1'b0, xor_1227_s23_q};
      sum_1232_s24_q <= {9'h0, difference_1230_s23_q} + {1'b0, xor_1231_s23_q};
      equal_1240_s24_q <= equal_1240_s23_q;
      contrast_s24_q <= contrast;
      contrast_2_s24_q <= contrast_2;
      equal_1292_s24_q <= equal_1292_s23_q;
      and_1471_s24_q <= and_1471;
      and_1474_s24_q <= and_1474_s23_q;
      and_1478_s24_q <= and_1478;
      and_1482_s24_q <= and_1482;
      and_1486_s24_q <= and_1486;
      difference_1500_s24_q <= difference_1500;
      less_1569_s24_q <= less_1569_s23_q;
      less_1571_s24_q <= less_1571_s23_q;
      equal_1572_s24_q <= equal_1572_s23_q;
      equal_1573_s24_q <= equal_1573_s23_q;
      equal_1574_s24_q <= equal_1574_s23_q;
      residual_s24_q <= residual_s23_q;
      less_1693_s24_q <= less_1693_s23_q;
      not_1701_s24_q <= not_1701_s23_q;
      less_1776_s24_q <= less_1776_s23_q;
      select_1798_s24_q <= select_1798;
      less_1906_s24_q <= $signed(24'h0) < $signed(counts_too_much_hidden_q);
      equal_1987_s24_q <= equal_1987_s23_q;
      sum_2061_s24_q <= sum_2061[13:3];
      less_2065_s24_q <= 11'he < left[12:2];
      less_2067_s24_q <= $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
      less_2070_s24_q <= 11'he < right[12:2];
      less_2072_s24_q <= $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
      less_2076_s24_q <= 11'he < upper[12:2];
      less_2088_s24_q <= 11'he < lower[12:2];
      and_2187_s24_q <= and_2187_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic [13:0] averager_detail_0_q;
  logic [13:0] averager_detail_1_q;
  logic census_columns_values_2_cell_2_mask_q;
  logic census_columns_values_2_cell_3_mask_q;
  logic census_columns_values_2_cell_4_mask_q;
  logic census_columns_values_3_cell_0_mask_q;
  logic census_columns_values_3_cell_1_mask_q;
  logic census_columns_values_3_cell_2_mask_q;
  logic census_columns_values_3_cell_3_mask_q;
  logic [14:0] registration_counts_half_votes_1_up_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic began_q;
  logic [3:0] seen_x_q;
  logic [3:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/agreement.hpp:282
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_s24_q & whole_9_s24_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s24_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s24_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s24_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s24_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:190
  logic [10:0] sum_460;
  assign sum_460 = sum_456_s24_q + {1'b0, sum_459_s24_q};
  // hls/stages/registration.hpp:28
  logic not_875;
  assign not_875 = ~difference_874_s24_q[8];
  logic [7:0] xor_876;
  assign xor_876 = twice_s24_q ^ {8{not_875}};
  logic [9:0] sum_877;
  assign sum_877 = {difference_874_s24_q[7:0], 1'b0, not_875} + {not_875, xor_876, not_875};
  // hls/stages/agreement.hpp:639
  logic [11:0] sum_976;
  assign sum_976 = {5'h0, sum_974_s24_q} + (region_fresh_s24_q ? 12'h0 : regions_rdata_s24_q[11:0]);
  // hls/stages/agreement.hpp:640
  logic [11:0] sum_981;
  assign sum_981 = {5'h0, sum_979_s24_q} + (region_fresh_s24_q ? 12'h0 : regions_rdata_s24_q[23:12]);
  // hls/stages/agreement.hpp:641
  logic [11:0] sum_987;
  assign sum_987 = {5'h0, sum_985_s24_q} + (region_fresh_s24_q ? 12'h0 : regions_rdata_s24_q[35:24]);
  // hls/stages/agreement.hpp:206
  logic next_row;
  assign next_row = select_1001_s24_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:818
  logic [6:0] select_1004;
  assign select_1004 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:828
  logic equal_1007;
  assign equal_1007 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:801
  logic not_1014;
  assign not_1014 = ~marks_first_s24_q;
  // hls/stages/agreement.hpp:672
  logic [4:0] t;
  assign t = difference_1036_s24_q + (equal_1037_s24_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:674
  logic [4:0] around;
  assign around = difference_1070_s24_q + (equal_1037_s24_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:675
  logic [4:0] n;
  assign n = difference_1086_s24_q + (equal_1037_s24_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2_s24_q} + (equal_363_s24_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1142;
  assign select_1142 = sample_pair_whole_s24_q ? (and_358_s24_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3_s24_q} + (equal_363_s24_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1150;
  assign select_1150 = sample_pair_whole_s24_q ? (and_358_s24_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:205
  logic select_1198;
  assign select_1198 = and_360_s24_q ? census_columns_values_1_cell_2_mask_s24_q : census_columns_values_2_cell_2_mask_q;
  logic select_1201;
  assign select_1201 = and_360_s24_q ? census_columns_values_1_cell_3_mask_s24_q : census_columns_values_2_cell_3_mask_q;
  logic select_1204;
  assign select_1204 = and_360_s24_q ? census_columns_values_1_cell_4_mask_s24_q : census_columns_values_2_cell_4_mask_q;
  logic select_1205;
  assign select_1205 = and_360_s24_q ? census_columns_values_2_cell_0_mask_s24_q : census_columns_values_3_cell_0_mask_q;
  logic select_1208;
  assign select_1208 = and_360_s24_q ? census_columns_values_2_cell_1_mask_s24_q : census_columns_values_3_cell_1_mask_q;
  logic select_1209;
  assign select_1209 = and_360_s24_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_1212;
  assign select_1212 = and_360_s24_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:192
  logic [10:0] sum_1225;
  assign sum_1225 = sum_1221_s24_q + {1'b0, sum_1224_s24_q};
  // hls/stages/agreement.hpp:673
  logic [4:0] e;
  assign e = difference_1500_s24_q + (equal_1037_s24_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:711
  logic less_1514;
  assign less_1514 = region_row_s24_q < x_s24_q[5:3];
  // hls/stages/agreement.hpp:616
  logic [1:0] difference_1527;
  assign difference_1527 = 2'h0 - {1'b0, select_939_s24_q[2]};
  // hls/stages/agreement.hpp:620
  logic [9:0] select_1528;
  assign select_1528 = select_939_s24_q[1] ? {difference_1527, cfg_explained_limit_i} : 10'h0;
  // hls/stages/agreement.hpp:339
  logic [9:0] select_1531;
  assign select_1531 = equal_910_s24_q ? 10'h0 : (drew_s24_q ? (select_939_s24_q[0] ? select_1528 : 10'h0) : 10'h0);
  // hls/stages/registration.hpp:146
  logic less_1684;
  assign less_1684 = $signed(residual_s24_q) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1710;
  assign and_1710 = less_1693_s24_q & not_1701_s24_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1712;
  assign select_1712 = select_939_s24_q[2] ? (less_1569_s24_q ? {and_1710, not_1701_s24_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1715;
  assign select_1715 = equal_910_s24_q ? 2'h0 : (drew_s24_q ? (select_939_s24_q[0] ? select_1712 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:79
  logic and_1718;
  assign and_1718 = less_1571_s24_q & less_1684;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1720;
  assign select_1720 = select_939_s24_q[2] ? (less_1569_s24_q ? {and_1718, less_1571_s24_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:79
  logic and_1726;
  assign and_1726 = less_1571_s24_q & less_1693_s24_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1728;
  assign select_1728 = select_939_s24_q[2] ? (less_1569_s24_q ? {and_1726, less_1571_s24_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1731;
  assign select_1731 = equal_910_s24_q ? 2'h0 : (drew_s24_q ? (select_939_s24_q[0] ? select_1728 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:80
  logic not_1734;
  assign not_1734 = ~lower_half_s24_q;
  // hls/stages/agreement.hpp:186
  logic and_1735;
  assign and_1735 = less_1684 & not_1734;
  logic [1:0] select_1737;
  assign select_1737 = select_939_s24_q[2] ? (less_1569_s24_q ? {and_1735, not_1734} : 2'h0) : 2'h0;
  logic and_1743;
  assign and_1743 = less_1693_s24_q & not_1734;
  logic [1:0] select_1745;
  assign select_1745 = select_939_s24_q[2] ? (less_1569_s24_q ? {and_1743, not_1734} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1748;
  assign select_1748 = equal_910_s24_q ? 2'h0 : (drew_s24_q ? (select_939_s24_q[0] ? select_1745 : 2'h0) : 2'h0);
  // hls/stages/agreement.hpp:186
  logic and_1751;
  assign and_1751 = lower_half_s24_q & less_1684;
  logic [1:0] select_1753;
  assign select_1753 = select_939_s24_q[2] ? (less_1569_s24_q ? {and_1751, lower_half_s24_q} : 2'h0) : 2'h0;
  logic and_1759;
  assign and_1759 = lower_half_s24_q & less_1693_s24_q;
  logic [1:0] select_1761;
  assign select_1761 = select_939_s24_q[2] ? (less_1569_s24_q ? {and_1759, lower_half_s24_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1764;
  assign select_1764 = equal_910_s24_q ? 2'h0 : (drew_s24_q ? (select_939_s24_q[0] ? select_1761 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1799;
  assign sum_1799 = registration_counts_half_votes_1_up_q + {{13{select_1798_s24_q[1]}}, select_1798_s24_q};
  // hls/stages/agreement.hpp:186
  logic and_1809;
  assign and_1809 = less_1776_s24_q & not_1734;
  logic [1:0] select_1811;
  assign select_1811 = select_939_s24_q[2] ? (less_1569_s24_q ? {and_1809, not_1734} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1814;
  assign select_1814 = equal_910_s24_q ? 2'h0 : (drew_s24_q ? (select_939_s24_q[0] ? select_1811 : 2'h0) : 2'h0);
  // hls/stages/agreement.hpp:186
  logic and_1825;
  assign and_1825 = lower_half_s24_q & less_1776_s24_q;
  logic [1:0] select_1827;
  assign select_1827 = select_939_s24_q[2] ? (less_1569_s24_q ? {and_1825, lower_half_s24_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1830;
  assign select_1830 = equal_910_s24_q ? 2'h0 : (drew_s24_q ? (select_939_s24_q[0] ? select_1827 : 2'h0) : 2'h0);
  logic [4:0] select_1941;
  assign select_1941 = equal_910_s24_q ? box_textured_sum_sums_values_0_q : (drew_s24_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1953;
  assign select_1953 = equal_910_s24_q ? box_explained_sum_sums_values_0_q : (drew_s24_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1965;
  assign select_1965 = equal_910_s24_q ? box_shown_sum_sums_values_0_q : (drew_s24_q ? around : box_shown_sum_sums_values_0_q);
  logic [4:0] select_1977;
  assign select_1977 = equal_910_s24_q ? box_nearer_sum_sums_values_0_q : (drew_s24_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:827
  logic [3:0] select_2004;
  assign select_2004 = select_1001_s24_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:206
  logic [7:0] select_2010;
  assign select_2010 = marks_first_s24_q ? (less_2006 ? {sum_2007, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:103
  logic less_2062;
  assign less_2062 = 11'h4 < sum_2061_s24_q;
  // hls/stages/registration.hpp:104
  logic or_2068;
  assign or_2068 = (~less_2065_s24_q) | less_2067_s24_q;
  logic select_2074;
  assign select_2074 = less_2062 ? (or_2068 ? less_2067_s24_q : less_2072_s24_q) : less_2072_s24_q;
  logic or_2075;
  assign or_2075 = (~less_2070_s24_q) | select_2074;
  // hls/stages/registration.hpp:119
  logic less_2078;
  assign less_2078 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/agreement.hpp:722
  logic [11:0] select_2195;
  assign select_2195 = equal_962_s24_q ? 12'h0 : (less_1514 ? 12'h0 : regions_rdata_s24_q[35:24]);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_counts_half_votes_1_up_q <= 15'h0;
      began_q <= 1'b0;
      seen_x_q <= 4'h0;
      seen_y_q <= 4'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 13'h0;
    end else if (s24_en) begin
      registration_counts_half_votes_1_up_q <= and_1471_s24_q ? 15'h0 : sum_1799;
      began_q <= not_1014 & (began_q | select_1001_s24_q);
      seen_x_q <= select_1001_s24_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s24_q ? 4'h0 : select_2004;
      seen_column_q <= select_1001_s24_q ? 8'h0 : (seen_column_q + {7'h0, equal_1007});
      seen_rows_left_q <= select_2010;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s24_q ? 13'h0 : (seen_base_q + {6'h0, select_1004});
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
    box_textured_sum_sums_values_0_q = 5'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_shown_sum_sums_values_0_q = 5'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s24_en) begin
      averager_detail_0_q <= select_1142;
      averager_detail_1_q <= select_1150;
      census_columns_values_2_cell_2_mask_q <= select_1198;
      census_columns_values_2_cell_3_mask_q <= select_1201;
      census_columns_values_2_cell_4_mask_q <= select_1204;
      census_columns_values_3_cell_0_mask_q <= select_1205;
      census_columns_values_3_cell_1_mask_q <= select_1208;
      census_columns_values_3_cell_2_mask_q <= select_1209;
      census_columns_values_3_cell_3_mask_q <= select_1212;
      box_textured_sum_sums_values_0_q <= select_1941;
      box_explained_sum_sums_values_0_q <= select_1953;
      box_shown_sum_sums_values_0_q <= select_1965;
      box_nearer_sum_sums_values_0_q <= select_1977;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic census_columns_values_1_cell_2_of_skin_s25_q;
  logic census_columns_values_2_cell_4_mask_s25_q;
  logic census_columns_values_3_cell_0_mask_s25_q;
  logic census_columns_values_3_cell_1_mask_s25_q;
  logic census_columns_values_3_cell_2_mask_s25_q;
  logic census_columns_values_3_cell_3_mask_s25_q;
  logic [5:0] x_s25_q;
  logic lower_half_s25_q;
  logic [11:0] registration_counts_measured_0_s25_q;
  logic [11:0] registration_counts_measured_1_s25_q;
  logic [11:0] registration_counts_measured_2_s25_q;
  logic [11:0] registration_counts_measured_3_s25_q;
  logic [2:0] region_row_s25_q;
  logic centres_values_1_textured_s25_q;
  logic centres_values_1_of_skin_s25_q;
  logic [6:0] column_s25_q;
  logic and_360_s25_q;
  logic whole_2_s25_q;
  logic drew_s25_q;
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
  logic less_405_s25_q;
  logic less_406_s25_q;
  logic less_407_s25_q;
  logic less_408_s25_q;
  logic less_409_s25_q;
  logic less_410_s25_q;
  logic less_411_s25_q;
  logic less_412_s25_q;
  logic less_413_s25_q;
  logic less_414_s25_q;
  logic less_415_s25_q;
  logic and_423_s25_q;
  logic whole_16_s25_q;
  logic and_449_s25_q;
  logic [11:0] sum_464_s25_q;
  logic [9:0] sum_467_s25_q;
  logic [6:0] x_s25_2_q;
  logic [7:0] best_left_rdata_s25_q;
  logic equal_532_s25_q;
  logic select_828_s25_q;
  logic less_834_s25_q;
  logic less_835_s25_q;
  logic or_837_s25_q;
  logic [7:0] select_841_s25_q;
  logic [5:0] select_845_s25_q;
  logic equal_850_s25_q;
  logic rise_s25_q;
  logic [1:0] sum_862_s25_q;
  logic [7:0] twice_s25_q;
  logic difference_874_s25_q;
  logic [9:0] sum_877_s25_q;
  logic and_894_s25_q;
  logic equal_910_s25_q;
  logic not_911_s25_q;
  logic [2:0] select_939_s25_q;
  logic or_954_s25_q;
  logic or_957_s25_q;
  logic or_960_s25_q;
  logic equal_962_s25_q;
  logic [11:0] sum_976_s25_q;
  logic [11:0] sum_981_s25_q;
  logic [11:0] sum_987_s25_q;
  logic and_988_s25_q;
  logic not_1014_s25_q;
  logic [7:0] sum_1024_s25_q;
  logic [4:0] t_s25_q;
  logic or_1045_s25_q;
  logic or_1048_s25_q;
  logic or_1051_s25_q;
  logic [4:0] around_s25_q;
  logic less_1089_s25_q;
  logic and_1100_s25_q;
  logic [11:0] sum_1229_s25_q;
  logic [9:0] sum_1232_s25_q;
  logic equal_1240_s25_q;
  logic [27:0] select_1254_s25_q;
  logic [8:0] contrast_s25_q;
  logic [8:0] contrast_2_s25_q;
  logic equal_1292_s25_q;
  logic and_1471_s25_q;
  logic and_1474_s25_q;
  logic and_1478_s25_q;
  logic and_1482_s25_q;
  logic and_1486_s25_q;
  logic equal_1489_s25_q;
  logic [4:0] e_s25_q;
  logic [11:0] select_1515_s25_q;
  logic [11:0] select_1518_s25_q;
  logic [9:0] select_1531_s25_q;
  logic less_1569_s25_q;
  logic less_1571_s25_q;
  logic equal_1572_s25_q;
  logic equal_1573_s25_q;
  logic equal_1574_s25_q;
  logic [7:0] residual_s25_q;
  logic less_1684_s25_q;
  logic not_1701_s25_q;
  logic [1:0] select_1715_s25_q;
  logic [1:0] select_1721_s25_q;
  logic [1:0] select_1731_s25_q;
  logic not_1734_s25_q;
  logic [1:0] select_1738_s25_q;
  logic [1:0] select_1748_s25_q;
  logic [1:0] select_1754_s25_q;
  logic [1:0] select_1764_s25_q;
  logic [1:0] select_1814_s25_q;
  logic [1:0] select_1830_s25_q;
  logic less_1906_s25_q;
  logic equal_1987_s25_q;
  logic less_2062_s25_q;
  logic less_2065_s25_q;
  logic or_2068_s25_q;
  logic less_2070_s25_q;
  logic or_2075_s25_q;
  logic less_2076_s25_q;
  logic less_2078_s25_q;
  logic select_2079_s25_q;
  logic less_2088_s25_q;
  logic and_2187_s25_q;
  logic [11:0] select_2196_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= line_ended_q;
      census_columns_values_1_cell_2_of_skin_s25_q <= census_columns_values_1_cell_2_of_skin_s24_q;
      census_columns_values_2_cell_4_mask_s25_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s25_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s25_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s25_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s25_q <= census_columns_values_3_cell_3_mask_q;
      x_s25_q <= x_s24_q[5:0];
      lower_half_s25_q <= lower_half_s24_q;
      registration_counts_measured_0_s25_q <= registration_counts_measured_0_s24_q;
      registration_counts_measured_1_s25_q <= registration_counts_measured_1_s24_q;
      registration_counts_measured_2_s25_q <= registration_counts_measured_2_s24_q;
      registration_counts_measured_3_s25_q <= registration_counts_measured_3_s24_q;
      region_row_s25_q <= region_row_s24_q;
      centres_values_1_textured_s25_q <= centres_values_1_textured_s24_q;
      centres_values_1_of_skin_s25_q <= centres_values_1_of_skin_s24_q;
      column_s25_q <= column_s24_q;
      and_360_s25_q <= and_360_s24_q;
      whole_2_s25_q <= whole_2_s24_q;
      drew_s25_q <= drew_s24_q;
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
      less_405_s25_q <= less_405_s24_q;
      less_406_s25_q <= less_406_s24_q;
      less_407_s25_q <= less_407_s24_q;
      less_408_s25_q <= less_408_s24_q;
      less_409_s25_q <= less_409_s24_q;
      less_410_s25_q <= less_410_s24_q;
      less_411_s25_q <= less_411_s24_q;
      less_412_s25_q <= less_412_s24_q;
      less_413_s25_q <= less_413_s24_q;
      less_414_s25_q <= less_414_s24_q;
      less_415_s25_q <= less_415_s24_q;
      and_423_s25_q <= and_423_s24_q;
      whole_16_s25_q <= whole_16;
      and_449_s25_q <= census_columns_values_1_cell_2_mask_s24_q & and_423_s24_q;
      sum_464_s25_q <= {1'b0, sum_460} + {2'h0, sum_463_s24_q};
      sum_467_s25_q <= sum_467_s24_q;
      x_s25_2_q <= x_s24_2_q;
      best_left_rdata_s25_q <= best_left_rdata_s24_q;
      equal_532_s25_q <= equal_532_s24_q;
      select_828_s25_q <= select_828_s24_q;
      less_834_s25_q <= less_834_s24_q;
      less_835_s25_q <= less_835_s24_q;
      or_837_s25_q <= or_837_s24_q;
      select_841_s25_q <= select_841_s24_q;
      select_845_s25_q <= select_845_s24_q;
      equal_850_s25_q <= equal_850_s24_q;
      rise_s25_q <= rise_s24_q;
      sum_862_s25_q <= sum_862_s24_q;
      twice_s25_q <= twice_s24_q;
      difference_874_s25_q <= difference_874_s24_q[8];
      sum_877_s25_q <= sum_877;
      and_894_s25_q <= and_894_s24_q;
      equal_910_s25_q <= equal_910_s24_q;
      not_911_s25_q <= not_911_s24_q;
      select_939_s25_q <= select_939_s24_q;
      or_954_s25_q <= or_954_s24_q;
      or_957_s25_q <= or_957_s24_q;
      or_960_s25_q <= or_960_s24_q;
      equal_962_s25_q <= equal_962_s24_q;
      sum_976_s25_q <= sum_976;
      sum_981_s25_q <= sum_981;
      sum_987_s25_q <= sum_987;
      and_988_s25_q <= and_988_s24_q;
      not_1014_s25_q <= not_1014;
      sum_1024_s25_q <= {2'h0, x_s24_q[7:2]} + 8'hff;
      t_s25_q <= t;
      or_1045_s25_q <= or_1045_s24_q;
      or_1048_s25_q <= or_1048_s24_q;
      or_1051_s25_q <= or_1051_s24_q;
      around_s25_q <= around;
      less_1089_s25_q <= {1'b0, around[4:1]} < n;
      and_1100_s25_q <= and_1100_s24_q;
      sum_1229_s25_q <= {1'b0, sum_1225} + {2'h0, sum_1228_s24_q};
      sum_1232_s25_q <= sum_1232_s24_q;
      equal_1240_s25_q <= equal_1240_s24_q;
      select_1254_s25_q <= sample_pair_whole_s24_q ? {detail_2, detail} : 28'h0;
      contrast_s25_q <= contrast_s24_q;
      contrast_2_s25_q <= contrast_2_s24_q;
      equal_1292_s25_q <= equal_1292_s24_q;
      and_1471_s25_q <= and_1471_s24_q;
      and_1474_s25_q <= and_1474_s24_q;
      and_1478_s25_q <= and_1478_s24_q;
      and_1482_s25_q <= and_1482_s24_q;
      and_1486_s25_q <= and_1486_s24_q;
      equal_1489_s25_q <= x_s24_q[7:1] == 7'h0;
      e_s25_q <= e;
      select_1515_s25_q <= less_1514 ? 12'h0 : regions_rdata_s24_q[11:0];
      select_1518_s25_q <= less_1514 ? 12'h0 : regions_rdata_s24_q[23:12];
      select_1531_s25_q <= select_1531;
      less_1569_s25_q <= less_1569_s24_q;
      less_1571_s25_q <= less_1571_s24_q;
      equal_1572_s25_q <= equal_1572_s24_q;
      equal_1573_s25_q <= equal_1573_s24_q;
      equal_1574_s25_q <= equal_1574_s24_q;
      residual_s25_q <= residual_s24_q;
      less_1684_s25_q <= less_1684;
      not_1701_s25_q <= not_1701_s24_q;
      select_1715_s25_q <= select_1715;
      select_1721_s25_q <= select_939_s24_q[0] ? select_1720 : 2'h0;
      select_1731_s25_q <= select_1731;
      not_1734_s25_q <= not_1734;
      select_1738_s25_q <= select_939_s24_q[0] ? select_1737 : 2'h0;
      select_1748_s25_q <= select_1748;
      select_1754_s25_q <= select_939_s24_q[0] ? select_1753 : 2'h0;
      select_1764_s25_q <= select_1764;
      select_1814_s25_q <= select_1814;
      select_1830_s25_q <= select_1830;
      less_1906_s25_q <= less_1906_s24_q;
      equal_1987_s25_q <= equal_1987_s24_q;
      less_2062_s25_q <= less_2062;
      less_2065_s25_q <= less_2065_s24_q;
      or_2068_s25_q <= or_2068;
      less_2070_s25_q <= less_2070_s24_q;
      or_2075_s25_q <= or_2075;
      less_2076_s25_q <= less_2076_s24_q;
      less_2078_s25_q <= less_2078;
      select_2079_s25_q <= or_2075 ? select_2074 : less_2078;
      less_2088_s25_q <= less_2088_s24_q;
      and_2187_s25_q <= and_2187_s24_q;
      select_2196_s25_q <= equal_910_s24_q ? select_2195 : 12'h0;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_3_cell_4_mask_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic sharpness_last_mask_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_textured_q;
  logic [23:0] counts_too_little_explained_q;
  logic [14:0] registration_counts_votes_1_up_q;
  logic [14:0] registration_counts_votes_2_down_q;
  logic [14:0] registration_counts_votes_2_up_q;
  logic [14:0] registration_counts_votes_3_down_q;
  logic [14:0] registration_counts_votes_3_up_q;
  logic [14:0] registration_counts_votes_4_down_q;
  logic [14:0] registration_counts_votes_4_up_q;
  logic [14:0] registration_counts_half_votes_2_up_q;
  logic [14:0] registration_counts_half_votes_3_up_q;
  logic [7:0] hidden_for_q;
  logic [7:0] next_hidden_for_q;
  logic begins_product_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic said_q;
  // hls/stages/agreement.hpp:282
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s25_q & whole_16_s25_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s25_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s25_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s25_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s25_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:190
  logic [11:0] texture;
  assign texture = sum_464_s25_q + {2'h0, sum_467_s25_q};
  // hls/stages/registration.hpp:28
  logic not_878;
  assign not_878 = ~sum_877_s25_q[9];
  logic [7:0] xor_879;
  assign xor_879 = twice_s25_q ^ {8{not_878}};
  // hls/stages/agreement.hpp:831
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:802
  logic select_1012;
  assign select_1012 = marks_first_s25_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:788
  logic [10:0] sum_1013;
  assign sum_1013 = {1'b0, {5{select_1012}}, 1'b0, {2{select_1012}}, 1'b0, select_1012} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:692
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1024_s25_q[7]}}, sum_1024_s25_q, x_s25_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:788
  logic [10:0] sum_1026;
  assign sum_1026 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:679
  logic not_1052;
  assign not_1052 = ~region_row_s25_q[2];
  logic [2:0] select_1053;
  assign select_1053 = region_row_s25_q[1] ? {1'b0, not_1052, 1'b0} : {region_row_s25_q[2], 1'b0, not_1052};
  logic [5:0] select_1054;
  assign select_1054 = region_row_s25_q[0] ? {select_1053[2], 1'b0, select_1053[1], 1'b0, select_1053[0], 1'b0} : {1'b0, select_1053[2], 1'b0, select_1053[1], 1'b0, select_1053[0]};
  logic [11:0] select_1055;
  assign select_1055 = or_1051_s25_q ? {select_1054[5], 1'b0, select_1054[4], 1'b0, select_1054[3], 1'b0, select_1054[2], 1'b0, select_1054[1], 1'b0, select_1054[0], 1'b0} : {1'b0, select_1054[5], 1'b0, select_1054[4], 1'b0, select_1054[3], 1'b0, select_1054[2], 1'b0, select_1054[1], 1'b0, select_1054[0]};
  logic [23:0] select_1056;
  assign select_1056 = or_1048_s25_q ? {select_1055[11], 1'b0, select_1055[10], 1'b0, select_1055[9], 1'b0, select_1055[8], 1'b0, select_1055[7], 1'b0, select_1055[6], 1'b0, select_1055[5], 1'b0, select_1055[4], 1'b0, select_1055[3], 1'b0, select_1055[2], 1'b0, select_1055[1], 1'b0, select_1055[0], 1'b0} : {1'b0, select_1055[11], 1'b0, select_1055[10], 1'b0, select_1055[9], 1'b0, select_1055[8], 1'b0, select_1055[7], 1'b0, select_1055[6], 1'b0, select_1055[5], 1'b0, select_1055[4], 1'b0, select_1055[3], 1'b0, select_1055[2], 1'b0, select_1055[1], 1'b0, select_1055[0]};
  logic [47:0] select_1057;
  assign select_1057 = or_1045_s25_q ? {select_1056[23], 1'b0, select_1056[22], 1'b0, select_1056[21], 1'b0, select_1056[20], 1'b0, select_1056[19], 1'b0, select_1056[18], 1'b0, select_1056[17], 1'b0, select_1056[16], 1'b0, select_1056[15], 1'b0, select_1056[14], 1'b0, select_1056[13], 1'b0, select_1056[12], 1'b0, select_1056[11], 1'b0, select_1056[10], 1'b0, select_1056[9], 1'b0, select_1056[8], 1'b0, select_1056[7], 1'b0, select_1056[6], 1'b0, select_1056[5], 1'b0, select_1056[4], 1'b0, select_1056[3], 1'b0, select_1056[2], 1'b0, select_1056[1], 1'b0, select_1056[0], 1'b0} : {1'b0, select_1056[23], 1'b0, select_1056[22], 1'b0, select_1056[21], 1'b0, select_1056[20], 1'b0, select_1056[19], 1'b0, select_1056[18], 1'b0, select_1056[17], 1'b0, select_1056[16], 1'b0, select_1056[15], 1'b0, select_1056[14], 1'b0, select_1056[13], 1'b0, select_1056[12], 1'b0, select_1056[11], 1'b0, select_1056[10], 1'b0, select_1056[9], 1'b0, select_1056[8], 1'b0, select_1056[7], 1'b0, select_1056[6], 1'b0, select_1056[5], 1'b0, select_1056[4], 1'b0, select_1056[3], 1'b0, select_1056[2], 1'b0, select_1056[1], 1'b0, select_1056[0]};
  // hls/stages/agreement.hpp:681
  logic [5:0] sum_1073;
  assign sum_1073 = {1'b0, around_s25_q} + {2'h0, around_s25_q[4:1]};
  // hls/stages/agreement.hpp:205
  logic select_1213;
  assign select_1213 = and_360_s25_q ? census_columns_values_2_cell_4_mask_s25_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [11:0] sum_1233;
  assign sum_1233 = sum_1229_s25_q + {2'h0, sum_1232_s25_q};
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1235;
  assign select_1235 = and_360_s25_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1236;
  assign select_1236 = and_360_s25_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_1255;
  assign select_1255 = and_360_s25_q ? select_1254_s25_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_1256;
  assign select_1256 = and_360_s25_q ? select_1254_s25_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:275
  logic and_1259;
  assign and_1259 = whole_2_s25_q & (~(column_s25_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:283
  logic and_1265;
  assign and_1265 = and_1259 & (sharpness_last_mask_q & (7'h2 < contrast_s25_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1254_s25_q[13:0]};
  // hls/stages/agreement.hpp:283
  logic and_1276;
  assign and_1276 = and_1259 & (sharpness_last_mask_q & (7'h2 < contrast_2_s25_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1254_s25_q[27:14]};
  // hls/stages/agreement.hpp:533
  logic [13:0] select_1476;
  assign select_1476 = and_1471_s25_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1474_s25_q});
  logic [13:0] select_1480;
  assign select_1480 = and_1471_s25_q ? 14'h0 : (counts_textured_q + {13'h0, and_1478_s25_q});
  // hls/stages/agreement.hpp:680
  logic [5:0] sum_1503;
  assign sum_1503 = {1'b0, e_s25_q} + {2'h0, e_s25_q[4:1]};
  // hls/stages/agreement.hpp:528
  logic [23:0] sum_1532;
  assign sum_1532 = counts_too_little_explained_q + {{14{select_1531_s25_q[9]}}, select_1531_s25_q};
  // hls/stages/agreement.hpp:186
  logic and_1685;
  assign and_1685 = less_1569_s25_q & less_1684_s25_q;
  logic [1:0] select_1687;
  assign select_1687 = select_939_s25_q[0] ? (select_939_s25_q[2] ? {and_1685, less_1569_s25_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:79
  logic and_1702;
  assign and_1702 = less_1684_s25_q & not_1701_s25_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1704;
  assign select_1704 = select_939_s25_q[2] ? (less_1569_s25_q ? {and_1702, not_1701_s25_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1707;
  assign select_1707 = equal_910_s25_q ? 2'h0 : (drew_s25_q ? (select_939_s25_q[0] ? select_1704 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1716;
  assign sum_1716 = registration_counts_votes_1_up_q + {{13{select_1715_s25_q[1]}}, select_1715_s25_q};
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1723;
  assign select_1723 = equal_910_s25_q ? 2'h0 : (drew_s25_q ? select_1721_s25_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1724;
  assign sum_1724 = registration_counts_votes_2_down_q + {{13{select_1723[1]}}, select_1723};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1732;
  assign sum_1732 = registration_counts_votes_2_up_q + {{13{select_1731_s25_q[1]}}, select_1731_s25_q};
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1740;
  assign select_1740 = equal_910_s25_q ? 2'h0 : (drew_s25_q ? select_1738_s25_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1741;
  assign sum_1741 = registration_counts_votes_3_down_q + {{13{select_1740[1]}}, select_1740};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1749;
  assign sum_1749 = registration_counts_votes_3_up_q + {{13{select_1748_s25_q[1]}}, select_1748_s25_q};
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1756;
  assign select_1756 = equal_910_s25_q ? 2'h0 : (drew_s25_q ? select_1754_s25_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1757;
  assign sum_1757 = registration_counts_votes_4_down_q + {{13{select_1756[1]}}, select_1756};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1765;
  assign sum_1765 = registration_counts_votes_4_up_q + {{13{select_1764_s25_q[1]}}, select_1764_s25_q};
  // hls/stages/registration.hpp:146
  logic less_1767;
  assign less_1767 = $signed(residual_s25_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1768;
  assign and_1768 = not_1701_s25_q & less_1767;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1770;
  assign select_1770 = select_939_s25_q[2] ? (less_1569_s25_q ? {and_1768, not_1701_s25_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:79
  logic and_1785;
  assign and_1785 = less_1571_s25_q & less_1767;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1787;
  assign select_1787 = select_939_s25_q[2] ? (less_1569_s25_q ? {and_1785, less_1571_s25_q} : 2'h0) : 2'h0;
  logic and_1801;
  assign and_1801 = less_1767 & not_1734_s25_q;
  logic [1:0] select_1803;
  assign select_1803 = select_939_s25_q[2] ? (less_1569_s25_q ? {and_1801, not_1734_s25_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1815;
  assign sum_1815 = registration_counts_half_votes_2_up_q + {{13{select_1814_s25_q[1]}}, select_1814_s25_q};
  // hls/stages/agreement.hpp:186
  logic and_1817;
  assign and_1817 = lower_half_s25_q & less_1767;
  logic [1:0] select_1819;
  assign select_1819 = select_939_s25_q[2] ? (less_1569_s25_q ? {and_1817, lower_half_s25_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1831;
  assign sum_1831 = registration_counts_half_votes_3_up_q + {{13{select_1830_s25_q[1]}}, select_1830_s25_q};
  // hls/stages/agreement.hpp:722
  logic equal_1889;
  assign equal_1889 = x_s25_q == 6'h3f;
  // hls/stages/agreement.hpp:707
  logic and_1894;
  assign and_1894 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:714
  logic [12:0] sum_1898;
  assign sum_1898 = {1'b0, select_1518_s25_q} + {2'h0, select_1518_s25_q[11:1]};
  // hls/stages/agreement.hpp:724
  logic [7:0] select_1907;
  assign select_1907 = less_1906_s25_q ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1909;
  assign select_1909 = equal_910_s25_q ? (equal_1889 ? select_1907 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:149
  logic not_1910;
  assign not_1910 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:286
  logic [12:0] select_1990;
  assign select_1990 = equal_1292_s25_q ? (equal_1987_s25_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1993;
  assign select_1993 = and_360_s25_q ? (equal_1292_s25_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:339
  logic [13:0] select_2029;
  assign select_2029 = equal_910_s25_q ? (equal_1889 ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_2031;
  assign select_2031 = equal_910_s25_q ? (equal_1889 ? counts_textured_q : 14'h0) : 14'h0;
  // hls/stages/registration.hpp:104
  logic select_2081;
  assign select_2081 = less_2062_s25_q ? select_2079_s25_q : (less_2065_s25_q ? select_2079_s25_q : less_2078_s25_q);
  logic or_2082;
  assign or_2082 = (~less_2076_s25_q) | select_2081;
  // hls/stages/registration.hpp:119
  logic less_2083;
  assign less_2083 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_2084;
  assign select_2084 = or_2082 ? select_2081 : less_2083;
  // hls/stages/agreement.hpp:726
  logic and_2107;
  assign and_2107 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2108;
  assign or_2108 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2107;
  logic select_2109;
  assign select_2109 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2108 : and_2107;
  logic and_2159;
  assign and_2159 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1907 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:339
  logic [11:0] select_2172;
  assign select_2172 = equal_910_s25_q ? (equal_1889 ? registration_counts_measured_0_s25_q : 12'h0) : 12'h0;
  logic [11:0] select_2174;
  assign select_2174 = equal_910_s25_q ? (equal_1889 ? registration_counts_measured_1_s25_q : 12'h0) : 12'h0;
  logic [11:0] select_2176;
  assign select_2176 = equal_910_s25_q ? (equal_1889 ? registration_counts_measured_2_s25_q : 12'h0) : 12'h0;
  logic [11:0] select_2178;
  assign select_2178 = equal_910_s25_q ? (equal_1889 ? registration_counts_measured_3_s25_q : 12'h0) : 12'h0;

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s25_q, or_960_s25_q, or_957_s25_q, or_954_s25_q};
  logic regions_we;
  assign regions_we = s25_en & and_988_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_987_s25_q, sum_981_s25_q, sum_976_s25_q};
  end
`ifndef SYNTHESIS
  logic [5:0] regions_raddr_s23_sim;
  logic regions_re_s23_sim;
  logic [5:0] regions_raddr_s24_sim;
  logic regions_re_s24_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      regions_re_s23_sim <= 1'b0;
      regions_re_s24_sim <= 1'b0;
    end else if (en_i) begin
      regions_re_s23_sim <= regions_re;
      regions_raddr_s23_sim <= regions_raddr;
      regions_re_s24_sim <= regions_re_s23_sim;
      regions_raddr_s24_sim <= regions_raddr_s23_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s23_sim && regions_raddr_s23_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s24_sim && regions_raddr_s24_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_supervised_q <= 14'h0;
      counts_textured_q <= 14'h0;
      counts_too_little_explained_q <= 24'h0;
      registration_counts_votes_1_up_q <= 15'h0;
      registration_counts_votes_2_down_q <= 15'h0;
      registration_counts_votes_2_up_q <= 15'h0;
      registration_counts_votes_3_down_q <= 15'h0;
      registration_counts_votes_3_up_q <= 15'h0;
      registration_counts_votes_4_down_q <= 15'h0;
      registration_counts_votes_4_up_q <= 15'h0;
      registration_counts_half_votes_2_up_q <= 15'h0;
      registration_counts_half_votes_3_up_q <= 15'h0;
      hidden_for_q <= 8'h0;
      next_hidden_for_q <= 8'h0;
      begins_product_q <= 1'b0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s25_en) begin
      counts_supervised_q <= select_1476;
      counts_textured_q <= select_1480;
      counts_too_little_explained_q <= and_1471_s25_q ? 24'h0 : sum_1532;
      registration_counts_votes_1_up_q <= and_1471_s25_q ? 15'h0 : sum_1716;
      registration_counts_votes_2_down_q <= and_1471_s25_q ? 15'h0 : sum_1724;
      registration_counts_votes_2_up_q <= and_1471_s25_q ? 15'h0 : sum_1732;
      registration_counts_votes_3_down_q <= and_1471_s25_q ? 15'h0 : sum_1741;
      registration_counts_votes_3_up_q <= and_1471_s25_q ? 15'h0 : sum_1749;
      registration_counts_votes_4_down_q <= and_1471_s25_q ? 15'h0 : sum_1757;
      registration_counts_votes_4_up_q <= and_1471_s25_q ? 15'h0 : sum_1765;
      registration_counts_half_votes_2_up_q <= and_1471_s25_q ? 15'h0 : sum_1815;
      registration_counts_half_votes_3_up_q <= and_1471_s25_q ? 15'h0 : sum_1831;
      hidden_for_q <= select_1909;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1910};
      begins_product_q <= drew_s25_q;
      map_row_q <= and_360_s25_q ? select_1990 : map_row_q;
      map_width_q <= select_1993;
      write_half_q <= marks_first_s25_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1012;
      done_q <= not_1014_s25_q & ((~begins_product_q) & (done_q | said_q));
      said_q <= equal_910_s25_q & equal_1889;
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s25_en) begin
      census_columns_values_3_cell_4_mask_q <= select_1213;
      census_changes_values_0_left_q <= and_360_s25_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_360_s25_q ? sum_1233 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1235;
      census_changes_values_1_right_q <= select_1236;
      sharpness_last_mask_q <= and_360_s25_q ? whole_2_s25_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= select_1255;
      sharpness_last_detail_1_q <= select_1256;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic census_columns_values_1_cell_2_of_skin_s26_q;
  logic [11:0] census_changes_values_1_left_s26_q;
  logic [11:0] census_changes_values_1_right_s26_q;
  logic begins_product_s26_q;
  logic centres_values_1_textured_s26_q;
  logic centres_values_1_of_skin_s26_q;
  logic done_s26_q;
  logic [6:0] column_s26_q;
  logic and_360_s26_q;
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
  logic less_405_s26_q;
  logic less_406_s26_q;
  logic less_407_s26_q;
  logic less_408_s26_q;
  logic less_409_s26_q;
  logic less_410_s26_q;
  logic less_411_s26_q;
  logic less_412_s26_q;
  logic less_413_s26_q;
  logic less_414_s26_q;
  logic less_415_s26_q;
  logic and_423_s26_q;
  logic and_448_s26_q;
  logic and_449_s26_q;
  logic [12:0] sum_469_s26_q;
  logic [6:0] x_s26_q;
  logic [7:0] best_left_rdata_s26_q;
  logic equal_532_s26_q;
  logic select_828_s26_q;
  logic less_834_s26_q;
  logic less_835_s26_q;
  logic or_837_s26_q;
  logic [7:0] select_841_s26_q;
  logic [5:0] select_845_s26_q;
  logic equal_850_s26_q;
  logic rise_s26_q;
  logic [1:0] sum_862_s26_q;
  logic [7:0] twice_s26_q;
  logic difference_874_s26_q;
  logic sum_877_s26_q;
  logic [9:0] sum_880_s26_q;
  logic and_894_s26_q;
  logic equal_910_s26_q;
  logic not_911_s26_q;
  logic [2:0] select_939_s26_q;
  logic equal_962_s26_q;
  logic [2:0] index_s26_q;
  logic [10:0] sum_1013_s26_q;
  logic and_1020_s26_q;
  logic less_1021_s26_q;
  logic [2:0] index_2_s26_q;
  logic [10:0] sum_1026_s26_q;
  logic equal_1040_s26_q;
  logic [47:0] select_1057_s26_q;
  logic not_1075_s26_q;
  logic less_1089_s26_q;
  logic and_1100_s26_q;
  logic equal_1240_s26_q;
  logic [12:0] sum_1241_s26_q;
  logic [12:0] select_1267_s26_q;
  logic [12:0] select_1278_s26_q;
  logic [8:0] select_1283_s26_q;
  logic [8:0] select_1287_s26_q;
  logic and_1471_s26_q;
  logic and_1482_s26_q;
  logic and_1486_s26_q;
  logic equal_1489_s26_q;
  logic not_1505_s26_q;
  logic [11:0] select_1515_s26_q;
  logic [11:0] select_1518_s26_q;
  logic less_1569_s26_q;
  logic equal_1572_s26_q;
  logic equal_1573_s26_q;
  logic equal_1574_s26_q;
  logic [7:0] residual_s26_q;
  logic [1:0] select_1689_s26_q;
  logic [1:0] select_1707_s26_q;
  logic [1:0] select_1771_s26_q;
  logic [1:0] select_1788_s26_q;
  logic [1:0] select_1804_s26_q;
  logic [1:0] select_1820_s26_q;
  logic equal_1889_s26_q;
  logic equal_1890_s26_q;
  logic and_1894_s26_q;
  logic less_1895_s26_q;
  logic not_1900_s26_q;
  logic [13:0] select_2029_s26_q;
  logic [13:0] select_2031_s26_q;
  logic less_2062_s26_q;
  logic less_2065_s26_q;
  logic or_2068_s26_q;
  logic less_2070_s26_q;
  logic or_2075_s26_q;
  logic less_2076_s26_q;
  logic or_2082_s26_q;
  logic select_2084_s26_q;
  logic select_2085_s26_q;
  logic less_2088_s26_q;
  logic less_2091_s26_q;
  logic less_2099_s26_q;
  logic less_2100_s26_q;
  logic less_2101_s26_q;
  logic and_2102_s26_q;
  logic select_2109_s26_q;
  logic and_2161_s26_q;
  logic [11:0] select_2172_s26_q;
  logic [11:0] select_2174_s26_q;
  logic [11:0] select_2176_s26_q;
  logic [11:0] select_2178_s26_q;
  logic and_2187_s26_q;
  logic [5:0] select_2189_s26_q;
  logic [11:0] select_2196_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      census_columns_values_1_cell_2_of_skin_s26_q <= census_columns_values_1_cell_2_of_skin_s25_q;
      census_changes_values_1_left_s26_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s26_q <= census_changes_values_1_right_q;
      begins_product_s26_q <= begins_product_q;
      centres_values_1_textured_s26_q <= centres_values_1_textured_s25_q;
      centres_values_1_of_skin_s26_q <= centres_values_1_of_skin_s25_q;
      done_s26_q <= done_q;
      column_s26_q <= column_s25_q;
      and_360_s26_q <= and_360_s25_q;
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
      less_405_s26_q <= less_405_s25_q;
      less_406_s26_q <= less_406_s25_q;
      less_407_s26_q <= less_407_s25_q;
      less_408_s26_q <= less_408_s25_q;
      less_409_s26_q <= less_409_s25_q;
      less_410_s26_q <= less_410_s25_q;
      less_411_s26_q <= less_411_s25_q;
      less_412_s26_q <= less_412_s25_q;
      less_413_s26_q <= less_413_s25_q;
      less_414_s26_q <= less_414_s25_q;
      less_415_s26_q <= less_415_s25_q;
      and_423_s26_q <= and_423_s25_q;
      and_448_s26_q <= whole_22 & and_423_s25_q;
      and_449_s26_q <= and_449_s25_q;
      sum_469_s26_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      x_s26_q <= x_s25_2_q;
      best_left_rdata_s26_q <= best_left_rdata_s25_q;
      equal_532_s26_q <= equal_532_s25_q;
      select_828_s26_q <= select_828_s25_q;
      less_834_s26_q <= less_834_s25_q;
      less_835_s26_q <= less_835_s25_q;
      or_837_s26_q <= or_837_s25_q;
      select_841_s26_q <= select_841_s25_q;
      select_845_s26_q <= select_845_s25_q;
      equal_850_s26_q <= equal_850_s25_q;
      rise_s26_q <= rise_s25_q;
      sum_862_s26_q <= sum_862_s25_q;
      twice_s26_q <= twice_s25_q;
      difference_874_s26_q <= difference_874_s25_q;
      sum_877_s26_q <= sum_877_s25_q[9];
      sum_880_s26_q <= {sum_877_s25_q[8:0], not_878} + {not_878, xor_879, not_878};
      and_894_s26_q <= and_894_s25_q;
      equal_910_s26_q <= equal_910_s25_q;
      not_911_s26_q <= not_911_s25_q;
      select_939_s26_q <= select_939_s25_q;
      equal_962_s26_q <= equal_962_s25_q;
      index_s26_q <= index[2:0];
      sum_1013_s26_q <= sum_1013;
      and_1020_s26_q <= began_q & (seen_x_q == 4'h0);
      less_1021_s26_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s26_q <= index_2[2:0];
      sum_1026_s26_q <= sum_1026;
      equal_1040_s26_q <= t_s25_q[4:1] == 4'h0;
      select_1057_s26_q <= select_1057;
      not_1075_s26_q <= ~({sum_1073, around_s25_q[0]} < {2'h0, t_s25_q});
      less_1089_s26_q <= less_1089_s25_q;
      and_1100_s26_q <= and_1100_s25_q;
      equal_1240_s26_q <= equal_1240_s25_q;
      sum_1241_s26_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1233};
      select_1267_s26_q <= and_1265 ? detail_3[14:2] : 13'h0;
      select_1278_s26_q <= and_1276 ? detail_4[14:2] : 13'h0;
      select_1283_s26_q <= and_1265 ? contrast_s25_q : 9'h0;
      select_1287_s26_q <= and_1276 ? contrast_2_s25_q : 9'h0;
      and_1471_s26_q <= and_1471_s25_q;
      and_1482_s26_q <= and_1482_s25_q;
      and_1486_s26_q <= and_1486_s25_q;
      equal_1489_s26_q <= equal_1489_s25_q;
      not_1505_s26_q <= ~({sum_1503, e_s25_q[0]} < {2'h0, t_s25_q});
      select_1515_s26_q <= select_1515_s25_q;
      select_1518_s26_q <= select_1518_s25_q;
      less_1569_s26_q <= less_1569_s25_q;
      equal_1572_s26_q <= equal_1572_s25_q;
      equal_1573_s26_q <= equal_1573_s25_q;
      equal_1574_s26_q <= equal_1574_s25_q;
      residual_s26_q <= residual_s25_q;
      select_1689_s26_q <= equal_910_s25_q ? 2'h0 : (drew_s25_q ? select_1687 : 2'h0);
      select_1707_s26_q <= select_1707;
      select_1771_s26_q <= select_939_s25_q[0] ? select_1770 : 2'h0;
      select_1788_s26_q <= select_939_s25_q[0] ? select_1787 : 2'h0;
      select_1804_s26_q <= select_939_s25_q[0] ? select_1803 : 2'h0;
      select_1820_s26_q <= select_939_s25_q[0] ? select_1819 : 2'h0;
      equal_1889_s26_q <= equal_1889;
      equal_1890_s26_q <= select_1515_s25_q[11:3] == 9'h0;
      and_1894_s26_q <= and_1894;
      less_1895_s26_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      not_1900_s26_q <= ~({sum_1898, select_1518_s25_q[0]} < {2'h0, select_1515_s25_q});
      select_2029_s26_q <= select_2029;
      select_2031_s26_q <= select_2031;
      less_2062_s26_q <= less_2062_s25_q;
      less_2065_s26_q <= less_2065_s25_q;
      or_2068_s26_q <= or_2068_s25_q;
      less_2070_s26_q <= less_2070_s25_q;
      or_2075_s26_q <= or_2075_s25_q;
      less_2076_s26_q <= less_2076_s25_q;
      or_2082_s26_q <= or_2082;
      select_2084_s26_q <= select_2084;
      select_2085_s26_q <= less_2070_s25_q ? select_2084 : less_2083;
      less_2088_s26_q <= less_2088_s25_q;
      less_2091_s26_q <= $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
      less_2099_s26_q <= $signed(15'h0) < $signed(registration_counts_votes_2_up_q);
      less_2100_s26_q <= $signed(15'h0) < $signed(registration_counts_votes_1_up_q);
      less_2101_s26_q <= $signed(15'h0) < $signed(registration_counts_votes_2_down_q);
      and_2102_s26_q <= less_2076_s25_q & less_2088_s25_q;
      select_2109_s26_q <= select_2109;
      and_2161_s26_q <= equal_1889 & (cfg_prove_i & and_2159);
      select_2172_s26_q <= select_2172;
      select_2174_s26_q <= select_2174;
      select_2176_s26_q <= select_2176;
      select_2178_s26_q <= select_2178;
      and_2187_s26_q <= and_2187_s25_q;
      select_2189_s26_q <= equal_910_s25_q ? (equal_962_s25_q ? 6'h0 : x_s25_q) : 6'h0;
      select_2196_s26_q <= select_2196_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
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
  logic [47:0] good_next_q;
  logic [35:0] product_0_q;
  logic [35:0] product_1_q;
  logic [34:0] addend_0_q;
  logic [34:0] addend_1_q;
  logic [17:0] multiplier_0_q;
  logic [17:0] multiplier_1_q;
  // hls/stages/census.hpp:201
  logic [13:0] sum_470;
  assign sum_470 = {2'h0, census_changes_values_1_left_s26_q} + {1'b0, sum_469_s26_q};
  logic [13:0] sum_471;
  assign sum_471 = {2'h0, census_changes_values_2_left_q} + sum_470;
  // hls/stages/registration.hpp:28
  logic not_881;
  assign not_881 = ~sum_880_s26_q[9];
  logic [7:0] xor_882;
  assign xor_882 = twice_s26_q ^ {8{not_881}};
  logic [9:0] sum_883;
  assign sum_883 = {sum_880_s26_q[8:0], not_881} + {not_881, xor_882, not_881};
  logic not_884;
  assign not_884 = ~sum_883[9];
  // hls/stages/agreement.hpp:679
  logic not_1060;
  assign not_1060 = ~((good_q & select_1057_s26_q) == 48'h0);
  // hls/stages/agreement.hpp:681
  logic is_seen;
  assign is_seen = equal_1040_s26_q ? not_1060 : not_1075_s26_q;
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1237;
  assign select_1237 = and_360_s26_q ? census_changes_values_1_left_s26_q : census_changes_values_2_left_q;
  logic [11:0] select_1238;
  assign select_1238 = and_360_s26_q ? census_changes_values_1_right_s26_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [13:0] sum_1242;
  assign sum_1242 = {2'h0, census_changes_values_1_right_s26_q} + {1'b0, sum_1241_s26_q};
  logic [13:0] sum_1243;
  assign sum_1243 = {2'h0, census_changes_values_2_right_q} + sum_1242;
  // hls/stages/census.hpp:277
  logic [23:0] select_1269;
  assign select_1269 = equal_1240_s26_q ? {11'h0, select_1267_s26_q} : (sharpness_sums_detail_0_q + {11'h0, select_1267_s26_q});
  logic [23:0] select_1280;
  assign select_1280 = equal_1240_s26_q ? {11'h0, select_1278_s26_q} : (sharpness_sums_detail_1_q + {11'h0, select_1278_s26_q});
  logic [23:0] sum_1284;
  assign sum_1284 = (equal_1240_s26_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1283_s26_q};
  logic [23:0] sum_1288;
  assign sum_1288 = (equal_1240_s26_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1287_s26_q};
  // hls/stages/agreement.hpp:712
  logic [12:0] sum_1519;
  assign sum_1519 = {1'b0, select_1518_s26_q} + {3'h0, select_1518_s26_q[11:2]};
  // hls/stages/agreement.hpp:620
  logic [8:0] select_1542;
  assign select_1542 = select_939_s26_q[1] ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1690;
  assign sum_1690 = registration_counts_votes_0_down_q + {{13{select_1689_s26_q[1]}}, select_1689_s26_q};
  logic [14:0] sum_1708;
  assign sum_1708 = registration_counts_votes_1_down_q + {{13{select_1707_s26_q[1]}}, select_1707_s26_q};
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1773;
  assign select_1773 = equal_910_s26_q ? 2'h0 : (begins_product_q ? select_1771_s26_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1774;
  assign sum_1774 = registration_counts_half_votes_0_down_q + {{13{select_1773[1]}}, select_1773};
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1790;
  assign select_1790 = equal_910_s26_q ? 2'h0 : (begins_product_q ? select_1788_s26_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1791;
  assign sum_1791 = registration_counts_half_votes_1_down_q + {{13{select_1790[1]}}, select_1790};
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1806;
  assign select_1806 = equal_910_s26_q ? 2'h0 : (begins_product_q ? select_1804_s26_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1807;
  assign sum_1807 = registration_counts_half_votes_2_down_q + {{13{select_1806[1]}}, select_1806};
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1822;
  assign select_1822 = equal_910_s26_q ? 2'h0 : (begins_product_q ? select_1820_s26_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1823;
  assign sum_1823 = registration_counts_half_votes_3_down_q + {{13{select_1822[1]}}, select_1822};
  // hls/stages/agreement.hpp:714
  logic select_1901;
  assign select_1901 = equal_1890_s26_q ? (and_1894_s26_q & (~less_1895_s26_q)) : not_1900_s26_q;
  // hls/stages/agreement.hpp:722
  logic [47:0] select_1902;
  assign select_1902 = equal_962_s26_q ? good_next_q : {select_1901, good_next_q[47:1]};
  // hls/stages/agreement.hpp:339
  logic [47:0] select_1904;
  assign select_1904 = equal_910_s26_q ? (equal_1889_s26_q ? select_1902 : good_q) : good_q;
  // hls/stages/agreement.hpp:739
  logic [35:0] select_1921;
  assign select_1921 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:733
  logic [35:0] detail_left;
  assign detail_left = begins_product_s26_q ? 36'h0 : select_1921;
  // hls/stages/agreement.hpp:739
  logic [35:0] select_1924;
  assign select_1924 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:743
  logic [35:0] detail_right;
  assign detail_right = begins_product_s26_q ? 36'h0 : select_1924;
  // hls/stages/agreement.hpp:733
  logic [34:0] select_1926;
  assign select_1926 = begins_product_s26_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:743
  logic [34:0] select_1927;
  assign select_1927 = begins_product_s26_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:733
  logic [17:0] select_1928;
  assign select_1928 = begins_product_s26_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:743
  logic [17:0] select_1929;
  assign select_1929 = begins_product_s26_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:831
  logic and_2016;
  assign and_2016 = and_1100_s26_q & ({sum_1026_s26_q, index_2_s26_q} == {sum_1013_s26_q, index_s26_q});
  // hls/stages/registration.hpp:104
  logic select_2087;
  assign select_2087 = less_2062_s26_q ? select_2084_s26_q : (less_2065_s26_q ? select_2084_s26_q : select_2085_s26_q);
  logic or_2090;
  assign or_2090 = select_2087 | (~less_2088_s26_q);
  // hls/stages/registration.hpp:105
  logic select_2092;
  assign select_2092 = or_2090 ? select_2087 : less_2091_s26_q;
  // hls/stages/agreement.hpp:726
  logic and_2110;
  assign and_2110 = and_2102_s26_q & select_2109_s26_q;
  logic select_2112;
  assign select_2112 = less_2100_s26_q ? (less_2101_s26_q | and_2110) : and_2110;
  logic select_2114;
  assign select_2114 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? (less_2099_s26_q | select_2112) : select_2112;
  // hls/stages/registration.hpp:119
  logic less_2117;
  assign less_2117 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  logic less_2120;
  assign less_2120 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2123;
  assign less_2123 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2126;
  assign less_2126 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:339
  logic [23:0] select_2180;
  assign select_2180 = equal_910_s26_q ? (equal_1889_s26_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2182;
  assign select_2182 = equal_910_s26_q ? (equal_1889_s26_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [11:0] select_2193;
  assign select_2193 = equal_910_s26_q ? (equal_962_s26_q ? 12'h0 : select_1518_s26_q) : 12'h0;

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:911; read in stage 26, written in stage 27: 26 < 27 < 26 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1013_s26_q, index_s26_q};
  logic map_re;
  assign map_re = s26_en & (and_1020_s26_q & less_1021_s26_q);
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
      good_next_q <= 48'h0;
      product_0_q <= 36'h0;
      product_1_q <= 36'h0;
      addend_0_q <= 35'h0;
      addend_1_q <= 35'h0;
      multiplier_0_q <= 18'h0;
      multiplier_1_q <= 18'h0;
    end else if (s26_en) begin
      sharpness_sums_detail_0_q <= and_360_s26_q ? select_1269 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_360_s26_q ? select_1280 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_360_s26_q ? sum_1284 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_360_s26_q ? sum_1288 : sharpness_sums_contrast_1_q;
      registration_counts_votes_0_down_q <= and_1471_s26_q ? 15'h0 : sum_1690;
      registration_counts_votes_1_down_q <= and_1471_s26_q ? 15'h0 : sum_1708;
      registration_counts_half_votes_0_down_q <= and_1471_s26_q ? 15'h0 : sum_1774;
      registration_counts_half_votes_1_down_q <= and_1471_s26_q ? 15'h0 : sum_1791;
      registration_counts_half_votes_2_down_q <= and_1471_s26_q ? 15'h0 : sum_1807;
      registration_counts_half_votes_3_down_q <= and_1471_s26_q ? 15'h0 : sum_1823;
      good_q <= select_1904;
      good_next_q <= equal_910_s26_q ? select_1902 : good_next_q;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1926;
      addend_1_q <= select_1927;
      multiplier_0_q <= select_1928;
      multiplier_1_q <= select_1929;
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
    if (s26_en) begin
      census_changes_values_2_left_q <= select_1237;
      census_changes_values_2_right_q <= select_1238;
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
  logic centres_values_1_textured_s27_q;
  logic centres_values_1_of_skin_s27_q;
  logic done_s27_q;
  logic [6:0] column_s27_q;
  logic and_360_s27_q;
  logic drew_s27_q;
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
  logic less_405_s27_q;
  logic less_406_s27_q;
  logic less_407_s27_q;
  logic less_408_s27_q;
  logic less_409_s27_q;
  logic less_410_s27_q;
  logic less_411_s27_q;
  logic less_412_s27_q;
  logic less_413_s27_q;
  logic less_414_s27_q;
  logic less_415_s27_q;
  logic and_423_s27_q;
  logic and_448_s27_q;
  logic and_449_s27_q;
  logic [8:0] sum_471_s27_q;
  logic [6:0] x_s27_q;
  logic [7:0] best_left_rdata_s27_q;
  logic equal_532_s27_q;
  logic select_828_s27_q;
  logic less_834_s27_q;
  logic less_835_s27_q;
  logic or_837_s27_q;
  logic [7:0] select_841_s27_q;
  logic [5:0] select_845_s27_q;
  logic equal_850_s27_q;
  logic rise_s27_q;
  logic [1:0] sum_862_s27_q;
  logic difference_874_s27_q;
  logic sum_877_s27_q;
  logic sum_880_s27_q;
  logic [9:0] sum_883_s27_q;
  logic not_884_s27_q;
  logic [7:0] xor_885_s27_q;
  logic and_894_s27_q;
  logic equal_910_s27_q;
  logic not_911_s27_q;
  logic [2:0] select_939_s27_q;
  logic equal_962_s27_q;
  logic and_1020_s27_q;
  logic less_1021_s27_q;
  logic [2:0] index_2_s27_q;
  logic [10:0] sum_1026_s27_q;
  logic is_seen_s27_q;
  logic less_1089_s27_q;
  logic and_1100_s27_q;
  logic equal_1240_s27_q;
  logic [8:0] sum_1243_s27_q;
  logic and_1471_s27_q;
  logic and_1482_s27_q;
  logic and_1486_s27_q;
  logic equal_1489_s27_q;
  logic select_1506_s27_q;
  logic [11:0] select_1515_s27_q;
  logic less_1520_s27_q;
  logic [7:0] select_1543_s27_q;
  logic and_1544_s27_q;
  logic less_1569_s27_q;
  logic equal_1572_s27_q;
  logic equal_1573_s27_q;
  logic equal_1574_s27_q;
  logic [7:0] residual_s27_q;
  logic equal_1889_s27_q;
  logic and_1894_s27_q;
  logic less_1895_s27_q;
  logic and_2001_s27_q;
  logic and_2016_s27_q;
  logic [13:0] select_2029_s27_q;
  logic [13:0] select_2031_s27_q;
  logic less_2062_s27_q;
  logic less_2063_s27_q;
  logic less_2065_s27_q;
  logic or_2068_s27_q;
  logic less_2070_s27_q;
  logic or_2075_s27_q;
  logic less_2076_s27_q;
  logic or_2082_s27_q;
  logic less_2088_s27_q;
  logic or_2090_s27_q;
  logic select_2092_s27_q;
  logic select_2093_s27_q;
  logic select_2115_s27_q;
  logic less_2117_s27_q;
  logic less_2120_s27_q;
  logic less_2123_s27_q;
  logic less_2126_s27_q;
  logic and_2162_s27_q;
  logic [11:0] select_2172_s27_q;
  logic [11:0] select_2174_s27_q;
  logic [11:0] select_2176_s27_q;
  logic [11:0] select_2178_s27_q;
  logic [23:0] select_2180_s27_q;
  logic [23:0] select_2182_s27_q;
  logic and_2187_s27_q;
  logic [5:0] select_2189_s27_q;
  logic [11:0] select_2193_s27_q;
  logic [11:0] select_2196_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      census_columns_values_1_cell_2_of_skin_s27_q <= census_columns_values_1_cell_2_of_skin_s26_q;
      sharpness_sums_contrast_0_s27_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s27_q <= sharpness_sums_contrast_1_q;
      centres_values_1_textured_s27_q <= centres_values_1_textured_s26_q;
      centres_values_1_of_skin_s27_q <= centres_values_1_of_skin_s26_q;
      done_s27_q <= done_s26_q;
      column_s27_q <= column_s26_q;
      and_360_s27_q <= and_360_s26_q;
      drew_s27_q <= begins_product_q;
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
      less_405_s27_q <= less_405_s26_q;
      less_406_s27_q <= less_406_s26_q;
      less_407_s27_q <= less_407_s26_q;
      less_408_s27_q <= less_408_s26_q;
      less_409_s27_q <= less_409_s26_q;
      less_410_s27_q <= less_410_s26_q;
      less_411_s27_q <= less_411_s26_q;
      less_412_s27_q <= less_412_s26_q;
      less_413_s27_q <= less_413_s26_q;
      less_414_s27_q <= less_414_s26_q;
      less_415_s27_q <= less_415_s26_q;
      and_423_s27_q <= and_423_s26_q;
      and_448_s27_q <= and_448_s26_q;
      and_449_s27_q <= and_449_s26_q;
      sum_471_s27_q <= sum_471[13:5];
      x_s27_q <= x_s26_q;
      best_left_rdata_s27_q <= best_left_rdata_s26_q;
      equal_532_s27_q <= equal_532_s26_q;
      select_828_s27_q <= select_828_s26_q;
      less_834_s27_q <= less_834_s26_q;
      less_835_s27_q <= less_835_s26_q;
      or_837_s27_q <= or_837_s26_q;
      select_841_s27_q <= select_841_s26_q;
      select_845_s27_q <= select_845_s26_q;
      equal_850_s27_q <= equal_850_s26_q;
      rise_s27_q <= rise_s26_q;
      sum_862_s27_q <= sum_862_s26_q;
      difference_874_s27_q <= difference_874_s26_q;
      sum_877_s27_q <= sum_877_s26_q;
      sum_880_s27_q <= sum_880_s26_q[9];
      sum_883_s27_q <= sum_883;
      not_884_s27_q <= not_884;
      xor_885_s27_q <= twice_s26_q ^ {8{not_884}};
      and_894_s27_q <= and_894_s26_q;
      equal_910_s27_q <= equal_910_s26_q;
      not_911_s27_q <= not_911_s26_q;
      select_939_s27_q <= select_939_s26_q;
      equal_962_s27_q <= equal_962_s26_q;
      and_1020_s27_q <= and_1020_s26_q;
      less_1021_s27_q <= less_1021_s26_q;
      index_2_s27_q <= index_2_s26_q;
      sum_1026_s27_q <= sum_1026_s26_q;
      is_seen_s27_q <= is_seen;
      less_1089_s27_q <= less_1089_s26_q;
      and_1100_s27_q <= and_1100_s26_q;
      equal_1240_s27_q <= equal_1240_s26_q;
      sum_1243_s27_q <= sum_1243[13:5];
      and_1471_s27_q <= and_1471_s26_q;
      and_1482_s27_q <= and_1482_s26_q;
      and_1486_s27_q <= and_1486_s26_q;
      equal_1489_s27_q <= equal_1489_s26_q;
      select_1506_s27_q <= equal_1040_s26_q ? not_1060 : not_1505_s26_q;
      select_1515_s27_q <= select_1515_s26_q;
      less_1520_s27_q <= {sum_1519, select_1518_s26_q[1:0]} < {3'h0, select_1515_s26_q};
      select_1543_s27_q <= select_939_s26_q[0] ? select_1542[7:0] : 8'h0;
      and_1544_s27_q <= select_939_s26_q[0] & select_1542[8];
      less_1569_s27_q <= less_1569_s26_q;
      equal_1572_s27_q <= equal_1572_s26_q;
      equal_1573_s27_q <= equal_1573_s26_q;
      equal_1574_s27_q <= equal_1574_s26_q;
      residual_s27_q <= residual_s26_q;
      equal_1889_s27_q <= equal_1889_s26_q;
      and_1894_s27_q <= and_1894_s26_q;
      less_1895_s27_q <= less_1895_s26_q;
      and_2001_s27_q <= said_q;
      and_2016_s27_q <= and_2016;
      select_2029_s27_q <= select_2029_s26_q;
      select_2031_s27_q <= select_2031_s26_q;
      less_2062_s27_q <= less_2062_s26_q;
      less_2063_s27_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2065_s27_q <= less_2065_s26_q;
      or_2068_s27_q <= or_2068_s26_q;
      less_2070_s27_q <= less_2070_s26_q;
      or_2075_s27_q <= or_2075_s26_q;
      less_2076_s27_q <= less_2076_s26_q;
      or_2082_s27_q <= or_2082_s26_q;
      less_2088_s27_q <= less_2088_s26_q;
      or_2090_s27_q <= or_2090;
      select_2092_s27_q <= select_2092;
      select_2093_s27_q <= less_2076_s26_q ? select_2092 : less_2091_s26_q;
      select_2115_s27_q <= (less_2065_s26_q & less_2070_s26_q) ? select_2114 : and_2110;
      less_2117_s27_q <= less_2117;
      less_2120_s27_q <= less_2120;
      less_2123_s27_q <= less_2123;
      less_2126_s27_q <= less_2126;
      and_2162_s27_q <= equal_910_s26_q & and_2161_s26_q;
      select_2172_s27_q <= select_2172_s26_q;
      select_2174_s27_q <= select_2174_s26_q;
      select_2176_s27_q <= select_2176_s26_q;
      select_2178_s27_q <= select_2178_s26_q;
      select_2180_s27_q <= select_2180;
      select_2182_s27_q <= select_2182;
      and_2187_s27_q <= and_2187_s26_q;
      select_2189_s27_q <= select_2189_s26_q;
      select_2193_s27_q <= select_2193;
      select_2196_s27_q <= select_2196_s26_q;
    end
  end

  // Stage 27 ----------------------------------------------------------------------------------------------------------
  logic proven_q;
  // hls/stages/registration.hpp:28
  logic [9:0] sum_886;
  assign sum_886 = {sum_883_s27_q[8:0], not_884_s27_q} + {not_884_s27_q, xor_885_s27_q, not_884_s27_q};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_887;
  assign difference_887 = {sum_862_s27_q, select_828_s27_q, 5'h0} - {3'h0, difference_874_s27_q, sum_877_s27_q, sum_880_s27_q, sum_883_s27_q[9], sum_886[9]};
  // hls/stages/agreement.hpp:693
  logic and_1090;
  assign and_1090 = is_seen_s27_q & less_1089_s27_q;
  // hls/stages/agreement.hpp:685
  logic not_1507;
  assign not_1507 = ~select_1506_s27_q;
  // hls/stages/agreement.hpp:691
  logic and_1509;
  assign and_1509 = (~equal_1489_s27_q) & (centres_values_1_textured_s27_q & not_1507);
  // hls/stages/agreement.hpp:720
  logic [11:0] select_1522;
  assign select_1522 = ((~(select_1515_s27_q[11:4] == 8'h0)) & less_1520_s27_q) ? select_1515_s27_q : 12'h0;
  // hls/stages/agreement.hpp:620
  logic [8:0] select_1535;
  assign select_1535 = select_939_s27_q[1] ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:688
  logic [2:0] select_1546;
  assign select_1546 = select_1506_s27_q ? {3{and_1544_s27_q}} : ({3{and_1544_s27_q}} + 3'h1);
  // hls/stages/agreement.hpp:691
  logic [2:0] select_1547;
  assign select_1547 = centres_values_1_textured_s27_q ? select_1546 : {3{and_1544_s27_q}};
  logic [9:0] select_1554;
  assign select_1554 = centres_values_1_of_skin_s27_q ? ({1'b0, not_1507, 8'h0} - {2'h0, cfg_unproven_skin_limit_i}) : 10'h0;
  logic [9:0] select_1556;
  assign select_1556 = equal_1489_s27_q ? 10'h0 : (centres_values_1_textured_s27_q ? select_1554 : 10'h0);
  // hls/stages/agreement.hpp:339
  logic and_2043;
  assign and_2043 = equal_910_s27_q & (equal_1889_s27_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/registration.hpp:105
  logic select_2095;
  assign select_2095 = less_2065_s27_q ? select_2092_s27_q : (less_2070_s27_q ? select_2092_s27_q : select_2093_s27_q);
  // hls/stages/agreement.hpp:726
  logic or_2116;
  assign or_2116 = (less_2062_s27_q ? select_2092_s27_q : select_2095) | select_2115_s27_q;
  // hls/stages/agreement.hpp:339
  logic [11:0] select_2191;
  assign select_2191 = equal_910_s27_q ? (equal_962_s27_q ? 12'h0 : select_1515_s27_q) : 12'h0;

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1026_s27_q, index_2_s27_q};
  logic map_we;
  assign map_we = s27_en & and_1100_s27_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1090, is_seen_s27_q};
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
    end else if (s27_en) begin
      proven_q <= marks_first_s27_q ? done_s27_q : proven_q;
    end
  end

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic census_columns_values_1_cell_2_of_skin_s28_q;
  logic [23:0] sharpness_sums_contrast_0_s28_q;
  logic [23:0] sharpness_sums_contrast_1_s28_q;
  logic [6:0] column_s28_q;
  logic and_360_s28_q;
  logic drew_s28_q;
  logic less_392_s28_q;
  logic less_393_s28_q;
  logic less_394_s28_q;
  logic less_395_s28_q;
  logic less_396_s28_q;
  logic less_397_s28_q;
  logic less_398_s28_q;
  logic less_399_s28_q;
  logic less_400_s28_q;
  logic less_401_s28_q;
  logic less_402_s28_q;
  logic less_403_s28_q;
  logic less_404_s28_q;
  logic less_405_s28_q;
  logic less_406_s28_q;
  logic less_407_s28_q;
  logic less_408_s28_q;
  logic less_409_s28_q;
  logic less_410_s28_q;
  logic less_411_s28_q;
  logic less_412_s28_q;
  logic less_413_s28_q;
  logic less_414_s28_q;
  logic less_415_s28_q;
  logic and_423_s28_q;
  logic and_448_s28_q;
  logic and_449_s28_q;
  logic less_472_s28_q;
  logic [6:0] x_s28_q;
  logic [7:0] best_left_rdata_s28_q;
  logic equal_532_s28_q;
  logic select_828_s28_q;
  logic less_834_s28_q;
  logic less_835_s28_q;
  logic or_837_s28_q;
  logic [7:0] select_841_s28_q;
  logic [5:0] select_845_s28_q;
  logic equal_850_s28_q;
  logic rise_s28_q;
  logic [1:0] sum_862_s28_q;
  logic difference_874_s28_q;
  logic sum_877_s28_q;
  logic sum_880_s28_q;
  logic sum_883_s28_q;
  logic sum_886_s28_q;
  logic [7:0] difference_887_s28_q;
  logic and_894_s28_q;
  logic equal_910_s28_q;
  logic [1:0] select_939_s28_q;
  logic and_1020_s28_q;
  logic less_1021_s28_q;
  logic [1:0] map_rdata_s28_q;
  logic is_seen_s28_q;
  logic and_1090_s28_q;
  logic equal_1240_s28_q;
  logic and_1245_s28_q;
  logic and_1471_s28_q;
  logic and_1482_s28_q;
  logic and_1486_s28_q;
  logic and_1511_s28_q;
  logic [11:0] select_1523_s28_q;
  logic [8:0] select_1537_s28_q;
  logic [7:0] select_1543_s28_q;
  logic [2:0] select_1548_s28_q;
  logic [9:0] select_1557_s28_q;
  logic less_1569_s28_q;
  logic equal_1572_s28_q;
  logic equal_1573_s28_q;
  logic equal_1574_s28_q;
  logic [7:0] residual_s28_q;
  logic equal_1889_s28_q;
  logic and_1894_s28_q;
  logic less_1895_s28_q;
  logic [35:0] detail_left_s28_q;
  logic [35:0] detail_right_s28_q;
  logic and_2001_s28_q;
  logic and_2016_s28_q;
  logic [13:0] select_2029_s28_q;
  logic [13:0] select_2031_s28_q;
  logic and_2043_s28_q;
  logic less_2062_s28_q;
  logic less_2063_s28_q;
  logic less_2065_s28_q;
  logic or_2068_s28_q;
  logic less_2070_s28_q;
  logic or_2075_s28_q;
  logic less_2076_s28_q;
  logic or_2082_s28_q;
  logic less_2088_s28_q;
  logic or_2090_s28_q;
  logic select_2115_s28_q;
  logic or_2116_s28_q;
  logic or_2118_s28_q;
  logic less_2120_s28_q;
  logic less_2123_s28_q;
  logic less_2126_s28_q;
  logic [36:0] sum_2139_s28_q;
  logic [36:0] sum_2148_s28_q;
  logic and_2162_s28_q;
  logic [11:0] select_2172_s28_q;
  logic [11:0] select_2174_s28_q;
  logic [11:0] select_2176_s28_q;
  logic [11:0] select_2178_s28_q;
  logic [23:0] select_2180_s28_q;
  logic [23:0] select_2182_s28_q;
  logic and_2187_s28_q;
  logic [5:0] select_2189_s28_q;
  logic [11:0] select_2191_s28_q;
  logic [11:0] select_2193_s28_q;
  logic [11:0] select_2196_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      census_columns_values_1_cell_2_of_skin_s28_q <= census_columns_values_1_cell_2_of_skin_s27_q;
      sharpness_sums_contrast_0_s28_q <= sharpness_sums_contrast_0_s27_q;
      sharpness_sums_contrast_1_s28_q <= sharpness_sums_contrast_1_s27_q;
      column_s28_q <= column_s27_q;
      and_360_s28_q <= and_360_s27_q;
      drew_s28_q <= drew_s27_q;
      less_392_s28_q <= less_392_s27_q;
      less_393_s28_q <= less_393_s27_q;
      less_394_s28_q <= less_394_s27_q;
      less_395_s28_q <= less_395_s27_q;
      less_396_s28_q <= less_396_s27_q;
      less_397_s28_q <= less_397_s27_q;
      less_398_s28_q <= less_398_s27_q;
      less_399_s28_q <= less_399_s27_q;
      less_400_s28_q <= less_400_s27_q;
      less_401_s28_q <= less_401_s27_q;
      less_402_s28_q <= less_402_s27_q;
      less_403_s28_q <= less_403_s27_q;
      less_404_s28_q <= less_404_s27_q;
      less_405_s28_q <= less_405_s27_q;
      less_406_s28_q <= less_406_s27_q;
      less_407_s28_q <= less_407_s27_q;
      less_408_s28_q <= less_408_s27_q;
      less_409_s28_q <= less_409_s27_q;
      less_410_s28_q <= less_410_s27_q;
      less_411_s28_q <= less_411_s27_q;
      less_412_s28_q <= less_412_s27_q;
      less_413_s28_q <= less_413_s27_q;
      less_414_s28_q <= less_414_s27_q;
      less_415_s28_q <= less_415_s27_q;
      and_423_s28_q <= and_423_s27_q;
      and_448_s28_q <= and_448_s27_q;
      and_449_s28_q <= and_449_s27_q;
      less_472_s28_q <= 9'h4 < sum_471_s27_q;
      x_s28_q <= x_s27_q;
      best_left_rdata_s28_q <= best_left_rdata_s27_q;
      equal_532_s28_q <= equal_532_s27_q;
      select_828_s28_q <= select_828_s27_q;
      less_834_s28_q <= less_834_s27_q;
      less_835_s28_q <= less_835_s27_q;
      or_837_s28_q <= or_837_s27_q;
      select_841_s28_q <= select_841_s27_q;
      select_845_s28_q <= select_845_s27_q;
      equal_850_s28_q <= equal_850_s27_q;
      rise_s28_q <= rise_s27_q;
      sum_862_s28_q <= sum_862_s27_q;
      difference_874_s28_q <= difference_874_s27_q;
      sum_877_s28_q <= sum_877_s27_q;
      sum_880_s28_q <= sum_880_s27_q;
      sum_883_s28_q <= sum_883_s27_q[9];
      sum_886_s28_q <= sum_886[9];
      difference_887_s28_q <= difference_887;
      and_894_s28_q <= and_894_s27_q;
      equal_910_s28_q <= equal_910_s27_q;
      select_939_s28_q <= {select_939_s27_q[2], select_939_s27_q[0]};
      and_1020_s28_q <= and_1020_s27_q;
      less_1021_s28_q <= less_1021_s27_q;
      map_rdata_s28_q <= map_rdata_q;
      is_seen_s28_q <= is_seen_s27_q;
      and_1090_s28_q <= and_1090;
      equal_1240_s28_q <= equal_1240_s27_q;
      and_1245_s28_q <= and_448_s27_q & (9'h4 < sum_1243_s27_q);
      and_1471_s28_q <= and_1471_s27_q;
      and_1482_s28_q <= and_1482_s27_q;
      and_1486_s28_q <= and_1486_s27_q;
      and_1511_s28_q <= not_911_s27_q & (drew_s27_q & and_1509);
      select_1523_s28_q <= equal_962_s27_q ? 12'h0 : select_1522;
      select_1537_s28_q <= drew_s27_q ? (select_939_s27_q[0] ? select_1535 : 9'h0) : 9'h0;
      select_1543_s28_q <= select_1543_s27_q;
      select_1548_s28_q <= equal_1489_s27_q ? {3{and_1544_s27_q}} : select_1547;
      select_1557_s28_q <= drew_s27_q ? select_1556 : 10'h0;
      less_1569_s28_q <= less_1569_s27_q;
      equal_1572_s28_q <= equal_1572_s27_q;
      equal_1573_s28_q <= equal_1573_s27_q;
      equal_1574_s28_q <= equal_1574_s27_q;
      residual_s28_q <= residual_s27_q;
      equal_1889_s28_q <= equal_1889_s27_q;
      and_1894_s28_q <= and_1894_s27_q;
      less_1895_s28_q <= less_1895_s27_q;
      detail_left_s28_q <= product_0_q;
      detail_right_s28_q <= product_1_q;
      and_2001_s28_q <= and_2001_s27_q;
      and_2016_s28_q <= and_2016_s27_q;
      select_2029_s28_q <= select_2029_s27_q;
      select_2031_s28_q <= select_2031_s27_q;
      and_2043_s28_q <= and_2043;
      less_2062_s28_q <= less_2062_s27_q;
      less_2063_s28_q <= less_2063_s27_q;
      less_2065_s28_q <= less_2065_s27_q;
      or_2068_s28_q <= or_2068_s27_q;
      less_2070_s28_q <= less_2070_s27_q;
      or_2075_s28_q <= or_2075_s27_q;
      less_2076_s28_q <= less_2076_s27_q;
      or_2082_s28_q <= or_2082_s27_q;
      less_2088_s28_q <= less_2088_s27_q;
      or_2090_s28_q <= or_2090_s27_q;
      select_2115_s28_q <= select_2115_s27_q;
      or_2116_s28_q <= or_2116;
      or_2118_s28_q <= less_2117_s27_q | or_2116;
      less_2120_s28_q <= less_2120_s27_q;
      less_2123_s28_q <= less_2123_s27_q;
      less_2126_s28_q <= less_2126_s27_q;
      sum_2139_s28_q <= {1'b0, product_1_q} + {3'h0, product_1_q[35:2]};
      sum_2148_s28_q <= {1'b0, product_0_q} + {3'h0, product_0_q[35:2]};
      and_2162_s28_q <= and_2162_s27_q;
      select_2172_s28_q <= select_2172_s27_q;
      select_2174_s28_q <= select_2174_s27_q;
      select_2176_s28_q <= select_2176_s27_q;
      select_2178_s28_q <= select_2178_s27_q;
      select_2180_s28_q <= select_2180_s27_q;
      select_2182_s28_q <= select_2182_s27_q;
      and_2187_s28_q <= and_2187_s27_q;
      select_2189_s28_q <= select_2189_s27_q;
      select_2191_s28_q <= select_2191;
      select_2193_s28_q <= select_2193_s27_q;
      select_2196_s28_q <= select_2196_s27_q;
    end
  end

  // Stage 28 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [23:0] counts_too_many_bad_q;
  logic [23:0] counts_too_much_unproven_q;
  logic [23:0] counts_too_much_unseen_skin_q;
  // hls/stages/census.hpp:223
  logic and_473;
  assign and_473 = and_423_s28_q & less_472_s28_q;
  // hls/stages/agreement.hpp:471
  logic [7:0] select_888;
  assign select_888 = rise_s28_q ? difference_887_s28_q : {sum_862_s28_q, select_828_s28_q, difference_874_s28_q, sum_877_s28_q, sum_880_s28_q, sum_883_s28_q, sum_886_s28_q};
  logic [7:0] select_889;
  assign select_889 = equal_850_s28_q ? select_888 : {sum_862_s28_q, select_828_s28_q, 5'h0};
  // hls/stages/agreement.hpp:473
  logic [7:0] select_892;
  assign select_892 = less_834_s28_q ? (or_837_s28_q ? select_889 : best_left_rdata_s28_q) : (less_835_s28_q ? select_889 : best_left_rdata_s28_q);
  // hls/stages/census.hpp:226
  logic and_1246;
  assign and_1246 = and_448_s28_q & less_472_s28_q;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1247;
  assign sum_1247 = census_left_misses_q + {{17{and_1246}}, and_1245_s28_q, 1'b0, and_1245_s28_q};
  // hls/stages/agreement.hpp:205
  logic [19:0] select_1249;
  assign select_1249 = and_360_s28_q ? (equal_1240_s28_q ? 20'h0 : sum_1247) : census_left_misses_q;
  // hls/stages/agreement.hpp:339
  logic [20:0] select_1538;
  assign select_1538 = equal_910_s28_q ? {1'b0, select_1523_s28_q, 8'h0} : {{12{select_1537_s28_q[8]}}, select_1537_s28_q};
  // hls/stages/agreement.hpp:533
  logic [23:0] select_1540;
  assign select_1540 = and_1471_s28_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1538[20]}}, select_1538});
  // hls/stages/agreement.hpp:339
  logic [10:0] select_1550;
  assign select_1550 = equal_910_s28_q ? 11'h0 : (drew_s28_q ? {select_1548_s28_q, select_1543_s28_q} : 11'h0);
  // hls/stages/agreement.hpp:530
  logic [23:0] sum_1551;
  assign sum_1551 = counts_too_much_unproven_q + {{13{select_1550[10]}}, select_1550};
  // hls/stages/agreement.hpp:339
  logic [9:0] select_1558;
  assign select_1558 = equal_910_s28_q ? 10'h0 : select_1557_s28_q;
  // hls/stages/agreement.hpp:531
  logic [23:0] sum_1559;
  assign sum_1559 = counts_too_much_unseen_skin_q + {{14{select_1558[9]}}, select_1558};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1612;
  assign select_1612 = equal_1573_s28_q ? 8'h0 : (equal_1574_s28_q ? 8'h0 : residual_s28_q);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1615;
  assign select_1615 = select_939_s28_q[1] ? (less_1569_s28_q ? (equal_1572_s28_q ? 8'h0 : select_1612) : 8'h0) : 8'h0;
  // hls/stages/registration.hpp:80
  logic [7:0] select_1622;
  assign select_1622 = equal_1573_s28_q ? 8'h0 : (equal_1574_s28_q ? residual_s28_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1625;
  assign select_1625 = select_939_s28_q[1] ? (less_1569_s28_q ? (equal_1572_s28_q ? 8'h0 : select_1622) : 8'h0) : 8'h0;
  // hls/stages/registration.hpp:80
  logic [7:0] select_1632;
  assign select_1632 = equal_1572_s28_q ? 8'h0 : (equal_1573_s28_q ? residual_s28_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1634;
  assign select_1634 = select_939_s28_q[1] ? (less_1569_s28_q ? select_1632 : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1637;
  assign select_1637 = equal_910_s28_q ? 8'h0 : (drew_s28_q ? (select_939_s28_q[0] ? select_1634 : 8'h0) : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1641;
  assign select_1641 = less_1569_s28_q ? (equal_1572_s28_q ? residual_s28_q : 8'h0) : 8'h0;
  logic [7:0] select_1643;
  assign select_1643 = select_939_s28_q[0] ? (select_939_s28_q[1] ? select_1641 : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:831
  logic [1:0] select_2017;
  assign select_2017 = and_2016_s28_q ? {and_1090_s28_q, is_seen_s28_q} : map_rdata_s28_q;
  // hls/stages/agreement.hpp:832
  logic and_2018;
  assign and_2018 = proven_q & less_2006;
  // hls/stages/agreement.hpp:726
  logic or_2054;
  assign or_2054 = ($signed(24'h0) < $signed(counts_too_much_unproven_q)) | ($signed(24'h0) < $signed(counts_too_much_unseen_skin_q));
  logic select_2119;
  assign select_2119 = or_2090_s28_q ? or_2116_s28_q : or_2118_s28_q;
  logic or_2121;
  assign or_2121 = less_2120_s28_q | select_2119;
  logic select_2122;
  assign select_2122 = or_2082_s28_q ? select_2119 : or_2121;
  logic or_2124;
  assign or_2124 = less_2123_s28_q | select_2122;
  logic select_2125;
  assign select_2125 = or_2075_s28_q ? select_2122 : or_2124;
  logic select_2131;
  assign select_2131 = less_2076_s28_q ? or_2121 : (less_2088_s28_q ? or_2118_s28_q : select_2115_s28_q);
  // hls/stages/agreement.hpp:767
  logic and_2138;
  assign and_2138 = cfg_prove_i & and_1894_s28_q;
  // hls/stages/agreement.hpp:768
  logic less_2140;
  assign less_2140 = {detail_left_s28_q, 3'h0} < {sum_2139_s28_q, detail_right_s28_q[1:0]};
  logic less_2141;
  assign less_2141 = {sharpness_sums_contrast_0_s28_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_s28_q};
  // hls/stages/agreement.hpp:726
  logic or_2144;
  assign or_2144 = less_2140 | (less_2141 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:771
  logic less_2149;
  assign less_2149 = {detail_right_s28_q, 3'h0} < {sum_2148_s28_q, detail_left_s28_q[1:0]};
  logic less_2150;
  assign less_2150 = {sharpness_sums_contrast_1_s28_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_s28_q};
  // hls/stages/agreement.hpp:339
  logic [23:0] select_2184;
  assign select_2184 = equal_910_s28_q ? (equal_1889_s28_q ? sharpness_sums_contrast_0_s28_q : 24'h0) : 24'h0;
  logic [23:0] select_2186;
  assign select_2186 = equal_910_s28_q ? (equal_1889_s28_q ? sharpness_sums_contrast_1_s28_q : 24'h0) : 24'h0;

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s28_q;
  logic fresh_we;
  assign fresh_we = s28_en & and_360_s28_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s28_q, and_473, and_449_s28_q, and_448_s28_q, and_423_s28_q, less_415_s28_q, less_414_s28_q, less_413_s28_q, less_412_s28_q, less_411_s28_q, less_410_s28_q, less_409_s28_q, less_408_s28_q, less_407_s28_q, less_406_s28_q, less_405_s28_q, less_404_s28_q, less_403_s28_q, less_402_s28_q, less_401_s28_q, less_400_s28_q, less_399_s28_q, less_398_s28_q, less_397_s28_q, less_396_s28_q, less_395_s28_q, less_394_s28_q, less_393_s28_q, less_392_s28_q};
  end
`ifndef SYNTHESIS
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
  logic [6:0] fresh_raddr_s27_sim;
  logic fresh_re_s27_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      fresh_re_s27_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s7_sim <= fresh_re;
      fresh_raddr_s7_sim <= fresh_raddr;
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
      fresh_re_s27_sim <= fresh_re_s26_sim;
      fresh_raddr_s27_sim <= fresh_raddr_s26_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && fresh_we) begin
      if (fresh_re && fresh_raddr == fresh_waddr) begin
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
      if (fresh_re_s27_sim && fresh_raddr_s27_sim == fresh_waddr) begin
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
    end else if (s28_en) begin
      census_left_misses_q <= select_1249;
      counts_too_many_bad_q <= select_1540;
      counts_too_much_unproven_q <= and_1471_s28_q ? 24'h0 : sum_1551;
      counts_too_much_unseen_skin_q <= and_1471_s28_q ? 24'h0 : sum_1559;
    end
  end

  logic [7:0] pixel_0_s29_q;
  logic [7:0] pixel_1_s29_q;
  logic saturated_s29_q;
  logic mask_s29_q;
  logic marks_first_s29_q;
  logic marks_last_s29_q;
  logic [6:0] x_s29_q;
  logic [7:0] select_841_s29_q;
  logic [5:0] select_845_s29_q;
  logic [7:0] select_893_s29_q;
  logic and_894_s29_q;
  logic equal_910_s29_q;
  logic and_1020_s29_q;
  logic less_1021_s29_q;
  logic and_1471_s29_q;
  logic and_1482_s29_q;
  logic and_1486_s29_q;
  logic and_1511_s29_q;
  logic [11:0] select_1524_s29_q;
  logic [7:0] select_1617_s29_q;
  logic [7:0] select_1627_s29_q;
  logic [7:0] select_1637_s29_q;
  logic [7:0] select_1645_s29_q;
  logic equal_1889_s29_q;
  logic less_1895_s29_q;
  logic and_2001_s29_q;
  logic and_2019_s29_q;
  logic and_2022_s29_q;
  logic [13:0] select_2029_s29_q;
  logic [13:0] select_2031_s29_q;
  logic and_2043_s29_q;
  logic not_2044_s29_q;
  logic or_2055_s29_q;
  logic less_2062_s29_q;
  logic less_2063_s29_q;
  logic less_2065_s29_q;
  logic or_2068_s29_q;
  logic select_2125_s29_q;
  logic or_2127_s29_q;
  logic select_2132_s29_q;
  logic and_2145_s29_q;
  logic and_2152_s29_q;
  logic and_2162_s29_q;
  logic [11:0] select_2172_s29_q;
  logic [11:0] select_2174_s29_q;
  logic [11:0] select_2176_s29_q;
  logic [11:0] select_2178_s29_q;
  logic [23:0] select_2180_s29_q;
  logic [23:0] select_2182_s29_q;
  logic [23:0] select_2184_s29_q;
  logic [23:0] select_2186_s29_q;
  logic and_2187_s29_q;
  logic [5:0] select_2189_s29_q;
  logic [11:0] select_2191_s29_q;
  logic [11:0] select_2193_s29_q;
  logic [11:0] select_2196_s29_q;
  always_ff @(posedge clk_i) begin
    if (s28_en) begin
      pixel_0_s29_q <= pixel_0_s28_q;
      pixel_1_s29_q <= pixel_1_s28_q;
      saturated_s29_q <= saturated_s28_q;
      mask_s29_q <= mask_s28_q;
      marks_first_s29_q <= marks_first_s28_q;
      marks_last_s29_q <= marks_last_s28_q;
      x_s29_q <= x_s28_q;
      select_841_s29_q <= select_841_s28_q;
      select_845_s29_q <= select_845_s28_q;
      select_893_s29_q <= equal_532_s28_q ? select_889 : select_892;
      and_894_s29_q <= and_894_s28_q;
      equal_910_s29_q <= equal_910_s28_q;
      and_1020_s29_q <= and_1020_s28_q;
      less_1021_s29_q <= less_1021_s28_q;
      and_1471_s29_q <= and_1471_s28_q;
      and_1482_s29_q <= and_1482_s28_q;
      and_1486_s29_q <= and_1486_s28_q;
      and_1511_s29_q <= and_1511_s28_q;
      select_1524_s29_q <= equal_910_s28_q ? select_1523_s28_q : 12'h0;
      select_1617_s29_q <= drew_s28_q ? (select_939_s28_q[0] ? select_1615 : 8'h0) : 8'h0;
      select_1627_s29_q <= drew_s28_q ? (select_939_s28_q[0] ? select_1625 : 8'h0) : 8'h0;
      select_1637_s29_q <= select_1637;
      select_1645_s29_q <= equal_910_s28_q ? 8'h0 : (drew_s28_q ? select_1643 : 8'h0);
      equal_1889_s29_q <= equal_1889_s28_q;
      less_1895_s29_q <= less_1895_s28_q;
      and_2001_s29_q <= and_2001_s28_q;
      and_2019_s29_q <= select_2017[0] & and_2018;
      and_2022_s29_q <= select_2017[1] & and_2018;
      select_2029_s29_q <= select_2029_s28_q;
      select_2031_s29_q <= select_2031_s28_q;
      and_2043_s29_q <= and_2043_s28_q;
      not_2044_s29_q <= ~and_1894_s28_q;
      or_2055_s29_q <= ($signed(24'h0) < $signed(counts_too_many_bad_q)) | or_2054;
      less_2062_s29_q <= less_2062_s28_q;
      less_2063_s29_q <= less_2063_s28_q;
      less_2065_s29_q <= less_2065_s28_q;
      or_2068_s29_q <= or_2068_s28_q;
      select_2125_s29_q <= select_2125;
      or_2127_s29_q <= less_2126_s28_q | select_2125;
      select_2132_s29_q <= less_2070_s28_q ? or_2124 : select_2131;
      and_2145_s29_q <= and_2138 & or_2144;
      and_2152_s29_q <= and_2138 & (less_2149 | less_2150);
      and_2162_s29_q <= and_2162_s28_q;
      select_2172_s29_q <= select_2172_s28_q;
      select_2174_s29_q <= select_2174_s28_q;
      select_2176_s29_q <= select_2176_s28_q;
      select_2178_s29_q <= select_2178_s28_q;
      select_2180_s29_q <= select_2180_s28_q;
      select_2182_s29_q <= select_2182_s28_q;
      select_2184_s29_q <= select_2184;
      select_2186_s29_q <= select_2186;
      and_2187_s29_q <= and_2187_s28_q;
      select_2189_s29_q <= select_2189_s28_q;
      select_2191_s29_q <= select_2191_s28_q;
      select_2193_s29_q <= select_2193_s28_q;
      select_2196_s29_q <= select_2196_s28_q;
    end
  end

  // Stage 29 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:533
  logic [13:0] select_1484;
  assign select_1484 = and_1471_s29_q ? 14'h0 : (counts_explained_q + {13'h0, and_1482_s29_q});
  logic [13:0] select_1488;
  assign select_1488 = and_1471_s29_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1486_s29_q});
  logic [13:0] select_1513;
  assign select_1513 = and_1471_s29_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1511_s29_q});
  logic [13:0] select_1526;
  assign select_1526 = and_1471_s29_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1524_s29_q});
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1618;
  assign select_1618 = equal_910_s29_q ? 8'h0 : select_1617_s29_q;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1619;
  assign sum_1619 = registration_counts_across_0_q + {{12{select_1618[7]}}, select_1618};
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1628;
  assign select_1628 = equal_910_s29_q ? 8'h0 : select_1627_s29_q;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1629;
  assign sum_1629 = registration_counts_across_1_q + {{12{select_1628[7]}}, select_1628};
  logic [19:0] sum_1638;
  assign sum_1638 = registration_counts_across_2_q + {{12{select_1637_s29_q[7]}}, select_1637_s29_q};
  logic [19:0] sum_1646;
  assign sum_1646 = registration_counts_across_3_q + {{12{select_1645_s29_q[7]}}, select_1645_s29_q};
  // hls/stages/agreement.hpp:208
  logic select_2021;
  assign select_2021 = and_1020_s29_q ? (less_1021_s29_q ? and_2019_s29_q : seen_q) : seen_q;
  logic select_2024;
  assign select_2024 = and_1020_s29_q ? (less_1021_s29_q ? and_2022_s29_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:339
  logic [13:0] select_2033;
  assign select_2033 = equal_910_s29_q ? (equal_1889_s29_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_2035;
  assign select_2035 = equal_910_s29_q ? (equal_1889_s29_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_2037;
  assign select_2037 = equal_910_s29_q ? (equal_1889_s29_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_2039;
  assign select_2039 = equal_910_s29_q ? (equal_1889_s29_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic and_2047;
  assign and_2047 = equal_910_s29_q & (equal_1889_s29_q & (cfg_prove_i & not_2044_s29_q));
  // hls/stages/agreement.hpp:760
  logic or_2048;
  assign or_2048 = not_2025 | not_2044_s29_q;
  // hls/stages/agreement.hpp:339
  logic and_2057;
  assign and_2057 = equal_1889_s29_q & ((less_1895_s29_q | or_2048) ? (~or_2048) : or_2055_s29_q);
  // hls/stages/agreement.hpp:726
  logic or_2129;
  assign or_2129 = less_2063_s29_q | (or_2068_s29_q ? select_2125_s29_q : or_2127_s29_q);
  logic select_2134;
  assign select_2134 = less_2062_s29_q ? or_2129 : (less_2065_s29_q ? or_2127_s29_q : select_2132_s29_q);
  // hls/stages/agreement.hpp:339
  logic and_2137;
  assign and_2137 = equal_910_s29_q & (equal_1889_s29_q & (cfg_prove_i & select_2134));
  logic [19:0] select_2164;
  assign select_2164 = equal_910_s29_q ? (equal_1889_s29_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2166;
  assign select_2166 = equal_910_s29_q ? (equal_1889_s29_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2168;
  assign select_2168 = equal_910_s29_q ? (equal_1889_s29_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2170;
  assign select_2170 = equal_910_s29_q ? (equal_1889_s29_q ? registration_counts_across_3_q : 20'h0) : 20'h0;

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s29_q;
  logic best_left_we;
  assign best_left_we = s29_en & and_894_s29_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_893_s29_q, select_845_s29_q, select_841_s29_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_left_raddr_s8_sim;
  logic best_left_re_s8_sim;
  logic [6:0] best_left_raddr_s9_sim;
  logic best_left_re_s9_sim;
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
  logic [6:0] best_left_raddr_s26_sim;
  logic best_left_re_s26_sim;
  logic [6:0] best_left_raddr_s27_sim;
  logic best_left_re_s27_sim;
  logic [6:0] best_left_raddr_s28_sim;
  logic best_left_re_s28_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s8_sim <= 1'b0;
      best_left_re_s9_sim <= 1'b0;
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
      best_left_re_s26_sim <= 1'b0;
      best_left_re_s27_sim <= 1'b0;
      best_left_re_s28_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s8_sim <= best_left_re;
      best_left_raddr_s8_sim <= best_left_raddr;
      best_left_re_s9_sim <= best_left_re_s8_sim;
      best_left_raddr_s9_sim <= best_left_raddr_s8_sim;
      best_left_re_s10_sim <= best_left_re_s9_sim;
      best_left_raddr_s10_sim <= best_left_raddr_s9_sim;
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
      best_left_re_s26_sim <= best_left_re_s25_sim;
      best_left_raddr_s26_sim <= best_left_raddr_s25_sim;
      best_left_re_s27_sim <= best_left_re_s26_sim;
      best_left_raddr_s27_sim <= best_left_raddr_s26_sim;
      best_left_re_s28_sim <= best_left_re_s27_sim;
      best_left_raddr_s28_sim <= best_left_raddr_s27_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s8_sim && best_left_raddr_s8_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s9_sim && best_left_raddr_s9_sim == best_left_waddr) begin
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
      if (best_left_re_s26_sim && best_left_raddr_s26_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s27_sim && best_left_raddr_s27_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s28_sim && best_left_raddr_s28_sim == best_left_waddr) begin
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
    end else if (s29_en) begin
      counts_explained_q <= select_1484;
      counts_nearer_q <= select_1488;
      counts_unproven_q <= select_1513;
      counts_regions_bad_q <= select_1526;
      registration_counts_across_0_q <= and_1471_s29_q ? 20'h0 : sum_1619;
      registration_counts_across_1_q <= and_1471_s29_q ? 20'h0 : sum_1629;
      registration_counts_across_2_q <= and_1471_s29_q ? 20'h0 : sum_1638;
      registration_counts_across_3_q <= and_1471_s29_q ? 20'h0 : sum_1646;
      seen_q <= select_2021;
      nearer_q <= select_2024;
    end
  end

  logic [7:0] pixel_0_s30_q;
  logic [7:0] pixel_1_s30_q;
  logic saturated_s30_q;
  logic mask_s30_q;
  logic marks_first_s30_q;
  logic marks_last_s30_q;
  logic and_2001_s30_q;
  logic or_2026_s30_q;
  logic and_2027_s30_q;
  logic [13:0] select_2029_s30_q;
  logic [13:0] select_2031_s30_q;
  logic [13:0] select_2033_s30_q;
  logic [13:0] select_2035_s30_q;
  logic [13:0] select_2037_s30_q;
  logic [13:0] select_2039_s30_q;
  logic and_2043_s30_q;
  logic and_2047_s30_q;
  logic and_2058_s30_q;
  logic and_2137_s30_q;
  logic and_2147_s30_q;
  logic and_2154_s30_q;
  logic and_2162_s30_q;
  logic [19:0] select_2164_s30_q;
  logic [19:0] select_2166_s30_q;
  logic [19:0] select_2168_s30_q;
  logic [19:0] select_2170_s30_q;
  logic [11:0] select_2172_s30_q;
  logic [11:0] select_2174_s30_q;
  logic [11:0] select_2176_s30_q;
  logic [11:0] select_2178_s30_q;
  logic [23:0] select_2180_s30_q;
  logic [23:0] select_2182_s30_q;
  logic [23:0] select_2184_s30_q;
  logic [23:0] select_2186_s30_q;
  logic and_2187_s30_q;
  logic [5:0] select_2189_s30_q;
  logic [11:0] select_2191_s30_q;
  logic [11:0] select_2193_s30_q;
  logic [11:0] select_2196_s30_q;
  always_ff @(posedge clk_i) begin
    if (s29_en) begin
      pixel_0_s30_q <= pixel_0_s29_q;
      pixel_1_s30_q <= pixel_1_s29_q;
      saturated_s30_q <= saturated_s29_q;
      mask_s30_q <= mask_s29_q;
      marks_first_s30_q <= marks_first_s29_q;
      marks_last_s30_q <= marks_last_s29_q;
      and_2001_s30_q <= and_2001_s29_q;
      or_2026_s30_q <= not_2025 | select_2021;
      and_2027_s30_q <= cfg_prove_i & select_2024;
      select_2029_s30_q <= select_2029_s29_q;
      select_2031_s30_q <= select_2031_s29_q;
      select_2033_s30_q <= select_2033;
      select_2035_s30_q <= select_2035;
      select_2037_s30_q <= select_2037;
      select_2039_s30_q <= select_2039;
      and_2043_s30_q <= and_2043_s29_q;
      and_2047_s30_q <= and_2047;
      and_2058_s30_q <= equal_910_s29_q & and_2057;
      and_2137_s30_q <= and_2137;
      and_2147_s30_q <= equal_910_s29_q & (equal_1889_s29_q & and_2145_s29_q);
      and_2154_s30_q <= equal_910_s29_q & (equal_1889_s29_q & and_2152_s29_q);
      and_2162_s30_q <= and_2162_s29_q;
      select_2164_s30_q <= select_2164;
      select_2166_s30_q <= select_2166;
      select_2168_s30_q <= select_2168;
      select_2170_s30_q <= select_2170;
      select_2172_s30_q <= select_2172_s29_q;
      select_2174_s30_q <= select_2174_s29_q;
      select_2176_s30_q <= select_2176_s29_q;
      select_2178_s30_q <= select_2178_s29_q;
      select_2180_s30_q <= select_2180_s29_q;
      select_2182_s30_q <= select_2182_s29_q;
      select_2184_s30_q <= select_2184_s29_q;
      select_2186_s30_q <= select_2186_s29_q;
      and_2187_s30_q <= and_2187_s29_q;
      select_2189_s30_q <= select_2189_s29_q;
      select_2191_s30_q <= select_2191_s29_q;
      select_2193_s30_q <= select_2193_s29_q;
      select_2196_s30_q <= select_2196_s29_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s30_q;
  assign pixel_1_o = pixel_1_s30_q;
  assign saturated_o = saturated_s30_q;
  assign mask_o = mask_s30_q;
  assign marks_first_o = marks_first_s30_q;
  assign marks_last_o = marks_last_s30_q;
  assign marks_seen_o = or_2026_s30_q;
  assign marks_nearer_o = and_2027_s30_q;
  assign verdict_valid_o = and_2001_s30_q;
  assign verdict_supervised_o = {2'h0, select_2029_s30_q};
  assign verdict_textured_o = {2'h0, select_2031_s30_q};
  assign verdict_explained_o = {2'h0, select_2033_s30_q};
  assign verdict_nearer_o = {2'h0, select_2035_s30_q};
  assign verdict_unproven_o = {2'h0, select_2037_s30_q};
  assign verdict_regions_bad_o = {2'h0, select_2039_s30_q};
  assign verdict_unproven_yet_o = and_2043_s30_q;
  assign verdict_untextured_o = and_2047_s30_q;
  assign verdict_disagree_o = and_2058_s30_q;
  assign verdict_moved_o = and_2137_s30_q;
  assign verdict_unsharp_left_o = and_2147_s30_q;
  assign verdict_unsharp_right_o = and_2154_s30_q;
  assign verdict_hidden_o = and_2162_s30_q;
  assign verdict_across_0_o = select_2164_s30_q;
  assign verdict_across_1_o = select_2166_s30_q;
  assign verdict_across_2_o = select_2168_s30_q;
  assign verdict_across_3_o = select_2170_s30_q;
  assign verdict_measured_0_o = select_2172_s30_q;
  assign verdict_measured_1_o = select_2174_s30_q;
  assign verdict_measured_2_o = select_2176_s30_q;
  assign verdict_measured_3_o = select_2178_s30_q;
  assign verdict_detail_0_o = select_2180_s30_q;
  assign verdict_detail_1_o = select_2182_s30_q;
  assign verdict_contrast_0_o = select_2184_s30_q;
  assign verdict_contrast_1_o = select_2186_s30_q;
  assign region_valid_o = and_2187_s30_q;
  assign region_region_o = select_2189_s30_q;
  assign region_textured_o = select_2191_s30_q;
  assign region_explained_o = select_2193_s30_q;
  assign region_nearer_o = select_2196_s30_q;
  assign valid_o = valid_s30_q;

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
      valid_s30_q <= 1'b0;
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
      valid_s30_q <= valid_s29_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{right[1:0], left[1:0], sum_2061[2:0], sum_1601[0], sum_1597[0], sum_1589[1:0], sum_1588[1:0], sum_1584[0], detail_4[1:0], detail_3[1:0], sum_1243[4:0], sum_886[8:0], sum_471[4:0], cfg_width_i[3:0]};

endmodule
