// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contrasts<horopter::hls::profiles::hd>, hls/stages/contrast.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 211 bits, pipeline 487 bits, memories 0 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q;
  logic s1_en, s2_en, s3_en, s4_en, s5_en, s8_en;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s8_en = en_i & valid_s8_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contrast.hpp:41
  logic [9:0] xor_37;
  assign xor_37 = gx_0_i[9:0] ^ {10{gx_0_i[10]}};
  logic [10:0] sum_38;
  assign sum_38 = {10'h0, gx_0_i[10]} + {1'b0, xor_37};
  // hls/stages/contrast.hpp:108
  logic [7:0] magnitude;
  assign magnitude = (sum_38[10:8] == 3'h0) ? sum_38[7:0] : 8'hff;
  // hls/stages/contrast.hpp:41
  logic [9:0] xor_45;
  assign xor_45 = gx_1_i[9:0] ^ {10{gx_1_i[10]}};
  logic [10:0] sum_46;
  assign sum_46 = {10'h0, gx_1_i[10]} + {1'b0, xor_45};
  logic [9:0] xor_89;
  assign xor_89 = gy_0_i[9:0] ^ {10{gy_0_i[10]}};
  logic [10:0] sum_90;
  assign sum_90 = {10'h0, gy_0_i[10]} + {1'b0, xor_89};
  logic [7:0] magnitude_3;
  assign magnitude_3 = (sum_90[10:8] == 3'h0) ? sum_90[7:0] : 8'hff;
  logic [9:0] xor_98;
  assign xor_98 = gy_1_i[9:0] ^ {10{gy_1_i[10]}};
  logic [10:0] sum_99;
  assign sum_99 = {10'h0, gy_1_i[10]} + {1'b0, xor_98};

  logic gx_0_s1_q;
  logic gx_1_s1_q;
  logic gy_0_s1_q;
  logic gy_1_s1_q;
  logic [7:0] grey_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic [7:0] magnitude_s1_q;
  logic [7:0] select_48_s1_q;
  logic [7:0] magnitude_3_s1_q;
  logic [7:0] select_101_s1_q;
  logic not_112_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      gx_0_s1_q <= gx_0_i[10];
      gx_1_s1_q <= gx_1_i[10];
      gy_0_s1_q <= gy_0_i[10];
      gy_1_s1_q <= gy_1_i[10];
      grey_s1_q <= grey_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      magnitude_s1_q <= magnitude;
      select_48_s1_q <= (sum_46[10:8] == 3'h0) ? sum_46[7:0] : 8'hff;
      magnitude_3_s1_q <= magnitude_3;
      select_101_s1_q <= (sum_99[10:8] == 3'h0) ? sum_99[7:0] : 8'hff;
      not_112_s1_q <= ~(sum_38[10:5] == 6'h0);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [18:0] left_q;
  logic [18:0] right_q;
  // hls/stages/contrast.hpp:106
  logic [18:0] select_36;
  assign select_36 = marks_first_s1_q ? 19'h0 : left_q;
  // hls/stages/contrast.hpp:112
  logic [18:0] select_42;
  assign select_42 = mask_s1_q ? (select_36 + {11'h0, magnitude_s1_q}) : select_36;
  // hls/stages/contrast.hpp:106
  logic [18:0] select_44;
  assign select_44 = marks_first_s1_q ? 19'h0 : right_q;
  // hls/stages/contrast.hpp:112
  logic [18:0] select_50;
  assign select_50 = mask_s1_q ? (select_44 + {11'h0, select_48_s1_q}) : select_44;
  // hls/stages/contrast.hpp:45
  logic [4:0] size;
  assign size = saturated_s1_q ? 5'h0 : ((magnitude_s1_q[7:5] == 3'h0) ? magnitude_s1_q[4:0] : 5'h1f);
  logic [3:0] size_3;
  assign size_3 = saturated_s1_q ? 4'h0 : ((magnitude_3_s1_q[7:4] == 4'h0) ? magnitude_3_s1_q[3:0] : 4'hf);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q <= 19'h0;
      right_q <= 19'h0;
    end else if (s1_en) begin
      left_q <= marks_last_s1_q ? 19'h0 : select_42;
      right_q <= marks_last_s1_q ? 19'h0 : select_50;
    end
  end

  logic gx_0_s2_q;
  logic gx_1_s2_q;
  logic gy_0_s2_q;
  logic gy_1_s2_q;
  logic [7:0] grey_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic [18:0] select_42_s2_q;
  logic [7:0] select_48_s2_q;
  logic [18:0] select_50_s2_q;
  logic [4:0] size_s2_q;
  logic [3:0] size_3_s2_q;
  logic [7:0] select_101_s2_q;
  logic and_113_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      gx_0_s2_q <= gx_0_s1_q;
      gx_1_s2_q <= gx_1_s1_q;
      gy_0_s2_q <= gy_0_s1_q;
      gy_1_s2_q <= gy_1_s1_q;
      grey_s2_q <= grey_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      select_42_s2_q <= select_42;
      select_48_s2_q <= select_48_s1_q;
      select_50_s2_q <= select_50;
      size_s2_q <= size;
      size_3_s2_q <= size_3;
      select_101_s2_q <= select_101_s1_q;
      and_113_s2_q <= (~saturated_s1_q) & not_112_s1_q;
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
      row_left_q <= marks_last_s2_q ? select_42_s2_q : row_left_q;
      row_right_q <= marks_last_s2_q ? select_50_s2_q : row_right_q;
    end
  end

  logic gx_1_s3_q;
  logic gy_1_s3_q;
  logic [7:0] grey_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic [18:0] row_left_s3_q;
  logic [18:0] row_right_s3_q;
  logic [7:0] select_48_s3_q;
  logic [5:0] select_80_s3_q;
  logic [4:0] select_97_s3_q;
  logic [7:0] select_101_s3_q;
  logic and_113_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      gx_1_s3_q <= gx_1_s2_q;
      gy_1_s3_q <= gy_1_s2_q;
      grey_s3_q <= grey_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      row_left_s3_q <= row_left_q;
      row_right_s3_q <= row_right_q;
      select_48_s3_q <= select_48_s2_q;
      select_80_s3_q <= gx_0_s2_q ? (6'h0 - {1'b0, size_s2_q}) : {1'b0, size_s2_q};
      select_97_s3_q <= gy_0_s2_q ? (5'h0 - {1'b0, size_3_s2_q}) : {1'b0, size_3_s2_q};
      select_101_s3_q <= select_101_s2_q;
      and_113_s3_q <= and_113_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [21:0] sums_left_q;
  logic [21:0] sums_right_q;
  logic [4:0] beats_left_q;
  // hls/stages/contrast.hpp:106
  logic [4:0] select_25;
  assign select_25 = marks_first_s3_q ? 5'h0 : beats_left_q;
  // hls/stages/contrast.hpp:116
  logic equal_26;
  assign equal_26 = select_25 == 5'h12;
  // hls/stages/contrast.hpp:120
  logic [21:0] select_29;
  assign select_29 = marks_last_s3_q ? (sums_left_q - {3'h0, sums_left_q[21:3]}) : (equal_26 ? (sums_left_q + {3'h0, row_left_s3_q}) : sums_left_q);
  logic [21:0] select_33;
  assign select_33 = equal_26 ? (sums_right_q + {3'h0, row_right_s3_q}) : sums_right_q;
  logic [21:0] select_34;
  assign select_34 = marks_last_s3_q ? (sums_right_q - {3'h0, sums_right_q[21:3]}) : select_33;
  // hls/stages/contrast.hpp:131
  logic not_73;
  assign not_73 = ~(select_25 == 5'h0);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sums_left_q <= 22'h780;
      sums_right_q <= 22'h780;
      beats_left_q <= 5'h0;
    end else if (s3_en) begin
      sums_left_q <= marks_first_s3_q ? 22'h780 : select_29;
      sums_right_q <= marks_first_s3_q ? 22'h780 : select_34;
      beats_left_q <= marks_last_s3_q ? 5'h12 : (select_25 + {5{not_73}});
    end
  end

  logic gx_1_s4_q;
  logic gy_1_s4_q;
  logic [7:0] grey_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic select_25_s4_q;
  logic [7:0] select_48_s4_q;
  logic equal_54_s4_q;
  logic [5:0] select_80_s4_q;
  logic [4:0] select_97_s4_q;
  logic [7:0] select_101_s4_q;
  logic and_113_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      gx_1_s4_q <= gx_1_s3_q;
      gy_1_s4_q <= gy_1_s3_q;
      grey_s4_q <= grey_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      select_25_s4_q <= select_25[0];
      select_48_s4_q <= select_48_s3_q;
      equal_54_s4_q <= select_25 == 5'h11;
      select_80_s4_q <= select_80_s3_q;
      select_97_s4_q <= select_97_s3_q;
      select_101_s4_q <= select_101_s3_q;
      and_113_s4_q <= and_113_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [7:0] next_gain_q;
  logic [21:0] divisor_q;
  logic [23:0] remainder_q;
  logic [23:0] difference_q;
  // hls/stages/contrast.hpp:106
  logic [7:0] select_55;
  assign select_55 = marks_first_s4_q ? 8'h40 : next_gain_q;
  // hls/stages/contrast.hpp:121
  logic not_56;
  assign not_56 = ~difference_q[23];
  // hls/stages/contrast.hpp:131
  logic [7:0] select_58;
  assign select_58 = equal_54_s4_q ? select_55 : (select_25_s4_q ? {select_55[6:0], not_56} : select_55);
  // hls/stages/contrast.hpp:124
  logic [23:0] select_65;
  assign select_65 = ({sums_right_q, 2'h0} < {2'h0, sums_left_q}) ? {sums_right_q, 2'h0} : {2'h0, sums_left_q};
  // hls/stages/contrast.hpp:126
  logic [22:0] select_66;
  assign select_66 = difference_q[23] ? remainder_q[22:0] : difference_q[22:0];
  // hls/stages/contrast.hpp:131
  logic [23:0] select_68;
  assign select_68 = equal_54_s4_q ? select_65 : (select_25_s4_q ? {select_66, 1'b0} : remainder_q);
  // hls/stages/contrast.hpp:129
  logic [23:0] difference_69;
  assign difference_69 = {1'b0, remainder_q[23:1]} - {2'h0, divisor_q};
  // hls/stages/contrast.hpp:131
  logic [23:0] select_70;
  assign select_70 = select_25_s4_q ? difference_q : {difference_69[23], difference_69[21:0], remainder_q[0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      next_gain_q <= 8'h40;
      divisor_q <= 22'h0;
      remainder_q <= 24'h0;
      difference_q <= 24'h0;
    end else if (s4_en) begin
      next_gain_q <= select_58;
      divisor_q <= equal_54_s4_q ? sums_right_q : divisor_q;
      remainder_q <= select_68;
      difference_q <= equal_54_s4_q ? difference_q : select_70;
    end
  end

  logic gx_1_s5_q;
  logic gy_1_s5_q;
  logic [7:0] grey_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic [7:0] select_48_s5_q;
  logic [5:0] select_80_s5_q;
  logic [4:0] select_97_s5_q;
  logic [7:0] select_101_s5_q;
  logic and_113_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      gx_1_s5_q <= gx_1_s4_q;
      gy_1_s5_q <= gy_1_s4_q;
      grey_s5_q <= grey_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      select_48_s5_q <= select_48_s4_q;
      select_80_s5_q <= select_80_s4_q;
      select_97_s5_q <= select_97_s4_q;
      select_101_s5_q <= select_101_s4_q;
      and_113_s5_q <= and_113_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [7:0] gain_q;
  // hls/stages/contrast.hpp:106
  logic [7:0] gain;
  assign gain = marks_first_s5_q ? 8'h40 : gain_q;
  // hls/stages/contrast.hpp:41
  logic [7:0] select_62;
  assign select_62 = marks_last_s5_q ? ((next_gain_q[7:4] == 4'h0) ? 8'h10 : next_gain_q) : gain;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      gain_q <= 8'h40;
    end else if (s5_en) begin
      gain_q <= select_62;
    end
  end

  logic gx_1_s6_q;
  logic gy_1_s6_q;
  logic [7:0] grey_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_seen_s6_q;
  logic marks_nearer_s6_q;
  logic [7:0] select_48_s6_q;
  logic [7:0] gain_s6_q;
  logic [5:0] select_80_s6_q;
  logic [4:0] select_97_s6_q;
  logic [7:0] select_101_s6_q;
  logic and_113_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      gx_1_s6_q <= gx_1_s5_q;
      gy_1_s6_q <= gy_1_s5_q;
      grey_s6_q <= grey_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_seen_s6_q <= marks_seen_s5_q;
      marks_nearer_s6_q <= marks_nearer_s5_q;
      select_48_s6_q <= select_48_s5_q;
      gain_s6_q <= gain;
      select_80_s6_q <= select_80_s5_q;
      select_97_s6_q <= select_97_s5_q;
      select_101_s6_q <= select_101_s5_q;
      and_113_s6_q <= and_113_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contrast.hpp:48
  logic [15:0] product_81;
  assign product_81 = {8'h0, gain_s6_q} * {8'h0, select_48_s6_q};
  logic [15:0] product_102;
  assign product_102 = {8'h0, gain_s6_q} * {8'h0, select_101_s6_q};

  logic gx_1_s7_q;
  logic gy_1_s7_q;
  logic [7:0] grey_s7_q;
  logic saturated_s7_q;
  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_seen_s7_q;
  logic marks_nearer_s7_q;
  logic [5:0] select_80_s7_q;
  logic [9:0] product_81_s7_q;
  logic [4:0] select_97_s7_q;
  logic [9:0] product_102_s7_q;
  logic and_113_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      gx_1_s7_q <= gx_1_s6_q;
      gy_1_s7_q <= gy_1_s6_q;
      grey_s7_q <= grey_s6_q;
      saturated_s7_q <= saturated_s6_q;
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_seen_s7_q <= marks_seen_s6_q;
      marks_nearer_s7_q <= marks_nearer_s6_q;
      select_80_s7_q <= select_80_s6_q;
      product_81_s7_q <= product_81[15:6];
      select_97_s7_q <= select_97_s6_q;
      product_102_s7_q <= product_102[15:6];
      and_113_s7_q <= and_113_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contrast.hpp:48
  logic [7:0] magnitude_2;
  assign magnitude_2 = (product_81_s7_q[9:8] == 2'h0) ? product_81_s7_q[7:0] : 8'hff;
  logic [7:0] magnitude_4;
  assign magnitude_4 = (product_102_s7_q[9:8] == 2'h0) ? product_102_s7_q[7:0] : 8'hff;

  logic gx_1_s8_q;
  logic gy_1_s8_q;
  logic [7:0] grey_s8_q;
  logic saturated_s8_q;
  logic mask_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_seen_s8_q;
  logic marks_nearer_s8_q;
  logic [5:0] select_80_s8_q;
  logic [4:0] select_85_s8_q;
  logic [4:0] select_97_s8_q;
  logic [3:0] select_106_s8_q;
  logic and_113_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      gx_1_s8_q <= gx_1_s7_q;
      gy_1_s8_q <= gy_1_s7_q;
      grey_s8_q <= grey_s7_q;
      saturated_s8_q <= saturated_s7_q;
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_seen_s8_q <= marks_seen_s7_q;
      marks_nearer_s8_q <= marks_nearer_s7_q;
      select_80_s8_q <= select_80_s7_q;
      select_85_s8_q <= (magnitude_2[7:5] == 3'h0) ? magnitude_2[4:0] : 5'h1f;
      select_97_s8_q <= select_97_s7_q;
      select_106_s8_q <= (magnitude_4[7:4] == 4'h0) ? magnitude_4[3:0] : 4'hf;
      and_113_s8_q <= and_113_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/contrast.hpp:45
  logic [4:0] size_2;
  assign size_2 = saturated_s8_q ? 5'h0 : select_85_s8_q;
  logic [3:0] size_4;
  assign size_4 = saturated_s8_q ? 4'h0 : select_106_s8_q;

  logic [7:0] grey_s9_q;
  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic marks_seen_s9_q;
  logic marks_nearer_s9_q;
  logic [5:0] select_80_s9_q;
  logic [5:0] select_88_s9_q;
  logic [4:0] select_97_s9_q;
  logic [4:0] select_109_s9_q;
  logic and_113_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      grey_s9_q <= grey_s8_q;
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      marks_seen_s9_q <= marks_seen_s8_q;
      marks_nearer_s9_q <= marks_nearer_s8_q;
      select_80_s9_q <= select_80_s8_q;
      select_88_s9_q <= gx_1_s8_q ? (6'h0 - {1'b0, size_2}) : {1'b0, size_2};
      select_97_s9_q <= select_97_s8_q;
      select_109_s9_q <= gy_1_s8_q ? (5'h0 - {1'b0, size_4}) : {1'b0, size_4};
      and_113_s9_q <= and_113_s8_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign left_o = select_80_s9_q;
  assign right_o = select_88_s9_q;
  assign left_y_o = select_97_s9_q;
  assign right_y_o = select_109_s9_q;
  assign edge_v_o = and_113_s9_q;
  assign mask_o = mask_s9_q;
  assign grey_o = grey_s9_q;
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
  assign unused_bits = ^{product_102[5:0], product_81[5:0], difference_69[22]};

endmodule
