// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Texture<horopter::hls::profiles::hd>, hls/stages/texture.hpp. Do not edit.
//
// Latency 7 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 65 bits, pipeline 380 bits, memories 71040 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q;
  logic s0_en, s2_en, s3_en, s4_en, s6_en;
  assign s0_en = en_i & valid_i;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s6_en = en_i & valid_s6_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] raster_column_q;
  logic raster_row_ended_q;
  // hls/stages/texture.hpp:42
  logic or_20;
  assign or_20 = marks_first_i | raster_row_ended_q;
  logic [10:0] select_21;
  assign select_21 = or_20 ? 11'h0 : raster_column_q;

  // Memory memory, 1920 x 37, DISTANCE 16, hls/stages/texture.hpp:86; read in stage 0, written in stage 6: 0 < 6 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [36:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 37'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_21;
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
      raster_column_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_21 + 11'h1;
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
  logic [10:0] select_21_s1_q;
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
      select_21_s1_q <= select_21;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic [3:0] difference_0_s2_q;
  logic [3:0] difference_1_s2_q;
  logic [7:0] magnitude_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic or_20_s2_q;
  logic [10:0] select_21_s2_q;
  logic [36:0] memory_rdata_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s2_q <= difference_0_s1_q;
      difference_1_s2_q <= difference_1_s1_q;
      magnitude_s2_q <= magnitude_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      or_20_s2_q <= or_20_s1_q;
      select_21_s2_q <= select_21_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [1:0] raster_rows_q;
  logic columns_values_0_q;
  logic columns_values_1_q;
  logic columns_values_2_q;
  // hls/stages/texture.hpp:42
  logic [1:0] select_23;
  assign select_23 = marks_first_s2_q ? 2'h0 : raster_rows_q;
  // hls/stages/texture.hpp:44
  logic [12:0] delayed;
  assign delayed = (select_23 == 2'h0) ? 13'h0 : memory_rdata_s2_q[36:24];
  // hls/stages/texture.hpp:42
  logic equal_26;
  assign equal_26 = select_23 == 2'h3;
  logic not_38;
  assign not_38 = ~equal_26;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 2'h0;
      columns_values_0_q <= 1'b0;
      columns_values_1_q <= 1'b0;
      columns_values_2_q <= 1'b0;
    end else if (s2_en) begin
      raster_rows_q <= marks_last_s2_q ? (select_23 + {1'b0, not_38}) : select_23;
      columns_values_0_q <= delayed[12];
      columns_values_1_q <= columns_values_0_q;
      columns_values_2_q <= columns_values_1_q;
    end
  end

  logic [3:0] difference_0_s3_q;
  logic [3:0] difference_1_s3_q;
  logic [7:0] magnitude_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic columns_values_2_s3_q;
  logic or_20_s3_q;
  logic [10:0] select_21_s3_q;
  logic [15:0] memory_rdata_s3_q;
  logic [11:0] delayed_s3_q;
  logic [7:0] select_27_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s3_q <= difference_0_s2_q;
      difference_1_s3_q <= difference_1_s2_q;
      magnitude_s3_q <= magnitude_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      columns_values_2_s3_q <= columns_values_2_q;
      or_20_s3_q <= or_20_s2_q;
      select_21_s3_q <= select_21_s2_q;
      memory_rdata_s3_q <= memory_rdata_s2_q[15:0];
      delayed_s3_q <= delayed[11:0];
      select_27_s3_q <= equal_26 ? memory_rdata_s2_q[23:16] : 8'h0;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [11:0] row_columns_values_0_q;
  logic [11:0] row_columns_values_1_q;
  logic [11:0] row_columns_values_2_q;
  // hls/stages/texture.hpp:52
  logic [8:0] difference_28;
  assign difference_28 = {1'b0, magnitude_s3_q} - {1'b0, select_27_s3_q};
  logic [9:0] sum_29;
  assign sum_29 = delayed_s3_q[9:0] + {difference_28[8], difference_28};

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    row_columns_values_0_q = 12'h0;
    row_columns_values_1_q = 12'h0;
    row_columns_values_2_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      row_columns_values_0_q <= {2'h0, sum_29};
      row_columns_values_1_q <= row_columns_values_0_q;
      row_columns_values_2_q <= row_columns_values_1_q;
    end
  end

  logic [3:0] difference_0_s4_q;
  logic [3:0] difference_1_s4_q;
  logic [7:0] magnitude_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic columns_values_2_s4_q;
  logic or_20_s4_q;
  logic [10:0] select_21_s4_q;
  logic [15:0] memory_rdata_s4_q;
  logic [1:0] delayed_s4_q;
  logic [11:0] select_32_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s4_q <= difference_0_s3_q;
      difference_1_s4_q <= difference_1_s3_q;
      magnitude_s4_q <= magnitude_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      columns_values_2_s4_q <= columns_values_2_s3_q;
      or_20_s4_q <= or_20_s3_q;
      select_21_s4_q <= select_21_s3_q;
      memory_rdata_s4_q <= memory_rdata_s3_q;
      delayed_s4_q <= delayed_s3_q[11:10];
      select_32_s4_q <= (11'h2 < select_21_s3_q) ? row_columns_values_2_q : 12'h0;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [11:0] row_sum_sums_values_0_q;
  // hls/stages/texture.hpp:56
  logic [11:0] sum;
  assign sum = (or_20_s4_q ? 12'h0 : row_sum_sums_values_0_q) + ({2'h0, row_columns_values_0_q[9:0]} - select_32_s4_q);

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    row_sum_sums_values_0_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s4_en) begin
      row_sum_sums_values_0_q <= sum;
    end
  end

  logic [3:0] difference_0_s5_q;
  logic [3:0] difference_1_s5_q;
  logic [7:0] magnitude_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic columns_values_2_s5_q;
  logic [10:0] select_21_s5_q;
  logic [15:0] memory_rdata_s5_q;
  logic [1:0] delayed_s5_q;
  logic [9:0] sum_29_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s5_q <= difference_0_s4_q;
      difference_1_s5_q <= difference_1_s4_q;
      magnitude_s5_q <= magnitude_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      columns_values_2_s5_q <= columns_values_2_s4_q;
      select_21_s5_q <= select_21_s4_q;
      memory_rdata_s5_q <= memory_rdata_s4_q;
      delayed_s5_q <= delayed_s4_q;
      sum_29_s5_q <= row_columns_values_0_q[9:0];
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------

  logic [3:0] difference_0_s6_q;
  logic [3:0] difference_1_s6_q;
  logic [7:0] magnitude_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_seen_s6_q;
  logic marks_nearer_s6_q;
  logic columns_values_2_s6_q;
  logic [10:0] select_21_s6_q;
  logic [15:0] memory_rdata_s6_q;
  logic [1:0] delayed_s6_q;
  logic [9:0] sum_29_s6_q;
  logic not_36_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s6_q <= difference_0_s5_q;
      difference_1_s6_q <= difference_1_s5_q;
      magnitude_s6_q <= magnitude_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_seen_s6_q <= marks_seen_s5_q;
      marks_nearer_s6_q <= marks_nearer_s5_q;
      columns_values_2_s6_q <= columns_values_2_s5_q;
      select_21_s6_q <= select_21_s5_q;
      memory_rdata_s6_q <= memory_rdata_s5_q;
      delayed_s6_q <= delayed_s5_q;
      sum_29_s6_q <= sum_29_s5_q;
      not_36_s6_q <= ~(row_sum_sums_values_0_q < cfg_texture_limit_i);
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_21_s6_q;
  logic memory_we;
  assign memory_we = s6_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {delayed_s6_q, not_36_s6_q, sum_29_s6_q, memory_rdata_s6_q, magnitude_s6_q};
  end
`ifndef SYNTHESIS
  logic [10:0] memory_raddr_s1_sim;
  logic memory_re_s1_sim;
  logic [10:0] memory_raddr_s2_sim;
  logic memory_re_s2_sim;
  logic [10:0] memory_raddr_s3_sim;
  logic memory_re_s3_sim;
  logic [10:0] memory_raddr_s4_sim;
  logic memory_re_s4_sim;
  logic [10:0] memory_raddr_s5_sim;
  logic memory_re_s5_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      memory_re_s1_sim <= 1'b0;
      memory_re_s2_sim <= 1'b0;
      memory_re_s3_sim <= 1'b0;
      memory_re_s4_sim <= 1'b0;
      memory_re_s5_sim <= 1'b0;
    end else if (en_i) begin
      memory_re_s1_sim <= memory_re;
      memory_raddr_s1_sim <= memory_raddr;
      memory_re_s2_sim <= memory_re_s1_sim;
      memory_raddr_s2_sim <= memory_raddr_s1_sim;
      memory_re_s3_sim <= memory_re_s2_sim;
      memory_raddr_s3_sim <= memory_raddr_s2_sim;
      memory_re_s4_sim <= memory_re_s3_sim;
      memory_raddr_s4_sim <= memory_raddr_s3_sim;
      memory_re_s5_sim <= memory_re_s4_sim;
      memory_raddr_s5_sim <= memory_raddr_s4_sim;
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
      if (memory_re_s3_sim && memory_raddr_s3_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s4_sim && memory_raddr_s4_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s5_sim && memory_raddr_s5_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_waddr >= 11'd1920) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 11'd1920) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  logic [3:0] difference_0_s7_q;
  logic [3:0] difference_1_s7_q;
  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_seen_s7_q;
  logic marks_nearer_s7_q;
  logic columns_values_2_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      difference_0_s7_q <= difference_0_s6_q;
      difference_1_s7_q <= difference_1_s6_q;
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_seen_s7_q <= marks_seen_s6_q;
      marks_nearer_s7_q <= marks_nearer_s6_q;
      columns_values_2_s7_q <= columns_values_2_s6_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign difference_0_o = difference_0_s7_q;
  assign difference_1_o = difference_1_s7_q;
  assign textured_o = columns_values_2_s7_q;
  assign mask_o = mask_s7_q;
  assign marks_first_o = marks_first_s7_q;
  assign marks_last_o = marks_last_s7_q;
  assign marks_seen_o = marks_seen_s7_q;
  assign marks_nearer_o = marks_nearer_s7_q;
  assign valid_o = valid_s7_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
      valid_s7_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
    end
  end

endmodule
