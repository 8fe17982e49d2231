// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contest<horopter::hls::profiles::hd>, hls/stages/contest.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 785 bits, pipeline 610 bits, memories 0 bits.
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
  output logic valid_o,
  output logic signed [6:0] vote_o,
  output logic firm_o,
  output logic [5:0] grey_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;

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
  // hls/stages/contest.hpp:54
  logic or_205;
  assign or_205 = marks_first_i | row_ended_q;
  // hls/stages/contest.hpp:132
  logic [4:0] select_206;
  assign select_206 = or_205 ? 5'h0 : columns_q;
  // hls/stages/contest.hpp:147
  logic not_208;
  assign not_208 = ~(select_206 == 5'h12);
  // hls/stages/contest.hpp:132
  logic [11:0] select_218;
  assign select_218 = known_i ? cost_1_i : 12'hfff;
  logic [11:0] select_219;
  assign select_219 = or_205 ? 12'hfff : outside_values_7_q;
  logic [11:0] select_225;
  assign select_225 = known_i ? cost_2_i : 12'hfff;
  logic [11:0] select_226;
  assign select_226 = or_205 ? 12'hfff : outside_values_11_q;
  logic [11:0] select_231;
  assign select_231 = known_i ? cost_3_i : 12'hfff;
  logic [11:0] select_232;
  assign select_232 = or_205 ? 12'hfff : outside_values_14_q;
  logic [11:0] select_235;
  assign select_235 = known_i ? cost_4_i : 12'hfff;
  logic [11:0] select_236;
  assign select_236 = or_205 ? 12'hfff : outside_values_15_q;

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
      columns_q <= select_206 + {4'h0, not_208};
      outside_values_0_q <= known_i ? cost_0_i : 12'hfff;
      outside_values_1_q <= or_205 ? 12'hfff : outside_values_0_q;
      outside_values_2_q <= or_205 ? 12'hfff : outside_values_1_q;
      outside_values_3_q <= or_205 ? 12'hfff : outside_values_2_q;
      outside_values_4_q <= or_205 ? 12'hfff : outside_values_3_q;
      outside_values_5_q <= or_205 ? 12'hfff : outside_values_4_q;
      outside_values_6_q <= or_205 ? 12'hfff : outside_values_5_q;
      outside_values_7_q <= or_205 ? 12'hfff : outside_values_6_q;
      outside_values_8_q <= (select_218 < select_219) ? select_218 : select_219;
      outside_values_9_q <= or_205 ? 12'hfff : outside_values_8_q;
      outside_values_10_q <= or_205 ? 12'hfff : outside_values_9_q;
      outside_values_11_q <= or_205 ? 12'hfff : outside_values_10_q;
      outside_values_12_q <= (select_225 < select_226) ? select_225 : select_226;
      outside_values_13_q <= or_205 ? 12'hfff : outside_values_12_q;
      outside_values_14_q <= or_205 ? 12'hfff : outside_values_13_q;
      outside_values_15_q <= (select_231 < select_232) ? select_231 : select_232;
      outside_values_16_q <= (select_235 < select_236) ? select_235 : select_236;
      outside_values_17_q <= or_205 ? 12'hfff : outside_values_16_q;
      outside_values_18_q <= or_205 ? 12'hfff : outside_values_17_q;
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
  logic or_205_s1_q;
  logic and_248_s1_q;
  logic equal_253_s1_q;
  logic less_258_s1_q;
  logic less_263_s1_q;
  logic less_268_s1_q;
  logic less_274_s1_q;
  logic less_289_s1_q;
  logic less_291_s1_q;
  logic [11:0] select_296_s1_q;
  logic [11:0] select_298_s1_q;
  logic less_327_s1_q;
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
      or_205_s1_q <= or_205;
      and_248_s1_q <= known_i & (~(select_206 == 5'h0));
      equal_253_s1_q <= select_206[4:1] == 4'h0;
      less_258_s1_q <= select_206 < 5'h3;
      less_263_s1_q <= select_206[4:1] < 4'h3;
      less_268_s1_q <= select_206[4:1] < 4'h5;
      less_274_s1_q <= cost_7_i < cost_5_i;
      less_289_s1_q <= cost_12_i < cost_11_i;
      less_291_s1_q <= cost_10_i < cost_9_i;
      select_296_s1_q <= (cost_3_i < cost_2_i) ? cost_3_i : cost_2_i;
      select_298_s1_q <= (cost_1_i < cost_0_i) ? cost_1_i : cost_0_i;
      less_327_s1_q <= select_206[4:1] < 4'h9;
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
  // hls/stages/contest.hpp:132
  logic [11:0] select_242;
  assign select_242 = known_s1_q ? cost_6_s1_q : 12'hfff;
  logic [11:0] select_243;
  assign select_243 = or_205_s1_q ? 12'hfff : inside_next_q;
  logic [11:0] select_249;
  assign select_249 = and_248_s1_q ? cost_7_s1_q : 12'hfff;
  // hls/stages/contest.hpp:145
  logic less_256;
  assign less_256 = (known_s1_q ? (equal_253_s1_q ? 12'hfff : cost_8_s1_q) : 12'hfff) < seen_values_0_inside_q;
  logic less_261;
  assign less_261 = (known_s1_q ? (less_258_s1_q ? 12'hfff : cost_9_s1_q) : 12'hfff) < seen_values_1_inside_q;
  logic less_266;
  assign less_266 = (known_s1_q ? (less_263_s1_q ? 12'hfff : cost_10_s1_q) : 12'hfff) < seen_values_4_inside_q;
  logic less_271;
  assign less_271 = (known_s1_q ? (less_268_s1_q ? 12'hfff : cost_11_s1_q) : 12'hfff) < seen_values_8_inside_q;
  // hls/stages/contest.hpp:158
  logic [12:0] inner;
  assign inner = {1'b0, cost_6_s1_q} - {1'b0, cost_5_s1_q};
  logic [12:0] inner_2;
  assign inner_2 = {1'b0, cost_6_s1_q} - {1'b0, cost_7_s1_q};
  // hls/stages/contest.hpp:167
  logic [11:0] select_290;
  assign select_290 = less_289_s1_q ? cost_12_s1_q : cost_11_s1_q;
  logic [11:0] select_292;
  assign select_292 = less_291_s1_q ? cost_10_s1_q : cost_9_s1_q;
  logic [11:0] select_300;
  assign select_300 = (select_296_s1_q < select_298_s1_q) ? select_296_s1_q : select_298_s1_q;
  // hls/stages/contest.hpp:98
  logic [11:0] select_305;
  assign select_305 = less_274_s1_q ? cost_7_s1_q : cost_5_s1_q;
  logic [11:0] inside_v;
  assign inside_v = (select_305 < cost_6_s1_q) ? select_305 : cost_6_s1_q;
  // hls/stages/contest.hpp:145
  logic less_330;
  assign less_330 = (known_s1_q ? (less_327_s1_q ? 12'hfff : cost_12_s1_q) : 12'hfff) < seen_values_16_inside_q;

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
      inside_here_q <= (select_242 < select_243) ? select_242 : select_243;
      seen_values_0_inside_q <= (select_249 < inside_here_q) ? select_249 : inside_here_q;
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
  logic less_256_s2_q;
  logic less_261_s2_q;
  logic less_266_s2_q;
  logic less_271_s2_q;
  logic and_276_s2_q;
  logic [12:0] inner_s2_q;
  logic [12:0] difference_279_s2_q;
  logic and_282_s2_q;
  logic [12:0] inner_2_s2_q;
  logic [12:0] difference_285_s2_q;
  logic [11:0] select_288_s2_q;
  logic [11:0] select_294_s2_q;
  logic [11:0] select_300_s2_q;
  logic [11:0] inside_v_s2_q;
  logic less_330_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      evident_s2_q <= evident_s1_q;
      strong_v_s2_q <= strong_v_s1_q;
      outside_values_18_s2_q <= outside_values_18_s1_q;
      centres_values_17_grey_s2_q <= centres_values_17_grey_s1_q;
      centres_values_17_exists_s2_q <= centres_values_17_exists_s1_q;
      centres_values_17_marks_first_s2_q <= centres_values_17_marks_first_s1_q;
      centres_values_17_marks_last_s2_q <= centres_values_17_marks_last_s1_q;
      less_256_s2_q <= less_256;
      less_261_s2_q <= less_261;
      less_266_s2_q <= less_266;
      less_271_s2_q <= less_271;
      and_276_s2_q <= (cost_5_s1_q < cost_6_s1_q) & (~less_274_s1_q);
      inner_s2_q <= inner;
      difference_279_s2_q <= {1'b0, cost_4_s1_q} - {1'b0, cost_5_s1_q};
      and_282_s2_q <= less_274_s1_q & (cost_7_s1_q < cost_6_s1_q);
      inner_2_s2_q <= inner_2;
      difference_285_s2_q <= {1'b0, cost_8_s1_q} - {1'b0, cost_7_s1_q};
      select_288_s2_q <= (cost_8_s1_q < cost_4_s1_q) ? cost_8_s1_q : cost_4_s1_q;
      select_294_s2_q <= (select_290 < select_292) ? select_290 : select_292;
      select_300_s2_q <= select_300;
      inside_v_s2_q <= inside_v;
      less_330_s2_q <= less_330;
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
  // hls/stages/contest.hpp:159
  logic [13:0] difference_278;
  assign difference_278 = {{3{inner_s2_q[12]}}, inner_s2_q[12:2]} - {inner_s2_q[12], inner_s2_q};
  logic [14:0] b;
  assign b = {difference_278[13], difference_278} + {{2{difference_279_s2_q[12]}}, difference_279_s2_q};
  logic [13:0] difference_284;
  assign difference_284 = {{3{inner_2_s2_q[12]}}, inner_2_s2_q[12:2]} - {inner_2_s2_q[12], inner_2_s2_q};
  logic [14:0] b_2;
  assign b_2 = {difference_284[13], difference_284} + {{2{difference_285_s2_q[12]}}, difference_285_s2_q};
  // hls/stages/contest.hpp:96
  logic [11:0] far;
  assign far = (select_294_s2_q < select_300_s2_q) ? select_294_s2_q : select_300_s2_q;

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
      seen_values_1_hidden_q <= seen_values_0_hidden_q | less_256_s2_q;
      seen_values_2_hidden_q <= seen_values_1_hidden_q | less_261_s2_q;
      seen_values_3_hidden_q <= seen_values_2_hidden_q;
      seen_values_4_hidden_q <= seen_values_3_hidden_q;
      seen_values_5_hidden_q <= seen_values_4_hidden_q | less_266_s2_q;
      seen_values_6_hidden_q <= seen_values_5_hidden_q;
      seen_values_7_hidden_q <= seen_values_6_hidden_q;
      seen_values_8_hidden_q <= seen_values_7_hidden_q;
      seen_values_9_hidden_q <= seen_values_8_hidden_q | less_271_s2_q;
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
  logic and_276_s3_q;
  logic [14:0] b_s3_q;
  logic and_282_s3_q;
  logic [14:0] b_2_s3_q;
  logic [11:0] select_288_s3_q;
  logic [11:0] far_s3_q;
  logic [11:0] inside_v_s3_q;
  logic or_331_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      evident_s3_q <= evident_s2_q;
      strong_v_s3_q <= strong_v_s2_q;
      centres_values_17_grey_s3_q <= centres_values_17_grey_s2_q;
      centres_values_17_exists_s3_q <= centres_values_17_exists_s2_q;
      centres_values_17_marks_first_s3_q <= centres_values_17_marks_first_s2_q;
      centres_values_17_marks_last_s3_q <= centres_values_17_marks_last_s2_q;
      and_276_s3_q <= and_276_s2_q;
      b_s3_q <= b;
      and_282_s3_q <= and_282_s2_q;
      b_2_s3_q <= b_2;
      select_288_s3_q <= select_288_s2_q;
      far_s3_q <= far;
      inside_v_s3_q <= inside_v_s2_q;
      or_331_s3_q <= seen_values_16_hidden_q | less_330_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:97
  logic [11:0] outside;
  assign outside = (select_288_s3_q < far_s3_q) ? select_288_s3_q : far_s3_q;
  // hls/stages/contest.hpp:105
  logic less_321;
  assign less_321 = {1'b0, far_s3_q} < ({1'b0, inside_v_s3_q} + {5'h0, inside_v_s3_q[11:4]});

  logic evident_s4_q;
  logic strong_v_s4_q;
  logic [5:0] centres_values_17_grey_s4_q;
  logic centres_values_17_exists_s4_q;
  logic centres_values_17_marks_first_s4_q;
  logic centres_values_17_marks_last_s4_q;
  logic and_276_s4_q;
  logic [14:0] b_s4_q;
  logic and_282_s4_q;
  logic [14:0] b_2_s4_q;
  logic [11:0] outside_s4_q;
  logic [11:0] inside_v_s4_q;
  logic not_322_s4_q;
  logic or_331_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      evident_s4_q <= evident_s3_q;
      strong_v_s4_q <= strong_v_s3_q;
      centres_values_17_grey_s4_q <= centres_values_17_grey_s3_q;
      centres_values_17_exists_s4_q <= centres_values_17_exists_s3_q;
      centres_values_17_marks_first_s4_q <= centres_values_17_marks_first_s3_q;
      centres_values_17_marks_last_s4_q <= centres_values_17_marks_last_s3_q;
      and_276_s4_q <= and_276_s3_q;
      b_s4_q <= b_s3_q;
      and_282_s4_q <= and_282_s3_q;
      b_2_s4_q <= b_2_s3_q;
      outside_s4_q <= outside;
      inside_v_s4_q <= inside_v_s3_q;
      not_322_s4_q <= ~less_321;
      or_331_s4_q <= or_331_s3_q;
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
  // hls/stages/contest.hpp:100
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
      centres_values_0_votes_q <= evident_s4_q & ((outside_s4_q < inside_v_s4_q) | not_322_s4_q);
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
  logic and_276_s5_q;
  logic [14:0] b_s5_q;
  logic and_282_s5_q;
  logic [14:0] b_2_s5_q;
  logic [12:0] z_s5_q;
  logic less_309_s5_q;
  logic or_331_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      strong_v_s5_q <= strong_v_s4_q;
      centres_values_17_votes_s5_q <= centres_values_17_votes_q;
      centres_values_17_grey_s5_q <= centres_values_17_grey_s4_q;
      centres_values_17_exists_s5_q <= centres_values_17_exists_s4_q;
      centres_values_17_marks_first_s5_q <= centres_values_17_marks_first_s4_q;
      centres_values_17_marks_last_s5_q <= centres_values_17_marks_last_s4_q;
      and_276_s5_q <= and_276_s4_q;
      b_s5_q <= b_s4_q;
      and_282_s5_q <= and_282_s4_q;
      b_2_s5_q <= b_2_s4_q;
      z_s5_q <= z;
      less_309_s5_q <= $signed(b_2_s4_q) < $signed({{2{z[12]}}, z});
      or_331_s5_q <= or_331_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:101
  logic [14:0] z_2;
  assign z_2 = and_282_s5_q ? (less_309_s5_q ? b_2_s5_q : {{2{z_s5_q[12]}}, z_s5_q}) : {{2{z_s5_q[12]}}, z_s5_q};

  logic strong_v_s6_q;
  logic centres_values_17_votes_s6_q;
  logic [5:0] centres_values_17_grey_s6_q;
  logic centres_values_17_exists_s6_q;
  logic centres_values_17_marks_first_s6_q;
  logic centres_values_17_marks_last_s6_q;
  logic and_276_s6_q;
  logic [14:0] b_s6_q;
  logic [14:0] z_2_s6_q;
  logic less_312_s6_q;
  logic or_331_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      strong_v_s6_q <= strong_v_s5_q;
      centres_values_17_votes_s6_q <= centres_values_17_votes_s5_q;
      centres_values_17_grey_s6_q <= centres_values_17_grey_s5_q;
      centres_values_17_exists_s6_q <= centres_values_17_exists_s5_q;
      centres_values_17_marks_first_s6_q <= centres_values_17_marks_first_s5_q;
      centres_values_17_marks_last_s6_q <= centres_values_17_marks_last_s5_q;
      and_276_s6_q <= and_276_s5_q;
      b_s6_q <= b_s5_q;
      z_2_s6_q <= z_2;
      less_312_s6_q <= $signed(b_s5_q) < $signed(z_2);
      or_331_s6_q <= or_331_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:103
  logic [14:0] z_3;
  assign z_3 = and_276_s6_q ? (less_312_s6_q ? b_s6_q : z_2_s6_q) : z_2_s6_q;

  logic strong_v_s7_q;
  logic centres_values_17_votes_s7_q;
  logic [5:0] centres_values_17_grey_s7_q;
  logic centres_values_17_exists_s7_q;
  logic centres_values_17_marks_first_s7_q;
  logic centres_values_17_marks_last_s7_q;
  logic less_315_s7_q;
  logic [5:0] select_317_s7_q;
  logic less_325_s7_q;
  logic or_331_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      strong_v_s7_q <= strong_v_s6_q;
      centres_values_17_votes_s7_q <= centres_values_17_votes_s6_q;
      centres_values_17_grey_s7_q <= centres_values_17_grey_s6_q;
      centres_values_17_exists_s7_q <= centres_values_17_exists_s6_q;
      centres_values_17_marks_first_s7_q <= centres_values_17_marks_first_s6_q;
      centres_values_17_marks_last_s7_q <= centres_values_17_marks_last_s6_q;
      less_315_s7_q <= $signed(z_3[14:3]) < $signed(12'hfe1);
      select_317_s7_q <= ($signed(7'h0) < $signed(z_3[14:8])) ? 6'h1f : z_3[8:3];
      less_325_s7_q <= $signed(z_3) < $signed(15'h7e01);
      or_331_s7_q <= or_331_s6_q;
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
  // hls/stages/contest.hpp:59
  logic [5:0] select_333;
  assign select_333 = ($signed(6'h38) < $signed(centres_values_17_clipped_q)) ? 6'h38 : centres_values_17_clipped_q;
  logic [5:0] clipped;
  assign clipped = or_331_s7_q ? select_333 : centres_values_17_clipped_q;

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
    end else if (s7_en) begin
      centres_values_0_clipped_q <= less_315_s7_q ? 6'h21 : select_317_s7_q;
      centres_values_0_firm_q <= strong_v_s7_q & less_325_s7_q;
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

  logic centres_values_17_votes_s8_q;
  logic centres_values_17_firm_s8_q;
  logic [5:0] centres_values_17_grey_s8_q;
  logic centres_values_17_exists_s8_q;
  logic centres_values_17_marks_first_s8_q;
  logic centres_values_17_marks_last_s8_q;
  logic [5:0] clipped_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      centres_values_17_votes_s8_q <= centres_values_17_votes_s7_q;
      centres_values_17_firm_s8_q <= centres_values_17_firm_q;
      centres_values_17_grey_s8_q <= centres_values_17_grey_s7_q;
      centres_values_17_exists_s8_q <= centres_values_17_exists_s7_q;
      centres_values_17_marks_first_s8_q <= centres_values_17_marks_first_s7_q;
      centres_values_17_marks_last_s8_q <= centres_values_17_marks_last_s7_q;
      clipped_s8_q <= clipped;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contest.hpp:61
  logic and_337;
  assign and_337 = centres_values_17_votes_s8_q & (~(clipped_s8_q == 6'h0));
  // hls/stages/contest.hpp:65
  logic [6:0] select_339;
  assign select_339 = and_337 ? ({3'h0, cfg_bias_i} + {clipped_s8_q[5], clipped_s8_q}) : 7'h0;

  logic [5:0] centres_values_17_grey_s9_q;
  logic centres_values_17_exists_s9_q;
  logic centres_values_17_marks_first_s9_q;
  logic centres_values_17_marks_last_s9_q;
  logic [6:0] select_339_s9_q;
  logic and_340_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      centres_values_17_grey_s9_q <= centres_values_17_grey_s8_q;
      centres_values_17_exists_s9_q <= centres_values_17_exists_s8_q;
      centres_values_17_marks_first_s9_q <= centres_values_17_marks_first_s8_q;
      centres_values_17_marks_last_s9_q <= centres_values_17_marks_last_s8_q;
      select_339_s9_q <= select_339;
      and_340_s9_q <= centres_values_17_firm_s8_q & and_337;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign vote_o = select_339_s9_q;
  assign firm_o = and_340_s9_q;
  assign grey_o = centres_values_17_grey_s9_q;
  assign exists_o = centres_values_17_exists_s9_q;
  assign marks_first_o = centres_values_17_marks_first_s9_q;
  assign marks_last_o = centres_values_17_marks_last_s9_q;
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

endmodule
