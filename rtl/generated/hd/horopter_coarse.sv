// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Coarse<horopter::hls::profiles::hd>, hls/stages/coarse.hpp. Do not edit.
//
// Latency 7 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 294 bits, pipeline 235 bits, memories 0 bits.
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
  logic s0_en, s2_en, s3_en, s4_en, s5_en, s6_en;
  assign s0_en = en_i & valid_i;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;

  // Of the configuration alone: not pipelined.
  logic [8:0] sum_35;
  assign sum_35 = {1'b0, cfg_blind_step_i} + {2'h0, cfg_blind_step_i[7:1]};
  logic equal_160;
  assign equal_160 = cfg_blind_share_i == 8'h0;

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
  // hls/stages/coarse.hpp:71
  logic [17:0] product_51;
  assign product_51 = $signed({{9{g_s1_q[8]}}, g_s1_q}) * $signed({{9{h_q[8]}}, h_q});
  logic [17:0] product_52;
  assign product_52 = $signed({{9{h_s1_q[8]}}, h_s1_q}) * $signed({{9{g_q[8]}}, g_q});
  // hls/stages/coarse.hpp:72
  logic [17:0] product_57;
  assign product_57 = $signed({{9{g_q[8]}}, g_q}) * $signed({{9{h_q[8]}}, h_q});
  // hls/stages/coarse.hpp:62
  logic [7:0] xor_60;
  assign xor_60 = g_q[7:0] ^ {8{g_q[8]}};
  // hls/stages/coarse.hpp:63
  logic [7:0] xor_86;
  assign xor_86 = h_q[7:0] ^ {8{h_q[8]}};
  // hls/stages/coarse.hpp:145
  logic not_112;
  assign not_112 = ~places_column_q[6];
  logic [3:0] select_113;
  assign select_113 = places_column_q[5] ? {places_column_q[6], 1'b0, not_112, 1'b0} : {1'b0, places_column_q[6], 1'b0, not_112};
  logic [7:0] select_114;
  assign select_114 = places_column_q[4] ? {select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0], 1'b0} : {1'b0, select_113[3], 1'b0, select_113[2], 1'b0, select_113[1], 1'b0, select_113[0]};
  logic [15:0] select_115;
  assign select_115 = places_column_q[3] ? {select_114[7], 1'b0, select_114[6], 1'b0, select_114[5], 1'b0, select_114[4], 1'b0, select_114[3], 1'b0, select_114[2], 1'b0, select_114[1], 1'b0, select_114[0], 1'b0} : {1'b0, select_114[7], 1'b0, select_114[6], 1'b0, select_114[5], 1'b0, select_114[4], 1'b0, select_114[3], 1'b0, select_114[2], 1'b0, select_114[1], 1'b0, select_114[0]};

  logic first_s2_q;
  logic start_s2_q;
  logic [17:0] product_51_s2_q;
  logic [17:0] product_52_s2_q;
  logic [17:0] product_57_s2_q;
  logic [8:0] sum_61_s2_q;
  logic [8:0] sum_87_s2_q;
  logic select_95_s2_q;
  logic equal_96_s2_q;
  logic [15:0] select_115_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s2_q <= first_s1_q;
      start_s2_q <= start_s1_q;
      product_51_s2_q <= product_51;
      product_52_s2_q <= product_52;
      product_57_s2_q <= product_57;
      sum_61_s2_q <= {8'h0, g_q[8]} + {1'b0, xor_60};
      sum_87_s2_q <= {8'h0, h_q[8]} + {1'b0, xor_86};
      select_95_s2_q <= places_column_q[2];
      equal_96_s2_q <= places_column_q[1:0] == 2'h0;
      select_115_s2_q <= select_115;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [6:0] small_step_q;
  logic [2:0] column_q;
  logic second_q;
  logic ended_q;
  logic [20:0] products_q;
  logic [11:0] texture_q;
  logic places_first_row_q;
  logic [31:0] left_parts_strips_q;
  logic [31:0] right_parts_strips_q;
  // hls/stages/coarse.hpp:60
  logic [2:0] select_40;
  assign select_40 = start_s2_q ? 3'h0 : column_q;
  // hls/stages/coarse.hpp:74
  logic equal_42;
  assign equal_42 = select_40 == 3'h7;
  // hls/stages/coarse.hpp:83
  logic or_43;
  assign or_43 = start_s2_q | equal_42;
  // hls/stages/coarse.hpp:60
  logic not_47;
  assign not_47 = ~start_s2_q;
  // hls/stages/coarse.hpp:71
  logic and_50;
  assign and_50 = not_47 & (~(second_q & not_47));
  logic [18:0] difference_53;
  assign difference_53 = {product_51_s2_q[17], product_51_s2_q} - {product_52_s2_q[17], product_52_s2_q};
  // hls/stages/coarse.hpp:72
  logic [17:0] select_58;
  assign select_58 = and_50 ? product_57_s2_q : 18'h0;
  // hls/stages/coarse.hpp:74
  logic [11:0] select_63;
  assign select_63 = and_50 ? (texture_q + {3'h0, sum_61_s2_q}) : texture_q;
  // hls/stages/coarse.hpp:132
  logic and_97;
  assign and_97 = places_first_row_q & not_47;
  // hls/stages/coarse.hpp:64
  logic one_more;
  assign one_more = first_s2_q ? equal_96_s2_q : (and_97 & equal_96_s2_q);
  // hls/stages/coarse.hpp:133
  logic or_106;
  assign or_106 = first_s2_q | and_97;
  // hls/stages/coarse.hpp:138
  logic or_110;
  assign or_110 = start_s2_q | (sum_61_s2_q < {2'h0, small_step_q});
  // hls/stages/coarse.hpp:146
  logic [31:0] seen;
  assign seen = first_s2_q ? 32'h0 : left_parts_strips_q;
  // hls/stages/coarse.hpp:145
  logic [31:0] here;
  assign here = select_95_s2_q ? {select_115_s2_q[15], 1'b0, select_115_s2_q[14], 1'b0, select_115_s2_q[13], 1'b0, select_115_s2_q[12], 1'b0, select_115_s2_q[11], 1'b0, select_115_s2_q[10], 1'b0, select_115_s2_q[9], 1'b0, select_115_s2_q[8], 1'b0, select_115_s2_q[7], 1'b0, select_115_s2_q[6], 1'b0, select_115_s2_q[5], 1'b0, select_115_s2_q[4], 1'b0, select_115_s2_q[3], 1'b0, select_115_s2_q[2], 1'b0, select_115_s2_q[1], 1'b0, select_115_s2_q[0], 1'b0} : {1'b0, select_115_s2_q[15], 1'b0, select_115_s2_q[14], 1'b0, select_115_s2_q[13], 1'b0, select_115_s2_q[12], 1'b0, select_115_s2_q[11], 1'b0, select_115_s2_q[10], 1'b0, select_115_s2_q[9], 1'b0, select_115_s2_q[8], 1'b0, select_115_s2_q[7], 1'b0, select_115_s2_q[6], 1'b0, select_115_s2_q[5], 1'b0, select_115_s2_q[4], 1'b0, select_115_s2_q[3], 1'b0, select_115_s2_q[2], 1'b0, select_115_s2_q[1], 1'b0, select_115_s2_q[0]};
  // hls/stages/coarse.hpp:146
  logic or_135;
  assign or_135 = start_s2_q | (sum_87_s2_q < {2'h0, small_step_q});
  logic [31:0] seen_2;
  assign seen_2 = first_s2_q ? 32'h0 : right_parts_strips_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      small_step_q <= 7'h0;
      column_q <= 3'h0;
      second_q <= 1'b0;
      ended_q <= 1'b0;
      products_q <= 21'h0;
      texture_q <= 12'h0;
      places_first_row_q <= 1'b0;
      left_parts_strips_q <= 32'h0;
      right_parts_strips_q <= 32'h0;
    end else if (s2_en) begin
      small_step_q <= sum_35[8:2];
      column_q <= select_40 + 3'h1;
      second_q <= start_s2_q;
      ended_q <= equal_42 ? or_43 : (start_s2_q & or_43);
      products_q <= (ended_q ? 21'h0 : products_q) + {{3{select_58[17]}}, select_58};
      texture_q <= equal_42 ? 12'h0 : (start_s2_q ? 12'h0 : select_63);
      places_first_row_q <= first_s2_q ? or_106 : (and_97 & or_106);
      left_parts_strips_q <= or_110 ? seen : (here | seen);
      right_parts_strips_q <= or_135 ? seen_2 : (here | seen_2);
    end
  end

  logic first_s3_q;
  logic ended_s3_q;
  logic equal_42_s3_q;
  logic not_47_s3_q;
  logic [18:0] select_54_s3_q;
  logic not_67_s3_q;
  logic not_82_s3_q;
  logic not_90_s3_q;
  logic one_more_s3_q;
  logic or_110_s3_q;
  logic equal_125_s3_q;
  logic or_135_s3_q;
  logic equal_145_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s3_q <= first_s2_q;
      ended_s3_q <= ended_q;
      equal_42_s3_q <= equal_42;
      not_47_s3_q <= not_47;
      select_54_s3_q <= and_50 ? difference_53 : 19'h0;
      not_67_s3_q <= ~(select_63[11:6] == 6'h0);
      not_82_s3_q <= ~(start_s2_q | (sum_61_s2_q < {1'b0, cfg_blind_step_i}));
      not_90_s3_q <= ~(start_s2_q | (sum_87_s2_q < {1'b0, cfg_blind_step_i}));
      one_more_s3_q <= one_more;
      or_110_s3_q <= or_110;
      equal_125_s3_q <= (here & seen) == 32'h0;
      or_135_s3_q <= or_135;
      equal_145_s3_q <= (here & seen_2) == 32'h0;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [20:0] determinants_q;
  logic [5:0] places_strips_q;
  logic [4:0] places_rows_q;
  logic left_parts_row_seen_q;
  logic [9:0] left_parts_blind_strips_q;
  logic [9:0] left_parts_blind_rows_q;
  logic right_parts_row_seen_q;
  logic [9:0] right_parts_blind_strips_q;
  logic [9:0] right_parts_blind_rows_q;
  // hls/stages/coarse.hpp:71
  logic [20:0] determinants;
  assign determinants = (ended_s3_q ? 21'h0 : determinants_q) + {{2{select_54_s3_q[18]}}, select_54_s3_q};
  // hls/stages/coarse.hpp:77
  logic [21:0] sum_71;
  assign sum_71 = {products_q[20], products_q} + {{2{products_q[20]}}, products_q[20:1]};
  // hls/stages/coarse.hpp:135
  logic [4:0] rows_before;
  assign rows_before = first_s3_q ? 5'h0 : places_rows_q;
  // hls/stages/coarse.hpp:136
  logic and_104;
  assign and_104 = second_q & (~rows_before[4]);
  // hls/stages/coarse.hpp:147
  logic not_119;
  assign not_119 = ~or_110_s3_q;
  // hls/stages/coarse.hpp:163
  logic [9:0] sum_123;
  assign sum_123 = {8'h0, {2{one_more_s3_q}}} + (first_s3_q ? 10'h0 : left_parts_blind_strips_q);
  // hls/stages/coarse.hpp:65
  logic and_126;
  assign and_126 = not_119 & equal_125_s3_q;
  // hls/stages/coarse.hpp:163
  logic [7:0] sum_127;
  assign sum_127 = {8{and_126}} + sum_123[9:2];
  logic [9:0] sum_129;
  assign sum_129 = {8'h0, {2{second_q}}} + (first_s3_q ? 10'h0 : left_parts_blind_rows_q);
  logic not_132;
  assign not_132 = ~((second_q | or_110_s3_q) ? or_110_s3_q : left_parts_row_seen_q);
  logic [7:0] sum_133;
  assign sum_133 = sum_129[9:2] + {8{not_132}};
  // hls/stages/coarse.hpp:147
  logic not_139;
  assign not_139 = ~or_135_s3_q;
  // hls/stages/coarse.hpp:163
  logic [9:0] sum_143;
  assign sum_143 = {8'h0, {2{one_more_s3_q}}} + (first_s3_q ? 10'h0 : right_parts_blind_strips_q);
  // hls/stages/coarse.hpp:66
  logic and_146;
  assign and_146 = not_139 & equal_145_s3_q;
  // hls/stages/coarse.hpp:163
  logic [7:0] sum_147;
  assign sum_147 = {8{and_146}} + sum_143[9:2];
  logic [9:0] sum_149;
  assign sum_149 = {8'h0, {2{second_q}}} + (first_s3_q ? 10'h0 : right_parts_blind_rows_q);
  logic not_152;
  assign not_152 = ~((second_q | or_135_s3_q) ? or_135_s3_q : right_parts_row_seen_q);
  logic [7:0] sum_153;
  assign sum_153 = sum_149[9:2] + {8{not_152}};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      determinants_q <= 21'h0;
      places_strips_q <= 6'h0;
      places_rows_q <= 5'h0;
      left_parts_row_seen_q <= 1'b0;
      left_parts_blind_strips_q <= 10'h0;
      left_parts_blind_rows_q <= 10'h0;
      right_parts_row_seen_q <= 1'b0;
      right_parts_blind_strips_q <= 10'h0;
      right_parts_blind_rows_q <= 10'h0;
    end else if (s3_en) begin
      determinants_q <= determinants;
      places_strips_q <= {5'h0, one_more_s3_q} + (first_s3_q ? 6'h0 : places_strips_q);
      places_rows_q <= rows_before + {4'h0, and_104};
      left_parts_row_seen_q <= not_119 | (left_parts_row_seen_q & not_47_s3_q);
      left_parts_blind_strips_q <= {sum_127, sum_123[1:0]};
      left_parts_blind_rows_q <= {sum_133, sum_129[1:0]};
      right_parts_row_seen_q <= not_139 | (right_parts_row_seen_q & not_47_s3_q);
      right_parts_blind_strips_q <= {sum_147, sum_143[1:0]};
      right_parts_blind_rows_q <= {sum_153, sum_149[1:0]};
    end
  end

  logic first_s4_q;
  logic sum_59_s4_q;
  logic and_68_s4_q;
  logic [21:0] sum_71_s4_q;
  logic [9:0] difference_83_s4_q;
  logic [9:0] difference_91_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s4_q <= first_s3_q;
      sum_59_s4_q <= products_q[0];
      and_68_s4_q <= equal_42_s3_q & not_67_s3_q;
      sum_71_s4_q <= sum_71;
      difference_83_s4_q <= {1'b0, not_82_s3_q, 8'h0} - {2'h0, cfg_blind_share_i};
      difference_91_s4_q <= {1'b0, not_90_s3_q, 8'h0} - {2'h0, cfg_blind_share_i};
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [21:0] left_steps_balance_q;
  logic [21:0] right_steps_balance_q;
  // hls/stages/coarse.hpp:78
  logic less_72;
  assign less_72 = $signed({determinants_q, 5'h0}) < $signed({{3{sum_71_s4_q[21]}}, sum_71_s4_q, sum_59_s4_q});
  logic [21:0] sum_73;
  assign sum_73 = {determinants_q[20], determinants_q} + {{4{sum_71_s4_q[21]}}, sum_71_s4_q[21:4]};
  // hls/stages/coarse.hpp:107
  logic [21:0] sum_85;
  assign sum_85 = {{12{difference_83_s4_q[9]}}, difference_83_s4_q} + (first_s4_q ? 22'h0 : left_steps_balance_q);
  logic [21:0] sum_93;
  assign sum_93 = {{12{difference_91_s4_q[9]}}, difference_91_s4_q} + (first_s4_q ? 22'h0 : right_steps_balance_q);
  // hls/stages/coarse.hpp:155
  logic equal_164;
  assign equal_164 = places_strips_q[5:3] == 3'h0;
  // hls/stages/coarse.hpp:109
  logic or_167;
  assign or_167 = (places_rows_q[4] & (~left_parts_blind_rows_q[9])) | (~(left_parts_blind_strips_q[9] | equal_164));
  // hls/stages/coarse.hpp:94
  logic or_174;
  assign or_174 = (places_rows_q[4] & (~right_parts_blind_rows_q[9])) | (~(right_parts_blind_strips_q[9] | equal_164));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_steps_balance_q <= 22'h0;
      right_steps_balance_q <= 22'h0;
    end else if (s4_en) begin
      left_steps_balance_q <= sum_85;
      right_steps_balance_q <= sum_93;
    end
  end

  logic first_s5_q;
  logic sum_59_s5_q;
  logic and_68_s5_q;
  logic [3:0] sum_71_s5_q;
  logic less_72_s5_q;
  logic [21:0] sum_73_s5_q;
  logic or_167_s5_q;
  logic or_174_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s5_q <= first_s4_q;
      sum_59_s5_q <= sum_59_s4_q;
      and_68_s5_q <= and_68_s4_q;
      sum_71_s5_q <= sum_71_s4_q[3:0];
      less_72_s5_q <= less_72;
      sum_73_s5_q <= sum_73;
      or_167_s5_q <= or_167;
      or_174_s5_q <= or_174;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [11:0] segments_missing_q;
  // hls/stages/coarse.hpp:80
  logic [11:0] select_70;
  assign select_70 = first_s5_q ? {4'h0, cfg_one_camera_segments_i} : (segments_missing_q + {12{and_68_s5_q}});
  // hls/stages/coarse.hpp:78
  logic less_74;
  assign less_74 = $signed({sum_73_s5_q, sum_71_s5_q, sum_59_s5_q}) < $signed(27'h1);
  logic not_75;
  assign not_75 = ~less_74;
  // hls/stages/coarse.hpp:109
  logic select_168;
  assign select_168 = (left_steps_balance_q[21] | equal_160) ? left_steps_balance_q[21] : or_167_s5_q;
  // hls/stages/coarse.hpp:94
  logic select_175;
  assign select_175 = (right_steps_balance_q[21] | equal_160) ? right_steps_balance_q[21] : or_174_s5_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      segments_missing_q <= 12'h0;
    end else if (s5_en) begin
      segments_missing_q <= select_70;
    end
  end

  logic first_s6_q;
  logic [1:0] select_77_s6_q;
  logic select_168_s6_q;
  logic select_175_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s6_q <= first_s5_q;
      select_77_s6_q <= and_68_s5_q ? (less_72_s5_q ? {less_74, not_75} : 2'h2) : 2'h0;
      select_168_s6_q <= select_168;
      select_175_s6_q <= select_175;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [12:0] score_q;
  // hls/stages/coarse.hpp:81
  logic [12:0] select_79;
  assign select_79 = first_s6_q ? 13'h0 : (score_q + {{11{select_77_s6_q[1]}}, 1'b0, select_77_s6_q[0]});
  // hls/stages/coarse.hpp:94
  logic and_157;
  assign and_157 = (~(cfg_one_camera_segments_i == 8'h0)) & ($signed(segments_missing_q) < $signed(12'h1));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      score_q <= 13'h0;
    end else if (s6_en) begin
      score_q <= select_79;
    end
  end

  logic and_159_s7_q;
  logic select_168_s7_q;
  logic select_175_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      and_159_s7_q <= and_157 & (~select_79[12]);
      select_168_s7_q <= select_168_s6_q;
      select_175_s7_q <= select_175_s6_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign one_camera_o = and_159_s7_q;
  assign left_blind_o = select_168_s7_q;
  assign right_blind_o = select_175_s7_q;
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
  assign unused_bits = ^sum_35[1:0];

endmodule
