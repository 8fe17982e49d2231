// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Align<horopter::hls::profiles::field>, hls/stages/align.hpp. Do not edit.
//
// Latency 0 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
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
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  input  logic [8:0] cfg_width_i,
  input  logic [8:0] cfg_height_i,
  output logic valid_o,
  output logic [1:0] state_o,
  output logic first_o,
  output logic last_o,
  output logic end_v_o,
  output logic idle_o,
  output logic hidden_o,
  output logic unproven_o
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
  // hls/stages/align.hpp:72
  logic not_18;
  assign not_18 = ~marks_first_i;
  logic and_19;
  assign and_19 = active_q & not_18;
  logic and_20;
  assign and_20 = started_q & not_18;
  logic [3:0] select_22;
  assign select_22 = marks_first_i ? 4'h0 : rows_q;
  // hls/stages/align.hpp:75
  logic equal_23;
  assign equal_23 = select_22 == 4'h9;
  logic [3:0] select_25;
  assign select_25 = marks_first_i ? 4'h0 : (row_ended_q ? 4'h0 : columns_q);
  logic equal_26;
  assign equal_26 = select_25 == 4'h9;
  // hls/stages/align.hpp:77
  logic and_27;
  assign and_27 = equal_23 & equal_26;
  logic and_28;
  assign and_28 = (~and_20) & and_27;
  // hls/stages/align.hpp:82
  logic or_29;
  assign or_29 = and_19 | and_28;
  // hls/stages/align.hpp:85
  logic and_30;
  assign and_30 = last_q & and_19;
  logic and_31;
  assign and_31 = final_row_q & and_30;
  // hls/stages/align.hpp:95
  logic not_34;
  assign not_34 = ~and_28;
  // hls/stages/align.hpp:107
  logic not_43;
  assign not_43 = ~equal_23;
  // hls/stages/align.hpp:105
  logic not_46;
  assign not_46 = ~equal_26;
  // hls/stages/align.hpp:104
  logic [8:0] select_51;
  assign select_51 = and_28 ? (cfg_width_i + 9'h1ff) : (last_q ? cfg_width_i : (columns_left_q + 9'h1ff));
  logic [8:0] select_54;
  assign select_54 = and_28 ? cfg_height_i : (last_q ? (rows_left_q + 9'h1ff) : rows_left_q);
  // hls/stages/align.hpp:77
  logic equal_55;
  assign equal_55 = state_i == 2'h0;
  // hls/stages/align.hpp:79
  logic and_56;
  assign and_56 = marks_nearer_i & equal_55;
  // hls/stages/align.hpp:81
  logic and_58;
  assign and_58 = equal_55 & (~marks_seen_i);
  // hls/stages/align.hpp:72
  logic and_61;
  assign and_61 = idle_q & not_18;

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
      active_q <= or_29 & (~and_31);
      idle_q <= and_31;
      last_q <= not_34 & ((~last_q) & (columns_left_q == 9'h2));
      final_row_q <= not_34 & (last_q ? (rows_left_q == 9'h2) : final_row_q);
      started_q <= and_20 | and_27;
      row_ended_q <= marks_last_i;
      rows_q <= marks_last_i ? (select_22 + {3'h0, not_43}) : select_22;
      columns_q <= select_25 + {3'h0, not_46};
      columns_left_q <= select_51;
      rows_left_q <= select_54;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = (and_56 | and_58) ? 2'h2 : state_i;
  assign first_o = and_28;
  assign last_o = and_30;
  assign end_v_o = and_31;
  assign idle_o = and_61;
  assign hidden_o = and_56;
  assign unproven_o = and_58;
  assign valid_o = valid_i & (and_61 | or_29);

endmodule
