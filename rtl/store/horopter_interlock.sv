// SPDX-License-Identifier: Apache-2.0
// Restart interlock: after an alarm, a fault, and at start, safe_o stays low until somebody has said restart. Who crossed
// a thin skin may stand behind it, and the frames after that are good again.
//
// A restart is a press of restart_i (settings_i.by_pin) or the key written to a register (settings_i.by_register). It is
// accepted only when the last settings_i.frames published frames, at least one, were good and nothing was wrong since.
// Otherwise it is forgotten. A press counts when it ends, and only if a frame was published while it lasted: so a button
// that bounces gives one restart, and one that is held, or a broken wire, gives none. Nor does a press during which
// something is wrong: who pressed did not know of it. One that is held for 255 published frames is a fault, stuck_o, with
// each frame until it is let go. restart_i may come from another clock.
//
// released_o = 1: restarted, and good since. held_o is its opposite, decided and stored on its own. settings_i.by_itself:
// no restart is needed. waiting_o: a restart would be accepted. Reset: held.
module horopter_interlock (
    input  logic clk_i,
    input  logic rst_ni,
    input  horopter_csr_pkg::interlock_t settings_i,
    input  logic restart_i,
    input  logic restart_written_i,  // the key was written
    input  logic published_i,  // a frame; good_i says whether it was
    input  logic good_i,
    input  logic bad_now_i,
    output logic released_o,
    output logic held_o,
    output logic waiting_o,
    output logic stuck_o
);
  logic [2:0] restart_q = 3'b000;  // two registers between clocks, one for the edge
  always_ff @(posedge clk_i) restart_q <= {restart_q[1:0], restart_i};

  logic [7:0] held_frames_q;  // published while it was pressed; 0 where the pin is not asked
  logic pressed, request, let_go;
  // Both a clock late. A restart that bad_q takes back lasts a clock; in it safe_o is low, as it asks bad_now_i itself.
  logic bad_q, published_q;
  logic spoiled_q;  // something was wrong during this press; after reset until the button is let go
  assign pressed = restart_q[1];
  assign let_go = !pressed && !restart_q[2];
  always_ff @(posedge clk_i) begin
    bad_q <= bad_now_i || (published_i && !good_i);
    published_q <= rst_ni && published_i;
  end
  assign request = (restart_q[2] && !pressed && held_frames_q != 8'd0 && !stuck_o && !spoiled_q)
      || (settings_i.by_register && restart_written_i);
  assign stuck_o = held_frames_q == 8'hFF;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || !settings_i.by_pin || let_go) held_frames_q <= 8'd0;
    else if (published_i && !stuck_o) held_frames_q <= held_frames_q + 8'd1;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) spoiled_q <= 1'b1;
    else spoiled_q <= !let_go && (spoiled_q || bad_q);
  end

  logic [3:0] good_frames_q;
  logic enough;
  assign enough = good_frames_q != 4'd0 && good_frames_q >= settings_i.frames;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || bad_q) good_frames_q <= 4'd0;
    else if (published_q && good_frames_q != 4'hF) good_frames_q <= good_frames_q + 4'd1;
  end

  logic released_q = 1'b0, held_q = 1'b1;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || bad_q) released_q <= 1'b0;
    else if (request && enough) released_q <= 1'b1;
  end
  // The same, said the other way round and stored again.
  always_ff @(posedge clk_i) begin
    if (!rst_ni || bad_q) held_q <= 1'b1;
    else if (request && enough) held_q <= 1'b0;
  end
  assign released_o = released_q || settings_i.by_itself;
  assign held_o = held_q && !settings_i.by_itself;
  assign waiting_o = held_o && enough && !bad_q;
endmodule
