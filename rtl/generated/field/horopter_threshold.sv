// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Threshold<horopter::hls::profiles::field>, hls/stages/threshold.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// Outputs are logic: what they go to takes them with the clock if en_i = 1.
// State 0 bits, pipeline 8 bits, memories 0 bits.
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
  logic valid_s1_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------

  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic not_12_s1_q;
  logic and_14_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      not_12_s1_q <= ~(cfg_sum_limit_i < sum_0_i);
      and_14_s1_q <= textured_i & (cfg_self_limit_i < sum_1_i);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_o = not_12_s1_q;
  assign decidable_o = and_14_s1_q;
  assign mask_o = mask_s1_q;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = marks_last_s1_q;
  assign marks_seen_o = marks_seen_s1_q;
  assign marks_nearer_o = marks_nearer_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
    end
  end

endmodule
