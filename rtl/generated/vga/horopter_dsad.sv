// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Dsad<horopter::hls::profiles::vga>, hls/stages/dsad.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 189 bits, pipeline 28 bits, memories 61440 bits.
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
  logic [9:0] raster_next_column_q;
  logic raster_row_ended_q;
  // hls/stages/dsad.hpp:41
  logic or_31;
  assign or_31 = marks_first_i | raster_row_ended_q;
  logic [9:0] select_32;
  assign select_32 = or_31 ? 10'h0 : raster_next_column_q;

  // Memory memory, 640 x 96, DISTANCE 16, hls/stages/dsad.hpp:72; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [95:0] memory_mem [0:639];
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 96'h0;
  logic [9:0] memory_raddr;
  assign memory_raddr = select_32;
  logic memory_re;
  assign memory_re = s0_en;
  logic [95:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_next_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_next_column_q <= select_32 + 10'h1;
      raster_row_ended_q <= marks_last_i;
    end
  end

  logic [3:0] difference_0_s1_q;
  logic [3:0] difference_1_s1_q;
  logic textured_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic or_31_s1_q;
  logic [9:0] select_32_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      difference_0_s1_q <= difference_0_i;
      difference_1_s1_q <= difference_1_i;
      textured_s1_q <= textured_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      or_31_s1_q <= or_31;
      select_32_s1_q <= select_32;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_rows_q;
  logic [7:0] rows_0_columns_values_0_q;
  logic [7:0] rows_0_columns_values_1_q;
  logic [7:0] rows_0_columns_values_2_q;
  logic [7:0] rows_0_columns_values_3_q;
  logic [7:0] rows_0_columns_values_4_q;
  logic [7:0] rows_0_columns_values_5_q;
  logic [7:0] rows_0_columns_values_6_q;
  logic [7:0] rows_0_columns_values_7_q;
  logic [7:0] rows_0_columns_values_8_q;
  logic [10:0] rows_0_sums_values_0_q;
  logic [7:0] rows_1_columns_values_0_q;
  logic [7:0] rows_1_columns_values_1_q;
  logic [7:0] rows_1_columns_values_2_q;
  logic [7:0] rows_1_columns_values_3_q;
  logic [7:0] rows_1_columns_values_4_q;
  logic [7:0] rows_1_columns_values_5_q;
  logic [7:0] rows_1_columns_values_6_q;
  logic [7:0] rows_1_columns_values_7_q;
  logic [7:0] rows_1_columns_values_8_q;
  logic [10:0] rows_1_sums_values_0_q;
  logic [7:0] mask_columns_values_0_q;
  // hls/stages/dsad.hpp:41
  logic [3:0] select_34;
  assign select_34 = marks_first_s1_q ? 4'h0 : raster_rows_q;
  logic equal_35;
  assign equal_35 = select_34 == 4'h0;
  logic equal_37;
  assign equal_37 = select_34 == 4'h9;
  // hls/stages/dsad.hpp:50
  logic [3:0] leaving;
  assign leaving = equal_37 ? memory_rdata_q[35:32] : 4'h0;
  // hls/stages/dsad.hpp:51
  logic [4:0] difference_39;
  assign difference_39 = {1'b0, difference_0_s1_q} - {1'b0, leaving};
  logic [7:0] sum_40;
  assign sum_40 = (equal_35 ? 8'h0 : memory_rdata_q[79:72]) + {{3{difference_39[4]}}, difference_39};
  // hls/stages/dsad.hpp:50
  logic [3:0] leaving_2;
  assign leaving_2 = equal_37 ? memory_rdata_q[71:68] : 4'h0;
  // hls/stages/dsad.hpp:51
  logic [4:0] difference_43;
  assign difference_43 = {1'b0, difference_1_s1_q} - {1'b0, leaving_2};
  logic [7:0] sum_44;
  assign sum_44 = (equal_35 ? 8'h0 : memory_rdata_q[87:80]) + {{3{difference_43[4]}}, difference_43};
  logic [7:0] select_45;
  assign select_45 = equal_35 ? 8'h0 : memory_rdata_q[95:88];
  // hls/stages/dsad.hpp:41
  logic not_47;
  assign not_47 = ~equal_37;
  // hls/stages/dsad.hpp:54
  logic less_50;
  assign less_50 = 10'h8 < select_32_s1_q;
  logic [7:0] select_51;
  assign select_51 = less_50 ? rows_0_columns_values_8_q : 8'h0;
  logic [8:0] difference_52;
  assign difference_52 = {1'b0, sum_40} - {1'b0, select_51};
  logic [10:0] sum_54;
  assign sum_54 = {{2{difference_52[8]}}, difference_52} + (or_31_s1_q ? 11'h0 : rows_0_sums_values_0_q);
  logic [7:0] select_55;
  assign select_55 = less_50 ? rows_1_columns_values_8_q : 8'h0;
  logic [8:0] difference_56;
  assign difference_56 = {1'b0, sum_44} - {1'b0, select_55};
  logic [10:0] sum_58;
  assign sum_58 = {{2{difference_56[8]}}, difference_56} + (or_31_s1_q ? 11'h0 : rows_1_sums_values_0_q);
  // hls/stages/dsad.hpp:56
  logic equal_59;
  assign equal_59 = {select_45, mask_s1_q} == 9'h1ff;
  logic [7:0] select_60;
  assign select_60 = or_31_s1_q ? 8'h0 : mask_columns_values_0_q;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = select_32_s1_q;
  logic memory_we;
  assign memory_we = s1_en;
  always_ff @(posedge clk_i) begin
    if (memory_we) memory_mem[memory_waddr] <= {select_45[6:0], mask_s1_q, sum_44, sum_40, memory_rdata_q[67:36], difference_1_s1_q, memory_rdata_q[31:0], difference_0_s1_q};
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
      rows_0_columns_values_0_q <= 8'h0;
      rows_0_columns_values_1_q <= 8'h0;
      rows_0_columns_values_2_q <= 8'h0;
      rows_0_columns_values_3_q <= 8'h0;
      rows_0_columns_values_4_q <= 8'h0;
      rows_0_columns_values_5_q <= 8'h0;
      rows_0_columns_values_6_q <= 8'h0;
      rows_0_columns_values_7_q <= 8'h0;
      rows_0_columns_values_8_q <= 8'h0;
      rows_0_sums_values_0_q <= 11'h0;
      rows_1_columns_values_0_q <= 8'h0;
      rows_1_columns_values_1_q <= 8'h0;
      rows_1_columns_values_2_q <= 8'h0;
      rows_1_columns_values_3_q <= 8'h0;
      rows_1_columns_values_4_q <= 8'h0;
      rows_1_columns_values_5_q <= 8'h0;
      rows_1_columns_values_6_q <= 8'h0;
      rows_1_columns_values_7_q <= 8'h0;
      rows_1_columns_values_8_q <= 8'h0;
      rows_1_sums_values_0_q <= 11'h0;
      mask_columns_values_0_q <= 8'h0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q ? (select_34 + {3'h0, not_47}) : select_34;
      rows_0_columns_values_0_q <= sum_40;
      rows_0_columns_values_1_q <= rows_0_columns_values_0_q;
      rows_0_columns_values_2_q <= rows_0_columns_values_1_q;
      rows_0_columns_values_3_q <= rows_0_columns_values_2_q;
      rows_0_columns_values_4_q <= rows_0_columns_values_3_q;
      rows_0_columns_values_5_q <= rows_0_columns_values_4_q;
      rows_0_columns_values_6_q <= rows_0_columns_values_5_q;
      rows_0_columns_values_7_q <= rows_0_columns_values_6_q;
      rows_0_columns_values_8_q <= rows_0_columns_values_7_q;
      rows_0_sums_values_0_q <= sum_54;
      rows_1_columns_values_0_q <= sum_44;
      rows_1_columns_values_1_q <= rows_1_columns_values_0_q;
      rows_1_columns_values_2_q <= rows_1_columns_values_1_q;
      rows_1_columns_values_3_q <= rows_1_columns_values_2_q;
      rows_1_columns_values_4_q <= rows_1_columns_values_3_q;
      rows_1_columns_values_5_q <= rows_1_columns_values_4_q;
      rows_1_columns_values_6_q <= rows_1_columns_values_5_q;
      rows_1_columns_values_7_q <= rows_1_columns_values_6_q;
      rows_1_columns_values_8_q <= rows_1_columns_values_7_q;
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
