// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Direction<horopter::hls::profiles::hd>, hls/stages/direction.hpp. Do not edit.
//
// Latency 10 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 580 bits, memories 0 bits.
module horopter_direction (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic signed [10:0] gx_0_i,
  input  logic signed [10:0] gx_1_i,
  input  logic signed [10:0] gy_0_i,
  input  logic signed [10:0] gy_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  output logic valid_o,
  output logic [7:0] direction_0_o,
  output logic [7:0] direction_1_o,
  output logic [7:0] magnitude_0_o,
  output logic [7:0] magnitude_1_o,
  output logic saturated_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;
  assign s9_en = en_i & valid_s9_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:43
  logic [9:0] x;
  assign x = {9'h0, gx_0_i[10]} + (gx_0_i[9:0] ^ {10{gx_0_i[10]}});
  // hls/stages/direction.hpp:44
  logic [9:0] y;
  assign y = {9'h0, gy_0_i[10]} + (gy_0_i[9:0] ^ {10{gy_0_i[10]}});
  // hls/stages/direction.hpp:43
  logic [9:0] x_2;
  assign x_2 = {9'h0, gx_1_i[10]} + (gx_1_i[9:0] ^ {10{gx_1_i[10]}});
  // hls/stages/direction.hpp:44
  logic [9:0] y_2;
  assign y_2 = {9'h0, gy_1_i[10]} + (gy_1_i[9:0] ^ {10{gy_1_i[10]}});

  logic gx_0_s1_q;
  logic gx_1_s1_q;
  logic gy_0_s1_q;
  logic gy_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic [9:0] x_s1_q;
  logic [9:0] y_s1_q;
  logic [9:0] x_2_s1_q;
  logic [9:0] y_2_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      gx_0_s1_q <= gx_0_i[10];
      gx_1_s1_q <= gx_1_i[10];
      gy_0_s1_q <= gy_0_i[10];
      gy_1_s1_q <= gy_1_i[10];
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      x_s1_q <= x;
      y_s1_q <= y;
      x_2_s1_q <= x_2;
      y_2_s1_q <= y_2;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:46
  logic less_13;
  assign less_13 = x_s1_q < y_s1_q;
  logic [9:0] larger;
  assign larger = less_13 ? y_s1_q : x_s1_q;
  // hls/stages/direction.hpp:47
  logic [9:0] smaller;
  assign smaller = (y_s1_q < x_s1_q) ? y_s1_q : x_s1_q;
  // hls/stages/direction.hpp:46
  logic less_45;
  assign less_45 = x_2_s1_q < y_2_s1_q;
  logic [9:0] larger_2;
  assign larger_2 = less_45 ? y_2_s1_q : x_2_s1_q;
  // hls/stages/direction.hpp:47
  logic [9:0] smaller_2;
  assign smaller_2 = (y_2_s1_q < x_2_s1_q) ? y_2_s1_q : x_2_s1_q;

  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic less_13_s2_q;
  logic xor_16_s2_q;
  logic [9:0] larger_s2_q;
  logic [9:0] smaller_s2_q;
  logic select_39_s2_q;
  logic less_45_s2_q;
  logic xor_48_s2_q;
  logic [9:0] larger_2_s2_q;
  logic [9:0] smaller_2_s2_q;
  logic select_71_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      less_13_s2_q <= less_13;
      xor_16_s2_q <= less_13 ^ (~(gx_0_s1_q ^ gy_0_s1_q));
      larger_s2_q <= larger;
      smaller_s2_q <= smaller;
      select_39_s2_q <= less_13 ? gy_0_s1_q : gx_0_s1_q;
      less_45_s2_q <= less_45;
      xor_48_s2_q <= less_45 ^ (~(gx_1_s1_q ^ gy_1_s1_q));
      larger_2_s2_q <= larger_2;
      smaller_2_s2_q <= smaller_2;
      select_71_s2_q <= less_45 ? gy_1_s1_q : gx_1_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:49
  logic [10:0] sum_73;
  assign sum_73 = {1'b0, smaller_s2_q} + {2'h0, smaller_s2_q[9:1]};
  logic [9:0] sum_74;
  assign sum_74 = sum_73[10:1] + 10'h1;
  logic [10:0] sum_78;
  assign sum_78 = {1'b0, smaller_2_s2_q} + {2'h0, smaller_2_s2_q[9:1]};
  logic [9:0] sum_79;
  assign sum_79 = sum_78[10:1] + 10'h1;

  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic less_13_s3_q;
  logic xor_16_s3_q;
  logic [9:0] larger_s3_q;
  logic [9:0] difference_20_s3_q;
  logic select_39_s3_q;
  logic less_45_s3_q;
  logic xor_48_s3_q;
  logic [9:0] larger_2_s3_q;
  logic [9:0] difference_52_s3_q;
  logic select_71_s3_q;
  logic [8:0] sum_74_s3_q;
  logic [8:0] sum_79_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      less_13_s3_q <= less_13_s2_q;
      xor_16_s3_q <= xor_16_s2_q;
      larger_s3_q <= larger_s2_q;
      difference_20_s3_q <= {1'b0, larger_s2_q[9:1]} - smaller_s2_q;
      select_39_s3_q <= select_39_s2_q;
      less_45_s3_q <= less_45_s2_q;
      xor_48_s3_q <= xor_48_s2_q;
      larger_2_s3_q <= larger_2_s2_q;
      difference_52_s3_q <= {1'b0, larger_2_s2_q[9:1]} - smaller_2_s2_q;
      select_71_s3_q <= select_71_s2_q;
      sum_74_s3_q <= sum_74[9:1];
      sum_79_s3_q <= sum_79[9:1];
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_21;
  assign not_21 = ~difference_20_s3_q[9];
  logic [9:0] xor_22;
  assign xor_22 = larger_s3_q ^ {10{not_21}};
  logic [10:0] sum_23;
  assign sum_23 = {difference_20_s3_q[8:0], larger_s3_q[0], not_21} + {not_21, xor_22};
  logic not_53;
  assign not_53 = ~difference_52_s3_q[9];
  logic [9:0] xor_54;
  assign xor_54 = larger_2_s3_q ^ {10{not_53}};
  logic [10:0] sum_55;
  assign sum_55 = {difference_52_s3_q[8:0], larger_2_s3_q[0], not_53} + {not_53, xor_54};
  // hls/stages/direction.hpp:49
  logic [10:0] sum_75;
  assign sum_75 = {1'b0, larger_s3_q} + {2'h0, sum_74_s3_q};
  logic [10:0] select_77;
  assign select_77 = (sum_75[10:8] == 3'h0) ? sum_75 : 11'hff;
  logic [10:0] sum_80;
  assign sum_80 = {1'b0, larger_2_s3_q} + {2'h0, sum_79_s3_q};
  logic [8:0] select_82;
  assign select_82 = (sum_80[10:8] == 3'h0) ? sum_80[8:0] : 9'hff;

  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic less_13_s4_q;
  logic xor_16_s4_q;
  logic [9:0] larger_s4_q;
  logic difference_20_s4_q;
  logic [10:0] sum_23_s4_q;
  logic select_39_s4_q;
  logic less_45_s4_q;
  logic xor_48_s4_q;
  logic [9:0] larger_2_s4_q;
  logic difference_52_s4_q;
  logic [10:0] sum_55_s4_q;
  logic select_71_s4_q;
  logic [7:0] select_77_s4_q;
  logic [4:0] select_82_s4_q;
  logic [2:0] or_83_s4_q;
  logic or_84_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      less_13_s4_q <= less_13_s3_q;
      xor_16_s4_q <= xor_16_s3_q;
      larger_s4_q <= larger_s3_q;
      difference_20_s4_q <= difference_20_s3_q[9];
      sum_23_s4_q <= sum_23;
      select_39_s4_q <= select_39_s3_q;
      less_45_s4_q <= less_45_s3_q;
      xor_48_s4_q <= xor_48_s3_q;
      larger_2_s4_q <= larger_2_s3_q;
      difference_52_s4_q <= difference_52_s3_q[9];
      sum_55_s4_q <= sum_55;
      select_71_s4_q <= select_71_s3_q;
      select_77_s4_q <= select_77[7:0];
      select_82_s4_q <= select_82[7:3];
      or_83_s4_q <= select_77[10:8] | select_82[2:0];
      or_84_s4_q <= saturated_s3_q | select_82[8];
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_24;
  assign not_24 = ~sum_23_s4_q[10];
  logic [9:0] xor_25;
  assign xor_25 = larger_s4_q ^ {10{not_24}};
  logic not_56;
  assign not_56 = ~sum_55_s4_q[10];
  logic [9:0] xor_57;
  assign xor_57 = larger_2_s4_q ^ {10{not_56}};

  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic less_13_s5_q;
  logic xor_16_s5_q;
  logic [9:0] larger_s5_q;
  logic difference_20_s5_q;
  logic sum_23_s5_q;
  logic [10:0] sum_26_s5_q;
  logic select_39_s5_q;
  logic less_45_s5_q;
  logic xor_48_s5_q;
  logic [9:0] larger_2_s5_q;
  logic difference_52_s5_q;
  logic sum_55_s5_q;
  logic [10:0] sum_58_s5_q;
  logic select_71_s5_q;
  logic [7:0] select_77_s5_q;
  logic [4:0] select_82_s5_q;
  logic [2:0] or_83_s5_q;
  logic or_84_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      less_13_s5_q <= less_13_s4_q;
      xor_16_s5_q <= xor_16_s4_q;
      larger_s5_q <= larger_s4_q;
      difference_20_s5_q <= difference_20_s4_q;
      sum_23_s5_q <= sum_23_s4_q[10];
      sum_26_s5_q <= {sum_23_s4_q[9:0], not_24} + {not_24, xor_25};
      select_39_s5_q <= select_39_s4_q;
      less_45_s5_q <= less_45_s4_q;
      xor_48_s5_q <= xor_48_s4_q;
      larger_2_s5_q <= larger_2_s4_q;
      difference_52_s5_q <= difference_52_s4_q;
      sum_55_s5_q <= sum_55_s4_q[10];
      sum_58_s5_q <= {sum_55_s4_q[9:0], not_56} + {not_56, xor_57};
      select_71_s5_q <= select_71_s4_q;
      select_77_s5_q <= select_77_s4_q;
      select_82_s5_q <= select_82_s4_q;
      or_83_s5_q <= or_83_s4_q;
      or_84_s5_q <= or_84_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_27;
  assign not_27 = ~sum_26_s5_q[10];
  logic [9:0] xor_28;
  assign xor_28 = larger_s5_q ^ {10{not_27}};
  logic not_59;
  assign not_59 = ~sum_58_s5_q[10];
  logic [9:0] xor_60;
  assign xor_60 = larger_2_s5_q ^ {10{not_59}};

  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic less_13_s6_q;
  logic xor_16_s6_q;
  logic [9:0] larger_s6_q;
  logic difference_20_s6_q;
  logic sum_23_s6_q;
  logic sum_26_s6_q;
  logic [10:0] sum_29_s6_q;
  logic select_39_s6_q;
  logic less_45_s6_q;
  logic xor_48_s6_q;
  logic [9:0] larger_2_s6_q;
  logic difference_52_s6_q;
  logic sum_55_s6_q;
  logic sum_58_s6_q;
  logic [10:0] sum_61_s6_q;
  logic select_71_s6_q;
  logic [7:0] select_77_s6_q;
  logic [4:0] select_82_s6_q;
  logic [2:0] or_83_s6_q;
  logic or_84_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      less_13_s6_q <= less_13_s5_q;
      xor_16_s6_q <= xor_16_s5_q;
      larger_s6_q <= larger_s5_q;
      difference_20_s6_q <= difference_20_s5_q;
      sum_23_s6_q <= sum_23_s5_q;
      sum_26_s6_q <= sum_26_s5_q[10];
      sum_29_s6_q <= {sum_26_s5_q[9:0], not_27} + {not_27, xor_28};
      select_39_s6_q <= select_39_s5_q;
      less_45_s6_q <= less_45_s5_q;
      xor_48_s6_q <= xor_48_s5_q;
      larger_2_s6_q <= larger_2_s5_q;
      difference_52_s6_q <= difference_52_s5_q;
      sum_55_s6_q <= sum_55_s5_q;
      sum_58_s6_q <= sum_58_s5_q[10];
      sum_61_s6_q <= {sum_58_s5_q[9:0], not_59} + {not_59, xor_60};
      select_71_s6_q <= select_71_s5_q;
      select_77_s6_q <= select_77_s5_q;
      select_82_s6_q <= select_82_s5_q;
      or_83_s6_q <= or_83_s5_q;
      or_84_s6_q <= or_84_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_30;
  assign not_30 = ~sum_29_s6_q[10];
  logic [9:0] xor_31;
  assign xor_31 = larger_s6_q ^ {10{not_30}};
  logic not_62;
  assign not_62 = ~sum_61_s6_q[10];
  logic [9:0] xor_63;
  assign xor_63 = larger_2_s6_q ^ {10{not_62}};

  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic less_13_s7_q;
  logic xor_16_s7_q;
  logic [9:0] larger_s7_q;
  logic difference_20_s7_q;
  logic sum_23_s7_q;
  logic sum_26_s7_q;
  logic sum_29_s7_q;
  logic [10:0] sum_32_s7_q;
  logic select_39_s7_q;
  logic less_45_s7_q;
  logic xor_48_s7_q;
  logic [9:0] larger_2_s7_q;
  logic difference_52_s7_q;
  logic sum_55_s7_q;
  logic sum_58_s7_q;
  logic sum_61_s7_q;
  logic [10:0] sum_64_s7_q;
  logic select_71_s7_q;
  logic [7:0] select_77_s7_q;
  logic [4:0] select_82_s7_q;
  logic [2:0] or_83_s7_q;
  logic or_84_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      less_13_s7_q <= less_13_s6_q;
      xor_16_s7_q <= xor_16_s6_q;
      larger_s7_q <= larger_s6_q;
      difference_20_s7_q <= difference_20_s6_q;
      sum_23_s7_q <= sum_23_s6_q;
      sum_26_s7_q <= sum_26_s6_q;
      sum_29_s7_q <= sum_29_s6_q[10];
      sum_32_s7_q <= {sum_29_s6_q[9:0], not_30} + {not_30, xor_31};
      select_39_s7_q <= select_39_s6_q;
      less_45_s7_q <= less_45_s6_q;
      xor_48_s7_q <= xor_48_s6_q;
      larger_2_s7_q <= larger_2_s6_q;
      difference_52_s7_q <= difference_52_s6_q;
      sum_55_s7_q <= sum_55_s6_q;
      sum_58_s7_q <= sum_58_s6_q;
      sum_61_s7_q <= sum_61_s6_q[10];
      sum_64_s7_q <= {sum_61_s6_q[9:0], not_62} + {not_62, xor_63};
      select_71_s7_q <= select_71_s6_q;
      select_77_s7_q <= select_77_s6_q;
      select_82_s7_q <= select_82_s6_q;
      or_83_s7_q <= or_83_s6_q;
      or_84_s7_q <= or_84_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_33;
  assign not_33 = ~sum_32_s7_q[10];
  logic [9:0] xor_34;
  assign xor_34 = larger_s7_q ^ {10{not_33}};
  logic [10:0] sum_35;
  assign sum_35 = {sum_32_s7_q[9:0], not_33} + {not_33, xor_34};
  logic not_65;
  assign not_65 = ~sum_64_s7_q[10];
  logic [9:0] xor_66;
  assign xor_66 = larger_2_s7_q ^ {10{not_65}};
  logic [10:0] sum_67;
  assign sum_67 = {sum_64_s7_q[9:0], not_65} + {not_65, xor_66};

  logic mask_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic less_13_s8_q;
  logic xor_16_s8_q;
  logic difference_20_s8_q;
  logic sum_23_s8_q;
  logic sum_26_s8_q;
  logic sum_29_s8_q;
  logic sum_32_s8_q;
  logic sum_35_s8_q;
  logic select_39_s8_q;
  logic less_45_s8_q;
  logic xor_48_s8_q;
  logic difference_52_s8_q;
  logic sum_55_s8_q;
  logic sum_58_s8_q;
  logic sum_61_s8_q;
  logic sum_64_s8_q;
  logic sum_67_s8_q;
  logic select_71_s8_q;
  logic [7:0] select_77_s8_q;
  logic [4:0] select_82_s8_q;
  logic [2:0] or_83_s8_q;
  logic or_84_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      less_13_s8_q <= less_13_s7_q;
      xor_16_s8_q <= xor_16_s7_q;
      difference_20_s8_q <= difference_20_s7_q;
      sum_23_s8_q <= sum_23_s7_q;
      sum_26_s8_q <= sum_26_s7_q;
      sum_29_s8_q <= sum_29_s7_q;
      sum_32_s8_q <= sum_32_s7_q[10];
      sum_35_s8_q <= sum_35[10];
      select_39_s8_q <= select_39_s7_q;
      less_45_s8_q <= less_45_s7_q;
      xor_48_s8_q <= xor_48_s7_q;
      difference_52_s8_q <= difference_52_s7_q;
      sum_55_s8_q <= sum_55_s7_q;
      sum_58_s8_q <= sum_58_s7_q;
      sum_61_s8_q <= sum_61_s7_q;
      sum_64_s8_q <= sum_64_s7_q[10];
      sum_67_s8_q <= sum_67[10];
      select_71_s8_q <= select_71_s7_q;
      select_77_s8_q <= select_77_s7_q;
      select_82_s8_q <= select_82_s7_q;
      or_83_s8_q <= or_83_s7_q;
      or_84_s8_q <= or_84_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic [5:0] angle;  // table arctangent_table
  always_comb begin
    case ({difference_20_s8_q, sum_23_s8_q, sum_26_s8_q, sum_29_s8_q, sum_32_s8_q, sum_35_s8_q})
      6'd1: angle = 6'h1;
      6'd2: angle = 6'h2;
      6'd3: angle = 6'h2;
      6'd4: angle = 6'h3;
      6'd5: angle = 6'h3;
      6'd6: angle = 6'h4;
      6'd7: angle = 6'h5;
      6'd8: angle = 6'h5;
      6'd9: angle = 6'h6;
      6'd10: angle = 6'h7;
      6'd11: angle = 6'h7;
      6'd12: angle = 6'h8;
      6'd13: angle = 6'h8;
      6'd14: angle = 6'h9;
      6'd15: angle = 6'ha;
      6'd16: angle = 6'ha;
      6'd17: angle = 6'hb;
      6'd18: angle = 6'hb;
      6'd19: angle = 6'hc;
      6'd20: angle = 6'hd;
      6'd21: angle = 6'hd;
      6'd22: angle = 6'he;
      6'd23: angle = 6'he;
      6'd24: angle = 6'hf;
      6'd25: angle = 6'hf;
      6'd26: angle = 6'h10;
      6'd27: angle = 6'h11;
      6'd28: angle = 6'h11;
      6'd29: angle = 6'h12;
      6'd30: angle = 6'h12;
      6'd31: angle = 6'h13;
      6'd32: angle = 6'h13;
      6'd33: angle = 6'h14;
      6'd34: angle = 6'h14;
      6'd35: angle = 6'h15;
      6'd36: angle = 6'h15;
      6'd37: angle = 6'h16;
      6'd38: angle = 6'h16;
      6'd39: angle = 6'h17;
      6'd40: angle = 6'h17;
      6'd41: angle = 6'h17;
      6'd42: angle = 6'h18;
      6'd43: angle = 6'h18;
      6'd44: angle = 6'h19;
      6'd45: angle = 6'h19;
      6'd46: angle = 6'h1a;
      6'd47: angle = 6'h1a;
      6'd48: angle = 6'h1a;
      6'd49: angle = 6'h1b;
      6'd50: angle = 6'h1b;
      6'd51: angle = 6'h1c;
      6'd52: angle = 6'h1c;
      6'd53: angle = 6'h1c;
      6'd54: angle = 6'h1d;
      6'd55: angle = 6'h1d;
      6'd56: angle = 6'h1d;
      6'd57: angle = 6'h1e;
      6'd58: angle = 6'h1e;
      6'd59: angle = 6'h1f;
      6'd60: angle = 6'h1f;
      6'd61: angle = 6'h1f;
      6'd62: angle = 6'h20;
      6'd63: angle = 6'h20;
      default: angle = 6'h0;
    endcase
  end
  logic [5:0] angle_2;  // table arctangent_table
  always_comb begin
    case ({difference_52_s8_q, sum_55_s8_q, sum_58_s8_q, sum_61_s8_q, sum_64_s8_q, sum_67_s8_q})
      6'd1: angle_2 = 6'h1;
      6'd2: angle_2 = 6'h2;
      6'd3: angle_2 = 6'h2;
      6'd4: angle_2 = 6'h3;
      6'd5: angle_2 = 6'h3;
      6'd6: angle_2 = 6'h4;
      6'd7: angle_2 = 6'h5;
      6'd8: angle_2 = 6'h5;
      6'd9: angle_2 = 6'h6;
      6'd10: angle_2 = 6'h7;
      6'd11: angle_2 = 6'h7;
      6'd12: angle_2 = 6'h8;
      6'd13: angle_2 = 6'h8;
      6'd14: angle_2 = 6'h9;
      6'd15: angle_2 = 6'ha;
      6'd16: angle_2 = 6'ha;
      6'd17: angle_2 = 6'hb;
      6'd18: angle_2 = 6'hb;
      6'd19: angle_2 = 6'hc;
      6'd20: angle_2 = 6'hd;
      6'd21: angle_2 = 6'hd;
      6'd22: angle_2 = 6'he;
      6'd23: angle_2 = 6'he;
      6'd24: angle_2 = 6'hf;
      6'd25: angle_2 = 6'hf;
      6'd26: angle_2 = 6'h10;
      6'd27: angle_2 = 6'h11;
      6'd28: angle_2 = 6'h11;
      6'd29: angle_2 = 6'h12;
      6'd30: angle_2 = 6'h12;
      6'd31: angle_2 = 6'h13;
      6'd32: angle_2 = 6'h13;
      6'd33: angle_2 = 6'h14;
      6'd34: angle_2 = 6'h14;
      6'd35: angle_2 = 6'h15;
      6'd36: angle_2 = 6'h15;
      6'd37: angle_2 = 6'h16;
      6'd38: angle_2 = 6'h16;
      6'd39: angle_2 = 6'h17;
      6'd40: angle_2 = 6'h17;
      6'd41: angle_2 = 6'h17;
      6'd42: angle_2 = 6'h18;
      6'd43: angle_2 = 6'h18;
      6'd44: angle_2 = 6'h19;
      6'd45: angle_2 = 6'h19;
      6'd46: angle_2 = 6'h1a;
      6'd47: angle_2 = 6'h1a;
      6'd48: angle_2 = 6'h1a;
      6'd49: angle_2 = 6'h1b;
      6'd50: angle_2 = 6'h1b;
      6'd51: angle_2 = 6'h1c;
      6'd52: angle_2 = 6'h1c;
      6'd53: angle_2 = 6'h1c;
      6'd54: angle_2 = 6'h1d;
      6'd55: angle_2 = 6'h1d;
      6'd56: angle_2 = 6'h1d;
      6'd57: angle_2 = 6'h1e;
      6'd58: angle_2 = 6'h1e;
      6'd59: angle_2 = 6'h1f;
      6'd60: angle_2 = 6'h1f;
      6'd61: angle_2 = 6'h1f;
      6'd62: angle_2 = 6'h20;
      6'd63: angle_2 = 6'h20;
      default: angle_2 = 6'h0;
    endcase
  end

  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic less_13_s9_q;
  logic xor_16_s9_q;
  logic [5:0] angle_s9_q;
  logic select_39_s9_q;
  logic less_45_s9_q;
  logic xor_48_s9_q;
  logic [5:0] angle_2_s9_q;
  logic select_71_s9_q;
  logic [7:0] select_77_s9_q;
  logic [4:0] select_82_s9_q;
  logic [2:0] or_83_s9_q;
  logic or_84_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      less_13_s9_q <= less_13_s8_q;
      xor_16_s9_q <= xor_16_s8_q;
      angle_s9_q <= angle;
      select_39_s9_q <= select_39_s8_q;
      less_45_s9_q <= less_45_s8_q;
      xor_48_s9_q <= xor_48_s8_q;
      angle_2_s9_q <= angle_2;
      select_71_s9_q <= select_71_s8_q;
      select_77_s9_q <= select_77_s8_q;
      select_82_s9_q <= select_82_s8_q;
      or_83_s9_q <= or_83_s8_q;
      or_84_s9_q <= or_84_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:69
  logic [6:0] select_38;
  assign select_38 = xor_16_s9_q ? {1'b0, angle_s9_q} : (7'h0 - {1'b0, angle_s9_q});
  logic [6:0] select_70;
  assign select_70 = xor_48_s9_q ? {1'b0, angle_2_s9_q} : (7'h0 - {1'b0, angle_2_s9_q});

  logic mask_s10_q;
  logic marks_first_s10_q;
  logic marks_last_s10_q;
  logic [5:0] select_38_s10_q;
  logic [1:0] sum_40_s10_q;
  logic [5:0] select_70_s10_q;
  logic [1:0] sum_72_s10_q;
  logic [7:0] select_77_s10_q;
  logic [4:0] select_82_s10_q;
  logic [2:0] or_83_s10_q;
  logic or_84_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      mask_s10_q <= mask_s9_q;
      marks_first_s10_q <= marks_first_s9_q;
      marks_last_s10_q <= marks_last_s9_q;
      select_38_s10_q <= select_38[5:0];
      sum_40_s10_q <= {select_39_s9_q, less_13_s9_q} + {2{select_38[6]}};
      select_70_s10_q <= select_70[5:0];
      sum_72_s10_q <= {select_71_s9_q, less_45_s9_q} + {2{select_70[6]}};
      select_77_s10_q <= select_77_s9_q;
      select_82_s10_q <= select_82_s9_q;
      or_83_s10_q <= or_83_s9_q;
      or_84_s10_q <= or_84_s9_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign direction_0_o = {sum_40_s10_q, select_38_s10_q};
  assign direction_1_o = {sum_72_s10_q, select_70_s10_q};
  assign magnitude_0_o = select_77_s10_q;
  assign magnitude_1_o = {select_82_s10_q, or_83_s10_q};
  assign saturated_o = or_84_s10_q;
  assign mask_o = mask_s10_q;
  assign marks_first_o = marks_first_s10_q;
  assign marks_last_o = marks_last_s10_q;
  assign valid_o = valid_s10_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
      valid_s7_q <= 1'b0;
      valid_s8_q <= 1'b0;
      valid_s9_q <= 1'b0;
      valid_s10_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
      valid_s8_q <= valid_s7_q;
      valid_s9_q <= valid_s8_q;
      valid_s10_q <= valid_s9_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_79[0], sum_78[0], sum_74[0], sum_73[0], sum_67[9:0], sum_35[9:0]};

endmodule
