// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Majority<horopter::hls::profiles::hd>, hls/stages/majority.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 115 bits, pipeline 185 bits, memories 34560 bits.
module horopter_majority (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic skin_i,
  input  logic decidable_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [1:0] state_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q;
  logic s0_en, s2_en, s3_en, s6_en, s7_en, s8_en;
  assign s0_en = en_i & valid_i;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] raster_column_q;
  logic raster_row_ended_q;
  // hls/stages/majority.hpp:38
  logic or_20;
  assign or_20 = marks_first_i | raster_row_ended_q;
  logic [10:0] select_21;
  assign select_21 = or_20 ? 11'h0 : raster_column_q;

  // Memory memory, 1920 x 18, DISTANCE 16, hls/stages/majority.hpp:72; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 18'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_21;
`ifndef SYNTHESIS
  logic memory_re;
  assign memory_re = s0_en;
`endif
  logic [17:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_21 + 11'h1;
      raster_row_ended_q <= marks_last_i;
    end
  end

  logic decidable_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic or_20_s1_q;
  logic [10:0] select_21_s1_q;
  logic and_23_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      decidable_s1_q <= decidable_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      or_20_s1_q <= or_20;
      select_21_s1_q <= select_21;
      and_23_s1_q <= skin_i & decidable_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic decidable_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic or_20_s2_q;
  logic [10:0] select_21_s2_q;
  logic [17:0] memory_rdata_s2_q;
  logic and_23_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      decidable_s2_q <= decidable_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      or_20_s2_q <= or_20_s1_q;
      select_21_s2_q <= select_21_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
      and_23_s2_q <= and_23_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  logic [5:0] mask_columns_values_0_q;
  // hls/stages/majority.hpp:38
  logic and_25;
  assign and_25 = raster_rows_q & (~marks_first_s2_q);
  // hls/stages/majority.hpp:52
  logic [5:0] select_26;
  assign select_26 = and_25 ? memory_rdata_s2_q[17:12] : 6'h0;
  // hls/stages/majority.hpp:49
  logic [1:0] sum_30;
  assign sum_30 = {1'b0, memory_rdata_s2_q[7]} + ({1'b0, memory_rdata_s2_q[6]} + {1'b0, and_23_s2_q});
  logic [1:0] sum_36;
  assign sum_36 = {1'b0, memory_rdata_s2_q[1]} + ({1'b0, decidable_s2_q} + {1'b0, memory_rdata_s2_q[0]});
  // hls/stages/majority.hpp:52
  logic equal_46;
  assign equal_46 = {select_26, mask_s2_q} == 7'h7f;
  logic [5:0] select_47;
  assign select_47 = or_20_s2_q ? 6'h0 : mask_columns_values_0_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s2_en) begin
      raster_rows_q <= marks_last_s2_q | and_25;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    mask_columns_values_0_q = 6'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      mask_columns_values_0_q <= {select_47[4:0], equal_46};
    end
  end

  logic decidable_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic or_20_s3_q;
  logic [10:0] select_21_s3_q;
  logic [11:0] memory_rdata_s3_q;
  logic and_23_s3_q;
  logic [4:0] select_26_s3_q;
  logic [1:0] sum_30_s3_q;
  logic [1:0] sum_36_s3_q;
  logic select_47_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      decidable_s3_q <= decidable_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      or_20_s3_q <= or_20_s2_q;
      select_21_s3_q <= select_21_s2_q;
      memory_rdata_s3_q <= memory_rdata_s2_q[11:0];
      and_23_s3_q <= and_23_s2_q;
      select_26_s3_q <= select_26[4:0];
      sum_30_s3_q <= sum_30;
      sum_36_s3_q <= sum_36;
      select_47_s3_q <= select_47[5];
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_21_s3_q;
  logic memory_we;
  assign memory_we = s3_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_26_s3_q, mask_s3_q, memory_rdata_s3_q[10:6], and_23_s3_q, memory_rdata_s3_q[4:0], decidable_s3_q};
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

  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic or_20_s4_q;
  logic [5:0] memory_rdata_s4_q;
  logic [2:0] sum_31_s4_q;
  logic [2:0] sum_37_s4_q;
  logic less_41_s4_q;
  logic equal_48_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      or_20_s4_q <= or_20_s3_q;
      memory_rdata_s4_q <= {memory_rdata_s3_q[11:9], memory_rdata_s3_q[5:3]};
      sum_31_s4_q <= {2'h0, memory_rdata_s3_q[8]} + {1'b0, sum_30_s3_q};
      sum_37_s4_q <= {2'h0, memory_rdata_s3_q[2]} + {1'b0, sum_36_s3_q};
      less_41_s4_q <= 11'h6 < select_21_s3_q;
      equal_48_s4_q <= {select_47_s3_q, mask_columns_values_0_q} == 7'h7f;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------

  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic or_20_s5_q;
  logic [3:0] memory_rdata_s5_q;
  logic [2:0] sum_32_s5_q;
  logic [2:0] sum_38_s5_q;
  logic less_41_s5_q;
  logic equal_48_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      or_20_s5_q <= or_20_s4_q;
      memory_rdata_s5_q <= {memory_rdata_s4_q[5:4], memory_rdata_s4_q[2:1]};
      sum_32_s5_q <= {2'h0, memory_rdata_s4_q[3]} + sum_31_s4_q;
      sum_38_s5_q <= {2'h0, memory_rdata_s4_q[0]} + sum_37_s4_q;
      less_41_s5_q <= less_41_s4_q;
      equal_48_s5_q <= equal_48_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_seen_s6_q;
  logic marks_nearer_s6_q;
  logic or_20_s6_q;
  logic [1:0] memory_rdata_s6_q;
  logic [2:0] sum_33_s6_q;
  logic [2:0] sum_39_s6_q;
  logic less_41_s6_q;
  logic equal_48_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_seen_s6_q <= marks_seen_s5_q;
      marks_nearer_s6_q <= marks_nearer_s5_q;
      or_20_s6_q <= or_20_s5_q;
      memory_rdata_s6_q <= {memory_rdata_s5_q[3], memory_rdata_s5_q[1]};
      sum_33_s6_q <= {2'h0, memory_rdata_s5_q[2]} + sum_32_s5_q;
      sum_39_s6_q <= {2'h0, memory_rdata_s5_q[0]} + sum_38_s5_q;
      less_41_s6_q <= less_41_s5_q;
      equal_48_s6_q <= equal_48_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [11:0] sums_columns_values_0_q;
  logic [11:0] sums_columns_values_1_q;
  logic [11:0] sums_columns_values_2_q;
  logic [11:0] sums_columns_values_3_q;
  logic [11:0] sums_columns_values_4_q;
  logic [11:0] sums_columns_values_5_q;
  logic [11:0] sums_columns_values_6_q;
  // hls/stages/majority.hpp:49
  logic [2:0] sum_34;
  assign sum_34 = {2'h0, memory_rdata_s6_q[1]} + sum_33_s6_q;
  logic [2:0] sum_40;
  assign sum_40 = {2'h0, memory_rdata_s6_q[0]} + sum_39_s6_q;

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_columns_values_0_q = 12'h0;
    sums_columns_values_1_q = 12'h0;
    sums_columns_values_2_q = 12'h0;
    sums_columns_values_3_q = 12'h0;
    sums_columns_values_4_q = 12'h0;
    sums_columns_values_5_q = 12'h0;
    sums_columns_values_6_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s6_en) begin
      sums_columns_values_0_q <= {3'h0, sum_40, 3'h0, sum_34};
      sums_columns_values_1_q <= sums_columns_values_0_q;
      sums_columns_values_2_q <= sums_columns_values_1_q;
      sums_columns_values_3_q <= sums_columns_values_2_q;
      sums_columns_values_4_q <= sums_columns_values_3_q;
      sums_columns_values_5_q <= sums_columns_values_4_q;
      sums_columns_values_6_q <= sums_columns_values_5_q;
    end
  end

  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_seen_s7_q;
  logic marks_nearer_s7_q;
  logic or_20_s7_q;
  logic [11:0] select_42_s7_q;
  logic equal_48_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_seen_s7_q <= marks_seen_s6_q;
      marks_nearer_s7_q <= marks_nearer_s6_q;
      or_20_s7_q <= or_20_s6_q;
      select_42_s7_q <= less_41_s6_q ? sums_columns_values_6_q : 12'h0;
      equal_48_s7_q <= equal_48_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [11:0] sums_sum_sums_values_0_q;
  // hls/stages/majority.hpp:49
  logic [11:0] difference_43;
  assign difference_43 = {3'h0, sums_columns_values_0_q[8:6], 3'h0, sums_columns_values_0_q[2:0]} - select_42_s7_q;

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_sum_sums_values_0_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s7_en) begin
      sums_sum_sums_values_0_q <= difference_43 + (or_20_s7_q ? 12'h0 : sums_sum_sums_values_0_q);
    end
  end

  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_seen_s8_q;
  logic marks_nearer_s8_q;
  logic equal_48_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_seen_s8_q <= marks_seen_s7_q;
      marks_nearer_s8_q <= marks_nearer_s7_q;
      equal_48_s8_q <= equal_48_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/majority.hpp:57
  logic less_49;
  assign less_49 = 6'h18 < sums_sum_sums_values_0_q[11:6];
  // hls/stages/majority.hpp:58
  logic vote;
  assign vote = {1'b0, sums_sum_sums_values_0_q[11:7]} < sums_sum_sums_values_0_q[5:0];
  // hls/stages/majority.hpp:59
  logic and_51;
  assign and_51 = less_49 & vote;
  logic not_52;
  assign not_52 = ~less_49;

  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic marks_seen_s9_q;
  logic marks_nearer_s9_q;
  logic [1:0] select_53_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      marks_seen_s9_q <= marks_seen_s8_q;
      marks_nearer_s9_q <= marks_nearer_s8_q;
      select_53_s9_q <= equal_48_s8_q ? {not_52, and_51} : 2'h3;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = select_53_s9_q;
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
