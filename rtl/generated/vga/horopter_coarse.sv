// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Coarse<horopter::hls::profiles::vga>, hls/stages/coarse.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 286 bits, pipeline 5 bits, memories 0 bits.
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
  logic [8:0] sum_106;
  assign sum_106 = {1'b0, cfg_blind_step_i} + {2'h0, cfg_blind_step_i[7:1]};
  logic equal_158;
  assign equal_158 = cfg_blind_share_i == 8'h0;

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
  logic [2:0] select_37;
  assign select_37 = start_i ? 3'h0 : column_q;
  // hls/stages/coarse.hpp:76
  logic equal_39;
  assign equal_39 = select_37 == 3'h7;
  // hls/stages/coarse.hpp:60
  logic not_40;
  assign not_40 = ~start_i;
  logic and_41;
  assign and_41 = second_q & not_40;
  // hls/stages/coarse.hpp:72
  logic [17:0] product_42;
  assign product_42 = $signed({{9{g_q[8]}}, g_q}) * $signed({{9{h_2[8]}}, h_2});
  logic [17:0] product_43;
  assign product_43 = $signed({{9{h_q[8]}}, h_q}) * $signed({{9{g_2[8]}}, g_2});
  logic [18:0] difference_44;
  assign difference_44 = {product_42[17], product_42} - {product_43[17], product_43};
  // hls/stages/coarse.hpp:76
  logic [20:0] select_46;
  assign select_46 = and_41 ? determinants_q : (determinants_q + {{2{difference_44[18]}}, difference_44});
  // hls/stages/coarse.hpp:73
  logic [17:0] product_49;
  assign product_49 = $signed({{9{g_2[8]}}, g_2}) * $signed({{9{h_2[8]}}, h_2});
  // hls/stages/coarse.hpp:76
  logic [20:0] select_51;
  assign select_51 = and_41 ? products_q : (products_q + {{3{product_49[17]}}, product_49});
  // hls/stages/coarse.hpp:62
  logic [7:0] xor_54;
  assign xor_54 = g_2[7:0] ^ {8{g_2[8]}};
  logic [8:0] sum_55;
  assign sum_55 = {8'h0, g_2[8]} + {1'b0, xor_54};
  // hls/stages/coarse.hpp:76
  logic [11:0] select_57;
  assign select_57 = and_41 ? texture_q : (texture_q + {3'h0, sum_55});
  // hls/stages/coarse.hpp:78
  logic and_63;
  assign and_63 = equal_39 & (~((start_i ? texture_q[11:6] : select_57[11:6]) == 6'h0));
  // hls/stages/coarse.hpp:82
  logic [11:0] select_65;
  assign select_65 = first_i ? {4'h0, cfg_one_camera_segments_i} : (segments_missing_q + {12{and_63}});
  // hls/stages/coarse.hpp:76
  logic [20:0] determinants;
  assign determinants = start_i ? determinants_q : select_46;
  logic [20:0] select_67;
  assign select_67 = start_i ? products_q : select_51;
  // hls/stages/coarse.hpp:79
  logic [21:0] sum_68;
  assign sum_68 = {select_67[20], select_67} + {{2{select_67[20]}}, select_67[20:1]};
  // hls/stages/coarse.hpp:80
  logic less_69;
  assign less_69 = $signed({determinants, 5'h0}) < $signed({{3{sum_68[21]}}, sum_68, select_67[0]});
  logic [21:0] sum_70;
  assign sum_70 = {determinants[20], determinants} + {{4{sum_68[21]}}, sum_68[21:4]};
  logic less_71;
  assign less_71 = $signed({sum_70, sum_68[3:0], select_67[0]}) < $signed(27'h1);
  logic not_72;
  assign not_72 = ~less_71;
  // hls/stages/coarse.hpp:83
  logic [1:0] select_74;
  assign select_74 = and_63 ? (less_69 ? {less_71, not_72} : 2'h2) : 2'h0;
  logic [12:0] select_76;
  assign select_76 = first_i ? 13'h0 : (score_q + {{11{select_74[1]}}, 1'b0, select_74[0]});
  // hls/stages/coarse.hpp:111
  logic not_79;
  assign not_79 = ~(start_i | (sum_55 < {1'b0, cfg_blind_step_i}));
  logic [9:0] difference_80;
  assign difference_80 = {1'b0, not_79, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:112
  logic [21:0] sum_82;
  assign sum_82 = {{12{difference_80[9]}}, difference_80} + (first_i ? 22'h0 : left_steps_balance_q);
  // hls/stages/coarse.hpp:63
  logic [7:0] xor_83;
  assign xor_83 = h_2[7:0] ^ {8{h_2[8]}};
  logic [8:0] sum_84;
  assign sum_84 = {8'h0, h_2[8]} + {1'b0, xor_83};
  // hls/stages/coarse.hpp:111
  logic not_87;
  assign not_87 = ~(start_i | (sum_84 < {1'b0, cfg_blind_step_i}));
  logic [9:0] difference_88;
  assign difference_88 = {1'b0, not_87, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:112
  logic [21:0] sum_90;
  assign sum_90 = {{12{difference_88[9]}}, difference_88} + (first_i ? 22'h0 : right_steps_balance_q);
  // hls/stages/coarse.hpp:135
  logic [6:0] select_92;
  assign select_92 = start_i ? 7'h0 : (places_column_q + 7'h1);
  // hls/stages/coarse.hpp:138
  logic equal_93;
  assign equal_93 = select_92[1:0] == 2'h0;
  // hls/stages/coarse.hpp:137
  logic and_94;
  assign and_94 = places_first_row_q & not_40;
  // hls/stages/coarse.hpp:64
  logic one_more;
  assign one_more = first_i ? equal_93 : (and_94 & equal_93);
  // hls/stages/coarse.hpp:140
  logic [4:0] rows_before;
  assign rows_before = first_i ? 5'h0 : places_rows_q;
  // hls/stages/coarse.hpp:141
  logic and_101;
  assign and_101 = start_i & (~rows_before[4]);
  // hls/stages/coarse.hpp:138
  logic or_103;
  assign or_103 = first_i | and_94;
  // hls/stages/coarse.hpp:143
  logic or_108;
  assign or_108 = start_i | (sum_55 < {2'h0, sum_106[8:2]});
  // hls/stages/coarse.hpp:151
  logic [31:0] seen;
  assign seen = first_i ? 32'h0 : left_parts_strips_q;
  // hls/stages/coarse.hpp:150
  logic not_110;
  assign not_110 = ~select_92[6];
  logic [3:0] select_111;
  assign select_111 = select_92[5] ? {select_92[6], 1'b0, not_110, 1'b0} : {1'b0, select_92[6], 1'b0, not_110};
  logic [7:0] select_112;
  assign select_112 = select_92[4] ? {select_111[3], 1'b0, select_111[2], 1'b0, select_111[1], 1'b0, select_111[0], 1'b0} : {1'b0, select_111[3], 1'b0, select_111[2], 1'b0, select_111[1], 1'b0, select_111[0]};
  logic [15:0] select_113;
  assign select_113 = select_92[3] ? {select_112[7], 1'b0, select_112[6], 1'b0, select_112[5], 1'b0, select_112[4], 1'b0, select_112[3], 1'b0, select_112[2], 1'b0, select_112[1], 1'b0, select_112[0], 1'b0} : {1'b0, select_112[7], 1'b0, select_112[6], 1'b0, select_112[5], 1'b0, select_112[4], 1'b0, select_112[3], 1'b0, select_112[2], 1'b0, select_112[1], 1'b0, select_112[0]};
  logic [31:0] here;
  assign here = select_92[2] ? {select_113[15], 1'b0, select_113[14], 1'b0, select_113[13], 1'b0, select_113[12], 1'b0, select_113[11], 1'b0, select_113[10], 1'b0, select_113[9], 1'b0, select_113[8], 1'b0, select_113[7], 1'b0, select_113[6], 1'b0, select_113[5], 1'b0, select_113[4], 1'b0, select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0], 1'b0} : {1'b0, select_113[15], 1'b0, select_113[14], 1'b0, select_113[13], 1'b0, select_113[12], 1'b0, select_113[11], 1'b0, select_113[10], 1'b0, select_113[9], 1'b0, select_113[8], 1'b0, select_113[7], 1'b0, select_113[6], 1'b0, select_113[5], 1'b0, select_113[4], 1'b0, select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0]};
  // hls/stages/coarse.hpp:152
  logic not_117;
  assign not_117 = ~or_108;
  // hls/stages/coarse.hpp:168
  logic [9:0] sum_121;
  assign sum_121 = {8'h0, {2{one_more}}} + (first_i ? 10'h0 : left_parts_blind_strips_q);
  // hls/stages/coarse.hpp:66
  logic and_124;
  assign and_124 = not_117 & ((here & seen) == 32'h0);
  // hls/stages/coarse.hpp:168
  logic [7:0] sum_125;
  assign sum_125 = {8{and_124}} + sum_121[9:2];
  logic [9:0] sum_127;
  assign sum_127 = {8'h0, {2{start_i}}} + (first_i ? 10'h0 : left_parts_blind_rows_q);
  logic not_130;
  assign not_130 = ~((start_i | or_108) ? or_108 : left_parts_row_seen_q);
  logic [7:0] sum_131;
  assign sum_131 = sum_127[9:2] + {8{not_130}};
  // hls/stages/coarse.hpp:151
  logic or_133;
  assign or_133 = start_i | (sum_84 < {2'h0, sum_106[8:2]});
  logic [31:0] seen_2;
  assign seen_2 = first_i ? 32'h0 : right_parts_strips_q;
  // hls/stages/coarse.hpp:152
  logic not_137;
  assign not_137 = ~or_133;
  // hls/stages/coarse.hpp:168
  logic [9:0] sum_141;
  assign sum_141 = {8'h0, {2{one_more}}} + (first_i ? 10'h0 : right_parts_blind_strips_q);
  // hls/stages/coarse.hpp:152
  logic and_144;
  assign and_144 = ((here & seen_2) == 32'h0) & not_137;
  // hls/stages/coarse.hpp:168
  logic [7:0] sum_145;
  assign sum_145 = {8{and_144}} + sum_141[9:2];
  logic [9:0] sum_147;
  assign sum_147 = {8'h0, {2{start_i}}} + (first_i ? 10'h0 : right_parts_blind_rows_q);
  logic not_150;
  assign not_150 = ~((start_i | or_133) ? or_133 : right_parts_row_seen_q);
  logic [7:0] sum_151;
  assign sum_151 = sum_147[9:2] + {8{not_150}};

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
      g_q <= g_2;
      h_q <= h_2;
      column_q <= select_37 + 3'h1;
      second_q <= start_i;
      determinants_q <= equal_39 ? 21'h0 : (start_i ? 21'h0 : select_46);
      products_q <= equal_39 ? 21'h0 : (start_i ? 21'h0 : select_51);
      texture_q <= equal_39 ? 12'h0 : (start_i ? 12'h0 : select_57);
      segments_missing_q <= select_65;
      score_q <= select_76;
      left_steps_balance_q <= sum_82;
      right_steps_balance_q <= sum_90;
      places_column_q <= select_92;
      places_strips_q <= {5'h0, one_more} + (first_i ? 6'h0 : places_strips_q);
      places_rows_q <= rows_before + {4'h0, and_101};
      places_first_row_q <= first_i ? or_103 : (and_94 & or_103);
      left_parts_strips_q <= or_108 ? seen : (here | seen);
      left_parts_row_seen_q <= not_117 | (left_parts_row_seen_q & not_40);
      left_parts_blind_strips_q <= {sum_125, sum_121[1:0]};
      left_parts_blind_rows_q <= {sum_131, sum_127[1:0]};
      right_parts_strips_q <= or_133 ? seen_2 : (here | seen_2);
      right_parts_row_seen_q <= not_137 | (right_parts_row_seen_q & not_40);
      right_parts_blind_strips_q <= {sum_145, sum_141[1:0]};
      right_parts_blind_rows_q <= {sum_151, sum_147[1:0]};
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/coarse.hpp:99
  logic and_155;
  assign and_155 = (~(cfg_one_camera_segments_i == 8'h0)) & ($signed(segments_missing_q) < $signed(12'h1));
  // hls/stages/coarse.hpp:160
  logic equal_162;
  assign equal_162 = places_strips_q[5:3] == 3'h0;
  // hls/stages/coarse.hpp:114
  logic or_165;
  assign or_165 = (places_rows_q[4] & (~left_parts_blind_rows_q[9])) | (~(left_parts_blind_strips_q[9] | equal_162));
  logic select_166;
  assign select_166 = (left_steps_balance_q[21] | equal_158) ? left_steps_balance_q[21] : or_165;
  // hls/stages/coarse.hpp:99
  logic or_172;
  assign or_172 = (places_rows_q[4] & (~right_parts_blind_rows_q[9])) | (~(right_parts_blind_strips_q[9] | equal_162));
  logic select_173;
  assign select_173 = (right_steps_balance_q[21] | equal_158) ? right_steps_balance_q[21] : or_172;

  logic and_157_s2_q;
  logic select_166_s2_q;
  logic select_173_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      and_157_s2_q <= and_155 & (~score_q[12]);
      select_166_s2_q <= select_166;
      select_173_s2_q <= select_173;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign one_camera_o = and_157_s2_q;
  assign left_blind_o = select_166_s2_q;
  assign right_blind_o = select_173_s2_q;
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
  assign unused_bits = ^sum_106[1:0];

endmodule
