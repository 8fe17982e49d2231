// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::hd>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 160 bits, pipeline 715 bits, memories 0 bits.
module horopter_map_expand (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic prime_i,
  input  logic load_i,
  input  logic [15:0] column_top_x_i,
  input  logic [15:0] column_top_y_i,
  input  logic column_top_exists_i,
  input  logic column_top_of_skin_i,
  input  logic [15:0] column_bottom_x_i,
  input  logic [15:0] column_bottom_y_i,
  input  logic column_bottom_exists_i,
  input  logic column_bottom_of_skin_i,
  input  logic column_swapped_i,
  input  logic [5:0] row_fraction_i,
  input  logic outside_i,
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
  output logic present_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_live_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q;
  logic s5_en, s6_en, s7_en, s8_en;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;

  // Of the configuration alone: not pipelined.
  logic [2:0] up;
  assign up = (2'h2 < cfg_spacing_x_log2_i[2:1]) ? 3'h0 : (3'h6 - cfg_spacing_x_log2_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:189
  logic equal_31;
  assign equal_31 = row_fraction_i == 6'h0;
  logic and_32;
  assign and_32 = column_swapped_i & equal_31;
  // hls/stages/map_expand.hpp:190
  logic and_35;
  assign and_35 = equal_31 & (~column_swapped_i);
  // hls/stages/map_expand.hpp:76
  logic and_37;
  assign and_37 = (column_top_exists_i | and_32) & (column_bottom_exists_i | and_35);
  logic and_42;
  assign and_42 = (column_top_of_skin_i | and_32) & (column_bottom_of_skin_i | and_35);
  // hls/stages/map_expand.hpp:157
  logic [15:0] select_45;
  assign select_45 = column_swapped_i ? column_top_x_i : column_bottom_x_i;
  // hls/stages/map_expand.hpp:156
  logic [15:0] from;
  assign from = column_swapped_i ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:157
  logic [16:0] difference;
  assign difference = {1'b0, select_45} - {1'b0, from};
  logic [15:0] select_71;
  assign select_71 = column_swapped_i ? column_top_y_i : column_bottom_y_i;
  // hls/stages/map_expand.hpp:156
  logic [15:0] from_2;
  assign from_2 = column_swapped_i ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:157
  logic [16:0] difference_2;
  assign difference_2 = {1'b0, select_71} - {1'b0, from_2};

  logic prime_s1_q;
  logic load_s1_q;
  logic [5:0] row_fraction_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic and_37_s1_q;
  logic and_42_s1_q;
  logic [15:0] from_s1_q;
  logic [16:0] difference_s1_q;
  logic [15:0] from_2_s1_q;
  logic [16:0] difference_2_s1_q;
  logic not_106_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      prime_s1_q <= prime_i;
      load_s1_q <= load_i;
      row_fraction_s1_q <= row_fraction_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      and_37_s1_q <= and_37;
      and_42_s1_q <= and_42;
      from_s1_q <= from;
      difference_s1_q <= difference;
      from_2_s1_q <= from_2;
      difference_2_s1_q <= difference_2;
      not_106_s1_q <= ~outside_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_51;
  assign select_51 = row_fraction_s1_q[2] ? difference_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_52;
  assign select_52 = row_fraction_s1_q[3] ? difference_s1_q : 17'h0;
  logic [17:0] sum_53;
  assign sum_53 = {select_52[16], select_52} + {{2{select_51[16]}}, select_51[16:1]};
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_54;
  assign select_54 = row_fraction_s1_q[4] ? difference_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:159
  logic [16:0] sum_56;
  assign sum_56 = (row_fraction_s1_q[5] ? difference_s1_q : 17'h0) + {select_54[16], select_54[16:1]};
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_77;
  assign select_77 = row_fraction_s1_q[2] ? difference_2_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_78;
  assign select_78 = row_fraction_s1_q[3] ? difference_2_s1_q : 17'h0;
  logic [17:0] sum_79;
  assign sum_79 = {select_78[16], select_78} + {{2{select_77[16]}}, select_77[16:1]};
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_80;
  assign select_80 = row_fraction_s1_q[4] ? difference_2_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:159
  logic [16:0] sum_82;
  assign sum_82 = (row_fraction_s1_q[5] ? difference_2_s1_q : 17'h0) + {select_80[16], select_80[16:1]};

  logic prime_s2_q;
  logic load_s2_q;
  logic [1:0] row_fraction_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_live_s2_q;
  logic and_37_s2_q;
  logic and_42_s2_q;
  logic [15:0] from_s2_q;
  logic [16:0] difference_s2_q;
  logic select_51_s2_q;
  logic [17:0] sum_53_s2_q;
  logic select_54_s2_q;
  logic [16:0] sum_56_s2_q;
  logic [15:0] from_2_s2_q;
  logic [16:0] difference_2_s2_q;
  logic select_77_s2_q;
  logic [17:0] sum_79_s2_q;
  logic select_80_s2_q;
  logic [16:0] sum_82_s2_q;
  logic not_106_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      prime_s2_q <= prime_s1_q;
      load_s2_q <= load_s1_q;
      row_fraction_s2_q <= row_fraction_s1_q[1:0];
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_live_s2_q <= marks_live_s1_q;
      and_37_s2_q <= and_37_s1_q;
      and_42_s2_q <= and_42_s1_q;
      from_s2_q <= from_s1_q;
      difference_s2_q <= difference_s1_q;
      select_51_s2_q <= select_51[0];
      sum_53_s2_q <= sum_53;
      select_54_s2_q <= select_54[0];
      sum_56_s2_q <= sum_56;
      from_2_s2_q <= from_2_s1_q;
      difference_2_s2_q <= difference_2_s1_q;
      select_77_s2_q <= select_77[0];
      sum_79_s2_q <= sum_79;
      select_80_s2_q <= select_80[0];
      sum_82_s2_q <= sum_82;
      not_106_s2_q <= not_106_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_48;
  assign select_48 = row_fraction_s2_q[0] ? difference_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_49;
  assign select_49 = row_fraction_s2_q[1] ? difference_s2_q : 17'h0;
  logic [17:0] sum_50;
  assign sum_50 = {select_49[16], select_49} + {{2{select_48[16]}}, select_48[16:1]};
  // hls/stages/map_expand.hpp:160
  logic [17:0] sum_57;
  assign sum_57 = {sum_53_s2_q[17], sum_53_s2_q[17:1]} + {sum_56_s2_q, select_54_s2_q};
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_74;
  assign select_74 = row_fraction_s2_q[0] ? difference_2_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_75;
  assign select_75 = row_fraction_s2_q[1] ? difference_2_s2_q : 17'h0;
  logic [17:0] sum_76;
  assign sum_76 = {select_75[16], select_75} + {{2{select_74[16]}}, select_74[16:1]};
  // hls/stages/map_expand.hpp:160
  logic [17:0] sum_83;
  assign sum_83 = {sum_79_s2_q[17], sum_79_s2_q[17:1]} + {sum_82_s2_q, select_80_s2_q};

  logic prime_s3_q;
  logic load_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_live_s3_q;
  logic and_37_s3_q;
  logic and_42_s3_q;
  logic [15:0] from_s3_q;
  logic select_48_s3_q;
  logic [17:0] sum_50_s3_q;
  logic select_51_s3_q;
  logic sum_53_s3_q;
  logic [17:0] sum_57_s3_q;
  logic [15:0] from_2_s3_q;
  logic select_74_s3_q;
  logic [17:0] sum_76_s3_q;
  logic select_77_s3_q;
  logic sum_79_s3_q;
  logic [17:0] sum_83_s3_q;
  logic not_106_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      prime_s3_q <= prime_s2_q;
      load_s3_q <= load_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_live_s3_q <= marks_live_s2_q;
      and_37_s3_q <= and_37_s2_q;
      and_42_s3_q <= and_42_s2_q;
      from_s3_q <= from_s2_q;
      select_48_s3_q <= select_48[0];
      sum_50_s3_q <= sum_50;
      select_51_s3_q <= select_51_s2_q;
      sum_53_s3_q <= sum_53_s2_q[0];
      sum_57_s3_q <= sum_57;
      from_2_s3_q <= from_2_s2_q;
      select_74_s3_q <= select_74[0];
      sum_76_s3_q <= sum_76;
      select_77_s3_q <= select_77_s2_q;
      sum_79_s3_q <= sum_79_s2_q[0];
      sum_83_s3_q <= sum_83;
      not_106_s3_q <= not_106_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:160
  logic [19:0] sum_58;
  assign sum_58 = {{3{sum_50_s3_q[17]}}, sum_50_s3_q[17:1]} + {sum_57_s3_q, sum_53_s3_q, select_51_s3_q};
  logic [19:0] sum_84;
  assign sum_84 = {{3{sum_76_s3_q[17]}}, sum_76_s3_q[17:1]} + {sum_83_s3_q, sum_79_s3_q, select_77_s3_q};

  logic prime_s4_q;
  logic load_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_live_s4_q;
  logic and_37_s4_q;
  logic and_42_s4_q;
  logic [15:0] from_s4_q;
  logic select_48_s4_q;
  logic sum_50_s4_q;
  logic [19:0] sum_58_s4_q;
  logic [15:0] from_2_s4_q;
  logic select_74_s4_q;
  logic sum_76_s4_q;
  logic [19:0] sum_84_s4_q;
  logic not_106_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      prime_s4_q <= prime_s3_q;
      load_s4_q <= load_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_live_s4_q <= marks_live_s3_q;
      and_37_s4_q <= and_37_s3_q;
      and_42_s4_q <= and_42_s3_q;
      from_s4_q <= from_s3_q;
      select_48_s4_q <= select_48_s3_q;
      sum_50_s4_q <= sum_50_s3_q[0];
      sum_58_s4_q <= sum_58;
      from_2_s4_q <= from_2_s3_q;
      select_74_s4_q <= select_74_s3_q;
      sum_76_s4_q <= sum_76_s3_q[0];
      sum_84_s4_q <= sum_84;
      not_106_s4_q <= not_106_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------

  logic prime_s5_q;
  logic load_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_live_s5_q;
  logic and_37_s5_q;
  logic and_42_s5_q;
  logic select_48_s5_q;
  logic sum_50_s5_q;
  logic [3:0] sum_58_s5_q;
  logic [15:0] sum_59_s5_q;
  logic select_74_s5_q;
  logic sum_76_s5_q;
  logic [3:0] sum_84_s5_q;
  logic [15:0] sum_85_s5_q;
  logic not_106_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      prime_s5_q <= prime_s4_q;
      load_s5_q <= load_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_live_s5_q <= marks_live_s4_q;
      and_37_s5_q <= and_37_s4_q;
      and_42_s5_q <= and_42_s4_q;
      select_48_s5_q <= select_48_s4_q;
      sum_50_s5_q <= sum_50_s4_q;
      sum_58_s5_q <= sum_58_s4_q[3:0];
      sum_59_s5_q <= from_s4_q + sum_58_s4_q[19:4];
      select_74_s5_q <= select_74_s4_q;
      sum_76_s5_q <= sum_76_s4_q;
      sum_84_s5_q <= sum_84_s4_q[3:0];
      sum_85_s5_q <= from_2_s4_q + sum_84_s4_q[19:4];
      not_106_s5_q <= not_106_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic right_valid_q;
  logic left_valid_q;
  logic right_of_skin_q;
  logic left_of_skin_q;
  logic [21:0] x_right_q;
  logic [21:0] y_right_q;
  // hls/stages/map_expand.hpp:71
  logic not_28;
  assign not_28 = ~prime_s5_q;
  // hls/stages/map_expand.hpp:72
  logic and_29;
  assign and_29 = load_s5_q & not_28;
  // hls/stages/map_expand.hpp:126
  logic or_30;
  assign or_30 = prime_s5_q | and_29;
  // hls/stages/map_expand.hpp:83
  logic select_39;
  assign select_39 = and_29 ? right_valid_q : left_valid_q;
  logic select_44;
  assign select_44 = and_29 ? right_of_skin_q : left_of_skin_q;
  // hls/stages/map_expand.hpp:127
  logic [21:0] select_60;
  assign select_60 = or_30 ? {sum_59_s5_q, sum_58_s5_q, sum_50_s5_q, select_48_s5_q} : x_right_q;
  // hls/stages/map_expand.hpp:124
  logic [22:0] value_2;
  assign value_2 = {1'b0, sum_59_s5_q, sum_58_s5_q, sum_50_s5_q, select_48_s5_q} - {1'b0, x_right_q};
  // hls/stages/map_expand.hpp:127
  logic [21:0] select_86;
  assign select_86 = or_30 ? {sum_85_s5_q, sum_84_s5_q, sum_76_s5_q, select_74_s5_q} : y_right_q;
  // hls/stages/map_expand.hpp:124
  logic [22:0] value_5;
  assign value_5 = {1'b0, sum_85_s5_q, sum_84_s5_q, sum_76_s5_q, select_74_s5_q} - {1'b0, y_right_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      right_of_skin_q <= 1'b0;
      left_of_skin_q <= 1'b0;
      x_right_q <= 22'h0;
      y_right_q <= 22'h0;
    end else if (s5_en) begin
      right_valid_q <= or_30 ? and_37_s5_q : right_valid_q;
      left_valid_q <= select_39;
      right_of_skin_q <= or_30 ? and_42_s5_q : right_of_skin_q;
      left_of_skin_q <= select_44;
      x_right_q <= select_60;
      y_right_q <= select_86;
    end
  end

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_live_s6_q;
  logic [21:0] x_right_s6_q;
  logic [21:0] y_right_s6_q;
  logic not_28_s6_q;
  logic and_29_s6_q;
  logic value_2_s6_q;
  logic [22:0] select_66_s6_q;
  logic value_5_s6_q;
  logic [22:0] select_89_s6_q;
  logic and_104_s6_q;
  logic not_106_s6_q;
  logic and_109_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_live_s6_q <= marks_live_s5_q;
      x_right_s6_q <= x_right_q;
      y_right_s6_q <= y_right_q;
      not_28_s6_q <= not_28;
      and_29_s6_q <= and_29;
      value_2_s6_q <= value_2[22];
      select_66_s6_q <= up[0] ? {value_2[21:0], 1'b0} : value_2;
      value_5_s6_q <= value_5[22];
      select_89_s6_q <= up[0] ? {value_5[21:0], 1'b0} : value_5;
      and_104_s6_q <= (right_of_skin_q | and_29) & select_44;
      not_106_s6_q <= not_106_s5_q;
      and_109_s6_q <= (right_valid_q | and_29) & select_39;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [27:0] x_increment_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:112
  logic [24:0] select_67;
  assign select_67 = up[1] ? {select_66_s6_q, 2'h0} : {{2{value_2_s6_q}}, select_66_s6_q};
  // hls/stages/map_expand.hpp:113
  logic [27:0] value_3;
  assign value_3 = up[2] ? {select_67[23:0], 4'h0} : {{3{value_2_s6_q}}, select_67};
  // hls/stages/map_expand.hpp:112
  logic [24:0] select_90;
  assign select_90 = up[1] ? {select_89_s6_q, 2'h0} : {{2{value_5_s6_q}}, select_89_s6_q};
  // hls/stages/map_expand.hpp:113
  logic [27:0] value_6;
  assign value_6 = up[2] ? {select_90[23:0], 4'h0} : {{3{value_5_s6_q}}, select_90};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_increment_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s6_en) begin
      x_increment_q <= and_29_s6_q ? value_3 : x_increment_q;
      y_increment_q <= and_29_s6_q ? value_6 : y_increment_q;
    end
  end

  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_live_s7_q;
  logic [21:0] x_right_s7_q;
  logic [21:0] y_right_s7_q;
  logic not_28_s7_q;
  logic and_29_s7_q;
  logic and_104_s7_q;
  logic not_106_s7_q;
  logic and_109_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_live_s7_q <= marks_live_s6_q;
      x_right_s7_q <= x_right_s6_q;
      y_right_s7_q <= y_right_s6_q;
      not_28_s7_q <= not_28_s6_q;
      and_29_s7_q <= and_29_s6_q;
      and_104_s7_q <= and_104_s6_q;
      not_106_s7_q <= not_106_s6_q;
      and_109_s7_q <= and_109_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [27:0] x_place_q;
  logic [27:0] y_place_q;
  // hls/stages/map_expand.hpp:126
  logic [27:0] value;
  assign value = and_29_s7_q ? {x_right_s7_q, 6'h0} : x_place_q;
  logic [27:0] value_4;
  assign value_4 = and_29_s7_q ? {y_right_s7_q, 6'h0} : y_place_q;
  // hls/stages/map_expand.hpp:198
  logic [15:0] sum_94;
  assign sum_94 = {1'b0, value[27:13]} + 16'h1;
  logic [15:0] sum_96;
  assign sum_96 = {1'b0, value_4[27:13]} + 16'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_place_q <= 28'h0;
      y_place_q <= 28'h0;
    end else if (s7_en) begin
      x_place_q <= value + x_increment_q;
      y_place_q <= value_4 + y_increment_q;
    end
  end

  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_live_s8_q;
  logic not_28_s8_q;
  logic [13:0] sum_94_s8_q;
  logic [13:0] sum_96_s8_q;
  logic not_99_s8_q;
  logic not_101_s8_q;
  logic and_104_s8_q;
  logic not_106_s8_q;
  logic and_109_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_live_s8_q <= marks_live_s7_q;
      not_28_s8_q <= not_28_s7_q;
      sum_94_s8_q <= sum_94[14:1];
      sum_96_s8_q <= sum_96[14:1];
      not_99_s8_q <= ~(sum_94[15:10] == 6'h0);
      not_101_s8_q <= ~(sum_96[15:10] == 6'h0);
      and_104_s8_q <= and_104_s7_q;
      not_106_s8_q <= not_106_s7_q;
      and_109_s8_q <= and_109_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:90
  logic and_102;
  assign and_102 = not_99_s8_q & not_101_s8_q;

  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic marks_live_s9_q;
  logic [8:0] sum_94_s9_q;
  logic [4:0] sum_95_s9_q;
  logic [8:0] sum_96_s9_q;
  logic [4:0] sum_97_s9_q;
  logic and_107_s9_q;
  logic and_110_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      marks_live_s9_q <= marks_live_s8_q;
      sum_94_s9_q <= sum_94_s8_q[8:0];
      sum_95_s9_q <= sum_94_s8_q[13:9] + 5'h1f;
      sum_96_s9_q <= sum_96_s8_q[8:0];
      sum_97_s9_q <= sum_96_s8_q[13:9] + 5'h1f;
      and_107_s9_q <= (and_102 & and_104_s8_q) & not_106_s8_q;
      and_110_s9_q <= and_102 & and_109_s8_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_95_s9_q, sum_94_s9_q[8:3]};
  assign y_o = {sum_97_s9_q, sum_96_s9_q[8:3]};
  assign wx_o = sum_94_s9_q[2:0];
  assign wy_o = sum_96_s9_q[2:0];
  assign mapped_o = and_107_s9_q;
  assign present_o = and_110_s9_q;
  assign marks_first_o = marks_first_s9_q;
  assign marks_last_o = marks_last_s9_q;
  assign marks_live_o = marks_live_s9_q;
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
      valid_s9_q <= valid_s8_q & not_28_s8_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_96[0], sum_94[0]};

endmodule
