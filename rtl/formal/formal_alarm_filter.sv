// SPDX-License-Identifier: Apache-2.0
// horopter_alarm_filter: a frame counts when so many of the last ones show an alarm with it, against a count of them all;
// after a frame with a fault, one that did not come, and at start always; and nothing changes within a frame but to that.
module formal_alarm_filter (
    input logic clk_i,
    input logic rst_ni,
    input horopter_csr_pkg::alarm_frames_t settings,
    input logic gap,
    input logic published,
    input logic seen,
    input logic faulty,
    input logic decide,
    input logic raw
);
  logic counts, passes;
  horopter_alarm_filter dut (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .settings_i(settings),
      .gap_i(gap),
      .published_i(published),
      .seen_i(seen),
      .faulty_i(faulty),
      .decide_i(decide),
      .raw_i(raw),
      .counts_o(counts),
      .passes_o(passes)
  );
  logic past_valid = 1'b0, expected = 1'b1;
  horopter_csr_pkg::alarm_frames_t past_settings;
  logic [6:0] history = '1;  // with the frame before in bit 1, as if this one showed an alarm
  logic [1:0] quiet = 2'd0;  // clocks since something changed
  logic [2:0] of, shown;
  assign of = settings.of > settings.needed ? settings.of : settings.needed;
  always_comb begin
    shown = 3'd1;
    for (int i = 1; i < 7; i++) if (history[i] && 32'(of) > 32'(i)) shown = shown + 3'd1;
  end
  always @(posedge clk_i) begin
    past_valid <= 1'b1;
    past_settings <= settings;
    quiet <= !rst_ni || gap || published ? 2'd0 : quiet == 2'd3 ? 2'd3 : quiet + 2'd1;
    if (!rst_ni || gap || (published && faulty)) history <= '1;
    else if (published) history <= {history[5:1], seen, 1'b1};
    if (!rst_ni || gap) expected <= 1'b1;
    else if (decide) expected <= raw || shown >= settings.needed;
  end
  always @(*) begin
    if (!past_valid) assume (!rst_ni);
    if (past_valid) assume (settings == past_settings);
    if (quiet < 2'd3) assume (!decide);
    if (past_valid) begin
      assert (counts == expected);
      assert (passes == !expected);
      if (settings.needed <= 3'd1) assert (counts);
    end
    cover (passes && settings.needed == 3'd7);
    cover (counts && settings.needed == 3'd2 && settings.of == 3'd3 && history == 7'b0000101);
  end
endmodule
