// SPDX-License-Identifier: Apache-2.0
// A board's serial line with the registers and the map store behind it, and a frame every FRAME_CLOCKS in which nothing is
// done but that it takes its table.
module board_line #(
    parameter int unsigned FRAME_CLOCKS = 4096
) (
    input  logic       clk_25mhz,
    input  logic       ftdi_txd,
    output logic       ftdi_rxd,
    input  logic [1:1] btn,
    output logic [7:0] led
);
  logic [4:0] reset_q = 5'd0;
  logic rst_n;
  assign rst_n = reset_q[4];
  assign led = {7'd0, btn[1]};
  always_ff @(posedge clk_25mhz) if (!rst_n) reset_q <= reset_q + 5'd1;

  logic [11:0] awaddr, araddr, write_addr, read_addr;
  logic [31:0] wdata, rdata, write_data, read_data, board_wdata;
  logic [3:0] write_strb;
  logic [14:0] board_addr;
  logic awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready, board_write;
  logic write_valid, write_ready, write_error, read_error;
  logic [1:0] bresp, rresp;
  horopter_serial #(
      .BAUD(3_000_000)
  ) u_serial (
      .clk_i(clk_25mhz),
      .rst_ni(rst_n),
      .rx_i(ftdi_txd),
      .tx_o(ftdi_rxd),
      .m_axil_awaddr(awaddr),
      .m_axil_awvalid(awvalid),
      .m_axil_awready(awready),
      .m_axil_wdata(wdata),
      .m_axil_wvalid(wvalid),
      .m_axil_wready(wready),
      .m_axil_bresp(bresp),
      .m_axil_bvalid(bvalid),
      .m_axil_bready(bready),
      .m_axil_araddr(araddr),
      .m_axil_arvalid(arvalid),
      .m_axil_arready(arready),
      .m_axil_rdata(rdata),
      .m_axil_rresp(rresp),
      .m_axil_rvalid(rvalid),
      .m_axil_rready(rready),
      .board_addr_o(board_addr),
      .board_write_o(board_write),
      .board_wdata_o(board_wdata),
      .board_rdata_i(32'd0)
  );

  horopter_axil_slave u_slave (
      .clk_i(clk_25mhz),
      .rst_ni(rst_n),
      .s_axil_awaddr(awaddr),
      .s_axil_awvalid(awvalid),
      .s_axil_awready(awready),
      .s_axil_wdata(wdata),
      .s_axil_wstrb(4'hF),
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

  logic enable, control_valid, control_ready, start, data_valid, data_ready, busy;
  logic [11:0] width, height;
  logic [3:0] selected, slot, active_q;
  logic [15:0] base;
  logic [23:0] undecidable_limit;
  logic [31:0] data, crc, extent;
  logic [2:0] error;
  logic [14:0] valid;
  logic [31:0] frame_q;
  horopter_csr u_csr (
      .clk_i(clk_25mhz),
      .rst_ni(rst_n),
      .locked_i(enable),
      .write_valid_i(write_valid),
      .write_ready_o(write_ready),
      .write_addr_i(write_addr),
      .write_data_i(write_data),
      .write_strb_i(write_strb),
      .write_error_o(write_error),
      .read_addr_i(read_addr),
      .read_data_o(read_data),
      .read_error_o(read_error),
      .control_enable_o(enable),
      .width_px_o(width),
      .height_rows_o(height),
      .table_select_slot_o(selected),
      .map_slot_slot_o(slot),
      .map_base_word64_o(base),
      .map_control_valid_o(control_valid),
      .map_control_ready_i(control_ready),
      .map_control_start_o(start),
      .map_data_valid_o(data_valid),
      .map_data_ready_i(data_ready),
      .map_data_word_o(data),
      .map_status_busy_i(busy),
      .map_status_error_i(error),
      .map_status_active_slot_i(active_q),
      .map_valid_slots_i(valid),
      .map_crc_value_i(crc),
      .map_extent_base_word64_i(extent[15:0]),
      .map_extent_end_word64_i(extent[31:16]),
      .map_undecidable_limit_pixels_o(undecidable_limit)
  );

  horopter_map_store #(
      .POOL_BYTES(65536)
  ) u_map_store (
      .clk_i(clk_25mhz),
      .rst_ni(rst_n),
      .running_i(enable),
      .width_i(width),
      .height_i(height),
      .selected_slot_i(selected),
      .active_slot_i(active_q),
      .slot_i(slot),
      .base_i(base),
      .undecidable_limit_i(undecidable_limit),
      .start_valid_i(control_valid && start),
      .start_ready_o(control_ready),
      .data_valid_i(data_valid),
      .data_ready_o(data_ready),
      .data_i(data),
      .busy_o(busy),
      .error_o(error),
      .valid_o(valid),
      .slot_crc_o(crc),
      .slot_extent_o(extent),
      .lookup_i(1'b0),
      .lookup_slot_i(4'd0),
      .read_en_i(1'b0),
      .even_addr_i('0),
      .odd_addr_i('0)
  );

  always_ff @(posedge clk_25mhz) begin
    frame_q <= frame_q == FRAME_CLOCKS - 1 ? 32'd0 : frame_q + 32'd1;
    if (frame_q == 32'd0) active_q <= selected;
    if (!enable) begin
      frame_q <= 32'd0;
      active_q <= 4'd15;
    end
  end
endmodule
