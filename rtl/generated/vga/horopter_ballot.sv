// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Ballot<horopter::hls::profiles::vga>, hls/stages/ballot.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 13 bits, pipeline 90 bits, memories 172800 bits.
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
  logic [9:0] raster_next_column_q;
  logic raster_row_ended_q;
  logic running_q;
  // hls/stages/ballot.hpp:34
  logic [9:0] select_15;
  assign select_15 = (marks_first_i | raster_row_ended_q) ? 10'h0 : raster_next_column_q;
  // hls/stages/ballot.hpp:37
  logic or_16;
  assign or_16 = marks_first_i | running_q;

  // Memory memory, 640 x 270, DISTANCE 16, hls/stages/ballot.hpp:80; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [269:0] memory_mem [0:639];
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 270'h0;
  logic [9:0] memory_raddr;
  assign memory_raddr = select_15;
  logic memory_re;
  assign memory_re = s0_en & or_16;
  logic [269:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_next_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_next_column_q <= select_15 + 10'h1;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_16 : (marks_first_i & or_16);
    end
  end

  logic [7:0] vote_s1_q;
  logic firm_s1_q;
  logic [5:0] grey_s1_q;
  logic exists_s1_q;
  logic marks_first_s1_q;
  logic running_s1_q;
  logic [9:0] select_15_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      vote_s1_q <= $unsigned(vote_i);
      firm_s1_q <= firm_i;
      grey_s1_q <= grey_i;
      exists_s1_q <= exists_i;
      marks_first_s1_q <= marks_first_i;
      running_s1_q <= running_q;
      select_15_s1_q <= select_15;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/ballot.hpp:34
  logic and_19;
  assign and_19 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/ballot.hpp:38
  logic [7:0] select_21;
  assign select_21 = running_s1_q ? memory_rdata_q[7:0] : (marks_first_s1_q ? memory_rdata_q[7:0] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_22;
  assign select_22 = and_19 ? select_21 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_24;
  assign select_24 = running_s1_q ? memory_rdata_q[13:8] : (marks_first_s1_q ? memory_rdata_q[13:8] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_25;
  assign select_25 = and_19 ? select_24 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_27;
  assign select_27 = running_s1_q ? memory_rdata_q[14] : (marks_first_s1_q & memory_rdata_q[14]);
  // hls/stages/ballot.hpp:41
  logic and_28;
  assign and_28 = and_19 & select_27;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_30;
  assign select_30 = running_s1_q ? memory_rdata_q[22:15] : (marks_first_s1_q ? memory_rdata_q[22:15] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_31;
  assign select_31 = and_19 ? select_30 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_33;
  assign select_33 = running_s1_q ? memory_rdata_q[28:23] : (marks_first_s1_q ? memory_rdata_q[28:23] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_34;
  assign select_34 = and_19 ? select_33 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_36;
  assign select_36 = running_s1_q ? memory_rdata_q[29] : (marks_first_s1_q & memory_rdata_q[29]);
  // hls/stages/ballot.hpp:41
  logic and_37;
  assign and_37 = and_19 & select_36;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_39;
  assign select_39 = running_s1_q ? memory_rdata_q[37:30] : (marks_first_s1_q ? memory_rdata_q[37:30] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_40;
  assign select_40 = and_19 ? select_39 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_42;
  assign select_42 = running_s1_q ? memory_rdata_q[43:38] : (marks_first_s1_q ? memory_rdata_q[43:38] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_43;
  assign select_43 = and_19 ? select_42 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_45;
  assign select_45 = running_s1_q ? memory_rdata_q[44] : (marks_first_s1_q & memory_rdata_q[44]);
  // hls/stages/ballot.hpp:41
  logic and_46;
  assign and_46 = and_19 & select_45;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_48;
  assign select_48 = running_s1_q ? memory_rdata_q[52:45] : (marks_first_s1_q ? memory_rdata_q[52:45] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_49;
  assign select_49 = and_19 ? select_48 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_51;
  assign select_51 = running_s1_q ? memory_rdata_q[58:53] : (marks_first_s1_q ? memory_rdata_q[58:53] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_52;
  assign select_52 = and_19 ? select_51 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_54;
  assign select_54 = running_s1_q ? memory_rdata_q[59] : (marks_first_s1_q & memory_rdata_q[59]);
  // hls/stages/ballot.hpp:41
  logic and_55;
  assign and_55 = and_19 & select_54;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_57;
  assign select_57 = running_s1_q ? memory_rdata_q[67:60] : (marks_first_s1_q ? memory_rdata_q[67:60] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_58;
  assign select_58 = and_19 ? select_57 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_60;
  assign select_60 = running_s1_q ? memory_rdata_q[73:68] : (marks_first_s1_q ? memory_rdata_q[73:68] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_61;
  assign select_61 = and_19 ? select_60 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_63;
  assign select_63 = running_s1_q ? memory_rdata_q[74] : (marks_first_s1_q & memory_rdata_q[74]);
  // hls/stages/ballot.hpp:41
  logic and_64;
  assign and_64 = and_19 & select_63;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_66;
  assign select_66 = running_s1_q ? memory_rdata_q[82:75] : (marks_first_s1_q ? memory_rdata_q[82:75] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_67;
  assign select_67 = and_19 ? select_66 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_69;
  assign select_69 = running_s1_q ? memory_rdata_q[88:83] : (marks_first_s1_q ? memory_rdata_q[88:83] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_70;
  assign select_70 = and_19 ? select_69 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_72;
  assign select_72 = running_s1_q ? memory_rdata_q[89] : (marks_first_s1_q & memory_rdata_q[89]);
  // hls/stages/ballot.hpp:41
  logic and_73;
  assign and_73 = and_19 & select_72;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_75;
  assign select_75 = running_s1_q ? memory_rdata_q[97:90] : (marks_first_s1_q ? memory_rdata_q[97:90] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_76;
  assign select_76 = and_19 ? select_75 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_78;
  assign select_78 = running_s1_q ? memory_rdata_q[103:98] : (marks_first_s1_q ? memory_rdata_q[103:98] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_79;
  assign select_79 = and_19 ? select_78 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_81;
  assign select_81 = running_s1_q ? memory_rdata_q[104] : (marks_first_s1_q & memory_rdata_q[104]);
  // hls/stages/ballot.hpp:41
  logic and_82;
  assign and_82 = and_19 & select_81;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_84;
  assign select_84 = running_s1_q ? memory_rdata_q[112:105] : (marks_first_s1_q ? memory_rdata_q[112:105] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_85;
  assign select_85 = and_19 ? select_84 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_87;
  assign select_87 = running_s1_q ? memory_rdata_q[118:113] : (marks_first_s1_q ? memory_rdata_q[118:113] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_88;
  assign select_88 = and_19 ? select_87 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic select_90;
  assign select_90 = running_s1_q ? memory_rdata_q[119] : (marks_first_s1_q & memory_rdata_q[119]);
  // hls/stages/ballot.hpp:41
  logic and_91;
  assign and_91 = and_19 & select_90;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_93;
  assign select_93 = running_s1_q ? memory_rdata_q[127:120] : (marks_first_s1_q ? memory_rdata_q[127:120] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_94;
  assign select_94 = and_19 ? select_93 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_96;
  assign select_96 = running_s1_q ? memory_rdata_q[133:128] : (marks_first_s1_q ? memory_rdata_q[133:128] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_97;
  assign select_97 = and_19 ? select_96 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_99;
  assign select_99 = running_s1_q ? memory_rdata_q[142:135] : (marks_first_s1_q ? memory_rdata_q[142:135] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_100;
  assign select_100 = and_19 ? select_99 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_102;
  assign select_102 = running_s1_q ? memory_rdata_q[148:143] : (marks_first_s1_q ? memory_rdata_q[148:143] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_103;
  assign select_103 = and_19 ? select_102 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_105;
  assign select_105 = running_s1_q ? memory_rdata_q[156:149] : (marks_first_s1_q ? memory_rdata_q[156:149] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_106;
  assign select_106 = and_19 ? select_105 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_108;
  assign select_108 = running_s1_q ? memory_rdata_q[162:157] : (marks_first_s1_q ? memory_rdata_q[162:157] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_109;
  assign select_109 = and_19 ? select_108 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_111;
  assign select_111 = running_s1_q ? memory_rdata_q[170:163] : (marks_first_s1_q ? memory_rdata_q[170:163] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_112;
  assign select_112 = and_19 ? select_111 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_114;
  assign select_114 = running_s1_q ? memory_rdata_q[176:171] : (marks_first_s1_q ? memory_rdata_q[176:171] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_115;
  assign select_115 = and_19 ? select_114 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_117;
  assign select_117 = running_s1_q ? memory_rdata_q[184:177] : (marks_first_s1_q ? memory_rdata_q[184:177] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_118;
  assign select_118 = and_19 ? select_117 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_120;
  assign select_120 = running_s1_q ? memory_rdata_q[190:185] : (marks_first_s1_q ? memory_rdata_q[190:185] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_121;
  assign select_121 = and_19 ? select_120 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_123;
  assign select_123 = running_s1_q ? memory_rdata_q[198:191] : (marks_first_s1_q ? memory_rdata_q[198:191] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_124;
  assign select_124 = and_19 ? select_123 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_126;
  assign select_126 = running_s1_q ? memory_rdata_q[204:199] : (marks_first_s1_q ? memory_rdata_q[204:199] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_127;
  assign select_127 = and_19 ? select_126 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_129;
  assign select_129 = running_s1_q ? memory_rdata_q[212:205] : (marks_first_s1_q ? memory_rdata_q[212:205] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_130;
  assign select_130 = and_19 ? select_129 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_132;
  assign select_132 = running_s1_q ? memory_rdata_q[218:213] : (marks_first_s1_q ? memory_rdata_q[218:213] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_133;
  assign select_133 = and_19 ? select_132 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_135;
  assign select_135 = running_s1_q ? memory_rdata_q[226:219] : (marks_first_s1_q ? memory_rdata_q[226:219] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_136;
  assign select_136 = and_19 ? select_135 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_138;
  assign select_138 = running_s1_q ? memory_rdata_q[232:227] : (marks_first_s1_q ? memory_rdata_q[232:227] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_139;
  assign select_139 = and_19 ? select_138 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [7:0] select_141;
  assign select_141 = running_s1_q ? memory_rdata_q[240:233] : (marks_first_s1_q ? memory_rdata_q[240:233] : 8'h0);
  // hls/stages/ballot.hpp:41
  logic [7:0] select_142;
  assign select_142 = and_19 ? select_141 : 8'h0;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_144;
  assign select_144 = running_s1_q ? memory_rdata_q[246:241] : (marks_first_s1_q ? memory_rdata_q[246:241] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_145;
  assign select_145 = and_19 ? select_144 : 6'h0;
  // hls/stages/ballot.hpp:38
  logic [8:0] select_147;
  assign select_147 = running_s1_q ? memory_rdata_q[269:261] : (marks_first_s1_q ? memory_rdata_q[269:261] : 9'h0);
  // hls/stages/ballot.hpp:41
  logic [8:0] select_148;
  assign select_148 = and_19 ? select_147 : 9'h0;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_153;
  assign difference_153 = {1'b0, grey_s1_q} - {1'b0, select_97};
  logic [7:0] difference;
  assign difference = difference_153[6] ? (8'h0 - {difference_153[6], difference_153}) : {2'h0, difference_153[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_157;
  assign select_157 = ({4'h0, cfg_similar_i} < difference) ? 8'h0 : vote_s1_q;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_158;
  assign difference_158 = {1'b0, select_145} - {1'b0, select_97};
  logic [7:0] difference_2;
  assign difference_2 = difference_158[6] ? (8'h0 - {difference_158[6], difference_158}) : {2'h0, difference_158[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_162;
  assign select_162 = ({4'h0, cfg_similar_i} < difference_2) ? 8'h0 : select_142;
  // hls/stages/ballot.hpp:38
  logic [5:0] select_164;
  assign select_164 = running_s1_q ? memory_rdata_q[260:255] : (marks_first_s1_q ? memory_rdata_q[260:255] : 6'h0);
  // hls/stages/ballot.hpp:41
  logic [5:0] select_165;
  assign select_165 = and_19 ? select_164 : 6'h0;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_166;
  assign difference_166 = {1'b0, select_165} - {1'b0, select_97};
  logic [7:0] difference_3;
  assign difference_3 = difference_166[6] ? (8'h0 - {difference_166[6], difference_166}) : {2'h0, difference_166[5:0]};
  // hls/stages/ballot.hpp:38
  logic [7:0] select_171;
  assign select_171 = running_s1_q ? memory_rdata_q[254:247] : (marks_first_s1_q ? memory_rdata_q[254:247] : 8'h0);
  // hls/stages/ballot.hpp:47
  logic [7:0] select_173;
  assign select_173 = ({4'h0, cfg_similar_i} < difference_3) ? 8'h0 : (and_19 ? select_171 : 8'h0);
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_174;
  assign sum_174 = {select_162[7], select_162} + {select_173[7], select_173};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_176;
  assign difference_176 = {1'b0, select_25} - {1'b0, select_97};
  logic [7:0] difference_4;
  assign difference_4 = difference_176[6] ? (8'h0 - {difference_176[6], difference_176}) : {2'h0, difference_176[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_180;
  assign select_180 = ({4'h0, cfg_similar_i} < difference_4) ? 8'h0 : select_22;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_181;
  assign difference_181 = {1'b0, select_34} - {1'b0, select_97};
  logic [7:0] difference_5;
  assign difference_5 = difference_181[6] ? (8'h0 - {difference_181[6], difference_181}) : {2'h0, difference_181[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_185;
  assign select_185 = ({4'h0, cfg_similar_i} < difference_5) ? 8'h0 : select_31;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_186;
  assign sum_186 = {select_180[7], select_180} + {select_185[7], select_185};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_187;
  assign difference_187 = {1'b0, select_43} - {1'b0, select_97};
  logic [7:0] difference_6;
  assign difference_6 = difference_187[6] ? (8'h0 - {difference_187[6], difference_187}) : {2'h0, difference_187[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_191;
  assign select_191 = ({4'h0, cfg_similar_i} < difference_6) ? 8'h0 : select_40;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_192;
  assign difference_192 = {1'b0, select_52} - {1'b0, select_97};
  logic [7:0] difference_7;
  assign difference_7 = difference_192[6] ? (8'h0 - {difference_192[6], difference_192}) : {2'h0, difference_192[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_196;
  assign select_196 = ({4'h0, cfg_similar_i} < difference_7) ? 8'h0 : select_49;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_197;
  assign sum_197 = {select_191[7], select_191} + {select_196[7], select_196};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_199;
  assign difference_199 = {1'b0, select_61} - {1'b0, select_97};
  logic [7:0] difference_8;
  assign difference_8 = difference_199[6] ? (8'h0 - {difference_199[6], difference_199}) : {2'h0, difference_199[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_203;
  assign select_203 = ({4'h0, cfg_similar_i} < difference_8) ? 8'h0 : select_58;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_204;
  assign difference_204 = {1'b0, select_70} - {1'b0, select_97};
  logic [7:0] difference_9;
  assign difference_9 = difference_204[6] ? (8'h0 - {difference_204[6], difference_204}) : {2'h0, difference_204[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_208;
  assign select_208 = ({4'h0, cfg_similar_i} < difference_9) ? 8'h0 : select_67;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_209;
  assign sum_209 = {select_203[7], select_203} + {select_208[7], select_208};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_210;
  assign difference_210 = {1'b0, select_79} - {1'b0, select_97};
  logic [7:0] difference_10;
  assign difference_10 = difference_210[6] ? (8'h0 - {difference_210[6], difference_210}) : {2'h0, difference_210[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_214;
  assign select_214 = ({4'h0, cfg_similar_i} < difference_10) ? 8'h0 : select_76;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_215;
  assign difference_215 = {1'b0, select_88} - {1'b0, select_97};
  logic [7:0] difference_11;
  assign difference_11 = difference_215[6] ? (8'h0 - {difference_215[6], difference_215}) : {2'h0, difference_215[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_219;
  assign select_219 = ({4'h0, cfg_similar_i} < difference_11) ? 8'h0 : select_85;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_220;
  assign sum_220 = {select_214[7], select_214} + {select_219[7], select_219};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_223;
  assign difference_223 = {1'b0, select_103} - {1'b0, select_97};
  logic [7:0] difference_12;
  assign difference_12 = difference_223[6] ? (8'h0 - {difference_223[6], difference_223}) : {2'h0, difference_223[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_227;
  assign select_227 = ({4'h0, cfg_similar_i} < difference_12) ? 8'h0 : select_100;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_228;
  assign sum_228 = {select_94[7], select_94} + {select_227[7], select_227};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_229;
  assign difference_229 = {1'b0, select_109} - {1'b0, select_97};
  logic [7:0] difference_13;
  assign difference_13 = difference_229[6] ? (8'h0 - {difference_229[6], difference_229}) : {2'h0, difference_229[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_233;
  assign select_233 = ({4'h0, cfg_similar_i} < difference_13) ? 8'h0 : select_106;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_234;
  assign difference_234 = {1'b0, select_115} - {1'b0, select_97};
  logic [7:0] difference_14;
  assign difference_14 = difference_234[6] ? (8'h0 - {difference_234[6], difference_234}) : {2'h0, difference_234[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_238;
  assign select_238 = ({4'h0, cfg_similar_i} < difference_14) ? 8'h0 : select_112;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_239;
  assign sum_239 = {select_233[7], select_233} + {select_238[7], select_238};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_241;
  assign difference_241 = {1'b0, select_121} - {1'b0, select_97};
  logic [7:0] difference_15;
  assign difference_15 = difference_241[6] ? (8'h0 - {difference_241[6], difference_241}) : {2'h0, difference_241[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_245;
  assign select_245 = ({4'h0, cfg_similar_i} < difference_15) ? 8'h0 : select_118;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_246;
  assign difference_246 = {1'b0, select_127} - {1'b0, select_97};
  logic [7:0] difference_16;
  assign difference_16 = difference_246[6] ? (8'h0 - {difference_246[6], difference_246}) : {2'h0, difference_246[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_250;
  assign select_250 = ({4'h0, cfg_similar_i} < difference_16) ? 8'h0 : select_124;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_251;
  assign sum_251 = {select_245[7], select_245} + {select_250[7], select_250};
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_252;
  assign difference_252 = {1'b0, select_133} - {1'b0, select_97};
  logic [7:0] difference_17;
  assign difference_17 = difference_252[6] ? (8'h0 - {difference_252[6], difference_252}) : {2'h0, difference_252[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_256;
  assign select_256 = ({4'h0, cfg_similar_i} < difference_17) ? 8'h0 : select_130;
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_257;
  assign difference_257 = {1'b0, select_139} - {1'b0, select_97};
  logic [7:0] difference_18;
  assign difference_18 = difference_257[6] ? (8'h0 - {difference_257[6], difference_257}) : {2'h0, difference_257[5:0]};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_261;
  assign select_261 = ({4'h0, cfg_similar_i} < difference_18) ? 8'h0 : select_136;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_262;
  assign sum_262 = {select_256[7], select_256} + {select_261[7], select_261};
  // hls/stages/ballot.hpp:38
  logic select_275;
  assign select_275 = running_s1_q ? memory_rdata_q[134] : (marks_first_s1_q & memory_rdata_q[134]);

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = select_15_s1_q;
  logic memory_we;
  assign memory_we = s1_en & running_q;
  always_ff @(posedge clk_i) begin
    if (memory_we) memory_mem[memory_waddr] <= {select_148[7:0], firm_s1_q, select_145, select_142, select_139, select_136, select_133, select_130, select_127, select_124, select_121, select_118, select_115, select_112, select_109, select_106, select_103, select_100, select_97, select_94, and_91, select_88, select_85, and_82, select_79, select_76, and_73, select_70, select_67, and_64, select_61, select_58, and_55, select_52, select_49, and_46, select_43, select_40, and_37, select_34, select_31, and_28, select_25, select_22, exists_s1_q, grey_s1_q, vote_s1_q};
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
      raster_rows_q <= raster_row_ended_q | and_19;
    end
  end

  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic select_148_s2_q;
  logic [9:0] sum_175_s2_q;
  logic [9:0] sum_198_s2_q;
  logic [9:0] sum_221_s2_q;
  logic [9:0] sum_240_s2_q;
  logic [9:0] sum_263_s2_q;
  logic and_276_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      select_148_s2_q <= select_148[8];
      sum_175_s2_q <= {{2{select_157[7]}}, select_157} + {sum_174[8], sum_174};
      sum_198_s2_q <= {sum_186[8], sum_186} + {sum_197[8], sum_197};
      sum_221_s2_q <= {sum_209[8], sum_209} + {sum_220[8], sum_220};
      sum_240_s2_q <= {sum_228[8], sum_228} + {sum_239[8], sum_239};
      sum_263_s2_q <= {sum_251[8], sum_251} + {sum_262[8], sum_262};
      and_276_s2_q <= and_19 & select_275;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:50
  logic [10:0] sum_222;
  assign sum_222 = {sum_198_s2_q[9], sum_198_s2_q} + {sum_221_s2_q[9], sum_221_s2_q};
  logic [10:0] sum_264;
  assign sum_264 = {sum_240_s2_q[9], sum_240_s2_q} + {sum_263_s2_q[9], sum_263_s2_q};
  logic [11:0] sum_265;
  assign sum_265 = {sum_222[10], sum_222} + {sum_264[10], sum_264};
  logic [12:0] sum_266;
  assign sum_266 = {{3{sum_175_s2_q[9]}}, sum_175_s2_q} + {sum_265[11], sum_265};
  // hls/stages/ballot.hpp:61
  logic [13:0] difference_270;
  assign difference_270 = 14'h0 - {sum_266[12], sum_266};
  logic less_271;
  assign less_271 = $signed(difference_270[13:3]) < $signed({3'h0, cfg_clear_quorum_i});

  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic not_268_s3_q;
  logic or_273_s3_q;
  logic and_276_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      not_268_s3_q <= ~($signed(sum_266) < $signed({5'h0, cfg_quorum_i}));
      or_273_s3_q <= (select_148_s2_q & sum_266[12]) | (~less_271);
      and_276_s3_q <= and_276_s2_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_o = not_268_s3_q;
  assign clear_o = or_273_s3_q;
  assign exists_o = and_276_s3_q;
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
  assign unused_bits = ^difference_270[2:0];

endmodule
