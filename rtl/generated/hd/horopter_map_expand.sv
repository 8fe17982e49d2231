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
  logic or_27;
  assign or_27 = (~(column_top_x_i == 16'hffff)) | (~(column_top_y_i == 16'hffff));
  logic or_33;
  assign or_33 = (~(column_bottom_x_i == 16'hffff)) | (~(column_bottom_y_i == 16'hffff));
  // hls/stages/map_expand.hpp:140
  logic [15:0] select_38;
  assign select_38 = row_fraction_i[0] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_42;
  assign select_42 = row_fraction_i[2] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_43;
  assign select_43 = row_fraction_i[3] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_45;
  assign select_45 = row_fraction_i[4] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_46;
  assign select_46 = row_fraction_i[5] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_61;
  assign select_61 = row_fraction_i[0] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_65;
  assign select_65 = row_fraction_i[2] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_66;
  assign select_66 = row_fraction_i[3] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_68;
  assign select_68 = row_fraction_i[4] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_69;
  assign select_69 = row_fraction_i[5] ? column_bottom_y_i : column_top_y_i;

  logic prime_s1_q;
  logic load_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic and_35_s1_q;
  logic [16:0] sum_39_s1_q;
  logic [15:0] select_40_s1_q;
  logic select_42_s1_q;
  logic [16:0] sum_44_s1_q;
  logic select_45_s1_q;
  logic [16:0] sum_47_s1_q;
  logic [16:0] sum_62_s1_q;
  logic [15:0] select_63_s1_q;
  logic select_65_s1_q;
  logic [16:0] sum_67_s1_q;
  logic select_68_s1_q;
  logic [16:0] sum_70_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      prime_s1_q <= prime_i;
      load_s1_q <= load_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      and_35_s1_q <= or_27 & ((row_fraction_i == 6'h0) | or_33);
      sum_39_s1_q <= {1'b0, column_top_x_i} + {1'b0, select_38};
      select_40_s1_q <= row_fraction_i[1] ? column_bottom_x_i : column_top_x_i;
      select_42_s1_q <= select_42[0];
      sum_44_s1_q <= {1'b0, select_43} + {2'h0, select_42[15:1]};
      select_45_s1_q <= select_45[0];
      sum_47_s1_q <= {1'b0, select_46} + {2'h0, select_45[15:1]};
      sum_62_s1_q <= {1'b0, column_top_y_i} + {1'b0, select_61};
      select_63_s1_q <= row_fraction_i[1] ? column_bottom_y_i : column_top_y_i;
      select_65_s1_q <= select_65[0];
      sum_67_s1_q <= {1'b0, select_66} + {2'h0, select_65[15:1]};
      select_68_s1_q <= select_68[0];
      sum_70_s1_q <= {1'b0, select_69} + {2'h0, select_68[15:1]};
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic prime_s2_q;
  logic load_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_live_s2_q;
  logic and_35_s2_q;
  logic sum_39_s2_q;
  logic [16:0] sum_41_s2_q;
  logic select_42_s2_q;
  logic sum_44_s2_q;
  logic [17:0] sum_48_s2_q;
  logic sum_62_s2_q;
  logic [16:0] sum_64_s2_q;
  logic select_65_s2_q;
  logic sum_67_s2_q;
  logic [17:0] sum_71_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      prime_s2_q <= prime_s1_q;
      load_s2_q <= load_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_live_s2_q <= marks_live_s1_q;
      and_35_s2_q <= and_35_s1_q;
      sum_39_s2_q <= sum_39_s1_q[0];
      sum_41_s2_q <= {1'b0, select_40_s1_q} + {1'b0, sum_39_s1_q[16:1]};
      select_42_s2_q <= select_42_s1_q;
      sum_44_s2_q <= sum_44_s1_q[0];
      sum_48_s2_q <= {2'h0, sum_44_s1_q[16:1]} + {sum_47_s1_q, select_45_s1_q};
      sum_62_s2_q <= sum_62_s1_q[0];
      sum_64_s2_q <= {1'b0, select_63_s1_q} + {1'b0, sum_62_s1_q[16:1]};
      select_65_s2_q <= select_65_s1_q;
      sum_67_s2_q <= sum_67_s1_q[0];
      sum_71_s2_q <= {2'h0, sum_67_s1_q[16:1]} + {sum_70_s1_q, select_68_s1_q};
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:144
  logic [19:0] sum_49;
  assign sum_49 = {4'h0, sum_41_s2_q[16:1]} + {sum_48_s2_q, sum_44_s2_q, select_42_s2_q};
  // hls/stages/map_expand.hpp:174
  logic [19:0] sum_72;
  assign sum_72 = {sum_71_s2_q, sum_67_s2_q, select_65_s2_q} + {4'h0, sum_64_s2_q[16:1]};

  logic prime_s3_q;
  logic load_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_live_s3_q;
  logic and_35_s3_q;
  logic sum_39_s3_q;
  logic sum_41_s3_q;
  logic [19:0] sum_49_s3_q;
  logic sum_62_s3_q;
  logic sum_64_s3_q;
  logic [19:0] sum_72_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      prime_s3_q <= prime_s2_q;
      load_s3_q <= load_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_live_s3_q <= marks_live_s2_q;
      and_35_s3_q <= and_35_s2_q;
      sum_39_s3_q <= sum_39_s2_q;
      sum_41_s3_q <= sum_41_s2_q[0];
      sum_49_s3_q <= sum_49;
      sum_62_s3_q <= sum_62_s2_q;
      sum_64_s3_q <= sum_64_s2_q[0];
      sum_72_s3_q <= sum_72;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic right_valid_q;
  logic left_valid_q;
  logic [21:0] x_right_q;
  logic [21:0] y_right_q;
  // hls/stages/map_expand.hpp:65
  logic not_20;
  assign not_20 = ~prime_s3_q;
  // hls/stages/map_expand.hpp:66
  logic and_21;
  assign and_21 = load_s3_q & not_20;
  // hls/stages/map_expand.hpp:110
  logic or_22;
  assign or_22 = prime_s3_q | and_21;
  // hls/stages/map_expand.hpp:73
  logic select_37;
  assign select_37 = and_21 ? right_valid_q : left_valid_q;
  // hls/stages/map_expand.hpp:108
  logic [22:0] value_2;
  assign value_2 = {1'b0, sum_49_s3_q, sum_41_s3_q, sum_39_s3_q} - {1'b0, x_right_q};
  // hls/stages/map_expand.hpp:95
  logic [22:0] select_56;
  assign select_56 = up[0] ? {value_2[21:0], 1'b0} : value_2;
  // hls/stages/map_expand.hpp:108
  logic [22:0] value_5;
  assign value_5 = {1'b0, sum_72_s3_q, sum_64_s3_q, sum_62_s3_q} - {1'b0, y_right_q};
  // hls/stages/map_expand.hpp:95
  logic [22:0] select_76;
  assign select_76 = up[0] ? {value_5[21:0], 1'b0} : value_5;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
      x_right_q <= 22'h0;
      y_right_q <= 22'h0;
    end else if (s3_en) begin
      right_valid_q <= or_22 ? and_35_s3_q : right_valid_q;
      left_valid_q <= select_37;
      x_right_q <= or_22 ? {sum_49_s3_q, sum_41_s3_q, sum_39_s3_q} : x_right_q;
      y_right_q <= or_22 ? {sum_72_s3_q, sum_64_s3_q, sum_62_s3_q} : y_right_q;
    end
  end

  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_live_s4_q;
  logic [21:0] x_right_s4_q;
  logic [21:0] y_right_s4_q;
  logic not_20_s4_q;
  logic and_21_s4_q;
  logic value_2_s4_q;
  logic [24:0] select_57_s4_q;
  logic value_5_s4_q;
  logic [24:0] select_77_s4_q;
  logic and_90_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_live_s4_q <= marks_live_s3_q;
      x_right_s4_q <= x_right_q;
      y_right_s4_q <= y_right_q;
      not_20_s4_q <= not_20;
      and_21_s4_q <= and_21;
      value_2_s4_q <= value_2[22];
      select_57_s4_q <= up[1] ? {select_56, 2'h0} : {{2{value_2[22]}}, select_56};
      value_5_s4_q <= value_5[22];
      select_77_s4_q <= up[1] ? {select_76, 2'h0} : {{2{value_5[22]}}, select_76};
      and_90_s4_q <= (right_valid_q | and_21) & select_37;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [27:0] x_place_q;
  logic [27:0] x_increment_q;
  logic [27:0] y_place_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:110
  logic [27:0] value;
  assign value = and_21_s4_q ? {x_right_s4_q, 6'h0} : x_place_q;
  // hls/stages/map_expand.hpp:97
  logic [27:0] value_3;
  assign value_3 = up[2] ? {select_57_s4_q[23:0], 4'h0} : {{3{value_2_s4_q}}, select_57_s4_q};
  // hls/stages/map_expand.hpp:110
  logic [27:0] select_59;
  assign select_59 = and_21_s4_q ? value_3 : x_increment_q;
  logic [27:0] value_4;
  assign value_4 = and_21_s4_q ? {y_right_s4_q, 6'h0} : y_place_q;
  // hls/stages/map_expand.hpp:97
  logic [27:0] value_6;
  assign value_6 = up[2] ? {select_77_s4_q[23:0], 4'h0} : {{3{value_5_s4_q}}, select_77_s4_q};
  // hls/stages/map_expand.hpp:110
  logic [27:0] select_79;
  assign select_79 = and_21_s4_q ? value_6 : y_increment_q;
  // hls/stages/map_expand.hpp:178
  logic [15:0] sum_81;
  assign sum_81 = {1'b0, value[27:13]} + 16'h1;
  logic [15:0] sum_83;
  assign sum_83 = {1'b0, value_4[27:13]} + 16'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_place_q <= 28'h0;
      x_increment_q <= 28'h0;
      y_place_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s4_en) begin
      x_place_q <= value + select_59;
      x_increment_q <= select_59;
      y_place_q <= value_4 + select_79;
      y_increment_q <= select_79;
    end
  end

  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_live_s5_q;
  logic not_20_s5_q;
  logic [13:0] sum_81_s5_q;
  logic [13:0] sum_83_s5_q;
  logic not_86_s5_q;
  logic not_88_s5_q;
  logic and_90_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_live_s5_q <= marks_live_s4_q;
      not_20_s5_q <= not_20_s4_q;
      sum_81_s5_q <= sum_81[14:1];
      sum_83_s5_q <= sum_83[14:1];
      not_86_s5_q <= ~(sum_83[15:10] == 6'h0);
      not_88_s5_q <= ~(sum_81[15:10] == 6'h0);
      and_90_s5_q <= and_90_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_live_s6_q;
  logic [8:0] sum_81_s6_q;
  logic [4:0] sum_82_s6_q;
  logic [8:0] sum_83_s6_q;
  logic [4:0] sum_84_s6_q;
  logic and_92_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_live_s6_q <= marks_live_s5_q;
      sum_81_s6_q <= sum_81_s5_q[8:0];
      sum_82_s6_q <= sum_81_s5_q[13:9] + 5'h1f;
      sum_83_s6_q <= sum_83_s5_q[8:0];
      sum_84_s6_q <= sum_83_s5_q[13:9] + 5'h1f;
      and_92_s6_q <= not_86_s5_q & (not_88_s5_q & and_90_s5_q);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_82_s6_q, sum_81_s6_q[8:3]};
  assign y_o = {sum_84_s6_q, sum_83_s6_q[8:3]};
  assign wx_o = sum_81_s6_q[2:0];
  assign wy_o = sum_83_s6_q[2:0];
  assign mapped_o = and_92_s6_q;
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
      valid_s6_q <= valid_s5_q & not_20_s5_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_83[0], sum_81[0]};

endmodule
