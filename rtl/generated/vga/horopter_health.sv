// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::vga>, hls/stages/health.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 262 bits, pipeline 29 bits, memories 2048 bits.
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
  // hls/stages/health.hpp:206
  logic [9:0] place;
  assign place = first_i ? 10'h0 : x_q;
  // hls/stages/health.hpp:211
  logic equal_30;
  assign equal_30 = place[3:0] == 4'hf;
  // hls/stages/health.hpp:208
  logic [3:0] y;
  assign y = first_i ? 4'h0 : y_q;
  // hls/stages/health.hpp:213
  logic [1:0] sum_91;
  assign sum_91 = y[1:0] + y[3:2];

  // Memory above, 64 x 32, DISTANCE 16, hls/stages/health.hpp:273; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign above_re = s0_en & equal_30;
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
  logic equal_30_s1_q;
  logic y_s1_q;
  logic and_95_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      last_s1_q <= last_i;
      left_1_s1_q <= left_1_q;
      place_s1_q <= place[9:4];
      equal_30_s1_q <= equal_30;
      y_s1_q <= y[0];
      and_95_s1_q <= (place[3:0] == {sum_91, y[1:0]}) & (~(place[9:1] == 9'h0));
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
  // hls/stages/health.hpp:120
  logic [31:0] select_32;
  assign select_32 = first_s1_q ? 32'h0 : signature_q;
  logic [12:0] xor_33;
  assign xor_33 = {13{select_32[0]}} ^ {select_32[31:30], select_32[28:27], select_32[25:24], select_32[22:20], select_32[16], select_32[10:9], select_32[6]};
  logic [7:0] xor_34;
  assign xor_34 = left_0_q ^ {select_32[8:7], xor_33[0], select_32[5:1]};
  logic parity_35;
  assign parity_35 = ^{select_32[6], select_32[0], left_0_q[5]};
  // hls/stages/health.hpp:122
  logic [7:0] select_47;
  assign select_47 = first_s1_q ? left_0_q : ((left_0_q < darkest_q) ? left_0_q : darkest_q);
  // hls/stages/health.hpp:123
  logic [7:0] select_50;
  assign select_50 = first_s1_q ? left_0_q : ((brightest_q < left_0_q) ? left_0_q : brightest_q);
  logic not_52;
  assign not_52 = ~(cfg_dark_level_i < left_0_q);
  // hls/stages/health.hpp:124
  logic not_56;
  assign not_56 = ~(left_0_q < cfg_bright_level_i);
  // hls/stages/health.hpp:207
  logic [2:0] rows;
  assign rows = first_s1_q ? 3'h0 : rows_q;
  // hls/stages/health.hpp:190
  logic equal_71;
  assign equal_71 = rows[2:1] == 2'h0;
  // hls/stages/health.hpp:170
  logic [8:0] difference_72;
  assign difference_72 = {1'b0, left_0_q} - {1'b0, above_rdata_q[7:0]};
  logic [7:0] xor_73;
  assign xor_73 = difference_72[7:0] ^ {8{difference_72[8]}};
  logic [8:0] sum_74;
  assign sum_74 = {8'h0, difference_72[8]} + {1'b0, xor_73};
  // hls/stages/health.hpp:172
  logic [8:0] sum_75;
  assign sum_75 = sum_74 + 9'h1;
  // hls/stages/health.hpp:171
  logic [8:0] difference_76;
  assign difference_76 = {1'b0, left_0_q} - {1'b0, above_rdata_q[15:8]};
  logic [7:0] xor_77;
  assign xor_77 = difference_76[7:0] ^ {8{difference_76[8]}};
  logic [8:0] sum_78;
  assign sum_78 = {8'h0, difference_76[8]} + {1'b0, xor_77};
  // hls/stages/health.hpp:172
  logic [8:0] sum_80;
  assign sum_80 = sum_78 + 9'h1;
  logic less_81;
  assign less_81 = sum_80 < sum_74;
  // hls/stages/health.hpp:125
  logic [1:0] like;
  assign like = equal_30_s1_q ? (equal_71 ? 2'h0 : ((sum_75 < sum_78) ? 2'h1 : {2{less_81}})) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_85;
  assign equal_85 = like == 2'h1;
  logic equal_86;
  assign equal_86 = like == 2'h3;
  logic or_87;
  assign or_87 = equal_85 | equal_86;
  // hls/stages/health.hpp:196
  logic [20:0] sum_88;
  assign sum_88 = (first_s1_q ? 21'h0 : turn_q) + {{16{equal_85}}, 1'b0, {4{or_87}}};
  // hls/stages/health.hpp:178
  logic [1:0] select_90;
  assign select_90 = equal_85 ? 2'h1 : {2{equal_86}};
  // hls/stages/health.hpp:170
  logic [8:0] difference_96;
  assign difference_96 = {1'b0, left_0_q} - {1'b0, left_1_q};
  logic [7:0] xor_97;
  assign xor_97 = difference_96[7:0] ^ {8{difference_96[8]}};
  logic [8:0] sum_98;
  assign sum_98 = {8'h0, difference_96[8]} + {1'b0, xor_97};
  logic [8:0] difference_100;
  assign difference_100 = {1'b0, left_0_q} - {1'b0, left_1_s1_q};
  logic [7:0] xor_101;
  assign xor_101 = difference_100[7:0] ^ {8{difference_100[8]}};
  logic [8:0] sum_102;
  assign sum_102 = {8'h0, difference_100[8]} + {1'b0, xor_101};
  // hls/stages/health.hpp:172
  logic [8:0] sum_104;
  assign sum_104 = sum_102 + 9'h1;
  logic less_105;
  assign less_105 = sum_104 < sum_98;
  // hls/stages/health.hpp:125
  logic [1:0] like_2;
  assign like_2 = and_95_s1_q ? (((sum_98 + 9'h1) < sum_102) ? 2'h1 : {2{less_105}}) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_109;
  assign equal_109 = like_2 == 2'h3;
  // hls/stages/health.hpp:198
  logic [1:0] select_110;
  assign select_110 = (like_2 == 2'h1) ? 2'h1 : {2{equal_109}};
  logic [8:0] sum_111;
  assign sum_111 = {{2{equal_85}}, select_90[1], equal_85, 1'b0, {4{select_90[0]}}} + {{3{select_110[1]}}, 1'b0, {5{select_110[0]}}};
  // hls/stages/health.hpp:172
  logic less_115;
  assign less_115 = sum_75 < sum_102;
  // hls/stages/health.hpp:125
  logic [1:0] like_3;
  assign like_3 = equal_30_s1_q ? (equal_71 ? 2'h0 : ((sum_104 < sum_74) ? 2'h1 : {2{less_115}})) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_120;
  assign equal_120 = like_3 == 2'h3;
  logic [1:0] select_121;
  assign select_121 = (like_3 == 2'h1) ? 2'h1 : {2{equal_120}};
  // hls/stages/health.hpp:199
  logic [20:0] sum_122;
  assign sum_122 = (first_s1_q ? 21'h0 : level_q) + {{16{select_121[1]}}, 1'b0, {4{select_121[0]}}};
  // hls/stages/health.hpp:171
  logic [8:0] difference_124;
  assign difference_124 = {1'b0, left_0_q} - {1'b0, above_rdata_q[31:24]};
  logic [7:0] xor_125;
  assign xor_125 = difference_124[7:0] ^ {8{difference_124[8]}};
  logic [8:0] sum_126;
  assign sum_126 = {8'h0, difference_124[8]} + {1'b0, xor_125};
  // hls/stages/health.hpp:172
  logic less_129;
  assign less_129 = (sum_126 + 9'h1) < sum_78;
  // hls/stages/health.hpp:125
  logic [1:0] select_132;
  assign select_132 = equal_30_s1_q ? (rows[2] ? ((sum_80 < sum_126) ? 2'h1 : {2{less_129}}) : 2'h0) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_134;
  assign equal_134 = select_132 == 2'h1;
  // hls/stages/health.hpp:200
  logic or_135;
  assign or_135 = (select_132 == 2'h3) | equal_134;
  logic [20:0] sum_136;
  assign sum_136 = (first_s1_q ? 21'h0 : pair_q) + {{16{equal_134}}, 1'b0, {4{or_135}}};
  // hls/stages/health.hpp:202
  logic [2:0] select_139;
  assign select_139 = y_s1_q ? (3'h0 - {like[1], like}) : {like[1], like};
  logic [15:0] sum_140;
  assign sum_140 = (first_s1_q ? 16'h0 : even_less_odd_q) + {{13{select_139[2]}}, select_139};

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = place_s1_q;
  logic above_we;
  assign above_we = s1_en & equal_30_s1_q;
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
      signature_q <= {select_32[0], xor_33[12:11], select_32[29], xor_33[10:9], select_32[26], xor_33[8:7], select_32[23], xor_33[6:4], select_32[19:17], xor_33[3], select_32[15:11], xor_33[2:1], xor_34[7:6], parity_35, xor_34[4:0]};
      darkest_q <= select_47;
      brightest_q <= select_50;
      dark_q <= {18'h0, not_52} + (first_s1_q ? 19'h0 : dark_q);
      bright_q <= {18'h0, not_56} + (first_s1_q ? 19'h0 : bright_q);
      rows_q <= (last_s1_q & (~(rows == 3'h4))) ? (rows + 3'h1) : rows;
      turn_q <= sum_88;
      aside_q <= (first_s1_q ? 23'h0 : aside_q) + {{14{sum_111[8]}}, sum_111};
      level_q <= sum_122;
      pair_q <= sum_136;
      even_less_odd_q <= sum_140;
    end
  end

  logic end_v_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      end_v_s2_q <= end_v_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [31:0] previous_signature_q;
  logic has_previous_q;
  logic [7:0] repeats_q;
  // hls/stages/health.hpp:131
  logic [7:0] select_42;
  assign select_42 = (previous_signature_q == signature_q) ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  logic [7:0] select_43;
  assign select_43 = has_previous_q ? select_42 : 8'h0;
  // hls/stages/health.hpp:134
  logic less_141;
  assign less_141 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:135
  logic less_142;
  assign less_142 = cfg_bright_limit_i < bright_q;
  // hls/stages/health.hpp:136
  logic or_146;
  assign or_146 = less_142 | (less_141 | (cfg_contrast_limit_i < (brightest_q - darkest_q)));
  logic not_147;
  assign not_147 = ~or_146;
  // hls/stages/health.hpp:137
  logic less_149;
  assign less_149 = (cfg_frozen_limit_i + 8'hff) < select_43;
  // hls/stages/health.hpp:140
  logic and_153;
  assign and_153 = ($signed(23'h1f40) < $signed(aside_q)) & ($signed(21'h640) < $signed(level_q));
  // hls/stages/health.hpp:141
  logic [21:0] sum_155;
  assign sum_155 = {pair_q[20], pair_q} + {{2{pair_q[20]}}, pair_q[20:1]};
  logic [14:0] xor_156;
  assign xor_156 = even_less_odd_q[14:0] ^ {15{even_less_odd_q[15]}};
  logic [15:0] sum_157;
  assign sum_157 = {15'h0, even_less_odd_q[15]} + {1'b0, xor_156};
  // hls/stages/health.hpp:144
  logic and_159;
  assign and_159 = ($signed(21'h640) < $signed(pair_q)) & ($signed({sum_155[21], sum_155[21:6]}) < $signed({1'b0, sum_157}));
  logic or_161;
  assign or_161 = ($signed(21'h300) < $signed(turn_q)) | (and_153 | and_159);
  logic [4:0] select_162;
  assign select_162 = end_v_s2_q ? {or_161, less_149, not_147, less_142, less_141} : 5'h0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      previous_signature_q <= 32'h0;
      has_previous_q <= 1'b0;
      repeats_q <= 8'h0;
    end else if (s2_en) begin
      previous_signature_q <= end_v_s2_q ? signature_q : previous_signature_q;
      has_previous_q <= end_v_s2_q | has_previous_q;
      repeats_q <= end_v_s2_q ? select_43 : repeats_q;
    end
  end

  logic [4:0] select_162_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      select_162_s3_q <= select_162;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_162_s3_q[0];
  assign white_o = select_162_s3_q[1];
  assign constant_o = select_162_s3_q[2];
  assign frozen_o = select_162_s3_q[3];
  assign torn_o = select_162_s3_q[4];
  assign signature_o = previous_signature_q;
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
  assign unused_bits = ^{sum_155[5:0], xor_34[5]};

endmodule
