// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 30 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2576 bits, pipeline 8402 bits, memories 91944 bits.
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
  logic [6:0] sum_1415;
  assign sum_1415 = {1'b0, cfg_width_i[10:5]} + 7'h11;
  logic [6:0] sum_1430;
  assign sum_1430 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] difference_1910;
  assign difference_1910 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_2053;
  assign less_2053 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_2054;
  assign sum_2054 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_2072;
  assign not_2072 = ~cfg_prove_i;

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
  logic [3:0] select_1150;
  assign select_1150 = sample_pair_whole_q ? (sample_last_q ? (select_339 + 4'h1) : select_339) : raster_at_y_q;

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
      raster_at_y_q <= select_1150;
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
  logic [6:0] select_1152;
  assign select_1152 = sample_pair_whole_s1_q ? (select_321 + {6'h0, equal_356}) : raster_at_column_q;
  // hls/stages/census.hpp:52
  logic [6:0] select_1154;
  assign select_1154 = sample_last_s1_q ? (select_417 + {6'h0, equal_357_s1_q}) : select_417;
  // hls/stages/agreement.hpp:204
  logic select_1159;
  assign select_1159 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_326 & (~raster_final_row_q)) : or_326) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [10:0] select_1161;
  assign select_1161 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:204
  logic select_1165;
  assign select_1165 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
    end else if (s1_en) begin
      raster_at_column_q <= select_1152;
      raster_at_row_q <= sample_pair_whole_s1_q ? select_1154 : raster_at_row_q;
      raster_at_live_q <= select_1159;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_1161 : raster_rows_left_q;
      raster_final_row_q <= select_1165;
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
  // hls/stages/agreement.hpp:306
  logic [7:0] sum_1426;
  assign sum_1426 = {1'b0, row_s2_q} + 8'h1;

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
  logic equal_1427_s3_q;
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
      equal_1427_s3_q <= {sum_1426[7], cfg_height_i[10:4]} == {1'b0, sum_1426[6:0]};
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
  // hls/stages/agreement.hpp:787
  logic drew;
  assign drew = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:381
  logic equal_380;
  assign equal_380 = run_phase_q == 3'h4;
  logic equal_383;
  assign equal_383 = run_phase_q == 3'h3;
  logic equal_385;
  assign equal_385 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:143
  logic not_975;
  assign not_975 = ~drew;
  // hls/stages/agreement.hpp:289
  logic equal_1337;
  assign equal_1337 = {last[7], column_s3_q} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:200
  logic [2:0] select_1338;
  assign select_1338 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1347;
  assign select_1347 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1350;
  assign select_1350 = ends_q ? following_shift_q : run_shift_q;
  logic select_1353;
  assign select_1353 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:290
  logic not_1354;
  assign not_1354 = ~equal_1337;
  // hls/stages/agreement.hpp:371
  logic not_1357;
  assign not_1357 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:381
  logic equal_1358;
  assign equal_1358 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:160
  logic or_1359;
  assign or_1359 = equal_1358 | equal_385;
  logic [2:0] select_1360;
  assign select_1360 = equal_383 ? {run_last_shift_q, {2{not_1357}}} : {1'b0, or_1359, equal_385};
  logic [2:0] select_1362;
  assign select_1362 = drew ? {{2{final_row_q}}, 1'b0} : (equal_380 ? 3'h5 : select_1360);
  logic [7:0] select_1379;
  assign select_1379 = equal_383 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_385 ? first_beats_q : (equal_1358 ? whole_beats_q : 8'h0));
  logic [5:0] select_1385;
  assign select_1385 = equal_383 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_385 ? (6'h0 - least_q[5:0]) : 6'h0);
  logic select_1392;
  assign select_1392 = equal_383 ? (next_last_shift_q & not_1357) : (equal_385 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1400;
  assign select_1400 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:296
  logic less_1407;
  assign less_1407 = 7'h1c < column_s3_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1410;
  assign select_1410 = and_360 ? (equal_1337 ? (less_1407 ? 7'h1d : column_s3_q) : least_q) : least_q;
  // hls/stages/agreement.hpp:290
  logic [7:0] select_1413;
  assign select_1413 = equal_1337 ? (less_1407 ? ({1'b0, cfg_width_i[10:4]} + 8'h5) : 8'h23) : first_beats_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1417;
  assign select_1417 = and_360 ? (equal_1337 ? {sum_1415, cfg_width_i[4]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:346
  logic not_1418;
  assign not_1418 = ~ends_q;
  // hls/stages/agreement.hpp:200
  logic and_1423;
  assign and_1423 = not_1418 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:205
  logic select_1429;
  assign select_1429 = and_360 ? (equal_1337 ? equal_1427_s3_q : final_row_q) : final_row_q;
  // hls/stages/agreement.hpp:153
  logic not_1962;
  assign not_1962 = ~run_shift_q[5];

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
      run_phase_q <= and_360 ? (equal_1337 ? 3'h1 : select_1338) : select_1338;
      run_beats_q <= and_360 ? (equal_1337 ? 8'h20 : select_1347) : select_1347;
      run_shift_q <= and_360 ? (equal_1337 ? 6'h0 : select_1350) : select_1350;
      run_last_shift_q <= and_360 ? (select_1353 & not_1354) : select_1353;
      following_phase_q <= select_1362;
      following_beats_q <= drew ? 8'h3f : (equal_380 ? whole_beats_q : select_1379);
      following_shift_q <= drew ? 6'h0 : (equal_380 ? 6'h0 : select_1385);
      following_last_shift_q <= not_975 & ((~equal_380) & select_1392);
      beats_left_q <= and_360 ? (equal_1337 ? 8'h20 : select_1400) : select_1400;
      least_q <= select_1410;
      first_beats_q <= and_360 ? select_1413 : first_beats_q;
      whole_beats_q <= select_1417;
      ends_q <= and_360 ? (and_1423 & not_1354) : and_1423;
      final_row_q <= select_1429;
      next_beats_q <= {{7{not_1962}}, 1'b1} + run_beats_q;
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
  logic equal_944_s4_q;
  logic not_975_s4_q;
  logic equal_1337_s4_q;
  logic equal_1358_s4_q;
  logic not_1418_s4_q;
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
      equal_944_s4_q <= run_phase_q == 3'h6;
      not_975_s4_q <= not_975;
      equal_1337_s4_q <= equal_1337;
      equal_1358_s4_q <= equal_1358;
      not_1418_s4_q <= not_1418;
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
  // hls/stages/agreement.hpp:602
  logic less_386;
  assign less_386 = run_highest_q < x_q;
  logic not_387;
  assign not_387 = ~less_386;
  // hls/stages/agreement.hpp:181
  logic [6:0] select_503;
  assign select_503 = equal_383_s4_q ? ({run_shift_s4_q[5], run_shift_s4_q} + x_q[6:0]) : x_q[6:0];
  // hls/stages/agreement.hpp:469
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:488
  logic equal_532;
  assign equal_532 = {{2{run_shift_s4_q[5]}}, run_shift_s4_q} == (8'h0 - {1'b0, least_s4_q});
  // hls/stages/agreement.hpp:735
  logic [6:0] sum_1140;
  assign sum_1140 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1341;
  assign select_1341 = ends_s4_q ? following_lowest_q : run_lowest_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1343;
  assign select_1343 = and_360_s4_q ? (equal_1337_s4_q ? 8'h0 : select_1341) : select_1341;
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1344;
  assign select_1344 = ends_s4_q ? following_highest_q : run_highest_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1346;
  assign select_1346 = and_360_s4_q ? (equal_1337_s4_q ? 8'h0 : select_1344) : select_1344;
  // hls/stages/agreement.hpp:160
  logic [7:0] select_1364;
  assign select_1364 = run_last_shift_s4_q ? 8'h0 : (run_shift_s4_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1365;
  assign select_1365 = equal_385_s4_q ? least_s4_q : 7'h0;
  logic [7:0] select_1367;
  assign select_1367 = equal_380_s4_q ? 8'h0 : (equal_383_s4_q ? select_1364 : {1'b0, select_1365});
  logic [7:0] select_1370;
  assign select_1370 = run_last_shift_s4_q ? {1'b0, last_q} : (run_shift_s4_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1372;
  assign select_1372 = equal_385_s4_q ? last_q : (equal_1358_s4_q ? last_q : 7'h0);
  logic [7:0] select_1374;
  assign select_1374 = equal_380_s4_q ? {1'b0, last_q} : (equal_383_s4_q ? select_1370 : {1'b0, select_1372});
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1396;
  assign select_1396 = ends_s4_q ? following_lowest_q : (x_q + 8'h1);
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1398;
  assign select_1398 = and_360_s4_q ? (equal_1337_s4_q ? 8'h0 : select_1396) : select_1396;
  // hls/stages/agreement.hpp:645
  logic [5:0] sum_1615;
  assign sum_1615 = {1'b0, last_q[6:2]} + 6'h1;

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
      run_lowest_q <= select_1343;
      run_highest_q <= select_1346;
      following_lowest_q <= drew_s4_q ? 8'h0 : select_1367;
      following_highest_q <= drew_s4_q ? 8'h0 : select_1374;
      x_q <= select_1398;
      last_q <= and_360_s4_q ? (equal_1337_s4_q ? column_s4_q : last_q) : last_q;
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
  logic equal_535_s5_q;
  logic equal_603_s5_q;
  logic equal_931_s5_q;
  logic equal_944_s5_q;
  logic not_975_s5_q;
  logic equal_1011_s5_q;
  logic not_1142_s5_q;
  logic equal_1337_s5_q;
  logic not_1418_s5_q;
  logic less_1616_s5_q;
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
      equal_535_s5_q <= run_lowest_q == x;
      equal_603_s5_q <= run_lowest_q == x_q;
      equal_931_s5_q <= run_highest_q == x;
      equal_944_s5_q <= equal_944_s4_q;
      not_975_s5_q <= not_975_s4_q;
      equal_1011_s5_q <= x_q == {1'b0, last_q};
      not_1142_s5_q <= ~({sum_1140, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1337_s5_q <= equal_1337_s4_q;
      not_1418_s5_q <= not_1418_s4_q;
      less_1616_s5_q <= {1'b0, sum_1615, last_q[1]} < x_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:590
  logic or_381;
  assign or_381 = drew_s5_q | equal_380_s5_q;
  // hls/stages/agreement.hpp:447
  logic not_382;
  assign not_382 = ~or_381;
  // hls/stages/agreement.hpp:181
  logic select_474;
  assign select_474 = equal_383_s5_q ? not_387_s5_q : and_388_s5_q;
  // hls/stages/agreement.hpp:492
  logic or_534;
  assign or_534 = equal_532_s5_q | ($signed(6'h0) < $signed(run_shift_s5_q));

  // Memory left, 120 x 77, DISTANCE 32, hls/stages/agreement.hpp:917; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
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

  // Memory right_codes, 120 x 91, DISTANCE 32, hls/stages/agreement.hpp:918; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
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

  logic [7:0] pixel_0_s6_q;
  logic [7:0] pixel_1_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic sample_pair_whole_s6_q;
  logic [5:0] run_shift_s6_q;
  logic [7:0] x_s6_q;
  logic ends_s6_q;
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
  logic not_382_s6_q;
  logic equal_383_s6_q;
  logic less_386_s6_q;
  logic not_387_s6_q;
  logic and_390_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic not_526_s6_q;
  logic select_536_s6_q;
  logic equal_603_s6_q;
  logic select_932_s6_q;
  logic equal_944_s6_q;
  logic not_975_s6_q;
  logic equal_1011_s6_q;
  logic not_1142_s6_q;
  logic equal_1337_s6_q;
  logic not_1418_s6_q;
  logic less_1616_s6_q;
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
      ends_s6_q <= ends_s5_q;
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
      not_382_s6_q <= not_382;
      equal_383_s6_q <= equal_383_s5_q;
      less_386_s6_q <= less_386_s5_q;
      not_387_s6_q <= not_387_s5_q;
      and_390_s6_q <= not_382 & ((~equal_383_s5_q) & and_388_s5_q);
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x_s5_2_q;
      not_526_s6_q <= not_526_s5_q;
      select_536_s6_q <= or_534 ? equal_532_s5_q : equal_535_s5_q;
      equal_603_s6_q <= equal_603_s5_q;
      select_932_s6_q <= or_534 ? equal_532_s5_q : equal_931_s5_q;
      equal_944_s6_q <= equal_944_s5_q;
      not_975_s6_q <= not_975_s5_q;
      equal_1011_s6_q <= equal_1011_s5_q;
      not_1142_s6_q <= not_1142_s5_q;
      equal_1337_s6_q <= equal_1337_s5_q;
      not_1418_s6_q <= not_1418_s5_q;
      less_1616_s6_q <= less_1616_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:181
  logic and_528;
  assign and_528 = equal_383_s6_q & (age_q[2] & not_526_s6_q);
  // hls/stages/agreement.hpp:200
  logic [5:0] select_1419;
  assign select_1419 = ends_s6_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1421;
  assign select_1421 = and_360_s6_q ? (equal_1337_s6_q ? 7'h0 : {select_1419, not_1418_s6_q}) : {select_1419, not_1418_s6_q};

  // Memory fresh, 120 x 29, DISTANCE 32, hls/stages/agreement.hpp:916; read in stage 6, written in stage 28: 6 < 28 < 6 + DISTANCE.
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s6_en) begin
      age_q <= select_1421;
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
  logic [2:0] age_s7_q;
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
  logic select_536_s7_q;
  logic equal_603_s7_q;
  logic and_926_s7_q;
  logic select_932_s7_q;
  logic equal_944_s7_q;
  logic not_975_s7_q;
  logic equal_1011_s7_q;
  logic not_1142_s7_q;
  logic equal_1337_s7_q;
  logic less_1616_s7_q;
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
      age_s7_q <= {age_q[6], age_q[4:3]};
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
      select_529_s7_q <= or_381_s6_q ? not_387_s6_q : and_528;
      select_536_s7_q <= select_536_s6_q;
      equal_603_s7_q <= equal_603_s6_q;
      and_926_s7_q <= not_382_s6_q & and_528;
      select_932_s7_q <= select_932_s6_q;
      equal_944_s7_q <= equal_944_s6_q;
      not_975_s7_q <= not_975_s6_q;
      equal_1011_s7_q <= equal_1011_s6_q;
      not_1142_s7_q <= not_1142_s6_q;
      equal_1337_s7_q <= equal_1337_s6_q;
      less_1616_s7_q <= less_1616_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:414
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
  // hls/stages/agreement.hpp:415
  logic less_514;
  assign less_514 = row_q < 7'h5;
  logic less_518;
  assign less_518 = row_q[6:1] < 6'h3;
  // hls/stages/agreement.hpp:170
  logic and_542;
  assign and_542 = left_rdata_s7_q[44] & not_387_s7_q;
  logic [11:0] a;
  assign a = less_386_s7_q ? 12'h0 : left_rdata_s7_q[43:32];
  logic [11:0] b;
  assign b = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[37:26];
  logic [11:0] a_2;
  assign a_2 = less_386_s7_q ? 12'h0 : left_rdata_s7_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[50:39];
  logic and_581;
  assign and_581 = left_rdata_s7_q[76] & not_387_s7_q;
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
  // hls/stages/agreement.hpp:424
  logic [11:0] not_753;
  assign not_753 = ~(a_3 ^ b_6);
  // hls/stages/agreement.hpp:170
  logic [11:0] b_7;
  assign b_7 = less_386_s7_q ? 12'h0 : right_codes_rdata_s7_q[11:0];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_782;
  assign not_782 = ~(a ^ b_7);
  // hls/stages/agreement.hpp:610
  logic and_948;
  assign and_948 = left_rdata_s7_q[61] & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:343
  logic and_1144;
  assign and_1144 = drew_s7_q & (((7'h6 < row_q) & (~(x_s7_q[7:2] == 6'h0))) & not_1142_s7_q);
  // hls/stages/agreement.hpp:290
  logic select_1433;
  assign select_1433 = equal_1337_s7_q ? (~({row_s7_q, 1'b0} < {sum_1430, cfg_height_i[4]})) : lower_half_q;

  // Memory best_left, 120 x 35, DISTANCE 32, hls/stages/agreement.hpp:919; read in stage 7, written in stage 29: 7 < 29 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [34:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 35'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_381_s7_q ? x_s7_q[6:0] : x_s7_2_q;
  logic best_left_re;
  assign best_left_re = s7_en & select_529_s7_q;
  logic [34:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s7_en) begin
      row_q <= and_360_s7_q ? (equal_1337_s7_q ? row_s7_q : row_q) : row_q;
      lower_half_q <= and_360_s7_q ? select_1433 : lower_half_q;
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
  logic [2:0] age_s8_q;
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
  logic select_536_s8_q;
  logic and_542_s8_q;
  logic and_543_s8_q;
  logic [11:0] a_s8_q;
  logic [11:0] b_s8_q;
  logic and_561_s8_q;
  logic and_562_s8_q;
  logic [11:0] a_2_s8_q;
  logic [11:0] b_2_s8_q;
  logic and_581_s8_q;
  logic and_582_s8_q;
  logic [11:0] a_3_s8_q;
  logic [11:0] b_3_s8_q;
  logic equal_603_s8_q;
  logic and_637_s8_q;
  logic [11:0] b_4_s8_q;
  logic and_661_s8_q;
  logic [11:0] b_5_s8_q;
  logic and_750_s8_q;
  logic [9:0] not_753_s8_q;
  logic [1:0] sum_754_s8_q;
  logic and_779_s8_q;
  logic [9:0] not_782_s8_q;
  logic [1:0] sum_783_s8_q;
  logic and_926_s8_q;
  logic select_932_s8_q;
  logic equal_944_s8_q;
  logic and_949_s8_q;
  logic and_950_s8_q;
  logic and_952_s8_q;
  logic not_975_s8_q;
  logic equal_1011_s8_q;
  logic and_1144_s8_q;
  logic equal_1285_s8_q;
  logic equal_1337_s8_q;
  logic less_1614_s8_q;
  logic less_1616_s8_q;
  logic equal_1880_s8_q;
  logic less_1891_s8_q;
  logic equal_2034_s8_q;
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
      select_536_s8_q <= select_536_s7_q;
      and_542_s8_q <= and_542;
      and_543_s8_q <= right_codes_rdata_s7_q[38] & not_387_s7_q;
      a_s8_q <= a;
      b_s8_q <= b;
      and_561_s8_q <= left_rdata_s7_q[60] & not_387_s7_q;
      and_562_s8_q <= right_codes_rdata_s7_q[51] & not_387_s7_q;
      a_2_s8_q <= a_2;
      b_2_s8_q <= b_2;
      and_581_s8_q <= and_581;
      and_582_s8_q <= right_codes_rdata_s7_q[64] & not_387_s7_q;
      a_3_s8_q <= a_3;
      b_3_s8_q <= b_3;
      equal_603_s8_q <= equal_603_s7_q;
      and_637_s8_q <= right_codes_rdata_s7_q[77] & not_387_s7_q;
      b_4_s8_q <= b_4;
      and_661_s8_q <= right_codes_rdata_s7_q[25] & not_387_s7_q;
      b_5_s8_q <= b_5;
      and_750_s8_q <= and_581 & (right_codes_rdata_s7_q[90] & not_387_s7_q);
      not_753_s8_q <= not_753[11:2];
      sum_754_s8_q <= {1'b0, not_753[0]} + {1'b0, not_753[1]};
      and_779_s8_q <= and_542 & (right_codes_rdata_s7_q[12] & not_387_s7_q);
      not_782_s8_q <= not_782[11:2];
      sum_783_s8_q <= {1'b0, not_782[0]} + {1'b0, not_782[1]};
      and_926_s8_q <= and_926_s7_q;
      select_932_s8_q <= select_932_s7_q;
      equal_944_s8_q <= equal_944_s7_q;
      and_949_s8_q <= not_387_s7_q & and_948;
      and_950_s8_q <= left_rdata_s7_q[62] & and_948;
      and_952_s8_q <= left_rdata_s7_q[63] & not_387_s7_q;
      not_975_s8_q <= not_975_s7_q;
      equal_1011_s8_q <= equal_1011_s7_q;
      and_1144_s8_q <= and_1144;
      equal_1285_s8_q <= (column_s7_q | row_s7_q) == 7'h0;
      equal_1337_s8_q <= equal_1337_s7_q;
      less_1614_s8_q <= 6'h4 < row_q[6:1];
      less_1616_s8_q <= less_1616_s7_q;
      equal_1880_s8_q <= row_s7_q[6:2] == 5'h0;
      less_1891_s8_q <= 6'h2 < row_s7_q[6:1];
      equal_2034_s8_q <= row_s7_q[6:3] == 4'h0;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:424
  logic [11:0] not_548;
  assign not_548 = ~(a_s8_q ^ b_s8_q);
  logic [1:0] sum_550;
  assign sum_550 = {1'b0, not_548[2]} + ({1'b0, not_548[0]} + {1'b0, not_548[1]});
  logic [11:0] not_567;
  assign not_567 = ~(a_2_s8_q ^ b_2_s8_q);
  logic [1:0] sum_569;
  assign sum_569 = {1'b0, not_567[2]} + ({1'b0, not_567[0]} + {1'b0, not_567[1]});
  logic [11:0] not_587;
  assign not_587 = ~(a_3_s8_q ^ b_3_s8_q);
  logic [1:0] sum_589;
  assign sum_589 = {1'b0, not_587[2]} + ({1'b0, not_587[0]} + {1'b0, not_587[1]});
  logic [11:0] not_608;
  assign not_608 = ~(a_s8_q ^ b_2_s8_q);
  logic [1:0] sum_610;
  assign sum_610 = {1'b0, not_608[2]} + ({1'b0, not_608[0]} + {1'b0, not_608[1]});
  logic [11:0] not_623;
  assign not_623 = ~(a_2_s8_q ^ b_3_s8_q);
  logic [1:0] sum_625;
  assign sum_625 = {1'b0, not_623[2]} + ({1'b0, not_623[0]} + {1'b0, not_623[1]});
  logic [11:0] not_641;
  assign not_641 = ~(a_3_s8_q ^ b_4_s8_q);
  logic [1:0] sum_643;
  assign sum_643 = {1'b0, not_641[2]} + ({1'b0, not_641[0]} + {1'b0, not_641[1]});
  logic [11:0] not_665;
  assign not_665 = ~(a_s8_q ^ b_5_s8_q);
  logic [1:0] sum_667;
  assign sum_667 = {1'b0, not_665[2]} + ({1'b0, not_665[0]} + {1'b0, not_665[1]});
  logic [11:0] not_680;
  assign not_680 = ~(a_2_s8_q ^ b_s8_q);
  logic [1:0] sum_682;
  assign sum_682 = {1'b0, not_680[2]} + ({1'b0, not_680[0]} + {1'b0, not_680[1]});
  logic [11:0] not_696;
  assign not_696 = ~(a_3_s8_q ^ b_2_s8_q);
  logic [1:0] sum_698;
  assign sum_698 = {1'b0, not_696[2]} + ({1'b0, not_696[0]} + {1'b0, not_696[1]});
  logic [11:0] not_720;
  assign not_720 = ~(a_s8_q ^ b_3_s8_q);
  logic [1:0] sum_722;
  assign sum_722 = {1'b0, not_720[2]} + ({1'b0, not_720[0]} + {1'b0, not_720[1]});
  logic [11:0] not_735;
  assign not_735 = ~(a_2_s8_q ^ b_4_s8_q);
  logic [1:0] sum_737;
  assign sum_737 = {1'b0, not_735[2]} + ({1'b0, not_735[0]} + {1'b0, not_735[1]});
  logic [1:0] sum_755;
  assign sum_755 = {1'b0, not_753_s8_q[0]} + sum_754_s8_q;
  logic [1:0] sum_784;
  assign sum_784 = {1'b0, not_782_s8_q[0]} + sum_783_s8_q;
  logic [11:0] not_797;
  assign not_797 = ~(a_2_s8_q ^ b_5_s8_q);
  logic [1:0] sum_799;
  assign sum_799 = {1'b0, not_797[2]} + ({1'b0, not_797[0]} + {1'b0, not_797[1]});
  logic [11:0] not_813;
  assign not_813 = ~(a_3_s8_q ^ b_s8_q);
  logic [1:0] sum_815;
  assign sum_815 = {1'b0, not_813[2]} + ({1'b0, not_813[0]} + {1'b0, not_813[1]});

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
  logic [2:0] age_s9_q;
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
  logic [6:0] x_s9_2_q;
  logic select_529_s9_q;
  logic [34:0] best_left_rdata_s9_q;
  logic select_536_s9_q;
  logic and_542_s9_q;
  logic and_543_s9_q;
  logic [7:0] not_548_s9_q;
  logic [2:0] sum_551_s9_q;
  logic and_561_s9_q;
  logic and_562_s9_q;
  logic [7:0] not_567_s9_q;
  logic [2:0] sum_570_s9_q;
  logic and_581_s9_q;
  logic and_582_s9_q;
  logic [7:0] not_587_s9_q;
  logic [2:0] sum_590_s9_q;
  logic equal_603_s9_q;
  logic [7:0] not_608_s9_q;
  logic [2:0] sum_611_s9_q;
  logic [7:0] not_623_s9_q;
  logic [2:0] sum_626_s9_q;
  logic and_637_s9_q;
  logic [7:0] not_641_s9_q;
  logic [2:0] sum_644_s9_q;
  logic and_661_s9_q;
  logic [7:0] not_665_s9_q;
  logic [2:0] sum_668_s9_q;
  logic [7:0] not_680_s9_q;
  logic [2:0] sum_683_s9_q;
  logic [7:0] not_696_s9_q;
  logic [2:0] sum_699_s9_q;
  logic [7:0] not_720_s9_q;
  logic [2:0] sum_723_s9_q;
  logic [7:0] not_735_s9_q;
  logic [2:0] sum_738_s9_q;
  logic and_750_s9_q;
  logic [7:0] not_753_s9_q;
  logic [2:0] sum_756_s9_q;
  logic and_779_s9_q;
  logic [7:0] not_782_s9_q;
  logic [2:0] sum_785_s9_q;
  logic [7:0] not_797_s9_q;
  logic [2:0] sum_800_s9_q;
  logic [7:0] not_813_s9_q;
  logic [2:0] sum_816_s9_q;
  logic and_926_s9_q;
  logic select_932_s9_q;
  logic equal_944_s9_q;
  logic and_949_s9_q;
  logic and_950_s9_q;
  logic and_952_s9_q;
  logic not_975_s9_q;
  logic equal_1011_s9_q;
  logic and_1144_s9_q;
  logic equal_1285_s9_q;
  logic equal_1337_s9_q;
  logic less_1614_s9_q;
  logic less_1616_s9_q;
  logic equal_1880_s9_q;
  logic less_1891_s9_q;
  logic equal_2034_s9_q;
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
      x_s9_2_q <= x_s8_2_q;
      select_529_s9_q <= select_529_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_q;
      select_536_s9_q <= select_536_s8_q;
      and_542_s9_q <= and_542_s8_q;
      and_543_s9_q <= and_543_s8_q;
      not_548_s9_q <= not_548[11:4];
      sum_551_s9_q <= {2'h0, not_548[3]} + {1'b0, sum_550};
      and_561_s9_q <= and_561_s8_q;
      and_562_s9_q <= and_562_s8_q;
      not_567_s9_q <= not_567[11:4];
      sum_570_s9_q <= {2'h0, not_567[3]} + {1'b0, sum_569};
      and_581_s9_q <= and_581_s8_q;
      and_582_s9_q <= and_582_s8_q;
      not_587_s9_q <= not_587[11:4];
      sum_590_s9_q <= {2'h0, not_587[3]} + {1'b0, sum_589};
      equal_603_s9_q <= equal_603_s8_q;
      not_608_s9_q <= not_608[11:4];
      sum_611_s9_q <= {2'h0, not_608[3]} + {1'b0, sum_610};
      not_623_s9_q <= not_623[11:4];
      sum_626_s9_q <= {2'h0, not_623[3]} + {1'b0, sum_625};
      and_637_s9_q <= and_637_s8_q;
      not_641_s9_q <= not_641[11:4];
      sum_644_s9_q <= {2'h0, not_641[3]} + {1'b0, sum_643};
      and_661_s9_q <= and_661_s8_q;
      not_665_s9_q <= not_665[11:4];
      sum_668_s9_q <= {2'h0, not_665[3]} + {1'b0, sum_667};
      not_680_s9_q <= not_680[11:4];
      sum_683_s9_q <= {2'h0, not_680[3]} + {1'b0, sum_682};
      not_696_s9_q <= not_696[11:4];
      sum_699_s9_q <= {2'h0, not_696[3]} + {1'b0, sum_698};
      not_720_s9_q <= not_720[11:4];
      sum_723_s9_q <= {2'h0, not_720[3]} + {1'b0, sum_722};
      not_735_s9_q <= not_735[11:4];
      sum_738_s9_q <= {2'h0, not_735[3]} + {1'b0, sum_737};
      and_750_s9_q <= and_750_s8_q;
      not_753_s9_q <= not_753_s8_q[9:2];
      sum_756_s9_q <= {2'h0, not_753_s8_q[1]} + {1'b0, sum_755};
      and_779_s9_q <= and_779_s8_q;
      not_782_s9_q <= not_782_s8_q[9:2];
      sum_785_s9_q <= {2'h0, not_782_s8_q[1]} + {1'b0, sum_784};
      not_797_s9_q <= not_797[11:4];
      sum_800_s9_q <= {2'h0, not_797[3]} + {1'b0, sum_799};
      not_813_s9_q <= not_813[11:4];
      sum_816_s9_q <= {2'h0, not_813[3]} + {1'b0, sum_815};
      and_926_s9_q <= and_926_s8_q;
      select_932_s9_q <= select_932_s8_q;
      equal_944_s9_q <= equal_944_s8_q;
      and_949_s9_q <= and_949_s8_q;
      and_950_s9_q <= and_950_s8_q;
      and_952_s9_q <= and_952_s8_q;
      not_975_s9_q <= not_975_s8_q;
      equal_1011_s9_q <= equal_1011_s8_q;
      and_1144_s9_q <= and_1144_s8_q;
      equal_1285_s9_q <= equal_1285_s8_q;
      equal_1337_s9_q <= equal_1337_s8_q;
      less_1614_s9_q <= less_1614_s8_q;
      less_1616_s9_q <= less_1616_s8_q;
      equal_1880_s9_q <= equal_1880_s8_q;
      less_1891_s9_q <= less_1891_s8_q;
      equal_2034_s9_q <= equal_2034_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:424
  logic [2:0] sum_553;
  assign sum_553 = {2'h0, not_548_s9_q[1]} + ({2'h0, not_548_s9_q[0]} + sum_551_s9_q);
  logic [2:0] sum_572;
  assign sum_572 = {2'h0, not_567_s9_q[1]} + ({2'h0, not_567_s9_q[0]} + sum_570_s9_q);
  logic [2:0] sum_592;
  assign sum_592 = {2'h0, not_587_s9_q[1]} + ({2'h0, not_587_s9_q[0]} + sum_590_s9_q);
  logic [2:0] sum_613;
  assign sum_613 = {2'h0, not_608_s9_q[1]} + ({2'h0, not_608_s9_q[0]} + sum_611_s9_q);
  logic [2:0] sum_628;
  assign sum_628 = {2'h0, not_623_s9_q[1]} + ({2'h0, not_623_s9_q[0]} + sum_626_s9_q);
  logic [2:0] sum_646;
  assign sum_646 = {2'h0, not_641_s9_q[1]} + ({2'h0, not_641_s9_q[0]} + sum_644_s9_q);
  logic [2:0] sum_670;
  assign sum_670 = {2'h0, not_665_s9_q[1]} + ({2'h0, not_665_s9_q[0]} + sum_668_s9_q);
  logic [2:0] sum_685;
  assign sum_685 = {2'h0, not_680_s9_q[1]} + ({2'h0, not_680_s9_q[0]} + sum_683_s9_q);
  logic [2:0] sum_701;
  assign sum_701 = {2'h0, not_696_s9_q[1]} + ({2'h0, not_696_s9_q[0]} + sum_699_s9_q);
  logic [2:0] sum_725;
  assign sum_725 = {2'h0, not_720_s9_q[1]} + ({2'h0, not_720_s9_q[0]} + sum_723_s9_q);
  logic [2:0] sum_740;
  assign sum_740 = {2'h0, not_735_s9_q[1]} + ({2'h0, not_735_s9_q[0]} + sum_738_s9_q);
  logic [2:0] sum_758;
  assign sum_758 = {2'h0, not_753_s9_q[1]} + ({2'h0, not_753_s9_q[0]} + sum_756_s9_q);
  logic [2:0] sum_787;
  assign sum_787 = {2'h0, not_782_s9_q[1]} + ({2'h0, not_782_s9_q[0]} + sum_785_s9_q);
  logic [2:0] sum_802;
  assign sum_802 = {2'h0, not_797_s9_q[1]} + ({2'h0, not_797_s9_q[0]} + sum_800_s9_q);
  logic [2:0] sum_818;
  assign sum_818 = {2'h0, not_813_s9_q[1]} + ({2'h0, not_813_s9_q[0]} + sum_816_s9_q);
  // hls/stages/agreement.hpp:607
  logic [6:0] sum_927;
  assign sum_927 = x_s9_q[6:0] + {best_left_rdata_s9_q[13], best_left_rdata_s9_q[13:8]};
  // hls/stages/agreement.hpp:504
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
  logic [2:0] age_s10_q;
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
  logic [6:0] x_s10_2_q;
  logic select_529_s10_q;
  logic [34:0] best_left_rdata_s10_q;
  logic select_536_s10_q;
  logic and_542_s10_q;
  logic and_543_s10_q;
  logic [5:0] not_548_s10_q;
  logic [2:0] sum_553_s10_q;
  logic and_561_s10_q;
  logic and_562_s10_q;
  logic [5:0] not_567_s10_q;
  logic [2:0] sum_572_s10_q;
  logic and_581_s10_q;
  logic and_582_s10_q;
  logic [5:0] not_587_s10_q;
  logic [2:0] sum_592_s10_q;
  logic equal_603_s10_q;
  logic [5:0] not_608_s10_q;
  logic [2:0] sum_613_s10_q;
  logic [5:0] not_623_s10_q;
  logic [2:0] sum_628_s10_q;
  logic and_637_s10_q;
  logic [5:0] not_641_s10_q;
  logic [2:0] sum_646_s10_q;
  logic and_661_s10_q;
  logic [5:0] not_665_s10_q;
  logic [2:0] sum_670_s10_q;
  logic [5:0] not_680_s10_q;
  logic [2:0] sum_685_s10_q;
  logic [5:0] not_696_s10_q;
  logic [2:0] sum_701_s10_q;
  logic [5:0] not_720_s10_q;
  logic [2:0] sum_725_s10_q;
  logic [5:0] not_735_s10_q;
  logic [2:0] sum_740_s10_q;
  logic and_750_s10_q;
  logic [5:0] not_753_s10_q;
  logic [2:0] sum_758_s10_q;
  logic and_779_s10_q;
  logic [5:0] not_782_s10_q;
  logic [2:0] sum_787_s10_q;
  logic [5:0] not_797_s10_q;
  logic [2:0] sum_802_s10_q;
  logic [5:0] not_813_s10_q;
  logic [2:0] sum_818_s10_q;
  logic and_926_s10_q;
  logic [6:0] partner_s10_q;
  logic [6:0] select_929_s10_q;
  logic select_932_s10_q;
  logic equal_944_s10_q;
  logic and_949_s10_q;
  logic and_950_s10_q;
  logic and_952_s10_q;
  logic not_975_s10_q;
  logic equal_1011_s10_q;
  logic and_1144_s10_q;
  logic equal_1285_s10_q;
  logic equal_1337_s10_q;
  logic less_1614_s10_q;
  logic less_1616_s10_q;
  logic equal_1880_s10_q;
  logic less_1891_s10_q;
  logic equal_2034_s10_q;
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
      x_s10_2_q <= x_s9_2_q;
      select_529_s10_q <= select_529_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_536_s10_q <= select_536_s9_q;
      and_542_s10_q <= and_542_s9_q;
      and_543_s10_q <= and_543_s9_q;
      not_548_s10_q <= not_548_s9_q[7:2];
      sum_553_s10_q <= sum_553;
      and_561_s10_q <= and_561_s9_q;
      and_562_s10_q <= and_562_s9_q;
      not_567_s10_q <= not_567_s9_q[7:2];
      sum_572_s10_q <= sum_572;
      and_581_s10_q <= and_581_s9_q;
      and_582_s10_q <= and_582_s9_q;
      not_587_s10_q <= not_587_s9_q[7:2];
      sum_592_s10_q <= sum_592;
      equal_603_s10_q <= equal_603_s9_q;
      not_608_s10_q <= not_608_s9_q[7:2];
      sum_613_s10_q <= sum_613;
      not_623_s10_q <= not_623_s9_q[7:2];
      sum_628_s10_q <= sum_628;
      and_637_s10_q <= and_637_s9_q;
      not_641_s10_q <= not_641_s9_q[7:2];
      sum_646_s10_q <= sum_646;
      and_661_s10_q <= and_661_s9_q;
      not_665_s10_q <= not_665_s9_q[7:2];
      sum_670_s10_q <= sum_670;
      not_680_s10_q <= not_680_s9_q[7:2];
      sum_685_s10_q <= sum_685;
      not_696_s10_q <= not_696_s9_q[7:2];
      sum_701_s10_q <= sum_701;
      not_720_s10_q <= not_720_s9_q[7:2];
      sum_725_s10_q <= sum_725;
      not_735_s10_q <= not_735_s9_q[7:2];
      sum_740_s10_q <= sum_740;
      and_750_s10_q <= and_750_s9_q;
      not_753_s10_q <= not_753_s9_q[7:2];
      sum_758_s10_q <= sum_758;
      and_779_s10_q <= and_779_s9_q;
      not_782_s10_q <= not_782_s9_q[7:2];
      sum_787_s10_q <= sum_787;
      not_797_s10_q <= not_797_s9_q[7:2];
      sum_802_s10_q <= sum_802;
      not_813_s10_q <= not_813_s9_q[7:2];
      sum_818_s10_q <= sum_818;
      and_926_s10_q <= and_926_s9_q;
      partner_s10_q <= partner;
      select_929_s10_q <= or_381_s9_q ? sum_927 : partner;
      select_932_s10_q <= select_932_s9_q;
      equal_944_s10_q <= equal_944_s9_q;
      and_949_s10_q <= and_949_s9_q;
      and_950_s10_q <= and_950_s9_q;
      and_952_s10_q <= and_952_s9_q;
      not_975_s10_q <= not_975_s9_q;
      equal_1011_s10_q <= equal_1011_s9_q;
      and_1144_s10_q <= and_1144_s9_q;
      equal_1285_s10_q <= equal_1285_s9_q;
      equal_1337_s10_q <= equal_1337_s9_q;
      less_1614_s10_q <= less_1614_s9_q;
      less_1616_s10_q <= less_1616_s9_q;
      equal_1880_s10_q <= equal_1880_s9_q;
      less_1891_s10_q <= less_1891_s9_q;
      equal_2034_s10_q <= equal_2034_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:424
  logic [2:0] sum_554;
  assign sum_554 = {2'h0, not_548_s10_q[0]} + sum_553_s10_q;
  logic [2:0] sum_573;
  assign sum_573 = {2'h0, not_567_s10_q[0]} + sum_572_s10_q;
  logic [2:0] sum_593;
  assign sum_593 = {2'h0, not_587_s10_q[0]} + sum_592_s10_q;
  logic [2:0] sum_614;
  assign sum_614 = {2'h0, not_608_s10_q[0]} + sum_613_s10_q;
  logic [2:0] sum_629;
  assign sum_629 = {2'h0, not_623_s10_q[0]} + sum_628_s10_q;
  logic [2:0] sum_647;
  assign sum_647 = {2'h0, not_641_s10_q[0]} + sum_646_s10_q;
  logic [2:0] sum_671;
  assign sum_671 = {2'h0, not_665_s10_q[0]} + sum_670_s10_q;
  logic [2:0] sum_686;
  assign sum_686 = {2'h0, not_680_s10_q[0]} + sum_685_s10_q;
  logic [2:0] sum_702;
  assign sum_702 = {2'h0, not_696_s10_q[0]} + sum_701_s10_q;
  logic [2:0] sum_726;
  assign sum_726 = {2'h0, not_720_s10_q[0]} + sum_725_s10_q;
  logic [2:0] sum_741;
  assign sum_741 = {2'h0, not_735_s10_q[0]} + sum_740_s10_q;
  logic [2:0] sum_759;
  assign sum_759 = {2'h0, not_753_s10_q[0]} + sum_758_s10_q;
  logic [2:0] sum_788;
  assign sum_788 = {2'h0, not_782_s10_q[0]} + sum_787_s10_q;
  logic [2:0] sum_803;
  assign sum_803 = {2'h0, not_797_s10_q[0]} + sum_802_s10_q;
  logic [2:0] sum_819;
  assign sum_819 = {2'h0, not_813_s10_q[0]} + sum_818_s10_q;

  // Memory best_right, 120 x 15, DISTANCE 32, hls/stages/agreement.hpp:920; read in stage 10, written in stage 21: 10 < 21 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 15'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = select_929_s10_q;
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
  logic [2:0] age_s11_q;
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
  logic [6:0] x_s11_2_q;
  logic select_529_s11_q;
  logic [34:0] best_left_rdata_s11_q;
  logic select_536_s11_q;
  logic and_542_s11_q;
  logic and_543_s11_q;
  logic [3:0] not_548_s11_q;
  logic [3:0] sum_555_s11_q;
  logic and_561_s11_q;
  logic and_562_s11_q;
  logic [3:0] not_567_s11_q;
  logic [3:0] sum_574_s11_q;
  logic and_581_s11_q;
  logic and_582_s11_q;
  logic [3:0] not_587_s11_q;
  logic [3:0] sum_594_s11_q;
  logic equal_603_s11_q;
  logic [3:0] not_608_s11_q;
  logic [3:0] sum_615_s11_q;
  logic [3:0] not_623_s11_q;
  logic [3:0] sum_630_s11_q;
  logic and_637_s11_q;
  logic [3:0] not_641_s11_q;
  logic [3:0] sum_648_s11_q;
  logic and_661_s11_q;
  logic [3:0] not_665_s11_q;
  logic [3:0] sum_672_s11_q;
  logic [3:0] not_680_s11_q;
  logic [3:0] sum_687_s11_q;
  logic [3:0] not_696_s11_q;
  logic [3:0] sum_703_s11_q;
  logic [3:0] not_720_s11_q;
  logic [3:0] sum_727_s11_q;
  logic [3:0] not_735_s11_q;
  logic [3:0] sum_742_s11_q;
  logic and_750_s11_q;
  logic [3:0] not_753_s11_q;
  logic [3:0] sum_760_s11_q;
  logic and_779_s11_q;
  logic [3:0] not_782_s11_q;
  logic [3:0] sum_789_s11_q;
  logic [3:0] not_797_s11_q;
  logic [3:0] sum_804_s11_q;
  logic [3:0] not_813_s11_q;
  logic [3:0] sum_820_s11_q;
  logic and_926_s11_q;
  logic [6:0] partner_s11_q;
  logic select_932_s11_q;
  logic equal_944_s11_q;
  logic and_949_s11_q;
  logic and_950_s11_q;
  logic and_952_s11_q;
  logic not_975_s11_q;
  logic equal_1011_s11_q;
  logic and_1144_s11_q;
  logic equal_1285_s11_q;
  logic equal_1337_s11_q;
  logic less_1614_s11_q;
  logic less_1616_s11_q;
  logic equal_1880_s11_q;
  logic less_1891_s11_q;
  logic equal_2034_s11_q;
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
      x_s11_2_q <= x_s10_2_q;
      select_529_s11_q <= select_529_s10_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_536_s11_q <= select_536_s10_q;
      and_542_s11_q <= and_542_s10_q;
      and_543_s11_q <= and_543_s10_q;
      not_548_s11_q <= not_548_s10_q[5:2];
      sum_555_s11_q <= {3'h0, not_548_s10_q[1]} + {1'b0, sum_554};
      and_561_s11_q <= and_561_s10_q;
      and_562_s11_q <= and_562_s10_q;
      not_567_s11_q <= not_567_s10_q[5:2];
      sum_574_s11_q <= {3'h0, not_567_s10_q[1]} + {1'b0, sum_573};
      and_581_s11_q <= and_581_s10_q;
      and_582_s11_q <= and_582_s10_q;
      not_587_s11_q <= not_587_s10_q[5:2];
      sum_594_s11_q <= {3'h0, not_587_s10_q[1]} + {1'b0, sum_593};
      equal_603_s11_q <= equal_603_s10_q;
      not_608_s11_q <= not_608_s10_q[5:2];
      sum_615_s11_q <= {3'h0, not_608_s10_q[1]} + {1'b0, sum_614};
      not_623_s11_q <= not_623_s10_q[5:2];
      sum_630_s11_q <= {3'h0, not_623_s10_q[1]} + {1'b0, sum_629};
      and_637_s11_q <= and_637_s10_q;
      not_641_s11_q <= not_641_s10_q[5:2];
      sum_648_s11_q <= {3'h0, not_641_s10_q[1]} + {1'b0, sum_647};
      and_661_s11_q <= and_661_s10_q;
      not_665_s11_q <= not_665_s10_q[5:2];
      sum_672_s11_q <= {3'h0, not_665_s10_q[1]} + {1'b0, sum_671};
      not_680_s11_q <= not_680_s10_q[5:2];
      sum_687_s11_q <= {3'h0, not_680_s10_q[1]} + {1'b0, sum_686};
      not_696_s11_q <= not_696_s10_q[5:2];
      sum_703_s11_q <= {3'h0, not_696_s10_q[1]} + {1'b0, sum_702};
      not_720_s11_q <= not_720_s10_q[5:2];
      sum_727_s11_q <= {3'h0, not_720_s10_q[1]} + {1'b0, sum_726};
      not_735_s11_q <= not_735_s10_q[5:2];
      sum_742_s11_q <= {3'h0, not_735_s10_q[1]} + {1'b0, sum_741};
      and_750_s11_q <= and_750_s10_q;
      not_753_s11_q <= not_753_s10_q[5:2];
      sum_760_s11_q <= {3'h0, not_753_s10_q[1]} + {1'b0, sum_759};
      and_779_s11_q <= and_779_s10_q;
      not_782_s11_q <= not_782_s10_q[5:2];
      sum_789_s11_q <= {3'h0, not_782_s10_q[1]} + {1'b0, sum_788};
      not_797_s11_q <= not_797_s10_q[5:2];
      sum_804_s11_q <= {3'h0, not_797_s10_q[1]} + {1'b0, sum_803};
      not_813_s11_q <= not_813_s10_q[5:2];
      sum_820_s11_q <= {3'h0, not_813_s10_q[1]} + {1'b0, sum_819};
      and_926_s11_q <= and_926_s10_q;
      partner_s11_q <= partner_s10_q;
      select_932_s11_q <= select_932_s10_q;
      equal_944_s11_q <= equal_944_s10_q;
      and_949_s11_q <= and_949_s10_q;
      and_950_s11_q <= and_950_s10_q;
      and_952_s11_q <= and_952_s10_q;
      not_975_s11_q <= not_975_s10_q;
      equal_1011_s11_q <= equal_1011_s10_q;
      and_1144_s11_q <= and_1144_s10_q;
      equal_1285_s11_q <= equal_1285_s10_q;
      equal_1337_s11_q <= equal_1337_s10_q;
      less_1614_s11_q <= less_1614_s10_q;
      less_1616_s11_q <= less_1616_s10_q;
      equal_1880_s11_q <= equal_1880_s10_q;
      less_1891_s11_q <= less_1891_s10_q;
      equal_2034_s11_q <= equal_2034_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:424
  logic [3:0] sum_557;
  assign sum_557 = {3'h0, not_548_s11_q[1]} + ({3'h0, not_548_s11_q[0]} + sum_555_s11_q);
  logic [3:0] sum_576;
  assign sum_576 = {3'h0, not_567_s11_q[1]} + ({3'h0, not_567_s11_q[0]} + sum_574_s11_q);
  logic [3:0] sum_596;
  assign sum_596 = {3'h0, not_587_s11_q[1]} + ({3'h0, not_587_s11_q[0]} + sum_594_s11_q);
  logic [3:0] sum_617;
  assign sum_617 = {3'h0, not_608_s11_q[1]} + ({3'h0, not_608_s11_q[0]} + sum_615_s11_q);
  logic [3:0] sum_632;
  assign sum_632 = {3'h0, not_623_s11_q[1]} + ({3'h0, not_623_s11_q[0]} + sum_630_s11_q);
  logic [3:0] sum_650;
  assign sum_650 = {3'h0, not_641_s11_q[1]} + ({3'h0, not_641_s11_q[0]} + sum_648_s11_q);
  logic [3:0] sum_674;
  assign sum_674 = {3'h0, not_665_s11_q[1]} + ({3'h0, not_665_s11_q[0]} + sum_672_s11_q);
  logic [3:0] sum_689;
  assign sum_689 = {3'h0, not_680_s11_q[1]} + ({3'h0, not_680_s11_q[0]} + sum_687_s11_q);
  logic [3:0] sum_705;
  assign sum_705 = {3'h0, not_696_s11_q[1]} + ({3'h0, not_696_s11_q[0]} + sum_703_s11_q);
  logic [3:0] sum_729;
  assign sum_729 = {3'h0, not_720_s11_q[1]} + ({3'h0, not_720_s11_q[0]} + sum_727_s11_q);
  logic [3:0] sum_744;
  assign sum_744 = {3'h0, not_735_s11_q[1]} + ({3'h0, not_735_s11_q[0]} + sum_742_s11_q);
  logic [3:0] sum_762;
  assign sum_762 = {3'h0, not_753_s11_q[1]} + ({3'h0, not_753_s11_q[0]} + sum_760_s11_q);
  logic [3:0] sum_791;
  assign sum_791 = {3'h0, not_782_s11_q[1]} + ({3'h0, not_782_s11_q[0]} + sum_789_s11_q);
  logic [3:0] sum_806;
  assign sum_806 = {3'h0, not_797_s11_q[1]} + ({3'h0, not_797_s11_q[0]} + sum_804_s11_q);
  logic [3:0] sum_822;
  assign sum_822 = {3'h0, not_813_s11_q[1]} + ({3'h0, not_813_s11_q[0]} + sum_820_s11_q);

  logic [7:0] pixel_0_s12_q;
  logic [7:0] pixel_1_s12_q;
  logic saturated_s12_q;
  logic mask_s12_q;
  logic marks_first_s12_q;
  logic marks_last_s12_q;
  logic sample_pair_whole_s12_q;
  logic [5:0] run_shift_s12_q;
  logic [7:0] x_s12_q;
  logic [2:0] age_s12_q;
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
  logic [6:0] x_s12_2_q;
  logic select_529_s12_q;
  logic [34:0] best_left_rdata_s12_q;
  logic select_536_s12_q;
  logic and_542_s12_q;
  logic and_543_s12_q;
  logic [1:0] not_548_s12_q;
  logic [3:0] sum_557_s12_q;
  logic and_561_s12_q;
  logic and_562_s12_q;
  logic [1:0] not_567_s12_q;
  logic [3:0] sum_576_s12_q;
  logic and_581_s12_q;
  logic and_582_s12_q;
  logic [1:0] not_587_s12_q;
  logic [3:0] sum_596_s12_q;
  logic equal_603_s12_q;
  logic [1:0] not_608_s12_q;
  logic [3:0] sum_617_s12_q;
  logic [1:0] not_623_s12_q;
  logic [3:0] sum_632_s12_q;
  logic and_637_s12_q;
  logic [1:0] not_641_s12_q;
  logic [3:0] sum_650_s12_q;
  logic and_661_s12_q;
  logic [1:0] not_665_s12_q;
  logic [3:0] sum_674_s12_q;
  logic [1:0] not_680_s12_q;
  logic [3:0] sum_689_s12_q;
  logic [1:0] not_696_s12_q;
  logic [3:0] sum_705_s12_q;
  logic [1:0] not_720_s12_q;
  logic [3:0] sum_729_s12_q;
  logic [1:0] not_735_s12_q;
  logic [3:0] sum_744_s12_q;
  logic and_750_s12_q;
  logic [1:0] not_753_s12_q;
  logic [3:0] sum_762_s12_q;
  logic and_779_s12_q;
  logic [1:0] not_782_s12_q;
  logic [3:0] sum_791_s12_q;
  logic [1:0] not_797_s12_q;
  logic [3:0] sum_806_s12_q;
  logic [1:0] not_813_s12_q;
  logic [3:0] sum_822_s12_q;
  logic and_926_s12_q;
  logic [6:0] partner_s12_q;
  logic [14:0] best_right_rdata_s12_q;
  logic select_932_s12_q;
  logic equal_944_s12_q;
  logic and_949_s12_q;
  logic and_950_s12_q;
  logic and_952_s12_q;
  logic not_975_s12_q;
  logic equal_1011_s12_q;
  logic and_1144_s12_q;
  logic equal_1285_s12_q;
  logic equal_1337_s12_q;
  logic less_1614_s12_q;
  logic less_1616_s12_q;
  logic equal_1880_s12_q;
  logic less_1891_s12_q;
  logic equal_2034_s12_q;
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
      x_s12_2_q <= x_s11_2_q;
      select_529_s12_q <= select_529_s11_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_536_s12_q <= select_536_s11_q;
      and_542_s12_q <= and_542_s11_q;
      and_543_s12_q <= and_543_s11_q;
      not_548_s12_q <= not_548_s11_q[3:2];
      sum_557_s12_q <= sum_557;
      and_561_s12_q <= and_561_s11_q;
      and_562_s12_q <= and_562_s11_q;
      not_567_s12_q <= not_567_s11_q[3:2];
      sum_576_s12_q <= sum_576;
      and_581_s12_q <= and_581_s11_q;
      and_582_s12_q <= and_582_s11_q;
      not_587_s12_q <= not_587_s11_q[3:2];
      sum_596_s12_q <= sum_596;
      equal_603_s12_q <= equal_603_s11_q;
      not_608_s12_q <= not_608_s11_q[3:2];
      sum_617_s12_q <= sum_617;
      not_623_s12_q <= not_623_s11_q[3:2];
      sum_632_s12_q <= sum_632;
      and_637_s12_q <= and_637_s11_q;
      not_641_s12_q <= not_641_s11_q[3:2];
      sum_650_s12_q <= sum_650;
      and_661_s12_q <= and_661_s11_q;
      not_665_s12_q <= not_665_s11_q[3:2];
      sum_674_s12_q <= sum_674;
      not_680_s12_q <= not_680_s11_q[3:2];
      sum_689_s12_q <= sum_689;
      not_696_s12_q <= not_696_s11_q[3:2];
      sum_705_s12_q <= sum_705;
      not_720_s12_q <= not_720_s11_q[3:2];
      sum_729_s12_q <= sum_729;
      not_735_s12_q <= not_735_s11_q[3:2];
      sum_744_s12_q <= sum_744;
      and_750_s12_q <= and_750_s11_q;
      not_753_s12_q <= not_753_s11_q[3:2];
      sum_762_s12_q <= sum_762;
      and_779_s12_q <= and_779_s11_q;
      not_782_s12_q <= not_782_s11_q[3:2];
      sum_791_s12_q <= sum_791;
      not_797_s12_q <= not_797_s11_q[3:2];
      sum_806_s12_q <= sum_806;
      not_813_s12_q <= not_813_s11_q[3:2];
      sum_822_s12_q <= sum_822;
      and_926_s12_q <= and_926_s11_q;
      partner_s12_q <= partner_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      select_932_s12_q <= select_932_s11_q;
      equal_944_s12_q <= equal_944_s11_q;
      and_949_s12_q <= and_949_s11_q;
      and_950_s12_q <= and_950_s11_q;
      and_952_s12_q <= and_952_s11_q;
      not_975_s12_q <= not_975_s11_q;
      equal_1011_s12_q <= equal_1011_s11_q;
      and_1144_s12_q <= and_1144_s11_q;
      equal_1285_s12_q <= equal_1285_s11_q;
      equal_1337_s12_q <= equal_1337_s11_q;
      less_1614_s12_q <= less_1614_s11_q;
      less_1616_s12_q <= less_1616_s11_q;
      equal_1880_s12_q <= equal_1880_s11_q;
      less_1891_s12_q <= less_1891_s11_q;
      equal_2034_s12_q <= equal_2034_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:424
  logic [3:0] sum_559;
  assign sum_559 = {3'h0, not_548_s12_q[1]} + ({3'h0, not_548_s12_q[0]} + sum_557_s12_q);
  logic [3:0] column_2;
  assign column_2 = (and_542_s12_q & and_543_s12_q) ? sum_559 : 4'h0;
  logic [3:0] sum_578;
  assign sum_578 = {3'h0, not_567_s12_q[1]} + ({3'h0, not_567_s12_q[0]} + sum_576_s12_q);
  logic [3:0] sum_598;
  assign sum_598 = {3'h0, not_587_s12_q[1]} + ({3'h0, not_587_s12_q[0]} + sum_596_s12_q);
  logic [3:0] sum_619;
  assign sum_619 = {3'h0, not_608_s12_q[1]} + ({3'h0, not_608_s12_q[0]} + sum_617_s12_q);
  logic [3:0] column_5;
  assign column_5 = (and_542_s12_q & and_562_s12_q) ? sum_619 : 4'h0;
  logic [3:0] sum_634;
  assign sum_634 = {3'h0, not_623_s12_q[1]} + ({3'h0, not_623_s12_q[0]} + sum_632_s12_q);
  logic [3:0] sum_652;
  assign sum_652 = {3'h0, not_641_s12_q[1]} + ({3'h0, not_641_s12_q[0]} + sum_650_s12_q);
  logic [3:0] sum_676;
  assign sum_676 = {3'h0, not_665_s12_q[1]} + ({3'h0, not_665_s12_q[0]} + sum_674_s12_q);
  logic [3:0] column_8;
  assign column_8 = (and_542_s12_q & and_661_s12_q) ? sum_676 : 4'h0;
  logic [3:0] sum_691;
  assign sum_691 = {3'h0, not_680_s12_q[1]} + ({3'h0, not_680_s12_q[0]} + sum_689_s12_q);
  logic [3:0] sum_707;
  assign sum_707 = {3'h0, not_696_s12_q[1]} + ({3'h0, not_696_s12_q[0]} + sum_705_s12_q);
  logic [3:0] sum_731;
  assign sum_731 = {3'h0, not_720_s12_q[1]} + ({3'h0, not_720_s12_q[0]} + sum_729_s12_q);
  logic [3:0] column_11;
  assign column_11 = (and_542_s12_q & and_582_s12_q) ? sum_731 : 4'h0;
  logic [3:0] sum_746;
  assign sum_746 = {3'h0, not_735_s12_q[1]} + ({3'h0, not_735_s12_q[0]} + sum_744_s12_q);
  logic [3:0] sum_764;
  assign sum_764 = {3'h0, not_753_s12_q[1]} + ({3'h0, not_753_s12_q[0]} + sum_762_s12_q);
  logic [3:0] sum_793;
  assign sum_793 = {3'h0, not_782_s12_q[1]} + ({3'h0, not_782_s12_q[0]} + sum_791_s12_q);
  logic [3:0] column_14;
  assign column_14 = and_779_s12_q ? sum_793 : 4'h0;
  logic [3:0] sum_808;
  assign sum_808 = {3'h0, not_797_s12_q[1]} + ({3'h0, not_797_s12_q[0]} + sum_806_s12_q);
  logic [3:0] sum_824;
  assign sum_824 = {3'h0, not_813_s12_q[1]} + ({3'h0, not_813_s12_q[0]} + sum_822_s12_q);
  // hls/stages/agreement.hpp:621
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_s12_q[14:8]} - {1'b0, x_s12_q};
  // hls/stages/agreement.hpp:625
  logic and_962;
  assign and_962 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s12_q[13:8]));

  logic [7:0] pixel_0_s13_q;
  logic [7:0] pixel_1_s13_q;
  logic saturated_s13_q;
  logic mask_s13_q;
  logic marks_first_s13_q;
  logic marks_last_s13_q;
  logic sample_pair_whole_s13_q;
  logic [5:0] run_shift_s13_q;
  logic [7:0] x_s13_q;
  logic [2:0] age_s13_q;
  logic lower_half_s13_q;
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
  logic [6:0] x_s13_2_q;
  logic select_529_s13_q;
  logic [34:0] best_left_rdata_s13_q;
  logic select_536_s13_q;
  logic [3:0] column_2_s13_q;
  logic [3:0] select_579_s13_q;
  logic [3:0] select_599_s13_q;
  logic equal_603_s13_q;
  logic [3:0] column_5_s13_q;
  logic [3:0] select_635_s13_q;
  logic [3:0] select_653_s13_q;
  logic [3:0] column_8_s13_q;
  logic [3:0] select_692_s13_q;
  logic [3:0] select_708_s13_q;
  logic [3:0] column_11_s13_q;
  logic [3:0] select_747_s13_q;
  logic [3:0] select_765_s13_q;
  logic [3:0] column_14_s13_q;
  logic [3:0] select_809_s13_q;
  logic [3:0] select_825_s13_q;
  logic and_926_s13_q;
  logic [6:0] partner_s13_q;
  logic [14:0] best_right_rdata_s13_q;
  logic select_932_s13_q;
  logic equal_944_s13_q;
  logic and_949_s13_q;
  logic and_950_s13_q;
  logic and_952_s13_q;
  logic [8:0] way_s13_q;
  logic and_962_s13_q;
  logic not_975_s13_q;
  logic equal_1011_s13_q;
  logic and_1144_s13_q;
  logic equal_1285_s13_q;
  logic equal_1337_s13_q;
  logic less_1614_s13_q;
  logic less_1616_s13_q;
  logic equal_1880_s13_q;
  logic less_1891_s13_q;
  logic equal_2034_s13_q;
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
      x_s13_2_q <= x_s12_2_q;
      select_529_s13_q <= select_529_s12_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_536_s13_q <= select_536_s12_q;
      column_2_s13_q <= column_2;
      select_579_s13_q <= (and_561_s12_q & and_562_s12_q) ? sum_578 : 4'h0;
      select_599_s13_q <= (and_581_s12_q & and_582_s12_q) ? sum_598 : 4'h0;
      equal_603_s13_q <= equal_603_s12_q;
      column_5_s13_q <= column_5;
      select_635_s13_q <= (and_561_s12_q & and_582_s12_q) ? sum_634 : 4'h0;
      select_653_s13_q <= (and_581_s12_q & and_637_s12_q) ? sum_652 : 4'h0;
      column_8_s13_q <= column_8;
      select_692_s13_q <= (and_561_s12_q & and_543_s12_q) ? sum_691 : 4'h0;
      select_708_s13_q <= (and_581_s12_q & and_562_s12_q) ? sum_707 : 4'h0;
      column_11_s13_q <= column_11;
      select_747_s13_q <= (and_561_s12_q & and_637_s12_q) ? sum_746 : 4'h0;
      select_765_s13_q <= and_750_s12_q ? sum_764 : 4'h0;
      column_14_s13_q <= column_14;
      select_809_s13_q <= (and_561_s12_q & and_661_s12_q) ? sum_808 : 4'h0;
      select_825_s13_q <= (and_581_s12_q & and_543_s12_q) ? sum_824 : 4'h0;
      and_926_s13_q <= and_926_s12_q;
      partner_s13_q <= partner_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_932_s13_q <= select_932_s12_q;
      equal_944_s13_q <= equal_944_s12_q;
      and_949_s13_q <= and_949_s12_q;
      and_950_s13_q <= and_950_s12_q;
      and_952_s13_q <= and_952_s12_q;
      way_s13_q <= way;
      and_962_s13_q <= and_962;
      not_975_s13_q <= not_975_s12_q;
      equal_1011_s13_q <= equal_1011_s12_q;
      and_1144_s13_q <= and_1144_s12_q;
      equal_1285_s13_q <= equal_1285_s12_q;
      equal_1337_s13_q <= equal_1337_s12_q;
      less_1614_s13_q <= less_1614_s12_q;
      less_1616_s13_q <= less_1616_s12_q;
      equal_1880_s13_q <= equal_1880_s12_q;
      less_1891_s13_q <= less_1891_s12_q;
      equal_2034_s13_q <= equal_2034_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [23:0] registration_next_slope_row_q;
  logic [27:0] registration_next_slope_change_q;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_3;
  assign column_3 = {1'b0, column_2_s13_q} + {1'b0, select_579_s13_q};
  logic [5:0] column_4;
  assign column_4 = {1'b0, column_3} + {2'h0, select_599_s13_q};
  logic [4:0] column_6;
  assign column_6 = {1'b0, column_5_s13_q} + {1'b0, select_635_s13_q};
  logic [5:0] column_7;
  assign column_7 = {1'b0, column_6} + {2'h0, select_653_s13_q};
  logic [4:0] column_9;
  assign column_9 = {1'b0, column_8_s13_q} + {1'b0, select_692_s13_q};
  logic [5:0] column_10;
  assign column_10 = {1'b0, column_9} + {2'h0, select_708_s13_q};
  logic [4:0] column_12;
  assign column_12 = {1'b0, column_11_s13_q} + {1'b0, select_747_s13_q};
  logic [5:0] column_13;
  assign column_13 = {1'b0, column_12} + {2'h0, select_765_s13_q};
  logic [4:0] column_15;
  assign column_15 = {1'b0, column_14_s13_q} + {1'b0, select_809_s13_q};
  logic [5:0] column_16;
  assign column_16 = {1'b0, column_15} + {2'h0, select_825_s13_q};
  // hls/stages/agreement.hpp:622
  logic [9:0] sum_954;
  assign sum_954 = {way_s13_q[8], way_s13_q} + 10'h1;
  // hls/stages/registration.hpp:158
  logic [16:0] select_1623;
  assign select_1623 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/registration.hpp:57
  logic [23:0] select_1881;
  assign select_1881 = equal_1880_s13_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:205
  logic [23:0] select_1883;
  assign select_1883 = and_360_s13_q ? (equal_1337_s13_q ? select_1881 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1884;
  assign select_1884 = equal_1880_s13_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:205
  logic [27:0] select_1886;
  assign select_1886 = and_360_s13_q ? (equal_1337_s13_q ? select_1884 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1888;
  assign select_1888 = drew_s13_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1889;
  assign sum_1889 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1890;
  assign sum_1890 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      registration_next_slope_row_q <= 24'h0;
      registration_next_slope_change_q <= 28'h0;
    end else if (s13_en) begin
      registration_slope_row_q <= select_1883;
      registration_slope_change_q <= select_1886;
      registration_slope_q <= select_1888;
      registration_next_slope_row_q <= sum_1889;
      registration_next_slope_change_q <= sum_1890;
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
  logic [2:0] age_s14_q;
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
  logic select_529_s14_q;
  logic [34:0] best_left_rdata_s14_q;
  logic select_536_s14_q;
  logic [5:0] column_4_s14_q;
  logic equal_603_s14_q;
  logic [5:0] column_7_s14_q;
  logic [5:0] column_10_s14_q;
  logic [5:0] column_13_s14_q;
  logic [5:0] column_16_s14_q;
  logic and_926_s14_q;
  logic [6:0] partner_s14_q;
  logic [14:0] best_right_rdata_s14_q;
  logic select_932_s14_q;
  logic equal_944_s14_q;
  logic and_949_s14_q;
  logic and_950_s14_q;
  logic and_952_s14_q;
  logic less_955_s14_q;
  logic less_956_s14_q;
  logic or_963_s14_q;
  logic not_975_s14_q;
  logic equal_1011_s14_q;
  logic and_1144_s14_q;
  logic equal_1285_s14_q;
  logic equal_1337_s14_q;
  logic less_1614_s14_q;
  logic less_1616_s14_q;
  logic [16:0] select_1623_s14_q;
  logic less_1891_s14_q;
  logic equal_2034_s14_q;
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
      registration_slope_s14_q <= registration_slope_q[27:16];
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
      select_529_s14_q <= select_529_s13_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_536_s14_q <= select_536_s13_q;
      column_4_s14_q <= column_4;
      equal_603_s14_q <= equal_603_s13_q;
      column_7_s14_q <= column_7;
      column_10_s14_q <= column_10;
      column_13_s14_q <= column_13;
      column_16_s14_q <= column_16;
      and_926_s14_q <= and_926_s13_q;
      partner_s14_q <= partner_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_932_s14_q <= select_932_s13_q;
      equal_944_s14_q <= equal_944_s13_q;
      and_949_s14_q <= and_949_s13_q;
      and_950_s14_q <= and_950_s13_q;
      and_952_s14_q <= and_952_s13_q;
      less_955_s14_q <= {{6{sum_954[9]}}, sum_954} < 16'h3;
      less_956_s14_q <= 8'hb6 < best_left_rdata_s13_q[7:0];
      or_963_s14_q <= (cfg_nearer_below_i & best_left_rdata_s13_q[13]) | and_962_s13_q;
      not_975_s14_q <= not_975_s13_q;
      equal_1011_s14_q <= equal_1011_s13_q;
      and_1144_s14_q <= and_1144_s13_q;
      equal_1285_s14_q <= equal_1285_s13_q;
      equal_1337_s14_q <= equal_1337_s13_q;
      less_1614_s14_q <= less_1614_s13_q;
      less_1616_s14_q <= less_1616_s13_q;
      select_1623_s14_q <= select_1623;
      less_1891_s14_q <= less_1891_s13_q;
      equal_2034_s14_q <= equal_2034_s13_q;
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
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_602;
  assign difference_602 = {2'h0, column_4_s14_q} - (age_s14_q[2] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] difference_656;
  assign difference_656 = {2'h0, column_7_s14_q} - (age_s14_q[2] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] difference_711;
  assign difference_711 = {2'h0, column_10_s14_q} - (age_s14_q[2] ? sums_3_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_889;
  assign sum_889 = (age_s14_q[0] ? sums_2_columns_values_3_q[6:0] : 7'h0) + (sums_2_columns_values_1_q[6:0] + sums_2_columns_values_2_q[6:0]);
  logic [6:0] sum_892;
  assign sum_892 = (age_s14_q[0] ? sums_1_columns_values_3_q[6:0] : 7'h0) + (sums_1_columns_values_1_q[6:0] + sums_1_columns_values_2_q[6:0]);
  logic [6:0] sum_897;
  assign sum_897 = (age_s14_q[0] ? sums_3_columns_values_3_q[6:0] : 7'h0) + (sums_3_columns_values_1_q[6:0] + sums_3_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:618
  logic and_951;
  assign and_951 = not_387_s14_q & and_950_s14_q;
  // hls/stages/agreement.hpp:613
  logic and_957;
  assign and_957 = less_955_s14_q & less_956_s14_q;
  // hls/stages/agreement.hpp:618
  logic and_959;
  assign and_959 = not_387_s14_q & (and_950_s14_q & and_957);
  logic and_966;
  assign and_966 = not_387_s14_q & (and_950_s14_q & (and_957 & or_963_s14_q));
  // hls/stages/agreement.hpp:181
  logic [5:0] select_967;
  assign select_967 = less_386_s14_q ? 6'h0 : best_left_rdata_s14_q[13:8];
  logic [11:0] select_968;
  assign select_968 = or_381_s14_q ? {select_967, and_966, and_959, and_952_s14_q, and_951, and_949_s14_q, not_387_s14_q} : 12'h0;
  logic [7:0] select_1451;
  assign select_1451 = equal_383_s14_q ? {2'h0, column_7_s14_q} : sums_1_columns_values_0_q;
  logic [7:0] select_1453;
  assign select_1453 = equal_383_s14_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1455;
  assign select_1455 = equal_383_s14_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1457;
  assign select_1457 = equal_383_s14_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1459;
  assign select_1459 = equal_383_s14_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1461;
  assign select_1461 = equal_383_s14_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1463;
  assign select_1463 = equal_383_s14_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1467;
  assign select_1467 = equal_383_s14_q ? {2'h0, column_4_s14_q} : sums_2_columns_values_0_q;
  logic [7:0] select_1469;
  assign select_1469 = equal_383_s14_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1471;
  assign select_1471 = equal_383_s14_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1473;
  assign select_1473 = equal_383_s14_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1475;
  assign select_1475 = equal_383_s14_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1477;
  assign select_1477 = equal_383_s14_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1479;
  assign select_1479 = equal_383_s14_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1483;
  assign select_1483 = equal_383_s14_q ? {2'h0, column_10_s14_q} : sums_3_columns_values_0_q;
  logic [7:0] select_1485;
  assign select_1485 = equal_383_s14_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1487;
  assign select_1487 = equal_383_s14_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1489;
  assign select_1489 = equal_383_s14_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1491;
  assign select_1491 = equal_383_s14_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1493;
  assign select_1493 = equal_383_s14_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1495;
  assign select_1495 = equal_383_s14_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  // hls/stages/registration.hpp:158
  logic [13:0] select_1625;
  assign select_1625 = ($signed(10'h0) < $signed(select_1623_s14_q[16:7])) ? 14'h7f : select_1623_s14_q[13:0];

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
      sums_1_columns_values_0_q <= or_381_s14_q ? sums_1_columns_values_0_q : select_1451;
      sums_1_columns_values_1_q <= or_381_s14_q ? sums_1_columns_values_1_q : select_1453;
      sums_1_columns_values_2_q <= or_381_s14_q ? sums_1_columns_values_2_q : select_1455;
      sums_1_columns_values_3_q <= or_381_s14_q ? sums_1_columns_values_3_q : select_1457;
      sums_1_columns_values_4_q <= or_381_s14_q ? sums_1_columns_values_4_q : select_1459;
      sums_1_columns_values_5_q <= or_381_s14_q ? sums_1_columns_values_5_q : select_1461;
      sums_1_columns_values_6_q <= or_381_s14_q ? sums_1_columns_values_6_q : select_1463;
      sums_2_columns_values_0_q <= or_381_s14_q ? sums_2_columns_values_0_q : select_1467;
      sums_2_columns_values_1_q <= or_381_s14_q ? sums_2_columns_values_1_q : select_1469;
      sums_2_columns_values_2_q <= or_381_s14_q ? sums_2_columns_values_2_q : select_1471;
      sums_2_columns_values_3_q <= or_381_s14_q ? sums_2_columns_values_3_q : select_1473;
      sums_2_columns_values_4_q <= or_381_s14_q ? sums_2_columns_values_4_q : select_1475;
      sums_2_columns_values_5_q <= or_381_s14_q ? sums_2_columns_values_5_q : select_1477;
      sums_2_columns_values_6_q <= or_381_s14_q ? sums_2_columns_values_6_q : select_1479;
      sums_3_columns_values_0_q <= or_381_s14_q ? sums_3_columns_values_0_q : select_1483;
      sums_3_columns_values_1_q <= or_381_s14_q ? sums_3_columns_values_1_q : select_1485;
      sums_3_columns_values_2_q <= or_381_s14_q ? sums_3_columns_values_2_q : select_1487;
      sums_3_columns_values_3_q <= or_381_s14_q ? sums_3_columns_values_3_q : select_1489;
      sums_3_columns_values_4_q <= or_381_s14_q ? sums_3_columns_values_4_q : select_1491;
      sums_3_columns_values_5_q <= or_381_s14_q ? sums_3_columns_values_5_q : select_1493;
      sums_3_columns_values_6_q <= or_381_s14_q ? sums_3_columns_values_6_q : select_1495;
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
  logic [2:0] age_s15_q;
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
  logic equal_380_s15_q;
  logic or_381_s15_q;
  logic equal_383_s15_q;
  logic less_386_s15_q;
  logic not_387_s15_q;
  logic equal_419_s15_q;
  logic [6:0] x_s15_2_q;
  logic select_529_s15_q;
  logic [34:0] best_left_rdata_s15_q;
  logic select_536_s15_q;
  logic [7:0] difference_602_s15_q;
  logic equal_603_s15_q;
  logic [7:0] difference_656_s15_q;
  logic [7:0] difference_711_s15_q;
  logic [5:0] column_13_s15_q;
  logic [5:0] column_16_s15_q;
  logic [6:0] sum_889_s15_q;
  logic [6:0] sum_892_s15_q;
  logic [6:0] sum_897_s15_q;
  logic and_926_s15_q;
  logic [6:0] partner_s15_q;
  logic [14:0] best_right_rdata_s15_q;
  logic select_932_s15_q;
  logic equal_944_s15_q;
  logic and_950_s15_q;
  logic [11:0] select_968_s15_q;
  logic not_975_s15_q;
  logic equal_1011_s15_q;
  logic and_1144_s15_q;
  logic equal_1285_s15_q;
  logic equal_1337_s15_q;
  logic less_1614_s15_q;
  logic less_1616_s15_q;
  logic [9:0] select_1625_s15_q;
  logic [12:0] select_1629_s15_q;
  logic [12:0] select_1630_s15_q;
  logic [11:0] select_1632_s15_q;
  logic [10:0] select_1633_s15_q;
  logic less_1891_s15_q;
  logic equal_2034_s15_q;
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
      equal_380_s15_q <= equal_380_s14_q;
      or_381_s15_q <= or_381_s14_q;
      equal_383_s15_q <= equal_383_s14_q;
      less_386_s15_q <= less_386_s14_q;
      not_387_s15_q <= not_387_s14_q;
      equal_419_s15_q <= equal_419_s14_q;
      x_s15_2_q <= x_s14_2_q;
      select_529_s15_q <= select_529_s14_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_536_s15_q <= select_536_s14_q;
      difference_602_s15_q <= difference_602;
      equal_603_s15_q <= equal_603_s14_q;
      difference_656_s15_q <= difference_656;
      difference_711_s15_q <= difference_711;
      column_13_s15_q <= column_13_s14_q;
      column_16_s15_q <= column_16_s14_q;
      sum_889_s15_q <= sum_889;
      sum_892_s15_q <= sum_892;
      sum_897_s15_q <= sum_897;
      and_926_s15_q <= and_926_s14_q;
      partner_s15_q <= partner_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_932_s15_q <= select_932_s14_q;
      equal_944_s15_q <= equal_944_s14_q;
      and_950_s15_q <= and_950_s14_q;
      select_968_s15_q <= select_968;
      not_975_s15_q <= not_975_s14_q;
      equal_1011_s15_q <= equal_1011_s14_q;
      and_1144_s15_q <= and_1144_s14_q;
      equal_1285_s15_q <= equal_1285_s14_q;
      equal_1337_s15_q <= equal_1337_s14_q;
      less_1614_s15_q <= less_1614_s14_q;
      less_1616_s15_q <= less_1616_s14_q;
      select_1625_s15_q <= select_1625[9:0];
      select_1629_s15_q <= select_968[6] ? select_1625[13:1] : 13'h0;
      select_1630_s15_q <= select_968[7] ? select_1625[12:0] : 13'h0;
      select_1632_s15_q <= select_968[8] ? select_1625[11:0] : 12'h0;
      select_1633_s15_q <= select_968[9] ? select_1625[10:0] : 11'h0;
      less_1891_s15_q <= less_1891_s14_q;
      equal_2034_s15_q <= equal_2034_s14_q;
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
  // hls/stages/agreement.hpp:463
  logic [7:0] sum_605;
  assign sum_605 = difference_602_s15_q + (equal_603_s15_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  logic [7:0] sum_658;
  assign sum_658 = difference_656_s15_q + (equal_603_s15_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  logic [7:0] sum_713;
  assign sum_713 = difference_711_s15_q + (equal_603_s15_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  logic [7:0] difference_768;
  assign difference_768 = {2'h0, column_13_s15_q} - (age_s15_q[2] ? sums_0_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:478
  logic less_893;
  assign less_893 = sum_889_s15_q < sum_892_s15_q;
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_904;
  assign sum_904 = (age_s15_q[0] ? sums_0_columns_values_3_q[6:0] : 7'h0) + (sums_0_columns_values_1_q[6:0] + sums_0_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1435;
  assign select_1435 = equal_383_s15_q ? {2'h0, column_13_s15_q} : sums_0_columns_values_0_q;
  logic [7:0] select_1437;
  assign select_1437 = equal_383_s15_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1439;
  assign select_1439 = equal_383_s15_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1441;
  assign select_1441 = equal_383_s15_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1443;
  assign select_1443 = equal_383_s15_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1445;
  assign select_1445 = equal_383_s15_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1447;
  assign select_1447 = equal_383_s15_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1466;
  assign select_1466 = or_381_s15_q ? sums_1_sum_sums_values_0_q : (equal_383_s15_q ? sum_658 : sums_1_sum_sums_values_0_q);
  logic [7:0] select_1482;
  assign select_1482 = or_381_s15_q ? sums_2_sum_sums_values_0_q : (equal_383_s15_q ? sum_605 : sums_2_sum_sums_values_0_q);
  logic [7:0] select_1498;
  assign select_1498 = or_381_s15_q ? sums_3_sum_sums_values_0_q : (equal_383_s15_q ? sum_713 : sums_3_sum_sums_values_0_q);
  // hls/stages/registration.hpp:153
  logic [9:0] select_1626;
  assign select_1626 = select_968_s15_q[10] ? select_1625_s15_q : 10'h0;
  logic [8:0] difference_1628;
  assign difference_1628 = select_1626[9:1] - (select_968_s15_q[11] ? select_1625_s15_q[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1631;
  assign sum_1631 = select_1629_s15_q + select_1630_s15_q;
  // hls/stages/registration.hpp:152
  logic [10:0] sum_1634;
  assign sum_1634 = select_1632_s15_q[11:1] + select_1633_s15_q;
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1635;
  assign sum_1635 = sum_1631[12:1] + {sum_1634, select_1632_s15_q[0]};

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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s15_en) begin
      sums_0_columns_values_0_q <= or_381_s15_q ? sums_0_columns_values_0_q : select_1435;
      sums_0_columns_values_1_q <= or_381_s15_q ? sums_0_columns_values_1_q : select_1437;
      sums_0_columns_values_2_q <= or_381_s15_q ? sums_0_columns_values_2_q : select_1439;
      sums_0_columns_values_3_q <= or_381_s15_q ? sums_0_columns_values_3_q : select_1441;
      sums_0_columns_values_4_q <= or_381_s15_q ? sums_0_columns_values_4_q : select_1443;
      sums_0_columns_values_5_q <= or_381_s15_q ? sums_0_columns_values_5_q : select_1445;
      sums_0_columns_values_6_q <= or_381_s15_q ? sums_0_columns_values_6_q : select_1447;
      sums_1_sum_sums_values_0_q <= select_1466;
      sums_2_sum_sums_values_0_q <= select_1482;
      sums_3_sum_sums_values_0_q <= select_1498;
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
  logic [2:0] age_s16_q;
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
  logic equal_380_s16_q;
  logic or_381_s16_q;
  logic equal_383_s16_q;
  logic less_386_s16_q;
  logic not_387_s16_q;
  logic equal_419_s16_q;
  logic [6:0] x_s16_2_q;
  logic select_529_s16_q;
  logic [34:0] best_left_rdata_s16_q;
  logic select_536_s16_q;
  logic equal_603_s16_q;
  logic [7:0] sum_605_s16_q;
  logic [7:0] sum_658_s16_q;
  logic less_659_s16_q;
  logic [7:0] sum_713_s16_q;
  logic [7:0] difference_768_s16_q;
  logic [5:0] column_16_s16_q;
  logic [6:0] sum_889_s16_q;
  logic [6:0] sum_892_s16_q;
  logic less_893_s16_q;
  logic [6:0] select_894_s16_q;
  logic [6:0] sum_897_s16_q;
  logic [6:0] sum_904_s16_q;
  logic and_926_s16_q;
  logic [6:0] partner_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic select_932_s16_q;
  logic equal_944_s16_q;
  logic and_950_s16_q;
  logic [11:0] select_968_s16_q;
  logic not_975_s16_q;
  logic equal_1011_s16_q;
  logic and_1144_s16_q;
  logic equal_1285_s16_q;
  logic equal_1337_s16_q;
  logic less_1614_s16_q;
  logic less_1616_s16_q;
  logic select_1626_s16_q;
  logic [8:0] difference_1628_s16_q;
  logic [9:0] sum_1635_s16_q;
  logic less_1891_s16_q;
  logic equal_2034_s16_q;
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
      equal_380_s16_q <= equal_380_s15_q;
      or_381_s16_q <= or_381_s15_q;
      equal_383_s16_q <= equal_383_s15_q;
      less_386_s16_q <= less_386_s15_q;
      not_387_s16_q <= not_387_s15_q;
      equal_419_s16_q <= equal_419_s15_q;
      x_s16_2_q <= x_s15_2_q;
      select_529_s16_q <= select_529_s15_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      select_536_s16_q <= select_536_s15_q;
      equal_603_s16_q <= equal_603_s15_q;
      sum_605_s16_q <= sum_605;
      sum_658_s16_q <= sum_658;
      less_659_s16_q <= sum_605 < sum_658;
      sum_713_s16_q <= sum_713;
      difference_768_s16_q <= difference_768;
      column_16_s16_q <= column_16_s15_q;
      sum_889_s16_q <= sum_889_s15_q;
      sum_892_s16_q <= sum_892_s15_q;
      less_893_s16_q <= less_893;
      select_894_s16_q <= less_893 ? sum_892_s15_q : sum_889_s15_q;
      sum_897_s16_q <= sum_897_s15_q;
      sum_904_s16_q <= sum_904;
      and_926_s16_q <= and_926_s15_q;
      partner_s16_q <= partner_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q;
      select_932_s16_q <= select_932_s15_q;
      equal_944_s16_q <= equal_944_s15_q;
      and_950_s16_q <= and_950_s15_q;
      select_968_s16_q <= select_968_s15_q;
      not_975_s16_q <= not_975_s15_q;
      equal_1011_s16_q <= equal_1011_s15_q;
      and_1144_s16_q <= and_1144_s15_q;
      equal_1285_s16_q <= equal_1285_s15_q;
      equal_1337_s16_q <= equal_1337_s15_q;
      less_1614_s16_q <= less_1614_s15_q;
      less_1616_s16_q <= less_1616_s15_q;
      select_1626_s16_q <= select_1626[0];
      difference_1628_s16_q <= difference_1628;
      sum_1635_s16_q <= sum_1635[11:2];
      less_1891_s16_q <= less_1891_s15_q;
      equal_2034_s16_q <= equal_2034_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_4_columns_values_0_q;
  logic [7:0] sums_4_columns_values_1_q;
  logic [7:0] sums_4_columns_values_2_q;
  logic [7:0] sums_4_columns_values_3_q;
  logic [7:0] sums_4_columns_values_4_q;
  logic [7:0] sums_4_columns_values_5_q;
  logic [7:0] sums_4_columns_values_6_q;
  // hls/stages/agreement.hpp:478
  logic not_715;
  assign not_715 = ~less_659_s16_q;
  logic [1:0] best;
  assign best = ((less_659_s16_q ? sum_658_s16_q : sum_605_s16_q) < sum_713_s16_q) ? 2'h3 : {not_715, less_659_s16_q};
  // hls/stages/agreement.hpp:463
  logic [7:0] sum_770;
  assign sum_770 = difference_768_s16_q + (equal_603_s16_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  logic [7:0] difference_828;
  assign difference_828 = {2'h0, column_16_s16_q} - (age_s16_q[2] ? sums_4_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:478
  logic not_899;
  assign not_899 = ~less_893_s16_q;
  logic [1:0] best_3;
  assign best_3 = (select_894_s16_q < sum_897_s16_q) ? 2'h3 : {not_899, less_893_s16_q};
  logic [6:0] select_906;
  assign select_906 = best_3[1] ? (best_3[0] ? sum_897_s16_q : sum_889_s16_q) : (best_3[0] ? sum_892_s16_q : sum_904_s16_q);
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_914;
  assign sum_914 = (age_s16_q[0] ? sums_4_columns_values_3_q[6:0] : 7'h0) + (sums_4_columns_values_1_q[6:0] + sums_4_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:606
  logic [6:0] sum_937;
  assign sum_937 = x_s16_q[6:0] + {best_left_rdata_s16_q[34], best_left_rdata_s16_q[34:29]};
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1450;
  assign select_1450 = or_381_s16_q ? sums_0_sum_sums_values_0_q : (equal_383_s16_q ? sum_770 : sums_0_sum_sums_values_0_q);
  logic [7:0] select_1499;
  assign select_1499 = equal_383_s16_q ? {2'h0, column_16_s16_q} : sums_4_columns_values_0_q;
  logic [7:0] select_1501;
  assign select_1501 = equal_383_s16_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1503;
  assign select_1503 = equal_383_s16_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1505;
  assign select_1505 = equal_383_s16_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1507;
  assign select_1507 = equal_383_s16_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1509;
  assign select_1509 = equal_383_s16_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1511;
  assign select_1511 = equal_383_s16_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1636;
  assign sum_1636 = {difference_1628_s16_q, select_1626_s16_q} + sum_1635_s16_q;
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1637;
  assign sum_1637 = {registration_slope_s16_q[11], registration_slope_s16_q} + {{5{sum_1636[9]}}, sum_1636[9:2]};

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_0_sum_sums_values_0_q = 8'h0;
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
    if (s16_en) begin
      sums_0_sum_sums_values_0_q <= select_1450;
      sums_4_columns_values_0_q <= or_381_s16_q ? sums_4_columns_values_0_q : select_1499;
      sums_4_columns_values_1_q <= or_381_s16_q ? sums_4_columns_values_1_q : select_1501;
      sums_4_columns_values_2_q <= or_381_s16_q ? sums_4_columns_values_2_q : select_1503;
      sums_4_columns_values_3_q <= or_381_s16_q ? sums_4_columns_values_3_q : select_1505;
      sums_4_columns_values_4_q <= or_381_s16_q ? sums_4_columns_values_4_q : select_1507;
      sums_4_columns_values_5_q <= or_381_s16_q ? sums_4_columns_values_5_q : select_1509;
      sums_4_columns_values_6_q <= or_381_s16_q ? sums_4_columns_values_6_q : select_1511;
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
  logic equal_380_s17_q;
  logic or_381_s17_q;
  logic equal_383_s17_q;
  logic less_386_s17_q;
  logic not_387_s17_q;
  logic equal_419_s17_q;
  logic [6:0] x_s17_2_q;
  logic select_529_s17_q;
  logic [34:0] best_left_rdata_s17_q;
  logic select_536_s17_q;
  logic equal_603_s17_q;
  logic [7:0] sum_605_s17_q;
  logic [7:0] sum_658_s17_q;
  logic [7:0] sum_713_s17_q;
  logic [1:0] best_s17_q;
  logic [7:0] select_717_s17_q;
  logic [7:0] sum_770_s17_q;
  logic [7:0] select_771_s17_q;
  logic [7:0] difference_828_s17_q;
  logic [6:0] sum_889_s17_q;
  logic [6:0] sum_892_s17_q;
  logic [6:0] sum_897_s17_q;
  logic [1:0] best_3_s17_q;
  logic [6:0] sum_904_s17_q;
  logic [6:0] select_906_s17_q;
  logic [6:0] sum_914_s17_q;
  logic and_926_s17_q;
  logic [6:0] partner_s17_q;
  logic [14:0] best_right_rdata_s17_q;
  logic select_932_s17_q;
  logic [6:0] sum_937_s17_q;
  logic equal_944_s17_q;
  logic and_950_s17_q;
  logic [11:0] select_968_s17_q;
  logic not_975_s17_q;
  logic equal_1011_s17_q;
  logic and_1144_s17_q;
  logic equal_1285_s17_q;
  logic equal_1337_s17_q;
  logic less_1614_s17_q;
  logic less_1616_s17_q;
  logic [12:0] sum_1637_s17_q;
  logic less_1891_s17_q;
  logic equal_2034_s17_q;
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
      age_s17_q <= age_s16_q[1];
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
      equal_380_s17_q <= equal_380_s16_q;
      or_381_s17_q <= or_381_s16_q;
      equal_383_s17_q <= equal_383_s16_q;
      less_386_s17_q <= less_386_s16_q;
      not_387_s17_q <= not_387_s16_q;
      equal_419_s17_q <= equal_419_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_529_s17_q <= select_529_s16_q;
      best_left_rdata_s17_q <= best_left_rdata_s16_q;
      select_536_s17_q <= select_536_s16_q;
      equal_603_s17_q <= equal_603_s16_q;
      sum_605_s17_q <= sum_605_s16_q;
      sum_658_s17_q <= sum_658_s16_q;
      sum_713_s17_q <= sum_713_s16_q;
      best_s17_q <= best;
      select_717_s17_q <= best[0] ? sum_713_s16_q : sum_605_s16_q;
      sum_770_s17_q <= sum_770;
      select_771_s17_q <= best[0] ? sum_658_s16_q : sum_770;
      difference_828_s17_q <= difference_828;
      sum_889_s17_q <= sum_889_s16_q;
      sum_892_s17_q <= sum_892_s16_q;
      sum_897_s17_q <= sum_897_s16_q;
      best_3_s17_q <= best_3;
      sum_904_s17_q <= sum_904_s16_q;
      select_906_s17_q <= select_906;
      sum_914_s17_q <= sum_914;
      and_926_s17_q <= and_926_s16_q;
      partner_s17_q <= partner_s16_q;
      best_right_rdata_s17_q <= best_right_rdata_s16_q;
      select_932_s17_q <= select_932_s16_q;
      sum_937_s17_q <= sum_937;
      equal_944_s17_q <= equal_944_s16_q;
      and_950_s17_q <= and_950_s16_q;
      select_968_s17_q <= select_968_s16_q;
      not_975_s17_q <= not_975_s16_q;
      equal_1011_s17_q <= equal_1011_s16_q;
      and_1144_s17_q <= and_1144_s16_q;
      equal_1285_s17_q <= equal_1285_s16_q;
      equal_1337_s17_q <= equal_1337_s16_q;
      less_1614_s17_q <= less_1614_s16_q;
      less_1616_s17_q <= less_1616_s16_q;
      sum_1637_s17_q <= sum_1637;
      less_1891_s17_q <= less_1891_s16_q;
      equal_2034_s17_q <= equal_2034_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_4_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:478
  logic less_773;
  assign less_773 = (best_s17_q[1] ? select_717_s17_q : select_771_s17_q) < sum_770_s17_q;
  logic [1:0] best_2;
  assign best_2 = less_773 ? 2'h0 : best_s17_q;
  // hls/stages/agreement.hpp:463
  logic [7:0] sum_830;
  assign sum_830 = difference_828_s17_q + (equal_603_s17_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:478
  logic [1:0] best_4;
  assign best_4 = (select_906_s17_q < sum_904_s17_q) ? 2'h0 : best_3_s17_q;
  logic [6:0] select_911;
  assign select_911 = best_4[1] ? (best_4[0] ? sum_897_s17_q : sum_889_s17_q) : (best_4[0] ? sum_892_s17_q : sum_904_s17_q);
  // hls/stages/agreement.hpp:343
  logic [6:0] select_974;
  assign select_974 = drew_s17_q ? x_s17_q[6:0] : (or_381_s17_q ? (less_386_s17_q ? 7'h0 : sum_937_s17_q) : 7'h0);
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1514;
  assign select_1514 = or_381_s17_q ? sums_4_sum_sums_values_0_q : (equal_383_s17_q ? sum_830 : sums_4_sum_sums_values_0_q);
  // hls/stages/registration.hpp:151
  logic [7:0] select_1640;
  assign select_1640 = ($signed(sum_1637_s17_q[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1637_s17_q[7:0];
  logic [7:0] slope;
  assign slope = ($signed(6'h0) < $signed(sum_1637_s17_q[12:7])) ? 8'h7f : select_1640;

  // Memory near_right, 120 x 14, DISTANCE 32, hls/stages/agreement.hpp:921; read in stage 17, written in stage 21: 17 < 21 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [13:0] near_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) near_right_mem[i] = 14'h0;
`endif
  logic [6:0] near_right_raddr;
  assign near_right_raddr = or_381_s17_q ? sum_937_s17_q : partner_s17_q;
  logic near_right_re;
  assign near_right_re = s17_en & select_529_s17_q;
  logic [13:0] near_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (near_right_re) near_right_rdata_q <= near_right_mem[near_right_raddr];
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_4_sum_sums_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s17_en) begin
      sums_4_sum_sums_values_0_q <= select_1514;
    end
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
  logic equal_380_s18_q;
  logic or_381_s18_q;
  logic less_386_s18_q;
  logic not_387_s18_q;
  logic equal_419_s18_q;
  logic [6:0] x_s18_2_q;
  logic [34:0] best_left_rdata_s18_q;
  logic select_536_s18_q;
  logic [7:0] sum_605_s18_q;
  logic [7:0] sum_658_s18_q;
  logic [7:0] sum_713_s18_q;
  logic [7:0] sum_770_s18_q;
  logic [1:0] best_2_s18_q;
  logic [7:0] select_775_s18_q;
  logic [7:0] select_776_s18_q;
  logic [7:0] sum_830_s18_q;
  logic [6:0] sum_889_s18_q;
  logic [6:0] sum_892_s18_q;
  logic [6:0] sum_897_s18_q;
  logic [6:0] sum_904_s18_q;
  logic [1:0] best_4_s18_q;
  logic [6:0] select_911_s18_q;
  logic [6:0] sum_914_s18_q;
  logic and_926_s18_q;
  logic [6:0] partner_s18_q;
  logic [14:0] best_right_rdata_s18_q;
  logic select_932_s18_q;
  logic equal_944_s18_q;
  logic and_950_s18_q;
  logic [7:0] select_968_s18_q;
  logic [6:0] select_974_s18_q;
  logic not_975_s18_q;
  logic equal_1011_s18_q;
  logic and_1144_s18_q;
  logic equal_1285_s18_q;
  logic equal_1337_s18_q;
  logic less_1614_s18_q;
  logic less_1616_s18_q;
  logic [7:0] slope_s18_q;
  logic [6:0] select_1642_s18_q;
  logic [7:0] select_1643_s18_q;
  logic [7:0] select_1645_s18_q;
  logic [7:0] select_1646_s18_q;
  logic less_1891_s18_q;
  logic equal_2034_s18_q;
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
      equal_380_s18_q <= equal_380_s17_q;
      or_381_s18_q <= or_381_s17_q;
      less_386_s18_q <= less_386_s17_q;
      not_387_s18_q <= not_387_s17_q;
      equal_419_s18_q <= equal_419_s17_q;
      x_s18_2_q <= x_s17_2_q;
      best_left_rdata_s18_q <= best_left_rdata_s17_q;
      select_536_s18_q <= select_536_s17_q;
      sum_605_s18_q <= sum_605_s17_q;
      sum_658_s18_q <= sum_658_s17_q;
      sum_713_s18_q <= sum_713_s17_q;
      sum_770_s18_q <= sum_770_s17_q;
      best_2_s18_q <= best_2;
      select_775_s18_q <= best_2[0] ? sum_713_s17_q : sum_605_s17_q;
      select_776_s18_q <= best_2[0] ? sum_658_s17_q : sum_770_s17_q;
      sum_830_s18_q <= sum_830;
      sum_889_s18_q <= sum_889_s17_q;
      sum_892_s18_q <= sum_892_s17_q;
      sum_897_s18_q <= sum_897_s17_q;
      sum_904_s18_q <= sum_904_s17_q;
      best_4_s18_q <= best_4;
      select_911_s18_q <= select_911;
      sum_914_s18_q <= sum_914_s17_q;
      and_926_s18_q <= and_926_s17_q;
      partner_s18_q <= partner_s17_q;
      best_right_rdata_s18_q <= best_right_rdata_s17_q;
      select_932_s18_q <= select_932_s17_q;
      equal_944_s18_q <= equal_944_s17_q;
      and_950_s18_q <= and_950_s17_q;
      select_968_s18_q <= {select_968_s17_q[11:10], select_968_s17_q[5:0]};
      select_974_s18_q <= select_974;
      not_975_s18_q <= not_975_s17_q;
      equal_1011_s18_q <= equal_1011_s17_q;
      and_1144_s18_q <= and_1144_s17_q;
      equal_1285_s18_q <= equal_1285_s17_q;
      equal_1337_s18_q <= equal_1337_s17_q;
      less_1614_s18_q <= less_1614_s17_q;
      less_1616_s18_q <= less_1616_s17_q;
      slope_s18_q <= slope;
      select_1642_s18_q <= select_968_s17_q[6] ? slope[7:1] : 7'h0;
      select_1643_s18_q <= select_968_s17_q[7] ? slope : 8'h0;
      select_1645_s18_q <= select_968_s17_q[8] ? slope : 8'h0;
      select_1646_s18_q <= select_968_s17_q[9] ? slope : 8'h0;
      less_1891_s18_q <= less_1891_s17_q;
      equal_2034_s18_q <= equal_2034_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:98
  logic and_335;
  assign and_335 = sample_pair_whole_s18_q & and_334_s18_q;
  // hls/stages/agreement.hpp:470
  logic less_537;
  assign less_537 = $signed(run_shift_s18_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_539;
  assign less_539 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s18_q);
  // hls/stages/agreement.hpp:478
  logic less_831;
  assign less_831 = (best_2_s18_q[1] ? select_775_s18_q : select_776_s18_q) < sum_830_s18_q;
  logic [1:0] select_832;
  assign select_832 = less_831 ? 2'h0 : best_2_s18_q;
  logic less_915;
  assign less_915 = select_911_s18_q < sum_914_s18_q;
  logic [1:0] select_916;
  assign select_916 = less_915 ? 2'h0 : best_4_s18_q;
  // hls/stages/agreement.hpp:487
  logic [6:0] select_919;
  assign select_919 = select_916[1] ? (select_916[0] ? sum_897_s18_q : sum_889_s18_q) : (select_916[0] ? sum_892_s18_q : sum_904_s18_q);
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1621;
  assign select_1621 = or_381_s18_q ? (less_386_s18_q ? 8'h0 : best_left_rdata_s18_q[21:14]) : 8'h0;
  // hls/stages/registration.hpp:151
  logic [8:0] sum_1644;
  assign sum_1644 = {{2{select_1642_s18_q[6]}}, select_1642_s18_q} + {select_1643_s18_q[7], select_1643_s18_q};
  // hls/stages/registration.hpp:152
  logic [8:0] sum_1647;
  assign sum_1647 = {{2{select_1645_s18_q[7]}}, select_1645_s18_q[7:1]} + {select_1646_s18_q[7], select_1646_s18_q};
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1648;
  assign sum_1648 = {{3{sum_1644[8]}}, sum_1644[8:1]} + {sum_1647[8], sum_1647, select_1645_s18_q[0]};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1649;
  assign select_1649 = select_968_s18_q[6] ? slope_s18_q : 8'h0;
  logic [7:0] select_1650;
  assign select_1650 = select_968_s18_q[7] ? slope_s18_q : 8'h0;
  logic [8:0] difference_1651;
  assign difference_1651 = {{2{select_1649[7]}}, select_1649[7:1]} - {select_1650[7], select_1650};

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
  logic equal_380_s19_q;
  logic or_381_s19_q;
  logic not_387_s19_q;
  logic equal_419_s19_q;
  logic [6:0] x_s19_2_q;
  logic [34:0] best_left_rdata_s19_q;
  logic select_536_s19_q;
  logic and_541_s19_q;
  logic [7:0] sum_605_s19_q;
  logic [7:0] sum_658_s19_q;
  logic [7:0] sum_713_s19_q;
  logic [7:0] sum_770_s19_q;
  logic [7:0] sum_830_s19_q;
  logic less_831_s19_q;
  logic [1:0] select_832_s19_q;
  logic [7:0] select_833_s19_q;
  logic [7:0] select_834_s19_q;
  logic equal_843_s19_q;
  logic [6:0] sum_914_s19_q;
  logic less_915_s19_q;
  logic [6:0] select_919_s19_q;
  logic and_926_s19_q;
  logic [6:0] partner_s19_q;
  logic [14:0] best_right_rdata_s19_q;
  logic select_932_s19_q;
  logic [13:0] near_right_rdata_s19_q;
  logic equal_944_s19_q;
  logic and_950_s19_q;
  logic [5:0] select_968_s19_q;
  logic [6:0] select_974_s19_q;
  logic not_975_s19_q;
  logic equal_1011_s19_q;
  logic and_1144_s19_q;
  logic equal_1285_s19_q;
  logic equal_1337_s19_q;
  logic less_1614_s19_q;
  logic less_1616_s19_q;
  logic [7:0] select_1621_s19_q;
  logic [9:0] sum_1648_s19_q;
  logic select_1649_s19_q;
  logic [8:0] difference_1651_s19_q;
  logic less_1891_s19_q;
  logic equal_2034_s19_q;
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
      equal_380_s19_q <= equal_380_s18_q;
      or_381_s19_q <= or_381_s18_q;
      not_387_s19_q <= not_387_s18_q;
      equal_419_s19_q <= equal_419_s18_q;
      x_s19_2_q <= x_s18_2_q;
      best_left_rdata_s19_q <= best_left_rdata_s18_q;
      select_536_s19_q <= select_536_s18_q;
      and_541_s19_q <= (~less_537) & (~less_539);
      sum_605_s19_q <= sum_605_s18_q;
      sum_658_s19_q <= sum_658_s18_q;
      sum_713_s19_q <= sum_713_s18_q;
      sum_770_s19_q <= sum_770_s18_q;
      sum_830_s19_q <= sum_830_s18_q;
      less_831_s19_q <= less_831;
      select_832_s19_q <= select_832;
      select_833_s19_q <= select_832[0] ? sum_713_s18_q : sum_605_s18_q;
      select_834_s19_q <= select_832[0] ? sum_658_s18_q : sum_770_s18_q;
      equal_843_s19_q <= {less_831, select_832} == 3'h0;
      sum_914_s19_q <= sum_914_s18_q;
      less_915_s19_q <= less_915;
      select_919_s19_q <= select_919;
      and_926_s19_q <= and_926_s18_q;
      partner_s19_q <= partner_s18_q;
      best_right_rdata_s19_q <= best_right_rdata_s18_q;
      select_932_s19_q <= select_932_s18_q;
      near_right_rdata_s19_q <= near_right_rdata_q;
      equal_944_s19_q <= equal_944_s18_q;
      and_950_s19_q <= and_950_s18_q;
      select_968_s19_q <= select_968_s18_q[5:0];
      select_974_s19_q <= select_974_s18_q;
      not_975_s19_q <= not_975_s18_q;
      equal_1011_s19_q <= equal_1011_s18_q;
      and_1144_s19_q <= and_1144_s18_q;
      equal_1285_s19_q <= equal_1285_s18_q;
      equal_1337_s19_q <= equal_1337_s18_q;
      less_1614_s19_q <= less_1614_s18_q;
      less_1616_s19_q <= less_1616_s18_q;
      select_1621_s19_q <= select_1621;
      sum_1648_s19_q <= sum_1648[10:1];
      select_1649_s19_q <= select_1649[0];
      difference_1651_s19_q <= difference_1651;
      less_1891_s19_q <= less_1891_s18_q;
      equal_2034_s19_q <= equal_2034_s18_q;
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
  // hls/stages/agreement.hpp:486
  logic [7:0] of_best;
  assign of_best = less_831_s19_q ? sum_830_s19_q : (select_832_s19_q[1] ? select_833_s19_q : select_834_s19_q);
  logic [7:0] of_best_2;
  assign of_best_2 = and_541_s19_q ? of_best : 8'h0;
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_831_s19_q, select_832_s19_q} == 3'h4) ? 3'h3 : (equal_843_s19_q ? 3'h1 : {less_831_s19_q, select_832_s19_q});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_847;
  assign sum_847 = near_best + 3'h1;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_852;
  assign sum_852 = near_best + 3'h7;
  // hls/stages/registration.hpp:26
  logic [7:0] select_861;
  assign select_861 = near_best[1] ? (near_best[0] ? sum_713_s19_q : sum_605_s19_q) : (near_best[0] ? sum_658_s19_q : sum_770_s19_q);
  // hls/stages/agreement.hpp:487
  logic [6:0] of_near;
  assign of_near = less_915_s19_q ? sum_914_s19_q : select_919_s19_q;
  logic [6:0] of_near_2;
  assign of_near_2 = and_541_s19_q ? of_near : 7'h0;
  // hls/stages/agreement.hpp:635
  logic not_945;
  assign not_945 = ~equal_944_s19_q;
  // hls/stages/agreement.hpp:343
  logic and_970;
  assign and_970 = not_945 & (drew_s19_q & select_968_s19_q[0]);
  // hls/stages/agreement.hpp:621
  logic [8:0] way_2;
  assign way_2 = {2'h0, near_right_rdata_s19_q[13:7]} - {1'b0, x_s19_q};
  // hls/stages/agreement.hpp:625
  logic and_983;
  assign and_983 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s19_q[34:29]));
  // hls/stages/agreement.hpp:204
  logic select_1198;
  assign select_1198 = sample_pair_whole_s19_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1652;
  assign sum_1652 = {difference_1651_s19_q, select_1649_s19_q} + {sum_1648_s19_q[9], sum_1648_s19_q[9:1]};
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1653;
  assign difference_1653 = {{4{select_1621_s19_q[7]}}, select_1621_s19_q} - {sum_1652[9], sum_1652, sum_1648_s19_q[0]};

  // Memory shown_right, 120 x 2, DISTANCE 32, hls/stages/agreement.hpp:922; read in stage 19, written in stage 22: 19 < 22 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s19_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s19_en & and_970;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

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
      averager_running_of_skin_q <= select_1198;
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
  logic equal_380_s20_q;
  logic or_381_s20_q;
  logic not_387_s20_q;
  logic equal_419_s20_q;
  logic [6:0] x_s20_2_q;
  logic [34:0] best_left_rdata_s20_q;
  logic select_536_s20_q;
  logic [7:0] sum_830_s20_q;
  logic select_832_s20_q;
  logic [7:0] of_best_2_s20_q;
  logic less_838_s20_q;
  logic equal_846_s20_q;
  logic [1:0] sum_847_s20_q;
  logic [7:0] select_848_s20_q;
  logic [7:0] select_849_s20_q;
  logic [1:0] sum_852_s20_q;
  logic [7:0] select_853_s20_q;
  logic [7:0] select_854_s20_q;
  logic [1:0] sum_858_s20_q;
  logic [7:0] select_862_s20_q;
  logic [6:0] of_near_2_s20_q;
  logic or_923_s20_q;
  logic and_926_s20_q;
  logic [6:0] partner_s20_q;
  logic [14:0] best_right_rdata_s20_q;
  logic select_932_s20_q;
  logic less_933_s20_q;
  logic [13:0] near_right_rdata_s20_q;
  logic or_941_s20_q;
  logic equal_944_s20_q;
  logic not_945_s20_q;
  logic and_950_s20_q;
  logic [5:0] select_968_s20_q;
  logic and_970_s20_q;
  logic [6:0] select_974_s20_q;
  logic not_975_s20_q;
  logic [8:0] way_2_s20_q;
  logic and_983_s20_q;
  logic equal_1011_s20_q;
  logic and_1145_s20_q;
  logic equal_1285_s20_q;
  logic equal_1337_s20_q;
  logic less_1614_s20_q;
  logic less_1616_s20_q;
  logic [11:0] difference_1653_s20_q;
  logic less_1891_s20_q;
  logic equal_2034_s20_q;
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
      equal_380_s20_q <= equal_380_s19_q;
      or_381_s20_q <= or_381_s19_q;
      not_387_s20_q <= not_387_s19_q;
      equal_419_s20_q <= equal_419_s19_q;
      x_s20_2_q <= x_s19_2_q;
      best_left_rdata_s20_q <= best_left_rdata_s19_q;
      select_536_s20_q <= select_536_s19_q;
      sum_830_s20_q <= sum_830_s19_q;
      select_832_s20_q <= select_832_s19_q[0];
      of_best_2_s20_q <= of_best_2;
      less_838_s20_q <= best_left_rdata_s19_q[7:0] < of_best_2;
      equal_846_s20_q <= {less_831_s19_q, select_832_s19_q} == near_best;
      sum_847_s20_q <= sum_847[2:1];
      select_848_s20_q <= sum_847[0] ? sum_713_s19_q : sum_605_s19_q;
      select_849_s20_q <= sum_847[0] ? sum_658_s19_q : sum_770_s19_q;
      sum_852_s20_q <= sum_852[2:1];
      select_853_s20_q <= sum_852[0] ? sum_713_s19_q : sum_605_s19_q;
      select_854_s20_q <= sum_852[0] ? sum_658_s19_q : sum_770_s19_q;
      sum_858_s20_q <= {less_831_s19_q, select_832_s19_q[1]} + 2'h3;
      select_862_s20_q <= near_best[2] ? sum_830_s19_q : select_861;
      of_near_2_s20_q <= of_near_2;
      or_923_s20_q <= select_536_s19_q | (best_left_rdata_s19_q[28:22] < of_near_2);
      and_926_s20_q <= and_926_s19_q;
      partner_s20_q <= partner_s19_q;
      best_right_rdata_s20_q <= best_right_rdata_s19_q;
      select_932_s20_q <= select_932_s19_q;
      less_933_s20_q <= best_right_rdata_s19_q[7:0] < of_best_2;
      near_right_rdata_s20_q <= near_right_rdata_s19_q;
      or_941_s20_q <= select_932_s19_q | (near_right_rdata_s19_q[6:0] < of_near_2);
      equal_944_s20_q <= equal_944_s19_q;
      not_945_s20_q <= not_945;
      and_950_s20_q <= and_950_s19_q;
      select_968_s20_q <= select_968_s19_q;
      and_970_s20_q <= and_970;
      select_974_s20_q <= select_974_s19_q;
      not_975_s20_q <= not_975_s19_q;
      way_2_s20_q <= way_2;
      and_983_s20_q <= and_983;
      equal_1011_s20_q <= equal_1011_s19_q;
      and_1145_s20_q <= not_945 & and_1144_s19_q;
      equal_1285_s20_q <= equal_1285_s19_q;
      equal_1337_s20_q <= equal_1337_s19_q;
      less_1614_s20_q <= less_1614_s19_q;
      less_1616_s20_q <= less_1616_s19_q;
      difference_1653_s20_q <= difference_1653;
      less_1891_s20_q <= less_1891_s19_q;
      equal_2034_s20_q <= equal_2034_s19_q;
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
  // hls/stages/agreement.hpp:493
  logic or_839;
  assign or_839 = select_536_s20_q | less_838_s20_q;
  // hls/stages/registration.hpp:23
  logic [7:0] below;
  assign below = sum_847_s20_q[1] ? sum_830_s20_q : (sum_847_s20_q[0] ? select_848_s20_q : select_849_s20_q);
  // hls/stages/registration.hpp:22
  logic [7:0] above;
  assign above = sum_852_s20_q[1] ? sum_830_s20_q : (sum_852_s20_q[0] ? select_853_s20_q : select_854_s20_q);
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/agreement.hpp:507
  logic or_934;
  assign or_934 = select_932_s20_q | less_933_s20_q;
  // hls/stages/agreement.hpp:622
  logic [9:0] sum_977;
  assign sum_977 = {way_2_s20_q[8], way_2_s20_q} + 10'h1;
  // hls/stages/division.hpp:18
  logic [5:0] sum_1009;
  assign sum_1009 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:158
  logic [11:0] select_1655;
  assign select_1655 = ($signed(difference_1653_s20_q[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1653_s20_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1900;
  assign sum_1900 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1901;
  assign select_1901 = sum_1009[5] ? {1'b1, sum_1009[4:0], region_across_rest_q[2:0]} : sum_1900;
  // hls/stages/agreement.hpp:290
  logic [8:0] select_1905;
  assign select_1905 = equal_1337_s20_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_1908;
  assign select_1908 = equal_1337_s20_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

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

  // Memory seen_columns, 120 x 18, DISTANCE 32, hls/stages/agreement.hpp:953; read in stage 20, written in stage 22: 20 < 22 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s20_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s20_en & and_970_s20_q;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s20_en) begin
      region_across_rest_q <= drew_s20_q ? select_1901 : columns_begin_rest_q;
      region_across_back_q <= drew_s20_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_360_s20_q ? select_1905 : columns_begin_rest_q;
      columns_begin_back_q <= and_360_s20_q ? select_1908 : columns_begin_back_q;
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
  logic equal_380_s21_q;
  logic or_381_s21_q;
  logic not_387_s21_q;
  logic equal_419_s21_q;
  logic [6:0] x_s21_2_q;
  logic [7:0] best_left_rdata_s21_q;
  logic select_832_s21_q;
  logic or_839_s21_q;
  logic [7:0] select_840_s21_q;
  logic [5:0] select_841_s21_q;
  logic equal_846_s21_q;
  logic [7:0] below_s21_q;
  logic [7:0] above_s21_q;
  logic rise_s21_q;
  logic [1:0] sum_858_s21_q;
  logic [7:0] select_862_s21_q;
  logic [7:0] xor_866_s21_q;
  logic [6:0] select_924_s21_q;
  logic [5:0] select_925_s21_q;
  logic and_926_s21_q;
  logic [6:0] partner_s21_q;
  logic [7:0] select_935_s21_q;
  logic [6:0] select_936_s21_q;
  logic [6:0] select_942_s21_q;
  logic [6:0] select_943_s21_q;
  logic equal_944_s21_q;
  logic not_945_s21_q;
  logic and_950_s21_q;
  logic [5:0] select_968_s21_q;
  logic and_970_s21_q;
  logic [1:0] shown_right_rdata_s21_q;
  logic [6:0] select_974_s21_q;
  logic not_975_s21_q;
  logic less_978_s21_q;
  logic less_979_s21_q;
  logic or_984_s21_q;
  logic sum_1009_s21_q;
  logic equal_1011_s21_q;
  logic and_1145_s21_q;
  logic equal_1285_s21_q;
  logic equal_1337_s21_q;
  logic less_1614_s21_q;
  logic less_1616_s21_q;
  logic [11:0] select_1655_s21_q;
  logic less_1656_s21_q;
  logic less_1891_s21_q;
  logic equal_2034_s21_q;
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
      equal_380_s21_q <= equal_380_s20_q;
      or_381_s21_q <= or_381_s20_q;
      not_387_s21_q <= not_387_s20_q;
      equal_419_s21_q <= equal_419_s20_q;
      x_s21_2_q <= x_s20_2_q;
      best_left_rdata_s21_q <= best_left_rdata_s20_q[21:14];
      select_832_s21_q <= select_832_s20_q;
      or_839_s21_q <= or_839;
      select_840_s21_q <= or_839 ? of_best_2_s20_q : best_left_rdata_s20_q[7:0];
      select_841_s21_q <= or_839 ? run_shift_s20_q : best_left_rdata_s20_q[13:8];
      equal_846_s21_q <= equal_846_s20_q;
      below_s21_q <= below;
      above_s21_q <= above;
      rise_s21_q <= rise[8];
      sum_858_s21_q <= sum_858_s20_q;
      select_862_s21_q <= select_862_s20_q;
      xor_866_s21_q <= rise[7:0] ^ {8{rise[8]}};
      select_924_s21_q <= or_923_s20_q ? of_near_2_s20_q : best_left_rdata_s20_q[28:22];
      select_925_s21_q <= or_923_s20_q ? run_shift_s20_q : best_left_rdata_s20_q[34:29];
      and_926_s21_q <= and_926_s20_q;
      partner_s21_q <= partner_s20_q;
      select_935_s21_q <= or_934 ? of_best_2_s20_q : best_right_rdata_s20_q[7:0];
      select_936_s21_q <= or_934 ? x_s20_2_q : best_right_rdata_s20_q[14:8];
      select_942_s21_q <= or_941_s20_q ? of_near_2_s20_q : near_right_rdata_s20_q[6:0];
      select_943_s21_q <= or_941_s20_q ? x_s20_2_q : near_right_rdata_s20_q[13:7];
      equal_944_s21_q <= equal_944_s20_q;
      not_945_s21_q <= not_945_s20_q;
      and_950_s21_q <= and_950_s20_q;
      select_968_s21_q <= select_968_s20_q;
      and_970_s21_q <= and_970_s20_q;
      shown_right_rdata_s21_q <= shown_right_rdata_q;
      select_974_s21_q <= select_974_s20_q;
      not_975_s21_q <= not_975_s20_q;
      less_978_s21_q <= {{6{sum_977[9]}}, sum_977} < 16'h3;
      less_979_s21_q <= 6'h2a < best_left_rdata_s20_q[28:23];
      or_984_s21_q <= (cfg_nearer_below_i & best_left_rdata_s20_q[34]) | and_983_s20_q;
      sum_1009_s21_q <= sum_1009[5];
      equal_1011_s21_q <= equal_1011_s20_q;
      and_1145_s21_q <= and_1145_s20_q;
      equal_1285_s21_q <= equal_1285_s20_q;
      equal_1337_s21_q <= equal_1337_s20_q;
      less_1614_s21_q <= less_1614_s20_q;
      less_1616_s21_q <= less_1616_s20_q;
      select_1655_s21_q <= select_1655;
      less_1656_s21_q <= $signed(5'h0) < $signed(select_1655[11:7]);
      less_1891_s21_q <= less_1891_s20_q;
      equal_2034_s21_q <= equal_2034_s20_q;
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
  logic [7:0] select_863;
  assign select_863 = rise_s21_q ? below_s21_q : above_s21_q;
  logic [8:0] fall;
  assign fall = {1'b0, select_862_s21_q} - {1'b0, select_863};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [8:0] size;
  assign size = {8'h0, rise_s21_q} + {1'b0, xor_866_s21_q};
  // hls/stages/agreement.hpp:615
  logic and_980;
  assign and_980 = less_978_s21_q & less_979_s21_q;
  // hls/stages/agreement.hpp:181
  logic and_988;
  assign and_988 = or_381_s21_q & (not_387_s21_q & (and_950_s21_q & (and_980 & or_984_s21_q)));
  logic and_992;
  assign and_992 = or_381_s21_q & (not_387_s21_q & (and_950_s21_q & and_980));
  // hls/stages/agreement.hpp:343
  logic and_995;
  assign and_995 = not_945_s21_q & (drew_s21_q ? select_968_s21_q[0] : (equal_380_s21_q & and_992));
  // hls/stages/agreement.hpp:147
  logic [7:0] select_996;
  assign select_996 = drew_s21_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:672
  logic or_999;
  assign or_999 = select_996[7] | (~({select_996[5], select_996[3], select_996[1]} == 3'h0));
  // hls/stages/agreement.hpp:680
  logic or_1012;
  assign or_1012 = (~sum_1009_s21_q) | equal_1011_s21_q;
  // hls/stages/agreement.hpp:186
  logic shown;
  assign shown = select_968_s21_q[0] & (shown_right_rdata_s21_q[0] | and_992);
  logic near;
  assign near = select_968_s21_q[0] & (and_992 ? and_988 : shown_right_rdata_s21_q[1]);
  // hls/stages/agreement.hpp:650
  logic [7:0] select_1087;
  assign select_1087 = select_968_s21_q[0] ? (sum_1009_s21_q ? select_996 : {select_996[6:0], 1'b0}) : select_996;
  // hls/stages/agreement.hpp:672
  logic or_1090;
  assign or_1090 = select_1087[7] | (~({select_1087[5], select_1087[3], select_1087[1]} == 3'h0));
  // hls/stages/agreement.hpp:204
  logic [10:0] select_1177;
  assign select_1177 = sample_pair_whole_s21_q ? (and_358_s21_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1179;
  assign select_1179 = sample_pair_whole_s21_q ? (and_358_s21_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_1200;
  assign select_1200 = sample_pair_whole_s21_q ? (and_358_s21_q ? select_373 : averager_mask_q) : averager_mask_q;
  logic select_1202;
  assign select_1202 = sample_pair_whole_s21_q ? (and_358_s21_q ? select_377 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/registration.hpp:158
  logic [11:0] residual;
  assign residual = less_1656_s21_q ? 12'h7f : select_1655_s21_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_1892;
  assign sum_1892 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:290
  logic [8:0] select_1912;
  assign select_1912 = equal_419_s21_q ? {difference_1910[7], difference_1910} : (less_1891_s21_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1914;
  assign select_1914 = and_360_s21_q ? (equal_1337_s21_q ? select_1912 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:290
  logic [7:0] select_1916;
  assign select_1916 = equal_419_s21_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1918;
  assign select_1918 = and_360_s21_q ? (equal_1337_s21_q ? select_1916 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_1920;
  assign select_1920 = sum_1892[7] ? {1'b1, sum_1892[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

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
  assign best_right_we = s21_en & and_926_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_936_s21_q, select_935_s21_q};
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

  // Memory near_right, write
  logic [6:0] near_right_waddr;
  assign near_right_waddr = partner_s21_q;
  logic near_right_we;
  assign near_right_we = s21_en & and_926_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (near_right_we) near_right_mem[near_right_waddr] <= {select_943_s21_q, select_942_s21_q};
  end
`ifndef SYNTHESIS
  logic [6:0] near_right_raddr_s18_sim;
  logic near_right_re_s18_sim;
  logic [6:0] near_right_raddr_s19_sim;
  logic near_right_re_s19_sim;
  logic [6:0] near_right_raddr_s20_sim;
  logic near_right_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      near_right_re_s18_sim <= 1'b0;
      near_right_re_s19_sim <= 1'b0;
      near_right_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      near_right_re_s18_sim <= near_right_re;
      near_right_raddr_s18_sim <= near_right_raddr;
      near_right_re_s19_sim <= near_right_re_s18_sim;
      near_right_raddr_s19_sim <= near_right_raddr_s18_sim;
      near_right_re_s20_sim <= near_right_re_s19_sim;
      near_right_raddr_s20_sim <= near_right_raddr_s19_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && near_right_we) begin
      if (near_right_re && near_right_raddr == near_right_waddr) begin
        $error("near_right: address %0d is read less than DISTANCE steps after its write", near_right_waddr);
      end
      if (near_right_re_s18_sim && near_right_raddr_s18_sim == near_right_waddr) begin
        $error("near_right: address %0d is read less than DISTANCE steps after its write", near_right_waddr);
      end
      if (near_right_re_s19_sim && near_right_raddr_s19_sim == near_right_waddr) begin
        $error("near_right: address %0d is read less than DISTANCE steps after its write", near_right_waddr);
      end
      if (near_right_re_s20_sim && near_right_raddr_s20_sim == near_right_waddr) begin
        $error("near_right: address %0d is read less than DISTANCE steps after its write", near_right_waddr);
      end
      if (near_right_waddr >= 7'd120) $error("near_right: write outside, address %0d", near_right_waddr);
    end
    if (rst_ni && near_right_re && near_right_raddr >= 7'd120) $error("near_right: read outside, address %0d", near_right_raddr);
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
    end else if (s21_en) begin
      averager_mask_q <= select_1200;
      averager_of_skin_q <= select_1202;
      region_columns_q <= equal_944_s21_q ? select_996 : (drew_s21_q ? select_1087 : 8'h1);
      region_down_rest_q <= select_1914;
      region_down_back_q <= select_1918;
      region_down_next_q <= select_1920;
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
      averager_total_0_q <= select_1177;
      averager_total_1_q <= select_1179;
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
  logic select_832_s22_q;
  logic or_839_s22_q;
  logic [7:0] select_840_s22_q;
  logic [5:0] select_841_s22_q;
  logic equal_846_s22_q;
  logic rise_s22_q;
  logic [1:0] sum_858_s22_q;
  logic [7:0] twice_s22_q;
  logic [8:0] size_s22_q;
  logic [6:0] select_924_s22_q;
  logic [5:0] select_925_s22_q;
  logic and_926_s22_q;
  logic equal_944_s22_q;
  logic not_945_s22_q;
  logic [5:0] select_968_s22_q;
  logic and_970_s22_q;
  logic [6:0] select_974_s22_q;
  logic not_975_s22_q;
  logic and_989_s22_q;
  logic and_995_s22_q;
  logic or_999_s22_q;
  logic or_1002_s22_q;
  logic or_1005_s22_q;
  logic equal_1007_s22_q;
  logic and_1014_s22_q;
  logic [17:0] seen_columns_rdata_s22_q;
  logic shown_s22_q;
  logic near_s22_q;
  logic or_1090_s22_q;
  logic or_1093_s22_q;
  logic or_1096_s22_q;
  logic and_1145_s22_q;
  logic equal_1285_s22_q;
  logic equal_1337_s22_q;
  logic less_1614_s22_q;
  logic less_1616_s22_q;
  logic [7:0] residual_s22_q;
  logic [12:0] difference_1739_s22_q;
  logic less_1891_s22_q;
  logic sum_1892_s22_q;
  logic select_1931_s22_q;
  logic equal_2034_s22_q;
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
      select_832_s22_q <= select_832_s21_q;
      or_839_s22_q <= or_839_s21_q;
      select_840_s22_q <= select_840_s21_q;
      select_841_s22_q <= select_841_s21_q;
      equal_846_s22_q <= equal_846_s21_q;
      rise_s22_q <= rise_s21_q;
      sum_858_s22_q <= sum_858_s21_q;
      twice_s22_q <= twice;
      size_s22_q <= size;
      select_924_s22_q <= select_924_s21_q;
      select_925_s22_q <= select_925_s21_q;
      and_926_s22_q <= and_926_s21_q;
      equal_944_s22_q <= equal_944_s21_q;
      not_945_s22_q <= not_945_s21_q;
      select_968_s22_q <= select_968_s21_q;
      and_970_s22_q <= and_970_s21_q;
      select_974_s22_q <= select_974_s21_q;
      not_975_s22_q <= not_975_s21_q;
      and_989_s22_q <= not_975_s21_q & and_988;
      and_995_s22_q <= and_995;
      or_999_s22_q <= or_999;
      or_1002_s22_q <= select_996[7] | (~({select_996[6], select_996[3:2]} == 3'h0));
      or_1005_s22_q <= select_996[7] | (~(select_996[6:4] == 3'h0));
      equal_1007_s22_q <= x_s21_q[5:4] == 2'h3;
      and_1014_s22_q <= drew_s21_q & (select_968_s21_q[0] & or_1012);
      seen_columns_rdata_s22_q <= seen_columns_rdata_q;
      shown_s22_q <= shown;
      near_s22_q <= near;
      or_1090_s22_q <= or_1090;
      or_1093_s22_q <= select_1087[7] | (~({select_1087[6], select_1087[3:2]} == 3'h0));
      or_1096_s22_q <= select_1087[7] | (~(select_1087[6:4] == 3'h0));
      and_1145_s22_q <= and_1145_s21_q;
      equal_1285_s22_q <= equal_1285_s21_q;
      equal_1337_s22_q <= equal_1337_s21_q;
      less_1614_s22_q <= less_1614_s21_q;
      less_1616_s22_q <= less_1616_s21_q;
      residual_s22_q <= residual[7:0];
      difference_1739_s22_q <= 13'h0 - {residual[11], residual};
      less_1891_s22_q <= less_1891_s21_q;
      sum_1892_s22_q <= sum_1892[7];
      select_1931_s22_q <= sum_1009_s21_q ? (equal_1011_s21_q & or_1012) : or_1012;
      equal_2034_s22_q <= equal_2034_s21_q;
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
  logic segment_starts_q;
  logic [2:0] next_region_row_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
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
  logic [8:0] select_869;
  assign select_869 = ({twice_s22_q, 1'b0} < size_s22_q) ? {twice_s22_q, 1'b0} : size_s22_q;
  // hls/stages/agreement.hpp:343
  logic [5:0] select_1006;
  assign select_1006 = equal_944_s22_q ? x_s22_q[5:0] : {region_row_q, or_1005_s22_q, or_1002_s22_q, or_999_s22_q};
  // hls/stages/agreement.hpp:753
  logic not_1008;
  assign not_1008 = ~equal_1007_s22_q;
  // hls/stages/agreement.hpp:186
  logic textured;
  assign textured = select_968_s22_q[0] & select_968_s22_q[2];
  logic explained;
  assign explained = select_968_s22_q[0] & select_968_s22_q[4];
  logic and_1028;
  assign and_1028 = select_968_s22_q[0] & ({select_968_s22_q[5], select_968_s22_q[3]} == 2'h3);
  logic and_1035;
  assign and_1035 = select_968_s22_q[0] & select_968_s22_q[3];
  // hls/stages/agreement.hpp:650
  logic and_1074;
  assign and_1074 = seen_columns_rdata_s22_q[5] & select_968_s22_q[0];
  logic and_1075;
  assign and_1075 = seen_columns_rdata_s22_q[0] & select_968_s22_q[0];
  logic and_1108;
  assign and_1108 = seen_columns_rdata_s22_q[8] & select_968_s22_q[0];
  logic and_1109;
  assign and_1109 = seen_columns_rdata_s22_q[3] & select_968_s22_q[0];
  logic and_1124;
  assign and_1124 = seen_columns_rdata_s22_q[9] & select_968_s22_q[0];
  logic and_1125;
  assign and_1125 = seen_columns_rdata_s22_q[4] & select_968_s22_q[0];
  // hls/stages/agreement.hpp:204
  logic [8:0] select_1169;
  assign select_1169 = sample_pair_whole_s22_q ? (and_358_s22_q ? grey_s22_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1171;
  assign select_1171 = sample_pair_whole_s22_q ? (and_358_s22_q ? grey_2_s22_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1173;
  assign select_1173 = sample_pair_whole_s22_q ? (and_358_s22_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1175;
  assign select_1175 = sample_pair_whole_s22_q ? (and_358_s22_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1180;
  assign sum_1180 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s22_q};
  logic [9:0] sum_1188;
  assign sum_1188 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s22_q};
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1203;
  assign select_1203 = and_360_s22_q ? select_366_s22_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1204;
  assign select_1204 = and_360_s22_q ? select_370_s22_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1206;
  assign select_1206 = and_360_s22_q ? census_memory_rdata_s22_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1207;
  assign select_1207 = and_360_s22_q ? census_memory_rdata_s22_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1208;
  assign select_1208 = and_360_s22_q ? census_memory_rdata_s22_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1209;
  assign select_1209 = and_360_s22_q ? census_memory_rdata_s22_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1210;
  assign select_1210 = and_360_s22_q ? census_memory_rdata_s22_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1211;
  assign select_1211 = and_360_s22_q ? census_memory_rdata_s22_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1212;
  assign select_1212 = and_360_s22_q ? census_memory_rdata_s22_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1213;
  assign select_1213 = and_360_s22_q ? census_memory_rdata_s22_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1214;
  assign select_1214 = and_360_s22_q ? census_memory_rdata_s22_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1215;
  assign select_1215 = and_360_s22_q ? census_memory_rdata_s22_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1216;
  assign select_1216 = and_360_s22_q ? census_memory_rdata_s22_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1217;
  assign select_1217 = and_360_s22_q ? census_memory_rdata_s22_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1218;
  assign select_1218 = and_360_s22_q ? census_memory_rdata_s22_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1219;
  assign select_1219 = and_360_s22_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1220;
  assign select_1220 = and_360_s22_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1222;
  assign select_1222 = and_360_s22_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1223;
  assign select_1223 = and_360_s22_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1225;
  assign select_1225 = and_360_s22_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1226;
  assign select_1226 = and_360_s22_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1228;
  assign select_1228 = and_360_s22_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1229;
  assign select_1229 = and_360_s22_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1230;
  assign select_1230 = and_360_s22_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1232;
  assign select_1232 = and_360_s22_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1233;
  assign select_1233 = and_360_s22_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1235;
  assign select_1235 = and_360_s22_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1236;
  assign select_1236 = and_360_s22_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1238;
  assign select_1238 = and_360_s22_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1239;
  assign select_1239 = and_360_s22_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1241;
  assign select_1241 = and_360_s22_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1242;
  assign select_1242 = and_360_s22_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1244;
  assign select_1244 = and_360_s22_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1245;
  assign select_1245 = and_360_s22_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1247;
  assign select_1247 = and_360_s22_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1248;
  assign select_1248 = and_360_s22_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1251;
  assign select_1251 = and_360_s22_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1252;
  assign select_1252 = and_360_s22_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1255;
  assign select_1255 = and_360_s22_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1256;
  assign select_1256 = and_360_s22_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1260;
  assign difference_1260 = {1'b0, select_370_s22_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_1263;
  assign difference_1263 = {1'b0, census_memory_rdata_s22_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_1267;
  assign difference_1267 = {1'b0, census_memory_rdata_s22_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_1271;
  assign difference_1271 = {1'b0, census_memory_rdata_s22_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_1275;
  assign difference_1275 = {1'b0, census_memory_rdata_s22_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1305;
  assign difference_1305 = {1'b0, select_366_s22_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_1316;
  assign difference_1316 = {1'b0, select_370_s22_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:343
  logic and_1519;
  assign and_1519 = not_945_s22_q & (drew_s22_q & (select_968_s22_q[0] & select_968_s22_q[1]));
  // hls/stages/agreement.hpp:650
  logic and_1538;
  assign and_1538 = seen_columns_rdata_s22_q[7] & select_968_s22_q[0];
  logic and_1539;
  assign and_1539 = seen_columns_rdata_s22_q[2] & select_968_s22_q[0];
  // hls/stages/agreement.hpp:644
  logic [9:0] select_1608;
  assign select_1608 = ({select_968_s22_q[3], select_968_s22_q[1]} == 2'h3) ? ({1'b0, select_968_s22_q[5], 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:343
  logic [9:0] select_1611;
  assign select_1611 = equal_944_s22_q ? 10'h0 : (drew_s22_q ? (select_968_s22_q[0] ? select_1608 : 10'h0) : 10'h0);
  // hls/stages/registration.hpp:73
  logic equal_1617;
  assign equal_1617 = {lower_half_s22_q, less_1616_s22_q} == 2'h3;
  logic equal_1618;
  assign equal_1618 = {lower_half_s22_q, less_1616_s22_q} == 2'h2;
  logic equal_1619;
  assign equal_1619 = {lower_half_s22_q, less_1616_s22_q} == 2'h1;
  logic not_1695;
  assign not_1695 = ~equal_1617;
  logic not_1696;
  assign not_1696 = ~equal_1618;
  // hls/stages/agreement.hpp:186
  logic and_1701;
  assign and_1701 = select_968_s22_q[4] & (less_1614_s22_q & (not_1695 & (not_1696 & (~equal_1619))));
  logic and_1710;
  assign and_1710 = select_968_s22_q[4] & (less_1614_s22_q & (not_1695 & (equal_1619 & not_1696)));
  logic and_1718;
  assign and_1718 = select_968_s22_q[4] & (less_1614_s22_q & (equal_1618 & not_1695));
  logic and_1726;
  assign and_1726 = select_968_s22_q[0] & (select_968_s22_q[4] & (less_1614_s22_q & equal_1617));
  // hls/stages/registration.hpp:146
  logic less_1740;
  assign less_1740 = $signed(difference_1739_s22_q) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:186
  logic and_1741;
  assign and_1741 = less_1614_s22_q & less_1740;
  logic [1:0] select_1743;
  assign select_1743 = select_968_s22_q[0] ? (select_968_s22_q[4] ? {and_1741, less_1614_s22_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:80
  logic not_1748;
  assign not_1748 = ~less_1616_s22_q;
  // hls/stages/registration.hpp:146
  logic less_1823;
  assign less_1823 = $signed(difference_1739_s22_q) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1824;
  assign and_1824 = not_1748 & less_1823;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1826;
  assign select_1826 = select_968_s22_q[4] ? (less_1614_s22_q ? {and_1824, not_1748} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:290
  logic [2:0] select_1894;
  assign select_1894 = less_1891_s22_q ? (sum_1892_s22_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1896;
  assign select_1896 = equal_1337_s22_q ? (equal_419_s22_q ? 3'h0 : select_1894) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1892_s22_q;
  // hls/stages/agreement.hpp:290
  logic select_1924;
  assign select_1924 = equal_1337_s22_q ? (equal_419_s22_q | (less_1891_s22_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:147
  logic or_1929;
  assign or_1929 = segment_starts_q | not_975_s22_q;
  // hls/stages/agreement.hpp:343
  logic select_1933;
  assign select_1933 = drew_s22_q ? (select_968_s22_q[0] ? select_1931_s22_q : or_1929) : or_1929;
  logic select_2026;
  assign select_2026 = equal_944_s22_q ? centres_values_0_textured_q : (drew_s22_q ? and_1074 : centres_values_0_textured_q);
  logic select_2028;
  assign select_2028 = drew_s22_q ? (seen_columns_rdata_s22_q[6] & select_968_s22_q[0]) : centres_values_0_of_skin_q;
  logic select_2030;
  assign select_2030 = drew_s22_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2032;
  assign select_2032 = drew_s22_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;

  // Memory regions, 64 x 36, DISTANCE 32, hls/stages/agreement.hpp:938; read in stage 22, written in stage 25: 22 < 25 < 22 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1006;
  logic regions_re;
  assign regions_re = s22_en & (equal_944_s22_q ? not_1008 : and_1014_s22_q);
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

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_974_s22_q;
  logic shown_right_we;
  assign shown_right_we = s22_en & and_995_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_989_s22_q, not_975_s22_q};
  end
`ifndef SYNTHESIS
  logic [6:0] shown_right_raddr_s20_sim;
  logic shown_right_re_s20_sim;
  logic [6:0] shown_right_raddr_s21_sim;
  logic shown_right_re_s21_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      shown_right_re_s20_sim <= 1'b0;
      shown_right_re_s21_sim <= 1'b0;
    end else if (en_i) begin
      shown_right_re_s20_sim <= shown_right_re;
      shown_right_raddr_s20_sim <= shown_right_raddr;
      shown_right_re_s21_sim <= shown_right_re_s20_sim;
      shown_right_raddr_s21_sim <= shown_right_raddr_s20_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_re_s20_sim && shown_right_raddr_s20_sim == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_re_s21_sim && shown_right_raddr_s21_sim == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 7'd120) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 7'd120) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s22_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s22_en & and_970_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s22_q[13:7], seen_columns_rdata_s22_q[5:0], near_s22_q, shown_s22_q, explained, and_1035, textured};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s21_sim;
  logic seen_columns_re_s21_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s21_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s21_sim <= seen_columns_re;
      seen_columns_raddr_s21_sim <= seen_columns_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s21_sim && seen_columns_raddr_s21_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 7'd120) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 7'd120) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      next_region_row_q <= 3'h0;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
    end else if (s22_en) begin
      region_row_q <= and_360_s22_q ? select_1896 : region_row_q;
      region_fresh_q <= and_360_s22_q ? select_1924 : region_fresh_q;
      segment_starts_q <= equal_944_s22_q ? or_1929 : select_1933;
      next_region_row_q <= region_row_q + 3'h1;
      centres_values_0_textured_q <= select_2026;
      centres_values_0_of_skin_q <= equal_944_s22_q ? centres_values_0_of_skin_q : select_2028;
      centres_values_1_textured_q <= equal_944_s22_q ? centres_values_1_textured_q : select_2030;
      centres_values_1_of_skin_q <= equal_944_s22_q ? centres_values_1_of_skin_q : select_2032;
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
      averager_quarter_1_0_q <= select_1169;
      averager_quarter_1_1_q <= select_1171;
      averager_quarter_2_0_q <= select_1173;
      averager_quarter_2_1_q <= select_1175;
      census_columns_values_0_cell_0_left_q <= select_1203;
      census_columns_values_0_cell_0_right_q <= select_1204;
      census_columns_values_0_cell_1_left_q <= select_1206;
      census_columns_values_0_cell_1_right_q <= select_1207;
      census_columns_values_0_cell_1_mask_q <= select_1208;
      census_columns_values_0_cell_2_left_q <= select_1209;
      census_columns_values_0_cell_2_right_q <= select_1210;
      census_columns_values_0_cell_2_mask_q <= select_1211;
      census_columns_values_0_cell_2_of_skin_q <= select_1212;
      census_columns_values_0_cell_3_left_q <= select_1213;
      census_columns_values_0_cell_3_right_q <= select_1214;
      census_columns_values_0_cell_3_mask_q <= select_1215;
      census_columns_values_0_cell_4_left_q <= select_1216;
      census_columns_values_0_cell_4_right_q <= select_1217;
      census_columns_values_0_cell_4_mask_q <= select_1218;
      census_columns_values_1_cell_0_left_q <= select_1219;
      census_columns_values_1_cell_0_right_q <= select_1220;
      census_columns_values_1_cell_1_left_q <= select_1222;
      census_columns_values_1_cell_1_right_q <= select_1223;
      census_columns_values_1_cell_2_left_q <= select_1225;
      census_columns_values_1_cell_2_right_q <= select_1226;
      census_columns_values_1_cell_2_of_skin_q <= select_1228;
      census_columns_values_1_cell_3_left_q <= select_1229;
      census_columns_values_1_cell_3_right_q <= select_1230;
      census_columns_values_1_cell_4_left_q <= select_1232;
      census_columns_values_1_cell_4_right_q <= select_1233;
      census_columns_values_2_cell_0_left_q <= select_1235;
      census_columns_values_2_cell_0_right_q <= select_1236;
      census_columns_values_2_cell_1_left_q <= select_1238;
      census_columns_values_2_cell_1_right_q <= select_1239;
      census_columns_values_2_cell_2_left_q <= select_1241;
      census_columns_values_2_cell_2_right_q <= select_1242;
      census_columns_values_2_cell_3_left_q <= select_1244;
      census_columns_values_2_cell_3_right_q <= select_1245;
      census_columns_values_2_cell_4_left_q <= select_1247;
      census_columns_values_2_cell_4_right_q <= select_1248;
      census_columns_values_3_cell_1_left_q <= select_1251;
      census_columns_values_3_cell_1_right_q <= select_1252;
      census_columns_values_3_cell_3_left_q <= select_1255;
      census_columns_values_3_cell_3_right_q <= select_1256;
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
  logic select_832_s23_q;
  logic or_839_s23_q;
  logic [7:0] select_840_s23_q;
  logic [5:0] select_841_s23_q;
  logic equal_846_s23_q;
  logic rise_s23_q;
  logic [1:0] sum_858_s23_q;
  logic [7:0] twice_s23_q;
  logic [8:0] select_869_s23_q;
  logic [6:0] select_924_s23_q;
  logic [5:0] select_925_s23_q;
  logic and_926_s23_q;
  logic equal_944_s23_q;
  logic not_945_s23_q;
  logic [2:0] select_968_s23_q;
  logic or_999_s23_q;
  logic or_1002_s23_q;
  logic or_1005_s23_q;
  logic equal_1007_s23_q;
  logic textured_s23_q;
  logic explained_s23_q;
  logic and_1028_s23_q;
  logic and_1033_s23_q;
  logic and_1072_s23_q;
  logic and_1073_s23_q;
  logic [1:0] sum_1077_s23_q;
  logic or_1090_s23_q;
  logic or_1093_s23_q;
  logic or_1096_s23_q;
  logic and_1106_s23_q;
  logic and_1107_s23_q;
  logic [1:0] sum_1111_s23_q;
  logic and_1122_s23_q;
  logic and_1123_s23_q;
  logic [1:0] sum_1127_s23_q;
  logic and_1145_s23_q;
  logic sum_1180_s23_q;
  logic [9:0] difference_1181_s23_q;
  logic sum_1188_s23_q;
  logic [9:0] difference_1189_s23_q;
  logic difference_1260_s23_q;
  logic [8:0] xor_1261_s23_q;
  logic difference_1263_s23_q;
  logic [8:0] xor_1264_s23_q;
  logic difference_1267_s23_q;
  logic [8:0] xor_1268_s23_q;
  logic difference_1271_s23_q;
  logic [8:0] xor_1272_s23_q;
  logic difference_1275_s23_q;
  logic [8:0] xor_1276_s23_q;
  logic equal_1285_s23_q;
  logic difference_1305_s23_q;
  logic [8:0] xor_1306_s23_q;
  logic difference_1316_s23_q;
  logic [8:0] xor_1317_s23_q;
  logic equal_1337_s23_q;
  logic and_1519_s23_q;
  logic and_1536_s23_q;
  logic and_1537_s23_q;
  logic [1:0] sum_1541_s23_q;
  logic [9:0] select_1611_s23_q;
  logic less_1614_s23_q;
  logic less_1616_s23_q;
  logic equal_1617_s23_q;
  logic equal_1618_s23_q;
  logic equal_1619_s23_q;
  logic [7:0] residual_s23_q;
  logic and_1702_s23_q;
  logic and_1711_s23_q;
  logic and_1720_s23_q;
  logic and_1728_s23_q;
  logic less_1740_s23_q;
  logic [1:0] select_1744_s23_q;
  logic not_1748_s23_q;
  logic less_1823_s23_q;
  logic [1:0] select_1827_s23_q;
  logic equal_2034_s23_q;
  logic and_2234_s23_q;
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
      centres_values_1_textured_s23_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_q;
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
      select_832_s23_q <= select_832_s22_q;
      or_839_s23_q <= or_839_s22_q;
      select_840_s23_q <= select_840_s22_q;
      select_841_s23_q <= select_841_s22_q;
      equal_846_s23_q <= equal_846_s22_q;
      rise_s23_q <= rise_s22_q;
      sum_858_s23_q <= sum_858_s22_q;
      twice_s23_q <= twice_s22_q;
      select_869_s23_q <= select_869;
      select_924_s23_q <= select_924_s22_q;
      select_925_s23_q <= select_925_s22_q;
      and_926_s23_q <= and_926_s22_q;
      equal_944_s23_q <= equal_944_s22_q;
      not_945_s23_q <= not_945_s22_q;
      select_968_s23_q <= {select_968_s22_q[4], select_968_s22_q[2], select_968_s22_q[0]};
      or_999_s23_q <= or_999_s22_q;
      or_1002_s23_q <= or_1002_s22_q;
      or_1005_s23_q <= or_1005_s22_q;
      equal_1007_s23_q <= equal_1007_s22_q;
      textured_s23_q <= textured;
      explained_s23_q <= explained;
      and_1028_s23_q <= and_1028;
      and_1033_s23_q <= not_945_s22_q & and_1014_s22_q;
      and_1072_s23_q <= seen_columns_rdata_s22_q[14] & select_968_s22_q[0];
      and_1073_s23_q <= seen_columns_rdata_s22_q[10] & select_968_s22_q[0];
      sum_1077_s23_q <= {1'b0, and_1074} + ({1'b0, textured} + {1'b0, and_1075});
      or_1090_s23_q <= or_1090_s22_q;
      or_1093_s23_q <= or_1093_s22_q;
      or_1096_s23_q <= or_1096_s22_q;
      and_1106_s23_q <= seen_columns_rdata_s22_q[16] & select_968_s22_q[0];
      and_1107_s23_q <= seen_columns_rdata_s22_q[12] & select_968_s22_q[0];
      sum_1111_s23_q <= {1'b0, and_1108} + ({1'b0, shown_s22_q} + {1'b0, and_1109});
      and_1122_s23_q <= seen_columns_rdata_s22_q[17] & select_968_s22_q[0];
      and_1123_s23_q <= seen_columns_rdata_s22_q[13] & select_968_s22_q[0];
      sum_1127_s23_q <= {1'b0, and_1124} + ({1'b0, near_s22_q} + {1'b0, and_1125});
      and_1145_s23_q <= and_1145_s22_q;
      sum_1180_s23_q <= sum_1180[0];
      difference_1181_s23_q <= {1'b0, sum_1180[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_1188_s23_q <= sum_1188[0];
      difference_1189_s23_q <= {1'b0, sum_1188[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_1260_s23_q <= difference_1260[9];
      xor_1261_s23_q <= difference_1260[8:0] ^ {9{difference_1260[9]}};
      difference_1263_s23_q <= difference_1263[9];
      xor_1264_s23_q <= difference_1263[8:0] ^ {9{difference_1263[9]}};
      difference_1267_s23_q <= difference_1267[9];
      xor_1268_s23_q <= difference_1267[8:0] ^ {9{difference_1267[9]}};
      difference_1271_s23_q <= difference_1271[9];
      xor_1272_s23_q <= difference_1271[8:0] ^ {9{difference_1271[9]}};
      difference_1275_s23_q <= difference_1275[9];
      xor_1276_s23_q <= difference_1275[8:0] ^ {9{difference_1275[9]}};
      equal_1285_s23_q <= equal_1285_s22_q;
      difference_1305_s23_q <= difference_1305[9];
      xor_1306_s23_q <= difference_1305[8:0] ^ {9{difference_1305[9]}};
      difference_1316_s23_q <= difference_1316[9];
      xor_1317_s23_q <= difference_1316[8:0] ^ {9{difference_1316[9]}};
      equal_1337_s23_q <= equal_1337_s22_q;
      and_1519_s23_q <= and_1519;
      and_1536_s23_q <= seen_columns_rdata_s22_q[15] & select_968_s22_q[0];
      and_1537_s23_q <= seen_columns_rdata_s22_q[11] & select_968_s22_q[0];
      sum_1541_s23_q <= {1'b0, and_1538} + ({1'b0, explained} + {1'b0, and_1539});
      select_1611_s23_q <= select_1611;
      less_1614_s23_q <= less_1614_s22_q;
      less_1616_s23_q <= less_1616_s22_q;
      equal_1617_s23_q <= equal_1617;
      equal_1618_s23_q <= equal_1618;
      equal_1619_s23_q <= equal_1619;
      residual_s23_q <= residual_s22_q;
      and_1702_s23_q <= select_968_s22_q[0] & and_1701;
      and_1711_s23_q <= select_968_s22_q[0] & and_1710;
      and_1720_s23_q <= drew_s22_q & (select_968_s22_q[0] & and_1718);
      and_1728_s23_q <= not_945_s22_q & (drew_s22_q & and_1726);
      less_1740_s23_q <= less_1740;
      select_1744_s23_q <= drew_s22_q ? select_1743 : 2'h0;
      not_1748_s23_q <= not_1748;
      less_1823_s23_q <= less_1823;
      select_1827_s23_q <= select_968_s22_q[0] ? select_1826 : 2'h0;
      equal_2034_s23_q <= equal_2034_s22_q;
      and_2234_s23_q <= equal_944_s22_q & not_1008;
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
  logic segment_started_q;
  logic [13:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  // hls/stages/agreement.hpp:285
  logic equal_416;
  assign equal_416 = column_s23_q == 7'h0;
  logic [3:0] select_420;
  assign select_420 = equal_419_s23_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:286
  logic [4:0] select_421;
  assign select_421 = equal_416 ? {select_420, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_422;
  assign select_422 = equal_416 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:286
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
  // hls/stages/agreement.hpp:542
  logic [6:0] select_1018;
  assign select_1018 = segment_started_q ? segment_textured_q : 7'h0;
  logic [6:0] select_1023;
  assign select_1023 = segment_started_q ? segment_explained_q : 7'h0;
  logic [6:0] select_1029;
  assign select_1029 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:846
  logic or_1040;
  assign or_1040 = marks_first_s23_q | line_ended_q;
  // hls/stages/agreement.hpp:848
  logic [13:0] select_1042;
  assign select_1042 = marks_first_s23_q ? 14'h1 : (or_1040 ? {rows_passed_q[12:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:847
  logic [8:0] select_1044;
  assign select_1044 = or_1040 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:855
  logic select_1046;
  assign select_1046 = cfg_compete_i ? (or_1040 & select_1042[13]) : (select_1044[8] & select_1042[9]);
  // hls/stages/agreement.hpp:709
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1072_s23_q} + ({2'h0, and_1073_s23_q} + {1'b0, sum_1077_s23_q});
  // hls/stages/agreement.hpp:711
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1106_s23_q} + ({2'h0, and_1107_s23_q} + {1'b0, sum_1111_s23_q});
  // hls/stages/agreement.hpp:712
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1122_s23_q} + ({2'h0, and_1123_s23_q} + {1'b0, sum_1127_s23_q});
  // hls/stages/census.hpp:129
  logic [9:0] xor_1182;
  assign xor_1182 = {difference_1181_s23_q[8:0], sum_1180_s23_q} ^ {10{difference_1181_s23_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1181_s23_q[9]} + {1'b0, xor_1182};
  logic [9:0] xor_1190;
  assign xor_1190 = {difference_1189_s23_q[8:0], sum_1188_s23_q} ^ {10{difference_1189_s23_q[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1189_s23_q[9]} + {1'b0, xor_1190};
  // hls/stages/agreement.hpp:205
  logic select_1205;
  assign select_1205 = and_360_s23_q ? whole_2_s23_q : census_columns_values_0_cell_0_mask_q;
  logic select_1221;
  assign select_1221 = and_360_s23_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_1224;
  assign select_1224 = and_360_s23_q ? census_columns_values_0_cell_1_mask_s23_q : census_columns_values_1_cell_1_mask_q;
  logic select_1227;
  assign select_1227 = and_360_s23_q ? census_columns_values_0_cell_2_mask_s23_q : census_columns_values_1_cell_2_mask_q;
  logic select_1231;
  assign select_1231 = and_360_s23_q ? census_columns_values_0_cell_3_mask_s23_q : census_columns_values_1_cell_3_mask_q;
  logic select_1234;
  assign select_1234 = and_360_s23_q ? census_columns_values_0_cell_4_mask_s23_q : census_columns_values_1_cell_4_mask_q;
  logic select_1237;
  assign select_1237 = and_360_s23_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_1240;
  assign select_1240 = and_360_s23_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] sum_1262;
  assign sum_1262 = {9'h0, difference_1260_s23_q} + {1'b0, xor_1261_s23_q};
  logic [9:0] sum_1265;
  assign sum_1265 = {9'h0, difference_1263_s23_q} + {1'b0, xor_1264_s23_q};
  // hls/stages/census.hpp:273
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1305_s23_q} + xor_1306_s23_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1316_s23_q} + xor_1317_s23_q;
  // hls/stages/agreement.hpp:205
  logic and_1516;
  assign and_1516 = and_360_s23_q & (equal_419_s23_q & equal_1337_s23_q);
  // hls/stages/agreement.hpp:343
  logic and_1523;
  assign and_1523 = not_945_s23_q & (drew_s23_q & textured_s23_q);
  logic and_1527;
  assign and_1527 = not_945_s23_q & (drew_s23_q & explained_s23_q);
  logic and_1531;
  assign and_1531 = not_945_s23_q & (drew_s23_q & and_1028_s23_q);
  // hls/stages/agreement.hpp:710
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_1536_s23_q} + ({2'h0, and_1537_s23_q} + {1'b0, sum_1541_s23_q});
  // hls/stages/agreement.hpp:565
  logic [23:0] sum_1612;
  assign sum_1612 = counts_too_much_hidden_q + {{14{select_1611_s23_q[9]}}, select_1611_s23_q};
  // hls/stages/agreement.hpp:343
  logic and_1704;
  assign and_1704 = not_945_s23_q & (drew_s23_q & and_1702_s23_q);
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1706;
  assign select_1706 = and_1516 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1704});
  // hls/stages/agreement.hpp:343
  logic and_1713;
  assign and_1713 = not_945_s23_q & (drew_s23_q & and_1711_s23_q);
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1715;
  assign select_1715 = and_1516 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1713});
  // hls/stages/agreement.hpp:343
  logic and_1721;
  assign and_1721 = not_945_s23_q & and_1720_s23_q;
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1723;
  assign select_1723 = and_1516 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1721});
  logic [11:0] select_1730;
  assign select_1730 = and_1516 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1728_s23_q});
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1745;
  assign select_1745 = equal_944_s23_q ? 2'h0 : select_1744_s23_q;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1746;
  assign sum_1746 = registration_counts_votes_0_up_q + {{13{select_1745[1]}}, select_1745};
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1829;
  assign select_1829 = equal_944_s23_q ? 2'h0 : (drew_s23_q ? select_1827_s23_q : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1830;
  assign sum_1830 = registration_counts_half_votes_0_up_q + {{13{select_1829[1]}}, select_1829};
  // hls/stages/registration.hpp:79
  logic and_1840;
  assign and_1840 = less_1616_s23_q & less_1823_s23_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1842;
  assign select_1842 = select_968_s23_q[2] ? (less_1614_s23_q ? {and_1840, less_1616_s23_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1845;
  assign select_1845 = equal_944_s23_q ? 2'h0 : (drew_s23_q ? (select_968_s23_q[0] ? select_1842 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2108;
  assign sum_2108 = {1'b0, upper} + {1'b0, lower};
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
      segment_started_q <= 1'b0;
      rows_passed_q <= 14'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s23_en) begin
      census_filled_q <= and_360_s23_q ? {select_422[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_360_s23_q ? select_421 : rows_passed_above_q;
      counts_too_much_hidden_q <= and_1516 ? 24'h0 : sum_1612;
      registration_counts_measured_0_q <= select_1706;
      registration_counts_measured_1_q <= select_1715;
      registration_counts_measured_2_q <= select_1723;
      registration_counts_measured_3_q <= select_1730;
      registration_counts_votes_0_up_q <= and_1516 ? 15'h0 : sum_1746;
      registration_counts_half_votes_0_up_q <= and_1516 ? 15'h0 : sum_1830;
      segment_textured_q <= select_1018 + {6'h0, and_1523};
      segment_explained_q <= select_1023 + {6'h0, and_1527};
      segment_nearer_q <= select_1029 + {6'h0, and_1531};
      segment_started_q <= ~segment_starts_q;
      rows_passed_q <= select_1042;
      columns_passed_q <= {select_1044[7:0], or_1040};
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s23_en) begin
      census_columns_values_0_cell_0_mask_q <= select_1205;
      census_columns_values_1_cell_0_mask_q <= select_1221;
      census_columns_values_1_cell_1_mask_q <= select_1224;
      census_columns_values_1_cell_2_mask_q <= select_1227;
      census_columns_values_1_cell_3_mask_q <= select_1231;
      census_columns_values_1_cell_4_mask_q <= select_1234;
      census_columns_values_2_cell_0_mask_q <= select_1237;
      census_columns_values_2_cell_1_mask_q <= select_1240;
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
  logic age_s24_q;
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
  logic select_832_s24_q;
  logic or_839_s24_q;
  logic [7:0] select_840_s24_q;
  logic [5:0] select_841_s24_q;
  logic equal_846_s24_q;
  logic rise_s24_q;
  logic [1:0] sum_858_s24_q;
  logic [7:0] twice_s24_q;
  logic [8:0] difference_870_s24_q;
  logic [6:0] select_924_s24_q;
  logic [5:0] select_925_s24_q;
  logic and_926_s24_q;
  logic equal_944_s24_q;
  logic not_945_s24_q;
  logic [2:0] select_968_s24_q;
  logic or_999_s24_q;
  logic or_1002_s24_q;
  logic or_1005_s24_q;
  logic equal_1007_s24_q;
  logic [35:0] regions_rdata_s24_q;
  logic [6:0] sum_1019_s24_q;
  logic [6:0] sum_1024_s24_q;
  logic [6:0] sum_1030_s24_q;
  logic and_1033_s24_q;
  logic select_1046_s24_q;
  logic [2:0] textured_2_s24_q;
  logic or_1090_s24_q;
  logic or_1093_s24_q;
  logic or_1096_s24_q;
  logic [2:0] shown_2_s24_q;
  logic [2:0] near_2_s24_q;
  logic and_1145_s24_q;
  logic [10:0] size_2_s24_q;
  logic [10:0] size_3_s24_q;
  logic [10:0] sum_1266_s24_q;
  logic [9:0] sum_1269_s24_q;
  logic [9:0] sum_1273_s24_q;
  logic [9:0] sum_1277_s24_q;
  logic equal_1285_s24_q;
  logic [8:0] contrast_s24_q;
  logic [8:0] contrast_2_s24_q;
  logic equal_1337_s24_q;
  logic and_1516_s24_q;
  logic and_1519_s24_q;
  logic and_1523_s24_q;
  logic and_1527_s24_q;
  logic and_1531_s24_q;
  logic [2:0] explained_2_s24_q;
  logic less_1614_s24_q;
  logic less_1616_s24_q;
  logic equal_1617_s24_q;
  logic equal_1618_s24_q;
  logic equal_1619_s24_q;
  logic [7:0] residual_s24_q;
  logic less_1740_s24_q;
  logic not_1748_s24_q;
  logic less_1823_s24_q;
  logic [1:0] select_1845_s24_q;
  logic less_1953_s24_q;
  logic equal_2034_s24_q;
  logic [10:0] sum_2108_s24_q;
  logic less_2112_s24_q;
  logic less_2114_s24_q;
  logic less_2117_s24_q;
  logic less_2119_s24_q;
  logic less_2123_s24_q;
  logic less_2135_s24_q;
  logic and_2234_s24_q;
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
      age_s24_q <= age_s23_q;
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
      select_832_s24_q <= select_832_s23_q;
      or_839_s24_q <= or_839_s23_q;
      select_840_s24_q <= select_840_s23_q;
      select_841_s24_q <= select_841_s23_q;
      equal_846_s24_q <= equal_846_s23_q;
      rise_s24_q <= rise_s23_q;
      sum_858_s24_q <= sum_858_s23_q;
      twice_s24_q <= twice_s23_q;
      difference_870_s24_q <= {1'b0, twice_s23_q} - select_869_s23_q;
      select_924_s24_q <= select_924_s23_q;
      select_925_s24_q <= select_925_s23_q;
      and_926_s24_q <= and_926_s23_q;
      equal_944_s24_q <= equal_944_s23_q;
      not_945_s24_q <= not_945_s23_q;
      select_968_s24_q <= select_968_s23_q;
      or_999_s24_q <= or_999_s23_q;
      or_1002_s24_q <= or_1002_s23_q;
      or_1005_s24_q <= or_1005_s23_q;
      equal_1007_s24_q <= equal_1007_s23_q;
      regions_rdata_s24_q <= regions_rdata_q;
      sum_1019_s24_q <= {6'h0, textured_s23_q} + select_1018;
      sum_1024_s24_q <= {6'h0, explained_s23_q} + select_1023;
      sum_1030_s24_q <= {6'h0, and_1028_s23_q} + select_1029;
      and_1033_s24_q <= and_1033_s23_q;
      select_1046_s24_q <= select_1046;
      textured_2_s24_q <= textured_2;
      or_1090_s24_q <= or_1090_s23_q;
      or_1093_s24_q <= or_1093_s23_q;
      or_1096_s24_q <= or_1096_s23_q;
      shown_2_s24_q <= shown_2;
      near_2_s24_q <= near_2;
      and_1145_s24_q <= and_1145_s23_q;
      size_2_s24_q <= size_2;
      size_3_s24_q <= size_3;
      sum_1266_s24_q <= {1'b0, sum_1262} + {1'b0, sum_1265};
      sum_1269_s24_q <= {9'h0, difference_1267_s23_q} + {1'b0, xor_1268_s23_q};
      sum_1273_s24_q <= {9'h0, difference_1271_s23_q} + {1'b0, xor_1272_s23_q};
      sum_1277_s24_q <= {9'h0, difference_1275_s23_q} + {1'b0, xor_1276_s23_q};
      equal_1285_s24_q <= equal_1285_s23_q;
      contrast_s24_q <= contrast;
      contrast_2_s24_q <= contrast_2;
      equal_1337_s24_q <= equal_1337_s23_q;
      and_1516_s24_q <= and_1516;
      and_1519_s24_q <= and_1519_s23_q;
      and_1523_s24_q <= and_1523;
      and_1527_s24_q <= and_1527;
      and_1531_s24_q <= and_1531;
      explained_2_s24_q <= explained_2;
      less_1614_s24_q <= less_1614_s23_q;
      less_1616_s24_q <= less_1616_s23_q;
      equal_1617_s24_q <= equal_1617_s23_q;
      equal_1618_s24_q <= equal_1618_s23_q;
      equal_1619_s24_q <= equal_1619_s23_q;
      residual_s24_q <= residual_s23_q;
      less_1740_s24_q <= less_1740_s23_q;
      not_1748_s24_q <= not_1748_s23_q;
      less_1823_s24_q <= less_1823_s23_q;
      select_1845_s24_q <= select_1845;
      less_1953_s24_q <= $signed(24'h0) < $signed(counts_too_much_hidden_q);
      equal_2034_s24_q <= equal_2034_s23_q;
      sum_2108_s24_q <= sum_2108[13:3];
      less_2112_s24_q <= 11'he < left[12:2];
      less_2114_s24_q <= $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
      less_2117_s24_q <= 11'he < right[12:2];
      less_2119_s24_q <= $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
      less_2123_s24_q <= 11'he < upper[12:2];
      less_2135_s24_q <= 11'he < lower[12:2];
      and_2234_s24_q <= and_2234_s23_q;
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
  logic began_q;
  logic [3:0] seen_x_q;
  logic [3:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/agreement.hpp:286
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
  logic not_871;
  assign not_871 = ~difference_870_s24_q[8];
  logic [7:0] xor_872;
  assign xor_872 = twice_s24_q ^ {8{not_871}};
  logic [9:0] sum_873;
  assign sum_873 = {difference_870_s24_q[7:0], 1'b0, not_871} + {not_871, xor_872, not_871};
  // hls/stages/agreement.hpp:683
  logic [11:0] sum_1021;
  assign sum_1021 = {5'h0, sum_1019_s24_q} + (region_fresh_s24_q ? 12'h0 : regions_rdata_s24_q[11:0]);
  // hls/stages/agreement.hpp:684
  logic [11:0] sum_1026;
  assign sum_1026 = {5'h0, sum_1024_s24_q} + (region_fresh_s24_q ? 12'h0 : regions_rdata_s24_q[23:12]);
  // hls/stages/agreement.hpp:685
  logic [11:0] sum_1032;
  assign sum_1032 = {5'h0, sum_1030_s24_q} + (region_fresh_s24_q ? 12'h0 : regions_rdata_s24_q[35:24]);
  // hls/stages/agreement.hpp:206
  logic next_row;
  assign next_row = select_1046_s24_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:862
  logic [6:0] select_1049;
  assign select_1049 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:872
  logic equal_1052;
  assign equal_1052 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:845
  logic not_1059;
  assign not_1059 = ~marks_first_s24_q;
  // hls/stages/agreement.hpp:716
  logic [4:0] difference_1081;
  assign difference_1081 = {2'h0, textured_2_s24_q} - (age_s24_q ? box_textured_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:718
  logic [4:0] difference_1115;
  assign difference_1115 = {2'h0, shown_2_s24_q} - (age_s24_q ? box_shown_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:719
  logic [4:0] difference_1131;
  assign difference_1131 = {2'h0, near_2_s24_q} - (age_s24_q ? box_nearer_columns_values_4_q : 5'h0);
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2_s24_q} + (equal_363_s24_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1187;
  assign select_1187 = sample_pair_whole_s24_q ? (and_358_s24_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3_s24_q} + (equal_363_s24_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1195;
  assign select_1195 = sample_pair_whole_s24_q ? (and_358_s24_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:205
  logic select_1243;
  assign select_1243 = and_360_s24_q ? census_columns_values_1_cell_2_mask_s24_q : census_columns_values_2_cell_2_mask_q;
  logic select_1246;
  assign select_1246 = and_360_s24_q ? census_columns_values_1_cell_3_mask_s24_q : census_columns_values_2_cell_3_mask_q;
  logic select_1249;
  assign select_1249 = and_360_s24_q ? census_columns_values_1_cell_4_mask_s24_q : census_columns_values_2_cell_4_mask_q;
  logic select_1250;
  assign select_1250 = and_360_s24_q ? census_columns_values_2_cell_0_mask_s24_q : census_columns_values_3_cell_0_mask_q;
  logic select_1253;
  assign select_1253 = and_360_s24_q ? census_columns_values_2_cell_1_mask_s24_q : census_columns_values_3_cell_1_mask_q;
  logic select_1254;
  assign select_1254 = and_360_s24_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_1257;
  assign select_1257 = and_360_s24_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:192
  logic [10:0] sum_1270;
  assign sum_1270 = sum_1266_s24_q + {1'b0, sum_1269_s24_q};
  // hls/stages/agreement.hpp:717
  logic [4:0] difference_1545;
  assign difference_1545 = {2'h0, explained_2_s24_q} - (age_s24_q ? box_explained_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:755
  logic less_1559;
  assign less_1559 = region_row_s24_q < x_s24_q[5:3];
  // hls/stages/agreement.hpp:660
  logic [1:0] difference_1572;
  assign difference_1572 = 2'h0 - {1'b0, select_968_s24_q[2]};
  // hls/stages/agreement.hpp:664
  logic [9:0] select_1573;
  assign select_1573 = select_968_s24_q[1] ? {difference_1572, cfg_explained_limit_i} : 10'h0;
  // hls/stages/agreement.hpp:343
  logic [9:0] select_1576;
  assign select_1576 = equal_944_s24_q ? 10'h0 : (drew_s24_q ? (select_968_s24_q[0] ? select_1573 : 10'h0) : 10'h0);
  // hls/stages/registration.hpp:146
  logic less_1731;
  assign less_1731 = $signed(residual_s24_q) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1757;
  assign and_1757 = less_1740_s24_q & not_1748_s24_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1759;
  assign select_1759 = select_968_s24_q[2] ? (less_1614_s24_q ? {and_1757, not_1748_s24_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1762;
  assign select_1762 = equal_944_s24_q ? 2'h0 : (drew_s24_q ? (select_968_s24_q[0] ? select_1759 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:79
  logic and_1765;
  assign and_1765 = less_1616_s24_q & less_1731;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1767;
  assign select_1767 = select_968_s24_q[2] ? (less_1614_s24_q ? {and_1765, less_1616_s24_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:79
  logic and_1773;
  assign and_1773 = less_1616_s24_q & less_1740_s24_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1775;
  assign select_1775 = select_968_s24_q[2] ? (less_1614_s24_q ? {and_1773, less_1616_s24_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1778;
  assign select_1778 = equal_944_s24_q ? 2'h0 : (drew_s24_q ? (select_968_s24_q[0] ? select_1775 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:80
  logic not_1781;
  assign not_1781 = ~lower_half_s24_q;
  // hls/stages/agreement.hpp:186
  logic and_1782;
  assign and_1782 = less_1731 & not_1781;
  logic [1:0] select_1784;
  assign select_1784 = select_968_s24_q[2] ? (less_1614_s24_q ? {and_1782, not_1781} : 2'h0) : 2'h0;
  logic and_1790;
  assign and_1790 = less_1740_s24_q & not_1781;
  logic [1:0] select_1792;
  assign select_1792 = select_968_s24_q[2] ? (less_1614_s24_q ? {and_1790, not_1781} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1795;
  assign select_1795 = equal_944_s24_q ? 2'h0 : (drew_s24_q ? (select_968_s24_q[0] ? select_1792 : 2'h0) : 2'h0);
  // hls/stages/agreement.hpp:186
  logic and_1798;
  assign and_1798 = lower_half_s24_q & less_1731;
  logic [1:0] select_1800;
  assign select_1800 = select_968_s24_q[2] ? (less_1614_s24_q ? {and_1798, lower_half_s24_q} : 2'h0) : 2'h0;
  logic and_1806;
  assign and_1806 = lower_half_s24_q & less_1740_s24_q;
  logic [1:0] select_1808;
  assign select_1808 = select_968_s24_q[2] ? (less_1614_s24_q ? {and_1806, lower_half_s24_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1811;
  assign select_1811 = equal_944_s24_q ? 2'h0 : (drew_s24_q ? (select_968_s24_q[0] ? select_1808 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1846;
  assign sum_1846 = registration_counts_half_votes_1_up_q + {{13{select_1845_s24_q[1]}}, select_1845_s24_q};
  // hls/stages/agreement.hpp:186
  logic and_1856;
  assign and_1856 = less_1823_s24_q & not_1781;
  logic [1:0] select_1858;
  assign select_1858 = select_968_s24_q[2] ? (less_1614_s24_q ? {and_1856, not_1781} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1861;
  assign select_1861 = equal_944_s24_q ? 2'h0 : (drew_s24_q ? (select_968_s24_q[0] ? select_1858 : 2'h0) : 2'h0);
  // hls/stages/agreement.hpp:186
  logic and_1872;
  assign and_1872 = lower_half_s24_q & less_1823_s24_q;
  logic [1:0] select_1874;
  assign select_1874 = select_968_s24_q[2] ? (less_1614_s24_q ? {and_1872, lower_half_s24_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1877;
  assign select_1877 = equal_944_s24_q ? 2'h0 : (drew_s24_q ? (select_968_s24_q[0] ? select_1874 : 2'h0) : 2'h0);
  logic [4:0] select_1977;
  assign select_1977 = drew_s24_q ? {2'h0, textured_2_s24_q} : box_textured_columns_values_0_q;
  logic [4:0] select_1979;
  assign select_1979 = drew_s24_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1981;
  assign select_1981 = drew_s24_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1983;
  assign select_1983 = drew_s24_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1985;
  assign select_1985 = drew_s24_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1989;
  assign select_1989 = drew_s24_q ? {2'h0, explained_2_s24_q} : box_explained_columns_values_0_q;
  logic [4:0] select_1991;
  assign select_1991 = drew_s24_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1993;
  assign select_1993 = drew_s24_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1995;
  assign select_1995 = drew_s24_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1997;
  assign select_1997 = drew_s24_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_2001;
  assign select_2001 = drew_s24_q ? {2'h0, shown_2_s24_q} : box_shown_columns_values_0_q;
  logic [4:0] select_2003;
  assign select_2003 = drew_s24_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [4:0] select_2005;
  assign select_2005 = drew_s24_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [4:0] select_2007;
  assign select_2007 = drew_s24_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [4:0] select_2009;
  assign select_2009 = drew_s24_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [4:0] select_2013;
  assign select_2013 = drew_s24_q ? {2'h0, near_2_s24_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_2015;
  assign select_2015 = drew_s24_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_2017;
  assign select_2017 = drew_s24_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_2019;
  assign select_2019 = drew_s24_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_2021;
  assign select_2021 = drew_s24_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  // hls/stages/agreement.hpp:871
  logic [3:0] select_2051;
  assign select_2051 = select_1046_s24_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:206
  logic [7:0] select_2057;
  assign select_2057 = marks_first_s24_q ? (less_2053 ? {sum_2054, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:103
  logic less_2109;
  assign less_2109 = 11'h4 < sum_2108_s24_q;
  // hls/stages/registration.hpp:104
  logic or_2115;
  assign or_2115 = (~less_2112_s24_q) | less_2114_s24_q;
  logic select_2121;
  assign select_2121 = less_2109 ? (or_2115 ? less_2114_s24_q : less_2119_s24_q) : less_2119_s24_q;
  logic or_2122;
  assign or_2122 = (~less_2117_s24_q) | select_2121;
  // hls/stages/registration.hpp:119
  logic less_2125;
  assign less_2125 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/agreement.hpp:766
  logic [11:0] select_2242;
  assign select_2242 = equal_1007_s24_q ? 12'h0 : (less_1559 ? 12'h0 : regions_rdata_s24_q[35:24]);

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
      registration_counts_half_votes_1_up_q <= and_1516_s24_q ? 15'h0 : sum_1846;
      began_q <= not_1059 & (began_q | select_1046_s24_q);
      seen_x_q <= select_1046_s24_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s24_q ? 4'h0 : select_2051;
      seen_column_q <= select_1046_s24_q ? 8'h0 : (seen_column_q + {7'h0, equal_1052});
      seen_rows_left_q <= select_2057;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s24_q ? 13'h0 : (seen_base_q + {6'h0, select_1049});
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
    if (s24_en) begin
      averager_detail_0_q <= select_1187;
      averager_detail_1_q <= select_1195;
      census_columns_values_2_cell_2_mask_q <= select_1243;
      census_columns_values_2_cell_3_mask_q <= select_1246;
      census_columns_values_2_cell_4_mask_q <= select_1249;
      census_columns_values_3_cell_0_mask_q <= select_1250;
      census_columns_values_3_cell_1_mask_q <= select_1253;
      census_columns_values_3_cell_2_mask_q <= select_1254;
      census_columns_values_3_cell_3_mask_q <= select_1257;
      box_textured_columns_values_0_q <= equal_944_s24_q ? box_textured_columns_values_0_q : select_1977;
      box_textured_columns_values_1_q <= equal_944_s24_q ? box_textured_columns_values_1_q : select_1979;
      box_textured_columns_values_2_q <= equal_944_s24_q ? box_textured_columns_values_2_q : select_1981;
      box_textured_columns_values_3_q <= equal_944_s24_q ? box_textured_columns_values_3_q : select_1983;
      box_textured_columns_values_4_q <= equal_944_s24_q ? box_textured_columns_values_4_q : select_1985;
      box_explained_columns_values_0_q <= equal_944_s24_q ? box_explained_columns_values_0_q : select_1989;
      box_explained_columns_values_1_q <= equal_944_s24_q ? box_explained_columns_values_1_q : select_1991;
      box_explained_columns_values_2_q <= equal_944_s24_q ? box_explained_columns_values_2_q : select_1993;
      box_explained_columns_values_3_q <= equal_944_s24_q ? box_explained_columns_values_3_q : select_1995;
      box_explained_columns_values_4_q <= equal_944_s24_q ? box_explained_columns_values_4_q : select_1997;
      box_shown_columns_values_0_q <= equal_944_s24_q ? box_shown_columns_values_0_q : select_2001;
      box_shown_columns_values_1_q <= equal_944_s24_q ? box_shown_columns_values_1_q : select_2003;
      box_shown_columns_values_2_q <= equal_944_s24_q ? box_shown_columns_values_2_q : select_2005;
      box_shown_columns_values_3_q <= equal_944_s24_q ? box_shown_columns_values_3_q : select_2007;
      box_shown_columns_values_4_q <= equal_944_s24_q ? box_shown_columns_values_4_q : select_2009;
      box_nearer_columns_values_0_q <= equal_944_s24_q ? box_nearer_columns_values_0_q : select_2013;
      box_nearer_columns_values_1_q <= equal_944_s24_q ? box_nearer_columns_values_1_q : select_2015;
      box_nearer_columns_values_2_q <= equal_944_s24_q ? box_nearer_columns_values_2_q : select_2017;
      box_nearer_columns_values_3_q <= equal_944_s24_q ? box_nearer_columns_values_3_q : select_2019;
      box_nearer_columns_values_4_q <= equal_944_s24_q ? box_nearer_columns_values_4_q : select_2021;
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
  logic select_832_s25_q;
  logic or_839_s25_q;
  logic [7:0] select_840_s25_q;
  logic [5:0] select_841_s25_q;
  logic equal_846_s25_q;
  logic rise_s25_q;
  logic [1:0] sum_858_s25_q;
  logic [7:0] twice_s25_q;
  logic difference_870_s25_q;
  logic [9:0] sum_873_s25_q;
  logic [6:0] select_924_s25_q;
  logic [5:0] select_925_s25_q;
  logic and_926_s25_q;
  logic equal_944_s25_q;
  logic not_945_s25_q;
  logic [2:0] select_968_s25_q;
  logic or_999_s25_q;
  logic or_1002_s25_q;
  logic or_1005_s25_q;
  logic equal_1007_s25_q;
  logic [11:0] sum_1021_s25_q;
  logic [11:0] sum_1026_s25_q;
  logic [11:0] sum_1032_s25_q;
  logic and_1033_s25_q;
  logic not_1059_s25_q;
  logic [7:0] sum_1069_s25_q;
  logic [4:0] difference_1081_s25_q;
  logic equal_1082_s25_q;
  logic or_1090_s25_q;
  logic or_1093_s25_q;
  logic or_1096_s25_q;
  logic [4:0] difference_1115_s25_q;
  logic [4:0] difference_1131_s25_q;
  logic and_1145_s25_q;
  logic [11:0] sum_1274_s25_q;
  logic [9:0] sum_1277_s25_q;
  logic equal_1285_s25_q;
  logic [27:0] select_1299_s25_q;
  logic [8:0] contrast_s25_q;
  logic [8:0] contrast_2_s25_q;
  logic equal_1337_s25_q;
  logic and_1516_s25_q;
  logic and_1519_s25_q;
  logic and_1523_s25_q;
  logic and_1527_s25_q;
  logic and_1531_s25_q;
  logic equal_1534_s25_q;
  logic [4:0] difference_1545_s25_q;
  logic [11:0] select_1560_s25_q;
  logic [11:0] select_1563_s25_q;
  logic [9:0] select_1576_s25_q;
  logic less_1614_s25_q;
  logic less_1616_s25_q;
  logic equal_1617_s25_q;
  logic equal_1618_s25_q;
  logic equal_1619_s25_q;
  logic [7:0] residual_s25_q;
  logic less_1731_s25_q;
  logic not_1748_s25_q;
  logic [1:0] select_1762_s25_q;
  logic [1:0] select_1768_s25_q;
  logic [1:0] select_1778_s25_q;
  logic not_1781_s25_q;
  logic [1:0] select_1785_s25_q;
  logic [1:0] select_1795_s25_q;
  logic [1:0] select_1801_s25_q;
  logic [1:0] select_1811_s25_q;
  logic [1:0] select_1861_s25_q;
  logic [1:0] select_1877_s25_q;
  logic less_1953_s25_q;
  logic equal_2034_s25_q;
  logic less_2109_s25_q;
  logic less_2112_s25_q;
  logic or_2115_s25_q;
  logic less_2117_s25_q;
  logic or_2122_s25_q;
  logic less_2123_s25_q;
  logic less_2125_s25_q;
  logic select_2126_s25_q;
  logic less_2135_s25_q;
  logic and_2234_s25_q;
  logic [11:0] select_2243_s25_q;
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
      select_832_s25_q <= select_832_s24_q;
      or_839_s25_q <= or_839_s24_q;
      select_840_s25_q <= select_840_s24_q;
      select_841_s25_q <= select_841_s24_q;
      equal_846_s25_q <= equal_846_s24_q;
      rise_s25_q <= rise_s24_q;
      sum_858_s25_q <= sum_858_s24_q;
      twice_s25_q <= twice_s24_q;
      difference_870_s25_q <= difference_870_s24_q[8];
      sum_873_s25_q <= sum_873;
      select_924_s25_q <= select_924_s24_q;
      select_925_s25_q <= select_925_s24_q;
      and_926_s25_q <= and_926_s24_q;
      equal_944_s25_q <= equal_944_s24_q;
      not_945_s25_q <= not_945_s24_q;
      select_968_s25_q <= select_968_s24_q;
      or_999_s25_q <= or_999_s24_q;
      or_1002_s25_q <= or_1002_s24_q;
      or_1005_s25_q <= or_1005_s24_q;
      equal_1007_s25_q <= equal_1007_s24_q;
      sum_1021_s25_q <= sum_1021;
      sum_1026_s25_q <= sum_1026;
      sum_1032_s25_q <= sum_1032;
      and_1033_s25_q <= and_1033_s24_q;
      not_1059_s25_q <= not_1059;
      sum_1069_s25_q <= {2'h0, x_s24_q[7:2]} + 8'hff;
      difference_1081_s25_q <= difference_1081;
      equal_1082_s25_q <= x_s24_q == 8'h0;
      or_1090_s25_q <= or_1090_s24_q;
      or_1093_s25_q <= or_1093_s24_q;
      or_1096_s25_q <= or_1096_s24_q;
      difference_1115_s25_q <= difference_1115;
      difference_1131_s25_q <= difference_1131;
      and_1145_s25_q <= and_1145_s24_q;
      sum_1274_s25_q <= {1'b0, sum_1270} + {2'h0, sum_1273_s24_q};
      sum_1277_s25_q <= sum_1277_s24_q;
      equal_1285_s25_q <= equal_1285_s24_q;
      select_1299_s25_q <= sample_pair_whole_s24_q ? {detail_2, detail} : 28'h0;
      contrast_s25_q <= contrast_s24_q;
      contrast_2_s25_q <= contrast_2_s24_q;
      equal_1337_s25_q <= equal_1337_s24_q;
      and_1516_s25_q <= and_1516_s24_q;
      and_1519_s25_q <= and_1519_s24_q;
      and_1523_s25_q <= and_1523_s24_q;
      and_1527_s25_q <= and_1527_s24_q;
      and_1531_s25_q <= and_1531_s24_q;
      equal_1534_s25_q <= x_s24_q[7:1] == 7'h0;
      difference_1545_s25_q <= difference_1545;
      select_1560_s25_q <= less_1559 ? 12'h0 : regions_rdata_s24_q[11:0];
      select_1563_s25_q <= less_1559 ? 12'h0 : regions_rdata_s24_q[23:12];
      select_1576_s25_q <= select_1576;
      less_1614_s25_q <= less_1614_s24_q;
      less_1616_s25_q <= less_1616_s24_q;
      equal_1617_s25_q <= equal_1617_s24_q;
      equal_1618_s25_q <= equal_1618_s24_q;
      equal_1619_s25_q <= equal_1619_s24_q;
      residual_s25_q <= residual_s24_q;
      less_1731_s25_q <= less_1731;
      not_1748_s25_q <= not_1748_s24_q;
      select_1762_s25_q <= select_1762;
      select_1768_s25_q <= select_968_s24_q[0] ? select_1767 : 2'h0;
      select_1778_s25_q <= select_1778;
      not_1781_s25_q <= not_1781;
      select_1785_s25_q <= select_968_s24_q[0] ? select_1784 : 2'h0;
      select_1795_s25_q <= select_1795;
      select_1801_s25_q <= select_968_s24_q[0] ? select_1800 : 2'h0;
      select_1811_s25_q <= select_1811;
      select_1861_s25_q <= select_1861;
      select_1877_s25_q <= select_1877;
      less_1953_s25_q <= less_1953_s24_q;
      equal_2034_s25_q <= equal_2034_s24_q;
      less_2109_s25_q <= less_2109;
      less_2112_s25_q <= less_2112_s24_q;
      or_2115_s25_q <= or_2115;
      less_2117_s25_q <= less_2117_s24_q;
      or_2122_s25_q <= or_2122;
      less_2123_s25_q <= less_2123_s24_q;
      less_2125_s25_q <= less_2125;
      select_2126_s25_q <= or_2122 ? select_2121 : less_2125;
      less_2135_s25_q <= less_2135_s24_q;
      and_2234_s25_q <= and_2234_s24_q;
      select_2243_s25_q <= equal_944_s24_q ? select_2242 : 12'h0;
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
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic said_q;
  // hls/stages/agreement.hpp:286
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
  logic not_874;
  assign not_874 = ~sum_873_s25_q[9];
  logic [7:0] xor_875;
  assign xor_875 = twice_s25_q ^ {8{not_874}};
  // hls/stages/agreement.hpp:875
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:846
  logic select_1057;
  assign select_1057 = marks_first_s25_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:832
  logic [10:0] sum_1058;
  assign sum_1058 = {1'b0, {5{select_1057}}, 1'b0, {2{select_1057}}, 1'b0, select_1057} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:736
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1069_s25_q[7]}}, sum_1069_s25_q, x_s25_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:832
  logic [10:0] sum_1071;
  assign sum_1071 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:716
  logic [4:0] t;
  assign t = difference_1081_s25_q + (equal_1082_s25_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:723
  logic not_1097;
  assign not_1097 = ~region_row_s25_q[2];
  logic [2:0] select_1098;
  assign select_1098 = region_row_s25_q[1] ? {1'b0, not_1097, 1'b0} : {region_row_s25_q[2], 1'b0, not_1097};
  logic [5:0] select_1099;
  assign select_1099 = region_row_s25_q[0] ? {select_1098[2], 1'b0, select_1098[1], 1'b0, select_1098[0], 1'b0} : {1'b0, select_1098[2], 1'b0, select_1098[1], 1'b0, select_1098[0]};
  logic [11:0] select_1100;
  assign select_1100 = or_1096_s25_q ? {select_1099[5], 1'b0, select_1099[4], 1'b0, select_1099[3], 1'b0, select_1099[2], 1'b0, select_1099[1], 1'b0, select_1099[0], 1'b0} : {1'b0, select_1099[5], 1'b0, select_1099[4], 1'b0, select_1099[3], 1'b0, select_1099[2], 1'b0, select_1099[1], 1'b0, select_1099[0]};
  logic [23:0] select_1101;
  assign select_1101 = or_1093_s25_q ? {select_1100[11], 1'b0, select_1100[10], 1'b0, select_1100[9], 1'b0, select_1100[8], 1'b0, select_1100[7], 1'b0, select_1100[6], 1'b0, select_1100[5], 1'b0, select_1100[4], 1'b0, select_1100[3], 1'b0, select_1100[2], 1'b0, select_1100[1], 1'b0, select_1100[0], 1'b0} : {1'b0, select_1100[11], 1'b0, select_1100[10], 1'b0, select_1100[9], 1'b0, select_1100[8], 1'b0, select_1100[7], 1'b0, select_1100[6], 1'b0, select_1100[5], 1'b0, select_1100[4], 1'b0, select_1100[3], 1'b0, select_1100[2], 1'b0, select_1100[1], 1'b0, select_1100[0]};
  logic [47:0] select_1102;
  assign select_1102 = or_1090_s25_q ? {select_1101[23], 1'b0, select_1101[22], 1'b0, select_1101[21], 1'b0, select_1101[20], 1'b0, select_1101[19], 1'b0, select_1101[18], 1'b0, select_1101[17], 1'b0, select_1101[16], 1'b0, select_1101[15], 1'b0, select_1101[14], 1'b0, select_1101[13], 1'b0, select_1101[12], 1'b0, select_1101[11], 1'b0, select_1101[10], 1'b0, select_1101[9], 1'b0, select_1101[8], 1'b0, select_1101[7], 1'b0, select_1101[6], 1'b0, select_1101[5], 1'b0, select_1101[4], 1'b0, select_1101[3], 1'b0, select_1101[2], 1'b0, select_1101[1], 1'b0, select_1101[0], 1'b0} : {1'b0, select_1101[23], 1'b0, select_1101[22], 1'b0, select_1101[21], 1'b0, select_1101[20], 1'b0, select_1101[19], 1'b0, select_1101[18], 1'b0, select_1101[17], 1'b0, select_1101[16], 1'b0, select_1101[15], 1'b0, select_1101[14], 1'b0, select_1101[13], 1'b0, select_1101[12], 1'b0, select_1101[11], 1'b0, select_1101[10], 1'b0, select_1101[9], 1'b0, select_1101[8], 1'b0, select_1101[7], 1'b0, select_1101[6], 1'b0, select_1101[5], 1'b0, select_1101[4], 1'b0, select_1101[3], 1'b0, select_1101[2], 1'b0, select_1101[1], 1'b0, select_1101[0]};
  // hls/stages/agreement.hpp:718
  logic [4:0] around;
  assign around = difference_1115_s25_q + (equal_1082_s25_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:719
  logic [4:0] n;
  assign n = difference_1131_s25_q + (equal_1082_s25_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:205
  logic select_1258;
  assign select_1258 = and_360_s25_q ? census_columns_values_2_cell_4_mask_s25_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [11:0] sum_1278;
  assign sum_1278 = sum_1274_s25_q + {2'h0, sum_1277_s25_q};
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1280;
  assign select_1280 = and_360_s25_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1281;
  assign select_1281 = and_360_s25_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_1300;
  assign select_1300 = and_360_s25_q ? select_1299_s25_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_1301;
  assign select_1301 = and_360_s25_q ? select_1299_s25_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:275
  logic and_1304;
  assign and_1304 = whole_2_s25_q & (~(column_s25_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:287
  logic and_1310;
  assign and_1310 = and_1304 & (sharpness_last_mask_q & (7'h2 < contrast_s25_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1299_s25_q[13:0]};
  // hls/stages/agreement.hpp:287
  logic and_1321;
  assign and_1321 = and_1304 & (sharpness_last_mask_q & (7'h2 < contrast_2_s25_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1299_s25_q[27:14]};
  // hls/stages/agreement.hpp:566
  logic [13:0] select_1521;
  assign select_1521 = and_1516_s25_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1519_s25_q});
  logic [13:0] select_1525;
  assign select_1525 = and_1516_s25_q ? 14'h0 : (counts_textured_q + {13'h0, and_1523_s25_q});
  // hls/stages/agreement.hpp:717
  logic [4:0] e;
  assign e = difference_1545_s25_q + (equal_1082_s25_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:561
  logic [23:0] sum_1577;
  assign sum_1577 = counts_too_little_explained_q + {{14{select_1576_s25_q[9]}}, select_1576_s25_q};
  // hls/stages/agreement.hpp:186
  logic and_1732;
  assign and_1732 = less_1614_s25_q & less_1731_s25_q;
  logic [1:0] select_1734;
  assign select_1734 = select_968_s25_q[0] ? (select_968_s25_q[2] ? {and_1732, less_1614_s25_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:79
  logic and_1749;
  assign and_1749 = less_1731_s25_q & not_1748_s25_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1751;
  assign select_1751 = select_968_s25_q[2] ? (less_1614_s25_q ? {and_1749, not_1748_s25_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1754;
  assign select_1754 = equal_944_s25_q ? 2'h0 : (drew_s25_q ? (select_968_s25_q[0] ? select_1751 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1763;
  assign sum_1763 = registration_counts_votes_1_up_q + {{13{select_1762_s25_q[1]}}, select_1762_s25_q};
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1770;
  assign select_1770 = equal_944_s25_q ? 2'h0 : (drew_s25_q ? select_1768_s25_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1771;
  assign sum_1771 = registration_counts_votes_2_down_q + {{13{select_1770[1]}}, select_1770};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1779;
  assign sum_1779 = registration_counts_votes_2_up_q + {{13{select_1778_s25_q[1]}}, select_1778_s25_q};
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1787;
  assign select_1787 = equal_944_s25_q ? 2'h0 : (drew_s25_q ? select_1785_s25_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1788;
  assign sum_1788 = registration_counts_votes_3_down_q + {{13{select_1787[1]}}, select_1787};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1796;
  assign sum_1796 = registration_counts_votes_3_up_q + {{13{select_1795_s25_q[1]}}, select_1795_s25_q};
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1803;
  assign select_1803 = equal_944_s25_q ? 2'h0 : (drew_s25_q ? select_1801_s25_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1804;
  assign sum_1804 = registration_counts_votes_4_down_q + {{13{select_1803[1]}}, select_1803};
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1812;
  assign sum_1812 = registration_counts_votes_4_up_q + {{13{select_1811_s25_q[1]}}, select_1811_s25_q};
  // hls/stages/registration.hpp:146
  logic less_1814;
  assign less_1814 = $signed(residual_s25_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1815;
  assign and_1815 = not_1748_s25_q & less_1814;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1817;
  assign select_1817 = select_968_s25_q[2] ? (less_1614_s25_q ? {and_1815, not_1748_s25_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:79
  logic and_1832;
  assign and_1832 = less_1616_s25_q & less_1814;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1834;
  assign select_1834 = select_968_s25_q[2] ? (less_1614_s25_q ? {and_1832, less_1616_s25_q} : 2'h0) : 2'h0;
  logic and_1848;
  assign and_1848 = less_1814 & not_1781_s25_q;
  logic [1:0] select_1850;
  assign select_1850 = select_968_s25_q[2] ? (less_1614_s25_q ? {and_1848, not_1781_s25_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1862;
  assign sum_1862 = registration_counts_half_votes_2_up_q + {{13{select_1861_s25_q[1]}}, select_1861_s25_q};
  // hls/stages/agreement.hpp:186
  logic and_1864;
  assign and_1864 = lower_half_s25_q & less_1814;
  logic [1:0] select_1866;
  assign select_1866 = select_968_s25_q[2] ? (less_1614_s25_q ? {and_1864, lower_half_s25_q} : 2'h0) : 2'h0;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1878;
  assign sum_1878 = registration_counts_half_votes_3_up_q + {{13{select_1877_s25_q[1]}}, select_1877_s25_q};
  // hls/stages/agreement.hpp:766
  logic equal_1936;
  assign equal_1936 = x_s25_q == 6'h3f;
  // hls/stages/agreement.hpp:751
  logic and_1941;
  assign and_1941 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:758
  logic [12:0] sum_1945;
  assign sum_1945 = {1'b0, select_1563_s25_q} + {2'h0, select_1563_s25_q[11:1]};
  // hls/stages/agreement.hpp:768
  logic [7:0] select_1954;
  assign select_1954 = less_1953_s25_q ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1956;
  assign select_1956 = equal_944_s25_q ? (equal_1936 ? select_1954 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:149
  logic not_1957;
  assign not_1957 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:343
  logic [4:0] select_1988;
  assign select_1988 = equal_944_s25_q ? box_textured_sum_sums_values_0_q : (drew_s25_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_2000;
  assign select_2000 = equal_944_s25_q ? box_explained_sum_sums_values_0_q : (drew_s25_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_2012;
  assign select_2012 = equal_944_s25_q ? box_shown_sum_sums_values_0_q : (drew_s25_q ? around : box_shown_sum_sums_values_0_q);
  logic [4:0] select_2024;
  assign select_2024 = equal_944_s25_q ? box_nearer_sum_sums_values_0_q : (drew_s25_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:290
  logic [12:0] select_2037;
  assign select_2037 = equal_1337_s25_q ? (equal_2034_s25_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_2040;
  assign select_2040 = and_360_s25_q ? (equal_1337_s25_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:343
  logic [13:0] select_2076;
  assign select_2076 = equal_944_s25_q ? (equal_1936 ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_2078;
  assign select_2078 = equal_944_s25_q ? (equal_1936 ? counts_textured_q : 14'h0) : 14'h0;
  // hls/stages/registration.hpp:104
  logic select_2128;
  assign select_2128 = less_2109_s25_q ? select_2126_s25_q : (less_2112_s25_q ? select_2126_s25_q : less_2125_s25_q);
  logic or_2129;
  assign or_2129 = (~less_2123_s25_q) | select_2128;
  // hls/stages/registration.hpp:119
  logic less_2130;
  assign less_2130 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_2131;
  assign select_2131 = or_2129 ? select_2128 : less_2130;
  // hls/stages/agreement.hpp:770
  logic and_2154;
  assign and_2154 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2155;
  assign or_2155 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2154;
  logic select_2156;
  assign select_2156 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2155 : and_2154;
  logic and_2206;
  assign and_2206 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1954 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:343
  logic [11:0] select_2219;
  assign select_2219 = equal_944_s25_q ? (equal_1936 ? registration_counts_measured_0_s25_q : 12'h0) : 12'h0;
  logic [11:0] select_2221;
  assign select_2221 = equal_944_s25_q ? (equal_1936 ? registration_counts_measured_1_s25_q : 12'h0) : 12'h0;
  logic [11:0] select_2223;
  assign select_2223 = equal_944_s25_q ? (equal_1936 ? registration_counts_measured_2_s25_q : 12'h0) : 12'h0;
  logic [11:0] select_2225;
  assign select_2225 = equal_944_s25_q ? (equal_1936 ? registration_counts_measured_3_s25_q : 12'h0) : 12'h0;

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s25_q, or_1005_s25_q, or_1002_s25_q, or_999_s25_q};
  logic regions_we;
  assign regions_we = s25_en & and_1033_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1032_s25_q, sum_1026_s25_q, sum_1021_s25_q};
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
      counts_supervised_q <= select_1521;
      counts_textured_q <= select_1525;
      counts_too_little_explained_q <= and_1516_s25_q ? 24'h0 : sum_1577;
      registration_counts_votes_1_up_q <= and_1516_s25_q ? 15'h0 : sum_1763;
      registration_counts_votes_2_down_q <= and_1516_s25_q ? 15'h0 : sum_1771;
      registration_counts_votes_2_up_q <= and_1516_s25_q ? 15'h0 : sum_1779;
      registration_counts_votes_3_down_q <= and_1516_s25_q ? 15'h0 : sum_1788;
      registration_counts_votes_3_up_q <= and_1516_s25_q ? 15'h0 : sum_1796;
      registration_counts_votes_4_down_q <= and_1516_s25_q ? 15'h0 : sum_1804;
      registration_counts_votes_4_up_q <= and_1516_s25_q ? 15'h0 : sum_1812;
      registration_counts_half_votes_2_up_q <= and_1516_s25_q ? 15'h0 : sum_1862;
      registration_counts_half_votes_3_up_q <= and_1516_s25_q ? 15'h0 : sum_1878;
      hidden_for_q <= select_1956;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1957};
      begins_product_q <= drew_s25_q;
      map_row_q <= and_360_s25_q ? select_2037 : map_row_q;
      map_width_q <= select_2040;
      write_half_q <= marks_first_s25_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1057;
      done_q <= not_1059_s25_q & ((~begins_product_q) & (done_q | said_q));
      said_q <= equal_944_s25_q & equal_1936;
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
    box_shown_sum_sums_values_0_q = 5'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s25_en) begin
      census_columns_values_3_cell_4_mask_q <= select_1258;
      census_changes_values_0_left_q <= and_360_s25_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_360_s25_q ? sum_1278 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1280;
      census_changes_values_1_right_q <= select_1281;
      sharpness_last_mask_q <= and_360_s25_q ? whole_2_s25_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= select_1300;
      sharpness_last_detail_1_q <= select_1301;
      box_textured_sum_sums_values_0_q <= select_1988;
      box_explained_sum_sums_values_0_q <= select_2000;
      box_shown_sum_sums_values_0_q <= select_2012;
      box_nearer_sum_sums_values_0_q <= select_2024;
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
  logic select_832_s26_q;
  logic or_839_s26_q;
  logic [7:0] select_840_s26_q;
  logic [5:0] select_841_s26_q;
  logic equal_846_s26_q;
  logic rise_s26_q;
  logic [1:0] sum_858_s26_q;
  logic [7:0] twice_s26_q;
  logic difference_870_s26_q;
  logic sum_873_s26_q;
  logic [9:0] sum_876_s26_q;
  logic [6:0] select_924_s26_q;
  logic [5:0] select_925_s26_q;
  logic and_926_s26_q;
  logic equal_944_s26_q;
  logic not_945_s26_q;
  logic [2:0] select_968_s26_q;
  logic equal_1007_s26_q;
  logic [2:0] index_s26_q;
  logic [10:0] sum_1058_s26_q;
  logic and_1065_s26_q;
  logic less_1066_s26_q;
  logic [2:0] index_2_s26_q;
  logic [10:0] sum_1071_s26_q;
  logic [4:0] t_s26_q;
  logic [47:0] select_1102_s26_q;
  logic around_s26_q;
  logic [5:0] sum_1118_s26_q;
  logic less_1134_s26_q;
  logic and_1145_s26_q;
  logic equal_1285_s26_q;
  logic [12:0] sum_1286_s26_q;
  logic [12:0] select_1312_s26_q;
  logic [12:0] select_1323_s26_q;
  logic [8:0] select_1328_s26_q;
  logic [8:0] select_1332_s26_q;
  logic and_1516_s26_q;
  logic and_1527_s26_q;
  logic and_1531_s26_q;
  logic equal_1534_s26_q;
  logic e_s26_q;
  logic [5:0] sum_1548_s26_q;
  logic [11:0] select_1560_s26_q;
  logic [11:0] select_1563_s26_q;
  logic less_1614_s26_q;
  logic equal_1617_s26_q;
  logic equal_1618_s26_q;
  logic equal_1619_s26_q;
  logic [7:0] residual_s26_q;
  logic [1:0] select_1736_s26_q;
  logic [1:0] select_1754_s26_q;
  logic [1:0] select_1818_s26_q;
  logic [1:0] select_1835_s26_q;
  logic [1:0] select_1851_s26_q;
  logic [1:0] select_1867_s26_q;
  logic equal_1936_s26_q;
  logic equal_1937_s26_q;
  logic and_1941_s26_q;
  logic less_1942_s26_q;
  logic not_1947_s26_q;
  logic [13:0] select_2076_s26_q;
  logic [13:0] select_2078_s26_q;
  logic less_2109_s26_q;
  logic less_2112_s26_q;
  logic or_2115_s26_q;
  logic less_2117_s26_q;
  logic or_2122_s26_q;
  logic less_2123_s26_q;
  logic or_2129_s26_q;
  logic select_2131_s26_q;
  logic select_2132_s26_q;
  logic less_2135_s26_q;
  logic less_2138_s26_q;
  logic less_2146_s26_q;
  logic less_2147_s26_q;
  logic less_2148_s26_q;
  logic and_2149_s26_q;
  logic select_2156_s26_q;
  logic and_2208_s26_q;
  logic [11:0] select_2219_s26_q;
  logic [11:0] select_2221_s26_q;
  logic [11:0] select_2223_s26_q;
  logic [11:0] select_2225_s26_q;
  logic and_2234_s26_q;
  logic [5:0] select_2236_s26_q;
  logic [11:0] select_2243_s26_q;
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
      select_832_s26_q <= select_832_s25_q;
      or_839_s26_q <= or_839_s25_q;
      select_840_s26_q <= select_840_s25_q;
      select_841_s26_q <= select_841_s25_q;
      equal_846_s26_q <= equal_846_s25_q;
      rise_s26_q <= rise_s25_q;
      sum_858_s26_q <= sum_858_s25_q;
      twice_s26_q <= twice_s25_q;
      difference_870_s26_q <= difference_870_s25_q;
      sum_873_s26_q <= sum_873_s25_q[9];
      sum_876_s26_q <= {sum_873_s25_q[8:0], not_874} + {not_874, xor_875, not_874};
      select_924_s26_q <= select_924_s25_q;
      select_925_s26_q <= select_925_s25_q;
      and_926_s26_q <= and_926_s25_q;
      equal_944_s26_q <= equal_944_s25_q;
      not_945_s26_q <= not_945_s25_q;
      select_968_s26_q <= select_968_s25_q;
      equal_1007_s26_q <= equal_1007_s25_q;
      index_s26_q <= index[2:0];
      sum_1058_s26_q <= sum_1058;
      and_1065_s26_q <= began_q & (seen_x_q == 4'h0);
      less_1066_s26_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s26_q <= index_2[2:0];
      sum_1071_s26_q <= sum_1071;
      t_s26_q <= t;
      select_1102_s26_q <= select_1102;
      around_s26_q <= around[0];
      sum_1118_s26_q <= {1'b0, around} + {2'h0, around[4:1]};
      less_1134_s26_q <= {1'b0, around[4:1]} < n;
      and_1145_s26_q <= and_1145_s25_q;
      equal_1285_s26_q <= equal_1285_s25_q;
      sum_1286_s26_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1278};
      select_1312_s26_q <= and_1310 ? detail_3[14:2] : 13'h0;
      select_1323_s26_q <= and_1321 ? detail_4[14:2] : 13'h0;
      select_1328_s26_q <= and_1310 ? contrast_s25_q : 9'h0;
      select_1332_s26_q <= and_1321 ? contrast_2_s25_q : 9'h0;
      and_1516_s26_q <= and_1516_s25_q;
      and_1527_s26_q <= and_1527_s25_q;
      and_1531_s26_q <= and_1531_s25_q;
      equal_1534_s26_q <= equal_1534_s25_q;
      e_s26_q <= e[0];
      sum_1548_s26_q <= {1'b0, e} + {2'h0, e[4:1]};
      select_1560_s26_q <= select_1560_s25_q;
      select_1563_s26_q <= select_1563_s25_q;
      less_1614_s26_q <= less_1614_s25_q;
      equal_1617_s26_q <= equal_1617_s25_q;
      equal_1618_s26_q <= equal_1618_s25_q;
      equal_1619_s26_q <= equal_1619_s25_q;
      residual_s26_q <= residual_s25_q;
      select_1736_s26_q <= equal_944_s25_q ? 2'h0 : (drew_s25_q ? select_1734 : 2'h0);
      select_1754_s26_q <= select_1754;
      select_1818_s26_q <= select_968_s25_q[0] ? select_1817 : 2'h0;
      select_1835_s26_q <= select_968_s25_q[0] ? select_1834 : 2'h0;
      select_1851_s26_q <= select_968_s25_q[0] ? select_1850 : 2'h0;
      select_1867_s26_q <= select_968_s25_q[0] ? select_1866 : 2'h0;
      equal_1936_s26_q <= equal_1936;
      equal_1937_s26_q <= select_1560_s25_q[11:3] == 9'h0;
      and_1941_s26_q <= and_1941;
      less_1942_s26_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      not_1947_s26_q <= ~({sum_1945, select_1563_s25_q[0]} < {2'h0, select_1560_s25_q});
      select_2076_s26_q <= select_2076;
      select_2078_s26_q <= select_2078;
      less_2109_s26_q <= less_2109_s25_q;
      less_2112_s26_q <= less_2112_s25_q;
      or_2115_s26_q <= or_2115_s25_q;
      less_2117_s26_q <= less_2117_s25_q;
      or_2122_s26_q <= or_2122_s25_q;
      less_2123_s26_q <= less_2123_s25_q;
      or_2129_s26_q <= or_2129;
      select_2131_s26_q <= select_2131;
      select_2132_s26_q <= less_2117_s25_q ? select_2131 : less_2130;
      less_2135_s26_q <= less_2135_s25_q;
      less_2138_s26_q <= $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
      less_2146_s26_q <= $signed(15'h0) < $signed(registration_counts_votes_2_up_q);
      less_2147_s26_q <= $signed(15'h0) < $signed(registration_counts_votes_1_up_q);
      less_2148_s26_q <= $signed(15'h0) < $signed(registration_counts_votes_2_down_q);
      and_2149_s26_q <= less_2123_s25_q & less_2135_s25_q;
      select_2156_s26_q <= select_2156;
      and_2208_s26_q <= equal_1936 & (cfg_prove_i & and_2206);
      select_2219_s26_q <= select_2219;
      select_2221_s26_q <= select_2221;
      select_2223_s26_q <= select_2223;
      select_2225_s26_q <= select_2225;
      and_2234_s26_q <= and_2234_s25_q;
      select_2236_s26_q <= equal_944_s25_q ? (equal_1007_s25_q ? 6'h0 : x_s25_q) : 6'h0;
      select_2243_s26_q <= select_2243_s25_q;
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
  logic not_877;
  assign not_877 = ~sum_876_s26_q[9];
  logic [7:0] xor_878;
  assign xor_878 = twice_s26_q ^ {8{not_877}};
  logic [9:0] sum_879;
  assign sum_879 = {sum_876_s26_q[8:0], not_877} + {not_877, xor_878, not_877};
  logic not_880;
  assign not_880 = ~sum_879[9];
  // hls/stages/agreement.hpp:722
  logic equal_1085;
  assign equal_1085 = t_s26_q[4:1] == 4'h0;
  // hls/stages/agreement.hpp:723
  logic not_1105;
  assign not_1105 = ~((good_q & select_1102_s26_q) == 48'h0);
  // hls/stages/agreement.hpp:725
  logic is_seen;
  assign is_seen = equal_1085 ? not_1105 : (~({sum_1118_s26_q, around_s26_q} < {2'h0, t_s26_q}));
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1282;
  assign select_1282 = and_360_s26_q ? census_changes_values_1_left_s26_q : census_changes_values_2_left_q;
  logic [11:0] select_1283;
  assign select_1283 = and_360_s26_q ? census_changes_values_1_right_s26_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [13:0] sum_1287;
  assign sum_1287 = {2'h0, census_changes_values_1_right_s26_q} + {1'b0, sum_1286_s26_q};
  logic [13:0] sum_1288;
  assign sum_1288 = {2'h0, census_changes_values_2_right_q} + sum_1287;
  // hls/stages/census.hpp:277
  logic [23:0] select_1314;
  assign select_1314 = equal_1285_s26_q ? {11'h0, select_1312_s26_q} : (sharpness_sums_detail_0_q + {11'h0, select_1312_s26_q});
  logic [23:0] select_1325;
  assign select_1325 = equal_1285_s26_q ? {11'h0, select_1323_s26_q} : (sharpness_sums_detail_1_q + {11'h0, select_1323_s26_q});
  logic [23:0] sum_1329;
  assign sum_1329 = (equal_1285_s26_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1328_s26_q};
  logic [23:0] sum_1333;
  assign sum_1333 = (equal_1285_s26_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1332_s26_q};
  // hls/stages/agreement.hpp:724
  logic select_1551;
  assign select_1551 = equal_1085 ? not_1105 : (~({sum_1548_s26_q, e_s26_q} < {2'h0, t_s26_q}));
  // hls/stages/agreement.hpp:756
  logic [12:0] sum_1564;
  assign sum_1564 = {1'b0, select_1563_s26_q} + {3'h0, select_1563_s26_q[11:2]};
  // hls/stages/agreement.hpp:664
  logic [8:0] select_1587;
  assign select_1587 = select_968_s26_q[1] ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1737;
  assign sum_1737 = registration_counts_votes_0_down_q + {{13{select_1736_s26_q[1]}}, select_1736_s26_q};
  logic [14:0] sum_1755;
  assign sum_1755 = registration_counts_votes_1_down_q + {{13{select_1754_s26_q[1]}}, select_1754_s26_q};
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1820;
  assign select_1820 = equal_944_s26_q ? 2'h0 : (begins_product_q ? select_1818_s26_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1821;
  assign sum_1821 = registration_counts_half_votes_0_down_q + {{13{select_1820[1]}}, select_1820};
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1837;
  assign select_1837 = equal_944_s26_q ? 2'h0 : (begins_product_q ? select_1835_s26_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1838;
  assign sum_1838 = registration_counts_half_votes_1_down_q + {{13{select_1837[1]}}, select_1837};
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1853;
  assign select_1853 = equal_944_s26_q ? 2'h0 : (begins_product_q ? select_1851_s26_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1854;
  assign sum_1854 = registration_counts_half_votes_2_down_q + {{13{select_1853[1]}}, select_1853};
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1869;
  assign select_1869 = equal_944_s26_q ? 2'h0 : (begins_product_q ? select_1867_s26_q : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1870;
  assign sum_1870 = registration_counts_half_votes_3_down_q + {{13{select_1869[1]}}, select_1869};
  // hls/stages/agreement.hpp:758
  logic select_1948;
  assign select_1948 = equal_1937_s26_q ? (and_1941_s26_q & (~less_1942_s26_q)) : not_1947_s26_q;
  // hls/stages/agreement.hpp:766
  logic [47:0] select_1949;
  assign select_1949 = equal_1007_s26_q ? good_next_q : {select_1948, good_next_q[47:1]};
  // hls/stages/agreement.hpp:343
  logic [47:0] select_1951;
  assign select_1951 = equal_944_s26_q ? (equal_1936_s26_q ? select_1949 : good_q) : good_q;
  // hls/stages/agreement.hpp:783
  logic [35:0] select_1968;
  assign select_1968 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:777
  logic [35:0] detail_left;
  assign detail_left = begins_product_s26_q ? 36'h0 : select_1968;
  // hls/stages/agreement.hpp:783
  logic [35:0] select_1971;
  assign select_1971 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:787
  logic [35:0] detail_right;
  assign detail_right = begins_product_s26_q ? 36'h0 : select_1971;
  // hls/stages/agreement.hpp:777
  logic [34:0] select_1973;
  assign select_1973 = begins_product_s26_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:787
  logic [34:0] select_1974;
  assign select_1974 = begins_product_s26_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:777
  logic [17:0] select_1975;
  assign select_1975 = begins_product_s26_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:787
  logic [17:0] select_1976;
  assign select_1976 = begins_product_s26_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:875
  logic and_2063;
  assign and_2063 = and_1145_s26_q & ({sum_1071_s26_q, index_2_s26_q} == {sum_1058_s26_q, index_s26_q});
  // hls/stages/registration.hpp:104
  logic select_2134;
  assign select_2134 = less_2109_s26_q ? select_2131_s26_q : (less_2112_s26_q ? select_2131_s26_q : select_2132_s26_q);
  logic or_2137;
  assign or_2137 = select_2134 | (~less_2135_s26_q);
  // hls/stages/registration.hpp:105
  logic select_2139;
  assign select_2139 = or_2137 ? select_2134 : less_2138_s26_q;
  // hls/stages/agreement.hpp:770
  logic and_2157;
  assign and_2157 = and_2149_s26_q & select_2156_s26_q;
  logic select_2159;
  assign select_2159 = less_2147_s26_q ? (less_2148_s26_q | and_2157) : and_2157;
  logic select_2161;
  assign select_2161 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? (less_2146_s26_q | select_2159) : select_2159;
  // hls/stages/registration.hpp:119
  logic less_2164;
  assign less_2164 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  logic less_2167;
  assign less_2167 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2170;
  assign less_2170 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2173;
  assign less_2173 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:343
  logic [23:0] select_2227;
  assign select_2227 = equal_944_s26_q ? (equal_1936_s26_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2229;
  assign select_2229 = equal_944_s26_q ? (equal_1936_s26_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [11:0] select_2240;
  assign select_2240 = equal_944_s26_q ? (equal_1007_s26_q ? 12'h0 : select_1563_s26_q) : 12'h0;

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:957; read in stage 26, written in stage 27: 26 < 27 < 26 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1058_s26_q, index_s26_q};
  logic map_re;
  assign map_re = s26_en & (and_1065_s26_q & less_1066_s26_q);
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
      sharpness_sums_detail_0_q <= and_360_s26_q ? select_1314 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_360_s26_q ? select_1325 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_360_s26_q ? sum_1329 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_360_s26_q ? sum_1333 : sharpness_sums_contrast_1_q;
      registration_counts_votes_0_down_q <= and_1516_s26_q ? 15'h0 : sum_1737;
      registration_counts_votes_1_down_q <= and_1516_s26_q ? 15'h0 : sum_1755;
      registration_counts_half_votes_0_down_q <= and_1516_s26_q ? 15'h0 : sum_1821;
      registration_counts_half_votes_1_down_q <= and_1516_s26_q ? 15'h0 : sum_1838;
      registration_counts_half_votes_2_down_q <= and_1516_s26_q ? 15'h0 : sum_1854;
      registration_counts_half_votes_3_down_q <= and_1516_s26_q ? 15'h0 : sum_1870;
      good_q <= select_1951;
      good_next_q <= equal_944_s26_q ? select_1949 : good_next_q;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1973;
      addend_1_q <= select_1974;
      multiplier_0_q <= select_1975;
      multiplier_1_q <= select_1976;
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
      census_changes_values_2_left_q <= select_1282;
      census_changes_values_2_right_q <= select_1283;
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
  logic select_832_s27_q;
  logic or_839_s27_q;
  logic [7:0] select_840_s27_q;
  logic [5:0] select_841_s27_q;
  logic equal_846_s27_q;
  logic rise_s27_q;
  logic [1:0] sum_858_s27_q;
  logic difference_870_s27_q;
  logic sum_873_s27_q;
  logic sum_876_s27_q;
  logic [9:0] sum_879_s27_q;
  logic not_880_s27_q;
  logic [7:0] xor_881_s27_q;
  logic [6:0] select_924_s27_q;
  logic [5:0] select_925_s27_q;
  logic and_926_s27_q;
  logic equal_944_s27_q;
  logic not_945_s27_q;
  logic [2:0] select_968_s27_q;
  logic equal_1007_s27_q;
  logic and_1065_s27_q;
  logic less_1066_s27_q;
  logic [2:0] index_2_s27_q;
  logic [10:0] sum_1071_s27_q;
  logic is_seen_s27_q;
  logic less_1134_s27_q;
  logic and_1145_s27_q;
  logic equal_1285_s27_q;
  logic [8:0] sum_1288_s27_q;
  logic and_1516_s27_q;
  logic and_1527_s27_q;
  logic and_1531_s27_q;
  logic equal_1534_s27_q;
  logic select_1551_s27_q;
  logic [11:0] select_1560_s27_q;
  logic less_1565_s27_q;
  logic [7:0] select_1588_s27_q;
  logic and_1589_s27_q;
  logic less_1614_s27_q;
  logic equal_1617_s27_q;
  logic equal_1618_s27_q;
  logic equal_1619_s27_q;
  logic [7:0] residual_s27_q;
  logic equal_1936_s27_q;
  logic and_1941_s27_q;
  logic less_1942_s27_q;
  logic and_2048_s27_q;
  logic and_2063_s27_q;
  logic [13:0] select_2076_s27_q;
  logic [13:0] select_2078_s27_q;
  logic less_2109_s27_q;
  logic less_2110_s27_q;
  logic less_2112_s27_q;
  logic or_2115_s27_q;
  logic less_2117_s27_q;
  logic or_2122_s27_q;
  logic less_2123_s27_q;
  logic or_2129_s27_q;
  logic less_2135_s27_q;
  logic or_2137_s27_q;
  logic select_2139_s27_q;
  logic select_2140_s27_q;
  logic select_2162_s27_q;
  logic less_2164_s27_q;
  logic less_2167_s27_q;
  logic less_2170_s27_q;
  logic less_2173_s27_q;
  logic and_2209_s27_q;
  logic [11:0] select_2219_s27_q;
  logic [11:0] select_2221_s27_q;
  logic [11:0] select_2223_s27_q;
  logic [11:0] select_2225_s27_q;
  logic [23:0] select_2227_s27_q;
  logic [23:0] select_2229_s27_q;
  logic and_2234_s27_q;
  logic [5:0] select_2236_s27_q;
  logic [11:0] select_2240_s27_q;
  logic [11:0] select_2243_s27_q;
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
      select_832_s27_q <= select_832_s26_q;
      or_839_s27_q <= or_839_s26_q;
      select_840_s27_q <= select_840_s26_q;
      select_841_s27_q <= select_841_s26_q;
      equal_846_s27_q <= equal_846_s26_q;
      rise_s27_q <= rise_s26_q;
      sum_858_s27_q <= sum_858_s26_q;
      difference_870_s27_q <= difference_870_s26_q;
      sum_873_s27_q <= sum_873_s26_q;
      sum_876_s27_q <= sum_876_s26_q[9];
      sum_879_s27_q <= sum_879;
      not_880_s27_q <= not_880;
      xor_881_s27_q <= twice_s26_q ^ {8{not_880}};
      select_924_s27_q <= select_924_s26_q;
      select_925_s27_q <= select_925_s26_q;
      and_926_s27_q <= and_926_s26_q;
      equal_944_s27_q <= equal_944_s26_q;
      not_945_s27_q <= not_945_s26_q;
      select_968_s27_q <= select_968_s26_q;
      equal_1007_s27_q <= equal_1007_s26_q;
      and_1065_s27_q <= and_1065_s26_q;
      less_1066_s27_q <= less_1066_s26_q;
      index_2_s27_q <= index_2_s26_q;
      sum_1071_s27_q <= sum_1071_s26_q;
      is_seen_s27_q <= is_seen;
      less_1134_s27_q <= less_1134_s26_q;
      and_1145_s27_q <= and_1145_s26_q;
      equal_1285_s27_q <= equal_1285_s26_q;
      sum_1288_s27_q <= sum_1288[13:5];
      and_1516_s27_q <= and_1516_s26_q;
      and_1527_s27_q <= and_1527_s26_q;
      and_1531_s27_q <= and_1531_s26_q;
      equal_1534_s27_q <= equal_1534_s26_q;
      select_1551_s27_q <= select_1551;
      select_1560_s27_q <= select_1560_s26_q;
      less_1565_s27_q <= {sum_1564, select_1563_s26_q[1:0]} < {3'h0, select_1560_s26_q};
      select_1588_s27_q <= select_968_s26_q[0] ? select_1587[7:0] : 8'h0;
      and_1589_s27_q <= select_968_s26_q[0] & select_1587[8];
      less_1614_s27_q <= less_1614_s26_q;
      equal_1617_s27_q <= equal_1617_s26_q;
      equal_1618_s27_q <= equal_1618_s26_q;
      equal_1619_s27_q <= equal_1619_s26_q;
      residual_s27_q <= residual_s26_q;
      equal_1936_s27_q <= equal_1936_s26_q;
      and_1941_s27_q <= and_1941_s26_q;
      less_1942_s27_q <= less_1942_s26_q;
      and_2048_s27_q <= said_q;
      and_2063_s27_q <= and_2063;
      select_2076_s27_q <= select_2076_s26_q;
      select_2078_s27_q <= select_2078_s26_q;
      less_2109_s27_q <= less_2109_s26_q;
      less_2110_s27_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2112_s27_q <= less_2112_s26_q;
      or_2115_s27_q <= or_2115_s26_q;
      less_2117_s27_q <= less_2117_s26_q;
      or_2122_s27_q <= or_2122_s26_q;
      less_2123_s27_q <= less_2123_s26_q;
      or_2129_s27_q <= or_2129_s26_q;
      less_2135_s27_q <= less_2135_s26_q;
      or_2137_s27_q <= or_2137;
      select_2139_s27_q <= select_2139;
      select_2140_s27_q <= less_2123_s26_q ? select_2139 : less_2138_s26_q;
      select_2162_s27_q <= (less_2112_s26_q & less_2117_s26_q) ? select_2161 : and_2157;
      less_2164_s27_q <= less_2164;
      less_2167_s27_q <= less_2167;
      less_2170_s27_q <= less_2170;
      less_2173_s27_q <= less_2173;
      and_2209_s27_q <= equal_944_s26_q & and_2208_s26_q;
      select_2219_s27_q <= select_2219_s26_q;
      select_2221_s27_q <= select_2221_s26_q;
      select_2223_s27_q <= select_2223_s26_q;
      select_2225_s27_q <= select_2225_s26_q;
      select_2227_s27_q <= select_2227;
      select_2229_s27_q <= select_2229;
      and_2234_s27_q <= and_2234_s26_q;
      select_2236_s27_q <= select_2236_s26_q;
      select_2240_s27_q <= select_2240;
      select_2243_s27_q <= select_2243_s26_q;
    end
  end

  // Stage 27 ----------------------------------------------------------------------------------------------------------
  logic proven_q;
  // hls/stages/registration.hpp:28
  logic [9:0] sum_882;
  assign sum_882 = {sum_879_s27_q[8:0], not_880_s27_q} + {not_880_s27_q, xor_881_s27_q, not_880_s27_q};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_883;
  assign difference_883 = {sum_858_s27_q, select_832_s27_q, 5'h0} - {3'h0, difference_870_s27_q, sum_873_s27_q, sum_876_s27_q, sum_879_s27_q[9], sum_882[9]};
  // hls/stages/agreement.hpp:737
  logic and_1135;
  assign and_1135 = is_seen_s27_q & less_1134_s27_q;
  // hls/stages/agreement.hpp:729
  logic not_1552;
  assign not_1552 = ~select_1551_s27_q;
  // hls/stages/agreement.hpp:735
  logic and_1554;
  assign and_1554 = (~equal_1534_s27_q) & (centres_values_1_textured_s27_q & not_1552);
  // hls/stages/agreement.hpp:764
  logic [11:0] select_1567;
  assign select_1567 = ((~(select_1560_s27_q[11:4] == 8'h0)) & less_1565_s27_q) ? select_1560_s27_q : 12'h0;
  // hls/stages/agreement.hpp:664
  logic [8:0] select_1580;
  assign select_1580 = select_968_s27_q[1] ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:732
  logic [2:0] select_1591;
  assign select_1591 = select_1551_s27_q ? {3{and_1589_s27_q}} : ({3{and_1589_s27_q}} + 3'h1);
  // hls/stages/agreement.hpp:735
  logic [2:0] select_1592;
  assign select_1592 = centres_values_1_textured_s27_q ? select_1591 : {3{and_1589_s27_q}};
  logic [9:0] select_1599;
  assign select_1599 = centres_values_1_of_skin_s27_q ? ({1'b0, not_1552, 8'h0} - {2'h0, cfg_unproven_skin_limit_i}) : 10'h0;
  logic [9:0] select_1601;
  assign select_1601 = equal_1534_s27_q ? 10'h0 : (centres_values_1_textured_s27_q ? select_1599 : 10'h0);
  // hls/stages/agreement.hpp:343
  logic and_2090;
  assign and_2090 = equal_944_s27_q & (equal_1936_s27_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/registration.hpp:105
  logic select_2142;
  assign select_2142 = less_2112_s27_q ? select_2139_s27_q : (less_2117_s27_q ? select_2139_s27_q : select_2140_s27_q);
  // hls/stages/agreement.hpp:770
  logic or_2163;
  assign or_2163 = (less_2109_s27_q ? select_2139_s27_q : select_2142) | select_2162_s27_q;
  // hls/stages/agreement.hpp:343
  logic [11:0] select_2238;
  assign select_2238 = equal_944_s27_q ? (equal_1007_s27_q ? 12'h0 : select_1560_s27_q) : 12'h0;

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1071_s27_q, index_2_s27_q};
  logic map_we;
  assign map_we = s27_en & and_1145_s27_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1135, is_seen_s27_q};
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
  logic select_832_s28_q;
  logic or_839_s28_q;
  logic [7:0] select_840_s28_q;
  logic [5:0] select_841_s28_q;
  logic equal_846_s28_q;
  logic rise_s28_q;
  logic [1:0] sum_858_s28_q;
  logic difference_870_s28_q;
  logic sum_873_s28_q;
  logic sum_876_s28_q;
  logic sum_879_s28_q;
  logic sum_882_s28_q;
  logic [7:0] difference_883_s28_q;
  logic [6:0] select_924_s28_q;
  logic [5:0] select_925_s28_q;
  logic and_926_s28_q;
  logic equal_944_s28_q;
  logic [1:0] select_968_s28_q;
  logic and_1065_s28_q;
  logic less_1066_s28_q;
  logic [1:0] map_rdata_s28_q;
  logic is_seen_s28_q;
  logic and_1135_s28_q;
  logic equal_1285_s28_q;
  logic and_1290_s28_q;
  logic and_1516_s28_q;
  logic and_1527_s28_q;
  logic and_1531_s28_q;
  logic and_1556_s28_q;
  logic [11:0] select_1568_s28_q;
  logic [8:0] select_1582_s28_q;
  logic [7:0] select_1588_s28_q;
  logic [2:0] select_1593_s28_q;
  logic [9:0] select_1602_s28_q;
  logic less_1614_s28_q;
  logic equal_1617_s28_q;
  logic equal_1618_s28_q;
  logic equal_1619_s28_q;
  logic [7:0] residual_s28_q;
  logic equal_1936_s28_q;
  logic and_1941_s28_q;
  logic less_1942_s28_q;
  logic [35:0] detail_left_s28_q;
  logic [35:0] detail_right_s28_q;
  logic and_2048_s28_q;
  logic and_2063_s28_q;
  logic [13:0] select_2076_s28_q;
  logic [13:0] select_2078_s28_q;
  logic and_2090_s28_q;
  logic less_2109_s28_q;
  logic less_2110_s28_q;
  logic less_2112_s28_q;
  logic or_2115_s28_q;
  logic less_2117_s28_q;
  logic or_2122_s28_q;
  logic less_2123_s28_q;
  logic or_2129_s28_q;
  logic less_2135_s28_q;
  logic or_2137_s28_q;
  logic select_2162_s28_q;
  logic or_2163_s28_q;
  logic or_2165_s28_q;
  logic less_2167_s28_q;
  logic less_2170_s28_q;
  logic less_2173_s28_q;
  logic [36:0] sum_2186_s28_q;
  logic [36:0] sum_2195_s28_q;
  logic and_2209_s28_q;
  logic [11:0] select_2219_s28_q;
  logic [11:0] select_2221_s28_q;
  logic [11:0] select_2223_s28_q;
  logic [11:0] select_2225_s28_q;
  logic [23:0] select_2227_s28_q;
  logic [23:0] select_2229_s28_q;
  logic and_2234_s28_q;
  logic [5:0] select_2236_s28_q;
  logic [11:0] select_2238_s28_q;
  logic [11:0] select_2240_s28_q;
  logic [11:0] select_2243_s28_q;
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
      select_832_s28_q <= select_832_s27_q;
      or_839_s28_q <= or_839_s27_q;
      select_840_s28_q <= select_840_s27_q;
      select_841_s28_q <= select_841_s27_q;
      equal_846_s28_q <= equal_846_s27_q;
      rise_s28_q <= rise_s27_q;
      sum_858_s28_q <= sum_858_s27_q;
      difference_870_s28_q <= difference_870_s27_q;
      sum_873_s28_q <= sum_873_s27_q;
      sum_876_s28_q <= sum_876_s27_q;
      sum_879_s28_q <= sum_879_s27_q[9];
      sum_882_s28_q <= sum_882[9];
      difference_883_s28_q <= difference_883;
      select_924_s28_q <= select_924_s27_q;
      select_925_s28_q <= select_925_s27_q;
      and_926_s28_q <= and_926_s27_q;
      equal_944_s28_q <= equal_944_s27_q;
      select_968_s28_q <= {select_968_s27_q[2], select_968_s27_q[0]};
      and_1065_s28_q <= and_1065_s27_q;
      less_1066_s28_q <= less_1066_s27_q;
      map_rdata_s28_q <= map_rdata_q;
      is_seen_s28_q <= is_seen_s27_q;
      and_1135_s28_q <= and_1135;
      equal_1285_s28_q <= equal_1285_s27_q;
      and_1290_s28_q <= and_448_s27_q & (9'h4 < sum_1288_s27_q);
      and_1516_s28_q <= and_1516_s27_q;
      and_1527_s28_q <= and_1527_s27_q;
      and_1531_s28_q <= and_1531_s27_q;
      and_1556_s28_q <= not_945_s27_q & (drew_s27_q & and_1554);
      select_1568_s28_q <= equal_1007_s27_q ? 12'h0 : select_1567;
      select_1582_s28_q <= drew_s27_q ? (select_968_s27_q[0] ? select_1580 : 9'h0) : 9'h0;
      select_1588_s28_q <= select_1588_s27_q;
      select_1593_s28_q <= equal_1534_s27_q ? {3{and_1589_s27_q}} : select_1592;
      select_1602_s28_q <= drew_s27_q ? select_1601 : 10'h0;
      less_1614_s28_q <= less_1614_s27_q;
      equal_1617_s28_q <= equal_1617_s27_q;
      equal_1618_s28_q <= equal_1618_s27_q;
      equal_1619_s28_q <= equal_1619_s27_q;
      residual_s28_q <= residual_s27_q;
      equal_1936_s28_q <= equal_1936_s27_q;
      and_1941_s28_q <= and_1941_s27_q;
      less_1942_s28_q <= less_1942_s27_q;
      detail_left_s28_q <= product_0_q;
      detail_right_s28_q <= product_1_q;
      and_2048_s28_q <= and_2048_s27_q;
      and_2063_s28_q <= and_2063_s27_q;
      select_2076_s28_q <= select_2076_s27_q;
      select_2078_s28_q <= select_2078_s27_q;
      and_2090_s28_q <= and_2090;
      less_2109_s28_q <= less_2109_s27_q;
      less_2110_s28_q <= less_2110_s27_q;
      less_2112_s28_q <= less_2112_s27_q;
      or_2115_s28_q <= or_2115_s27_q;
      less_2117_s28_q <= less_2117_s27_q;
      or_2122_s28_q <= or_2122_s27_q;
      less_2123_s28_q <= less_2123_s27_q;
      or_2129_s28_q <= or_2129_s27_q;
      less_2135_s28_q <= less_2135_s27_q;
      or_2137_s28_q <= or_2137_s27_q;
      select_2162_s28_q <= select_2162_s27_q;
      or_2163_s28_q <= or_2163;
      or_2165_s28_q <= less_2164_s27_q | or_2163;
      less_2167_s28_q <= less_2167_s27_q;
      less_2170_s28_q <= less_2170_s27_q;
      less_2173_s28_q <= less_2173_s27_q;
      sum_2186_s28_q <= {1'b0, product_1_q} + {3'h0, product_1_q[35:2]};
      sum_2195_s28_q <= {1'b0, product_0_q} + {3'h0, product_0_q[35:2]};
      and_2209_s28_q <= and_2209_s27_q;
      select_2219_s28_q <= select_2219_s27_q;
      select_2221_s28_q <= select_2221_s27_q;
      select_2223_s28_q <= select_2223_s27_q;
      select_2225_s28_q <= select_2225_s27_q;
      select_2227_s28_q <= select_2227_s27_q;
      select_2229_s28_q <= select_2229_s27_q;
      and_2234_s28_q <= and_2234_s27_q;
      select_2236_s28_q <= select_2236_s27_q;
      select_2238_s28_q <= select_2238;
      select_2240_s28_q <= select_2240_s27_q;
      select_2243_s28_q <= select_2243_s27_q;
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
  // hls/stages/agreement.hpp:496
  logic [7:0] select_884;
  assign select_884 = rise_s28_q ? difference_883_s28_q : {sum_858_s28_q, select_832_s28_q, difference_870_s28_q, sum_873_s28_q, sum_876_s28_q, sum_879_s28_q, sum_882_s28_q};
  logic [7:0] select_885;
  assign select_885 = equal_846_s28_q ? select_884 : {sum_858_s28_q, select_832_s28_q, 5'h0};
  // hls/stages/census.hpp:226
  logic and_1291;
  assign and_1291 = and_448_s28_q & less_472_s28_q;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1292;
  assign sum_1292 = census_left_misses_q + {{17{and_1291}}, and_1290_s28_q, 1'b0, and_1290_s28_q};
  // hls/stages/agreement.hpp:205
  logic [19:0] select_1294;
  assign select_1294 = and_360_s28_q ? (equal_1285_s28_q ? 20'h0 : sum_1292) : census_left_misses_q;
  // hls/stages/agreement.hpp:343
  logic [20:0] select_1583;
  assign select_1583 = equal_944_s28_q ? {1'b0, select_1568_s28_q, 8'h0} : {{12{select_1582_s28_q[8]}}, select_1582_s28_q};
  // hls/stages/agreement.hpp:566
  logic [23:0] select_1585;
  assign select_1585 = and_1516_s28_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1583[20]}}, select_1583});
  // hls/stages/agreement.hpp:343
  logic [10:0] select_1595;
  assign select_1595 = equal_944_s28_q ? 11'h0 : (drew_s28_q ? {select_1593_s28_q, select_1588_s28_q} : 11'h0);
  // hls/stages/agreement.hpp:563
  logic [23:0] sum_1596;
  assign sum_1596 = counts_too_much_unproven_q + {{13{select_1595[10]}}, select_1595};
  // hls/stages/agreement.hpp:343
  logic [9:0] select_1603;
  assign select_1603 = equal_944_s28_q ? 10'h0 : select_1602_s28_q;
  // hls/stages/agreement.hpp:564
  logic [23:0] sum_1604;
  assign sum_1604 = counts_too_much_unseen_skin_q + {{14{select_1603[9]}}, select_1603};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1659;
  assign select_1659 = equal_1618_s28_q ? 8'h0 : (equal_1619_s28_q ? 8'h0 : residual_s28_q);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1662;
  assign select_1662 = select_968_s28_q[1] ? (less_1614_s28_q ? (equal_1617_s28_q ? 8'h0 : select_1659) : 8'h0) : 8'h0;
  // hls/stages/registration.hpp:80
  logic [7:0] select_1669;
  assign select_1669 = equal_1618_s28_q ? 8'h0 : (equal_1619_s28_q ? residual_s28_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1672;
  assign select_1672 = select_968_s28_q[1] ? (less_1614_s28_q ? (equal_1617_s28_q ? 8'h0 : select_1669) : 8'h0) : 8'h0;
  // hls/stages/registration.hpp:80
  logic [7:0] select_1679;
  assign select_1679 = equal_1617_s28_q ? 8'h0 : (equal_1618_s28_q ? residual_s28_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1681;
  assign select_1681 = select_968_s28_q[1] ? (less_1614_s28_q ? select_1679 : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1684;
  assign select_1684 = equal_944_s28_q ? 8'h0 : (drew_s28_q ? (select_968_s28_q[0] ? select_1681 : 8'h0) : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1688;
  assign select_1688 = less_1614_s28_q ? (equal_1617_s28_q ? residual_s28_q : 8'h0) : 8'h0;
  logic [7:0] select_1690;
  assign select_1690 = select_968_s28_q[0] ? (select_968_s28_q[1] ? select_1688 : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:875
  logic [1:0] select_2064;
  assign select_2064 = and_2063_s28_q ? {and_1135_s28_q, is_seen_s28_q} : map_rdata_s28_q;
  // hls/stages/agreement.hpp:876
  logic and_2065;
  assign and_2065 = proven_q & less_2053;
  // hls/stages/agreement.hpp:770
  logic or_2101;
  assign or_2101 = ($signed(24'h0) < $signed(counts_too_much_unproven_q)) | ($signed(24'h0) < $signed(counts_too_much_unseen_skin_q));
  logic select_2166;
  assign select_2166 = or_2137_s28_q ? or_2163_s28_q : or_2165_s28_q;
  logic or_2168;
  assign or_2168 = less_2167_s28_q | select_2166;
  logic select_2169;
  assign select_2169 = or_2129_s28_q ? select_2166 : or_2168;
  logic or_2171;
  assign or_2171 = less_2170_s28_q | select_2169;
  logic select_2172;
  assign select_2172 = or_2122_s28_q ? select_2169 : or_2171;
  logic select_2178;
  assign select_2178 = less_2123_s28_q ? or_2168 : (less_2135_s28_q ? or_2165_s28_q : select_2162_s28_q);
  // hls/stages/agreement.hpp:811
  logic and_2185;
  assign and_2185 = cfg_prove_i & and_1941_s28_q;
  // hls/stages/agreement.hpp:812
  logic less_2187;
  assign less_2187 = {detail_left_s28_q, 3'h0} < {sum_2186_s28_q, detail_right_s28_q[1:0]};
  logic less_2188;
  assign less_2188 = {sharpness_sums_contrast_0_s28_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_s28_q};
  // hls/stages/agreement.hpp:770
  logic or_2191;
  assign or_2191 = less_2187 | (less_2188 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:815
  logic less_2196;
  assign less_2196 = {detail_right_s28_q, 3'h0} < {sum_2195_s28_q, detail_left_s28_q[1:0]};
  logic less_2197;
  assign less_2197 = {sharpness_sums_contrast_1_s28_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_s28_q};
  // hls/stages/agreement.hpp:343
  logic [23:0] select_2231;
  assign select_2231 = equal_944_s28_q ? (equal_1936_s28_q ? sharpness_sums_contrast_0_s28_q : 24'h0) : 24'h0;
  logic [23:0] select_2233;
  assign select_2233 = equal_944_s28_q ? (equal_1936_s28_q ? sharpness_sums_contrast_1_s28_q : 24'h0) : 24'h0;

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
      census_left_misses_q <= select_1294;
      counts_too_many_bad_q <= select_1585;
      counts_too_much_unproven_q <= and_1516_s28_q ? 24'h0 : sum_1596;
      counts_too_much_unseen_skin_q <= and_1516_s28_q ? 24'h0 : sum_1604;
    end
  end

  logic [7:0] pixel_0_s29_q;
  logic [7:0] pixel_1_s29_q;
  logic saturated_s29_q;
  logic mask_s29_q;
  logic marks_first_s29_q;
  logic marks_last_s29_q;
  logic [6:0] x_s29_q;
  logic [7:0] select_840_s29_q;
  logic [5:0] select_841_s29_q;
  logic [7:0] select_886_s29_q;
  logic [6:0] select_924_s29_q;
  logic [5:0] select_925_s29_q;
  logic and_926_s29_q;
  logic equal_944_s29_q;
  logic and_1065_s29_q;
  logic less_1066_s29_q;
  logic and_1516_s29_q;
  logic and_1527_s29_q;
  logic and_1531_s29_q;
  logic and_1556_s29_q;
  logic [11:0] select_1569_s29_q;
  logic [7:0] select_1664_s29_q;
  logic [7:0] select_1674_s29_q;
  logic [7:0] select_1684_s29_q;
  logic [7:0] select_1692_s29_q;
  logic equal_1936_s29_q;
  logic less_1942_s29_q;
  logic and_2048_s29_q;
  logic and_2066_s29_q;
  logic and_2069_s29_q;
  logic [13:0] select_2076_s29_q;
  logic [13:0] select_2078_s29_q;
  logic and_2090_s29_q;
  logic not_2091_s29_q;
  logic or_2102_s29_q;
  logic less_2109_s29_q;
  logic less_2110_s29_q;
  logic less_2112_s29_q;
  logic or_2115_s29_q;
  logic select_2172_s29_q;
  logic or_2174_s29_q;
  logic select_2179_s29_q;
  logic and_2192_s29_q;
  logic and_2199_s29_q;
  logic and_2209_s29_q;
  logic [11:0] select_2219_s29_q;
  logic [11:0] select_2221_s29_q;
  logic [11:0] select_2223_s29_q;
  logic [11:0] select_2225_s29_q;
  logic [23:0] select_2227_s29_q;
  logic [23:0] select_2229_s29_q;
  logic [23:0] select_2231_s29_q;
  logic [23:0] select_2233_s29_q;
  logic and_2234_s29_q;
  logic [5:0] select_2236_s29_q;
  logic [11:0] select_2238_s29_q;
  logic [11:0] select_2240_s29_q;
  logic [11:0] select_2243_s29_q;
  always_ff @(posedge clk_i) begin
    if (s28_en) begin
      pixel_0_s29_q <= pixel_0_s28_q;
      pixel_1_s29_q <= pixel_1_s28_q;
      saturated_s29_q <= saturated_s28_q;
      mask_s29_q <= mask_s28_q;
      marks_first_s29_q <= marks_first_s28_q;
      marks_last_s29_q <= marks_last_s28_q;
      x_s29_q <= x_s28_q;
      select_840_s29_q <= select_840_s28_q;
      select_841_s29_q <= select_841_s28_q;
      select_886_s29_q <= or_839_s28_q ? select_885 : best_left_rdata_s28_q;
      select_924_s29_q <= select_924_s28_q;
      select_925_s29_q <= select_925_s28_q;
      and_926_s29_q <= and_926_s28_q;
      equal_944_s29_q <= equal_944_s28_q;
      and_1065_s29_q <= and_1065_s28_q;
      less_1066_s29_q <= less_1066_s28_q;
      and_1516_s29_q <= and_1516_s28_q;
      and_1527_s29_q <= and_1527_s28_q;
      and_1531_s29_q <= and_1531_s28_q;
      and_1556_s29_q <= and_1556_s28_q;
      select_1569_s29_q <= equal_944_s28_q ? select_1568_s28_q : 12'h0;
      select_1664_s29_q <= drew_s28_q ? (select_968_s28_q[0] ? select_1662 : 8'h0) : 8'h0;
      select_1674_s29_q <= drew_s28_q ? (select_968_s28_q[0] ? select_1672 : 8'h0) : 8'h0;
      select_1684_s29_q <= select_1684;
      select_1692_s29_q <= equal_944_s28_q ? 8'h0 : (drew_s28_q ? select_1690 : 8'h0);
      equal_1936_s29_q <= equal_1936_s28_q;
      less_1942_s29_q <= less_1942_s28_q;
      and_2048_s29_q <= and_2048_s28_q;
      and_2066_s29_q <= select_2064[0] & and_2065;
      and_2069_s29_q <= select_2064[1] & and_2065;
      select_2076_s29_q <= select_2076_s28_q;
      select_2078_s29_q <= select_2078_s28_q;
      and_2090_s29_q <= and_2090_s28_q;
      not_2091_s29_q <= ~and_1941_s28_q;
      or_2102_s29_q <= ($signed(24'h0) < $signed(counts_too_many_bad_q)) | or_2101;
      less_2109_s29_q <= less_2109_s28_q;
      less_2110_s29_q <= less_2110_s28_q;
      less_2112_s29_q <= less_2112_s28_q;
      or_2115_s29_q <= or_2115_s28_q;
      select_2172_s29_q <= select_2172;
      or_2174_s29_q <= less_2173_s28_q | select_2172;
      select_2179_s29_q <= less_2117_s28_q ? or_2171 : select_2178;
      and_2192_s29_q <= and_2185 & or_2191;
      and_2199_s29_q <= and_2185 & (less_2196 | less_2197);
      and_2209_s29_q <= and_2209_s28_q;
      select_2219_s29_q <= select_2219_s28_q;
      select_2221_s29_q <= select_2221_s28_q;
      select_2223_s29_q <= select_2223_s28_q;
      select_2225_s29_q <= select_2225_s28_q;
      select_2227_s29_q <= select_2227_s28_q;
      select_2229_s29_q <= select_2229_s28_q;
      select_2231_s29_q <= select_2231;
      select_2233_s29_q <= select_2233;
      and_2234_s29_q <= and_2234_s28_q;
      select_2236_s29_q <= select_2236_s28_q;
      select_2238_s29_q <= select_2238_s28_q;
      select_2240_s29_q <= select_2240_s28_q;
      select_2243_s29_q <= select_2243_s28_q;
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
  // hls/stages/agreement.hpp:566
  logic [13:0] select_1529;
  assign select_1529 = and_1516_s29_q ? 14'h0 : (counts_explained_q + {13'h0, and_1527_s29_q});
  logic [13:0] select_1533;
  assign select_1533 = and_1516_s29_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1531_s29_q});
  logic [13:0] select_1558;
  assign select_1558 = and_1516_s29_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1556_s29_q});
  logic [13:0] select_1571;
  assign select_1571 = and_1516_s29_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1569_s29_q});
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1665;
  assign select_1665 = equal_944_s29_q ? 8'h0 : select_1664_s29_q;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1666;
  assign sum_1666 = registration_counts_across_0_q + {{12{select_1665[7]}}, select_1665};
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1675;
  assign select_1675 = equal_944_s29_q ? 8'h0 : select_1674_s29_q;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1676;
  assign sum_1676 = registration_counts_across_1_q + {{12{select_1675[7]}}, select_1675};
  logic [19:0] sum_1685;
  assign sum_1685 = registration_counts_across_2_q + {{12{select_1684_s29_q[7]}}, select_1684_s29_q};
  logic [19:0] sum_1693;
  assign sum_1693 = registration_counts_across_3_q + {{12{select_1692_s29_q[7]}}, select_1692_s29_q};
  // hls/stages/agreement.hpp:208
  logic select_2068;
  assign select_2068 = and_1065_s29_q ? (less_1066_s29_q ? and_2066_s29_q : seen_q) : seen_q;
  logic select_2071;
  assign select_2071 = and_1065_s29_q ? (less_1066_s29_q ? and_2069_s29_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:343
  logic [13:0] select_2080;
  assign select_2080 = equal_944_s29_q ? (equal_1936_s29_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_2082;
  assign select_2082 = equal_944_s29_q ? (equal_1936_s29_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_2084;
  assign select_2084 = equal_944_s29_q ? (equal_1936_s29_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_2086;
  assign select_2086 = equal_944_s29_q ? (equal_1936_s29_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic and_2094;
  assign and_2094 = equal_944_s29_q & (equal_1936_s29_q & (cfg_prove_i & not_2091_s29_q));
  // hls/stages/agreement.hpp:804
  logic or_2095;
  assign or_2095 = not_2072 | not_2091_s29_q;
  // hls/stages/agreement.hpp:343
  logic and_2104;
  assign and_2104 = equal_1936_s29_q & ((less_1942_s29_q | or_2095) ? (~or_2095) : or_2102_s29_q);
  // hls/stages/agreement.hpp:770
  logic or_2176;
  assign or_2176 = less_2110_s29_q | (or_2115_s29_q ? select_2172_s29_q : or_2174_s29_q);
  logic select_2181;
  assign select_2181 = less_2109_s29_q ? or_2176 : (less_2112_s29_q ? or_2174_s29_q : select_2179_s29_q);
  // hls/stages/agreement.hpp:343
  logic and_2184;
  assign and_2184 = equal_944_s29_q & (equal_1936_s29_q & (cfg_prove_i & select_2181));
  logic [19:0] select_2211;
  assign select_2211 = equal_944_s29_q ? (equal_1936_s29_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2213;
  assign select_2213 = equal_944_s29_q ? (equal_1936_s29_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2215;
  assign select_2215 = equal_944_s29_q ? (equal_1936_s29_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2217;
  assign select_2217 = equal_944_s29_q ? (equal_1936_s29_q ? registration_counts_across_3_q : 20'h0) : 20'h0;

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s29_q;
  logic best_left_we;
  assign best_left_we = s29_en & and_926_s29_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_925_s29_q, select_924_s29_q, select_886_s29_q, select_841_s29_q, select_840_s29_q};
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
      counts_explained_q <= select_1529;
      counts_nearer_q <= select_1533;
      counts_unproven_q <= select_1558;
      counts_regions_bad_q <= select_1571;
      registration_counts_across_0_q <= and_1516_s29_q ? 20'h0 : sum_1666;
      registration_counts_across_1_q <= and_1516_s29_q ? 20'h0 : sum_1676;
      registration_counts_across_2_q <= and_1516_s29_q ? 20'h0 : sum_1685;
      registration_counts_across_3_q <= and_1516_s29_q ? 20'h0 : sum_1693;
      seen_q <= select_2068;
      nearer_q <= select_2071;
    end
  end

  logic [7:0] pixel_0_s30_q;
  logic [7:0] pixel_1_s30_q;
  logic saturated_s30_q;
  logic mask_s30_q;
  logic marks_first_s30_q;
  logic marks_last_s30_q;
  logic and_2048_s30_q;
  logic or_2073_s30_q;
  logic and_2074_s30_q;
  logic [13:0] select_2076_s30_q;
  logic [13:0] select_2078_s30_q;
  logic [13:0] select_2080_s30_q;
  logic [13:0] select_2082_s30_q;
  logic [13:0] select_2084_s30_q;
  logic [13:0] select_2086_s30_q;
  logic and_2090_s30_q;
  logic and_2094_s30_q;
  logic and_2105_s30_q;
  logic and_2184_s30_q;
  logic and_2194_s30_q;
  logic and_2201_s30_q;
  logic and_2209_s30_q;
  logic [19:0] select_2211_s30_q;
  logic [19:0] select_2213_s30_q;
  logic [19:0] select_2215_s30_q;
  logic [19:0] select_2217_s30_q;
  logic [11:0] select_2219_s30_q;
  logic [11:0] select_2221_s30_q;
  logic [11:0] select_2223_s30_q;
  logic [11:0] select_2225_s30_q;
  logic [23:0] select_2227_s30_q;
  logic [23:0] select_2229_s30_q;
  logic [23:0] select_2231_s30_q;
  logic [23:0] select_2233_s30_q;
  logic and_2234_s30_q;
  logic [5:0] select_2236_s30_q;
  logic [11:0] select_2238_s30_q;
  logic [11:0] select_2240_s30_q;
  logic [11:0] select_2243_s30_q;
  always_ff @(posedge clk_i) begin
    if (s29_en) begin
      pixel_0_s30_q <= pixel_0_s29_q;
      pixel_1_s30_q <= pixel_1_s29_q;
      saturated_s30_q <= saturated_s29_q;
      mask_s30_q <= mask_s29_q;
      marks_first_s30_q <= marks_first_s29_q;
      marks_last_s30_q <= marks_last_s29_q;
      and_2048_s30_q <= and_2048_s29_q;
      or_2073_s30_q <= not_2072 | select_2068;
      and_2074_s30_q <= cfg_prove_i & select_2071;
      select_2076_s30_q <= select_2076_s29_q;
      select_2078_s30_q <= select_2078_s29_q;
      select_2080_s30_q <= select_2080;
      select_2082_s30_q <= select_2082;
      select_2084_s30_q <= select_2084;
      select_2086_s30_q <= select_2086;
      and_2090_s30_q <= and_2090_s29_q;
      and_2094_s30_q <= and_2094;
      and_2105_s30_q <= equal_944_s29_q & and_2104;
      and_2184_s30_q <= and_2184;
      and_2194_s30_q <= equal_944_s29_q & (equal_1936_s29_q & and_2192_s29_q);
      and_2201_s30_q <= equal_944_s29_q & (equal_1936_s29_q & and_2199_s29_q);
      and_2209_s30_q <= and_2209_s29_q;
      select_2211_s30_q <= select_2211;
      select_2213_s30_q <= select_2213;
      select_2215_s30_q <= select_2215;
      select_2217_s30_q <= select_2217;
      select_2219_s30_q <= select_2219_s29_q;
      select_2221_s30_q <= select_2221_s29_q;
      select_2223_s30_q <= select_2223_s29_q;
      select_2225_s30_q <= select_2225_s29_q;
      select_2227_s30_q <= select_2227_s29_q;
      select_2229_s30_q <= select_2229_s29_q;
      select_2231_s30_q <= select_2231_s29_q;
      select_2233_s30_q <= select_2233_s29_q;
      and_2234_s30_q <= and_2234_s29_q;
      select_2236_s30_q <= select_2236_s29_q;
      select_2238_s30_q <= select_2238_s29_q;
      select_2240_s30_q <= select_2240_s29_q;
      select_2243_s30_q <= select_2243_s29_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s30_q;
  assign pixel_1_o = pixel_1_s30_q;
  assign saturated_o = saturated_s30_q;
  assign mask_o = mask_s30_q;
  assign marks_first_o = marks_first_s30_q;
  assign marks_last_o = marks_last_s30_q;
  assign marks_seen_o = or_2073_s30_q;
  assign marks_nearer_o = and_2074_s30_q;
  assign verdict_valid_o = and_2048_s30_q;
  assign verdict_supervised_o = {2'h0, select_2076_s30_q};
  assign verdict_textured_o = {2'h0, select_2078_s30_q};
  assign verdict_explained_o = {2'h0, select_2080_s30_q};
  assign verdict_nearer_o = {2'h0, select_2082_s30_q};
  assign verdict_unproven_o = {2'h0, select_2084_s30_q};
  assign verdict_regions_bad_o = {2'h0, select_2086_s30_q};
  assign verdict_unproven_yet_o = and_2090_s30_q;
  assign verdict_untextured_o = and_2094_s30_q;
  assign verdict_disagree_o = and_2105_s30_q;
  assign verdict_moved_o = and_2184_s30_q;
  assign verdict_unsharp_left_o = and_2194_s30_q;
  assign verdict_unsharp_right_o = and_2201_s30_q;
  assign verdict_hidden_o = and_2209_s30_q;
  assign verdict_across_0_o = select_2211_s30_q;
  assign verdict_across_1_o = select_2213_s30_q;
  assign verdict_across_2_o = select_2215_s30_q;
  assign verdict_across_3_o = select_2217_s30_q;
  assign verdict_measured_0_o = select_2219_s30_q;
  assign verdict_measured_1_o = select_2221_s30_q;
  assign verdict_measured_2_o = select_2223_s30_q;
  assign verdict_measured_3_o = select_2225_s30_q;
  assign verdict_detail_0_o = select_2227_s30_q;
  assign verdict_detail_1_o = select_2229_s30_q;
  assign verdict_contrast_0_o = select_2231_s30_q;
  assign verdict_contrast_1_o = select_2233_s30_q;
  assign region_valid_o = and_2234_s30_q;
  assign region_region_o = select_2236_s30_q;
  assign region_textured_o = select_2238_s30_q;
  assign region_explained_o = select_2240_s30_q;
  assign region_nearer_o = select_2243_s30_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_2108[2:0], sum_1648[0], sum_1644[0], sum_1636[1:0], sum_1635[1:0], sum_1631[0], detail_4[1:0], detail_3[1:0], sum_1288[4:0], sum_882[8:0], sum_471[4:0], cfg_width_i[3:0]};

endmodule
