// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Paths<horopter::hls::profiles::vga>, hls/stages/plane_paths.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
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
  input  logic [5:0] edges_i,
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
  logic [9:0] select_35;
  assign select_35 = marks_first_i ? 10'h0 : (raster_row_ended_q ? 10'h0 : (raster_column_q + 10'h1));
  // hls/stages/plane_paths.hpp:83
  logic or_37;
  assign or_37 = marks_first_i | running_q;
  // hls/stages/planes.hpp:42
  logic [10:0] select_321;
  assign select_321 = (sum_17_i < sum_16_i) ? sum_17_i : sum_16_i;
  logic [10:0] select_323;
  assign select_323 = (sum_18_i < select_321) ? sum_18_i : select_321;
  logic [10:0] select_325;
  assign select_325 = (sum_15_i < sum_14_i) ? sum_15_i : sum_14_i;
  logic [10:0] select_327;
  assign select_327 = (sum_13_i < sum_12_i) ? sum_13_i : sum_12_i;
  logic [10:0] select_329;
  assign select_329 = (select_325 < select_327) ? select_325 : select_327;
  logic [10:0] select_331;
  assign select_331 = (sum_11_i < sum_10_i) ? sum_11_i : sum_10_i;
  logic [10:0] select_333;
  assign select_333 = (sum_9_i < sum_8_i) ? sum_9_i : sum_8_i;
  logic [10:0] select_335;
  assign select_335 = (select_331 < select_333) ? select_331 : select_333;
  logic [10:0] select_337;
  assign select_337 = (select_329 < select_335) ? select_329 : select_335;
  logic [10:0] select_339;
  assign select_339 = (sum_7_i < sum_6_i) ? sum_7_i : sum_6_i;
  logic [10:0] select_341;
  assign select_341 = (sum_5_i < sum_4_i) ? sum_5_i : sum_4_i;
  logic [10:0] select_343;
  assign select_343 = (select_339 < select_341) ? select_339 : select_341;
  logic [10:0] select_345;
  assign select_345 = (sum_3_i < sum_2_i) ? sum_3_i : sum_2_i;
  logic [10:0] select_347;
  assign select_347 = (sum_1_i < sum_0_i) ? sum_1_i : sum_0_i;
  logic [10:0] select_349;
  assign select_349 = (select_345 < select_347) ? select_345 : select_347;
  logic [10:0] select_351;
  assign select_351 = (select_343 < select_349) ? select_343 : select_349;
  logic [10:0] select_353;
  assign select_353 = (select_337 < select_351) ? select_337 : select_351;
  logic [10:0] select_355;
  assign select_355 = (select_323 < select_353) ? select_323 : select_353;
  // hls/stages/plane_paths.hpp:61
  logic [11:0] sum_356;
  assign sum_356 = {1'b0, evidence_i} + {3'h0, evidence_i[10:2]};
  logic [11:0] sum_357;
  assign sum_357 = {1'b0, evidence_i} + {1'b0, sum_356[11:1]};
  // hls/stages/plane_paths.hpp:63
  logic not_360;
  assign not_360 = ~(edges_i[5:3] == 3'h0);
  // hls/stages/plane_paths.hpp:64
  logic or_361;
  assign or_361 = ({select_355, 4'h0} < {sum_357, sum_356[0], evidence_i[1:0]}) | not_360;

  // Memory memory, 640 x 114 and parity, DISTANCE 16, hls/stages/plane_paths.hpp:118; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [114:0] memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) memory_mem[i] = 115'h0;
`endif
  logic [9:0] memory_raddr;
  assign memory_raddr = running_q ? select_35 : 10'h0;
  logic memory_re;
  assign memory_re = s0_en & or_37;
  logic [114:0] memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_word_q <= memory_mem[memory_raddr];
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
      raster_column_q <= select_35;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_37 : (marks_first_i & or_37);
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
  logic not_360_s1_q;
  logic and_362_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      not_360_s1_q <= not_360;
      and_362_s1_q <= known_i & or_361;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/plane_paths.hpp:79
  logic and_40;
  assign and_40 = raster_rows_q & (~marks_first_s1_q);
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_42;
  assign select_42 = running_s1_q ? memory_rdata_q[5:0] : (marks_first_s1_q ? memory_rdata_q[5:0] : 6'h0);
  logic [5:0] price;
  assign price = and_40 ? select_42 : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_44;
  assign sum_44 = {1'b0, sum_0_s1_q[10:2]} + {4'h0, price};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_46;
  assign select_46 = running_s1_q ? memory_rdata_q[113:108] : (marks_first_s1_q ? memory_rdata_q[113:108] : 6'h0);
  logic [5:0] price_2;
  assign price_2 = and_40 ? select_46 : 6'h0;
  logic [5:0] select_50;
  assign select_50 = running_s1_q ? memory_rdata_q[107:102] : (marks_first_s1_q ? memory_rdata_q[107:102] : 6'h0);
  logic [5:0] price_3;
  assign price_3 = and_40 ? select_50 : 6'h0;
  logic [5:0] select_54;
  assign select_54 = running_s1_q ? memory_rdata_q[101:96] : (marks_first_s1_q ? memory_rdata_q[101:96] : 6'h0);
  logic [5:0] price_4;
  assign price_4 = and_40 ? select_54 : 6'h0;
  logic [5:0] select_62;
  assign select_62 = running_s1_q ? memory_rdata_q[95:90] : (marks_first_s1_q ? memory_rdata_q[95:90] : 6'h0);
  logic [5:0] price_5;
  assign price_5 = and_40 ? select_62 : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_64;
  assign sum_64 = {1'b0, sum_15_s1_q[10:2]} + {4'h0, price_5};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_66;
  assign select_66 = running_s1_q ? memory_rdata_q[89:84] : (marks_first_s1_q ? memory_rdata_q[89:84] : 6'h0);
  logic [5:0] price_6;
  assign price_6 = and_40 ? select_66 : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_68;
  assign sum_68 = {1'b0, sum_14_s1_q[10:2]} + {4'h0, price_6};
  // hls/stages/planes.hpp:42
  logic [11:0] select_70;
  assign select_70 = ({sum_64, sum_15_s1_q[1:0]} < {sum_68, sum_14_s1_q[1:0]}) ? {sum_64, sum_15_s1_q[1:0]} : {sum_68, sum_14_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_72;
  assign select_72 = running_s1_q ? memory_rdata_q[77:72] : (marks_first_s1_q ? memory_rdata_q[77:72] : 6'h0);
  logic [5:0] opinion;
  assign opinion = and_40 ? select_72 : 6'h0;
  // hls/stages/plane_paths.hpp:115
  logic [6:0] sum_74;
  assign sum_74 = {1'b0, opinion} + 7'h27;
  logic [5:0] select_75;
  assign select_75 = sum_74[6] ? 6'h3f : sum_74[5:0];
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_77;
  assign select_77 = running_s1_q ? memory_rdata_q[83:78] : (marks_first_s1_q ? memory_rdata_q[83:78] : 6'h0);
  logic [5:0] opinion_2;
  assign opinion_2 = and_40 ? select_77 : 6'h0;
  // hls/stages/plane_paths.hpp:94
  logic [5:0] price_7;
  assign price_7 = (select_75 < opinion_2) ? select_75 : opinion_2;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_81;
  assign sum_81 = {1'b0, sum_13_s1_q[10:2]} + {4'h0, price_7};
  // hls/stages/plane_paths.hpp:115
  logic [6:0] sum_82;
  assign sum_82 = {1'b0, opinion_2} + 7'h27;
  logic [5:0] select_83;
  assign select_83 = sum_82[6] ? 6'h3f : sum_82[5:0];
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_85;
  assign select_85 = running_s1_q ? memory_rdata_q[71:66] : (marks_first_s1_q ? memory_rdata_q[71:66] : 6'h0);
  logic [5:0] opinion_3;
  assign opinion_3 = and_40 ? select_85 : 6'h0;
  // hls/stages/plane_paths.hpp:115
  logic [6:0] sum_87;
  assign sum_87 = {1'b0, opinion_3} + 7'h27;
  logic [5:0] select_88;
  assign select_88 = sum_87[6] ? 6'h3f : sum_87[5:0];
  // hls/stages/plane_paths.hpp:94
  logic [5:0] price_8;
  assign price_8 = (select_88 < opinion) ? select_88 : opinion;
  // hls/stages/plane_paths.hpp:95
  logic [5:0] price_9;
  assign price_9 = (select_83 < price_8) ? select_83 : price_8;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_93;
  assign sum_93 = {1'b0, sum_12_s1_q[10:2]} + {4'h0, price_9};
  // hls/stages/planes.hpp:42
  logic [11:0] select_95;
  assign select_95 = ({sum_81, sum_13_s1_q[1:0]} < {sum_93, sum_12_s1_q[1:0]}) ? {sum_81, sum_13_s1_q[1:0]} : {sum_93, sum_12_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_99;
  assign select_99 = running_s1_q ? memory_rdata_q[65:60] : (marks_first_s1_q ? memory_rdata_q[65:60] : 6'h0);
  logic [5:0] opinion_4;
  assign opinion_4 = and_40 ? select_99 : 6'h0;
  // hls/stages/plane_paths.hpp:115
  logic [6:0] sum_101;
  assign sum_101 = {1'b0, opinion_4} + 7'h27;
  logic [5:0] select_102;
  assign select_102 = sum_101[6] ? 6'h3f : sum_101[5:0];
  // hls/stages/plane_paths.hpp:94
  logic [5:0] price_10;
  assign price_10 = (select_102 < opinion_3) ? select_102 : opinion_3;
  // hls/stages/plane_paths.hpp:95
  logic [5:0] price_11;
  assign price_11 = (select_75 < price_10) ? select_75 : price_10;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_107;
  assign sum_107 = {1'b0, sum_11_s1_q[10:2]} + {4'h0, price_11};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_109;
  assign select_109 = running_s1_q ? memory_rdata_q[59:54] : (marks_first_s1_q ? memory_rdata_q[59:54] : 6'h0);
  logic [5:0] opinion_5;
  assign opinion_5 = and_40 ? select_109 : 6'h0;
  // hls/stages/plane_paths.hpp:115
  logic [6:0] sum_111;
  assign sum_111 = {1'b0, opinion_5} + 7'h27;
  logic [5:0] select_112;
  assign select_112 = sum_111[6] ? 6'h3f : sum_111[5:0];
  // hls/stages/plane_paths.hpp:94
  logic [5:0] price_12;
  assign price_12 = (select_112 < opinion_4) ? select_112 : opinion_4;
  // hls/stages/plane_paths.hpp:95
  logic [5:0] price_13;
  assign price_13 = (select_88 < price_12) ? select_88 : price_12;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_117;
  assign sum_117 = {1'b0, sum_10_s1_q[10:2]} + {4'h0, price_13};
  // hls/stages/planes.hpp:42
  logic [11:0] select_119;
  assign select_119 = ({sum_107, sum_11_s1_q[1:0]} < {sum_117, sum_10_s1_q[1:0]}) ? {sum_107, sum_11_s1_q[1:0]} : {sum_117, sum_10_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_121;
  assign select_121 = running_s1_q ? memory_rdata_q[53:48] : (marks_first_s1_q ? memory_rdata_q[53:48] : 6'h0);
  logic [5:0] opinion_6;
  assign opinion_6 = and_40 ? select_121 : 6'h0;
  // hls/stages/plane_paths.hpp:115
  logic [6:0] sum_123;
  assign sum_123 = {1'b0, opinion_6} + 7'h27;
  logic [5:0] select_124;
  assign select_124 = sum_123[6] ? 6'h3f : sum_123[5:0];
  // hls/stages/plane_paths.hpp:94
  logic [5:0] price_14;
  assign price_14 = (select_124 < opinion_5) ? select_124 : opinion_5;
  // hls/stages/plane_paths.hpp:95
  logic [5:0] price_15;
  assign price_15 = (select_102 < price_14) ? select_102 : price_14;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_129;
  assign sum_129 = {1'b0, sum_9_s1_q[10:2]} + {4'h0, price_15};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_131;
  assign select_131 = running_s1_q ? memory_rdata_q[47:42] : (marks_first_s1_q ? memory_rdata_q[47:42] : 6'h0);
  logic [5:0] opinion_7;
  assign opinion_7 = and_40 ? select_131 : 6'h0;
  // hls/stages/plane_paths.hpp:115
  logic [6:0] sum_133;
  assign sum_133 = {1'b0, opinion_7} + 7'h27;
  logic [5:0] select_134;
  assign select_134 = sum_133[6] ? 6'h3f : sum_133[5:0];
  // hls/stages/plane_paths.hpp:94
  logic [5:0] price_16;
  assign price_16 = (select_134 < opinion_6) ? select_134 : opinion_6;
  // hls/stages/plane_paths.hpp:95
  logic [5:0] price_17;
  assign price_17 = (select_112 < price_16) ? select_112 : price_16;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_139;
  assign sum_139 = {1'b0, sum_8_s1_q[10:2]} + {4'h0, price_17};
  // hls/stages/planes.hpp:42
  logic [11:0] select_141;
  assign select_141 = ({sum_129, sum_9_s1_q[1:0]} < {sum_139, sum_8_s1_q[1:0]}) ? {sum_129, sum_9_s1_q[1:0]} : {sum_139, sum_8_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_147;
  assign select_147 = running_s1_q ? memory_rdata_q[41:36] : (marks_first_s1_q ? memory_rdata_q[41:36] : 6'h0);
  logic [5:0] opinion_8;
  assign opinion_8 = and_40 ? select_147 : 6'h0;
  // hls/stages/plane_paths.hpp:115
  logic [6:0] sum_149;
  assign sum_149 = {1'b0, opinion_8} + 7'h27;
  logic [5:0] select_150;
  assign select_150 = sum_149[6] ? 6'h3f : sum_149[5:0];
  // hls/stages/plane_paths.hpp:94
  logic [5:0] price_18;
  assign price_18 = (select_150 < opinion_7) ? select_150 : opinion_7;
  // hls/stages/plane_paths.hpp:95
  logic [5:0] price_19;
  assign price_19 = (select_124 < price_18) ? select_124 : price_18;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_155;
  assign sum_155 = {1'b0, sum_7_s1_q[10:2]} + {4'h0, price_19};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_157;
  assign select_157 = running_s1_q ? memory_rdata_q[35:30] : (marks_first_s1_q ? memory_rdata_q[35:30] : 6'h0);
  logic [5:0] opinion_9;
  assign opinion_9 = and_40 ? select_157 : 6'h0;
  // hls/stages/plane_paths.hpp:115
  logic [6:0] sum_159;
  assign sum_159 = {1'b0, opinion_9} + 7'h27;
  logic [5:0] select_160;
  assign select_160 = sum_159[6] ? 6'h3f : sum_159[5:0];
  // hls/stages/plane_paths.hpp:94
  logic [5:0] price_20;
  assign price_20 = (select_160 < opinion_8) ? select_160 : opinion_8;
  // hls/stages/plane_paths.hpp:95
  logic [5:0] price_21;
  assign price_21 = (select_134 < price_20) ? select_134 : price_20;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_165;
  assign sum_165 = {1'b0, sum_6_s1_q[10:2]} + {4'h0, price_21};
  // hls/stages/planes.hpp:42
  logic [11:0] select_167;
  assign select_167 = ({sum_155, sum_7_s1_q[1:0]} < {sum_165, sum_6_s1_q[1:0]}) ? {sum_155, sum_7_s1_q[1:0]} : {sum_165, sum_6_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:95
  logic [5:0] price_22;
  assign price_22 = (select_150 < opinion_9) ? select_150 : opinion_9;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_170;
  assign sum_170 = {1'b0, sum_5_s1_q[10:2]} + {4'h0, price_22};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_172;
  assign select_172 = running_s1_q ? memory_rdata_q[29:24] : (marks_first_s1_q ? memory_rdata_q[29:24] : 6'h0);
  logic [5:0] price_23;
  assign price_23 = and_40 ? select_172 : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_174;
  assign sum_174 = {1'b0, sum_4_s1_q[10:2]} + {4'h0, price_23};
  // hls/stages/planes.hpp:42
  logic [11:0] select_176;
  assign select_176 = ({sum_170, sum_5_s1_q[1:0]} < {sum_174, sum_4_s1_q[1:0]}) ? {sum_170, sum_5_s1_q[1:0]} : {sum_174, sum_4_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_180;
  assign select_180 = running_s1_q ? memory_rdata_q[23:18] : (marks_first_s1_q ? memory_rdata_q[23:18] : 6'h0);
  logic [5:0] price_24;
  assign price_24 = and_40 ? select_180 : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_182;
  assign sum_182 = {1'b0, sum_3_s1_q[10:2]} + {4'h0, price_24};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_184;
  assign select_184 = running_s1_q ? memory_rdata_q[17:12] : (marks_first_s1_q ? memory_rdata_q[17:12] : 6'h0);
  logic [5:0] price_25;
  assign price_25 = and_40 ? select_184 : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_186;
  assign sum_186 = {1'b0, sum_2_s1_q[10:2]} + {4'h0, price_25};
  // hls/stages/planes.hpp:42
  logic [11:0] select_188;
  assign select_188 = ({sum_182, sum_3_s1_q[1:0]} < {sum_186, sum_2_s1_q[1:0]}) ? {sum_182, sum_3_s1_q[1:0]} : {sum_186, sum_2_s1_q[1:0]};
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_190;
  assign select_190 = running_s1_q ? memory_rdata_q[11:6] : (marks_first_s1_q ? memory_rdata_q[11:6] : 6'h0);
  logic [5:0] price_26;
  assign price_26 = and_40 ? select_190 : 6'h0;
  // hls/stages/plane_paths.hpp:96
  logic [9:0] sum_192;
  assign sum_192 = {1'b0, sum_1_s1_q[10:2]} + {4'h0, price_26};
  // hls/stages/planes.hpp:42
  logic [11:0] select_194;
  assign select_194 = ({sum_192, sum_1_s1_q[1:0]} < {sum_44, sum_0_s1_q[1:0]}) ? {sum_192, sum_1_s1_q[1:0]} : {sum_44, sum_0_s1_q[1:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s1_en) begin
      raster_rows_q <= raster_row_ended_q | and_40;
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
  logic [9:0] select_35_s2_q;
  logic [9:0] sum_44_s2_q;
  logic [9:0] sum_48_s2_q;
  logic [9:0] sum_52_s2_q;
  logic [9:0] sum_56_s2_q;
  logic [9:0] sum_64_s2_q;
  logic [9:0] sum_68_s2_q;
  logic [9:0] sum_81_s2_q;
  logic [9:0] sum_93_s2_q;
  logic [11:0] select_97_s2_q;
  logic [9:0] sum_107_s2_q;
  logic [9:0] sum_117_s2_q;
  logic [9:0] sum_129_s2_q;
  logic [9:0] sum_139_s2_q;
  logic [11:0] select_143_s2_q;
  logic [9:0] sum_155_s2_q;
  logic [9:0] sum_165_s2_q;
  logic [9:0] sum_170_s2_q;
  logic [9:0] sum_174_s2_q;
  logic [11:0] select_178_s2_q;
  logic [9:0] sum_182_s2_q;
  logic [9:0] sum_186_s2_q;
  logic [9:0] sum_192_s2_q;
  logic [11:0] select_196_s2_q;
  logic select_318_s2_q;
  logic not_360_s2_q;
  logic and_362_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      select_35_s2_q <= raster_column_q;
      sum_44_s2_q <= sum_44;
      sum_48_s2_q <= {1'b0, sum_18_s1_q[10:2]} + {4'h0, price_2};
      sum_52_s2_q <= {1'b0, sum_17_s1_q[10:2]} + {4'h0, price_3};
      sum_56_s2_q <= {1'b0, sum_16_s1_q[10:2]} + {4'h0, price_4};
      sum_64_s2_q <= sum_64;
      sum_68_s2_q <= sum_68;
      sum_81_s2_q <= sum_81;
      sum_93_s2_q <= sum_93;
      select_97_s2_q <= (select_70 < select_95) ? select_70 : select_95;
      sum_107_s2_q <= sum_107;
      sum_117_s2_q <= sum_117;
      sum_129_s2_q <= sum_129;
      sum_139_s2_q <= sum_139;
      select_143_s2_q <= (select_119 < select_141) ? select_119 : select_141;
      sum_155_s2_q <= sum_155;
      sum_165_s2_q <= sum_165;
      sum_170_s2_q <= sum_170;
      sum_174_s2_q <= sum_174;
      select_178_s2_q <= (select_167 < select_176) ? select_167 : select_176;
      sum_182_s2_q <= sum_182;
      sum_186_s2_q <= sum_186;
      sum_192_s2_q <= sum_192;
      select_196_s2_q <= (select_188 < select_194) ? select_188 : select_194;
      select_318_s2_q <= running_q;
      not_360_s2_q <= not_360_s1_q;
      and_362_s2_q <= and_362_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/planes.hpp:42
  logic [11:0] select_58;
  assign select_58 = ({sum_52_s2_q, sum_17_s2_q} < {sum_56_s2_q, sum_16_s2_q}) ? {sum_52_s2_q, sum_17_s2_q} : {sum_56_s2_q, sum_16_s2_q};
  logic [11:0] select_60;
  assign select_60 = ({sum_48_s2_q, sum_18_s2_q} < select_58) ? {sum_48_s2_q, sum_18_s2_q} : select_58;
  logic [11:0] select_145;
  assign select_145 = (select_97_s2_q < select_143_s2_q) ? select_97_s2_q : select_143_s2_q;
  logic [11:0] select_198;
  assign select_198 = (select_178_s2_q < select_196_s2_q) ? select_178_s2_q : select_196_s2_q;
  logic [11:0] select_200;
  assign select_200 = (select_145 < select_198) ? select_145 : select_198;
  logic [11:0] best;
  assign best = (select_60 < select_200) ? select_60 : select_200;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_203;
  assign difference_203 = {sum_44_s2_q, sum_0_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_205;
  assign select_205 = (difference_203[11:8] == 4'h0) ? difference_203[7:2] : 6'h3f;
  logic [6:0] sum_206;
  assign sum_206 = {1'b0, select_205} + 7'h3;
  logic [5:0] select_208;
  assign select_208 = known_s2_q ? (select_205 - {1'b0, sum_206[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_209;
  assign difference_209 = {sum_192_s2_q, sum_1_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_211;
  assign select_211 = (difference_209[11:8] == 4'h0) ? difference_209[7:2] : 6'h3f;
  logic [6:0] sum_212;
  assign sum_212 = {1'b0, select_211} + 7'h3;
  logic [5:0] select_214;
  assign select_214 = known_s2_q ? (select_211 - {1'b0, sum_212[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_215;
  assign difference_215 = {sum_186_s2_q, sum_2_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_217;
  assign select_217 = (difference_215[11:8] == 4'h0) ? difference_215[7:2] : 6'h3f;
  logic [6:0] sum_218;
  assign sum_218 = {1'b0, select_217} + 7'h3;
  logic [5:0] select_220;
  assign select_220 = known_s2_q ? (select_217 - {1'b0, sum_218[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_221;
  assign difference_221 = {sum_182_s2_q, sum_3_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_223;
  assign select_223 = (difference_221[11:8] == 4'h0) ? difference_221[7:2] : 6'h3f;
  logic [6:0] sum_224;
  assign sum_224 = {1'b0, select_223} + 7'h3;
  logic [5:0] select_226;
  assign select_226 = known_s2_q ? (select_223 - {1'b0, sum_224[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_227;
  assign difference_227 = {sum_174_s2_q, sum_4_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_229;
  assign select_229 = (difference_227[11:8] == 4'h0) ? difference_227[7:2] : 6'h3f;
  logic [6:0] sum_230;
  assign sum_230 = {1'b0, select_229} + 7'h3;
  logic [5:0] select_232;
  assign select_232 = known_s2_q ? (select_229 - {1'b0, sum_230[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_233;
  assign difference_233 = {sum_170_s2_q, sum_5_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_235;
  assign select_235 = (difference_233[11:8] == 4'h0) ? difference_233[7:2] : 6'h3f;
  logic [6:0] sum_236;
  assign sum_236 = {1'b0, select_235} + 7'h3;
  logic [5:0] select_238;
  assign select_238 = known_s2_q ? (select_235 - {1'b0, sum_236[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_239;
  assign difference_239 = {sum_165_s2_q, sum_6_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_241;
  assign select_241 = (difference_239[11:8] == 4'h0) ? difference_239[7:2] : 6'h3f;
  logic [6:0] sum_242;
  assign sum_242 = {1'b0, select_241} + 7'h3;
  logic [5:0] select_244;
  assign select_244 = known_s2_q ? (select_241 - {1'b0, sum_242[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_245;
  assign difference_245 = {sum_155_s2_q, sum_7_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_247;
  assign select_247 = (difference_245[11:8] == 4'h0) ? difference_245[7:2] : 6'h3f;
  logic [6:0] sum_248;
  assign sum_248 = {1'b0, select_247} + 7'h3;
  logic [5:0] select_250;
  assign select_250 = known_s2_q ? (select_247 - {1'b0, sum_248[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_251;
  assign difference_251 = {sum_139_s2_q, sum_8_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_253;
  assign select_253 = (difference_251[11:8] == 4'h0) ? difference_251[7:2] : 6'h3f;
  logic [6:0] sum_254;
  assign sum_254 = {1'b0, select_253} + 7'h3;
  logic [5:0] select_256;
  assign select_256 = known_s2_q ? (select_253 - {1'b0, sum_254[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_257;
  assign difference_257 = {sum_129_s2_q, sum_9_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_259;
  assign select_259 = (difference_257[11:8] == 4'h0) ? difference_257[7:2] : 6'h3f;
  logic [6:0] sum_260;
  assign sum_260 = {1'b0, select_259} + 7'h3;
  logic [5:0] select_262;
  assign select_262 = known_s2_q ? (select_259 - {1'b0, sum_260[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_263;
  assign difference_263 = {sum_117_s2_q, sum_10_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_265;
  assign select_265 = (difference_263[11:8] == 4'h0) ? difference_263[7:2] : 6'h3f;
  logic [6:0] sum_266;
  assign sum_266 = {1'b0, select_265} + 7'h3;
  logic [5:0] select_268;
  assign select_268 = known_s2_q ? (select_265 - {1'b0, sum_266[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_269;
  assign difference_269 = {sum_107_s2_q, sum_11_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_271;
  assign select_271 = (difference_269[11:8] == 4'h0) ? difference_269[7:2] : 6'h3f;
  logic [6:0] sum_272;
  assign sum_272 = {1'b0, select_271} + 7'h3;
  logic [5:0] select_274;
  assign select_274 = known_s2_q ? (select_271 - {1'b0, sum_272[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_275;
  assign difference_275 = {sum_93_s2_q, sum_12_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_277;
  assign select_277 = (difference_275[11:8] == 4'h0) ? difference_275[7:2] : 6'h3f;
  logic [6:0] sum_278;
  assign sum_278 = {1'b0, select_277} + 7'h3;
  logic [5:0] select_280;
  assign select_280 = known_s2_q ? (select_277 - {1'b0, sum_278[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_281;
  assign difference_281 = {sum_81_s2_q, sum_13_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_283;
  assign select_283 = (difference_281[11:8] == 4'h0) ? difference_281[7:2] : 6'h3f;
  logic [6:0] sum_284;
  assign sum_284 = {1'b0, select_283} + 7'h3;
  logic [5:0] select_286;
  assign select_286 = known_s2_q ? (select_283 - {1'b0, sum_284[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_287;
  assign difference_287 = {sum_68_s2_q, sum_14_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_289;
  assign select_289 = (difference_287[11:8] == 4'h0) ? difference_287[7:2] : 6'h3f;
  logic [6:0] sum_290;
  assign sum_290 = {1'b0, select_289} + 7'h3;
  logic [5:0] select_292;
  assign select_292 = known_s2_q ? (select_289 - {1'b0, sum_290[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_293;
  assign difference_293 = {sum_64_s2_q, sum_15_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_295;
  assign select_295 = (difference_293[11:8] == 4'h0) ? difference_293[7:2] : 6'h3f;
  logic [6:0] sum_296;
  assign sum_296 = {1'b0, select_295} + 7'h3;
  logic [5:0] select_298;
  assign select_298 = known_s2_q ? (select_295 - {1'b0, sum_296[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_299;
  assign difference_299 = {sum_56_s2_q, sum_16_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_301;
  assign select_301 = (difference_299[11:8] == 4'h0) ? difference_299[7:2] : 6'h3f;
  logic [6:0] sum_302;
  assign sum_302 = {1'b0, select_301} + 7'h3;
  logic [5:0] select_304;
  assign select_304 = known_s2_q ? (select_301 - {1'b0, sum_302[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_305;
  assign difference_305 = {sum_52_s2_q, sum_17_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_307;
  assign select_307 = (difference_305[11:8] == 4'h0) ? difference_305[7:2] : 6'h3f;
  logic [6:0] sum_308;
  assign sum_308 = {1'b0, select_307} + 7'h3;
  logic [5:0] select_310;
  assign select_310 = known_s2_q ? (select_307 - {1'b0, sum_308[6:2]}) : 6'h0;
  // hls/stages/plane_paths.hpp:105
  logic [11:0] difference_311;
  assign difference_311 = {sum_48_s2_q, sum_18_s2_q} - best;
  // hls/stages/plane_paths.hpp:106
  logic [5:0] select_313;
  assign select_313 = (difference_311[11:8] == 4'h0) ? difference_311[7:2] : 6'h3f;
  logic [6:0] sum_314;
  assign sum_314 = {1'b0, select_313} + 7'h3;
  logic [5:0] select_316;
  assign select_316 = known_s2_q ? (select_313 - {1'b0, sum_314[6:2]}) : 6'h0;

  // Memory memory, write
  logic [9:0] memory_waddr;
  assign memory_waddr = select_35_s2_q;
  logic memory_we;
  assign memory_we = s2_en & select_318_s2_q;
  logic [113:0] memory_wdata;
  assign memory_wdata = {select_316, select_310, select_304, select_298, select_292, select_286, select_280, select_274, select_268, select_262, select_256, select_250, select_244, select_238, select_232, select_226, select_220, select_214, select_208};
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
  logic [9:0] sum_44_s3_q;
  logic [9:0] sum_48_s3_q;
  logic [9:0] sum_52_s3_q;
  logic [9:0] sum_56_s3_q;
  logic [9:0] sum_64_s3_q;
  logic [9:0] sum_68_s3_q;
  logic [9:0] sum_81_s3_q;
  logic [9:0] sum_93_s3_q;
  logic [9:0] sum_107_s3_q;
  logic [9:0] sum_117_s3_q;
  logic [9:0] sum_129_s3_q;
  logic [9:0] sum_139_s3_q;
  logic [9:0] sum_155_s3_q;
  logic [9:0] sum_165_s3_q;
  logic [9:0] sum_170_s3_q;
  logic [9:0] sum_174_s3_q;
  logic [9:0] sum_182_s3_q;
  logic [9:0] sum_186_s3_q;
  logic [9:0] sum_192_s3_q;
  logic not_360_s3_q;
  logic and_362_s3_q;
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
      sum_44_s3_q <= sum_44_s2_q;
      sum_48_s3_q <= sum_48_s2_q;
      sum_52_s3_q <= sum_52_s2_q;
      sum_56_s3_q <= sum_56_s2_q;
      sum_64_s3_q <= sum_64_s2_q;
      sum_68_s3_q <= sum_68_s2_q;
      sum_81_s3_q <= sum_81_s2_q;
      sum_93_s3_q <= sum_93_s2_q;
      sum_107_s3_q <= sum_107_s2_q;
      sum_117_s3_q <= sum_117_s2_q;
      sum_129_s3_q <= sum_129_s2_q;
      sum_139_s3_q <= sum_139_s2_q;
      sum_155_s3_q <= sum_155_s2_q;
      sum_165_s3_q <= sum_165_s2_q;
      sum_170_s3_q <= sum_170_s2_q;
      sum_174_s3_q <= sum_174_s2_q;
      sum_182_s3_q <= sum_182_s2_q;
      sum_186_s3_q <= sum_186_s2_q;
      sum_192_s3_q <= sum_192_s2_q;
      not_360_s3_q <= not_360_s2_q;
      and_362_s3_q <= and_362_s2_q;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (memory_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign cost_0_o = {sum_44_s3_q, sum_0_s3_q};
  assign cost_1_o = {sum_192_s3_q, sum_1_s3_q};
  assign cost_2_o = {sum_186_s3_q, sum_2_s3_q};
  assign cost_3_o = {sum_182_s3_q, sum_3_s3_q};
  assign cost_4_o = {sum_174_s3_q, sum_4_s3_q};
  assign cost_5_o = {sum_170_s3_q, sum_5_s3_q};
  assign cost_6_o = {sum_165_s3_q, sum_6_s3_q};
  assign cost_7_o = {sum_155_s3_q, sum_7_s3_q};
  assign cost_8_o = {sum_139_s3_q, sum_8_s3_q};
  assign cost_9_o = {sum_129_s3_q, sum_9_s3_q};
  assign cost_10_o = {sum_117_s3_q, sum_10_s3_q};
  assign cost_11_o = {sum_107_s3_q, sum_11_s3_q};
  assign cost_12_o = {sum_93_s3_q, sum_12_s3_q};
  assign cost_13_o = {sum_81_s3_q, sum_13_s3_q};
  assign cost_14_o = {sum_68_s3_q, sum_14_s3_q};
  assign cost_15_o = {sum_64_s3_q, sum_15_s3_q};
  assign cost_16_o = {sum_56_s3_q, sum_16_s3_q};
  assign cost_17_o = {sum_52_s3_q, sum_17_s3_q};
  assign cost_18_o = {sum_48_s3_q, sum_18_s3_q};
  assign grey_o = grey_s3_q;
  assign known_o = known_s3_q;
  assign evident_o = and_362_s3_q;
  assign strong_v_o = not_360_s3_q;
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
  assign unused_bits = ^{sum_314[1:0], difference_311[1:0], sum_308[1:0], difference_305[1:0], sum_302[1:0], difference_299[1:0], sum_296[1:0], difference_293[1:0], sum_290[1:0], difference_287[1:0], sum_284[1:0], difference_281[1:0], sum_278[1:0], difference_275[1:0], sum_272[1:0], difference_269[1:0], sum_266[1:0], difference_263[1:0], sum_260[1:0], difference_257[1:0], sum_254[1:0], difference_251[1:0], sum_248[1:0], difference_245[1:0], sum_242[1:0], difference_239[1:0], sum_236[1:0], difference_233[1:0], sum_230[1:0], difference_227[1:0], sum_224[1:0], difference_221[1:0], sum_218[1:0], difference_215[1:0], sum_212[1:0], difference_209[1:0], sum_206[1:0], difference_203[1:0], edges_i[2:0]};

endmodule
