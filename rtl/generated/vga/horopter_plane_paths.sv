// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Paths<horopter::hls::profiles::vga>, hls/stages/plane_paths.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 13 bits, pipeline 769 bits, memories 73600 bits.
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
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic parity_error_o,
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
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
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
  logic [9:0] select_34;
  assign select_34 = marks_first_i ? 10'h0 : (raster_row_ended_q ? 10'h0 : (raster_column_q + 10'h1));
  // hls/stages/plane_paths.hpp:82
  logic or_36;
  assign or_36 = marks_first_i | running_q;
  // hls/stages/plane_paths.hpp:113
  logic [10:0] select_320;
  assign select_320 = (sum_17_i < sum_16_i) ? sum_17_i : sum_16_i;
  logic [10:0] select_322;
  assign select_322 = (sum_18_i < select_320) ? sum_18_i : select_320;
  logic [10:0] select_324;
  assign select_324 = (sum_15_i < sum_14_i) ? sum_15_i : sum_14_i;
  logic [10:0] select_326;
  assign select_326 = (sum_13_i < sum_12_i) ? sum_13_i : sum_12_i;
  logic [10:0] select_328;
  assign select_328 = (select_324 < select_326) ? select_324 : select_326;
  logic [10:0] select_330;
  assign select_330 = (sum_11_i < sum_10_i) ? sum_11_i : sum_10_i;
  logic [10:0] select_332;
  assign select_332 = (sum_9_i < sum_8_i) ? sum_9_i : sum_8_i;
  logic [10:0] select_334;
  assign select_334 = (select_330 < select_332) ? select_330 : select_332;
  logic [10:0] select_336;
  assign select_336 = (select_328 < select_334) ? select_328 : select_334;
  logic [10:0] select_338;
  assign select_338 = (sum_7_i < sum_6_i) ? sum_7_i : sum_6_i;
  logic [10:0] select_340;
  assign select_340 = (sum_5_i < sum_4_i) ? sum_5_i : sum_4_i;
  logic [10:0] select_342;
  assign select_342 = (select_338 < select_340) ? select_338 : select_340;
  logic [10:0] select_344;
  assign select_344 = (sum_3_i < sum_2_i) ? sum_3_i : sum_2_i;
  logic [10:0] select_346;
  assign select_346 = (sum_1_i < sum_0_i) ? sum_1_i : sum_0_i;
  logic [10:0] select_348;
  assign select_348 = (select_344 < select_346) ? select_344 : select_346;
  logic [10:0] select_350;
  assign select_350 = (select_342 < select_348) ? select_342 : select_348;
  logic [10:0] select_352;
  assign select_352 = (select_336 < select_350) ? select_336 : select_350;
  logic [10:0] select_354;
  assign select_354 = (select_322 < select_352) ? select_322 : select_352;
  // hls/stages/plane_paths.hpp:61
  logic [11:0] sum_355;
  assign sum_355 = {1'b0, evidence_i} + {3'h0, evidence_i[10:2]};
  logic [11:0] sum_356;
  assign sum_356 = {1'b0, evidence_i} + {1'b0, sum_355[11:1]};
  // hls/stages/plane_paths.hpp:63
  logic less_358;
  assign less_358 = 10'h13a < evidence_i[10:1];
  // hls/stages/plane_paths.hpp:64
  logic or_359;
  assign or_359 = ({select_354, 4'h0} < {sum_356, sum_355[0], evidence_i[1:0]}) | less_358;

  // Memory memory, 640 x 114 and parity, DISTANCE 16, hls/stages/plane_paths.hpp:119; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [114:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 115'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = running_q ? select_34 : 10'h0;
  logic memory_re;
  assign memory_re = s0_en & or_36;
  logic [114:0] memory_word_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_word_q <= memory_mem[memory_raddr];
  end
  logic [113:0] memory_rdata_q;
  assign memory_rdata_q = memory_word_q[113:0];
  logic memory_read_q, memory_error;
  always_ff @(posedge clk_i) memory_read_q <= rst_ni & memory_re;
  assign memory_error = memory_read_q & ^memory_word_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_34;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_36 : (marks_first_i & or_36);
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
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic running_s1_q;
  logic less_358_s1_q;
  logic and_360_s1_q;
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
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      running_s1_q <= running_q;
      less_358_s1_q <= less_358;
      and_360_s1_q <= known_i & or_359;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/plane_paths.hpp:79
  logic and_39;
  assign and_39 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_41;
  assign select_41 = running_s1_q ? memory_rdata_q[5:0] : (marks_first_s1_q ? memory_rdata_q[5:0] : 6'h0);
  logic [5:0] price;
  assign price = and_39 ? select_41 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_43;
  assign sum_43 = {1'b0, sum_0_s1_q[10:2]} + {4'h0, price};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_45;
  assign select_45 = running_s1_q ? memory_rdata_q[113:108] : (marks_first_s1_q ? memory_rdata_q[113:108] : 6'h0);
  logic [5:0] price_2;
  assign price_2 = and_39 ? select_45 : 6'h0;
  logic [5:0] select_49;
  assign select_49 = running_s1_q ? memory_rdata_q[107:102] : (marks_first_s1_q ? memory_rdata_q[107:102] : 6'h0);
  logic [5:0] price_3;
  assign price_3 = and_39 ? select_49 : 6'h0;
  logic [5:0] select_53;
  assign select_53 = running_s1_q ? memory_rdata_q[101:96] : (marks_first_s1_q ? memory_rdata_q[101:96] : 6'h0);
  logic [5:0] price_4;
  assign price_4 = and_39 ? select_53 : 6'h0;
  logic [5:0] select_61;
  assign select_61 = running_s1_q ? memory_rdata_q[95:90] : (marks_first_s1_q ? memory_rdata_q[95:90] : 6'h0);
  logic [5:0] price_5;
  assign price_5 = and_39 ? select_61 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_63;
  assign sum_63 = {1'b0, sum_15_s1_q[10:2]} + {4'h0, price_5};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_65;
  assign select_65 = running_s1_q ? memory_rdata_q[89:84] : (marks_first_s1_q ? memory_rdata_q[89:84] : 6'h0);
  logic [5:0] price_6;
  assign price_6 = and_39 ? select_65 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_67;
  assign sum_67 = {1'b0, sum_14_s1_q[10:2]} + {4'h0, price_6};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_69;
  assign select_69 = ({sum_63, sum_15_s1_q[1:0]} < {sum_67, sum_14_s1_q[1:0]}) ? {sum_63, sum_15_s1_q[1:0]} : {sum_67, sum_14_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_71;
  assign select_71 = running_s1_q ? memory_rdata_q[77:72] : (marks_first_s1_q ? memory_rdata_q[77:72] : 6'h0);
  logic [5:0] opinion;
  assign opinion = and_39 ? select_71 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_73;
  assign sum_73 = {1'b0, opinion} + 7'h27;
  logic [5:0] select_74;
  assign select_74 = sum_73[6] ? 6'h3f : sum_73[5:0];
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_76;
  assign select_76 = running_s1_q ? memory_rdata_q[83:78] : (marks_first_s1_q ? memory_rdata_q[83:78] : 6'h0);
  logic [5:0] opinion_2;
  assign opinion_2 = and_39 ? select_76 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_7;
  assign price_7 = (select_74 < opinion_2) ? select_74 : opinion_2;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_80;
  assign sum_80 = {1'b0, sum_13_s1_q[10:2]} + {4'h0, price_7};
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_81;
  assign sum_81 = {1'b0, opinion_2} + 7'h27;
  logic [5:0] select_82;
  assign select_82 = sum_81[6] ? 6'h3f : sum_81[5:0];
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_84;
  assign select_84 = running_s1_q ? memory_rdata_q[71:66] : (marks_first_s1_q ? memory_rdata_q[71:66] : 6'h0);
  logic [5:0] opinion_3;
  assign opinion_3 = and_39 ? select_84 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_86;
  assign sum_86 = {1'b0, opinion_3} + 7'h27;
  logic [5:0] select_87;
  assign select_87 = sum_86[6] ? 6'h3f : sum_86[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_8;
  assign price_8 = (select_87 < opinion) ? select_87 : opinion;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_9;
  assign price_9 = (select_82 < price_8) ? select_82 : price_8;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_92;
  assign sum_92 = {1'b0, sum_12_s1_q[10:2]} + {4'h0, price_9};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_94;
  assign select_94 = ({sum_80, sum_13_s1_q[1:0]} < {sum_92, sum_12_s1_q[1:0]}) ? {sum_80, sum_13_s1_q[1:0]} : {sum_92, sum_12_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_98;
  assign select_98 = running_s1_q ? memory_rdata_q[65:60] : (marks_first_s1_q ? memory_rdata_q[65:60] : 6'h0);
  logic [5:0] opinion_4;
  assign opinion_4 = and_39 ? select_98 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_100;
  assign sum_100 = {1'b0, opinion_4} + 7'h27;
  logic [5:0] select_101;
  assign select_101 = sum_100[6] ? 6'h3f : sum_100[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_10;
  assign price_10 = (select_101 < opinion_3) ? select_101 : opinion_3;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_11;
  assign price_11 = (select_74 < price_10) ? select_74 : price_10;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_106;
  assign sum_106 = {1'b0, sum_11_s1_q[10:2]} + {4'h0, price_11};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_108;
  assign select_108 = running_s1_q ? memory_rdata_q[59:54] : (marks_first_s1_q ? memory_rdata_q[59:54] : 6'h0);
  logic [5:0] opinion_5;
  assign opinion_5 = and_39 ? select_108 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_110;
  assign sum_110 = {1'b0, opinion_5} + 7'h27;
  logic [5:0] select_111;
  assign select_111 = sum_110[6] ? 6'h3f : sum_110[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_12;
  assign price_12 = (select_111 < opinion_4) ? select_111 : opinion_4;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_13;
  assign price_13 = (select_87 < price_12) ? select_87 : price_12;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_116;
  assign sum_116 = {1'b0, sum_10_s1_q[10:2]} + {4'h0, price_13};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_118;
  assign select_118 = ({sum_106, sum_11_s1_q[1:0]} < {sum_116, sum_10_s1_q[1:0]}) ? {sum_106, sum_11_s1_q[1:0]} : {sum_116, sum_10_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_120;
  assign select_120 = running_s1_q ? memory_rdata_q[53:48] : (marks_first_s1_q ? memory_rdata_q[53:48] : 6'h0);
  logic [5:0] opinion_6;
  assign opinion_6 = and_39 ? select_120 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_122;
  assign sum_122 = {1'b0, opinion_6} + 7'h27;
  logic [5:0] select_123;
  assign select_123 = sum_122[6] ? 6'h3f : sum_122[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_14;
  assign price_14 = (select_123 < opinion_5) ? select_123 : opinion_5;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_15;
  assign price_15 = (select_101 < price_14) ? select_101 : price_14;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_128;
  assign sum_128 = {1'b0, sum_9_s1_q[10:2]} + {4'h0, price_15};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_130;
  assign select_130 = running_s1_q ? memory_rdata_q[47:42] : (marks_first_s1_q ? memory_rdata_q[47:42] : 6'h0);
  logic [5:0] opinion_7;
  assign opinion_7 = and_39 ? select_130 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_132;
  assign sum_132 = {1'b0, opinion_7} + 7'h27;
  logic [5:0] select_133;
  assign select_133 = sum_132[6] ? 6'h3f : sum_132[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_16;
  assign price_16 = (select_133 < opinion_6) ? select_133 : opinion_6;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_17;
  assign price_17 = (select_111 < price_16) ? select_111 : price_16;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_138;
  assign sum_138 = {1'b0, sum_8_s1_q[10:2]} + {4'h0, price_17};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_140;
  assign select_140 = ({sum_128, sum_9_s1_q[1:0]} < {sum_138, sum_8_s1_q[1:0]}) ? {sum_128, sum_9_s1_q[1:0]} : {sum_138, sum_8_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_146;
  assign select_146 = running_s1_q ? memory_rdata_q[41:36] : (marks_first_s1_q ? memory_rdata_q[41:36] : 6'h0);
  logic [5:0] opinion_8;
  assign opinion_8 = and_39 ? select_146 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_148;
  assign sum_148 = {1'b0, opinion_8} + 7'h27;
  logic [5:0] select_149;
  assign select_149 = sum_148[6] ? 6'h3f : sum_148[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_18;
  assign price_18 = (select_149 < opinion_7) ? select_149 : opinion_7;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_19;
  assign price_19 = (select_123 < price_18) ? select_123 : price_18;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_154;
  assign sum_154 = {1'b0, sum_7_s1_q[10:2]} + {4'h0, price_19};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_156;
  assign select_156 = running_s1_q ? memory_rdata_q[35:30] : (marks_first_s1_q ? memory_rdata_q[35:30] : 6'h0);
  logic [5:0] opinion_9;
  assign opinion_9 = and_39 ? select_156 : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [6:0] sum_158;
  assign sum_158 = {1'b0, opinion_9} + 7'h27;
  logic [5:0] select_159;
  assign select_159 = sum_158[6] ? 6'h3f : sum_158[5:0];
  // hls/stages/plane_paths.hpp:89
  logic [5:0] price_20;
  assign price_20 = (select_159 < opinion_8) ? select_159 : opinion_8;
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_21;
  assign price_21 = (select_133 < price_20) ? select_133 : price_20;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_164;
  assign sum_164 = {1'b0, sum_6_s1_q[10:2]} + {4'h0, price_21};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_166;
  assign select_166 = ({sum_154, sum_7_s1_q[1:0]} < {sum_164, sum_6_s1_q[1:0]}) ? {sum_154, sum_7_s1_q[1:0]} : {sum_164, sum_6_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:90
  logic [5:0] price_22;
  assign price_22 = (select_149 < opinion_9) ? select_149 : opinion_9;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_169;
  assign sum_169 = {1'b0, sum_5_s1_q[10:2]} + {4'h0, price_22};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_171;
  assign select_171 = running_s1_q ? memory_rdata_q[29:24] : (marks_first_s1_q ? memory_rdata_q[29:24] : 6'h0);
  logic [5:0] price_23;
  assign price_23 = and_39 ? select_171 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_173;
  assign sum_173 = {1'b0, sum_4_s1_q[10:2]} + {4'h0, price_23};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_175;
  assign select_175 = ({sum_169, sum_5_s1_q[1:0]} < {sum_173, sum_4_s1_q[1:0]}) ? {sum_169, sum_5_s1_q[1:0]} : {sum_173, sum_4_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_179;
  assign select_179 = running_s1_q ? memory_rdata_q[23:18] : (marks_first_s1_q ? memory_rdata_q[23:18] : 6'h0);
  logic [5:0] price_24;
  assign price_24 = and_39 ? select_179 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_181;
  assign sum_181 = {1'b0, sum_3_s1_q[10:2]} + {4'h0, price_24};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_183;
  assign select_183 = running_s1_q ? memory_rdata_q[17:12] : (marks_first_s1_q ? memory_rdata_q[17:12] : 6'h0);
  logic [5:0] price_25;
  assign price_25 = and_39 ? select_183 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_185;
  assign sum_185 = {1'b0, sum_2_s1_q[10:2]} + {4'h0, price_25};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_187;
  assign select_187 = ({sum_181, sum_3_s1_q[1:0]} < {sum_185, sum_2_s1_q[1:0]}) ? {sum_181, sum_3_s1_q[1:0]} : {sum_185, sum_2_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_189;
  assign select_189 = running_s1_q ? memory_rdata_q[11:6] : (marks_first_s1_q ? memory_rdata_q[11:6] : 6'h0);
  logic [5:0] price_26;
  assign price_26 = and_39 ? select_189 : 6'h0;
  // hls/stages/plane_paths.hpp:91
  logic [9:0] sum_191;
  assign sum_191 = {1'b0, sum_1_s1_q[10:2]} + {4'h0, price_26};
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_193;
  assign select_193 = ({sum_191, sum_1_s1_q[1:0]} < {sum_43, sum_0_s1_q[1:0]}) ? {sum_191, sum_1_s1_q[1:0]} : {sum_43, sum_0_s1_q[1:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_39;
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
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic [9:0] select_34_s2_q;
  logic [9:0] sum_43_s2_q;
  logic [9:0] sum_47_s2_q;
  logic [9:0] sum_51_s2_q;
  logic [9:0] sum_55_s2_q;
  logic [9:0] sum_63_s2_q;
  logic [9:0] sum_67_s2_q;
  logic [9:0] sum_80_s2_q;
  logic [9:0] sum_92_s2_q;
  logic [11:0] select_96_s2_q;
  logic [9:0] sum_106_s2_q;
  logic [9:0] sum_116_s2_q;
  logic [9:0] sum_128_s2_q;
  logic [9:0] sum_138_s2_q;
  logic [11:0] select_142_s2_q;
  logic [9:0] sum_154_s2_q;
  logic [9:0] sum_164_s2_q;
  logic [9:0] sum_169_s2_q;
  logic [9:0] sum_173_s2_q;
  logic [11:0] select_177_s2_q;
  logic [9:0] sum_181_s2_q;
  logic [9:0] sum_185_s2_q;
  logic [9:0] sum_191_s2_q;
  logic [11:0] select_195_s2_q;
  logic select_317_s2_q;
  logic less_358_s2_q;
  logic and_360_s2_q;
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
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      select_34_s2_q <= raster_column_q;
      sum_43_s2_q <= sum_43;
      sum_47_s2_q <= {1'b0, sum_18_s1_q[10:2]} + {4'h0, price_2};
      sum_51_s2_q <= {1'b0, sum_17_s1_q[10:2]} + {4'h0, price_3};
      sum_55_s2_q <= {1'b0, sum_16_s1_q[10:2]} + {4'h0, price_4};
      sum_63_s2_q <= sum_63;
      sum_67_s2_q <= sum_67;
      sum_80_s2_q <= sum_80;
      sum_92_s2_q <= sum_92;
      select_96_s2_q <= (select_69 < select_94) ? select_69 : select_94;
      sum_106_s2_q <= sum_106;
      sum_116_s2_q <= sum_116;
      sum_128_s2_q <= sum_128;
      sum_138_s2_q <= sum_138;
      select_142_s2_q <= (select_118 < select_140) ? select_118 : select_140;
      sum_154_s2_q <= sum_154;
      sum_164_s2_q <= sum_164;
      sum_169_s2_q <= sum_169;
      sum_173_s2_q <= sum_173;
      select_177_s2_q <= (select_166 < select_175) ? select_166 : select_175;
      sum_181_s2_q <= sum_181;
      sum_185_s2_q <= sum_185;
      sum_191_s2_q <= sum_191;
      select_195_s2_q <= (select_187 < select_193) ? select_187 : select_193;
      select_317_s2_q <= running_q;
      less_358_s2_q <= less_358_s1_q;
      and_360_s2_q <= and_360_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:113
  logic [11:0] select_57;
  assign select_57 = ({sum_51_s2_q, sum_17_s2_q} < {sum_55_s2_q, sum_16_s2_q}) ? {sum_51_s2_q, sum_17_s2_q} : {sum_55_s2_q, sum_16_s2_q};
  logic [11:0] select_59;
  assign select_59 = ({sum_47_s2_q, sum_18_s2_q} < select_57) ? {sum_47_s2_q, sum_18_s2_q} : select_57;
  logic [11:0] select_144;
  assign select_144 = (select_96_s2_q < select_142_s2_q) ? select_96_s2_q : select_142_s2_q;
  logic [11:0] select_197;
  assign select_197 = (select_177_s2_q < select_195_s2_q) ? select_177_s2_q : select_195_s2_q;
  logic [11:0] select_199;
  assign select_199 = (select_144 < select_197) ? select_144 : select_197;
  logic [11:0] best;
  assign best = (select_59 < select_199) ? select_59 : select_199;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_202;
  assign difference_202 = {sum_43_s2_q, sum_0_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_204;
  assign select_204 = (difference_202[11:8] == 4'h0) ? difference_202[7:2] : 6'h3f;
  logic [6:0] sum_205;
  assign sum_205 = {1'b0, select_204} + 7'h3;
  logic [5:0] select_207;
  assign select_207 = known_s2_q ? (select_204 - {1'b0, sum_205[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_208;
  assign difference_208 = {sum_191_s2_q, sum_1_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_210;
  assign select_210 = (difference_208[11:8] == 4'h0) ? difference_208[7:2] : 6'h3f;
  logic [6:0] sum_211;
  assign sum_211 = {1'b0, select_210} + 7'h3;
  logic [5:0] select_213;
  assign select_213 = known_s2_q ? (select_210 - {1'b0, sum_211[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_214;
  assign difference_214 = {sum_185_s2_q, sum_2_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_216;
  assign select_216 = (difference_214[11:8] == 4'h0) ? difference_214[7:2] : 6'h3f;
  logic [6:0] sum_217;
  assign sum_217 = {1'b0, select_216} + 7'h3;
  logic [5:0] select_219;
  assign select_219 = known_s2_q ? (select_216 - {1'b0, sum_217[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_220;
  assign difference_220 = {sum_181_s2_q, sum_3_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_222;
  assign select_222 = (difference_220[11:8] == 4'h0) ? difference_220[7:2] : 6'h3f;
  logic [6:0] sum_223;
  assign sum_223 = {1'b0, select_222} + 7'h3;
  logic [5:0] select_225;
  assign select_225 = known_s2_q ? (select_222 - {1'b0, sum_223[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_226;
  assign difference_226 = {sum_173_s2_q, sum_4_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_228;
  assign select_228 = (difference_226[11:8] == 4'h0) ? difference_226[7:2] : 6'h3f;
  logic [6:0] sum_229;
  assign sum_229 = {1'b0, select_228} + 7'h3;
  logic [5:0] select_231;
  assign select_231 = known_s2_q ? (select_228 - {1'b0, sum_229[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_232;
  assign difference_232 = {sum_169_s2_q, sum_5_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_234;
  assign select_234 = (difference_232[11:8] == 4'h0) ? difference_232[7:2] : 6'h3f;
  logic [6:0] sum_235;
  assign sum_235 = {1'b0, select_234} + 7'h3;
  logic [5:0] select_237;
  assign select_237 = known_s2_q ? (select_234 - {1'b0, sum_235[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_238;
  assign difference_238 = {sum_164_s2_q, sum_6_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_240;
  assign select_240 = (difference_238[11:8] == 4'h0) ? difference_238[7:2] : 6'h3f;
  logic [6:0] sum_241;
  assign sum_241 = {1'b0, select_240} + 7'h3;
  logic [5:0] select_243;
  assign select_243 = known_s2_q ? (select_240 - {1'b0, sum_241[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_244;
  assign difference_244 = {sum_154_s2_q, sum_7_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_246;
  assign select_246 = (difference_244[11:8] == 4'h0) ? difference_244[7:2] : 6'h3f;
  logic [6:0] sum_247;
  assign sum_247 = {1'b0, select_246} + 7'h3;
  logic [5:0] select_249;
  assign select_249 = known_s2_q ? (select_246 - {1'b0, sum_247[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_250;
  assign difference_250 = {sum_138_s2_q, sum_8_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_252;
  assign select_252 = (difference_250[11:8] == 4'h0) ? difference_250[7:2] : 6'h3f;
  logic [6:0] sum_253;
  assign sum_253 = {1'b0, select_252} + 7'h3;
  logic [5:0] select_255;
  assign select_255 = known_s2_q ? (select_252 - {1'b0, sum_253[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_256;
  assign difference_256 = {sum_128_s2_q, sum_9_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_258;
  assign select_258 = (difference_256[11:8] == 4'h0) ? difference_256[7:2] : 6'h3f;
  logic [6:0] sum_259;
  assign sum_259 = {1'b0, select_258} + 7'h3;
  logic [5:0] select_261;
  assign select_261 = known_s2_q ? (select_258 - {1'b0, sum_259[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_262;
  assign difference_262 = {sum_116_s2_q, sum_10_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_264;
  assign select_264 = (difference_262[11:8] == 4'h0) ? difference_262[7:2] : 6'h3f;
  logic [6:0] sum_265;
  assign sum_265 = {1'b0, select_264} + 7'h3;
  logic [5:0] select_267;
  assign select_267 = known_s2_q ? (select_264 - {1'b0, sum_265[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_268;
  assign difference_268 = {sum_106_s2_q, sum_11_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_270;
  assign select_270 = (difference_268[11:8] == 4'h0) ? difference_268[7:2] : 6'h3f;
  logic [6:0] sum_271;
  assign sum_271 = {1'b0, select_270} + 7'h3;
  logic [5:0] select_273;
  assign select_273 = known_s2_q ? (select_270 - {1'b0, sum_271[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_274;
  assign difference_274 = {sum_92_s2_q, sum_12_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_276;
  assign select_276 = (difference_274[11:8] == 4'h0) ? difference_274[7:2] : 6'h3f;
  logic [6:0] sum_277;
  assign sum_277 = {1'b0, select_276} + 7'h3;
  logic [5:0] select_279;
  assign select_279 = known_s2_q ? (select_276 - {1'b0, sum_277[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_280;
  assign difference_280 = {sum_80_s2_q, sum_13_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_282;
  assign select_282 = (difference_280[11:8] == 4'h0) ? difference_280[7:2] : 6'h3f;
  logic [6:0] sum_283;
  assign sum_283 = {1'b0, select_282} + 7'h3;
  logic [5:0] select_285;
  assign select_285 = known_s2_q ? (select_282 - {1'b0, sum_283[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_286;
  assign difference_286 = {sum_67_s2_q, sum_14_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_288;
  assign select_288 = (difference_286[11:8] == 4'h0) ? difference_286[7:2] : 6'h3f;
  logic [6:0] sum_289;
  assign sum_289 = {1'b0, select_288} + 7'h3;
  logic [5:0] select_291;
  assign select_291 = known_s2_q ? (select_288 - {1'b0, sum_289[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_292;
  assign difference_292 = {sum_63_s2_q, sum_15_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_294;
  assign select_294 = (difference_292[11:8] == 4'h0) ? difference_292[7:2] : 6'h3f;
  logic [6:0] sum_295;
  assign sum_295 = {1'b0, select_294} + 7'h3;
  logic [5:0] select_297;
  assign select_297 = known_s2_q ? (select_294 - {1'b0, sum_295[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_298;
  assign difference_298 = {sum_55_s2_q, sum_16_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_300;
  assign select_300 = (difference_298[11:8] == 4'h0) ? difference_298[7:2] : 6'h3f;
  logic [6:0] sum_301;
  assign sum_301 = {1'b0, select_300} + 7'h3;
  logic [5:0] select_303;
  assign select_303 = known_s2_q ? (select_300 - {1'b0, sum_301[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_304;
  assign difference_304 = {sum_51_s2_q, sum_17_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_306;
  assign select_306 = (difference_304[11:8] == 4'h0) ? difference_304[7:2] : 6'h3f;
  logic [6:0] sum_307;
  assign sum_307 = {1'b0, select_306} + 7'h3;
  logic [5:0] select_309;
  assign select_309 = known_s2_q ? (select_306 - {1'b0, sum_307[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [11:0] difference_310;
  assign difference_310 = {sum_47_s2_q, sum_18_s2_q} - best;
  // hls/stages/plane_paths.hpp:97
  logic [5:0] select_312;
  assign select_312 = (difference_310[11:8] == 4'h0) ? difference_310[7:2] : 6'h3f;
  logic [6:0] sum_313;
  assign sum_313 = {1'b0, select_312} + 7'h3;
  logic [5:0] select_315;
  assign select_315 = known_s2_q ? (select_312 - {1'b0, sum_313[6:2]}) : 6'h0;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = select_34_s2_q;
  logic memory_we;
  assign memory_we = s2_en & select_317_s2_q;
  logic [113:0] memory_wdata;
  assign memory_wdata = {select_315, select_309, select_303, select_297, select_291, select_285, select_279, select_273, select_267, select_261, select_255, select_249, select_243, select_237, select_231, select_225, select_219, select_213, select_207};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {^memory_wdata, memory_wdata};
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
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic [9:0] sum_43_s3_q;
  logic [9:0] sum_47_s3_q;
  logic [9:0] sum_51_s3_q;
  logic [9:0] sum_55_s3_q;
  logic [9:0] sum_63_s3_q;
  logic [9:0] sum_67_s3_q;
  logic [9:0] sum_80_s3_q;
  logic [9:0] sum_92_s3_q;
  logic [9:0] sum_106_s3_q;
  logic [9:0] sum_116_s3_q;
  logic [9:0] sum_128_s3_q;
  logic [9:0] sum_138_s3_q;
  logic [9:0] sum_154_s3_q;
  logic [9:0] sum_164_s3_q;
  logic [9:0] sum_169_s3_q;
  logic [9:0] sum_173_s3_q;
  logic [9:0] sum_181_s3_q;
  logic [9:0] sum_185_s3_q;
  logic [9:0] sum_191_s3_q;
  logic less_358_s3_q;
  logic and_360_s3_q;
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
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      sum_43_s3_q <= sum_43_s2_q;
      sum_47_s3_q <= sum_47_s2_q;
      sum_51_s3_q <= sum_51_s2_q;
      sum_55_s3_q <= sum_55_s2_q;
      sum_63_s3_q <= sum_63_s2_q;
      sum_67_s3_q <= sum_67_s2_q;
      sum_80_s3_q <= sum_80_s2_q;
      sum_92_s3_q <= sum_92_s2_q;
      sum_106_s3_q <= sum_106_s2_q;
      sum_116_s3_q <= sum_116_s2_q;
      sum_128_s3_q <= sum_128_s2_q;
      sum_138_s3_q <= sum_138_s2_q;
      sum_154_s3_q <= sum_154_s2_q;
      sum_164_s3_q <= sum_164_s2_q;
      sum_169_s3_q <= sum_169_s2_q;
      sum_173_s3_q <= sum_173_s2_q;
      sum_181_s3_q <= sum_181_s2_q;
      sum_185_s3_q <= sum_185_s2_q;
      sum_191_s3_q <= sum_191_s2_q;
      less_358_s3_q <= less_358_s2_q;
      and_360_s3_q <= and_360_s2_q;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (memory_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign cost_0_o = {sum_43_s3_q, sum_0_s3_q};
  assign cost_1_o = {sum_191_s3_q, sum_1_s3_q};
  assign cost_2_o = {sum_185_s3_q, sum_2_s3_q};
  assign cost_3_o = {sum_181_s3_q, sum_3_s3_q};
  assign cost_4_o = {sum_173_s3_q, sum_4_s3_q};
  assign cost_5_o = {sum_169_s3_q, sum_5_s3_q};
  assign cost_6_o = {sum_164_s3_q, sum_6_s3_q};
  assign cost_7_o = {sum_154_s3_q, sum_7_s3_q};
  assign cost_8_o = {sum_138_s3_q, sum_8_s3_q};
  assign cost_9_o = {sum_128_s3_q, sum_9_s3_q};
  assign cost_10_o = {sum_116_s3_q, sum_10_s3_q};
  assign cost_11_o = {sum_106_s3_q, sum_11_s3_q};
  assign cost_12_o = {sum_92_s3_q, sum_12_s3_q};
  assign cost_13_o = {sum_80_s3_q, sum_13_s3_q};
  assign cost_14_o = {sum_67_s3_q, sum_14_s3_q};
  assign cost_15_o = {sum_63_s3_q, sum_15_s3_q};
  assign cost_16_o = {sum_55_s3_q, sum_16_s3_q};
  assign cost_17_o = {sum_51_s3_q, sum_17_s3_q};
  assign cost_18_o = {sum_47_s3_q, sum_18_s3_q};
  assign grey_o = grey_s3_q;
  assign known_o = known_s3_q;
  assign evident_o = and_360_s3_q;
  assign strong_v_o = less_358_s3_q;
  assign exists_o = exists_s3_q;
  assign marks_first_o = marks_first_s3_q;
  assign marks_last_o = marks_last_s3_q;
  assign marks_seen_o = marks_seen_s3_q;
  assign marks_nearer_o = marks_nearer_s3_q;
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
  assign unused_bits = ^{sum_313[1:0], difference_310[1:0], sum_307[1:0], difference_304[1:0], sum_301[1:0], difference_298[1:0], sum_295[1:0], difference_292[1:0], sum_289[1:0], difference_286[1:0], sum_283[1:0], difference_280[1:0], sum_277[1:0], difference_274[1:0], sum_271[1:0], difference_268[1:0], sum_265[1:0], difference_262[1:0], sum_259[1:0], difference_256[1:0], sum_253[1:0], difference_250[1:0], sum_247[1:0], difference_244[1:0], sum_241[1:0], difference_238[1:0], sum_235[1:0], difference_232[1:0], sum_229[1:0], difference_226[1:0], sum_223[1:0], difference_220[1:0], sum_217[1:0], difference_214[1:0], sum_211[1:0], difference_208[1:0], sum_205[1:0], difference_202[1:0]};

endmodule
