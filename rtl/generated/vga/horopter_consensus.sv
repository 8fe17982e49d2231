// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Consensus<horopter::hls::profiles::vga>, hls/stages/consensus.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 127 bits, pipeline 24 bits, memories 12160 bits.
module horopter_consensus (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic skin_i,
  input  logic clear_i,
  input  logic exists_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic parity_error_o,
  output logic valid_o,
  output logic [1:0] state_o,
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

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [9:0] raster_column_q;
  logic raster_row_ended_q;
  logic running_q;
  logic centres_values_0_marks_first_q;
  logic centres_values_0_marks_last_q;
  logic centres_values_0_marks_seen_q;
  logic centres_values_0_marks_nearer_q;
  logic centres_values_1_marks_first_q;
  logic centres_values_1_marks_last_q;
  logic centres_values_1_marks_seen_q;
  logic centres_values_1_marks_nearer_q;
  logic centres_values_2_marks_first_q;
  logic centres_values_2_marks_last_q;
  logic centres_values_2_marks_seen_q;
  logic centres_values_2_marks_nearer_q;
  // hls/stages/consensus.hpp:40
  logic or_54;
  assign or_54 = marks_first_i | raster_row_ended_q;
  logic [9:0] select_56;
  assign select_56 = or_54 ? 10'h0 : (raster_column_q + 10'h1);
  // hls/stages/consensus.hpp:96
  logic or_57;
  assign or_57 = marks_first_i | running_q;

  // Memory memory, 640 x 18 and parity, DISTANCE 16, hls/stages/consensus.hpp:104; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 19'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = select_56;
  logic memory_re;
  assign memory_re = s0_en & or_57;
  logic [18:0] memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_word_q <= memory_mem[memory_raddr];
  end
  logic [17:0] memory_rdata_q;
  assign memory_rdata_q = memory_word_q[17:0];
  logic memory_read_q, memory_error;
  always_ff @(posedge clk_i) memory_read_q <= rst_ni & memory_re;
  assign memory_error = memory_read_q & ^memory_word_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
      centres_values_0_marks_first_q <= 1'b0;
      centres_values_0_marks_last_q <= 1'b0;
      centres_values_0_marks_seen_q <= 1'b0;
      centres_values_0_marks_nearer_q <= 1'b0;
      centres_values_1_marks_first_q <= 1'b0;
      centres_values_1_marks_last_q <= 1'b0;
      centres_values_1_marks_seen_q <= 1'b0;
      centres_values_1_marks_nearer_q <= 1'b0;
      centres_values_2_marks_first_q <= 1'b0;
      centres_values_2_marks_last_q <= 1'b0;
      centres_values_2_marks_seen_q <= 1'b0;
      centres_values_2_marks_nearer_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_56;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_57 : (marks_first_i & or_57);
      centres_values_0_marks_first_q <= marks_first_i;
      centres_values_0_marks_last_q <= marks_last_i;
      centres_values_0_marks_seen_q <= marks_seen_i;
      centres_values_0_marks_nearer_q <= marks_nearer_i;
      centres_values_1_marks_first_q <= centres_values_0_marks_first_q;
      centres_values_1_marks_last_q <= centres_values_0_marks_last_q;
      centres_values_1_marks_seen_q <= centres_values_0_marks_seen_q;
      centres_values_1_marks_nearer_q <= centres_values_0_marks_nearer_q;
      centres_values_2_marks_first_q <= centres_values_1_marks_first_q;
      centres_values_2_marks_last_q <= centres_values_1_marks_last_q;
      centres_values_2_marks_seen_q <= centres_values_1_marks_seen_q;
      centres_values_2_marks_nearer_q <= centres_values_1_marks_nearer_q;
    end
  end

  logic exists_s1_q;
  logic running_s1_q;
  logic centres_values_2_marks_first_s1_q;
  logic centres_values_2_marks_last_s1_q;
  logic centres_values_2_marks_seen_s1_q;
  logic centres_values_2_marks_nearer_s1_q;
  logic or_54_s1_q;
  logic and_64_s1_q;
  logic and_68_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      exists_s1_q <= exists_i;
      running_s1_q <= running_q;
      centres_values_2_marks_first_s1_q <= centres_values_2_marks_first_q;
      centres_values_2_marks_last_s1_q <= centres_values_2_marks_last_q;
      centres_values_2_marks_seen_s1_q <= centres_values_2_marks_seen_q;
      centres_values_2_marks_nearer_s1_q <= centres_values_2_marks_nearer_q;
      or_54_s1_q <= or_54;
      and_64_s1_q <= clear_i & exists_i;
      and_68_s1_q <= skin_i & exists_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  logic [2:0] columns_values_0_exists_q;
  logic [2:0] columns_values_0_clear_q;
  logic [2:0] columns_values_0_skin_q;
  logic [2:0] columns_values_1_exists_q;
  logic [2:0] columns_values_1_clear_q;
  logic [2:0] columns_values_1_skin_q;
  logic [2:0] columns_values_2_exists_q;
  logic [2:0] columns_values_2_clear_q;
  logic [2:0] columns_values_2_skin_q;
  logic [2:0] columns_values_3_exists_q;
  logic [2:0] columns_values_3_clear_q;
  logic [2:0] columns_values_3_skin_q;
  logic [2:0] columns_values_4_exists_q;
  logic [2:0] columns_values_4_clear_q;
  logic [2:0] columns_values_4_skin_q;
  logic [2:0] columns_values_5_exists_q;
  logic [2:0] columns_values_5_clear_q;
  logic [2:0] columns_values_5_skin_q;
  logic [2:0] columns_values_6_exists_q;
  logic [2:0] columns_values_6_clear_q;
  logic [2:0] columns_values_6_skin_q;
  logic [5:0] sums_exists_q;
  logic [5:0] sums_clear_q;
  logic [5:0] sums_skin_q;
  logic [5:0] rest_exists_q;
  logic [5:0] rest_clear_q;
  logic [5:0] rest_skin_q;
  logic centres_values_0_exists_q;
  logic centres_values_1_exists_q;
  logic centres_values_2_exists_q;
  // hls/stages/consensus.hpp:40
  logic and_60;
  assign and_60 = raster_rows_q & (~centres_values_0_marks_first_q);
  // hls/stages/consensus.hpp:44
  logic [5:0] select_62;
  assign select_62 = running_s1_q ? memory_rdata_q[5:0] : (centres_values_0_marks_first_q ? memory_rdata_q[5:0] : 6'h0);
  // hls/stages/consensus.hpp:47
  logic [5:0] select_63;
  assign select_63 = and_60 ? select_62 : 6'h0;
  // hls/stages/consensus.hpp:44
  logic [5:0] select_66;
  assign select_66 = running_s1_q ? memory_rdata_q[11:6] : (centres_values_0_marks_first_q ? memory_rdata_q[11:6] : 6'h0);
  // hls/stages/consensus.hpp:48
  logic [5:0] select_67;
  assign select_67 = and_60 ? select_66 : 6'h0;
  // hls/stages/consensus.hpp:44
  logic [5:0] select_70;
  assign select_70 = running_s1_q ? memory_rdata_q[17:12] : (centres_values_0_marks_first_q ? memory_rdata_q[17:12] : 6'h0);
  // hls/stages/consensus.hpp:49
  logic [5:0] select_71;
  assign select_71 = and_60 ? select_70 : 6'h0;
  // hls/stages/consensus.hpp:56
  logic [1:0] sum_76;
  assign sum_76 = {1'b0, select_63[1]} + ({1'b0, exists_s1_q} + {1'b0, select_63[0]});
  logic [2:0] sum_79;
  assign sum_79 = {2'h0, select_63[4]} + ({2'h0, select_63[3]} + ({2'h0, select_63[2]} + {1'b0, sum_76}));
  logic [2:0] entering;
  assign entering = {2'h0, select_63[5]} + sum_79;
  logic [1:0] sum_82;
  assign sum_82 = {1'b0, select_67[1]} + ({1'b0, and_64_s1_q} + {1'b0, select_67[0]});
  logic [2:0] sum_85;
  assign sum_85 = {2'h0, select_67[4]} + ({2'h0, select_67[3]} + ({2'h0, select_67[2]} + {1'b0, sum_82}));
  logic [2:0] entering_2;
  assign entering_2 = {2'h0, select_67[5]} + sum_85;
  logic [1:0] sum_88;
  assign sum_88 = {1'b0, select_71[1]} + ({1'b0, and_68_s1_q} + {1'b0, select_71[0]});
  logic [2:0] sum_91;
  assign sum_91 = {2'h0, select_71[4]} + ({2'h0, select_71[3]} + ({2'h0, select_71[2]} + {1'b0, sum_88}));
  logic [2:0] entering_3;
  assign entering_3 = {2'h0, select_71[5]} + sum_91;
  // hls/stages/consensus.hpp:62
  logic less_94;
  assign less_94 = 10'h6 < raster_column_q;
  // hls/stages/consensus.hpp:101
  logic [2:0] select_95;
  assign select_95 = less_94 ? columns_values_6_exists_q : 3'h0;
  logic [3:0] difference_96;
  assign difference_96 = {1'b0, entering} - {1'b0, select_95};
  logic [5:0] sum_97;
  assign sum_97 = (or_54_s1_q ? 6'h0 : sums_exists_q) + {{2{difference_96[3]}}, difference_96};
  logic [2:0] select_99;
  assign select_99 = less_94 ? columns_values_6_clear_q : 3'h0;
  logic [3:0] difference_100;
  assign difference_100 = {1'b0, entering_2} - {1'b0, select_99};
  logic [5:0] sum_101;
  assign sum_101 = (or_54_s1_q ? 6'h0 : sums_clear_q) + {{2{difference_100[3]}}, difference_100};
  logic [2:0] select_103;
  assign select_103 = less_94 ? columns_values_6_skin_q : 3'h0;
  logic [3:0] difference_104;
  assign difference_104 = {1'b0, entering_3} - {1'b0, select_103};
  logic [5:0] sum_105;
  assign sum_105 = (or_54_s1_q ? 6'h0 : sums_skin_q) + {{2{difference_104[3]}}, difference_104};
  // hls/stages/consensus.hpp:66
  logic [5:0] difference_107;
  assign difference_107 = (or_54_s1_q ? sums_exists_q : rest_exists_q) - {3'h0, columns_values_6_exists_q};
  // hls/stages/consensus.hpp:67
  logic [5:0] difference_109;
  assign difference_109 = (or_54_s1_q ? sums_clear_q : rest_clear_q) - {3'h0, columns_values_6_clear_q};
  // hls/stages/consensus.hpp:68
  logic [5:0] difference_111;
  assign difference_111 = (or_54_s1_q ? sums_skin_q : rest_skin_q) - {3'h0, columns_values_6_skin_q};
  // hls/stages/consensus.hpp:59
  logic total;
  assign total = raster_column_q < 10'h3;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en & running_q;
  logic [17:0] memory_wdata;
  assign memory_wdata = {select_71[4:0], and_68_s1_q, select_67[4:0], and_64_s1_q, select_63[4:0], exists_s1_q};
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
      columns_values_0_exists_q <= 3'h0;
      columns_values_0_clear_q <= 3'h0;
      columns_values_0_skin_q <= 3'h0;
      columns_values_1_exists_q <= 3'h0;
      columns_values_1_clear_q <= 3'h0;
      columns_values_1_skin_q <= 3'h0;
      columns_values_2_exists_q <= 3'h0;
      columns_values_2_clear_q <= 3'h0;
      columns_values_2_skin_q <= 3'h0;
      columns_values_3_exists_q <= 3'h0;
      columns_values_3_clear_q <= 3'h0;
      columns_values_3_skin_q <= 3'h0;
      columns_values_4_exists_q <= 3'h0;
      columns_values_4_clear_q <= 3'h0;
      columns_values_4_skin_q <= 3'h0;
      columns_values_5_exists_q <= 3'h0;
      columns_values_5_clear_q <= 3'h0;
      columns_values_5_skin_q <= 3'h0;
      columns_values_6_exists_q <= 3'h0;
      columns_values_6_clear_q <= 3'h0;
      columns_values_6_skin_q <= 3'h0;
      sums_exists_q <= 6'h0;
      sums_clear_q <= 6'h0;
      sums_skin_q <= 6'h0;
      rest_exists_q <= 6'h0;
      rest_clear_q <= 6'h0;
      rest_skin_q <= 6'h0;
      centres_values_0_exists_q <= 1'b0;
      centres_values_1_exists_q <= 1'b0;
      centres_values_2_exists_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_60;
      columns_values_0_exists_q <= entering;
      columns_values_0_clear_q <= entering_2;
      columns_values_0_skin_q <= entering_3;
      columns_values_1_exists_q <= columns_values_0_exists_q;
      columns_values_1_clear_q <= columns_values_0_clear_q;
      columns_values_1_skin_q <= columns_values_0_skin_q;
      columns_values_2_exists_q <= columns_values_1_exists_q;
      columns_values_2_clear_q <= columns_values_1_clear_q;
      columns_values_2_skin_q <= columns_values_1_skin_q;
      columns_values_3_exists_q <= columns_values_2_exists_q;
      columns_values_3_clear_q <= columns_values_2_clear_q;
      columns_values_3_skin_q <= columns_values_2_skin_q;
      columns_values_4_exists_q <= columns_values_3_exists_q;
      columns_values_4_clear_q <= columns_values_3_clear_q;
      columns_values_4_skin_q <= columns_values_3_skin_q;
      columns_values_5_exists_q <= columns_values_4_exists_q;
      columns_values_5_clear_q <= columns_values_4_clear_q;
      columns_values_5_skin_q <= columns_values_4_skin_q;
      columns_values_6_exists_q <= columns_values_5_exists_q;
      columns_values_6_clear_q <= columns_values_5_clear_q;
      columns_values_6_skin_q <= columns_values_5_skin_q;
      sums_exists_q <= sum_97;
      sums_clear_q <= sum_101;
      sums_skin_q <= sum_105;
      rest_exists_q <= difference_107;
      rest_clear_q <= difference_109;
      rest_skin_q <= difference_111;
      centres_values_0_exists_q <= select_63[2];
      centres_values_1_exists_q <= centres_values_0_exists_q;
      centres_values_2_exists_q <= centres_values_1_exists_q;
    end
  end

  logic centres_values_2_exists_s2_q;
  logic centres_values_2_marks_first_s2_q;
  logic centres_values_2_marks_last_s2_q;
  logic centres_values_2_marks_seen_s2_q;
  logic centres_values_2_marks_nearer_s2_q;
  logic total_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      centres_values_2_exists_s2_q <= centres_values_2_exists_q;
      centres_values_2_marks_first_s2_q <= centres_values_2_marks_first_s1_q;
      centres_values_2_marks_last_s2_q <= centres_values_2_marks_last_s1_q;
      centres_values_2_marks_seen_s2_q <= centres_values_2_marks_seen_s1_q;
      centres_values_2_marks_nearer_s2_q <= centres_values_2_marks_nearer_s1_q;
      total_s2_q <= total;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/consensus.hpp:75
  logic [4:0] select_113;
  assign select_113 = total_s2_q ? rest_exists_q[5:1] : sums_exists_q[5:1];
  logic less_115;
  assign less_115 = {1'b0, select_113} < (total_s2_q ? rest_skin_q : sums_skin_q);
  // hls/stages/consensus.hpp:77
  logic other;
  assign other = ~({1'b0, select_113} < (total_s2_q ? rest_clear_q : sums_clear_q));
  // hls/stages/consensus.hpp:78
  logic and_120;
  assign and_120 = other & (~less_115);

  logic centres_values_2_marks_first_s3_q;
  logic centres_values_2_marks_last_s3_q;
  logic centres_values_2_marks_seen_s3_q;
  logic centres_values_2_marks_nearer_s3_q;
  logic [1:0] select_121_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      centres_values_2_marks_first_s3_q <= centres_values_2_marks_first_s2_q;
      centres_values_2_marks_last_s3_q <= centres_values_2_marks_last_s2_q;
      centres_values_2_marks_seen_s3_q <= centres_values_2_marks_seen_s2_q;
      centres_values_2_marks_nearer_s3_q <= centres_values_2_marks_nearer_s2_q;
      select_121_s3_q <= centres_values_2_exists_s2_q ? {and_120, less_115} : 2'h3;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (memory_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = select_121_s3_q;
  assign marks_first_o = centres_values_2_marks_first_s3_q;
  assign marks_last_o = centres_values_2_marks_last_s3_q;
  assign marks_seen_o = centres_values_2_marks_seen_s3_q;
  assign marks_nearer_o = centres_values_2_marks_nearer_s3_q;
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

endmodule
