// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::hd>, hls/stages/health.hpp. Do not edit.
//
// Latency 11 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 307 bits, pipeline 394 bits, memories 2048 bits.
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
  input  logic [20:0] cfg_dark_limit_i,
  input  logic [20:0] cfg_bright_limit_i,
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q;
  logic s0_en, s1_en, s3_en, s5_en, s7_en, s8_en, s9_en, s10_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s3_en = en_i & valid_s3_q;
  assign s5_en = en_i & valid_s5_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;
  assign s9_en = en_i & valid_s9_q;
  assign s10_en = en_i & valid_s10_q;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] x_q;
  logic [4:0] y_q;
  // hls/stages/health.hpp:211
  logic [10:0] place;
  assign place = first_i ? 11'h0 : x_q;
  // hls/stages/health.hpp:213
  logic [4:0] y;
  assign y = first_i ? 5'h0 : y_q;
  // hls/stages/health.hpp:218
  logic [2:0] sum_100;
  assign sum_100 = y[2:0] + y[4:2];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= 11'h0;
      y_q <= 5'h0;
    end else if (s0_en) begin
      x_q <= last_i ? 11'h0 : (place + 11'h1);
      y_q <= last_i ? (y + 5'h1) : y;
    end
  end

  logic [7:0] pixel_s1_q;
  logic first_s1_q;
  logic end_v_s1_q;
  logic last_s1_q;
  logic [5:0] place_s1_q;
  logic equal_31_s1_q;
  logic y_s1_q;
  logic equal_101_s1_q;
  logic not_103_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s1_q <= pixel_i;
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      last_s1_q <= last_i;
      place_s1_q <= place[10:5];
      equal_31_s1_q <= place[4:0] == 5'h1f;
      y_s1_q <= y[0];
      equal_101_s1_q <= place[4:0] == {sum_100, y[1:0]};
      not_103_s1_q <= ~(place[10:1] == 10'h0);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  // Memory above, 64 x 32, DISTANCE 16, hls/stages/health.hpp:278; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] above_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) above_mem[i] = 32'h0;
`endif
  logic [5:0] above_raddr;
  assign above_raddr = place_s1_q;
`ifndef SYNTHESIS
  logic above_re;
  assign above_re = s1_en & equal_31_s1_q;
`endif
  logic [31:0] above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) above_rdata_q <= above_mem[above_raddr];
  end

  logic [7:0] pixel_s2_q;
  logic first_s2_q;
  logic end_v_s2_q;
  logic last_s2_q;
  logic [5:0] place_s2_q;
  logic equal_31_s2_q;
  logic y_s2_q;
  logic and_104_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s2_q <= pixel_s1_q;
      first_s2_q <= first_s1_q;
      end_v_s2_q <= end_v_s1_q;
      last_s2_q <= last_s1_q;
      place_s2_q <= place_s1_q;
      equal_31_s2_q <= equal_31_s1_q;
      y_s2_q <= y_s1_q;
      and_104_s2_q <= equal_101_s1_q & not_103_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------

  logic [7:0] pixel_s3_q;
  logic first_s3_q;
  logic end_v_s3_q;
  logic last_s3_q;
  logic [5:0] place_s3_q;
  logic equal_31_s3_q;
  logic [31:0] above_rdata_s3_q;
  logic y_s3_q;
  logic and_104_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s3_q <= pixel_s2_q;
      first_s3_q <= first_s2_q;
      end_v_s3_q <= end_v_s2_q;
      last_s3_q <= last_s2_q;
      place_s3_q <= place_s2_q;
      equal_31_s3_q <= equal_31_s2_q;
      above_rdata_s3_q <= above_rdata_q;
      y_s3_q <= y_s2_q;
      and_104_s3_q <= and_104_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_0_q;
  logic [7:0] left_1_q;
  // hls/stages/health.hpp:175
  logic [8:0] difference_81;
  assign difference_81 = {1'b0, pixel_s3_q} - {1'b0, above_rdata_s3_q[7:0]};
  // hls/stages/health.hpp:176
  logic [8:0] difference_85;
  assign difference_85 = {1'b0, pixel_s3_q} - {1'b0, above_rdata_s3_q[15:8]};
  // hls/stages/health.hpp:175
  logic [8:0] difference_105;
  assign difference_105 = {1'b0, pixel_s3_q} - {1'b0, left_0_q};
  logic [8:0] difference_109;
  assign difference_109 = {1'b0, pixel_s3_q} - {1'b0, left_1_q};
  // hls/stages/health.hpp:176
  logic [8:0] difference_133;
  assign difference_133 = {1'b0, pixel_s3_q} - {1'b0, above_rdata_s3_q[31:24]};

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = place_s3_q;
  logic above_we;
  assign above_we = s3_en & equal_31_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= {above_rdata_s3_q[23:0], pixel_s3_q};
  end
`ifndef SYNTHESIS
  logic [5:0] above_raddr_s2_sim;
  logic above_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      above_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      above_re_s2_sim <= above_re;
      above_raddr_s2_sim <= above_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && above_we) begin
      if (above_re && above_raddr == above_waddr) begin
        $error("above: address %0d is read less than DISTANCE steps after its write", above_waddr);
      end
      if (above_re_s2_sim && above_raddr_s2_sim == above_waddr) begin
        $error("above: address %0d is read less than DISTANCE steps after its write", above_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_0_q <= 8'h0;
      left_1_q <= 8'h0;
    end else if (s3_en) begin
      left_0_q <= pixel_s3_q;
      left_1_q <= left_0_q;
    end
  end

  logic first_s4_q;
  logic end_v_s4_q;
  logic last_s4_q;
  logic equal_31_s4_q;
  logic y_s4_q;
  logic difference_81_s4_q;
  logic [7:0] xor_82_s4_q;
  logic difference_85_s4_q;
  logic [7:0] xor_86_s4_q;
  logic and_104_s4_q;
  logic difference_105_s4_q;
  logic [7:0] xor_106_s4_q;
  logic difference_109_s4_q;
  logic [7:0] xor_110_s4_q;
  logic difference_133_s4_q;
  logic [7:0] xor_134_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s4_q <= first_s3_q;
      end_v_s4_q <= end_v_s3_q;
      last_s4_q <= last_s3_q;
      equal_31_s4_q <= equal_31_s3_q;
      y_s4_q <= y_s3_q;
      difference_81_s4_q <= difference_81[8];
      xor_82_s4_q <= difference_81[7:0] ^ {8{difference_81[8]}};
      difference_85_s4_q <= difference_85[8];
      xor_86_s4_q <= difference_85[7:0] ^ {8{difference_85[8]}};
      and_104_s4_q <= and_104_s3_q;
      difference_105_s4_q <= difference_105[8];
      xor_106_s4_q <= difference_105[7:0] ^ {8{difference_105[8]}};
      difference_109_s4_q <= difference_109[8];
      xor_110_s4_q <= difference_109[7:0] ^ {8{difference_109[8]}};
      difference_133_s4_q <= difference_133[8];
      xor_134_s4_q <= difference_133[7:0] ^ {8{difference_133[8]}};
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------

  logic [7:0] pixel_s5_q;
  logic first_s5_q;
  logic end_v_s5_q;
  logic last_s5_q;
  logic equal_31_s5_q;
  logic y_s5_q;
  logic [8:0] sum_83_s5_q;
  logic [8:0] sum_87_s5_q;
  logic and_104_s5_q;
  logic [8:0] sum_107_s5_q;
  logic [8:0] sum_111_s5_q;
  logic [8:0] sum_135_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s5_q <= left_0_q;
      first_s5_q <= first_s4_q;
      end_v_s5_q <= end_v_s4_q;
      last_s5_q <= last_s4_q;
      equal_31_s5_q <= equal_31_s4_q;
      y_s5_q <= y_s4_q;
      sum_83_s5_q <= {8'h0, difference_81_s4_q} + {1'b0, xor_82_s4_q};
      sum_87_s5_q <= {8'h0, difference_85_s4_q} + {1'b0, xor_86_s4_q};
      and_104_s5_q <= and_104_s4_q;
      sum_107_s5_q <= {8'h0, difference_105_s4_q} + {1'b0, xor_106_s4_q};
      sum_111_s5_q <= {8'h0, difference_109_s4_q} + {1'b0, xor_110_s4_q};
      sum_135_s5_q <= {8'h0, difference_133_s4_q} + {1'b0, xor_134_s4_q};
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [2:0] rows_q;
  // hls/stages/health.hpp:212
  logic [2:0] rows;
  assign rows = first_s5_q ? 3'h0 : rows_q;
  // hls/stages/health.hpp:177
  logic [8:0] sum_84;
  assign sum_84 = sum_83_s5_q + 9'h1;
  logic [8:0] sum_89;
  assign sum_89 = sum_87_s5_q + 9'h1;
  logic [8:0] sum_113;
  assign sum_113 = sum_111_s5_q + 9'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      rows_q <= 3'h0;
    end else if (s5_en) begin
      rows_q <= (last_s5_q & (~(rows == 3'h4))) ? (rows + 3'h1) : rows;
    end
  end

  logic [7:0] pixel_s6_q;
  logic first_s6_q;
  logic end_v_s6_q;
  logic equal_31_s6_q;
  logic y_s6_q;
  logic rows_s6_q;
  logic equal_80_s6_q;
  logic less_88_s6_q;
  logic less_90_s6_q;
  logic and_104_s6_q;
  logic less_112_s6_q;
  logic less_114_s6_q;
  logic less_123_s6_q;
  logic less_124_s6_q;
  logic less_136_s6_q;
  logic less_138_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s6_q <= pixel_s5_q;
      first_s6_q <= first_s5_q;
      end_v_s6_q <= end_v_s5_q;
      equal_31_s6_q <= equal_31_s5_q;
      y_s6_q <= y_s5_q;
      rows_s6_q <= rows[2];
      equal_80_s6_q <= rows[2:1] == 2'h0;
      less_88_s6_q <= sum_84 < sum_87_s5_q;
      less_90_s6_q <= sum_89 < sum_83_s5_q;
      and_104_s6_q <= and_104_s5_q;
      less_112_s6_q <= (sum_107_s5_q + 9'h1) < sum_111_s5_q;
      less_114_s6_q <= sum_113 < sum_107_s5_q;
      less_123_s6_q <= sum_113 < sum_83_s5_q;
      less_124_s6_q <= sum_84 < sum_111_s5_q;
      less_136_s6_q <= sum_89 < sum_135_s5_q;
      less_138_s6_q <= (sum_135_s5_q + 9'h1) < sum_87_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/health.hpp:126
  logic [1:0] like;
  assign like = equal_31_s6_q ? (equal_80_s6_q ? 2'h0 : (less_88_s6_q ? 2'h1 : {2{less_90_s6_q}})) : 2'h0;
  logic [1:0] select_116;
  assign select_116 = and_104_s6_q ? (less_112_s6_q ? 2'h1 : {2{less_114_s6_q}}) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_118;
  assign equal_118 = select_116 == 2'h3;
  // hls/stages/health.hpp:126
  logic [1:0] select_126;
  assign select_126 = equal_80_s6_q ? 2'h0 : (less_123_s6_q ? 2'h1 : {2{less_124_s6_q}});
  logic [1:0] like_2;
  assign like_2 = equal_31_s6_q ? select_126 : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_129;
  assign equal_129 = like_2 == 2'h3;
  // hls/stages/health.hpp:126
  logic [1:0] select_141;
  assign select_141 = equal_31_s6_q ? (rows_s6_q ? (less_136_s6_q ? 2'h1 : {2{less_138_s6_q}}) : 2'h0) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_143;
  assign equal_143 = select_141 == 2'h1;

  logic [7:0] pixel_s7_q;
  logic first_s7_q;
  logic end_v_s7_q;
  logic equal_94_s7_q;
  logic equal_95_s7_q;
  logic [1:0] select_119_s7_q;
  logic [1:0] select_130_s7_q;
  logic equal_143_s7_q;
  logic or_144_s7_q;
  logic [2:0] select_148_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s7_q <= pixel_s6_q;
      first_s7_q <= first_s6_q;
      end_v_s7_q <= end_v_s6_q;
      equal_94_s7_q <= like == 2'h1;
      equal_95_s7_q <= like == 2'h3;
      select_119_s7_q <= (select_116 == 2'h1) ? 2'h1 : {2{equal_118}};
      select_130_s7_q <= (like_2 == 2'h1) ? 2'h1 : {2{equal_129}};
      equal_143_s7_q <= equal_143;
      or_144_s7_q <= (select_141 == 2'h3) | equal_143;
      select_148_s7_q <= y_s6_q ? (3'h0 - {like[1], like}) : {like[1], like};
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [31:0] signature_q;
  logic [7:0] darkest_q;
  logic [7:0] brightest_q;
  logic [21:0] turn_q;
  logic [21:0] level_q;
  logic [21:0] pair_q;
  logic [17:0] even_less_odd_q;
  // hls/stages/health.hpp:121
  logic [31:0] select_33;
  assign select_33 = first_s7_q ? 32'h0 : signature_q;
  logic [12:0] xor_34;
  assign xor_34 = {13{select_33[0]}} ^ {select_33[31:30], select_33[28:27], select_33[25:24], select_33[22:20], select_33[16], select_33[10:9], select_33[6]};
  logic [7:0] xor_35;
  assign xor_35 = pixel_s7_q ^ {select_33[8:7], xor_34[0], select_33[5:1]};
  logic parity_36;
  assign parity_36 = ^{select_33[6], select_33[0], pixel_s7_q[5]};
  // hls/stages/health.hpp:123
  logic [7:0] select_56;
  assign select_56 = first_s7_q ? pixel_s7_q : ((pixel_s7_q < darkest_q) ? pixel_s7_q : darkest_q);
  // hls/stages/health.hpp:124
  logic [7:0] select_59;
  assign select_59 = first_s7_q ? pixel_s7_q : ((brightest_q < pixel_s7_q) ? pixel_s7_q : brightest_q);
  // hls/stages/health.hpp:183
  logic or_96;
  assign or_96 = equal_94_s7_q | equal_95_s7_q;
  // hls/stages/health.hpp:201
  logic [21:0] sum_97;
  assign sum_97 = (first_s7_q ? 22'h0 : turn_q) + {{17{equal_94_s7_q}}, 1'b0, {4{or_96}}};
  // hls/stages/health.hpp:183
  logic [1:0] select_99;
  assign select_99 = equal_94_s7_q ? 2'h1 : {2{equal_95_s7_q}};
  // hls/stages/health.hpp:203
  logic [8:0] sum_120;
  assign sum_120 = {{2{equal_94_s7_q}}, select_99[1], equal_94_s7_q, 1'b0, {4{select_99[0]}}} + {{3{select_119_s7_q[1]}}, 1'b0, {5{select_119_s7_q[0]}}};
  // hls/stages/health.hpp:204
  logic [21:0] sum_131;
  assign sum_131 = (first_s7_q ? 22'h0 : level_q) + {{17{select_130_s7_q[1]}}, 1'b0, {4{select_130_s7_q[0]}}};
  // hls/stages/health.hpp:205
  logic [21:0] sum_145;
  assign sum_145 = (first_s7_q ? 22'h0 : pair_q) + {{17{equal_143_s7_q}}, 1'b0, {4{or_144_s7_q}}};
  // hls/stages/health.hpp:207
  logic [17:0] sum_149;
  assign sum_149 = (first_s7_q ? 18'h0 : even_less_odd_q) + {{15{select_148_s7_q[2]}}, select_148_s7_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      signature_q <= 32'h0;
      darkest_q <= 8'h0;
      brightest_q <= 8'h0;
      turn_q <= 22'h0;
      level_q <= 22'h0;
      pair_q <= 22'h0;
      even_less_odd_q <= 18'h0;
    end else if (s7_en) begin
      signature_q <= {select_33[0], xor_34[12:11], select_33[29], xor_34[10:9], select_33[26], xor_34[8:7], select_33[23], xor_34[6:4], select_33[19:17], xor_34[3], select_33[15:11], xor_34[2:1], xor_35[7:6], parity_36, xor_35[4:0]};
      darkest_q <= select_56;
      brightest_q <= select_59;
      turn_q <= sum_97;
      level_q <= sum_131;
      pair_q <= sum_145;
      even_less_odd_q <= sum_149;
    end
  end

  logic first_s8_q;
  logic end_v_s8_q;
  logic not_61_s8_q;
  logic not_65_s8_q;
  logic [8:0] sum_120_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s8_q <= first_s7_q;
      end_v_s8_q <= end_v_s7_q;
      not_61_s8_q <= ~(cfg_dark_level_i < pixel_s7_q);
      not_65_s8_q <= ~(pixel_s7_q < cfg_bright_level_i);
      sum_120_s8_q <= sum_120;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [31:0] before_0_q;
  logic [31:0] before_1_q;
  logic [1:0] frames_q;
  logic [20:0] dark_q;
  logic [20:0] bright_q;
  logic [23:0] aside_q;
  // hls/stages/health.hpp:135
  logic and_48;
  assign and_48 = ((~frames_q[0]) | (~(before_0_q == signature_q))) & ((~frames_q[1]) | (~(before_1_q == signature_q)));
  // hls/stages/health.hpp:202
  logic [23:0] sum_121;
  assign sum_121 = (first_s8_q ? 24'h0 : aside_q) + {{15{sum_120_s8_q[8]}}, sum_120_s8_q};
  // hls/stages/health.hpp:146
  logic [22:0] sum_164;
  assign sum_164 = {pair_q[21], pair_q} + {{2{pair_q[21]}}, pair_q[21:1]};
  logic [16:0] xor_165;
  assign xor_165 = even_less_odd_q[16:0] ^ {17{even_less_odd_q[17]}};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      before_0_q <= 32'h0;
      before_1_q <= 32'h0;
      frames_q <= 2'h0;
      dark_q <= 21'h0;
      bright_q <= 21'h0;
      aside_q <= 24'h0;
    end else if (s8_en) begin
      before_0_q <= end_v_s8_q ? signature_q : before_0_q;
      before_1_q <= end_v_s8_q ? before_0_q : before_1_q;
      frames_q <= end_v_s8_q ? {frames_q[0], 1'b1} : frames_q;
      dark_q <= {20'h0, not_61_s8_q} + (first_s8_q ? 21'h0 : dark_q);
      bright_q <= {20'h0, not_65_s8_q} + (first_s8_q ? 21'h0 : bright_q);
      aside_q <= sum_121;
    end
  end

  logic end_v_s9_q;
  logic and_48_s9_q;
  logic less_153_s9_q;
  logic less_159_s9_q;
  logic less_161_s9_q;
  logic less_163_s9_q;
  logic [16:0] sum_164_s9_q;
  logic [17:0] sum_166_s9_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      end_v_s9_q <= end_v_s8_q;
      and_48_s9_q <= and_48;
      less_153_s9_q <= cfg_contrast_limit_i < (brightest_q - darkest_q);
      less_159_s9_q <= $signed(22'h300) < $signed(turn_q);
      less_161_s9_q <= $signed(22'h640) < $signed(level_q);
      less_163_s9_q <= $signed(22'h640) < $signed(pair_q);
      sum_164_s9_q <= sum_164[22:6];
      sum_166_s9_q <= {17'h0, even_less_odd_q[17]} + {1'b0, xor_165};
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic [7:0] repeats_q;
  // hls/stages/health.hpp:135
  logic [7:0] select_52;
  assign select_52 = and_48_s9_q ? 8'h0 : ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1));
  // hls/stages/health.hpp:139
  logic less_150;
  assign less_150 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:146
  logic less_167;
  assign less_167 = $signed({{2{sum_164_s9_q[16]}}, sum_164_s9_q}) < $signed({1'b0, sum_166_s9_q});
  // hls/stages/health.hpp:147
  logic or_169;
  assign or_169 = (($signed(24'h1f40) < $signed(aside_q)) & less_161_s9_q) | (less_163_s9_q & less_167);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      repeats_q <= 8'h0;
    end else if (s9_en) begin
      repeats_q <= end_v_s9_q ? select_52 : repeats_q;
    end
  end

  logic end_v_s10_q;
  logic [31:0] select_37_s10_q;
  logic [7:0] select_52_s10_q;
  logic less_150_s10_q;
  logic less_151_s10_q;
  logic or_154_s10_q;
  logic or_170_s10_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      end_v_s10_q <= end_v_s9_q;
      select_37_s10_q <= before_0_q;
      select_52_s10_q <= select_52;
      less_150_s10_q <= less_150;
      less_151_s10_q <= cfg_bright_limit_i < bright_q;
      or_154_s10_q <= less_150 | less_153_s9_q;
      or_170_s10_q <= less_159_s9_q | or_169;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/health.hpp:141
  logic not_156;
  assign not_156 = ~(less_151_s10_q | or_154_s10_q);
  // hls/stages/health.hpp:142
  logic less_158;
  assign less_158 = (cfg_frozen_limit_i + 8'hff) < select_52_s10_q;
  // hls/stages/health.hpp:149
  logic [4:0] select_171;
  assign select_171 = end_v_s10_q ? {or_170_s10_q, less_158, not_156, less_151_s10_q, less_150_s10_q} : 5'h0;

  logic [31:0] select_37_s11_q;
  logic [4:0] select_171_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      select_37_s11_q <= select_37_s10_q;
      select_171_s11_q <= select_171;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_171_s11_q[0];
  assign white_o = select_171_s11_q[1];
  assign constant_o = select_171_s11_q[2];
  assign frozen_o = select_171_s11_q[3];
  assign torn_o = select_171_s11_q[4];
  assign signature_o = select_37_s11_q;
  assign valid_o = valid_s11_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
      valid_s7_q <= 1'b0;
      valid_s8_q <= 1'b0;
      valid_s9_q <= 1'b0;
      valid_s10_q <= 1'b0;
      valid_s11_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
      valid_s8_q <= valid_s7_q;
      valid_s9_q <= valid_s8_q;
      valid_s10_q <= valid_s9_q;
      valid_s11_q <= valid_s10_q & end_v_s10_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_164[5:0], xor_35[5]};

endmodule
