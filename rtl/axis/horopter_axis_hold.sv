// SPDX-License-Identifier: Apache-2.0
// Ends the beat that is under way when the source of a valid/ready stream is reset.
//
// A beat that is offered (m_valid_o = 1) and not taken stays until it is taken, although the source takes it back:
// drop_i = 1 says that it does so with the next clock. What the source offers meanwhile waits. Latency 0; m_valid_o,
// m_data_o and s_ready_o are combinational. Reset: nothing is held.
module horopter_axis_hold #(
    parameter int unsigned WIDTH = 8
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             drop_i,
    input  logic             s_valid_i,
    output logic             s_ready_o,
    input  logic [WIDTH-1:0] s_data_i,
    output logic             m_valid_o,
    input  logic             m_ready_i,
    output logic [WIDTH-1:0] m_data_o
);
  if (WIDTH == 0) begin : g_illegal
    $fatal(1, "horopter_axis_hold: WIDTH must be positive");
  end

  logic held_q;
  logic [WIDTH-1:0] data_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || m_ready_i) held_q <= 1'b0;
    else if (drop_i && s_valid_i) held_q <= 1'b1;
    if (!held_q) data_q <= s_data_i;
  end

  assign m_valid_o = held_q || s_valid_i;
  assign m_data_o = held_q ? data_q : s_data_i;
  assign s_ready_o = m_ready_i && !held_q;
endmodule
