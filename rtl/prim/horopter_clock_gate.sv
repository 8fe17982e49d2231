// SPDX-License-Identifier: Apache-2.0
// The clock of modules that stand still while en_i = 0. They have clock enables of their own, which say the same: this
// only saves a simulator, which works at each edge of a clock, the time for them. In an FPGA clk_o is clk_i.
//
// en_i   changes with clk_i, or is constant. During reset it must be 1, or the modules are not reset.
module horopter_clock_gate (
    input  logic clk_i,
    input  logic en_i,
    output logic clk_o
);
`ifdef SYNTHESIS
  assign clk_o = clk_i;
  logic unused_en;
  assign unused_en = en_i;
`else
  logic en_q;
  always_latch if (!clk_i) en_q = en_i;
  assign clk_o = clk_i & en_q;
`endif
endmodule
