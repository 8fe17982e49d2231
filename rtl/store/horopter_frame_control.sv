// SPDX-License-Identifier: Apache-2.0
// Frame control: collects the faults of each frame, publishes a frame when its last state has left, decides what is safe.
//
// Faults of the streams and skew belong to the frame record open_slot_i, those of an image check to the record in which
// the camera's frame ended (identical images: that of the second camera), those of the check of both images to its
// record judged_slot_i, parity, store_miss, internal and settings to the frame being output, those of an upload to the next
// frame published. A silence, silence_i, makes not safe at once, but belongs to no frame.
//
// A frame is published, publish_o for one clock, when its last state and its last run have left and its counts, its
// objects and its verdict (stage `agreement`) are there. In the same clock all frame_* outputs change, frame_done_o = 1, heartbeat_o toggles.
// safe_o rises only then, and only if this frame and the one before had no fault and no alarm, nothing was wrong in
// between, and nothing speaks against the next one: what hides the alarm of a single frame does not make safe. And only
// if a restart was given since something was wrong, or none is needed (horopter_interlock). It falls
// with any fault, with an object that is an alarm (and with horopter_alarm_filter is one of enough), with the watchdog, and while safe_allowed_i is 0. unsafe_o is decided and stored on its own. frame_safe_o
// is of the one frame. Reset: not safe.
module horopter_frame_control (
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
    input  horopter_csr_pkg::health_t left_health_i,
    input  horopter_csr_pkg::health_t right_health_i,
    input  logic              same_image_i,  // the images last checked are the same; a clock after health_valid_i
    input  horopter_csr_pkg::stream_faults_t left_stream_i,
    input  horopter_csr_pkg::stream_faults_t right_stream_i,
    input  logic              judged_i,  // the check of both images
    input  logic              judged_slot_i,
    input  logic              one_camera_i,
    input  logic [       1:0] blind_i,
    input  logic [       1:0] still_i,
    input  logic              skew_i,
    input  logic              bad_upload_i,
    input  logic              refused_upload_i,
    input  logic [       1:0] silence_i,
    input  logic [       1:0] silent_i,
    // frame going out
    input  logic              begin_i,
    input  logic              active_i,
    input  logic [       1:0] whole_i,  // as many rows of it came as an image has
    input  logic              read_slot_i,
    input  logic              table_ok_i,
    input  logic [       3:0] table_slot_i,
    input  logic [      31:0] table_crc_i,
    input  logic [       1:0] parity_error_i,
    input  logic              internal_i,
    input  logic              settings_i,
    input  horopter_csr_pkg::interlock_t interlock_i,
    input  horopter_csr_pkg::alarm_frames_t alarm_frames_i,
    input  logic              restart_i,  // of any clock
    input  logic              restart_written_i,
    input  logic              miss_i,  // a pixel that missed its source row
    input  logic              state_first_i,  // its first state leaves
    input  logic              state_end_i,  // its last state leaves
    input  logic              runs_end_i,  // its last run leaves
    input  logic              counts_valid_i,
    input  logic [      23:0] skin_i,
    input  logic [      23:0] undecidable_i,
    input  logic [      23:0] unsupervised_i,
    input  logic              alarm_i,
    input  logic              objects_ended_i,  // the frame's objects are known
    input  logic              objects_overflow_i,  // with it: more than can be told apart
    input  logic              object_alarm_i,  // of the frame so far, or of the last one
    input  logic              contactors_bad_i,  // they do not follow safe_o
    input  logic              contactors_ready_i,  // they have dropped
    input  logic              teaching_i,  // the frame teaches what cannot be decided
    input  logic              too_undecidable_i,
    input  logic              too_unsupervised_i,
    input  logic              verdict_valid_i,  // what both cameras see, together
    input  horopter_csr_pkg::verdict_t verdict_i,
    output logic              publish_o,
    output logic              forget_o,  // the last published frame taught, but perhaps not what is true
    // the last published frame
    output logic [      31:0] frame_sequence_o,
    output logic              frame_seen_o,  // what would be an alarm without alarm_frames_i
    output logic              frame_alarm_o,
    output logic              frame_safe_o,
    output logic [       3:0] frame_slot_o,
    output horopter_csr_pkg::faults_t frame_faults_o,
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
    output horopter_csr_pkg::faults_t fault_set_o,  // every fault, one clock when it is found
    output logic              late_o,
    output logic              heartbeat_o,
    output logic              waiting_o,  // for a restart, that would be accepted
    output logic              safe_o,
    output logic              unsafe_o
);
  // --- faults, registered, so that their sources may be slow ---
  // Of each vector only what its source has; the rest stays '0.
  horopter_csr_pkg::faults_t arriving_q, left_health_q, right_health_q, judged_q, outgoing_q, event_in_q, transient_q;
  logic released, held, stuck;  // the interlock
  logic open_q, open_slot_q, left_slot_q, right_slot_q, judged_slot_q, late_rises;
  logic [1:0] empty_q;  // the image check has found nothing in the camera's image
  logic [1:0] health_valid_q;
  // In yosys a write at a variable place is a subtraction and a shift otherwise.
  (* nowrshmsk *) logic [1:0] left_checked_q, right_checked_q;  // by record
  logic [4:0] begin_q;  // the table's entry is there some clocks after the begin
  always_ff @(posedge clk_i) begin
    arriving_q <= '0;
    left_health_q <= '0;
    right_health_q <= '0;
    judged_q <= '0;
    outgoing_q <= '0;
    event_in_q <= '0;
    transient_q <= '0;
    health_valid_q <= rst_ni ? health_valid_i : 2'b00;
    if (!rst_ni) begin
      open_q <= 1'b0;
      begin_q <= 5'd0;
    end else begin
      arriving_q.left.stream <= left_stream_i;
      arriving_q.right.stream <= right_stream_i;
      arriving_q.machine.skew <= skew_i;
      if (health_valid_i[0]) left_health_q.left.image <= left_health_i.image;
      if (health_valid_i[0]) left_health_q.left.torn <= left_health_i.torn;
      if (health_valid_i[1]) right_health_q.right.image <= right_health_i.image;
      if (health_valid_i[1]) right_health_q.right.torn <= right_health_i.torn;
      // Told with the second of the two.
      left_health_q.machine.identical_images <= health_valid_q[0] && same_image_i && right_checked_q[left_slot_q];
      right_health_q.machine.identical_images <= health_valid_q[1] && same_image_i && left_checked_q[right_slot_q];
      judged_q.machine.one_camera <= judged_i && one_camera_i && !same_image_i;  // that says it already
      judged_q.left.blind <= judged_i && blind_i[0] && !empty_q[0];
      judged_q.right.blind <= judged_i && blind_i[1] && !empty_q[1];
      judged_q.left.image.frozen <= judged_i && still_i[0];
      judged_q.right.image.frozen <= judged_i && still_i[1];
      if (health_valid_i[0]) empty_q[0] <= left_health_i.image.black || left_health_i.image.white || left_health_i.image.constant;
      if (health_valid_i[1]) empty_q[1] <= right_health_i.image.black || right_health_i.image.white || right_health_i.image.constant;
      outgoing_q.left.parity <= parity_error_i[0];
      outgoing_q.right.parity <= parity_error_i[1];
      outgoing_q.machine.store_miss <= miss_i;
      outgoing_q.machine.internal <= internal_i;
      outgoing_q.machine.settings <= settings_i;
      outgoing_q.machine.contactors <= contactors_bad_i;
      outgoing_q.machine.restart <= stuck && begin_q[4];
      outgoing_q.machine.teaching <= teaching_i && begin_q[4];
      outgoing_q.machine.no_table <= begin_q[4] && !table_ok_i;
      outgoing_q.machine.too_undecidable <= (counts_valid_i && too_undecidable_i) || (verdict_valid_i && verdict_i.untextured);
      outgoing_q.machine.objects <= objects_ended_i && objects_overflow_i;
      outgoing_q.machine.disagree <= verdict_valid_i && verdict_i.disagree;
      outgoing_q.machine.unproven <= verdict_valid_i && verdict_i.unproven;
      outgoing_q.machine.moved <= verdict_valid_i && verdict_i.moved;
      outgoing_q.machine.out_of_step <= verdict_valid_i && verdict_i.out_of_step;
      outgoing_q.machine.hidden <= verdict_valid_i && verdict_i.hidden;
      outgoing_q.left.unsharp <= verdict_valid_i && verdict_i.unsharp[0];
      outgoing_q.right.unsharp <= verdict_valid_i && verdict_i.unsharp[1];
      outgoing_q.machine.too_unsupervised <= counts_valid_i && too_unsupervised_i;
      event_in_q.machine.map_crc <= bad_upload_i;
      event_in_q.machine.map_busy <= refused_upload_i;
      transient_q.left.stream.silent <= silence_i[0];
      transient_q.right.stream.silent <= silence_i[1];
      transient_q.machine.late <= late_rises;
      open_q <= open_i;
      begin_q <= {begin_q[3:0], begin_i};
    end
    open_slot_q <= open_slot_i;
    judged_slot_q <= judged_slot_i;
    if (health_end_i[0]) left_slot_q <= open_slot_i;
    if (health_end_i[1]) right_slot_q <= open_slot_i;
  end

  // --- where they belong: a frame record, or, if that is closed already, to the next frame published ---
  logic state_ended_q, runs_ended_q, counted_q, objects_ended_q, judged_by_both_q, overlooked_q;
  logic alarm_q, object_alarm_q;
  logic complete, publishing, publish_q;
  (* nowrshmsk *) logic [1:0] accepts;  // records that still take faults
  horopter_csr_pkg::faults_t set_record0, set_record1, set_event;
  assign complete = active_i && state_ended_q && runs_ended_q && counted_q && objects_ended_q && judged_by_both_q && !publishing && !publish_q && !publish_o;
  always_ff @(posedge clk_i) begin
    publishing <= rst_ni && complete;
    accepts <= busy_i;
    if (complete || publishing || publish_q || publish_o) accepts[read_slot_i] <= 1'b0;
  end
  always_comb begin
    set_record0 = '0;
    set_record1 = '0;
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
    if (!accepts[judged_slot_q]) set_event = set_event | judged_q;
    else if (judged_slot_q) set_record1 = set_record1 | judged_q;
    else set_record0 = set_record0 | judged_q;
    if (!accepts[read_slot_i]) set_event = set_event | outgoing_q;
    else if (read_slot_i) set_record1 = set_record1 | outgoing_q;
    else set_record0 = set_record0 | outgoing_q;
  end

  horopter_csr_pkg::faults_t faults0_q, faults1_q, event_q, total_q, read_faults, unchecked;
  logic [1:0] incomplete, unexplained_q;  // an image of the record; and no fault of its stream says why, as of the clock before
  logic [1:0] bad_q;  // by record
  logic found_q, others_bad_q;
  // set_q: fault_set_o has a fault; faulty_q: total_q has one. A bit tells of eight: one for all would take too long.
  localparam int unsigned FAULTS = $bits(fault_set_o);
  localparam int unsigned FAULT_GROUPS = (FAULTS + 7) / 8;
  function automatic [FAULT_GROUPS-1:0] groups_of(input horopter_csr_pkg::faults_t faults);
    for (int unsigned i = 0; i < FAULT_GROUPS; i++) groups_of[i] = 8'(FAULTS'(faults) >> (8 * i)) != 8'd0;
  endfunction
  logic [FAULT_GROUPS-1:0] set_q;
  logic [FAULT_GROUPS:0] faulty_q;  // the highest: what is unchecked
  logic told_q;  // publish_q told of a fault of the frame as a whole
  logic set_now;  // fault_set_o has a fault
  assign set_now = set_q != '0 || told_q;
  horopter_csr_pkg::faults_t fault_set;
  assign fault_set = set_record0 | set_record1 | set_event | transient_q;
  logic seen, counts, passes;  // a frame that shows an alarm may be one of too few
  assign seen = alarm_q || object_alarm_q;
  assign read_faults = (read_slot_i ? faults1_q : faults0_q) | event_q;
  // A frame without its image checks or without all its rows, and without a fault of a camera's stream that explains it,
  // was not checked: not safe.
  always_comb begin
    unchecked = '0;
    unchecked.machine.internal = !read_faults.machine.skew && unexplained_q != 2'b00;
    unchecked.machine.overlooked = overlooked_q && !(seen && counts);  // with an alarm it is none
  end
  assign incomplete = ~({right_checked_q[read_slot_i], left_checked_q[read_slot_i]} & whole_i);
  always_ff @(posedge clk_i) begin
    unexplained_q <= incomplete & {read_faults.right.stream == '0, read_faults.left.stream == '0};
    if (!rst_ni) begin
      faults0_q <= '0;
      faults1_q <= '0;
      event_q <= '0;
      left_checked_q <= 2'b00;
      right_checked_q <= 2'b00;
      fault_set_o <= '0;
      found_q <= 1'b0;
      bad_q <= 2'b00;
      others_bad_q <= 1'b0;
      total_q <= '0;
      faulty_q <= '0;
      set_q <= '0;
      told_q <= 1'b0;
    end else begin
      faults0_q <= (open_q && !open_slot_q ? '0 : faults0_q) | set_record0;
      faults1_q <= (open_q && open_slot_q ? '0 : faults1_q) | set_record1;
      event_q <= (publishing ? '0 : event_q) | set_event;
      if (open_q) begin
        left_checked_q[open_slot_q] <= 1'b0;
        right_checked_q[open_slot_q] <= 1'b0;
      end
      if (health_valid_i[0]) left_checked_q[left_slot_q] <= 1'b1;
      if (health_valid_i[1]) right_checked_q[right_slot_q] <= 1'b1;
      if (publishing) total_q <= read_faults | unchecked;
      if (publishing) faulty_q <= {unchecked != '0, groups_of(read_faults)};
      fault_set_o <= fault_set;
      set_q <= groups_of(fault_set);
      told_q <= publish_q && (total_q.machine.internal || total_q.machine.overlooked);
      if (publish_q && total_q.machine.internal) fault_set_o.machine.internal <= 1'b1;
      if (publish_q && total_q.machine.overlooked) fault_set_o.machine.overlooked <= 1'b1;
      found_q <= set_now;
      // Until this has followed a fault, set_now and found_q tell of it.
      bad_q <= {faults1_q != '0, faults0_q != '0};
      others_bad_q <= bad_q[!read_slot_i] && busy_i[!read_slot_i];
    end
  end

  // --- publishing: publishing closes the record, publish_q takes the picture, publish_o tells ---
  logic [31:0] time_q, first_time_q;  // counts down: so the choice of a record merges into the subtraction (scripts/ecp5.py)
  logic [31:0] open_time0_q, open_time1_q, arrived_time0_q, arrived_time1_q;  // by record; a memory for two would be larger
  logic [31:0] open_time, arrived_time;  // of the frame being output
  assign open_time = read_slot_i ? open_time1_q : open_time0_q;
  assign arrived_time = read_slot_i ? arrived_time1_q : arrived_time0_q;
  logic state_first_q, first_seen_q;
  logic [23:0] skin_q, undecidable_q, unsupervised_q, misses_q;
  logic [31:0] next_sequence_q;
  logic good;
  assign good = faulty_q == '0 && !(seen && counts) && table_ok_i;
  always_ff @(posedge clk_i) begin
    publish_q <= 1'b0;
    publish_o <= 1'b0;
    next_sequence_q <= frame_sequence_o + 32'd1;
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
      objects_ended_q <= 1'b0;
      judged_by_both_q <= 1'b0;
      overlooked_q <= 1'b1;
      first_seen_q <= 1'b0;
      alarm_q <= 1'b1;
      object_alarm_q <= 1'b1;
      misses_q <= 24'd0;
      frame_sequence_o <= 32'd0;
      frame_seen_o <= 1'b0;
      frame_alarm_o <= 1'b0;
      frame_safe_o <= 1'b0;
      frame_slot_o <= horopter_csr_pkg::NO_SLOT;
      frame_faults_o <= '0;
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
        objects_ended_q <= 1'b0;
        judged_by_both_q <= 1'b0;
        overlooked_q <= 1'b1;
        first_seen_q <= 1'b0;
        alarm_q <= 1'b1;
        object_alarm_q <= 1'b1;
        misses_q <= 24'd0;
      end else if (active_i) begin
        if (state_first_q) first_seen_q <= 1'b1;
        if (state_end_i) state_ended_q <= 1'b1;
        if (runs_end_i) runs_ended_q <= 1'b1;
        if (verdict_valid_i) judged_by_both_q <= 1'b1;
        if (verdict_valid_i) overlooked_q <= verdict_i.overlooked;
        if (counts_valid_i) begin
          counted_q <= 1'b1;
          alarm_q <= alarm_i;
        end
        if (objects_ended_i) begin
          objects_ended_q <= 1'b1;
          object_alarm_q <= object_alarm_i;
        end
        if (miss_i) misses_q <= misses_q + 24'd1;  // no more than pixels
      end

      publish_q <= publishing;
      if (publish_q) begin
        publish_o <= 1'b1;
        frame_done_o <= 1'b1;
        heartbeat_o <= !heartbeat_o;
        frame_sequence_o <= next_sequence_q;
        frame_seen_o <= seen;
        frame_alarm_o <= seen && !good;
        frame_safe_o <= good;
        frame_slot_o <= table_ok_i ? table_slot_i : horopter_csr_pkg::NO_SLOT;
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

  // With a fault of its own, or an alarm, what a frame has taught says nothing of an empty zone. What both cameras see of a
  // frame is known of the one before it, and in part of the one before that: neither may have had any, whether it taught
  // or not. Of `unproven` only the first frame's counts: before it nothing is known; later it says nothing of the images.
  // Worked out from what was published, in two clocks: these registers lie near the bus.
  horopter_csr_pkg::faults_t beside_teaching, that_stay;
  logic published_q, first_q;
  logic [FAULT_GROUPS-1:0] beside_q, stay_q;
  logic [1:0] spoiled_before_q;
  always_comb begin
    beside_teaching = frame_faults_o;
    beside_teaching.machine.teaching = 1'b0;
    that_stay = beside_teaching;
    that_stay.machine.unproven = beside_teaching.machine.unproven && first_q;
  end
  always_ff @(posedge clk_i) begin
    beside_q <= groups_of(beside_teaching);
    stay_q <= groups_of(that_stay);
    published_q <= rst_ni && publish_o;
    if (!rst_ni) begin
      forget_o <= 1'b0;
      first_q <= 1'b1;
      spoiled_before_q <= 2'b00;
    end else if (published_q) begin
      forget_o <= frame_faults_o.machine.teaching && (beside_q != '0 || frame_seen_o || spoiled_before_q != 2'b00);
      first_q <= 1'b0;
      spoiled_before_q <= {spoiled_before_q[0], stay_q != '0 || frame_seen_o};
    end
  end

  logic no_table_q;  // the frame's table does not change before it is published
  always_ff @(posedge clk_i) begin
    no_table_q <= !table_ok_i;
    if (!rst_ni || (publish_q && no_table_q)) frame_table_crc_o <= 32'd0;
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
  logic safe_q = 1'b0, unsafe_q = 1'b1;  // before the first clock, too
  // As a fault: an object is known before its frame has ended.
  logic [2:0] object_now_q;
  always_ff @(posedge clk_i) object_now_q <= rst_ni ? {object_now_q[1:0], object_alarm_i && counts} : 3'b000;
  logic bad_now;
  assign bad_now = found_q || object_now_q[2:1] != 2'b00 || set_now || (late_o && !publish_q) || silent_i != 2'b00 || !safe_allowed_i;
  logic good_before_q, bad_before_q;  // the frame published before, and all since
  // Of a fault between the picture and this clock set_now tells.
  logic good_frame, bad_frame;
  assign good_frame = good && !others_bad_q;
  assign bad_frame = total_q != '0 || ((alarm_q || object_alarm_q) && !passes) || !table_ok_i || others_bad_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || bad_now) begin
      safe_q <= 1'b0;
      good_before_q <= 1'b0;
    end else if (publish_q) begin
      safe_q <= good_before_q && good_frame && released && (safe_q || contactors_ready_i);
      good_before_q <= good_frame;
    end
  end
  // The same, said the other way round and stored again.
  always_ff @(posedge clk_i) begin
    if (!rst_ni || bad_now) begin
      unsafe_q <= 1'b1;
      bad_before_q <= 1'b1;
    end else if (publish_q) begin
      unsafe_q <= bad_before_q || bad_frame || held || (unsafe_q && !contactors_ready_i);
      bad_before_q <= bad_frame;
    end
  end
  horopter_interlock u_interlock (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .settings_i(interlock_i),
      .restart_i(restart_i),
      .restart_written_i(restart_written_i),
      .published_i(publish_q),
      .good_i(good_frame),
      .bad_now_i(bad_now),
      .released_o(released),
      .held_o(held),
      .waiting_o(waiting_o),
      .stuck_o(stuck)
  );
  horopter_alarm_filter u_alarm_filter (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .settings_i(alarm_frames_i),
      .gap_i(late_o || silent_i != 2'b00),
      .published_i(publish_o),
      .seen_i(frame_seen_o),
      .faulty_i(faulty_q != '0),  // as of frame_faults_o, from publishing on
      .decide_i(begin_q[4]),
      .raw_i(teaching_i),
      .counts_o(counts),
      .passes_o(passes)
  );
  assign safe_o = safe_q;
  assign unsafe_o = unsafe_q;
endmodule
