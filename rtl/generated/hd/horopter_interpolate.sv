// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Interpolate<horopter::hls::profiles::hd>, hls/stages/interpolate.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 201 bits, memories 0 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;

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
  logic xor_21;
  assign xor_21 = wx_i[2] ^ swapped_x_i;
  logic [7:0] chosen_3;
  assign chosen_3 = xor_21 ? p11_i : p10_i;
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
  logic [7:0] chosen_6;
  assign chosen_6 = xor_21 ? p01_i : p00_i;
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

  logic swapped_y_s1_q;
  logic [7:0] left_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic xor_13_s1_q;
  logic [8:0] sum_s1_q;
  logic [7:0] chosen_2_s1_q;
  logic [7:0] chosen_3_s1_q;
  logic [8:0] sum_3_s1_q;
  logic [7:0] chosen_5_s1_q;
  logic [7:0] chosen_6_s1_q;
  logic xor_33_s1_q;
  logic xor_36_s1_q;
  logic and_52_s1_q;
  logic or_55_s1_q;
  logic and_57_s1_q;
  logic or_60_s1_q;
  logic and_62_s1_q;
  logic or_65_s1_q;
  logic and_69_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      swapped_y_s1_q <= swapped_y_i;
      left_s1_q <= left_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      xor_13_s1_q <= wy_i[2] ^ swapped_y_i;
      sum_s1_q <= sum;
      chosen_2_s1_q <= chosen_2;
      chosen_3_s1_q <= chosen_3;
      sum_3_s1_q <= sum_3;
      chosen_5_s1_q <= chosen_5;
      chosen_6_s1_q <= chosen_6;
      xor_33_s1_q <= wy_i[0] ^ swapped_y_i;
      xor_36_s1_q <= wy_i[1] ^ swapped_y_i;
      and_52_s1_q <= or_47 & or_51;
      or_55_s1_q <= (p00_i == 8'hff) | (p00_i == 8'h0);
      and_57_s1_q <= or_56 & or_51;
      or_60_s1_q <= (p01_i == 8'hff) | (p01_i == 8'h0);
      and_62_s1_q <= or_47 & or_61;
      or_65_s1_q <= (p10_i == 8'hff) | (p10_i == 8'h0);
      and_69_s1_q <= (or_56 & or_61) & (sum_67[7:1] == 7'h0);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:64
  logic [8:0] sum_20;
  assign sum_20 = {1'b0, sum_s1_q[8:1]} + {1'b0, chosen_2_s1_q};
  logic [8:0] sum_28;
  assign sum_28 = {1'b0, sum_3_s1_q[8:1]} + {1'b0, chosen_5_s1_q};
  // hls/stages/interpolate.hpp:61
  logic select_71;
  assign select_71 = and_62_s1_q ? (or_65_s1_q | and_69_s1_q) : and_69_s1_q;
  logic select_73;
  assign select_73 = and_57_s1_q ? (or_60_s1_q | select_71) : select_71;

  logic swapped_y_s2_q;
  logic [7:0] left_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic xor_13_s2_q;
  logic sum_s2_q;
  logic sum_20_s2_q;
  logic [8:0] sum_23_s2_q;
  logic sum_3_s2_q;
  logic sum_28_s2_q;
  logic [8:0] sum_30_s2_q;
  logic xor_33_s2_q;
  logic xor_36_s2_q;
  logic select_75_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      swapped_y_s2_q <= swapped_y_s1_q;
      left_s2_q <= left_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      xor_13_s2_q <= xor_13_s1_q;
      sum_s2_q <= sum_s1_q[0];
      sum_20_s2_q <= sum_20[0];
      sum_23_s2_q <= {1'b0, sum_20[8:1]} + {1'b0, chosen_3_s1_q};
      sum_3_s2_q <= sum_3_s1_q[0];
      sum_28_s2_q <= sum_28[0];
      sum_30_s2_q <= {1'b0, sum_28[8:1]} + {1'b0, chosen_6_s1_q};
      xor_33_s2_q <= xor_33_s1_q;
      xor_36_s2_q <= xor_36_s1_q;
      select_75_s2_q <= and_52_s1_q ? (or_55_s1_q | select_73) : select_73;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:63
  logic [10:0] chosen_7;
  assign chosen_7 = xor_13_s2_q ? {sum_23_s2_q, sum_20_s2_q, sum_s2_q} : {sum_30_s2_q, sum_28_s2_q, sum_3_s2_q};
  // hls/stages/interpolate.hpp:61
  logic [10:0] select_32;
  assign select_32 = swapped_y_s2_q ? {sum_23_s2_q, sum_20_s2_q, sum_s2_q} : {sum_30_s2_q, sum_28_s2_q, sum_3_s2_q};
  // hls/stages/interpolate.hpp:63
  logic [10:0] chosen_8;
  assign chosen_8 = xor_33_s2_q ? {sum_23_s2_q, sum_20_s2_q, sum_s2_q} : {sum_30_s2_q, sum_28_s2_q, sum_3_s2_q};
  // hls/stages/interpolate.hpp:64
  logic [11:0] sum_35;
  assign sum_35 = {1'b0, select_32} + {1'b0, chosen_8};
  // hls/stages/interpolate.hpp:63
  logic [10:0] chosen_9;
  assign chosen_9 = xor_36_s2_q ? {sum_23_s2_q, sum_20_s2_q, sum_s2_q} : {sum_30_s2_q, sum_28_s2_q, sum_3_s2_q};

  logic [7:0] left_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic [10:0] chosen_7_s3_q;
  logic [10:0] sum_35_s3_q;
  logic [10:0] chosen_9_s3_q;
  logic or_76_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      left_s3_q <= left_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      chosen_7_s3_q <= chosen_7;
      sum_35_s3_q <= sum_35[11:1];
      chosen_9_s3_q <= chosen_9;
      or_76_s3_q <= ((left_s2_q == 8'hff) | (left_s2_q == 8'h0)) | select_75_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:52
  logic [11:0] sum_38;
  assign sum_38 = {1'b0, sum_35_s3_q} + {1'b0, chosen_9_s3_q};
  logic [11:0] sum_39;
  assign sum_39 = {1'b0, chosen_7_s3_q} + {1'b0, sum_38[11:1]};

  logic [7:0] left_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic [8:0] sum_39_s4_q;
  logic or_76_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      left_s4_q <= left_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sum_39_s4_q <= sum_39[11:3];
      or_76_s4_q <= or_76_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/interpolate.hpp:52
  logic [8:0] sum_40;
  assign sum_40 = sum_39_s4_q + 9'h1;

  logic [7:0] left_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic [7:0] sum_40_s5_q;
  logic or_76_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      left_s5_q <= left_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      sum_40_s5_q <= sum_40[8:1];
      or_76_s5_q <= or_76_s4_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = left_s5_q;
  assign pixel_1_o = sum_40_s5_q;
  assign saturated_o = or_76_s5_q;
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
  assign unused_bits = ^{sum_67[0], sum_40[0], sum_39[2:0], sum_38[0], sum_35[0]};

endmodule
