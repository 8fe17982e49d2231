// SPDX-License-Identifier: Apache-2.0
// In place of horopter_ram where a proof must not depend on what a memory holds: it reads anything.
module horopter_ram #(
    parameter int unsigned WIDTH = 8,
    parameter int unsigned DEPTH = 1024,
    parameter bit PARITY = 1'b0,
    parameter bit OUTPUT_REGISTER = 1'b0,
    parameter bit FAST = 1'b0,
    parameter bit ODD = 1'b0,
    parameter bit STEADY = 1'b0,
    parameter int unsigned ADDR_BITS = DEPTH > 1 ? $clog2(DEPTH) : 1
) (
    input  logic                 clk_i,
    input  logic                 write_en_i,
    input  logic [ADDR_BITS-1:0] write_addr_i,
    input  logic [    WIDTH-1:0] write_data_i,
    input  logic                 read_en_i,
    input  logic [ADDR_BITS-1:0] read_addr_i,
    output logic [    WIDTH-1:0] read_data_o,
    output logic                 parity_error_o
);
  (* anyseq *) logic [WIDTH-1:0] anything;
  assign read_data_o = anything;
  assign parity_error_o = 1'b0;
endmodule
