// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Align<horopter::hls::profiles::hd>, hls/stages/align.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 36 bits, pipeline 22 bits, memories 0 bits.
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
  input  logic [10:0] cfg_width_i,
  input  logic [10:0] cfg_height_i,
  input  logic cfg_compete_i,
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
  logic valid_s1_q, valid_s2_q, valid_s3_q;
  logic s0_en, s1_en, s2_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;

  // Of the configuration alone: not pipelined.
  logic columns;
  assign columns = ~cfg_compete_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic row_ended_q;
  logic [3:0] columns_q;
  // hls/stages/align.hpp:75
  logic [3:0] select_27;
  assign select_27 = marks_first_i ? 4'h0 : (row_ended_q ? 4'h0 : columns_q);
  logic equal_28;
  assign equal_28 = {columns, select_27[2:1], columns} == {select_27[3], 2'h0, select_27[0]};
  // hls/stages/align.hpp:105
  logic not_48;
  assign not_48 = ~equal_28;
  // hls/stages/align.hpp:77
  logic equal_57;
  assign equal_57 = state_i == 2'h0;
  // hls/stages/align.hpp:79
  logic and_58;
  assign and_58 = marks_nearer_i & equal_57;
  // hls/stages/align.hpp:81
  logic and_60;
  assign and_60 = equal_57 & (~marks_seen_i);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_ended_q <= 1'b1;
      columns_q <= 4'h0;
    end else if (s0_en) begin
      row_ended_q <= marks_last_i;
      columns_q <= select_27 + {3'h0, not_48};
    end
  end

  logic marks_first_s1_q;
  logic equal_28_s1_q;
  logic and_58_s1_q;
  logic and_60_s1_q;
  logic [1:0] select_62_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s1_q <= marks_first_i;
      equal_28_s1_q <= equal_28;
      and_58_s1_q <= and_58;
      and_60_s1_q <= and_60;
      select_62_s1_q <= (and_58 | and_60) ? 2'h2 : state_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic started_q;
  logic [3:0] rows_q;
  // hls/stages/align.hpp:72
  logic not_19;
  assign not_19 = ~marks_first_s1_q;
  logic and_21;
  assign and_21 = started_q & not_19;
  logic [3:0] select_24;
  assign select_24 = marks_first_s1_q ? 4'h0 : rows_q;
  // hls/stages/align.hpp:75
  logic equal_25;
  assign equal_25 = {select_24[3], cfg_compete_i, select_24[1], columns} == {1'b1, select_24[2], 1'b0, select_24[0]};
  // hls/stages/align.hpp:77
  logic and_29;
  assign and_29 = equal_25 & equal_28_s1_q;
  // hls/stages/align.hpp:107
  logic not_45;
  assign not_45 = ~equal_25;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      started_q <= 1'b1;
      rows_q <= 4'h0;
    end else if (s1_en) begin
      started_q <= and_21 | and_29;
      rows_q <= row_ended_q ? (select_24 + {3'h0, not_45}) : select_24;
    end
  end

  logic not_19_s2_q;
  logic and_30_s2_q;
  logic and_58_s2_q;
  logic and_60_s2_q;
  logic [1:0] select_62_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      not_19_s2_q <= not_19;
      and_30_s2_q <= (~and_21) & and_29;
      and_58_s2_q <= and_58_s1_q;
      and_60_s2_q <= and_60_s1_q;
      select_62_s2_q <= select_62_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic active_q;
  logic idle_q;
  logic last_q;
  logic final_row_q;
  logic [10:0] columns_left_q;
  logic [10:0] rows_left_q;
  // hls/stages/align.hpp:72
  logic and_20;
  assign and_20 = active_q & not_19_s2_q;
  // hls/stages/align.hpp:82
  logic or_31;
  assign or_31 = and_20 | and_30_s2_q;
  // hls/stages/align.hpp:85
  logic and_32;
  assign and_32 = last_q & and_20;
  logic and_33;
  assign and_33 = final_row_q & and_32;
  // hls/stages/align.hpp:95
  logic not_36;
  assign not_36 = ~and_30_s2_q;
  // hls/stages/align.hpp:104
  logic [10:0] select_53;
  assign select_53 = and_30_s2_q ? (cfg_width_i + 11'h7ff) : (last_q ? cfg_width_i : (columns_left_q + 11'h7ff));
  logic [10:0] select_56;
  assign select_56 = and_30_s2_q ? cfg_height_i : (last_q ? (rows_left_q + 11'h7ff) : rows_left_q);
  // hls/stages/align.hpp:72
  logic and_63;
  assign and_63 = idle_q & not_19_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      idle_q <= 1'b0;
      last_q <= 1'b0;
      final_row_q <= 1'b0;
      columns_left_q <= 11'h0;
      rows_left_q <= 11'h0;
    end else if (s2_en) begin
      active_q <= or_31 & (~and_33);
      idle_q <= and_33;
      last_q <= not_36 & ((~last_q) & (columns_left_q == 11'h2));
      final_row_q <= not_36 & (last_q ? (rows_left_q == 11'h2) : final_row_q);
      columns_left_q <= select_53;
      rows_left_q <= select_56;
    end
  end

  logic and_30_s3_q;
  logic and_32_s3_q;
  logic and_58_s3_q;
  logic and_60_s3_q;
  logic [1:0] select_62_s3_q;
  logic and_63_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      and_30_s3_q <= and_30_s2_q;
      and_32_s3_q <= and_32;
      and_58_s3_q <= and_58_s2_q;
      and_60_s3_q <= and_60_s2_q;
      select_62_s3_q <= select_62_s2_q;
      and_63_s3_q <= and_63;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign state_o = select_62_s3_q;
  assign first_o = and_30_s3_q;
  assign last_o = and_32_s3_q;
  assign end_v_o = idle_q;
  assign idle_o = and_63_s3_q;
  assign hidden_o = and_58_s3_q;
  assign unproven_o = and_60_s3_q;
  assign valid_o = valid_s3_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q & (and_63 | or_31);
    end
  end

endmodule
