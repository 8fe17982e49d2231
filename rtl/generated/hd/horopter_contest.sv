// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contest<horopter::hls::profiles::hd>, hls/stages/contest.hpp. Do not edit.
//
// Latency 8 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 785 bits, pipeline 533 bits, memories 0 bits.
module horopter_contest (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [11:0] cost_0_i,
  input  logic [11:0] cost_1_i,
  input  logic [11:0] cost_2_i,
  input  logic [11:0] cost_3_i,
  input  logic [11:0] cost_4_i,
  input  logic [11:0] cost_5_i,
  input  logic [11:0] cost_6_i,
  input  logic [11:0] cost_7_i,
  input  logic [11:0] cost_8_i,
  input  logic [11:0] cost_9_i,
  input  logic [11:0] cost_10_i,
  input  logic [11:0] cost_11_i,
  input  logic [11:0] cost_12_i,
  input  logic [5:0] grey_i,
  input  logic known_i,
  input  logic evident_i,
  input  logic strong_v_i,
  input  logic exists_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [3:0] cfg_bias_i,
  input  logic [3:0] cfg_boundary_i,
  output logic valid_o,
  output logic signed [6:0] vote_o,
  output logic firm_o,
  output logic [5:0] grey_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;

  // Of the configuration alone: not pipelined.
  logic [3:0] rest;
  assign rest = (cfg_boundary_i == 4'hf) ? 4'h0 : (4'he - cfg_boundary_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic row_ended_q;
  logic [4:0] columns_q;
  logic [11:0] outside_values_0_q;
  logic [11:0] outside_values_1_q;
  logic [11:0] outside_values_2_q;
  logic [11:0] outside_values_3_q;
  logic [11:0] outside_values_4_q;
  logic [11:0] outside_values_5_q;
  logic [11:0] outside_values_6_q;
  logic [11:0] outside_values_7_q;
  logic [11:0] outside_values_8_q;
  logic [11:0] outside_values_9_q;
  logic [11:0] outside_values_10_q;
  logic [11:0] outside_values_11_q;
  logic [11:0] outside_values_12_q;
  logic [11:0] outside_values_13_q;
  logic [11:0] outside_values_14_q;
  logic [11:0] outside_values_15_q;
  logic [11:0] outside_values_16_q;
  logic [11:0] outside_values_17_q;
  logic [11:0] outside_values_18_q;
  logic [5:0] centres_values_0_grey_q;
  logic centres_values_0_exists_q;
  logic centres_values_0_marks_first_q;
  logic centres_values_0_marks_last_q;
  logic [5:0] centres_values_1_grey_q;
  logic centres_values_1_exists_q;
  logic centres_values_1_marks_first_q;
  logic centres_values_1_marks_last_q;
  logic [5:0] centres_values_2_grey_q;
  logic centres_values_2_exists_q;
  logic centres_values_2_marks_first_q;
  logic centres_values_2_marks_last_q;
  logic [5:0] centres_values_3_grey_q;
  logic centres_values_3_exists_q;
  logic centres_values_3_marks_first_q;
  logic centres_values_3_marks_last_q;
  logic [5:0] centres_values_4_grey_q;
  logic centres_values_4_exists_q;
  logic centres_values_4_marks_first_q;
  logic centres_values_4_marks_last_q;
  logic [5:0] centres_values_5_grey_q;
  logic centres_values_5_exists_q;
  logic centres_values_5_marks_first_q;
  logic centres_values_5_marks_last_q;
  logic [5:0] centres_values_6_grey_q;
  logic centres_values_6_exists_q;
  logic centres_values_6_marks_first_q;
  logic centres_values_6_marks_last_q;
  logic [5:0] centres_values_7_grey_q;
  logic centres_values_7_exists_q;
  logic centres_values_7_marks_first_q;
  logic centres_values_7_marks_last_q;
  logic [5:0] centres_values_8_grey_q;
  logic centres_values_8_exists_q;
  logic centres_values_8_marks_first_q;
  logic centres_values_8_marks_last_q;
  logic [5:0] centres_values_9_grey_q;
  logic centres_values_9_exists_q;
  logic centres_values_9_marks_first_q;
  logic centres_values_9_marks_last_q;
  logic [5:0] centres_values_10_grey_q;
  logic centres_values_10_exists_q;
  logic centres_values_10_marks_first_q;
  logic centres_values_10_marks_last_q;
  logic [5:0] centres_values_11_grey_q;
  logic centres_values_11_exists_q;
  logic centres_values_11_marks_first_q;
  logic centres_values_11_marks_last_q;
  logic [5:0] centres_values_12_grey_q;
  logic centres_values_12_exists_q;
  logic centres_values_12_marks_first_q;
  logic centres_values_12_marks_last_q;
  logic [5:0] centres_values_13_grey_q;
  logic centres_values_13_exists_q;
  logic centres_values_13_marks_first_q;
  logic centres_values_13_marks_last_q;
  logic [5:0] centres_values_14_grey_q;
  logic centres_values_14_exists_q;
  logic centres_values_14_marks_first_q;
  logic centres_values_14_marks_last_q;
  logic [5:0] centres_values_15_grey_q;
  logic centres_values_15_exists_q;
  logic centres_values_15_marks_first_q;
  logic centres_values_15_marks_last_q;
  logic [5:0] centres_values_16_grey_q;
  logic centres_values_16_exists_q;
  logic centres_values_16_marks_first_q;
  logic centres_values_16_marks_last_q;
  logic [5:0] centres_values_17_grey_q;
  logic centres_values_17_exists_q;
  logic centres_values_17_marks_first_q;
  logic centres_values_17_marks_last_q;
  // hls/stages/contest.hpp:56
  logic or_206;
  assign or_206 = marks_first_i | row_ended_q;
  // hls/stages/contest.hpp:133
  logic [4:0] select_207;
  assign select_207 = or_206 ? 5'h0 : columns_q;
  // hls/stages/contest.hpp:148
  logic not_209;
  assign not_209 = ~(select_207 == 5'h12);
  // hls/stages/contest.hpp:133
  logic [11:0] select_219;
  assign select_219 = known_i ? cost_1_i : 12'hfff;
  logic [11:0] select_220;
  assign select_220 = or_206 ? 12'hfff : outside_values_7_q;
  logic [11:0] select_226;
  assign select_226 = known_i ? cost_2_i : 12'hfff;
  logic [11:0] select_227;
  assign select_227 = or_206 ? 12'hfff : outside_values_11_q;
  logic [11:0] select_232;
  assign select_232 = known_i ? cost_3_i : 12'hfff;
  logic [11:0] select_233;
  assign select_233 = or_206 ? 12'hfff : outside_values_14_q;
  logic [11:0] select_236;
  assign select_236 = known_i ? cost_4_i : 12'hfff;
  logic [11:0] select_237;
  assign select_237 = or_206 ? 12'hfff : outside_values_15_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_ended_q <= 1'b1;
      columns_q <= 5'h0;
      outside_values_0_q <= 12'h0;
      outside_values_1_q <= 12'h0;
      outside_values_2_q <= 12'h0;
      outside_values_3_q <= 12'h0;
      outside_values_4_q <= 12'h0;
      outside_values_5_q <= 12'h0;
      outside_values_6_q <= 12'h0;
      outside_values_7_q <= 12'h0;
      outside_values_8_q <= 12'h0;
      outside_values_9_q <= 12'h0;
      outside_values_10_q <= 12'h0;
      outside_values_11_q <= 12'h0;
      outside_values_12_q <= 12'h0;
      outside_values_13_q <= 12'h0;
      outside_values_14_q <= 12'h0;
      outside_values_15_q <= 12'h0;
      outside_values_16_q <= 12'h0;
      outside_values_17_q <= 12'h0;
      outside_values_18_q <= 12'h0;
      centres_values_0_grey_q <= 6'h0;
      centres_values_0_exists_q <= 1'b0;
      centres_values_0_marks_first_q <= 1'b0;
      centres_values_0_marks_last_q <= 1'b0;
      centres_values_1_grey_q <= 6'h0;
      centres_values_1_exists_q <= 1'b0;
      centres_values_1_marks_first_q <= 1'b0;
      centres_values_1_marks_last_q <= 1'b0;
      centres_values_2_grey_q <= 6'h0;
      centres_values_2_exists_q <= 1'b0;
      centres_values_2_marks_first_q <= 1'b0;
      centres_values_2_marks_last_q <= 1'b0;
      centres_values_3_grey_q <= 6'h0;
      centres_values_3_exists_q <= 1'b0;
      centres_values_3_marks_first_q <= 1'b0;
      centres_values_3_marks_last_q <= 1'b0;
      centres_values_4_grey_q <= 6'h0;
      centres_values_4_exists_q <= 1'b0;
      centres_values_4_marks_first_q <= 1'b0;
      centres_values_4_marks_last_q <= 1'b0;
      centres_values_5_grey_q <= 6'h0;
      centres_values_5_exists_q <= 1'b0;
      centres_values_5_marks_first_q <= 1'b0;
      centres_values_5_marks_last_q <= 1'b0;
      centres_values_6_grey_q <= 6'h0;
      centres_values_6_exists_q <= 1'b0;
      centres_values_6_marks_first_q <= 1'b0;
      centres_values_6_marks_last_q <= 1'b0;
      centres_values_7_grey_q <= 6'h0;
      centres_values_7_exists_q <= 1'b0;
      centres_values_7_marks_first_q <= 1'b0;
      centres_values_7_marks_last_q <= 1'b0;
      centres_values_8_grey_q <= 6'h0;
      centres_values_8_exists_q <= 1'b0;
      centres_values_8_marks_first_q <= 1'b0;
      centres_values_8_marks_last_q <= 1'b0;
      centres_values_9_grey_q <= 6'h0;
      centres_values_9_exists_q <= 1'b0;
      centres_values_9_marks_first_q <= 1'b0;
      centres_values_9_marks_last_q <= 1'b0;
      centres_values_10_grey_q <= 6'h0;
      centres_values_10_exists_q <= 1'b0;
      centres_values_10_marks_first_q <= 1'b0;
      centres_values_10_marks_last_q <= 1'b0;
      centres_values_11_grey_q <= 6'h0;
      centres_values_11_exists_q <= 1'b0;
      centres_values_11_marks_first_q <= 1'b0;
      centres_values_11_marks_last_q <= 1'b0;
      centres_values_12_grey_q <= 6'h0;
      centres_values_12_exists_q <= 1'b0;
      centres_values_12_marks_first_q <= 1'b0;
      centres_values_12_marks_last_q <= 1'b0;
      centres_values_13_grey_q <= 6'h0;
      centres_values_13_exists_q <= 1'b0;
      centres_values_13_marks_first_q <= 1'b0;
      centres_values_13_marks_last_q <= 1'b0;
      centres_values_14_grey_q <= 6'h0;
      centres_values_14_exists_q <= 1'b0;
      centres_values_14_marks_first_q <= 1'b0;
      centres_values_14_marks_last_q <= 1'b0;
      centres_values_15_grey_q <= 6'h0;
      centres_values_15_exists_q <= 1'b0;
      centres_values_15_marks_first_q <= 1'b0;
      centres_values_15_marks_last_q <= 1'b0;
      centres_values_16_grey_q <= 6'h0;
      centres_values_16_exists_q <= 1'b0;
      centres_values_16_marks_first_q <= 1'b0;
      centres_values_16_marks_last_q <= 1'b0;
      centres_values_17_grey_q <= 6'h0;
      centres_values_17_exists_q <= 1'b0;
      centres_values_17_marks_first_q <= 1'b0;
      centres_values_17_marks_last_q <= 1'b0;
    end else if (s0_en) begin
      row_ended_q <= marks_last_i;
      columns_q <= select_207 + {4'h0, not_209};
      outside_values_0_q <= known_i ? cost_0_i : 12'hfff;
      outside_values_1_q <= or_206 ? 12'hfff : outside_values_0_q;
      outside_values_2_q <= or_206 ? 12'hfff : outside_values_1_q;
      outside_values_3_q <= or_206 ? 12'hfff : outside_values_2_q;
      outside_values_4_q <= or_206 ? 12'hfff : outside_values_3_q;
      outside_values_5_q <= or_206 ? 12'hfff : outside_values_4_q;
      outside_values_6_q <= or_206 ? 12'hfff : outside_values_5_q;
      outside_values_7_q <= or_206 ? 12'hfff : outside_values_6_q;
      outside_values_8_q <= (select_219 < select_220) ? select_219 : select_220;
      outside_values_9_q <= or_206 ? 12'hfff : outside_values_8_q;
      outside_values_10_q <= or_206 ? 12'hfff : outside_values_9_q;
      outside_values_11_q <= or_206 ? 12'hfff : outside_values_10_q;
      outside_values_12_q <= (select_226 < select_227) ? select_226 : select_227;
      outside_values_13_q <= or_206 ? 12'hfff : outside_values_12_q;
      outside_values_14_q <= or_206 ? 12'hfff : outside_values_13_q;
      outside_values_15_q <= (select_232 < select_233) ? select_232 : select_233;
      outside_values_16_q <= (select_236 < select_237) ? select_236 : select_237;
      outside_values_17_q <= or_206 ? 12'hfff : outside_values_16_q;
      outside_values_18_q <= or_206 ? 12'hfff : outside_values_17_q;
      centres_values_0_grey_q <= grey_i;
      centres_values_0_exists_q <= exists_i;
      centres_values_0_marks_first_q <= marks_first_i;
      centres_values_0_marks_last_q <= marks_last_i;
      centres_values_1_grey_q <= centres_values_0_grey_q;
      centres_values_1_exists_q <= centres_values_0_exists_q;
      centres_values_1_marks_first_q <= centres_values_0_marks_first_q;
      centres_values_1_marks_last_q <= centres_values_0_marks_last_q;
      centres_values_2_grey_q <= centres_values_1_grey_q;
      centres_values_2_exists_q <= centres_values_1_exists_q;
      centres_values_2_marks_first_q <= centres_values_1_marks_first_q;
      centres_values_2_marks_last_q <= centres_values_1_marks_last_q;
      centres_values_3_grey_q <= centres_values_2_grey_q;
      centres_values_3_exists_q <= centres_values_2_exists_q;
      centres_values_3_marks_first_q <= centres_values_2_marks_first_q;
      centres_values_3_marks_last_q <= centres_values_2_marks_last_q;
      centres_values_4_grey_q <= centres_values_3_grey_q;
      centres_values_4_exists_q <= centres_values_3_exists_q;
      centres_values_4_marks_first_q <= centres_values_3_marks_first_q;
      centres_values_4_marks_last_q <= centres_values_3_marks_last_q;
      centres_values_5_grey_q <= centres_values_4_grey_q;
      centres_values_5_exists_q <= centres_values_4_exists_q;
      centres_values_5_marks_first_q <= centres_values_4_marks_first_q;
      centres_values_5_marks_last_q <= centres_values_4_marks_last_q;
      centres_values_6_grey_q <= centres_values_5_grey_q;
      centres_values_6_exists_q <= centres_values_5_exists_q;
      centres_values_6_marks_first_q <= centres_values_5_marks_first_q;
      centres_values_6_marks_last_q <= centres_values_5_marks_last_q;
      centres_values_7_grey_q <= centres_values_6_grey_q;
      centres_values_7_exists_q <= centres_values_6_exists_q;
      centres_values_7_marks_first_q <= centres_values_6_marks_first_q;
      centres_values_7_marks_last_q <= centres_values_6_marks_last_q;
      centres_values_8_grey_q <= centres_values_7_grey_q;
      centres_values_8_exists_q <= centres_values_7_exists_q;
      centres_values_8_marks_first_q <= centres_values_7_marks_first_q;
      centres_values_8_marks_last_q <= centres_values_7_marks_last_q;
      centres_values_9_grey_q <= centres_values_8_grey_q;
      centres_values_9_exists_q <= centres_values_8_exists_q;
      centres_values_9_marks_first_q <= centres_values_8_marks_first_q;
      centres_values_9_marks_last_q <= centres_values_8_marks_last_q;
      centres_values_10_grey_q <= centres_values_9_grey_q;
      centres_values_10_exists_q <= centres_values_9_exists_q;
      centres_values_10_marks_first_q <= centres_values_9_marks_first_q;
      centres_values_10_marks_last_q <= centres_values_9_marks_last_q;
      centres_values_11_grey_q <= centres_values_10_grey_q;
      centres_values_11_exists_q <= centres_values_10_exists_q;
      centres_values_11_marks_first_q <= centres_values_10_marks_first_q;
      centres_values_11_marks_last_q <= centres_values_10_marks_last_q;
      centres_values_12_grey_q <= centres_values_11_grey_q;
      centres_values_12_exists_q <= centres_values_11_exists_q;
      centres_values_12_marks_first_q <= centres_values_11_marks_first_q;
      centres_values_12_marks_last_q <= centres_values_11_marks_last_q;
      centres_values_13_grey_q <= centres_values_12_grey_q;
      centres_values_13_exists_q <= centres_values_12_exists_q;
      centres_values_13_marks_first_q <= centres_values_12_marks_first_q;
      centres_values_13_marks_last_q <= centres_values_12_marks_last_q;
      centres_values_14_grey_q <= centres_values_13_grey_q;
      centres_values_14_exists_q <= centres_values_13_exists_q;
      centres_values_14_marks_first_q <= centres_values_13_marks_first_q;
      centres_values_14_marks_last_q <= centres_values_13_marks_last_q;
      centres_values_15_grey_q <= centres_values_14_grey_q;
      centres_values_15_exists_q <= centres_values_14_exists_q;
      centres_values_15_marks_first_q <= centres_values_14_marks_first_q;
      centres_values_15_marks_last_q <= centres_values_14_marks_last_q;
      centres_values_16_grey_q <= centres_values_15_grey_q;
      centres_values_16_exists_q <= centres_values_15_exists_q;
      centres_values_16_marks_first_q <= centres_values_15_marks_first_q;
      centres_values_16_marks_last_q <= centres_values_15_marks_last_q;
      centres_values_17_grey_q <= centres_values_16_grey_q;
      centres_values_17_exists_q <= centres_values_16_exists_q;
      centres_values_17_marks_first_q <= centres_values_16_marks_first_q;
      centres_values_17_marks_last_q <= centres_values_16_marks_last_q;
    end
  end

  logic [11:0] cost_4_s1_q;
  logic [11:0] cost_5_s1_q;
  logic [11:0] cost_6_s1_q;
  logic [11:0] cost_7_s1_q;
  logic [11:0] cost_8_s1_q;
  logic [11:0] cost_9_s1_q;
  logic [11:0] cost_10_s1_q;
  logic [11:0] cost_11_s1_q;
  logic [11:0] cost_12_s1_q;
  logic known_s1_q;
  logic evident_s1_q;
  logic strong_v_s1_q;
  logic [11:0] outside_values_18_s1_q;
  logic [5:0] centres_values_17_grey_s1_q;
  logic centres_values_17_exists_s1_q;
  logic centres_values_17_marks_first_s1_q;
  logic centres_values_17_marks_last_s1_q;
  logic or_206_s1_q;
  logic and_249_s1_q;
  logic equal_254_s1_q;
  logic less_259_s1_q;
  logic less_264_s1_q;
  logic less_269_s1_q;
  logic less_274_s1_q;
  logic less_300_s1_q;
  logic less_302_s1_q;
  logic [11:0] select_307_s1_q;
  logic [11:0] select_309_s1_q;
  logic less_333_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      cost_4_s1_q <= cost_4_i;
      cost_5_s1_q <= cost_5_i;
      cost_6_s1_q <= cost_6_i;
      cost_7_s1_q <= cost_7_i;
      cost_8_s1_q <= cost_8_i;
      cost_9_s1_q <= cost_9_i;
      cost_10_s1_q <= cost_10_i;
      cost_11_s1_q <= cost_11_i;
      cost_12_s1_q <= cost_12_i;
      known_s1_q <= known_i;
      evident_s1_q <= evident_i;
      strong_v_s1_q <= strong_v_i;
      outside_values_18_s1_q <= outside_values_18_q;
      centres_values_17_grey_s1_q <= centres_values_17_grey_q;
      centres_values_17_exists_s1_q <= centres_values_17_exists_q;
      centres_values_17_marks_first_s1_q <= centres_values_17_marks_first_q;
      centres_values_17_marks_last_s1_q <= centres_values_17_marks_last_q;
      or_206_s1_q <= or_206;
      and_249_s1_q <= known_i & (~(select_207 == 5'h0));
      equal_254_s1_q <= select_207[4:1] == 4'h0;
      less_259_s1_q <= select_207 < 5'h3;
      less_264_s1_q <= select_207[4:1] < 4'h3;
      less_269_s1_q <= select_207[4:1] < 4'h5;
      less_274_s1_q <= cost_7_i < cost_5_i;
      less_300_s1_q <= cost_12_i < cost_11_i;
      less_302_s1_q <= cost_10_i < cost_9_i;
      select_307_s1_q <= (cost_3_i < cost_2_i) ? cost_3_i : cost_2_i;
      select_309_s1_q <= (cost_1_i < cost_0_i) ? cost_1_i : cost_0_i;
      less_333_s1_q <= select_207[4:1] < 4'h9;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [11:0] inside_next_q;
  logic [11:0] inside_here_q;
  logic [11:0] seen_values_0_inside_q;
  logic [11:0] seen_values_1_inside_q;
  logic [11:0] seen_values_2_inside_q;
  logic [11:0] seen_values_3_inside_q;
  logic [11:0] seen_values_4_inside_q;
  logic [11:0] seen_values_5_inside_q;
  logic [11:0] seen_values_6_inside_q;
  logic [11:0] seen_values_7_inside_q;
  logic [11:0] seen_values_8_inside_q;
  logic [11:0] seen_values_9_inside_q;
  logic [11:0] seen_values_10_inside_q;
  logic [11:0] seen_values_11_inside_q;
  logic [11:0] seen_values_12_inside_q;
  logic [11:0] seen_values_13_inside_q;
  logic [11:0] seen_values_14_inside_q;
  logic [11:0] seen_values_15_inside_q;
  logic [11:0] seen_values_16_inside_q;
  // hls/stages/contest.hpp:133
  logic [11:0] select_243;
  assign select_243 = known_s1_q ? cost_6_s1_q : 12'hfff;
  logic [11:0] select_244;
  assign select_244 = or_206_s1_q ? 12'hfff : inside_next_q;
  logic [11:0] select_250;
  assign select_250 = and_249_s1_q ? cost_7_s1_q : 12'hfff;
  // hls/stages/contest.hpp:146
  logic less_257;
  assign less_257 = (known_s1_q ? (equal_254_s1_q ? 12'hfff : cost_8_s1_q) : 12'hfff) < seen_values_0_inside_q;
  logic less_262;
  assign less_262 = (known_s1_q ? (less_259_s1_q ? 12'hfff : cost_9_s1_q) : 12'hfff) < seen_values_1_inside_q;
  logic less_267;
  assign less_267 = (known_s1_q ? (less_264_s1_q ? 12'hfff : cost_10_s1_q) : 12'hfff) < seen_values_4_inside_q;
  logic less_272;
  assign less_272 = (known_s1_q ? (less_269_s1_q ? 12'hfff : cost_11_s1_q) : 12'hfff) < seen_values_8_inside_q;
  // hls/stages/contest.hpp:100
  logic [11:0] beside;
  assign beside = less_274_s1_q ? cost_7_s1_q : cost_5_s1_q;
  // hls/stages/contest.hpp:101
  logic less_276;
  assign less_276 = beside < cost_6_s1_q;
  // hls/stages/contest.hpp:102
  logic [11:0] outer;
  assign outer = less_274_s1_q ? cost_8_s1_q : cost_4_s1_q;
  // hls/stages/contest.hpp:160
  logic [12:0] value;
  assign value = {1'b0, outer} - {1'b0, beside};
  logic [12:0] value_2;
  assign value_2 = {1'b0, beside} - {1'b0, cost_6_s1_q};
  // hls/stages/contest.hpp:176
  logic [11:0] select_301;
  assign select_301 = less_300_s1_q ? cost_12_s1_q : cost_11_s1_q;
  logic [11:0] select_303;
  assign select_303 = less_302_s1_q ? cost_10_s1_q : cost_9_s1_q;
  logic [11:0] select_311;
  assign select_311 = (select_307_s1_q < select_309_s1_q) ? select_307_s1_q : select_309_s1_q;
  // hls/stages/contest.hpp:101
  logic [11:0] inside_v;
  assign inside_v = less_276 ? beside : cost_6_s1_q;
  // hls/stages/contest.hpp:146
  logic less_336;
  assign less_336 = (known_s1_q ? (less_333_s1_q ? 12'hfff : cost_12_s1_q) : 12'hfff) < seen_values_16_inside_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      inside_next_q <= 12'h0;
      inside_here_q <= 12'h0;
      seen_values_0_inside_q <= 12'h0;
      seen_values_1_inside_q <= 12'h0;
      seen_values_2_inside_q <= 12'h0;
      seen_values_3_inside_q <= 12'h0;
      seen_values_4_inside_q <= 12'h0;
      seen_values_5_inside_q <= 12'h0;
      seen_values_6_inside_q <= 12'h0;
      seen_values_7_inside_q <= 12'h0;
      seen_values_8_inside_q <= 12'h0;
      seen_values_9_inside_q <= 12'h0;
      seen_values_10_inside_q <= 12'h0;
      seen_values_11_inside_q <= 12'h0;
      seen_values_12_inside_q <= 12'h0;
      seen_values_13_inside_q <= 12'h0;
      seen_values_14_inside_q <= 12'h0;
      seen_values_15_inside_q <= 12'h0;
      seen_values_16_inside_q <= 12'h0;
    end else if (s1_en) begin
      inside_next_q <= known_s1_q ? cost_5_s1_q : 12'hfff;
      inside_here_q <= (select_243 < select_244) ? select_243 : select_244;
      seen_values_0_inside_q <= (select_250 < inside_here_q) ? select_250 : inside_here_q;
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
    end
  end

  logic evident_s2_q;
  logic strong_v_s2_q;
  logic [11:0] outside_values_18_s2_q;
  logic [5:0] centres_values_17_grey_s2_q;
  logic centres_values_17_exists_s2_q;
  logic centres_values_17_marks_first_s2_q;
  logic centres_values_17_marks_last_s2_q;
  logic less_257_s2_q;
  logic less_262_s2_q;
  logic less_267_s2_q;
  logic less_272_s2_q;
  logic less_276_s2_q;
  logic [12:0] value_s2_q;
  logic [12:0] value_2_s2_q;
  logic [11:0] select_299_s2_q;
  logic [11:0] select_305_s2_q;
  logic [11:0] select_311_s2_q;
  logic [11:0] inside_v_s2_q;
  logic less_336_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      evident_s2_q <= evident_s1_q;
      strong_v_s2_q <= strong_v_s1_q;
      outside_values_18_s2_q <= outside_values_18_s1_q;
      centres_values_17_grey_s2_q <= centres_values_17_grey_s1_q;
      centres_values_17_exists_s2_q <= centres_values_17_exists_s1_q;
      centres_values_17_marks_first_s2_q <= centres_values_17_marks_first_s1_q;
      centres_values_17_marks_last_s2_q <= centres_values_17_marks_last_s1_q;
      less_257_s2_q <= less_257;
      less_262_s2_q <= less_262;
      less_267_s2_q <= less_267;
      less_272_s2_q <= less_272;
      less_276_s2_q <= less_276;
      value_s2_q <= value;
      value_2_s2_q <= value_2;
      select_299_s2_q <= (cost_8_s1_q < cost_4_s1_q) ? cost_8_s1_q : cost_4_s1_q;
      select_305_s2_q <= (select_301 < select_303) ? select_301 : select_303;
      select_311_s2_q <= select_311;
      inside_v_s2_q <= inside_v;
      less_336_s2_q <= less_336;
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
  // hls/stages/contest.hpp:166
  logic [11:0] select_279;
  assign select_279 = cfg_boundary_i[0] ? value_s2_q[12:1] : 12'h0;
  logic [12:0] select_280;
  assign select_280 = cfg_boundary_i[1] ? value_s2_q : 13'h0;
  logic [13:0] sum_281;
  assign sum_281 = {{2{select_279[11]}}, select_279} + {select_280[12], select_280};
  // hls/stages/contest.hpp:167
  logic [12:0] select_282;
  assign select_282 = cfg_boundary_i[2] ? value_s2_q : 13'h0;
  logic [12:0] select_283;
  assign select_283 = cfg_boundary_i[3] ? value_s2_q : 13'h0;
  logic [13:0] sum_284;
  assign sum_284 = {{2{select_282[12]}}, select_282[12:1]} + {select_283[12], select_283};
  // hls/stages/contest.hpp:166
  logic [11:0] select_290;
  assign select_290 = rest[0] ? value_2_s2_q[12:1] : 12'h0;
  logic [12:0] select_291;
  assign select_291 = rest[1] ? value_2_s2_q : 13'h0;
  logic [13:0] sum_292;
  assign sum_292 = {{2{select_290[11]}}, select_290} + {select_291[12], select_291};
  // hls/stages/contest.hpp:167
  logic [12:0] select_293;
  assign select_293 = rest[2] ? value_2_s2_q : 13'h0;
  logic [12:0] select_294;
  assign select_294 = rest[3] ? value_2_s2_q : 13'h0;
  logic [13:0] sum_295;
  assign sum_295 = {{2{select_293[12]}}, select_293[12:1]} + {select_294[12], select_294};
  // hls/stages/contest.hpp:98
  logic [11:0] far;
  assign far = (select_305_s2_q < select_311_s2_q) ? select_305_s2_q : select_311_s2_q;

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
    end else if (s2_en) begin
      seen_values_0_hidden_q <= outside_values_18_s2_q < seen_values_0_inside_q;
      seen_values_1_hidden_q <= seen_values_0_hidden_q | less_257_s2_q;
      seen_values_2_hidden_q <= seen_values_1_hidden_q | less_262_s2_q;
      seen_values_3_hidden_q <= seen_values_2_hidden_q;
      seen_values_4_hidden_q <= seen_values_3_hidden_q;
      seen_values_5_hidden_q <= seen_values_4_hidden_q | less_267_s2_q;
      seen_values_6_hidden_q <= seen_values_5_hidden_q;
      seen_values_7_hidden_q <= seen_values_6_hidden_q;
      seen_values_8_hidden_q <= seen_values_7_hidden_q;
      seen_values_9_hidden_q <= seen_values_8_hidden_q | less_272_s2_q;
      seen_values_10_hidden_q <= seen_values_9_hidden_q;
      seen_values_11_hidden_q <= seen_values_10_hidden_q;
      seen_values_12_hidden_q <= seen_values_11_hidden_q;
      seen_values_13_hidden_q <= seen_values_12_hidden_q;
      seen_values_14_hidden_q <= seen_values_13_hidden_q;
      seen_values_15_hidden_q <= seen_values_14_hidden_q;
      seen_values_16_hidden_q <= seen_values_15_hidden_q;
    end
  end

  logic evident_s3_q;
  logic strong_v_s3_q;
  logic [5:0] centres_values_17_grey_s3_q;
  logic centres_values_17_exists_s3_q;
  logic centres_values_17_marks_first_s3_q;
  logic centres_values_17_marks_last_s3_q;
  logic less_276_s3_q;
  logic [12:0] sum_281_s3_q;
  logic select_282_s3_q;
  logic [13:0] sum_284_s3_q;
  logic [12:0] sum_292_s3_q;
  logic select_293_s3_q;
  logic [13:0] sum_295_s3_q;
  logic [11:0] select_299_s3_q;
  logic [11:0] far_s3_q;
  logic [11:0] inside_v_s3_q;
  logic or_337_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      evident_s3_q <= evident_s2_q;
      strong_v_s3_q <= strong_v_s2_q;
      centres_values_17_grey_s3_q <= centres_values_17_grey_s2_q;
      centres_values_17_exists_s3_q <= centres_values_17_exists_s2_q;
      centres_values_17_marks_first_s3_q <= centres_values_17_marks_first_s2_q;
      centres_values_17_marks_last_s3_q <= centres_values_17_marks_last_s2_q;
      less_276_s3_q <= less_276_s2_q;
      sum_281_s3_q <= sum_281[13:1];
      select_282_s3_q <= select_282[0];
      sum_284_s3_q <= sum_284;
      sum_292_s3_q <= sum_292[13:1];
      select_293_s3_q <= select_293[0];
      sum_295_s3_q <= sum_295;
      select_299_s3_q <= select_299_s2_q;
      far_s3_q <= far;
      inside_v_s3_q <= inside_v_s2_q;
      or_337_s3_q <= seen_values_16_hidden_q | less_336_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:168
  logic [15:0] sum_285;
  assign sum_285 = {{3{sum_281_s3_q[12]}}, sum_281_s3_q} + {sum_284_s3_q[13], sum_284_s3_q, select_282_s3_q};
  logic [15:0] sum_296;
  assign sum_296 = {{3{sum_292_s3_q[12]}}, sum_292_s3_q} + {sum_295_s3_q[13], sum_295_s3_q, select_293_s3_q};
  // hls/stages/contest.hpp:160
  logic [15:0] b;
  assign b = {sum_285[15], sum_285[15:1]} + {sum_296[15], sum_296[15:1]};
  // hls/stages/contest.hpp:99
  logic [11:0] outside;
  assign outside = (select_299_s3_q < far_s3_q) ? select_299_s3_q : far_s3_q;
  // hls/stages/contest.hpp:106
  logic less_327;
  assign less_327 = {1'b0, far_s3_q} < ({1'b0, inside_v_s3_q} + {5'h0, inside_v_s3_q[11:4]});

  logic evident_s4_q;
  logic strong_v_s4_q;
  logic [5:0] centres_values_17_grey_s4_q;
  logic centres_values_17_exists_s4_q;
  logic centres_values_17_marks_first_s4_q;
  logic centres_values_17_marks_last_s4_q;
  logic less_276_s4_q;
  logic [15:0] b_s4_q;
  logic [11:0] outside_s4_q;
  logic [11:0] inside_v_s4_q;
  logic not_328_s4_q;
  logic or_337_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      evident_s4_q <= evident_s3_q;
      strong_v_s4_q <= strong_v_s3_q;
      centres_values_17_grey_s4_q <= centres_values_17_grey_s3_q;
      centres_values_17_exists_s4_q <= centres_values_17_exists_s3_q;
      centres_values_17_marks_first_s4_q <= centres_values_17_marks_first_s3_q;
      centres_values_17_marks_last_s4_q <= centres_values_17_marks_last_s3_q;
      less_276_s4_q <= less_276_s3_q;
      b_s4_q <= b;
      outside_s4_q <= outside;
      inside_v_s4_q <= inside_v_s3_q;
      not_328_s4_q <= ~less_327;
      or_337_s4_q <= or_337_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/contest.hpp:104
  logic [12:0] z;
  assign z = {1'b0, outside_s4_q} - {1'b0, inside_v_s4_q};

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
    end else if (s4_en) begin
      centres_values_0_votes_q <= evident_s4_q & ((outside_s4_q < inside_v_s4_q) | not_328_s4_q);
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
    end
  end

  logic strong_v_s5_q;
  logic centres_values_17_votes_s5_q;
  logic [5:0] centres_values_17_grey_s5_q;
  logic centres_values_17_exists_s5_q;
  logic centres_values_17_marks_first_s5_q;
  logic centres_values_17_marks_last_s5_q;
  logic less_276_s5_q;
  logic [15:0] b_s5_q;
  logic [12:0] z_s5_q;
  logic less_318_s5_q;
  logic or_337_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      strong_v_s5_q <= strong_v_s4_q;
      centres_values_17_votes_s5_q <= centres_values_17_votes_q;
      centres_values_17_grey_s5_q <= centres_values_17_grey_s4_q;
      centres_values_17_exists_s5_q <= centres_values_17_exists_s4_q;
      centres_values_17_marks_first_s5_q <= centres_values_17_marks_first_s4_q;
      centres_values_17_marks_last_s5_q <= centres_values_17_marks_last_s4_q;
      less_276_s5_q <= less_276_s4_q;
      b_s5_q <= b_s4_q;
      z_s5_q <= z;
      less_318_s5_q <= $signed(b_s4_q) < $signed({{3{z[12]}}, z});
      or_337_s5_q <= or_337_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:105
  logic [15:0] z_2;
  assign z_2 = less_276_s5_q ? (less_318_s5_q ? b_s5_q : {{3{z_s5_q[12]}}, z_s5_q}) : {{3{z_s5_q[12]}}, z_s5_q};

  logic strong_v_s6_q;
  logic centres_values_17_votes_s6_q;
  logic [5:0] centres_values_17_grey_s6_q;
  logic centres_values_17_exists_s6_q;
  logic centres_values_17_marks_first_s6_q;
  logic centres_values_17_marks_last_s6_q;
  logic less_321_s6_q;
  logic [5:0] select_323_s6_q;
  logic less_331_s6_q;
  logic or_337_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      strong_v_s6_q <= strong_v_s5_q;
      centres_values_17_votes_s6_q <= centres_values_17_votes_s5_q;
      centres_values_17_grey_s6_q <= centres_values_17_grey_s5_q;
      centres_values_17_exists_s6_q <= centres_values_17_exists_s5_q;
      centres_values_17_marks_first_s6_q <= centres_values_17_marks_first_s5_q;
      centres_values_17_marks_last_s6_q <= centres_values_17_marks_last_s5_q;
      less_321_s6_q <= $signed(z_2[15:3]) < $signed(13'h1fe1);
      select_323_s6_q <= ($signed(8'h0) < $signed(z_2[15:8])) ? 6'h1f : z_2[8:3];
      less_331_s6_q <= $signed(z_2) < $signed(16'hfe01);
      or_337_s6_q <= or_337_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/contest.hpp:61
  logic [5:0] select_339;
  assign select_339 = ($signed(6'h38) < $signed(centres_values_17_clipped_q)) ? 6'h38 : centres_values_17_clipped_q;
  logic [5:0] clipped;
  assign clipped = or_337_s6_q ? select_339 : centres_values_17_clipped_q;

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
    end else if (s6_en) begin
      centres_values_0_clipped_q <= less_321_s6_q ? 6'h21 : select_323_s6_q;
      centres_values_0_firm_q <= strong_v_s6_q & less_331_s6_q;
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
    end
  end

  logic centres_values_17_votes_s7_q;
  logic centres_values_17_firm_s7_q;
  logic [5:0] centres_values_17_grey_s7_q;
  logic centres_values_17_exists_s7_q;
  logic centres_values_17_marks_first_s7_q;
  logic centres_values_17_marks_last_s7_q;
  logic [5:0] clipped_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      centres_values_17_votes_s7_q <= centres_values_17_votes_s6_q;
      centres_values_17_firm_s7_q <= centres_values_17_firm_q;
      centres_values_17_grey_s7_q <= centres_values_17_grey_s6_q;
      centres_values_17_exists_s7_q <= centres_values_17_exists_s6_q;
      centres_values_17_marks_first_s7_q <= centres_values_17_marks_first_s6_q;
      centres_values_17_marks_last_s7_q <= centres_values_17_marks_last_s6_q;
      clipped_s7_q <= clipped;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:63
  logic and_343;
  assign and_343 = centres_values_17_votes_s7_q & (~(clipped_s7_q == 6'h0));
  // hls/stages/contest.hpp:67
  logic [6:0] select_345;
  assign select_345 = and_343 ? ({3'h0, cfg_bias_i} + {clipped_s7_q[5], clipped_s7_q}) : 7'h0;

  logic [5:0] centres_values_17_grey_s8_q;
  logic centres_values_17_exists_s8_q;
  logic centres_values_17_marks_first_s8_q;
  logic centres_values_17_marks_last_s8_q;
  logic [6:0] select_345_s8_q;
  logic and_346_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      centres_values_17_grey_s8_q <= centres_values_17_grey_s7_q;
      centres_values_17_exists_s8_q <= centres_values_17_exists_s7_q;
      centres_values_17_marks_first_s8_q <= centres_values_17_marks_first_s7_q;
      centres_values_17_marks_last_s8_q <= centres_values_17_marks_last_s7_q;
      select_345_s8_q <= select_345;
      and_346_s8_q <= centres_values_17_firm_s7_q & and_343;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign vote_o = select_345_s8_q;
  assign firm_o = and_346_s8_q;
  assign grey_o = centres_values_17_grey_s8_q;
  assign exists_o = centres_values_17_exists_s8_q;
  assign marks_first_o = centres_values_17_marks_first_s8_q;
  assign marks_last_o = centres_values_17_marks_last_s8_q;
  assign valid_o = valid_s8_q;

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
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
      valid_s8_q <= valid_s7_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_296[0], sum_292[0], sum_285[0], sum_281[0]};

endmodule
