// SPDX-License-Identifier: Apache-2.0
// Left delay: the left image waits here, row by row, until the right image is LOOKAHEAD rows ahead.
//
// A ring of ROWS rows. Write side: as the framer gives them; a bad row counts as missing. Read side: requests in raster
// order, those of live rows only; the pixel comes 7 clocks later if FAST, else 1 (out of step with nothing: the image store
// asks at the right time). mask_o = the row came and was good. Rows that never came are not in the ring.
// SUBSAMPLE = 2: what waits is the mean of two pixels, all that is needed of them; both requests of a pair get it.
// keep_o: rows before it (counted as the framer counts stored rows) are read for good and may be overwritten.
// Where a frame's rows are is told anew with each frame, so that nothing that went wrong in one lasts. place_error_o: they
// do not follow those of the frame before, or the place in the ring is not what its second copy says.
module horopter_left_store #(
    parameter int unsigned WIDTH = 640,
    parameter int unsigned HEIGHT = 480,
    parameter int unsigned ROWS = 36,
    parameter int unsigned SUBSAMPLE = 1,
    parameter bit PARITY = 1'b1,
    parameter bit FAST = 1'b0,  // for clocks that need a register after every step, see horopter_ram
    parameter int unsigned SLOT_BITS = $clog2(ROWS)
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    // write
    input  logic                 write_en_i,
    input  logic [SLOT_BITS-1:0] write_slot_i,
    input  logic [         11:0] write_x_i,
    input  logic [          7:0] write_pixel_i,
    input  logic                 row_done_i,
    input  logic                 row_bad_i,
    // frame
    input  logic                 begin_i,  // a new output frame; base_* valid
    input  logic [  SLOT_BITS:0] base_i,  // count of its first row
    input  logic [SLOT_BITS-1:0] base_slot_i,
    input  logic [         11:0] rows_i,  // rows of it that came so far
    output logic [  SLOT_BITS:0] keep_o,
    output logic                 place_error_o,
    // request and answer
    input  logic                 valid_i,
    input  logic                 last_i,
    input  logic                 live_i,
    output logic [          7:0] pixel_o,
    output logic                 mask_o,
    output logic                 parity_error_o
);
  // In blocks of up to 128 columns: block by block, row by row, so that a row's start needs no multiplication.
  localparam int unsigned COLUMNS = WIDTH / SUBSAMPLE;
  localparam int unsigned BLOCK_BITS = COLUMNS < 128 ? $clog2(COLUMNS) : 7;
  localparam int unsigned BLOCKS = (COLUMNS + 2 ** BLOCK_BITS - 1) / 2 ** BLOCK_BITS;
  localparam int unsigned DEPTH = BLOCKS * ROWS * 2 ** BLOCK_BITS;
  localparam int unsigned ADDR_BITS = $clog2(DEPTH);
  localparam int unsigned ROW_ADDR_BITS = ADDR_BITS - BLOCK_BITS;
  localparam int unsigned ROW_BITS = $clog2(HEIGHT + 1);
  localparam int unsigned X_BITS = $clog2(WIDTH);

  if (ROWS < 4 || ROWS > 2048 || WIDTH < 4 || SLOT_BITS != $clog2(ROWS)) begin : g_illegal
    $fatal(1, "horopter_left_store: ROWS must be 4 to 2048, WIDTH at least 4");
  end
  if (SUBSAMPLE < 1 || SUBSAMPLE > 2 || WIDTH % SUBSAMPLE != 0 || (SUBSAMPLE != 1 && FAST)) begin : g_illegal_subsample
    $fatal(1, "horopter_left_store: SUBSAMPLE must be 1, or 2 without FAST and divide WIDTH");
  end

  // Block * ROWS, by additions: a multiplier block would lie far away.
  function automatic [ROW_ADDR_BITS-1:0] block_start(input [ROW_ADDR_BITS-1:0] block);
    block_start = '0;
    for (int unsigned i = 0; i < 11; i++) if (ROWS[i]) block_start = block_start + (block << i);
  endfunction

  logic write_en, read, is_bad, error;
  logic [SLOT_BITS-1:0] slot_q;
  logic [ADDR_BITS-1:0] write_addr, read_addr;
  logic [7:0] write_pixel, pixel;
  horopter_ram #(
      .WIDTH(8),
      .DEPTH(DEPTH),
      .PARITY(PARITY),
      .OUTPUT_REGISTER(FAST),
      .FAST(FAST)
  ) u_pixels (
      .clk_i(clk_i),
      .write_en_i(write_en),
      .write_addr_i(write_addr),
      .write_data_i(write_pixel),
      .read_en_i(read),
      .read_addr_i(read_addr),
      .read_data_o(pixel),
      .parity_error_o(error)
  );
  horopter_bad_rows #(
      .ROWS(ROWS)
  ) u_bad_rows (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .row_done_i(row_done_i),
      .row_bad_i(row_bad_i),
      .slot_i(write_slot_i),
      .row_i(slot_q),
      .below_i(1'b0),
      .bad_o(is_bad)
  );

  // --- rows of the ring and of the frame ---
  logic [ROW_BITS-1:0] row_q;
  logic [SLOT_BITS:0] keep_q;
  logic end_of_row, wraps;
  logic last;  // with read
  logic copy_error;
  horopter_place_copy #(
      .ROWS(ROWS)
  ) u_place_copy (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .begin_i(begin_i),
      .base_slot_i(base_slot_i),
      .step_i(read && last),
      .slot_i(slot_q),
      .error_o(copy_error)
  );
  always_ff @(posedge clk_i) begin
    wraps <= 32'(slot_q) == ROWS - 1;  // rows are longer than a clock
    place_error_o <= rst_ni && (copy_error || (begin_i && (slot_q != base_slot_i || keep_q != base_i)));
    if (!rst_ni) begin
      row_q <= '0;
      keep_q <= '0;
      slot_q <= '0;
    end else begin
      if (begin_i) row_q <= '0;
      else if (end_of_row) row_q <= row_q + 1'b1;
      if (begin_i) begin
        keep_q <= base_i;
        slot_q <= base_slot_i;
      end else if (read && last) begin
        keep_q <= keep_q + 1'b1;
        slot_q <= wraps ? '0 : slot_q + 1'b1;
      end
    end
  end
  assign keep_o = keep_q;

  if (FAST) begin : g_fast
    // --- write ---
    logic write_en_q, write_en_q2;
    logic [ROW_ADDR_BITS-1:0] write_block_q;
    logic [SLOT_BITS-1:0] write_slot_q;
    logic [BLOCK_BITS-1:0] write_x_q;
    logic [ADDR_BITS-1:0] write_addr_q;
    logic [7:0] write_pixel_q, write_pixel_q2;
    always_ff @(posedge clk_i) begin
      write_en_q <= write_en_i;
      write_en_q2 <= write_en_q;
      if (write_en_i) begin
        write_block_q <= block_start(ROW_ADDR_BITS'(write_x_i >> BLOCK_BITS));
        write_slot_q <= write_slot_i;
        write_x_q <= write_x_i[BLOCK_BITS-1:0];
        write_pixel_q <= write_pixel_i;
      end
      if (write_en_q) begin
        write_addr_q <= {write_block_q + ROW_ADDR_BITS'(write_slot_q), write_x_q};
        write_pixel_q2 <= write_pixel_q;
      end
    end
    assign write_en = write_en_q2;
    assign write_addr = write_addr_q;
    assign write_pixel = write_pixel_q2;

    // --- read ---
    // The raster waits for some clocks between two rows, in which present_q settles.
    logic [ROW_ADDR_BITS-1:0] block_row_q;
    logic [BLOCK_BITS-1:0] x_q;
    logic present_q, asked_q, last_q, end_of_row_q, row_starts_q;
    assign read = asked_q;
    assign last = last_q;
    assign end_of_row = end_of_row_q;
    always_ff @(posedge clk_i) begin
      asked_q <= rst_ni && valid_i && live_i && present_q;
      last_q <= last_i;
      end_of_row_q <= rst_ni && valid_i && live_i && last_i;
      present_q <= rst_ni && 12'(row_q) < rows_i;
      row_starts_q <= rst_ni && (begin_i || (read && last));  // then slot_q has moved on, and nothing is read
      // No frame is read that did not begin, which sets them.
      block_row_q <= (row_starts_q ? ROW_ADDR_BITS'(slot_q) : block_row_q) + (read && &x_q ? ROW_ADDR_BITS'(ROWS) : '0);
      if (end_of_row || begin_i) x_q <= '0;
      else if (read) x_q <= x_q + 1'b1;
    end
    assign read_addr = {block_row_q, x_q};

    // Between two rows slot_q is there some clocks before anything is read, and a row that is read stays as it came.
    logic is_bad_q;
    logic [5:1] read_q, good_q;
    always_ff @(posedge clk_i) begin
      is_bad_q <= is_bad;
      read_q <= {read_q[4:1], read};
      good_q <= {good_q[4:1], read && !is_bad_q};
      pixel_o <= pixel;
      mask_o <= good_q[5];
      parity_error_o <= read_q[5] && error;
    end
  end else begin : g_slow
    function automatic [ADDR_BITS-1:0] place(input [SLOT_BITS-1:0] slot, input [$clog2(COLUMNS)-1:0] x);
      place = {block_start(ROW_ADDR_BITS'(x >> BLOCK_BITS)) + ROW_ADDR_BITS'(slot), x[BLOCK_BITS-1:0]};
    endfunction
    assign write_addr = place(write_slot_i, write_x_i[X_BITS-1:SUBSAMPLE-1]);
    if (SUBSAMPLE == 2) begin : g_mean
      logic [7:0] even_q;
      always_ff @(posedge clk_i) if (write_en_i) even_q <= write_pixel_i;
      assign write_en = write_en_i && write_x_i[0];
      assign write_pixel = 8'((9'(even_q) + 9'(write_pixel_i) + 9'd1) >> 1);
    end else begin : g_pixel
      assign write_en = write_en_i;
      assign write_pixel = write_pixel_i;
    end

    logic [X_BITS-1:0] x_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni || begin_i || (read && last)) x_q <= '0;
      else if (read) x_q <= x_q + 1'b1;
    end
    assign read = valid_i && live_i && row_q < rows_i[ROW_BITS-1:0];
    assign last = last_i;
    assign end_of_row = valid_i && live_i && last_i;
    assign read_addr = place(slot_q, x_q[X_BITS-1:SUBSAMPLE-1]);

    logic read_q;
    always_ff @(posedge clk_i) read_q <= read && !is_bad;
    assign pixel_o = pixel;
    assign mask_o = read_q;
    assign parity_error_o = read_q && error;
    logic unused_bits;
    assign unused_bits = ^{write_x_i[11:X_BITS], rows_i[11:ROW_BITS]};
  end
endmodule
