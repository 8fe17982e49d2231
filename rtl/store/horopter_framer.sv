// SPDX-License-Identifier: Apache-2.0
// Turns whatever one camera sends into well-formed rows of a frame, and says what was wrong with it.
//
// A row is written pixel by pixel (write_*_o) into the ring slot slot_o and counts once it is complete (row_done_o);
// a row with too few or too many pixels is complete too, but bad. A frame ends with its last row, or early: by a new
// start of frame, by silence (in live mode: by a pause of four line lengths), by an overflow, or by cut_i. Rows that never came are not written: the store treats rows
// from the number of those that came as missing, so that ending a frame takes one clock, whatever is missing.
//
// Frames are opened by the pairing of the two cameras: start_o asks, grant_i admits, deny_i refuses (live mode, no
// room). missing_start: what comes between two frames is no start of frame. It is told when that comes, and again with the
// next frame: nobody knows to which of the two it belongs. After EXTRA_LINES such lines a frame without rows stands for
// the lost one.
//
// Stream: valid/ready with pixel, first (start of frame) and last (end of line); almost_full_i of the FIFO in front
// tells in live mode that waiting is over. All outputs are registers but s_ready_o. Reset: waits for a start of frame; in
// live mode the camera may be in the middle of one, else anything before it is a missing start.
module horopter_framer #(
    parameter int unsigned SLOTS = 64,  // rows of the ring
    parameter int unsigned EXTRA_LINES = 8,
    parameter int unsigned SLOT_BITS = $clog2(SLOTS)
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    // configuration, constant while out of reset (but for the timeout)
    input  logic                 live_i,
    input  logic [         11:0] width_i,
    input  logic [         11:0] height_i,
    input  logic [         31:0] timeout_i,
    // camera
    input  logic                 s_valid_i,
    output logic                 s_ready_o,
    input  logic [          7:0] s_pixel_i,
    input  logic                 s_first_i,
    input  logic                 s_last_i,
    input  logic                 almost_full_i,
    // pairing
    output logic                 start_o,  // wants a frame
    output logic                 empty_o,  // with start_o: a frame without rows, standing for a lost one
    output logic                 urgent_o,  // with start_o, live: cannot wait longer
    input  logic                 grant_i,
    input  logic                 deny_i,
    input  logic                 cut_i,  // end the frame now
    input  logic                 patience_i,  // silence counts from now on
    output logic                 near_o,  // in its first EXTRA_LINES rows
    output logic                 far_o,  // more than 64 px into the frame
    output logic                 deep_o,  // at least 3 / 2 EXTRA_LINES rows into the frame
    output logic                 silent_o,  // for the timeout
    output logic                 gone_o,  // it is silent, or, live, pauses for longer than any pause within a frame
    // into the store
    input  logic [  SLOT_BITS:0] keep_i,  // rows before this one (counted as stored_o) are no longer needed
    output logic [  SLOT_BITS:0] stored_o,  // complete rows so far, modulo twice the ring's or a little more
    output logic [SLOT_BITS-1:0] slot_o,  // slot of the row in progress
    output logic                 write_en_o,
    output logic [SLOT_BITS-1:0] write_slot_o,
    output logic [         11:0] write_x_o,
    output logic [          7:0] write_pixel_o,
    output logic                 write_first_o,  // first pixel of the frame
    output logic                 write_end_o,  // last pixel of a frame that is as tall as it should be
    output logic                 row_done_o,  // with the last pixel of a row
    output logic                 row_bad_o,  // with row_done_o
    output logic                 frame_done_o,  // the frame has ended, for whatever reason
    // faults, one clock each
    output logic                 short_line_o,
    output logic                 long_line_o,
    output logic                 missing_line_o,
    output logic                 missing_start_o,  // of the last frame granted
    output logic                 overflow_o,
    output logic                 lost_silent_o,  // the frame in progress ended in silence
    output logic                 silence_o  // the camera has fallen silent, in a frame or not
);
  if (SLOTS < 4 || SLOTS > 2048 || SLOTS % 2 != 0 || EXTRA_LINES < 2 || EXTRA_LINES > 8) begin : g_illegal
    $fatal(1, "horopter_framer: SLOTS must be even, 4 to 2048, EXTRA_LINES 2 to 8");
  end

  typedef enum logic [2:0] {
    WAIT,  // throw away until a start of frame
    IDLE,  // between frames: the next pixel must be a start of frame
    EXTRA,  // lines without a start of frame
    LOST,  // a frame without a start: asks for an empty frame
    START,  // start of frame seen: asks for a frame
    LINE,  // in a frame
    SKIP,  // in a frame, throwing away the rest of a long line
    SKIP_END  // the same after the last row
  } state_e;
  state_e state_q;

  logic [11:0] x_q, y_q;
  logic [SLOT_BITS:0] stored_q;
  logic [SLOT_BITS-1:0] slot_q;
  logic [2:0] extra_q;
  logic stored_now_q;  // a row was completed in the clock before
  logic granted_q, denied_q;  // what was asked for a clock ago
  logic empty_q;  // and that it was a frame without rows
  logic drop_q;  // the start of frame that has just been denied goes
  logic fresh_q;  // the next pixel is the first of the frame
  logic blocked_q;  // the slot of the row that begins may not be written yet
  logic pending_start_fault_q;
  logic near_q, deep_q, far_q;  // what y_q and x_q say, decided with them: the pairing takes its time

  // The geometry does not change while this runs.
  logic [11:0] before_last_x_q, before_last_y_q;
  always_ff @(posedge clk_i) begin
    before_last_x_q <= width_i - 12'd2;
    before_last_y_q <= height_i - 12'd2;
  end
  logic row_start_q, row_end_q, last_row_q;  // where x_q and y_q stand, decided with them

  // Silence: the camera could send and does not. Clocks left count down, from a clock later on, as that needs no comparison;
  // the choice stands before the adder, whose carry cells take it in.
  logic [31:0] patience_q;
  logic heard, heard_q, out_of_patience_q, silent_q;
  logic [32:0] next_patience;
  assign heard = !rst_ni || s_valid_i || patience_i;
  assign next_patience = {1'b0, heard_q ? timeout_i : patience_q} + {33{!heard_q}};
  always_ff @(posedge clk_i) begin
    heard_q <= heard;
    patience_q <= next_patience[31:0];
    out_of_patience_q <= !heard && next_patience[32];
    silent_q <= !heard && (silent_q || out_of_patience_q);
    silence_o <= !heard && !silent_q && out_of_patience_q;
  end
  assign silent_o = silent_q;

  // A live camera that pauses in a frame for four line lengths has lost lines: the frame ends now, not with the next
  // start of frame, so that the result keeps up with the other camera.
  logic [13:0] pause_q;
  logic [14:0] next_pause;
  logic paused_q, pausing_q, gone_q;
  assign next_pause = {1'b0, heard_q ? {width_i, 2'b00} : pause_q} + {15{!heard_q}};
  always_ff @(posedge clk_i) begin
    pause_q <= next_pause[13:0];
    paused_q <= rst_ni && !s_valid_i && live_i && next_pause[14];
    pausing_q <= rst_ni && !s_valid_i && (pausing_q || paused_q);
    gone_q <= rst_ni && !s_valid_i && ((!patience_i && (silent_q || out_of_patience_q)) || pausing_q || paused_q);
  end
  assign gone_o = gone_q;

  // What the head of the stream means in a frame.
  logic in_frame, restarts, early, take, at_end, complete, last_row, overflow, ends_early;
  assign in_frame = state_q == LINE || state_q == SKIP;
  assign restarts = s_valid_i && s_first_i && !fresh_q;
  assign early = in_frame && restarts;
  assign overflow = state_q == LINE && blocked_q && live_i && almost_full_i;
  assign take = state_q == LINE && s_valid_i && !blocked_q && (fresh_q || !s_first_i);  // a row may end with the frame
  assign at_end = row_end_q;
  assign complete = take && (s_last_i || at_end);
  assign last_row = last_row_q;
  assign ends_early = in_frame && (restarts || overflow || cut_i || gone_q);

  // A start of frame waits for its grant, or is dropped; what comes between frames, or is too much of a row, goes.
  assign s_ready_o = state_q == LINE ? !blocked_q && (fresh_q || !s_first_i) : drop_q || !s_first_i;

  always_ff @(posedge clk_i) begin
    short_line_o <= 1'b0;
    long_line_o <= 1'b0;
    missing_line_o <= 1'b0;
    missing_start_o <= 1'b0;
    overflow_o <= 1'b0;
    lost_silent_o <= 1'b0;
    row_done_o <= 1'b0;
    row_bad_o <= 1'b0;
    frame_done_o <= 1'b0;
    drop_q <= 1'b0;
    if (!rst_ni) begin
      state_q <= live_i ? WAIT : IDLE;
      extra_q <= 3'd0;
      pending_start_fault_q <= 1'b0;
      slot_q <= '0;
      stored_q <= '0;
      near_q <= 1'b1;
      deep_q <= 1'b0;
      far_q <= 1'b0;
      fresh_q <= 1'b0;
    end else begin
      case (state_q)
        WAIT: if (s_valid_i && s_first_i && !drop_q) state_q <= START;

        IDLE:
        if (s_valid_i) begin
          extra_q <= {2'b00, s_last_i};
          state_q <= s_first_i ? START : EXTRA;
          missing_start_o <= !s_first_i;
          pending_start_fault_q <= !s_first_i;
        end

        EXTRA: begin
          if (s_valid_i && s_first_i) begin
            state_q <= START;
          end else if (s_valid_i && s_last_i) begin
            extra_q <= extra_q + 3'd1;
            if (32'(extra_q) == EXTRA_LINES - 1) state_q <= LOST;
          end else if (silent_q) begin
            state_q <= WAIT;
          end
        end

        LOST: begin
          if (s_valid_i && s_first_i) begin
            state_q <= START;
          end else if (granted_q) begin
            state_q <= WAIT;
          end
        end

        START: begin
          row_end_q <= 1'b0;
          last_row_q <= 1'b0;
          near_q <= 1'b1;
          deep_q <= 1'b0;
          far_q <= 1'b0;
          fresh_q <= 1'b1;
          if (granted_q && !empty_q) begin
            state_q <= LINE;
            missing_start_o <= pending_start_fault_q;
            pending_start_fault_q <= 1'b0;
          end else if (denied_q) begin
            state_q <= WAIT;
            drop_q <= 1'b1;
            overflow_o <= 1'b1;
          end
        end

        LINE: begin
          if (take) begin
            fresh_q <= 1'b0;
            row_end_q <= x_q == before_last_x_q;
            if (x_q[6]) far_q <= 1'b1;
          end
          if (complete) begin
            row_end_q <= 1'b0;
            far_q <= 1'b1;
            stored_q <= stored_q + 1'b1;
            slot_q <= 32'(slot_q) == SLOTS - 1 ? '0 : slot_q + 1'b1;
            row_done_o <= 1'b1;
            row_bad_o <= s_last_i != at_end;
            short_line_o <= !at_end;
            long_line_o <= !s_last_i;
            frame_done_o <= last_row;
          end
          // As ends_early, in few levels: a row that is complete has neither restarted nor overflowed.
          if (restarts) begin
            state_q <= START;
          end else if (complete && !cut_i && !gone_q) begin
            if (last_row) state_q <= s_last_i ? IDLE : SKIP_END;
            else if (!s_last_i) state_q <= SKIP;
          end else if ((blocked_q && live_i && almost_full_i) || cut_i || gone_q) begin
            state_q <= WAIT;
          end
        end

        SKIP: begin
          if (restarts) state_q <= START;
          else if (cut_i || gone_q) state_q <= WAIT;
          else if (s_valid_i && s_last_i) state_q <= LINE;
        end

        default: begin  // SKIP_END
          if (s_valid_i && s_first_i) state_q <= START;
          else if (s_valid_i && s_last_i) state_q <= IDLE;
          else if (silent_q) state_q <= WAIT;
        end
      endcase

      // The frame without rows; the start of the next may have come while it was granted.
      if (granted_q && empty_q) begin
        missing_start_o <= 1'b1;
        frame_done_o <= 1'b1;
        pending_start_fault_q <= 1'b0;
      end

      // A clock after the row's end, never in START.
      if (stored_now_q) begin
        last_row_q <= y_q == before_last_y_q;
        // Rows come one by one: it is the first of those with these lowest bits.
        if (y_q[3:0] == 4'(EXTRA_LINES - 1)) near_q <= 1'b0;
        if (y_q[3:0] == 4'(EXTRA_LINES + EXTRA_LINES / 2 - 1)) deep_q <= 1'b1;
      end

      // A frame cut short: by a new start of frame, or by what makes the rest of it worthless.
      if (ends_early) begin
        frame_done_o <= 1'b1;
        // Also where the camera goes on in the clock in which its silence is known: what it sends may be of another frame.
        missing_line_o <= early || (gone_q && !silent_q);
        overflow_o <= overflow && !early;
        lost_silent_o <= silent_q;
      end
    end
  end

  // Where the next pixel goes.
  always_ff @(posedge clk_i) begin
    if (!rst_ni || state_q == START || complete) x_q <= 12'd0;
    else if (take) x_q <= x_q + 12'd1;
    if (!rst_ni || state_q == START) y_q <= 12'd0;
    else if (stored_now_q) y_q <= y_q + 12'd1;
  end

  // Room for the row that begins. What the counters say is a clock old, and older than the row that has just been stored.
  logic [SLOT_BITS:0] used;
  logic full_q, nearly_full_q;
  assign used = stored_q - keep_i;
  always_ff @(posedge clk_i) begin
    full_q <= 32'(used) >= SLOTS;
    nearly_full_q <= 32'(used) >= SLOTS - 1;
    stored_now_q <= complete;
    row_start_q <= complete || state_q == START || (row_start_q && !take);
    if (complete) blocked_q <= nearly_full_q;
    else blocked_q <= (stored_now_q ? blocked_q : full_q) && (state_q == START || (row_start_q && !take));
  end

  always_ff @(posedge clk_i) begin
    write_en_o <= rst_ni && take;
    write_first_o <= fresh_q;
    write_end_o <= complete && last_row;
    if (take) begin
      write_slot_o <= slot_q;
      write_x_o <= x_q;
      write_pixel_o <= s_pixel_i;
    end
  end
  assign near_o = near_q;
  assign deep_o = deep_q;
  assign far_o = far_q;

  // Question and answer count a clock later; until the answer has counted nothing more is asked.
  logic may_ask;
  assign may_ask = rst_ni && !grant_i && !deny_i && !granted_q && !denied_q;
  always_ff @(posedge clk_i) begin
    granted_q <= rst_ni && grant_i;
    denied_q <= rst_ni && deny_i;
    empty_q <= empty_o;
    start_o <= may_ask && (state_q == START || state_q == LOST);
    urgent_o <= may_ask && state_q == START && live_i && almost_full_i;
    empty_o <= state_q == LOST;
  end
  assign stored_o = stored_q;
  assign slot_o = slot_q;
endmodule
