// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Dim<horopter::hls::profiles::vga>, hls/stages/dim.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 23 bits, memories 0 bits.
module horopter_dim (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic [7:0] pixel_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  input  logic cfg_dim_i,
  output logic valid_o,
  output logic [7:0] pixel_0_o,
  output logic [7:0] pixel_1_o,
  output logic saturated_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/dim.hpp:27
  logic [1:0] sum_10;
  assign sum_10 = {1'b0, pixel_0_i[7]} + 2'h1;
  logic [1:0] sum_12;
  assign sum_12 = {1'b0, pixel_1_i[7]} + 2'h1;

  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic [7:0] select_11_s1_q;
  logic [7:0] select_13_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      select_11_s1_q <= cfg_dim_i ? {sum_10, pixel_0_i[6:1]} : pixel_0_i;
      select_13_s1_q <= cfg_dim_i ? {sum_12, pixel_1_i[6:1]} : pixel_1_i;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = select_11_s1_q;
  assign pixel_1_o = select_13_s1_q;
  assign saturated_o = saturated_s1_q;
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
