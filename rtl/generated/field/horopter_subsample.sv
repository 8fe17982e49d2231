// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Subsample<horopter::hls::profiles::field>, hls/stages/subsample.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 20 bits, pipeline 20 bits, memories 0 bits.
module horopter_subsample (
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
  output logic valid_o,
  output logic [7:0] pixel_0_o,
  output logic [7:0] pixel_1_o,
  output logic saturated_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic second_q;
  logic [7:0] even_pixel_0_q;
  logic [7:0] even_pixel_1_q;
  logic even_saturated_q;
  logic even_mask_q;
  logic even_marks_first_q;
  // hls/stages/subsample.hpp:39
  logic and_14;
  assign and_14 = second_q & (~marks_first_i);
  // hls/stages/subsample.hpp:48
  logic [8:0] sum_24;
  assign sum_24 = ({1'b0, pixel_0_i} + {1'b0, even_pixel_0_q}) + 9'h1;
  // hls/stages/subsample.hpp:42
  logic [8:0] sum_26;
  assign sum_26 = ({1'b0, pixel_1_i} + {1'b0, even_pixel_1_q}) + 9'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      second_q <= 1'b0;
      even_pixel_0_q <= 8'h0;
      even_pixel_1_q <= 8'h0;
      even_saturated_q <= 1'b0;
      even_mask_q <= 1'b0;
      even_marks_first_q <= 1'b0;
    end else if (s0_en) begin
      second_q <= (~and_14) & (~marks_last_i);
      even_pixel_0_q <= and_14 ? even_pixel_0_q : pixel_0_i;
      even_pixel_1_q <= and_14 ? even_pixel_1_q : pixel_1_i;
      even_saturated_q <= and_14 ? even_saturated_q : saturated_i;
      even_mask_q <= and_14 ? even_mask_q : mask_i;
      even_marks_first_q <= and_14 ? even_marks_first_q : marks_first_i;
    end
  end

  logic marks_last_s1_q;
  logic [7:0] sum_24_s1_q;
  logic [7:0] sum_26_s1_q;
  logic or_27_s1_q;
  logic and_29_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      marks_last_s1_q <= marks_last_i;
      sum_24_s1_q <= sum_24[8:1];
      sum_26_s1_q <= sum_26[8:1];
      or_27_s1_q <= saturated_i | even_saturated_q;
      and_29_s1_q <= and_14 & (mask_i & even_mask_q);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = sum_24_s1_q;
  assign pixel_1_o = sum_26_s1_q;
  assign saturated_o = or_27_s1_q;
  assign mask_o = and_29_s1_q;
  assign marks_first_o = even_marks_first_q;
  assign marks_last_o = marks_last_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & (marks_last_i | and_14);
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_26[0], sum_24[0]};

endmodule
