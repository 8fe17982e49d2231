// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Ballot<horopter::hls::profiles::vga>, hls/stages/ballot.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 13 bits, pipeline 52 bits, memories 172800 bits.
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
  input  logic [3:0] cfg_similar_i,
  input  logic [7:0] cfg_quorum_i,
  input  logic [7:0] cfg_clear_quorum_i,
  output logic valid_o,
  output logic skin_o,
  output logic clear_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o
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
  // hls/stages/ballot.hpp:34
  logic [9:0] select_16;
  assign select_16 = marks_first_i ? 10'h0 : (raster_row_ended_q ? 10'h0 : (raster_column_q + 10'h1));
  // hls/stages/ballot.hpp:37
  logic or_18;
  assign or_18 = marks_first_i | running_q;

  // Memory memory, 640 x 270, DISTANCE 16, hls/stages/ballot.hpp:80; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [269:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 270'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = running_q ? select_16 : 10'h0;
  logic memory_re;
  assign memory_re = s0_en & or_18;
  logic [269:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_16;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_18 : (marks_first_i & or_18);
    end
  end

  logic [7:0] vote_s1_q;
  logic firm_s1_q;
  logic [5:0] grey_s1_q;
  logic exists_s1_q;
  logic marks_first_s1_q;
  logic running_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      vote_s1_q <= $unsigned(vote_i);
      firm_s1_q <= firm_i;
      grey_s1_q <= grey_i;
      exists_s1_q <= exists_i;
      marks_first_s1_q <= marks_first_i;
      running_s1_q <= running_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/ballot.hpp:34
  logic and_21;
  assign and_21 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/ballot.hpp:38
  logic [7:0] select_23;
  assign select_23 = running_s1_q ? memory_rdata_q[7:0] : (marks_first_s1_q ? memory_rdata_q[7:0] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_24;
  assign select_24 = and_21 ? select_23 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_26;
  assign select_26 = running_s1_q ? memory_rdata_q[13:8] : (marks_first_s1_q ? memory_rdata_q[13:8] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_27;
  assign select_27 = and_21 ? select_26 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_29;
  assign select_29 = running_s1_q ? memory_rdata_q[14] : (marks_first_s1_q & memory_rdata_q[14]);
  // hls/stages/ballot.hpp:41
  logic and_30;
  assign and_30 = and_21 & select_29;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_32;
  assign select_32 = running_s1_q ? memory_rdata_q[22:15] : (marks_first_s1_q ? memory_rdata_q[22:15] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_33;
  assign select_33 = and_21 ? select_32 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_35;
  assign select_35 = running_s1_q ? memory_rdata_q[28:23] : (marks_first_s1_q ? memory_rdata_q[28:23] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_36;
  assign select_36 = and_21 ? select_35 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_38;
  assign select_38 = running_s1_q ? memory_rdata_q[29] : (marks_first_s1_q & memory_rdata_q[29]);
  // hls/stages/ballot.hpp:41
  logic and_39;
  assign and_39 = and_21 & select_38;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_41;
  assign select_41 = running_s1_q ? memory_rdata_q[37:30] : (marks_first_s1_q ? memory_rdata_q[37:30] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_42;
  assign select_42 = and_21 ? select_41 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_44;
  assign select_44 = running_s1_q ? memory_rdata_q[43:38] : (marks_first_s1_q ? memory_rdata_q[43:38] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_45;
  assign select_45 = and_21 ? select_44 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_47;
  assign select_47 = running_s1_q ? memory_rdata_q[44] : (marks_first_s1_q & memory_rdata_q[44]);
  // hls/stages/ballot.hpp:41
  logic and_48;
  assign and_48 = and_21 & select_47;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_50;
  assign select_50 = running_s1_q ? memory_rdata_q[52:45] : (marks_first_s1_q ? memory_rdata_q[52:45] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_51;
  assign select_51 = and_21 ? select_50 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_53;
  assign select_53 = running_s1_q ? memory_rdata_q[58:53] : (marks_first_s1_q ? memory_rdata_q[58:53] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_54;
  assign select_54 = and_21 ? select_53 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_56;
  assign select_56 = running_s1_q ? memory_rdata_q[59] : (marks_first_s1_q & memory_rdata_q[59]);
  // hls/stages/ballot.hpp:41
  logic and_57;
  assign and_57 = and_21 & select_56;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_59;
  assign select_59 = running_s1_q ? memory_rdata_q[67:60] : (marks_first_s1_q ? memory_rdata_q[67:60] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_60;
  assign select_60 = and_21 ? select_59 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_62;
  assign select_62 = running_s1_q ? memory_rdata_q[73:68] : (marks_first_s1_q ? memory_rdata_q[73:68] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_63;
  assign select_63 = and_21 ? select_62 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_65;
  assign select_65 = running_s1_q ? memory_rdata_q[74] : (marks_first_s1_q & memory_rdata_q[74]);
  // hls/stages/ballot.hpp:41
  logic and_66;
  assign and_66 = and_21 & select_65;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_68;
  assign select_68 = running_s1_q ? memory_rdata_q[82:75] : (marks_first_s1_q ? memory_rdata_q[82:75] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_69;
  assign select_69 = and_21 ? select_68 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_71;
  assign select_71 = running_s1_q ? memory_rdata_q[88:83] : (marks_first_s1_q ? memory_rdata_q[88:83] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_72;
  assign select_72 = and_21 ? select_71 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_74;
  assign select_74 = running_s1_q ? memory_rdata_q[89] : (marks_first_s1_q & memory_rdata_q[89]);
  // hls/stages/ballot.hpp:41
  logic and_75;
  assign and_75 = and_21 & select_74;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_77;
  assign select_77 = running_s1_q ? memory_rdata_q[97:90] : (marks_first_s1_q ? memory_rdata_q[97:90] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_78;
  assign select_78 = and_21 ? select_77 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_80;
  assign select_80 = running_s1_q ? memory_rdata_q[103:98] : (marks_first_s1_q ? memory_rdata_q[103:98] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_81;
  assign select_81 = and_21 ? select_80 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_83;
  assign select_83 = running_s1_q ? memory_rdata_q[104] : (marks_first_s1_q & memory_rdata_q[104]);
  // hls/stages/ballot.hpp:41
  logic and_84;
  assign and_84 = and_21 & select_83;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_86;
  assign select_86 = running_s1_q ? memory_rdata_q[112:105] : (marks_first_s1_q ? memory_rdata_q[112:105] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_87;
  assign select_87 = and_21 ? select_86 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_89;
  assign select_89 = running_s1_q ? memory_rdata_q[118:113] : (marks_first_s1_q ? memory_rdata_q[118:113] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_90;
  assign select_90 = and_21 ? select_89 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_92;
  assign select_92 = running_s1_q ? memory_rdata_q[119] : (marks_first_s1_q & memory_rdata_q[119]);
  // hls/stages/ballot.hpp:41
  logic and_93;
  assign and_93 = and_21 & select_92;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_95;
  assign select_95 = running_s1_q ? memory_rdata_q[127:120] : (marks_first_s1_q ? memory_rdata_q[127:120] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_96;
  assign select_96 = and_21 ? select_95 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_98;
  assign select_98 = running_s1_q ? memory_rdata_q[133:128] : (marks_first_s1_q ? memory_rdata_q[133:128] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_99;
  assign select_99 = and_21 ? select_98 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_101;
  assign select_101 = running_s1_q ? memory_rdata_q[142:135] : (marks_first_s1_q ? memory_rdata_q[142:135] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_102;
  assign select_102 = and_21 ? select_101 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_104;
  assign select_104 = running_s1_q ? memory_rdata_q[148:143] : (marks_first_s1_q ? memory_rdata_q[148:143] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_105;
  assign select_105 = and_21 ? select_104 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_107;
  assign select_107 = running_s1_q ? memory_rdata_q[156:149] : (marks_first_s1_q ? memory_rdata_q[156:149] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_108;
  assign select_108 = and_21 ? select_107 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_110;
  assign select_110 = running_s1_q ? memory_rdata_q[162:157] : (marks_first_s1_q ? memory_rdata_q[162:157] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_111;
  assign select_111 = and_21 ? select_110 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_113;
  assign select_113 = running_s1_q ? memory_rdata_q[170:163] : (marks_first_s1_q ? memory_rdata_q[170:163] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_114;
  assign select_114 = and_21 ? select_113 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_116;
  assign select_116 = running_s1_q ? memory_rdata_q[176:171] : (marks_first_s1_q ? memory_rdata_q[176:171] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_117;
  assign select_117 = and_21 ? select_116 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_119;
  assign select_119 = running_s1_q ? memory_rdata_q[184:177] : (marks_first_s1_q ? memory_rdata_q[184:177] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_120;
  assign select_120 = and_21 ? select_119 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_122;
  assign select_122 = running_s1_q ? memory_rdata_q[190:185] : (marks_first_s1_q ? memory_rdata_q[190:185] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_123;
  assign select_123 = and_21 ? select_122 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_125;
  assign select_125 = running_s1_q ? memory_rdata_q[198:191] : (marks_first_s1_q ? memory_rdata_q[198:191] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_126;
  assign select_126 = and_21 ? select_125 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_128;
  assign select_128 = running_s1_q ? memory_rdata_q[204:199] : (marks_first_s1_q ? memory_rdata_q[204:199] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_129;
  assign select_129 = and_21 ? select_128 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_131;
  assign select_131 = running_s1_q ? memory_rdata_q[212:205] : (marks_first_s1_q ? memory_rdata_q[212:205] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_132;
  assign select_132 = and_21 ? select_131 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_134;
  assign select_134 = running_s1_q ? memory_rdata_q[218:213] : (marks_first_s1_q ? memory_rdata_q[218:213] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_135;
  assign select_135 = and_21 ? select_134 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_137;
  assign select_137 = running_s1_q ? memory_rdata_q[226:219] : (marks_first_s1_q ? memory_rdata_q[226:219] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_138;
  assign select_138 = and_21 ? select_137 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_140;
  assign select_140 = running_s1_q ? memory_rdata_q[232:227] : (marks_first_s1_q ? memory_rdata_q[232:227] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_141;
  assign select_141 = and_21 ? select_140 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_143;
  assign select_143 = running_s1_q ? memory_rdata_q[240:233] : (marks_first_s1_q ? memory_rdata_q[240:233] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_144;
  assign select_144 = and_21 ? select_143 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_146;
  assign select_146 = running_s1_q ? memory_rdata_q[246:241] : (marks_first_s1_q ? memory_rdata_q[246:241] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_147;
  assign select_147 = and_21 ? select_146 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [8:0] select_149;
  assign select_149 = running_s1_q ? memory_rdata_q[269:261] : (marks_first_s1_q ? memory_rdata_q[269:261] : 9'h0);
  // hls/stages/ballot.hpp:41
  logic [8:0] select_150;
  assign select_150 = and_21 ? select_149 : 9'h0;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_154;
  assign difference_154 = {1'b0, grey_s1_q} - {1'b0, select_99};
  logic [5:0] xor_155;
  assign xor_155 = difference_154[5:0] ^ {6{difference_154[6]}};
  logic [6:0] difference;
  assign difference = {6'h0, difference_154[6]} + {1'b0, xor_155};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_158;
  assign select_158 = ({3'h0, cfg_similar_i} < difference) ? 8'h0 : vote_s1_q;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_159;
  assign difference_159 = {1'b0, select_147} - {1'b0, select_99};
  logic [5:0] xor_160;
  assign xor_160 = difference_159[5:0] ^ {6{difference_159[6]}};
  logic [6:0] difference_2;
  assign difference_2 = {6'h0, difference_159[6]} + {1'b0, xor_160};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_163;
  assign select_163 = ({3'h0, cfg_similar_i} < difference_2) ? 8'h0 : select_144;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_165;
  assign select_165 = running_s1_q ? memory_rdata_q[260:255] : (marks_first_s1_q ? memory_rdata_q[260:255] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_166;
  assign select_166 = and_21 ? select_165 : 6'h0;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_167;
  assign difference_167 = {1'b0, select_166} - {1'b0, select_99};
  logic [5:0] xor_168;
  assign xor_168 = difference_167[5:0] ^ {6{difference_167[6]}};
  logic [6:0] difference_3;
  assign difference_3 = {6'h0, difference_167[6]} + {1'b0, xor_168};
  // hls/stages/ballot.hpp:38
  logic [7:0] select_172;
  assign select_172 = running_s1_q ? memory_rdata_q[254:247] : (marks_first_s1_q ? memory_rdata_q[254:247] : 8'h0);
  // hls/stages/ballot.hpp:47
  logic [7:0] select_174;
  assign select_174 = ({3'h0, cfg_similar_i} < difference_3) ? 8'h0 : (and_21 ? select_172 : 8'h0);
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_175;
  assign sum_175 = {select_163[7], select_163} + {select_174[7], select_174};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_177;
  assign difference_177 = {1'b0, select_27} - {1'b0, select_99};
  logic [5:0] xor_178;
  assign xor_178 = difference_177[5:0] ^ {6{difference_177[6]}};
  logic [6:0] difference_4;
  assign difference_4 = {6'h0, difference_177[6]} + {1'b0, xor_178};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_181;
  assign select_181 = ({3'h0, cfg_similar_i} < difference_4) ? 8'h0 : select_24;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_182;
  assign difference_182 = {1'b0, select_36} - {1'b0, select_99};
  logic [5:0] xor_183;
  assign xor_183 = difference_182[5:0] ^ {6{difference_182[6]}};
  logic [6:0] difference_5;
  assign difference_5 = {6'h0, difference_182[6]} + {1'b0, xor_183};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_186;
  assign select_186 = ({3'h0, cfg_similar_i} < difference_5) ? 8'h0 : select_33;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_187;
  assign sum_187 = {select_181[7], select_181} + {select_186[7], select_186};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_188;
  assign difference_188 = {1'b0, select_45} - {1'b0, select_99};
  logic [5:0] xor_189;
  assign xor_189 = difference_188[5:0] ^ {6{difference_188[6]}};
  logic [6:0] difference_6;
  assign difference_6 = {6'h0, difference_188[6]} + {1'b0, xor_189};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_192;
  assign select_192 = ({3'h0, cfg_similar_i} < difference_6) ? 8'h0 : select_42;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_193;
  assign difference_193 = {1'b0, select_54} - {1'b0, select_99};
  logic [5:0] xor_194;
  assign xor_194 = difference_193[5:0] ^ {6{difference_193[6]}};
  logic [6:0] difference_7;
  assign difference_7 = {6'h0, difference_193[6]} + {1'b0, xor_194};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_197;
  assign select_197 = ({3'h0, cfg_similar_i} < difference_7) ? 8'h0 : select_51;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_198;
  assign sum_198 = {select_192[7], select_192} + {select_197[7], select_197};
  logic [9:0] sum_199;
  assign sum_199 = {sum_187[8], sum_187} + {sum_198[8], sum_198};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_200;
  assign difference_200 = {1'b0, select_63} - {1'b0, select_99};
  logic [5:0] xor_201;
  assign xor_201 = difference_200[5:0] ^ {6{difference_200[6]}};
  logic [6:0] difference_8;
  assign difference_8 = {6'h0, difference_200[6]} + {1'b0, xor_201};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_204;
  assign select_204 = ({3'h0, cfg_similar_i} < difference_8) ? 8'h0 : select_60;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_205;
  assign difference_205 = {1'b0, select_72} - {1'b0, select_99};
  logic [5:0] xor_206;
  assign xor_206 = difference_205[5:0] ^ {6{difference_205[6]}};
  logic [6:0] difference_9;
  assign difference_9 = {6'h0, difference_205[6]} + {1'b0, xor_206};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_209;
  assign select_209 = ({3'h0, cfg_similar_i} < difference_9) ? 8'h0 : select_69;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_210;
  assign sum_210 = {select_204[7], select_204} + {select_209[7], select_209};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_211;
  assign difference_211 = {1'b0, select_81} - {1'b0, select_99};
  logic [5:0] xor_212;
  assign xor_212 = difference_211[5:0] ^ {6{difference_211[6]}};
  logic [6:0] difference_10;
  assign difference_10 = {6'h0, difference_211[6]} + {1'b0, xor_212};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_215;
  assign select_215 = ({3'h0, cfg_similar_i} < difference_10) ? 8'h0 : select_78;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_216;
  assign difference_216 = {1'b0, select_90} - {1'b0, select_99};
  logic [5:0] xor_217;
  assign xor_217 = difference_216[5:0] ^ {6{difference_216[6]}};
  logic [6:0] difference_11;
  assign difference_11 = {6'h0, difference_216[6]} + {1'b0, xor_217};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_220;
  assign select_220 = ({3'h0, cfg_similar_i} < difference_11) ? 8'h0 : select_87;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_221;
  assign sum_221 = {select_215[7], select_215} + {select_220[7], select_220};
  logic [9:0] sum_222;
  assign sum_222 = {sum_210[8], sum_210} + {sum_221[8], sum_221};
  logic [10:0] sum_223;
  assign sum_223 = {sum_199[9], sum_199} + {sum_222[9], sum_222};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_224;
  assign difference_224 = {1'b0, select_105} - {1'b0, select_99};
  logic [5:0] xor_225;
  assign xor_225 = difference_224[5:0] ^ {6{difference_224[6]}};
  logic [6:0] difference_12;
  assign difference_12 = {6'h0, difference_224[6]} + {1'b0, xor_225};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_228;
  assign select_228 = ({3'h0, cfg_similar_i} < difference_12) ? 8'h0 : select_102;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_229;
  assign sum_229 = {select_96[7], select_96} + {select_228[7], select_228};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_230;
  assign difference_230 = {1'b0, select_111} - {1'b0, select_99};
  logic [5:0] xor_231;
  assign xor_231 = difference_230[5:0] ^ {6{difference_230[6]}};
  logic [6:0] difference_13;
  assign difference_13 = {6'h0, difference_230[6]} + {1'b0, xor_231};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_234;
  assign select_234 = ({3'h0, cfg_similar_i} < difference_13) ? 8'h0 : select_108;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_235;
  assign difference_235 = {1'b0, select_117} - {1'b0, select_99};
  logic [5:0] xor_236;
  assign xor_236 = difference_235[5:0] ^ {6{difference_235[6]}};
  logic [6:0] difference_14;
  assign difference_14 = {6'h0, difference_235[6]} + {1'b0, xor_236};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_239;
  assign select_239 = ({3'h0, cfg_similar_i} < difference_14) ? 8'h0 : select_114;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_240;
  assign sum_240 = {select_234[7], select_234} + {select_239[7], select_239};
  logic [9:0] sum_241;
  assign sum_241 = {sum_229[8], sum_229} + {sum_240[8], sum_240};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_242;
  assign difference_242 = {1'b0, select_123} - {1'b0, select_99};
  logic [5:0] xor_243;
  assign xor_243 = difference_242[5:0] ^ {6{difference_242[6]}};
  logic [6:0] difference_15;
  assign difference_15 = {6'h0, difference_242[6]} + {1'b0, xor_243};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_246;
  assign select_246 = ({3'h0, cfg_similar_i} < difference_15) ? 8'h0 : select_120;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_247;
  assign difference_247 = {1'b0, select_129} - {1'b0, select_99};
  logic [5:0] xor_248;
  assign xor_248 = difference_247[5:0] ^ {6{difference_247[6]}};
  logic [6:0] difference_16;
  assign difference_16 = {6'h0, difference_247[6]} + {1'b0, xor_248};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_251;
  assign select_251 = ({3'h0, cfg_similar_i} < difference_16) ? 8'h0 : select_126;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_252;
  assign sum_252 = {select_246[7], select_246} + {select_251[7], select_251};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_253;
  assign difference_253 = {1'b0, select_135} - {1'b0, select_99};
  logic [5:0] xor_254;
  assign xor_254 = difference_253[5:0] ^ {6{difference_253[6]}};
  logic [6:0] difference_17;
  assign difference_17 = {6'h0, difference_253[6]} + {1'b0, xor_254};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_257;
  assign select_257 = ({3'h0, cfg_similar_i} < difference_17) ? 8'h0 : select_132;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_258;
  assign difference_258 = {1'b0, select_141} - {1'b0, select_99};
  logic [5:0] xor_259;
  assign xor_259 = difference_258[5:0] ^ {6{difference_258[6]}};
  logic [6:0] difference_18;
  assign difference_18 = {6'h0, difference_258[6]} + {1'b0, xor_259};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_262;
  assign select_262 = ({3'h0, cfg_similar_i} < difference_18) ? 8'h0 : select_138;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_263;
  assign sum_263 = {select_257[7], select_257} + {select_262[7], select_262};
  logic [9:0] sum_264;
  assign sum_264 = {sum_252[8], sum_252} + {sum_263[8], sum_263};
  logic [10:0] sum_265;
  assign sum_265 = {sum_241[9], sum_241} + {sum_264[9], sum_264};
  // hls/stages/ballot.hpp:38
  logic select_276;
  assign select_276 = running_s1_q ? memory_rdata_q[134] : (marks_first_s1_q & memory_rdata_q[134]);

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en & running_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_150[7:0], firm_s1_q, select_147, select_144, select_141, select_138, select_135, select_132, select_129, select_126, select_123, select_120, select_117, select_114, select_111, select_108, select_105, select_102, select_99, select_96, and_93, select_90, select_87, and_84, select_81, select_78, and_75, select_72, select_69, and_66, select_63, select_60, and_57, select_54, select_51, and_48, select_45, select_42, and_39, select_36, select_33, and_30, select_27, select_24, exists_s1_q, grey_s1_q, vote_s1_q};
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
      raster_rows_q <= raster_row_ended_q | and_21;
    end
  end

  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic select_150_s2_q;
  logic [9:0] sum_176_s2_q;
  logic [11:0] sum_266_s2_q;
  logic and_277_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      select_150_s2_q <= select_150[8];
      sum_176_s2_q <= {{2{select_158[7]}}, select_158} + {sum_175[8], sum_175};
      sum_266_s2_q <= {sum_223[10], sum_223} + {sum_265[10], sum_265};
      and_277_s2_q <= and_21 & select_276;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:50
  logic [12:0] sum_267;
  assign sum_267 = {{3{sum_176_s2_q[9]}}, sum_176_s2_q} + {sum_266_s2_q[11], sum_266_s2_q};
  // hls/stages/ballot.hpp:61
  logic [13:0] difference_271;
  assign difference_271 = 14'h0 - {sum_267[12], sum_267};
  logic less_272;
  assign less_272 = $signed(difference_271[13:3]) < $signed({3'h0, cfg_clear_quorum_i});

  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic not_269_s3_q;
  logic or_274_s3_q;
  logic and_277_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      not_269_s3_q <= ~($signed(sum_267) < $signed({5'h0, cfg_quorum_i}));
      or_274_s3_q <= (select_150_s2_q & sum_267[12]) | (~less_272);
      and_277_s3_q <= and_277_s2_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_o = not_269_s3_q;
  assign clear_o = or_274_s3_q;
  assign exists_o = and_277_s3_q;
  assign marks_first_o = marks_first_s3_q;
  assign marks_last_o = marks_last_s3_q;
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
  assign unused_bits = ^difference_271[2:0];

endmodule
