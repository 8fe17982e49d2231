// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::vga>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 116 bits, pipeline 83 bits, memories 0 bits.
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
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Of the configuration alone: not pipelined.
  logic [2:0] up;
  assign up = (2'h2 < cfg_spacing_x_log2_i[2:1]) ? 3'h0 : (3'h6 - cfg_spacing_x_log2_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic right_valid_q;
  logic left_valid_q;
  logic right_of_skin_q;
  logic left_of_skin_q;
  logic [27:0] x_place_q;
  logic [27:0] x_increment_q;
  // hls/stages/map_expand.hpp:73
  logic not_21;
  assign not_21 = ~prime_i;
  // hls/stages/map_expand.hpp:74
  logic and_22;
  assign and_22 = load_i & not_21;
  // hls/stages/map_expand.hpp:145
  logic or_23;
  assign or_23 = prime_i | and_22;
  // hls/stages/map_expand.hpp:191
  logic equal_24;
  assign equal_24 = row_fraction_i == 6'h0;
  logic and_25;
  assign and_25 = column_swapped_i & equal_24;
  // hls/stages/map_expand.hpp:192
  logic and_31;
  assign and_31 = equal_24 & (~column_swapped_i);
  // hls/stages/map_expand.hpp:193
  logic or_35;
  assign or_35 = and_31 | (~((column_bottom_x_i & column_bottom_y_i) == 16'hffff));
  logic and_36;
  assign and_36 = (and_25 | (~((column_top_x_i & column_top_y_i) == 16'hffff))) & or_35;
  // hls/stages/map_expand.hpp:85
  logic select_38;
  assign select_38 = and_22 ? right_valid_q : left_valid_q;
  // hls/stages/map_expand.hpp:35
  logic or_41;
  assign or_41 = (~column_top_y_i[15]) | (column_top_y_i[14:13] == 2'h0);
  // hls/stages/map_expand.hpp:32
  logic equal_43;
  assign equal_43 = column_bottom_y_i[14:13] == 2'h0;
  logic and_47;
  assign and_47 = (or_41 | and_25) & (and_31 | (equal_43 | (~column_bottom_y_i[15])));
  // hls/stages/map_expand.hpp:85
  logic select_49;
  assign select_49 = and_22 ? right_of_skin_q : left_of_skin_q;
  // hls/stages/map_expand.hpp:113
  logic [2:0] up_2;
  assign up_2 = prime_i ? 3'h6 : up;
  // hls/stages/map_expand.hpp:168
  logic xor_54;
  assign xor_54 = column_swapped_i ^ row_fraction_i[5];
  logic [15:0] sum;
  assign sum = xor_54 ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:172
  logic xor_56;
  assign xor_56 = row_fraction_i[3] ^ row_fraction_i[4];
  // hls/stages/map_expand.hpp:167
  logic [16:0] difference;
  assign difference = {1'b0, column_bottom_x_i} - {1'b0, column_top_x_i};
  // hls/stages/map_expand.hpp:174
  logic or_60;
  assign or_60 = xor_56 | (row_fraction_i[3] ^ (~row_fraction_i[5]));
  // hls/stages/map_expand.hpp:176
  logic [16:0] select_61;
  assign select_61 = or_60 ? 17'h0 : difference;
  logic [17:0] size;
  assign size = xor_56 ? {difference[16], difference} : {select_61, 1'b0};
  // hls/stages/map_expand.hpp:180
  logic [17:0] select_64;
  assign select_64 = xor_54 ? (~size) : size;
  logic [18:0] sum_65;
  assign sum_65 = {sum, 3'h1} + {select_64, xor_54};
  // hls/stages/map_expand.hpp:177
  logic xor_66;
  assign xor_66 = column_swapped_i ^ row_fraction_i[3];
  // hls/stages/map_expand.hpp:172
  logic xor_67;
  assign xor_67 = row_fraction_i[1] ^ row_fraction_i[2];
  // hls/stages/map_expand.hpp:173
  logic and_70;
  assign and_70 = (~xor_67) & (row_fraction_i[1] ^ row_fraction_i[3]);
  // hls/stages/map_expand.hpp:176
  logic [16:0] select_71;
  assign select_71 = and_70 ? difference : 17'h0;
  logic [17:0] size_2;
  assign size_2 = xor_67 ? {difference[16], difference} : {select_71, 1'b0};
  // hls/stages/map_expand.hpp:180
  logic [17:0] select_74;
  assign select_74 = xor_66 ? (~size_2) : size_2;
  logic [20:0] sum_75;
  assign sum_75 = {sum_65[18:1], 3'h1} + {{2{select_74[17]}}, select_74, xor_66};
  // hls/stages/map_expand.hpp:177
  logic xor_76;
  assign xor_76 = column_swapped_i ^ row_fraction_i[1];
  // hls/stages/map_expand.hpp:173
  logic and_78;
  assign and_78 = row_fraction_i[1] & (~row_fraction_i[0]);
  // hls/stages/map_expand.hpp:176
  logic [16:0] select_79;
  assign select_79 = and_78 ? difference : 17'h0;
  logic [17:0] size_3;
  assign size_3 = row_fraction_i[0] ? {difference[16], difference} : {select_79, 1'b0};
  // hls/stages/map_expand.hpp:180
  logic [17:0] select_82;
  assign select_82 = xor_76 ? (~size_3) : size_3;
  logic [22:0] arriving;
  assign arriving = {sum_75[20:1], 3'h1} + {{4{select_82[17]}}, select_82, xor_76};
  // hls/stages/map_expand.hpp:145
  logic [22:0] value;
  assign value = {1'b0, arriving[22:1]} - {1'b0, x_place_q[27:6]};
  // hls/stages/map_expand.hpp:113
  logic [22:0] select_85;
  assign select_85 = up_2[0] ? {value[21:0], 1'b0} : value;
  // hls/stages/map_expand.hpp:114
  logic [24:0] select_86;
  assign select_86 = up_2[1] ? {select_85, 2'h0} : {{2{value[22]}}, select_85};
  // hls/stages/map_expand.hpp:115
  logic [27:0] value_2;
  assign value_2 = up_2[2] ? {select_86[23:0], 4'h0} : {{3{value[22]}}, select_86};
  // hls/stages/map_expand.hpp:146
  logic [27:0] select_88;
  assign select_88 = or_23 ? value_2 : x_increment_q;
  logic [27:0] sum_89;
  assign sum_89 = x_place_q + select_88;
  // hls/stages/map_expand.hpp:147
  logic [5:0] select_90;
  assign select_90 = prime_i ? 6'h0 : sum_89[5:0];
  // hls/stages/map_expand.hpp:35
  logic [1:0] sum_93;
  assign sum_93 = column_bottom_y_i[14:13] + 2'h3;
  logic [15:0] b;
  assign b = (column_bottom_y_i[15] & (~equal_43)) ? {sum_93, column_bottom_y_i[12:0], 1'b0} : column_bottom_y_i;
  logic [1:0] sum_95;
  assign sum_95 = column_top_y_i[14:13] + 2'h3;
  logic [15:0] a;
  assign a = or_41 ? column_top_y_i : {sum_95, column_top_y_i[12:0], 1'b0};
  // hls/stages/map_expand.hpp:168
  logic [15:0] sum_2;
  assign sum_2 = xor_54 ? b : a;
  // hls/stages/map_expand.hpp:167
  logic [16:0] once;
  assign once = {1'b0, b} - {1'b0, a};
  // hls/stages/map_expand.hpp:176
  logic [16:0] select_99;
  assign select_99 = or_60 ? 17'h0 : once;
  logic [17:0] size_4;
  assign size_4 = xor_56 ? {once[16], once} : {select_99, 1'b0};
  // hls/stages/map_expand.hpp:180
  logic [17:0] select_102;
  assign select_102 = xor_54 ? (~size_4) : size_4;
  logic [18:0] sum_103;
  assign sum_103 = {sum_2, 3'h1} + {select_102, xor_54};
  // hls/stages/map_expand.hpp:176
  logic [16:0] select_104;
  assign select_104 = and_70 ? once : 17'h0;
  logic [17:0] size_5;
  assign size_5 = xor_67 ? {once[16], once} : {select_104, 1'b0};
  // hls/stages/map_expand.hpp:180
  logic [17:0] select_107;
  assign select_107 = xor_66 ? (~size_5) : size_5;
  logic [20:0] sum_108;
  assign sum_108 = {sum_103[18:1], 3'h1} + {{2{select_107[17]}}, select_107, xor_66};
  // hls/stages/map_expand.hpp:176
  logic [16:0] select_109;
  assign select_109 = and_78 ? once : 17'h0;
  logic [17:0] size_6;
  assign size_6 = row_fraction_i[0] ? {once[16], once} : {select_109, 1'b0};
  // hls/stages/map_expand.hpp:180
  logic [17:0] select_112;
  assign select_112 = xor_76 ? (~size_6) : size_6;
  logic [22:0] arriving_2;
  assign arriving_2 = {sum_108[20:1], 3'h1} + {{4{select_112[17]}}, select_112, xor_76};
  // hls/stages/map_expand.hpp:200
  logic [15:0] sum_121;
  assign sum_121 = {1'b0, x_place_q[27:13]} + 16'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      right_of_skin_q <= 1'b0;
      left_of_skin_q <= 1'b0;
    end else if (s0_en) begin
      right_valid_q <= or_23 ? and_36 : right_valid_q;
      left_valid_q <= select_38;
      right_of_skin_q <= or_23 ? and_47 : right_of_skin_q;
      left_of_skin_q <= select_49;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    x_place_q = 28'h0;
    x_increment_q = 28'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (rst_ni & s0_en) begin
      x_place_q <= {sum_89[27:6], select_90};
      x_increment_q <= select_88;
    end
  end

  logic prime_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic not_21_s1_q;
  logic or_23_s1_q;
  logic [2:0] up_2_s1_q;
  logic [21:0] arriving_2_s1_q;
  logic [8:0] sum_121_s1_q;
  logic [4:0] sum_122_s1_q;
  logic not_126_s1_q;
  logic and_131_s1_q;
  logic and_134_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      prime_s1_q <= prime_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      not_21_s1_q <= not_21;
      or_23_s1_q <= or_23;
      up_2_s1_q <= up_2;
      arriving_2_s1_q <= arriving_2[22:1];
      sum_121_s1_q <= sum_121[9:1];
      sum_122_s1_q <= sum_121[14:10] + 5'h1f;
      not_126_s1_q <= ~(sum_121[15:10] == 6'h0);
      and_131_s1_q <= (right_of_skin_q | and_22) & select_49;
      and_134_s1_q <= (right_valid_q | and_22) & select_38;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [27:0] y_place_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:145
  logic [22:0] value_3;
  assign value_3 = {1'b0, arriving_2_s1_q} - {1'b0, y_place_q[27:6]};
  // hls/stages/map_expand.hpp:113
  logic [22:0] select_115;
  assign select_115 = up_2_s1_q[0] ? {value_3[21:0], 1'b0} : value_3;
  // hls/stages/map_expand.hpp:114
  logic [24:0] select_116;
  assign select_116 = up_2_s1_q[1] ? {select_115, 2'h0} : {{2{value_3[22]}}, select_115};
  // hls/stages/map_expand.hpp:115
  logic [27:0] value_4;
  assign value_4 = up_2_s1_q[2] ? {select_116[23:0], 4'h0} : {{3{value_3[22]}}, select_116};
  // hls/stages/map_expand.hpp:146
  logic [27:0] select_118;
  assign select_118 = or_23_s1_q ? value_4 : y_increment_q;
  logic [27:0] sum_119;
  assign sum_119 = y_place_q + select_118;
  // hls/stages/map_expand.hpp:147
  logic [5:0] select_120;
  assign select_120 = prime_s1_q ? 6'h0 : sum_119[5:0];
  // hls/stages/map_expand.hpp:200
  logic [15:0] sum_123;
  assign sum_123 = {1'b0, y_place_q[27:13]} + 16'h1;
  // hls/stages/map_expand.hpp:92
  logic and_129;
  assign and_129 = not_126_s1_q & (~(sum_123[15:10] == 6'h0));

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    y_place_q = 28'h0;
    y_increment_q = 28'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      y_place_q <= {sum_119[27:6], select_120};
      y_increment_q <= select_118;
    end
  end

  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_live_s2_q;
  logic [8:0] sum_121_s2_q;
  logic [4:0] sum_122_s2_q;
  logic [8:0] sum_123_s2_q;
  logic [4:0] sum_124_s2_q;
  logic and_132_s2_q;
  logic and_135_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_live_s2_q <= marks_live_s1_q;
      sum_121_s2_q <= sum_121_s1_q;
      sum_122_s2_q <= sum_122_s1_q;
      sum_123_s2_q <= sum_123[9:1];
      sum_124_s2_q <= sum_123[14:10] + 5'h1f;
      and_132_s2_q <= and_129 & and_131_s1_q;
      and_135_s2_q <= and_129 & and_134_s1_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_122_s2_q, sum_121_s2_q[8:3]};
  assign y_o = {sum_124_s2_q, sum_123_s2_q[8:3]};
  assign wx_o = sum_121_s2_q[2:0];
  assign wy_o = sum_123_s2_q[2:0];
  assign mapped_o = and_132_s2_q;
  assign present_o = and_135_s2_q;
  assign marks_first_o = marks_first_s2_q;
  assign marks_last_o = marks_last_s2_q;
  assign marks_live_o = marks_live_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q & not_21_s1_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_123[0], sum_121[0], arriving_2[0], sum_108[0], sum_103[0], arriving[0], sum_75[0], sum_65[0]};

endmodule
