// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Spread<horopter::hls::profiles::hd>, hls/stages/spread.hpp. Do not edit.
//
// Latency 11 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1633 bits, pipeline 432 bits, memories 0 bits.
module horopter_spread (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic signed [6:0] vote_i,
  input  logic firm_i,
  input  logic [5:0] grey_i,
  input  logic exists_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  input  logic [2:0] cfg_smooth_i,
  output logic valid_o,
  output logic signed [7:0] vote_o,
  output logic firm_o,
  output logic [5:0] grey_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en;
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

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [6:0] last_vote_q;
  logic [5:0] last_grey_q;
  logic last_exists_q;
  logic [6:0] first_values_0_left_q;
  logic centres_values_0_firm_q;
  logic centres_values_0_marks_first_q;
  logic centres_values_0_marks_seen_q;
  logic centres_values_0_marks_nearer_q;
  logic centres_values_1_firm_q;
  logic [5:0] centres_values_1_grey_q;
  logic centres_values_1_exists_q;
  logic centres_values_1_marks_first_q;
  logic centres_values_1_marks_seen_q;
  logic centres_values_1_marks_nearer_q;
  logic centres_values_2_firm_q;
  logic [5:0] centres_values_2_grey_q;
  logic centres_values_2_exists_q;
  logic centres_values_2_marks_first_q;
  logic centres_values_2_marks_seen_q;
  logic centres_values_2_marks_nearer_q;
  logic centres_values_3_firm_q;
  logic [5:0] centres_values_3_grey_q;
  logic centres_values_3_exists_q;
  logic centres_values_3_marks_first_q;
  logic centres_values_3_marks_seen_q;
  logic centres_values_3_marks_nearer_q;
  logic centres_values_4_firm_q;
  logic [5:0] centres_values_4_grey_q;
  logic centres_values_4_exists_q;
  logic centres_values_4_marks_first_q;
  logic centres_values_4_marks_seen_q;
  logic centres_values_4_marks_nearer_q;
  logic centres_values_5_firm_q;
  logic [5:0] centres_values_5_grey_q;
  logic centres_values_5_exists_q;
  logic centres_values_5_marks_first_q;
  logic centres_values_5_marks_seen_q;
  logic centres_values_5_marks_nearer_q;
  logic centres_values_6_firm_q;
  logic [5:0] centres_values_6_grey_q;
  logic centres_values_6_exists_q;
  logic centres_values_6_marks_first_q;
  logic centres_values_6_marks_seen_q;
  logic centres_values_6_marks_nearer_q;
  logic centres_values_7_firm_q;
  logic [5:0] centres_values_7_grey_q;
  logic centres_values_7_exists_q;
  logic centres_values_7_marks_first_q;
  logic centres_values_7_marks_seen_q;
  logic centres_values_7_marks_nearer_q;
  logic centres_values_8_firm_q;
  logic [5:0] centres_values_8_grey_q;
  logic centres_values_8_exists_q;
  logic centres_values_8_marks_first_q;
  logic centres_values_8_marks_seen_q;
  logic centres_values_8_marks_nearer_q;
  logic centres_values_9_firm_q;
  logic [5:0] centres_values_9_grey_q;
  logic centres_values_9_exists_q;
  logic centres_values_9_marks_first_q;
  logic centres_values_9_marks_seen_q;
  logic centres_values_9_marks_nearer_q;
  logic centres_values_10_firm_q;
  logic [5:0] centres_values_10_grey_q;
  logic centres_values_10_exists_q;
  logic centres_values_10_marks_first_q;
  logic centres_values_10_marks_seen_q;
  logic centres_values_10_marks_nearer_q;
  logic centres_values_11_firm_q;
  logic [5:0] centres_values_11_grey_q;
  logic centres_values_11_exists_q;
  logic centres_values_11_marks_first_q;
  logic centres_values_11_marks_seen_q;
  logic centres_values_11_marks_nearer_q;
  logic centres_values_12_firm_q;
  logic [5:0] centres_values_12_grey_q;
  logic centres_values_12_exists_q;
  logic centres_values_12_marks_first_q;
  logic centres_values_12_marks_seen_q;
  logic centres_values_12_marks_nearer_q;
  logic centres_values_13_firm_q;
  logic [5:0] centres_values_13_grey_q;
  logic centres_values_13_exists_q;
  logic centres_values_13_marks_first_q;
  logic centres_values_13_marks_seen_q;
  logic centres_values_13_marks_nearer_q;
  logic centres_values_14_firm_q;
  logic [5:0] centres_values_14_grey_q;
  logic centres_values_14_exists_q;
  logic centres_values_14_marks_first_q;
  logic centres_values_14_marks_seen_q;
  logic centres_values_14_marks_nearer_q;
  logic centres_values_15_firm_q;
  logic [5:0] centres_values_15_grey_q;
  logic centres_values_15_exists_q;
  logic centres_values_15_marks_first_q;
  logic centres_values_15_marks_seen_q;
  logic centres_values_15_marks_nearer_q;
  logic centres_values_16_firm_q;
  logic [5:0] centres_values_16_grey_q;
  logic centres_values_16_exists_q;
  logic centres_values_16_marks_first_q;
  logic centres_values_16_marks_seen_q;
  logic centres_values_16_marks_nearer_q;
  logic centres_values_17_firm_q;
  logic [5:0] centres_values_17_grey_q;
  logic centres_values_17_exists_q;
  logic centres_values_17_marks_first_q;
  logic centres_values_17_marks_seen_q;
  logic centres_values_17_marks_nearer_q;
  logic centres_values_18_firm_q;
  logic [5:0] centres_values_18_grey_q;
  logic centres_values_18_exists_q;
  logic centres_values_18_marks_first_q;
  logic centres_values_18_marks_seen_q;
  logic centres_values_18_marks_nearer_q;
  logic centres_values_19_firm_q;
  logic [5:0] centres_values_19_grey_q;
  logic centres_values_19_exists_q;
  logic centres_values_19_marks_first_q;
  logic centres_values_19_marks_seen_q;
  logic centres_values_19_marks_nearer_q;
  logic centres_values_20_firm_q;
  logic [5:0] centres_values_20_grey_q;
  logic centres_values_20_exists_q;
  logic centres_values_20_marks_first_q;
  logic centres_values_20_marks_seen_q;
  logic centres_values_20_marks_nearer_q;
  logic centres_values_21_firm_q;
  logic [5:0] centres_values_21_grey_q;
  logic centres_values_21_exists_q;
  logic centres_values_21_marks_first_q;
  logic centres_values_21_marks_seen_q;
  logic centres_values_21_marks_nearer_q;
  logic centres_values_22_firm_q;
  logic [5:0] centres_values_22_grey_q;
  logic centres_values_22_exists_q;
  logic centres_values_22_marks_first_q;
  logic centres_values_22_marks_seen_q;
  logic centres_values_22_marks_nearer_q;
  logic centres_values_23_firm_q;
  logic [5:0] centres_values_23_grey_q;
  logic centres_values_23_exists_q;
  logic centres_values_23_marks_first_q;
  logic centres_values_23_marks_seen_q;
  logic centres_values_23_marks_nearer_q;
  logic centres_values_24_firm_q;
  logic [5:0] centres_values_24_grey_q;
  logic centres_values_24_exists_q;
  logic centres_values_24_marks_first_q;
  logic centres_values_24_marks_seen_q;
  logic centres_values_24_marks_nearer_q;
  logic centres_values_25_firm_q;
  logic [5:0] centres_values_25_grey_q;
  logic centres_values_25_exists_q;
  logic centres_values_25_marks_first_q;
  logic centres_values_25_marks_seen_q;
  logic centres_values_25_marks_nearer_q;
  logic centres_values_26_firm_q;
  logic [5:0] centres_values_26_grey_q;
  logic centres_values_26_exists_q;
  logic centres_values_26_marks_first_q;
  logic centres_values_26_marks_seen_q;
  logic centres_values_26_marks_nearer_q;
  logic centres_values_27_firm_q;
  logic [5:0] centres_values_27_grey_q;
  logic centres_values_27_exists_q;
  logic centres_values_27_marks_first_q;
  logic centres_values_27_marks_seen_q;
  logic centres_values_27_marks_nearer_q;
  logic centres_values_28_firm_q;
  logic [5:0] centres_values_28_grey_q;
  logic centres_values_28_exists_q;
  logic centres_values_28_marks_first_q;
  logic centres_values_28_marks_seen_q;
  logic centres_values_28_marks_nearer_q;
  logic centres_values_29_firm_q;
  logic [5:0] centres_values_29_grey_q;
  logic centres_values_29_exists_q;
  logic centres_values_29_marks_first_q;
  logic centres_values_29_marks_seen_q;
  logic centres_values_29_marks_nearer_q;
  logic centres_values_30_firm_q;
  logic [5:0] centres_values_30_grey_q;
  logic centres_values_30_exists_q;
  logic centres_values_30_marks_first_q;
  logic centres_values_30_marks_seen_q;
  logic centres_values_30_marks_nearer_q;
  logic centres_values_31_firm_q;
  logic [5:0] centres_values_31_grey_q;
  logic centres_values_31_exists_q;
  logic centres_values_31_marks_first_q;
  logic centres_values_31_marks_seen_q;
  logic centres_values_31_marks_nearer_q;
  // hls/stages/spread.hpp:51
  logic [6:0] difference_421;
  assign difference_421 = {1'b0, grey_i} - {1'b0, last_grey_q};
  logic [5:0] xor_422;
  assign xor_422 = difference_421[5:0] ^ {6{difference_421[6]}};
  logic [6:0] difference;
  assign difference = {6'h0, difference_421[6]} + {1'b0, xor_422};
  // hls/stages/spread.hpp:87
  logic [7:0] difference_432;
  assign difference_432 = {last_vote_q[6], last_vote_q} - {{5{last_vote_q[6]}}, last_vote_q[6:4]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      last_vote_q <= 7'h0;
      last_grey_q <= 6'h0;
      last_exists_q <= 1'b0;
      first_values_0_left_q <= 7'h0;
      centres_values_0_firm_q <= 1'b0;
      centres_values_0_marks_first_q <= 1'b0;
      centres_values_0_marks_seen_q <= 1'b0;
      centres_values_0_marks_nearer_q <= 1'b0;
      centres_values_1_firm_q <= 1'b0;
      centres_values_1_grey_q <= 6'h0;
      centres_values_1_exists_q <= 1'b0;
      centres_values_1_marks_first_q <= 1'b0;
      centres_values_1_marks_seen_q <= 1'b0;
      centres_values_1_marks_nearer_q <= 1'b0;
      centres_values_2_firm_q <= 1'b0;
      centres_values_2_grey_q <= 6'h0;
      centres_values_2_exists_q <= 1'b0;
      centres_values_2_marks_first_q <= 1'b0;
      centres_values_2_marks_seen_q <= 1'b0;
      centres_values_2_marks_nearer_q <= 1'b0;
      centres_values_3_firm_q <= 1'b0;
      centres_values_3_grey_q <= 6'h0;
      centres_values_3_exists_q <= 1'b0;
      centres_values_3_marks_first_q <= 1'b0;
      centres_values_3_marks_seen_q <= 1'b0;
      centres_values_3_marks_nearer_q <= 1'b0;
      centres_values_4_firm_q <= 1'b0;
      centres_values_4_grey_q <= 6'h0;
      centres_values_4_exists_q <= 1'b0;
      centres_values_4_marks_first_q <= 1'b0;
      centres_values_4_marks_seen_q <= 1'b0;
      centres_values_4_marks_nearer_q <= 1'b0;
      centres_values_5_firm_q <= 1'b0;
      centres_values_5_grey_q <= 6'h0;
      centres_values_5_exists_q <= 1'b0;
      centres_values_5_marks_first_q <= 1'b0;
      centres_values_5_marks_seen_q <= 1'b0;
      centres_values_5_marks_nearer_q <= 1'b0;
      centres_values_6_firm_q <= 1'b0;
      centres_values_6_grey_q <= 6'h0;
      centres_values_6_exists_q <= 1'b0;
      centres_values_6_marks_first_q <= 1'b0;
      centres_values_6_marks_seen_q <= 1'b0;
      centres_values_6_marks_nearer_q <= 1'b0;
      centres_values_7_firm_q <= 1'b0;
      centres_values_7_grey_q <= 6'h0;
      centres_values_7_exists_q <= 1'b0;
      centres_values_7_marks_first_q <= 1'b0;
      centres_values_7_marks_seen_q <= 1'b0;
      centres_values_7_marks_nearer_q <= 1'b0;
      centres_values_8_firm_q <= 1'b0;
      centres_values_8_grey_q <= 6'h0;
      centres_values_8_exists_q <= 1'b0;
      centres_values_8_marks_first_q <= 1'b0;
      centres_values_8_marks_seen_q <= 1'b0;
      centres_values_8_marks_nearer_q <= 1'b0;
      centres_values_9_firm_q <= 1'b0;
      centres_values_9_grey_q <= 6'h0;
      centres_values_9_exists_q <= 1'b0;
      centres_values_9_marks_first_q <= 1'b0;
      centres_values_9_marks_seen_q <= 1'b0;
      centres_values_9_marks_nearer_q <= 1'b0;
      centres_values_10_firm_q <= 1'b0;
      centres_values_10_grey_q <= 6'h0;
      centres_values_10_exists_q <= 1'b0;
      centres_values_10_marks_first_q <= 1'b0;
      centres_values_10_marks_seen_q <= 1'b0;
      centres_values_10_marks_nearer_q <= 1'b0;
      centres_values_11_firm_q <= 1'b0;
      centres_values_11_grey_q <= 6'h0;
      centres_values_11_exists_q <= 1'b0;
      centres_values_11_marks_first_q <= 1'b0;
      centres_values_11_marks_seen_q <= 1'b0;
      centres_values_11_marks_nearer_q <= 1'b0;
      centres_values_12_firm_q <= 1'b0;
      centres_values_12_grey_q <= 6'h0;
      centres_values_12_exists_q <= 1'b0;
      centres_values_12_marks_first_q <= 1'b0;
      centres_values_12_marks_seen_q <= 1'b0;
      centres_values_12_marks_nearer_q <= 1'b0;
      centres_values_13_firm_q <= 1'b0;
      centres_values_13_grey_q <= 6'h0;
      centres_values_13_exists_q <= 1'b0;
      centres_values_13_marks_first_q <= 1'b0;
      centres_values_13_marks_seen_q <= 1'b0;
      centres_values_13_marks_nearer_q <= 1'b0;
      centres_values_14_firm_q <= 1'b0;
      centres_values_14_grey_q <= 6'h0;
      centres_values_14_exists_q <= 1'b0;
      centres_values_14_marks_first_q <= 1'b0;
      centres_values_14_marks_seen_q <= 1'b0;
      centres_values_14_marks_nearer_q <= 1'b0;
      centres_values_15_firm_q <= 1'b0;
      centres_values_15_grey_q <= 6'h0;
      centres_values_15_exists_q <= 1'b0;
      centres_values_15_marks_first_q <= 1'b0;
      centres_values_15_marks_seen_q <= 1'b0;
      centres_values_15_marks_nearer_q <= 1'b0;
      centres_values_16_firm_q <= 1'b0;
      centres_values_16_grey_q <= 6'h0;
      centres_values_16_exists_q <= 1'b0;
      centres_values_16_marks_first_q <= 1'b0;
      centres_values_16_marks_seen_q <= 1'b0;
      centres_values_16_marks_nearer_q <= 1'b0;
      centres_values_17_firm_q <= 1'b0;
      centres_values_17_grey_q <= 6'h0;
      centres_values_17_exists_q <= 1'b0;
      centres_values_17_marks_first_q <= 1'b0;
      centres_values_17_marks_seen_q <= 1'b0;
      centres_values_17_marks_nearer_q <= 1'b0;
      centres_values_18_firm_q <= 1'b0;
      centres_values_18_grey_q <= 6'h0;
      centres_values_18_exists_q <= 1'b0;
      centres_values_18_marks_first_q <= 1'b0;
      centres_values_18_marks_seen_q <= 1'b0;
      centres_values_18_marks_nearer_q <= 1'b0;
      centres_values_19_firm_q <= 1'b0;
      centres_values_19_grey_q <= 6'h0;
      centres_values_19_exists_q <= 1'b0;
      centres_values_19_marks_first_q <= 1'b0;
      centres_values_19_marks_seen_q <= 1'b0;
      centres_values_19_marks_nearer_q <= 1'b0;
      centres_values_20_firm_q <= 1'b0;
      centres_values_20_grey_q <= 6'h0;
      centres_values_20_exists_q <= 1'b0;
      centres_values_20_marks_first_q <= 1'b0;
      centres_values_20_marks_seen_q <= 1'b0;
      centres_values_20_marks_nearer_q <= 1'b0;
      centres_values_21_firm_q <= 1'b0;
      centres_values_21_grey_q <= 6'h0;
      centres_values_21_exists_q <= 1'b0;
      centres_values_21_marks_first_q <= 1'b0;
      centres_values_21_marks_seen_q <= 1'b0;
      centres_values_21_marks_nearer_q <= 1'b0;
      centres_values_22_firm_q <= 1'b0;
      centres_values_22_grey_q <= 6'h0;
      centres_values_22_exists_q <= 1'b0;
      centres_values_22_marks_first_q <= 1'b0;
      centres_values_22_marks_seen_q <= 1'b0;
      centres_values_22_marks_nearer_q <= 1'b0;
      centres_values_23_firm_q <= 1'b0;
      centres_values_23_grey_q <= 6'h0;
      centres_values_23_exists_q <= 1'b0;
      centres_values_23_marks_first_q <= 1'b0;
      centres_values_23_marks_seen_q <= 1'b0;
      centres_values_23_marks_nearer_q <= 1'b0;
      centres_values_24_firm_q <= 1'b0;
      centres_values_24_grey_q <= 6'h0;
      centres_values_24_exists_q <= 1'b0;
      centres_values_24_marks_first_q <= 1'b0;
      centres_values_24_marks_seen_q <= 1'b0;
      centres_values_24_marks_nearer_q <= 1'b0;
      centres_values_25_firm_q <= 1'b0;
      centres_values_25_grey_q <= 6'h0;
      centres_values_25_exists_q <= 1'b0;
      centres_values_25_marks_first_q <= 1'b0;
      centres_values_25_marks_seen_q <= 1'b0;
      centres_values_25_marks_nearer_q <= 1'b0;
      centres_values_26_firm_q <= 1'b0;
      centres_values_26_grey_q <= 6'h0;
      centres_values_26_exists_q <= 1'b0;
      centres_values_26_marks_first_q <= 1'b0;
      centres_values_26_marks_seen_q <= 1'b0;
      centres_values_26_marks_nearer_q <= 1'b0;
      centres_values_27_firm_q <= 1'b0;
      centres_values_27_grey_q <= 6'h0;
      centres_values_27_exists_q <= 1'b0;
      centres_values_27_marks_first_q <= 1'b0;
      centres_values_27_marks_seen_q <= 1'b0;
      centres_values_27_marks_nearer_q <= 1'b0;
      centres_values_28_firm_q <= 1'b0;
      centres_values_28_grey_q <= 6'h0;
      centres_values_28_exists_q <= 1'b0;
      centres_values_28_marks_first_q <= 1'b0;
      centres_values_28_marks_seen_q <= 1'b0;
      centres_values_28_marks_nearer_q <= 1'b0;
      centres_values_29_firm_q <= 1'b0;
      centres_values_29_grey_q <= 6'h0;
      centres_values_29_exists_q <= 1'b0;
      centres_values_29_marks_first_q <= 1'b0;
      centres_values_29_marks_seen_q <= 1'b0;
      centres_values_29_marks_nearer_q <= 1'b0;
      centres_values_30_firm_q <= 1'b0;
      centres_values_30_grey_q <= 6'h0;
      centres_values_30_exists_q <= 1'b0;
      centres_values_30_marks_first_q <= 1'b0;
      centres_values_30_marks_seen_q <= 1'b0;
      centres_values_30_marks_nearer_q <= 1'b0;
      centres_values_31_firm_q <= 1'b0;
      centres_values_31_grey_q <= 6'h0;
      centres_values_31_exists_q <= 1'b0;
      centres_values_31_marks_first_q <= 1'b0;
      centres_values_31_marks_seen_q <= 1'b0;
      centres_values_31_marks_nearer_q <= 1'b0;
    end else if (s0_en) begin
      last_vote_q <= $unsigned(vote_i);
      last_grey_q <= grey_i;
      last_exists_q <= exists_i;
      first_values_0_left_q <= last_vote_q;
      centres_values_0_firm_q <= firm_i;
      centres_values_0_marks_first_q <= marks_first_i;
      centres_values_0_marks_seen_q <= marks_seen_i;
      centres_values_0_marks_nearer_q <= marks_nearer_i;
      centres_values_1_firm_q <= centres_values_0_firm_q;
      centres_values_1_grey_q <= last_grey_q;
      centres_values_1_exists_q <= last_exists_q;
      centres_values_1_marks_first_q <= centres_values_0_marks_first_q;
      centres_values_1_marks_seen_q <= centres_values_0_marks_seen_q;
      centres_values_1_marks_nearer_q <= centres_values_0_marks_nearer_q;
      centres_values_2_firm_q <= centres_values_1_firm_q;
      centres_values_2_grey_q <= centres_values_1_grey_q;
      centres_values_2_exists_q <= centres_values_1_exists_q;
      centres_values_2_marks_first_q <= centres_values_1_marks_first_q;
      centres_values_2_marks_seen_q <= centres_values_1_marks_seen_q;
      centres_values_2_marks_nearer_q <= centres_values_1_marks_nearer_q;
      centres_values_3_firm_q <= centres_values_2_firm_q;
      centres_values_3_grey_q <= centres_values_2_grey_q;
      centres_values_3_exists_q <= centres_values_2_exists_q;
      centres_values_3_marks_first_q <= centres_values_2_marks_first_q;
      centres_values_3_marks_seen_q <= centres_values_2_marks_seen_q;
      centres_values_3_marks_nearer_q <= centres_values_2_marks_nearer_q;
      centres_values_4_firm_q <= centres_values_3_firm_q;
      centres_values_4_grey_q <= centres_values_3_grey_q;
      centres_values_4_exists_q <= centres_values_3_exists_q;
      centres_values_4_marks_first_q <= centres_values_3_marks_first_q;
      centres_values_4_marks_seen_q <= centres_values_3_marks_seen_q;
      centres_values_4_marks_nearer_q <= centres_values_3_marks_nearer_q;
      centres_values_5_firm_q <= centres_values_4_firm_q;
      centres_values_5_grey_q <= centres_values_4_grey_q;
      centres_values_5_exists_q <= centres_values_4_exists_q;
      centres_values_5_marks_first_q <= centres_values_4_marks_first_q;
      centres_values_5_marks_seen_q <= centres_values_4_marks_seen_q;
      centres_values_5_marks_nearer_q <= centres_values_4_marks_nearer_q;
      centres_values_6_firm_q <= centres_values_5_firm_q;
      centres_values_6_grey_q <= centres_values_5_grey_q;
      centres_values_6_exists_q <= centres_values_5_exists_q;
      centres_values_6_marks_first_q <= centres_values_5_marks_first_q;
      centres_values_6_marks_seen_q <= centres_values_5_marks_seen_q;
      centres_values_6_marks_nearer_q <= centres_values_5_marks_nearer_q;
      centres_values_7_firm_q <= centres_values_6_firm_q;
      centres_values_7_grey_q <= centres_values_6_grey_q;
      centres_values_7_exists_q <= centres_values_6_exists_q;
      centres_values_7_marks_first_q <= centres_values_6_marks_first_q;
      centres_values_7_marks_seen_q <= centres_values_6_marks_seen_q;
      centres_values_7_marks_nearer_q <= centres_values_6_marks_nearer_q;
      centres_values_8_firm_q <= centres_values_7_firm_q;
      centres_values_8_grey_q <= centres_values_7_grey_q;
      centres_values_8_exists_q <= centres_values_7_exists_q;
      centres_values_8_marks_first_q <= centres_values_7_marks_first_q;
      centres_values_8_marks_seen_q <= centres_values_7_marks_seen_q;
      centres_values_8_marks_nearer_q <= centres_values_7_marks_nearer_q;
      centres_values_9_firm_q <= centres_values_8_firm_q;
      centres_values_9_grey_q <= centres_values_8_grey_q;
      centres_values_9_exists_q <= centres_values_8_exists_q;
      centres_values_9_marks_first_q <= centres_values_8_marks_first_q;
      centres_values_9_marks_seen_q <= centres_values_8_marks_seen_q;
      centres_values_9_marks_nearer_q <= centres_values_8_marks_nearer_q;
      centres_values_10_firm_q <= centres_values_9_firm_q;
      centres_values_10_grey_q <= centres_values_9_grey_q;
      centres_values_10_exists_q <= centres_values_9_exists_q;
      centres_values_10_marks_first_q <= centres_values_9_marks_first_q;
      centres_values_10_marks_seen_q <= centres_values_9_marks_seen_q;
      centres_values_10_marks_nearer_q <= centres_values_9_marks_nearer_q;
      centres_values_11_firm_q <= centres_values_10_firm_q;
      centres_values_11_grey_q <= centres_values_10_grey_q;
      centres_values_11_exists_q <= centres_values_10_exists_q;
      centres_values_11_marks_first_q <= centres_values_10_marks_first_q;
      centres_values_11_marks_seen_q <= centres_values_10_marks_seen_q;
      centres_values_11_marks_nearer_q <= centres_values_10_marks_nearer_q;
      centres_values_12_firm_q <= centres_values_11_firm_q;
      centres_values_12_grey_q <= centres_values_11_grey_q;
      centres_values_12_exists_q <= centres_values_11_exists_q;
      centres_values_12_marks_first_q <= centres_values_11_marks_first_q;
      centres_values_12_marks_seen_q <= centres_values_11_marks_seen_q;
      centres_values_12_marks_nearer_q <= centres_values_11_marks_nearer_q;
      centres_values_13_firm_q <= centres_values_12_firm_q;
      centres_values_13_grey_q <= centres_values_12_grey_q;
      centres_values_13_exists_q <= centres_values_12_exists_q;
      centres_values_13_marks_first_q <= centres_values_12_marks_first_q;
      centres_values_13_marks_seen_q <= centres_values_12_marks_seen_q;
      centres_values_13_marks_nearer_q <= centres_values_12_marks_nearer_q;
      centres_values_14_firm_q <= centres_values_13_firm_q;
      centres_values_14_grey_q <= centres_values_13_grey_q;
      centres_values_14_exists_q <= centres_values_13_exists_q;
      centres_values_14_marks_first_q <= centres_values_13_marks_first_q;
      centres_values_14_marks_seen_q <= centres_values_13_marks_seen_q;
      centres_values_14_marks_nearer_q <= centres_values_13_marks_nearer_q;
      centres_values_15_firm_q <= centres_values_14_firm_q;
      centres_values_15_grey_q <= centres_values_14_grey_q;
      centres_values_15_exists_q <= centres_values_14_exists_q;
      centres_values_15_marks_first_q <= centres_values_14_marks_first_q;
      centres_values_15_marks_seen_q <= centres_values_14_marks_seen_q;
      centres_values_15_marks_nearer_q <= centres_values_14_marks_nearer_q;
      centres_values_16_firm_q <= centres_values_15_firm_q;
      centres_values_16_grey_q <= centres_values_15_grey_q;
      centres_values_16_exists_q <= centres_values_15_exists_q;
      centres_values_16_marks_first_q <= centres_values_15_marks_first_q;
      centres_values_16_marks_seen_q <= centres_values_15_marks_seen_q;
      centres_values_16_marks_nearer_q <= centres_values_15_marks_nearer_q;
      centres_values_17_firm_q <= centres_values_16_firm_q;
      centres_values_17_grey_q <= centres_values_16_grey_q;
      centres_values_17_exists_q <= centres_values_16_exists_q;
      centres_values_17_marks_first_q <= centres_values_16_marks_first_q;
      centres_values_17_marks_seen_q <= centres_values_16_marks_seen_q;
      centres_values_17_marks_nearer_q <= centres_values_16_marks_nearer_q;
      centres_values_18_firm_q <= centres_values_17_firm_q;
      centres_values_18_grey_q <= centres_values_17_grey_q;
      centres_values_18_exists_q <= centres_values_17_exists_q;
      centres_values_18_marks_first_q <= centres_values_17_marks_first_q;
      centres_values_18_marks_seen_q <= centres_values_17_marks_seen_q;
      centres_values_18_marks_nearer_q <= centres_values_17_marks_nearer_q;
      centres_values_19_firm_q <= centres_values_18_firm_q;
      centres_values_19_grey_q <= centres_values_18_grey_q;
      centres_values_19_exists_q <= centres_values_18_exists_q;
      centres_values_19_marks_first_q <= centres_values_18_marks_first_q;
      centres_values_19_marks_seen_q <= centres_values_18_marks_seen_q;
      centres_values_19_marks_nearer_q <= centres_values_18_marks_nearer_q;
      centres_values_20_firm_q <= centres_values_19_firm_q;
      centres_values_20_grey_q <= centres_values_19_grey_q;
      centres_values_20_exists_q <= centres_values_19_exists_q;
      centres_values_20_marks_first_q <= centres_values_19_marks_first_q;
      centres_values_20_marks_seen_q <= centres_values_19_marks_seen_q;
      centres_values_20_marks_nearer_q <= centres_values_19_marks_nearer_q;
      centres_values_21_firm_q <= centres_values_20_firm_q;
      centres_values_21_grey_q <= centres_values_20_grey_q;
      centres_values_21_exists_q <= centres_values_20_exists_q;
      centres_values_21_marks_first_q <= centres_values_20_marks_first_q;
      centres_values_21_marks_seen_q <= centres_values_20_marks_seen_q;
      centres_values_21_marks_nearer_q <= centres_values_20_marks_nearer_q;
      centres_values_22_firm_q <= centres_values_21_firm_q;
      centres_values_22_grey_q <= centres_values_21_grey_q;
      centres_values_22_exists_q <= centres_values_21_exists_q;
      centres_values_22_marks_first_q <= centres_values_21_marks_first_q;
      centres_values_22_marks_seen_q <= centres_values_21_marks_seen_q;
      centres_values_22_marks_nearer_q <= centres_values_21_marks_nearer_q;
      centres_values_23_firm_q <= centres_values_22_firm_q;
      centres_values_23_grey_q <= centres_values_22_grey_q;
      centres_values_23_exists_q <= centres_values_22_exists_q;
      centres_values_23_marks_first_q <= centres_values_22_marks_first_q;
      centres_values_23_marks_seen_q <= centres_values_22_marks_seen_q;
      centres_values_23_marks_nearer_q <= centres_values_22_marks_nearer_q;
      centres_values_24_firm_q <= centres_values_23_firm_q;
      centres_values_24_grey_q <= centres_values_23_grey_q;
      centres_values_24_exists_q <= centres_values_23_exists_q;
      centres_values_24_marks_first_q <= centres_values_23_marks_first_q;
      centres_values_24_marks_seen_q <= centres_values_23_marks_seen_q;
      centres_values_24_marks_nearer_q <= centres_values_23_marks_nearer_q;
      centres_values_25_firm_q <= centres_values_24_firm_q;
      centres_values_25_grey_q <= centres_values_24_grey_q;
      centres_values_25_exists_q <= centres_values_24_exists_q;
      centres_values_25_marks_first_q <= centres_values_24_marks_first_q;
      centres_values_25_marks_seen_q <= centres_values_24_marks_seen_q;
      centres_values_25_marks_nearer_q <= centres_values_24_marks_nearer_q;
      centres_values_26_firm_q <= centres_values_25_firm_q;
      centres_values_26_grey_q <= centres_values_25_grey_q;
      centres_values_26_exists_q <= centres_values_25_exists_q;
      centres_values_26_marks_first_q <= centres_values_25_marks_first_q;
      centres_values_26_marks_seen_q <= centres_values_25_marks_seen_q;
      centres_values_26_marks_nearer_q <= centres_values_25_marks_nearer_q;
      centres_values_27_firm_q <= centres_values_26_firm_q;
      centres_values_27_grey_q <= centres_values_26_grey_q;
      centres_values_27_exists_q <= centres_values_26_exists_q;
      centres_values_27_marks_first_q <= centres_values_26_marks_first_q;
      centres_values_27_marks_seen_q <= centres_values_26_marks_seen_q;
      centres_values_27_marks_nearer_q <= centres_values_26_marks_nearer_q;
      centres_values_28_firm_q <= centres_values_27_firm_q;
      centres_values_28_grey_q <= centres_values_27_grey_q;
      centres_values_28_exists_q <= centres_values_27_exists_q;
      centres_values_28_marks_first_q <= centres_values_27_marks_first_q;
      centres_values_28_marks_seen_q <= centres_values_27_marks_seen_q;
      centres_values_28_marks_nearer_q <= centres_values_27_marks_nearer_q;
      centres_values_29_firm_q <= centres_values_28_firm_q;
      centres_values_29_grey_q <= centres_values_28_grey_q;
      centres_values_29_exists_q <= centres_values_28_exists_q;
      centres_values_29_marks_first_q <= centres_values_28_marks_first_q;
      centres_values_29_marks_seen_q <= centres_values_28_marks_seen_q;
      centres_values_29_marks_nearer_q <= centres_values_28_marks_nearer_q;
      centres_values_30_firm_q <= centres_values_29_firm_q;
      centres_values_30_grey_q <= centres_values_29_grey_q;
      centres_values_30_exists_q <= centres_values_29_exists_q;
      centres_values_30_marks_first_q <= centres_values_29_marks_first_q;
      centres_values_30_marks_seen_q <= centres_values_29_marks_seen_q;
      centres_values_30_marks_nearer_q <= centres_values_29_marks_nearer_q;
      centres_values_31_firm_q <= centres_values_30_firm_q;
      centres_values_31_grey_q <= centres_values_30_grey_q;
      centres_values_31_exists_q <= centres_values_30_exists_q;
      centres_values_31_marks_first_q <= centres_values_30_marks_first_q;
      centres_values_31_marks_seen_q <= centres_values_30_marks_seen_q;
      centres_values_31_marks_nearer_q <= centres_values_30_marks_nearer_q;
    end
  end

  logic marks_last_s1_q;
  logic [6:0] first_values_0_left_s1_q;
  logic centres_values_31_firm_s1_q;
  logic [5:0] centres_values_31_grey_s1_q;
  logic centres_values_31_exists_s1_q;
  logic centres_values_31_marks_first_s1_q;
  logic centres_values_31_marks_seen_s1_q;
  logic centres_values_31_marks_nearer_s1_q;
  logic [6:0] difference_s1_q;
  logic [7:0] difference_432_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      marks_last_s1_q <= marks_last_i;
      first_values_0_left_s1_q <= first_values_0_left_q;
      centres_values_31_firm_s1_q <= centres_values_31_firm_q;
      centres_values_31_grey_s1_q <= centres_values_31_grey_q;
      centres_values_31_exists_s1_q <= centres_values_31_exists_q;
      centres_values_31_marks_first_s1_q <= centres_values_31_marks_first_q;
      centres_values_31_marks_seen_s1_q <= centres_values_31_marks_seen_q;
      centres_values_31_marks_nearer_s1_q <= centres_values_31_marks_nearer_q;
      difference_s1_q <= difference;
      difference_432_s1_q <= difference_432;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic row_ended_q;
  logic first_values_0_joined_q;
  logic first_values_1_joined_q;
  logic [8:0] second_values_0_right_q;
  logic [8:0] second_values_1_right_q;
  logic centres_values_0_marks_last_q;
  logic centres_values_1_marks_last_q;
  logic centres_values_2_marks_last_q;
  logic centres_values_3_marks_last_q;
  logic centres_values_4_marks_last_q;
  logic centres_values_5_marks_last_q;
  logic centres_values_6_marks_last_q;
  logic centres_values_7_marks_last_q;
  logic centres_values_8_marks_last_q;
  logic centres_values_9_marks_last_q;
  logic centres_values_10_marks_last_q;
  logic centres_values_11_marks_last_q;
  logic centres_values_12_marks_last_q;
  logic centres_values_13_marks_last_q;
  logic centres_values_14_marks_last_q;
  logic centres_values_15_marks_last_q;
  logic centres_values_16_marks_last_q;
  logic centres_values_17_marks_last_q;
  logic centres_values_18_marks_last_q;
  logic centres_values_19_marks_last_q;
  logic centres_values_20_marks_last_q;
  logic centres_values_21_marks_last_q;
  logic centres_values_22_marks_last_q;
  logic centres_values_23_marks_last_q;
  logic centres_values_24_marks_last_q;
  logic centres_values_25_marks_last_q;
  logic centres_values_26_marks_last_q;
  logic centres_values_27_marks_last_q;
  logic centres_values_28_marks_last_q;
  logic centres_values_29_marks_last_q;
  logic centres_values_30_marks_last_q;
  logic centres_values_31_marks_last_q;
  // hls/stages/spread.hpp:51
  logic and_426;
  assign and_426 = centres_values_1_exists_q & (~({4'h0, cfg_smooth_i} < difference_s1_q));
  logic joined;
  assign joined = (~(centres_values_0_marks_first_q | row_ended_q)) & (last_exists_q & and_426);
  // hls/stages/spread.hpp:102
  logic [8:0] sum_433;
  assign sum_433 = {{2{first_values_0_left_s1_q[6]}}, first_values_0_left_s1_q} + {difference_432_s1_q[7], difference_432_s1_q};
  logic [8:0] value;
  assign value = first_values_0_joined_q ? sum_433 : {{2{first_values_0_left_s1_q[6]}}, first_values_0_left_s1_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_ended_q <= 1'b1;
      first_values_0_joined_q <= 1'b0;
      first_values_1_joined_q <= 1'b0;
      second_values_0_right_q <= 9'h0;
      second_values_1_right_q <= 9'h0;
      centres_values_0_marks_last_q <= 1'b0;
      centres_values_1_marks_last_q <= 1'b0;
      centres_values_2_marks_last_q <= 1'b0;
      centres_values_3_marks_last_q <= 1'b0;
      centres_values_4_marks_last_q <= 1'b0;
      centres_values_5_marks_last_q <= 1'b0;
      centres_values_6_marks_last_q <= 1'b0;
      centres_values_7_marks_last_q <= 1'b0;
      centres_values_8_marks_last_q <= 1'b0;
      centres_values_9_marks_last_q <= 1'b0;
      centres_values_10_marks_last_q <= 1'b0;
      centres_values_11_marks_last_q <= 1'b0;
      centres_values_12_marks_last_q <= 1'b0;
      centres_values_13_marks_last_q <= 1'b0;
      centres_values_14_marks_last_q <= 1'b0;
      centres_values_15_marks_last_q <= 1'b0;
      centres_values_16_marks_last_q <= 1'b0;
      centres_values_17_marks_last_q <= 1'b0;
      centres_values_18_marks_last_q <= 1'b0;
      centres_values_19_marks_last_q <= 1'b0;
      centres_values_20_marks_last_q <= 1'b0;
      centres_values_21_marks_last_q <= 1'b0;
      centres_values_22_marks_last_q <= 1'b0;
      centres_values_23_marks_last_q <= 1'b0;
      centres_values_24_marks_last_q <= 1'b0;
      centres_values_25_marks_last_q <= 1'b0;
      centres_values_26_marks_last_q <= 1'b0;
      centres_values_27_marks_last_q <= 1'b0;
      centres_values_28_marks_last_q <= 1'b0;
      centres_values_29_marks_last_q <= 1'b0;
      centres_values_30_marks_last_q <= 1'b0;
      centres_values_31_marks_last_q <= 1'b0;
    end else if (s1_en) begin
      row_ended_q <= marks_last_s1_q;
      first_values_0_joined_q <= joined;
      first_values_1_joined_q <= first_values_0_joined_q;
      second_values_0_right_q <= value;
      second_values_1_right_q <= second_values_0_right_q;
      centres_values_0_marks_last_q <= marks_last_s1_q;
      centres_values_1_marks_last_q <= centres_values_0_marks_last_q;
      centres_values_2_marks_last_q <= centres_values_1_marks_last_q;
      centres_values_3_marks_last_q <= centres_values_2_marks_last_q;
      centres_values_4_marks_last_q <= centres_values_3_marks_last_q;
      centres_values_5_marks_last_q <= centres_values_4_marks_last_q;
      centres_values_6_marks_last_q <= centres_values_5_marks_last_q;
      centres_values_7_marks_last_q <= centres_values_6_marks_last_q;
      centres_values_8_marks_last_q <= centres_values_7_marks_last_q;
      centres_values_9_marks_last_q <= centres_values_8_marks_last_q;
      centres_values_10_marks_last_q <= centres_values_9_marks_last_q;
      centres_values_11_marks_last_q <= centres_values_10_marks_last_q;
      centres_values_12_marks_last_q <= centres_values_11_marks_last_q;
      centres_values_13_marks_last_q <= centres_values_12_marks_last_q;
      centres_values_14_marks_last_q <= centres_values_13_marks_last_q;
      centres_values_15_marks_last_q <= centres_values_14_marks_last_q;
      centres_values_16_marks_last_q <= centres_values_15_marks_last_q;
      centres_values_17_marks_last_q <= centres_values_16_marks_last_q;
      centres_values_18_marks_last_q <= centres_values_17_marks_last_q;
      centres_values_19_marks_last_q <= centres_values_18_marks_last_q;
      centres_values_20_marks_last_q <= centres_values_19_marks_last_q;
      centres_values_21_marks_last_q <= centres_values_20_marks_last_q;
      centres_values_22_marks_last_q <= centres_values_21_marks_last_q;
      centres_values_23_marks_last_q <= centres_values_22_marks_last_q;
      centres_values_24_marks_last_q <= centres_values_23_marks_last_q;
      centres_values_25_marks_last_q <= centres_values_24_marks_last_q;
      centres_values_26_marks_last_q <= centres_values_25_marks_last_q;
      centres_values_27_marks_last_q <= centres_values_26_marks_last_q;
      centres_values_28_marks_last_q <= centres_values_27_marks_last_q;
      centres_values_29_marks_last_q <= centres_values_28_marks_last_q;
      centres_values_30_marks_last_q <= centres_values_29_marks_last_q;
      centres_values_31_marks_last_q <= centres_values_30_marks_last_q;
    end
  end

  logic [6:0] first_values_0_left_s2_q;
  logic first_values_1_joined_s2_q;
  logic [8:0] second_values_1_right_s2_q;
  logic centres_values_31_firm_s2_q;
  logic [5:0] centres_values_31_grey_s2_q;
  logic centres_values_31_exists_s2_q;
  logic centres_values_31_marks_first_s2_q;
  logic centres_values_31_marks_last_s2_q;
  logic centres_values_31_marks_seen_s2_q;
  logic centres_values_31_marks_nearer_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      first_values_0_left_s2_q <= first_values_0_left_s1_q;
      first_values_1_joined_s2_q <= first_values_1_joined_q;
      second_values_1_right_s2_q <= second_values_1_right_q;
      centres_values_31_firm_s2_q <= centres_values_31_firm_s1_q;
      centres_values_31_grey_s2_q <= centres_values_31_grey_s1_q;
      centres_values_31_exists_s2_q <= centres_values_31_exists_s1_q;
      centres_values_31_marks_first_s2_q <= centres_values_31_marks_first_s1_q;
      centres_values_31_marks_last_s2_q <= centres_values_31_marks_last_q;
      centres_values_31_marks_seen_s2_q <= centres_values_31_marks_seen_s1_q;
      centres_values_31_marks_nearer_s2_q <= centres_values_31_marks_nearer_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/spread.hpp:88
  logic [9:0] difference_439;
  assign difference_439 = {second_values_0_right_q[8], second_values_0_right_q} - {{4{second_values_0_right_q[8]}}, second_values_0_right_q[8:3]};
  // hls/stages/spread.hpp:102
  logic [10:0] sum_440;
  assign sum_440 = {{2{second_values_1_right_s2_q[8]}}, second_values_1_right_s2_q} + {difference_439[9], difference_439};

  logic [6:0] first_values_0_left_s3_q;
  logic first_values_1_joined_s3_q;
  logic [8:0] second_values_1_right_s3_q;
  logic centres_values_31_firm_s3_q;
  logic [5:0] centres_values_31_grey_s3_q;
  logic centres_values_31_exists_s3_q;
  logic centres_values_31_marks_first_s3_q;
  logic centres_values_31_marks_last_s3_q;
  logic centres_values_31_marks_seen_s3_q;
  logic centres_values_31_marks_nearer_s3_q;
  logic and_435_s3_q;
  logic [10:0] sum_440_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      first_values_0_left_s3_q <= first_values_0_left_s2_q;
      first_values_1_joined_s3_q <= first_values_1_joined_s2_q;
      second_values_1_right_s3_q <= second_values_1_right_s2_q;
      centres_values_31_firm_s3_q <= centres_values_31_firm_s2_q;
      centres_values_31_grey_s3_q <= centres_values_31_grey_s2_q;
      centres_values_31_exists_s3_q <= centres_values_31_exists_s2_q;
      centres_values_31_marks_first_s3_q <= centres_values_31_marks_first_s2_q;
      centres_values_31_marks_last_s3_q <= centres_values_31_marks_last_s2_q;
      centres_values_31_marks_seen_s3_q <= centres_values_31_marks_seen_s2_q;
      centres_values_31_marks_nearer_s3_q <= centres_values_31_marks_nearer_s2_q;
      and_435_s3_q <= first_values_1_joined_q & first_values_0_joined_q;
      sum_440_s3_q <= sum_440;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] first_values_1_left_q;
  logic second_values_0_joined_q;
  logic second_values_1_joined_q;
  logic second_values_2_joined_q;
  logic second_values_3_joined_q;
  logic [10:0] third_values_0_right_q;
  logic [10:0] third_values_1_right_q;
  logic [10:0] third_values_2_right_q;
  logic [10:0] third_values_3_right_q;
  logic [6:0] centres_values_3_vote_q;
  logic [6:0] centres_values_4_vote_q;
  logic [6:0] centres_values_5_vote_q;
  logic [6:0] centres_values_6_vote_q;
  logic [6:0] centres_values_7_vote_q;
  logic [6:0] centres_values_8_vote_q;
  logic [6:0] centres_values_9_vote_q;
  logic [6:0] centres_values_10_vote_q;
  logic [6:0] centres_values_11_vote_q;
  logic [6:0] centres_values_12_vote_q;
  logic [6:0] centres_values_13_vote_q;
  logic [6:0] centres_values_14_vote_q;
  logic [6:0] centres_values_15_vote_q;
  logic [6:0] centres_values_16_vote_q;
  logic [6:0] centres_values_17_vote_q;
  logic [6:0] centres_values_18_vote_q;
  logic [6:0] centres_values_19_vote_q;
  logic [6:0] centres_values_20_vote_q;
  logic [6:0] centres_values_21_vote_q;
  logic [6:0] centres_values_22_vote_q;
  logic [6:0] centres_values_23_vote_q;
  logic [6:0] centres_values_24_vote_q;
  logic [6:0] centres_values_25_vote_q;
  logic [6:0] centres_values_26_vote_q;
  logic [6:0] centres_values_27_vote_q;
  logic [6:0] centres_values_28_vote_q;
  logic [6:0] centres_values_29_vote_q;
  logic [6:0] centres_values_30_vote_q;
  logic [6:0] centres_values_31_vote_q;
  // hls/stages/spread.hpp:87
  logic [7:0] difference_429;
  assign difference_429 = {first_values_1_left_q[6], first_values_1_left_q} - {{5{first_values_1_left_q[6]}}, first_values_1_left_q[6:4]};
  // hls/stages/spread.hpp:102
  logic [10:0] value_2;
  assign value_2 = second_values_1_joined_q ? sum_440_s3_q : {{2{second_values_1_right_s3_q[8]}}, second_values_1_right_s3_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      first_values_1_left_q <= 7'h0;
      second_values_0_joined_q <= 1'b0;
      second_values_1_joined_q <= 1'b0;
      second_values_2_joined_q <= 1'b0;
      second_values_3_joined_q <= 1'b0;
      third_values_0_right_q <= 11'h0;
      third_values_1_right_q <= 11'h0;
      third_values_2_right_q <= 11'h0;
      third_values_3_right_q <= 11'h0;
      centres_values_3_vote_q <= 7'h0;
      centres_values_4_vote_q <= 7'h0;
      centres_values_5_vote_q <= 7'h0;
      centres_values_6_vote_q <= 7'h0;
      centres_values_7_vote_q <= 7'h0;
      centres_values_8_vote_q <= 7'h0;
      centres_values_9_vote_q <= 7'h0;
      centres_values_10_vote_q <= 7'h0;
      centres_values_11_vote_q <= 7'h0;
      centres_values_12_vote_q <= 7'h0;
      centres_values_13_vote_q <= 7'h0;
      centres_values_14_vote_q <= 7'h0;
      centres_values_15_vote_q <= 7'h0;
      centres_values_16_vote_q <= 7'h0;
      centres_values_17_vote_q <= 7'h0;
      centres_values_18_vote_q <= 7'h0;
      centres_values_19_vote_q <= 7'h0;
      centres_values_20_vote_q <= 7'h0;
      centres_values_21_vote_q <= 7'h0;
      centres_values_22_vote_q <= 7'h0;
      centres_values_23_vote_q <= 7'h0;
      centres_values_24_vote_q <= 7'h0;
      centres_values_25_vote_q <= 7'h0;
      centres_values_26_vote_q <= 7'h0;
      centres_values_27_vote_q <= 7'h0;
      centres_values_28_vote_q <= 7'h0;
      centres_values_29_vote_q <= 7'h0;
      centres_values_30_vote_q <= 7'h0;
      centres_values_31_vote_q <= 7'h0;
    end else if (s3_en) begin
      first_values_1_left_q <= first_values_0_left_s3_q;
      second_values_0_joined_q <= and_435_s3_q;
      second_values_1_joined_q <= second_values_0_joined_q;
      second_values_2_joined_q <= second_values_1_joined_q;
      second_values_3_joined_q <= second_values_2_joined_q;
      third_values_0_right_q <= value_2;
      third_values_1_right_q <= third_values_0_right_q;
      third_values_2_right_q <= third_values_1_right_q;
      third_values_3_right_q <= third_values_2_right_q;
      centres_values_3_vote_q <= first_values_1_left_q;
      centres_values_4_vote_q <= centres_values_3_vote_q;
      centres_values_5_vote_q <= centres_values_4_vote_q;
      centres_values_6_vote_q <= centres_values_5_vote_q;
      centres_values_7_vote_q <= centres_values_6_vote_q;
      centres_values_8_vote_q <= centres_values_7_vote_q;
      centres_values_9_vote_q <= centres_values_8_vote_q;
      centres_values_10_vote_q <= centres_values_9_vote_q;
      centres_values_11_vote_q <= centres_values_10_vote_q;
      centres_values_12_vote_q <= centres_values_11_vote_q;
      centres_values_13_vote_q <= centres_values_12_vote_q;
      centres_values_14_vote_q <= centres_values_13_vote_q;
      centres_values_15_vote_q <= centres_values_14_vote_q;
      centres_values_16_vote_q <= centres_values_15_vote_q;
      centres_values_17_vote_q <= centres_values_16_vote_q;
      centres_values_18_vote_q <= centres_values_17_vote_q;
      centres_values_19_vote_q <= centres_values_18_vote_q;
      centres_values_20_vote_q <= centres_values_19_vote_q;
      centres_values_21_vote_q <= centres_values_20_vote_q;
      centres_values_22_vote_q <= centres_values_21_vote_q;
      centres_values_23_vote_q <= centres_values_22_vote_q;
      centres_values_24_vote_q <= centres_values_23_vote_q;
      centres_values_25_vote_q <= centres_values_24_vote_q;
      centres_values_26_vote_q <= centres_values_25_vote_q;
      centres_values_27_vote_q <= centres_values_26_vote_q;
      centres_values_28_vote_q <= centres_values_27_vote_q;
      centres_values_29_vote_q <= centres_values_28_vote_q;
      centres_values_30_vote_q <= centres_values_29_vote_q;
      centres_values_31_vote_q <= centres_values_30_vote_q;
    end
  end

  logic first_values_1_joined_s4_q;
  logic second_values_3_joined_s4_q;
  logic [10:0] third_values_3_right_s4_q;
  logic [6:0] centres_values_31_vote_s4_q;
  logic centres_values_31_firm_s4_q;
  logic [5:0] centres_values_31_grey_s4_q;
  logic centres_values_31_exists_s4_q;
  logic centres_values_31_marks_first_s4_q;
  logic centres_values_31_marks_last_s4_q;
  logic centres_values_31_marks_seen_s4_q;
  logic centres_values_31_marks_nearer_s4_q;
  logic [7:0] difference_429_s4_q;
  logic [10:0] difference_446_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      first_values_1_joined_s4_q <= first_values_1_joined_s3_q;
      second_values_3_joined_s4_q <= second_values_3_joined_q;
      third_values_3_right_s4_q <= third_values_3_right_q;
      centres_values_31_vote_s4_q <= centres_values_31_vote_q;
      centres_values_31_firm_s4_q <= centres_values_31_firm_s3_q;
      centres_values_31_grey_s4_q <= centres_values_31_grey_s3_q;
      centres_values_31_exists_s4_q <= centres_values_31_exists_s3_q;
      centres_values_31_marks_first_s4_q <= centres_values_31_marks_first_s3_q;
      centres_values_31_marks_last_s4_q <= centres_values_31_marks_last_s3_q;
      centres_values_31_marks_seen_s4_q <= centres_values_31_marks_seen_s3_q;
      centres_values_31_marks_nearer_s4_q <= centres_values_31_marks_nearer_s3_q;
      difference_429_s4_q <= difference_429;
      difference_446_s4_q <= value_2 - {{2{value_2[10]}}, value_2[10:2]};
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [8:0] second_values_0_left_q;
  logic [8:0] second_values_1_left_q;
  logic [8:0] second_values_2_left_q;
  logic [8:0] second_values_3_left_q;
  logic third_values_0_joined_q;
  logic third_values_1_joined_q;
  logic third_values_2_joined_q;
  logic third_values_3_joined_q;
  logic third_values_4_joined_q;
  logic third_values_5_joined_q;
  logic third_values_6_joined_q;
  logic third_values_7_joined_q;
  logic [10:0] fourth_values_0_right_q;
  logic [10:0] fourth_values_1_right_q;
  logic [10:0] fourth_values_2_right_q;
  logic [10:0] fourth_values_3_right_q;
  logic [10:0] fourth_values_4_right_q;
  logic [10:0] fourth_values_5_right_q;
  logic [10:0] fourth_values_6_right_q;
  logic [10:0] fourth_values_7_right_q;
  // hls/stages/spread.hpp:101
  logic [8:0] sum_430;
  assign sum_430 = {{2{first_values_1_left_q[6]}}, first_values_1_left_q} + {difference_429_s4_q[7], difference_429_s4_q};
  logic [8:0] select_431;
  assign select_431 = first_values_1_joined_s4_q ? sum_430 : {{2{first_values_1_left_q[6]}}, first_values_1_left_q};
  // hls/stages/spread.hpp:88
  logic [9:0] difference_436;
  assign difference_436 = {second_values_3_left_q[8], second_values_3_left_q} - {{4{second_values_3_left_q[8]}}, second_values_3_left_q[8:3]};
  // hls/stages/spread.hpp:102
  logic [10:0] value_3;
  assign value_3 = third_values_3_joined_q ? (third_values_3_right_s4_q + difference_446_s4_q) : third_values_3_right_s4_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      second_values_0_left_q <= 9'h0;
      second_values_1_left_q <= 9'h0;
      second_values_2_left_q <= 9'h0;
      second_values_3_left_q <= 9'h0;
      third_values_0_joined_q <= 1'b0;
      third_values_1_joined_q <= 1'b0;
      third_values_2_joined_q <= 1'b0;
      third_values_3_joined_q <= 1'b0;
      third_values_4_joined_q <= 1'b0;
      third_values_5_joined_q <= 1'b0;
      third_values_6_joined_q <= 1'b0;
      third_values_7_joined_q <= 1'b0;
      fourth_values_0_right_q <= 11'h0;
      fourth_values_1_right_q <= 11'h0;
      fourth_values_2_right_q <= 11'h0;
      fourth_values_3_right_q <= 11'h0;
      fourth_values_4_right_q <= 11'h0;
      fourth_values_5_right_q <= 11'h0;
      fourth_values_6_right_q <= 11'h0;
      fourth_values_7_right_q <= 11'h0;
    end else if (s4_en) begin
      second_values_0_left_q <= select_431;
      second_values_1_left_q <= second_values_0_left_q;
      second_values_2_left_q <= second_values_1_left_q;
      second_values_3_left_q <= second_values_2_left_q;
      third_values_0_joined_q <= second_values_2_joined_q & second_values_0_joined_q;
      third_values_1_joined_q <= third_values_0_joined_q;
      third_values_2_joined_q <= third_values_1_joined_q;
      third_values_3_joined_q <= third_values_2_joined_q;
      third_values_4_joined_q <= third_values_3_joined_q;
      third_values_5_joined_q <= third_values_4_joined_q;
      third_values_6_joined_q <= third_values_5_joined_q;
      third_values_7_joined_q <= third_values_6_joined_q;
      fourth_values_0_right_q <= value_3;
      fourth_values_1_right_q <= fourth_values_0_right_q;
      fourth_values_2_right_q <= fourth_values_1_right_q;
      fourth_values_3_right_q <= fourth_values_2_right_q;
      fourth_values_4_right_q <= fourth_values_3_right_q;
      fourth_values_5_right_q <= fourth_values_4_right_q;
      fourth_values_6_right_q <= fourth_values_5_right_q;
      fourth_values_7_right_q <= fourth_values_6_right_q;
    end
  end

  logic second_values_3_joined_s5_q;
  logic third_values_7_joined_s5_q;
  logic [10:0] fourth_values_7_right_s5_q;
  logic [6:0] centres_values_31_vote_s5_q;
  logic centres_values_31_firm_s5_q;
  logic [5:0] centres_values_31_grey_s5_q;
  logic centres_values_31_exists_s5_q;
  logic centres_values_31_marks_first_s5_q;
  logic centres_values_31_marks_last_s5_q;
  logic centres_values_31_marks_seen_s5_q;
  logic centres_values_31_marks_nearer_s5_q;
  logic [9:0] difference_436_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      second_values_3_joined_s5_q <= second_values_3_joined_s4_q;
      third_values_7_joined_s5_q <= third_values_7_joined_q;
      fourth_values_7_right_s5_q <= fourth_values_7_right_q;
      centres_values_31_vote_s5_q <= centres_values_31_vote_s4_q;
      centres_values_31_firm_s5_q <= centres_values_31_firm_s4_q;
      centres_values_31_grey_s5_q <= centres_values_31_grey_s4_q;
      centres_values_31_exists_s5_q <= centres_values_31_exists_s4_q;
      centres_values_31_marks_first_s5_q <= centres_values_31_marks_first_s4_q;
      centres_values_31_marks_last_s5_q <= centres_values_31_marks_last_s4_q;
      centres_values_31_marks_seen_s5_q <= centres_values_31_marks_seen_s4_q;
      centres_values_31_marks_nearer_s5_q <= centres_values_31_marks_nearer_s4_q;
      difference_436_s5_q <= difference_436;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [10:0] third_values_0_left_q;
  logic [10:0] third_values_1_left_q;
  logic [10:0] third_values_2_left_q;
  logic [10:0] third_values_3_left_q;
  logic [10:0] third_values_4_left_q;
  logic [10:0] third_values_5_left_q;
  logic [10:0] third_values_6_left_q;
  logic [10:0] third_values_7_left_q;
  // hls/stages/spread.hpp:101
  logic [10:0] sum_437;
  assign sum_437 = {{2{second_values_2_left_q[8]}}, second_values_2_left_q} + {difference_436_s5_q[9], difference_436_s5_q};
  logic [10:0] select_438;
  assign select_438 = second_values_3_joined_s5_q ? sum_437 : {{2{second_values_2_left_q[8]}}, second_values_2_left_q};
  // hls/stages/spread.hpp:89
  logic [10:0] difference_443;
  assign difference_443 = third_values_7_left_q - {{2{third_values_7_left_q[10]}}, third_values_7_left_q[10:2]};
  // hls/stages/spread.hpp:90
  logic [10:0] difference_454;
  assign difference_454 = fourth_values_0_right_q - {fourth_values_0_right_q[10], fourth_values_0_right_q[10:1]};
  logic [10:0] sum_455;
  assign sum_455 = {{3{fourth_values_0_right_q[10]}}, fourth_values_0_right_q[10:3]} + difference_454;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      third_values_0_left_q <= 11'h0;
      third_values_1_left_q <= 11'h0;
      third_values_2_left_q <= 11'h0;
      third_values_3_left_q <= 11'h0;
      third_values_4_left_q <= 11'h0;
      third_values_5_left_q <= 11'h0;
      third_values_6_left_q <= 11'h0;
      third_values_7_left_q <= 11'h0;
    end else if (s5_en) begin
      third_values_0_left_q <= select_438;
      third_values_1_left_q <= third_values_0_left_q;
      third_values_2_left_q <= third_values_1_left_q;
      third_values_3_left_q <= third_values_2_left_q;
      third_values_4_left_q <= third_values_3_left_q;
      third_values_5_left_q <= third_values_4_left_q;
      third_values_6_left_q <= third_values_5_left_q;
      third_values_7_left_q <= third_values_6_left_q;
    end
  end

  logic third_values_7_joined_s6_q;
  logic [10:0] fourth_values_7_right_s6_q;
  logic [6:0] centres_values_31_vote_s6_q;
  logic centres_values_31_firm_s6_q;
  logic [5:0] centres_values_31_grey_s6_q;
  logic centres_values_31_exists_s6_q;
  logic centres_values_31_marks_first_s6_q;
  logic centres_values_31_marks_last_s6_q;
  logic centres_values_31_marks_seen_s6_q;
  logic centres_values_31_marks_nearer_s6_q;
  logic [10:0] sum_444_s6_q;
  logic and_449_s6_q;
  logic [10:0] sum_455_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      third_values_7_joined_s6_q <= third_values_7_joined_s5_q;
      fourth_values_7_right_s6_q <= fourth_values_7_right_s5_q;
      centres_values_31_vote_s6_q <= centres_values_31_vote_s5_q;
      centres_values_31_firm_s6_q <= centres_values_31_firm_s5_q;
      centres_values_31_grey_s6_q <= centres_values_31_grey_s5_q;
      centres_values_31_exists_s6_q <= centres_values_31_exists_s5_q;
      centres_values_31_marks_first_s6_q <= centres_values_31_marks_first_s5_q;
      centres_values_31_marks_last_s6_q <= centres_values_31_marks_last_s5_q;
      centres_values_31_marks_seen_s6_q <= centres_values_31_marks_seen_s5_q;
      centres_values_31_marks_nearer_s6_q <= centres_values_31_marks_nearer_s5_q;
      sum_444_s6_q <= third_values_3_left_q + difference_443;
      and_449_s6_q <= third_values_4_joined_q & third_values_0_joined_q;
      sum_455_s6_q <= sum_455;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [10:0] fourth_values_0_left_q;
  logic fourth_values_0_joined_q;
  logic [10:0] fourth_values_1_left_q;
  logic fourth_values_1_joined_q;
  logic [10:0] fourth_values_2_left_q;
  logic fourth_values_2_joined_q;
  logic [10:0] fourth_values_3_left_q;
  logic fourth_values_3_joined_q;
  logic [10:0] fourth_values_4_left_q;
  logic fourth_values_4_joined_q;
  logic [10:0] fourth_values_5_left_q;
  logic fourth_values_5_joined_q;
  logic [10:0] fourth_values_6_left_q;
  logic fourth_values_6_joined_q;
  logic [10:0] fourth_values_7_left_q;
  logic fourth_values_7_joined_q;
  logic [10:0] fourth_values_8_left_q;
  logic fourth_values_8_joined_q;
  logic [10:0] fourth_values_9_left_q;
  logic fourth_values_9_joined_q;
  logic [10:0] fourth_values_10_left_q;
  logic fourth_values_10_joined_q;
  logic [10:0] fourth_values_11_left_q;
  logic fourth_values_11_joined_q;
  logic [10:0] fourth_values_12_left_q;
  logic fourth_values_12_joined_q;
  logic [10:0] fourth_values_13_left_q;
  logic fourth_values_13_joined_q;
  logic [10:0] fourth_values_14_left_q;
  logic fourth_values_14_joined_q;
  logic [10:0] fourth_values_15_left_q;
  logic fourth_values_15_joined_q;
  logic [10:0] fifth_values_0_right_q;
  logic [10:0] fifth_values_1_right_q;
  logic [10:0] fifth_values_2_right_q;
  logic [10:0] fifth_values_3_right_q;
  logic [10:0] fifth_values_4_right_q;
  logic [10:0] fifth_values_5_right_q;
  logic [10:0] fifth_values_6_right_q;
  logic [10:0] fifth_values_7_right_q;
  logic [10:0] fifth_values_8_right_q;
  logic [10:0] fifth_values_9_right_q;
  logic [10:0] fifth_values_10_right_q;
  logic [10:0] fifth_values_11_right_q;
  logic [10:0] fifth_values_12_right_q;
  logic [10:0] fifth_values_13_right_q;
  logic [10:0] fifth_values_14_right_q;
  logic [10:0] fifth_values_15_right_q;
  // hls/stages/spread.hpp:101
  logic [10:0] select_445;
  assign select_445 = third_values_7_joined_s6_q ? sum_444_s6_q : third_values_4_left_q;
  // hls/stages/spread.hpp:90
  logic [10:0] difference_450;
  assign difference_450 = fourth_values_15_left_q - {fourth_values_15_left_q[10], fourth_values_15_left_q[10:1]};
  logic [10:0] sum_451;
  assign sum_451 = {{3{fourth_values_15_left_q[10]}}, fourth_values_15_left_q[10:3]} + difference_450;
  // hls/stages/spread.hpp:102
  logic [10:0] value_4;
  assign value_4 = fourth_values_7_joined_q ? (fourth_values_7_right_s6_q + sum_455_s6_q) : fourth_values_7_right_s6_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fourth_values_0_left_q <= 11'h0;
      fourth_values_0_joined_q <= 1'b0;
      fourth_values_1_left_q <= 11'h0;
      fourth_values_1_joined_q <= 1'b0;
      fourth_values_2_left_q <= 11'h0;
      fourth_values_2_joined_q <= 1'b0;
      fourth_values_3_left_q <= 11'h0;
      fourth_values_3_joined_q <= 1'b0;
      fourth_values_4_left_q <= 11'h0;
      fourth_values_4_joined_q <= 1'b0;
      fourth_values_5_left_q <= 11'h0;
      fourth_values_5_joined_q <= 1'b0;
      fourth_values_6_left_q <= 11'h0;
      fourth_values_6_joined_q <= 1'b0;
      fourth_values_7_left_q <= 11'h0;
      fourth_values_7_joined_q <= 1'b0;
      fourth_values_8_left_q <= 11'h0;
      fourth_values_8_joined_q <= 1'b0;
      fourth_values_9_left_q <= 11'h0;
      fourth_values_9_joined_q <= 1'b0;
      fourth_values_10_left_q <= 11'h0;
      fourth_values_10_joined_q <= 1'b0;
      fourth_values_11_left_q <= 11'h0;
      fourth_values_11_joined_q <= 1'b0;
      fourth_values_12_left_q <= 11'h0;
      fourth_values_12_joined_q <= 1'b0;
      fourth_values_13_left_q <= 11'h0;
      fourth_values_13_joined_q <= 1'b0;
      fourth_values_14_left_q <= 11'h0;
      fourth_values_14_joined_q <= 1'b0;
      fourth_values_15_left_q <= 11'h0;
      fourth_values_15_joined_q <= 1'b0;
      fifth_values_0_right_q <= 11'h0;
      fifth_values_1_right_q <= 11'h0;
      fifth_values_2_right_q <= 11'h0;
      fifth_values_3_right_q <= 11'h0;
      fifth_values_4_right_q <= 11'h0;
      fifth_values_5_right_q <= 11'h0;
      fifth_values_6_right_q <= 11'h0;
      fifth_values_7_right_q <= 11'h0;
      fifth_values_8_right_q <= 11'h0;
      fifth_values_9_right_q <= 11'h0;
      fifth_values_10_right_q <= 11'h0;
      fifth_values_11_right_q <= 11'h0;
      fifth_values_12_right_q <= 11'h0;
      fifth_values_13_right_q <= 11'h0;
      fifth_values_14_right_q <= 11'h0;
      fifth_values_15_right_q <= 11'h0;
    end else if (s6_en) begin
      fourth_values_0_left_q <= select_445;
      fourth_values_0_joined_q <= and_449_s6_q;
      fourth_values_1_left_q <= fourth_values_0_left_q;
      fourth_values_1_joined_q <= fourth_values_0_joined_q;
      fourth_values_2_left_q <= fourth_values_1_left_q;
      fourth_values_2_joined_q <= fourth_values_1_joined_q;
      fourth_values_3_left_q <= fourth_values_2_left_q;
      fourth_values_3_joined_q <= fourth_values_2_joined_q;
      fourth_values_4_left_q <= fourth_values_3_left_q;
      fourth_values_4_joined_q <= fourth_values_3_joined_q;
      fourth_values_5_left_q <= fourth_values_4_left_q;
      fourth_values_5_joined_q <= fourth_values_4_joined_q;
      fourth_values_6_left_q <= fourth_values_5_left_q;
      fourth_values_6_joined_q <= fourth_values_5_joined_q;
      fourth_values_7_left_q <= fourth_values_6_left_q;
      fourth_values_7_joined_q <= fourth_values_6_joined_q;
      fourth_values_8_left_q <= fourth_values_7_left_q;
      fourth_values_8_joined_q <= fourth_values_7_joined_q;
      fourth_values_9_left_q <= fourth_values_8_left_q;
      fourth_values_9_joined_q <= fourth_values_8_joined_q;
      fourth_values_10_left_q <= fourth_values_9_left_q;
      fourth_values_10_joined_q <= fourth_values_9_joined_q;
      fourth_values_11_left_q <= fourth_values_10_left_q;
      fourth_values_11_joined_q <= fourth_values_10_joined_q;
      fourth_values_12_left_q <= fourth_values_11_left_q;
      fourth_values_12_joined_q <= fourth_values_11_joined_q;
      fourth_values_13_left_q <= fourth_values_12_left_q;
      fourth_values_13_joined_q <= fourth_values_12_joined_q;
      fourth_values_14_left_q <= fourth_values_13_left_q;
      fourth_values_14_joined_q <= fourth_values_13_joined_q;
      fourth_values_15_left_q <= fourth_values_14_left_q;
      fourth_values_15_joined_q <= fourth_values_14_joined_q;
      fifth_values_0_right_q <= value_4;
      fifth_values_1_right_q <= fifth_values_0_right_q;
      fifth_values_2_right_q <= fifth_values_1_right_q;
      fifth_values_3_right_q <= fifth_values_2_right_q;
      fifth_values_4_right_q <= fifth_values_3_right_q;
      fifth_values_5_right_q <= fifth_values_4_right_q;
      fifth_values_6_right_q <= fifth_values_5_right_q;
      fifth_values_7_right_q <= fifth_values_6_right_q;
      fifth_values_8_right_q <= fifth_values_7_right_q;
      fifth_values_9_right_q <= fifth_values_8_right_q;
      fifth_values_10_right_q <= fifth_values_9_right_q;
      fifth_values_11_right_q <= fifth_values_10_right_q;
      fifth_values_12_right_q <= fifth_values_11_right_q;
      fifth_values_13_right_q <= fifth_values_12_right_q;
      fifth_values_14_right_q <= fifth_values_13_right_q;
      fifth_values_15_right_q <= fifth_values_14_right_q;
    end
  end

  logic fourth_values_15_joined_s7_q;
  logic [10:0] fifth_values_15_right_s7_q;
  logic [6:0] centres_values_31_vote_s7_q;
  logic centres_values_31_firm_s7_q;
  logic [5:0] centres_values_31_grey_s7_q;
  logic centres_values_31_exists_s7_q;
  logic centres_values_31_marks_first_s7_q;
  logic centres_values_31_marks_last_s7_q;
  logic centres_values_31_marks_seen_s7_q;
  logic centres_values_31_marks_nearer_s7_q;
  logic [10:0] sum_451_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      fourth_values_15_joined_s7_q <= fourth_values_15_joined_q;
      fifth_values_15_right_s7_q <= fifth_values_15_right_q;
      centres_values_31_vote_s7_q <= centres_values_31_vote_s6_q;
      centres_values_31_firm_s7_q <= centres_values_31_firm_s6_q;
      centres_values_31_grey_s7_q <= centres_values_31_grey_s6_q;
      centres_values_31_exists_s7_q <= centres_values_31_exists_s6_q;
      centres_values_31_marks_first_s7_q <= centres_values_31_marks_first_s6_q;
      centres_values_31_marks_last_s7_q <= centres_values_31_marks_last_s6_q;
      centres_values_31_marks_seen_s7_q <= centres_values_31_marks_seen_s6_q;
      centres_values_31_marks_nearer_s7_q <= centres_values_31_marks_nearer_s6_q;
      sum_451_s7_q <= sum_451;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [10:0] fifth_values_0_left_q;
  logic fifth_values_0_joined_q;
  logic [10:0] fifth_values_1_left_q;
  logic fifth_values_1_joined_q;
  logic [10:0] fifth_values_2_left_q;
  logic fifth_values_2_joined_q;
  logic [10:0] fifth_values_3_left_q;
  logic fifth_values_3_joined_q;
  logic [10:0] fifth_values_4_left_q;
  logic fifth_values_4_joined_q;
  logic [10:0] fifth_values_5_left_q;
  logic fifth_values_5_joined_q;
  logic [10:0] fifth_values_6_left_q;
  logic fifth_values_6_joined_q;
  logic [10:0] fifth_values_7_left_q;
  logic fifth_values_7_joined_q;
  logic [10:0] fifth_values_8_left_q;
  logic fifth_values_8_joined_q;
  logic [10:0] fifth_values_9_left_q;
  logic fifth_values_9_joined_q;
  logic [10:0] fifth_values_10_left_q;
  logic fifth_values_10_joined_q;
  logic [10:0] fifth_values_11_left_q;
  logic fifth_values_11_joined_q;
  logic [10:0] fifth_values_12_left_q;
  logic fifth_values_12_joined_q;
  logic [10:0] fifth_values_13_left_q;
  logic fifth_values_13_joined_q;
  logic [10:0] fifth_values_14_left_q;
  logic fifth_values_14_joined_q;
  logic [10:0] fifth_values_15_left_q;
  logic fifth_values_15_joined_q;
  logic [9:0] fifth_values_16_left_q;
  logic fifth_values_16_joined_q;
  logic [9:0] fifth_values_17_left_q;
  logic fifth_values_17_joined_q;
  logic [9:0] fifth_values_18_left_q;
  logic fifth_values_18_joined_q;
  logic [9:0] fifth_values_19_left_q;
  logic fifth_values_19_joined_q;
  logic [9:0] fifth_values_20_left_q;
  logic fifth_values_20_joined_q;
  logic [9:0] fifth_values_21_left_q;
  logic fifth_values_21_joined_q;
  logic [9:0] fifth_values_22_left_q;
  logic fifth_values_22_joined_q;
  logic [9:0] fifth_values_23_left_q;
  logic fifth_values_23_joined_q;
  logic [9:0] fifth_values_24_left_q;
  logic fifth_values_24_joined_q;
  logic [9:0] fifth_values_25_left_q;
  logic fifth_values_25_joined_q;
  logic [9:0] fifth_values_26_left_q;
  logic fifth_values_26_joined_q;
  logic [9:0] fifth_values_27_left_q;
  logic fifth_values_27_joined_q;
  logic [9:0] fifth_values_28_left_q;
  logic fifth_values_28_joined_q;
  logic [9:0] fifth_values_29_left_q;
  logic fifth_values_29_joined_q;
  logic [9:0] fifth_values_30_left_q;
  logic fifth_values_30_joined_q;
  logic [9:0] fifth_values_31_left_q;
  logic fifth_values_31_joined_q;
  // hls/stages/spread.hpp:101
  logic [10:0] select_453;
  assign select_453 = fourth_values_15_joined_s7_q ? (fourth_values_8_left_q + sum_451_s7_q) : fourth_values_8_left_q;
  // hls/stages/spread.hpp:91
  logic [10:0] difference_459;
  assign difference_459 = {fifth_values_31_left_q[9], fifth_values_31_left_q} - {{3{fifth_values_31_left_q[9]}}, fifth_values_31_left_q[9:2]};
  logic [10:0] difference_462;
  assign difference_462 = {fifth_values_0_right_q[10], fifth_values_0_right_q[10:1]} - {{3{fifth_values_0_right_q[10]}}, fifth_values_0_right_q[10:3]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fifth_values_0_left_q <= 11'h0;
      fifth_values_0_joined_q <= 1'b0;
      fifth_values_1_left_q <= 11'h0;
      fifth_values_1_joined_q <= 1'b0;
      fifth_values_2_left_q <= 11'h0;
      fifth_values_2_joined_q <= 1'b0;
      fifth_values_3_left_q <= 11'h0;
      fifth_values_3_joined_q <= 1'b0;
      fifth_values_4_left_q <= 11'h0;
      fifth_values_4_joined_q <= 1'b0;
      fifth_values_5_left_q <= 11'h0;
      fifth_values_5_joined_q <= 1'b0;
      fifth_values_6_left_q <= 11'h0;
      fifth_values_6_joined_q <= 1'b0;
      fifth_values_7_left_q <= 11'h0;
      fifth_values_7_joined_q <= 1'b0;
      fifth_values_8_left_q <= 11'h0;
      fifth_values_8_joined_q <= 1'b0;
      fifth_values_9_left_q <= 11'h0;
      fifth_values_9_joined_q <= 1'b0;
      fifth_values_10_left_q <= 11'h0;
      fifth_values_10_joined_q <= 1'b0;
      fifth_values_11_left_q <= 11'h0;
      fifth_values_11_joined_q <= 1'b0;
      fifth_values_12_left_q <= 11'h0;
      fifth_values_12_joined_q <= 1'b0;
      fifth_values_13_left_q <= 11'h0;
      fifth_values_13_joined_q <= 1'b0;
      fifth_values_14_left_q <= 11'h0;
      fifth_values_14_joined_q <= 1'b0;
      fifth_values_15_left_q <= 11'h0;
      fifth_values_15_joined_q <= 1'b0;
      fifth_values_16_left_q <= 10'h0;
      fifth_values_16_joined_q <= 1'b0;
      fifth_values_17_left_q <= 10'h0;
      fifth_values_17_joined_q <= 1'b0;
      fifth_values_18_left_q <= 10'h0;
      fifth_values_18_joined_q <= 1'b0;
      fifth_values_19_left_q <= 10'h0;
      fifth_values_19_joined_q <= 1'b0;
      fifth_values_20_left_q <= 10'h0;
      fifth_values_20_joined_q <= 1'b0;
      fifth_values_21_left_q <= 10'h0;
      fifth_values_21_joined_q <= 1'b0;
      fifth_values_22_left_q <= 10'h0;
      fifth_values_22_joined_q <= 1'b0;
      fifth_values_23_left_q <= 10'h0;
      fifth_values_23_joined_q <= 1'b0;
      fifth_values_24_left_q <= 10'h0;
      fifth_values_24_joined_q <= 1'b0;
      fifth_values_25_left_q <= 10'h0;
      fifth_values_25_joined_q <= 1'b0;
      fifth_values_26_left_q <= 10'h0;
      fifth_values_26_joined_q <= 1'b0;
      fifth_values_27_left_q <= 10'h0;
      fifth_values_27_joined_q <= 1'b0;
      fifth_values_28_left_q <= 10'h0;
      fifth_values_28_joined_q <= 1'b0;
      fifth_values_29_left_q <= 10'h0;
      fifth_values_29_joined_q <= 1'b0;
      fifth_values_30_left_q <= 10'h0;
      fifth_values_30_joined_q <= 1'b0;
      fifth_values_31_left_q <= 10'h0;
      fifth_values_31_joined_q <= 1'b0;
    end else if (s7_en) begin
      fifth_values_0_left_q <= select_453;
      fifth_values_0_joined_q <= fourth_values_8_joined_q & fourth_values_0_joined_q;
      fifth_values_1_left_q <= fifth_values_0_left_q;
      fifth_values_1_joined_q <= fifth_values_0_joined_q;
      fifth_values_2_left_q <= fifth_values_1_left_q;
      fifth_values_2_joined_q <= fifth_values_1_joined_q;
      fifth_values_3_left_q <= fifth_values_2_left_q;
      fifth_values_3_joined_q <= fifth_values_2_joined_q;
      fifth_values_4_left_q <= fifth_values_3_left_q;
      fifth_values_4_joined_q <= fifth_values_3_joined_q;
      fifth_values_5_left_q <= fifth_values_4_left_q;
      fifth_values_5_joined_q <= fifth_values_4_joined_q;
      fifth_values_6_left_q <= fifth_values_5_left_q;
      fifth_values_6_joined_q <= fifth_values_5_joined_q;
      fifth_values_7_left_q <= fifth_values_6_left_q;
      fifth_values_7_joined_q <= fifth_values_6_joined_q;
      fifth_values_8_left_q <= fifth_values_7_left_q;
      fifth_values_8_joined_q <= fifth_values_7_joined_q;
      fifth_values_9_left_q <= fifth_values_8_left_q;
      fifth_values_9_joined_q <= fifth_values_8_joined_q;
      fifth_values_10_left_q <= fifth_values_9_left_q;
      fifth_values_10_joined_q <= fifth_values_9_joined_q;
      fifth_values_11_left_q <= fifth_values_10_left_q;
      fifth_values_11_joined_q <= fifth_values_10_joined_q;
      fifth_values_12_left_q <= fifth_values_11_left_q;
      fifth_values_12_joined_q <= fifth_values_11_joined_q;
      fifth_values_13_left_q <= fifth_values_12_left_q;
      fifth_values_13_joined_q <= fifth_values_12_joined_q;
      fifth_values_14_left_q <= fifth_values_13_left_q;
      fifth_values_14_joined_q <= fifth_values_13_joined_q;
      fifth_values_15_left_q <= fifth_values_14_left_q;
      fifth_values_15_joined_q <= fifth_values_14_joined_q;
      fifth_values_16_left_q <= fifth_values_15_left_q[10:1];
      fifth_values_16_joined_q <= fifth_values_15_joined_q;
      fifth_values_17_left_q <= fifth_values_16_left_q;
      fifth_values_17_joined_q <= fifth_values_16_joined_q;
      fifth_values_18_left_q <= fifth_values_17_left_q;
      fifth_values_18_joined_q <= fifth_values_17_joined_q;
      fifth_values_19_left_q <= fifth_values_18_left_q;
      fifth_values_19_joined_q <= fifth_values_18_joined_q;
      fifth_values_20_left_q <= fifth_values_19_left_q;
      fifth_values_20_joined_q <= fifth_values_19_joined_q;
      fifth_values_21_left_q <= fifth_values_20_left_q;
      fifth_values_21_joined_q <= fifth_values_20_joined_q;
      fifth_values_22_left_q <= fifth_values_21_left_q;
      fifth_values_22_joined_q <= fifth_values_21_joined_q;
      fifth_values_23_left_q <= fifth_values_22_left_q;
      fifth_values_23_joined_q <= fifth_values_22_joined_q;
      fifth_values_24_left_q <= fifth_values_23_left_q;
      fifth_values_24_joined_q <= fifth_values_23_joined_q;
      fifth_values_25_left_q <= fifth_values_24_left_q;
      fifth_values_25_joined_q <= fifth_values_24_joined_q;
      fifth_values_26_left_q <= fifth_values_25_left_q;
      fifth_values_26_joined_q <= fifth_values_25_joined_q;
      fifth_values_27_left_q <= fifth_values_26_left_q;
      fifth_values_27_joined_q <= fifth_values_26_joined_q;
      fifth_values_28_left_q <= fifth_values_27_left_q;
      fifth_values_28_joined_q <= fifth_values_27_joined_q;
      fifth_values_29_left_q <= fifth_values_28_left_q;
      fifth_values_29_joined_q <= fifth_values_28_joined_q;
      fifth_values_30_left_q <= fifth_values_29_left_q;
      fifth_values_30_joined_q <= fifth_values_29_joined_q;
      fifth_values_31_left_q <= fifth_values_30_left_q;
      fifth_values_31_joined_q <= fifth_values_30_joined_q;
    end
  end

  logic fifth_values_15_left_s8_q;
  logic [10:0] fifth_values_15_right_s8_q;
  logic fifth_values_31_joined_s8_q;
  logic [6:0] centres_values_31_vote_s8_q;
  logic centres_values_31_firm_s8_q;
  logic [5:0] centres_values_31_grey_s8_q;
  logic centres_values_31_exists_s8_q;
  logic centres_values_31_marks_first_s8_q;
  logic centres_values_31_marks_last_s8_q;
  logic centres_values_31_marks_seen_s8_q;
  logic centres_values_31_marks_nearer_s8_q;
  logic [10:0] sum_460_s8_q;
  logic [10:0] sum_463_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      fifth_values_15_left_s8_q <= fifth_values_15_left_q[0];
      fifth_values_15_right_s8_q <= fifth_values_15_right_s7_q;
      fifth_values_31_joined_s8_q <= fifth_values_31_joined_q;
      centres_values_31_vote_s8_q <= centres_values_31_vote_s7_q;
      centres_values_31_firm_s8_q <= centres_values_31_firm_s7_q;
      centres_values_31_grey_s8_q <= centres_values_31_grey_s7_q;
      centres_values_31_exists_s8_q <= centres_values_31_exists_s7_q;
      centres_values_31_marks_first_s8_q <= centres_values_31_marks_first_s7_q;
      centres_values_31_marks_last_s8_q <= centres_values_31_marks_last_s7_q;
      centres_values_31_marks_seen_s8_q <= centres_values_31_marks_seen_s7_q;
      centres_values_31_marks_nearer_s8_q <= centres_values_31_marks_nearer_s7_q;
      sum_460_s8_q <= fifth_values_15_left_q + difference_459;
      sum_463_s8_q <= fifth_values_15_right_s7_q + difference_462;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/spread.hpp:101
  logic [10:0] select_461;
  assign select_461 = fifth_values_31_joined_s8_q ? sum_460_s8_q : {fifth_values_16_left_q, fifth_values_15_left_s8_q};
  // hls/stages/spread.hpp:102
  logic [10:0] select_464;
  assign select_464 = fifth_values_16_joined_q ? sum_463_s8_q : fifth_values_15_right_s8_q;

  logic [6:0] centres_values_31_vote_s9_q;
  logic centres_values_31_firm_s9_q;
  logic [5:0] centres_values_31_grey_s9_q;
  logic centres_values_31_exists_s9_q;
  logic centres_values_31_marks_first_s9_q;
  logic centres_values_31_marks_last_s9_q;
  logic centres_values_31_marks_seen_s9_q;
  logic centres_values_31_marks_nearer_s9_q;
  logic [11:0] sum_465_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      centres_values_31_vote_s9_q <= centres_values_31_vote_s8_q;
      centres_values_31_firm_s9_q <= centres_values_31_firm_s8_q;
      centres_values_31_grey_s9_q <= centres_values_31_grey_s8_q;
      centres_values_31_exists_s9_q <= centres_values_31_exists_s8_q;
      centres_values_31_marks_first_s9_q <= centres_values_31_marks_first_s8_q;
      centres_values_31_marks_last_s9_q <= centres_values_31_marks_last_s8_q;
      centres_values_31_marks_seen_s9_q <= centres_values_31_marks_seen_s8_q;
      centres_values_31_marks_nearer_s9_q <= centres_values_31_marks_nearer_s8_q;
      sum_465_s9_q <= {select_461[10], select_461} + {select_464[10], select_464};
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/spread.hpp:64
  logic [11:0] difference_466;
  assign difference_466 = sum_465_s9_q - {{5{centres_values_31_vote_s9_q[6]}}, centres_values_31_vote_s9_q};

  logic centres_values_31_firm_s10_q;
  logic [5:0] centres_values_31_grey_s10_q;
  logic centres_values_31_exists_s10_q;
  logic centres_values_31_marks_first_s10_q;
  logic centres_values_31_marks_last_s10_q;
  logic centres_values_31_marks_seen_s10_q;
  logic centres_values_31_marks_nearer_s10_q;
  logic [9:0] difference_466_s10_q;
  logic less_467_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      centres_values_31_firm_s10_q <= centres_values_31_firm_s9_q;
      centres_values_31_grey_s10_q <= centres_values_31_grey_s9_q;
      centres_values_31_exists_s10_q <= centres_values_31_exists_s9_q;
      centres_values_31_marks_first_s10_q <= centres_values_31_marks_first_s9_q;
      centres_values_31_marks_last_s10_q <= centres_values_31_marks_last_s9_q;
      centres_values_31_marks_seen_s10_q <= centres_values_31_marks_seen_s9_q;
      centres_values_31_marks_nearer_s10_q <= centres_values_31_marks_nearer_s9_q;
      difference_466_s10_q <= difference_466[11:2];
      less_467_s10_q <= $signed(difference_466[11:2]) < $signed(10'h381);
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/spread.hpp:67
  logic [9:0] select_468;
  assign select_468 = less_467_s10_q ? 10'h381 : difference_466_s10_q;
  logic [7:0] select_470;
  assign select_470 = ($signed(3'h0) < $signed(select_468[9:7])) ? 8'h7f : select_468[7:0];

  logic centres_values_31_firm_s11_q;
  logic [5:0] centres_values_31_grey_s11_q;
  logic centres_values_31_exists_s11_q;
  logic centres_values_31_marks_first_s11_q;
  logic centres_values_31_marks_last_s11_q;
  logic centres_values_31_marks_seen_s11_q;
  logic centres_values_31_marks_nearer_s11_q;
  logic [7:0] select_471_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      centres_values_31_firm_s11_q <= centres_values_31_firm_s10_q;
      centres_values_31_grey_s11_q <= centres_values_31_grey_s10_q;
      centres_values_31_exists_s11_q <= centres_values_31_exists_s10_q;
      centres_values_31_marks_first_s11_q <= centres_values_31_marks_first_s10_q;
      centres_values_31_marks_last_s11_q <= centres_values_31_marks_last_s10_q;
      centres_values_31_marks_seen_s11_q <= centres_values_31_marks_seen_s10_q;
      centres_values_31_marks_nearer_s11_q <= centres_values_31_marks_nearer_s10_q;
      select_471_s11_q <= centres_values_31_exists_s10_q ? select_470 : 8'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign vote_o = select_471_s11_q;
  assign firm_o = centres_values_31_firm_s11_q;
  assign grey_o = centres_values_31_grey_s11_q;
  assign exists_o = centres_values_31_exists_s11_q;
  assign marks_first_o = centres_values_31_marks_first_s11_q;
  assign marks_last_o = centres_values_31_marks_last_s11_q;
  assign marks_seen_o = centres_values_31_marks_seen_s11_q;
  assign marks_nearer_o = centres_values_31_marks_nearer_s11_q;
  assign valid_o = valid_s11_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^difference_466[1:0];

endmodule
