// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Blind<horopter::hls::profiles::hd>, hls/stages/blind.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 92 bits, pipeline 340 bits, memories 131896 bits.
module horopter_blind (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic first_i,
  input  logic last_i,
  input  logic idle_i,
  input  logic [10:0] cfg_width_i,
  input  logic [10:0] cfg_height_i,
  input  logic cfg_watch_i,
  input  logic cfg_teach_i,
  input  logic cfg_forget_i,
  input  logic [7:0] cfg_blind_margin_i,
  output logic valid_o,
  output logic there_o,
  output logic [1:0] state_o,
  output logic blind_o,
  output logic first_o,
  output logic last_o,
  output logic done_o,
  output logic taught_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q;
  logic s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s8_en;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s8_en = en_i & valid_s8_q;

  // Of the configuration alone: not pipelined.
  logic not_86;
  assign not_86 = ~cfg_forget_i;
  logic not_87;
  assign not_87 = ~cfg_teach_i;
  logic [6:0] select_143;
  assign select_143 = (7'h78 < cfg_width_i[10:4]) ? 7'h77 : (cfg_width_i[10:4] + 7'h7f);

  // Stage 0 -----------------------------------------------------------------------------------------------------------

  logic [1:0] state_s1_q;
  logic first_s1_q;
  logic last_s1_q;
  logic idle_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      state_s1_q <= state_i;
      first_s1_q <= first_i;
      last_s1_q <= last_i;
      idle_s1_q <= idle_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [10:0] x_q;
  logic [10:0] before_v_q;
  logic [10:0] before_end_q;
  logic [6:0] last_block_q;
  logic [4:0] rows_left_q;
  logic more_q;
  logic row_ended_q;
  logic at_end_q;
  // hls/stages/blind.hpp:65
  logic not_33;
  assign not_33 = ~idle_s1_q;
  logic and_34;
  assign and_34 = first_s1_q & not_33;
  // hls/stages/blind.hpp:67
  logic [10:0] x;
  assign x = (row_ended_q | and_34) ? 11'h0 : x_q;
  // hls/stages/blind.hpp:65
  logic and_37;
  assign and_37 = idle_s1_q & more_q;
  // hls/stages/blind.hpp:78
  logic or_38;
  assign or_38 = not_33 | and_37;
  // hls/stages/blind.hpp:66
  logic last;
  assign last = idle_s1_q ? at_end_q : last_s1_q;
  // hls/stages/blind.hpp:88
  logic [10:0] select_130;
  assign select_130 = (not_33 & last) ? before_v_q : before_end_q;
  // hls/stages/blind.hpp:82
  logic [6:0] select_145;
  assign select_145 = and_34 ? ((cfg_width_i[10:5] == 6'h0) ? 7'h1 : select_143) : last_block_q;
  // hls/stages/blind.hpp:93
  logic or_157;
  assign or_157 = and_34 | (and_37 & last);

  // Memory states, 1920 x 34, DISTANCE 16, hls/stages/blind.hpp:200; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [33:0] states_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) states_mem[i] = 34'h0;
`endif
  logic [10:0] states_raddr;
  assign states_raddr = x;
`ifndef SYNTHESIS
  logic states_re;
  assign states_re = s1_en & or_38;
`endif
  logic [33:0] states_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) states_rdata_q <= states_mem[states_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= 11'h0;
      before_v_q <= 11'h0;
      before_end_q <= 11'h77e;
      last_block_q <= 7'h0;
      rows_left_q <= 5'h0;
      more_q <= 1'b0;
      row_ended_q <= 1'b1;
      at_end_q <= 1'b0;
    end else if (s1_en) begin
      x_q <= x + 11'h1;
      before_v_q <= x;
      before_end_q <= select_130;
      last_block_q <= select_145;
      rows_left_q <= or_157 ? (and_34 ? 5'h11 : (rows_left_q + 5'h1f)) : rows_left_q;
      more_q <= or_157 ? (and_34 | (~(rows_left_q == 5'h1))) : more_q;
      row_ended_q <= last;
      at_end_q <= (~(x < select_130)) & (~last);
    end
  end

  logic [1:0] state_s2_q;
  logic last_s2_q;
  logic idle_s2_q;
  logic [6:0] last_block_s2_q;
  logic not_33_s2_q;
  logic and_34_s2_q;
  logic or_38_s2_q;
  logic less_40_s2_q;
  logic and_187_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      state_s2_q <= state_s1_q;
      last_s2_q <= last_s1_q;
      idle_s2_q <= idle_s1_q;
      last_block_s2_q <= last_block_q;
      not_33_s2_q <= not_33;
      and_34_s2_q <= and_34;
      or_38_s2_q <= or_38;
      less_40_s2_q <= last_block_q < x[10:4];
      and_187_s2_q <= idle_s1_q & (~more_q);
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [10:0] rows_expected_q;
  logic last_row_q;
  logic [3:0] inner_row_q;
  logic [9:0] place_q;
  // hls/stages/blind.hpp:77
  logic [6:0] block;
  assign block = less_40_s2_q ? last_block_s2_q : before_v_q[10:4];
  // hls/stages/blind.hpp:169
  logic ends;
  assign ends = last_s2_q | ((~(last_block_s2_q == block)) & (before_v_q[3:0] == 4'hf));
  // hls/stages/blind.hpp:69
  logic [3:0] select_53;
  assign select_53 = and_34_s2_q ? 4'h0 : inner_row_q;
  logic [9:0] select_57;
  assign select_57 = and_34_s2_q ? 10'h0 : place_q;
  // hls/stages/blind.hpp:65
  logic not_59;
  assign not_59 = ~and_34_s2_q;
  // hls/stages/blind.hpp:69
  logic and_60;
  assign and_60 = last_row_q & not_59;
  // hls/stages/blind.hpp:176
  logic equal_61;
  assign equal_61 = select_53 == 4'hf;
  // hls/stages/blind.hpp:83
  logic and_131;
  assign and_131 = row_ended_q & or_38_s2_q;
  // hls/stages/blind.hpp:82
  logic [10:0] fewer;
  assign fewer = rows_expected_q + 11'h7ff;
  // hls/stages/blind.hpp:87
  logic [10:0] select_135;
  assign select_135 = (and_34_s2_q | and_131) ? (and_34_s2_q ? cfg_height_i : fewer) : rows_expected_q;
  // hls/stages/blind.hpp:86
  logic [9:0] select_150;
  assign select_150 = and_131 ? (equal_61 ? (select_57 + 10'hf) : select_57) : select_57;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      rows_expected_q <= 11'h0;
      last_row_q <= 1'b0;
      inner_row_q <= 4'h0;
      place_q <= 10'h0;
    end else if (s2_en) begin
      rows_expected_q <= select_135;
      last_row_q <= and_131 ? (rows_expected_q == 11'h2) : and_60;
      inner_row_q <= and_131 ? (select_53 + 4'h1) : select_53;
      place_q <= select_150;
    end
  end

  logic [1:0] state_s3_q;
  logic idle_s3_q;
  logic not_33_s3_q;
  logic and_34_s3_q;
  logic [10:0] x_s3_q;
  logic or_38_s3_q;
  logic [33:0] states_rdata_s3_q;
  logic [6:0] block_s3_q;
  logic ends_s3_q;
  logic equal_54_s3_q;
  logic [9:0] sum_58_s3_q;
  logic not_59_s3_q;
  logic and_60_s3_q;
  logic equal_61_s3_q;
  logic last_s3_q;
  logic and_131_s3_q;
  logic and_187_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      state_s3_q <= state_s2_q;
      idle_s3_q <= idle_s2_q;
      not_33_s3_q <= not_33_s2_q;
      and_34_s3_q <= and_34_s2_q;
      x_s3_q <= before_v_q;
      or_38_s3_q <= or_38_s2_q;
      states_rdata_s3_q <= states_rdata_q;
      block_s3_q <= block;
      ends_s3_q <= ends;
      equal_54_s3_q <= select_53 == 4'h0;
      sum_58_s3_q <= select_57 + {6'h0, block[6:3]};
      not_59_s3_q <= not_59;
      and_60_s3_q <= and_60;
      equal_61_s3_q <= equal_61;
      last_s3_q <= row_ended_q;
      and_131_s3_q <= and_131;
      and_187_s3_q <= and_187_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic odd_q;
  logic new_block_q;
  logic [4:0] above_q;
  logic first_above_q;
  logic ended_q;
  logic teaches_q;
  logic session_q;
  // hls/stages/blind.hpp:173
  logic and_47;
  assign and_47 = not_33_s3_q & ends_s3_q;
  // hls/stages/blind.hpp:69
  logic or_49;
  assign or_49 = new_block_q | and_34_s3_q;
  // hls/stages/blind.hpp:80
  logic and_64;
  assign and_64 = not_33_s3_q & (ends_s3_q & (and_60_s3_q | equal_61_s3_q));
  // hls/stages/blind.hpp:69
  logic and_82;
  assign and_82 = ended_q & not_59_s3_q;
  logic and_84;
  assign and_84 = idle_s3_q & (~and_82);
  logic select_85;
  assign select_85 = and_34_s3_q ? cfg_teach_i : teaches_q;
  // hls/stages/blind.hpp:80
  logic and_102;
  assign and_102 = ends_s3_q & (equal_61_s3_q ? select_85 : (and_60_s3_q & select_85));
  // hls/stages/blind.hpp:69
  logic and_115;
  assign and_115 = odd_q & not_59_s3_q;
  logic [4:0] select_118;
  assign select_118 = and_34_s3_q ? 5'h0 : above_q;
  // hls/stages/blind.hpp:162
  logic equal_119;
  assign equal_119 = select_118 == 5'h11;
  // hls/stages/blind.hpp:86
  logic [4:0] select_155;
  assign select_155 = and_131_s3_q ? (equal_119 ? select_118 : (select_118 + 5'h1)) : select_118;
  // hls/stages/blind.hpp:69
  logic and_170;
  assign and_170 = first_above_q & not_59_s3_q;
  logic select_175;
  assign select_175 = and_34_s3_q ? (session_q & (cfg_teach_i & not_86)) : session_q;

  // Memory counts, 120 x 9, DISTANCE 16, hls/stages/blind.hpp:201; read in stage 3, written in stage 6: 3 < 6 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] counts_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) counts_mem[i] = 9'h0;
`endif
  logic [6:0] counts_raddr;
  assign counts_raddr = block_s3_q;
`ifndef SYNTHESIS
  logic counts_re;
  assign counts_re = s3_en & and_47;
`endif
  logic [8:0] counts_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) counts_rdata_q <= counts_mem[counts_raddr];
  end

  // Memory taught_low, 8160 x 2, DISTANCE 16, hls/include/horopter/hls/sliced_memory.hpp:33; read in stage 3, written in stage 8: 3 < 8 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] taught_low_mem [0:8159];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8160; i++) taught_low_mem[i] = 2'h0;
`endif
  logic [12:0] taught_low_raddr;
  assign taught_low_raddr = {sum_58_s3_q, block_s3_q[2:0]};
`ifndef SYNTHESIS
  logic taught_low_re;
  assign taught_low_re = s3_en & and_64;
`endif
  logic [1:0] taught_low_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) taught_low_rdata_q <= taught_low_mem[taught_low_raddr];
  end

  // Memory taught_high_low, 8160 x 2, DISTANCE 16, hls/include/horopter/hls/sliced_memory.hpp:33; read in stage 3, written in stage 8: 3 < 8 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] taught_high_low_mem [0:8159];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8160; i++) taught_high_low_mem[i] = 2'h0;
`endif
  logic [12:0] taught_high_low_raddr;
  assign taught_high_low_raddr = {sum_58_s3_q, block_s3_q[2:0]};
`ifndef SYNTHESIS
  logic taught_high_low_re;
  assign taught_high_low_re = s3_en & and_64;
`endif
  logic [1:0] taught_high_low_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) taught_high_low_rdata_q <= taught_high_low_mem[taught_high_low_raddr];
  end

  // Memory taught_high_high_low, 8160 x 2, DISTANCE 16, hls/include/horopter/hls/sliced_memory.hpp:33; read in stage 3, written in stage 8: 3 < 8 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] taught_high_high_low_mem [0:8159];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8160; i++) taught_high_high_low_mem[i] = 2'h0;
`endif
  logic [12:0] taught_high_high_low_raddr;
  assign taught_high_high_low_raddr = {sum_58_s3_q, block_s3_q[2:0]};
`ifndef SYNTHESIS
  logic taught_high_high_low_re;
  assign taught_high_high_low_re = s3_en & and_64;
`endif
  logic [1:0] taught_high_high_low_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) taught_high_high_low_rdata_q <= taught_high_high_low_mem[taught_high_high_low_raddr];
  end

  // Memory taught_high_high_high, 8160 x 2, DISTANCE 16, hls/include/horopter/hls/sliced_memory.hpp:34; read in stage 3, written in stage 8: 3 < 8 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] taught_high_high_high_mem [0:8159];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8160; i++) taught_high_high_high_mem[i] = 2'h0;
`endif
  logic [12:0] taught_high_high_high_raddr;
  assign taught_high_high_high_raddr = {sum_58_s3_q, block_s3_q[2:0]};
`ifndef SYNTHESIS
  logic taught_high_high_high_re;
  assign taught_high_high_high_re = s3_en & and_64;
`endif
  logic [1:0] taught_high_high_high_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) taught_high_high_high_rdata_q <= taught_high_high_high_mem[taught_high_high_high_raddr];
  end

  // Memory states, write
  logic [10:0] states_waddr;
  assign states_waddr = x_s3_q;
  logic states_we;
  assign states_we = s3_en & or_38_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (states_we) states_mem[states_waddr] <= {states_rdata_s3_q[31:0], state_s3_q};
  end
`ifndef SYNTHESIS
  logic [10:0] states_raddr_s2_sim;
  logic states_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      states_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      states_re_s2_sim <= states_re;
      states_raddr_s2_sim <= states_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && states_we) begin
      if (states_re && states_raddr == states_waddr) begin
        $error("states: address %0d is read less than DISTANCE steps after its write", states_waddr);
      end
      if (states_re_s2_sim && states_raddr_s2_sim == states_waddr) begin
        $error("states: address %0d is read less than DISTANCE steps after its write", states_waddr);
      end
      if (states_waddr >= 11'd1920) $error("states: write outside, address %0d", states_waddr);
    end
    if (rst_ni && states_re && states_raddr >= 11'd1920) $error("states: read outside, address %0d", states_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      odd_q <= 1'b0;
      new_block_q <= 1'b1;
      above_q <= 5'h0;
      first_above_q <= 1'b0;
      ended_q <= 1'b1;
      teaches_q <= 1'b0;
      session_q <= 1'b0;
    end else if (s3_en) begin
      odd_q <= and_131_s3_q ? (and_115 ^ equal_61_s3_q) : and_115;
      new_block_q <= idle_s3_q ? or_49 : ends_s3_q;
      above_q <= select_155;
      first_above_q <= and_131_s3_q ? (select_118 == 5'h10) : and_170;
      ended_q <= and_82 | and_84;
      teaches_q <= select_85;
      session_q <= and_84 ? (select_85 | select_175) : select_175;
    end
  end

  logic idle_s4_q;
  logic and_34_s4_q;
  logic or_38_s4_q;
  logic [1:0] states_rdata_s4_q;
  logic [6:0] block_s4_q;
  logic and_47_s4_q;
  logic or_49_s4_q;
  logic equal_51_s4_q;
  logic equal_54_s4_q;
  logic [9:0] sum_58_s4_q;
  logic and_64_s4_q;
  logic and_84_s4_q;
  logic and_89_s4_q;
  logic and_103_s4_q;
  logic and_115_s4_q;
  logic not_117_s4_q;
  logic equal_119_s4_q;
  logic and_120_s4_q;
  logic last_s4_q;
  logic and_185_s4_q;
  logic and_187_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      idle_s4_q <= idle_s3_q;
      and_34_s4_q <= and_34_s3_q;
      or_38_s4_q <= or_38_s3_q;
      states_rdata_s4_q <= states_rdata_s3_q[33:32];
      block_s4_q <= block_s3_q;
      and_47_s4_q <= and_47;
      or_49_s4_q <= or_49;
      equal_51_s4_q <= state_s3_q == 2'h2;
      equal_54_s4_q <= equal_54_s3_q;
      sum_58_s4_q <= sum_58_s3_q;
      and_64_s4_q <= and_64;
      and_84_s4_q <= and_84;
      and_89_s4_q <= not_86 & (session_q | not_87);
      and_103_s4_q <= not_33_s3_q & and_102;
      and_115_s4_q <= and_115;
      not_117_s4_q <= ~(and_115 ^ equal_54_s3_q);
      equal_119_s4_q <= equal_119;
      and_120_s4_q <= or_38_s3_q & equal_119;
      last_s4_q <= last_s3_q;
      and_185_s4_q <= or_38_s3_q & (and_170 & (x_s3_q == 11'h0));
      and_187_s4_q <= and_187_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic watches_q;
  logic has_taught_q;
  // hls/stages/blind.hpp:69
  logic select_91;
  assign select_91 = and_34_s4_q ? (has_taught_q & and_89_s4_q) : has_taught_q;

  // Memory blind, 256 x 1, DISTANCE 16, hls/stages/blind.hpp:203; read in stage 4, written in stage 8: 4 < 8 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic blind_mem [0:255];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 256; i++) blind_mem[i] = 1'b0;
`endif
  logic [7:0] blind_raddr;
  assign blind_raddr = {block_s4_q, not_117_s4_q};
`ifndef SYNTHESIS
  logic blind_re;
  assign blind_re = s4_en & and_120_s4_q;
`endif
  logic blind_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) blind_rdata_q <= blind_mem[blind_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      watches_q <= 1'b0;
      has_taught_q <= 1'b0;
    end else if (s4_en) begin
      watches_q <= and_34_s4_q ? (cfg_watch_i & not_87) : watches_q;
      has_taught_q <= and_84_s4_q ? (teaches_q | select_91) : select_91;
    end
  end

  logic idle_s5_q;
  logic or_38_s5_q;
  logic [1:0] states_rdata_s5_q;
  logic [6:0] block_s5_q;
  logic and_47_s5_q;
  logic [8:0] counts_rdata_s5_q;
  logic or_49_s5_q;
  logic equal_51_s5_q;
  logic equal_54_s5_q;
  logic [9:0] sum_58_s5_q;
  logic and_64_s5_q;
  logic [1:0] taught_low_rdata_s5_q;
  logic [1:0] taught_high_high_high_rdata_s5_q;
  logic [1:0] taught_high_high_low_rdata_s5_q;
  logic [1:0] taught_high_low_rdata_s5_q;
  logic and_103_s5_q;
  logic and_115_s5_q;
  logic equal_119_s5_q;
  logic and_120_s5_q;
  logic last_s5_q;
  logic and_185_s5_q;
  logic and_187_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      idle_s5_q <= idle_s4_q;
      or_38_s5_q <= or_38_s4_q;
      states_rdata_s5_q <= states_rdata_s4_q;
      block_s5_q <= block_s4_q;
      and_47_s5_q <= and_47_s4_q;
      counts_rdata_s5_q <= counts_rdata_q;
      or_49_s5_q <= or_49_s4_q;
      equal_51_s5_q <= equal_51_s4_q;
      equal_54_s5_q <= equal_54_s4_q;
      sum_58_s5_q <= sum_58_s4_q;
      and_64_s5_q <= and_64_s4_q;
      taught_low_rdata_s5_q <= taught_low_rdata_q;
      taught_high_high_high_rdata_s5_q <= taught_high_high_high_rdata_q;
      taught_high_high_low_rdata_s5_q <= taught_high_high_low_rdata_q;
      taught_high_low_rdata_s5_q <= taught_high_low_rdata_q;
      and_103_s5_q <= and_103_s4_q;
      and_115_s5_q <= and_115_s4_q;
      equal_119_s5_q <= equal_119_s4_q;
      and_120_s5_q <= and_120_s4_q;
      last_s5_q <= last_s4_q;
      and_185_s5_q <= and_185_s4_q;
      and_187_s5_q <= and_187_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [4:0] in_row_q;
  // hls/stages/blind.hpp:170
  logic [4:0] sum_52;
  assign sum_52 = (or_49_s5_q ? 5'h0 : in_row_q) + {4'h0, equal_51_s5_q};
  // hls/stages/blind.hpp:131
  logic parity_81;
  assign parity_81 = ^{taught_high_low_rdata_s5_q, taught_high_high_low_rdata_s5_q, taught_high_high_high_rdata_s5_q, taught_low_rdata_s5_q};
  // hls/stages/blind.hpp:181
  logic [6:0] known;
  assign known = (parity_81 | (~has_taught_q)) ? 7'h0 : {taught_high_high_high_rdata_s5_q[0], taught_high_high_low_rdata_s5_q, taught_high_low_rdata_s5_q, taught_low_rdata_s5_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      in_row_q <= 5'h0;
    end else if (s5_en) begin
      in_row_q <= idle_s5_q ? in_row_q : sum_52;
    end
  end

  logic or_38_s6_q;
  logic [1:0] states_rdata_s6_q;
  logic [6:0] block_s6_q;
  logic and_47_s6_q;
  logic [8:0] sum_56_s6_q;
  logic [9:0] sum_58_s6_q;
  logic and_64_s6_q;
  logic select_93_s6_q;
  logic [6:0] known_s6_q;
  logic and_103_s6_q;
  logic and_115_s6_q;
  logic equal_119_s6_q;
  logic and_120_s6_q;
  logic blind_rdata_s6_q;
  logic select_123_s6_q;
  logic last_s6_q;
  logic and_185_s6_q;
  logic and_187_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      or_38_s6_q <= or_38_s5_q;
      states_rdata_s6_q <= states_rdata_s5_q;
      block_s6_q <= block_s5_q;
      and_47_s6_q <= and_47_s5_q;
      sum_56_s6_q <= {4'h0, sum_52} + (equal_54_s5_q ? 9'h0 : counts_rdata_s5_q);
      sum_58_s6_q <= sum_58_s5_q;
      and_64_s6_q <= and_64_s5_q;
      select_93_s6_q <= has_taught_q;
      known_s6_q <= known;
      and_103_s6_q <= and_103_s5_q;
      and_115_s6_q <= and_115_s5_q;
      equal_119_s6_q <= equal_119_s5_q;
      and_120_s6_q <= and_120_s5_q;
      blind_rdata_s6_q <= blind_rdata_q;
      select_123_s6_q <= watches_q;
      last_s6_q <= last_s5_q;
      and_185_s6_q <= and_185_s5_q;
      and_187_s6_q <= and_187_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/blind.hpp:165
  logic and_181;
  assign and_181 = equal_119_s6_q & (blind_rdata_s6_q & (states_rdata_s6_q == 2'h2));

  // Memory counts, write
  logic [6:0] counts_waddr;
  assign counts_waddr = block_s6_q;
  logic counts_we;
  assign counts_we = s6_en & and_47_s6_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (counts_we) counts_mem[counts_waddr] <= sum_56_s6_q;
  end
`ifndef SYNTHESIS
  logic [6:0] counts_raddr_s4_sim;
  logic counts_re_s4_sim;
  logic [6:0] counts_raddr_s5_sim;
  logic counts_re_s5_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_re_s4_sim <= 1'b0;
      counts_re_s5_sim <= 1'b0;
    end else if (en_i) begin
      counts_re_s4_sim <= counts_re;
      counts_raddr_s4_sim <= counts_raddr;
      counts_re_s5_sim <= counts_re_s4_sim;
      counts_raddr_s5_sim <= counts_raddr_s4_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && counts_we) begin
      if (counts_re && counts_raddr == counts_waddr) begin
        $error("counts: address %0d is read less than DISTANCE steps after its write", counts_waddr);
      end
      if (counts_re_s4_sim && counts_raddr_s4_sim == counts_waddr) begin
        $error("counts: address %0d is read less than DISTANCE steps after its write", counts_waddr);
      end
      if (counts_re_s5_sim && counts_raddr_s5_sim == counts_waddr) begin
        $error("counts: address %0d is read less than DISTANCE steps after its write", counts_waddr);
      end
      if (counts_waddr >= 7'd120) $error("counts: write outside, address %0d", counts_waddr);
    end
    if (rst_ni && counts_re && counts_raddr >= 7'd120) $error("counts: read outside, address %0d", counts_raddr);
  end
`endif

  logic [6:0] block_s7_q;
  logic [8:0] sum_56_s7_q;
  logic [9:0] sum_58_s7_q;
  logic and_64_s7_q;
  logic select_93_s7_q;
  logic [6:0] known_s7_q;
  logic less_97_s7_q;
  logic and_103_s7_q;
  logic and_115_s7_q;
  logic and_120_s7_q;
  logic select_123_s7_q;
  logic [8:0] sum_124_s7_q;
  logic last_s7_q;
  logic [1:0] select_178_s7_q;
  logic and_182_s7_q;
  logic and_185_s7_q;
  logic and_187_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      block_s7_q <= block_s6_q;
      sum_56_s7_q <= sum_56_s6_q;
      sum_58_s7_q <= sum_58_s6_q;
      and_64_s7_q <= and_64_s6_q;
      select_93_s7_q <= select_93_s6_q;
      known_s7_q <= known_s6_q;
      less_97_s7_q <= {known_s6_q, 2'h0} < sum_56_s6_q;
      and_103_s7_q <= and_103_s6_q;
      and_115_s7_q <= and_115_s6_q;
      and_120_s7_q <= and_120_s6_q;
      select_123_s7_q <= select_123_s6_q;
      sum_124_s7_q <= {1'b0, cfg_blind_margin_i} + {2'h0, known_s6_q};
      last_s7_q <= last_s6_q;
      select_178_s7_q <= or_38_s6_q ? states_rdata_s6_q : 2'h0;
      and_182_s7_q <= or_38_s6_q & and_181;
      and_185_s7_q <= and_185_s6_q;
      and_187_s7_q <= and_187_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/blind.hpp:182
  logic [8:0] sum_99;
  assign sum_99 = (less_97_s7_q ? sum_56_s7_q : {known_s7_q, 2'h0}) + 9'h3;

  logic [6:0] block_s8_q;
  logic [9:0] sum_58_s8_q;
  logic and_64_s8_q;
  logic select_93_s8_q;
  logic [6:0] sum_99_s8_q;
  logic and_103_s8_q;
  logic and_115_s8_q;
  logic and_120_s8_q;
  logic and_126_s8_q;
  logic last_s8_q;
  logic [1:0] select_178_s8_q;
  logic and_182_s8_q;
  logic and_185_s8_q;
  logic and_187_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      block_s8_q <= block_s7_q;
      sum_58_s8_q <= sum_58_s7_q;
      and_64_s8_q <= and_64_s7_q;
      select_93_s8_q <= select_93_s7_q;
      sum_99_s8_q <= sum_99[8:2];
      and_103_s8_q <= and_103_s7_q;
      and_115_s8_q <= and_115_s7_q;
      and_120_s8_q <= and_120_s7_q;
      and_126_s8_q <= select_123_s7_q & ({sum_124_s7_q, 2'h0} < {2'h0, sum_56_s7_q});
      last_s8_q <= last_s7_q;
      select_178_s8_q <= select_178_s7_q;
      and_182_s8_q <= and_182_s7_q;
      and_185_s8_q <= and_185_s7_q;
      and_187_s8_q <= and_187_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/blind.hpp:131
  logic parity_114;
  assign parity_114 = ^sum_99_s8_q;

  // Memory taught_low, write
  logic [12:0] taught_low_waddr;
  assign taught_low_waddr = {sum_58_s8_q, block_s8_q[2:0]};
  logic taught_low_we;
  assign taught_low_we = s8_en & and_103_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (taught_low_we) taught_low_mem[taught_low_waddr] <= sum_99_s8_q[1:0];
  end
`ifndef SYNTHESIS
  logic [12:0] taught_low_raddr_s4_sim;
  logic taught_low_re_s4_sim;
  logic [12:0] taught_low_raddr_s5_sim;
  logic taught_low_re_s5_sim;
  logic [12:0] taught_low_raddr_s6_sim;
  logic taught_low_re_s6_sim;
  logic [12:0] taught_low_raddr_s7_sim;
  logic taught_low_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      taught_low_re_s4_sim <= 1'b0;
      taught_low_re_s5_sim <= 1'b0;
      taught_low_re_s6_sim <= 1'b0;
      taught_low_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      taught_low_re_s4_sim <= taught_low_re;
      taught_low_raddr_s4_sim <= taught_low_raddr;
      taught_low_re_s5_sim <= taught_low_re_s4_sim;
      taught_low_raddr_s5_sim <= taught_low_raddr_s4_sim;
      taught_low_re_s6_sim <= taught_low_re_s5_sim;
      taught_low_raddr_s6_sim <= taught_low_raddr_s5_sim;
      taught_low_re_s7_sim <= taught_low_re_s6_sim;
      taught_low_raddr_s7_sim <= taught_low_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && taught_low_we) begin
      if (taught_low_re && taught_low_raddr == taught_low_waddr) begin
        $error("taught_low: address %0d is read less than DISTANCE steps after its write", taught_low_waddr);
      end
      if (taught_low_re_s4_sim && taught_low_raddr_s4_sim == taught_low_waddr) begin
        $error("taught_low: address %0d is read less than DISTANCE steps after its write", taught_low_waddr);
      end
      if (taught_low_re_s5_sim && taught_low_raddr_s5_sim == taught_low_waddr) begin
        $error("taught_low: address %0d is read less than DISTANCE steps after its write", taught_low_waddr);
      end
      if (taught_low_re_s6_sim && taught_low_raddr_s6_sim == taught_low_waddr) begin
        $error("taught_low: address %0d is read less than DISTANCE steps after its write", taught_low_waddr);
      end
      if (taught_low_re_s7_sim && taught_low_raddr_s7_sim == taught_low_waddr) begin
        $error("taught_low: address %0d is read less than DISTANCE steps after its write", taught_low_waddr);
      end
      if (taught_low_waddr >= 13'd8160) $error("taught_low: write outside, address %0d", taught_low_waddr);
    end
    if (rst_ni && taught_low_re && taught_low_raddr >= 13'd8160) $error("taught_low: read outside, address %0d", taught_low_raddr);
  end
`endif

  // Memory taught_high_low, write
  logic [12:0] taught_high_low_waddr;
  assign taught_high_low_waddr = {sum_58_s8_q, block_s8_q[2:0]};
  logic taught_high_low_we;
  assign taught_high_low_we = s8_en & and_103_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (taught_high_low_we) taught_high_low_mem[taught_high_low_waddr] <= sum_99_s8_q[3:2];
  end
`ifndef SYNTHESIS
  logic [12:0] taught_high_low_raddr_s4_sim;
  logic taught_high_low_re_s4_sim;
  logic [12:0] taught_high_low_raddr_s5_sim;
  logic taught_high_low_re_s5_sim;
  logic [12:0] taught_high_low_raddr_s6_sim;
  logic taught_high_low_re_s6_sim;
  logic [12:0] taught_high_low_raddr_s7_sim;
  logic taught_high_low_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      taught_high_low_re_s4_sim <= 1'b0;
      taught_high_low_re_s5_sim <= 1'b0;
      taught_high_low_re_s6_sim <= 1'b0;
      taught_high_low_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      taught_high_low_re_s4_sim <= taught_high_low_re;
      taught_high_low_raddr_s4_sim <= taught_high_low_raddr;
      taught_high_low_re_s5_sim <= taught_high_low_re_s4_sim;
      taught_high_low_raddr_s5_sim <= taught_high_low_raddr_s4_sim;
      taught_high_low_re_s6_sim <= taught_high_low_re_s5_sim;
      taught_high_low_raddr_s6_sim <= taught_high_low_raddr_s5_sim;
      taught_high_low_re_s7_sim <= taught_high_low_re_s6_sim;
      taught_high_low_raddr_s7_sim <= taught_high_low_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && taught_high_low_we) begin
      if (taught_high_low_re && taught_high_low_raddr == taught_high_low_waddr) begin
        $error("taught_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_low_waddr);
      end
      if (taught_high_low_re_s4_sim && taught_high_low_raddr_s4_sim == taught_high_low_waddr) begin
        $error("taught_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_low_waddr);
      end
      if (taught_high_low_re_s5_sim && taught_high_low_raddr_s5_sim == taught_high_low_waddr) begin
        $error("taught_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_low_waddr);
      end
      if (taught_high_low_re_s6_sim && taught_high_low_raddr_s6_sim == taught_high_low_waddr) begin
        $error("taught_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_low_waddr);
      end
      if (taught_high_low_re_s7_sim && taught_high_low_raddr_s7_sim == taught_high_low_waddr) begin
        $error("taught_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_low_waddr);
      end
      if (taught_high_low_waddr >= 13'd8160) $error("taught_high_low: write outside, address %0d", taught_high_low_waddr);
    end
    if (rst_ni && taught_high_low_re && taught_high_low_raddr >= 13'd8160) $error("taught_high_low: read outside, address %0d", taught_high_low_raddr);
  end
`endif

  // Memory taught_high_high_low, write
  logic [12:0] taught_high_high_low_waddr;
  assign taught_high_high_low_waddr = {sum_58_s8_q, block_s8_q[2:0]};
  logic taught_high_high_low_we;
  assign taught_high_high_low_we = s8_en & and_103_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (taught_high_high_low_we) taught_high_high_low_mem[taught_high_high_low_waddr] <= sum_99_s8_q[5:4];
  end
`ifndef SYNTHESIS
  logic [12:0] taught_high_high_low_raddr_s4_sim;
  logic taught_high_high_low_re_s4_sim;
  logic [12:0] taught_high_high_low_raddr_s5_sim;
  logic taught_high_high_low_re_s5_sim;
  logic [12:0] taught_high_high_low_raddr_s6_sim;
  logic taught_high_high_low_re_s6_sim;
  logic [12:0] taught_high_high_low_raddr_s7_sim;
  logic taught_high_high_low_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      taught_high_high_low_re_s4_sim <= 1'b0;
      taught_high_high_low_re_s5_sim <= 1'b0;
      taught_high_high_low_re_s6_sim <= 1'b0;
      taught_high_high_low_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      taught_high_high_low_re_s4_sim <= taught_high_high_low_re;
      taught_high_high_low_raddr_s4_sim <= taught_high_high_low_raddr;
      taught_high_high_low_re_s5_sim <= taught_high_high_low_re_s4_sim;
      taught_high_high_low_raddr_s5_sim <= taught_high_high_low_raddr_s4_sim;
      taught_high_high_low_re_s6_sim <= taught_high_high_low_re_s5_sim;
      taught_high_high_low_raddr_s6_sim <= taught_high_high_low_raddr_s5_sim;
      taught_high_high_low_re_s7_sim <= taught_high_high_low_re_s6_sim;
      taught_high_high_low_raddr_s7_sim <= taught_high_high_low_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && taught_high_high_low_we) begin
      if (taught_high_high_low_re && taught_high_high_low_raddr == taught_high_high_low_waddr) begin
        $error("taught_high_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_high_low_waddr);
      end
      if (taught_high_high_low_re_s4_sim && taught_high_high_low_raddr_s4_sim == taught_high_high_low_waddr) begin
        $error("taught_high_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_high_low_waddr);
      end
      if (taught_high_high_low_re_s5_sim && taught_high_high_low_raddr_s5_sim == taught_high_high_low_waddr) begin
        $error("taught_high_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_high_low_waddr);
      end
      if (taught_high_high_low_re_s6_sim && taught_high_high_low_raddr_s6_sim == taught_high_high_low_waddr) begin
        $error("taught_high_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_high_low_waddr);
      end
      if (taught_high_high_low_re_s7_sim && taught_high_high_low_raddr_s7_sim == taught_high_high_low_waddr) begin
        $error("taught_high_high_low: address %0d is read less than DISTANCE steps after its write", taught_high_high_low_waddr);
      end
      if (taught_high_high_low_waddr >= 13'd8160) $error("taught_high_high_low: write outside, address %0d", taught_high_high_low_waddr);
    end
    if (rst_ni && taught_high_high_low_re && taught_high_high_low_raddr >= 13'd8160) $error("taught_high_high_low: read outside, address %0d", taught_high_high_low_raddr);
  end
`endif

  // Memory taught_high_high_high, write
  logic [12:0] taught_high_high_high_waddr;
  assign taught_high_high_high_waddr = {sum_58_s8_q, block_s8_q[2:0]};
  logic taught_high_high_high_we;
  assign taught_high_high_high_we = s8_en & and_103_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (taught_high_high_high_we) taught_high_high_high_mem[taught_high_high_high_waddr] <= {parity_114, sum_99_s8_q[6]};
  end
`ifndef SYNTHESIS
  logic [12:0] taught_high_high_high_raddr_s4_sim;
  logic taught_high_high_high_re_s4_sim;
  logic [12:0] taught_high_high_high_raddr_s5_sim;
  logic taught_high_high_high_re_s5_sim;
  logic [12:0] taught_high_high_high_raddr_s6_sim;
  logic taught_high_high_high_re_s6_sim;
  logic [12:0] taught_high_high_high_raddr_s7_sim;
  logic taught_high_high_high_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      taught_high_high_high_re_s4_sim <= 1'b0;
      taught_high_high_high_re_s5_sim <= 1'b0;
      taught_high_high_high_re_s6_sim <= 1'b0;
      taught_high_high_high_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      taught_high_high_high_re_s4_sim <= taught_high_high_high_re;
      taught_high_high_high_raddr_s4_sim <= taught_high_high_high_raddr;
      taught_high_high_high_re_s5_sim <= taught_high_high_high_re_s4_sim;
      taught_high_high_high_raddr_s5_sim <= taught_high_high_high_raddr_s4_sim;
      taught_high_high_high_re_s6_sim <= taught_high_high_high_re_s5_sim;
      taught_high_high_high_raddr_s6_sim <= taught_high_high_high_raddr_s5_sim;
      taught_high_high_high_re_s7_sim <= taught_high_high_high_re_s6_sim;
      taught_high_high_high_raddr_s7_sim <= taught_high_high_high_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && taught_high_high_high_we) begin
      if (taught_high_high_high_re && taught_high_high_high_raddr == taught_high_high_high_waddr) begin
        $error("taught_high_high_high: address %0d is read less than DISTANCE steps after its write", taught_high_high_high_waddr);
      end
      if (taught_high_high_high_re_s4_sim && taught_high_high_high_raddr_s4_sim == taught_high_high_high_waddr) begin
        $error("taught_high_high_high: address %0d is read less than DISTANCE steps after its write", taught_high_high_high_waddr);
      end
      if (taught_high_high_high_re_s5_sim && taught_high_high_high_raddr_s5_sim == taught_high_high_high_waddr) begin
        $error("taught_high_high_high: address %0d is read less than DISTANCE steps after its write", taught_high_high_high_waddr);
      end
      if (taught_high_high_high_re_s6_sim && taught_high_high_high_raddr_s6_sim == taught_high_high_high_waddr) begin
        $error("taught_high_high_high: address %0d is read less than DISTANCE steps after its write", taught_high_high_high_waddr);
      end
      if (taught_high_high_high_re_s7_sim && taught_high_high_high_raddr_s7_sim == taught_high_high_high_waddr) begin
        $error("taught_high_high_high: address %0d is read less than DISTANCE steps after its write", taught_high_high_high_waddr);
      end
      if (taught_high_high_high_waddr >= 13'd8160) $error("taught_high_high_high: write outside, address %0d", taught_high_high_high_waddr);
    end
    if (rst_ni && taught_high_high_high_re && taught_high_high_high_raddr >= 13'd8160) $error("taught_high_high_high: read outside, address %0d", taught_high_high_high_raddr);
  end
`endif

  // Memory blind, write
  logic [7:0] blind_waddr;
  assign blind_waddr = {block_s8_q, and_115_s8_q};
  logic blind_we;
  assign blind_we = s8_en & and_64_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (blind_we) blind_mem[blind_waddr] <= and_126_s8_q;
  end
`ifndef SYNTHESIS
  logic [7:0] blind_raddr_s5_sim;
  logic blind_re_s5_sim;
  logic [7:0] blind_raddr_s6_sim;
  logic blind_re_s6_sim;
  logic [7:0] blind_raddr_s7_sim;
  logic blind_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      blind_re_s5_sim <= 1'b0;
      blind_re_s6_sim <= 1'b0;
      blind_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      blind_re_s5_sim <= blind_re;
      blind_raddr_s5_sim <= blind_raddr;
      blind_re_s6_sim <= blind_re_s5_sim;
      blind_raddr_s6_sim <= blind_raddr_s5_sim;
      blind_re_s7_sim <= blind_re_s6_sim;
      blind_raddr_s7_sim <= blind_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && blind_we) begin
      if (blind_re && blind_raddr == blind_waddr) begin
        $error("blind: address %0d is read less than DISTANCE steps after its write", blind_waddr);
      end
      if (blind_re_s5_sim && blind_raddr_s5_sim == blind_waddr) begin
        $error("blind: address %0d is read less than DISTANCE steps after its write", blind_waddr);
      end
      if (blind_re_s6_sim && blind_raddr_s6_sim == blind_waddr) begin
        $error("blind: address %0d is read less than DISTANCE steps after its write", blind_waddr);
      end
      if (blind_re_s7_sim && blind_raddr_s7_sim == blind_waddr) begin
        $error("blind: address %0d is read less than DISTANCE steps after its write", blind_waddr);
      end
    end
  end
`endif

  logic select_93_s9_q;
  logic and_120_s9_q;
  logic last_s9_q;
  logic [1:0] select_178_s9_q;
  logic and_182_s9_q;
  logic and_185_s9_q;
  logic and_187_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      select_93_s9_q <= select_93_s8_q;
      and_120_s9_q <= and_120_s8_q;
      last_s9_q <= last_s8_q;
      select_178_s9_q <= select_178_s8_q;
      and_182_s9_q <= and_182_s8_q;
      and_185_s9_q <= and_185_s8_q;
      and_187_s9_q <= and_187_s8_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign there_o = and_120_s9_q;
  assign state_o = select_178_s9_q;
  assign blind_o = and_182_s9_q;
  assign first_o = and_185_s9_q;
  assign last_o = last_s9_q;
  assign done_o = and_187_s9_q;
  assign taught_o = select_93_s9_q;
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

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_99[1:0], cfg_width_i[3:0]};

endmodule
