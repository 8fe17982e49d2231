// SPDX-License-Identifier: Apache-2.0
// State of the machine and its faults: whether the streaming core runs, what is wrong now and in which frame
// (horopter_frame_control), what raises irq_o.
//
// The streaming core runs while enabled with a possible geometry; otherwise running_o = 0 is its reset. Uploads work then,
// too, and so do their faults: rst_ni is the reset of the whole machine.
module horopter_status #(
    parameter int unsigned MAX_LOOKAHEAD = horopter_profile_pkg::STORE_ROWS / 2
) (
    input  logic                             clk_i,
    input  logic                             rst_ni,
    // registers
    input  logic                             enable_i,
    input  logic                             test_input_i,
    input  logic [11:0]                      width_i,
    input  logic [11:0]                      height_i,
    input  logic [11:0]                      lookahead_i,
    input  logic [31:0]                      timeout_i,
    input  logic [1:0]                       changed_i,  // without a write: a register, what the frame sampled
    input  horopter_csr_pkg::irq_enable_t    irq_enable_i,
    input  horopter_csr_pkg::irq_status_t    irq_status_i,
    output horopter_csr_pkg::irq_status_t    irq_set_o,
    output logic                             irq_o,
    output logic                             running_o,  // the streaming core is out of reset
    output horopter_csr_pkg::status_t        status_o,
    output horopter_csr_pkg::faults_t        faults_set_o,  // every fault, one clock
    // frames coming in
    input  logic                             open_i,  // open_slot_i has just been opened
    input  logic                             open_slot_i,
    input  horopter_csr_pkg::interlock_t     interlock_i,
    input  horopter_csr_pkg::alarm_frames_t  alarm_frames_i,
    input  logic                             restart_i,  // of any clock
    input  logic                             feedback_i,  // the same
    input  logic [31:0]                      feedback_clocks_i,
    input  logic                             restart_valid_i,  // RESTART is written
    input  logic [31:0]                      restart_key_i,
    input  logic [1:0]                       busy_i,
    input  logic                             arrived_i,
    input  logic [1:0]                       health_end_i,  // last pixel of a camera's frame goes to its image check
    input  logic [1:0]                       health_valid_i,
    input  horopter_csr_pkg::health_t  left_health_i,
    input  horopter_csr_pkg::health_t  right_health_i,
    input  logic [31:0]                      left_signature_i,
    input  logic [31:0]                      right_signature_i,
    input  logic                             judged_i,  // the check of both images
    input  logic                             judged_slot_i,
    input  logic                             one_camera_i,
    input  logic [1:0]                       blind_i,
    input  logic [1:0]                       still_i,
    input  horopter_csr_pkg::stream_faults_t left_stream_i,
    input  horopter_csr_pkg::stream_faults_t right_stream_i,
    input  logic                             skew_i,
    input  logic [1:0]                       silence_i,
    input  logic [1:0]                       silent_i,
    input  logic                             bad_upload_i,
    input  logic                             refused_upload_i,
    // frame going out
    input  logic                             begin_i,
    input  logic                             active_i,
    input  logic [1:0]                       whole_i,  // as many rows of it came as an image has
    input  logic                             read_slot_i,
    input  logic                             table_ok_i,
    input  logic [3:0]                       table_slot_i,
    input  logic [31:0]                      table_crc_i,
    input  logic                             table_error_i,  // parity of the directory
    input  logic                             beat_parity_error_i,  // of the map
    input  logic                             areas_error_i,  // parity of the map's areas
    input  logic                             stage_parity_error_i,  // of a stage's memory
    input  logic                             quad_valid_i,
    input  logic                             quad_miss_i,
    input  logic                             quad_parity_error_i,  // of the right image
    input  logic                             left_mask_i,
    input  logic                             left_parity_error_i,
    input  logic [1:0]                       output_overflow_i,  // states, runs
    input  logic                             place_error_i,  // of its rows in the rings
    input  logic                             rows_error_i,  // it has not left with as many rows
    input  logic                             state_first_i,  // its first state leaves
    input  logic                             state_end_i,  // its last state leaves
    input  logic                             runs_end_i,  // its last run leaves
    input  logic                             counts_valid_i,
    input  logic [23:0]                      skin_i,
    input  logic [23:0]                      undecidable_i,
    input  logic [23:0]                      unsupervised_i,
    input  logic                             alarm_i,
    input  logic                             objects_ended_i,
    input  logic                             objects_overflow_i,
    input  logic                             object_alarm_i,
    input  logic                             taught_i,
    input  logic                             teaching_i,
    output logic                             forget_o,  // what it has taught
    input  logic                             too_undecidable_i,
    input  logic                             too_unsupervised_i,
    input  logic                             verdict_valid_i,  // what both cameras see, together
    input  horopter_csr_pkg::verdict_t       verdict_i,
    output logic                             publish_o,
    // the last published frame
    output logic [31:0]                      frame_sequence_o,
    output horopter_csr_pkg::frame_status_t  frame_status_o,
    output horopter_csr_pkg::faults_t        frame_faults_o,
    output logic [31:0]                      frame_table_crc_o,
    output logic [23:0]                      frame_skin_o,
    output logic [23:0]                      frame_undecidable_o,
    output logic [23:0]                      frame_unsupervised_o,
    output logic [23:0]                      frame_misses_o,
    output logic [31:0]                      frame_cycles_o,
    output logic [31:0]                      frame_latency_o,
    output logic [31:0]                      frame_tail_o,
    output logic                             frame_done_o,
    // now
    output logic                             heartbeat_o,
    output logic                             safe_o,
    output logic                             unsafe_o
);
  localparam int unsigned WIDTH = horopter_profile_pkg::WIDTH;
  localparam int unsigned HEIGHT = horopter_profile_pkg::HEIGHT;
  localparam int unsigned SUBSAMPLE = horopter_profile_pkg::SUBSAMPLE;
  localparam int unsigned MIN_WIDTH = horopter_table_pkg::SMALLEST_RESULT_WIDTH * SUBSAMPLE;
  localparam int unsigned MIN_HEIGHT = horopter_table_pkg::SMALLEST_HEIGHT;

  if (WIDTH % SUBSAMPLE != 0 || WIDTH < MIN_WIDTH || WIDTH > 2046 || HEIGHT < MIN_HEIGHT || HEIGHT > 2046) begin : g_illegal_size
    $fatal(1, "horopter_status: WIDTH must be a multiple of SUBSAMPLE, WIDTH and HEIGHT in the range of the registers");
  end

  logic bad_width_q, bad_height_q, bad_lookahead_q, bad_geometry_q;
  logic running_q = 1'b0;  // in reset before the first clock, too
  always_ff @(posedge clk_i) begin
    // Registers do not change in the clocks before enable_i rises.
    bad_width_q <= 32'(width_i) > WIDTH || 32'(width_i) < MIN_WIDTH || 32'(width_i) % SUBSAMPLE != 0;
    bad_height_q <= 32'(height_i) > HEIGHT || 32'(height_i) < MIN_HEIGHT;
    bad_lookahead_q <= 32'(lookahead_i) > MAX_LOOKAHEAD;
    bad_geometry_q <= bad_width_q || bad_height_q || bad_lookahead_q;
    running_q <= rst_ni && enable_i && !bad_geometry_q;
  end
  assign running_o = running_q;

  logic late, waiting, waiting_q, restart_written_q;
  logic contactors_bad, contactors_ready;
  assign status_o.running = running_q;
  assign status_o.bad_geometry = bad_geometry_q;
  assign status_o.busy = busy_i != 2'b00;
  assign status_o.safe = safe_o;
  assign status_o.unsafe = unsafe_o;
  assign status_o.left_silent = silent_i[0];
  assign status_o.right_silent = silent_i[1];
  assign status_o.late = late;
  assign status_o.waiting = waiting_q;
  assign status_o.by_itself = interlock_i.by_itself;
  assign status_o.taught = taught_i;

  // The core's reset comes a clock after rst_ni: what it says between them is of the time before.
  logic reset_q;
  logic same_image_q;
  logic [2:0] fault_q;
  horopter_csr_pkg::faults_t fault_set;
  assign irq_set_o.frame = frame_done_o && !reset_q;
  assign irq_set_o.fault = fault_q != '0;
  always_ff @(posedge clk_i) begin
    reset_q <= !rst_ni;
    same_image_q <= left_signature_i == right_signature_i;
    waiting_q <= rst_ni && waiting && contactors_ready;
    restart_written_q <= rst_ni && restart_valid_i && restart_key_i == horopter_csr_pkg::RESTART_KEY;
    fault_q <= rst_ni ? {faults_set_o.machine != '0, faults_set_o.right != '0, faults_set_o.left != '0} : '0;
    faults_set_o <= rst_ni && !reset_q ? fault_set : '0;
    if (rst_ni && bad_upload_i) faults_set_o.machine.map_crc <= 1'b1;
    if (rst_ni && refused_upload_i) faults_set_o.machine.map_busy <= 1'b1;
    irq_o <= rst_ni && ((irq_status_i.frame && irq_enable_i.frame) || (irq_status_i.fault && irq_enable_i.fault));
  end

  logic miss, internal;
  horopter_feedback u_feedback (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .clocks_i(feedback_clocks_i),
      .safe_i(safe_o),
      .feedback_i(feedback_i),
      .ready_o(contactors_ready),
      .bad_o(contactors_bad)
  );
  logic [1:0] parity_error;
  assign miss = quad_valid_i && quad_miss_i;
  assign parity_error = {quad_valid_i && quad_parity_error_i && left_mask_i, left_parity_error_i};
  assign internal = output_overflow_i != 2'b00 || beat_parity_error_i || table_error_i || rows_error_i
      || place_error_i || stage_parity_error_i || areas_error_i;

  horopter_frame_control u_frame_control (
      .clk_i(clk_i),
      .rst_ni(running_q),
      .safe_allowed_i(rst_ni && !test_input_i),  // a reset ends it at once, not a clock later
      .timeout_i(timeout_i),
      .open_i(open_i),
      .open_slot_i(open_slot_i),
      .busy_i(busy_i),
      .arrived_i(arrived_i),
      .health_end_i(health_end_i),
      .health_valid_i(health_valid_i),
      .left_health_i(left_health_i),
      .right_health_i(right_health_i),
      .same_image_i(same_image_q),
      .judged_i(judged_i),
      .judged_slot_i(judged_slot_i),
      .one_camera_i(one_camera_i),
      .blind_i(blind_i),
      .still_i(still_i),
      .left_stream_i(left_stream_i),
      .right_stream_i(right_stream_i),
      .skew_i(skew_i),
      .bad_upload_i(bad_upload_i),
      .refused_upload_i(refused_upload_i),
      .silence_i(silence_i),
      .silent_i(silent_i),
      .begin_i(begin_i),
      .active_i(active_i),
      .whole_i(whole_i),
      .read_slot_i(read_slot_i),
      .table_ok_i(table_ok_i),
      .table_slot_i(table_slot_i),
      .table_crc_i(table_crc_i),
      .parity_error_i(parity_error),
      .internal_i(internal),
      .settings_i(changed_i != 2'b00),
      .interlock_i(interlock_i),
      .alarm_frames_i(alarm_frames_i),
      .restart_i(restart_i),
      .contactors_bad_i(contactors_bad),
      .contactors_ready_i(contactors_ready),
      .restart_written_i(restart_written_q),
      .miss_i(miss),
      .state_first_i(state_first_i),
      .state_end_i(state_end_i),
      .runs_end_i(runs_end_i),
      .counts_valid_i(counts_valid_i),
      .skin_i(skin_i),
      .undecidable_i(undecidable_i),
      .unsupervised_i(unsupervised_i),
      .alarm_i(alarm_i),
      .objects_ended_i(objects_ended_i),
      .objects_overflow_i(objects_overflow_i),
      .object_alarm_i(object_alarm_i),
      .teaching_i(teaching_i),
      .forget_o(forget_o),
      .too_undecidable_i(too_undecidable_i),
      .too_unsupervised_i(too_unsupervised_i),
      .verdict_valid_i(verdict_valid_i),
      .verdict_i(verdict_i),
      .publish_o(publish_o),
      .frame_sequence_o(frame_sequence_o),
      .frame_seen_o(frame_status_o.seen),
      .frame_alarm_o(frame_status_o.alarm),
      .frame_safe_o(frame_status_o.safe),
      .frame_slot_o(frame_status_o.slot),
      .frame_faults_o(frame_faults_o),
      .frame_table_crc_o(frame_table_crc_o),
      .frame_skin_o(frame_skin_o),
      .frame_undecidable_o(frame_undecidable_o),
      .frame_unsupervised_o(frame_unsupervised_o),
      .frame_misses_o(frame_misses_o),
      .frame_cycles_o(frame_cycles_o),
      .frame_latency_o(frame_latency_o),
      .frame_tail_o(frame_tail_o),
      .frame_done_o(frame_done_o),
      .fault_set_o(fault_set),
      .late_o(late),
      .heartbeat_o(heartbeat_o),
      .waiting_o(waiting),
      .safe_o(safe_o),
      .unsafe_o(unsafe_o)
  );
endmodule
