// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Ballot<horopter::hls::profiles::hd>, hls/stages/ballot.hpp. Do not edit.
//
// Latency 8 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 14 bits, pipeline 678 bits, memories 288000 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] raster_column_q;
  logic raster_row_ended_q;
  logic running_q;
  // hls/stages/ballot.hpp:40
  logic [10:0] select_17;
  assign select_17 = (marks_first_i | raster_row_ended_q) ? 11'h0 : raster_column_q;
  // hls/stages/ballot.hpp:44
  logic or_18;
  assign or_18 = marks_first_i | running_q;

  // Memory memory, 1920 x 150, DISTANCE 16, hls/stages/ballot.hpp:98; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [149:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 150'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_17;
  logic memory_re;
  assign memory_re = s0_en & or_18;
  logic [149:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_17 + 11'h1;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_18 : (marks_first_i & or_18);
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
  logic [10:0] select_17_s1_q;
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
      select_17_s1_q <= select_17;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic [7:0] vote_s2_q;
  logic firm_s2_q;
  logic [5:0] grey_s2_q;
  logic exists_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic running_s2_q;
  logic [10:0] select_17_s2_q;
  logic [149:0] memory_rdata_s2_q;
  logic select_92_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      vote_s2_q <= vote_s1_q;
      firm_s2_q <= firm_s1_q;
      grey_s2_q <= grey_s1_q;
      exists_s2_q <= exists_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      running_s2_q <= running_s1_q;
      select_17_s2_q <= select_17_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
      select_92_s2_q <= running_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/ballot.hpp:40
  logic and_21;
  assign and_21 = raster_rows_q & (~marks_first_s2_q);
  // hls/stages/ballot.hpp:49
  logic [7:0] select_23;
  assign select_23 = running_s2_q ? memory_rdata_s2_q[7:0] : (marks_first_s2_q ? memory_rdata_s2_q[7:0] : 8'h0);
  logic [5:0] select_26;
  assign select_26 = running_s2_q ? memory_rdata_s2_q[13:8] : (marks_first_s2_q ? memory_rdata_s2_q[13:8] : 6'h0);
  logic select_29;
  assign select_29 = running_s2_q ? memory_rdata_s2_q[14] : (marks_first_s2_q & memory_rdata_s2_q[14]);
  logic [7:0] select_32;
  assign select_32 = running_s2_q ? memory_rdata_s2_q[22:15] : (marks_first_s2_q ? memory_rdata_s2_q[22:15] : 8'h0);
  logic [5:0] select_35;
  assign select_35 = running_s2_q ? memory_rdata_s2_q[28:23] : (marks_first_s2_q ? memory_rdata_s2_q[28:23] : 6'h0);
  logic select_38;
  assign select_38 = running_s2_q ? memory_rdata_s2_q[29] : (marks_first_s2_q & memory_rdata_s2_q[29]);
  logic [7:0] select_41;
  assign select_41 = running_s2_q ? memory_rdata_s2_q[37:30] : (marks_first_s2_q ? memory_rdata_s2_q[37:30] : 8'h0);
  logic [5:0] select_44;
  assign select_44 = running_s2_q ? memory_rdata_s2_q[43:38] : (marks_first_s2_q ? memory_rdata_s2_q[43:38] : 6'h0);
  logic select_47;
  assign select_47 = running_s2_q ? memory_rdata_s2_q[44] : (marks_first_s2_q & memory_rdata_s2_q[44]);
  logic [7:0] select_50;
  assign select_50 = running_s2_q ? memory_rdata_s2_q[52:45] : (marks_first_s2_q ? memory_rdata_s2_q[52:45] : 8'h0);
  logic [5:0] select_53;
  assign select_53 = running_s2_q ? memory_rdata_s2_q[58:53] : (marks_first_s2_q ? memory_rdata_s2_q[58:53] : 6'h0);
  logic select_56;
  assign select_56 = running_s2_q ? memory_rdata_s2_q[59] : (marks_first_s2_q & memory_rdata_s2_q[59]);
  logic [7:0] select_59;
  assign select_59 = running_s2_q ? memory_rdata_s2_q[67:60] : (marks_first_s2_q ? memory_rdata_s2_q[67:60] : 8'h0);
  logic [5:0] select_62;
  assign select_62 = running_s2_q ? memory_rdata_s2_q[73:68] : (marks_first_s2_q ? memory_rdata_s2_q[73:68] : 6'h0);
  logic [7:0] select_65;
  assign select_65 = running_s2_q ? memory_rdata_s2_q[82:75] : (marks_first_s2_q ? memory_rdata_s2_q[82:75] : 8'h0);
  logic [5:0] select_68;
  assign select_68 = running_s2_q ? memory_rdata_s2_q[88:83] : (marks_first_s2_q ? memory_rdata_s2_q[88:83] : 6'h0);
  logic [7:0] select_71;
  assign select_71 = running_s2_q ? memory_rdata_s2_q[96:89] : (marks_first_s2_q ? memory_rdata_s2_q[96:89] : 8'h0);
  logic [5:0] select_74;
  assign select_74 = running_s2_q ? memory_rdata_s2_q[102:97] : (marks_first_s2_q ? memory_rdata_s2_q[102:97] : 6'h0);
  logic [7:0] select_77;
  assign select_77 = running_s2_q ? memory_rdata_s2_q[110:103] : (marks_first_s2_q ? memory_rdata_s2_q[110:103] : 8'h0);
  logic [5:0] select_80;
  assign select_80 = running_s2_q ? memory_rdata_s2_q[116:111] : (marks_first_s2_q ? memory_rdata_s2_q[116:111] : 6'h0);
  logic [7:0] select_83;
  assign select_83 = running_s2_q ? memory_rdata_s2_q[124:117] : (marks_first_s2_q ? memory_rdata_s2_q[124:117] : 8'h0);
  logic [5:0] select_86;
  assign select_86 = running_s2_q ? memory_rdata_s2_q[130:125] : (marks_first_s2_q ? memory_rdata_s2_q[130:125] : 6'h0);
  logic [4:0] select_89;
  assign select_89 = running_s2_q ? memory_rdata_s2_q[149:145] : (marks_first_s2_q ? memory_rdata_s2_q[149:145] : 5'h0);
  logic [5:0] select_143;
  assign select_143 = running_s2_q ? memory_rdata_s2_q[144:139] : (marks_first_s2_q ? memory_rdata_s2_q[144:139] : 6'h0);
  logic [7:0] select_150;
  assign select_150 = running_s2_q ? memory_rdata_s2_q[138:131] : (marks_first_s2_q ? memory_rdata_s2_q[138:131] : 8'h0);
  logic select_169;
  assign select_169 = running_s2_q ? memory_rdata_s2_q[74] : (marks_first_s2_q & memory_rdata_s2_q[74]);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s2_en) begin
      raster_rows_q <= marks_last_s2_q | and_21;
    end
  end

  logic [7:0] vote_s3_q;
  logic firm_s3_q;
  logic [5:0] grey_s3_q;
  logic exists_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic [10:0] select_17_s3_q;
  logic [7:0] select_24_s3_q;
  logic [5:0] select_27_s3_q;
  logic and_30_s3_q;
  logic [7:0] select_33_s3_q;
  logic [5:0] select_36_s3_q;
  logic and_39_s3_q;
  logic [7:0] select_42_s3_q;
  logic [5:0] select_45_s3_q;
  logic and_48_s3_q;
  logic [7:0] select_51_s3_q;
  logic [5:0] select_54_s3_q;
  logic and_57_s3_q;
  logic [7:0] select_60_s3_q;
  logic [5:0] select_63_s3_q;
  logic [7:0] select_66_s3_q;
  logic [5:0] select_69_s3_q;
  logic [7:0] select_72_s3_q;
  logic [5:0] select_75_s3_q;
  logic [7:0] select_78_s3_q;
  logic [5:0] select_81_s3_q;
  logic [7:0] select_84_s3_q;
  logic [5:0] select_87_s3_q;
  logic [4:0] select_90_s3_q;
  logic select_92_s3_q;
  logic [5:0] select_144_s3_q;
  logic [7:0] select_151_s3_q;
  logic and_170_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      vote_s3_q <= vote_s2_q;
      firm_s3_q <= firm_s2_q;
      grey_s3_q <= grey_s2_q;
      exists_s3_q <= exists_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      select_17_s3_q <= select_17_s2_q;
      select_24_s3_q <= and_21 ? select_23 : 8'h0;
      select_27_s3_q <= and_21 ? select_26 : 6'h0;
      and_30_s3_q <= and_21 & select_29;
      select_33_s3_q <= and_21 ? select_32 : 8'h0;
      select_36_s3_q <= and_21 ? select_35 : 6'h0;
      and_39_s3_q <= and_21 & select_38;
      select_42_s3_q <= and_21 ? select_41 : 8'h0;
      select_45_s3_q <= and_21 ? select_44 : 6'h0;
      and_48_s3_q <= and_21 & select_47;
      select_51_s3_q <= and_21 ? select_50 : 8'h0;
      select_54_s3_q <= and_21 ? select_53 : 6'h0;
      and_57_s3_q <= and_21 & select_56;
      select_60_s3_q <= and_21 ? select_59 : 8'h0;
      select_63_s3_q <= and_21 ? select_62 : 6'h0;
      select_66_s3_q <= and_21 ? select_65 : 8'h0;
      select_69_s3_q <= and_21 ? select_68 : 6'h0;
      select_72_s3_q <= and_21 ? select_71 : 8'h0;
      select_75_s3_q <= and_21 ? select_74 : 6'h0;
      select_78_s3_q <= and_21 ? select_77 : 8'h0;
      select_81_s3_q <= and_21 ? select_80 : 6'h0;
      select_84_s3_q <= and_21 ? select_83 : 8'h0;
      select_87_s3_q <= and_21 ? select_86 : 6'h0;
      select_90_s3_q <= and_21 ? select_89 : 5'h0;
      select_92_s3_q <= select_92_s2_q;
      select_144_s3_q <= and_21 ? select_143 : 6'h0;
      select_151_s3_q <= and_21 ? select_150 : 8'h0;
      and_170_s3_q <= and_21 & select_169;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:57
  logic [6:0] difference_95;
  assign difference_95 = {1'b0, select_36_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_96;
  assign xor_96 = difference_95[5:0] ^ {6{difference_95[6]}};
  logic [6:0] difference;
  assign difference = {6'h0, difference_95[6]} + {1'b0, xor_96};
  logic [6:0] difference_100;
  assign difference_100 = {1'b0, select_27_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_101;
  assign xor_101 = difference_100[5:0] ^ {6{difference_100[6]}};
  logic [6:0] difference_2;
  assign difference_2 = {6'h0, difference_100[6]} + {1'b0, xor_101};
  logic [6:0] difference_106;
  assign difference_106 = {1'b0, select_54_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_107;
  assign xor_107 = difference_106[5:0] ^ {6{difference_106[6]}};
  logic [6:0] difference_3;
  assign difference_3 = {6'h0, difference_106[6]} + {1'b0, xor_107};
  logic [6:0] difference_111;
  assign difference_111 = {1'b0, select_45_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_112;
  assign xor_112 = difference_111[5:0] ^ {6{difference_111[6]}};
  logic [6:0] difference_4;
  assign difference_4 = {6'h0, difference_111[6]} + {1'b0, xor_112};
  logic [6:0] difference_118;
  assign difference_118 = {1'b0, select_69_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_119;
  assign xor_119 = difference_118[5:0] ^ {6{difference_118[6]}};
  logic [6:0] difference_5;
  assign difference_5 = {6'h0, difference_118[6]} + {1'b0, xor_119};
  logic [6:0] difference_124;
  assign difference_124 = {1'b0, select_81_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_125;
  assign xor_125 = difference_124[5:0] ^ {6{difference_124[6]}};
  logic [6:0] difference_6;
  assign difference_6 = {6'h0, difference_124[6]} + {1'b0, xor_125};
  logic [6:0] difference_129;
  assign difference_129 = {1'b0, select_75_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_130;
  assign xor_130 = difference_129[5:0] ^ {6{difference_129[6]}};
  logic [6:0] difference_7;
  assign difference_7 = {6'h0, difference_129[6]} + {1'b0, xor_130};
  logic [6:0] difference_137;
  assign difference_137 = {1'b0, grey_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_138;
  assign xor_138 = difference_137[5:0] ^ {6{difference_137[6]}};
  logic [6:0] difference_8;
  assign difference_8 = {6'h0, difference_137[6]} + {1'b0, xor_138};
  logic [6:0] difference_145;
  assign difference_145 = {1'b0, select_144_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_146;
  assign xor_146 = difference_145[5:0] ^ {6{difference_145[6]}};
  logic [6:0] difference_9;
  assign difference_9 = {6'h0, difference_145[6]} + {1'b0, xor_146};
  logic [6:0] difference_153;
  assign difference_153 = {1'b0, select_87_s3_q} - {1'b0, select_63_s3_q};
  logic [5:0] xor_154;
  assign xor_154 = difference_153[5:0] ^ {6{difference_153[6]}};
  logic [6:0] difference_10;
  assign difference_10 = {6'h0, difference_153[6]} + {1'b0, xor_154};

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_17_s3_q;
  logic memory_we;
  assign memory_we = s3_en & select_92_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_90_s3_q[3:0], firm_s3_q, select_87_s3_q, select_84_s3_q, select_81_s3_q, select_78_s3_q, select_75_s3_q, select_72_s3_q, select_69_s3_q, select_66_s3_q, select_63_s3_q, select_60_s3_q, and_57_s3_q, select_54_s3_q, select_51_s3_q, and_48_s3_q, select_45_s3_q, select_42_s3_q, and_39_s3_q, select_36_s3_q, select_33_s3_q, and_30_s3_q, select_27_s3_q, select_24_s3_q, exists_s3_q, grey_s3_q, vote_s3_q};
  end
`ifndef SYNTHESIS
  logic [10:0] memory_raddr_s1_sim;
  logic memory_re_s1_sim;
  logic [10:0] memory_raddr_s2_sim;
  logic memory_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      memory_re_s1_sim <= 1'b0;
      memory_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      memory_re_s1_sim <= memory_re;
      memory_raddr_s1_sim <= memory_raddr;
      memory_re_s2_sim <= memory_re_s1_sim;
      memory_raddr_s2_sim <= memory_raddr_s1_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && memory_we) begin
      if (memory_re && memory_raddr == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s1_sim && memory_raddr_s1_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s2_sim && memory_raddr_s2_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_waddr >= 11'd1920) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 11'd1920) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  logic [7:0] vote_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic [7:0] select_24_s4_q;
  logic [7:0] select_33_s4_q;
  logic [7:0] select_42_s4_q;
  logic [7:0] select_51_s4_q;
  logic [7:0] select_60_s4_q;
  logic [7:0] select_66_s4_q;
  logic [7:0] select_72_s4_q;
  logic [7:0] select_78_s4_q;
  logic [7:0] select_84_s4_q;
  logic select_90_s4_q;
  logic [6:0] difference_s4_q;
  logic [6:0] difference_2_s4_q;
  logic [6:0] difference_3_s4_q;
  logic [6:0] difference_4_s4_q;
  logic [6:0] difference_5_s4_q;
  logic [6:0] difference_6_s4_q;
  logic [6:0] difference_7_s4_q;
  logic [6:0] difference_8_s4_q;
  logic [6:0] difference_9_s4_q;
  logic [7:0] select_151_s4_q;
  logic [6:0] difference_10_s4_q;
  logic and_170_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      vote_s4_q <= vote_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      select_24_s4_q <= select_24_s3_q;
      select_33_s4_q <= select_33_s3_q;
      select_42_s4_q <= select_42_s3_q;
      select_51_s4_q <= select_51_s3_q;
      select_60_s4_q <= select_60_s3_q;
      select_66_s4_q <= select_66_s3_q;
      select_72_s4_q <= select_72_s3_q;
      select_78_s4_q <= select_78_s3_q;
      select_84_s4_q <= select_84_s3_q;
      select_90_s4_q <= select_90_s3_q[4];
      difference_s4_q <= difference;
      difference_2_s4_q <= difference_2;
      difference_3_s4_q <= difference_3;
      difference_4_s4_q <= difference_4;
      difference_5_s4_q <= difference_5;
      difference_6_s4_q <= difference_6;
      difference_7_s4_q <= difference_7;
      difference_8_s4_q <= difference_8;
      difference_9_s4_q <= difference_9;
      select_151_s4_q <= select_151_s3_q;
      difference_10_s4_q <= difference_10;
      and_170_s4_q <= and_170_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:58
  logic [7:0] select_99;
  assign select_99 = ({3'h0, cfg_similar_i} < difference_s4_q) ? 8'h0 : select_33_s4_q;
  logic [7:0] select_104;
  assign select_104 = ({3'h0, cfg_similar_i} < difference_2_s4_q) ? 8'h0 : select_24_s4_q;
  logic [7:0] select_110;
  assign select_110 = ({3'h0, cfg_similar_i} < difference_3_s4_q) ? 8'h0 : select_51_s4_q;
  logic [7:0] select_115;
  assign select_115 = ({3'h0, cfg_similar_i} < difference_4_s4_q) ? 8'h0 : select_42_s4_q;
  logic [7:0] select_122;
  assign select_122 = ({3'h0, cfg_similar_i} < difference_5_s4_q) ? 8'h0 : select_66_s4_q;
  // hls/stages/ballot.hpp:61
  logic [8:0] sum_123;
  assign sum_123 = {select_60_s4_q[7], select_60_s4_q} + {select_122[7], select_122};
  // hls/stages/ballot.hpp:58
  logic [7:0] select_128;
  assign select_128 = ({3'h0, cfg_similar_i} < difference_6_s4_q) ? 8'h0 : select_78_s4_q;
  logic [7:0] select_133;
  assign select_133 = ({3'h0, cfg_similar_i} < difference_7_s4_q) ? 8'h0 : select_72_s4_q;
  logic [7:0] select_152;
  assign select_152 = ({3'h0, cfg_similar_i} < difference_9_s4_q) ? 8'h0 : select_151_s4_q;
  logic [7:0] select_157;
  assign select_157 = ({3'h0, cfg_similar_i} < difference_10_s4_q) ? 8'h0 : select_84_s4_q;

  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic select_90_s5_q;
  logic [8:0] sum_105_s5_q;
  logic [8:0] sum_116_s5_q;
  logic [8:0] sum_123_s5_q;
  logic [8:0] sum_134_s5_q;
  logic [7:0] select_141_s5_q;
  logic [8:0] sum_158_s5_q;
  logic and_170_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      select_90_s5_q <= select_90_s4_q;
      sum_105_s5_q <= {select_99[7], select_99} + {select_104[7], select_104};
      sum_116_s5_q <= {select_110[7], select_110} + {select_115[7], select_115};
      sum_123_s5_q <= sum_123;
      sum_134_s5_q <= {select_128[7], select_128} + {select_133[7], select_133};
      select_141_s5_q <= ({3'h0, cfg_similar_i} < difference_8_s4_q) ? 8'h0 : vote_s4_q;
      sum_158_s5_q <= {select_152[7], select_152} + {select_157[7], select_157};
      and_170_s5_q <= and_170_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:61
  logic [9:0] sum_117;
  assign sum_117 = {sum_105_s5_q[8], sum_105_s5_q} + {sum_116_s5_q[8], sum_116_s5_q};
  logic [9:0] sum_135;
  assign sum_135 = {sum_123_s5_q[8], sum_123_s5_q} + {sum_134_s5_q[8], sum_134_s5_q};
  logic [9:0] sum_159;
  assign sum_159 = {{2{select_141_s5_q[7]}}, select_141_s5_q} + {sum_158_s5_q[8], sum_158_s5_q};

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_seen_s6_q;
  logic marks_nearer_s6_q;
  logic select_90_s6_q;
  logic [10:0] sum_136_s6_q;
  logic [9:0] sum_159_s6_q;
  logic and_170_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_seen_s6_q <= marks_seen_s5_q;
      marks_nearer_s6_q <= marks_nearer_s5_q;
      select_90_s6_q <= select_90_s5_q;
      sum_136_s6_q <= {sum_117[9], sum_117} + {sum_135[9], sum_135};
      sum_159_s6_q <= sum_159;
      and_170_s6_q <= and_170_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:61
  logic [11:0] sum_160;
  assign sum_160 = {sum_136_s6_q[10], sum_136_s6_q} + {{2{sum_159_s6_q[9]}}, sum_159_s6_q};
  // hls/stages/ballot.hpp:79
  logic [12:0] difference_163;
  assign difference_163 = 13'h0 - {sum_160[11], sum_160};

  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_seen_s7_q;
  logic marks_nearer_s7_q;
  logic not_162_s7_q;
  logic [9:0] difference_163_s7_q;
  logic and_166_s7_q;
  logic and_170_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_seen_s7_q <= marks_seen_s6_q;
      marks_nearer_s7_q <= marks_nearer_s6_q;
      not_162_s7_q <= ~($signed(sum_160) < $signed({4'h0, cfg_quorum_i}));
      difference_163_s7_q <= difference_163[12:3];
      and_166_s7_q <= select_90_s6_q & sum_160[11];
      and_170_s7_q <= and_170_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:79
  logic less_164;
  assign less_164 = $signed(difference_163_s7_q) < $signed({2'h0, cfg_clear_quorum_i});

  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_seen_s8_q;
  logic marks_nearer_s8_q;
  logic not_162_s8_q;
  logic or_167_s8_q;
  logic and_170_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_seen_s8_q <= marks_seen_s7_q;
      marks_nearer_s8_q <= marks_nearer_s7_q;
      not_162_s8_q <= not_162_s7_q;
      or_167_s8_q <= (~less_164) | and_166_s7_q;
      and_170_s8_q <= and_170_s7_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_o = not_162_s8_q;
  assign clear_o = or_167_s8_q;
  assign exists_o = and_170_s8_q;
  assign marks_first_o = marks_first_s8_q;
  assign marks_last_o = marks_last_s8_q;
  assign marks_seen_o = marks_seen_s8_q;
  assign marks_nearer_o = marks_nearer_s8_q;
  assign valid_o = valid_s8_q;

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
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
      valid_s8_q <= valid_s7_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^difference_163[2:0];

endmodule
