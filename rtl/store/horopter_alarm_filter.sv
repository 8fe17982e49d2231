// SPDX-License-Identifier: Apache-2.0
// In how many frames an alarm must be seen until it counts (thesis 5.2; the multiple sampling of laser scanners): in
// settings_i.needed of the last settings_i.of, this one among them; 0 is as 1, and fewer than `needed` as `needed`.
//
// A frame with a fault shows nothing of what is there, so it and all before it count as frames in which an alarm was
// seen; so do those before the start, and those that did not come, gap_i. So the first frame after them that shows an alarm is one.
//
// counts_o = 1: what this frame shows is an alarm, passes_o is its opposite, decided and stored on its own. Both are of the
// frame that began, decide_i some clocks later: what the frame before has shown must be known. raw_i: it counts whatever
// was seen before.
module horopter_alarm_filter (
    input  logic clk_i,
    input  logic rst_ni,
    input  horopter_csr_pkg::alarm_frames_t settings_i,
    input  logic gap_i,
    input  logic published_i,  // a frame; seen_i and faulty_i are of it
    input  logic seen_i,
    input  logic faulty_i,
    input  logic decide_i,  // at least three clocks after published_i
    input  logic raw_i,
    output logic counts_o,
    output logic passes_o
);
  localparam int unsigned MOST = 6;  // frames before this one that may count
  logic published_q, seen_q, faulty_q;
  logic [MOST-1:0] history_q, of_these;  // the last frame in bit 0
  logic [2:0] shown, of_q;
  logic enough_q, too_few_q;
  always_comb begin
    for (int unsigned i = 0; i < MOST; i++) of_these[i] = history_q[i] && 32'(of_q) > i + 1;
    shown = 3'd0;
    for (int unsigned i = 0; i < MOST; i++) shown = shown + 3'(of_these[i]);
  end
  always_ff @(posedge clk_i) begin
    published_q <= rst_ni && !gap_i && published_i;
    seen_q <= seen_i;
    faulty_q <= faulty_i;
    if (!rst_ni || gap_i || (published_q && faulty_q)) history_q <= '1;
    else if (published_q) history_q <= {history_q[MOST-2:0], seen_q};
    of_q <= settings_i.of > settings_i.needed ? settings_i.of : settings_i.needed;
    enough_q <= 4'(shown) + 4'd1 >= 4'(settings_i.needed);
    too_few_q <= 4'(shown) + 4'd1 < 4'(settings_i.needed);
  end

  logic counts_q = 1'b1, passes_q = 1'b0;  // before the first clock, too
  always_ff @(posedge clk_i) begin
    if (!rst_ni || gap_i) counts_q <= 1'b1;
    else if (decide_i) counts_q <= enough_q || raw_i;
  end
  // The same, said the other way round and stored again.
  always_ff @(posedge clk_i) begin
    if (!rst_ni || gap_i) passes_q <= 1'b0;
    else if (decide_i) passes_q <= too_few_q && !raw_i;
  end
  assign counts_o = counts_q;
  assign passes_o = passes_q;
endmodule
