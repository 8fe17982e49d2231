// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::field>, hls/stages/health.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 305 bits, pipeline 29 bits, memories 2048 bits.
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
  logic equal_33;
  assign equal_33 = place[3:0] == 4'hf;
  // hls/stages/health.hpp:213
  logic [3:0] y;
  assign y = first_i ? 4'h0 : y_q;
  // hls/stages/health.hpp:218
  logic [1:0] sum_98;
  assign sum_98 = y[1:0] + y[3:2];

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
  assign above_re = s0_en & equal_33;
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
  logic equal_33_s1_q;
  logic y_s1_q;
  logic and_102_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      last_s1_q <= last_i;
      left_3_s1_q <= left_3_q;
      place_s1_q <= place[9:4];
      equal_33_s1_q <= equal_33;
      y_s1_q <= y[0];
      and_102_s1_q <= (place[3:0] == {sum_98, y[1:0]}) & (~(place[9:2] == 8'h0));
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
  logic [31:0] select_35;
  assign select_35 = first_s1_q ? 32'h0 : signature_q;
  logic [12:0] xor_36;
  assign xor_36 = {13{select_35[0]}} ^ {select_35[31:30], select_35[28:27], select_35[25:24], select_35[22:20], select_35[16], select_35[10:9], select_35[6]};
  logic [7:0] xor_37;
  assign xor_37 = left_0_q ^ {select_35[8:7], xor_36[0], select_35[5:1]};
  logic parity_38;
  assign parity_38 = ^{select_35[6], select_35[0], left_0_q[5]};
  // hls/stages/health.hpp:123
  logic [7:0] select_54;
  assign select_54 = first_s1_q ? left_0_q : ((left_0_q < darkest_q) ? left_0_q : darkest_q);
  // hls/stages/health.hpp:124
  logic [7:0] select_57;
  assign select_57 = first_s1_q ? left_0_q : ((brightest_q < left_0_q) ? left_0_q : brightest_q);
  logic not_59;
  assign not_59 = ~(cfg_dark_level_i < left_0_q);
  // hls/stages/health.hpp:125
  logic not_63;
  assign not_63 = ~(left_0_q < cfg_bright_level_i);
  // hls/stages/health.hpp:212
  logic [2:0] rows;
  assign rows = first_s1_q ? 3'h0 : rows_q;
  // hls/stages/health.hpp:195
  logic equal_78;
  assign equal_78 = rows[2:1] == 2'h0;
  // hls/stages/health.hpp:175
  logic [8:0] difference_79;
  assign difference_79 = {1'b0, left_0_q} - {1'b0, above_rdata_q[7:0]};
  logic [7:0] xor_80;
  assign xor_80 = difference_79[7:0] ^ {8{difference_79[8]}};
  logic [8:0] sum_81;
  assign sum_81 = {8'h0, difference_79[8]} + {1'b0, xor_80};
  // hls/stages/health.hpp:177
  logic [8:0] sum_82;
  assign sum_82 = sum_81 + 9'h1;
  // hls/stages/health.hpp:176
  logic [8:0] difference_83;
  assign difference_83 = {1'b0, left_0_q} - {1'b0, above_rdata_q[15:8]};
  logic [7:0] xor_84;
  assign xor_84 = difference_83[7:0] ^ {8{difference_83[8]}};
  logic [8:0] sum_85;
  assign sum_85 = {8'h0, difference_83[8]} + {1'b0, xor_84};
  // hls/stages/health.hpp:177
  logic [8:0] sum_87;
  assign sum_87 = sum_85 + 9'h1;
  logic less_88;
  assign less_88 = sum_87 < sum_81;
  // hls/stages/health.hpp:126
  logic [1:0] like;
  assign like = equal_33_s1_q ? (equal_78 ? 2'h0 : ((sum_82 < sum_85) ? 2'h1 : {2{less_88}})) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_92;
  assign equal_92 = like == 2'h1;
  logic equal_93;
  assign equal_93 = like == 2'h3;
  logic or_94;
  assign or_94 = equal_92 | equal_93;
  // hls/stages/health.hpp:201
  logic [19:0] sum_95;
  assign sum_95 = (first_s1_q ? 20'h0 : turn_q) + {{15{equal_92}}, 1'b0, {4{or_94}}};
  // hls/stages/health.hpp:183
  logic [1:0] select_97;
  assign select_97 = equal_92 ? 2'h1 : {2{equal_93}};
  // hls/stages/health.hpp:175
  logic [8:0] difference_103;
  assign difference_103 = {1'b0, left_0_q} - {1'b0, left_2_q};
  logic [7:0] xor_104;
  assign xor_104 = difference_103[7:0] ^ {8{difference_103[8]}};
  logic [8:0] sum_105;
  assign sum_105 = {8'h0, difference_103[8]} + {1'b0, xor_104};
  logic [8:0] difference_107;
  assign difference_107 = {1'b0, left_0_q} - {1'b0, left_3_s1_q};
  logic [7:0] xor_108;
  assign xor_108 = difference_107[7:0] ^ {8{difference_107[8]}};
  logic [8:0] sum_109;
  assign sum_109 = {8'h0, difference_107[8]} + {1'b0, xor_108};
  // hls/stages/health.hpp:177
  logic [8:0] sum_111;
  assign sum_111 = sum_109 + 9'h1;
  logic less_112;
  assign less_112 = sum_111 < sum_105;
  // hls/stages/health.hpp:126
  logic [1:0] like_2;
  assign like_2 = and_102_s1_q ? (((sum_105 + 9'h1) < sum_109) ? 2'h1 : {2{less_112}}) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_116;
  assign equal_116 = like_2 == 2'h3;
  // hls/stages/health.hpp:203
  logic [1:0] select_117;
  assign select_117 = (like_2 == 2'h1) ? 2'h1 : {2{equal_116}};
  logic [8:0] sum_118;
  assign sum_118 = {{2{equal_92}}, select_97[1], equal_92, 1'b0, {4{select_97[0]}}} + {{3{select_117[1]}}, 1'b0, {5{select_117[0]}}};
  // hls/stages/health.hpp:177
  logic less_122;
  assign less_122 = sum_82 < sum_109;
  // hls/stages/health.hpp:126
  logic [1:0] like_3;
  assign like_3 = equal_33_s1_q ? (equal_78 ? 2'h0 : ((sum_111 < sum_81) ? 2'h1 : {2{less_122}})) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_127;
  assign equal_127 = like_3 == 2'h3;
  logic [1:0] select_128;
  assign select_128 = (like_3 == 2'h1) ? 2'h1 : {2{equal_127}};
  // hls/stages/health.hpp:204
  logic [19:0] sum_129;
  assign sum_129 = (first_s1_q ? 20'h0 : level_q) + {{15{select_128[1]}}, 1'b0, {4{select_128[0]}}};
  // hls/stages/health.hpp:176
  logic [8:0] difference_131;
  assign difference_131 = {1'b0, left_0_q} - {1'b0, above_rdata_q[31:24]};
  logic [7:0] xor_132;
  assign xor_132 = difference_131[7:0] ^ {8{difference_131[8]}};
  logic [8:0] sum_133;
  assign sum_133 = {8'h0, difference_131[8]} + {1'b0, xor_132};
  // hls/stages/health.hpp:177
  logic less_136;
  assign less_136 = (sum_133 + 9'h1) < sum_85;
  // hls/stages/health.hpp:126
  logic [1:0] select_139;
  assign select_139 = equal_33_s1_q ? (rows[2] ? ((sum_87 < sum_133) ? 2'h1 : {2{less_136}}) : 2'h0) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_141;
  assign equal_141 = select_139 == 2'h1;
  // hls/stages/health.hpp:205
  logic or_142;
  assign or_142 = (select_139 == 2'h3) | equal_141;
  logic [19:0] sum_143;
  assign sum_143 = (first_s1_q ? 20'h0 : pair_q) + {{15{equal_141}}, 1'b0, {4{or_142}}};
  // hls/stages/health.hpp:207
  logic [2:0] select_146;
  assign select_146 = y_s1_q ? (3'h0 - {like[1], like}) : {like[1], like};
  logic [15:0] sum_147;
  assign sum_147 = (first_s1_q ? 16'h0 : even_less_odd_q) + {{13{select_146[2]}}, select_146};

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = place_s1_q;
  logic above_we;
  assign above_we = s1_en & equal_33_s1_q;
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
      signature_q <= {select_35[0], xor_36[12:11], select_35[29], xor_36[10:9], select_35[26], xor_36[8:7], select_35[23], xor_36[6:4], select_35[19:17], xor_36[3], select_35[15:11], xor_36[2:1], xor_37[7:6], parity_38, xor_37[4:0]};
      darkest_q <= select_54;
      brightest_q <= select_57;
      dark_q <= {17'h0, not_59} + (first_s1_q ? 18'h0 : dark_q);
      bright_q <= {17'h0, not_63} + (first_s1_q ? 18'h0 : bright_q);
      rows_q <= (last_s1_q & (~(rows == 3'h4))) ? (rows + 3'h1) : rows;
      turn_q <= sum_95;
      aside_q <= (first_s1_q ? 22'h0 : aside_q) + {{13{sum_118[8]}}, sum_118};
      level_q <= sum_129;
      pair_q <= sum_143;
      even_less_odd_q <= sum_147;
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
  logic [31:0] signature_before_q;
  logic [1:0] frames_q;
  logic [7:0] repeats_q;
  // hls/stages/health.hpp:134
  logic or_46;
  assign or_46 = (frames_q[0] & (previous_signature_q == signature_q)) | (frames_q[1] & (signature_before_q == signature_q));
  // hls/stages/health.hpp:135
  logic [7:0] select_50;
  assign select_50 = or_46 ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  // hls/stages/health.hpp:139
  logic less_148;
  assign less_148 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:140
  logic less_149;
  assign less_149 = cfg_bright_limit_i < bright_q;
  // hls/stages/health.hpp:141
  logic or_153;
  assign or_153 = less_149 | (less_148 | (cfg_contrast_limit_i < (brightest_q - darkest_q)));
  logic not_154;
  assign not_154 = ~or_153;
  // hls/stages/health.hpp:142
  logic less_156;
  assign less_156 = (cfg_frozen_limit_i + 8'hff) < select_50;
  // hls/stages/health.hpp:145
  logic and_160;
  assign and_160 = ($signed(22'h1f40) < $signed(aside_q)) & ($signed(20'h640) < $signed(level_q));
  // hls/stages/health.hpp:146
  logic [20:0] sum_162;
  assign sum_162 = {pair_q[19], pair_q} + {{2{pair_q[19]}}, pair_q[19:1]};
  logic [14:0] xor_163;
  assign xor_163 = even_less_odd_q[14:0] ^ {15{even_less_odd_q[15]}};
  logic [15:0] sum_164;
  assign sum_164 = {15'h0, even_less_odd_q[15]} + {1'b0, xor_163};
  logic less_165;
  assign less_165 = $signed({{2{sum_162[20]}}, sum_162[20:6]}) < $signed({1'b0, sum_164});
  // hls/stages/health.hpp:149
  logic or_168;
  assign or_168 = ($signed(20'h300) < $signed(turn_q)) | (and_160 | (($signed(20'h640) < $signed(pair_q)) & less_165));
  logic [4:0] select_169;
  assign select_169 = end_v_s2_q ? {or_168, less_156, not_154, less_149, less_148} : 5'h0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      previous_signature_q <= 32'h0;
      signature_before_q <= 32'h0;
      frames_q <= 2'h0;
      repeats_q <= 8'h0;
    end else if (s2_en) begin
      previous_signature_q <= end_v_s2_q ? signature_q : previous_signature_q;
      signature_before_q <= end_v_s2_q ? previous_signature_q : signature_before_q;
      frames_q <= end_v_s2_q ? {frames_q[0], 1'b1} : frames_q;
      repeats_q <= end_v_s2_q ? select_50 : repeats_q;
    end
  end

  logic [4:0] select_169_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      select_169_s3_q <= select_169;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_169_s3_q[0];
  assign white_o = select_169_s3_q[1];
  assign constant_o = select_169_s3_q[2];
  assign frozen_o = select_169_s3_q[3];
  assign torn_o = select_169_s3_q[4];
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
  assign unused_bits = ^{sum_162[5:0], xor_37[5]};

endmodule
