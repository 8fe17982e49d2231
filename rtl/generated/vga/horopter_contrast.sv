// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contrasts<horopter::hls::profiles::vga>, hls/stages/contrast.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 202 bits, pipeline 27 bits, memories 0 bits.
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
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  input  logic [7:0] smooth_grey_i,
  input  logic smooth_exists_i,
  output logic valid_o,
  output logic signed [5:0] left_o,
  output logic signed [5:0] right_o,
  output logic mask_o,
  output logic [7:0] grey_o,
  output logic exists_o,
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
  // hls/stages/contrast.hpp:99
  logic [4:0] select_26;
  assign select_26 = marks_first_i ? 5'h0 : beats_left_q;
  // hls/stages/contrast.hpp:109
  logic equal_27;
  assign equal_27 = select_26 == 5'h12;
  // hls/stages/contrast.hpp:113
  logic [20:0] select_30;
  assign select_30 = marks_last_i ? (sums_left_q - {3'h0, sums_left_q[20:3]}) : (equal_27 ? (sums_left_q + {3'h0, row_left_q}) : sums_left_q);
  logic [20:0] select_31;
  assign select_31 = marks_first_i ? 21'h280 : select_30;
  logic [20:0] select_35;
  assign select_35 = marks_last_i ? (sums_right_q - {3'h0, sums_right_q[20:3]}) : (equal_27 ? (sums_right_q + {3'h0, row_right_q}) : sums_right_q);
  logic [20:0] select_36;
  assign select_36 = marks_first_i ? 21'h280 : select_35;
  // hls/stages/contrast.hpp:99
  logic [17:0] select_37;
  assign select_37 = marks_first_i ? 18'h0 : left_q;
  // hls/stages/contrast.hpp:38
  logic [9:0] xor_38;
  assign xor_38 = gx_0_i[9:0] ^ {10{gx_0_i[10]}};
  logic [10:0] sum_39;
  assign sum_39 = {10'h0, gx_0_i[10]} + {1'b0, xor_38};
  // hls/stages/contrast.hpp:101
  logic [7:0] magnitude;
  assign magnitude = (sum_39[10:8] == 3'h0) ? sum_39[7:0] : 8'hff;
  // hls/stages/contrast.hpp:105
  logic [17:0] select_43;
  assign select_43 = mask_i ? (select_37 + {10'h0, magnitude}) : select_37;
  // hls/stages/contrast.hpp:99
  logic [17:0] select_45;
  assign select_45 = marks_first_i ? 18'h0 : right_q;
  // hls/stages/contrast.hpp:38
  logic [9:0] xor_46;
  assign xor_46 = gx_1_i[9:0] ^ {10{gx_1_i[10]}};
  logic [10:0] sum_47;
  assign sum_47 = {10'h0, gx_1_i[10]} + {1'b0, xor_46};
  // hls/stages/contrast.hpp:102
  logic [7:0] select_49;
  assign select_49 = (sum_47[10:8] == 3'h0) ? sum_47[7:0] : 8'hff;
  // hls/stages/contrast.hpp:105
  logic [17:0] select_51;
  assign select_51 = mask_i ? (select_45 + {10'h0, select_49}) : select_45;
  // hls/stages/contrast.hpp:115
  logic equal_55;
  assign equal_55 = select_26 == 5'h11;
  // hls/stages/contrast.hpp:99
  logic [7:0] select_56;
  assign select_56 = marks_first_i ? 8'h40 : next_gain_q;
  // hls/stages/contrast.hpp:114
  logic not_57;
  assign not_57 = ~difference_q[22];
  // hls/stages/contrast.hpp:124
  logic [7:0] select_59;
  assign select_59 = equal_55 ? select_56 : (select_26[0] ? {select_56[6:0], not_57} : select_56);
  // hls/stages/contrast.hpp:99
  logic [7:0] gain;
  assign gain = marks_first_i ? 8'h40 : gain_q;
  // hls/stages/contrast.hpp:38
  logic [7:0] select_63;
  assign select_63 = marks_last_i ? ((select_59[7:4] == 4'h0) ? 8'h10 : select_59) : gain;
  // hls/stages/contrast.hpp:117
  logic [22:0] select_66;
  assign select_66 = ({select_36, 2'h0} < {2'h0, select_31}) ? {select_36, 2'h0} : {2'h0, select_31};
  // hls/stages/contrast.hpp:119
  logic [21:0] select_67;
  assign select_67 = difference_q[22] ? remainder_q[21:0] : difference_q[21:0];
  // hls/stages/contrast.hpp:124
  logic [22:0] select_69;
  assign select_69 = equal_55 ? select_66 : (select_26[0] ? {select_67, 1'b0} : remainder_q);
  // hls/stages/contrast.hpp:122
  logic [22:0] difference_70;
  assign difference_70 = {1'b0, remainder_q[22:1]} - {2'h0, divisor_q};
  // hls/stages/contrast.hpp:124
  logic [22:0] select_71;
  assign select_71 = select_26[0] ? difference_q : {difference_70[22], difference_70[20:0], remainder_q[0]};
  logic not_74;
  assign not_74 = ~(select_26 == 5'h0);
  // hls/stages/contrast.hpp:41
  logic [4:0] size;
  assign size = saturated_i ? 5'h0 : ((magnitude[7:5] == 3'h0) ? magnitude[4:0] : 5'h1f);
  // hls/stages/contrast.hpp:47
  logic [15:0] product_82;
  assign product_82 = {8'h0, gain} * {8'h0, select_49};
  logic [7:0] magnitude_2;
  assign magnitude_2 = (product_82[15:14] == 2'h0) ? product_82[13:6] : 8'hff;
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
      sums_left_q <= select_31;
      sums_right_q <= select_36;
      left_q <= marks_last_i ? 18'h0 : select_43;
      right_q <= marks_last_i ? 18'h0 : select_51;
      row_left_q <= marks_last_i ? select_43 : row_left_q;
      row_right_q <= marks_last_i ? select_51 : row_right_q;
      gain_q <= select_63;
      next_gain_q <= select_59;
      divisor_q <= equal_55 ? select_36 : divisor_q;
      remainder_q <= select_69;
      difference_q <= equal_55 ? difference_q : select_71;
      beats_left_q <= marks_last_i ? 5'h12 : (select_26 + {5{not_74}});
    end
  end

  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic [7:0] smooth_grey_s1_q;
  logic smooth_exists_s1_q;
  logic [5:0] select_81_s1_q;
  logic [5:0] select_89_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      smooth_grey_s1_q <= smooth_grey_i;
      smooth_exists_s1_q <= smooth_exists_i;
      select_81_s1_q <= gx_0_i[10] ? (6'h0 - {1'b0, size}) : {1'b0, size};
      select_89_s1_q <= gx_1_i[10] ? (6'h0 - {1'b0, size_2}) : {1'b0, size_2};
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign left_o = select_81_s1_q;
  assign right_o = select_89_s1_q;
  assign mask_o = mask_s1_q;
  assign grey_o = smooth_grey_s1_q;
  assign exists_o = smooth_exists_s1_q;
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
  assign unused_bits = ^{product_82[5:0], difference_70[21], $unsigned(gy_1_i), $unsigned(gy_0_i)};

endmodule
