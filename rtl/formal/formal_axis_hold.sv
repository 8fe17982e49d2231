// SPDX-License-Identifier: Apache-2.0
// Proof of horopter_axis_hold by induction, unbounded: what it offers stays until it is taken, whatever its source does,
// and what the source offers comes out once.
module formal_axis_hold (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       source_rst_ni,
    input logic       s_valid_i,
    input logic [7:0] s_data_i,
    input logic       m_ready_i
);
  logic s_ready, m_valid;
  logic [7:0] m_data;
  horopter_axis_hold #(
      .WIDTH(8)
  ) dut (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .drop_i(!source_rst_ni),
      .s_valid_i(s_valid_i),
      .s_ready_o(s_ready),
      .s_data_i(s_data_i),
      .m_valid_o(m_valid),
      .m_ready_i(m_ready_i),
      .m_data_o(m_data)
  );
  (* hierconn *) wire \dut.held_q ;

  logic past_valid = 1'b0, past_stall = 1'b0, past_drop = 1'b0, past_reset = 1'b1, s_stall = 1'b0;
  logic [7:0] past_data, s_data;
  always @(posedge clk_i) begin
    past_valid <= 1'b1;
    past_reset <= !rst_ni;
    past_stall <= rst_ni && m_valid && !m_ready_i;
    past_data <= m_data;
    past_drop <= !source_rst_ni;
    s_stall <= source_rst_ni && s_valid_i && !s_ready;
    s_data <= s_data_i;
  end

  always @(*) begin
    if (!past_valid) assume (!rst_ni);
    if (!rst_ni) assume (!source_rst_ni);
    // The source: nothing after its reset, and what it offers stays until it is taken or its reset comes.
    if (past_drop) assume (!s_valid_i);
    if (s_stall) assume (s_valid_i && s_data_i == s_data);
    if (past_valid) begin
      if (past_stall) assert (m_valid && m_data == past_data);
      if (past_reset) assert (!m_valid);
      // Taken from the source in the clock in which it comes out, or held because the source takes it back.
      assert ((s_valid_i && s_ready) == (m_valid && m_ready_i && !\dut.held_q ));
      assert (m_valid == (s_valid_i || \dut.held_q ));
      if (s_valid_i && !\dut.held_q ) assert (m_data == s_data_i);
      cover (\dut.held_q && s_valid_i && m_ready_i);
      cover (past_stall && past_drop && m_ready_i);
    end
  end
endmodule
