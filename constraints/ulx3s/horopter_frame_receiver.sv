// SPDX-License-Identifier: Apache-2.0
// Frames from bytes, as docs/boards.md describes them. Whatever is not a whole frame with a right CRC is dropped: bytes
// that were broken on the line, that were lost, that came twice, and frames for which there is no room.
//
// It holds two frames: one that comes and one that is worked on. valid_o: a frame is there; words_o: its words, without
// the CRC, the first one is the header; word_o: the word at index_i, a clock later. done_i for one clock frees it.
module horopter_frame_receiver #(
    parameter int unsigned LARGEST = 65  // words of a frame, without the CRC
) (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic        byte_valid_i,
    input  logic        byte_broken_i,
    input  logic [ 7:0] byte_i,
    output logic        valid_o,
    output logic [ 6:0] words_o,
    input  logic [ 6:0] index_i,
    output logic [31:0] word_o,
    input  logic        done_i
);
  localparam logic [7:0] FLAG = 8'h7E;
  localparam logic [7:0] ESCAPE = 8'h7D;
  localparam logic [31:0] CRC_RIGHT = 32'hDEBB20E3;
  if (LARGEST > 126) begin : g_illegal
    $fatal(1, "horopter_frame_receiver: LARGEST must be at most 126");
  end

  logic in_frame_q, escape_q, slot_q, out_slot_q;
  logic [8:0] count_q;  // bytes
  logic [31:0] crc_q, crc, word;
  logic [23:0] before_q;  // of the word, the bytes before this one
  logic [1:0] full_q;
  logic [6:0] words_q[2];
  logic [7:0] data;
  assign data = escape_q ? byte_i ^ 8'h20 : byte_i;
  assign word = {data, before_q};
  horopter_crc32 u_crc (
      .crc_i(crc_q),
      .byte_i(data),
      .crc_o(crc)
  );

  logic is_flag, ends, takes;
  assign is_flag = byte_valid_i && !byte_broken_i && byte_i == FLAG;
  assign ends = is_flag && in_frame_q && !escape_q && count_q[8:3] != 6'd0 && count_q[1:0] == 2'd0 && crc_q == CRC_RIGHT;
  assign takes = byte_valid_i && !is_flag && in_frame_q && (escape_q || byte_i != ESCAPE);
  always_ff @(posedge clk_i) begin
    if (is_flag) begin  // it may end one frame and begin the next
      in_frame_q <= ends ? !full_q[!slot_q] || done_i : !full_q[slot_q];
      escape_q <= 1'b0;
      count_q <= 9'd0;
      crc_q <= '1;
    end else if (byte_valid_i) begin
      escape_q <= !escape_q && byte_i == ESCAPE;
      if (byte_broken_i) in_frame_q <= 1'b0;
    end
    if (takes) begin
      crc_q <= crc;
      count_q <= count_q + 9'd1;
      before_q <= word[31:8];
      if (32'(count_q) == 4 * (LARGEST + 1)) in_frame_q <= 1'b0;
    end
    if (ends) begin
      full_q[slot_q] <= 1'b1;
      words_q[slot_q] <= count_q[8:2] - 7'd1;
      slot_q <= !slot_q;
    end
    if (done_i) begin
      full_q[out_slot_q] <= 1'b0;
      out_slot_q <= !out_slot_q;
    end
    if (!rst_ni) begin
      in_frame_q <= 1'b0;
      full_q <= 2'b00;
      slot_q <= 1'b0;
      out_slot_q <= 1'b0;
    end
  end
  assign valid_o = full_q[out_slot_q];
  assign words_o = words_q[out_slot_q];

  logic [31:0] memory[256];
  always_ff @(posedge clk_i) begin
    if (takes && count_q[1:0] == 2'd3) memory[{slot_q, count_q[8:2]}] <= word;
    word_o <= memory[{out_slot_q, index_i}];
  end
endmodule
