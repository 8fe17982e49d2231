// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Dsad<horopter::hls::profiles::vga>, hls/stages/dsad.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 189 bits, pipeline 18 bits, memories 61440 bits.
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
  logic [9:0] raster_column_q;
  logic raster_row_ended_q;
  // hls/stages/dsad.hpp:42
  logic or_31;
  assign or_31 = marks_first_i | raster_row_ended_q;
  logic [9:0] select_33;
  assign select_33 = or_31 ? 10'h0 : (raster_column_q + 10'h1);

  // Memory memory, 640 x 96, DISTANCE 16, hls/stages/dsad.hpp:108; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [95:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 96'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = select_33;
  logic memory_re;
  assign memory_re = s0_en;
  logic [95:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_33;
      raster_row_ended_q <= marks_last_i;
    end
  end

  logic [3:0] difference_0_s1_q;
  logic [3:0] difference_1_s1_q;
  logic textured_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic or_31_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      difference_0_s1_q <= difference_0_i;
      difference_1_s1_q <= difference_1_i;
      textured_s1_q <= textured_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      or_31_s1_q <= or_31;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_rows_q;
  logic [7:0] columns_values_values_0_0_q;
  logic [7:0] columns_values_values_0_1_q;
  logic [7:0] columns_values_values_1_0_q;
  logic [7:0] columns_values_values_1_1_q;
  logic [7:0] columns_values_values_2_0_q;
  logic [7:0] columns_values_values_2_1_q;
  logic [7:0] columns_values_values_3_0_q;
  logic [7:0] columns_values_values_3_1_q;
  logic [7:0] columns_values_values_4_0_q;
  logic [7:0] columns_values_values_4_1_q;
  logic [7:0] columns_values_values_5_0_q;
  logic [7:0] columns_values_values_5_1_q;
  logic [7:0] columns_values_values_6_0_q;
  logic [7:0] columns_values_values_6_1_q;
  logic [7:0] columns_values_values_7_0_q;
  logic [7:0] columns_values_values_7_1_q;
  logic [7:0] columns_values_values_8_0_q;
  logic [7:0] columns_values_values_8_1_q;
  logic [10:0] rows_0_sums_values_0_q;
  logic [10:0] rows_1_sums_values_0_q;
  logic [7:0] mask_columns_values_0_q;
  // hls/stages/dsad.hpp:42
  logic [3:0] select_35;
  assign select_35 = marks_first_s1_q ? 4'h0 : raster_rows_q;
  logic equal_36;
  assign equal_36 = select_35 == 4'h0;
  logic equal_38;
  assign equal_38 = select_35 == 4'h9;
  // hls/stages/dsad.hpp:51
  logic [3:0] leaving;
  assign leaving = equal_38 ? memory_rdata_q[35:32] : 4'h0;
  // hls/stages/dsad.hpp:52
  logic [4:0] difference_40;
  assign difference_40 = {1'b0, difference_0_s1_q} - {1'b0, leaving};
  logic [7:0] sum_41;
  assign sum_41 = (equal_36 ? 8'h0 : memory_rdata_q[79:72]) + {{3{difference_40[4]}}, difference_40};
  // hls/stages/dsad.hpp:51
  logic [3:0] leaving_2;
  assign leaving_2 = equal_38 ? memory_rdata_q[71:68] : 4'h0;
  // hls/stages/dsad.hpp:52
  logic [4:0] difference_44;
  assign difference_44 = {1'b0, difference_1_s1_q} - {1'b0, leaving_2};
  logic [7:0] sum_45;
  assign sum_45 = (equal_36 ? 8'h0 : memory_rdata_q[87:80]) + {{3{difference_44[4]}}, difference_44};
  logic [7:0] select_46;
  assign select_46 = equal_36 ? 8'h0 : memory_rdata_q[95:88];
  // hls/stages/dsad.hpp:42
  logic not_47;
  assign not_47 = ~equal_38;
  // hls/stages/dsad.hpp:57
  logic less_50;
  assign less_50 = 10'h8 < raster_column_q;
  // hls/stages/dsad.hpp:60
  logic [7:0] select_51;
  assign select_51 = less_50 ? columns_values_values_8_0_q : 8'h0;
  logic [8:0] difference_52;
  assign difference_52 = {1'b0, sum_41} - {1'b0, select_51};
  logic [10:0] sum_54;
  assign sum_54 = {{2{difference_52[8]}}, difference_52} + (or_31_s1_q ? 11'h0 : rows_0_sums_values_0_q);
  logic [7:0] select_55;
  assign select_55 = less_50 ? columns_values_values_8_1_q : 8'h0;
  logic [8:0] difference_56;
  assign difference_56 = {1'b0, sum_45} - {1'b0, select_55};
  logic [10:0] sum_58;
  assign sum_58 = {{2{difference_56[8]}}, difference_56} + (or_31_s1_q ? 11'h0 : rows_1_sums_values_0_q);
  // hls/stages/dsad.hpp:62
  logic equal_59;
  assign equal_59 = {select_46, mask_s1_q} == 9'h1ff;
  logic [7:0] select_60;
  assign select_60 = or_31_s1_q ? 8'h0 : mask_columns_values_0_q;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_46[6:0], mask_s1_q, sum_45, sum_41, memory_rdata_q[67:36], difference_1_s1_q, memory_rdata_q[31:0], difference_0_s1_q};
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
      raster_rows_q <= 4'h0;
      columns_values_values_0_0_q <= 8'h0;
      columns_values_values_0_1_q <= 8'h0;
      columns_values_values_1_0_q <= 8'h0;
      columns_values_values_1_1_q <= 8'h0;
      columns_values_values_2_0_q <= 8'h0;
      columns_values_values_2_1_q <= 8'h0;
      columns_values_values_3_0_q <= 8'h0;
      columns_values_values_3_1_q <= 8'h0;
      columns_values_values_4_0_q <= 8'h0;
      columns_values_values_4_1_q <= 8'h0;
      columns_values_values_5_0_q <= 8'h0;
      columns_values_values_5_1_q <= 8'h0;
      columns_values_values_6_0_q <= 8'h0;
      columns_values_values_6_1_q <= 8'h0;
      columns_values_values_7_0_q <= 8'h0;
      columns_values_values_7_1_q <= 8'h0;
      columns_values_values_8_0_q <= 8'h0;
      columns_values_values_8_1_q <= 8'h0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q ? (select_35 + {3'h0, not_47}) : select_35;
      columns_values_values_0_0_q <= sum_41;
      columns_values_values_0_1_q <= sum_45;
      columns_values_values_1_0_q <= columns_values_values_0_0_q;
      columns_values_values_1_1_q <= columns_values_values_0_1_q;
      columns_values_values_2_0_q <= columns_values_values_1_0_q;
      columns_values_values_2_1_q <= columns_values_values_1_1_q;
      columns_values_values_3_0_q <= columns_values_values_2_0_q;
      columns_values_values_3_1_q <= columns_values_values_2_1_q;
      columns_values_values_4_0_q <= columns_values_values_3_0_q;
      columns_values_values_4_1_q <= columns_values_values_3_1_q;
      columns_values_values_5_0_q <= columns_values_values_4_0_q;
      columns_values_values_5_1_q <= columns_values_values_4_1_q;
      columns_values_values_6_0_q <= columns_values_values_5_0_q;
      columns_values_values_6_1_q <= columns_values_values_5_1_q;
      columns_values_values_7_0_q <= columns_values_values_6_0_q;
      columns_values_values_7_1_q <= columns_values_values_6_1_q;
      columns_values_values_8_0_q <= columns_values_values_7_0_q;
      columns_values_values_8_1_q <= columns_values_values_7_1_q;
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
      rows_0_sums_values_0_q <= sum_54;
      rows_1_sums_values_0_q <= sum_58;
      mask_columns_values_0_q <= {select_60[6:0], equal_59};
    end
  end

  logic textured_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic equal_61_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      textured_s2_q <= textured_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      equal_61_s2_q <= {select_60, equal_59} == 9'h1ff;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign sum_0_o = rows_0_sums_values_0_q;
  assign sum_1_o = rows_1_sums_values_0_q;
  assign textured_o = textured_s2_q;
  assign mask_o = equal_61_s2_q;
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
