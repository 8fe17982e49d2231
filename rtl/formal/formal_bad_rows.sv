// SPDX-License-Identifier: Apache-2.0
// Proof of horopter_bad_rows for rings of 5 rows: a bad row is said to be bad until its slot is written again, a good one
// only where it came after a bad one and before another.
module formal_bad_rows (
    input logic       clk_i,
    input logic       rst_ni,
    input logic       row_done_i,
    input logic       row_bad_i,
    input logic [2:0] row_i,
    input logic       below_i
);
  localparam int unsigned ROWS = 5;
  logic [2:0] slot = 3'd0;
  logic bad;
  horopter_bad_rows #(
      .ROWS(ROWS)
  ) dut (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .row_done_i(row_done_i),
      .row_bad_i(row_bad_i),
      .slot_i(slot),
      .row_i(row_i),
      .below_i(below_i),
      .bad_o(bad)
  );

  logic [ROWS-1:0] is_bad;
  logic past_valid = 1'b0, alone;  // since all rows were good, one bad one came
  always @(posedge clk_i) begin
    past_valid <= 1'b1;
    if (!rst_ni) begin
      is_bad <= '0;
    end else if (row_done_i) begin
      slot <= slot == ROWS - 1 ? 3'd0 : slot + 3'd1;
      is_bad[slot] <= row_bad_i;
      if (row_bad_i) alone <= (is_bad & ~(ROWS'(1) << slot)) == '0;
    end
  end

  // By age: 0 is the row that is overwritten next.
  logic [2*ROWS-1:0] twice;
  logic [ROWS-1:0] by_age, newer;
  logic [2:0] below_row, age;
  assign twice = {is_bad, is_bad};
  assign by_age = ROWS'(twice >> slot);
  assign below_row = row_i == ROWS - 1 ? 3'd0 : row_i + 3'd1;
  assign age = row_i >= slot ? row_i - slot : row_i + 3'(ROWS) - slot;
  assign newer = by_age & (5'h1F << age);
  always @(*) begin
    if (!past_valid) assume (!rst_ni);
    assume (row_i < ROWS);
    if (past_valid) begin
      if (is_bad[row_i]) assert (bad);
      if (below_i && is_bad[below_row]) assert (bad);
      if (!below_i && !is_bad[row_i] && newer == '0) assert (!bad);
      if (is_bad == '0 || (alone && !is_bad[row_i] && !below_i)) assert (!bad);
      cover (bad && !is_bad[row_i] && !below_i);
      cover (&is_bad && slot == 3'd2);
    end
  end
endmodule
