// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Paths<horopter::hls::profiles::hd>, hls/stages/plane_paths.hpp. Do not edit.
//
// Latency 6 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 1506 bits, memories 0 bits.
module horopter_plane_paths (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [10:0] sum_0_i,
  input  logic [10:0] sum_1_i,
  input  logic [10:0] sum_2_i,
  input  logic [10:0] sum_3_i,
  input  logic [10:0] sum_4_i,
  input  logic [10:0] sum_5_i,
  input  logic [10:0] sum_6_i,
  input  logic [10:0] sum_7_i,
  input  logic [10:0] sum_8_i,
  input  logic [10:0] sum_9_i,
  input  logic [10:0] sum_10_i,
  input  logic [10:0] sum_11_i,
  input  logic [10:0] sum_12_i,
  input  logic [10:0] sum_13_i,
  input  logic [10:0] sum_14_i,
  input  logic [10:0] sum_15_i,
  input  logic [10:0] sum_16_i,
  input  logic [10:0] sum_17_i,
  input  logic [10:0] sum_18_i,
  input  logic [10:0] evidence_i,
  input  logic [5:0] edges_i,
  input  logic [5:0] grey_i,
  input  logic known_i,
  input  logic exists_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [10:0] cost_0_o,
  output logic [10:0] cost_1_o,
  output logic [10:0] cost_2_o,
  output logic [10:0] cost_3_o,
  output logic [10:0] cost_4_o,
  output logic [10:0] cost_5_o,
  output logic [10:0] cost_6_o,
  output logic [10:0] cost_7_o,
  output logic [10:0] cost_8_o,
  output logic [10:0] cost_9_o,
  output logic [10:0] cost_10_o,
  output logic [10:0] cost_11_o,
  output logic [10:0] cost_12_o,
  output logic [10:0] cost_13_o,
  output logic [10:0] cost_14_o,
  output logic [10:0] cost_15_o,
  output logic [10:0] cost_16_o,
  output logic [10:0] cost_17_o,
  output logic [10:0] cost_18_o,
  output logic [5:0] grey_o,
  output logic known_o,
  output logic evident_o,
  output logic strong_v_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q;
  logic s5_en;
  assign s5_en = en_i & valid_s5_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------

  logic [10:0] sum_0_s1_q;
  logic [10:0] sum_1_s1_q;
  logic [10:0] sum_2_s1_q;
  logic [10:0] sum_3_s1_q;
  logic [10:0] sum_4_s1_q;
  logic [10:0] sum_5_s1_q;
  logic [10:0] sum_6_s1_q;
  logic [10:0] sum_7_s1_q;
  logic [10:0] sum_8_s1_q;
  logic [10:0] sum_9_s1_q;
  logic [10:0] sum_10_s1_q;
  logic [10:0] sum_11_s1_q;
  logic [10:0] sum_12_s1_q;
  logic [10:0] sum_13_s1_q;
  logic [10:0] sum_14_s1_q;
  logic [10:0] sum_15_s1_q;
  logic [10:0] sum_16_s1_q;
  logic [10:0] sum_17_s1_q;
  logic [10:0] sum_18_s1_q;
  logic [10:0] evidence_s1_q;
  logic [5:0] grey_s1_q;
  logic known_s1_q;
  logic exists_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic less_33_s1_q;
  logic less_35_s1_q;
  logic less_39_s1_q;
  logic less_41_s1_q;
  logic less_47_s1_q;
  logic less_49_s1_q;
  logic less_53_s1_q;
  logic less_55_s1_q;
  logic not_69_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      sum_0_s1_q <= sum_0_i;
      sum_1_s1_q <= sum_1_i;
      sum_2_s1_q <= sum_2_i;
      sum_3_s1_q <= sum_3_i;
      sum_4_s1_q <= sum_4_i;
      sum_5_s1_q <= sum_5_i;
      sum_6_s1_q <= sum_6_i;
      sum_7_s1_q <= sum_7_i;
      sum_8_s1_q <= sum_8_i;
      sum_9_s1_q <= sum_9_i;
      sum_10_s1_q <= sum_10_i;
      sum_11_s1_q <= sum_11_i;
      sum_12_s1_q <= sum_12_i;
      sum_13_s1_q <= sum_13_i;
      sum_14_s1_q <= sum_14_i;
      sum_15_s1_q <= sum_15_i;
      sum_16_s1_q <= sum_16_i;
      sum_17_s1_q <= sum_17_i;
      sum_18_s1_q <= sum_18_i;
      evidence_s1_q <= evidence_i;
      grey_s1_q <= grey_i;
      known_s1_q <= known_i;
      exists_s1_q <= exists_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      less_33_s1_q <= sum_15_i < sum_14_i;
      less_35_s1_q <= sum_13_i < sum_12_i;
      less_39_s1_q <= sum_11_i < sum_10_i;
      less_41_s1_q <= sum_9_i < sum_8_i;
      less_47_s1_q <= sum_7_i < sum_6_i;
      less_49_s1_q <= sum_5_i < sum_4_i;
      less_53_s1_q <= sum_3_i < sum_2_i;
      less_55_s1_q <= sum_1_i < sum_0_i;
      not_69_s1_q <= ~(edges_i[5:3] == 3'h0);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/planes.hpp:42
  logic [10:0] select_34;
  assign select_34 = less_33_s1_q ? sum_15_s1_q : sum_14_s1_q;
  logic [10:0] select_36;
  assign select_36 = less_35_s1_q ? sum_13_s1_q : sum_12_s1_q;
  logic [10:0] select_40;
  assign select_40 = less_39_s1_q ? sum_11_s1_q : sum_10_s1_q;
  logic [10:0] select_42;
  assign select_42 = less_41_s1_q ? sum_9_s1_q : sum_8_s1_q;
  logic [10:0] select_48;
  assign select_48 = less_47_s1_q ? sum_7_s1_q : sum_6_s1_q;
  logic [10:0] select_50;
  assign select_50 = less_49_s1_q ? sum_5_s1_q : sum_4_s1_q;
  logic [10:0] select_54;
  assign select_54 = less_53_s1_q ? sum_3_s1_q : sum_2_s1_q;
  logic [10:0] select_56;
  assign select_56 = less_55_s1_q ? sum_1_s1_q : sum_0_s1_q;

  logic [10:0] sum_0_s2_q;
  logic [10:0] sum_1_s2_q;
  logic [10:0] sum_2_s2_q;
  logic [10:0] sum_3_s2_q;
  logic [10:0] sum_4_s2_q;
  logic [10:0] sum_5_s2_q;
  logic [10:0] sum_6_s2_q;
  logic [10:0] sum_7_s2_q;
  logic [10:0] sum_8_s2_q;
  logic [10:0] sum_9_s2_q;
  logic [10:0] sum_10_s2_q;
  logic [10:0] sum_11_s2_q;
  logic [10:0] sum_12_s2_q;
  logic [10:0] sum_13_s2_q;
  logic [10:0] sum_14_s2_q;
  logic [10:0] sum_15_s2_q;
  logic [10:0] sum_16_s2_q;
  logic [10:0] sum_17_s2_q;
  logic [10:0] sum_18_s2_q;
  logic [10:0] evidence_s2_q;
  logic [5:0] grey_s2_q;
  logic known_s2_q;
  logic exists_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic [10:0] select_38_s2_q;
  logic [10:0] select_44_s2_q;
  logic [10:0] select_52_s2_q;
  logic [10:0] select_58_s2_q;
  logic not_69_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      sum_0_s2_q <= sum_0_s1_q;
      sum_1_s2_q <= sum_1_s1_q;
      sum_2_s2_q <= sum_2_s1_q;
      sum_3_s2_q <= sum_3_s1_q;
      sum_4_s2_q <= sum_4_s1_q;
      sum_5_s2_q <= sum_5_s1_q;
      sum_6_s2_q <= sum_6_s1_q;
      sum_7_s2_q <= sum_7_s1_q;
      sum_8_s2_q <= sum_8_s1_q;
      sum_9_s2_q <= sum_9_s1_q;
      sum_10_s2_q <= sum_10_s1_q;
      sum_11_s2_q <= sum_11_s1_q;
      sum_12_s2_q <= sum_12_s1_q;
      sum_13_s2_q <= sum_13_s1_q;
      sum_14_s2_q <= sum_14_s1_q;
      sum_15_s2_q <= sum_15_s1_q;
      sum_16_s2_q <= sum_16_s1_q;
      sum_17_s2_q <= sum_17_s1_q;
      sum_18_s2_q <= sum_18_s1_q;
      evidence_s2_q <= evidence_s1_q;
      grey_s2_q <= grey_s1_q;
      known_s2_q <= known_s1_q;
      exists_s2_q <= exists_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      select_38_s2_q <= (select_34 < select_36) ? select_34 : select_36;
      select_44_s2_q <= (select_40 < select_42) ? select_40 : select_42;
      select_52_s2_q <= (select_48 < select_50) ? select_48 : select_50;
      select_58_s2_q <= (select_54 < select_56) ? select_54 : select_56;
      not_69_s2_q <= not_69_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/planes.hpp:42
  logic [10:0] select_46;
  assign select_46 = (select_38_s2_q < select_44_s2_q) ? select_38_s2_q : select_44_s2_q;
  logic [10:0] select_60;
  assign select_60 = (select_52_s2_q < select_58_s2_q) ? select_52_s2_q : select_58_s2_q;

  logic [10:0] sum_0_s3_q;
  logic [10:0] sum_1_s3_q;
  logic [10:0] sum_2_s3_q;
  logic [10:0] sum_3_s3_q;
  logic [10:0] sum_4_s3_q;
  logic [10:0] sum_5_s3_q;
  logic [10:0] sum_6_s3_q;
  logic [10:0] sum_7_s3_q;
  logic [10:0] sum_8_s3_q;
  logic [10:0] sum_9_s3_q;
  logic [10:0] sum_10_s3_q;
  logic [10:0] sum_11_s3_q;
  logic [10:0] sum_12_s3_q;
  logic [10:0] sum_13_s3_q;
  logic [10:0] sum_14_s3_q;
  logic [10:0] sum_15_s3_q;
  logic [10:0] sum_16_s3_q;
  logic [10:0] sum_17_s3_q;
  logic [10:0] sum_18_s3_q;
  logic [10:0] evidence_s3_q;
  logic [5:0] grey_s3_q;
  logic known_s3_q;
  logic exists_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic less_29_s3_q;
  logic [10:0] select_46_s3_q;
  logic [10:0] select_60_s3_q;
  logic not_69_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      sum_0_s3_q <= sum_0_s2_q;
      sum_1_s3_q <= sum_1_s2_q;
      sum_2_s3_q <= sum_2_s2_q;
      sum_3_s3_q <= sum_3_s2_q;
      sum_4_s3_q <= sum_4_s2_q;
      sum_5_s3_q <= sum_5_s2_q;
      sum_6_s3_q <= sum_6_s2_q;
      sum_7_s3_q <= sum_7_s2_q;
      sum_8_s3_q <= sum_8_s2_q;
      sum_9_s3_q <= sum_9_s2_q;
      sum_10_s3_q <= sum_10_s2_q;
      sum_11_s3_q <= sum_11_s2_q;
      sum_12_s3_q <= sum_12_s2_q;
      sum_13_s3_q <= sum_13_s2_q;
      sum_14_s3_q <= sum_14_s2_q;
      sum_15_s3_q <= sum_15_s2_q;
      sum_16_s3_q <= sum_16_s2_q;
      sum_17_s3_q <= sum_17_s2_q;
      sum_18_s3_q <= sum_18_s2_q;
      evidence_s3_q <= evidence_s2_q;
      grey_s3_q <= grey_s2_q;
      known_s3_q <= known_s2_q;
      exists_s3_q <= exists_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      less_29_s3_q <= sum_17_s2_q < sum_16_s2_q;
      select_46_s3_q <= select_46;
      select_60_s3_q <= select_60;
      not_69_s3_q <= not_69_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/planes.hpp:42
  logic [10:0] select_30;
  assign select_30 = less_29_s3_q ? sum_17_s3_q : sum_16_s3_q;
  logic [10:0] select_62;
  assign select_62 = (select_46_s3_q < select_60_s3_q) ? select_46_s3_q : select_60_s3_q;

  logic [10:0] sum_0_s4_q;
  logic [10:0] sum_1_s4_q;
  logic [10:0] sum_2_s4_q;
  logic [10:0] sum_3_s4_q;
  logic [10:0] sum_4_s4_q;
  logic [10:0] sum_5_s4_q;
  logic [10:0] sum_6_s4_q;
  logic [10:0] sum_7_s4_q;
  logic [10:0] sum_8_s4_q;
  logic [10:0] sum_9_s4_q;
  logic [10:0] sum_10_s4_q;
  logic [10:0] sum_11_s4_q;
  logic [10:0] sum_12_s4_q;
  logic [10:0] sum_13_s4_q;
  logic [10:0] sum_14_s4_q;
  logic [10:0] sum_15_s4_q;
  logic [10:0] sum_16_s4_q;
  logic [10:0] sum_17_s4_q;
  logic [10:0] sum_18_s4_q;
  logic [10:0] evidence_s4_q;
  logic [5:0] grey_s4_q;
  logic known_s4_q;
  logic exists_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic [10:0] select_32_s4_q;
  logic [10:0] select_62_s4_q;
  logic not_69_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      sum_0_s4_q <= sum_0_s3_q;
      sum_1_s4_q <= sum_1_s3_q;
      sum_2_s4_q <= sum_2_s3_q;
      sum_3_s4_q <= sum_3_s3_q;
      sum_4_s4_q <= sum_4_s3_q;
      sum_5_s4_q <= sum_5_s3_q;
      sum_6_s4_q <= sum_6_s3_q;
      sum_7_s4_q <= sum_7_s3_q;
      sum_8_s4_q <= sum_8_s3_q;
      sum_9_s4_q <= sum_9_s3_q;
      sum_10_s4_q <= sum_10_s3_q;
      sum_11_s4_q <= sum_11_s3_q;
      sum_12_s4_q <= sum_12_s3_q;
      sum_13_s4_q <= sum_13_s3_q;
      sum_14_s4_q <= sum_14_s3_q;
      sum_15_s4_q <= sum_15_s3_q;
      sum_16_s4_q <= sum_16_s3_q;
      sum_17_s4_q <= sum_17_s3_q;
      sum_18_s4_q <= sum_18_s3_q;
      evidence_s4_q <= evidence_s3_q;
      grey_s4_q <= grey_s3_q;
      known_s4_q <= known_s3_q;
      exists_s4_q <= exists_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      select_32_s4_q <= (sum_18_s3_q < select_30) ? sum_18_s3_q : select_30;
      select_62_s4_q <= select_62;
      not_69_s4_q <= not_69_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/planes.hpp:42
  logic [10:0] select_64;
  assign select_64 = (select_32_s4_q < select_62_s4_q) ? select_32_s4_q : select_62_s4_q;
  // hls/stages/plane_paths.hpp:61
  logic [11:0] sum_65;
  assign sum_65 = {1'b0, evidence_s4_q} + {3'h0, evidence_s4_q[10:2]};

  logic [10:0] sum_0_s5_q;
  logic [10:0] sum_1_s5_q;
  logic [10:0] sum_2_s5_q;
  logic [10:0] sum_3_s5_q;
  logic [10:0] sum_4_s5_q;
  logic [10:0] sum_5_s5_q;
  logic [10:0] sum_6_s5_q;
  logic [10:0] sum_7_s5_q;
  logic [10:0] sum_8_s5_q;
  logic [10:0] sum_9_s5_q;
  logic [10:0] sum_10_s5_q;
  logic [10:0] sum_11_s5_q;
  logic [10:0] sum_12_s5_q;
  logic [10:0] sum_13_s5_q;
  logic [10:0] sum_14_s5_q;
  logic [10:0] sum_15_s5_q;
  logic [10:0] sum_16_s5_q;
  logic [10:0] sum_17_s5_q;
  logic [10:0] sum_18_s5_q;
  logic [1:0] evidence_s5_q;
  logic [5:0] grey_s5_q;
  logic known_s5_q;
  logic exists_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic [10:0] select_64_s5_q;
  logic sum_65_s5_q;
  logic [11:0] sum_66_s5_q;
  logic not_69_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      sum_0_s5_q <= sum_0_s4_q;
      sum_1_s5_q <= sum_1_s4_q;
      sum_2_s5_q <= sum_2_s4_q;
      sum_3_s5_q <= sum_3_s4_q;
      sum_4_s5_q <= sum_4_s4_q;
      sum_5_s5_q <= sum_5_s4_q;
      sum_6_s5_q <= sum_6_s4_q;
      sum_7_s5_q <= sum_7_s4_q;
      sum_8_s5_q <= sum_8_s4_q;
      sum_9_s5_q <= sum_9_s4_q;
      sum_10_s5_q <= sum_10_s4_q;
      sum_11_s5_q <= sum_11_s4_q;
      sum_12_s5_q <= sum_12_s4_q;
      sum_13_s5_q <= sum_13_s4_q;
      sum_14_s5_q <= sum_14_s4_q;
      sum_15_s5_q <= sum_15_s4_q;
      sum_16_s5_q <= sum_16_s4_q;
      sum_17_s5_q <= sum_17_s4_q;
      sum_18_s5_q <= sum_18_s4_q;
      evidence_s5_q <= evidence_s4_q[1:0];
      grey_s5_q <= grey_s4_q;
      known_s5_q <= known_s4_q;
      exists_s5_q <= exists_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      select_64_s5_q <= select_64;
      sum_65_s5_q <= sum_65[0];
      sum_66_s5_q <= {1'b0, evidence_s4_q} + {1'b0, sum_65[11:1]};
      not_69_s5_q <= not_69_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:62
  logic less_67;
  assign less_67 = {select_64_s5_q, 4'h0} < {sum_66_s5_q, sum_65_s5_q, evidence_s5_q};

  logic [10:0] sum_0_s6_q;
  logic [10:0] sum_1_s6_q;
  logic [10:0] sum_2_s6_q;
  logic [10:0] sum_3_s6_q;
  logic [10:0] sum_4_s6_q;
  logic [10:0] sum_5_s6_q;
  logic [10:0] sum_6_s6_q;
  logic [10:0] sum_7_s6_q;
  logic [10:0] sum_8_s6_q;
  logic [10:0] sum_9_s6_q;
  logic [10:0] sum_10_s6_q;
  logic [10:0] sum_11_s6_q;
  logic [10:0] sum_12_s6_q;
  logic [10:0] sum_13_s6_q;
  logic [10:0] sum_14_s6_q;
  logic [10:0] sum_15_s6_q;
  logic [10:0] sum_16_s6_q;
  logic [10:0] sum_17_s6_q;
  logic [10:0] sum_18_s6_q;
  logic [5:0] grey_s6_q;
  logic known_s6_q;
  logic exists_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_seen_s6_q;
  logic marks_nearer_s6_q;
  logic not_69_s6_q;
  logic and_71_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      sum_0_s6_q <= sum_0_s5_q;
      sum_1_s6_q <= sum_1_s5_q;
      sum_2_s6_q <= sum_2_s5_q;
      sum_3_s6_q <= sum_3_s5_q;
      sum_4_s6_q <= sum_4_s5_q;
      sum_5_s6_q <= sum_5_s5_q;
      sum_6_s6_q <= sum_6_s5_q;
      sum_7_s6_q <= sum_7_s5_q;
      sum_8_s6_q <= sum_8_s5_q;
      sum_9_s6_q <= sum_9_s5_q;
      sum_10_s6_q <= sum_10_s5_q;
      sum_11_s6_q <= sum_11_s5_q;
      sum_12_s6_q <= sum_12_s5_q;
      sum_13_s6_q <= sum_13_s5_q;
      sum_14_s6_q <= sum_14_s5_q;
      sum_15_s6_q <= sum_15_s5_q;
      sum_16_s6_q <= sum_16_s5_q;
      sum_17_s6_q <= sum_17_s5_q;
      sum_18_s6_q <= sum_18_s5_q;
      grey_s6_q <= grey_s5_q;
      known_s6_q <= known_s5_q;
      exists_s6_q <= exists_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_seen_s6_q <= marks_seen_s5_q;
      marks_nearer_s6_q <= marks_nearer_s5_q;
      not_69_s6_q <= not_69_s5_q;
      and_71_s6_q <= known_s5_q & (less_67 | not_69_s5_q);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign cost_0_o = sum_0_s6_q;
  assign cost_1_o = sum_1_s6_q;
  assign cost_2_o = sum_2_s6_q;
  assign cost_3_o = sum_3_s6_q;
  assign cost_4_o = sum_4_s6_q;
  assign cost_5_o = sum_5_s6_q;
  assign cost_6_o = sum_6_s6_q;
  assign cost_7_o = sum_7_s6_q;
  assign cost_8_o = sum_8_s6_q;
  assign cost_9_o = sum_9_s6_q;
  assign cost_10_o = sum_10_s6_q;
  assign cost_11_o = sum_11_s6_q;
  assign cost_12_o = sum_12_s6_q;
  assign cost_13_o = sum_13_s6_q;
  assign cost_14_o = sum_14_s6_q;
  assign cost_15_o = sum_15_s6_q;
  assign cost_16_o = sum_16_s6_q;
  assign cost_17_o = sum_17_s6_q;
  assign cost_18_o = sum_18_s6_q;
  assign grey_o = grey_s6_q;
  assign known_o = known_s6_q;
  assign evident_o = and_71_s6_q;
  assign strong_v_o = not_69_s6_q;
  assign exists_o = exists_s6_q;
  assign marks_first_o = marks_first_s6_q;
  assign marks_last_o = marks_last_s6_q;
  assign marks_seen_o = marks_seen_s6_q;
  assign marks_nearer_o = marks_nearer_s6_q;
  assign valid_o = valid_s6_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^edges_i[2:0];

endmodule
