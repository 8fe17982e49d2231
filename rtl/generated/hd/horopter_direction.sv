// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Direction<horopter::hls::profiles::hd>, hls/stages/direction.hpp. Do not edit.
//
// Latency 10 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 600 bits, memories 0 bits.
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
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [7:0] direction_0_o,
  output logic [7:0] direction_1_o,
  output logic [7:0] magnitude_0_o,
  output logic [7:0] magnitude_1_o,
  output logic saturated_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q;
  logic s9_en;
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
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic [9:0] x_s1_q;
  logic [9:0] y_s1_q;
  logic [9:0] x_2_s1_q;
  logic [9:0] y_2_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      gx_0_s1_q <= gx_0_i[10];
      gx_1_s1_q <= gx_1_i[10];
      gy_0_s1_q <= gy_0_i[10];
      gy_1_s1_q <= gy_1_i[10];
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      x_s1_q <= x;
      y_s1_q <= y;
      x_2_s1_q <= x_2;
      y_2_s1_q <= y_2;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:46
  logic less_15;
  assign less_15 = x_s1_q < y_s1_q;
  logic [9:0] larger;
  assign larger = less_15 ? y_s1_q : x_s1_q;
  // hls/stages/direction.hpp:47
  logic [9:0] smaller;
  assign smaller = (y_s1_q < x_s1_q) ? y_s1_q : x_s1_q;
  // hls/stages/direction.hpp:46
  logic less_47;
  assign less_47 = x_2_s1_q < y_2_s1_q;
  logic [9:0] larger_2;
  assign larger_2 = less_47 ? y_2_s1_q : x_2_s1_q;
  // hls/stages/direction.hpp:47
  logic [9:0] smaller_2;
  assign smaller_2 = (y_2_s1_q < x_2_s1_q) ? y_2_s1_q : x_2_s1_q;

  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic less_15_s2_q;
  logic xor_18_s2_q;
  logic [9:0] larger_s2_q;
  logic [9:0] smaller_s2_q;
  logic select_41_s2_q;
  logic less_47_s2_q;
  logic xor_50_s2_q;
  logic [9:0] larger_2_s2_q;
  logic [9:0] smaller_2_s2_q;
  logic select_73_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      less_15_s2_q <= less_15;
      xor_18_s2_q <= less_15 ^ (~(gx_0_s1_q ^ gy_0_s1_q));
      larger_s2_q <= larger;
      smaller_s2_q <= smaller;
      select_41_s2_q <= less_15 ? gy_0_s1_q : gx_0_s1_q;
      less_47_s2_q <= less_47;
      xor_50_s2_q <= less_47 ^ (~(gx_1_s1_q ^ gy_1_s1_q));
      larger_2_s2_q <= larger_2;
      smaller_2_s2_q <= smaller_2;
      select_73_s2_q <= less_47 ? gy_1_s1_q : gx_1_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:49
  logic [10:0] sum_75;
  assign sum_75 = {1'b0, smaller_s2_q} + {2'h0, smaller_s2_q[9:1]};
  logic [9:0] sum_76;
  assign sum_76 = sum_75[10:1] + 10'h1;
  logic [10:0] sum_80;
  assign sum_80 = {1'b0, smaller_2_s2_q} + {2'h0, smaller_2_s2_q[9:1]};
  logic [9:0] sum_81;
  assign sum_81 = sum_80[10:1] + 10'h1;

  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic less_15_s3_q;
  logic xor_18_s3_q;
  logic [9:0] larger_s3_q;
  logic [9:0] difference_22_s3_q;
  logic select_41_s3_q;
  logic less_47_s3_q;
  logic xor_50_s3_q;
  logic [9:0] larger_2_s3_q;
  logic [9:0] difference_54_s3_q;
  logic select_73_s3_q;
  logic [8:0] sum_76_s3_q;
  logic [8:0] sum_81_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      less_15_s3_q <= less_15_s2_q;
      xor_18_s3_q <= xor_18_s2_q;
      larger_s3_q <= larger_s2_q;
      difference_22_s3_q <= {1'b0, larger_s2_q[9:1]} - smaller_s2_q;
      select_41_s3_q <= select_41_s2_q;
      less_47_s3_q <= less_47_s2_q;
      xor_50_s3_q <= xor_50_s2_q;
      larger_2_s3_q <= larger_2_s2_q;
      difference_54_s3_q <= {1'b0, larger_2_s2_q[9:1]} - smaller_2_s2_q;
      select_73_s3_q <= select_73_s2_q;
      sum_76_s3_q <= sum_76[9:1];
      sum_81_s3_q <= sum_81[9:1];
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_23;
  assign not_23 = ~difference_22_s3_q[9];
  logic [9:0] xor_24;
  assign xor_24 = larger_s3_q ^ {10{not_23}};
  logic [10:0] sum_25;
  assign sum_25 = {difference_22_s3_q[8:0], larger_s3_q[0], not_23} + {not_23, xor_24};
  logic not_55;
  assign not_55 = ~difference_54_s3_q[9];
  logic [9:0] xor_56;
  assign xor_56 = larger_2_s3_q ^ {10{not_55}};
  logic [10:0] sum_57;
  assign sum_57 = {difference_54_s3_q[8:0], larger_2_s3_q[0], not_55} + {not_55, xor_56};
  // hls/stages/direction.hpp:49
  logic [10:0] sum_77;
  assign sum_77 = {1'b0, larger_s3_q} + {2'h0, sum_76_s3_q};
  logic [10:0] sum_82;
  assign sum_82 = {1'b0, larger_2_s3_q} + {2'h0, sum_81_s3_q};

  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic less_15_s4_q;
  logic xor_18_s4_q;
  logic [9:0] larger_s4_q;
  logic difference_22_s4_q;
  logic [10:0] sum_25_s4_q;
  logic select_41_s4_q;
  logic less_47_s4_q;
  logic xor_50_s4_q;
  logic [9:0] larger_2_s4_q;
  logic difference_54_s4_q;
  logic [10:0] sum_57_s4_q;
  logic select_73_s4_q;
  logic [7:0] select_79_s4_q;
  logic [7:0] select_84_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      less_15_s4_q <= less_15_s3_q;
      xor_18_s4_q <= xor_18_s3_q;
      larger_s4_q <= larger_s3_q;
      difference_22_s4_q <= difference_22_s3_q[9];
      sum_25_s4_q <= sum_25;
      select_41_s4_q <= select_41_s3_q;
      less_47_s4_q <= less_47_s3_q;
      xor_50_s4_q <= xor_50_s3_q;
      larger_2_s4_q <= larger_2_s3_q;
      difference_54_s4_q <= difference_54_s3_q[9];
      sum_57_s4_q <= sum_57;
      select_73_s4_q <= select_73_s3_q;
      select_79_s4_q <= (sum_77[10:8] == 3'h0) ? sum_77[7:0] : 8'hff;
      select_84_s4_q <= (sum_82[10:8] == 3'h0) ? sum_82[7:0] : 8'hff;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_26;
  assign not_26 = ~sum_25_s4_q[10];
  logic [9:0] xor_27;
  assign xor_27 = larger_s4_q ^ {10{not_26}};
  logic not_58;
  assign not_58 = ~sum_57_s4_q[10];
  logic [9:0] xor_59;
  assign xor_59 = larger_2_s4_q ^ {10{not_58}};

  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic less_15_s5_q;
  logic xor_18_s5_q;
  logic [9:0] larger_s5_q;
  logic difference_22_s5_q;
  logic sum_25_s5_q;
  logic [10:0] sum_28_s5_q;
  logic select_41_s5_q;
  logic less_47_s5_q;
  logic xor_50_s5_q;
  logic [9:0] larger_2_s5_q;
  logic difference_54_s5_q;
  logic sum_57_s5_q;
  logic [10:0] sum_60_s5_q;
  logic select_73_s5_q;
  logic [7:0] select_79_s5_q;
  logic [7:0] select_84_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      less_15_s5_q <= less_15_s4_q;
      xor_18_s5_q <= xor_18_s4_q;
      larger_s5_q <= larger_s4_q;
      difference_22_s5_q <= difference_22_s4_q;
      sum_25_s5_q <= sum_25_s4_q[10];
      sum_28_s5_q <= {sum_25_s4_q[9:0], not_26} + {not_26, xor_27};
      select_41_s5_q <= select_41_s4_q;
      less_47_s5_q <= less_47_s4_q;
      xor_50_s5_q <= xor_50_s4_q;
      larger_2_s5_q <= larger_2_s4_q;
      difference_54_s5_q <= difference_54_s4_q;
      sum_57_s5_q <= sum_57_s4_q[10];
      sum_60_s5_q <= {sum_57_s4_q[9:0], not_58} + {not_58, xor_59};
      select_73_s5_q <= select_73_s4_q;
      select_79_s5_q <= select_79_s4_q;
      select_84_s5_q <= select_84_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_29;
  assign not_29 = ~sum_28_s5_q[10];
  logic [9:0] xor_30;
  assign xor_30 = larger_s5_q ^ {10{not_29}};
  logic not_61;
  assign not_61 = ~sum_60_s5_q[10];
  logic [9:0] xor_62;
  assign xor_62 = larger_2_s5_q ^ {10{not_61}};

  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_seen_s6_q;
  logic marks_nearer_s6_q;
  logic less_15_s6_q;
  logic xor_18_s6_q;
  logic [9:0] larger_s6_q;
  logic difference_22_s6_q;
  logic sum_25_s6_q;
  logic sum_28_s6_q;
  logic [10:0] sum_31_s6_q;
  logic select_41_s6_q;
  logic less_47_s6_q;
  logic xor_50_s6_q;
  logic [9:0] larger_2_s6_q;
  logic difference_54_s6_q;
  logic sum_57_s6_q;
  logic sum_60_s6_q;
  logic [10:0] sum_63_s6_q;
  logic select_73_s6_q;
  logic [7:0] select_79_s6_q;
  logic [7:0] select_84_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_seen_s6_q <= marks_seen_s5_q;
      marks_nearer_s6_q <= marks_nearer_s5_q;
      less_15_s6_q <= less_15_s5_q;
      xor_18_s6_q <= xor_18_s5_q;
      larger_s6_q <= larger_s5_q;
      difference_22_s6_q <= difference_22_s5_q;
      sum_25_s6_q <= sum_25_s5_q;
      sum_28_s6_q <= sum_28_s5_q[10];
      sum_31_s6_q <= {sum_28_s5_q[9:0], not_29} + {not_29, xor_30};
      select_41_s6_q <= select_41_s5_q;
      less_47_s6_q <= less_47_s5_q;
      xor_50_s6_q <= xor_50_s5_q;
      larger_2_s6_q <= larger_2_s5_q;
      difference_54_s6_q <= difference_54_s5_q;
      sum_57_s6_q <= sum_57_s5_q;
      sum_60_s6_q <= sum_60_s5_q[10];
      sum_63_s6_q <= {sum_60_s5_q[9:0], not_61} + {not_61, xor_62};
      select_73_s6_q <= select_73_s5_q;
      select_79_s6_q <= select_79_s5_q;
      select_84_s6_q <= select_84_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_32;
  assign not_32 = ~sum_31_s6_q[10];
  logic [9:0] xor_33;
  assign xor_33 = larger_s6_q ^ {10{not_32}};
  logic not_64;
  assign not_64 = ~sum_63_s6_q[10];
  logic [9:0] xor_65;
  assign xor_65 = larger_2_s6_q ^ {10{not_64}};

  logic saturated_s7_q;
  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_seen_s7_q;
  logic marks_nearer_s7_q;
  logic less_15_s7_q;
  logic xor_18_s7_q;
  logic [9:0] larger_s7_q;
  logic difference_22_s7_q;
  logic sum_25_s7_q;
  logic sum_28_s7_q;
  logic sum_31_s7_q;
  logic [10:0] sum_34_s7_q;
  logic select_41_s7_q;
  logic less_47_s7_q;
  logic xor_50_s7_q;
  logic [9:0] larger_2_s7_q;
  logic difference_54_s7_q;
  logic sum_57_s7_q;
  logic sum_60_s7_q;
  logic sum_63_s7_q;
  logic [10:0] sum_66_s7_q;
  logic select_73_s7_q;
  logic [7:0] select_79_s7_q;
  logic [7:0] select_84_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s7_q <= saturated_s6_q;
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_seen_s7_q <= marks_seen_s6_q;
      marks_nearer_s7_q <= marks_nearer_s6_q;
      less_15_s7_q <= less_15_s6_q;
      xor_18_s7_q <= xor_18_s6_q;
      larger_s7_q <= larger_s6_q;
      difference_22_s7_q <= difference_22_s6_q;
      sum_25_s7_q <= sum_25_s6_q;
      sum_28_s7_q <= sum_28_s6_q;
      sum_31_s7_q <= sum_31_s6_q[10];
      sum_34_s7_q <= {sum_31_s6_q[9:0], not_32} + {not_32, xor_33};
      select_41_s7_q <= select_41_s6_q;
      less_47_s7_q <= less_47_s6_q;
      xor_50_s7_q <= xor_50_s6_q;
      larger_2_s7_q <= larger_2_s6_q;
      difference_54_s7_q <= difference_54_s6_q;
      sum_57_s7_q <= sum_57_s6_q;
      sum_60_s7_q <= sum_60_s6_q;
      sum_63_s7_q <= sum_63_s6_q[10];
      sum_66_s7_q <= {sum_63_s6_q[9:0], not_64} + {not_64, xor_65};
      select_73_s7_q <= select_73_s6_q;
      select_79_s7_q <= select_79_s6_q;
      select_84_s7_q <= select_84_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_35;
  assign not_35 = ~sum_34_s7_q[10];
  logic [9:0] xor_36;
  assign xor_36 = larger_s7_q ^ {10{not_35}};
  logic [10:0] sum_37;
  assign sum_37 = {sum_34_s7_q[9:0], not_35} + {not_35, xor_36};
  logic not_67;
  assign not_67 = ~sum_66_s7_q[10];
  logic [9:0] xor_68;
  assign xor_68 = larger_2_s7_q ^ {10{not_67}};
  logic [10:0] sum_69;
  assign sum_69 = {sum_66_s7_q[9:0], not_67} + {not_67, xor_68};

  logic saturated_s8_q;
  logic mask_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_seen_s8_q;
  logic marks_nearer_s8_q;
  logic less_15_s8_q;
  logic xor_18_s8_q;
  logic difference_22_s8_q;
  logic sum_25_s8_q;
  logic sum_28_s8_q;
  logic sum_31_s8_q;
  logic sum_34_s8_q;
  logic sum_37_s8_q;
  logic select_41_s8_q;
  logic less_47_s8_q;
  logic xor_50_s8_q;
  logic difference_54_s8_q;
  logic sum_57_s8_q;
  logic sum_60_s8_q;
  logic sum_63_s8_q;
  logic sum_66_s8_q;
  logic sum_69_s8_q;
  logic select_73_s8_q;
  logic [7:0] select_79_s8_q;
  logic [7:0] select_84_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s8_q <= saturated_s7_q;
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_seen_s8_q <= marks_seen_s7_q;
      marks_nearer_s8_q <= marks_nearer_s7_q;
      less_15_s8_q <= less_15_s7_q;
      xor_18_s8_q <= xor_18_s7_q;
      difference_22_s8_q <= difference_22_s7_q;
      sum_25_s8_q <= sum_25_s7_q;
      sum_28_s8_q <= sum_28_s7_q;
      sum_31_s8_q <= sum_31_s7_q;
      sum_34_s8_q <= sum_34_s7_q[10];
      sum_37_s8_q <= sum_37[10];
      select_41_s8_q <= select_41_s7_q;
      less_47_s8_q <= less_47_s7_q;
      xor_50_s8_q <= xor_50_s7_q;
      difference_54_s8_q <= difference_54_s7_q;
      sum_57_s8_q <= sum_57_s7_q;
      sum_60_s8_q <= sum_60_s7_q;
      sum_63_s8_q <= sum_63_s7_q;
      sum_66_s8_q <= sum_66_s7_q[10];
      sum_69_s8_q <= sum_69[10];
      select_73_s8_q <= select_73_s7_q;
      select_79_s8_q <= select_79_s7_q;
      select_84_s8_q <= select_84_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic [5:0] angle;  // table arctangent_table
  always_comb begin
    case ({difference_22_s8_q, sum_25_s8_q, sum_28_s8_q, sum_31_s8_q, sum_34_s8_q, sum_37_s8_q})
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
    case ({difference_54_s8_q, sum_57_s8_q, sum_60_s8_q, sum_63_s8_q, sum_66_s8_q, sum_69_s8_q})
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

  logic saturated_s9_q;
  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic marks_seen_s9_q;
  logic marks_nearer_s9_q;
  logic less_15_s9_q;
  logic xor_18_s9_q;
  logic [5:0] angle_s9_q;
  logic select_41_s9_q;
  logic less_47_s9_q;
  logic xor_50_s9_q;
  logic [5:0] angle_2_s9_q;
  logic select_73_s9_q;
  logic [7:0] select_79_s9_q;
  logic [7:0] select_84_s9_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s9_q <= saturated_s8_q;
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      marks_seen_s9_q <= marks_seen_s8_q;
      marks_nearer_s9_q <= marks_nearer_s8_q;
      less_15_s9_q <= less_15_s8_q;
      xor_18_s9_q <= xor_18_s8_q;
      angle_s9_q <= angle;
      select_41_s9_q <= select_41_s8_q;
      less_47_s9_q <= less_47_s8_q;
      xor_50_s9_q <= xor_50_s8_q;
      angle_2_s9_q <= angle_2;
      select_73_s9_q <= select_73_s8_q;
      select_79_s9_q <= select_79_s8_q;
      select_84_s9_q <= select_84_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:69
  logic [6:0] select_40;
  assign select_40 = xor_18_s9_q ? {1'b0, angle_s9_q} : (7'h0 - {1'b0, angle_s9_q});
  logic [6:0] select_72;
  assign select_72 = xor_50_s9_q ? {1'b0, angle_2_s9_q} : (7'h0 - {1'b0, angle_2_s9_q});

  logic saturated_s10_q;
  logic mask_s10_q;
  logic marks_first_s10_q;
  logic marks_last_s10_q;
  logic marks_seen_s10_q;
  logic marks_nearer_s10_q;
  logic [5:0] select_40_s10_q;
  logic [1:0] sum_42_s10_q;
  logic [5:0] select_72_s10_q;
  logic [1:0] sum_74_s10_q;
  logic [7:0] select_79_s10_q;
  logic [7:0] select_84_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      saturated_s10_q <= saturated_s9_q;
      mask_s10_q <= mask_s9_q;
      marks_first_s10_q <= marks_first_s9_q;
      marks_last_s10_q <= marks_last_s9_q;
      marks_seen_s10_q <= marks_seen_s9_q;
      marks_nearer_s10_q <= marks_nearer_s9_q;
      select_40_s10_q <= select_40[5:0];
      sum_42_s10_q <= {select_41_s9_q, less_15_s9_q} + {2{select_40[6]}};
      select_72_s10_q <= select_72[5:0];
      sum_74_s10_q <= {select_73_s9_q, less_47_s9_q} + {2{select_72[6]}};
      select_79_s10_q <= select_79_s9_q;
      select_84_s10_q <= select_84_s9_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign direction_0_o = {sum_42_s10_q, select_40_s10_q};
  assign direction_1_o = {sum_74_s10_q, select_72_s10_q};
  assign magnitude_0_o = select_79_s10_q;
  assign magnitude_1_o = select_84_s10_q;
  assign saturated_o = saturated_s10_q;
  assign mask_o = mask_s10_q;
  assign marks_first_o = marks_first_s10_q;
  assign marks_last_o = marks_last_s10_q;
  assign marks_seen_o = marks_seen_s10_q;
  assign marks_nearer_o = marks_nearer_s10_q;
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
  assign unused_bits = ^{sum_81[0], sum_80[0], sum_76[0], sum_75[0], sum_69[9:0], sum_37[9:0]};

endmodule
