// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Cells<horopter::hls::profiles::vga>, hls/stages/cells.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 24 bits, pipeline 21 bits, memories 1792 bits.
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
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [2:0] x_q;
  logic [2:0] y_q;
  logic [6:0] column_q;
  logic [10:0] row_sum_q;
  // hls/stages/cells.hpp:41
  logic [6:0] select_8;
  assign select_8 = first_i ? 7'h0 : column_q;
  logic [2:0] select_9;
  assign select_9 = first_i ? 3'h0 : x_q;
  logic equal_10;
  assign equal_10 = select_9 == 3'h7;
  logic [2:0] select_15;
  assign select_15 = first_i ? 3'h0 : y_q;

  // Memory sums, 128 x 14, DISTANCE 16, hls/stages/cells.hpp:69; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [13:0] sums_mem [0:127];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 128; i++) sums_mem[i] = 14'h0;
`endif
  logic [6:0] sums_raddr;
  assign sums_raddr = select_8;
`ifndef SYNTHESIS
  logic sums_re;
  assign sums_re = s0_en & equal_10;
`endif
  logic [13:0] sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) sums_rdata_q <= sums_mem[sums_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= 3'h0;
      y_q <= 3'h0;
      column_q <= 7'h0;
      row_sum_q <= 11'h0;
    end else if (s0_en) begin
      x_q <= last_i ? 3'h0 : (select_9 + 3'h1);
      y_q <= last_i ? (select_15 + 3'h1) : select_15;
      column_q <= last_i ? 7'h0 : (equal_10 ? (select_8 + 7'h1) : select_8);
      row_sum_q <= {3'h0, pixel_i} + ((select_9 == 3'h0) ? 11'h0 : row_sum_q);
    end
  end

  logic [6:0] select_8_s1_q;
  logic equal_10_s1_q;
  logic equal_16_s1_q;
  logic and_31_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      select_8_s1_q <= select_8;
      equal_10_s1_q <= equal_10;
      equal_16_s1_q <= select_15 == 3'h0;
      and_31_s1_q <= ((~first_i) & (y_q == 3'h7)) & equal_10;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/cells.hpp:48
  logic [13:0] sum_18;
  assign sum_18 = {3'h0, row_sum_q} + (equal_16_s1_q ? 14'h0 : sums_rdata_q);

  // Memory sums, write
  logic [6:0] sums_waddr;
  assign sums_waddr = select_8_s1_q;
  logic sums_we;
  assign sums_we = s1_en & equal_10_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (sums_we) sums_mem[sums_waddr] <= sum_18;
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && sums_we) begin
      if (sums_re && sums_raddr == sums_waddr) begin
        $error("sums: address %0d is read less than DISTANCE steps after its write", sums_waddr);
      end
    end
  end
`endif

  logic [7:0] select_26_s2_q;
  logic equal_27_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      select_26_s2_q <= equal_10_s1_q ? sum_18[13:6] : 8'h0;
      equal_27_s2_q <= select_8_s1_q == 7'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign mean_o = select_26_s2_q;
  assign start_o = equal_27_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q & and_31_s1_q;
    end
  end

endmodule
