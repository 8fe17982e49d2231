// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contrasts<horopter::hls::profiles::hd>, hls/stages/contrast.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 211 bits, pipeline 362 bits, memories 0 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contrast.hpp:38
  logic [9:0] xor_38;
  assign xor_38 = gx_0_i[9:0] ^ {10{gx_0_i[10]}};
  logic [10:0] sum_39;
  assign sum_39 = {10'h0, gx_0_i[10]} + {1'b0, xor_38};
  // hls/stages/contrast.hpp:101
  logic [7:0] magnitude;
  assign magnitude = (sum_39[10:8] == 3'h0) ? sum_39[7:0] : 8'hff;
  // hls/stages/contrast.hpp:38
  logic [9:0] xor_46;
  assign xor_46 = gx_1_i[9:0] ^ {10{gx_1_i[10]}};
  logic [10:0] sum_47;
  assign sum_47 = {10'h0, gx_1_i[10]} + {1'b0, xor_46};

  logic gx_0_s1_q;
  logic gx_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic [7:0] smooth_grey_s1_q;
  logic smooth_exists_s1_q;
  logic [7:0] magnitude_s1_q;
  logic [7:0] select_49_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      gx_0_s1_q <= gx_0_i[10];
      gx_1_s1_q <= gx_1_i[10];
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      smooth_grey_s1_q <= smooth_grey_i;
      smooth_exists_s1_q <= smooth_exists_i;
      magnitude_s1_q <= magnitude;
      select_49_s1_q <= (sum_47[10:8] == 3'h0) ? sum_47[7:0] : 8'hff;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [18:0] left_q;
  logic [18:0] right_q;
  // hls/stages/contrast.hpp:99
  logic [18:0] select_37;
  assign select_37 = marks_first_s1_q ? 19'h0 : left_q;
  // hls/stages/contrast.hpp:105
  logic [18:0] select_43;
  assign select_43 = mask_s1_q ? (select_37 + {11'h0, magnitude_s1_q}) : select_37;
  // hls/stages/contrast.hpp:99
  logic [18:0] select_45;
  assign select_45 = marks_first_s1_q ? 19'h0 : right_q;
  // hls/stages/contrast.hpp:105
  logic [18:0] select_51;
  assign select_51 = mask_s1_q ? (select_45 + {11'h0, select_49_s1_q}) : select_45;
  // hls/stages/contrast.hpp:41
  logic [4:0] size;
  assign size = saturated_s1_q ? 5'h0 : ((magnitude_s1_q[7:5] == 3'h0) ? magnitude_s1_q[4:0] : 5'h1f);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q <= 19'h0;
      right_q <= 19'h0;
    end else if (s1_en) begin
      left_q <= marks_last_s1_q ? 19'h0 : select_43;
      right_q <= marks_last_s1_q ? 19'h0 : select_51;
    end
  end

  logic gx_0_s2_q;
  logic gx_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic [7:0] smooth_grey_s2_q;
  logic smooth_exists_s2_q;
  logic [18:0] select_43_s2_q;
  logic [7:0] select_49_s2_q;
  logic [18:0] select_51_s2_q;
  logic [4:0] size_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      gx_0_s2_q <= gx_0_s1_q;
      gx_1_s2_q <= gx_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      smooth_grey_s2_q <= smooth_grey_s1_q;
      smooth_exists_s2_q <= smooth_exists_s1_q;
      select_43_s2_q <= select_43;
      select_49_s2_q <= select_49_s1_q;
      select_51_s2_q <= select_51;
      size_s2_q <= size;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [18:0] row_left_q;
  logic [18:0] row_right_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_left_q <= 19'h0;
      row_right_q <= 19'h0;
    end else if (s2_en) begin
      row_left_q <= marks_last_s2_q ? select_43_s2_q : row_left_q;
      row_right_q <= marks_last_s2_q ? select_51_s2_q : row_right_q;
    end
  end

  logic gx_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic [7:0] smooth_grey_s3_q;
  logic smooth_exists_s3_q;
  logic [18:0] row_left_s3_q;
  logic [18:0] row_right_s3_q;
  logic [7:0] select_49_s3_q;
  logic [5:0] select_81_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      gx_1_s3_q <= gx_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      smooth_grey_s3_q <= smooth_grey_s2_q;
      smooth_exists_s3_q <= smooth_exists_s2_q;
      row_left_s3_q <= row_left_q;
      row_right_s3_q <= row_right_q;
      select_49_s3_q <= select_49_s2_q;
      select_81_s3_q <= gx_0_s2_q ? (6'h0 - {1'b0, size_s2_q}) : {1'b0, size_s2_q};
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [21:0] sums_left_q;
  logic [21:0] sums_right_q;
  logic [4:0] beats_left_q;
  // hls/stages/contrast.hpp:99
  logic [4:0] select_26;
  assign select_26 = marks_first_s3_q ? 5'h0 : beats_left_q;
  // hls/stages/contrast.hpp:109
  logic equal_27;
  assign equal_27 = select_26 == 5'h12;
  // hls/stages/contrast.hpp:113
  logic [21:0] select_30;
  assign select_30 = marks_last_s3_q ? (sums_left_q - {3'h0, sums_left_q[21:3]}) : (equal_27 ? (sums_left_q + {3'h0, row_left_s3_q}) : sums_left_q);
  logic [21:0] select_34;
  assign select_34 = equal_27 ? (sums_right_q + {3'h0, row_right_s3_q}) : sums_right_q;
  logic [21:0] select_35;
  assign select_35 = marks_last_s3_q ? (sums_right_q - {3'h0, sums_right_q[21:3]}) : select_34;
  // hls/stages/contrast.hpp:124
  logic not_74;
  assign not_74 = ~(select_26 == 5'h0);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sums_left_q <= 22'h780;
      sums_right_q <= 22'h780;
      beats_left_q <= 5'h0;
    end else if (s3_en) begin
      sums_left_q <= marks_first_s3_q ? 22'h780 : select_30;
      sums_right_q <= marks_first_s3_q ? 22'h780 : select_35;
      beats_left_q <= marks_last_s3_q ? 5'h12 : (select_26 + {5{not_74}});
    end
  end

  logic gx_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic [7:0] smooth_grey_s4_q;
  logic smooth_exists_s4_q;
  logic select_26_s4_q;
  logic [7:0] select_49_s4_q;
  logic equal_55_s4_q;
  logic [5:0] select_81_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      gx_1_s4_q <= gx_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      smooth_grey_s4_q <= smooth_grey_s3_q;
      smooth_exists_s4_q <= smooth_exists_s3_q;
      select_26_s4_q <= select_26[0];
      select_49_s4_q <= select_49_s3_q;
      equal_55_s4_q <= select_26 == 5'h11;
      select_81_s4_q <= select_81_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [7:0] next_gain_q;
  logic [21:0] divisor_q;
  logic [23:0] remainder_q;
  logic [23:0] difference_q;
  // hls/stages/contrast.hpp:99
  logic [7:0] select_56;
  assign select_56 = marks_first_s4_q ? 8'h40 : next_gain_q;
  // hls/stages/contrast.hpp:114
  logic not_57;
  assign not_57 = ~difference_q[23];
  // hls/stages/contrast.hpp:124
  logic [7:0] select_59;
  assign select_59 = equal_55_s4_q ? select_56 : (select_26_s4_q ? {select_56[6:0], not_57} : select_56);
  // hls/stages/contrast.hpp:117
  logic [23:0] select_66;
  assign select_66 = ({sums_right_q, 2'h0} < {2'h0, sums_left_q}) ? {sums_right_q, 2'h0} : {2'h0, sums_left_q};
  // hls/stages/contrast.hpp:119
  logic [22:0] select_67;
  assign select_67 = difference_q[23] ? remainder_q[22:0] : difference_q[22:0];
  // hls/stages/contrast.hpp:124
  logic [23:0] select_69;
  assign select_69 = equal_55_s4_q ? select_66 : (select_26_s4_q ? {select_67, 1'b0} : remainder_q);
  // hls/stages/contrast.hpp:122
  logic [23:0] difference_70;
  assign difference_70 = {1'b0, remainder_q[23:1]} - {2'h0, divisor_q};
  // hls/stages/contrast.hpp:124
  logic [23:0] select_71;
  assign select_71 = select_26_s4_q ? difference_q : {difference_70[23], difference_70[21:0], remainder_q[0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      next_gain_q <= 8'h40;
      divisor_q <= 22'h0;
      remainder_q <= 24'h0;
      difference_q <= 24'h0;
    end else if (s4_en) begin
      next_gain_q <= select_59;
      divisor_q <= equal_55_s4_q ? sums_right_q : divisor_q;
      remainder_q <= select_69;
      difference_q <= equal_55_s4_q ? difference_q : select_71;
    end
  end

  logic gx_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic [7:0] smooth_grey_s5_q;
  logic smooth_exists_s5_q;
  logic [7:0] select_49_s5_q;
  logic [5:0] select_81_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      gx_1_s5_q <= gx_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      smooth_grey_s5_q <= smooth_grey_s4_q;
      smooth_exists_s5_q <= smooth_exists_s4_q;
      select_49_s5_q <= select_49_s4_q;
      select_81_s5_q <= select_81_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [7:0] gain_q;
  // hls/stages/contrast.hpp:99
  logic [7:0] gain;
  assign gain = marks_first_s5_q ? 8'h40 : gain_q;
  // hls/stages/contrast.hpp:38
  logic [7:0] select_63;
  assign select_63 = marks_last_s5_q ? ((next_gain_q[7:4] == 4'h0) ? 8'h10 : next_gain_q) : gain;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      gain_q <= 8'h40;
    end else if (s5_en) begin
      gain_q <= select_63;
    end
  end

  logic gx_1_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_seen_s6_q;
  logic marks_nearer_s6_q;
  logic [7:0] smooth_grey_s6_q;
  logic smooth_exists_s6_q;
  logic [7:0] select_49_s6_q;
  logic [7:0] gain_s6_q;
  logic [5:0] select_81_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      gx_1_s6_q <= gx_1_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_seen_s6_q <= marks_seen_s5_q;
      marks_nearer_s6_q <= marks_nearer_s5_q;
      smooth_grey_s6_q <= smooth_grey_s5_q;
      smooth_exists_s6_q <= smooth_exists_s5_q;
      select_49_s6_q <= select_49_s5_q;
      gain_s6_q <= gain;
      select_81_s6_q <= select_81_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contrast.hpp:47
  logic [15:0] product_82;
  assign product_82 = {8'h0, gain_s6_q} * {8'h0, select_49_s6_q};

  logic gx_1_s7_q;
  logic saturated_s7_q;
  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_seen_s7_q;
  logic marks_nearer_s7_q;
  logic [7:0] smooth_grey_s7_q;
  logic smooth_exists_s7_q;
  logic [5:0] select_81_s7_q;
  logic [9:0] product_82_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      gx_1_s7_q <= gx_1_s6_q;
      saturated_s7_q <= saturated_s6_q;
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_seen_s7_q <= marks_seen_s6_q;
      marks_nearer_s7_q <= marks_nearer_s6_q;
      smooth_grey_s7_q <= smooth_grey_s6_q;
      smooth_exists_s7_q <= smooth_exists_s6_q;
      select_81_s7_q <= select_81_s6_q;
      product_82_s7_q <= product_82[15:6];
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contrast.hpp:47
  logic [7:0] magnitude_2;
  assign magnitude_2 = (product_82_s7_q[9:8] == 2'h0) ? product_82_s7_q[7:0] : 8'hff;
  // hls/stages/contrast.hpp:41
  logic [4:0] size_2;
  assign size_2 = saturated_s7_q ? 5'h0 : ((magnitude_2[7:5] == 3'h0) ? magnitude_2[4:0] : 5'h1f);

  logic gx_1_s8_q;
  logic mask_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_seen_s8_q;
  logic marks_nearer_s8_q;
  logic [7:0] smooth_grey_s8_q;
  logic smooth_exists_s8_q;
  logic [5:0] select_81_s8_q;
  logic [4:0] size_2_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      gx_1_s8_q <= gx_1_s7_q;
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_seen_s8_q <= marks_seen_s7_q;
      marks_nearer_s8_q <= marks_nearer_s7_q;
      smooth_grey_s8_q <= smooth_grey_s7_q;
      smooth_exists_s8_q <= smooth_exists_s7_q;
      select_81_s8_q <= select_81_s7_q;
      size_2_s8_q <= size_2;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------

  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic marks_seen_s9_q;
  logic marks_nearer_s9_q;
  logic [7:0] smooth_grey_s9_q;
  logic smooth_exists_s9_q;
  logic [5:0] select_81_s9_q;
  logic [5:0] select_89_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      marks_seen_s9_q <= marks_seen_s8_q;
      marks_nearer_s9_q <= marks_nearer_s8_q;
      smooth_grey_s9_q <= smooth_grey_s8_q;
      smooth_exists_s9_q <= smooth_exists_s8_q;
      select_81_s9_q <= select_81_s8_q;
      select_89_s9_q <= gx_1_s8_q ? (6'h0 - {1'b0, size_2_s8_q}) : {1'b0, size_2_s8_q};
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign left_o = select_81_s9_q;
  assign right_o = select_89_s9_q;
  assign mask_o = mask_s9_q;
  assign grey_o = smooth_grey_s9_q;
  assign exists_o = smooth_exists_s9_q;
  assign marks_first_o = marks_first_s9_q;
  assign marks_last_o = marks_last_s9_q;
  assign marks_seen_o = marks_seen_s9_q;
  assign marks_nearer_o = marks_nearer_s9_q;
  assign valid_o = valid_s9_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
      valid_s7_q <= 1'b0;
      valid_s8_q <= 1'b0;
      valid_s9_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
      valid_s8_q <= valid_s7_q;
      valid_s9_q <= valid_s8_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{product_82[5:0], difference_70[22], $unsigned(gy_1_i), $unsigned(gy_0_i)};

endmodule
