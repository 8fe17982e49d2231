// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::field>, hls/stages/health.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 125 bits, pipeline 5 bits, memories 0 bits.
module horopter_health (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_i,
  input  logic first_i,
  input  logic end_v_i,
  input  logic [7:0] cfg_dark_level_i,
  input  logic [7:0] cfg_bright_level_i,
  input  logic [17:0] cfg_dark_limit_i,
  input  logic [17:0] cfg_bright_limit_i,
  input  logic [7:0] cfg_contrast_limit_i,
  input  logic [7:0] cfg_frozen_limit_i,
  output logic valid_o,
  output logic black_o,
  output logic white_o,
  output logic constant_o,
  output logic frozen_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [31:0] crc_q;
  logic [31:0] previous_crc_q;
  logic has_previous_q;
  logic [7:0] repeats_q;
  logic [7:0] darkest_q;
  logic [7:0] brightest_q;
  logic [17:0] dark_q;
  logic [17:0] bright_q;
  // hls/stages/health.hpp:53
  logic [31:0] select_18;
  assign select_18 = first_i ? 32'hffffffff : crc_q;
  logic [7:0] xor_19;
  assign xor_19 = pixel_i ^ select_18[7:0];
  logic parity_21;
  assign parity_21 = ^{select_18[6], select_18[0], pixel_i[6], pixel_i[0]};
  logic parity_22;
  assign parity_22 = ^{select_18[9], select_18[0], pixel_i[0]};
  logic parity_23;
  assign parity_23 = ^{select_18[10], select_18[0], pixel_i[0]};
  logic parity_24;
  assign parity_24 = ^{select_18[16], select_18[0], pixel_i[0]};
  logic parity_25;
  assign parity_25 = ^{select_18[20], select_18[0], pixel_i[0]};
  logic parity_26;
  assign parity_26 = ^{select_18[21], select_18[0], pixel_i[0]};
  logic parity_27;
  assign parity_27 = ^{select_18[22], select_18[0], pixel_i[0]};
  logic parity_28;
  assign parity_28 = ^{select_18[24], select_18[0], pixel_i[0]};
  logic parity_29;
  assign parity_29 = ^{select_18[25], select_18[0], pixel_i[0]};
  logic parity_30;
  assign parity_30 = ^{select_18[27], select_18[0], pixel_i[0]};
  logic parity_31;
  assign parity_31 = ^{select_18[28], select_18[0], pixel_i[0]};
  logic parity_32;
  assign parity_32 = ^{select_18[30], select_18[0], pixel_i[0]};
  logic parity_33;
  assign parity_33 = ^{select_18[31], select_18[0], pixel_i[0]};
  logic [12:0] xor_34;
  assign xor_34 = {xor_19[0], xor_19[1], select_18[29], xor_19[1], select_18[26], xor_19[1], select_18[23], {2{xor_19[1]}}, select_18[17], select_18[11], {2{xor_19[1]}}} ^ {xor_19[1], parity_33, xor_19[1], parity_31, xor_19[1], parity_29, xor_19[1], parity_27, parity_26, {2{xor_19[1]}}, parity_23, xor_19[7]};
  logic parity_35;
  assign parity_35 = ^{select_18[7], select_18[1], pixel_i[7], pixel_i[1]};
  logic parity_36;
  assign parity_36 = ^{select_18[11], select_18[1], pixel_i[1]};
  logic parity_37;
  assign parity_37 = ^{select_18[17], select_18[1], pixel_i[1]};
  logic parity_38;
  assign parity_38 = ^{select_18[23], select_18[1], pixel_i[1]};
  logic parity_39;
  assign parity_39 = ^{select_18[26], select_18[1], pixel_i[1]};
  logic parity_40;
  assign parity_40 = ^{select_18[29], select_18[1], pixel_i[1]};
  logic parity_41;
  assign parity_41 = ^{select_18[1:0], pixel_i[1:0]};
  logic [12:0] xor_42;
  assign xor_42 = {xor_19[1], {8{xor_19[2]}}, select_18[18], select_18[12], xor_19[2], select_18[8]} ^ {xor_19[2], parity_41, parity_32, parity_40, parity_30, parity_39, parity_28, parity_38, xor_34[5], {2{xor_19[2]}}, parity_36, xor_19[2]};
  logic parity_43;
  assign parity_43 = ^{select_18[8], select_18[2], pixel_i[2]};
  logic parity_44;
  assign parity_44 = ^{select_18[12], select_18[2], pixel_i[2]};
  logic parity_45;
  assign parity_45 = ^{select_18[18], select_18[2], pixel_i[2]};
  logic parity_46;
  assign parity_46 = ^{select_18[22], select_18[2:0], pixel_i[2:0]};
  logic parity_47;
  assign parity_47 = ^{select_18[2:1], pixel_i[2:1]};
  logic [12:0] xor_48;
  assign xor_48 = {xor_19[2], {8{xor_19[3]}}, select_18[19], select_18[13], {2{xor_19[3]}}} ^ {xor_19[3], parity_47, xor_34[11], xor_42[10], xor_34[9], xor_42[8], xor_34[7], xor_42[6:5], {2{xor_19[3]}}, parity_44, parity_22};
  logic parity_49;
  assign parity_49 = ^{select_18[13], select_18[3], pixel_i[3]};
  logic parity_50;
  assign parity_50 = ^{select_18[19], select_18[3], pixel_i[3]};
  logic parity_51;
  assign parity_51 = ^{select_18[23], select_18[3:1], pixel_i[3:1]};
  logic parity_52;
  assign parity_52 = ^{select_18[24], select_18[3:2], select_18[0], pixel_i[3:2], pixel_i[0]};
  logic parity_53;
  assign parity_53 = ^{select_18[25], select_18[3], select_18[1:0], pixel_i[3], pixel_i[1:0]};
  logic parity_54;
  assign parity_54 = ^{select_18[27], select_18[3:2], select_18[0], pixel_i[3:2], pixel_i[0]};
  logic parity_55;
  assign parity_55 = ^{select_18[28], select_18[3], select_18[1:0], pixel_i[3], pixel_i[1:0]};
  logic parity_56;
  assign parity_56 = ^{select_18[30], select_18[3:2], select_18[0], pixel_i[3:2], pixel_i[0]};
  logic parity_57;
  assign parity_57 = ^{select_18[31], select_18[3], select_18[1:0], pixel_i[3], pixel_i[1:0]};
  logic parity_58;
  assign parity_58 = ^{select_18[3:2], pixel_i[3:2]};
  logic [12:0] xor_59;
  assign xor_59 = {xor_19[3], {9{xor_19[4]}}, select_18[14], {2{xor_19[4]}}} ^ {xor_19[4], parity_58, xor_42[11], parity_57, xor_42[9], parity_55, xor_42[7], parity_53, parity_52, parity_25, xor_19[4], parity_49, xor_34[1]};
  logic parity_60;
  assign parity_60 = ^{select_18[10], select_18[4], select_18[1:0], pixel_i[4], pixel_i[1:0]};
  logic parity_61;
  assign parity_61 = ^{select_18[14], select_18[4], pixel_i[4]};
  logic parity_62;
  assign parity_62 = ^{select_18[24], select_18[4:2], select_18[0], pixel_i[4:2], pixel_i[0]};
  logic parity_63;
  assign parity_63 = ^{select_18[25], select_18[4:3], select_18[1:0], pixel_i[4:3], pixel_i[1:0]};
  logic parity_64;
  assign parity_64 = ^{select_18[26], select_18[4], select_18[2:1], pixel_i[4], pixel_i[2:1]};
  logic parity_65;
  assign parity_65 = ^{select_18[28], select_18[4:3], select_18[1:0], pixel_i[4:3], pixel_i[1:0]};
  logic parity_66;
  assign parity_66 = ^{select_18[29], select_18[4], select_18[2:1], pixel_i[4], pixel_i[2:1]};
  logic parity_67;
  assign parity_67 = ^{select_18[31], select_18[4:3], select_18[1:0], pixel_i[4:3], pixel_i[1:0]};
  logic parity_68;
  assign parity_68 = ^{select_18[4], select_18[2:0], pixel_i[4], pixel_i[2:0]};
  logic parity_69;
  assign parity_69 = ^{select_18[4:3], pixel_i[4:3]};
  logic [12:0] xor_70;
  assign xor_70 = {xor_19[4], {9{xor_19[5]}}, select_18[15], {2{xor_19[5]}}} ^ {xor_19[5], parity_69, xor_48[11], parity_68, parity_56, parity_66, parity_54, parity_64, parity_63, xor_34[4], xor_19[5], parity_61, xor_42[1]};
  logic parity_71;
  assign parity_71 = ^{select_18[11], select_18[5], select_18[2:1], pixel_i[5], pixel_i[2:1]};
  logic parity_72;
  assign parity_72 = ^{select_18[15], select_18[5], pixel_i[5]};
  logic parity_73;
  assign parity_73 = ^{select_18[21], select_18[5], select_18[1:0], pixel_i[5], pixel_i[1:0]};
  logic parity_74;
  assign parity_74 = ^{select_18[25], select_18[5:3], select_18[1:0], pixel_i[5:3], pixel_i[1:0]};
  logic parity_75;
  assign parity_75 = ^{select_18[26], select_18[5:4], select_18[2:1], pixel_i[5:4], pixel_i[2:1]};
  logic parity_76;
  assign parity_76 = ^{select_18[27], select_18[5], select_18[3:2], select_18[0], pixel_i[5], pixel_i[3:2], pixel_i[0]};
  logic parity_77;
  assign parity_77 = ^{select_18[29], select_18[5:4], select_18[2:1], pixel_i[5:4], pixel_i[2:1]};
  logic parity_78;
  assign parity_78 = ^{select_18[30], select_18[5], select_18[3:2], select_18[0], pixel_i[5], pixel_i[3:2], pixel_i[0]};
  logic parity_79;
  assign parity_79 = ^{select_18[5:4], select_18[2:0], pixel_i[5:4], pixel_i[2:0]};
  logic parity_80;
  assign parity_80 = ^{select_18[5], select_18[3:1], pixel_i[5], pixel_i[3:1]};
  logic parity_81;
  assign parity_81 = ^{select_18[5:4], pixel_i[5:4]};
  logic [12:0] xor_82;
  assign xor_82 = {xor_19[5], {12{parity_21}}} ^ {parity_21, parity_81, xor_59[11], parity_80, parity_67, parity_78, parity_65, parity_76, parity_75, parity_46, parity_24, parity_72, xor_48[1]};
  logic parity_83;
  assign parity_83 = ^{select_18[12], select_18[6], select_18[3:2], select_18[0], pixel_i[6], pixel_i[3:2], pixel_i[0]};
  logic parity_84;
  assign parity_84 = ^{select_18[16], select_18[6], pixel_i[6]};
  logic parity_85;
  assign parity_85 = ^{select_18[22], select_18[6], select_18[2:1], pixel_i[6], pixel_i[2:1]};
  logic parity_86;
  assign parity_86 = ^{select_18[26], select_18[6:4], select_18[2:0], pixel_i[6:4], pixel_i[2:0]};
  logic parity_87;
  assign parity_87 = ^{select_18[27], select_18[6:5], select_18[3:2], pixel_i[6:5], pixel_i[3:2]};
  logic parity_88;
  assign parity_88 = ^{select_18[28], select_18[6], select_18[4:3], select_18[1], pixel_i[6], pixel_i[4:3], pixel_i[1]};
  logic parity_89;
  assign parity_89 = ^{select_18[30], select_18[6:5], select_18[3:2], pixel_i[6:5], pixel_i[3:2]};
  logic parity_90;
  assign parity_90 = ^{select_18[31], select_18[6], select_18[4:3], select_18[1], pixel_i[6], pixel_i[4:3], pixel_i[1]};
  logic parity_91;
  assign parity_91 = ^{select_18[6:5], select_18[3:0], pixel_i[6:5], pixel_i[3:0]};
  logic parity_92;
  assign parity_92 = ^{select_18[6], select_18[4:2], select_18[0], pixel_i[6], pixel_i[4:2], pixel_i[0]};
  logic [12:0] xor_93;
  assign xor_93 = {parity_21, {12{parity_35}}} ^ {parity_35, xor_82[12], xor_70[11], parity_92, parity_79, parity_90, parity_77, parity_88, parity_87, parity_51, parity_37, parity_84, xor_59[1]};
  logic parity_94;
  assign parity_94 = ^{select_18[13], select_18[7], select_18[4:3], select_18[1], pixel_i[7], pixel_i[4:3], pixel_i[1]};
  logic parity_95;
  assign parity_95 = ^{select_18[16], select_18[7:6], select_18[1], pixel_i[7:6], pixel_i[1]};
  logic parity_96;
  assign parity_96 = ^{select_18[17], select_18[7], pixel_i[7]};
  logic parity_97;
  assign parity_97 = ^{select_18[23], select_18[7], select_18[3:2], pixel_i[7], pixel_i[3:2]};
  logic parity_98;
  assign parity_98 = ^{select_18[27], select_18[7:5], select_18[3:1], pixel_i[7:5], pixel_i[3:1]};
  logic parity_99;
  assign parity_99 = ^{select_18[28], select_18[7:6], select_18[4:3], pixel_i[7:6], pixel_i[4:3]};
  logic parity_100;
  assign parity_100 = ^{select_18[29], select_18[7], select_18[5:4], select_18[2], pixel_i[7], pixel_i[5:4], pixel_i[2]};
  logic parity_101;
  assign parity_101 = ^{select_18[31], select_18[7:6], select_18[4:3], pixel_i[7:6], pixel_i[4:3]};
  logic parity_102;
  assign parity_102 = ^{select_18[7], select_18[5:4], select_18[2], select_18[0], pixel_i[7], pixel_i[5:4], pixel_i[2], pixel_i[0]};
  logic parity_103;
  assign parity_103 = ^{select_18[7:6], select_18[4:0], pixel_i[7:6], pixel_i[4:0]};
  logic parity_104;
  assign parity_104 = ^{select_18[7], select_18[5:3], select_18[1], pixel_i[7], pixel_i[5:3], pixel_i[1]};
  logic parity_105;
  assign parity_105 = ^{select_18[7:5], select_18[1:0], pixel_i[7:5], pixel_i[1:0]};
  logic [31:0] select_106;
  assign select_106 = end_v_i ? {parity_35, xor_93[12], parity_105, xor_82[11], parity_104, parity_103, parity_91, parity_102, parity_101, parity_89, parity_100, parity_99, parity_98, parity_86, parity_74, parity_62, parity_97, parity_85, parity_73, xor_59[3], parity_50, parity_45, parity_96, parity_95, xor_82[1], xor_70[1], parity_94, parity_83, parity_71, parity_60, xor_48[0], parity_43} : previous_crc_q;
  // hls/stages/health.hpp:62
  logic equal_108;
  assign equal_108 = previous_crc_q == {parity_35, xor_93[12], parity_105, xor_82[11], parity_104, parity_103, parity_91, parity_102, parity_101, parity_89, parity_100, parity_99, parity_98, parity_86, parity_74, parity_62, parity_97, parity_85, parity_73, xor_59[3], parity_50, parity_45, parity_96, parity_95, xor_82[1], xor_70[1], parity_94, parity_83, parity_71, parity_60, xor_48[0], parity_43};
  // hls/stages/health.hpp:63
  logic [7:0] select_112;
  assign select_112 = equal_108 ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  logic [7:0] select_113;
  assign select_113 = has_previous_q ? select_112 : 8'h0;
  // hls/stages/health.hpp:54
  logic [7:0] select_115;
  assign select_115 = first_i ? 8'hff : darkest_q;
  logic [7:0] select_117;
  assign select_117 = (pixel_i < select_115) ? pixel_i : select_115;
  // hls/stages/health.hpp:55
  logic [7:0] select_118;
  assign select_118 = first_i ? 8'h0 : brightest_q;
  logic [7:0] select_120;
  assign select_120 = (select_118 < pixel_i) ? pixel_i : select_118;
  // hls/stages/health.hpp:56
  logic not_123;
  assign not_123 = ~(cfg_dark_level_i < pixel_i);
  logic [17:0] sum_124;
  assign sum_124 = (first_i ? 18'h0 : dark_q) + {17'h0, not_123};
  // hls/stages/health.hpp:57
  logic not_127;
  assign not_127 = ~(pixel_i < cfg_bright_level_i);
  logic [17:0] sum_128;
  assign sum_128 = (first_i ? 18'h0 : bright_q) + {17'h0, not_127};
  // hls/stages/health.hpp:66
  logic less_129;
  assign less_129 = cfg_dark_limit_i < sum_124;
  // hls/stages/health.hpp:67
  logic less_131;
  assign less_131 = cfg_bright_limit_i < sum_128;
  // hls/stages/health.hpp:68
  logic and_138;
  assign and_138 = (~(cfg_contrast_limit_i < (select_120 - select_117))) & (~(less_129 | less_131));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      crc_q <= 32'h0;
      previous_crc_q <= 32'h0;
      has_previous_q <= 1'b0;
      repeats_q <= 8'h0;
      darkest_q <= 8'h0;
      brightest_q <= 8'h0;
      dark_q <= 18'h0;
      bright_q <= 18'h0;
    end else if (s0_en) begin
      crc_q <= {parity_35, xor_93[12], parity_105, xor_82[11], parity_104, parity_103, parity_91, parity_102, parity_101, parity_89, parity_100, parity_99, parity_98, parity_86, parity_74, parity_62, parity_97, parity_85, parity_73, xor_59[3], parity_50, parity_45, parity_96, parity_95, xor_82[1], xor_70[1], parity_94, parity_83, parity_71, parity_60, xor_48[0], parity_43};
      previous_crc_q <= select_106;
      has_previous_q <= end_v_i | has_previous_q;
      repeats_q <= end_v_i ? select_113 : repeats_q;
      darkest_q <= select_117;
      brightest_q <= select_120;
      dark_q <= sum_124;
      bright_q <= sum_128;
    end
  end

  logic and_130_s1_q;
  logic and_132_s1_q;
  logic and_139_s1_q;
  logic and_142_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      and_130_s1_q <= end_v_i & less_129;
      and_132_s1_q <= end_v_i & less_131;
      and_139_s1_q <= end_v_i & and_138;
      and_142_s1_q <= end_v_i & ((cfg_frozen_limit_i + 8'hff) < select_113);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = and_130_s1_q;
  assign white_o = and_132_s1_q;
  assign constant_o = and_139_s1_q;
  assign frozen_o = and_142_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & end_v_i;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{xor_93[11:0], xor_82[10:2], xor_82[0], xor_70[12], xor_70[10:2], xor_70[0], xor_59[12], xor_59[10:4], xor_59[2], xor_59[0], xor_48[12], xor_48[10:2], xor_42[12], xor_42[4:2], xor_42[0], xor_34[12], xor_34[10], xor_34[8], xor_34[6], xor_34[3:2], xor_34[0], xor_19[6]};

endmodule
