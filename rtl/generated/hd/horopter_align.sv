// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Align<horopter::hls::profiles::hd>, hls/stages/align.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 36 bits, pipeline 11 bits, memories 0 bits.
module horopter_align (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [10:0] cfg_width_i,
  input  logic [10:0] cfg_height_i,
  input  logic cfg_compete_i,
  output logic valid_o,
  output logic [1:0] state_o,
  output logic first_o,
  output logic last_o,
  output logic end_v_o,
  output logic idle_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Of the configuration alone: not pipelined.
  logic columns;
  assign columns = ~cfg_compete_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic started_q;
  logic row_ended_q;
  logic [3:0] rows_q;
  logic [3:0] columns_q;
  // hls/stages/align.hpp:67
  logic not_17;
  assign not_17 = ~marks_first_i;
  logic and_19;
  assign and_19 = started_q & not_17;
  logic [3:0] select_21;
  assign select_21 = marks_first_i ? 4'h0 : rows_q;
  // hls/stages/align.hpp:70
  logic equal_22;
  assign equal_22 = {select_21[3], cfg_compete_i, select_21[1:0]} == {1'b1, select_21[2], 2'h1};
  logic [3:0] select_25;
  assign select_25 = marks_first_i ? 4'h0 : (row_ended_q ? 4'h0 : columns_q);
  logic equal_26;
  assign equal_26 = {columns, select_25[2:1], columns} == {select_25[3], 2'h0, select_25[0]};
  // hls/stages/align.hpp:72
  logic and_27;
  assign and_27 = equal_22 & equal_26;
  // hls/stages/align.hpp:100
  logic not_44;
  assign not_44 = ~equal_22;
  // hls/stages/align.hpp:98
  logic not_47;
  assign not_47 = ~equal_26;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      started_q <= 1'b1;
      row_ended_q <= 1'b1;
      rows_q <= 4'h0;
      columns_q <= 4'h0;
    end else if (s0_en) begin
      started_q <= and_19 | and_27;
      row_ended_q <= marks_last_i;
      rows_q <= marks_last_i ? (select_21 + {3'h0, not_44}) : select_21;
      columns_q <= select_25 + {3'h0, not_47};
    end
  end

  logic [1:0] state_s1_q;
  logic not_17_s1_q;
  logic and_28_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      state_s1_q <= state_i;
      not_17_s1_q <= not_17;
      and_28_s1_q <= (~and_19) & and_27;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic active_q;
  logic idle_q;
  logic last_q;
  logic final_row_q;
  logic [10:0] columns_left_q;
  logic [10:0] rows_left_q;
  // hls/stages/align.hpp:67
  logic and_18;
  assign and_18 = active_q & not_17_s1_q;
  // hls/stages/align.hpp:74
  logic or_29;
  assign or_29 = and_18 | and_28_s1_q;
  // hls/stages/align.hpp:77
  logic and_30;
  assign and_30 = last_q & and_18;
  logic and_31;
  assign and_31 = final_row_q & and_30;
  // hls/stages/align.hpp:97
  logic select_38;
  assign select_38 = and_28_s1_q ? (cfg_width_i == 11'h2) : ((~last_q) & (columns_left_q == 11'h2));
  logic select_42;
  assign select_42 = and_28_s1_q ? (cfg_height_i == 11'h1) : (last_q ? (rows_left_q == 11'h2) : final_row_q);
  logic [10:0] select_52;
  assign select_52 = and_28_s1_q ? (cfg_width_i + 11'h7ff) : (last_q ? cfg_width_i : (columns_left_q + 11'h7ff));
  logic [10:0] select_55;
  assign select_55 = and_28_s1_q ? cfg_height_i : (last_q ? (rows_left_q + 11'h7ff) : rows_left_q);
  // hls/stages/align.hpp:67
  logic and_56;
  assign and_56 = idle_q & not_17_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      idle_q <= 1'b0;
      last_q <= 1'b0;
      final_row_q <= 1'b0;
      columns_left_q <= 11'h0;
      rows_left_q <= 11'h0;
    end else if (s1_en) begin
      active_q <= or_29 & (~and_31);
      idle_q <= and_31;
      last_q <= select_38;
      final_row_q <= select_42;
      columns_left_q <= select_52;
      rows_left_q <= select_55;
    end
  end

  logic [1:0] state_s2_q;
  logic and_28_s2_q;
  logic and_30_s2_q;
  logic and_56_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      state_s2_q <= state_s1_q;
      and_28_s2_q <= and_28_s1_q;
      and_30_s2_q <= and_30;
      and_56_s2_q <= and_56;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = state_s2_q;
  assign first_o = and_28_s2_q;
  assign last_o = and_30_s2_q;
  assign end_v_o = idle_q;
  assign idle_o = and_56_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q & (and_56 | or_29);
    end
  end

endmodule
