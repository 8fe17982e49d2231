// SPDX-License-Identifier: Apache-2.0
// Watches a value that only a write may change: its parity is taken after each write, and compared ever after.
//
// written_i: the value has been written by the last edge, or may be anything (reset). error_o: an odd number of bits has
// changed since; it comes a clock later and stays until the next write.
module horopter_guard #(
    parameter int unsigned WIDTH = 8
) (
    input  logic             clk_i,
    input  logic             written_i,
    input  logic [WIDTH-1:0] value_i,
    output logic             error_o
);
  if (WIDTH == 0) begin : g_illegal
    $fatal(1, "horopter_guard: WIDTH must be positive");
  end
  logic odd_q, written_q, parity_q;
  always_ff @(posedge clk_i) begin
    odd_q <= ^value_i;
    written_q <= written_i;
    if (written_q) parity_q <= odd_q;
  end
  assign error_o = !written_q && odd_q != parity_q;
endmodule
