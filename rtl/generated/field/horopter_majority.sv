// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Majority<horopter::hls::profiles::field>, hls/stages/majority.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// Outputs are logic: what they go to takes them with the clock if en_i = 1.
// State 113 bits, pipeline 14 bits, memories 6804 bits.
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
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [8:0] raster_column_q;
  logic raster_row_ended_q;
  // hls/stages/majority.hpp:38
  logic or_20;
  assign or_20 = marks_first_i | raster_row_ended_q;
  logic [8:0] select_22;
  assign select_22 = or_20 ? 9'h0 : (raster_column_q + 9'h1);

  // Memory memory, 378 x 18, DISTANCE 16, hls/stages/majority.hpp:72; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] memory_mem [0:377];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 378; i++) memory_mem[i] = 18'h0;
`endif
  logic [8:0] memory_raddr;
  assign memory_raddr = select_22;
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
      raster_column_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_22;
      raster_row_ended_q <= marks_last_i;
    end
  end

  logic decidable_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic or_20_s1_q;
  logic and_24_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      decidable_s1_q <= decidable_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      or_20_s1_q <= or_20;
      and_24_s1_q <= skin_i & decidable_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  logic [11:0] sums_columns_values_0_q;
  logic [11:0] sums_columns_values_1_q;
  logic [11:0] sums_columns_values_2_q;
  logic [11:0] sums_columns_values_3_q;
  logic [11:0] sums_columns_values_4_q;
  logic [11:0] sums_columns_values_5_q;
  logic [11:0] sums_columns_values_6_q;
  logic [11:0] sums_sum_sums_values_0_q;
  logic [5:0] mask_columns_values_0_q;
  // hls/stages/majority.hpp:38
  logic and_26;
  assign and_26 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/majority.hpp:52
  logic [5:0] select_27;
  assign select_27 = and_26 ? memory_rdata_q[17:12] : 6'h0;
  // hls/stages/majority.hpp:49
  logic [1:0] sum_30;
  assign sum_30 = {1'b0, memory_rdata_q[7]} + ({1'b0, memory_rdata_q[6]} + {1'b0, and_24_s1_q});
  logic [2:0] sum_32;
  assign sum_32 = {2'h0, memory_rdata_q[9]} + ({2'h0, memory_rdata_q[8]} + {1'b0, sum_30});
  logic [2:0] sum_34;
  assign sum_34 = {2'h0, memory_rdata_q[11]} + ({2'h0, memory_rdata_q[10]} + sum_32);
  logic [1:0] sum_36;
  assign sum_36 = {1'b0, memory_rdata_q[1]} + ({1'b0, decidable_s1_q} + {1'b0, memory_rdata_q[0]});
  logic [2:0] sum_38;
  assign sum_38 = {2'h0, memory_rdata_q[3]} + ({2'h0, memory_rdata_q[2]} + {1'b0, sum_36});
  logic [2:0] sum_40;
  assign sum_40 = {2'h0, memory_rdata_q[5]} + ({2'h0, memory_rdata_q[4]} + sum_38);
  logic [11:0] difference_43;
  assign difference_43 = {3'h0, sum_40, 3'h0, sum_34} - ((9'h6 < raster_column_q) ? sums_columns_values_6_q : 12'h0);
  // hls/stages/majority.hpp:52
  logic equal_46;
  assign equal_46 = {select_27, mask_s1_q} == 7'h7f;
  logic [5:0] select_47;
  assign select_47 = or_20_s1_q ? 6'h0 : mask_columns_values_0_q;

  // Memory memory, write
  logic [8:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_27[4:0], mask_s1_q, memory_rdata_q[10:6], and_24_s1_q, memory_rdata_q[4:0], decidable_s1_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && memory_we) begin
      if (memory_re && memory_raddr == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_waddr >= 9'd378) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 9'd378) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_26;
    end
  end

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
    sums_sum_sums_values_0_q = 12'h0;
    mask_columns_values_0_q = 6'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      sums_columns_values_0_q <= {3'h0, sum_40, 3'h0, sum_34};
      sums_columns_values_1_q <= sums_columns_values_0_q;
      sums_columns_values_2_q <= sums_columns_values_1_q;
      sums_columns_values_3_q <= sums_columns_values_2_q;
      sums_columns_values_4_q <= sums_columns_values_3_q;
      sums_columns_values_5_q <= sums_columns_values_4_q;
      sums_columns_values_6_q <= sums_columns_values_5_q;
      sums_sum_sums_values_0_q <= difference_43 + (or_20_s1_q ? 12'h0 : sums_sum_sums_values_0_q);
      mask_columns_values_0_q <= {select_47[4:0], equal_46};
    end
  end

  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic equal_48_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      equal_48_s2_q <= {select_47, equal_46} == 7'h7f;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
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

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = equal_48_s2_q ? {not_52, and_51} : 2'h3;
  assign marks_first_o = marks_first_s2_q;
  assign marks_last_o = marks_last_s2_q;
  assign marks_seen_o = marks_seen_s2_q;
  assign marks_nearer_o = marks_nearer_s2_q;
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

endmodule
