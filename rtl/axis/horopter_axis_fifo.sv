// SPDX-License-Identifier: Apache-2.0
// FIFO of a valid/ready stream in a synchronous memory, with its output in a register.
//
// Holds DEPTH words in the memory (a power of two) and two more at its output. Throughput one word a clock, latency
// 4 clocks when empty. s_ready_o is 0 while the memory is full. almost_full_o (registered) is 1 once ALMOST_FULL or more words are in the memory: a source that sees it may have
// DEPTH - ALMOST_FULL - 2 words under way.
// overflow_o: one clock, a word came while s_ready_o was 0 and was dropped (a source that ignores s_ready_o).
// Once m_valid_o is 1, m_data_o holds until m_ready_i. Reset: empty.
module horopter_axis_fifo #(
    parameter int unsigned WIDTH = 8,
    parameter int unsigned DEPTH = 16,
    parameter int unsigned ALMOST_FULL = DEPTH / 2
) (
    input  logic             clk_i,
    input  logic             rst_ni,
    input  logic             s_valid_i,
    output logic             s_ready_o,
    input  logic [WIDTH-1:0] s_data_i,
    output logic             m_valid_o,
    input  logic             m_ready_i,
    output logic [WIDTH-1:0] m_data_o,
    output logic             almost_full_o,
    output logic             overflow_o
);
  localparam int unsigned ADDR_BITS = $clog2(DEPTH);

  if (WIDTH == 0 || DEPTH < 4 || DEPTH != 1 << ADDR_BITS) begin : g_illegal_depth
    $fatal(1, "horopter_axis_fifo: WIDTH must be positive, DEPTH a power of two of at least 4");
  end
  if (ALMOST_FULL == 0 || ALMOST_FULL > DEPTH) begin : g_illegal_level
    $fatal(1, "horopter_axis_fifo: ALMOST_FULL must be from 1 to DEPTH");
  end

  logic [ADDR_BITS-1:0] write_q, read_q;
  logic [ADDR_BITS:0] level;  // words in the memory
  logic full, empty_q, write, read, fetched_q, valid_q, advance;
  logic [WIDTH-1:0] fetched, data_q;

  assign full = level[ADDR_BITS];
  assign s_ready_o = !full;
  assign write = s_valid_i && !full;
  // Output register, then the memory's own output, move up when they are empty or emptied.
  assign advance = !valid_q || m_ready_i;
  assign read = !empty_q && (!fetched_q || advance);

  logic unused_parity;
  horopter_ram #(
      .WIDTH(WIDTH),
      .DEPTH(DEPTH)
  ) u_ram (
      .clk_i(clk_i),
      .write_en_i(write),
      .write_addr_i(write_q),
      .write_data_i(s_data_i),
      .read_en_i(read),
      .read_addr_i(read_q),
      .read_data_o(fetched),
      .parity_error_o(unused_parity)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q <= '0;
      read_q <= '0;
      level <= '0;
      empty_q <= 1'b1;
      fetched_q <= 1'b0;
      valid_q <= 1'b0;
      almost_full_o <= 1'b0;
      overflow_o <= 1'b0;
    end else begin
      if (write) write_q <= write_q + 1'b1;
      if (read) read_q <= read_q + 1'b1;
      if (write != read) level <= level + {{ADDR_BITS{read}}, 1'b1};  // one less or one more
      empty_q <= level[ADDR_BITS:1] == '0 && (read || !level[0]);  // a word that comes counts a clock later
      if (read) fetched_q <= 1'b1;
      else if (advance) fetched_q <= 1'b0;
      if (advance) valid_q <= fetched_q;
      almost_full_o <= 32'(level) >= ALMOST_FULL;
      overflow_o <= s_valid_i && full;
    end
    if (advance) data_q <= fetched;
  end

  assign m_valid_o = valid_q;
  assign m_data_o = data_q;
endmodule
