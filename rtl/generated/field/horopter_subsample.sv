// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Subsample<horopter::hls::profiles::field>, hls/stages/subsample.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 15 bits, pipeline 14 bits, memories 0 bits.
module horopter_subsample (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic [7:0] pixel_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic present_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  output logic valid_o,
  output logic [7:0] pixel_0_o,
  output logic saturated_o,
  output logic mask_o,
  output logic present_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic second_q;
  logic right_waits_q;
  logic [7:0] kept_pixel_1_q;
  logic kept_saturated_q;
  logic kept_mask_q;
  logic kept_present_q;
  logic kept_marks_first_q;
  logic kept_marks_last_q;
  // hls/stages/subsample.hpp:78
  logic second;
  assign second = second_q & (~marks_first_i);
  // hls/stages/subsample.hpp:83
  logic not_18;
  assign not_18 = ~second;
  // hls/stages/subsample.hpp:91
  logic [8:0] right;
  assign right = ({1'b0, pixel_1_i} + {1'b0, kept_pixel_1_q}) + 9'h1;
  logic [7:0] right_2;
  assign right_2 = second ? right[8:1] : pixel_1_i;
  // hls/stages/subsample.hpp:80
  logic saturated;
  assign saturated = saturated_i | kept_saturated_q;
  logic mask;
  assign mask = mask_i & kept_mask_q;
  // hls/stages/subsample.hpp:83
  logic present;
  assign present = present_i & kept_present_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      second_q <= 1'b0;
      right_waits_q <= 1'b0;
    end else if (s0_en) begin
      second_q <= not_18 & (~marks_last_i);
      right_waits_q <= second;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    kept_pixel_1_q = 8'h0;
    kept_saturated_q = 1'b0;
    kept_mask_q = 1'b0;
    kept_present_q = 1'b0;
    kept_marks_first_q = 1'b0;
    kept_marks_last_q = 1'b0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (rst_ni & s0_en) begin
      kept_pixel_1_q <= right_2;
      kept_saturated_q <= second ? saturated : saturated_i;
      kept_mask_q <= second ? mask : mask_i;
      kept_present_q <= second ? present : present_i;
      kept_marks_first_q <= marks_first_i;
      kept_marks_last_q <= marks_last_i;
    end
  end

  logic [7:0] select_30_s1_q;
  logic select_31_s1_q;
  logic select_32_s1_q;
  logic select_33_s1_q;
  logic and_34_s1_q;
  logic and_36_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      select_30_s1_q <= second ? pixel_0_i : kept_pixel_1_q;
      select_31_s1_q <= second ? saturated : kept_saturated_q;
      select_32_s1_q <= second ? mask : kept_mask_q;
      select_33_s1_q <= second ? present : kept_present_q;
      and_34_s1_q <= kept_marks_first_q & second;
      and_36_s1_q <= not_18 & (marks_last_i | kept_marks_last_q);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = select_30_s1_q;
  assign saturated_o = select_31_s1_q;
  assign mask_o = select_32_s1_q;
  assign present_o = select_33_s1_q;
  assign marks_first_o = and_34_s1_q;
  assign marks_last_o = and_36_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & (right_waits_q | second);
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^right[0];

endmodule
