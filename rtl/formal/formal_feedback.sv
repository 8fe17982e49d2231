// SPDX-License-Identifier: Apache-2.0
// horopter_feedback: what does not follow for longer than it may is bad, and what follows never is; ready only while dropped.
module formal_feedback (
    input logic        clk_i,
    input logic        rst_ni,
    input logic [31:0] clocks,
    input logic        safe,
    input logic        feedback
);
  logic ready, bad;
  horopter_feedback dut (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .clocks_i(clocks),
      .safe_i(safe),
      .feedback_i(feedback),
      .ready_o(ready),
      .bad_o(bad)
  );
  localparam int unsigned CLOCKS = 5;
  logic past_valid = 1'b0;
  logic [31:0] past_clocks = 32'd0;  // as clocks_q has: yosys makes one register of the two
  logic [2:0] past_feedback = 3'b000;  // the newest in bit 0
  logic [1:0] past_safe = 2'b00;
  logic [3:0] wrong = 4'd0, right = 4'd0;  // clocks in a row in which the pins, two clocks late, did not, did follow
  logic [3:0] since_reset = 4'd0;
  always @(posedge clk_i) begin
    past_valid <= 1'b1;
    past_clocks <= clocks;
    past_feedback <= {past_feedback[1:0], feedback};
    past_safe <= {past_safe[0], safe};
    since_reset <= !rst_ni ? 4'd0 : since_reset == 4'd15 ? 4'd15 : since_reset + 4'd1;
    if (!rst_ni || !past_valid || past_feedback[1] != safe) wrong <= 4'd0;
    else if (wrong != 4'd15) wrong <= wrong + 4'd1;
    if (!rst_ni || past_feedback[1] == safe) right <= 4'd0;
    else if (right != 4'd15) right <= right + 4'd1;
  end
  always @(*) begin
    assume (clocks == 32'd0 || clocks == CLOCKS);
    if (past_valid) assume (clocks == past_clocks);
    if (since_reset > 4'd3) begin
      if (clocks != 32'd0 && wrong > 4'(CLOCKS + 1)) assert (bad);
      if (clocks == 32'd0 || wrong < 4'(CLOCKS)) assert (!bad);
      if (clocks != 32'd0) assert (ready == past_feedback[2]);
      else assert (ready);
    end
    cover (bad);
    cover (ready && !bad && since_reset > 4'd10);
  end
endmodule
