// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::hd>, hls/stages/health.hpp. Do not edit.
//
// Latency 11 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 274 bits, pipeline 394 bits, memories 2048 bits.
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
  // hls/stages/health.hpp:206
  logic [10:0] place;
  assign place = first_i ? 11'h0 : x_q;
  // hls/stages/health.hpp:208
  logic [4:0] y;
  assign y = first_i ? 5'h0 : y_q;
  // hls/stages/health.hpp:213
  logic [2:0] sum_91;
  assign sum_91 = y[2:0] + y[4:2];

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
  logic equal_30_s1_q;
  logic y_s1_q;
  logic equal_92_s1_q;
  logic not_94_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s1_q <= pixel_i;
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      last_s1_q <= last_i;
      place_s1_q <= place[10:5];
      equal_30_s1_q <= place[4:0] == 5'h1f;
      y_s1_q <= y[0];
      equal_92_s1_q <= place[4:0] == {sum_91, y[1:0]};
      not_94_s1_q <= ~(place[10:1] == 10'h0);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  // Memory above, 64 x 32, DISTANCE 16, hls/stages/health.hpp:273; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
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
  assign above_re = s1_en & equal_30_s1_q;
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
  logic equal_30_s2_q;
  logic y_s2_q;
  logic and_95_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s2_q <= pixel_s1_q;
      first_s2_q <= first_s1_q;
      end_v_s2_q <= end_v_s1_q;
      last_s2_q <= last_s1_q;
      place_s2_q <= place_s1_q;
      equal_30_s2_q <= equal_30_s1_q;
      y_s2_q <= y_s1_q;
      and_95_s2_q <= equal_92_s1_q & not_94_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------

  logic [7:0] pixel_s3_q;
  logic first_s3_q;
  logic end_v_s3_q;
  logic last_s3_q;
  logic [5:0] place_s3_q;
  logic equal_30_s3_q;
  logic [31:0] above_rdata_s3_q;
  logic y_s3_q;
  logic and_95_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s3_q <= pixel_s2_q;
      first_s3_q <= first_s2_q;
      end_v_s3_q <= end_v_s2_q;
      last_s3_q <= last_s2_q;
      place_s3_q <= place_s2_q;
      equal_30_s3_q <= equal_30_s2_q;
      above_rdata_s3_q <= above_rdata_q;
      y_s3_q <= y_s2_q;
      and_95_s3_q <= and_95_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_0_q;
  logic [7:0] left_1_q;
  // hls/stages/health.hpp:170
  logic [8:0] difference_72;
  assign difference_72 = {1'b0, pixel_s3_q} - {1'b0, above_rdata_s3_q[7:0]};
  // hls/stages/health.hpp:171
  logic [8:0] difference_76;
  assign difference_76 = {1'b0, pixel_s3_q} - {1'b0, above_rdata_s3_q[15:8]};
  // hls/stages/health.hpp:170
  logic [8:0] difference_96;
  assign difference_96 = {1'b0, pixel_s3_q} - {1'b0, left_0_q};
  logic [8:0] difference_100;
  assign difference_100 = {1'b0, pixel_s3_q} - {1'b0, left_1_q};
  // hls/stages/health.hpp:171
  logic [8:0] difference_124;
  assign difference_124 = {1'b0, pixel_s3_q} - {1'b0, above_rdata_s3_q[31:24]};

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = place_s3_q;
  logic above_we;
  assign above_we = s3_en & equal_30_s3_q;
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
  logic equal_30_s4_q;
  logic y_s4_q;
  logic difference_72_s4_q;
  logic [7:0] xor_73_s4_q;
  logic difference_76_s4_q;
  logic [7:0] xor_77_s4_q;
  logic and_95_s4_q;
  logic difference_96_s4_q;
  logic [7:0] xor_97_s4_q;
  logic difference_100_s4_q;
  logic [7:0] xor_101_s4_q;
  logic difference_124_s4_q;
  logic [7:0] xor_125_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s4_q <= first_s3_q;
      end_v_s4_q <= end_v_s3_q;
      last_s4_q <= last_s3_q;
      equal_30_s4_q <= equal_30_s3_q;
      y_s4_q <= y_s3_q;
      difference_72_s4_q <= difference_72[8];
      xor_73_s4_q <= difference_72[7:0] ^ {8{difference_72[8]}};
      difference_76_s4_q <= difference_76[8];
      xor_77_s4_q <= difference_76[7:0] ^ {8{difference_76[8]}};
      and_95_s4_q <= and_95_s3_q;
      difference_96_s4_q <= difference_96[8];
      xor_97_s4_q <= difference_96[7:0] ^ {8{difference_96[8]}};
      difference_100_s4_q <= difference_100[8];
      xor_101_s4_q <= difference_100[7:0] ^ {8{difference_100[8]}};
      difference_124_s4_q <= difference_124[8];
      xor_125_s4_q <= difference_124[7:0] ^ {8{difference_124[8]}};
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------

  logic [7:0] pixel_s5_q;
  logic first_s5_q;
  logic end_v_s5_q;
  logic last_s5_q;
  logic equal_30_s5_q;
  logic y_s5_q;
  logic [8:0] sum_74_s5_q;
  logic [8:0] sum_78_s5_q;
  logic and_95_s5_q;
  logic [8:0] sum_98_s5_q;
  logic [8:0] sum_102_s5_q;
  logic [8:0] sum_126_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s5_q <= left_0_q;
      first_s5_q <= first_s4_q;
      end_v_s5_q <= end_v_s4_q;
      last_s5_q <= last_s4_q;
      equal_30_s5_q <= equal_30_s4_q;
      y_s5_q <= y_s4_q;
      sum_74_s5_q <= {8'h0, difference_72_s4_q} + {1'b0, xor_73_s4_q};
      sum_78_s5_q <= {8'h0, difference_76_s4_q} + {1'b0, xor_77_s4_q};
      and_95_s5_q <= and_95_s4_q;
      sum_98_s5_q <= {8'h0, difference_96_s4_q} + {1'b0, xor_97_s4_q};
      sum_102_s5_q <= {8'h0, difference_100_s4_q} + {1'b0, xor_101_s4_q};
      sum_126_s5_q <= {8'h0, difference_124_s4_q} + {1'b0, xor_125_s4_q};
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [2:0] rows_q;
  // hls/stages/health.hpp:207
  logic [2:0] rows;
  assign rows = first_s5_q ? 3'h0 : rows_q;
  // hls/stages/health.hpp:172
  logic [8:0] sum_75;
  assign sum_75 = sum_74_s5_q + 9'h1;
  logic [8:0] sum_80;
  assign sum_80 = sum_78_s5_q + 9'h1;
  logic [8:0] sum_104;
  assign sum_104 = sum_102_s5_q + 9'h1;

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
  logic equal_30_s6_q;
  logic y_s6_q;
  logic rows_s6_q;
  logic equal_71_s6_q;
  logic less_79_s6_q;
  logic less_81_s6_q;
  logic and_95_s6_q;
  logic less_103_s6_q;
  logic less_105_s6_q;
  logic less_114_s6_q;
  logic less_115_s6_q;
  logic less_127_s6_q;
  logic less_129_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s6_q <= pixel_s5_q;
      first_s6_q <= first_s5_q;
      end_v_s6_q <= end_v_s5_q;
      equal_30_s6_q <= equal_30_s5_q;
      y_s6_q <= y_s5_q;
      rows_s6_q <= rows[2];
      equal_71_s6_q <= rows[2:1] == 2'h0;
      less_79_s6_q <= sum_75 < sum_78_s5_q;
      less_81_s6_q <= sum_80 < sum_74_s5_q;
      and_95_s6_q <= and_95_s5_q;
      less_103_s6_q <= (sum_98_s5_q + 9'h1) < sum_102_s5_q;
      less_105_s6_q <= sum_104 < sum_98_s5_q;
      less_114_s6_q <= sum_104 < sum_74_s5_q;
      less_115_s6_q <= sum_75 < sum_102_s5_q;
      less_127_s6_q <= sum_80 < sum_126_s5_q;
      less_129_s6_q <= (sum_126_s5_q + 9'h1) < sum_78_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/health.hpp:125
  logic [1:0] like;
  assign like = equal_30_s6_q ? (equal_71_s6_q ? 2'h0 : (less_79_s6_q ? 2'h1 : {2{less_81_s6_q}})) : 2'h0;
  logic [1:0] like_2;
  assign like_2 = and_95_s6_q ? (less_103_s6_q ? 2'h1 : {2{less_105_s6_q}}) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_109;
  assign equal_109 = like_2 == 2'h3;
  // hls/stages/health.hpp:125
  logic [1:0] select_117;
  assign select_117 = equal_71_s6_q ? 2'h0 : (less_114_s6_q ? 2'h1 : {2{less_115_s6_q}});
  logic [1:0] like_3;
  assign like_3 = equal_30_s6_q ? select_117 : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_120;
  assign equal_120 = like_3 == 2'h3;
  // hls/stages/health.hpp:125
  logic [1:0] select_132;
  assign select_132 = equal_30_s6_q ? (rows_s6_q ? (less_127_s6_q ? 2'h1 : {2{less_129_s6_q}}) : 2'h0) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_134;
  assign equal_134 = select_132 == 2'h1;

  logic [7:0] pixel_s7_q;
  logic first_s7_q;
  logic end_v_s7_q;
  logic equal_85_s7_q;
  logic equal_86_s7_q;
  logic [1:0] select_110_s7_q;
  logic [1:0] select_121_s7_q;
  logic equal_134_s7_q;
  logic or_135_s7_q;
  logic [2:0] select_139_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_s7_q <= pixel_s6_q;
      first_s7_q <= first_s6_q;
      end_v_s7_q <= end_v_s6_q;
      equal_85_s7_q <= like == 2'h1;
      equal_86_s7_q <= like == 2'h3;
      select_110_s7_q <= (like_2 == 2'h1) ? 2'h1 : {2{equal_109}};
      select_121_s7_q <= (like_3 == 2'h1) ? 2'h1 : {2{equal_120}};
      equal_134_s7_q <= equal_134;
      or_135_s7_q <= (select_132 == 2'h3) | equal_134;
      select_139_s7_q <= y_s6_q ? (3'h0 - {like[1], like}) : {like[1], like};
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
  // hls/stages/health.hpp:120
  logic [31:0] select_32;
  assign select_32 = first_s7_q ? 32'h0 : signature_q;
  logic [12:0] xor_33;
  assign xor_33 = {13{select_32[0]}} ^ {select_32[31:30], select_32[28:27], select_32[25:24], select_32[22:20], select_32[16], select_32[10:9], select_32[6]};
  logic [7:0] xor_34;
  assign xor_34 = pixel_s7_q ^ {select_32[8:7], xor_33[0], select_32[5:1]};
  logic parity_35;
  assign parity_35 = ^{select_32[6], select_32[0], pixel_s7_q[5]};
  // hls/stages/health.hpp:122
  logic [7:0] select_47;
  assign select_47 = first_s7_q ? pixel_s7_q : ((pixel_s7_q < darkest_q) ? pixel_s7_q : darkest_q);
  // hls/stages/health.hpp:123
  logic [7:0] select_50;
  assign select_50 = first_s7_q ? pixel_s7_q : ((brightest_q < pixel_s7_q) ? pixel_s7_q : brightest_q);
  // hls/stages/health.hpp:178
  logic or_87;
  assign or_87 = equal_85_s7_q | equal_86_s7_q;
  // hls/stages/health.hpp:196
  logic [21:0] sum_88;
  assign sum_88 = (first_s7_q ? 22'h0 : turn_q) + {{17{equal_85_s7_q}}, 1'b0, {4{or_87}}};
  // hls/stages/health.hpp:178
  logic [1:0] select_90;
  assign select_90 = equal_85_s7_q ? 2'h1 : {2{equal_86_s7_q}};
  // hls/stages/health.hpp:198
  logic [8:0] sum_111;
  assign sum_111 = {{2{equal_85_s7_q}}, select_90[1], equal_85_s7_q, 1'b0, {4{select_90[0]}}} + {{3{select_110_s7_q[1]}}, 1'b0, {5{select_110_s7_q[0]}}};
  // hls/stages/health.hpp:199
  logic [21:0] sum_122;
  assign sum_122 = (first_s7_q ? 22'h0 : level_q) + {{17{select_121_s7_q[1]}}, 1'b0, {4{select_121_s7_q[0]}}};
  // hls/stages/health.hpp:200
  logic [21:0] sum_136;
  assign sum_136 = (first_s7_q ? 22'h0 : pair_q) + {{17{equal_134_s7_q}}, 1'b0, {4{or_135_s7_q}}};
  // hls/stages/health.hpp:202
  logic [17:0] sum_140;
  assign sum_140 = (first_s7_q ? 18'h0 : even_less_odd_q) + {{15{select_139_s7_q[2]}}, select_139_s7_q};

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
      signature_q <= {select_32[0], xor_33[12:11], select_32[29], xor_33[10:9], select_32[26], xor_33[8:7], select_32[23], xor_33[6:4], select_32[19:17], xor_33[3], select_32[15:11], xor_33[2:1], xor_34[7:6], parity_35, xor_34[4:0]};
      darkest_q <= select_47;
      brightest_q <= select_50;
      turn_q <= sum_88;
      level_q <= sum_122;
      pair_q <= sum_136;
      even_less_odd_q <= sum_140;
    end
  end

  logic first_s8_q;
  logic end_v_s8_q;
  logic not_52_s8_q;
  logic not_56_s8_q;
  logic [8:0] sum_111_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s8_q <= first_s7_q;
      end_v_s8_q <= end_v_s7_q;
      not_52_s8_q <= ~(cfg_dark_level_i < pixel_s7_q);
      not_56_s8_q <= ~(pixel_s7_q < cfg_bright_level_i);
      sum_111_s8_q <= sum_111;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [31:0] previous_signature_q;
  logic [20:0] dark_q;
  logic [20:0] bright_q;
  logic [23:0] aside_q;
  // hls/stages/health.hpp:197
  logic [23:0] sum_112;
  assign sum_112 = (first_s8_q ? 24'h0 : aside_q) + {{15{sum_111_s8_q[8]}}, sum_111_s8_q};
  // hls/stages/health.hpp:141
  logic [22:0] sum_155;
  assign sum_155 = {pair_q[21], pair_q} + {{2{pair_q[21]}}, pair_q[21:1]};
  logic [16:0] xor_156;
  assign xor_156 = even_less_odd_q[16:0] ^ {17{even_less_odd_q[17]}};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      previous_signature_q <= 32'h0;
      dark_q <= 21'h0;
      bright_q <= 21'h0;
      aside_q <= 24'h0;
    end else if (s8_en) begin
      previous_signature_q <= end_v_s8_q ? signature_q : previous_signature_q;
      dark_q <= {20'h0, not_52_s8_q} + (first_s8_q ? 21'h0 : dark_q);
      bright_q <= {20'h0, not_56_s8_q} + (first_s8_q ? 21'h0 : bright_q);
      aside_q <= sum_112;
    end
  end

  logic end_v_s9_q;
  logic equal_38_s9_q;
  logic less_144_s9_q;
  logic less_150_s9_q;
  logic less_152_s9_q;
  logic less_154_s9_q;
  logic [16:0] sum_155_s9_q;
  logic [17:0] sum_157_s9_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      end_v_s9_q <= end_v_s8_q;
      equal_38_s9_q <= previous_signature_q == signature_q;
      less_144_s9_q <= cfg_contrast_limit_i < (brightest_q - darkest_q);
      less_150_s9_q <= $signed(22'h300) < $signed(turn_q);
      less_152_s9_q <= $signed(22'h640) < $signed(level_q);
      less_154_s9_q <= $signed(22'h640) < $signed(pair_q);
      sum_155_s9_q <= sum_155[22:6];
      sum_157_s9_q <= {17'h0, even_less_odd_q[17]} + {1'b0, xor_156};
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic has_previous_q;
  logic [7:0] repeats_q;
  // hls/stages/health.hpp:131
  logic [7:0] select_42;
  assign select_42 = equal_38_s9_q ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  logic [7:0] select_43;
  assign select_43 = has_previous_q ? select_42 : 8'h0;
  // hls/stages/health.hpp:134
  logic less_141;
  assign less_141 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:141
  logic less_158;
  assign less_158 = $signed({{2{sum_155_s9_q[16]}}, sum_155_s9_q}) < $signed({1'b0, sum_157_s9_q});
  // hls/stages/health.hpp:144
  logic or_160;
  assign or_160 = (($signed(24'h1f40) < $signed(aside_q)) & less_152_s9_q) | (less_154_s9_q & less_158);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      has_previous_q <= 1'b0;
      repeats_q <= 8'h0;
    end else if (s9_en) begin
      has_previous_q <= end_v_s9_q | has_previous_q;
      repeats_q <= end_v_s9_q ? select_43 : repeats_q;
    end
  end

  logic end_v_s10_q;
  logic [31:0] select_36_s10_q;
  logic [7:0] select_43_s10_q;
  logic less_141_s10_q;
  logic less_142_s10_q;
  logic or_145_s10_q;
  logic or_161_s10_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      end_v_s10_q <= end_v_s9_q;
      select_36_s10_q <= previous_signature_q;
      select_43_s10_q <= select_43;
      less_141_s10_q <= less_141;
      less_142_s10_q <= cfg_bright_limit_i < bright_q;
      or_145_s10_q <= less_141 | less_144_s9_q;
      or_161_s10_q <= less_150_s9_q | or_160;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/health.hpp:136
  logic not_147;
  assign not_147 = ~(less_142_s10_q | or_145_s10_q);
  // hls/stages/health.hpp:137
  logic less_149;
  assign less_149 = (cfg_frozen_limit_i + 8'hff) < select_43_s10_q;
  // hls/stages/health.hpp:144
  logic [4:0] select_162;
  assign select_162 = end_v_s10_q ? {or_161_s10_q, less_149, not_147, less_142_s10_q, less_141_s10_q} : 5'h0;

  logic [31:0] select_36_s11_q;
  logic [4:0] select_162_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      select_36_s11_q <= select_36_s10_q;
      select_162_s11_q <= select_162;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_162_s11_q[0];
  assign white_o = select_162_s11_q[1];
  assign constant_o = select_162_s11_q[2];
  assign frozen_o = select_162_s11_q[3];
  assign torn_o = select_162_s11_q[4];
  assign signature_o = select_36_s11_q;
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
  assign unused_bits = ^{sum_155[5:0], xor_34[5]};

endmodule
