// SPDX-License-Identifier: Apache-2.0
// Carries from bit to bit: the smallest adder, and fast enough at 30 MHz. yosys's own choice is a tree of carries.
(* techmap_celltype = "$lcu" *)
module _ripple_lcu (P, G, CI, CO);
  parameter WIDTH = 1;
  input [WIDTH-1:0] P, G;
  input CI;
  output [WIDTH-1:0] CO;
  wire [WIDTH:0] carry = {CO, CI};
  genvar i;
  generate
    for (i = 0; i < WIDTH; i = i + 1) begin : g_bit
      assign CO[i] = G[i] | (P[i] & carry[i]);
    end
  endgenerate
endmodule
