// SPDX-License-Identifier: Apache-2.0
// Horopter: two cameras in, the state of every pixel out.
//
// Sizes come from horopter_profile_pkg (one package per profile, in rtl/generated/<profile>); registers are described in
// rtl/csr/registers.md. One clock; rst_ni synchronous, active low.
//
// s_axis_left, s_axis_right  AXI4-Stream Video, 8-bit grey: tuser = first pixel of a frame, tlast = last of a line.
// s_axis_test                both images in one stream, {right, left}, taken instead of the cameras with MODE.test_input.
// m_axis_state               one beat a pixel of the result in raster order, tdata[1:0] = 0 clear, 1 skin,
//                            2 undecidable, 3 unsupervised; tuser, tlast as above.
// m_axis_runs                the rows as runs: {state[63:62], 14'b0, row[47:32], start[31:16], end[15:0]}, end included,
//                            every row covered completely; tlast = last run of a frame.
// m_axis_objects             the objects of a frame, in the order in which they end: {sum of rows[207:176], sum of
//                            columns[175:144], bottom[143:128], top[127:112], right[111:96], left[95:80], area in
//                            1/1024 mm2[79:48], blind pixels[47:24], pixels[23:0]}. After them, with tlast, a beat of
//                            the frame: {128'b0, FRAME_SEQUENCE[79:48], objects that were not sent[47:24], objects[23:0]}.
//                            Nothing waits for it: while 16 wait, more are not sent, and counted. With a beat of a frame
//                            that has not been taken when the next frame ends, nothing is sent of that one.
// restart_i                  a button, of any clock: see INTERLOCK and horopter_interlock.sv.
// feedback_i                 of the contactors that safe_o switches, of any clock: see FEEDBACK and horopter_feedback.sv.
// safe_o, unsafe_o           complements, from separate registers; safe only while the last two frames were complete, in
//                            time, free of faults and of alarm, and a restart was given since the last time they were
//                            not. Anything but safe_o = 1 and unsafe_o = 0 means not safe.
// heartbeat_o                toggles with every finished frame. frame_done_o: one clock, the FRAME registers are new.
//
// Parameters fit the memories of a small part: the pool of mapping tables, and the largest LOOKAHEAD, that is the left
// delay: a larger one is a bad geometry. A profile that has both rules of decision can be built with one of them. TWICE: what
// says where each pixel comes from is built twice, against upsets. BLIND: watches for what goes blind; 0: BLOCKS keeps its reset.
module horopter_top #(
    parameter bit THESIS = horopter_profile_pkg::THESIS,
    parameter bit COMPETE = horopter_profile_pkg::COMPETE,
    parameter int unsigned POOL_BYTES = horopter_profile_pkg::POOL_BYTES,
    parameter int unsigned MAX_LOOKAHEAD = horopter_profile_pkg::STORE_ROWS / 2,
    parameter bit TWICE = horopter_profile_pkg::COMPETE,
    parameter bit BLIND = 1'b1
) (
    input  logic        clk_i,
    input  logic        rst_ni,
    // AXI4-Lite slave
    input  logic [11:0] s_axil_awaddr,
    input  logic [ 2:0] s_axil_awprot,
    input  logic        s_axil_awvalid,
    output logic        s_axil_awready,
    input  logic [31:0] s_axil_wdata,
    input  logic [ 3:0] s_axil_wstrb,
    input  logic        s_axil_wvalid,
    output logic        s_axil_wready,
    output logic [ 1:0] s_axil_bresp,
    output logic        s_axil_bvalid,
    input  logic        s_axil_bready,
    input  logic [11:0] s_axil_araddr,
    input  logic [ 2:0] s_axil_arprot,
    input  logic        s_axil_arvalid,
    output logic        s_axil_arready,
    output logic [31:0] s_axil_rdata,
    output logic [ 1:0] s_axil_rresp,
    output logic        s_axil_rvalid,
    input  logic        s_axil_rready,
    // left camera
    input  logic [ 7:0] s_axis_left_tdata,
    input  logic        s_axis_left_tuser,
    input  logic        s_axis_left_tlast,
    input  logic        s_axis_left_tvalid,
    output logic        s_axis_left_tready,
    // right camera
    input  logic [ 7:0] s_axis_right_tdata,
    input  logic        s_axis_right_tuser,
    input  logic        s_axis_right_tlast,
    input  logic        s_axis_right_tvalid,
    output logic        s_axis_right_tready,
    // test frames
    input  logic [15:0] s_axis_test_tdata,
    input  logic        s_axis_test_tuser,
    input  logic        s_axis_test_tlast,
    input  logic        s_axis_test_tvalid,
    output logic        s_axis_test_tready,
    // states
    output logic [ 7:0] m_axis_state_tdata,
    output logic        m_axis_state_tuser,
    output logic        m_axis_state_tlast,
    output logic        m_axis_state_tvalid,
    input  logic        m_axis_state_tready,
    // runs
    output logic [63:0] m_axis_runs_tdata,
    output logic        m_axis_runs_tlast,
    output logic        m_axis_runs_tvalid,
    input  logic        m_axis_runs_tready,
    // objects
    output logic [207:0] m_axis_objects_tdata,
    output logic        m_axis_objects_tlast,
    output logic        m_axis_objects_tvalid,
    input  logic        m_axis_objects_tready,
    // status
    input  logic        restart_i,
    input  logic        feedback_i,
    output logic        safe_o,
    output logic        unsafe_o,
    output logic        heartbeat_o,
    output logic        frame_done_o,
    output logic        irq_o
);
  localparam int unsigned WIDTH = horopter_profile_pkg::WIDTH;
  localparam int unsigned HEIGHT = horopter_profile_pkg::HEIGHT;
  localparam int unsigned SUBSAMPLE = horopter_profile_pkg::SUBSAMPLE;
  localparam int unsigned DSAD_WINDOW = horopter_profile_pkg::DSAD_WINDOW;
  localparam int unsigned WEIGHT_BITS = horopter_profile_pkg::WEIGHT_BITS;
  localparam int unsigned STORE_ROWS = horopter_profile_pkg::STORE_ROWS;
  localparam int unsigned RESULT_WIDTH = WIDTH / SUBSAMPLE;
  localparam int unsigned RESULT_PIXELS = RESULT_WIDTH * HEIGHT;
  localparam bit FAST = horopter_profile_pkg::CLOCK_KHZ > 50_000;  // beyond, a register must follow every step
  localparam int unsigned LEFT_ROWS = MAX_LOOKAHEAD + 8;  // LOOKAHEAD rows, one arriving, one leaving, and slack
  // for a frame whose end is noticed only with the start of the next
  localparam int unsigned MAX_SUM = 15 * DSAD_WINDOW * DSAD_WINDOW;

  // Beats that can be under way from the raster generator to the output FIFOs: a bound on the sum of all latencies.
  localparam int unsigned IN_FLIGHT = FAST ? 160 : 128;
  localparam int unsigned RING_BITS = $clog2(STORE_ROWS);
  localparam int unsigned LEFT_BITS = $clog2(LEFT_ROWS);
  localparam int unsigned MAP_ADDR_BITS = $clog2(POOL_BYTES / 8);
  localparam int unsigned SUM_BITS = $clog2(MAX_SUM + 1);
  localparam int unsigned TEXTURE_BITS = $clog2(3 * 3 * 255 + 1);
  localparam int unsigned COUNT_BITS = $clog2(RESULT_PIXELS + 1);
  localparam int unsigned PIXEL_BITS = $clog2(WIDTH * HEIGHT + 1);
  localparam int unsigned RESULT_WIDTH_BITS = $clog2(RESULT_WIDTH + 1);
  localparam int unsigned RESULT_HEIGHT_BITS = $clog2(HEIGHT + 1);
  localparam int unsigned COLUMN_BITS = $clog2(RESULT_WIDTH);
  localparam int unsigned ROW_BITS = $clog2(HEIGHT);

  if (SUBSAMPLE != 1 && SUBSAMPLE != 2) begin : g_illegal_subsample
    $fatal(1, "horopter_top: SUBSAMPLE must be 1 or 2");
  end
  if (MAX_LOOKAHEAD == 0 || MAX_LOOKAHEAD > STORE_ROWS / 2) begin : g_illegal_lookahead
    $fatal(1, "horopter_top: MAX_LOOKAHEAD must be 1 to half of STORE_ROWS");
  end
  if (POOL_BYTES > horopter_profile_pkg::POOL_BYTES) begin : g_illegal_pool
    $fatal(1, "horopter_top: POOL_BYTES must be at most the profile's");
  end
  if (horopter_profile_pkg::HYPOTHESES != 1) begin : g_illegal_hypotheses
    $fatal(1, "horopter_top: connects stages with one hypothesis");
  end

  // ------------------------------------------------------------------------------------------------ registers
  logic write_valid, write_ready, write_error, read_error;
  logic [11:0] write_addr, read_addr;
  logic [31:0] write_data, read_data;
  logic [3:0] write_strb;

  horopter_axil_slave #(
      .ADDR_BITS(12)
  ) u_axil (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .s_axil_awaddr(s_axil_awaddr),
      .s_axil_awvalid(s_axil_awvalid),
      .s_axil_awready(s_axil_awready),
      .s_axil_wdata(s_axil_wdata),
      .s_axil_wstrb(s_axil_wstrb),
      .s_axil_wvalid(s_axil_wvalid),
      .s_axil_wready(s_axil_wready),
      .s_axil_bresp(s_axil_bresp),
      .s_axil_bvalid(s_axil_bvalid),
      .s_axil_bready(s_axil_bready),
      .s_axil_araddr(s_axil_araddr),
      .s_axil_arvalid(s_axil_arvalid),
      .s_axil_arready(s_axil_arready),
      .s_axil_rdata(s_axil_rdata),
      .s_axil_rresp(s_axil_rresp),
      .s_axil_rvalid(s_axil_rvalid),
      .s_axil_rready(s_axil_rready),
      .write_valid_o(write_valid),
      .write_ready_i(write_ready),
      .write_addr_o(write_addr),
      .write_data_o(write_data),
      .write_strb_o(write_strb),
      .write_error_i(write_error),
      .read_addr_o(read_addr),
      .read_data_i(read_data),
      .read_error_i(read_error)
  );
  // AXI4-Lite has them; nothing here depends on them.
  logic unused_prot;
  assign unused_prot = ^{s_axil_awprot, s_axil_arprot};

  logic enable, live, test_input, core_rst_n;
  logic [1:0] changed;  // without a write: a register, what a frame has sampled
  horopter_csr_pkg::status_t status;
  logic [11:0] width, height, lookahead;
  logic [31:0] timeout;
  logic [3:0] table_select, active_slot_q;
  logic same_table_q;  // the frame before of this field had the same one
  horopter_csr_pkg::irq_enable_t irq_enable;
  horopter_csr_pkg::irq_status_t irq_set, irq_status;
  logic [15:0] sum_limit, self_limit, texture_limit;
  logic [23:0] alarm_limit, object_limit, map_undecidable_limit, unsupervised_limit, black_limit, white_limit;
  logic [7:0] black_level, white_level, constant_limit, frozen_limit, one_camera_segments;
  logic [7:0] blind_step, blind_share, still_limit;
  horopter_csr_pkg::agreement_t agreement, sampled_agreement;
  horopter_csr_pkg::agreement_limits_t agreement_limits, sampled_agreement_limits;
  logic [7:0] hidden_frames, sampled_hidden_frames;
  horopter_csr_pkg::registration_t registration, sampled_registration;
  horopter_csr_pkg::epipolar_t epipolar, sampled_epipolar;
  horopter_csr_pkg::epipolar_change_t epipolar_change, sampled_epipolar_change;
  logic [5:0] region_select;
  logic [31:0] frame_word;
  logic [23:0] frame_object, frame_blind;
  logic [31:0] object_area_limit, sampled_object_area_limit, frame_object_area;
  horopter_csr_pkg::blocks_t blocks, sampled_blocks;
  logic dim;  // the frame is looked at as half of the light would show it
  logic [15:0] taught_frames;
  horopter_csr_pkg::frame_object_columns_t frame_object_columns;
  horopter_csr_pkg::frame_object_rows_t frame_object_rows;
  logic [23:0] frame_hidden, frame_unproven_pixels;
  logic decision_compete;
  horopter_csr_pkg::compete_t compete_settings;
  logic [3:0] map_slot;
  logic [15:0] map_base;
  logic map_control_valid, map_control_ready, map_start, map_data_valid, map_data_ready;
  logic [31:0] map_data, map_crc, map_extent;
  horopter_csr_pkg::interlock_t interlock;
  horopter_csr_pkg::alarm_frames_t alarm_frames;
  logic restart_valid;
  logic [31:0] restart_key, feedback_clocks;
  logic map_busy;
  logic [2:0] map_error;
  logic [14:0] map_valid;
  horopter_csr_pkg::faults_t faults_set;
  logic [1:0] frame_busy, silent;
  logic bad_upload, refused_upload;
  logic [31:0] frame_sequence, frame_table_crc, frame_cycles, frame_latency, frame_tail;
  horopter_csr_pkg::frame_status_t frame_status;
  logic [23:0] frame_skin, frame_undecidable, frame_unsupervised, frame_misses;
  horopter_csr_pkg::faults_t frame_faults, faults_now;

  horopter_csr #(
      .BOTH_RULES(THESIS && COMPETE),
      .COMPETE(COMPETE),
      .BLIND(BLIND),
      .DECISION_COMPETE_RESET(!THESIS),
      .WIDTH_PX_RESET(12'(WIDTH)),
      .HEIGHT_ROWS_RESET(12'(HEIGHT)),
      .LOOKAHEAD_ROWS_RESET(12'(MAX_LOOKAHEAD)),
      .TIMEOUT_CLOCKS_RESET(32'(2 * WIDTH * HEIGHT)),
      .SUM_LIMIT_VALUE_RESET(16'(MAX_SUM / 4)),
      .SELF_LIMIT_VALUE_RESET(16'(DSAD_WINDOW * DSAD_WINDOW)),
      .ALARM_LIMIT_PIXELS_RESET(24'(RESULT_PIXELS / 20)),
      .UNSUPERVISED_LIMIT_PIXELS_RESET(24'(RESULT_PIXELS)),
      .BLACK_LIMIT_PIXELS_RESET(24'(WIDTH * HEIGHT / 20 * 19)),
      .WHITE_LIMIT_PIXELS_RESET(24'(WIDTH * HEIGHT / 20 * 19))
  ) u_csr (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .locked_i(enable),
      .write_valid_i(write_valid),
      .write_ready_o(write_ready),
      .write_addr_i(write_addr),
      .write_data_i(write_data),
      .write_strb_i(write_strb),
      .write_error_o(write_error),
      .read_addr_i(read_addr),
      .read_data_o(read_data),
      .read_error_o(read_error),
      .changed_o(changed[0]),
      .memory_word_i(frame_word),
      .build_size_width_i(16'(WIDTH)),
      .build_size_height_i(16'(HEIGHT)),
      .build_store_rows_i(16'(STORE_ROWS)),
      .build_store_pool_kib_i(16'(POOL_BYTES / 1024)),
      .build_window_dsad_i(8'(DSAD_WINDOW)),
      .build_window_majority_i(8'(horopter_profile_pkg::MAJORITY_WINDOW)),
      .build_window_subsample_i(4'(SUBSAMPLE)),
      .build_window_weight_bits_i(4'(WEIGHT_BITS)),
      .build_window_hypotheses_i(4'(horopter_profile_pkg::HYPOTHESES)),
      .build_window_thesis_i(THESIS),
      .build_window_compete_i(COMPETE),
      .build_window_blind_i(BLIND),
      .build_compete_planes_i(COMPETE ? 8'(horopter_profile_pkg::PLANES) : 8'd0),
      .build_compete_sum_rows_i(COMPETE ? 4'(horopter_profile_pkg::SUM_ROWS) : 4'd0),
      .build_compete_sum_columns_i(COMPETE ? 4'(horopter_profile_pkg::SUM_COLUMNS) : 4'd0),
      .build_compete_ballot_reach_i(COMPETE ? 4'(horopter_profile_pkg::BALLOT_REACH) : 4'd0),
      .build_compete_paths_i(COMPETE && 1'(horopter_profile_pkg::PATHS)),
      .build_clock_khz_i(32'(horopter_profile_pkg::CLOCK_KHZ)),
      .control_enable_o(enable),
      .mode_live_o(live),
      .mode_test_input_o(test_input),
      .status_i(status),
      .width_px_o(width),
      .height_rows_o(height),
      .lookahead_rows_o(lookahead),
      .timeout_clocks_o(timeout),
      .table_select_slot_o(table_select),
      .irq_enable_o(irq_enable),
      .irq_status_set_i(irq_set),
      .irq_status_o(irq_status),
      .interlock_o(interlock),
      .alarm_frames_o(alarm_frames),
      .feedback_clocks_o(feedback_clocks),
      .restart_valid_o(restart_valid),
      .restart_ready_i(1'b1),
      .restart_key_o(restart_key),
      .sum_limit_value_o(sum_limit),
      .self_limit_value_o(self_limit),
      .texture_limit_sum_o(texture_limit),
      .alarm_limit_pixels_o(alarm_limit),
      .object_limit_pixels_o(object_limit),
      .object_area_limit_of_1024_o(object_area_limit),
      .blocks_o(blocks),
      .unsupervised_limit_pixels_o(unsupervised_limit),
      .black_level_grey_o(black_level),
      .black_limit_pixels_o(black_limit),
      .white_level_grey_o(white_level),
      .white_limit_pixels_o(white_limit),
      .constant_limit_grey_o(constant_limit),
      .frozen_limit_frames_o(frozen_limit),
      .one_camera_segments_o(one_camera_segments),
      .blind_step_grey_o(blind_step),
      .blind_share_of_256_o(blind_share),
      .still_limit_frames_o(still_limit),
      .decision_compete_o(decision_compete),
      .compete_o(compete_settings),
      .agreement_o(agreement),
      .agreement_limits_o(agreement_limits),
      .hidden_frames_o(hidden_frames),
      .registration_o(registration),
      .epipolar_o(epipolar),
      .epipolar_change_o(epipolar_change),
      .region_select_region_o(region_select),
      .frame_hidden_pixels_i(frame_hidden),
      .frame_unproven_pixels_pixels_i(frame_unproven_pixels),
      .frame_object_pixels_i(frame_object),
      .frame_object_columns_i(frame_object_columns),
      .frame_object_rows_i(frame_object_rows),
      .frame_object_area_of_1024_i(frame_object_area),
      .frame_blind_pixels_i(frame_blind),
      .taught_frames_i(taught_frames),
      .map_slot_slot_o(map_slot),
      .map_base_word64_o(map_base),
      .map_undecidable_limit_pixels_o(map_undecidable_limit),
      .map_control_valid_o(map_control_valid),
      .map_control_ready_i(map_control_ready),
      .map_control_start_o(map_start),
      .map_data_valid_o(map_data_valid),
      .map_data_ready_i(map_data_ready),
      .map_data_word_o(map_data),
      .map_status_busy_i(map_busy),
      .map_status_error_i(map_error),
      .map_status_active_slot_i(active_slot_q),
      .map_valid_slots_i(map_valid),
      .map_crc_value_i(map_crc),
      .map_extent_base_word64_i(map_extent[15:0]),
      .map_extent_end_word64_i(map_extent[31:16]),
      .faults_cameras_set_i({faults_set.right, faults_set.left}),
      .faults_cameras_o({faults_now.right, faults_now.left}),
      .faults_machine_set_i(faults_set.machine),
      .faults_machine_o(faults_now.machine),
      .frame_sequence_value_i(frame_sequence),
      .frame_status_i(frame_status),
      .frame_faults_cameras_i({frame_faults.right, frame_faults.left}),
      .frame_table_crc_value_i(frame_table_crc),
      .frame_skin_pixels_i(frame_skin),
      .frame_undecidable_pixels_i(frame_undecidable),
      .frame_unsupervised_pixels_i(frame_unsupervised),
      .frame_misses_pixels_i(frame_misses),
      .frame_cycles_clocks_i(frame_cycles),
      .frame_latency_clocks_i(frame_latency),
      .frame_tail_clocks_i(frame_tail),
      .frame_faults_machine_i(frame_faults.machine)
  );

  logic unused_faults_now;
  assign unused_faults_now = ^faults_now;  // read by software only

  // ------------------------------------------------------------------------------------------------ settings of a frame
  logic frame_open, frame_begin;
  logic [7:0] sampled_black_level, sampled_white_level, sampled_constant_limit, sampled_frozen_limit;
  logic [PIXEL_BITS-1:0] sampled_black_limit, sampled_white_limit;
  logic [SUM_BITS-1:0] sampled_sum_limit, sampled_self_limit;
  logic [TEXTURE_BITS-1:0] sampled_texture_limit;
  logic [23:0] table_undecidable_limit;
  logic [47:0] table_unsupervised;
  logic table_ok;
  logic [COUNT_BITS-1:0] sampled_alarm_limit, sampled_object_limit, sampled_undecidable_limit, sampled_unsupervised_limit;
  logic sampled_compete;
  horopter_csr_pkg::compete_t sampled_settings;
  logic [RESULT_WIDTH_BITS-1:0] result_width;
  logic [RESULT_HEIGHT_BITS-1:0] result_height;
  horopter_settings #(
      .THESIS(THESIS),
      .COMPETE(COMPETE),
      .PIXEL_BITS(PIXEL_BITS),
      .SUM_BITS(SUM_BITS),
      .TEXTURE_BITS(TEXTURE_BITS),
      .COUNT_BITS(COUNT_BITS),
      .WIDTH_BITS(RESULT_WIDTH_BITS),
      .HEIGHT_BITS(RESULT_HEIGHT_BITS)
  ) u_settings (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .black_level_i(black_level),
      .white_level_i(white_level),
      .constant_limit_i(constant_limit),
      .frozen_limit_i(frozen_limit),
      .black_limit_i(black_limit),
      .white_limit_i(white_limit),
      .sum_limit_i(sum_limit),
      .self_limit_i(self_limit),
      .texture_limit_i(texture_limit),
      .alarm_limit_i(alarm_limit),
      .object_limit_i(object_limit),
      .object_area_limit_i(object_area_limit),
      .blocks_i(blocks),
      .undecidable_limit_i(table_undecidable_limit),
      .table_ok_i(table_ok),
      .unsupervised_i(table_unsupervised),
      .unsupervised_limit_i(unsupervised_limit),
      .agreement_i(agreement),
      .agreement_limits_i(agreement_limits),
      .hidden_frames_i(hidden_frames),
      .registration_i(registration),
      .epipolar_i(epipolar),
      .epipolar_change_i(epipolar_change),
      .decision_compete_i(decision_compete),
      .compete_i(compete_settings),
      .width_i(width),
      .height_i(RESULT_HEIGHT_BITS'(height)),
      .open_i(frame_open),
      .black_level_o(sampled_black_level),
      .white_level_o(sampled_white_level),
      .constant_limit_o(sampled_constant_limit),
      .frozen_limit_o(sampled_frozen_limit),
      .black_limit_o(sampled_black_limit),
      .white_limit_o(sampled_white_limit),
      .begin_i(frame_begin),
      .sum_limit_o(sampled_sum_limit),
      .self_limit_o(sampled_self_limit),
      .texture_limit_o(sampled_texture_limit),
      .alarm_limit_o(sampled_alarm_limit),
      .object_limit_o(sampled_object_limit),
      .object_area_limit_o(sampled_object_area_limit),
      .blocks_o(sampled_blocks),
      .dim_o(dim),
      .undecidable_limit_o(sampled_undecidable_limit),
      .unsupervised_limit_o(sampled_unsupervised_limit),
      .agreement_o(sampled_agreement),
      .agreement_limits_o(sampled_agreement_limits),
      .hidden_frames_o(sampled_hidden_frames),
      .registration_o(sampled_registration),
      .epipolar_o(sampled_epipolar),
      .epipolar_change_o(sampled_epipolar_change),
      .decision_compete_o(sampled_compete),
      .compete_o(sampled_settings),
      .result_width_o(result_width),
      .result_height_o(result_height),
      .changed_o(changed[1])
  );

  // ------------------------------------------------------------------------------------------------ cameras in
  // Index 0 = left, 1 = right.
  logic [1:0] room, start, start_empty, urgent, grant, deny, cut, near, far, deep, gone, pair_silent, frame_ended;
  logic [1:0] write_en, row_done, row_bad, silence, health_end, health_valid;
  logic [11:0] left_write_x, right_write_x;
  logic [LEFT_BITS:0] left_stored, left_keep;
  logic [RING_BITS:0] right_stored, right_keep;
  logic [7:0] left_write_pixel, right_write_pixel;
  logic [LEFT_BITS-1:0] left_slot, left_write_slot;
  logic [RING_BITS-1:0] right_slot, right_write_slot;
  horopter_csr_pkg::stream_faults_t left_stream, right_stream;
  horopter_csr_pkg::health_t left_health, right_health;
  logic [31:0] left_signature, right_signature;
  logic [1:0] cell_valid, cell_start, blind, still;
  logic [7:0] left_cell_mean, right_cell_mean;
  logic judged, judged_slot, one_camera;
  logic open_slot, arrived, skew, patience;
  assign patience = frame_open && !live;
  assign s_axis_test_tready = test_input && (live || (core_rst_n && room == 2'b11));

  horopter_camera_input #(
      .SLOTS(LEFT_ROWS),
      .FAST(FAST)
  ) u_left_camera (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .live_i(live),
      .test_input_i(test_input),
      .width_i(width),
      .height_i(height),
      .timeout_i(timeout),
      .black_level_i(sampled_black_level),
      .white_level_i(sampled_white_level),
      .black_limit_i(sampled_black_limit),
      .white_limit_i(sampled_white_limit),
      .constant_limit_i(sampled_constant_limit),
      .frozen_limit_i(sampled_frozen_limit),
      .s_axis_tdata(s_axis_left_tdata),
      .s_axis_tuser(s_axis_left_tuser),
      .s_axis_tlast(s_axis_left_tlast),
      .s_axis_tvalid(s_axis_left_tvalid),
      .s_axis_tready(s_axis_left_tready),
      .test_data_i(s_axis_test_tdata[7:0]),
      .test_first_i(s_axis_test_tuser),
      .test_last_i(s_axis_test_tlast),
      .test_valid_i(s_axis_test_tvalid),
      .room_o(room[0]),
      .other_room_i(room[1]),
      .start_o(start[0]),
      .empty_o(start_empty[0]),
      .urgent_o(urgent[0]),
      .grant_i(grant[0]),
      .deny_i(deny[0]),
      .cut_i(cut[0]),
      .patience_i(patience),
      .near_o(near[0]),
      .far_o(far[0]),
      .deep_o(deep[0]),
      .silent_o(silent[0]),
      .gone_o(gone[0]),
      .frame_done_o(frame_ended[0]),
      .lost_silent_i(pair_silent[0]),
      .keep_i(left_keep),
      .stored_o(left_stored),
      .slot_o(left_slot),
      .write_en_o(write_en[0]),
      .write_slot_o(left_write_slot),
      .write_x_o(left_write_x),
      .write_pixel_o(left_write_pixel),
      .row_done_o(row_done[0]),
      .row_bad_o(row_bad[0]),
      .silence_o(silence[0]),
      .stream_o(left_stream),
      .health_end_o(health_end[0]),
      .health_valid_o(health_valid[0]),
      .health_o(left_health),
      .signature_o(left_signature),
      .cell_valid_o(cell_valid[0]),
      .cell_mean_o(left_cell_mean),
      .cell_start_o(cell_start[0])
  );
  horopter_camera_input #(
      .SLOTS(STORE_ROWS),
      .FAST(FAST)
  ) u_right_camera (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .live_i(live),
      .test_input_i(test_input),
      .width_i(width),
      .height_i(height),
      .timeout_i(timeout),
      .black_level_i(sampled_black_level),
      .white_level_i(sampled_white_level),
      .black_limit_i(sampled_black_limit),
      .white_limit_i(sampled_white_limit),
      .constant_limit_i(sampled_constant_limit),
      .frozen_limit_i(sampled_frozen_limit),
      .s_axis_tdata(s_axis_right_tdata),
      .s_axis_tuser(s_axis_right_tuser),
      .s_axis_tlast(s_axis_right_tlast),
      .s_axis_tvalid(s_axis_right_tvalid),
      .s_axis_tready(s_axis_right_tready),
      .test_data_i(s_axis_test_tdata[15:8]),
      .test_first_i(s_axis_test_tuser),
      .test_last_i(s_axis_test_tlast),
      .test_valid_i(s_axis_test_tvalid),
      .room_o(room[1]),
      .other_room_i(room[0]),
      .start_o(start[1]),
      .empty_o(start_empty[1]),
      .urgent_o(urgent[1]),
      .grant_i(grant[1]),
      .deny_i(deny[1]),
      .cut_i(cut[1]),
      .patience_i(patience),
      .near_o(near[1]),
      .far_o(far[1]),
      .deep_o(deep[1]),
      .silent_o(silent[1]),
      .gone_o(gone[1]),
      .frame_done_o(frame_ended[1]),
      .lost_silent_i(pair_silent[1]),
      .keep_i(right_keep),
      .stored_o(right_stored),
      .slot_o(right_slot),
      .write_en_o(write_en[1]),
      .write_slot_o(right_write_slot),
      .write_x_o(right_write_x),
      .write_pixel_o(right_write_pixel),
      .row_done_o(row_done[1]),
      .row_bad_o(row_bad[1]),
      .silence_o(silence[1]),
      .stream_o(right_stream),
      .health_end_o(health_end[1]),
      .health_valid_o(health_valid[1]),
      .health_o(right_health),
      .signature_o(right_signature),
      .cell_valid_o(cell_valid[1]),
      .cell_mean_o(right_cell_mean),
      .cell_start_o(cell_start[1])
  );

  logic read_slot, frame_active, published, left_ended, right_ended;
  logic [11:0] left_rows, right_rows;
  logic [1:0] whole, place_error;
  logic [LEFT_BITS:0] left_base;
  logic [LEFT_BITS-1:0] left_base_slot;
  logic [RING_BITS:0] right_base;
  logic [RING_BITS-1:0] right_base_slot;
  horopter_pairing #(
      .LEFT_BITS(LEFT_BITS),
      .RING_BITS(RING_BITS)
  ) u_pairing (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .live_i(live),
      .height_i(height),
      .start_i(start),
      .empty_i(start_empty),
      .urgent_i(urgent),
      .grant_o(grant),
      .deny_o(deny),
      .cut_o(cut),
      .near_i(near),
      .far_i(far),
      .deep_i(deep),
      .silent_i(silent),
      .gone_i(gone),
      .broken_i({right_stream != '0, left_stream != '0}),
      .row_done_i(row_done),
      .frame_done_i(frame_ended),
      .left_stored_i(left_stored),
      .left_slot_i(left_slot),
      .right_stored_i(right_stored),
      .right_slot_i(right_slot),
      .slot_o(open_slot),
      .open_o(frame_open),
      .arrived_o(arrived),
      .skew_o(skew),
      .lost_silent_o(pair_silent),
      .busy_o(frame_busy),
      .read_slot_i(read_slot),
      .left_rows_o(left_rows),
      .left_ended_o(left_ended),
      .right_rows_o(right_rows),
      .right_ended_o(right_ended),
      .whole_o(whole),
      .left_base_o(left_base),
      .left_base_slot_o(left_base_slot),
      .right_base_o(right_base),
      .right_base_slot_o(right_base_slot),
      .active_i(frame_active),
      .place_error_o(place_error[1]),
      .free_i(published)
  );

  horopter_coarse_check u_coarse_check (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .one_camera_segments_i(one_camera_segments),
      .blind_step_i(blind_step),
      .blind_share_i(blind_share),
      .still_limit_i(still_limit),
      .valid_i(cell_valid),
      .left_mean_i(left_cell_mean),
      .right_mean_i(right_cell_mean),
      .start_i(cell_start),
      .open_i(frame_open),
      .slot_i(open_slot),
      .arrived_i(arrived),
      .judged_o(judged),
      .judged_slot_o(judged_slot),
      .one_camera_o(one_camera),
      .blind_o(blind),
      .still_o(still)
  );

  // ------------------------------------------------------------------------------------------------ map and raster
  logic lookup, table_error;
  logic [MAP_ADDR_BITS-1:0] table_base, map_even_addr, map_odd_addr;
  logic [2:0] table_nx, table_ny;
  logic [11:0] table_columns;
  logic [31:0] table_crc, map_even, map_odd;
  logic map_read, map_parity_error, table_spans;
  logic [11:0] table_areas;
  logic areas_wait, areas_read, areas_error;
  logic [MAP_ADDR_BITS-1:0] areas_addr;
  logic go, beat_parity_error;

  always_ff @(posedge clk_i) begin
    if (!core_rst_n) begin
      active_slot_q <= horopter_csr_pkg::NO_SLOT;
    end else if (lookup) begin
      active_slot_q <= table_select;
    end
  end

  // Two fields take turns, each with a table of its own, which may be replaced in between: the table of two frames ago.
  if (SUBSAMPLE == 1) begin : g_frames
    always_ff @(posedge clk_i) begin
      if (!core_rst_n) same_table_q <= 1'b0;
      else if (lookup) same_table_q <= table_select == active_slot_q;
    end
  end else begin : g_fields
    logic runs_q;  // a frame has begun
    logic [32:0] before_q, two_before_q;  // whether there was one, and its CRC
    always_ff @(posedge clk_i) begin
      same_table_q <= core_rst_n && table_ok && {table_ok, table_crc} == two_before_q;
      if (!core_rst_n) begin
        runs_q <= 1'b0;
        before_q <= '0;
        two_before_q <= '0;
      end else if (lookup) begin
        runs_q <= 1'b1;
        before_q <= {runs_q && table_ok, table_crc};
        two_before_q <= before_q;
      end
    end
  end

  horopter_map_store #(
      .POOL_BYTES(POOL_BYTES),
      .FAST(FAST)
  ) u_map_store (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .running_i(core_rst_n),
      .width_i(width),
      .height_i(height),
      .selected_slot_i(table_select),
      .active_slot_i(active_slot_q),
      .slot_i(map_slot),
      .base_i(map_base),
      .undecidable_limit_i(map_undecidable_limit),
      .start_valid_i(map_control_valid && map_start),
      .start_ready_o(map_control_ready),
      .data_valid_i(map_data_valid),
      .data_ready_o(map_data_ready),
      .data_i(map_data),
      .busy_o(map_busy),
      .error_o(map_error),
      .valid_o(map_valid),
      .slot_crc_o(map_crc),
      .slot_extent_o(map_extent),
      .bad_upload_o(bad_upload),
      .refused_o(refused_upload),
      .lookup_i(lookup),
      .lookup_slot_i(table_select),
      .table_ok_o(table_ok),
      .table_error_o(table_error),
      .table_base_o(table_base),
      .table_areas_o(table_areas),
      .table_nx_o(table_nx),
      .table_ny_o(table_ny),
      .table_columns_o(table_columns),
      .table_spans_o(table_spans),
      .table_crc_o(table_crc),
      .table_undecidable_limit_o(table_undecidable_limit),
      .table_unsupervised_o(table_unsupervised),
      .read_en_i(map_read || areas_read),
      .even_addr_i(areas_read ? areas_addr : map_even_addr),
      .odd_addr_i(areas_read ? areas_addr : map_odd_addr),
      .even_data_o(map_even),
      .odd_data_o(map_odd),
      .parity_error_o(map_parity_error)
  );

  logic place_valid, place_present, place_mapped, place_first, place_last, place_live, places_differ;
  logic [10:0] place_x, place_y;
  logic [WEIGHT_BITS-1:0] place_wx, place_wy;
  localparam int unsigned SAID_BITS = 2 * MAP_ADDR_BITS + 2 * WEIGHT_BITS + 34;
  logic [SAID_BITS-1:0] said;
  horopter_places #(
      .COMPETE(COMPETE),
      .FAST(FAST),
      .SAYS(TWICE),
      .IN_FLIGHT(IN_FLIGHT),
      .MAP_ADDR_BITS(MAP_ADDR_BITS)
  ) u_places (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .width_i(width),
      .height_i(height),
      .lookahead_i(lookahead),
      .compete_i(sampled_compete),
      .go_i(go),
      .busy_i(frame_busy),
      .slot_o(read_slot),
      .left_rows_i(left_rows),
      .left_ended_i(left_ended),
      .right_rows_i(right_rows),
      .right_ended_i(right_ended),
      .begin_o(frame_begin),
      .wait_i(areas_wait),
      .active_o(frame_active),
      .published_i(published),
      .lookup_o(lookup),
      .table_ok_i(table_ok),
      .table_base_i(table_base),
      .table_nx_i(table_nx),
      .table_ny_i(table_ny),
      .table_columns_i(table_columns),
      .table_spans_i(table_spans),
      .map_read_o(map_read),
      .map_even_addr_o(map_even_addr),
      .map_odd_addr_o(map_odd_addr),
      .map_even_i(map_even),
      .map_odd_i(map_odd),
      .map_error_i(map_parity_error),
      .map_parity_error_o(beat_parity_error),
      .valid_o(place_valid),
      .x_o(place_x),
      .y_o(place_y),
      .wx_o(place_wx),
      .wy_o(place_wy),
      .present_o(place_present),
      .mapped_o(place_mapped),
      .first_o(place_first),
      .last_o(place_last),
      .live_o(place_live),
      .said_o(said)
  );
  if (TWICE) begin : g_twice
    // What comes from another place than the table says is compared with the wrong pixels, and nothing else would tell.
    logic [SAID_BITS-1:0] said_again;
    logic unused_slot, unused_begin, unused_active, unused_lookup, unused_map_read, unused_map_parity_error;
    logic unused_valid, unused_present, unused_mapped, unused_first, unused_last, unused_live;
    logic [MAP_ADDR_BITS-1:0] unused_map_even_addr, unused_map_odd_addr;
    logic [10:0] unused_x, unused_y;
    logic [WEIGHT_BITS-1:0] unused_wx, unused_wy;
    (* keep_hierarchy *) horopter_places #(
        .COMPETE(COMPETE),
        .FAST(FAST),
        .SAYS(1'b1),
        .IN_FLIGHT(IN_FLIGHT),
        .MAP_ADDR_BITS(MAP_ADDR_BITS)
    ) u_places_again (
        .clk_i(clk_i),
        .rst_ni(core_rst_n),
        .width_i(width),
        .height_i(height),
        .lookahead_i(lookahead),
        .compete_i(sampled_compete),
        .go_i(go),
        .busy_i(frame_busy),
        .slot_o(unused_slot),
        .left_rows_i(left_rows),
        .left_ended_i(left_ended),
        .right_rows_i(right_rows),
        .right_ended_i(right_ended),
        .begin_o(unused_begin),
        .wait_i(areas_wait),
        .active_o(unused_active),
        .published_i(published),
        .lookup_o(unused_lookup),
        .table_ok_i(table_ok),
        .table_base_i(table_base),
        .table_nx_i(table_nx),
        .table_ny_i(table_ny),
        .table_columns_i(table_columns),
        .table_spans_i(table_spans),
        .map_read_o(unused_map_read),
        .map_even_addr_o(unused_map_even_addr),
        .map_odd_addr_o(unused_map_odd_addr),
        .map_even_i(map_even),
        .map_odd_i(map_odd),
        .map_error_i(map_parity_error),
        .map_parity_error_o(unused_map_parity_error),
        .valid_o(unused_valid),
        .x_o(unused_x),
        .y_o(unused_y),
        .wx_o(unused_wx),
        .wy_o(unused_wy),
        .present_o(unused_present),
        .mapped_o(unused_mapped),
        .first_o(unused_first),
        .last_o(unused_last),
        .live_o(unused_live),
        .said_o(said_again)
    );
    logic [SAID_BITS/8:0] differ_q;
    always_ff @(posedge clk_i) begin
      for (int unsigned i = 0; i <= SAID_BITS / 8; i++) differ_q[i] <= core_rst_n && 8'((said ^ said_again) >> (8 * i)) != 8'd0;
      places_differ <= differ_q != '0;
    end
  end else begin : g_once
    logic unused_said;
    assign unused_said = ^said;
    assign places_differ = 1'b0;
  end

  // ------------------------------------------------------------------------------------------------ right image, transformed
  logic quad_valid, quad_mask, quad_present, quad_first, quad_last, quad_live, quad_miss, quad_parity_error;
  logic [7:0] p00, p01, p10, p11, left_pixel;
  logic swapped_x, swapped_y;
  logic [WEIGHT_BITS-1:0] quad_wx, quad_wy;
  logic left_read_valid, left_read_last, left_read_live, left_mask, left_parity_error;
  horopter_image_store #(
      .WIDTH(WIDTH),
      .HEIGHT(HEIGHT),
      .ROWS(STORE_ROWS),
      .WEIGHT_BITS(WEIGHT_BITS),
      .FAST(FAST)
  ) u_image_store (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .width_i(width),
      .height_i(height),
      .lookahead_i(lookahead),
      .write_en_i(write_en[1]),
      .write_slot_i(right_write_slot),
      .write_x_i(right_write_x),
      .write_pixel_i(right_write_pixel),
      .row_done_i(row_done[1]),
      .row_bad_i(row_bad[1]),
      .begin_i(frame_begin),
      .base_i(right_base),
      .base_slot_i(right_base_slot),
      .rows_i(right_rows),
      .keep_o(right_keep),
      .valid_i(place_valid),
      .x_i(place_x),
      .y_i(place_y),
      .wx_i(place_wx),
      .wy_i(place_wy),
      .present_i(place_present && table_ok),
      .mapped_i(place_mapped && table_ok),
      .first_i(place_first),
      .last_i(place_last),
      .live_i(place_live),
      .left_valid_o(left_read_valid),
      .left_last_o(left_read_last),
      .left_live_o(left_read_live),
      .valid_o(quad_valid),
      .p00_o(p00),
      .p01_o(p01),
      .p10_o(p10),
      .p11_o(p11),
      .swapped_x_o(swapped_x),
      .swapped_y_o(swapped_y),
      .wx_o(quad_wx),
      .wy_o(quad_wy),
      .mask_o(quad_mask),
      .present_o(quad_present),
      .first_o(quad_first),
      .last_o(quad_last),
      .live_o(quad_live),
      .miss_o(quad_miss),
      .parity_error_o(quad_parity_error)
  );
  horopter_left_store #(
      .WIDTH(WIDTH),
      .HEIGHT(HEIGHT),
      .ROWS(LEFT_ROWS),
      .SUBSAMPLE(SUBSAMPLE),
      .FAST(FAST)
  ) u_left_store (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .write_en_i(write_en[0]),
      .write_slot_i(left_write_slot),
      .write_x_i(left_write_x),
      .write_pixel_i(left_write_pixel),
      .row_done_i(row_done[0]),
      .row_bad_i(row_bad[0]),
      .begin_i(frame_begin),
      .base_i(left_base),
      .base_slot_i(left_base_slot),
      .rows_i(left_rows),
      .keep_o(left_keep),
      .place_error_o(place_error[0]),
      .valid_i(left_read_valid),
      .last_i(left_read_last),
      .live_i(left_read_live),
      .pixel_o(left_pixel),
      .mask_o(left_mask),
      .parity_error_o(left_parity_error)
  );
  logic unused_quad;
  assign unused_quad = quad_live;

  // ------------------------------------------------------------------------------------------------ stages
  logic state_valid, state_first, state_last, state_end, state_idle;
  logic [1:0] state;
  logic run_valid, run_last;
  logic [ROW_BITS-1:0] run_row;
  logic [COLUMN_BITS-1:0] run_start, run_end;
  logic [1:0] run_state;
  logic counts_valid, alarm, too_undecidable, too_little_decided, too_unsupervised;
  logic [COUNT_BITS-1:0] skin_pixels, undecidable_pixels, unsupervised_pixels;
  logic verdict_valid, word_valid;
  logic disagree, unproven, moved, hidden, untextured, overlooked, out_of_step;
  logic [1:0] unsharp;
  horopter_csr_pkg::verdict_t verdict;
  assign verdict = {out_of_step, overlooked, unsharp, untextured, hidden, moved, unproven, disagree};  // as horopter_csr_pkg has it
  logic [5:0] word_index;
  logic [31:0] word;
  logic align_hidden, align_unproven;
  logic stage_parity_error;
  horopter_stages #(
      .THESIS(THESIS),
      .COMPETE(COMPETE)
  ) u_stages (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .valid_i(quad_valid),
      .p00_i(p00),
      .p01_i(p01),
      .p10_i(p10),
      .p11_i(p11),
      .swapped_x_i(swapped_x),
      .swapped_y_i(swapped_y),
      .wx_i(quad_wx),
      .wy_i(quad_wy),
      .left_i(left_pixel),
      .mask_i(quad_mask && left_mask),
      .present_i(quad_present && left_mask),
      .marks_first_i(quad_first),
      .marks_last_i(quad_last),
      .cfg_dim_i(dim),
      .cfg_texture_limit_i(sampled_texture_limit),
      .cfg_sum_limit_i(sampled_sum_limit),
      .cfg_self_limit_i(sampled_self_limit),
      .cfg_compete_i(sampled_compete),
      .compete_settings_i(sampled_settings),
      .cfg_prove_i(sampled_agreement.prove),
      .cfg_nearer_below_i(sampled_agreement.nearer_below),
      .cfg_nearer_above_i(sampled_agreement.nearer_above),
      .cfg_shift_lowest_i(sampled_agreement.shift_lowest),
      .cfg_shift_highest_i(sampled_agreement.shift_highest),
      .cfg_explained_limit_i(sampled_agreement_limits.explained),
      .cfg_regions_limit_i(sampled_agreement_limits.regions),
      .cfg_unproven_limit_i(sampled_agreement_limits.unproven),
      .cfg_unproven_skin_limit_i(sampled_agreement.unproven_skin),
      .cfg_hidden_limit_i(sampled_agreement_limits.hidden),
      .cfg_hidden_frames_i(sampled_hidden_frames),
      .cfg_moved_limit_i(sampled_registration.moved),
      .cfg_moved_half_limit_i(sampled_registration.moved_half),
      .cfg_patch_limit_i(sampled_registration.patches),
      .cfg_on_skin_limit_i(sampled_registration.on_skin),
      .cfg_on_skin_cells_i(sampled_registration.on_skin_cells),
      .cfg_alarm_before_i(frame_status.alarm),
      .cfg_same_table_i(same_table_q),
      .cfg_epipolar_slope_i(sampled_epipolar.slope),
      .cfg_epipolar_column_i(sampled_epipolar.column),
      .cfg_epipolar_row_i(sampled_epipolar_change.row),
      .cfg_epipolar_both_i(sampled_epipolar_change.both),
      .parity_error_o(stage_parity_error),
      .agreement_verdict_valid_o(verdict_valid),
      .agreement_verdict_unproven_yet_o(unproven),
      .agreement_verdict_untextured_o(untextured),
      .agreement_verdict_disagree_o(disagree),
      .agreement_verdict_moved_o(moved),
      .agreement_verdict_overlooked_o(overlooked),
      .agreement_verdict_out_of_step_o(out_of_step),
      .agreement_verdict_unsharp_left_o(unsharp[0]),
      .agreement_verdict_unsharp_right_o(unsharp[1]),
      .agreement_verdict_hidden_o(hidden),
      .agreement_frame_valid_o(word_valid),
      .agreement_frame_index_o(word_index),
      .agreement_frame_word_o(word),
      .align_hidden_o(align_hidden),
      .align_unproven_o(align_unproven),
      .cfg_width_i(result_width),
      .cfg_height_i(result_height),
      .cfg_alarm_limit_i(sampled_alarm_limit),
      .cfg_undecidable_limit_i(sampled_undecidable_limit),
      .cfg_unsupervised_limit_i(sampled_unsupervised_limit),
      .align_valid_o(state_valid),
      .align_state_o(state),
      .align_first_o(state_first),
      .align_last_o(state_last),
      .align_end_v_o(state_end),
      .align_idle_o(state_idle),
      .runs_valid_o(run_valid),
      .runs_row_o(run_row),
      .runs_start_o(run_start),
      .runs_end_v_o(run_end),
      .runs_state_o(run_state),
      .runs_last_o(run_last),
      .alarm_valid_o(counts_valid),
      .alarm_skin_pixels_o(skin_pixels),
      .alarm_unsupervised_pixels_o(unsupervised_pixels),
      .alarm_alarm_o(alarm),
      .alarm_too_undecidable_o(too_undecidable),
      .alarm_too_unsupervised_o(too_unsupervised)
  );

  horopter_agreement_result #(
      .COUNT_BITS(COUNT_BITS)
  ) u_agreement_result (
      .clk_i(clk_i),
      .prove_i(sampled_agreement.prove),
      .word_valid_i(word_valid),
      .index_i(word_index),
      .word_i(word),
      .state_valid_i(state_valid && !state_idle),
      .state_first_i(state_first),
      .undecidable_i(state == 2'd2),
      .hidden_i(align_hidden),
      .unproven_pixel_i(align_unproven),
      .counts_valid_i(counts_valid),
      .undecidable_limit_i(sampled_undecidable_limit),
      .undecidable_o(undecidable_pixels),
      .too_undecidable_o(too_little_decided),
      .region_select_i(region_select),
      .read_addr_i(read_addr),
      .word_o(frame_word),
      .frame_hidden_o(frame_hidden),
      .frame_unproven_pixels_o(frame_unproven_pixels)
  );

  logic pixel_valid, pixel_first, pixel_last;
  logic [7:0] pixel_area;
  localparam int unsigned AREA_LATENCY = FAST ? 4 : 3;
  horopter_areas #(
      .ADDR_BITS(MAP_ADDR_BITS),
      .FAST(FAST),
      .LATENCY(AREA_LATENCY)
  ) u_areas (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .begin_i(frame_begin),
      .table_ok_i(table_ok),
      .base_i(table_base),
      .areas_i(table_areas),
      .busy_o(areas_wait),
      .read_o(areas_read),
      .addr_o(areas_addr),
      .even_i(map_even),
      .odd_i(map_odd),
      .error_i(map_parity_error),
      .width_i(result_width),
      .pixel_valid_i(pixel_valid),
      .pixel_first_i(pixel_first),
      .pixel_last_i(pixel_last),
      .area_o(pixel_area),
      .error_o(areas_error)
  );

  logic objects_ended, objects_overflow, object_alarm, taught, forget;
  logic [31:0] next_frame_q;  // what FRAME_SEQUENCE will be
  always_ff @(posedge clk_i) next_frame_q <= frame_sequence + 32'd1;
  horopter_object_check #(
      .BLIND(BLIND),
      .AREA_LATENCY(AREA_LATENCY)
  ) u_object_check (
      .clk_i(clk_i),
      .rst_ni(core_rst_n),
      .bus_rst_ni(rst_ni),
      .begin_i(frame_begin),
      .object_limit_i(sampled_object_limit),
      .object_area_limit_i(sampled_object_area_limit),
      .width_i(result_width),
      .height_i(result_height),
      .blocks_i(sampled_blocks),
      .forget_i(forget),
      .compete_i(sampled_compete),
      .pixel_valid_o(pixel_valid),
      .pixel_first_o(pixel_first),
      .pixel_last_o(pixel_last),
      .pixel_area_i(pixel_area),
      .state_valid_i(state_valid && !state_idle),
      .state_i(state),
      .state_first_i(state_first),
      .state_last_i(state_last),
      .state_end_i(state_end),
      .ended_o(objects_ended),
      .overflow_o(objects_overflow),
      .alarm_o(object_alarm),
      .taught_o(taught),
      .taught_frames_o(taught_frames),
      .frame_pixels_o(frame_object),
      .frame_columns_o(frame_object_columns),
      .frame_rows_o(frame_object_rows),
      .frame_area_o(frame_object_area),
      .frame_blind_o(frame_blind),
      .frame_i(next_frame_q),
      .m_axis_objects_tdata(m_axis_objects_tdata),
      .m_axis_objects_tlast(m_axis_objects_tlast),
      .m_axis_objects_tvalid(m_axis_objects_tvalid),
      .m_axis_objects_tready(m_axis_objects_tready)
  );

  // ------------------------------------------------------------------------------------------------ outputs
  logic out_first, out_end, out_runs_end, unused_run;
  logic [1:0] output_overflow;
  logic rows_error;
  assign unused_run = ^{run_row, run_start};
  horopter_output #(
      .DEPTH(FAST ? 512 : 256),
      .IN_FLIGHT(IN_FLIGHT),
      .FAST(FAST),
      .ROW_BITS(ROW_BITS),
      .COLUMN_BITS(COLUMN_BITS),
      .WIDTH_BITS(RESULT_WIDTH_BITS),
      .HEIGHT_BITS(RESULT_HEIGHT_BITS)
  ) u_output (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .core_rst_ni(core_rst_n),
      .result_width_i(result_width),
      .result_height_i(result_height),
      .go_o(go),
      .overflow_o(output_overflow),
      .state_valid_i(state_valid && !state_idle),
      .state_i(state),
      .state_first_i(state_first),
      .state_last_i(state_last),
      .state_end_i(state_end),
      .run_valid_i(run_valid),
      .run_end_i(run_end),
      .run_state_i(run_state),
      .run_last_i(run_last),
      .m_axis_state_tdata(m_axis_state_tdata),
      .m_axis_state_tuser(m_axis_state_tuser),
      .m_axis_state_tlast(m_axis_state_tlast),
      .m_axis_state_tvalid(m_axis_state_tvalid),
      .m_axis_state_tready(m_axis_state_tready),
      .state_first_o(out_first),
      .state_end_o(out_end),
      .m_axis_runs_tdata(m_axis_runs_tdata),
      .m_axis_runs_tlast(m_axis_runs_tlast),
      .m_axis_runs_tvalid(m_axis_runs_tvalid),
      .m_axis_runs_tready(m_axis_runs_tready),
      .runs_end_o(out_runs_end),
      .rows_error_o(rows_error)
  );

  // ------------------------------------------------------------------------------------------------ status and faults
  horopter_status #(
      .MAX_LOOKAHEAD(MAX_LOOKAHEAD)
  ) u_status (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .enable_i(enable),
      .test_input_i(test_input),
      .width_i(width),
      .height_i(height),
      .lookahead_i(lookahead),
      .timeout_i(timeout),
      .changed_i(changed),
      .irq_enable_i(irq_enable),
      .irq_status_i(irq_status),
      .irq_set_o(irq_set),
      .irq_o(irq_o),
      .running_o(core_rst_n),
      .status_o(status),
      .faults_set_o(faults_set),
      .open_i(frame_open),
      .open_slot_i(open_slot),
      .interlock_i(interlock),
      .alarm_frames_i(alarm_frames),
      .restart_i(restart_i),
      .feedback_i(feedback_i),
      .feedback_clocks_i(feedback_clocks),
      .restart_valid_i(restart_valid),
      .restart_key_i(restart_key),
      .busy_i(frame_busy),
      .arrived_i(arrived),
      .health_end_i(health_end),
      .health_valid_i(health_valid),
      .left_health_i(left_health),
      .right_health_i(right_health),
      .left_signature_i(left_signature),
      .right_signature_i(right_signature),
      .judged_i(judged),
      .judged_slot_i(judged_slot),
      .one_camera_i(one_camera),
      .blind_i(blind),
      .still_i(still),
      .left_stream_i(left_stream),
      .right_stream_i(right_stream),
      .skew_i(skew),
      .silence_i(silence),
      .silent_i(silent),
      .bad_upload_i(bad_upload),
      .refused_upload_i(refused_upload),
      .begin_i(frame_begin),
      .active_i(frame_active),
      .whole_i(whole),
      .read_slot_i(read_slot),
      .table_ok_i(table_ok),
      .table_slot_i(active_slot_q),
      .table_crc_i(table_crc),
      .table_error_i(table_error),
      .beat_parity_error_i(beat_parity_error),
      .areas_error_i(areas_error),
      .stage_parity_error_i(stage_parity_error),
      .quad_valid_i(quad_valid),
      .quad_miss_i(quad_miss),
      .quad_parity_error_i(quad_parity_error),
      .left_mask_i(left_mask),
      .left_parity_error_i(left_parity_error),
      .output_overflow_i(output_overflow),
      .rows_error_i(rows_error),
      .place_error_i(places_differ || place_error != 2'b00),
      .state_first_i(out_first),
      .state_end_i(out_end),
      .runs_end_i(out_runs_end),
      .counts_valid_i(counts_valid),
      .skin_i(24'(skin_pixels)),
      .undecidable_i(24'(undecidable_pixels)),
      .unsupervised_i(24'(unsupervised_pixels)),
      .alarm_i(alarm),
      .objects_ended_i(objects_ended),
      .objects_overflow_i(objects_overflow),
      .object_alarm_i(object_alarm),
      .taught_i(taught),
      .teaching_i(sampled_blocks.teach),
      .forget_o(forget),
      .too_undecidable_i(too_undecidable || too_little_decided),
      .too_unsupervised_i(too_unsupervised),
      .verdict_valid_i(verdict_valid),
      .verdict_i(verdict),
      .publish_o(published),
      .frame_sequence_o(frame_sequence),
      .frame_status_o(frame_status),
      .frame_faults_o(frame_faults),
      .frame_table_crc_o(frame_table_crc),
      .frame_skin_o(frame_skin),
      .frame_undecidable_o(frame_undecidable),
      .frame_unsupervised_o(frame_unsupervised),
      .frame_misses_o(frame_misses),
      .frame_cycles_o(frame_cycles),
      .frame_latency_o(frame_latency),
      .frame_tail_o(frame_tail),
      .frame_done_o(frame_done_o),
      .heartbeat_o(heartbeat_o),
      .safe_o(safe_o),
      .unsafe_o(unsafe_o)
  );
endmodule
