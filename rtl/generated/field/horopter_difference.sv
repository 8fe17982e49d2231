// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Difference<horopter::hls::profiles::field>, hls/stages/difference.hpp. Do not edit.
//
// Latency 0 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// Outputs are logic: what they go to takes them with the clock if en_i = 1.
// State 59 bits, pipeline 0 bits, memories 0 bits.
module horopter_difference (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] direction_0_i,
  input  logic [7:0] magnitude_0_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  output logic valid_o,
  output logic [3:0] difference_0_o,
  output logic [3:0] difference_1_o,
  output logic [7:0] magnitude_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic difference_row_ended_q;
  logic [7:0] difference_left_0_direction_q;
  logic difference_left_0_has_direction_q;
  logic difference_left_0_exists_q;
  logic [7:0] difference_left_1_direction_q;
  logic difference_left_1_has_direction_q;
  logic difference_left_1_exists_q;
  logic [7:0] difference_left_2_direction_q;
  logic difference_left_2_has_direction_q;
  logic difference_left_2_exists_q;
  logic [7:0] difference_left_3_direction_q;
  logic difference_left_3_has_direction_q;
  logic difference_left_3_exists_q;
  logic [7:0] left_direction_0_q;
  logic [7:0] left_magnitude_0_q;
  logic left_marks_first_q;
  logic second_q;
  // hls/stages/difference.hpp:122
  logic and_25;
  assign and_25 = second_q & (~marks_first_i);
  // hls/stages/difference.hpp:58
  logic equal_28;
  assign equal_28 = left_magnitude_0_q == 8'h0;
  logic not_29;
  assign not_29 = ~equal_28;
  // hls/stages/difference.hpp:68
  logic not_33;
  assign not_33 = ~(and_25 & (difference_row_ended_q | left_marks_first_q));
  logic and_34;
  assign and_34 = difference_left_0_exists_q & not_33;
  // hls/stages/difference.hpp:128
  logic [7:0] select_36;
  assign select_36 = and_25 ? difference_left_0_direction_q : difference_left_1_direction_q;
  logic select_37;
  assign select_37 = and_25 ? difference_left_0_has_direction_q : difference_left_1_has_direction_q;
  // hls/stages/difference.hpp:68
  logic and_38;
  assign and_38 = difference_left_1_exists_q & not_33;
  // hls/stages/difference.hpp:128
  logic [7:0] select_40;
  assign select_40 = and_25 ? difference_left_1_direction_q : difference_left_2_direction_q;
  logic select_41;
  assign select_41 = and_25 ? difference_left_1_has_direction_q : difference_left_2_has_direction_q;
  // hls/stages/difference.hpp:68
  logic and_42;
  assign and_42 = difference_left_2_exists_q & not_33;
  // hls/stages/difference.hpp:128
  logic [7:0] select_44;
  assign select_44 = and_25 ? difference_left_2_direction_q : difference_left_3_direction_q;
  logic select_45;
  assign select_45 = and_25 ? difference_left_2_has_direction_q : difference_left_3_has_direction_q;
  // hls/stages/difference.hpp:68
  logic and_46;
  assign and_46 = difference_left_3_exists_q & not_33;
  // hls/stages/difference.hpp:59
  logic not_53;
  assign not_53 = ~(magnitude_0_i == 8'h0);
  // hls/stages/difference.hpp:94
  logic [7:0] turn;
  assign turn = left_direction_0_q - direction_0_i;
  // hls/stages/difference.hpp:95
  logic [6:0] xor_56;
  assign xor_56 = turn[6:0] ^ {7{turn[7]}};
  logic [7:0] shortest;
  assign shortest = {7'h0, turn[7]} + {1'b0, xor_56};
  // hls/stages/difference.hpp:96
  logic [3:0] level;
  assign level = shortest[7] ? 4'hf : shortest[6:3];
  // hls/stages/difference.hpp:97
  logic or_59;
  assign or_59 = not_29 | not_53;
  logic not_60;
  assign not_60 = ~or_59;
  // hls/stages/difference.hpp:98
  logic without;
  assign without = difference_left_3_has_direction_q | not_29;
  // hls/stages/difference.hpp:94
  logic [7:0] turn_2;
  assign turn_2 = left_direction_0_q - difference_left_3_direction_q;
  // hls/stages/difference.hpp:95
  logic [6:0] xor_64;
  assign xor_64 = turn_2[6:0] ^ {7{turn_2[7]}};
  logic [7:0] shortest_2;
  assign shortest_2 = {7'h0, turn_2[7]} + {1'b0, xor_64};
  // hls/stages/difference.hpp:96
  logic [3:0] level_2;
  assign level_2 = shortest_2[7] ? 4'hf : shortest_2[6:3];
  // hls/stages/difference.hpp:68
  logic [3:0] select_68;
  assign select_68 = equal_28 ? {without, 3'h0} : (difference_left_3_has_direction_q ? level_2 : {without, 3'h0});

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      difference_row_ended_q <= 1'b1;
      second_q <= 1'b0;
    end else if (s0_en) begin
      difference_row_ended_q <= and_25 ? marks_last_i : difference_row_ended_q;
      second_q <= ~and_25;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    difference_left_0_direction_q = 8'h0;
    difference_left_0_has_direction_q = 1'b0;
    difference_left_0_exists_q = 1'b0;
    difference_left_1_direction_q = 8'h0;
    difference_left_1_has_direction_q = 1'b0;
    difference_left_1_exists_q = 1'b0;
    difference_left_2_direction_q = 8'h0;
    difference_left_2_has_direction_q = 1'b0;
    difference_left_2_exists_q = 1'b0;
    difference_left_3_direction_q = 8'h0;
    difference_left_3_has_direction_q = 1'b0;
    difference_left_3_exists_q = 1'b0;
    left_direction_0_q = 8'h0;
    left_magnitude_0_q = 8'h0;
    left_marks_first_q = 1'b0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (rst_ni & s0_en) begin
      difference_left_0_direction_q <= and_25 ? left_direction_0_q : difference_left_0_direction_q;
      difference_left_0_has_direction_q <= and_25 ? not_29 : difference_left_0_has_direction_q;
      difference_left_0_exists_q <= and_25 ? mask_i : and_34;
      difference_left_1_direction_q <= select_36;
      difference_left_1_has_direction_q <= select_37;
      difference_left_1_exists_q <= and_25 ? and_34 : and_38;
      difference_left_2_direction_q <= select_40;
      difference_left_2_has_direction_q <= select_41;
      difference_left_2_exists_q <= and_25 ? and_38 : and_42;
      difference_left_3_direction_q <= select_44;
      difference_left_3_has_direction_q <= select_45;
      difference_left_3_exists_q <= and_25 ? and_42 : and_46;
      left_direction_0_q <= and_25 ? left_direction_0_q : direction_0_i;
      left_magnitude_0_q <= and_25 ? left_magnitude_0_q : magnitude_0_i;
      left_marks_first_q <= and_25 ? left_marks_first_q : marks_first_i;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign difference_0_o = (not_29 & not_53) ? level : {or_59, not_60, 2'h0};
  assign difference_1_o = and_46 ? select_68 : 4'h0;
  assign magnitude_o = saturated_i ? 8'h0 : left_magnitude_0_q;
  assign mask_o = mask_i;
  assign marks_first_o = left_marks_first_q;
  assign marks_last_o = marks_last_i;
  assign valid_o = valid_i & and_25;

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{shortest_2[2:0], shortest[2:0]};

endmodule
