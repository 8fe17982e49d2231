// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::field>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 114 bits, pipeline 33 bits, memories 0 bits.
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
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Of the configuration alone: not pipelined.
  logic [2:0] up;
  assign up = (2'h2 < cfg_spacing_x_log2_i[2:1]) ? 3'h0 : (3'h6 - cfg_spacing_x_log2_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic right_valid_q;
  logic left_valid_q;
  logic [27:0] x_place_q;
  logic [27:0] x_increment_q;
  logic [27:0] y_place_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:65
  logic not_18;
  assign not_18 = ~prime_i;
  // hls/stages/map_expand.hpp:66
  logic and_19;
  assign and_19 = load_i & not_18;
  // hls/stages/map_expand.hpp:127
  logic or_20;
  assign or_20 = prime_i | and_19;
  // hls/stages/map_expand.hpp:30
  logic or_25;
  assign or_25 = (~(column_top_x_i == 16'hffff)) | (~(column_top_y_i == 16'hffff));
  // hls/stages/map_expand.hpp:172
  logic or_32;
  assign or_32 = (~(column_bottom_y_i == 16'hffff)) | ((row_fraction_i == 6'h0) | (~(column_bottom_x_i == 16'hffff)));
  // hls/stages/map_expand.hpp:73
  logic select_35;
  assign select_35 = and_19 ? right_valid_q : left_valid_q;
  // hls/stages/map_expand.hpp:95
  logic [2:0] up_2;
  assign up_2 = prime_i ? 3'h6 : up;
  // hls/stages/map_expand.hpp:150
  logic [15:0] sum;
  assign sum = row_fraction_i[5] ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:154
  logic xor_41;
  assign xor_41 = row_fraction_i[3] ^ row_fraction_i[4];
  // hls/stages/map_expand.hpp:149
  logic [16:0] difference;
  assign difference = {1'b0, column_bottom_x_i} - {1'b0, column_top_x_i};
  // hls/stages/map_expand.hpp:155
  logic and_45;
  assign and_45 = (~xor_41) & (row_fraction_i[3] ^ row_fraction_i[5]);
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_46;
  assign select_46 = and_45 ? difference : 17'h0;
  logic [17:0] size;
  assign size = xor_41 ? {difference[16], difference} : {select_46, 1'b0};
  // hls/stages/map_expand.hpp:161
  logic [17:0] select_49;
  assign select_49 = row_fraction_i[5] ? (~size) : size;
  logic [18:0] sum_50;
  assign sum_50 = {sum, 3'h1} + {select_49, row_fraction_i[5]};
  // hls/stages/map_expand.hpp:154
  logic xor_51;
  assign xor_51 = row_fraction_i[1] ^ row_fraction_i[2];
  // hls/stages/map_expand.hpp:155
  logic and_54;
  assign and_54 = (~xor_51) & (row_fraction_i[1] ^ row_fraction_i[3]);
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_55;
  assign select_55 = and_54 ? difference : 17'h0;
  logic [17:0] size_2;
  assign size_2 = xor_51 ? {difference[16], difference} : {select_55, 1'b0};
  // hls/stages/map_expand.hpp:161
  logic [17:0] select_58;
  assign select_58 = row_fraction_i[3] ? (~size_2) : size_2;
  logic [20:0] sum_59;
  assign sum_59 = {sum_50[18:1], 3'h1} + {{2{select_58[17]}}, select_58, row_fraction_i[3]};
  // hls/stages/map_expand.hpp:155
  logic and_61;
  assign and_61 = row_fraction_i[1] & (~row_fraction_i[0]);
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_62;
  assign select_62 = and_61 ? difference : 17'h0;
  logic [17:0] size_3;
  assign size_3 = row_fraction_i[0] ? {difference[16], difference} : {select_62, 1'b0};
  // hls/stages/map_expand.hpp:161
  logic [17:0] select_65;
  assign select_65 = row_fraction_i[1] ? (~size_3) : size_3;
  logic [22:0] arriving;
  assign arriving = {sum_59[20:1], 3'h1} + {{4{select_65[17]}}, select_65, row_fraction_i[1]};
  // hls/stages/map_expand.hpp:127
  logic [22:0] value;
  assign value = {1'b0, arriving[22:1]} - {1'b0, x_place_q[27:6]};
  // hls/stages/map_expand.hpp:95
  logic [22:0] select_68;
  assign select_68 = up_2[0] ? {value[21:0], 1'b0} : value;
  // hls/stages/map_expand.hpp:96
  logic [24:0] select_69;
  assign select_69 = up_2[1] ? {select_68, 2'h0} : {{2{value[22]}}, select_68};
  // hls/stages/map_expand.hpp:97
  logic [27:0] value_2;
  assign value_2 = up_2[2] ? {select_69[23:0], 4'h0} : {{3{value[22]}}, select_69};
  // hls/stages/map_expand.hpp:128
  logic [27:0] select_71;
  assign select_71 = or_20 ? value_2 : x_increment_q;
  logic [27:0] sum_72;
  assign sum_72 = x_place_q + select_71;
  // hls/stages/map_expand.hpp:129
  logic [5:0] select_73;
  assign select_73 = prime_i ? 6'h0 : sum_72[5:0];
  // hls/stages/map_expand.hpp:150
  logic [15:0] sum_2;
  assign sum_2 = row_fraction_i[5] ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:149
  logic [16:0] difference_2;
  assign difference_2 = {1'b0, column_bottom_y_i} - {1'b0, column_top_y_i};
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_76;
  assign select_76 = and_45 ? difference_2 : 17'h0;
  logic [17:0] size_4;
  assign size_4 = xor_41 ? {difference_2[16], difference_2} : {select_76, 1'b0};
  // hls/stages/map_expand.hpp:161
  logic [17:0] select_79;
  assign select_79 = row_fraction_i[5] ? (~size_4) : size_4;
  logic [18:0] sum_80;
  assign sum_80 = {sum_2, 3'h1} + {select_79, row_fraction_i[5]};
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_81;
  assign select_81 = and_54 ? difference_2 : 17'h0;
  logic [17:0] size_5;
  assign size_5 = xor_51 ? {difference_2[16], difference_2} : {select_81, 1'b0};
  // hls/stages/map_expand.hpp:161
  logic [17:0] select_84;
  assign select_84 = row_fraction_i[3] ? (~size_5) : size_5;
  logic [20:0] sum_85;
  assign sum_85 = {sum_80[18:1], 3'h1} + {{2{select_84[17]}}, select_84, row_fraction_i[3]};
  // hls/stages/map_expand.hpp:158
  logic [16:0] select_86;
  assign select_86 = and_61 ? difference_2 : 17'h0;
  logic [17:0] size_6;
  assign size_6 = row_fraction_i[0] ? {difference_2[16], difference_2} : {select_86, 1'b0};
  // hls/stages/map_expand.hpp:161
  logic [17:0] select_89;
  assign select_89 = row_fraction_i[1] ? (~size_6) : size_6;
  logic [22:0] arriving_2;
  assign arriving_2 = {sum_85[20:1], 3'h1} + {{4{select_89[17]}}, select_89, row_fraction_i[1]};
  // hls/stages/map_expand.hpp:127
  logic [22:0] value_3;
  assign value_3 = {1'b0, arriving_2[22:1]} - {1'b0, y_place_q[27:6]};
  // hls/stages/map_expand.hpp:95
  logic [22:0] select_92;
  assign select_92 = up_2[0] ? {value_3[21:0], 1'b0} : value_3;
  // hls/stages/map_expand.hpp:96
  logic [24:0] select_93;
  assign select_93 = up_2[1] ? {select_92, 2'h0} : {{2{value_3[22]}}, select_92};
  // hls/stages/map_expand.hpp:97
  logic [27:0] value_4;
  assign value_4 = up_2[2] ? {select_93[23:0], 4'h0} : {{3{value_3[22]}}, select_93};
  // hls/stages/map_expand.hpp:128
  logic [27:0] select_95;
  assign select_95 = or_20 ? value_4 : y_increment_q;
  logic [27:0] sum_96;
  assign sum_96 = y_place_q + select_95;
  // hls/stages/map_expand.hpp:129
  logic [5:0] select_97;
  assign select_97 = prime_i ? 6'h0 : sum_96[5:0];
  // hls/stages/map_expand.hpp:178
  logic [15:0] sum_98;
  assign sum_98 = {1'b0, x_place_q[27:13]} + 16'h1;
  logic [15:0] sum_100;
  assign sum_100 = {1'b0, y_place_q[27:13]} + 16'h1;
  // hls/stages/map_expand.hpp:77
  logic and_108;
  assign and_108 = (~(sum_98[15:10] == 6'h0)) & ((right_valid_q | and_19) & select_35);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      x_place_q <= 28'h0;
      x_increment_q <= 28'h0;
      y_place_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s0_en) begin
      right_valid_q <= or_20 ? (or_25 & or_32) : right_valid_q;
      left_valid_q <= select_35;
      x_place_q <= {sum_72[27:6], select_73};
      x_increment_q <= select_71;
      y_place_q <= {sum_96[27:6], select_97};
      y_increment_q <= select_95;
    end
  end

  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic [8:0] sum_98_s1_q;
  logic [4:0] sum_99_s1_q;
  logic [8:0] sum_100_s1_q;
  logic [4:0] sum_101_s1_q;
  logic and_109_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      sum_98_s1_q <= sum_98[9:1];
      sum_99_s1_q <= sum_98[14:10] + 5'h1f;
      sum_100_s1_q <= sum_100[9:1];
      sum_101_s1_q <= sum_100[14:10] + 5'h1f;
      and_109_s1_q <= (~(sum_100[15:10] == 6'h0)) & and_108;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_99_s1_q, sum_98_s1_q[8:3]};
  assign y_o = {sum_101_s1_q, sum_100_s1_q[8:3]};
  assign wx_o = sum_98_s1_q[2:0];
  assign wy_o = sum_100_s1_q[2:0];
  assign mapped_o = and_109_s1_q;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = marks_last_s1_q;
  assign marks_live_o = marks_live_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & not_18;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_100[0], sum_98[0], arriving_2[0], sum_85[0], sum_80[0], arriving[0], sum_59[0], sum_50[0]};

endmodule
