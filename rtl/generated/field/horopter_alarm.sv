// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Alarm<horopter::hls::profiles::field>, hls/stages/alarm.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
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
  input  logic [16:0] cfg_alarm_limit_i,
  input  logic [16:0] cfg_undecidable_limit_i,
  input  logic [16:0] cfg_unsupervised_limit_i,
  output logic valid_o,
  output logic [16:0] skin_pixels_o,
  output logic [16:0] undecidable_pixels_o,
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
  logic [16:0] select_11;
  assign select_11 = first_i ? 17'h0 : skin_q;
  // hls/stages/alarm.hpp:45
  logic equal_12;
  assign equal_12 = state_i == 2'h1;
  // hls/stages/alarm.hpp:31
  logic [16:0] select_14;
  assign select_14 = idle_i ? select_11 : (select_11 + {16'h0, equal_12});
  // hls/stages/alarm.hpp:44
  logic [16:0] select_15;
  assign select_15 = first_i ? 17'h0 : undecidable_q;
  // hls/stages/alarm.hpp:46
  logic equal_16;
  assign equal_16 = state_i == 2'h2;
  // hls/stages/alarm.hpp:31
  logic [16:0] select_18;
  assign select_18 = idle_i ? select_15 : (select_15 + {16'h0, equal_16});
  // hls/stages/alarm.hpp:44
  logic [16:0] select_19;
  assign select_19 = first_i ? 17'h0 : unsupervised_q;
  // hls/stages/alarm.hpp:47
  logic equal_20;
  assign equal_20 = state_i == 2'h3;
  // hls/stages/alarm.hpp:31
  logic [16:0] select_22;
  assign select_22 = idle_i ? select_19 : (select_19 + {16'h0, equal_20});

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      skin_q <= 17'h0;
      undecidable_q <= 17'h0;
      unsupervised_q <= 17'h0;
    end else if (s0_en) begin
      skin_q <= select_14;
      undecidable_q <= select_18;
      unsupervised_q <= select_22;
    end
  end

  logic less_23_s1_q;
  logic less_24_s1_q;
  logic less_25_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      less_23_s1_q <= cfg_alarm_limit_i < select_14;
      less_24_s1_q <= cfg_undecidable_limit_i < select_18;
      less_25_s1_q <= cfg_unsupervised_limit_i < select_22;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_pixels_o = skin_q;
  assign undecidable_pixels_o = undecidable_q;
  assign unsupervised_pixels_o = unsupervised_q;
  assign alarm_o = less_23_s1_q;
  assign too_undecidable_o = less_24_s1_q;
  assign too_unsupervised_o = less_25_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & (end_v_i & (~idle_i));
    end
  end

endmodule
