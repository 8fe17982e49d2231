// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Dsad<horopter::hls::profiles::field>, hls/stages/dsad.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 48 bits, pipeline 26 bits, memories 36544 bits.
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
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [10:0] sum_0_o,
  output logic [10:0] sum_1_o,
  output logic textured_o,
  output logic mask_o,
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
  logic [3:0] columns_place_q;
  // hls/stages/dsad.hpp:42
  logic or_16;
  assign or_16 = marks_first_i | raster_row_ended_q;
  logic [8:0] select_18;
  assign select_18 = or_16 ? 9'h0 : (raster_column_q + 9'h1);

  // Memory memory, 378 x 96, DISTANCE 16, hls/stages/dsad.hpp:108; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [95:0] memory_mem [0:377];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 378; i++) memory_mem[i] = 96'h0;
`endif
  logic [8:0] memory_raddr;
  assign memory_raddr = select_18;
`ifndef SYNTHESIS
  logic memory_re;
  assign memory_re = s0_en;
`endif
  logic [95:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_rdata_q <= memory_mem[memory_raddr];
  end

  // Memory columns_values, 16 x 16, DISTANCE 7, hls/stages/dsad.hpp:104; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [15:0] columns_values_mem [0:15];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16; i++) columns_values_mem[i] = 16'h0;
`endif
  logic [3:0] columns_values_raddr;
  assign columns_values_raddr = columns_place_q + 4'h7;
`ifndef SYNTHESIS
  logic columns_values_re;
  assign columns_values_re = s0_en;
`endif
  logic [15:0] columns_values_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) columns_values_rdata_q <= columns_values_mem[columns_values_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      columns_place_q <= 4'h0;
    end else if (s0_en) begin
      raster_column_q <= select_18;
      raster_row_ended_q <= marks_last_i;
      columns_place_q <= columns_place_q + 4'h1;
    end
  end

  logic [3:0] difference_0_s1_q;
  logic [3:0] difference_1_s1_q;
  logic textured_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic [3:0] columns_place_s1_q;
  logic or_16_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s1_q <= difference_0_i;
      difference_1_s1_q <= difference_1_i;
      textured_s1_q <= textured_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      columns_place_s1_q <= columns_place_q;
      or_16_s1_q <= or_16;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_rows_q;
  logic [10:0] rows_0_sums_values_0_q;
  logic [10:0] rows_1_sums_values_0_q;
  logic [7:0] mask_columns_values_0_q;
  // hls/stages/dsad.hpp:42
  logic [3:0] select_20;
  assign select_20 = marks_first_s1_q ? 4'h0 : raster_rows_q;
  logic equal_21;
  assign equal_21 = select_20 == 4'h0;
  logic equal_23;
  assign equal_23 = select_20 == 4'h9;
  // hls/stages/dsad.hpp:51
  logic [3:0] leaving;
  assign leaving = equal_23 ? memory_rdata_q[35:32] : 4'h0;
  // hls/stages/dsad.hpp:52
  logic [4:0] difference_25;
  assign difference_25 = {1'b0, difference_0_s1_q} - {1'b0, leaving};
  logic [7:0] sum_26;
  assign sum_26 = (equal_21 ? 8'h0 : memory_rdata_q[79:72]) + {{3{difference_25[4]}}, difference_25};
  // hls/stages/dsad.hpp:51
  logic [3:0] leaving_2;
  assign leaving_2 = equal_23 ? memory_rdata_q[71:68] : 4'h0;
  // hls/stages/dsad.hpp:52
  logic [4:0] difference_29;
  assign difference_29 = {1'b0, difference_1_s1_q} - {1'b0, leaving_2};
  logic [7:0] sum_30;
  assign sum_30 = (equal_21 ? 8'h0 : memory_rdata_q[87:80]) + {{3{difference_29[4]}}, difference_29};
  logic [7:0] select_31;
  assign select_31 = equal_21 ? 8'h0 : memory_rdata_q[95:88];
  // hls/stages/dsad.hpp:42
  logic not_34;
  assign not_34 = ~equal_23;
  // hls/stages/dsad.hpp:57
  logic less_38;
  assign less_38 = 9'h8 < raster_column_q;
  // hls/stages/dsad.hpp:60
  logic [7:0] select_39;
  assign select_39 = less_38 ? columns_values_rdata_q[7:0] : 8'h0;
  logic [8:0] difference_40;
  assign difference_40 = {1'b0, sum_26} - {1'b0, select_39};
  logic [10:0] sum_42;
  assign sum_42 = {{2{difference_40[8]}}, difference_40} + (or_16_s1_q ? 11'h0 : rows_0_sums_values_0_q);
  logic [7:0] select_43;
  assign select_43 = less_38 ? columns_values_rdata_q[15:8] : 8'h0;
  logic [8:0] difference_44;
  assign difference_44 = {1'b0, sum_30} - {1'b0, select_43};
  logic [10:0] sum_46;
  assign sum_46 = {{2{difference_44[8]}}, difference_44} + (or_16_s1_q ? 11'h0 : rows_1_sums_values_0_q);
  // hls/stages/dsad.hpp:62
  logic equal_47;
  assign equal_47 = {select_31, mask_s1_q} == 9'h1ff;
  logic [7:0] select_48;
  assign select_48 = or_16_s1_q ? 8'h0 : mask_columns_values_0_q;

  // Memory memory, write
  logic [8:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_31[6:0], mask_s1_q, sum_30, sum_26, memory_rdata_q[67:36], difference_1_s1_q, memory_rdata_q[31:0], difference_0_s1_q};
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
    if (columns_values_we) columns_values_mem[columns_values_waddr] <= {sum_30, sum_26};
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
      raster_rows_q <= raster_row_ended_q ? (select_20 + {3'h0, not_34}) : select_20;
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
      rows_0_sums_values_0_q <= sum_42;
      rows_1_sums_values_0_q <= sum_46;
      mask_columns_values_0_q <= {select_48[6:0], equal_47};
    end
  end

  logic textured_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic equal_49_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      textured_s2_q <= textured_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      equal_49_s2_q <= {select_48, equal_47} == 9'h1ff;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign sum_0_o = rows_0_sums_values_0_q;
  assign sum_1_o = rows_1_sums_values_0_q;
  assign textured_o = textured_s2_q;
  assign mask_o = equal_49_s2_q;
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
