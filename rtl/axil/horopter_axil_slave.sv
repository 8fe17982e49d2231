// SPDX-License-Identifier: Apache-2.0
// AXI4-Lite slave in front of a register block: handshakes on one side, single accesses on the other.
//
// Address and data of a write may come in either order. One write and one read at a time, each answered after its
// access; awready, wready and arready come from registers and do not wait for valid. A write access (write_valid_o) is
// held until write_ready_i. It is answered a clock later: then the register has what was written, and the next access may
// come. The data of a read is taken READ_CLOCKS after its address.
// An access is to a register of four bytes, whichever of its bytes the address names: read_addr_o and write_addr_o are
// multiples of 4, the strobes say which bytes are written. write_error_i, read_error_i become SLVERR. awprot and arprot are
// ignored. Reset: idle, what was under way is dropped.
module horopter_axil_slave #(
    parameter int unsigned ADDR_BITS = 12,
    parameter int unsigned READ_CLOCKS = 3
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    input  logic [ADDR_BITS-1:0] s_axil_awaddr,
    input  logic                 s_axil_awvalid,
    output logic                 s_axil_awready,
    input  logic [         31:0] s_axil_wdata,
    input  logic [          3:0] s_axil_wstrb,
    input  logic                 s_axil_wvalid,
    output logic                 s_axil_wready,
    output logic [          1:0] s_axil_bresp,
    output logic                 s_axil_bvalid,
    input  logic                 s_axil_bready,
    input  logic [ADDR_BITS-1:0] s_axil_araddr,
    input  logic                 s_axil_arvalid,
    output logic                 s_axil_arready,
    output logic [         31:0] s_axil_rdata,
    output logic [          1:0] s_axil_rresp,
    output logic                 s_axil_rvalid,
    input  logic                 s_axil_rready,
    output logic                 write_valid_o,
    input  logic                 write_ready_i,
    output logic [ADDR_BITS-1:0] write_addr_o,
    output logic [         31:0] write_data_o,
    output logic [          3:0] write_strb_o,
    input  logic                 write_error_i,
    output logic [ADDR_BITS-1:0] read_addr_o,
    input  logic [         31:0] read_data_i,
    input  logic                 read_error_i
);
  localparam logic [1:0] OKAY = 2'b00;
  localparam logic [1:0] SLVERR = 2'b10;

  logic unused_byte;
  assign unused_byte = ^{s_axil_awaddr[1:0], s_axil_araddr[1:0]};

  // Write: both halves are caught, then the access is made while no answer waits.
  logic have_addr_q, have_data_q, accessed_q, error_q, bvalid_q;
  logic [1:0] bresp_q;

  assign s_axil_awready = !have_addr_q;
  assign s_axil_wready = !have_data_q;
  assign write_valid_o = have_addr_q && have_data_q && !accessed_q && !bvalid_q;
  assign s_axil_bvalid = bvalid_q;
  assign s_axil_bresp = bresp_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      have_addr_q <= 1'b0;
      have_data_q <= 1'b0;
      accessed_q <= 1'b0;
      bvalid_q <= 1'b0;
      bresp_q <= OKAY;
    end else begin
      accessed_q <= write_valid_o && write_ready_i;
      if (accessed_q) bvalid_q <= 1'b1;
      else if (s_axil_bready) bvalid_q <= 1'b0;
      if (accessed_q) bresp_q <= error_q ? SLVERR : OKAY;
      if (accessed_q) begin
        have_addr_q <= 1'b0;
        have_data_q <= 1'b0;
      end else begin
        if (s_axil_awvalid) have_addr_q <= 1'b1;
        if (s_axil_wvalid) have_data_q <= 1'b1;
      end
    end
    error_q <= write_error_i;
    if (!have_addr_q) write_addr_o <= {s_axil_awaddr[ADDR_BITS-1:2], 2'b00};
    if (!have_data_q) begin
      write_data_o <= s_axil_wdata;
      write_strb_o <= s_axil_wstrb;
    end
  end

  // Read: address caught, its clocks counted, answer.
  typedef enum logic [1:0] {
    READ_IDLE,
    READ_WAIT,
    READ_ANSWER
  } read_state_e;
  read_state_e read_q;
  logic [READ_CLOCKS:1] waited_q;

  assign s_axil_arready = read_q == READ_IDLE;
  assign s_axil_rvalid = read_q == READ_ANSWER;

  always_ff @(posedge clk_i) begin
    waited_q <= read_q == READ_WAIT ? {waited_q[READ_CLOCKS-1:1], 1'b1} : '0;
    if (!rst_ni) begin
      read_q <= READ_IDLE;
    end else begin
      case (read_q)
        READ_IDLE: if (s_axil_arvalid) read_q <= READ_WAIT;
        READ_WAIT: if (waited_q[READ_CLOCKS]) read_q <= READ_ANSWER;
        default: if (s_axil_rready) read_q <= READ_IDLE;
      endcase
    end
    if (read_q == READ_IDLE) read_addr_o <= {s_axil_araddr[ADDR_BITS-1:2], 2'b00};
    if (read_q == READ_WAIT) begin
      s_axil_rdata <= read_data_i;
      s_axil_rresp <= read_error_i ? SLVERR : OKAY;
    end
  end
endmodule
