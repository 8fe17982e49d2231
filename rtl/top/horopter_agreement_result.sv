// SPDX-License-Identifier: Apache-2.0
// What the stage `agreement` said of a frame, for the registers: its words, and the pixels that were not clear because of it.
// The words come before the frame is published.
module horopter_agreement_result #(
    parameter int unsigned COUNT_BITS = 18
) (
    input  logic                  clk_i,
    input  logic                  prove_i,  // else nothing is said
    input  logic                  word_valid_i,
    input  logic [           5:0] index_i,  // stages/agreement.hpp, FrameWord
    input  logic [          31:0] word_i,
    // pixels of the result
    input  logic                  state_valid_i,
    input  logic                  state_first_i,
    input  logic                  undecidable_i,  // with those of the next two
    input  logic                  hidden_i,
    input  logic                  unproven_pixel_i,
    input  logic                  counts_valid_i,
    input  logic [COUNT_BITS-1:0] undecidable_limit_i,
    output logic [COUNT_BITS-1:0] undecidable_o,  // with counts_valid_i
    output logic                  too_undecidable_o,  // more than 19/16 of the limit: of 80 %, 95 %
    // registers
    input  logic [           5:0] region_select_i,
    input  logic [          11:0] read_addr_i,
    output logic [          31:0] word_o,  // two clocks after read_addr_i: FRAME_REGION, FRAME_AGREEMENT … FRAME_PATCHES
    output logic [          23:0] frame_hidden_o,
    output logic [          23:0] frame_unproven_pixels_o
);
  // FRAME_REGION is at 0x19C, FRAME_AGREEMENT at 0x150: the word of index 52.
  (* ram_style = "distributed" *)
  logic [31:0] words[64];
  logic [5:0] index_q;
  logic unused_addr;
  assign unused_addr = ^{read_addr_i[11:8], read_addr_i[6], read_addr_i[1:0]};
  logic [COUNT_BITS-1:0] hidden_q, unproven_q;
  // A skin behind everything is hidden almost everywhere: too little is decided for a frame that is safe.
  logic [COUNT_BITS:0] limit_q;
  always_ff @(posedge clk_i) begin
    if (word_valid_i) words[index_i] <= prove_i ? word_i : '0;
    index_q <= read_addr_i[7] ? region_select_i : {2'b11, read_addr_i[5:2]};
    word_o <= words[index_q];
    limit_q <= {1'b0, undecidable_limit_i} + {1'b0, undecidable_limit_i >> 3} + {1'b0, undecidable_limit_i >> 4};
    if (state_valid_i) begin
      undecidable_o <= (state_first_i ? '0 : undecidable_o) + COUNT_BITS'(undecidable_i);
      too_undecidable_o <= (!state_first_i && too_undecidable_o)
          || (undecidable_i && {1'b0, state_first_i ? '0 : undecidable_o} >= limit_q);
      hidden_q <= (state_first_i ? '0 : hidden_q) + COUNT_BITS'(hidden_i);
      unproven_q <= (state_first_i ? '0 : unproven_q) + COUNT_BITS'(unproven_pixel_i);
    end
    if (counts_valid_i) begin
      frame_hidden_o <= 24'(hidden_q);
      frame_unproven_pixels_o <= 24'(unproven_q);
    end
  end
endmodule
