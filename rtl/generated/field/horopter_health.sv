// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::field>, hls/stages/health.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 272 bits, pipeline 29 bits, memories 2048 bits.
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
  // hls/stages/health.hpp:206
  logic [9:0] place;
  assign place = first_i ? 10'h0 : x_q;
  // hls/stages/health.hpp:211
  logic equal_32;
  assign equal_32 = place[3:0] == 4'hf;
  // hls/stages/health.hpp:208
  logic [3:0] y;
  assign y = first_i ? 4'h0 : y_q;
  // hls/stages/health.hpp:213
  logic [1:0] sum_93;
  assign sum_93 = y[1:0] + y[3:2];

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
  assign above_re = s0_en & equal_32;
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
  logic equal_32_s1_q;
  logic y_s1_q;
  logic and_97_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      last_s1_q <= last_i;
      left_3_s1_q <= left_3_q;
      place_s1_q <= place[9:4];
      equal_32_s1_q <= equal_32;
      y_s1_q <= y[0];
      and_97_s1_q <= (place[3:0] == {sum_93, y[1:0]}) & (~(place[9:2] == 8'h0));
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
  // hls/stages/health.hpp:120
  logic [31:0] select_34;
  assign select_34 = first_s1_q ? 32'h0 : signature_q;
  logic [12:0] xor_35;
  assign xor_35 = {13{select_34[0]}} ^ {select_34[31:30], select_34[28:27], select_34[25:24], select_34[22:20], select_34[16], select_34[10:9], select_34[6]};
  logic [7:0] xor_36;
  assign xor_36 = left_0_q ^ {select_34[8:7], xor_35[0], select_34[5:1]};
  logic parity_37;
  assign parity_37 = ^{select_34[6], select_34[0], left_0_q[5]};
  // hls/stages/health.hpp:122
  logic [7:0] select_49;
  assign select_49 = first_s1_q ? left_0_q : ((left_0_q < darkest_q) ? left_0_q : darkest_q);
  // hls/stages/health.hpp:123
  logic [7:0] select_52;
  assign select_52 = first_s1_q ? left_0_q : ((brightest_q < left_0_q) ? left_0_q : brightest_q);
  logic not_54;
  assign not_54 = ~(cfg_dark_level_i < left_0_q);
  // hls/stages/health.hpp:124
  logic not_58;
  assign not_58 = ~(left_0_q < cfg_bright_level_i);
  // hls/stages/health.hpp:207
  logic [2:0] rows;
  assign rows = first_s1_q ? 3'h0 : rows_q;
  // hls/stages/health.hpp:190
  logic equal_73;
  assign equal_73 = rows[2:1] == 2'h0;
  // hls/stages/health.hpp:170
  logic [8:0] difference_74;
  assign difference_74 = {1'b0, left_0_q} - {1'b0, above_rdata_q[7:0]};
  logic [7:0] xor_75;
  assign xor_75 = difference_74[7:0] ^ {8{difference_74[8]}};
  logic [8:0] sum_76;
  assign sum_76 = {8'h0, difference_74[8]} + {1'b0, xor_75};
  // hls/stages/health.hpp:172
  logic [8:0] sum_77;
  assign sum_77 = sum_76 + 9'h1;
  // hls/stages/health.hpp:171
  logic [8:0] difference_78;
  assign difference_78 = {1'b0, left_0_q} - {1'b0, above_rdata_q[15:8]};
  logic [7:0] xor_79;
  assign xor_79 = difference_78[7:0] ^ {8{difference_78[8]}};
  logic [8:0] sum_80;
  assign sum_80 = {8'h0, difference_78[8]} + {1'b0, xor_79};
  // hls/stages/health.hpp:172
  logic [8:0] sum_82;
  assign sum_82 = sum_80 + 9'h1;
  logic less_83;
  assign less_83 = sum_82 < sum_76;
  // hls/stages/health.hpp:125
  logic [1:0] like;
  assign like = equal_32_s1_q ? (equal_73 ? 2'h0 : ((sum_77 < sum_80) ? 2'h1 : {2{less_83}})) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_87;
  assign equal_87 = like == 2'h1;
  logic equal_88;
  assign equal_88 = like == 2'h3;
  logic or_89;
  assign or_89 = equal_87 | equal_88;
  // hls/stages/health.hpp:196
  logic [19:0] sum_90;
  assign sum_90 = (first_s1_q ? 20'h0 : turn_q) + {{15{equal_87}}, 1'b0, {4{or_89}}};
  // hls/stages/health.hpp:178
  logic [1:0] select_92;
  assign select_92 = equal_87 ? 2'h1 : {2{equal_88}};
  // hls/stages/health.hpp:170
  logic [8:0] difference_98;
  assign difference_98 = {1'b0, left_0_q} - {1'b0, left_2_q};
  logic [7:0] xor_99;
  assign xor_99 = difference_98[7:0] ^ {8{difference_98[8]}};
  logic [8:0] sum_100;
  assign sum_100 = {8'h0, difference_98[8]} + {1'b0, xor_99};
  logic [8:0] difference_102;
  assign difference_102 = {1'b0, left_0_q} - {1'b0, left_3_s1_q};
  logic [7:0] xor_103;
  assign xor_103 = difference_102[7:0] ^ {8{difference_102[8]}};
  logic [8:0] sum_104;
  assign sum_104 = {8'h0, difference_102[8]} + {1'b0, xor_103};
  // hls/stages/health.hpp:172
  logic [8:0] sum_106;
  assign sum_106 = sum_104 + 9'h1;
  logic less_107;
  assign less_107 = sum_106 < sum_100;
  // hls/stages/health.hpp:125
  logic [1:0] like_2;
  assign like_2 = and_97_s1_q ? (((sum_100 + 9'h1) < sum_104) ? 2'h1 : {2{less_107}}) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_111;
  assign equal_111 = like_2 == 2'h3;
  // hls/stages/health.hpp:198
  logic [1:0] select_112;
  assign select_112 = (like_2 == 2'h1) ? 2'h1 : {2{equal_111}};
  logic [8:0] sum_113;
  assign sum_113 = {{2{equal_87}}, select_92[1], equal_87, 1'b0, {4{select_92[0]}}} + {{3{select_112[1]}}, 1'b0, {5{select_112[0]}}};
  // hls/stages/health.hpp:172
  logic less_117;
  assign less_117 = sum_77 < sum_104;
  // hls/stages/health.hpp:125
  logic [1:0] like_3;
  assign like_3 = equal_32_s1_q ? (equal_73 ? 2'h0 : ((sum_106 < sum_76) ? 2'h1 : {2{less_117}})) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_122;
  assign equal_122 = like_3 == 2'h3;
  logic [1:0] select_123;
  assign select_123 = (like_3 == 2'h1) ? 2'h1 : {2{equal_122}};
  // hls/stages/health.hpp:199
  logic [19:0] sum_124;
  assign sum_124 = (first_s1_q ? 20'h0 : level_q) + {{15{select_123[1]}}, 1'b0, {4{select_123[0]}}};
  // hls/stages/health.hpp:171
  logic [8:0] difference_126;
  assign difference_126 = {1'b0, left_0_q} - {1'b0, above_rdata_q[31:24]};
  logic [7:0] xor_127;
  assign xor_127 = difference_126[7:0] ^ {8{difference_126[8]}};
  logic [8:0] sum_128;
  assign sum_128 = {8'h0, difference_126[8]} + {1'b0, xor_127};
  // hls/stages/health.hpp:172
  logic less_131;
  assign less_131 = (sum_128 + 9'h1) < sum_80;
  // hls/stages/health.hpp:125
  logic [1:0] select_134;
  assign select_134 = equal_32_s1_q ? (rows[2] ? ((sum_82 < sum_128) ? 2'h1 : {2{less_131}}) : 2'h0) : 2'h0;
  // hls/stages/health.hpp:178
  logic equal_136;
  assign equal_136 = select_134 == 2'h1;
  // hls/stages/health.hpp:200
  logic or_137;
  assign or_137 = (select_134 == 2'h3) | equal_136;
  logic [19:0] sum_138;
  assign sum_138 = (first_s1_q ? 20'h0 : pair_q) + {{15{equal_136}}, 1'b0, {4{or_137}}};
  // hls/stages/health.hpp:202
  logic [2:0] select_141;
  assign select_141 = y_s1_q ? (3'h0 - {like[1], like}) : {like[1], like};
  logic [15:0] sum_142;
  assign sum_142 = (first_s1_q ? 16'h0 : even_less_odd_q) + {{13{select_141[2]}}, select_141};

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = place_s1_q;
  logic above_we;
  assign above_we = s1_en & equal_32_s1_q;
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
      signature_q <= {select_34[0], xor_35[12:11], select_34[29], xor_35[10:9], select_34[26], xor_35[8:7], select_34[23], xor_35[6:4], select_34[19:17], xor_35[3], select_34[15:11], xor_35[2:1], xor_36[7:6], parity_37, xor_36[4:0]};
      darkest_q <= select_49;
      brightest_q <= select_52;
      dark_q <= {17'h0, not_54} + (first_s1_q ? 18'h0 : dark_q);
      bright_q <= {17'h0, not_58} + (first_s1_q ? 18'h0 : bright_q);
      rows_q <= (last_s1_q & (~(rows == 3'h4))) ? (rows + 3'h1) : rows;
      turn_q <= sum_90;
      aside_q <= (first_s1_q ? 22'h0 : aside_q) + {{13{sum_113[8]}}, sum_113};
      level_q <= sum_124;
      pair_q <= sum_138;
      even_less_odd_q <= sum_142;
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
  logic [7:0] select_44;
  assign select_44 = (previous_signature_q == signature_q) ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  logic [7:0] select_45;
  assign select_45 = has_previous_q ? select_44 : 8'h0;
  // hls/stages/health.hpp:134
  logic less_143;
  assign less_143 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:135
  logic less_144;
  assign less_144 = cfg_bright_limit_i < bright_q;
  // hls/stages/health.hpp:136
  logic or_148;
  assign or_148 = less_144 | (less_143 | (cfg_contrast_limit_i < (brightest_q - darkest_q)));
  logic not_149;
  assign not_149 = ~or_148;
  // hls/stages/health.hpp:137
  logic less_151;
  assign less_151 = (cfg_frozen_limit_i + 8'hff) < select_45;
  // hls/stages/health.hpp:140
  logic and_155;
  assign and_155 = ($signed(22'h1f40) < $signed(aside_q)) & ($signed(20'h640) < $signed(level_q));
  // hls/stages/health.hpp:141
  logic [20:0] sum_157;
  assign sum_157 = {pair_q[19], pair_q} + {{2{pair_q[19]}}, pair_q[19:1]};
  logic [14:0] xor_158;
  assign xor_158 = even_less_odd_q[14:0] ^ {15{even_less_odd_q[15]}};
  logic [15:0] sum_159;
  assign sum_159 = {15'h0, even_less_odd_q[15]} + {1'b0, xor_158};
  logic less_160;
  assign less_160 = $signed({{2{sum_157[20]}}, sum_157[20:6]}) < $signed({1'b0, sum_159});
  // hls/stages/health.hpp:144
  logic or_163;
  assign or_163 = ($signed(20'h300) < $signed(turn_q)) | (and_155 | (($signed(20'h640) < $signed(pair_q)) & less_160));
  logic [4:0] select_164;
  assign select_164 = end_v_s2_q ? {or_163, less_151, not_149, less_144, less_143} : 5'h0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      previous_signature_q <= 32'h0;
      has_previous_q <= 1'b0;
      repeats_q <= 8'h0;
    end else if (s2_en) begin
      previous_signature_q <= end_v_s2_q ? signature_q : previous_signature_q;
      has_previous_q <= end_v_s2_q | has_previous_q;
      repeats_q <= end_v_s2_q ? select_45 : repeats_q;
    end
  end

  logic [4:0] select_164_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      select_164_s3_q <= select_164;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_164_s3_q[0];
  assign white_o = select_164_s3_q[1];
  assign constant_o = select_164_s3_q[2];
  assign frozen_o = select_164_s3_q[3];
  assign torn_o = select_164_s3_q[4];
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
  assign unused_bits = ^{sum_157[5:0], xor_36[5]};

endmodule
