// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Texture<horopter::hls::profiles::field>, hls/stages/texture.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// Outputs are logic: what they go to takes them with the clock if en_i = 1.
// State 63 bits, pipeline 22 bits, memories 13986 bits.
module horopter_texture (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [3:0] difference_0_i,
  input  logic [3:0] difference_1_i,
  input  logic [7:0] magnitude_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  input  logic [11:0] cfg_texture_limit_i,
  output logic valid_o,
  output logic [3:0] difference_0_o,
  output logic [3:0] difference_1_o,
  output logic textured_o,
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
  logic [8:0] raster_column_q;
  logic raster_row_ended_q;
  // hls/stages/texture.hpp:42
  logic or_20;
  assign or_20 = marks_first_i | raster_row_ended_q;
  logic [8:0] select_22;
  assign select_22 = or_20 ? 9'h0 : (raster_column_q + 9'h1);

  // Memory memory, 378 x 37, DISTANCE 16, hls/stages/texture.hpp:86; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [36:0] memory_mem [0:377];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 378; i++) memory_mem[i] = 37'h0;
`endif
  logic [8:0] memory_raddr;
  assign memory_raddr = select_22;
`ifndef SYNTHESIS
  logic memory_re;
  assign memory_re = s0_en;
`endif
  logic [36:0] memory_rdata_q;
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

  logic [3:0] difference_0_s1_q;
  logic [3:0] difference_1_s1_q;
  logic [7:0] magnitude_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic or_20_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s1_q <= difference_0_i;
      difference_1_s1_q <= difference_1_i;
      magnitude_s1_q <= magnitude_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      or_20_s1_q <= or_20;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [1:0] raster_rows_q;
  logic [11:0] row_columns_values_0_q;
  logic [11:0] row_columns_values_1_q;
  logic [11:0] row_columns_values_2_q;
  logic [11:0] row_sum_sums_values_0_q;
  logic columns_values_0_q;
  logic columns_values_1_q;
  logic columns_values_2_q;
  // hls/stages/texture.hpp:42
  logic [1:0] select_24;
  assign select_24 = marks_first_s1_q ? 2'h0 : raster_rows_q;
  // hls/stages/texture.hpp:44
  logic [12:0] delayed;
  assign delayed = (select_24 == 2'h0) ? 13'h0 : memory_rdata_q[36:24];
  // hls/stages/texture.hpp:42
  logic equal_27;
  assign equal_27 = select_24 == 2'h3;
  // hls/stages/texture.hpp:52
  logic [7:0] select_28;
  assign select_28 = equal_27 ? memory_rdata_q[23:16] : 8'h0;
  logic [8:0] difference_29;
  assign difference_29 = {1'b0, magnitude_s1_q} - {1'b0, select_28};
  logic [9:0] sum_30;
  assign sum_30 = delayed[9:0] + {difference_29[8], difference_29};
  // hls/stages/texture.hpp:56
  logic [11:0] difference_34;
  assign difference_34 = {2'h0, sum_30} - ((9'h2 < raster_column_q) ? row_columns_values_2_q : 12'h0);
  logic [11:0] sum;
  assign sum = (or_20_s1_q ? 12'h0 : row_sum_sums_values_0_q) + difference_34;
  // hls/stages/texture.hpp:57
  logic not_37;
  assign not_37 = ~(sum < cfg_texture_limit_i);
  // hls/stages/texture.hpp:42
  logic not_38;
  assign not_38 = ~equal_27;

  // Memory memory, write
  logic [8:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {delayed[11:10], not_37, sum_30, memory_rdata_q[15:0], magnitude_s1_q};
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
      raster_rows_q <= 2'h0;
      columns_values_0_q <= 1'b0;
      columns_values_1_q <= 1'b0;
      columns_values_2_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q ? (select_24 + {1'b0, not_38}) : select_24;
      columns_values_0_q <= delayed[12];
      columns_values_1_q <= columns_values_0_q;
      columns_values_2_q <= columns_values_1_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    row_columns_values_0_q = 12'h0;
    row_columns_values_1_q = 12'h0;
    row_columns_values_2_q = 12'h0;
    row_sum_sums_values_0_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      row_columns_values_0_q <= {2'h0, sum_30};
      row_columns_values_1_q <= row_columns_values_0_q;
      row_columns_values_2_q <= row_columns_values_1_q;
      row_sum_sums_values_0_q <= sum;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign difference_0_o = difference_0_s1_q;
  assign difference_1_o = difference_1_s1_q;
  assign textured_o = columns_values_2_q;
  assign mask_o = mask_s1_q;
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

endmodule
