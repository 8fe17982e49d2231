// SPDX-License-Identifier: Apache-2.0
// One camera's way in: its pixels, or those of the test frames, through a FIFO to well-formed rows (horopter_framer), and
// the check of its images (stage `health`), and their reduction for the check of both (stage `cells`).
//
// The two cameras may be DEPTH pixels apart. A test frame takes the place of both images, so a pixel of it is taken when
// both inputs have room. live_i: pixels come whether there is room or not, and one without is an overflow.
// stream_o: one clock each, faults of the frame that is open. health_valid_o: the check of a whole image, whose last pixel
// went in with health_end_o; signature_o, of the image checked last, stays. rst_ni: of the streaming core.
module horopter_camera_input #(
    parameter int unsigned SLOTS = 64,  // rows of the image's ring
    parameter bit FAST = 1'b0,
    parameter int unsigned SLOT_BITS = $clog2(SLOTS),
    parameter int unsigned PIXEL_BITS = $clog2(horopter_profile_pkg::WIDTH * horopter_profile_pkg::HEIGHT + 1)
) (
    input  logic                             clk_i,
    input  logic                             rst_ni,
    // configuration
    input  logic                             live_i,
    input  logic                             test_input_i,
    input  logic [                     11:0] width_i,
    input  logic [                     11:0] height_i,
    input  logic [                     31:0] timeout_i,
    // of the image check, sampled for a frame
    input  logic [                      7:0] black_level_i,
    input  logic [                      7:0] white_level_i,
    input  logic [           PIXEL_BITS-1:0] black_limit_i,
    input  logic [           PIXEL_BITS-1:0] white_limit_i,
    input  logic [                      7:0] constant_limit_i,
    input  logic [                      7:0] frozen_limit_i,
    // camera
    input  logic [                      7:0] s_axis_tdata,
    input  logic                             s_axis_tuser,
    input  logic                             s_axis_tlast,
    input  logic                             s_axis_tvalid,
    output logic                             s_axis_tready,
    // this camera's part of the test frames
    input  logic [                      7:0] test_data_i,
    input  logic                             test_first_i,
    input  logic                             test_last_i,
    input  logic                             test_valid_i,
    output logic                             room_o,
    input  logic                             other_room_i,
    // pairing, see horopter_framer
    output logic                             start_o,
    output logic                             empty_o,
    output logic                             urgent_o,
    input  logic                             grant_i,
    input  logic                             deny_i,
    input  logic                             cut_i,
    input  logic                             patience_i,
    output logic                             near_o,
    output logic                             far_o,
    output logic                             deep_o,
    output logic                             silent_o,
    output logic                             gone_o,
    output logic                             frame_done_o,
    input  logic                             lost_silent_i,  // the frame that it does not deliver
    // store, see horopter_framer
    input  logic [              SLOT_BITS:0] keep_i,
    output logic [              SLOT_BITS:0] stored_o,
    output logic [            SLOT_BITS-1:0] slot_o,
    output logic                             write_en_o,
    output logic [            SLOT_BITS-1:0] write_slot_o,
    output logic [                     11:0] write_x_o,
    output logic [                      7:0] write_pixel_o,
    output logic                             row_done_o,
    output logic                             row_bad_o,
    // faults
    output logic                             silence_o,  // one clock: silent_o begins
    output horopter_csr_pkg::stream_faults_t stream_o,
    output logic                             health_end_o,
    output logic                             health_valid_o,
    output horopter_csr_pkg::health_t        health_o,
    output logic [                     31:0] signature_o,
    // the means of its cells
    output logic                             cell_valid_o,
    output logic [                      7:0] cell_mean_o,
    output logic                             cell_start_o
);
  localparam int unsigned DEPTH = 64;
  localparam int unsigned LEVEL = 48;

  logic live_q, test_input_q;  // their registers lie far away
  always_ff @(posedge clk_i) {live_q, test_input_q} <= {live_i, test_input_i};

  logic in_valid, in_first, in_last, full_overflow, almost_full;
  logic [7:0] in_pixel;
  assign s_axis_tready = live_q || (rst_ni && !test_input_q && room_o);
  assign in_valid = test_input_q ? test_valid_i && (live_q || other_room_i) : s_axis_tvalid;
  assign in_first = test_input_q ? test_first_i : s_axis_tuser;
  assign in_last = test_input_q ? test_last_i : s_axis_tlast;
  assign in_pixel = test_input_q ? test_data_i : s_axis_tdata;

  logic queue_valid, queue_ready, head_valid, head_ready;
  logic [9:0] queue_data, head_data;
  horopter_axis_fifo #(
      .WIDTH(10),
      .DEPTH(DEPTH),
      .ALMOST_FULL(LEVEL)
  ) u_fifo (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .s_valid_i(in_valid),
      .s_ready_o(room_o),
      .s_data_i({in_first, in_last, in_pixel}),
      .m_valid_o(queue_valid),
      .m_ready_i(queue_ready),
      .m_data_o(queue_data),
      .almost_full_o(almost_full),
      .overflow_o(full_overflow)
  );
  if (FAST) begin : g_head  // a framer says late what it takes
    horopter_axis_skid #(
        .WIDTH(10)
    ) u_skid (
        .clk_i(clk_i),
        .rst_ni(rst_ni),
        .s_valid_i(queue_valid),
        .s_ready_o(queue_ready),
        .s_data_i(queue_data),
        .m_valid_o(head_valid),
        .m_ready_i(head_ready),
        .m_data_o(head_data)
    );
  end else begin : g_head
    assign head_valid = queue_valid;
    assign queue_ready = head_ready;
    assign head_data = queue_data;
  end

  logic write_first, write_end, overflow, lost_silent;
  horopter_framer #(
      .SLOTS(SLOTS)
  ) u_framer (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .live_i(live_q),
      .width_i(width_i),
      .height_i(height_i),
      .timeout_i(timeout_i),
      .s_valid_i(head_valid),
      .s_ready_o(head_ready),
      .s_pixel_i(head_data[7:0]),
      .s_first_i(head_data[9]),
      .s_last_i(head_data[8]),
      .almost_full_i(almost_full),
      .start_o(start_o),
      .empty_o(empty_o),
      .urgent_o(urgent_o),
      .grant_i(grant_i),
      .deny_i(deny_i),
      .cut_i(cut_i),
      .patience_i(patience_i),
      .near_o(near_o),
      .far_o(far_o),
      .deep_o(deep_o),
      .silent_o(silent_o),
      .gone_o(gone_o),
      .keep_i(keep_i),
      .stored_o(stored_o),
      .slot_o(slot_o),
      .write_en_o(write_en_o),
      .write_slot_o(write_slot_o),
      .write_x_o(write_x_o),
      .write_pixel_o(write_pixel_o),
      .write_first_o(write_first),
      .write_end_o(write_end),
      .row_done_o(row_done_o),
      .row_bad_o(row_bad_o),
      .frame_done_o(frame_done_o),
      .short_line_o(stream_o.short_line),
      .long_line_o(stream_o.long_line),
      .missing_line_o(stream_o.missing_line),
      .missing_start_o(stream_o.missing_start),
      .overflow_o(overflow),
      .lost_silent_o(lost_silent),
      .silence_o(silence_o)
  );
  assign stream_o.silent = lost_silent || lost_silent_i;
  // Only a live camera can lose a pixel at the FIFO: without, a full one makes it wait.
  assign stream_o.overflow = overflow || (full_overflow && live_q);

  assign health_end_o = write_en_o && write_end;
  horopter_health u_health (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .en_i(1'b1),
      .valid_i(write_en_o),
      .pixel_i(write_pixel_o),
      .first_i(write_first),
      .end_v_i(write_end),
      .last_i(row_done_o),
      .cfg_dark_level_i(black_level_i),
      .cfg_bright_level_i(white_level_i),
      .cfg_dark_limit_i(black_limit_i),
      .cfg_bright_limit_i(white_limit_i),
      .cfg_contrast_limit_i(constant_limit_i),
      .cfg_frozen_limit_i(frozen_limit_i),
      .valid_o(health_valid_o),
      .black_o(health_o.image.black),
      .white_o(health_o.image.white),
      .constant_o(health_o.image.constant),
      .frozen_o(health_o.image.frozen),
      .torn_o(health_o.torn),
      .signature_o(signature_o)
  );

  horopter_cells u_cells (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .en_i(1'b1),
      .valid_i(write_en_o),
      .pixel_i(write_pixel_o),
      .first_i(write_first),
      .last_i(row_done_o),
      .valid_o(cell_valid_o),
      .mean_o(cell_mean_o),
      .start_o(cell_start_o)
  );
endmodule
