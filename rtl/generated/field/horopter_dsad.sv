// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Dsad<horopter::hls::profiles::field>, hls/stages/dsad.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 48 bits, pipeline 22 bits, memories 36544 bits.
module horopter_dsad (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [3:0] difference_0_i,
  input  logic [3:0] difference_1_i,
  input  logic textured_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  output logic valid_o,
  output logic [10:0] sum_0_o,
  output logic [10:0] sum_1_o,
  output logic textured_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [8:0] raster_column_q;
  logic raster_row_ended_q;
  logic [3:0] columns_place_q;
  // hls/stages/dsad.hpp:42
  logic or_14;
  assign or_14 = marks_first_i | raster_row_ended_q;
  logic [8:0] select_16;
  assign select_16 = or_14 ? 9'h0 : (raster_column_q + 9'h1);

  // Memory memory, 378 x 96, DISTANCE 16, hls/stages/dsad.hpp:108; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [95:0] memory_mem [0:377];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 378; i++) memory_mem[i] = 96'h0;
`endif
  logic [8:0] memory_raddr;
  assign memory_raddr = select_16;
  logic memory_re;
  assign memory_re = s0_en;
  logic [95:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  // Memory columns_values, 16 x 16, DISTANCE 7, hls/stages/dsad.hpp:104; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [15:0] columns_values_mem [0:15];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16; i++) columns_values_mem[i] = 16'h0;
`endif
  logic [3:0] columns_values_raddr;
  assign columns_values_raddr = columns_place_q + 4'h7;
  logic columns_values_re;
  assign columns_values_re = s0_en;
  logic [15:0] columns_values_rdata_q;
  always_ff @(posedge clk_i) begin
    if (columns_values_re) columns_values_rdata_q <= columns_values_mem[columns_values_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      columns_place_q <= 4'h0;
    end else if (s0_en) begin
      raster_column_q <= select_16;
      raster_row_ended_q <= marks_last_i;
      columns_place_q <= columns_place_q + 4'h1;
    end
  end

  logic [3:0] difference_0_s1_q;
  logic [3:0] difference_1_s1_q;
  logic textured_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic [3:0] columns_place_s1_q;
  logic or_14_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      difference_0_s1_q <= difference_0_i;
      difference_1_s1_q <= difference_1_i;
      textured_s1_q <= textured_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      columns_place_s1_q <= columns_place_q;
      or_14_s1_q <= or_14;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_rows_q;
  logic [10:0] rows_0_sums_values_0_q;
  logic [10:0] rows_1_sums_values_0_q;
  logic [7:0] mask_columns_values_0_q;
  // hls/stages/dsad.hpp:42
  logic [3:0] select_18;
  assign select_18 = marks_first_s1_q ? 4'h0 : raster_rows_q;
  logic equal_19;
  assign equal_19 = select_18 == 4'h0;
  logic equal_21;
  assign equal_21 = select_18 == 4'h9;
  // hls/stages/dsad.hpp:51
  logic [3:0] leaving;
  assign leaving = equal_21 ? memory_rdata_q[35:32] : 4'h0;
  // hls/stages/dsad.hpp:52
  logic [4:0] difference_23;
  assign difference_23 = {1'b0, difference_0_s1_q} - {1'b0, leaving};
  logic [7:0] sum_24;
  assign sum_24 = (equal_19 ? 8'h0 : memory_rdata_q[79:72]) + {{3{difference_23[4]}}, difference_23};
  // hls/stages/dsad.hpp:51
  logic [3:0] leaving_2;
  assign leaving_2 = equal_21 ? memory_rdata_q[71:68] : 4'h0;
  // hls/stages/dsad.hpp:52
  logic [4:0] difference_27;
  assign difference_27 = {1'b0, difference_1_s1_q} - {1'b0, leaving_2};
  logic [7:0] sum_28;
  assign sum_28 = (equal_19 ? 8'h0 : memory_rdata_q[87:80]) + {{3{difference_27[4]}}, difference_27};
  logic [7:0] select_29;
  assign select_29 = equal_19 ? 8'h0 : memory_rdata_q[95:88];
  // hls/stages/dsad.hpp:42
  logic not_32;
  assign not_32 = ~equal_21;
  // hls/stages/dsad.hpp:57
  logic less_36;
  assign less_36 = 9'h8 < raster_column_q;
  // hls/stages/dsad.hpp:60
  logic [7:0] select_37;
  assign select_37 = less_36 ? columns_values_rdata_q[7:0] : 8'h0;
  logic [8:0] difference_38;
  assign difference_38 = {1'b0, sum_24} - {1'b0, select_37};
  logic [10:0] sum_40;
  assign sum_40 = {{2{difference_38[8]}}, difference_38} + (or_14_s1_q ? 11'h0 : rows_0_sums_values_0_q);
  logic [7:0] select_41;
  assign select_41 = less_36 ? columns_values_rdata_q[15:8] : 8'h0;
  logic [8:0] difference_42;
  assign difference_42 = {1'b0, sum_28} - {1'b0, select_41};
  logic [10:0] sum_44;
  assign sum_44 = {{2{difference_42[8]}}, difference_42} + (or_14_s1_q ? 11'h0 : rows_1_sums_values_0_q);
  // hls/stages/dsad.hpp:62
  logic equal_45;
  assign equal_45 = {select_29, mask_s1_q} == 9'h1ff;
  logic [7:0] select_46;
  assign select_46 = or_14_s1_q ? 8'h0 : mask_columns_values_0_q;

  // Memory memory, write
  logic [8:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_29[6:0], mask_s1_q, sum_28, sum_24, memory_rdata_q[67:36], difference_1_s1_q, memory_rdata_q[31:0], difference_0_s1_q};
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

  // Memory columns_values, write
  logic [3:0] columns_values_waddr;
  assign columns_values_waddr = columns_place_s1_q;
  logic columns_values_we;
  assign columns_values_we = s1_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (columns_values_we) columns_values_mem[columns_values_waddr] <= {sum_28, sum_24};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && columns_values_we) begin
      if (columns_values_re && columns_values_raddr == columns_values_waddr) begin
        $error("columns_values: address %0d is read less than DISTANCE steps after its write", columns_values_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 4'h0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q ? (select_18 + {3'h0, not_32}) : select_18;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    rows_0_sums_values_0_q = 11'h0;
    rows_1_sums_values_0_q = 11'h0;
    mask_columns_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      rows_0_sums_values_0_q <= sum_40;
      rows_1_sums_values_0_q <= sum_44;
      mask_columns_values_0_q <= {select_46[6:0], equal_45};
    end
  end

  logic textured_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic equal_47_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      textured_s2_q <= textured_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      equal_47_s2_q <= {select_46, equal_45} == 9'h1ff;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign sum_0_o = rows_0_sums_values_0_q;
  assign sum_1_o = rows_1_sums_values_0_q;
  assign textured_o = textured_s2_q;
  assign mask_o = equal_47_s2_q;
  assign marks_first_o = marks_first_s2_q;
  assign marks_last_o = marks_last_s2_q;
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
