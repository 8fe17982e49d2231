// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Alarm<horopter::hls::profiles::hd>, hls/stages/alarm.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 63 bits, pipeline 69 bits, memories 0 bits.
module horopter_alarm (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic first_i,
  input  logic end_v_i,
  input  logic idle_i,
  input  logic [20:0] cfg_alarm_limit_i,
  input  logic [20:0] cfg_undecidable_limit_i,
  input  logic [20:0] cfg_unsupervised_limit_i,
  output logic valid_o,
  output logic [20:0] skin_pixels_o,
  output logic [20:0] undecidable_pixels_o,
  output logic [20:0] unsupervised_pixels_o,
  output logic alarm_o,
  output logic too_undecidable_o,
  output logic too_unsupervised_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [20:0] skin_q;
  logic [20:0] undecidable_q;
  logic [20:0] unsupervised_q;
  // hls/stages/alarm.hpp:42
  logic not_11;
  assign not_11 = ~idle_i;
  // hls/stages/stream.hpp:54
  logic and_13;
  assign and_13 = not_11 & (state_i == 2'h1);
  logic and_17;
  assign and_17 = not_11 & (state_i == 2'h2);
  logic and_21;
  assign and_21 = not_11 & (state_i == 2'h3);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      skin_q <= 21'h0;
      undecidable_q <= 21'h0;
      unsupervised_q <= 21'h0;
    end else if (s0_en) begin
      skin_q <= {20'h0, and_13} + (first_i ? 21'h0 : skin_q);
      undecidable_q <= {20'h0, and_17} + (first_i ? 21'h0 : undecidable_q);
      unsupervised_q <= {20'h0, and_21} + (first_i ? 21'h0 : unsupervised_q);
    end
  end

  logic and_27_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      and_27_s1_q <= end_v_i & not_11;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic [20:0] sum_15_s2_q;
  logic [20:0] sum_19_s2_q;
  logic [20:0] sum_23_s2_q;
  logic less_24_s2_q;
  logic less_25_s2_q;
  logic less_26_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      sum_15_s2_q <= skin_q;
      sum_19_s2_q <= undecidable_q;
      sum_23_s2_q <= unsupervised_q;
      less_24_s2_q <= cfg_alarm_limit_i < skin_q;
      less_25_s2_q <= cfg_undecidable_limit_i < undecidable_q;
      less_26_s2_q <= cfg_unsupervised_limit_i < unsupervised_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_pixels_o = sum_15_s2_q;
  assign undecidable_pixels_o = sum_19_s2_q;
  assign unsupervised_pixels_o = sum_23_s2_q;
  assign alarm_o = less_24_s2_q;
  assign too_undecidable_o = less_25_s2_q;
  assign too_unsupervised_o = less_26_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q & and_27_s1_q;
    end
  end

endmodule
