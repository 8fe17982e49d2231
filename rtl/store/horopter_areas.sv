// SPDX-License-Identifier: Apache-2.0
// The areas of the frame's table (hls/include/horopter/hls/table_format.hpp): for each block of the result the code of the
// area of skin that one of its pixels sees. They are copied from the pool into a memory at the frame's begin, a word a
// clock, while the raster generator waits; and found for each pixel of the result.
//
// begin_i: one clock; 4 clocks later the table's entry is there, and stays. It has areas_i words of areas, in the pool's
// words64 before base_i, even bank first. busy_o: from the clock after begin_i on until all is stored; nothing else may
// read the pool then.
// The pool's words come READ clocks after their addresses. Without a table, and where it has no word, the code is the one
// of an area that is not known.
//
// pixel_*_i: the result's pixels in raster order; area_o is that of the pixel of LATENCY clocks before. An address is never
// outside of the memory, whatever an upset makes of it. error_o: a word came with a parity error, from the pool or the
// memory.
module horopter_areas #(
    parameter int unsigned COLUMNS = horopter_profile_pkg::WIDTH / horopter_profile_pkg::SUBSAMPLE,
    parameter int unsigned ROWS = horopter_profile_pkg::HEIGHT,
    parameter int unsigned ADDR_BITS = 14,
    parameter bit FAST = 1'b0,  // see horopter_ram
    parameter int unsigned READ = FAST ? 5 : 2,
    parameter int unsigned LATENCY = FAST ? 4 : 3
) (
    input  logic                         clk_i,
    input  logic                         rst_ni,
    // the frame's table
    input  logic                         begin_i,
    input  logic                         table_ok_i,
    input  logic [        ADDR_BITS-1:0] base_i,
    input  logic [                 11:0] areas_i,
    output logic                         busy_o,
    // pool
    output logic                         read_o,
    output logic [        ADDR_BITS-1:0] addr_o,  // of both banks
    input  logic [                 31:0] even_i,
    input  logic [                 31:0] odd_i,
    input  logic                         error_i,
    // result
    input  logic [$clog2(COLUMNS+1)-1:0] width_i,
    input  logic                         pixel_valid_i,
    input  logic                         pixel_first_i,
    input  logic                         pixel_last_i,  // of a row
    output logic [                  7:0] area_o,
    output logic                         error_o
);
  localparam int unsigned SIDE_BITS = horopter_table_pkg::AREA_BLOCK_LOG2;
  localparam logic [7:0] UNKNOWN = 8'(horopter_table_pkg::UNKNOWN_AREA);
  localparam int unsigned SIDE = 1 << SIDE_BITS;
  localparam int unsigned BLOCKS = ((COLUMNS + SIDE - 1) / SIDE) * ((ROWS + SIDE - 1) / SIDE);
  localparam int unsigned INDEX_BITS = $clog2(BLOCKS) > 3 ? $clog2(BLOCKS) : 3;  // of a block, whose lowest two choose a byte
  localparam int unsigned WORD_BITS = INDEX_BITS - 2;
  localparam int unsigned COLUMN_BITS = $clog2(COLUMNS);
  if (READ < 2 || LATENCY != (FAST ? 4 : 3)) begin : g_illegal
    $fatal(1, "horopter_areas: READ must be 2 or more, LATENCY left alone");
  end

  // --- copy ---
  logic [4:1] begin_q;
  logic reading_q, more_q, write_q, copy_error_q;  // more_q: words are still to be read
  logic [WORD_BITS-1:0] read_word_q, copied_q, write_addr_q;
  logic [11:0] areas_q, left_q;  // words of areas: all, and how many are still to be read
  logic [ADDR_BITS-1:0] addr_q;
  logic [READ:1] valid_q;
  logic [31:0] word_q;
  assign read_o = reading_q && more_q;
  assign addr_o = addr_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      begin_q <= '0;
      reading_q <= 1'b0;
      valid_q <= '0;
      write_q <= 1'b0;
      busy_o <= 1'b0;
    end else begin
      busy_o <= begin_i || begin_q != '0 || reading_q || valid_q != '0 || write_q;
      begin_q <= {begin_q[3:1], begin_i};
      reading_q <= begin_q[4] || (read_o && read_word_q != '1);
      valid_q <= {valid_q[READ-1:1], read_o};
      write_q <= valid_q[READ];
    end
    areas_q <= table_ok_i ? areas_i : 12'd0;
    if (begin_q[4]) begin
      read_word_q <= '0;
      copied_q <= '0;
      left_q <= areas_q;
      more_q <= areas_q != 12'd0;
      addr_q <= base_i - ADDR_BITS'((13'(areas_i) + 13'd1) >> 1);
    end else begin
      if (read_o) begin
        read_word_q <= read_word_q + 1'b1;
        addr_q <= addr_q + ADDR_BITS'(read_word_q[0]);
        left_q <= left_q - 12'd1;
        more_q <= left_q != 12'd1;
      end
      if (valid_q[READ]) copied_q <= copied_q + 1'b1;
    end
    word_q <= copied_q[0] ? odd_i : even_i;
    write_addr_q <= copied_q;
    copy_error_q <= rst_ni && valid_q[READ] && error_i;
  end

  // --- places ---
  logic [COLUMN_BITS-1:0] column_q, column;
  logic [SIDE_BITS-1:0] inner_q, inner;  // row in its block
  logic [INDEX_BITS-1:0] row_q, row, next_row_q, index_q;  // first block of the row, of the row of blocks below; block
  logic [INDEX_BITS-1:0] blocks_q;  // of a row
  logic read_q;
  assign column = pixel_first_i ? '0 : column_q;
  assign inner = pixel_first_i ? '0 : inner_q;
  assign row = pixel_first_i ? '0 : row_q;
  always_ff @(posedge clk_i) begin
    blocks_q <= INDEX_BITS'((32'(width_i) + SIDE - 1) >> SIDE_BITS);
    next_row_q <= row_q + blocks_q;
    read_q <= rst_ni && pixel_valid_i;
    if (pixel_valid_i) begin
      index_q <= row + INDEX_BITS'(column >> SIDE_BITS);
      column_q <= pixel_last_i ? '0 : column + 1'b1;
      inner_q <= inner + SIDE_BITS'(pixel_last_i);
      row_q <= pixel_last_i && inner == '1 ? next_row_q : row;
    end
  end

  logic [31:0] word;
  logic word_error, error_q;
  // From a word's address to the word; the oldest in the highest bits.
  localparam int unsigned WAIT = LATENCY - 2;
  logic [WAIT-1:0] known_q;  // a pixel, whose word the table has
  logic [2*WAIT-1:0] byte_q;
  horopter_ram #(
      .WIDTH(32),
      .DEPTH(1 << WORD_BITS),
      .PARITY(1'b1),
      .OUTPUT_REGISTER(FAST)
  ) u_codes (
      .clk_i(clk_i),
      .write_en_i(write_q),
      .write_addr_i(write_addr_q),
      .write_data_i(word_q),
      .read_en_i(read_q),
      .read_addr_i(index_q[INDEX_BITS-1:2]),
      .read_data_o(word),
      .parity_error_o(word_error)
  );
  always_ff @(posedge clk_i) begin
    known_q <= WAIT'({known_q, read_q && 12'(index_q[INDEX_BITS-1:2]) < areas_q});
    byte_q <= (2 * WAIT)'({byte_q, index_q[1:0]});
    area_o <= known_q[WAIT-1] ? word[8*byte_q[2*WAIT-1-:2]+:8] : UNKNOWN;
    error_q <= rst_ni && known_q[WAIT-1] && word_error;
    error_o <= copy_error_q || error_q;
  end
endmodule
