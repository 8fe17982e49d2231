// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Ballot<horopter::hls::profiles::vga>, hls/stages/ballot.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 13 bits, pipeline 58 bits, memories 173440 bits.
module horopter_ballot (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic signed [7:0] vote_i,
  input  logic firm_i,
  input  logic [5:0] grey_i,
  input  logic exists_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  input  logic [3:0] cfg_similar_i,
  input  logic [7:0] cfg_quorum_i,
  input  logic [7:0] cfg_clear_quorum_i,
  output logic parity_error_o,
  output logic valid_o,
  output logic skin_o,
  output logic clear_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q;
  logic s0_en, s1_en, s2_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [9:0] raster_column_q;
  logic raster_row_ended_q;
  logic running_q;
  // hls/stages/ballot.hpp:40
  logic [9:0] select_18;
  assign select_18 = marks_first_i ? 10'h0 : (raster_row_ended_q ? 10'h0 : (raster_column_q + 10'h1));
  // hls/stages/ballot.hpp:44
  logic or_20;
  assign or_20 = marks_first_i | running_q;

  // Memory memory, 640 x 270 and parity, DISTANCE 16, hls/stages/ballot.hpp:98; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [270:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 271'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = running_q ? select_18 : 10'h0;
  logic memory_re;
  assign memory_re = s0_en & or_20;
  logic [270:0] memory_word_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_word_q <= memory_mem[memory_raddr];
  end
  logic [269:0] memory_rdata_q;
  assign memory_rdata_q = memory_word_q[269:0];
  logic memory_read_q, memory_error;
  always_ff @(posedge clk_i) memory_read_q <= rst_ni & memory_re;
  assign memory_error = memory_read_q & ^memory_word_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_18;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_20 : (marks_first_i & or_20);
    end
  end

  logic [7:0] vote_s1_q;
  logic firm_s1_q;
  logic [5:0] grey_s1_q;
  logic exists_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic running_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      vote_s1_q <= $unsigned(vote_i);
      firm_s1_q <= firm_i;
      grey_s1_q <= grey_i;
      exists_s1_q <= exists_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      running_s1_q <= running_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/ballot.hpp:40
  logic and_23;
  assign and_23 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/ballot.hpp:49
  logic [7:0] select_25;
  assign select_25 = running_s1_q ? memory_rdata_q[7:0] : (marks_first_s1_q ? memory_rdata_q[7:0] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_26;
  assign select_26 = and_23 ? select_25 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_28;
  assign select_28 = running_s1_q ? memory_rdata_q[13:8] : (marks_first_s1_q ? memory_rdata_q[13:8] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_29;
  assign select_29 = and_23 ? select_28 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic select_31;
  assign select_31 = running_s1_q ? memory_rdata_q[14] : (marks_first_s1_q & memory_rdata_q[14]);
  // hls/stages/ballot.hpp:52
  logic and_32;
  assign and_32 = and_23 & select_31;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_34;
  assign select_34 = running_s1_q ? memory_rdata_q[22:15] : (marks_first_s1_q ? memory_rdata_q[22:15] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_35;
  assign select_35 = and_23 ? select_34 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_37;
  assign select_37 = running_s1_q ? memory_rdata_q[28:23] : (marks_first_s1_q ? memory_rdata_q[28:23] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_38;
  assign select_38 = and_23 ? select_37 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic select_40;
  assign select_40 = running_s1_q ? memory_rdata_q[29] : (marks_first_s1_q & memory_rdata_q[29]);
  // hls/stages/ballot.hpp:52
  logic and_41;
  assign and_41 = and_23 & select_40;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_43;
  assign select_43 = running_s1_q ? memory_rdata_q[37:30] : (marks_first_s1_q ? memory_rdata_q[37:30] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_44;
  assign select_44 = and_23 ? select_43 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_46;
  assign select_46 = running_s1_q ? memory_rdata_q[43:38] : (marks_first_s1_q ? memory_rdata_q[43:38] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_47;
  assign select_47 = and_23 ? select_46 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic select_49;
  assign select_49 = running_s1_q ? memory_rdata_q[44] : (marks_first_s1_q & memory_rdata_q[44]);
  // hls/stages/ballot.hpp:52
  logic and_50;
  assign and_50 = and_23 & select_49;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_52;
  assign select_52 = running_s1_q ? memory_rdata_q[52:45] : (marks_first_s1_q ? memory_rdata_q[52:45] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_53;
  assign select_53 = and_23 ? select_52 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_55;
  assign select_55 = running_s1_q ? memory_rdata_q[58:53] : (marks_first_s1_q ? memory_rdata_q[58:53] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_56;
  assign select_56 = and_23 ? select_55 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic select_58;
  assign select_58 = running_s1_q ? memory_rdata_q[59] : (marks_first_s1_q & memory_rdata_q[59]);
  // hls/stages/ballot.hpp:52
  logic and_59;
  assign and_59 = and_23 & select_58;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_61;
  assign select_61 = running_s1_q ? memory_rdata_q[67:60] : (marks_first_s1_q ? memory_rdata_q[67:60] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_62;
  assign select_62 = and_23 ? select_61 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_64;
  assign select_64 = running_s1_q ? memory_rdata_q[73:68] : (marks_first_s1_q ? memory_rdata_q[73:68] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_65;
  assign select_65 = and_23 ? select_64 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic select_67;
  assign select_67 = running_s1_q ? memory_rdata_q[74] : (marks_first_s1_q & memory_rdata_q[74]);
  // hls/stages/ballot.hpp:52
  logic and_68;
  assign and_68 = and_23 & select_67;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_70;
  assign select_70 = running_s1_q ? memory_rdata_q[82:75] : (marks_first_s1_q ? memory_rdata_q[82:75] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_71;
  assign select_71 = and_23 ? select_70 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_73;
  assign select_73 = running_s1_q ? memory_rdata_q[88:83] : (marks_first_s1_q ? memory_rdata_q[88:83] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_74;
  assign select_74 = and_23 ? select_73 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic select_76;
  assign select_76 = running_s1_q ? memory_rdata_q[89] : (marks_first_s1_q & memory_rdata_q[89]);
  // hls/stages/ballot.hpp:52
  logic and_77;
  assign and_77 = and_23 & select_76;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_79;
  assign select_79 = running_s1_q ? memory_rdata_q[97:90] : (marks_first_s1_q ? memory_rdata_q[97:90] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_80;
  assign select_80 = and_23 ? select_79 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_82;
  assign select_82 = running_s1_q ? memory_rdata_q[103:98] : (marks_first_s1_q ? memory_rdata_q[103:98] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_83;
  assign select_83 = and_23 ? select_82 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic select_85;
  assign select_85 = running_s1_q ? memory_rdata_q[104] : (marks_first_s1_q & memory_rdata_q[104]);
  // hls/stages/ballot.hpp:52
  logic and_86;
  assign and_86 = and_23 & select_85;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_88;
  assign select_88 = running_s1_q ? memory_rdata_q[112:105] : (marks_first_s1_q ? memory_rdata_q[112:105] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_89;
  assign select_89 = and_23 ? select_88 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_91;
  assign select_91 = running_s1_q ? memory_rdata_q[118:113] : (marks_first_s1_q ? memory_rdata_q[118:113] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_92;
  assign select_92 = and_23 ? select_91 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic select_94;
  assign select_94 = running_s1_q ? memory_rdata_q[119] : (marks_first_s1_q & memory_rdata_q[119]);
  // hls/stages/ballot.hpp:52
  logic and_95;
  assign and_95 = and_23 & select_94;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_97;
  assign select_97 = running_s1_q ? memory_rdata_q[127:120] : (marks_first_s1_q ? memory_rdata_q[127:120] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_98;
  assign select_98 = and_23 ? select_97 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_100;
  assign select_100 = running_s1_q ? memory_rdata_q[133:128] : (marks_first_s1_q ? memory_rdata_q[133:128] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_101;
  assign select_101 = and_23 ? select_100 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_103;
  assign select_103 = running_s1_q ? memory_rdata_q[142:135] : (marks_first_s1_q ? memory_rdata_q[142:135] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_104;
  assign select_104 = and_23 ? select_103 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_106;
  assign select_106 = running_s1_q ? memory_rdata_q[148:143] : (marks_first_s1_q ? memory_rdata_q[148:143] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_107;
  assign select_107 = and_23 ? select_106 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_109;
  assign select_109 = running_s1_q ? memory_rdata_q[156:149] : (marks_first_s1_q ? memory_rdata_q[156:149] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_110;
  assign select_110 = and_23 ? select_109 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_112;
  assign select_112 = running_s1_q ? memory_rdata_q[162:157] : (marks_first_s1_q ? memory_rdata_q[162:157] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_113;
  assign select_113 = and_23 ? select_112 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_115;
  assign select_115 = running_s1_q ? memory_rdata_q[170:163] : (marks_first_s1_q ? memory_rdata_q[170:163] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_116;
  assign select_116 = and_23 ? select_115 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_118;
  assign select_118 = running_s1_q ? memory_rdata_q[176:171] : (marks_first_s1_q ? memory_rdata_q[176:171] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_119;
  assign select_119 = and_23 ? select_118 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_121;
  assign select_121 = running_s1_q ? memory_rdata_q[184:177] : (marks_first_s1_q ? memory_rdata_q[184:177] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_122;
  assign select_122 = and_23 ? select_121 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_124;
  assign select_124 = running_s1_q ? memory_rdata_q[190:185] : (marks_first_s1_q ? memory_rdata_q[190:185] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_125;
  assign select_125 = and_23 ? select_124 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_127;
  assign select_127 = running_s1_q ? memory_rdata_q[198:191] : (marks_first_s1_q ? memory_rdata_q[198:191] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_128;
  assign select_128 = and_23 ? select_127 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_130;
  assign select_130 = running_s1_q ? memory_rdata_q[204:199] : (marks_first_s1_q ? memory_rdata_q[204:199] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_131;
  assign select_131 = and_23 ? select_130 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_133;
  assign select_133 = running_s1_q ? memory_rdata_q[212:205] : (marks_first_s1_q ? memory_rdata_q[212:205] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_134;
  assign select_134 = and_23 ? select_133 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_136;
  assign select_136 = running_s1_q ? memory_rdata_q[218:213] : (marks_first_s1_q ? memory_rdata_q[218:213] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_137;
  assign select_137 = and_23 ? select_136 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_139;
  assign select_139 = running_s1_q ? memory_rdata_q[226:219] : (marks_first_s1_q ? memory_rdata_q[226:219] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_140;
  assign select_140 = and_23 ? select_139 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_142;
  assign select_142 = running_s1_q ? memory_rdata_q[232:227] : (marks_first_s1_q ? memory_rdata_q[232:227] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_143;
  assign select_143 = and_23 ? select_142 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic [7:0] select_145;
  assign select_145 = running_s1_q ? memory_rdata_q[240:233] : (marks_first_s1_q ? memory_rdata_q[240:233] : 8'h0);
  // hls/stages/ballot.hpp:52
  logic [7:0] select_146;
  assign select_146 = and_23 ? select_145 : 8'h0;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_148;
  assign select_148 = running_s1_q ? memory_rdata_q[246:241] : (marks_first_s1_q ? memory_rdata_q[246:241] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_149;
  assign select_149 = and_23 ? select_148 : 6'h0;
  // hls/stages/ballot.hpp:49
  logic [8:0] select_151;
  assign select_151 = running_s1_q ? memory_rdata_q[269:261] : (marks_first_s1_q ? memory_rdata_q[269:261] : 9'h0);
  // hls/stages/ballot.hpp:52
  logic [8:0] select_152;
  assign select_152 = and_23 ? select_151 : 9'h0;
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_156;
  assign difference_156 = {1'b0, select_38} - {1'b0, select_101};
  logic [5:0] xor_157;
  assign xor_157 = difference_156[5:0] ^ {6{difference_156[6]}};
  logic [6:0] difference;
  assign difference = {6'h0, difference_156[6]} + {1'b0, xor_157};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_160;
  assign select_160 = ({3'h0, cfg_similar_i} < difference) ? 8'h0 : select_35;
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_161;
  assign difference_161 = {1'b0, select_29} - {1'b0, select_101};
  logic [5:0] xor_162;
  assign xor_162 = difference_161[5:0] ^ {6{difference_161[6]}};
  logic [6:0] difference_2;
  assign difference_2 = {6'h0, difference_161[6]} + {1'b0, xor_162};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_165;
  assign select_165 = ({3'h0, cfg_similar_i} < difference_2) ? 8'h0 : select_26;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_166;
  assign sum_166 = {select_160[7], select_160} + {select_165[7], select_165};
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_167;
  assign difference_167 = {1'b0, select_56} - {1'b0, select_101};
  logic [5:0] xor_168;
  assign xor_168 = difference_167[5:0] ^ {6{difference_167[6]}};
  logic [6:0] difference_3;
  assign difference_3 = {6'h0, difference_167[6]} + {1'b0, xor_168};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_171;
  assign select_171 = ({3'h0, cfg_similar_i} < difference_3) ? 8'h0 : select_53;
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_172;
  assign difference_172 = {1'b0, select_47} - {1'b0, select_101};
  logic [5:0] xor_173;
  assign xor_173 = difference_172[5:0] ^ {6{difference_172[6]}};
  logic [6:0] difference_4;
  assign difference_4 = {6'h0, difference_172[6]} + {1'b0, xor_173};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_176;
  assign select_176 = ({3'h0, cfg_similar_i} < difference_4) ? 8'h0 : select_44;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_177;
  assign sum_177 = {select_171[7], select_171} + {select_176[7], select_176};
  logic [9:0] sum_178;
  assign sum_178 = {sum_166[8], sum_166} + {sum_177[8], sum_177};
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_179;
  assign difference_179 = {1'b0, select_74} - {1'b0, select_101};
  logic [5:0] xor_180;
  assign xor_180 = difference_179[5:0] ^ {6{difference_179[6]}};
  logic [6:0] difference_5;
  assign difference_5 = {6'h0, difference_179[6]} + {1'b0, xor_180};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_183;
  assign select_183 = ({3'h0, cfg_similar_i} < difference_5) ? 8'h0 : select_71;
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_184;
  assign difference_184 = {1'b0, select_65} - {1'b0, select_101};
  logic [5:0] xor_185;
  assign xor_185 = difference_184[5:0] ^ {6{difference_184[6]}};
  logic [6:0] difference_6;
  assign difference_6 = {6'h0, difference_184[6]} + {1'b0, xor_185};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_188;
  assign select_188 = ({3'h0, cfg_similar_i} < difference_6) ? 8'h0 : select_62;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_189;
  assign sum_189 = {select_183[7], select_183} + {select_188[7], select_188};
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_190;
  assign difference_190 = {1'b0, select_92} - {1'b0, select_101};
  logic [5:0] xor_191;
  assign xor_191 = difference_190[5:0] ^ {6{difference_190[6]}};
  logic [6:0] difference_7;
  assign difference_7 = {6'h0, difference_190[6]} + {1'b0, xor_191};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_194;
  assign select_194 = ({3'h0, cfg_similar_i} < difference_7) ? 8'h0 : select_89;
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_195;
  assign difference_195 = {1'b0, select_83} - {1'b0, select_101};
  logic [5:0] xor_196;
  assign xor_196 = difference_195[5:0] ^ {6{difference_195[6]}};
  logic [6:0] difference_8;
  assign difference_8 = {6'h0, difference_195[6]} + {1'b0, xor_196};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_199;
  assign select_199 = ({3'h0, cfg_similar_i} < difference_8) ? 8'h0 : select_80;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_200;
  assign sum_200 = {select_194[7], select_194} + {select_199[7], select_199};
  logic [9:0] sum_201;
  assign sum_201 = {sum_189[8], sum_189} + {sum_200[8], sum_200};
  logic [10:0] sum_202;
  assign sum_202 = {sum_178[9], sum_178} + {sum_201[9], sum_201};
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_203;
  assign difference_203 = {1'b0, select_107} - {1'b0, select_101};
  logic [5:0] xor_204;
  assign xor_204 = difference_203[5:0] ^ {6{difference_203[6]}};
  logic [6:0] difference_9;
  assign difference_9 = {6'h0, difference_203[6]} + {1'b0, xor_204};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_207;
  assign select_207 = ({3'h0, cfg_similar_i} < difference_9) ? 8'h0 : select_104;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_208;
  assign sum_208 = {select_98[7], select_98} + {select_207[7], select_207};
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_209;
  assign difference_209 = {1'b0, select_119} - {1'b0, select_101};
  logic [5:0] xor_210;
  assign xor_210 = difference_209[5:0] ^ {6{difference_209[6]}};
  logic [6:0] difference_10;
  assign difference_10 = {6'h0, difference_209[6]} + {1'b0, xor_210};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_213;
  assign select_213 = ({3'h0, cfg_similar_i} < difference_10) ? 8'h0 : select_116;
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_214;
  assign difference_214 = {1'b0, select_113} - {1'b0, select_101};
  logic [5:0] xor_215;
  assign xor_215 = difference_214[5:0] ^ {6{difference_214[6]}};
  logic [6:0] difference_11;
  assign difference_11 = {6'h0, difference_214[6]} + {1'b0, xor_215};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_218;
  assign select_218 = ({3'h0, cfg_similar_i} < difference_11) ? 8'h0 : select_110;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_219;
  assign sum_219 = {select_213[7], select_213} + {select_218[7], select_218};
  logic [9:0] sum_220;
  assign sum_220 = {sum_208[8], sum_208} + {sum_219[8], sum_219};
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_221;
  assign difference_221 = {1'b0, select_131} - {1'b0, select_101};
  logic [5:0] xor_222;
  assign xor_222 = difference_221[5:0] ^ {6{difference_221[6]}};
  logic [6:0] difference_12;
  assign difference_12 = {6'h0, difference_221[6]} + {1'b0, xor_222};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_225;
  assign select_225 = ({3'h0, cfg_similar_i} < difference_12) ? 8'h0 : select_128;
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_226;
  assign difference_226 = {1'b0, select_125} - {1'b0, select_101};
  logic [5:0] xor_227;
  assign xor_227 = difference_226[5:0] ^ {6{difference_226[6]}};
  logic [6:0] difference_13;
  assign difference_13 = {6'h0, difference_226[6]} + {1'b0, xor_227};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_230;
  assign select_230 = ({3'h0, cfg_similar_i} < difference_13) ? 8'h0 : select_122;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_231;
  assign sum_231 = {select_225[7], select_225} + {select_230[7], select_230};
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_232;
  assign difference_232 = {1'b0, select_143} - {1'b0, select_101};
  logic [5:0] xor_233;
  assign xor_233 = difference_232[5:0] ^ {6{difference_232[6]}};
  logic [6:0] difference_14;
  assign difference_14 = {6'h0, difference_232[6]} + {1'b0, xor_233};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_236;
  assign select_236 = ({3'h0, cfg_similar_i} < difference_14) ? 8'h0 : select_140;
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_237;
  assign difference_237 = {1'b0, select_137} - {1'b0, select_101};
  logic [5:0] xor_238;
  assign xor_238 = difference_237[5:0] ^ {6{difference_237[6]}};
  logic [6:0] difference_15;
  assign difference_15 = {6'h0, difference_237[6]} + {1'b0, xor_238};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_241;
  assign select_241 = ({3'h0, cfg_similar_i} < difference_15) ? 8'h0 : select_134;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_242;
  assign sum_242 = {select_236[7], select_236} + {select_241[7], select_241};
  logic [9:0] sum_243;
  assign sum_243 = {sum_231[8], sum_231} + {sum_242[8], sum_242};
  logic [10:0] sum_244;
  assign sum_244 = {sum_220[9], sum_220} + {sum_243[9], sum_243};
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_246;
  assign difference_246 = {1'b0, grey_s1_q} - {1'b0, select_101};
  logic [5:0] xor_247;
  assign xor_247 = difference_246[5:0] ^ {6{difference_246[6]}};
  logic [6:0] difference_16;
  assign difference_16 = {6'h0, difference_246[6]} + {1'b0, xor_247};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_250;
  assign select_250 = ({3'h0, cfg_similar_i} < difference_16) ? 8'h0 : vote_s1_q;
  // hls/stages/ballot.hpp:49
  logic [5:0] select_252;
  assign select_252 = running_s1_q ? memory_rdata_q[260:255] : (marks_first_s1_q ? memory_rdata_q[260:255] : 6'h0);
  // hls/stages/ballot.hpp:52
  logic [5:0] select_253;
  assign select_253 = and_23 ? select_252 : 6'h0;
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_254;
  assign difference_254 = {1'b0, select_253} - {1'b0, select_101};
  logic [5:0] xor_255;
  assign xor_255 = difference_254[5:0] ^ {6{difference_254[6]}};
  logic [6:0] difference_17;
  assign difference_17 = {6'h0, difference_254[6]} + {1'b0, xor_255};
  // hls/stages/ballot.hpp:49
  logic [7:0] select_259;
  assign select_259 = running_s1_q ? memory_rdata_q[254:247] : (marks_first_s1_q ? memory_rdata_q[254:247] : 8'h0);
  // hls/stages/ballot.hpp:58
  logic [7:0] select_261;
  assign select_261 = ({3'h0, cfg_similar_i} < difference_17) ? 8'h0 : (and_23 ? select_259 : 8'h0);
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_262;
  assign difference_262 = {1'b0, select_149} - {1'b0, select_101};
  logic [5:0] xor_263;
  assign xor_263 = difference_262[5:0] ^ {6{difference_262[6]}};
  logic [6:0] difference_18;
  assign difference_18 = {6'h0, difference_262[6]} + {1'b0, xor_263};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_266;
  assign select_266 = ({3'h0, cfg_similar_i} < difference_18) ? 8'h0 : select_146;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_267;
  assign sum_267 = {select_261[7], select_261} + {select_266[7], select_266};
  // hls/stages/ballot.hpp:49
  logic select_278;
  assign select_278 = running_s1_q ? memory_rdata_q[134] : (marks_first_s1_q & memory_rdata_q[134]);

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en & running_q;
  logic [269:0] memory_wdata;
  assign memory_wdata = {select_152[7:0], firm_s1_q, select_149, select_146, select_143, select_140, select_137, select_134, select_131, select_128, select_125, select_122, select_119, select_116, select_113, select_110, select_107, select_104, select_101, select_98, and_95, select_92, select_89, and_86, select_83, select_80, and_77, select_74, select_71, and_68, select_65, select_62, and_59, select_56, select_53, and_50, select_47, select_44, and_41, select_38, select_35, and_32, select_29, select_26, exists_s1_q, grey_s1_q, vote_s1_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {^memory_wdata, memory_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && memory_we) begin
      if (memory_re && memory_raddr == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_waddr >= 10'd640) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 10'd640) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_23;
    end
  end

  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic select_152_s2_q;
  logic [11:0] sum_245_s2_q;
  logic [9:0] sum_268_s2_q;
  logic and_279_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      select_152_s2_q <= select_152[8];
      sum_245_s2_q <= {sum_202[10], sum_202} + {sum_244[10], sum_244};
      sum_268_s2_q <= {{2{select_250[7]}}, select_250} + {sum_267[8], sum_267};
      and_279_s2_q <= and_23 & select_278;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:61
  logic [12:0] sum_269;
  assign sum_269 = {sum_245_s2_q[11], sum_245_s2_q} + {{3{sum_268_s2_q[9]}}, sum_268_s2_q};
  // hls/stages/ballot.hpp:79
  logic [13:0] difference_272;
  assign difference_272 = 14'h0 - {sum_269[12], sum_269};
  logic less_273;
  assign less_273 = $signed(difference_272[13:3]) < $signed({3'h0, cfg_clear_quorum_i});

  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic not_271_s3_q;
  logic or_276_s3_q;
  logic and_279_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      not_271_s3_q <= ~($signed(sum_269) < $signed({5'h0, cfg_quorum_i}));
      or_276_s3_q <= (~less_273) | (select_152_s2_q & sum_269[12]);
      and_279_s3_q <= and_279_s2_q;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (memory_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_o = not_271_s3_q;
  assign clear_o = or_276_s3_q;
  assign exists_o = and_279_s3_q;
  assign marks_first_o = marks_first_s3_q;
  assign marks_last_o = marks_last_s3_q;
  assign marks_seen_o = marks_seen_s3_q;
  assign marks_nearer_o = marks_nearer_s3_q;
  assign valid_o = valid_s3_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^difference_272[2:0];

endmodule
