// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Consensus<horopter::hls::profiles::vga>, hls/stages/consensus.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 121 bits, pipeline 18 bits, memories 11520 bits.
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
  output logic valid_o,
  output logic [1:0] state_o,
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
  logic [9:0] raster_column_q;
  logic raster_row_ended_q;
  logic running_q;
  logic centres_values_0_marks_first_q;
  logic centres_values_0_marks_last_q;
  logic centres_values_1_marks_first_q;
  logic centres_values_1_marks_last_q;
  logic centres_values_2_marks_first_q;
  logic centres_values_2_marks_last_q;
  // hls/stages/consensus.hpp:36
  logic or_46;
  assign or_46 = marks_first_i | raster_row_ended_q;
  logic [9:0] select_48;
  assign select_48 = or_46 ? 10'h0 : (raster_column_q + 10'h1);
  // hls/stages/consensus.hpp:94
  logic or_49;
  assign or_49 = marks_first_i | running_q;

  // Memory memory, 640 x 18, DISTANCE 16, hls/stages/consensus.hpp:102; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 18'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = select_48;
  logic memory_re;
  assign memory_re = s0_en & or_49;
  logic [17:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
      centres_values_0_marks_first_q <= 1'b0;
      centres_values_0_marks_last_q <= 1'b0;
      centres_values_1_marks_first_q <= 1'b0;
      centres_values_1_marks_last_q <= 1'b0;
      centres_values_2_marks_first_q <= 1'b0;
      centres_values_2_marks_last_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_48;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_49 : (marks_first_i & or_49);
      centres_values_0_marks_first_q <= marks_first_i;
      centres_values_0_marks_last_q <= marks_last_i;
      centres_values_1_marks_first_q <= centres_values_0_marks_first_q;
      centres_values_1_marks_last_q <= centres_values_0_marks_last_q;
      centres_values_2_marks_first_q <= centres_values_1_marks_first_q;
      centres_values_2_marks_last_q <= centres_values_1_marks_last_q;
    end
  end

  logic exists_s1_q;
  logic running_s1_q;
  logic centres_values_2_marks_first_s1_q;
  logic centres_values_2_marks_last_s1_q;
  logic or_46_s1_q;
  logic and_56_s1_q;
  logic and_60_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      exists_s1_q <= exists_i;
      running_s1_q <= running_q;
      centres_values_2_marks_first_s1_q <= centres_values_2_marks_first_q;
      centres_values_2_marks_last_s1_q <= centres_values_2_marks_last_q;
      or_46_s1_q <= or_46;
      and_56_s1_q <= clear_i & exists_i;
      and_60_s1_q <= skin_i & exists_i;
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
  // hls/stages/consensus.hpp:36
  logic and_52;
  assign and_52 = raster_rows_q & (~centres_values_0_marks_first_q);
  // hls/stages/consensus.hpp:40
  logic [5:0] select_54;
  assign select_54 = running_s1_q ? memory_rdata_q[5:0] : (centres_values_0_marks_first_q ? memory_rdata_q[5:0] : 6'h0);
  // hls/stages/consensus.hpp:43
  logic [5:0] select_55;
  assign select_55 = and_52 ? select_54 : 6'h0;
  // hls/stages/consensus.hpp:40
  logic [5:0] select_58;
  assign select_58 = running_s1_q ? memory_rdata_q[11:6] : (centres_values_0_marks_first_q ? memory_rdata_q[11:6] : 6'h0);
  // hls/stages/consensus.hpp:44
  logic [5:0] select_59;
  assign select_59 = and_52 ? select_58 : 6'h0;
  // hls/stages/consensus.hpp:40
  logic [5:0] select_62;
  assign select_62 = running_s1_q ? memory_rdata_q[17:12] : (centres_values_0_marks_first_q ? memory_rdata_q[17:12] : 6'h0);
  // hls/stages/consensus.hpp:45
  logic [5:0] select_63;
  assign select_63 = and_52 ? select_62 : 6'h0;
  // hls/stages/consensus.hpp:52
  logic [1:0] sum_68;
  assign sum_68 = {1'b0, select_55[1]} + ({1'b0, exists_s1_q} + {1'b0, select_55[0]});
  logic [2:0] sum_71;
  assign sum_71 = {2'h0, select_55[4]} + ({2'h0, select_55[3]} + ({2'h0, select_55[2]} + {1'b0, sum_68}));
  logic [2:0] entering;
  assign entering = {2'h0, select_55[5]} + sum_71;
  logic [1:0] sum_74;
  assign sum_74 = {1'b0, select_59[1]} + ({1'b0, and_56_s1_q} + {1'b0, select_59[0]});
  logic [2:0] sum_77;
  assign sum_77 = {2'h0, select_59[4]} + ({2'h0, select_59[3]} + ({2'h0, select_59[2]} + {1'b0, sum_74}));
  logic [2:0] entering_2;
  assign entering_2 = {2'h0, select_59[5]} + sum_77;
  logic [1:0] sum_80;
  assign sum_80 = {1'b0, select_63[1]} + ({1'b0, and_60_s1_q} + {1'b0, select_63[0]});
  logic [2:0] sum_83;
  assign sum_83 = {2'h0, select_63[4]} + ({2'h0, select_63[3]} + ({2'h0, select_63[2]} + {1'b0, sum_80}));
  logic [2:0] entering_3;
  assign entering_3 = {2'h0, select_63[5]} + sum_83;
  // hls/stages/consensus.hpp:58
  logic less_86;
  assign less_86 = 10'h6 < raster_column_q;
  // hls/stages/consensus.hpp:99
  logic [2:0] select_87;
  assign select_87 = less_86 ? columns_values_6_exists_q : 3'h0;
  logic [3:0] difference_88;
  assign difference_88 = {1'b0, entering} - {1'b0, select_87};
  logic [5:0] sum_89;
  assign sum_89 = (or_46_s1_q ? 6'h0 : sums_exists_q) + {{2{difference_88[3]}}, difference_88};
  logic [2:0] select_91;
  assign select_91 = less_86 ? columns_values_6_clear_q : 3'h0;
  logic [3:0] difference_92;
  assign difference_92 = {1'b0, entering_2} - {1'b0, select_91};
  logic [5:0] sum_93;
  assign sum_93 = (or_46_s1_q ? 6'h0 : sums_clear_q) + {{2{difference_92[3]}}, difference_92};
  logic [2:0] select_95;
  assign select_95 = less_86 ? columns_values_6_skin_q : 3'h0;
  logic [3:0] difference_96;
  assign difference_96 = {1'b0, entering_3} - {1'b0, select_95};
  logic [5:0] sum_97;
  assign sum_97 = (or_46_s1_q ? 6'h0 : sums_skin_q) + {{2{difference_96[3]}}, difference_96};
  // hls/stages/consensus.hpp:62
  logic [5:0] difference_99;
  assign difference_99 = (or_46_s1_q ? sums_exists_q : rest_exists_q) - {3'h0, columns_values_6_exists_q};
  // hls/stages/consensus.hpp:63
  logic [5:0] difference_101;
  assign difference_101 = (or_46_s1_q ? sums_clear_q : rest_clear_q) - {3'h0, columns_values_6_clear_q};
  // hls/stages/consensus.hpp:64
  logic [5:0] difference_103;
  assign difference_103 = (or_46_s1_q ? sums_skin_q : rest_skin_q) - {3'h0, columns_values_6_skin_q};
  // hls/stages/consensus.hpp:55
  logic total;
  assign total = raster_column_q < 10'h3;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en & running_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_63[4:0], and_60_s1_q, select_59[4:0], and_56_s1_q, select_55[4:0], exists_s1_q};
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
      raster_rows_q <= raster_row_ended_q | and_52;
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
      sums_exists_q <= sum_89;
      sums_clear_q <= sum_93;
      sums_skin_q <= sum_97;
      rest_exists_q <= difference_99;
      rest_clear_q <= difference_101;
      rest_skin_q <= difference_103;
      centres_values_0_exists_q <= select_55[2];
      centres_values_1_exists_q <= centres_values_0_exists_q;
      centres_values_2_exists_q <= centres_values_1_exists_q;
    end
  end

  logic centres_values_2_exists_s2_q;
  logic centres_values_2_marks_first_s2_q;
  logic centres_values_2_marks_last_s2_q;
  logic total_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      centres_values_2_exists_s2_q <= centres_values_2_exists_q;
      centres_values_2_marks_first_s2_q <= centres_values_2_marks_first_s1_q;
      centres_values_2_marks_last_s2_q <= centres_values_2_marks_last_s1_q;
      total_s2_q <= total;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/consensus.hpp:71
  logic [4:0] select_105;
  assign select_105 = total_s2_q ? rest_exists_q[5:1] : sums_exists_q[5:1];
  logic less_107;
  assign less_107 = {1'b0, select_105} < (total_s2_q ? rest_skin_q : sums_skin_q);
  // hls/stages/consensus.hpp:73
  logic not_110;
  assign not_110 = ~({1'b0, select_105} < (total_s2_q ? rest_clear_q : sums_clear_q));
  logic and_112;
  assign and_112 = not_110 & (~less_107);

  logic centres_values_2_marks_first_s3_q;
  logic centres_values_2_marks_last_s3_q;
  logic [1:0] select_113_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      centres_values_2_marks_first_s3_q <= centres_values_2_marks_first_s2_q;
      centres_values_2_marks_last_s3_q <= centres_values_2_marks_last_s2_q;
      select_113_s3_q <= centres_values_2_exists_s2_q ? {and_112, less_107} : 2'h3;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = select_113_s3_q;
  assign marks_first_o = centres_values_2_marks_first_s3_q;
  assign marks_last_o = centres_values_2_marks_last_s3_q;
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
