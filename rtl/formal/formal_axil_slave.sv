// SPDX-License-Identifier: Apache-2.0
// horopter_axil_slave as an AXI4-Lite slave, bounded and by induction: answers are stable, one answer to each request and
// none without, error answers are those of the access, every accepted write reaches the register block exactly once.
module formal_axil_slave (
    input logic        clk_i,
    input logic        rst_ni,
    input logic [11:0] awaddr,
    input logic        awvalid,
    input logic [31:0] wdata,
    input logic [ 3:0] wstrb,
    input logic        wvalid,
    input logic        bready,
    input logic [11:0] araddr,
    input logic        arvalid,
    input logic        rready,
    input logic        write_ready,
    input logic        write_error,
    input logic [31:0] read_data,
    input logic        read_error
);
  logic awready, wready, bvalid, arready, rvalid, write_valid;
  logic [1:0] bresp, rresp;
  logic [31:0] rdata, write_data;
  logic [11:0] write_addr, read_addr;
  logic [3:0] write_strb;
  horopter_axil_slave #(
      .ADDR_BITS(12)
  ) dut (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .s_axil_awaddr(awaddr),
      .s_axil_awvalid(awvalid),
      .s_axil_awready(awready),
      .s_axil_wdata(wdata),
      .s_axil_wstrb(wstrb),
      .s_axil_wvalid(wvalid),
      .s_axil_wready(wready),
      .s_axil_bresp(bresp),
      .s_axil_bvalid(bvalid),
      .s_axil_bready(bready),
      .s_axil_araddr(araddr),
      .s_axil_arvalid(arvalid),
      .s_axil_arready(arready),
      .s_axil_rdata(rdata),
      .s_axil_rresp(rresp),
      .s_axil_rvalid(rvalid),
      .s_axil_rready(rready),
      .write_valid_o(write_valid),
      .write_ready_i(write_ready),
      .write_addr_o(write_addr),
      .write_data_o(write_data),
      .write_strb_o(write_strb),
      .write_error_i(write_error),
      .read_addr_o(read_addr),
      .read_data_i(read_data),
      .read_error_i(read_error)
  );
  // Registers of the device, joined when the hierarchy is flattened (yosys: hierconn).
  (* hierconn *) wire \dut.have_addr_q ;
  (* hierconn *) wire \dut.have_data_q ;
  (* hierconn *) wire \dut.accessed_q ;
  (* hierconn *) wire [1:0] \dut.read_q ;

  logic past_valid = 1'b0, past_reset = 1'b1;
  logic past_b_stall = 1'b0, past_r_stall = 1'b0, past_access_stall = 1'b0, past_write = 1'b0;
  logic [1:0] past_bresp, past_rresp, expected_bresp;
  logic [31:0] past_rdata, past_write_data, caught_data;
  logic [11:0] past_write_addr, caught_addr;
  logic [2:0] aw_open = 3'd0, w_open = 3'd0, ar_open = 3'd0;  // accepted, not answered

  always @(posedge clk_i) begin
    past_valid <= 1'b1;
    past_reset <= !rst_ni;
    past_b_stall <= rst_ni && bvalid && !bready;
    past_r_stall <= rst_ni && rvalid && !rready;
    past_access_stall <= rst_ni && write_valid && !write_ready;
    past_write <= rst_ni && write_valid && write_ready;
    past_bresp <= bresp;
    past_rresp <= rresp;
    past_rdata <= rdata;
    past_write_addr <= write_addr;
    past_write_data <= write_data;
    if (write_valid && write_ready) expected_bresp <= write_error ? 2'b10 : 2'b00;
    if (awvalid && awready) caught_addr <= {awaddr[11:2], 2'b00};
    if (wvalid && wready) caught_data <= wdata;
    if (!rst_ni) begin
      aw_open <= 3'd0;
      w_open <= 3'd0;
      ar_open <= 3'd0;
    end else begin
      aw_open <= aw_open + {2'd0, awvalid && awready} - {2'd0, bvalid && bready};
      w_open <= w_open + {2'd0, wvalid && wready} - {2'd0, bvalid && bready};
      ar_open <= ar_open + {2'd0, arvalid && arready} - {2'd0, rvalid && rready};
    end
  end

  always @(*) begin
    if (!past_valid) assume (!rst_ni);
    if (past_valid) begin
      if (past_reset) assert (!bvalid && !rvalid && !write_valid);
      // Never an answer without its request; the books agree with the slave's state.
      assert (aw_open == {2'd0, \dut.have_addr_q } + {2'd0, bvalid});
      assert (w_open == {2'd0, \dut.have_data_q } + {2'd0, bvalid});
      assert (ar_open == {2'd0, !arready});
      assert (\dut.read_q <= 2'd2);
      if (bvalid) assert (aw_open != 3'd0 && w_open != 3'd0 && bresp == expected_bresp);
      if (rvalid) assert (ar_open != 3'd0 && !rresp[0]);
      // Stable until taken.
      if (past_b_stall) assert (bvalid && bresp == past_bresp);
      if (past_r_stall) assert (rvalid && rresp == past_rresp && rdata == past_rdata);
      if (past_access_stall && !past_reset)
        assert (write_valid && write_addr == past_write_addr && write_data == past_write_data);
      // An access is made once, with what was sent, and answered a clock later.
      if (past_write) assert (!write_valid && \dut.accessed_q );
      if (\dut.accessed_q ) assert (!bvalid && past_write && \dut.have_addr_q && \dut.have_data_q );
      if (\dut.have_addr_q ) assert (write_addr == caught_addr);
      if (\dut.have_data_q ) assert (write_data == caught_data);
      cover (bvalid && bresp == 2'b10);
      cover (rvalid && rresp == 2'b00 && past_r_stall);
    end
  end
endmodule
