// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::field>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 116 bits, pipeline 34 bits, memories 0 bits.
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
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

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
  logic [27:0] y_place_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:68
  logic not_25;
  assign not_25 = ~prime_i;
  // hls/stages/map_expand.hpp:69
  logic and_26;
  assign and_26 = load_i & not_25;
  // hls/stages/map_expand.hpp:140
  logic or_27;
  assign or_27 = prime_i | and_26;
  // hls/stages/map_expand.hpp:186
  logic equal_28;
  assign equal_28 = row_fraction_i == 6'h0;
  logic and_29;
  assign and_29 = column_swapped_i & equal_28;
  // hls/stages/map_expand.hpp:187
  logic and_32;
  assign and_32 = equal_28 & (~column_swapped_i);
  // hls/stages/map_expand.hpp:73
  logic and_34;
  assign and_34 = (column_top_exists_i | and_29) & (column_bottom_exists_i | and_32);
  // hls/stages/map_expand.hpp:80
  logic select_36;
  assign select_36 = and_26 ? right_valid_q : left_valid_q;
  // hls/stages/map_expand.hpp:73
  logic and_39;
  assign and_39 = (column_top_of_skin_i | and_29) & (column_bottom_of_skin_i | and_32);
  // hls/stages/map_expand.hpp:80
  logic select_41;
  assign select_41 = and_26 ? right_of_skin_q : left_of_skin_q;
  // hls/stages/map_expand.hpp:108
  logic [2:0] up_2;
  assign up_2 = prime_i ? 3'h6 : up;
  // hls/stages/map_expand.hpp:163
  logic xor_46;
  assign xor_46 = column_swapped_i ^ row_fraction_i[5];
  logic [15:0] sum;
  assign sum = xor_46 ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:167
  logic xor_48;
  assign xor_48 = row_fraction_i[3] ^ row_fraction_i[4];
  // hls/stages/map_expand.hpp:162
  logic [16:0] once;
  assign once = {1'b0, column_bottom_x_i} - {1'b0, column_top_x_i};
  // hls/stages/map_expand.hpp:169
  logic or_52;
  assign or_52 = xor_48 | (row_fraction_i[3] ^ (~row_fraction_i[5]));
  // hls/stages/map_expand.hpp:171
  logic [16:0] select_53;
  assign select_53 = or_52 ? 17'h0 : once;
  logic [17:0] size;
  assign size = xor_48 ? {once[16], once} : {select_53, 1'b0};
  // hls/stages/map_expand.hpp:175
  logic [17:0] select_56;
  assign select_56 = xor_46 ? (~size) : size;
  logic [18:0] sum_57;
  assign sum_57 = {sum, 3'h1} + {select_56, xor_46};
  // hls/stages/map_expand.hpp:172
  logic xor_58;
  assign xor_58 = column_swapped_i ^ row_fraction_i[3];
  // hls/stages/map_expand.hpp:167
  logic xor_59;
  assign xor_59 = row_fraction_i[1] ^ row_fraction_i[2];
  // hls/stages/map_expand.hpp:168
  logic and_62;
  assign and_62 = (~xor_59) & (row_fraction_i[1] ^ row_fraction_i[3]);
  // hls/stages/map_expand.hpp:171
  logic [16:0] select_63;
  assign select_63 = and_62 ? once : 17'h0;
  logic [17:0] size_2;
  assign size_2 = xor_59 ? {once[16], once} : {select_63, 1'b0};
  // hls/stages/map_expand.hpp:175
  logic [17:0] select_66;
  assign select_66 = xor_58 ? (~size_2) : size_2;
  logic [20:0] sum_67;
  assign sum_67 = {sum_57[18:1], 3'h1} + {{2{select_66[17]}}, select_66, xor_58};
  // hls/stages/map_expand.hpp:172
  logic xor_68;
  assign xor_68 = column_swapped_i ^ row_fraction_i[1];
  // hls/stages/map_expand.hpp:168
  logic and_70;
  assign and_70 = row_fraction_i[1] & (~row_fraction_i[0]);
  // hls/stages/map_expand.hpp:171
  logic [16:0] select_71;
  assign select_71 = and_70 ? once : 17'h0;
  logic [17:0] size_3;
  assign size_3 = row_fraction_i[0] ? {once[16], once} : {select_71, 1'b0};
  // hls/stages/map_expand.hpp:175
  logic [17:0] select_74;
  assign select_74 = xor_68 ? (~size_3) : size_3;
  logic [22:0] arriving;
  assign arriving = {sum_67[20:1], 3'h1} + {{4{select_74[17]}}, select_74, xor_68};
  // hls/stages/map_expand.hpp:140
  logic [22:0] value;
  assign value = {1'b0, arriving[22:1]} - {1'b0, x_place_q[27:6]};
  // hls/stages/map_expand.hpp:108
  logic [22:0] select_77;
  assign select_77 = up_2[0] ? {value[21:0], 1'b0} : value;
  // hls/stages/map_expand.hpp:109
  logic [24:0] select_78;
  assign select_78 = up_2[1] ? {select_77, 2'h0} : {{2{value[22]}}, select_77};
  // hls/stages/map_expand.hpp:110
  logic [27:0] value_2;
  assign value_2 = up_2[2] ? {select_78[23:0], 4'h0} : {{3{value[22]}}, select_78};
  // hls/stages/map_expand.hpp:141
  logic [27:0] select_80;
  assign select_80 = or_27 ? value_2 : x_increment_q;
  logic [27:0] sum_81;
  assign sum_81 = x_place_q + select_80;
  // hls/stages/map_expand.hpp:142
  logic [5:0] select_82;
  assign select_82 = prime_i ? 6'h0 : sum_81[5:0];
  // hls/stages/map_expand.hpp:163
  logic [15:0] sum_2;
  assign sum_2 = xor_46 ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:162
  logic [16:0] once_2;
  assign once_2 = {1'b0, column_bottom_y_i} - {1'b0, column_top_y_i};
  // hls/stages/map_expand.hpp:171
  logic [16:0] select_85;
  assign select_85 = or_52 ? 17'h0 : once_2;
  logic [17:0] size_4;
  assign size_4 = xor_48 ? {once_2[16], once_2} : {select_85, 1'b0};
  // hls/stages/map_expand.hpp:175
  logic [17:0] select_88;
  assign select_88 = xor_46 ? (~size_4) : size_4;
  logic [18:0] sum_89;
  assign sum_89 = {sum_2, 3'h1} + {select_88, xor_46};
  // hls/stages/map_expand.hpp:171
  logic [16:0] select_90;
  assign select_90 = and_62 ? once_2 : 17'h0;
  logic [17:0] size_5;
  assign size_5 = xor_59 ? {once_2[16], once_2} : {select_90, 1'b0};
  // hls/stages/map_expand.hpp:175
  logic [17:0] select_93;
  assign select_93 = xor_58 ? (~size_5) : size_5;
  logic [20:0] sum_94;
  assign sum_94 = {sum_89[18:1], 3'h1} + {{2{select_93[17]}}, select_93, xor_58};
  // hls/stages/map_expand.hpp:171
  logic [16:0] select_95;
  assign select_95 = and_70 ? once_2 : 17'h0;
  logic [17:0] size_6;
  assign size_6 = row_fraction_i[0] ? {once_2[16], once_2} : {select_95, 1'b0};
  // hls/stages/map_expand.hpp:175
  logic [17:0] select_98;
  assign select_98 = xor_68 ? (~size_6) : size_6;
  logic [22:0] arriving_2;
  assign arriving_2 = {sum_94[20:1], 3'h1} + {{4{select_98[17]}}, select_98, xor_68};
  // hls/stages/map_expand.hpp:140
  logic [22:0] value_3;
  assign value_3 = {1'b0, arriving_2[22:1]} - {1'b0, y_place_q[27:6]};
  // hls/stages/map_expand.hpp:108
  logic [22:0] select_101;
  assign select_101 = up_2[0] ? {value_3[21:0], 1'b0} : value_3;
  // hls/stages/map_expand.hpp:109
  logic [24:0] select_102;
  assign select_102 = up_2[1] ? {select_101, 2'h0} : {{2{value_3[22]}}, select_101};
  // hls/stages/map_expand.hpp:110
  logic [27:0] value_4;
  assign value_4 = up_2[2] ? {select_102[23:0], 4'h0} : {{3{value_3[22]}}, select_102};
  // hls/stages/map_expand.hpp:141
  logic [27:0] select_104;
  assign select_104 = or_27 ? value_4 : y_increment_q;
  logic [27:0] sum_105;
  assign sum_105 = y_place_q + select_104;
  // hls/stages/map_expand.hpp:142
  logic [5:0] select_106;
  assign select_106 = prime_i ? 6'h0 : sum_105[5:0];
  // hls/stages/map_expand.hpp:195
  logic [15:0] sum_107;
  assign sum_107 = {1'b0, x_place_q[27:13]} + 16'h1;
  logic [15:0] sum_109;
  assign sum_109 = {1'b0, y_place_q[27:13]} + 16'h1;
  // hls/stages/map_expand.hpp:87
  logic and_115;
  assign and_115 = (~(sum_107[15:10] == 6'h0)) & (~(sum_109[15:10] == 6'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      right_of_skin_q <= 1'b0;
      left_of_skin_q <= 1'b0;
    end else if (s0_en) begin
      right_valid_q <= or_27 ? and_34 : right_valid_q;
      left_valid_q <= select_36;
      right_of_skin_q <= or_27 ? and_39 : right_of_skin_q;
      left_of_skin_q <= select_41;
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
      x_place_q <= {sum_81[27:6], select_82};
      x_increment_q <= select_80;
      y_place_q <= {sum_105[27:6], select_106};
      y_increment_q <= select_104;
    end
  end

  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic [8:0] sum_107_s1_q;
  logic [4:0] sum_108_s1_q;
  logic [8:0] sum_109_s1_q;
  logic [4:0] sum_110_s1_q;
  logic and_118_s1_q;
  logic and_121_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      sum_107_s1_q <= sum_107[9:1];
      sum_108_s1_q <= sum_107[14:10] + 5'h1f;
      sum_109_s1_q <= sum_109[9:1];
      sum_110_s1_q <= sum_109[14:10] + 5'h1f;
      and_118_s1_q <= and_115 & ((right_of_skin_q | and_26) & select_41);
      and_121_s1_q <= and_115 & ((right_valid_q | and_26) & select_36);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_108_s1_q, sum_107_s1_q[8:3]};
  assign y_o = {sum_110_s1_q, sum_109_s1_q[8:3]};
  assign wx_o = sum_107_s1_q[2:0];
  assign wy_o = sum_109_s1_q[2:0];
  assign mapped_o = and_118_s1_q;
  assign present_o = and_121_s1_q;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = marks_last_s1_q;
  assign marks_live_o = marks_live_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & not_25;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_109[0], sum_107[0], arriving_2[0], sum_94[0], sum_89[0], arriving[0], sum_67[0], sum_57[0]};

endmodule
