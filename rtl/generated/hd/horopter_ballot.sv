// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Ballot<horopter::hls::profiles::hd>, hls/stages/ballot.hpp. Do not edit.
//
// Latency 8 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 14 bits, pipeline 662 bits, memories 288000 bits.
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
  // hls/stages/ballot.hpp:34
  logic [10:0] select_15;
  assign select_15 = (marks_first_i | raster_row_ended_q) ? 11'h0 : raster_column_q;
  // hls/stages/ballot.hpp:37
  logic or_16;
  assign or_16 = marks_first_i | running_q;

  // Memory memory, 1920 x 150, DISTANCE 16, hls/stages/ballot.hpp:80; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [149:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 150'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_15;
  logic memory_re;
  assign memory_re = s0_en & or_16;
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
      raster_column_q <= select_15 + 11'h1;
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
  logic [10:0] select_15_s1_q;
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

  logic [7:0] vote_s2_q;
  logic firm_s2_q;
  logic [5:0] grey_s2_q;
  logic exists_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic running_s2_q;
  logic [10:0] select_15_s2_q;
  logic [149:0] memory_rdata_s2_q;
  logic select_90_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      vote_s2_q <= vote_s1_q;
      firm_s2_q <= firm_s1_q;
      grey_s2_q <= grey_s1_q;
      exists_s2_q <= exists_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      running_s2_q <= running_s1_q;
      select_15_s2_q <= select_15_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
      select_90_s2_q <= running_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/ballot.hpp:34
  logic and_19;
  assign and_19 = raster_rows_q & (~marks_first_s2_q);
  // hls/stages/ballot.hpp:38
  logic [7:0] select_21;
  assign select_21 = running_s2_q ? memory_rdata_s2_q[7:0] : (marks_first_s2_q ? memory_rdata_s2_q[7:0] : 8'h0);
  logic [5:0] select_24;
  assign select_24 = running_s2_q ? memory_rdata_s2_q[13:8] : (marks_first_s2_q ? memory_rdata_s2_q[13:8] : 6'h0);
  logic select_27;
  assign select_27 = running_s2_q ? memory_rdata_s2_q[14] : (marks_first_s2_q & memory_rdata_s2_q[14]);
  logic [7:0] select_30;
  assign select_30 = running_s2_q ? memory_rdata_s2_q[22:15] : (marks_first_s2_q ? memory_rdata_s2_q[22:15] : 8'h0);
  logic [5:0] select_33;
  assign select_33 = running_s2_q ? memory_rdata_s2_q[28:23] : (marks_first_s2_q ? memory_rdata_s2_q[28:23] : 6'h0);
  logic select_36;
  assign select_36 = running_s2_q ? memory_rdata_s2_q[29] : (marks_first_s2_q & memory_rdata_s2_q[29]);
  logic [7:0] select_39;
  assign select_39 = running_s2_q ? memory_rdata_s2_q[37:30] : (marks_first_s2_q ? memory_rdata_s2_q[37:30] : 8'h0);
  logic [5:0] select_42;
  assign select_42 = running_s2_q ? memory_rdata_s2_q[43:38] : (marks_first_s2_q ? memory_rdata_s2_q[43:38] : 6'h0);
  logic select_45;
  assign select_45 = running_s2_q ? memory_rdata_s2_q[44] : (marks_first_s2_q & memory_rdata_s2_q[44]);
  logic [7:0] select_48;
  assign select_48 = running_s2_q ? memory_rdata_s2_q[52:45] : (marks_first_s2_q ? memory_rdata_s2_q[52:45] : 8'h0);
  logic [5:0] select_51;
  assign select_51 = running_s2_q ? memory_rdata_s2_q[58:53] : (marks_first_s2_q ? memory_rdata_s2_q[58:53] : 6'h0);
  logic select_54;
  assign select_54 = running_s2_q ? memory_rdata_s2_q[59] : (marks_first_s2_q & memory_rdata_s2_q[59]);
  logic [7:0] select_57;
  assign select_57 = running_s2_q ? memory_rdata_s2_q[67:60] : (marks_first_s2_q ? memory_rdata_s2_q[67:60] : 8'h0);
  logic [5:0] select_60;
  assign select_60 = running_s2_q ? memory_rdata_s2_q[73:68] : (marks_first_s2_q ? memory_rdata_s2_q[73:68] : 6'h0);
  logic [7:0] select_63;
  assign select_63 = running_s2_q ? memory_rdata_s2_q[82:75] : (marks_first_s2_q ? memory_rdata_s2_q[82:75] : 8'h0);
  logic [5:0] select_66;
  assign select_66 = running_s2_q ? memory_rdata_s2_q[88:83] : (marks_first_s2_q ? memory_rdata_s2_q[88:83] : 6'h0);
  logic [7:0] select_69;
  assign select_69 = running_s2_q ? memory_rdata_s2_q[96:89] : (marks_first_s2_q ? memory_rdata_s2_q[96:89] : 8'h0);
  logic [5:0] select_72;
  assign select_72 = running_s2_q ? memory_rdata_s2_q[102:97] : (marks_first_s2_q ? memory_rdata_s2_q[102:97] : 6'h0);
  logic [7:0] select_75;
  assign select_75 = running_s2_q ? memory_rdata_s2_q[110:103] : (marks_first_s2_q ? memory_rdata_s2_q[110:103] : 8'h0);
  logic [5:0] select_78;
  assign select_78 = running_s2_q ? memory_rdata_s2_q[116:111] : (marks_first_s2_q ? memory_rdata_s2_q[116:111] : 6'h0);
  logic [7:0] select_81;
  assign select_81 = running_s2_q ? memory_rdata_s2_q[124:117] : (marks_first_s2_q ? memory_rdata_s2_q[124:117] : 8'h0);
  logic [5:0] select_84;
  assign select_84 = running_s2_q ? memory_rdata_s2_q[130:125] : (marks_first_s2_q ? memory_rdata_s2_q[130:125] : 6'h0);
  logic [4:0] select_87;
  assign select_87 = running_s2_q ? memory_rdata_s2_q[149:145] : (marks_first_s2_q ? memory_rdata_s2_q[149:145] : 5'h0);
  logic [5:0] select_104;
  assign select_104 = running_s2_q ? memory_rdata_s2_q[144:139] : (marks_first_s2_q ? memory_rdata_s2_q[144:139] : 6'h0);
  logic [7:0] select_111;
  assign select_111 = running_s2_q ? memory_rdata_s2_q[138:131] : (marks_first_s2_q ? memory_rdata_s2_q[138:131] : 8'h0);
  logic select_167;
  assign select_167 = running_s2_q ? memory_rdata_s2_q[74] : (marks_first_s2_q & memory_rdata_s2_q[74]);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s2_en) begin
      raster_rows_q <= marks_last_s2_q | and_19;
    end
  end

  logic [7:0] vote_s3_q;
  logic firm_s3_q;
  logic [5:0] grey_s3_q;
  logic exists_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic [10:0] select_15_s3_q;
  logic [7:0] select_22_s3_q;
  logic [5:0] select_25_s3_q;
  logic and_28_s3_q;
  logic [7:0] select_31_s3_q;
  logic [5:0] select_34_s3_q;
  logic and_37_s3_q;
  logic [7:0] select_40_s3_q;
  logic [5:0] select_43_s3_q;
  logic and_46_s3_q;
  logic [7:0] select_49_s3_q;
  logic [5:0] select_52_s3_q;
  logic and_55_s3_q;
  logic [7:0] select_58_s3_q;
  logic [5:0] select_61_s3_q;
  logic [7:0] select_64_s3_q;
  logic [5:0] select_67_s3_q;
  logic [7:0] select_70_s3_q;
  logic [5:0] select_73_s3_q;
  logic [7:0] select_76_s3_q;
  logic [5:0] select_79_s3_q;
  logic [7:0] select_82_s3_q;
  logic [5:0] select_85_s3_q;
  logic [4:0] select_88_s3_q;
  logic select_90_s3_q;
  logic [5:0] select_105_s3_q;
  logic [7:0] select_112_s3_q;
  logic and_168_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      vote_s3_q <= vote_s2_q;
      firm_s3_q <= firm_s2_q;
      grey_s3_q <= grey_s2_q;
      exists_s3_q <= exists_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      select_15_s3_q <= select_15_s2_q;
      select_22_s3_q <= and_19 ? select_21 : 8'h0;
      select_25_s3_q <= and_19 ? select_24 : 6'h0;
      and_28_s3_q <= and_19 & select_27;
      select_31_s3_q <= and_19 ? select_30 : 8'h0;
      select_34_s3_q <= and_19 ? select_33 : 6'h0;
      and_37_s3_q <= and_19 & select_36;
      select_40_s3_q <= and_19 ? select_39 : 8'h0;
      select_43_s3_q <= and_19 ? select_42 : 6'h0;
      and_46_s3_q <= and_19 & select_45;
      select_49_s3_q <= and_19 ? select_48 : 8'h0;
      select_52_s3_q <= and_19 ? select_51 : 6'h0;
      and_55_s3_q <= and_19 & select_54;
      select_58_s3_q <= and_19 ? select_57 : 8'h0;
      select_61_s3_q <= and_19 ? select_60 : 6'h0;
      select_64_s3_q <= and_19 ? select_63 : 8'h0;
      select_67_s3_q <= and_19 ? select_66 : 6'h0;
      select_70_s3_q <= and_19 ? select_69 : 8'h0;
      select_73_s3_q <= and_19 ? select_72 : 6'h0;
      select_76_s3_q <= and_19 ? select_75 : 8'h0;
      select_79_s3_q <= and_19 ? select_78 : 6'h0;
      select_82_s3_q <= and_19 ? select_81 : 8'h0;
      select_85_s3_q <= and_19 ? select_84 : 6'h0;
      select_88_s3_q <= and_19 ? select_87 : 5'h0;
      select_90_s3_q <= select_90_s2_q;
      select_105_s3_q <= and_19 ? select_104 : 6'h0;
      select_112_s3_q <= and_19 ? select_111 : 8'h0;
      and_168_s3_q <= and_19 & select_167;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:46
  logic [6:0] difference_93;
  assign difference_93 = {1'b0, grey_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_94;
  assign xor_94 = difference_93[5:0] ^ {6{difference_93[6]}};
  logic [6:0] difference;
  assign difference = {6'h0, difference_93[6]} + {1'b0, xor_94};
  logic [6:0] difference_98;
  assign difference_98 = {1'b0, select_85_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_99;
  assign xor_99 = difference_98[5:0] ^ {6{difference_98[6]}};
  logic [6:0] difference_2;
  assign difference_2 = {6'h0, difference_98[6]} + {1'b0, xor_99};
  logic [6:0] difference_106;
  assign difference_106 = {1'b0, select_105_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_107;
  assign xor_107 = difference_106[5:0] ^ {6{difference_106[6]}};
  logic [6:0] difference_3;
  assign difference_3 = {6'h0, difference_106[6]} + {1'b0, xor_107};
  logic [6:0] difference_116;
  assign difference_116 = {1'b0, select_25_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_117;
  assign xor_117 = difference_116[5:0] ^ {6{difference_116[6]}};
  logic [6:0] difference_4;
  assign difference_4 = {6'h0, difference_116[6]} + {1'b0, xor_117};
  logic [6:0] difference_121;
  assign difference_121 = {1'b0, select_34_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_122;
  assign xor_122 = difference_121[5:0] ^ {6{difference_121[6]}};
  logic [6:0] difference_5;
  assign difference_5 = {6'h0, difference_121[6]} + {1'b0, xor_122};
  logic [6:0] difference_127;
  assign difference_127 = {1'b0, select_43_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_128;
  assign xor_128 = difference_127[5:0] ^ {6{difference_127[6]}};
  logic [6:0] difference_6;
  assign difference_6 = {6'h0, difference_127[6]} + {1'b0, xor_128};
  logic [6:0] difference_132;
  assign difference_132 = {1'b0, select_52_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_133;
  assign xor_133 = difference_132[5:0] ^ {6{difference_132[6]}};
  logic [6:0] difference_7;
  assign difference_7 = {6'h0, difference_132[6]} + {1'b0, xor_133};
  logic [6:0] difference_139;
  assign difference_139 = {1'b0, select_67_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_140;
  assign xor_140 = difference_139[5:0] ^ {6{difference_139[6]}};
  logic [6:0] difference_8;
  assign difference_8 = {6'h0, difference_139[6]} + {1'b0, xor_140};
  logic [6:0] difference_145;
  assign difference_145 = {1'b0, select_73_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_146;
  assign xor_146 = difference_145[5:0] ^ {6{difference_145[6]}};
  logic [6:0] difference_9;
  assign difference_9 = {6'h0, difference_145[6]} + {1'b0, xor_146};
  logic [6:0] difference_150;
  assign difference_150 = {1'b0, select_79_s3_q} - {1'b0, select_61_s3_q};
  logic [5:0] xor_151;
  assign xor_151 = difference_150[5:0] ^ {6{difference_150[6]}};
  logic [6:0] difference_10;
  assign difference_10 = {6'h0, difference_150[6]} + {1'b0, xor_151};

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_15_s3_q;
  logic memory_we;
  assign memory_we = s3_en & select_90_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_88_s3_q[3:0], firm_s3_q, select_85_s3_q, select_82_s3_q, select_79_s3_q, select_76_s3_q, select_73_s3_q, select_70_s3_q, select_67_s3_q, select_64_s3_q, select_61_s3_q, select_58_s3_q, and_55_s3_q, select_52_s3_q, select_49_s3_q, and_46_s3_q, select_43_s3_q, select_40_s3_q, and_37_s3_q, select_34_s3_q, select_31_s3_q, and_28_s3_q, select_25_s3_q, select_22_s3_q, exists_s3_q, grey_s3_q, vote_s3_q};
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
  logic [7:0] select_22_s4_q;
  logic [7:0] select_31_s4_q;
  logic [7:0] select_40_s4_q;
  logic [7:0] select_49_s4_q;
  logic [7:0] select_58_s4_q;
  logic [7:0] select_64_s4_q;
  logic [7:0] select_70_s4_q;
  logic [7:0] select_76_s4_q;
  logic [7:0] select_82_s4_q;
  logic select_88_s4_q;
  logic [6:0] difference_s4_q;
  logic [6:0] difference_2_s4_q;
  logic [6:0] difference_3_s4_q;
  logic [7:0] select_112_s4_q;
  logic [6:0] difference_4_s4_q;
  logic [6:0] difference_5_s4_q;
  logic [6:0] difference_6_s4_q;
  logic [6:0] difference_7_s4_q;
  logic [6:0] difference_8_s4_q;
  logic [6:0] difference_9_s4_q;
  logic [6:0] difference_10_s4_q;
  logic and_168_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      vote_s4_q <= vote_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      select_22_s4_q <= select_22_s3_q;
      select_31_s4_q <= select_31_s3_q;
      select_40_s4_q <= select_40_s3_q;
      select_49_s4_q <= select_49_s3_q;
      select_58_s4_q <= select_58_s3_q;
      select_64_s4_q <= select_64_s3_q;
      select_70_s4_q <= select_70_s3_q;
      select_76_s4_q <= select_76_s3_q;
      select_82_s4_q <= select_82_s3_q;
      select_88_s4_q <= select_88_s3_q[4];
      difference_s4_q <= difference;
      difference_2_s4_q <= difference_2;
      difference_3_s4_q <= difference_3;
      select_112_s4_q <= select_112_s3_q;
      difference_4_s4_q <= difference_4;
      difference_5_s4_q <= difference_5;
      difference_6_s4_q <= difference_6;
      difference_7_s4_q <= difference_7;
      difference_8_s4_q <= difference_8;
      difference_9_s4_q <= difference_9;
      difference_10_s4_q <= difference_10;
      and_168_s4_q <= and_168_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:47
  logic [7:0] select_102;
  assign select_102 = ({3'h0, cfg_similar_i} < difference_2_s4_q) ? 8'h0 : select_82_s4_q;
  logic [7:0] select_113;
  assign select_113 = ({3'h0, cfg_similar_i} < difference_3_s4_q) ? 8'h0 : select_112_s4_q;
  logic [7:0] select_120;
  assign select_120 = ({3'h0, cfg_similar_i} < difference_4_s4_q) ? 8'h0 : select_22_s4_q;
  logic [7:0] select_125;
  assign select_125 = ({3'h0, cfg_similar_i} < difference_5_s4_q) ? 8'h0 : select_31_s4_q;
  logic [7:0] select_131;
  assign select_131 = ({3'h0, cfg_similar_i} < difference_6_s4_q) ? 8'h0 : select_40_s4_q;
  logic [7:0] select_136;
  assign select_136 = ({3'h0, cfg_similar_i} < difference_7_s4_q) ? 8'h0 : select_49_s4_q;
  logic [7:0] select_143;
  assign select_143 = ({3'h0, cfg_similar_i} < difference_8_s4_q) ? 8'h0 : select_64_s4_q;
  // hls/stages/ballot.hpp:50
  logic [8:0] sum_144;
  assign sum_144 = {select_58_s4_q[7], select_58_s4_q} + {select_143[7], select_143};
  // hls/stages/ballot.hpp:47
  logic [7:0] select_149;
  assign select_149 = ({3'h0, cfg_similar_i} < difference_9_s4_q) ? 8'h0 : select_70_s4_q;
  logic [7:0] select_154;
  assign select_154 = ({3'h0, cfg_similar_i} < difference_10_s4_q) ? 8'h0 : select_76_s4_q;

  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic select_88_s5_q;
  logic [7:0] select_97_s5_q;
  logic [8:0] sum_114_s5_q;
  logic [8:0] sum_126_s5_q;
  logic [8:0] sum_137_s5_q;
  logic [8:0] sum_144_s5_q;
  logic [8:0] sum_155_s5_q;
  logic and_168_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      select_88_s5_q <= select_88_s4_q;
      select_97_s5_q <= ({3'h0, cfg_similar_i} < difference_s4_q) ? 8'h0 : vote_s4_q;
      sum_114_s5_q <= {select_102[7], select_102} + {select_113[7], select_113};
      sum_126_s5_q <= {select_120[7], select_120} + {select_125[7], select_125};
      sum_137_s5_q <= {select_131[7], select_131} + {select_136[7], select_136};
      sum_144_s5_q <= sum_144;
      sum_155_s5_q <= {select_149[7], select_149} + {select_154[7], select_154};
      and_168_s5_q <= and_168_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:50
  logic [9:0] sum_115;
  assign sum_115 = {{2{select_97_s5_q[7]}}, select_97_s5_q} + {sum_114_s5_q[8], sum_114_s5_q};
  logic [9:0] sum_138;
  assign sum_138 = {sum_126_s5_q[8], sum_126_s5_q} + {sum_137_s5_q[8], sum_137_s5_q};
  logic [9:0] sum_156;
  assign sum_156 = {sum_144_s5_q[8], sum_144_s5_q} + {sum_155_s5_q[8], sum_155_s5_q};

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic select_88_s6_q;
  logic [9:0] sum_115_s6_q;
  logic [10:0] sum_157_s6_q;
  logic and_168_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      select_88_s6_q <= select_88_s5_q;
      sum_115_s6_q <= sum_115;
      sum_157_s6_q <= {sum_138[9], sum_138} + {sum_156[9], sum_156};
      and_168_s6_q <= and_168_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:50
  logic [11:0] sum_158;
  assign sum_158 = {{2{sum_115_s6_q[9]}}, sum_115_s6_q} + {sum_157_s6_q[10], sum_157_s6_q};
  // hls/stages/ballot.hpp:61
  logic [12:0] difference_162;
  assign difference_162 = 13'h0 - {sum_158[11], sum_158};

  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic not_160_s7_q;
  logic and_161_s7_q;
  logic [9:0] difference_162_s7_q;
  logic and_168_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      not_160_s7_q <= ~($signed(sum_158) < $signed({4'h0, cfg_quorum_i}));
      and_161_s7_q <= select_88_s6_q & sum_158[11];
      difference_162_s7_q <= difference_162[12:3];
      and_168_s7_q <= and_168_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/ballot.hpp:61
  logic less_163;
  assign less_163 = $signed(difference_162_s7_q) < $signed({2'h0, cfg_clear_quorum_i});

  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic not_160_s8_q;
  logic or_165_s8_q;
  logic and_168_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      not_160_s8_q <= not_160_s7_q;
      or_165_s8_q <= and_161_s7_q | (~less_163);
      and_168_s8_q <= and_168_s7_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign skin_o = not_160_s8_q;
  assign clear_o = or_165_s8_q;
  assign exists_o = and_168_s8_q;
  assign marks_first_o = marks_first_s8_q;
  assign marks_last_o = marks_last_s8_q;
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
  assign unused_bits = ^difference_162[2:0];

endmodule
