// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Interpolate<horopter::hls::profiles::vga>, hls/stages/interpolate.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 21 bits, memories 0 bits.
module horopter_interpolate (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] p00_i,
  input  logic [7:0] p01_i,
  input  logic [7:0] p10_i,
  input  logic [7:0] p11_i,
  input  logic [2:0] wx_i,
  input  logic [2:0] wy_i,
  input  logic [7:0] left_i,
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
  // hls/stages/interpolate.hpp:58
  logic [7:0] chosen;
  assign chosen = wx_i[0] ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:59
  logic [8:0] sum;
  assign sum = {1'b0, p10_i} + {1'b0, chosen};
  // hls/stages/interpolate.hpp:58
  logic [7:0] chosen_2;
  assign chosen_2 = wx_i[1] ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:59
  logic [8:0] sum_14;
  assign sum_14 = {1'b0, sum[8:1]} + {1'b0, chosen_2};
  // hls/stages/interpolate.hpp:58
  logic [7:0] chosen_3;
  assign chosen_3 = wx_i[2] ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:59
  logic [8:0] sum_16;
  assign sum_16 = {1'b0, sum_14[8:1]} + {1'b0, chosen_3};
  // hls/stages/interpolate.hpp:58
  logic [7:0] chosen_4;
  assign chosen_4 = wx_i[0] ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:59
  logic [8:0] sum_2;
  assign sum_2 = {1'b0, p00_i} + {1'b0, chosen_4};
  // hls/stages/interpolate.hpp:58
  logic [7:0] chosen_5;
  assign chosen_5 = wx_i[1] ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:59
  logic [8:0] sum_20;
  assign sum_20 = {1'b0, sum_2[8:1]} + {1'b0, chosen_5};
  // hls/stages/interpolate.hpp:58
  logic [7:0] chosen_6;
  assign chosen_6 = wx_i[2] ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:59
  logic [8:0] sum_22;
  assign sum_22 = {1'b0, sum_20[8:1]} + {1'b0, chosen_6};
  // hls/stages/interpolate.hpp:58
  logic [10:0] chosen_7;
  assign chosen_7 = wy_i[2] ? {sum_16, sum_14[0], sum[0]} : {sum_22, sum_20[0], sum_2[0]};
  logic [10:0] chosen_8;
  assign chosen_8 = wy_i[0] ? {sum_16, sum_14[0], sum[0]} : {sum_22, sum_20[0], sum_2[0]};
  // hls/stages/interpolate.hpp:59
  logic [11:0] sum_25;
  assign sum_25 = {1'b0, sum_22, sum_20[0], sum_2[0]} + {1'b0, chosen_8};
  // hls/stages/interpolate.hpp:58
  logic [10:0] chosen_9;
  assign chosen_9 = wy_i[1] ? {sum_16, sum_14[0], sum[0]} : {sum_22, sum_20[0], sum_2[0]};
  // hls/stages/interpolate.hpp:47
  logic [11:0] sum_27;
  assign sum_27 = {1'b0, sum_25[11:1]} + {1'b0, chosen_9};
  logic [11:0] sum_28;
  assign sum_28 = {1'b0, chosen_7} + {1'b0, sum_27[11:1]};
  logic [8:0] sum_29;
  assign sum_29 = sum_28[11:3] + 9'h1;
  // hls/stages/interpolate.hpp:42
  logic equal_36;
  assign equal_36 = wx_i == 3'h0;
  // hls/stages/interpolate.hpp:43
  logic equal_37;
  assign equal_37 = wy_i == 3'h0;
  // hls/stages/interpolate.hpp:52
  logic [7:0] sum_40;
  assign sum_40 = p11_i + 8'h1;
  // hls/stages/interpolate.hpp:56
  logic and_42;
  assign and_42 = (~(equal_36 | equal_37)) & (sum_40[7:1] == 7'h0);
  logic select_47;
  assign select_47 = equal_37 ? and_42 : (((p10_i == 8'hff) | (p10_i == 8'h0)) | and_42);
  logic select_52;
  assign select_52 = equal_36 ? select_47 : (((p01_i == 8'hff) | (p01_i == 8'h0)) | select_47);
  logic or_54;
  assign or_54 = ((left_i == 8'hff) | (left_i == 8'h0)) | (((p00_i == 8'hff) | (p00_i == 8'h0)) | select_52);

  logic [7:0] left_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic [7:0] sum_29_s1_q;
  logic or_54_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      left_s1_q <= left_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      sum_29_s1_q <= sum_29[8:1];
      or_54_s1_q <= or_54;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = left_s1_q;
  assign pixel_1_o = sum_29_s1_q;
  assign saturated_o = or_54_s1_q;
  assign mask_o = mask_s1_q;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = marks_last_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_40[0], sum_29[0], sum_28[2:0], sum_27[0], sum_25[0]};

endmodule
