// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Alarm<horopter::hls::profiles::field>, hls/stages/alarm.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 51 bits, pipeline 4 bits, memories 0 bits.
module horopter_alarm (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic first_i,
  input  logic end_v_i,
  input  logic idle_i,
  input  logic hidden_i,
  input  logic unproven_i,
  input  logic [16:0] cfg_alarm_limit_i,
  input  logic [16:0] cfg_undecidable_limit_i,
  input  logic [16:0] cfg_unsupervised_limit_i,
  output logic valid_o,
  output logic [16:0] skin_pixels_o,
  output logic [16:0] unsupervised_pixels_o,
  output logic alarm_o,
  output logic too_undecidable_o,
  output logic too_unsupervised_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [16:0] skin_q;
  logic [16:0] undecidable_q;
  logic [16:0] unsupervised_q;
  // hls/stages/alarm.hpp:44
  logic not_13;
  assign not_13 = ~idle_i;
  // hls/stages/stream.hpp:54
  logic and_15;
  assign and_15 = not_13 & (state_i == 2'h1);
  logic [16:0] sum_17;
  assign sum_17 = {16'h0, and_15} + (first_i ? 17'h0 : skin_q);
  logic and_23;
  assign and_23 = not_13 & ((state_i == 2'h2) & ((~hidden_i) & (~unproven_i)));
  logic [16:0] sum_25;
  assign sum_25 = {16'h0, and_23} + (first_i ? 17'h0 : undecidable_q);
  logic and_27;
  assign and_27 = not_13 & (state_i == 2'h3);
  logic [16:0] sum_29;
  assign sum_29 = {16'h0, and_27} + (first_i ? 17'h0 : unsupervised_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      skin_q <= 17'h0;
      undecidable_q <= 17'h0;
      unsupervised_q <= 17'h0;
    end else if (s0_en) begin
      skin_q <= sum_17;
      undecidable_q <= sum_25;
      unsupervised_q <= sum_29;
    end
  end

  logic less_30_s1_q;
  logic less_31_s1_q;
  logic less_32_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      less_30_s1_q <= cfg_alarm_limit_i < sum_17;
      less_31_s1_q <= cfg_undecidable_limit_i < sum_25;
      less_32_s1_q <= cfg_unsupervised_limit_i < sum_29;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_pixels_o = skin_q;
  assign unsupervised_pixels_o = unsupervised_q;
  assign alarm_o = less_30_s1_q;
  assign too_undecidable_o = less_31_s1_q;
  assign too_unsupervised_o = less_32_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & (end_v_i & not_13);
    end
  end

endmodule
