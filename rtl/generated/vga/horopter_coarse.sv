// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Coarse<horopter::hls::profiles::vga>, hls/stages/coarse.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 293 bits, pipeline 5 bits, memories 0 bits.
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
  logic [8:0] sum_34;
  assign sum_34 = {1'b0, cfg_blind_step_i} + {2'h0, cfg_blind_step_i[7:1]};
  logic equal_159;
  assign equal_159 = cfg_blind_share_i == 8'h0;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_q;
  logic [7:0] right_q;
  logic [6:0] small_step_q;
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
  logic [6:0] places_column_q;
  logic [5:0] places_strips_q;
  logic [4:0] places_rows_q;
  logic places_first_row_q;
  logic [31:0] left_parts_strips_q;
  logic left_parts_row_seen_q;
  logic [9:0] left_parts_blind_strips_q;
  logic [9:0] left_parts_blind_rows_q;
  logic [31:0] right_parts_strips_q;
  logic right_parts_row_seen_q;
  logic [9:0] right_parts_blind_strips_q;
  logic [9:0] right_parts_blind_rows_q;
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
  // hls/stages/coarse.hpp:60
  logic [2:0] select_39;
  assign select_39 = start_i ? 3'h0 : column_q;
  // hls/stages/coarse.hpp:76
  logic equal_41;
  assign equal_41 = select_39 == 3'h7;
  // hls/stages/coarse.hpp:60
  logic not_42;
  assign not_42 = ~start_i;
  logic and_43;
  assign and_43 = second_q & not_42;
  // hls/stages/coarse.hpp:72
  logic [17:0] product_44;
  assign product_44 = $signed({{9{g_q[8]}}, g_q}) * $signed({{9{h_2[8]}}, h_2});
  logic [17:0] product_45;
  assign product_45 = $signed({{9{h_q[8]}}, h_q}) * $signed({{9{g_2[8]}}, g_2});
  logic [18:0] difference_46;
  assign difference_46 = {product_44[17], product_44} - {product_45[17], product_45};
  // hls/stages/coarse.hpp:76
  logic [20:0] select_48;
  assign select_48 = and_43 ? determinants_q : (determinants_q + {{2{difference_46[18]}}, difference_46});
  // hls/stages/coarse.hpp:73
  logic [17:0] product_51;
  assign product_51 = $signed({{9{g_2[8]}}, g_2}) * $signed({{9{h_2[8]}}, h_2});
  // hls/stages/coarse.hpp:76
  logic [20:0] select_53;
  assign select_53 = and_43 ? products_q : (products_q + {{3{product_51[17]}}, product_51});
  // hls/stages/coarse.hpp:62
  logic [7:0] xor_56;
  assign xor_56 = g_2[7:0] ^ {8{g_2[8]}};
  logic [8:0] sum_57;
  assign sum_57 = {8'h0, g_2[8]} + {1'b0, xor_56};
  // hls/stages/coarse.hpp:76
  logic [11:0] select_59;
  assign select_59 = and_43 ? texture_q : (texture_q + {3'h0, sum_57});
  // hls/stages/coarse.hpp:78
  logic and_65;
  assign and_65 = equal_41 & (~((start_i ? texture_q[11:6] : select_59[11:6]) == 6'h0));
  // hls/stages/coarse.hpp:82
  logic [11:0] select_67;
  assign select_67 = first_i ? {4'h0, cfg_one_camera_segments_i} : (segments_missing_q + {12{and_65}});
  // hls/stages/coarse.hpp:76
  logic [20:0] determinants;
  assign determinants = start_i ? determinants_q : select_48;
  logic [20:0] select_69;
  assign select_69 = start_i ? products_q : select_53;
  // hls/stages/coarse.hpp:79
  logic [21:0] sum_70;
  assign sum_70 = {select_69[20], select_69} + {{2{select_69[20]}}, select_69[20:1]};
  // hls/stages/coarse.hpp:80
  logic less_71;
  assign less_71 = $signed({determinants, 5'h0}) < $signed({{3{sum_70[21]}}, sum_70, select_69[0]});
  logic [21:0] sum_72;
  assign sum_72 = {determinants[20], determinants} + {{4{sum_70[21]}}, sum_70[21:4]};
  logic less_73;
  assign less_73 = $signed({sum_72, sum_70[3:0], select_69[0]}) < $signed(27'h1);
  logic not_74;
  assign not_74 = ~less_73;
  // hls/stages/coarse.hpp:83
  logic [1:0] select_76;
  assign select_76 = and_65 ? (less_71 ? {less_73, not_74} : 2'h2) : 2'h0;
  logic [12:0] select_78;
  assign select_78 = first_i ? 13'h0 : (score_q + {{11{select_76[1]}}, 1'b0, select_76[0]});
  // hls/stages/coarse.hpp:111
  logic not_81;
  assign not_81 = ~(start_i | (sum_57 < {1'b0, cfg_blind_step_i}));
  logic [9:0] difference_82;
  assign difference_82 = {1'b0, not_81, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:112
  logic [21:0] sum_84;
  assign sum_84 = {{12{difference_82[9]}}, difference_82} + (first_i ? 22'h0 : left_steps_balance_q);
  // hls/stages/coarse.hpp:63
  logic [7:0] xor_85;
  assign xor_85 = h_2[7:0] ^ {8{h_2[8]}};
  logic [8:0] sum_86;
  assign sum_86 = {8'h0, h_2[8]} + {1'b0, xor_85};
  // hls/stages/coarse.hpp:111
  logic not_89;
  assign not_89 = ~(start_i | (sum_86 < {1'b0, cfg_blind_step_i}));
  logic [9:0] difference_90;
  assign difference_90 = {1'b0, not_89, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:112
  logic [21:0] sum_92;
  assign sum_92 = {{12{difference_90[9]}}, difference_90} + (first_i ? 22'h0 : right_steps_balance_q);
  // hls/stages/coarse.hpp:135
  logic [6:0] select_94;
  assign select_94 = start_i ? 7'h0 : (places_column_q + 7'h1);
  // hls/stages/coarse.hpp:138
  logic equal_95;
  assign equal_95 = select_94[1:0] == 2'h0;
  // hls/stages/coarse.hpp:137
  logic and_96;
  assign and_96 = places_first_row_q & not_42;
  // hls/stages/coarse.hpp:64
  logic one_more;
  assign one_more = first_i ? equal_95 : (and_96 & equal_95);
  // hls/stages/coarse.hpp:140
  logic [4:0] rows_before;
  assign rows_before = first_i ? 5'h0 : places_rows_q;
  // hls/stages/coarse.hpp:141
  logic and_103;
  assign and_103 = start_i & (~rows_before[4]);
  // hls/stages/coarse.hpp:138
  logic or_105;
  assign or_105 = first_i | and_96;
  // hls/stages/coarse.hpp:143
  logic or_109;
  assign or_109 = start_i | (sum_57 < {2'h0, small_step_q});
  // hls/stages/coarse.hpp:151
  logic [31:0] seen;
  assign seen = first_i ? 32'h0 : left_parts_strips_q;
  // hls/stages/coarse.hpp:150
  logic not_111;
  assign not_111 = ~select_94[6];
  logic [3:0] select_112;
  assign select_112 = select_94[5] ? {select_94[6], 1'b0, not_111, 1'b0} : {1'b0, select_94[6], 1'b0, not_111};
  logic [7:0] select_113;
  assign select_113 = select_94[4] ? {select_112[3], 1'b0, select_112[2], 1'b0, select_112[1], 1'b0, select_112[0], 1'b0} : {1'b0, select_112[3], 1'b0, select_112[2], 1'b0, select_112[1], 1'b0, select_112[0]};
  logic [15:0] select_114;
  assign select_114 = select_94[3] ? {select_113[7], 1'b0, select_113[6], 1'b0, select_113[5], 1'b0, select_113[4], 1'b0, select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0], 1'b0} : {1'b0, select_113[7], 1'b0, select_113[6], 1'b0, select_113[5], 1'b0, select_113[4], 1'b0, select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0]};
  logic [31:0] here;
  assign here = select_94[2] ? {select_114[15], 1'b0, select_114[14], 1'b0, select_114[13], 1'b0, select_114[12], 1'b0, select_114[11], 1'b0, select_114[10], 1'b0, select_114[9], 1'b0, select_114[8], 1'b0, select_114[7], 1'b0, select_114[6], 1'b0, select_114[5], 1'b0, select_114[4], 1'b0, select_114[3], 1'b0, select_114[2], 1'b0, select_114[1], 1'b0, select_114[0], 1'b0} : {1'b0, select_114[15], 1'b0, select_114[14], 1'b0, select_114[13], 1'b0, select_114[12], 1'b0, select_114[11], 1'b0, select_114[10], 1'b0, select_114[9], 1'b0, select_114[8], 1'b0, select_114[7], 1'b0, select_114[6], 1'b0, select_114[5], 1'b0, select_114[4], 1'b0, select_114[3], 1'b0, select_114[2], 1'b0, select_114[1], 1'b0, select_114[0]};
  // hls/stages/coarse.hpp:152
  logic not_118;
  assign not_118 = ~or_109;
  // hls/stages/coarse.hpp:168
  logic [9:0] sum_122;
  assign sum_122 = {8'h0, {2{one_more}}} + (first_i ? 10'h0 : left_parts_blind_strips_q);
  // hls/stages/coarse.hpp:65
  logic and_125;
  assign and_125 = not_118 & ((here & seen) == 32'h0);
  // hls/stages/coarse.hpp:168
  logic [7:0] sum_126;
  assign sum_126 = {8{and_125}} + sum_122[9:2];
  logic [9:0] sum_128;
  assign sum_128 = {8'h0, {2{start_i}}} + (first_i ? 10'h0 : left_parts_blind_rows_q);
  logic not_131;
  assign not_131 = ~((start_i | or_109) ? or_109 : left_parts_row_seen_q);
  logic [7:0] sum_132;
  assign sum_132 = sum_128[9:2] + {8{not_131}};
  // hls/stages/coarse.hpp:151
  logic or_134;
  assign or_134 = start_i | (sum_86 < {2'h0, small_step_q});
  logic [31:0] seen_2;
  assign seen_2 = first_i ? 32'h0 : right_parts_strips_q;
  // hls/stages/coarse.hpp:152
  logic not_138;
  assign not_138 = ~or_134;
  // hls/stages/coarse.hpp:168
  logic [9:0] sum_142;
  assign sum_142 = {8'h0, {2{one_more}}} + (first_i ? 10'h0 : right_parts_blind_strips_q);
  // hls/stages/coarse.hpp:152
  logic and_145;
  assign and_145 = ((here & seen_2) == 32'h0) & not_138;
  // hls/stages/coarse.hpp:168
  logic [7:0] sum_146;
  assign sum_146 = {8{and_145}} + sum_142[9:2];
  logic [9:0] sum_148;
  assign sum_148 = {8'h0, {2{start_i}}} + (first_i ? 10'h0 : right_parts_blind_rows_q);
  logic not_151;
  assign not_151 = ~((start_i | or_134) ? or_134 : right_parts_row_seen_q);
  logic [7:0] sum_152;
  assign sum_152 = sum_148[9:2] + {8{not_151}};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q <= 8'h0;
      right_q <= 8'h0;
      small_step_q <= 7'h0;
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
      places_column_q <= 7'h0;
      places_strips_q <= 6'h0;
      places_rows_q <= 5'h0;
      places_first_row_q <= 1'b0;
      left_parts_strips_q <= 32'h0;
      left_parts_row_seen_q <= 1'b0;
      left_parts_blind_strips_q <= 10'h0;
      left_parts_blind_rows_q <= 10'h0;
      right_parts_strips_q <= 32'h0;
      right_parts_row_seen_q <= 1'b0;
      right_parts_blind_strips_q <= 10'h0;
      right_parts_blind_rows_q <= 10'h0;
    end else if (s0_en) begin
      left_q <= left_i;
      right_q <= right_i;
      small_step_q <= sum_34[8:2];
      g_q <= g_2;
      h_q <= h_2;
      column_q <= select_39 + 3'h1;
      second_q <= start_i;
      determinants_q <= equal_41 ? 21'h0 : (start_i ? 21'h0 : select_48);
      products_q <= equal_41 ? 21'h0 : (start_i ? 21'h0 : select_53);
      texture_q <= equal_41 ? 12'h0 : (start_i ? 12'h0 : select_59);
      segments_missing_q <= select_67;
      score_q <= select_78;
      left_steps_balance_q <= sum_84;
      right_steps_balance_q <= sum_92;
      places_column_q <= select_94;
      places_strips_q <= {5'h0, one_more} + (first_i ? 6'h0 : places_strips_q);
      places_rows_q <= rows_before + {4'h0, and_103};
      places_first_row_q <= first_i ? or_105 : (and_96 & or_105);
      left_parts_strips_q <= or_109 ? seen : (here | seen);
      left_parts_row_seen_q <= not_118 | (left_parts_row_seen_q & not_42);
      left_parts_blind_strips_q <= {sum_126, sum_122[1:0]};
      left_parts_blind_rows_q <= {sum_132, sum_128[1:0]};
      right_parts_strips_q <= or_134 ? seen_2 : (here | seen_2);
      right_parts_row_seen_q <= not_138 | (right_parts_row_seen_q & not_42);
      right_parts_blind_strips_q <= {sum_146, sum_142[1:0]};
      right_parts_blind_rows_q <= {sum_152, sum_148[1:0]};
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/coarse.hpp:99
  logic and_156;
  assign and_156 = (~(cfg_one_camera_segments_i == 8'h0)) & ($signed(segments_missing_q) < $signed(12'h1));
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

  logic and_158_s2_q;
  logic select_167_s2_q;
  logic select_174_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      and_158_s2_q <= and_156 & (~score_q[12]);
      select_167_s2_q <= select_167;
      select_174_s2_q <= select_174;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign one_camera_o = and_158_s2_q;
  assign left_blind_o = select_167_s2_q;
  assign right_blind_o = select_174_s2_q;
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

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^sum_34[1:0];

endmodule
