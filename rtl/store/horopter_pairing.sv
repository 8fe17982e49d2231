// SPDX-License-Identifier: Apache-2.0
// Makes one frame out of two cameras: opens frames, says which camera's rows belong to which frame, keeps the books of
// the (at most two) frames between the cameras and the result.
//
// The first camera that asks opens a frame, the other joins it. Which images belong together:
// - In live mode time says it. A camera joins a frame only near its start; more than 64 px late is the fault skew. Where
//   waiting ends, because an input FIFO fills (urgent), the frame of the camera behind is cut short (skew). A camera that
//   has not come when the other is some rows into the frame will not come (skew). So a broken frame never shifts the later
//   ones. A live camera must pause for four line lengths or more between two images; else rows that were lost at the end of
//   one and at the start of the next can make one frame of both, unnoticed.
// - With back-pressure (live_i = 0) a camera that is ahead waits, and time says nothing. The cameras' images are counted:
//   the first ones after reset belong together, and so do the next. Once a frame was broken (broken_i), or a camera was
//   silent in one, the count is in doubt, and nothing that comes later can settle it: every later frame is a fault, skew,
//   until the reset, that is until CONTROL.enable has been 0. A whole image that a source drops without a trace cannot be
//   noticed here.
// A silent camera gets a frame without rows.
//
// Index 0 = left, 1 = right. A slot is one of two frame records; it is busy from its opening until free_i.
// grant_o and deny_o are combinational from registers; everything else is a register. Reset: no frame.
module horopter_pairing #(
    parameter int unsigned LEFT_BITS = 6,  // bits of a slot number of the left image's ring
    parameter int unsigned RING_BITS = 6  // and of the right one's
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    input  logic                 live_i,
    input  logic [         11:0] height_i,
    // framers
    input  logic [          1:0] start_i,
    input  logic [          1:0] empty_i,
    input  logic [          1:0] urgent_i,
    output logic [          1:0] grant_o,
    output logic [          1:0] deny_o,
    output logic [          1:0] cut_o,
    input  logic [          1:0] near_i,
    input  logic [          1:0] far_i,
    input  logic [          1:0] deep_i,
    input  logic [          1:0] silent_i,
    input  logic [          1:0] gone_i,
    input  logic [          1:0] broken_i,  // the framer has found the frames of its camera broken
    input  logic [          1:0] row_done_i,
    input  logic [          1:0] frame_done_i,
    input  logic [  LEFT_BITS:0] left_stored_i,
    input  logic [LEFT_BITS-1:0] left_slot_i,
    input  logic [  RING_BITS:0] right_stored_i,
    input  logic [RING_BITS-1:0] right_slot_i,
    // the arriving frame
    output logic                 slot_o,
    output logic                 open_o,  // one clock: slot_o has just been opened
    output logic                 arrived_o,  // one clock: both cameras are done with it
    output logic                 skew_o,  // one clock each, faults of slot_o
    output logic [          1:0] lost_silent_o,
    // the frame being output: its record
    output logic [          1:0] busy_o,
    input  logic                 read_slot_i,
    output logic [         11:0] left_rows_o,  // rows that came so far
    output logic                 left_ended_o,  // no more will come
    output logic [         11:0] right_rows_o,
    output logic                 right_ended_o,
    output logic [          1:0] whole_o,  // as many rows came as an image has
    output logic [  LEFT_BITS:0] left_base_o,  // count (as left_stored_i) of its first row
    output logic [LEFT_BITS-1:0] left_base_slot_o,
    output logic [  RING_BITS:0] right_base_o,
    output logic [RING_BITS-1:0] right_base_slot_o,
    input  logic                 active_i,  // it is being output: read_slot_i and its record stay as they are
    output logic                 place_error_o,  // where its first right row lies has changed since it was noted
    input  logic                 free_i  // read_slot_i is published
);
  logic open_q, slot_q;
  logic [1:0] joined_q, ended_q;
  (* nowrshmsk *) logic [1:0] busy_q;  // see horopter_frame_control
  logic [11:0] left_rows_q[2];
  logic [11:0] right_rows_q[2];
  logic [LEFT_BITS:0] left_base_q[2];
  logic [LEFT_BITS-1:0] left_base_slot_q[2];
  logic [RING_BITS:0] base_q[2];
  (* nowrshmsk *) logic [1:0] left_ended_q, right_ended_q;
  logic [RING_BITS-1:0] base_slot_q[2];
  logic base_odd_q[2];  // parity of the two
  logic [1:0] cut_q;
  logic doubtful_q;  // the count of the images is in doubt
  logic live_q;  // constant out of reset; its register lies far away
  always_ff @(posedge clk_i) live_q <= live_i;

  logic [1:0] urgent_q, can_join_q, joins, may_open, opens, missed_q, absent, given_up;
  logic next_slot, can_open_q, done_q;
  assign next_slot = open_q ? !slot_q : slot_q;

  // What a camera may do, decided a clock ahead: it waits for it. Whoever can join does not open.
  always_ff @(posedge clk_i) begin
    urgent_q <= urgent_i;
    done_q <= rst_ni && open_q && ended_q == 2'b11 && opens == 2'b00;
    can_open_q <= rst_ni && (!open_q || ended_q == 2'b11) && !busy_q[next_slot] && opens == 2'b00;
    for (int unsigned c = 0; c < 2; c++) begin
      // In live mode a frame is joined only near its start (one without rows: any time).
      can_join_q[c] <= rst_ni && open_q && !joined_q[c] && (!live_q || empty_i[c] || (near_i[1-c] && joined_q[1-c] && !ended_q[1-c]));
    end
  end
  assign joins = start_i & can_join_q & ~joined_q & ~missed_q;
  assign may_open = start_i & {2{can_open_q}};
  assign opens = joins != 2'b00 ? 2'b00 : {may_open[1] && !may_open[0], may_open[0]};
  assign grant_o = joins | opens;
  assign deny_o = urgent_i & ~grant_o & {2{done_q}};

  // A frame that a camera will not deliver (any more). With back-pressure silence counts from the opening of the frame,
  // which the framer knows one clock later. It joins no more; if it has joined in the clock of the decision, it is there.
  always_comb begin
    for (int unsigned c = 0; c < 2; c++) given_up[c] = silent_i[c] && (!live_q || far_i[1-c] || ended_q[1-c]);
  end
  always_ff @(posedge clk_i) begin
    for (int unsigned c = 0; c < 2; c++)
      missed_q[c] <= rst_ni && open_q && !open_o && !joined_q[c] && !missed_q[c]
          && (given_up[c] || (live_q && (start_i[c] || urgent_q[1-c] || deep_i[1-c])));
  end
  assign absent = missed_q & ~joined_q;

  always_ff @(posedge clk_i) begin
    open_o <= 1'b0;
    arrived_o <= 1'b0;
    skew_o <= open_o && doubtful_q;
    lost_silent_o <= 2'b00;
    cut_q <= 2'b00;
    if (!rst_ni) begin
      doubtful_q <= 1'b0;
      open_q <= 1'b0;
      slot_q <= 1'b0;
      joined_q <= 2'b00;
      ended_q <= 2'b00;
      busy_q <= 2'b00;
      for (int unsigned s = 0; s < 2; s++) begin
        left_rows_q[s] <= 12'd0;
        right_rows_q[s] <= 12'd0;
      end
      left_ended_q <= 2'b00;
      right_ended_q <= 2'b00;
    end else begin
      if (!live_q && (broken_i != 2'b00 || absent != 2'b00)) doubtful_q <= 1'b1;

      if (free_i) begin
        busy_q[read_slot_i] <= 1'b0;
        left_rows_q[read_slot_i] <= 12'd0;
        right_rows_q[read_slot_i] <= 12'd0;
        left_ended_q[read_slot_i] <= 1'b0;
        right_ended_q[read_slot_i] <= 1'b0;
      end

      for (int unsigned c = 0; c < 2; c++) begin
        if (joins[c]) begin
          joined_q[c] <= 1'b1;
          if (live_q && !empty_i[c] && far_i[1-c]) skew_o <= 1'b1;
        end
        if (frame_done_i[c]) ended_q[c] <= 1'b1;
        if (absent[c]) begin
          joined_q[c] <= 1'b1;
          ended_q[c] <= 1'b1;
          lost_silent_o[c] <= gone_i[c];
          if (!gone_i[c]) skew_o <= 1'b1;
        end
        // Live: the other camera's next frame is here and this one is still in the last.
        if (live_q && open_q && joined_q[c] && !ended_q[c] && !frame_done_i[c] && !cut_q[c] && urgent_q[1-c]
            && joined_q[1-c] && ended_q[1-c]) begin
          cut_q[c] <= 1'b1;
          skew_o <= 1'b1;
        end
      end

      if (row_done_i[0]) left_rows_q[slot_q] <= left_rows_q[slot_q] + 12'd1;
      if (row_done_i[1]) right_rows_q[slot_q] <= right_rows_q[slot_q] + 12'd1;
      if (frame_done_i[0] || absent[0]) left_ended_q[slot_q] <= 1'b1;
      if (frame_done_i[1] || absent[1]) right_ended_q[slot_q] <= 1'b1;
      if (open_q && ended_q != 2'b11 && (ended_q | frame_done_i | absent) == 2'b11) arrived_o <= 1'b1;

      if (opens != 2'b00) begin
        open_q <= 1'b1;
        open_o <= 1'b1;
        slot_q <= next_slot;
        joined_q <= opens;
        ended_q <= 2'b00;
        busy_q[next_slot] <= 1'b1;
      end
    end
  end

  // Where a frame begins that may be opened now.
  always_ff @(posedge clk_i) begin
    if (can_open_q) begin
      left_base_q[next_slot] <= left_stored_i;
      left_base_slot_q[next_slot] <= left_slot_i;
      base_q[next_slot] <= right_stored_i;
      base_slot_q[next_slot] <= right_slot_i;
      base_odd_q[next_slot] <= ^{right_stored_i, right_slot_i};
    end
  end

  assign cut_o = cut_q;
  assign slot_o = slot_q;
  assign busy_o = busy_q;

  always_ff @(posedge clk_i) begin
    left_rows_o <= busy_q[read_slot_i] ? left_rows_q[read_slot_i] : 12'd0;
    left_ended_o <= left_ended_q[read_slot_i] && busy_q[read_slot_i];
    right_rows_o <= busy_q[read_slot_i] ? right_rows_q[read_slot_i] : 12'd0;
    right_ended_o <= right_ended_q[read_slot_i] && busy_q[read_slot_i];
    whole_o <= {right_rows_q[read_slot_i] == height_i, left_rows_q[read_slot_i] == height_i};
    left_base_o <= left_base_q[read_slot_i];
    left_base_slot_o <= left_base_slot_q[read_slot_i];
    right_base_o <= base_q[read_slot_i];
    right_base_slot_o <= base_slot_q[read_slot_i];
  end

  // The left store compares its own with where the frame before has ended.
  logic odd_q, wrong_q;
  assign place_error_o = active_i && wrong_q;
  always_ff @(posedge clk_i) begin
    odd_q <= base_odd_q[read_slot_i];
    wrong_q <= ^{right_base_o, right_base_slot_o} != odd_q;
  end
endmodule
