// SPDX-License-Identifier: Apache-2.0
// Comparisons of unsigned numbers with a constant in look-up tables: a third of the carry cells that yosys takes for them.
(* techmap_celltype = "$lt $le $gt $ge" *)
module _compare_constant (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  parameter _TECHMAP_CELLTYPE_ = "";
  parameter [A_WIDTH-1:0] _TECHMAP_CONSTMSK_A_ = 0;
  parameter [B_WIDTH-1:0] _TECHMAP_CONSTMSK_B_ = 0;
  localparam WIDTH = A_WIDTH > B_WIDTH ? A_WIDTH : B_WIDTH;
  localparam SWAP = _TECHMAP_CELLTYPE_ == "$gt" || _TECHMAP_CELLTYPE_ == "$ge";
  localparam EQUAL = _TECHMAP_CELLTYPE_ == "$le" || _TECHMAP_CELLTYPE_ == "$ge";
  wire _TECHMAP_FAIL_ = A_SIGNED != 0 || B_SIGNED != 0 || !(&_TECHMAP_CONSTMSK_A_ || &_TECHMAP_CONSTMSK_B_);
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;
  wire [WIDTH-1:0] less = SWAP ? B : A;
  wire [WIDTH-1:0] more = SWAP ? A : B;
  wire [WIDTH:0] so_far;
  assign so_far[0] = EQUAL;
  genvar i;
  generate
    for (i = 0; i < WIDTH; i = i + 1) begin : g_bit
      assign so_far[i+1] = less[i] == more[i] ? so_far[i] : more[i];
    end
  endgenerate
  assign Y = so_far[WIDTH];
endmodule
