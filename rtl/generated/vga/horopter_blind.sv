// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Blind<horopter::hls::profiles::vga>, hls/stages/blind.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 82 bits, pipeline 40 bits, memories 50736 bits.
module horopter_blind (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic first_i,
  input  logic last_i,
  input  logic idle_i,
  input  logic [9:0] cfg_width_i,
  input  logic [8:0] cfg_height_i,
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
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Of the configuration alone: not pipelined.
  logic not_83;
  assign not_83 = ~cfg_forget_i;
  logic not_84;
  assign not_84 = ~cfg_teach_i;
  logic [6:0] select_140;
  assign select_140 = (cfg_width_i[9:4] == 6'h0) ? 7'h1 : ((7'h50 < cfg_width_i[9:3]) ? 7'h4f : (cfg_width_i[9:3] + 7'h7f));

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [9:0] x_q;
  logic [9:0] before_v_q;
  logic [9:0] before_end_q;
  logic [8:0] rows_expected_q;
  logic last_row_q;
  logic [2:0] inner_row_q;
  logic [6:0] last_block_q;
  logic odd_q;
  logic [8:0] place_q;
  logic new_block_q;
  logic [3:0] above_q;
  logic [3:0] rows_left_q;
  logic more_q;
  logic row_ended_q;
  logic at_end_q;
  logic first_above_q;
  logic ended_q;
  logic teaches_q;
  logic watches_q;
  logic session_q;
  logic has_taught_q;
  // hls/stages/blind.hpp:65
  logic not_33;
  assign not_33 = ~idle_i;
  logic and_34;
  assign and_34 = first_i & not_33;
  // hls/stages/blind.hpp:67
  logic [9:0] x;
  assign x = (row_ended_q | and_34) ? 10'h0 : x_q;
  // hls/stages/blind.hpp:65
  logic and_37;
  assign and_37 = idle_i & more_q;
  // hls/stages/blind.hpp:78
  logic or_38;
  assign or_38 = not_33 | and_37;
  // hls/stages/blind.hpp:77
  logic [6:0] block;
  assign block = (last_block_q < x[9:3]) ? last_block_q : x[9:3];
  // hls/stages/blind.hpp:169
  logic ends;
  assign ends = last_i | ((~(last_block_q == block)) & (x[2:0] == 3'h7));
  // hls/stages/blind.hpp:173
  logic and_47;
  assign and_47 = not_33 & ends;
  // hls/stages/blind.hpp:69
  logic or_49;
  assign or_49 = new_block_q | and_34;
  logic [2:0] select_53;
  assign select_53 = and_34 ? 3'h0 : inner_row_q;
  // hls/stages/blind.hpp:161
  logic equal_54;
  assign equal_54 = select_53 == 3'h0;
  // hls/stages/blind.hpp:69
  logic [8:0] select_57;
  assign select_57 = and_34 ? 9'h0 : place_q;
  // hls/stages/blind.hpp:177
  logic [8:0] sum_58;
  assign sum_58 = select_57 + {6'h0, block[6:4]};
  // hls/stages/blind.hpp:65
  logic not_59;
  assign not_59 = ~and_34;
  // hls/stages/blind.hpp:69
  logic and_60;
  assign and_60 = last_row_q & not_59;
  // hls/stages/blind.hpp:176
  logic equal_61;
  assign equal_61 = select_53 == 3'h7;
  // hls/stages/blind.hpp:80
  logic and_64;
  assign and_64 = not_33 & (ends & (and_60 | equal_61));
  // hls/stages/blind.hpp:69
  logic and_79;
  assign and_79 = ended_q & not_59;
  logic and_81;
  assign and_81 = idle_i & (~and_79);
  logic select_82;
  assign select_82 = and_34 ? cfg_teach_i : teaches_q;
  logic select_88;
  assign select_88 = and_34 ? (has_taught_q & (not_83 & (session_q | not_84))) : has_taught_q;
  logic and_111;
  assign and_111 = odd_q & not_59;
  // hls/stages/blind.hpp:161
  logic not_113;
  assign not_113 = ~(and_111 ^ equal_54);
  // hls/stages/blind.hpp:69
  logic [3:0] select_114;
  assign select_114 = and_34 ? 4'h0 : above_q;
  // hls/stages/blind.hpp:162
  logic equal_115;
  assign equal_115 = select_114 == 4'h9;
  // hls/stages/blind.hpp:161
  logic and_116;
  assign and_116 = or_38 & equal_115;
  // hls/stages/blind.hpp:66
  logic last;
  assign last = idle_i ? at_end_q : last_i;
  // hls/stages/blind.hpp:88
  logic [9:0] select_126;
  assign select_126 = (not_33 & last) ? before_v_q : before_end_q;
  // hls/stages/blind.hpp:83
  logic and_127;
  assign and_127 = last & or_38;
  // hls/stages/blind.hpp:82
  logic [8:0] fewer;
  assign fewer = rows_expected_q + 9'h1ff;
  // hls/stages/blind.hpp:87
  logic [8:0] select_131;
  assign select_131 = (and_34 | and_127) ? (and_34 ? cfg_height_i : fewer) : rows_expected_q;
  // hls/stages/blind.hpp:86
  logic [8:0] select_146;
  assign select_146 = and_127 ? (equal_61 ? (select_57 + 9'h5) : select_57) : select_57;
  logic [3:0] select_151;
  assign select_151 = and_127 ? (equal_115 ? select_114 : (select_114 + 4'h1)) : select_114;
  // hls/stages/blind.hpp:93
  logic or_153;
  assign or_153 = and_34 | (and_37 & last);
  // hls/stages/blind.hpp:69
  logic and_166;
  assign and_166 = first_above_q & not_59;
  logic select_171;
  assign select_171 = and_34 ? (session_q & (cfg_teach_i & not_83)) : session_q;

  // Memory states, 640 x 18, DISTANCE 16, hls/stages/blind.hpp:200; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] states_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) states_mem[i] = 18'h0;
`endif
  logic [9:0] states_raddr;
  assign states_raddr = x;
`ifndef SYNTHESIS
  logic states_re;
  assign states_re = s0_en & or_38;
`endif
  logic [17:0] states_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) states_rdata_q <= states_mem[states_raddr];
  end

  // Memory counts, 80 x 7, DISTANCE 16, hls/stages/blind.hpp:201; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [6:0] counts_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) counts_mem[i] = 7'h0;
`endif
  logic [6:0] counts_raddr;
  assign counts_raddr = block;
`ifndef SYNTHESIS
  logic counts_re;
  assign counts_re = s0_en & and_47;
`endif
  logic [6:0] counts_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) counts_rdata_q <= counts_mem[counts_raddr];
  end

  // Memory taught, 4800 x 8, DISTANCE 16, hls/stages/blind.hpp:202; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] taught_mem [0:4799];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 4800; i++) taught_mem[i] = 8'h0;
`endif
  logic [12:0] taught_raddr;
  assign taught_raddr = {sum_58, block[3:0]};
`ifndef SYNTHESIS
  logic taught_re;
  assign taught_re = s0_en & and_64;
`endif
  logic [7:0] taught_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) taught_rdata_q <= taught_mem[taught_raddr];
  end

  // Memory blind, 256 x 1, DISTANCE 16, hls/stages/blind.hpp:203; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic blind_mem [0:255];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 256; i++) blind_mem[i] = 1'b0;
`endif
  logic [7:0] blind_raddr;
  assign blind_raddr = {block, not_113};
`ifndef SYNTHESIS
  logic blind_re;
  assign blind_re = s0_en & and_116;
`endif
  logic blind_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) blind_rdata_q <= blind_mem[blind_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= 10'h0;
      before_v_q <= 10'h0;
      before_end_q <= 10'h27e;
      rows_expected_q <= 9'h0;
      last_row_q <= 1'b0;
      inner_row_q <= 3'h0;
      last_block_q <= 7'h0;
      odd_q <= 1'b0;
      place_q <= 9'h0;
      new_block_q <= 1'b1;
      above_q <= 4'h0;
      rows_left_q <= 4'h0;
      more_q <= 1'b0;
      row_ended_q <= 1'b1;
      at_end_q <= 1'b0;
      first_above_q <= 1'b0;
      ended_q <= 1'b1;
      teaches_q <= 1'b0;
      watches_q <= 1'b0;
      session_q <= 1'b0;
      has_taught_q <= 1'b0;
    end else if (s0_en) begin
      x_q <= x + 10'h1;
      before_v_q <= x;
      before_end_q <= select_126;
      rows_expected_q <= select_131;
      last_row_q <= and_127 ? (rows_expected_q == 9'h2) : and_60;
      inner_row_q <= and_127 ? (select_53 + 3'h1) : select_53;
      last_block_q <= and_34 ? select_140 : last_block_q;
      odd_q <= and_127 ? (and_111 ^ equal_61) : and_111;
      place_q <= select_146;
      new_block_q <= idle_i ? or_49 : ends;
      above_q <= select_151;
      rows_left_q <= or_153 ? (and_34 ? 4'h9 : (rows_left_q + 4'hf)) : rows_left_q;
      more_q <= or_153 ? (and_34 | (~(rows_left_q == 4'h1))) : more_q;
      row_ended_q <= last;
      at_end_q <= (~(x < select_126)) & (~last);
      first_above_q <= and_127 ? (select_114 == 4'h8) : and_166;
      ended_q <= and_79 | and_81;
      teaches_q <= select_82;
      watches_q <= and_34 ? (cfg_watch_i & not_84) : watches_q;
      session_q <= and_81 ? (select_82 | select_171) : select_171;
      has_taught_q <= and_81 ? (select_82 | select_88) : select_88;
    end
  end

  logic [1:0] state_s1_q;
  logic idle_s1_q;
  logic or_38_s1_q;
  logic [6:0] block_s1_q;
  logic and_47_s1_q;
  logic or_49_s1_q;
  logic equal_54_s1_q;
  logic [8:0] sum_58_s1_q;
  logic and_64_s1_q;
  logic and_110_s1_q;
  logic and_111_s1_q;
  logic equal_115_s1_q;
  logic and_116_s1_q;
  logic and_181_s1_q;
  logic and_183_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      state_s1_q <= state_i;
      idle_s1_q <= idle_i;
      or_38_s1_q <= or_38;
      block_s1_q <= block;
      and_47_s1_q <= and_47;
      or_49_s1_q <= or_49;
      equal_54_s1_q <= equal_54;
      sum_58_s1_q <= sum_58;
      and_64_s1_q <= and_64;
      and_110_s1_q <= not_33 & (ends & (equal_61 ? select_82 : (and_60 & select_82)));
      and_111_s1_q <= and_111;
      equal_115_s1_q <= equal_115;
      and_116_s1_q <= and_116;
      and_181_s1_q <= or_38 & (and_166 & (x == 10'h0));
      and_183_s1_q <= idle_i & (~more_q);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [3:0] in_row_q;
  // hls/stages/blind.hpp:170
  logic equal_51;
  assign equal_51 = state_s1_q == 2'h2;
  logic [3:0] sum_52;
  assign sum_52 = (or_49_s1_q ? 4'h0 : in_row_q) + {3'h0, equal_51};
  // hls/stages/blind.hpp:174
  logic [6:0] sum_56;
  assign sum_56 = {3'h0, sum_52} + (equal_54_s1_q ? 7'h0 : counts_rdata_q);
  // hls/stages/blind.hpp:181
  logic [6:0] known;
  assign known = ((^taught_rdata_q) | (~has_taught_q)) ? 7'h0 : taught_rdata_q[6:0];
  // hls/stages/blind.hpp:182
  logic [6:0] stored;
  assign stored = (known < sum_56) ? sum_56 : known;
  // hls/stages/blind.hpp:131
  logic parity_106;
  assign parity_106 = ^stored;
  // hls/stages/blind.hpp:186
  logic and_122;
  assign and_122 = watches_q & (({1'b0, cfg_blind_margin_i} + {2'h0, known}) < {2'h0, sum_56});
  // hls/stages/blind.hpp:165
  logic and_177;
  assign and_177 = equal_115_s1_q & (blind_rdata_q & (states_rdata_q[17:16] == 2'h2));

  // Memory states, write
  logic [9:0] states_waddr;
  assign states_waddr = before_v_q;
  logic states_we;
  assign states_we = s1_en & or_38_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (states_we) states_mem[states_waddr] <= {states_rdata_q[15:0], state_s1_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && states_we) begin
      if (states_re && states_raddr == states_waddr) begin
        $error("states: address %0d is read less than DISTANCE steps after its write", states_waddr);
      end
      if (states_waddr >= 10'd640) $error("states: write outside, address %0d", states_waddr);
    end
    if (rst_ni && states_re && states_raddr >= 10'd640) $error("states: read outside, address %0d", states_raddr);
  end
`endif

  // Memory counts, write
  logic [6:0] counts_waddr;
  assign counts_waddr = block_s1_q;
  logic counts_we;
  assign counts_we = s1_en & and_47_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (counts_we) counts_mem[counts_waddr] <= sum_56;
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && counts_we) begin
      if (counts_re && counts_raddr == counts_waddr) begin
        $error("counts: address %0d is read less than DISTANCE steps after its write", counts_waddr);
      end
      if (counts_waddr >= 7'd80) $error("counts: write outside, address %0d", counts_waddr);
    end
    if (rst_ni && counts_re && counts_raddr >= 7'd80) $error("counts: read outside, address %0d", counts_raddr);
  end
`endif

  // Memory taught, write
  logic [12:0] taught_waddr;
  assign taught_waddr = {sum_58_s1_q, block_s1_q[3:0]};
  logic taught_we;
  assign taught_we = s1_en & and_110_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (taught_we) taught_mem[taught_waddr] <= {parity_106, stored};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && taught_we) begin
      if (taught_re && taught_raddr == taught_waddr) begin
        $error("taught: address %0d is read less than DISTANCE steps after its write", taught_waddr);
      end
      if (taught_waddr >= 13'd4800) $error("taught: write outside, address %0d", taught_waddr);
    end
    if (rst_ni && taught_re && taught_raddr >= 13'd4800) $error("taught: read outside, address %0d", taught_raddr);
  end
`endif

  // Memory blind, write
  logic [7:0] blind_waddr;
  assign blind_waddr = {block_s1_q, and_111_s1_q};
  logic blind_we;
  assign blind_we = s1_en & and_64_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (blind_we) blind_mem[blind_waddr] <= and_122;
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && blind_we) begin
      if (blind_re && blind_raddr == blind_waddr) begin
        $error("blind: address %0d is read less than DISTANCE steps after its write", blind_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      in_row_q <= 4'h0;
    end else if (s1_en) begin
      in_row_q <= idle_s1_q ? in_row_q : sum_52;
    end
  end

  logic select_90_s2_q;
  logic and_116_s2_q;
  logic last_s2_q;
  logic [1:0] select_174_s2_q;
  logic and_178_s2_q;
  logic and_181_s2_q;
  logic and_183_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      select_90_s2_q <= has_taught_q;
      and_116_s2_q <= and_116_s1_q;
      last_s2_q <= row_ended_q;
      select_174_s2_q <= or_38_s1_q ? states_rdata_q[17:16] : 2'h0;
      and_178_s2_q <= or_38_s1_q & and_177;
      and_181_s2_q <= and_181_s1_q;
      and_183_s2_q <= and_183_s1_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign there_o = and_116_s2_q;
  assign state_o = select_174_s2_q;
  assign blind_o = and_178_s2_q;
  assign first_o = and_181_s2_q;
  assign last_o = last_s2_q;
  assign done_o = and_183_s2_q;
  assign taught_o = select_90_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^cfg_width_i[2:0];

endmodule
