// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::hd>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 8 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 160 bits, pipeline 659 bits, memories 0 bits.
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
  // hls/stages/map_expand.hpp:186
  logic equal_30;
  assign equal_30 = row_fraction_i == 6'h0;
  logic and_31;
  assign and_31 = column_swapped_i & equal_30;
  // hls/stages/map_expand.hpp:187
  logic and_34;
  assign and_34 = equal_30 & (~column_swapped_i);
  // hls/stages/map_expand.hpp:73
  logic and_36;
  assign and_36 = (column_top_exists_i | and_31) & (column_bottom_exists_i | and_34);
  logic and_41;
  assign and_41 = (column_top_of_skin_i | and_31) & (column_bottom_of_skin_i | and_34);
  // hls/stages/map_expand.hpp:154
  logic [15:0] select_44;
  assign select_44 = column_swapped_i ? column_top_x_i : column_bottom_x_i;
  // hls/stages/map_expand.hpp:153
  logic [15:0] from;
  assign from = column_swapped_i ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:154
  logic [16:0] difference;
  assign difference = {1'b0, select_44} - {1'b0, from};
  logic [15:0] select_70;
  assign select_70 = column_swapped_i ? column_top_y_i : column_bottom_y_i;
  // hls/stages/map_expand.hpp:153
  logic [15:0] from_2;
  assign from_2 = column_swapped_i ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:154
  logic [16:0] difference_2;
  assign difference_2 = {1'b0, select_70} - {1'b0, from_2};

  logic prime_s1_q;
  logic load_s1_q;
  logic [5:0] row_fraction_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic and_36_s1_q;
  logic and_41_s1_q;
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
      and_36_s1_q <= and_36;
      and_41_s1_q <= and_41;
      from_s1_q <= from;
      difference_s1_q <= difference;
      from_2_s1_q <= from_2;
      difference_2_s1_q <= difference_2;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:155
  logic [16:0] select_50;
  assign select_50 = row_fraction_s1_q[2] ? difference_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_51;
  assign select_51 = row_fraction_s1_q[3] ? difference_s1_q : 17'h0;
  logic [17:0] sum_52;
  assign sum_52 = {select_51[16], select_51} + {{2{select_50[16]}}, select_50[16:1]};
  // hls/stages/map_expand.hpp:155
  logic [16:0] select_53;
  assign select_53 = row_fraction_s1_q[4] ? difference_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:156
  logic [16:0] sum_55;
  assign sum_55 = (row_fraction_s1_q[5] ? difference_s1_q : 17'h0) + {select_53[16], select_53[16:1]};
  // hls/stages/map_expand.hpp:155
  logic [16:0] select_76;
  assign select_76 = row_fraction_s1_q[2] ? difference_2_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_77;
  assign select_77 = row_fraction_s1_q[3] ? difference_2_s1_q : 17'h0;
  logic [17:0] sum_78;
  assign sum_78 = {select_77[16], select_77} + {{2{select_76[16]}}, select_76[16:1]};
  // hls/stages/map_expand.hpp:155
  logic [16:0] select_79;
  assign select_79 = row_fraction_s1_q[4] ? difference_2_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:156
  logic [16:0] sum_81;
  assign sum_81 = (row_fraction_s1_q[5] ? difference_2_s1_q : 17'h0) + {select_79[16], select_79[16:1]};

  logic prime_s2_q;
  logic load_s2_q;
  logic [1:0] row_fraction_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_live_s2_q;
  logic and_36_s2_q;
  logic and_41_s2_q;
  logic [15:0] from_s2_q;
  logic [16:0] difference_s2_q;
  logic select_50_s2_q;
  logic [17:0] sum_52_s2_q;
  logic select_53_s2_q;
  logic [16:0] sum_55_s2_q;
  logic [15:0] from_2_s2_q;
  logic [16:0] difference_2_s2_q;
  logic select_76_s2_q;
  logic [17:0] sum_78_s2_q;
  logic select_79_s2_q;
  logic [16:0] sum_81_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      prime_s2_q <= prime_s1_q;
      load_s2_q <= load_s1_q;
      row_fraction_s2_q <= row_fraction_s1_q[1:0];
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_live_s2_q <= marks_live_s1_q;
      and_36_s2_q <= and_36_s1_q;
      and_41_s2_q <= and_41_s1_q;
      from_s2_q <= from_s1_q;
      difference_s2_q <= difference_s1_q;
      select_50_s2_q <= select_50[0];
      sum_52_s2_q <= sum_52;
      select_53_s2_q <= select_53[0];
      sum_55_s2_q <= sum_55;
      from_2_s2_q <= from_2_s1_q;
      difference_2_s2_q <= difference_2_s1_q;
      select_76_s2_q <= select_76[0];
      sum_78_s2_q <= sum_78;
      select_79_s2_q <= select_79[0];
      sum_81_s2_q <= sum_81;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:155
  logic [16:0] select_47;
  assign select_47 = row_fraction_s2_q[0] ? difference_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_48;
  assign select_48 = row_fraction_s2_q[1] ? difference_s2_q : 17'h0;
  logic [17:0] sum_49;
  assign sum_49 = {select_48[16], select_48} + {{2{select_47[16]}}, select_47[16:1]};
  // hls/stages/map_expand.hpp:157
  logic [17:0] sum_56;
  assign sum_56 = {sum_52_s2_q[17], sum_52_s2_q[17:1]} + {sum_55_s2_q, select_53_s2_q};
  // hls/stages/map_expand.hpp:155
  logic [16:0] select_73;
  assign select_73 = row_fraction_s2_q[0] ? difference_2_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_74;
  assign select_74 = row_fraction_s2_q[1] ? difference_2_s2_q : 17'h0;
  logic [17:0] sum_75;
  assign sum_75 = {select_74[16], select_74} + {{2{select_73[16]}}, select_73[16:1]};
  // hls/stages/map_expand.hpp:157
  logic [17:0] sum_82;
  assign sum_82 = {sum_78_s2_q[17], sum_78_s2_q[17:1]} + {sum_81_s2_q, select_79_s2_q};

  logic prime_s3_q;
  logic load_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_live_s3_q;
  logic and_36_s3_q;
  logic and_41_s3_q;
  logic [15:0] from_s3_q;
  logic select_47_s3_q;
  logic [17:0] sum_49_s3_q;
  logic select_50_s3_q;
  logic sum_52_s3_q;
  logic [17:0] sum_56_s3_q;
  logic [15:0] from_2_s3_q;
  logic select_73_s3_q;
  logic [17:0] sum_75_s3_q;
  logic select_76_s3_q;
  logic sum_78_s3_q;
  logic [17:0] sum_82_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      prime_s3_q <= prime_s2_q;
      load_s3_q <= load_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_live_s3_q <= marks_live_s2_q;
      and_36_s3_q <= and_36_s2_q;
      and_41_s3_q <= and_41_s2_q;
      from_s3_q <= from_s2_q;
      select_47_s3_q <= select_47[0];
      sum_49_s3_q <= sum_49;
      select_50_s3_q <= select_50_s2_q;
      sum_52_s3_q <= sum_52_s2_q[0];
      sum_56_s3_q <= sum_56;
      from_2_s3_q <= from_2_s2_q;
      select_73_s3_q <= select_73[0];
      sum_75_s3_q <= sum_75;
      select_76_s3_q <= select_76_s2_q;
      sum_78_s3_q <= sum_78_s2_q[0];
      sum_82_s3_q <= sum_82;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:157
  logic [19:0] sum_57;
  assign sum_57 = {{3{sum_49_s3_q[17]}}, sum_49_s3_q[17:1]} + {sum_56_s3_q, sum_52_s3_q, select_50_s3_q};
  logic [19:0] sum_83;
  assign sum_83 = {{3{sum_75_s3_q[17]}}, sum_75_s3_q[17:1]} + {sum_82_s3_q, sum_78_s3_q, select_76_s3_q};

  logic prime_s4_q;
  logic load_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_live_s4_q;
  logic and_36_s4_q;
  logic and_41_s4_q;
  logic [15:0] from_s4_q;
  logic select_47_s4_q;
  logic sum_49_s4_q;
  logic [19:0] sum_57_s4_q;
  logic [15:0] from_2_s4_q;
  logic select_73_s4_q;
  logic sum_75_s4_q;
  logic [19:0] sum_83_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      prime_s4_q <= prime_s3_q;
      load_s4_q <= load_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_live_s4_q <= marks_live_s3_q;
      and_36_s4_q <= and_36_s3_q;
      and_41_s4_q <= and_41_s3_q;
      from_s4_q <= from_s3_q;
      select_47_s4_q <= select_47_s3_q;
      sum_49_s4_q <= sum_49_s3_q[0];
      sum_57_s4_q <= sum_57;
      from_2_s4_q <= from_2_s3_q;
      select_73_s4_q <= select_73_s3_q;
      sum_75_s4_q <= sum_75_s3_q[0];
      sum_83_s4_q <= sum_83;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------

  logic prime_s5_q;
  logic load_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_live_s5_q;
  logic and_36_s5_q;
  logic and_41_s5_q;
  logic select_47_s5_q;
  logic sum_49_s5_q;
  logic [3:0] sum_57_s5_q;
  logic [15:0] sum_58_s5_q;
  logic select_73_s5_q;
  logic sum_75_s5_q;
  logic [3:0] sum_83_s5_q;
  logic [15:0] sum_84_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      prime_s5_q <= prime_s4_q;
      load_s5_q <= load_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_live_s5_q <= marks_live_s4_q;
      and_36_s5_q <= and_36_s4_q;
      and_41_s5_q <= and_41_s4_q;
      select_47_s5_q <= select_47_s4_q;
      sum_49_s5_q <= sum_49_s4_q;
      sum_57_s5_q <= sum_57_s4_q[3:0];
      sum_58_s5_q <= from_s4_q + sum_57_s4_q[19:4];
      select_73_s5_q <= select_73_s4_q;
      sum_75_s5_q <= sum_75_s4_q;
      sum_83_s5_q <= sum_83_s4_q[3:0];
      sum_84_s5_q <= from_2_s4_q + sum_83_s4_q[19:4];
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic right_valid_q;
  logic left_valid_q;
  logic right_of_skin_q;
  logic left_of_skin_q;
  logic [21:0] x_right_q;
  logic [21:0] y_right_q;
  // hls/stages/map_expand.hpp:68
  logic not_27;
  assign not_27 = ~prime_s5_q;
  // hls/stages/map_expand.hpp:69
  logic and_28;
  assign and_28 = load_s5_q & not_27;
  // hls/stages/map_expand.hpp:123
  logic or_29;
  assign or_29 = prime_s5_q | and_28;
  // hls/stages/map_expand.hpp:80
  logic select_38;
  assign select_38 = and_28 ? right_valid_q : left_valid_q;
  logic select_43;
  assign select_43 = and_28 ? right_of_skin_q : left_of_skin_q;
  // hls/stages/map_expand.hpp:124
  logic [21:0] select_59;
  assign select_59 = or_29 ? {sum_58_s5_q, sum_57_s5_q, sum_49_s5_q, select_47_s5_q} : x_right_q;
  // hls/stages/map_expand.hpp:121
  logic [22:0] value_2;
  assign value_2 = {1'b0, sum_58_s5_q, sum_57_s5_q, sum_49_s5_q, select_47_s5_q} - {1'b0, x_right_q};
  // hls/stages/map_expand.hpp:108
  logic [22:0] select_65;
  assign select_65 = up[0] ? {value_2[21:0], 1'b0} : value_2;
  // hls/stages/map_expand.hpp:124
  logic [21:0] select_85;
  assign select_85 = or_29 ? {sum_84_s5_q, sum_83_s5_q, sum_75_s5_q, select_73_s5_q} : y_right_q;
  // hls/stages/map_expand.hpp:121
  logic [22:0] value_5;
  assign value_5 = {1'b0, sum_84_s5_q, sum_83_s5_q, sum_75_s5_q, select_73_s5_q} - {1'b0, y_right_q};
  // hls/stages/map_expand.hpp:108
  logic [22:0] select_88;
  assign select_88 = up[0] ? {value_5[21:0], 1'b0} : value_5;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      right_of_skin_q <= 1'b0;
      left_of_skin_q <= 1'b0;
      x_right_q <= 22'h0;
      y_right_q <= 22'h0;
    end else if (s5_en) begin
      right_valid_q <= or_29 ? and_36_s5_q : right_valid_q;
      left_valid_q <= select_38;
      right_of_skin_q <= or_29 ? and_41_s5_q : right_of_skin_q;
      left_of_skin_q <= select_43;
      x_right_q <= select_59;
      y_right_q <= select_85;
    end
  end

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_live_s6_q;
  logic [21:0] x_right_s6_q;
  logic [21:0] y_right_s6_q;
  logic not_27_s6_q;
  logic and_28_s6_q;
  logic value_2_s6_q;
  logic [24:0] select_66_s6_q;
  logic value_5_s6_q;
  logic [24:0] select_89_s6_q;
  logic and_103_s6_q;
  logic and_106_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_live_s6_q <= marks_live_s5_q;
      x_right_s6_q <= x_right_q;
      y_right_s6_q <= y_right_q;
      not_27_s6_q <= not_27;
      and_28_s6_q <= and_28;
      value_2_s6_q <= value_2[22];
      select_66_s6_q <= up[1] ? {select_65, 2'h0} : {{2{value_2[22]}}, select_65};
      value_5_s6_q <= value_5[22];
      select_89_s6_q <= up[1] ? {select_88, 2'h0} : {{2{value_5[22]}}, select_88};
      and_103_s6_q <= (right_of_skin_q | and_28) & select_43;
      and_106_s6_q <= (right_valid_q | and_28) & select_38;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [27:0] x_place_q;
  logic [27:0] x_increment_q;
  logic [27:0] y_place_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:123
  logic [27:0] value;
  assign value = and_28_s6_q ? {x_right_s6_q, 6'h0} : x_place_q;
  // hls/stages/map_expand.hpp:110
  logic [27:0] value_3;
  assign value_3 = up[2] ? {select_66_s6_q[23:0], 4'h0} : {{3{value_2_s6_q}}, select_66_s6_q};
  // hls/stages/map_expand.hpp:123
  logic [27:0] select_68;
  assign select_68 = and_28_s6_q ? value_3 : x_increment_q;
  logic [27:0] value_4;
  assign value_4 = and_28_s6_q ? {y_right_s6_q, 6'h0} : y_place_q;
  // hls/stages/map_expand.hpp:110
  logic [27:0] value_6;
  assign value_6 = up[2] ? {select_89_s6_q[23:0], 4'h0} : {{3{value_5_s6_q}}, select_89_s6_q};
  // hls/stages/map_expand.hpp:123
  logic [27:0] select_91;
  assign select_91 = and_28_s6_q ? value_6 : y_increment_q;
  // hls/stages/map_expand.hpp:195
  logic [15:0] sum_93;
  assign sum_93 = {1'b0, value[27:13]} + 16'h1;
  logic [15:0] sum_95;
  assign sum_95 = {1'b0, value_4[27:13]} + 16'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_place_q <= 28'h0;
      x_increment_q <= 28'h0;
      y_place_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s6_en) begin
      x_place_q <= value + select_68;
      x_increment_q <= select_68;
      y_place_q <= value_4 + select_91;
      y_increment_q <= select_91;
    end
  end

  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_live_s7_q;
  logic not_27_s7_q;
  logic [13:0] sum_93_s7_q;
  logic [13:0] sum_95_s7_q;
  logic not_98_s7_q;
  logic not_100_s7_q;
  logic and_103_s7_q;
  logic and_106_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_live_s7_q <= marks_live_s6_q;
      not_27_s7_q <= not_27_s6_q;
      sum_93_s7_q <= sum_93[14:1];
      sum_95_s7_q <= sum_95[14:1];
      not_98_s7_q <= ~(sum_93[15:10] == 6'h0);
      not_100_s7_q <= ~(sum_95[15:10] == 6'h0);
      and_103_s7_q <= and_103_s6_q;
      and_106_s7_q <= and_106_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:87
  logic and_101;
  assign and_101 = not_98_s7_q & not_100_s7_q;

  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_live_s8_q;
  logic [8:0] sum_93_s8_q;
  logic [4:0] sum_94_s8_q;
  logic [8:0] sum_95_s8_q;
  logic [4:0] sum_96_s8_q;
  logic and_104_s8_q;
  logic and_107_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_live_s8_q <= marks_live_s7_q;
      sum_93_s8_q <= sum_93_s7_q[8:0];
      sum_94_s8_q <= sum_93_s7_q[13:9] + 5'h1f;
      sum_95_s8_q <= sum_95_s7_q[8:0];
      sum_96_s8_q <= sum_95_s7_q[13:9] + 5'h1f;
      and_104_s8_q <= and_101 & and_103_s7_q;
      and_107_s8_q <= and_101 & and_106_s7_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_94_s8_q, sum_93_s8_q[8:3]};
  assign y_o = {sum_96_s8_q, sum_95_s8_q[8:3]};
  assign wx_o = sum_93_s8_q[2:0];
  assign wy_o = sum_95_s8_q[2:0];
  assign mapped_o = and_104_s8_q;
  assign present_o = and_107_s8_q;
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
      valid_s8_q <= valid_s7_q & not_27_s7_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_95[0], sum_93[0]};

endmodule
