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
  // hls/stages/map_expand.hpp:66
  logic not_19;
  assign not_19 = ~prime_i;
  // hls/stages/map_expand.hpp:67
  logic and_20;
  assign and_20 = load_i & not_19;
  // hls/stages/map_expand.hpp:128
  logic or_21;
  assign or_21 = prime_i | and_20;
  // hls/stages/map_expand.hpp:30
  logic or_26;
  assign or_26 = (~(column_top_x_i == 16'hffff)) | (~(column_top_y_i == 16'hffff));
  logic equal_27;
  assign equal_27 = row_fraction_i == 6'h0;
  logic or_34;
  assign or_34 = (~(column_bottom_x_i == 16'hffff)) | (~(column_bottom_y_i == 16'hffff));
  // hls/stages/map_expand.hpp:70
  logic and_38;
  assign and_38 = (or_26 | (column_swapped_i & equal_27)) & (or_34 | (equal_27 & (~column_swapped_i)));
  // hls/stages/map_expand.hpp:74
  logic select_40;
  assign select_40 = and_20 ? right_valid_q : left_valid_q;
  // hls/stages/map_expand.hpp:96
  logic [2:0] up_2;
  assign up_2 = prime_i ? 3'h6 : up;
  // hls/stages/map_expand.hpp:151
  logic xor_45;
  assign xor_45 = column_swapped_i ^ row_fraction_i[5];
  logic [15:0] sum;
  assign sum = xor_45 ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:155
  logic xor_47;
  assign xor_47 = row_fraction_i[3] ^ row_fraction_i[4];
  // hls/stages/map_expand.hpp:150
  logic [16:0] difference;
  assign difference = {1'b0, column_bottom_x_i} - {1'b0, column_top_x_i};
  // hls/stages/map_expand.hpp:157
  logic or_51;
  assign or_51 = xor_47 | (row_fraction_i[3] ^ (~row_fraction_i[5]));
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_52;
  assign select_52 = or_51 ? 17'h0 : difference;
  logic [17:0] size;
  assign size = xor_47 ? {difference[16], difference} : {select_52, 1'b0};
  // hls/stages/map_expand.hpp:163
  logic [17:0] select_55;
  assign select_55 = xor_45 ? (~size) : size;
  logic [18:0] sum_56;
  assign sum_56 = {sum, 3'h1} + {select_55, xor_45};
  // hls/stages/map_expand.hpp:160
  logic xor_57;
  assign xor_57 = column_swapped_i ^ row_fraction_i[3];
  // hls/stages/map_expand.hpp:155
  logic xor_58;
  assign xor_58 = row_fraction_i[1] ^ row_fraction_i[2];
  // hls/stages/map_expand.hpp:156
  logic and_61;
  assign and_61 = (~xor_58) & (row_fraction_i[1] ^ row_fraction_i[3]);
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_62;
  assign select_62 = and_61 ? difference : 17'h0;
  logic [17:0] size_2;
  assign size_2 = xor_58 ? {difference[16], difference} : {select_62, 1'b0};
  // hls/stages/map_expand.hpp:163
  logic [17:0] select_65;
  assign select_65 = xor_57 ? (~size_2) : size_2;
  logic [20:0] sum_66;
  assign sum_66 = {sum_56[18:1], 3'h1} + {{2{select_65[17]}}, select_65, xor_57};
  // hls/stages/map_expand.hpp:160
  logic xor_67;
  assign xor_67 = column_swapped_i ^ row_fraction_i[1];
  // hls/stages/map_expand.hpp:156
  logic and_69;
  assign and_69 = row_fraction_i[1] & (~row_fraction_i[0]);
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_70;
  assign select_70 = and_69 ? difference : 17'h0;
  logic [17:0] size_3;
  assign size_3 = row_fraction_i[0] ? {difference[16], difference} : {select_70, 1'b0};
  // hls/stages/map_expand.hpp:163
  logic [17:0] select_73;
  assign select_73 = xor_67 ? (~size_3) : size_3;
  logic [22:0] arriving;
  assign arriving = {sum_66[20:1], 3'h1} + {{4{select_73[17]}}, select_73, xor_67};
  // hls/stages/map_expand.hpp:128
  logic [22:0] value;
  assign value = {1'b0, arriving[22:1]} - {1'b0, x_place_q[27:6]};
  // hls/stages/map_expand.hpp:96
  logic [22:0] select_76;
  assign select_76 = up_2[0] ? {value[21:0], 1'b0} : value;
  // hls/stages/map_expand.hpp:97
  logic [24:0] select_77;
  assign select_77 = up_2[1] ? {select_76, 2'h0} : {{2{value[22]}}, select_76};
  // hls/stages/map_expand.hpp:98
  logic [27:0] value_2;
  assign value_2 = up_2[2] ? {select_77[23:0], 4'h0} : {{3{value[22]}}, select_77};
  // hls/stages/map_expand.hpp:129
  logic [27:0] select_79;
  assign select_79 = or_21 ? value_2 : x_increment_q;
  logic [27:0] sum_80;
  assign sum_80 = x_place_q + select_79;
  // hls/stages/map_expand.hpp:130
  logic [5:0] select_81;
  assign select_81 = prime_i ? 6'h0 : sum_80[5:0];
  // hls/stages/map_expand.hpp:151
  logic [15:0] sum_2;
  assign sum_2 = xor_45 ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:150
  logic [16:0] difference_2;
  assign difference_2 = {1'b0, column_bottom_y_i} - {1'b0, column_top_y_i};
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_84;
  assign select_84 = or_51 ? 17'h0 : difference_2;
  logic [17:0] size_4;
  assign size_4 = xor_47 ? {difference_2[16], difference_2} : {select_84, 1'b0};
  // hls/stages/map_expand.hpp:163
  logic [17:0] select_87;
  assign select_87 = xor_45 ? (~size_4) : size_4;
  logic [18:0] sum_88;
  assign sum_88 = {sum_2, 3'h1} + {select_87, xor_45};
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_89;
  assign select_89 = and_61 ? difference_2 : 17'h0;
  logic [17:0] size_5;
  assign size_5 = xor_58 ? {difference_2[16], difference_2} : {select_89, 1'b0};
  // hls/stages/map_expand.hpp:163
  logic [17:0] select_92;
  assign select_92 = xor_57 ? (~size_5) : size_5;
  logic [20:0] sum_93;
  assign sum_93 = {sum_88[18:1], 3'h1} + {{2{select_92[17]}}, select_92, xor_57};
  // hls/stages/map_expand.hpp:159
  logic [16:0] select_94;
  assign select_94 = and_69 ? difference_2 : 17'h0;
  logic [17:0] size_6;
  assign size_6 = row_fraction_i[0] ? {difference_2[16], difference_2} : {select_94, 1'b0};
  // hls/stages/map_expand.hpp:163
  logic [17:0] select_97;
  assign select_97 = xor_67 ? (~size_6) : size_6;
  logic [22:0] arriving_2;
  assign arriving_2 = {sum_93[20:1], 3'h1} + {{4{select_97[17]}}, select_97, xor_67};
  // hls/stages/map_expand.hpp:128
  logic [22:0] value_3;
  assign value_3 = {1'b0, arriving_2[22:1]} - {1'b0, y_place_q[27:6]};
  // hls/stages/map_expand.hpp:96
  logic [22:0] select_100;
  assign select_100 = up_2[0] ? {value_3[21:0], 1'b0} : value_3;
  // hls/stages/map_expand.hpp:97
  logic [24:0] select_101;
  assign select_101 = up_2[1] ? {select_100, 2'h0} : {{2{value_3[22]}}, select_100};
  // hls/stages/map_expand.hpp:98
  logic [27:0] value_4;
  assign value_4 = up_2[2] ? {select_101[23:0], 4'h0} : {{3{value_3[22]}}, select_101};
  // hls/stages/map_expand.hpp:129
  logic [27:0] select_103;
  assign select_103 = or_21 ? value_4 : y_increment_q;
  logic [27:0] sum_104;
  assign sum_104 = y_place_q + select_103;
  // hls/stages/map_expand.hpp:130
  logic [5:0] select_105;
  assign select_105 = prime_i ? 6'h0 : sum_104[5:0];
  // hls/stages/map_expand.hpp:181
  logic [15:0] sum_106;
  assign sum_106 = {1'b0, x_place_q[27:13]} + 16'h1;
  logic [15:0] sum_108;
  assign sum_108 = {1'b0, y_place_q[27:13]} + 16'h1;
  // hls/stages/map_expand.hpp:78
  logic and_116;
  assign and_116 = (~(sum_106[15:10] == 6'h0)) & ((right_valid_q | and_20) & select_40);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
    end else if (s0_en) begin
      right_valid_q <= or_21 ? and_38 : right_valid_q;
      left_valid_q <= select_40;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    x_place_q = 28'h0;
    x_increment_q = 28'h0;
    y_place_q = 28'h0;
    y_increment_q = 28'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (rst_ni & s0_en) begin
      x_place_q <= {sum_80[27:6], select_81};
      x_increment_q <= select_79;
      y_place_q <= {sum_104[27:6], select_105};
      y_increment_q <= select_103;
    end
  end

  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic [8:0] sum_106_s1_q;
  logic [4:0] sum_107_s1_q;
  logic [8:0] sum_108_s1_q;
  logic [4:0] sum_109_s1_q;
  logic and_117_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      sum_106_s1_q <= sum_106[9:1];
      sum_107_s1_q <= sum_106[14:10] + 5'h1f;
      sum_108_s1_q <= sum_108[9:1];
      sum_109_s1_q <= sum_108[14:10] + 5'h1f;
      and_117_s1_q <= (~(sum_108[15:10] == 6'h0)) & and_116;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_107_s1_q, sum_106_s1_q[8:3]};
  assign y_o = {sum_109_s1_q, sum_108_s1_q[8:3]};
  assign wx_o = sum_106_s1_q[2:0];
  assign wy_o = sum_108_s1_q[2:0];
  assign mapped_o = and_117_s1_q;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = marks_last_s1_q;
  assign marks_live_o = marks_live_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & not_19;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_108[0], sum_106[0], arriving_2[0], sum_93[0], sum_88[0], arriving[0], sum_66[0], sum_56[0]};

endmodule
