// SPDX-License-Identifier: Apache-2.0
// Objects of a frame: the stages `blind` and `objects` on the states as they leave the chain. After the frame's last state
// each gets idle beats, one a clock, until everything has been said. A frame of which nothing can be blind does not wait for
// `blind`, from which pixels come some rows later.
//
// pixel_*_o: the pixels for which `objects` needs the code of an area, pixel_area_i, AREA_LATENCY clocks later.
//
// ended_o: one clock, everything of the frame has been said; overflow_o comes with it. alarm_o: an object of the frame so far,
// or of the last one until the next begins, has reached the limit. taught_o: at least one frame was taught. frame_*: of the
// largest object, 0 without one, and the number of blind pixels, from three clocks after ended_o on. m_axis_objects: as in horopter_top, by
// bus_rst_ni a beat that is offered stays. frame_i: the number of the frame. rst_ni: of the streaming core.
module horopter_object_check #(
    parameter bit BLIND = 1'b1,
    parameter int unsigned AREA_LATENCY = 3,
    parameter int unsigned COLUMNS = horopter_profile_pkg::WIDTH / horopter_profile_pkg::SUBSAMPLE,
    parameter int unsigned ROWS = horopter_profile_pkg::HEIGHT,
    parameter int unsigned COUNT_BITS = $clog2(COLUMNS * ROWS + 1)
) (
    input  logic                                  clk_i,
    input  logic                                  rst_ni,
    input  logic                                  bus_rst_ni,
    input  logic [              COUNT_BITS-1:0]   object_limit_i,
    input  logic [                        31:0]   object_area_limit_i,  // 1/1024 mm²
    input  logic [    $clog2(COLUMNS + 1)-1:0]    width_i,
    input  logic [       $clog2(ROWS + 1)-1:0]    height_i,
    input  horopter_csr_pkg::blocks_t             blocks_i,
    input  logic                                  begin_i,  // a frame; of the one before it nothing is an alarm any more
    input  logic                                  forget_i,  // what was taught; before a frame begins
    input  logic                                  compete_i,  // the frame's rule: what another has taught is forgotten
    output logic                                  pixel_valid_o,
    output logic                                  pixel_first_o,
    output logic                                  pixel_last_o,
    input  logic [                         7:0]   pixel_area_i,
    input  logic                                  state_valid_i,
    input  logic [                         1:0]   state_i,
    input  logic                                  state_first_i,
    input  logic                                  state_last_i,
    input  logic                                  state_end_i,
    output logic                                  ended_o,
    output logic                                  overflow_o,
    output logic                                  alarm_o,
    output logic                                  taught_o,
    output logic [                        15:0]   taught_frames_o,
    output logic [                        23:0]   frame_pixels_o,
    output horopter_csr_pkg::frame_object_columns_t frame_columns_o,
    output horopter_csr_pkg::frame_object_rows_t  frame_rows_o,
    output logic [                        31:0]   frame_area_o,
    output logic [                        23:0]   frame_blind_o,
    input  logic [                        31:0]   frame_i,
    output logic [                       207:0]   m_axis_objects_tdata,
    output logic                                  m_axis_objects_tlast,
    output logic                                  m_axis_objects_tvalid,
    input  logic                                  m_axis_objects_tready
);
  // Pixels leave it some rows after they came: the idle beats of `objects` begin when it is done.
  logic forget, compete_before_q;
  assign forget = forget_i || compete_i != compete_before_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) compete_before_q <= 1'b0;
    else if (BLIND && state_valid_i && state_first_i) compete_before_q <= compete_i;
  end
  logic blind_idle_q, blind_valid, there, blind, pixel_first, pixel_last, blind_done, taught;
  logic [1:0] pixel_state;
  if (BLIND) begin : g_blind
    horopter_blind u_blind (
        .clk_i(clk_i),
        .rst_ni(rst_ni),
        .en_i(1'b1),
        .valid_i(state_valid_i || blind_idle_q),
        .state_i(state_i),
        .first_i(state_first_i),
        .last_i(state_last_i),
        .idle_i(blind_idle_q),
        .cfg_width_i(width_i),
        .cfg_height_i(height_i),
        .cfg_watch_i(blocks_i.watch),
        .cfg_teach_i(blocks_i.teach),
        .cfg_forget_i(forget),
        .cfg_blind_margin_i(blocks_i.margin),
        .valid_o(blind_valid),
        .there_o(there),
        .state_o(pixel_state),
        .blind_o(blind),
        .first_o(pixel_first),
        .last_o(pixel_last),
        .done_o(blind_done),
        .taught_o(taught)
    );
    logic unused_dim;  // what is dimmed comes before
    assign unused_dim = blocks_i.dim;
  end else begin : g_no_blind
    assign {blind_valid, there, pixel_state, blind, pixel_first, pixel_last, blind_done, taught} = '0;
    logic unused_blind;
    assign unused_blind = ^{width_i, height_i, blocks_i, forget, blind_idle_q};
  end
  logic looks_q, pixel_valid;
  always_ff @(posedge clk_i) looks_q <= BLIND && (blocks_i.watch || blocks_i.teach);  // all through the frame
  assign pixel_valid = blind_valid && there && looks_q;
  logic [COUNT_BITS-1:0] blind_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) blind_idle_q <= 1'b0;
    else if (state_valid_i) blind_idle_q <= state_end_i && looks_q;
    else if (blind_valid && blind_done) blind_idle_q <= 1'b0;
    if (!rst_ni) taught_o <= 1'b0;
    else if (blind_valid) taught_o <= taught;
    if (!looks_q) blind_q <= '0;
    else if (pixel_valid) blind_q <= (pixel_first ? '0 : blind_q) + COUNT_BITS'(blind);
  end

  logic taught_before_q;  // by the frame before this one
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      taught_before_q <= 1'b0;
      taught_frames_o <= 16'd0;
    end else if (BLIND && state_valid_i && state_first_i) begin
      taught_before_q <= blocks_i.teach;
      if (forget || (blocks_i.teach && !taught_before_q)) taught_frames_o <= 16'd0;
      else if (taught_before_q && taught_frames_o != 16'hFFFF) taught_frames_o <= taught_frames_o + 16'd1;
    end
  end

  logic idle_q;  // the frame has ended
  logic valid, object_ended, alarm, overflow, done;
  logic [COUNT_BITS-1:0] pixels, blind_pixels, largest_q;
  logic [31:0] area, area_q;
  localparam int unsigned COLUMN_BITS = $clog2(COLUMNS);
  localparam int unsigned ROW_BITS = $clog2(ROWS);
  logic [COLUMN_BITS-1:0] left, right, left_q, right_q;
  logic [ROW_BITS-1:0] top, bottom, top_q, bottom_q;
  logic [COUNT_BITS+COLUMN_BITS-1:0] columns;
  logic [COUNT_BITS+ROW_BITS-1:0] rows;
  assign pixel_valid_o = looks_q ? pixel_valid : state_valid_i;
  assign pixel_first_o = looks_q ? pixel_first : state_first_i;
  assign pixel_last_o = looks_q ? pixel_last : state_last_i;
  // They wait until their areas are there, the oldest in the highest bits.
  localparam int unsigned BEAT = 6;
  logic occupied, late_valid, late_occupied, late_first, late_last, late_idle, late_blind;
  logic [AREA_LATENCY*BEAT-1:0] waiting_q;
  assign occupied = looks_q ? blind || pixel_state == 2'd1 : state_i == 2'd1;
  assign {late_valid, late_occupied, late_first, late_last, late_idle, late_blind} = waiting_q[AREA_LATENCY*BEAT-1-:BEAT];
  always_ff @(posedge clk_i) begin
    waiting_q <= {waiting_q[(AREA_LATENCY-1)*BEAT-1:0],
                  rst_ni && (pixel_valid_o || idle_q), occupied, pixel_first_o, pixel_last_o, idle_q, looks_q && blind};
  end
  horopter_objects u_objects (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .en_i(1'b1),
      .valid_i(late_valid),
      .occupied_i(late_occupied),
      .first_i(late_first),
      .last_i(late_last),
      .idle_i(late_idle),
      .area_i(pixel_area_i),
      .blind_i(late_blind),
      .cfg_object_limit_i(object_limit_i),
      .cfg_object_area_limit_i(object_area_limit_i),
      .valid_o(valid),
      .ended_o(object_ended),
      .object_pixels_o(pixels),
      .object_blind_o(blind_pixels),
      .object_area_o(area),
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
  // The largest, two clocks later than the object and the end: its comparison is long. Objects are at least 4 clocks apart.
  logic object_q, larger_q;
  logic [1:0] last_q;
  logic [COUNT_BITS-1:0] object_pixels_q;
  logic [31:0] object_area_q;
  logic [COLUMN_BITS-1:0] object_left_q, object_right_q;
  logic [ROW_BITS-1:0] object_top_q, object_bottom_q;
  logic none_q;  // largest_q is 0
  always_ff @(posedge clk_i) begin
    object_q <= rst_ni && valid && object_ended;
    larger_q <= rst_ni && object_q && object_pixels_q > largest_q;
    last_q <= rst_ni ? {last_q[0], ended_o} : 2'b00;
    if (valid && object_ended) begin
      object_pixels_q <= pixels;
      object_area_q <= area;
      {object_left_q, object_right_q, object_top_q, object_bottom_q} <= {left, right, top, bottom};
    end
  end
  always_ff @(posedge clk_i) begin
    ended_o <= rst_ni && valid && done && waits_q && !ended_o;
    if (valid) overflow_o <= overflow;
    alarm_o <= rst_ni && (valid ? alarm : alarm_o && !begin_i);
    if (!rst_ni) idle_q <= 1'b0;
    else idle_q <= (looks_q ? blind_valid && blind_done && blind_idle_q && !idle_q : state_valid_i && state_end_i) || (idle_q && !(valid && done));
    if (!rst_ni || ended_o) waits_q <= 1'b0;
    else if (state_valid_i && state_end_i) waits_q <= 1'b1;
    if (!rst_ni || last_q[1]) begin
      largest_q <= '0;
      none_q <= 1'b1;
    end else if (larger_q) begin
      largest_q <= object_pixels_q;
      none_q <= 1'b0;
      area_q <= object_area_q;
      {left_q, right_q, top_q, bottom_q} <= {object_left_q, object_right_q, object_top_q, object_bottom_q};
    end
    if (!rst_ni) begin
      frame_pixels_o <= 24'd0;
      frame_columns_o <= '0;
      frame_rows_o <= '0;
      frame_area_o <= 32'd0;
      frame_blind_o <= 24'd0;
    end else if (last_q[1]) begin
      frame_pixels_o <= 24'(largest_q);
      frame_area_o <= none_q ? 32'd0 : area_q;
      frame_blind_o <= 24'(blind_q);
      frame_columns_o.left <= none_q ? 12'd0 : 12'(left_q);
      frame_columns_o.right <= none_q ? 12'd0 : 12'(right_q);
      frame_rows_o.top <= none_q ? 12'd0 : 12'(top_q);
      frame_rows_o.bottom <= none_q ? 12'd0 : 12'(bottom_q);
    end
  end

  horopter_object_stream #(
      .COUNT_BITS(COUNT_BITS),
      .COLUMN_BITS(COLUMN_BITS),
      .ROW_BITS(ROW_BITS)
  ) u_stream (
      .clk_i(clk_i),
      .rst_ni(bus_rst_ni),
      .core_rst_ni(rst_ni),
      .object_valid_i(valid && object_ended),
      .object_pixels_i(pixels),
      .object_blind_i(blind_pixels),
      .object_area_i(area),
      .object_left_i(left),
      .object_right_i(right),
      .object_top_i(top),
      .object_bottom_i(bottom),
      .object_columns_i(columns),
      .object_rows_i(rows),
      .end_i(ended_o),
      .frame_i(frame_i),
      .m_axis_objects_tdata(m_axis_objects_tdata),
      .m_axis_objects_tlast(m_axis_objects_tlast),
      .m_axis_objects_tvalid(m_axis_objects_tvalid),
      .m_axis_objects_tready(m_axis_objects_tready)
  );
endmodule
