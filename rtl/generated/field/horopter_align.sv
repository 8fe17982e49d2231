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
  logic [8:0] sum_37;
  assign sum_37 = cfg_width_i + 9'h1ff;

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
  // hls/stages/align.hpp:71
  logic and_26;
  assign and_26 = (~and_18) & (equal_21 & equal_24);
  // hls/stages/align.hpp:80
  logic or_27;
  assign or_27 = (active_q & not_16) | and_26;
  logic select_29;
  assign select_29 = and_26 ? (cfg_height_i == 9'h1) : final_row_q;
  logic and_31;
  assign and_31 = last_q & (~and_26);
  // hls/stages/align.hpp:85
  logic and_32;
  assign and_32 = or_27 & and_31;
  logic and_33;
  assign and_33 = select_29 & and_32;
  // hls/stages/align.hpp:80
  logic [8:0] select_38;
  assign select_38 = and_26 ? sum_37 : columns_left_q;
  logic [8:0] select_42;
  assign select_42 = and_26 ? (cfg_height_i + 9'h1ff) : rows_left_q;
  // hls/stages/align.hpp:102
  logic not_46;
  assign not_46 = ~equal_21;
  // hls/stages/align.hpp:100
  logic not_49;
  assign not_49 = ~equal_24;
  // hls/stages/align.hpp:67
  logic and_55;
  assign and_55 = idle_q & not_16;

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
      active_q <= or_27 & (~and_33);
      idle_q <= and_33;
      last_q <= (~and_31) & (select_38 == 9'h1);
      final_row_q <= and_31 ? (select_42 == 9'h1) : select_29;
      started_q <= and_18 | and_26;
      row_ended_q <= marks_last_i;
      rows_q <= marks_last_i ? (select_20 + {3'h0, not_46}) : select_20;
      columns_q <= select_23 + {3'h0, not_49};
      columns_left_q <= and_31 ? sum_37 : (select_38 + 9'h1ff);
      rows_left_q <= and_31 ? (select_42 + 9'h1ff) : select_42;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = state_i;
  assign first_o = and_26;
  assign last_o = and_32;
  assign end_v_o = and_33;
  assign idle_o = and_55;
  assign valid_o = valid_i & (and_55 | or_27);

endmodule
