// SPDX-License-Identifier: Apache-2.0
// Skid buffer: cuts every combinational path of a valid/ready stream, at full throughput.
//
// s_ready_o, m_valid_o and m_data_o come from registers. Nothing is lost, doubled or reordered; once m_valid_o is 1,
// m_data_o holds until m_ready_i. Latency 1 clock, room for two words. Reset: empty.
module horopter_axis_skid #(
    parameter int unsigned WIDTH = 8
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             s_valid_i,
    output logic             s_ready_o,
    input  logic [WIDTH-1:0] s_data_i,
    output logic             m_valid_o,
    input  logic             m_ready_i,
    output logic [WIDTH-1:0] m_data_o
);
  if (WIDTH == 0) begin : g_illegal
    $fatal(1, "horopter_axis_skid: WIDTH must be positive");
  end

  logic valid_q, spare_valid_q;
  logic [WIDTH-1:0] data_q, spare_data_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= 1'b0;
      spare_valid_q <= 1'b0;
    end else if (!valid_q || m_ready_i) begin
      valid_q <= spare_valid_q || s_valid_i;
      spare_valid_q <= 1'b0;
    end else if (s_valid_i) begin
      spare_valid_q <= 1'b1;
    end
    if (!valid_q || m_ready_i) data_q <= spare_valid_q ? spare_data_q : s_data_i;
    if (!spare_valid_q) spare_data_q <= s_data_i;
  end

  assign s_ready_o = !spare_valid_q;
  assign m_valid_o = valid_q;
  assign m_data_o = data_q;
endmodule
