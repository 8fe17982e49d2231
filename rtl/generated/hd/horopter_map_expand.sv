// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::hd>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 6 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 158 bits, pipeline 451 bits, memories 0 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;

  // Of the configuration alone: not pipelined.
  logic [2:0] up;
  assign up = (2'h2 < cfg_spacing_x_log2_i[2:1]) ? 3'h0 : (3'h6 - cfg_spacing_x_log2_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:30
  logic or_28;
  assign or_28 = (~(column_top_x_i == 16'hffff)) | (~(column_top_y_i == 16'hffff));
  logic equal_29;
  assign equal_29 = row_fraction_i == 6'h0;
  logic or_36;
  assign or_36 = (~(column_bottom_x_i == 16'hffff)) | (~(column_bottom_y_i == 16'hffff));
  // hls/stages/map_expand.hpp:70
  logic and_40;
  assign and_40 = (or_28 | (column_swapped_i & equal_29)) & (or_36 | (equal_29 & (~column_swapped_i)));
  // hls/stages/map_expand.hpp:141
  logic xor_43;
  assign xor_43 = column_swapped_i ^ row_fraction_i[0];
  logic [15:0] select_44;
  assign select_44 = xor_43 ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:142
  logic [15:0] select_45;
  assign select_45 = column_swapped_i ? column_bottom_x_i : column_top_x_i;
  // hls/stages/map_expand.hpp:141
  logic xor_47;
  assign xor_47 = column_swapped_i ^ row_fraction_i[1];
  logic xor_50;
  assign xor_50 = column_swapped_i ^ row_fraction_i[2];
  logic [15:0] select_51;
  assign select_51 = xor_50 ? column_bottom_x_i : column_top_x_i;
  logic xor_52;
  assign xor_52 = column_swapped_i ^ row_fraction_i[3];
  logic [15:0] select_53;
  assign select_53 = xor_52 ? column_bottom_x_i : column_top_x_i;
  logic xor_55;
  assign xor_55 = column_swapped_i ^ row_fraction_i[4];
  logic [15:0] select_56;
  assign select_56 = xor_55 ? column_bottom_x_i : column_top_x_i;
  logic xor_57;
  assign xor_57 = column_swapped_i ^ row_fraction_i[5];
  logic [15:0] select_58;
  assign select_58 = xor_57 ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_73;
  assign select_73 = xor_43 ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:142
  logic [15:0] select_74;
  assign select_74 = column_swapped_i ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:141
  logic [15:0] select_78;
  assign select_78 = xor_50 ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_79;
  assign select_79 = xor_52 ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_81;
  assign select_81 = xor_55 ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_82;
  assign select_82 = xor_57 ? column_bottom_y_i : column_top_y_i;

  logic prime_s1_q;
  logic load_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic and_40_s1_q;
  logic [16:0] sum_46_s1_q;
  logic [15:0] select_48_s1_q;
  logic select_51_s1_q;
  logic [16:0] sum_54_s1_q;
  logic select_56_s1_q;
  logic [16:0] sum_59_s1_q;
  logic [16:0] sum_75_s1_q;
  logic [15:0] select_76_s1_q;
  logic select_78_s1_q;
  logic [16:0] sum_80_s1_q;
  logic select_81_s1_q;
  logic [16:0] sum_83_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      prime_s1_q <= prime_i;
      load_s1_q <= load_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      and_40_s1_q <= and_40;
      sum_46_s1_q <= {1'b0, select_44} + {1'b0, select_45};
      select_48_s1_q <= xor_47 ? column_bottom_x_i : column_top_x_i;
      select_51_s1_q <= select_51[0];
      sum_54_s1_q <= {1'b0, select_53} + {2'h0, select_51[15:1]};
      select_56_s1_q <= select_56[0];
      sum_59_s1_q <= {1'b0, select_58} + {2'h0, select_56[15:1]};
      sum_75_s1_q <= {1'b0, select_73} + {1'b0, select_74};
      select_76_s1_q <= xor_47 ? column_bottom_y_i : column_top_y_i;
      select_78_s1_q <= select_78[0];
      sum_80_s1_q <= {1'b0, select_79} + {2'h0, select_78[15:1]};
      select_81_s1_q <= select_81[0];
      sum_83_s1_q <= {1'b0, select_82} + {2'h0, select_81[15:1]};
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic prime_s2_q;
  logic load_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_live_s2_q;
  logic and_40_s2_q;
  logic sum_46_s2_q;
  logic [16:0] sum_49_s2_q;
  logic select_51_s2_q;
  logic sum_54_s2_q;
  logic [17:0] sum_60_s2_q;
  logic sum_75_s2_q;
  logic [16:0] sum_77_s2_q;
  logic select_78_s2_q;
  logic sum_80_s2_q;
  logic [17:0] sum_84_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      prime_s2_q <= prime_s1_q;
      load_s2_q <= load_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_live_s2_q <= marks_live_s1_q;
      and_40_s2_q <= and_40_s1_q;
      sum_46_s2_q <= sum_46_s1_q[0];
      sum_49_s2_q <= {1'b0, select_48_s1_q} + {1'b0, sum_46_s1_q[16:1]};
      select_51_s2_q <= select_51_s1_q;
      sum_54_s2_q <= sum_54_s1_q[0];
      sum_60_s2_q <= {2'h0, sum_54_s1_q[16:1]} + {sum_59_s1_q, select_56_s1_q};
      sum_75_s2_q <= sum_75_s1_q[0];
      sum_77_s2_q <= {1'b0, select_76_s1_q} + {1'b0, sum_75_s1_q[16:1]};
      select_78_s2_q <= select_78_s1_q;
      sum_80_s2_q <= sum_80_s1_q[0];
      sum_84_s2_q <= {2'h0, sum_80_s1_q[16:1]} + {sum_83_s1_q, select_81_s1_q};
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:145
  logic [19:0] sum_61;
  assign sum_61 = {4'h0, sum_49_s2_q[16:1]} + {sum_60_s2_q, sum_54_s2_q, select_51_s2_q};
  // hls/stages/map_expand.hpp:177
  logic [19:0] sum_85;
  assign sum_85 = {sum_84_s2_q, sum_80_s2_q, select_78_s2_q} + {4'h0, sum_77_s2_q[16:1]};

  logic prime_s3_q;
  logic load_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_live_s3_q;
  logic and_40_s3_q;
  logic sum_46_s3_q;
  logic sum_49_s3_q;
  logic [19:0] sum_61_s3_q;
  logic sum_75_s3_q;
  logic sum_77_s3_q;
  logic [19:0] sum_85_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      prime_s3_q <= prime_s2_q;
      load_s3_q <= load_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_live_s3_q <= marks_live_s2_q;
      and_40_s3_q <= and_40_s2_q;
      sum_46_s3_q <= sum_46_s2_q;
      sum_49_s3_q <= sum_49_s2_q[0];
      sum_61_s3_q <= sum_61;
      sum_75_s3_q <= sum_75_s2_q;
      sum_77_s3_q <= sum_77_s2_q[0];
      sum_85_s3_q <= sum_85;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic right_valid_q;
  logic left_valid_q;
  logic [21:0] x_right_q;
  logic [21:0] y_right_q;
  // hls/stages/map_expand.hpp:66
  logic not_21;
  assign not_21 = ~prime_s3_q;
  // hls/stages/map_expand.hpp:67
  logic and_22;
  assign and_22 = load_s3_q & not_21;
  // hls/stages/map_expand.hpp:111
  logic or_23;
  assign or_23 = prime_s3_q | and_22;
  // hls/stages/map_expand.hpp:74
  logic select_42;
  assign select_42 = and_22 ? right_valid_q : left_valid_q;
  // hls/stages/map_expand.hpp:109
  logic [22:0] value_2;
  assign value_2 = {1'b0, sum_61_s3_q, sum_49_s3_q, sum_46_s3_q} - {1'b0, x_right_q};
  // hls/stages/map_expand.hpp:96
  logic [22:0] select_68;
  assign select_68 = up[0] ? {value_2[21:0], 1'b0} : value_2;
  // hls/stages/map_expand.hpp:109
  logic [22:0] value_5;
  assign value_5 = {1'b0, sum_85_s3_q, sum_77_s3_q, sum_75_s3_q} - {1'b0, y_right_q};
  // hls/stages/map_expand.hpp:96
  logic [22:0] select_89;
  assign select_89 = up[0] ? {value_5[21:0], 1'b0} : value_5;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      x_right_q <= 22'h0;
      y_right_q <= 22'h0;
    end else if (s3_en) begin
      right_valid_q <= or_23 ? and_40_s3_q : right_valid_q;
      left_valid_q <= select_42;
      x_right_q <= or_23 ? {sum_61_s3_q, sum_49_s3_q, sum_46_s3_q} : x_right_q;
      y_right_q <= or_23 ? {sum_85_s3_q, sum_77_s3_q, sum_75_s3_q} : y_right_q;
    end
  end

  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_live_s4_q;
  logic [21:0] x_right_s4_q;
  logic [21:0] y_right_s4_q;
  logic not_21_s4_q;
  logic and_22_s4_q;
  logic value_2_s4_q;
  logic [24:0] select_69_s4_q;
  logic value_5_s4_q;
  logic [24:0] select_90_s4_q;
  logic and_103_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_live_s4_q <= marks_live_s3_q;
      x_right_s4_q <= x_right_q;
      y_right_s4_q <= y_right_q;
      not_21_s4_q <= not_21;
      and_22_s4_q <= and_22;
      value_2_s4_q <= value_2[22];
      select_69_s4_q <= up[1] ? {select_68, 2'h0} : {{2{value_2[22]}}, select_68};
      value_5_s4_q <= value_5[22];
      select_90_s4_q <= up[1] ? {select_89, 2'h0} : {{2{value_5[22]}}, select_89};
      and_103_s4_q <= (right_valid_q | and_22) & select_42;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [27:0] x_place_q;
  logic [27:0] x_increment_q;
  logic [27:0] y_place_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:111
  logic [27:0] value;
  assign value = and_22_s4_q ? {x_right_s4_q, 6'h0} : x_place_q;
  // hls/stages/map_expand.hpp:98
  logic [27:0] value_3;
  assign value_3 = up[2] ? {select_69_s4_q[23:0], 4'h0} : {{3{value_2_s4_q}}, select_69_s4_q};
  // hls/stages/map_expand.hpp:111
  logic [27:0] select_71;
  assign select_71 = and_22_s4_q ? value_3 : x_increment_q;
  logic [27:0] value_4;
  assign value_4 = and_22_s4_q ? {y_right_s4_q, 6'h0} : y_place_q;
  // hls/stages/map_expand.hpp:98
  logic [27:0] value_6;
  assign value_6 = up[2] ? {select_90_s4_q[23:0], 4'h0} : {{3{value_5_s4_q}}, select_90_s4_q};
  // hls/stages/map_expand.hpp:111
  logic [27:0] select_92;
  assign select_92 = and_22_s4_q ? value_6 : y_increment_q;
  // hls/stages/map_expand.hpp:181
  logic [15:0] sum_94;
  assign sum_94 = {1'b0, value[27:13]} + 16'h1;
  logic [15:0] sum_96;
  assign sum_96 = {1'b0, value_4[27:13]} + 16'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_place_q <= 28'h0;
      x_increment_q <= 28'h0;
      y_place_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s4_en) begin
      x_place_q <= value + select_71;
      x_increment_q <= select_71;
      y_place_q <= value_4 + select_92;
      y_increment_q <= select_92;
    end
  end

  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_live_s5_q;
  logic not_21_s5_q;
  logic [13:0] sum_94_s5_q;
  logic [13:0] sum_96_s5_q;
  logic not_99_s5_q;
  logic not_101_s5_q;
  logic and_103_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_live_s5_q <= marks_live_s4_q;
      not_21_s5_q <= not_21_s4_q;
      sum_94_s5_q <= sum_94[14:1];
      sum_96_s5_q <= sum_96[14:1];
      not_99_s5_q <= ~(sum_96[15:10] == 6'h0);
      not_101_s5_q <= ~(sum_94[15:10] == 6'h0);
      and_103_s5_q <= and_103_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_live_s6_q;
  logic [8:0] sum_94_s6_q;
  logic [4:0] sum_95_s6_q;
  logic [8:0] sum_96_s6_q;
  logic [4:0] sum_97_s6_q;
  logic and_105_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_live_s6_q <= marks_live_s5_q;
      sum_94_s6_q <= sum_94_s5_q[8:0];
      sum_95_s6_q <= sum_94_s5_q[13:9] + 5'h1f;
      sum_96_s6_q <= sum_96_s5_q[8:0];
      sum_97_s6_q <= sum_96_s5_q[13:9] + 5'h1f;
      and_105_s6_q <= not_99_s5_q & (not_101_s5_q & and_103_s5_q);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_95_s6_q, sum_94_s6_q[8:3]};
  assign y_o = {sum_97_s6_q, sum_96_s6_q[8:3]};
  assign wx_o = sum_94_s6_q[2:0];
  assign wy_o = sum_96_s6_q[2:0];
  assign mapped_o = and_105_s6_q;
  assign marks_first_o = marks_first_s6_q;
  assign marks_last_o = marks_last_s6_q;
  assign marks_live_o = marks_live_s6_q;
  assign valid_o = valid_s6_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q & not_21_s5_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_96[0], sum_94[0]};

endmodule
