// SPDX-License-Identifier: Apache-2.0
// Synchronous simple dual-port memory, one clock: one write port, one read port.
//
// Read latency 1 clock (OUTPUT_REGISTER = 0) or 2 (= 1: block memories are slow at their output). The read data holds
// while read_en_i is 0; with OUTPUT_REGISTER the second stage always follows the first by one clock.
// Reading an address in the clock in which it is written gives an undefined word, so that no bypass logic is needed.
// PARITY = 1 stores even parity beside each word (the ninth bit of block memories); parity_error_o comes with the data.
// Contents are zero at power-up (with correct parity) and survive reset: there is none.
module horopter_ram #(
    parameter int unsigned WIDTH = 8,
    parameter int unsigned DEPTH = 1024,
    parameter bit PARITY = 1'b0,
    parameter bit OUTPUT_REGISTER = 1'b0,
    parameter int unsigned ADDR_BITS = DEPTH > 1 ? $clog2(DEPTH) : 1
) (
    input  logic                 clk_i,
    input  logic                 write_en_i,
    input  logic [ADDR_BITS-1:0] write_addr_i,
    input  logic [    WIDTH-1:0] write_data_i,
    input  logic                 read_en_i,
    input  logic [ADDR_BITS-1:0] read_addr_i,
    output logic [    WIDTH-1:0] read_data_o,
    output logic                 parity_error_o
);
  localparam int unsigned WORD_BITS = WIDTH + (PARITY ? 1 : 0);

  if (WIDTH == 0 || DEPTH < 2 || ADDR_BITS != $clog2(DEPTH)) begin : g_illegal
    $fatal(1, "horopter_ram: WIDTH must be positive, DEPTH at least 2, ADDR_BITS left alone");
  end

  logic [WORD_BITS-1:0] memory[DEPTH];
  logic [WORD_BITS-1:0] write_word;
  logic [WORD_BITS-1:0] read_word_q;
  logic [WORD_BITS-1:0] out_word;

`ifndef SYNTHESIS
  // Synthesis leaves it away: block memories are zero after configuration anyway, and unrolling this takes minutes.
  initial begin
    for (int unsigned i = 0; i < DEPTH; i++) memory[i] = '0;
  end
`endif

  if (PARITY) begin : g_parity
    assign write_word = {^write_data_i, write_data_i};
    assign parity_error_o = ^out_word;
  end else begin : g_no_parity
    assign write_word = write_data_i;
    assign parity_error_o = 1'b0;
  end

  always_ff @(posedge clk_i) begin
    if (write_en_i) memory[write_addr_i] <= write_word;
    if (read_en_i) begin
      read_word_q <= memory[read_addr_i];
      if (write_en_i && write_addr_i == read_addr_i) read_word_q <= 'x;
    end
  end

  if (OUTPUT_REGISTER) begin : g_output
    logic [WORD_BITS-1:0] out_word_q;
    always_ff @(posedge clk_i) out_word_q <= read_word_q;
    assign out_word = out_word_q;
  end else begin : g_no_output
    assign out_word = read_word_q;
  end
  assign read_data_o = out_word[WIDTH-1:0];
endmodule
