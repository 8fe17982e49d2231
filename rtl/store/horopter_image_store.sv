// SPDX-License-Identifier: Apache-2.0
// Image store: a ring of ROWS rows of the right image in four banks by the parity of x and of the ring slot, so that the
// 2×2 pixels at any address are read in one clock (thesis 10.4.2).
//
// Write side: as the framer gives them; a bad row counts as missing. Read side: one request a clock from map_expand;
// the 2×2 pixels come READ_LATENCY clocks later, with mask = all of the following: mapped, in the image, in the window
// of rows that the ring holds for this output row, [row - (ROWS/2 - 2), row + lookahead], and received well. A pixel
// with weight 0 is not needed: it need not exist, and its value is anything. A mapped place in the image but outside
// the window is a miss.
//
// keep_o: rows before it (counted as the framer counts stored rows) are read for good and may be overwritten.
// left_* is the same request READ_LATENCY - 3 clocks old, for the left store, whose pixel then comes out in step.
module horopter_image_store #(
    parameter int unsigned WIDTH = 640,
    parameter int unsigned ROWS = 64,
    parameter int unsigned WEIGHT_BITS = 3,
    parameter bit PARITY = 1'b1,
    parameter bit FAST = 1'b0,  // see horopter_ram
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
    input  logic [           11:0] base_i,  // count of its first row
    input  logic [  SLOT_BITS-1:0] base_slot_i,
    input  logic [           11:0] rows_i,  // rows that came so far
    output logic [           11:0] keep_o,
    // request
    input  logic                   valid_i,
    input  logic [           10:0] x_i,
    input  logic [           10:0] y_i,
    input  logic [WEIGHT_BITS-1:0] wx_i,
    input  logic [WEIGHT_BITS-1:0] wy_i,
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
    output logic [            7:0] p00_o,
    output logic [            7:0] p01_o,
    output logic [            7:0] p10_o,
    output logic [            7:0] p11_o,
    output logic [WEIGHT_BITS-1:0] wx_o,
    output logic [WEIGHT_BITS-1:0] wy_o,
    output logic                   mask_o,
    output logic                   first_o,
    output logic                   last_o,
    output logic                   live_o,
    output logic                   miss_o,  // with valid_o
    output logic                   parity_error_o  // with valid_o
);
  localparam int unsigned READ_LATENCY = 8;
  // A multiple of 32 has few ones, and block memories have room for it.
  localparam int unsigned STRIDE = ((WIDTH + 1) / 2 + 31) / 32 * 32;
  localparam int unsigned HALF_ROWS = ROWS / 2;
  localparam int unsigned DEPTH = HALF_ROWS * STRIDE;
  localparam int unsigned ADDR_BITS = $clog2(DEPTH);
  localparam int unsigned INDEX_BITS = $clog2(HALF_ROWS);
  localparam int unsigned BACK = HALF_ROWS - 2;

  if (ROWS < 8 || ROWS > 2048 || ROWS % 2 != 0 || WIDTH < 4 || WIDTH > 2046 || SLOT_BITS != $clog2(ROWS)) begin : g_illegal
    $fatal(1, "horopter_image_store: ROWS must be even, 8 to 2048, WIDTH 4 to 2046");
  end

  // Row pair * STRIDE, by shifts: added for the digits 1 of STRIDE's non-adjacent form, subtracted for the digits -1.
  localparam int unsigned PLUS = ((3 * STRIDE) & ~STRIDE) >> 1;
  localparam int unsigned MINUS = (STRIDE & ~(3 * STRIDE)) >> 1;
  function automatic [ADDR_BITS-1:0] row_start(input [INDEX_BITS-1:0] pair);
    row_start = '0;
    for (int unsigned i = 0; i < 12; i++) begin
      if (PLUS[i]) row_start = row_start + (ADDR_BITS'(pair) << i);
      if (MINUS[i]) row_start = row_start - (ADDR_BITS'(pair) << i);
    end
  endfunction

  // --- write: bank by parity, address = row pair * STRIDE + x / 2 ---
  logic write_en_q, write_en_q2, bad_en_q;
  logic bad_q, bad_row_q;
  logic [INDEX_BITS-1:0] bad_index_q;
  logic [ADDR_BITS-1:0] write_base_q, write_addr_q;
  logic [10:0] write_column_q;
  logic [1:0] write_bank_q, write_bank_q2;  // {row parity, column parity}
  logic [7:0] write_pixel_q, write_pixel_q2;
  always_ff @(posedge clk_i) begin
    write_en_q <= write_en_i;
    bad_en_q <= row_done_i;
    write_en_q2 <= write_en_q;
    if (write_en_i) begin
      write_base_q <= row_start(write_slot_i[SLOT_BITS-1:1]);
      write_column_q <= write_x_i[11:1];
      write_bank_q <= {write_slot_i[0], write_x_i[0]};
      write_pixel_q <= write_pixel_i;
      bad_q <= row_bad_i;
      bad_row_q <= write_slot_i[0];
      bad_index_q <= write_slot_i[SLOT_BITS-1:1];
    end
    if (write_en_q) begin
      write_addr_q <= write_base_q + ADDR_BITS'(write_column_q);
      write_bank_q2 <= write_bank_q;
      write_pixel_q2 <= write_pixel_q;
    end
  end

  // --- read ---
  // The row of the output that the request belongs to.
  logic [11:0] row_q;
  always_ff @(posedge clk_i) begin
    if (begin_i) row_q <= 12'd0;
    else if (valid_i && last_i && live_i) row_q <= row_q + 12'd1;
  end

  // Marks and weights travel beside the address, all READ_LATENCY stages.
  logic [READ_LATENCY:1] valid_q, first_q, last_q, live_q;
  logic [READ_LATENCY*WEIGHT_BITS-1:0] wx_q, wy_q;  // stage s in bits (s - 1) * WEIGHT_BITS and up
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[READ_LATENCY-1:1], valid_i};
    first_q <= {first_q[READ_LATENCY-1:1], first_i};
    last_q <= {last_q[READ_LATENCY-1:1], last_i};
    live_q <= {live_q[READ_LATENCY-1:1], live_i};
    wx_q <= {wx_q[(READ_LATENCY-1)*WEIGHT_BITS-1:0], wx_i};
    wy_q <= {wy_q[(READ_LATENCY-1)*WEIGHT_BITS-1:0], wy_i};
  end

  // 1: what is needed of the 2×2.
  logic s1_mapped, s1_right, s1_below;
  logic [10:0] s1_x, s1_y;
  logic [11:0] s1_row;
  always_ff @(posedge clk_i) begin
    s1_mapped <= mapped_i && live_i;
    s1_right <= wx_i != '0;
    s1_below <= wy_i != '0;
    s1_x <= x_i;
    s1_y <= y_i;
    s1_row <= row_q;
  end

  // 2: the last pixel needed, the window's ends, the ring slot.
  logic s2_possible, s2_below;
  logic [10:0] s2_x;
  logic [11:0] s2_far_x, s2_far_y, s2_high, s2_y_back, s2_row;
  always_ff @(posedge clk_i) begin
    s2_possible <= s1_mapped;
    s2_below <= s1_below;
    s2_x <= s1_x;
    s2_far_x <= 12'(s1_x) + 12'(s1_right);
    s2_far_y <= 12'(s1_y) + 12'(s1_below);
    s2_high <= s1_row + lookahead_i;
    s2_y_back <= 12'(s1_y) + 12'(BACK);
    s2_row <= s1_row;
  end

  // 3: decisions, slot modulo ROWS.
  logic s3_inside, s3_in_window, s3_came, s3_below;
  logic [10:0] s3_x;
  logic [SLOT_BITS-1:0] s3_slot;
  if (ROWS == 1 << SLOT_BITS) begin : g_power_of_two
    logic [SLOT_BITS-1:0] s2_slot;
    always_ff @(posedge clk_i) begin
      s2_slot <= s1_y[SLOT_BITS-1:0] + base_slot_i;
      s3_slot <= s2_slot;
    end
  end else begin : g_any_ring
    // Only rows of the image are used, and the ring must be at least as tall: one subtraction is enough.
    logic [12:0] s2_slot;
    always_ff @(posedge clk_i) begin
      s2_slot <= 13'(s1_y) + 13'(base_slot_i);
      s3_slot <= SLOT_BITS'(32'(s2_slot) >= ROWS ? 32'(s2_slot) - ROWS : 32'(s2_slot));
    end
  end
  always_ff @(posedge clk_i) begin
    s3_inside <= s2_possible && s2_far_x < width_i && s2_far_y < height_i;
    s3_in_window <= s2_far_y <= s2_high && s2_y_back >= s2_row;
    s3_came <= s2_far_y < rows_i;
    s3_below <= s2_below;
    s3_x <= s2_x;
  end

  // 4: row pairs of the two row parities.
  logic s4_ok, s4_miss, s4_below, s4_row_odd;
  logic [10:0] s4_x;
  logic [INDEX_BITS-1:0] s4_even_row, s4_odd_row;
  always_ff @(posedge clk_i) begin
    s4_ok <= s3_inside && s3_in_window && s3_came;
    s4_miss <= s3_inside && !s3_in_window;
    s4_below <= s3_below;
    s4_row_odd <= s3_slot[0];
    s4_x <= s3_x;
    s4_odd_row <= s3_slot[SLOT_BITS-1:1];
    if (!s3_slot[0]) s4_even_row <= s3_slot[SLOT_BITS-1:1];
    else if (32'(s3_slot) == ROWS - 1) s4_even_row <= '0;
    else s4_even_row <= s3_slot[SLOT_BITS-1:1] + 1'b1;
  end

  // 5: start of the row pairs; columns of the two column parities.
  logic [READ_LATENCY-1:5] ok_q, miss_q, below_q, row_odd_q, column_odd_q;
  logic [ADDR_BITS-1:0] s5_even_base, s5_odd_base;
  logic [9:0] s5_even_column, s5_odd_column;
  always_ff @(posedge clk_i) begin
    ok_q <= {ok_q[READ_LATENCY-2:5], s4_ok};
    miss_q <= {miss_q[READ_LATENCY-2:5], s4_miss};
    below_q <= {below_q[READ_LATENCY-2:5], s4_below};
    row_odd_q <= {row_odd_q[READ_LATENCY-2:5], s4_row_odd};
    column_odd_q <= {column_odd_q[READ_LATENCY-2:5], s4_x[0]};
    s5_even_base <= row_start(s4_even_row);
    s5_odd_base <= row_start(s4_odd_row);
    s5_even_column <= s4_x[10:1] + 10'(s4_x[0]);
    s5_odd_column <= s4_x[10:1];
  end

  // 6 is the memories' address register, 7 their output: see below; this is READ_LATENCY 8 with the last multiplexer.
  logic [ADDR_BITS-1:0] even_column, odd_column;
  assign even_column = ADDR_BITS'(s5_even_column);
  assign odd_column = ADDR_BITS'(s5_odd_column);
  logic [31:0] bank_pixel;  // bank {row parity, column parity} in byte 0 to 3
  logic [3:0] bank_error;
  logic [1:0] row_is_bad;
  for (genvar r = 0; r < 2; r++) begin : g_row
    for (genvar c = 0; c < 2; c++) begin : g_column
      horopter_ram #(
          .WIDTH(8),
          .DEPTH(DEPTH),
          .PARITY(PARITY),
          .OUTPUT_REGISTER(1'b1),
          .FAST(FAST)
      ) u_bank (
          .clk_i(clk_i),
          .write_en_i(write_en_q2 && write_bank_q2 == {1'(r), 1'(c)}),
          .write_addr_i(write_addr_q),
          .write_data_i(write_pixel_q2),
          .read_en_i(ok_q[5]),
          .read_addr_i((r == 0 ? s5_even_base : s5_odd_base) + (c == 0 ? even_column : odd_column)),
          .read_data_o(bank_pixel[8*(2*r+c)+:8]),
          .parity_error_o(bank_error[2*r+c])
      );
    end

    logic bad_now, bad_now_q, bad_now_q2, unused_bad_parity;
    horopter_ram #(
        .WIDTH(1),
        .DEPTH(HALF_ROWS)
    ) u_bad (
        .clk_i(clk_i),
        .write_en_i(bad_en_q && bad_row_q == 1'(r)),
        .write_addr_i(bad_index_q),
        .write_data_i(bad_q),
        .read_en_i(s4_ok),
        .read_addr_i(r == 0 ? s4_even_row : s4_odd_row),
        .read_data_o(bad_now),
        .parity_error_o(unused_bad_parity)
    );
    always_ff @(posedge clk_i) begin
      bad_now_q <= bad_now;
      bad_now_q2 <= bad_now_q;
    end
    assign row_is_bad[r] = bad_now_q2;
  end

  // 8: the four pixels in their places.
  logic row_odd, column_odd;
  assign row_odd = row_odd_q[7];
  assign column_odd = column_odd_q[7];
  always_ff @(posedge clk_i) begin
    p00_o <= bank_pixel[{row_odd, column_odd, 3'b000}+:8];
    p01_o <= bank_pixel[{row_odd, !column_odd, 3'b000}+:8];
    p10_o <= bank_pixel[{!row_odd, column_odd, 3'b000}+:8];
    p11_o <= bank_pixel[{!row_odd, !column_odd, 3'b000}+:8];
    mask_o <= ok_q[7] && !row_is_bad[row_odd] && !(below_q[7] && row_is_bad[!row_odd]);
    miss_o <= miss_q[7];
    parity_error_o <= ok_q[7] && bank_error != '0;
  end
  assign valid_o = valid_q[8];
  assign first_o = first_q[8];
  assign last_o = last_q[8];
  assign live_o = live_q[8];
  assign wx_o = wx_q[(READ_LATENCY-1)*WEIGHT_BITS+:WEIGHT_BITS];
  assign wy_o = wy_q[(READ_LATENCY-1)*WEIGHT_BITS+:WEIGHT_BITS];

  assign left_valid_o = valid_q[5];
  assign left_last_o = last_q[5];
  assign left_live_o = live_q[5];

  // --- rows that are no longer needed ---
  logic [11:0] rows_read_q, keep_rows_q, keep_base_q;
  logic row_read;
  assign row_read = valid_q[6] && last_q[6] && live_q[6];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      rows_read_q <= 12'd0;
      keep_rows_q <= 12'd0;
      keep_base_q <= 12'd0;
    end else if (begin_i) begin
      rows_read_q <= 12'd0;
      keep_rows_q <= 12'd0;
      keep_base_q <= base_i;
    end else if (row_read) begin
      rows_read_q <= rows_read_q + 12'd1;
      if (rows_read_q == height_i - 12'd1) keep_rows_q <= rows_i;
      else if (32'(rows_read_q) >= BACK && keep_rows_q != rows_i) keep_rows_q <= keep_rows_q + 12'd1;
    end
    keep_o <= keep_base_q + keep_rows_q;
  end
endmodule
