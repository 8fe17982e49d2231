// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::field>, hls/stages/health.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 371 bits, pipeline 29 bits, memories 2048 bits.
module horopter_health (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_i,
  input  logic first_i,
  input  logic end_v_i,
  input  logic last_i,
  input  logic [7:0] cfg_dark_level_i,
  input  logic [7:0] cfg_bright_level_i,
  input  logic [17:0] cfg_dark_limit_i,
  input  logic [17:0] cfg_bright_limit_i,
  input  logic [7:0] cfg_contrast_limit_i,
  input  logic [7:0] cfg_frozen_limit_i,
  output logic valid_o,
  output logic black_o,
  output logic white_o,
  output logic constant_o,
  output logic frozen_o,
  output logic torn_o,
  output logic [31:0] signature_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q;
  logic s0_en, s1_en, s2_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_0_q;
  logic [7:0] left_1_q;
  logic [7:0] left_2_q;
  logic [7:0] left_3_q;
  logic [9:0] x_q;
  logic [3:0] y_q;
  // hls/stages/health.hpp:211
  logic [9:0] place;
  assign place = first_i ? 10'h0 : x_q;
  // hls/stages/health.hpp:216
  logic equal_35;
  assign equal_35 = place[3:0] == 4'hf;
  // hls/stages/health.hpp:213
  logic [3:0] y;
  assign y = first_i ? 4'h0 : y_q;
  // hls/stages/health.hpp:218
  logic [1:0] sum_116;
  assign sum_116 = y[1:0] + y[3:2];

  // Memory above, 64 x 32, DISTANCE 16, hls/stages/health.hpp:278; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] above_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) above_mem[i] = 32'h0;
`endif
  logic [5:0] above_raddr;
  assign above_raddr = place[9:4];
`ifndef SYNTHESIS
  logic above_re;
  assign above_re = s0_en & equal_35;
`endif
  logic [31:0] above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_0_q <= 8'h0;
      left_1_q <= 8'h0;
      left_2_q <= 8'h0;
      left_3_q <= 8'h0;
      x_q <= 10'h0;
      y_q <= 4'h0;
    end else if (s0_en) begin
      left_0_q <= pixel_i;
      left_1_q <= left_0_q;
      left_2_q <= left_1_q;
      left_3_q <= left_2_q;
      x_q <= last_i ? 10'h0 : (place + 10'h1);
      y_q <= last_i ? (y + 4'h1) : y;
    end
  end

  logic first_s1_q;
  logic end_v_s1_q;
  logic last_s1_q;
  logic [7:0] left_3_s1_q;
  logic [5:0] place_s1_q;
  logic equal_35_s1_q;
  logic y_s1_q;
  logic and_120_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      last_s1_q <= last_i;
      left_3_s1_q <= left_3_q;
      place_s1_q <= place[9:4];
      equal_35_s1_q <= equal_35;
      y_s1_q <= y[0];
      and_120_s1_q <= (place[3:0] == {sum_116, y[1:0]}) & (~(place[9:2] == 8'h0));
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [31:0] signature_q;
  logic [7:0] darkest_q;
  logic [7:0] brightest_q;
  logic [17:0] dark_q;
  logic [17:0] bright_q;
  logic [2:0] rows_q;
  logic [19:0] turn_q;
  logic [21:0] aside_q;
  logic [19:0] level_q;
  logic [19:0] pair_q;
  logic [15:0] even_less_odd_q;
  // hls/stages/health.hpp:121
  logic [31:0] select_37;
  assign select_37 = first_s1_q ? 32'h0 : signature_q;
  logic [12:0] xor_38;
  assign xor_38 = {13{select_37[0]}} ^ {select_37[31:30], select_37[28:27], select_37[25:24], select_37[22:20], select_37[16], select_37[10:9], select_37[6]};
  logic [7:0] xor_39;
  assign xor_39 = left_0_q ^ {select_37[8:7], xor_38[0], select_37[5:1]};
  logic parity_40;
  assign parity_40 = ^{select_37[6], select_37[0], left_0_q[5]};
  // hls/stages/health.hpp:123
  logic [7:0] select_72;
  assign select_72 = first_s1_q ? left_0_q : ((left_0_q < darkest_q) ? left_0_q : darkest_q);
  // hls/stages/health.hpp:124
  logic [7:0] select_75;
  assign select_75 = first_s1_q ? left_0_q : ((brightest_q < left_0_q) ? left_0_q : brightest_q);
  logic not_77;
  assign not_77 = ~(cfg_dark_level_i < left_0_q);
  // hls/stages/health.hpp:125
  logic not_81;
  assign not_81 = ~(left_0_q < cfg_bright_level_i);
  // hls/stages/health.hpp:212
  logic [2:0] rows;
  assign rows = first_s1_q ? 3'h0 : rows_q;
  // hls/stages/health.hpp:195
  logic equal_96;
  assign equal_96 = rows[2:1] == 2'h0;
  // hls/stages/health.hpp:175
  logic [8:0] difference_97;
  assign difference_97 = {1'b0, left_0_q} - {1'b0, above_rdata_q[7:0]};
  logic [7:0] xor_98;
  assign xor_98 = difference_97[7:0] ^ {8{difference_97[8]}};
  logic [8:0] sum_99;
  assign sum_99 = {8'h0, difference_97[8]} + {1'b0, xor_98};
  // hls/stages/health.hpp:177
  logic [8:0] sum_100;
  assign sum_100 = sum_99 + 9'h1;
  // hls/stages/health.hpp:176
  logic [8:0] difference_101;
  assign difference_101 = {1'b0, left_0_q} - {1'b0, above_rdata_q[15:8]};
  logic [7:0] xor_102;
  assign xor_102 = difference_101[7:0] ^ {8{difference_101[8]}};
  logic [8:0] sum_103;
  assign sum_103 = {8'h0, difference_101[8]} + {1'b0, xor_102};
  // hls/stages/health.hpp:177
  logic [8:0] sum_105;
  assign sum_105 = sum_103 + 9'h1;
  logic less_106;
  assign less_106 = sum_105 < sum_99;
  // hls/stages/health.hpp:126
  logic [1:0] like;
  assign like = equal_35_s1_q ? (equal_96 ? 2'h0 : ((sum_100 < sum_103) ? 2'h1 : {2{less_106}})) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_110;
  assign equal_110 = like == 2'h1;
  logic equal_111;
  assign equal_111 = like == 2'h3;
  logic or_112;
  assign or_112 = equal_110 | equal_111;
  // hls/stages/health.hpp:201
  logic [19:0] sum_113;
  assign sum_113 = (first_s1_q ? 20'h0 : turn_q) + {{15{equal_110}}, 1'b0, {4{or_112}}};
  // hls/stages/health.hpp:183
  logic [1:0] select_115;
  assign select_115 = equal_110 ? 2'h1 : {2{equal_111}};
  // hls/stages/health.hpp:175
  logic [8:0] difference_121;
  assign difference_121 = {1'b0, left_0_q} - {1'b0, left_2_q};
  logic [7:0] xor_122;
  assign xor_122 = difference_121[7:0] ^ {8{difference_121[8]}};
  logic [8:0] sum_123;
  assign sum_123 = {8'h0, difference_121[8]} + {1'b0, xor_122};
  logic [8:0] difference_125;
  assign difference_125 = {1'b0, left_0_q} - {1'b0, left_3_s1_q};
  logic [7:0] xor_126;
  assign xor_126 = difference_125[7:0] ^ {8{difference_125[8]}};
  logic [8:0] sum_127;
  assign sum_127 = {8'h0, difference_125[8]} + {1'b0, xor_126};
  // hls/stages/health.hpp:177
  logic [8:0] sum_129;
  assign sum_129 = sum_127 + 9'h1;
  logic less_130;
  assign less_130 = sum_129 < sum_123;
  // hls/stages/health.hpp:126
  logic [1:0] select_132;
  assign select_132 = and_120_s1_q ? (((sum_123 + 9'h1) < sum_127) ? 2'h1 : {2{less_130}}) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_134;
  assign equal_134 = select_132 == 2'h3;
  // hls/stages/health.hpp:203
  logic [1:0] select_135;
  assign select_135 = (select_132 == 2'h1) ? 2'h1 : {2{equal_134}};
  logic [8:0] sum_136;
  assign sum_136 = {{2{equal_110}}, select_115[1], equal_110, 1'b0, {4{select_115[0]}}} + {{3{select_135[1]}}, 1'b0, {5{select_135[0]}}};
  // hls/stages/health.hpp:177
  logic less_140;
  assign less_140 = sum_100 < sum_127;
  // hls/stages/health.hpp:126
  logic [1:0] like_2;
  assign like_2 = equal_35_s1_q ? (equal_96 ? 2'h0 : ((sum_129 < sum_99) ? 2'h1 : {2{less_140}})) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_145;
  assign equal_145 = like_2 == 2'h3;
  logic [1:0] select_146;
  assign select_146 = (like_2 == 2'h1) ? 2'h1 : {2{equal_145}};
  // hls/stages/health.hpp:204
  logic [19:0] sum_147;
  assign sum_147 = (first_s1_q ? 20'h0 : level_q) + {{15{select_146[1]}}, 1'b0, {4{select_146[0]}}};
  // hls/stages/health.hpp:176
  logic [8:0] difference_149;
  assign difference_149 = {1'b0, left_0_q} - {1'b0, above_rdata_q[31:24]};
  logic [7:0] xor_150;
  assign xor_150 = difference_149[7:0] ^ {8{difference_149[8]}};
  logic [8:0] sum_151;
  assign sum_151 = {8'h0, difference_149[8]} + {1'b0, xor_150};
  // hls/stages/health.hpp:177
  logic less_154;
  assign less_154 = (sum_151 + 9'h1) < sum_103;
  // hls/stages/health.hpp:126
  logic [1:0] select_157;
  assign select_157 = equal_35_s1_q ? (rows[2] ? ((sum_105 < sum_151) ? 2'h1 : {2{less_154}}) : 2'h0) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_159;
  assign equal_159 = select_157 == 2'h1;
  // hls/stages/health.hpp:205
  logic or_160;
  assign or_160 = (select_157 == 2'h3) | equal_159;
  logic [19:0] sum_161;
  assign sum_161 = (first_s1_q ? 20'h0 : pair_q) + {{15{equal_159}}, 1'b0, {4{or_160}}};
  // hls/stages/health.hpp:207
  logic [2:0] select_164;
  assign select_164 = y_s1_q ? (3'h0 - {like[1], like}) : {like[1], like};
  logic [15:0] sum_165;
  assign sum_165 = (first_s1_q ? 16'h0 : even_less_odd_q) + {{13{select_164[2]}}, select_164};

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = place_s1_q;
  logic above_we;
  assign above_we = s1_en & equal_35_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= {above_rdata_q[23:0], left_0_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && above_we) begin
      if (above_re && above_raddr == above_waddr) begin
        $error("above: address %0d is read less than DISTANCE steps after its write", above_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      signature_q <= 32'h0;
      darkest_q <= 8'h0;
      brightest_q <= 8'h0;
      dark_q <= 18'h0;
      bright_q <= 18'h0;
      rows_q <= 3'h0;
      turn_q <= 20'h0;
      aside_q <= 22'h0;
      level_q <= 20'h0;
      pair_q <= 20'h0;
      even_less_odd_q <= 16'h0;
    end else if (s1_en) begin
      signature_q <= {select_37[0], xor_38[12:11], select_37[29], xor_38[10:9], select_37[26], xor_38[8:7], select_37[23], xor_38[6:4], select_37[19:17], xor_38[3], select_37[15:11], xor_38[2:1], xor_39[7:6], parity_40, xor_39[4:0]};
      darkest_q <= select_72;
      brightest_q <= select_75;
      dark_q <= {17'h0, not_77} + (first_s1_q ? 18'h0 : dark_q);
      bright_q <= {17'h0, not_81} + (first_s1_q ? 18'h0 : bright_q);
      rows_q <= (last_s1_q & (~(rows == 3'h4))) ? (rows + 3'h1) : rows;
      turn_q <= sum_113;
      aside_q <= (first_s1_q ? 22'h0 : aside_q) + {{13{sum_136[8]}}, sum_136};
      level_q <= sum_147;
      pair_q <= sum_161;
      even_less_odd_q <= sum_165;
    end
  end

  logic end_v_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      end_v_s2_q <= end_v_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [31:0] before_0_q;
  logic [31:0] before_1_q;
  logic [31:0] before_2_q;
  logic [31:0] before_3_q;
  logic [3:0] frames_q;
  logic [7:0] repeats_q;
  // hls/stages/health.hpp:134
  logic and_54;
  assign and_54 = ((~frames_q[0]) | (~(before_0_q == signature_q))) & ((~frames_q[1]) | (~(before_1_q == signature_q)));
  // hls/stages/health.hpp:135
  logic and_64;
  assign and_64 = (and_54 & ((~frames_q[2]) | (~(before_2_q == signature_q)))) & ((~frames_q[3]) | (~(before_3_q == signature_q)));
  logic [7:0] select_68;
  assign select_68 = and_64 ? 8'h0 : ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1));
  // hls/stages/health.hpp:139
  logic less_166;
  assign less_166 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:140
  logic less_167;
  assign less_167 = cfg_bright_limit_i < bright_q;
  // hls/stages/health.hpp:141
  logic or_171;
  assign or_171 = less_167 | (less_166 | (cfg_contrast_limit_i < (brightest_q - darkest_q)));
  logic not_172;
  assign not_172 = ~or_171;
  // hls/stages/health.hpp:142
  logic less_174;
  assign less_174 = (cfg_frozen_limit_i + 8'hff) < select_68;
  // hls/stages/health.hpp:145
  logic and_178;
  assign and_178 = ($signed(22'h1f40) < $signed(aside_q)) & ($signed(20'h640) < $signed(level_q));
  // hls/stages/health.hpp:146
  logic [20:0] sum_180;
  assign sum_180 = {pair_q[19], pair_q} + {{2{pair_q[19]}}, pair_q[19:1]};
  logic [14:0] xor_181;
  assign xor_181 = even_less_odd_q[14:0] ^ {15{even_less_odd_q[15]}};
  logic [15:0] sum_182;
  assign sum_182 = {15'h0, even_less_odd_q[15]} + {1'b0, xor_181};
  logic less_183;
  assign less_183 = $signed({{2{sum_180[20]}}, sum_180[20:6]}) < $signed({1'b0, sum_182});
  // hls/stages/health.hpp:147
  logic or_186;
  assign or_186 = ($signed(20'h300) < $signed(turn_q)) | (and_178 | (($signed(20'h640) < $signed(pair_q)) & less_183));
  // hls/stages/health.hpp:149
  logic [4:0] select_187;
  assign select_187 = end_v_s2_q ? {or_186, less_174, not_172, less_167, less_166} : 5'h0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      before_0_q <= 32'h0;
      before_1_q <= 32'h0;
      before_2_q <= 32'h0;
      before_3_q <= 32'h0;
      frames_q <= 4'h0;
      repeats_q <= 8'h0;
    end else if (s2_en) begin
      before_0_q <= end_v_s2_q ? signature_q : before_0_q;
      before_1_q <= end_v_s2_q ? before_0_q : before_1_q;
      before_2_q <= end_v_s2_q ? before_1_q : before_2_q;
      before_3_q <= end_v_s2_q ? before_2_q : before_3_q;
      frames_q <= end_v_s2_q ? {frames_q[2:0], 1'b1} : frames_q;
      repeats_q <= end_v_s2_q ? select_68 : repeats_q;
    end
  end

  logic [4:0] select_187_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      select_187_s3_q <= select_187;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_187_s3_q[0];
  assign white_o = select_187_s3_q[1];
  assign constant_o = select_187_s3_q[2];
  assign frozen_o = select_187_s3_q[3];
  assign torn_o = select_187_s3_q[4];
  assign signature_o = before_0_q;
  assign valid_o = valid_s3_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q & end_v_s2_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_180[5:0], xor_39[5]};

endmodule
