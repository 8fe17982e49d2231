// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Consensus<horopter::hls::profiles::hd>, hls/stages/consensus.hpp. Do not edit.
//
// Latency 8 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 122 bits, pipeline 163 bits, memories 34560 bits.
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
  // hls/stages/consensus.hpp:36
  logic or_46;
  assign or_46 = marks_first_i | raster_row_ended_q;
  logic [10:0] select_47;
  assign select_47 = or_46 ? 11'h0 : raster_column_q;
  // hls/stages/consensus.hpp:94
  logic or_48;
  assign or_48 = marks_first_i | running_q;

  // Memory memory, 1920 x 18, DISTANCE 16, hls/stages/consensus.hpp:102; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 18'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_47;
  logic memory_re;
  assign memory_re = s0_en & or_48;
  logic [17:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_47 + 11'h1;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_48 : (marks_first_i & or_48);
    end
  end

  logic exists_s1_q;
  logic marks_first_s1_q;
  logic running_s1_q;
  logic or_46_s1_q;
  logic [10:0] select_47_s1_q;
  logic and_55_s1_q;
  logic and_59_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      exists_s1_q <= exists_i;
      marks_first_s1_q <= marks_first_i;
      running_s1_q <= running_q;
      or_46_s1_q <= or_46;
      select_47_s1_q <= select_47;
      and_55_s1_q <= clear_i & exists_i;
      and_59_s1_q <= skin_i & exists_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic centres_values_0_marks_first_q;
  logic centres_values_0_marks_last_q;
  logic centres_values_1_marks_first_q;
  logic centres_values_1_marks_last_q;
  logic centres_values_2_marks_first_q;
  logic centres_values_2_marks_last_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      centres_values_0_marks_first_q <= 1'b0;
      centres_values_0_marks_last_q <= 1'b0;
      centres_values_1_marks_first_q <= 1'b0;
      centres_values_1_marks_last_q <= 1'b0;
      centres_values_2_marks_first_q <= 1'b0;
      centres_values_2_marks_last_q <= 1'b0;
    end else if (s1_en) begin
      centres_values_0_marks_first_q <= marks_first_s1_q;
      centres_values_0_marks_last_q <= raster_row_ended_q;
      centres_values_1_marks_first_q <= centres_values_0_marks_first_q;
      centres_values_1_marks_last_q <= centres_values_0_marks_last_q;
      centres_values_2_marks_first_q <= centres_values_1_marks_first_q;
      centres_values_2_marks_last_q <= centres_values_1_marks_last_q;
    end
  end

  logic exists_s2_q;
  logic running_s2_q;
  logic centres_values_2_marks_first_s2_q;
  logic centres_values_2_marks_last_s2_q;
  logic or_46_s2_q;
  logic [10:0] select_47_s2_q;
  logic [17:0] memory_rdata_s2_q;
  logic and_55_s2_q;
  logic and_59_s2_q;
  logic select_64_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      exists_s2_q <= exists_s1_q;
      running_s2_q <= running_s1_q;
      centres_values_2_marks_first_s2_q <= centres_values_2_marks_first_q;
      centres_values_2_marks_last_s2_q <= centres_values_2_marks_last_q;
      or_46_s2_q <= or_46_s1_q;
      select_47_s2_q <= select_47_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
      and_55_s2_q <= and_55_s1_q;
      and_59_s2_q <= and_59_s1_q;
      select_64_s2_q <= running_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  logic centres_values_0_exists_q;
  logic centres_values_1_exists_q;
  logic centres_values_2_exists_q;
  // hls/stages/consensus.hpp:36
  logic and_51;
  assign and_51 = raster_rows_q & (~centres_values_0_marks_first_q);
  // hls/stages/consensus.hpp:40
  logic [5:0] select_53;
  assign select_53 = running_s2_q ? memory_rdata_s2_q[5:0] : (centres_values_0_marks_first_q ? memory_rdata_s2_q[5:0] : 6'h0);
  // hls/stages/consensus.hpp:43
  logic [5:0] select_54;
  assign select_54 = and_51 ? select_53 : 6'h0;
  // hls/stages/consensus.hpp:40
  logic [5:0] select_57;
  assign select_57 = running_s2_q ? memory_rdata_s2_q[11:6] : (centres_values_0_marks_first_q ? memory_rdata_s2_q[11:6] : 6'h0);
  logic [5:0] select_61;
  assign select_61 = running_s2_q ? memory_rdata_s2_q[17:12] : (centres_values_0_marks_first_q ? memory_rdata_s2_q[17:12] : 6'h0);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
      centres_values_0_exists_q <= 1'b0;
      centres_values_1_exists_q <= 1'b0;
      centres_values_2_exists_q <= 1'b0;
    end else if (s2_en) begin
      raster_rows_q <= centres_values_0_marks_last_q | and_51;
      centres_values_0_exists_q <= select_54[2];
      centres_values_1_exists_q <= centres_values_0_exists_q;
      centres_values_2_exists_q <= centres_values_1_exists_q;
    end
  end

  logic exists_s3_q;
  logic centres_values_2_exists_s3_q;
  logic centres_values_2_marks_first_s3_q;
  logic centres_values_2_marks_last_s3_q;
  logic or_46_s3_q;
  logic [10:0] select_47_s3_q;
  logic [4:0] select_54_s3_q;
  logic and_55_s3_q;
  logic [5:0] select_58_s3_q;
  logic and_59_s3_q;
  logic [5:0] select_62_s3_q;
  logic select_64_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      exists_s3_q <= exists_s2_q;
      centres_values_2_exists_s3_q <= centres_values_2_exists_q;
      centres_values_2_marks_first_s3_q <= centres_values_2_marks_first_s2_q;
      centres_values_2_marks_last_s3_q <= centres_values_2_marks_last_s2_q;
      or_46_s3_q <= or_46_s2_q;
      select_47_s3_q <= select_47_s2_q;
      select_54_s3_q <= {select_54[5:3], select_54[1:0]};
      and_55_s3_q <= and_55_s2_q;
      select_58_s3_q <= and_51 ? select_57 : 6'h0;
      and_59_s3_q <= and_59_s2_q;
      select_62_s3_q <= and_51 ? select_61 : 6'h0;
      select_64_s3_q <= select_64_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/consensus.hpp:52
  logic [1:0] sum_68;
  assign sum_68 = {1'b0, select_54_s3_q[1]} + ({1'b0, exists_s3_q} + {1'b0, select_54_s3_q[0]});
  logic [1:0] sum_74;
  assign sum_74 = {1'b0, select_58_s3_q[1]} + ({1'b0, and_55_s3_q} + {1'b0, select_58_s3_q[0]});
  logic [1:0] sum_80;
  assign sum_80 = {1'b0, select_62_s3_q[1]} + ({1'b0, and_59_s3_q} + {1'b0, select_62_s3_q[0]});
  // hls/stages/consensus.hpp:55
  logic total;
  assign total = select_47_s3_q < 11'h3;

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_47_s3_q;
  logic memory_we;
  assign memory_we = s3_en & select_64_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_62_s3_q[4:0], and_59_s3_q, select_58_s3_q[4:0], and_55_s3_q, select_54_s3_q[3:2], centres_values_0_exists_q, select_54_s3_q[1:0], exists_s3_q};
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

  logic centres_values_2_exists_s4_q;
  logic centres_values_2_marks_first_s4_q;
  logic centres_values_2_marks_last_s4_q;
  logic or_46_s4_q;
  logic [2:0] select_54_s4_q;
  logic [2:0] select_58_s4_q;
  logic [2:0] select_62_s4_q;
  logic [2:0] sum_69_s4_q;
  logic [2:0] sum_75_s4_q;
  logic [2:0] sum_81_s4_q;
  logic less_86_s4_q;
  logic total_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      centres_values_2_exists_s4_q <= centres_values_2_exists_s3_q;
      centres_values_2_marks_first_s4_q <= centres_values_2_marks_first_s3_q;
      centres_values_2_marks_last_s4_q <= centres_values_2_marks_last_s3_q;
      or_46_s4_q <= or_46_s3_q;
      select_54_s4_q <= select_54_s3_q[4:2];
      select_58_s4_q <= select_58_s3_q[5:3];
      select_62_s4_q <= select_62_s3_q[5:3];
      sum_69_s4_q <= {2'h0, centres_values_0_exists_q} + {1'b0, sum_68};
      sum_75_s4_q <= {2'h0, select_58_s3_q[2]} + {1'b0, sum_74};
      sum_81_s4_q <= {2'h0, select_62_s3_q[2]} + {1'b0, sum_80};
      less_86_s4_q <= 11'h6 < select_47_s3_q;
      total_s4_q <= total;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/consensus.hpp:52
  logic [2:0] sum_71;
  assign sum_71 = {2'h0, select_54_s4_q[1]} + ({2'h0, select_54_s4_q[0]} + sum_69_s4_q);
  logic [2:0] sum_77;
  assign sum_77 = {2'h0, select_58_s4_q[1]} + ({2'h0, select_58_s4_q[0]} + sum_75_s4_q);
  logic [2:0] sum_83;
  assign sum_83 = {2'h0, select_62_s4_q[1]} + ({2'h0, select_62_s4_q[0]} + sum_81_s4_q);

  logic centres_values_2_exists_s5_q;
  logic centres_values_2_marks_first_s5_q;
  logic centres_values_2_marks_last_s5_q;
  logic or_46_s5_q;
  logic select_54_s5_q;
  logic select_58_s5_q;
  logic select_62_s5_q;
  logic [2:0] sum_71_s5_q;
  logic [2:0] sum_77_s5_q;
  logic [2:0] sum_83_s5_q;
  logic less_86_s5_q;
  logic total_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      centres_values_2_exists_s5_q <= centres_values_2_exists_s4_q;
      centres_values_2_marks_first_s5_q <= centres_values_2_marks_first_s4_q;
      centres_values_2_marks_last_s5_q <= centres_values_2_marks_last_s4_q;
      or_46_s5_q <= or_46_s4_q;
      select_54_s5_q <= select_54_s4_q[2];
      select_58_s5_q <= select_58_s4_q[2];
      select_62_s5_q <= select_62_s4_q[2];
      sum_71_s5_q <= sum_71;
      sum_77_s5_q <= sum_77;
      sum_83_s5_q <= sum_83;
      less_86_s5_q <= less_86_s4_q;
      total_s5_q <= total_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/consensus.hpp:52
  logic [2:0] entering;
  assign entering = {2'h0, select_54_s5_q} + sum_71_s5_q;
  logic [2:0] entering_2;
  assign entering_2 = {2'h0, select_58_s5_q} + sum_77_s5_q;
  logic [2:0] entering_3;
  assign entering_3 = {2'h0, select_62_s5_q} + sum_83_s5_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
    end else if (s5_en) begin
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
    end
  end

  logic [2:0] columns_values_6_exists_s6_q;
  logic [2:0] columns_values_6_clear_s6_q;
  logic [2:0] columns_values_6_skin_s6_q;
  logic centres_values_2_exists_s6_q;
  logic centres_values_2_marks_first_s6_q;
  logic centres_values_2_marks_last_s6_q;
  logic or_46_s6_q;
  logic less_86_s6_q;
  logic total_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      columns_values_6_exists_s6_q <= columns_values_6_exists_q;
      columns_values_6_clear_s6_q <= columns_values_6_clear_q;
      columns_values_6_skin_s6_q <= columns_values_6_skin_q;
      centres_values_2_exists_s6_q <= centres_values_2_exists_s5_q;
      centres_values_2_marks_first_s6_q <= centres_values_2_marks_first_s5_q;
      centres_values_2_marks_last_s6_q <= centres_values_2_marks_last_s5_q;
      or_46_s6_q <= or_46_s5_q;
      less_86_s6_q <= less_86_s5_q;
      total_s6_q <= total_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [5:0] sums_exists_q;
  logic [5:0] sums_clear_q;
  logic [5:0] sums_skin_q;
  logic [5:0] rest_exists_q;
  logic [5:0] rest_clear_q;
  logic [5:0] rest_skin_q;
  // hls/stages/consensus.hpp:99
  logic [2:0] select_87;
  assign select_87 = less_86_s6_q ? columns_values_6_exists_s6_q : 3'h0;
  logic [3:0] difference_88;
  assign difference_88 = {1'b0, columns_values_0_exists_q} - {1'b0, select_87};
  logic [5:0] sum_89;
  assign sum_89 = (or_46_s6_q ? 6'h0 : sums_exists_q) + {{2{difference_88[3]}}, difference_88};
  logic [2:0] select_91;
  assign select_91 = less_86_s6_q ? columns_values_6_clear_s6_q : 3'h0;
  logic [3:0] difference_92;
  assign difference_92 = {1'b0, columns_values_0_clear_q} - {1'b0, select_91};
  logic [5:0] sum_93;
  assign sum_93 = (or_46_s6_q ? 6'h0 : sums_clear_q) + {{2{difference_92[3]}}, difference_92};
  logic [2:0] select_95;
  assign select_95 = less_86_s6_q ? columns_values_6_skin_s6_q : 3'h0;
  logic [3:0] difference_96;
  assign difference_96 = {1'b0, columns_values_0_skin_q} - {1'b0, select_95};
  logic [5:0] sum_97;
  assign sum_97 = (or_46_s6_q ? 6'h0 : sums_skin_q) + {{2{difference_96[3]}}, difference_96};
  // hls/stages/consensus.hpp:62
  logic [5:0] difference_99;
  assign difference_99 = (or_46_s6_q ? sums_exists_q : rest_exists_q) - {3'h0, columns_values_6_exists_s6_q};
  // hls/stages/consensus.hpp:63
  logic [5:0] difference_101;
  assign difference_101 = (or_46_s6_q ? sums_clear_q : rest_clear_q) - {3'h0, columns_values_6_clear_s6_q};
  // hls/stages/consensus.hpp:64
  logic [5:0] difference_103;
  assign difference_103 = (or_46_s6_q ? sums_skin_q : rest_skin_q) - {3'h0, columns_values_6_skin_s6_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sums_exists_q <= 6'h0;
      sums_clear_q <= 6'h0;
      sums_skin_q <= 6'h0;
      rest_exists_q <= 6'h0;
      rest_clear_q <= 6'h0;
      rest_skin_q <= 6'h0;
    end else if (s6_en) begin
      sums_exists_q <= sum_89;
      sums_clear_q <= sum_93;
      sums_skin_q <= sum_97;
      rest_exists_q <= difference_99;
      rest_clear_q <= difference_101;
      rest_skin_q <= difference_103;
    end
  end

  logic centres_values_2_exists_s7_q;
  logic centres_values_2_marks_first_s7_q;
  logic centres_values_2_marks_last_s7_q;
  logic total_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      centres_values_2_exists_s7_q <= centres_values_2_exists_s6_q;
      centres_values_2_marks_first_s7_q <= centres_values_2_marks_first_s6_q;
      centres_values_2_marks_last_s7_q <= centres_values_2_marks_last_s6_q;
      total_s7_q <= total_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/consensus.hpp:71
  logic [4:0] select_105;
  assign select_105 = total_s7_q ? rest_exists_q[5:1] : sums_exists_q[5:1];
  logic less_107;
  assign less_107 = {1'b0, select_105} < (total_s7_q ? rest_skin_q : sums_skin_q);
  // hls/stages/consensus.hpp:73
  logic not_110;
  assign not_110 = ~({1'b0, select_105} < (total_s7_q ? rest_clear_q : sums_clear_q));
  logic and_112;
  assign and_112 = not_110 & (~less_107);

  logic centres_values_2_marks_first_s8_q;
  logic centres_values_2_marks_last_s8_q;
  logic [1:0] select_113_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      centres_values_2_marks_first_s8_q <= centres_values_2_marks_first_s7_q;
      centres_values_2_marks_last_s8_q <= centres_values_2_marks_last_s7_q;
      select_113_s8_q <= centres_values_2_exists_s7_q ? {and_112, less_107} : 2'h3;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = select_113_s8_q;
  assign marks_first_o = centres_values_2_marks_first_s8_q;
  assign marks_last_o = centres_values_2_marks_last_s8_q;
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

endmodule
