// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Paths<horopter::hls::profiles::vga>, hls/stages/plane_paths.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 13 bits, pipeline 763 bits, memories 72960 bits.
module horopter_plane_paths (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [10:0] sum_0_i,
  input  logic [10:0] sum_1_i,
  input  logic [10:0] sum_2_i,
  input  logic [10:0] sum_3_i,
  input  logic [10:0] sum_4_i,
  input  logic [10:0] sum_5_i,
  input  logic [10:0] sum_6_i,
  input  logic [10:0] sum_7_i,
  input  logic [10:0] sum_8_i,
  input  logic [10:0] sum_9_i,
  input  logic [10:0] sum_10_i,
  input  logic [10:0] sum_11_i,
  input  logic [10:0] sum_12_i,
  input  logic [10:0] sum_13_i,
  input  logic [10:0] sum_14_i,
  input  logic [10:0] sum_15_i,
  input  logic [10:0] sum_16_i,
  input  logic [10:0] sum_17_i,
  input  logic [10:0] sum_18_i,
  input  logic [10:0] evidence_i,
  input  logic [5:0] grey_i,
  input  logic known_i,
  input  logic exists_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  output logic valid_o,
  output logic [11:0] cost_0_o,
  output logic [11:0] cost_1_o,
  output logic [11:0] cost_2_o,
  output logic [11:0] cost_3_o,
  output logic [11:0] cost_4_o,
  output logic [11:0] cost_5_o,
  output logic [11:0] cost_6_o,
  output logic [11:0] cost_7_o,
  output logic [11:0] cost_8_o,
  output logic [11:0] cost_9_o,
  output logic [11:0] cost_10_o,
  output logic [11:0] cost_11_o,
  output logic [11:0] cost_12_o,
  output logic [11:0] cost_13_o,
  output logic [11:0] cost_14_o,
  output logic [11:0] cost_15_o,
  output logic [11:0] cost_16_o,
  output logic [11:0] cost_17_o,
  output logic [11:0] cost_18_o,
  output logic [5:0] grey_o,
  output logic known_o,
  output logic evident_o,
  output logic strong_v_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q;
  logic s0_en, s1_en, s2_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [9:0] raster_column_q;
  logic raster_row_ended_q;
  logic running_q;
  // hls/stages/plane_paths.hpp:79
  logic [9:0] select_32;
  assign select_32 = marks_first_i ? 10'h0 : (raster_row_ended_q ? 10'h0 : (raster_column_q + 10'h1));
  // hls/stages/plane_paths.hpp:82
  logic or_34;
  assign or_34 = marks_first_i | running_q;
  // hls/stages/plane_paths.hpp:113
  logic [10:0] select_318;
  assign select_318 = (sum_17_i < sum_16_i) ? sum_17_i : sum_16_i;
  logic [10:0] select_320;
  assign select_320 = (sum_18_i < select_318) ? sum_18_i : select_318;
  logic [10:0] select_322;
  assign select_322 = (sum_15_i < sum_14_i) ? sum_15_i : sum_14_i;
  logic [10:0] select_324;
  assign select_324 = (sum_13_i < sum_12_i) ? sum_13_i : sum_12_i;
  logic [10:0] select_326;
  assign select_326 = (select_322 < select_324) ? select_322 : select_324;
  logic [10:0] select_328;
  assign select_328 = (sum_11_i < sum_10_i) ? sum_11_i : sum_10_i;
  logic [10:0] select_330;
  assign select_330 = (sum_9_i < sum_8_i) ? sum_9_i : sum_8_i;
  logic [10:0] select_332;
  assign select_332 = (select_328 < select_330) ? select_328 : select_330;
  logic [10:0] select_334;
  assign select_334 = (select_326 < select_332) ? select_326 : select_332;
  logic [10:0] select_336;
  assign select_336 = (sum_7_i < sum_6_i) ? sum_7_i : sum_6_i;
  logic [10:0] select_338;
  assign select_338 = (sum_5_i < sum_4_i) ? sum_5_i : sum_4_i;
  logic [10:0] select_340;
  assign select_340 = (select_336 < select_338) ? select_336 : select_338;
  logic [10:0] select_342;
  assign select_342 = (sum_3_i < sum_2_i) ? sum_3_i : sum_2_i;
  logic [10:0] select_344;
  assign select_344 = (sum_1_i < sum_0_i) ? sum_1_i : sum_0_i;
  logic [10:0] select_346;
  assign select_346 = (select_342 < select_344) ? select_342 : select_344;
  logic [10:0] select_348;
  assign select_348 = (select_340 < select_346) ? select_340 : select_346;
  logic [10:0] select_350;
  assign select_350 = (select_334 < select_348) ? select_334 : select_348;
  logic [10:0] select_352;
  assign select_352 = (select_320 < select_350) ? select_320 : select_350;
  // hls/stages/plane_paths.hpp:61
  logic [11:0] sum_353;
  assign sum_353 = {1'b0, evidence_i} + {3'h0, evidence_i[10:2]};
  logic [11:0] sum_354;
  assign sum_354 = {1'b0, evidence_i} + {1'b0, sum_353[11:1]};
  // hls/stages/plane_paths.hpp:63
  logic less_356;
  assign less_356 = 10'h13a < evidence_i[10:1];
  // hls/stages/plane_paths.hpp:64
  logic or_357;
  assign or_357 = ({select_352, 4'h0} < {sum_354, sum_353[0], evidence_i[1:0]}) | less_356;

  // Memory memory, 640 x 114, DISTANCE 16, hls/stages/plane_paths.hpp:119; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [113:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 114'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = running_q ? select_32 : 10'h0;
  logic memory_re;
  assign memory_re = s0_en & or_34;
  logic [113:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_32;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_34 : (marks_first_i & or_34);
    end
  end

  logic [10:0] sum_0_s1_q;
  logic [10:0] sum_1_s1_q;
  logic [10:0] sum_2_s1_q;
  logic [10:0] sum_3_s1_q;
  logic [10:0] sum_4_s1_q;
  logic [10:0] sum_5_s1_q;
  logic [10:0] sum_6_s1_q;
  logic [10:0] sum_7_s1_q;
  logic [10:0] sum_8_s1_q;
  logic [10:0] sum_9_s1_q;
  logic [10:0] sum_10_s1_q;
  logic [10:0] sum_11_s1_q;
  logic [10:0] sum_12_s1_q;
  logic [10:0] sum_13_s1_q;
  logic [10:0] sum_14_s1_q;
  logic [10:0] sum_15_s1_q;
  logic [10:0] sum_16_s1_q;
  logic [10:0] sum_17_s1_q;
  logic [10:0] sum_18_s1_q;
  logic [5:0] grey_s1_q;
  logic known_s1_q;
  logic exists_s1_q;
  logic marks_first_s1_q;
  logic running_s1_q;
  logic less_356_s1_q;
  logic and_358_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      sum_0_s1_q <= sum_0_i;
      sum_1_s1_q <= sum_1_i;
      sum_2_s1_q <= sum_2_i;
      sum_3_s1_q <= sum_3_i;
      sum_4_s1_q <= sum_4_i;
      sum_5_s1_q <= sum_5_i;
      sum_6_s1_q <= sum_6_i;
      sum_7_s1_q <= sum_7_i;
      sum_8_s1_q <= sum_8_i;
      sum_9_s1_q <= sum_9_i;
      sum_10_s1_q <= sum_10_i;
      sum_11_s1_q <= sum_11_i;
      sum_12_s1_q <= sum_12_i;
      sum_13_s1_q <= sum_13_i;
      sum_14_s1_q <= sum_14_i;
      sum_15_s1_q <= sum_15_i;
      sum_16_s1_q <= sum_16_i;
      sum_17_s1_q <= sum_17_i;
      sum_18_s1_q <= sum_18_i;
      grey_s1_q <= grey_i;
      known_s1_q <= known_i;
      exists_s1_q <= exists_i;
      marks_first_s1_q <= marks_first_i;
      running_s1_q <= running_q;
      less_356_s1_q <= less_356;
      and_358_s1_q <= known_i & or_357;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/plane_paths.hpp:79
  logic and_37;
  assign and_37 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_39;
  assign select_39 = running_s1_q ? memory_rdata_q[5:0] : (marks_first_s1_q ? memory_rdata_q[5:0] : 6'h0);
  logic [5:0] price;
  assign price = and_37 ? select_39 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_41;
  assign sum_41 = {1'b0, sum_0_s1_q[10:2]} + {4'h0, price};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_43;
  assign select_43 = running_s1_q ? memory_rdata_q[113:108] : (marks_first_s1_q ? memory_rdata_q[113:108] : 6'h0);
  logic [5:0] price_2;
  assign price_2 = and_37 ? select_43 : 6'h0;
  logic [5:0] select_47;
  assign select_47 = running_s1_q ? memory_rdata_q[107:102] : (marks_first_s1_q ? memory_rdata_q[107:102] : 6'h0);
  logic [5:0] price_3;
  assign price_3 = and_37 ? select_47 : 6'h0;
  logic [5:0] select_51;
  assign select_51 = running_s1_q ? memory_rdata_q[101:96] : (marks_first_s1_q ? memory_rdata_q[101:96] : 6'h0);
  logic [5:0] price_4;
  assign price_4 = and_37 ? select_51 : 6'h0;
  logic [5:0] select_59;
  assign select_59 = running_s1_q ? memory_rdata_q[95:90] : (marks_first_s1_q ? memory_rdata_q[95:90] : 6'h0);
  logic [5:0] price_5;
  assign price_5 = and_37 ? select_59 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_61;
  assign sum_61 = {1'b0, sum_15_s1_q[10:2]} + {4'h0, price_5};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_63;
  assign select_63 = running_s1_q ? memory_rdata_q[89:84] : (marks_first_s1_q ? memory_rdata_q[89:84] : 6'h0);
  logic [5:0] price_6;
  assign price_6 = and_37 ? select_63 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_65;
  assign sum_65 = {1'b0, sum_14_s1_q[10:2]} + {4'h0, price_6};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_67;
  assign select_67 = ({sum_61, sum_15_s1_q[1:0]} < {sum_65, sum_14_s1_q[1:0]}) ? {sum_61, sum_15_s1_q[1:0]} : {sum_65, sum_14_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_69;
  assign select_69 = running_s1_q ? memory_rdata_q[77:72] : (marks_first_s1_q ? memory_rdata_q[77:72] : 6'h0);
  logic [5:0] opinion;
  assign opinion = and_37 ? select_69 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_71;
  assign sum_71 = {1'b0, opinion} + 7'h27;
  logic [5:0] select_72;
  assign select_72 = sum_71[6] ? 6'h3f : sum_71[5:0];
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_74;
  assign select_74 = running_s1_q ? memory_rdata_q[83:78] : (marks_first_s1_q ? memory_rdata_q[83:78] : 6'h0);
  logic [5:0] opinion_2;
  assign opinion_2 = and_37 ? select_74 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_7;
  assign price_7 = (select_72 < opinion_2) ? select_72 : opinion_2;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_78;
  assign sum_78 = {1'b0, sum_13_s1_q[10:2]} + {4'h0, price_7};
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_79;
  assign sum_79 = {1'b0, opinion_2} + 7'h27;
  logic [5:0] select_80;
  assign select_80 = sum_79[6] ? 6'h3f : sum_79[5:0];
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_82;
  assign select_82 = running_s1_q ? memory_rdata_q[71:66] : (marks_first_s1_q ? memory_rdata_q[71:66] : 6'h0);
  logic [5:0] opinion_3;
  assign opinion_3 = and_37 ? select_82 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_84;
  assign sum_84 = {1'b0, opinion_3} + 7'h27;
  logic [5:0] select_85;
  assign select_85 = sum_84[6] ? 6'h3f : sum_84[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_8;
  assign price_8 = (select_85 < opinion) ? select_85 : opinion;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_9;
  assign price_9 = (select_80 < price_8) ? select_80 : price_8;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_90;
  assign sum_90 = {1'b0, sum_12_s1_q[10:2]} + {4'h0, price_9};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_92;
  assign select_92 = ({sum_78, sum_13_s1_q[1:0]} < {sum_90, sum_12_s1_q[1:0]}) ? {sum_78, sum_13_s1_q[1:0]} : {sum_90, sum_12_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_96;
  assign select_96 = running_s1_q ? memory_rdata_q[65:60] : (marks_first_s1_q ? memory_rdata_q[65:60] : 6'h0);
  logic [5:0] opinion_4;
  assign opinion_4 = and_37 ? select_96 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_98;
  assign sum_98 = {1'b0, opinion_4} + 7'h27;
  logic [5:0] select_99;
  assign select_99 = sum_98[6] ? 6'h3f : sum_98[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_10;
  assign price_10 = (select_99 < opinion_3) ? select_99 : opinion_3;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_11;
  assign price_11 = (select_72 < price_10) ? select_72 : price_10;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_104;
  assign sum_104 = {1'b0, sum_11_s1_q[10:2]} + {4'h0, price_11};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_106;
  assign select_106 = running_s1_q ? memory_rdata_q[59:54] : (marks_first_s1_q ? memory_rdata_q[59:54] : 6'h0);
  logic [5:0] opinion_5;
  assign opinion_5 = and_37 ? select_106 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_108;
  assign sum_108 = {1'b0, opinion_5} + 7'h27;
  logic [5:0] select_109;
  assign select_109 = sum_108[6] ? 6'h3f : sum_108[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_12;
  assign price_12 = (select_109 < opinion_4) ? select_109 : opinion_4;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_13;
  assign price_13 = (select_85 < price_12) ? select_85 : price_12;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_114;
  assign sum_114 = {1'b0, sum_10_s1_q[10:2]} + {4'h0, price_13};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_116;
  assign select_116 = ({sum_104, sum_11_s1_q[1:0]} < {sum_114, sum_10_s1_q[1:0]}) ? {sum_104, sum_11_s1_q[1:0]} : {sum_114, sum_10_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_118;
  assign select_118 = running_s1_q ? memory_rdata_q[53:48] : (marks_first_s1_q ? memory_rdata_q[53:48] : 6'h0);
  logic [5:0] opinion_6;
  assign opinion_6 = and_37 ? select_118 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_120;
  assign sum_120 = {1'b0, opinion_6} + 7'h27;
  logic [5:0] select_121;
  assign select_121 = sum_120[6] ? 6'h3f : sum_120[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_14;
  assign price_14 = (select_121 < opinion_5) ? select_121 : opinion_5;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_15;
  assign price_15 = (select_99 < price_14) ? select_99 : price_14;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_126;
  assign sum_126 = {1'b0, sum_9_s1_q[10:2]} + {4'h0, price_15};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_128;
  assign select_128 = running_s1_q ? memory_rdata_q[47:42] : (marks_first_s1_q ? memory_rdata_q[47:42] : 6'h0);
  logic [5:0] opinion_7;
  assign opinion_7 = and_37 ? select_128 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_130;
  assign sum_130 = {1'b0, opinion_7} + 7'h27;
  logic [5:0] select_131;
  assign select_131 = sum_130[6] ? 6'h3f : sum_130[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_16;
  assign price_16 = (select_131 < opinion_6) ? select_131 : opinion_6;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_17;
  assign price_17 = (select_109 < price_16) ? select_109 : price_16;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_136;
  assign sum_136 = {1'b0, sum_8_s1_q[10:2]} + {4'h0, price_17};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_138;
  assign select_138 = ({sum_126, sum_9_s1_q[1:0]} < {sum_136, sum_8_s1_q[1:0]}) ? {sum_126, sum_9_s1_q[1:0]} : {sum_136, sum_8_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_144;
  assign select_144 = running_s1_q ? memory_rdata_q[41:36] : (marks_first_s1_q ? memory_rdata_q[41:36] : 6'h0);
  logic [5:0] opinion_8;
  assign opinion_8 = and_37 ? select_144 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_146;
  assign sum_146 = {1'b0, opinion_8} + 7'h27;
  logic [5:0] select_147;
  assign select_147 = sum_146[6] ? 6'h3f : sum_146[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_18;
  assign price_18 = (select_147 < opinion_7) ? select_147 : opinion_7;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_19;
  assign price_19 = (select_121 < price_18) ? select_121 : price_18;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_152;
  assign sum_152 = {1'b0, sum_7_s1_q[10:2]} + {4'h0, price_19};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_154;
  assign select_154 = running_s1_q ? memory_rdata_q[35:30] : (marks_first_s1_q ? memory_rdata_q[35:30] : 6'h0);
  logic [5:0] opinion_9;
  assign opinion_9 = and_37 ? select_154 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_156;
  assign sum_156 = {1'b0, opinion_9} + 7'h27;
  logic [5:0] select_157;
  assign select_157 = sum_156[6] ? 6'h3f : sum_156[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_20;
  assign price_20 = (select_157 < opinion_8) ? select_157 : opinion_8;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_21;
  assign price_21 = (select_131 < price_20) ? select_131 : price_20;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_162;
  assign sum_162 = {1'b0, sum_6_s1_q[10:2]} + {4'h0, price_21};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_164;
  assign select_164 = ({sum_152, sum_7_s1_q[1:0]} < {sum_162, sum_6_s1_q[1:0]}) ? {sum_152, sum_7_s1_q[1:0]} : {sum_162, sum_6_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_22;
  assign price_22 = (select_147 < opinion_9) ? select_147 : opinion_9;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_167;
  assign sum_167 = {1'b0, sum_5_s1_q[10:2]} + {4'h0, price_22};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_169;
  assign select_169 = running_s1_q ? memory_rdata_q[29:24] : (marks_first_s1_q ? memory_rdata_q[29:24] : 6'h0);
  logic [5:0] price_23;
  assign price_23 = and_37 ? select_169 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_171;
  assign sum_171 = {1'b0, sum_4_s1_q[10:2]} + {4'h0, price_23};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_173;
  assign select_173 = ({sum_167, sum_5_s1_q[1:0]} < {sum_171, sum_4_s1_q[1:0]}) ? {sum_167, sum_5_s1_q[1:0]} : {sum_171, sum_4_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_177;
  assign select_177 = running_s1_q ? memory_rdata_q[23:18] : (marks_first_s1_q ? memory_rdata_q[23:18] : 6'h0);
  logic [5:0] price_24;
  assign price_24 = and_37 ? select_177 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_179;
  assign sum_179 = {1'b0, sum_3_s1_q[10:2]} + {4'h0, price_24};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_181;
  assign select_181 = running_s1_q ? memory_rdata_q[17:12] : (marks_first_s1_q ? memory_rdata_q[17:12] : 6'h0);
  logic [5:0] price_25;
  assign price_25 = and_37 ? select_181 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_183;
  assign sum_183 = {1'b0, sum_2_s1_q[10:2]} + {4'h0, price_25};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_185;
  assign select_185 = ({sum_179, sum_3_s1_q[1:0]} < {sum_183, sum_2_s1_q[1:0]}) ? {sum_179, sum_3_s1_q[1:0]} : {sum_183, sum_2_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_187;
  assign select_187 = running_s1_q ? memory_rdata_q[11:6] : (marks_first_s1_q ? memory_rdata_q[11:6] : 6'h0);
  logic [5:0] price_26;
  assign price_26 = and_37 ? select_187 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_189;
  assign sum_189 = {1'b0, sum_1_s1_q[10:2]} + {4'h0, price_26};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_191;
  assign select_191 = ({sum_189, sum_1_s1_q[1:0]} < {sum_41, sum_0_s1_q[1:0]}) ? {sum_189, sum_1_s1_q[1:0]} : {sum_41, sum_0_s1_q[1:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_37;
    end
  end

  logic [1:0] sum_0_s2_q;
  logic [1:0] sum_1_s2_q;
  logic [1:0] sum_2_s2_q;
  logic [1:0] sum_3_s2_q;
  logic [1:0] sum_4_s2_q;
  logic [1:0] sum_5_s2_q;
  logic [1:0] sum_6_s2_q;
  logic [1:0] sum_7_s2_q;
  logic [1:0] sum_8_s2_q;
  logic [1:0] sum_9_s2_q;
  logic [1:0] sum_10_s2_q;
  logic [1:0] sum_11_s2_q;
  logic [1:0] sum_12_s2_q;
  logic [1:0] sum_13_s2_q;
  logic [1:0] sum_14_s2_q;
  logic [1:0] sum_15_s2_q;
  logic [1:0] sum_16_s2_q;
  logic [1:0] sum_17_s2_q;
  logic [1:0] sum_18_s2_q;
  logic [5:0] grey_s2_q;
  logic known_s2_q;
  logic exists_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic [9:0] select_32_s2_q;
  logic [9:0] sum_41_s2_q;
  logic [9:0] sum_45_s2_q;
  logic [9:0] sum_49_s2_q;
  logic [9:0] sum_53_s2_q;
  logic [9:0] sum_61_s2_q;
  logic [9:0] sum_65_s2_q;
  logic [9:0] sum_78_s2_q;
  logic [9:0] sum_90_s2_q;
  logic [11:0] select_94_s2_q;
  logic [9:0] sum_104_s2_q;
  logic [9:0] sum_114_s2_q;
  logic [9:0] sum_126_s2_q;
  logic [9:0] sum_136_s2_q;
  logic [11:0] select_140_s2_q;
  logic [9:0] sum_152_s2_q;
  logic [9:0] sum_162_s2_q;
  logic [9:0] sum_167_s2_q;
  logic [9:0] sum_171_s2_q;
  logic [11:0] select_175_s2_q;
  logic [9:0] sum_179_s2_q;
  logic [9:0] sum_183_s2_q;
  logic [9:0] sum_189_s2_q;
  logic [11:0] select_193_s2_q;
  logic select_315_s2_q;
  logic less_356_s2_q;
  logic and_358_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      sum_0_s2_q <= sum_0_s1_q[1:0];
      sum_1_s2_q <= sum_1_s1_q[1:0];
      sum_2_s2_q <= sum_2_s1_q[1:0];
      sum_3_s2_q <= sum_3_s1_q[1:0];
      sum_4_s2_q <= sum_4_s1_q[1:0];
      sum_5_s2_q <= sum_5_s1_q[1:0];
      sum_6_s2_q <= sum_6_s1_q[1:0];
      sum_7_s2_q <= sum_7_s1_q[1:0];
      sum_8_s2_q <= sum_8_s1_q[1:0];
      sum_9_s2_q <= sum_9_s1_q[1:0];
      sum_10_s2_q <= sum_10_s1_q[1:0];
      sum_11_s2_q <= sum_11_s1_q[1:0];
      sum_12_s2_q <= sum_12_s1_q[1:0];
      sum_13_s2_q <= sum_13_s1_q[1:0];
      sum_14_s2_q <= sum_14_s1_q[1:0];
      sum_15_s2_q <= sum_15_s1_q[1:0];
      sum_16_s2_q <= sum_16_s1_q[1:0];
      sum_17_s2_q <= sum_17_s1_q[1:0];
      sum_18_s2_q <= sum_18_s1_q[1:0];
      grey_s2_q <= grey_s1_q;
      known_s2_q <= known_s1_q;
      exists_s2_q <= exists_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      select_32_s2_q <= raster_column_q;
      sum_41_s2_q <= sum_41;
      sum_45_s2_q <= {1'b0, sum_18_s1_q[10:2]} + {4'h0, price_2};
      sum_49_s2_q <= {1'b0, sum_17_s1_q[10:2]} + {4'h0, price_3};
      sum_53_s2_q <= {1'b0, sum_16_s1_q[10:2]} + {4'h0, price_4};
      sum_61_s2_q <= sum_61;
      sum_65_s2_q <= sum_65;
      sum_78_s2_q <= sum_78;
      sum_90_s2_q <= sum_90;
      select_94_s2_q <= (select_67 < select_92) ? select_67 : select_92;
      sum_104_s2_q <= sum_104;
      sum_114_s2_q <= sum_114;
      sum_126_s2_q <= sum_126;
      sum_136_s2_q <= sum_136;
      select_140_s2_q <= (select_116 < select_138) ? select_116 : select_138;
      sum_152_s2_q <= sum_152;
      sum_162_s2_q <= sum_162;
      sum_167_s2_q <= sum_167;
      sum_171_s2_q <= sum_171;
      select_175_s2_q <= (select_164 < select_173) ? select_164 : select_173;
      sum_179_s2_q <= sum_179;
      sum_183_s2_q <= sum_183;
      sum_189_s2_q <= sum_189;
      select_193_s2_q <= (select_185 < select_191) ? select_185 : select_191;
      select_315_s2_q <= running_q;
      less_356_s2_q <= less_356_s1_q;
      and_358_s2_q <= and_358_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_55;
  assign select_55 = ({sum_49_s2_q, sum_17_s2_q} < {sum_53_s2_q, sum_16_s2_q}) ? {sum_49_s2_q, sum_17_s2_q} : {sum_53_s2_q, sum_16_s2_q};
  logic [11:0] select_57;
  assign select_57 = ({sum_45_s2_q, sum_18_s2_q} < select_55) ? {sum_45_s2_q, sum_18_s2_q} : select_55;
  logic [11:0] select_142;
  assign select_142 = (select_94_s2_q < select_140_s2_q) ? select_94_s2_q : select_140_s2_q;
  logic [11:0] select_195;
  assign select_195 = (select_175_s2_q < select_193_s2_q) ? select_175_s2_q : select_193_s2_q;
  logic [11:0] select_197;
  assign select_197 = (select_142 < select_195) ? select_142 : select_195;
  logic [11:0] best;
  assign best = (select_57 < select_197) ? select_57 : select_197;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_200;
  assign difference_200 = {sum_41_s2_q, sum_0_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_202;
  assign select_202 = (difference_200[11:8] == 4'h0) ? difference_200[7:2] : 6'h3f;
  logic [6:0] sum_203;
  assign sum_203 = {1'b0, select_202} + 7'h3;
  logic [5:0] select_205;
  assign select_205 = known_s2_q ? (select_202 - {1'b0, sum_203[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_206;
  assign difference_206 = {sum_189_s2_q, sum_1_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_208;
  assign select_208 = (difference_206[11:8] == 4'h0) ? difference_206[7:2] : 6'h3f;
  logic [6:0] sum_209;
  assign sum_209 = {1'b0, select_208} + 7'h3;
  logic [5:0] select_211;
  assign select_211 = known_s2_q ? (select_208 - {1'b0, sum_209[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_212;
  assign difference_212 = {sum_183_s2_q, sum_2_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_214;
  assign select_214 = (difference_212[11:8] == 4'h0) ? difference_212[7:2] : 6'h3f;
  logic [6:0] sum_215;
  assign sum_215 = {1'b0, select_214} + 7'h3;
  logic [5:0] select_217;
  assign select_217 = known_s2_q ? (select_214 - {1'b0, sum_215[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_218;
  assign difference_218 = {sum_179_s2_q, sum_3_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_220;
  assign select_220 = (difference_218[11:8] == 4'h0) ? difference_218[7:2] : 6'h3f;
  logic [6:0] sum_221;
  assign sum_221 = {1'b0, select_220} + 7'h3;
  logic [5:0] select_223;
  assign select_223 = known_s2_q ? (select_220 - {1'b0, sum_221[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_224;
  assign difference_224 = {sum_171_s2_q, sum_4_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_226;
  assign select_226 = (difference_224[11:8] == 4'h0) ? difference_224[7:2] : 6'h3f;
  logic [6:0] sum_227;
  assign sum_227 = {1'b0, select_226} + 7'h3;
  logic [5:0] select_229;
  assign select_229 = known_s2_q ? (select_226 - {1'b0, sum_227[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_230;
  assign difference_230 = {sum_167_s2_q, sum_5_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_232;
  assign select_232 = (difference_230[11:8] == 4'h0) ? difference_230[7:2] : 6'h3f;
  logic [6:0] sum_233;
  assign sum_233 = {1'b0, select_232} + 7'h3;
  logic [5:0] select_235;
  assign select_235 = known_s2_q ? (select_232 - {1'b0, sum_233[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_236;
  assign difference_236 = {sum_162_s2_q, sum_6_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_238;
  assign select_238 = (difference_236[11:8] == 4'h0) ? difference_236[7:2] : 6'h3f;
  logic [6:0] sum_239;
  assign sum_239 = {1'b0, select_238} + 7'h3;
  logic [5:0] select_241;
  assign select_241 = known_s2_q ? (select_238 - {1'b0, sum_239[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_242;
  assign difference_242 = {sum_152_s2_q, sum_7_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_244;
  assign select_244 = (difference_242[11:8] == 4'h0) ? difference_242[7:2] : 6'h3f;
  logic [6:0] sum_245;
  assign sum_245 = {1'b0, select_244} + 7'h3;
  logic [5:0] select_247;
  assign select_247 = known_s2_q ? (select_244 - {1'b0, sum_245[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_248;
  assign difference_248 = {sum_136_s2_q, sum_8_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_250;
  assign select_250 = (difference_248[11:8] == 4'h0) ? difference_248[7:2] : 6'h3f;
  logic [6:0] sum_251;
  assign sum_251 = {1'b0, select_250} + 7'h3;
  logic [5:0] select_253;
  assign select_253 = known_s2_q ? (select_250 - {1'b0, sum_251[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_254;
  assign difference_254 = {sum_126_s2_q, sum_9_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_256;
  assign select_256 = (difference_254[11:8] == 4'h0) ? difference_254[7:2] : 6'h3f;
  logic [6:0] sum_257;
  assign sum_257 = {1'b0, select_256} + 7'h3;
  logic [5:0] select_259;
  assign select_259 = known_s2_q ? (select_256 - {1'b0, sum_257[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_260;
  assign difference_260 = {sum_114_s2_q, sum_10_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_262;
  assign select_262 = (difference_260[11:8] == 4'h0) ? difference_260[7:2] : 6'h3f;
  logic [6:0] sum_263;
  assign sum_263 = {1'b0, select_262} + 7'h3;
  logic [5:0] select_265;
  assign select_265 = known_s2_q ? (select_262 - {1'b0, sum_263[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_266;
  assign difference_266 = {sum_104_s2_q, sum_11_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_268;
  assign select_268 = (difference_266[11:8] == 4'h0) ? difference_266[7:2] : 6'h3f;
  logic [6:0] sum_269;
  assign sum_269 = {1'b0, select_268} + 7'h3;
  logic [5:0] select_271;
  assign select_271 = known_s2_q ? (select_268 - {1'b0, sum_269[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_272;
  assign difference_272 = {sum_90_s2_q, sum_12_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_274;
  assign select_274 = (difference_272[11:8] == 4'h0) ? difference_272[7:2] : 6'h3f;
  logic [6:0] sum_275;
  assign sum_275 = {1'b0, select_274} + 7'h3;
  logic [5:0] select_277;
  assign select_277 = known_s2_q ? (select_274 - {1'b0, sum_275[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_278;
  assign difference_278 = {sum_78_s2_q, sum_13_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_280;
  assign select_280 = (difference_278[11:8] == 4'h0) ? difference_278[7:2] : 6'h3f;
  logic [6:0] sum_281;
  assign sum_281 = {1'b0, select_280} + 7'h3;
  logic [5:0] select_283;
  assign select_283 = known_s2_q ? (select_280 - {1'b0, sum_281[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_284;
  assign difference_284 = {sum_65_s2_q, sum_14_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_286;
  assign select_286 = (difference_284[11:8] == 4'h0) ? difference_284[7:2] : 6'h3f;
  logic [6:0] sum_287;
  assign sum_287 = {1'b0, select_286} + 7'h3;
  logic [5:0] select_289;
  assign select_289 = known_s2_q ? (select_286 - {1'b0, sum_287[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_290;
  assign difference_290 = {sum_61_s2_q, sum_15_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_292;
  assign select_292 = (difference_290[11:8] == 4'h0) ? difference_290[7:2] : 6'h3f;
  logic [6:0] sum_293;
  assign sum_293 = {1'b0, select_292} + 7'h3;
  logic [5:0] select_295;
  assign select_295 = known_s2_q ? (select_292 - {1'b0, sum_293[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_296;
  assign difference_296 = {sum_53_s2_q, sum_16_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_298;
  assign select_298 = (difference_296[11:8] == 4'h0) ? difference_296[7:2] : 6'h3f;
  logic [6:0] sum_299;
  assign sum_299 = {1'b0, select_298} + 7'h3;
  logic [5:0] select_301;
  assign select_301 = known_s2_q ? (select_298 - {1'b0, sum_299[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_302;
  assign difference_302 = {sum_49_s2_q, sum_17_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_304;
  assign select_304 = (difference_302[11:8] == 4'h0) ? difference_302[7:2] : 6'h3f;
  logic [6:0] sum_305;
  assign sum_305 = {1'b0, select_304} + 7'h3;
  logic [5:0] select_307;
  assign select_307 = known_s2_q ? (select_304 - {1'b0, sum_305[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_308;
  assign difference_308 = {sum_45_s2_q, sum_18_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_310;
  assign select_310 = (difference_308[11:8] == 4'h0) ? difference_308[7:2] : 6'h3f;
  logic [6:0] sum_311;
  assign sum_311 = {1'b0, select_310} + 7'h3;
  logic [5:0] select_313;
  assign select_313 = known_s2_q ? (select_310 - {1'b0, sum_311[6:2]}) : 6'h0;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = select_32_s2_q;
  logic memory_we;
  assign memory_we = s2_en & select_315_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_313, select_307, select_301, select_295, select_289, select_283, select_277, select_271, select_265, select_259, select_253, select_247, select_241, select_235, select_229, select_223, select_217, select_211, select_205};
  end
`ifndef SYNTHESIS
  logic [9:0] memory_raddr_s1_sim;
  logic memory_re_s1_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      memory_re_s1_sim <= 1'b0;
    end else if (en_i) begin
      memory_re_s1_sim <= memory_re;
      memory_raddr_s1_sim <= memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && memory_we) begin
      if (memory_re && memory_raddr == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s1_sim && memory_raddr_s1_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_waddr >= 10'd640) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 10'd640) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  logic [1:0] sum_0_s3_q;
  logic [1:0] sum_1_s3_q;
  logic [1:0] sum_2_s3_q;
  logic [1:0] sum_3_s3_q;
  logic [1:0] sum_4_s3_q;
  logic [1:0] sum_5_s3_q;
  logic [1:0] sum_6_s3_q;
  logic [1:0] sum_7_s3_q;
  logic [1:0] sum_8_s3_q;
  logic [1:0] sum_9_s3_q;
  logic [1:0] sum_10_s3_q;
  logic [1:0] sum_11_s3_q;
  logic [1:0] sum_12_s3_q;
  logic [1:0] sum_13_s3_q;
  logic [1:0] sum_14_s3_q;
  logic [1:0] sum_15_s3_q;
  logic [1:0] sum_16_s3_q;
  logic [1:0] sum_17_s3_q;
  logic [1:0] sum_18_s3_q;
  logic [5:0] grey_s3_q;
  logic known_s3_q;
  logic exists_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic [9:0] sum_41_s3_q;
  logic [9:0] sum_45_s3_q;
  logic [9:0] sum_49_s3_q;
  logic [9:0] sum_53_s3_q;
  logic [9:0] sum_61_s3_q;
  logic [9:0] sum_65_s3_q;
  logic [9:0] sum_78_s3_q;
  logic [9:0] sum_90_s3_q;
  logic [9:0] sum_104_s3_q;
  logic [9:0] sum_114_s3_q;
  logic [9:0] sum_126_s3_q;
  logic [9:0] sum_136_s3_q;
  logic [9:0] sum_152_s3_q;
  logic [9:0] sum_162_s3_q;
  logic [9:0] sum_167_s3_q;
  logic [9:0] sum_171_s3_q;
  logic [9:0] sum_179_s3_q;
  logic [9:0] sum_183_s3_q;
  logic [9:0] sum_189_s3_q;
  logic less_356_s3_q;
  logic and_358_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      sum_0_s3_q <= sum_0_s2_q;
      sum_1_s3_q <= sum_1_s2_q;
      sum_2_s3_q <= sum_2_s2_q;
      sum_3_s3_q <= sum_3_s2_q;
      sum_4_s3_q <= sum_4_s2_q;
      sum_5_s3_q <= sum_5_s2_q;
      sum_6_s3_q <= sum_6_s2_q;
      sum_7_s3_q <= sum_7_s2_q;
      sum_8_s3_q <= sum_8_s2_q;
      sum_9_s3_q <= sum_9_s2_q;
      sum_10_s3_q <= sum_10_s2_q;
      sum_11_s3_q <= sum_11_s2_q;
      sum_12_s3_q <= sum_12_s2_q;
      sum_13_s3_q <= sum_13_s2_q;
      sum_14_s3_q <= sum_14_s2_q;
      sum_15_s3_q <= sum_15_s2_q;
      sum_16_s3_q <= sum_16_s2_q;
      sum_17_s3_q <= sum_17_s2_q;
      sum_18_s3_q <= sum_18_s2_q;
      grey_s3_q <= grey_s2_q;
      known_s3_q <= known_s2_q;
      exists_s3_q <= exists_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sum_41_s3_q <= sum_41_s2_q;
      sum_45_s3_q <= sum_45_s2_q;
      sum_49_s3_q <= sum_49_s2_q;
      sum_53_s3_q <= sum_53_s2_q;
      sum_61_s3_q <= sum_61_s2_q;
      sum_65_s3_q <= sum_65_s2_q;
      sum_78_s3_q <= sum_78_s2_q;
      sum_90_s3_q <= sum_90_s2_q;
      sum_104_s3_q <= sum_104_s2_q;
      sum_114_s3_q <= sum_114_s2_q;
      sum_126_s3_q <= sum_126_s2_q;
      sum_136_s3_q <= sum_136_s2_q;
      sum_152_s3_q <= sum_152_s2_q;
      sum_162_s3_q <= sum_162_s2_q;
      sum_167_s3_q <= sum_167_s2_q;
      sum_171_s3_q <= sum_171_s2_q;
      sum_179_s3_q <= sum_179_s2_q;
      sum_183_s3_q <= sum_183_s2_q;
      sum_189_s3_q <= sum_189_s2_q;
      less_356_s3_q <= less_356_s2_q;
      and_358_s3_q <= and_358_s2_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign cost_0_o = {sum_41_s3_q, sum_0_s3_q};
  assign cost_1_o = {sum_189_s3_q, sum_1_s3_q};
  assign cost_2_o = {sum_183_s3_q, sum_2_s3_q};
  assign cost_3_o = {sum_179_s3_q, sum_3_s3_q};
  assign cost_4_o = {sum_171_s3_q, sum_4_s3_q};
  assign cost_5_o = {sum_167_s3_q, sum_5_s3_q};
  assign cost_6_o = {sum_162_s3_q, sum_6_s3_q};
  assign cost_7_o = {sum_152_s3_q, sum_7_s3_q};
  assign cost_8_o = {sum_136_s3_q, sum_8_s3_q};
  assign cost_9_o = {sum_126_s3_q, sum_9_s3_q};
  assign cost_10_o = {sum_114_s3_q, sum_10_s3_q};
  assign cost_11_o = {sum_104_s3_q, sum_11_s3_q};
  assign cost_12_o = {sum_90_s3_q, sum_12_s3_q};
  assign cost_13_o = {sum_78_s3_q, sum_13_s3_q};
  assign cost_14_o = {sum_65_s3_q, sum_14_s3_q};
  assign cost_15_o = {sum_61_s3_q, sum_15_s3_q};
  assign cost_16_o = {sum_53_s3_q, sum_16_s3_q};
  assign cost_17_o = {sum_49_s3_q, sum_17_s3_q};
  assign cost_18_o = {sum_45_s3_q, sum_18_s3_q};
  assign grey_o = grey_s3_q;
  assign known_o = known_s3_q;
  assign evident_o = and_358_s3_q;
  assign strong_v_o = less_356_s3_q;
  assign exists_o = exists_s3_q;
  assign marks_first_o = marks_first_s3_q;
  assign marks_last_o = marks_last_s3_q;
  assign valid_o = valid_s3_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_311[1:0], difference_308[1:0], sum_305[1:0], difference_302[1:0], sum_299[1:0], difference_296[1:0], sum_293[1:0], difference_290[1:0], sum_287[1:0], difference_284[1:0], sum_281[1:0], difference_278[1:0], sum_275[1:0], difference_272[1:0], sum_269[1:0], difference_266[1:0], sum_263[1:0], difference_260[1:0], sum_257[1:0], difference_254[1:0], sum_251[1:0], difference_248[1:0], sum_245[1:0], difference_242[1:0], sum_239[1:0], difference_236[1:0], sum_233[1:0], difference_230[1:0], sum_227[1:0], difference_224[1:0], sum_221[1:0], difference_218[1:0], sum_215[1:0], difference_212[1:0], sum_209[1:0], difference_206[1:0], sum_203[1:0], difference_200[1:0]};

endmodule
