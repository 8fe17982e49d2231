// SPDX-License-Identifier: Apache-2.0
// Frame control: collects the faults of each frame, publishes a frame when its last state has left, decides what is safe.
//
// Faults are vectors in the bit order of the register FAULTS. arriving_faults_i belong to the frame record open_slot_i,
// health results to the record in which the camera's frame ended, output_faults_i to the frame being output,
// event_faults_i to the next frame published. transient_faults_i make not safe at once, but belong to no frame.
//
// A frame is published, publish_o for one clock, when its last state and its last run have left and its counts are
// there. In the same clock all frame_* outputs change, frame_done_o = 1, heartbeat_o toggles.
// safe_o rises only then, and only if the frame had no fault and no alarm and nothing speaks against the next one; it
// falls with any fault, with the watchdog, and while safe_allowed_i is 0. unsafe_o is decided and stored on its own.
// Reset: not safe.
module horopter_frame_control #(
    parameter int unsigned FAULTS = 31,
    parameter int unsigned LEFT_HEALTH_LSB = 6,  // black, white, constant, frozen
    parameter int unsigned RIGHT_HEALTH_LSB = 17,
    parameter int unsigned LEFT_CAMERA_MASK = 32'h0000_003F,  // faults after which a frame may lack its image check
    parameter int unsigned RIGHT_CAMERA_MASK = 32'h0001_F800,
    parameter int unsigned SKEW_MASK = 32'h0040_0000,
    parameter int unsigned NO_TABLE_BIT = 24,
    parameter int unsigned TOO_UNDECIDABLE_BIT = 27,
    parameter int unsigned TOO_UNSUPERVISED_BIT = 28,
    parameter int unsigned LATE_BIT = 29,
    parameter int unsigned INTERNAL_BIT = 30
) (
    input  logic              clk_i,
    input  logic              rst_ni,
    input  logic              safe_allowed_i,
    input  logic [      31:0] timeout_i,
    // frames coming in
    input  logic              open_i,  // open_slot_i has just been opened
    input  logic              open_slot_i,
    input  logic [       1:0] busy_i,
    input  logic              arrived_i,
    input  logic [       1:0] health_end_i,  // last pixel of a camera's frame goes to its image check
    input  logic [       1:0] health_valid_i,
    input  logic [       3:0] left_health_i,  // frozen, constant, white, black
    input  logic [       3:0] right_health_i,
    input  logic [FAULTS-1:0] arriving_faults_i,
    input  logic [FAULTS-1:0] event_faults_i,
    input  logic [FAULTS-1:0] transient_faults_i,
    input  logic [       1:0] silent_i,
    // frame going out
    input  logic              begin_i,
    input  logic              active_i,
    input  logic              read_slot_i,
    input  logic              table_ok_i,
    input  logic [       3:0] table_slot_i,
    input  logic [      31:0] table_crc_i,
    input  logic [FAULTS-1:0] output_faults_i,
    input  logic              miss_i,  // a pixel that missed its source row
    input  logic              state_first_i,  // its first state leaves
    input  logic              state_end_i,  // its last state leaves
    input  logic              runs_end_i,  // its last run leaves
    input  logic              counts_valid_i,
    input  logic [      23:0] skin_i,
    input  logic [      23:0] undecidable_i,
    input  logic [      23:0] unsupervised_i,
    input  logic              alarm_i,
    input  logic              too_undecidable_i,
    input  logic              too_unsupervised_i,
    output logic              publish_o,
    // the last published frame
    output logic [      31:0] frame_sequence_o,
    output logic              frame_alarm_o,
    output logic              frame_safe_o,
    output logic [       3:0] frame_slot_o,
    output logic [FAULTS-1:0] frame_faults_o,
    output logic [      31:0] frame_table_crc_o,
    output logic [      23:0] frame_skin_o,
    output logic [      23:0] frame_undecidable_o,
    output logic [      23:0] frame_unsupervised_o,
    output logic [      23:0] frame_misses_o,
    output logic [      31:0] frame_cycles_o,
    output logic [      31:0] frame_latency_o,
    output logic [      31:0] frame_tail_o,
    output logic              frame_done_o,
    // now
    output logic [FAULTS-1:0] fault_set_o,  // every fault, one clock when it is found
    output logic              late_o,
    output logic              heartbeat_o,
    output logic              safe_o,
    output logic              unsafe_o
);
  localparam logic [FAULTS-1:0] NONE = '0;
  localparam logic [FAULTS-1:0] INTERNAL = FAULTS'(1) << INTERNAL_BIT;
  localparam logic [FAULTS-1:0] LATE = FAULTS'(1) << LATE_BIT;
  localparam logic [FAULTS-1:0] NO_TABLE = FAULTS'(1) << NO_TABLE_BIT;
  localparam logic [FAULTS-1:0] LEFT_EXCUSE = FAULTS'(LEFT_CAMERA_MASK | SKEW_MASK);
  localparam logic [FAULTS-1:0] RIGHT_EXCUSE = FAULTS'(RIGHT_CAMERA_MASK | SKEW_MASK);

  // --- faults, registered, so that their sources may be slow ---
  logic [FAULTS-1:0] arriving_q, left_health_q, right_health_q, outgoing_q, event_in_q, transient_q;
  logic open_q, open_slot_q, left_slot_q, right_slot_q, late_rises;
  logic [4:0] begin_q;  // the table's entry is there some clocks after the begin
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      arriving_q <= NONE;
      left_health_q <= NONE;
      right_health_q <= NONE;
      outgoing_q <= NONE;
      event_in_q <= NONE;
      transient_q <= NONE;
      open_q <= 1'b0;
      begin_q <= 5'd0;
    end else begin
      arriving_q <= arriving_faults_i;
      left_health_q <= health_valid_i[0] ? FAULTS'(left_health_i) << LEFT_HEALTH_LSB : NONE;
      right_health_q <= health_valid_i[1] ? FAULTS'(right_health_i) << RIGHT_HEALTH_LSB : NONE;
      outgoing_q <= output_faults_i | (begin_q[4] && !table_ok_i ? NO_TABLE : NONE)
          | (counts_valid_i && too_undecidable_i ? FAULTS'(1) << TOO_UNDECIDABLE_BIT : NONE)
          | (counts_valid_i && too_unsupervised_i ? FAULTS'(1) << TOO_UNSUPERVISED_BIT : NONE);
      event_in_q <= event_faults_i;
      transient_q <= transient_faults_i | (late_rises ? LATE : NONE);
      open_q <= open_i;
      begin_q <= {begin_q[3:0], begin_i};
    end
    open_slot_q <= open_slot_i;
    if (health_end_i[0]) left_slot_q <= open_slot_i;
    if (health_end_i[1]) right_slot_q <= open_slot_i;
  end

  // --- where they belong: a frame record, or, if that is closed already, to the next frame published ---
  logic state_ended_q, runs_ended_q, counted_q;
  logic complete, publishing, publish_q;
  logic [1:0] accepts;  // records that still take faults
  logic [FAULTS-1:0] set_record0, set_record1, set_event;
  assign complete = active_i && state_ended_q && runs_ended_q && counted_q && !publishing && !publish_q && !publish_o;
  always_ff @(posedge clk_i) begin
    publishing <= rst_ni && complete;
    accepts <= busy_i;
    if (complete || publishing || publish_q || publish_o) accepts[read_slot_i] <= 1'b0;
  end
  always_comb begin
    set_record0 = NONE;
    set_record1 = NONE;
    set_event = event_in_q;
    if (!accepts[open_slot_q]) set_event = set_event | arriving_q;
    else if (open_slot_q) set_record1 = set_record1 | arriving_q;
    else set_record0 = set_record0 | arriving_q;
    if (!accepts[left_slot_q]) set_event = set_event | left_health_q;
    else if (left_slot_q) set_record1 = set_record1 | left_health_q;
    else set_record0 = set_record0 | left_health_q;
    if (!accepts[right_slot_q]) set_event = set_event | right_health_q;
    else if (right_slot_q) set_record1 = set_record1 | right_health_q;
    else set_record0 = set_record0 | right_health_q;
    if (!accepts[read_slot_i]) set_event = set_event | outgoing_q;
    else if (read_slot_i) set_record1 = set_record1 | outgoing_q;
    else set_record0 = set_record0 | outgoing_q;
  end

  logic [FAULTS-1:0] faults0_q, faults1_q, event_q, total_q, read_faults;
  logic [1:0] left_checked_q, right_checked_q;  // by record
  logic [1:0] bad_q;  // by record
  logic found_q, others_bad_q;
  assign read_faults = (read_slot_i ? faults1_q : faults0_q) | event_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      faults0_q <= NONE;
      faults1_q <= NONE;
      event_q <= NONE;
      left_checked_q <= 2'b00;
      right_checked_q <= 2'b00;
      fault_set_o <= NONE;
      found_q <= 1'b0;
      bad_q <= 2'b00;
      others_bad_q <= 1'b0;
      total_q <= NONE;
    end else begin
      faults0_q <= (open_q && !open_slot_q ? NONE : faults0_q) | set_record0;
      faults1_q <= (open_q && open_slot_q ? NONE : faults1_q) | set_record1;
      event_q <= (publishing ? NONE : event_q) | set_event;
      if (open_q) begin
        left_checked_q[open_slot_q] <= 1'b0;
        right_checked_q[open_slot_q] <= 1'b0;
      end
      if (health_valid_i[0]) left_checked_q[left_slot_q] <= 1'b1;
      if (health_valid_i[1]) right_checked_q[right_slot_q] <= 1'b1;
      // A frame without its image checks, and without a camera fault that explains it, was not checked: not safe.
      if (publishing)
        total_q <= read_faults
            | ((!left_checked_q[read_slot_i] && (read_faults & LEFT_EXCUSE) == NONE)
               || (!right_checked_q[read_slot_i] && (read_faults & RIGHT_EXCUSE) == NONE) ? INTERNAL : NONE);
      fault_set_o <= set_record0 | set_record1 | set_event | transient_q | (publish_q ? total_q & INTERNAL : NONE);
      found_q <= fault_set_o != NONE;
      // Until this has followed a fault, fault_set_o and found_q tell of it.
      bad_q <= {faults1_q != NONE, faults0_q != NONE};
      others_bad_q <= bad_q[!read_slot_i] && busy_i[!read_slot_i];
    end
  end

  // --- publishing: publishing closes the record, publish_q takes the picture, publish_o tells ---
  logic [31:0] time_q, first_time_q;  // counts down: so the choice of a record merges into the subtraction (scripts/ecp5.py)
  logic [31:0] open_time0_q, open_time1_q, arrived_time0_q, arrived_time1_q;  // by record; a memory for two would be larger
  logic [31:0] open_time, arrived_time;  // of the frame being output
  assign open_time = read_slot_i ? open_time1_q : open_time0_q;
  assign arrived_time = read_slot_i ? arrived_time1_q : arrived_time0_q;
  logic state_first_q, first_seen_q, alarm_q;
  logic [23:0] skin_q, undecidable_q, unsupervised_q, misses_q;
  logic good;
  assign good = total_q == NONE && !alarm_q && table_ok_i;
  always_ff @(posedge clk_i) begin
    publish_q <= 1'b0;
    publish_o <= 1'b0;
    frame_done_o <= 1'b0;
    state_first_q <= state_first_i;
    if (state_first_q && !first_seen_q) first_time_q <= time_q;
    if (counts_valid_i) begin
      skin_q <= skin_i;
      undecidable_q <= undecidable_i;
      unsupervised_q <= unsupervised_i;
    end
    if (!rst_ni) begin
      time_q <= 32'd0;
      state_ended_q <= 1'b0;
      runs_ended_q <= 1'b0;
      counted_q <= 1'b0;
      first_seen_q <= 1'b0;
      alarm_q <= 1'b1;
      misses_q <= 24'd0;
      frame_sequence_o <= 32'd0;
      frame_alarm_o <= 1'b0;
      frame_safe_o <= 1'b0;
      frame_slot_o <= 4'd15;
      frame_faults_o <= NONE;
      frame_skin_o <= 24'd0;
      frame_undecidable_o <= 24'd0;
      frame_unsupervised_o <= 24'd0;
      frame_misses_o <= 24'd0;
      frame_cycles_o <= 32'd0;
      frame_latency_o <= 32'd0;
      frame_tail_o <= 32'd0;
      heartbeat_o <= 1'b0;
    end else begin
      time_q <= time_q - 32'd1;
      if (open_i && !open_slot_i) open_time0_q <= time_q;
      if (open_i && open_slot_i) open_time1_q <= time_q;
      if (arrived_i && !open_slot_i) arrived_time0_q <= time_q;
      if (arrived_i && open_slot_i) arrived_time1_q <= time_q;
      if (begin_i || publish_q) begin
        state_ended_q <= 1'b0;
        runs_ended_q <= 1'b0;
        counted_q <= 1'b0;
        first_seen_q <= 1'b0;
        alarm_q <= 1'b1;
        misses_q <= 24'd0;
      end else if (active_i) begin
        if (state_first_q) first_seen_q <= 1'b1;
        if (state_end_i) state_ended_q <= 1'b1;
        if (runs_end_i) runs_ended_q <= 1'b1;
        if (counts_valid_i) begin
          counted_q <= 1'b1;
          alarm_q <= alarm_i;
        end
        if (miss_i) misses_q <= misses_q + 24'd1;  // no more than pixels
      end

      publish_q <= publishing;
      if (publish_q) begin
        publish_o <= 1'b1;
        frame_done_o <= 1'b1;
        heartbeat_o <= !heartbeat_o;
        frame_sequence_o <= frame_sequence_o + 32'd1;
        frame_alarm_o <= alarm_q;
        frame_safe_o <= good;
        frame_slot_o <= table_ok_i ? table_slot_i : 4'd15;
        frame_faults_o <= total_q;
        frame_skin_o <= skin_q;
        frame_undecidable_o <= undecidable_q;
        frame_unsupervised_o <= unsupervised_q;
        frame_misses_o <= misses_q;
        frame_cycles_o <= open_time - time_q;
        frame_latency_o <= open_time + ~first_time_q;  // one less: it was noted a clock late
        frame_tail_o <= arrived_time - time_q;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni || (publish_q && !table_ok_i)) frame_table_crc_o <= 32'd0;
    else if (publish_q) frame_table_crc_o <= table_crc_i;
  end

  // --- watchdog: counts down, the choice before the adder, see horopter_framer ---
  logic [31:0] watchdog_q;
  logic [32:0] next_watchdog;
  logic finished, finished_q;
  assign finished = !rst_ni || publish_q;
  assign next_watchdog = {1'b0, finished_q ? timeout_i : watchdog_q} + {33{!finished_q}};
  assign late_rises = !late_o && next_watchdog[32];
  always_ff @(posedge clk_i) begin
    finished_q <= finished;
    watchdog_q <= next_watchdog[31:0];
    late_o <= !finished && (late_o || late_rises);
  end

  // --- safe ---
  initial begin  // before the first clock, too
    safe_o   = 1'b0;
    unsafe_o = 1'b1;
  end
  logic bad_now;
  assign bad_now = found_q || fault_set_o != NONE || (late_o && !publish_q) || silent_i != 2'b00 || !safe_allowed_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) safe_o <= 1'b0;
    else if (bad_now) safe_o <= 1'b0;
    else if (publish_q) safe_o <= good && !others_bad_q && event_q == NONE;
  end
  // The same, said the other way round and stored again.
  always_ff @(posedge clk_i) begin
    if (!rst_ni || bad_now) unsafe_o <= 1'b1;
    else if (publish_q) unsafe_o <= total_q != NONE || alarm_q || !table_ok_i || others_bad_q || event_q != NONE;
  end
endmodule
