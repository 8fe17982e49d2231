// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::vga>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
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
  // hls/stages/map_expand.hpp:71
  logic not_26;
  assign not_26 = ~prime_i;
  // hls/stages/map_expand.hpp:72
  logic and_27;
  assign and_27 = load_i & not_26;
  // hls/stages/map_expand.hpp:143
  logic or_28;
  assign or_28 = prime_i | and_27;
  // hls/stages/map_expand.hpp:189
  logic equal_29;
  assign equal_29 = row_fraction_i == 6'h0;
  logic and_30;
  assign and_30 = column_swapped_i & equal_29;
  // hls/stages/map_expand.hpp:190
  logic and_33;
  assign and_33 = equal_29 & (~column_swapped_i);
  // hls/stages/map_expand.hpp:76
  logic and_35;
  assign and_35 = (column_top_exists_i | and_30) & (column_bottom_exists_i | and_33);
  // hls/stages/map_expand.hpp:83
  logic select_37;
  assign select_37 = and_27 ? right_valid_q : left_valid_q;
  // hls/stages/map_expand.hpp:76
  logic and_40;
  assign and_40 = (column_top_of_skin_i | and_30) & (column_bottom_of_skin_i | and_33);
  // hls/stages/map_expand.hpp:83
  logic select_42;
  assign select_42 = and_27 ? right_of_skin_q : left_of_skin_q;
  // hls/stages/map_expand.hpp:111
  logic [2:0] up_2;
  assign up_2 = prime_i ? 3'h6 : up;
  // hls/stages/map_expand.hpp:166
  logic xor_47;
  assign xor_47 = column_swapped_i ^ row_fraction_i[5];
  logic [15:0] sum;
  assign sum = xor_47 ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:170
  logic xor_49;
  assign xor_49 = row_fraction_i[3] ^ row_fraction_i[4];
  // hls/stages/map_expand.hpp:165
  logic [16:0] once;
  assign once = {1'b0, column_bottom_x_i} - {1'b0, column_top_x_i};
  // hls/stages/map_expand.hpp:172
  logic or_53;
  assign or_53 = xor_49 | (row_fraction_i[3] ^ (~row_fraction_i[5]));
  // hls/stages/map_expand.hpp:174
  logic [16:0] select_54;
  assign select_54 = or_53 ? 17'h0 : once;
  logic [17:0] size;
  assign size = xor_49 ? {once[16], once} : {select_54, 1'b0};
  // hls/stages/map_expand.hpp:178
  logic [17:0] select_57;
  assign select_57 = xor_47 ? (~size) : size;
  logic [18:0] sum_58;
  assign sum_58 = {sum, 3'h1} + {select_57, xor_47};
  // hls/stages/map_expand.hpp:175
  logic xor_59;
  assign xor_59 = column_swapped_i ^ row_fraction_i[3];
  // hls/stages/map_expand.hpp:170
  logic xor_60;
  assign xor_60 = row_fraction_i[1] ^ row_fraction_i[2];
  // hls/stages/map_expand.hpp:171
  logic and_63;
  assign and_63 = (~xor_60) & (row_fraction_i[1] ^ row_fraction_i[3]);
  // hls/stages/map_expand.hpp:174
  logic [16:0] select_64;
  assign select_64 = and_63 ? once : 17'h0;
  logic [17:0] size_2;
  assign size_2 = xor_60 ? {once[16], once} : {select_64, 1'b0};
  // hls/stages/map_expand.hpp:178
  logic [17:0] select_67;
  assign select_67 = xor_59 ? (~size_2) : size_2;
  logic [20:0] sum_68;
  assign sum_68 = {sum_58[18:1], 3'h1} + {{2{select_67[17]}}, select_67, xor_59};
  // hls/stages/map_expand.hpp:175
  logic xor_69;
  assign xor_69 = column_swapped_i ^ row_fraction_i[1];
  // hls/stages/map_expand.hpp:171
  logic and_71;
  assign and_71 = row_fraction_i[1] & (~row_fraction_i[0]);
  // hls/stages/map_expand.hpp:174
  logic [16:0] select_72;
  assign select_72 = and_71 ? once : 17'h0;
  logic [17:0] size_3;
  assign size_3 = row_fraction_i[0] ? {once[16], once} : {select_72, 1'b0};
  // hls/stages/map_expand.hpp:178
  logic [17:0] select_75;
  assign select_75 = xor_69 ? (~size_3) : size_3;
  logic [22:0] arriving;
  assign arriving = {sum_68[20:1], 3'h1} + {{4{select_75[17]}}, select_75, xor_69};
  // hls/stages/map_expand.hpp:143
  logic [22:0] value;
  assign value = {1'b0, arriving[22:1]} - {1'b0, x_place_q[27:6]};
  // hls/stages/map_expand.hpp:111
  logic [22:0] select_78;
  assign select_78 = up_2[0] ? {value[21:0], 1'b0} : value;
  // hls/stages/map_expand.hpp:112
  logic [24:0] select_79;
  assign select_79 = up_2[1] ? {select_78, 2'h0} : {{2{value[22]}}, select_78};
  // hls/stages/map_expand.hpp:113
  logic [27:0] value_2;
  assign value_2 = up_2[2] ? {select_79[23:0], 4'h0} : {{3{value[22]}}, select_79};
  // hls/stages/map_expand.hpp:144
  logic [27:0] select_81;
  assign select_81 = or_28 ? value_2 : x_increment_q;
  logic [27:0] sum_82;
  assign sum_82 = x_place_q + select_81;
  // hls/stages/map_expand.hpp:145
  logic [5:0] select_83;
  assign select_83 = prime_i ? 6'h0 : sum_82[5:0];
  // hls/stages/map_expand.hpp:166
  logic [15:0] sum_2;
  assign sum_2 = xor_47 ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:165
  logic [16:0] once_2;
  assign once_2 = {1'b0, column_bottom_y_i} - {1'b0, column_top_y_i};
  // hls/stages/map_expand.hpp:174
  logic [16:0] select_86;
  assign select_86 = or_53 ? 17'h0 : once_2;
  logic [17:0] size_4;
  assign size_4 = xor_49 ? {once_2[16], once_2} : {select_86, 1'b0};
  // hls/stages/map_expand.hpp:178
  logic [17:0] select_89;
  assign select_89 = xor_47 ? (~size_4) : size_4;
  logic [18:0] sum_90;
  assign sum_90 = {sum_2, 3'h1} + {select_89, xor_47};
  // hls/stages/map_expand.hpp:174
  logic [16:0] select_91;
  assign select_91 = and_63 ? once_2 : 17'h0;
  logic [17:0] size_5;
  assign size_5 = xor_60 ? {once_2[16], once_2} : {select_91, 1'b0};
  // hls/stages/map_expand.hpp:178
  logic [17:0] select_94;
  assign select_94 = xor_59 ? (~size_5) : size_5;
  logic [20:0] sum_95;
  assign sum_95 = {sum_90[18:1], 3'h1} + {{2{select_94[17]}}, select_94, xor_59};
  // hls/stages/map_expand.hpp:174
  logic [16:0] select_96;
  assign select_96 = and_71 ? once_2 : 17'h0;
  logic [17:0] size_6;
  assign size_6 = row_fraction_i[0] ? {once_2[16], once_2} : {select_96, 1'b0};
  // hls/stages/map_expand.hpp:178
  logic [17:0] select_99;
  assign select_99 = xor_69 ? (~size_6) : size_6;
  logic [22:0] arriving_2;
  assign arriving_2 = {sum_95[20:1], 3'h1} + {{4{select_99[17]}}, select_99, xor_69};
  // hls/stages/map_expand.hpp:143
  logic [22:0] value_3;
  assign value_3 = {1'b0, arriving_2[22:1]} - {1'b0, y_place_q[27:6]};
  // hls/stages/map_expand.hpp:111
  logic [22:0] select_102;
  assign select_102 = up_2[0] ? {value_3[21:0], 1'b0} : value_3;
  // hls/stages/map_expand.hpp:112
  logic [24:0] select_103;
  assign select_103 = up_2[1] ? {select_102, 2'h0} : {{2{value_3[22]}}, select_102};
  // hls/stages/map_expand.hpp:113
  logic [27:0] value_4;
  assign value_4 = up_2[2] ? {select_103[23:0], 4'h0} : {{3{value_3[22]}}, select_103};
  // hls/stages/map_expand.hpp:144
  logic [27:0] select_105;
  assign select_105 = or_28 ? value_4 : y_increment_q;
  logic [27:0] sum_106;
  assign sum_106 = y_place_q + select_105;
  // hls/stages/map_expand.hpp:145
  logic [5:0] select_107;
  assign select_107 = prime_i ? 6'h0 : sum_106[5:0];
  // hls/stages/map_expand.hpp:198
  logic [15:0] sum_108;
  assign sum_108 = {1'b0, x_place_q[27:13]} + 16'h1;
  logic [15:0] sum_110;
  assign sum_110 = {1'b0, y_place_q[27:13]} + 16'h1;
  // hls/stages/map_expand.hpp:90
  logic and_116;
  assign and_116 = (~(sum_108[15:10] == 6'h0)) & (~(sum_110[15:10] == 6'h0));
  // hls/stages/map_expand.hpp:91
  logic and_121;
  assign and_121 = (and_116 & ((right_of_skin_q | and_27) & select_42)) & (~outside_i);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      right_of_skin_q <= 1'b0;
      left_of_skin_q <= 1'b0;
    end else if (s0_en) begin
      right_valid_q <= or_28 ? and_35 : right_valid_q;
      left_valid_q <= select_37;
      right_of_skin_q <= or_28 ? and_40 : right_of_skin_q;
      left_of_skin_q <= select_42;
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
      x_place_q <= {sum_82[27:6], select_83};
      x_increment_q <= select_81;
      y_place_q <= {sum_106[27:6], select_107};
      y_increment_q <= select_105;
    end
  end

  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic [8:0] sum_108_s1_q;
  logic [4:0] sum_109_s1_q;
  logic [8:0] sum_110_s1_q;
  logic [4:0] sum_111_s1_q;
  logic and_121_s1_q;
  logic and_124_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      sum_108_s1_q <= sum_108[9:1];
      sum_109_s1_q <= sum_108[14:10] + 5'h1f;
      sum_110_s1_q <= sum_110[9:1];
      sum_111_s1_q <= sum_110[14:10] + 5'h1f;
      and_121_s1_q <= and_121;
      and_124_s1_q <= and_116 & ((right_valid_q | and_27) & select_37);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_109_s1_q, sum_108_s1_q[8:3]};
  assign y_o = {sum_111_s1_q, sum_110_s1_q[8:3]};
  assign wx_o = sum_108_s1_q[2:0];
  assign wy_o = sum_110_s1_q[2:0];
  assign mapped_o = and_121_s1_q;
  assign present_o = and_124_s1_q;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = marks_last_s1_q;
  assign marks_live_o = marks_live_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & not_26;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_110[0], sum_108[0], arriving_2[0], sum_95[0], sum_90[0], arriving[0], sum_68[0], sum_58[0]};

endmodule
