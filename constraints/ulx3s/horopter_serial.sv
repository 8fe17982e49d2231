// SPDX-License-Identifier: Apache-2.0
// Registers over a serial line: 8N1, CLOCKS_PER_BIT clocks a bit, to an AXI4-Lite master.
//
//   host sends   'W' address[7:0] address[15:8] data, 4 bytes, lowest first      answer: status
//                'R' address[7:0] address[15:8]                                  answer: status, data, 4 bytes
// status: 0 done, 2 the register refused (SLVERR), 3 no such address (DECERR), 0xFF no such command, or a byte that was
// no byte (stop bit low): nothing was done, and the next byte is a command again. A command whose next byte does not
// come within GAP_CLOCKS is forgotten without an answer. The host waits for the answer before it sends the next command:
// what comes earlier is lost. Mapping tables are uploaded the same way, through MAP_SLOT, MAP_BASE, MAP_CONTROL and
// MAP_DATA.
module horopter_serial #(
    parameter int unsigned CLOCKS_PER_BIT = 25,
    parameter int unsigned GAP_CLOCKS = 1_000_000
) (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic        rx_i,
    output logic        tx_o,
    output logic [11:0] m_axil_awaddr,
    output logic        m_axil_awvalid,
    input  logic        m_axil_awready,
    output logic [31:0] m_axil_wdata,
    output logic        m_axil_wvalid,
    input  logic        m_axil_wready,
    input  logic [ 1:0] m_axil_bresp,
    input  logic        m_axil_bvalid,
    output logic        m_axil_bready,
    output logic [11:0] m_axil_araddr,
    output logic        m_axil_arvalid,
    input  logic        m_axil_arready,
    input  logic [31:0] m_axil_rdata,
    input  logic [ 1:0] m_axil_rresp,
    input  logic        m_axil_rvalid,
    output logic        m_axil_rready
);
  localparam int unsigned BIT_BITS = $clog2(CLOCKS_PER_BIT + 1);
  localparam int unsigned GAP_BITS = $clog2(GAP_CLOCKS + 1);
  if (CLOCKS_PER_BIT < 4 || GAP_CLOCKS < 20 * CLOCKS_PER_BIT) begin : g_illegal
    $fatal(1, "horopter_serial: CLOCKS_PER_BIT must be at least 4, GAP_CLOCKS at least two bytes");
  end

  // --- receiver: samples the middle of each bit ---
  logic [2:0] rx_q;  // synchroniser
  logic rx_busy_q, byte_valid_q, byte_bad_q;
  logic [BIT_BITS-1:0] rx_count_q;
  logic [3:0] rx_bit_q;
  logic [7:0] byte_q;
  always_ff @(posedge clk_i) begin
    rx_q <= {rx_q[1:0], rx_i};
    byte_valid_q <= 1'b0;
    if (!rst_ni) begin
      rx_q <= 3'b111;
      rx_busy_q <= 1'b0;
    end else if (!rx_busy_q) begin
      rx_count_q <= BIT_BITS'(CLOCKS_PER_BIT / 2);
      rx_bit_q <= 4'd0;
      rx_busy_q <= rx_q[2:1] == 2'b10;
    end else if (rx_count_q != '0) begin
      rx_count_q <= rx_count_q - 1'b1;
    end else begin
      rx_count_q <= BIT_BITS'(CLOCKS_PER_BIT - 1);
      rx_bit_q <= rx_bit_q + 4'd1;
      if (rx_bit_q == 4'd0) rx_busy_q <= !rx_q[2];  // a start bit that was none
      else if (rx_bit_q != 4'd9) byte_q <= {rx_q[2], byte_q[7:1]};
      else begin
        rx_busy_q <= 1'b0;
        byte_valid_q <= 1'b1;
        byte_bad_q <= !rx_q[2];
      end
    end
  end

  // --- commands ---
  typedef enum logic [2:0] {
    COMMAND,
    ADDRESS,
    DATA,
    WRITE,
    READ,
    ANSWER
  } state_e;
  state_e state_q;
  logic is_write_q;
  logic [1:0] index_q;
  logic [15:0] addr_q;
  logic [31:0] data_q;
  logic [39:0] answer_q;
  logic [2:0] answer_left_q;
  logic [GAP_BITS-1:0] gap_q;
  logic tx_ready, tx_start;
  assign tx_start = state_q == ANSWER && tx_ready && answer_left_q != 3'd0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= COMMAND;
      m_axil_awvalid <= 1'b0;
      m_axil_wvalid <= 1'b0;
      m_axil_arvalid <= 1'b0;
    end else begin
      if (m_axil_awready) m_axil_awvalid <= 1'b0;
      if (m_axil_wready) m_axil_wvalid <= 1'b0;
      if (m_axil_arready) m_axil_arvalid <= 1'b0;
      gap_q <= byte_valid_q ? '0 : gap_q + 1'b1;
      case (state_q)
        COMMAND: begin
          index_q <= 2'd0;
          gap_q <= '0;
          answer_q <= 40'hFF;
          answer_left_q <= 3'd1;
          if (byte_valid_q) begin
            is_write_q <= byte_q == "W";
            state_q <= !byte_bad_q && (byte_q == "W" || byte_q == "R") ? ADDRESS : ANSWER;
          end
        end

        ADDRESS:
        if (byte_valid_q) begin
          addr_q <= {byte_q, addr_q[15:8]};
          index_q <= index_q[0] ? 2'd0 : 2'd1;
          if (byte_bad_q) state_q <= ANSWER;
          else if (index_q[0]) begin
            state_q <= is_write_q ? DATA : READ;
            m_axil_arvalid <= !is_write_q && byte_q[7:4] == 4'd0;
          end
        end else if (32'(gap_q) == GAP_CLOCKS) state_q <= COMMAND;

        DATA:
        if (byte_valid_q) begin
          data_q <= {byte_q, data_q[31:8]};
          index_q <= index_q + 2'd1;
          if (byte_bad_q) state_q <= ANSWER;
          else if (index_q == 2'd3) begin
            state_q <= WRITE;
            m_axil_awvalid <= addr_q[15:12] == 4'd0;
            m_axil_wvalid <= addr_q[15:12] == 4'd0;
          end
        end else if (32'(gap_q) == GAP_CLOCKS) state_q <= COMMAND;

        WRITE:
        if (m_axil_bvalid || addr_q[15:12] != 4'd0) begin
          answer_q <= addr_q[15:12] != 4'd0 ? 40'd3 : {38'd0, m_axil_bresp};
          state_q <= ANSWER;
        end

        READ:
        if (m_axil_rvalid || addr_q[15:12] != 4'd0) begin
          answer_q <= addr_q[15:12] != 4'd0 ? 40'd3 : {m_axil_rdata, 6'd0, m_axil_rresp};
          answer_left_q <= 3'd5;
          state_q <= ANSWER;
        end

        default:  // ANSWER
        if (tx_start) begin
          answer_q <= {8'd0, answer_q[39:8]};
          answer_left_q <= answer_left_q - 3'd1;
        end else if (tx_ready && answer_left_q == 3'd0) state_q <= COMMAND;
      endcase
    end
  end
  assign m_axil_awaddr = addr_q[11:0];
  assign m_axil_araddr = addr_q[11:0];
  assign m_axil_wdata = data_q;
  assign m_axil_bready = state_q == WRITE;
  assign m_axil_rready = state_q == READ;

  // --- transmitter ---
  logic [9:0] tx_q;  // what is still to send, the stop bit last
  logic [3:0] tx_left_q;
  logic [BIT_BITS-1:0] tx_count_q;
  assign tx_ready = tx_left_q == 4'd0;
  assign tx_o = tx_q[0];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      tx_q <= '1;
      tx_left_q <= 4'd0;
    end else if (tx_start) begin
      tx_q <= {1'b1, answer_q[7:0], 1'b0};
      tx_left_q <= 4'd10;
      tx_count_q <= BIT_BITS'(CLOCKS_PER_BIT - 1);
    end else if (tx_left_q != 4'd0) begin
      if (tx_count_q != '0) tx_count_q <= tx_count_q - 1'b1;
      else begin
        tx_count_q <= BIT_BITS'(CLOCKS_PER_BIT - 1);
        tx_q <= {1'b1, tx_q[9:1]};
        tx_left_q <= tx_left_q - 4'd1;
      end
    end
  end
endmodule
