// SPDX-License-Identifier: Apache-2.0
// horopter_axis_fifo, 4 words deep, bounded (depth in the script): order, no loss, no doubling, stability, almost full.
module formal_axis_fifo (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       s_valid_i,
    input logic [3:0] s_data_i,
    input logic       m_ready_i
);
  logic s_ready, m_valid, almost_full, overflow;
  logic [3:0] m_data;
  horopter_axis_fifo #(
      .WIDTH(4),
      .DEPTH(4),
      .ALMOST_FULL(2)
  ) dut (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .s_valid_i(s_valid_i),
      .s_ready_o(s_ready),
      .s_data_i(s_data_i),
      .m_valid_o(m_valid),
      .m_ready_i(m_ready_i),
      .m_data_o(m_data),
      .almost_full_o(almost_full),
      .overflow_o(overflow)
  );
  // Registers of the device, joined when the hierarchy is flattened (yosys: hierconn).
  (* hierconn *) wire [2:0] \dut.level ;
  (* hierconn *) wire \dut.fetched_q ;
  (* hierconn *) wire \dut.valid_q ;

  (* anyconst *) logic [5:0] watched;
  logic [5:0] in_count = 6'd0, out_count = 6'd0;
  logic [3:0] seen_data, past_data;
  logic seen = 1'b0, past_valid = 1'b0, past_stall = 1'b0, past_refused = 1'b0;
  logic [2:0] past_level = 3'd0;

  always @(posedge clk_i) begin
    past_valid <= 1'b1;
    past_stall <= rst_ni && m_valid && !m_ready_i;
    past_refused <= rst_ni && s_valid_i && !s_ready;
    past_data <= m_data;
    past_level <= rst_ni ? \dut.level  : 3'd0;
    if (!rst_ni) begin
      in_count <= 6'd0;
      out_count <= 6'd0;
      seen <= 1'b0;
    end else begin
      if (s_valid_i && s_ready) begin
        in_count <= in_count + 6'd1;
        if (in_count == watched) begin
          seen <= 1'b1;
          seen_data <= s_data_i;
        end
      end
      if (m_valid && m_ready_i) out_count <= out_count + 6'd1;
    end
  end

  logic [5:0] held;
  assign held = in_count - out_count;
  always @(*) begin
    if (!past_valid) assume (!rst_ni);
    // Counters must not wrap within the depth of the proof.
    assume (in_count != 6'd63);
    if (past_valid) begin
      assert (\dut.level  <= 3'd4);
      assert (held == {3'd0, \dut.level } + {5'd0, \dut.fetched_q } + {5'd0, \dut.valid_q });
      assert (!m_valid || held != 6'd0);
      assert (!s_ready || \dut.level  != 3'd4);
      assert (s_ready || \dut.level  == 3'd4);
      if (m_valid && out_count == watched) assert (seen && m_data == seen_data);
      if (past_stall) assert (m_valid && m_data == past_data);
      assert (overflow == past_refused);
      assert (almost_full == (past_level >= 3'd2));
      cover (held == 6'd6);
      cover (out_count == 6'd8);
    end
  end
endmodule
