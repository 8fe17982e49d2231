// SPDX-License-Identifier: Apache-2.0
// Spans of a mapping table (hls/include/horopter/hls/table_format.hpp): which pixels of a row are outside of its span. Fetches
// a row's word from the pool while the raster generator waits to begin the row, and hands on that one's own reads.
//
// The pool has the words of an even and of the odd row below at one address, from base_i on, before the control points.
// row_i: one clock for each row, from 0 on, at least 2 clocks before its prime beat is issued and after the last beat of the
// row before was. setup_i: the table is known, a clock later first_control_o, too; the next row_i is that of row 0. Word and beat come as long after their
// addresses. outside_o belongs to the beat that is there, 0 of a table without spans. error_o: a word came with a parity
// error. A span whose end is not behind its beginning holds no pixel, wherever both are.
module horopter_row_span #(
    parameter int unsigned ADDR_BITS = 14,
    parameter int unsigned LATENCY = 2  // clocks from an address to its data
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    // table
    input  logic                 spans_i,
    input  logic                 table_ok_i,
    input  logic [ADDR_BITS-1:0] base_i,
    input  logic [         11:0] height_i,
    output logic [ADDR_BITS-1:0] first_control_o,  // behind the spans
    // raster generator
    input  logic                 setup_i,
    input  logic                 row_i,
    input  logic                 read_i,
    input  logic [ADDR_BITS-1:0] even_addr_i,
    input  logic [ADDR_BITS-1:0] odd_addr_i,
    // pool
    output logic                 read_o,
    output logic [ADDR_BITS-1:0] even_addr_o,
    output logic [ADDR_BITS-1:0] odd_addr_o,
    input  logic [         31:0] even_i,
    input  logic [         31:0] odd_i,
    input  logic                 error_i,
    // beats
    input  logic                 valid_i,
    input  logic                 last_i,
    output logic                 outside_o,
    output logic                 error_o
);
  if (LATENCY < 2) begin : g_illegal
    $fatal(1, "horopter_row_span: LATENCY must be 2 or more");
  end

  always_ff @(posedge clk_i)
    first_control_o <= base_i + (spans_i ? ADDR_BITS'(height_i[11:1]) + ADDR_BITS'(height_i[0]) : '0);

  logic fetch_q, odd_q;  // odd_q: the next row is
  logic [ADDR_BITS-1:0] addr_q;
  always_ff @(posedge clk_i) begin
    fetch_q <= rst_ni && row_i && spans_i;
    if (setup_i) begin
      addr_q <= base_i;
      odd_q <= 1'b0;
    end else if (fetch_q) begin
      odd_q <= !odd_q;
      if (odd_q) addr_q <= addr_q + 1'b1;
    end
  end
  assign read_o = read_i || fetch_q;
  assign even_addr_o = fetch_q ? addr_q : even_addr_i;
  assign odd_addr_o = fetch_q ? addr_q : odd_addr_i;

  logic [LATENCY:1] sent_q;
  logic [31:0] word;
  logic [11:0] first_q, end_q;
  assign word = odd_q ? even_i : odd_i;  // a row is longer than a fetch
  always_ff @(posedge clk_i) begin
    if (!rst_ni) sent_q <= '0;
    else sent_q <= {sent_q[LATENCY-1:1], fetch_q};
    error_o <= rst_ni && sent_q[LATENCY] && error_i && table_ok_i;
    if (sent_q[LATENCY]) begin
      first_q <= word[11:0];
      end_q <= word[27:16];
    end
  end

  // Of the pixel that comes with the next beat; after the prime beat that is the first.
  logic [11:0] x_q;
  logic outside_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) x_q <= 12'd0;
    else if (valid_i) x_q <= last_i ? 12'd0 : x_q + 12'd1;
    if (valid_i) outside_q <= x_q < first_q || x_q >= end_q;
  end
  assign outside_o = outside_q && spans_i;

  logic unused_bits;
  assign unused_bits = ^{word[31:28], word[15:12]};
endmodule
