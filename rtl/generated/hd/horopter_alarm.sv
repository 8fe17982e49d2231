// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Alarm<horopter::hls::profiles::hd>, hls/stages/alarm.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 63 bits, pipeline 54 bits, memories 0 bits.
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
  input  logic [20:0] cfg_alarm_limit_i,
  input  logic [20:0] cfg_undecidable_limit_i,
  input  logic [20:0] cfg_unsupervised_limit_i,
  output logic valid_o,
  output logic [20:0] skin_pixels_o,
  output logic [20:0] unsupervised_pixels_o,
  output logic alarm_o,
  output logic too_undecidable_o,
  output logic too_unsupervised_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q;
  logic s1_en, s2_en;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/alarm.hpp:44
  logic not_13;
  assign not_13 = ~idle_i;

  logic first_s1_q;
  logic and_15_s1_q;
  logic and_23_s1_q;
  logic and_27_s1_q;
  logic and_33_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s1_q <= first_i;
      and_15_s1_q <= not_13 & (state_i == 2'h1);
      and_23_s1_q <= not_13 & ((state_i == 2'h2) & ((~hidden_i) & (~unproven_i)));
      and_27_s1_q <= not_13 & (state_i == 2'h3);
      and_33_s1_q <= end_v_i & not_13;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [20:0] skin_q;
  logic [20:0] undecidable_q;
  logic [20:0] unsupervised_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      skin_q <= 21'h0;
      undecidable_q <= 21'h0;
      unsupervised_q <= 21'h0;
    end else if (s1_en) begin
      skin_q <= {20'h0, and_15_s1_q} + (first_s1_q ? 21'h0 : skin_q);
      undecidable_q <= {20'h0, and_23_s1_q} + (first_s1_q ? 21'h0 : undecidable_q);
      unsupervised_q <= {20'h0, and_27_s1_q} + (first_s1_q ? 21'h0 : unsupervised_q);
    end
  end

  logic and_33_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      and_33_s2_q <= and_33_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------

  logic [20:0] sum_17_s3_q;
  logic [20:0] sum_29_s3_q;
  logic less_30_s3_q;
  logic less_31_s3_q;
  logic less_32_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      sum_17_s3_q <= skin_q;
      sum_29_s3_q <= unsupervised_q;
      less_30_s3_q <= cfg_alarm_limit_i < skin_q;
      less_31_s3_q <= cfg_undecidable_limit_i < undecidable_q;
      less_32_s3_q <= cfg_unsupervised_limit_i < unsupervised_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_pixels_o = sum_17_s3_q;
  assign unsupervised_pixels_o = sum_29_s3_q;
  assign alarm_o = less_30_s3_q;
  assign too_undecidable_o = less_31_s3_q;
  assign too_unsupervised_o = less_32_s3_q;
  assign valid_o = valid_s3_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q & and_33_s2_q;
    end
  end

endmodule
