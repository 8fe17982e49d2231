// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Coarse<horopter::hls::profiles::vga>, hls/stages/coarse.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 294 bits, pipeline 4 bits, memories 0 bits.
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
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Of the configuration alone: not pipelined.
  logic [8:0] sum_35;
  assign sum_35 = {1'b0, cfg_blind_step_i} + {2'h0, cfg_blind_step_i[7:1]};
  logic equal_160;
  assign equal_160 = cfg_blind_share_i == 8'h0;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_q;
  logic [7:0] right_q;
  logic [6:0] small_step_q;
  logic [8:0] g_q;
  logic [8:0] h_q;
  logic [2:0] column_q;
  logic second_q;
  logic ended_q;
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
  logic [2:0] select_40;
  assign select_40 = start_i ? 3'h0 : column_q;
  // hls/stages/coarse.hpp:74
  logic equal_42;
  assign equal_42 = select_40 == 3'h7;
  // hls/stages/coarse.hpp:83
  logic or_43;
  assign or_43 = start_i | equal_42;
  // hls/stages/coarse.hpp:60
  logic not_47;
  assign not_47 = ~start_i;
  // hls/stages/coarse.hpp:71
  logic and_50;
  assign and_50 = not_47 & (~(second_q & not_47));
  logic [17:0] product_51;
  assign product_51 = $signed({{9{g_q[8]}}, g_q}) * $signed({{9{h_2[8]}}, h_2});
  logic [17:0] product_52;
  assign product_52 = $signed({{9{h_q[8]}}, h_q}) * $signed({{9{g_2[8]}}, g_2});
  logic [18:0] select_54;
  assign select_54 = and_50 ? ({product_51[17], product_51} - {product_52[17], product_52}) : 19'h0;
  logic [20:0] determinants;
  assign determinants = (ended_q ? 21'h0 : determinants_q) + {{2{select_54[18]}}, select_54};
  // hls/stages/coarse.hpp:72
  logic [17:0] product_57;
  assign product_57 = $signed({{9{g_2[8]}}, g_2}) * $signed({{9{h_2[8]}}, h_2});
  logic [17:0] select_58;
  assign select_58 = and_50 ? product_57 : 18'h0;
  logic [20:0] sum_59;
  assign sum_59 = (ended_q ? 21'h0 : products_q) + {{3{select_58[17]}}, select_58};
  // hls/stages/coarse.hpp:62
  logic [7:0] xor_60;
  assign xor_60 = g_2[7:0] ^ {8{g_2[8]}};
  logic [8:0] sum_61;
  assign sum_61 = {8'h0, g_2[8]} + {1'b0, xor_60};
  // hls/stages/coarse.hpp:74
  logic [11:0] select_63;
  assign select_63 = and_50 ? (texture_q + {3'h0, sum_61}) : texture_q;
  // hls/stages/coarse.hpp:76
  logic and_68;
  assign and_68 = equal_42 & (~(select_63[11:6] == 6'h0));
  // hls/stages/coarse.hpp:80
  logic [11:0] select_70;
  assign select_70 = first_i ? {4'h0, cfg_one_camera_segments_i} : (segments_missing_q + {12{and_68}});
  // hls/stages/coarse.hpp:77
  logic [21:0] sum_71;
  assign sum_71 = {sum_59[20], sum_59} + {{2{sum_59[20]}}, sum_59[20:1]};
  // hls/stages/coarse.hpp:78
  logic less_72;
  assign less_72 = $signed({determinants, 5'h0}) < $signed({{3{sum_71[21]}}, sum_71, sum_59[0]});
  logic [21:0] sum_73;
  assign sum_73 = {determinants[20], determinants} + {{4{sum_71[21]}}, sum_71[21:4]};
  logic less_74;
  assign less_74 = $signed({sum_73, sum_71[3:0], sum_59[0]}) < $signed(27'h1);
  logic not_75;
  assign not_75 = ~less_74;
  // hls/stages/coarse.hpp:81
  logic [1:0] select_77;
  assign select_77 = and_68 ? (less_72 ? {less_74, not_75} : 2'h2) : 2'h0;
  logic [12:0] select_79;
  assign select_79 = first_i ? 13'h0 : (score_q + {{11{select_77[1]}}, 1'b0, select_77[0]});
  // hls/stages/coarse.hpp:106
  logic not_82;
  assign not_82 = ~(start_i | (sum_61 < {1'b0, cfg_blind_step_i}));
  logic [9:0] difference_83;
  assign difference_83 = {1'b0, not_82, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:107
  logic [21:0] sum_85;
  assign sum_85 = {{12{difference_83[9]}}, difference_83} + (first_i ? 22'h0 : left_steps_balance_q);
  // hls/stages/coarse.hpp:63
  logic [7:0] xor_86;
  assign xor_86 = h_2[7:0] ^ {8{h_2[8]}};
  logic [8:0] sum_87;
  assign sum_87 = {8'h0, h_2[8]} + {1'b0, xor_86};
  // hls/stages/coarse.hpp:106
  logic not_90;
  assign not_90 = ~(start_i | (sum_87 < {1'b0, cfg_blind_step_i}));
  logic [9:0] difference_91;
  assign difference_91 = {1'b0, not_90, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:107
  logic [21:0] sum_93;
  assign sum_93 = {{12{difference_91[9]}}, difference_91} + (first_i ? 22'h0 : right_steps_balance_q);
  // hls/stages/coarse.hpp:130
  logic [6:0] select_95;
  assign select_95 = start_i ? 7'h0 : (places_column_q + 7'h1);
  // hls/stages/coarse.hpp:133
  logic equal_96;
  assign equal_96 = select_95[1:0] == 2'h0;
  // hls/stages/coarse.hpp:132
  logic and_97;
  assign and_97 = places_first_row_q & not_47;
  // hls/stages/coarse.hpp:64
  logic one_more;
  assign one_more = first_i ? equal_96 : (and_97 & equal_96);
  // hls/stages/coarse.hpp:134
  logic [5:0] sum_101;
  assign sum_101 = {5'h0, one_more} + (first_i ? 6'h0 : places_strips_q);
  // hls/stages/coarse.hpp:135
  logic [4:0] rows_before;
  assign rows_before = first_i ? 5'h0 : places_rows_q;
  // hls/stages/coarse.hpp:136
  logic and_104;
  assign and_104 = start_i & (~rows_before[4]);
  logic [4:0] sum_105;
  assign sum_105 = rows_before + {4'h0, and_104};
  // hls/stages/coarse.hpp:133
  logic or_106;
  assign or_106 = first_i | and_97;
  // hls/stages/coarse.hpp:138
  logic or_110;
  assign or_110 = start_i | (sum_61 < {2'h0, small_step_q});
  // hls/stages/coarse.hpp:146
  logic [31:0] seen;
  assign seen = first_i ? 32'h0 : left_parts_strips_q;
  // hls/stages/coarse.hpp:145
  logic not_112;
  assign not_112 = ~select_95[6];
  logic [3:0] select_113;
  assign select_113 = select_95[5] ? {select_95[6], 1'b0, not_112, 1'b0} : {1'b0, select_95[6], 1'b0, not_112};
  logic [7:0] select_114;
  assign select_114 = select_95[4] ? {select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0], 1'b0} : {1'b0, select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0]};
  logic [15:0] select_115;
  assign select_115 = select_95[3] ? {select_114[7], 1'b0, select_114[6], 1'b0, select_114[5], 1'b0, select_114[4], 1'b0, select_114[3], 1'b0, select_114[2], 1'b0, select_114[1], 1'b0, select_114[0], 1'b0} : {1'b0, select_114[7], 1'b0, select_114[6], 1'b0, select_114[5], 1'b0, select_114[4], 1'b0, select_114[3], 1'b0, select_114[2], 1'b0, select_114[1], 1'b0, select_114[0]};
  logic [31:0] here;
  assign here = select_95[2] ? {select_115[15], 1'b0, select_115[14], 1'b0, select_115[13], 1'b0, select_115[12], 1'b0, select_115[11], 1'b0, select_115[10], 1'b0, select_115[9], 1'b0, select_115[8], 1'b0, select_115[7], 1'b0, select_115[6], 1'b0, select_115[5], 1'b0, select_115[4], 1'b0, select_115[3], 1'b0, select_115[2], 1'b0, select_115[1], 1'b0, select_115[0], 1'b0} : {1'b0, select_115[15], 1'b0, select_115[14], 1'b0, select_115[13], 1'b0, select_115[12], 1'b0, select_115[11], 1'b0, select_115[10], 1'b0, select_115[9], 1'b0, select_115[8], 1'b0, select_115[7], 1'b0, select_115[6], 1'b0, select_115[5], 1'b0, select_115[4], 1'b0, select_115[3], 1'b0, select_115[2], 1'b0, select_115[1], 1'b0, select_115[0]};
  // hls/stages/coarse.hpp:147
  logic not_119;
  assign not_119 = ~or_110;
  // hls/stages/coarse.hpp:163
  logic [9:0] sum_123;
  assign sum_123 = {8'h0, {2{one_more}}} + (first_i ? 10'h0 : left_parts_blind_strips_q);
  // hls/stages/coarse.hpp:65
  logic and_126;
  assign and_126 = not_119 & ((here & seen) == 32'h0);
  // hls/stages/coarse.hpp:163
  logic [7:0] sum_127;
  assign sum_127 = {8{and_126}} + sum_123[9:2];
  logic [9:0] sum_129;
  assign sum_129 = {8'h0, {2{start_i}}} + (first_i ? 10'h0 : left_parts_blind_rows_q);
  logic not_132;
  assign not_132 = ~((start_i | or_110) ? or_110 : left_parts_row_seen_q);
  logic [7:0] sum_133;
  assign sum_133 = sum_129[9:2] + {8{not_132}};
  // hls/stages/coarse.hpp:146
  logic or_135;
  assign or_135 = start_i | (sum_87 < {2'h0, small_step_q});
  logic [31:0] seen_2;
  assign seen_2 = first_i ? 32'h0 : right_parts_strips_q;
  // hls/stages/coarse.hpp:147
  logic not_139;
  assign not_139 = ~or_135;
  // hls/stages/coarse.hpp:163
  logic [9:0] sum_143;
  assign sum_143 = {8'h0, {2{one_more}}} + (first_i ? 10'h0 : right_parts_blind_strips_q);
  // hls/stages/coarse.hpp:66
  logic and_146;
  assign and_146 = not_139 & ((here & seen_2) == 32'h0);
  // hls/stages/coarse.hpp:163
  logic [7:0] sum_147;
  assign sum_147 = {8{and_146}} + sum_143[9:2];
  logic [9:0] sum_149;
  assign sum_149 = {8'h0, {2{start_i}}} + (first_i ? 10'h0 : right_parts_blind_rows_q);
  logic not_152;
  assign not_152 = ~((start_i | or_135) ? or_135 : right_parts_row_seen_q);
  logic [7:0] sum_153;
  assign sum_153 = sum_149[9:2] + {8{not_152}};
  // hls/stages/coarse.hpp:94
  logic and_157;
  assign and_157 = (~(cfg_one_camera_segments_i == 8'h0)) & ($signed(select_70) < $signed(12'h1));
  // hls/stages/coarse.hpp:155
  logic equal_164;
  assign equal_164 = sum_101[5:3] == 3'h0;
  // hls/stages/coarse.hpp:109
  logic select_168;
  assign select_168 = (sum_85[21] | equal_160) ? sum_85[21] : ((sum_105[4] & (~sum_133[7])) | (~(sum_127[7] | equal_164)));
  // hls/stages/coarse.hpp:94
  logic select_175;
  assign select_175 = (sum_93[21] | equal_160) ? sum_93[21] : ((sum_105[4] & (~sum_153[7])) | (~(sum_147[7] | equal_164)));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q <= 8'h0;
      right_q <= 8'h0;
      small_step_q <= 7'h0;
      g_q <= 9'h0;
      h_q <= 9'h0;
      column_q <= 3'h0;
      second_q <= 1'b0;
      ended_q <= 1'b0;
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
      small_step_q <= sum_35[8:2];
      g_q <= g_2;
      h_q <= h_2;
      column_q <= select_40 + 3'h1;
      second_q <= start_i;
      ended_q <= equal_42 ? or_43 : (start_i & or_43);
      determinants_q <= determinants;
      products_q <= sum_59;
      texture_q <= equal_42 ? 12'h0 : (start_i ? 12'h0 : select_63);
      segments_missing_q <= select_70;
      score_q <= select_79;
      left_steps_balance_q <= sum_85;
      right_steps_balance_q <= sum_93;
      places_column_q <= select_95;
      places_strips_q <= sum_101;
      places_rows_q <= sum_105;
      places_first_row_q <= first_i ? or_106 : (and_97 & or_106);
      left_parts_strips_q <= or_110 ? seen : (here | seen);
      left_parts_row_seen_q <= not_119 | (left_parts_row_seen_q & not_47);
      left_parts_blind_strips_q <= {sum_127, sum_123[1:0]};
      left_parts_blind_rows_q <= {sum_133, sum_129[1:0]};
      right_parts_strips_q <= or_135 ? seen_2 : (here | seen_2);
      right_parts_row_seen_q <= not_139 | (right_parts_row_seen_q & not_47);
      right_parts_blind_strips_q <= {sum_147, sum_143[1:0]};
      right_parts_blind_rows_q <= {sum_153, sum_149[1:0]};
    end
  end

  logic and_159_s1_q;
  logic select_168_s1_q;
  logic select_175_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      and_159_s1_q <= and_157 & (~select_79[12]);
      select_168_s1_q <= select_168;
      select_175_s1_q <= select_175;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign one_camera_o = and_159_s1_q;
  assign left_blind_o = select_168_s1_q;
  assign right_blind_o = select_175_s1_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^sum_35[1:0];

endmodule
