// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Ballot<horopter::hls::profiles::hd>, hls/stages/ballot.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 14 bits, pipeline 733 bits, memories 288000 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q;
  logic s0_en, s2_en, s3_en, s8_en;
  assign s0_en = en_i & valid_i;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s8_en = en_i & valid_s8_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] select_165;
  assign select_165 = cfg_dim_i ? {1'b0, cfg_clear_quorum_i[7:1]} : cfg_clear_quorum_i;
  logic [8:0] select_166;
  assign select_166 = cfg_dim_i ? {cfg_clear_quorum_i, 1'b0} : {1'b0, cfg_clear_quorum_i};
  logic [9:0] sum_167;
  assign sum_167 = {1'b0, select_166} + {3'h0, select_165[7:1]};

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] raster_column_q;
  logic raster_row_ended_q;
  logic running_q;
  // hls/stages/ballot.hpp:49
  logic [10:0] select_18;
  assign select_18 = (marks_first_i | raster_row_ended_q) ? 11'h0 : raster_column_q;
  // hls/stages/ballot.hpp:53
  logic or_19;
  assign or_19 = marks_first_i | running_q;

  // Memory memory, 1920 x 150, DISTANCE 16, hls/stages/ballot.hpp:127; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [149:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 150'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_18;
`ifndef SYNTHESIS
  logic memory_re;
  assign memory_re = s0_en & or_19;
`endif
  logic [149:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_18 + 11'h1;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_19 : (marks_first_i & or_19);
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
  logic [10:0] select_18_s1_q;
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
      select_18_s1_q <= select_18;
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
  logic [10:0] select_18_s2_q;
  logic [149:0] memory_rdata_s2_q;
  logic select_93_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      vote_s2_q <= vote_s1_q;
      firm_s2_q <= firm_s1_q;
      grey_s2_q <= grey_s1_q;
      exists_s2_q <= exists_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      running_s2_q <= running_s1_q;
      select_18_s2_q <= select_18_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
      select_93_s2_q <= running_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/ballot.hpp:49
  logic and_22;
  assign and_22 = raster_rows_q & (~marks_first_s2_q);
  // hls/stages/ballot.hpp:59
  logic [7:0] select_24;
  assign select_24 = running_s2_q ? memory_rdata_s2_q[7:0] : (marks_first_s2_q ? memory_rdata_s2_q[7:0] : 8'h0);
  logic [5:0] select_27;
  assign select_27 = running_s2_q ? memory_rdata_s2_q[13:8] : (marks_first_s2_q ? memory_rdata_s2_q[13:8] : 6'h0);
  logic select_30;
  assign select_30 = running_s2_q ? memory_rdata_s2_q[14] : (marks_first_s2_q & memory_rdata_s2_q[14]);
  logic [7:0] select_33;
  assign select_33 = running_s2_q ? memory_rdata_s2_q[22:15] : (marks_first_s2_q ? memory_rdata_s2_q[22:15] : 8'h0);
  logic [5:0] select_36;
  assign select_36 = running_s2_q ? memory_rdata_s2_q[28:23] : (marks_first_s2_q ? memory_rdata_s2_q[28:23] : 6'h0);
  logic select_39;
  assign select_39 = running_s2_q ? memory_rdata_s2_q[29] : (marks_first_s2_q & memory_rdata_s2_q[29]);
  logic [7:0] select_42;
  assign select_42 = running_s2_q ? memory_rdata_s2_q[37:30] : (marks_first_s2_q ? memory_rdata_s2_q[37:30] : 8'h0);
  logic [5:0] select_45;
  assign select_45 = running_s2_q ? memory_rdata_s2_q[43:38] : (marks_first_s2_q ? memory_rdata_s2_q[43:38] : 6'h0);
  logic select_48;
  assign select_48 = running_s2_q ? memory_rdata_s2_q[44] : (marks_first_s2_q & memory_rdata_s2_q[44]);
  logic [7:0] select_51;
  assign select_51 = running_s2_q ? memory_rdata_s2_q[52:45] : (marks_first_s2_q ? memory_rdata_s2_q[52:45] : 8'h0);
  logic [5:0] select_54;
  assign select_54 = running_s2_q ? memory_rdata_s2_q[58:53] : (marks_first_s2_q ? memory_rdata_s2_q[58:53] : 6'h0);
  logic select_57;
  assign select_57 = running_s2_q ? memory_rdata_s2_q[59] : (marks_first_s2_q & memory_rdata_s2_q[59]);
  logic [7:0] select_60;
  assign select_60 = running_s2_q ? memory_rdata_s2_q[67:60] : (marks_first_s2_q ? memory_rdata_s2_q[67:60] : 8'h0);
  logic [5:0] select_63;
  assign select_63 = running_s2_q ? memory_rdata_s2_q[73:68] : (marks_first_s2_q ? memory_rdata_s2_q[73:68] : 6'h0);
  logic [7:0] select_66;
  assign select_66 = running_s2_q ? memory_rdata_s2_q[82:75] : (marks_first_s2_q ? memory_rdata_s2_q[82:75] : 8'h0);
  logic [5:0] select_69;
  assign select_69 = running_s2_q ? memory_rdata_s2_q[88:83] : (marks_first_s2_q ? memory_rdata_s2_q[88:83] : 6'h0);
  logic [7:0] select_72;
  assign select_72 = running_s2_q ? memory_rdata_s2_q[96:89] : (marks_first_s2_q ? memory_rdata_s2_q[96:89] : 8'h0);
  logic [5:0] select_75;
  assign select_75 = running_s2_q ? memory_rdata_s2_q[102:97] : (marks_first_s2_q ? memory_rdata_s2_q[102:97] : 6'h0);
  logic [7:0] select_78;
  assign select_78 = running_s2_q ? memory_rdata_s2_q[110:103] : (marks_first_s2_q ? memory_rdata_s2_q[110:103] : 8'h0);
  logic [5:0] select_81;
  assign select_81 = running_s2_q ? memory_rdata_s2_q[116:111] : (marks_first_s2_q ? memory_rdata_s2_q[116:111] : 6'h0);
  logic [7:0] select_84;
  assign select_84 = running_s2_q ? memory_rdata_s2_q[124:117] : (marks_first_s2_q ? memory_rdata_s2_q[124:117] : 8'h0);
  logic [5:0] select_87;
  assign select_87 = running_s2_q ? memory_rdata_s2_q[130:125] : (marks_first_s2_q ? memory_rdata_s2_q[130:125] : 6'h0);
  logic [4:0] select_90;
  assign select_90 = running_s2_q ? memory_rdata_s2_q[149:145] : (marks_first_s2_q ? memory_rdata_s2_q[149:145] : 5'h0);
  logic [5:0] select_107;
  assign select_107 = running_s2_q ? memory_rdata_s2_q[144:139] : (marks_first_s2_q ? memory_rdata_s2_q[144:139] : 6'h0);
  logic [7:0] select_114;
  assign select_114 = running_s2_q ? memory_rdata_s2_q[138:131] : (marks_first_s2_q ? memory_rdata_s2_q[138:131] : 8'h0);
  logic select_173;
  assign select_173 = running_s2_q ? memory_rdata_s2_q[74] : (marks_first_s2_q & memory_rdata_s2_q[74]);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s2_en) begin
      raster_rows_q <= marks_last_s2_q | and_22;
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
  logic [10:0] select_18_s3_q;
  logic [7:0] select_25_s3_q;
  logic [5:0] select_28_s3_q;
  logic and_31_s3_q;
  logic [7:0] select_34_s3_q;
  logic [5:0] select_37_s3_q;
  logic and_40_s3_q;
  logic [7:0] select_43_s3_q;
  logic [5:0] select_46_s3_q;
  logic and_49_s3_q;
  logic [7:0] select_52_s3_q;
  logic [5:0] select_55_s3_q;
  logic and_58_s3_q;
  logic [7:0] select_61_s3_q;
  logic [5:0] select_64_s3_q;
  logic [7:0] select_67_s3_q;
  logic [5:0] select_70_s3_q;
  logic [7:0] select_73_s3_q;
  logic [5:0] select_76_s3_q;
  logic [7:0] select_79_s3_q;
  logic [5:0] select_82_s3_q;
  logic [7:0] select_85_s3_q;
  logic [5:0] select_88_s3_q;
  logic [4:0] select_91_s3_q;
  logic select_93_s3_q;
  logic [5:0] select_108_s3_q;
  logic [7:0] select_115_s3_q;
  logic and_174_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      vote_s3_q <= vote_s2_q;
      firm_s3_q <= firm_s2_q;
      grey_s3_q <= grey_s2_q;
      exists_s3_q <= exists_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      select_18_s3_q <= select_18_s2_q;
      select_25_s3_q <= and_22 ? select_24 : 8'h0;
      select_28_s3_q <= and_22 ? select_27 : 6'h0;
      and_31_s3_q <= and_22 & select_30;
      select_34_s3_q <= and_22 ? select_33 : 8'h0;
      select_37_s3_q <= and_22 ? select_36 : 6'h0;
      and_40_s3_q <= and_22 & select_39;
      select_43_s3_q <= and_22 ? select_42 : 8'h0;
      select_46_s3_q <= and_22 ? select_45 : 6'h0;
      and_49_s3_q <= and_22 & select_48;
      select_52_s3_q <= and_22 ? select_51 : 8'h0;
      select_55_s3_q <= and_22 ? select_54 : 6'h0;
      and_58_s3_q <= and_22 & select_57;
      select_61_s3_q <= and_22 ? select_60 : 8'h0;
      select_64_s3_q <= and_22 ? select_63 : 6'h0;
      select_67_s3_q <= and_22 ? select_66 : 8'h0;
      select_70_s3_q <= and_22 ? select_69 : 6'h0;
      select_73_s3_q <= and_22 ? select_72 : 8'h0;
      select_76_s3_q <= and_22 ? select_75 : 6'h0;
      select_79_s3_q <= and_22 ? select_78 : 8'h0;
      select_82_s3_q <= and_22 ? select_81 : 6'h0;
      select_85_s3_q <= and_22 ? select_84 : 8'h0;
      select_88_s3_q <= and_22 ? select_87 : 6'h0;
      select_91_s3_q <= and_22 ? select_90 : 5'h0;
      select_93_s3_q <= select_93_s2_q;
      select_108_s3_q <= and_22 ? select_107 : 6'h0;
      select_115_s3_q <= and_22 ? select_114 : 8'h0;
      and_174_s3_q <= and_22 & select_173;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:67
  logic [6:0] difference_96;
  assign difference_96 = {1'b0, grey_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_97;
  assign xor_97 = difference_96[5:0] ^ {6{difference_96[6]}};
  logic [6:0] difference;
  assign difference = {6'h0, difference_96[6]} + {1'b0, xor_97};
  logic [6:0] difference_101;
  assign difference_101 = {1'b0, select_88_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_102;
  assign xor_102 = difference_101[5:0] ^ {6{difference_101[6]}};
  logic [6:0] difference_2;
  assign difference_2 = {6'h0, difference_101[6]} + {1'b0, xor_102};
  logic [6:0] difference_109;
  assign difference_109 = {1'b0, select_108_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_110;
  assign xor_110 = difference_109[5:0] ^ {6{difference_109[6]}};
  logic [6:0] difference_3;
  assign difference_3 = {6'h0, difference_109[6]} + {1'b0, xor_110};
  logic [6:0] difference_119;
  assign difference_119 = {1'b0, select_28_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_120;
  assign xor_120 = difference_119[5:0] ^ {6{difference_119[6]}};
  logic [6:0] difference_4;
  assign difference_4 = {6'h0, difference_119[6]} + {1'b0, xor_120};
  logic [6:0] difference_124;
  assign difference_124 = {1'b0, select_37_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_125;
  assign xor_125 = difference_124[5:0] ^ {6{difference_124[6]}};
  logic [6:0] difference_5;
  assign difference_5 = {6'h0, difference_124[6]} + {1'b0, xor_125};
  logic [6:0] difference_130;
  assign difference_130 = {1'b0, select_46_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_131;
  assign xor_131 = difference_130[5:0] ^ {6{difference_130[6]}};
  logic [6:0] difference_6;
  assign difference_6 = {6'h0, difference_130[6]} + {1'b0, xor_131};
  logic [6:0] difference_135;
  assign difference_135 = {1'b0, select_55_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_136;
  assign xor_136 = difference_135[5:0] ^ {6{difference_135[6]}};
  logic [6:0] difference_7;
  assign difference_7 = {6'h0, difference_135[6]} + {1'b0, xor_136};
  logic [6:0] difference_142;
  assign difference_142 = {1'b0, select_70_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_143;
  assign xor_143 = difference_142[5:0] ^ {6{difference_142[6]}};
  logic [6:0] difference_8;
  assign difference_8 = {6'h0, difference_142[6]} + {1'b0, xor_143};
  logic [6:0] difference_148;
  assign difference_148 = {1'b0, select_76_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_149;
  assign xor_149 = difference_148[5:0] ^ {6{difference_148[6]}};
  logic [6:0] difference_9;
  assign difference_9 = {6'h0, difference_148[6]} + {1'b0, xor_149};
  logic [6:0] difference_153;
  assign difference_153 = {1'b0, select_82_s3_q} - {1'b0, select_64_s3_q};
  logic [5:0] xor_154;
  assign xor_154 = difference_153[5:0] ^ {6{difference_153[6]}};
  logic [6:0] difference_10;
  assign difference_10 = {6'h0, difference_153[6]} + {1'b0, xor_154};

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_18_s3_q;
  logic memory_we;
  assign memory_we = s3_en & select_93_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_91_s3_q[3:0], firm_s3_q, select_88_s3_q, select_85_s3_q, select_82_s3_q, select_79_s3_q, select_76_s3_q, select_73_s3_q, select_70_s3_q, select_67_s3_q, select_64_s3_q, select_61_s3_q, and_58_s3_q, select_55_s3_q, select_52_s3_q, and_49_s3_q, select_46_s3_q, select_43_s3_q, and_40_s3_q, select_37_s3_q, select_34_s3_q, and_31_s3_q, select_28_s3_q, select_25_s3_q, exists_s3_q, grey_s3_q, vote_s3_q};
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
  logic [7:0] select_25_s4_q;
  logic [7:0] select_34_s4_q;
  logic [7:0] select_43_s4_q;
  logic [7:0] select_52_s4_q;
  logic [7:0] select_61_s4_q;
  logic [7:0] select_67_s4_q;
  logic [7:0] select_73_s4_q;
  logic [7:0] select_79_s4_q;
  logic [7:0] select_85_s4_q;
  logic select_91_s4_q;
  logic [6:0] difference_s4_q;
  logic [6:0] difference_2_s4_q;
  logic [6:0] difference_3_s4_q;
  logic [7:0] select_115_s4_q;
  logic [6:0] difference_4_s4_q;
  logic [6:0] difference_5_s4_q;
  logic [6:0] difference_6_s4_q;
  logic [6:0] difference_7_s4_q;
  logic [6:0] difference_8_s4_q;
  logic [6:0] difference_9_s4_q;
  logic [6:0] difference_10_s4_q;
  logic and_174_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      vote_s4_q <= vote_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      select_25_s4_q <= select_25_s3_q;
      select_34_s4_q <= select_34_s3_q;
      select_43_s4_q <= select_43_s3_q;
      select_52_s4_q <= select_52_s3_q;
      select_61_s4_q <= select_61_s3_q;
      select_67_s4_q <= select_67_s3_q;
      select_73_s4_q <= select_73_s3_q;
      select_79_s4_q <= select_79_s3_q;
      select_85_s4_q <= select_85_s3_q;
      select_91_s4_q <= select_91_s3_q[4];
      difference_s4_q <= difference;
      difference_2_s4_q <= difference_2;
      difference_3_s4_q <= difference_3;
      select_115_s4_q <= select_115_s3_q;
      difference_4_s4_q <= difference_4;
      difference_5_s4_q <= difference_5;
      difference_6_s4_q <= difference_6;
      difference_7_s4_q <= difference_7;
      difference_8_s4_q <= difference_8;
      difference_9_s4_q <= difference_9;
      difference_10_s4_q <= difference_10;
      and_174_s4_q <= and_174_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:68
  logic [7:0] select_105;
  assign select_105 = ({3'h0, cfg_similar_i} < difference_2_s4_q) ? 8'h0 : select_85_s4_q;
  logic [7:0] select_116;
  assign select_116 = ({3'h0, cfg_similar_i} < difference_3_s4_q) ? 8'h0 : select_115_s4_q;
  logic [7:0] select_123;
  assign select_123 = ({3'h0, cfg_similar_i} < difference_4_s4_q) ? 8'h0 : select_25_s4_q;
  logic [7:0] select_128;
  assign select_128 = ({3'h0, cfg_similar_i} < difference_5_s4_q) ? 8'h0 : select_34_s4_q;
  logic [7:0] select_134;
  assign select_134 = ({3'h0, cfg_similar_i} < difference_6_s4_q) ? 8'h0 : select_43_s4_q;
  logic [7:0] select_139;
  assign select_139 = ({3'h0, cfg_similar_i} < difference_7_s4_q) ? 8'h0 : select_52_s4_q;
  logic [7:0] select_146;
  assign select_146 = ({3'h0, cfg_similar_i} < difference_8_s4_q) ? 8'h0 : select_67_s4_q;
  logic [7:0] select_152;
  assign select_152 = ({3'h0, cfg_similar_i} < difference_9_s4_q) ? 8'h0 : select_73_s4_q;
  logic [7:0] select_157;
  assign select_157 = ({3'h0, cfg_similar_i} < difference_10_s4_q) ? 8'h0 : select_79_s4_q;

  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic [7:0] select_61_s5_q;
  logic select_91_s5_q;
  logic [7:0] select_100_s5_q;
  logic [7:0] select_105_s5_q;
  logic [7:0] select_116_s5_q;
  logic [7:0] select_123_s5_q;
  logic [7:0] select_128_s5_q;
  logic [7:0] select_134_s5_q;
  logic [7:0] select_139_s5_q;
  logic [7:0] select_146_s5_q;
  logic [7:0] select_152_s5_q;
  logic [7:0] select_157_s5_q;
  logic and_174_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      select_61_s5_q <= select_61_s4_q;
      select_91_s5_q <= select_91_s4_q;
      select_100_s5_q <= ({3'h0, cfg_similar_i} < difference_s4_q) ? 8'h0 : vote_s4_q;
      select_105_s5_q <= select_105;
      select_116_s5_q <= select_116;
      select_123_s5_q <= select_123;
      select_128_s5_q <= select_128;
      select_134_s5_q <= select_134;
      select_139_s5_q <= select_139;
      select_146_s5_q <= select_146;
      select_152_s5_q <= select_152;
      select_157_s5_q <= select_157;
      and_174_s5_q <= and_174_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:71
  logic [8:0] sum_117;
  assign sum_117 = {select_105_s5_q[7], select_105_s5_q} + {select_116_s5_q[7], select_116_s5_q};
  logic [9:0] sum_118;
  assign sum_118 = {{2{select_100_s5_q[7]}}, select_100_s5_q} + {sum_117[8], sum_117};
  logic [8:0] sum_129;
  assign sum_129 = {select_123_s5_q[7], select_123_s5_q} + {select_128_s5_q[7], select_128_s5_q};
  logic [8:0] sum_140;
  assign sum_140 = {select_134_s5_q[7], select_134_s5_q} + {select_139_s5_q[7], select_139_s5_q};
  logic [8:0] sum_147;
  assign sum_147 = {select_61_s5_q[7], select_61_s5_q} + {select_146_s5_q[7], select_146_s5_q};
  logic [8:0] sum_158;
  assign sum_158 = {select_152_s5_q[7], select_152_s5_q} + {select_157_s5_q[7], select_157_s5_q};

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_seen_s6_q;
  logic marks_nearer_s6_q;
  logic select_91_s6_q;
  logic [9:0] sum_118_s6_q;
  logic [9:0] sum_141_s6_q;
  logic [9:0] sum_159_s6_q;
  logic and_174_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_seen_s6_q <= marks_seen_s5_q;
      marks_nearer_s6_q <= marks_nearer_s5_q;
      select_91_s6_q <= select_91_s5_q;
      sum_118_s6_q <= sum_118;
      sum_141_s6_q <= {sum_129[8], sum_129} + {sum_140[8], sum_140};
      sum_159_s6_q <= {sum_147[8], sum_147} + {sum_158[8], sum_158};
      and_174_s6_q <= and_174_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:71
  logic [10:0] sum_160;
  assign sum_160 = {sum_141_s6_q[9], sum_141_s6_q} + {sum_159_s6_q[9], sum_159_s6_q};

  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_seen_s7_q;
  logic marks_nearer_s7_q;
  logic select_91_s7_q;
  logic [11:0] sum_161_s7_q;
  logic and_174_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_seen_s7_q <= marks_seen_s6_q;
      marks_nearer_s7_q <= marks_nearer_s6_q;
      select_91_s7_q <= select_91_s6_q;
      sum_161_s7_q <= {{2{sum_118_s6_q[9]}}, sum_118_s6_q} + {sum_160[10], sum_160};
      and_174_s7_q <= and_174_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:89
  logic [12:0] difference_164;
  assign difference_164 = 13'h0 - {sum_161_s7_q[11], sum_161_s7_q};
  logic less_168;
  assign less_168 = {{3{difference_164[12]}}, difference_164} < {5'h0, sum_167, select_165[0]};

  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_seen_s8_q;
  logic marks_nearer_s8_q;
  logic select_91_s8_q;
  logic sum_161_s8_q;
  logic not_163_s8_q;
  logic not_169_s8_q;
  logic and_174_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_seen_s8_q <= marks_seen_s7_q;
      marks_nearer_s8_q <= marks_nearer_s7_q;
      select_91_s8_q <= select_91_s7_q;
      sum_161_s8_q <= sum_161_s7_q[11];
      not_163_s8_q <= ~($signed(sum_161_s7_q) < $signed({4'h0, cfg_quorum_i}));
      not_169_s8_q <= ~less_168;
      and_174_s8_q <= and_174_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------

  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic marks_seen_s9_q;
  logic marks_nearer_s9_q;
  logic not_163_s9_q;
  logic and_171_s9_q;
  logic and_174_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      marks_seen_s9_q <= marks_seen_s8_q;
      marks_nearer_s9_q <= marks_nearer_s8_q;
      not_163_s9_q <= not_163_s8_q;
      and_171_s9_q <= sum_161_s8_q & (select_91_s8_q | not_169_s8_q);
      and_174_s9_q <= and_174_s8_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_o = not_163_s9_q;
  assign clear_o = and_171_s9_q;
  assign exists_o = and_174_s9_q;
  assign marks_first_o = marks_first_s9_q;
  assign marks_last_o = marks_last_s9_q;
  assign marks_seen_o = marks_seen_s9_q;
  assign marks_nearer_o = marks_nearer_s9_q;
  assign valid_o = valid_s9_q;

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
    end
  end

endmodule
