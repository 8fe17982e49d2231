// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Coarse<horopter::hls::profiles::hd>, hls/stages/coarse.hpp. Do not edit.
//
// Latency 7 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 286 bits, pipeline 262 bits, memories 0 bits.
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
  logic [8:0] sum_106;
  assign sum_106 = {1'b0, cfg_blind_step_i} + {2'h0, cfg_blind_step_i[7:1]};
  logic equal_158;
  assign equal_158 = cfg_blind_share_i == 8'h0;

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
  logic [17:0] product_42;
  assign product_42 = $signed({{9{g_s1_q[8]}}, g_s1_q}) * $signed({{9{h_q[8]}}, h_q});
  logic [17:0] product_43;
  assign product_43 = $signed({{9{h_s1_q[8]}}, h_s1_q}) * $signed({{9{g_q[8]}}, g_q});
  // hls/stages/coarse.hpp:73
  logic [17:0] product_49;
  assign product_49 = $signed({{9{g_q[8]}}, g_q}) * $signed({{9{h_q[8]}}, h_q});
  // hls/stages/coarse.hpp:62
  logic [7:0] xor_54;
  assign xor_54 = g_q[7:0] ^ {8{g_q[8]}};
  // hls/stages/coarse.hpp:63
  logic [7:0] xor_83;
  assign xor_83 = h_q[7:0] ^ {8{h_q[8]}};
  // hls/stages/coarse.hpp:150
  logic not_110;
  assign not_110 = ~places_column_q[6];
  logic [3:0] select_111;
  assign select_111 = places_column_q[5] ? {places_column_q[6], 1'b0, not_110, 1'b0} : {1'b0, places_column_q[6], 1'b0, not_110};
  logic [7:0] select_112;
  assign select_112 = places_column_q[4] ? {select_111[3], 1'b0, select_111[2], 1'b0, select_111[1], 1'b0, select_111[0], 1'b0} : {1'b0, select_111[3], 1'b0, select_111[2], 1'b0, select_111[1], 1'b0, select_111[0]};
  logic [15:0] select_113;
  assign select_113 = places_column_q[3] ? {select_112[7], 1'b0, select_112[6], 1'b0, select_112[5], 1'b0, select_112[4], 1'b0, select_112[3], 1'b0, select_112[2], 1'b0, select_112[1], 1'b0, select_112[0], 1'b0} : {1'b0, select_112[7], 1'b0, select_112[6], 1'b0, select_112[5], 1'b0, select_112[4], 1'b0, select_112[3], 1'b0, select_112[2], 1'b0, select_112[1], 1'b0, select_112[0]};

  logic first_s2_q;
  logic start_s2_q;
  logic [17:0] product_42_s2_q;
  logic [17:0] product_43_s2_q;
  logic [17:0] product_49_s2_q;
  logic [8:0] sum_55_s2_q;
  logic [8:0] sum_84_s2_q;
  logic select_92_s2_q;
  logic equal_93_s2_q;
  logic [15:0] select_113_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s2_q <= first_s1_q;
      start_s2_q <= start_s1_q;
      product_42_s2_q <= product_42;
      product_43_s2_q <= product_43;
      product_49_s2_q <= product_49;
      sum_55_s2_q <= {8'h0, g_q[8]} + {1'b0, xor_54};
      sum_84_s2_q <= {8'h0, h_q[8]} + {1'b0, xor_83};
      select_92_s2_q <= places_column_q[2];
      equal_93_s2_q <= places_column_q[1:0] == 2'h0;
      select_113_s2_q <= select_113;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [2:0] column_q;
  logic second_q;
  logic [20:0] products_q;
  logic [11:0] texture_q;
  logic places_first_row_q;
  logic [31:0] left_parts_strips_q;
  logic [31:0] right_parts_strips_q;
  // hls/stages/coarse.hpp:60
  logic [2:0] select_37;
  assign select_37 = start_s2_q ? 3'h0 : column_q;
  // hls/stages/coarse.hpp:76
  logic equal_39;
  assign equal_39 = select_37 == 3'h7;
  // hls/stages/coarse.hpp:60
  logic not_40;
  assign not_40 = ~start_s2_q;
  logic and_41;
  assign and_41 = second_q & not_40;
  // hls/stages/coarse.hpp:72
  logic [18:0] difference_44;
  assign difference_44 = {product_42_s2_q[17], product_42_s2_q} - {product_43_s2_q[17], product_43_s2_q};
  // hls/stages/coarse.hpp:76
  logic [20:0] select_51;
  assign select_51 = and_41 ? products_q : (products_q + {{3{product_49_s2_q[17]}}, product_49_s2_q});
  logic [11:0] select_57;
  assign select_57 = and_41 ? texture_q : (texture_q + {3'h0, sum_55_s2_q});
  // hls/stages/coarse.hpp:137
  logic and_94;
  assign and_94 = places_first_row_q & not_40;
  // hls/stages/coarse.hpp:64
  logic one_more;
  assign one_more = first_s2_q ? equal_93_s2_q : (and_94 & equal_93_s2_q);
  // hls/stages/coarse.hpp:138
  logic or_103;
  assign or_103 = first_s2_q | and_94;
  // hls/stages/coarse.hpp:143
  logic or_108;
  assign or_108 = start_s2_q | (sum_55_s2_q < {2'h0, sum_106[8:2]});
  // hls/stages/coarse.hpp:151
  logic [31:0] seen;
  assign seen = first_s2_q ? 32'h0 : left_parts_strips_q;
  // hls/stages/coarse.hpp:150
  logic [31:0] here;
  assign here = select_92_s2_q ? {select_113_s2_q[15], 1'b0, select_113_s2_q[14], 1'b0, select_113_s2_q[13], 1'b0, select_113_s2_q[12], 1'b0, select_113_s2_q[11], 1'b0, select_113_s2_q[10], 1'b0, select_113_s2_q[9], 1'b0, select_113_s2_q[8], 1'b0, select_113_s2_q[7], 1'b0, select_113_s2_q[6], 1'b0, select_113_s2_q[5], 1'b0, select_113_s2_q[4], 1'b0, select_113_s2_q[3], 1'b0, select_113_s2_q[2], 1'b0, select_113_s2_q[1], 1'b0, select_113_s2_q[0], 1'b0} : {1'b0, select_113_s2_q[15], 1'b0, select_113_s2_q[14], 1'b0, select_113_s2_q[13], 1'b0, select_113_s2_q[12], 1'b0, select_113_s2_q[11], 1'b0, select_113_s2_q[10], 1'b0, select_113_s2_q[9], 1'b0, select_113_s2_q[8], 1'b0, select_113_s2_q[7], 1'b0, select_113_s2_q[6], 1'b0, select_113_s2_q[5], 1'b0, select_113_s2_q[4], 1'b0, select_113_s2_q[3], 1'b0, select_113_s2_q[2], 1'b0, select_113_s2_q[1], 1'b0, select_113_s2_q[0]};
  // hls/stages/coarse.hpp:151
  logic or_133;
  assign or_133 = start_s2_q | (sum_84_s2_q < {2'h0, sum_106[8:2]});
  logic [31:0] seen_2;
  assign seen_2 = first_s2_q ? 32'h0 : right_parts_strips_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      column_q <= 3'h0;
      second_q <= 1'b0;
      products_q <= 21'h0;
      texture_q <= 12'h0;
      places_first_row_q <= 1'b0;
      left_parts_strips_q <= 32'h0;
      right_parts_strips_q <= 32'h0;
    end else if (s2_en) begin
      column_q <= select_37 + 3'h1;
      second_q <= start_s2_q;
      products_q <= equal_39 ? 21'h0 : (start_s2_q ? 21'h0 : select_51);
      texture_q <= equal_39 ? 12'h0 : (start_s2_q ? 12'h0 : select_57);
      places_first_row_q <= first_s2_q ? or_103 : (and_94 & or_103);
      left_parts_strips_q <= or_108 ? seen : (here | seen);
      right_parts_strips_q <= or_133 ? seen_2 : (here | seen_2);
    end
  end

  logic first_s3_q;
  logic equal_39_s3_q;
  logic not_40_s3_q;
  logic and_41_s3_q;
  logic [18:0] difference_44_s3_q;
  logic [5:0] select_60_s3_q;
  logic [20:0] select_67_s3_q;
  logic not_79_s3_q;
  logic not_87_s3_q;
  logic one_more_s3_q;
  logic or_108_s3_q;
  logic equal_123_s3_q;
  logic or_133_s3_q;
  logic equal_143_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s3_q <= first_s2_q;
      equal_39_s3_q <= equal_39;
      not_40_s3_q <= not_40;
      and_41_s3_q <= and_41;
      difference_44_s3_q <= difference_44;
      select_60_s3_q <= start_s2_q ? texture_q[11:6] : select_57[11:6];
      select_67_s3_q <= start_s2_q ? products_q : select_51;
      not_79_s3_q <= ~(start_s2_q | (sum_55_s2_q < {1'b0, cfg_blind_step_i}));
      not_87_s3_q <= ~(start_s2_q | (sum_84_s2_q < {1'b0, cfg_blind_step_i}));
      one_more_s3_q <= one_more;
      or_108_s3_q <= or_108;
      equal_123_s3_q <= (here & seen) == 32'h0;
      or_133_s3_q <= or_133;
      equal_143_s3_q <= (here & seen_2) == 32'h0;
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
  logic [20:0] sum_45;
  assign sum_45 = determinants_q + {{2{difference_44_s3_q[18]}}, difference_44_s3_q};
  // hls/stages/coarse.hpp:76
  logic [20:0] select_46;
  assign select_46 = and_41_s3_q ? determinants_q : sum_45;
  logic [20:0] determinants;
  assign determinants = second_q ? determinants_q : select_46;
  // hls/stages/coarse.hpp:79
  logic [21:0] sum_68;
  assign sum_68 = {select_67_s3_q[20], select_67_s3_q} + {{2{select_67_s3_q[20]}}, select_67_s3_q[20:1]};
  // hls/stages/coarse.hpp:111
  logic [9:0] difference_80;
  assign difference_80 = {1'b0, not_79_s3_q, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:112
  logic [21:0] sum_82;
  assign sum_82 = {{12{difference_80[9]}}, difference_80} + (first_s3_q ? 22'h0 : left_steps_balance_q);
  // hls/stages/coarse.hpp:111
  logic [9:0] difference_88;
  assign difference_88 = {1'b0, not_87_s3_q, 8'h0} - {2'h0, cfg_blind_share_i};
  // hls/stages/coarse.hpp:112
  logic [21:0] sum_90;
  assign sum_90 = {{12{difference_88[9]}}, difference_88} + (first_s3_q ? 22'h0 : right_steps_balance_q);
  // hls/stages/coarse.hpp:140
  logic [4:0] rows_before;
  assign rows_before = first_s3_q ? 5'h0 : places_rows_q;
  // hls/stages/coarse.hpp:141
  logic and_101;
  assign and_101 = second_q & (~rows_before[4]);
  // hls/stages/coarse.hpp:152
  logic not_117;
  assign not_117 = ~or_108_s3_q;
  // hls/stages/coarse.hpp:168
  logic [9:0] sum_121;
  assign sum_121 = {8'h0, {2{one_more_s3_q}}} + (first_s3_q ? 10'h0 : left_parts_blind_strips_q);
  // hls/stages/coarse.hpp:66
  logic and_124;
  assign and_124 = not_117 & equal_123_s3_q;
  // hls/stages/coarse.hpp:168
  logic [7:0] sum_125;
  assign sum_125 = {8{and_124}} + sum_121[9:2];
  logic [9:0] sum_127;
  assign sum_127 = {8'h0, {2{second_q}}} + (first_s3_q ? 10'h0 : left_parts_blind_rows_q);
  logic not_130;
  assign not_130 = ~((second_q | or_108_s3_q) ? or_108_s3_q : left_parts_row_seen_q);
  logic [7:0] sum_131;
  assign sum_131 = sum_127[9:2] + {8{not_130}};
  // hls/stages/coarse.hpp:152
  logic not_137;
  assign not_137 = ~or_133_s3_q;
  // hls/stages/coarse.hpp:168
  logic [9:0] sum_141;
  assign sum_141 = {8'h0, {2{one_more_s3_q}}} + (first_s3_q ? 10'h0 : right_parts_blind_strips_q);
  // hls/stages/coarse.hpp:152
  logic and_144;
  assign and_144 = equal_143_s3_q & not_137;
  // hls/stages/coarse.hpp:168
  logic [7:0] sum_145;
  assign sum_145 = {8{and_144}} + sum_141[9:2];
  logic [9:0] sum_147;
  assign sum_147 = {8'h0, {2{second_q}}} + (first_s3_q ? 10'h0 : right_parts_blind_rows_q);
  logic not_150;
  assign not_150 = ~((second_q | or_133_s3_q) ? or_133_s3_q : right_parts_row_seen_q);
  logic [7:0] sum_151;
  assign sum_151 = sum_147[9:2] + {8{not_150}};

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
      determinants_q <= equal_39_s3_q ? 21'h0 : (second_q ? 21'h0 : select_46);
      left_steps_balance_q <= sum_82;
      right_steps_balance_q <= sum_90;
      places_strips_q <= {5'h0, one_more_s3_q} + (first_s3_q ? 6'h0 : places_strips_q);
      places_rows_q <= rows_before + {4'h0, and_101};
      left_parts_row_seen_q <= not_117 | (left_parts_row_seen_q & not_40_s3_q);
      left_parts_blind_strips_q <= {sum_125, sum_121[1:0]};
      left_parts_blind_rows_q <= {sum_131, sum_127[1:0]};
      right_parts_row_seen_q <= not_137 | (right_parts_row_seen_q & not_40_s3_q);
      right_parts_blind_strips_q <= {sum_145, sum_141[1:0]};
      right_parts_blind_rows_q <= {sum_151, sum_147[1:0]};
    end
  end

  logic first_s4_q;
  logic and_63_s4_q;
  logic [20:0] determinants_s4_q;
  logic select_67_s4_q;
  logic [21:0] sum_68_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s4_q <= first_s3_q;
      and_63_s4_q <= equal_39_s3_q & (~(select_60_s3_q == 6'h0));
      determinants_s4_q <= determinants;
      select_67_s4_q <= select_67_s3_q[0];
      sum_68_s4_q <= sum_68;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/coarse.hpp:80
  logic less_69;
  assign less_69 = $signed({determinants_s4_q, 5'h0}) < $signed({{3{sum_68_s4_q[21]}}, sum_68_s4_q, select_67_s4_q});
  logic [21:0] sum_70;
  assign sum_70 = {determinants_s4_q[20], determinants_s4_q} + {{4{sum_68_s4_q[21]}}, sum_68_s4_q[21:4]};
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

  logic first_s5_q;
  logic and_63_s5_q;
  logic select_67_s5_q;
  logic [3:0] sum_68_s5_q;
  logic less_69_s5_q;
  logic [21:0] sum_70_s5_q;
  logic select_166_s5_q;
  logic select_173_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s5_q <= first_s4_q;
      and_63_s5_q <= and_63_s4_q;
      select_67_s5_q <= select_67_s4_q;
      sum_68_s5_q <= sum_68_s4_q[3:0];
      less_69_s5_q <= less_69;
      sum_70_s5_q <= sum_70;
      select_166_s5_q <= select_166;
      select_173_s5_q <= select_173;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [11:0] segments_missing_q;
  // hls/stages/coarse.hpp:82
  logic [11:0] select_65;
  assign select_65 = first_s5_q ? {4'h0, cfg_one_camera_segments_i} : (segments_missing_q + {12{and_63_s5_q}});
  // hls/stages/coarse.hpp:80
  logic less_71;
  assign less_71 = $signed({sum_70_s5_q, sum_68_s5_q, select_67_s5_q}) < $signed(27'h1);
  logic not_72;
  assign not_72 = ~less_71;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      segments_missing_q <= 12'h0;
    end else if (s5_en) begin
      segments_missing_q <= select_65;
    end
  end

  logic first_s6_q;
  logic [1:0] select_74_s6_q;
  logic select_166_s6_q;
  logic select_173_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s6_q <= first_s5_q;
      select_74_s6_q <= and_63_s5_q ? (less_69_s5_q ? {less_71, not_72} : 2'h2) : 2'h0;
      select_166_s6_q <= select_166_s5_q;
      select_173_s6_q <= select_173_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [12:0] score_q;
  // hls/stages/coarse.hpp:83
  logic [12:0] select_76;
  assign select_76 = first_s6_q ? 13'h0 : (score_q + {{11{select_74_s6_q[1]}}, 1'b0, select_74_s6_q[0]});
  // hls/stages/coarse.hpp:99
  logic and_155;
  assign and_155 = (~(cfg_one_camera_segments_i == 8'h0)) & ($signed(segments_missing_q) < $signed(12'h1));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      score_q <= 13'h0;
    end else if (s6_en) begin
      score_q <= select_76;
    end
  end

  logic and_157_s7_q;
  logic select_166_s7_q;
  logic select_173_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      and_157_s7_q <= and_155 & (~select_76[12]);
      select_166_s7_q <= select_166_s6_q;
      select_173_s7_q <= select_173_s6_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign one_camera_o = and_157_s7_q;
  assign left_blind_o = select_166_s7_q;
  assign right_blind_o = select_173_s7_q;
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
  assign unused_bits = ^sum_106[1:0];

endmodule
