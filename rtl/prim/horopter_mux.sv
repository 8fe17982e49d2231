// SPDX-License-Identifier: Apache-2.0
// Multiplexer: word number select_i of COUNT; combinational. A number beyond the last selects an undefined word.
// rtl/prim/ecp5 has the same in cells of the ECP5, whose multiplexers synthesis does not find by itself.
module horopter_mux #(
    parameter int unsigned WIDTH = 2,
    parameter int unsigned COUNT = 8,
    parameter int unsigned SELECT_BITS = COUNT > 1 ? $clog2(COUNT) : 1
) (
    input  logic [  SELECT_BITS-1:0] select_i,
    input  logic [COUNT*WIDTH-1:0] words_i,
    output logic [      WIDTH-1:0] word_o
);
  always_comb begin
    word_o = 'x;
    for (int unsigned i = 0; i < COUNT; i++) if (select_i == SELECT_BITS'(i)) word_o = words_i[i*WIDTH+:WIDTH];
  end
endmodule
