// SPDX-License-Identifier: Apache-2.0
// Where each pixel of the result comes from: the raster generator, the control points that it reads, the places between
// them, and the rows' spans. Ports as those of horopter_raster and, for the beats, those of the stage `map_expand`.
//
// said_o: with SAYS, all of it in a word, two clocks later, 0 where it means nothing: two of these modules with the same
// inputs always say the same, unless a register of one of them was upset.
module horopter_places #(
    parameter bit COMPETE = horopter_profile_pkg::COMPETE,
    parameter bit FAST = 1'b0,
    parameter bit SAYS = 1'b0,
    parameter int unsigned IN_FLIGHT = 256,
    parameter int unsigned MAP_ADDR_BITS = 14,
    parameter int unsigned WEIGHT_BITS = horopter_profile_pkg::WEIGHT_BITS,
    parameter int unsigned SAID_BITS = 2 * MAP_ADDR_BITS + 2 * WEIGHT_BITS + 34
) (
    input  logic                     clk_i,
    input  logic                     rst_ni,
    input  logic [             11:0] width_i,
    input  logic [             11:0] height_i,
    input  logic [             11:0] lookahead_i,
    input  logic                     compete_i,
    input  logic                     go_i,
    // frame records
    input  logic [              1:0] busy_i,
    output logic                     slot_o,
    input  logic [             11:0] left_rows_i,
    input  logic                     left_ended_i,
    input  logic [             11:0] right_rows_i,
    input  logic                     right_ended_i,
    output logic                     begin_o,
    input  logic                     wait_i,
    output logic                     active_o,
    input  logic                     published_i,
    // map store
    output logic                     lookup_o,
    input  logic                     table_ok_i,
    input  logic [MAP_ADDR_BITS-1:0] table_base_i,
    input  logic [              2:0] table_nx_i,
    input  logic [              2:0] table_ny_i,
    input  logic [             11:0] table_columns_i,
    input  logic                     table_spans_i,
    output logic                     map_read_o,
    output logic [MAP_ADDR_BITS-1:0] map_even_addr_o,
    output logic [MAP_ADDR_BITS-1:0] map_odd_addr_o,
    input  logic [             31:0] map_even_i,
    input  logic [             31:0] map_odd_i,
    input  logic                     map_error_i,
    output logic                     map_parity_error_o,
    // pixels
    output logic                     valid_o,
    output logic [             10:0] x_o,
    output logic [             10:0] y_o,
    output logic [  WEIGHT_BITS-1:0] wx_o,
    output logic [  WEIGHT_BITS-1:0] wy_o,
    output logic                     mapped_o,
    output logic                     present_o,
    output logic                     first_o,
    output logic                     last_o,
    output logic                     live_o,
    output logic [    SAID_BITS-1:0] said_o
);
  logic beat_valid, beat_prime, beat_load, beat_first, beat_last, beat_live, beat_swapped, beat_parity_error;
  logic [31:0] beat_even, beat_odd;
  logic [5:0] beat_fraction;
  logic setup, row, raster_read, span_error, beat_outside;
  logic [MAP_ADDR_BITS-1:0] first_control, raster_even_addr, raster_odd_addr;
  assign map_parity_error_o = (beat_valid && beat_parity_error) || span_error;
  horopter_raster #(
      .WIDTH(horopter_profile_pkg::WIDTH),
      .HEIGHT(horopter_profile_pkg::HEIGHT),
      .FAST(FAST),
      .FLUSH_ROWS(horopter_profile_pkg::FLUSH_ROWS),
      .COMPETE_FLUSH_ROWS(COMPETE ? horopter_profile_pkg::COMPETE_FLUSH_ROWS : horopter_profile_pkg::FLUSH_ROWS),
      .IN_FLIGHT(IN_FLIGHT),
      .MAP_ADDR_BITS(MAP_ADDR_BITS)
  ) u_raster (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .width_i(width_i),
      .height_i(height_i),
      .lookahead_i(lookahead_i),
      .compete_i(compete_i),
      .go_i(go_i),
      .busy_i(busy_i),
      .slot_o(slot_o),
      .left_rows_i(left_rows_i),
      .left_ended_i(left_ended_i),
      .right_rows_i(right_rows_i),
      .right_ended_i(right_ended_i),
      .begin_o(begin_o),
      .wait_i(wait_i),
      .active_o(active_o),
      .published_i(published_i),
      .lookup_o(lookup_o),
      .table_ok_i(table_ok_i),
      .table_base_i(first_control),
      .table_nx_i(table_nx_i),
      .table_ny_i(table_ny_i),
      .table_columns_i(table_columns_i),
      .setup_o(setup),
      .row_o(row),
      .map_read_o(raster_read),
      .map_even_addr_o(raster_even_addr),
      .map_odd_addr_o(raster_odd_addr),
      .map_even_i(map_even_i),
      .map_odd_i(map_odd_i),
      .map_error_i(map_error_i),
      .valid_o(beat_valid),
      .prime_o(beat_prime),
      .load_o(beat_load),
      .even_o(beat_even),
      .odd_o(beat_odd),
      .swapped_o(beat_swapped),
      .row_fraction_o(beat_fraction),
      .first_o(beat_first),
      .last_o(beat_last),
      .live_o(beat_live),
      .map_parity_error_o(beat_parity_error)
  );
  horopter_row_span #(
      .ADDR_BITS(MAP_ADDR_BITS),
      .LATENCY(FAST ? 5 : 2)
  ) u_row_span (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .spans_i(table_spans_i),
      .table_ok_i(table_ok_i),
      .base_i(table_base_i),
      .height_i(height_i),
      .first_control_o(first_control),
      .setup_i(setup),
      .row_i(row),
      .read_i(raster_read),
      .even_addr_i(raster_even_addr),
      .odd_addr_i(raster_odd_addr),
      .read_o(map_read_o),
      .even_addr_o(map_even_addr_o),
      .odd_addr_o(map_odd_addr_o),
      .even_i(map_even_i),
      .odd_i(map_odd_i),
      .error_i(map_error_i),
      .valid_i(beat_valid),
      .last_i(beat_last),
      .outside_o(beat_outside),
      .error_o(span_error)
  );

  logic [15:0] even_x, even_y, odd_x, odd_y;
  logic even_exists, even_of_skin, odd_exists, odd_of_skin;
  horopter_control_point u_even_point (
      .word_i(beat_even),
      .x_o(even_x),
      .y_o(even_y),
      .exists_o(even_exists),
      .of_skin_o(even_of_skin)
  );
  horopter_control_point u_odd_point (
      .word_i(beat_odd),
      .x_o(odd_x),
      .y_o(odd_y),
      .exists_o(odd_exists),
      .of_skin_o(odd_of_skin)
  );
  // The table is there clocks before the first beat: what comes from far away takes one of them.
  logic [2:0] spacing_x_log2, nx_q;
  always_ff @(posedge clk_i) nx_q <= table_nx_i;
  assign spacing_x_log2 = FAST ? nx_q : table_nx_i;
  horopter_map_expand u_map_expand (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .en_i(1'b1),
      .valid_i(beat_valid),
      .prime_i(beat_prime),
      .load_i(beat_load),
      .column_top_x_i(even_x),
      .column_top_y_i(even_y),
      .column_top_exists_i(even_exists),
      .column_top_of_skin_i(even_of_skin),
      .column_bottom_x_i(odd_x),
      .column_bottom_y_i(odd_y),
      .column_bottom_exists_i(odd_exists),
      .column_bottom_of_skin_i(odd_of_skin),
      .column_swapped_i(beat_swapped),
      .row_fraction_i(beat_fraction),
      .outside_i(beat_outside),
      .marks_first_i(beat_first),
      .marks_last_i(beat_last),
      .marks_live_i(beat_live),
      .cfg_spacing_x_log2_i(spacing_x_log2),
      .valid_o(valid_o),
      .x_o(x_o),
      .y_o(y_o),
      .wx_o(wx_o),
      .wy_o(wy_o),
      .mapped_o(mapped_o),
      .present_o(present_o),
      .marks_first_o(first_o),
      .marks_last_o(last_o),
      .marks_live_o(live_o)
  );

  if (SAYS) begin : g_says
    logic read_q, valid_q, place_valid_q;
    logic [2*MAP_ADDR_BITS-1:0] addr_q;
    logic [4:0] place_marks_q;
    logic [21+2*WEIGHT_BITS:0] place_q;
    logic [3:0] frame_q;
    always_ff @(posedge clk_i) begin
      read_q <= rst_ni && map_read_o;
      valid_q <= rst_ni && beat_valid;
      place_valid_q <= rst_ni && valid_o;
      frame_q <= {begin_o, lookup_o, active_o, slot_o};
      addr_q <= {map_even_addr_o, map_odd_addr_o};
      place_marks_q <= {mapped_o, present_o, first_o, last_o, live_o};
      place_q <= {x_o, y_o, wx_o, wy_o};
      said_o <= {read_q, valid_q, place_valid_q, frame_q, read_q ? addr_q : '0, place_valid_q ? {place_marks_q, place_q} : '0};
    end
  end else begin : g_mute
    assign said_o = '0;
  end
endmodule
