// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::vga>, hls/stages/map_expand.hpp. Do not edit.
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
  // hls/stages/map_expand.hpp:30
  logic or_25;
  assign or_25 = (~(column_top_x_i == 16'hffff)) | (~(column_top_y_i == 16'hffff));
  // hls/stages/map_expand.hpp:170
  logic or_32;
  assign or_32 = (~(column_bottom_y_i == 16'hffff)) | ((row_fraction_i == 6'h0) | (~(column_bottom_x_i == 16'hffff)));
  // hls/stages/map_expand.hpp:73
  logic select_35;
  assign select_35 = and_19 ? right_valid_q : left_valid_q;
  // hls/stages/map_expand.hpp:148
  logic [15:0] sum;
  assign sum = row_fraction_i[5] ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:152
  logic xor_37;
  assign xor_37 = row_fraction_i[3] ^ row_fraction_i[4];
  // hls/stages/map_expand.hpp:147
  logic [16:0] difference;
  assign difference = {1'b0, column_bottom_x_i} - {1'b0, column_top_x_i};
  // hls/stages/map_expand.hpp:153
  logic and_41;
  assign and_41 = (~xor_37) & (row_fraction_i[3] ^ row_fraction_i[5]);
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_42;
  assign select_42 = and_41 ? difference : 17'h0;
  logic [17:0] size;
  assign size = xor_37 ? {difference[16], difference} : {select_42, 1'b0};
  // hls/stages/map_expand.hpp:159
  logic [17:0] select_45;
  assign select_45 = row_fraction_i[5] ? (~size) : size;
  logic [18:0] sum_46;
  assign sum_46 = {sum, 3'h1} + {select_45, row_fraction_i[5]};
  // hls/stages/map_expand.hpp:152
  logic xor_47;
  assign xor_47 = row_fraction_i[1] ^ row_fraction_i[2];
  // hls/stages/map_expand.hpp:153
  logic and_50;
  assign and_50 = (~xor_47) & (row_fraction_i[1] ^ row_fraction_i[3]);
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_51;
  assign select_51 = and_50 ? difference : 17'h0;
  logic [17:0] size_2;
  assign size_2 = xor_47 ? {difference[16], difference} : {select_51, 1'b0};
  // hls/stages/map_expand.hpp:159
  logic [17:0] select_54;
  assign select_54 = row_fraction_i[3] ? (~size_2) : size_2;
  logic [20:0] sum_55;
  assign sum_55 = {sum_46[18:1], 3'h1} + {{2{select_54[17]}}, select_54, row_fraction_i[3]};
  // hls/stages/map_expand.hpp:153
  logic and_57;
  assign and_57 = row_fraction_i[1] & (~row_fraction_i[0]);
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_58;
  assign select_58 = and_57 ? difference : 17'h0;
  logic [17:0] size_3;
  assign size_3 = row_fraction_i[0] ? {difference[16], difference} : {select_58, 1'b0};
  // hls/stages/map_expand.hpp:159
  logic [17:0] select_61;
  assign select_61 = row_fraction_i[1] ? (~size_3) : size_3;
  logic [22:0] arriving;
  assign arriving = {sum_55[20:1], 3'h1} + {{4{select_61[17]}}, select_61, row_fraction_i[1]};
  // hls/stages/map_expand.hpp:126
  logic [22:0] value;
  assign value = {1'b0, arriving[22:1]} - {1'b0, x_place_q[27:6]};
  // hls/stages/map_expand.hpp:95
  logic [22:0] select_67;
  assign select_67 = up[0] ? {value[21:0], 1'b0} : value;
  // hls/stages/map_expand.hpp:96
  logic [24:0] select_68;
  assign select_68 = up[1] ? {select_67, 2'h0} : {{2{value[22]}}, select_67};
  // hls/stages/map_expand.hpp:97
  logic [27:0] value_2;
  assign value_2 = up[2] ? {select_68[23:0], 4'h0} : {{3{value[22]}}, select_68};
  // hls/stages/map_expand.hpp:127
  logic [27:0] select_70;
  assign select_70 = and_19 ? value_2 : x_increment_q;
  // hls/stages/map_expand.hpp:148
  logic [15:0] sum_2;
  assign sum_2 = row_fraction_i[5] ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:147
  logic [16:0] difference_2;
  assign difference_2 = {1'b0, column_bottom_y_i} - {1'b0, column_top_y_i};
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_75;
  assign select_75 = and_41 ? difference_2 : 17'h0;
  logic [17:0] size_4;
  assign size_4 = xor_37 ? {difference_2[16], difference_2} : {select_75, 1'b0};
  // hls/stages/map_expand.hpp:159
  logic [17:0] select_78;
  assign select_78 = row_fraction_i[5] ? (~size_4) : size_4;
  logic [18:0] sum_79;
  assign sum_79 = {sum_2, 3'h1} + {select_78, row_fraction_i[5]};
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_80;
  assign select_80 = and_50 ? difference_2 : 17'h0;
  logic [17:0] size_5;
  assign size_5 = xor_47 ? {difference_2[16], difference_2} : {select_80, 1'b0};
  // hls/stages/map_expand.hpp:159
  logic [17:0] select_83;
  assign select_83 = row_fraction_i[3] ? (~size_5) : size_5;
  logic [20:0] sum_84;
  assign sum_84 = {sum_79[18:1], 3'h1} + {{2{select_83[17]}}, select_83, row_fraction_i[3]};
  // hls/stages/map_expand.hpp:156
  logic [16:0] select_85;
  assign select_85 = and_57 ? difference_2 : 17'h0;
  logic [17:0] size_6;
  assign size_6 = row_fraction_i[0] ? {difference_2[16], difference_2} : {select_85, 1'b0};
  // hls/stages/map_expand.hpp:159
  logic [17:0] select_88;
  assign select_88 = row_fraction_i[1] ? (~size_6) : size_6;
  logic [22:0] arriving_2;
  assign arriving_2 = {sum_84[20:1], 3'h1} + {{4{select_88[17]}}, select_88, row_fraction_i[1]};
  // hls/stages/map_expand.hpp:126
  logic [22:0] value_3;
  assign value_3 = {1'b0, arriving_2[22:1]} - {1'b0, y_place_q[27:6]};
  // hls/stages/map_expand.hpp:95
  logic [22:0] select_91;
  assign select_91 = up[0] ? {value_3[21:0], 1'b0} : value_3;
  // hls/stages/map_expand.hpp:96
  logic [24:0] select_92;
  assign select_92 = up[1] ? {select_91, 2'h0} : {{2{value_3[22]}}, select_91};
  // hls/stages/map_expand.hpp:97
  logic [27:0] value_4;
  assign value_4 = up[2] ? {select_92[23:0], 4'h0} : {{3{value_3[22]}}, select_92};
  // hls/stages/map_expand.hpp:127
  logic [27:0] select_94;
  assign select_94 = and_19 ? value_4 : y_increment_q;
  // hls/stages/map_expand.hpp:176
  logic [15:0] sum_97;
  assign sum_97 = {1'b0, x_place_q[27:13]} + 16'h1;
  logic [15:0] sum_99;
  assign sum_99 = {1'b0, y_place_q[27:13]} + 16'h1;
  // hls/stages/map_expand.hpp:77
  logic and_107;
  assign and_107 = (~(sum_97[15:10] == 6'h0)) & ((right_valid_q | and_19) & select_35);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      x_place_q <= 28'h0;
      x_increment_q <= 28'h0;
      y_place_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s0_en) begin
      right_valid_q <= (prime_i | and_19) ? (or_25 & or_32) : right_valid_q;
      left_valid_q <= select_35;
      x_place_q <= prime_i ? {arriving[22:1], 6'h0} : (x_place_q + select_70);
      x_increment_q <= select_70;
      y_place_q <= prime_i ? {arriving_2[22:1], 6'h0} : (y_place_q + select_94);
      y_increment_q <= select_94;
    end
  end

  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic [8:0] sum_97_s1_q;
  logic [4:0] sum_98_s1_q;
  logic [8:0] sum_99_s1_q;
  logic [4:0] sum_100_s1_q;
  logic and_108_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      sum_97_s1_q <= sum_97[9:1];
      sum_98_s1_q <= sum_97[14:10] + 5'h1f;
      sum_99_s1_q <= sum_99[9:1];
      sum_100_s1_q <= sum_99[14:10] + 5'h1f;
      and_108_s1_q <= (~(sum_99[15:10] == 6'h0)) & and_107;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_98_s1_q, sum_97_s1_q[8:3]};
  assign y_o = {sum_100_s1_q, sum_99_s1_q[8:3]};
  assign wx_o = sum_97_s1_q[2:0];
  assign wy_o = sum_99_s1_q[2:0];
  assign mapped_o = and_108_s1_q;
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
  assign unused_bits = ^{sum_99[0], sum_97[0], arriving_2[0], sum_84[0], sum_79[0], arriving[0], sum_55[0], sum_46[0]};

endmodule
