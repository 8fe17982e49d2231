// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Blind<horopter::hls::profiles::field>, hls/stages/blind.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 79 bits, pipeline 41 bits, memories 20797 bits.
module horopter_blind (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic first_i,
  input  logic last_i,
  input  logic idle_i,
  input  logic [8:0] cfg_width_i,
  input  logic [8:0] cfg_height_i,
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
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Of the configuration alone: not pipelined.
  logic [5:0] last_block;
  assign last_block = (cfg_width_i[8:4] == 5'h0) ? 6'h1 : ((2'h2 < cfg_width_i[8:7]) ? 6'h2e : (cfg_width_i[8:3] + 6'h3f));
  logic not_88;
  assign not_88 = ~cfg_teach_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [8:0] x_q;
  logic [8:0] before_v_q;
  logic [8:0] before_end_q;
  logic [8:0] row_q;
  logic [2:0] inner_row_q;
  logic [5:0] last_block_q;
  logic odd_q;
  logic [10:0] place_q;
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
  // hls/stages/blind.hpp:62
  logic not_31;
  assign not_31 = ~idle_i;
  logic and_32;
  assign and_32 = first_i & not_31;
  // hls/stages/blind.hpp:64
  logic [8:0] x;
  assign x = (row_ended_q | and_32) ? 9'h0 : x_q;
  // hls/stages/blind.hpp:62
  logic and_35;
  assign and_35 = idle_i & more_q;
  // hls/stages/blind.hpp:76
  logic or_36;
  assign or_36 = not_31 | and_35;
  // hls/stages/blind.hpp:73
  logic [5:0] last_block_2;
  assign last_block_2 = and_32 ? last_block : last_block_q;
  // hls/stages/blind.hpp:75
  logic [5:0] block;
  assign block = (last_block_2 < x[8:3]) ? last_block_2 : x[8:3];
  // hls/stages/blind.hpp:149
  logic ends;
  assign ends = last_i | ((x[8:3] < last_block_2) & (x[2:0] == 3'h7));
  // hls/stages/blind.hpp:153
  logic and_50;
  assign and_50 = not_31 & ends;
  // hls/stages/blind.hpp:66
  logic or_52;
  assign or_52 = new_block_q | and_32;
  logic [2:0] select_56;
  assign select_56 = and_32 ? 3'h0 : inner_row_q;
  // hls/stages/blind.hpp:141
  logic equal_57;
  assign equal_57 = select_56 == 3'h0;
  // hls/stages/blind.hpp:66
  logic [10:0] select_60;
  assign select_60 = and_32 ? 11'h0 : place_q;
  // hls/stages/blind.hpp:157
  logic [10:0] place;
  assign place = select_60 + {5'h0, block};
  // hls/stages/blind.hpp:156
  logic equal_62;
  assign equal_62 = select_56 == 3'h7;
  // hls/stages/blind.hpp:66
  logic [8:0] select_63;
  assign select_63 = and_32 ? 9'h0 : row_q;
  // hls/stages/blind.hpp:156
  logic [9:0] sum_64;
  assign sum_64 = {1'b0, select_63} + 10'h1;
  logic equal_65;
  assign equal_65 = {sum_64[9], cfg_height_i} == {1'b0, sum_64[8:0]};
  // hls/stages/blind.hpp:79
  logic and_68;
  assign and_68 = not_31 & (ends & (equal_62 | equal_65));
  // hls/stages/blind.hpp:62
  logic not_83;
  assign not_83 = ~and_32;
  // hls/stages/blind.hpp:66
  logic and_84;
  assign and_84 = ended_q & not_83;
  logic and_86;
  assign and_86 = idle_i & (~and_84);
  logic select_87;
  assign select_87 = and_32 ? cfg_teach_i : teaches_q;
  logic select_91;
  assign select_91 = and_32 ? (has_taught_q & (session_q | not_88)) : has_taught_q;
  // hls/stages/blind.hpp:79
  logic and_112;
  assign and_112 = not_31 & (ends & (equal_62 ? select_87 : (select_87 & equal_65)));
  // hls/stages/blind.hpp:66
  logic and_113;
  assign and_113 = odd_q & not_83;
  // hls/stages/blind.hpp:141
  logic not_115;
  assign not_115 = ~(and_113 ^ equal_57);
  // hls/stages/blind.hpp:66
  logic [3:0] select_116;
  assign select_116 = and_32 ? 4'h0 : above_q;
  // hls/stages/blind.hpp:142
  logic equal_117;
  assign equal_117 = select_116 == 4'h9;
  // hls/stages/blind.hpp:141
  logic and_118;
  assign and_118 = or_36 & equal_117;
  // hls/stages/blind.hpp:63
  logic last;
  assign last = idle_i ? at_end_q : last_i;
  // hls/stages/blind.hpp:81
  logic [8:0] select_128;
  assign select_128 = (not_31 & last) ? before_v_q : before_end_q;
  // hls/stages/blind.hpp:79
  logic and_129;
  assign and_129 = last & or_36;
  // hls/stages/blind.hpp:80
  logic [10:0] select_137;
  assign select_137 = and_129 ? (equal_62 ? (select_60 + 11'h2f) : select_60) : select_60;
  logic [3:0] select_142;
  assign select_142 = and_129 ? (equal_117 ? select_116 : (select_116 + 4'h1)) : select_116;
  // hls/stages/blind.hpp:86
  logic or_144;
  assign or_144 = and_32 | (and_35 & last);
  // hls/stages/blind.hpp:66
  logic and_157;
  assign and_157 = first_above_q & not_83;
  logic select_161;
  assign select_161 = and_32 ? (cfg_teach_i & session_q) : session_q;

  // Memory states, 378 x 18, DISTANCE 16, hls/stages/blind.hpp:178; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] states_mem [0:377];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 378; i++) states_mem[i] = 18'h0;
`endif
  logic [8:0] states_raddr;
  assign states_raddr = x;
  logic states_re;
  assign states_re = s0_en & or_36;
  logic [17:0] states_rdata_q;
  always_ff @(posedge clk_i) begin
    if (states_re) states_rdata_q <= states_mem[states_raddr];
  end

  // Memory counts, 47 x 7, DISTANCE 16, hls/stages/blind.hpp:179; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [6:0] counts_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) counts_mem[i] = 7'h0;
`endif
  logic [5:0] counts_raddr;
  assign counts_raddr = block;
  logic counts_re;
  assign counts_re = s0_en & and_50;
  logic [6:0] counts_rdata_q;
  always_ff @(posedge clk_i) begin
    if (counts_re) counts_rdata_q <= counts_mem[counts_raddr];
  end

  // Memory taught, 1692 x 8, DISTANCE 16, hls/stages/blind.hpp:180; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] taught_mem [0:1691];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1692; i++) taught_mem[i] = 8'h0;
`endif
  logic [10:0] taught_raddr;
  assign taught_raddr = place;
  logic taught_re;
  assign taught_re = s0_en & and_68;
  logic [7:0] taught_rdata_q;
  always_ff @(posedge clk_i) begin
    if (taught_re) taught_rdata_q <= taught_mem[taught_raddr];
  end

  // Memory blind, 128 x 1, DISTANCE 16, hls/stages/blind.hpp:181; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic blind_mem [0:127];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 128; i++) blind_mem[i] = 1'b0;
`endif
  logic [6:0] blind_raddr;
  assign blind_raddr = {block, not_115};
  logic blind_re;
  assign blind_re = s0_en & and_118;
  logic blind_rdata_q;
  always_ff @(posedge clk_i) begin
    if (blind_re) blind_rdata_q <= blind_mem[blind_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= 9'h0;
      before_v_q <= 9'h0;
      before_end_q <= 9'h178;
      row_q <= 9'h0;
      inner_row_q <= 3'h0;
      last_block_q <= 6'h0;
      odd_q <= 1'b0;
      place_q <= 11'h0;
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
      x_q <= x + 9'h1;
      before_v_q <= x;
      before_end_q <= select_128;
      row_q <= and_129 ? sum_64[8:0] : select_63;
      inner_row_q <= and_129 ? (select_56 + 3'h1) : select_56;
      last_block_q <= last_block_2;
      odd_q <= and_129 ? (and_113 ^ equal_62) : and_113;
      place_q <= select_137;
      new_block_q <= idle_i ? or_52 : ends;
      above_q <= select_142;
      rows_left_q <= or_144 ? (and_32 ? 4'h9 : (rows_left_q + 4'hf)) : rows_left_q;
      more_q <= or_144 ? (and_32 | (~(rows_left_q == 4'h1))) : more_q;
      row_ended_q <= last;
      at_end_q <= (~(x < select_128)) & (~last);
      first_above_q <= and_129 ? (select_116 == 4'h8) : and_157;
      ended_q <= and_84 | and_86;
      teaches_q <= select_87;
      watches_q <= and_32 ? (cfg_watch_i & not_88) : watches_q;
      session_q <= and_86 ? (select_87 | select_161) : select_161;
      has_taught_q <= and_86 ? (select_87 | select_91) : select_91;
    end
  end

  logic [1:0] state_s1_q;
  logic idle_s1_q;
  logic or_36_s1_q;
  logic [5:0] block_s1_q;
  logic and_50_s1_q;
  logic or_52_s1_q;
  logic equal_57_s1_q;
  logic [10:0] place_s1_q;
  logic and_68_s1_q;
  logic and_112_s1_q;
  logic and_113_s1_q;
  logic equal_117_s1_q;
  logic and_118_s1_q;
  logic and_171_s1_q;
  logic and_173_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      state_s1_q <= state_i;
      idle_s1_q <= idle_i;
      or_36_s1_q <= or_36;
      block_s1_q <= block;
      and_50_s1_q <= and_50;
      or_52_s1_q <= or_52;
      equal_57_s1_q <= equal_57;
      place_s1_q <= place;
      and_68_s1_q <= and_68;
      and_112_s1_q <= and_112;
      and_113_s1_q <= and_113;
      equal_117_s1_q <= equal_117;
      and_118_s1_q <= and_118;
      and_171_s1_q <= or_36 & (and_157 & (x == 9'h0));
      and_173_s1_q <= idle_i & (~more_q);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [3:0] in_row_q;
  // hls/stages/blind.hpp:150
  logic equal_54;
  assign equal_54 = state_s1_q == 2'h2;
  logic [3:0] sum_55;
  assign sum_55 = (or_52_s1_q ? 4'h0 : in_row_q) + {3'h0, equal_54};
  // hls/stages/blind.hpp:154
  logic [6:0] sum_59;
  assign sum_59 = {3'h0, sum_55} + (equal_57_s1_q ? 7'h0 : counts_rdata_q);
  // hls/stages/blind.hpp:77
  logic [6:0] known;
  assign known = (^taught_rdata_q) ? 7'h0 : (has_taught_q ? taught_rdata_q[6:0] : 7'h0);
  // hls/stages/blind.hpp:161
  logic [6:0] stored;
  assign stored = (known < sum_59) ? sum_59 : known;
  // hls/stages/blind.hpp:111
  logic parity_108;
  assign parity_108 = ^stored;
  // hls/stages/blind.hpp:164
  logic and_124;
  assign and_124 = watches_q & (({1'b0, cfg_blind_margin_i} + {2'h0, known}) < {2'h0, sum_59});
  // hls/stages/blind.hpp:145
  logic and_167;
  assign and_167 = equal_117_s1_q & (blind_rdata_q & (states_rdata_q[17:16] == 2'h2));

  // Memory states, write
  logic [8:0] states_waddr;
  assign states_waddr = before_v_q;
  logic states_we;
  assign states_we = s1_en & or_36_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (states_we) states_mem[states_waddr] <= {states_rdata_q[15:0], state_s1_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && states_we) begin
      if (states_re && states_raddr == states_waddr) begin
        $error("states: address %0d is read less than DISTANCE steps after its write", states_waddr);
      end
      if (states_waddr >= 9'd378) $error("states: write outside, address %0d", states_waddr);
    end
    if (rst_ni && states_re && states_raddr >= 9'd378) $error("states: read outside, address %0d", states_raddr);
  end
`endif

  // Memory counts, write
  logic [5:0] counts_waddr;
  assign counts_waddr = block_s1_q;
  logic counts_we;
  assign counts_we = s1_en & and_50_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (counts_we) counts_mem[counts_waddr] <= sum_59;
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && counts_we) begin
      if (counts_re && counts_raddr == counts_waddr) begin
        $error("counts: address %0d is read less than DISTANCE steps after its write", counts_waddr);
      end
      if (counts_waddr >= 6'd47) $error("counts: write outside, address %0d", counts_waddr);
    end
    if (rst_ni && counts_re && counts_raddr >= 6'd47) $error("counts: read outside, address %0d", counts_raddr);
  end
`endif

  // Memory taught, write
  logic [10:0] taught_waddr;
  assign taught_waddr = place_s1_q;
  logic taught_we;
  assign taught_we = s1_en & and_112_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (taught_we) taught_mem[taught_waddr] <= {parity_108, stored};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && taught_we) begin
      if (taught_re && taught_raddr == taught_waddr) begin
        $error("taught: address %0d is read less than DISTANCE steps after its write", taught_waddr);
      end
      if (taught_waddr >= 11'd1692) $error("taught: write outside, address %0d", taught_waddr);
    end
    if (rst_ni && taught_re && taught_raddr >= 11'd1692) $error("taught: read outside, address %0d", taught_raddr);
  end
`endif

  // Memory blind, write
  logic [6:0] blind_waddr;
  assign blind_waddr = {block_s1_q, and_113_s1_q};
  logic blind_we;
  assign blind_we = s1_en & and_68_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (blind_we) blind_mem[blind_waddr] <= and_124;
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
      in_row_q <= idle_s1_q ? in_row_q : sum_55;
    end
  end

  logic select_93_s2_q;
  logic and_118_s2_q;
  logic last_s2_q;
  logic [1:0] select_164_s2_q;
  logic and_168_s2_q;
  logic and_171_s2_q;
  logic and_173_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      select_93_s2_q <= has_taught_q;
      and_118_s2_q <= and_118_s1_q;
      last_s2_q <= row_ended_q;
      select_164_s2_q <= or_36_s1_q ? states_rdata_q[17:16] : 2'h0;
      and_168_s2_q <= or_36_s1_q & and_167;
      and_171_s2_q <= and_171_s1_q;
      and_173_s2_q <= and_173_s1_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign there_o = and_118_s2_q;
  assign state_o = select_164_s2_q;
  assign blind_o = and_168_s2_q;
  assign first_o = and_171_s2_q;
  assign last_o = last_s2_q;
  assign done_o = and_173_s2_q;
  assign taught_o = select_93_s2_q;
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
