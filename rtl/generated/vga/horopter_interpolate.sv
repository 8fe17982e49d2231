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
  input  logic swapped_x_i,
  input  logic swapped_y_i,
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
  // hls/stages/interpolate.hpp:61
  logic [7:0] select_14;
  assign select_14 = swapped_x_i ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:63
  logic xor_15;
  assign xor_15 = wx_i[0] ^ swapped_x_i;
  logic [7:0] chosen;
  assign chosen = xor_15 ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:64
  logic [8:0] sum;
  assign sum = {1'b0, select_14} + {1'b0, chosen};
  // hls/stages/interpolate.hpp:63
  logic xor_18;
  assign xor_18 = wx_i[1] ^ swapped_x_i;
  logic [7:0] chosen_2;
  assign chosen_2 = xor_18 ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:64
  logic [8:0] sum_20;
  assign sum_20 = {1'b0, sum[8:1]} + {1'b0, chosen_2};
  // hls/stages/interpolate.hpp:63
  logic xor_21;
  assign xor_21 = wx_i[2] ^ swapped_x_i;
  logic [7:0] chosen_3;
  assign chosen_3 = xor_21 ? p11_i : p10_i;
  // hls/stages/interpolate.hpp:64
  logic [8:0] sum_23;
  assign sum_23 = {1'b0, sum_20[8:1]} + {1'b0, chosen_3};
  // hls/stages/interpolate.hpp:61
  logic [7:0] sum_2;
  assign sum_2 = swapped_x_i ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:63
  logic [7:0] chosen_4;
  assign chosen_4 = xor_15 ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:64
  logic [8:0] sum_3;
  assign sum_3 = {1'b0, sum_2} + {1'b0, chosen_4};
  // hls/stages/interpolate.hpp:63
  logic [7:0] chosen_5;
  assign chosen_5 = xor_18 ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:64
  logic [8:0] sum_28;
  assign sum_28 = {1'b0, sum_3[8:1]} + {1'b0, chosen_5};
  // hls/stages/interpolate.hpp:63
  logic [7:0] chosen_6;
  assign chosen_6 = xor_21 ? p01_i : p00_i;
  // hls/stages/interpolate.hpp:64
  logic [8:0] sum_30;
  assign sum_30 = {1'b0, sum_28[8:1]} + {1'b0, chosen_6};
  // hls/stages/interpolate.hpp:63
  logic [10:0] chosen_7;
  assign chosen_7 = (wy_i[2] ^ swapped_y_i) ? {sum_23, sum_20[0], sum[0]} : {sum_30, sum_28[0], sum_3[0]};
  // hls/stages/interpolate.hpp:61
  logic [10:0] select_32;
  assign select_32 = swapped_y_i ? {sum_23, sum_20[0], sum[0]} : {sum_30, sum_28[0], sum_3[0]};
  // hls/stages/interpolate.hpp:63
  logic [10:0] chosen_8;
  assign chosen_8 = (wy_i[0] ^ swapped_y_i) ? {sum_23, sum_20[0], sum[0]} : {sum_30, sum_28[0], sum_3[0]};
  // hls/stages/interpolate.hpp:64
  logic [11:0] sum_35;
  assign sum_35 = {1'b0, select_32} + {1'b0, chosen_8};
  // hls/stages/interpolate.hpp:63
  logic [10:0] chosen_9;
  assign chosen_9 = (wy_i[1] ^ swapped_y_i) ? {sum_23, sum_20[0], sum[0]} : {sum_30, sum_28[0], sum_3[0]};
  // hls/stages/interpolate.hpp:52
  logic [11:0] sum_38;
  assign sum_38 = {1'b0, sum_35[11:1]} + {1'b0, chosen_9};
  logic [11:0] sum_39;
  assign sum_39 = {1'b0, chosen_7} + {1'b0, sum_38[11:1]};
  logic [8:0] sum_40;
  assign sum_40 = sum_39[11:3] + 9'h1;
  // hls/stages/interpolate.hpp:45
  logic not_45;
  assign not_45 = ~(wx_i == 3'h0);
  logic or_47;
  assign or_47 = not_45 | (~swapped_x_i);
  // hls/stages/interpolate.hpp:47
  logic not_49;
  assign not_49 = ~(wy_i == 3'h0);
  logic or_51;
  assign or_51 = not_49 | (~swapped_y_i);
  // hls/stages/interpolate.hpp:46
  logic or_56;
  assign or_56 = swapped_x_i | not_45;
  // hls/stages/interpolate.hpp:48
  logic or_61;
  assign or_61 = swapped_y_i | not_49;
  // hls/stages/interpolate.hpp:57
  logic [7:0] sum_67;
  assign sum_67 = p11_i + 8'h1;
  // hls/stages/interpolate.hpp:61
  logic and_69;
  assign and_69 = (or_56 & or_61) & (sum_67[7:1] == 7'h0);
  logic select_71;
  assign select_71 = (or_47 & or_61) ? (((p10_i == 8'hff) | (p10_i == 8'h0)) | and_69) : and_69;
  logic select_73;
  assign select_73 = (or_56 & or_51) ? (((p01_i == 8'hff) | (p01_i == 8'h0)) | select_71) : select_71;
  logic select_75;
  assign select_75 = (or_47 & or_51) ? (((p00_i == 8'hff) | (p00_i == 8'h0)) | select_73) : select_73;

  logic [7:0] left_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic [7:0] sum_40_s1_q;
  logic or_76_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      left_s1_q <= left_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      sum_40_s1_q <= sum_40[8:1];
      or_76_s1_q <= ((left_i == 8'hff) | (left_i == 8'h0)) | select_75;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = left_s1_q;
  assign pixel_1_o = sum_40_s1_q;
  assign saturated_o = or_76_s1_q;
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
  assign unused_bits = ^{sum_67[0], sum_40[0], sum_39[2:0], sum_38[0], sum_35[0]};

endmodule
