// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contrasts<horopter::hls::profiles::vga>, hls/stages/contrast.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 202 bits, pipeline 25 bits, memories 0 bits.
module horopter_contrast (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic signed [10:0] gx_0_i,
  input  logic signed [10:0] gx_1_i,
  input  logic signed [10:0] gy_0_i,
  input  logic signed [10:0] gy_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [7:0] smooth_grey_i,
  input  logic smooth_exists_i,
  output logic valid_o,
  output logic signed [5:0] left_o,
  output logic signed [5:0] right_o,
  output logic mask_o,
  output logic [7:0] grey_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o
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
  // hls/stages/contrast.hpp:99
  logic [4:0] select_24;
  assign select_24 = marks_first_i ? 5'h0 : beats_left_q;
  // hls/stages/contrast.hpp:109
  logic equal_25;
  assign equal_25 = select_24 == 5'h12;
  // hls/stages/contrast.hpp:113
  logic [20:0] select_28;
  assign select_28 = marks_last_i ? (sums_left_q - {3'h0, sums_left_q[20:3]}) : (equal_25 ? (sums_left_q + {3'h0, row_left_q}) : sums_left_q);
  logic [20:0] select_29;
  assign select_29 = marks_first_i ? 21'h280 : select_28;
  logic [20:0] select_33;
  assign select_33 = marks_last_i ? (sums_right_q - {3'h0, sums_right_q[20:3]}) : (equal_25 ? (sums_right_q + {3'h0, row_right_q}) : sums_right_q);
  logic [20:0] select_34;
  assign select_34 = marks_first_i ? 21'h280 : select_33;
  // hls/stages/contrast.hpp:99
  logic [17:0] select_35;
  assign select_35 = marks_first_i ? 18'h0 : left_q;
  // hls/stages/contrast.hpp:38
  logic [9:0] xor_36;
  assign xor_36 = gx_0_i[9:0] ^ {10{gx_0_i[10]}};
  logic [10:0] sum_37;
  assign sum_37 = {10'h0, gx_0_i[10]} + {1'b0, xor_36};
  // hls/stages/contrast.hpp:101
  logic [7:0] magnitude;
  assign magnitude = (sum_37[10:8] == 3'h0) ? sum_37[7:0] : 8'hff;
  // hls/stages/contrast.hpp:105
  logic [17:0] select_41;
  assign select_41 = mask_i ? (select_35 + {10'h0, magnitude}) : select_35;
  // hls/stages/contrast.hpp:99
  logic [17:0] select_43;
  assign select_43 = marks_first_i ? 18'h0 : right_q;
  // hls/stages/contrast.hpp:38
  logic [9:0] xor_44;
  assign xor_44 = gx_1_i[9:0] ^ {10{gx_1_i[10]}};
  logic [10:0] sum_45;
  assign sum_45 = {10'h0, gx_1_i[10]} + {1'b0, xor_44};
  // hls/stages/contrast.hpp:102
  logic [7:0] select_47;
  assign select_47 = (sum_45[10:8] == 3'h0) ? sum_45[7:0] : 8'hff;
  // hls/stages/contrast.hpp:105
  logic [17:0] select_49;
  assign select_49 = mask_i ? (select_43 + {10'h0, select_47}) : select_43;
  // hls/stages/contrast.hpp:115
  logic equal_53;
  assign equal_53 = select_24 == 5'h11;
  // hls/stages/contrast.hpp:99
  logic [7:0] select_54;
  assign select_54 = marks_first_i ? 8'h40 : next_gain_q;
  // hls/stages/contrast.hpp:114
  logic not_55;
  assign not_55 = ~difference_q[22];
  // hls/stages/contrast.hpp:124
  logic [7:0] select_57;
  assign select_57 = equal_53 ? select_54 : (select_24[0] ? {select_54[6:0], not_55} : select_54);
  // hls/stages/contrast.hpp:99
  logic [7:0] gain;
  assign gain = marks_first_i ? 8'h40 : gain_q;
  // hls/stages/contrast.hpp:38
  logic [7:0] select_61;
  assign select_61 = marks_last_i ? ((select_57[7:4] == 4'h0) ? 8'h10 : select_57) : gain;
  // hls/stages/contrast.hpp:117
  logic [22:0] select_64;
  assign select_64 = ({select_34, 2'h0} < {2'h0, select_29}) ? {select_34, 2'h0} : {2'h0, select_29};
  // hls/stages/contrast.hpp:119
  logic [21:0] select_65;
  assign select_65 = difference_q[22] ? remainder_q[21:0] : difference_q[21:0];
  // hls/stages/contrast.hpp:124
  logic [22:0] select_67;
  assign select_67 = equal_53 ? select_64 : (select_24[0] ? {select_65, 1'b0} : remainder_q);
  // hls/stages/contrast.hpp:122
  logic [22:0] difference_68;
  assign difference_68 = {1'b0, remainder_q[22:1]} - {2'h0, divisor_q};
  // hls/stages/contrast.hpp:124
  logic [22:0] select_69;
  assign select_69 = select_24[0] ? difference_q : {difference_68[22], difference_68[20:0], remainder_q[0]};
  logic not_72;
  assign not_72 = ~(select_24 == 5'h0);
  // hls/stages/contrast.hpp:41
  logic [4:0] size;
  assign size = saturated_i ? 5'h0 : ((magnitude[7:5] == 3'h0) ? magnitude[4:0] : 5'h1f);
  // hls/stages/contrast.hpp:47
  logic [15:0] product_80;
  assign product_80 = {8'h0, gain} * {8'h0, select_47};
  logic [7:0] magnitude_2;
  assign magnitude_2 = (product_80[15:14] == 2'h0) ? product_80[13:6] : 8'hff;
  // hls/stages/contrast.hpp:41
  logic [4:0] size_2;
  assign size_2 = saturated_i ? 5'h0 : ((magnitude_2[7:5] == 3'h0) ? magnitude_2[4:0] : 5'h1f);

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
      sums_left_q <= select_29;
      sums_right_q <= select_34;
      left_q <= marks_last_i ? 18'h0 : select_41;
      right_q <= marks_last_i ? 18'h0 : select_49;
      row_left_q <= marks_last_i ? select_41 : row_left_q;
      row_right_q <= marks_last_i ? select_49 : row_right_q;
      gain_q <= select_61;
      next_gain_q <= select_57;
      divisor_q <= equal_53 ? select_34 : divisor_q;
      remainder_q <= select_67;
      difference_q <= equal_53 ? difference_q : select_69;
      beats_left_q <= marks_last_i ? 5'h12 : (select_24 + {5{not_72}});
    end
  end

  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic [7:0] smooth_grey_s1_q;
  logic smooth_exists_s1_q;
  logic [5:0] select_79_s1_q;
  logic [5:0] select_87_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      smooth_grey_s1_q <= smooth_grey_i;
      smooth_exists_s1_q <= smooth_exists_i;
      select_79_s1_q <= gx_0_i[10] ? (6'h0 - {1'b0, size}) : {1'b0, size};
      select_87_s1_q <= gx_1_i[10] ? (6'h0 - {1'b0, size_2}) : {1'b0, size_2};
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign left_o = select_79_s1_q;
  assign right_o = select_87_s1_q;
  assign mask_o = mask_s1_q;
  assign grey_o = smooth_grey_s1_q;
  assign exists_o = smooth_exists_s1_q;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = marks_last_s1_q;
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
  assign unused_bits = ^{product_80[5:0], difference_68[21], $unsigned(gy_1_i), $unsigned(gy_0_i)};

endmodule
