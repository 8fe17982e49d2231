// SPDX-License-Identifier: Apache-2.0
// Bytes from frames, as docs/boards.md describes them: flag, words, CRC-32, flag.
module horopter_frame_sender (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic        word_valid_i,
    output logic        word_ready_o,
    input  logic        word_last_i,
    input  logic [31:0] word_i,
    output logic        byte_valid_o,
    input  logic        byte_ready_i,
    output logic [ 7:0] byte_o
);
  localparam logic [7:0] FLAG = 8'h7E;
  localparam logic [7:0] ESCAPE = 8'h7D;

  typedef enum logic [2:0] {
    BEGIN,
    WORD,
    BYTES,
    CRC,
    END
  } state_e;
  state_e state_q;
  logic [31:0] word_q, crc_q, crc;
  logic [1:0] index_q;
  logic last_q, escaped_q, special, step;
  horopter_crc32 u_crc (
      .crc_i(crc_q),
      .byte_i(word_q[7:0]),
      .crc_o(crc)
  );
  // A byte that has a meaning of its own goes as ESCAPE and the byte with bit 5 inverted.
  assign special = (state_q == BYTES || state_q == CRC) && (word_q[7:0] == FLAG || word_q[7:0] == ESCAPE);
  assign byte_valid_o = state_q == BEGIN ? word_valid_i : state_q != WORD;
  assign byte_o = state_q == BEGIN || state_q == END ? FLAG : !special ? word_q[7:0] : escaped_q ? word_q[7:0] ^ 8'h20 : ESCAPE;
  assign step = byte_valid_o && byte_ready_i && !(special && !escaped_q);
  assign word_ready_o = state_q == WORD;

  always_ff @(posedge clk_i) begin
    if (byte_valid_o && byte_ready_i) escaped_q <= special && !escaped_q;
    case (state_q)
      BEGIN: begin
        crc_q <= '1;
        if (step) state_q <= WORD;
      end

      WORD: begin
        word_q <= word_i;
        last_q <= word_last_i;
        if (word_valid_i) state_q <= BYTES;
      end

      BYTES:
      if (step) begin
        crc_q <= crc;
        word_q <= {8'd0, word_q[31:8]};
        if (index_q == 2'd3) begin
          state_q <= last_q ? CRC : WORD;
          if (last_q) word_q <= ~crc;
        end
      end

      CRC:
      if (step) begin
        word_q <= {8'd0, word_q[31:8]};
        if (index_q == 2'd3) state_q <= END;
      end

      default:  // END
      if (step) state_q <= BEGIN;
    endcase
    if (state_q == WORD) index_q <= 2'd0;
    else if (step) index_q <= index_q + 2'd1;
    if (!rst_ni) begin
      state_q <= BEGIN;
      escaped_q <= 1'b0;
    end
  end
endmodule
