// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Coarse<horopter::hls::profiles::hd>, hls/stages/coarse.hpp. Do not edit.
//
// Latency 7 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 293 bits, pipeline 262 bits, memories 0 bits.
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
  logic s0_en, s2_en, s3_en, s5_en, s6_en;
  assign s0_en = en_i & valid_i;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;

  // Of the configuration alone: not pipelined.
  logic [8:0] sum_34;
  assign sum_34 = {1'b0, cfg_blind_step_i} + {2'h0, cfg_blind_step_i[7:1]};
  logic equal_159;
  assign equal_159 = cfg_blind_share_i == 8'h0;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_q;
  logic [7:0] right_q;
  logic [8:0] g_q;
  logic [8:0] h_q;
  logic [6:0] places_column_q;
  // hls/stages/coarse.hpp:60
  logic [8:0] g;
  assign g = {1'b0, left_i} - {1'b0, left_q};
  logic [8:0] g_2;
  assign g_2 = start_i ? 9'h0 : g;
  // hls/stages/coarse.hpp:61
  logic [8:0] h;
  assign h = {1'b0, right_i} - {1'b0, right_q};
  logic [8:0] h_2;
  assign h_2 = start_i ? 9'h0 : h;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q <= 8'h0;
      right_q <= 8'h0;
      g_q <= 9'h0;
      h_q <= 9'h0;
      places_column_q <= 7'h0;
    end else if (s0_en) begin
      left_q <= left_i;
      right_q <= right_i;
      g_q <= g_2;
      h_q <= h_2;
      places_column_q <= start_i ? 7'h0 : (places_column_q + 7'h1);
    end
  end

  logic first_s1_q;
  logic start_s1_q;
  logic [8:0] g_s1_q;
  logic [8:0] h_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s1_q <= first_i;
      start_s1_q <= start_i;
      g_s1_q <= g_q;
      h_s1_q <= h_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/coarse.hpp:72
  logic [17:0] product_44;
  assign product_44 = $signed({{9{g_s1_q[8]}}, g_s1_q}) * $signed({{9{h_q[8]}}, h_q});
  logic [17:0] product_45;
  assign product_45 = $signed({{9{h_s1_q[8]}}, h_s1_q}) * $signed({{9{g_q[8]}}, g_q});
  // hls/stages/coarse.hpp:73
  logic [17:0] product_51;
  assign product_51 = $signed({{9{g_q[8]}}, g_q}) * $signed({{9{h_q[8]}}, h_q});
  // hls/stages/coarse.hpp:62
  logic [7:0] xor_56;
  assign xor_56 = g_q[7:0] ^ {8{g_q[8]}};
  // hls/stages/coarse.hpp:63
  logic [7:0] xor_85;
  assign xor_85 = h_q[7:0] ^ {8{h_q[8]}};
  // hls/stages/coarse.hpp:150
  logic not_111;
  assign not_111 = ~places_column_q[6];
  logic [3:0] select_112;
  assign select_112 = places_column_q[5] ? {places_column_q[6], 1'b0, not_111, 1'b0} : {1'b0, places_column_q[6], 1'b0, not_111};
  logic [7:0] select_113;
  assign select_113 = places_column_q[4] ? {select_112[3], 1'b0, select_112[2], 1'b0, select_112[1], 1'b0, select_112[0], 1'b0} : {1'b0, select_112[3], 1'b0, select_112[2], 1'b0, select_112[1], 1'b0, select_112[0]};
  logic [15:0] select_114;
  assign select_114 = places_column_q[3] ? {select_113[7], 1'b0, select_113[6], 1'b0, select_113[5], 1'b0, select_113[4], 1'b0, select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0], 1'b0} : {1'b0, select_113[7], 1'b0, select_113[6], 1'b0, select_113[5], 1'b0, select_113[4], 1'b0, select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0]};

  logic first_s2_q;
  logic start_s2_q;
  logic [17:0] product_44_s2_q;
  logic [17:0] product_45_s2_q;
  logic [17:0] product_51_s2_q;
  logic [8:0] sum_57_s2_q;
  logic [8:0] sum_86_s2_q;
  logic select_94_s2_q;
  logic equal_95_s2_q;
  logic [15:0] select_114_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s2_q <= first_s1_q;
      start_s2_q <= start_s1_q;
      product_44_s2_q <= product_44;
      product_45_s2_q <= product_45;
      product_51_s2_q <= product_51;
      sum_57_s2_q <= {8'h0, g_q[8]} + {1'b0, xor_56};
      sum_86_s2_q <= {8'h0, h_q[8]} + {1'b0, xor_85};
      select_94_s2_q <= places_column_q[2];
      equal_95_s2_q <= places_column_q[1:0] == 2'h0;
      select_114_s2_q <= select_114;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [6:0] small_step_q;
  logic [2:0] column_q;
  logic second_q;
  logic [20:0] products_q;
  logic [11:0] texture_q;
  logic places_first_row_q;
  logic [31:0] left_parts_strips_q;
  logic [31:0] right_parts_strips_q;
  // hls/stages/coarse.hpp:60
  logic [2:0] select_39;
  assign select_39 = start_s2_q ? 3'h0 : column_q;
  // hls/stages/coarse.hpp:76
  logic equal_41;
  assign equal_41 = select_39 == 3'h7;
  // hls/stages/coarse.hpp:60
  logic not_42;
  assign not_42 = ~start_s2_q;
  logic and_43;
  assign and_43 = second_q & not_42;
  // hls/stages/coarse.hpp:72
  logic [18:0] difference_46;
  assign difference_46 = {product_44_s2_q[17], product_44_s2_q} - {product_45_s2_q[17], product_45_s2_q};
  // hls/stages/coarse.hpp:76
  logic [20:0] select_53;
  assign select_53 = and_43 ? products_q : (products_q + {{3{product_51_s2_q[17]}}, product_51_s2_q});
  logic [11:0] select_59;
  assign select_59 = and_43 ? texture_q : (texture_q + {3'h0, sum_57_s2_q});
  // hls/stages/coarse.hpp:137
  logic and_96;
  assign and_96 = places_first_row_q & not_42;
  // hls/stages/coarse.hpp:64
  logic one_more;
  assign one_more = first_s2_q ? equal_95_s2_q : (and_96 & equal_95_s2_q);
  // hls/stages/coarse.hpp:138
  logic or_105;
  assign or_105 = first_s2_q | and_96;
  // hls/stages/coarse.hpp:143
  logic or_109;
  assign or_109 = start_s2_q | (sum_57_s2_q < {2'h0, small_step_q});
  // hls/stages/coarse.hpp:151
  logic [31:0] seen;
  assign seen = first_s2_q ? 32'h0 : left_parts_strips_q;
  // hls/stages/coarse.hpp:150
  logic [31:0] here;
  assign here = select_94_s2_q ? {select_114_s2_q[15], 1'b0, select_114_s2_q[14], 1'b0, select_114_s2_q[13], 1'b0, select_114_s2_q[12], 1'b0, select_114_s2_q[11], 1'b0, select_114_s2_q[10], 1'b0, select_114_s2_q[9], 1'b0, select_114_s2_q[8], 1'b0, select_114_s2_q[7], 1'b0, select_114_s2_q[6], 1'b0, select_114_s2_q[5], 1'b0, select_114_s2_q[4], 1'b0, select_114_s2_q[3], 1'b0, select_114_s2_q[2], 1'b0, select_114_s2_q[1], 1'b0, select_114_s2_q[0], 1'b0} : {1'b0, select_114_s2_q[15], 1'b0, select_114_s2_q[14], 1'b0, select_114_s2_q[13], 1'b0, select_114_s2_q[12], 1'b0, select_114_s2_q[11], 1'b0, select_114_s2_q[10], 1'b0, select_114_s2_q[9], 1'b0, select_114_s2_q[8], 1'b0, select_114_s2_q[7], 1'b0, select_114_s2_q[6], 1'b0, select_114_s2_q[5], 1'b0, select_114_s2_q[4], 1'b0, select_114_s2_q[3], 1'b0, select_114_s2_q[2], 1'b0, select_114_s2_q[1], 1'b0, select_114_s2_q[0]};
  // hls/stages/coarse.hpp:151
  logic or_134;
  assign or_134 = start_s2_q | (sum_86_s2_q < {2'h0, small_step_q});
  logic [31:0] seen_2;
  assign seen_2 = first_s2_q ? 32'h0 : right_parts_strips_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      small_step_q <= 7'h0;
      column_q <= 3'h0;
      second_q <= 1'b0;
      products_q <= 21'h0;
      texture_q <= 12'h0;
      places_first_row_q <= 1'b0;
      left_parts_strips_q <= 32'h0;
      right_parts_strips_q <= 32'h0;
    end else if (s2_en) begin
      small_step_q <= sum_34[8:2];
      column_q <= select_39 + 3'h1;
      second_q <= start_s2_q;
      products_q <= equal_41 ? 21'h0 : (start_s2_q ? 21'h0 : select_53);
      texture_q <= equal_41 ? 12'h0 : (start_s2_q ? 12'h0 : select_59);
      places_first_row_q <= first_s2_q ? or_105 : (and_96 & or_105);
      left_parts_strips_q <= or_109 ? seen : (here | seen);
      right_parts_strips_q <= or_134 ? seen_2 : (here | seen_2);
    end
  end

  logic first_s3_q;
  logic equal_41_s3_q;
  logic not_42_s3_q;
  logic and_43_s3_q;
  logic [18:0] difference_46_s3_q;
  logic [5:0] select_62_s3_q;
  logic [20:0] select_69_s3_q;
  logic not_81_s3_q;
  logic not_89_s3_q;
  logic one_more_s3_q;
  logic or_109_s3_q;
  logic equal_124_s3_q;
  logic or_134_s3_q;
  logic equal_144_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s3_q <= first_s2_q;
      equal_41_s3_q <= equal_41;
      not_42_s3_q <= not_42;
      and_43_s3_q <= and_43;
      difference_46_s3_q <= difference_46;
      select_62_s3_q <= start_s2_q ? texture_q[11:6] : select_59[11:6];
      select_69_s3_q <= start_s2_q ? products_q : select_53;
      not_81_s3_q <= ~(start_s2_q | (sum_57_s2_q < {1'b0, cfg_blind_step_i}));
      not_89_s3_q <= ~(start_s2_q | (sum_86_s2_q < {1'b0, cfg_blind_step_i}));
      one_more_s3_q <= one_more;
      or_109_s3_q <= or_109;
      equal_124_s3_q <= (here & seen) == 32'h0;
      or_134_s3_q <= or_134;
      equal_144_s3_q <= (here & seen_2) == 32'h0;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [20:0] determinants_q;
  logic [21:0] left_steps_balance_q;
  logic [21:0] right_steps_balance_q;
  logic [5:0] places_strips_q;
  logic [4:0] places_rows_q;
  logic left_parts_row_seen_q;
  logic [9:0] left_parts_blind_strips_q;
  logic [9:0] left_parts_blind_rows_q;
  logic right_parts_row_seen_q;
  logic [9:0] right_parts_blind_strips_q;
  logic [9:0] right_parts_blind_rows_q;
  // hls/stages/coarse.hpp:72
  logic [20:0] sum_47;
  assign sum_47 = determinants_q + {{2{difference_46_s3_q[18]}}, difference_46_s3_q};
  // hls/stages/coarse.hpp:76
  logic [20:0] select_48;
  assign select_48 = and_43_s3_q ? determinants_q : sum_47;
  logic [20:0] determinants;
  assign determinants = second_q ? determinants_q : select_48;
  // hls/stages/coarse.hpp:79
  logic [21:0] sum_70;
  assign sum_70 = {select_69_s3_q[20], select_69_s3_q} + {{2{select_69_s3_q[20]}}, select_69_s3_q[20:1]};
  // hls/stages/coarse.hpp:111
  logic [9:0] difference_82;
  assign difference_82 = {1'b0, not_81_s3_q, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:112
  logic [21:0] sum_84;
  assign sum_84 = {{12{difference_82[9]}}, difference_82} + (first_s3_q ? 22'h0 : left_steps_balance_q);
  // hls/stages/coarse.hpp:111
  logic [9:0] difference_90;
  assign difference_90 = {1'b0, not_89_s3_q, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:112
  logic [21:0] sum_92;
  assign sum_92 = {{12{difference_90[9]}}, difference_90} + (first_s3_q ? 22'h0 : right_steps_balance_q);
  // hls/stages/coarse.hpp:140
  logic [4:0] rows_before;
  assign rows_before = first_s3_q ? 5'h0 : places_rows_q;
  // hls/stages/coarse.hpp:141
  logic and_103;
  assign and_103 = second_q & (~rows_before[4]);
  // hls/stages/coarse.hpp:152
  logic not_118;
  assign not_118 = ~or_109_s3_q;
  // hls/stages/coarse.hpp:168
  logic [9:0] sum_122;
  assign sum_122 = {8'h0, {2{one_more_s3_q}}} + (first_s3_q ? 10'h0 : left_parts_blind_strips_q);
  // hls/stages/coarse.hpp:65
  logic and_125;
  assign and_125 = not_118 & equal_124_s3_q;
  // hls/stages/coarse.hpp:168
  logic [7:0] sum_126;
  assign sum_126 = {8{and_125}} + sum_122[9:2];
  logic [9:0] sum_128;
  assign sum_128 = {8'h0, {2{second_q}}} + (first_s3_q ? 10'h0 : left_parts_blind_rows_q);
  logic not_131;
  assign not_131 = ~((second_q | or_109_s3_q) ? or_109_s3_q : left_parts_row_seen_q);
  logic [7:0] sum_132;
  assign sum_132 = sum_128[9:2] + {8{not_131}};
  // hls/stages/coarse.hpp:152
  logic not_138;
  assign not_138 = ~or_134_s3_q;
  // hls/stages/coarse.hpp:168
  logic [9:0] sum_142;
  assign sum_142 = {8'h0, {2{one_more_s3_q}}} + (first_s3_q ? 10'h0 : right_parts_blind_strips_q);
  // hls/stages/coarse.hpp:152
  logic and_145;
  assign and_145 = equal_144_s3_q & not_138;
  // hls/stages/coarse.hpp:168
  logic [7:0] sum_146;
  assign sum_146 = {8{and_145}} + sum_142[9:2];
  logic [9:0] sum_148;
  assign sum_148 = {8'h0, {2{second_q}}} + (first_s3_q ? 10'h0 : right_parts_blind_rows_q);
  logic not_151;
  assign not_151 = ~((second_q | or_134_s3_q) ? or_134_s3_q : right_parts_row_seen_q);
  logic [7:0] sum_152;
  assign sum_152 = sum_148[9:2] + {8{not_151}};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      determinants_q <= 21'h0;
      left_steps_balance_q <= 22'h0;
      right_steps_balance_q <= 22'h0;
      places_strips_q <= 6'h0;
      places_rows_q <= 5'h0;
      left_parts_row_seen_q <= 1'b0;
      left_parts_blind_strips_q <= 10'h0;
      left_parts_blind_rows_q <= 10'h0;
      right_parts_row_seen_q <= 1'b0;
      right_parts_blind_strips_q <= 10'h0;
      right_parts_blind_rows_q <= 10'h0;
    end else if (s3_en) begin
      determinants_q <= equal_41_s3_q ? 21'h0 : (second_q ? 21'h0 : select_48);
      left_steps_balance_q <= sum_84;
      right_steps_balance_q <= sum_92;
      places_strips_q <= {5'h0, one_more_s3_q} + (first_s3_q ? 6'h0 : places_strips_q);
      places_rows_q <= rows_before + {4'h0, and_103};
      left_parts_row_seen_q <= not_118 | (left_parts_row_seen_q & not_42_s3_q);
      left_parts_blind_strips_q <= {sum_126, sum_122[1:0]};
      left_parts_blind_rows_q <= {sum_132, sum_128[1:0]};
      right_parts_row_seen_q <= not_138 | (right_parts_row_seen_q & not_42_s3_q);
      right_parts_blind_strips_q <= {sum_146, sum_142[1:0]};
      right_parts_blind_rows_q <= {sum_152, sum_148[1:0]};
    end
  end

  logic first_s4_q;
  logic and_65_s4_q;
  logic [20:0] determinants_s4_q;
  logic select_69_s4_q;
  logic [21:0] sum_70_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s4_q <= first_s3_q;
      and_65_s4_q <= equal_41_s3_q & (~(select_62_s3_q == 6'h0));
      determinants_s4_q <= determinants;
      select_69_s4_q <= select_69_s3_q[0];
      sum_70_s4_q <= sum_70;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/coarse.hpp:80
  logic less_71;
  assign less_71 = $signed({determinants_s4_q, 5'h0}) < $signed({{3{sum_70_s4_q[21]}}, sum_70_s4_q, select_69_s4_q});
  logic [21:0] sum_72;
  assign sum_72 = {determinants_s4_q[20], determinants_s4_q} + {{4{sum_70_s4_q[21]}}, sum_70_s4_q[21:4]};
  // hls/stages/coarse.hpp:160
  logic equal_163;
  assign equal_163 = places_strips_q[5:3] == 3'h0;
  // hls/stages/coarse.hpp:114
  logic or_166;
  assign or_166 = (places_rows_q[4] & (~left_parts_blind_rows_q[9])) | (~(left_parts_blind_strips_q[9] | equal_163));
  logic select_167;
  assign select_167 = (left_steps_balance_q[21] | equal_159) ? left_steps_balance_q[21] : or_166;
  // hls/stages/coarse.hpp:99
  logic or_173;
  assign or_173 = (places_rows_q[4] & (~right_parts_blind_rows_q[9])) | (~(right_parts_blind_strips_q[9] | equal_163));
  logic select_174;
  assign select_174 = (right_steps_balance_q[21] | equal_159) ? right_steps_balance_q[21] : or_173;

  logic first_s5_q;
  logic and_65_s5_q;
  logic select_69_s5_q;
  logic [3:0] sum_70_s5_q;
  logic less_71_s5_q;
  logic [21:0] sum_72_s5_q;
  logic select_167_s5_q;
  logic select_174_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s5_q <= first_s4_q;
      and_65_s5_q <= and_65_s4_q;
      select_69_s5_q <= select_69_s4_q;
      sum_70_s5_q <= sum_70_s4_q[3:0];
      less_71_s5_q <= less_71;
      sum_72_s5_q <= sum_72;
      select_167_s5_q <= select_167;
      select_174_s5_q <= select_174;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [11:0] segments_missing_q;
  // hls/stages/coarse.hpp:82
  logic [11:0] select_67;
  assign select_67 = first_s5_q ? {4'h0, cfg_one_camera_segments_i} : (segments_missing_q + {12{and_65_s5_q}});
  // hls/stages/coarse.hpp:80
  logic less_73;
  assign less_73 = $signed({sum_72_s5_q, sum_70_s5_q, select_69_s5_q}) < $signed(27'h1);
  logic not_74;
  assign not_74 = ~less_73;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      segments_missing_q <= 12'h0;
    end else if (s5_en) begin
      segments_missing_q <= select_67;
    end
  end

  logic first_s6_q;
  logic [1:0] select_76_s6_q;
  logic select_167_s6_q;
  logic select_174_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s6_q <= first_s5_q;
      select_76_s6_q <= and_65_s5_q ? (less_71_s5_q ? {less_73, not_74} : 2'h2) : 2'h0;
      select_167_s6_q <= select_167_s5_q;
      select_174_s6_q <= select_174_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [12:0] score_q;
  // hls/stages/coarse.hpp:83
  logic [12:0] select_78;
  assign select_78 = first_s6_q ? 13'h0 : (score_q + {{11{select_76_s6_q[1]}}, 1'b0, select_76_s6_q[0]});
  // hls/stages/coarse.hpp:99
  logic and_156;
  assign and_156 = (~(cfg_one_camera_segments_i == 8'h0)) & ($signed(segments_missing_q) < $signed(12'h1));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      score_q <= 13'h0;
    end else if (s6_en) begin
      score_q <= select_78;
    end
  end

  logic and_158_s7_q;
  logic select_167_s7_q;
  logic select_174_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      and_158_s7_q <= and_156 & (~select_78[12]);
      select_167_s7_q <= select_167_s6_q;
      select_174_s7_q <= select_174_s6_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign one_camera_o = and_158_s7_q;
  assign left_blind_o = select_167_s7_q;
  assign right_blind_o = select_174_s7_q;
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

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^sum_34[1:0];

endmodule
