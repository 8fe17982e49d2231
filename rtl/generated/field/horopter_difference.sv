// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Difference<horopter::hls::profiles::field>, hls/stages/difference.hpp. Do not edit.
//
// Latency 0 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
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
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [3:0] difference_0_o,
  output logic [3:0] difference_1_o,
  output logic [7:0] magnitude_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
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
  logic second;
  assign second = second_q & (~marks_first_i);
  // hls/stages/difference.hpp:58
  logic equal_30;
  assign equal_30 = left_magnitude_0_q == 8'h0;
  logic not_31;
  assign not_31 = ~equal_30;
  // hls/stages/difference.hpp:68
  logic not_35;
  assign not_35 = ~(second & (difference_row_ended_q | left_marks_first_q));
  logic and_36;
  assign and_36 = difference_left_0_exists_q & not_35;
  // hls/stages/difference.hpp:129
  logic [7:0] select_38;
  assign select_38 = second ? difference_left_0_direction_q : difference_left_1_direction_q;
  logic select_39;
  assign select_39 = second ? difference_left_0_has_direction_q : difference_left_1_has_direction_q;
  // hls/stages/difference.hpp:68
  logic and_40;
  assign and_40 = difference_left_1_exists_q & not_35;
  // hls/stages/difference.hpp:129
  logic [7:0] select_42;
  assign select_42 = second ? difference_left_1_direction_q : difference_left_2_direction_q;
  logic select_43;
  assign select_43 = second ? difference_left_1_has_direction_q : difference_left_2_has_direction_q;
  // hls/stages/difference.hpp:68
  logic and_44;
  assign and_44 = difference_left_2_exists_q & not_35;
  // hls/stages/difference.hpp:129
  logic [7:0] select_46;
  assign select_46 = second ? difference_left_2_direction_q : difference_left_3_direction_q;
  logic select_47;
  assign select_47 = second ? difference_left_2_has_direction_q : difference_left_3_has_direction_q;
  // hls/stages/difference.hpp:68
  logic and_48;
  assign and_48 = difference_left_3_exists_q & not_35;
  // hls/stages/difference.hpp:59
  logic not_55;
  assign not_55 = ~(magnitude_0_i == 8'h0);
  // hls/stages/difference.hpp:94
  logic [7:0] turn;
  assign turn = left_direction_0_q - direction_0_i;
  // hls/stages/difference.hpp:95
  logic [6:0] xor_58;
  assign xor_58 = turn[6:0] ^ {7{turn[7]}};
  logic [7:0] shortest;
  assign shortest = {7'h0, turn[7]} + {1'b0, xor_58};
  // hls/stages/difference.hpp:96
  logic [3:0] level;
  assign level = shortest[7] ? 4'hf : shortest[6:3];
  // hls/stages/difference.hpp:97
  logic or_61;
  assign or_61 = not_31 | not_55;
  logic not_62;
  assign not_62 = ~or_61;
  // hls/stages/difference.hpp:98
  logic without;
  assign without = difference_left_3_has_direction_q | not_31;
  // hls/stages/difference.hpp:94
  logic [7:0] turn_2;
  assign turn_2 = left_direction_0_q - difference_left_3_direction_q;
  // hls/stages/difference.hpp:95
  logic [6:0] xor_66;
  assign xor_66 = turn_2[6:0] ^ {7{turn_2[7]}};
  logic [7:0] shortest_2;
  assign shortest_2 = {7'h0, turn_2[7]} + {1'b0, xor_66};
  // hls/stages/difference.hpp:96
  logic [3:0] level_2;
  assign level_2 = shortest_2[7] ? 4'hf : shortest_2[6:3];
  // hls/stages/difference.hpp:68
  logic [3:0] select_70;
  assign select_70 = equal_30 ? {without, 3'h0} : (difference_left_3_has_direction_q ? level_2 : {without, 3'h0});

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      difference_row_ended_q <= 1'b1;
      second_q <= 1'b0;
    end else if (s0_en) begin
      difference_row_ended_q <= second ? marks_last_i : difference_row_ended_q;
      second_q <= ~second;
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
      difference_left_0_direction_q <= second ? left_direction_0_q : difference_left_0_direction_q;
      difference_left_0_has_direction_q <= second ? not_31 : difference_left_0_has_direction_q;
      difference_left_0_exists_q <= second ? mask_i : and_36;
      difference_left_1_direction_q <= select_38;
      difference_left_1_has_direction_q <= select_39;
      difference_left_1_exists_q <= second ? and_36 : and_40;
      difference_left_2_direction_q <= select_42;
      difference_left_2_has_direction_q <= select_43;
      difference_left_2_exists_q <= second ? and_40 : and_44;
      difference_left_3_direction_q <= select_46;
      difference_left_3_has_direction_q <= select_47;
      difference_left_3_exists_q <= second ? and_44 : and_48;
      left_direction_0_q <= second ? left_direction_0_q : direction_0_i;
      left_magnitude_0_q <= second ? left_magnitude_0_q : magnitude_0_i;
      left_marks_first_q <= second ? left_marks_first_q : marks_first_i;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign difference_0_o = (not_31 & not_55) ? level : {or_61, not_62, 2'h0};
  assign difference_1_o = and_48 ? select_70 : 4'h0;
  assign magnitude_o = saturated_i ? 8'h0 : left_magnitude_0_q;
  assign mask_o = mask_i;
  assign marks_first_o = left_marks_first_q;
  assign marks_last_o = marks_last_i;
  assign marks_seen_o = marks_seen_i;
  assign marks_nearer_o = marks_nearer_i;
  assign valid_o = valid_i & second;

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{shortest_2[2:0], shortest[2:0]};

endmodule
