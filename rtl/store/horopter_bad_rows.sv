// SPDX-License-Identifier: Apache-2.0
// Which rows of a ring are bad: the span from the oldest bad row to the newest. What lies between them counts as bad, too:
// rows rarely are, and a span takes less than a bit for each row.
//
// row_done_i: the row in slot_i is complete, bad or good; what was there before is forgotten. Slots come in order.
// bad_o: whether row_i is bad, or with below_i the one after it; combinational.
module horopter_bad_rows #(
    parameter int unsigned ROWS = 36,
    parameter int unsigned SLOT_BITS = $clog2(ROWS)
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    input  logic                 row_done_i,
    input  logic                 row_bad_i,
    input  logic [SLOT_BITS-1:0] slot_i,
    input  logic [SLOT_BITS-1:0] row_i,
    input  logic                 below_i,
    output logic                 bad_o
);
  if (ROWS < 4 || SLOT_BITS != $clog2(ROWS)) begin : g_illegal
    $fatal(1, "horopter_bad_rows: ROWS must be at least 4");
  end
  localparam logic [SLOT_BITS-1:0] LAST_SLOT = SLOT_BITS'(ROWS - 1);

  logic any_q;
  logic [SLOT_BITS-1:0] before_q, last_q;  // the span is what follows before_q, up to last_q; all if they are the same
  logic [SLOT_BITS-1:0] first, previous;
  logic ends, begins_later;  // the span's newest row is overwritten, its oldest one
  assign first = before_q == LAST_SLOT ? '0 : before_q + 1'b1;
  assign previous = slot_i == '0 ? LAST_SLOT : slot_i - 1'b1;
  assign ends = !any_q || slot_i == last_q;
  assign begins_later = slot_i == first;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      any_q <= 1'b0;
    end else if (row_done_i) begin
      any_q <= row_bad_i || !ends;
      if (row_bad_i) last_q <= slot_i;
      if (ends) before_q <= previous;
      else if (begins_later) before_q <= slot_i;
    end
  end

  logic after_begin, up_to_end, wraps;
  assign after_begin = {row_i, below_i} > {before_q, 1'b0};
  assign up_to_end = row_i <= last_q;
  assign wraps = before_q >= last_q;
  assign bad_o = any_q && (wraps ? after_begin || up_to_end : after_begin && up_to_end);
endmodule
