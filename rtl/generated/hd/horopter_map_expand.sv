// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::MapExpand<horopter::hls::profiles::hd>, hls/stages/map_expand.hpp. Do not edit.
//
// Latency 7 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 158 bits, pipeline 498 bits, memories 0 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;

  // Of the configuration alone: not pipelined.
  logic [2:0] up;
  assign up = (2'h2 < cfg_spacing_x_log2_i[2:1]) ? 3'h0 : (3'h6 - cfg_spacing_x_log2_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:122
  logic [15:0] select_23;
  assign select_23 = row_fraction_i[0] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_27;
  assign select_27 = row_fraction_i[2] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_28;
  assign select_28 = row_fraction_i[3] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_30;
  assign select_30 = row_fraction_i[4] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_31;
  assign select_31 = row_fraction_i[5] ? column_bottom_x_i : column_top_x_i;
  logic [15:0] select_36;
  assign select_36 = row_fraction_i[0] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_40;
  assign select_40 = row_fraction_i[2] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_41;
  assign select_41 = row_fraction_i[3] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_43;
  assign select_43 = row_fraction_i[4] ? column_bottom_y_i : column_top_y_i;
  logic [15:0] select_44;
  assign select_44 = row_fraction_i[5] ? column_bottom_y_i : column_top_y_i;
  // hls/stages/map_expand.hpp:26
  logic or_53;
  assign or_53 = (~(column_top_x_i == 16'hffff)) | (~(column_top_y_i == 16'hffff));
  logic or_59;
  assign or_59 = (~(column_bottom_x_i == 16'hffff)) | (~(column_bottom_y_i == 16'hffff));

  logic prime_s1_q;
  logic load_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_live_s1_q;
  logic [16:0] sum_24_s1_q;
  logic [15:0] select_25_s1_q;
  logic select_27_s1_q;
  logic [16:0] sum_29_s1_q;
  logic select_30_s1_q;
  logic [16:0] sum_32_s1_q;
  logic [16:0] sum_37_s1_q;
  logic [15:0] select_38_s1_q;
  logic select_40_s1_q;
  logic [16:0] sum_42_s1_q;
  logic select_43_s1_q;
  logic [16:0] sum_45_s1_q;
  logic and_61_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      prime_s1_q <= prime_i;
      load_s1_q <= load_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_live_s1_q <= marks_live_i;
      sum_24_s1_q <= {1'b0, column_top_x_i} + {1'b0, select_23};
      select_25_s1_q <= row_fraction_i[1] ? column_bottom_x_i : column_top_x_i;
      select_27_s1_q <= select_27[0];
      sum_29_s1_q <= {1'b0, select_28} + {2'h0, select_27[15:1]};
      select_30_s1_q <= select_30[0];
      sum_32_s1_q <= {1'b0, select_31} + {2'h0, select_30[15:1]};
      sum_37_s1_q <= {1'b0, column_top_y_i} + {1'b0, select_36};
      select_38_s1_q <= row_fraction_i[1] ? column_bottom_y_i : column_top_y_i;
      select_40_s1_q <= select_40[0];
      sum_42_s1_q <= {1'b0, select_41} + {2'h0, select_40[15:1]};
      select_43_s1_q <= select_43[0];
      sum_45_s1_q <= {1'b0, select_44} + {2'h0, select_43[15:1]};
      and_61_s1_q <= or_53 & ((row_fraction_i == 6'h0) | or_59);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic prime_s2_q;
  logic load_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_live_s2_q;
  logic sum_24_s2_q;
  logic [16:0] sum_26_s2_q;
  logic select_27_s2_q;
  logic sum_29_s2_q;
  logic [17:0] sum_33_s2_q;
  logic sum_37_s2_q;
  logic [16:0] sum_39_s2_q;
  logic select_40_s2_q;
  logic sum_42_s2_q;
  logic [17:0] sum_46_s2_q;
  logic and_61_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      prime_s2_q <= prime_s1_q;
      load_s2_q <= load_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_live_s2_q <= marks_live_s1_q;
      sum_24_s2_q <= sum_24_s1_q[0];
      sum_26_s2_q <= {1'b0, select_25_s1_q} + {1'b0, sum_24_s1_q[16:1]};
      select_27_s2_q <= select_27_s1_q;
      sum_29_s2_q <= sum_29_s1_q[0];
      sum_33_s2_q <= {2'h0, sum_29_s1_q[16:1]} + {sum_32_s1_q, select_30_s1_q};
      sum_37_s2_q <= sum_37_s1_q[0];
      sum_39_s2_q <= {1'b0, select_38_s1_q} + {1'b0, sum_37_s1_q[16:1]};
      select_40_s2_q <= select_40_s1_q;
      sum_42_s2_q <= sum_42_s1_q[0];
      sum_46_s2_q <= {2'h0, sum_42_s1_q[16:1]} + {sum_45_s1_q, select_43_s1_q};
      and_61_s2_q <= and_61_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:126
  logic [19:0] sum_34;
  assign sum_34 = {4'h0, sum_26_s2_q[16:1]} + {sum_33_s2_q, sum_29_s2_q, select_27_s2_q};
  // hls/stages/map_expand.hpp:134
  logic [19:0] sum_47;
  assign sum_47 = {sum_46_s2_q, sum_42_s2_q, select_40_s2_q} + {4'h0, sum_39_s2_q[16:1]};

  logic prime_s3_q;
  logic load_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_live_s3_q;
  logic sum_24_s3_q;
  logic sum_26_s3_q;
  logic [19:0] sum_34_s3_q;
  logic sum_37_s3_q;
  logic sum_39_s3_q;
  logic [19:0] sum_47_s3_q;
  logic and_61_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      prime_s3_q <= prime_s2_q;
      load_s3_q <= load_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_live_s3_q <= marks_live_s2_q;
      sum_24_s3_q <= sum_24_s2_q;
      sum_26_s3_q <= sum_26_s2_q[0];
      sum_34_s3_q <= sum_34;
      sum_37_s3_q <= sum_37_s2_q;
      sum_39_s3_q <= sum_39_s2_q[0];
      sum_47_s3_q <= sum_47;
      and_61_s3_q <= and_61_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [21:0] right_x_q;
  logic [21:0] right_y_q;
  logic right_valid_q;
  logic left_valid_q;
  // hls/stages/map_expand.hpp:61
  logic not_20;
  assign not_20 = ~prime_s3_q;
  // hls/stages/map_expand.hpp:62
  logic and_21;
  assign and_21 = load_s3_q & not_20;
  // hls/stages/map_expand.hpp:63
  logic or_22;
  assign or_22 = prime_s3_q | and_21;
  // hls/stages/map_expand.hpp:74
  logic select_64;
  assign select_64 = or_22 ? (and_21 ? right_valid_q : left_valid_q) : left_valid_q;
  // hls/stages/map_expand.hpp:98
  logic [22:0] value_2;
  assign value_2 = {1'b0, sum_34_s3_q, sum_26_s3_q, sum_24_s3_q} - {1'b0, right_x_q};
  logic [22:0] value_5;
  assign value_5 = {1'b0, sum_47_s3_q, sum_39_s3_q, sum_37_s3_q} - {1'b0, right_y_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_x_q <= 22'h0;
      right_y_q <= 22'h0;
      right_valid_q <= 1'b0;
      left_valid_q <= 1'b0;
    end else if (s3_en) begin
      right_x_q <= or_22 ? {sum_34_s3_q, sum_26_s3_q, sum_24_s3_q} : right_x_q;
      right_y_q <= or_22 ? {sum_47_s3_q, sum_39_s3_q, sum_37_s3_q} : right_y_q;
      right_valid_q <= or_22 ? and_61_s3_q : right_valid_q;
      left_valid_q <= select_64;
    end
  end

  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_live_s4_q;
  logic [21:0] right_x_s4_q;
  logic [21:0] right_y_s4_q;
  logic not_20_s4_q;
  logic and_21_s4_q;
  logic or_22_s4_q;
  logic [22:0] value_2_s4_q;
  logic [22:0] value_5_s4_q;
  logic and_95_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_live_s4_q <= marks_live_s3_q;
      right_x_s4_q <= right_x_q;
      right_y_s4_q <= right_y_q;
      not_20_s4_q <= not_20;
      and_21_s4_q <= and_21;
      or_22_s4_q <= or_22;
      value_2_s4_q <= value_2;
      value_5_s4_q <= value_5;
      and_95_s4_q <= (right_valid_q | and_21) & select_64;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [27:0] x_increment_q;
  logic [27:0] y_increment_q;
  // hls/stages/map_expand.hpp:110
  logic [22:0] select_71;
  assign select_71 = up[0] ? {value_2_s4_q[21:0], 1'b0} : value_2_s4_q;
  // hls/stages/map_expand.hpp:111
  logic [24:0] select_72;
  assign select_72 = up[1] ? {select_71, 2'h0} : {{2{value_2_s4_q[22]}}, select_71};
  // hls/stages/map_expand.hpp:112
  logic [27:0] value_3;
  assign value_3 = up[2] ? {select_72[23:0], 4'h0} : {{3{value_2_s4_q[22]}}, select_72};
  // hls/stages/map_expand.hpp:74
  logic [27:0] select_75;
  assign select_75 = or_22_s4_q ? (and_21_s4_q ? value_3 : x_increment_q) : x_increment_q;
  // hls/stages/map_expand.hpp:110
  logic [22:0] select_80;
  assign select_80 = up[0] ? {value_5_s4_q[21:0], 1'b0} : value_5_s4_q;
  // hls/stages/map_expand.hpp:111
  logic [24:0] select_81;
  assign select_81 = up[1] ? {select_80, 2'h0} : {{2{value_5_s4_q[22]}}, select_80};
  // hls/stages/map_expand.hpp:112
  logic [27:0] value_6;
  assign value_6 = up[2] ? {select_81[23:0], 4'h0} : {{3{value_5_s4_q[22]}}, select_81};
  // hls/stages/map_expand.hpp:74
  logic [27:0] select_84;
  assign select_84 = or_22_s4_q ? (and_21_s4_q ? value_6 : y_increment_q) : y_increment_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_increment_q <= 28'h0;
      y_increment_q <= 28'h0;
    end else if (s4_en) begin
      x_increment_q <= select_75;
      y_increment_q <= select_84;
    end
  end

  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_live_s5_q;
  logic [21:0] right_x_s5_q;
  logic [21:0] right_y_s5_q;
  logic not_20_s5_q;
  logic and_21_s5_q;
  logic or_22_s5_q;
  logic and_95_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_live_s5_q <= marks_live_s4_q;
      right_x_s5_q <= right_x_s4_q;
      right_y_s5_q <= right_y_s4_q;
      not_20_s5_q <= not_20_s4_q;
      and_21_s5_q <= and_21_s4_q;
      or_22_s5_q <= or_22_s4_q;
      and_95_s5_q <= and_95_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [27:0] x_place_q;
  logic [27:0] y_place_q;
  // hls/stages/map_expand.hpp:74
  logic [27:0] value;
  assign value = or_22_s5_q ? (and_21_s5_q ? {right_x_s5_q, 6'h0} : x_place_q) : x_place_q;
  logic [27:0] value_4;
  assign value_4 = or_22_s5_q ? (and_21_s5_q ? {right_y_s5_q, 6'h0} : y_place_q) : y_place_q;
  // hls/stages/map_expand.hpp:139
  logic [15:0] sum_86;
  assign sum_86 = {1'b0, value[27:13]} + 16'h1;
  logic [15:0] sum_88;
  assign sum_88 = {1'b0, value_4[27:13]} + 16'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_place_q <= 28'h0;
      y_place_q <= 28'h0;
    end else if (s5_en) begin
      x_place_q <= value + x_increment_q;
      y_place_q <= value_4 + y_increment_q;
    end
  end

  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic marks_live_s6_q;
  logic not_20_s6_q;
  logic [14:0] sum_86_s6_q;
  logic [14:0] sum_88_s6_q;
  logic and_95_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      marks_live_s6_q <= marks_live_s5_q;
      not_20_s6_q <= not_20_s5_q;
      sum_86_s6_q <= sum_86[15:1];
      sum_88_s6_q <= sum_88[15:1];
      and_95_s6_q <= and_95_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/map_expand.hpp:77
  logic and_97;
  assign and_97 = (~(sum_88_s6_q[14:9] == 6'h0)) & ((~(sum_86_s6_q[14:9] == 6'h0)) & and_95_s6_q);

  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic marks_live_s7_q;
  logic [8:0] sum_86_s7_q;
  logic [4:0] sum_87_s7_q;
  logic [8:0] sum_88_s7_q;
  logic [4:0] sum_89_s7_q;
  logic and_97_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      marks_live_s7_q <= marks_live_s6_q;
      sum_86_s7_q <= sum_86_s6_q[8:0];
      sum_87_s7_q <= sum_86_s6_q[13:9] + 5'h1f;
      sum_88_s7_q <= sum_88_s6_q[8:0];
      sum_89_s7_q <= sum_88_s6_q[13:9] + 5'h1f;
      and_97_s7_q <= and_97;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign x_o = {sum_87_s7_q, sum_86_s7_q[8:3]};
  assign y_o = {sum_89_s7_q, sum_88_s7_q[8:3]};
  assign wx_o = sum_86_s7_q[2:0];
  assign wy_o = sum_88_s7_q[2:0];
  assign mapped_o = and_97_s7_q;
  assign marks_first_o = marks_first_s7_q;
  assign marks_last_o = marks_last_s7_q;
  assign marks_live_o = marks_live_s7_q;
  assign valid_o = valid_s7_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
      valid_s7_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q & not_20_s6_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_88[0], sum_86[0]};

endmodule
