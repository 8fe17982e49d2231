// SPDX-License-Identifier: Apache-2.0
// Proof of horopter_axis_skid by induction, unbounded: whatever goes in comes out, once, in order, and m_* is stable.
//
// One arbitrary (constant, unknown) word number is followed: it must come out with the value with which it went in.
module formal_axis_skid (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       s_valid_i,
    input logic [7:0] s_data_i,
    input logic       m_ready_i
);
  logic s_ready, m_valid;
  logic [7:0] m_data;
  horopter_axis_skid #(
      .WIDTH(8)
  ) dut (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .s_valid_i(s_valid_i),
      .s_ready_o(s_ready),
      .s_data_i(s_data_i),
      .m_valid_o(m_valid),
      .m_ready_i(m_ready_i),
      .m_data_o(m_data)
  );
  // Registers of the device, joined when the hierarchy is flattened (yosys: hierconn).
  (* hierconn *) wire \dut.valid_q ;
  (* hierconn *) wire \dut.spare_valid_q ;
  (* hierconn *) wire [7:0] \dut.spare_data_q ;

  (* anyconst *) logic [7:0] watched;
  logic [7:0] in_count = 8'd0, out_count = 8'd0;
  logic [7:0] seen_data;
  logic past_valid = 1'b0, past_stall = 1'b0;
  logic [7:0] past_data;

  always @(posedge clk_i) begin
    past_valid <= 1'b1;
    past_stall <= rst_ni && m_valid && !m_ready_i;
    past_data <= m_data;
    if (!rst_ni) begin
      in_count <= 8'd0;
      out_count <= 8'd0;
    end else begin
      if (s_valid_i && s_ready) begin
        in_count <= in_count + 8'd1;
        if (in_count == watched) seen_data <= s_data_i;
      end
      if (m_valid && m_ready_i) out_count <= out_count + 8'd1;
    end
  end

  logic [7:0] held;  // words in the buffer
  assign held = in_count - out_count;
  always @(*) begin
    if (!past_valid) assume (!rst_ni);
    if (past_valid) begin
      // Nothing is lost or doubled: what is held is what is valid.
      assert (held == {7'd0, \dut.valid_q } + {7'd0, \dut.spare_valid_q });
      assert (!\dut.spare_valid_q  || \dut.valid_q );
      assert (m_valid == (held != 8'd0));
      assert (s_ready == (held != 8'd2));
      // The watched word, wherever it is, is what went in.
      if (m_valid && out_count == watched) assert (m_data == seen_data);
      if (\dut.spare_valid_q  && out_count + 8'd1 == watched) assert (\dut.spare_data_q  == seen_data);
      // Stability.
      if (past_stall) assert (m_valid && m_data == past_data);
      cover (held == 8'd2);
      cover (out_count == 8'd5);
    end
  end
endmodule
