// SPDX-License-Identifier: Apache-2.0
// Image store: a ring of ROWS rows of the right image in four banks by the parity of x and of the ring slot, so that the
// 2×2 pixels at any address are read in one clock (thesis 10.4.2).
//
// Write side: as the framer gives them; a bad row counts as missing. Read side: one request a clock from map_expand;
// the 2×2 pixels come READ_LATENCY clocks later (11 if FAST, else 1), with present = all of the following: it exists, in the
// image, in the window of rows that the ring holds for this output row, [row - (ROWS/2 - 2), row + lookahead], and
// received well; mask = mapped, too: it belongs to the skin. A pixel with weight 0 is not needed: it need not exist, and
// its value is anything. A mapped place in the image but outside the window is a miss.
//
// keep_o: rows before it (counted as the framer counts stored rows) are read for good and may be overwritten.
// left_* is the same request as old as it takes for the left store's pixel to come out in step: 4 clocks if FAST, else 0.
module horopter_image_store #(
    parameter int unsigned WIDTH = 640,
    parameter int unsigned HEIGHT = 480,
    parameter int unsigned ROWS = 64,
    parameter int unsigned WEIGHT_BITS = 3,
    parameter bit PARITY = 1'b1,
    parameter bit FAST = 1'b0,  // for clocks that need a register after every step, see horopter_ram
    parameter int unsigned SLOT_BITS = $clog2(ROWS)
) (
    input  logic                   clk_i,
    input  logic                   rst_ni,
    input  logic [           11:0] width_i,
    input  logic [           11:0] height_i,
    input  logic [           11:0] lookahead_i,
    // write
    input  logic                   write_en_i,
    input  logic [  SLOT_BITS-1:0] write_slot_i,
    input  logic [           11:0] write_x_i,
    input  logic [            7:0] write_pixel_i,
    input  logic                   row_done_i,
    input  logic                   row_bad_i,
    // frame
    input  logic                   begin_i,  // a new output frame; base_* valid
    input  logic [    SLOT_BITS:0] base_i,  // count of its first row
    input  logic [  SLOT_BITS-1:0] base_slot_i,
    input  logic [           11:0] rows_i,  // rows that came so far
    output logic [    SLOT_BITS:0] keep_o,
    // request
    input  logic                   valid_i,
    input  logic [           10:0] x_i,
    input  logic [           10:0] y_i,
    input  logic [WEIGHT_BITS-1:0] wx_i,
    input  logic [WEIGHT_BITS-1:0] wy_i,
    input  logic                   present_i,
    input  logic                   mapped_i,
    input  logic                   first_i,
    input  logic                   last_i,
    input  logic                   live_i,
    // to the left store
    output logic                   left_valid_o,
    output logic                   left_last_o,
    output logic                   left_live_o,
    // answer
    output logic                   valid_o,
    output logic [            7:0] p00_o,  // of the even row and the even column
    output logic [            7:0] p01_o,
    output logic [            7:0] p10_o,
    output logic [            7:0] p11_o,
    output logic                   swapped_x_o,  // the odd column is the left one
    output logic                   swapped_y_o,  // the odd row is the upper one
    output logic [WEIGHT_BITS-1:0] wx_o,
    output logic [WEIGHT_BITS-1:0] wy_o,
    output logic                   mask_o,
    output logic                   present_o,
    output logic                   first_o,
    output logic                   last_o,
    output logic                   live_o,
    output logic                   miss_o,  // with valid_o
    output logic                   parity_error_o  // with valid_o
);
  localparam int unsigned HALF_ROWS = ROWS / 2;
  localparam int unsigned HALF_WIDTH = (WIDTH + 1) / 2;
  localparam int unsigned DEPTH = HALF_WIDTH * HALF_ROWS;
  localparam int unsigned INDEX_BITS = SLOT_BITS - 1;
  localparam int unsigned COLUMN_BITS = $clog2(HALF_WIDTH);
  localparam int unsigned ADDR_BITS = COLUMN_BITS + INDEX_BITS;
  localparam int unsigned ROW_BITS = $clog2(HEIGHT + 1);
  localparam int unsigned BACK = HALF_ROWS - 2;

  if (ROWS < 8 || ROWS > 2048 || ROWS != 1 << SLOT_BITS || WIDTH < 4 || WIDTH > 2046 || HEIGHT > 2046) begin : g_illegal
    $fatal(1, "horopter_image_store: ROWS must be a power of two, 8 to 2048, WIDTH 4 to 2046, HEIGHT up to 2046");
  end

  // Four banks {row parity, column parity}; within a bank {column / 2, slot / 2}, so that no address is computed.
  logic write_en;
  logic [ADDR_BITS-1:0] write_addr;
  logic [1:0] write_bank;
  logic [7:0] write_pixel;
  logic bank_read;
  logic [INDEX_BITS-1:0] even_row, odd_row;  // row pairs, of slots with even and odd number
  logic [COLUMN_BITS-1:0] even_column, odd_column;
  logic [31:0] bank_pixel;  // bank {row parity, column parity} in byte 0 to 3
  logic [3:0] bank_error;
  for (genvar r = 0; r < 2; r++) begin : g_row
    for (genvar c = 0; c < 2; c++) begin : g_column
      horopter_ram #(
          .WIDTH(8),
          .DEPTH(DEPTH),
          .PARITY(PARITY),
          .OUTPUT_REGISTER(FAST),
          .FAST(FAST)
      ) u_bank (
          .clk_i(clk_i),
          .write_en_i(write_en && write_bank == {1'(r), 1'(c)}),
          .write_addr_i(write_addr),
          .write_data_i(write_pixel),
          .read_en_i(bank_read),
          .read_addr_i({c == 0 ? even_column : odd_column, r == 0 ? even_row : odd_row}),
          .read_data_o(bank_pixel[8*(2*r+c)+:8]),
          .parity_error_o(bank_error[2*r+c])
      );
    end
  end

  logic [SLOT_BITS-1:0] asked_slot;
  logic asked_below, is_bad;  // the row of the 2x2, whether the one below counts, whether one of them is bad
  horopter_bad_rows #(
      .ROWS(ROWS)
  ) u_bad_rows (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .row_done_i(row_done_i),
      .row_bad_i(row_bad_i),
      .slot_i(write_slot_i),
      .row_i(asked_slot),
      .below_i(asked_below),
      .bad_o(is_bad)
  );

  // The row of the output that the request belongs to.
  logic [ROW_BITS-1:0] row_q;
  always_ff @(posedge clk_i) begin
    if (begin_i) row_q <= '0;
    else if (valid_i && last_i && live_i) row_q <= row_q + 1'b1;
  end

  if (FAST) begin : g_fast
    localparam int unsigned READ_LATENCY = 11;

    // --- write ---
    logic write_en_q, write_en_q2;
    logic [ADDR_BITS-1:0] write_addr_q, write_addr_q2;
    logic [1:0] write_bank_q, write_bank_q2;
    logic [7:0] write_pixel_q, write_pixel_q2;
    always_ff @(posedge clk_i) begin
      write_en_q <= write_en_i;
      write_en_q2 <= write_en_q;
      if (write_en_i) begin
        write_addr_q <= {write_x_i[COLUMN_BITS:1], write_slot_i[SLOT_BITS-1:1]};
        write_bank_q <= {write_slot_i[0], write_x_i[0]};
        write_pixel_q <= write_pixel_i;
      end
      if (write_en_q) begin
        write_addr_q2 <= write_addr_q;
        write_bank_q2 <= write_bank_q;
        write_pixel_q2 <= write_pixel_q;
      end
    end
    assign write_en = write_en_q2;
    assign write_addr = write_addr_q2;
    assign write_bank = write_bank_q2;
    assign write_pixel = write_pixel_q2;

    // --- read ---
    // Marks and weights travel beside the address, all READ_LATENCY stages.
    logic [READ_LATENCY:1] valid_q, first_q, last_q, live_q;
    logic [READ_LATENCY-1:1] mapped_q;
    logic [READ_LATENCY*WEIGHT_BITS-1:0] wx_q, wy_q;  // stage s in bits (s - 1) * WEIGHT_BITS and up
    always_ff @(posedge clk_i) begin
      if (!rst_ni) valid_q <= '0;
      else valid_q <= {valid_q[READ_LATENCY-1:1], valid_i};
      first_q <= {first_q[READ_LATENCY-1:1], first_i};
      last_q <= {last_q[READ_LATENCY-1:1], last_i};
      live_q <= {live_q[READ_LATENCY-1:1], live_i};
      mapped_q <= {mapped_q[READ_LATENCY-2:1], mapped_i};
      wx_q <= {wx_q[(READ_LATENCY-1)*WEIGHT_BITS-1:0], wx_i};
      wy_q <= {wy_q[(READ_LATENCY-1)*WEIGHT_BITS-1:0], wy_i};
    end

    // 1: what is needed of the 2×2.
    logic s1_present, s1_right, s1_below;
    logic [10:0] s1_x, s1_y;
    logic [11:0] s1_row;
    always_ff @(posedge clk_i) begin
      s1_present <= present_i && live_i;
      s1_right <= wx_i != '0;
      s1_below <= wy_i != '0;
      s1_x <= x_i;
      s1_y <= y_i;
      s1_row <= 12'(row_q);
    end

    // 2: the last pixel needed, the ring slot.
    logic s2_possible, s2_below;
    logic [10:0] s2_x;
    logic [11:0] s2_far_x, s2_far_y, s2_row;
    logic [SLOT_BITS-1:0] s2_slot;
    always_ff @(posedge clk_i) begin
      s2_possible <= s1_present;
      s2_below <= s1_below;
      s2_x <= s1_x;
      s2_far_x <= 12'(s1_x) + 12'(s1_right);
      s2_far_y <= 12'(s1_y) + 12'(s1_below);
      s2_row <= s1_row;
      s2_slot <= s1_y[SLOT_BITS-1:0] + base_slot_i;
    end

    // 3: decisions, and how far the last row needed is before that of the output, in two's complement.
    logic s3_inside, s3_came, s3_below;
    logic [12:0] s3_ahead;
    logic [10:0] s3_x;
    logic [SLOT_BITS-1:0] s3_slot;
    always_ff @(posedge clk_i) begin
      s3_inside <= s2_possible && s2_far_x < width_i && s2_far_y < height_i;
      s3_ahead <= {1'b0, s2_far_y} - {1'b0, s2_row};
      s3_came <= s2_far_y < rows_i;
      s3_below <= s2_below;
      s3_x <= s2_x;
      s3_slot <= s2_slot;
    end

    // 4: the window, row pairs of the two row parities.
    logic s4_ok, s4_miss, s4_below, s4_row_odd, in_window;
    logic [10:0] s4_x;
    logic [INDEX_BITS-1:0] s4_even_row, s4_odd_row;
    // -BACK is 2 more than a power of two's negative.
    assign in_window = s3_ahead[12] ? &s3_ahead[11:INDEX_BITS] && s3_ahead[INDEX_BITS-1:0] >= INDEX_BITS'(2) + INDEX_BITS'(s3_below)
        : s3_ahead[11:0] <= lookahead_i;
    always_ff @(posedge clk_i) begin
      s4_ok <= s3_inside && in_window && s3_came;
      s4_miss <= s3_inside && !in_window && mapped_q[3];
      s4_below <= s3_below;
      s4_row_odd <= s3_slot[0];
      s4_x <= s3_x;
      s4_odd_row <= s3_slot[SLOT_BITS-1:1];
      s4_even_row <= s3_slot[SLOT_BITS-1:1] + INDEX_BITS'(s3_slot[0]);
    end
    assign asked_slot = {s4_odd_row, s4_row_odd};
    assign asked_below = s4_below;

    // 5: columns of the two column parities.
    logic [READ_LATENCY-1:5] ok_q, miss_q, row_odd_q, column_odd_q;
    always_ff @(posedge clk_i) begin
      ok_q <= {ok_q[READ_LATENCY-2:5], s4_ok && !is_bad};
      miss_q <= {miss_q[READ_LATENCY-2:5], s4_miss};
      row_odd_q <= {row_odd_q[READ_LATENCY-2:5], s4_row_odd};
      column_odd_q <= {column_odd_q[READ_LATENCY-2:5], s4_x[0]};
      even_row <= s4_even_row;
      odd_row <= s4_odd_row;
      even_column <= s4_x[COLUMN_BITS:1] + COLUMN_BITS'(s4_x[0]);
      odd_column <= s4_x[COLUMN_BITS:1];
    end
    assign bank_read = ok_q[5];

    // 6 is the memories' address register, 7 to 10 their output, 11 has the four pixels.
    always_ff @(posedge clk_i) begin
      p00_o <= bank_pixel[0+:8];
      p01_o <= bank_pixel[8+:8];
      p10_o <= bank_pixel[16+:8];
      p11_o <= bank_pixel[24+:8];
      swapped_x_o <= column_odd_q[10];
      swapped_y_o <= row_odd_q[10];
      mask_o <= ok_q[10] && mapped_q[10];
      present_o <= ok_q[10];
      miss_o <= miss_q[10];
      parity_error_o <= ok_q[10] && bank_error != '0;
    end
    assign valid_o = valid_q[11];
    assign first_o = first_q[11];
    assign last_o = last_q[11];
    assign live_o = live_q[11];
    assign wx_o = wx_q[(READ_LATENCY-1)*WEIGHT_BITS+:WEIGHT_BITS];
    assign wy_o = wy_q[(READ_LATENCY-1)*WEIGHT_BITS+:WEIGHT_BITS];

    assign left_valid_o = valid_q[4];
    assign left_last_o = last_q[4];
    assign left_live_o = live_q[4];

    // --- rows that are no longer needed ---
    // Requests for the next row end long after the answers for this one, so that what was said of it then still holds.
    logic [SLOT_BITS:0] keep_rows_q, keep_base_q;  // modulo, within a ring's rows of rows_i
    logic row_asked, row_read, last_row_q, past_back_q, passes_q;
    logic [11:0] height_less_1_q;
    assign row_asked = valid_i && last_i && live_i;
    assign row_read = valid_q[8] && last_q[8] && live_q[8];
    always_ff @(posedge clk_i) begin
      height_less_1_q <= height_i - 12'd1;
      if (row_asked) last_row_q <= 12'(row_q) == height_less_1_q;
      if (begin_i) past_back_q <= 1'b0;
      else if (row_asked && row_q[INDEX_BITS-1:0] == INDEX_BITS'(BACK)) past_back_q <= 1'b1;  // the first of those
      passes_q <= past_back_q && keep_rows_q != rows_i[SLOT_BITS:0];
      if (!rst_ni || begin_i) keep_rows_q <= '0;
      else if (row_read && last_row_q) keep_rows_q <= rows_i[SLOT_BITS:0];
      else if (row_read && passes_q) keep_rows_q <= keep_rows_q + 1'b1;
      if (!rst_ni) keep_base_q <= '0;
      else if (begin_i) keep_base_q <= base_i;
      keep_o <= keep_base_q + keep_rows_q;
    end
    logic unused_bits;
    assign unused_bits = ^write_x_i[11:COLUMN_BITS+1];
  end else begin : g_slow
    // --- write ---
    assign write_en = write_en_i;
    assign write_addr = {write_x_i[COLUMN_BITS:1], write_slot_i[SLOT_BITS-1:1]};
    assign write_bank = {write_slot_i[0], write_x_i[0]};
    assign write_pixel = write_pixel_i;

    // --- read: all of it in the clock in which the memories take their addresses ---
    logic right, below, in_image, in_window, came;
    logic [11:0] last_row, last_column;
    logic [ROW_BITS:0] far_y;  // of a row in the image
    logic [ROW_BITS:0] ahead;  // by how much it is before the row of the output; two's complement
    logic [SLOT_BITS-1:0] slot;
    assign right = wx_i != '0;
    assign below = wy_i != '0;
    assign last_row = height_i - 12'd1;
    assign last_column = width_i - 12'd1;
    assign far_y = (ROW_BITS + 1)'(y_i) + (ROW_BITS + 1)'(below);
    // {a, 0} >= {b, bit} is a >= b + bit.
    assign in_image = present_i && live_i && {last_column, 1'b0} >= {1'b0, x_i, right} && {last_row, 1'b0} >= {1'b0, y_i, below};
    assign ahead = far_y - {1'b0, row_q};
    assign in_window = ahead[ROW_BITS] ? ahead >= (ROW_BITS + 1)'(-32'(BACK)) + (ROW_BITS + 1)'(below)
        : ahead <= lookahead_i[ROW_BITS:0];
    assign came = far_y < rows_i[ROW_BITS:0];
    assign slot = y_i[SLOT_BITS-1:0] + base_slot_i;
    assign odd_row = slot[SLOT_BITS-1:1];
    assign even_row = slot[SLOT_BITS-1:1] + INDEX_BITS'(slot[0] && below);
    assign odd_column = x_i[COLUMN_BITS:1];
    assign even_column = x_i[COLUMN_BITS:1] + COLUMN_BITS'(x_i[0] && right);
    assign bank_read = in_image && in_window && came;
    assign asked_slot = slot;
    assign asked_below = below;

    // --- answer ---
    logic ok_q, mapped_q, row_odd_q, column_odd_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) valid_o <= 1'b0;
      else valid_o <= valid_i;
      first_o <= first_i;
      last_o <= last_i;
      live_o <= live_i;
      wx_o <= wx_i;
      wy_o <= wy_i;
      miss_o <= in_image && !in_window && mapped_i;
      mapped_q <= mapped_i;
      ok_q <= bank_read && !is_bad;
      row_odd_q <= slot[0];
      column_odd_q <= x_i[0];
    end
    assign p00_o = bank_pixel[0+:8];
    assign p01_o = bank_pixel[8+:8];
    assign p10_o = bank_pixel[16+:8];
    assign p11_o = bank_pixel[24+:8];
    assign swapped_x_o = column_odd_q;
    assign swapped_y_o = row_odd_q;
    assign mask_o = ok_q && mapped_q;
    assign present_o = ok_q;
    assign parity_error_o = ok_q && bank_error != '0;

    assign left_valid_o = valid_i;
    assign left_last_o = last_i;
    assign left_live_o = live_i;

    // --- rows that are no longer needed; base_i stays as long as the frame is output ---
    logic [SLOT_BITS:0] end_of_rows;  // within a ring's rows of keep_o
    assign end_of_rows = base_i + rows_i[SLOT_BITS:0];
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        keep_o <= '0;
      end else if (begin_i) begin
        keep_o <= base_i;
      end else if (valid_i && last_i && live_i) begin
        if (row_q == last_row[ROW_BITS-1:0]) keep_o <= end_of_rows;
        else if (32'(row_q) >= BACK && keep_o != end_of_rows) keep_o <= keep_o + 1'b1;
      end
    end
    logic unused_bits;
    assign unused_bits = ^{write_x_i[11:COLUMN_BITS+1], lookahead_i[11:ROW_BITS+1], rows_i[11:ROW_BITS+1]};
  end
endmodule
