// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::hd>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 8 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 158 bits, pipeline 651 bits, memories 0 bits.
module horopter_map_expand (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic prime_i,
  input  logic load_i,
  input  logic [15:0] column_top_x_i,
  input  logic [15:0] column_top_y_i,
  input  logic [15:0] column_bottom_x_i,
  input  logic [15:0] column_bottom_y_i,
  input  logic column_swapped_i,
  input  logic [5:0] row_fraction_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_live_i,
  input  logic [2:0] cfg_spacing_x_log2_i,
  output logic valid_o,
  output logic [10:0] x_o,
  output logic [10:0] y_o,
  output logic [2:0] wx_o,
  output logic [2:0] wy_o,
  output logic mapped_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_live_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;

  // Of the configuration alone: not pipelined.
  logic [2:0] up;
  assign up = (2'h2 < cfg_spacing_x_log2_i[2:1]) ? 3'h0 : (3'h6 - cfg_spacing_x_log2_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:30
  logic or_28;
  assign or_28 = (~(column_top_x_i == 16'hffff)) | (~(column_top_y_i == 16'hffff));
  logic equal_29;
  assign equal_29 = row_fraction_i == 6'h0;
  logic or_36;
  assign or_36 = (~(column_bottom_x_i == 16'hffff)) | (~(column_bottom_y_i == 16'hffff));
  // hls/stages/map_expand.hpp:70
  logic and_40;
  assign and_40 = (or_28 | (column_swapped_i & equal_29)) & (or_36 | (equal_29 & (~column_swapped_i)));
  // hls/stages/map_expand.hpp:142
  logic [15:0] select_43;
  assign select_43 = column_swapped_i ? column_top_x_i : column_bottom_x_i;
  // hls/stages/map_expand.hpp:141
  logic [15:0] from;
  assign from = column_swapped_i ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:142
  logic [16:0] difference;
  assign difference = {1'b0, select_43} - {1'b0, from};
  logic [15:0] select_69;
  assign select_69 = column_swapped_i ? column_top_y_i : column_bottom_y_i;
  // hls/stages/map_expand.hpp:141
  logic [15:0] from_2;
  assign from_2 = column_swapped_i ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:142
  logic [16:0] difference_2;
  assign difference_2 = {1'b0, select_69} - {1'b0, from_2};

  logic prime_s1_q;
  logic load_s1_q;
  logic [5:0] row_fraction_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic and_40_s1_q;
  logic [15:0] from_s1_q;
  logic [16:0] difference_s1_q;
  logic [15:0] from_2_s1_q;
  logic [16:0] difference_2_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      prime_s1_q <= prime_i;
      load_s1_q <= load_i;
      row_fraction_s1_q <= row_fraction_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      and_40_s1_q <= and_40;
      from_s1_q <= from;
      difference_s1_q <= difference;
      from_2_s1_q <= from_2;
      difference_2_s1_q <= difference_2;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:143
  logic [16:0] select_49;
  assign select_49 = row_fraction_s1_q[2] ? difference_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:144
  logic [16:0] select_50;
  assign select_50 = row_fraction_s1_q[3] ? difference_s1_q : 17'h0;
  logic [17:0] sum_51;
  assign sum_51 = {select_50[16], select_50} + {{2{select_49[16]}}, select_49[16:1]};
  // hls/stages/map_expand.hpp:143
  logic [16:0] select_52;
  assign select_52 = row_fraction_s1_q[4] ? difference_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:144
  logic [16:0] sum_54;
  assign sum_54 = (row_fraction_s1_q[5] ? difference_s1_q : 17'h0) + {select_52[16], select_52[16:1]};
  // hls/stages/map_expand.hpp:143
  logic [16:0] select_75;
  assign select_75 = row_fraction_s1_q[2] ? difference_2_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:144
  logic [16:0] select_76;
  assign select_76 = row_fraction_s1_q[3] ? difference_2_s1_q : 17'h0;
  logic [17:0] sum_77;
  assign sum_77 = {select_76[16], select_76} + {{2{select_75[16]}}, select_75[16:1]};
  // hls/stages/map_expand.hpp:143
  logic [16:0] select_78;
  assign select_78 = row_fraction_s1_q[4] ? difference_2_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:144
  logic [16:0] sum_80;
  assign sum_80 = (row_fraction_s1_q[5] ? difference_2_s1_q : 17'h0) + {select_78[16], select_78[16:1]};

  logic prime_s2_q;
  logic load_s2_q;
  logic [1:0] row_fraction_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_live_s2_q;
  logic and_40_s2_q;
  logic [15:0] from_s2_q;
  logic [16:0] difference_s2_q;
  logic select_49_s2_q;
  logic [17:0] sum_51_s2_q;
  logic select_52_s2_q;
  logic [16:0] sum_54_s2_q;
  logic [15:0] from_2_s2_q;
  logic [16:0] difference_2_s2_q;
  logic select_75_s2_q;
  logic [17:0] sum_77_s2_q;
  logic select_78_s2_q;
  logic [16:0] sum_80_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      prime_s2_q <= prime_s1_q;
      load_s2_q <= load_s1_q;
      row_fraction_s2_q <= row_fraction_s1_q[1:0];
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_live_s2_q <= marks_live_s1_q;
      and_40_s2_q <= and_40_s1_q;
      from_s2_q <= from_s1_q;
      difference_s2_q <= difference_s1_q;
      select_49_s2_q <= select_49[0];
      sum_51_s2_q <= sum_51;
      select_52_s2_q <= select_52[0];
      sum_54_s2_q <= sum_54;
      from_2_s2_q <= from_2_s1_q;
      difference_2_s2_q <= difference_2_s1_q;
      select_75_s2_q <= select_75[0];
      sum_77_s2_q <= sum_77;
      select_78_s2_q <= select_78[0];
      sum_80_s2_q <= sum_80;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:143
  logic [16:0] select_46;
  assign select_46 = row_fraction_s2_q[0] ? difference_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:144
  logic [16:0] select_47;
  assign select_47 = row_fraction_s2_q[1] ? difference_s2_q : 17'h0;
  logic [17:0] sum_48;
  assign sum_48 = {select_47[16], select_47} + {{2{select_46[16]}}, select_46[16:1]};
  // hls/stages/map_expand.hpp:145
  logic [17:0] sum_55;
  assign sum_55 = {sum_51_s2_q[17], sum_51_s2_q[17:1]} + {sum_54_s2_q, select_52_s2_q};
  // hls/stages/map_expand.hpp:143
  logic [16:0] select_72;
  assign select_72 = row_fraction_s2_q[0] ? difference_2_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:144
  logic [16:0] select_73;
  assign select_73 = row_fraction_s2_q[1] ? difference_2_s2_q : 17'h0;
  logic [17:0] sum_74;
  assign sum_74 = {select_73[16], select_73} + {{2{select_72[16]}}, select_72[16:1]};
  // hls/stages/map_expand.hpp:145
  logic [17:0] sum_81;
  assign sum_81 = {sum_77_s2_q[17], sum_77_s2_q[17:1]} + {sum_80_s2_q, select_78_s2_q};

  logic prime_s3_q;
  logic load_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_live_s3_q;
  logic and_40_s3_q;
  logic [15:0] from_s3_q;
  logic select_46_s3_q;
  logic [17:0] sum_48_s3_q;
  logic select_49_s3_q;
  logic sum_51_s3_q;
  logic [17:0] sum_55_s3_q;
  logic [15:0] from_2_s3_q;
  logic select_72_s3_q;
  logic [17:0] sum_74_s3_q;
  logic select_75_s3_q;
  logic sum_77_s3_q;
  logic [17:0] sum_81_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      prime_s3_q <= prime_s2_q;
      load_s3_q <= load_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_live_s3_q <= marks_live_s2_q;
      and_40_s3_q <= and_40_s2_q;
      from_s3_q <= from_s2_q;
      select_46_s3_q <= select_46[0];
      sum_48_s3_q <= sum_48;
      select_49_s3_q <= select_49_s2_q;
      sum_51_s3_q <= sum_51_s2_q[0];
      sum_55_s3_q <= sum_55;
      from_2_s3_q <= from_2_s2_q;
      select_72_s3_q <= select_72[0];
      sum_74_s3_q <= sum_74;
      select_75_s3_q <= select_75_s2_q;
      sum_77_s3_q <= sum_77_s2_q[0];
      sum_81_s3_q <= sum_81;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:145
  logic [19:0] sum_56;
  assign sum_56 = {{3{sum_48_s3_q[17]}}, sum_48_s3_q[17:1]} + {sum_55_s3_q, sum_51_s3_q, select_49_s3_q};
  logic [19:0] sum_82;
  assign sum_82 = {{3{sum_74_s3_q[17]}}, sum_74_s3_q[17:1]} + {sum_81_s3_q, sum_77_s3_q, select_75_s3_q};

  logic prime_s4_q;
  logic load_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_live_s4_q;
  logic and_40_s4_q;
  logic [15:0] from_s4_q;
  logic select_46_s4_q;
  logic sum_48_s4_q;
  logic [19:0] sum_56_s4_q;
  logic [15:0] from_2_s4_q;
  logic select_72_s4_q;
  logic sum_74_s4_q;
  logic [19:0] sum_82_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      prime_s4_q <= prime_s3_q;
      load_s4_q <= load_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_live_s4_q <= marks_live_s3_q;
      and_40_s4_q <= and_40_s3_q;
      from_s4_q <= from_s3_q;
      select_46_s4_q <= select_46_s3_q;
      sum_48_s4_q <= sum_48_s3_q[0];
      sum_56_s4_q <= sum_56;
      from_2_s4_q <= from_2_s3_q;
      select_72_s4_q <= select_72_s3_q;
      sum_74_s4_q <= sum_74_s3_q[0];
      sum_82_s4_q <= sum_82;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------

  logic prime_s5_q;
  logic load_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_live_s5_q;
  logic and_40_s5_q;
  logic select_46_s5_q;
  logic sum_48_s5_q;
  logic [3:0] sum_56_s5_q;
  logic [15:0] sum_57_s5_q;
  logic select_72_s5_q;
  logic sum_74_s5_q;
  logic [3:0] sum_82_s5_q;
  logic [15:0] sum_83_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      prime_s5_q <= prime_s4_q;
      load_s5_q <= load_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_live_s5_q <= marks_live_s4_q;
      and_40_s5_q <= and_40_s4_q;
      select_46_s5_q <= select_46_s4_q;
      sum_48_s5_q <= sum_48_s4_q;
      sum_56_s5_q <= sum_56_s4_q[3:0];
      sum_57_s5_q <= from_s4_q + sum_56_s4_q[19:4];
      select_72_s5_q <= select_72_s4_q;
      sum_74_s5_q <= sum_74_s4_q;
      sum_82_s5_q <= sum_82_s4_q[3:0];
      sum_83_s5_q <= from_2_s4_q + sum_82_s4_q[19:4];
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic right_valid_q;
  logic left_valid_q;
  logic [21:0] x_right_q;
  logic [21:0] y_right_q;
  // hls/stages/map_expand.hpp:66
  logic not_21;
  assign not_21 = ~prime_s5_q;
  // hls/stages/map_expand.hpp:67
  logic and_22;
  assign and_22 = load_s5_q & not_21;
  // hls/stages/map_expand.hpp:111
  logic or_23;
  assign or_23 = prime_s5_q | and_22;
  // hls/stages/map_expand.hpp:74
  logic select_42;
  assign select_42 = and_22 ? right_valid_q : left_valid_q;
  // hls/stages/map_expand.hpp:112
  logic [21:0] select_58;
  assign select_58 = or_23 ? {sum_57_s5_q, sum_56_s5_q, sum_48_s5_q, select_46_s5_q} : x_right_q;
  // hls/stages/map_expand.hpp:109
  logic [22:0] value_2;
  assign value_2 = {1'b0, sum_57_s5_q, sum_56_s5_q, sum_48_s5_q, select_46_s5_q} - {1'b0, x_right_q};
  // hls/stages/map_expand.hpp:96
  logic [22:0] select_64;
  assign select_64 = up[0] ? {value_2[21:0], 1'b0} : value_2;
  // hls/stages/map_expand.hpp:112
  logic [21:0] select_84;
  assign select_84 = or_23 ? {sum_83_s5_q, sum_82_s5_q, sum_74_s5_q, select_72_s5_q} : y_right_q;
  // hls/stages/map_expand.hpp:109
  logic [22:0] value_5;
  assign value_5 = {1'b0, sum_83_s5_q, sum_82_s5_q, sum_74_s5_q, select_72_s5_q} - {1'b0, y_right_q};
  // hls/stages/map_expand.hpp:96
  logic [22:0] select_87;
  assign select_87 = up[0] ? {value_5[21:0], 1'b0} : value_5;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      x_right_q <= 22'h0;
      y_right_q <= 22'h0;
    end else if (s5_en) begin
      right_valid_q <= or_23 ? and_40_s5_q : right_valid_q;
      left_valid_q <= select_42;
      x_right_q <= select_58;
      y_right_q <= select_84;
    end
  end

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_live_s6_q;
  logic [21:0] x_right_s6_q;
  logic [21:0] y_right_s6_q;
  logic not_21_s6_q;
  logic and_22_s6_q;
  logic value_2_s6_q;
  logic [24:0] select_65_s6_q;
  logic value_5_s6_q;
  logic [24:0] select_88_s6_q;
  logic and_101_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_live_s6_q <= marks_live_s5_q;
      x_right_s6_q <= x_right_q;
      y_right_s6_q <= y_right_q;
      not_21_s6_q <= not_21;
      and_22_s6_q <= and_22;
      value_2_s6_q <= value_2[22];
      select_65_s6_q <= up[1] ? {select_64, 2'h0} : {{2{value_2[22]}}, select_64};
      value_5_s6_q <= value_5[22];
      select_88_s6_q <= up[1] ? {select_87, 2'h0} : {{2{value_5[22]}}, select_87};
      and_101_s6_q <= (right_valid_q | and_22) & select_42;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [27:0] x_place_q;
  logic [27:0] x_increment_q;
  logic [27:0] y_place_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:111
  logic [27:0] value;
  assign value = and_22_s6_q ? {x_right_s6_q, 6'h0} : x_place_q;
  // hls/stages/map_expand.hpp:98
  logic [27:0] value_3;
  assign value_3 = up[2] ? {select_65_s6_q[23:0], 4'h0} : {{3{value_2_s6_q}}, select_65_s6_q};
  // hls/stages/map_expand.hpp:111
  logic [27:0] select_67;
  assign select_67 = and_22_s6_q ? value_3 : x_increment_q;
  logic [27:0] value_4;
  assign value_4 = and_22_s6_q ? {y_right_s6_q, 6'h0} : y_place_q;
  // hls/stages/map_expand.hpp:98
  logic [27:0] value_6;
  assign value_6 = up[2] ? {select_88_s6_q[23:0], 4'h0} : {{3{value_5_s6_q}}, select_88_s6_q};
  // hls/stages/map_expand.hpp:111
  logic [27:0] select_90;
  assign select_90 = and_22_s6_q ? value_6 : y_increment_q;
  // hls/stages/map_expand.hpp:181
  logic [15:0] sum_92;
  assign sum_92 = {1'b0, value[27:13]} + 16'h1;
  logic [15:0] sum_94;
  assign sum_94 = {1'b0, value_4[27:13]} + 16'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_place_q <= 28'h0;
      x_increment_q <= 28'h0;
      y_place_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s6_en) begin
      x_place_q <= value + select_67;
      x_increment_q <= select_67;
      y_place_q <= value_4 + select_90;
      y_increment_q <= select_90;
    end
  end

  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_live_s7_q;
  logic not_21_s7_q;
  logic [13:0] sum_92_s7_q;
  logic [13:0] sum_94_s7_q;
  logic not_97_s7_q;
  logic not_99_s7_q;
  logic and_101_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_live_s7_q <= marks_live_s6_q;
      not_21_s7_q <= not_21_s6_q;
      sum_92_s7_q <= sum_92[14:1];
      sum_94_s7_q <= sum_94[14:1];
      not_97_s7_q <= ~(sum_94[15:10] == 6'h0);
      not_99_s7_q <= ~(sum_92[15:10] == 6'h0);
      and_101_s7_q <= and_101_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------

  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_live_s8_q;
  logic [8:0] sum_92_s8_q;
  logic [4:0] sum_93_s8_q;
  logic [8:0] sum_94_s8_q;
  logic [4:0] sum_95_s8_q;
  logic and_103_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_live_s8_q <= marks_live_s7_q;
      sum_92_s8_q <= sum_92_s7_q[8:0];
      sum_93_s8_q <= sum_92_s7_q[13:9] + 5'h1f;
      sum_94_s8_q <= sum_94_s7_q[8:0];
      sum_95_s8_q <= sum_94_s7_q[13:9] + 5'h1f;
      and_103_s8_q <= not_97_s7_q & (not_99_s7_q & and_101_s7_q);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_93_s8_q, sum_92_s8_q[8:3]};
  assign y_o = {sum_95_s8_q, sum_94_s8_q[8:3]};
  assign wx_o = sum_92_s8_q[2:0];
  assign wy_o = sum_94_s8_q[2:0];
  assign mapped_o = and_103_s8_q;
  assign marks_first_o = marks_first_s8_q;
  assign marks_last_o = marks_last_s8_q;
  assign marks_live_o = marks_live_s8_q;
  assign valid_o = valid_s8_q;

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
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
      valid_s8_q <= valid_s7_q & not_21_s7_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_94[0], sum_92[0]};

endmodule
