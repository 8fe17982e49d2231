// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Blind<horopter::hls::profiles::hd>, hls/stages/blind.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 91 bits, pipeline 321 bits, memories 140056 bits.
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
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;

  // Of the configuration alone: not pipelined.
  logic [6:0] select_41;
  assign select_41 = (7'h78 < cfg_width_i[10:4]) ? 7'h77 : (cfg_width_i[10:4] + 7'h7f);
  logic [6:0] last_block;
  assign last_block = (cfg_width_i[10:5] == 6'h0) ? 7'h1 : select_41;
  logic not_90;
  assign not_90 = ~cfg_teach_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------

  logic [1:0] state_s1_q;
  logic first_s1_q;
  logic last_s1_q;
  logic idle_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
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
  logic [10:0] row_q;
  logic [6:0] last_block_q;
  logic [4:0] rows_left_q;
  logic more_q;
  logic row_ended_q;
  logic at_end_q;
  // hls/stages/blind.hpp:62
  logic not_31;
  assign not_31 = ~idle_s1_q;
  logic and_32;
  assign and_32 = first_s1_q & not_31;
  // hls/stages/blind.hpp:64
  logic [10:0] x;
  assign x = (row_ended_q | and_32) ? 11'h0 : x_q;
  // hls/stages/blind.hpp:62
  logic and_35;
  assign and_35 = idle_s1_q & more_q;
  // hls/stages/blind.hpp:76
  logic or_36;
  assign or_36 = not_31 | and_35;
  // hls/stages/blind.hpp:73
  logic [6:0] last_block_2;
  assign last_block_2 = and_32 ? last_block : last_block_q;
  // hls/stages/blind.hpp:66
  logic [10:0] select_63;
  assign select_63 = and_32 ? 11'h0 : row_q;
  // hls/stages/blind.hpp:156
  logic [11:0] sum_64;
  assign sum_64 = {1'b0, select_63} + 12'h1;
  // hls/stages/blind.hpp:63
  logic last;
  assign last = idle_s1_q ? at_end_q : last_s1_q;
  // hls/stages/blind.hpp:81
  logic [10:0] select_133;
  assign select_133 = (not_31 & last) ? before_v_q : before_end_q;
  // hls/stages/blind.hpp:79
  logic and_134;
  assign and_134 = last & or_36;
  // hls/stages/blind.hpp:86
  logic or_149;
  assign or_149 = and_32 | (and_35 & last);

  // Memory states, 1920 x 34, DISTANCE 16, hls/stages/blind.hpp:178; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [33:0] states_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) states_mem[i] = 34'h0;
`endif
  logic [10:0] states_raddr;
  assign states_raddr = x;
  logic states_re;
  assign states_re = s1_en & or_36;
  logic [33:0] states_rdata_q;
  always_ff @(posedge clk_i) begin
    if (states_re) states_rdata_q <= states_mem[states_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= 11'h0;
      before_v_q <= 11'h0;
      before_end_q <= 11'h77e;
      row_q <= 11'h0;
      last_block_q <= 7'h0;
      rows_left_q <= 5'h0;
      more_q <= 1'b0;
      row_ended_q <= 1'b1;
      at_end_q <= 1'b0;
    end else if (s1_en) begin
      x_q <= x + 11'h1;
      before_v_q <= x;
      before_end_q <= select_133;
      row_q <= and_134 ? sum_64[10:0] : select_63;
      last_block_q <= last_block_2;
      rows_left_q <= or_149 ? (and_32 ? 5'h11 : (rows_left_q + 5'h1f)) : rows_left_q;
      more_q <= or_149 ? (and_32 | (~(rows_left_q == 5'h1))) : more_q;
      row_ended_q <= last;
      at_end_q <= (~(x < select_133)) & (~last);
    end
  end

  logic [1:0] state_s2_q;
  logic last_s2_q;
  logic idle_s2_q;
  logic not_31_s2_q;
  logic and_32_s2_q;
  logic or_36_s2_q;
  logic less_44_s2_q;
  logic [11:0] sum_64_s2_q;
  logic and_134_s2_q;
  logic and_178_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      state_s2_q <= state_s1_q;
      last_s2_q <= last_s1_q;
      idle_s2_q <= idle_s1_q;
      not_31_s2_q <= not_31;
      and_32_s2_q <= and_32;
      or_36_s2_q <= or_36;
      less_44_s2_q <= last_block_2 < x[10:4];
      sum_64_s2_q <= sum_64;
      and_134_s2_q <= and_134;
      and_178_s2_q <= idle_s1_q & (~more_q);
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] inner_row_q;
  logic [9:0] place_q;
  // hls/stages/blind.hpp:75
  logic [6:0] block;
  assign block = less_44_s2_q ? last_block_q : before_v_q[10:4];
  // hls/stages/blind.hpp:149
  logic ends;
  assign ends = last_s2_q | ((before_v_q[10:4] < last_block_q) & (before_v_q[3:0] == 4'hf));
  // hls/stages/blind.hpp:66
  logic [3:0] select_56;
  assign select_56 = and_32_s2_q ? 4'h0 : inner_row_q;
  logic [9:0] select_60;
  assign select_60 = and_32_s2_q ? 10'h0 : place_q;
  // hls/stages/blind.hpp:156
  logic equal_62;
  assign equal_62 = select_56 == 4'hf;
  // hls/stages/blind.hpp:80
  logic [9:0] select_142;
  assign select_142 = and_134_s2_q ? (equal_62 ? (select_60 + 10'hf) : select_60) : select_60;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      inner_row_q <= 4'h0;
      place_q <= 10'h0;
    end else if (s2_en) begin
      inner_row_q <= and_134_s2_q ? (select_56 + 4'h1) : select_56;
      place_q <= select_142;
    end
  end

  logic [1:0] state_s3_q;
  logic idle_s3_q;
  logic not_31_s3_q;
  logic and_32_s3_q;
  logic [10:0] x_s3_q;
  logic or_36_s3_q;
  logic [33:0] states_rdata_s3_q;
  logic [6:0] block_s3_q;
  logic ends_s3_q;
  logic equal_57_s3_q;
  logic [9:0] sum_61_s3_q;
  logic equal_62_s3_q;
  logic equal_65_s3_q;
  logic last_s3_q;
  logic and_134_s3_q;
  logic and_178_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      state_s3_q <= state_s2_q;
      idle_s3_q <= idle_s2_q;
      not_31_s3_q <= not_31_s2_q;
      and_32_s3_q <= and_32_s2_q;
      x_s3_q <= before_v_q;
      or_36_s3_q <= or_36_s2_q;
      states_rdata_s3_q <= states_rdata_q;
      block_s3_q <= block;
      ends_s3_q <= ends;
      equal_57_s3_q <= select_56 == 4'h0;
      sum_61_s3_q <= select_60 + {6'h0, block[6:3]};
      equal_62_s3_q <= equal_62;
      equal_65_s3_q <= {sum_64_s2_q[11], cfg_height_i} == {1'b0, sum_64_s2_q[10:0]};
      last_s3_q <= row_ended_q;
      and_134_s3_q <= and_134_s2_q;
      and_178_s3_q <= and_178_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic new_block_q;
  logic teaches_q;
  // hls/stages/blind.hpp:153
  logic and_50;
  assign and_50 = not_31_s3_q & ends_s3_q;
  // hls/stages/blind.hpp:66
  logic or_52;
  assign or_52 = new_block_q | and_32_s3_q;
  // hls/stages/blind.hpp:79
  logic and_68;
  assign and_68 = not_31_s3_q & (ends_s3_q & (equal_62_s3_q | equal_65_s3_q));
  // hls/stages/blind.hpp:66
  logic select_89;
  assign select_89 = and_32_s3_q ? cfg_teach_i : teaches_q;
  // hls/stages/blind.hpp:79
  logic and_116;
  assign and_116 = ends_s3_q & (equal_62_s3_q ? select_89 : (select_89 & equal_65_s3_q));

  // Memory counts, 120 x 9, DISTANCE 16, hls/stages/blind.hpp:179; read in stage 3, written in stage 6: 3 < 6 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] counts_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) counts_mem[i] = 9'h0;
`endif
  logic [6:0] counts_raddr;
  assign counts_raddr = block_s3_q;
  logic counts_re;
  assign counts_re = s3_en & and_50;
  logic [8:0] counts_rdata_q;
  always_ff @(posedge clk_i) begin
    if (counts_re) counts_rdata_q <= counts_mem[counts_raddr];
  end

  // Memory taught, 8160 x 9, DISTANCE 16, hls/stages/blind.hpp:180; read in stage 3, written in stage 8: 3 < 8 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] taught_mem [0:8159];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8160; i++) taught_mem[i] = 9'h0;
`endif
  logic [12:0] taught_raddr;
  assign taught_raddr = {sum_61_s3_q, block_s3_q[2:0]};
  logic taught_re;
  assign taught_re = s3_en & and_68;
  logic [8:0] taught_rdata_q;
  always_ff @(posedge clk_i) begin
    if (taught_re) taught_rdata_q <= taught_mem[taught_raddr];
  end

  // Memory states, write
  logic [10:0] states_waddr;
  assign states_waddr = x_s3_q;
  logic states_we;
  assign states_we = s3_en & or_36_s3_q;
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
      new_block_q <= 1'b1;
      teaches_q <= 1'b0;
    end else if (s3_en) begin
      new_block_q <= idle_s3_q ? or_52 : ends_s3_q;
      teaches_q <= select_89;
    end
  end

  logic idle_s4_q;
  logic and_32_s4_q;
  logic or_36_s4_q;
  logic [1:0] states_rdata_s4_q;
  logic [6:0] block_s4_q;
  logic and_50_s4_q;
  logic or_52_s4_q;
  logic equal_54_s4_q;
  logic equal_57_s4_q;
  logic [9:0] sum_61_s4_q;
  logic equal_62_s4_q;
  logic and_68_s4_q;
  logic and_117_s4_q;
  logic last_s4_q;
  logic and_134_s4_q;
  logic equal_174_s4_q;
  logic and_178_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      idle_s4_q <= idle_s3_q;
      and_32_s4_q <= and_32_s3_q;
      or_36_s4_q <= or_36_s3_q;
      states_rdata_s4_q <= states_rdata_s3_q[33:32];
      block_s4_q <= block_s3_q;
      and_50_s4_q <= and_50;
      or_52_s4_q <= or_52;
      equal_54_s4_q <= state_s3_q == 2'h2;
      equal_57_s4_q <= equal_57_s3_q;
      sum_61_s4_q <= sum_61_s3_q;
      equal_62_s4_q <= equal_62_s3_q;
      and_68_s4_q <= and_68;
      and_117_s4_q <= not_31_s3_q & and_116;
      last_s4_q <= last_s3_q;
      and_134_s4_q <= and_134_s3_q;
      equal_174_s4_q <= x_s3_q == 11'h0;
      and_178_s4_q <= and_178_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic odd_q;
  logic [4:0] above_q;
  logic first_above_q;
  logic ended_q;
  logic watches_q;
  logic session_q;
  logic has_taught_q;
  // hls/stages/blind.hpp:62
  logic not_85;
  assign not_85 = ~and_32_s4_q;
  // hls/stages/blind.hpp:66
  logic and_86;
  assign and_86 = ended_q & not_85;
  logic and_88;
  assign and_88 = idle_s4_q & (~and_86);
  logic select_93;
  assign select_93 = and_32_s4_q ? (has_taught_q & (session_q | not_90)) : has_taught_q;
  logic and_118;
  assign and_118 = odd_q & not_85;
  logic [4:0] select_121;
  assign select_121 = and_32_s4_q ? 5'h0 : above_q;
  // hls/stages/blind.hpp:142
  logic equal_122;
  assign equal_122 = select_121 == 5'h11;
  // hls/stages/blind.hpp:80
  logic [4:0] select_147;
  assign select_147 = and_134_s4_q ? (equal_122 ? select_121 : (select_121 + 5'h1)) : select_121;
  // hls/stages/blind.hpp:66
  logic and_162;
  assign and_162 = first_above_q & not_85;
  logic select_166;
  assign select_166 = and_32_s4_q ? (cfg_teach_i & session_q) : session_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      odd_q <= 1'b0;
      above_q <= 5'h0;
      first_above_q <= 1'b0;
      ended_q <= 1'b1;
      watches_q <= 1'b0;
      session_q <= 1'b0;
      has_taught_q <= 1'b0;
    end else if (s4_en) begin
      odd_q <= and_134_s4_q ? (and_118 ^ equal_62_s4_q) : and_118;
      above_q <= select_147;
      first_above_q <= and_134_s4_q ? (select_121 == 5'h10) : and_162;
      ended_q <= and_86 | and_88;
      watches_q <= and_32_s4_q ? (cfg_watch_i & not_90) : watches_q;
      session_q <= and_88 ? (teaches_q | select_166) : select_166;
      has_taught_q <= and_88 ? (teaches_q | select_93) : select_93;
    end
  end

  logic idle_s5_q;
  logic or_36_s5_q;
  logic [1:0] states_rdata_s5_q;
  logic [6:0] block_s5_q;
  logic and_50_s5_q;
  logic [8:0] counts_rdata_s5_q;
  logic or_52_s5_q;
  logic equal_54_s5_q;
  logic equal_57_s5_q;
  logic [9:0] sum_61_s5_q;
  logic and_68_s5_q;
  logic [8:0] taught_rdata_s5_q;
  logic and_117_s5_q;
  logic and_118_s5_q;
  logic equal_122_s5_q;
  logic last_s5_q;
  logic and_176_s5_q;
  logic and_178_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      idle_s5_q <= idle_s4_q;
      or_36_s5_q <= or_36_s4_q;
      states_rdata_s5_q <= states_rdata_s4_q;
      block_s5_q <= block_s4_q;
      and_50_s5_q <= and_50_s4_q;
      counts_rdata_s5_q <= counts_rdata_q;
      or_52_s5_q <= or_52_s4_q;
      equal_54_s5_q <= equal_54_s4_q;
      equal_57_s5_q <= equal_57_s4_q;
      sum_61_s5_q <= sum_61_s4_q;
      and_68_s5_q <= and_68_s4_q;
      taught_rdata_s5_q <= taught_rdata_q;
      and_117_s5_q <= and_117_s4_q;
      and_118_s5_q <= and_118;
      equal_122_s5_q <= equal_122;
      last_s5_q <= last_s4_q;
      and_176_s5_q <= or_36_s4_q & (and_162 & equal_174_s4_q);
      and_178_s5_q <= and_178_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [4:0] in_row_q;
  // hls/stages/blind.hpp:150
  logic [4:0] sum_55;
  assign sum_55 = (or_52_s5_q ? 5'h0 : in_row_q) + {4'h0, equal_54_s5_q};
  // hls/stages/blind.hpp:77
  logic [7:0] known;
  assign known = (^taught_rdata_s5_q) ? 8'h0 : (has_taught_q ? taught_rdata_s5_q[7:0] : 8'h0);
  // hls/stages/blind.hpp:141
  logic not_120;
  assign not_120 = ~(and_118_s5_q ^ equal_57_s5_q);
  logic and_123;
  assign and_123 = or_36_s5_q & equal_122_s5_q;

  // Memory blind, 256 x 1, DISTANCE 16, hls/stages/blind.hpp:181; read in stage 5, written in stage 7: 5 < 7 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic blind_mem [0:255];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 256; i++) blind_mem[i] = 1'b0;
`endif
  logic [7:0] blind_raddr;
  assign blind_raddr = {block_s5_q, not_120};
  logic blind_re;
  assign blind_re = s5_en & and_123;
  logic blind_rdata_q;
  always_ff @(posedge clk_i) begin
    if (blind_re) blind_rdata_q <= blind_mem[blind_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      in_row_q <= 5'h0;
    end else if (s5_en) begin
      in_row_q <= idle_s5_q ? in_row_q : sum_55;
    end
  end

  logic or_36_s6_q;
  logic [1:0] states_rdata_s6_q;
  logic [6:0] block_s6_q;
  logic and_50_s6_q;
  logic [8:0] sum_59_s6_q;
  logic [9:0] sum_61_s6_q;
  logic and_68_s6_q;
  logic select_95_s6_q;
  logic [7:0] known_s6_q;
  logic and_117_s6_q;
  logic and_118_s6_q;
  logic equal_122_s6_q;
  logic and_123_s6_q;
  logic select_126_s6_q;
  logic last_s6_q;
  logic and_176_s6_q;
  logic and_178_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      or_36_s6_q <= or_36_s5_q;
      states_rdata_s6_q <= states_rdata_s5_q;
      block_s6_q <= block_s5_q;
      and_50_s6_q <= and_50_s5_q;
      sum_59_s6_q <= {4'h0, sum_55} + (equal_57_s5_q ? 9'h0 : counts_rdata_s5_q);
      sum_61_s6_q <= sum_61_s5_q;
      and_68_s6_q <= and_68_s5_q;
      select_95_s6_q <= has_taught_q;
      known_s6_q <= known;
      and_117_s6_q <= and_117_s5_q;
      and_118_s6_q <= and_118_s5_q;
      equal_122_s6_q <= equal_122_s5_q;
      and_123_s6_q <= and_123;
      select_126_s6_q <= watches_q;
      last_s6_q <= last_s5_q;
      and_176_s6_q <= and_176_s5_q;
      and_178_s6_q <= and_178_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/blind.hpp:161
  logic [8:0] select_99;
  assign select_99 = ({known_s6_q, 1'b0} < sum_59_s6_q) ? sum_59_s6_q : {known_s6_q, 1'b0};
  // hls/stages/blind.hpp:163
  logic [8:0] sum_127;
  assign sum_127 = {1'b0, cfg_blind_margin_i} + {2'h0, known_s6_q[7:1]};

  // Memory counts, write
  logic [6:0] counts_waddr;
  assign counts_waddr = block_s6_q;
  logic counts_we;
  assign counts_we = s6_en & and_50_s6_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (counts_we) counts_mem[counts_waddr] <= sum_59_s6_q;
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

  logic or_36_s7_q;
  logic [1:0] states_rdata_s7_q;
  logic [6:0] block_s7_q;
  logic [9:0] sum_61_s7_q;
  logic and_68_s7_q;
  logic select_95_s7_q;
  logic [8:0] select_99_s7_q;
  logic and_117_s7_q;
  logic and_118_s7_q;
  logic equal_122_s7_q;
  logic and_123_s7_q;
  logic blind_rdata_s7_q;
  logic select_126_s7_q;
  logic less_128_s7_q;
  logic last_s7_q;
  logic and_176_s7_q;
  logic and_178_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      or_36_s7_q <= or_36_s6_q;
      states_rdata_s7_q <= states_rdata_s6_q;
      block_s7_q <= block_s6_q;
      sum_61_s7_q <= sum_61_s6_q;
      and_68_s7_q <= and_68_s6_q;
      select_95_s7_q <= select_95_s6_q;
      select_99_s7_q <= select_99;
      and_117_s7_q <= and_117_s6_q;
      and_118_s7_q <= and_118_s6_q;
      equal_122_s7_q <= equal_122_s6_q;
      and_123_s7_q <= and_123_s6_q;
      blind_rdata_s7_q <= blind_rdata_q;
      select_126_s7_q <= select_126_s6_q;
      less_128_s7_q <= {sum_127, known_s6_q[0], 1'b0} < {2'h0, sum_59_s6_q};
      last_s7_q <= last_s6_q;
      and_176_s7_q <= and_176_s6_q;
      and_178_s7_q <= and_178_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/blind.hpp:161
  logic [8:0] stored;
  assign stored = select_99_s7_q + 9'h1;
  // hls/stages/blind.hpp:145
  logic and_172;
  assign and_172 = equal_122_s7_q & (blind_rdata_s7_q & (states_rdata_s7_q == 2'h2));

  // Memory blind, write
  logic [7:0] blind_waddr;
  assign blind_waddr = {block_s7_q, and_118_s7_q};
  logic blind_we;
  assign blind_we = s7_en & and_68_s7_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (blind_we) blind_mem[blind_waddr] <= select_126_s7_q & less_128_s7_q;
  end
`ifndef SYNTHESIS
  logic [7:0] blind_raddr_s6_sim;
  logic blind_re_s6_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      blind_re_s6_sim <= 1'b0;
    end else if (en_i) begin
      blind_re_s6_sim <= blind_re;
      blind_raddr_s6_sim <= blind_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && blind_we) begin
      if (blind_re && blind_raddr == blind_waddr) begin
        $error("blind: address %0d is read less than DISTANCE steps after its write", blind_waddr);
      end
      if (blind_re_s6_sim && blind_raddr_s6_sim == blind_waddr) begin
        $error("blind: address %0d is read less than DISTANCE steps after its write", blind_waddr);
      end
    end
  end
`endif

  logic [2:0] block_s8_q;
  logic [9:0] sum_61_s8_q;
  logic select_95_s8_q;
  logic [7:0] stored_s8_q;
  logic and_117_s8_q;
  logic and_123_s8_q;
  logic last_s8_q;
  logic [1:0] select_169_s8_q;
  logic and_173_s8_q;
  logic and_176_s8_q;
  logic and_178_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      block_s8_q <= block_s7_q[2:0];
      sum_61_s8_q <= sum_61_s7_q;
      select_95_s8_q <= select_95_s7_q;
      stored_s8_q <= stored[8:1];
      and_117_s8_q <= and_117_s7_q;
      and_123_s8_q <= and_123_s7_q;
      last_s8_q <= last_s7_q;
      select_169_s8_q <= or_36_s7_q ? states_rdata_s7_q : 2'h0;
      and_173_s8_q <= or_36_s7_q & and_172;
      and_176_s8_q <= and_176_s7_q;
      and_178_s8_q <= and_178_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/blind.hpp:111
  logic parity_113;
  assign parity_113 = ^stored_s8_q;

  // Memory taught, write
  logic [12:0] taught_waddr;
  assign taught_waddr = {sum_61_s8_q, block_s8_q};
  logic taught_we;
  assign taught_we = s8_en & and_117_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (taught_we) taught_mem[taught_waddr] <= {parity_113, stored_s8_q};
  end
`ifndef SYNTHESIS
  logic [12:0] taught_raddr_s4_sim;
  logic taught_re_s4_sim;
  logic [12:0] taught_raddr_s5_sim;
  logic taught_re_s5_sim;
  logic [12:0] taught_raddr_s6_sim;
  logic taught_re_s6_sim;
  logic [12:0] taught_raddr_s7_sim;
  logic taught_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      taught_re_s4_sim <= 1'b0;
      taught_re_s5_sim <= 1'b0;
      taught_re_s6_sim <= 1'b0;
      taught_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      taught_re_s4_sim <= taught_re;
      taught_raddr_s4_sim <= taught_raddr;
      taught_re_s5_sim <= taught_re_s4_sim;
      taught_raddr_s5_sim <= taught_raddr_s4_sim;
      taught_re_s6_sim <= taught_re_s5_sim;
      taught_raddr_s6_sim <= taught_raddr_s5_sim;
      taught_re_s7_sim <= taught_re_s6_sim;
      taught_raddr_s7_sim <= taught_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && taught_we) begin
      if (taught_re && taught_raddr == taught_waddr) begin
        $error("taught: address %0d is read less than DISTANCE steps after its write", taught_waddr);
      end
      if (taught_re_s4_sim && taught_raddr_s4_sim == taught_waddr) begin
        $error("taught: address %0d is read less than DISTANCE steps after its write", taught_waddr);
      end
      if (taught_re_s5_sim && taught_raddr_s5_sim == taught_waddr) begin
        $error("taught: address %0d is read less than DISTANCE steps after its write", taught_waddr);
      end
      if (taught_re_s6_sim && taught_raddr_s6_sim == taught_waddr) begin
        $error("taught: address %0d is read less than DISTANCE steps after its write", taught_waddr);
      end
      if (taught_re_s7_sim && taught_raddr_s7_sim == taught_waddr) begin
        $error("taught: address %0d is read less than DISTANCE steps after its write", taught_waddr);
      end
      if (taught_waddr >= 13'd8160) $error("taught: write outside, address %0d", taught_waddr);
    end
    if (rst_ni && taught_re && taught_raddr >= 13'd8160) $error("taught: read outside, address %0d", taught_raddr);
  end
`endif

  logic select_95_s9_q;
  logic and_123_s9_q;
  logic last_s9_q;
  logic [1:0] select_169_s9_q;
  logic and_173_s9_q;
  logic and_176_s9_q;
  logic and_178_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      select_95_s9_q <= select_95_s8_q;
      and_123_s9_q <= and_123_s8_q;
      last_s9_q <= last_s8_q;
      select_169_s9_q <= select_169_s8_q;
      and_173_s9_q <= and_173_s8_q;
      and_176_s9_q <= and_176_s8_q;
      and_178_s9_q <= and_178_s8_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign there_o = and_123_s9_q;
  assign state_o = select_169_s9_q;
  assign blind_o = and_173_s9_q;
  assign first_o = and_176_s9_q;
  assign last_o = last_s9_q;
  assign done_o = and_178_s9_q;
  assign taught_o = select_95_s9_q;
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
  assign unused_bits = ^{stored[0], cfg_width_i[3:0]};

endmodule
