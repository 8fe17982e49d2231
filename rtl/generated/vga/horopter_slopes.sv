// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Slopes<horopter::hls::profiles::vga>, hls/stages/slopes.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 92 bits, pipeline 82 bits, memories 23680 bits.
module horopter_slopes (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic [7:0] pixel_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic parity_error_o,
  output logic valid_o,
  output logic signed [10:0] gx_0_o,
  output logic signed [10:0] gx_1_o,
  output logic signed [10:0] gy_0_o,
  output logic signed [10:0] gy_1_o,
  output logic [7:0] grey_o,
  output logic saturated_o,
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
  // hls/stages/sobel.hpp:50
  logic or_22;
  assign or_22 = marks_first_i | raster_row_ended_q;
  logic [9:0] select_24;
  assign select_24 = or_22 ? 10'h0 : (raster_column_q + 10'h1);

  // Memory memory, 640 x 36 and parity, DISTANCE 16, hls/stages/sobel.hpp:87; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [36:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 37'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = select_24;
  logic memory_re;
  assign memory_re = s0_en;
  logic [36:0] memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_word_q <= memory_mem[memory_raddr];
  end
  logic [35:0] memory_rdata_q;
  assign memory_rdata_q = memory_word_q[35:0];
  logic memory_read_q, memory_error;
  always_ff @(posedge clk_i) memory_read_q <= rst_ni & memory_re;
  assign memory_error = memory_read_q & ^memory_word_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_24;
      raster_row_ended_q <= marks_last_i;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic or_22_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      or_22_s1_q <= or_22;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  logic [9:0] smooth_0_values_0_q;
  logic [9:0] smooth_0_values_1_q;
  logic [9:0] smooth_1_values_0_q;
  logic [9:0] smooth_1_values_1_q;
  logic [8:0] slope_0_values_0_q;
  logic [8:0] slope_0_values_1_q;
  logic [8:0] slope_1_values_0_q;
  logic [8:0] slope_1_values_1_q;
  logic [1:0] mask_columns_values_0_q;
  logic [1:0] saturated_columns_values_0_q;
  // hls/stages/sobel.hpp:50
  logic and_27;
  assign and_27 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/sobel.hpp:72
  logic [1:0] select_28;
  assign select_28 = and_27 ? memory_rdata_q[33:32] : 2'h0;
  // hls/stages/sobel.hpp:73
  logic [1:0] select_29;
  assign select_29 = and_27 ? memory_rdata_q[35:34] : 2'h0;
  // hls/stages/sobel.hpp:58
  logic [8:0] sum_31;
  assign sum_31 = {1'b0, memory_rdata_q[7:0]} + {2'h0, memory_rdata_q[23:17]};
  logic [9:0] smooth;
  assign smooth = {2'h0, pixel_0_s1_q} + {sum_31, memory_rdata_q[16]};
  logic [8:0] sum_33;
  assign sum_33 = {1'b0, memory_rdata_q[15:8]} + {2'h0, memory_rdata_q[31:25]};
  logic [9:0] smooth_2;
  assign smooth_2 = {2'h0, pixel_1_s1_q} + {sum_33, memory_rdata_q[24]};
  // hls/stages/sobel.hpp:59
  logic [8:0] slope;
  assign slope = {1'b0, pixel_0_s1_q} - {1'b0, memory_rdata_q[23:16]};
  logic [8:0] slope_2;
  assign slope_2 = {1'b0, pixel_1_s1_q} - {1'b0, memory_rdata_q[31:24]};
  // hls/stages/sobel.hpp:72
  logic equal_37;
  assign equal_37 = {select_28, mask_s1_q} == 3'h7;
  logic [1:0] select_38;
  assign select_38 = or_22_s1_q ? 2'h0 : mask_columns_values_0_q;
  // hls/stages/sobel.hpp:73
  logic equal_39;
  assign equal_39 = {select_29, saturated_s1_q} == 3'h7;
  logic [1:0] select_40;
  assign select_40 = or_22_s1_q ? 2'h0 : saturated_columns_values_0_q;
  // hls/stages/sobel.hpp:61
  logic [9:0] sum_43;
  assign sum_43 = {slope_0_values_0_q[8], slope_0_values_0_q} + {{2{slope[8]}}, slope[8:1]};
  logic [10:0] sum_44;
  assign sum_44 = {{2{slope_0_values_1_q[8]}}, slope_0_values_1_q} + {sum_43, slope[0]};
  logic [9:0] sum_45;
  assign sum_45 = {slope_1_values_0_q[8], slope_1_values_0_q} + {{2{slope_2[8]}}, slope_2[8:1]};
  logic [10:0] sum_46;
  assign sum_46 = {{2{slope_1_values_1_q[8]}}, slope_1_values_1_q} + {sum_45, slope_2[0]};
  // hls/stages/sobel.hpp:64
  logic [10:0] sum_47;
  assign sum_47 = {1'b0, smooth_0_values_0_q} + {2'h0, smooth_0_values_1_q[9:1]};
  logic [11:0] sum_48;
  assign sum_48 = {sum_47, smooth_0_values_1_q[0]} + {2'h0, smooth};
  logic [8:0] sum_49;
  assign sum_49 = sum_48[11:3] + 9'h1;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = raster_column_q;
  logic memory_we;
  assign memory_we = s1_en;
  logic [35:0] memory_wdata;
  assign memory_wdata = {select_29[0], saturated_s1_q, select_28[0], mask_s1_q, memory_rdata_q[15:0], pixel_1_s1_q, pixel_0_s1_q};
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
      raster_rows_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_27;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    smooth_0_values_0_q = 10'h0;
    smooth_0_values_1_q = 10'h0;
    smooth_1_values_0_q = 10'h0;
    smooth_1_values_1_q = 10'h0;
    slope_0_values_0_q = 9'h0;
    slope_0_values_1_q = 9'h0;
    slope_1_values_0_q = 9'h0;
    slope_1_values_1_q = 9'h0;
    mask_columns_values_0_q = 2'h0;
    saturated_columns_values_0_q = 2'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      smooth_0_values_0_q <= smooth;
      smooth_0_values_1_q <= smooth_0_values_0_q;
      smooth_1_values_0_q <= smooth_2;
      smooth_1_values_1_q <= smooth_1_values_0_q;
      slope_0_values_0_q <= slope;
      slope_0_values_1_q <= slope_0_values_0_q;
      slope_1_values_0_q <= slope_2;
      slope_1_values_1_q <= slope_1_values_0_q;
      mask_columns_values_0_q <= {select_38[0], equal_37};
      saturated_columns_values_0_q <= {select_40[0], equal_39};
    end
  end

  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic [10:0] difference_41_s2_q;
  logic [10:0] difference_42_s2_q;
  logic [10:0] sum_44_s2_q;
  logic [10:0] sum_46_s2_q;
  logic [7:0] sum_49_s2_q;
  logic equal_50_s2_q;
  logic equal_51_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      difference_41_s2_q <= {1'b0, smooth} - {1'b0, smooth_0_values_1_q};
      difference_42_s2_q <= {1'b0, smooth_2} - {1'b0, smooth_1_values_1_q};
      sum_44_s2_q <= sum_44;
      sum_46_s2_q <= sum_46;
      sum_49_s2_q <= sum_49[8:1];
      equal_50_s2_q <= {select_40, equal_39} == 3'h7;
      equal_51_s2_q <= {select_38, equal_37} == 3'h7;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (memory_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign gx_0_o = difference_41_s2_q;
  assign gx_1_o = difference_42_s2_q;
  assign gy_0_o = sum_44_s2_q;
  assign gy_1_o = sum_46_s2_q;
  assign grey_o = sum_49_s2_q;
  assign saturated_o = equal_50_s2_q;
  assign mask_o = equal_51_s2_q;
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

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_49[0], sum_48[2:0]};

endmodule
