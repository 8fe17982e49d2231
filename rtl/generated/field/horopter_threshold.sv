// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Threshold<horopter::hls::profiles::field>, hls/stages/threshold.hpp. Do not edit.
//
// Latency 0 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// Outputs are logic: what they go to takes them with the clock if en_i = 1.
// State 0 bits, pipeline 0 bits, memories 0 bits.
module horopter_threshold (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [10:0] sum_0_i,
  input  logic [10:0] sum_1_i,
  input  logic textured_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  input  logic [10:0] cfg_sum_limit_i,
  input  logic [10:0] cfg_self_limit_i,
  output logic valid_o,
  output logic skin_o,
  output logic decidable_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.

  // Stage 0 -----------------------------------------------------------------------------------------------------------

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_o = ~(cfg_sum_limit_i < sum_0_i);
  assign decidable_o = textured_i & (cfg_self_limit_i < sum_1_i);
  assign mask_o = mask_i;
  assign marks_first_o = marks_first_i;
  assign marks_last_o = marks_last_i;
  assign marks_seen_o = marks_seen_i;
  assign marks_nearer_o = marks_nearer_i;
  assign valid_o = valid_i;

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{clk_i, rst_ni, en_i};

endmodule
