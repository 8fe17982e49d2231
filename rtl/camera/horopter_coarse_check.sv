// SPDX-License-Identifier: Apache-2.0
// The check of both cameras' images against each other (stage `coarse`) and against those before (stage `still`), on the
// means of their cells (stage `cells`).
//
// The cameras need not come at the same time: the cells of the one that is ahead wait in a memory for those of the other,
// at most those of the rows that the image stores hold, and of a row of cells more. Cells of one camera are at least 8 clocks
// apart, a pair takes less.
//
// judged_o: one clock, SETTLE clocks after both cameras were done with a frame (arrived_i), that of record judged_slot_o;
// what the check says comes with it. Nothing of the next frame is here by then: its first row of cells takes longer. A frame
// without a pair of cells says nothing. Settings are taken when it is open and the last one judged. rst_ni: of the streaming core.
module horopter_coarse_check (
    input  logic       clk_i,
    input  logic       rst_ni,
    // settings
    input  logic [7:0] one_camera_segments_i,
    input  logic [7:0] blind_step_i,
    input  logic [7:0] blind_share_i,
    input  logic [7:0] still_limit_i,
    // cells, index 0 = left
    input  logic [1:0] valid_i,
    input  logic [7:0] left_mean_i,
    input  logic [7:0] right_mean_i,
    input  logic [1:0] start_i,
    // frames
    input  logic       open_i,
    input  logic       slot_i,
    input  logic       arrived_i,
    output logic       judged_o,
    output logic       judged_slot_o,
    output logic       one_camera_o,
    output logic [1:0] blind_o,
    output logic [1:0] still_o
);
  localparam int unsigned CELL = horopter_profile_pkg::CELL;
  localparam int unsigned COLUMNS = horopter_profile_pkg::WIDTH / CELL;
  localparam int unsigned DEPTH = 2 ** $clog2((horopter_profile_pkg::STORE_ROWS / CELL + 2) * COLUMNS);  // cells that can wait
  localparam int unsigned ADDR_BITS = $clog2(DEPTH);
  localparam int unsigned SETTLE = 32;

  logic [7:0] one_camera_segments_q, blind_step_q, blind_share_q, still_limit_q;
  logic opened_q, settling;
  always_ff @(posedge clk_i) begin
    opened_q <= open_i || (opened_q && settling);
    if (opened_q && !settling) begin
      one_camera_segments_q <= one_camera_segments_i;
      blind_step_q <= blind_step_i;
      blind_share_q <= blind_share_i;
      still_limit_q <= still_limit_i;
    end
  end

  // --- pairs: one of three things in a clock ---
  logic clear;  // the frame is over
  (* nowrshmsk *) logic [1:0] held_q;  // a cell that has come; see horopter_frame_control
  logic [8:0] left_q, right_q;  // {start, mean}
  logic ahead_q;  // whose cells wait
  logic [ADDR_BITS-1:0] write_addr_q, read_addr_q;
  logic empty_q;  // as of the clock before. A word on its way in counts; after a pop nothing is decided for two clocks.
  logic meets, pushes, pops;
  logic pushed_q;  // a word is on its way into the memory
  logic [8:0] pushed_word_q;
  logic [1:0] reading_q;  // a word is on its way out of it
  logic [8:0] memory_word;
  logic ready, unused_parity;
  assign ready = reading_q == 2'b00 && !pushed_q;
  assign meets = held_q == 2'b11 && empty_q && ready;
  assign pops = held_q[!ahead_q] && !empty_q && ready;
  assign pushes = !meets && !pops && (empty_q ? held_q != 2'b00 : held_q[ahead_q]) && ready;

  horopter_ram #(
      .WIDTH(9),
      .DEPTH(DEPTH),
      .OUTPUT_REGISTER(1'b1)
  ) u_waiting (
      .clk_i(clk_i),
      .write_en_i(pushed_q),
      .write_addr_i(write_addr_q),
      .write_data_i(pushed_word_q),
      .read_en_i(pops),
      .read_addr_i(read_addr_q),
      .read_data_o(memory_word),
      .parity_error_o(unused_parity)
  );

  logic pair_valid_q, begun_q;
  logic [8:0] pair_left_q, pair_right_q;
  always_ff @(posedge clk_i) begin
    pair_valid_q <= 1'b0;
    reading_q <= {reading_q[0], pops};
    pushed_q <= pushes;
    pushed_word_q <= (empty_q ? held_q[1] : ahead_q) ? right_q : left_q;
    empty_q <= write_addr_q == read_addr_q && !pushed_q;
    if (meets || reading_q[1]) begin
      pair_valid_q <= 1'b1;
      pair_left_q <= meets || ahead_q ? left_q : memory_word;
      pair_right_q <= meets || !ahead_q ? right_q : memory_word;
      if (meets) held_q <= 2'b00;
      else held_q[!ahead_q] <= 1'b0;
    end
    if (pair_valid_q) begun_q <= 1'b1;
    if (pushes) begin
      if (empty_q) ahead_q <= held_q[1];
      held_q[empty_q ? held_q[1] : ahead_q] <= 1'b0;
    end
    if (pushed_q) write_addr_q <= write_addr_q + 1'b1;
    if (pops) read_addr_q <= read_addr_q + 1'b1;
    if (valid_i[0]) begin
      held_q[0] <= 1'b1;
      left_q <= {start_i[0], left_mean_i};
    end
    if (valid_i[1]) begin
      held_q[1] <= 1'b1;
      right_q <= {start_i[1], right_mean_i};
    end
    if (!rst_ni || clear) begin
      held_q <= 2'b00;
      reading_q <= 2'b00;
      pushed_q <= 1'b0;
      empty_q <= 1'b1;
      write_addr_q <= '0;
      read_addr_q <= '0;
      pair_valid_q <= 1'b0;
      begun_q <= 1'b0;
    end
  end
  logic unused_start;
  assign unused_start = pair_right_q[8];  // that of the left image, as pairs have the same place

  logic coarse_valid, coarse_one_camera;
  logic [1:0] coarse_blind;
  horopter_coarse u_coarse (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .en_i(1'b1),
      .valid_i(pair_valid_q),
      .left_i(pair_left_q[7:0]),
      .right_i(pair_right_q[7:0]),
      .first_i(!begun_q),
      .start_i(pair_left_q[8]),
      .cfg_one_camera_segments_i(one_camera_segments_q),
      .cfg_blind_step_i(blind_step_q),
      .cfg_blind_share_i(blind_share_q),
      .valid_o(coarse_valid),
      .one_camera_o(coarse_one_camera),
      .left_blind_o(coarse_blind[0]),
      .right_blind_o(coarse_blind[1])
  );

  logic still_valid;
  logic [1:0] still;
  horopter_still u_still (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .en_i(1'b1),
      .valid_i(pair_valid_q),
      .left_i(pair_left_q[7:0]),
      .right_i(pair_right_q[7:0]),
      .first_i(!begun_q),
      .cfg_still_limit_i(still_limit_q),
      .valid_o(still_valid),
      .left_still_o(still[0]),
      .right_still_o(still[1])
  );

  // --- the frame's end ---
  logic [$clog2(SETTLE):0] settle_q;  // counts down, its highest bit says that it does
  assign clear = judged_o;
  assign settling = settle_q[$clog2(SETTLE)];
  always_ff @(posedge clk_i) begin
    judged_o <= rst_ni && settle_q == ($clog2(SETTLE) + 1)'(SETTLE);
    if (!rst_ni) settle_q <= '0;
    else if (arrived_i) settle_q <= '1;
    else if (settling) settle_q <= settle_q - 1'b1;
    if (arrived_i) judged_slot_o <= slot_i;
    if (!rst_ni || clear) {one_camera_o, blind_o} <= 3'b000;
    else if (coarse_valid) {one_camera_o, blind_o} <= {coarse_one_camera, coarse_blind};
    if (!rst_ni || clear) still_o <= 2'b00;
    else if (still_valid) still_o <= still;
  end
endmodule
