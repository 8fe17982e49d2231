// SPDX-License-Identifier: Apache-2.0
// The objects of a frame on their way out, in the order in which they end, and a last beat that says how many there were.
// Format of m_axis_objects as in horopter_top. A reader that is too slow loses objects, and is told how many; nothing waits
// for it.
//
// object_*: with object_valid_i an object. end_i: one clock, after the frame's last object; frame_i is its number. The last
// beat waits until there is room, and until then objects of the next frame are lost. Where that one ends before, none of it
// is sent, its last beat neither: the numbers tell.
// core_rst_ni: of the streaming core; it drops what waits, but a beat that is offered stays until it is taken.
module horopter_object_stream #(
    parameter int unsigned COUNT_BITS = 18,
    parameter int unsigned COLUMN_BITS = 9,
    parameter int unsigned ROW_BITS = 9
) (
    input  logic                              clk_i,
    input  logic                              rst_ni,
    input  logic                              core_rst_ni,
    input  logic                              object_valid_i,
    input  logic [            COUNT_BITS-1:0] object_pixels_i,
    input  logic [            COUNT_BITS-1:0] object_blind_i,
    input  logic [                      31:0] object_area_i,
    input  logic [           COLUMN_BITS-1:0] object_left_i,
    input  logic [           COLUMN_BITS-1:0] object_right_i,
    input  logic [              ROW_BITS-1:0] object_top_i,
    input  logic [              ROW_BITS-1:0] object_bottom_i,
    input  logic [COUNT_BITS+COLUMN_BITS-1:0] object_columns_i,
    input  logic [   COUNT_BITS+ROW_BITS-1:0] object_rows_i,
    input  logic                              end_i,
    input  logic [                      31:0] frame_i,
    output logic [                     207:0] m_axis_objects_tdata,
    output logic                              m_axis_objects_tlast,
    output logic                              m_axis_objects_tvalid,
    input  logic                              m_axis_objects_tready
);
  if (COUNT_BITS > 24 || COLUMN_BITS > 16 || ROW_BITS > 16 || COUNT_BITS + COLUMN_BITS > 32 || COUNT_BITS + ROW_BITS > 32)
  begin : g_illegal
    $fatal(1, "horopter_object_stream: an object does not fit its beat");
  end
  localparam int unsigned WIDTH = 1 + 4 * COUNT_BITS + 32 + 3 * COLUMN_BITS + 3 * ROW_BITS;
  localparam int unsigned PLACE_BITS = 2 * COUNT_BITS + 3 * COLUMN_BITS + 3 * ROW_BITS;

  // --- counting; the last beat has its numbers where objects have pixels, blind pixels and area ---
  logic closing_q, room, write;
  logic [COUNT_BITS-1:0] objects_q, lost_q, closing_objects_q, closing_lost_q;
  logic [31:0] closing_frame_q;
  logic [WIDTH-1:0] written;
  assign write = closing_q || object_valid_i;
  assign written = closing_q ? {1'b1, {PLACE_BITS{1'b0}}, closing_frame_q, closing_lost_q, closing_objects_q}
      : {1'b0, object_rows_i, object_columns_i, object_bottom_i, object_top_i, object_right_i, object_left_i,
         object_area_i, object_blind_i, object_pixels_i};
  always_ff @(posedge clk_i) begin
    if (!core_rst_ni) begin
      closing_q <= 1'b0;
      objects_q <= '0;
      lost_q <= '0;
    end else begin
      if (end_i) closing_q <= 1'b1;
      else if (room) closing_q <= 1'b0;
      if (end_i) begin
        objects_q <= '0;
        lost_q <= '0;
      end else if (object_valid_i) begin
        objects_q <= objects_q + 1'b1;
        if (closing_q || !room) lost_q <= lost_q + 1'b1;
      end
    end
    if (end_i && (!closing_q || room)) begin
      closing_objects_q <= objects_q;
      closing_lost_q <= lost_q;
      closing_frame_q <= frame_i;
    end
  end

  // --- out ---
  logic valid, ready, unused_full, unused_overflow;
  logic [WIDTH-1:0] waiting, sent;
  horopter_axis_fifo #(
      .WIDTH(WIDTH),
      .DEPTH(16)
  ) u_fifo (
      .clk_i(clk_i),
      .rst_ni(rst_ni && core_rst_ni),
      .s_valid_i(write),
      .s_ready_o(room),
      .s_data_i(written),
      .m_valid_o(valid),
      .m_ready_i(ready),
      .m_data_o(waiting),
      .almost_full_o(unused_full),
      .overflow_o(unused_overflow)
  );
  horopter_axis_hold #(
      .WIDTH(WIDTH)
  ) u_hold (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .drop_i(!core_rst_ni),
      .s_valid_i(valid),
      .s_ready_o(ready),
      .s_data_i(waiting),
      .m_valid_o(m_axis_objects_tvalid),
      .m_ready_i(m_axis_objects_tready),
      .m_data_o(sent)
  );
  logic [COUNT_BITS-1:0] pixels, blind;
  logic [COLUMN_BITS-1:0] left, right;
  logic [ROW_BITS-1:0] top, bottom;
  logic [COUNT_BITS+COLUMN_BITS-1:0] columns;
  logic [COUNT_BITS+ROW_BITS-1:0] rows;
  logic [31:0] area;
  assign {m_axis_objects_tlast, rows, columns, bottom, top, right, left, area, blind, pixels} = sent;
  assign m_axis_objects_tdata = {
      32'(rows), 32'(columns), 16'(bottom), 16'(top), 16'(right), 16'(left), area, 24'(blind), 24'(pixels)};
endmodule
