// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Spread<horopter::hls::profiles::hd>, hls/stages/spread.hpp. Do not edit.
//
// Latency 10 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 785 bits, pipeline 384 bits, memories 0 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s9_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s9_en = en_i & valid_s9_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [6:0] last_vote_q;
  logic [5:0] last_grey_q;
  logic last_exists_q;
  logic [6:0] first_values_0_left_q;
  logic centres_values_0_firm_q;
  logic centres_values_0_marks_seen_q;
  logic centres_values_0_marks_nearer_q;
  logic centres_values_1_firm_q;
  logic [5:0] centres_values_1_grey_q;
  logic centres_values_1_exists_q;
  logic centres_values_1_marks_seen_q;
  logic centres_values_1_marks_nearer_q;
  logic centres_values_2_firm_q;
  logic [5:0] centres_values_2_grey_q;
  logic centres_values_2_exists_q;
  logic centres_values_2_marks_seen_q;
  logic centres_values_2_marks_nearer_q;
  logic centres_values_3_firm_q;
  logic [5:0] centres_values_3_grey_q;
  logic centres_values_3_exists_q;
  logic centres_values_3_marks_seen_q;
  logic centres_values_3_marks_nearer_q;
  logic centres_values_4_firm_q;
  logic [5:0] centres_values_4_grey_q;
  logic centres_values_4_exists_q;
  logic centres_values_4_marks_seen_q;
  logic centres_values_4_marks_nearer_q;
  logic centres_values_5_firm_q;
  logic [5:0] centres_values_5_grey_q;
  logic centres_values_5_exists_q;
  logic centres_values_5_marks_seen_q;
  logic centres_values_5_marks_nearer_q;
  logic centres_values_6_firm_q;
  logic [5:0] centres_values_6_grey_q;
  logic centres_values_6_exists_q;
  logic centres_values_6_marks_seen_q;
  logic centres_values_6_marks_nearer_q;
  logic centres_values_7_firm_q;
  logic [5:0] centres_values_7_grey_q;
  logic centres_values_7_exists_q;
  logic centres_values_7_marks_seen_q;
  logic centres_values_7_marks_nearer_q;
  logic centres_values_8_firm_q;
  logic [5:0] centres_values_8_grey_q;
  logic centres_values_8_exists_q;
  logic centres_values_8_marks_seen_q;
  logic centres_values_8_marks_nearer_q;
  logic centres_values_9_firm_q;
  logic [5:0] centres_values_9_grey_q;
  logic centres_values_9_exists_q;
  logic centres_values_9_marks_seen_q;
  logic centres_values_9_marks_nearer_q;
  logic centres_values_10_firm_q;
  logic [5:0] centres_values_10_grey_q;
  logic centres_values_10_exists_q;
  logic centres_values_10_marks_seen_q;
  logic centres_values_10_marks_nearer_q;
  logic centres_values_11_firm_q;
  logic [5:0] centres_values_11_grey_q;
  logic centres_values_11_exists_q;
  logic centres_values_11_marks_seen_q;
  logic centres_values_11_marks_nearer_q;
  logic centres_values_12_firm_q;
  logic [5:0] centres_values_12_grey_q;
  logic centres_values_12_exists_q;
  logic centres_values_12_marks_seen_q;
  logic centres_values_12_marks_nearer_q;
  logic centres_values_13_firm_q;
  logic [5:0] centres_values_13_grey_q;
  logic centres_values_13_exists_q;
  logic centres_values_13_marks_seen_q;
  logic centres_values_13_marks_nearer_q;
  logic centres_values_14_firm_q;
  logic [5:0] centres_values_14_grey_q;
  logic centres_values_14_exists_q;
  logic centres_values_14_marks_seen_q;
  logic centres_values_14_marks_nearer_q;
  logic centres_values_15_firm_q;
  logic [5:0] centres_values_15_grey_q;
  logic centres_values_15_exists_q;
  logic centres_values_15_marks_seen_q;
  logic centres_values_15_marks_nearer_q;
  // hls/stages/spread.hpp:51
  logic [6:0] difference_213;
  assign difference_213 = {1'b0, grey_i} - {1'b0, last_grey_q};
  logic [5:0] xor_214;
  assign xor_214 = difference_213[5:0] ^ {6{difference_213[6]}};
  logic [6:0] difference;
  assign difference = {6'h0, difference_213[6]} + {1'b0, xor_214};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      last_vote_q <= 7'h0;
      last_grey_q <= 6'h0;
      last_exists_q <= 1'b0;
      first_values_0_left_q <= 7'h0;
      centres_values_0_firm_q <= 1'b0;
      centres_values_0_marks_seen_q <= 1'b0;
      centres_values_0_marks_nearer_q <= 1'b0;
      centres_values_1_firm_q <= 1'b0;
      centres_values_1_grey_q <= 6'h0;
      centres_values_1_exists_q <= 1'b0;
      centres_values_1_marks_seen_q <= 1'b0;
      centres_values_1_marks_nearer_q <= 1'b0;
      centres_values_2_firm_q <= 1'b0;
      centres_values_2_grey_q <= 6'h0;
      centres_values_2_exists_q <= 1'b0;
      centres_values_2_marks_seen_q <= 1'b0;
      centres_values_2_marks_nearer_q <= 1'b0;
      centres_values_3_firm_q <= 1'b0;
      centres_values_3_grey_q <= 6'h0;
      centres_values_3_exists_q <= 1'b0;
      centres_values_3_marks_seen_q <= 1'b0;
      centres_values_3_marks_nearer_q <= 1'b0;
      centres_values_4_firm_q <= 1'b0;
      centres_values_4_grey_q <= 6'h0;
      centres_values_4_exists_q <= 1'b0;
      centres_values_4_marks_seen_q <= 1'b0;
      centres_values_4_marks_nearer_q <= 1'b0;
      centres_values_5_firm_q <= 1'b0;
      centres_values_5_grey_q <= 6'h0;
      centres_values_5_exists_q <= 1'b0;
      centres_values_5_marks_seen_q <= 1'b0;
      centres_values_5_marks_nearer_q <= 1'b0;
      centres_values_6_firm_q <= 1'b0;
      centres_values_6_grey_q <= 6'h0;
      centres_values_6_exists_q <= 1'b0;
      centres_values_6_marks_seen_q <= 1'b0;
      centres_values_6_marks_nearer_q <= 1'b0;
      centres_values_7_firm_q <= 1'b0;
      centres_values_7_grey_q <= 6'h0;
      centres_values_7_exists_q <= 1'b0;
      centres_values_7_marks_seen_q <= 1'b0;
      centres_values_7_marks_nearer_q <= 1'b0;
      centres_values_8_firm_q <= 1'b0;
      centres_values_8_grey_q <= 6'h0;
      centres_values_8_exists_q <= 1'b0;
      centres_values_8_marks_seen_q <= 1'b0;
      centres_values_8_marks_nearer_q <= 1'b0;
      centres_values_9_firm_q <= 1'b0;
      centres_values_9_grey_q <= 6'h0;
      centres_values_9_exists_q <= 1'b0;
      centres_values_9_marks_seen_q <= 1'b0;
      centres_values_9_marks_nearer_q <= 1'b0;
      centres_values_10_firm_q <= 1'b0;
      centres_values_10_grey_q <= 6'h0;
      centres_values_10_exists_q <= 1'b0;
      centres_values_10_marks_seen_q <= 1'b0;
      centres_values_10_marks_nearer_q <= 1'b0;
      centres_values_11_firm_q <= 1'b0;
      centres_values_11_grey_q <= 6'h0;
      centres_values_11_exists_q <= 1'b0;
      centres_values_11_marks_seen_q <= 1'b0;
      centres_values_11_marks_nearer_q <= 1'b0;
      centres_values_12_firm_q <= 1'b0;
      centres_values_12_grey_q <= 6'h0;
      centres_values_12_exists_q <= 1'b0;
      centres_values_12_marks_seen_q <= 1'b0;
      centres_values_12_marks_nearer_q <= 1'b0;
      centres_values_13_firm_q <= 1'b0;
      centres_values_13_grey_q <= 6'h0;
      centres_values_13_exists_q <= 1'b0;
      centres_values_13_marks_seen_q <= 1'b0;
      centres_values_13_marks_nearer_q <= 1'b0;
      centres_values_14_firm_q <= 1'b0;
      centres_values_14_grey_q <= 6'h0;
      centres_values_14_exists_q <= 1'b0;
      centres_values_14_marks_seen_q <= 1'b0;
      centres_values_14_marks_nearer_q <= 1'b0;
      centres_values_15_firm_q <= 1'b0;
      centres_values_15_grey_q <= 6'h0;
      centres_values_15_exists_q <= 1'b0;
      centres_values_15_marks_seen_q <= 1'b0;
      centres_values_15_marks_nearer_q <= 1'b0;
    end else if (s0_en) begin
      last_vote_q <= $unsigned(vote_i);
      last_grey_q <= grey_i;
      last_exists_q <= exists_i;
      first_values_0_left_q <= last_vote_q;
      centres_values_0_firm_q <= firm_i;
      centres_values_0_marks_seen_q <= marks_seen_i;
      centres_values_0_marks_nearer_q <= marks_nearer_i;
      centres_values_1_firm_q <= centres_values_0_firm_q;
      centres_values_1_grey_q <= last_grey_q;
      centres_values_1_exists_q <= last_exists_q;
      centres_values_1_marks_seen_q <= centres_values_0_marks_seen_q;
      centres_values_1_marks_nearer_q <= centres_values_0_marks_nearer_q;
      centres_values_2_firm_q <= centres_values_1_firm_q;
      centres_values_2_grey_q <= centres_values_1_grey_q;
      centres_values_2_exists_q <= centres_values_1_exists_q;
      centres_values_2_marks_seen_q <= centres_values_1_marks_seen_q;
      centres_values_2_marks_nearer_q <= centres_values_1_marks_nearer_q;
      centres_values_3_firm_q <= centres_values_2_firm_q;
      centres_values_3_grey_q <= centres_values_2_grey_q;
      centres_values_3_exists_q <= centres_values_2_exists_q;
      centres_values_3_marks_seen_q <= centres_values_2_marks_seen_q;
      centres_values_3_marks_nearer_q <= centres_values_2_marks_nearer_q;
      centres_values_4_firm_q <= centres_values_3_firm_q;
      centres_values_4_grey_q <= centres_values_3_grey_q;
      centres_values_4_exists_q <= centres_values_3_exists_q;
      centres_values_4_marks_seen_q <= centres_values_3_marks_seen_q;
      centres_values_4_marks_nearer_q <= centres_values_3_marks_nearer_q;
      centres_values_5_firm_q <= centres_values_4_firm_q;
      centres_values_5_grey_q <= centres_values_4_grey_q;
      centres_values_5_exists_q <= centres_values_4_exists_q;
      centres_values_5_marks_seen_q <= centres_values_4_marks_seen_q;
      centres_values_5_marks_nearer_q <= centres_values_4_marks_nearer_q;
      centres_values_6_firm_q <= centres_values_5_firm_q;
      centres_values_6_grey_q <= centres_values_5_grey_q;
      centres_values_6_exists_q <= centres_values_5_exists_q;
      centres_values_6_marks_seen_q <= centres_values_5_marks_seen_q;
      centres_values_6_marks_nearer_q <= centres_values_5_marks_nearer_q;
      centres_values_7_firm_q <= centres_values_6_firm_q;
      centres_values_7_grey_q <= centres_values_6_grey_q;
      centres_values_7_exists_q <= centres_values_6_exists_q;
      centres_values_7_marks_seen_q <= centres_values_6_marks_seen_q;
      centres_values_7_marks_nearer_q <= centres_values_6_marks_nearer_q;
      centres_values_8_firm_q <= centres_values_7_firm_q;
      centres_values_8_grey_q <= centres_values_7_grey_q;
      centres_values_8_exists_q <= centres_values_7_exists_q;
      centres_values_8_marks_seen_q <= centres_values_7_marks_seen_q;
      centres_values_8_marks_nearer_q <= centres_values_7_marks_nearer_q;
      centres_values_9_firm_q <= centres_values_8_firm_q;
      centres_values_9_grey_q <= centres_values_8_grey_q;
      centres_values_9_exists_q <= centres_values_8_exists_q;
      centres_values_9_marks_seen_q <= centres_values_8_marks_seen_q;
      centres_values_9_marks_nearer_q <= centres_values_8_marks_nearer_q;
      centres_values_10_firm_q <= centres_values_9_firm_q;
      centres_values_10_grey_q <= centres_values_9_grey_q;
      centres_values_10_exists_q <= centres_values_9_exists_q;
      centres_values_10_marks_seen_q <= centres_values_9_marks_seen_q;
      centres_values_10_marks_nearer_q <= centres_values_9_marks_nearer_q;
      centres_values_11_firm_q <= centres_values_10_firm_q;
      centres_values_11_grey_q <= centres_values_10_grey_q;
      centres_values_11_exists_q <= centres_values_10_exists_q;
      centres_values_11_marks_seen_q <= centres_values_10_marks_seen_q;
      centres_values_11_marks_nearer_q <= centres_values_10_marks_nearer_q;
      centres_values_12_firm_q <= centres_values_11_firm_q;
      centres_values_12_grey_q <= centres_values_11_grey_q;
      centres_values_12_exists_q <= centres_values_11_exists_q;
      centres_values_12_marks_seen_q <= centres_values_11_marks_seen_q;
      centres_values_12_marks_nearer_q <= centres_values_11_marks_nearer_q;
      centres_values_13_firm_q <= centres_values_12_firm_q;
      centres_values_13_grey_q <= centres_values_12_grey_q;
      centres_values_13_exists_q <= centres_values_12_exists_q;
      centres_values_13_marks_seen_q <= centres_values_12_marks_seen_q;
      centres_values_13_marks_nearer_q <= centres_values_12_marks_nearer_q;
      centres_values_14_firm_q <= centres_values_13_firm_q;
      centres_values_14_grey_q <= centres_values_13_grey_q;
      centres_values_14_exists_q <= centres_values_13_exists_q;
      centres_values_14_marks_seen_q <= centres_values_13_marks_seen_q;
      centres_values_14_marks_nearer_q <= centres_values_13_marks_nearer_q;
      centres_values_15_firm_q <= centres_values_14_firm_q;
      centres_values_15_grey_q <= centres_values_14_grey_q;
      centres_values_15_exists_q <= centres_values_14_exists_q;
      centres_values_15_marks_seen_q <= centres_values_14_marks_seen_q;
      centres_values_15_marks_nearer_q <= centres_values_14_marks_nearer_q;
    end
  end

  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic [6:0] first_values_0_left_s1_q;
  logic centres_values_15_firm_s1_q;
  logic [5:0] centres_values_15_grey_s1_q;
  logic centres_values_15_exists_s1_q;
  logic centres_values_15_marks_seen_s1_q;
  logic centres_values_15_marks_nearer_s1_q;
  logic [6:0] difference_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      first_values_0_left_s1_q <= first_values_0_left_q;
      centres_values_15_firm_s1_q <= centres_values_15_firm_q;
      centres_values_15_grey_s1_q <= centres_values_15_grey_q;
      centres_values_15_exists_s1_q <= centres_values_15_exists_q;
      centres_values_15_marks_seen_s1_q <= centres_values_15_marks_seen_q;
      centres_values_15_marks_nearer_s1_q <= centres_values_15_marks_nearer_q;
      difference_s1_q <= difference;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic centres_values_0_marks_first_q;
  logic centres_values_1_marks_first_q;
  logic centres_values_2_marks_first_q;
  logic centres_values_3_marks_first_q;
  logic centres_values_4_marks_first_q;
  logic centres_values_5_marks_first_q;
  logic centres_values_6_marks_first_q;
  logic centres_values_7_marks_first_q;
  logic centres_values_8_marks_first_q;
  logic centres_values_9_marks_first_q;
  logic centres_values_10_marks_first_q;
  logic centres_values_11_marks_first_q;
  logic centres_values_12_marks_first_q;
  logic centres_values_13_marks_first_q;
  logic centres_values_14_marks_first_q;
  logic centres_values_15_marks_first_q;
  // hls/stages/spread.hpp:51
  logic and_218;
  assign and_218 = centres_values_1_exists_q & (~({4'h0, cfg_smooth_i} < difference_s1_q));
  // hls/stages/spread.hpp:86
  logic [7:0] difference_224;
  assign difference_224 = {first_values_0_left_q[6], first_values_0_left_q} - {{5{first_values_0_left_q[6]}}, first_values_0_left_q[6:4]};
  // hls/stages/spread.hpp:101
  logic [8:0] sum_225;
  assign sum_225 = {{2{first_values_0_left_s1_q[6]}}, first_values_0_left_s1_q} + {difference_224[7], difference_224};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      centres_values_0_marks_first_q <= 1'b0;
      centres_values_1_marks_first_q <= 1'b0;
      centres_values_2_marks_first_q <= 1'b0;
      centres_values_3_marks_first_q <= 1'b0;
      centres_values_4_marks_first_q <= 1'b0;
      centres_values_5_marks_first_q <= 1'b0;
      centres_values_6_marks_first_q <= 1'b0;
      centres_values_7_marks_first_q <= 1'b0;
      centres_values_8_marks_first_q <= 1'b0;
      centres_values_9_marks_first_q <= 1'b0;
      centres_values_10_marks_first_q <= 1'b0;
      centres_values_11_marks_first_q <= 1'b0;
      centres_values_12_marks_first_q <= 1'b0;
      centres_values_13_marks_first_q <= 1'b0;
      centres_values_14_marks_first_q <= 1'b0;
      centres_values_15_marks_first_q <= 1'b0;
    end else if (s1_en) begin
      centres_values_0_marks_first_q <= marks_first_s1_q;
      centres_values_1_marks_first_q <= centres_values_0_marks_first_q;
      centres_values_2_marks_first_q <= centres_values_1_marks_first_q;
      centres_values_3_marks_first_q <= centres_values_2_marks_first_q;
      centres_values_4_marks_first_q <= centres_values_3_marks_first_q;
      centres_values_5_marks_first_q <= centres_values_4_marks_first_q;
      centres_values_6_marks_first_q <= centres_values_5_marks_first_q;
      centres_values_7_marks_first_q <= centres_values_6_marks_first_q;
      centres_values_8_marks_first_q <= centres_values_7_marks_first_q;
      centres_values_9_marks_first_q <= centres_values_8_marks_first_q;
      centres_values_10_marks_first_q <= centres_values_9_marks_first_q;
      centres_values_11_marks_first_q <= centres_values_10_marks_first_q;
      centres_values_12_marks_first_q <= centres_values_11_marks_first_q;
      centres_values_13_marks_first_q <= centres_values_12_marks_first_q;
      centres_values_14_marks_first_q <= centres_values_13_marks_first_q;
      centres_values_15_marks_first_q <= centres_values_14_marks_first_q;
    end
  end

  logic marks_last_s2_q;
  logic [6:0] first_values_0_left_s2_q;
  logic centres_values_15_firm_s2_q;
  logic [5:0] centres_values_15_grey_s2_q;
  logic centres_values_15_exists_s2_q;
  logic centres_values_15_marks_first_s2_q;
  logic centres_values_15_marks_seen_s2_q;
  logic centres_values_15_marks_nearer_s2_q;
  logic and_219_s2_q;
  logic [8:0] sum_225_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_last_s2_q <= marks_last_s1_q;
      first_values_0_left_s2_q <= first_values_0_left_s1_q;
      centres_values_15_firm_s2_q <= centres_values_15_firm_s1_q;
      centres_values_15_grey_s2_q <= centres_values_15_grey_s1_q;
      centres_values_15_exists_s2_q <= centres_values_15_exists_s1_q;
      centres_values_15_marks_first_s2_q <= centres_values_15_marks_first_q;
      centres_values_15_marks_seen_s2_q <= centres_values_15_marks_seen_s1_q;
      centres_values_15_marks_nearer_s2_q <= centres_values_15_marks_nearer_s1_q;
      and_219_s2_q <= last_exists_q & and_218;
      sum_225_s2_q <= sum_225;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic row_ended_q;
  logic first_values_0_joined_q;
  logic [6:0] first_values_1_left_q;
  logic first_values_1_joined_q;
  logic [8:0] second_values_0_right_q;
  logic [8:0] second_values_1_right_q;
  logic centres_values_0_marks_last_q;
  logic centres_values_1_marks_last_q;
  logic centres_values_2_marks_last_q;
  logic [6:0] centres_values_3_vote_q;
  logic centres_values_3_marks_last_q;
  logic [6:0] centres_values_4_vote_q;
  logic centres_values_4_marks_last_q;
  logic [6:0] centres_values_5_vote_q;
  logic centres_values_5_marks_last_q;
  logic [6:0] centres_values_6_vote_q;
  logic centres_values_6_marks_last_q;
  logic [6:0] centres_values_7_vote_q;
  logic centres_values_7_marks_last_q;
  logic [6:0] centres_values_8_vote_q;
  logic centres_values_8_marks_last_q;
  logic [6:0] centres_values_9_vote_q;
  logic centres_values_9_marks_last_q;
  logic [6:0] centres_values_10_vote_q;
  logic centres_values_10_marks_last_q;
  logic [6:0] centres_values_11_vote_q;
  logic centres_values_11_marks_last_q;
  logic [6:0] centres_values_12_vote_q;
  logic centres_values_12_marks_last_q;
  logic [6:0] centres_values_13_vote_q;
  logic centres_values_13_marks_last_q;
  logic [6:0] centres_values_14_vote_q;
  logic centres_values_14_marks_last_q;
  logic [6:0] centres_values_15_vote_q;
  logic centres_values_15_marks_last_q;
  // hls/stages/spread.hpp:51
  logic joined;
  assign joined = (~(centres_values_0_marks_first_q | row_ended_q)) & and_219_s2_q;
  // hls/stages/spread.hpp:86
  logic [7:0] difference_221;
  assign difference_221 = {first_values_1_left_q[6], first_values_1_left_q} - {{5{first_values_1_left_q[6]}}, first_values_1_left_q[6:4]};
  // hls/stages/spread.hpp:101
  logic [8:0] value;
  assign value = first_values_0_joined_q ? sum_225_s2_q : {{2{first_values_0_left_s2_q[6]}}, first_values_0_left_s2_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_ended_q <= 1'b1;
      first_values_0_joined_q <= 1'b0;
      first_values_1_left_q <= 7'h0;
      first_values_1_joined_q <= 1'b0;
      second_values_0_right_q <= 9'h0;
      second_values_1_right_q <= 9'h0;
      centres_values_0_marks_last_q <= 1'b0;
      centres_values_1_marks_last_q <= 1'b0;
      centres_values_2_marks_last_q <= 1'b0;
      centres_values_3_vote_q <= 7'h0;
      centres_values_3_marks_last_q <= 1'b0;
      centres_values_4_vote_q <= 7'h0;
      centres_values_4_marks_last_q <= 1'b0;
      centres_values_5_vote_q <= 7'h0;
      centres_values_5_marks_last_q <= 1'b0;
      centres_values_6_vote_q <= 7'h0;
      centres_values_6_marks_last_q <= 1'b0;
      centres_values_7_vote_q <= 7'h0;
      centres_values_7_marks_last_q <= 1'b0;
      centres_values_8_vote_q <= 7'h0;
      centres_values_8_marks_last_q <= 1'b0;
      centres_values_9_vote_q <= 7'h0;
      centres_values_9_marks_last_q <= 1'b0;
      centres_values_10_vote_q <= 7'h0;
      centres_values_10_marks_last_q <= 1'b0;
      centres_values_11_vote_q <= 7'h0;
      centres_values_11_marks_last_q <= 1'b0;
      centres_values_12_vote_q <= 7'h0;
      centres_values_12_marks_last_q <= 1'b0;
      centres_values_13_vote_q <= 7'h0;
      centres_values_13_marks_last_q <= 1'b0;
      centres_values_14_vote_q <= 7'h0;
      centres_values_14_marks_last_q <= 1'b0;
      centres_values_15_vote_q <= 7'h0;
      centres_values_15_marks_last_q <= 1'b0;
    end else if (s2_en) begin
      row_ended_q <= marks_last_s2_q;
      first_values_0_joined_q <= joined;
      first_values_1_left_q <= first_values_0_left_s2_q;
      first_values_1_joined_q <= first_values_0_joined_q;
      second_values_0_right_q <= value;
      second_values_1_right_q <= second_values_0_right_q;
      centres_values_0_marks_last_q <= marks_last_s2_q;
      centres_values_1_marks_last_q <= centres_values_0_marks_last_q;
      centres_values_2_marks_last_q <= centres_values_1_marks_last_q;
      centres_values_3_vote_q <= first_values_1_left_q;
      centres_values_3_marks_last_q <= centres_values_2_marks_last_q;
      centres_values_4_vote_q <= centres_values_3_vote_q;
      centres_values_4_marks_last_q <= centres_values_3_marks_last_q;
      centres_values_5_vote_q <= centres_values_4_vote_q;
      centres_values_5_marks_last_q <= centres_values_4_marks_last_q;
      centres_values_6_vote_q <= centres_values_5_vote_q;
      centres_values_6_marks_last_q <= centres_values_5_marks_last_q;
      centres_values_7_vote_q <= centres_values_6_vote_q;
      centres_values_7_marks_last_q <= centres_values_6_marks_last_q;
      centres_values_8_vote_q <= centres_values_7_vote_q;
      centres_values_8_marks_last_q <= centres_values_7_marks_last_q;
      centres_values_9_vote_q <= centres_values_8_vote_q;
      centres_values_9_marks_last_q <= centres_values_8_marks_last_q;
      centres_values_10_vote_q <= centres_values_9_vote_q;
      centres_values_10_marks_last_q <= centres_values_9_marks_last_q;
      centres_values_11_vote_q <= centres_values_10_vote_q;
      centres_values_11_marks_last_q <= centres_values_10_marks_last_q;
      centres_values_12_vote_q <= centres_values_11_vote_q;
      centres_values_12_marks_last_q <= centres_values_11_marks_last_q;
      centres_values_13_vote_q <= centres_values_12_vote_q;
      centres_values_13_marks_last_q <= centres_values_12_marks_last_q;
      centres_values_14_vote_q <= centres_values_13_vote_q;
      centres_values_14_marks_last_q <= centres_values_13_marks_last_q;
      centres_values_15_vote_q <= centres_values_14_vote_q;
      centres_values_15_marks_last_q <= centres_values_14_marks_last_q;
    end
  end

  logic first_values_1_joined_s3_q;
  logic [8:0] second_values_1_right_s3_q;
  logic [6:0] centres_values_15_vote_s3_q;
  logic centres_values_15_firm_s3_q;
  logic [5:0] centres_values_15_grey_s3_q;
  logic centres_values_15_exists_s3_q;
  logic centres_values_15_marks_first_s3_q;
  logic centres_values_15_marks_last_s3_q;
  logic centres_values_15_marks_seen_s3_q;
  logic centres_values_15_marks_nearer_s3_q;
  logic [7:0] difference_221_s3_q;
  logic [9:0] difference_231_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_values_1_joined_s3_q <= first_values_1_joined_q;
      second_values_1_right_s3_q <= second_values_1_right_q;
      centres_values_15_vote_s3_q <= centres_values_15_vote_q;
      centres_values_15_firm_s3_q <= centres_values_15_firm_s2_q;
      centres_values_15_grey_s3_q <= centres_values_15_grey_s2_q;
      centres_values_15_exists_s3_q <= centres_values_15_exists_s2_q;
      centres_values_15_marks_first_s3_q <= centres_values_15_marks_first_s2_q;
      centres_values_15_marks_last_s3_q <= centres_values_15_marks_last_q;
      centres_values_15_marks_seen_s3_q <= centres_values_15_marks_seen_s2_q;
      centres_values_15_marks_nearer_s3_q <= centres_values_15_marks_nearer_s2_q;
      difference_221_s3_q <= difference_221;
      difference_231_s3_q <= {value[8], value} - {{4{value[8]}}, value[8:3]};
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [8:0] second_values_0_left_q;
  logic second_values_0_joined_q;
  logic [8:0] second_values_1_left_q;
  logic second_values_1_joined_q;
  logic [8:0] second_values_2_left_q;
  logic second_values_2_joined_q;
  logic [8:0] second_values_3_left_q;
  logic second_values_3_joined_q;
  logic [10:0] third_values_0_right_q;
  logic [10:0] third_values_1_right_q;
  logic [10:0] third_values_2_right_q;
  logic [10:0] third_values_3_right_q;
  // hls/stages/spread.hpp:100
  logic [8:0] sum_222;
  assign sum_222 = {{2{first_values_1_left_q[6]}}, first_values_1_left_q} + {difference_221_s3_q[7], difference_221_s3_q};
  logic [8:0] select_223;
  assign select_223 = first_values_1_joined_s3_q ? sum_222 : {{2{first_values_1_left_q[6]}}, first_values_1_left_q};
  // hls/stages/spread.hpp:87
  logic [9:0] difference_228;
  assign difference_228 = {second_values_3_left_q[8], second_values_3_left_q} - {{4{second_values_3_left_q[8]}}, second_values_3_left_q[8:3]};
  // hls/stages/spread.hpp:101
  logic [10:0] sum_232;
  assign sum_232 = {{2{second_values_1_right_s3_q[8]}}, second_values_1_right_s3_q} + {difference_231_s3_q[9], difference_231_s3_q};
  logic [10:0] value_2;
  assign value_2 = second_values_1_joined_q ? sum_232 : {{2{second_values_1_right_s3_q[8]}}, second_values_1_right_s3_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      second_values_0_left_q <= 9'h0;
      second_values_0_joined_q <= 1'b0;
      second_values_1_left_q <= 9'h0;
      second_values_1_joined_q <= 1'b0;
      second_values_2_left_q <= 9'h0;
      second_values_2_joined_q <= 1'b0;
      second_values_3_left_q <= 9'h0;
      second_values_3_joined_q <= 1'b0;
      third_values_0_right_q <= 11'h0;
      third_values_1_right_q <= 11'h0;
      third_values_2_right_q <= 11'h0;
      third_values_3_right_q <= 11'h0;
    end else if (s3_en) begin
      second_values_0_left_q <= select_223;
      second_values_0_joined_q <= first_values_1_joined_q & first_values_0_joined_q;
      second_values_1_left_q <= second_values_0_left_q;
      second_values_1_joined_q <= second_values_0_joined_q;
      second_values_2_left_q <= second_values_1_left_q;
      second_values_2_joined_q <= second_values_1_joined_q;
      second_values_3_left_q <= second_values_2_left_q;
      second_values_3_joined_q <= second_values_2_joined_q;
      third_values_0_right_q <= value_2;
      third_values_1_right_q <= third_values_0_right_q;
      third_values_2_right_q <= third_values_1_right_q;
      third_values_3_right_q <= third_values_2_right_q;
    end
  end

  logic second_values_3_joined_s4_q;
  logic [10:0] third_values_3_right_s4_q;
  logic [6:0] centres_values_15_vote_s4_q;
  logic centres_values_15_firm_s4_q;
  logic [5:0] centres_values_15_grey_s4_q;
  logic centres_values_15_exists_s4_q;
  logic centres_values_15_marks_first_s4_q;
  logic centres_values_15_marks_last_s4_q;
  logic centres_values_15_marks_seen_s4_q;
  logic centres_values_15_marks_nearer_s4_q;
  logic [9:0] difference_228_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      second_values_3_joined_s4_q <= second_values_3_joined_q;
      third_values_3_right_s4_q <= third_values_3_right_q;
      centres_values_15_vote_s4_q <= centres_values_15_vote_s3_q;
      centres_values_15_firm_s4_q <= centres_values_15_firm_s3_q;
      centres_values_15_grey_s4_q <= centres_values_15_grey_s3_q;
      centres_values_15_exists_s4_q <= centres_values_15_exists_s3_q;
      centres_values_15_marks_first_s4_q <= centres_values_15_marks_first_s3_q;
      centres_values_15_marks_last_s4_q <= centres_values_15_marks_last_s3_q;
      centres_values_15_marks_seen_s4_q <= centres_values_15_marks_seen_s3_q;
      centres_values_15_marks_nearer_s4_q <= centres_values_15_marks_nearer_s3_q;
      difference_228_s4_q <= difference_228;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [10:0] third_values_0_left_q;
  logic [10:0] third_values_1_left_q;
  logic [10:0] third_values_2_left_q;
  logic [10:0] third_values_3_left_q;
  logic [10:0] third_values_4_left_q;
  logic [10:0] third_values_5_left_q;
  logic [10:0] third_values_6_left_q;
  logic [10:0] third_values_7_left_q;
  // hls/stages/spread.hpp:100
  logic [10:0] sum_229;
  assign sum_229 = {{2{second_values_2_left_q[8]}}, second_values_2_left_q} + {difference_228_s4_q[9], difference_228_s4_q};
  logic [10:0] select_230;
  assign select_230 = second_values_3_joined_s4_q ? sum_229 : {{2{second_values_2_left_q[8]}}, second_values_2_left_q};
  // hls/stages/spread.hpp:88
  logic [10:0] difference_235;
  assign difference_235 = third_values_7_left_q - {{2{third_values_7_left_q[10]}}, third_values_7_left_q[10:2]};
  logic [10:0] difference_238;
  assign difference_238 = third_values_0_right_q - {{2{third_values_0_right_q[10]}}, third_values_0_right_q[10:2]};

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
    end else if (s4_en) begin
      third_values_0_left_q <= select_230;
      third_values_1_left_q <= third_values_0_left_q;
      third_values_2_left_q <= third_values_1_left_q;
      third_values_3_left_q <= third_values_2_left_q;
      third_values_4_left_q <= third_values_3_left_q;
      third_values_5_left_q <= third_values_4_left_q;
      third_values_6_left_q <= third_values_5_left_q;
      third_values_7_left_q <= third_values_6_left_q;
    end
  end

  logic [10:0] third_values_3_right_s5_q;
  logic [6:0] centres_values_15_vote_s5_q;
  logic centres_values_15_firm_s5_q;
  logic [5:0] centres_values_15_grey_s5_q;
  logic centres_values_15_exists_s5_q;
  logic centres_values_15_marks_first_s5_q;
  logic centres_values_15_marks_last_s5_q;
  logic centres_values_15_marks_seen_s5_q;
  logic centres_values_15_marks_nearer_s5_q;
  logic and_234_s5_q;
  logic [10:0] sum_236_s5_q;
  logic [10:0] sum_239_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      third_values_3_right_s5_q <= third_values_3_right_s4_q;
      centres_values_15_vote_s5_q <= centres_values_15_vote_s4_q;
      centres_values_15_firm_s5_q <= centres_values_15_firm_s4_q;
      centres_values_15_grey_s5_q <= centres_values_15_grey_s4_q;
      centres_values_15_exists_s5_q <= centres_values_15_exists_s4_q;
      centres_values_15_marks_first_s5_q <= centres_values_15_marks_first_s4_q;
      centres_values_15_marks_last_s5_q <= centres_values_15_marks_last_s4_q;
      centres_values_15_marks_seen_s5_q <= centres_values_15_marks_seen_s4_q;
      centres_values_15_marks_nearer_s5_q <= centres_values_15_marks_nearer_s4_q;
      and_234_s5_q <= second_values_2_joined_q & second_values_0_joined_q;
      sum_236_s5_q <= third_values_3_left_q + difference_235;
      sum_239_s5_q <= third_values_3_right_s4_q + difference_238;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic third_values_0_joined_q;
  logic third_values_1_joined_q;
  logic third_values_2_joined_q;
  logic third_values_3_joined_q;
  logic third_values_4_joined_q;
  logic third_values_5_joined_q;
  logic third_values_6_joined_q;
  logic third_values_7_joined_q;
  logic [10:0] fourth_values_0_left_q;
  logic [10:0] fourth_values_0_right_q;
  logic [10:0] fourth_values_1_left_q;
  logic [10:0] fourth_values_1_right_q;
  logic [10:0] fourth_values_2_left_q;
  logic [10:0] fourth_values_2_right_q;
  logic [10:0] fourth_values_3_left_q;
  logic [10:0] fourth_values_3_right_q;
  logic [10:0] fourth_values_4_left_q;
  logic [10:0] fourth_values_4_right_q;
  logic [10:0] fourth_values_5_left_q;
  logic [10:0] fourth_values_5_right_q;
  logic [10:0] fourth_values_6_left_q;
  logic [10:0] fourth_values_6_right_q;
  logic [10:0] fourth_values_7_left_q;
  logic [10:0] fourth_values_7_right_q;
  logic [10:0] fourth_values_8_left_q;
  logic [10:0] fourth_values_9_left_q;
  logic [10:0] fourth_values_10_left_q;
  logic [10:0] fourth_values_11_left_q;
  logic [10:0] fourth_values_12_left_q;
  logic [10:0] fourth_values_13_left_q;
  logic [10:0] fourth_values_14_left_q;
  logic [10:0] fourth_values_15_left_q;
  // hls/stages/spread.hpp:101
  logic [10:0] value_3;
  assign value_3 = third_values_3_joined_q ? sum_239_s5_q : third_values_3_right_s5_q;
  // hls/stages/spread.hpp:89
  logic [10:0] difference_242;
  assign difference_242 = fourth_values_15_left_q - {fourth_values_15_left_q[10], fourth_values_15_left_q[10:1]};
  logic [10:0] sum_243;
  assign sum_243 = {{3{fourth_values_15_left_q[10]}}, fourth_values_15_left_q[10:3]} + difference_242;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      third_values_0_joined_q <= 1'b0;
      third_values_1_joined_q <= 1'b0;
      third_values_2_joined_q <= 1'b0;
      third_values_3_joined_q <= 1'b0;
      third_values_4_joined_q <= 1'b0;
      third_values_5_joined_q <= 1'b0;
      third_values_6_joined_q <= 1'b0;
      third_values_7_joined_q <= 1'b0;
      fourth_values_0_left_q <= 11'h0;
      fourth_values_0_right_q <= 11'h0;
      fourth_values_1_left_q <= 11'h0;
      fourth_values_1_right_q <= 11'h0;
      fourth_values_2_left_q <= 11'h0;
      fourth_values_2_right_q <= 11'h0;
      fourth_values_3_left_q <= 11'h0;
      fourth_values_3_right_q <= 11'h0;
      fourth_values_4_left_q <= 11'h0;
      fourth_values_4_right_q <= 11'h0;
      fourth_values_5_left_q <= 11'h0;
      fourth_values_5_right_q <= 11'h0;
      fourth_values_6_left_q <= 11'h0;
      fourth_values_6_right_q <= 11'h0;
      fourth_values_7_left_q <= 11'h0;
      fourth_values_7_right_q <= 11'h0;
      fourth_values_8_left_q <= 11'h0;
      fourth_values_9_left_q <= 11'h0;
      fourth_values_10_left_q <= 11'h0;
      fourth_values_11_left_q <= 11'h0;
      fourth_values_12_left_q <= 11'h0;
      fourth_values_13_left_q <= 11'h0;
      fourth_values_14_left_q <= 11'h0;
      fourth_values_15_left_q <= 11'h0;
    end else if (s5_en) begin
      third_values_0_joined_q <= and_234_s5_q;
      third_values_1_joined_q <= third_values_0_joined_q;
      third_values_2_joined_q <= third_values_1_joined_q;
      third_values_3_joined_q <= third_values_2_joined_q;
      third_values_4_joined_q <= third_values_3_joined_q;
      third_values_5_joined_q <= third_values_4_joined_q;
      third_values_6_joined_q <= third_values_5_joined_q;
      third_values_7_joined_q <= third_values_6_joined_q;
      fourth_values_0_left_q <= third_values_7_joined_q ? sum_236_s5_q : third_values_4_left_q;
      fourth_values_0_right_q <= value_3;
      fourth_values_1_left_q <= fourth_values_0_left_q;
      fourth_values_1_right_q <= fourth_values_0_right_q;
      fourth_values_2_left_q <= fourth_values_1_left_q;
      fourth_values_2_right_q <= fourth_values_1_right_q;
      fourth_values_3_left_q <= fourth_values_2_left_q;
      fourth_values_3_right_q <= fourth_values_2_right_q;
      fourth_values_4_left_q <= fourth_values_3_left_q;
      fourth_values_4_right_q <= fourth_values_3_right_q;
      fourth_values_5_left_q <= fourth_values_4_left_q;
      fourth_values_5_right_q <= fourth_values_4_right_q;
      fourth_values_6_left_q <= fourth_values_5_left_q;
      fourth_values_6_right_q <= fourth_values_5_right_q;
      fourth_values_7_left_q <= fourth_values_6_left_q;
      fourth_values_7_right_q <= fourth_values_6_right_q;
      fourth_values_8_left_q <= fourth_values_7_left_q;
      fourth_values_9_left_q <= fourth_values_8_left_q;
      fourth_values_10_left_q <= fourth_values_9_left_q;
      fourth_values_11_left_q <= fourth_values_10_left_q;
      fourth_values_12_left_q <= fourth_values_11_left_q;
      fourth_values_13_left_q <= fourth_values_12_left_q;
      fourth_values_14_left_q <= fourth_values_13_left_q;
      fourth_values_15_left_q <= fourth_values_14_left_q;
    end
  end

  logic [10:0] fourth_values_7_right_s6_q;
  logic [6:0] centres_values_15_vote_s6_q;
  logic centres_values_15_firm_s6_q;
  logic [5:0] centres_values_15_grey_s6_q;
  logic centres_values_15_exists_s6_q;
  logic centres_values_15_marks_first_s6_q;
  logic centres_values_15_marks_last_s6_q;
  logic centres_values_15_marks_seen_s6_q;
  logic centres_values_15_marks_nearer_s6_q;
  logic [10:0] sum_243_s6_q;
  logic [10:0] difference_246_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      fourth_values_7_right_s6_q <= fourth_values_7_right_q;
      centres_values_15_vote_s6_q <= centres_values_15_vote_s5_q;
      centres_values_15_firm_s6_q <= centres_values_15_firm_s5_q;
      centres_values_15_grey_s6_q <= centres_values_15_grey_s5_q;
      centres_values_15_exists_s6_q <= centres_values_15_exists_s5_q;
      centres_values_15_marks_first_s6_q <= centres_values_15_marks_first_s5_q;
      centres_values_15_marks_last_s6_q <= centres_values_15_marks_last_s5_q;
      centres_values_15_marks_seen_s6_q <= centres_values_15_marks_seen_s5_q;
      centres_values_15_marks_nearer_s6_q <= centres_values_15_marks_nearer_s5_q;
      sum_243_s6_q <= sum_243;
      difference_246_s6_q <= value_3 - {value_3[10], value_3[10:1]};
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic fourth_values_0_joined_q;
  logic fourth_values_1_joined_q;
  logic fourth_values_2_joined_q;
  logic fourth_values_3_joined_q;
  logic fourth_values_4_joined_q;
  logic fourth_values_5_joined_q;
  logic fourth_values_6_joined_q;
  logic fourth_values_7_joined_q;
  logic fourth_values_8_joined_q;
  logic fourth_values_9_joined_q;
  logic fourth_values_10_joined_q;
  logic fourth_values_11_joined_q;
  logic fourth_values_12_joined_q;
  logic fourth_values_13_joined_q;
  logic fourth_values_14_joined_q;
  logic fourth_values_15_joined_q;
  // hls/stages/spread.hpp:100
  logic [10:0] select_245;
  assign select_245 = fourth_values_15_joined_q ? (fourth_values_8_left_q + sum_243_s6_q) : fourth_values_8_left_q;
  // hls/stages/spread.hpp:89
  logic [10:0] sum_247;
  assign sum_247 = {{3{fourth_values_0_right_q[10]}}, fourth_values_0_right_q[10:3]} + difference_246_s6_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fourth_values_0_joined_q <= 1'b0;
      fourth_values_1_joined_q <= 1'b0;
      fourth_values_2_joined_q <= 1'b0;
      fourth_values_3_joined_q <= 1'b0;
      fourth_values_4_joined_q <= 1'b0;
      fourth_values_5_joined_q <= 1'b0;
      fourth_values_6_joined_q <= 1'b0;
      fourth_values_7_joined_q <= 1'b0;
      fourth_values_8_joined_q <= 1'b0;
      fourth_values_9_joined_q <= 1'b0;
      fourth_values_10_joined_q <= 1'b0;
      fourth_values_11_joined_q <= 1'b0;
      fourth_values_12_joined_q <= 1'b0;
      fourth_values_13_joined_q <= 1'b0;
      fourth_values_14_joined_q <= 1'b0;
      fourth_values_15_joined_q <= 1'b0;
    end else if (s6_en) begin
      fourth_values_0_joined_q <= third_values_4_joined_q & third_values_0_joined_q;
      fourth_values_1_joined_q <= fourth_values_0_joined_q;
      fourth_values_2_joined_q <= fourth_values_1_joined_q;
      fourth_values_3_joined_q <= fourth_values_2_joined_q;
      fourth_values_4_joined_q <= fourth_values_3_joined_q;
      fourth_values_5_joined_q <= fourth_values_4_joined_q;
      fourth_values_6_joined_q <= fourth_values_5_joined_q;
      fourth_values_7_joined_q <= fourth_values_6_joined_q;
      fourth_values_8_joined_q <= fourth_values_7_joined_q;
      fourth_values_9_joined_q <= fourth_values_8_joined_q;
      fourth_values_10_joined_q <= fourth_values_9_joined_q;
      fourth_values_11_joined_q <= fourth_values_10_joined_q;
      fourth_values_12_joined_q <= fourth_values_11_joined_q;
      fourth_values_13_joined_q <= fourth_values_12_joined_q;
      fourth_values_14_joined_q <= fourth_values_13_joined_q;
      fourth_values_15_joined_q <= fourth_values_14_joined_q;
    end
  end

  logic [10:0] fourth_values_7_right_s7_q;
  logic [6:0] centres_values_15_vote_s7_q;
  logic centres_values_15_firm_s7_q;
  logic [5:0] centres_values_15_grey_s7_q;
  logic centres_values_15_exists_s7_q;
  logic centres_values_15_marks_first_s7_q;
  logic centres_values_15_marks_last_s7_q;
  logic centres_values_15_marks_seen_s7_q;
  logic centres_values_15_marks_nearer_s7_q;
  logic [10:0] select_245_s7_q;
  logic [10:0] sum_248_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      fourth_values_7_right_s7_q <= fourth_values_7_right_s6_q;
      centres_values_15_vote_s7_q <= centres_values_15_vote_s6_q;
      centres_values_15_firm_s7_q <= centres_values_15_firm_s6_q;
      centres_values_15_grey_s7_q <= centres_values_15_grey_s6_q;
      centres_values_15_exists_s7_q <= centres_values_15_exists_s6_q;
      centres_values_15_marks_first_s7_q <= centres_values_15_marks_first_s6_q;
      centres_values_15_marks_last_s7_q <= centres_values_15_marks_last_s6_q;
      centres_values_15_marks_seen_s7_q <= centres_values_15_marks_seen_s6_q;
      centres_values_15_marks_nearer_s7_q <= centres_values_15_marks_nearer_s6_q;
      select_245_s7_q <= select_245;
      sum_248_s7_q <= fourth_values_7_right_s6_q + sum_247;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/spread.hpp:101
  logic [10:0] select_249;
  assign select_249 = fourth_values_8_joined_q ? sum_248_s7_q : fourth_values_7_right_s7_q;
  // hls/stages/spread.hpp:63
  logic [11:0] sum_250;
  assign sum_250 = {select_245_s7_q[10], select_245_s7_q} + {select_249[10], select_249};

  logic [6:0] centres_values_15_vote_s8_q;
  logic centres_values_15_firm_s8_q;
  logic [5:0] centres_values_15_grey_s8_q;
  logic centres_values_15_exists_s8_q;
  logic centres_values_15_marks_first_s8_q;
  logic centres_values_15_marks_last_s8_q;
  logic centres_values_15_marks_seen_s8_q;
  logic centres_values_15_marks_nearer_s8_q;
  logic [11:0] sum_250_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      centres_values_15_vote_s8_q <= centres_values_15_vote_s7_q;
      centres_values_15_firm_s8_q <= centres_values_15_firm_s7_q;
      centres_values_15_grey_s8_q <= centres_values_15_grey_s7_q;
      centres_values_15_exists_s8_q <= centres_values_15_exists_s7_q;
      centres_values_15_marks_first_s8_q <= centres_values_15_marks_first_s7_q;
      centres_values_15_marks_last_s8_q <= centres_values_15_marks_last_s7_q;
      centres_values_15_marks_seen_s8_q <= centres_values_15_marks_seen_s7_q;
      centres_values_15_marks_nearer_s8_q <= centres_values_15_marks_nearer_s7_q;
      sum_250_s8_q <= sum_250;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/spread.hpp:63
  logic [11:0] difference_251;
  assign difference_251 = sum_250_s8_q - {{5{centres_values_15_vote_s8_q[6]}}, centres_values_15_vote_s8_q};

  logic centres_values_15_firm_s9_q;
  logic [5:0] centres_values_15_grey_s9_q;
  logic centres_values_15_exists_s9_q;
  logic centres_values_15_marks_first_s9_q;
  logic centres_values_15_marks_last_s9_q;
  logic centres_values_15_marks_seen_s9_q;
  logic centres_values_15_marks_nearer_s9_q;
  logic [9:0] difference_251_s9_q;
  logic less_252_s9_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      centres_values_15_firm_s9_q <= centres_values_15_firm_s8_q;
      centres_values_15_grey_s9_q <= centres_values_15_grey_s8_q;
      centres_values_15_exists_s9_q <= centres_values_15_exists_s8_q;
      centres_values_15_marks_first_s9_q <= centres_values_15_marks_first_s8_q;
      centres_values_15_marks_last_s9_q <= centres_values_15_marks_last_s8_q;
      centres_values_15_marks_seen_s9_q <= centres_values_15_marks_seen_s8_q;
      centres_values_15_marks_nearer_s9_q <= centres_values_15_marks_nearer_s8_q;
      difference_251_s9_q <= difference_251[11:2];
      less_252_s9_q <= $signed(difference_251[11:2]) < $signed(10'h381);
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/spread.hpp:66
  logic [9:0] select_253;
  assign select_253 = less_252_s9_q ? 10'h381 : difference_251_s9_q;
  logic [7:0] select_255;
  assign select_255 = ($signed(3'h0) < $signed(select_253[9:7])) ? 8'h7f : select_253[7:0];

  logic centres_values_15_firm_s10_q;
  logic [5:0] centres_values_15_grey_s10_q;
  logic centres_values_15_exists_s10_q;
  logic centres_values_15_marks_first_s10_q;
  logic centres_values_15_marks_last_s10_q;
  logic centres_values_15_marks_seen_s10_q;
  logic centres_values_15_marks_nearer_s10_q;
  logic [7:0] select_256_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      centres_values_15_firm_s10_q <= centres_values_15_firm_s9_q;
      centres_values_15_grey_s10_q <= centres_values_15_grey_s9_q;
      centres_values_15_exists_s10_q <= centres_values_15_exists_s9_q;
      centres_values_15_marks_first_s10_q <= centres_values_15_marks_first_s9_q;
      centres_values_15_marks_last_s10_q <= centres_values_15_marks_last_s9_q;
      centres_values_15_marks_seen_s10_q <= centres_values_15_marks_seen_s9_q;
      centres_values_15_marks_nearer_s10_q <= centres_values_15_marks_nearer_s9_q;
      select_256_s10_q <= centres_values_15_exists_s9_q ? select_255 : 8'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign vote_o = select_256_s10_q;
  assign firm_o = centres_values_15_firm_s10_q;
  assign grey_o = centres_values_15_grey_s10_q;
  assign exists_o = centres_values_15_exists_s10_q;
  assign marks_first_o = centres_values_15_marks_first_s10_q;
  assign marks_last_o = centres_values_15_marks_last_s10_q;
  assign marks_seen_o = centres_values_15_marks_seen_s10_q;
  assign marks_nearer_o = centres_values_15_marks_nearer_s10_q;
  assign valid_o = valid_s10_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^difference_251[1:0];

endmodule
