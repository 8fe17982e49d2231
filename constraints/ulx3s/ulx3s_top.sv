// SPDX-License-Identifier: Apache-2.0
// Horopter on a ULX3S (ECP5-85F) without cameras: a test pattern for both, registers over the USB serial port.
//
// After configuration the words of BOOT_FILE (address << 32 | data, made by scripts/bitstream) are written to the
// registers: an identity table, and enable. Then the serial port has the bus (horopter_serial). The board's own registers:
//   8000  "HBRD"                      8008  write: keep the runs of the next frame; read: {busy, 7'b0, runs kept[23:0]}
//   8004  clock in Hz                 800C  runs that can be kept
//   C000  the runs, see horopter_runs_memory
// btn[1] held: the pattern's right image is shifted by 16 px, and nothing is in the skin any more.
// btn[2] pressed and let go: a restart (INTERLOCK).
// led: 0 safe, 1 unsafe, 2 heartbeat, 3 the last frame had a pixel in the skin, 4 btn[1],
//      5 boot is done, 6 a boot write was refused, 7 on.
module ulx3s_top #(
    parameter BOOT_FILE = "build/ulx3s/boot.hex",
    parameter int unsigned BOOT_WORDS = 128,
    parameter int unsigned BAUD = 1_000_000,
    parameter int unsigned RUNS = 4096
) (
    input  logic       clk_25mhz,
    input  logic       ftdi_txd,  // to the FPGA
    output logic       ftdi_rxd,
    input  logic [2:1] btn,
    output logic [7:0] led,
    output logic       wifi_gpio0  // 1 keeps the board from rebooting into the ESP32's bitstream
);
  localparam int unsigned CLOCK_HZ = 25_000_000;
  logic clk;
  assign clk = clk_25mhz;
  assign wifi_gpio0 = 1'b1;

  // Some clocks of reset after configuration.
  logic [4:0] reset_q = 5'd0;
  logic rst_n;
  assign rst_n = reset_q[4];
  always_ff @(posedge clk) if (!rst_n) reset_q <= reset_q + 5'd1;

  logic [2:0] button_q;
  always_ff @(posedge clk) button_q <= {button_q[1:0], btn[1]};

  // --- bus: boot first, then the serial port ---
  logic [11:0] awaddr, serial_awaddr, araddr;
  logic [31:0] wdata, serial_wdata, rdata;
  logic awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready;
  logic serial_awvalid, serial_wvalid, serial_bready;
  logic [1:0] bresp, rresp;

  localparam int unsigned BOOT_BITS = $clog2(BOOT_WORDS + 1);
  logic [43:0] boot[BOOT_WORDS];
  initial $readmemh(BOOT_FILE, boot);
  logic [43:0] boot_q;
  logic [BOOT_BITS-1:0] boot_index_q;
  logic boot_done_q, boot_refused_q, boot_read_q, boot_aw_q, boot_w_q;
  always_ff @(posedge clk) begin
    boot_q <= boot[boot_index_q[$clog2(BOOT_WORDS)-1:0]];
    boot_read_q <= 1'b0;
    if (!rst_n) begin
      boot_index_q <= '0;
      boot_done_q <= 1'b0;
      boot_refused_q <= 1'b0;
      boot_read_q <= 1'b1;
      boot_aw_q <= 1'b0;
      boot_w_q <= 1'b0;
    end else if (!boot_done_q) begin
      if (boot_read_q) begin
        boot_aw_q <= 1'b1;
        boot_w_q <= 1'b1;
      end else begin
        if (awready) boot_aw_q <= 1'b0;
        if (wready) boot_w_q <= 1'b0;
      end
      if (bvalid) begin
        boot_index_q <= boot_index_q + 1'b1;
        boot_read_q <= 1'b1;
        if (bresp != 2'b00) boot_refused_q <= 1'b1;
        if (32'(boot_index_q) == BOOT_WORDS - 1) boot_done_q <= 1'b1;
      end
    end
  end
  assign awaddr = boot_done_q ? serial_awaddr : boot_q[43:32];
  assign wdata = boot_done_q ? serial_wdata : boot_q[31:0];
  assign awvalid = boot_done_q ? serial_awvalid : boot_aw_q && !boot_read_q;
  assign wvalid = boot_done_q ? serial_wvalid : boot_w_q && !boot_read_q;
  assign bready = boot_done_q ? serial_bready : 1'b1;

  logic board_write;
  logic [14:0] board_addr;
  logic [31:0] board_wdata, board_rdata;
  horopter_serial #(
      .CLOCK_HZ(CLOCK_HZ),
      .BAUD(BAUD)
  ) u_serial (
      .clk_i(clk),
      .rst_ni(rst_n && boot_done_q),
      .rx_i(ftdi_txd),
      .tx_o(ftdi_rxd),
      .m_axil_awaddr(serial_awaddr),
      .m_axil_awvalid(serial_awvalid),
      .m_axil_awready(awready),
      .m_axil_wdata(serial_wdata),
      .m_axil_wvalid(serial_wvalid),
      .m_axil_wready(wready),
      .m_axil_bresp(bresp),
      .m_axil_bvalid(bvalid),
      .m_axil_bready(serial_bready),
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
      .board_rdata_i(board_rdata)
  );

  // --- scene, of the size that the machine has accepted last; it begins with a whole frame whenever the machine does ---
  localparam logic [11:0] CONTROL_ADDRESS = 12'h040;  // rtl/csr/registers.md
  localparam logic [11:0] WIDTH_ADDRESS = 12'h04C;
  localparam logic [11:0] HEIGHT_ADDRESS = 12'h050;
  logic [11:0] width_q, height_q;
  logic enabled_q;
  always_ff @(posedge clk) begin
    if (bvalid && bready && bresp == 2'b00) begin
      if (awaddr == CONTROL_ADDRESS) enabled_q <= wdata[0];
      if (awaddr == WIDTH_ADDRESS) width_q <= wdata[11:0];
      if (awaddr == HEIGHT_ADDRESS) height_q <= wdata[11:0];
    end
    if (!rst_n) begin
      enabled_q <= 1'b0;
      width_q <= 12'(horopter_profile_pkg::WIDTH);
      height_q <= 12'(horopter_profile_pkg::HEIGHT);
    end
  end
  logic [7:0] left_pixel, right_pixel;
  logic first, last, left_valid, right_valid, left_ready, right_ready;
  horopter_pattern u_pattern (
      .clk_i(clk),
      .rst_ni(enabled_q),
      .width_i(width_q),
      .height_i(height_q),
      .shift_i(button_q[2] ? 5'd16 : 5'd0),
      .m_axis_left_tdata(left_pixel),
      .m_axis_right_tdata(right_pixel),
      .m_axis_tuser(first),
      .m_axis_tlast(last),
      .m_axis_left_tvalid(left_valid),
      .m_axis_right_tvalid(right_valid),
      .m_axis_left_tready(left_ready),
      .m_axis_right_tready(right_ready)
  );

  // --- machine ---
  logic [7:0] state;
  logic state_first, state_last, state_valid, runs_last, runs_valid, frame_done, irq, test_ready;
  logic [63:0] runs;
  logic [207:0] objects;
  logic objects_last, objects_valid;
  logic safe, unsafe, heartbeat, skin_q, skin_seen_q;
  horopter_top u_horopter (
      .clk_i(clk),
      .rst_ni(rst_n),
      .s_axil_awaddr(awaddr),
      .s_axil_awprot(3'd0),
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
      .s_axil_arprot(3'd0),
      .s_axil_arvalid(arvalid),
      .s_axil_arready(arready),
      .s_axil_rdata(rdata),
      .s_axil_rresp(rresp),
      .s_axil_rvalid(rvalid),
      .s_axil_rready(rready),
      .s_axis_left_tdata(left_pixel),
      .s_axis_left_tuser(first),
      .s_axis_left_tlast(last),
      .s_axis_left_tvalid(left_valid),
      .s_axis_left_tready(left_ready),
      .s_axis_right_tdata(right_pixel),
      .s_axis_right_tuser(first),
      .s_axis_right_tlast(last),
      .s_axis_right_tvalid(right_valid),
      .s_axis_right_tready(right_ready),
      .s_axis_test_tdata(16'd0),
      .s_axis_test_tuser(1'b0),
      .s_axis_test_tlast(1'b0),
      .s_axis_test_tvalid(1'b0),
      .s_axis_test_tready(test_ready),
      .m_axis_state_tdata(state),
      .m_axis_state_tuser(state_first),
      .m_axis_state_tlast(state_last),
      .m_axis_state_tvalid(state_valid),
      .m_axis_state_tready(1'b1),
      .m_axis_runs_tdata(runs),
      .m_axis_runs_tlast(runs_last),
      .m_axis_runs_tvalid(runs_valid),
      .m_axis_runs_tready(1'b1),
      .m_axis_objects_tdata(objects),
      .m_axis_objects_tlast(objects_last),
      .m_axis_objects_tvalid(objects_valid),
      .m_axis_objects_tready(1'b1),
      .restart_i(btn[2]),
      .feedback_i(1'b0),  // no contactors
      .safe_o(safe),
      .unsafe_o(unsafe),
      .heartbeat_o(heartbeat),
      .frame_done_o(frame_done),
      .irq_o(irq)
  );
  logic unused;
  assign unused = ^{objects, objects_last, objects_valid, test_ready, state[7:2], state_first, state_last, irq, board_wdata[31:1], board_addr[1:0]};

  // --- the board's own registers ---
  localparam int unsigned RUNS_BITS = $clog2(RUNS);
  if (RUNS > 4096) begin : g_illegal
    $fatal(1, "ulx3s_top: RUNS must be at most 4096");
  end
  logic runs_busy;
  logic [23:0] runs_count;
  logic [31:0] runs_word;
  horopter_runs_memory #(
      .RUNS(RUNS)
  ) u_runs (
      .clk_i(clk),
      .rst_ni(rst_n),
      .start_i(board_write && board_addr[14:2] == 13'd2 && board_wdata[0]),
      .busy_o(runs_busy),
      .count_o(runs_count),
      .s_axis_runs_tdata(runs),
      .s_axis_runs_tlast(runs_last),
      .s_axis_runs_tvalid(runs_valid),
      .read_addr_i(board_addr[RUNS_BITS+1:2]),
      .read_data_o(runs_word)
  );
  always_comb begin
    case (board_addr[3:2])
      2'd0: board_rdata = "HBRD";
      2'd1: board_rdata = CLOCK_HZ;
      2'd2: board_rdata = {runs_busy, 7'd0, runs_count};
      default: board_rdata = RUNS;
    endcase
    if (board_addr[14]) board_rdata = runs_word;
  end

  always_ff @(posedge clk) begin
    if (frame_done) begin
      skin_q <= skin_seen_q;
      skin_seen_q <= 1'b0;
    end else if (state_valid && state[1:0] == 2'd1) skin_seen_q <= 1'b1;
    if (!rst_n) begin
      skin_q <= 1'b0;
      skin_seen_q <= 1'b0;
    end
  end
  assign led = {1'b1, boot_refused_q, boot_done_q, button_q[2], skin_q, heartbeat, unsafe, safe};
endmodule
