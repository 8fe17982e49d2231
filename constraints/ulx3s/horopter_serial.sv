// SPDX-License-Identifier: Apache-2.0
// Registers over a serial line: requests and answers in frames with sequence number and CRC, to an AXI4-Lite master and to
// the board's own registers. The protocol, and why a table can only arrive whole: docs/boards.md.
//
// Words of a request, without the CRC:  {address[15:0], kind[1:0], words[5:0] - 1, sequence[7:0]}, then the data
//   OPEN   one word, that comes back: begins a session; the next request has this sequence number + 1
//   READ   the registers from the address on, one after the other
//   WRITE  all words to the register at the address, one after the other
// Words of an answer: data of a READ, the word of an OPEN, then {word[7:0], status[7:0], expected[7:0], sequence[7:0]}:
// the sequence number of the request, the one that is expected next, and at which word an access was refused.
// A WRITE is carried out once, in its turn. When one is refused, all later ones are until the next OPEN.
// Addresses below 1000 hex are the machine's registers, from 8000 hex on the board's: board_*, read data a clock after
// the address.
module horopter_serial #(
    parameter int unsigned CLOCK_HZ = 25_000_000,
    parameter int unsigned BAUD = 1_000_000
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
    output logic        m_axil_rready,
    output logic [14:0] board_addr_o,
    output logic        board_write_o,
    output logic [31:0] board_wdata_o,
    input  logic [31:0] board_rdata_i
);
  localparam logic [1:0] OPEN = 2'd0;
  localparam logic [1:0] READ = 2'd1;
  localparam logic [1:0] WRITE = 2'd2;
  localparam logic [7:0] DONE = 8'd0;  // or the response of AXI: 2 refused, 3 no such address
  localparam logic [7:0] NO_SESSION = 8'd4;
  localparam logic [7:0] NOT_ITS_TURN = 8'd5;

  logic rx_valid, rx_broken, tx_valid, tx_ready;
  logic [7:0] rx_byte, tx_byte;
  horopter_uart #(
      .CLOCK_HZ(CLOCK_HZ),
      .BAUD(BAUD)
  ) u_uart (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .rx_i(rx_i),
      .tx_o(tx_o),
      .rx_valid_o(rx_valid),
      .rx_broken_o(rx_broken),
      .rx_byte_o(rx_byte),
      .tx_valid_i(tx_valid),
      .tx_ready_o(tx_ready),
      .tx_byte_i(tx_byte)
  );

  logic frame_valid, frame_done;
  logic [6:0] frame_words, index_q;
  logic [31:0] frame_word;
  horopter_frame_receiver u_receiver (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .byte_valid_i(rx_valid),
      .byte_broken_i(rx_broken),
      .byte_i(rx_byte),
      .valid_o(frame_valid),
      .words_o(frame_words),
      .index_i(index_q),
      .word_o(frame_word),
      .done_i(frame_done)
  );

  logic send_valid, send_ready, send_last;
  logic [31:0] send_word;
  horopter_frame_sender u_sender (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .word_valid_i(send_valid),
      .word_ready_o(send_ready),
      .word_last_i(send_last),
      .word_i(send_word),
      .byte_valid_o(tx_valid),
      .byte_ready_i(tx_ready),
      .byte_o(tx_byte)
  );

  typedef enum logic [3:0] {
    IDLE,
    HEADER,  // it comes out of the receiver
    JUDGE,
    FETCH,  // the next word
    ACCESS,
    WAIT,  // for the bus
    BOARD,
    DATA,
    ANSWER,
    FREE
  } state_e;
  state_e state_q;
  logic [7:0] number_q, expected_q, status_q, word_q;
  logic [7:0] broken_q;  // status of the WRITE that was refused, 0 without
  logic session_q;
  logic [1:0] kind_q;
  logic [5:0] left_q;  // words after this one
  logic [15:0] addr_q;
  logic [31:0] data_q;

  // Of the header.
  logic [1:0] kind;
  logic [7:0] number;
  logic [6:0] words;
  logic well_formed;
  assign number = frame_word[7:0];
  assign words = {1'b0, frame_word[13:8]} + 7'd1;
  assign kind = frame_word[15:14];
  assign well_formed = kind == OPEN ? frame_words == 7'd2 : kind == READ ? frame_words == 7'd1
      : kind == WRITE && frame_words == words + 7'd1;

  logic bus_done, exists, to_board;
  logic [1:0] response;
  assign to_board = addr_q[15];
  assign exists = addr_q[15:12] == 4'd0;
  assign bus_done = kind_q == WRITE ? m_axil_bvalid : m_axil_rvalid;
  assign response = kind_q == WRITE ? m_axil_bresp : m_axil_rresp;

  always_ff @(posedge clk_i) begin
    if (m_axil_awready) m_axil_awvalid <= 1'b0;
    if (m_axil_wready) m_axil_wvalid <= 1'b0;
    if (m_axil_arready) m_axil_arvalid <= 1'b0;
    board_write_o <= 1'b0;
    case (state_q)
      IDLE: begin
        index_q <= 7'd0;
        if (frame_valid && index_q == 7'd0) state_q <= HEADER;
      end

      HEADER: state_q <= JUDGE;

      JUDGE: begin
        number_q <= number;
        kind_q <= kind;
        left_q <= kind == OPEN ? 6'd0 : frame_word[13:8];
        addr_q <= frame_word[31:16];
        word_q <= 8'd0;
        index_q <= 7'd1;
        status_q <= DONE;
        state_q <= FETCH;
        if (!well_formed) begin
          state_q <= FREE;
        end else if (kind == OPEN) begin
          session_q <= 1'b1;
          broken_q <= DONE;
          expected_q <= number + 8'd1;
        end else if (!session_q) begin
          status_q <= NO_SESSION;
          state_q <= ANSWER;
        end else if (kind == WRITE && broken_q != DONE) begin
          status_q <= broken_q;
          state_q <= ANSWER;
        end else if (number == expected_q) begin
          expected_q <= expected_q + 8'd1;
        end else if (kind == WRITE) begin
          status_q <= NOT_ITS_TURN;
          state_q <= ANSWER;
        end
      end

      FETCH: state_q <= ACCESS;

      ACCESS: begin
        data_q <= frame_word;
        board_write_o <= kind_q == WRITE && to_board;
        if (kind_q == OPEN) begin
          state_q <= DATA;
        end else if (to_board) begin
          state_q <= BOARD;
        end else if (!exists) begin
          status_q <= 8'd3;
          if (kind_q == WRITE) broken_q <= 8'd3;
          state_q <= ANSWER;
        end else begin
          m_axil_awvalid <= kind_q == WRITE;
          m_axil_wvalid <= kind_q == WRITE;
          m_axil_arvalid <= kind_q == READ;
          state_q <= WAIT;
        end
      end

      WAIT:
      if (bus_done) begin
        if (kind_q == READ) data_q <= m_axil_rdata;
        state_q <= DATA;
        if (response != 2'd0) begin
          status_q <= {6'd0, response};
          if (kind_q == WRITE) broken_q <= {6'd0, response};
          state_q <= ANSWER;
        end
      end

      BOARD: begin
        if (kind_q == READ) data_q <= board_rdata_i;
        state_q <= DATA;
      end

      DATA:
      if (kind_q == WRITE || send_ready) begin
        index_q <= index_q + 7'd1;
        left_q <= left_q - 6'd1;
        word_q <= word_q + 8'd1;
        if (kind_q == READ) addr_q <= addr_q + 16'd4;
        state_q <= left_q == 6'd0 ? ANSWER : FETCH;
      end

      ANSWER: if (send_ready) state_q <= FREE;

      default: begin  // FREE
        index_q <= 7'd0;
        state_q <= IDLE;
      end
    endcase
    if (!rst_ni) begin
      state_q <= IDLE;
      session_q <= 1'b0;
      broken_q <= DONE;
      m_axil_awvalid <= 1'b0;
      m_axil_wvalid <= 1'b0;
      m_axil_arvalid <= 1'b0;
      board_write_o <= 1'b0;
    end
  end
  assign frame_done = state_q == FREE;
  assign send_valid = (state_q == DATA && kind_q != WRITE) || state_q == ANSWER;
  assign send_last = state_q == ANSWER;
  assign send_word = state_q == ANSWER ? {word_q, status_q, expected_q, number_q} : data_q;
  assign m_axil_awaddr = addr_q[11:0];
  assign m_axil_araddr = addr_q[11:0];
  assign m_axil_wdata = data_q;
  assign m_axil_bready = state_q == WAIT;
  assign m_axil_rready = state_q == WAIT;
  assign board_addr_o = addr_q[14:0];
  assign board_wdata_o = data_q;
endmodule
