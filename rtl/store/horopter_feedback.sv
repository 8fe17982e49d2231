// SPDX-License-Identifier: Apache-2.0
// Feedback of the contactors that safe_o switches: their mirror contacts, closed (feedback_i = 1) while all of them have
// dropped. So it must be the opposite of safe_o.
//
// bad_o: it was not for clocks_i clocks after a change of safe_o. A contactor whose contacts have welded together does not
// drop; a wire that broke says that it has not dropped, either. ready_o: they have dropped, so that safe_o may rise: else one
// that welds would not be seen where safe_o is low for a shorter time. clocks_i = 0: nothing is connected, never bad,
// always ready. feedback_i may come from another clock.
module horopter_feedback (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic [31:0] clocks_i,
    input  logic        safe_i,
    input  logic        feedback_i,
    output logic        ready_o,
    output logic        bad_o
);
  logic [1:0] dropped_q = 2'b00;  // two registers between clocks
  logic supervised_q = 1'b0, follows;
  logic [31:0] clocks_q = '0;
  logic [32:0] left_q = '0;  // clocks that they may still take, less one; negative when these are over
  assign follows = !supervised_q || dropped_q[1] != safe_i;
  always_ff @(posedge clk_i) begin
    dropped_q <= {dropped_q[0], feedback_i};
    clocks_q <= clocks_i;
    supervised_q <= rst_ni && clocks_q != 32'd0;
    left_q <= (follows ? {1'b0, clocks_q} : left_q) - 33'd1;  // the choice before the adder, see horopter_framer
    bad_o <= rst_ni && !follows && (bad_o || left_q[32]);
    ready_o <= rst_ni && (!supervised_q || dropped_q[1]);
  end
endmodule
