// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Coarse<horopter::hls::profiles::hd>, hls/stages/coarse.hpp. Do not edit.
//
// Latency 7 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 161 bits, pipeline 236 bits, memories 0 bits.
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

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_q;
  logic [7:0] right_q;
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q <= 8'h0;
      right_q <= 8'h0;
    end else if (s0_en) begin
      left_q <= left_i;
      right_q <= right_i;
    end
  end

  logic first_s1_q;
  logic start_s1_q;
  logic [8:0] g_2_s1_q;
  logic [8:0] h_2_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      first_s1_q <= first_i;
      start_s1_q <= start_i;
      g_2_s1_q <= g_2;
      h_2_s1_q <= h_2;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [8:0] g_q;
  logic [8:0] h_q;
  // hls/stages/coarse.hpp:65
  logic [17:0] product_30;
  assign product_30 = $signed({{9{g_q[8]}}, g_q}) * $signed({{9{h_2_s1_q[8]}}, h_2_s1_q});
  logic [17:0] product_31;
  assign product_31 = $signed({{9{h_q[8]}}, h_q}) * $signed({{9{g_2_s1_q[8]}}, g_2_s1_q});
  // hls/stages/coarse.hpp:66
  logic [17:0] product_37;
  assign product_37 = $signed({{9{g_2_s1_q[8]}}, g_2_s1_q}) * $signed({{9{h_2_s1_q[8]}}, h_2_s1_q});

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      g_q <= 9'h0;
      h_q <= 9'h0;
    end else if (s1_en) begin
      g_q <= g_2_s1_q;
      h_q <= h_2_s1_q;
    end
  end

  logic first_s2_q;
  logic start_s2_q;
  logic [17:0] product_30_s2_q;
  logic [17:0] product_31_s2_q;
  logic [17:0] product_37_s2_q;
  logic [7:0] xor_71_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      first_s2_q <= first_s1_q;
      start_s2_q <= start_s1_q;
      product_30_s2_q <= product_30;
      product_31_s2_q <= product_31;
      product_37_s2_q <= product_37;
      xor_71_s2_q <= h_2_s1_q[7:0] ^ {8{h_2_s1_q[8]}};
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [2:0] column_q;
  logic second_q;
  logic [20:0] products_q;
  // hls/stages/coarse.hpp:57
  logic [2:0] select_25;
  assign select_25 = start_s2_q ? 3'h0 : column_q;
  // hls/stages/coarse.hpp:69
  logic equal_27;
  assign equal_27 = select_25 == 3'h7;
  // hls/stages/coarse.hpp:57
  logic and_29;
  assign and_29 = second_q & (~start_s2_q);
  // hls/stages/coarse.hpp:65
  logic [18:0] difference_32;
  assign difference_32 = {product_30_s2_q[17], product_30_s2_q} - {product_31_s2_q[17], product_31_s2_q};
  // hls/stages/coarse.hpp:69
  logic [20:0] select_39;
  assign select_39 = and_29 ? products_q : (products_q + {{3{product_37_s2_q[17]}}, product_37_s2_q});
  // hls/stages/coarse.hpp:59
  logic [7:0] xor_42;
  assign xor_42 = g_q[7:0] ^ {8{g_q[8]}};
  // hls/stages/coarse.hpp:60
  logic less_73;
  assign less_73 = ({8'h0, h_q[8]} + {1'b0, xor_71_s2_q}) < {1'b0, cfg_blind_step_i};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      column_q <= 3'h0;
      second_q <= 1'b0;
      products_q <= 21'h0;
    end else if (s2_en) begin
      column_q <= select_25 + 3'h1;
      second_q <= start_s2_q;
      products_q <= equal_27 ? 21'h0 : (start_s2_q ? 21'h0 : select_39);
    end
  end

  logic first_s3_q;
  logic equal_27_s3_q;
  logic and_29_s3_q;
  logic [18:0] difference_32_s3_q;
  logic [8:0] sum_43_s3_q;
  logic [20:0] select_55_s3_q;
  logic less_73_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      first_s3_q <= first_s2_q;
      equal_27_s3_q <= equal_27;
      and_29_s3_q <= and_29;
      difference_32_s3_q <= difference_32;
      sum_43_s3_q <= {8'h0, g_q[8]} + {1'b0, xor_42};
      select_55_s3_q <= start_s2_q ? products_q : select_39;
      less_73_s3_q <= less_73;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [20:0] determinants_q;
  logic [11:0] texture_q;
  // hls/stages/coarse.hpp:65
  logic [20:0] sum_33;
  assign sum_33 = determinants_q + {{2{difference_32_s3_q[18]}}, difference_32_s3_q};
  // hls/stages/coarse.hpp:69
  logic [20:0] select_34;
  assign select_34 = and_29_s3_q ? determinants_q : sum_33;
  logic [11:0] select_45;
  assign select_45 = and_29_s3_q ? texture_q : (texture_q + {3'h0, sum_43_s3_q});
  logic [20:0] determinants;
  assign determinants = second_q ? determinants_q : select_34;
  // hls/stages/coarse.hpp:72
  logic [21:0] sum_56;
  assign sum_56 = {select_55_s3_q[20], select_55_s3_q} + {{2{select_55_s3_q[20]}}, select_55_s3_q[20:1]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      determinants_q <= 21'h0;
      texture_q <= 12'h0;
    end else if (s3_en) begin
      determinants_q <= equal_27_s3_q ? 21'h0 : (second_q ? 21'h0 : select_34);
      texture_q <= equal_27_s3_q ? 12'h0 : (second_q ? 12'h0 : select_45);
    end
  end

  logic first_s4_q;
  logic equal_27_s4_q;
  logic [5:0] select_48_s4_q;
  logic [20:0] determinants_s4_q;
  logic select_55_s4_q;
  logic [21:0] sum_56_s4_q;
  logic not_67_s4_q;
  logic not_75_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      first_s4_q <= first_s3_q;
      equal_27_s4_q <= equal_27_s3_q;
      select_48_s4_q <= second_q ? texture_q[11:6] : select_45[11:6];
      determinants_s4_q <= determinants;
      select_55_s4_q <= select_55_s3_q[0];
      sum_56_s4_q <= sum_56;
      not_67_s4_q <= ~(second_q | (sum_43_s3_q < {1'b0, cfg_blind_step_i}));
      not_75_s4_q <= ~(second_q | less_73_s3_q);
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [21:0] left_steps_balance_q;
  logic [21:0] right_steps_balance_q;
  // hls/stages/coarse.hpp:73
  logic less_57;
  assign less_57 = $signed({determinants_s4_q, 5'h0}) < $signed({{3{sum_56_s4_q[21]}}, sum_56_s4_q, select_55_s4_q});
  logic [21:0] sum_58;
  assign sum_58 = {determinants_s4_q[20], determinants_s4_q} + {{4{sum_56_s4_q[21]}}, sum_56_s4_q[21:4]};
  // hls/stages/coarse.hpp:103
  logic [9:0] difference_68;
  assign difference_68 = {1'b0, not_67_s4_q, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:104
  logic [21:0] sum_70;
  assign sum_70 = {{12{difference_68[9]}}, difference_68} + (first_s4_q ? 22'h0 : left_steps_balance_q);
  // hls/stages/coarse.hpp:103
  logic [9:0] difference_76;
  assign difference_76 = {1'b0, not_75_s4_q, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:104
  logic [21:0] sum_78;
  assign sum_78 = {{12{difference_76[9]}}, difference_76} + (first_s4_q ? 22'h0 : right_steps_balance_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_steps_balance_q <= 22'h0;
      right_steps_balance_q <= 22'h0;
    end else if (s4_en) begin
      left_steps_balance_q <= sum_70;
      right_steps_balance_q <= sum_78;
    end
  end

  logic first_s5_q;
  logic and_51_s5_q;
  logic select_55_s5_q;
  logic [3:0] sum_56_s5_q;
  logic less_57_s5_q;
  logic [21:0] sum_58_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      first_s5_q <= first_s4_q;
      and_51_s5_q <= equal_27_s4_q & (~(select_48_s4_q == 6'h0));
      select_55_s5_q <= select_55_s4_q;
      sum_56_s5_q <= sum_56_s4_q[3:0];
      less_57_s5_q <= less_57;
      sum_58_s5_q <= sum_58;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [11:0] segments_missing_q;
  // hls/stages/coarse.hpp:75
  logic [11:0] select_53;
  assign select_53 = first_s5_q ? {4'h0, cfg_one_camera_segments_i} : (segments_missing_q + {12{and_51_s5_q}});
  // hls/stages/coarse.hpp:73
  logic less_59;
  assign less_59 = $signed({sum_58_s5_q, sum_56_s5_q, select_55_s5_q}) < $signed(27'h1);
  logic not_60;
  assign not_60 = ~less_59;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      segments_missing_q <= 12'h0;
    end else if (s5_en) begin
      segments_missing_q <= select_53;
    end
  end

  logic first_s6_q;
  logic [1:0] select_62_s6_q;
  logic sum_70_s6_q;
  logic sum_78_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      first_s6_q <= first_s5_q;
      select_62_s6_q <= and_51_s5_q ? (less_57_s5_q ? {less_59, not_60} : 2'h2) : 2'h0;
      sum_70_s6_q <= left_steps_balance_q[21];
      sum_78_s6_q <= right_steps_balance_q[21];
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [12:0] score_q;
  // hls/stages/coarse.hpp:76
  logic [12:0] select_64;
  assign select_64 = first_s6_q ? 13'h0 : (score_q + {{11{select_62_s6_q[1]}}, 1'b0, select_62_s6_q[0]});
  // hls/stages/coarse.hpp:92
  logic and_82;
  assign and_82 = (~(cfg_one_camera_segments_i == 8'h0)) & ($signed(segments_missing_q) < $signed(12'h1));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      score_q <= 13'h0;
    end else if (s6_en) begin
      score_q <= select_64;
    end
  end

  logic sum_70_s7_q;
  logic sum_78_s7_q;
  logic and_84_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      sum_70_s7_q <= sum_70_s6_q;
      sum_78_s7_q <= sum_78_s6_q;
      and_84_s7_q <= and_82 & (~select_64[12]);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign one_camera_o = and_84_s7_q;
  assign left_blind_o = sum_70_s7_q;
  assign right_blind_o = sum_78_s7_q;
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
      valid_s7_q <= valid_s6_q;
    end
  end

endmodule
