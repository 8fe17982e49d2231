// SPDX-License-Identifier: Apache-2.0
// Objects of a frame: the stage `objects` on the states as they leave the chain. After the frame's last state it gets idle
// beats, one a clock, until everything has been said.
//
// ended_o: one clock, everything of the frame has been said; overflow_o comes with it. alarm_o: an object of the frame so far,
// or of the last one until the next begins, has reached the limit. frame_*: of the largest object, from ended_o on; 0 without
// one. rst_ni: of the streaming core.
module horopter_object_check #(
    parameter int unsigned COLUMNS = horopter_profile_pkg::WIDTH / horopter_profile_pkg::SUBSAMPLE,
    parameter int unsigned ROWS = horopter_profile_pkg::HEIGHT,
    parameter int unsigned COUNT_BITS = $clog2(COLUMNS * ROWS + 1)
) (
    input  logic                                  clk_i,
    input  logic                                  rst_ni,
    input  logic [              COUNT_BITS-1:0]   object_limit_i,
    input  logic                                  state_valid_i,
    input  logic [                         1:0]   state_i,
    input  logic                                  state_first_i,
    input  logic                                  state_last_i,
    input  logic                                  state_end_i,
    output logic                                  ended_o,
    output logic                                  overflow_o,
    output logic                                  alarm_o,
    output logic [                        23:0]   frame_pixels_o,
    output horopter_csr_pkg::frame_object_columns_t frame_columns_o,
    output horopter_csr_pkg::frame_object_rows_t  frame_rows_o
);
  logic idle_q;  // the frame has ended
  logic valid, object_ended, alarm, overflow, done;
  logic [COUNT_BITS-1:0] pixels, largest_q;
  localparam int unsigned COLUMN_BITS = $clog2(COLUMNS);
  localparam int unsigned ROW_BITS = $clog2(ROWS);
  logic [COLUMN_BITS-1:0] left, right, left_q, right_q;
  logic [ROW_BITS-1:0] top, bottom, top_q, bottom_q;
  logic [COUNT_BITS+COLUMN_BITS-1:0] columns;
  logic [COUNT_BITS+ROW_BITS-1:0] rows;
  logic unused_sums;
  assign unused_sums = ^{columns, rows};
  horopter_objects u_objects (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .en_i(1'b1),
      .valid_i(state_valid_i || idle_q),
      .state_i(state_i),
      .first_i(state_first_i),
      .last_i(state_last_i),
      .idle_i(idle_q),
      .cfg_object_limit_i(object_limit_i),
      .valid_o(valid),
      .ended_o(object_ended),
      .object_pixels_o(pixels),
      .object_left_o(left),
      .object_right_o(right),
      .object_top_o(top),
      .object_bottom_o(bottom),
      .object_columns_o(columns),
      .object_rows_o(rows),
      .alarm_o(alarm),
      .overflow_o(overflow),
      .done_o(done)
  );
  logic waits_q;  // for the end
  always_ff @(posedge clk_i) begin
    ended_o <= rst_ni && valid && done && waits_q && !ended_o;
    if (valid) overflow_o <= overflow;
    alarm_o <= rst_ni && (valid ? alarm : alarm_o);
    if (!rst_ni) idle_q <= 1'b0;
    else idle_q <= (state_valid_i && state_end_i) || (idle_q && !(valid && done));
    if (!rst_ni || ended_o) waits_q <= 1'b0;
    else if (state_valid_i && state_end_i) waits_q <= 1'b1;
    if (!rst_ni || ended_o) largest_q <= '0;
    else if (valid && object_ended && pixels > largest_q) begin
      largest_q <= pixels;
      left_q <= left;
      right_q <= right;
      top_q <= top;
      bottom_q <= bottom;
    end
    if (!rst_ni) begin
      frame_pixels_o <= 24'd0;
      frame_columns_o <= '0;
      frame_rows_o <= '0;
    end else if (ended_o) begin
      frame_pixels_o <= 24'(largest_q);
      frame_columns_o.left <= largest_q == '0 ? 12'd0 : 12'(left_q);
      frame_columns_o.right <= largest_q == '0 ? 12'd0 : 12'(right_q);
      frame_rows_o.top <= largest_q == '0 ? 12'd0 : 12'(top_q);
      frame_rows_o.bottom <= largest_q == '0 ? 12'd0 : 12'(bottom_q);
    end
  end
endmodule
