// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Interpolate<horopter::hls::profiles::hd>, hls/stages/interpolate.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 206 bits, memories 0 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s4_en;
  assign s4_en = en_i & valid_s4_q;

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
  logic xor_22;
  assign xor_22 = wx_i[2] ^ swapped_x_i;
  logic [7:0] chosen_3;
  assign chosen_3 = xor_22 ? p11_i : p10_i;
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
  logic [7:0] chosen_6;
  assign chosen_6 = xor_22 ? p01_i : p00_i;
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

  logic swapped_y_s1_q;
  logic [7:0] left_s1_q;
  logic mask_s1_q;
  logic present_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic xor_14_s1_q;
  logic [8:0] sum_s1_q;
  logic [7:0] chosen_2_s1_q;
  logic [7:0] chosen_3_s1_q;
  logic [8:0] sum_3_s1_q;
  logic [7:0] chosen_5_s1_q;
  logic [7:0] chosen_6_s1_q;
  logic xor_34_s1_q;
  logic xor_37_s1_q;
  logic and_53_s1_q;
  logic or_56_s1_q;
  logic and_58_s1_q;
  logic or_61_s1_q;
  logic and_63_s1_q;
  logic or_66_s1_q;
  logic and_70_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      swapped_y_s1_q <= swapped_y_i;
      left_s1_q <= left_i;
      mask_s1_q <= mask_i;
      present_s1_q <= present_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      xor_14_s1_q <= wy_i[2] ^ swapped_y_i;
      sum_s1_q <= sum;
      chosen_2_s1_q <= chosen_2;
      chosen_3_s1_q <= chosen_3;
      sum_3_s1_q <= sum_3;
      chosen_5_s1_q <= chosen_5;
      chosen_6_s1_q <= chosen_6;
      xor_34_s1_q <= wy_i[0] ^ swapped_y_i;
      xor_37_s1_q <= wy_i[1] ^ swapped_y_i;
      and_53_s1_q <= or_48 & or_52;
      or_56_s1_q <= (p00_i == 8'hff) | (p00_i == 8'h0);
      and_58_s1_q <= or_57 & or_52;
      or_61_s1_q <= (p01_i == 8'hff) | (p01_i == 8'h0);
      and_63_s1_q <= or_48 & or_62;
      or_66_s1_q <= (p10_i == 8'hff) | (p10_i == 8'h0);
      and_70_s1_q <= (or_57 & or_62) & (sum_68[7:1] == 7'h0);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:67
  logic [8:0] sum_21;
  assign sum_21 = {1'b0, sum_s1_q[8:1]} + {1'b0, chosen_2_s1_q};
  logic [8:0] sum_29;
  assign sum_29 = {1'b0, sum_3_s1_q[8:1]} + {1'b0, chosen_5_s1_q};
  // hls/stages/interpolate.hpp:64
  logic select_72;
  assign select_72 = and_63_s1_q ? (or_66_s1_q | and_70_s1_q) : and_70_s1_q;
  logic select_74;
  assign select_74 = and_58_s1_q ? (or_61_s1_q | select_72) : select_72;

  logic swapped_y_s2_q;
  logic [7:0] left_s2_q;
  logic mask_s2_q;
  logic present_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic xor_14_s2_q;
  logic sum_s2_q;
  logic sum_21_s2_q;
  logic [8:0] sum_24_s2_q;
  logic sum_3_s2_q;
  logic sum_29_s2_q;
  logic [8:0] sum_31_s2_q;
  logic xor_34_s2_q;
  logic xor_37_s2_q;
  logic select_76_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      swapped_y_s2_q <= swapped_y_s1_q;
      left_s2_q <= left_s1_q;
      mask_s2_q <= mask_s1_q;
      present_s2_q <= present_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      xor_14_s2_q <= xor_14_s1_q;
      sum_s2_q <= sum_s1_q[0];
      sum_21_s2_q <= sum_21[0];
      sum_24_s2_q <= {1'b0, sum_21[8:1]} + {1'b0, chosen_3_s1_q};
      sum_3_s2_q <= sum_3_s1_q[0];
      sum_29_s2_q <= sum_29[0];
      sum_31_s2_q <= {1'b0, sum_29[8:1]} + {1'b0, chosen_6_s1_q};
      xor_34_s2_q <= xor_34_s1_q;
      xor_37_s2_q <= xor_37_s1_q;
      select_76_s2_q <= and_53_s1_q ? (or_56_s1_q | select_74) : select_74;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:66
  logic [10:0] chosen_7;
  assign chosen_7 = xor_14_s2_q ? {sum_24_s2_q, sum_21_s2_q, sum_s2_q} : {sum_31_s2_q, sum_29_s2_q, sum_3_s2_q};
  // hls/stages/interpolate.hpp:64
  logic [10:0] select_33;
  assign select_33 = swapped_y_s2_q ? {sum_24_s2_q, sum_21_s2_q, sum_s2_q} : {sum_31_s2_q, sum_29_s2_q, sum_3_s2_q};
  // hls/stages/interpolate.hpp:66
  logic [10:0] chosen_8;
  assign chosen_8 = xor_34_s2_q ? {sum_24_s2_q, sum_21_s2_q, sum_s2_q} : {sum_31_s2_q, sum_29_s2_q, sum_3_s2_q};
  // hls/stages/interpolate.hpp:67
  logic [11:0] sum_36;
  assign sum_36 = {1'b0, select_33} + {1'b0, chosen_8};
  // hls/stages/interpolate.hpp:66
  logic [10:0] chosen_9;
  assign chosen_9 = xor_37_s2_q ? {sum_24_s2_q, sum_21_s2_q, sum_s2_q} : {sum_31_s2_q, sum_29_s2_q, sum_3_s2_q};

  logic [7:0] left_s3_q;
  logic mask_s3_q;
  logic present_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic [10:0] chosen_7_s3_q;
  logic [10:0] sum_36_s3_q;
  logic [10:0] chosen_9_s3_q;
  logic or_77_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      left_s3_q <= left_s2_q;
      mask_s3_q <= mask_s2_q;
      present_s3_q <= present_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      chosen_7_s3_q <= chosen_7;
      sum_36_s3_q <= sum_36[11:1];
      chosen_9_s3_q <= chosen_9;
      or_77_s3_q <= ((left_s2_q == 8'hff) | (left_s2_q == 8'h0)) | select_76_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:55
  logic [11:0] sum_39;
  assign sum_39 = {1'b0, sum_36_s3_q} + {1'b0, chosen_9_s3_q};
  logic [11:0] sum_40;
  assign sum_40 = {1'b0, chosen_7_s3_q} + {1'b0, sum_39[11:1]};

  logic [7:0] left_s4_q;
  logic mask_s4_q;
  logic present_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic [8:0] sum_40_s4_q;
  logic or_77_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      left_s4_q <= left_s3_q;
      mask_s4_q <= mask_s3_q;
      present_s4_q <= present_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sum_40_s4_q <= sum_40[11:3];
      or_77_s4_q <= or_77_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:55
  logic [8:0] sum_41;
  assign sum_41 = sum_40_s4_q + 9'h1;

  logic [7:0] left_s5_q;
  logic mask_s5_q;
  logic present_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic [7:0] sum_41_s5_q;
  logic or_77_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      left_s5_q <= left_s4_q;
      mask_s5_q <= mask_s4_q;
      present_s5_q <= present_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      sum_41_s5_q <= sum_41[8:1];
      or_77_s5_q <= or_77_s4_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = left_s5_q;
  assign pixel_1_o = sum_41_s5_q;
  assign saturated_o = or_77_s5_q;
  assign mask_o = mask_s5_q;
  assign present_o = present_s5_q;
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
  assign unused_bits = ^{sum_68[0], sum_41[0], sum_40[2:0], sum_39[0], sum_36[0]};

endmodule
