// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Align<horopter::hls::profiles::field>, hls/stages/align.hpp. Do not edit.
//
// Latency 0 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// Outputs are logic: what they go to takes them with the clock if en_i = 1.
// State 32 bits, pipeline 0 bits, memories 0 bits.
module horopter_align (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [8:0] cfg_width_i,
  input  logic [8:0] cfg_height_i,
  output logic valid_o,
  output logic [1:0] state_o,
  output logic first_o,
  output logic last_o,
  output logic end_v_o,
  output logic idle_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic active_q;
  logic idle_q;
  logic last_q;
  logic final_row_q;
  logic started_q;
  logic row_ended_q;
  logic [3:0] rows_q;
  logic [3:0] columns_q;
  logic [8:0] columns_left_q;
  logic [8:0] rows_left_q;
  // hls/stages/align.hpp:67
  logic not_16;
  assign not_16 = ~marks_first_i;
  logic and_17;
  assign and_17 = active_q & not_16;
  logic and_18;
  assign and_18 = started_q & not_16;
  logic [3:0] select_20;
  assign select_20 = marks_first_i ? 4'h0 : rows_q;
  // hls/stages/align.hpp:70
  logic equal_21;
  assign equal_21 = select_20 == 4'h9;
  logic [3:0] select_23;
  assign select_23 = marks_first_i ? 4'h0 : (row_ended_q ? 4'h0 : columns_q);
  logic equal_24;
  assign equal_24 = select_23 == 4'h9;
  // hls/stages/align.hpp:72
  logic and_25;
  assign and_25 = equal_21 & equal_24;
  logic and_26;
  assign and_26 = (~and_18) & and_25;
  // hls/stages/align.hpp:74
  logic or_27;
  assign or_27 = and_17 | and_26;
  // hls/stages/align.hpp:77
  logic and_28;
  assign and_28 = last_q & and_17;
  logic and_29;
  assign and_29 = final_row_q & and_28;
  // hls/stages/align.hpp:97
  logic select_36;
  assign select_36 = and_26 ? (cfg_width_i == 9'h2) : ((~last_q) & (columns_left_q == 9'h2));
  logic select_40;
  assign select_40 = and_26 ? (cfg_height_i == 9'h1) : (last_q ? (rows_left_q == 9'h2) : final_row_q);
  // hls/stages/align.hpp:100
  logic not_42;
  assign not_42 = ~equal_21;
  // hls/stages/align.hpp:98
  logic not_45;
  assign not_45 = ~equal_24;
  // hls/stages/align.hpp:97
  logic [8:0] select_50;
  assign select_50 = and_26 ? (cfg_width_i + 9'h1ff) : (last_q ? cfg_width_i : (columns_left_q + 9'h1ff));
  logic [8:0] select_53;
  assign select_53 = and_26 ? cfg_height_i : (last_q ? (rows_left_q + 9'h1ff) : rows_left_q);
  // hls/stages/align.hpp:67
  logic and_54;
  assign and_54 = idle_q & not_16;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      idle_q <= 1'b0;
      last_q <= 1'b0;
      final_row_q <= 1'b0;
      started_q <= 1'b1;
      row_ended_q <= 1'b1;
      rows_q <= 4'h0;
      columns_q <= 4'h0;
      columns_left_q <= 9'h0;
      rows_left_q <= 9'h0;
    end else if (s0_en) begin
      active_q <= or_27 & (~and_29);
      idle_q <= and_29;
      last_q <= select_36;
      final_row_q <= select_40;
      started_q <= and_18 | and_25;
      row_ended_q <= marks_last_i;
      rows_q <= marks_last_i ? (select_20 + {3'h0, not_42}) : select_20;
      columns_q <= select_23 + {3'h0, not_45};
      columns_left_q <= select_50;
      rows_left_q <= select_53;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = state_i;
  assign first_o = and_26;
  assign last_o = and_28;
  assign end_v_o = and_29;
  assign idle_o = and_54;
  assign valid_o = valid_i & (and_54 | or_27);

endmodule
