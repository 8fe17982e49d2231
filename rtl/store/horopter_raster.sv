// SPDX-License-Identifier: Apache-2.0
// Raster generator: makes the beats of an output frame, and the addresses of the control points that they need.
//
// Per frame: height + FLUSH_ROWS rows, each a prime beat and `width` pixel beats; flush rows are not live. Row y of the
// frame starts when right row min(y + lookahead, height - 1) and left row y are there, or will never come: so the last
// rows come by themselves, at one beat a clock, whatever the cameras do. A beat is issued only while go_i: the outputs
// must be able to take IN_FLIGHT beats more. A frame starts when the one before is published and IN_FLIGHT clocks have
// passed since its last beat, so that frames never share the pipeline.
//
// setup_o, row_o: as horopter_row_span takes them; nothing is read then.
// begin_o: one clock, settings and table may change now; at least 8 clocks before the first beat, which waits for wait_i to
// fall, too: it must be up before these are over.
// The control points of a beat come 2 clocks after their addresses. FAST: the beats are registers, and leave a clock later;
// FAST = 0 computes where it can what FAST keeps in registers.
module horopter_raster #(
    parameter int unsigned WIDTH = 640,
    parameter int unsigned HEIGHT = 480,
    parameter bit FAST = 1'b0,
    parameter int unsigned FLUSH_ROWS = 10,
    parameter int unsigned COMPETE_FLUSH_ROWS = 10,  // with compete_i
    parameter int unsigned IN_FLIGHT = 256,
    parameter int unsigned MAP_ADDR_BITS = 14
) (
    input  logic                     clk_i,
    input  logic                     rst_ni,
    input  logic [             11:0] width_i,
    input  logic [             11:0] height_i,
    input  logic [             11:0] lookahead_i,
    input  logic                     compete_i,  // constant from the clock after begin_o to the next
    input  logic                     go_i,  // FAST: counts from the next clock on
    // frame records
    input  logic [              1:0] busy_i,
    output logic                     slot_o,  // record of the frame being output, or of the next one
    input  logic [             11:0] left_rows_i,
    input  logic                     left_ended_i,
    input  logic [             11:0] right_rows_i,
    input  logic                     right_ended_i,
    output logic                     begin_o,
    input  logic                     wait_i,
    output logic                     active_o,  // from begin_o until published
    input  logic                     published_i,
    // map store
    output logic                     lookup_o,
    input  logic                     table_ok_i,
    input  logic [MAP_ADDR_BITS-1:0] table_base_i,
    input  logic [              2:0] table_nx_i,
    input  logic [              2:0] table_ny_i,
    input  logic [             11:0] table_columns_i,
    output logic                     setup_o,
    output logic                     row_o,
    output logic                     map_read_o,
    output logic [MAP_ADDR_BITS-1:0] map_even_addr_o,
    output logic [MAP_ADDR_BITS-1:0] map_odd_addr_o,
    input  logic [             31:0] map_even_i,
    input  logic [             31:0] map_odd_i,
    input  logic                     map_error_i,
    // beats
    output logic                     valid_o,
    output logic                     prime_o,
    output logic                     load_o,
    output logic [             31:0] even_o,
    output logic [             31:0] odd_o,
    output logic                     swapped_o,  // the odd one is above
    output logic [              5:0] row_fraction_o,
    output logic                     first_o,
    output logic                     last_o,
    output logic                     live_o,
    output logic                     map_parity_error_o
);
  if (FLUSH_ROWS == 0 || FLUSH_ROWS > 64 || COMPETE_FLUSH_ROWS < FLUSH_ROWS || COMPETE_FLUSH_ROWS > 64 || IN_FLIGHT < 16 || IN_FLIGHT > 4096) begin : g_illegal
    $fatal(1, "horopter_raster: FLUSH_ROWS must be 1 to 64, COMPETE_FLUSH_ROWS FLUSH_ROWS to 64, IN_FLIGHT 16 to 4096");
  end

  typedef enum logic [2:0] {
    IDLE,
    SETUP,
    WAIT_ROW,
    PRIME,
    PIXELS,
    DRAIN,
    WAIT_PUBLISHED
  } state_e;
  state_e state_q;

  localparam int unsigned X_BITS = $clog2(WIDTH);
  localparam int unsigned ROW_BITS = $clog2(HEIGHT + COMPETE_FLUSH_ROWS);
  localparam int unsigned COUNT_BITS = $clog2(IN_FLIGHT + 1);

  logic [X_BITS-1:0] x_q;
  logic [ROW_BITS-1:0] y_q;
  logic [COUNT_BITS-1:0] count_q;
  logic live_q, first_q, slot_q, busy_q, ready_q, active_q, published_q;
  logic ready;  // the row in progress is there
  logic loads;  // this pixel loads the next column of control points
  logic [ROW_BITS-1:0] flush_rows;
  assign flush_rows = compete_i ? ROW_BITS'(COMPETE_FLUSH_ROWS) : ROW_BITS'(FLUSH_ROWS);
  logic last_x, last_y, flushed;  // x_q, y_q are the last of the image, y_q is that of the flush rows

  // What go_i comes from lies far away on a fast chip.
  logic go, go_q;
  always_ff @(posedge clk_i) go_q <= go_i;
  assign go = FAST ? go_q : go_i;

  // Stage 0 of the beat.
  logic issue_prime, issue_pixel;
  assign issue_prime = state_q == PRIME && go;
  assign issue_pixel = state_q == PIXELS && go;
  assign setup_o = state_q == SETUP;
  assign row_o = state_q == WAIT_ROW && 32'(count_q) == 1 && live_q;
  assign map_read_o = issue_prime || (issue_pixel && loads);
  // Some clocks behind, but rows only ever arrive. Before a frame begins, y_q is 0.
  always_ff @(posedge clk_i) {busy_q, ready_q} <= {busy_i[slot_q], ready};

  always_ff @(posedge clk_i) begin
    begin_o <= 1'b0;
    lookup_o <= 1'b0;
    if (!rst_ni) begin
      state_q <= IDLE;
      slot_q <= 1'b0;
      active_q <= 1'b0;
      published_q <= 1'b0;
      live_q <= 1'b1;
      count_q <= '0;
    end else begin
      if (published_i) begin
        active_q <= 1'b0;
        published_q <= 1'b1;
      end
      case (state_q)
        // A few clocks for the record's registers to follow slot_q and y_q.
        IDLE: begin
          if (!count_q[3]) begin
            count_q <= count_q + 1'b1;
          end else if (busy_q && ready_q) begin
            begin_o <= 1'b1;
            lookup_o <= 1'b1;
            active_q <= 1'b1;
            published_q <= 1'b0;
            count_q <= '0;
            state_q <= SETUP;
          end
        end

        SETUP: begin
          first_q <= 1'b1;
          if (!count_q[3]) begin
            count_q <= count_q + 1'b1;
          end else if (!wait_i) begin
            count_q <= '0;
            state_q <= WAIT_ROW;
          end
        end

        WAIT_ROW: begin
          x_q <= '0;
          // Clocks for ready_q to follow y_q.
          if (32'(count_q) != (FAST ? 3 : 2)) begin
            count_q <= count_q + 1'b1;
          end else if (ready_q) begin
            count_q <= '0;
            state_q <= PRIME;
          end
        end

        PRIME: if (go) state_q <= PIXELS;

        PIXELS:
        if (go) begin
          x_q <= x_q + 1'b1;
          first_q <= 1'b0;
          if (last_x) begin
            state_q <= WAIT_ROW;
            if (last_y) live_q <= 1'b0;
            if (!live_q && flushed) begin
              state_q <= DRAIN;
              live_q <= 1'b1;
            end
          end
        end

        DRAIN: begin
          count_q <= count_q + 1'b1;
          if (32'(count_q) == IN_FLIGHT) state_q <= WAIT_PUBLISHED;
        end

        default:  // WAIT_PUBLISHED
        if (published_q) begin
          slot_q <= !slot_q;
          count_q <= '0;
          state_q <= IDLE;
        end
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni || (issue_pixel && last_x && !live_q && flushed)) y_q <= '0;
    else if (issue_pixel && last_x) y_q <= y_q + 1'b1;
  end

  // The beat waits for the control points, as long as the map store takes.
  localparam int unsigned READ = FAST ? 5 : 2;
  logic [READ:1] valid_q, prime_q, load_q, beat_first_q, beat_last_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[READ-1:1], issue_prime || issue_pixel};
    prime_q <= {prime_q[READ-1:1], issue_prime};
    load_q <= {load_q[READ-1:1], issue_pixel && loads};
    beat_first_q <= {beat_first_q[READ-1:1], issue_pixel && first_q};
    beat_last_q <= {beat_last_q[READ-1:1], issue_pixel && last_x};
  end

  // Cells have rows of control points above and below; the even ones are in one bank, the odd ones in the other.
  if (FAST) begin : g_fast
    // The geometry does not change while this runs, y_q does after a row.
    logic [ROW_BITS-1:0] last_row_q, flush_end_q;
    logic [X_BITS-1:0] before_last_column_q;
    logic [11:0] ahead_q;
    logic last_x_q, last_y_q, flushed_q, right_complete_q;
    always_ff @(posedge clk_i) begin
      last_row_q <= ROW_BITS'(height_i - 12'd1);
      flush_end_q <= last_row_q + flush_rows;
      before_last_column_q <= X_BITS'(width_i - 12'd2);
      ahead_q <= 12'(y_q) + lookahead_i;
      right_complete_q <= right_rows_i == height_i;
      last_y_q <= y_q == last_row_q;
      flushed_q <= y_q == flush_end_q;
    end
    assign last_x = last_x_q;
    assign last_y = last_y_q;
    assign flushed = flushed_q;
    logic right_ready_q, left_ready_q;
    always_ff @(posedge clk_i) begin
      right_ready_q <= right_rows_i > ahead_q || right_complete_q || right_ended_i;
      left_ready_q <= left_rows_i > 12'(y_q) || left_ended_i;
    end
    assign ready = !live_q || (right_ready_q && left_ready_q);

    logic odd_cell_q, loads_q, cell_end_y_q;
    logic [MAP_ADDR_BITS-1:0] even_row_q, odd_row_q, even_addr_q, odd_addr_q, row_below;
    assign row_below = (odd_cell_q ? odd_row_q : even_row_q) + MAP_ADDR_BITS'(table_columns_i);
    logic [5:0] fraction_q, cell_mask_x_q, cell_mask_y_q;
    assign loads = loads_q;
    logic row_over_q;  // the row's last pixel was issued in the clock before; its successor waits for some clocks
    always_ff @(posedge clk_i) begin
      row_over_q <= issue_pixel && last_x && live_q;
      // Decided with the pixel before.
      if (state_q == WAIT_ROW) begin
        last_x_q <= 1'b0;
        loads_q <= live_q;
      end else if (issue_pixel) begin
        last_x_q <= x_q == before_last_column_q;
        loads_q <= live_q && (x_q[5:0] & cell_mask_x_q) == cell_mask_x_q;
      end
      cell_end_y_q <= (y_q[5:0] & cell_mask_y_q) == cell_mask_y_q;  // the next row is in another cell
      // Nothing is read while a row waits.
      even_addr_q <= (state_q == WAIT_ROW ? even_row_q : even_addr_q) + MAP_ADDR_BITS'(map_read_o);
      odd_addr_q <= (state_q == WAIT_ROW ? odd_row_q : odd_addr_q) + MAP_ADDR_BITS'(map_read_o);
      if (state_q == SETUP) begin
        even_row_q <= table_base_i;
        odd_row_q <= table_base_i;
        odd_cell_q <= 1'b0;
        fraction_q <= 6'd0;
        cell_mask_x_q <= ~(6'h3F << table_nx_i);
        cell_mask_y_q <= ~(6'h3F << table_ny_i);
      end else if (row_over_q) begin
        // The cell's lower row becomes the upper one of the next: only the other bank moves on.
        fraction_q <= cell_end_y_q ? 6'd0 : fraction_q + (6'd1 << (3'd6 - table_ny_i));
        if (cell_end_y_q) begin
          odd_cell_q <= !odd_cell_q;
          if (odd_cell_q) odd_row_q <= row_below;
          else even_row_q <= row_below;
        end
      end
    end
    assign map_even_addr_o = even_addr_q;
    assign map_odd_addr_o = odd_addr_q;

    // A last stage puts the control points in their order.
    logic [READ:1] beat_live_q, beat_odd_q;
    logic [6*READ-1:0] beat_fraction_q;  // the oldest in the highest bits
    always_ff @(posedge clk_i) begin
      beat_live_q <= {beat_live_q[READ-1:1], live_q};
      beat_odd_q <= {beat_odd_q[READ-1:1], odd_cell_q};
      beat_fraction_q <= {beat_fraction_q[6*(READ-1)-1:0], fraction_q};
      if (!rst_ni) valid_o <= 1'b0;
      else valid_o <= valid_q[READ];
      prime_o <= prime_q[READ];
      load_o <= load_q[READ];
      first_o <= beat_first_q[READ];
      last_o <= beat_last_q[READ];
      live_o <= beat_live_q[READ];
      row_fraction_o <= beat_fraction_q[6*(READ-1)+:6];
      even_o <= map_even_i;
      odd_o <= map_odd_i;
      swapped_o <= beat_odd_q[READ];
      map_parity_error_o <= map_error_i && (prime_q[READ] || load_q[READ]) && beat_live_q[READ] && table_ok_i;
    end
  end else begin : g_slow
    logic [ROW_BITS-1:0] last_row;
    assign last_row = ROW_BITS'(height_i - 12'd1);
    assign last_x = x_q == X_BITS'(width_i - 12'd1);
    assign last_y = y_q == last_row;
    assign flushed = y_q == last_row + flush_rows;
    // Row min(y + lookahead, height - 1).
    logic right_ready;
    assign right_ready = 32'(right_rows_i) > 32'(y_q) + 32'(lookahead_i[ROW_BITS-1:0]) || right_rows_i == height_i || right_ended_i;
    assign ready = !live_q || (right_ready && (left_rows_i > 12'(y_q) || left_ended_i));

    // A row reads as many control points of each bank as the table has columns; then its addresses go back, or stay where
    // the next row of cells has its control points. The upper row of an even cell is in the even bank, with the same
    // address as the lower one in the odd bank; below it lies the next row of the even bank.
    logic [MAP_ADDR_BITS-1:0] odd_addr_q;
    logic odd_cell_q, new_row_of_cells;
    logic [5:0] fraction;
    assign loads = live_q && 6'(x_q[5:0] << (3'd6 - table_nx_i)) == 6'd0;
    assign fraction = y_q[5:0] << (3'd6 - table_ny_i);
    assign new_row_of_cells = fraction == 6'd0;
    always_ff @(posedge clk_i) begin
      if (state_q == SETUP) begin
        odd_addr_q <= table_base_i;
        odd_cell_q <= 1'b1;  // before the first one, which is even
      end else if (state_q == WAIT_ROW && count_q == '0) begin
        if (new_row_of_cells) odd_cell_q <= !odd_cell_q;
        if (!new_row_of_cells || !odd_cell_q) odd_addr_q <= odd_addr_q - MAP_ADDR_BITS'(table_columns_i);
      end else if (map_read_o) begin
        odd_addr_q <= odd_addr_q + 1'b1;
      end
    end
    assign map_odd_addr_o = odd_addr_q;
    assign map_even_addr_o = odd_addr_q + (odd_cell_q ? MAP_ADDR_BITS'(table_columns_i) : '0);

    // What does not change in a row; the one before has left when the next one's first beat is issued.
    logic row_live_q, row_odd_q;
    logic [5:0] row_fraction_q;
    always_ff @(posedge clk_i) begin
      if (issue_prime) begin
        row_live_q <= live_q;
        row_odd_q <= odd_cell_q;
        row_fraction_q <= fraction;
      end
    end
    assign valid_o = valid_q[2];
    assign prime_o = prime_q[2];
    assign load_o = load_q[2];
    assign first_o = beat_first_q[2];
    assign last_o = beat_last_q[2];
    assign live_o = row_live_q;
    assign row_fraction_o = row_fraction_q;
    assign even_o = map_even_i;
    assign odd_o = map_odd_i;
    assign swapped_o = row_odd_q;
    assign map_parity_error_o = map_error_i && (prime_q[2] || load_q[2]) && row_live_q && table_ok_i;
    logic unused_bits;
    assign unused_bits = ^lookahead_i[11:ROW_BITS];
  end
  assign slot_o = slot_q;
  assign active_o = active_q;
endmodule
