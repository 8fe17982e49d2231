// SPDX-License-Identifier: Apache-2.0
// horopter_frame_control's safe_o, unbounded: it never rises but with the publication of a frame without fault or alarm and
// with a valid table, after another such frame and no fault in between, never survives a fault by more than 3 clocks, is low
// after reset, and always differs from unsafe_o. And it never rises but with a restart since the last time that something
// was wrong, allowed by the settings and after as many good frames as they want, or where none is needed.
module formal_safe (
    input logic        clk_i,
    input logic        rst_ni,
    input logic        safe_allowed,
    input logic        open,
    input logic        open_slot,
    input logic [ 1:0] busy,
    input logic        arrived,
    input logic [ 1:0] health_end,
    input logic [ 1:0] health_valid,
    input horopter_csr_pkg::health_t left_health,
    input horopter_csr_pkg::health_t right_health,
    input logic        same_image,
    input horopter_csr_pkg::stream_faults_t left_stream,
    input horopter_csr_pkg::stream_faults_t right_stream,
    input logic        judged,
    input logic        judged_slot,
    input logic        one_camera,
    input logic [ 1:0] blind,
    input logic [ 1:0] still,
    input logic        skew,
    input logic        bad_upload,
    input logic        refused_upload,
    input logic [ 1:0] silence,
    input logic [ 1:0] silent,
    input logic        begin_frame,
    input logic        active,
    input logic [ 1:0] whole,
    input logic        read_slot,
    input logic        table_ok,
    input logic [ 1:0] parity_error,
    input logic        internal,
    input logic        settings,
    input horopter_csr_pkg::interlock_t interlock,
    input horopter_csr_pkg::alarm_frames_t alarm_frames,
    input logic        restart,
    input logic        restart_written,
    input logic        miss,
    input logic        state_first,
    input logic        state_end,
    input logic        runs_end,
    input logic        counts_valid,
    input logic        alarm,
    input logic        objects_ended,
    input logic        objects_overflow,
    input logic        object_alarm,
    input logic        teaching,
    input logic        contactors_bad,
    input logic        contactors_ready,
    input logic        too_undecidable,
    input logic        too_unsupervised,
    input logic        verdict_valid,
    input horopter_csr_pkg::verdict_t verdict
);
  logic publish, frame_seen, frame_alarm, frame_safe, frame_done, late, heartbeat, safe, unsafe;
  horopter_csr_pkg::faults_t frame_faults, fault_set;
  logic [31:0] sequence_number;
  horopter_frame_control dut (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .safe_allowed_i(safe_allowed),
      .timeout_i(32'd20),
      .open_i(open),
      .open_slot_i(open_slot),
      .busy_i(busy),
      .arrived_i(arrived),
      .health_end_i(health_end),
      .health_valid_i(health_valid),
      .left_health_i(left_health),
      .right_health_i(right_health),
      .same_image_i(same_image),
      .left_stream_i(left_stream),
      .right_stream_i(right_stream),
      .judged_i(judged),
      .judged_slot_i(judged_slot),
      .one_camera_i(one_camera),
      .blind_i(blind),
      .still_i(still),
      .skew_i(skew),
      .bad_upload_i(bad_upload),
      .refused_upload_i(refused_upload),
      .silence_i(silence),
      .silent_i(silent),
      .begin_i(begin_frame),
      .active_i(active),
      .whole_i(whole),
      .read_slot_i(read_slot),
      .table_ok_i(table_ok),
      .table_slot_i(4'd0),
      .table_crc_i(32'd0),
      .parity_error_i(parity_error),
      .internal_i(internal),
      .settings_i(settings),
      .interlock_i(interlock),
      .alarm_frames_i(alarm_frames),
      .restart_i(restart),
      .restart_written_i(restart_written),
      .miss_i(miss),
      .state_first_i(state_first),
      .state_end_i(state_end),
      .runs_end_i(runs_end),
      .counts_valid_i(counts_valid),
      .skin_i(24'd0),
      .undecidable_i(24'd0),
      .unsupervised_i(24'd0),
      .alarm_i(alarm),
      .teaching_i(teaching),
      .contactors_bad_i(contactors_bad),
      .contactors_ready_i(contactors_ready),
      .objects_ended_i(objects_ended),
      .objects_overflow_i(objects_overflow),
      .object_alarm_i(object_alarm),
      .too_undecidable_i(too_undecidable),
      .too_unsupervised_i(too_unsupervised),
      .verdict_valid_i(verdict_valid),
      .verdict_i(verdict),
      .publish_o(publish),
      .forget_o(),
      .frame_sequence_o(sequence_number),
      .frame_seen_o(frame_seen),
      .frame_alarm_o(frame_alarm),
      .frame_safe_o(frame_safe),
      .frame_slot_o(),
      .frame_faults_o(frame_faults),
      .frame_table_crc_o(),
      .frame_skin_o(),
      .frame_undecidable_o(),
      .frame_unsupervised_o(),
      .frame_misses_o(),
      .frame_cycles_o(),
      .frame_latency_o(),
      .frame_tail_o(),
      .frame_done_o(frame_done),
      .fault_set_o(fault_set),
      .late_o(late),
      .heartbeat_o(heartbeat),
      .waiting_o(waiting),
      .safe_o(safe),
      .unsafe_o(unsafe)
  );

  logic waiting;
  logic past_valid = 1'b0, past_safe = 1'b0, past_reset = 1'b1, past_ready = 1'b0;
  logic [3:0] fault_age = 4'd0;  // bit i: a fault came i + 1 clocks ago
  logic good_before = 1'b0;  // the frame published before was good, and no fault has come since
  logic fault_now;
  logic [4:0] begun = 5'd0;  // the frame that is output began so many clocks ago
  // Identical images are a fault with the second image check of a record; a check follows its image's last pixel.
  logic [1:0] left_checked = 2'b00, right_checked = 2'b00, ended = 2'b00;
  logic left_slot, right_slot, opened = 1'b0, opened_slot, identical;
  logic [1:0] checks = 2'b00;  // that have just come
  logic [1:0] empty = 2'b11;  // nothing is in the camera's image; that is another fault than blind
  logic [1:0] past_silent = 2'b00, past_late = 2'b00;
  assign identical = same_image && ((checks[0] && right_checked[left_slot]) || (checks[1] && left_checked[right_slot]));
  always @(posedge clk_i) begin
    checks <= rst_ni ? health_valid : 2'b00;
    opened <= rst_ni && open;
    opened_slot <= open_slot;
    ended <= ended | health_end;
    if (rst_ni && health_valid[0]) empty[0] <= left_health.image.black || left_health.image.white || left_health.image.constant;
    if (rst_ni && health_valid[1]) empty[1] <= right_health.image.black || right_health.image.white || right_health.image.constant;
    past_silent <= rst_ni ? silent : 2'b00;
    past_late <= {past_late[0], late};
    if (health_end[0]) left_slot <= open_slot;
    if (health_end[1]) right_slot <= open_slot;
    if (!rst_ni) begin
      left_checked <= 2'b00;
      right_checked <= 2'b00;
    end else begin
      if (opened) left_checked[opened_slot] <= 1'b0;
      if (opened) right_checked[opened_slot] <= 1'b0;
      if (health_valid[0]) left_checked[left_slot] <= 1'b1;
      if (health_valid[1]) right_checked[right_slot] <= 1'b1;
    end
  end
  // `overlooked` is a fault of a published frame, where there is no alarm.
  horopter_csr_pkg::verdict_t other_verdict;
  always_comb begin
    other_verdict = verdict;
    other_verdict.overlooked = 1'b0;
  end
  // Faults of a health result without valid, or of an alarm without counts, mean nothing.
  assign fault_now = {left_stream, right_stream, skew, bad_upload, refused_upload, silence, parity_error, internal, settings, contactors_bad, miss} != '0 || identical
      || (health_valid[0] && left_health != '0) || (health_valid[1] && right_health != '0)
      || (object_alarm && alarm_frames.needed <= 3'd1) || (objects_ended && objects_overflow) || (begun[4] && teaching)
      || (counts_valid && (too_undecidable || too_unsupervised)) || (verdict_valid && other_verdict != '0)
      || (judged && (still != 2'b00 || (one_camera && !same_image) || (blind & ~empty) != 2'b00)) || (begun[4] && !table_ok);
  always @(posedge clk_i) begin
    past_valid <= 1'b1;
    past_reset <= !rst_ni;
    past_safe <= safe;
    past_ready <= contactors_ready;
    begun <= rst_ni ? {begun[3:0], begin_frame} : 5'd0;
    fault_age <= rst_ni ? {fault_age[2:0], fault_now} : 4'd0;
    if (!rst_ni || fault_age[2]) good_before <= 1'b0;
    else if (frame_done) good_before <= frame_safe && frame_faults == '0 && !frame_alarm;
  end

  // The interlock's settings are locked while the machine runs. Of restarts: one was asked for since the last time that
  // something was wrong, after so many good frames, and not by a press during which something was wrong.
  horopter_csr_pkg::interlock_t past_interlock;
  horopter_csr_pkg::alarm_frames_t past_alarm_frames;
  logic [2:0] past_restart = 3'b000;  // restart_i comes from another clock, through two registers
  logic asked = 1'b0, asks;
  logic [3:0] good_frames = 4'd0;
  logic wrong, spoiled = 1'b0;
  logic [2:0] pressed_for = 3'd0;  // a fault is known 3 clocks after it came
  assign wrong = !rst_ni || fault_age[2] || (frame_done && !(frame_safe && frame_faults == '0 && !frame_alarm));
  assign asks = (interlock.by_register && restart_written)
      || (interlock.by_pin && past_restart[2] && !past_restart[1] && !spoiled);
  always @(posedge clk_i) begin
    past_interlock <= interlock;
    past_alarm_frames <= alarm_frames;
    past_restart <= {past_restart[1:0], restart};
    if (!past_restart[1]) pressed_for <= 3'd0;
    else if (pressed_for != 3'd7) pressed_for <= pressed_for + 3'd1;
    spoiled <= (past_restart[1] || past_restart[2]) && (spoiled || (wrong && pressed_for > 3'd3));
    if (wrong) begin
      asked <= 1'b0;
      good_frames <= 4'd0;
    end else begin
      if (asks && !safe) asked <= 1'b1;
      if (frame_done && good_frames != 4'hF) good_frames <= good_frames + 4'd1;
    end
  end

  always @(*) begin
    if (!past_valid) assume (!rst_ni);
    if (past_valid && !past_reset) assume (interlock == past_interlock && alarm_frames == past_alarm_frames);
    assume ((health_valid & ~ended) == 2'b00);
    assert (safe != unsafe);
    if (past_valid) begin
      if (past_reset) assert (!safe);
      if (past_silent != 2'b00 || past_late == 2'b11) assert (!safe);
      // Rises only with a good frame.
      if (safe && !past_safe) assert (frame_done && frame_safe && frame_faults == '0 && !frame_alarm && good_before);
      if (safe && !past_safe && !interlock.by_itself) begin
        assert (asked);
        assert (good_frames >= interlock.frames && good_frames != 4'd0);  // this one comes on top
      end
      if (safe && !past_safe) assert (past_ready);
      // Waits for a restart only after so many good frames: this one comes on top of those published since something was wrong.
      if (waiting) assert (good_frames >= interlock.frames && good_frames != 4'd0);
      // A fault is felt after its register, its collection and the decision: 3 clocks.
      if (fault_age[2] || fault_age[3]) assert (!safe || frame_done);
      if (fault_age[2]) assert (!safe);
      // A published frame with a fault or an alarm.
      if (frame_done && (frame_faults != '0 || frame_alarm)) assert (!safe && !frame_safe);
      // In how many frames it must be seen: formal_alarm_filter. Unless told otherwise, in one.
      if (frame_done && frame_seen && (frame_faults != '0 || alarm_frames.needed <= 3'd1)) assert (frame_alarm);
      cover (safe && sequence_number == 32'd2);
      cover (past_safe && !safe && late);
    end
  end
endmodule
