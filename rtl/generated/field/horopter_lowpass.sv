// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Lowpass<horopter::hls::profiles::field>, hls/stages/lowpass.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// Outputs are logic: what they go to takes them with the clock if en_i = 1.
// State 60 bits, pipeline 15 bits, memories 15120 bits.
module horopter_lowpass (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [7:0] pixel_0_o,
  output logic saturated_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [9:0] raster_column_q;
  logic raster_row_ended_q;
  // hls/stages/lowpass.hpp:27
  logic or_19;
  assign or_19 = marks_first_i | raster_row_ended_q;
  logic [9:0] select_21;
  assign select_21 = or_19 ? 10'h0 : (raster_column_q + 10'h1);

  // Memory memory, 756 x 20, DISTANCE 16, hls/stages/lowpass.hpp:58; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [19:0] memory_mem [0:755];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 756; i++) memory_mem[i] = 20'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = select_21;
`ifndef SYNTHESIS
  logic memory_re;
  assign memory_re = s0_en;
`endif
  logic [19:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_21;
      raster_row_ended_q <= marks_last_i;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic or_19_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      or_19_s1_q <= or_19;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  logic [9:0] columns_0_values_0_q;
  logic [9:0] columns_0_values_1_q;
  logic [9:0] columns_0_values_2_q;
  logic [9:0] columns_0_values_3_q;
  logic [1:0] mask_columns_values_0_q;
  logic [1:0] mask_columns_values_1_q;
  logic [1:0] saturated_columns_values_0_q;
  logic [1:0] saturated_columns_values_1_q;
  // hls/stages/lowpass.hpp:27
  logic and_24;
  assign and_24 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/lowpass.hpp:43
  logic [1:0] select_25;
  assign select_25 = and_24 ? memory_rdata_q[17:16] : 2'h0;
  // hls/stages/lowpass.hpp:44
  logic [1:0] select_26;
  assign select_26 = and_24 ? memory_rdata_q[19:18] : 2'h0;
  // hls/stages/lowpass.hpp:35
  logic [8:0] sum_28;
  assign sum_28 = {1'b0, memory_rdata_q[7:0]} + {2'h0, memory_rdata_q[15:9]};
  logic [9:0] sum;
  assign sum = {2'h0, pixel_0_s1_q} + {sum_28, memory_rdata_q[8]};
  // hls/stages/lowpass.hpp:43
  logic equal_30;
  assign equal_30 = {select_25, mask_s1_q} == 3'h7;
  logic [1:0] select_31;
  assign select_31 = or_19_s1_q ? 2'h0 : mask_columns_values_1_q;
  // hls/stages/lowpass.hpp:44
  logic equal_33;
  assign equal_33 = {select_26, saturated_s1_q} == 3'h7;
  logic [1:0] select_34;
  assign select_34 = or_19_s1_q ? 2'h0 : saturated_columns_values_1_q;
  // hls/stages/lowpass.hpp:38
  logic [10:0] sum_36;
  assign sum_36 = {1'b0, columns_0_values_1_q} + {2'h0, columns_0_values_3_q[9:1]};
  logic [11:0] sum_37;
  assign sum_37 = {sum_36, columns_0_values_3_q[0]} + {2'h0, sum};
  logic [8:0] sum_38;
  assign sum_38 = sum_37[11:3] + 9'h1;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_26[0], saturated_s1_q, select_25[0], mask_s1_q, memory_rdata_q[7:0], pixel_0_s1_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && memory_we) begin
      if (memory_re && memory_raddr == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_waddr >= 10'd756) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 10'd756) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_24;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    columns_0_values_0_q = 10'h0;
    columns_0_values_1_q = 10'h0;
    columns_0_values_2_q = 10'h0;
    columns_0_values_3_q = 10'h0;
    mask_columns_values_0_q = 2'h0;
    mask_columns_values_1_q = 2'h0;
    saturated_columns_values_0_q = 2'h0;
    saturated_columns_values_1_q = 2'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      columns_0_values_0_q <= sum;
      columns_0_values_1_q <= columns_0_values_0_q;
      columns_0_values_2_q <= columns_0_values_1_q;
      columns_0_values_3_q <= columns_0_values_2_q;
      mask_columns_values_0_q <= {select_31[0], equal_30};
      mask_columns_values_1_q <= or_19_s1_q ? 2'h0 : mask_columns_values_0_q;
      saturated_columns_values_0_q <= {select_34[0], equal_33};
      saturated_columns_values_1_q <= or_19_s1_q ? 2'h0 : saturated_columns_values_0_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = sum_38[8:1];
  assign saturated_o = {select_34, equal_33} == 3'h7;
  assign mask_o = {select_31, equal_30} == 3'h7;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = raster_row_ended_q;
  assign marks_seen_o = marks_seen_s1_q;
  assign marks_nearer_o = marks_nearer_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_38[0], sum_37[2:0]};

endmodule
