// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Ballot<horopter::hls::profiles::vga>, hls/stages/ballot.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
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
  input  logic cfg_dim_i,
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

  // Of the configuration alone: not pipelined.
  logic [7:0] select_274;
  assign select_274 = cfg_dim_i ? cfg_clear_quorum_i : 8'h0;
  logic [8:0] sum_275;
  assign sum_275 = {1'b0, cfg_clear_quorum_i} + {2'h0, select_274[7:1]};

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [9:0] raster_column_q;
  logic raster_row_ended_q;
  logic running_q;
  // hls/stages/ballot.hpp:49
  logic [9:0] select_19;
  assign select_19 = marks_first_i ? 10'h0 : (raster_row_ended_q ? 10'h0 : (raster_column_q + 10'h1));
  // hls/stages/ballot.hpp:53
  logic or_21;
  assign or_21 = marks_first_i | running_q;

  // Memory memory, 640 x 270 and parity, DISTANCE 16, hls/stages/ballot.hpp:127; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [270:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 271'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = running_q ? select_19 : 10'h0;
  logic memory_re;
  assign memory_re = s0_en & or_21;
  logic [270:0] memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_word_q <= memory_mem[memory_raddr];
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
      raster_column_q <= select_19;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_21 : (marks_first_i & or_21);
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
    if (en_i) begin
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
  // hls/stages/ballot.hpp:49
  logic and_24;
  assign and_24 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/ballot.hpp:59
  logic [7:0] select_26;
  assign select_26 = running_s1_q ? memory_rdata_q[7:0] : (marks_first_s1_q ? memory_rdata_q[7:0] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_27;
  assign select_27 = and_24 ? select_26 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_29;
  assign select_29 = running_s1_q ? memory_rdata_q[13:8] : (marks_first_s1_q ? memory_rdata_q[13:8] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_30;
  assign select_30 = and_24 ? select_29 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic select_32;
  assign select_32 = running_s1_q ? memory_rdata_q[14] : (marks_first_s1_q & memory_rdata_q[14]);
  // hls/stages/ballot.hpp:62
  logic and_33;
  assign and_33 = and_24 & select_32;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_35;
  assign select_35 = running_s1_q ? memory_rdata_q[22:15] : (marks_first_s1_q ? memory_rdata_q[22:15] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_36;
  assign select_36 = and_24 ? select_35 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_38;
  assign select_38 = running_s1_q ? memory_rdata_q[28:23] : (marks_first_s1_q ? memory_rdata_q[28:23] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_39;
  assign select_39 = and_24 ? select_38 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic select_41;
  assign select_41 = running_s1_q ? memory_rdata_q[29] : (marks_first_s1_q & memory_rdata_q[29]);
  // hls/stages/ballot.hpp:62
  logic and_42;
  assign and_42 = and_24 & select_41;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_44;
  assign select_44 = running_s1_q ? memory_rdata_q[37:30] : (marks_first_s1_q ? memory_rdata_q[37:30] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_45;
  assign select_45 = and_24 ? select_44 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_47;
  assign select_47 = running_s1_q ? memory_rdata_q[43:38] : (marks_first_s1_q ? memory_rdata_q[43:38] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_48;
  assign select_48 = and_24 ? select_47 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic select_50;
  assign select_50 = running_s1_q ? memory_rdata_q[44] : (marks_first_s1_q & memory_rdata_q[44]);
  // hls/stages/ballot.hpp:62
  logic and_51;
  assign and_51 = and_24 & select_50;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_53;
  assign select_53 = running_s1_q ? memory_rdata_q[52:45] : (marks_first_s1_q ? memory_rdata_q[52:45] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_54;
  assign select_54 = and_24 ? select_53 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_56;
  assign select_56 = running_s1_q ? memory_rdata_q[58:53] : (marks_first_s1_q ? memory_rdata_q[58:53] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_57;
  assign select_57 = and_24 ? select_56 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic select_59;
  assign select_59 = running_s1_q ? memory_rdata_q[59] : (marks_first_s1_q & memory_rdata_q[59]);
  // hls/stages/ballot.hpp:62
  logic and_60;
  assign and_60 = and_24 & select_59;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_62;
  assign select_62 = running_s1_q ? memory_rdata_q[67:60] : (marks_first_s1_q ? memory_rdata_q[67:60] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_63;
  assign select_63 = and_24 ? select_62 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_65;
  assign select_65 = running_s1_q ? memory_rdata_q[73:68] : (marks_first_s1_q ? memory_rdata_q[73:68] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_66;
  assign select_66 = and_24 ? select_65 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic select_68;
  assign select_68 = running_s1_q ? memory_rdata_q[74] : (marks_first_s1_q & memory_rdata_q[74]);
  // hls/stages/ballot.hpp:62
  logic and_69;
  assign and_69 = and_24 & select_68;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_71;
  assign select_71 = running_s1_q ? memory_rdata_q[82:75] : (marks_first_s1_q ? memory_rdata_q[82:75] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_72;
  assign select_72 = and_24 ? select_71 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_74;
  assign select_74 = running_s1_q ? memory_rdata_q[88:83] : (marks_first_s1_q ? memory_rdata_q[88:83] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_75;
  assign select_75 = and_24 ? select_74 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic select_77;
  assign select_77 = running_s1_q ? memory_rdata_q[89] : (marks_first_s1_q & memory_rdata_q[89]);
  // hls/stages/ballot.hpp:62
  logic and_78;
  assign and_78 = and_24 & select_77;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_80;
  assign select_80 = running_s1_q ? memory_rdata_q[97:90] : (marks_first_s1_q ? memory_rdata_q[97:90] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_81;
  assign select_81 = and_24 ? select_80 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_83;
  assign select_83 = running_s1_q ? memory_rdata_q[103:98] : (marks_first_s1_q ? memory_rdata_q[103:98] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_84;
  assign select_84 = and_24 ? select_83 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic select_86;
  assign select_86 = running_s1_q ? memory_rdata_q[104] : (marks_first_s1_q & memory_rdata_q[104]);
  // hls/stages/ballot.hpp:62
  logic and_87;
  assign and_87 = and_24 & select_86;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_89;
  assign select_89 = running_s1_q ? memory_rdata_q[112:105] : (marks_first_s1_q ? memory_rdata_q[112:105] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_90;
  assign select_90 = and_24 ? select_89 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_92;
  assign select_92 = running_s1_q ? memory_rdata_q[118:113] : (marks_first_s1_q ? memory_rdata_q[118:113] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_93;
  assign select_93 = and_24 ? select_92 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic select_95;
  assign select_95 = running_s1_q ? memory_rdata_q[119] : (marks_first_s1_q & memory_rdata_q[119]);
  // hls/stages/ballot.hpp:62
  logic and_96;
  assign and_96 = and_24 & select_95;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_98;
  assign select_98 = running_s1_q ? memory_rdata_q[127:120] : (marks_first_s1_q ? memory_rdata_q[127:120] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_99;
  assign select_99 = and_24 ? select_98 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_101;
  assign select_101 = running_s1_q ? memory_rdata_q[133:128] : (marks_first_s1_q ? memory_rdata_q[133:128] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_102;
  assign select_102 = and_24 ? select_101 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_104;
  assign select_104 = running_s1_q ? memory_rdata_q[142:135] : (marks_first_s1_q ? memory_rdata_q[142:135] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_105;
  assign select_105 = and_24 ? select_104 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_107;
  assign select_107 = running_s1_q ? memory_rdata_q[148:143] : (marks_first_s1_q ? memory_rdata_q[148:143] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_108;
  assign select_108 = and_24 ? select_107 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_110;
  assign select_110 = running_s1_q ? memory_rdata_q[156:149] : (marks_first_s1_q ? memory_rdata_q[156:149] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_111;
  assign select_111 = and_24 ? select_110 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_113;
  assign select_113 = running_s1_q ? memory_rdata_q[162:157] : (marks_first_s1_q ? memory_rdata_q[162:157] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_114;
  assign select_114 = and_24 ? select_113 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_116;
  assign select_116 = running_s1_q ? memory_rdata_q[170:163] : (marks_first_s1_q ? memory_rdata_q[170:163] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_117;
  assign select_117 = and_24 ? select_116 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_119;
  assign select_119 = running_s1_q ? memory_rdata_q[176:171] : (marks_first_s1_q ? memory_rdata_q[176:171] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_120;
  assign select_120 = and_24 ? select_119 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_122;
  assign select_122 = running_s1_q ? memory_rdata_q[184:177] : (marks_first_s1_q ? memory_rdata_q[184:177] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_123;
  assign select_123 = and_24 ? select_122 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_125;
  assign select_125 = running_s1_q ? memory_rdata_q[190:185] : (marks_first_s1_q ? memory_rdata_q[190:185] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_126;
  assign select_126 = and_24 ? select_125 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_128;
  assign select_128 = running_s1_q ? memory_rdata_q[198:191] : (marks_first_s1_q ? memory_rdata_q[198:191] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_129;
  assign select_129 = and_24 ? select_128 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_131;
  assign select_131 = running_s1_q ? memory_rdata_q[204:199] : (marks_first_s1_q ? memory_rdata_q[204:199] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_132;
  assign select_132 = and_24 ? select_131 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_134;
  assign select_134 = running_s1_q ? memory_rdata_q[212:205] : (marks_first_s1_q ? memory_rdata_q[212:205] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_135;
  assign select_135 = and_24 ? select_134 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_137;
  assign select_137 = running_s1_q ? memory_rdata_q[218:213] : (marks_first_s1_q ? memory_rdata_q[218:213] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_138;
  assign select_138 = and_24 ? select_137 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_140;
  assign select_140 = running_s1_q ? memory_rdata_q[226:219] : (marks_first_s1_q ? memory_rdata_q[226:219] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_141;
  assign select_141 = and_24 ? select_140 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_143;
  assign select_143 = running_s1_q ? memory_rdata_q[232:227] : (marks_first_s1_q ? memory_rdata_q[232:227] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_144;
  assign select_144 = and_24 ? select_143 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic [7:0] select_146;
  assign select_146 = running_s1_q ? memory_rdata_q[240:233] : (marks_first_s1_q ? memory_rdata_q[240:233] : 8'h0);
  // hls/stages/ballot.hpp:62
  logic [7:0] select_147;
  assign select_147 = and_24 ? select_146 : 8'h0;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_149;
  assign select_149 = running_s1_q ? memory_rdata_q[246:241] : (marks_first_s1_q ? memory_rdata_q[246:241] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_150;
  assign select_150 = and_24 ? select_149 : 6'h0;
  // hls/stages/ballot.hpp:59
  logic [8:0] select_152;
  assign select_152 = running_s1_q ? memory_rdata_q[269:261] : (marks_first_s1_q ? memory_rdata_q[269:261] : 9'h0);
  // hls/stages/ballot.hpp:62
  logic [8:0] select_153;
  assign select_153 = and_24 ? select_152 : 9'h0;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_157;
  assign difference_157 = {1'b0, grey_s1_q} - {1'b0, select_102};
  logic [5:0] xor_158;
  assign xor_158 = difference_157[5:0] ^ {6{difference_157[6]}};
  logic [6:0] difference;
  assign difference = {6'h0, difference_157[6]} + {1'b0, xor_158};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_161;
  assign select_161 = ({3'h0, cfg_similar_i} < difference) ? 8'h0 : vote_s1_q;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_162;
  assign difference_162 = {1'b0, select_150} - {1'b0, select_102};
  logic [5:0] xor_163;
  assign xor_163 = difference_162[5:0] ^ {6{difference_162[6]}};
  logic [6:0] difference_2;
  assign difference_2 = {6'h0, difference_162[6]} + {1'b0, xor_163};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_166;
  assign select_166 = ({3'h0, cfg_similar_i} < difference_2) ? 8'h0 : select_147;
  // hls/stages/ballot.hpp:59
  logic [5:0] select_168;
  assign select_168 = running_s1_q ? memory_rdata_q[260:255] : (marks_first_s1_q ? memory_rdata_q[260:255] : 6'h0);
  // hls/stages/ballot.hpp:62
  logic [5:0] select_169;
  assign select_169 = and_24 ? select_168 : 6'h0;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_170;
  assign difference_170 = {1'b0, select_169} - {1'b0, select_102};
  logic [5:0] xor_171;
  assign xor_171 = difference_170[5:0] ^ {6{difference_170[6]}};
  logic [6:0] difference_3;
  assign difference_3 = {6'h0, difference_170[6]} + {1'b0, xor_171};
  // hls/stages/ballot.hpp:59
  logic [7:0] select_175;
  assign select_175 = running_s1_q ? memory_rdata_q[254:247] : (marks_first_s1_q ? memory_rdata_q[254:247] : 8'h0);
  // hls/stages/ballot.hpp:68
  logic [7:0] select_177;
  assign select_177 = ({3'h0, cfg_similar_i} < difference_3) ? 8'h0 : (and_24 ? select_175 : 8'h0);
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_178;
  assign sum_178 = {select_166[7], select_166} + {select_177[7], select_177};
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_180;
  assign difference_180 = {1'b0, select_30} - {1'b0, select_102};
  logic [5:0] xor_181;
  assign xor_181 = difference_180[5:0] ^ {6{difference_180[6]}};
  logic [6:0] difference_4;
  assign difference_4 = {6'h0, difference_180[6]} + {1'b0, xor_181};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_184;
  assign select_184 = ({3'h0, cfg_similar_i} < difference_4) ? 8'h0 : select_27;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_185;
  assign difference_185 = {1'b0, select_39} - {1'b0, select_102};
  logic [5:0] xor_186;
  assign xor_186 = difference_185[5:0] ^ {6{difference_185[6]}};
  logic [6:0] difference_5;
  assign difference_5 = {6'h0, difference_185[6]} + {1'b0, xor_186};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_189;
  assign select_189 = ({3'h0, cfg_similar_i} < difference_5) ? 8'h0 : select_36;
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_190;
  assign sum_190 = {select_184[7], select_184} + {select_189[7], select_189};
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_191;
  assign difference_191 = {1'b0, select_48} - {1'b0, select_102};
  logic [5:0] xor_192;
  assign xor_192 = difference_191[5:0] ^ {6{difference_191[6]}};
  logic [6:0] difference_6;
  assign difference_6 = {6'h0, difference_191[6]} + {1'b0, xor_192};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_195;
  assign select_195 = ({3'h0, cfg_similar_i} < difference_6) ? 8'h0 : select_45;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_196;
  assign difference_196 = {1'b0, select_57} - {1'b0, select_102};
  logic [5:0] xor_197;
  assign xor_197 = difference_196[5:0] ^ {6{difference_196[6]}};
  logic [6:0] difference_7;
  assign difference_7 = {6'h0, difference_196[6]} + {1'b0, xor_197};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_200;
  assign select_200 = ({3'h0, cfg_similar_i} < difference_7) ? 8'h0 : select_54;
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_201;
  assign sum_201 = {select_195[7], select_195} + {select_200[7], select_200};
  logic [9:0] sum_202;
  assign sum_202 = {sum_190[8], sum_190} + {sum_201[8], sum_201};
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_203;
  assign difference_203 = {1'b0, select_66} - {1'b0, select_102};
  logic [5:0] xor_204;
  assign xor_204 = difference_203[5:0] ^ {6{difference_203[6]}};
  logic [6:0] difference_8;
  assign difference_8 = {6'h0, difference_203[6]} + {1'b0, xor_204};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_207;
  assign select_207 = ({3'h0, cfg_similar_i} < difference_8) ? 8'h0 : select_63;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_208;
  assign difference_208 = {1'b0, select_75} - {1'b0, select_102};
  logic [5:0] xor_209;
  assign xor_209 = difference_208[5:0] ^ {6{difference_208[6]}};
  logic [6:0] difference_9;
  assign difference_9 = {6'h0, difference_208[6]} + {1'b0, xor_209};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_212;
  assign select_212 = ({3'h0, cfg_similar_i} < difference_9) ? 8'h0 : select_72;
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_213;
  assign sum_213 = {select_207[7], select_207} + {select_212[7], select_212};
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_214;
  assign difference_214 = {1'b0, select_84} - {1'b0, select_102};
  logic [5:0] xor_215;
  assign xor_215 = difference_214[5:0] ^ {6{difference_214[6]}};
  logic [6:0] difference_10;
  assign difference_10 = {6'h0, difference_214[6]} + {1'b0, xor_215};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_218;
  assign select_218 = ({3'h0, cfg_similar_i} < difference_10) ? 8'h0 : select_81;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_219;
  assign difference_219 = {1'b0, select_93} - {1'b0, select_102};
  logic [5:0] xor_220;
  assign xor_220 = difference_219[5:0] ^ {6{difference_219[6]}};
  logic [6:0] difference_11;
  assign difference_11 = {6'h0, difference_219[6]} + {1'b0, xor_220};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_223;
  assign select_223 = ({3'h0, cfg_similar_i} < difference_11) ? 8'h0 : select_90;
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_224;
  assign sum_224 = {select_218[7], select_218} + {select_223[7], select_223};
  logic [9:0] sum_225;
  assign sum_225 = {sum_213[8], sum_213} + {sum_224[8], sum_224};
  logic [10:0] sum_226;
  assign sum_226 = {sum_202[9], sum_202} + {sum_225[9], sum_225};
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_227;
  assign difference_227 = {1'b0, select_108} - {1'b0, select_102};
  logic [5:0] xor_228;
  assign xor_228 = difference_227[5:0] ^ {6{difference_227[6]}};
  logic [6:0] difference_12;
  assign difference_12 = {6'h0, difference_227[6]} + {1'b0, xor_228};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_231;
  assign select_231 = ({3'h0, cfg_similar_i} < difference_12) ? 8'h0 : select_105;
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_232;
  assign sum_232 = {select_99[7], select_99} + {select_231[7], select_231};
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_233;
  assign difference_233 = {1'b0, select_114} - {1'b0, select_102};
  logic [5:0] xor_234;
  assign xor_234 = difference_233[5:0] ^ {6{difference_233[6]}};
  logic [6:0] difference_13;
  assign difference_13 = {6'h0, difference_233[6]} + {1'b0, xor_234};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_237;
  assign select_237 = ({3'h0, cfg_similar_i} < difference_13) ? 8'h0 : select_111;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_238;
  assign difference_238 = {1'b0, select_120} - {1'b0, select_102};
  logic [5:0] xor_239;
  assign xor_239 = difference_238[5:0] ^ {6{difference_238[6]}};
  logic [6:0] difference_14;
  assign difference_14 = {6'h0, difference_238[6]} + {1'b0, xor_239};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_242;
  assign select_242 = ({3'h0, cfg_similar_i} < difference_14) ? 8'h0 : select_117;
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_243;
  assign sum_243 = {select_237[7], select_237} + {select_242[7], select_242};
  logic [9:0] sum_244;
  assign sum_244 = {sum_232[8], sum_232} + {sum_243[8], sum_243};
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_245;
  assign difference_245 = {1'b0, select_126} - {1'b0, select_102};
  logic [5:0] xor_246;
  assign xor_246 = difference_245[5:0] ^ {6{difference_245[6]}};
  logic [6:0] difference_15;
  assign difference_15 = {6'h0, difference_245[6]} + {1'b0, xor_246};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_249;
  assign select_249 = ({3'h0, cfg_similar_i} < difference_15) ? 8'h0 : select_123;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_250;
  assign difference_250 = {1'b0, select_132} - {1'b0, select_102};
  logic [5:0] xor_251;
  assign xor_251 = difference_250[5:0] ^ {6{difference_250[6]}};
  logic [6:0] difference_16;
  assign difference_16 = {6'h0, difference_250[6]} + {1'b0, xor_251};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_254;
  assign select_254 = ({3'h0, cfg_similar_i} < difference_16) ? 8'h0 : select_129;
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_255;
  assign sum_255 = {select_249[7], select_249} + {select_254[7], select_254};
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_256;
  assign difference_256 = {1'b0, select_138} - {1'b0, select_102};
  logic [5:0] xor_257;
  assign xor_257 = difference_256[5:0] ^ {6{difference_256[6]}};
  logic [6:0] difference_17;
  assign difference_17 = {6'h0, difference_256[6]} + {1'b0, xor_257};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_260;
  assign select_260 = ({3'h0, cfg_similar_i} < difference_17) ? 8'h0 : select_135;
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_261;
  assign difference_261 = {1'b0, select_144} - {1'b0, select_102};
  logic [5:0] xor_262;
  assign xor_262 = difference_261[5:0] ^ {6{difference_261[6]}};
  logic [6:0] difference_18;
  assign difference_18 = {6'h0, difference_261[6]} + {1'b0, xor_262};
  // hls/stages/ballot.hpp:68
  logic [7:0] select_265;
  assign select_265 = ({3'h0, cfg_similar_i} < difference_18) ? 8'h0 : select_141;
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_266;
  assign sum_266 = {select_260[7], select_260} + {select_265[7], select_265};
  logic [9:0] sum_267;
  assign sum_267 = {sum_255[8], sum_255} + {sum_266[8], sum_266};
  logic [10:0] sum_268;
  assign sum_268 = {sum_244[9], sum_244} + {sum_267[9], sum_267};
  // hls/stages/ballot.hpp:59
  logic select_281;
  assign select_281 = running_s1_q ? memory_rdata_q[134] : (marks_first_s1_q & memory_rdata_q[134]);

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en & running_q;
  logic [269:0] memory_wdata;
  assign memory_wdata = {select_153[7:0], firm_s1_q, select_150, select_147, select_144, select_141, select_138, select_135, select_132, select_129, select_126, select_123, select_120, select_117, select_114, select_111, select_108, select_105, select_102, select_99, and_96, select_93, select_90, and_87, select_84, select_81, and_78, select_75, select_72, and_69, select_66, select_63, and_60, select_57, select_54, and_51, select_48, select_45, and_42, select_39, select_36, and_33, select_30, select_27, exists_s1_q, grey_s1_q, vote_s1_q};
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
      raster_rows_q <= raster_row_ended_q | and_24;
    end
  end

  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic select_153_s2_q;
  logic [9:0] sum_179_s2_q;
  logic [11:0] sum_269_s2_q;
  logic and_282_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      select_153_s2_q <= select_153[8];
      sum_179_s2_q <= {{2{select_161[7]}}, select_161} + {sum_178[8], sum_178};
      sum_269_s2_q <= {sum_226[10], sum_226} + {sum_268[10], sum_268};
      and_282_s2_q <= and_24 & select_281;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:71
  logic [12:0] sum_270;
  assign sum_270 = {{3{sum_179_s2_q[9]}}, sum_179_s2_q} + {sum_269_s2_q[11], sum_269_s2_q};
  // hls/stages/ballot.hpp:89
  logic [13:0] difference_273;
  assign difference_273 = 14'h0 - {sum_270[12], sum_270};
  logic less_276;
  assign less_276 = {{2{difference_273[13]}}, difference_273[13:2]} < {4'h0, sum_275, select_274[0]};

  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic not_272_s3_q;
  logic and_279_s3_q;
  logic and_282_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      not_272_s3_q <= ~($signed(sum_270) < $signed({5'h0, cfg_quorum_i}));
      and_279_s3_q <= sum_270[12] & (select_153_s2_q | (~less_276));
      and_282_s3_q <= and_282_s2_q;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (memory_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_o = not_272_s3_q;
  assign clear_o = and_279_s3_q;
  assign exists_o = and_282_s3_q;
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
  assign unused_bits = ^difference_273[1:0];

endmodule
