// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Consensus<horopter::hls::profiles::vga>, hls/stages/consensus.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 121 bits, pipeline 39 bits, memories 11520 bits.
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
  logic [9:0] raster_next_column_q;
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
  logic [9:0] select_47;
  assign select_47 = or_46 ? 10'h0 : raster_next_column_q;
  // hls/stages/consensus.hpp:94
  logic or_48;
  assign or_48 = marks_first_i | running_q;

  // Memory memory, 640 x 18, DISTANCE 16, hls/stages/consensus.hpp:102; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] memory_mem [0:639];
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 18'h0;
  logic [9:0] memory_raddr;
  assign memory_raddr = select_47;
  logic memory_re;
  assign memory_re = s0_en & or_48;
  logic [17:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_next_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
      centres_values_0_marks_first_q <= 1'b0;
      centres_values_0_marks_last_q <= 1'b0;
      centres_values_1_marks_first_q <= 1'b0;
      centres_values_1_marks_last_q <= 1'b0;
      centres_values_2_marks_first_q <= 1'b0;
      centres_values_2_marks_last_q <= 1'b0;
    end else if (s0_en) begin
      raster_next_column_q <= select_47 + 10'h1;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_48 : (marks_first_i & or_48);
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
  logic [9:0] select_47_s1_q;
  logic and_55_s1_q;
  logic and_59_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      exists_s1_q <= exists_i;
      running_s1_q <= running_q;
      centres_values_2_marks_first_s1_q <= centres_values_2_marks_first_q;
      centres_values_2_marks_last_s1_q <= centres_values_2_marks_last_q;
      or_46_s1_q <= or_46;
      select_47_s1_q <= select_47;
      and_55_s1_q <= clear_i & exists_i;
      and_59_s1_q <= skin_i & exists_i;
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
  logic centres_values_0_exists_q;
  logic centres_values_1_exists_q;
  logic centres_values_2_exists_q;
  // hls/stages/consensus.hpp:36
  logic and_51;
  assign and_51 = raster_rows_q & (~centres_values_0_marks_first_q);
  // hls/stages/consensus.hpp:40
  logic [5:0] select_53;
  assign select_53 = running_s1_q ? memory_rdata_q[5:0] : (centres_values_0_marks_first_q ? memory_rdata_q[5:0] : 6'h0);
  // hls/stages/consensus.hpp:43
  logic [5:0] select_54;
  assign select_54 = and_51 ? select_53 : 6'h0;
  // hls/stages/consensus.hpp:40
  logic [5:0] select_57;
  assign select_57 = running_s1_q ? memory_rdata_q[11:6] : (centres_values_0_marks_first_q ? memory_rdata_q[11:6] : 6'h0);
  // hls/stages/consensus.hpp:44
  logic [5:0] select_58;
  assign select_58 = and_51 ? select_57 : 6'h0;
  // hls/stages/consensus.hpp:40
  logic [5:0] select_61;
  assign select_61 = running_s1_q ? memory_rdata_q[17:12] : (centres_values_0_marks_first_q ? memory_rdata_q[17:12] : 6'h0);
  // hls/stages/consensus.hpp:45
  logic [5:0] select_62;
  assign select_62 = and_51 ? select_61 : 6'h0;
  // hls/stages/consensus.hpp:52
  logic [1:0] sum_68;
  assign sum_68 = {1'b0, select_54[1]} + ({1'b0, exists_s1_q} + {1'b0, select_54[0]});
  logic [2:0] sum_71;
  assign sum_71 = {2'h0, select_54[4]} + ({2'h0, select_54[3]} + ({2'h0, select_54[2]} + {1'b0, sum_68}));
  logic [2:0] entering;
  assign entering = {2'h0, select_54[5]} + sum_71;
  logic [1:0] sum_74;
  assign sum_74 = {1'b0, select_58[1]} + ({1'b0, and_55_s1_q} + {1'b0, select_58[0]});
  logic [2:0] sum_77;
  assign sum_77 = {2'h0, select_58[4]} + ({2'h0, select_58[3]} + ({2'h0, select_58[2]} + {1'b0, sum_74}));
  logic [2:0] entering_2;
  assign entering_2 = {2'h0, select_58[5]} + sum_77;
  logic [1:0] sum_80;
  assign sum_80 = {1'b0, select_62[1]} + ({1'b0, and_59_s1_q} + {1'b0, select_62[0]});
  logic [2:0] sum_83;
  assign sum_83 = {2'h0, select_62[4]} + ({2'h0, select_62[3]} + ({2'h0, select_62[2]} + {1'b0, sum_80}));
  logic [2:0] entering_3;
  assign entering_3 = {2'h0, select_62[5]} + sum_83;
  // hls/stages/consensus.hpp:55
  logic total;
  assign total = select_47_s1_q < 10'h3;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = select_47_s1_q;
  logic memory_we;
  assign memory_we = s1_en & running_q;
  always_ff @(posedge clk_i) begin
    if (memory_we) memory_mem[memory_waddr] <= {select_62[4:0], and_59_s1_q, select_58[4:0], and_55_s1_q, select_54[4:0], exists_s1_q};
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
      centres_values_0_exists_q <= 1'b0;
      centres_values_1_exists_q <= 1'b0;
      centres_values_2_exists_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_51;
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
      centres_values_0_exists_q <= select_54[2];
      centres_values_1_exists_q <= centres_values_0_exists_q;
      centres_values_2_exists_q <= centres_values_1_exists_q;
    end
  end

  logic [2:0] columns_values_6_exists_s2_q;
  logic [2:0] columns_values_6_clear_s2_q;
  logic [2:0] columns_values_6_skin_s2_q;
  logic centres_values_2_exists_s2_q;
  logic centres_values_2_marks_first_s2_q;
  logic centres_values_2_marks_last_s2_q;
  logic or_46_s2_q;
  logic less_86_s2_q;
  logic total_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      columns_values_6_exists_s2_q <= columns_values_6_exists_q;
      columns_values_6_clear_s2_q <= columns_values_6_clear_q;
      columns_values_6_skin_s2_q <= columns_values_6_skin_q;
      centres_values_2_exists_s2_q <= centres_values_2_exists_q;
      centres_values_2_marks_first_s2_q <= centres_values_2_marks_first_s1_q;
      centres_values_2_marks_last_s2_q <= centres_values_2_marks_last_s1_q;
      or_46_s2_q <= or_46_s1_q;
      less_86_s2_q <= 10'h6 < select_47_s1_q;
      total_s2_q <= total;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [5:0] sums_exists_q;
  logic [5:0] sums_clear_q;
  logic [5:0] sums_skin_q;
  logic [5:0] rest_exists_q;
  logic [5:0] rest_clear_q;
  logic [5:0] rest_skin_q;
  // hls/stages/consensus.hpp:99
  logic [2:0] select_87;
  assign select_87 = less_86_s2_q ? columns_values_6_exists_s2_q : 3'h0;
  logic [3:0] difference_88;
  assign difference_88 = {1'b0, columns_values_0_exists_q} - {1'b0, select_87};
  logic [5:0] sum_89;
  assign sum_89 = (or_46_s2_q ? 6'h0 : sums_exists_q) + {{2{difference_88[3]}}, difference_88};
  logic [2:0] select_91;
  assign select_91 = less_86_s2_q ? columns_values_6_clear_s2_q : 3'h0;
  logic [3:0] difference_92;
  assign difference_92 = {1'b0, columns_values_0_clear_q} - {1'b0, select_91};
  logic [5:0] sum_93;
  assign sum_93 = (or_46_s2_q ? 6'h0 : sums_clear_q) + {{2{difference_92[3]}}, difference_92};
  logic [2:0] select_95;
  assign select_95 = less_86_s2_q ? columns_values_6_skin_s2_q : 3'h0;
  logic [3:0] difference_96;
  assign difference_96 = {1'b0, columns_values_0_skin_q} - {1'b0, select_95};
  logic [5:0] sum_97;
  assign sum_97 = (or_46_s2_q ? 6'h0 : sums_skin_q) + {{2{difference_96[3]}}, difference_96};
  // hls/stages/consensus.hpp:62
  logic [5:0] difference_99;
  assign difference_99 = (or_46_s2_q ? sums_exists_q : rest_exists_q) - {3'h0, columns_values_6_exists_s2_q};
  // hls/stages/consensus.hpp:63
  logic [5:0] difference_101;
  assign difference_101 = (or_46_s2_q ? sums_clear_q : rest_clear_q) - {3'h0, columns_values_6_clear_s2_q};
  // hls/stages/consensus.hpp:64
  logic [5:0] difference_103;
  assign difference_103 = (or_46_s2_q ? sums_skin_q : rest_skin_q) - {3'h0, columns_values_6_skin_s2_q};
  // hls/stages/consensus.hpp:71
  logic [4:0] select_105;
  assign select_105 = total_s2_q ? difference_99[5:1] : sum_89[5:1];
  logic less_107;
  assign less_107 = {1'b0, select_105} < (total_s2_q ? difference_103 : sum_97);
  // hls/stages/consensus.hpp:73
  logic and_112;
  assign and_112 = (~({1'b0, select_105} < (total_s2_q ? difference_101 : sum_93))) & (~less_107);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sums_exists_q <= 6'h0;
      sums_clear_q <= 6'h0;
      sums_skin_q <= 6'h0;
      rest_exists_q <= 6'h0;
      rest_clear_q <= 6'h0;
      rest_skin_q <= 6'h0;
    end else if (s2_en) begin
      sums_exists_q <= sum_89;
      sums_clear_q <= sum_93;
      sums_skin_q <= sum_97;
      rest_exists_q <= difference_99;
      rest_clear_q <= difference_101;
      rest_skin_q <= difference_103;
    end
  end

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
