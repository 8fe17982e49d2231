// SPDX-License-Identifier: Apache-2.0
// Watches a value that only a write may change: its parity is taken after each write, and compared ever after.
//
// write_i: the value is written by this clock's edge, or may be anything (reset). error_o: an odd number of bits has changed
// since; it comes three clocks later and stays until the next write. The first registers are small, so that they can lie near
// the value.
module horopter_guard #(
    parameter int unsigned WIDTH = 8
) (
    input  logic             clk_i,
    input  logic             write_i,
    input  logic [WIDTH-1:0] value_i,
    output logic             error_o
);
  if (WIDTH == 0) begin : g_illegal
    $fatal(1, "horopter_guard: WIDTH must be positive");
  end
  localparam int unsigned GROUPS = (WIDTH + 3) / 4;
  logic [4*GROUPS-1:0] value;
  logic [GROUPS-1:0] odd_groups_q;
  logic odd_q, parity_q;
  logic [2:0] write_q;
  logic waiting_q;  // until the parity is that of what was written
  assign value = (4 * GROUPS)'(value_i);
  always_ff @(posedge clk_i) begin
    for (int unsigned i = 0; i < GROUPS; i++) odd_groups_q[i] <= ^value[4*i+:4];
    odd_q <= ^odd_groups_q;
    write_q <= {write_q[1:0], write_i};
    if (write_q[2]) parity_q <= odd_q;
    waiting_q <= write_i || write_q[1:0] != 2'b00;
    error_o <= !write_i && !waiting_q && odd_q != parity_q;
  end
endmodule
