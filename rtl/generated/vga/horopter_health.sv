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
  logic [1:0] sum_96;
  assign sum_96 = y[1:0] + y[3:2];

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
  logic and_100_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      last_s1_q <= last_i;
      left_1_s1_q <= left_1_q;
      place_s1_q <= place[9:4];
      equal_31_s1_q <= equal_31;
      y_s1_q <= y[0];
      and_100_s1_q <= (place[3:0] == {sum_96, y[1:0]}) & (~(place[9:1] == 9'h0));
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
  logic [7:0] select_52;
  assign select_52 = first_s1_q ? left_0_q : ((left_0_q < darkest_q) ? left_0_q : darkest_q);
  // hls/stages/health.hpp:124
  logic [7:0] select_55;
  assign select_55 = first_s1_q ? left_0_q : ((brightest_q < left_0_q) ? left_0_q : brightest_q);
  logic not_57;
  assign not_57 = ~(cfg_dark_level_i < left_0_q);
  // hls/stages/health.hpp:125
  logic not_61;
  assign not_61 = ~(left_0_q < cfg_bright_level_i);
  // hls/stages/health.hpp:212
  logic [2:0] rows;
  assign rows = first_s1_q ? 3'h0 : rows_q;
  // hls/stages/health.hpp:195
  logic equal_76;
  assign equal_76 = rows[2:1] == 2'h0;
  // hls/stages/health.hpp:175
  logic [8:0] difference_77;
  assign difference_77 = {1'b0, left_0_q} - {1'b0, above_rdata_q[7:0]};
  logic [7:0] xor_78;
  assign xor_78 = difference_77[7:0] ^ {8{difference_77[8]}};
  logic [8:0] sum_79;
  assign sum_79 = {8'h0, difference_77[8]} + {1'b0, xor_78};
  // hls/stages/health.hpp:177
  logic [8:0] sum_80;
  assign sum_80 = sum_79 + 9'h1;
  // hls/stages/health.hpp:176
  logic [8:0] difference_81;
  assign difference_81 = {1'b0, left_0_q} - {1'b0, above_rdata_q[15:8]};
  logic [7:0] xor_82;
  assign xor_82 = difference_81[7:0] ^ {8{difference_81[8]}};
  logic [8:0] sum_83;
  assign sum_83 = {8'h0, difference_81[8]} + {1'b0, xor_82};
  // hls/stages/health.hpp:177
  logic [8:0] sum_85;
  assign sum_85 = sum_83 + 9'h1;
  logic less_86;
  assign less_86 = sum_85 < sum_79;
  // hls/stages/health.hpp:126
  logic [1:0] like;
  assign like = equal_31_s1_q ? (equal_76 ? 2'h0 : ((sum_80 < sum_83) ? 2'h1 : {2{less_86}})) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_90;
  assign equal_90 = like == 2'h1;
  logic equal_91;
  assign equal_91 = like == 2'h3;
  logic or_92;
  assign or_92 = equal_90 | equal_91;
  // hls/stages/health.hpp:201
  logic [20:0] sum_93;
  assign sum_93 = (first_s1_q ? 21'h0 : turn_q) + {{16{equal_90}}, 1'b0, {4{or_92}}};
  // hls/stages/health.hpp:183
  logic [1:0] select_95;
  assign select_95 = equal_90 ? 2'h1 : {2{equal_91}};
  // hls/stages/health.hpp:175
  logic [8:0] difference_101;
  assign difference_101 = {1'b0, left_0_q} - {1'b0, left_1_q};
  logic [7:0] xor_102;
  assign xor_102 = difference_101[7:0] ^ {8{difference_101[8]}};
  logic [8:0] sum_103;
  assign sum_103 = {8'h0, difference_101[8]} + {1'b0, xor_102};
  logic [8:0] difference_105;
  assign difference_105 = {1'b0, left_0_q} - {1'b0, left_1_s1_q};
  logic [7:0] xor_106;
  assign xor_106 = difference_105[7:0] ^ {8{difference_105[8]}};
  logic [8:0] sum_107;
  assign sum_107 = {8'h0, difference_105[8]} + {1'b0, xor_106};
  // hls/stages/health.hpp:177
  logic [8:0] sum_109;
  assign sum_109 = sum_107 + 9'h1;
  logic less_110;
  assign less_110 = sum_109 < sum_103;
  // hls/stages/health.hpp:126
  logic [1:0] like_2;
  assign like_2 = and_100_s1_q ? (((sum_103 + 9'h1) < sum_107) ? 2'h1 : {2{less_110}}) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_114;
  assign equal_114 = like_2 == 2'h3;
  // hls/stages/health.hpp:203
  logic [1:0] select_115;
  assign select_115 = (like_2 == 2'h1) ? 2'h1 : {2{equal_114}};
  logic [8:0] sum_116;
  assign sum_116 = {{2{equal_90}}, select_95[1], equal_90, 1'b0, {4{select_95[0]}}} + {{3{select_115[1]}}, 1'b0, {5{select_115[0]}}};
  // hls/stages/health.hpp:177
  logic less_120;
  assign less_120 = sum_80 < sum_107;
  // hls/stages/health.hpp:126
  logic [1:0] like_3;
  assign like_3 = equal_31_s1_q ? (equal_76 ? 2'h0 : ((sum_109 < sum_79) ? 2'h1 : {2{less_120}})) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_125;
  assign equal_125 = like_3 == 2'h3;
  logic [1:0] select_126;
  assign select_126 = (like_3 == 2'h1) ? 2'h1 : {2{equal_125}};
  // hls/stages/health.hpp:204
  logic [20:0] sum_127;
  assign sum_127 = (first_s1_q ? 21'h0 : level_q) + {{16{select_126[1]}}, 1'b0, {4{select_126[0]}}};
  // hls/stages/health.hpp:176
  logic [8:0] difference_129;
  assign difference_129 = {1'b0, left_0_q} - {1'b0, above_rdata_q[31:24]};
  logic [7:0] xor_130;
  assign xor_130 = difference_129[7:0] ^ {8{difference_129[8]}};
  logic [8:0] sum_131;
  assign sum_131 = {8'h0, difference_129[8]} + {1'b0, xor_130};
  // hls/stages/health.hpp:177
  logic less_134;
  assign less_134 = (sum_131 + 9'h1) < sum_83;
  // hls/stages/health.hpp:126
  logic [1:0] select_137;
  assign select_137 = equal_31_s1_q ? (rows[2] ? ((sum_85 < sum_131) ? 2'h1 : {2{less_134}}) : 2'h0) : 2'h0;
  // hls/stages/health.hpp:183
  logic equal_139;
  assign equal_139 = select_137 == 2'h1;
  // hls/stages/health.hpp:205
  logic or_140;
  assign or_140 = (select_137 == 2'h3) | equal_139;
  logic [20:0] sum_141;
  assign sum_141 = (first_s1_q ? 21'h0 : pair_q) + {{16{equal_139}}, 1'b0, {4{or_140}}};
  // hls/stages/health.hpp:207
  logic [2:0] select_144;
  assign select_144 = y_s1_q ? (3'h0 - {like[1], like}) : {like[1], like};
  logic [15:0] sum_145;
  assign sum_145 = (first_s1_q ? 16'h0 : even_less_odd_q) + {{13{select_144[2]}}, select_144};

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
      darkest_q <= select_52;
      brightest_q <= select_55;
      dark_q <= {18'h0, not_57} + (first_s1_q ? 19'h0 : dark_q);
      bright_q <= {18'h0, not_61} + (first_s1_q ? 19'h0 : bright_q);
      rows_q <= (last_s1_q & (~(rows == 3'h4))) ? (rows + 3'h1) : rows;
      turn_q <= sum_93;
      aside_q <= (first_s1_q ? 23'h0 : aside_q) + {{14{sum_116[8]}}, sum_116};
      level_q <= sum_127;
      pair_q <= sum_141;
      even_less_odd_q <= sum_145;
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
  logic or_44;
  assign or_44 = (frames_q[0] & (previous_signature_q == signature_q)) | (frames_q[1] & (signature_before_q == signature_q));
  // hls/stages/health.hpp:135
  logic [7:0] select_48;
  assign select_48 = or_44 ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  // hls/stages/health.hpp:139
  logic less_146;
  assign less_146 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:140
  logic less_147;
  assign less_147 = cfg_bright_limit_i < bright_q;
  // hls/stages/health.hpp:141
  logic or_151;
  assign or_151 = less_147 | (less_146 | (cfg_contrast_limit_i < (brightest_q - darkest_q)));
  logic not_152;
  assign not_152 = ~or_151;
  // hls/stages/health.hpp:142
  logic less_154;
  assign less_154 = (cfg_frozen_limit_i + 8'hff) < select_48;
  // hls/stages/health.hpp:145
  logic and_158;
  assign and_158 = ($signed(23'h1f40) < $signed(aside_q)) & ($signed(21'h640) < $signed(level_q));
  // hls/stages/health.hpp:146
  logic [21:0] sum_160;
  assign sum_160 = {pair_q[20], pair_q} + {{2{pair_q[20]}}, pair_q[20:1]};
  logic [14:0] xor_161;
  assign xor_161 = even_less_odd_q[14:0] ^ {15{even_less_odd_q[15]}};
  logic [15:0] sum_162;
  assign sum_162 = {15'h0, even_less_odd_q[15]} + {1'b0, xor_161};
  // hls/stages/health.hpp:149
  logic and_164;
  assign and_164 = ($signed(21'h640) < $signed(pair_q)) & ($signed({sum_160[21], sum_160[21:6]}) < $signed({1'b0, sum_162}));
  logic or_166;
  assign or_166 = ($signed(21'h300) < $signed(turn_q)) | (and_158 | and_164);
  logic [4:0] select_167;
  assign select_167 = end_v_s2_q ? {or_166, less_154, not_152, less_147, less_146} : 5'h0;

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
      repeats_q <= end_v_s2_q ? select_48 : repeats_q;
    end
  end

  logic [4:0] select_167_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      select_167_s3_q <= select_167;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_167_s3_q[0];
  assign white_o = select_167_s3_q[1];
  assign constant_o = select_167_s3_q[2];
  assign frozen_o = select_167_s3_q[3];
  assign torn_o = select_167_s3_q[4];
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
  assign unused_bits = ^{sum_160[5:0], xor_35[5]};

endmodule
