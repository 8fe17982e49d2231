// SPDX-License-Identifier: Apache-2.0
// One array of horopter_ram, to whose description its ports and latencies belong.
module horopter_ram_bank #(
    parameter int unsigned WIDTH = 8,
    parameter int unsigned DEPTH = 1024,
    parameter bit OUTPUT_REGISTER = 1'b0,
    parameter int unsigned ADDR_BITS = DEPTH > 1 ? $clog2(DEPTH) : 1
) (
    input  logic                 clk_i,
    input  logic                 write_en_i,
    input  logic [ADDR_BITS-1:0] write_addr_i,
    input  logic [    WIDTH-1:0] write_data_i,
    input  logic                 read_en_i,
    input  logic [ADDR_BITS-1:0] read_addr_i,
    output logic [    WIDTH-1:0] read_data_o
);
  logic [WIDTH-1:0] memory[DEPTH];
  logic [WIDTH-1:0] read_word_q;

`ifndef SYNTHESIS
  // Synthesis leaves it away: block memories are zero after configuration anyway, and unrolling this takes minutes.
  initial begin
    for (int unsigned i = 0; i < DEPTH; i++) memory[i] = '0;
  end
`endif

  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (write_en_i) memory[write_addr_i] <= write_data_i;
    if (read_en_i) begin
      read_word_q <= memory[read_addr_i];
      if (write_en_i && write_addr_i == read_addr_i) read_word_q <= 'x;
    end
  end

  if (OUTPUT_REGISTER) begin : g_output
    logic [WIDTH-1:0] out_word_q;
    always_ff @(posedge clk_i) out_word_q <= read_word_q;
    assign read_data_o = out_word_q;
  end else begin : g_no_output
    assign read_data_o = read_word_q;
  end
endmodule
