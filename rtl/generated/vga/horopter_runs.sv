// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Runs<horopter::hls::profiles::vga>, hls/stages/runs.hpp. Do not edit.
//
// Latency 0 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// Outputs are logic: what they go to takes them with the clock if en_i = 1.
// State 43 bits, pipeline 0 bits, memories 0 bits.
module horopter_runs (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic first_i,
  input  logic last_i,
  input  logic idle_i,
  output logic valid_o,
  output logic [8:0] row_o,
  output logic [9:0] start_o,
  output logic [9:0] end_v_o,
  output logic [1:0] state_o,
  output logic last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic open_q;
  logic row_ended_q;
  logic [8:0] row_q;
  logic [9:0] start_q;
  logic [9:0] end_v_q;
  logic [9:0] next_q;
  logic [1:0] state_q;
  // hls/stages/runs.hpp:35
  logic or_13;
  assign or_13 = first_i | row_ended_q;
  // hls/stages/runs.hpp:44
  logic or_20;
  assign or_20 = or_13 | (idle_i | (~(state_i == state_q)));
  // hls/stages/runs.hpp:35
  logic [9:0] x;
  assign x = or_13 ? 10'h0 : next_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      open_q <= 1'b0;
      row_ended_q <= 1'b1;
      row_q <= 9'h0;
      start_q <= 10'h0;
      end_v_q <= 10'h0;
      next_q <= 10'h0;
      state_q <= 2'h0;
    end else if (s0_en) begin
      open_q <= ~idle_i;
      row_ended_q <= last_i;
      row_q <= first_i ? 9'h0 : (or_13 ? (row_q + 9'h1) : row_q);
      start_q <= or_20 ? x : start_q;
      end_v_q <= x;
      next_q <= x + 10'h1;
      state_q <= or_20 ? state_i : state_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign row_o = row_q;
  assign start_o = start_q;
  assign end_v_o = end_v_q;
  assign state_o = state_q;
  assign last_o = idle_i;
  assign valid_o = valid_i & (or_20 & (open_q & (~first_i)));

endmodule
