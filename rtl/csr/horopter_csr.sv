// SPDX-License-Identifier: Apache-2.0
// Made by scripts/generate-registers from rtl/csr/registers.yaml: change that, not this.
//
// The register block. Write: write_valid_i with address, data and strobes stays until write_ready_o, two clocks later but
// for stream registers. write_error_o is valid with it, and a refused write changes nothing. The register changes two clocks
// after write_ready_o; the next write must not come before. Read: read_data_o and read_error_o follow read_addr_i three
// clocks later, every clock. Partial writes follow the strobes; of a stream register they are an error. Reset: synchronous,
// all storage to its reset value.
// changed_o: a register that the bus writes has changed without a write, and has not been written since (horopter_guard).
// memory_word_i: of registers whose words lie in a memory, the word of read_addr_i two clocks later.
module horopter_csr #(
    parameter bit BLIND = 1'b1,
    parameter bit BOTH_RULES = 1'b1,
    parameter bit COMPETE = 1'b1,
    parameter logic [11:0] WIDTH_PX_RESET = 12'd0,
    parameter logic [11:0] HEIGHT_ROWS_RESET = 12'd0,
    parameter logic [11:0] LOOKAHEAD_ROWS_RESET = 12'd0,
    parameter logic [31:0] TIMEOUT_CLOCKS_RESET = 32'd0,
    parameter logic [15:0] SUM_LIMIT_VALUE_RESET = 16'd0,
    parameter logic [15:0] SELF_LIMIT_VALUE_RESET = 16'd0,
    parameter logic [23:0] ALARM_LIMIT_PIXELS_RESET = 24'd0,
    parameter logic [23:0] UNSUPERVISED_LIMIT_PIXELS_RESET = 24'd0,
    parameter logic [23:0] BLACK_LIMIT_PIXELS_RESET = 24'd0,
    parameter logic [23:0] WHITE_LIMIT_PIXELS_RESET = 24'd0,
    parameter logic [0:0] DECISION_COMPETE_RESET = 1'd0
) (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic        locked_i,  // 1: writes to locked registers are errors
    input  logic        write_valid_i,
    output logic        write_ready_o,
    input  logic [11:0] write_addr_i,
    input  logic [31:0] write_data_i,
    input  logic [ 3:0] write_strb_i,
    output logic        write_error_o,
    input  logic [11:0] read_addr_i,
    output logic [31:0] read_data_o,
    output logic        read_error_o,
    output logic        changed_o,
    input  logic [31:0] memory_word_i,
    input  logic [15:0] build_size_width_i,
    input  logic [15:0] build_size_height_i,
    input  logic [15:0] build_store_rows_i,
    input  logic [15:0] build_store_pool_kib_i,
    input  logic [ 7:0] build_window_dsad_i,
    input  logic [ 7:0] build_window_majority_i,
    input  logic [ 3:0] build_window_subsample_i,
    input  logic [ 3:0] build_window_weight_bits_i,
    input  logic [ 3:0] build_window_hypotheses_i,
    input  logic        build_window_thesis_i,
    input  logic        build_window_compete_i,
    input  logic        build_window_blind_i,
    input  logic [31:0] build_clock_khz_i,
    input  logic [ 7:0] build_compete_planes_i,
    input  logic [ 3:0] build_compete_sum_rows_i,
    input  logic [ 3:0] build_compete_sum_columns_i,
    input  logic [ 3:0] build_compete_ballot_reach_i,
    input  logic        build_compete_paths_i,
    output logic        control_enable_o,
    output logic        mode_live_o,
    output logic        mode_test_input_o,
    input  logic [10:0] status_i,
    output logic [11:0] width_px_o,
    output logic [11:0] height_rows_o,
    output logic [11:0] lookahead_rows_o,
    output logic [31:0] timeout_clocks_o,
    output logic [ 3:0] table_select_slot_o,
    output logic [ 1:0] irq_enable_o,
    input  logic [ 1:0] irq_status_set_i,
    output logic [ 1:0] irq_status_o,
    output logic [ 6:0] interlock_o,
    output logic        restart_valid_o,
    input  logic        restart_ready_i,
    output logic [31:0] restart_key_o,
    output logic [31:0] feedback_clocks_o,
    output logic [15:0] sum_limit_value_o,
    output logic [15:0] self_limit_value_o,
    output logic [15:0] texture_limit_sum_o,
    output logic [23:0] alarm_limit_pixels_o,
    output logic [ 5:0] alarm_frames_o,
    output logic [23:0] unsupervised_limit_pixels_o,
    output logic [ 7:0] black_level_grey_o,
    output logic [23:0] black_limit_pixels_o,
    output logic [ 7:0] white_level_grey_o,
    output logic [23:0] white_limit_pixels_o,
    output logic [ 7:0] constant_limit_grey_o,
    output logic [ 7:0] frozen_limit_frames_o,
    output logic        decision_compete_o,
    output logic [30:0] compete_o,
    output logic [ 3:0] map_slot_slot_o,
    output logic [15:0] map_base_word64_o,
    output logic        map_control_valid_o,
    input  logic        map_control_ready_i,
    output logic        map_control_start_o,
    output logic        map_data_valid_o,
    input  logic        map_data_ready_i,
    output logic [31:0] map_data_word_o,
    input  logic        map_status_busy_i,
    input  logic [ 2:0] map_status_error_i,
    input  logic [ 3:0] map_status_active_slot_i,
    input  logic [14:0] map_valid_slots_i,
    input  logic [31:0] map_crc_value_i,
    output logic [23:0] map_undecidable_limit_pixels_o,
    input  logic [27:0] faults_cameras_set_i,
    output logic [27:0] faults_cameras_o,
    input  logic [21:0] faults_machine_set_i,
    output logic [21:0] faults_machine_o,
    input  logic [15:0] map_extent_base_word64_i,
    input  logic [15:0] map_extent_end_word64_i,
    input  logic [31:0] frame_sequence_value_i,
    input  logic [ 6:0] frame_status_i,
    input  logic [27:0] frame_faults_cameras_i,
    input  logic [31:0] frame_table_crc_value_i,
    input  logic [23:0] frame_skin_pixels_i,
    input  logic [23:0] frame_undecidable_pixels_i,
    input  logic [23:0] frame_unsupervised_pixels_i,
    input  logic [23:0] frame_misses_pixels_i,
    input  logic [31:0] frame_cycles_clocks_i,
    input  logic [31:0] frame_latency_clocks_i,
    input  logic [31:0] frame_tail_clocks_i,
    input  logic [21:0] frame_faults_machine_i,
    output logic [22:0] agreement_o,
    output logic [31:0] agreement_limits_o,
    output logic [ 7:0] hidden_frames_o,
    output logic [30:0] registration_o,
    output logic [31:0] epipolar_o,
    output logic [31:0] epipolar_change_o,
    output logic [ 7:0] one_camera_segments_o,
    output logic [ 7:0] blind_step_grey_o,
    output logic [ 7:0] blind_share_of_256_o,
    output logic [ 7:0] still_limit_frames_o,
    input  logic [23:0] frame_hidden_pixels_i,
    input  logic [23:0] frame_unproven_pixels_pixels_i,
    output logic [ 5:0] region_select_region_o,
    output logic [23:0] object_limit_pixels_o,
    input  logic [23:0] frame_object_pixels_i,
    input  logic [23:0] frame_object_columns_i,
    input  logic [23:0] frame_object_rows_i,
    output logic [10:0] blocks_o,
    input  logic [23:0] frame_blind_pixels_i,
    input  logic [15:0] taught_frames_i,
    input  logic [31:0] frame_object_area_of_1024_i,
    output logic [31:0] object_area_limit_of_1024_o
);
  // The address is decoded always, in the first clock of a write into a group of eight words and the word, in the second into
  // whether it may be written. From the third on it is answered, taken_q, and counts, write_q; nothing
  // counts without an answer.
  logic seen_q, taken_q, write_q;
  logic [10:0] write_group_q;
  logic [7:0] write_word_q;
  logic free, lockable, whole, refused;  // written always, unless locked, as all four bytes; not
  always_ff @(posedge clk_i) begin
    seen_q <= rst_ni && write_valid_i && !write_ready_o;
    taken_q <= rst_ni && write_valid_i && seen_q && !write_ready_o;
    write_q <= rst_ni && write_valid_i && seen_q && !write_ready_o && !refused;
    write_word_q <= write_addr_i[1:0] == 2'd0 ? 8'd1 << write_addr_i[4:2] : 8'd0;
    write_group_q[0] <= write_addr_i[11:5] == 7'h02;
    write_group_q[1] <= write_addr_i[11:5] == 7'h03;
    write_group_q[2] <= write_addr_i[11:5] == 7'h04;
    write_group_q[3] <= write_addr_i[11:5] == 7'h05;
    write_group_q[4] <= write_addr_i[11:5] == 7'h06;
    write_group_q[5] <= write_addr_i[11:5] == 7'h07;
    write_group_q[6] <= write_addr_i[11:5] == 7'h09;
    write_group_q[7] <= write_addr_i[11:5] == 7'h0A;
    write_group_q[8] <= write_addr_i[11:5] == 7'h0C;
    write_group_q[9] <= write_addr_i[11:5] == 7'h0D;
    write_group_q[10] <= write_addr_i[11:5] == 7'h0E;
  end
  assign write_error_o = !write_q;  // one register for both: no upset of it stores what was refused, or the reverse
  assign refused = !(free || (lockable && !locked_i) || (whole && write_strb_i == 4'hF));
  assign free = (write_group_q[0] && (write_word_q & 8'hC1) != 8'd0)
      || (write_group_q[1] && (write_word_q & 8'h03) != 8'd0)
      || (write_group_q[2] && (write_word_q & 8'h2F) != 8'd0)
      || (write_group_q[3] && (write_word_q & 8'hFF) != 8'd0)
      || (write_group_q[4] && (write_word_q & 8'h83) != 8'd0)
      || (write_group_q[5] && (write_word_q & 8'h03) != 8'd0)
      || (write_group_q[6] && (write_word_q & 8'hE0) != 8'd0)
      || (write_group_q[7] && (write_word_q & 8'h03) != 8'd0)
      || (write_group_q[8] && (write_word_q & 8'h4F) != 8'd0)
      || (write_group_q[9] && (write_word_q & 8'h11) != 8'd0)
      || (write_group_q[10] && (write_word_q & 8'h01) != 8'd0);
  assign lockable = (write_group_q[0] && (write_word_q & 8'h3A) != 8'd0)
      || (write_group_q[1] && (write_word_q & 8'h14) != 8'd0)
      || (write_group_q[2] && (write_word_q & 8'h10) != 8'd0)
      || (write_group_q[6] && (write_word_q & 8'h10) != 8'd0);
  assign whole = (write_group_q[1] && (write_word_q & 8'h08) != 8'd0)
      || (write_group_q[4] && (write_word_q & 8'h0C) != 8'd0);

  assign restart_valid_o = taken_q && write_q && write_group_q[1] && write_word_q[3];
  assign restart_key_o = write_data_i[31:0];
  assign map_control_valid_o = taken_q && write_q && write_group_q[4] && write_word_q[2];
  assign map_control_start_o = write_data_i[0];
  assign map_data_valid_o = taken_q && write_q && write_group_q[4] && write_word_q[3];
  assign map_data_word_o = write_data_i[31:0];
  assign write_ready_o = taken_q
      && !(restart_valid_o && !restart_ready_i)
      && !(map_control_valid_o && !map_control_ready_i)
      && !(map_data_valid_o && !map_data_ready_i);

  // What is written is stored a clock later. One-hot: which register.
  logic [43:0] store_q;
  logic [31:0] data_q;
  logic [3:0] strb_q;
  always_ff @(posedge clk_i) begin
    store_q[0] <= taken_q && write_q && write_group_q[0] && write_word_q[0];
    store_q[1] <= taken_q && write_q && write_group_q[0] && write_word_q[1];
    store_q[2] <= taken_q && write_q && write_group_q[0] && write_word_q[3];
    store_q[3] <= taken_q && write_q && write_group_q[0] && write_word_q[4];
    store_q[4] <= taken_q && write_q && write_group_q[0] && write_word_q[5];
    store_q[5] <= taken_q && write_q && write_group_q[0] && write_word_q[6];
    store_q[6] <= taken_q && write_q && write_group_q[0] && write_word_q[7];
    store_q[7] <= taken_q && write_q && write_group_q[1] && write_word_q[0];
    store_q[8] <= taken_q && write_q && write_group_q[1] && write_word_q[2];
    store_q[9] <= taken_q && write_q && write_group_q[1] && write_word_q[4];
    store_q[10] <= taken_q && write_q && write_group_q[2] && write_word_q[0];
    store_q[11] <= taken_q && write_q && write_group_q[2] && write_word_q[1];
    store_q[12] <= taken_q && write_q && write_group_q[2] && write_word_q[2];
    store_q[13] <= taken_q && write_q && write_group_q[2] && write_word_q[3];
    store_q[14] <= taken_q && write_q && write_group_q[2] && write_word_q[4];
    store_q[15] <= taken_q && write_q && write_group_q[2] && write_word_q[5];
    store_q[16] <= taken_q && write_q && write_group_q[3] && write_word_q[0];
    store_q[17] <= taken_q && write_q && write_group_q[3] && write_word_q[1];
    store_q[18] <= taken_q && write_q && write_group_q[3] && write_word_q[2];
    store_q[19] <= taken_q && write_q && write_group_q[3] && write_word_q[3];
    store_q[20] <= taken_q && write_q && write_group_q[3] && write_word_q[4];
    store_q[21] <= taken_q && write_q && write_group_q[3] && write_word_q[5];
    store_q[22] <= taken_q && write_q && write_group_q[3] && write_word_q[6];
    store_q[23] <= taken_q && write_q && write_group_q[3] && write_word_q[7];
    store_q[24] <= taken_q && write_q && write_group_q[4] && write_word_q[0];
    store_q[25] <= taken_q && write_q && write_group_q[4] && write_word_q[1];
    store_q[26] <= taken_q && write_q && write_group_q[4] && write_word_q[7];
    store_q[27] <= taken_q && write_q && write_group_q[6] && write_word_q[4];
    store_q[28] <= taken_q && write_q && write_group_q[6] && write_word_q[5];
    store_q[29] <= taken_q && write_q && write_group_q[6] && write_word_q[6];
    store_q[30] <= taken_q && write_q && write_group_q[6] && write_word_q[7];
    store_q[31] <= taken_q && write_q && write_group_q[7] && write_word_q[0];
    store_q[32] <= taken_q && write_q && write_group_q[7] && write_word_q[1];
    store_q[33] <= taken_q && write_q && write_group_q[8] && write_word_q[0];
    store_q[34] <= taken_q && write_q && write_group_q[8] && write_word_q[1];
    store_q[35] <= taken_q && write_q && write_group_q[8] && write_word_q[2];
    store_q[36] <= taken_q && write_q && write_group_q[8] && write_word_q[3];
    store_q[37] <= taken_q && write_q && write_group_q[8] && write_word_q[6];
    store_q[38] <= taken_q && write_q && write_group_q[9] && write_word_q[0];
    store_q[39] <= taken_q && write_q && write_group_q[9] && write_word_q[4];
    store_q[40] <= taken_q && write_q && write_group_q[10] && write_word_q[0];
    store_q[41] <= taken_q && write_q && write_group_q[1] && write_word_q[1];
    store_q[42] <= taken_q && write_q && write_group_q[5] && write_word_q[0];
    store_q[43] <= taken_q && write_q && write_group_q[5] && write_word_q[1];
    if (!rst_ni) store_q <= '0;
    data_q <= write_data_i;
    strb_q <= write_strb_i;
  end

  // CONTROL: Run control. While enable is 0 the streaming core is in reset.
  logic        control_enable_q;
  assign control_enable_o = control_enable_q;
  // MODE: What the streams are.
  logic        mode_live_q;
  assign mode_live_o = mode_live_q;
  logic        mode_test_input_q;
  assign mode_test_input_o = mode_test_input_q;
  // WIDTH: Width of the incoming images.
  logic [11:0] width_px_q;
  assign width_px_o = width_px_q;
  // HEIGHT: Height of the incoming images.
  logic [11:0] height_rows_q;
  assign height_rows_o = height_rows_q;
  // LOOKAHEAD: Rows the right image is ahead of the output.
  logic [11:0] lookahead_rows_q;
  assign lookahead_rows_o = lookahead_rows_q;
  // TIMEOUT: Watchdog: longest time without a pixel of a camera, and without a finished frame. A new value counts from the next pixel, the next frame on.
  logic [31:0] timeout_clocks_q;
  assign timeout_clocks_o = timeout_clocks_q;
  // TABLE_SELECT: Mapping table of the next output frame.
  logic [ 3:0] table_select_slot_q;
  assign table_select_slot_o = table_select_slot_q;
  // IRQ_ENABLE: What raises irq_o; fields as in IRQ_STATUS.
  logic        irq_enable_frame_q;
  logic        irq_enable_fault_q;
  assign irq_enable_o = {irq_enable_fault_q, irq_enable_frame_q};
  // INTERLOCK: What lets safe_o rise at start, and after an alarm or a fault (rtl/store/horopter_interlock.sv).
  logic        interlock_by_itself_q;
  logic        interlock_by_pin_q;
  logic        interlock_by_register_q;
  logic [ 3:0] interlock_frames_q;
  assign interlock_o = {interlock_frames_q, interlock_by_register_q, interlock_by_pin_q, interlock_by_itself_q};
  // FEEDBACK: Contactors that safe_o switches (rtl/store/horopter_feedback.sv).
  logic [31:0] feedback_clocks_q;
  assign feedback_clocks_o = feedback_clocks_q;
  // SUM_LIMIT: A pixel is in the skin when its DSAD sum is at most this.
  logic [15:0] sum_limit_value_q;
  assign sum_limit_value_o = sum_limit_value_q;
  // SELF_LIMIT: A window whose left directions differ from those of their neighbours by no more than this in sum is no texture.
  logic [15:0] self_limit_value_q;
  assign self_limit_value_o = self_limit_value_q;
  // TEXTURE_LIMIT: A pixel is decidable when the left magnitude, summed over 3×3, is at least this.
  logic [15:0] texture_limit_sum_q;
  assign texture_limit_sum_o = texture_limit_sum_q;
  // ALARM_LIMIT: More skin pixels than this in a frame are an alarm.
  logic [23:0] alarm_limit_pixels_q;
  assign alarm_limit_pixels_o = alarm_limit_pixels_q;
  // ALARM_FRAMES: In how many frames an alarm must be seen until it is one (rtl/store/horopter_alarm_filter.sv).
  logic [ 2:0] alarm_frames_needed_q;
  logic [ 2:0] alarm_frames_of_q;
  assign alarm_frames_o = {alarm_frames_of_q, alarm_frames_needed_q};
  // UNSUPERVISED_LIMIT: More unsupervised pixels than this in a frame are a fault.
  logic [23:0] unsupervised_limit_pixels_q;
  assign unsupervised_limit_pixels_o = unsupervised_limit_pixels_q;
  // BLACK_LEVEL: Black image: grey level at or below which a pixel is black.
  logic [ 7:0] black_level_grey_q;
  assign black_level_grey_o = black_level_grey_q;
  // BLACK_LIMIT: Black image: more black pixels than this are a fault.
  logic [23:0] black_limit_pixels_q;
  assign black_limit_pixels_o = black_limit_pixels_q;
  // WHITE_LEVEL: White image: grey level at or above which a pixel is white.
  logic [ 7:0] white_level_grey_q;
  assign white_level_grey_o = white_level_grey_q;
  // WHITE_LIMIT: White image: more white pixels than this are a fault.
  logic [23:0] white_limit_pixels_q;
  assign white_limit_pixels_o = white_limit_pixels_q;
  // CONSTANT_LIMIT: Constant image: brightest minus darkest pixel not above this is a fault.
  logic [ 7:0] constant_limit_grey_q;
  assign constant_limit_grey_o = constant_limit_grey_q;
  // FROZEN_LIMIT: Frozen image: one of the two frames before again, this many times in a row, is a fault. With two fields of an image in turn, one of the four before.
  logic [ 7:0] frozen_limit_frames_q;
  assign frozen_limit_frames_o = frozen_limit_frames_q;
  // DECISION: The rule; fixed where only one is built: a write changes nothing, read it back.
  logic        decision_compete_q;
  assign decision_compete_o = decision_compete_q;
  // COMPETE: Settings of the rule `compete`; 0 where it is not built.
  logic [ 3:0] compete_bias_q;
  logic [ 2:0] compete_smooth_q;
  logic [ 3:0] compete_similar_q;
  logic [ 7:0] compete_quorum_q;
  logic [ 7:0] compete_clear_quorum_q;
  logic [ 3:0] compete_boundary_q;
  assign compete_o = {compete_boundary_q, compete_clear_quorum_q, compete_quorum_q, compete_similar_q, compete_smooth_q, compete_bias_q};
  // MAP_SLOT: Slot of the next upload.
  logic [ 3:0] map_slot_slot_q;
  assign map_slot_slot_o = map_slot_slot_q;
  // MAP_BASE: Where the next upload goes in the pool.
  logic [15:0] map_base_word64_q;
  assign map_base_word64_o = map_base_word64_q;
  // MAP_UNDECIDABLE_LIMIT: Of the tables whose upload starts from now on: more undecidable pixels than this in a frame made by the table are a fault. Stays with the table.
  logic [23:0] map_undecidable_limit_pixels_q;
  assign map_undecidable_limit_pixels_o = map_undecidable_limit_pixels_q;
  // AGREEMENT: Whether both cameras see the same world, compared coarsely over all depths.
  logic        agreement_prove_q;
  logic        agreement_nearer_below_q;
  logic        agreement_nearer_above_q;
  logic [ 5:0] agreement_shift_lowest_q;
  logic [ 5:0] agreement_shift_highest_q;
  logic [ 7:0] agreement_unproven_skin_q;
  assign agreement_o = {agreement_unproven_skin_q, agreement_shift_highest_q, agreement_shift_lowest_q, agreement_nearer_above_q, agreement_nearer_below_q, agreement_prove_q};
  // AGREEMENT_LIMITS: Shares in 1/256.
  logic [ 7:0] agreement_limits_explained_q;
  logic [ 7:0] agreement_limits_regions_q;
  logic [ 7:0] agreement_limits_unproven_q;
  logic [ 7:0] agreement_limits_hidden_q;
  assign agreement_limits_o = {agreement_limits_hidden_q, agreement_limits_unproven_q, agreement_limits_regions_q, agreement_limits_explained_q};
  // HIDDEN: How long something may stand between cameras and skin.
  logic [ 7:0] hidden_frames_q;
  assign hidden_frames_o = hidden_frames_q;
  // REGISTRATION: How far the right image may be displaced across the rows. In 1/32 cell: 1/4 px in `vga`, 1/2 px in `hd`.
  logic [ 5:0] registration_moved_q;
  logic [ 5:0] registration_moved_half_q;
  logic [ 5:0] registration_patches_q;
  logic [ 4:0] registration_on_skin_q;
  logic [ 7:0] registration_on_skin_cells_q;
  assign registration_o = {registration_on_skin_cells_q, registration_on_skin_q, registration_patches_q, registration_moved_half_q, registration_moved_q};
  // EPIPOLAR: Slope of the epipolar lines in the transformed images, two's complement.
  logic [15:0] epipolar_slope_q;
  logic [15:0] epipolar_column_q;
  assign epipolar_o = {epipolar_column_q, epipolar_slope_q};
  // EPIPOLAR_CHANGE: More of it.
  logic [15:0] epipolar_change_row_q;
  logic [15:0] epipolar_change_both_q;
  assign epipolar_change_o = {epipolar_change_both_q, epipolar_change_row_q};
  // ONE_CAMERA: One camera twice: the check of both images against each other (hls/stages/coarse.hpp).
  logic [ 7:0] one_camera_segments_q;
  assign one_camera_segments_o = one_camera_segments_q;
  // BLIND_STEP: Blind camera: a step from a cell of its image to the next one in the row is one that it sees. Cells: 8×8 px, in a build wider than 1024 px 16×16 px.
  logic [ 7:0] blind_step_grey_q;
  assign blind_step_grey_o = blind_step_grey_q;
  // BLIND_SHARE: Blind camera: such steps at a smaller share of the frame's cells than this are a fault. So is a quarter of the strips of four columns of cells, or of the rows of cells, without a step of 3/8 of BLIND_STEP.
  logic [ 7:0] blind_share_of_256_q;
  assign blind_share_of_256_o = blind_share_of_256_q;
  // STILL_LIMIT: Frozen camera: so many frames one after another that repeat one of the two before them, but for noise, are a fault (hls/stages/still.hpp).
  logic [ 7:0] still_limit_frames_q;
  assign still_limit_frames_o = still_limit_frames_q;
  // REGION_SELECT: Which region FRAME_REGION tells of.
  logic [ 5:0] region_select_region_q;
  assign region_select_region_o = region_select_region_q;
  // OBJECT_LIMIT: An object, pixels that touch each other and are in the skin or blind (BLOCKS), of this many pixels is an alarm, at once (hls/stages/objects.hpp).
  logic [23:0] object_limit_pixels_q;
  assign object_limit_pixels_o = object_limit_pixels_q;
  // BLOCKS: Blocks of the result, 8×8 px, in a build wider than 1024 px 16×16 px, and how many of their pixels cannot be decided.
  logic        blocks_watch_q;
  logic        blocks_teach_q;
  logic [ 7:0] blocks_margin_q;
  logic        blocks_dim_q;
  assign blocks_o = {blocks_dim_q, blocks_margin_q, blocks_teach_q, blocks_watch_q};
  // OBJECT_AREA_LIMIT: And so is an object that covers this much of the skin, by the table's areas. A pixel of a table without areas covers 1023.999 mm².
  logic [31:0] object_area_limit_of_1024_q;
  assign object_area_limit_of_1024_o = object_area_limit_of_1024_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      control_enable_q <= 1'd0;
      mode_live_q <= 1'd0;
      mode_test_input_q <= 1'd0;
      width_px_q <= WIDTH_PX_RESET;
      height_rows_q <= HEIGHT_ROWS_RESET;
      lookahead_rows_q <= LOOKAHEAD_ROWS_RESET;
      timeout_clocks_q <= TIMEOUT_CLOCKS_RESET;
      table_select_slot_q <= 4'd15;
      irq_enable_frame_q <= 1'd0;
      irq_enable_fault_q <= 1'd0;
      interlock_by_itself_q <= 1'd0;
      interlock_by_pin_q <= 1'd1;
      interlock_by_register_q <= 1'd0;
      interlock_frames_q <= 4'd2;
      feedback_clocks_q <= 32'd0;
      sum_limit_value_q <= SUM_LIMIT_VALUE_RESET;
      self_limit_value_q <= SELF_LIMIT_VALUE_RESET;
      texture_limit_sum_q <= 16'd288;
      alarm_limit_pixels_q <= ALARM_LIMIT_PIXELS_RESET;
      alarm_frames_needed_q <= 3'd1;
      alarm_frames_of_q <= 3'd1;
      unsupervised_limit_pixels_q <= UNSUPERVISED_LIMIT_PIXELS_RESET;
      black_level_grey_q <= 8'd4;
      black_limit_pixels_q <= BLACK_LIMIT_PIXELS_RESET;
      white_level_grey_q <= 8'd251;
      white_limit_pixels_q <= WHITE_LIMIT_PIXELS_RESET;
      constant_limit_grey_q <= 8'd8;
      frozen_limit_frames_q <= 8'd1;
      decision_compete_q <= DECISION_COMPETE_RESET;
      compete_bias_q <= COMPETE ? 4'd2 : 4'd0;
      compete_smooth_q <= COMPETE ? 3'd2 : 3'd0;
      compete_similar_q <= COMPETE ? 4'd3 : 4'd0;
      compete_quorum_q <= COMPETE ? 8'd10 : 8'd0;
      compete_clear_quorum_q <= COMPETE ? 8'd50 : 8'd0;
      compete_boundary_q <= COMPETE ? 4'd8 : 4'd0;
      map_slot_slot_q <= 4'd0;
      map_base_word64_q <= 16'd0;
      map_undecidable_limit_pixels_q <= 24'd0;
      agreement_prove_q <= 1'd1;
      agreement_nearer_below_q <= 1'd0;
      agreement_nearer_above_q <= 1'd0;
      agreement_shift_lowest_q <= 6'd34;
      agreement_shift_highest_q <= 6'd30;
      agreement_unproven_skin_q <= 8'd154;
      agreement_limits_explained_q <= 8'd107;
      agreement_limits_regions_q <= 8'd64;
      agreement_limits_unproven_q <= 8'd115;
      agreement_limits_hidden_q <= 8'd26;
      hidden_frames_q <= 8'd50;
      registration_moved_q <= 6'd3;
      registration_moved_half_q <= 6'd5;
      registration_patches_q <= 6'd8;
      registration_on_skin_q <= 5'd6;
      registration_on_skin_cells_q <= 8'd31;
      epipolar_slope_q <= 16'd0;
      epipolar_column_q <= 16'd0;
      epipolar_change_row_q <= 16'd0;
      epipolar_change_both_q <= 16'd0;
      one_camera_segments_q <= 8'd12;
      blind_step_grey_q <= 8'd14;
      blind_share_of_256_q <= 8'd2;
      still_limit_frames_q <= 8'd4;
      region_select_region_q <= 6'd0;
      object_limit_pixels_q <= 24'd1000;
      blocks_watch_q <= 1'd0;
      blocks_teach_q <= 1'd0;
      blocks_margin_q <= BLIND ? 8'd8 : 8'd0;
      blocks_dim_q <= 1'd0;
      object_area_limit_of_1024_q <= 32'd4294967295;
    end else begin
      if (store_q[0]) begin  // CONTROL
        if (strb_q[0]) control_enable_q <= data_q[0];
      end
      if (store_q[1]) begin  // MODE
        if (strb_q[0]) begin
          mode_live_q <= data_q[0];
          mode_test_input_q <= data_q[1];
        end
      end
      if (store_q[2]) begin  // WIDTH
        if (strb_q[0]) width_px_q[7:0] <= data_q[7:0];
        if (strb_q[1]) width_px_q[11:8] <= data_q[11:8];
      end
      if (store_q[3]) begin  // HEIGHT
        if (strb_q[0]) height_rows_q[7:0] <= data_q[7:0];
        if (strb_q[1]) height_rows_q[11:8] <= data_q[11:8];
      end
      if (store_q[4]) begin  // LOOKAHEAD
        if (strb_q[0]) lookahead_rows_q[7:0] <= data_q[7:0];
        if (strb_q[1]) lookahead_rows_q[11:8] <= data_q[11:8];
      end
      if (store_q[5]) begin  // TIMEOUT
        if (strb_q[0]) timeout_clocks_q[7:0] <= data_q[7:0];
        if (strb_q[1]) timeout_clocks_q[15:8] <= data_q[15:8];
        if (strb_q[2]) timeout_clocks_q[23:16] <= data_q[23:16];
        if (strb_q[3]) timeout_clocks_q[31:24] <= data_q[31:24];
      end
      if (store_q[6]) begin  // TABLE_SELECT
        if (strb_q[0]) table_select_slot_q[3:0] <= data_q[3:0];
      end
      if (store_q[7]) begin  // IRQ_ENABLE
        if (strb_q[0]) begin
          irq_enable_frame_q <= data_q[0];
          irq_enable_fault_q <= data_q[1];
        end
      end
      if (store_q[8]) begin  // INTERLOCK
        if (strb_q[0]) begin
          interlock_by_itself_q <= data_q[0];
          interlock_by_pin_q <= data_q[1];
          interlock_by_register_q <= data_q[2];
          interlock_frames_q[3:0] <= data_q[6:3];
        end
      end
      if (store_q[9]) begin  // FEEDBACK
        if (strb_q[0]) feedback_clocks_q[7:0] <= data_q[7:0];
        if (strb_q[1]) feedback_clocks_q[15:8] <= data_q[15:8];
        if (strb_q[2]) feedback_clocks_q[23:16] <= data_q[23:16];
        if (strb_q[3]) feedback_clocks_q[31:24] <= data_q[31:24];
      end
      if (store_q[10]) begin  // SUM_LIMIT
        if (strb_q[0]) sum_limit_value_q[7:0] <= data_q[7:0];
        if (strb_q[1]) sum_limit_value_q[15:8] <= data_q[15:8];
      end
      if (store_q[11]) begin  // SELF_LIMIT
        if (strb_q[0]) self_limit_value_q[7:0] <= data_q[7:0];
        if (strb_q[1]) self_limit_value_q[15:8] <= data_q[15:8];
      end
      if (store_q[12]) begin  // TEXTURE_LIMIT
        if (strb_q[0]) texture_limit_sum_q[7:0] <= data_q[7:0];
        if (strb_q[1]) texture_limit_sum_q[15:8] <= data_q[15:8];
      end
      if (store_q[13]) begin  // ALARM_LIMIT
        if (strb_q[0]) alarm_limit_pixels_q[7:0] <= data_q[7:0];
        if (strb_q[1]) alarm_limit_pixels_q[15:8] <= data_q[15:8];
        if (strb_q[2]) alarm_limit_pixels_q[23:16] <= data_q[23:16];
      end
      if (store_q[14]) begin  // ALARM_FRAMES
        if (strb_q[0]) begin
          alarm_frames_needed_q[2:0] <= data_q[2:0];
          alarm_frames_of_q[2:0] <= data_q[5:3];
        end
      end
      if (store_q[15]) begin  // UNSUPERVISED_LIMIT
        if (strb_q[0]) unsupervised_limit_pixels_q[7:0] <= data_q[7:0];
        if (strb_q[1]) unsupervised_limit_pixels_q[15:8] <= data_q[15:8];
        if (strb_q[2]) unsupervised_limit_pixels_q[23:16] <= data_q[23:16];
      end
      if (store_q[16]) begin  // BLACK_LEVEL
        if (strb_q[0]) black_level_grey_q[7:0] <= data_q[7:0];
      end
      if (store_q[17]) begin  // BLACK_LIMIT
        if (strb_q[0]) black_limit_pixels_q[7:0] <= data_q[7:0];
        if (strb_q[1]) black_limit_pixels_q[15:8] <= data_q[15:8];
        if (strb_q[2]) black_limit_pixels_q[23:16] <= data_q[23:16];
      end
      if (store_q[18]) begin  // WHITE_LEVEL
        if (strb_q[0]) white_level_grey_q[7:0] <= data_q[7:0];
      end
      if (store_q[19]) begin  // WHITE_LIMIT
        if (strb_q[0]) white_limit_pixels_q[7:0] <= data_q[7:0];
        if (strb_q[1]) white_limit_pixels_q[15:8] <= data_q[15:8];
        if (strb_q[2]) white_limit_pixels_q[23:16] <= data_q[23:16];
      end
      if (store_q[20]) begin  // CONSTANT_LIMIT
        if (strb_q[0]) constant_limit_grey_q[7:0] <= data_q[7:0];
      end
      if (store_q[21]) begin  // FROZEN_LIMIT
        if (strb_q[0]) frozen_limit_frames_q[7:0] <= data_q[7:0];
      end
      if (BOTH_RULES && store_q[22]) begin  // DECISION
        if (strb_q[0]) decision_compete_q <= data_q[0];
      end
      if (COMPETE && store_q[23]) begin  // COMPETE
        if (strb_q[0]) begin
          compete_bias_q[3:0] <= data_q[3:0];
          compete_smooth_q[2:0] <= data_q[6:4];
          compete_similar_q[0] <= data_q[7];
        end
        if (strb_q[1]) begin
          compete_similar_q[3:1] <= data_q[10:8];
          compete_quorum_q[4:0] <= data_q[15:11];
        end
        if (strb_q[2]) begin
          compete_quorum_q[7:5] <= data_q[18:16];
          compete_clear_quorum_q[4:0] <= data_q[23:19];
        end
        if (strb_q[3]) begin
          compete_clear_quorum_q[7:5] <= data_q[26:24];
          compete_boundary_q[3:0] <= data_q[30:27];
        end
      end
      if (store_q[24]) begin  // MAP_SLOT
        if (strb_q[0]) map_slot_slot_q[3:0] <= data_q[3:0];
      end
      if (store_q[25]) begin  // MAP_BASE
        if (strb_q[0]) map_base_word64_q[7:0] <= data_q[7:0];
        if (strb_q[1]) map_base_word64_q[15:8] <= data_q[15:8];
      end
      if (store_q[26]) begin  // MAP_UNDECIDABLE_LIMIT
        if (strb_q[0]) map_undecidable_limit_pixels_q[7:0] <= data_q[7:0];
        if (strb_q[1]) map_undecidable_limit_pixels_q[15:8] <= data_q[15:8];
        if (strb_q[2]) map_undecidable_limit_pixels_q[23:16] <= data_q[23:16];
      end
      if (store_q[27]) begin  // AGREEMENT
        if (strb_q[0]) begin
          agreement_prove_q <= data_q[0];
          agreement_nearer_below_q <= data_q[1];
          agreement_nearer_above_q <= data_q[2];
          agreement_shift_lowest_q[4:0] <= data_q[7:3];
        end
        if (strb_q[1]) begin
          agreement_shift_lowest_q[5] <= data_q[8];
          agreement_shift_highest_q[5:0] <= data_q[14:9];
          agreement_unproven_skin_q[0] <= data_q[15];
        end
        if (strb_q[2]) agreement_unproven_skin_q[7:1] <= data_q[22:16];
      end
      if (store_q[28]) begin  // AGREEMENT_LIMITS
        if (strb_q[0]) agreement_limits_explained_q[7:0] <= data_q[7:0];
        if (strb_q[1]) agreement_limits_regions_q[7:0] <= data_q[15:8];
        if (strb_q[2]) agreement_limits_unproven_q[7:0] <= data_q[23:16];
        if (strb_q[3]) agreement_limits_hidden_q[7:0] <= data_q[31:24];
      end
      if (store_q[29]) begin  // HIDDEN
        if (strb_q[0]) hidden_frames_q[7:0] <= data_q[7:0];
      end
      if (store_q[30]) begin  // REGISTRATION
        if (strb_q[0]) begin
          registration_moved_q[5:0] <= data_q[5:0];
          registration_moved_half_q[1:0] <= data_q[7:6];
        end
        if (strb_q[1]) begin
          registration_moved_half_q[5:2] <= data_q[11:8];
          registration_patches_q[3:0] <= data_q[15:12];
        end
        if (strb_q[2]) begin
          registration_patches_q[5:4] <= data_q[17:16];
          registration_on_skin_q[4:0] <= data_q[22:18];
          registration_on_skin_cells_q[0] <= data_q[23];
        end
        if (strb_q[3]) registration_on_skin_cells_q[7:1] <= data_q[30:24];
      end
      if (store_q[31]) begin  // EPIPOLAR
        if (strb_q[0]) epipolar_slope_q[7:0] <= data_q[7:0];
        if (strb_q[1]) epipolar_slope_q[15:8] <= data_q[15:8];
        if (strb_q[2]) epipolar_column_q[7:0] <= data_q[23:16];
        if (strb_q[3]) epipolar_column_q[15:8] <= data_q[31:24];
      end
      if (store_q[32]) begin  // EPIPOLAR_CHANGE
        if (strb_q[0]) epipolar_change_row_q[7:0] <= data_q[7:0];
        if (strb_q[1]) epipolar_change_row_q[15:8] <= data_q[15:8];
        if (strb_q[2]) epipolar_change_both_q[7:0] <= data_q[23:16];
        if (strb_q[3]) epipolar_change_both_q[15:8] <= data_q[31:24];
      end
      if (store_q[33]) begin  // ONE_CAMERA
        if (strb_q[0]) one_camera_segments_q[7:0] <= data_q[7:0];
      end
      if (store_q[34]) begin  // BLIND_STEP
        if (strb_q[0]) blind_step_grey_q[7:0] <= data_q[7:0];
      end
      if (store_q[35]) begin  // BLIND_SHARE
        if (strb_q[0]) blind_share_of_256_q[7:0] <= data_q[7:0];
      end
      if (store_q[36]) begin  // STILL_LIMIT
        if (strb_q[0]) still_limit_frames_q[7:0] <= data_q[7:0];
      end
      if (store_q[37]) begin  // REGION_SELECT
        if (strb_q[0]) region_select_region_q[5:0] <= data_q[5:0];
      end
      if (store_q[38]) begin  // OBJECT_LIMIT
        if (strb_q[0]) object_limit_pixels_q[7:0] <= data_q[7:0];
        if (strb_q[1]) object_limit_pixels_q[15:8] <= data_q[15:8];
        if (strb_q[2]) object_limit_pixels_q[23:16] <= data_q[23:16];
      end
      if (BLIND && store_q[39]) begin  // BLOCKS
        if (strb_q[0]) begin
          blocks_watch_q <= data_q[0];
          blocks_teach_q <= data_q[1];
          blocks_margin_q[5:0] <= data_q[7:2];
        end
        if (strb_q[1]) begin
          blocks_margin_q[7:6] <= data_q[9:8];
          blocks_dim_q <= data_q[10];
        end
      end
      if (store_q[40]) begin  // OBJECT_AREA_LIMIT
        if (strb_q[0]) object_area_limit_of_1024_q[7:0] <= data_q[7:0];
        if (strb_q[1]) object_area_limit_of_1024_q[15:8] <= data_q[15:8];
        if (strb_q[2]) object_area_limit_of_1024_q[23:16] <= data_q[23:16];
        if (strb_q[3]) object_area_limit_of_1024_q[31:24] <= data_q[31:24];
      end
    end
  end

  // Each of these registers is guarded.
  logic [40:0] guard_error;
  always_ff @(posedge clk_i) changed_o <= guard_error != '0;
  horopter_guard #(
      .WIDTH(1)
  ) u_control_guard (
      .clk_i(clk_i),
      .write_i(store_q[0] || !rst_ni),
      .value_i({control_enable_q}),
      .error_o(guard_error[0])
  );
  horopter_guard #(
      .WIDTH(2)
  ) u_mode_guard (
      .clk_i(clk_i),
      .write_i(store_q[1] || !rst_ni),
      .value_i({mode_test_input_q, mode_live_q}),
      .error_o(guard_error[1])
  );
  horopter_guard #(
      .WIDTH(12)
  ) u_width_guard (
      .clk_i(clk_i),
      .write_i(store_q[2] || !rst_ni),
      .value_i({width_px_q}),
      .error_o(guard_error[2])
  );
  horopter_guard #(
      .WIDTH(12)
  ) u_height_guard (
      .clk_i(clk_i),
      .write_i(store_q[3] || !rst_ni),
      .value_i({height_rows_q}),
      .error_o(guard_error[3])
  );
  horopter_guard #(
      .WIDTH(12)
  ) u_lookahead_guard (
      .clk_i(clk_i),
      .write_i(store_q[4] || !rst_ni),
      .value_i({lookahead_rows_q}),
      .error_o(guard_error[4])
  );
  horopter_guard #(
      .WIDTH(32)
  ) u_timeout_guard (
      .clk_i(clk_i),
      .write_i(store_q[5] || !rst_ni),
      .value_i({timeout_clocks_q}),
      .error_o(guard_error[5])
  );
  horopter_guard #(
      .WIDTH(4)
  ) u_table_select_guard (
      .clk_i(clk_i),
      .write_i(store_q[6] || !rst_ni),
      .value_i({table_select_slot_q}),
      .error_o(guard_error[6])
  );
  horopter_guard #(
      .WIDTH(2)
  ) u_irq_enable_guard (
      .clk_i(clk_i),
      .write_i(store_q[7] || !rst_ni),
      .value_i({irq_enable_fault_q, irq_enable_frame_q}),
      .error_o(guard_error[7])
  );
  horopter_guard #(
      .WIDTH(7)
  ) u_interlock_guard (
      .clk_i(clk_i),
      .write_i(store_q[8] || !rst_ni),
      .value_i({interlock_frames_q, interlock_by_register_q, interlock_by_pin_q, interlock_by_itself_q}),
      .error_o(guard_error[8])
  );
  horopter_guard #(
      .WIDTH(32)
  ) u_feedback_guard (
      .clk_i(clk_i),
      .write_i(store_q[9] || !rst_ni),
      .value_i({feedback_clocks_q}),
      .error_o(guard_error[9])
  );
  horopter_guard #(
      .WIDTH(16)
  ) u_sum_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[10] || !rst_ni),
      .value_i({sum_limit_value_q}),
      .error_o(guard_error[10])
  );
  horopter_guard #(
      .WIDTH(16)
  ) u_self_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[11] || !rst_ni),
      .value_i({self_limit_value_q}),
      .error_o(guard_error[11])
  );
  horopter_guard #(
      .WIDTH(16)
  ) u_texture_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[12] || !rst_ni),
      .value_i({texture_limit_sum_q}),
      .error_o(guard_error[12])
  );
  horopter_guard #(
      .WIDTH(24)
  ) u_alarm_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[13] || !rst_ni),
      .value_i({alarm_limit_pixels_q}),
      .error_o(guard_error[13])
  );
  horopter_guard #(
      .WIDTH(6)
  ) u_alarm_frames_guard (
      .clk_i(clk_i),
      .write_i(store_q[14] || !rst_ni),
      .value_i({alarm_frames_of_q, alarm_frames_needed_q}),
      .error_o(guard_error[14])
  );
  horopter_guard #(
      .WIDTH(24)
  ) u_unsupervised_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[15] || !rst_ni),
      .value_i({unsupervised_limit_pixels_q}),
      .error_o(guard_error[15])
  );
  horopter_guard #(
      .WIDTH(8)
  ) u_black_level_guard (
      .clk_i(clk_i),
      .write_i(store_q[16] || !rst_ni),
      .value_i({black_level_grey_q}),
      .error_o(guard_error[16])
  );
  horopter_guard #(
      .WIDTH(24)
  ) u_black_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[17] || !rst_ni),
      .value_i({black_limit_pixels_q}),
      .error_o(guard_error[17])
  );
  horopter_guard #(
      .WIDTH(8)
  ) u_white_level_guard (
      .clk_i(clk_i),
      .write_i(store_q[18] || !rst_ni),
      .value_i({white_level_grey_q}),
      .error_o(guard_error[18])
  );
  horopter_guard #(
      .WIDTH(24)
  ) u_white_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[19] || !rst_ni),
      .value_i({white_limit_pixels_q}),
      .error_o(guard_error[19])
  );
  horopter_guard #(
      .WIDTH(8)
  ) u_constant_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[20] || !rst_ni),
      .value_i({constant_limit_grey_q}),
      .error_o(guard_error[20])
  );
  horopter_guard #(
      .WIDTH(8)
  ) u_frozen_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[21] || !rst_ni),
      .value_i({frozen_limit_frames_q}),
      .error_o(guard_error[21])
  );
  horopter_guard #(
      .WIDTH(1)
  ) u_decision_guard (
      .clk_i(clk_i),
      .write_i(store_q[22] || !rst_ni),
      .value_i({decision_compete_q}),
      .error_o(guard_error[22])
  );
  horopter_guard #(
      .WIDTH(31)
  ) u_compete_guard (
      .clk_i(clk_i),
      .write_i(store_q[23] || !rst_ni),
      .value_i({compete_boundary_q, compete_clear_quorum_q, compete_quorum_q, compete_similar_q, compete_smooth_q, compete_bias_q}),
      .error_o(guard_error[23])
  );
  horopter_guard #(
      .WIDTH(4)
  ) u_map_slot_guard (
      .clk_i(clk_i),
      .write_i(store_q[24] || !rst_ni),
      .value_i({map_slot_slot_q}),
      .error_o(guard_error[24])
  );
  horopter_guard #(
      .WIDTH(16)
  ) u_map_base_guard (
      .clk_i(clk_i),
      .write_i(store_q[25] || !rst_ni),
      .value_i({map_base_word64_q}),
      .error_o(guard_error[25])
  );
  horopter_guard #(
      .WIDTH(24)
  ) u_map_undecidable_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[26] || !rst_ni),
      .value_i({map_undecidable_limit_pixels_q}),
      .error_o(guard_error[26])
  );
  horopter_guard #(
      .WIDTH(23)
  ) u_agreement_guard (
      .clk_i(clk_i),
      .write_i(store_q[27] || !rst_ni),
      .value_i({agreement_unproven_skin_q, agreement_shift_highest_q, agreement_shift_lowest_q, agreement_nearer_above_q, agreement_nearer_below_q, agreement_prove_q}),
      .error_o(guard_error[27])
  );
  horopter_guard #(
      .WIDTH(32)
  ) u_agreement_limits_guard (
      .clk_i(clk_i),
      .write_i(store_q[28] || !rst_ni),
      .value_i({agreement_limits_hidden_q, agreement_limits_unproven_q, agreement_limits_regions_q, agreement_limits_explained_q}),
      .error_o(guard_error[28])
  );
  horopter_guard #(
      .WIDTH(8)
  ) u_hidden_guard (
      .clk_i(clk_i),
      .write_i(store_q[29] || !rst_ni),
      .value_i({hidden_frames_q}),
      .error_o(guard_error[29])
  );
  horopter_guard #(
      .WIDTH(31)
  ) u_registration_guard (
      .clk_i(clk_i),
      .write_i(store_q[30] || !rst_ni),
      .value_i({registration_on_skin_cells_q, registration_on_skin_q, registration_patches_q, registration_moved_half_q, registration_moved_q}),
      .error_o(guard_error[30])
  );
  horopter_guard #(
      .WIDTH(32)
  ) u_epipolar_guard (
      .clk_i(clk_i),
      .write_i(store_q[31] || !rst_ni),
      .value_i({epipolar_column_q, epipolar_slope_q}),
      .error_o(guard_error[31])
  );
  horopter_guard #(
      .WIDTH(32)
  ) u_epipolar_change_guard (
      .clk_i(clk_i),
      .write_i(store_q[32] || !rst_ni),
      .value_i({epipolar_change_both_q, epipolar_change_row_q}),
      .error_o(guard_error[32])
  );
  horopter_guard #(
      .WIDTH(8)
  ) u_one_camera_guard (
      .clk_i(clk_i),
      .write_i(store_q[33] || !rst_ni),
      .value_i({one_camera_segments_q}),
      .error_o(guard_error[33])
  );
  horopter_guard #(
      .WIDTH(8)
  ) u_blind_step_guard (
      .clk_i(clk_i),
      .write_i(store_q[34] || !rst_ni),
      .value_i({blind_step_grey_q}),
      .error_o(guard_error[34])
  );
  horopter_guard #(
      .WIDTH(8)
  ) u_blind_share_guard (
      .clk_i(clk_i),
      .write_i(store_q[35] || !rst_ni),
      .value_i({blind_share_of_256_q}),
      .error_o(guard_error[35])
  );
  horopter_guard #(
      .WIDTH(8)
  ) u_still_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[36] || !rst_ni),
      .value_i({still_limit_frames_q}),
      .error_o(guard_error[36])
  );
  horopter_guard #(
      .WIDTH(6)
  ) u_region_select_guard (
      .clk_i(clk_i),
      .write_i(store_q[37] || !rst_ni),
      .value_i({region_select_region_q}),
      .error_o(guard_error[37])
  );
  horopter_guard #(
      .WIDTH(24)
  ) u_object_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[38] || !rst_ni),
      .value_i({object_limit_pixels_q}),
      .error_o(guard_error[38])
  );
  horopter_guard #(
      .WIDTH(11)
  ) u_blocks_guard (
      .clk_i(clk_i),
      .write_i(store_q[39] || !rst_ni),
      .value_i({blocks_dim_q, blocks_margin_q, blocks_teach_q, blocks_watch_q}),
      .error_o(guard_error[39])
  );
  horopter_guard #(
      .WIDTH(32)
  ) u_object_area_limit_guard (
      .clk_i(clk_i),
      .write_i(store_q[40] || !rst_ni),
      .value_i({object_area_limit_of_1024_q}),
      .error_o(guard_error[40])
  );

  // IRQ_STATUS: Events since they were last cleared.
  logic [ 1:0] irq_status_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) irq_status_q <= 2'd0;
    else if (store_q[41])
      irq_status_q <= (irq_status_q & ~(data_q[1:0] & {{2{strb_q[0]}}})) | irq_status_set_i;
    else irq_status_q <= irq_status_q | irq_status_set_i;
  end
  assign irq_status_o = irq_status_q;

  // FAULTS_CAMERAS: Every fault of the cameras since it was last cleared; a written 1 clears. safe_o does not depend on this register.
  logic [27:0] faults_cameras_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) faults_cameras_q <= 28'd0;
    else if (store_q[42])
      faults_cameras_q <= (faults_cameras_q & ~({data_q[29:16], data_q[13:0]} & {{6{strb_q[3]}}, {8{strb_q[2]}}, {6{strb_q[1]}}, {8{strb_q[0]}}})) | faults_cameras_set_i;
    else faults_cameras_q <= faults_cameras_q | faults_cameras_set_i;
  end
  assign faults_cameras_o = faults_cameras_q;

  // FAULTS_MACHINE: The same for faults of both cameras together, of tables and of the machine.
  logic [21:0] faults_machine_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) faults_machine_q <= 22'd0;
    else if (store_q[43])
      faults_machine_q <= (faults_machine_q & ~(data_q[21:0] & {{6{strb_q[2]}}, {8{strb_q[1]}}, {8{strb_q[0]}}})) | faults_machine_set_i;
    else faults_machine_q <= faults_machine_q | faults_machine_set_i;
  end
  assign faults_machine_o = faults_machine_q;

  // Reads, in three steps: which group of eight, if the word exists; the word (zero in the others); all together.
  logic [31:0] group_00_q;
  logic [31:0] group_02_q;
  logic [31:0] group_03_q;
  logic [31:0] group_04_q;
  logic [31:0] group_05_q;
  logic [31:0] group_06_q;
  logic [31:0] group_07_q;
  logic [31:0] group_08_q;
  logic [31:0] group_09_q;
  logic [31:0] group_0A_q;
  logic [31:0] group_0C_q;
  logic [31:0] group_0D_q;
  logic [31:0] group_0E_q;
  logic [12:0] wanted_q;
  logic known_q, memory_wanted_q, memory_known_q;
  logic [7:0] word_q;
  always_ff @(posedge clk_i) begin
    word_q <= 8'd1 << read_addr_i[4:2];
    wanted_q <= '0;
    memory_wanted_q <= 1'b0;
    case (read_addr_i)
      12'h000, 12'h004, 12'h008, 12'h00C, 12'h010, 12'h014, 12'h018: wanted_q[0] <= 1'b1;
      12'h040, 12'h044, 12'h048, 12'h04C, 12'h050, 12'h054, 12'h058, 12'h05C: wanted_q[1] <= 1'b1;
      12'h060, 12'h064, 12'h068, 12'h070: wanted_q[2] <= 1'b1;
      12'h080, 12'h084, 12'h088, 12'h08C, 12'h090, 12'h094: wanted_q[3] <= 1'b1;
      12'h0A0, 12'h0A4, 12'h0A8, 12'h0AC, 12'h0B0, 12'h0B4, 12'h0B8, 12'h0BC: wanted_q[4] <= 1'b1;
      12'h0C0, 12'h0C4, 12'h0D0, 12'h0D4, 12'h0D8, 12'h0DC: wanted_q[5] <= 1'b1;
      12'h0E0, 12'h0E4, 12'h0E8: wanted_q[6] <= 1'b1;
      12'h100, 12'h104, 12'h108, 12'h10C, 12'h110, 12'h114, 12'h118, 12'h11C: wanted_q[7] <= 1'b1;
      12'h120, 12'h124, 12'h128, 12'h12C, 12'h130, 12'h134, 12'h138, 12'h13C: wanted_q[8] <= 1'b1;
      12'h140, 12'h144: wanted_q[9] <= 1'b1;
      12'h180, 12'h184, 12'h188, 12'h18C, 12'h190, 12'h194, 12'h198: wanted_q[10] <= 1'b1;
      12'h1A0, 12'h1A4, 12'h1A8, 12'h1AC, 12'h1B0, 12'h1B4, 12'h1B8, 12'h1BC: wanted_q[11] <= 1'b1;
      12'h1C0: wanted_q[12] <= 1'b1;
      12'h150, 12'h154, 12'h158, 12'h15C, 12'h160, 12'h164, 12'h168, 12'h16C, 12'h170, 12'h174, 12'h178, 12'h17C,
      12'h19C: memory_wanted_q <= 1'b1;
      default: ;  // no register
    endcase
    group_00_q <= 32'd0;
    if (wanted_q[0])
      group_00_q <= (word_q[0] ? 32'h484F524F : 32'd0)
        | (word_q[1] ? {16'h2, 16'h8} : 32'd0)
        | (word_q[2] ? {build_size_height_i, build_size_width_i} : 32'd0)
        | (word_q[3] ? {build_store_pool_kib_i, build_store_rows_i} : 32'd0)
        | (word_q[4] ? {1'd0, build_window_blind_i, build_window_compete_i, build_window_thesis_i, build_window_hypotheses_i, build_window_weight_bits_i, build_window_subsample_i, build_window_majority_i, build_window_dsad_i} : 32'd0)
        | (word_q[5] ? build_clock_khz_i : 32'd0)
        | (word_q[6] ? {11'd0, build_compete_paths_i, build_compete_ballot_reach_i, build_compete_sum_columns_i, build_compete_sum_rows_i, build_compete_planes_i} : 32'd0);
    group_02_q <= 32'd0;
    if (wanted_q[1])
      group_02_q <= (word_q[0] ? {31'd0, control_enable_q} : 32'd0)
        | (word_q[1] ? {30'd0, mode_test_input_q, mode_live_q} : 32'd0)
        | (word_q[2] ? {21'd0, status_i} : 32'd0)
        | (word_q[3] ? {20'd0, width_px_q} : 32'd0)
        | (word_q[4] ? {20'd0, height_rows_q} : 32'd0)
        | (word_q[5] ? {20'd0, lookahead_rows_q} : 32'd0)
        | (word_q[6] ? timeout_clocks_q : 32'd0)
        | (word_q[7] ? {28'd0, table_select_slot_q} : 32'd0);
    group_03_q <= 32'd0;
    if (wanted_q[2])
      group_03_q <= (word_q[0] ? {30'd0, irq_enable_fault_q, irq_enable_frame_q} : 32'd0)
        | (word_q[1] ? {30'd0, irq_status_q} : 32'd0)
        | (word_q[2] ? {25'd0, interlock_frames_q, interlock_by_register_q, interlock_by_pin_q, interlock_by_itself_q} : 32'd0)
        | (word_q[4] ? feedback_clocks_q : 32'd0);
    group_04_q <= 32'd0;
    if (wanted_q[3])
      group_04_q <= (word_q[0] ? {16'd0, sum_limit_value_q} : 32'd0)
        | (word_q[1] ? {16'd0, self_limit_value_q} : 32'd0)
        | (word_q[2] ? {16'd0, texture_limit_sum_q} : 32'd0)
        | (word_q[3] ? {8'd0, alarm_limit_pixels_q} : 32'd0)
        | (word_q[4] ? {26'd0, alarm_frames_of_q, alarm_frames_needed_q} : 32'd0)
        | (word_q[5] ? {8'd0, unsupervised_limit_pixels_q} : 32'd0);
    group_05_q <= 32'd0;
    if (wanted_q[4])
      group_05_q <= (word_q[0] ? {24'd0, black_level_grey_q} : 32'd0)
        | (word_q[1] ? {8'd0, black_limit_pixels_q} : 32'd0)
        | (word_q[2] ? {24'd0, white_level_grey_q} : 32'd0)
        | (word_q[3] ? {8'd0, white_limit_pixels_q} : 32'd0)
        | (word_q[4] ? {24'd0, constant_limit_grey_q} : 32'd0)
        | (word_q[5] ? {24'd0, frozen_limit_frames_q} : 32'd0)
        | (word_q[6] ? {31'd0, decision_compete_q} : 32'd0)
        | (word_q[7] ? {1'd0, compete_boundary_q, compete_clear_quorum_q, compete_quorum_q, compete_similar_q, compete_smooth_q, compete_bias_q} : 32'd0);
    group_06_q <= 32'd0;
    if (wanted_q[5])
      group_06_q <= (word_q[0] ? {28'd0, map_slot_slot_q} : 32'd0)
        | (word_q[1] ? {16'd0, map_base_word64_q} : 32'd0)
        | (word_q[4] ? {24'd0, map_status_active_slot_i, map_status_error_i, map_status_busy_i} : 32'd0)
        | (word_q[5] ? {17'd0, map_valid_slots_i} : 32'd0)
        | (word_q[6] ? map_crc_value_i : 32'd0)
        | (word_q[7] ? {8'd0, map_undecidable_limit_pixels_q} : 32'd0);
    group_07_q <= 32'd0;
    if (wanted_q[6])
      group_07_q <= (word_q[0] ? {2'd0, faults_cameras_q[27:14], 2'd0, faults_cameras_q[13:0]} : 32'd0)
        | (word_q[1] ? {10'd0, faults_machine_q} : 32'd0)
        | (word_q[2] ? {map_extent_end_word64_i, map_extent_base_word64_i} : 32'd0);
    group_08_q <= 32'd0;
    if (wanted_q[7])
      group_08_q <= (word_q[0] ? frame_sequence_value_i : 32'd0)
        | (word_q[1] ? {25'd0, frame_status_i} : 32'd0)
        | (word_q[2] ? {2'd0, frame_faults_cameras_i[27:14], 2'd0, frame_faults_cameras_i[13:0]} : 32'd0)
        | (word_q[3] ? frame_table_crc_value_i : 32'd0)
        | (word_q[4] ? {8'd0, frame_skin_pixels_i} : 32'd0)
        | (word_q[5] ? {8'd0, frame_undecidable_pixels_i} : 32'd0)
        | (word_q[6] ? {8'd0, frame_unsupervised_pixels_i} : 32'd0)
        | (word_q[7] ? {8'd0, frame_misses_pixels_i} : 32'd0);
    group_09_q <= 32'd0;
    if (wanted_q[8])
      group_09_q <= (word_q[0] ? frame_cycles_clocks_i : 32'd0)
        | (word_q[1] ? frame_latency_clocks_i : 32'd0)
        | (word_q[2] ? frame_tail_clocks_i : 32'd0)
        | (word_q[3] ? {10'd0, frame_faults_machine_i} : 32'd0)
        | (word_q[4] ? {9'd0, agreement_unproven_skin_q, agreement_shift_highest_q, agreement_shift_lowest_q, agreement_nearer_above_q, agreement_nearer_below_q, agreement_prove_q} : 32'd0)
        | (word_q[5] ? {agreement_limits_hidden_q, agreement_limits_unproven_q, agreement_limits_regions_q, agreement_limits_explained_q} : 32'd0)
        | (word_q[6] ? {24'd0, hidden_frames_q} : 32'd0)
        | (word_q[7] ? {1'd0, registration_on_skin_cells_q, registration_on_skin_q, registration_patches_q, registration_moved_half_q, registration_moved_q} : 32'd0);
    group_0A_q <= 32'd0;
    if (wanted_q[9])
      group_0A_q <= (word_q[0] ? {epipolar_column_q, epipolar_slope_q} : 32'd0)
        | (word_q[1] ? {epipolar_change_both_q, epipolar_change_row_q} : 32'd0);
    group_0C_q <= 32'd0;
    if (wanted_q[10])
      group_0C_q <= (word_q[0] ? {24'd0, one_camera_segments_q} : 32'd0)
        | (word_q[1] ? {24'd0, blind_step_grey_q} : 32'd0)
        | (word_q[2] ? {24'd0, blind_share_of_256_q} : 32'd0)
        | (word_q[3] ? {24'd0, still_limit_frames_q} : 32'd0)
        | (word_q[4] ? {8'd0, frame_hidden_pixels_i} : 32'd0)
        | (word_q[5] ? {8'd0, frame_unproven_pixels_pixels_i} : 32'd0)
        | (word_q[6] ? {26'd0, region_select_region_q} : 32'd0);
    group_0D_q <= 32'd0;
    if (wanted_q[11])
      group_0D_q <= (word_q[0] ? {8'd0, object_limit_pixels_q} : 32'd0)
        | (word_q[1] ? {8'd0, frame_object_pixels_i} : 32'd0)
        | (word_q[2] ? {4'd0, frame_object_columns_i[23:12], 4'd0, frame_object_columns_i[11:0]} : 32'd0)
        | (word_q[3] ? {4'd0, frame_object_rows_i[23:12], 4'd0, frame_object_rows_i[11:0]} : 32'd0)
        | (word_q[4] ? {21'd0, blocks_dim_q, blocks_margin_q, blocks_teach_q, blocks_watch_q} : 32'd0)
        | (word_q[5] ? {8'd0, frame_blind_pixels_i} : 32'd0)
        | (word_q[6] ? {16'd0, taught_frames_i} : 32'd0)
        | (word_q[7] ? frame_object_area_of_1024_i : 32'd0);
    group_0E_q <= 32'd0;
    if (wanted_q[12])
      group_0E_q <= (word_q[0] ? object_area_limit_of_1024_q : 32'd0);
    known_q <= wanted_q != '0;
    memory_known_q <= memory_wanted_q;
    read_data_o <= group_00_q | group_02_q | group_03_q | group_04_q | group_05_q | group_06_q | group_07_q | group_08_q | group_09_q | group_0A_q | group_0C_q | group_0D_q | group_0E_q | (memory_known_q ? memory_word_i : 32'd0);
    read_error_o <= !known_q && !memory_known_q;
  end
endmodule
