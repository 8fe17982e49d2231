// SPDX-License-Identifier: Apache-2.0
// A second copy of a place in a ring of rows, inverted and counted down, so that one upset bit of either shows.
module horopter_place_copy #(
    parameter int unsigned ROWS = 64,
    parameter int unsigned SLOT_BITS = $clog2(ROWS)
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    input  logic                 begin_i,  // the place is base_slot_i from the next clock on
    input  logic [SLOT_BITS-1:0] base_slot_i,
    input  logic                 step_i,  // the next row; rows are longer than a clock
    input  logic [SLOT_BITS-1:0] slot_i,  // the first copy
    output logic                 error_o
);
  logic [SLOT_BITS-1:0] not_slot_q;
  logic wraps_q;
  assign error_o = slot_i != ~not_slot_q;
  always_ff @(posedge clk_i) begin
    wraps_q <= not_slot_q == ~SLOT_BITS'(ROWS - 1);
    if (!rst_ni) not_slot_q <= '1;
    else if (begin_i) not_slot_q <= ~base_slot_i;
    else if (step_i) not_slot_q <= wraps_q ? '1 : not_slot_q - 1'b1;
  end
endmodule
