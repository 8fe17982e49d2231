// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Interpolate<horopter::hls::profiles::hd>, hls/stages/interpolate.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 198 bits, memories 0 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;

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
  logic [7:0] chosen_3;
  assign chosen_3 = wx_i[2] ? p11_i : p10_i;
  logic [7:0] chosen_4;
  assign chosen_4 = wx_i[0] ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:59
  logic [8:0] sum_2;
  assign sum_2 = {1'b0, p00_i} + {1'b0, chosen_4};
  // hls/stages/interpolate.hpp:58
  logic [7:0] chosen_5;
  assign chosen_5 = wx_i[1] ? p01_i : p00_i;
  logic [7:0] chosen_6;
  assign chosen_6 = wx_i[2] ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:42
  logic equal_36;
  assign equal_36 = wx_i == 3'h0;
  // hls/stages/interpolate.hpp:43
  logic equal_37;
  assign equal_37 = wy_i == 3'h0;
  // hls/stages/interpolate.hpp:52
  logic [7:0] sum_40;
  assign sum_40 = p11_i + 8'h1;

  logic [2:0] wy_s1_q;
  logic [7:0] left_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic [8:0] sum_s1_q;
  logic [7:0] chosen_2_s1_q;
  logic [7:0] chosen_3_s1_q;
  logic [8:0] sum_2_s1_q;
  logic [7:0] chosen_5_s1_q;
  logic [7:0] chosen_6_s1_q;
  logic or_35_s1_q;
  logic equal_36_s1_q;
  logic equal_37_s1_q;
  logic and_42_s1_q;
  logic or_45_s1_q;
  logic or_50_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      wy_s1_q <= wy_i;
      left_s1_q <= left_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      sum_s1_q <= sum;
      chosen_2_s1_q <= chosen_2;
      chosen_3_s1_q <= chosen_3;
      sum_2_s1_q <= sum_2;
      chosen_5_s1_q <= chosen_5;
      chosen_6_s1_q <= chosen_6;
      or_35_s1_q <= (p00_i == 8'hff) | (p00_i == 8'h0);
      equal_36_s1_q <= equal_36;
      equal_37_s1_q <= equal_37;
      and_42_s1_q <= (~(equal_36 | equal_37)) & (sum_40[7:1] == 7'h0);
      or_45_s1_q <= (p10_i == 8'hff) | (p10_i == 8'h0);
      or_50_s1_q <= (p01_i == 8'hff) | (p01_i == 8'h0);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:59
  logic [8:0] sum_14;
  assign sum_14 = {1'b0, sum_s1_q[8:1]} + {1'b0, chosen_2_s1_q};
  logic [8:0] sum_20;
  assign sum_20 = {1'b0, sum_2_s1_q[8:1]} + {1'b0, chosen_5_s1_q};
  // hls/stages/interpolate.hpp:56
  logic select_47;
  assign select_47 = equal_37_s1_q ? and_42_s1_q : (or_45_s1_q | and_42_s1_q);
  logic or_53;
  assign or_53 = or_35_s1_q | (equal_36_s1_q ? select_47 : (or_50_s1_q | select_47));

  logic [2:0] wy_s2_q;
  logic [7:0] left_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic sum_s2_q;
  logic sum_14_s2_q;
  logic [8:0] sum_16_s2_q;
  logic sum_2_s2_q;
  logic sum_20_s2_q;
  logic [8:0] sum_22_s2_q;
  logic or_54_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      wy_s2_q <= wy_s1_q;
      left_s2_q <= left_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      sum_s2_q <= sum_s1_q[0];
      sum_14_s2_q <= sum_14[0];
      sum_16_s2_q <= {1'b0, sum_14[8:1]} + {1'b0, chosen_3_s1_q};
      sum_2_s2_q <= sum_2_s1_q[0];
      sum_20_s2_q <= sum_20[0];
      sum_22_s2_q <= {1'b0, sum_20[8:1]} + {1'b0, chosen_6_s1_q};
      or_54_s2_q <= ((left_s1_q == 8'hff) | (left_s1_q == 8'h0)) | or_53;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:58
  logic [10:0] chosen_7;
  assign chosen_7 = wy_s2_q[2] ? {sum_16_s2_q, sum_14_s2_q, sum_s2_q} : {sum_22_s2_q, sum_20_s2_q, sum_2_s2_q};
  logic [10:0] chosen_8;
  assign chosen_8 = wy_s2_q[0] ? {sum_16_s2_q, sum_14_s2_q, sum_s2_q} : {sum_22_s2_q, sum_20_s2_q, sum_2_s2_q};
  // hls/stages/interpolate.hpp:59
  logic [11:0] sum_25;
  assign sum_25 = {1'b0, sum_22_s2_q, sum_20_s2_q, sum_2_s2_q} + {1'b0, chosen_8};
  // hls/stages/interpolate.hpp:58
  logic [10:0] chosen_9;
  assign chosen_9 = wy_s2_q[1] ? {sum_16_s2_q, sum_14_s2_q, sum_s2_q} : {sum_22_s2_q, sum_20_s2_q, sum_2_s2_q};

  logic [7:0] left_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic [10:0] chosen_7_s3_q;
  logic [10:0] sum_25_s3_q;
  logic [10:0] chosen_9_s3_q;
  logic or_54_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      left_s3_q <= left_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      chosen_7_s3_q <= chosen_7;
      sum_25_s3_q <= sum_25[11:1];
      chosen_9_s3_q <= chosen_9;
      or_54_s3_q <= or_54_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:47
  logic [11:0] sum_27;
  assign sum_27 = {1'b0, sum_25_s3_q} + {1'b0, chosen_9_s3_q};
  logic [11:0] sum_28;
  assign sum_28 = {1'b0, chosen_7_s3_q} + {1'b0, sum_27[11:1]};

  logic [7:0] left_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic [8:0] sum_28_s4_q;
  logic or_54_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      left_s4_q <= left_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sum_28_s4_q <= sum_28[11:3];
      or_54_s4_q <= or_54_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:47
  logic [8:0] sum_29;
  assign sum_29 = sum_28_s4_q + 9'h1;

  logic [7:0] left_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic [7:0] sum_29_s5_q;
  logic or_54_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      left_s5_q <= left_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      sum_29_s5_q <= sum_29[8:1];
      or_54_s5_q <= or_54_s4_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = left_s5_q;
  assign pixel_1_o = sum_29_s5_q;
  assign saturated_o = or_54_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign valid_o = valid_s5_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_40[0], sum_29[0], sum_28[2:0], sum_27[0], sum_25[0]};

endmodule
