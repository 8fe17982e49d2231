// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Interpolate<horopter::hls::profiles::vga>, hls/stages/interpolate.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 22 bits, memories 0 bits.
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
  input  logic swapped_x_i,
  input  logic swapped_y_i,
  input  logic [7:0] left_i,
  input  logic mask_i,
  input  logic present_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  output logic valid_o,
  output logic [7:0] pixel_0_o,
  output logic [7:0] pixel_1_o,
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
  // hls/stages/interpolate.hpp:64
  logic [7:0] select_15;
  assign select_15 = swapped_x_i ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:66
  logic xor_16;
  assign xor_16 = wx_i[0] ^ swapped_x_i;
  logic [7:0] chosen;
  assign chosen = xor_16 ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:67
  logic [8:0] sum;
  assign sum = {1'b0, select_15} + {1'b0, chosen};
  // hls/stages/interpolate.hpp:66
  logic xor_19;
  assign xor_19 = wx_i[1] ^ swapped_x_i;
  logic [7:0] chosen_2;
  assign chosen_2 = xor_19 ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:67
  logic [8:0] sum_21;
  assign sum_21 = {1'b0, sum[8:1]} + {1'b0, chosen_2};
  // hls/stages/interpolate.hpp:66
  logic xor_22;
  assign xor_22 = wx_i[2] ^ swapped_x_i;
  logic [7:0] chosen_3;
  assign chosen_3 = xor_22 ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:67
  logic [8:0] sum_24;
  assign sum_24 = {1'b0, sum_21[8:1]} + {1'b0, chosen_3};
  // hls/stages/interpolate.hpp:64
  logic [7:0] sum_2;
  assign sum_2 = swapped_x_i ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:66
  logic [7:0] chosen_4;
  assign chosen_4 = xor_16 ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:67
  logic [8:0] sum_3;
  assign sum_3 = {1'b0, sum_2} + {1'b0, chosen_4};
  // hls/stages/interpolate.hpp:66
  logic [7:0] chosen_5;
  assign chosen_5 = xor_19 ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:67
  logic [8:0] sum_29;
  assign sum_29 = {1'b0, sum_3[8:1]} + {1'b0, chosen_5};
  // hls/stages/interpolate.hpp:66
  logic [7:0] chosen_6;
  assign chosen_6 = xor_22 ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:67
  logic [8:0] sum_31;
  assign sum_31 = {1'b0, sum_29[8:1]} + {1'b0, chosen_6};
  // hls/stages/interpolate.hpp:66
  logic [10:0] chosen_7;
  assign chosen_7 = (wy_i[2] ^ swapped_y_i) ? {sum_24, sum_21[0], sum[0]} : {sum_31, sum_29[0], sum_3[0]};
  // hls/stages/interpolate.hpp:64
  logic [10:0] select_33;
  assign select_33 = swapped_y_i ? {sum_24, sum_21[0], sum[0]} : {sum_31, sum_29[0], sum_3[0]};
  // hls/stages/interpolate.hpp:66
  logic [10:0] chosen_8;
  assign chosen_8 = (wy_i[0] ^ swapped_y_i) ? {sum_24, sum_21[0], sum[0]} : {sum_31, sum_29[0], sum_3[0]};
  // hls/stages/interpolate.hpp:67
  logic [11:0] sum_36;
  assign sum_36 = {1'b0, select_33} + {1'b0, chosen_8};
  // hls/stages/interpolate.hpp:66
  logic [10:0] chosen_9;
  assign chosen_9 = (wy_i[1] ^ swapped_y_i) ? {sum_24, sum_21[0], sum[0]} : {sum_31, sum_29[0], sum_3[0]};
  // hls/stages/interpolate.hpp:55
  logic [11:0] sum_39;
  assign sum_39 = {1'b0, sum_36[11:1]} + {1'b0, chosen_9};
  logic [11:0] sum_40;
  assign sum_40 = {1'b0, chosen_7} + {1'b0, sum_39[11:1]};
  logic [8:0] sum_41;
  assign sum_41 = sum_40[11:3] + 9'h1;
  // hls/stages/interpolate.hpp:47
  logic not_46;
  assign not_46 = ~(wx_i == 3'h0);
  logic or_48;
  assign or_48 = not_46 | (~swapped_x_i);
  // hls/stages/interpolate.hpp:49
  logic not_50;
  assign not_50 = ~(wy_i == 3'h0);
  logic or_52;
  assign or_52 = not_50 | (~swapped_y_i);
  // hls/stages/interpolate.hpp:48
  logic or_57;
  assign or_57 = swapped_x_i | not_46;
  // hls/stages/interpolate.hpp:50
  logic or_62;
  assign or_62 = swapped_y_i | not_50;
  // hls/stages/interpolate.hpp:60
  logic [7:0] sum_68;
  assign sum_68 = p11_i + 8'h1;
  // hls/stages/interpolate.hpp:64
  logic and_70;
  assign and_70 = (or_57 & or_62) & (sum_68[7:1] == 7'h0);
  logic select_72;
  assign select_72 = (or_48 & or_62) ? (((p10_i == 8'hff) | (p10_i == 8'h0)) | and_70) : and_70;
  logic select_74;
  assign select_74 = (or_57 & or_52) ? (((p01_i == 8'hff) | (p01_i == 8'h0)) | select_72) : select_72;
  logic select_76;
  assign select_76 = (or_48 & or_52) ? (((p00_i == 8'hff) | (p00_i == 8'h0)) | select_74) : select_74;

  logic [7:0] left_s1_q;
  logic mask_s1_q;
  logic present_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic [7:0] sum_41_s1_q;
  logic or_77_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      left_s1_q <= left_i;
      mask_s1_q <= mask_i;
      present_s1_q <= present_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      sum_41_s1_q <= sum_41[8:1];
      or_77_s1_q <= ((left_i == 8'hff) | (left_i == 8'h0)) | select_76;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = left_s1_q;
  assign pixel_1_o = sum_41_s1_q;
  assign saturated_o = or_77_s1_q;
  assign mask_o = mask_s1_q;
  assign present_o = present_s1_q;
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
  assign unused_bits = ^{sum_68[0], sum_41[0], sum_40[2:0], sum_39[0], sum_36[0]};

endmodule
