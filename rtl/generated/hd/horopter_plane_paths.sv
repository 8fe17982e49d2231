// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Paths<horopter::hls::profiles::hd>, hls/stages/plane_paths.hpp. Do not edit.
//
// Latency 12 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 14 bits, pipeline 2733 bits, memories 149760 bits.
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
  output logic [5:0] grey_o,
  output logic known_o,
  output logic evident_o,
  output logic strong_v_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;
  assign s9_en = en_i & valid_s9_q;
  assign s10_en = en_i & valid_s10_q;
  assign s11_en = en_i & valid_s11_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] raster_column_q;
  logic raster_row_ended_q;
  logic running_q;
  // hls/stages/plane_paths.hpp:51
  logic [10:0] select_25;
  assign select_25 = (marks_first_i | raster_row_ended_q) ? 11'h0 : raster_column_q;
  // hls/stages/plane_paths.hpp:85
  logic or_26;
  assign or_26 = marks_first_i | running_q;

  // Memory memory, 1920 x 78, DISTANCE 16, hls/stages/plane_paths.hpp:104; read in stage 0, written in stage 11: 0 < 11 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 78'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_25;
  logic memory_re;
  assign memory_re = s0_en & or_26;
  logic [77:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (memory_re) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s0_en) begin
      raster_column_q <= select_25 + 11'h1;
      raster_row_ended_q <= marks_last_i;
      running_q <= running_q ? or_26 : (marks_first_i & or_26);
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
  logic [10:0] evidence_s1_q;
  logic [5:0] grey_s1_q;
  logic known_s1_q;
  logic exists_s1_q;
  logic marks_first_s1_q;
  logic running_s1_q;
  logic [10:0] select_25_s1_q;
  logic less_205_s1_q;
  logic less_207_s1_q;
  logic less_213_s1_q;
  logic less_215_s1_q;
  logic less_219_s1_q;
  logic less_221_s1_q;
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
      evidence_s1_q <= evidence_i;
      grey_s1_q <= grey_i;
      known_s1_q <= known_i;
      exists_s1_q <= exists_i;
      marks_first_s1_q <= marks_first_i;
      running_s1_q <= running_q;
      select_25_s1_q <= select_25;
      less_205_s1_q <= sum_11_i < sum_10_i;
      less_207_s1_q <= sum_9_i < sum_8_i;
      less_213_s1_q <= sum_7_i < sum_6_i;
      less_215_s1_q <= sum_5_i < sum_4_i;
      less_219_s1_q <= sum_3_i < sum_2_i;
      less_221_s1_q <= sum_1_i < sum_0_i;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:98
  logic [10:0] select_206;
  assign select_206 = less_205_s1_q ? sum_11_s1_q : sum_10_s1_q;
  logic [10:0] select_208;
  assign select_208 = less_207_s1_q ? sum_9_s1_q : sum_8_s1_q;
  logic [10:0] select_214;
  assign select_214 = less_213_s1_q ? sum_7_s1_q : sum_6_s1_q;
  logic [10:0] select_216;
  assign select_216 = less_215_s1_q ? sum_5_s1_q : sum_4_s1_q;
  logic [10:0] select_220;
  assign select_220 = less_219_s1_q ? sum_3_s1_q : sum_2_s1_q;
  logic [10:0] select_222;
  assign select_222 = less_221_s1_q ? sum_1_s1_q : sum_0_s1_q;

  logic [10:0] sum_0_s2_q;
  logic [10:0] sum_1_s2_q;
  logic [10:0] sum_2_s2_q;
  logic [10:0] sum_3_s2_q;
  logic [10:0] sum_4_s2_q;
  logic [10:0] sum_5_s2_q;
  logic [10:0] sum_6_s2_q;
  logic [10:0] sum_7_s2_q;
  logic [10:0] sum_8_s2_q;
  logic [10:0] sum_9_s2_q;
  logic [10:0] sum_10_s2_q;
  logic [10:0] sum_11_s2_q;
  logic [10:0] sum_12_s2_q;
  logic [10:0] evidence_s2_q;
  logic [5:0] grey_s2_q;
  logic known_s2_q;
  logic exists_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic running_s2_q;
  logic [10:0] select_25_s2_q;
  logic [77:0] memory_rdata_s2_q;
  logic select_202_s2_q;
  logic [10:0] select_210_s2_q;
  logic [10:0] select_218_s2_q;
  logic [10:0] select_224_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      sum_0_s2_q <= sum_0_s1_q;
      sum_1_s2_q <= sum_1_s1_q;
      sum_2_s2_q <= sum_2_s1_q;
      sum_3_s2_q <= sum_3_s1_q;
      sum_4_s2_q <= sum_4_s1_q;
      sum_5_s2_q <= sum_5_s1_q;
      sum_6_s2_q <= sum_6_s1_q;
      sum_7_s2_q <= sum_7_s1_q;
      sum_8_s2_q <= sum_8_s1_q;
      sum_9_s2_q <= sum_9_s1_q;
      sum_10_s2_q <= sum_10_s1_q;
      sum_11_s2_q <= sum_11_s1_q;
      sum_12_s2_q <= sum_12_s1_q;
      evidence_s2_q <= evidence_s1_q;
      grey_s2_q <= grey_s1_q;
      known_s2_q <= known_s1_q;
      exists_s2_q <= exists_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      running_s2_q <= running_s1_q;
      select_25_s2_q <= select_25_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
      select_202_s2_q <= running_q;
      select_210_s2_q <= (select_206 < select_208) ? select_206 : select_208;
      select_218_s2_q <= (select_214 < select_216) ? select_214 : select_216;
      select_224_s2_q <= (select_220 < select_222) ? select_220 : select_222;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  // hls/stages/plane_paths.hpp:51
  logic and_29;
  assign and_29 = raster_rows_q & (~marks_first_s2_q);
  // hls/stages/plane_paths.hpp:55
  logic [47:0] select_31;
  assign select_31 = running_s2_q ? memory_rdata_s2_q[47:0] : (marks_first_s2_q ? memory_rdata_s2_q[47:0] : 48'h0);
  // hls/stages/plane_paths.hpp:40
  logic [47:0] price;
  assign price = and_29 ? select_31 : 48'h0;
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_35;
  assign select_35 = running_s2_q ? memory_rdata_s2_q[77:72] : (marks_first_s2_q ? memory_rdata_s2_q[77:72] : 6'h0);
  // hls/stages/plane_paths.hpp:40
  logic [5:0] price_2;
  assign price_2 = and_29 ? select_35 : 6'h0;
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_39;
  assign select_39 = running_s2_q ? memory_rdata_s2_q[71:66] : (marks_first_s2_q ? memory_rdata_s2_q[71:66] : 6'h0);
  // hls/stages/plane_paths.hpp:40
  logic [5:0] price_3;
  assign price_3 = and_29 ? select_39 : 6'h0;
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_43;
  assign select_43 = running_s2_q ? memory_rdata_s2_q[65:60] : (marks_first_s2_q ? memory_rdata_s2_q[65:60] : 6'h0);
  // hls/stages/plane_paths.hpp:40
  logic [5:0] price_4;
  assign price_4 = and_29 ? select_43 : 6'h0;
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_49;
  assign select_49 = running_s2_q ? memory_rdata_s2_q[53:48] : (marks_first_s2_q ? memory_rdata_s2_q[53:48] : 6'h0);
  // hls/stages/plane_paths.hpp:40
  logic [5:0] opinion;
  assign opinion = and_29 ? select_49 : 6'h0;
  // hls/stages/plane_paths.hpp:55
  logic [5:0] select_54;
  assign select_54 = running_s2_q ? memory_rdata_s2_q[59:54] : (marks_first_s2_q ? memory_rdata_s2_q[59:54] : 6'h0);
  // hls/stages/plane_paths.hpp:40
  logic [5:0] price_5;
  assign price_5 = and_29 ? select_54 : 6'h0;
  // hls/stages/plane_paths.hpp:98
  logic [10:0] select_226;
  assign select_226 = (select_218_s2_q < select_224_s2_q) ? select_218_s2_q : select_224_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s2_en) begin
      raster_rows_q <= marks_last_s2_q | and_29;
    end
  end

  logic [10:0] sum_0_s3_q;
  logic [10:0] sum_1_s3_q;
  logic [10:0] sum_2_s3_q;
  logic [10:0] sum_3_s3_q;
  logic [10:0] sum_4_s3_q;
  logic [10:0] sum_5_s3_q;
  logic [10:0] sum_6_s3_q;
  logic [10:0] sum_7_s3_q;
  logic [10:0] sum_8_s3_q;
  logic [10:0] sum_9_s3_q;
  logic [10:0] sum_10_s3_q;
  logic [10:0] sum_11_s3_q;
  logic [10:0] sum_12_s3_q;
  logic [10:0] evidence_s3_q;
  logic [5:0] grey_s3_q;
  logic known_s3_q;
  logic exists_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic [10:0] select_25_s3_q;
  logic [47:0] price_s3_q;
  logic [5:0] price_2_s3_q;
  logic [5:0] price_3_s3_q;
  logic [5:0] price_4_s3_q;
  logic [5:0] opinion_s3_q;
  logic [5:0] price_5_s3_q;
  logic select_202_s3_q;
  logic [10:0] select_212_s3_q;
  logic [10:0] select_226_s3_q;
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
      evidence_s3_q <= evidence_s2_q;
      grey_s3_q <= grey_s2_q;
      known_s3_q <= known_s2_q;
      exists_s3_q <= exists_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      select_25_s3_q <= select_25_s2_q;
      price_s3_q <= price;
      price_2_s3_q <= price_2;
      price_3_s3_q <= price_3;
      price_4_s3_q <= price_4;
      opinion_s3_q <= opinion;
      price_5_s3_q <= price_5;
      select_202_s3_q <= select_202_s2_q;
      select_212_s3_q <= (sum_12_s2_q < select_210_s2_q) ? sum_12_s2_q : select_210_s2_q;
      select_226_s3_q <= select_226;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:90
  logic [6:0] sum_51;
  assign sum_51 = {1'b0, opinion_s3_q} + 7'h27;
  logic [5:0] select_52;
  assign select_52 = sum_51[6] ? 6'h3f : sum_51[5:0];
  logic [6:0] sum_59;
  assign sum_59 = {1'b0, price_5_s3_q} + 7'h27;
  logic [6:0] sum_61;
  assign sum_61 = {1'b0, price_s3_q[47:42]} + 7'h27;
  logic [5:0] select_62;
  assign select_62 = sum_61[6] ? 6'h3f : sum_61[5:0];
  logic [6:0] sum_74;
  assign sum_74 = {1'b0, price_s3_q[41:36]} + 7'h27;
  logic [5:0] select_75;
  assign select_75 = sum_74[6] ? 6'h3f : sum_74[5:0];
  logic [6:0] sum_81;
  assign sum_81 = {1'b0, price_s3_q[35:30]} + 7'h27;
  logic [5:0] select_82;
  assign select_82 = sum_81[6] ? 6'h3f : sum_81[5:0];
  logic [6:0] sum_90;
  assign sum_90 = {1'b0, price_s3_q[29:24]} + 7'h27;
  logic [5:0] select_91;
  assign select_91 = sum_90[6] ? 6'h3f : sum_90[5:0];
  logic [6:0] sum_97;
  assign sum_97 = {1'b0, price_s3_q[23:18]} + 7'h27;
  logic [5:0] select_98;
  assign select_98 = sum_97[6] ? 6'h3f : sum_97[5:0];
  // hls/stages/plane_paths.hpp:98
  logic [10:0] select_228;
  assign select_228 = (select_212_s3_q < select_226_s3_q) ? select_212_s3_q : select_226_s3_q;
  // hls/stages/plane_paths.hpp:74
  logic [11:0] sum_229;
  assign sum_229 = {1'b0, evidence_s3_q} + {3'h0, evidence_s3_q[10:2]};

  logic [1:0] sum_0_s4_q;
  logic [1:0] sum_1_s4_q;
  logic [1:0] sum_2_s4_q;
  logic [10:0] sum_3_s4_q;
  logic [10:0] sum_4_s4_q;
  logic [10:0] sum_5_s4_q;
  logic [10:0] sum_6_s4_q;
  logic [10:0] sum_7_s4_q;
  logic [10:0] sum_8_s4_q;
  logic [10:0] sum_9_s4_q;
  logic [1:0] sum_10_s4_q;
  logic [1:0] sum_11_s4_q;
  logic [1:0] sum_12_s4_q;
  logic [1:0] evidence_s4_q;
  logic [5:0] grey_s4_q;
  logic known_s4_q;
  logic exists_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic [10:0] select_25_s4_q;
  logic [29:0] price_s4_q;
  logic [9:0] sum_33_s4_q;
  logic [9:0] sum_37_s4_q;
  logic [9:0] sum_41_s4_q;
  logic [9:0] sum_45_s4_q;
  logic [5:0] opinion_s4_q;
  logic [5:0] select_52_s4_q;
  logic [5:0] price_5_s4_q;
  logic less_56_s4_q;
  logic [5:0] select_60_s4_q;
  logic [5:0] select_62_s4_q;
  logic less_63_s4_q;
  logic [5:0] select_75_s4_q;
  logic less_76_s4_q;
  logic [5:0] select_82_s4_q;
  logic less_83_s4_q;
  logic [5:0] select_91_s4_q;
  logic less_92_s4_q;
  logic [5:0] select_98_s4_q;
  logic less_99_s4_q;
  logic less_108_s4_q;
  logic [9:0] sum_111_s4_q;
  logic [9:0] sum_114_s4_q;
  logic select_202_s4_q;
  logic [10:0] select_228_s4_q;
  logic sum_229_s4_q;
  logic [11:0] sum_230_s4_q;
  logic less_232_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      sum_0_s4_q <= sum_0_s3_q[1:0];
      sum_1_s4_q <= sum_1_s3_q[1:0];
      sum_2_s4_q <= sum_2_s3_q[1:0];
      sum_3_s4_q <= sum_3_s3_q;
      sum_4_s4_q <= sum_4_s3_q;
      sum_5_s4_q <= sum_5_s3_q;
      sum_6_s4_q <= sum_6_s3_q;
      sum_7_s4_q <= sum_7_s3_q;
      sum_8_s4_q <= sum_8_s3_q;
      sum_9_s4_q <= sum_9_s3_q;
      sum_10_s4_q <= sum_10_s3_q[1:0];
      sum_11_s4_q <= sum_11_s3_q[1:0];
      sum_12_s4_q <= sum_12_s3_q[1:0];
      evidence_s4_q <= evidence_s3_q[1:0];
      grey_s4_q <= grey_s3_q;
      known_s4_q <= known_s3_q;
      exists_s4_q <= exists_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      select_25_s4_q <= select_25_s3_q;
      price_s4_q <= price_s3_q[47:18];
      sum_33_s4_q <= {1'b0, sum_0_s3_q[10:2]} + {4'h0, price_s3_q[5:0]};
      sum_37_s4_q <= {1'b0, sum_12_s3_q[10:2]} + {4'h0, price_2_s3_q};
      sum_41_s4_q <= {1'b0, sum_11_s3_q[10:2]} + {4'h0, price_3_s3_q};
      sum_45_s4_q <= {1'b0, sum_10_s3_q[10:2]} + {4'h0, price_4_s3_q};
      opinion_s4_q <= opinion_s3_q;
      select_52_s4_q <= select_52;
      price_5_s4_q <= price_5_s3_q;
      less_56_s4_q <= select_52 < price_5_s3_q;
      select_60_s4_q <= sum_59[6] ? 6'h3f : sum_59[5:0];
      select_62_s4_q <= select_62;
      less_63_s4_q <= select_62 < opinion_s3_q;
      select_75_s4_q <= select_75;
      less_76_s4_q <= select_75 < price_s3_q[47:42];
      select_82_s4_q <= select_82;
      less_83_s4_q <= select_82 < price_s3_q[41:36];
      select_91_s4_q <= select_91;
      less_92_s4_q <= select_91 < price_s3_q[35:30];
      select_98_s4_q <= select_98;
      less_99_s4_q <= select_98 < price_s3_q[29:24];
      less_108_s4_q <= select_91 < price_s3_q[23:18];
      sum_111_s4_q <= {1'b0, sum_2_s3_q[10:2]} + {4'h0, price_s3_q[17:12]};
      sum_114_s4_q <= {1'b0, sum_1_s3_q[10:2]} + {4'h0, price_s3_q[11:6]};
      select_202_s4_q <= select_202_s3_q;
      select_228_s4_q <= select_228;
      sum_229_s4_q <= sum_229[0];
      sum_230_s4_q <= {1'b0, evidence_s3_q} + {1'b0, sum_229[11:1]};
      less_232_s4_q <= 10'h13a < evidence_s3_q[10:1];
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_6;
  assign price_6 = less_56_s4_q ? select_52_s4_q : price_5_s4_q;
  logic [5:0] price_7;
  assign price_7 = less_63_s4_q ? select_62_s4_q : opinion_s4_q;
  // hls/stages/plane_paths.hpp:62
  logic [5:0] price_8;
  assign price_8 = (select_60_s4_q < price_7) ? select_60_s4_q : price_7;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_9;
  assign price_9 = less_76_s4_q ? select_75_s4_q : price_s4_q[29:24];
  // hls/stages/plane_paths.hpp:62
  logic [5:0] price_10;
  assign price_10 = (select_52_s4_q < price_9) ? select_52_s4_q : price_9;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_11;
  assign price_11 = less_83_s4_q ? select_82_s4_q : price_s4_q[23:18];
  // hls/stages/plane_paths.hpp:62
  logic [5:0] price_12;
  assign price_12 = (select_62_s4_q < price_11) ? select_62_s4_q : price_11;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_13;
  assign price_13 = less_92_s4_q ? select_91_s4_q : price_s4_q[17:12];
  // hls/stages/plane_paths.hpp:62
  logic [5:0] price_14;
  assign price_14 = (select_75_s4_q < price_13) ? select_75_s4_q : price_13;
  // hls/stages/plane_paths.hpp:61
  logic [5:0] price_15;
  assign price_15 = less_99_s4_q ? select_98_s4_q : price_s4_q[11:6];
  // hls/stages/plane_paths.hpp:62
  logic [5:0] price_16;
  assign price_16 = (select_82_s4_q < price_15) ? select_82_s4_q : price_15;
  logic [5:0] price_17;
  assign price_17 = less_108_s4_q ? select_91_s4_q : price_s4_q[5:0];
  // hls/stages/plane_paths.hpp:75
  logic less_231;
  assign less_231 = {select_228_s4_q, 4'h0} < {sum_230_s4_q, sum_229_s4_q, evidence_s4_q};

  logic [1:0] sum_0_s5_q;
  logic [1:0] sum_1_s5_q;
  logic [1:0] sum_2_s5_q;
  logic [1:0] sum_3_s5_q;
  logic [10:0] sum_4_s5_q;
  logic [10:0] sum_5_s5_q;
  logic [10:0] sum_6_s5_q;
  logic [10:0] sum_7_s5_q;
  logic [10:0] sum_8_s5_q;
  logic [1:0] sum_9_s5_q;
  logic [1:0] sum_10_s5_q;
  logic [1:0] sum_11_s5_q;
  logic [1:0] sum_12_s5_q;
  logic [5:0] grey_s5_q;
  logic known_s5_q;
  logic exists_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic [10:0] select_25_s5_q;
  logic [9:0] sum_33_s5_q;
  logic [9:0] sum_37_s5_q;
  logic [9:0] sum_41_s5_q;
  logic [9:0] sum_45_s5_q;
  logic [9:0] sum_58_s5_q;
  logic [5:0] price_8_s5_q;
  logic [5:0] price_10_s5_q;
  logic [5:0] price_12_s5_q;
  logic [5:0] price_14_s5_q;
  logic [5:0] price_16_s5_q;
  logic [9:0] sum_110_s5_q;
  logic [9:0] sum_111_s5_q;
  logic [9:0] sum_114_s5_q;
  logic select_202_s5_q;
  logic less_232_s5_q;
  logic and_234_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      sum_0_s5_q <= sum_0_s4_q;
      sum_1_s5_q <= sum_1_s4_q;
      sum_2_s5_q <= sum_2_s4_q;
      sum_3_s5_q <= sum_3_s4_q[1:0];
      sum_4_s5_q <= sum_4_s4_q;
      sum_5_s5_q <= sum_5_s4_q;
      sum_6_s5_q <= sum_6_s4_q;
      sum_7_s5_q <= sum_7_s4_q;
      sum_8_s5_q <= sum_8_s4_q;
      sum_9_s5_q <= sum_9_s4_q[1:0];
      sum_10_s5_q <= sum_10_s4_q;
      sum_11_s5_q <= sum_11_s4_q;
      sum_12_s5_q <= sum_12_s4_q;
      grey_s5_q <= grey_s4_q;
      known_s5_q <= known_s4_q;
      exists_s5_q <= exists_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      select_25_s5_q <= select_25_s4_q;
      sum_33_s5_q <= sum_33_s4_q;
      sum_37_s5_q <= sum_37_s4_q;
      sum_41_s5_q <= sum_41_s4_q;
      sum_45_s5_q <= sum_45_s4_q;
      sum_58_s5_q <= {1'b0, sum_9_s4_q[10:2]} + {4'h0, price_6};
      price_8_s5_q <= price_8;
      price_10_s5_q <= price_10;
      price_12_s5_q <= price_12;
      price_14_s5_q <= price_14;
      price_16_s5_q <= price_16;
      sum_110_s5_q <= {1'b0, sum_3_s4_q[10:2]} + {4'h0, price_17};
      sum_111_s5_q <= sum_111_s4_q;
      sum_114_s5_q <= sum_114_s4_q;
      select_202_s5_q <= select_202_s4_q;
      less_232_s5_q <= less_232_s4_q;
      and_234_s5_q <= known_s4_q & (less_231 | less_232_s4_q);
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:63
  logic [9:0] sum_67;
  assign sum_67 = {1'b0, sum_8_s5_q[10:2]} + {4'h0, price_8_s5_q};
  logic [9:0] sum_80;
  assign sum_80 = {1'b0, sum_7_s5_q[10:2]} + {4'h0, price_10_s5_q};
  logic [9:0] sum_87;
  assign sum_87 = {1'b0, sum_6_s5_q[10:2]} + {4'h0, price_12_s5_q};
  logic [9:0] sum_96;
  assign sum_96 = {1'b0, sum_5_s5_q[10:2]} + {4'h0, price_14_s5_q};
  logic [9:0] sum_103;
  assign sum_103 = {1'b0, sum_4_s5_q[10:2]} + {4'h0, price_16_s5_q};

  logic [1:0] sum_0_s6_q;
  logic [1:0] sum_1_s6_q;
  logic [1:0] sum_2_s6_q;
  logic [1:0] sum_3_s6_q;
  logic [1:0] sum_4_s6_q;
  logic [1:0] sum_5_s6_q;
  logic [1:0] sum_6_s6_q;
  logic [1:0] sum_7_s6_q;
  logic [1:0] sum_8_s6_q;
  logic [1:0] sum_9_s6_q;
  logic [1:0] sum_10_s6_q;
  logic [1:0] sum_11_s6_q;
  logic [1:0] sum_12_s6_q;
  logic [5:0] grey_s6_q;
  logic known_s6_q;
  logic exists_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic [10:0] select_25_s6_q;
  logic [9:0] sum_33_s6_q;
  logic [9:0] sum_37_s6_q;
  logic [9:0] sum_41_s6_q;
  logic [9:0] sum_45_s6_q;
  logic less_46_s6_q;
  logic [9:0] sum_58_s6_q;
  logic [9:0] sum_67_s6_q;
  logic less_68_s6_q;
  logic [9:0] sum_80_s6_q;
  logic [9:0] sum_87_s6_q;
  logic less_88_s6_q;
  logic [9:0] sum_96_s6_q;
  logic [9:0] sum_103_s6_q;
  logic less_104_s6_q;
  logic [9:0] sum_110_s6_q;
  logic [9:0] sum_111_s6_q;
  logic less_112_s6_q;
  logic [9:0] sum_114_s6_q;
  logic less_115_s6_q;
  logic select_202_s6_q;
  logic less_232_s6_q;
  logic and_234_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      sum_0_s6_q <= sum_0_s5_q;
      sum_1_s6_q <= sum_1_s5_q;
      sum_2_s6_q <= sum_2_s5_q;
      sum_3_s6_q <= sum_3_s5_q;
      sum_4_s6_q <= sum_4_s5_q[1:0];
      sum_5_s6_q <= sum_5_s5_q[1:0];
      sum_6_s6_q <= sum_6_s5_q[1:0];
      sum_7_s6_q <= sum_7_s5_q[1:0];
      sum_8_s6_q <= sum_8_s5_q[1:0];
      sum_9_s6_q <= sum_9_s5_q;
      sum_10_s6_q <= sum_10_s5_q;
      sum_11_s6_q <= sum_11_s5_q;
      sum_12_s6_q <= sum_12_s5_q;
      grey_s6_q <= grey_s5_q;
      known_s6_q <= known_s5_q;
      exists_s6_q <= exists_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      select_25_s6_q <= select_25_s5_q;
      sum_33_s6_q <= sum_33_s5_q;
      sum_37_s6_q <= sum_37_s5_q;
      sum_41_s6_q <= sum_41_s5_q;
      sum_45_s6_q <= sum_45_s5_q;
      less_46_s6_q <= {sum_41_s5_q, sum_11_s5_q} < {sum_45_s5_q, sum_10_s5_q};
      sum_58_s6_q <= sum_58_s5_q;
      sum_67_s6_q <= sum_67;
      less_68_s6_q <= {sum_58_s5_q, sum_9_s5_q} < {sum_67, sum_8_s5_q[1:0]};
      sum_80_s6_q <= sum_80;
      sum_87_s6_q <= sum_87;
      less_88_s6_q <= {sum_80, sum_7_s5_q[1:0]} < {sum_87, sum_6_s5_q[1:0]};
      sum_96_s6_q <= sum_96;
      sum_103_s6_q <= sum_103;
      less_104_s6_q <= {sum_96, sum_5_s5_q[1:0]} < {sum_103, sum_4_s5_q[1:0]};
      sum_110_s6_q <= sum_110_s5_q;
      sum_111_s6_q <= sum_111_s5_q;
      less_112_s6_q <= {sum_110_s5_q, sum_3_s5_q} < {sum_111_s5_q, sum_2_s5_q};
      sum_114_s6_q <= sum_114_s5_q;
      less_115_s6_q <= {sum_114_s5_q, sum_1_s5_q} < {sum_33_s5_q, sum_0_s5_q};
      select_202_s6_q <= select_202_s5_q;
      less_232_s6_q <= less_232_s5_q;
      and_234_s6_q <= and_234_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:98
  logic [11:0] select_47;
  assign select_47 = less_46_s6_q ? {sum_41_s6_q, sum_11_s6_q} : {sum_45_s6_q, sum_10_s6_q};
  logic [11:0] select_69;
  assign select_69 = less_68_s6_q ? {sum_58_s6_q, sum_9_s6_q} : {sum_67_s6_q, sum_8_s6_q};
  logic [11:0] select_89;
  assign select_89 = less_88_s6_q ? {sum_80_s6_q, sum_7_s6_q} : {sum_87_s6_q, sum_6_s6_q};
  logic [11:0] select_105;
  assign select_105 = less_104_s6_q ? {sum_96_s6_q, sum_5_s6_q} : {sum_103_s6_q, sum_4_s6_q};
  logic [11:0] select_113;
  assign select_113 = less_112_s6_q ? {sum_110_s6_q, sum_3_s6_q} : {sum_111_s6_q, sum_2_s6_q};
  logic [11:0] select_116;
  assign select_116 = less_115_s6_q ? {sum_114_s6_q, sum_1_s6_q} : {sum_33_s6_q, sum_0_s6_q};

  logic [1:0] sum_0_s7_q;
  logic [1:0] sum_1_s7_q;
  logic [1:0] sum_2_s7_q;
  logic [1:0] sum_3_s7_q;
  logic [1:0] sum_4_s7_q;
  logic [1:0] sum_5_s7_q;
  logic [1:0] sum_6_s7_q;
  logic [1:0] sum_7_s7_q;
  logic [1:0] sum_8_s7_q;
  logic [1:0] sum_9_s7_q;
  logic [1:0] sum_10_s7_q;
  logic [1:0] sum_11_s7_q;
  logic [1:0] sum_12_s7_q;
  logic [5:0] grey_s7_q;
  logic known_s7_q;
  logic exists_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic [10:0] select_25_s7_q;
  logic [9:0] sum_33_s7_q;
  logic [9:0] sum_37_s7_q;
  logic [9:0] sum_41_s7_q;
  logic [9:0] sum_45_s7_q;
  logic [9:0] sum_58_s7_q;
  logic [9:0] sum_67_s7_q;
  logic [11:0] select_71_s7_q;
  logic [9:0] sum_80_s7_q;
  logic [9:0] sum_87_s7_q;
  logic [9:0] sum_96_s7_q;
  logic [9:0] sum_103_s7_q;
  logic [11:0] select_107_s7_q;
  logic [9:0] sum_110_s7_q;
  logic [9:0] sum_111_s7_q;
  logic [9:0] sum_114_s7_q;
  logic [11:0] select_118_s7_q;
  logic select_202_s7_q;
  logic less_232_s7_q;
  logic and_234_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      sum_0_s7_q <= sum_0_s6_q;
      sum_1_s7_q <= sum_1_s6_q;
      sum_2_s7_q <= sum_2_s6_q;
      sum_3_s7_q <= sum_3_s6_q;
      sum_4_s7_q <= sum_4_s6_q;
      sum_5_s7_q <= sum_5_s6_q;
      sum_6_s7_q <= sum_6_s6_q;
      sum_7_s7_q <= sum_7_s6_q;
      sum_8_s7_q <= sum_8_s6_q;
      sum_9_s7_q <= sum_9_s6_q;
      sum_10_s7_q <= sum_10_s6_q;
      sum_11_s7_q <= sum_11_s6_q;
      sum_12_s7_q <= sum_12_s6_q;
      grey_s7_q <= grey_s6_q;
      known_s7_q <= known_s6_q;
      exists_s7_q <= exists_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      select_25_s7_q <= select_25_s6_q;
      sum_33_s7_q <= sum_33_s6_q;
      sum_37_s7_q <= sum_37_s6_q;
      sum_41_s7_q <= sum_41_s6_q;
      sum_45_s7_q <= sum_45_s6_q;
      sum_58_s7_q <= sum_58_s6_q;
      sum_67_s7_q <= sum_67_s6_q;
      select_71_s7_q <= (select_47 < select_69) ? select_47 : select_69;
      sum_80_s7_q <= sum_80_s6_q;
      sum_87_s7_q <= sum_87_s6_q;
      sum_96_s7_q <= sum_96_s6_q;
      sum_103_s7_q <= sum_103_s6_q;
      select_107_s7_q <= (select_89 < select_105) ? select_89 : select_105;
      sum_110_s7_q <= sum_110_s6_q;
      sum_111_s7_q <= sum_111_s6_q;
      sum_114_s7_q <= sum_114_s6_q;
      select_118_s7_q <= (select_113 < select_116) ? select_113 : select_116;
      select_202_s7_q <= select_202_s6_q;
      less_232_s7_q <= less_232_s6_q;
      and_234_s7_q <= and_234_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:98
  logic [11:0] select_73;
  assign select_73 = ({sum_37_s7_q, sum_12_s7_q} < select_71_s7_q) ? {sum_37_s7_q, sum_12_s7_q} : select_71_s7_q;
  logic [11:0] select_120;
  assign select_120 = (select_107_s7_q < select_118_s7_q) ? select_107_s7_q : select_118_s7_q;

  logic [1:0] sum_0_s8_q;
  logic [1:0] sum_1_s8_q;
  logic [1:0] sum_2_s8_q;
  logic [1:0] sum_3_s8_q;
  logic [1:0] sum_4_s8_q;
  logic [1:0] sum_5_s8_q;
  logic [1:0] sum_6_s8_q;
  logic [1:0] sum_7_s8_q;
  logic [1:0] sum_8_s8_q;
  logic [1:0] sum_9_s8_q;
  logic [1:0] sum_10_s8_q;
  logic [1:0] sum_11_s8_q;
  logic [1:0] sum_12_s8_q;
  logic [5:0] grey_s8_q;
  logic known_s8_q;
  logic exists_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic [10:0] select_25_s8_q;
  logic [9:0] sum_33_s8_q;
  logic [9:0] sum_37_s8_q;
  logic [9:0] sum_41_s8_q;
  logic [9:0] sum_45_s8_q;
  logic [9:0] sum_58_s8_q;
  logic [9:0] sum_67_s8_q;
  logic [11:0] select_73_s8_q;
  logic [9:0] sum_80_s8_q;
  logic [9:0] sum_87_s8_q;
  logic [9:0] sum_96_s8_q;
  logic [9:0] sum_103_s8_q;
  logic [9:0] sum_110_s8_q;
  logic [9:0] sum_111_s8_q;
  logic [9:0] sum_114_s8_q;
  logic [11:0] select_120_s8_q;
  logic select_202_s8_q;
  logic less_232_s8_q;
  logic and_234_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      sum_0_s8_q <= sum_0_s7_q;
      sum_1_s8_q <= sum_1_s7_q;
      sum_2_s8_q <= sum_2_s7_q;
      sum_3_s8_q <= sum_3_s7_q;
      sum_4_s8_q <= sum_4_s7_q;
      sum_5_s8_q <= sum_5_s7_q;
      sum_6_s8_q <= sum_6_s7_q;
      sum_7_s8_q <= sum_7_s7_q;
      sum_8_s8_q <= sum_8_s7_q;
      sum_9_s8_q <= sum_9_s7_q;
      sum_10_s8_q <= sum_10_s7_q;
      sum_11_s8_q <= sum_11_s7_q;
      sum_12_s8_q <= sum_12_s7_q;
      grey_s8_q <= grey_s7_q;
      known_s8_q <= known_s7_q;
      exists_s8_q <= exists_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      select_25_s8_q <= select_25_s7_q;
      sum_33_s8_q <= sum_33_s7_q;
      sum_37_s8_q <= sum_37_s7_q;
      sum_41_s8_q <= sum_41_s7_q;
      sum_45_s8_q <= sum_45_s7_q;
      sum_58_s8_q <= sum_58_s7_q;
      sum_67_s8_q <= sum_67_s7_q;
      select_73_s8_q <= select_73;
      sum_80_s8_q <= sum_80_s7_q;
      sum_87_s8_q <= sum_87_s7_q;
      sum_96_s8_q <= sum_96_s7_q;
      sum_103_s8_q <= sum_103_s7_q;
      sum_110_s8_q <= sum_110_s7_q;
      sum_111_s8_q <= sum_111_s7_q;
      sum_114_s8_q <= sum_114_s7_q;
      select_120_s8_q <= select_120;
      select_202_s8_q <= select_202_s7_q;
      less_232_s8_q <= less_232_s7_q;
      and_234_s8_q <= and_234_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:98
  logic [11:0] best;
  assign best = (select_73_s8_q < select_120_s8_q) ? select_73_s8_q : select_120_s8_q;

  logic [1:0] sum_0_s9_q;
  logic [1:0] sum_1_s9_q;
  logic [1:0] sum_2_s9_q;
  logic [1:0] sum_3_s9_q;
  logic [1:0] sum_4_s9_q;
  logic [1:0] sum_5_s9_q;
  logic [1:0] sum_6_s9_q;
  logic [1:0] sum_7_s9_q;
  logic [1:0] sum_8_s9_q;
  logic [1:0] sum_9_s9_q;
  logic [1:0] sum_10_s9_q;
  logic [1:0] sum_11_s9_q;
  logic [1:0] sum_12_s9_q;
  logic [5:0] grey_s9_q;
  logic known_s9_q;
  logic exists_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic [10:0] select_25_s9_q;
  logic [9:0] sum_33_s9_q;
  logic [9:0] sum_37_s9_q;
  logic [9:0] sum_41_s9_q;
  logic [9:0] sum_45_s9_q;
  logic [9:0] sum_58_s9_q;
  logic [9:0] sum_67_s9_q;
  logic [9:0] sum_80_s9_q;
  logic [9:0] sum_87_s9_q;
  logic [9:0] sum_96_s9_q;
  logic [9:0] sum_103_s9_q;
  logic [9:0] sum_110_s9_q;
  logic [9:0] sum_111_s9_q;
  logic [9:0] sum_114_s9_q;
  logic [11:0] best_s9_q;
  logic select_202_s9_q;
  logic less_232_s9_q;
  logic and_234_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      sum_0_s9_q <= sum_0_s8_q;
      sum_1_s9_q <= sum_1_s8_q;
      sum_2_s9_q <= sum_2_s8_q;
      sum_3_s9_q <= sum_3_s8_q;
      sum_4_s9_q <= sum_4_s8_q;
      sum_5_s9_q <= sum_5_s8_q;
      sum_6_s9_q <= sum_6_s8_q;
      sum_7_s9_q <= sum_7_s8_q;
      sum_8_s9_q <= sum_8_s8_q;
      sum_9_s9_q <= sum_9_s8_q;
      sum_10_s9_q <= sum_10_s8_q;
      sum_11_s9_q <= sum_11_s8_q;
      sum_12_s9_q <= sum_12_s8_q;
      grey_s9_q <= grey_s8_q;
      known_s9_q <= known_s8_q;
      exists_s9_q <= exists_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      select_25_s9_q <= select_25_s8_q;
      sum_33_s9_q <= sum_33_s8_q;
      sum_37_s9_q <= sum_37_s8_q;
      sum_41_s9_q <= sum_41_s8_q;
      sum_45_s9_q <= sum_45_s8_q;
      sum_58_s9_q <= sum_58_s8_q;
      sum_67_s9_q <= sum_67_s8_q;
      sum_80_s9_q <= sum_80_s8_q;
      sum_87_s9_q <= sum_87_s8_q;
      sum_96_s9_q <= sum_96_s8_q;
      sum_103_s9_q <= sum_103_s8_q;
      sum_110_s9_q <= sum_110_s8_q;
      sum_111_s9_q <= sum_111_s8_q;
      sum_114_s9_q <= sum_114_s8_q;
      best_s9_q <= best;
      select_202_s9_q <= select_202_s8_q;
      less_232_s9_q <= less_232_s8_q;
      and_234_s9_q <= and_234_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:68
  logic [11:0] difference_123;
  assign difference_123 = {sum_33_s9_q, sum_0_s9_q} - best_s9_q;
  logic [11:0] difference_129;
  assign difference_129 = {sum_114_s9_q, sum_1_s9_q} - best_s9_q;
  logic [11:0] difference_135;
  assign difference_135 = {sum_111_s9_q, sum_2_s9_q} - best_s9_q;
  logic [11:0] difference_141;
  assign difference_141 = {sum_110_s9_q, sum_3_s9_q} - best_s9_q;
  logic [11:0] difference_147;
  assign difference_147 = {sum_103_s9_q, sum_4_s9_q} - best_s9_q;
  logic [11:0] difference_153;
  assign difference_153 = {sum_96_s9_q, sum_5_s9_q} - best_s9_q;
  logic [11:0] difference_159;
  assign difference_159 = {sum_87_s9_q, sum_6_s9_q} - best_s9_q;
  logic [11:0] difference_165;
  assign difference_165 = {sum_80_s9_q, sum_7_s9_q} - best_s9_q;
  logic [11:0] difference_171;
  assign difference_171 = {sum_67_s9_q, sum_8_s9_q} - best_s9_q;
  logic [11:0] difference_177;
  assign difference_177 = {sum_58_s9_q, sum_9_s9_q} - best_s9_q;
  logic [11:0] difference_183;
  assign difference_183 = {sum_45_s9_q, sum_10_s9_q} - best_s9_q;
  logic [11:0] difference_189;
  assign difference_189 = {sum_41_s9_q, sum_11_s9_q} - best_s9_q;
  logic [11:0] difference_195;
  assign difference_195 = {sum_37_s9_q, sum_12_s9_q} - best_s9_q;

  logic [1:0] sum_0_s10_q;
  logic [1:0] sum_1_s10_q;
  logic [1:0] sum_2_s10_q;
  logic [1:0] sum_3_s10_q;
  logic [1:0] sum_4_s10_q;
  logic [1:0] sum_5_s10_q;
  logic [1:0] sum_6_s10_q;
  logic [1:0] sum_7_s10_q;
  logic [1:0] sum_8_s10_q;
  logic [1:0] sum_9_s10_q;
  logic [1:0] sum_10_s10_q;
  logic [1:0] sum_11_s10_q;
  logic [1:0] sum_12_s10_q;
  logic [5:0] grey_s10_q;
  logic known_s10_q;
  logic exists_s10_q;
  logic marks_first_s10_q;
  logic marks_last_s10_q;
  logic [10:0] select_25_s10_q;
  logic [9:0] sum_33_s10_q;
  logic [9:0] sum_37_s10_q;
  logic [9:0] sum_41_s10_q;
  logic [9:0] sum_45_s10_q;
  logic [9:0] sum_58_s10_q;
  logic [9:0] sum_67_s10_q;
  logic [9:0] sum_80_s10_q;
  logic [9:0] sum_87_s10_q;
  logic [9:0] sum_96_s10_q;
  logic [9:0] sum_103_s10_q;
  logic [9:0] sum_110_s10_q;
  logic [9:0] sum_111_s10_q;
  logic [9:0] sum_114_s10_q;
  logic [5:0] select_125_s10_q;
  logic [5:0] select_131_s10_q;
  logic [5:0] select_137_s10_q;
  logic [5:0] select_143_s10_q;
  logic [5:0] select_149_s10_q;
  logic [5:0] select_155_s10_q;
  logic [5:0] select_161_s10_q;
  logic [5:0] select_167_s10_q;
  logic [5:0] select_173_s10_q;
  logic [5:0] select_179_s10_q;
  logic [5:0] select_185_s10_q;
  logic [5:0] select_191_s10_q;
  logic [5:0] select_197_s10_q;
  logic select_202_s10_q;
  logic less_232_s10_q;
  logic and_234_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      sum_0_s10_q <= sum_0_s9_q;
      sum_1_s10_q <= sum_1_s9_q;
      sum_2_s10_q <= sum_2_s9_q;
      sum_3_s10_q <= sum_3_s9_q;
      sum_4_s10_q <= sum_4_s9_q;
      sum_5_s10_q <= sum_5_s9_q;
      sum_6_s10_q <= sum_6_s9_q;
      sum_7_s10_q <= sum_7_s9_q;
      sum_8_s10_q <= sum_8_s9_q;
      sum_9_s10_q <= sum_9_s9_q;
      sum_10_s10_q <= sum_10_s9_q;
      sum_11_s10_q <= sum_11_s9_q;
      sum_12_s10_q <= sum_12_s9_q;
      grey_s10_q <= grey_s9_q;
      known_s10_q <= known_s9_q;
      exists_s10_q <= exists_s9_q;
      marks_first_s10_q <= marks_first_s9_q;
      marks_last_s10_q <= marks_last_s9_q;
      select_25_s10_q <= select_25_s9_q;
      sum_33_s10_q <= sum_33_s9_q;
      sum_37_s10_q <= sum_37_s9_q;
      sum_41_s10_q <= sum_41_s9_q;
      sum_45_s10_q <= sum_45_s9_q;
      sum_58_s10_q <= sum_58_s9_q;
      sum_67_s10_q <= sum_67_s9_q;
      sum_80_s10_q <= sum_80_s9_q;
      sum_87_s10_q <= sum_87_s9_q;
      sum_96_s10_q <= sum_96_s9_q;
      sum_103_s10_q <= sum_103_s9_q;
      sum_110_s10_q <= sum_110_s9_q;
      sum_111_s10_q <= sum_111_s9_q;
      sum_114_s10_q <= sum_114_s9_q;
      select_125_s10_q <= (difference_123[11:8] == 4'h0) ? difference_123[7:2] : 6'h3f;
      select_131_s10_q <= (difference_129[11:8] == 4'h0) ? difference_129[7:2] : 6'h3f;
      select_137_s10_q <= (difference_135[11:8] == 4'h0) ? difference_135[7:2] : 6'h3f;
      select_143_s10_q <= (difference_141[11:8] == 4'h0) ? difference_141[7:2] : 6'h3f;
      select_149_s10_q <= (difference_147[11:8] == 4'h0) ? difference_147[7:2] : 6'h3f;
      select_155_s10_q <= (difference_153[11:8] == 4'h0) ? difference_153[7:2] : 6'h3f;
      select_161_s10_q <= (difference_159[11:8] == 4'h0) ? difference_159[7:2] : 6'h3f;
      select_167_s10_q <= (difference_165[11:8] == 4'h0) ? difference_165[7:2] : 6'h3f;
      select_173_s10_q <= (difference_171[11:8] == 4'h0) ? difference_171[7:2] : 6'h3f;
      select_179_s10_q <= (difference_177[11:8] == 4'h0) ? difference_177[7:2] : 6'h3f;
      select_185_s10_q <= (difference_183[11:8] == 4'h0) ? difference_183[7:2] : 6'h3f;
      select_191_s10_q <= (difference_189[11:8] == 4'h0) ? difference_189[7:2] : 6'h3f;
      select_197_s10_q <= (difference_195[11:8] == 4'h0) ? difference_195[7:2] : 6'h3f;
      select_202_s10_q <= select_202_s9_q;
      less_232_s10_q <= less_232_s9_q;
      and_234_s10_q <= and_234_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/plane_paths.hpp:69
  logic [6:0] sum_126;
  assign sum_126 = {1'b0, select_125_s10_q} + 7'h3;
  logic [6:0] sum_132;
  assign sum_132 = {1'b0, select_131_s10_q} + 7'h3;
  logic [6:0] sum_138;
  assign sum_138 = {1'b0, select_137_s10_q} + 7'h3;
  logic [6:0] sum_144;
  assign sum_144 = {1'b0, select_143_s10_q} + 7'h3;
  logic [6:0] sum_150;
  assign sum_150 = {1'b0, select_149_s10_q} + 7'h3;
  logic [6:0] sum_156;
  assign sum_156 = {1'b0, select_155_s10_q} + 7'h3;
  logic [6:0] sum_162;
  assign sum_162 = {1'b0, select_161_s10_q} + 7'h3;
  logic [6:0] sum_168;
  assign sum_168 = {1'b0, select_167_s10_q} + 7'h3;
  logic [6:0] sum_174;
  assign sum_174 = {1'b0, select_173_s10_q} + 7'h3;
  logic [6:0] sum_180;
  assign sum_180 = {1'b0, select_179_s10_q} + 7'h3;
  logic [6:0] sum_186;
  assign sum_186 = {1'b0, select_185_s10_q} + 7'h3;
  logic [6:0] sum_192;
  assign sum_192 = {1'b0, select_191_s10_q} + 7'h3;
  logic [6:0] sum_198;
  assign sum_198 = {1'b0, select_197_s10_q} + 7'h3;

  logic [1:0] sum_0_s11_q;
  logic [1:0] sum_1_s11_q;
  logic [1:0] sum_2_s11_q;
  logic [1:0] sum_3_s11_q;
  logic [1:0] sum_4_s11_q;
  logic [1:0] sum_5_s11_q;
  logic [1:0] sum_6_s11_q;
  logic [1:0] sum_7_s11_q;
  logic [1:0] sum_8_s11_q;
  logic [1:0] sum_9_s11_q;
  logic [1:0] sum_10_s11_q;
  logic [1:0] sum_11_s11_q;
  logic [1:0] sum_12_s11_q;
  logic [5:0] grey_s11_q;
  logic known_s11_q;
  logic exists_s11_q;
  logic marks_first_s11_q;
  logic marks_last_s11_q;
  logic [10:0] select_25_s11_q;
  logic [9:0] sum_33_s11_q;
  logic [9:0] sum_37_s11_q;
  logic [9:0] sum_41_s11_q;
  logic [9:0] sum_45_s11_q;
  logic [9:0] sum_58_s11_q;
  logic [9:0] sum_67_s11_q;
  logic [9:0] sum_80_s11_q;
  logic [9:0] sum_87_s11_q;
  logic [9:0] sum_96_s11_q;
  logic [9:0] sum_103_s11_q;
  logic [9:0] sum_110_s11_q;
  logic [9:0] sum_111_s11_q;
  logic [9:0] sum_114_s11_q;
  logic [5:0] select_128_s11_q;
  logic [5:0] select_134_s11_q;
  logic [5:0] select_140_s11_q;
  logic [5:0] select_146_s11_q;
  logic [5:0] select_152_s11_q;
  logic [5:0] select_158_s11_q;
  logic [5:0] select_164_s11_q;
  logic [5:0] select_170_s11_q;
  logic [5:0] select_176_s11_q;
  logic [5:0] select_182_s11_q;
  logic [5:0] select_188_s11_q;
  logic [5:0] select_194_s11_q;
  logic [5:0] select_200_s11_q;
  logic select_202_s11_q;
  logic less_232_s11_q;
  logic and_234_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      sum_0_s11_q <= sum_0_s10_q;
      sum_1_s11_q <= sum_1_s10_q;
      sum_2_s11_q <= sum_2_s10_q;
      sum_3_s11_q <= sum_3_s10_q;
      sum_4_s11_q <= sum_4_s10_q;
      sum_5_s11_q <= sum_5_s10_q;
      sum_6_s11_q <= sum_6_s10_q;
      sum_7_s11_q <= sum_7_s10_q;
      sum_8_s11_q <= sum_8_s10_q;
      sum_9_s11_q <= sum_9_s10_q;
      sum_10_s11_q <= sum_10_s10_q;
      sum_11_s11_q <= sum_11_s10_q;
      sum_12_s11_q <= sum_12_s10_q;
      grey_s11_q <= grey_s10_q;
      known_s11_q <= known_s10_q;
      exists_s11_q <= exists_s10_q;
      marks_first_s11_q <= marks_first_s10_q;
      marks_last_s11_q <= marks_last_s10_q;
      select_25_s11_q <= select_25_s10_q;
      sum_33_s11_q <= sum_33_s10_q;
      sum_37_s11_q <= sum_37_s10_q;
      sum_41_s11_q <= sum_41_s10_q;
      sum_45_s11_q <= sum_45_s10_q;
      sum_58_s11_q <= sum_58_s10_q;
      sum_67_s11_q <= sum_67_s10_q;
      sum_80_s11_q <= sum_80_s10_q;
      sum_87_s11_q <= sum_87_s10_q;
      sum_96_s11_q <= sum_96_s10_q;
      sum_103_s11_q <= sum_103_s10_q;
      sum_110_s11_q <= sum_110_s10_q;
      sum_111_s11_q <= sum_111_s10_q;
      sum_114_s11_q <= sum_114_s10_q;
      select_128_s11_q <= known_s10_q ? (select_125_s10_q - {1'b0, sum_126[6:2]}) : 6'h0;
      select_134_s11_q <= known_s10_q ? (select_131_s10_q - {1'b0, sum_132[6:2]}) : 6'h0;
      select_140_s11_q <= known_s10_q ? (select_137_s10_q - {1'b0, sum_138[6:2]}) : 6'h0;
      select_146_s11_q <= known_s10_q ? (select_143_s10_q - {1'b0, sum_144[6:2]}) : 6'h0;
      select_152_s11_q <= known_s10_q ? (select_149_s10_q - {1'b0, sum_150[6:2]}) : 6'h0;
      select_158_s11_q <= known_s10_q ? (select_155_s10_q - {1'b0, sum_156[6:2]}) : 6'h0;
      select_164_s11_q <= known_s10_q ? (select_161_s10_q - {1'b0, sum_162[6:2]}) : 6'h0;
      select_170_s11_q <= known_s10_q ? (select_167_s10_q - {1'b0, sum_168[6:2]}) : 6'h0;
      select_176_s11_q <= known_s10_q ? (select_173_s10_q - {1'b0, sum_174[6:2]}) : 6'h0;
      select_182_s11_q <= known_s10_q ? (select_179_s10_q - {1'b0, sum_180[6:2]}) : 6'h0;
      select_188_s11_q <= known_s10_q ? (select_185_s10_q - {1'b0, sum_186[6:2]}) : 6'h0;
      select_194_s11_q <= known_s10_q ? (select_191_s10_q - {1'b0, sum_192[6:2]}) : 6'h0;
      select_200_s11_q <= known_s10_q ? (select_197_s10_q - {1'b0, sum_198[6:2]}) : 6'h0;
      select_202_s11_q <= select_202_s10_q;
      less_232_s11_q <= less_232_s10_q;
      and_234_s11_q <= and_234_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_25_s11_q;
  logic memory_we;
  assign memory_we = s11_en & select_202_s11_q;
  always_ff @(posedge clk_i) begin
    if (memory_we) memory_mem[memory_waddr] <= {select_200_s11_q, select_194_s11_q, select_188_s11_q, select_182_s11_q, select_176_s11_q, select_170_s11_q, select_164_s11_q, select_158_s11_q, select_152_s11_q, select_146_s11_q, select_140_s11_q, select_134_s11_q, select_128_s11_q};
  end
`ifndef SYNTHESIS
  logic [10:0] memory_raddr_s1_sim;
  logic memory_re_s1_sim;
  logic [10:0] memory_raddr_s2_sim;
  logic memory_re_s2_sim;
  logic [10:0] memory_raddr_s3_sim;
  logic memory_re_s3_sim;
  logic [10:0] memory_raddr_s4_sim;
  logic memory_re_s4_sim;
  logic [10:0] memory_raddr_s5_sim;
  logic memory_re_s5_sim;
  logic [10:0] memory_raddr_s6_sim;
  logic memory_re_s6_sim;
  logic [10:0] memory_raddr_s7_sim;
  logic memory_re_s7_sim;
  logic [10:0] memory_raddr_s8_sim;
  logic memory_re_s8_sim;
  logic [10:0] memory_raddr_s9_sim;
  logic memory_re_s9_sim;
  logic [10:0] memory_raddr_s10_sim;
  logic memory_re_s10_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      memory_re_s1_sim <= 1'b0;
      memory_re_s2_sim <= 1'b0;
      memory_re_s3_sim <= 1'b0;
      memory_re_s4_sim <= 1'b0;
      memory_re_s5_sim <= 1'b0;
      memory_re_s6_sim <= 1'b0;
      memory_re_s7_sim <= 1'b0;
      memory_re_s8_sim <= 1'b0;
      memory_re_s9_sim <= 1'b0;
      memory_re_s10_sim <= 1'b0;
    end else if (en_i) begin
      memory_re_s1_sim <= memory_re;
      memory_raddr_s1_sim <= memory_raddr;
      memory_re_s2_sim <= memory_re_s1_sim;
      memory_raddr_s2_sim <= memory_raddr_s1_sim;
      memory_re_s3_sim <= memory_re_s2_sim;
      memory_raddr_s3_sim <= memory_raddr_s2_sim;
      memory_re_s4_sim <= memory_re_s3_sim;
      memory_raddr_s4_sim <= memory_raddr_s3_sim;
      memory_re_s5_sim <= memory_re_s4_sim;
      memory_raddr_s5_sim <= memory_raddr_s4_sim;
      memory_re_s6_sim <= memory_re_s5_sim;
      memory_raddr_s6_sim <= memory_raddr_s5_sim;
      memory_re_s7_sim <= memory_re_s6_sim;
      memory_raddr_s7_sim <= memory_raddr_s6_sim;
      memory_re_s8_sim <= memory_re_s7_sim;
      memory_raddr_s8_sim <= memory_raddr_s7_sim;
      memory_re_s9_sim <= memory_re_s8_sim;
      memory_raddr_s9_sim <= memory_raddr_s8_sim;
      memory_re_s10_sim <= memory_re_s9_sim;
      memory_raddr_s10_sim <= memory_raddr_s9_sim;
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
      if (memory_re_s3_sim && memory_raddr_s3_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s4_sim && memory_raddr_s4_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s5_sim && memory_raddr_s5_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s6_sim && memory_raddr_s6_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s7_sim && memory_raddr_s7_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s8_sim && memory_raddr_s8_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s9_sim && memory_raddr_s9_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s10_sim && memory_raddr_s10_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_waddr >= 11'd1920) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 11'd1920) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  logic [1:0] sum_0_s12_q;
  logic [1:0] sum_1_s12_q;
  logic [1:0] sum_2_s12_q;
  logic [1:0] sum_3_s12_q;
  logic [1:0] sum_4_s12_q;
  logic [1:0] sum_5_s12_q;
  logic [1:0] sum_6_s12_q;
  logic [1:0] sum_7_s12_q;
  logic [1:0] sum_8_s12_q;
  logic [1:0] sum_9_s12_q;
  logic [1:0] sum_10_s12_q;
  logic [1:0] sum_11_s12_q;
  logic [1:0] sum_12_s12_q;
  logic [5:0] grey_s12_q;
  logic known_s12_q;
  logic exists_s12_q;
  logic marks_first_s12_q;
  logic marks_last_s12_q;
  logic [9:0] sum_33_s12_q;
  logic [9:0] sum_37_s12_q;
  logic [9:0] sum_41_s12_q;
  logic [9:0] sum_45_s12_q;
  logic [9:0] sum_58_s12_q;
  logic [9:0] sum_67_s12_q;
  logic [9:0] sum_80_s12_q;
  logic [9:0] sum_87_s12_q;
  logic [9:0] sum_96_s12_q;
  logic [9:0] sum_103_s12_q;
  logic [9:0] sum_110_s12_q;
  logic [9:0] sum_111_s12_q;
  logic [9:0] sum_114_s12_q;
  logic less_232_s12_q;
  logic and_234_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
      sum_0_s12_q <= sum_0_s11_q;
      sum_1_s12_q <= sum_1_s11_q;
      sum_2_s12_q <= sum_2_s11_q;
      sum_3_s12_q <= sum_3_s11_q;
      sum_4_s12_q <= sum_4_s11_q;
      sum_5_s12_q <= sum_5_s11_q;
      sum_6_s12_q <= sum_6_s11_q;
      sum_7_s12_q <= sum_7_s11_q;
      sum_8_s12_q <= sum_8_s11_q;
      sum_9_s12_q <= sum_9_s11_q;
      sum_10_s12_q <= sum_10_s11_q;
      sum_11_s12_q <= sum_11_s11_q;
      sum_12_s12_q <= sum_12_s11_q;
      grey_s12_q <= grey_s11_q;
      known_s12_q <= known_s11_q;
      exists_s12_q <= exists_s11_q;
      marks_first_s12_q <= marks_first_s11_q;
      marks_last_s12_q <= marks_last_s11_q;
      sum_33_s12_q <= sum_33_s11_q;
      sum_37_s12_q <= sum_37_s11_q;
      sum_41_s12_q <= sum_41_s11_q;
      sum_45_s12_q <= sum_45_s11_q;
      sum_58_s12_q <= sum_58_s11_q;
      sum_67_s12_q <= sum_67_s11_q;
      sum_80_s12_q <= sum_80_s11_q;
      sum_87_s12_q <= sum_87_s11_q;
      sum_96_s12_q <= sum_96_s11_q;
      sum_103_s12_q <= sum_103_s11_q;
      sum_110_s12_q <= sum_110_s11_q;
      sum_111_s12_q <= sum_111_s11_q;
      sum_114_s12_q <= sum_114_s11_q;
      less_232_s12_q <= less_232_s11_q;
      and_234_s12_q <= and_234_s11_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign cost_0_o = {sum_33_s12_q, sum_0_s12_q};
  assign cost_1_o = {sum_114_s12_q, sum_1_s12_q};
  assign cost_2_o = {sum_111_s12_q, sum_2_s12_q};
  assign cost_3_o = {sum_110_s12_q, sum_3_s12_q};
  assign cost_4_o = {sum_103_s12_q, sum_4_s12_q};
  assign cost_5_o = {sum_96_s12_q, sum_5_s12_q};
  assign cost_6_o = {sum_87_s12_q, sum_6_s12_q};
  assign cost_7_o = {sum_80_s12_q, sum_7_s12_q};
  assign cost_8_o = {sum_67_s12_q, sum_8_s12_q};
  assign cost_9_o = {sum_58_s12_q, sum_9_s12_q};
  assign cost_10_o = {sum_45_s12_q, sum_10_s12_q};
  assign cost_11_o = {sum_41_s12_q, sum_11_s12_q};
  assign cost_12_o = {sum_37_s12_q, sum_12_s12_q};
  assign grey_o = grey_s12_q;
  assign known_o = known_s12_q;
  assign evident_o = and_234_s12_q;
  assign strong_v_o = less_232_s12_q;
  assign exists_o = exists_s12_q;
  assign marks_first_o = marks_first_s12_q;
  assign marks_last_o = marks_last_s12_q;
  assign valid_o = valid_s12_q;

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
      valid_s12_q <= 1'b0;
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
      valid_s11_q <= valid_s10_q;
      valid_s12_q <= valid_s11_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_198[1:0], difference_195[1:0], sum_192[1:0], difference_189[1:0], sum_186[1:0], difference_183[1:0], sum_180[1:0], difference_177[1:0], sum_174[1:0], difference_171[1:0], sum_168[1:0], difference_165[1:0], sum_162[1:0], difference_159[1:0], sum_156[1:0], difference_153[1:0], sum_150[1:0], difference_147[1:0], sum_144[1:0], difference_141[1:0], sum_138[1:0], difference_135[1:0], sum_132[1:0], difference_129[1:0], sum_126[1:0], difference_123[1:0]};

endmodule
