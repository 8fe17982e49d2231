// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Difference<horopter::hls::profiles::hd>, hls/stages/difference.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 41 bits, pipeline 46 bits, memories 0 bits.
module horopter_difference (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] direction_0_i,
  input  logic [7:0] direction_1_i,
  input  logic [7:0] magnitude_0_i,
  input  logic [7:0] magnitude_1_i,
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
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_0_direction_q;
  logic [7:0] left_1_direction_q;
  logic [7:0] left_2_direction_q;
  logic [7:0] left_3_direction_q;
  // hls/stages/difference.hpp:94
  logic [7:0] turn;
  assign turn = direction_0_i - direction_1_i;
  // hls/stages/difference.hpp:95
  logic [6:0] xor_38;
  assign xor_38 = turn[6:0] ^ {7{turn[7]}};
  logic [7:0] shortest;
  assign shortest = {7'h0, turn[7]} + {1'b0, xor_38};
  // hls/stages/difference.hpp:94
  logic [7:0] turn_2;
  assign turn_2 = direction_0_i - left_3_direction_q;
  // hls/stages/difference.hpp:95
  logic [6:0] xor_48;
  assign xor_48 = turn_2[6:0] ^ {7{turn_2[7]}};
  logic [7:0] shortest_2;
  assign shortest_2 = {7'h0, turn_2[7]} + {1'b0, xor_48};

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_0_direction_q = 8'h0;
    left_1_direction_q = 8'h0;
    left_2_direction_q = 8'h0;
    left_3_direction_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (rst_ni & s0_en) begin
      left_0_direction_q <= direction_0_i;
      left_1_direction_q <= left_0_direction_q;
      left_2_direction_q <= left_1_direction_q;
      left_3_direction_q <= left_2_direction_q;
    end
  end

  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic equal_24_s1_q;
  logic not_35_s1_q;
  logic [4:0] shortest_s1_q;
  logic [4:0] shortest_2_s1_q;
  logic [7:0] select_54_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      equal_24_s1_q <= magnitude_0_i == 8'h0;
      not_35_s1_q <= ~(magnitude_1_i == 8'h0);
      shortest_s1_q <= shortest[7:3];
      shortest_2_s1_q <= shortest_2[7:3];
      select_54_s1_q <= saturated_i ? 8'h0 : magnitude_0_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic row_ended_q;
  logic left_0_has_direction_q;
  logic left_0_exists_q;
  logic left_1_has_direction_q;
  logic left_1_exists_q;
  logic left_2_has_direction_q;
  logic left_2_exists_q;
  logic left_3_has_direction_q;
  logic left_3_exists_q;
  // hls/stages/difference.hpp:58
  logic not_25;
  assign not_25 = ~equal_24_s1_q;
  // hls/stages/difference.hpp:53
  logic not_26;
  assign not_26 = ~marks_first_s1_q;
  // hls/stages/difference.hpp:68
  logic not_27;
  assign not_27 = ~row_ended_q;
  // hls/stages/difference.hpp:96
  logic [3:0] level;
  assign level = shortest_s1_q[4] ? 4'hf : shortest_s1_q[3:0];
  // hls/stages/difference.hpp:68
  logic or_41;
  assign or_41 = not_35_s1_q | not_25;
  // hls/stages/difference.hpp:97
  logic not_42;
  assign not_42 = ~or_41;
  // hls/stages/difference.hpp:98
  logic without;
  assign without = left_3_has_direction_q | not_25;
  // hls/stages/difference.hpp:96
  logic [3:0] level_2;
  assign level_2 = shortest_2_s1_q[4] ? 4'hf : shortest_2_s1_q[3:0];
  // hls/stages/difference.hpp:68
  logic [3:0] select_52;
  assign select_52 = equal_24_s1_q ? {without, 3'h0} : (left_3_has_direction_q ? level_2 : {without, 3'h0});

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_ended_q <= 1'b1;
    end else if (s1_en) begin
      row_ended_q <= marks_last_s1_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_0_has_direction_q = 1'b0;
    left_0_exists_q = 1'b0;
    left_1_has_direction_q = 1'b0;
    left_1_exists_q = 1'b0;
    left_2_has_direction_q = 1'b0;
    left_2_exists_q = 1'b0;
    left_3_has_direction_q = 1'b0;
    left_3_exists_q = 1'b0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      left_0_has_direction_q <= not_25;
      left_0_exists_q <= mask_s1_q;
      left_1_has_direction_q <= left_0_has_direction_q;
      left_1_exists_q <= not_26 & (left_0_exists_q & not_27);
      left_2_has_direction_q <= left_1_has_direction_q;
      left_2_exists_q <= not_26 & (left_1_exists_q & not_27);
      left_3_has_direction_q <= left_2_has_direction_q;
      left_3_exists_q <= not_26 & (left_2_exists_q & not_27);
    end
  end

  logic marks_first_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic [3:0] select_43_s2_q;
  logic [3:0] select_53_s2_q;
  logic [7:0] select_54_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      marks_first_s2_q <= marks_first_s1_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      select_43_s2_q <= (not_35_s1_q & not_25) ? level : {or_41, not_42, 2'h0};
      select_53_s2_q <= (not_26 & (left_3_exists_q & not_27)) ? select_52 : 4'h0;
      select_54_s2_q <= select_54_s1_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign difference_0_o = select_43_s2_q;
  assign difference_1_o = select_53_s2_q;
  assign magnitude_o = select_54_s2_q;
  assign mask_o = left_0_exists_q;
  assign marks_first_o = marks_first_s2_q;
  assign marks_last_o = row_ended_q;
  assign marks_seen_o = marks_seen_s2_q;
  assign marks_nearer_o = marks_nearer_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{shortest_2[2:0], shortest[2:0]};

endmodule
