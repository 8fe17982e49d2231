// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::hd>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 9 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 160 bits, pipeline 721 bits, memories 0 bits.
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
  output logic present_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_live_o
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

  // Of the configuration alone: not pipelined.
  logic [2:0] up;
  assign up = (2'h2 < cfg_spacing_x_log2_i[2:1]) ? 3'h0 : (3'h6 - cfg_spacing_x_log2_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:191
  logic equal_26;
  assign equal_26 = row_fraction_i == 6'h0;
  logic and_27;
  assign and_27 = column_swapped_i & equal_26;
  // hls/stages/map_expand.hpp:192
  logic and_33;
  assign and_33 = equal_26 & (~column_swapped_i);
  // hls/stages/map_expand.hpp:193
  logic or_37;
  assign or_37 = and_33 | (~((column_bottom_x_i & column_bottom_y_i) == 16'hffff));
  logic and_38;
  assign and_38 = (and_27 | (~((column_top_x_i & column_top_y_i) == 16'hffff))) & or_37;
  // hls/stages/map_expand.hpp:35
  logic or_43;
  assign or_43 = (~column_top_y_i[15]) | (column_top_y_i[14:13] == 2'h0);
  // hls/stages/map_expand.hpp:32
  logic or_47;
  assign or_47 = (~column_bottom_y_i[15]) | (column_bottom_y_i[14:13] == 2'h0);
  // hls/stages/map_expand.hpp:159
  logic [15:0] select_52;
  assign select_52 = column_swapped_i ? column_top_x_i : column_bottom_x_i;
  // hls/stages/map_expand.hpp:158
  logic [15:0] from;
  assign from = column_swapped_i ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:159
  logic [16:0] difference;
  assign difference = {1'b0, select_52} - {1'b0, from};
  // hls/stages/map_expand.hpp:35
  logic [1:0] sum_78;
  assign sum_78 = column_top_y_i[14:13] + 2'h3;
  logic [15:0] a;
  assign a = or_43 ? column_top_y_i : {sum_78, column_top_y_i[12:0], 1'b0};
  logic [1:0] sum_80;
  assign sum_80 = column_bottom_y_i[14:13] + 2'h3;
  logic [15:0] b;
  assign b = or_47 ? column_bottom_y_i : {sum_80, column_bottom_y_i[12:0], 1'b0};
  // hls/stages/map_expand.hpp:158
  logic [15:0] from_2;
  assign from_2 = column_swapped_i ? b : a;

  logic prime_s1_q;
  logic load_s1_q;
  logic [5:0] row_fraction_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic and_38_s1_q;
  logic and_49_s1_q;
  logic [15:0] from_s1_q;
  logic [16:0] difference_s1_q;
  logic [15:0] select_82_s1_q;
  logic [15:0] from_2_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      prime_s1_q <= prime_i;
      load_s1_q <= load_i;
      row_fraction_s1_q <= row_fraction_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      and_38_s1_q <= and_38;
      and_49_s1_q <= (or_43 | and_27) & (or_47 | and_33);
      from_s1_q <= from;
      difference_s1_q <= difference;
      select_82_s1_q <= column_swapped_i ? a : b;
      from_2_s1_q <= from_2;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:160
  logic [16:0] select_58;
  assign select_58 = row_fraction_s1_q[2] ? difference_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:161
  logic [16:0] select_59;
  assign select_59 = row_fraction_s1_q[3] ? difference_s1_q : 17'h0;
  logic [17:0] sum_60;
  assign sum_60 = {select_59[16], select_59} + {{2{select_58[16]}}, select_58[16:1]};
  // hls/stages/map_expand.hpp:160
  logic [16:0] select_61;
  assign select_61 = row_fraction_s1_q[4] ? difference_s1_q : 17'h0;
  // hls/stages/map_expand.hpp:161
  logic [16:0] sum_63;
  assign sum_63 = (row_fraction_s1_q[5] ? difference_s1_q : 17'h0) + {select_61[16], select_61[16:1]};
  // hls/stages/map_expand.hpp:159
  logic [16:0] difference_2;
  assign difference_2 = {1'b0, select_82_s1_q} - {1'b0, from_2_s1_q};

  logic prime_s2_q;
  logic load_s2_q;
  logic [5:0] row_fraction_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_live_s2_q;
  logic and_38_s2_q;
  logic and_49_s2_q;
  logic [15:0] from_s2_q;
  logic [16:0] difference_s2_q;
  logic select_58_s2_q;
  logic [17:0] sum_60_s2_q;
  logic select_61_s2_q;
  logic [16:0] sum_63_s2_q;
  logic [15:0] from_2_s2_q;
  logic [16:0] difference_2_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      prime_s2_q <= prime_s1_q;
      load_s2_q <= load_s1_q;
      row_fraction_s2_q <= row_fraction_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_live_s2_q <= marks_live_s1_q;
      and_38_s2_q <= and_38_s1_q;
      and_49_s2_q <= and_49_s1_q;
      from_s2_q <= from_s1_q;
      difference_s2_q <= difference_s1_q;
      select_58_s2_q <= select_58[0];
      sum_60_s2_q <= sum_60;
      select_61_s2_q <= select_61[0];
      sum_63_s2_q <= sum_63;
      from_2_s2_q <= from_2_s1_q;
      difference_2_s2_q <= difference_2;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:160
  logic [16:0] select_55;
  assign select_55 = row_fraction_s2_q[0] ? difference_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:161
  logic [16:0] select_56;
  assign select_56 = row_fraction_s2_q[1] ? difference_s2_q : 17'h0;
  logic [17:0] sum_57;
  assign sum_57 = {select_56[16], select_56} + {{2{select_55[16]}}, select_55[16:1]};
  // hls/stages/map_expand.hpp:162
  logic [17:0] sum_64;
  assign sum_64 = {sum_60_s2_q[17], sum_60_s2_q[17:1]} + {sum_63_s2_q, select_61_s2_q};
  // hls/stages/map_expand.hpp:160
  logic [16:0] select_85;
  assign select_85 = row_fraction_s2_q[0] ? difference_2_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:161
  logic [16:0] select_86;
  assign select_86 = row_fraction_s2_q[1] ? difference_2_s2_q : 17'h0;
  logic [17:0] sum_87;
  assign sum_87 = {select_86[16], select_86} + {{2{select_85[16]}}, select_85[16:1]};
  // hls/stages/map_expand.hpp:160
  logic [16:0] select_88;
  assign select_88 = row_fraction_s2_q[2] ? difference_2_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:161
  logic [16:0] select_89;
  assign select_89 = row_fraction_s2_q[3] ? difference_2_s2_q : 17'h0;
  logic [17:0] sum_90;
  assign sum_90 = {select_89[16], select_89} + {{2{select_88[16]}}, select_88[16:1]};
  // hls/stages/map_expand.hpp:160
  logic [16:0] select_91;
  assign select_91 = row_fraction_s2_q[4] ? difference_2_s2_q : 17'h0;
  // hls/stages/map_expand.hpp:161
  logic [16:0] sum_93;
  assign sum_93 = (row_fraction_s2_q[5] ? difference_2_s2_q : 17'h0) + {select_91[16], select_91[16:1]};

  logic prime_s3_q;
  logic load_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_live_s3_q;
  logic and_38_s3_q;
  logic and_49_s3_q;
  logic [15:0] from_s3_q;
  logic select_55_s3_q;
  logic [17:0] sum_57_s3_q;
  logic select_58_s3_q;
  logic sum_60_s3_q;
  logic [17:0] sum_64_s3_q;
  logic [15:0] from_2_s3_q;
  logic select_85_s3_q;
  logic [17:0] sum_87_s3_q;
  logic select_88_s3_q;
  logic [17:0] sum_90_s3_q;
  logic select_91_s3_q;
  logic [16:0] sum_93_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      prime_s3_q <= prime_s2_q;
      load_s3_q <= load_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_live_s3_q <= marks_live_s2_q;
      and_38_s3_q <= and_38_s2_q;
      and_49_s3_q <= and_49_s2_q;
      from_s3_q <= from_s2_q;
      select_55_s3_q <= select_55[0];
      sum_57_s3_q <= sum_57;
      select_58_s3_q <= select_58_s2_q;
      sum_60_s3_q <= sum_60_s2_q[0];
      sum_64_s3_q <= sum_64;
      from_2_s3_q <= from_2_s2_q;
      select_85_s3_q <= select_85[0];
      sum_87_s3_q <= sum_87;
      select_88_s3_q <= select_88[0];
      sum_90_s3_q <= sum_90;
      select_91_s3_q <= select_91[0];
      sum_93_s3_q <= sum_93;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:162
  logic [19:0] sum_65;
  assign sum_65 = {{3{sum_57_s3_q[17]}}, sum_57_s3_q[17:1]} + {sum_64_s3_q, sum_60_s3_q, select_58_s3_q};
  logic [17:0] sum_94;
  assign sum_94 = {sum_90_s3_q[17], sum_90_s3_q[17:1]} + {sum_93_s3_q, select_91_s3_q};

  logic prime_s4_q;
  logic load_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_live_s4_q;
  logic and_38_s4_q;
  logic and_49_s4_q;
  logic [15:0] from_s4_q;
  logic select_55_s4_q;
  logic sum_57_s4_q;
  logic [19:0] sum_65_s4_q;
  logic [15:0] from_2_s4_q;
  logic select_85_s4_q;
  logic [17:0] sum_87_s4_q;
  logic select_88_s4_q;
  logic sum_90_s4_q;
  logic [17:0] sum_94_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      prime_s4_q <= prime_s3_q;
      load_s4_q <= load_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_live_s4_q <= marks_live_s3_q;
      and_38_s4_q <= and_38_s3_q;
      and_49_s4_q <= and_49_s3_q;
      from_s4_q <= from_s3_q;
      select_55_s4_q <= select_55_s3_q;
      sum_57_s4_q <= sum_57_s3_q[0];
      sum_65_s4_q <= sum_65;
      from_2_s4_q <= from_2_s3_q;
      select_85_s4_q <= select_85_s3_q;
      sum_87_s4_q <= sum_87_s3_q;
      select_88_s4_q <= select_88_s3_q;
      sum_90_s4_q <= sum_90_s3_q[0];
      sum_94_s4_q <= sum_94;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:162
  logic [19:0] sum_95;
  assign sum_95 = {{3{sum_87_s4_q[17]}}, sum_87_s4_q[17:1]} + {sum_94_s4_q, sum_90_s4_q, select_88_s4_q};

  logic prime_s5_q;
  logic load_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_live_s5_q;
  logic and_38_s5_q;
  logic and_49_s5_q;
  logic select_55_s5_q;
  logic sum_57_s5_q;
  logic [3:0] sum_65_s5_q;
  logic [15:0] sum_66_s5_q;
  logic [15:0] from_2_s5_q;
  logic select_85_s5_q;
  logic sum_87_s5_q;
  logic [19:0] sum_95_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      prime_s5_q <= prime_s4_q;
      load_s5_q <= load_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_live_s5_q <= marks_live_s4_q;
      and_38_s5_q <= and_38_s4_q;
      and_49_s5_q <= and_49_s4_q;
      select_55_s5_q <= select_55_s4_q;
      sum_57_s5_q <= sum_57_s4_q;
      sum_65_s5_q <= sum_65_s4_q[3:0];
      sum_66_s5_q <= from_s4_q + sum_65_s4_q[19:4];
      from_2_s5_q <= from_2_s4_q;
      select_85_s5_q <= select_85_s4_q;
      sum_87_s5_q <= sum_87_s4_q[0];
      sum_95_s5_q <= sum_95;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic right_valid_q;
  logic left_valid_q;
  logic right_of_skin_q;
  logic left_of_skin_q;
  logic [21:0] x_right_q;
  // hls/stages/map_expand.hpp:73
  logic not_23;
  assign not_23 = ~prime_s5_q;
  // hls/stages/map_expand.hpp:74
  logic and_24;
  assign and_24 = load_s5_q & not_23;
  // hls/stages/map_expand.hpp:128
  logic or_25;
  assign or_25 = prime_s5_q | and_24;
  // hls/stages/map_expand.hpp:85
  logic select_40;
  assign select_40 = and_24 ? right_valid_q : left_valid_q;
  logic select_51;
  assign select_51 = and_24 ? right_of_skin_q : left_of_skin_q;
  // hls/stages/map_expand.hpp:129
  logic [21:0] select_67;
  assign select_67 = or_25 ? {sum_66_s5_q, sum_65_s5_q, sum_57_s5_q, select_55_s5_q} : x_right_q;
  // hls/stages/map_expand.hpp:126
  logic [22:0] value_2;
  assign value_2 = {1'b0, sum_66_s5_q, sum_65_s5_q, sum_57_s5_q, select_55_s5_q} - {1'b0, x_right_q};
  // hls/stages/map_expand.hpp:113
  logic [22:0] select_73;
  assign select_73 = up[0] ? {value_2[21:0], 1'b0} : value_2;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      right_of_skin_q <= 1'b0;
      left_of_skin_q <= 1'b0;
      x_right_q <= 22'h0;
    end else if (s5_en) begin
      right_valid_q <= or_25 ? and_38_s5_q : right_valid_q;
      left_valid_q <= select_40;
      right_of_skin_q <= or_25 ? and_49_s5_q : right_of_skin_q;
      left_of_skin_q <= select_51;
      x_right_q <= select_67;
    end
  end

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_live_s6_q;
  logic [21:0] x_right_s6_q;
  logic not_23_s6_q;
  logic and_24_s6_q;
  logic or_25_s6_q;
  logic value_2_s6_q;
  logic [24:0] select_74_s6_q;
  logic select_85_s6_q;
  logic sum_87_s6_q;
  logic [3:0] sum_95_s6_q;
  logic [15:0] sum_96_s6_q;
  logic and_115_s6_q;
  logic and_118_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_live_s6_q <= marks_live_s5_q;
      x_right_s6_q <= x_right_q;
      not_23_s6_q <= not_23;
      and_24_s6_q <= and_24;
      or_25_s6_q <= or_25;
      value_2_s6_q <= value_2[22];
      select_74_s6_q <= up[1] ? {select_73, 2'h0} : {{2{value_2[22]}}, select_73};
      select_85_s6_q <= select_85_s5_q;
      sum_87_s6_q <= sum_87_s5_q;
      sum_95_s6_q <= sum_95_s5_q[3:0];
      sum_96_s6_q <= from_2_s5_q + sum_95_s5_q[19:4];
      and_115_s6_q <= (right_of_skin_q | and_24) & select_51;
      and_118_s6_q <= (right_valid_q | and_24) & select_40;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [27:0] x_place_q;
  logic [27:0] x_increment_q;
  logic [21:0] y_right_q;
  // hls/stages/map_expand.hpp:128
  logic [27:0] value;
  assign value = and_24_s6_q ? {x_right_s6_q, 6'h0} : x_place_q;
  // hls/stages/map_expand.hpp:115
  logic [27:0] value_3;
  assign value_3 = up[2] ? {select_74_s6_q[23:0], 4'h0} : {{3{value_2_s6_q}}, select_74_s6_q};
  // hls/stages/map_expand.hpp:128
  logic [27:0] select_76;
  assign select_76 = and_24_s6_q ? value_3 : x_increment_q;
  // hls/stages/map_expand.hpp:129
  logic [21:0] select_97;
  assign select_97 = or_25_s6_q ? {sum_96_s6_q, sum_95_s6_q, sum_87_s6_q, select_85_s6_q} : y_right_q;
  // hls/stages/map_expand.hpp:126
  logic [22:0] value_5;
  assign value_5 = {1'b0, sum_96_s6_q, sum_95_s6_q, sum_87_s6_q, select_85_s6_q} - {1'b0, y_right_q};
  // hls/stages/map_expand.hpp:113
  logic [22:0] select_100;
  assign select_100 = up[0] ? {value_5[21:0], 1'b0} : value_5;
  // hls/stages/map_expand.hpp:200
  logic [15:0] sum_105;
  assign sum_105 = {1'b0, value[27:13]} + 16'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_place_q <= 28'h0;
      x_increment_q <= 28'h0;
      y_right_q <= 22'h0;
    end else if (s6_en) begin
      x_place_q <= value + select_76;
      x_increment_q <= select_76;
      y_right_q <= select_97;
    end
  end

  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_live_s7_q;
  logic [21:0] y_right_s7_q;
  logic not_23_s7_q;
  logic and_24_s7_q;
  logic value_5_s7_q;
  logic [24:0] select_101_s7_q;
  logic [13:0] sum_105_s7_q;
  logic not_110_s7_q;
  logic and_115_s7_q;
  logic and_118_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_live_s7_q <= marks_live_s6_q;
      y_right_s7_q <= y_right_q;
      not_23_s7_q <= not_23_s6_q;
      and_24_s7_q <= and_24_s6_q;
      value_5_s7_q <= value_5[22];
      select_101_s7_q <= up[1] ? {select_100, 2'h0} : {{2{value_5[22]}}, select_100};
      sum_105_s7_q <= sum_105[14:1];
      not_110_s7_q <= ~(sum_105[15:10] == 6'h0);
      and_115_s7_q <= and_115_s6_q;
      and_118_s7_q <= and_118_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [27:0] y_place_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:128
  logic [27:0] value_4;
  assign value_4 = and_24_s7_q ? {y_right_s7_q, 6'h0} : y_place_q;
  // hls/stages/map_expand.hpp:115
  logic [27:0] value_6;
  assign value_6 = up[2] ? {select_101_s7_q[23:0], 4'h0} : {{3{value_5_s7_q}}, select_101_s7_q};
  // hls/stages/map_expand.hpp:128
  logic [27:0] select_103;
  assign select_103 = and_24_s7_q ? value_6 : y_increment_q;
  // hls/stages/map_expand.hpp:200
  logic [15:0] sum_107;
  assign sum_107 = {1'b0, value_4[27:13]} + 16'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      y_place_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s7_en) begin
      y_place_q <= value_4 + select_103;
      y_increment_q <= select_103;
    end
  end

  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic marks_live_s8_q;
  logic not_23_s8_q;
  logic [8:0] sum_105_s8_q;
  logic [4:0] sum_106_s8_q;
  logic [13:0] sum_107_s8_q;
  logic not_110_s8_q;
  logic not_112_s8_q;
  logic and_115_s8_q;
  logic and_118_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      marks_live_s8_q <= marks_live_s7_q;
      not_23_s8_q <= not_23_s7_q;
      sum_105_s8_q <= sum_105_s7_q[8:0];
      sum_106_s8_q <= sum_105_s7_q[13:9] + 5'h1f;
      sum_107_s8_q <= sum_107[14:1];
      not_110_s8_q <= not_110_s7_q;
      not_112_s8_q <= ~(sum_107[15:10] == 6'h0);
      and_115_s8_q <= and_115_s7_q;
      and_118_s8_q <= and_118_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:92
  logic and_113;
  assign and_113 = not_110_s8_q & not_112_s8_q;

  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic marks_live_s9_q;
  logic [8:0] sum_105_s9_q;
  logic [4:0] sum_106_s9_q;
  logic [8:0] sum_107_s9_q;
  logic [4:0] sum_108_s9_q;
  logic and_116_s9_q;
  logic and_119_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      marks_live_s9_q <= marks_live_s8_q;
      sum_105_s9_q <= sum_105_s8_q;
      sum_106_s9_q <= sum_106_s8_q;
      sum_107_s9_q <= sum_107_s8_q[8:0];
      sum_108_s9_q <= sum_107_s8_q[13:9] + 5'h1f;
      and_116_s9_q <= and_113 & and_115_s8_q;
      and_119_s9_q <= and_113 & and_118_s8_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_106_s9_q, sum_105_s9_q[8:3]};
  assign y_o = {sum_108_s9_q, sum_107_s9_q[8:3]};
  assign wx_o = sum_105_s9_q[2:0];
  assign wy_o = sum_107_s9_q[2:0];
  assign mapped_o = and_116_s9_q;
  assign present_o = and_119_s9_q;
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
      valid_s9_q <= valid_s8_q & not_23_s8_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_107[0], sum_105[0]};

endmodule
