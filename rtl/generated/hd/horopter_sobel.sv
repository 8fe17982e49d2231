// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Sobel<horopter::hls::profiles::hd>, hls/stages/sobel.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 93 bits, pipeline 289 bits, memories 69120 bits.
module horopter_sobel (
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
  output logic valid_o,
  output logic signed [10:0] gx_0_o,
  output logic signed [10:0] gx_1_o,
  output logic signed [10:0] gy_0_o,
  output logic signed [10:0] gy_1_o,
  output logic saturated_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s2_en, s3_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] raster_column_q;
  logic raster_row_ended_q;
  // hls/stages/sobel.hpp:50
  logic or_22;
  assign or_22 = marks_first_i | raster_row_ended_q;
  logic [10:0] select_23;
  assign select_23 = or_22 ? 11'h0 : raster_column_q;

  // Memory memory, 1920 x 36, DISTANCE 16, hls/stages/sobel.hpp:87; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 36'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_23;
`ifndef SYNTHESIS
  logic memory_re;
  assign memory_re = s0_en;
`endif
  logic [35:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_23 + 11'h1;
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
  logic [10:0] select_23_s1_q;
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
      select_23_s1_q <= select_23;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic or_22_s2_q;
  logic [10:0] select_23_s2_q;
  logic [35:0] memory_rdata_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      or_22_s2_q <= or_22_s1_q;
      select_23_s2_q <= select_23_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  logic [1:0] mask_columns_values_0_q;
  logic [1:0] saturated_columns_values_0_q;
  // hls/stages/sobel.hpp:50
  logic and_26;
  assign and_26 = raster_rows_q & (~marks_first_s2_q);
  // hls/stages/sobel.hpp:72
  logic [1:0] select_27;
  assign select_27 = and_26 ? memory_rdata_s2_q[33:32] : 2'h0;
  // hls/stages/sobel.hpp:73
  logic [1:0] select_28;
  assign select_28 = and_26 ? memory_rdata_s2_q[35:34] : 2'h0;
  // hls/stages/sobel.hpp:58
  logic [8:0] sum_31;
  assign sum_31 = {1'b0, memory_rdata_s2_q[7:0]} + {2'h0, memory_rdata_s2_q[23:17]};
  logic [8:0] sum_33;
  assign sum_33 = {1'b0, memory_rdata_s2_q[15:8]} + {2'h0, memory_rdata_s2_q[31:25]};
  // hls/stages/sobel.hpp:72
  logic equal_37;
  assign equal_37 = {select_27, mask_s2_q} == 3'h7;
  logic [1:0] select_38;
  assign select_38 = or_22_s2_q ? 2'h0 : mask_columns_values_0_q;
  // hls/stages/sobel.hpp:73
  logic equal_39;
  assign equal_39 = {select_28, saturated_s2_q} == 3'h7;
  logic [1:0] select_40;
  assign select_40 = or_22_s2_q ? 2'h0 : saturated_columns_values_0_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s2_en) begin
      raster_rows_q <= marks_last_s2_q | and_26;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    mask_columns_values_0_q = 2'h0;
    saturated_columns_values_0_q = 2'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      mask_columns_values_0_q <= {select_38[0], equal_37};
      saturated_columns_values_0_q <= {select_40[0], equal_39};
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic [10:0] select_23_s3_q;
  logic [31:0] memory_rdata_s3_q;
  logic select_27_s3_q;
  logic select_28_s3_q;
  logic [8:0] sum_31_s3_q;
  logic [8:0] sum_33_s3_q;
  logic equal_47_s3_q;
  logic equal_48_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      select_23_s3_q <= select_23_s2_q;
      memory_rdata_s3_q <= memory_rdata_s2_q[31:0];
      select_27_s3_q <= select_27[0];
      select_28_s3_q <= select_28[0];
      sum_31_s3_q <= sum_31;
      sum_33_s3_q <= sum_33;
      equal_47_s3_q <= {select_40, equal_39} == 3'h7;
      equal_48_s3_q <= {select_38, equal_37} == 3'h7;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [9:0] smooth_0_values_0_q;
  logic [9:0] smooth_0_values_1_q;
  logic [9:0] smooth_1_values_0_q;
  logic [9:0] smooth_1_values_1_q;
  logic [8:0] slope_0_values_0_q;
  logic [8:0] slope_0_values_1_q;
  logic [8:0] slope_1_values_0_q;
  logic [8:0] slope_1_values_1_q;
  // hls/stages/sobel.hpp:58
  logic [9:0] smooth;
  assign smooth = {2'h0, pixel_0_s3_q} + {sum_31_s3_q, memory_rdata_s3_q[16]};
  logic [9:0] smooth_2;
  assign smooth_2 = {2'h0, pixel_1_s3_q} + {sum_33_s3_q, memory_rdata_s3_q[24]};
  // hls/stages/sobel.hpp:59
  logic [8:0] slope;
  assign slope = {1'b0, pixel_0_s3_q} - {1'b0, memory_rdata_s3_q[23:16]};
  logic [8:0] slope_2;
  assign slope_2 = {1'b0, pixel_1_s3_q} - {1'b0, memory_rdata_s3_q[31:24]};

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_23_s3_q;
  logic memory_we;
  assign memory_we = s3_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_28_s3_q, saturated_s3_q, select_27_s3_q, mask_s3_q, memory_rdata_s3_q[15:0], pixel_1_s3_q, pixel_0_s3_q};
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      smooth_0_values_0_q <= smooth;
      smooth_0_values_1_q <= smooth_0_values_0_q;
      smooth_1_values_0_q <= smooth_2;
      smooth_1_values_1_q <= smooth_1_values_0_q;
      slope_0_values_0_q <= slope;
      slope_0_values_1_q <= slope_0_values_0_q;
      slope_1_values_0_q <= slope_2;
      slope_1_values_1_q <= slope_1_values_0_q;
    end
  end

  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic [9:0] smooth_0_values_1_s4_q;
  logic [9:0] smooth_1_values_1_s4_q;
  logic [8:0] slope_0_values_1_s4_q;
  logic [8:0] slope_1_values_1_s4_q;
  logic equal_47_s4_q;
  logic equal_48_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      smooth_0_values_1_s4_q <= smooth_0_values_1_q;
      smooth_1_values_1_s4_q <= smooth_1_values_1_q;
      slope_0_values_1_s4_q <= slope_0_values_1_q;
      slope_1_values_1_s4_q <= slope_1_values_1_q;
      equal_47_s4_q <= equal_47_s3_q;
      equal_48_s4_q <= equal_48_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/sobel.hpp:61
  logic [9:0] sum_43;
  assign sum_43 = {slope_0_values_1_q[8], slope_0_values_1_q} + {{2{slope_0_values_0_q[8]}}, slope_0_values_0_q[8:1]};
  logic [10:0] sum_44;
  assign sum_44 = {{2{slope_0_values_1_s4_q[8]}}, slope_0_values_1_s4_q} + {sum_43, slope_0_values_0_q[0]};
  logic [9:0] sum_45;
  assign sum_45 = {slope_1_values_1_q[8], slope_1_values_1_q} + {{2{slope_1_values_0_q[8]}}, slope_1_values_0_q[8:1]};
  logic [10:0] sum_46;
  assign sum_46 = {{2{slope_1_values_1_s4_q[8]}}, slope_1_values_1_s4_q} + {sum_45, slope_1_values_0_q[0]};

  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic [10:0] difference_41_s5_q;
  logic [10:0] difference_42_s5_q;
  logic [10:0] sum_44_s5_q;
  logic [10:0] sum_46_s5_q;
  logic equal_47_s5_q;
  logic equal_48_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      difference_41_s5_q <= {1'b0, smooth_0_values_0_q} - {1'b0, smooth_0_values_1_s4_q};
      difference_42_s5_q <= {1'b0, smooth_1_values_0_q} - {1'b0, smooth_1_values_1_s4_q};
      sum_44_s5_q <= sum_44;
      sum_46_s5_q <= sum_46;
      equal_47_s5_q <= equal_47_s4_q;
      equal_48_s5_q <= equal_48_s4_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign gx_0_o = difference_41_s5_q;
  assign gx_1_o = difference_42_s5_q;
  assign gy_0_o = sum_44_s5_q;
  assign gy_1_o = sum_46_s5_q;
  assign saturated_o = equal_47_s5_q;
  assign mask_o = equal_48_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = marks_seen_s5_q;
  assign marks_nearer_o = marks_nearer_s5_q;
  assign valid_o = valid_s5_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
    end
  end

endmodule
