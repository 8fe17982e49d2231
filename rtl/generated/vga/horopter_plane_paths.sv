// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Paths<horopter::hls::profiles::vga>, hls/stages/plane_paths.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 13 bits, pipeline 989 bits, memories 72960 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q;
  logic s0_en, s1_en, s2_en, s3_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [9:0] raster_next_column_q;
  logic raster_row_ended_q;
  logic running_q;
  // hls/stages/plane_paths.hpp:50
  logic [9:0] select_31;
  assign select_31 = (marks_first_i | raster_row_ended_q) ? 10'h0 : raster_next_column_q;
  // hls/stages/plane_paths.hpp:53
  logic or_32;
  assign or_32 = marks_first_i | running_q;
  // hls/stages/plane_paths.hpp:97
  logic [10:0] select_317;
  assign select_317 = (sum_17_i < sum_16_i) ? sum_17_i : sum_16_i;
  logic [10:0] select_319;
  assign select_319 = (sum_18_i < select_317) ? sum_18_i : select_317;
  logic [10:0] select_321;
  assign select_321 = (sum_15_i < sum_14_i) ? sum_15_i : sum_14_i;
  logic [10:0] select_323;
  assign select_323 = (sum_13_i < sum_12_i) ? sum_13_i : sum_12_i;
  logic [10:0] select_325;
  assign select_325 = (select_321 < select_323) ? select_321 : select_323;
  logic [10:0] select_327;
  assign select_327 = (sum_11_i < sum_10_i) ? sum_11_i : sum_10_i;
  logic [10:0] select_329;
  assign select_329 = (sum_9_i < sum_8_i) ? sum_9_i : sum_8_i;
  logic [10:0] select_331;
  assign select_331 = (select_327 < select_329) ? select_327 : select_329;
  logic [10:0] select_333;
  assign select_333 = (select_325 < select_331) ? select_325 : select_331;
  logic [10:0] select_335;
  assign select_335 = (sum_7_i < sum_6_i) ? sum_7_i : sum_6_i;
  logic [10:0] select_337;
  assign select_337 = (sum_5_i < sum_4_i) ? sum_5_i : sum_4_i;
  logic [10:0] select_339;
  assign select_339 = (select_335 < select_337) ? select_335 : select_337;
  logic [10:0] select_341;
  assign select_341 = (sum_3_i < sum_2_i) ? sum_3_i : sum_2_i;
  logic [10:0] select_343;
  assign select_343 = (sum_1_i < sum_0_i) ? sum_1_i : sum_0_i;
  logic [10:0] select_345;
  assign select_345 = (select_341 < select_343) ? select_341 : select_343;
  logic [10:0] select_347;
  assign select_347 = (select_339 < select_345) ? select_339 : select_345;
  logic [10:0] select_349;
  assign select_349 = (select_333 < select_347) ? select_333 : select_347;
  logic [10:0] select_351;
  assign select_351 = (select_319 < select_349) ? select_319 : select_349;
  // hls/stages/plane_paths.hpp:73
  logic [11:0] sum_352;
  assign sum_352 = {1'b0, evidence_i} + {3'h0, evidence_i[10:2]};
  logic [11:0] sum_353;
  assign sum_353 = {1'b0, evidence_i} + {1'b0, sum_352[11:1]};
  // hls/stages/plane_paths.hpp:75
  logic less_355;
  assign less_355 = 10'h13a < evidence_i[10:1];
  // hls/stages/plane_paths.hpp:76
  logic or_356;
  assign or_356 = ({select_351, 4'h0} < {sum_353, sum_352[0], evidence_i[1:0]}) | less_355;

  // Memory memory, 640 x 114, DISTANCE 16, hls/stages/plane_paths.hpp:103; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [113:0] memory_mem [0:639];
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 114'h0;
  logic [9:0] memory_raddr;
  assign memory_raddr = select_31;
  logic memory_re;
  assign memory_re = s0_en & or_32;
  logic [113:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_next_column_q <= 10'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_next_column_q <= select_31 + 10'h1;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_32 : (marks_first_i & or_32);
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
  logic [9:0] select_31_s1_q;
  logic less_355_s1_q;
  logic and_357_s1_q;
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
      select_31_s1_q <= select_31;
      less_355_s1_q <= less_355;
      and_357_s1_q <= known_i & or_356;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/plane_paths.hpp:50
  logic and_35;
  assign and_35 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_37;
  assign select_37 = running_s1_q ? memory_rdata_q[5:0] : (marks_first_s1_q ? memory_rdata_q[5:0] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price;
  assign price = and_35 ? select_37 : 6'h0;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_41;
  assign select_41 = running_s1_q ? memory_rdata_q[113:108] : (marks_first_s1_q ? memory_rdata_q[113:108] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price_2;
  assign price_2 = and_35 ? select_41 : 6'h0;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_45;
  assign select_45 = running_s1_q ? memory_rdata_q[107:102] : (marks_first_s1_q ? memory_rdata_q[107:102] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price_3;
  assign price_3 = and_35 ? select_45 : 6'h0;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_49;
  assign select_49 = running_s1_q ? memory_rdata_q[101:96] : (marks_first_s1_q ? memory_rdata_q[101:96] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price_4;
  assign price_4 = and_35 ? select_49 : 6'h0;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_57;
  assign select_57 = running_s1_q ? memory_rdata_q[95:90] : (marks_first_s1_q ? memory_rdata_q[95:90] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price_5;
  assign price_5 = and_35 ? select_57 : 6'h0;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_61;
  assign select_61 = running_s1_q ? memory_rdata_q[89:84] : (marks_first_s1_q ? memory_rdata_q[89:84] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price_6;
  assign price_6 = and_35 ? select_61 : 6'h0;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_67;
  assign select_67 = running_s1_q ? memory_rdata_q[77:72] : (marks_first_s1_q ? memory_rdata_q[77:72] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] opinion;
  assign opinion = and_35 ? select_67 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [6:0] sum_69;
  assign sum_69 = {1'b0, opinion} + 7'h27;
  logic [5:0] select_70;
  assign select_70 = sum_69[6] ? 6'h3f : sum_69[5:0];
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_72;
  assign select_72 = running_s1_q ? memory_rdata_q[83:78] : (marks_first_s1_q ? memory_rdata_q[83:78] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] opinion_2;
  assign opinion_2 = and_35 ? select_72 : 6'h0;
  // hls/stages/plane_paths.hpp:60
  logic [5:0] price_7;
  assign price_7 = (select_70 < opinion_2) ? select_70 : opinion_2;
  // hls/stages/plane_paths.hpp:89
  logic [6:0] sum_77;
  assign sum_77 = {1'b0, opinion_2} + 7'h27;
  logic [5:0] select_78;
  assign select_78 = sum_77[6] ? 6'h3f : sum_77[5:0];
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_80;
  assign select_80 = running_s1_q ? memory_rdata_q[71:66] : (marks_first_s1_q ? memory_rdata_q[71:66] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] opinion_3;
  assign opinion_3 = and_35 ? select_80 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [6:0] sum_82;
  assign sum_82 = {1'b0, opinion_3} + 7'h27;
  logic [5:0] select_83;
  assign select_83 = sum_82[6] ? 6'h3f : sum_82[5:0];
  // hls/stages/plane_paths.hpp:60
  logic [5:0] price_8;
  assign price_8 = (select_83 < opinion) ? select_83 : opinion;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_9;
  assign price_9 = (select_78 < price_8) ? select_78 : price_8;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_94;
  assign select_94 = running_s1_q ? memory_rdata_q[65:60] : (marks_first_s1_q ? memory_rdata_q[65:60] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] opinion_4;
  assign opinion_4 = and_35 ? select_94 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [6:0] sum_96;
  assign sum_96 = {1'b0, opinion_4} + 7'h27;
  logic [5:0] select_97;
  assign select_97 = sum_96[6] ? 6'h3f : sum_96[5:0];
  // hls/stages/plane_paths.hpp:60
  logic [5:0] price_10;
  assign price_10 = (select_97 < opinion_3) ? select_97 : opinion_3;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_11;
  assign price_11 = (select_70 < price_10) ? select_70 : price_10;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_104;
  assign select_104 = running_s1_q ? memory_rdata_q[59:54] : (marks_first_s1_q ? memory_rdata_q[59:54] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] opinion_5;
  assign opinion_5 = and_35 ? select_104 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [6:0] sum_106;
  assign sum_106 = {1'b0, opinion_5} + 7'h27;
  logic [5:0] select_107;
  assign select_107 = sum_106[6] ? 6'h3f : sum_106[5:0];
  // hls/stages/plane_paths.hpp:60
  logic [5:0] price_12;
  assign price_12 = (select_107 < opinion_4) ? select_107 : opinion_4;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_13;
  assign price_13 = (select_83 < price_12) ? select_83 : price_12;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_116;
  assign select_116 = running_s1_q ? memory_rdata_q[53:48] : (marks_first_s1_q ? memory_rdata_q[53:48] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] opinion_6;
  assign opinion_6 = and_35 ? select_116 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [6:0] sum_118;
  assign sum_118 = {1'b0, opinion_6} + 7'h27;
  logic [5:0] select_119;
  assign select_119 = sum_118[6] ? 6'h3f : sum_118[5:0];
  // hls/stages/plane_paths.hpp:60
  logic [5:0] price_14;
  assign price_14 = (select_119 < opinion_5) ? select_119 : opinion_5;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_15;
  assign price_15 = (select_97 < price_14) ? select_97 : price_14;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_126;
  assign select_126 = running_s1_q ? memory_rdata_q[47:42] : (marks_first_s1_q ? memory_rdata_q[47:42] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] opinion_7;
  assign opinion_7 = and_35 ? select_126 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [6:0] sum_128;
  assign sum_128 = {1'b0, opinion_7} + 7'h27;
  logic [5:0] select_129;
  assign select_129 = sum_128[6] ? 6'h3f : sum_128[5:0];
  // hls/stages/plane_paths.hpp:60
  logic [5:0] price_16;
  assign price_16 = (select_129 < opinion_6) ? select_129 : opinion_6;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_17;
  assign price_17 = (select_107 < price_16) ? select_107 : price_16;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_142;
  assign select_142 = running_s1_q ? memory_rdata_q[41:36] : (marks_first_s1_q ? memory_rdata_q[41:36] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] opinion_8;
  assign opinion_8 = and_35 ? select_142 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [6:0] sum_144;
  assign sum_144 = {1'b0, opinion_8} + 7'h27;
  logic [5:0] select_145;
  assign select_145 = sum_144[6] ? 6'h3f : sum_144[5:0];
  // hls/stages/plane_paths.hpp:60
  logic [5:0] price_18;
  assign price_18 = (select_145 < opinion_7) ? select_145 : opinion_7;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_19;
  assign price_19 = (select_119 < price_18) ? select_119 : price_18;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_152;
  assign select_152 = running_s1_q ? memory_rdata_q[35:30] : (marks_first_s1_q ? memory_rdata_q[35:30] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] opinion_9;
  assign opinion_9 = and_35 ? select_152 : 6'h0;
  // hls/stages/plane_paths.hpp:89
  logic [6:0] sum_154;
  assign sum_154 = {1'b0, opinion_9} + 7'h27;
  logic [5:0] select_155;
  assign select_155 = sum_154[6] ? 6'h3f : sum_154[5:0];
  // hls/stages/plane_paths.hpp:60
  logic [5:0] price_20;
  assign price_20 = (select_155 < opinion_8) ? select_155 : opinion_8;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_21;
  assign price_21 = (select_129 < price_20) ? select_129 : price_20;
  logic [5:0] price_22;
  assign price_22 = (select_145 < opinion_9) ? select_145 : opinion_9;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_167;
  assign select_167 = running_s1_q ? memory_rdata_q[29:24] : (marks_first_s1_q ? memory_rdata_q[29:24] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price_23;
  assign price_23 = and_35 ? select_167 : 6'h0;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_175;
  assign select_175 = running_s1_q ? memory_rdata_q[23:18] : (marks_first_s1_q ? memory_rdata_q[23:18] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price_24;
  assign price_24 = and_35 ? select_175 : 6'h0;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_179;
  assign select_179 = running_s1_q ? memory_rdata_q[17:12] : (marks_first_s1_q ? memory_rdata_q[17:12] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price_25;
  assign price_25 = and_35 ? select_179 : 6'h0;
  // hls/stages/plane_paths.hpp:54
  logic [5:0] select_185;
  assign select_185 = running_s1_q ? memory_rdata_q[11:6] : (marks_first_s1_q ? memory_rdata_q[11:6] : 6'h0);
  // hls/stages/plane_paths.hpp:39
  logic [5:0] price_26;
  assign price_26 = and_35 ? select_185 : 6'h0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_35;
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
  logic [9:0] select_31_s2_q;
  logic [9:0] sum_39_s2_q;
  logic [9:0] sum_43_s2_q;
  logic [9:0] sum_47_s2_q;
  logic [9:0] sum_51_s2_q;
  logic [9:0] sum_59_s2_q;
  logic [9:0] sum_63_s2_q;
  logic [9:0] sum_76_s2_q;
  logic [9:0] sum_88_s2_q;
  logic [9:0] sum_102_s2_q;
  logic [9:0] sum_112_s2_q;
  logic [9:0] sum_124_s2_q;
  logic [9:0] sum_134_s2_q;
  logic [9:0] sum_150_s2_q;
  logic [9:0] sum_160_s2_q;
  logic [9:0] sum_165_s2_q;
  logic [9:0] sum_169_s2_q;
  logic [9:0] sum_177_s2_q;
  logic [9:0] sum_181_s2_q;
  logic [9:0] sum_187_s2_q;
  logic select_313_s2_q;
  logic less_355_s2_q;
  logic and_357_s2_q;
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
      select_31_s2_q <= select_31_s1_q;
      sum_39_s2_q <= {1'b0, sum_0_s1_q[10:2]} + {4'h0, price};
      sum_43_s2_q <= {1'b0, sum_18_s1_q[10:2]} + {4'h0, price_2};
      sum_47_s2_q <= {1'b0, sum_17_s1_q[10:2]} + {4'h0, price_3};
      sum_51_s2_q <= {1'b0, sum_16_s1_q[10:2]} + {4'h0, price_4};
      sum_59_s2_q <= {1'b0, sum_15_s1_q[10:2]} + {4'h0, price_5};
      sum_63_s2_q <= {1'b0, sum_14_s1_q[10:2]} + {4'h0, price_6};
      sum_76_s2_q <= {1'b0, sum_13_s1_q[10:2]} + {4'h0, price_7};
      sum_88_s2_q <= {1'b0, sum_12_s1_q[10:2]} + {4'h0, price_9};
      sum_102_s2_q <= {1'b0, sum_11_s1_q[10:2]} + {4'h0, price_11};
      sum_112_s2_q <= {1'b0, sum_10_s1_q[10:2]} + {4'h0, price_13};
      sum_124_s2_q <= {1'b0, sum_9_s1_q[10:2]} + {4'h0, price_15};
      sum_134_s2_q <= {1'b0, sum_8_s1_q[10:2]} + {4'h0, price_17};
      sum_150_s2_q <= {1'b0, sum_7_s1_q[10:2]} + {4'h0, price_19};
      sum_160_s2_q <= {1'b0, sum_6_s1_q[10:2]} + {4'h0, price_21};
      sum_165_s2_q <= {1'b0, sum_5_s1_q[10:2]} + {4'h0, price_22};
      sum_169_s2_q <= {1'b0, sum_4_s1_q[10:2]} + {4'h0, price_23};
      sum_177_s2_q <= {1'b0, sum_3_s1_q[10:2]} + {4'h0, price_24};
      sum_181_s2_q <= {1'b0, sum_2_s1_q[10:2]} + {4'h0, price_25};
      sum_187_s2_q <= {1'b0, sum_1_s1_q[10:2]} + {4'h0, price_26};
      select_313_s2_q <= running_q;
      less_355_s2_q <= less_355_s1_q;
      and_357_s2_q <= and_357_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:97
  logic [11:0] select_53;
  assign select_53 = ({sum_47_s2_q, sum_17_s2_q} < {sum_51_s2_q, sum_16_s2_q}) ? {sum_47_s2_q, sum_17_s2_q} : {sum_51_s2_q, sum_16_s2_q};
  logic [11:0] select_55;
  assign select_55 = ({sum_43_s2_q, sum_18_s2_q} < select_53) ? {sum_43_s2_q, sum_18_s2_q} : select_53;
  logic [11:0] select_65;
  assign select_65 = ({sum_59_s2_q, sum_15_s2_q} < {sum_63_s2_q, sum_14_s2_q}) ? {sum_59_s2_q, sum_15_s2_q} : {sum_63_s2_q, sum_14_s2_q};
  logic [11:0] select_90;
  assign select_90 = ({sum_76_s2_q, sum_13_s2_q} < {sum_88_s2_q, sum_12_s2_q}) ? {sum_76_s2_q, sum_13_s2_q} : {sum_88_s2_q, sum_12_s2_q};
  logic [11:0] select_92;
  assign select_92 = (select_65 < select_90) ? select_65 : select_90;
  logic [11:0] select_114;
  assign select_114 = ({sum_102_s2_q, sum_11_s2_q} < {sum_112_s2_q, sum_10_s2_q}) ? {sum_102_s2_q, sum_11_s2_q} : {sum_112_s2_q, sum_10_s2_q};
  logic [11:0] select_136;
  assign select_136 = ({sum_124_s2_q, sum_9_s2_q} < {sum_134_s2_q, sum_8_s2_q}) ? {sum_124_s2_q, sum_9_s2_q} : {sum_134_s2_q, sum_8_s2_q};
  logic [11:0] select_138;
  assign select_138 = (select_114 < select_136) ? select_114 : select_136;
  logic [11:0] select_140;
  assign select_140 = (select_92 < select_138) ? select_92 : select_138;
  logic [11:0] select_162;
  assign select_162 = ({sum_150_s2_q, sum_7_s2_q} < {sum_160_s2_q, sum_6_s2_q}) ? {sum_150_s2_q, sum_7_s2_q} : {sum_160_s2_q, sum_6_s2_q};
  logic [11:0] select_171;
  assign select_171 = ({sum_165_s2_q, sum_5_s2_q} < {sum_169_s2_q, sum_4_s2_q}) ? {sum_165_s2_q, sum_5_s2_q} : {sum_169_s2_q, sum_4_s2_q};
  logic [11:0] select_173;
  assign select_173 = (select_162 < select_171) ? select_162 : select_171;
  logic [11:0] select_183;
  assign select_183 = ({sum_177_s2_q, sum_3_s2_q} < {sum_181_s2_q, sum_2_s2_q}) ? {sum_177_s2_q, sum_3_s2_q} : {sum_181_s2_q, sum_2_s2_q};
  logic [11:0] select_189;
  assign select_189 = ({sum_187_s2_q, sum_1_s2_q} < {sum_39_s2_q, sum_0_s2_q}) ? {sum_187_s2_q, sum_1_s2_q} : {sum_39_s2_q, sum_0_s2_q};
  logic [11:0] select_191;
  assign select_191 = (select_183 < select_189) ? select_183 : select_189;
  logic [11:0] select_193;
  assign select_193 = (select_173 < select_191) ? select_173 : select_191;
  logic [11:0] select_195;
  assign select_195 = (select_140 < select_193) ? select_140 : select_193;
  logic [11:0] best;
  assign best = (select_55 < select_195) ? select_55 : select_195;

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
  logic [9:0] select_31_s3_q;
  logic [9:0] sum_39_s3_q;
  logic [9:0] sum_43_s3_q;
  logic [9:0] sum_47_s3_q;
  logic [9:0] sum_51_s3_q;
  logic [9:0] sum_59_s3_q;
  logic [9:0] sum_63_s3_q;
  logic [9:0] sum_76_s3_q;
  logic [9:0] sum_88_s3_q;
  logic [9:0] sum_102_s3_q;
  logic [9:0] sum_112_s3_q;
  logic [9:0] sum_124_s3_q;
  logic [9:0] sum_134_s3_q;
  logic [9:0] sum_150_s3_q;
  logic [9:0] sum_160_s3_q;
  logic [9:0] sum_165_s3_q;
  logic [9:0] sum_169_s3_q;
  logic [9:0] sum_177_s3_q;
  logic [9:0] sum_181_s3_q;
  logic [9:0] sum_187_s3_q;
  logic [11:0] best_s3_q;
  logic select_313_s3_q;
  logic less_355_s3_q;
  logic and_357_s3_q;
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
      select_31_s3_q <= select_31_s2_q;
      sum_39_s3_q <= sum_39_s2_q;
      sum_43_s3_q <= sum_43_s2_q;
      sum_47_s3_q <= sum_47_s2_q;
      sum_51_s3_q <= sum_51_s2_q;
      sum_59_s3_q <= sum_59_s2_q;
      sum_63_s3_q <= sum_63_s2_q;
      sum_76_s3_q <= sum_76_s2_q;
      sum_88_s3_q <= sum_88_s2_q;
      sum_102_s3_q <= sum_102_s2_q;
      sum_112_s3_q <= sum_112_s2_q;
      sum_124_s3_q <= sum_124_s2_q;
      sum_134_s3_q <= sum_134_s2_q;
      sum_150_s3_q <= sum_150_s2_q;
      sum_160_s3_q <= sum_160_s2_q;
      sum_165_s3_q <= sum_165_s2_q;
      sum_169_s3_q <= sum_169_s2_q;
      sum_177_s3_q <= sum_177_s2_q;
      sum_181_s3_q <= sum_181_s2_q;
      sum_187_s3_q <= sum_187_s2_q;
      best_s3_q <= best;
      select_313_s3_q <= select_313_s2_q;
      less_355_s3_q <= less_355_s2_q;
      and_357_s3_q <= and_357_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_198;
  assign difference_198 = {sum_39_s3_q, sum_0_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_200;
  assign select_200 = (difference_198[11:8] == 4'h0) ? difference_198[7:2] : 6'h3f;
  logic [6:0] sum_201;
  assign sum_201 = {1'b0, select_200} + 7'h3;
  logic [5:0] select_203;
  assign select_203 = known_s3_q ? (select_200 - {1'b0, sum_201[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_204;
  assign difference_204 = {sum_187_s3_q, sum_1_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_206;
  assign select_206 = (difference_204[11:8] == 4'h0) ? difference_204[7:2] : 6'h3f;
  logic [6:0] sum_207;
  assign sum_207 = {1'b0, select_206} + 7'h3;
  logic [5:0] select_209;
  assign select_209 = known_s3_q ? (select_206 - {1'b0, sum_207[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_210;
  assign difference_210 = {sum_181_s3_q, sum_2_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_212;
  assign select_212 = (difference_210[11:8] == 4'h0) ? difference_210[7:2] : 6'h3f;
  logic [6:0] sum_213;
  assign sum_213 = {1'b0, select_212} + 7'h3;
  logic [5:0] select_215;
  assign select_215 = known_s3_q ? (select_212 - {1'b0, sum_213[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_216;
  assign difference_216 = {sum_177_s3_q, sum_3_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_218;
  assign select_218 = (difference_216[11:8] == 4'h0) ? difference_216[7:2] : 6'h3f;
  logic [6:0] sum_219;
  assign sum_219 = {1'b0, select_218} + 7'h3;
  logic [5:0] select_221;
  assign select_221 = known_s3_q ? (select_218 - {1'b0, sum_219[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_222;
  assign difference_222 = {sum_169_s3_q, sum_4_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_224;
  assign select_224 = (difference_222[11:8] == 4'h0) ? difference_222[7:2] : 6'h3f;
  logic [6:0] sum_225;
  assign sum_225 = {1'b0, select_224} + 7'h3;
  logic [5:0] select_227;
  assign select_227 = known_s3_q ? (select_224 - {1'b0, sum_225[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_228;
  assign difference_228 = {sum_165_s3_q, sum_5_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_230;
  assign select_230 = (difference_228[11:8] == 4'h0) ? difference_228[7:2] : 6'h3f;
  logic [6:0] sum_231;
  assign sum_231 = {1'b0, select_230} + 7'h3;
  logic [5:0] select_233;
  assign select_233 = known_s3_q ? (select_230 - {1'b0, sum_231[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_234;
  assign difference_234 = {sum_160_s3_q, sum_6_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_236;
  assign select_236 = (difference_234[11:8] == 4'h0) ? difference_234[7:2] : 6'h3f;
  logic [6:0] sum_237;
  assign sum_237 = {1'b0, select_236} + 7'h3;
  logic [5:0] select_239;
  assign select_239 = known_s3_q ? (select_236 - {1'b0, sum_237[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_240;
  assign difference_240 = {sum_150_s3_q, sum_7_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_242;
  assign select_242 = (difference_240[11:8] == 4'h0) ? difference_240[7:2] : 6'h3f;
  logic [6:0] sum_243;
  assign sum_243 = {1'b0, select_242} + 7'h3;
  logic [5:0] select_245;
  assign select_245 = known_s3_q ? (select_242 - {1'b0, sum_243[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_246;
  assign difference_246 = {sum_134_s3_q, sum_8_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_248;
  assign select_248 = (difference_246[11:8] == 4'h0) ? difference_246[7:2] : 6'h3f;
  logic [6:0] sum_249;
  assign sum_249 = {1'b0, select_248} + 7'h3;
  logic [5:0] select_251;
  assign select_251 = known_s3_q ? (select_248 - {1'b0, sum_249[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_252;
  assign difference_252 = {sum_124_s3_q, sum_9_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_254;
  assign select_254 = (difference_252[11:8] == 4'h0) ? difference_252[7:2] : 6'h3f;
  logic [6:0] sum_255;
  assign sum_255 = {1'b0, select_254} + 7'h3;
  logic [5:0] select_257;
  assign select_257 = known_s3_q ? (select_254 - {1'b0, sum_255[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_258;
  assign difference_258 = {sum_112_s3_q, sum_10_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_260;
  assign select_260 = (difference_258[11:8] == 4'h0) ? difference_258[7:2] : 6'h3f;
  logic [6:0] sum_261;
  assign sum_261 = {1'b0, select_260} + 7'h3;
  logic [5:0] select_263;
  assign select_263 = known_s3_q ? (select_260 - {1'b0, sum_261[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_264;
  assign difference_264 = {sum_102_s3_q, sum_11_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_266;
  assign select_266 = (difference_264[11:8] == 4'h0) ? difference_264[7:2] : 6'h3f;
  logic [6:0] sum_267;
  assign sum_267 = {1'b0, select_266} + 7'h3;
  logic [5:0] select_269;
  assign select_269 = known_s3_q ? (select_266 - {1'b0, sum_267[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_270;
  assign difference_270 = {sum_88_s3_q, sum_12_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_272;
  assign select_272 = (difference_270[11:8] == 4'h0) ? difference_270[7:2] : 6'h3f;
  logic [6:0] sum_273;
  assign sum_273 = {1'b0, select_272} + 7'h3;
  logic [5:0] select_275;
  assign select_275 = known_s3_q ? (select_272 - {1'b0, sum_273[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_276;
  assign difference_276 = {sum_76_s3_q, sum_13_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_278;
  assign select_278 = (difference_276[11:8] == 4'h0) ? difference_276[7:2] : 6'h3f;
  logic [6:0] sum_279;
  assign sum_279 = {1'b0, select_278} + 7'h3;
  logic [5:0] select_281;
  assign select_281 = known_s3_q ? (select_278 - {1'b0, sum_279[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_282;
  assign difference_282 = {sum_63_s3_q, sum_14_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_284;
  assign select_284 = (difference_282[11:8] == 4'h0) ? difference_282[7:2] : 6'h3f;
  logic [6:0] sum_285;
  assign sum_285 = {1'b0, select_284} + 7'h3;
  logic [5:0] select_287;
  assign select_287 = known_s3_q ? (select_284 - {1'b0, sum_285[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_288;
  assign difference_288 = {sum_59_s3_q, sum_15_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_290;
  assign select_290 = (difference_288[11:8] == 4'h0) ? difference_288[7:2] : 6'h3f;
  logic [6:0] sum_291;
  assign sum_291 = {1'b0, select_290} + 7'h3;
  logic [5:0] select_293;
  assign select_293 = known_s3_q ? (select_290 - {1'b0, sum_291[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_294;
  assign difference_294 = {sum_51_s3_q, sum_16_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_296;
  assign select_296 = (difference_294[11:8] == 4'h0) ? difference_294[7:2] : 6'h3f;
  logic [6:0] sum_297;
  assign sum_297 = {1'b0, select_296} + 7'h3;
  logic [5:0] select_299;
  assign select_299 = known_s3_q ? (select_296 - {1'b0, sum_297[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_300;
  assign difference_300 = {sum_47_s3_q, sum_17_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_302;
  assign select_302 = (difference_300[11:8] == 4'h0) ? difference_300[7:2] : 6'h3f;
  logic [6:0] sum_303;
  assign sum_303 = {1'b0, select_302} + 7'h3;
  logic [5:0] select_305;
  assign select_305 = known_s3_q ? (select_302 - {1'b0, sum_303[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:67
  logic [11:0] difference_306;
  assign difference_306 = {sum_43_s3_q, sum_18_s3_q} - best_s3_q;
  // hls/stages/plane_paths.hpp:68
  logic [5:0] select_308;
  assign select_308 = (difference_306[11:8] == 4'h0) ? difference_306[7:2] : 6'h3f;
  logic [6:0] sum_309;
  assign sum_309 = {1'b0, select_308} + 7'h3;
  logic [5:0] select_311;
  assign select_311 = known_s3_q ? (select_308 - {1'b0, sum_309[6:2]}) : 6'h0;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = select_31_s3_q;
  logic memory_we;
  assign memory_we = s3_en & select_313_s3_q;
  always_ff @(posedge clk_i) begin
    if (memory_we) memory_mem[memory_waddr] <= {select_311, select_305, select_299, select_293, select_287, select_281, select_275, select_269, select_263, select_257, select_251, select_245, select_239, select_233, select_227, select_221, select_215, select_209, select_203};
  end
`ifndef SYNTHESIS
  logic [9:0] memory_raddr_s1_sim;
  logic memory_re_s1_sim;
  logic [9:0] memory_raddr_s2_sim;
  logic memory_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      memory_re_s1_sim <= 1'b0;
      memory_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      memory_re_s1_sim <= memory_re;
      memory_raddr_s1_sim <= memory_raddr;
      memory_re_s2_sim <= memory_re_s1_sim;
      memory_raddr_s2_sim <= memory_raddr_s1_sim;
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
      if (memory_re_s2_sim && memory_raddr_s2_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_waddr >= 10'd640) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 10'd640) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  logic [1:0] sum_0_s4_q;
  logic [1:0] sum_1_s4_q;
  logic [1:0] sum_2_s4_q;
  logic [1:0] sum_3_s4_q;
  logic [1:0] sum_4_s4_q;
  logic [1:0] sum_5_s4_q;
  logic [1:0] sum_6_s4_q;
  logic [1:0] sum_7_s4_q;
  logic [1:0] sum_8_s4_q;
  logic [1:0] sum_9_s4_q;
  logic [1:0] sum_10_s4_q;
  logic [1:0] sum_11_s4_q;
  logic [1:0] sum_12_s4_q;
  logic [1:0] sum_13_s4_q;
  logic [1:0] sum_14_s4_q;
  logic [1:0] sum_15_s4_q;
  logic [1:0] sum_16_s4_q;
  logic [1:0] sum_17_s4_q;
  logic [1:0] sum_18_s4_q;
  logic [5:0] grey_s4_q;
  logic known_s4_q;
  logic exists_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic [9:0] sum_39_s4_q;
  logic [9:0] sum_43_s4_q;
  logic [9:0] sum_47_s4_q;
  logic [9:0] sum_51_s4_q;
  logic [9:0] sum_59_s4_q;
  logic [9:0] sum_63_s4_q;
  logic [9:0] sum_76_s4_q;
  logic [9:0] sum_88_s4_q;
  logic [9:0] sum_102_s4_q;
  logic [9:0] sum_112_s4_q;
  logic [9:0] sum_124_s4_q;
  logic [9:0] sum_134_s4_q;
  logic [9:0] sum_150_s4_q;
  logic [9:0] sum_160_s4_q;
  logic [9:0] sum_165_s4_q;
  logic [9:0] sum_169_s4_q;
  logic [9:0] sum_177_s4_q;
  logic [9:0] sum_181_s4_q;
  logic [9:0] sum_187_s4_q;
  logic less_355_s4_q;
  logic and_357_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      sum_0_s4_q <= sum_0_s3_q;
      sum_1_s4_q <= sum_1_s3_q;
      sum_2_s4_q <= sum_2_s3_q;
      sum_3_s4_q <= sum_3_s3_q;
      sum_4_s4_q <= sum_4_s3_q;
      sum_5_s4_q <= sum_5_s3_q;
      sum_6_s4_q <= sum_6_s3_q;
      sum_7_s4_q <= sum_7_s3_q;
      sum_8_s4_q <= sum_8_s3_q;
      sum_9_s4_q <= sum_9_s3_q;
      sum_10_s4_q <= sum_10_s3_q;
      sum_11_s4_q <= sum_11_s3_q;
      sum_12_s4_q <= sum_12_s3_q;
      sum_13_s4_q <= sum_13_s3_q;
      sum_14_s4_q <= sum_14_s3_q;
      sum_15_s4_q <= sum_15_s3_q;
      sum_16_s4_q <= sum_16_s3_q;
      sum_17_s4_q <= sum_17_s3_q;
      sum_18_s4_q <= sum_18_s3_q;
      grey_s4_q <= grey_s3_q;
      known_s4_q <= known_s3_q;
      exists_s4_q <= exists_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sum_39_s4_q <= sum_39_s3_q;
      sum_43_s4_q <= sum_43_s3_q;
      sum_47_s4_q <= sum_47_s3_q;
      sum_51_s4_q <= sum_51_s3_q;
      sum_59_s4_q <= sum_59_s3_q;
      sum_63_s4_q <= sum_63_s3_q;
      sum_76_s4_q <= sum_76_s3_q;
      sum_88_s4_q <= sum_88_s3_q;
      sum_102_s4_q <= sum_102_s3_q;
      sum_112_s4_q <= sum_112_s3_q;
      sum_124_s4_q <= sum_124_s3_q;
      sum_134_s4_q <= sum_134_s3_q;
      sum_150_s4_q <= sum_150_s3_q;
      sum_160_s4_q <= sum_160_s3_q;
      sum_165_s4_q <= sum_165_s3_q;
      sum_169_s4_q <= sum_169_s3_q;
      sum_177_s4_q <= sum_177_s3_q;
      sum_181_s4_q <= sum_181_s3_q;
      sum_187_s4_q <= sum_187_s3_q;
      less_355_s4_q <= less_355_s3_q;
      and_357_s4_q <= and_357_s3_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign cost_0_o = {sum_39_s4_q, sum_0_s4_q};
  assign cost_1_o = {sum_187_s4_q, sum_1_s4_q};
  assign cost_2_o = {sum_181_s4_q, sum_2_s4_q};
  assign cost_3_o = {sum_177_s4_q, sum_3_s4_q};
  assign cost_4_o = {sum_169_s4_q, sum_4_s4_q};
  assign cost_5_o = {sum_165_s4_q, sum_5_s4_q};
  assign cost_6_o = {sum_160_s4_q, sum_6_s4_q};
  assign cost_7_o = {sum_150_s4_q, sum_7_s4_q};
  assign cost_8_o = {sum_134_s4_q, sum_8_s4_q};
  assign cost_9_o = {sum_124_s4_q, sum_9_s4_q};
  assign cost_10_o = {sum_112_s4_q, sum_10_s4_q};
  assign cost_11_o = {sum_102_s4_q, sum_11_s4_q};
  assign cost_12_o = {sum_88_s4_q, sum_12_s4_q};
  assign cost_13_o = {sum_76_s4_q, sum_13_s4_q};
  assign cost_14_o = {sum_63_s4_q, sum_14_s4_q};
  assign cost_15_o = {sum_59_s4_q, sum_15_s4_q};
  assign cost_16_o = {sum_51_s4_q, sum_16_s4_q};
  assign cost_17_o = {sum_47_s4_q, sum_17_s4_q};
  assign cost_18_o = {sum_43_s4_q, sum_18_s4_q};
  assign grey_o = grey_s4_q;
  assign known_o = known_s4_q;
  assign evident_o = and_357_s4_q;
  assign strong_v_o = less_355_s4_q;
  assign exists_o = exists_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign valid_o = valid_s4_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_309[1:0], difference_306[1:0], sum_303[1:0], difference_300[1:0], sum_297[1:0], difference_294[1:0], sum_291[1:0], difference_288[1:0], sum_285[1:0], difference_282[1:0], sum_279[1:0], difference_276[1:0], sum_273[1:0], difference_270[1:0], sum_267[1:0], difference_264[1:0], sum_261[1:0], difference_258[1:0], sum_255[1:0], difference_252[1:0], sum_249[1:0], difference_246[1:0], sum_243[1:0], difference_240[1:0], sum_237[1:0], difference_234[1:0], sum_231[1:0], difference_228[1:0], sum_225[1:0], difference_222[1:0], sum_219[1:0], difference_216[1:0], sum_213[1:0], difference_210[1:0], sum_207[1:0], difference_204[1:0], sum_201[1:0], difference_198[1:0]};

endmodule
