// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Coarse<horopter::hls::profiles::vga>, hls/stages/coarse.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 161 bits, pipeline 5 bits, memories 0 bits.
module horopter_coarse (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] left_i,
  input  logic [7:0] right_i,
  input  logic first_i,
  input  logic start_i,
  input  logic [7:0] cfg_one_camera_segments_i,
  input  logic [7:0] cfg_blind_step_i,
  input  logic [7:0] cfg_blind_share_i,
  output logic valid_o,
  output logic one_camera_o,
  output logic left_blind_o,
  output logic right_blind_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_q;
  logic [7:0] right_q;
  logic [8:0] g_q;
  logic [8:0] h_q;
  logic [2:0] column_q;
  logic second_q;
  logic [20:0] determinants_q;
  logic [20:0] products_q;
  logic [11:0] texture_q;
  logic [11:0] segments_missing_q;
  logic [12:0] score_q;
  logic [21:0] left_steps_balance_q;
  logic [21:0] right_steps_balance_q;
  // hls/stages/coarse.hpp:57
  logic [8:0] g;
  assign g = {1'b0, left_i} - {1'b0, left_q};
  logic [8:0] g_2;
  assign g_2 = start_i ? 9'h0 : g;
  // hls/stages/coarse.hpp:58
  logic [8:0] h;
  assign h = {1'b0, right_i} - {1'b0, right_q};
  logic [8:0] h_2;
  assign h_2 = start_i ? 9'h0 : h;
  // hls/stages/coarse.hpp:57
  logic [2:0] select_25;
  assign select_25 = start_i ? 3'h0 : column_q;
  // hls/stages/coarse.hpp:69
  logic equal_27;
  assign equal_27 = select_25 == 3'h7;
  // hls/stages/coarse.hpp:57
  logic and_29;
  assign and_29 = second_q & (~start_i);
  // hls/stages/coarse.hpp:65
  logic [17:0] product_30;
  assign product_30 = $signed({{9{g_q[8]}}, g_q}) * $signed({{9{h_2[8]}}, h_2});
  logic [17:0] product_31;
  assign product_31 = $signed({{9{h_q[8]}}, h_q}) * $signed({{9{g_2[8]}}, g_2});
  logic [18:0] difference_32;
  assign difference_32 = {product_30[17], product_30} - {product_31[17], product_31};
  // hls/stages/coarse.hpp:69
  logic [20:0] select_34;
  assign select_34 = and_29 ? determinants_q : (determinants_q + {{2{difference_32[18]}}, difference_32});
  // hls/stages/coarse.hpp:66
  logic [17:0] product_37;
  assign product_37 = $signed({{9{g_2[8]}}, g_2}) * $signed({{9{h_2[8]}}, h_2});
  // hls/stages/coarse.hpp:69
  logic [20:0] select_39;
  assign select_39 = and_29 ? products_q : (products_q + {{3{product_37[17]}}, product_37});
  // hls/stages/coarse.hpp:59
  logic [7:0] xor_42;
  assign xor_42 = g_2[7:0] ^ {8{g_2[8]}};
  logic [8:0] sum_43;
  assign sum_43 = {8'h0, g_2[8]} + {1'b0, xor_42};
  // hls/stages/coarse.hpp:69
  logic [11:0] select_45;
  assign select_45 = and_29 ? texture_q : (texture_q + {3'h0, sum_43});
  // hls/stages/coarse.hpp:71
  logic and_51;
  assign and_51 = equal_27 & (~((start_i ? texture_q[11:6] : select_45[11:6]) == 6'h0));
  // hls/stages/coarse.hpp:75
  logic [11:0] select_53;
  assign select_53 = first_i ? {4'h0, cfg_one_camera_segments_i} : (segments_missing_q + {12{and_51}});
  // hls/stages/coarse.hpp:69
  logic [20:0] determinants;
  assign determinants = start_i ? determinants_q : select_34;
  logic [20:0] select_55;
  assign select_55 = start_i ? products_q : select_39;
  // hls/stages/coarse.hpp:72
  logic [21:0] sum_56;
  assign sum_56 = {select_55[20], select_55} + {{2{select_55[20]}}, select_55[20:1]};
  // hls/stages/coarse.hpp:73
  logic less_57;
  assign less_57 = $signed({determinants, 5'h0}) < $signed({{3{sum_56[21]}}, sum_56, select_55[0]});
  logic [21:0] sum_58;
  assign sum_58 = {determinants[20], determinants} + {{4{sum_56[21]}}, sum_56[21:4]};
  logic less_59;
  assign less_59 = $signed({sum_58, sum_56[3:0], select_55[0]}) < $signed(27'h1);
  logic not_60;
  assign not_60 = ~less_59;
  // hls/stages/coarse.hpp:76
  logic [1:0] select_62;
  assign select_62 = and_51 ? (less_57 ? {less_59, not_60} : 2'h2) : 2'h0;
  logic [12:0] select_64;
  assign select_64 = first_i ? 13'h0 : (score_q + {{11{select_62[1]}}, 1'b0, select_62[0]});
  // hls/stages/coarse.hpp:103
  logic not_67;
  assign not_67 = ~(start_i | (sum_43 < {1'b0, cfg_blind_step_i}));
  logic [9:0] difference_68;
  assign difference_68 = {1'b0, not_67, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:104
  logic [21:0] sum_70;
  assign sum_70 = {{12{difference_68[9]}}, difference_68} + (first_i ? 22'h0 : left_steps_balance_q);
  // hls/stages/coarse.hpp:60
  logic [7:0] xor_71;
  assign xor_71 = h_2[7:0] ^ {8{h_2[8]}};
  logic or_74;
  assign or_74 = start_i | (({8'h0, h_2[8]} + {1'b0, xor_71}) < {1'b0, cfg_blind_step_i});
  // hls/stages/coarse.hpp:103
  logic not_75;
  assign not_75 = ~or_74;
  logic [9:0] difference_76;
  assign difference_76 = {1'b0, not_75, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:104
  logic [21:0] sum_78;
  assign sum_78 = {{12{difference_76[9]}}, difference_76} + (first_i ? 22'h0 : right_steps_balance_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q <= 8'h0;
      right_q <= 8'h0;
      g_q <= 9'h0;
      h_q <= 9'h0;
      column_q <= 3'h0;
      second_q <= 1'b0;
      determinants_q <= 21'h0;
      products_q <= 21'h0;
      texture_q <= 12'h0;
      segments_missing_q <= 12'h0;
      score_q <= 13'h0;
      left_steps_balance_q <= 22'h0;
      right_steps_balance_q <= 22'h0;
    end else if (s0_en) begin
      left_q <= left_i;
      right_q <= right_i;
      g_q <= g_2;
      h_q <= h_2;
      column_q <= select_25 + 3'h1;
      second_q <= start_i;
      determinants_q <= equal_27 ? 21'h0 : (start_i ? 21'h0 : select_34);
      products_q <= equal_27 ? 21'h0 : (start_i ? 21'h0 : select_39);
      texture_q <= equal_27 ? 12'h0 : (start_i ? 12'h0 : select_45);
      segments_missing_q <= select_53;
      score_q <= select_64;
      left_steps_balance_q <= sum_70;
      right_steps_balance_q <= sum_78;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/coarse.hpp:92
  logic and_82;
  assign and_82 = (~(cfg_one_camera_segments_i == 8'h0)) & ($signed(segments_missing_q) < $signed(12'h1));

  logic sum_70_s2_q;
  logic sum_78_s2_q;
  logic and_84_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      sum_70_s2_q <= left_steps_balance_q[21];
      sum_78_s2_q <= right_steps_balance_q[21];
      and_84_s2_q <= and_82 & (~score_q[12]);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign one_camera_o = and_84_s2_q;
  assign left_blind_o = sum_70_s2_q;
  assign right_blind_o = sum_78_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
    end
  end

endmodule
