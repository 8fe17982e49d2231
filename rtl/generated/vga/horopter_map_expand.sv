// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::vga>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 158 bits, pipeline 33 bits, memories 0 bits.
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
  logic [21:0] right_x_q;
  logic [21:0] right_y_q;
  logic right_valid_q;
  logic left_valid_q;
  logic [27:0] x_place_q;
  logic [27:0] x_increment_q;
  logic [27:0] y_place_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:61
  logic not_20;
  assign not_20 = ~prime_i;
  // hls/stages/map_expand.hpp:62
  logic and_21;
  assign and_21 = load_i & not_20;
  // hls/stages/map_expand.hpp:63
  logic or_22;
  assign or_22 = prime_i | and_21;
  // hls/stages/map_expand.hpp:122
  logic [15:0] select_23;
  assign select_23 = row_fraction_i[0] ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:123
  logic [16:0] sum_24;
  assign sum_24 = {1'b0, column_top_x_i} + {1'b0, select_23};
  // hls/stages/map_expand.hpp:122
  logic [15:0] select_25;
  assign select_25 = row_fraction_i[1] ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:123
  logic [16:0] sum_26;
  assign sum_26 = {1'b0, select_25} + {1'b0, sum_24[16:1]};
  // hls/stages/map_expand.hpp:122
  logic [15:0] select_27;
  assign select_27 = row_fraction_i[2] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_28;
  assign select_28 = row_fraction_i[3] ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:124
  logic [16:0] sum_29;
  assign sum_29 = {1'b0, select_28} + {2'h0, select_27[15:1]};
  // hls/stages/map_expand.hpp:122
  logic [15:0] select_30;
  assign select_30 = row_fraction_i[4] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_31;
  assign select_31 = row_fraction_i[5] ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:126
  logic [16:0] sum_32;
  assign sum_32 = {1'b0, select_31} + {2'h0, select_30[15:1]};
  logic [17:0] sum_33;
  assign sum_33 = {2'h0, sum_29[16:1]} + {sum_32, select_30[0]};
  logic [19:0] sum_34;
  assign sum_34 = {4'h0, sum_26[16:1]} + {sum_33, sum_29[0], select_27[0]};
  // hls/stages/map_expand.hpp:122
  logic [15:0] select_36;
  assign select_36 = row_fraction_i[0] ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:123
  logic [16:0] sum_37;
  assign sum_37 = {1'b0, column_top_y_i} + {1'b0, select_36};
  // hls/stages/map_expand.hpp:122
  logic [15:0] select_38;
  assign select_38 = row_fraction_i[1] ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:134
  logic [16:0] sum_39;
  assign sum_39 = {1'b0, select_38} + {1'b0, sum_37[16:1]};
  // hls/stages/map_expand.hpp:122
  logic [15:0] select_40;
  assign select_40 = row_fraction_i[2] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_41;
  assign select_41 = row_fraction_i[3] ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:124
  logic [16:0] sum_42;
  assign sum_42 = {1'b0, select_41} + {2'h0, select_40[15:1]};
  // hls/stages/map_expand.hpp:122
  logic [15:0] select_43;
  assign select_43 = row_fraction_i[4] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_44;
  assign select_44 = row_fraction_i[5] ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:126
  logic [16:0] sum_45;
  assign sum_45 = {1'b0, select_44} + {2'h0, select_43[15:1]};
  logic [17:0] sum_46;
  assign sum_46 = {2'h0, sum_42[16:1]} + {sum_45, select_43[0]};
  // hls/stages/map_expand.hpp:134
  logic [19:0] sum_47;
  assign sum_47 = {sum_46, sum_42[0], select_40[0]} + {4'h0, sum_39[16:1]};
  // hls/stages/map_expand.hpp:26
  logic or_53;
  assign or_53 = (~(column_top_x_i == 16'hffff)) | (~(column_top_y_i == 16'hffff));
  logic or_59;
  assign or_59 = (~(column_bottom_x_i == 16'hffff)) | (~(column_bottom_y_i == 16'hffff));
  // hls/stages/map_expand.hpp:74
  logic select_62;
  assign select_62 = or_22 ? (or_53 & ((row_fraction_i == 6'h0) | or_59)) : right_valid_q;
  logic select_64;
  assign select_64 = or_22 ? (and_21 ? right_valid_q : left_valid_q) : left_valid_q;
  logic [27:0] value;
  assign value = or_22 ? (and_21 ? {right_x_q, 6'h0} : x_place_q) : x_place_q;
  // hls/stages/map_expand.hpp:98
  logic [22:0] value_2;
  assign value_2 = {1'b0, sum_34, sum_26[0], sum_24[0]} - {1'b0, right_x_q};
  // hls/stages/map_expand.hpp:110
  logic [22:0] select_71;
  assign select_71 = up[0] ? {value_2[21:0], 1'b0} : value_2;
  // hls/stages/map_expand.hpp:111
  logic [24:0] select_72;
  assign select_72 = up[1] ? {select_71, 2'h0} : {{2{value_2[22]}}, select_71};
  // hls/stages/map_expand.hpp:112
  logic [27:0] value_3;
  assign value_3 = up[2] ? {select_72[23:0], 4'h0} : {{3{value_2[22]}}, select_72};
  // hls/stages/map_expand.hpp:74
  logic [27:0] select_75;
  assign select_75 = or_22 ? (and_21 ? value_3 : x_increment_q) : x_increment_q;
  logic [27:0] value_4;
  assign value_4 = or_22 ? (and_21 ? {right_y_q, 6'h0} : y_place_q) : y_place_q;
  // hls/stages/map_expand.hpp:98
  logic [22:0] value_5;
  assign value_5 = {1'b0, sum_47, sum_39[0], sum_37[0]} - {1'b0, right_y_q};
  // hls/stages/map_expand.hpp:110
  logic [22:0] select_80;
  assign select_80 = up[0] ? {value_5[21:0], 1'b0} : value_5;
  // hls/stages/map_expand.hpp:111
  logic [24:0] select_81;
  assign select_81 = up[1] ? {select_80, 2'h0} : {{2{value_5[22]}}, select_80};
  // hls/stages/map_expand.hpp:112
  logic [27:0] value_6;
  assign value_6 = up[2] ? {select_81[23:0], 4'h0} : {{3{value_5[22]}}, select_81};
  // hls/stages/map_expand.hpp:74
  logic [27:0] select_84;
  assign select_84 = or_22 ? (and_21 ? value_6 : y_increment_q) : y_increment_q;
  // hls/stages/map_expand.hpp:139
  logic [15:0] sum_86;
  assign sum_86 = {1'b0, value[27:13]} + 16'h1;
  logic [15:0] sum_88;
  assign sum_88 = {1'b0, value_4[27:13]} + 16'h1;
  // hls/stages/map_expand.hpp:77
  logic and_96;
  assign and_96 = (~(sum_86[15:10] == 6'h0)) & ((right_valid_q | and_21) & select_64);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_x_q <= 22'h0;
      right_y_q <= 22'h0;
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      x_place_q <= 28'h0;
      x_increment_q <= 28'h0;
      y_place_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s0_en) begin
      right_x_q <= or_22 ? {sum_34, sum_26[0], sum_24[0]} : right_x_q;
      right_y_q <= or_22 ? {sum_47, sum_39[0], sum_37[0]} : right_y_q;
      right_valid_q <= select_62;
      left_valid_q <= select_64;
      x_place_q <= value + select_75;
      x_increment_q <= select_75;
      y_place_q <= value_4 + select_84;
      y_increment_q <= select_84;
    end
  end

  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic [8:0] sum_86_s1_q;
  logic [4:0] sum_87_s1_q;
  logic [8:0] sum_88_s1_q;
  logic [4:0] sum_89_s1_q;
  logic and_97_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      sum_86_s1_q <= sum_86[9:1];
      sum_87_s1_q <= sum_86[14:10] + 5'h1f;
      sum_88_s1_q <= sum_88[9:1];
      sum_89_s1_q <= sum_88[14:10] + 5'h1f;
      and_97_s1_q <= (~(sum_88[15:10] == 6'h0)) & and_96;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_87_s1_q, sum_86_s1_q[8:3]};
  assign y_o = {sum_89_s1_q, sum_88_s1_q[8:3]};
  assign wx_o = sum_86_s1_q[2:0];
  assign wy_o = sum_88_s1_q[2:0];
  assign mapped_o = and_97_s1_q;
  assign marks_first_o = marks_first_s1_q;
  assign marks_last_o = marks_last_s1_q;
  assign marks_live_o = marks_live_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & not_20;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_88[0], sum_86[0]};

endmodule
