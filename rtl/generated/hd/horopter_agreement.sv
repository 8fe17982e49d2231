// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 28 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2126 bits, pipeline 8573 bits, memories 93504 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q, valid_s27_q, valid_s28_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en, s26_en, s27_en;
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

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [6:0] sum_2621;
  assign sum_2621 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] difference_2880;
  assign difference_2880 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_3081;
  assign less_3081 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_3082;
  assign sum_3082 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_3100;
  assign not_3100 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_376;
  assign select_376 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 4'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_376 + 4'h1) : raster_at_x_q;
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
  logic [3:0] raster_at_x_s1_q;
  logic raster_row_ended_s1_q;
  logic [3:0] select_376_s1_q;
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
      raster_at_x_s1_q <= raster_at_x_q;
      raster_row_ended_s1_q <= raster_row_ended_q;
      select_376_s1_q <= select_376;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:35
  logic [6:0] select_379;
  assign select_379 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/agreement.hpp:215
  logic [6:0] column;
  assign column = sample_pair_whole_s1_q ? select_379 : 7'h0;
  // hls/stages/census.hpp:45
  logic equal_414;
  assign equal_414 = select_376_s1_q == 4'hf;
  // hls/stages/agreement.hpp:215
  logic [6:0] select_2331;
  assign select_2331 = sample_pair_whole_s1_q ? (select_379 + {6'h0, equal_414}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2331;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic sample_pair_first_s2_q;
  logic sample_pair_whole_s2_q;
  logic sample_last_s2_q;
  logic sample_present_s2_q;
  logic [3:0] raster_at_x_s2_q;
  logic [6:0] raster_at_column_s2_q;
  logic raster_row_ended_s2_q;
  logic equal_377_s2_q;
  logic equal_380_s2_q;
  logic not_387_s2_q;
  logic [6:0] column_s2_q;
  logic equal_414_s2_q;
  logic equal_421_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_first_s2_q <= sample_pair_first_s1_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_last_s2_q <= sample_last_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      raster_at_x_s2_q <= raster_at_x_s1_q;
      raster_at_column_s2_q <= raster_at_column_q;
      raster_row_ended_s2_q <= raster_row_ended_s1_q;
      equal_377_s2_q <= select_376_s1_q[1:0] == 2'h0;
      equal_380_s2_q <= {select_379, select_376_s1_q} == 11'h0;
      not_387_s2_q <= ~(select_376_s1_q[1:0] == 2'h3);
      column_s2_q <= column;
      equal_414_s2_q <= equal_414;
      equal_421_s2_q <= select_376_s1_q == 4'h3;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:95
  logic [8:0] select_383;
  assign select_383 = equal_377_s2_q ? (equal_380_s2_q ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/census.hpp:40
  logic [3:0] select_397;
  assign select_397 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:215
  logic [3:0] select_2329;
  assign select_2329 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_397 + 4'h1) : select_397) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2329;
      averager_place_q <= sample_pair_whole_s2_q ? select_383 : averager_place_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_last_s3_q;
  logic sample_present_s3_q;
  logic [3:0] raster_at_x_s3_q;
  logic [3:0] raster_at_y_s3_q;
  logic [6:0] raster_at_column_s3_q;
  logic raster_row_ended_s3_q;
  logic [8:0] averager_place_s3_q;
  logic equal_377_s3_q;
  logic [8:0] select_383_s3_q;
  logic not_387_s3_q;
  logic equal_398_s3_q;
  logic [6:0] column_s3_q;
  logic equal_414_s3_q;
  logic equal_415_s3_q;
  logic equal_421_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_first_s3_q <= sample_pair_first_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_last_s3_q <= sample_last_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      raster_at_x_s3_q <= raster_at_x_s2_q;
      raster_at_y_s3_q <= raster_at_y_q;
      raster_at_column_s3_q <= raster_at_column_s2_q;
      raster_row_ended_s3_q <= raster_row_ended_s2_q;
      averager_place_s3_q <= averager_place_q;
      equal_377_s3_q <= equal_377_s2_q;
      select_383_s3_q <= select_383;
      not_387_s3_q <= not_387_s2_q;
      equal_398_s3_q <= select_397 == 4'h0;
      column_s3_q <= column_s2_q;
      equal_414_s3_q <= equal_414_s2_q;
      equal_415_s3_q <= select_397 == 4'hf;
      equal_421_s3_q <= equal_421_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:40
  logic or_384;
  assign or_384 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:213
  logic and_392;
  assign and_392 = (~((~or_384) | not_387_s3_q)) & (~(select_383_s3_q[8:5] == 4'hf));
  // hls/stages/census.hpp:105
  logic and_416;
  assign and_416 = equal_415_s3_q & and_392;
  // hls/stages/agreement.hpp:215
  logic and_418;
  assign and_418 = sample_pair_whole_s3_q & (equal_414_s3_q & and_416);
  // hls/stages/census.hpp:40
  logic [6:0] select_477;
  assign select_477 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:215
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_477 : 7'h0;
  // hls/stages/census.hpp:52
  logic [6:0] select_2333;
  assign select_2333 = sample_last_s3_q ? (select_477 + {6'h0, equal_415_s3_q}) : select_477;
  // hls/stages/agreement.hpp:215
  logic select_2339;
  assign select_2339 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_384 & (~raster_final_row_q)) : or_384) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [10:0] select_2341;
  assign select_2341 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:215
  logic select_2345;
  assign select_2345 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:313
  logic equal_2565;
  assign equal_2565 = {last[7], column_s3_q} == {1'b0, last[6:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_2333 : raster_at_row_q;
      raster_at_live_q <= select_2339;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2341 : raster_rows_left_q;
      raster_final_row_q <= select_2345;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic sample_pair_first_s4_q;
  logic sample_pair_whole_s4_q;
  logic sample_last_s4_q;
  logic sample_present_s4_q;
  logic [3:0] raster_at_x_s4_q;
  logic [3:0] raster_at_y_s4_q;
  logic [6:0] raster_at_column_s4_q;
  logic [6:0] raster_at_row_s4_q;
  logic raster_at_live_s4_q;
  logic [10:0] raster_rows_left_s4_q;
  logic raster_row_ended_s4_q;
  logic raster_final_row_s4_q;
  logic [8:0] averager_place_s4_q;
  logic equal_377_s4_q;
  logic [8:0] select_383_s4_q;
  logic and_392_s4_q;
  logic equal_398_s4_q;
  logic [6:0] column_s4_q;
  logic and_416_s4_q;
  logic and_418_s4_q;
  logic equal_421_s4_q;
  logic [6:0] row_s4_q;
  logic equal_2565_s4_q;
  logic and_2566_s4_q;
  logic [7:0] sum_2617_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sample_pair_first_s4_q <= sample_pair_first_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      sample_last_s4_q <= sample_last_s3_q;
      sample_present_s4_q <= sample_present_s3_q;
      raster_at_x_s4_q <= raster_at_x_s3_q;
      raster_at_y_s4_q <= raster_at_y_s3_q;
      raster_at_column_s4_q <= raster_at_column_s3_q;
      raster_at_row_s4_q <= raster_at_row_q;
      raster_at_live_s4_q <= raster_at_live_q;
      raster_rows_left_s4_q <= raster_rows_left_q;
      raster_row_ended_s4_q <= raster_row_ended_s3_q;
      raster_final_row_s4_q <= raster_final_row_q;
      averager_place_s4_q <= averager_place_s3_q;
      equal_377_s4_q <= equal_377_s3_q;
      select_383_s4_q <= select_383_s3_q;
      and_392_s4_q <= and_392;
      equal_398_s4_q <= equal_398_s3_q;
      column_s4_q <= column_s3_q;
      and_416_s4_q <= and_416;
      and_418_s4_q <= and_418;
      equal_421_s4_q <= equal_421_s3_q;
      row_s4_q <= row;
      equal_2565_s4_q <= equal_2565;
      and_2566_s4_q <= and_418 & equal_2565;
      sum_2617_s4_q <= {1'b0, row} + 8'h1;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic raster_at_first_q;
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
  logic [6:0] last_q;
  logic [6:0] least_q;
  logic [7:0] whole_q;
  logic [7:0] drawn_q;
  logic [2:0] slot_q;
  logic ends_cell_q;
  logic ends_q;
  logic final_row_q;
  // hls/stages/agreement.hpp:134
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:406
  logic equal_438;
  assign equal_438 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:397
  logic equal_441;
  assign equal_441 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:398
  logic equal_443;
  assign equal_443 = run_phase_q == 3'h2;
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1436;
  assign sum_1436 = slot_q[1:0] + 2'h3;
  // hls/stages/registration.hpp:249
  logic equal_1484;
  assign equal_1484 = sum_1436 == 2'h0;
  // hls/stages/registration.hpp:248
  logic not_1489;
  assign not_1489 = ~sum_1436[0];
  // hls/stages/registration.hpp:250
  logic [8:0] select_1491;
  assign select_1491 = equal_1484 ? 9'h188 : ({7'h62, not_1489, 1'b1} + 9'h1);
  // hls/stages/agreement.hpp:423
  logic not_1787;
  assign not_1787 = ~run_shift_q[5];
  logic [7:0] select_1790;
  assign select_1790 = equal_441 ? ({{7{not_1787}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:399
  logic select_1796;
  assign select_1796 = equal_441 ? (~run_last_shift_q) : equal_443;
  // hls/stages/agreement.hpp:403
  logic equal_1798;
  assign equal_1798 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:406
  logic equal_1799;
  assign equal_1799 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:416
  logic [7:0] or_1802;
  assign or_1802 = (select_1796 ? plan_columns_q : 8'h0) | ((equal_1798 | equal_1799) ? whole_q : 8'h0);
  // hls/stages/agreement.hpp:146
  logic and_1803;
  assign and_1803 = run_last_shift_q & equal_441;
  // hls/stages/agreement.hpp:416
  logic [1:0] or_1804;
  assign or_1804 = {2{and_1803}} | or_1802[4:3];
  // hls/stages/agreement.hpp:417
  logic [7:0] or_1806;
  assign or_1806 = {or_1802[7:5], or_1804, or_1802[2:0]} | (equal_438 ? drawn_q : 8'h0);
  logic [4:0] or_1807;
  assign or_1807 = {5{so}} | {or_1806[6], or_1806[3:0]};
  // hls/stages/agreement.hpp:413
  logic [6:0] value_2;
  assign value_2 = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_1812;
  assign select_1812 = (plan_shift_q[5] & select_1796) ? value_2 : 7'h0;
  logic [1:0] or_1813;
  assign or_1813 = {2{so}} | select_1812[5:4];
  // hls/stages/agreement.hpp:146
  logic and_1816;
  assign and_1816 = select_1796 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:403
  logic not_1823;
  assign not_1823 = ~select_1796;
  // hls/stages/agreement.hpp:146
  logic and_1825;
  assign and_1825 = final_row_q & so;
  // hls/stages/agreement.hpp:403
  logic [1:0] select_1826;
  assign select_1826 = equal_1799 ? 2'h1 : {2{and_1825}};
  logic [2:0] select_1828;
  assign select_1828 = (and_1803 | (select_1796 | equal_1798)) ? (equal_1798 ? 3'h2 : {not_1823, {2{select_1796}}}) : (equal_438 ? 3'h6 : {select_1826[0], select_1826});
  // hls/stages/registration.hpp:250
  logic [7:0] select_2125;
  assign select_2125 = select_1491[0] ? {7'h0, averager_place_s4_q[8]} : averager_place_s4_q[7:0];
  logic [7:0] select_2147;
  assign select_2147 = select_1491[0] ? {5'h0, raster_rows_left_s4_q[10:8]} : raster_rows_left_s4_q[7:0];
  // hls/stages/agreement.hpp:215
  logic select_2335;
  assign select_2335 = sample_pair_whole_s4_q ? sample_pair_first_s4_q : raster_at_first_q;
  // hls/stages/agreement.hpp:368
  logic select_2569;
  assign select_2569 = (and_2566_s4_q | (~ends_cell_q)) ? and_2566_s4_q : ends_q;
  // hls/stages/agreement.hpp:374
  logic [2:0] now;
  assign now = select_2569 ? (and_2566_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:379
  logic [5:0] select_2573;
  assign select_2573 = select_2569 ? (and_2566_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2576;
  assign select_2576 = select_2569 ? (following_last_shift_q & (~and_2566_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:380
  logic [7:0] select_2578;
  assign select_2578 = select_2569 ? (and_2566_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:368
  logic [6:0] select_2579;
  assign select_2579 = and_2566_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:371
  logic [7:0] select_2581;
  assign select_2581 = select_2569 ? {select_2579[6], select_2579} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2584;
  assign select_2584 = select_2569 ? (and_2566_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:314
  logic [6:0] select_2591;
  assign select_2591 = equal_2565_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:365
  logic [7:0] select_2595;
  assign select_2595 = and_418_s4_q ? (equal_2565_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2598;
  assign select_2598 = and_418_s4_q ? (equal_2565_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:376
  logic select_2612;
  assign select_2612 = (ends_cell_q | select_2569) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_441 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:371
  logic and_2616;
  assign and_2616 = (~select_2569) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:329
  logic equal_2618;
  assign equal_2618 = {sum_2617_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2617_s4_q[6:0]};
  // hls/stages/agreement.hpp:365
  logic select_2620;
  assign select_2620 = and_418_s4_q ? (equal_2565_s4_q ? equal_2618 : final_row_q) : final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_first_q <= 1'b0;
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
      last_q <= 7'h0;
      least_q <= 7'h0;
      whole_q <= 8'h0;
      drawn_q <= 8'h0;
      slot_q <= 3'h0;
      ends_cell_q <= 1'b1;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
    end else if (s4_en) begin
      raster_at_first_q <= select_2335;
      run_phase_q <= now;
      run_shift_q <= select_2573;
      run_last_shift_q <= select_2576;
      run_span_q <= select_2578;
      following_phase_q <= select_1828;
      following_shift_q <= select_1796 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_1816;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_1812[6], or_1813, select_1812[3:0]};
      following_columns_q <= {or_1806[7], or_1807[4], or_1806[5:4], or_1807[3:0]};
      plan_shift_q <= equal_441 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_1790;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2581;
      columns_left_q <= select_2584;
      last_q <= and_418_s4_q ? (equal_2565_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_418_s4_q ? select_2591 : least_q;
      whole_q <= select_2595;
      drawn_q <= select_2598;
      slot_q <= select_2569 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2612;
      ends_q <= and_2616;
      final_row_q <= select_2620;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic sample_pair_first_s5_q;
  logic sample_pair_whole_s5_q;
  logic sample_present_s5_q;
  logic [2:0] run_phase_s5_q;
  logic [5:0] run_shift_s5_q;
  logic run_last_shift_s5_q;
  logic [7:0] x_s5_q;
  logic [6:0] last_s5_q;
  logic [7:0] drawn_s5_q;
  logic [2:0] slot_s5_q;
  logic ends_cell_s5_q;
  logic equal_377_s5_q;
  logic [8:0] select_383_s5_q;
  logic and_392_s5_q;
  logic equal_398_s5_q;
  logic [6:0] column_s5_q;
  logic and_416_s5_q;
  logic and_418_s5_q;
  logic equal_421_s5_q;
  logic so_s5_q;
  logic equal_438_s5_q;
  logic equal_441_s5_q;
  logic equal_443_s5_q;
  logic [7:0] sum_444_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_554_s5_q;
  logic equal_563_s5_q;
  logic [1:0] sum_1436_s5_q;
  logic equal_1484_s5_q;
  logic [8:0] select_1491_s5_q;
  logic and_1767_s5_q;
  logic select_1771_s5_q;
  logic [7:0] select_1776_s5_q;
  logic [7:0] select_1779_s5_q;
  logic [7:0] select_1830_s5_q;
  logic [7:0] select_2125_s5_q;
  logic select_2146_s5_q;
  logic [7:0] select_2147_s5_q;
  logic select_2151_s5_q;
  logic [6:0] select_2152_s5_q;
  logic [3:0] select_2154_s5_q;
  logic select_2158_s5_q;
  logic equal_2565_s5_q;
  logic and_2566_s5_q;
  logic select_2569_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      sample_pair_first_s5_q <= sample_pair_first_s4_q;
      sample_pair_whole_s5_q <= sample_pair_whole_s4_q;
      sample_present_s5_q <= sample_present_s4_q;
      run_phase_s5_q <= run_phase_q;
      run_shift_s5_q <= run_shift_q;
      run_last_shift_s5_q <= run_last_shift_q;
      x_s5_q <= x_q;
      last_s5_q <= last_q;
      drawn_s5_q <= drawn_q;
      slot_s5_q <= slot_q;
      ends_cell_s5_q <= ends_cell_q;
      equal_377_s5_q <= equal_377_s4_q;
      select_383_s5_q <= select_383_s4_q;
      and_392_s5_q <= and_392_s4_q;
      equal_398_s5_q <= equal_398_s4_q;
      column_s5_q <= column_s4_q;
      and_416_s5_q <= and_416_s4_q;
      and_418_s5_q <= and_418_s4_q;
      equal_421_s5_q <= equal_421_s4_q;
      so_s5_q <= so;
      equal_438_s5_q <= equal_438;
      equal_441_s5_q <= equal_441;
      equal_443_s5_q <= equal_443;
      sum_444_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_554_s5_q <= {1'b0, last_q} + 8'h3;
      equal_563_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      sum_1436_s5_q <= sum_1436;
      equal_1484_s5_q <= equal_1484;
      select_1491_s5_q <= select_1491;
      and_1767_s5_q <= final_row_q & select_1491[0];
      select_1771_s5_q <= select_1491[0] ? so : ends_q;
      select_1776_s5_q <= select_1491[0] ? whole_q : {1'b0, least_q};
      select_1779_s5_q <= select_1491[0] ? columns_left_q : x_q;
      select_1830_s5_q <= select_1491[0] ? 8'h0 : run_span_q;
      select_2125_s5_q <= select_2125;
      select_2146_s5_q <= select_1491[0] ? raster_final_row_s4_q : raster_row_ended_s4_q;
      select_2147_s5_q <= select_2147;
      select_2151_s5_q <= select_1491[0] ? raster_at_live_s4_q : raster_at_first_q;
      select_2152_s5_q <= select_1491[0] ? raster_at_row_s4_q : raster_at_column_s4_q;
      select_2154_s5_q <= select_1491[0] ? raster_at_y_s4_q : raster_at_x_s4_q;
      select_2158_s5_q <= select_1491[0] ? sample_last_s4_q : sample_pair_whole_s4_q;
      equal_2565_s5_q <= equal_2565_s4_q;
      and_2566_s5_q <= and_2566_s4_q;
      select_2569_s5_q <= select_2569;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic sample_of_skin_q;
  logic [4:0] rows_passed_above_q;
  logic [6:0] row_q;
  logic [6:0] age_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:391
  logic [7:0] select_445;
  assign select_445 = run_shift_s5_q[5] ? x_s5_q : sum_444_s5_q;
  logic less_446;
  assign less_446 = {1'b0, last_s5_q} < select_445;
  // hls/stages/agreement.hpp:163
  logic not_447;
  assign not_447 = ~less_446;
  // hls/stages/agreement.hpp:309
  logic equal_476;
  assign equal_476 = column_s5_q == 7'h0;
  logic equal_479;
  assign equal_479 = row_s5_q == 7'h0;
  logic [3:0] select_480;
  assign select_480 = equal_479 ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:310
  logic [4:0] select_481;
  assign select_481 = equal_476 ? {select_480, 1'b1} : rows_passed_above_q;
  // hls/stages/agreement.hpp:597
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:747
  logic [5:0] sum_1467;
  assign sum_1467 = {1'b0, last_s5_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:135
  logic and_1523;
  assign and_1523 = ends_cell_s5_q & so_s5_q;
  // hls/stages/registration.hpp:250
  logic select_1770;
  assign select_1770 = select_1491_s5_q[1] ? and_1767_s5_q : (and_1523 & (~select_1491_s5_q[0]));
  logic [2:0] select_1773;
  assign select_1773 = select_1491_s5_q[1] ? {2'h0, select_1771_s5_q} : (select_1491_s5_q[0] ? {2'h0, ends_cell_s5_q} : slot_s5_q);
  logic [2:0] select_1774;
  assign select_1774 = select_1491_s5_q[2] ? {2'h0, select_1770} : select_1773;
  logic [7:0] select_1777;
  assign select_1777 = select_1491_s5_q[1] ? (select_1491_s5_q[0] ? {age_q, 1'b1} : drawn_s5_q) : select_1776_s5_q;
  logic [6:0] select_1778;
  assign select_1778 = select_1491_s5_q[0] ? row_q : last_s5_q;
  logic [7:0] select_1781;
  assign select_1781 = select_1491_s5_q[2] ? select_1777 : (select_1491_s5_q[1] ? {1'b0, select_1778} : select_1779_s5_q);
  logic [7:0] select_1808;
  assign select_1808 = select_1491_s5_q[0] ? {{2{plan_shift_q[5]}}, plan_shift_q} : following_columns_q;
  logic [7:0] select_1809;
  assign select_1809 = select_1491_s5_q[1] ? (select_1491_s5_q[0] ? plan_columns_q : plan_span_q) : select_1808;
  logic [7:0] select_1814;
  assign select_1814 = select_1491_s5_q[0] ? {following_lowest_q[6], following_lowest_q} : following_span_q;
  logic [5:0] select_1818;
  assign select_1818 = select_1491_s5_q[0] ? {5'h0, following_last_shift_q} : following_shift_q;
  logic [7:0] select_1819;
  assign select_1819 = select_1491_s5_q[1] ? select_1814 : {{2{select_1818[5]}}, select_1818};
  logic [2:0] select_1829;
  assign select_1829 = select_1491_s5_q[0] ? following_phase_q : 3'h0;
  logic [5:0] select_1832;
  assign select_1832 = select_1491_s5_q[0] ? {5'h0, run_last_shift_s5_q} : run_shift_s5_q;
  logic [4:0] select_1833;
  assign select_1833 = select_1491_s5_q[0] ? {2'h0, run_phase_s5_q} : rows_passed_above_q;
  logic [5:0] select_1834;
  assign select_1834 = select_1491_s5_q[1] ? select_1832 : {1'b0, select_1833};
  logic [7:0] select_1835;
  assign select_1835 = select_1491_s5_q[2] ? (select_1491_s5_q[1] ? {5'h0, select_1829} : select_1830_s5_q) : {{2{select_1834[5]}}, select_1834};
  logic [7:0] select_1836;
  assign select_1836 = select_1491_s5_q[3] ? (select_1491_s5_q[2] ? select_1809 : select_1819) : select_1835;
  logic [7:0] select_2148;
  assign select_2148 = select_1491_s5_q[1] ? {7'h0, select_2146_s5_q} : select_2147_s5_q;
  logic [6:0] select_2153;
  assign select_2153 = select_1491_s5_q[1] ? {6'h0, select_2151_s5_q} : select_2152_s5_q;
  logic select_2155;
  assign select_2155 = select_1491_s5_q[0] ? sample_of_skin_q : sample_present_s5_q;
  logic [3:0] select_2156;
  assign select_2156 = select_1491_s5_q[1] ? select_2154_s5_q : {3'h0, select_2155};
  // hls/stages/agreement.hpp:211
  logic and_2321;
  assign and_2321 = ((7'h6 < row_q) & (~(x_s5_q[7:2] == 6'h0))) & (~({sum_1467, last_s5_q[1:0]} < x_s5_q));
  // hls/stages/agreement.hpp:373
  logic [6:0] select_2600;
  assign select_2600 = select_2569_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);
  // hls/stages/agreement.hpp:314
  logic select_2624;
  assign select_2624 = equal_2565_s5_q ? (~({row_s5_q, 1'b0} < {sum_2621, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:365
  logic and_2756;
  assign and_2756 = and_418_s5_q & (equal_2565_s5_q & (row_s5_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_of_skin_q <= 1'b0;
      rows_passed_above_q <= 5'h0;
      row_q <= 7'h0;
      age_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s5_en) begin
      sample_of_skin_q <= mask_s5_q;
      rows_passed_above_q <= and_418_s5_q ? select_481 : rows_passed_above_q;
      row_q <= and_418_s5_q ? (equal_2565_s5_q ? row_s5_q : row_q) : row_q;
      age_q <= select_2600;
      lower_half_q <= and_418_s5_q ? select_2624 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s6_q;
  logic [7:0] pixel_1_s6_q;
  logic saturated_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic sample_pair_first_s6_q;
  logic sample_pair_whole_s6_q;
  logic sample_present_s6_q;
  logic sample_of_skin_s6_q;
  logic [5:0] run_shift_s6_q;
  logic [7:0] x_s6_q;
  logic [3:0] age_s6_q;
  logic [2:0] slot_s6_q;
  logic ends_cell_s6_q;
  logic lower_half_s6_q;
  logic equal_377_s6_q;
  logic [8:0] select_383_s6_q;
  logic and_392_s6_q;
  logic equal_398_s6_q;
  logic [6:0] column_s6_q;
  logic and_416_s6_q;
  logic and_418_s6_q;
  logic equal_421_s6_q;
  logic so_s6_q;
  logic equal_438_s6_q;
  logic equal_441_s6_q;
  logic [6:0] sum_444_s6_q;
  logic less_446_s6_q;
  logic not_447_s6_q;
  logic and_448_s6_q;
  logic equal_476_s6_q;
  logic equal_479_s6_q;
  logic select_481_s6_q;
  logic not_538_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_558_s6_q;
  logic equal_563_s6_q;
  logic equal_1375_s6_q;
  logic equal_1385_s6_q;
  logic not_1390_s6_q;
  logic [1:0] sum_1436_s6_q;
  logic less_1468_s6_q;
  logic equal_1484_s6_q;
  logic [8:0] select_1491_s6_q;
  logic and_1523_s6_q;
  logic less_1543_s6_q;
  logic [7:0] select_1782_s6_q;
  logic [7:0] select_1836_s6_q;
  logic [7:0] select_2125_s6_q;
  logic [7:0] select_2148_s6_q;
  logic [6:0] select_2157_s6_q;
  logic select_2158_s6_q;
  logic equal_2186_s6_q;
  logic and_2321_s6_q;
  logic equal_2511_s6_q;
  logic equal_2565_s6_q;
  logic and_2757_s6_q;
  logic and_2759_s6_q;
  logic less_2865_s6_q;
  logic equal_3062_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      pixel_1_s6_q <= pixel_1_s5_q;
      saturated_s6_q <= saturated_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      sample_pair_first_s6_q <= sample_pair_first_s5_q;
      sample_pair_whole_s6_q <= sample_pair_whole_s5_q;
      sample_present_s6_q <= sample_present_s5_q;
      sample_of_skin_s6_q <= sample_of_skin_q;
      run_shift_s6_q <= run_shift_s5_q;
      x_s6_q <= x_s5_q;
      age_s6_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s6_q <= slot_s5_q;
      ends_cell_s6_q <= ends_cell_s5_q;
      lower_half_s6_q <= lower_half_q;
      equal_377_s6_q <= equal_377_s5_q;
      select_383_s6_q <= select_383_s5_q;
      and_392_s6_q <= and_392_s5_q;
      equal_398_s6_q <= equal_398_s5_q;
      column_s6_q <= column_s5_q;
      and_416_s6_q <= and_416_s5_q;
      and_418_s6_q <= and_418_s5_q;
      equal_421_s6_q <= equal_421_s5_q;
      so_s6_q <= so_s5_q;
      equal_438_s6_q <= equal_438_s5_q;
      equal_441_s6_q <= equal_441_s5_q;
      sum_444_s6_q <= sum_444_s5_q[6:0];
      less_446_s6_q <= less_446;
      not_447_s6_q <= not_447;
      and_448_s6_q <= equal_443_s5_q & not_447;
      equal_476_s6_q <= equal_476;
      equal_479_s6_q <= equal_479;
      select_481_s6_q <= select_481[4];
      not_538_s6_q <= ~(row_q == 7'h0);
      x_s6_2_q <= x[6:0];
      and_558_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_554_s5_q < select_445)));
      equal_563_s6_q <= equal_563_s5_q;
      equal_1375_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1385_s6_q <= run_phase_s5_q == 3'h7;
      not_1390_s6_q <= ~(row_q[6:3] == 4'h0);
      sum_1436_s6_q <= sum_1436_s5_q;
      less_1468_s6_q <= {1'b0, sum_1467, last_s5_q[1]} < x_s5_q;
      equal_1484_s6_q <= equal_1484_s5_q;
      select_1491_s6_q <= select_1491_s5_q;
      and_1523_s6_q <= and_1523;
      less_1543_s6_q <= 6'h4 < row_q[6:1];
      select_1782_s6_q <= select_1491_s5_q[3] ? {5'h0, select_1774} : select_1781;
      select_1836_s6_q <= select_1836;
      select_2125_s6_q <= select_2125_s5_q;
      select_2148_s6_q <= select_2148;
      select_2157_s6_q <= select_1491_s5_q[2] ? select_2153 : {3'h0, select_2156};
      select_2158_s6_q <= select_2158_s5_q;
      equal_2186_s6_q <= x_s5_q == {1'b0, last_s5_q};
      and_2321_s6_q <= and_2321;
      equal_2511_s6_q <= (column_s5_q | row_s5_q) == 7'h0;
      equal_2565_s6_q <= equal_2565_s5_q;
      and_2757_s6_q <= and_2566_s5_q & and_2756;
      and_2759_s6_q <= and_2566_s5_q & (~and_2756);
      less_2865_s6_q <= 6'h2 < row_s5_q[6:1];
      equal_3062_s6_q <= row_s5_q[6:3] == 4'h0;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:391
  logic or_439;
  assign or_439 = so_s6_q | equal_438_s6_q;
  // hls/stages/agreement.hpp:527
  logic not_440;
  assign not_440 = ~or_439;
  // hls/stages/agreement.hpp:551
  logic select_534;
  assign select_534 = equal_441_s6_q ? not_447_s6_q : and_448_s6_q;
  // hls/stages/agreement.hpp:191
  logic and_559;
  assign and_559 = equal_441_s6_q & and_558_s6_q;
  logic select_560;
  assign select_560 = or_439 ? not_447_s6_q : and_559;
  // hls/stages/agreement.hpp:606
  logic or_565;
  assign or_565 = equal_563_s6_q | ($signed(6'h0) < $signed(run_shift_s6_q));
  // hls/stages/agreement.hpp:618
  logic [6:0] right;
  assign right = sum_444_s6_q + 7'h7d;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1072; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_439 ? not_447_s6_q : select_534);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1073; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_441_s6_q ? sum_444_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_440 & select_534);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 46, DISTANCE 24, hls/stages/agreement.hpp:1074; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 46'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_439 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_560;
  logic [45:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  logic [7:0] pixel_0_s7_q;
  logic [7:0] pixel_1_s7_q;
  logic saturated_s7_q;
  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic sample_pair_first_s7_q;
  logic sample_pair_whole_s7_q;
  logic sample_present_s7_q;
  logic sample_of_skin_s7_q;
  logic [5:0] run_shift_s7_q;
  logic [7:0] x_s7_q;
  logic [3:0] age_s7_q;
  logic [2:0] slot_s7_q;
  logic ends_cell_s7_q;
  logic lower_half_s7_q;
  logic equal_377_s7_q;
  logic [8:0] select_383_s7_q;
  logic and_392_s7_q;
  logic equal_398_s7_q;
  logic [6:0] column_s7_q;
  logic and_416_s7_q;
  logic and_418_s7_q;
  logic equal_421_s7_q;
  logic so_s7_q;
  logic equal_438_s7_q;
  logic or_439_s7_q;
  logic equal_441_s7_q;
  logic less_446_s7_q;
  logic not_447_s7_q;
  logic and_450_s7_q;
  logic equal_476_s7_q;
  logic equal_479_s7_q;
  logic select_481_s7_q;
  logic not_538_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_560_s7_q;
  logic select_567_s7_q;
  logic and_1369_s7_q;
  logic [6:0] right_s7_q;
  logic select_1376_s7_q;
  logic equal_1385_s7_q;
  logic not_1390_s7_q;
  logic [1:0] sum_1436_s7_q;
  logic less_1468_s7_q;
  logic equal_1484_s7_q;
  logic [8:0] select_1491_s7_q;
  logic and_1523_s7_q;
  logic less_1543_s7_q;
  logic [7:0] select_1782_s7_q;
  logic [7:0] select_1836_s7_q;
  logic [7:0] select_2125_s7_q;
  logic [7:0] select_2148_s7_q;
  logic [6:0] select_2157_s7_q;
  logic select_2158_s7_q;
  logic equal_2186_s7_q;
  logic and_2323_s7_q;
  logic equal_2511_s7_q;
  logic equal_2565_s7_q;
  logic and_2757_s7_q;
  logic and_2759_s7_q;
  logic less_2865_s7_q;
  logic equal_3062_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      pixel_0_s7_q <= pixel_0_s6_q;
      pixel_1_s7_q <= pixel_1_s6_q;
      saturated_s7_q <= saturated_s6_q;
      mask_s7_q <= sample_of_skin_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      sample_pair_first_s7_q <= sample_pair_first_s6_q;
      sample_pair_whole_s7_q <= sample_pair_whole_s6_q;
      sample_present_s7_q <= sample_present_s6_q;
      sample_of_skin_s7_q <= sample_of_skin_s6_q;
      run_shift_s7_q <= run_shift_s6_q;
      x_s7_q <= x_s6_q;
      age_s7_q <= age_s6_q;
      slot_s7_q <= slot_s6_q;
      ends_cell_s7_q <= ends_cell_s6_q;
      lower_half_s7_q <= lower_half_s6_q;
      equal_377_s7_q <= equal_377_s6_q;
      select_383_s7_q <= select_383_s6_q;
      and_392_s7_q <= and_392_s6_q;
      equal_398_s7_q <= equal_398_s6_q;
      column_s7_q <= column_s6_q;
      and_416_s7_q <= and_416_s6_q;
      and_418_s7_q <= and_418_s6_q;
      equal_421_s7_q <= equal_421_s6_q;
      so_s7_q <= so_s6_q;
      equal_438_s7_q <= equal_438_s6_q;
      or_439_s7_q <= or_439;
      equal_441_s7_q <= equal_441_s6_q;
      less_446_s7_q <= less_446_s6_q;
      not_447_s7_q <= not_447_s6_q;
      and_450_s7_q <= not_440 & ((~equal_441_s6_q) & and_448_s6_q);
      equal_476_s7_q <= equal_476_s6_q;
      equal_479_s7_q <= equal_479_s6_q;
      select_481_s7_q <= select_481_s6_q;
      not_538_s7_q <= not_538_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_560_s7_q <= select_560;
      select_567_s7_q <= or_565 ? equal_563_s6_q : (~age_s6_q[1]);
      and_1369_s7_q <= not_440 & and_559;
      right_s7_q <= right;
      select_1376_s7_q <= or_565 ? equal_563_s6_q : equal_1375_s6_q;
      equal_1385_s7_q <= equal_1385_s6_q;
      not_1390_s7_q <= not_1390_s6_q;
      sum_1436_s7_q <= sum_1436_s6_q;
      less_1468_s7_q <= less_1468_s6_q;
      equal_1484_s7_q <= equal_1484_s6_q;
      select_1491_s7_q <= select_1491_s6_q;
      and_1523_s7_q <= and_1523_s6_q;
      less_1543_s7_q <= less_1543_s6_q;
      select_1782_s7_q <= select_1782_s6_q;
      select_1836_s7_q <= select_1836_s6_q;
      select_2125_s7_q <= select_2125_s6_q;
      select_2148_s7_q <= select_2148_s6_q;
      select_2157_s7_q <= select_2157_s6_q;
      select_2158_s7_q <= select_2158_s6_q;
      equal_2186_s7_q <= equal_2186_s6_q;
      and_2323_s7_q <= so_s6_q & (ends_cell_s6_q & and_2321_s6_q);
      equal_2511_s7_q <= equal_2511_s6_q;
      equal_2565_s7_q <= equal_2565_s6_q;
      and_2757_s7_q <= and_2757_s6_q;
      and_2759_s7_q <= and_2759_s6_q;
      less_2865_s7_q <= less_2865_s6_q;
      equal_3062_s7_q <= equal_3062_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1071; read in stage 7, written in stage 23: 7 < 23 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_450_s7_q;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  logic [7:0] pixel_0_s8_q;
  logic [7:0] pixel_1_s8_q;
  logic saturated_s8_q;
  logic mask_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic sample_pair_first_s8_q;
  logic sample_pair_whole_s8_q;
  logic sample_present_s8_q;
  logic sample_of_skin_s8_q;
  logic [5:0] run_shift_s8_q;
  logic [7:0] x_s8_q;
  logic [3:0] age_s8_q;
  logic [2:0] slot_s8_q;
  logic ends_cell_s8_q;
  logic lower_half_s8_q;
  logic equal_377_s8_q;
  logic [8:0] select_383_s8_q;
  logic and_392_s8_q;
  logic equal_398_s8_q;
  logic [6:0] column_s8_q;
  logic and_416_s8_q;
  logic and_418_s8_q;
  logic equal_421_s8_q;
  logic so_s8_q;
  logic equal_438_s8_q;
  logic or_439_s8_q;
  logic equal_441_s8_q;
  logic less_446_s8_q;
  logic not_447_s8_q;
  logic and_450_s8_q;
  logic equal_476_s8_q;
  logic equal_479_s8_q;
  logic select_481_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic not_538_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_560_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic select_567_s8_q;
  logic and_1369_s8_q;
  logic [6:0] right_s8_q;
  logic select_1376_s8_q;
  logic equal_1385_s8_q;
  logic not_1390_s8_q;
  logic [1:0] sum_1436_s8_q;
  logic less_1468_s8_q;
  logic equal_1484_s8_q;
  logic [8:0] select_1491_s8_q;
  logic and_1523_s8_q;
  logic less_1543_s8_q;
  logic [7:0] select_1782_s8_q;
  logic [7:0] select_1836_s8_q;
  logic [7:0] select_2125_s8_q;
  logic [7:0] select_2148_s8_q;
  logic [6:0] select_2157_s8_q;
  logic select_2158_s8_q;
  logic equal_2186_s8_q;
  logic and_2323_s8_q;
  logic equal_2511_s8_q;
  logic equal_2565_s8_q;
  logic and_2757_s8_q;
  logic and_2759_s8_q;
  logic less_2865_s8_q;
  logic equal_3062_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      pixel_0_s8_q <= pixel_0_s7_q;
      pixel_1_s8_q <= pixel_1_s7_q;
      saturated_s8_q <= saturated_s7_q;
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      sample_pair_first_s8_q <= sample_pair_first_s7_q;
      sample_pair_whole_s8_q <= sample_pair_whole_s7_q;
      sample_present_s8_q <= sample_present_s7_q;
      sample_of_skin_s8_q <= sample_of_skin_s7_q;
      run_shift_s8_q <= run_shift_s7_q;
      x_s8_q <= x_s7_q;
      age_s8_q <= age_s7_q;
      slot_s8_q <= slot_s7_q;
      ends_cell_s8_q <= ends_cell_s7_q;
      lower_half_s8_q <= lower_half_s7_q;
      equal_377_s8_q <= equal_377_s7_q;
      select_383_s8_q <= select_383_s7_q;
      and_392_s8_q <= and_392_s7_q;
      equal_398_s8_q <= equal_398_s7_q;
      column_s8_q <= column_s7_q;
      and_416_s8_q <= and_416_s7_q;
      and_418_s8_q <= and_418_s7_q;
      equal_421_s8_q <= equal_421_s7_q;
      so_s8_q <= so_s7_q;
      equal_438_s8_q <= equal_438_s7_q;
      or_439_s8_q <= or_439_s7_q;
      equal_441_s8_q <= equal_441_s7_q;
      less_446_s8_q <= less_446_s7_q;
      not_447_s8_q <= not_447_s7_q;
      and_450_s8_q <= and_450_s7_q;
      equal_476_s8_q <= equal_476_s7_q;
      equal_479_s8_q <= equal_479_s7_q;
      select_481_s8_q <= select_481_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      not_538_s8_q <= not_538_s7_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_560_s8_q <= select_560_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      select_567_s8_q <= select_567_s7_q;
      and_1369_s8_q <= and_1369_s7_q;
      right_s8_q <= right_s7_q;
      select_1376_s8_q <= select_1376_s7_q;
      equal_1385_s8_q <= equal_1385_s7_q;
      not_1390_s8_q <= not_1390_s7_q;
      sum_1436_s8_q <= sum_1436_s7_q;
      less_1468_s8_q <= less_1468_s7_q;
      equal_1484_s8_q <= equal_1484_s7_q;
      select_1491_s8_q <= select_1491_s7_q;
      and_1523_s8_q <= and_1523_s7_q;
      less_1543_s8_q <= less_1543_s7_q;
      select_1782_s8_q <= select_1782_s7_q;
      select_1836_s8_q <= select_1836_s7_q;
      select_2125_s8_q <= select_2125_s7_q;
      select_2148_s8_q <= select_2148_s7_q;
      select_2157_s8_q <= select_2157_s7_q;
      select_2158_s8_q <= select_2158_s7_q;
      equal_2186_s8_q <= equal_2186_s7_q;
      and_2323_s8_q <= and_2323_s7_q;
      equal_2511_s8_q <= equal_2511_s7_q;
      equal_2565_s8_q <= equal_2565_s7_q;
      and_2757_s8_q <= and_2757_s7_q;
      and_2759_s8_q <= and_2759_s7_q;
      less_2865_s8_q <= less_2865_s7_q;
      equal_3062_s8_q <= equal_3062_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:159
  logic and_573;
  assign and_573 = left_rdata_s8_q[44] & not_447_s8_q;
  logic and_574;
  assign and_574 = right_codes_rdata_s8_q[38] & not_447_s8_q;
  logic [11:0] select_575;
  assign select_575 = less_446_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_576;
  assign select_576 = less_446_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_580;
  assign select_580 = and_573 ? (and_574 ? (~(select_575 ^ select_576)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:159
  logic and_596;
  assign and_596 = left_rdata_s8_q[60] & not_447_s8_q;
  logic and_597;
  assign and_597 = right_codes_rdata_s8_q[51] & not_447_s8_q;
  logic [11:0] select_598;
  assign select_598 = less_446_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_599;
  assign select_599 = less_446_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_603;
  assign select_603 = and_596 ? (and_597 ? (~(select_598 ^ select_599)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:159
  logic and_613;
  assign and_613 = left_rdata_s8_q[76] & not_447_s8_q;
  logic and_614;
  assign and_614 = right_codes_rdata_s8_q[64] & not_447_s8_q;
  logic [11:0] select_615;
  assign select_615 = less_446_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_616;
  assign select_616 = less_446_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_620;
  assign select_620 = and_613 ? (and_614 ? (~(select_615 ^ select_616)) : 12'h0) : 12'h0;
  logic [11:0] select_828;
  assign select_828 = (slot_s8_q[0] ? and_614 : and_597) ? (~(select_576 ^ (slot_s8_q[0] ? select_615 : select_598))) : 12'h0;
  // hls/stages/agreement.hpp:159
  logic and_845;
  assign and_845 = right_codes_rdata_s8_q[77] & not_447_s8_q;
  logic [11:0] select_847;
  assign select_847 = less_446_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_851;
  assign select_851 = (slot_s8_q[0] ? and_845 : and_614) ? (~(select_599 ^ (slot_s8_q[0] ? select_847 : select_615))) : 12'h0;
  // hls/stages/agreement.hpp:541
  logic select_863;
  assign select_863 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_447_s8_q) : and_845;
  logic [11:0] select_865;
  assign select_865 = slot_s8_q[0] ? (less_446_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_847;
  // hls/stages/agreement.hpp:159
  logic and_1074;
  assign and_1074 = right_codes_rdata_s8_q[25] & not_447_s8_q;
  // hls/stages/agreement.hpp:541
  logic select_1075;
  assign select_1075 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_447_s8_q) : and_1074;
  // hls/stages/agreement.hpp:159
  logic [11:0] select_1077;
  assign select_1077 = less_446_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:541
  logic [11:0] select_1078;
  assign select_1078 = slot_s8_q[0] ? (less_446_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1077;
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1102;
  assign select_1102 = (slot_s8_q[0] ? and_1074 : and_574) ? (~(select_599 ^ (slot_s8_q[0] ? select_1077 : select_575))) : 12'h0;
  logic [11:0] select_1117;
  assign select_1117 = (slot_s8_q[0] ? and_574 : and_597) ? (~(select_616 ^ (slot_s8_q[0] ? select_575 : select_598))) : 12'h0;
  // hls/stages/agreement.hpp:720
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:724
  logic and_1391;
  assign and_1391 = (or_439_s8_q & (left_rdata_s8_q[61] & not_447_s8_q)) & not_1390_s8_q;
  // hls/stages/agreement.hpp:182
  logic and_1399;
  assign and_1399 = not_447_s8_q & (or_439_s8_q & (left_rdata_s8_q[63] & not_447_s8_q));

  logic [7:0] pixel_0_s9_q;
  logic [7:0] pixel_1_s9_q;
  logic saturated_s9_q;
  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic sample_pair_first_s9_q;
  logic sample_pair_whole_s9_q;
  logic sample_present_s9_q;
  logic sample_of_skin_s9_q;
  logic [5:0] run_shift_s9_q;
  logic [7:0] x_s9_q;
  logic [3:0] age_s9_q;
  logic [2:0] slot_s9_q;
  logic ends_cell_s9_q;
  logic lower_half_s9_q;
  logic equal_377_s9_q;
  logic [8:0] select_383_s9_q;
  logic and_392_s9_q;
  logic equal_398_s9_q;
  logic [6:0] column_s9_q;
  logic and_416_s9_q;
  logic and_418_s9_q;
  logic equal_421_s9_q;
  logic so_s9_q;
  logic equal_438_s9_q;
  logic or_439_s9_q;
  logic equal_441_s9_q;
  logic less_446_s9_q;
  logic not_447_s9_q;
  logic and_450_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic equal_476_s9_q;
  logic equal_479_s9_q;
  logic select_481_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_539_s9_q;
  logic and_540_s9_q;
  logic and_541_s9_q;
  logic and_542_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_546_s9_q;
  logic and_547_s9_q;
  logic and_548_s9_q;
  logic and_549_s9_q;
  logic and_550_s9_q;
  logic and_551_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_560_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic select_567_s9_q;
  logic and_573_s9_q;
  logic [11:0] select_580_s9_q;
  logic and_596_s9_q;
  logic [11:0] select_603_s9_q;
  logic and_613_s9_q;
  logic [11:0] select_620_s9_q;
  logic [11:0] select_828_s9_q;
  logic [11:0] select_851_s9_q;
  logic [11:0] select_868_s9_q;
  logic [11:0] select_1081_s9_q;
  logic [11:0] select_1102_s9_q;
  logic [11:0] select_1117_s9_q;
  logic and_1369_s9_q;
  logic [6:0] sum_1371_s9_q;
  logic [6:0] right_s9_q;
  logic select_1376_s9_q;
  logic equal_1385_s9_q;
  logic and_1392_s9_q;
  logic and_1395_s9_q;
  logic and_1399_s9_q;
  logic and_1410_s9_q;
  logic less_1411_s9_q;
  logic [1:0] sum_1436_s9_q;
  logic less_1468_s9_q;
  logic equal_1484_s9_q;
  logic [8:0] select_1491_s9_q;
  logic and_1523_s9_q;
  logic less_1543_s9_q;
  logic [7:0] select_1782_s9_q;
  logic [7:0] select_1836_s9_q;
  logic [7:0] select_2125_s9_q;
  logic [7:0] select_2148_s9_q;
  logic [6:0] select_2157_s9_q;
  logic select_2158_s9_q;
  logic equal_2186_s9_q;
  logic and_2323_s9_q;
  logic equal_2511_s9_q;
  logic equal_2565_s9_q;
  logic and_2757_s9_q;
  logic and_2759_s9_q;
  logic less_2865_s9_q;
  logic equal_3062_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      pixel_0_s9_q <= pixel_0_s8_q;
      pixel_1_s9_q <= pixel_1_s8_q;
      saturated_s9_q <= saturated_s8_q;
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      sample_pair_first_s9_q <= sample_pair_first_s8_q;
      sample_pair_whole_s9_q <= sample_pair_whole_s8_q;
      sample_present_s9_q <= sample_present_s8_q;
      sample_of_skin_s9_q <= sample_of_skin_s8_q;
      run_shift_s9_q <= run_shift_s8_q;
      x_s9_q <= x_s8_q;
      age_s9_q <= age_s8_q;
      slot_s9_q <= slot_s8_q;
      ends_cell_s9_q <= ends_cell_s8_q;
      lower_half_s9_q <= lower_half_s8_q;
      equal_377_s9_q <= equal_377_s8_q;
      select_383_s9_q <= select_383_s8_q;
      and_392_s9_q <= and_392_s8_q;
      equal_398_s9_q <= equal_398_s8_q;
      column_s9_q <= column_s8_q;
      and_416_s9_q <= and_416_s8_q;
      and_418_s9_q <= and_418_s8_q;
      equal_421_s9_q <= equal_421_s8_q;
      so_s9_q <= so_s8_q;
      equal_438_s9_q <= equal_438_s8_q;
      or_439_s9_q <= or_439_s8_q;
      equal_441_s9_q <= equal_441_s8_q;
      less_446_s9_q <= less_446_s8_q;
      not_447_s9_q <= not_447_s8_q;
      and_450_s9_q <= and_450_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      equal_476_s9_q <= equal_476_s8_q;
      equal_479_s9_q <= equal_479_s8_q;
      select_481_s9_q <= select_481_s8_q;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_539_s9_q <= left_rdata_s8_q[12] & not_538_s8_q;
      and_540_s9_q <= left_rdata_s8_q[28] & not_538_s8_q;
      and_541_s9_q <= left_rdata_s8_q[44] & not_538_s8_q;
      and_542_s9_q <= left_rdata_s8_q[60] & not_538_s8_q;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_546_s9_q <= right_codes_rdata_s8_q[12] & not_538_s8_q;
      and_547_s9_q <= right_codes_rdata_s8_q[25] & not_538_s8_q;
      and_548_s9_q <= right_codes_rdata_s8_q[38] & not_538_s8_q;
      and_549_s9_q <= right_codes_rdata_s8_q[51] & not_538_s8_q;
      and_550_s9_q <= right_codes_rdata_s8_q[64] & not_538_s8_q;
      and_551_s9_q <= right_codes_rdata_s8_q[77] & not_538_s8_q;
      x_s9_2_q <= x_s8_2_q;
      select_560_s9_q <= select_560_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_567_s9_q <= select_567_s8_q;
      and_573_s9_q <= and_573;
      select_580_s9_q <= select_580;
      and_596_s9_q <= and_596;
      select_603_s9_q <= select_603;
      and_613_s9_q <= and_613;
      select_620_s9_q <= select_620;
      select_828_s9_q <= select_828;
      select_851_s9_q <= select_851;
      select_868_s9_q <= select_863 ? (~(select_616 ^ select_865)) : 12'h0;
      select_1081_s9_q <= select_1075 ? (~(select_576 ^ select_1078)) : 12'h0;
      select_1102_s9_q <= select_1102;
      select_1117_s9_q <= select_1117;
      and_1369_s9_q <= and_1369_s8_q;
      sum_1371_s9_q <= x_s8_q[6:0] + {shift[5], shift};
      right_s9_q <= right_s8_q;
      select_1376_s9_q <= select_1376_s8_q;
      equal_1385_s9_q <= equal_1385_s8_q;
      and_1392_s9_q <= not_447_s8_q & and_1391;
      and_1395_s9_q <= (or_439_s8_q & (left_rdata_s8_q[62] & not_447_s8_q)) & and_1391;
      and_1399_s9_q <= and_1399;
      and_1410_s9_q <= cfg_nearer_below_i & shift[5];
      less_1411_s9_q <= $signed(6'h0) < $signed(shift);
      sum_1436_s9_q <= sum_1436_s8_q;
      less_1468_s9_q <= less_1468_s8_q;
      equal_1484_s9_q <= equal_1484_s8_q;
      select_1491_s9_q <= select_1491_s8_q;
      and_1523_s9_q <= and_1523_s8_q;
      less_1543_s9_q <= less_1543_s8_q;
      select_1782_s9_q <= select_1782_s8_q;
      select_1836_s9_q <= select_1836_s8_q;
      select_2125_s9_q <= select_2125_s8_q;
      select_2148_s9_q <= select_2148_s8_q;
      select_2157_s9_q <= select_2157_s8_q;
      select_2158_s9_q <= select_2158_s8_q;
      equal_2186_s9_q <= equal_2186_s8_q;
      and_2323_s9_q <= and_2323_s8_q;
      equal_2511_s9_q <= equal_2511_s8_q;
      equal_2565_s9_q <= equal_2565_s8_q;
      and_2757_s9_q <= and_2757_s8_q;
      and_2759_s9_q <= and_2759_s8_q;
      less_2865_s9_q <= less_2865_s8_q;
      equal_3062_s9_q <= equal_3062_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:480
  logic parity_586;
  assign parity_586 = ^select_580_s9_q[5:3];
  logic parity_589;
  assign parity_589 = ^select_580_s9_q[8:6];
  logic parity_592;
  assign parity_592 = ^select_580_s9_q[11:3];
  logic parity_606;
  assign parity_606 = ^select_603_s9_q[8:6];
  logic parity_609;
  assign parity_609 = ^select_603_s9_q[11:9];
  logic parity_626;
  assign parity_626 = ^select_620_s9_q[2:0];
  logic parity_629;
  assign parity_629 = ^select_620_s9_q[5:3];
  logic parity_632;
  assign parity_632 = ^select_620_s9_q[8:0];
  logic parity_638;
  assign parity_638 = ^select_620_s9_q[11:9];
  logic parity_641;
  assign parity_641 = ^select_603_s9_q[2:0];
  logic parity_644;
  assign parity_644 = ^{select_620_s9_q[11:9], select_603_s9_q[5:0]};
  logic parity_647;
  assign parity_647 = ^{select_620_s9_q, select_603_s9_q, select_580_s9_q[2:0]};
  // hls/stages/agreement.hpp:479
  logic or_652;
  assign or_652 = (select_580_s9_q[1:0] == 2'h3) | (select_580_s9_q[2] & (select_580_s9_q[0] | select_580_s9_q[1]));
  // hls/stages/agreement.hpp:481
  logic or_656;
  assign or_656 = (select_603_s9_q[7:6] == 2'h3) | (select_603_s9_q[8] & (select_603_s9_q[6] | select_603_s9_q[7]));
  logic or_660;
  assign or_660 = (select_603_s9_q[10:9] == 2'h3) | (select_603_s9_q[11] & (select_603_s9_q[9] | select_603_s9_q[10]));
  // hls/stages/agreement.hpp:479
  logic or_668;
  assign or_668 = (select_620_s9_q[7:6] == 2'h3) | (select_620_s9_q[8] & (~(select_620_s9_q[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_672;
  assign or_672 = (select_620_s9_q[1:0] == 2'h3) | (select_620_s9_q[2] & (select_620_s9_q[0] | select_620_s9_q[1]));
  logic or_676;
  assign or_676 = (select_620_s9_q[4:3] == 2'h3) | (select_620_s9_q[5] & (select_620_s9_q[3] | select_620_s9_q[4]));
  // hls/stages/agreement.hpp:480
  logic parity_679;
  assign parity_679 = ^{or_676, or_672, or_668};
  // hls/stages/agreement.hpp:479
  logic or_683;
  assign or_683 = (select_603_s9_q[4:3] == 2'h3) | (select_603_s9_q[5] & (select_603_s9_q[3] | select_603_s9_q[4]));
  // hls/stages/agreement.hpp:481
  logic or_687;
  assign or_687 = (select_620_s9_q[10:9] == 2'h3) | (select_620_s9_q[11] & (select_620_s9_q[9] | select_620_s9_q[10]));
  logic or_691;
  assign or_691 = (select_603_s9_q[1:0] == 2'h3) | (select_603_s9_q[2] & (select_603_s9_q[0] | select_603_s9_q[1]));
  // hls/stages/agreement.hpp:480
  logic parity_694;
  assign parity_694 = ^{or_691, or_687, or_683};
  logic parity_697;
  assign parity_697 = ^{or_691, or_687, or_683, or_676, or_672, or_668, or_660, or_656, or_652};
  // hls/stages/agreement.hpp:481
  logic and_698;
  assign and_698 = parity_592 & parity_647;
  logic or_702;
  assign or_702 = (parity_586 & parity_589) | ((^select_580_s9_q[11:9]) & (parity_586 | parity_589));
  logic and_705;
  assign and_705 = (^{select_603_s9_q[11:6], select_580_s9_q[2:0]}) & (parity_632 | parity_644);
  logic or_706;
  assign or_706 = (parity_632 & parity_644) | and_705;
  // hls/stages/agreement.hpp:479
  logic or_713;
  assign or_713 = (select_580_s9_q[10:9] == 2'h3) | (select_580_s9_q[11] & (select_580_s9_q[9] | select_580_s9_q[10]));
  // hls/stages/agreement.hpp:481
  logic or_717;
  assign or_717 = (select_580_s9_q[4:3] == 2'h3) | (select_580_s9_q[5] & (select_580_s9_q[3] | select_580_s9_q[4]));
  logic or_721;
  assign or_721 = (select_580_s9_q[7:6] == 2'h3) | (select_580_s9_q[8] & (select_580_s9_q[6] | select_580_s9_q[7]));
  // hls/stages/agreement.hpp:480
  logic parity_724;
  assign parity_724 = ^{or_721, or_717, or_713};
  // hls/stages/agreement.hpp:481
  logic or_728;
  assign or_728 = (parity_606 & parity_609) | ((^select_580_s9_q[2:0]) & (parity_606 | parity_609));
  logic or_732;
  assign or_732 = (parity_626 & parity_629) | ((^select_620_s9_q[8:6]) & (parity_626 | parity_629));
  logic or_736;
  assign or_736 = (parity_638 & parity_641) | ((^select_603_s9_q[5:3]) & (parity_638 | parity_641));
  // hls/stages/agreement.hpp:480
  logic parity_739;
  assign parity_739 = ^{or_736, or_732, or_728};
  // hls/stages/agreement.hpp:465
  logic [11:0] select_829;
  assign select_829 = and_573_s9_q ? select_828_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_835;
  assign parity_835 = ^select_829[5:3];
  logic parity_838;
  assign parity_838 = ^select_829[8:6];
  logic parity_841;
  assign parity_841 = ^select_829[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_852;
  assign select_852 = and_596_s9_q ? select_851_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_855;
  assign parity_855 = ^select_852[8:6];
  logic parity_858;
  assign parity_858 = ^select_852[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_869;
  assign select_869 = and_613_s9_q ? select_868_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_875;
  assign parity_875 = ^select_869[2:0];
  logic parity_878;
  assign parity_878 = ^select_869[5:3];
  logic parity_881;
  assign parity_881 = ^select_869[8:0];
  logic parity_887;
  assign parity_887 = ^select_869[11:9];
  logic parity_890;
  assign parity_890 = ^select_852[2:0];
  logic parity_893;
  assign parity_893 = ^{select_869[11:9], select_852[5:0]};
  logic parity_896;
  assign parity_896 = ^{select_869, select_852, select_829[2:0]};
  // hls/stages/agreement.hpp:479
  logic or_901;
  assign or_901 = (select_829[1:0] == 2'h3) | (select_829[2] & (select_829[0] | select_829[1]));
  // hls/stages/agreement.hpp:481
  logic or_905;
  assign or_905 = (select_852[7:6] == 2'h3) | (select_852[8] & (select_852[6] | select_852[7]));
  logic or_909;
  assign or_909 = (select_852[10:9] == 2'h3) | (select_852[11] & (select_852[9] | select_852[10]));
  // hls/stages/agreement.hpp:479
  logic or_917;
  assign or_917 = (select_869[7:6] == 2'h3) | (select_869[8] & (~(select_869[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_921;
  assign or_921 = (select_869[1:0] == 2'h3) | (select_869[2] & (select_869[0] | select_869[1]));
  logic or_925;
  assign or_925 = (select_869[4:3] == 2'h3) | (select_869[5] & (select_869[3] | select_869[4]));
  // hls/stages/agreement.hpp:480
  logic parity_928;
  assign parity_928 = ^{or_925, or_921, or_917};
  // hls/stages/agreement.hpp:479
  logic or_932;
  assign or_932 = (select_852[4:3] == 2'h3) | (select_852[5] & (select_852[3] | select_852[4]));
  // hls/stages/agreement.hpp:481
  logic or_936;
  assign or_936 = (select_869[10:9] == 2'h3) | (select_869[11] & (select_869[9] | select_869[10]));
  logic or_940;
  assign or_940 = (select_852[1:0] == 2'h3) | (select_852[2] & (select_852[0] | select_852[1]));
  // hls/stages/agreement.hpp:480
  logic parity_943;
  assign parity_943 = ^{or_940, or_936, or_932};
  logic parity_946;
  assign parity_946 = ^{or_940, or_936, or_932, or_925, or_921, or_917, or_909, or_905, or_901};
  // hls/stages/agreement.hpp:481
  logic or_951;
  assign or_951 = (parity_835 & parity_838) | ((^select_829[11:9]) & (parity_835 | parity_838));
  logic and_954;
  assign and_954 = (^{select_852[11:6], select_829[2:0]}) & (parity_881 | parity_893);
  // hls/stages/agreement.hpp:479
  logic or_962;
  assign or_962 = (select_829[10:9] == 2'h3) | (select_829[11] & (select_829[9] | select_829[10]));
  // hls/stages/agreement.hpp:481
  logic or_966;
  assign or_966 = (select_829[4:3] == 2'h3) | (select_829[5] & (select_829[3] | select_829[4]));
  logic or_970;
  assign or_970 = (select_829[7:6] == 2'h3) | (select_829[8] & (select_829[6] | select_829[7]));
  logic or_977;
  assign or_977 = (parity_855 & parity_858) | ((^select_829[2:0]) & (parity_855 | parity_858));
  logic or_981;
  assign or_981 = (parity_875 & parity_878) | ((^select_869[8:6]) & (parity_875 | parity_878));
  logic or_985;
  assign or_985 = (parity_887 & parity_890) | ((^select_852[5:3]) & (parity_887 | parity_890));
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1082;
  assign select_1082 = and_573_s9_q ? select_1081_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1088;
  assign parity_1088 = ^select_1082[5:3];
  logic parity_1091;
  assign parity_1091 = ^select_1082[8:6];
  logic parity_1094;
  assign parity_1094 = ^select_1082[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1103;
  assign select_1103 = and_596_s9_q ? select_1102_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1106;
  assign parity_1106 = ^select_1103[8:6];
  logic parity_1109;
  assign parity_1109 = ^select_1103[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1118;
  assign select_1118 = and_613_s9_q ? select_1117_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1124;
  assign parity_1124 = ^select_1118[2:0];
  logic parity_1127;
  assign parity_1127 = ^select_1118[5:3];
  logic parity_1130;
  assign parity_1130 = ^select_1118[8:0];
  logic parity_1136;
  assign parity_1136 = ^select_1118[11:9];
  logic parity_1139;
  assign parity_1139 = ^select_1103[2:0];
  logic parity_1142;
  assign parity_1142 = ^{select_1118[11:9], select_1103[5:0]};
  logic parity_1145;
  assign parity_1145 = ^{select_1118, select_1103, select_1082[2:0]};
  // hls/stages/agreement.hpp:479
  logic or_1150;
  assign or_1150 = (select_1082[1:0] == 2'h3) | (select_1082[2] & (select_1082[0] | select_1082[1]));
  // hls/stages/agreement.hpp:481
  logic or_1154;
  assign or_1154 = (select_1103[7:6] == 2'h3) | (select_1103[8] & (select_1103[6] | select_1103[7]));
  logic or_1158;
  assign or_1158 = (select_1103[10:9] == 2'h3) | (select_1103[11] & (select_1103[9] | select_1103[10]));
  // hls/stages/agreement.hpp:479
  logic or_1166;
  assign or_1166 = (select_1118[7:6] == 2'h3) | (select_1118[8] & (~(select_1118[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1170;
  assign or_1170 = (select_1118[1:0] == 2'h3) | (select_1118[2] & (select_1118[0] | select_1118[1]));
  logic or_1174;
  assign or_1174 = (select_1118[4:3] == 2'h3) | (select_1118[5] & (select_1118[3] | select_1118[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1177;
  assign parity_1177 = ^{or_1174, or_1170, or_1166};
  // hls/stages/agreement.hpp:479
  logic or_1181;
  assign or_1181 = (select_1103[4:3] == 2'h3) | (select_1103[5] & (select_1103[3] | select_1103[4]));
  // hls/stages/agreement.hpp:481
  logic or_1185;
  assign or_1185 = (select_1118[10:9] == 2'h3) | (select_1118[11] & (select_1118[9] | select_1118[10]));
  logic or_1189;
  assign or_1189 = (select_1103[1:0] == 2'h3) | (select_1103[2] & (select_1103[0] | select_1103[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1192;
  assign parity_1192 = ^{or_1189, or_1185, or_1181};
  logic parity_1195;
  assign parity_1195 = ^{or_1189, or_1185, or_1181, or_1174, or_1170, or_1166, or_1158, or_1154, or_1150};
  // hls/stages/agreement.hpp:481
  logic or_1200;
  assign or_1200 = (parity_1088 & parity_1091) | ((^select_1082[11:9]) & (parity_1088 | parity_1091));
  logic and_1203;
  assign and_1203 = (^{select_1103[11:6], select_1082[2:0]}) & (parity_1130 | parity_1142);
  // hls/stages/agreement.hpp:479
  logic or_1211;
  assign or_1211 = (select_1082[10:9] == 2'h3) | (select_1082[11] & (select_1082[9] | select_1082[10]));
  // hls/stages/agreement.hpp:481
  logic or_1215;
  assign or_1215 = (select_1082[4:3] == 2'h3) | (select_1082[5] & (select_1082[3] | select_1082[4]));
  logic or_1219;
  assign or_1219 = (select_1082[7:6] == 2'h3) | (select_1082[8] & (select_1082[6] | select_1082[7]));
  logic or_1226;
  assign or_1226 = (parity_1106 & parity_1109) | ((^select_1082[2:0]) & (parity_1106 | parity_1109));
  logic or_1230;
  assign or_1230 = (parity_1124 & parity_1127) | ((^select_1118[8:6]) & (parity_1124 | parity_1127));
  logic or_1234;
  assign or_1234 = (parity_1136 & parity_1139) | ((^select_1103[5:3]) & (parity_1136 | parity_1139));
  // hls/stages/agreement.hpp:211
  logic [6:0] select_1424;
  assign select_1424 = so_s9_q ? x_s9_q[6:0] : (or_439_s9_q ? (less_446_s9_q ? 7'h0 : sum_1371_s9_q) : 7'h0);

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1075; read in stage 9, written in stage 17: 9 < 17 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_439_s9_q ? sum_1371_s9_q : right_s9_q;
  logic best_right_re;
  assign best_right_re = s9_en & select_560_s9_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_450_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_542_s9_q, left_rdata_s9_q[56:42], and_541_s9_q, left_rdata_s9_q[41:27], and_540_s9_q, left_rdata_s9_q[26:12], and_539_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
  end
`ifndef SYNTHESIS
  logic [6:0] left_raddr_s7_sim;
  logic left_re_s7_sim;
  logic [6:0] left_raddr_s8_sim;
  logic left_re_s8_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_re_s7_sim <= 1'b0;
      left_re_s8_sim <= 1'b0;
    end else if (en_i) begin
      left_re_s7_sim <= left_re;
      left_raddr_s7_sim <= left_raddr;
      left_re_s8_sim <= left_re_s7_sim;
      left_raddr_s8_sim <= left_raddr_s7_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s7_sim && left_raddr_s7_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s8_sim && left_raddr_s8_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 7'd120) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 7'd120) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [6:0] right_codes_waddr;
  assign right_codes_waddr = x_s9_q[6:0];
  logic right_codes_we;
  assign right_codes_we = s9_en & and_450_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_551_s9_q, right_codes_rdata_s9_q[71:60], and_550_s9_q, right_codes_rdata_s9_q[59:48], and_549_s9_q, right_codes_rdata_s9_q[47:36], and_548_s9_q, right_codes_rdata_s9_q[35:24], and_547_s9_q, right_codes_rdata_s9_q[23:12], and_546_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
  end
`ifndef SYNTHESIS
  logic [6:0] right_codes_raddr_s7_sim;
  logic right_codes_re_s7_sim;
  logic [6:0] right_codes_raddr_s8_sim;
  logic right_codes_re_s8_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_codes_re_s7_sim <= 1'b0;
      right_codes_re_s8_sim <= 1'b0;
    end else if (en_i) begin
      right_codes_re_s7_sim <= right_codes_re;
      right_codes_raddr_s7_sim <= right_codes_raddr;
      right_codes_re_s8_sim <= right_codes_re_s7_sim;
      right_codes_raddr_s8_sim <= right_codes_raddr_s7_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s7_sim && right_codes_raddr_s7_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s8_sim && right_codes_raddr_s8_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 7'd120) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 7'd120) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  logic [7:0] pixel_0_s10_q;
  logic [7:0] pixel_1_s10_q;
  logic saturated_s10_q;
  logic mask_s10_q;
  logic marks_first_s10_q;
  logic marks_last_s10_q;
  logic sample_pair_first_s10_q;
  logic sample_pair_whole_s10_q;
  logic sample_present_s10_q;
  logic sample_of_skin_s10_q;
  logic [5:0] run_shift_s10_q;
  logic [7:0] x_s10_q;
  logic [3:0] age_s10_q;
  logic [2:0] slot_s10_q;
  logic ends_cell_s10_q;
  logic lower_half_s10_q;
  logic equal_377_s10_q;
  logic [8:0] select_383_s10_q;
  logic and_392_s10_q;
  logic equal_398_s10_q;
  logic [6:0] column_s10_q;
  logic and_416_s10_q;
  logic and_418_s10_q;
  logic equal_421_s10_q;
  logic so_s10_q;
  logic equal_438_s10_q;
  logic or_439_s10_q;
  logic equal_441_s10_q;
  logic less_446_s10_q;
  logic not_447_s10_q;
  logic equal_476_s10_q;
  logic equal_479_s10_q;
  logic select_481_s10_q;
  logic [6:0] x_s10_2_q;
  logic [45:0] best_left_rdata_s10_q;
  logic select_567_s10_q;
  logic xor_648_s10_q;
  logic parity_697_s10_q;
  logic and_698_s10_q;
  logic or_702_s10_q;
  logic or_706_s10_q;
  logic parity_709_s10_q;
  logic or_713_s10_q;
  logic or_717_s10_q;
  logic or_721_s10_q;
  logic or_728_s10_q;
  logic or_732_s10_q;
  logic or_736_s10_q;
  logic and_745_s10_q;
  logic and_747_s10_q;
  logic and_749_s10_q;
  logic or_750_s10_q;
  logic or_759_s10_q;
  logic or_763_s10_q;
  logic or_767_s10_q;
  logic or_772_s10_q;
  logic or_778_s10_q;
  logic and_781_s10_q;
  logic xor_897_s10_q;
  logic parity_912_s10_q;
  logic parity_946_s10_q;
  logic and_947_s10_q;
  logic or_951_s10_q;
  logic or_955_s10_q;
  logic or_962_s10_q;
  logic or_966_s10_q;
  logic or_970_s10_q;
  logic or_977_s10_q;
  logic or_981_s10_q;
  logic or_985_s10_q;
  logic and_994_s10_q;
  logic or_995_s10_q;
  logic or_1008_s10_q;
  logic or_1012_s10_q;
  logic or_1016_s10_q;
  logic xor_1146_s10_q;
  logic parity_1161_s10_q;
  logic parity_1195_s10_q;
  logic and_1196_s10_q;
  logic or_1200_s10_q;
  logic or_1204_s10_q;
  logic or_1211_s10_q;
  logic or_1215_s10_q;
  logic or_1219_s10_q;
  logic or_1226_s10_q;
  logic or_1230_s10_q;
  logic or_1234_s10_q;
  logic and_1243_s10_q;
  logic or_1244_s10_q;
  logic or_1257_s10_q;
  logic or_1261_s10_q;
  logic or_1265_s10_q;
  logic and_1369_s10_q;
  logic [6:0] right_s10_q;
  logic select_1376_s10_q;
  logic equal_1385_s10_q;
  logic and_1392_s10_q;
  logic and_1395_s10_q;
  logic and_1399_s10_q;
  logic or_1413_s10_q;
  logic [6:0] select_1424_s10_q;
  logic [1:0] sum_1436_s10_q;
  logic less_1468_s10_q;
  logic equal_1484_s10_q;
  logic [8:0] select_1491_s10_q;
  logic and_1523_s10_q;
  logic less_1543_s10_q;
  logic [7:0] select_1782_s10_q;
  logic [7:0] select_1836_s10_q;
  logic [7:0] select_2125_s10_q;
  logic [7:0] select_2148_s10_q;
  logic [6:0] select_2157_s10_q;
  logic select_2158_s10_q;
  logic equal_2186_s10_q;
  logic and_2323_s10_q;
  logic equal_2511_s10_q;
  logic equal_2565_s10_q;
  logic and_2757_s10_q;
  logic and_2759_s10_q;
  logic less_2865_s10_q;
  logic equal_3062_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      pixel_0_s10_q <= pixel_0_s9_q;
      pixel_1_s10_q <= pixel_1_s9_q;
      saturated_s10_q <= saturated_s9_q;
      mask_s10_q <= mask_s9_q;
      marks_first_s10_q <= marks_first_s9_q;
      marks_last_s10_q <= marks_last_s9_q;
      sample_pair_first_s10_q <= sample_pair_first_s9_q;
      sample_pair_whole_s10_q <= sample_pair_whole_s9_q;
      sample_present_s10_q <= sample_present_s9_q;
      sample_of_skin_s10_q <= sample_of_skin_s9_q;
      run_shift_s10_q <= run_shift_s9_q;
      x_s10_q <= x_s9_q;
      age_s10_q <= age_s9_q;
      slot_s10_q <= slot_s9_q;
      ends_cell_s10_q <= ends_cell_s9_q;
      lower_half_s10_q <= lower_half_s9_q;
      equal_377_s10_q <= equal_377_s9_q;
      select_383_s10_q <= select_383_s9_q;
      and_392_s10_q <= and_392_s9_q;
      equal_398_s10_q <= equal_398_s9_q;
      column_s10_q <= column_s9_q;
      and_416_s10_q <= and_416_s9_q;
      and_418_s10_q <= and_418_s9_q;
      equal_421_s10_q <= equal_421_s9_q;
      so_s10_q <= so_s9_q;
      equal_438_s10_q <= equal_438_s9_q;
      or_439_s10_q <= or_439_s9_q;
      equal_441_s10_q <= equal_441_s9_q;
      less_446_s10_q <= less_446_s9_q;
      not_447_s10_q <= not_447_s9_q;
      equal_476_s10_q <= equal_476_s9_q;
      equal_479_s10_q <= equal_479_s9_q;
      select_481_s10_q <= select_481_s9_q;
      x_s10_2_q <= x_s9_2_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_567_s10_q <= select_567_s9_q;
      xor_648_s10_q <= parity_592 ^ parity_647;
      parity_697_s10_q <= parity_697;
      and_698_s10_q <= and_698;
      or_702_s10_q <= or_702;
      or_706_s10_q <= or_706;
      parity_709_s10_q <= ^{or_706, or_702, and_698};
      or_713_s10_q <= or_713;
      or_717_s10_q <= or_717;
      or_721_s10_q <= or_721;
      or_728_s10_q <= or_728;
      or_732_s10_q <= or_732;
      or_736_s10_q <= or_736;
      and_745_s10_q <= parity_679 & parity_694;
      and_747_s10_q <= (^{or_660, or_656, or_652}) & (parity_679 | parity_694);
      and_749_s10_q <= parity_724 & parity_739;
      or_750_s10_q <= parity_724 | parity_739;
      or_759_s10_q <= (or_656 & or_660) | (or_652 & (or_656 | or_660));
      or_763_s10_q <= (or_672 & or_676) | (or_668 & (or_672 | or_676));
      or_767_s10_q <= (or_687 & or_691) | (or_683 & (or_687 | or_691));
      or_772_s10_q <= or_702 | or_706;
      or_778_s10_q <= (or_717 & or_721) | (or_713 & (or_717 | or_721));
      and_781_s10_q <= or_728 & (or_732 | or_736);
      xor_897_s10_q <= parity_841 ^ parity_896;
      parity_912_s10_q <= ^{or_909, or_905, or_901};
      parity_946_s10_q <= parity_946;
      and_947_s10_q <= parity_841 & parity_896;
      or_951_s10_q <= or_951;
      or_955_s10_q <= (parity_881 & parity_893) | and_954;
      or_962_s10_q <= or_962;
      or_966_s10_q <= or_966;
      or_970_s10_q <= or_970;
      or_977_s10_q <= or_977;
      or_981_s10_q <= or_981;
      or_985_s10_q <= or_985;
      and_994_s10_q <= parity_928 & parity_943;
      or_995_s10_q <= parity_928 | parity_943;
      or_1008_s10_q <= (or_905 & or_909) | (or_901 & (or_905 | or_909));
      or_1012_s10_q <= (or_921 & or_925) | (or_917 & (or_921 | or_925));
      or_1016_s10_q <= (or_936 & or_940) | (or_932 & (or_936 | or_940));
      xor_1146_s10_q <= parity_1094 ^ parity_1145;
      parity_1161_s10_q <= ^{or_1158, or_1154, or_1150};
      parity_1195_s10_q <= parity_1195;
      and_1196_s10_q <= parity_1094 & parity_1145;
      or_1200_s10_q <= or_1200;
      or_1204_s10_q <= (parity_1130 & parity_1142) | and_1203;
      or_1211_s10_q <= or_1211;
      or_1215_s10_q <= or_1215;
      or_1219_s10_q <= or_1219;
      or_1226_s10_q <= or_1226;
      or_1230_s10_q <= or_1230;
      or_1234_s10_q <= or_1234;
      and_1243_s10_q <= parity_1177 & parity_1192;
      or_1244_s10_q <= parity_1177 | parity_1192;
      or_1257_s10_q <= (or_1154 & or_1158) | (or_1150 & (or_1154 | or_1158));
      or_1261_s10_q <= (or_1170 & or_1174) | (or_1166 & (or_1170 | or_1174));
      or_1265_s10_q <= (or_1185 & or_1189) | (or_1181 & (or_1185 | or_1189));
      and_1369_s10_q <= and_1369_s9_q;
      right_s10_q <= right_s9_q;
      select_1376_s10_q <= select_1376_s9_q;
      equal_1385_s10_q <= equal_1385_s9_q;
      and_1392_s10_q <= and_1392_s9_q;
      and_1395_s10_q <= and_1395_s9_q;
      and_1399_s10_q <= and_1399_s9_q;
      or_1413_s10_q <= and_1410_s9_q | (cfg_nearer_above_i & less_1411_s9_q);
      select_1424_s10_q <= select_1424;
      sum_1436_s10_q <= sum_1436_s9_q;
      less_1468_s10_q <= less_1468_s9_q;
      equal_1484_s10_q <= equal_1484_s9_q;
      select_1491_s10_q <= select_1491_s9_q;
      and_1523_s10_q <= and_1523_s9_q;
      less_1543_s10_q <= less_1543_s9_q;
      select_1782_s10_q <= select_1782_s9_q;
      select_1836_s10_q <= select_1836_s9_q;
      select_2125_s10_q <= select_2125_s9_q;
      select_2148_s10_q <= select_2148_s9_q;
      select_2157_s10_q <= select_2157_s9_q;
      select_2158_s10_q <= select_2158_s9_q;
      equal_2186_s10_q <= equal_2186_s9_q;
      and_2323_s10_q <= and_2323_s9_q;
      equal_2511_s10_q <= equal_2511_s9_q;
      equal_2565_s10_q <= equal_2565_s9_q;
      and_2757_s10_q <= and_2757_s9_q;
      and_2759_s10_q <= and_2759_s9_q;
      less_2865_s10_q <= less_2865_s9_q;
      equal_3062_s10_q <= equal_3062_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:480
  logic parity_742;
  assign parity_742 = ^{or_736_s10_q, or_732_s10_q, or_728_s10_q, or_721_s10_q, or_717_s10_q, or_713_s10_q, or_706_s10_q, or_702_s10_q, and_698_s10_q};
  // hls/stages/agreement.hpp:481
  logic and_744;
  assign and_744 = parity_697_s10_q & parity_742;
  logic or_748;
  assign or_748 = and_745_s10_q | and_747_s10_q;
  logic or_752;
  assign or_752 = and_749_s10_q | (parity_709_s10_q & or_750_s10_q);
  // hls/stages/agreement.hpp:480
  logic parity_770;
  assign parity_770 = ^{or_767_s10_q, or_763_s10_q, or_759_s10_q};
  // hls/stages/agreement.hpp:481
  logic or_774;
  assign or_774 = (or_702_s10_q & or_706_s10_q) | (and_698_s10_q & or_772_s10_q);
  logic or_782;
  assign or_782 = (or_732_s10_q & or_736_s10_q) | and_781_s10_q;
  // hls/stages/agreement.hpp:480
  logic parity_785;
  assign parity_785 = ^{or_782, or_778_s10_q, or_774};
  logic parity_788;
  assign parity_788 = ^{or_782, or_778_s10_q, or_774, or_767_s10_q, or_763_s10_q, or_759_s10_q, or_752, or_748, and_744};
  // hls/stages/agreement.hpp:481
  logic or_792;
  assign or_792 = (parity_770 & parity_785) | ((^{or_752, or_748, and_744}) & (parity_770 | parity_785));
  logic or_796;
  assign or_796 = (or_748 & or_752) | (and_744 & (or_748 | or_752));
  logic or_800;
  assign or_800 = (or_763_s10_q & or_767_s10_q) | (or_759_s10_q & (or_763_s10_q | or_767_s10_q));
  logic or_804;
  assign or_804 = (or_778_s10_q & or_782) | (or_774 & (or_778_s10_q | or_782));
  // hls/stages/agreement.hpp:480
  logic parity_973;
  assign parity_973 = ^{or_970_s10_q, or_966_s10_q, or_962_s10_q};
  logic parity_988;
  assign parity_988 = ^{or_985_s10_q, or_981_s10_q, or_977_s10_q};
  logic parity_991;
  assign parity_991 = ^{or_985_s10_q, or_981_s10_q, or_977_s10_q, or_970_s10_q, or_966_s10_q, or_962_s10_q, or_955_s10_q, or_951_s10_q, and_947_s10_q};
  // hls/stages/agreement.hpp:481
  logic and_993;
  assign and_993 = parity_946_s10_q & parity_991;
  logic or_997;
  assign or_997 = and_994_s10_q | (parity_912_s10_q & or_995_s10_q);
  logic and_1000;
  assign and_1000 = (^{or_955_s10_q, or_951_s10_q, and_947_s10_q}) & (parity_973 | parity_988);
  logic or_1001;
  assign or_1001 = (parity_973 & parity_988) | and_1000;
  // hls/stages/agreement.hpp:480
  logic parity_1019;
  assign parity_1019 = ^{or_1016_s10_q, or_1012_s10_q, or_1008_s10_q};
  // hls/stages/agreement.hpp:481
  logic or_1023;
  assign or_1023 = (or_951_s10_q & or_955_s10_q) | (and_947_s10_q & (or_951_s10_q | or_955_s10_q));
  logic or_1027;
  assign or_1027 = (or_966_s10_q & or_970_s10_q) | (or_962_s10_q & (or_966_s10_q | or_970_s10_q));
  logic or_1031;
  assign or_1031 = (or_981_s10_q & or_985_s10_q) | (or_977_s10_q & (or_981_s10_q | or_985_s10_q));
  // hls/stages/agreement.hpp:480
  logic parity_1034;
  assign parity_1034 = ^{or_1031, or_1027, or_1023};
  logic parity_1037;
  assign parity_1037 = ^{or_1031, or_1027, or_1023, or_1016_s10_q, or_1012_s10_q, or_1008_s10_q, or_1001, or_997, and_993};
  // hls/stages/agreement.hpp:481
  logic or_1049;
  assign or_1049 = (or_1012_s10_q & or_1016_s10_q) | (or_1008_s10_q & (or_1012_s10_q | or_1016_s10_q));
  // hls/stages/agreement.hpp:480
  logic parity_1222;
  assign parity_1222 = ^{or_1219_s10_q, or_1215_s10_q, or_1211_s10_q};
  logic parity_1237;
  assign parity_1237 = ^{or_1234_s10_q, or_1230_s10_q, or_1226_s10_q};
  logic parity_1240;
  assign parity_1240 = ^{or_1234_s10_q, or_1230_s10_q, or_1226_s10_q, or_1219_s10_q, or_1215_s10_q, or_1211_s10_q, or_1204_s10_q, or_1200_s10_q, and_1196_s10_q};
  // hls/stages/agreement.hpp:481
  logic and_1242;
  assign and_1242 = parity_1195_s10_q & parity_1240;
  logic or_1246;
  assign or_1246 = and_1243_s10_q | (parity_1161_s10_q & or_1244_s10_q);
  logic and_1249;
  assign and_1249 = (^{or_1204_s10_q, or_1200_s10_q, and_1196_s10_q}) & (parity_1222 | parity_1237);
  logic or_1250;
  assign or_1250 = (parity_1222 & parity_1237) | and_1249;
  // hls/stages/agreement.hpp:480
  logic parity_1268;
  assign parity_1268 = ^{or_1265_s10_q, or_1261_s10_q, or_1257_s10_q};
  // hls/stages/agreement.hpp:481
  logic or_1272;
  assign or_1272 = (or_1200_s10_q & or_1204_s10_q) | (and_1196_s10_q & (or_1200_s10_q | or_1204_s10_q));
  logic or_1276;
  assign or_1276 = (or_1215_s10_q & or_1219_s10_q) | (or_1211_s10_q & (or_1215_s10_q | or_1219_s10_q));
  logic or_1280;
  assign or_1280 = (or_1230_s10_q & or_1234_s10_q) | (or_1226_s10_q & (or_1230_s10_q | or_1234_s10_q));
  // hls/stages/agreement.hpp:480
  logic parity_1283;
  assign parity_1283 = ^{or_1280, or_1276, or_1272};
  logic parity_1286;
  assign parity_1286 = ^{or_1280, or_1276, or_1272, or_1265_s10_q, or_1261_s10_q, or_1257_s10_q, or_1250, or_1246, and_1242};
  // hls/stages/agreement.hpp:481
  logic or_1298;
  assign or_1298 = (or_1261_s10_q & or_1265_s10_q) | (or_1257_s10_q & (or_1261_s10_q | or_1265_s10_q));

  logic [7:0] pixel_0_s11_q;
  logic [7:0] pixel_1_s11_q;
  logic saturated_s11_q;
  logic mask_s11_q;
  logic marks_first_s11_q;
  logic marks_last_s11_q;
  logic sample_pair_first_s11_q;
  logic sample_pair_whole_s11_q;
  logic sample_present_s11_q;
  logic sample_of_skin_s11_q;
  logic [5:0] run_shift_s11_q;
  logic [7:0] x_s11_q;
  logic [3:0] age_s11_q;
  logic [2:0] slot_s11_q;
  logic ends_cell_s11_q;
  logic lower_half_s11_q;
  logic equal_377_s11_q;
  logic [8:0] select_383_s11_q;
  logic and_392_s11_q;
  logic equal_398_s11_q;
  logic [6:0] column_s11_q;
  logic and_416_s11_q;
  logic and_418_s11_q;
  logic equal_421_s11_q;
  logic so_s11_q;
  logic equal_438_s11_q;
  logic or_439_s11_q;
  logic equal_441_s11_q;
  logic less_446_s11_q;
  logic not_447_s11_q;
  logic equal_476_s11_q;
  logic equal_479_s11_q;
  logic select_481_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic select_567_s11_q;
  logic xor_648_s11_q;
  logic xor_743_s11_q;
  logic parity_788_s11_q;
  logic or_792_s11_q;
  logic or_796_s11_q;
  logic or_800_s11_q;
  logic or_804_s11_q;
  logic parity_807_s11_q;
  logic and_810_s11_q;
  logic and_812_s11_q;
  logic xor_897_s11_q;
  logic xor_992_s11_q;
  logic parity_1037_s11_q;
  logic and_1038_s11_q;
  logic and_1040_s11_q;
  logic and_1042_s11_q;
  logic and_1044_s11_q;
  logic or_1049_s11_q;
  logic or_1053_s11_q;
  logic xor_1146_s11_q;
  logic xor_1241_s11_q;
  logic parity_1286_s11_q;
  logic and_1287_s11_q;
  logic and_1289_s11_q;
  logic and_1291_s11_q;
  logic and_1293_s11_q;
  logic or_1298_s11_q;
  logic or_1302_s11_q;
  logic and_1369_s11_q;
  logic [6:0] right_s11_q;
  logic [28:0] best_right_rdata_s11_q;
  logic select_1376_s11_q;
  logic equal_1385_s11_q;
  logic and_1392_s11_q;
  logic and_1395_s11_q;
  logic and_1399_s11_q;
  logic or_1413_s11_q;
  logic [6:0] select_1424_s11_q;
  logic [1:0] sum_1436_s11_q;
  logic less_1468_s11_q;
  logic equal_1484_s11_q;
  logic [8:0] select_1491_s11_q;
  logic and_1523_s11_q;
  logic less_1543_s11_q;
  logic [7:0] select_1782_s11_q;
  logic [7:0] select_1836_s11_q;
  logic [7:0] select_2125_s11_q;
  logic [7:0] select_2148_s11_q;
  logic [6:0] select_2157_s11_q;
  logic select_2158_s11_q;
  logic equal_2186_s11_q;
  logic and_2323_s11_q;
  logic equal_2511_s11_q;
  logic equal_2565_s11_q;
  logic and_2757_s11_q;
  logic and_2759_s11_q;
  logic less_2865_s11_q;
  logic equal_3062_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      pixel_0_s11_q <= pixel_0_s10_q;
      pixel_1_s11_q <= pixel_1_s10_q;
      saturated_s11_q <= saturated_s10_q;
      mask_s11_q <= mask_s10_q;
      marks_first_s11_q <= marks_first_s10_q;
      marks_last_s11_q <= marks_last_s10_q;
      sample_pair_first_s11_q <= sample_pair_first_s10_q;
      sample_pair_whole_s11_q <= sample_pair_whole_s10_q;
      sample_present_s11_q <= sample_present_s10_q;
      sample_of_skin_s11_q <= sample_of_skin_s10_q;
      run_shift_s11_q <= run_shift_s10_q;
      x_s11_q <= x_s10_q;
      age_s11_q <= age_s10_q;
      slot_s11_q <= slot_s10_q;
      ends_cell_s11_q <= ends_cell_s10_q;
      lower_half_s11_q <= lower_half_s10_q;
      equal_377_s11_q <= equal_377_s10_q;
      select_383_s11_q <= select_383_s10_q;
      and_392_s11_q <= and_392_s10_q;
      equal_398_s11_q <= equal_398_s10_q;
      column_s11_q <= column_s10_q;
      and_416_s11_q <= and_416_s10_q;
      and_418_s11_q <= and_418_s10_q;
      equal_421_s11_q <= equal_421_s10_q;
      so_s11_q <= so_s10_q;
      equal_438_s11_q <= equal_438_s10_q;
      or_439_s11_q <= or_439_s10_q;
      equal_441_s11_q <= equal_441_s10_q;
      less_446_s11_q <= less_446_s10_q;
      not_447_s11_q <= not_447_s10_q;
      equal_476_s11_q <= equal_476_s10_q;
      equal_479_s11_q <= equal_479_s10_q;
      select_481_s11_q <= select_481_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_567_s11_q <= select_567_s10_q;
      xor_648_s11_q <= xor_648_s10_q;
      xor_743_s11_q <= parity_697_s10_q ^ parity_742;
      parity_788_s11_q <= parity_788;
      or_792_s11_q <= or_792;
      or_796_s11_q <= or_796;
      or_800_s11_q <= or_800;
      or_804_s11_q <= or_804;
      parity_807_s11_q <= ^{or_804, or_800, or_796};
      and_810_s11_q <= or_800 & or_804;
      and_812_s11_q <= or_796 & (or_800 | or_804);
      xor_897_s11_q <= xor_897_s10_q;
      xor_992_s11_q <= parity_946_s10_q ^ parity_991;
      parity_1037_s11_q <= parity_1037;
      and_1038_s11_q <= parity_1019 & parity_1034;
      and_1040_s11_q <= (^{or_1001, or_997, and_993}) & (parity_1019 | parity_1034);
      and_1042_s11_q <= or_997 & or_1001;
      and_1044_s11_q <= and_993 & (or_997 | or_1001);
      or_1049_s11_q <= or_1049;
      or_1053_s11_q <= (or_1027 & or_1031) | (or_1023 & (or_1027 | or_1031));
      xor_1146_s11_q <= xor_1146_s10_q;
      xor_1241_s11_q <= parity_1195_s10_q ^ parity_1240;
      parity_1286_s11_q <= parity_1286;
      and_1287_s11_q <= parity_1268 & parity_1283;
      and_1289_s11_q <= (^{or_1250, or_1246, and_1242}) & (parity_1268 | parity_1283);
      and_1291_s11_q <= or_1246 & or_1250;
      and_1293_s11_q <= and_1242 & (or_1246 | or_1250);
      or_1298_s11_q <= or_1298;
      or_1302_s11_q <= (or_1276 & or_1280) | (or_1272 & (or_1276 | or_1280));
      and_1369_s11_q <= and_1369_s10_q;
      right_s11_q <= right_s10_q;
      best_right_rdata_s11_q <= best_right_rdata_q;
      select_1376_s11_q <= select_1376_s10_q;
      equal_1385_s11_q <= equal_1385_s10_q;
      and_1392_s11_q <= and_1392_s10_q;
      and_1395_s11_q <= and_1395_s10_q;
      and_1399_s11_q <= and_1399_s10_q;
      or_1413_s11_q <= or_1413_s10_q;
      select_1424_s11_q <= select_1424_s10_q;
      sum_1436_s11_q <= sum_1436_s10_q;
      less_1468_s11_q <= less_1468_s10_q;
      equal_1484_s11_q <= equal_1484_s10_q;
      select_1491_s11_q <= select_1491_s10_q;
      and_1523_s11_q <= and_1523_s10_q;
      less_1543_s11_q <= less_1543_s10_q;
      select_1782_s11_q <= select_1782_s10_q;
      select_1836_s11_q <= select_1836_s10_q;
      select_2125_s11_q <= select_2125_s10_q;
      select_2148_s11_q <= select_2148_s10_q;
      select_2157_s11_q <= select_2157_s10_q;
      select_2158_s11_q <= select_2158_s10_q;
      equal_2186_s11_q <= equal_2186_s10_q;
      and_2323_s11_q <= and_2323_s10_q;
      equal_2511_s11_q <= equal_2511_s10_q;
      equal_2565_s11_q <= equal_2565_s10_q;
      and_2757_s11_q <= and_2757_s10_q;
      and_2759_s11_q <= and_2759_s10_q;
      less_2865_s11_q <= less_2865_s10_q;
      equal_3062_s11_q <= equal_3062_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  logic [5:0] middle_sum_columns_values_0_q;
  logic [5:0] middle_sum_columns_values_1_q;
  logic [5:0] middle_sum_columns_values_2_q;
  logic [5:0] middle_sum_columns_values_3_q;
  logic [5:0] middle_sum_columns_values_4_q;
  logic [5:0] middle_sum_columns_values_5_q;
  logic [5:0] middle_sum_columns_values_6_q;
  // hls/stages/census.hpp:98
  logic and_393;
  assign and_393 = sample_pair_whole_s11_q & and_392_s11_q;
  // hls/stages/agreement.hpp:480
  logic parity_809;
  assign parity_809 = ^{or_804_s11_q, or_800_s11_q, or_796_s11_q, or_792_s11_q};
  // hls/stages/agreement.hpp:481
  logic or_813;
  assign or_813 = and_810_s11_q | and_812_s11_q;
  logic and_814;
  assign and_814 = or_792_s11_q & parity_807_s11_q;
  // hls/stages/agreement.hpp:480
  logic xor_815;
  assign xor_815 = or_813 ^ and_814;
  // hls/stages/agreement.hpp:483
  logic and_816;
  assign and_816 = or_813 & and_814;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_817;
  assign select_817 = equal_441_s11_q ? {and_816, xor_815, parity_809, parity_788_s11_q, xor_743_s11_q, xor_648_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_439_s11_q ? 6'h0 : select_817;
  // hls/stages/agreement.hpp:586
  logic [5:0] select_819;
  assign select_819 = age_s11_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:481
  logic or_1041;
  assign or_1041 = and_1038_s11_q | and_1040_s11_q;
  logic or_1045;
  assign or_1045 = and_1042_s11_q | and_1044_s11_q;
  // hls/stages/agreement.hpp:480
  logic parity_1058;
  assign parity_1058 = ^{or_1053_s11_q, or_1049_s11_q, or_1045, or_1041};
  // hls/stages/agreement.hpp:481
  logic or_1062;
  assign or_1062 = (or_1049_s11_q & or_1053_s11_q) | (or_1045 & (or_1049_s11_q | or_1053_s11_q));
  logic and_1063;
  assign and_1063 = or_1041 & (^{or_1053_s11_q, or_1049_s11_q, or_1045});
  // hls/stages/agreement.hpp:480
  logic xor_1064;
  assign xor_1064 = or_1062 ^ and_1063;
  // hls/stages/agreement.hpp:483
  logic and_1065;
  assign and_1065 = or_1062 & and_1063;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_1066;
  assign select_1066 = equal_441_s11_q ? {and_1065, xor_1064, parity_1058, parity_1037_s11_q, xor_992_s11_q, xor_897_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_439_s11_q ? 6'h0 : select_1066;
  // hls/stages/agreement.hpp:481
  logic or_1290;
  assign or_1290 = and_1287_s11_q | and_1289_s11_q;
  logic or_1294;
  assign or_1294 = and_1291_s11_q | and_1293_s11_q;
  // hls/stages/agreement.hpp:480
  logic parity_1307;
  assign parity_1307 = ^{or_1302_s11_q, or_1298_s11_q, or_1294, or_1290};
  // hls/stages/agreement.hpp:481
  logic or_1311;
  assign or_1311 = (or_1298_s11_q & or_1302_s11_q) | (or_1294 & (or_1298_s11_q | or_1302_s11_q));
  logic and_1312;
  assign and_1312 = or_1290 & (^{or_1302_s11_q, or_1298_s11_q, or_1294});
  // hls/stages/agreement.hpp:480
  logic xor_1313;
  assign xor_1313 = or_1311 ^ and_1312;
  // hls/stages/agreement.hpp:483
  logic and_1314;
  assign and_1314 = or_1311 & and_1312;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_1315;
  assign select_1315 = equal_441_s11_q ? {and_1314, xor_1313, parity_1307, parity_1286_s11_q, xor_1241_s11_q, xor_1146_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_439_s11_q ? 6'h0 : select_1315;
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v;
  assign before_v = age_s11_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1343;
  assign sum_1343 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:728
  logic [6:0] chosen;
  assign chosen = slot_s11_q[2] ? best_right_rdata_s11_q[14:8] : best_right_rdata_s11_q[28:22];
  // hls/stages/agreement.hpp:174
  logic [5:0] select_1752;
  assign select_1752 = slot_s11_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [5:0] select_1753;
  assign select_1753 = slot_s11_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_1755;
  assign select_1755 = slot_s11_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1756;
  assign select_1756 = slot_s11_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_1759;
  assign select_1759 = slot_s11_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1760;
  assign select_1760 = slot_s11_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:146; read in stage 11, written in stage 14: 11 < 14 < 11 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_383_s11_q;
  logic averager_memory_re;
  assign averager_memory_re = s11_en & and_393;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    middle_sum_columns_values_0_q = 6'h0;
    middle_sum_columns_values_1_q = 6'h0;
    middle_sum_columns_values_2_q = 6'h0;
    middle_sum_columns_values_3_q = 6'h0;
    middle_sum_columns_values_4_q = 6'h0;
    middle_sum_columns_values_5_q = 6'h0;
    middle_sum_columns_values_6_q = 6'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s11_en) begin
      middle_sum_columns_values_0_q <= slot_s11_q[0] ? middle_sum_columns_values_0_q : column_2;
      middle_sum_columns_values_1_q <= select_1760;
      middle_sum_columns_values_2_q <= select_1759;
      middle_sum_columns_values_3_q <= select_1756;
      middle_sum_columns_values_4_q <= select_1755;
      middle_sum_columns_values_5_q <= select_1753;
      middle_sum_columns_values_6_q <= select_1752;
    end
  end

  logic [7:0] pixel_0_s12_q;
  logic [7:0] pixel_1_s12_q;
  logic saturated_s12_q;
  logic mask_s12_q;
  logic marks_first_s12_q;
  logic marks_last_s12_q;
  logic sample_pair_first_s12_q;
  logic sample_pair_whole_s12_q;
  logic sample_present_s12_q;
  logic sample_of_skin_s12_q;
  logic [5:0] run_shift_s12_q;
  logic [7:0] x_s12_q;
  logic [3:0] age_s12_q;
  logic [2:0] slot_s12_q;
  logic ends_cell_s12_q;
  logic lower_half_s12_q;
  logic equal_377_s12_q;
  logic [8:0] select_383_s12_q;
  logic and_392_s12_q;
  logic and_393_s12_q;
  logic equal_398_s12_q;
  logic [6:0] column_s12_q;
  logic and_416_s12_q;
  logic and_418_s12_q;
  logic equal_421_s12_q;
  logic so_s12_q;
  logic equal_438_s12_q;
  logic or_439_s12_q;
  logic less_446_s12_q;
  logic not_447_s12_q;
  logic equal_476_s12_q;
  logic equal_479_s12_q;
  logic select_481_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic select_567_s12_q;
  logic [6:0] difference_820_s12_q;
  logic [5:0] column_3_s12_q;
  logic [5:0] column_4_s12_q;
  logic [6:0] sum_1344_s12_q;
  logic and_1369_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic select_1376_s12_q;
  logic equal_1385_s12_q;
  logic and_1392_s12_q;
  logic and_1395_s12_q;
  logic and_1399_s12_q;
  logic less_1400_s12_q;
  logic [6:0] chosen_s12_q;
  logic or_1413_s12_q;
  logic [6:0] select_1424_s12_q;
  logic [1:0] sum_1436_s12_q;
  logic less_1468_s12_q;
  logic equal_1484_s12_q;
  logic [8:0] select_1491_s12_q;
  logic and_1523_s12_q;
  logic less_1543_s12_q;
  logic [7:0] select_1782_s12_q;
  logic [7:0] select_1836_s12_q;
  logic [7:0] select_2125_s12_q;
  logic [7:0] select_2148_s12_q;
  logic [6:0] select_2157_s12_q;
  logic select_2158_s12_q;
  logic equal_2186_s12_q;
  logic and_2323_s12_q;
  logic equal_2511_s12_q;
  logic equal_2565_s12_q;
  logic and_2757_s12_q;
  logic and_2759_s12_q;
  logic less_2865_s12_q;
  logic equal_3062_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
      pixel_0_s12_q <= pixel_0_s11_q;
      pixel_1_s12_q <= pixel_1_s11_q;
      saturated_s12_q <= saturated_s11_q;
      mask_s12_q <= mask_s11_q;
      marks_first_s12_q <= marks_first_s11_q;
      marks_last_s12_q <= marks_last_s11_q;
      sample_pair_first_s12_q <= sample_pair_first_s11_q;
      sample_pair_whole_s12_q <= sample_pair_whole_s11_q;
      sample_present_s12_q <= sample_present_s11_q;
      sample_of_skin_s12_q <= sample_of_skin_s11_q;
      run_shift_s12_q <= run_shift_s11_q;
      x_s12_q <= x_s11_q;
      age_s12_q <= age_s11_q;
      slot_s12_q <= slot_s11_q;
      ends_cell_s12_q <= ends_cell_s11_q;
      lower_half_s12_q <= lower_half_s11_q;
      equal_377_s12_q <= equal_377_s11_q;
      select_383_s12_q <= select_383_s11_q;
      and_392_s12_q <= and_392_s11_q;
      and_393_s12_q <= and_393;
      equal_398_s12_q <= equal_398_s11_q;
      column_s12_q <= column_s11_q;
      and_416_s12_q <= and_416_s11_q;
      and_418_s12_q <= and_418_s11_q;
      equal_421_s12_q <= equal_421_s11_q;
      so_s12_q <= so_s11_q;
      equal_438_s12_q <= equal_438_s11_q;
      or_439_s12_q <= or_439_s11_q;
      less_446_s12_q <= less_446_s11_q;
      not_447_s12_q <= not_447_s11_q;
      equal_476_s12_q <= equal_476_s11_q;
      equal_479_s12_q <= equal_479_s11_q;
      select_481_s12_q <= select_481_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_567_s12_q <= select_567_s11_q;
      difference_820_s12_q <= {1'b0, column_2} - {1'b0, select_819};
      column_3_s12_q <= column_3;
      column_4_s12_q <= column_4;
      sum_1344_s12_q <= {1'b0, before_v} + sum_1343;
      and_1369_s12_q <= and_1369_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_s11_q;
      select_1376_s12_q <= select_1376_s11_q;
      equal_1385_s12_q <= equal_1385_s11_q;
      and_1392_s12_q <= and_1392_s11_q;
      and_1395_s12_q <= and_1395_s11_q;
      and_1399_s12_q <= and_1399_s11_q;
      less_1400_s12_q <= 8'hb6 < best_left_rdata_s11_q[16:9];
      chosen_s12_q <= chosen;
      or_1413_s12_q <= or_1413_s11_q;
      select_1424_s12_q <= select_1424_s11_q;
      sum_1436_s12_q <= sum_1436_s11_q;
      less_1468_s12_q <= less_1468_s11_q;
      equal_1484_s12_q <= equal_1484_s11_q;
      select_1491_s12_q <= select_1491_s11_q;
      and_1523_s12_q <= and_1523_s11_q;
      less_1543_s12_q <= less_1543_s11_q;
      select_1782_s12_q <= select_1782_s11_q;
      select_1836_s12_q <= select_1836_s11_q;
      select_2125_s12_q <= select_2125_s11_q;
      select_2148_s12_q <= select_2148_s11_q;
      select_2157_s12_q <= select_2157_s11_q;
      select_2158_s12_q <= select_2158_s11_q;
      equal_2186_s12_q <= equal_2186_s11_q;
      and_2323_s12_q <= and_2323_s11_q;
      equal_2511_s12_q <= equal_2511_s11_q;
      equal_2565_s12_q <= equal_2565_s11_q;
      and_2757_s12_q <= and_2757_s11_q;
      and_2759_s12_q <= and_2759_s11_q;
      less_2865_s12_q <= less_2865_s11_q;
      equal_3062_s12_q <= equal_3062_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic [7:0] middle_sum_sum_sums_values_0_q;
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
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_1_q;
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
  logic [27:0] registration_slope_change_q;
  // hls/stages/census.hpp:91
  logic [13:0] select_396;
  assign select_396 = equal_377_s12_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_402;
  assign sum_402 = {6'h0, sample_pair_pixel_1_q} + (equal_377_s12_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:213
  logic whole;
  assign whole = equal_377_s12_q ? sample_present_s12_q : (sample_present_s12_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_377_s12_q ? sample_of_skin_s12_q : (sample_of_skin_s12_q & averager_running_of_skin_q);
  // hls/stages/agreement.hpp:586
  logic [7:0] sum_822;
  assign sum_822 = {difference_820_s12_q[6], difference_820_s12_q} + (age_s12_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [5:0] select_1068;
  assign select_1068 = age_s12_q[3] ? sums_0_columns_values_13_q : 6'h0;
  logic [6:0] difference_1069;
  assign difference_1069 = {1'b0, column_3_s12_q} - {1'b0, select_1068};
  // hls/stages/agreement.hpp:556
  logic equal_1070;
  assign equal_1070 = {age_s12_q[0], slot_s12_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:586
  logic [7:0] sum_1072;
  assign sum_1072 = {difference_1069[6], difference_1069} + (equal_1070 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [5:0] select_1317;
  assign select_1317 = age_s12_q[3] ? sums_1_columns_values_13_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v_2;
  assign before_v_2 = age_s12_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1347;
  assign sum_1347 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v_3;
  assign before_v_3 = age_s12_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1350;
  assign sum_1350 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:727
  logic select_1402;
  assign select_1402 = slot_s12_q[2] ? less_1400_s12_q : (6'h2a < best_left_rdata_s12_q[39:34]);
  // hls/stages/agreement.hpp:734
  logic [8:0] difference_1405;
  assign difference_1405 = {2'h0, chosen_s12_q} - {1'b0, x_s12_q};
  // hls/stages/registration.hpp:250
  logic [5:0] select_1754;
  assign select_1754 = select_1491_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [5:0] select_1757;
  assign select_1757 = select_1491_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1761;
  assign select_1761 = select_1491_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1763;
  assign select_1763 = select_1491_s12_q[0] ? middle_sum_columns_values_0_q : {5'h0, lower_half_s12_q};
  logic [5:0] select_1765;
  assign select_1765 = select_1491_s12_q[2] ? (select_1491_s12_q[1] ? select_1754 : select_1757) : (select_1491_s12_q[1] ? select_1761 : select_1763);
  logic select_2123;
  assign select_2123 = select_1491_s12_q[0] ? averager_running_of_skin_q : averager_running_mask_q;
  logic [7:0] select_2142;
  assign select_2142 = select_1491_s12_q[0] ? {2'h0, averager_running_1_q[13:8]} : averager_running_1_q[7:0];
  logic [7:0] select_2145;
  assign select_2145 = select_1491_s12_q[0] ? {2'h0, averager_running_0_q[13:8]} : averager_running_0_q[7:0];
  logic [7:0] select_2159;
  assign select_2159 = select_1491_s12_q[0] ? {7'h0, sample_pair_first_s12_q} : sample_pair_pixel_1_q;
  logic [7:0] select_2163;
  assign select_2163 = select_1491_s12_q[1] ? (select_1491_s12_q[0] ? sample_pair_pixel_0_q : 8'h0) : (select_1491_s12_q[0] ? 8'h0 : left_pixel_q);
  logic [7:0] select_2164;
  assign select_2164 = select_1491_s12_q[2] ? (select_1491_s12_q[1] ? {7'h0, select_2158_s12_q} : select_2159) : select_2163;
  // hls/stages/agreement.hpp:215
  logic select_2378;
  assign select_2378 = sample_pair_whole_s12_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/registration.hpp:122
  logic [15:0] select_2763;
  assign select_2763 = and_2759_s12_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2763[15]}}, select_2763};
  // hls/stages/registration.hpp:124
  logic [27:0] select_2765;
  assign select_2765 = and_2757_s12_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      registration_slope_change_q <= 28'h0;
    end else if (s12_en) begin
      sample_pair_pixel_0_q <= pixel_0_s12_q;
      sample_pair_pixel_1_q <= pixel_1_s12_q;
      averager_running_mask_q <= sample_pair_whole_s12_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2378;
      registration_slope_change_q <= select_2765;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
    averager_running_0_q = 14'h0;
    averager_running_1_q = 14'h0;
    middle_sum_sum_sums_values_0_q = 8'h0;
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
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_1_q = 8'h0;
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
    if (s12_en) begin
      left_pixel_q <= left_pixel_q;
      averager_running_0_q <= sample_pair_whole_s12_q ? select_396 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s12_q ? sum_402 : averager_running_1_q;
      middle_sum_sum_sums_values_0_q <= slot_s12_q[0] ? middle_sum_sum_sums_values_0_q : sum_822;
      sums_0_columns_values_0_q <= column_3_s12_q;
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
      sums_0_sum_sums_values_0_q <= sum_1072;
      sums_0_sum_sums_values_1_q <= equal_1070 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_columns_values_0_q <= column_4_s12_q;
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

  logic saturated_s13_q;
  logic mask_s13_q;
  logic marks_first_s13_q;
  logic marks_last_s13_q;
  logic sample_pair_whole_s13_q;
  logic [5:0] run_shift_s13_q;
  logic [7:0] x_s13_q;
  logic age_s13_q;
  logic [2:0] slot_s13_q;
  logic ends_cell_s13_q;
  logic lower_half_s13_q;
  logic [27:0] registration_slope_change_s13_q;
  logic [8:0] select_383_s13_q;
  logic and_392_s13_q;
  logic and_393_s13_q;
  logic [29:0] averager_memory_rdata_s13_q;
  logic [13:0] select_396_s13_q;
  logic equal_398_s13_q;
  logic [13:0] sum_402_s13_q;
  logic whole_s13_q;
  logic all_of_skin_s13_q;
  logic [6:0] column_s13_q;
  logic and_416_s13_q;
  logic and_418_s13_q;
  logic equal_421_s13_q;
  logic so_s13_q;
  logic equal_438_s13_q;
  logic or_439_s13_q;
  logic less_446_s13_q;
  logic not_447_s13_q;
  logic equal_476_s13_q;
  logic equal_479_s13_q;
  logic select_481_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_567_s13_q;
  logic [7:0] sum_822_s13_q;
  logic equal_1070_s13_q;
  logic [6:0] difference_1318_s13_q;
  logic [6:0] sum_1344_s13_q;
  logic [6:0] sum_1348_s13_q;
  logic [6:0] sum_1351_s13_q;
  logic and_1369_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1376_s13_q;
  logic equal_1385_s13_q;
  logic and_1392_s13_q;
  logic and_1395_s13_q;
  logic and_1399_s13_q;
  logic select_1402_s13_q;
  logic [9:0] sum_1406_s13_q;
  logic or_1413_s13_q;
  logic [6:0] select_1424_s13_q;
  logic [1:0] sum_1436_s13_q;
  logic less_1468_s13_q;
  logic equal_1484_s13_q;
  logic [8:0] select_1491_s13_q;
  logic and_1523_s13_q;
  logic less_1543_s13_q;
  logic less_1631_s13_q;
  logic [5:0] select_1765_s13_q;
  logic [7:0] select_1782_s13_q;
  logic [7:0] select_1836_s13_q;
  logic select_2123_s13_q;
  logic [7:0] select_2125_s13_q;
  logic [7:0] select_2142_s13_q;
  logic [7:0] select_2149_s13_q;
  logic [7:0] select_2165_s13_q;
  logic equal_2186_s13_q;
  logic and_2323_s13_q;
  logic equal_2511_s13_q;
  logic equal_2565_s13_q;
  logic and_2757_s13_q;
  logic and_2759_s13_q;
  logic less_2865_s13_q;
  logic equal_3062_s13_q;
  always_ff @(posedge clk_i) begin
    if (s12_en) begin
      saturated_s13_q <= saturated_s12_q;
      mask_s13_q <= mask_s12_q;
      marks_first_s13_q <= marks_first_s12_q;
      marks_last_s13_q <= marks_last_s12_q;
      sample_pair_whole_s13_q <= sample_pair_whole_s12_q;
      run_shift_s13_q <= run_shift_s12_q;
      x_s13_q <= x_s12_q;
      age_s13_q <= age_s12_q[2];
      slot_s13_q <= slot_s12_q;
      ends_cell_s13_q <= ends_cell_s12_q;
      lower_half_s13_q <= lower_half_s12_q;
      registration_slope_change_s13_q <= registration_slope_change_q;
      select_383_s13_q <= select_383_s12_q;
      and_392_s13_q <= and_392_s12_q;
      and_393_s13_q <= and_393_s12_q;
      averager_memory_rdata_s13_q <= averager_memory_rdata_q;
      select_396_s13_q <= select_396;
      equal_398_s13_q <= equal_398_s12_q;
      sum_402_s13_q <= sum_402;
      whole_s13_q <= whole;
      all_of_skin_s13_q <= all_of_skin;
      column_s13_q <= column_s12_q;
      and_416_s13_q <= and_416_s12_q;
      and_418_s13_q <= and_418_s12_q;
      equal_421_s13_q <= equal_421_s12_q;
      so_s13_q <= so_s12_q;
      equal_438_s13_q <= equal_438_s12_q;
      or_439_s13_q <= or_439_s12_q;
      less_446_s13_q <= less_446_s12_q;
      not_447_s13_q <= not_447_s12_q;
      equal_476_s13_q <= equal_476_s12_q;
      equal_479_s13_q <= equal_479_s12_q;
      select_481_s13_q <= select_481_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_567_s13_q <= select_567_s12_q;
      sum_822_s13_q <= sum_822;
      equal_1070_s13_q <= equal_1070;
      difference_1318_s13_q <= {1'b0, column_4_s12_q} - {1'b0, select_1317};
      sum_1344_s13_q <= sum_1344_s12_q;
      sum_1348_s13_q <= {1'b0, before_v_2} + sum_1347;
      sum_1351_s13_q <= {1'b0, before_v_3} + sum_1350;
      and_1369_s13_q <= and_1369_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1376_s13_q <= select_1376_s12_q;
      equal_1385_s13_q <= equal_1385_s12_q;
      and_1392_s13_q <= and_1392_s12_q;
      and_1395_s13_q <= and_1395_s12_q;
      and_1399_s13_q <= and_1399_s12_q;
      select_1402_s13_q <= select_1402;
      sum_1406_s13_q <= {difference_1405[8], difference_1405} + 10'h1;
      or_1413_s13_q <= or_1413_s12_q;
      select_1424_s13_q <= select_1424_s12_q;
      sum_1436_s13_q <= sum_1436_s12_q;
      less_1468_s13_q <= less_1468_s12_q;
      equal_1484_s13_q <= equal_1484_s12_q;
      select_1491_s13_q <= select_1491_s12_q;
      and_1523_s13_q <= and_1523_s12_q;
      less_1543_s13_q <= less_1543_s12_q;
      less_1631_s13_q <= $signed(registration_slope_change_q[27:18]) < $signed(10'h3ff);
      select_1765_s13_q <= select_1765;
      select_1782_s13_q <= select_1782_s12_q;
      select_1836_s13_q <= select_1836_s12_q;
      select_2123_s13_q <= select_2123;
      select_2125_s13_q <= select_2125_s12_q;
      select_2142_s13_q <= select_2142;
      select_2149_s13_q <= select_1491_s12_q[2] ? select_2145 : select_2148_s12_q;
      select_2165_s13_q <= select_1491_s12_q[3] ? {1'b0, select_2157_s12_q} : select_2164;
      equal_2186_s13_q <= equal_2186_s12_q;
      and_2323_s13_q <= and_2323_s12_q;
      equal_2511_s13_q <= equal_2511_s12_q;
      equal_2565_s13_q <= equal_2565_s12_q;
      and_2757_s13_q <= and_2757_s12_q;
      and_2759_s13_q <= and_2759_s12_q;
      less_2865_s13_q <= less_2865_s12_q;
      equal_3062_s13_q <= equal_3062_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_1_sum_sums_values_1_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_q;
  // hls/stages/census.hpp:100
  logic [13:0] sum_400;
  assign sum_400 = select_396_s13_q + (equal_398_s13_q ? 14'h0 : averager_memory_rdata_s13_q[13:0]);
  logic [13:0] sum_404;
  assign sum_404 = sum_402_s13_q + (equal_398_s13_q ? 14'h0 : averager_memory_rdata_s13_q[27:14]);
  // hls/stages/census.hpp:101
  logic and_408;
  assign and_408 = whole_s13_q & (averager_memory_rdata_s13_q[28] | equal_398_s13_q);
  // hls/stages/census.hpp:102
  logic and_412;
  assign and_412 = all_of_skin_s13_q & (averager_memory_rdata_s13_q[29] | equal_398_s13_q);
  // hls/stages/agreement.hpp:586
  logic [7:0] sum_1320;
  assign sum_1320 = {difference_1318_s13_q[6], difference_1318_s13_q} + (equal_1070_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1353;
  assign select_1353 = (sum_1348_s13_q < sum_1351_s13_q) ? sum_1351_s13_q : sum_1348_s13_q;
  // hls/stages/agreement.hpp:182
  logic and_1408;
  assign and_1408 = (and_1395_s13_q & select_1402_s13_q) & ({{22{sum_1406_s13_q[9]}}, sum_1406_s13_q} < 32'h3);
  // hls/stages/agreement.hpp:191
  logic [7:0] select_1550;
  assign select_1550 = or_439_s13_q ? (less_446_s13_q ? 8'h0 : best_left_rdata_s13_q[32:25]) : 8'h0;
  logic [7:0] select_1552;
  assign select_1552 = or_439_s13_q ? (less_446_s13_q ? 8'h0 : best_left_rdata_s13_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1611;
  assign select_1611 = select_1491_s13_q[0] ? {{4{registration_slope_q[27]}}, registration_slope_q[27:24]} : registration_slope_q[23:16];
  logic [7:0] select_1612;
  assign select_1612 = select_1491_s13_q[0] ? registration_slope_q[15:8] : registration_slope_q[7:0];
  logic [7:0] select_1614;
  assign select_1614 = select_1491_s13_q[0] ? {{4{registration_slope_change_s13_q[27]}}, registration_slope_change_s13_q[27:24]} : registration_slope_change_s13_q[23:16];
  logic [7:0] select_1615;
  assign select_1615 = select_1491_s13_q[0] ? registration_slope_change_s13_q[15:8] : registration_slope_change_s13_q[7:0];
  logic [7:0] select_1617;
  assign select_1617 = select_1491_s13_q[2] ? (select_1491_s13_q[1] ? select_1611 : select_1612) : (select_1491_s13_q[1] ? select_1614 : select_1615);
  logic [7:0] select_1618;
  assign select_1618 = select_1491_s13_q[0] ? {{4{registration_slope_row_q[23]}}, registration_slope_row_q[23:20]} : registration_slope_row_q[19:12];
  logic [7:0] select_1619;
  assign select_1619 = select_1491_s13_q[0] ? registration_slope_row_q[11:4] : {registration_slope_row_q[3:0], 4'h0};
  // hls/stages/registration.hpp:206
  logic [16:0] select_1632;
  assign select_1632 = less_1631_s13_q ? 17'h1ff80 : registration_slope_change_s13_q[27:11];
  logic [13:0] select_1634;
  assign select_1634 = ($signed(10'h0) < $signed(select_1632[16:7])) ? 14'h7f : select_1632[13:0];
  // hls/stages/registration.hpp:250
  logic [7:0] select_1718;
  assign select_1718 = select_1491_s13_q[0] ? sum_1320 : {2'h0, sums_1_columns_values_13_q};
  logic [5:0] select_1719;
  assign select_1719 = select_1491_s13_q[0] ? sums_1_columns_values_12_q : sums_1_columns_values_11_q;
  logic [5:0] select_1721;
  assign select_1721 = select_1491_s13_q[0] ? sums_1_columns_values_10_q : sums_1_columns_values_9_q;
  logic [5:0] select_1722;
  assign select_1722 = select_1491_s13_q[0] ? sums_1_columns_values_8_q : sums_1_columns_values_7_q;
  logic [5:0] select_1726;
  assign select_1726 = select_1491_s13_q[0] ? sums_1_columns_values_6_q : sums_1_columns_values_5_q;
  logic [5:0] select_1727;
  assign select_1727 = select_1491_s13_q[0] ? sums_1_columns_values_4_q : sums_1_columns_values_3_q;
  logic [5:0] select_1728;
  assign select_1728 = select_1491_s13_q[1] ? select_1726 : select_1727;
  logic [5:0] select_1729;
  assign select_1729 = select_1491_s13_q[0] ? sums_1_columns_values_2_q : sums_1_columns_values_1_q;
  logic [7:0] select_1731;
  assign select_1731 = select_1491_s13_q[0] ? {2'h0, sums_1_columns_values_0_q} : sums_0_sum_sums_values_1_q;
  logic [7:0] select_1733;
  assign select_1733 = select_1491_s13_q[2] ? {2'h0, select_1728} : (select_1491_s13_q[1] ? {2'h0, select_1729} : select_1731);
  logic [7:0] select_1734;
  assign select_1734 = select_1491_s13_q[0] ? sums_0_sum_sums_values_0_q : {2'h0, sums_0_columns_values_13_q};
  logic [5:0] select_1735;
  assign select_1735 = select_1491_s13_q[0] ? sums_0_columns_values_12_q : sums_0_columns_values_11_q;
  logic [5:0] select_1737;
  assign select_1737 = select_1491_s13_q[0] ? sums_0_columns_values_10_q : sums_0_columns_values_9_q;
  logic [5:0] select_1738;
  assign select_1738 = select_1491_s13_q[0] ? sums_0_columns_values_8_q : sums_0_columns_values_7_q;
  logic [5:0] select_1739;
  assign select_1739 = select_1491_s13_q[1] ? select_1737 : select_1738;
  logic [7:0] select_1740;
  assign select_1740 = select_1491_s13_q[2] ? (select_1491_s13_q[1] ? select_1734 : {2'h0, select_1735}) : {2'h0, select_1739};
  logic [5:0] select_1744;
  assign select_1744 = select_1491_s13_q[0] ? sums_0_columns_values_6_q : sums_0_columns_values_5_q;
  logic [5:0] select_1745;
  assign select_1745 = select_1491_s13_q[0] ? sums_0_columns_values_4_q : sums_0_columns_values_3_q;
  logic [5:0] select_1746;
  assign select_1746 = select_1491_s13_q[1] ? select_1744 : select_1745;
  logic [5:0] select_1747;
  assign select_1747 = select_1491_s13_q[0] ? sums_0_columns_values_2_q : sums_0_columns_values_1_q;
  logic [7:0] select_1749;
  assign select_1749 = select_1491_s13_q[0] ? {2'h0, sums_0_columns_values_0_q} : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1751;
  assign select_1751 = select_1491_s13_q[2] ? {2'h0, select_1746} : (select_1491_s13_q[1] ? {2'h0, select_1747} : select_1749);
  logic [7:0] select_1783;
  assign select_1783 = select_1491_s13_q[4] ? (select_1491_s13_q[3] ? select_1751 : {2'h0, select_1765_s13_q}) : select_1782_s13_q;
  // hls/stages/registration.hpp:121
  logic [15:0] select_2760;
  assign select_2760 = and_2759_s13_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:124
  logic [23:0] select_2762;
  assign select_2762 = and_2757_s13_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2760[15]}}, select_2760});
  // hls/stages/registration.hpp:117
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_1523_s13_q ? registration_slope_change_s13_q : 28'h0);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_slope_row_q <= 24'h0;
      registration_slope_q <= 28'h0;
    end else if (s13_en) begin
      registration_slope_row_q <= select_2762;
      registration_slope_q <= so_s13_q ? column_5 : {registration_slope_row_q, 4'h0};
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_1_sum_sums_values_1_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s13_en) begin
      sums_1_sum_sums_values_0_q <= sum_1320;
      sums_1_sum_sums_values_1_q <= equal_1070_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic age_s14_q;
  logic [2:0] slot_s14_q;
  logic ends_cell_s14_q;
  logic lower_half_s14_q;
  logic [11:0] registration_slope_s14_q;
  logic [8:0] select_383_s14_q;
  logic and_392_s14_q;
  logic and_393_s14_q;
  logic [13:0] sum_400_s14_q;
  logic [13:0] sum_404_s14_q;
  logic and_408_s14_q;
  logic and_412_s14_q;
  logic [6:0] column_s14_q;
  logic and_416_s14_q;
  logic and_418_s14_q;
  logic equal_421_s14_q;
  logic so_s14_q;
  logic equal_438_s14_q;
  logic or_439_s14_q;
  logic less_446_s14_q;
  logic not_447_s14_q;
  logic equal_476_s14_q;
  logic equal_479_s14_q;
  logic select_481_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_567_s14_q;
  logic [7:0] sum_822_s14_q;
  logic [7:0] sum_1072_s14_q;
  logic less_1321_s14_q;
  logic [6:0] sum_1344_s14_q;
  logic [6:0] select_1353_s14_q;
  logic and_1369_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1376_s14_q;
  logic equal_1385_s14_q;
  logic and_1392_s14_q;
  logic and_1396_s14_q;
  logic and_1399_s14_q;
  logic and_1409_s14_q;
  logic and_1414_s14_q;
  logic [8:0] select_1416_s14_q;
  logic [6:0] select_1424_s14_q;
  logic [1:0] sum_1436_s14_q;
  logic less_1468_s14_q;
  logic equal_1484_s14_q;
  logic [8:0] select_1491_s14_q;
  logic and_1523_s14_q;
  logic less_1543_s14_q;
  logic [7:0] select_1550_s14_q;
  logic [7:0] select_1552_s14_q;
  logic [7:0] select_1617_s14_q;
  logic [7:0] select_1620_s14_q;
  logic [13:0] select_1634_s14_q;
  logic [7:0] select_1720_s14_q;
  logic [5:0] select_1723_s14_q;
  logic [7:0] select_1741_s14_q;
  logic [7:0] select_1783_s14_q;
  logic [7:0] select_1836_s14_q;
  logic select_2123_s14_q;
  logic [7:0] select_2125_s14_q;
  logic [7:0] select_2142_s14_q;
  logic [7:0] select_2149_s14_q;
  logic [7:0] select_2165_s14_q;
  logic equal_2186_s14_q;
  logic and_2323_s14_q;
  logic equal_2511_s14_q;
  logic equal_2565_s14_q;
  logic less_2865_s14_q;
  logic equal_3062_s14_q;
  always_ff @(posedge clk_i) begin
    if (s13_en) begin
      pixel_0_s14_q <= sample_pair_pixel_0_q;
      pixel_1_s14_q <= sample_pair_pixel_1_q;
      saturated_s14_q <= saturated_s13_q;
      mask_s14_q <= mask_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      sample_pair_whole_s14_q <= sample_pair_whole_s13_q;
      run_shift_s14_q <= run_shift_s13_q;
      x_s14_q <= x_s13_q;
      age_s14_q <= age_s13_q;
      slot_s14_q <= slot_s13_q;
      ends_cell_s14_q <= ends_cell_s13_q;
      lower_half_s14_q <= lower_half_s13_q;
      registration_slope_s14_q <= registration_slope_q[27:16];
      select_383_s14_q <= select_383_s13_q;
      and_392_s14_q <= and_392_s13_q;
      and_393_s14_q <= and_393_s13_q;
      sum_400_s14_q <= sum_400;
      sum_404_s14_q <= sum_404;
      and_408_s14_q <= and_408;
      and_412_s14_q <= and_412;
      column_s14_q <= column_s13_q;
      and_416_s14_q <= and_416_s13_q;
      and_418_s14_q <= and_418_s13_q;
      equal_421_s14_q <= equal_421_s13_q;
      so_s14_q <= so_s13_q;
      equal_438_s14_q <= equal_438_s13_q;
      or_439_s14_q <= or_439_s13_q;
      less_446_s14_q <= less_446_s13_q;
      not_447_s14_q <= not_447_s13_q;
      equal_476_s14_q <= equal_476_s13_q;
      equal_479_s14_q <= equal_479_s13_q;
      select_481_s14_q <= select_481_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_567_s14_q <= select_567_s13_q;
      sum_822_s14_q <= sum_822_s13_q;
      sum_1072_s14_q <= sums_0_sum_sums_values_0_q;
      less_1321_s14_q <= sums_0_sum_sums_values_0_q < sum_1320;
      sum_1344_s14_q <= sum_1344_s13_q;
      select_1353_s14_q <= select_1353;
      and_1369_s14_q <= and_1369_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1376_s14_q <= select_1376_s13_q;
      equal_1385_s14_q <= equal_1385_s13_q;
      and_1392_s14_q <= and_1392_s13_q;
      and_1396_s14_q <= not_447_s13_q & and_1395_s13_q;
      and_1399_s14_q <= and_1399_s13_q;
      and_1409_s14_q <= not_447_s13_q & and_1408;
      and_1414_s14_q <= and_1408 & or_1413_s13_q;
      select_1416_s14_q <= less_446_s13_q ? 9'h0 : best_left_rdata_s13_q[8:0];
      select_1424_s14_q <= select_1424_s13_q;
      sum_1436_s14_q <= sum_1436_s13_q;
      less_1468_s14_q <= less_1468_s13_q;
      equal_1484_s14_q <= equal_1484_s13_q;
      select_1491_s14_q <= select_1491_s13_q;
      and_1523_s14_q <= and_1523_s13_q;
      less_1543_s14_q <= less_1543_s13_q;
      select_1550_s14_q <= select_1550;
      select_1552_s14_q <= select_1552;
      select_1617_s14_q <= select_1617;
      select_1620_s14_q <= select_1491_s13_q[1] ? select_1618 : select_1619;
      select_1634_s14_q <= select_1634;
      select_1720_s14_q <= select_1491_s13_q[1] ? select_1718 : {2'h0, select_1719};
      select_1723_s14_q <= select_1491_s13_q[1] ? select_1721 : select_1722;
      select_1741_s14_q <= select_1491_s13_q[3] ? select_1733 : select_1740;
      select_1783_s14_q <= select_1783;
      select_1836_s14_q <= select_1836_s13_q;
      select_2123_s14_q <= select_2123_s13_q;
      select_2125_s14_q <= select_2125_s13_q;
      select_2142_s14_q <= select_2142_s13_q;
      select_2149_s14_q <= select_2149_s13_q;
      select_2165_s14_q <= select_2165_s13_q;
      equal_2186_s14_q <= equal_2186_s13_q;
      and_2323_s14_q <= and_2323_s13_q;
      equal_2511_s14_q <= equal_2511_s13_q;
      equal_2565_s14_q <= equal_2565_s13_q;
      less_2865_s14_q <= less_2865_s13_q;
      equal_3062_s14_q <= equal_3062_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [7:0] chosen_score_q;
  logic [6:0] chosen_near_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_392_s14_q ? sum_400_s14_q[13:5] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_392_s14_q ? sum_404_s14_q[13:5] : 9'h0;
  logic and_429;
  assign and_429 = and_392_s14_q & and_408_s14_q;
  // hls/stages/census.hpp:105
  logic select_431;
  assign select_431 = equal_421_s14_q ? and_429 : (averager_mask_q & and_429);
  // hls/stages/agreement.hpp:215
  logic whole_2;
  assign whole_2 = sample_pair_whole_s14_q & select_431;
  // hls/stages/census.hpp:126
  logic and_433;
  assign and_433 = and_392_s14_q & and_412_s14_q;
  // hls/stages/census.hpp:105
  logic select_435;
  assign select_435 = equal_421_s14_q ? and_433 : (averager_of_skin_q & and_433);
  // hls/stages/agreement.hpp:596
  logic less_568;
  assign less_568 = $signed(run_shift_s14_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_570;
  assign less_570 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s14_q);
  // hls/stages/agreement.hpp:562
  logic [7:0] select_823;
  assign select_823 = slot_s14_q[0] ? chosen_score_q : sum_822_s14_q;
  // hls/stages/agreement.hpp:558
  logic [7:0] select_1322;
  assign select_1322 = less_1321_s14_q ? sums_1_sum_sums_values_0_q : sum_1072_s14_q;
  logic less_1323;
  assign less_1323 = select_823 < select_1322;
  // hls/stages/agreement.hpp:527
  logic not_1329;
  assign not_1329 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:559
  logic [1:0] select_1330;
  assign select_1330 = less_1321_s14_q ? {slot_s14_q[0], not_1329} : 2'h0;
  logic [2:0] select_1332;
  assign select_1332 = less_1323 ? {select_1330, not_1329} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:562
  logic [6:0] select_1345;
  assign select_1345 = slot_s14_q[0] ? chosen_near_q : sum_1344_s14_q;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1355;
  assign select_1355 = (select_1345 < select_1353_s14_q) ? select_1353_s14_q : select_1345;
  // hls/stages/agreement.hpp:182
  logic and_1415;
  assign and_1415 = not_447_s14_q & and_1414_s14_q;
  // hls/stages/agreement.hpp:191
  logic [14:0] inside_v;
  assign inside_v = or_439_s14_q ? {select_1416_s14_q, and_1415, and_1409_s14_q, and_1399_s14_q, and_1396_s14_q, and_1392_s14_q, not_447_s14_q} : 15'h0;
  // hls/stages/agreement.hpp:197
  logic right_2;
  assign right_2 = inside_v[0] & less_1468_s14_q;
  // hls/stages/registration.hpp:201
  logic [9:0] select_1635;
  assign select_1635 = inside_v[10] ? select_1634_s14_q[9:0] : 10'h0;
  logic [8:0] difference_1637;
  assign difference_1637 = select_1635[9:1] - (inside_v[11] ? select_1634_s14_q[8:0] : 9'h0);
  // hls/stages/registration.hpp:199
  logic [12:0] sum_1640;
  assign sum_1640 = (inside_v[6] ? select_1634_s14_q[13:1] : 13'h0) + (inside_v[7] ? select_1634_s14_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:200
  logic [11:0] select_1641;
  assign select_1641 = inside_v[8] ? select_1634_s14_q[11:0] : 12'h0;
  logic [10:0] sum_1643;
  assign sum_1643 = select_1641[11:1] + (inside_v[9] ? select_1634_s14_q[10:0] : 11'h0);
  // hls/stages/agreement.hpp:191
  logic [7:0] select_1655;
  assign select_1655 = or_439_s14_q ? (less_446_s14_q ? 8'h0 : best_left_rdata_s14_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_1550_s14_q} - {1'b0, select_1552_s14_q};
  // hls/stages/agreement.hpp:174
  logic [7:0] select_1704;
  assign select_1704 = slot_s14_q[0] ? 8'h0 : sum_822_s14_q;
  // hls/stages/agreement.hpp:558
  logic less_1707;
  assign less_1707 = select_1704 < select_1322;
  // hls/stages/agreement.hpp:174
  logic [6:0] select_1709;
  assign select_1709 = slot_s14_q[0] ? 7'h0 : sum_1344_s14_q;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1711;
  assign select_1711 = (select_1709 < select_1353_s14_q) ? select_1353_s14_q : select_1709;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1724;
  assign select_1724 = select_1491_s14_q[2] ? select_1720_s14_q : {2'h0, select_1723_s14_q};
  logic select_2124;
  assign select_2124 = select_1491_s14_q[1] ? (select_1491_s14_q[0] ? averager_of_skin_q : averager_mask_q) : select_2123_s14_q;
  // hls/stages/agreement.hpp:197
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:215
  logic select_2380;
  assign select_2380 = sample_pair_whole_s14_q ? (and_416_s14_q ? select_431 : averager_mask_q) : averager_mask_q;
  logic select_2382;
  assign select_2382 = sample_pair_whole_s14_q ? (and_416_s14_q ? select_435 : averager_of_skin_q) : averager_of_skin_q;

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_383_s14_q;
  logic averager_memory_we;
  assign averager_memory_we = s14_en & and_393_s14_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_412_s14_q, and_408_s14_q, sum_404_s14_q, sum_400_s14_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s12_sim;
  logic averager_memory_re_s12_sim;
  logic [8:0] averager_memory_raddr_s13_sim;
  logic averager_memory_re_s13_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s12_sim <= 1'b0;
      averager_memory_re_s13_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s12_sim <= averager_memory_re;
      averager_memory_raddr_s12_sim <= averager_memory_raddr;
      averager_memory_re_s13_sim <= averager_memory_re_s12_sim;
      averager_memory_raddr_s13_sim <= averager_memory_raddr_s12_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s12_sim && averager_memory_raddr_s12_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s13_sim && averager_memory_raddr_s13_sim == averager_memory_waddr) begin
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
      averager_of_skin_q <= 1'b0;
      chosen_score_q <= 8'h0;
      chosen_near_q <= 7'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
    end else if (s14_en) begin
      averager_mask_q <= select_2380;
      averager_of_skin_q <= select_2382;
      chosen_score_q <= less_1707 ? select_1322 : select_1704;
      chosen_near_q <= select_1711;
      chosen_place_q <= less_1707 ? {select_1330, not_1329} : 3'h2;
      before_0_q <= select_1704;
      before_1_q <= sum_1072_s14_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
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
  logic [2:0] slot_s15_q;
  logic ends_cell_s15_q;
  logic lower_half_s15_q;
  logic [7:0] before_0_s15_q;
  logic [7:0] before_1_s15_q;
  logic [7:0] before_2_s15_q;
  logic [11:0] registration_slope_s15_q;
  logic [6:0] column_s15_q;
  logic and_416_s15_q;
  logic and_418_s15_q;
  logic [8:0] grey_s15_q;
  logic equal_421_s15_q;
  logic [8:0] grey_2_s15_q;
  logic whole_2_s15_q;
  logic and_436_s15_q;
  logic so_s15_q;
  logic equal_476_s15_q;
  logic equal_479_s15_q;
  logic select_481_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_567_s15_q;
  logic and_572_s15_q;
  logic [7:0] select_1324_s15_q;
  logic [2:0] select_1332_s15_q;
  logic [6:0] select_1355_s15_q;
  logic and_1369_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1376_s15_q;
  logic equal_1385_s15_q;
  logic [13:0] inside_v_s15_q;
  logic [6:0] select_1424_s15_q;
  logic and_1427_s15_q;
  logic [1:0] sum_1436_s15_q;
  logic right_2_s15_q;
  logic equal_1484_s15_q;
  logic [8:0] select_1491_s15_q;
  logic and_1523_s15_q;
  logic and_1544_s15_q;
  logic less_1553_s15_q;
  logic [7:0] select_1617_s15_q;
  logic [7:0] select_1620_s15_q;
  logic select_1635_s15_q;
  logic [8:0] difference_1637_s15_q;
  logic [11:0] sum_1640_s15_q;
  logic select_1641_s15_q;
  logic [10:0] sum_1643_s15_q;
  logic [7:0] select_1655_s15_q;
  logic rise_s15_q;
  logic [7:0] select_1657_s15_q;
  logic [7:0] xor_1662_s15_q;
  logic [7:0] select_1714_s15_q;
  logic [7:0] select_1724_s15_q;
  logic [7:0] select_1741_s15_q;
  logic [7:0] select_1783_s15_q;
  logic [7:0] select_1836_s15_q;
  logic select_2124_s15_q;
  logic [7:0] select_2125_s15_q;
  logic [7:0] select_2142_s15_q;
  logic [7:0] select_2149_s15_q;
  logic [7:0] select_2165_s15_q;
  logic equal_2186_s15_q;
  logic textured_s15_q;
  logic and_2323_s15_q;
  logic equal_2511_s15_q;
  logic equal_2565_s15_q;
  logic less_2865_s15_q;
  logic equal_3062_s15_q;
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
      slot_s15_q <= slot_s14_q;
      ends_cell_s15_q <= ends_cell_s14_q;
      lower_half_s15_q <= lower_half_s14_q;
      before_0_s15_q <= before_0_q;
      before_1_s15_q <= before_1_q;
      before_2_s15_q <= before_2_q;
      registration_slope_s15_q <= registration_slope_s14_q;
      column_s15_q <= column_s14_q;
      and_416_s15_q <= and_416_s14_q;
      and_418_s15_q <= and_418_s14_q;
      grey_s15_q <= grey;
      equal_421_s15_q <= equal_421_s14_q;
      grey_2_s15_q <= grey_2;
      whole_2_s15_q <= whole_2;
      and_436_s15_q <= sample_pair_whole_s14_q & select_435;
      so_s15_q <= so_s14_q;
      equal_476_s15_q <= equal_476_s14_q;
      equal_479_s15_q <= equal_479_s14_q;
      select_481_s15_q <= select_481_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_567_s15_q <= select_567_s14_q;
      and_572_s15_q <= (~less_568) & (~less_570);
      select_1324_s15_q <= less_1323 ? select_1322 : select_823;
      select_1332_s15_q <= select_1332;
      select_1355_s15_q <= select_1355;
      and_1369_s15_q <= and_1369_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1376_s15_q <= select_1376_s14_q;
      equal_1385_s15_q <= equal_1385_s14_q;
      inside_v_s15_q <= {inside_v[14:3], inside_v[1:0]};
      select_1424_s15_q <= select_1424_s14_q;
      and_1427_s15_q <= equal_438_s14_q & inside_v[4];
      sum_1436_s15_q <= sum_1436_s14_q;
      right_2_s15_q <= right_2;
      equal_1484_s15_q <= equal_1484_s14_q;
      select_1491_s15_q <= select_1491_s14_q;
      and_1523_s15_q <= and_1523_s14_q;
      and_1544_s15_q <= inside_v[4] & less_1543_s14_q;
      less_1553_s15_q <= select_1550_s14_q < select_1552_s14_q;
      select_1617_s15_q <= select_1617_s14_q;
      select_1620_s15_q <= select_1620_s14_q;
      select_1635_s15_q <= select_1635[0];
      difference_1637_s15_q <= difference_1637;
      sum_1640_s15_q <= sum_1640[12:1];
      select_1641_s15_q <= select_1641[0];
      sum_1643_s15_q <= sum_1643;
      select_1655_s15_q <= select_1655;
      rise_s15_q <= rise[8];
      select_1657_s15_q <= rise[8] ? select_1550_s14_q : select_1552_s14_q;
      xor_1662_s15_q <= rise[7:0] ^ {8{rise[8]}};
      select_1714_s15_q <= sums_1_sum_sums_values_1_q;
      select_1724_s15_q <= select_1724;
      select_1741_s15_q <= select_1741_s14_q;
      select_1783_s15_q <= select_1783_s14_q;
      select_1836_s15_q <= select_1836_s14_q;
      select_2124_s15_q <= select_2124;
      select_2125_s15_q <= select_2125_s14_q;
      select_2142_s15_q <= select_2142_s14_q;
      select_2149_s15_q <= select_2149_s14_q;
      select_2165_s15_q <= select_2165_s14_q;
      equal_2186_s15_q <= equal_2186_s14_q;
      textured_s15_q <= textured;
      and_2323_s15_q <= and_2323_s14_q;
      equal_2511_s15_q <= equal_2511_s14_q;
      equal_2565_s15_q <= equal_2565_s14_q;
      less_2865_s15_q <= less_2865_s14_q;
      equal_3062_s15_q <= equal_3062_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_quarter_1_0_q;
  logic [8:0] averager_quarter_1_1_q;
  logic [8:0] averager_quarter_2_0_q;
  logic [8:0] averager_quarter_2_1_q;
  logic [10:0] averager_total_0_q;
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey_s15_q} + (equal_421_s15_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:600
  logic [7:0] of_best;
  assign of_best = and_572_s15_q ? select_1324_s15_q : 8'h0;
  // hls/stages/agreement.hpp:609
  logic equal_1335;
  assign equal_1335 = select_1332_s15_q == 3'h1;
  logic equal_1336;
  assign equal_1336 = select_1332_s15_q == 3'h2;
  logic not_1337;
  assign not_1337 = ~equal_1336;
  logic [2:0] select_1338;
  assign select_1338 = equal_1335 ? 3'h2 : {not_1337, {2{equal_1336}}};
  logic [7:0] select_1340;
  assign select_1340 = select_1338[1] ? before_2_q : (select_1338[0] ? before_2_s15_q : before_0_s15_q);
  logic [6:0] select_1356;
  assign select_1356 = select_1338[0] ? {4'h0, select_1332_s15_q} : select_1355_s15_q;
  logic [7:0] select_1357;
  assign select_1357 = select_1338[1] ? (select_1338[0] ? before_1_s15_q : before_1_q) : {1'b0, select_1356};
  // hls/stages/agreement.hpp:610
  logic [1:0] select_1360;
  assign select_1360 = equal_1335 ? 2'h0 : {not_1337, equal_1336};
  logic [7:0] select_1362;
  assign select_1362 = select_1360[1] ? before_2_q : (select_1360[0] ? before_2_s15_q : before_0_s15_q);
  // hls/stages/agreement.hpp:601
  logic [6:0] of_near;
  assign of_near = and_572_s15_q ? select_1355_s15_q : 7'h0;
  // hls/stages/agreement.hpp:747
  logic not_1386;
  assign not_1386 = ~equal_1385_s15_q;
  // hls/stages/agreement.hpp:211
  logic and_1418;
  assign and_1418 = ends_cell_s15_q & inside_v_s15_q[0];
  logic and_1420;
  assign and_1420 = not_1386 & (so_s15_q & and_1418);
  // hls/stages/registration.hpp:202
  logic [11:0] sum_1644;
  assign sum_1644 = sum_1640_s15_q + {sum_1643_s15_q, select_1641_s15_q};
  logic [9:0] sum_1645;
  assign sum_1645 = {difference_1637_s15_q, select_1635_s15_q} + sum_1644[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] difference_1658;
  assign difference_1658 = {1'b0, select_1655_s15_q} - {1'b0, select_1657_s15_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_1658[8] ? 8'h0 : difference_1658[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size;
  assign size = {8'h0, rise_s15_q} + {1'b0, xor_1662_s15_q};
  // hls/stages/registration.hpp:250
  logic [7:0] select_1696;
  assign select_1696 = select_1491_s15_q[1] ? before_2_q : (select_1491_s15_q[0] ? before_2_s15_q : before_0_s15_q);
  logic [6:0] select_1698;
  assign select_1698 = select_1491_s15_q[0] ? {4'h0, select_1332_s15_q} : select_1355_s15_q;
  logic [7:0] select_1699;
  assign select_1699 = select_1491_s15_q[1] ? (select_1491_s15_q[0] ? before_1_s15_q : before_1_q) : {1'b0, select_1698};
  logic [7:0] select_1706;
  assign select_1706 = select_1491_s15_q[1] ? (select_1491_s15_q[0] ? select_1324_s15_q : before_2_q) : (select_1491_s15_q[0] ? before_1_q : before_0_q);
  logic [6:0] select_1712;
  assign select_1712 = select_1491_s15_q[0] ? {4'h0, chosen_place_q} : chosen_near_q;
  logic [7:0] select_1716;
  assign select_1716 = select_1491_s15_q[1] ? {1'b0, select_1712} : (select_1491_s15_q[0] ? chosen_score_q : select_1714_s15_q);
  logic [7:0] select_1725;
  assign select_1725 = select_1491_s15_q[3] ? (select_1491_s15_q[2] ? select_1706 : select_1716) : select_1724_s15_q;
  logic [7:0] select_2132;
  assign select_2132 = select_1491_s15_q[0] ? {5'h0, averager_total_0_q[10:8]} : averager_total_0_q[7:0];
  logic [7:0] select_2133;
  assign select_2133 = select_1491_s15_q[0] ? {7'h0, averager_quarter_2_1_q[8]} : averager_quarter_2_1_q[7:0];
  logic [7:0] select_2138;
  assign select_2138 = select_1491_s15_q[0] ? {7'h0, averager_quarter_2_0_q[8]} : averager_quarter_2_0_q[7:0];
  logic [7:0] select_2139;
  assign select_2139 = select_1491_s15_q[0] ? {7'h0, averager_quarter_1_1_q[8]} : averager_quarter_1_1_q[7:0];
  logic [7:0] select_2141;
  assign select_2141 = select_1491_s15_q[0] ? {7'h0, averager_quarter_1_0_q[8]} : averager_quarter_1_0_q[7:0];
  logic [7:0] select_2144;
  assign select_2144 = select_1491_s15_q[2] ? (select_1491_s15_q[1] ? select_2138 : select_2139) : (select_1491_s15_q[1] ? select_2141 : select_2142_s15_q);
  logic [7:0] select_2166;
  assign select_2166 = select_1491_s15_q[4] ? (select_1491_s15_q[3] ? select_2144 : select_2149_s15_q) : select_2165_s15_q;
  // hls/stages/agreement.hpp:215
  logic [8:0] select_2349;
  assign select_2349 = sample_pair_whole_s15_q ? (and_416_s15_q ? grey_s15_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2351;
  assign select_2351 = sample_pair_whole_s15_q ? (and_416_s15_q ? grey_2_s15_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2353;
  assign select_2353 = sample_pair_whole_s15_q ? (and_416_s15_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2355;
  assign select_2355 = sample_pair_whole_s15_q ? (and_416_s15_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  logic [10:0] select_2357;
  assign select_2357 = sample_pair_whole_s15_q ? (and_416_s15_q ? total : averager_total_0_q) : averager_total_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_2360;
  assign sum_2360 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s15_q};
  logic [9:0] sum_2368;
  assign sum_2368 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s15_q};

  // Memory census_memory, 120 x 80, DISTANCE 16, hls/stages/census.hpp:254; read in stage 15, written in stage 17: 15 < 17 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [79:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 80'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s15_q;
  logic census_memory_re;
  assign census_memory_re = s15_en & and_418_s15_q;
  logic [79:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1076; read in stage 15, written in stage 16: 15 < 16 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s15_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s15_en & and_1420;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1100; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s15_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s15_en & and_1420;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_quarter_1_0_q = 9'h0;
    averager_quarter_1_1_q = 9'h0;
    averager_quarter_2_0_q = 9'h0;
    averager_quarter_2_1_q = 9'h0;
    averager_total_0_q = 11'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s15_en) begin
      averager_quarter_1_0_q <= select_2349;
      averager_quarter_1_1_q <= select_2351;
      averager_quarter_2_0_q <= select_2353;
      averager_quarter_2_1_q <= select_2355;
      averager_total_0_q <= select_2357;
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
  logic [2:0] slot_s16_q;
  logic ends_cell_s16_q;
  logic lower_half_s16_q;
  logic [11:0] registration_slope_s16_q;
  logic [6:0] column_s16_q;
  logic and_416_s16_q;
  logic and_418_s16_q;
  logic equal_421_s16_q;
  logic [8:0] select_424_s16_q;
  logic [8:0] grey_2_s16_q;
  logic whole_2_s16_q;
  logic and_436_s16_q;
  logic so_s16_q;
  logic equal_476_s16_q;
  logic equal_479_s16_q;
  logic select_481_s16_q;
  logic [6:0] x_s16_2_q;
  logic [45:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1327_s16_q;
  logic [2:0] select_1332_s16_q;
  logic [7:0] select_1358_s16_q;
  logic [7:0] select_1362_s16_q;
  logic [6:0] of_near_s16_q;
  logic or_1366_s16_q;
  logic and_1369_s16_q;
  logic [6:0] right_s16_q;
  logic [28:0] best_right_rdata_s16_q;
  logic or_1378_s16_q;
  logic or_1382_s16_q;
  logic equal_1385_s16_q;
  logic not_1386_s16_q;
  logic [13:0] inside_v_s16_q;
  logic and_1420_s16_q;
  logic [6:0] select_1424_s16_q;
  logic and_1429_s16_q;
  logic [1:0] sum_1436_s16_q;
  logic right_2_s16_q;
  logic equal_1484_s16_q;
  logic [8:0] select_1491_s16_q;
  logic and_1523_s16_q;
  logic and_1544_s16_q;
  logic less_1553_s16_q;
  logic [7:0] select_1617_s16_q;
  logic [7:0] select_1620_s16_q;
  logic [7:0] sum_1645_s16_q;
  logic [7:0] wide_s16_q;
  logic [8:0] size_s16_q;
  logic [7:0] select_1700_s16_q;
  logic [7:0] select_1742_s16_q;
  logic [7:0] select_1783_s16_q;
  logic [7:0] select_1836_s16_q;
  logic select_2124_s16_q;
  logic [7:0] select_2125_s16_q;
  logic [7:0] select_2134_s16_q;
  logic [7:0] select_2166_s16_q;
  logic equal_2186_s16_q;
  logic textured_s16_q;
  logic and_2324_s16_q;
  logic sum_2360_s16_q;
  logic [9:0] difference_2361_s16_q;
  logic sum_2368_s16_q;
  logic [9:0] difference_2369_s16_q;
  logic equal_2511_s16_q;
  logic equal_2565_s16_q;
  logic less_2865_s16_q;
  logic equal_3062_s16_q;
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
      slot_s16_q <= slot_s15_q;
      ends_cell_s16_q <= ends_cell_s15_q;
      lower_half_s16_q <= lower_half_s15_q;
      registration_slope_s16_q <= registration_slope_s15_q;
      column_s16_q <= column_s15_q;
      and_416_s16_q <= and_416_s15_q;
      and_418_s16_q <= and_418_s15_q;
      equal_421_s16_q <= equal_421_s15_q;
      select_424_s16_q <= sample_pair_whole_s15_q ? total[10:2] : 9'h0;
      grey_2_s16_q <= grey_2_s15_q;
      whole_2_s16_q <= whole_2_s15_q;
      and_436_s16_q <= and_436_s15_q;
      so_s16_q <= so_s15_q;
      equal_476_s16_q <= equal_476_s15_q;
      equal_479_s16_q <= equal_479_s15_q;
      select_481_s16_q <= select_481_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      of_best_s16_q <= of_best;
      or_1327_s16_q <= select_567_s15_q | (best_left_rdata_s15_q[16:9] < of_best);
      select_1332_s16_q <= select_1332_s15_q;
      select_1358_s16_q <= select_1338[2] ? select_1340 : select_1357;
      select_1362_s16_q <= select_1362;
      of_near_s16_q <= of_near;
      or_1366_s16_q <= select_567_s15_q | (best_left_rdata_s15_q[39:33] < of_near);
      and_1369_s16_q <= and_1369_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q;
      or_1378_s16_q <= select_1376_s15_q | (best_right_rdata_s15_q[7:0] < of_best);
      or_1382_s16_q <= select_1376_s15_q | (best_right_rdata_s15_q[21:15] < of_near);
      equal_1385_s16_q <= equal_1385_s15_q;
      not_1386_s16_q <= not_1386;
      inside_v_s16_q <= inside_v_s15_q;
      and_1420_s16_q <= and_1420;
      select_1424_s16_q <= select_1424_s15_q;
      and_1429_s16_q <= not_1386 & (so_s15_q ? and_1418 : and_1427_s15_q);
      sum_1436_s16_q <= sum_1436_s15_q;
      right_2_s16_q <= right_2_s15_q;
      equal_1484_s16_q <= equal_1484_s15_q;
      select_1491_s16_q <= select_1491_s15_q;
      and_1523_s16_q <= and_1523_s15_q;
      and_1544_s16_q <= and_1544_s15_q;
      less_1553_s16_q <= less_1553_s15_q;
      select_1617_s16_q <= select_1617_s15_q;
      select_1620_s16_q <= select_1620_s15_q;
      sum_1645_s16_q <= sum_1645[9:2];
      wide_s16_q <= wide;
      size_s16_q <= size;
      select_1700_s16_q <= select_1491_s15_q[2] ? select_1696 : select_1699;
      select_1742_s16_q <= select_1491_s15_q[4] ? select_1725 : select_1741_s15_q;
      select_1783_s16_q <= select_1783_s15_q;
      select_1836_s16_q <= select_1836_s15_q;
      select_2124_s16_q <= select_2124_s15_q;
      select_2125_s16_q <= select_2125_s15_q;
      select_2134_s16_q <= select_1491_s15_q[1] ? select_2132 : select_2133;
      select_2166_s16_q <= select_2166;
      equal_2186_s16_q <= equal_2186_s15_q;
      textured_s16_q <= textured_s15_q;
      and_2324_s16_q <= not_1386 & and_2323_s15_q;
      sum_2360_s16_q <= sum_2360[0];
      difference_2361_s16_q <= {1'b0, sum_2360[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2368_s16_q <= sum_2368[0];
      difference_2369_s16_q <= {1'b0, sum_2368[9:1]} - {1'b0, averager_quarter_1_1_q};
      equal_2511_s16_q <= equal_2511_s15_q;
      equal_2565_s16_q <= equal_2565_s15_q;
      less_2865_s16_q <= less_2865_s15_q;
      equal_3062_s16_q <= equal_3062_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_1_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s16_q} + (equal_421_s16_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:139
  logic not_1425;
  assign not_1425 = ~so_s16_q;
  // hls/stages/agreement.hpp:211
  logic and_1426;
  assign and_1426 = not_1425 & inside_v_s16_q[4];
  // hls/stages/registration.hpp:250
  logic [6:0] select_1509;
  assign select_1509 = select_1491_s16_q[0] ? {7{columns_begin_back_q[7]}} : columns_begin_back_q[6:0];
  logic [7:0] select_1510;
  assign select_1510 = select_1491_s16_q[0] ? {8{columns_begin_rest_q[8]}} : columns_begin_rest_q[7:0];
  logic [7:0] select_1511;
  assign select_1511 = select_1491_s16_q[1] ? {columns_begin_back_q[7], select_1509} : select_1510;
  logic [7:0] select_1512;
  assign select_1512 = select_1491_s16_q[0] ? {8{region_across_next_q[8]}} : region_across_next_q[7:0];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1513;
  assign sum_1513 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1514;
  assign sum_1514 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1515;
  assign select_1515 = sum_1513[5] ? {1'b1, sum_1513[4:0], region_across_rest_q[2:0]} : sum_1514;
  // hls/stages/agreement.hpp:143
  logic [8:0] select_1525;
  assign select_1525 = so_s16_q ? (and_1523_s16_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1646;
  assign sum_1646 = {registration_slope_s16_q[11], registration_slope_s16_q} + {{5{sum_1645_s16_q[7]}}, sum_1645_s16_q};
  // hls/stages/registration.hpp:40
  logic [8:0] select_1665;
  assign select_1665 = ({wide_s16_q, 1'b0} < size_s16_q) ? {wide_s16_q, 1'b0} : size_s16_q;
  logic [8:0] taken;
  assign taken = ~select_1665;
  // hls/stages/registration.hpp:250
  logic [7:0] select_2130;
  assign select_2130 = select_1491_s16_q[0] ? {5'h0, averager_total_1_q[10:8]} : averager_total_1_q[7:0];
  // hls/stages/agreement.hpp:215
  logic [10:0] select_2359;
  assign select_2359 = sample_pair_whole_s16_q ? (and_416_s16_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/census.hpp:129
  logic [9:0] xor_2362;
  assign xor_2362 = {difference_2361_s16_q[8:0], sum_2360_s16_q} ^ {10{difference_2361_s16_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2361_s16_q[9]} + {1'b0, xor_2362};
  logic [9:0] xor_2370;
  assign xor_2370 = {difference_2369_s16_q[8:0], sum_2368_s16_q} ^ {10{difference_2369_s16_q[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_2369_s16_q[9]} + {1'b0, xor_2370};
  // hls/stages/agreement.hpp:314
  logic [8:0] select_2875;
  assign select_2875 = equal_2565_s16_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_2878;
  assign select_2878 = equal_2565_s16_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1424_s16_q;
  logic shown_right_we;
  assign shown_right_we = s16_en & and_1429_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1426, not_1425};
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
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s16_en) begin
      region_across_rest_q <= select_1525;
      region_across_back_q <= so_s16_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_1515;
      columns_begin_rest_q <= and_418_s16_q ? select_2875 : columns_begin_rest_q;
      columns_begin_back_q <= and_418_s16_q ? select_2878 : columns_begin_back_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_total_1_q = 11'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s16_en) begin
      averager_total_1_q <= select_2359;
    end
  end

  logic [7:0] pixel_0_s17_q;
  logic [7:0] pixel_1_s17_q;
  logic saturated_s17_q;
  logic mask_s17_q;
  logic marks_first_s17_q;
  logic marks_last_s17_q;
  logic sample_pair_whole_s17_q;
  logic [7:0] x_s17_q;
  logic age_s17_q;
  logic [2:0] slot_s17_q;
  logic ends_cell_s17_q;
  logic lower_half_s17_q;
  logic [6:0] column_s17_q;
  logic and_416_s17_q;
  logic and_418_s17_q;
  logic [79:0] census_memory_rdata_s17_q;
  logic equal_421_s17_q;
  logic [8:0] select_424_s17_q;
  logic [8:0] select_428_s17_q;
  logic whole_2_s17_q;
  logic and_436_s17_q;
  logic so_s17_q;
  logic equal_476_s17_q;
  logic equal_479_s17_q;
  logic select_481_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1328_s17_q;
  logic [2:0] select_1333_s17_q;
  logic [7:0] select_1334_s17_q;
  logic [7:0] select_1359_s17_q;
  logic [7:0] select_1363_s17_q;
  logic [6:0] select_1367_s17_q;
  logic [5:0] select_1368_s17_q;
  logic and_1369_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1379_s17_q;
  logic [6:0] select_1380_s17_q;
  logic [6:0] select_1383_s17_q;
  logic [6:0] select_1384_s17_q;
  logic equal_1385_s17_q;
  logic not_1386_s17_q;
  logic [13:0] inside_v_s17_q;
  logic and_1420_s17_q;
  logic [1:0] shown_right_rdata_s17_q;
  logic not_1425_s17_q;
  logic [1:0] sum_1436_s17_q;
  logic right_2_s17_q;
  logic equal_1484_s17_q;
  logic [8:0] select_1491_s17_q;
  logic [7:0] select_1511_s17_q;
  logic [7:0] select_1512_s17_q;
  logic sum_1513_s17_q;
  logic and_1544_s17_q;
  logic less_1553_s17_q;
  logic [7:0] select_1617_s17_q;
  logic [7:0] select_1620_s17_q;
  logic [7:0] sum_1646_s17_q;
  logic less_1647_s17_q;
  logic less_1648_s17_q;
  logic less_1653_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] taken_s17_q;
  logic [7:0] not_1667_s17_q;
  logic [7:0] select_1700_s17_q;
  logic [7:0] select_1742_s17_q;
  logic [7:0] select_1783_s17_q;
  logic [7:0] select_1836_s17_q;
  logic select_2124_s17_q;
  logic [7:0] select_2125_s17_q;
  logic [7:0] select_2130_s17_q;
  logic [7:0] select_2134_s17_q;
  logic [7:0] select_2166_s17_q;
  logic equal_2186_s17_q;
  logic textured_s17_q;
  logic [17:0] seen_columns_rdata_s17_q;
  logic and_2324_s17_q;
  logic [10:0] size_2_s17_q;
  logic [10:0] size_3_s17_q;
  logic equal_2511_s17_q;
  logic equal_2565_s17_q;
  logic less_2865_s17_q;
  logic equal_3062_s17_q;
  always_ff @(posedge clk_i) begin
    if (s16_en) begin
      pixel_0_s17_q <= pixel_0_s16_q;
      pixel_1_s17_q <= pixel_1_s16_q;
      saturated_s17_q <= saturated_s16_q;
      mask_s17_q <= mask_s16_q;
      marks_first_s17_q <= marks_first_s16_q;
      marks_last_s17_q <= marks_last_s16_q;
      sample_pair_whole_s17_q <= sample_pair_whole_s16_q;
      x_s17_q <= x_s16_q;
      age_s17_q <= age_s16_q;
      slot_s17_q <= slot_s16_q;
      ends_cell_s17_q <= ends_cell_s16_q;
      lower_half_s17_q <= lower_half_s16_q;
      column_s17_q <= column_s16_q;
      and_416_s17_q <= and_416_s16_q;
      and_418_s17_q <= and_418_s16_q;
      census_memory_rdata_s17_q <= census_memory_rdata_q;
      equal_421_s17_q <= equal_421_s16_q;
      select_424_s17_q <= select_424_s16_q;
      select_428_s17_q <= sample_pair_whole_s16_q ? total_2[10:2] : 9'h0;
      whole_2_s17_q <= whole_2_s16_q;
      and_436_s17_q <= and_436_s16_q;
      so_s17_q <= so_s16_q;
      equal_476_s17_q <= equal_476_s16_q;
      equal_479_s17_q <= equal_479_s16_q;
      select_481_s17_q <= select_481_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1328_s17_q <= or_1327_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1333_s17_q <= or_1327_s16_q ? select_1332_s16_q : best_left_rdata_s16_q[8:6];
      select_1334_s17_q <= or_1327_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1359_s17_q <= or_1327_s16_q ? select_1358_s16_q : best_left_rdata_s16_q[24:17];
      select_1363_s17_q <= or_1327_s16_q ? select_1362_s16_q : best_left_rdata_s16_q[32:25];
      select_1367_s17_q <= or_1366_s16_q ? of_near_s16_q : best_left_rdata_s16_q[39:33];
      select_1368_s17_q <= or_1366_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[45:40];
      and_1369_s17_q <= and_1369_s16_q;
      right_s17_q <= right_s16_q;
      select_1379_s17_q <= or_1378_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1380_s17_q <= or_1378_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1383_s17_q <= or_1382_s16_q ? of_near_s16_q : best_right_rdata_s16_q[21:15];
      select_1384_s17_q <= or_1382_s16_q ? x_s16_2_q : best_right_rdata_s16_q[28:22];
      equal_1385_s17_q <= equal_1385_s16_q;
      not_1386_s17_q <= not_1386_s16_q;
      inside_v_s17_q <= inside_v_s16_q;
      and_1420_s17_q <= and_1420_s16_q;
      shown_right_rdata_s17_q <= shown_right_rdata_q;
      not_1425_s17_q <= not_1425;
      sum_1436_s17_q <= sum_1436_s16_q;
      right_2_s17_q <= right_2_s16_q;
      equal_1484_s17_q <= equal_1484_s16_q;
      select_1491_s17_q <= select_1491_s16_q;
      select_1511_s17_q <= select_1511;
      select_1512_s17_q <= select_1512;
      sum_1513_s17_q <= sum_1513[5];
      and_1544_s17_q <= and_1544_s16_q;
      less_1553_s17_q <= less_1553_s16_q;
      select_1617_s17_q <= select_1617_s16_q;
      select_1620_s17_q <= select_1620_s16_q;
      sum_1646_s17_q <= sum_1646[7:0];
      less_1647_s17_q <= $signed(6'h0) < $signed(sum_1646[12:7]);
      less_1648_s17_q <= $signed(sum_1646[12:7]) < $signed(6'h3f);
      less_1653_s17_q <= slot_s16_q < 3'h3;
      wide_s17_q <= wide_s16_q;
      taken_s17_q <= taken;
      not_1667_s17_q <= ~wide_s16_q;
      select_1700_s17_q <= select_1700_s16_q;
      select_1742_s17_q <= select_1742_s16_q;
      select_1783_s17_q <= select_1783_s16_q;
      select_1836_s17_q <= select_1836_s16_q;
      select_2124_s17_q <= select_2124_s16_q;
      select_2125_s17_q <= select_2125_s16_q;
      select_2130_s17_q <= select_2130;
      select_2134_s17_q <= select_2134_s16_q;
      select_2166_s17_q <= select_2166_s16_q;
      equal_2186_s17_q <= equal_2186_s16_q;
      textured_s17_q <= textured_s16_q;
      seen_columns_rdata_s17_q <= seen_columns_rdata_q;
      and_2324_s17_q <= and_2324_s16_q;
      size_2_s17_q <= size_2;
      size_3_s17_q <= size_3;
      equal_2511_s17_q <= equal_2511_s16_q;
      equal_2565_s17_q <= equal_2565_s16_q;
      less_2865_s17_q <= less_2865_s16_q;
      equal_3062_s17_q <= equal_3062_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
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
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  logic [7:0] registration_slope_here_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  // hls/stages/census.hpp:214
  logic less_452;
  assign less_452 = census_memory_rdata_s17_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_453;
  assign less_453 = census_memory_rdata_s17_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_454;
  assign less_454 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_455;
  assign less_455 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_456;
  assign less_456 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_457;
  assign less_457 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_458;
  assign less_458 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_459;
  assign less_459 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_460;
  assign less_460 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_461;
  assign less_461 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_462;
  assign less_462 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_463;
  assign less_463 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_464;
  assign less_464 = census_memory_rdata_s17_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_465;
  assign less_465 = census_memory_rdata_s17_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_466;
  assign less_466 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_467;
  assign less_467 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_468;
  assign less_468 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_469;
  assign less_469 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_470;
  assign less_470 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_471;
  assign less_471 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_472;
  assign less_472 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_473;
  assign less_473 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_474;
  assign less_474 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_475;
  assign less_475 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:206
  logic and_485;
  assign and_485 = census_memory_rdata_s17_q[38] & (census_memory_rdata_s17_q[18] & whole_2_s17_q);
  logic and_487;
  assign and_487 = census_memory_rdata_s17_q[78] & (census_memory_rdata_s17_q[58] & and_485);
  // hls/stages/census.hpp:190
  logic [9:0] difference_510;
  assign difference_510 = {1'b0, select_424_s17_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_513;
  assign difference_513 = {1'b0, census_memory_rdata_s17_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_517;
  assign difference_517 = {1'b0, census_memory_rdata_s17_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_521;
  assign difference_521 = {1'b0, census_memory_rdata_s17_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_525;
  assign difference_525 = {1'b0, census_memory_rdata_s17_q[68:60]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s17_q[0] ? (right_2_s17_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1473;
  assign sum_1473 = {2'h0, slot_s17_q} + 5'h1f;
  // hls/stages/registration.hpp:243
  logic not_1479;
  assign not_1479 = ~lower_half_s17_q;
  logic [3:0] select_1480;
  assign select_1480 = registration_of_right_q ? {lower_half_s17_q, 1'b0, not_1479, 1'b0} : {1'b0, lower_half_s17_q, 1'b0, not_1479};
  // hls/stages/registration.hpp:250
  logic [7:0] select_1497;
  assign select_1497 = select_1491_s17_q[0] ? {8{region_down_next_q[8]}} : region_down_next_q[7:0];
  // hls/stages/division.hpp:34
  logic [7:0] sum_1498;
  assign sum_1498 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/division.hpp:36
  logic [8:0] select_1500;
  assign select_1500 = sum_1498[7] ? {1'b1, sum_1498[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});
  // hls/stages/registration.hpp:250
  logic [6:0] select_1505;
  assign select_1505 = select_1491_s17_q[0] ? {7{region_down_back_q[7]}} : region_down_back_q[6:0];
  logic [7:0] select_1506;
  assign select_1506 = select_1491_s17_q[0] ? {8{region_down_rest_q[8]}} : region_down_rest_q[7:0];
  logic [7:0] select_1507;
  assign select_1507 = select_1491_s17_q[1] ? {region_down_back_q[7], select_1505} : select_1506;
  logic [7:0] select_1516;
  assign select_1516 = select_1491_s17_q[0] ? {8{region_across_next_q[8]}} : region_across_next_q[7:0];
  logic [7:0] select_1518;
  assign select_1518 = select_1491_s17_q[2] ? select_1511_s17_q : (select_1491_s17_q[1] ? select_1512_s17_q : select_1516);
  logic [7:0] select_1519;
  assign select_1519 = select_1491_s17_q[3] ? (select_1491_s17_q[2] ? select_1507 : 8'h0) : select_1518;
  logic [6:0] select_1522;
  assign select_1522 = select_1491_s17_q[0] ? {7{region_across_back_q[7]}} : region_across_back_q[6:0];
  logic [7:0] select_1526;
  assign select_1526 = select_1491_s17_q[0] ? {8{region_across_rest_q[8]}} : region_across_rest_q[7:0];
  logic [7:0] select_1527;
  assign select_1527 = select_1491_s17_q[1] ? {region_across_back_q[7], select_1522} : select_1526;
  // hls/stages/agreement.hpp:143
  logic [7:0] select_1528;
  assign select_1528 = so_s17_q ? region_columns_q : 8'h1;
  // hls/stages/registration.hpp:250
  logic and_1539;
  assign and_1539 = (select_1491_s17_q[0] ? shown_nearer_q : shown_shown_q) & (~select_1491_s17_q[1]);
  // hls/stages/registration.hpp:83
  logic equal_1542;
  assign equal_1542 = slot_s17_q == 3'h7;
  // hls/stages/registration.hpp:47
  logic or_1547;
  assign or_1547 = (inside_v_s17_q[13:11] == 3'h0) | (inside_v_s17_q[13:11] == 3'h4);
  // hls/stages/agreement.hpp:192
  logic [4:0] select_1554;
  assign select_1554 = so_s17_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:199
  logic [6:0] select_1558;
  assign select_1558 = inside_v_s17_q[5] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1559;
  assign select_1559 = inside_v_s17_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1560;
  assign sum_1560 = {{2{select_1558[6]}}, select_1558} + {select_1559[7], select_1559};
  // hls/stages/registration.hpp:200
  logic [7:0] select_1561;
  assign select_1561 = inside_v_s17_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1562;
  assign select_1562 = inside_v_s17_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1563;
  assign sum_1563 = {{2{select_1561[7]}}, select_1561[7:1]} + {select_1562[7], select_1562};
  // hls/stages/registration.hpp:201
  logic [7:0] select_1565;
  assign select_1565 = inside_v_s17_q[9] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1566;
  assign select_1566 = inside_v_s17_q[10] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1567;
  assign difference_1567 = {{2{select_1565[7]}}, select_1565[7:1]} - {select_1566[7], select_1566};
  // hls/stages/registration.hpp:106
  logic select_1623;
  assign select_1623 = equal_1542 ? inside_v_s17_q[0] : registration_was_inside_q;
  // hls/stages/registration.hpp:206
  logic [7:0] select_1650;
  assign select_1650 = less_1647_s17_q ? 8'h7f : (less_1648_s17_q ? 8'h80 : sum_1646_s17_q);
  // hls/stages/registration.hpp:106
  logic [7:0] select_1651;
  assign select_1651 = equal_1542 ? registration_slope_here_q : select_1650;
  // hls/stages/registration.hpp:37
  logic not_1660;
  assign not_1660 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_1653_s17_q ? {1'b0, wide_s17_q, 1'b0} : {registration_displacement_over_q[8:0], not_1660};
  // hls/stages/registration.hpp:40
  logic [7:0] select_1668;
  assign select_1668 = registration_displacement_over_q[9] ? wide_s17_q : not_1667_s17_q;
  logic [9:0] taken_2;
  assign taken_2 = less_1653_s17_q ? {taken_s17_q, 1'b1} : {not_1660, select_1668, not_1660};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_1670;
  assign sum_1670 = {left, 1'b1} + {taken_2, less_1653_s17_q};
  // hls/stages/registration.hpp:250
  logic select_1945;
  assign select_1945 = select_1491_s17_q[0] ? sharpness_last_of_skin_q : sharpness_last_mask_q;
  logic [7:0] select_1946;
  assign select_1946 = select_1491_s17_q[0] ? {7'h0, sharpness_last_mean_1_q[8]} : sharpness_last_mean_1_q[7:0];
  logic [7:0] select_1948;
  assign select_1948 = select_1491_s17_q[0] ? {7'h0, sharpness_last_mean_0_q[8]} : sharpness_last_mean_0_q[7:0];
  logic [7:0] select_1949;
  assign select_1949 = select_1491_s17_q[1] ? select_1948 : {7'h0, sharpness_last_valid_q};
  logic [7:0] select_1950;
  assign select_1950 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? {7'h0, select_1945} : select_1946) : select_1949;
  logic select_1972;
  assign select_1972 = select_1491_s17_q[0] ? census_columns_values_4_cell_4_of_skin_q : census_columns_values_4_cell_4_mask_q;
  logic [7:0] select_1973;
  assign select_1973 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_4_right_q[8]} : census_columns_values_4_cell_4_right_q[7:0];
  logic [7:0] select_1975;
  assign select_1975 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_4_left_q[8]} : census_columns_values_4_cell_4_left_q[7:0];
  logic select_1976;
  assign select_1976 = select_1491_s17_q[0] ? census_columns_values_4_cell_3_of_skin_q : census_columns_values_4_cell_3_mask_q;
  logic [7:0] select_1978;
  assign select_1978 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? {7'h0, select_1972} : select_1973) : (select_1491_s17_q[1] ? select_1975 : {7'h0, select_1976});
  logic [7:0] select_1982;
  assign select_1982 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_3_right_q[8]} : census_columns_values_4_cell_3_right_q[7:0];
  logic [7:0] select_1983;
  assign select_1983 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_3_left_q[8]} : census_columns_values_4_cell_3_left_q[7:0];
  logic select_1985;
  assign select_1985 = select_1491_s17_q[0] ? census_columns_values_4_cell_2_of_skin_q : census_columns_values_4_cell_2_mask_q;
  logic [7:0] select_1986;
  assign select_1986 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_2_right_q[8]} : census_columns_values_4_cell_2_right_q[7:0];
  logic [7:0] select_1988;
  assign select_1988 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_1982 : select_1983) : (select_1491_s17_q[1] ? {7'h0, select_1985} : select_1986);
  logic [7:0] select_1989;
  assign select_1989 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_2_left_q[8]} : census_columns_values_4_cell_2_left_q[7:0];
  logic select_1990;
  assign select_1990 = select_1491_s17_q[0] ? census_columns_values_4_cell_1_of_skin_q : census_columns_values_4_cell_1_mask_q;
  logic [7:0] select_1992;
  assign select_1992 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_1_right_q[8]} : census_columns_values_4_cell_1_right_q[7:0];
  logic [7:0] select_1993;
  assign select_1993 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_1_left_q[8]} : census_columns_values_4_cell_1_left_q[7:0];
  logic [7:0] select_1995;
  assign select_1995 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_1989 : {7'h0, select_1990}) : (select_1491_s17_q[1] ? select_1992 : select_1993);
  logic select_1997;
  assign select_1997 = select_1491_s17_q[0] ? census_columns_values_4_cell_0_of_skin_q : census_columns_values_4_cell_0_mask_q;
  logic [7:0] select_1998;
  assign select_1998 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_0_right_q[8]} : census_columns_values_4_cell_0_right_q[7:0];
  logic [7:0] select_2000;
  assign select_2000 = select_1491_s17_q[0] ? {7'h0, census_columns_values_4_cell_0_left_q[8]} : census_columns_values_4_cell_0_left_q[7:0];
  logic select_2001;
  assign select_2001 = select_1491_s17_q[0] ? census_columns_values_3_cell_4_of_skin_q : census_columns_values_3_cell_4_mask_q;
  logic [7:0] select_2003;
  assign select_2003 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? {7'h0, select_1997} : select_1998) : (select_1491_s17_q[1] ? select_2000 : {7'h0, select_2001});
  logic [7:0] select_2004;
  assign select_2004 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_4_right_q[8]} : census_columns_values_3_cell_4_right_q[7:0];
  logic [7:0] select_2005;
  assign select_2005 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_4_left_q[8]} : census_columns_values_3_cell_4_left_q[7:0];
  logic select_2007;
  assign select_2007 = select_1491_s17_q[0] ? census_columns_values_3_cell_3_of_skin_q : census_columns_values_3_cell_3_mask_q;
  logic [7:0] select_2008;
  assign select_2008 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_3_right_q[8]} : census_columns_values_3_cell_3_right_q[7:0];
  logic [7:0] select_2010;
  assign select_2010 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2004 : select_2005) : (select_1491_s17_q[1] ? {7'h0, select_2007} : select_2008);
  logic [7:0] select_2012;
  assign select_2012 = select_1491_s17_q[4] ? (select_1491_s17_q[3] ? select_1988 : select_1995) : (select_1491_s17_q[3] ? select_2003 : select_2010);
  logic [7:0] select_2013;
  assign select_2013 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_3_left_q[8]} : census_columns_values_3_cell_3_left_q[7:0];
  logic select_2014;
  assign select_2014 = select_1491_s17_q[0] ? census_columns_values_3_cell_2_of_skin_q : census_columns_values_3_cell_2_mask_q;
  logic [7:0] select_2016;
  assign select_2016 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_2_right_q[8]} : census_columns_values_3_cell_2_right_q[7:0];
  logic [7:0] select_2017;
  assign select_2017 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_2_left_q[8]} : census_columns_values_3_cell_2_left_q[7:0];
  logic [7:0] select_2019;
  assign select_2019 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2013 : {7'h0, select_2014}) : (select_1491_s17_q[1] ? select_2016 : select_2017);
  logic select_2020;
  assign select_2020 = select_1491_s17_q[0] ? census_columns_values_3_cell_1_of_skin_q : census_columns_values_3_cell_1_mask_q;
  logic [7:0] select_2021;
  assign select_2021 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_1_right_q[8]} : census_columns_values_3_cell_1_right_q[7:0];
  logic [7:0] select_2023;
  assign select_2023 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_1_left_q[8]} : census_columns_values_3_cell_1_left_q[7:0];
  logic select_2024;
  assign select_2024 = select_1491_s17_q[0] ? census_columns_values_3_cell_0_of_skin_q : census_columns_values_3_cell_0_mask_q;
  logic [7:0] select_2026;
  assign select_2026 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? {7'h0, select_2020} : select_2021) : (select_1491_s17_q[1] ? select_2023 : {7'h0, select_2024});
  logic [7:0] select_2028;
  assign select_2028 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_0_right_q[8]} : census_columns_values_3_cell_0_right_q[7:0];
  logic [7:0] select_2029;
  assign select_2029 = select_1491_s17_q[0] ? {7'h0, census_columns_values_3_cell_0_left_q[8]} : census_columns_values_3_cell_0_left_q[7:0];
  logic select_2031;
  assign select_2031 = select_1491_s17_q[0] ? census_columns_values_2_cell_4_of_skin_q : census_columns_values_2_cell_4_mask_q;
  logic [7:0] select_2032;
  assign select_2032 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_4_right_q[8]} : census_columns_values_2_cell_4_right_q[7:0];
  logic [7:0] select_2034;
  assign select_2034 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2028 : select_2029) : (select_1491_s17_q[1] ? {7'h0, select_2031} : select_2032);
  logic [7:0] select_2035;
  assign select_2035 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_4_left_q[8]} : census_columns_values_2_cell_4_left_q[7:0];
  logic select_2036;
  assign select_2036 = select_1491_s17_q[0] ? census_columns_values_2_cell_3_of_skin_q : census_columns_values_2_cell_3_mask_q;
  logic [7:0] select_2038;
  assign select_2038 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_3_right_q[8]} : census_columns_values_2_cell_3_right_q[7:0];
  logic [7:0] select_2039;
  assign select_2039 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_3_left_q[8]} : census_columns_values_2_cell_3_left_q[7:0];
  logic [7:0] select_2041;
  assign select_2041 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2035 : {7'h0, select_2036}) : (select_1491_s17_q[1] ? select_2038 : select_2039);
  logic [7:0] select_2043;
  assign select_2043 = select_1491_s17_q[4] ? (select_1491_s17_q[3] ? select_2019 : select_2026) : (select_1491_s17_q[3] ? select_2034 : select_2041);
  logic select_2046;
  assign select_2046 = select_1491_s17_q[0] ? census_columns_values_2_cell_2_of_skin_q : census_columns_values_2_cell_2_mask_q;
  logic [7:0] select_2047;
  assign select_2047 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_2_right_q[8]} : census_columns_values_2_cell_2_right_q[7:0];
  logic [7:0] select_2049;
  assign select_2049 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_2_left_q[8]} : census_columns_values_2_cell_2_left_q[7:0];
  logic select_2050;
  assign select_2050 = select_1491_s17_q[0] ? census_columns_values_2_cell_1_of_skin_q : census_columns_values_2_cell_1_mask_q;
  logic [7:0] select_2052;
  assign select_2052 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? {7'h0, select_2046} : select_2047) : (select_1491_s17_q[1] ? select_2049 : {7'h0, select_2050});
  logic [7:0] select_2053;
  assign select_2053 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_1_right_q[8]} : census_columns_values_2_cell_1_right_q[7:0];
  logic [7:0] select_2054;
  assign select_2054 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_1_left_q[8]} : census_columns_values_2_cell_1_left_q[7:0];
  logic select_2056;
  assign select_2056 = select_1491_s17_q[0] ? census_columns_values_2_cell_0_of_skin_q : census_columns_values_2_cell_0_mask_q;
  logic [7:0] select_2057;
  assign select_2057 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_0_right_q[8]} : census_columns_values_2_cell_0_right_q[7:0];
  logic [7:0] select_2059;
  assign select_2059 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2053 : select_2054) : (select_1491_s17_q[1] ? {7'h0, select_2056} : select_2057);
  logic [7:0] select_2061;
  assign select_2061 = select_1491_s17_q[0] ? {7'h0, census_columns_values_2_cell_0_left_q[8]} : census_columns_values_2_cell_0_left_q[7:0];
  logic select_2062;
  assign select_2062 = select_1491_s17_q[0] ? census_columns_values_1_cell_4_of_skin_q : census_columns_values_1_cell_4_mask_q;
  logic [7:0] select_2064;
  assign select_2064 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_4_right_q[8]} : census_columns_values_1_cell_4_right_q[7:0];
  logic [7:0] select_2065;
  assign select_2065 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_4_left_q[8]} : census_columns_values_1_cell_4_left_q[7:0];
  logic [7:0] select_2067;
  assign select_2067 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2061 : {7'h0, select_2062}) : (select_1491_s17_q[1] ? select_2064 : select_2065);
  logic select_2068;
  assign select_2068 = select_1491_s17_q[0] ? census_columns_values_1_cell_3_of_skin_q : census_columns_values_1_cell_3_mask_q;
  logic [7:0] select_2069;
  assign select_2069 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_3_right_q[8]} : census_columns_values_1_cell_3_right_q[7:0];
  logic [7:0] select_2071;
  assign select_2071 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_3_left_q[8]} : census_columns_values_1_cell_3_left_q[7:0];
  logic select_2072;
  assign select_2072 = select_1491_s17_q[0] ? census_columns_values_1_cell_2_of_skin_q : census_columns_values_1_cell_2_mask_q;
  logic [7:0] select_2074;
  assign select_2074 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? {7'h0, select_2068} : select_2069) : (select_1491_s17_q[1] ? select_2071 : {7'h0, select_2072});
  logic [7:0] select_2076;
  assign select_2076 = select_1491_s17_q[4] ? (select_1491_s17_q[3] ? select_2052 : select_2059) : (select_1491_s17_q[3] ? select_2067 : select_2074);
  logic [7:0] select_2077;
  assign select_2077 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_2_right_q[8]} : census_columns_values_1_cell_2_right_q[7:0];
  logic [7:0] select_2078;
  assign select_2078 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_2_left_q[8]} : census_columns_values_1_cell_2_left_q[7:0];
  logic select_2080;
  assign select_2080 = select_1491_s17_q[0] ? census_columns_values_1_cell_1_of_skin_q : census_columns_values_1_cell_1_mask_q;
  logic [7:0] select_2081;
  assign select_2081 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_1_right_q[8]} : census_columns_values_1_cell_1_right_q[7:0];
  logic [7:0] select_2083;
  assign select_2083 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2077 : select_2078) : (select_1491_s17_q[1] ? {7'h0, select_2080} : select_2081);
  logic [7:0] select_2084;
  assign select_2084 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_1_left_q[8]} : census_columns_values_1_cell_1_left_q[7:0];
  logic select_2085;
  assign select_2085 = select_1491_s17_q[0] ? census_columns_values_1_cell_0_of_skin_q : census_columns_values_1_cell_0_mask_q;
  logic [7:0] select_2087;
  assign select_2087 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_0_right_q[8]} : census_columns_values_1_cell_0_right_q[7:0];
  logic [7:0] select_2088;
  assign select_2088 = select_1491_s17_q[0] ? {7'h0, census_columns_values_1_cell_0_left_q[8]} : census_columns_values_1_cell_0_left_q[7:0];
  logic [7:0] select_2090;
  assign select_2090 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2084 : {7'h0, select_2085}) : (select_1491_s17_q[1] ? select_2087 : select_2088);
  logic select_2092;
  assign select_2092 = select_1491_s17_q[0] ? census_columns_values_0_cell_4_of_skin_q : census_columns_values_0_cell_4_mask_q;
  logic [7:0] select_2093;
  assign select_2093 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_4_right_q[8]} : census_columns_values_0_cell_4_right_q[7:0];
  logic [7:0] select_2095;
  assign select_2095 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_4_left_q[8]} : census_columns_values_0_cell_4_left_q[7:0];
  logic select_2096;
  assign select_2096 = select_1491_s17_q[0] ? census_columns_values_0_cell_3_of_skin_q : census_columns_values_0_cell_3_mask_q;
  logic [7:0] select_2098;
  assign select_2098 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? {7'h0, select_2092} : select_2093) : (select_1491_s17_q[1] ? select_2095 : {7'h0, select_2096});
  logic [7:0] select_2099;
  assign select_2099 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_3_right_q[8]} : census_columns_values_0_cell_3_right_q[7:0];
  logic [7:0] select_2100;
  assign select_2100 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_3_left_q[8]} : census_columns_values_0_cell_3_left_q[7:0];
  logic select_2102;
  assign select_2102 = select_1491_s17_q[0] ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_0_cell_2_mask_q;
  logic [7:0] select_2103;
  assign select_2103 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_2_right_q[8]} : census_columns_values_0_cell_2_right_q[7:0];
  logic [7:0] select_2105;
  assign select_2105 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2099 : select_2100) : (select_1491_s17_q[1] ? {7'h0, select_2102} : select_2103);
  logic [7:0] select_2107;
  assign select_2107 = select_1491_s17_q[4] ? (select_1491_s17_q[3] ? select_2083 : select_2090) : (select_1491_s17_q[3] ? select_2098 : select_2105);
  logic [7:0] select_2109;
  assign select_2109 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_2_left_q[8]} : census_columns_values_0_cell_2_left_q[7:0];
  logic select_2110;
  assign select_2110 = select_1491_s17_q[0] ? census_columns_values_0_cell_1_of_skin_q : census_columns_values_0_cell_1_mask_q;
  logic [7:0] select_2112;
  assign select_2112 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_1_right_q[8]} : census_columns_values_0_cell_1_right_q[7:0];
  logic [7:0] select_2113;
  assign select_2113 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_1_left_q[8]} : census_columns_values_0_cell_1_left_q[7:0];
  logic [7:0] select_2115;
  assign select_2115 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2109 : {7'h0, select_2110}) : (select_1491_s17_q[1] ? select_2112 : select_2113);
  logic select_2116;
  assign select_2116 = select_1491_s17_q[0] ? census_columns_values_0_cell_0_of_skin_q : census_columns_values_0_cell_0_mask_q;
  logic [7:0] select_2117;
  assign select_2117 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_0_right_q[8]} : census_columns_values_0_cell_0_right_q[7:0];
  logic [7:0] select_2119;
  assign select_2119 = select_1491_s17_q[0] ? {7'h0, census_columns_values_0_cell_0_left_q[8]} : census_columns_values_0_cell_0_left_q[7:0];
  logic [7:0] select_2120;
  assign select_2120 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? {7'h0, select_2116} : select_2117) : select_2119;
  logic [7:0] select_2126;
  assign select_2126 = select_1491_s17_q[0] ? {2'h0, averager_detail_1_q[13:8]} : averager_detail_1_q[7:0];
  logic [7:0] select_2128;
  assign select_2128 = select_1491_s17_q[2] ? {7'h0, select_2124_s17_q} : (select_1491_s17_q[1] ? select_2125_s17_q : select_2126);
  logic [7:0] select_2129;
  assign select_2129 = select_1491_s17_q[0] ? {2'h0, averager_detail_0_q[13:8]} : averager_detail_0_q[7:0];
  logic [7:0] select_2135;
  assign select_2135 = select_1491_s17_q[2] ? (select_1491_s17_q[1] ? select_2129 : select_2130_s17_q) : select_2134_s17_q;
  logic [7:0] select_2137;
  assign select_2137 = select_1491_s17_q[4] ? (select_1491_s17_q[3] ? select_2115 : select_2120) : (select_1491_s17_q[3] ? select_2128 : select_2135);
  // hls/stages/agreement.hpp:781
  logic or_2175;
  assign or_2175 = select_1528[7] | (~({select_1528[5], select_1528[3], select_1528[1]} == 3'h0));
  // hls/stages/agreement.hpp:789
  logic or_2187;
  assign or_2187 = (~sum_1513_s17_q) | equal_2186_s17_q;
  // hls/stages/agreement.hpp:197
  logic explained;
  assign explained = inside_v_s17_q[0] & inside_v_s17_q[3];
  logic and_2204;
  assign and_2204 = inside_v_s17_q[0] & ({inside_v_s17_q[4], inside_v_s17_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:752
  logic select_2212;
  assign select_2212 = slot_s17_q[2] ? shown_shown_q : inside_v_s17_q[3];
  // hls/stages/agreement.hpp:197
  logic shown;
  assign shown = inside_v_s17_q[0] & (shown_right_rdata_s17_q[0] | select_2212);
  // hls/stages/agreement.hpp:752
  logic select_2215;
  assign select_2215 = slot_s17_q[2] ? shown_nearer_q : inside_v_s17_q[4];
  // hls/stages/agreement.hpp:197
  logic near;
  assign near = inside_v_s17_q[0] & (select_2212 ? select_2215 : shown_right_rdata_s17_q[1]);
  // hls/stages/agreement.hpp:765
  logic [7:0] select_2265;
  assign select_2265 = inside_v_s17_q[0] ? (sum_1513_s17_q ? select_1528 : {select_1528[6:0], 1'b0}) : select_1528;
  // hls/stages/agreement.hpp:781
  logic or_2268;
  assign or_2268 = select_2265[7] | (~({select_2265[5], select_2265[3], select_2265[1]} == 3'h0));
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2_s17_q} + (equal_421_s17_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_2367;
  assign select_2367 = sample_pair_whole_s17_q ? (and_416_s17_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3_s17_q} + (equal_421_s17_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_2375;
  assign select_2375 = sample_pair_whole_s17_q ? (and_416_s17_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:365
  logic [8:0] select_2383;
  assign select_2383 = and_418_s17_q ? select_424_s17_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2384;
  assign select_2384 = and_418_s17_q ? select_428_s17_q : census_columns_values_0_cell_0_right_q;
  logic select_2385;
  assign select_2385 = and_418_s17_q ? whole_2_s17_q : census_columns_values_0_cell_0_mask_q;
  logic select_2386;
  assign select_2386 = and_418_s17_q ? and_436_s17_q : census_columns_values_0_cell_0_of_skin_q;
  logic [8:0] select_2387;
  assign select_2387 = and_418_s17_q ? census_memory_rdata_s17_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2388;
  assign select_2388 = and_418_s17_q ? census_memory_rdata_s17_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2389;
  assign select_2389 = and_418_s17_q ? census_memory_rdata_s17_q[18] : census_columns_values_0_cell_1_mask_q;
  logic select_2390;
  assign select_2390 = and_418_s17_q ? census_memory_rdata_s17_q[19] : census_columns_values_0_cell_1_of_skin_q;
  logic [8:0] select_2391;
  assign select_2391 = and_418_s17_q ? census_memory_rdata_s17_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2392;
  assign select_2392 = and_418_s17_q ? census_memory_rdata_s17_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2393;
  assign select_2393 = and_418_s17_q ? census_memory_rdata_s17_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2394;
  assign select_2394 = and_418_s17_q ? census_memory_rdata_s17_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2395;
  assign select_2395 = and_418_s17_q ? census_memory_rdata_s17_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2396;
  assign select_2396 = and_418_s17_q ? census_memory_rdata_s17_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2397;
  assign select_2397 = and_418_s17_q ? census_memory_rdata_s17_q[58] : census_columns_values_0_cell_3_mask_q;
  logic select_2398;
  assign select_2398 = and_418_s17_q ? census_memory_rdata_s17_q[59] : census_columns_values_0_cell_3_of_skin_q;
  logic [8:0] select_2399;
  assign select_2399 = and_418_s17_q ? census_memory_rdata_s17_q[68:60] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2400;
  assign select_2400 = and_418_s17_q ? census_memory_rdata_s17_q[77:69] : census_columns_values_0_cell_4_right_q;
  logic select_2401;
  assign select_2401 = and_418_s17_q ? census_memory_rdata_s17_q[78] : census_columns_values_0_cell_4_mask_q;
  logic select_2402;
  assign select_2402 = and_418_s17_q ? census_memory_rdata_s17_q[79] : census_columns_values_0_cell_4_of_skin_q;
  logic [8:0] select_2403;
  assign select_2403 = and_418_s17_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2404;
  assign select_2404 = and_418_s17_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2405;
  assign select_2405 = and_418_s17_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2406;
  assign select_2406 = and_418_s17_q ? census_columns_values_0_cell_0_of_skin_q : census_columns_values_1_cell_0_of_skin_q;
  logic [8:0] select_2407;
  assign select_2407 = and_418_s17_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2408;
  assign select_2408 = and_418_s17_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2409;
  assign select_2409 = and_418_s17_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic select_2410;
  assign select_2410 = and_418_s17_q ? census_columns_values_0_cell_1_of_skin_q : census_columns_values_1_cell_1_of_skin_q;
  logic [8:0] select_2411;
  assign select_2411 = and_418_s17_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2412;
  assign select_2412 = and_418_s17_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2413;
  assign select_2413 = and_418_s17_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2414;
  assign select_2414 = and_418_s17_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2415;
  assign select_2415 = and_418_s17_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2416;
  assign select_2416 = and_418_s17_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2417;
  assign select_2417 = and_418_s17_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic select_2418;
  assign select_2418 = and_418_s17_q ? census_columns_values_0_cell_3_of_skin_q : census_columns_values_1_cell_3_of_skin_q;
  logic [8:0] select_2419;
  assign select_2419 = and_418_s17_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2420;
  assign select_2420 = and_418_s17_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2421;
  assign select_2421 = and_418_s17_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic select_2422;
  assign select_2422 = and_418_s17_q ? census_columns_values_0_cell_4_of_skin_q : census_columns_values_1_cell_4_of_skin_q;
  logic [8:0] select_2423;
  assign select_2423 = and_418_s17_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2424;
  assign select_2424 = and_418_s17_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2425;
  assign select_2425 = and_418_s17_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2426;
  assign select_2426 = and_418_s17_q ? census_columns_values_1_cell_0_of_skin_q : census_columns_values_2_cell_0_of_skin_q;
  logic [8:0] select_2427;
  assign select_2427 = and_418_s17_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2428;
  assign select_2428 = and_418_s17_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2429;
  assign select_2429 = and_418_s17_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic select_2430;
  assign select_2430 = and_418_s17_q ? census_columns_values_1_cell_1_of_skin_q : census_columns_values_2_cell_1_of_skin_q;
  logic [8:0] select_2431;
  assign select_2431 = and_418_s17_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2432;
  assign select_2432 = and_418_s17_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2433;
  assign select_2433 = and_418_s17_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2434;
  assign select_2434 = and_418_s17_q ? census_columns_values_1_cell_2_of_skin_q : census_columns_values_2_cell_2_of_skin_q;
  logic [8:0] select_2435;
  assign select_2435 = and_418_s17_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2436;
  assign select_2436 = and_418_s17_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2437;
  assign select_2437 = and_418_s17_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic select_2438;
  assign select_2438 = and_418_s17_q ? census_columns_values_1_cell_3_of_skin_q : census_columns_values_2_cell_3_of_skin_q;
  logic [8:0] select_2439;
  assign select_2439 = and_418_s17_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2440;
  assign select_2440 = and_418_s17_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2441;
  assign select_2441 = and_418_s17_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2442;
  assign select_2442 = and_418_s17_q ? census_columns_values_1_cell_4_of_skin_q : census_columns_values_2_cell_4_of_skin_q;
  logic [8:0] select_2443;
  assign select_2443 = and_418_s17_q ? census_columns_values_2_cell_0_left_q : census_columns_values_3_cell_0_left_q;
  logic [8:0] select_2444;
  assign select_2444 = and_418_s17_q ? census_columns_values_2_cell_0_right_q : census_columns_values_3_cell_0_right_q;
  logic select_2445;
  assign select_2445 = and_418_s17_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic select_2446;
  assign select_2446 = and_418_s17_q ? census_columns_values_2_cell_0_of_skin_q : census_columns_values_3_cell_0_of_skin_q;
  logic [8:0] select_2447;
  assign select_2447 = and_418_s17_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2448;
  assign select_2448 = and_418_s17_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2449;
  assign select_2449 = and_418_s17_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2450;
  assign select_2450 = and_418_s17_q ? census_columns_values_2_cell_1_of_skin_q : census_columns_values_3_cell_1_of_skin_q;
  logic [8:0] select_2451;
  assign select_2451 = and_418_s17_q ? census_columns_values_2_cell_2_left_q : census_columns_values_3_cell_2_left_q;
  logic [8:0] select_2452;
  assign select_2452 = and_418_s17_q ? census_columns_values_2_cell_2_right_q : census_columns_values_3_cell_2_right_q;
  logic select_2453;
  assign select_2453 = and_418_s17_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2454;
  assign select_2454 = and_418_s17_q ? census_columns_values_2_cell_2_of_skin_q : census_columns_values_3_cell_2_of_skin_q;
  logic [8:0] select_2455;
  assign select_2455 = and_418_s17_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2456;
  assign select_2456 = and_418_s17_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2457;
  assign select_2457 = and_418_s17_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2458;
  assign select_2458 = and_418_s17_q ? census_columns_values_2_cell_3_of_skin_q : census_columns_values_3_cell_3_of_skin_q;
  logic [8:0] select_2459;
  assign select_2459 = and_418_s17_q ? census_columns_values_2_cell_4_left_q : census_columns_values_3_cell_4_left_q;
  logic [8:0] select_2460;
  assign select_2460 = and_418_s17_q ? census_columns_values_2_cell_4_right_q : census_columns_values_3_cell_4_right_q;
  logic select_2461;
  assign select_2461 = and_418_s17_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  logic select_2462;
  assign select_2462 = and_418_s17_q ? census_columns_values_2_cell_4_of_skin_q : census_columns_values_3_cell_4_of_skin_q;
  logic [8:0] select_2463;
  assign select_2463 = and_418_s17_q ? census_columns_values_3_cell_0_left_q : census_columns_values_4_cell_0_left_q;
  logic [8:0] select_2464;
  assign select_2464 = and_418_s17_q ? census_columns_values_3_cell_0_right_q : census_columns_values_4_cell_0_right_q;
  logic select_2465;
  assign select_2465 = and_418_s17_q ? census_columns_values_3_cell_0_mask_q : census_columns_values_4_cell_0_mask_q;
  logic select_2466;
  assign select_2466 = and_418_s17_q ? census_columns_values_3_cell_0_of_skin_q : census_columns_values_4_cell_0_of_skin_q;
  logic [8:0] select_2467;
  assign select_2467 = and_418_s17_q ? census_columns_values_3_cell_1_left_q : census_columns_values_4_cell_1_left_q;
  logic [8:0] select_2468;
  assign select_2468 = and_418_s17_q ? census_columns_values_3_cell_1_right_q : census_columns_values_4_cell_1_right_q;
  logic select_2469;
  assign select_2469 = and_418_s17_q ? census_columns_values_3_cell_1_mask_q : census_columns_values_4_cell_1_mask_q;
  logic select_2470;
  assign select_2470 = and_418_s17_q ? census_columns_values_3_cell_1_of_skin_q : census_columns_values_4_cell_1_of_skin_q;
  logic [8:0] select_2471;
  assign select_2471 = and_418_s17_q ? census_columns_values_3_cell_2_left_q : census_columns_values_4_cell_2_left_q;
  logic [8:0] select_2472;
  assign select_2472 = and_418_s17_q ? census_columns_values_3_cell_2_right_q : census_columns_values_4_cell_2_right_q;
  logic select_2473;
  assign select_2473 = and_418_s17_q ? census_columns_values_3_cell_2_mask_q : census_columns_values_4_cell_2_mask_q;
  logic select_2474;
  assign select_2474 = and_418_s17_q ? census_columns_values_3_cell_2_of_skin_q : census_columns_values_4_cell_2_of_skin_q;
  logic [8:0] select_2475;
  assign select_2475 = and_418_s17_q ? census_columns_values_3_cell_3_left_q : census_columns_values_4_cell_3_left_q;
  logic [8:0] select_2476;
  assign select_2476 = and_418_s17_q ? census_columns_values_3_cell_3_right_q : census_columns_values_4_cell_3_right_q;
  logic select_2477;
  assign select_2477 = and_418_s17_q ? census_columns_values_3_cell_3_mask_q : census_columns_values_4_cell_3_mask_q;
  logic select_2478;
  assign select_2478 = and_418_s17_q ? census_columns_values_3_cell_3_of_skin_q : census_columns_values_4_cell_3_of_skin_q;
  logic [8:0] select_2479;
  assign select_2479 = and_418_s17_q ? census_columns_values_3_cell_4_left_q : census_columns_values_4_cell_4_left_q;
  logic [8:0] select_2480;
  assign select_2480 = and_418_s17_q ? census_columns_values_3_cell_4_right_q : census_columns_values_4_cell_4_right_q;
  logic select_2481;
  assign select_2481 = and_418_s17_q ? census_columns_values_3_cell_4_mask_q : census_columns_values_4_cell_4_mask_q;
  logic select_2482;
  assign select_2482 = and_418_s17_q ? census_columns_values_3_cell_4_of_skin_q : census_columns_values_4_cell_4_of_skin_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_2484;
  assign difference_2484 = {1'b0, select_428_s17_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2487;
  assign difference_2487 = {1'b0, census_memory_rdata_s17_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2491;
  assign difference_2491 = {1'b0, census_memory_rdata_s17_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2495;
  assign difference_2495 = {1'b0, census_memory_rdata_s17_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2499;
  assign difference_2499 = {1'b0, census_memory_rdata_s17_q[77:69]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:273
  logic [9:0] difference_2533;
  assign difference_2533 = {1'b0, select_424_s17_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2544;
  assign difference_2544 = {1'b0, select_428_s17_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:765
  logic and_2653;
  assign and_2653 = seen_columns_rdata_s17_q[7] & inside_v_s17_q[0];
  logic and_2654;
  assign and_2654 = seen_columns_rdata_s17_q[2] & inside_v_s17_q[0];
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2712;
  assign select_2712 = equal_1385_s17_q ? registration_slope_here_q : (so_s17_q ? select_1651 : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2713;
  assign equal_2713 = slot_s17_q == 3'h4;
  // hls/stages/agreement.hpp:211
  logic select_2742;
  assign select_2742 = so_s17_q ? (equal_2713 ? right_2_s17_q : registration_of_right_q) : registration_of_right_q;
  logic select_2745;
  assign select_2745 = equal_1385_s17_q ? registration_was_inside_q : (so_s17_q ? select_1623 : registration_was_inside_q);
  logic select_2862;
  assign select_2862 = equal_1385_s17_q ? shown_shown_q : (so_s17_q ? select_2212 : shown_shown_q);
  logic select_2864;
  assign select_2864 = equal_1385_s17_q ? shown_nearer_q : (so_s17_q ? select_2215 : shown_nearer_q);
  logic [7:0] select_2873;
  assign select_2873 = equal_1385_s17_q ? select_1528 : (so_s17_q ? (ends_cell_s17_q ? select_2265 : select_1528) : 8'h1);
  // hls/stages/agreement.hpp:314
  logic [8:0] select_2882;
  assign select_2882 = equal_479_s17_q ? {difference_2880[7], difference_2880} : (less_2865_s17_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:365
  logic [8:0] select_2884;
  assign select_2884 = and_418_s17_q ? (equal_2565_s17_q ? select_2882 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:314
  logic [7:0] select_2886;
  assign select_2886 = equal_479_s17_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:365
  logic [7:0] select_2888;
  assign select_2888 = and_418_s17_q ? (equal_2565_s17_q ? select_2886 : region_down_back_q) : region_down_back_q;

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s17_q;
  logic census_memory_we;
  assign census_memory_we = s17_en & and_418_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s17_q[59:0], and_436_s17_q, whole_2_s17_q, select_428_s17_q, select_424_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s16_sim;
  logic census_memory_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s16_sim <= census_memory_re;
      census_memory_raddr_s16_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s16_sim && census_memory_raddr_s16_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1369_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1368_s17_q, select_1367_s17_q, select_1363_s17_q, select_1359_s17_q, select_1334_s17_q, select_1333_s17_q, select_1328_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_left_raddr_s7_sim;
  logic best_left_re_s7_sim;
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s7_sim <= 1'b0;
      best_left_re_s8_sim <= 1'b0;
      best_left_re_s9_sim <= 1'b0;
      best_left_re_s10_sim <= 1'b0;
      best_left_re_s11_sim <= 1'b0;
      best_left_re_s12_sim <= 1'b0;
      best_left_re_s13_sim <= 1'b0;
      best_left_re_s14_sim <= 1'b0;
      best_left_re_s15_sim <= 1'b0;
      best_left_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s7_sim <= best_left_re;
      best_left_raddr_s7_sim <= best_left_raddr;
      best_left_re_s8_sim <= best_left_re_s7_sim;
      best_left_raddr_s8_sim <= best_left_raddr_s7_sim;
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
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s7_sim && best_left_raddr_s7_sim == best_left_waddr) begin
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
      if (best_left_waddr >= 7'd120) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 7'd120) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = right_s17_q;
  logic best_right_we;
  assign best_right_we = s17_en & and_1369_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1384_s17_q, select_1383_s17_q, select_1380_s17_q, select_1379_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_right_raddr_s10_sim;
  logic best_right_re_s10_sim;
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s10_sim <= 1'b0;
      best_right_re_s11_sim <= 1'b0;
      best_right_re_s12_sim <= 1'b0;
      best_right_re_s13_sim <= 1'b0;
      best_right_re_s14_sim <= 1'b0;
      best_right_re_s15_sim <= 1'b0;
      best_right_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      best_right_re_s10_sim <= best_right_re;
      best_right_raddr_s10_sim <= best_right_raddr;
      best_right_re_s11_sim <= best_right_re_s10_sim;
      best_right_raddr_s11_sim <= best_right_raddr_s10_sim;
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
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s10_sim && best_right_raddr_s10_sim == best_right_waddr) begin
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
      if (best_right_waddr >= 7'd120) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd120) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
    end else if (s17_en) begin
      registration_displacement_over_q <= so_s17_q ? sum_1670[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_1554;
      registration_slope_here_q <= select_2712;
      registration_of_right_q <= equal_1385_s17_q ? registration_of_right_q : select_2742;
      registration_was_inside_q <= select_2745;
      shown_shown_q <= select_2862;
      shown_nearer_q <= select_2864;
      region_columns_q <= select_2873;
      region_down_rest_q <= select_2884;
      region_down_back_q <= select_2888;
      region_down_next_q <= select_1500;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s17_en) begin
      averager_detail_0_q <= select_2367;
      averager_detail_1_q <= select_2375;
      census_columns_values_0_cell_0_left_q <= select_2383;
      census_columns_values_0_cell_0_right_q <= select_2384;
      census_columns_values_0_cell_0_mask_q <= select_2385;
      census_columns_values_0_cell_0_of_skin_q <= select_2386;
      census_columns_values_0_cell_1_left_q <= select_2387;
      census_columns_values_0_cell_1_right_q <= select_2388;
      census_columns_values_0_cell_1_mask_q <= select_2389;
      census_columns_values_0_cell_1_of_skin_q <= select_2390;
      census_columns_values_0_cell_2_left_q <= select_2391;
      census_columns_values_0_cell_2_right_q <= select_2392;
      census_columns_values_0_cell_2_mask_q <= select_2393;
      census_columns_values_0_cell_2_of_skin_q <= select_2394;
      census_columns_values_0_cell_3_left_q <= select_2395;
      census_columns_values_0_cell_3_right_q <= select_2396;
      census_columns_values_0_cell_3_mask_q <= select_2397;
      census_columns_values_0_cell_3_of_skin_q <= select_2398;
      census_columns_values_0_cell_4_left_q <= select_2399;
      census_columns_values_0_cell_4_right_q <= select_2400;
      census_columns_values_0_cell_4_mask_q <= select_2401;
      census_columns_values_0_cell_4_of_skin_q <= select_2402;
      census_columns_values_1_cell_0_left_q <= select_2403;
      census_columns_values_1_cell_0_right_q <= select_2404;
      census_columns_values_1_cell_0_mask_q <= select_2405;
      census_columns_values_1_cell_0_of_skin_q <= select_2406;
      census_columns_values_1_cell_1_left_q <= select_2407;
      census_columns_values_1_cell_1_right_q <= select_2408;
      census_columns_values_1_cell_1_mask_q <= select_2409;
      census_columns_values_1_cell_1_of_skin_q <= select_2410;
      census_columns_values_1_cell_2_left_q <= select_2411;
      census_columns_values_1_cell_2_right_q <= select_2412;
      census_columns_values_1_cell_2_mask_q <= select_2413;
      census_columns_values_1_cell_2_of_skin_q <= select_2414;
      census_columns_values_1_cell_3_left_q <= select_2415;
      census_columns_values_1_cell_3_right_q <= select_2416;
      census_columns_values_1_cell_3_mask_q <= select_2417;
      census_columns_values_1_cell_3_of_skin_q <= select_2418;
      census_columns_values_1_cell_4_left_q <= select_2419;
      census_columns_values_1_cell_4_right_q <= select_2420;
      census_columns_values_1_cell_4_mask_q <= select_2421;
      census_columns_values_1_cell_4_of_skin_q <= select_2422;
      census_columns_values_2_cell_0_left_q <= select_2423;
      census_columns_values_2_cell_0_right_q <= select_2424;
      census_columns_values_2_cell_0_mask_q <= select_2425;
      census_columns_values_2_cell_0_of_skin_q <= select_2426;
      census_columns_values_2_cell_1_left_q <= select_2427;
      census_columns_values_2_cell_1_right_q <= select_2428;
      census_columns_values_2_cell_1_mask_q <= select_2429;
      census_columns_values_2_cell_1_of_skin_q <= select_2430;
      census_columns_values_2_cell_2_left_q <= select_2431;
      census_columns_values_2_cell_2_right_q <= select_2432;
      census_columns_values_2_cell_2_mask_q <= select_2433;
      census_columns_values_2_cell_2_of_skin_q <= select_2434;
      census_columns_values_2_cell_3_left_q <= select_2435;
      census_columns_values_2_cell_3_right_q <= select_2436;
      census_columns_values_2_cell_3_mask_q <= select_2437;
      census_columns_values_2_cell_3_of_skin_q <= select_2438;
      census_columns_values_2_cell_4_left_q <= select_2439;
      census_columns_values_2_cell_4_right_q <= select_2440;
      census_columns_values_2_cell_4_mask_q <= select_2441;
      census_columns_values_2_cell_4_of_skin_q <= select_2442;
      census_columns_values_3_cell_0_left_q <= select_2443;
      census_columns_values_3_cell_0_right_q <= select_2444;
      census_columns_values_3_cell_0_mask_q <= select_2445;
      census_columns_values_3_cell_0_of_skin_q <= select_2446;
      census_columns_values_3_cell_1_left_q <= select_2447;
      census_columns_values_3_cell_1_right_q <= select_2448;
      census_columns_values_3_cell_1_mask_q <= select_2449;
      census_columns_values_3_cell_1_of_skin_q <= select_2450;
      census_columns_values_3_cell_2_left_q <= select_2451;
      census_columns_values_3_cell_2_right_q <= select_2452;
      census_columns_values_3_cell_2_mask_q <= select_2453;
      census_columns_values_3_cell_2_of_skin_q <= select_2454;
      census_columns_values_3_cell_3_left_q <= select_2455;
      census_columns_values_3_cell_3_right_q <= select_2456;
      census_columns_values_3_cell_3_mask_q <= select_2457;
      census_columns_values_3_cell_3_of_skin_q <= select_2458;
      census_columns_values_3_cell_4_left_q <= select_2459;
      census_columns_values_3_cell_4_right_q <= select_2460;
      census_columns_values_3_cell_4_mask_q <= select_2461;
      census_columns_values_3_cell_4_of_skin_q <= select_2462;
      census_columns_values_4_cell_0_left_q <= select_2463;
      census_columns_values_4_cell_0_right_q <= select_2464;
      census_columns_values_4_cell_0_mask_q <= select_2465;
      census_columns_values_4_cell_0_of_skin_q <= select_2466;
      census_columns_values_4_cell_1_left_q <= select_2467;
      census_columns_values_4_cell_1_right_q <= select_2468;
      census_columns_values_4_cell_1_mask_q <= select_2469;
      census_columns_values_4_cell_1_of_skin_q <= select_2470;
      census_columns_values_4_cell_2_left_q <= select_2471;
      census_columns_values_4_cell_2_right_q <= select_2472;
      census_columns_values_4_cell_2_mask_q <= select_2473;
      census_columns_values_4_cell_2_of_skin_q <= select_2474;
      census_columns_values_4_cell_3_left_q <= select_2475;
      census_columns_values_4_cell_3_right_q <= select_2476;
      census_columns_values_4_cell_3_mask_q <= select_2477;
      census_columns_values_4_cell_3_of_skin_q <= select_2478;
      census_columns_values_4_cell_4_left_q <= select_2479;
      census_columns_values_4_cell_4_right_q <= select_2480;
      census_columns_values_4_cell_4_mask_q <= select_2481;
      census_columns_values_4_cell_4_of_skin_q <= select_2482;
      sharpness_last_valid_q <= sharpness_last_valid_q | and_418_s17_q;
      sharpness_last_mean_0_q <= and_418_s17_q ? select_424_s17_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_418_s17_q ? select_428_s17_q : sharpness_last_mean_1_q;
      sharpness_last_mask_q <= and_418_s17_q ? whole_2_s17_q : sharpness_last_mask_q;
      sharpness_last_of_skin_q <= and_418_s17_q ? and_436_s17_q : sharpness_last_of_skin_q;
    end
  end

  logic [7:0] pixel_0_s18_q;
  logic [7:0] pixel_1_s18_q;
  logic saturated_s18_q;
  logic mask_s18_q;
  logic marks_first_s18_q;
  logic marks_last_s18_q;
  logic census_columns_values_0_cell_0_mask_s18_q;
  logic census_columns_values_0_cell_1_mask_s18_q;
  logic census_columns_values_0_cell_2_mask_s18_q;
  logic census_columns_values_0_cell_3_mask_s18_q;
  logic census_columns_values_0_cell_4_mask_s18_q;
  logic census_columns_values_1_cell_0_mask_s18_q;
  logic census_columns_values_1_cell_1_mask_s18_q;
  logic census_columns_values_1_cell_2_mask_s18_q;
  logic census_columns_values_1_cell_2_of_skin_s18_q;
  logic census_columns_values_1_cell_3_mask_s18_q;
  logic census_columns_values_1_cell_4_mask_s18_q;
  logic census_columns_values_2_cell_0_mask_s18_q;
  logic census_columns_values_2_cell_1_mask_s18_q;
  logic census_columns_values_2_cell_2_mask_s18_q;
  logic census_columns_values_2_cell_3_mask_s18_q;
  logic census_columns_values_2_cell_4_mask_s18_q;
  logic census_columns_values_3_cell_0_mask_s18_q;
  logic census_columns_values_3_cell_1_mask_s18_q;
  logic census_columns_values_3_cell_2_mask_s18_q;
  logic census_columns_values_3_cell_3_mask_s18_q;
  logic census_columns_values_3_cell_4_mask_s18_q;
  logic sharpness_last_mask_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic [2:0] slot_s18_q;
  logic ends_cell_s18_q;
  logic lower_half_s18_q;
  logic registration_of_right_s18_q;
  logic [6:0] column_s18_q;
  logic and_418_s18_q;
  logic so_s18_q;
  logic less_452_s18_q;
  logic less_453_s18_q;
  logic less_454_s18_q;
  logic less_455_s18_q;
  logic less_456_s18_q;
  logic less_457_s18_q;
  logic less_458_s18_q;
  logic less_459_s18_q;
  logic less_460_s18_q;
  logic less_461_s18_q;
  logic less_462_s18_q;
  logic less_463_s18_q;
  logic less_464_s18_q;
  logic less_465_s18_q;
  logic less_466_s18_q;
  logic less_467_s18_q;
  logic less_468_s18_q;
  logic less_469_s18_q;
  logic less_470_s18_q;
  logic less_471_s18_q;
  logic less_472_s18_q;
  logic less_473_s18_q;
  logic less_474_s18_q;
  logic less_475_s18_q;
  logic equal_476_s18_q;
  logic equal_479_s18_q;
  logic select_481_s18_q;
  logic and_487_s18_q;
  logic difference_510_s18_q;
  logic [8:0] xor_511_s18_q;
  logic difference_513_s18_q;
  logic [8:0] xor_514_s18_q;
  logic difference_517_s18_q;
  logic [8:0] xor_518_s18_q;
  logic difference_521_s18_q;
  logic [8:0] xor_522_s18_q;
  logic difference_525_s18_q;
  logic [8:0] xor_526_s18_q;
  logic equal_1385_s18_q;
  logic not_1386_s18_q;
  logic [3:0] inside_v_s18_q;
  logic and_1420_s18_q;
  logic not_1425_s18_q;
  logic equal_1430_s18_q;
  logic [1:0] sum_1436_s18_q;
  logic and_1475_s18_q;
  logic [3:0] select_1480_s18_q;
  logic equal_1484_s18_q;
  logic [8:0] select_1491_s18_q;
  logic [7:0] select_1497_s18_q;
  logic sum_1498_s18_q;
  logic [7:0] select_1519_s18_q;
  logic [7:0] select_1527_s18_q;
  logic [7:0] select_1528_s18_q;
  logic and_1539_s18_q;
  logic equal_1542_s18_q;
  logic and_1544_s18_q;
  logic or_1547_s18_q;
  logic [1:0] sum_1548_s18_q;
  logic less_1553_s18_q;
  logic [7:0] sum_1560_s18_q;
  logic select_1561_s18_q;
  logic [8:0] sum_1563_s18_q;
  logic select_1565_s18_q;
  logic [8:0] difference_1567_s18_q;
  logic [7:0] select_1617_s18_q;
  logic [7:0] select_1620_s18_q;
  logic select_1624_s18_q;
  logic [7:0] select_1651_s18_q;
  logic [7:0] select_1700_s18_q;
  logic [7:0] select_1742_s18_q;
  logic [7:0] select_1783_s18_q;
  logic [7:0] select_1836_s18_q;
  logic [7:0] select_1950_s18_q;
  logic [7:0] select_1978_s18_q;
  logic [7:0] select_2012_s18_q;
  logic [7:0] select_2043_s18_q;
  logic [7:0] select_2076_s18_q;
  logic [7:0] select_2107_s18_q;
  logic [7:0] select_2137_s18_q;
  logic [7:0] select_2166_s18_q;
  logic or_2175_s18_q;
  logic or_2178_s18_q;
  logic or_2181_s18_q;
  logic and_2190_s18_q;
  logic textured_s18_q;
  logic explained_s18_q;
  logic and_2204_s18_q;
  logic [12:0] seen_columns_rdata_s18_q;
  logic shown_s18_q;
  logic near_s18_q;
  logic and_2250_s18_q;
  logic and_2252_s18_q;
  logic or_2268_s18_q;
  logic or_2271_s18_q;
  logic or_2274_s18_q;
  logic and_2285_s18_q;
  logic and_2287_s18_q;
  logic and_2288_s18_q;
  logic and_2301_s18_q;
  logic and_2303_s18_q;
  logic and_2304_s18_q;
  logic and_2324_s18_q;
  logic difference_2484_s18_q;
  logic [8:0] xor_2485_s18_q;
  logic difference_2487_s18_q;
  logic [8:0] xor_2488_s18_q;
  logic difference_2491_s18_q;
  logic [8:0] xor_2492_s18_q;
  logic difference_2495_s18_q;
  logic [8:0] xor_2496_s18_q;
  logic difference_2499_s18_q;
  logic [8:0] xor_2500_s18_q;
  logic equal_2511_s18_q;
  logic [27:0] select_2527_s18_q;
  logic and_2532_s18_q;
  logic difference_2533_s18_q;
  logic [8:0] xor_2534_s18_q;
  logic difference_2544_s18_q;
  logic [8:0] xor_2545_s18_q;
  logic equal_2565_s18_q;
  logic and_2651_s18_q;
  logic and_2652_s18_q;
  logic [1:0] sum_2656_s18_q;
  logic and_2716_s18_q;
  logic equal_2746_s18_q;
  logic [3:0] not_2747_s18_q;
  logic less_2865_s18_q;
  logic select_2898_s18_q;
  logic and_3052_s18_q;
  logic equal_3062_s18_q;
  always_ff @(posedge clk_i) begin
    if (s17_en) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      census_columns_values_0_cell_0_mask_s18_q <= census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_mask_s18_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s18_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s18_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s18_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_0_mask_s18_q <= census_columns_values_1_cell_0_mask_q;
      census_columns_values_1_cell_1_mask_s18_q <= census_columns_values_1_cell_1_mask_q;
      census_columns_values_1_cell_2_mask_s18_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s18_q <= census_columns_values_1_cell_2_of_skin_q;
      census_columns_values_1_cell_3_mask_s18_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s18_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s18_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s18_q <= census_columns_values_2_cell_1_mask_q;
      census_columns_values_2_cell_2_mask_s18_q <= census_columns_values_2_cell_2_mask_q;
      census_columns_values_2_cell_3_mask_s18_q <= census_columns_values_2_cell_3_mask_q;
      census_columns_values_2_cell_4_mask_s18_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s18_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s18_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s18_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s18_q <= census_columns_values_3_cell_3_mask_q;
      census_columns_values_3_cell_4_mask_s18_q <= census_columns_values_3_cell_4_mask_q;
      sharpness_last_mask_s18_q <= sharpness_last_mask_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      slot_s18_q <= slot_s17_q;
      ends_cell_s18_q <= ends_cell_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      registration_of_right_s18_q <= registration_of_right_q;
      column_s18_q <= column_s17_q;
      and_418_s18_q <= and_418_s17_q;
      so_s18_q <= so_s17_q;
      less_452_s18_q <= less_452;
      less_453_s18_q <= less_453;
      less_454_s18_q <= less_454;
      less_455_s18_q <= less_455;
      less_456_s18_q <= less_456;
      less_457_s18_q <= less_457;
      less_458_s18_q <= less_458;
      less_459_s18_q <= less_459;
      less_460_s18_q <= less_460;
      less_461_s18_q <= less_461;
      less_462_s18_q <= less_462;
      less_463_s18_q <= less_463;
      less_464_s18_q <= less_464;
      less_465_s18_q <= less_465;
      less_466_s18_q <= less_466;
      less_467_s18_q <= less_467;
      less_468_s18_q <= less_468;
      less_469_s18_q <= less_469;
      less_470_s18_q <= less_470;
      less_471_s18_q <= less_471;
      less_472_s18_q <= less_472;
      less_473_s18_q <= less_473;
      less_474_s18_q <= less_474;
      less_475_s18_q <= less_475;
      equal_476_s18_q <= equal_476_s17_q;
      equal_479_s18_q <= equal_479_s17_q;
      select_481_s18_q <= select_481_s17_q;
      and_487_s18_q <= and_487;
      difference_510_s18_q <= difference_510[9];
      xor_511_s18_q <= difference_510[8:0] ^ {9{difference_510[9]}};
      difference_513_s18_q <= difference_513[9];
      xor_514_s18_q <= difference_513[8:0] ^ {9{difference_513[9]}};
      difference_517_s18_q <= difference_517[9];
      xor_518_s18_q <= difference_517[8:0] ^ {9{difference_517[9]}};
      difference_521_s18_q <= difference_521[9];
      xor_522_s18_q <= difference_521[8:0] ^ {9{difference_521[9]}};
      difference_525_s18_q <= difference_525[9];
      xor_526_s18_q <= difference_525[8:0] ^ {9{difference_525[9]}};
      equal_1385_s18_q <= equal_1385_s17_q;
      not_1386_s18_q <= not_1386_s17_q;
      inside_v_s18_q <= {inside_v_s17_q[11], inside_v_s17_q[2:0]};
      and_1420_s18_q <= and_1420_s17_q;
      not_1425_s18_q <= not_1425_s17_q;
      equal_1430_s18_q <= x_s17_q[6:4] == 3'h7;
      sum_1436_s18_q <= sum_1436_s17_q;
      and_1475_s18_q <= half_ends & ({{3{sum_1473[4]}}, sum_1473} < 8'h3);
      select_1480_s18_q <= select_1480;
      equal_1484_s18_q <= equal_1484_s17_q;
      select_1491_s18_q <= select_1491_s17_q;
      select_1497_s18_q <= select_1497;
      sum_1498_s18_q <= sum_1498[7];
      select_1519_s18_q <= select_1519;
      select_1527_s18_q <= select_1527;
      select_1528_s18_q <= select_1528;
      and_1539_s18_q <= and_1539;
      equal_1542_s18_q <= equal_1542;
      and_1544_s18_q <= and_1544_s17_q;
      or_1547_s18_q <= or_1547;
      sum_1548_s18_q <= inside_v_s17_q[13:12] + 2'h3;
      less_1553_s18_q <= less_1553_s17_q;
      sum_1560_s18_q <= sum_1560[8:1];
      select_1561_s18_q <= select_1561[0];
      sum_1563_s18_q <= sum_1563;
      select_1565_s18_q <= select_1565[0];
      difference_1567_s18_q <= difference_1567;
      select_1617_s18_q <= select_1617_s17_q;
      select_1620_s18_q <= select_1620_s17_q;
      select_1624_s18_q <= select_1491_s17_q[0] ? select_1623 : registration_of_right_q;
      select_1651_s18_q <= select_1651;
      select_1700_s18_q <= select_1700_s17_q;
      select_1742_s18_q <= select_1742_s17_q;
      select_1783_s18_q <= select_1783_s17_q;
      select_1836_s18_q <= select_1836_s17_q;
      select_1950_s18_q <= select_1950;
      select_1978_s18_q <= select_1978;
      select_2012_s18_q <= select_2012;
      select_2043_s18_q <= select_2043;
      select_2076_s18_q <= select_2076;
      select_2107_s18_q <= select_2107;
      select_2137_s18_q <= select_2137;
      select_2166_s18_q <= select_2166_s17_q;
      or_2175_s18_q <= or_2175;
      or_2178_s18_q <= select_1528[7] | (~({select_1528[6], select_1528[3:2]} == 3'h0));
      or_2181_s18_q <= select_1528[7] | (~(select_1528[6:4] == 3'h0));
      and_2190_s18_q <= so_s17_q & (ends_cell_s17_q & (inside_v_s17_q[0] & or_2187));
      textured_s18_q <= textured_s17_q;
      explained_s18_q <= explained;
      and_2204_s18_q <= and_2204;
      seen_columns_rdata_s18_q <= {seen_columns_rdata_s17_q[13:7], seen_columns_rdata_s17_q[5:0]};
      shown_s18_q <= shown;
      near_s18_q <= near;
      and_2250_s18_q <= seen_columns_rdata_s17_q[14] & inside_v_s17_q[0];
      and_2252_s18_q <= seen_columns_rdata_s17_q[5] & inside_v_s17_q[0];
      or_2268_s18_q <= or_2268;
      or_2271_s18_q <= select_2265[7] | (~({select_2265[6], select_2265[3:2]} == 3'h0));
      or_2274_s18_q <= select_2265[7] | (~(select_2265[6:4] == 3'h0));
      and_2285_s18_q <= seen_columns_rdata_s17_q[16] & inside_v_s17_q[0];
      and_2287_s18_q <= seen_columns_rdata_s17_q[8] & inside_v_s17_q[0];
      and_2288_s18_q <= seen_columns_rdata_s17_q[3] & inside_v_s17_q[0];
      and_2301_s18_q <= seen_columns_rdata_s17_q[17] & inside_v_s17_q[0];
      and_2303_s18_q <= seen_columns_rdata_s17_q[9] & inside_v_s17_q[0];
      and_2304_s18_q <= seen_columns_rdata_s17_q[4] & inside_v_s17_q[0];
      and_2324_s18_q <= and_2324_s17_q;
      difference_2484_s18_q <= difference_2484[9];
      xor_2485_s18_q <= difference_2484[8:0] ^ {9{difference_2484[9]}};
      difference_2487_s18_q <= difference_2487[9];
      xor_2488_s18_q <= difference_2487[8:0] ^ {9{difference_2487[9]}};
      difference_2491_s18_q <= difference_2491[9];
      xor_2492_s18_q <= difference_2491[8:0] ^ {9{difference_2491[9]}};
      difference_2495_s18_q <= difference_2495[9];
      xor_2496_s18_q <= difference_2495[8:0] ^ {9{difference_2495[9]}};
      difference_2499_s18_q <= difference_2499[9];
      xor_2500_s18_q <= difference_2499[8:0] ^ {9{difference_2499[9]}};
      equal_2511_s18_q <= equal_2511_s17_q;
      select_2527_s18_q <= sample_pair_whole_s17_q ? {detail_2, detail} : 28'h0;
      and_2532_s18_q <= whole_2_s17_q & (~(column_s17_q[6:1] == 6'h0));
      difference_2533_s18_q <= difference_2533[9];
      xor_2534_s18_q <= difference_2533[8:0] ^ {9{difference_2533[9]}};
      difference_2544_s18_q <= difference_2544[9];
      xor_2545_s18_q <= difference_2544[8:0] ^ {9{difference_2544[9]}};
      equal_2565_s18_q <= equal_2565_s17_q;
      and_2651_s18_q <= seen_columns_rdata_s17_q[15] & inside_v_s17_q[0];
      and_2652_s18_q <= seen_columns_rdata_s17_q[11] & inside_v_s17_q[0];
      sum_2656_s18_q <= {1'b0, and_2653} + ({1'b0, explained} + {1'b0, and_2654});
      and_2716_s18_q <= not_1386_s17_q & (so_s17_q & (half_ends & equal_2713));
      equal_2746_s18_q <= sum_1436_s17_q == 2'h2;
      not_2747_s18_q <= ~select_1480;
      less_2865_s18_q <= less_2865_s17_q;
      select_2898_s18_q <= sum_1513_s17_q ? (equal_2186_s17_q & or_2187) : or_2187;
      and_3052_s18_q <= seen_columns_rdata_s17_q[6] & inside_v_s17_q[0];
      equal_3062_s18_q <= equal_3062_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic [3:0] registration_fresh_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic region_fresh_q;
  logic segment_starts_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  // hls/stages/agreement.hpp:310
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_s18_q & and_487_s18_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s18_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s18_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s18_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s18_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_s18_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_s18_q & whole_8;
  // hls/stages/census.hpp:190
  logic [9:0] sum_512;
  assign sum_512 = {9'h0, difference_510_s18_q} + {1'b0, xor_511_s18_q};
  logic [9:0] sum_515;
  assign sum_515 = {9'h0, difference_513_s18_q} + {1'b0, xor_514_s18_q};
  // hls/stages/registration.hpp:139
  logic all;
  assign all = x_s18_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:143
  logic or_1492;
  assign or_1492 = segment_starts_q | not_1425_s18_q;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1501;
  assign select_1501 = select_1491_s18_q[0] ? {8{region_down_next_q[8]}} : region_down_next_q[7:0];
  // hls/stages/agreement.hpp:131
  logic [2:0] sum_1529;
  assign sum_1529 = region_row_q + 3'h1;
  // hls/stages/registration.hpp:250
  logic [2:0] select_1530;
  assign select_1530 = select_1491_s18_q[0] ? next_region_row_q : sum_1529;
  logic [7:0] select_1532;
  assign select_1532 = select_1491_s18_q[2] ? select_1527_s18_q : (select_1491_s18_q[1] ? select_1528_s18_q : {5'h0, select_1530});
  // hls/stages/registration.hpp:47
  logic [7:0] difference_1555;
  assign difference_1555 = {sum_1548_s18_q, inside_v_s18_q[3], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_1556;
  assign select_1556 = less_1553_s18_q ? difference_1555 : {sum_1548_s18_q, inside_v_s18_q[3], registration_displacement_fraction_q};
  logic [7:0] select_1557;
  assign select_1557 = or_1547_s18_q ? {sum_1548_s18_q, inside_v_s18_q[3], 5'h0} : select_1556;
  // hls/stages/registration.hpp:202
  logic [10:0] sum_1564;
  assign sum_1564 = {{3{sum_1560_s18_q[7]}}, sum_1560_s18_q} + {sum_1563_s18_q[8], sum_1563_s18_q, select_1561_s18_q};
  logic [9:0] sum_1568;
  assign sum_1568 = {difference_1567_s18_q, select_1565_s18_q} + {sum_1564[10], sum_1564[10:2]};
  // hls/stages/registration.hpp:250
  logic [7:0] select_1621;
  assign select_1621 = select_1491_s18_q[2] ? select_1620_s18_q : {4'h0, registration_fresh_q};
  logic [7:0] select_1672;
  assign select_1672 = select_1491_s18_q[0] ? {6'h0, registration_displacement_over_q[9:8]} : registration_displacement_over_q[7:0];
  logic [7:0] select_1673;
  assign select_1673 = select_1491_s18_q[1] ? {3'h0, registration_displacement_fraction_q} : select_1672;
  logic [7:0] select_2168;
  assign select_2168 = select_1491_s18_q[6] ? (select_1491_s18_q[5] ? select_2076_s18_q : select_2107_s18_q) : (select_1491_s18_q[5] ? select_2137_s18_q : select_2166_s18_q);
  // hls/stages/agreement.hpp:211
  logic [5:0] select_2182;
  assign select_2182 = equal_1385_s18_q ? x_s18_q[5:0] : {region_row_q, or_2181_s18_q, or_2178_s18_q, or_2175_s18_q};
  // hls/stages/agreement.hpp:859
  logic not_2183;
  assign not_2183 = ~equal_1430_s18_q;
  // hls/stages/agreement.hpp:197
  logic and_2211;
  assign and_2211 = inside_v_s18_q[0] & inside_v_s18_q[2];
  // hls/stages/agreement.hpp:765
  logic and_2253;
  assign and_2253 = seen_columns_rdata_s18_q[0] & inside_v_s18_q[0];
  // hls/stages/agreement.hpp:818
  logic [1:0] sum_2255;
  assign sum_2255 = {1'b0, and_2252_s18_q} + ({1'b0, textured_s18_q} + {1'b0, and_2253});
  // hls/stages/agreement.hpp:765
  logic and_2286;
  assign and_2286 = seen_columns_rdata_s18_q[11] & inside_v_s18_q[0];
  // hls/stages/agreement.hpp:820
  logic [1:0] sum_2290;
  assign sum_2290 = {1'b0, and_2287_s18_q} + ({1'b0, shown_s18_q} + {1'b0, and_2288_s18_q});
  // hls/stages/agreement.hpp:765
  logic and_2302;
  assign and_2302 = seen_columns_rdata_s18_q[12] & inside_v_s18_q[0];
  // hls/stages/agreement.hpp:821
  logic [1:0] sum_2306;
  assign sum_2306 = {1'b0, and_2303_s18_q} + ({1'b0, near_s18_q} + {1'b0, and_2304_s18_q});
  // hls/stages/census.hpp:192
  logic [9:0] sum_2486;
  assign sum_2486 = {9'h0, difference_2484_s18_q} + {1'b0, xor_2485_s18_q};
  logic [9:0] sum_2489;
  assign sum_2489 = {9'h0, difference_2487_s18_q} + {1'b0, xor_2488_s18_q};
  // hls/stages/census.hpp:273
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2533_s18_q} + xor_2534_s18_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2544_s18_q} + xor_2545_s18_q;
  // hls/stages/agreement.hpp:365
  logic and_2627;
  assign and_2627 = and_418_s18_q & (equal_479_s18_q & equal_2565_s18_q);
  // hls/stages/agreement.hpp:211
  logic and_2630;
  assign and_2630 = so_s18_q & (ends_cell_s18_q & (inside_v_s18_q[0] & inside_v_s18_q[1]));
  // hls/stages/agreement.hpp:836
  logic not_2650;
  assign not_2650 = ~(x_s18_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:819
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2651_s18_q} + ({2'h0, and_2652_s18_q} + {1'b0, sum_2656_s18_q});
  // hls/stages/agreement.hpp:211
  logic and_2691;
  assign and_2691 = ends_cell_s18_q & (inside_v_s18_q[0] & (inside_v_s18_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:841
  logic and_2697;
  assign and_2697 = not_2650 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/registration.hpp:253
  logic [3:0] select_2749;
  assign select_2749 = equal_2746_s18_q ? (registration_fresh_q & not_2747_s18_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:211
  logic [3:0] select_2751;
  assign select_2751 = so_s18_q ? (and_1475_s18_q ? select_2749 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:227
  logic [3:0] select_2753;
  assign select_2753 = and_2627 ? 4'hf : (equal_1385_s18_q ? registration_fresh_q : select_2751);
  // hls/stages/agreement.hpp:314
  logic [2:0] select_2867;
  assign select_2867 = less_2865_s18_q ? (sum_1498_s18_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2869;
  assign select_2869 = equal_2565_s18_q ? (equal_479_s18_q ? 3'h0 : select_2867) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1498_s18_q;
  // hls/stages/agreement.hpp:314
  logic select_2892;
  assign select_2892 = equal_2565_s18_q ? (equal_479_s18_q | (less_2865_s18_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:211
  logic select_2900;
  assign select_2900 = ends_cell_s18_q ? (inside_v_s18_q[0] ? select_2898_s18_q : or_1492) : or_1492;
  // hls/stages/agreement.hpp:931
  logic equal_2909;
  assign equal_2909 = x_s18_q[6:3] == 4'h7;
  logic equal_2933;
  assign equal_2933 = x_s18_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:856
  logic [7:0] select_2946;
  assign select_2946 = (x_s18_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2948;
  assign select_2948 = equal_2933 ? cfg_unproven_skin_limit_i : (equal_2909 ? cfg_unproven_limit_i : select_2946);
  // hls/stages/agreement.hpp:211
  logic select_3050;
  assign select_3050 = so_s18_q ? (ends_cell_s18_q ? and_2252_s18_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3054;
  assign select_3054 = so_s18_q ? (ends_cell_s18_q ? and_3052_s18_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_3056;
  assign select_3056 = ends_cell_s18_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3058;
  assign select_3058 = equal_1385_s18_q ? centres_values_1_textured_q : (so_s18_q ? select_3056 : centres_values_1_textured_q);
  logic select_3059;
  assign select_3059 = ends_cell_s18_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3061;
  assign select_3061 = equal_1385_s18_q ? centres_values_1_of_skin_q : (so_s18_q ? select_3059 : centres_values_1_of_skin_q);

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1093; read in stage 18, written in stage 21: 18 < 21 < 18 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2182;
  logic regions_re;
  assign regions_re = s18_en & (equal_1385_s18_q ? (x_s18_q[6] & not_2183) : and_2190_s18_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s18_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s18_en & and_1420_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s18_q, near_s18_q, shown_s18_q, explained_s18_q, and_2211, textured_s18_q};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s16_sim;
  logic seen_columns_re_s16_sim;
  logic [6:0] seen_columns_raddr_s17_sim;
  logic seen_columns_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s16_sim <= 1'b0;
      seen_columns_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s16_sim <= seen_columns_re;
      seen_columns_raddr_s16_sim <= seen_columns_raddr;
      seen_columns_re_s17_sim <= seen_columns_re_s16_sim;
      seen_columns_raddr_s17_sim <= seen_columns_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s16_sim && seen_columns_raddr_s16_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s17_sim && seen_columns_raddr_s17_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 7'd120) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 7'd120) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_fresh_q <= 4'hf;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
    end else if (s18_en) begin
      registration_fresh_q <= select_2753;
      region_row_q <= and_418_s18_q ? select_2869 : region_row_q;
      next_region_row_q <= sum_1529;
      region_fresh_q <= and_418_s18_q ? select_2892 : region_fresh_q;
      segment_starts_q <= equal_1385_s18_q ? or_1492 : (so_s18_q ? select_2900 : or_1492);
      centres_values_0_textured_q <= equal_1385_s18_q ? centres_values_0_textured_q : select_3050;
      centres_values_0_of_skin_q <= equal_1385_s18_q ? centres_values_0_of_skin_q : select_3054;
      centres_values_1_textured_q <= select_3058;
      centres_values_1_of_skin_q <= select_3061;
    end
  end

  logic [7:0] pixel_0_s19_q;
  logic [7:0] pixel_1_s19_q;
  logic saturated_s19_q;
  logic mask_s19_q;
  logic marks_first_s19_q;
  logic marks_last_s19_q;
  logic census_columns_values_1_cell_2_mask_s19_q;
  logic census_columns_values_1_cell_2_of_skin_s19_q;
  logic census_columns_values_1_cell_3_mask_s19_q;
  logic census_columns_values_1_cell_4_mask_s19_q;
  logic census_columns_values_2_cell_0_mask_s19_q;
  logic census_columns_values_2_cell_1_mask_s19_q;
  logic census_columns_values_2_cell_2_mask_s19_q;
  logic census_columns_values_2_cell_3_mask_s19_q;
  logic census_columns_values_2_cell_4_mask_s19_q;
  logic census_columns_values_3_cell_0_mask_s19_q;
  logic census_columns_values_3_cell_1_mask_s19_q;
  logic census_columns_values_3_cell_2_mask_s19_q;
  logic census_columns_values_3_cell_3_mask_s19_q;
  logic census_columns_values_3_cell_4_mask_s19_q;
  logic sharpness_last_mask_s19_q;
  logic [7:0] x_s19_q;
  logic age_s19_q;
  logic [2:0] slot_s19_q;
  logic ends_cell_s19_q;
  logic lower_half_s19_q;
  logic registration_of_right_s19_q;
  logic [3:0] registration_fresh_s19_q;
  logic [2:0] region_row_s19_q;
  logic region_fresh_s19_q;
  logic centres_values_1_textured_s19_q;
  logic centres_values_1_of_skin_s19_q;
  logic [6:0] column_s19_q;
  logic and_418_s19_q;
  logic so_s19_q;
  logic less_452_s19_q;
  logic less_453_s19_q;
  logic less_454_s19_q;
  logic less_455_s19_q;
  logic less_456_s19_q;
  logic less_457_s19_q;
  logic less_458_s19_q;
  logic less_459_s19_q;
  logic less_460_s19_q;
  logic less_461_s19_q;
  logic less_462_s19_q;
  logic less_463_s19_q;
  logic less_464_s19_q;
  logic less_465_s19_q;
  logic less_466_s19_q;
  logic less_467_s19_q;
  logic less_468_s19_q;
  logic less_469_s19_q;
  logic less_470_s19_q;
  logic less_471_s19_q;
  logic less_472_s19_q;
  logic less_473_s19_q;
  logic less_474_s19_q;
  logic less_475_s19_q;
  logic equal_476_s19_q;
  logic select_481_s19_q;
  logic whole_9_s19_q;
  logic [10:0] sum_516_s19_q;
  logic [9:0] sum_519_s19_q;
  logic [9:0] sum_523_s19_q;
  logic [9:0] sum_527_s19_q;
  logic equal_1385_s19_q;
  logic not_1386_s19_q;
  logic equal_1430_s19_q;
  logic all_s19_q;
  logic [1:0] sum_1436_s19_q;
  logic equal_1444_s19_q;
  logic equal_1446_s19_q;
  logic equal_1448_s19_q;
  logic equal_1450_s19_q;
  logic and_1476_s19_q;
  logic equal_1482_s19_q;
  logic equal_1484_s19_q;
  logic [8:0] select_1491_s19_q;
  logic or_1492_s19_q;
  logic [7:0] select_1502_s19_q;
  logic [7:0] select_1519_s19_q;
  logic [7:0] select_1532_s19_q;
  logic and_1539_s19_q;
  logic equal_1542_s19_q;
  logic and_1544_s19_q;
  logic [7:0] select_1557_s19_q;
  logic sum_1564_s19_q;
  logic [9:0] sum_1568_s19_q;
  logic [7:0] select_1622_s19_q;
  logic select_1624_s19_q;
  logic [7:0] select_1651_s19_q;
  logic [7:0] select_1673_s19_q;
  logic [7:0] select_1700_s19_q;
  logic [7:0] select_1742_s19_q;
  logic [7:0] select_1783_s19_q;
  logic [7:0] select_1836_s19_q;
  logic [7:0] select_1950_s19_q;
  logic [7:0] select_1978_s19_q;
  logic [7:0] select_2044_s19_q;
  logic [7:0] select_2168_s19_q;
  logic or_2175_s19_q;
  logic or_2178_s19_q;
  logic or_2181_s19_q;
  logic not_2183_s19_q;
  logic textured_s19_q;
  logic explained_s19_q;
  logic and_2204_s19_q;
  logic and_2209_s19_q;
  logic and_2250_s19_q;
  logic and_2251_s19_q;
  logic [1:0] sum_2255_s19_q;
  logic or_2268_s19_q;
  logic or_2271_s19_q;
  logic or_2274_s19_q;
  logic and_2285_s19_q;
  logic [2:0] sum_2291_s19_q;
  logic and_2301_s19_q;
  logic [2:0] sum_2307_s19_q;
  logic and_2324_s19_q;
  logic [10:0] sum_2490_s19_q;
  logic [9:0] sum_2493_s19_q;
  logic [9:0] sum_2497_s19_q;
  logic [9:0] sum_2501_s19_q;
  logic equal_2511_s19_q;
  logic [27:0] select_2527_s19_q;
  logic and_2532_s19_q;
  logic [8:0] contrast_s19_q;
  logic [8:0] contrast_2_s19_q;
  logic equal_2565_s19_q;
  logic and_2627_s19_q;
  logic and_2631_s19_q;
  logic not_2650_s19_q;
  logic [2:0] explained_2_s19_q;
  logic and_2693_s19_q;
  logic and_2700_s19_q;
  logic and_2716_s19_q;
  logic equal_2909_s19_q;
  logic equal_2932_s19_q;
  logic equal_2933_s19_q;
  logic [7:0] select_2948_s19_q;
  logic equal_3062_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      pixel_0_s19_q <= pixel_0_s18_q;
      pixel_1_s19_q <= pixel_1_s18_q;
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= mask_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
      census_columns_values_1_cell_2_mask_s19_q <= census_columns_values_1_cell_2_mask_s18_q;
      census_columns_values_1_cell_2_of_skin_s19_q <= census_columns_values_1_cell_2_of_skin_s18_q;
      census_columns_values_1_cell_3_mask_s19_q <= census_columns_values_1_cell_3_mask_s18_q;
      census_columns_values_1_cell_4_mask_s19_q <= census_columns_values_1_cell_4_mask_s18_q;
      census_columns_values_2_cell_0_mask_s19_q <= census_columns_values_2_cell_0_mask_s18_q;
      census_columns_values_2_cell_1_mask_s19_q <= census_columns_values_2_cell_1_mask_s18_q;
      census_columns_values_2_cell_2_mask_s19_q <= census_columns_values_2_cell_2_mask_s18_q;
      census_columns_values_2_cell_3_mask_s19_q <= census_columns_values_2_cell_3_mask_s18_q;
      census_columns_values_2_cell_4_mask_s19_q <= census_columns_values_2_cell_4_mask_s18_q;
      census_columns_values_3_cell_0_mask_s19_q <= census_columns_values_3_cell_0_mask_s18_q;
      census_columns_values_3_cell_1_mask_s19_q <= census_columns_values_3_cell_1_mask_s18_q;
      census_columns_values_3_cell_2_mask_s19_q <= census_columns_values_3_cell_2_mask_s18_q;
      census_columns_values_3_cell_3_mask_s19_q <= census_columns_values_3_cell_3_mask_s18_q;
      census_columns_values_3_cell_4_mask_s19_q <= census_columns_values_3_cell_4_mask_s18_q;
      sharpness_last_mask_s19_q <= sharpness_last_mask_s18_q;
      x_s19_q <= x_s18_q;
      age_s19_q <= age_s18_q;
      slot_s19_q <= slot_s18_q;
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      registration_of_right_s19_q <= registration_of_right_s18_q;
      registration_fresh_s19_q <= registration_fresh_q;
      region_row_s19_q <= region_row_q;
      region_fresh_s19_q <= region_fresh_q;
      centres_values_1_textured_s19_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s19_q <= centres_values_1_of_skin_q;
      column_s19_q <= column_s18_q;
      and_418_s19_q <= and_418_s18_q;
      so_s19_q <= so_s18_q;
      less_452_s19_q <= less_452_s18_q;
      less_453_s19_q <= less_453_s18_q;
      less_454_s19_q <= less_454_s18_q;
      less_455_s19_q <= less_455_s18_q;
      less_456_s19_q <= less_456_s18_q;
      less_457_s19_q <= less_457_s18_q;
      less_458_s19_q <= less_458_s18_q;
      less_459_s19_q <= less_459_s18_q;
      less_460_s19_q <= less_460_s18_q;
      less_461_s19_q <= less_461_s18_q;
      less_462_s19_q <= less_462_s18_q;
      less_463_s19_q <= less_463_s18_q;
      less_464_s19_q <= less_464_s18_q;
      less_465_s19_q <= less_465_s18_q;
      less_466_s19_q <= less_466_s18_q;
      less_467_s19_q <= less_467_s18_q;
      less_468_s19_q <= less_468_s18_q;
      less_469_s19_q <= less_469_s18_q;
      less_470_s19_q <= less_470_s18_q;
      less_471_s19_q <= less_471_s18_q;
      less_472_s19_q <= less_472_s18_q;
      less_473_s19_q <= less_473_s18_q;
      less_474_s19_q <= less_474_s18_q;
      less_475_s19_q <= less_475_s18_q;
      equal_476_s19_q <= equal_476_s18_q;
      select_481_s19_q <= select_481_s18_q;
      whole_9_s19_q <= whole_9;
      sum_516_s19_q <= {1'b0, sum_512} + {1'b0, sum_515};
      sum_519_s19_q <= {9'h0, difference_517_s18_q} + {1'b0, xor_518_s18_q};
      sum_523_s19_q <= {9'h0, difference_521_s18_q} + {1'b0, xor_522_s18_q};
      sum_527_s19_q <= {9'h0, difference_525_s18_q} + {1'b0, xor_526_s18_q};
      equal_1385_s19_q <= equal_1385_s18_q;
      not_1386_s19_q <= not_1386_s18_q;
      equal_1430_s19_q <= equal_1430_s18_q;
      all_s19_q <= all;
      sum_1436_s19_q <= sum_1436_s18_q;
      equal_1444_s19_q <= x_s18_q[5:0] == 6'h3b;
      equal_1446_s19_q <= x_s18_q[5:0] == 6'h36;
      equal_1448_s19_q <= x_s18_q[5:0] == 6'h35;
      equal_1450_s19_q <= x_s18_q[5:0] == 6'h34;
      and_1476_s19_q <= so_s18_q & and_1475_s18_q;
      equal_1482_s19_q <= (registration_fresh_q & select_1480_s18_q) == 4'h0;
      equal_1484_s19_q <= equal_1484_s18_q;
      select_1491_s19_q <= select_1491_s18_q;
      or_1492_s19_q <= or_1492;
      select_1502_s19_q <= select_1491_s18_q[1] ? select_1497_s18_q : select_1501;
      select_1519_s19_q <= select_1519_s18_q;
      select_1532_s19_q <= select_1532;
      and_1539_s19_q <= and_1539_s18_q;
      equal_1542_s19_q <= equal_1542_s18_q;
      and_1544_s19_q <= and_1544_s18_q;
      select_1557_s19_q <= select_1557;
      sum_1564_s19_q <= sum_1564[1];
      sum_1568_s19_q <= sum_1568;
      select_1622_s19_q <= select_1491_s18_q[3] ? select_1617_s18_q : select_1621;
      select_1624_s19_q <= select_1624_s18_q;
      select_1651_s19_q <= select_1651_s18_q;
      select_1673_s19_q <= select_1673;
      select_1700_s19_q <= select_1700_s18_q;
      select_1742_s19_q <= select_1742_s18_q;
      select_1783_s19_q <= select_1783_s18_q;
      select_1836_s19_q <= select_1836_s18_q;
      select_1950_s19_q <= select_1950_s18_q;
      select_1978_s19_q <= select_1978_s18_q;
      select_2044_s19_q <= select_1491_s18_q[5] ? select_2012_s18_q : select_2043_s18_q;
      select_2168_s19_q <= select_2168;
      or_2175_s19_q <= or_2175_s18_q;
      or_2178_s19_q <= or_2178_s18_q;
      or_2181_s19_q <= or_2181_s18_q;
      not_2183_s19_q <= not_2183;
      textured_s19_q <= textured_s18_q;
      explained_s19_q <= explained_s18_q;
      and_2204_s19_q <= and_2204_s18_q;
      and_2209_s19_q <= not_1386_s18_q & and_2190_s18_q;
      and_2250_s19_q <= and_2250_s18_q;
      and_2251_s19_q <= seen_columns_rdata_s18_q[9] & inside_v_s18_q[0];
      sum_2255_s19_q <= sum_2255;
      or_2268_s19_q <= or_2268_s18_q;
      or_2271_s19_q <= or_2271_s18_q;
      or_2274_s19_q <= or_2274_s18_q;
      and_2285_s19_q <= and_2285_s18_q;
      sum_2291_s19_q <= {2'h0, and_2286} + {1'b0, sum_2290};
      and_2301_s19_q <= and_2301_s18_q;
      sum_2307_s19_q <= {2'h0, and_2302} + {1'b0, sum_2306};
      and_2324_s19_q <= and_2324_s18_q;
      sum_2490_s19_q <= {1'b0, sum_2486} + {1'b0, sum_2489};
      sum_2493_s19_q <= {9'h0, difference_2491_s18_q} + {1'b0, xor_2492_s18_q};
      sum_2497_s19_q <= {9'h0, difference_2495_s18_q} + {1'b0, xor_2496_s18_q};
      sum_2501_s19_q <= {9'h0, difference_2499_s18_q} + {1'b0, xor_2500_s18_q};
      equal_2511_s19_q <= equal_2511_s18_q;
      select_2527_s19_q <= select_2527_s18_q;
      and_2532_s19_q <= and_2532_s18_q;
      contrast_s19_q <= contrast;
      contrast_2_s19_q <= contrast_2;
      equal_2565_s19_q <= equal_2565_s18_q;
      and_2627_s19_q <= and_2627;
      and_2631_s19_q <= not_1386_s18_q & and_2630;
      not_2650_s19_q <= not_2650;
      explained_2_s19_q <= explained_2;
      and_2693_s19_q <= not_1386_s18_q & (so_s18_q & and_2691);
      and_2700_s19_q <= not_1386_s18_q & (so_s18_q & (ends_cell_s18_q & and_2697));
      and_2716_s19_q <= and_2716_s18_q;
      equal_2909_s19_q <= equal_2909;
      equal_2932_s19_q <= x_s18_q[6:3] == 4'h9;
      equal_2933_s19_q <= equal_2933;
      select_2948_s19_q <= select_2948;
      equal_3062_s19_q <= equal_3062_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic [13:0] counts_textured_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
  logic segment_started_q;
  logic [2:0] box_explained_columns_values_0_q;
  logic [2:0] box_explained_columns_values_1_q;
  logic [2:0] box_explained_columns_values_2_q;
  logic [2:0] box_explained_columns_values_3_q;
  logic [2:0] box_explained_columns_values_4_q;
  logic [2:0] box_shown_columns_values_0_q;
  logic [2:0] box_shown_columns_values_1_q;
  logic [2:0] box_shown_columns_values_2_q;
  logic [2:0] box_shown_columns_values_3_q;
  logic [2:0] box_shown_columns_values_4_q;
  logic [2:0] box_nearer_columns_values_0_q;
  logic [2:0] box_nearer_columns_values_1_q;
  logic [2:0] box_nearer_columns_values_2_q;
  logic [2:0] box_nearer_columns_values_3_q;
  logic [2:0] box_nearer_columns_values_4_q;
  // hls/stages/agreement.hpp:310
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_s19_q & whole_9_s19_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s19_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s19_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s19_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s19_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_s19_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_s19_q & whole_15;
  // hls/stages/census.hpp:190
  logic [10:0] sum_520;
  assign sum_520 = sum_516_s19_q + {1'b0, sum_519_s19_q};
  // hls/stages/agreement.hpp:899
  logic [1:0] quarter;
  assign quarter = x_s19_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:860
  logic [1:0] select_1433;
  assign select_1433 = x_s19_q[4] ? {x_s19_q[3], x_s19_q[0]} : {x_s19_q[0], x_s19_q[3]};
  // hls/stages/agreement.hpp:872
  logic [3:0] select_1435;
  assign select_1435 = equal_1430_s19_q ? {2'h0, quarter} : (all_s19_q ? {1'b0, x_s19_q[2:0]} : {x_s19_q[2:1], select_1433});
  // hls/stages/agreement.hpp:211
  logic [3:0] select_1437;
  assign select_1437 = equal_1385_s19_q ? select_1435 : {sum_1436_s19_q, lower_half_s19_q, registration_of_right_s19_q};
  // hls/stages/agreement.hpp:897
  logic equal_1438;
  assign equal_1438 = x_s19_q[5:0] == 6'h3e;
  logic equal_1440;
  assign equal_1440 = x_s19_q[5:0] == 6'h3d;
  logic equal_1442;
  assign equal_1442 = x_s19_q[5:0] == 6'h3c;
  // hls/stages/agreement.hpp:899
  logic and_1453;
  assign and_1453 = (~equal_1446_s19_q) & ((~equal_1448_s19_q) & (~equal_1450_s19_q));
  logic and_1456;
  assign and_1456 = (~equal_1440) & ((~equal_1442) & ((~equal_1444_s19_q) & and_1453));
  // hls/stages/agreement.hpp:860
  logic less_1458;
  assign less_1458 = x_s19_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:140
  logic [1:0] kind;
  assign kind = all_s19_q ? {1'b0, x_s19_q[2]} : x_s19_q[2:1];
  // hls/stages/registration.hpp:152
  logic or_1462;
  assign or_1462 = (kind == 2'h3) | (x_s19_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:872
  logic select_1465;
  assign select_1465 = equal_1430_s19_q ? ((~equal_1438) & and_1456) : (less_1458 & (~or_1462));
  // hls/stages/registration.hpp:250
  logic [2:0] select_1534;
  assign select_1534 = select_1491_s19_q[1] ? (select_1491_s19_q[0] ? region_row_s19_q : 3'h0) : 3'h0;
  logic [2:0] select_1535;
  assign select_1535 = select_1491_s19_q[2] ? select_1534 : 3'h0;
  // hls/stages/registration.hpp:101
  logic [11:0] value;
  assign value = {{4{select_1557_s19_q[7]}}, select_1557_s19_q} - {sum_1568_s19_q[9], sum_1568_s19_q, sum_1564_s19_q};
  // hls/stages/registration.hpp:250
  logic [7:0] select_1680;
  assign select_1680 = select_1491_s19_q[0] ? {2'h0, counts_skin_textured_q[13:8]} : counts_skin_textured_q[7:0];
  logic [7:0] select_1682;
  assign select_1682 = select_1491_s19_q[0] ? {2'h0, counts_skin_supervised_q[13:8]} : counts_skin_supervised_q[7:0];
  // hls/stages/census.hpp:328
  logic not_1840;
  assign not_1840 = ~x_s19_q[1];
  logic [2:0] select_1841;
  assign select_1841 = x_s19_q[0] ? {1'b0, not_1840, 1'b0} : {x_s19_q[1], 1'b0, not_1840};
  logic [5:0] select_1842;
  assign select_1842 = slot_s19_q[2] ? {select_1841[2], 1'b0, select_1841[1], 1'b0, select_1841[0], 1'b0} : {1'b0, select_1841[2], 1'b0, select_1841[1], 1'b0, select_1841[0]};
  logic [11:0] select_1843;
  assign select_1843 = slot_s19_q[1] ? {select_1842[5], 1'b0, select_1842[4], 1'b0, select_1842[3], 1'b0, select_1842[2], 1'b0, select_1842[1], 1'b0, select_1842[0], 1'b0} : {1'b0, select_1842[5], 1'b0, select_1842[4], 1'b0, select_1842[3], 1'b0, select_1842[2], 1'b0, select_1842[1], 1'b0, select_1842[0]};
  // hls/stages/agreement.hpp:818
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2250_s19_q} + ({2'h0, and_2251_s19_q} + {1'b0, sum_2255_s19_q});
  // hls/stages/agreement.hpp:820
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2285_s19_q} + sum_2291_s19_q;
  // hls/stages/agreement.hpp:827
  logic [2:0] select_2293;
  assign select_2293 = age_s19_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:821
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2301_s19_q} + sum_2307_s19_q;
  // hls/stages/agreement.hpp:828
  logic [2:0] select_2309;
  assign select_2309 = age_s19_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/census.hpp:192
  logic [10:0] sum_2494;
  assign sum_2494 = sum_2490_s19_q + {1'b0, sum_2493_s19_q};
  // hls/stages/agreement.hpp:311
  logic and_2538;
  assign and_2538 = and_2532_s19_q & (sharpness_last_mask_s19_q & (7'h2 < contrast_s19_q[8:2]));
  logic and_2549;
  assign and_2549 = and_2532_s19_q & (sharpness_last_mask_s19_q & (7'h2 < contrast_2_s19_q[8:2]));
  // hls/stages/agreement.hpp:211
  logic and_2636;
  assign and_2636 = not_1386_s19_q & (so_s19_q & (ends_cell_s19_q & textured_s19_q));
  // hls/stages/agreement.hpp:826
  logic [2:0] select_2659;
  assign select_2659 = age_s19_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2695;
  assign select_2695 = and_2627_s19_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2693_s19_q});
  logic [13:0] select_2702;
  assign select_2702 = and_2627_s19_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2700_s19_q});
  // hls/stages/agreement.hpp:860
  logic [1:0] quarter_2;
  assign quarter_2 = all_s19_q ? x_s19_q[1:0] : select_1433;
  // hls/stages/registration.hpp:243
  logic not_2773;
  assign not_2773 = ~quarter_2[1];
  logic [3:0] select_2774;
  assign select_2774 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2773, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2773};
  // hls/stages/agreement.hpp:937
  logic equal_2910;
  assign equal_2910 = x_s19_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:931
  logic equal_2930;
  assign equal_2930 = x_s19_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:856
  logic [7:0] limit;
  assign limit = equal_2930 ? cfg_regions_limit_i : (equal_2932_s19_q ? cfg_hidden_limit_i : select_2948_s19_q);
  // hls/stages/agreement.hpp:944
  logic not_2951;
  assign not_2951 = ~x_s19_q[2];
  logic [3:0] select_2952;
  assign select_2952 = x_s19_q[1] ? {x_s19_q[2], 1'b0, not_2951, 1'b0} : {1'b0, x_s19_q[2], 1'b0, not_2951};
  logic [7:0] select_2953;
  assign select_2953 = x_s19_q[0] ? {select_2952[3], 1'b0, select_2952[2], 1'b0, select_2952[1], 1'b0, select_2952[0], 1'b0} : {1'b0, select_2952[3], 1'b0, select_2952[2], 1'b0, select_2952[1], 1'b0, select_2952[0]};
  // hls/stages/agreement.hpp:856
  logic [13:0] select_2957;
  assign select_2957 = equal_2932_s19_q ? counts_skin_supervised_q : (equal_2933_s19_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2930 ? counts_textured_q : select_2957;
  // hls/stages/agreement.hpp:211
  logic [2:0] select_2995;
  assign select_2995 = ends_cell_s19_q ? explained_2_s19_q : box_explained_columns_values_0_q;
  logic [2:0] select_2997;
  assign select_2997 = equal_1385_s19_q ? box_explained_columns_values_0_q : (so_s19_q ? select_2995 : box_explained_columns_values_0_q);
  logic [2:0] select_2998;
  assign select_2998 = ends_cell_s19_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3000;
  assign select_3000 = equal_1385_s19_q ? box_explained_columns_values_1_q : (so_s19_q ? select_2998 : box_explained_columns_values_1_q);
  logic [2:0] select_3001;
  assign select_3001 = ends_cell_s19_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3003;
  assign select_3003 = equal_1385_s19_q ? box_explained_columns_values_2_q : (so_s19_q ? select_3001 : box_explained_columns_values_2_q);
  logic [2:0] select_3004;
  assign select_3004 = ends_cell_s19_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3006;
  assign select_3006 = equal_1385_s19_q ? box_explained_columns_values_3_q : (so_s19_q ? select_3004 : box_explained_columns_values_3_q);
  logic [2:0] select_3007;
  assign select_3007 = ends_cell_s19_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3009;
  assign select_3009 = equal_1385_s19_q ? box_explained_columns_values_4_q : (so_s19_q ? select_3007 : box_explained_columns_values_4_q);
  logic [2:0] select_3014;
  assign select_3014 = so_s19_q ? (ends_cell_s19_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3016;
  assign select_3016 = ends_cell_s19_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3018;
  assign select_3018 = equal_1385_s19_q ? box_shown_columns_values_1_q : (so_s19_q ? select_3016 : box_shown_columns_values_1_q);
  logic [2:0] select_3019;
  assign select_3019 = ends_cell_s19_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3021;
  assign select_3021 = equal_1385_s19_q ? box_shown_columns_values_2_q : (so_s19_q ? select_3019 : box_shown_columns_values_2_q);
  logic [2:0] select_3022;
  assign select_3022 = ends_cell_s19_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3024;
  assign select_3024 = equal_1385_s19_q ? box_shown_columns_values_3_q : (so_s19_q ? select_3022 : box_shown_columns_values_3_q);
  logic [2:0] select_3025;
  assign select_3025 = ends_cell_s19_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3027;
  assign select_3027 = equal_1385_s19_q ? box_shown_columns_values_4_q : (so_s19_q ? select_3025 : box_shown_columns_values_4_q);
  logic [2:0] select_3032;
  assign select_3032 = so_s19_q ? (ends_cell_s19_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3034;
  assign select_3034 = ends_cell_s19_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3036;
  assign select_3036 = equal_1385_s19_q ? box_nearer_columns_values_1_q : (so_s19_q ? select_3034 : box_nearer_columns_values_1_q);
  logic [2:0] select_3037;
  assign select_3037 = ends_cell_s19_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3039;
  assign select_3039 = equal_1385_s19_q ? box_nearer_columns_values_2_q : (so_s19_q ? select_3037 : box_nearer_columns_values_2_q);
  logic [2:0] select_3040;
  assign select_3040 = ends_cell_s19_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3042;
  assign select_3042 = equal_1385_s19_q ? box_nearer_columns_values_3_q : (so_s19_q ? select_3040 : box_nearer_columns_values_3_q);
  logic [2:0] select_3043;
  assign select_3043 = ends_cell_s19_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3045;
  assign select_3045 = equal_1385_s19_q ? box_nearer_columns_values_4_q : (so_s19_q ? select_3043 : box_nearer_columns_values_4_q);
  // hls/stages/registration.hpp:243
  logic not_3143;
  assign not_3143 = ~quarter[1];
  logic [3:0] select_3144;
  assign select_3144 = quarter[0] ? {quarter[1], 1'b0, not_3143, 1'b0} : {1'b0, quarter[1], 1'b0, not_3143};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_textured_q <= 14'h0;
      counts_skin_supervised_q <= 14'h0;
      counts_skin_textured_q <= 14'h0;
      segment_started_q <= 1'b0;
    end else if (s19_en) begin
      counts_textured_q <= and_2627_s19_q ? 14'h0 : (counts_textured_q + {13'h0, and_2636});
      counts_skin_supervised_q <= select_2695;
      counts_skin_textured_q <= select_2702;
      segment_started_q <= ~segment_starts_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    box_explained_columns_values_0_q = 3'h0;
    box_explained_columns_values_1_q = 3'h0;
    box_explained_columns_values_2_q = 3'h0;
    box_explained_columns_values_3_q = 3'h0;
    box_explained_columns_values_4_q = 3'h0;
    box_shown_columns_values_0_q = 3'h0;
    box_shown_columns_values_1_q = 3'h0;
    box_shown_columns_values_2_q = 3'h0;
    box_shown_columns_values_3_q = 3'h0;
    box_shown_columns_values_4_q = 3'h0;
    box_nearer_columns_values_0_q = 3'h0;
    box_nearer_columns_values_1_q = 3'h0;
    box_nearer_columns_values_2_q = 3'h0;
    box_nearer_columns_values_3_q = 3'h0;
    box_nearer_columns_values_4_q = 3'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s19_en) begin
      box_explained_columns_values_0_q <= select_2997;
      box_explained_columns_values_1_q <= select_3000;
      box_explained_columns_values_2_q <= select_3003;
      box_explained_columns_values_3_q <= select_3006;
      box_explained_columns_values_4_q <= select_3009;
      box_shown_columns_values_0_q <= equal_1385_s19_q ? box_shown_columns_values_0_q : select_3014;
      box_shown_columns_values_1_q <= select_3018;
      box_shown_columns_values_2_q <= select_3021;
      box_shown_columns_values_3_q <= select_3024;
      box_shown_columns_values_4_q <= select_3027;
      box_nearer_columns_values_0_q <= equal_1385_s19_q ? box_nearer_columns_values_0_q : select_3032;
      box_nearer_columns_values_1_q <= select_3036;
      box_nearer_columns_values_2_q <= select_3039;
      box_nearer_columns_values_3_q <= select_3042;
      box_nearer_columns_values_4_q <= select_3045;
    end
  end

  logic [7:0] pixel_0_s20_q;
  logic [7:0] pixel_1_s20_q;
  logic saturated_s20_q;
  logic mask_s20_q;
  logic marks_first_s20_q;
  logic marks_last_s20_q;
  logic census_columns_values_1_cell_2_mask_s20_q;
  logic census_columns_values_1_cell_2_of_skin_s20_q;
  logic census_columns_values_2_cell_4_mask_s20_q;
  logic census_columns_values_3_cell_0_mask_s20_q;
  logic census_columns_values_3_cell_1_mask_s20_q;
  logic census_columns_values_3_cell_2_mask_s20_q;
  logic census_columns_values_3_cell_3_mask_s20_q;
  logic census_columns_values_3_cell_4_mask_s20_q;
  logic [7:0] x_s20_q;
  logic age_s20_q;
  logic slot_s20_q;
  logic ends_cell_s20_q;
  logic lower_half_s20_q;
  logic [13:0] counts_textured_s20_q;
  logic registration_of_right_s20_q;
  logic [2:0] region_row_s20_q;
  logic region_fresh_s20_q;
  logic segment_started_s20_q;
  logic centres_values_1_textured_s20_q;
  logic centres_values_1_of_skin_s20_q;
  logic [6:0] column_s20_q;
  logic and_418_s20_q;
  logic so_s20_q;
  logic less_452_s20_q;
  logic less_453_s20_q;
  logic less_454_s20_q;
  logic less_455_s20_q;
  logic less_456_s20_q;
  logic less_457_s20_q;
  logic less_458_s20_q;
  logic less_459_s20_q;
  logic less_460_s20_q;
  logic less_461_s20_q;
  logic less_462_s20_q;
  logic less_463_s20_q;
  logic less_464_s20_q;
  logic less_465_s20_q;
  logic less_466_s20_q;
  logic less_467_s20_q;
  logic less_468_s20_q;
  logic less_469_s20_q;
  logic less_470_s20_q;
  logic less_471_s20_q;
  logic less_472_s20_q;
  logic less_473_s20_q;
  logic less_474_s20_q;
  logic less_475_s20_q;
  logic equal_476_s20_q;
  logic select_481_s20_q;
  logic whole_16_s20_q;
  logic [11:0] sum_524_s20_q;
  logic [9:0] sum_527_s20_q;
  logic equal_1385_s20_q;
  logic not_1386_s20_q;
  logic equal_1430_s20_q;
  logic all_s20_q;
  logic [1:0] sum_1436_s20_q;
  logic [3:0] select_1437_s20_q;
  logic equal_1438_s20_q;
  logic equal_1440_s20_q;
  logic equal_1442_s20_q;
  logic equal_1444_s20_q;
  logic equal_1446_s20_q;
  logic equal_1448_s20_q;
  logic equal_1450_s20_q;
  logic less_1458_s20_q;
  logic or_1462_s20_q;
  logic select_1465_s20_q;
  logic and_1476_s20_q;
  logic equal_1482_s20_q;
  logic equal_1484_s20_q;
  logic [8:0] select_1491_s20_q;
  logic select_1493_s20_q;
  logic [7:0] select_1502_s20_q;
  logic [7:0] select_1519_s20_q;
  logic [7:0] select_1536_s20_q;
  logic and_1539_s20_q;
  logic equal_1542_s20_q;
  logic and_1544_s20_q;
  logic [11:0] select_1571_s20_q;
  logic [7:0] select_1622_s20_q;
  logic select_1624_s20_q;
  logic [7:0] select_1651_s20_q;
  logic [7:0] select_1673_s20_q;
  logic [7:0] select_1680_s20_q;
  logic [7:0] select_1682_s20_q;
  logic [7:0] select_1700_s20_q;
  logic [7:0] select_1742_s20_q;
  logic [7:0] select_1783_s20_q;
  logic [7:0] select_1836_s20_q;
  logic equal_1838_s20_q;
  logic [11:0] select_1843_s20_q;
  logic less_1866_s20_q;
  logic [7:0] select_1950_s20_q;
  logic [7:0] select_1978_s20_q;
  logic [7:0] select_2044_s20_q;
  logic [7:0] select_2168_s20_q;
  logic or_2175_s20_q;
  logic or_2178_s20_q;
  logic or_2181_s20_q;
  logic not_2183_s20_q;
  logic [29:0] regions_rdata_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_2204_s20_q;
  logic and_2209_s20_q;
  logic [2:0] textured_2_s20_q;
  logic equal_2260_s20_q;
  logic or_2268_s20_q;
  logic or_2271_s20_q;
  logic or_2274_s20_q;
  logic [3:0] difference_2294_s20_q;
  logic [3:0] difference_2310_s20_q;
  logic and_2324_s20_q;
  logic [11:0] sum_2498_s20_q;
  logic [9:0] sum_2501_s20_q;
  logic equal_2511_s20_q;
  logic [27:0] select_2527_s20_q;
  logic and_2538_s20_q;
  logic and_2549_s20_q;
  logic [8:0] select_2556_s20_q;
  logic [8:0] select_2560_s20_q;
  logic equal_2565_s20_q;
  logic and_2627_s20_q;
  logic and_2631_s20_q;
  logic and_2636_s20_q;
  logic not_2650_s20_q;
  logic [3:0] difference_2660_s20_q;
  logic and_2716_s20_q;
  logic equal_2776_s20_q;
  logic equal_2910_s20_q;
  logic and_2911_s20_q;
  logic equal_2930_s20_q;
  logic equal_2932_s20_q;
  logic equal_2933_s20_q;
  logic equal_2955_s20_q;
  logic [13:0] of_s20_q;
  logic equal_3062_s20_q;
  logic equal_3146_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      pixel_0_s20_q <= pixel_0_s19_q;
      pixel_1_s20_q <= pixel_1_s19_q;
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= mask_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      census_columns_values_1_cell_2_mask_s20_q <= census_columns_values_1_cell_2_mask_s19_q;
      census_columns_values_1_cell_2_of_skin_s20_q <= census_columns_values_1_cell_2_of_skin_s19_q;
      census_columns_values_2_cell_4_mask_s20_q <= census_columns_values_2_cell_4_mask_s19_q;
      census_columns_values_3_cell_0_mask_s20_q <= census_columns_values_3_cell_0_mask_s19_q;
      census_columns_values_3_cell_1_mask_s20_q <= census_columns_values_3_cell_1_mask_s19_q;
      census_columns_values_3_cell_2_mask_s20_q <= census_columns_values_3_cell_2_mask_s19_q;
      census_columns_values_3_cell_3_mask_s20_q <= census_columns_values_3_cell_3_mask_s19_q;
      census_columns_values_3_cell_4_mask_s20_q <= census_columns_values_3_cell_4_mask_s19_q;
      x_s20_q <= x_s19_q;
      age_s20_q <= age_s19_q;
      slot_s20_q <= slot_s19_q[0];
      ends_cell_s20_q <= ends_cell_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      counts_textured_s20_q <= counts_textured_q;
      registration_of_right_s20_q <= registration_of_right_s19_q;
      region_row_s20_q <= region_row_s19_q;
      region_fresh_s20_q <= region_fresh_s19_q;
      segment_started_s20_q <= segment_started_q;
      centres_values_1_textured_s20_q <= centres_values_1_textured_s19_q;
      centres_values_1_of_skin_s20_q <= centres_values_1_of_skin_s19_q;
      column_s20_q <= column_s19_q;
      and_418_s20_q <= and_418_s19_q;
      so_s20_q <= so_s19_q;
      less_452_s20_q <= less_452_s19_q;
      less_453_s20_q <= less_453_s19_q;
      less_454_s20_q <= less_454_s19_q;
      less_455_s20_q <= less_455_s19_q;
      less_456_s20_q <= less_456_s19_q;
      less_457_s20_q <= less_457_s19_q;
      less_458_s20_q <= less_458_s19_q;
      less_459_s20_q <= less_459_s19_q;
      less_460_s20_q <= less_460_s19_q;
      less_461_s20_q <= less_461_s19_q;
      less_462_s20_q <= less_462_s19_q;
      less_463_s20_q <= less_463_s19_q;
      less_464_s20_q <= less_464_s19_q;
      less_465_s20_q <= less_465_s19_q;
      less_466_s20_q <= less_466_s19_q;
      less_467_s20_q <= less_467_s19_q;
      less_468_s20_q <= less_468_s19_q;
      less_469_s20_q <= less_469_s19_q;
      less_470_s20_q <= less_470_s19_q;
      less_471_s20_q <= less_471_s19_q;
      less_472_s20_q <= less_472_s19_q;
      less_473_s20_q <= less_473_s19_q;
      less_474_s20_q <= less_474_s19_q;
      less_475_s20_q <= less_475_s19_q;
      equal_476_s20_q <= equal_476_s19_q;
      select_481_s20_q <= select_481_s19_q;
      whole_16_s20_q <= whole_16;
      sum_524_s20_q <= {1'b0, sum_520} + {2'h0, sum_523_s19_q};
      sum_527_s20_q <= sum_527_s19_q;
      equal_1385_s20_q <= equal_1385_s19_q;
      not_1386_s20_q <= not_1386_s19_q;
      equal_1430_s20_q <= equal_1430_s19_q;
      all_s20_q <= all_s19_q;
      sum_1436_s20_q <= sum_1436_s19_q;
      select_1437_s20_q <= select_1437;
      equal_1438_s20_q <= equal_1438;
      equal_1440_s20_q <= equal_1440;
      equal_1442_s20_q <= equal_1442;
      equal_1444_s20_q <= equal_1444_s19_q;
      equal_1446_s20_q <= equal_1446_s19_q;
      equal_1448_s20_q <= equal_1448_s19_q;
      equal_1450_s20_q <= equal_1450_s19_q;
      less_1458_s20_q <= less_1458;
      or_1462_s20_q <= or_1462;
      select_1465_s20_q <= select_1465;
      and_1476_s20_q <= and_1476_s19_q;
      equal_1482_s20_q <= equal_1482_s19_q;
      equal_1484_s20_q <= equal_1484_s19_q;
      select_1491_s20_q <= select_1491_s19_q;
      select_1493_s20_q <= select_1491_s19_q[0] ? segment_started_q : or_1492_s19_q;
      select_1502_s20_q <= select_1502_s19_q;
      select_1519_s20_q <= select_1519_s19_q;
      select_1536_s20_q <= select_1491_s19_q[3] ? select_1532_s19_q : {5'h0, select_1535};
      and_1539_s20_q <= and_1539_s19_q;
      equal_1542_s20_q <= equal_1542_s19_q;
      and_1544_s20_q <= and_1544_s19_q;
      select_1571_s20_q <= ($signed(value[11:7]) < $signed(5'h1f)) ? 12'hf80 : value;
      select_1622_s20_q <= select_1622_s19_q;
      select_1624_s20_q <= select_1624_s19_q;
      select_1651_s20_q <= select_1651_s19_q;
      select_1673_s20_q <= select_1673_s19_q;
      select_1680_s20_q <= select_1680;
      select_1682_s20_q <= select_1682;
      select_1700_s20_q <= select_1700_s19_q;
      select_1742_s20_q <= select_1742_s19_q;
      select_1783_s20_q <= select_1783_s19_q;
      select_1836_s20_q <= select_1836_s19_q;
      equal_1838_s20_q <= {x_s19_q[4:0], slot_s19_q} == 8'h0;
      select_1843_s20_q <= select_1843;
      less_1866_s20_q <= 7'h2 < {x_s19_q[4:0], slot_s19_q[2:1]};
      select_1950_s20_q <= select_1950_s19_q;
      select_1978_s20_q <= select_1978_s19_q;
      select_2044_s20_q <= select_2044_s19_q;
      select_2168_s20_q <= select_2168_s19_q;
      or_2175_s20_q <= or_2175_s19_q;
      or_2178_s20_q <= or_2178_s19_q;
      or_2181_s20_q <= or_2181_s19_q;
      not_2183_s20_q <= not_2183_s19_q;
      regions_rdata_s20_q <= regions_rdata_q;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained_s19_q;
      and_2204_s20_q <= and_2204_s19_q;
      and_2209_s20_q <= and_2209_s19_q;
      textured_2_s20_q <= textured_2;
      equal_2260_s20_q <= x_s19_q == 8'h0;
      or_2268_s20_q <= or_2268_s19_q;
      or_2271_s20_q <= or_2271_s19_q;
      or_2274_s20_q <= or_2274_s19_q;
      difference_2294_s20_q <= {1'b0, shown_2} - {1'b0, select_2293};
      difference_2310_s20_q <= {1'b0, near_2} - {1'b0, select_2309};
      and_2324_s20_q <= and_2324_s19_q;
      sum_2498_s20_q <= {1'b0, sum_2494} + {2'h0, sum_2497_s19_q};
      sum_2501_s20_q <= sum_2501_s19_q;
      equal_2511_s20_q <= equal_2511_s19_q;
      select_2527_s20_q <= select_2527_s19_q;
      and_2538_s20_q <= and_2538;
      and_2549_s20_q <= and_2549;
      select_2556_s20_q <= and_2538 ? contrast_s19_q : 9'h0;
      select_2560_s20_q <= and_2549 ? contrast_2_s19_q : 9'h0;
      equal_2565_s20_q <= equal_2565_s19_q;
      and_2627_s20_q <= and_2627_s19_q;
      and_2631_s20_q <= and_2631_s19_q;
      and_2636_s20_q <= and_2636;
      not_2650_s20_q <= not_2650_s19_q;
      difference_2660_s20_q <= {1'b0, explained_2_s19_q} - {1'b0, select_2659};
      and_2716_s20_q <= and_2716_s19_q;
      equal_2776_s20_q <= (registration_fresh_s19_q & select_2774) == 4'h0;
      equal_2910_s20_q <= equal_2910;
      and_2911_s20_q <= equal_2909_s19_q & equal_2910;
      equal_2930_s20_q <= equal_2930;
      equal_2932_s20_q <= equal_2932_s19_q;
      equal_2933_s20_q <= equal_2933_s19_q;
      equal_2955_s20_q <= (limit & select_2953) == 8'h0;
      of_s20_q <= of;
      equal_3062_s20_q <= equal_3062_s19_q;
      equal_3146_s20_q <= (registration_fresh_s19_q & select_3144) == 4'h0;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [13:0] counts_explained_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
  logic [13:0] product_q;
  logic [2:0] box_textured_columns_values_0_q;
  logic [2:0] box_textured_columns_values_1_q;
  logic [2:0] box_textured_columns_values_2_q;
  logic [2:0] box_textured_columns_values_3_q;
  logic [2:0] box_textured_columns_values_4_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic [13:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  // hls/stages/agreement.hpp:310
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s20_q & whole_16_s20_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s20_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s20_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s20_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s20_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_s20_q & whole_21;
  // hls/stages/census.hpp:190
  logic [11:0] texture;
  assign texture = sum_524_s20_q + {2'h0, sum_527_s20_q};
  // hls/stages/agreement.hpp:211
  logic select_1477;
  assign select_1477 = equal_1385_s20_q ? (x_s20_q[6] & select_1465_s20_q) : and_1476_s20_q;
  // hls/stages/registration.hpp:250
  logic [6:0] select_1495;
  assign select_1495 = select_1491_s20_q[0] ? segment_textured_q : {6'h0, region_fresh_s20_q};
  logic [6:0] select_1496;
  assign select_1496 = select_1491_s20_q[1] ? (select_1491_s20_q[0] ? segment_nearer_q : segment_explained_q) : select_1495;
  logic [7:0] select_1504;
  assign select_1504 = select_1491_s20_q[3] ? {7'h0, select_1493_s20_q} : (select_1491_s20_q[2] ? {1'b0, select_1496} : select_1502_s20_q);
  // hls/stages/registration.hpp:206
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1571_s20_q[11:7])) ? 12'h7f : select_1571_s20_q;
  // hls/stages/census.hpp:328
  logic less_1839;
  assign less_1839 = x_s20_q[4:0] < 5'h3;
  logic [23:0] select_1844;
  assign select_1844 = slot_s20_q ? {select_1843_s20_q[11], 1'b0, select_1843_s20_q[10], 1'b0, select_1843_s20_q[9], 1'b0, select_1843_s20_q[8], 1'b0, select_1843_s20_q[7], 1'b0, select_1843_s20_q[6], 1'b0, select_1843_s20_q[5], 1'b0, select_1843_s20_q[4], 1'b0, select_1843_s20_q[3], 1'b0, select_1843_s20_q[2], 1'b0, select_1843_s20_q[1], 1'b0, select_1843_s20_q[0], 1'b0} : {1'b0, select_1843_s20_q[11], 1'b0, select_1843_s20_q[10], 1'b0, select_1843_s20_q[9], 1'b0, select_1843_s20_q[8], 1'b0, select_1843_s20_q[7], 1'b0, select_1843_s20_q[6], 1'b0, select_1843_s20_q[5], 1'b0, select_1843_s20_q[4], 1'b0, select_1843_s20_q[3], 1'b0, select_1843_s20_q[2], 1'b0, select_1843_s20_q[1], 1'b0, select_1843_s20_q[0]};
  // hls/stages/census.hpp:291
  logic and_1848;
  assign and_1848 = less_1839 & (~((sharpness_sums_contrast_0_q & select_1844) == 24'h0));
  logic and_1858;
  assign and_1858 = less_1839 & (~((sharpness_sums_contrast_1_q & select_1844) == 24'h0));
  // hls/stages/registration.hpp:250
  logic [7:0] select_1941;
  assign select_1941 = select_1491_s20_q[0] ? {2'h0, sharpness_last_detail_1_q[13:8]} : sharpness_last_detail_1_q[7:0];
  logic [7:0] select_1942;
  assign select_1942 = select_1491_s20_q[0] ? {2'h0, sharpness_last_detail_0_q[13:8]} : sharpness_last_detail_0_q[7:0];
  logic [7:0] select_1965;
  assign select_1965 = select_1491_s20_q[0] ? {4'h0, census_changes_values_1_right_q[11:8]} : census_changes_values_1_right_q[7:0];
  logic [7:0] select_1966;
  assign select_1966 = select_1491_s20_q[0] ? {4'h0, census_changes_values_1_left_q[11:8]} : census_changes_values_1_left_q[7:0];
  logic [7:0] select_1968;
  assign select_1968 = select_1491_s20_q[0] ? {4'h0, census_changes_values_0_right_q[11:8]} : census_changes_values_0_right_q[7:0];
  logic [7:0] select_1969;
  assign select_1969 = select_1491_s20_q[0] ? {4'h0, census_changes_values_0_left_q[11:8]} : census_changes_values_0_left_q[7:0];
  logic [7:0] select_1971;
  assign select_1971 = select_1491_s20_q[2] ? (select_1491_s20_q[1] ? select_1965 : select_1966) : (select_1491_s20_q[1] ? select_1968 : select_1969);
  // hls/stages/agreement.hpp:659
  logic [6:0] select_2194;
  assign select_2194 = segment_started_s20_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:660
  logic [6:0] sum_2195;
  assign sum_2195 = {6'h0, textured_s20_q} + select_2194;
  // hls/stages/agreement.hpp:792
  logic [9:0] sum_2197;
  assign sum_2197 = {3'h0, sum_2195} + (region_fresh_s20_q ? 10'h0 : regions_rdata_s20_q[9:0]);
  // hls/stages/agreement.hpp:659
  logic [6:0] select_2199;
  assign select_2199 = segment_started_s20_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:660
  logic [6:0] sum_2200;
  assign sum_2200 = {6'h0, explained_s20_q} + select_2199;
  // hls/stages/agreement.hpp:793
  logic [9:0] sum_2202;
  assign sum_2202 = {3'h0, sum_2200} + (region_fresh_s20_q ? 10'h0 : regions_rdata_s20_q[19:10]);
  // hls/stages/agreement.hpp:659
  logic [6:0] select_2205;
  assign select_2205 = segment_started_s20_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:661
  logic [6:0] sum_2206;
  assign sum_2206 = {6'h0, and_2204_s20_q} + select_2205;
  // hls/stages/agreement.hpp:794
  logic [9:0] sum_2208;
  assign sum_2208 = {3'h0, sum_2206} + (region_fresh_s20_q ? 10'h0 : regions_rdata_s20_q[29:20]);
  // hls/stages/agreement.hpp:984
  logic or_2218;
  assign or_2218 = marks_first_s20_q | line_ended_q;
  // hls/stages/agreement.hpp:986
  logic [13:0] select_2220;
  assign select_2220 = marks_first_s20_q ? 14'h1 : (or_2218 ? {rows_passed_q[12:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:985
  logic [8:0] select_2222;
  assign select_2222 = or_2218 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:993
  logic select_2224;
  assign select_2224 = cfg_compete_i ? (or_2218 & select_2220[13]) : (select_2222[8] & select_2220[9]);
  // hls/stages/agreement.hpp:825
  logic [2:0] select_2258;
  assign select_2258 = age_s20_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:827
  logic [4:0] around;
  assign around = {difference_2294_s20_q[3], difference_2294_s20_q} + (equal_2260_s20_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:828
  logic [4:0] n;
  assign n = {difference_2310_s20_q[3], difference_2310_s20_q} + (equal_2260_s20_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:192
  logic [11:0] sum_2502;
  assign sum_2502 = sum_2498_s20_q + {2'h0, sum_2501_s20_q};
  // hls/stages/agreement.hpp:365
  logic [11:0] select_2504;
  assign select_2504 = and_418_s20_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2505;
  assign select_2505 = and_418_s20_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_2528;
  assign select_2528 = and_418_s20_q ? select_2527_s20_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2529;
  assign select_2529 = and_418_s20_q ? select_2527_s20_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2527_s20_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2527_s20_q[27:14]};
  // hls/stages/census.hpp:277
  logic [23:0] sum_2557;
  assign sum_2557 = (equal_2511_s20_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2556_s20_q};
  logic [23:0] sum_2561;
  assign sum_2561 = (equal_2511_s20_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2560_s20_q};
  // hls/stages/agreement.hpp:211
  logic and_2641;
  assign and_2641 = not_1386_s20_q & (so_s20_q & (ends_cell_s20_q & explained_s20_q));
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2643;
  assign select_2643 = and_2627_s20_q ? 14'h0 : (counts_explained_q + {13'h0, and_2641});
  // hls/stages/agreement.hpp:211
  logic and_2646;
  assign and_2646 = not_1386_s20_q & (so_s20_q & (ends_cell_s20_q & and_2204_s20_q));
  // hls/stages/agreement.hpp:826
  logic [4:0] e;
  assign e = {difference_2660_s20_q[3], difference_2660_s20_q} + (equal_2260_s20_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:862
  logic less_2675;
  assign less_2675 = region_row_s20_q < x_s20_q[5:3];
  // hls/stages/agreement.hpp:944
  logic [13:0] select_2944;
  assign select_2944 = equal_2910_s20_q ? 14'h0 : product_q;
  logic [13:0] select_2959;
  assign select_2959 = equal_2955_s20_q ? 14'h0 : of_s20_q;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2944} + {1'b0, select_2959};
  // hls/stages/agreement.hpp:211
  logic [2:0] select_2977;
  assign select_2977 = ends_cell_s20_q ? textured_2_s20_q : box_textured_columns_values_0_q;
  logic [2:0] select_2979;
  assign select_2979 = equal_1385_s20_q ? box_textured_columns_values_0_q : (so_s20_q ? select_2977 : box_textured_columns_values_0_q);
  logic [2:0] select_2980;
  assign select_2980 = ends_cell_s20_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2982;
  assign select_2982 = equal_1385_s20_q ? box_textured_columns_values_1_q : (so_s20_q ? select_2980 : box_textured_columns_values_1_q);
  logic [2:0] select_2983;
  assign select_2983 = ends_cell_s20_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2985;
  assign select_2985 = equal_1385_s20_q ? box_textured_columns_values_2_q : (so_s20_q ? select_2983 : box_textured_columns_values_2_q);
  logic [2:0] select_2986;
  assign select_2986 = ends_cell_s20_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2988;
  assign select_2988 = equal_1385_s20_q ? box_textured_columns_values_3_q : (so_s20_q ? select_2986 : box_textured_columns_values_3_q);
  logic [2:0] select_2989;
  assign select_2989 = ends_cell_s20_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2991;
  assign select_2991 = equal_1385_s20_q ? box_textured_columns_values_4_q : (so_s20_q ? select_2989 : box_textured_columns_values_4_q);
  logic [4:0] select_3011;
  assign select_3011 = so_s20_q ? (ends_cell_s20_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3012;
  assign select_3012 = equal_1385_s20_q ? box_explained_sum_sums_values_0_q : select_3011;
  logic [4:0] select_3029;
  assign select_3029 = so_s20_q ? (ends_cell_s20_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_3047;
  assign select_3047 = so_s20_q ? (ends_cell_s20_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:260; read in stage 20, written in stage 27: 20 < 27 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1437_s20_q;
  logic registration_sums_re;
  assign registration_sums_re = s20_en & select_1477;
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      counts_explained_q <= 14'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 14'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s20_en) begin
      sharpness_sums_contrast_0_q <= and_418_s20_q ? sum_2557 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_418_s20_q ? sum_2561 : sharpness_sums_contrast_1_q;
      counts_explained_q <= select_2643;
      segment_textured_q <= select_2194 + {6'h0, and_2636_s20_q};
      segment_explained_q <= select_2199 + {6'h0, and_2641};
      segment_nearer_q <= select_2205 + {6'h0, and_2646};
      product_q <= equal_1385_s20_q ? sum_3[14:1] : product_q;
      rows_passed_q <= select_2220;
      columns_passed_q <= {select_2222[7:0], or_2218};
      line_ended_q <= marks_last_s20_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_changes_values_0_left_q = 12'h0;
    census_changes_values_0_right_q = 12'h0;
    census_changes_values_1_left_q = 12'h0;
    census_changes_values_1_right_q = 12'h0;
    sharpness_last_detail_0_q = 14'h0;
    sharpness_last_detail_1_q = 14'h0;
    box_textured_columns_values_0_q = 3'h0;
    box_textured_columns_values_1_q = 3'h0;
    box_textured_columns_values_2_q = 3'h0;
    box_textured_columns_values_3_q = 3'h0;
    box_textured_columns_values_4_q = 3'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_shown_sum_sums_values_0_q = 5'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s20_en) begin
      census_changes_values_0_left_q <= and_418_s20_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_418_s20_q ? sum_2502 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2504;
      census_changes_values_1_right_q <= select_2505;
      sharpness_last_detail_0_q <= select_2528;
      sharpness_last_detail_1_q <= select_2529;
      box_textured_columns_values_0_q <= select_2979;
      box_textured_columns_values_1_q <= select_2982;
      box_textured_columns_values_2_q <= select_2985;
      box_textured_columns_values_3_q <= select_2988;
      box_textured_columns_values_4_q <= select_2991;
      box_explained_sum_sums_values_0_q <= select_3012;
      box_shown_sum_sums_values_0_q <= equal_1385_s20_q ? box_shown_sum_sums_values_0_q : select_3029;
      box_nearer_sum_sums_values_0_q <= equal_1385_s20_q ? box_nearer_sum_sums_values_0_q : select_3047;
    end
  end

  logic [7:0] pixel_0_s21_q;
  logic [7:0] pixel_1_s21_q;
  logic saturated_s21_q;
  logic mask_s21_q;
  logic marks_first_s21_q;
  logic census_columns_values_1_cell_2_mask_s21_q;
  logic census_columns_values_1_cell_2_of_skin_s21_q;
  logic [11:0] census_changes_values_1_left_s21_q;
  logic [11:0] census_changes_values_1_right_s21_q;
  logic [23:0] sharpness_sums_contrast_0_s21_q;
  logic [23:0] sharpness_sums_contrast_1_s21_q;
  logic [7:0] x_s21_q;
  logic ends_cell_s21_q;
  logic lower_half_s21_q;
  logic [13:0] counts_textured_s21_q;
  logic [13:0] counts_explained_s21_q;
  logic registration_of_right_s21_q;
  logic [2:0] region_row_s21_q;
  logic [13:0] product_s21_q;
  logic centres_values_1_textured_s21_q;
  logic centres_values_1_of_skin_s21_q;
  logic [6:0] column_s21_q;
  logic and_418_s21_q;
  logic so_s21_q;
  logic less_452_s21_q;
  logic less_453_s21_q;
  logic less_454_s21_q;
  logic less_455_s21_q;
  logic less_456_s21_q;
  logic less_457_s21_q;
  logic less_458_s21_q;
  logic less_459_s21_q;
  logic less_460_s21_q;
  logic less_461_s21_q;
  logic less_462_s21_q;
  logic less_463_s21_q;
  logic less_464_s21_q;
  logic less_465_s21_q;
  logic less_466_s21_q;
  logic less_467_s21_q;
  logic less_468_s21_q;
  logic less_469_s21_q;
  logic less_470_s21_q;
  logic less_471_s21_q;
  logic less_472_s21_q;
  logic less_473_s21_q;
  logic less_474_s21_q;
  logic less_475_s21_q;
  logic equal_476_s21_q;
  logic select_481_s21_q;
  logic whole_22_s21_q;
  logic [12:0] sum_529_s21_q;
  logic equal_1385_s21_q;
  logic not_1386_s21_q;
  logic equal_1430_s21_q;
  logic all_s21_q;
  logic [1:0] sum_1436_s21_q;
  logic equal_1438_s21_q;
  logic equal_1440_s21_q;
  logic equal_1442_s21_q;
  logic equal_1444_s21_q;
  logic equal_1446_s21_q;
  logic equal_1448_s21_q;
  logic equal_1450_s21_q;
  logic less_1458_s21_q;
  logic or_1462_s21_q;
  logic equal_1482_s21_q;
  logic equal_1484_s21_q;
  logic [8:0] select_1491_s21_q;
  logic [7:0] select_1520_s21_q;
  logic [7:0] select_1536_s21_q;
  logic and_1539_s21_q;
  logic equal_1542_s21_q;
  logic and_1544_s21_q;
  logic [11:0] residual_s21_q;
  logic [7:0] select_1622_s21_q;
  logic select_1624_s21_q;
  logic [7:0] select_1651_s21_q;
  logic [7:0] select_1673_s21_q;
  logic [7:0] select_1680_s21_q;
  logic [7:0] select_1682_s21_q;
  logic [7:0] select_1700_s21_q;
  logic [7:0] select_1742_s21_q;
  logic [7:0] select_1783_s21_q;
  logic [7:0] select_1836_s21_q;
  logic equal_1838_s21_q;
  logic and_1848_s21_q;
  logic and_1858_s21_q;
  logic less_1866_s21_q;
  logic [7:0] select_1943_s21_q;
  logic [7:0] select_1950_s21_q;
  logic [7:0] select_1979_s21_q;
  logic [7:0] select_2044_s21_q;
  logic [7:0] select_2168_s21_q;
  logic and_2172_s21_q;
  logic or_2175_s21_q;
  logic or_2178_s21_q;
  logic or_2181_s21_q;
  logic not_2183_s21_q;
  logic [9:0] sum_2197_s21_q;
  logic [9:0] sum_2202_s21_q;
  logic [9:0] sum_2208_s21_q;
  logic and_2209_s21_q;
  logic select_2224_s21_q;
  logic [3:0] difference_2259_s21_q;
  logic equal_2260_s21_q;
  logic or_2268_s21_q;
  logic or_2271_s21_q;
  logic or_2274_s21_q;
  logic [4:0] around_s21_q;
  logic less_2313_s21_q;
  logic and_2324_s21_q;
  logic equal_2511_s21_q;
  logic [12:0] sum_2512_s21_q;
  logic [12:0] select_2540_s21_q;
  logic [12:0] select_2551_s21_q;
  logic equal_2565_s21_q;
  logic and_2627_s21_q;
  logic and_2631_s21_q;
  logic and_2646_s21_q;
  logic not_2650_s21_q;
  logic [4:0] e_s21_q;
  logic [9:0] select_2676_s21_q;
  logic [9:0] select_2679_s21_q;
  logic and_2716_s21_q;
  logic equal_2776_s21_q;
  logic equal_2910_s21_q;
  logic and_2911_s21_q;
  logic less_2912_s21_q;
  logic equal_2913_s21_q;
  logic equal_2930_s21_q;
  logic equal_2932_s21_q;
  logic equal_2933_s21_q;
  logic sum_3_s21_q;
  logic equal_3062_s21_q;
  logic equal_3146_s21_q;
  logic [9:0] select_3155_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= pixel_0_s20_q;
      pixel_1_s21_q <= pixel_1_s20_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= mask_s20_q;
      marks_first_s21_q <= marks_first_s20_q;
      census_columns_values_1_cell_2_mask_s21_q <= census_columns_values_1_cell_2_mask_s20_q;
      census_columns_values_1_cell_2_of_skin_s21_q <= census_columns_values_1_cell_2_of_skin_s20_q;
      census_changes_values_1_left_s21_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s21_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s21_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s21_q <= sharpness_sums_contrast_1_q;
      x_s21_q <= x_s20_q;
      ends_cell_s21_q <= ends_cell_s20_q;
      lower_half_s21_q <= lower_half_s20_q;
      counts_textured_s21_q <= counts_textured_s20_q;
      counts_explained_s21_q <= counts_explained_q;
      registration_of_right_s21_q <= registration_of_right_s20_q;
      region_row_s21_q <= region_row_s20_q;
      product_s21_q <= product_q;
      centres_values_1_textured_s21_q <= centres_values_1_textured_s20_q;
      centres_values_1_of_skin_s21_q <= centres_values_1_of_skin_s20_q;
      column_s21_q <= column_s20_q;
      and_418_s21_q <= and_418_s20_q;
      so_s21_q <= so_s20_q;
      less_452_s21_q <= less_452_s20_q;
      less_453_s21_q <= less_453_s20_q;
      less_454_s21_q <= less_454_s20_q;
      less_455_s21_q <= less_455_s20_q;
      less_456_s21_q <= less_456_s20_q;
      less_457_s21_q <= less_457_s20_q;
      less_458_s21_q <= less_458_s20_q;
      less_459_s21_q <= less_459_s20_q;
      less_460_s21_q <= less_460_s20_q;
      less_461_s21_q <= less_461_s20_q;
      less_462_s21_q <= less_462_s20_q;
      less_463_s21_q <= less_463_s20_q;
      less_464_s21_q <= less_464_s20_q;
      less_465_s21_q <= less_465_s20_q;
      less_466_s21_q <= less_466_s20_q;
      less_467_s21_q <= less_467_s20_q;
      less_468_s21_q <= less_468_s20_q;
      less_469_s21_q <= less_469_s20_q;
      less_470_s21_q <= less_470_s20_q;
      less_471_s21_q <= less_471_s20_q;
      less_472_s21_q <= less_472_s20_q;
      less_473_s21_q <= less_473_s20_q;
      less_474_s21_q <= less_474_s20_q;
      less_475_s21_q <= less_475_s20_q;
      equal_476_s21_q <= equal_476_s20_q;
      select_481_s21_q <= select_481_s20_q;
      whole_22_s21_q <= whole_22;
      sum_529_s21_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1385_s21_q <= equal_1385_s20_q;
      not_1386_s21_q <= not_1386_s20_q;
      equal_1430_s21_q <= equal_1430_s20_q;
      all_s21_q <= all_s20_q;
      sum_1436_s21_q <= sum_1436_s20_q;
      equal_1438_s21_q <= equal_1438_s20_q;
      equal_1440_s21_q <= equal_1440_s20_q;
      equal_1442_s21_q <= equal_1442_s20_q;
      equal_1444_s21_q <= equal_1444_s20_q;
      equal_1446_s21_q <= equal_1446_s20_q;
      equal_1448_s21_q <= equal_1448_s20_q;
      equal_1450_s21_q <= equal_1450_s20_q;
      less_1458_s21_q <= less_1458_s20_q;
      or_1462_s21_q <= or_1462_s20_q;
      equal_1482_s21_q <= equal_1482_s20_q;
      equal_1484_s21_q <= equal_1484_s20_q;
      select_1491_s21_q <= select_1491_s20_q;
      select_1520_s21_q <= select_1491_s20_q[4] ? select_1504 : select_1519_s20_q;
      select_1536_s21_q <= select_1536_s20_q;
      and_1539_s21_q <= and_1539_s20_q;
      equal_1542_s21_q <= equal_1542_s20_q;
      and_1544_s21_q <= and_1544_s20_q;
      residual_s21_q <= residual;
      select_1622_s21_q <= select_1622_s20_q;
      select_1624_s21_q <= select_1624_s20_q;
      select_1651_s21_q <= select_1651_s20_q;
      select_1673_s21_q <= select_1673_s20_q;
      select_1680_s21_q <= select_1680_s20_q;
      select_1682_s21_q <= select_1682_s20_q;
      select_1700_s21_q <= select_1700_s20_q;
      select_1742_s21_q <= select_1742_s20_q;
      select_1783_s21_q <= select_1783_s20_q;
      select_1836_s21_q <= select_1836_s20_q;
      equal_1838_s21_q <= equal_1838_s20_q;
      and_1848_s21_q <= and_1848;
      and_1858_s21_q <= and_1858;
      less_1866_s21_q <= less_1866_s20_q;
      select_1943_s21_q <= select_1491_s20_q[1] ? select_1941 : select_1942;
      select_1950_s21_q <= select_1950_s20_q;
      select_1979_s21_q <= select_1491_s20_q[3] ? select_1971 : select_1978_s20_q;
      select_2044_s21_q <= select_2044_s20_q;
      select_2168_s21_q <= select_2168_s20_q;
      and_2172_s21_q <= not_1386_s20_q & and_1476_s20_q;
      or_2175_s21_q <= or_2175_s20_q;
      or_2178_s21_q <= or_2178_s20_q;
      or_2181_s21_q <= or_2181_s20_q;
      not_2183_s21_q <= not_2183_s20_q;
      sum_2197_s21_q <= sum_2197;
      sum_2202_s21_q <= sum_2202;
      sum_2208_s21_q <= sum_2208;
      and_2209_s21_q <= and_2209_s20_q;
      select_2224_s21_q <= select_2224;
      difference_2259_s21_q <= {1'b0, textured_2_s20_q} - {1'b0, select_2258};
      equal_2260_s21_q <= equal_2260_s20_q;
      or_2268_s21_q <= or_2268_s20_q;
      or_2271_s21_q <= or_2271_s20_q;
      or_2274_s21_q <= or_2274_s20_q;
      around_s21_q <= around;
      less_2313_s21_q <= {1'b0, around[4:1]} < n;
      and_2324_s21_q <= and_2324_s20_q;
      equal_2511_s21_q <= equal_2511_s20_q;
      sum_2512_s21_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2502};
      select_2540_s21_q <= and_2538_s20_q ? detail_3[14:2] : 13'h0;
      select_2551_s21_q <= and_2549_s20_q ? detail_4[14:2] : 13'h0;
      equal_2565_s21_q <= equal_2565_s20_q;
      and_2627_s21_q <= and_2627_s20_q;
      and_2631_s21_q <= and_2631_s20_q;
      and_2646_s21_q <= and_2646;
      not_2650_s21_q <= not_2650_s20_q;
      e_s21_q <= e;
      select_2676_s21_q <= less_2675 ? 10'h0 : regions_rdata_s20_q[9:0];
      select_2679_s21_q <= less_2675 ? 10'h0 : regions_rdata_s20_q[19:10];
      and_2716_s21_q <= and_2716_s20_q;
      equal_2776_s21_q <= equal_2776_s20_q;
      equal_2910_s21_q <= equal_2910_s20_q;
      and_2911_s21_q <= and_2911_s20_q;
      less_2912_s21_q <= counts_explained_q < product_q;
      equal_2913_s21_q <= counts_explained_q == product_q;
      equal_2930_s21_q <= equal_2930_s20_q;
      equal_2932_s21_q <= equal_2932_s20_q;
      equal_2933_s21_q <= equal_2933_s20_q;
      sum_3_s21_q <= sum_3[0];
      equal_3062_s21_q <= equal_3062_s20_q;
      equal_3146_s21_q <= equal_3146_s20_q;
      select_3155_s21_q <= less_2675 ? 10'h0 : regions_rdata_s20_q[29:20];
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [11:0] census_changes_values_3_left_q;
  logic [11:0] census_changes_values_3_right_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [13:0] counts_supervised_q;
  logic product_rest_q;
  logic disagree_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic began_q;
  logic [3:0] seen_x_q;
  logic [3:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/census.hpp:201
  logic [13:0] sum_530;
  assign sum_530 = {2'h0, census_changes_values_1_left_s21_q} + {1'b0, sum_529_s21_q};
  logic [13:0] sum_531;
  assign sum_531 = {2'h0, census_changes_values_2_left_q} + sum_530;
  // hls/stages/registration.hpp:193
  logic [12:0] difference_1574;
  assign difference_1574 = 13'h0 - {residual_s21_q[11], residual_s21_q};
  logic less_1575;
  assign less_1575 = $signed(difference_1574) < $signed({7'h0, cfg_moved_half_limit_i});
  logic less_1578;
  assign less_1578 = $signed(residual_s21_q[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  logic less_1586;
  assign less_1586 = $signed(residual_s21_q[7:0]) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/registration.hpp:106
  logic [7:0] select_1592;
  assign select_1592 = equal_1542_s21_q ? (and_1544_s21_q ? residual_s21_q[7:0] : 8'h0) : 8'h0;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1694;
  assign select_1694 = select_1491_s21_q[0] ? {2'h0, counts_supervised_q[13:8]} : counts_supervised_q[7:0];
  // hls/stages/census.hpp:296
  logic [17:0] select_1868;
  assign select_1868 = (less_1866_s21_q & and_1858_s21_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_1879;
  assign select_1879 = (less_1866_s21_q & and_1848_s21_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1939;
  assign select_1939 = select_1491_s21_q[0] ? sharpness_sums_detail_0_q[15:8] : sharpness_sums_detail_0_q[7:0];
  logic [7:0] select_1940;
  assign select_1940 = select_1491_s21_q[1] ? (select_1491_s21_q[0] ? 8'h0 : sharpness_sums_detail_0_q[23:16]) : select_1939;
  logic [7:0] select_1951;
  assign select_1951 = select_1491_s21_q[3] ? (select_1491_s21_q[2] ? select_1940 : select_1943_s21_q) : select_1950_s21_q;
  logic [7:0] select_1957;
  assign select_1957 = select_1491_s21_q[0] ? {4'h0, census_changes_values_3_right_q[11:8]} : census_changes_values_3_right_q[7:0];
  logic [7:0] select_1958;
  assign select_1958 = select_1491_s21_q[0] ? {4'h0, census_changes_values_3_left_q[11:8]} : census_changes_values_3_left_q[7:0];
  logic [7:0] select_1960;
  assign select_1960 = select_1491_s21_q[0] ? {4'h0, census_changes_values_2_right_q[11:8]} : census_changes_values_2_right_q[7:0];
  logic [7:0] select_1961;
  assign select_1961 = select_1491_s21_q[0] ? {4'h0, census_changes_values_2_left_q[11:8]} : census_changes_values_2_left_q[7:0];
  logic [7:0] select_1963;
  assign select_1963 = select_1491_s21_q[2] ? (select_1491_s21_q[1] ? select_1957 : select_1958) : (select_1491_s21_q[1] ? select_1960 : select_1961);
  // hls/stages/agreement.hpp:218
  logic next_row;
  assign next_row = select_2224_s21_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1000
  logic [6:0] select_2227;
  assign select_2227 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1010
  logic equal_2230;
  assign equal_2230 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:983
  logic not_2237;
  assign not_2237 = ~marks_first_s21_q;
  // hls/stages/agreement.hpp:825
  logic [4:0] t;
  assign t = {difference_2259_s21_q[3], difference_2259_s21_q} + (equal_2260_s21_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:832
  logic not_2275;
  assign not_2275 = ~region_row_s21_q[2];
  logic [2:0] select_2276;
  assign select_2276 = region_row_s21_q[1] ? {1'b0, not_2275, 1'b0} : {region_row_s21_q[2], 1'b0, not_2275};
  logic [5:0] select_2277;
  assign select_2277 = region_row_s21_q[0] ? {select_2276[2], 1'b0, select_2276[1], 1'b0, select_2276[0], 1'b0} : {1'b0, select_2276[2], 1'b0, select_2276[1], 1'b0, select_2276[0]};
  logic [11:0] select_2278;
  assign select_2278 = or_2274_s21_q ? {select_2277[5], 1'b0, select_2277[4], 1'b0, select_2277[3], 1'b0, select_2277[2], 1'b0, select_2277[1], 1'b0, select_2277[0], 1'b0} : {1'b0, select_2277[5], 1'b0, select_2277[4], 1'b0, select_2277[3], 1'b0, select_2277[2], 1'b0, select_2277[1], 1'b0, select_2277[0]};
  logic [23:0] select_2279;
  assign select_2279 = or_2271_s21_q ? {select_2278[11], 1'b0, select_2278[10], 1'b0, select_2278[9], 1'b0, select_2278[8], 1'b0, select_2278[7], 1'b0, select_2278[6], 1'b0, select_2278[5], 1'b0, select_2278[4], 1'b0, select_2278[3], 1'b0, select_2278[2], 1'b0, select_2278[1], 1'b0, select_2278[0], 1'b0} : {1'b0, select_2278[11], 1'b0, select_2278[10], 1'b0, select_2278[9], 1'b0, select_2278[8], 1'b0, select_2278[7], 1'b0, select_2278[6], 1'b0, select_2278[5], 1'b0, select_2278[4], 1'b0, select_2278[3], 1'b0, select_2278[2], 1'b0, select_2278[1], 1'b0, select_2278[0]};
  // hls/stages/agreement.hpp:834
  logic [5:0] sum_2297;
  assign sum_2297 = {1'b0, around_s21_q} + {2'h0, around_s21_q[4:1]};
  // hls/stages/agreement.hpp:365
  logic [11:0] select_2506;
  assign select_2506 = and_418_s21_q ? census_changes_values_1_left_s21_q : census_changes_values_2_left_q;
  logic [11:0] select_2507;
  assign select_2507 = and_418_s21_q ? census_changes_values_1_right_s21_q : census_changes_values_2_right_q;
  logic [11:0] select_2508;
  assign select_2508 = and_418_s21_q ? census_changes_values_2_left_q : census_changes_values_3_left_q;
  logic [11:0] select_2509;
  assign select_2509 = and_418_s21_q ? census_changes_values_2_right_q : census_changes_values_3_right_q;
  // hls/stages/census.hpp:202
  logic [13:0] sum_2513;
  assign sum_2513 = {2'h0, census_changes_values_1_right_s21_q} + {1'b0, sum_2512_s21_q};
  logic [13:0] sum_2514;
  assign sum_2514 = {2'h0, census_changes_values_2_right_q} + sum_2513;
  // hls/stages/census.hpp:277
  logic [23:0] select_2542;
  assign select_2542 = equal_2511_s21_q ? {11'h0, select_2540_s21_q} : (sharpness_sums_detail_0_q + {11'h0, select_2540_s21_q});
  logic [23:0] select_2553;
  assign select_2553 = equal_2511_s21_q ? {11'h0, select_2551_s21_q} : (sharpness_sums_detail_1_q + {11'h0, select_2551_s21_q});
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2633;
  assign select_2633 = and_2627_s21_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2631_s21_q});
  // hls/stages/agreement.hpp:833
  logic [5:0] sum_2663;
  assign sum_2663 = {1'b0, e_s21_q} + {2'h0, e_s21_q[4:1]};
  // hls/stages/agreement.hpp:909
  logic or_2907;
  assign or_2907 = ({counts_textured_s21_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s21_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:940
  logic too_little;
  assign too_little = less_2912_s21_q | (product_rest_q & equal_2913_s21_q);
  // hls/stages/agreement.hpp:941
  logic select_2916;
  assign select_2916 = and_2911_s21_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:865
  logic [10:0] sum_2919;
  assign sum_2919 = {1'b0, select_2679_s21_q} + {2'h0, select_2679_s21_q[9:1]};
  // hls/stages/agreement.hpp:211
  logic select_2964;
  assign select_2964 = equal_1385_s21_q ? (equal_2910_s21_q ? sum_3_s21_q : (product_rest_q | sum_3_s21_q)) : product_rest_q;
  logic [4:0] select_2993;
  assign select_2993 = so_s21_q ? (ends_cell_s21_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_2994;
  assign select_2994 = equal_1385_s21_q ? box_textured_sum_sums_values_0_q : select_2993;
  // hls/stages/agreement.hpp:1009
  logic [3:0] select_3079;
  assign select_3079 = select_2224_s21_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:218
  logic [7:0] select_3085;
  assign select_3085 = marks_first_s21_q ? (less_3081 ? {sum_3082, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s21_q, or_2181_s21_q, or_2178_s21_q, or_2175_s21_q};
  logic regions_we;
  assign regions_we = s21_en & and_2209_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2208_s21_q, sum_2202_s21_q, sum_2197_s21_q};
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
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      counts_supervised_q <= 14'h0;
      product_rest_q <= 1'b0;
      disagree_q <= 1'b0;
      began_q <= 1'b0;
      seen_x_q <= 4'h0;
      seen_y_q <= 4'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 13'h0;
    end else if (s21_en) begin
      sharpness_sums_detail_0_q <= and_418_s21_q ? select_2542 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_418_s21_q ? select_2553 : sharpness_sums_detail_1_q;
      counts_supervised_q <= select_2633;
      product_rest_q <= select_2964;
      disagree_q <= equal_1385_s21_q ? select_2916 : disagree_q;
      began_q <= not_2237 & (began_q | select_2224_s21_q);
      seen_x_q <= select_2224_s21_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s21_q ? 4'h0 : select_3079;
      seen_column_q <= select_2224_s21_q ? 8'h0 : (seen_column_q + {7'h0, equal_2230});
      seen_rows_left_q <= select_3085;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s21_q ? 13'h0 : (seen_base_q + {6'h0, select_2227});
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_changes_values_2_left_q = 12'h0;
    census_changes_values_2_right_q = 12'h0;
    census_changes_values_3_left_q = 12'h0;
    census_changes_values_3_right_q = 12'h0;
    box_textured_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s21_en) begin
      census_changes_values_2_left_q <= select_2506;
      census_changes_values_2_right_q <= select_2507;
      census_changes_values_3_left_q <= select_2508;
      census_changes_values_3_right_q <= select_2509;
      box_textured_sum_sums_values_0_q <= select_2994;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic census_columns_values_1_cell_2_mask_s22_q;
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic [23:0] sharpness_sums_detail_0_s22_q;
  logic [23:0] sharpness_sums_detail_1_s22_q;
  logic [23:0] sharpness_sums_contrast_0_s22_q;
  logic [23:0] sharpness_sums_contrast_1_s22_q;
  logic [6:0] x_s22_q;
  logic ends_cell_s22_q;
  logic lower_half_s22_q;
  logic [13:0] counts_supervised_s22_q;
  logic [13:0] counts_textured_s22_q;
  logic [13:0] counts_explained_s22_q;
  logic registration_of_right_s22_q;
  logic [13:0] product_s22_q;
  logic centres_values_1_textured_s22_q;
  logic centres_values_1_of_skin_s22_q;
  logic [6:0] column_s22_q;
  logic and_418_s22_q;
  logic so_s22_q;
  logic less_452_s22_q;
  logic less_453_s22_q;
  logic less_454_s22_q;
  logic less_455_s22_q;
  logic less_456_s22_q;
  logic less_457_s22_q;
  logic less_458_s22_q;
  logic less_459_s22_q;
  logic less_460_s22_q;
  logic less_461_s22_q;
  logic less_462_s22_q;
  logic less_463_s22_q;
  logic less_464_s22_q;
  logic less_465_s22_q;
  logic less_466_s22_q;
  logic less_467_s22_q;
  logic less_468_s22_q;
  logic less_469_s22_q;
  logic less_470_s22_q;
  logic less_471_s22_q;
  logic less_472_s22_q;
  logic less_473_s22_q;
  logic less_474_s22_q;
  logic less_475_s22_q;
  logic equal_476_s22_q;
  logic select_481_s22_q;
  logic whole_22_s22_q;
  logic [8:0] sum_531_s22_q;
  logic equal_1385_s22_q;
  logic not_1386_s22_q;
  logic equal_1430_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1436_s22_q;
  logic equal_1438_s22_q;
  logic equal_1440_s22_q;
  logic equal_1442_s22_q;
  logic equal_1444_s22_q;
  logic equal_1446_s22_q;
  logic equal_1448_s22_q;
  logic equal_1450_s22_q;
  logic less_1458_s22_q;
  logic or_1462_s22_q;
  logic [31:0] registration_sums_rdata_s22_q;
  logic equal_1482_s22_q;
  logic equal_1484_s22_q;
  logic [8:0] select_1491_s22_q;
  logic [7:0] select_1520_s22_q;
  logic [7:0] select_1536_s22_q;
  logic and_1539_s22_q;
  logic equal_1542_s22_q;
  logic and_1544_s22_q;
  logic less_1575_s22_q;
  logic and_1579_s22_q;
  logic less_1581_s22_q;
  logic and_1587_s22_q;
  logic [7:0] select_1592_s22_q;
  logic [7:0] select_1622_s22_q;
  logic select_1624_s22_q;
  logic [7:0] select_1651_s22_q;
  logic [7:0] select_1673_s22_q;
  logic [7:0] select_1680_s22_q;
  logic [7:0] select_1682_s22_q;
  logic [7:0] select_1701_s22_q;
  logic [7:0] select_1742_s22_q;
  logic [7:0] select_1783_s22_q;
  logic [7:0] select_1836_s22_q;
  logic equal_1837_s22_q;
  logic equal_1838_s22_q;
  logic and_1848_s22_q;
  logic and_1858_s22_q;
  logic less_1866_s22_q;
  logic [17:0] select_1868_s22_q;
  logic [17:0] select_1879_s22_q;
  logic [7:0] select_1951_s22_q;
  logic [7:0] select_1963_s22_q;
  logic [7:0] select_1979_s22_q;
  logic [7:0] select_2044_s22_q;
  logic [7:0] select_2168_s22_q;
  logic and_2172_s22_q;
  logic not_2183_s22_q;
  logic not_2237_s22_q;
  logic [7:0] sum_2247_s22_q;
  logic equal_2263_s22_q;
  logic or_2268_s22_q;
  logic [23:0] select_2279_s22_q;
  logic not_2299_s22_q;
  logic less_2313_s22_q;
  logic and_2324_s22_q;
  logic equal_2511_s22_q;
  logic [8:0] sum_2514_s22_q;
  logic equal_2565_s22_q;
  logic and_2627_s22_q;
  logic and_2646_s22_q;
  logic not_2650_s22_q;
  logic not_2665_s22_q;
  logic [9:0] select_2676_s22_q;
  logic [9:0] select_2679_s22_q;
  logic and_2716_s22_q;
  logic equal_2776_s22_q;
  logic equal_2904_s22_q;
  logic or_2907_s22_q;
  logic equal_2910_s22_q;
  logic select_2916_s22_q;
  logic not_2921_s22_q;
  logic equal_2930_s22_q;
  logic equal_2932_s22_q;
  logic equal_2933_s22_q;
  logic equal_3062_s22_q;
  logic equal_3146_s22_q;
  logic [9:0] select_3155_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= line_ended_q;
      census_columns_values_1_cell_2_mask_s22_q <= census_columns_values_1_cell_2_mask_s21_q;
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_s21_q;
      sharpness_sums_detail_0_s22_q <= sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_s22_q <= sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_s22_q <= sharpness_sums_contrast_0_s21_q;
      sharpness_sums_contrast_1_s22_q <= sharpness_sums_contrast_1_s21_q;
      x_s22_q <= x_s21_q[6:0];
      ends_cell_s22_q <= ends_cell_s21_q;
      lower_half_s22_q <= lower_half_s21_q;
      counts_supervised_s22_q <= counts_supervised_q;
      counts_textured_s22_q <= counts_textured_s21_q;
      counts_explained_s22_q <= counts_explained_s21_q;
      registration_of_right_s22_q <= registration_of_right_s21_q;
      product_s22_q <= product_s21_q;
      centres_values_1_textured_s22_q <= centres_values_1_textured_s21_q;
      centres_values_1_of_skin_s22_q <= centres_values_1_of_skin_s21_q;
      column_s22_q <= column_s21_q;
      and_418_s22_q <= and_418_s21_q;
      so_s22_q <= so_s21_q;
      less_452_s22_q <= less_452_s21_q;
      less_453_s22_q <= less_453_s21_q;
      less_454_s22_q <= less_454_s21_q;
      less_455_s22_q <= less_455_s21_q;
      less_456_s22_q <= less_456_s21_q;
      less_457_s22_q <= less_457_s21_q;
      less_458_s22_q <= less_458_s21_q;
      less_459_s22_q <= less_459_s21_q;
      less_460_s22_q <= less_460_s21_q;
      less_461_s22_q <= less_461_s21_q;
      less_462_s22_q <= less_462_s21_q;
      less_463_s22_q <= less_463_s21_q;
      less_464_s22_q <= less_464_s21_q;
      less_465_s22_q <= less_465_s21_q;
      less_466_s22_q <= less_466_s21_q;
      less_467_s22_q <= less_467_s21_q;
      less_468_s22_q <= less_468_s21_q;
      less_469_s22_q <= less_469_s21_q;
      less_470_s22_q <= less_470_s21_q;
      less_471_s22_q <= less_471_s21_q;
      less_472_s22_q <= less_472_s21_q;
      less_473_s22_q <= less_473_s21_q;
      less_474_s22_q <= less_474_s21_q;
      less_475_s22_q <= less_475_s21_q;
      equal_476_s22_q <= equal_476_s21_q;
      select_481_s22_q <= select_481_s21_q;
      whole_22_s22_q <= whole_22_s21_q;
      sum_531_s22_q <= sum_531[13:5];
      equal_1385_s22_q <= equal_1385_s21_q;
      not_1386_s22_q <= not_1386_s21_q;
      equal_1430_s22_q <= equal_1430_s21_q;
      all_s22_q <= all_s21_q;
      sum_1436_s22_q <= sum_1436_s21_q;
      equal_1438_s22_q <= equal_1438_s21_q;
      equal_1440_s22_q <= equal_1440_s21_q;
      equal_1442_s22_q <= equal_1442_s21_q;
      equal_1444_s22_q <= equal_1444_s21_q;
      equal_1446_s22_q <= equal_1446_s21_q;
      equal_1448_s22_q <= equal_1448_s21_q;
      equal_1450_s22_q <= equal_1450_s21_q;
      less_1458_s22_q <= less_1458_s21_q;
      or_1462_s22_q <= or_1462_s21_q;
      registration_sums_rdata_s22_q <= registration_sums_rdata_q;
      equal_1482_s22_q <= equal_1482_s21_q;
      equal_1484_s22_q <= equal_1484_s21_q;
      select_1491_s22_q <= select_1491_s21_q;
      select_1520_s22_q <= select_1520_s21_q;
      select_1536_s22_q <= select_1536_s21_q;
      and_1539_s22_q <= and_1539_s21_q;
      equal_1542_s22_q <= equal_1542_s21_q;
      and_1544_s22_q <= and_1544_s21_q;
      less_1575_s22_q <= less_1575;
      and_1579_s22_q <= and_1544_s21_q & less_1578;
      less_1581_s22_q <= $signed(difference_1574) < $signed({7'h0, cfg_moved_limit_i});
      and_1587_s22_q <= and_1544_s21_q & less_1586;
      select_1592_s22_q <= select_1592;
      select_1622_s22_q <= select_1622_s21_q;
      select_1624_s22_q <= select_1624_s21_q;
      select_1651_s22_q <= select_1651_s21_q;
      select_1673_s22_q <= select_1673_s21_q;
      select_1680_s22_q <= select_1680_s21_q;
      select_1682_s22_q <= select_1682_s21_q;
      select_1701_s22_q <= select_1491_s21_q[3] ? select_1694 : select_1700_s21_q;
      select_1742_s22_q <= select_1742_s21_q;
      select_1783_s22_q <= select_1783_s21_q;
      select_1836_s22_q <= select_1836_s21_q;
      equal_1837_s22_q <= x_s21_q[7:3] == 5'h0;
      equal_1838_s22_q <= equal_1838_s21_q;
      and_1848_s22_q <= and_1848_s21_q;
      and_1858_s22_q <= and_1858_s21_q;
      less_1866_s22_q <= less_1866_s21_q;
      select_1868_s22_q <= select_1868;
      select_1879_s22_q <= select_1879;
      select_1951_s22_q <= select_1951;
      select_1963_s22_q <= select_1963;
      select_1979_s22_q <= select_1979_s21_q;
      select_2044_s22_q <= select_2044_s21_q;
      select_2168_s22_q <= select_2168_s21_q;
      and_2172_s22_q <= and_2172_s21_q;
      not_2183_s22_q <= not_2183_s21_q;
      not_2237_s22_q <= not_2237;
      sum_2247_s22_q <= {2'h0, x_s21_q[7:2]} + 8'hff;
      equal_2263_s22_q <= t[4:1] == 4'h0;
      or_2268_s22_q <= or_2268_s21_q;
      select_2279_s22_q <= select_2279;
      not_2299_s22_q <= ~({sum_2297, around_s21_q[0]} < {2'h0, t});
      less_2313_s22_q <= less_2313_s21_q;
      and_2324_s22_q <= and_2324_s21_q;
      equal_2511_s22_q <= equal_2511_s21_q;
      sum_2514_s22_q <= sum_2514[13:5];
      equal_2565_s22_q <= equal_2565_s21_q;
      and_2627_s22_q <= and_2627_s21_q;
      and_2646_s22_q <= and_2646_s21_q;
      not_2650_s22_q <= not_2650_s21_q;
      not_2665_s22_q <= ~({sum_2663, e_s21_q[0]} < {2'h0, t});
      select_2676_s22_q <= select_2676_s21_q;
      select_2679_s22_q <= select_2679_s21_q;
      and_2716_s22_q <= and_2716_s21_q;
      equal_2776_s22_q <= equal_2776_s21_q;
      equal_2904_s22_q <= select_2676_s21_q[9:3] == 7'h0;
      or_2907_s22_q <= or_2907;
      equal_2910_s22_q <= equal_2910_s21_q;
      select_2916_s22_q <= select_2916;
      not_2921_s22_q <= ~({sum_2919, select_2679_s21_q[0]} < {2'h0, select_2676_s21_q});
      equal_2930_s22_q <= equal_2930_s21_q;
      equal_2932_s22_q <= equal_2932_s21_q;
      equal_2933_s22_q <= equal_2933_s21_q;
      equal_3062_s22_q <= equal_3062_s21_q;
      equal_3146_s22_q <= equal_3146_s21_q;
      select_3155_s22_q <= select_3155_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
  logic [4:0] census_filled_q;
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [1:0] sharpness_comparing_contrast_0_q;
  logic [1:0] sharpness_comparing_contrast_1_q;
  logic sharpness_comparing_less_contrast_0_q;
  logic sharpness_comparing_less_contrast_1_q;
  logic [13:0] counts_nearer_q;
  logic [13:0] registration_half_across_q;
  logic [47:0] good_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_482;
  assign select_482 = equal_476_s22_q ? 4'h0 : census_filled_q[3:0];
  // hls/stages/census.hpp:219
  logic and_483;
  assign and_483 = select_481_s22_q & select_482[3];
  // hls/stages/census.hpp:220
  logic and_508;
  assign and_508 = whole_22_s22_q & and_483;
  // hls/stages/registration.hpp:106
  logic and_1576;
  assign and_1576 = and_1544_s22_q & less_1575_s22_q;
  logic [1:0] select_1577;
  assign select_1577 = equal_1542_s22_q ? {and_1576, and_1544_s22_q} : 2'h0;
  logic [1:0] select_1580;
  assign select_1580 = equal_1542_s22_q ? {and_1579_s22_q, and_1544_s22_q} : 2'h0;
  logic and_1582;
  assign and_1582 = and_1544_s22_q & less_1581_s22_q;
  logic [1:0] select_1583;
  assign select_1583 = equal_1542_s22_q ? {and_1582, and_1544_s22_q} : 2'h0;
  // hls/stages/registration.hpp:250
  logic [1:0] select_1585;
  assign select_1585 = select_1491_s22_q[1] ? select_1577 : (select_1491_s22_q[0] ? select_1580 : select_1583);
  // hls/stages/registration.hpp:106
  logic [1:0] select_1588;
  assign select_1588 = equal_1542_s22_q ? {and_1587_s22_q, and_1544_s22_q} : 2'h0;
  logic and_1589;
  assign and_1589 = and_1544_s22_q & equal_1542_s22_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_1590;
  assign select_1590 = select_1491_s22_q[0] ? select_1588 : {1'b0, and_1589};
  logic [7:0] select_1594;
  assign select_1594 = select_1491_s22_q[1] ? {{6{select_1590[1]}}, select_1590} : (select_1491_s22_q[0] ? select_1592_s22_q : 8'h0);
  logic [7:0] select_1595;
  assign select_1595 = select_1491_s22_q[2] ? {{6{select_1585[1]}}, select_1585} : select_1594;
  logic [7:0] select_1630;
  assign select_1630 = select_1491_s22_q[0] ? {{2{registration_half_across_q[13]}}, registration_half_across_q[13:8]} : registration_half_across_q[7:0];
  logic [7:0] select_1674;
  assign select_1674 = select_1491_s22_q[2] ? (select_1491_s22_q[1] ? select_1630 : select_1651_s22_q) : select_1673_s22_q;
  logic [7:0] select_1689;
  assign select_1689 = select_1491_s22_q[0] ? {2'h0, counts_explained_s22_q[13:8]} : counts_explained_s22_q[7:0];
  logic [7:0] select_1690;
  assign select_1690 = select_1491_s22_q[0] ? {2'h0, counts_textured_s22_q[13:8]} : counts_textured_s22_q[7:0];
  // hls/stages/census.hpp:305
  logic xor_1849;
  assign xor_1849 = sharpness_comparing_contrast_1_q[1] ^ and_1848_s22_q;
  logic select_1852;
  assign select_1852 = (equal_1838_s22_q | xor_1849) ? (and_1848_s22_q & xor_1849) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:154
  logic select_1853;
  assign select_1853 = equal_1837_s22_q ? select_1852 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/census.hpp:305
  logic xor_1859;
  assign xor_1859 = sharpness_comparing_contrast_0_q[1] ^ and_1858_s22_q;
  logic select_1862;
  assign select_1862 = (equal_1838_s22_q | xor_1859) ? (and_1858_s22_q & xor_1859) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:154
  logic select_1863;
  assign select_1863 = equal_1837_s22_q ? select_1862 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:296
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_1868_s22_q};
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_1879_s22_q};
  // hls/stages/agreement.hpp:154
  logic [1:0] select_1897;
  assign select_1897 = equal_1837_s22_q ? {sharpness_comparing_contrast_1_q[0], and_1858_s22_q} : sharpness_comparing_contrast_1_q;
  logic [1:0] select_1899;
  assign select_1899 = equal_1837_s22_q ? {sharpness_comparing_contrast_0_q[0], and_1848_s22_q} : sharpness_comparing_contrast_0_q;
  logic [17:0] select_1909;
  assign select_1909 = equal_1837_s22_q ? (less_1866_s22_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [17:0] select_1921;
  assign select_1921 = equal_1837_s22_q ? (less_1866_s22_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/agreement.hpp:1013
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:984
  logic select_2235;
  assign select_2235 = marks_first_s22_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:970
  logic [10:0] sum_2236;
  assign sum_2236 = {1'b0, {5{select_2235}}, 1'b0, {2{select_2235}}, 1'b0, select_2235} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:842
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2247_s22_q[7]}}, sum_2247_s22_q, x_s22_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:970
  logic [10:0] sum_2249;
  assign sum_2249 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:832
  logic [47:0] select_2280;
  assign select_2280 = or_2268_s22_q ? {select_2279_s22_q[23], 1'b0, select_2279_s22_q[22], 1'b0, select_2279_s22_q[21], 1'b0, select_2279_s22_q[20], 1'b0, select_2279_s22_q[19], 1'b0, select_2279_s22_q[18], 1'b0, select_2279_s22_q[17], 1'b0, select_2279_s22_q[16], 1'b0, select_2279_s22_q[15], 1'b0, select_2279_s22_q[14], 1'b0, select_2279_s22_q[13], 1'b0, select_2279_s22_q[12], 1'b0, select_2279_s22_q[11], 1'b0, select_2279_s22_q[10], 1'b0, select_2279_s22_q[9], 1'b0, select_2279_s22_q[8], 1'b0, select_2279_s22_q[7], 1'b0, select_2279_s22_q[6], 1'b0, select_2279_s22_q[5], 1'b0, select_2279_s22_q[4], 1'b0, select_2279_s22_q[3], 1'b0, select_2279_s22_q[2], 1'b0, select_2279_s22_q[1], 1'b0, select_2279_s22_q[0], 1'b0} : {1'b0, select_2279_s22_q[23], 1'b0, select_2279_s22_q[22], 1'b0, select_2279_s22_q[21], 1'b0, select_2279_s22_q[20], 1'b0, select_2279_s22_q[19], 1'b0, select_2279_s22_q[18], 1'b0, select_2279_s22_q[17], 1'b0, select_2279_s22_q[16], 1'b0, select_2279_s22_q[15], 1'b0, select_2279_s22_q[14], 1'b0, select_2279_s22_q[13], 1'b0, select_2279_s22_q[12], 1'b0, select_2279_s22_q[11], 1'b0, select_2279_s22_q[10], 1'b0, select_2279_s22_q[9], 1'b0, select_2279_s22_q[8], 1'b0, select_2279_s22_q[7], 1'b0, select_2279_s22_q[6], 1'b0, select_2279_s22_q[5], 1'b0, select_2279_s22_q[4], 1'b0, select_2279_s22_q[3], 1'b0, select_2279_s22_q[2], 1'b0, select_2279_s22_q[1], 1'b0, select_2279_s22_q[0]};
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2648;
  assign select_2648 = and_2627_s22_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2646_s22_q});
  // hls/stages/agreement.hpp:863
  logic [10:0] sum_2680;
  assign sum_2680 = {1'b0, select_2679_s22_q} + {3'h0, select_2679_s22_q[9:2]};
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2718;
  assign select_2718 = equal_1385_s22_q ? 8'h0 : (so_s22_q ? select_1592_s22_q : 8'h0);
  // hls/stages/registration.hpp:126
  logic [13:0] select_2720;
  assign select_2720 = and_2716_s22_q ? 14'h0 : (registration_half_across_q + {{6{select_2718[7]}}, select_2718});
  // hls/stages/agreement.hpp:862
  logic [11:0] select_2778;
  assign select_2778 = or_1462_s22_q ? 12'h0 : (equal_2776_s22_q ? registration_sums_rdata_s22_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:872
  logic [11:0] select_2780;
  assign select_2780 = equal_1430_s22_q ? 12'h0 : (less_1458_s22_q ? select_2778 : 12'h0);
  // hls/stages/registration.hpp:145
  logic and_2783;
  assign and_2783 = x_s22_q[1] & all_s22_q;
  // hls/stages/agreement.hpp:872
  logic and_2786;
  assign and_2786 = not_2183_s22_q & (less_1458_s22_q & ({and_2783, x_s22_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:862
  logic [11:0] select_2793;
  assign select_2793 = or_1462_s22_q ? 12'h0 : (equal_2776_s22_q ? registration_sums_rdata_s22_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:872
  logic [11:0] select_2795;
  assign select_2795 = equal_1430_s22_q ? 12'h0 : (less_1458_s22_q ? select_2793 : 12'h0);
  // hls/stages/registration.hpp:142
  logic not_2801;
  assign not_2801 = ~all_s22_q;
  // hls/stages/agreement.hpp:872
  logic and_2804;
  assign and_2804 = not_2183_s22_q & (less_1458_s22_q & (x_s22_q[2:0] == {all_s22_q, not_2801, 1'b0}));
  // hls/stages/agreement.hpp:211
  logic and_2810;
  assign and_2810 = equal_1385_s22_q & (x_s22_q[6] & (not_2183_s22_q & (less_1458_s22_q & all_s22_q)));
  // hls/stages/registration.hpp:149
  logic equal_2837;
  assign equal_2837 = x_s22_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:872
  logic and_2840;
  assign and_2840 = not_2183_s22_q & (less_1458_s22_q & (x_s22_q[5] ? x_s22_q[3] : equal_2837));
  logic and_2849;
  assign and_2849 = not_2183_s22_q & (less_1458_s22_q & ((~x_s22_q[5]) & (x_s22_q[3] & equal_2837)));
  // hls/stages/agreement.hpp:865
  logic select_2922;
  assign select_2922 = equal_2904_s22_q ? ((~or_2907_s22_q) & (~select_2916_s22_q)) : not_2921_s22_q;
  // hls/stages/agreement.hpp:872
  logic [47:0] select_2924;
  assign select_2924 = x_s22_q[6] ? (equal_1430_s22_q ? good_q : {select_2922, good_q[47:1]}) : good_q;
  logic equal_2927;
  assign equal_2927 = x_s22_q == 7'h7f;
  // hls/stages/agreement.hpp:314
  logic [12:0] select_3065;
  assign select_3065 = equal_2565_s22_q ? (equal_3062_s22_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:365
  logic [6:0] select_3068;
  assign select_3068 = and_418_s22_q ? (equal_2565_s22_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:870
  logic [31:0] select_3148;
  assign select_3148 = equal_1450_s22_q ? {2'h0, counts_explained_s22_q, 2'h0, counts_textured_s22_q} : (equal_3146_s22_q ? registration_sums_rdata_s22_q : 32'h0);
  logic [31:0] select_3149;
  assign select_3149 = equal_1448_s22_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s22_q} : select_3148;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_filled_q <= 5'h0;
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      sharpness_comparing_contrast_0_q <= 2'h0;
      sharpness_comparing_contrast_1_q <= 2'h0;
      sharpness_comparing_less_contrast_0_q <= 1'b0;
      sharpness_comparing_less_contrast_1_q <= 1'b0;
      counts_nearer_q <= 14'h0;
      registration_half_across_q <= 14'h0;
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s22_en) begin
      census_filled_q <= and_418_s22_q ? {select_482, 1'b1} : census_filled_q;
      sharpness_comparing_rest_0_q <= so_s22_q ? select_1921 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s22_q ? select_1909 : sharpness_comparing_rest_1_q;
      sharpness_comparing_contrast_0_q <= so_s22_q ? select_1899 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s22_q ? select_1897 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s22_q ? select_1863 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s22_q ? select_1853 : sharpness_comparing_less_contrast_1_q;
      counts_nearer_q <= select_2648;
      registration_half_across_q <= select_2720;
      good_q <= equal_1385_s22_q ? select_2924 : good_q;
      map_row_q <= and_418_s22_q ? select_3065 : map_row_q;
      map_width_q <= select_3068;
      write_half_q <= marks_first_s22_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2235;
      done_q <= not_2237_s22_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s22_q;
      said_q <= equal_1385_s22_q & equal_2927;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic [4:0] census_filled_s23_q;
  logic [23:0] sharpness_sums_detail_0_s23_q;
  logic [23:0] sharpness_sums_detail_1_s23_q;
  logic [23:0] sharpness_sums_contrast_0_s23_q;
  logic [23:0] sharpness_sums_contrast_1_s23_q;
  logic [6:0] x_s23_q;
  logic ends_cell_s23_q;
  logic lower_half_s23_q;
  logic [13:0] counts_nearer_s23_q;
  logic [13:0] registration_half_across_s23_q;
  logic registration_of_right_s23_q;
  logic [13:0] product_s23_q;
  logic centres_values_1_textured_s23_q;
  logic centres_values_1_of_skin_s23_q;
  logic done_s23_q;
  logic [6:0] column_s23_q;
  logic and_418_s23_q;
  logic less_452_s23_q;
  logic less_453_s23_q;
  logic less_454_s23_q;
  logic less_455_s23_q;
  logic less_456_s23_q;
  logic less_457_s23_q;
  logic less_458_s23_q;
  logic less_459_s23_q;
  logic less_460_s23_q;
  logic less_461_s23_q;
  logic less_462_s23_q;
  logic less_463_s23_q;
  logic less_464_s23_q;
  logic less_465_s23_q;
  logic less_466_s23_q;
  logic less_467_s23_q;
  logic less_468_s23_q;
  logic less_469_s23_q;
  logic less_470_s23_q;
  logic less_471_s23_q;
  logic less_472_s23_q;
  logic less_473_s23_q;
  logic less_474_s23_q;
  logic less_475_s23_q;
  logic and_483_s23_q;
  logic and_508_s23_q;
  logic and_509_s23_q;
  logic less_532_s23_q;
  logic equal_1385_s23_q;
  logic not_1386_s23_q;
  logic equal_1430_s23_q;
  logic [1:0] sum_1436_s23_q;
  logic equal_1438_s23_q;
  logic equal_1440_s23_q;
  logic equal_1442_s23_q;
  logic equal_1444_s23_q;
  logic equal_1446_s23_q;
  logic less_1458_s23_q;
  logic [19:0] select_1483_s23_q;
  logic equal_1484_s23_q;
  logic [11:0] select_1488_s23_q;
  logic [8:0] select_1491_s23_q;
  logic [7:0] select_1520_s23_q;
  logic [7:0] select_1536_s23_q;
  logic and_1539_s23_q;
  logic [7:0] select_1595_s23_q;
  logic [7:0] select_1622_s23_q;
  logic select_1624_s23_q;
  logic [7:0] select_1674_s23_q;
  logic [7:0] select_1680_s23_q;
  logic [7:0] select_1682_s23_q;
  logic [7:0] select_1691_s23_q;
  logic [7:0] select_1701_s23_q;
  logic [7:0] select_1742_s23_q;
  logic [7:0] select_1783_s23_q;
  logic [7:0] select_1836_s23_q;
  logic equal_1837_s23_q;
  logic equal_1838_s23_q;
  logic sum_s23_q;
  logic sum_2_s23_q;
  logic [7:0] select_1951_s23_q;
  logic [7:0] select_1963_s23_q;
  logic [7:0] select_1979_s23_q;
  logic [7:0] select_2044_s23_q;
  logic [7:0] select_2168_s23_q;
  logic and_2172_s23_q;
  logic not_2183_s23_q;
  logic [2:0] index_s23_q;
  logic [10:0] sum_2236_s23_q;
  logic and_2243_s23_q;
  logic less_2244_s23_q;
  logic [2:0] index_2_s23_q;
  logic [10:0] sum_2249_s23_q;
  logic equal_2263_s23_q;
  logic not_2283_s23_q;
  logic not_2299_s23_q;
  logic less_2313_s23_q;
  logic and_2324_s23_q;
  logic equal_2511_s23_q;
  logic and_2516_s23_q;
  logic and_2627_s23_q;
  logic not_2650_s23_q;
  logic not_2665_s23_q;
  logic [9:0] select_2676_s23_q;
  logic [9:0] select_2679_s23_q;
  logic less_2681_s23_q;
  logic and_2716_s23_q;
  logic and_2722_s23_q;
  logic [1:0] select_2726_s23_q;
  logic [1:0] select_2730_s23_q;
  logic [1:0] select_2734_s23_q;
  logic [1:0] select_2738_s23_q;
  logic [11:0] select_2780_s23_q;
  logic and_2788_s23_q;
  logic [11:0] select_2795_s23_q;
  logic and_2806_s23_q;
  logic and_2810_s23_q;
  logic and_2842_s23_q;
  logic and_2850_s23_q;
  logic or_2907_s23_q;
  logic equal_2910_s23_q;
  logic select_2916_s23_q;
  logic equal_2927_s23_q;
  logic equal_2930_s23_q;
  logic equal_2932_s23_q;
  logic equal_2933_s23_q;
  logic [31:0] select_3149_s23_q;
  logic [9:0] select_3155_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_s22_q;
      census_filled_s23_q <= census_filled_q;
      sharpness_sums_detail_0_s23_q <= sharpness_sums_detail_0_s22_q;
      sharpness_sums_detail_1_s23_q <= sharpness_sums_detail_1_s22_q;
      sharpness_sums_contrast_0_s23_q <= sharpness_sums_contrast_0_s22_q;
      sharpness_sums_contrast_1_s23_q <= sharpness_sums_contrast_1_s22_q;
      x_s23_q <= x_s22_q;
      ends_cell_s23_q <= ends_cell_s22_q;
      lower_half_s23_q <= lower_half_s22_q;
      counts_nearer_s23_q <= counts_nearer_q;
      registration_half_across_s23_q <= registration_half_across_q;
      registration_of_right_s23_q <= registration_of_right_s22_q;
      product_s23_q <= product_s22_q;
      centres_values_1_textured_s23_q <= centres_values_1_textured_s22_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_s22_q;
      done_s23_q <= done_q;
      column_s23_q <= column_s22_q;
      and_418_s23_q <= and_418_s22_q;
      less_452_s23_q <= less_452_s22_q;
      less_453_s23_q <= less_453_s22_q;
      less_454_s23_q <= less_454_s22_q;
      less_455_s23_q <= less_455_s22_q;
      less_456_s23_q <= less_456_s22_q;
      less_457_s23_q <= less_457_s22_q;
      less_458_s23_q <= less_458_s22_q;
      less_459_s23_q <= less_459_s22_q;
      less_460_s23_q <= less_460_s22_q;
      less_461_s23_q <= less_461_s22_q;
      less_462_s23_q <= less_462_s22_q;
      less_463_s23_q <= less_463_s22_q;
      less_464_s23_q <= less_464_s22_q;
      less_465_s23_q <= less_465_s22_q;
      less_466_s23_q <= less_466_s22_q;
      less_467_s23_q <= less_467_s22_q;
      less_468_s23_q <= less_468_s22_q;
      less_469_s23_q <= less_469_s22_q;
      less_470_s23_q <= less_470_s22_q;
      less_471_s23_q <= less_471_s22_q;
      less_472_s23_q <= less_472_s22_q;
      less_473_s23_q <= less_473_s22_q;
      less_474_s23_q <= less_474_s22_q;
      less_475_s23_q <= less_475_s22_q;
      and_483_s23_q <= and_483;
      and_508_s23_q <= and_508;
      and_509_s23_q <= census_columns_values_1_cell_2_mask_s22_q & and_483;
      less_532_s23_q <= 9'h4 < sum_531_s22_q;
      equal_1385_s23_q <= equal_1385_s22_q;
      not_1386_s23_q <= not_1386_s22_q;
      equal_1430_s23_q <= equal_1430_s22_q;
      sum_1436_s23_q <= sum_1436_s22_q;
      equal_1438_s23_q <= equal_1438_s22_q;
      equal_1440_s23_q <= equal_1440_s22_q;
      equal_1442_s23_q <= equal_1442_s22_q;
      equal_1444_s23_q <= equal_1444_s22_q;
      equal_1446_s23_q <= equal_1446_s22_q;
      less_1458_s23_q <= less_1458_s22_q;
      select_1483_s23_q <= equal_1482_s22_q ? registration_sums_rdata_s22_q[19:0] : 20'h0;
      equal_1484_s23_q <= equal_1484_s22_q;
      select_1488_s23_q <= equal_1482_s22_q ? registration_sums_rdata_s22_q[31:20] : 12'h0;
      select_1491_s23_q <= select_1491_s22_q;
      select_1520_s23_q <= select_1520_s22_q;
      select_1536_s23_q <= select_1536_s22_q;
      and_1539_s23_q <= and_1539_s22_q;
      select_1595_s23_q <= select_1595;
      select_1622_s23_q <= select_1622_s22_q;
      select_1624_s23_q <= select_1624_s22_q;
      select_1674_s23_q <= select_1674;
      select_1680_s23_q <= select_1680_s22_q;
      select_1682_s23_q <= select_1682_s22_q;
      select_1691_s23_q <= select_1491_s22_q[1] ? select_1689 : select_1690;
      select_1701_s23_q <= select_1701_s22_q;
      select_1742_s23_q <= select_1742_s22_q;
      select_1783_s23_q <= select_1783_s22_q;
      select_1836_s23_q <= select_1836_s22_q;
      equal_1837_s23_q <= equal_1837_s22_q;
      equal_1838_s23_q <= equal_1838_s22_q;
      sum_s23_q <= sum[0];
      sum_2_s23_q <= sum_2[0];
      select_1951_s23_q <= select_1951_s22_q;
      select_1963_s23_q <= select_1963_s22_q;
      select_1979_s23_q <= select_1979_s22_q;
      select_2044_s23_q <= select_2044_s22_q;
      select_2168_s23_q <= select_2168_s22_q;
      and_2172_s23_q <= and_2172_s22_q;
      not_2183_s23_q <= not_2183_s22_q;
      index_s23_q <= index[2:0];
      sum_2236_s23_q <= sum_2236;
      and_2243_s23_q <= began_q & (seen_x_q == 4'h0);
      less_2244_s23_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s23_q <= index_2[2:0];
      sum_2249_s23_q <= sum_2249;
      equal_2263_s23_q <= equal_2263_s22_q;
      not_2283_s23_q <= ~((good_q & select_2280) == 48'h0);
      not_2299_s23_q <= not_2299_s22_q;
      less_2313_s23_q <= less_2313_s22_q;
      and_2324_s23_q <= and_2324_s22_q;
      equal_2511_s23_q <= equal_2511_s22_q;
      and_2516_s23_q <= and_508 & (9'h4 < sum_2514_s22_q);
      and_2627_s23_q <= and_2627_s22_q;
      not_2650_s23_q <= not_2650_s22_q;
      not_2665_s23_q <= not_2665_s22_q;
      select_2676_s23_q <= select_2676_s22_q;
      select_2679_s23_q <= select_2679_s22_q;
      less_2681_s23_q <= {sum_2680, select_2679_s22_q[1:0]} < {3'h0, select_2676_s22_q};
      and_2716_s23_q <= and_2716_s22_q;
      and_2722_s23_q <= not_1386_s22_q & (so_s22_q & and_1589);
      select_2726_s23_q <= equal_1385_s22_q ? 2'h0 : (so_s22_q ? select_1588 : 2'h0);
      select_2730_s23_q <= equal_1385_s22_q ? 2'h0 : (so_s22_q ? select_1583 : 2'h0);
      select_2734_s23_q <= equal_1385_s22_q ? 2'h0 : (so_s22_q ? select_1580 : 2'h0);
      select_2738_s23_q <= equal_1385_s22_q ? 2'h0 : (so_s22_q ? select_1577 : 2'h0);
      select_2780_s23_q <= select_2780;
      and_2788_s23_q <= equal_1385_s22_q & (x_s22_q[6] & and_2786);
      select_2795_s23_q <= select_2795;
      and_2806_s23_q <= equal_1385_s22_q & (x_s22_q[6] & and_2804);
      and_2810_s23_q <= and_2810;
      and_2842_s23_q <= equal_1385_s22_q & (x_s22_q[6] & and_2840);
      and_2850_s23_q <= x_s22_q[6] & and_2849;
      or_2907_s23_q <= or_2907_s22_q;
      equal_2910_s23_q <= equal_2910_s22_q;
      select_2916_s23_q <= select_2916_s22_q;
      equal_2927_s23_q <= equal_2927;
      equal_2930_s23_q <= equal_2930_s22_q;
      equal_2932_s23_q <= equal_2932_s22_q;
      equal_2933_s23_q <= equal_2933_s22_q;
      select_3149_s23_q <= select_3149;
      select_3155_s23_q <= select_3155_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
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
  logic good_known_q;
  // hls/stages/census.hpp:223
  logic and_533;
  assign and_533 = and_483_s23_q & less_532_s23_q;
  // hls/stages/registration.hpp:249
  logic [6:0] select_1485;
  assign select_1485 = sum_1436_s23_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  logic [13:0] select_1486;
  assign select_1486 = equal_1484_s23_q ? registration_half_across_s23_q : {{7{select_1485[6]}}, select_1485};
  // hls/stages/registration.hpp:250
  logic not_1540;
  assign not_1540 = ~select_1491_s23_q[2];
  logic and_1541;
  assign and_1541 = and_1539_s23_q & not_1540;
  logic [7:0] select_1597;
  assign select_1597 = select_1491_s23_q[4] ? select_1536_s23_q : (select_1491_s23_q[3] ? {7'h0, and_1541} : select_1595_s23_q);
  logic select_1599;
  assign select_1599 = select_1491_s23_q[0] ? registration_other_up_q : registration_other_down_q;
  logic select_1602;
  assign select_1602 = select_1491_s23_q[0] ? registration_other_enough_q : registration_votes_up_q;
  logic select_1603;
  assign select_1603 = select_1491_s23_q[0] ? registration_votes_down_q : registration_enough_q;
  logic select_1604;
  assign select_1604 = select_1491_s23_q[1] ? select_1602 : select_1603;
  logic [7:0] select_1605;
  assign select_1605 = select_1491_s23_q[0] ? {{2{registration_up_q[13]}}, registration_up_q[13:8]} : registration_up_q[7:0];
  logic [7:0] select_1606;
  assign select_1606 = select_1491_s23_q[0] ? {{2{registration_down_q[13]}}, registration_down_q[13:8]} : registration_down_q[7:0];
  logic [7:0] select_1608;
  assign select_1608 = select_1491_s23_q[2] ? {7'h0, select_1604} : (select_1491_s23_q[1] ? select_1605 : select_1606);
  logic [6:0] select_1625;
  assign select_1625 = select_1491_s23_q[1] ? {6'h0, select_1624_s23_q} : registration_half_half_votes_up_q;
  logic [6:0] select_1626;
  assign select_1626 = select_1491_s23_q[0] ? registration_half_half_votes_down_q : registration_half_votes_up_q;
  logic [6:0] select_1627;
  assign select_1627 = select_1491_s23_q[0] ? registration_half_votes_down_q : {1'b0, registration_half_measured_q};
  logic [6:0] select_1629;
  assign select_1629 = select_1491_s23_q[2] ? select_1625 : (select_1491_s23_q[1] ? select_1626 : select_1627);
  logic [7:0] select_1675;
  assign select_1675 = select_1491_s23_q[3] ? {select_1629[6], select_1629} : select_1674_s23_q;
  logic select_1865;
  assign select_1865 = select_1491_s23_q[0] ? sharpness_comparing_less_contrast_1_q : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:302
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s23_q});
  // hls/stages/census.hpp:304
  logic xor_1872;
  assign xor_1872 = sharpness_comparing_product_1_q[2] ^ five_times[0];
  // hls/stages/census.hpp:302
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s23_q});
  // hls/stages/census.hpp:304
  logic xor_1883;
  assign xor_1883 = sharpness_comparing_product_0_q[2] ^ five_times_2[0];
  // hls/stages/agreement.hpp:154
  logic select_1891;
  assign select_1891 = drew_q ? (equal_1837_s23_q ? five_times[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  logic select_1892;
  assign select_1892 = equal_1837_s23_q ? five_times_2[1] : sharpness_comparing_carry_0_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_1901;
  assign select_1901 = select_1491_s23_q[0] ? sharpness_comparing_contrast_1_q : sharpness_comparing_contrast_0_q;
  // hls/stages/agreement.hpp:154
  logic [2:0] select_1902;
  assign select_1902 = equal_1837_s23_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s23_q} : sharpness_comparing_product_1_q;
  logic [2:0] select_1903;
  assign select_1903 = drew_q ? select_1902 : sharpness_comparing_product_1_q;
  logic [2:0] select_1904;
  assign select_1904 = equal_1837_s23_q ? {sharpness_comparing_product_0_q[1:0], sum_s23_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_1905;
  assign select_1905 = drew_q ? select_1904 : sharpness_comparing_product_0_q;
  // hls/stages/registration.hpp:250
  logic [2:0] select_1907;
  assign select_1907 = select_1491_s23_q[1] ? {1'b0, select_1901} : (select_1491_s23_q[0] ? select_1903 : select_1905);
  logic [1:0] select_1911;
  assign select_1911 = select_1491_s23_q[0] ? 2'h0 : sharpness_comparing_rest_1_q[17:16];
  logic [7:0] select_1912;
  assign select_1912 = select_1491_s23_q[0] ? sharpness_comparing_rest_1_q[15:8] : sharpness_comparing_rest_1_q[7:0];
  logic [7:0] select_1914;
  assign select_1914 = select_1491_s23_q[2] ? {5'h0, select_1907} : (select_1491_s23_q[1] ? {6'h0, select_1911} : select_1912);
  logic [1:0] select_1923;
  assign select_1923 = select_1491_s23_q[0] ? 2'h0 : sharpness_comparing_rest_0_q[17:16];
  logic [7:0] select_1924;
  assign select_1924 = select_1491_s23_q[0] ? sharpness_comparing_rest_0_q[15:8] : sharpness_comparing_rest_0_q[7:0];
  logic [7:0] select_1926;
  assign select_1926 = select_1491_s23_q[0] ? 8'h0 : sharpness_sums_contrast_1_s23_q[23:16];
  logic [7:0] select_1927;
  assign select_1927 = select_1491_s23_q[0] ? sharpness_sums_contrast_1_s23_q[15:8] : sharpness_sums_contrast_1_s23_q[7:0];
  logic [7:0] select_1929;
  assign select_1929 = select_1491_s23_q[2] ? (select_1491_s23_q[1] ? {6'h0, select_1923} : select_1924) : (select_1491_s23_q[1] ? select_1926 : select_1927);
  logic [7:0] select_1930;
  assign select_1930 = select_1491_s23_q[0] ? 8'h0 : sharpness_sums_contrast_0_s23_q[23:16];
  logic [7:0] select_1931;
  assign select_1931 = select_1491_s23_q[0] ? sharpness_sums_contrast_0_s23_q[15:8] : sharpness_sums_contrast_0_s23_q[7:0];
  logic [7:0] select_1933;
  assign select_1933 = select_1491_s23_q[0] ? 8'h0 : sharpness_sums_detail_1_s23_q[23:16];
  logic [7:0] select_1934;
  assign select_1934 = select_1491_s23_q[0] ? sharpness_sums_detail_1_s23_q[15:8] : sharpness_sums_detail_1_s23_q[7:0];
  logic [7:0] select_1936;
  assign select_1936 = select_1491_s23_q[2] ? (select_1491_s23_q[1] ? select_1930 : select_1931) : (select_1491_s23_q[1] ? select_1933 : select_1934);
  logic [7:0] select_1952;
  assign select_1952 = select_1491_s23_q[4] ? (select_1491_s23_q[3] ? select_1929 : select_1936) : select_1951_s23_q;
  logic [2:0] select_1953;
  assign select_1953 = select_1491_s23_q[0] ? {3{census_left_misses_q[19]}} : census_left_misses_q[18:16];
  logic [7:0] select_1954;
  assign select_1954 = select_1491_s23_q[0] ? census_left_misses_q[15:8] : census_left_misses_q[7:0];
  logic [7:0] select_1955;
  assign select_1955 = select_1491_s23_q[1] ? {{5{census_left_misses_q[19]}}, select_1953} : select_1954;
  logic [7:0] select_1964;
  assign select_1964 = select_1491_s23_q[3] ? (select_1491_s23_q[2] ? {3'h0, census_filled_s23_q} : select_1955) : select_1963_s23_q;
  // hls/stages/agreement.hpp:765
  logic and_2284;
  assign and_2284 = good_known_q & not_2283_s23_q;
  // hls/stages/agreement.hpp:834
  logic is_seen;
  assign is_seen = equal_2263_s23_q ? and_2284 : not_2299_s23_q;
  // hls/stages/census.hpp:226
  logic and_2517;
  assign and_2517 = and_508_s23_q & less_532_s23_q;
  // hls/stages/census.hpp:227
  logic [19:0] sum_2518;
  assign sum_2518 = census_left_misses_q + {{17{and_2517}}, and_2516_s23_q, 1'b0, and_2516_s23_q};
  // hls/stages/agreement.hpp:365
  logic [19:0] select_2520;
  assign select_2520 = and_418_s23_q ? (equal_2511_s23_q ? 20'h0 : sum_2518) : census_left_misses_q;
  // hls/stages/agreement.hpp:837
  logic not_2667;
  assign not_2667 = ~(equal_2263_s23_q ? and_2284 : not_2665_s23_q);
  // hls/stages/agreement.hpp:211
  logic and_2670;
  assign and_2670 = ends_cell_s23_q & (not_2650_s23_q & (centres_values_1_textured_s23_q & not_2667));
  // hls/stages/agreement.hpp:868
  logic [9:0] select_2683;
  assign select_2683 = ((~(select_2676_s23_q[9:4] == 6'h0)) & less_2681_s23_q) ? select_2676_s23_q : 10'h0;
  // hls/stages/agreement.hpp:211
  logic [9:0] select_2686;
  assign select_2686 = equal_1385_s23_q ? (x_s23_q[6] ? (equal_1430_s23_q ? 10'h0 : select_2683) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:841
  logic and_2704;
  assign and_2704 = centres_values_1_textured_s23_q & (centres_values_1_of_skin_s23_q & not_2667);
  // hls/stages/registration.hpp:126
  logic [5:0] select_2724;
  assign select_2724 = and_2716_s23_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2722_s23_q});
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2727;
  assign sum_2727 = registration_half_votes_down_q + {{5{select_2726_s23_q[1]}}, select_2726_s23_q};
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2731;
  assign sum_2731 = registration_half_votes_up_q + {{5{select_2730_s23_q[1]}}, select_2730_s23_q};
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2735;
  assign sum_2735 = registration_half_half_votes_down_q + {{5{select_2734_s23_q[1]}}, select_2734_s23_q};
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2739;
  assign sum_2739 = registration_half_half_votes_up_q + {{5{select_2738_s23_q[1]}}, select_2738_s23_q};
  // hls/stages/agreement.hpp:211
  logic and_2771;
  assign and_2771 = equal_1385_s23_q & (x_s23_q[6] & (not_2183_s23_q & less_1458_s23_q));
  logic [11:0] select_2782;
  assign select_2782 = equal_1385_s23_q ? (x_s23_q[6] ? select_2780_s23_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:237
  logic [13:0] sum_2790;
  assign sum_2790 = {{2{select_2782[11]}}, select_2782} + (and_2788_s23_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:211
  logic [11:0] select_2797;
  assign select_2797 = equal_1385_s23_q ? (x_s23_q[6] ? select_2795_s23_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:238
  logic [13:0] sum_2799;
  assign sum_2799 = {{2{select_2797[11]}}, select_2797} + (and_2788_s23_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:231
  logic not_2811;
  assign not_2811 = ~and_2810_s23_q;
  logic less_2812;
  assign less_2812 = $signed({9'h1, {2{not_2811}}, and_2810_s23_q}) < $signed(registration_up_q[13:2]);
  logic select_2813;
  assign select_2813 = and_2806_s23_q ? less_2812 : registration_enough_q;
  // hls/stages/agreement.hpp:872
  logic and_2817;
  assign and_2817 = x_s23_q[6] & (not_2183_s23_q & (less_1458_s23_q & (x_s23_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:211
  logic and_2818;
  assign and_2818 = equal_1385_s23_q & and_2817;
  // hls/stages/registration.hpp:227
  logic less_2819;
  assign less_2819 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2821;
  assign less_2821 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:872
  logic and_2826;
  assign and_2826 = x_s23_q[6] & (not_2183_s23_q & (less_1458_s23_q & (x_s23_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:211
  logic and_2827;
  assign and_2827 = equal_1385_s23_q & and_2826;
  // hls/stages/agreement.hpp:872
  logic and_2834;
  assign and_2834 = x_s23_q[6] & (not_2183_s23_q & (less_1458_s23_q & (x_s23_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:229
  logic and_2852;
  assign and_2852 = registration_votes_up_q & registration_other_down_q;
  logic select_2854;
  assign select_2854 = registration_votes_down_q ? (registration_other_up_q | and_2852) : and_2852;
  // hls/stages/registration.hpp:130
  logic and_2856;
  assign and_2856 = (equal_1385_s23_q & and_2850_s23_q) & (registration_other_enough_q & select_2854);
  logic and_2858;
  assign and_2858 = registration_enough_q & ((and_2842_s23_q & (less_2821 | less_2819)) | and_2856);
  // hls/stages/agreement.hpp:211
  logic select_2929;
  assign select_2929 = equal_1385_s23_q ? ((x_s23_q[6] & good_known_q) | equal_2927_s23_q) : good_known_q;
  // hls/stages/agreement.hpp:1013
  logic and_3091;
  assign and_3091 = and_2324_s23_q & ({sum_2249_s23_q, index_2_s23_q} == {sum_2236_s23_q, index_s23_q});
  // hls/stages/agreement.hpp:875
  logic or_3120;
  assign or_3120 = sharpness_comparing_less_contrast_0_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:211
  logic and_3140;
  assign and_3140 = equal_1385_s23_q & (x_s23_q[6] & (not_2183_s23_q | (4'hc < x_s23_q[5:2])));

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1104; read in stage 23, written in stage 24: 23 < 24 < 23 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2236_s23_q, index_s23_q};
  logic map_re;
  assign map_re = s23_en & (and_2243_s23_q & less_2244_s23_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s23_q;
  logic fresh_we;
  assign fresh_we = s23_en & and_418_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s23_q, and_533, and_509_s23_q, and_508_s23_q, and_483_s23_q, less_475_s23_q, less_474_s23_q, less_473_s23_q, less_472_s23_q, less_471_s23_q, less_470_s23_q, less_469_s23_q, less_468_s23_q, less_467_s23_q, less_466_s23_q, less_465_s23_q, less_464_s23_q, less_463_s23_q, less_462_s23_q, less_461_s23_q, less_460_s23_q, less_459_s23_q, less_458_s23_q, less_457_s23_q, less_456_s23_q, less_455_s23_q, less_454_s23_q, less_453_s23_q, less_452_s23_q};
  end
`ifndef SYNTHESIS
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
    end else if (en_i) begin
      fresh_re_s8_sim <= fresh_re;
      fresh_raddr_s8_sim <= fresh_raddr;
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
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && fresh_we) begin
      if (fresh_re && fresh_raddr == fresh_waddr) begin
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
      if (fresh_waddr >= 7'd120) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd120) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_left_misses_q <= 20'h0;
      sharpness_comparing_product_0_q <= 3'h0;
      sharpness_comparing_product_1_q <= 3'h0;
      sharpness_comparing_carry_0_q <= 1'b0;
      sharpness_comparing_carry_1_q <= 1'b0;
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
      good_known_q <= 1'b0;
    end else if (s23_en) begin
      census_left_misses_q <= select_2520;
      sharpness_comparing_product_0_q <= select_1905;
      sharpness_comparing_product_1_q <= select_1903;
      sharpness_comparing_carry_0_q <= drew_q ? select_1892 : sharpness_comparing_carry_0_q;
      sharpness_comparing_carry_1_q <= select_1891;
      registration_half_measured_q <= select_2724;
      registration_half_votes_down_q <= and_2716_s23_q ? 7'h0 : sum_2727;
      registration_half_votes_up_q <= and_2716_s23_q ? 7'h0 : sum_2731;
      registration_half_half_votes_down_q <= and_2716_s23_q ? 7'h0 : sum_2735;
      registration_half_half_votes_up_q <= and_2716_s23_q ? 7'h0 : sum_2739;
      registration_down_q <= and_2771 ? sum_2790 : registration_down_q;
      registration_up_q <= and_2771 ? sum_2799 : registration_up_q;
      registration_enough_q <= select_2813;
      registration_votes_down_q <= and_2818 ? less_2819 : registration_votes_down_q;
      registration_votes_up_q <= and_2818 ? less_2821 : registration_votes_up_q;
      registration_other_enough_q <= and_2827 ? select_2813 : registration_other_enough_q;
      registration_other_down_q <= and_2827 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2827 ? registration_votes_up_q : registration_other_up_q;
      good_known_q <= select_2929;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic [23:0] sharpness_sums_detail_0_s24_q;
  logic [23:0] sharpness_sums_detail_1_s24_q;
  logic [23:0] sharpness_sums_contrast_0_s24_q;
  logic [23:0] sharpness_sums_contrast_1_s24_q;
  logic [6:0] x_s24_q;
  logic lower_half_s24_q;
  logic [13:0] counts_nearer_s24_q;
  logic registration_of_right_s24_q;
  logic [13:0] product_s24_q;
  logic done_s24_q;
  logic so_s24_q;
  logic equal_1385_s24_q;
  logic not_1386_s24_q;
  logic equal_1430_s24_q;
  logic [1:0] sum_1436_s24_q;
  logic equal_1438_s24_q;
  logic equal_1440_s24_q;
  logic equal_1442_s24_q;
  logic equal_1444_s24_q;
  logic equal_1446_s24_q;
  logic [19:0] sum_1487_s24_q;
  logic [11:0] select_1488_s24_q;
  logic [8:0] select_1491_s24_q;
  logic not_1540_s24_q;
  logic [7:0] select_1598_s24_q;
  logic select_1599_s24_q;
  logic [7:0] select_1608_s24_q;
  logic [7:0] select_1676_s24_q;
  logic [7:0] select_1680_s24_q;
  logic [7:0] select_1682_s24_q;
  logic [7:0] select_1691_s24_q;
  logic [7:0] select_1701_s24_q;
  logic [7:0] select_1742_s24_q;
  logic [7:0] select_1783_s24_q;
  logic [7:0] select_1836_s24_q;
  logic equal_1837_s24_q;
  logic select_1854_s24_q;
  logic select_1865_s24_q;
  logic or_1873_s24_q;
  logic and_1874_s24_q;
  logic or_1884_s24_q;
  logic and_1885_s24_q;
  logic [7:0] select_1914_s24_q;
  logic [7:0] select_1952_s24_q;
  logic [7:0] select_1980_s24_q;
  logic [7:0] select_2044_s24_q;
  logic [7:0] select_2168_s24_q;
  logic and_2172_s24_q;
  logic and_2243_s24_q;
  logic less_2244_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_2249_s24_q;
  logic is_seen_s24_q;
  logic and_2314_s24_q;
  logic and_2324_s24_q;
  logic and_2627_s24_q;
  logic and_2672_s24_q;
  logic [9:0] select_2676_s24_q;
  logic [9:0] select_2679_s24_q;
  logic [9:0] select_2686_s24_q;
  logic and_2707_s24_q;
  logic not_2836_s24_q;
  logic and_2858_s24_q;
  logic or_2907_s24_q;
  logic equal_2910_s24_q;
  logic select_2916_s24_q;
  logic equal_2927_s24_q;
  logic equal_2930_s24_q;
  logic equal_2932_s24_q;
  logic equal_2933_s24_q;
  logic and_3076_s24_q;
  logic and_3091_s24_q;
  logic or_3120_s24_q;
  logic and_3140_s24_q;
  logic [31:0] select_3149_s24_q;
  logic [9:0] select_3155_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      sharpness_sums_detail_0_s24_q <= sharpness_sums_detail_0_s23_q;
      sharpness_sums_detail_1_s24_q <= sharpness_sums_detail_1_s23_q;
      sharpness_sums_contrast_0_s24_q <= sharpness_sums_contrast_0_s23_q;
      sharpness_sums_contrast_1_s24_q <= sharpness_sums_contrast_1_s23_q;
      x_s24_q <= x_s23_q;
      lower_half_s24_q <= lower_half_s23_q;
      counts_nearer_s24_q <= counts_nearer_s23_q;
      registration_of_right_s24_q <= registration_of_right_s23_q;
      product_s24_q <= product_s23_q;
      done_s24_q <= done_s23_q;
      so_s24_q <= drew_q;
      equal_1385_s24_q <= equal_1385_s23_q;
      not_1386_s24_q <= not_1386_s23_q;
      equal_1430_s24_q <= equal_1430_s23_q;
      sum_1436_s24_q <= sum_1436_s23_q;
      equal_1438_s24_q <= equal_1438_s23_q;
      equal_1440_s24_q <= equal_1440_s23_q;
      equal_1442_s24_q <= equal_1442_s23_q;
      equal_1444_s24_q <= equal_1444_s23_q;
      equal_1446_s24_q <= equal_1446_s23_q;
      sum_1487_s24_q <= select_1483_s23_q + {{6{select_1486[13]}}, select_1486};
      select_1488_s24_q <= select_1488_s23_q;
      select_1491_s24_q <= select_1491_s23_q;
      not_1540_s24_q <= not_1540;
      select_1598_s24_q <= select_1491_s23_q[5] ? select_1520_s23_q : select_1597;
      select_1599_s24_q <= select_1599;
      select_1608_s24_q <= select_1608;
      select_1676_s24_q <= select_1491_s23_q[4] ? select_1622_s23_q : select_1675;
      select_1680_s24_q <= select_1680_s23_q;
      select_1682_s24_q <= select_1682_s23_q;
      select_1691_s24_q <= select_1691_s23_q;
      select_1701_s24_q <= select_1701_s23_q;
      select_1742_s24_q <= select_1742_s23_q;
      select_1783_s24_q <= select_1783_s23_q;
      select_1836_s24_q <= select_1836_s23_q;
      equal_1837_s24_q <= equal_1837_s23_q;
      select_1854_s24_q <= sharpness_comparing_less_contrast_1_q;
      select_1865_s24_q <= select_1865;
      or_1873_s24_q <= equal_1838_s23_q | xor_1872;
      and_1874_s24_q <= five_times[0] & xor_1872;
      or_1884_s24_q <= equal_1838_s23_q | xor_1883;
      and_1885_s24_q <= five_times_2[0] & xor_1883;
      select_1914_s24_q <= select_1914;
      select_1952_s24_q <= select_1952;
      select_1980_s24_q <= select_1491_s23_q[4] ? select_1964 : select_1979_s23_q;
      select_2044_s24_q <= select_2044_s23_q;
      select_2168_s24_q <= select_2168_s23_q;
      and_2172_s24_q <= and_2172_s23_q;
      and_2243_s24_q <= and_2243_s23_q;
      less_2244_s24_q <= less_2244_s23_q;
      index_2_s24_q <= index_2_s23_q;
      sum_2249_s24_q <= sum_2249_s23_q;
      is_seen_s24_q <= is_seen;
      and_2314_s24_q <= is_seen & less_2313_s23_q;
      and_2324_s24_q <= and_2324_s23_q;
      and_2627_s24_q <= and_2627_s23_q;
      and_2672_s24_q <= not_1386_s23_q & (drew_q & and_2670);
      select_2676_s24_q <= select_2676_s23_q;
      select_2679_s24_q <= select_2679_s23_q;
      select_2686_s24_q <= select_2686;
      and_2707_s24_q <= drew_q & (ends_cell_s23_q & (not_2650_s23_q & and_2704));
      not_2836_s24_q <= ~(equal_1385_s23_q & and_2834);
      and_2858_s24_q <= and_2858;
      or_2907_s24_q <= or_2907_s23_q;
      equal_2910_s24_q <= equal_2910_s23_q;
      select_2916_s24_q <= select_2916_s23_q;
      equal_2927_s24_q <= equal_2927_s23_q;
      equal_2930_s24_q <= equal_2930_s23_q;
      equal_2932_s24_q <= equal_2932_s23_q;
      equal_2933_s24_q <= equal_2933_s23_q;
      and_3076_s24_q <= said_q;
      and_3091_s24_q <= and_3091;
      or_3120_s24_q <= or_3120;
      and_3140_s24_q <= and_3140;
      select_3149_s24_q <= select_3149_s23_q;
      select_3155_s24_q <= select_3155_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_unproven_q;
  logic registration_moved_q;
  logic proven_q;
  // hls/stages/registration.hpp:250
  logic and_1601;
  assign and_1601 = not_1540_s24_q & (select_1491_s24_q[1] ? registration_moved_q : select_1599_s24_q);
  logic [7:0] select_1610;
  assign select_1610 = select_1491_s24_q[4] ? 8'h0 : (select_1491_s24_q[3] ? {7'h0, and_1601} : select_1608_s24_q);
  logic [7:0] select_1679;
  assign select_1679 = select_1491_s24_q[0] ? {2'h0, counts_skin_unproven_q[13:8]} : counts_skin_unproven_q[7:0];
  logic [7:0] select_1683;
  assign select_1683 = select_1491_s24_q[0] ? {2'h0, counts_regions_bad_q[13:8]} : counts_regions_bad_q[7:0];
  logic [7:0] select_1685;
  assign select_1685 = select_1491_s24_q[2] ? (select_1491_s24_q[1] ? select_1679 : select_1680_s24_q) : (select_1491_s24_q[1] ? select_1682_s24_q : select_1683);
  logic [7:0] select_1686;
  assign select_1686 = select_1491_s24_q[0] ? {2'h0, counts_unproven_q[13:8]} : counts_unproven_q[7:0];
  logic [7:0] select_1687;
  assign select_1687 = select_1491_s24_q[0] ? {2'h0, counts_nearer_s24_q[13:8]} : counts_nearer_s24_q[7:0];
  logic [7:0] select_1692;
  assign select_1692 = select_1491_s24_q[2] ? (select_1491_s24_q[1] ? select_1686 : select_1687) : select_1691_s24_q;
  logic [7:0] select_1702;
  assign select_1702 = select_1491_s24_q[4] ? (select_1491_s24_q[3] ? select_1685 : select_1692) : select_1701_s24_q;
  // hls/stages/census.hpp:304
  logic select_1875;
  assign select_1875 = or_1873_s24_q ? and_1874_s24_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:154
  logic select_1876;
  assign select_1876 = equal_1837_s24_q ? select_1875 : sharpness_comparing_less_detail_1_q;
  logic select_1877;
  assign select_1877 = so_s24_q ? select_1876 : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:304
  logic select_1886;
  assign select_1886 = or_1884_s24_q ? and_1885_s24_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:154
  logic select_1887;
  assign select_1887 = equal_1837_s24_q ? select_1886 : sharpness_comparing_less_detail_0_q;
  logic select_1888;
  assign select_1888 = so_s24_q ? select_1887 : sharpness_comparing_less_detail_0_q;
  // hls/stages/registration.hpp:250
  logic select_1894;
  assign select_1894 = select_1491_s24_q[0] ? sharpness_comparing_carry_1_q : sharpness_comparing_carry_0_q;
  logic select_1895;
  assign select_1895 = select_1491_s24_q[1] ? (select_1491_s24_q[0] ? select_1877 : select_1888) : select_1894;
  logic [7:0] select_2045;
  assign select_2045 = select_1491_s24_q[6] ? (select_1491_s24_q[5] ? select_1952_s24_q : select_1980_s24_q) : select_2044_s24_q;
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2674;
  assign select_2674 = and_2627_s24_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2672_s24_q});
  logic [13:0] select_2688;
  assign select_2688 = and_2627_s24_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2686_s24_q});
  // hls/stages/agreement.hpp:211
  logic and_2708;
  assign and_2708 = not_1386_s24_q & and_2707_s24_q;
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2710;
  assign select_2710 = and_2627_s24_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2708});
  // hls/stages/agreement.hpp:856
  logic [13:0] select_2935;
  assign select_2935 = equal_2932_s24_q ? counts_skin_unproven_q : (equal_2933_s24_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_2930_s24_q ? counts_nearer_s24_q : select_2935;
  // hls/stages/agreement.hpp:211
  logic and_3106;
  assign and_3106 = equal_1385_s24_q & (equal_2927_s24_q & (cfg_prove_i & (~proven_q)));
  logic and_3118;
  assign and_3118 = equal_1385_s24_q & (equal_2927_s24_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:870
  logic [31:0] select_3150;
  assign select_3150 = equal_1446_s24_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3149_s24_q;
  logic [31:0] select_3151;
  assign select_3151 = equal_1444_s24_q ? {8'h0, sharpness_sums_detail_0_s24_q} : select_3150;
  logic [31:0] select_3152;
  assign select_3152 = equal_1442_s24_q ? {8'h0, sharpness_sums_detail_1_s24_q} : select_3151;
  logic [31:0] select_3153;
  assign select_3153 = equal_1440_s24_q ? {8'h0, sharpness_sums_contrast_0_s24_q} : select_3152;
  logic [31:0] select_3154;
  assign select_3154 = equal_1438_s24_q ? {8'h0, sharpness_sums_contrast_1_s24_q} : select_3153;

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_2249_s24_q, index_2_s24_q};
  logic map_we;
  assign map_we = s24_en & and_2324_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2314_s24_q, is_seen_s24_q};
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
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_skin_unproven_q <= 14'h0;
      registration_moved_q <= 1'b0;
      proven_q <= 1'b0;
    end else if (s24_en) begin
      sharpness_comparing_less_detail_0_q <= select_1888;
      sharpness_comparing_less_detail_1_q <= select_1877;
      counts_unproven_q <= select_2674;
      counts_regions_bad_q <= select_2688;
      counts_skin_unproven_q <= select_2710;
      registration_moved_q <= not_2836_s24_q & (registration_moved_q | and_2858_s24_q);
      proven_q <= marks_first_s24_q ? done_s24_q : proven_q;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic x_s25_q;
  logic lower_half_s25_q;
  logic registration_of_right_s25_q;
  logic [13:0] product_s25_q;
  logic equal_1385_s25_q;
  logic equal_1430_s25_q;
  logic [1:0] sum_1436_s25_q;
  logic [19:0] sum_1487_s25_q;
  logic [11:0] select_1488_s25_q;
  logic [6:0] select_1491_s25_q;
  logic [7:0] select_1598_s25_q;
  logic [7:0] select_1677_s25_q;
  logic [7:0] select_1702_s25_q;
  logic [7:0] select_1742_s25_q;
  logic [7:0] select_1783_s25_q;
  logic [7:0] select_1836_s25_q;
  logic select_1865_s25_q;
  logic select_1895_s25_q;
  logic [7:0] select_1914_s25_q;
  logic [7:0] select_2169_s25_q;
  logic and_2172_s25_q;
  logic and_2243_s25_q;
  logic less_2244_s25_q;
  logic [1:0] map_rdata_s25_q;
  logic is_seen_s25_q;
  logic and_2314_s25_q;
  logic [9:0] select_2676_s25_q;
  logic [9:0] select_2679_s25_q;
  logic or_2907_s25_q;
  logic equal_2910_s25_q;
  logic select_2916_s25_q;
  logic equal_2927_s25_q;
  logic and_2931_s25_q;
  logic [13:0] before_v_4_s25_q;
  logic not_2968_s25_q;
  logic or_2972_s25_q;
  logic and_3076_s25_q;
  logic and_3091_s25_q;
  logic and_3106_s25_q;
  logic and_3118_s25_q;
  logic or_3121_s25_q;
  logic or_3125_s25_q;
  logic and_3140_s25_q;
  logic [5:0] select_3142_s25_q;
  logic [31:0] select_3154_s25_q;
  logic [9:0] select_3155_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      x_s25_q <= x_s24_q[6];
      lower_half_s25_q <= lower_half_s24_q;
      registration_of_right_s25_q <= registration_of_right_s24_q;
      product_s25_q <= product_s24_q;
      equal_1385_s25_q <= equal_1385_s24_q;
      equal_1430_s25_q <= equal_1430_s24_q;
      sum_1436_s25_q <= sum_1436_s24_q;
      sum_1487_s25_q <= sum_1487_s24_q;
      select_1488_s25_q <= select_1488_s24_q;
      select_1491_s25_q <= select_1491_s24_q[8:2];
      select_1598_s25_q <= select_1598_s24_q;
      select_1677_s25_q <= select_1491_s24_q[5] ? select_1610 : select_1676_s24_q;
      select_1702_s25_q <= select_1702;
      select_1742_s25_q <= select_1742_s24_q;
      select_1783_s25_q <= select_1783_s24_q;
      select_1836_s25_q <= select_1836_s24_q;
      select_1865_s25_q <= select_1865_s24_q;
      select_1895_s25_q <= select_1895;
      select_1914_s25_q <= select_1914_s24_q;
      select_2169_s25_q <= select_1491_s24_q[7] ? select_2045 : select_2168_s24_q;
      and_2172_s25_q <= and_2172_s24_q;
      and_2243_s25_q <= and_2243_s24_q;
      less_2244_s25_q <= less_2244_s24_q;
      map_rdata_s25_q <= map_rdata_q;
      is_seen_s25_q <= is_seen_s24_q;
      and_2314_s25_q <= and_2314_s24_q;
      select_2676_s25_q <= select_2676_s24_q;
      select_2679_s25_q <= select_2679_s24_q;
      or_2907_s25_q <= or_2907_s24_q;
      equal_2910_s25_q <= equal_2910_s24_q;
      select_2916_s25_q <= select_2916_s24_q;
      equal_2927_s25_q <= equal_2927_s24_q;
      and_2931_s25_q <= equal_2930_s24_q & equal_2910_s24_q;
      before_v_4_s25_q <= before_v_4;
      not_2968_s25_q <= ~(equal_2933_s24_q & equal_2910_s24_q);
      or_2972_s25_q <= (equal_2933_s24_q | equal_2932_s24_q) | (x_s24_q[6:3] == 4'hf);
      and_3076_s25_q <= and_3076_s24_q;
      and_3091_s25_q <= and_3091_s24_q;
      and_3106_s25_q <= and_3106;
      and_3118_s25_q <= and_3118;
      or_3121_s25_q <= select_1888 | or_3120_s24_q;
      or_3125_s25_q <= select_1877 | select_1854_s24_q;
      and_3140_s25_q <= and_3140_s24_q;
      select_3142_s25_q <= equal_1385_s24_q ? (x_s24_q[6] ? x_s24_q[5:0] : 6'h0) : 6'h0;
      select_3154_s25_q <= select_3154;
      select_3155_s25_q <= select_3155_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic hides_q;
  // hls/stages/registration.hpp:250
  logic select_1896;
  assign select_1896 = select_1491_s25_q[0] ? select_1865_s25_q : select_1895_s25_q;
  logic [7:0] select_1916;
  assign select_1916 = select_1491_s25_q[2] ? select_1836_s25_q : (select_1491_s25_q[1] ? {7'h0, select_1896} : select_1914_s25_q);
  logic [7:0] select_1918;
  assign select_1918 = select_1491_s25_q[4] ? (select_1491_s25_q[3] ? select_1702_s25_q : select_1742_s25_q) : (select_1491_s25_q[3] ? select_1783_s25_q : select_1916);
  // hls/stages/agreement.hpp:936
  logic [14:0] over;
  assign over = {1'b0, product_s25_q} - {1'b0, before_v_4_s25_q};
  // hls/stages/agreement.hpp:944
  logic select_2938;
  assign select_2938 = and_2931_s25_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1013
  logic [1:0] select_3092;
  assign select_3092 = and_3091_s25_q ? {and_2314_s25_q, is_seen_s25_q} : map_rdata_s25_q;
  // hls/stages/agreement.hpp:1014
  logic and_3093;
  assign and_3093 = proven_q & less_3081;
  // hls/stages/agreement.hpp:872
  logic [31:0] select_3156;
  assign select_3156 = equal_1430_s25_q ? select_3154_s25_q : {2'h0, select_3155_s25_q, select_2679_s25_q, select_2676_s25_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      hides_q <= 1'b0;
    end else if (s25_en) begin
      hides_q <= equal_1385_s25_q ? select_2938 : hides_q;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic lower_half_s26_q;
  logic registration_of_right_s26_q;
  logic equal_1385_s26_q;
  logic [1:0] sum_1436_s26_q;
  logic [19:0] sum_1487_s26_q;
  logic [11:0] select_1488_s26_q;
  logic [1:0] select_1491_s26_q;
  logic [7:0] select_1678_s26_q;
  logic [7:0] select_1918_s26_q;
  logic [7:0] select_2169_s26_q;
  logic and_2172_s26_q;
  logic and_2243_s26_q;
  logic less_2244_s26_q;
  logic or_2907_s26_q;
  logic select_2916_s26_q;
  logic equal_2927_s26_q;
  logic select_2938_s26_q;
  logic and_2966_s26_q;
  logic not_2968_s26_q;
  logic or_2972_s26_q;
  logic and_3076_s26_q;
  logic and_3094_s26_q;
  logic and_3097_s26_q;
  logic and_3106_s26_q;
  logic and_3118_s26_q;
  logic or_3121_s26_q;
  logic or_3125_s26_q;
  logic and_3140_s26_q;
  logic [5:0] select_3142_s26_q;
  logic [31:0] select_3158_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      lower_half_s26_q <= lower_half_s25_q;
      registration_of_right_s26_q <= registration_of_right_s25_q;
      equal_1385_s26_q <= equal_1385_s25_q;
      sum_1436_s26_q <= sum_1436_s25_q;
      sum_1487_s26_q <= sum_1487_s25_q;
      select_1488_s26_q <= select_1488_s25_q;
      select_1491_s26_q <= select_1491_s25_q[6:5];
      select_1678_s26_q <= select_1491_s25_q[4] ? select_1598_s25_q : select_1677_s25_q;
      select_1918_s26_q <= select_1918;
      select_2169_s26_q <= select_2169_s25_q;
      and_2172_s26_q <= and_2172_s25_q;
      and_2243_s26_q <= and_2243_s25_q;
      less_2244_s26_q <= less_2244_s25_q;
      or_2907_s26_q <= or_2907_s25_q;
      select_2916_s26_q <= select_2916_s25_q;
      equal_2927_s26_q <= equal_2927_s25_q;
      select_2938_s26_q <= select_2938;
      and_2966_s26_q <= over[14] & equal_2910_s25_q;
      not_2968_s26_q <= not_2968_s25_q;
      or_2972_s26_q <= or_2972_s25_q;
      and_3076_s26_q <= and_3076_s25_q;
      and_3094_s26_q <= select_3092[0] & and_3093;
      and_3097_s26_q <= select_3092[1] & and_3093;
      and_3106_s26_q <= and_3106_s25_q;
      and_3118_s26_q <= and_3118_s25_q;
      or_3121_s26_q <= or_3121_s25_q;
      or_3125_s26_q <= or_3125_s25_q;
      and_3140_s26_q <= and_3140_s25_q;
      select_3142_s26_q <= select_3142_s25_q;
      select_3158_s26_q <= equal_1385_s25_q ? (x_s25_q ? select_3156 : 32'h0) : 32'h0;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/registration.hpp:250
  logic [7:0] select_2170;
  assign select_2170 = select_1491_s26_q[1] ? (select_1491_s26_q[0] ? select_1678_s26_q : select_1918_s26_q) : select_2169_s26_q;
  // hls/stages/agreement.hpp:873
  logic not_2939;
  assign not_2939 = ~hidden_for_q[7];
  logic [7:0] select_2941;
  assign select_2941 = select_2938_s26_q ? (hidden_for_q + {7'h0, not_2939}) : 8'h0;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2943;
  assign select_2943 = equal_1385_s26_q ? (equal_2927_s26_q ? select_2941 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:942
  logic and_2969;
  assign and_2969 = too_much_q & not_2968_s26_q;
  // hls/stages/agreement.hpp:943
  logic select_2974;
  assign select_2974 = and_2966_s26_q ? (and_2969 | or_2972_s26_q) : and_2969;
  // hls/stages/agreement.hpp:220
  logic select_3096;
  assign select_3096 = and_2243_s26_q ? (less_2244_s26_q ? and_3094_s26_q : seen_q) : seen_q;
  logic select_3099;
  assign select_3099 = and_2243_s26_q ? (less_2244_s26_q ? and_3097_s26_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:211
  logic and_3109;
  assign and_3109 = equal_1385_s26_q & (equal_2927_s26_q & (cfg_prove_i & or_2907_s26_q));
  // hls/stages/agreement.hpp:953
  logic not_3111;
  assign not_3111 = ~(or_2907_s26_q | not_3100);
  // hls/stages/agreement.hpp:211
  logic and_3114;
  assign and_3114 = equal_2927_s26_q & (not_3111 & (select_2916_s26_q | select_2974));
  logic and_3124;
  assign and_3124 = equal_1385_s26_q & (equal_2927_s26_q & (not_3111 & or_3121_s26_q));
  logic and_3128;
  assign and_3128 = equal_1385_s26_q & (equal_2927_s26_q & (not_3111 & or_3125_s26_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s26_en) begin
      hidden_for_q <= select_2943;
      too_much_q <= equal_1385_s26_q ? select_2974 : too_much_q;
      seen_q <= select_3096;
      nearer_q <= select_3099;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic lower_half_s27_q;
  logic registration_of_right_s27_q;
  logic equal_1385_s27_q;
  logic [1:0] sum_1436_s27_q;
  logic [19:0] sum_1487_s27_q;
  logic [11:0] sum_2171_s27_q;
  logic and_2172_s27_q;
  logic equal_2927_s27_q;
  logic and_3076_s27_q;
  logic and_3106_s27_q;
  logic and_3109_s27_q;
  logic and_3115_s27_q;
  logic and_3118_s27_q;
  logic and_3124_s27_q;
  logic and_3128_s27_q;
  logic not_3132_s27_q;
  logic and_3140_s27_q;
  logic [5:0] select_3142_s27_q;
  logic [31:0] select_3158_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      lower_half_s27_q <= lower_half_s26_q;
      registration_of_right_s27_q <= registration_of_right_s26_q;
      equal_1385_s27_q <= equal_1385_s26_q;
      sum_1436_s27_q <= sum_1436_s26_q;
      sum_1487_s27_q <= sum_1487_s26_q;
      sum_2171_s27_q <= select_1488_s26_q + {{4{select_2170[7]}}, select_2170};
      and_2172_s27_q <= and_2172_s26_q;
      equal_2927_s27_q <= equal_2927_s26_q;
      and_3076_s27_q <= and_3076_s26_q;
      and_3106_s27_q <= and_3106_s26_q;
      and_3109_s27_q <= and_3109;
      and_3115_s27_q <= equal_1385_s26_q & and_3114;
      and_3118_s27_q <= and_3118_s26_q;
      and_3124_s27_q <= and_3124;
      and_3128_s27_q <= and_3128;
      not_3132_s27_q <= ~(select_2941 < cfg_hidden_frames_i);
      and_3140_s27_q <= and_3140_s26_q;
      select_3142_s27_q <= select_3142_s26_q;
      select_3158_s27_q <= select_3158_s26_q;
    end
  end

  // Stage 27 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:875
  logic and_3134;
  assign and_3134 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_3132_s27_q);

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1436_s27_q, lower_half_s27_q, registration_of_right_s27_q};
  logic registration_sums_we;
  assign registration_sums_we = s27_en & and_2172_s27_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_2171_s27_q, sum_1487_s27_q};
  end
`ifndef SYNTHESIS
  logic [3:0] registration_sums_raddr_s21_sim;
  logic registration_sums_re_s21_sim;
  logic [3:0] registration_sums_raddr_s22_sim;
  logic registration_sums_re_s22_sim;
  logic [3:0] registration_sums_raddr_s23_sim;
  logic registration_sums_re_s23_sim;
  logic [3:0] registration_sums_raddr_s24_sim;
  logic registration_sums_re_s24_sim;
  logic [3:0] registration_sums_raddr_s25_sim;
  logic registration_sums_re_s25_sim;
  logic [3:0] registration_sums_raddr_s26_sim;
  logic registration_sums_re_s26_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_sums_re_s21_sim <= 1'b0;
      registration_sums_re_s22_sim <= 1'b0;
      registration_sums_re_s23_sim <= 1'b0;
      registration_sums_re_s24_sim <= 1'b0;
      registration_sums_re_s25_sim <= 1'b0;
      registration_sums_re_s26_sim <= 1'b0;
    end else if (en_i) begin
      registration_sums_re_s21_sim <= registration_sums_re;
      registration_sums_raddr_s21_sim <= registration_sums_raddr;
      registration_sums_re_s22_sim <= registration_sums_re_s21_sim;
      registration_sums_raddr_s22_sim <= registration_sums_raddr_s21_sim;
      registration_sums_re_s23_sim <= registration_sums_re_s22_sim;
      registration_sums_raddr_s23_sim <= registration_sums_raddr_s22_sim;
      registration_sums_re_s24_sim <= registration_sums_re_s23_sim;
      registration_sums_raddr_s24_sim <= registration_sums_raddr_s23_sim;
      registration_sums_re_s25_sim <= registration_sums_re_s24_sim;
      registration_sums_raddr_s25_sim <= registration_sums_raddr_s24_sim;
      registration_sums_re_s26_sim <= registration_sums_re_s25_sim;
      registration_sums_raddr_s26_sim <= registration_sums_raddr_s25_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && registration_sums_we) begin
      if (registration_sums_re && registration_sums_raddr == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s21_sim && registration_sums_raddr_s21_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s22_sim && registration_sums_raddr_s22_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s23_sim && registration_sums_raddr_s23_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s24_sim && registration_sums_raddr_s24_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s25_sim && registration_sums_raddr_s25_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s26_sim && registration_sums_raddr_s26_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_waddr >= 4'd12) $error("registration_sums: write outside, address %0d", registration_sums_waddr);
    end
    if (rst_ni && registration_sums_re && registration_sums_raddr >= 4'd12) $error("registration_sums: read outside, address %0d", registration_sums_raddr);
  end
`endif

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic and_3076_s28_q;
  logic or_3101_s28_q;
  logic and_3102_s28_q;
  logic and_3106_s28_q;
  logic and_3109_s28_q;
  logic and_3115_s28_q;
  logic and_3118_s28_q;
  logic and_3124_s28_q;
  logic and_3128_s28_q;
  logic and_3136_s28_q;
  logic and_3140_s28_q;
  logic [5:0] select_3142_s28_q;
  logic [31:0] select_3158_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      and_3076_s28_q <= and_3076_s27_q;
      or_3101_s28_q <= not_3100 | seen_q;
      and_3102_s28_q <= cfg_prove_i & nearer_q;
      and_3106_s28_q <= and_3106_s27_q;
      and_3109_s28_q <= and_3109_s27_q;
      and_3115_s28_q <= and_3115_s27_q;
      and_3118_s28_q <= and_3118_s27_q;
      and_3124_s28_q <= and_3124_s27_q;
      and_3128_s28_q <= and_3128_s27_q;
      and_3136_s28_q <= equal_1385_s27_q & (equal_2927_s27_q & and_3134);
      and_3140_s28_q <= and_3140_s27_q;
      select_3142_s28_q <= select_3142_s27_q;
      select_3158_s28_q <= select_3158_s27_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s28_q;
  assign pixel_1_o = pixel_1_s28_q;
  assign saturated_o = saturated_s28_q;
  assign mask_o = mask_s28_q;
  assign marks_first_o = marks_first_s28_q;
  assign marks_last_o = marks_last_s28_q;
  assign marks_seen_o = or_3101_s28_q;
  assign marks_nearer_o = and_3102_s28_q;
  assign verdict_valid_o = and_3076_s28_q;
  assign verdict_unproven_yet_o = and_3106_s28_q;
  assign verdict_untextured_o = and_3109_s28_q;
  assign verdict_disagree_o = and_3115_s28_q;
  assign verdict_moved_o = and_3118_s28_q;
  assign verdict_unsharp_left_o = and_3124_s28_q;
  assign verdict_unsharp_right_o = and_3128_s28_q;
  assign verdict_hidden_o = and_3136_s28_q;
  assign frame_valid_o = and_3140_s28_q;
  assign frame_index_o = select_3142_s28_q;
  assign frame_word_o = select_3158_s28_q;
  assign valid_o = valid_s28_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], detail_4[1:0], detail_3[1:0], sum_2514[4:0], sum_1670[0], sum_1645[1:0], sum_1644[1:0], sum_1640[0], sum_1564[0], sum_1560[0], sum_531[4:0], cfg_width_i[3:0]};

endmodule
