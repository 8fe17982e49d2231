// SPDX-License-Identifier: Apache-2.0
// Bytes over a serial line: 8 data bits, no parity, 1 stop bit. BAUD need not divide CLOCK_HZ: bits are counted in
// fractions of a clock, so that each edge is at most one clock off.
//
// rx_valid_o: for one clock, in the middle of the stop bit. rx_broken_o with it: there was no stop bit.
module horopter_uart #(
    parameter int unsigned CLOCK_HZ = 25_000_000,
    parameter int unsigned BAUD = 1_000_000
) (
    input  logic       clk_i,
    input  logic       rst_ni,
    input  logic       rx_i,
    output logic       tx_o,
    output logic       rx_valid_o,
    output logic       rx_broken_o,
    output logic [7:0] rx_byte_o,
    input  logic       tx_valid_i,
    output logic       tx_ready_o,
    input  logic [7:0] tx_byte_i
);
  // A bit is over when so many steps are: CLOCK / STEP clocks.
  localparam int unsigned CLOCK = CLOCK_HZ / 100;
  localparam int unsigned STEP = BAUD / 100;
  localparam int unsigned BITS = $clog2(CLOCK + STEP);
  if (CLOCK_HZ % 100 != 0 || BAUD % 100 != 0 || STEP == 0 || CLOCK < 8 * STEP) begin : g_illegal
    $fatal(1, "horopter_uart: CLOCK_HZ must be at least 8 times BAUD, both multiples of 100");
  end

  // --- receiver: samples the middle of each bit ---
  logic [2:0] line_q;  // synchroniser
  logic busy_q, sample;
  logic [3:0] bit_q;
  logic [BITS-1:0] rx_phase_q;
  assign sample = rx_phase_q >= BITS'(CLOCK);
  always_ff @(posedge clk_i) begin
    line_q <= {line_q[1:0], rx_i};
    rx_valid_o <= 1'b0;
    if (!rst_ni) begin
      line_q <= 3'b111;
      busy_q <= 1'b0;
    end else if (!busy_q) begin
      rx_phase_q <= BITS'(CLOCK / 2);
      bit_q <= 4'd0;
      busy_q <= line_q[2:1] == 2'b10;
    end else begin
      rx_phase_q <= sample ? rx_phase_q - BITS'(CLOCK - STEP) : rx_phase_q + BITS'(STEP);
      if (sample) begin
        bit_q <= bit_q + 4'd1;
        if (bit_q == 4'd0) busy_q <= !line_q[2];  // a start bit that was none
        else if (bit_q != 4'd9) rx_byte_o <= {line_q[2], rx_byte_o[7:1]};
        else begin
          busy_q <= 1'b0;
          rx_valid_o <= 1'b1;
          rx_broken_o <= !line_q[2];
        end
      end
    end
  end

  // --- transmitter ---
  logic [9:0] shift_q;  // what is still to send, the stop bit last
  logic [3:0] left_q;
  logic [BITS-1:0] tx_phase_q;
  assign tx_ready_o = left_q == 4'd0;
  assign tx_o = shift_q[0];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      shift_q <= '1;
      left_q <= 4'd0;
    end else if (tx_ready_o) begin
      tx_phase_q <= BITS'(STEP);
      if (tx_valid_i) begin
        shift_q <= {1'b1, tx_byte_i, 1'b0};
        left_q <= 4'd10;
      end
    end else if (tx_phase_q >= BITS'(CLOCK)) begin
      tx_phase_q <= tx_phase_q - BITS'(CLOCK - STEP);
      shift_q <= {1'b1, shift_q[9:1]};
      left_q <= left_q - 4'd1;
    end else begin
      tx_phase_q <= tx_phase_q + BITS'(STEP);
    end
  end
endmodule
