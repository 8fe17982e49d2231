// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::vga>, hls/stages/health.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 295 bits, pipeline 29 bits, memories 2048 bits.
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
  input  logic [18:0] cfg_dark_limit_i,
  input  logic [18:0] cfg_bright_limit_i,
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
  logic [9:0] x_q;
  logic [3:0] y_q;
  // hls/stages/health.hpp:211
  logic [9:0] place;
  assign place = first_i ? 10'h0 : x_q;
  // hls/stages/health.hpp:216
  logic equal_31;
  assign equal_31 = place[3:0] == 4'hf;
  // hls/stages/health.hpp:213
  logic [3:0] y;
  assign y = first_i ? 4'h0 : y_q;
  // hls/stages/health.hpp:218
  logic [1:0] sum_100;
  assign sum_100 = y[1:0] + y[3:2];

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
  assign above_re = s0_en & equal_31;
`endif
  logic [31:0] above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_0_q <= 8'h0;
      left_1_q <= 8'h0;
      x_q <= 10'h0;
      y_q <= 4'h0;
    end else if (s0_en) begin
      left_0_q <= pixel_i;
      left_1_q <= left_0_q;
      x_q <= last_i ? 10'h0 : (place + 10'h1);
      y_q <= last_i ? (y + 4'h1) : y;
    end
  end

  logic first_s1_q;
  logic end_v_s1_q;
  logic last_s1_q;
  logic [7:0] left_1_s1_q;
  logic [5:0] place_s1_q;
  logic equal_31_s1_q;
  logic y_s1_q;
  logic and_104_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      last_s1_q <= last_i;
      left_1_s1_q <= left_1_q;
      place_s1_q <= place[9:4];
      equal_31_s1_q <= equal_31;
      y_s1_q <= y[0];
      and_104_s1_q <= (place[3:0] == {sum_100, y[1:0]}) & (~(place[9:1] == 9'h0));
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [31:0] signature_q;
  logic [7:0] darkest_q;
  logic [7:0] brightest_q;
  logic [18:0] dark_q;
  logic [18:0] bright_q;
  logic [2:0] rows_q;
  logic [20:0] turn_q;
  logic [22:0] aside_q;
  logic [20:0] level_q;
  logic [20:0] pair_q;
  logic [15:0] even_less_odd_q;
  // hls/stages/health.hpp:121
  logic [31:0] select_33;
  assign select_33 = first_s1_q ? 32'h0 : signature_q;
  logic [12:0] xor_34;
  assign xor_34 = {13{select_33[0]}} ^ {select_33[31:30], select_33[28:27], select_33[25:24], select_33[22:20], select_33[16], select_33[10:9], select_33[6]};
  logic [7:0] xor_35;
  assign xor_35 = left_0_q ^ {select_33[8:7], xor_34[0], select_33[5:1]};
  logic parity_36;
  assign parity_36 = ^{select_33[6], select_33[0], left_0_q[5]};
  // hls/stages/health.hpp:123
  logic [7:0] select_56;
  assign select_56 = first_s1_q ? left_0_q : ((left_0_q < darkest_q) ? left_0_q : darkest_q);
  // hls/stages/health.hpp:124
  logic [7:0] select_59;
  assign select_59 = first_s1_q ? left_0_q : ((brightest_q < left_0_q) ? left_0_q : brightest_q);
  logic not_61;
  assign not_61 = ~(cfg_dark_level_i < left_0_q);
  // hls/stages/health.hpp:125
  logic not_65;
  assign not_65 = ~(left_0_q < cfg_bright_level_i);
  // hls/stages/health.hpp:212
  logic [2:0] rows;
  assign rows = first_s1_q ? 3'h0 : rows_q;
  // hls/stages/health.hpp:195
  logic equal_80;
  assign equal_80 = rows[2:1] == 2'h0;
  // hls/stages/health.hpp:175
  logic [8:0] difference_81;
  assign difference_81 = {1'b0, left_0_q} - {1'b0, above_rdata_q[7:0]};
  logic [7:0] xor_82;
  assign xor_82 = difference_81[7:0] ^ {8{difference_81[8]}};
  logic [8:0] sum_83;
  assign sum_83 = {8'h0, difference_81[8]} + {1'b0, xor_82};
  // hls/stages/health.hpp:177
  logic [8:0] sum_84;
  assign sum_84 = sum_83 + 9'h1;
  // hls/stages/health.hpp:176
  logic [8:0] difference_85;
  assign difference_85 = {1'b0, left_0_q} - {1'b0, above_rdata_q[15:8]};
  logic [7:0] xor_86;
  assign xor_86 = difference_85[7:0] ^ {8{difference_85[8]}};
  logic [8:0] sum_87;
  assign sum_87 = {8'h0, difference_85[8]} + {1'b0, xor_86};
  // hls/stages/health.hpp:177
  logic [8:0] sum_89;
  assign sum_89 = sum_87 + 9'h1;
  logic less_90;
  assign less_90 = sum_89 < sum_83;
  // hls/stages/health.hpp:126
  logic [1:0] like;
  assign like = equal_31_s1_q ? (equal_80 ? 2'h0 : ((sum_84 < sum_87) ? 2'h1 : {2{less_90}})) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_94;
  assign equal_94 = like == 2'h1;
  logic equal_95;
  assign equal_95 = like == 2'h3;
  logic or_96;
  assign or_96 = equal_94 | equal_95;
  // hls/stages/health.hpp:201
  logic [20:0] sum_97;
  assign sum_97 = (first_s1_q ? 21'h0 : turn_q) + {{16{equal_94}}, 1'b0, {4{or_96}}};
  // hls/stages/health.hpp:183
  logic [1:0] select_99;
  assign select_99 = equal_94 ? 2'h1 : {2{equal_95}};
  // hls/stages/health.hpp:175
  logic [8:0] difference_105;
  assign difference_105 = {1'b0, left_0_q} - {1'b0, left_1_q};
  logic [7:0] xor_106;
  assign xor_106 = difference_105[7:0] ^ {8{difference_105[8]}};
  logic [8:0] sum_107;
  assign sum_107 = {8'h0, difference_105[8]} + {1'b0, xor_106};
  logic [8:0] difference_109;
  assign difference_109 = {1'b0, left_0_q} - {1'b0, left_1_s1_q};
  logic [7:0] xor_110;
  assign xor_110 = difference_109[7:0] ^ {8{difference_109[8]}};
  logic [8:0] sum_111;
  assign sum_111 = {8'h0, difference_109[8]} + {1'b0, xor_110};
  // hls/stages/health.hpp:177
  logic [8:0] sum_113;
  assign sum_113 = sum_111 + 9'h1;
  logic less_114;
  assign less_114 = sum_113 < sum_107;
  // hls/stages/health.hpp:126
  logic [1:0] select_116;
  assign select_116 = and_104_s1_q ? (((sum_107 + 9'h1) < sum_111) ? 2'h1 : {2{less_114}}) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_118;
  assign equal_118 = select_116 == 2'h3;
  // hls/stages/health.hpp:203
  logic [1:0] select_119;
  assign select_119 = (select_116 == 2'h1) ? 2'h1 : {2{equal_118}};
  logic [8:0] sum_120;
  assign sum_120 = {{2{equal_94}}, select_99[1], equal_94, 1'b0, {4{select_99[0]}}} + {{3{select_119[1]}}, 1'b0, {5{select_119[0]}}};
  // hls/stages/health.hpp:177
  logic less_124;
  assign less_124 = sum_84 < sum_111;
  // hls/stages/health.hpp:126
  logic [1:0] like_2;
  assign like_2 = equal_31_s1_q ? (equal_80 ? 2'h0 : ((sum_113 < sum_83) ? 2'h1 : {2{less_124}})) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_129;
  assign equal_129 = like_2 == 2'h3;
  logic [1:0] select_130;
  assign select_130 = (like_2 == 2'h1) ? 2'h1 : {2{equal_129}};
  // hls/stages/health.hpp:204
  logic [20:0] sum_131;
  assign sum_131 = (first_s1_q ? 21'h0 : level_q) + {{16{select_130[1]}}, 1'b0, {4{select_130[0]}}};
  // hls/stages/health.hpp:176
  logic [8:0] difference_133;
  assign difference_133 = {1'b0, left_0_q} - {1'b0, above_rdata_q[31:24]};
  logic [7:0] xor_134;
  assign xor_134 = difference_133[7:0] ^ {8{difference_133[8]}};
  logic [8:0] sum_135;
  assign sum_135 = {8'h0, difference_133[8]} + {1'b0, xor_134};
  // hls/stages/health.hpp:177
  logic less_138;
  assign less_138 = (sum_135 + 9'h1) < sum_87;
  // hls/stages/health.hpp:126
  logic [1:0] select_141;
  assign select_141 = equal_31_s1_q ? (rows[2] ? ((sum_89 < sum_135) ? 2'h1 : {2{less_138}}) : 2'h0) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_143;
  assign equal_143 = select_141 == 2'h1;
  // hls/stages/health.hpp:205
  logic or_144;
  assign or_144 = (select_141 == 2'h3) | equal_143;
  logic [20:0] sum_145;
  assign sum_145 = (first_s1_q ? 21'h0 : pair_q) + {{16{equal_143}}, 1'b0, {4{or_144}}};
  // hls/stages/health.hpp:207
  logic [2:0] select_148;
  assign select_148 = y_s1_q ? (3'h0 - {like[1], like}) : {like[1], like};
  logic [15:0] sum_149;
  assign sum_149 = (first_s1_q ? 16'h0 : even_less_odd_q) + {{13{select_148[2]}}, select_148};

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = place_s1_q;
  logic above_we;
  assign above_we = s1_en & equal_31_s1_q;
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
      dark_q <= 19'h0;
      bright_q <= 19'h0;
      rows_q <= 3'h0;
      turn_q <= 21'h0;
      aside_q <= 23'h0;
      level_q <= 21'h0;
      pair_q <= 21'h0;
      even_less_odd_q <= 16'h0;
    end else if (s1_en) begin
      signature_q <= {select_33[0], xor_34[12:11], select_33[29], xor_34[10:9], select_33[26], xor_34[8:7], select_33[23], xor_34[6:4], select_33[19:17], xor_34[3], select_33[15:11], xor_34[2:1], xor_35[7:6], parity_36, xor_35[4:0]};
      darkest_q <= select_56;
      brightest_q <= select_59;
      dark_q <= {18'h0, not_61} + (first_s1_q ? 19'h0 : dark_q);
      bright_q <= {18'h0, not_65} + (first_s1_q ? 19'h0 : bright_q);
      rows_q <= (last_s1_q & (~(rows == 3'h4))) ? (rows + 3'h1) : rows;
      turn_q <= sum_97;
      aside_q <= (first_s1_q ? 23'h0 : aside_q) + {{14{sum_120[8]}}, sum_120};
      level_q <= sum_131;
      pair_q <= sum_145;
      even_less_odd_q <= sum_149;
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
  logic [1:0] frames_q;
  logic [7:0] repeats_q;
  // hls/stages/health.hpp:135
  logic and_48;
  assign and_48 = ((~frames_q[0]) | (~(before_0_q == signature_q))) & ((~frames_q[1]) | (~(before_1_q == signature_q)));
  logic [7:0] select_52;
  assign select_52 = and_48 ? 8'h0 : ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1));
  // hls/stages/health.hpp:139
  logic less_150;
  assign less_150 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:140
  logic less_151;
  assign less_151 = cfg_bright_limit_i < bright_q;
  // hls/stages/health.hpp:141
  logic or_155;
  assign or_155 = less_151 | (less_150 | (cfg_contrast_limit_i < (brightest_q - darkest_q)));
  logic not_156;
  assign not_156 = ~or_155;
  // hls/stages/health.hpp:142
  logic less_158;
  assign less_158 = (cfg_frozen_limit_i + 8'hff) < select_52;
  // hls/stages/health.hpp:145
  logic and_162;
  assign and_162 = ($signed(23'h1f40) < $signed(aside_q)) & ($signed(21'h640) < $signed(level_q));
  // hls/stages/health.hpp:146
  logic [21:0] sum_164;
  assign sum_164 = {pair_q[20], pair_q} + {{2{pair_q[20]}}, pair_q[20:1]};
  logic [14:0] xor_165;
  assign xor_165 = even_less_odd_q[14:0] ^ {15{even_less_odd_q[15]}};
  logic [15:0] sum_166;
  assign sum_166 = {15'h0, even_less_odd_q[15]} + {1'b0, xor_165};
  // hls/stages/health.hpp:147
  logic and_168;
  assign and_168 = ($signed(21'h640) < $signed(pair_q)) & ($signed({sum_164[21], sum_164[21:6]}) < $signed({1'b0, sum_166}));
  logic or_170;
  assign or_170 = ($signed(21'h300) < $signed(turn_q)) | (and_162 | and_168);
  // hls/stages/health.hpp:149
  logic [4:0] select_171;
  assign select_171 = end_v_s2_q ? {or_170, less_158, not_156, less_151, less_150} : 5'h0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      before_0_q <= 32'h0;
      before_1_q <= 32'h0;
      frames_q <= 2'h0;
      repeats_q <= 8'h0;
    end else if (s2_en) begin
      before_0_q <= end_v_s2_q ? signature_q : before_0_q;
      before_1_q <= end_v_s2_q ? before_0_q : before_1_q;
      frames_q <= end_v_s2_q ? {frames_q[0], 1'b1} : frames_q;
      repeats_q <= end_v_s2_q ? select_52 : repeats_q;
    end
  end

  logic [4:0] select_171_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      select_171_s3_q <= select_171;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_171_s3_q[0];
  assign white_o = select_171_s3_q[1];
  assign constant_o = select_171_s3_q[2];
  assign frozen_o = select_171_s3_q[3];
  assign torn_o = select_171_s3_q[4];
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
  assign unused_bits = ^{sum_164[5:0], xor_35[5]};

endmodule
