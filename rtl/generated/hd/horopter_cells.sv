// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Cells<horopter::hls::profiles::hd>, hls/stages/cells.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 27 bits, pipeline 118 bits, memories 2048 bits.
module horopter_cells (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_i,
  input  logic first_i,
  input  logic last_i,
  output logic valid_o,
  output logic [7:0] mean_o,
  output logic start_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s2_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s2_en = en_i & valid_s2_q;
  assign s4_en = en_i & valid_s4_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [3:0] x_q;
  logic [3:0] y_q;
  logic [6:0] column_q;
  // hls/stages/cells.hpp:41
  logic [6:0] select_8;
  assign select_8 = first_i ? 7'h0 : column_q;
  logic [3:0] select_9;
  assign select_9 = first_i ? 4'h0 : x_q;
  logic equal_10;
  assign equal_10 = select_9 == 4'hf;
  logic [3:0] select_15;
  assign select_15 = first_i ? 4'h0 : y_q;

  // Memory sums, 128 x 16, DISTANCE 16, hls/stages/cells.hpp:69; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [15:0] sums_mem [0:127];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 128; i++) sums_mem[i] = 16'h0;
`endif
  logic [6:0] sums_raddr;
  assign sums_raddr = select_8;
`ifndef SYNTHESIS
  logic sums_re;
  assign sums_re = s0_en & equal_10;
`endif
  logic [15:0] sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) sums_rdata_q <= sums_mem[sums_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= 4'h0;
      y_q <= 4'h0;
      column_q <= 7'h0;
    end else if (s0_en) begin
      x_q <= last_i ? 4'h0 : (select_9 + 4'h1);
      y_q <= last_i ? (select_15 + 4'h1) : select_15;
      column_q <= last_i ? 7'h0 : (equal_10 ? (select_8 + 7'h1) : select_8);
    end
  end

  logic [7:0] pixel_s1_q;
  logic [6:0] select_8_s1_q;
  logic equal_10_s1_q;
  logic equal_12_s1_q;
  logic equal_16_s1_q;
  logic and_31_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s1_q <= pixel_i;
      select_8_s1_q <= select_8;
      equal_10_s1_q <= equal_10;
      equal_12_s1_q <= select_9 == 4'h0;
      equal_16_s1_q <= select_15 == 4'h0;
      and_31_s1_q <= ((~first_i) & (y_q == 4'hf)) & equal_10;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic [7:0] pixel_s2_q;
  logic [6:0] select_8_s2_q;
  logic equal_10_s2_q;
  logic [15:0] sums_rdata_s2_q;
  logic equal_12_s2_q;
  logic equal_16_s2_q;
  logic and_31_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s2_q <= pixel_s1_q;
      select_8_s2_q <= select_8_s1_q;
      equal_10_s2_q <= equal_10_s1_q;
      sums_rdata_s2_q <= sums_rdata_q;
      equal_12_s2_q <= equal_12_s1_q;
      equal_16_s2_q <= equal_16_s1_q;
      and_31_s2_q <= and_31_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [11:0] row_sum_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_sum_q <= 12'h0;
    end else if (s2_en) begin
      row_sum_q <= {4'h0, pixel_s2_q} + (equal_12_s2_q ? 12'h0 : row_sum_q);
    end
  end

  logic [6:0] select_8_s3_q;
  logic equal_10_s3_q;
  logic [15:0] select_17_s3_q;
  logic and_31_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      select_8_s3_q <= select_8_s2_q;
      equal_10_s3_q <= equal_10_s2_q;
      select_17_s3_q <= equal_16_s2_q ? 16'h0 : sums_rdata_s2_q;
      and_31_s3_q <= and_31_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------

  logic [6:0] select_8_s4_q;
  logic equal_10_s4_q;
  logic [15:0] sum_18_s4_q;
  logic and_31_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      select_8_s4_q <= select_8_s3_q;
      equal_10_s4_q <= equal_10_s3_q;
      sum_18_s4_q <= {4'h0, row_sum_q} + select_17_s3_q;
      and_31_s4_q <= and_31_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------

  // Memory sums, write
  logic [6:0] sums_waddr;
  assign sums_waddr = select_8_s4_q;
  logic sums_we;
  assign sums_we = s4_en & equal_10_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (sums_we) sums_mem[sums_waddr] <= sum_18_s4_q;
  end
`ifndef SYNTHESIS
  logic [6:0] sums_raddr_s1_sim;
  logic sums_re_s1_sim;
  logic [6:0] sums_raddr_s2_sim;
  logic sums_re_s2_sim;
  logic [6:0] sums_raddr_s3_sim;
  logic sums_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sums_re_s1_sim <= 1'b0;
      sums_re_s2_sim <= 1'b0;
      sums_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      sums_re_s1_sim <= sums_re;
      sums_raddr_s1_sim <= sums_raddr;
      sums_re_s2_sim <= sums_re_s1_sim;
      sums_raddr_s2_sim <= sums_raddr_s1_sim;
      sums_re_s3_sim <= sums_re_s2_sim;
      sums_raddr_s3_sim <= sums_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && sums_we) begin
      if (sums_re && sums_raddr == sums_waddr) begin
        $error("sums: address %0d is read less than DISTANCE steps after its write", sums_waddr);
      end
      if (sums_re_s1_sim && sums_raddr_s1_sim == sums_waddr) begin
        $error("sums: address %0d is read less than DISTANCE steps after its write", sums_waddr);
      end
      if (sums_re_s2_sim && sums_raddr_s2_sim == sums_waddr) begin
        $error("sums: address %0d is read less than DISTANCE steps after its write", sums_waddr);
      end
      if (sums_re_s3_sim && sums_raddr_s3_sim == sums_waddr) begin
        $error("sums: address %0d is read less than DISTANCE steps after its write", sums_waddr);
      end
    end
  end
`endif

  logic [7:0] select_26_s5_q;
  logic equal_27_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      select_26_s5_q <= equal_10_s4_q ? sum_18_s4_q[15:8] : 8'h0;
      equal_27_s5_q <= select_8_s4_q == 7'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign mean_o = select_26_s5_q;
  assign start_o = equal_27_s5_q;
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
      valid_s5_q <= valid_s4_q & and_31_s4_q;
    end
  end

endmodule
