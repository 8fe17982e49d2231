// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contrasts<horopter::hls::profiles::vga>, hls/stages/contrast.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 202 bits, pipeline 37 bits, memories 0 bits.
module horopter_contrast (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic signed [10:0] gx_0_i,
  input  logic signed [10:0] gx_1_i,
  input  logic signed [10:0] gy_0_i,
  input  logic signed [10:0] gy_1_i,
  input  logic [7:0] grey_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic signed [5:0] left_o,
  output logic signed [5:0] right_o,
  output logic signed [4:0] left_y_o,
  output logic signed [4:0] right_y_o,
  output logic edge_v_o,
  output logic mask_o,
  output logic [7:0] grey_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [20:0] sums_left_q;
  logic [20:0] sums_right_q;
  logic [17:0] left_q;
  logic [17:0] right_q;
  logic [17:0] row_left_q;
  logic [17:0] row_right_q;
  logic [7:0] gain_q;
  logic [7:0] next_gain_q;
  logic [20:0] divisor_q;
  logic [22:0] remainder_q;
  logic [22:0] difference_q;
  logic [4:0] beats_left_q;
  // hls/stages/contrast.hpp:106
  logic [4:0] select_25;
  assign select_25 = marks_first_i ? 5'h0 : beats_left_q;
  // hls/stages/contrast.hpp:116
  logic equal_26;
  assign equal_26 = select_25 == 5'h12;
  // hls/stages/contrast.hpp:120
  logic [20:0] select_29;
  assign select_29 = marks_last_i ? (sums_left_q - {3'h0, sums_left_q[20:3]}) : (equal_26 ? (sums_left_q + {3'h0, row_left_q}) : sums_left_q);
  logic [20:0] select_30;
  assign select_30 = marks_first_i ? 21'h280 : select_29;
  logic [20:0] select_34;
  assign select_34 = marks_last_i ? (sums_right_q - {3'h0, sums_right_q[20:3]}) : (equal_26 ? (sums_right_q + {3'h0, row_right_q}) : sums_right_q);
  logic [20:0] select_35;
  assign select_35 = marks_first_i ? 21'h280 : select_34;
  // hls/stages/contrast.hpp:106
  logic [17:0] select_36;
  assign select_36 = marks_first_i ? 18'h0 : left_q;
  // hls/stages/contrast.hpp:41
  logic [9:0] xor_37;
  assign xor_37 = gx_0_i[9:0] ^ {10{gx_0_i[10]}};
  logic [10:0] sum_38;
  assign sum_38 = {10'h0, gx_0_i[10]} + {1'b0, xor_37};
  // hls/stages/contrast.hpp:108
  logic [7:0] magnitude;
  assign magnitude = (sum_38[10:8] == 3'h0) ? sum_38[7:0] : 8'hff;
  // hls/stages/contrast.hpp:112
  logic [17:0] select_42;
  assign select_42 = mask_i ? (select_36 + {10'h0, magnitude}) : select_36;
  // hls/stages/contrast.hpp:106
  logic [17:0] select_44;
  assign select_44 = marks_first_i ? 18'h0 : right_q;
  // hls/stages/contrast.hpp:41
  logic [9:0] xor_45;
  assign xor_45 = gx_1_i[9:0] ^ {10{gx_1_i[10]}};
  logic [10:0] sum_46;
  assign sum_46 = {10'h0, gx_1_i[10]} + {1'b0, xor_45};
  // hls/stages/contrast.hpp:109
  logic [7:0] select_48;
  assign select_48 = (sum_46[10:8] == 3'h0) ? sum_46[7:0] : 8'hff;
  // hls/stages/contrast.hpp:112
  logic [17:0] select_50;
  assign select_50 = mask_i ? (select_44 + {10'h0, select_48}) : select_44;
  // hls/stages/contrast.hpp:122
  logic equal_54;
  assign equal_54 = select_25 == 5'h11;
  // hls/stages/contrast.hpp:106
  logic [7:0] select_55;
  assign select_55 = marks_first_i ? 8'h40 : next_gain_q;
  // hls/stages/contrast.hpp:121
  logic not_56;
  assign not_56 = ~difference_q[22];
  // hls/stages/contrast.hpp:131
  logic [7:0] select_58;
  assign select_58 = equal_54 ? select_55 : (select_25[0] ? {select_55[6:0], not_56} : select_55);
  // hls/stages/contrast.hpp:106
  logic [7:0] gain;
  assign gain = marks_first_i ? 8'h40 : gain_q;
  // hls/stages/contrast.hpp:41
  logic [7:0] select_62;
  assign select_62 = marks_last_i ? ((select_58[7:4] == 4'h0) ? 8'h10 : select_58) : gain;
  // hls/stages/contrast.hpp:124
  logic [22:0] select_65;
  assign select_65 = ({select_35, 2'h0} < {2'h0, select_30}) ? {select_35, 2'h0} : {2'h0, select_30};
  // hls/stages/contrast.hpp:126
  logic [21:0] select_66;
  assign select_66 = difference_q[22] ? remainder_q[21:0] : difference_q[21:0];
  // hls/stages/contrast.hpp:131
  logic [22:0] select_68;
  assign select_68 = equal_54 ? select_65 : (select_25[0] ? {select_66, 1'b0} : remainder_q);
  // hls/stages/contrast.hpp:129
  logic [22:0] difference_69;
  assign difference_69 = {1'b0, remainder_q[22:1]} - {2'h0, divisor_q};
  // hls/stages/contrast.hpp:131
  logic [22:0] select_70;
  assign select_70 = select_25[0] ? difference_q : {difference_69[22], difference_69[20:0], remainder_q[0]};
  logic not_73;
  assign not_73 = ~(select_25 == 5'h0);
  // hls/stages/contrast.hpp:45
  logic [4:0] size;
  assign size = saturated_i ? 5'h0 : ((magnitude[7:5] == 3'h0) ? magnitude[4:0] : 5'h1f);
  // hls/stages/contrast.hpp:48
  logic [15:0] product_81;
  assign product_81 = {8'h0, gain} * {8'h0, select_48};
  logic [7:0] magnitude_2;
  assign magnitude_2 = (product_81[15:14] == 2'h0) ? product_81[13:6] : 8'hff;
  // hls/stages/contrast.hpp:45
  logic [4:0] size_2;
  assign size_2 = saturated_i ? 5'h0 : ((magnitude_2[7:5] == 3'h0) ? magnitude_2[4:0] : 5'h1f);
  // hls/stages/contrast.hpp:41
  logic [9:0] xor_89;
  assign xor_89 = gy_0_i[9:0] ^ {10{gy_0_i[10]}};
  logic [10:0] sum_90;
  assign sum_90 = {10'h0, gy_0_i[10]} + {1'b0, xor_89};
  logic [7:0] magnitude_3;
  assign magnitude_3 = (sum_90[10:8] == 3'h0) ? sum_90[7:0] : 8'hff;
  // hls/stages/contrast.hpp:45
  logic [3:0] size_3;
  assign size_3 = saturated_i ? 4'h0 : ((magnitude_3[7:4] == 4'h0) ? magnitude_3[3:0] : 4'hf);
  // hls/stages/contrast.hpp:41
  logic [9:0] xor_98;
  assign xor_98 = gy_1_i[9:0] ^ {10{gy_1_i[10]}};
  logic [10:0] sum_99;
  assign sum_99 = {10'h0, gy_1_i[10]} + {1'b0, xor_98};
  // hls/stages/contrast.hpp:48
  logic [7:0] select_101;
  assign select_101 = (sum_99[10:8] == 3'h0) ? sum_99[7:0] : 8'hff;
  logic [15:0] product_102;
  assign product_102 = {8'h0, gain} * {8'h0, select_101};
  logic [7:0] magnitude_4;
  assign magnitude_4 = (product_102[15:14] == 2'h0) ? product_102[13:6] : 8'hff;
  // hls/stages/contrast.hpp:45
  logic [3:0] size_4;
  assign size_4 = saturated_i ? 4'h0 : ((magnitude_4[7:4] == 4'h0) ? magnitude_4[3:0] : 4'hf);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sums_left_q <= 21'h280;
      sums_right_q <= 21'h280;
      left_q <= 18'h0;
      right_q <= 18'h0;
      row_left_q <= 18'h0;
      row_right_q <= 18'h0;
      gain_q <= 8'h40;
      next_gain_q <= 8'h40;
      divisor_q <= 21'h0;
      remainder_q <= 23'h0;
      difference_q <= 23'h0;
      beats_left_q <= 5'h0;
    end else if (s0_en) begin
      sums_left_q <= select_30;
      sums_right_q <= select_35;
      left_q <= marks_last_i ? 18'h0 : select_42;
      right_q <= marks_last_i ? 18'h0 : select_50;
      row_left_q <= marks_last_i ? select_42 : row_left_q;
      row_right_q <= marks_last_i ? select_50 : row_right_q;
      gain_q <= select_62;
      next_gain_q <= select_58;
      divisor_q <= equal_54 ? select_35 : divisor_q;
      remainder_q <= select_68;
      difference_q <= equal_54 ? difference_q : select_70;
      beats_left_q <= marks_last_i ? 5'h12 : (select_25 + {5{not_73}});
    end
  end

  logic [7:0] grey_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic [5:0] select_80_s1_q;
  logic [5:0] select_88_s1_q;
  logic [4:0] select_97_s1_q;
  logic [4:0] select_109_s1_q;
  logic and_113_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      grey_s1_q <= grey_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      select_80_s1_q <= gx_0_i[10] ? (6'h0 - {1'b0, size}) : {1'b0, size};
      select_88_s1_q <= gx_1_i[10] ? (6'h0 - {1'b0, size_2}) : {1'b0, size_2};
      select_97_s1_q <= gy_0_i[10] ? (5'h0 - {1'b0, size_3}) : {1'b0, size_3};
      select_109_s1_q <= gy_1_i[10] ? (5'h0 - {1'b0, size_4}) : {1'b0, size_4};
      and_113_s1_q <= (~saturated_i) & (~(sum_38[10:5] == 6'h0));
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign left_o = select_80_s1_q;
  assign right_o = select_88_s1_q;
  assign left_y_o = select_97_s1_q;
  assign right_y_o = select_109_s1_q;
  assign edge_v_o = and_113_s1_q;
  assign mask_o = mask_s1_q;
  assign grey_o = grey_s1_q;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = marks_last_s1_q;
  assign marks_seen_o = marks_seen_s1_q;
  assign marks_nearer_o = marks_nearer_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{product_102[5:0], product_81[5:0], difference_69[21]};

endmodule
