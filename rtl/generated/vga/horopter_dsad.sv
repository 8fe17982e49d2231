// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Dsad<horopter::hls::profiles::vga>, hls/stages/dsad.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 189 bits, pipeline 22 bits, memories 62080 bits.
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
  output logic parity_error_o,
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
  logic [9:0] raster_column_q;
  logic raster_row_ended_q;
  // hls/stages/dsad.hpp:42
  logic or_33;
  assign or_33 = marks_first_i | raster_row_ended_q;
  logic [9:0] select_35;
  assign select_35 = or_33 ? 10'h0 : (raster_column_q + 10'h1);

  // Memory memory, 640 x 96 and parity, DISTANCE 16, hls/stages/dsad.hpp:108; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [96:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 97'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = select_35;
  logic memory_re;
  assign memory_re = s0_en;
  logic [96:0] memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_word_q <= memory_mem[memory_raddr];
  end
  logic [95:0] memory_rdata_q;
  assign memory_rdata_q = memory_word_q[95:0];
  logic memory_read_q, memory_error;
  always_ff @(posedge clk_i) memory_read_q <= rst_ni & memory_re;
  assign memory_error = memory_read_q & ^memory_word_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_35;
      raster_row_ended_q <= marks_last_i;
    end
  end

  logic [3:0] difference_0_s1_q;
  logic [3:0] difference_1_s1_q;
  logic textured_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic or_33_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s1_q <= difference_0_i;
      difference_1_s1_q <= difference_1_i;
      textured_s1_q <= textured_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      or_33_s1_q <= or_33;
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
  logic [3:0] select_37;
  assign select_37 = marks_first_s1_q ? 4'h0 : raster_rows_q;
  logic equal_38;
  assign equal_38 = select_37 == 4'h0;
  logic equal_40;
  assign equal_40 = select_37 == 4'h9;
  // hls/stages/dsad.hpp:51
  logic [3:0] leaving;
  assign leaving = equal_40 ? memory_rdata_q[35:32] : 4'h0;
  // hls/stages/dsad.hpp:52
  logic [4:0] difference_42;
  assign difference_42 = {1'b0, difference_0_s1_q} - {1'b0, leaving};
  logic [7:0] sum_43;
  assign sum_43 = (equal_38 ? 8'h0 : memory_rdata_q[79:72]) + {{3{difference_42[4]}}, difference_42};
  // hls/stages/dsad.hpp:51
  logic [3:0] leaving_2;
  assign leaving_2 = equal_40 ? memory_rdata_q[71:68] : 4'h0;
  // hls/stages/dsad.hpp:52
  logic [4:0] difference_46;
  assign difference_46 = {1'b0, difference_1_s1_q} - {1'b0, leaving_2};
  logic [7:0] sum_47;
  assign sum_47 = (equal_38 ? 8'h0 : memory_rdata_q[87:80]) + {{3{difference_46[4]}}, difference_46};
  logic [7:0] select_48;
  assign select_48 = equal_38 ? 8'h0 : memory_rdata_q[95:88];
  // hls/stages/dsad.hpp:42
  logic not_49;
  assign not_49 = ~equal_40;
  // hls/stages/dsad.hpp:57
  logic less_52;
  assign less_52 = 10'h8 < raster_column_q;
  // hls/stages/dsad.hpp:60
  logic [7:0] select_53;
  assign select_53 = less_52 ? columns_values_values_8_0_q : 8'h0;
  logic [8:0] difference_54;
  assign difference_54 = {1'b0, sum_43} - {1'b0, select_53};
  logic [10:0] sum_56;
  assign sum_56 = {{2{difference_54[8]}}, difference_54} + (or_33_s1_q ? 11'h0 : rows_0_sums_values_0_q);
  logic [7:0] select_57;
  assign select_57 = less_52 ? columns_values_values_8_1_q : 8'h0;
  logic [8:0] difference_58;
  assign difference_58 = {1'b0, sum_47} - {1'b0, select_57};
  logic [10:0] sum_60;
  assign sum_60 = {{2{difference_58[8]}}, difference_58} + (or_33_s1_q ? 11'h0 : rows_1_sums_values_0_q);
  // hls/stages/dsad.hpp:62
  logic equal_61;
  assign equal_61 = {select_48, mask_s1_q} == 9'h1ff;
  logic [7:0] select_62;
  assign select_62 = or_33_s1_q ? 8'h0 : mask_columns_values_0_q;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en;
  logic [95:0] memory_wdata;
  assign memory_wdata = {select_48[6:0], mask_s1_q, sum_47, sum_43, memory_rdata_q[67:36], difference_1_s1_q, memory_rdata_q[31:0], difference_0_s1_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {^memory_wdata, memory_wdata};
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
      raster_rows_q <= raster_row_ended_q ? (select_37 + {3'h0, not_49}) : select_37;
      columns_values_values_0_0_q <= sum_43;
      columns_values_values_0_1_q <= sum_47;
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
      rows_0_sums_values_0_q <= sum_56;
      rows_1_sums_values_0_q <= sum_60;
      mask_columns_values_0_q <= {select_62[6:0], equal_61};
    end
  end

  logic textured_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic equal_63_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      textured_s2_q <= textured_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      equal_63_s2_q <= {select_62, equal_61} == 9'h1ff;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (memory_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign sum_0_o = rows_0_sums_values_0_q;
  assign sum_1_o = rows_1_sums_values_0_q;
  assign textured_o = textured_s2_q;
  assign mask_o = equal_63_s2_q;
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
