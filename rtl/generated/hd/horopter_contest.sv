// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contest<horopter::hls::profiles::hd>, hls/stages/contest.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 1035 bits, pipeline 676 bits, memories 0 bits.
module horopter_contest (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [10:0] cost_0_i,
  input  logic [10:0] cost_1_i,
  input  logic [10:0] cost_2_i,
  input  logic [10:0] cost_3_i,
  input  logic [10:0] cost_4_i,
  input  logic [10:0] cost_5_i,
  input  logic [10:0] cost_6_i,
  input  logic [10:0] cost_7_i,
  input  logic [10:0] cost_8_i,
  input  logic [10:0] cost_9_i,
  input  logic [10:0] cost_10_i,
  input  logic [10:0] cost_11_i,
  input  logic [10:0] cost_12_i,
  input  logic [10:0] cost_13_i,
  input  logic [10:0] cost_14_i,
  input  logic [10:0] cost_15_i,
  input  logic [10:0] cost_16_i,
  input  logic [10:0] cost_17_i,
  input  logic [10:0] cost_18_i,
  input  logic [5:0] grey_i,
  input  logic known_i,
  input  logic evident_i,
  input  logic strong_v_i,
  input  logic exists_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  input  logic [3:0] cfg_bias_i,
  input  logic [3:0] cfg_boundary_i,
  output logic valid_o,
  output logic signed [6:0] vote_o,
  output logic firm_o,
  output logic [5:0] grey_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q;
  logic s0_en, s1_en, s2_en, s5_en, s7_en, s8_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s5_en = en_i & valid_s5_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;

  // Of the configuration alone: not pipelined.
  logic [3:0] rest;
  assign rest = (cfg_boundary_i == 4'hf) ? 4'h0 : (4'he - cfg_boundary_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic row_ended_q;
  logic [4:0] columns_q;
  logic [10:0] outside_values_0_q;
  logic [10:0] outside_values_1_q;
  logic [10:0] outside_values_2_q;
  logic [10:0] outside_values_3_q;
  logic [10:0] outside_values_4_q;
  logic [10:0] outside_values_5_q;
  logic [10:0] outside_values_6_q;
  logic [10:0] outside_values_7_q;
  logic [10:0] outside_values_8_q;
  logic [10:0] outside_values_9_q;
  logic [10:0] outside_values_10_q;
  logic [10:0] outside_values_11_q;
  logic [10:0] outside_values_12_q;
  logic [10:0] outside_values_13_q;
  logic [10:0] outside_values_14_q;
  logic [10:0] outside_values_15_q;
  logic [10:0] outside_values_16_q;
  logic [10:0] outside_values_17_q;
  logic [10:0] outside_values_18_q;
  logic [10:0] outside_values_19_q;
  logic [10:0] outside_values_20_q;
  logic [10:0] outside_values_21_q;
  logic [10:0] outside_values_22_q;
  logic [10:0] outside_values_23_q;
  logic [10:0] outside_values_24_q;
  logic [5:0] centres_values_0_grey_q;
  logic centres_values_0_exists_q;
  logic centres_values_0_marks_first_q;
  logic centres_values_0_marks_last_q;
  logic centres_values_0_marks_seen_q;
  logic centres_values_0_marks_nearer_q;
  logic [5:0] centres_values_1_grey_q;
  logic centres_values_1_exists_q;
  logic centres_values_1_marks_first_q;
  logic centres_values_1_marks_last_q;
  logic centres_values_1_marks_seen_q;
  logic centres_values_1_marks_nearer_q;
  logic [5:0] centres_values_2_grey_q;
  logic centres_values_2_exists_q;
  logic centres_values_2_marks_first_q;
  logic centres_values_2_marks_last_q;
  logic centres_values_2_marks_seen_q;
  logic centres_values_2_marks_nearer_q;
  logic [5:0] centres_values_3_grey_q;
  logic centres_values_3_exists_q;
  logic centres_values_3_marks_first_q;
  logic centres_values_3_marks_last_q;
  logic centres_values_3_marks_seen_q;
  logic centres_values_3_marks_nearer_q;
  logic [5:0] centres_values_4_grey_q;
  logic centres_values_4_exists_q;
  logic centres_values_4_marks_first_q;
  logic centres_values_4_marks_last_q;
  logic centres_values_4_marks_seen_q;
  logic centres_values_4_marks_nearer_q;
  logic [5:0] centres_values_5_grey_q;
  logic centres_values_5_exists_q;
  logic centres_values_5_marks_first_q;
  logic centres_values_5_marks_last_q;
  logic centres_values_5_marks_seen_q;
  logic centres_values_5_marks_nearer_q;
  logic [5:0] centres_values_6_grey_q;
  logic centres_values_6_exists_q;
  logic centres_values_6_marks_first_q;
  logic centres_values_6_marks_last_q;
  logic centres_values_6_marks_seen_q;
  logic centres_values_6_marks_nearer_q;
  logic [5:0] centres_values_7_grey_q;
  logic centres_values_7_exists_q;
  logic centres_values_7_marks_first_q;
  logic centres_values_7_marks_last_q;
  logic centres_values_7_marks_seen_q;
  logic centres_values_7_marks_nearer_q;
  logic [5:0] centres_values_8_grey_q;
  logic centres_values_8_exists_q;
  logic centres_values_8_marks_first_q;
  logic centres_values_8_marks_last_q;
  logic centres_values_8_marks_seen_q;
  logic centres_values_8_marks_nearer_q;
  logic [5:0] centres_values_9_grey_q;
  logic centres_values_9_exists_q;
  logic centres_values_9_marks_first_q;
  logic centres_values_9_marks_last_q;
  logic centres_values_9_marks_seen_q;
  logic centres_values_9_marks_nearer_q;
  logic [5:0] centres_values_10_grey_q;
  logic centres_values_10_exists_q;
  logic centres_values_10_marks_first_q;
  logic centres_values_10_marks_last_q;
  logic centres_values_10_marks_seen_q;
  logic centres_values_10_marks_nearer_q;
  logic [5:0] centres_values_11_grey_q;
  logic centres_values_11_exists_q;
  logic centres_values_11_marks_first_q;
  logic centres_values_11_marks_last_q;
  logic centres_values_11_marks_seen_q;
  logic centres_values_11_marks_nearer_q;
  logic [5:0] centres_values_12_grey_q;
  logic centres_values_12_exists_q;
  logic centres_values_12_marks_first_q;
  logic centres_values_12_marks_last_q;
  logic centres_values_12_marks_seen_q;
  logic centres_values_12_marks_nearer_q;
  logic [5:0] centres_values_13_grey_q;
  logic centres_values_13_exists_q;
  logic centres_values_13_marks_first_q;
  logic centres_values_13_marks_last_q;
  logic centres_values_13_marks_seen_q;
  logic centres_values_13_marks_nearer_q;
  logic [5:0] centres_values_14_grey_q;
  logic centres_values_14_exists_q;
  logic centres_values_14_marks_first_q;
  logic centres_values_14_marks_last_q;
  logic centres_values_14_marks_seen_q;
  logic centres_values_14_marks_nearer_q;
  logic [5:0] centres_values_15_grey_q;
  logic centres_values_15_exists_q;
  logic centres_values_15_marks_first_q;
  logic centres_values_15_marks_last_q;
  logic centres_values_15_marks_seen_q;
  logic centres_values_15_marks_nearer_q;
  logic [5:0] centres_values_16_grey_q;
  logic centres_values_16_exists_q;
  logic centres_values_16_marks_first_q;
  logic centres_values_16_marks_last_q;
  logic centres_values_16_marks_seen_q;
  logic centres_values_16_marks_nearer_q;
  logic [5:0] centres_values_17_grey_q;
  logic centres_values_17_exists_q;
  logic centres_values_17_marks_first_q;
  logic centres_values_17_marks_last_q;
  logic centres_values_17_marks_seen_q;
  logic centres_values_17_marks_nearer_q;
  logic [5:0] centres_values_18_grey_q;
  logic centres_values_18_exists_q;
  logic centres_values_18_marks_first_q;
  logic centres_values_18_marks_last_q;
  logic centres_values_18_marks_seen_q;
  logic centres_values_18_marks_nearer_q;
  logic [5:0] centres_values_19_grey_q;
  logic centres_values_19_exists_q;
  logic centres_values_19_marks_first_q;
  logic centres_values_19_marks_last_q;
  logic centres_values_19_marks_seen_q;
  logic centres_values_19_marks_nearer_q;
  logic [5:0] centres_values_20_grey_q;
  logic centres_values_20_exists_q;
  logic centres_values_20_marks_first_q;
  logic centres_values_20_marks_last_q;
  logic centres_values_20_marks_seen_q;
  logic centres_values_20_marks_nearer_q;
  logic [5:0] centres_values_21_grey_q;
  logic centres_values_21_exists_q;
  logic centres_values_21_marks_first_q;
  logic centres_values_21_marks_last_q;
  logic centres_values_21_marks_seen_q;
  logic centres_values_21_marks_nearer_q;
  logic [5:0] centres_values_22_grey_q;
  logic centres_values_22_exists_q;
  logic centres_values_22_marks_first_q;
  logic centres_values_22_marks_last_q;
  logic centres_values_22_marks_seen_q;
  logic centres_values_22_marks_nearer_q;
  logic [5:0] centres_values_23_grey_q;
  logic centres_values_23_exists_q;
  logic centres_values_23_marks_first_q;
  logic centres_values_23_marks_last_q;
  logic centres_values_23_marks_seen_q;
  logic centres_values_23_marks_nearer_q;
  // hls/stages/contest.hpp:56
  logic or_322;
  assign or_322 = marks_first_i | row_ended_q;
  // hls/stages/contest.hpp:128
  logic [4:0] select_323;
  assign select_323 = or_322 ? 5'h0 : columns_q;
  // hls/stages/contest.hpp:143
  logic not_325;
  assign not_325 = ~(select_323 == 5'h18);
  // hls/stages/contest.hpp:128
  logic [10:0] select_333;
  assign select_333 = known_i ? cost_1_i : 11'h7ff;
  logic [10:0] select_334;
  assign select_334 = or_322 ? 11'h7ff : outside_values_5_q;
  logic [10:0] select_341;
  assign select_341 = known_i ? cost_2_i : 11'h7ff;
  logic [10:0] select_342;
  assign select_342 = or_322 ? 11'h7ff : outside_values_10_q;
  logic [10:0] select_348;
  assign select_348 = known_i ? cost_3_i : 11'h7ff;
  logic [10:0] select_349;
  assign select_349 = or_322 ? 11'h7ff : outside_values_14_q;
  logic [10:0] select_354;
  assign select_354 = known_i ? cost_4_i : 11'h7ff;
  logic [10:0] select_355;
  assign select_355 = or_322 ? 11'h7ff : outside_values_17_q;
  logic [10:0] select_359;
  assign select_359 = known_i ? cost_5_i : 11'h7ff;
  logic [10:0] select_360;
  assign select_360 = or_322 ? 11'h7ff : outside_values_19_q;
  logic [10:0] select_363;
  assign select_363 = known_i ? cost_6_i : 11'h7ff;
  logic [10:0] select_364;
  assign select_364 = or_322 ? 11'h7ff : outside_values_20_q;
  logic [10:0] select_367;
  assign select_367 = known_i ? cost_7_i : 11'h7ff;
  logic [10:0] select_368;
  assign select_368 = or_322 ? 11'h7ff : outside_values_21_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_ended_q <= 1'b1;
      columns_q <= 5'h0;
      outside_values_0_q <= 11'h0;
      outside_values_1_q <= 11'h0;
      outside_values_2_q <= 11'h0;
      outside_values_3_q <= 11'h0;
      outside_values_4_q <= 11'h0;
      outside_values_5_q <= 11'h0;
      outside_values_6_q <= 11'h0;
      outside_values_7_q <= 11'h0;
      outside_values_8_q <= 11'h0;
      outside_values_9_q <= 11'h0;
      outside_values_10_q <= 11'h0;
      outside_values_11_q <= 11'h0;
      outside_values_12_q <= 11'h0;
      outside_values_13_q <= 11'h0;
      outside_values_14_q <= 11'h0;
      outside_values_15_q <= 11'h0;
      outside_values_16_q <= 11'h0;
      outside_values_17_q <= 11'h0;
      outside_values_18_q <= 11'h0;
      outside_values_19_q <= 11'h0;
      outside_values_20_q <= 11'h0;
      outside_values_21_q <= 11'h0;
      outside_values_22_q <= 11'h0;
      outside_values_23_q <= 11'h0;
      outside_values_24_q <= 11'h0;
      centres_values_0_grey_q <= 6'h0;
      centres_values_0_exists_q <= 1'b0;
      centres_values_0_marks_first_q <= 1'b0;
      centres_values_0_marks_last_q <= 1'b0;
      centres_values_0_marks_seen_q <= 1'b0;
      centres_values_0_marks_nearer_q <= 1'b0;
      centres_values_1_grey_q <= 6'h0;
      centres_values_1_exists_q <= 1'b0;
      centres_values_1_marks_first_q <= 1'b0;
      centres_values_1_marks_last_q <= 1'b0;
      centres_values_1_marks_seen_q <= 1'b0;
      centres_values_1_marks_nearer_q <= 1'b0;
      centres_values_2_grey_q <= 6'h0;
      centres_values_2_exists_q <= 1'b0;
      centres_values_2_marks_first_q <= 1'b0;
      centres_values_2_marks_last_q <= 1'b0;
      centres_values_2_marks_seen_q <= 1'b0;
      centres_values_2_marks_nearer_q <= 1'b0;
      centres_values_3_grey_q <= 6'h0;
      centres_values_3_exists_q <= 1'b0;
      centres_values_3_marks_first_q <= 1'b0;
      centres_values_3_marks_last_q <= 1'b0;
      centres_values_3_marks_seen_q <= 1'b0;
      centres_values_3_marks_nearer_q <= 1'b0;
      centres_values_4_grey_q <= 6'h0;
      centres_values_4_exists_q <= 1'b0;
      centres_values_4_marks_first_q <= 1'b0;
      centres_values_4_marks_last_q <= 1'b0;
      centres_values_4_marks_seen_q <= 1'b0;
      centres_values_4_marks_nearer_q <= 1'b0;
      centres_values_5_grey_q <= 6'h0;
      centres_values_5_exists_q <= 1'b0;
      centres_values_5_marks_first_q <= 1'b0;
      centres_values_5_marks_last_q <= 1'b0;
      centres_values_5_marks_seen_q <= 1'b0;
      centres_values_5_marks_nearer_q <= 1'b0;
      centres_values_6_grey_q <= 6'h0;
      centres_values_6_exists_q <= 1'b0;
      centres_values_6_marks_first_q <= 1'b0;
      centres_values_6_marks_last_q <= 1'b0;
      centres_values_6_marks_seen_q <= 1'b0;
      centres_values_6_marks_nearer_q <= 1'b0;
      centres_values_7_grey_q <= 6'h0;
      centres_values_7_exists_q <= 1'b0;
      centres_values_7_marks_first_q <= 1'b0;
      centres_values_7_marks_last_q <= 1'b0;
      centres_values_7_marks_seen_q <= 1'b0;
      centres_values_7_marks_nearer_q <= 1'b0;
      centres_values_8_grey_q <= 6'h0;
      centres_values_8_exists_q <= 1'b0;
      centres_values_8_marks_first_q <= 1'b0;
      centres_values_8_marks_last_q <= 1'b0;
      centres_values_8_marks_seen_q <= 1'b0;
      centres_values_8_marks_nearer_q <= 1'b0;
      centres_values_9_grey_q <= 6'h0;
      centres_values_9_exists_q <= 1'b0;
      centres_values_9_marks_first_q <= 1'b0;
      centres_values_9_marks_last_q <= 1'b0;
      centres_values_9_marks_seen_q <= 1'b0;
      centres_values_9_marks_nearer_q <= 1'b0;
      centres_values_10_grey_q <= 6'h0;
      centres_values_10_exists_q <= 1'b0;
      centres_values_10_marks_first_q <= 1'b0;
      centres_values_10_marks_last_q <= 1'b0;
      centres_values_10_marks_seen_q <= 1'b0;
      centres_values_10_marks_nearer_q <= 1'b0;
      centres_values_11_grey_q <= 6'h0;
      centres_values_11_exists_q <= 1'b0;
      centres_values_11_marks_first_q <= 1'b0;
      centres_values_11_marks_last_q <= 1'b0;
      centres_values_11_marks_seen_q <= 1'b0;
      centres_values_11_marks_nearer_q <= 1'b0;
      centres_values_12_grey_q <= 6'h0;
      centres_values_12_exists_q <= 1'b0;
      centres_values_12_marks_first_q <= 1'b0;
      centres_values_12_marks_last_q <= 1'b0;
      centres_values_12_marks_seen_q <= 1'b0;
      centres_values_12_marks_nearer_q <= 1'b0;
      centres_values_13_grey_q <= 6'h0;
      centres_values_13_exists_q <= 1'b0;
      centres_values_13_marks_first_q <= 1'b0;
      centres_values_13_marks_last_q <= 1'b0;
      centres_values_13_marks_seen_q <= 1'b0;
      centres_values_13_marks_nearer_q <= 1'b0;
      centres_values_14_grey_q <= 6'h0;
      centres_values_14_exists_q <= 1'b0;
      centres_values_14_marks_first_q <= 1'b0;
      centres_values_14_marks_last_q <= 1'b0;
      centres_values_14_marks_seen_q <= 1'b0;
      centres_values_14_marks_nearer_q <= 1'b0;
      centres_values_15_grey_q <= 6'h0;
      centres_values_15_exists_q <= 1'b0;
      centres_values_15_marks_first_q <= 1'b0;
      centres_values_15_marks_last_q <= 1'b0;
      centres_values_15_marks_seen_q <= 1'b0;
      centres_values_15_marks_nearer_q <= 1'b0;
      centres_values_16_grey_q <= 6'h0;
      centres_values_16_exists_q <= 1'b0;
      centres_values_16_marks_first_q <= 1'b0;
      centres_values_16_marks_last_q <= 1'b0;
      centres_values_16_marks_seen_q <= 1'b0;
      centres_values_16_marks_nearer_q <= 1'b0;
      centres_values_17_grey_q <= 6'h0;
      centres_values_17_exists_q <= 1'b0;
      centres_values_17_marks_first_q <= 1'b0;
      centres_values_17_marks_last_q <= 1'b0;
      centres_values_17_marks_seen_q <= 1'b0;
      centres_values_17_marks_nearer_q <= 1'b0;
      centres_values_18_grey_q <= 6'h0;
      centres_values_18_exists_q <= 1'b0;
      centres_values_18_marks_first_q <= 1'b0;
      centres_values_18_marks_last_q <= 1'b0;
      centres_values_18_marks_seen_q <= 1'b0;
      centres_values_18_marks_nearer_q <= 1'b0;
      centres_values_19_grey_q <= 6'h0;
      centres_values_19_exists_q <= 1'b0;
      centres_values_19_marks_first_q <= 1'b0;
      centres_values_19_marks_last_q <= 1'b0;
      centres_values_19_marks_seen_q <= 1'b0;
      centres_values_19_marks_nearer_q <= 1'b0;
      centres_values_20_grey_q <= 6'h0;
      centres_values_20_exists_q <= 1'b0;
      centres_values_20_marks_first_q <= 1'b0;
      centres_values_20_marks_last_q <= 1'b0;
      centres_values_20_marks_seen_q <= 1'b0;
      centres_values_20_marks_nearer_q <= 1'b0;
      centres_values_21_grey_q <= 6'h0;
      centres_values_21_exists_q <= 1'b0;
      centres_values_21_marks_first_q <= 1'b0;
      centres_values_21_marks_last_q <= 1'b0;
      centres_values_21_marks_seen_q <= 1'b0;
      centres_values_21_marks_nearer_q <= 1'b0;
      centres_values_22_grey_q <= 6'h0;
      centres_values_22_exists_q <= 1'b0;
      centres_values_22_marks_first_q <= 1'b0;
      centres_values_22_marks_last_q <= 1'b0;
      centres_values_22_marks_seen_q <= 1'b0;
      centres_values_22_marks_nearer_q <= 1'b0;
      centres_values_23_grey_q <= 6'h0;
      centres_values_23_exists_q <= 1'b0;
      centres_values_23_marks_first_q <= 1'b0;
      centres_values_23_marks_last_q <= 1'b0;
      centres_values_23_marks_seen_q <= 1'b0;
      centres_values_23_marks_nearer_q <= 1'b0;
    end else if (s0_en) begin
      row_ended_q <= marks_last_i;
      columns_q <= select_323 + {4'h0, not_325};
      outside_values_0_q <= known_i ? cost_0_i : 11'h7ff;
      outside_values_1_q <= or_322 ? 11'h7ff : outside_values_0_q;
      outside_values_2_q <= or_322 ? 11'h7ff : outside_values_1_q;
      outside_values_3_q <= or_322 ? 11'h7ff : outside_values_2_q;
      outside_values_4_q <= or_322 ? 11'h7ff : outside_values_3_q;
      outside_values_5_q <= or_322 ? 11'h7ff : outside_values_4_q;
      outside_values_6_q <= (select_333 < select_334) ? select_333 : select_334;
      outside_values_7_q <= or_322 ? 11'h7ff : outside_values_6_q;
      outside_values_8_q <= or_322 ? 11'h7ff : outside_values_7_q;
      outside_values_9_q <= or_322 ? 11'h7ff : outside_values_8_q;
      outside_values_10_q <= or_322 ? 11'h7ff : outside_values_9_q;
      outside_values_11_q <= (select_341 < select_342) ? select_341 : select_342;
      outside_values_12_q <= or_322 ? 11'h7ff : outside_values_11_q;
      outside_values_13_q <= or_322 ? 11'h7ff : outside_values_12_q;
      outside_values_14_q <= or_322 ? 11'h7ff : outside_values_13_q;
      outside_values_15_q <= (select_348 < select_349) ? select_348 : select_349;
      outside_values_16_q <= or_322 ? 11'h7ff : outside_values_15_q;
      outside_values_17_q <= or_322 ? 11'h7ff : outside_values_16_q;
      outside_values_18_q <= (select_354 < select_355) ? select_354 : select_355;
      outside_values_19_q <= or_322 ? 11'h7ff : outside_values_18_q;
      outside_values_20_q <= (select_359 < select_360) ? select_359 : select_360;
      outside_values_21_q <= (select_363 < select_364) ? select_363 : select_364;
      outside_values_22_q <= (select_367 < select_368) ? select_367 : select_368;
      outside_values_23_q <= or_322 ? 11'h7ff : outside_values_22_q;
      outside_values_24_q <= or_322 ? 11'h7ff : outside_values_23_q;
      centres_values_0_grey_q <= grey_i;
      centres_values_0_exists_q <= exists_i;
      centres_values_0_marks_first_q <= marks_first_i;
      centres_values_0_marks_last_q <= marks_last_i;
      centres_values_0_marks_seen_q <= marks_seen_i;
      centres_values_0_marks_nearer_q <= marks_nearer_i;
      centres_values_1_grey_q <= centres_values_0_grey_q;
      centres_values_1_exists_q <= centres_values_0_exists_q;
      centres_values_1_marks_first_q <= centres_values_0_marks_first_q;
      centres_values_1_marks_last_q <= centres_values_0_marks_last_q;
      centres_values_1_marks_seen_q <= centres_values_0_marks_seen_q;
      centres_values_1_marks_nearer_q <= centres_values_0_marks_nearer_q;
      centres_values_2_grey_q <= centres_values_1_grey_q;
      centres_values_2_exists_q <= centres_values_1_exists_q;
      centres_values_2_marks_first_q <= centres_values_1_marks_first_q;
      centres_values_2_marks_last_q <= centres_values_1_marks_last_q;
      centres_values_2_marks_seen_q <= centres_values_1_marks_seen_q;
      centres_values_2_marks_nearer_q <= centres_values_1_marks_nearer_q;
      centres_values_3_grey_q <= centres_values_2_grey_q;
      centres_values_3_exists_q <= centres_values_2_exists_q;
      centres_values_3_marks_first_q <= centres_values_2_marks_first_q;
      centres_values_3_marks_last_q <= centres_values_2_marks_last_q;
      centres_values_3_marks_seen_q <= centres_values_2_marks_seen_q;
      centres_values_3_marks_nearer_q <= centres_values_2_marks_nearer_q;
      centres_values_4_grey_q <= centres_values_3_grey_q;
      centres_values_4_exists_q <= centres_values_3_exists_q;
      centres_values_4_marks_first_q <= centres_values_3_marks_first_q;
      centres_values_4_marks_last_q <= centres_values_3_marks_last_q;
      centres_values_4_marks_seen_q <= centres_values_3_marks_seen_q;
      centres_values_4_marks_nearer_q <= centres_values_3_marks_nearer_q;
      centres_values_5_grey_q <= centres_values_4_grey_q;
      centres_values_5_exists_q <= centres_values_4_exists_q;
      centres_values_5_marks_first_q <= centres_values_4_marks_first_q;
      centres_values_5_marks_last_q <= centres_values_4_marks_last_q;
      centres_values_5_marks_seen_q <= centres_values_4_marks_seen_q;
      centres_values_5_marks_nearer_q <= centres_values_4_marks_nearer_q;
      centres_values_6_grey_q <= centres_values_5_grey_q;
      centres_values_6_exists_q <= centres_values_5_exists_q;
      centres_values_6_marks_first_q <= centres_values_5_marks_first_q;
      centres_values_6_marks_last_q <= centres_values_5_marks_last_q;
      centres_values_6_marks_seen_q <= centres_values_5_marks_seen_q;
      centres_values_6_marks_nearer_q <= centres_values_5_marks_nearer_q;
      centres_values_7_grey_q <= centres_values_6_grey_q;
      centres_values_7_exists_q <= centres_values_6_exists_q;
      centres_values_7_marks_first_q <= centres_values_6_marks_first_q;
      centres_values_7_marks_last_q <= centres_values_6_marks_last_q;
      centres_values_7_marks_seen_q <= centres_values_6_marks_seen_q;
      centres_values_7_marks_nearer_q <= centres_values_6_marks_nearer_q;
      centres_values_8_grey_q <= centres_values_7_grey_q;
      centres_values_8_exists_q <= centres_values_7_exists_q;
      centres_values_8_marks_first_q <= centres_values_7_marks_first_q;
      centres_values_8_marks_last_q <= centres_values_7_marks_last_q;
      centres_values_8_marks_seen_q <= centres_values_7_marks_seen_q;
      centres_values_8_marks_nearer_q <= centres_values_7_marks_nearer_q;
      centres_values_9_grey_q <= centres_values_8_grey_q;
      centres_values_9_exists_q <= centres_values_8_exists_q;
      centres_values_9_marks_first_q <= centres_values_8_marks_first_q;
      centres_values_9_marks_last_q <= centres_values_8_marks_last_q;
      centres_values_9_marks_seen_q <= centres_values_8_marks_seen_q;
      centres_values_9_marks_nearer_q <= centres_values_8_marks_nearer_q;
      centres_values_10_grey_q <= centres_values_9_grey_q;
      centres_values_10_exists_q <= centres_values_9_exists_q;
      centres_values_10_marks_first_q <= centres_values_9_marks_first_q;
      centres_values_10_marks_last_q <= centres_values_9_marks_last_q;
      centres_values_10_marks_seen_q <= centres_values_9_marks_seen_q;
      centres_values_10_marks_nearer_q <= centres_values_9_marks_nearer_q;
      centres_values_11_grey_q <= centres_values_10_grey_q;
      centres_values_11_exists_q <= centres_values_10_exists_q;
      centres_values_11_marks_first_q <= centres_values_10_marks_first_q;
      centres_values_11_marks_last_q <= centres_values_10_marks_last_q;
      centres_values_11_marks_seen_q <= centres_values_10_marks_seen_q;
      centres_values_11_marks_nearer_q <= centres_values_10_marks_nearer_q;
      centres_values_12_grey_q <= centres_values_11_grey_q;
      centres_values_12_exists_q <= centres_values_11_exists_q;
      centres_values_12_marks_first_q <= centres_values_11_marks_first_q;
      centres_values_12_marks_last_q <= centres_values_11_marks_last_q;
      centres_values_12_marks_seen_q <= centres_values_11_marks_seen_q;
      centres_values_12_marks_nearer_q <= centres_values_11_marks_nearer_q;
      centres_values_13_grey_q <= centres_values_12_grey_q;
      centres_values_13_exists_q <= centres_values_12_exists_q;
      centres_values_13_marks_first_q <= centres_values_12_marks_first_q;
      centres_values_13_marks_last_q <= centres_values_12_marks_last_q;
      centres_values_13_marks_seen_q <= centres_values_12_marks_seen_q;
      centres_values_13_marks_nearer_q <= centres_values_12_marks_nearer_q;
      centres_values_14_grey_q <= centres_values_13_grey_q;
      centres_values_14_exists_q <= centres_values_13_exists_q;
      centres_values_14_marks_first_q <= centres_values_13_marks_first_q;
      centres_values_14_marks_last_q <= centres_values_13_marks_last_q;
      centres_values_14_marks_seen_q <= centres_values_13_marks_seen_q;
      centres_values_14_marks_nearer_q <= centres_values_13_marks_nearer_q;
      centres_values_15_grey_q <= centres_values_14_grey_q;
      centres_values_15_exists_q <= centres_values_14_exists_q;
      centres_values_15_marks_first_q <= centres_values_14_marks_first_q;
      centres_values_15_marks_last_q <= centres_values_14_marks_last_q;
      centres_values_15_marks_seen_q <= centres_values_14_marks_seen_q;
      centres_values_15_marks_nearer_q <= centres_values_14_marks_nearer_q;
      centres_values_16_grey_q <= centres_values_15_grey_q;
      centres_values_16_exists_q <= centres_values_15_exists_q;
      centres_values_16_marks_first_q <= centres_values_15_marks_first_q;
      centres_values_16_marks_last_q <= centres_values_15_marks_last_q;
      centres_values_16_marks_seen_q <= centres_values_15_marks_seen_q;
      centres_values_16_marks_nearer_q <= centres_values_15_marks_nearer_q;
      centres_values_17_grey_q <= centres_values_16_grey_q;
      centres_values_17_exists_q <= centres_values_16_exists_q;
      centres_values_17_marks_first_q <= centres_values_16_marks_first_q;
      centres_values_17_marks_last_q <= centres_values_16_marks_last_q;
      centres_values_17_marks_seen_q <= centres_values_16_marks_seen_q;
      centres_values_17_marks_nearer_q <= centres_values_16_marks_nearer_q;
      centres_values_18_grey_q <= centres_values_17_grey_q;
      centres_values_18_exists_q <= centres_values_17_exists_q;
      centres_values_18_marks_first_q <= centres_values_17_marks_first_q;
      centres_values_18_marks_last_q <= centres_values_17_marks_last_q;
      centres_values_18_marks_seen_q <= centres_values_17_marks_seen_q;
      centres_values_18_marks_nearer_q <= centres_values_17_marks_nearer_q;
      centres_values_19_grey_q <= centres_values_18_grey_q;
      centres_values_19_exists_q <= centres_values_18_exists_q;
      centres_values_19_marks_first_q <= centres_values_18_marks_first_q;
      centres_values_19_marks_last_q <= centres_values_18_marks_last_q;
      centres_values_19_marks_seen_q <= centres_values_18_marks_seen_q;
      centres_values_19_marks_nearer_q <= centres_values_18_marks_nearer_q;
      centres_values_20_grey_q <= centres_values_19_grey_q;
      centres_values_20_exists_q <= centres_values_19_exists_q;
      centres_values_20_marks_first_q <= centres_values_19_marks_first_q;
      centres_values_20_marks_last_q <= centres_values_19_marks_last_q;
      centres_values_20_marks_seen_q <= centres_values_19_marks_seen_q;
      centres_values_20_marks_nearer_q <= centres_values_19_marks_nearer_q;
      centres_values_21_grey_q <= centres_values_20_grey_q;
      centres_values_21_exists_q <= centres_values_20_exists_q;
      centres_values_21_marks_first_q <= centres_values_20_marks_first_q;
      centres_values_21_marks_last_q <= centres_values_20_marks_last_q;
      centres_values_21_marks_seen_q <= centres_values_20_marks_seen_q;
      centres_values_21_marks_nearer_q <= centres_values_20_marks_nearer_q;
      centres_values_22_grey_q <= centres_values_21_grey_q;
      centres_values_22_exists_q <= centres_values_21_exists_q;
      centres_values_22_marks_first_q <= centres_values_21_marks_first_q;
      centres_values_22_marks_last_q <= centres_values_21_marks_last_q;
      centres_values_22_marks_seen_q <= centres_values_21_marks_seen_q;
      centres_values_22_marks_nearer_q <= centres_values_21_marks_nearer_q;
      centres_values_23_grey_q <= centres_values_22_grey_q;
      centres_values_23_exists_q <= centres_values_22_exists_q;
      centres_values_23_marks_first_q <= centres_values_22_marks_first_q;
      centres_values_23_marks_last_q <= centres_values_22_marks_last_q;
      centres_values_23_marks_seen_q <= centres_values_22_marks_seen_q;
      centres_values_23_marks_nearer_q <= centres_values_22_marks_nearer_q;
    end
  end

  logic [10:0] cost_6_s1_q;
  logic [10:0] cost_7_s1_q;
  logic [10:0] cost_8_s1_q;
  logic [10:0] cost_9_s1_q;
  logic [10:0] cost_10_s1_q;
  logic [10:0] cost_11_s1_q;
  logic [10:0] cost_12_s1_q;
  logic [10:0] cost_13_s1_q;
  logic [10:0] cost_14_s1_q;
  logic [10:0] cost_15_s1_q;
  logic [10:0] cost_16_s1_q;
  logic [10:0] cost_17_s1_q;
  logic [10:0] cost_18_s1_q;
  logic known_s1_q;
  logic evident_s1_q;
  logic strong_v_s1_q;
  logic [10:0] outside_values_24_s1_q;
  logic [5:0] centres_values_23_grey_s1_q;
  logic centres_values_23_exists_s1_q;
  logic centres_values_23_marks_first_s1_q;
  logic centres_values_23_marks_last_s1_q;
  logic centres_values_23_marks_seen_s1_q;
  logic centres_values_23_marks_nearer_s1_q;
  logic or_322_s1_q;
  logic [3:0] select_323_s1_q;
  logic and_380_s1_q;
  logic less_390_s1_q;
  logic less_405_s1_q;
  logic less_410_s1_q;
  logic less_420_s1_q;
  logic less_446_s1_q;
  logic less_450_s1_q;
  logic less_452_s1_q;
  logic [10:0] select_459_s1_q;
  logic [10:0] select_463_s1_q;
  logic [10:0] select_465_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      cost_6_s1_q <= cost_6_i;
      cost_7_s1_q <= cost_7_i;
      cost_8_s1_q <= cost_8_i;
      cost_9_s1_q <= cost_9_i;
      cost_10_s1_q <= cost_10_i;
      cost_11_s1_q <= cost_11_i;
      cost_12_s1_q <= cost_12_i;
      cost_13_s1_q <= cost_13_i;
      cost_14_s1_q <= cost_14_i;
      cost_15_s1_q <= cost_15_i;
      cost_16_s1_q <= cost_16_i;
      cost_17_s1_q <= cost_17_i;
      cost_18_s1_q <= cost_18_i;
      known_s1_q <= known_i;
      evident_s1_q <= evident_i;
      strong_v_s1_q <= strong_v_i;
      outside_values_24_s1_q <= outside_values_24_q;
      centres_values_23_grey_s1_q <= centres_values_23_grey_q;
      centres_values_23_exists_s1_q <= centres_values_23_exists_q;
      centres_values_23_marks_first_s1_q <= centres_values_23_marks_first_q;
      centres_values_23_marks_last_s1_q <= centres_values_23_marks_last_q;
      centres_values_23_marks_seen_s1_q <= centres_values_23_marks_seen_q;
      centres_values_23_marks_nearer_s1_q <= centres_values_23_marks_nearer_q;
      or_322_s1_q <= or_322;
      select_323_s1_q <= select_323[4:1];
      and_380_s1_q <= known_i & (~(select_323 == 5'h0));
      less_390_s1_q <= select_323 < 5'h3;
      less_405_s1_q <= select_323 < 5'h9;
      less_410_s1_q <= select_323 < 5'hd;
      less_420_s1_q <= cost_10_i < cost_8_i;
      less_446_s1_q <= cost_17_i < cost_16_i;
      less_450_s1_q <= cost_15_i < cost_14_i;
      less_452_s1_q <= cost_13_i < cost_12_i;
      select_459_s1_q <= (cost_5_i < cost_4_i) ? cost_5_i : cost_4_i;
      select_463_s1_q <= (cost_3_i < cost_2_i) ? cost_3_i : cost_2_i;
      select_465_s1_q <= (cost_1_i < cost_0_i) ? cost_1_i : cost_0_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [10:0] inside_next_q;
  logic [10:0] inside_here_q;
  logic [10:0] seen_values_0_inside_q;
  logic [10:0] seen_values_1_inside_q;
  logic [10:0] seen_values_2_inside_q;
  logic [10:0] seen_values_3_inside_q;
  logic [10:0] seen_values_4_inside_q;
  logic [10:0] seen_values_5_inside_q;
  logic [10:0] seen_values_6_inside_q;
  logic [10:0] seen_values_7_inside_q;
  logic [10:0] seen_values_8_inside_q;
  logic [10:0] seen_values_9_inside_q;
  logic [10:0] seen_values_10_inside_q;
  logic [10:0] seen_values_11_inside_q;
  logic [10:0] seen_values_12_inside_q;
  logic [10:0] seen_values_13_inside_q;
  logic [10:0] seen_values_14_inside_q;
  logic [10:0] seen_values_15_inside_q;
  logic [10:0] seen_values_16_inside_q;
  logic [10:0] seen_values_17_inside_q;
  logic [10:0] seen_values_18_inside_q;
  logic [10:0] seen_values_19_inside_q;
  logic [10:0] seen_values_20_inside_q;
  logic [10:0] seen_values_21_inside_q;
  logic [10:0] seen_values_22_inside_q;
  // hls/stages/contest.hpp:128
  logic [10:0] select_374;
  assign select_374 = known_s1_q ? cost_9_s1_q : 11'h7ff;
  logic [10:0] select_375;
  assign select_375 = or_322_s1_q ? 11'h7ff : inside_next_q;
  logic [10:0] select_381;
  assign select_381 = and_380_s1_q ? cost_10_s1_q : 11'h7ff;
  logic [10:0] select_387;
  assign select_387 = known_s1_q ? ((select_323_s1_q == 4'h0) ? 11'h7ff : cost_11_s1_q) : 11'h7ff;
  // hls/stages/contest.hpp:141
  logic less_393;
  assign less_393 = (known_s1_q ? (less_390_s1_q ? 11'h7ff : cost_12_s1_q) : 11'h7ff) < seen_values_1_inside_q;
  // hls/stages/contest.hpp:128
  logic [10:0] select_397;
  assign select_397 = known_s1_q ? ((select_323_s1_q[3:1] == 3'h0) ? 11'h7ff : cost_13_s1_q) : 11'h7ff;
  logic [10:0] select_402;
  assign select_402 = known_s1_q ? ((select_323_s1_q < 4'h3) ? 11'h7ff : cost_14_s1_q) : 11'h7ff;
  // hls/stages/contest.hpp:141
  logic less_408;
  assign less_408 = (known_s1_q ? (less_405_s1_q ? 11'h7ff : cost_15_s1_q) : 11'h7ff) < seen_values_7_inside_q;
  logic less_413;
  assign less_413 = (known_s1_q ? (less_410_s1_q ? 11'h7ff : cost_16_s1_q) : 11'h7ff) < seen_values_11_inside_q;
  // hls/stages/contest.hpp:128
  logic [10:0] select_417;
  assign select_417 = known_s1_q ? ((select_323_s1_q < 4'h9) ? 11'h7ff : cost_17_s1_q) : 11'h7ff;
  // hls/stages/contest.hpp:95
  logic [10:0] beside;
  assign beside = less_420_s1_q ? cost_10_s1_q : cost_8_s1_q;
  // hls/stages/contest.hpp:96
  logic less_422;
  assign less_422 = beside < cost_9_s1_q;
  // hls/stages/contest.hpp:97
  logic [10:0] outer;
  assign outer = less_420_s1_q ? cost_11_s1_q : cost_7_s1_q;
  // hls/stages/contest.hpp:155
  logic [11:0] value;
  assign value = {1'b0, outer} - {1'b0, beside};
  logic [11:0] value_2;
  assign value_2 = {1'b0, beside} - {1'b0, cost_9_s1_q};
  // hls/stages/planes.hpp:42
  logic [10:0] select_447;
  assign select_447 = less_446_s1_q ? cost_17_s1_q : cost_16_s1_q;
  logic [10:0] select_451;
  assign select_451 = less_450_s1_q ? cost_15_s1_q : cost_14_s1_q;
  logic [10:0] select_453;
  assign select_453 = less_452_s1_q ? cost_13_s1_q : cost_12_s1_q;
  logic [10:0] select_467;
  assign select_467 = (select_463_s1_q < select_465_s1_q) ? select_463_s1_q : select_465_s1_q;
  // hls/stages/contest.hpp:96
  logic [10:0] inside_v;
  assign inside_v = less_422 ? beside : cost_9_s1_q;
  // hls/stages/contest.hpp:128
  logic [10:0] select_493;
  assign select_493 = known_s1_q ? ((select_323_s1_q[3:2] == 2'h3) ? cost_18_s1_q : 11'h7ff) : 11'h7ff;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      inside_next_q <= 11'h0;
      inside_here_q <= 11'h0;
      seen_values_0_inside_q <= 11'h0;
      seen_values_1_inside_q <= 11'h0;
      seen_values_2_inside_q <= 11'h0;
      seen_values_3_inside_q <= 11'h0;
      seen_values_4_inside_q <= 11'h0;
      seen_values_5_inside_q <= 11'h0;
      seen_values_6_inside_q <= 11'h0;
      seen_values_7_inside_q <= 11'h0;
      seen_values_8_inside_q <= 11'h0;
      seen_values_9_inside_q <= 11'h0;
      seen_values_10_inside_q <= 11'h0;
      seen_values_11_inside_q <= 11'h0;
      seen_values_12_inside_q <= 11'h0;
      seen_values_13_inside_q <= 11'h0;
      seen_values_14_inside_q <= 11'h0;
      seen_values_15_inside_q <= 11'h0;
      seen_values_16_inside_q <= 11'h0;
      seen_values_17_inside_q <= 11'h0;
      seen_values_18_inside_q <= 11'h0;
      seen_values_19_inside_q <= 11'h0;
      seen_values_20_inside_q <= 11'h0;
      seen_values_21_inside_q <= 11'h0;
      seen_values_22_inside_q <= 11'h0;
    end else if (s1_en) begin
      inside_next_q <= known_s1_q ? cost_8_s1_q : 11'h7ff;
      inside_here_q <= (select_374 < select_375) ? select_374 : select_375;
      seen_values_0_inside_q <= (select_381 < inside_here_q) ? select_381 : inside_here_q;
      seen_values_1_inside_q <= seen_values_0_inside_q;
      seen_values_2_inside_q <= seen_values_1_inside_q;
      seen_values_3_inside_q <= seen_values_2_inside_q;
      seen_values_4_inside_q <= seen_values_3_inside_q;
      seen_values_5_inside_q <= seen_values_4_inside_q;
      seen_values_6_inside_q <= seen_values_5_inside_q;
      seen_values_7_inside_q <= seen_values_6_inside_q;
      seen_values_8_inside_q <= seen_values_7_inside_q;
      seen_values_9_inside_q <= seen_values_8_inside_q;
      seen_values_10_inside_q <= seen_values_9_inside_q;
      seen_values_11_inside_q <= seen_values_10_inside_q;
      seen_values_12_inside_q <= seen_values_11_inside_q;
      seen_values_13_inside_q <= seen_values_12_inside_q;
      seen_values_14_inside_q <= seen_values_13_inside_q;
      seen_values_15_inside_q <= seen_values_14_inside_q;
      seen_values_16_inside_q <= seen_values_15_inside_q;
      seen_values_17_inside_q <= seen_values_16_inside_q;
      seen_values_18_inside_q <= seen_values_17_inside_q;
      seen_values_19_inside_q <= seen_values_18_inside_q;
      seen_values_20_inside_q <= seen_values_19_inside_q;
      seen_values_21_inside_q <= seen_values_20_inside_q;
      seen_values_22_inside_q <= seen_values_21_inside_q;
    end
  end

  logic evident_s2_q;
  logic strong_v_s2_q;
  logic [10:0] outside_values_24_s2_q;
  logic [5:0] centres_values_23_grey_s2_q;
  logic centres_values_23_exists_s2_q;
  logic centres_values_23_marks_first_s2_q;
  logic centres_values_23_marks_last_s2_q;
  logic centres_values_23_marks_seen_s2_q;
  logic centres_values_23_marks_nearer_s2_q;
  logic less_388_s2_q;
  logic less_393_s2_q;
  logic less_398_s2_q;
  logic less_403_s2_q;
  logic less_408_s2_q;
  logic less_413_s2_q;
  logic less_418_s2_q;
  logic less_422_s2_q;
  logic [11:0] value_s2_q;
  logic [11:0] value_2_s2_q;
  logic [10:0] select_445_s2_q;
  logic [10:0] select_449_s2_q;
  logic [10:0] select_455_s2_q;
  logic [10:0] select_461_s2_q;
  logic [10:0] select_467_s2_q;
  logic [10:0] inside_v_s2_q;
  logic less_494_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      evident_s2_q <= evident_s1_q;
      strong_v_s2_q <= strong_v_s1_q;
      outside_values_24_s2_q <= outside_values_24_s1_q;
      centres_values_23_grey_s2_q <= centres_values_23_grey_s1_q;
      centres_values_23_exists_s2_q <= centres_values_23_exists_s1_q;
      centres_values_23_marks_first_s2_q <= centres_values_23_marks_first_s1_q;
      centres_values_23_marks_last_s2_q <= centres_values_23_marks_last_s1_q;
      centres_values_23_marks_seen_s2_q <= centres_values_23_marks_seen_s1_q;
      centres_values_23_marks_nearer_s2_q <= centres_values_23_marks_nearer_s1_q;
      less_388_s2_q <= select_387 < seen_values_0_inside_q;
      less_393_s2_q <= less_393;
      less_398_s2_q <= select_397 < seen_values_2_inside_q;
      less_403_s2_q <= select_402 < seen_values_4_inside_q;
      less_408_s2_q <= less_408;
      less_413_s2_q <= less_413;
      less_418_s2_q <= select_417 < seen_values_16_inside_q;
      less_422_s2_q <= less_422;
      value_s2_q <= value;
      value_2_s2_q <= value_2;
      select_445_s2_q <= (cost_11_s1_q < cost_7_s1_q) ? cost_11_s1_q : cost_7_s1_q;
      select_449_s2_q <= (cost_18_s1_q < select_447) ? cost_18_s1_q : select_447;
      select_455_s2_q <= (select_451 < select_453) ? select_451 : select_453;
      select_461_s2_q <= (cost_6_s1_q < select_459_s1_q) ? cost_6_s1_q : select_459_s1_q;
      select_467_s2_q <= select_467;
      inside_v_s2_q <= inside_v;
      less_494_s2_q <= select_493 < seen_values_22_inside_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic seen_values_0_hidden_q;
  logic seen_values_1_hidden_q;
  logic seen_values_2_hidden_q;
  logic seen_values_3_hidden_q;
  logic seen_values_4_hidden_q;
  logic seen_values_5_hidden_q;
  logic seen_values_6_hidden_q;
  logic seen_values_7_hidden_q;
  logic seen_values_8_hidden_q;
  logic seen_values_9_hidden_q;
  logic seen_values_10_hidden_q;
  logic seen_values_11_hidden_q;
  logic seen_values_12_hidden_q;
  logic seen_values_13_hidden_q;
  logic seen_values_14_hidden_q;
  logic seen_values_15_hidden_q;
  logic seen_values_16_hidden_q;
  logic seen_values_17_hidden_q;
  logic seen_values_18_hidden_q;
  logic seen_values_19_hidden_q;
  logic seen_values_20_hidden_q;
  logic seen_values_21_hidden_q;
  logic seen_values_22_hidden_q;
  // hls/stages/contest.hpp:161
  logic [10:0] select_425;
  assign select_425 = cfg_boundary_i[0] ? value_s2_q[11:1] : 11'h0;
  logic [11:0] select_426;
  assign select_426 = cfg_boundary_i[1] ? value_s2_q : 12'h0;
  logic [12:0] sum_427;
  assign sum_427 = {{2{select_425[10]}}, select_425} + {select_426[11], select_426};
  // hls/stages/contest.hpp:162
  logic [11:0] select_428;
  assign select_428 = cfg_boundary_i[2] ? value_s2_q : 12'h0;
  logic [11:0] select_429;
  assign select_429 = cfg_boundary_i[3] ? value_s2_q : 12'h0;
  logic [12:0] sum_430;
  assign sum_430 = {{2{select_428[11]}}, select_428[11:1]} + {select_429[11], select_429};
  // hls/stages/contest.hpp:161
  logic [10:0] select_436;
  assign select_436 = rest[0] ? value_2_s2_q[11:1] : 11'h0;
  logic [11:0] select_437;
  assign select_437 = rest[1] ? value_2_s2_q : 12'h0;
  logic [12:0] sum_438;
  assign sum_438 = {{2{select_436[10]}}, select_436} + {select_437[11], select_437};
  // hls/stages/contest.hpp:162
  logic [11:0] select_439;
  assign select_439 = rest[2] ? value_2_s2_q : 12'h0;
  logic [11:0] select_440;
  assign select_440 = rest[3] ? value_2_s2_q : 12'h0;
  logic [12:0] sum_441;
  assign sum_441 = {{2{select_439[11]}}, select_439[11:1]} + {select_440[11], select_440};
  // hls/stages/planes.hpp:42
  logic [10:0] select_457;
  assign select_457 = (select_449_s2_q < select_455_s2_q) ? select_449_s2_q : select_455_s2_q;
  logic [10:0] select_469;
  assign select_469 = (select_461_s2_q < select_467_s2_q) ? select_461_s2_q : select_467_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_values_0_hidden_q <= 1'b0;
      seen_values_1_hidden_q <= 1'b0;
      seen_values_2_hidden_q <= 1'b0;
      seen_values_3_hidden_q <= 1'b0;
      seen_values_4_hidden_q <= 1'b0;
      seen_values_5_hidden_q <= 1'b0;
      seen_values_6_hidden_q <= 1'b0;
      seen_values_7_hidden_q <= 1'b0;
      seen_values_8_hidden_q <= 1'b0;
      seen_values_9_hidden_q <= 1'b0;
      seen_values_10_hidden_q <= 1'b0;
      seen_values_11_hidden_q <= 1'b0;
      seen_values_12_hidden_q <= 1'b0;
      seen_values_13_hidden_q <= 1'b0;
      seen_values_14_hidden_q <= 1'b0;
      seen_values_15_hidden_q <= 1'b0;
      seen_values_16_hidden_q <= 1'b0;
      seen_values_17_hidden_q <= 1'b0;
      seen_values_18_hidden_q <= 1'b0;
      seen_values_19_hidden_q <= 1'b0;
      seen_values_20_hidden_q <= 1'b0;
      seen_values_21_hidden_q <= 1'b0;
      seen_values_22_hidden_q <= 1'b0;
    end else if (s2_en) begin
      seen_values_0_hidden_q <= outside_values_24_s2_q < seen_values_0_inside_q;
      seen_values_1_hidden_q <= seen_values_0_hidden_q | less_388_s2_q;
      seen_values_2_hidden_q <= seen_values_1_hidden_q | less_393_s2_q;
      seen_values_3_hidden_q <= seen_values_2_hidden_q | less_398_s2_q;
      seen_values_4_hidden_q <= seen_values_3_hidden_q;
      seen_values_5_hidden_q <= seen_values_4_hidden_q | less_403_s2_q;
      seen_values_6_hidden_q <= seen_values_5_hidden_q;
      seen_values_7_hidden_q <= seen_values_6_hidden_q;
      seen_values_8_hidden_q <= seen_values_7_hidden_q | less_408_s2_q;
      seen_values_9_hidden_q <= seen_values_8_hidden_q;
      seen_values_10_hidden_q <= seen_values_9_hidden_q;
      seen_values_11_hidden_q <= seen_values_10_hidden_q;
      seen_values_12_hidden_q <= seen_values_11_hidden_q | less_413_s2_q;
      seen_values_13_hidden_q <= seen_values_12_hidden_q;
      seen_values_14_hidden_q <= seen_values_13_hidden_q;
      seen_values_15_hidden_q <= seen_values_14_hidden_q;
      seen_values_16_hidden_q <= seen_values_15_hidden_q;
      seen_values_17_hidden_q <= seen_values_16_hidden_q | less_418_s2_q;
      seen_values_18_hidden_q <= seen_values_17_hidden_q;
      seen_values_19_hidden_q <= seen_values_18_hidden_q;
      seen_values_20_hidden_q <= seen_values_19_hidden_q;
      seen_values_21_hidden_q <= seen_values_20_hidden_q;
      seen_values_22_hidden_q <= seen_values_21_hidden_q;
    end
  end

  logic evident_s3_q;
  logic strong_v_s3_q;
  logic [5:0] centres_values_23_grey_s3_q;
  logic centres_values_23_exists_s3_q;
  logic centres_values_23_marks_first_s3_q;
  logic centres_values_23_marks_last_s3_q;
  logic centres_values_23_marks_seen_s3_q;
  logic centres_values_23_marks_nearer_s3_q;
  logic less_422_s3_q;
  logic [11:0] sum_427_s3_q;
  logic select_428_s3_q;
  logic [12:0] sum_430_s3_q;
  logic [11:0] sum_438_s3_q;
  logic select_439_s3_q;
  logic [12:0] sum_441_s3_q;
  logic [10:0] select_445_s3_q;
  logic [10:0] select_457_s3_q;
  logic [10:0] select_469_s3_q;
  logic [10:0] inside_v_s3_q;
  logic or_495_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      evident_s3_q <= evident_s2_q;
      strong_v_s3_q <= strong_v_s2_q;
      centres_values_23_grey_s3_q <= centres_values_23_grey_s2_q;
      centres_values_23_exists_s3_q <= centres_values_23_exists_s2_q;
      centres_values_23_marks_first_s3_q <= centres_values_23_marks_first_s2_q;
      centres_values_23_marks_last_s3_q <= centres_values_23_marks_last_s2_q;
      centres_values_23_marks_seen_s3_q <= centres_values_23_marks_seen_s2_q;
      centres_values_23_marks_nearer_s3_q <= centres_values_23_marks_nearer_s2_q;
      less_422_s3_q <= less_422_s2_q;
      sum_427_s3_q <= sum_427[12:1];
      select_428_s3_q <= select_428[0];
      sum_430_s3_q <= sum_430;
      sum_438_s3_q <= sum_438[12:1];
      select_439_s3_q <= select_439[0];
      sum_441_s3_q <= sum_441;
      select_445_s3_q <= select_445_s2_q;
      select_457_s3_q <= select_457;
      select_469_s3_q <= select_469;
      inside_v_s3_q <= inside_v_s2_q;
      or_495_s3_q <= seen_values_22_hidden_q | less_494_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:163
  logic [14:0] sum_431;
  assign sum_431 = {{3{sum_427_s3_q[11]}}, sum_427_s3_q} + {sum_430_s3_q[12], sum_430_s3_q, select_428_s3_q};
  logic [14:0] sum_442;
  assign sum_442 = {{3{sum_438_s3_q[11]}}, sum_438_s3_q} + {sum_441_s3_q[12], sum_441_s3_q, select_439_s3_q};
  // hls/stages/contest.hpp:155
  logic [14:0] b;
  assign b = {sum_431[14], sum_431[14:1]} + {sum_442[14], sum_442[14:1]};
  // hls/stages/contest.hpp:93
  logic [10:0] far;
  assign far = (select_457_s3_q < select_469_s3_q) ? select_457_s3_q : select_469_s3_q;

  logic evident_s4_q;
  logic strong_v_s4_q;
  logic [5:0] centres_values_23_grey_s4_q;
  logic centres_values_23_exists_s4_q;
  logic centres_values_23_marks_first_s4_q;
  logic centres_values_23_marks_last_s4_q;
  logic centres_values_23_marks_seen_s4_q;
  logic centres_values_23_marks_nearer_s4_q;
  logic less_422_s4_q;
  logic [14:0] b_s4_q;
  logic [10:0] select_445_s4_q;
  logic [10:0] far_s4_q;
  logic [10:0] inside_v_s4_q;
  logic or_495_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      evident_s4_q <= evident_s3_q;
      strong_v_s4_q <= strong_v_s3_q;
      centres_values_23_grey_s4_q <= centres_values_23_grey_s3_q;
      centres_values_23_exists_s4_q <= centres_values_23_exists_s3_q;
      centres_values_23_marks_first_s4_q <= centres_values_23_marks_first_s3_q;
      centres_values_23_marks_last_s4_q <= centres_values_23_marks_last_s3_q;
      centres_values_23_marks_seen_s4_q <= centres_values_23_marks_seen_s3_q;
      centres_values_23_marks_nearer_s4_q <= centres_values_23_marks_nearer_s3_q;
      less_422_s4_q <= less_422_s3_q;
      b_s4_q <= b;
      select_445_s4_q <= select_445_s3_q;
      far_s4_q <= far;
      inside_v_s4_q <= inside_v_s3_q;
      or_495_s4_q <= or_495_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:94
  logic [10:0] outside;
  assign outside = (select_445_s4_q < far_s4_q) ? select_445_s4_q : far_s4_q;
  // hls/stages/contest.hpp:101
  logic less_485;
  assign less_485 = {1'b0, far_s4_q} < ({1'b0, inside_v_s4_q} + {5'h0, inside_v_s4_q[10:4]});

  logic evident_s5_q;
  logic strong_v_s5_q;
  logic [5:0] centres_values_23_grey_s5_q;
  logic centres_values_23_exists_s5_q;
  logic centres_values_23_marks_first_s5_q;
  logic centres_values_23_marks_last_s5_q;
  logic centres_values_23_marks_seen_s5_q;
  logic centres_values_23_marks_nearer_s5_q;
  logic less_422_s5_q;
  logic [14:0] b_s5_q;
  logic [10:0] outside_s5_q;
  logic [10:0] inside_v_s5_q;
  logic not_486_s5_q;
  logic or_495_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      evident_s5_q <= evident_s4_q;
      strong_v_s5_q <= strong_v_s4_q;
      centres_values_23_grey_s5_q <= centres_values_23_grey_s4_q;
      centres_values_23_exists_s5_q <= centres_values_23_exists_s4_q;
      centres_values_23_marks_first_s5_q <= centres_values_23_marks_first_s4_q;
      centres_values_23_marks_last_s5_q <= centres_values_23_marks_last_s4_q;
      centres_values_23_marks_seen_s5_q <= centres_values_23_marks_seen_s4_q;
      centres_values_23_marks_nearer_s5_q <= centres_values_23_marks_nearer_s4_q;
      less_422_s5_q <= less_422_s4_q;
      b_s5_q <= b_s4_q;
      outside_s5_q <= outside;
      inside_v_s5_q <= inside_v_s4_q;
      not_486_s5_q <= ~less_485;
      or_495_s5_q <= or_495_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic centres_values_0_votes_q;
  logic centres_values_1_votes_q;
  logic centres_values_2_votes_q;
  logic centres_values_3_votes_q;
  logic centres_values_4_votes_q;
  logic centres_values_5_votes_q;
  logic centres_values_6_votes_q;
  logic centres_values_7_votes_q;
  logic centres_values_8_votes_q;
  logic centres_values_9_votes_q;
  logic centres_values_10_votes_q;
  logic centres_values_11_votes_q;
  logic centres_values_12_votes_q;
  logic centres_values_13_votes_q;
  logic centres_values_14_votes_q;
  logic centres_values_15_votes_q;
  logic centres_values_16_votes_q;
  logic centres_values_17_votes_q;
  logic centres_values_18_votes_q;
  logic centres_values_19_votes_q;
  logic centres_values_20_votes_q;
  logic centres_values_21_votes_q;
  logic centres_values_22_votes_q;
  logic centres_values_23_votes_q;
  // hls/stages/contest.hpp:99
  logic [11:0] z;
  assign z = {1'b0, outside_s5_q} - {1'b0, inside_v_s5_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      centres_values_0_votes_q <= 1'b0;
      centres_values_1_votes_q <= 1'b0;
      centres_values_2_votes_q <= 1'b0;
      centres_values_3_votes_q <= 1'b0;
      centres_values_4_votes_q <= 1'b0;
      centres_values_5_votes_q <= 1'b0;
      centres_values_6_votes_q <= 1'b0;
      centres_values_7_votes_q <= 1'b0;
      centres_values_8_votes_q <= 1'b0;
      centres_values_9_votes_q <= 1'b0;
      centres_values_10_votes_q <= 1'b0;
      centres_values_11_votes_q <= 1'b0;
      centres_values_12_votes_q <= 1'b0;
      centres_values_13_votes_q <= 1'b0;
      centres_values_14_votes_q <= 1'b0;
      centres_values_15_votes_q <= 1'b0;
      centres_values_16_votes_q <= 1'b0;
      centres_values_17_votes_q <= 1'b0;
      centres_values_18_votes_q <= 1'b0;
      centres_values_19_votes_q <= 1'b0;
      centres_values_20_votes_q <= 1'b0;
      centres_values_21_votes_q <= 1'b0;
      centres_values_22_votes_q <= 1'b0;
      centres_values_23_votes_q <= 1'b0;
    end else if (s5_en) begin
      centres_values_0_votes_q <= evident_s5_q & ((outside_s5_q < inside_v_s5_q) | not_486_s5_q);
      centres_values_1_votes_q <= centres_values_0_votes_q;
      centres_values_2_votes_q <= centres_values_1_votes_q;
      centres_values_3_votes_q <= centres_values_2_votes_q;
      centres_values_4_votes_q <= centres_values_3_votes_q;
      centres_values_5_votes_q <= centres_values_4_votes_q;
      centres_values_6_votes_q <= centres_values_5_votes_q;
      centres_values_7_votes_q <= centres_values_6_votes_q;
      centres_values_8_votes_q <= centres_values_7_votes_q;
      centres_values_9_votes_q <= centres_values_8_votes_q;
      centres_values_10_votes_q <= centres_values_9_votes_q;
      centres_values_11_votes_q <= centres_values_10_votes_q;
      centres_values_12_votes_q <= centres_values_11_votes_q;
      centres_values_13_votes_q <= centres_values_12_votes_q;
      centres_values_14_votes_q <= centres_values_13_votes_q;
      centres_values_15_votes_q <= centres_values_14_votes_q;
      centres_values_16_votes_q <= centres_values_15_votes_q;
      centres_values_17_votes_q <= centres_values_16_votes_q;
      centres_values_18_votes_q <= centres_values_17_votes_q;
      centres_values_19_votes_q <= centres_values_18_votes_q;
      centres_values_20_votes_q <= centres_values_19_votes_q;
      centres_values_21_votes_q <= centres_values_20_votes_q;
      centres_values_22_votes_q <= centres_values_21_votes_q;
      centres_values_23_votes_q <= centres_values_22_votes_q;
    end
  end

  logic strong_v_s6_q;
  logic centres_values_23_votes_s6_q;
  logic [5:0] centres_values_23_grey_s6_q;
  logic centres_values_23_exists_s6_q;
  logic centres_values_23_marks_first_s6_q;
  logic centres_values_23_marks_last_s6_q;
  logic centres_values_23_marks_seen_s6_q;
  logic centres_values_23_marks_nearer_s6_q;
  logic less_422_s6_q;
  logic [14:0] b_s6_q;
  logic [11:0] z_s6_q;
  logic less_476_s6_q;
  logic or_495_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      strong_v_s6_q <= strong_v_s5_q;
      centres_values_23_votes_s6_q <= centres_values_23_votes_q;
      centres_values_23_grey_s6_q <= centres_values_23_grey_s5_q;
      centres_values_23_exists_s6_q <= centres_values_23_exists_s5_q;
      centres_values_23_marks_first_s6_q <= centres_values_23_marks_first_s5_q;
      centres_values_23_marks_last_s6_q <= centres_values_23_marks_last_s5_q;
      centres_values_23_marks_seen_s6_q <= centres_values_23_marks_seen_s5_q;
      centres_values_23_marks_nearer_s6_q <= centres_values_23_marks_nearer_s5_q;
      less_422_s6_q <= less_422_s5_q;
      b_s6_q <= b_s5_q;
      z_s6_q <= z;
      less_476_s6_q <= $signed(b_s5_q) < $signed({{3{z[11]}}, z});
      or_495_s6_q <= or_495_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:100
  logic [14:0] z_2;
  assign z_2 = less_422_s6_q ? (less_476_s6_q ? b_s6_q : {{3{z_s6_q[11]}}, z_s6_q}) : {{3{z_s6_q[11]}}, z_s6_q};

  logic strong_v_s7_q;
  logic centres_values_23_votes_s7_q;
  logic [5:0] centres_values_23_grey_s7_q;
  logic centres_values_23_exists_s7_q;
  logic centres_values_23_marks_first_s7_q;
  logic centres_values_23_marks_last_s7_q;
  logic centres_values_23_marks_seen_s7_q;
  logic centres_values_23_marks_nearer_s7_q;
  logic less_479_s7_q;
  logic [5:0] select_481_s7_q;
  logic less_489_s7_q;
  logic or_495_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      strong_v_s7_q <= strong_v_s6_q;
      centres_values_23_votes_s7_q <= centres_values_23_votes_s6_q;
      centres_values_23_grey_s7_q <= centres_values_23_grey_s6_q;
      centres_values_23_exists_s7_q <= centres_values_23_exists_s6_q;
      centres_values_23_marks_first_s7_q <= centres_values_23_marks_first_s6_q;
      centres_values_23_marks_last_s7_q <= centres_values_23_marks_last_s6_q;
      centres_values_23_marks_seen_s7_q <= centres_values_23_marks_seen_s6_q;
      centres_values_23_marks_nearer_s7_q <= centres_values_23_marks_nearer_s6_q;
      less_479_s7_q <= $signed(z_2[14:3]) < $signed(12'hfe1);
      select_481_s7_q <= ($signed(7'h0) < $signed(z_2[14:8])) ? 6'h1f : z_2[8:3];
      less_489_s7_q <= $signed(z_2) < $signed(15'h7e01);
      or_495_s7_q <= or_495_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [5:0] centres_values_0_clipped_q;
  logic centres_values_0_firm_q;
  logic [5:0] centres_values_1_clipped_q;
  logic centres_values_1_firm_q;
  logic [5:0] centres_values_2_clipped_q;
  logic centres_values_2_firm_q;
  logic [5:0] centres_values_3_clipped_q;
  logic centres_values_3_firm_q;
  logic [5:0] centres_values_4_clipped_q;
  logic centres_values_4_firm_q;
  logic [5:0] centres_values_5_clipped_q;
  logic centres_values_5_firm_q;
  logic [5:0] centres_values_6_clipped_q;
  logic centres_values_6_firm_q;
  logic [5:0] centres_values_7_clipped_q;
  logic centres_values_7_firm_q;
  logic [5:0] centres_values_8_clipped_q;
  logic centres_values_8_firm_q;
  logic [5:0] centres_values_9_clipped_q;
  logic centres_values_9_firm_q;
  logic [5:0] centres_values_10_clipped_q;
  logic centres_values_10_firm_q;
  logic [5:0] centres_values_11_clipped_q;
  logic centres_values_11_firm_q;
  logic [5:0] centres_values_12_clipped_q;
  logic centres_values_12_firm_q;
  logic [5:0] centres_values_13_clipped_q;
  logic centres_values_13_firm_q;
  logic [5:0] centres_values_14_clipped_q;
  logic centres_values_14_firm_q;
  logic [5:0] centres_values_15_clipped_q;
  logic centres_values_15_firm_q;
  logic [5:0] centres_values_16_clipped_q;
  logic centres_values_16_firm_q;
  logic [5:0] centres_values_17_clipped_q;
  logic centres_values_17_firm_q;
  logic [5:0] centres_values_18_clipped_q;
  logic centres_values_18_firm_q;
  logic [5:0] centres_values_19_clipped_q;
  logic centres_values_19_firm_q;
  logic [5:0] centres_values_20_clipped_q;
  logic centres_values_20_firm_q;
  logic [5:0] centres_values_21_clipped_q;
  logic centres_values_21_firm_q;
  logic [5:0] centres_values_22_clipped_q;
  logic centres_values_22_firm_q;
  logic [5:0] centres_values_23_clipped_q;
  logic centres_values_23_firm_q;
  // hls/stages/contest.hpp:61
  logic [5:0] select_497;
  assign select_497 = ($signed(6'h38) < $signed(centres_values_23_clipped_q)) ? 6'h38 : centres_values_23_clipped_q;
  logic [5:0] clipped;
  assign clipped = or_495_s7_q ? select_497 : centres_values_23_clipped_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      centres_values_0_clipped_q <= 6'h0;
      centres_values_0_firm_q <= 1'b0;
      centres_values_1_clipped_q <= 6'h0;
      centres_values_1_firm_q <= 1'b0;
      centres_values_2_clipped_q <= 6'h0;
      centres_values_2_firm_q <= 1'b0;
      centres_values_3_clipped_q <= 6'h0;
      centres_values_3_firm_q <= 1'b0;
      centres_values_4_clipped_q <= 6'h0;
      centres_values_4_firm_q <= 1'b0;
      centres_values_5_clipped_q <= 6'h0;
      centres_values_5_firm_q <= 1'b0;
      centres_values_6_clipped_q <= 6'h0;
      centres_values_6_firm_q <= 1'b0;
      centres_values_7_clipped_q <= 6'h0;
      centres_values_7_firm_q <= 1'b0;
      centres_values_8_clipped_q <= 6'h0;
      centres_values_8_firm_q <= 1'b0;
      centres_values_9_clipped_q <= 6'h0;
      centres_values_9_firm_q <= 1'b0;
      centres_values_10_clipped_q <= 6'h0;
      centres_values_10_firm_q <= 1'b0;
      centres_values_11_clipped_q <= 6'h0;
      centres_values_11_firm_q <= 1'b0;
      centres_values_12_clipped_q <= 6'h0;
      centres_values_12_firm_q <= 1'b0;
      centres_values_13_clipped_q <= 6'h0;
      centres_values_13_firm_q <= 1'b0;
      centres_values_14_clipped_q <= 6'h0;
      centres_values_14_firm_q <= 1'b0;
      centres_values_15_clipped_q <= 6'h0;
      centres_values_15_firm_q <= 1'b0;
      centres_values_16_clipped_q <= 6'h0;
      centres_values_16_firm_q <= 1'b0;
      centres_values_17_clipped_q <= 6'h0;
      centres_values_17_firm_q <= 1'b0;
      centres_values_18_clipped_q <= 6'h0;
      centres_values_18_firm_q <= 1'b0;
      centres_values_19_clipped_q <= 6'h0;
      centres_values_19_firm_q <= 1'b0;
      centres_values_20_clipped_q <= 6'h0;
      centres_values_20_firm_q <= 1'b0;
      centres_values_21_clipped_q <= 6'h0;
      centres_values_21_firm_q <= 1'b0;
      centres_values_22_clipped_q <= 6'h0;
      centres_values_22_firm_q <= 1'b0;
      centres_values_23_clipped_q <= 6'h0;
      centres_values_23_firm_q <= 1'b0;
    end else if (s7_en) begin
      centres_values_0_clipped_q <= less_479_s7_q ? 6'h21 : select_481_s7_q;
      centres_values_0_firm_q <= strong_v_s7_q & less_489_s7_q;
      centres_values_1_clipped_q <= centres_values_0_clipped_q;
      centres_values_1_firm_q <= centres_values_0_firm_q;
      centres_values_2_clipped_q <= centres_values_1_clipped_q;
      centres_values_2_firm_q <= centres_values_1_firm_q;
      centres_values_3_clipped_q <= centres_values_2_clipped_q;
      centres_values_3_firm_q <= centres_values_2_firm_q;
      centres_values_4_clipped_q <= centres_values_3_clipped_q;
      centres_values_4_firm_q <= centres_values_3_firm_q;
      centres_values_5_clipped_q <= centres_values_4_clipped_q;
      centres_values_5_firm_q <= centres_values_4_firm_q;
      centres_values_6_clipped_q <= centres_values_5_clipped_q;
      centres_values_6_firm_q <= centres_values_5_firm_q;
      centres_values_7_clipped_q <= centres_values_6_clipped_q;
      centres_values_7_firm_q <= centres_values_6_firm_q;
      centres_values_8_clipped_q <= centres_values_7_clipped_q;
      centres_values_8_firm_q <= centres_values_7_firm_q;
      centres_values_9_clipped_q <= centres_values_8_clipped_q;
      centres_values_9_firm_q <= centres_values_8_firm_q;
      centres_values_10_clipped_q <= centres_values_9_clipped_q;
      centres_values_10_firm_q <= centres_values_9_firm_q;
      centres_values_11_clipped_q <= centres_values_10_clipped_q;
      centres_values_11_firm_q <= centres_values_10_firm_q;
      centres_values_12_clipped_q <= centres_values_11_clipped_q;
      centres_values_12_firm_q <= centres_values_11_firm_q;
      centres_values_13_clipped_q <= centres_values_12_clipped_q;
      centres_values_13_firm_q <= centres_values_12_firm_q;
      centres_values_14_clipped_q <= centres_values_13_clipped_q;
      centres_values_14_firm_q <= centres_values_13_firm_q;
      centres_values_15_clipped_q <= centres_values_14_clipped_q;
      centres_values_15_firm_q <= centres_values_14_firm_q;
      centres_values_16_clipped_q <= centres_values_15_clipped_q;
      centres_values_16_firm_q <= centres_values_15_firm_q;
      centres_values_17_clipped_q <= centres_values_16_clipped_q;
      centres_values_17_firm_q <= centres_values_16_firm_q;
      centres_values_18_clipped_q <= centres_values_17_clipped_q;
      centres_values_18_firm_q <= centres_values_17_firm_q;
      centres_values_19_clipped_q <= centres_values_18_clipped_q;
      centres_values_19_firm_q <= centres_values_18_firm_q;
      centres_values_20_clipped_q <= centres_values_19_clipped_q;
      centres_values_20_firm_q <= centres_values_19_firm_q;
      centres_values_21_clipped_q <= centres_values_20_clipped_q;
      centres_values_21_firm_q <= centres_values_20_firm_q;
      centres_values_22_clipped_q <= centres_values_21_clipped_q;
      centres_values_22_firm_q <= centres_values_21_firm_q;
      centres_values_23_clipped_q <= centres_values_22_clipped_q;
      centres_values_23_firm_q <= centres_values_22_firm_q;
    end
  end

  logic centres_values_23_votes_s8_q;
  logic centres_values_23_firm_s8_q;
  logic [5:0] centres_values_23_grey_s8_q;
  logic centres_values_23_exists_s8_q;
  logic centres_values_23_marks_first_s8_q;
  logic centres_values_23_marks_last_s8_q;
  logic centres_values_23_marks_seen_s8_q;
  logic centres_values_23_marks_nearer_s8_q;
  logic [5:0] clipped_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      centres_values_23_votes_s8_q <= centres_values_23_votes_s7_q;
      centres_values_23_firm_s8_q <= centres_values_23_firm_q;
      centres_values_23_grey_s8_q <= centres_values_23_grey_s7_q;
      centres_values_23_exists_s8_q <= centres_values_23_exists_s7_q;
      centres_values_23_marks_first_s8_q <= centres_values_23_marks_first_s7_q;
      centres_values_23_marks_last_s8_q <= centres_values_23_marks_last_s7_q;
      centres_values_23_marks_seen_s8_q <= centres_values_23_marks_seen_s7_q;
      centres_values_23_marks_nearer_s8_q <= centres_values_23_marks_nearer_s7_q;
      clipped_s8_q <= clipped;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:63
  logic and_501;
  assign and_501 = centres_values_23_votes_s8_q & (~(clipped_s8_q == 6'h0));
  // hls/stages/contest.hpp:67
  logic [6:0] select_503;
  assign select_503 = and_501 ? ({3'h0, cfg_bias_i} + {clipped_s8_q[5], clipped_s8_q}) : 7'h0;

  logic [5:0] centres_values_23_grey_s9_q;
  logic centres_values_23_exists_s9_q;
  logic centres_values_23_marks_first_s9_q;
  logic centres_values_23_marks_last_s9_q;
  logic centres_values_23_marks_seen_s9_q;
  logic centres_values_23_marks_nearer_s9_q;
  logic [6:0] select_503_s9_q;
  logic and_504_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      centres_values_23_grey_s9_q <= centres_values_23_grey_s8_q;
      centres_values_23_exists_s9_q <= centres_values_23_exists_s8_q;
      centres_values_23_marks_first_s9_q <= centres_values_23_marks_first_s8_q;
      centres_values_23_marks_last_s9_q <= centres_values_23_marks_last_s8_q;
      centres_values_23_marks_seen_s9_q <= centres_values_23_marks_seen_s8_q;
      centres_values_23_marks_nearer_s9_q <= centres_values_23_marks_nearer_s8_q;
      select_503_s9_q <= select_503;
      and_504_s9_q <= centres_values_23_firm_s8_q & and_501;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign vote_o = select_503_s9_q;
  assign firm_o = and_504_s9_q;
  assign grey_o = centres_values_23_grey_s9_q;
  assign exists_o = centres_values_23_exists_s9_q;
  assign marks_first_o = centres_values_23_marks_first_s9_q;
  assign marks_last_o = centres_values_23_marks_last_s9_q;
  assign marks_seen_o = centres_values_23_marks_seen_s9_q;
  assign marks_nearer_o = centres_values_23_marks_nearer_s9_q;
  assign valid_o = valid_s9_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_442[0], sum_438[0], sum_431[0], sum_427[0]};

endmodule
