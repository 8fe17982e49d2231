// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contest<horopter::hls::profiles::vga>, hls/stages/contest.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1037 bits, pipeline 47 bits, memories 0 bits.
module horopter_contest (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [11:0] cost_0_i,
  input  logic [11:0] cost_1_i,
  input  logic [11:0] cost_2_i,
  input  logic [11:0] cost_3_i,
  input  logic [11:0] cost_4_i,
  input  logic [11:0] cost_5_i,
  input  logic [11:0] cost_6_i,
  input  logic [11:0] cost_7_i,
  input  logic [11:0] cost_8_i,
  input  logic [11:0] cost_9_i,
  input  logic [11:0] cost_10_i,
  input  logic [11:0] cost_11_i,
  input  logic [11:0] cost_12_i,
  input  logic [11:0] cost_13_i,
  input  logic [11:0] cost_14_i,
  input  logic [11:0] cost_15_i,
  input  logic [11:0] cost_16_i,
  input  logic [11:0] cost_17_i,
  input  logic [11:0] cost_18_i,
  input  logic [5:0] grey_i,
  input  logic known_i,
  input  logic evident_i,
  input  logic strong_v_i,
  input  logic exists_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [3:0] cfg_bias_i,
  input  logic [3:0] cfg_boundary_i,
  output logic valid_o,
  output logic signed [6:0] vote_o,
  output logic firm_o,
  output logic [5:0] grey_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Of the configuration alone: not pipelined.
  logic [3:0] rest;
  assign rest = (cfg_boundary_i == 4'hf) ? 4'h0 : (4'he - cfg_boundary_i);

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic row_ended_q;
  logic [4:0] columns_q;
  logic [11:0] outside_values_0_q;
  logic [11:0] outside_values_1_q;
  logic [11:0] outside_values_2_q;
  logic [11:0] outside_values_3_q;
  logic [11:0] outside_values_4_q;
  logic [11:0] outside_values_5_q;
  logic [11:0] outside_values_6_q;
  logic [11:0] outside_values_7_q;
  logic [11:0] outside_values_8_q;
  logic [11:0] outside_values_9_q;
  logic [11:0] outside_values_10_q;
  logic [11:0] outside_values_11_q;
  logic [11:0] outside_values_12_q;
  logic [11:0] outside_values_13_q;
  logic [11:0] outside_values_14_q;
  logic [11:0] outside_values_15_q;
  logic [11:0] outside_values_16_q;
  logic [11:0] outside_values_17_q;
  logic [11:0] outside_values_18_q;
  logic [11:0] outside_values_19_q;
  logic [11:0] outside_values_20_q;
  logic [11:0] outside_values_21_q;
  logic [11:0] outside_values_22_q;
  logic [11:0] outside_values_23_q;
  logic [11:0] outside_values_24_q;
  logic [11:0] inside_next_q;
  logic [11:0] inside_here_q;
  logic [11:0] seen_values_0_inside_q;
  logic seen_values_0_hidden_q;
  logic [11:0] seen_values_1_inside_q;
  logic seen_values_1_hidden_q;
  logic [11:0] seen_values_2_inside_q;
  logic seen_values_2_hidden_q;
  logic [11:0] seen_values_3_inside_q;
  logic seen_values_3_hidden_q;
  logic [11:0] seen_values_4_inside_q;
  logic seen_values_4_hidden_q;
  logic [11:0] seen_values_5_inside_q;
  logic seen_values_5_hidden_q;
  logic [11:0] seen_values_6_inside_q;
  logic seen_values_6_hidden_q;
  logic [11:0] seen_values_7_inside_q;
  logic seen_values_7_hidden_q;
  logic [11:0] seen_values_8_inside_q;
  logic seen_values_8_hidden_q;
  logic [11:0] seen_values_9_inside_q;
  logic seen_values_9_hidden_q;
  logic [11:0] seen_values_10_inside_q;
  logic seen_values_10_hidden_q;
  logic [11:0] seen_values_11_inside_q;
  logic seen_values_11_hidden_q;
  logic [11:0] seen_values_12_inside_q;
  logic seen_values_12_hidden_q;
  logic [11:0] seen_values_13_inside_q;
  logic seen_values_13_hidden_q;
  logic [11:0] seen_values_14_inside_q;
  logic seen_values_14_hidden_q;
  logic [11:0] seen_values_15_inside_q;
  logic seen_values_15_hidden_q;
  logic [11:0] seen_values_16_inside_q;
  logic seen_values_16_hidden_q;
  logic [11:0] seen_values_17_inside_q;
  logic seen_values_17_hidden_q;
  logic [11:0] seen_values_18_inside_q;
  logic seen_values_18_hidden_q;
  logic [11:0] seen_values_19_inside_q;
  logic seen_values_19_hidden_q;
  logic [11:0] seen_values_20_inside_q;
  logic seen_values_20_hidden_q;
  logic [11:0] seen_values_21_inside_q;
  logic seen_values_21_hidden_q;
  logic [11:0] seen_values_22_inside_q;
  logic seen_values_22_hidden_q;
  logic centres_values_0_votes_q;
  logic [5:0] centres_values_0_grey_q;
  logic centres_values_0_exists_q;
  logic centres_values_0_marks_first_q;
  logic centres_values_0_marks_last_q;
  logic centres_values_1_votes_q;
  logic [5:0] centres_values_1_grey_q;
  logic centres_values_1_exists_q;
  logic centres_values_1_marks_first_q;
  logic centres_values_1_marks_last_q;
  logic centres_values_2_votes_q;
  logic [5:0] centres_values_2_grey_q;
  logic centres_values_2_exists_q;
  logic centres_values_2_marks_first_q;
  logic centres_values_2_marks_last_q;
  logic centres_values_3_votes_q;
  logic [5:0] centres_values_3_grey_q;
  logic centres_values_3_exists_q;
  logic centres_values_3_marks_first_q;
  logic centres_values_3_marks_last_q;
  logic centres_values_4_votes_q;
  logic [5:0] centres_values_4_grey_q;
  logic centres_values_4_exists_q;
  logic centres_values_4_marks_first_q;
  logic centres_values_4_marks_last_q;
  logic centres_values_5_votes_q;
  logic [5:0] centres_values_5_grey_q;
  logic centres_values_5_exists_q;
  logic centres_values_5_marks_first_q;
  logic centres_values_5_marks_last_q;
  logic centres_values_6_votes_q;
  logic [5:0] centres_values_6_grey_q;
  logic centres_values_6_exists_q;
  logic centres_values_6_marks_first_q;
  logic centres_values_6_marks_last_q;
  logic centres_values_7_votes_q;
  logic [5:0] centres_values_7_grey_q;
  logic centres_values_7_exists_q;
  logic centres_values_7_marks_first_q;
  logic centres_values_7_marks_last_q;
  logic centres_values_8_votes_q;
  logic [5:0] centres_values_8_grey_q;
  logic centres_values_8_exists_q;
  logic centres_values_8_marks_first_q;
  logic centres_values_8_marks_last_q;
  logic centres_values_9_votes_q;
  logic [5:0] centres_values_9_grey_q;
  logic centres_values_9_exists_q;
  logic centres_values_9_marks_first_q;
  logic centres_values_9_marks_last_q;
  logic centres_values_10_votes_q;
  logic [5:0] centres_values_10_grey_q;
  logic centres_values_10_exists_q;
  logic centres_values_10_marks_first_q;
  logic centres_values_10_marks_last_q;
  logic centres_values_11_votes_q;
  logic [5:0] centres_values_11_grey_q;
  logic centres_values_11_exists_q;
  logic centres_values_11_marks_first_q;
  logic centres_values_11_marks_last_q;
  logic centres_values_12_votes_q;
  logic [5:0] centres_values_12_grey_q;
  logic centres_values_12_exists_q;
  logic centres_values_12_marks_first_q;
  logic centres_values_12_marks_last_q;
  logic centres_values_13_votes_q;
  logic [5:0] centres_values_13_grey_q;
  logic centres_values_13_exists_q;
  logic centres_values_13_marks_first_q;
  logic centres_values_13_marks_last_q;
  logic centres_values_14_votes_q;
  logic [5:0] centres_values_14_grey_q;
  logic centres_values_14_exists_q;
  logic centres_values_14_marks_first_q;
  logic centres_values_14_marks_last_q;
  logic centres_values_15_votes_q;
  logic [5:0] centres_values_15_grey_q;
  logic centres_values_15_exists_q;
  logic centres_values_15_marks_first_q;
  logic centres_values_15_marks_last_q;
  logic centres_values_16_votes_q;
  logic [5:0] centres_values_16_grey_q;
  logic centres_values_16_exists_q;
  logic centres_values_16_marks_first_q;
  logic centres_values_16_marks_last_q;
  logic centres_values_17_votes_q;
  logic [5:0] centres_values_17_grey_q;
  logic centres_values_17_exists_q;
  logic centres_values_17_marks_first_q;
  logic centres_values_17_marks_last_q;
  logic centres_values_18_votes_q;
  logic [5:0] centres_values_18_grey_q;
  logic centres_values_18_exists_q;
  logic centres_values_18_marks_first_q;
  logic centres_values_18_marks_last_q;
  logic centres_values_19_votes_q;
  logic [5:0] centres_values_19_grey_q;
  logic centres_values_19_exists_q;
  logic centres_values_19_marks_first_q;
  logic centres_values_19_marks_last_q;
  logic centres_values_20_votes_q;
  logic [5:0] centres_values_20_grey_q;
  logic centres_values_20_exists_q;
  logic centres_values_20_marks_first_q;
  logic centres_values_20_marks_last_q;
  logic centres_values_21_votes_q;
  logic [5:0] centres_values_21_grey_q;
  logic centres_values_21_exists_q;
  logic centres_values_21_marks_first_q;
  logic centres_values_21_marks_last_q;
  logic centres_values_22_votes_q;
  logic [5:0] centres_values_22_grey_q;
  logic centres_values_22_exists_q;
  logic centres_values_22_marks_first_q;
  logic centres_values_22_marks_last_q;
  logic centres_values_23_votes_q;
  logic [5:0] centres_values_23_grey_q;
  logic centres_values_23_exists_q;
  logic centres_values_23_marks_first_q;
  logic centres_values_23_marks_last_q;
  // hls/stages/contest.hpp:56
  logic or_272;
  assign or_272 = marks_first_i | row_ended_q;
  // hls/stages/contest.hpp:128
  logic [4:0] select_273;
  assign select_273 = or_272 ? 5'h0 : columns_q;
  // hls/stages/contest.hpp:143
  logic not_275;
  assign not_275 = ~(select_273 == 5'h18);
  // hls/stages/contest.hpp:128
  logic [11:0] select_283;
  assign select_283 = known_i ? cost_1_i : 12'hfff;
  logic [11:0] select_284;
  assign select_284 = or_272 ? 12'hfff : outside_values_5_q;
  logic [11:0] select_291;
  assign select_291 = known_i ? cost_2_i : 12'hfff;
  logic [11:0] select_292;
  assign select_292 = or_272 ? 12'hfff : outside_values_10_q;
  logic [11:0] select_298;
  assign select_298 = known_i ? cost_3_i : 12'hfff;
  logic [11:0] select_299;
  assign select_299 = or_272 ? 12'hfff : outside_values_14_q;
  logic [11:0] select_304;
  assign select_304 = known_i ? cost_4_i : 12'hfff;
  logic [11:0] select_305;
  assign select_305 = or_272 ? 12'hfff : outside_values_17_q;
  logic [11:0] select_309;
  assign select_309 = known_i ? cost_5_i : 12'hfff;
  logic [11:0] select_310;
  assign select_310 = or_272 ? 12'hfff : outside_values_19_q;
  logic [11:0] select_313;
  assign select_313 = known_i ? cost_6_i : 12'hfff;
  logic [11:0] select_314;
  assign select_314 = or_272 ? 12'hfff : outside_values_20_q;
  logic [11:0] select_317;
  assign select_317 = known_i ? cost_7_i : 12'hfff;
  logic [11:0] select_318;
  assign select_318 = or_272 ? 12'hfff : outside_values_21_q;
  logic [11:0] select_324;
  assign select_324 = known_i ? cost_9_i : 12'hfff;
  logic [11:0] select_325;
  assign select_325 = or_272 ? 12'hfff : inside_next_q;
  logic [11:0] select_331;
  assign select_331 = (known_i & (~(select_273 == 5'h0))) ? cost_10_i : 12'hfff;
  // hls/stages/contest.hpp:134
  logic [11:0] select_333;
  assign select_333 = (select_331 < inside_here_q) ? select_331 : inside_here_q;
  // hls/stages/contest.hpp:128
  logic [11:0] select_337;
  assign select_337 = known_i ? ((select_273[4:1] == 4'h0) ? 12'hfff : cost_11_i) : 12'hfff;
  // hls/stages/contest.hpp:141
  logic less_343;
  assign less_343 = (known_i ? ((select_273 < 5'h3) ? 12'hfff : cost_12_i) : 12'hfff) < seen_values_1_inside_q;
  // hls/stages/contest.hpp:128
  logic [11:0] select_347;
  assign select_347 = known_i ? ((select_273[4:2] == 3'h0) ? 12'hfff : cost_13_i) : 12'hfff;
  logic [11:0] select_352;
  assign select_352 = known_i ? ((select_273[4:1] < 4'h3) ? 12'hfff : cost_14_i) : 12'hfff;
  // hls/stages/contest.hpp:141
  logic less_358;
  assign less_358 = (known_i ? ((select_273 < 5'h9) ? 12'hfff : cost_15_i) : 12'hfff) < seen_values_7_inside_q;
  logic less_363;
  assign less_363 = (known_i ? ((select_273 < 5'hd) ? 12'hfff : cost_16_i) : 12'hfff) < seen_values_11_inside_q;
  // hls/stages/contest.hpp:128
  logic [11:0] select_367;
  assign select_367 = known_i ? ((select_273[4:1] < 4'h9) ? 12'hfff : cost_17_i) : 12'hfff;
  // hls/stages/contest.hpp:95
  logic less_370;
  assign less_370 = cost_10_i < cost_8_i;
  logic [11:0] beside;
  assign beside = less_370 ? cost_10_i : cost_8_i;
  // hls/stages/contest.hpp:96
  logic less_372;
  assign less_372 = beside < cost_9_i;
  // hls/stages/contest.hpp:97
  logic [11:0] outer;
  assign outer = less_370 ? cost_11_i : cost_7_i;
  // hls/stages/contest.hpp:155
  logic [12:0] value;
  assign value = {1'b0, outer} - {1'b0, beside};
  // hls/stages/contest.hpp:161
  logic [11:0] select_375;
  assign select_375 = cfg_boundary_i[0] ? value[12:1] : 12'h0;
  logic [12:0] select_376;
  assign select_376 = cfg_boundary_i[1] ? value : 13'h0;
  logic [13:0] sum_377;
  assign sum_377 = {{2{select_375[11]}}, select_375} + {select_376[12], select_376};
  // hls/stages/contest.hpp:162
  logic [12:0] select_378;
  assign select_378 = cfg_boundary_i[2] ? value : 13'h0;
  logic [12:0] select_379;
  assign select_379 = cfg_boundary_i[3] ? value : 13'h0;
  logic [13:0] sum_380;
  assign sum_380 = {{2{select_378[12]}}, select_378[12:1]} + {select_379[12], select_379};
  // hls/stages/contest.hpp:163
  logic [15:0] sum_381;
  assign sum_381 = {{3{sum_377[13]}}, sum_377[13:1]} + {sum_380[13], sum_380, select_378[0]};
  // hls/stages/contest.hpp:155
  logic [12:0] value_2;
  assign value_2 = {1'b0, beside} - {1'b0, cost_9_i};
  // hls/stages/contest.hpp:161
  logic [11:0] select_386;
  assign select_386 = rest[0] ? value_2[12:1] : 12'h0;
  logic [12:0] select_387;
  assign select_387 = rest[1] ? value_2 : 13'h0;
  logic [13:0] sum_388;
  assign sum_388 = {{2{select_386[11]}}, select_386} + {select_387[12], select_387};
  // hls/stages/contest.hpp:162
  logic [12:0] select_389;
  assign select_389 = rest[2] ? value_2 : 13'h0;
  logic [12:0] select_390;
  assign select_390 = rest[3] ? value_2 : 13'h0;
  logic [13:0] sum_391;
  assign sum_391 = {{2{select_389[12]}}, select_389[12:1]} + {select_390[12], select_390};
  // hls/stages/contest.hpp:163
  logic [15:0] sum_392;
  assign sum_392 = {{3{sum_388[13]}}, sum_388[13:1]} + {sum_391[13], sum_391, select_389[0]};
  // hls/stages/contest.hpp:155
  logic [15:0] b;
  assign b = {sum_381[15], sum_381[15:1]} + {sum_392[15], sum_392[15:1]};
  // hls/stages/contest.hpp:94
  logic [11:0] select_395;
  assign select_395 = (cost_11_i < cost_7_i) ? cost_11_i : cost_7_i;
  // hls/stages/contest.hpp:171
  logic [11:0] select_397;
  assign select_397 = (cost_17_i < cost_16_i) ? cost_17_i : cost_16_i;
  logic [11:0] select_399;
  assign select_399 = (cost_18_i < select_397) ? cost_18_i : select_397;
  logic [11:0] select_401;
  assign select_401 = (cost_15_i < cost_14_i) ? cost_15_i : cost_14_i;
  logic [11:0] select_403;
  assign select_403 = (cost_13_i < cost_12_i) ? cost_13_i : cost_12_i;
  logic [11:0] select_405;
  assign select_405 = (select_401 < select_403) ? select_401 : select_403;
  logic [11:0] select_407;
  assign select_407 = (select_399 < select_405) ? select_399 : select_405;
  logic [11:0] select_409;
  assign select_409 = (cost_5_i < cost_4_i) ? cost_5_i : cost_4_i;
  logic [11:0] select_411;
  assign select_411 = (cost_6_i < select_409) ? cost_6_i : select_409;
  logic [11:0] select_413;
  assign select_413 = (cost_3_i < cost_2_i) ? cost_3_i : cost_2_i;
  logic [11:0] select_415;
  assign select_415 = (cost_1_i < cost_0_i) ? cost_1_i : cost_0_i;
  logic [11:0] select_417;
  assign select_417 = (select_413 < select_415) ? select_413 : select_415;
  logic [11:0] select_419;
  assign select_419 = (select_411 < select_417) ? select_411 : select_417;
  // hls/stages/contest.hpp:93
  logic [11:0] far;
  assign far = (select_407 < select_419) ? select_407 : select_419;
  // hls/stages/contest.hpp:94
  logic [11:0] outside;
  assign outside = (select_395 < far) ? select_395 : far;
  // hls/stages/contest.hpp:96
  logic [11:0] inside_v;
  assign inside_v = less_372 ? beside : cost_9_i;
  // hls/stages/contest.hpp:99
  logic [12:0] z;
  assign z = {1'b0, outside} - {1'b0, inside_v};
  // hls/stages/contest.hpp:100
  logic [15:0] z_2;
  assign z_2 = less_372 ? (($signed(b) < $signed({{3{z[12]}}, z})) ? b : {{3{z[12]}}, z}) : {{3{z[12]}}, z};
  // hls/stages/contest.hpp:101
  logic or_437;
  assign or_437 = (outside < inside_v) | (~({1'b0, far} < ({1'b0, inside_v} + {5'h0, inside_v[11:4]})));
  // hls/stages/contest.hpp:128
  logic [11:0] select_443;
  assign select_443 = known_i ? ((select_273[4:3] == 2'h3) ? cost_18_i : 12'hfff) : 12'hfff;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_ended_q <= 1'b1;
      columns_q <= 5'h0;
      outside_values_0_q <= 12'h0;
      outside_values_1_q <= 12'h0;
      outside_values_2_q <= 12'h0;
      outside_values_3_q <= 12'h0;
      outside_values_4_q <= 12'h0;
      outside_values_5_q <= 12'h0;
      outside_values_6_q <= 12'h0;
      outside_values_7_q <= 12'h0;
      outside_values_8_q <= 12'h0;
      outside_values_9_q <= 12'h0;
      outside_values_10_q <= 12'h0;
      outside_values_11_q <= 12'h0;
      outside_values_12_q <= 12'h0;
      outside_values_13_q <= 12'h0;
      outside_values_14_q <= 12'h0;
      outside_values_15_q <= 12'h0;
      outside_values_16_q <= 12'h0;
      outside_values_17_q <= 12'h0;
      outside_values_18_q <= 12'h0;
      outside_values_19_q <= 12'h0;
      outside_values_20_q <= 12'h0;
      outside_values_21_q <= 12'h0;
      outside_values_22_q <= 12'h0;
      outside_values_23_q <= 12'h0;
      outside_values_24_q <= 12'h0;
      inside_next_q <= 12'h0;
      inside_here_q <= 12'h0;
      seen_values_0_inside_q <= 12'h0;
      seen_values_0_hidden_q <= 1'b0;
      seen_values_1_inside_q <= 12'h0;
      seen_values_1_hidden_q <= 1'b0;
      seen_values_2_inside_q <= 12'h0;
      seen_values_2_hidden_q <= 1'b0;
      seen_values_3_inside_q <= 12'h0;
      seen_values_3_hidden_q <= 1'b0;
      seen_values_4_inside_q <= 12'h0;
      seen_values_4_hidden_q <= 1'b0;
      seen_values_5_inside_q <= 12'h0;
      seen_values_5_hidden_q <= 1'b0;
      seen_values_6_inside_q <= 12'h0;
      seen_values_6_hidden_q <= 1'b0;
      seen_values_7_inside_q <= 12'h0;
      seen_values_7_hidden_q <= 1'b0;
      seen_values_8_inside_q <= 12'h0;
      seen_values_8_hidden_q <= 1'b0;
      seen_values_9_inside_q <= 12'h0;
      seen_values_9_hidden_q <= 1'b0;
      seen_values_10_inside_q <= 12'h0;
      seen_values_10_hidden_q <= 1'b0;
      seen_values_11_inside_q <= 12'h0;
      seen_values_11_hidden_q <= 1'b0;
      seen_values_12_inside_q <= 12'h0;
      seen_values_12_hidden_q <= 1'b0;
      seen_values_13_inside_q <= 12'h0;
      seen_values_13_hidden_q <= 1'b0;
      seen_values_14_inside_q <= 12'h0;
      seen_values_14_hidden_q <= 1'b0;
      seen_values_15_inside_q <= 12'h0;
      seen_values_15_hidden_q <= 1'b0;
      seen_values_16_inside_q <= 12'h0;
      seen_values_16_hidden_q <= 1'b0;
      seen_values_17_inside_q <= 12'h0;
      seen_values_17_hidden_q <= 1'b0;
      seen_values_18_inside_q <= 12'h0;
      seen_values_18_hidden_q <= 1'b0;
      seen_values_19_inside_q <= 12'h0;
      seen_values_19_hidden_q <= 1'b0;
      seen_values_20_inside_q <= 12'h0;
      seen_values_20_hidden_q <= 1'b0;
      seen_values_21_inside_q <= 12'h0;
      seen_values_21_hidden_q <= 1'b0;
      seen_values_22_inside_q <= 12'h0;
      seen_values_22_hidden_q <= 1'b0;
      centres_values_0_votes_q <= 1'b0;
      centres_values_0_grey_q <= 6'h0;
      centres_values_0_exists_q <= 1'b0;
      centres_values_0_marks_first_q <= 1'b0;
      centres_values_0_marks_last_q <= 1'b0;
      centres_values_1_votes_q <= 1'b0;
      centres_values_1_grey_q <= 6'h0;
      centres_values_1_exists_q <= 1'b0;
      centres_values_1_marks_first_q <= 1'b0;
      centres_values_1_marks_last_q <= 1'b0;
      centres_values_2_votes_q <= 1'b0;
      centres_values_2_grey_q <= 6'h0;
      centres_values_2_exists_q <= 1'b0;
      centres_values_2_marks_first_q <= 1'b0;
      centres_values_2_marks_last_q <= 1'b0;
      centres_values_3_votes_q <= 1'b0;
      centres_values_3_grey_q <= 6'h0;
      centres_values_3_exists_q <= 1'b0;
      centres_values_3_marks_first_q <= 1'b0;
      centres_values_3_marks_last_q <= 1'b0;
      centres_values_4_votes_q <= 1'b0;
      centres_values_4_grey_q <= 6'h0;
      centres_values_4_exists_q <= 1'b0;
      centres_values_4_marks_first_q <= 1'b0;
      centres_values_4_marks_last_q <= 1'b0;
      centres_values_5_votes_q <= 1'b0;
      centres_values_5_grey_q <= 6'h0;
      centres_values_5_exists_q <= 1'b0;
      centres_values_5_marks_first_q <= 1'b0;
      centres_values_5_marks_last_q <= 1'b0;
      centres_values_6_votes_q <= 1'b0;
      centres_values_6_grey_q <= 6'h0;
      centres_values_6_exists_q <= 1'b0;
      centres_values_6_marks_first_q <= 1'b0;
      centres_values_6_marks_last_q <= 1'b0;
      centres_values_7_votes_q <= 1'b0;
      centres_values_7_grey_q <= 6'h0;
      centres_values_7_exists_q <= 1'b0;
      centres_values_7_marks_first_q <= 1'b0;
      centres_values_7_marks_last_q <= 1'b0;
      centres_values_8_votes_q <= 1'b0;
      centres_values_8_grey_q <= 6'h0;
      centres_values_8_exists_q <= 1'b0;
      centres_values_8_marks_first_q <= 1'b0;
      centres_values_8_marks_last_q <= 1'b0;
      centres_values_9_votes_q <= 1'b0;
      centres_values_9_grey_q <= 6'h0;
      centres_values_9_exists_q <= 1'b0;
      centres_values_9_marks_first_q <= 1'b0;
      centres_values_9_marks_last_q <= 1'b0;
      centres_values_10_votes_q <= 1'b0;
      centres_values_10_grey_q <= 6'h0;
      centres_values_10_exists_q <= 1'b0;
      centres_values_10_marks_first_q <= 1'b0;
      centres_values_10_marks_last_q <= 1'b0;
      centres_values_11_votes_q <= 1'b0;
      centres_values_11_grey_q <= 6'h0;
      centres_values_11_exists_q <= 1'b0;
      centres_values_11_marks_first_q <= 1'b0;
      centres_values_11_marks_last_q <= 1'b0;
      centres_values_12_votes_q <= 1'b0;
      centres_values_12_grey_q <= 6'h0;
      centres_values_12_exists_q <= 1'b0;
      centres_values_12_marks_first_q <= 1'b0;
      centres_values_12_marks_last_q <= 1'b0;
      centres_values_13_votes_q <= 1'b0;
      centres_values_13_grey_q <= 6'h0;
      centres_values_13_exists_q <= 1'b0;
      centres_values_13_marks_first_q <= 1'b0;
      centres_values_13_marks_last_q <= 1'b0;
      centres_values_14_votes_q <= 1'b0;
      centres_values_14_grey_q <= 6'h0;
      centres_values_14_exists_q <= 1'b0;
      centres_values_14_marks_first_q <= 1'b0;
      centres_values_14_marks_last_q <= 1'b0;
      centres_values_15_votes_q <= 1'b0;
      centres_values_15_grey_q <= 6'h0;
      centres_values_15_exists_q <= 1'b0;
      centres_values_15_marks_first_q <= 1'b0;
      centres_values_15_marks_last_q <= 1'b0;
      centres_values_16_votes_q <= 1'b0;
      centres_values_16_grey_q <= 6'h0;
      centres_values_16_exists_q <= 1'b0;
      centres_values_16_marks_first_q <= 1'b0;
      centres_values_16_marks_last_q <= 1'b0;
      centres_values_17_votes_q <= 1'b0;
      centres_values_17_grey_q <= 6'h0;
      centres_values_17_exists_q <= 1'b0;
      centres_values_17_marks_first_q <= 1'b0;
      centres_values_17_marks_last_q <= 1'b0;
      centres_values_18_votes_q <= 1'b0;
      centres_values_18_grey_q <= 6'h0;
      centres_values_18_exists_q <= 1'b0;
      centres_values_18_marks_first_q <= 1'b0;
      centres_values_18_marks_last_q <= 1'b0;
      centres_values_19_votes_q <= 1'b0;
      centres_values_19_grey_q <= 6'h0;
      centres_values_19_exists_q <= 1'b0;
      centres_values_19_marks_first_q <= 1'b0;
      centres_values_19_marks_last_q <= 1'b0;
      centres_values_20_votes_q <= 1'b0;
      centres_values_20_grey_q <= 6'h0;
      centres_values_20_exists_q <= 1'b0;
      centres_values_20_marks_first_q <= 1'b0;
      centres_values_20_marks_last_q <= 1'b0;
      centres_values_21_votes_q <= 1'b0;
      centres_values_21_grey_q <= 6'h0;
      centres_values_21_exists_q <= 1'b0;
      centres_values_21_marks_first_q <= 1'b0;
      centres_values_21_marks_last_q <= 1'b0;
      centres_values_22_votes_q <= 1'b0;
      centres_values_22_grey_q <= 6'h0;
      centres_values_22_exists_q <= 1'b0;
      centres_values_22_marks_first_q <= 1'b0;
      centres_values_22_marks_last_q <= 1'b0;
      centres_values_23_votes_q <= 1'b0;
      centres_values_23_grey_q <= 6'h0;
      centres_values_23_exists_q <= 1'b0;
      centres_values_23_marks_first_q <= 1'b0;
      centres_values_23_marks_last_q <= 1'b0;
    end else if (s0_en) begin
      row_ended_q <= marks_last_i;
      columns_q <= select_273 + {4'h0, not_275};
      outside_values_0_q <= known_i ? cost_0_i : 12'hfff;
      outside_values_1_q <= or_272 ? 12'hfff : outside_values_0_q;
      outside_values_2_q <= or_272 ? 12'hfff : outside_values_1_q;
      outside_values_3_q <= or_272 ? 12'hfff : outside_values_2_q;
      outside_values_4_q <= or_272 ? 12'hfff : outside_values_3_q;
      outside_values_5_q <= or_272 ? 12'hfff : outside_values_4_q;
      outside_values_6_q <= (select_283 < select_284) ? select_283 : select_284;
      outside_values_7_q <= or_272 ? 12'hfff : outside_values_6_q;
      outside_values_8_q <= or_272 ? 12'hfff : outside_values_7_q;
      outside_values_9_q <= or_272 ? 12'hfff : outside_values_8_q;
      outside_values_10_q <= or_272 ? 12'hfff : outside_values_9_q;
      outside_values_11_q <= (select_291 < select_292) ? select_291 : select_292;
      outside_values_12_q <= or_272 ? 12'hfff : outside_values_11_q;
      outside_values_13_q <= or_272 ? 12'hfff : outside_values_12_q;
      outside_values_14_q <= or_272 ? 12'hfff : outside_values_13_q;
      outside_values_15_q <= (select_298 < select_299) ? select_298 : select_299;
      outside_values_16_q <= or_272 ? 12'hfff : outside_values_15_q;
      outside_values_17_q <= or_272 ? 12'hfff : outside_values_16_q;
      outside_values_18_q <= (select_304 < select_305) ? select_304 : select_305;
      outside_values_19_q <= or_272 ? 12'hfff : outside_values_18_q;
      outside_values_20_q <= (select_309 < select_310) ? select_309 : select_310;
      outside_values_21_q <= (select_313 < select_314) ? select_313 : select_314;
      outside_values_22_q <= (select_317 < select_318) ? select_317 : select_318;
      outside_values_23_q <= or_272 ? 12'hfff : outside_values_22_q;
      outside_values_24_q <= or_272 ? 12'hfff : outside_values_23_q;
      inside_next_q <= known_i ? cost_8_i : 12'hfff;
      inside_here_q <= (select_324 < select_325) ? select_324 : select_325;
      seen_values_0_inside_q <= select_333;
      seen_values_0_hidden_q <= outside_values_24_q < select_333;
      seen_values_1_inside_q <= seen_values_0_inside_q;
      seen_values_1_hidden_q <= seen_values_0_hidden_q | (select_337 < seen_values_0_inside_q);
      seen_values_2_inside_q <= seen_values_1_inside_q;
      seen_values_2_hidden_q <= seen_values_1_hidden_q | less_343;
      seen_values_3_inside_q <= seen_values_2_inside_q;
      seen_values_3_hidden_q <= seen_values_2_hidden_q | (select_347 < seen_values_2_inside_q);
      seen_values_4_inside_q <= seen_values_3_inside_q;
      seen_values_4_hidden_q <= seen_values_3_hidden_q;
      seen_values_5_inside_q <= seen_values_4_inside_q;
      seen_values_5_hidden_q <= seen_values_4_hidden_q | (select_352 < seen_values_4_inside_q);
      seen_values_6_inside_q <= seen_values_5_inside_q;
      seen_values_6_hidden_q <= seen_values_5_hidden_q;
      seen_values_7_inside_q <= seen_values_6_inside_q;
      seen_values_7_hidden_q <= seen_values_6_hidden_q;
      seen_values_8_inside_q <= seen_values_7_inside_q;
      seen_values_8_hidden_q <= seen_values_7_hidden_q | less_358;
      seen_values_9_inside_q <= seen_values_8_inside_q;
      seen_values_9_hidden_q <= seen_values_8_hidden_q;
      seen_values_10_inside_q <= seen_values_9_inside_q;
      seen_values_10_hidden_q <= seen_values_9_hidden_q;
      seen_values_11_inside_q <= seen_values_10_inside_q;
      seen_values_11_hidden_q <= seen_values_10_hidden_q;
      seen_values_12_inside_q <= seen_values_11_inside_q;
      seen_values_12_hidden_q <= seen_values_11_hidden_q | less_363;
      seen_values_13_inside_q <= seen_values_12_inside_q;
      seen_values_13_hidden_q <= seen_values_12_hidden_q;
      seen_values_14_inside_q <= seen_values_13_inside_q;
      seen_values_14_hidden_q <= seen_values_13_hidden_q;
      seen_values_15_inside_q <= seen_values_14_inside_q;
      seen_values_15_hidden_q <= seen_values_14_hidden_q;
      seen_values_16_inside_q <= seen_values_15_inside_q;
      seen_values_16_hidden_q <= seen_values_15_hidden_q;
      seen_values_17_inside_q <= seen_values_16_inside_q;
      seen_values_17_hidden_q <= seen_values_16_hidden_q | (select_367 < seen_values_16_inside_q);
      seen_values_18_inside_q <= seen_values_17_inside_q;
      seen_values_18_hidden_q <= seen_values_17_hidden_q;
      seen_values_19_inside_q <= seen_values_18_inside_q;
      seen_values_19_hidden_q <= seen_values_18_hidden_q;
      seen_values_20_inside_q <= seen_values_19_inside_q;
      seen_values_20_hidden_q <= seen_values_19_hidden_q;
      seen_values_21_inside_q <= seen_values_20_inside_q;
      seen_values_21_hidden_q <= seen_values_20_hidden_q;
      seen_values_22_inside_q <= seen_values_21_inside_q;
      seen_values_22_hidden_q <= seen_values_21_hidden_q;
      centres_values_0_votes_q <= evident_i & or_437;
      centres_values_0_grey_q <= grey_i;
      centres_values_0_exists_q <= exists_i;
      centres_values_0_marks_first_q <= marks_first_i;
      centres_values_0_marks_last_q <= marks_last_i;
      centres_values_1_votes_q <= centres_values_0_votes_q;
      centres_values_1_grey_q <= centres_values_0_grey_q;
      centres_values_1_exists_q <= centres_values_0_exists_q;
      centres_values_1_marks_first_q <= centres_values_0_marks_first_q;
      centres_values_1_marks_last_q <= centres_values_0_marks_last_q;
      centres_values_2_votes_q <= centres_values_1_votes_q;
      centres_values_2_grey_q <= centres_values_1_grey_q;
      centres_values_2_exists_q <= centres_values_1_exists_q;
      centres_values_2_marks_first_q <= centres_values_1_marks_first_q;
      centres_values_2_marks_last_q <= centres_values_1_marks_last_q;
      centres_values_3_votes_q <= centres_values_2_votes_q;
      centres_values_3_grey_q <= centres_values_2_grey_q;
      centres_values_3_exists_q <= centres_values_2_exists_q;
      centres_values_3_marks_first_q <= centres_values_2_marks_first_q;
      centres_values_3_marks_last_q <= centres_values_2_marks_last_q;
      centres_values_4_votes_q <= centres_values_3_votes_q;
      centres_values_4_grey_q <= centres_values_3_grey_q;
      centres_values_4_exists_q <= centres_values_3_exists_q;
      centres_values_4_marks_first_q <= centres_values_3_marks_first_q;
      centres_values_4_marks_last_q <= centres_values_3_marks_last_q;
      centres_values_5_votes_q <= centres_values_4_votes_q;
      centres_values_5_grey_q <= centres_values_4_grey_q;
      centres_values_5_exists_q <= centres_values_4_exists_q;
      centres_values_5_marks_first_q <= centres_values_4_marks_first_q;
      centres_values_5_marks_last_q <= centres_values_4_marks_last_q;
      centres_values_6_votes_q <= centres_values_5_votes_q;
      centres_values_6_grey_q <= centres_values_5_grey_q;
      centres_values_6_exists_q <= centres_values_5_exists_q;
      centres_values_6_marks_first_q <= centres_values_5_marks_first_q;
      centres_values_6_marks_last_q <= centres_values_5_marks_last_q;
      centres_values_7_votes_q <= centres_values_6_votes_q;
      centres_values_7_grey_q <= centres_values_6_grey_q;
      centres_values_7_exists_q <= centres_values_6_exists_q;
      centres_values_7_marks_first_q <= centres_values_6_marks_first_q;
      centres_values_7_marks_last_q <= centres_values_6_marks_last_q;
      centres_values_8_votes_q <= centres_values_7_votes_q;
      centres_values_8_grey_q <= centres_values_7_grey_q;
      centres_values_8_exists_q <= centres_values_7_exists_q;
      centres_values_8_marks_first_q <= centres_values_7_marks_first_q;
      centres_values_8_marks_last_q <= centres_values_7_marks_last_q;
      centres_values_9_votes_q <= centres_values_8_votes_q;
      centres_values_9_grey_q <= centres_values_8_grey_q;
      centres_values_9_exists_q <= centres_values_8_exists_q;
      centres_values_9_marks_first_q <= centres_values_8_marks_first_q;
      centres_values_9_marks_last_q <= centres_values_8_marks_last_q;
      centres_values_10_votes_q <= centres_values_9_votes_q;
      centres_values_10_grey_q <= centres_values_9_grey_q;
      centres_values_10_exists_q <= centres_values_9_exists_q;
      centres_values_10_marks_first_q <= centres_values_9_marks_first_q;
      centres_values_10_marks_last_q <= centres_values_9_marks_last_q;
      centres_values_11_votes_q <= centres_values_10_votes_q;
      centres_values_11_grey_q <= centres_values_10_grey_q;
      centres_values_11_exists_q <= centres_values_10_exists_q;
      centres_values_11_marks_first_q <= centres_values_10_marks_first_q;
      centres_values_11_marks_last_q <= centres_values_10_marks_last_q;
      centres_values_12_votes_q <= centres_values_11_votes_q;
      centres_values_12_grey_q <= centres_values_11_grey_q;
      centres_values_12_exists_q <= centres_values_11_exists_q;
      centres_values_12_marks_first_q <= centres_values_11_marks_first_q;
      centres_values_12_marks_last_q <= centres_values_11_marks_last_q;
      centres_values_13_votes_q <= centres_values_12_votes_q;
      centres_values_13_grey_q <= centres_values_12_grey_q;
      centres_values_13_exists_q <= centres_values_12_exists_q;
      centres_values_13_marks_first_q <= centres_values_12_marks_first_q;
      centres_values_13_marks_last_q <= centres_values_12_marks_last_q;
      centres_values_14_votes_q <= centres_values_13_votes_q;
      centres_values_14_grey_q <= centres_values_13_grey_q;
      centres_values_14_exists_q <= centres_values_13_exists_q;
      centres_values_14_marks_first_q <= centres_values_13_marks_first_q;
      centres_values_14_marks_last_q <= centres_values_13_marks_last_q;
      centres_values_15_votes_q <= centres_values_14_votes_q;
      centres_values_15_grey_q <= centres_values_14_grey_q;
      centres_values_15_exists_q <= centres_values_14_exists_q;
      centres_values_15_marks_first_q <= centres_values_14_marks_first_q;
      centres_values_15_marks_last_q <= centres_values_14_marks_last_q;
      centres_values_16_votes_q <= centres_values_15_votes_q;
      centres_values_16_grey_q <= centres_values_15_grey_q;
      centres_values_16_exists_q <= centres_values_15_exists_q;
      centres_values_16_marks_first_q <= centres_values_15_marks_first_q;
      centres_values_16_marks_last_q <= centres_values_15_marks_last_q;
      centres_values_17_votes_q <= centres_values_16_votes_q;
      centres_values_17_grey_q <= centres_values_16_grey_q;
      centres_values_17_exists_q <= centres_values_16_exists_q;
      centres_values_17_marks_first_q <= centres_values_16_marks_first_q;
      centres_values_17_marks_last_q <= centres_values_16_marks_last_q;
      centres_values_18_votes_q <= centres_values_17_votes_q;
      centres_values_18_grey_q <= centres_values_17_grey_q;
      centres_values_18_exists_q <= centres_values_17_exists_q;
      centres_values_18_marks_first_q <= centres_values_17_marks_first_q;
      centres_values_18_marks_last_q <= centres_values_17_marks_last_q;
      centres_values_19_votes_q <= centres_values_18_votes_q;
      centres_values_19_grey_q <= centres_values_18_grey_q;
      centres_values_19_exists_q <= centres_values_18_exists_q;
      centres_values_19_marks_first_q <= centres_values_18_marks_first_q;
      centres_values_19_marks_last_q <= centres_values_18_marks_last_q;
      centres_values_20_votes_q <= centres_values_19_votes_q;
      centres_values_20_grey_q <= centres_values_19_grey_q;
      centres_values_20_exists_q <= centres_values_19_exists_q;
      centres_values_20_marks_first_q <= centres_values_19_marks_first_q;
      centres_values_20_marks_last_q <= centres_values_19_marks_last_q;
      centres_values_21_votes_q <= centres_values_20_votes_q;
      centres_values_21_grey_q <= centres_values_20_grey_q;
      centres_values_21_exists_q <= centres_values_20_exists_q;
      centres_values_21_marks_first_q <= centres_values_20_marks_first_q;
      centres_values_21_marks_last_q <= centres_values_20_marks_last_q;
      centres_values_22_votes_q <= centres_values_21_votes_q;
      centres_values_22_grey_q <= centres_values_21_grey_q;
      centres_values_22_exists_q <= centres_values_21_exists_q;
      centres_values_22_marks_first_q <= centres_values_21_marks_first_q;
      centres_values_22_marks_last_q <= centres_values_21_marks_last_q;
      centres_values_23_votes_q <= centres_values_22_votes_q;
      centres_values_23_grey_q <= centres_values_22_grey_q;
      centres_values_23_exists_q <= centres_values_22_exists_q;
      centres_values_23_marks_first_q <= centres_values_22_marks_first_q;
      centres_values_23_marks_last_q <= centres_values_22_marks_last_q;
    end
  end

  logic strong_v_s1_q;
  logic centres_values_23_votes_s1_q;
  logic [5:0] centres_values_23_grey_s1_q;
  logic centres_values_23_exists_s1_q;
  logic centres_values_23_marks_first_s1_q;
  logic centres_values_23_marks_last_s1_q;
  logic [15:0] z_2_s1_q;
  logic or_445_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      strong_v_s1_q <= strong_v_i;
      centres_values_23_votes_s1_q <= centres_values_23_votes_q;
      centres_values_23_grey_s1_q <= centres_values_23_grey_q;
      centres_values_23_exists_s1_q <= centres_values_23_exists_q;
      centres_values_23_marks_first_s1_q <= centres_values_23_marks_first_q;
      centres_values_23_marks_last_s1_q <= centres_values_23_marks_last_q;
      z_2_s1_q <= z_2;
      or_445_s1_q <= seen_values_22_hidden_q | (select_443 < seen_values_22_inside_q);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] centres_values_0_clipped_q;
  logic centres_values_0_firm_q;
  logic [5:0] centres_values_1_clipped_q;
  logic centres_values_1_firm_q;
  logic [5:0] centres_values_2_clipped_q;
  logic centres_values_2_firm_q;
  logic [5:0] centres_values_3_clipped_q;
  logic centres_values_3_firm_q;
  logic [5:0] centres_values_4_clipped_q;
  logic centres_values_4_firm_q;
  logic [5:0] centres_values_5_clipped_q;
  logic centres_values_5_firm_q;
  logic [5:0] centres_values_6_clipped_q;
  logic centres_values_6_firm_q;
  logic [5:0] centres_values_7_clipped_q;
  logic centres_values_7_firm_q;
  logic [5:0] centres_values_8_clipped_q;
  logic centres_values_8_firm_q;
  logic [5:0] centres_values_9_clipped_q;
  logic centres_values_9_firm_q;
  logic [5:0] centres_values_10_clipped_q;
  logic centres_values_10_firm_q;
  logic [5:0] centres_values_11_clipped_q;
  logic centres_values_11_firm_q;
  logic [5:0] centres_values_12_clipped_q;
  logic centres_values_12_firm_q;
  logic [5:0] centres_values_13_clipped_q;
  logic centres_values_13_firm_q;
  logic [5:0] centres_values_14_clipped_q;
  logic centres_values_14_firm_q;
  logic [5:0] centres_values_15_clipped_q;
  logic centres_values_15_firm_q;
  logic [5:0] centres_values_16_clipped_q;
  logic centres_values_16_firm_q;
  logic [5:0] centres_values_17_clipped_q;
  logic centres_values_17_firm_q;
  logic [5:0] centres_values_18_clipped_q;
  logic centres_values_18_firm_q;
  logic [5:0] centres_values_19_clipped_q;
  logic centres_values_19_firm_q;
  logic [5:0] centres_values_20_clipped_q;
  logic centres_values_20_firm_q;
  logic [5:0] centres_values_21_clipped_q;
  logic centres_values_21_firm_q;
  logic [5:0] centres_values_22_clipped_q;
  logic centres_values_22_firm_q;
  logic [5:0] centres_values_23_clipped_q;
  logic centres_values_23_firm_q;
  // hls/stages/contest.hpp:59
  logic [5:0] select_431;
  assign select_431 = ($signed(8'h0) < $signed(z_2_s1_q[15:8])) ? 6'h1f : z_2_s1_q[8:3];
  logic [5:0] select_432;
  assign select_432 = ($signed(z_2_s1_q[15:3]) < $signed(13'h1fe1)) ? 6'h21 : select_431;
  // hls/stages/contest.hpp:61
  logic [5:0] select_447;
  assign select_447 = ($signed(6'h38) < $signed(centres_values_23_clipped_q)) ? 6'h38 : centres_values_23_clipped_q;
  logic [5:0] clipped;
  assign clipped = or_445_s1_q ? select_447 : centres_values_23_clipped_q;
  // hls/stages/contest.hpp:63
  logic and_451;
  assign and_451 = centres_values_23_votes_s1_q & (~(clipped == 6'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      centres_values_0_clipped_q <= 6'h0;
      centres_values_0_firm_q <= 1'b0;
      centres_values_1_clipped_q <= 6'h0;
      centres_values_1_firm_q <= 1'b0;
      centres_values_2_clipped_q <= 6'h0;
      centres_values_2_firm_q <= 1'b0;
      centres_values_3_clipped_q <= 6'h0;
      centres_values_3_firm_q <= 1'b0;
      centres_values_4_clipped_q <= 6'h0;
      centres_values_4_firm_q <= 1'b0;
      centres_values_5_clipped_q <= 6'h0;
      centres_values_5_firm_q <= 1'b0;
      centres_values_6_clipped_q <= 6'h0;
      centres_values_6_firm_q <= 1'b0;
      centres_values_7_clipped_q <= 6'h0;
      centres_values_7_firm_q <= 1'b0;
      centres_values_8_clipped_q <= 6'h0;
      centres_values_8_firm_q <= 1'b0;
      centres_values_9_clipped_q <= 6'h0;
      centres_values_9_firm_q <= 1'b0;
      centres_values_10_clipped_q <= 6'h0;
      centres_values_10_firm_q <= 1'b0;
      centres_values_11_clipped_q <= 6'h0;
      centres_values_11_firm_q <= 1'b0;
      centres_values_12_clipped_q <= 6'h0;
      centres_values_12_firm_q <= 1'b0;
      centres_values_13_clipped_q <= 6'h0;
      centres_values_13_firm_q <= 1'b0;
      centres_values_14_clipped_q <= 6'h0;
      centres_values_14_firm_q <= 1'b0;
      centres_values_15_clipped_q <= 6'h0;
      centres_values_15_firm_q <= 1'b0;
      centres_values_16_clipped_q <= 6'h0;
      centres_values_16_firm_q <= 1'b0;
      centres_values_17_clipped_q <= 6'h0;
      centres_values_17_firm_q <= 1'b0;
      centres_values_18_clipped_q <= 6'h0;
      centres_values_18_firm_q <= 1'b0;
      centres_values_19_clipped_q <= 6'h0;
      centres_values_19_firm_q <= 1'b0;
      centres_values_20_clipped_q <= 6'h0;
      centres_values_20_firm_q <= 1'b0;
      centres_values_21_clipped_q <= 6'h0;
      centres_values_21_firm_q <= 1'b0;
      centres_values_22_clipped_q <= 6'h0;
      centres_values_22_firm_q <= 1'b0;
      centres_values_23_clipped_q <= 6'h0;
      centres_values_23_firm_q <= 1'b0;
    end else if (s1_en) begin
      centres_values_0_clipped_q <= select_432;
      centres_values_0_firm_q <= strong_v_s1_q & ($signed(z_2_s1_q) < $signed(16'hfe01));
      centres_values_1_clipped_q <= centres_values_0_clipped_q;
      centres_values_1_firm_q <= centres_values_0_firm_q;
      centres_values_2_clipped_q <= centres_values_1_clipped_q;
      centres_values_2_firm_q <= centres_values_1_firm_q;
      centres_values_3_clipped_q <= centres_values_2_clipped_q;
      centres_values_3_firm_q <= centres_values_2_firm_q;
      centres_values_4_clipped_q <= centres_values_3_clipped_q;
      centres_values_4_firm_q <= centres_values_3_firm_q;
      centres_values_5_clipped_q <= centres_values_4_clipped_q;
      centres_values_5_firm_q <= centres_values_4_firm_q;
      centres_values_6_clipped_q <= centres_values_5_clipped_q;
      centres_values_6_firm_q <= centres_values_5_firm_q;
      centres_values_7_clipped_q <= centres_values_6_clipped_q;
      centres_values_7_firm_q <= centres_values_6_firm_q;
      centres_values_8_clipped_q <= centres_values_7_clipped_q;
      centres_values_8_firm_q <= centres_values_7_firm_q;
      centres_values_9_clipped_q <= centres_values_8_clipped_q;
      centres_values_9_firm_q <= centres_values_8_firm_q;
      centres_values_10_clipped_q <= centres_values_9_clipped_q;
      centres_values_10_firm_q <= centres_values_9_firm_q;
      centres_values_11_clipped_q <= centres_values_10_clipped_q;
      centres_values_11_firm_q <= centres_values_10_firm_q;
      centres_values_12_clipped_q <= centres_values_11_clipped_q;
      centres_values_12_firm_q <= centres_values_11_firm_q;
      centres_values_13_clipped_q <= centres_values_12_clipped_q;
      centres_values_13_firm_q <= centres_values_12_firm_q;
      centres_values_14_clipped_q <= centres_values_13_clipped_q;
      centres_values_14_firm_q <= centres_values_13_firm_q;
      centres_values_15_clipped_q <= centres_values_14_clipped_q;
      centres_values_15_firm_q <= centres_values_14_firm_q;
      centres_values_16_clipped_q <= centres_values_15_clipped_q;
      centres_values_16_firm_q <= centres_values_15_firm_q;
      centres_values_17_clipped_q <= centres_values_16_clipped_q;
      centres_values_17_firm_q <= centres_values_16_firm_q;
      centres_values_18_clipped_q <= centres_values_17_clipped_q;
      centres_values_18_firm_q <= centres_values_17_firm_q;
      centres_values_19_clipped_q <= centres_values_18_clipped_q;
      centres_values_19_firm_q <= centres_values_18_firm_q;
      centres_values_20_clipped_q <= centres_values_19_clipped_q;
      centres_values_20_firm_q <= centres_values_19_firm_q;
      centres_values_21_clipped_q <= centres_values_20_clipped_q;
      centres_values_21_firm_q <= centres_values_20_firm_q;
      centres_values_22_clipped_q <= centres_values_21_clipped_q;
      centres_values_22_firm_q <= centres_values_21_firm_q;
      centres_values_23_clipped_q <= centres_values_22_clipped_q;
      centres_values_23_firm_q <= centres_values_22_firm_q;
    end
  end

  logic [5:0] centres_values_23_grey_s2_q;
  logic centres_values_23_exists_s2_q;
  logic centres_values_23_marks_first_s2_q;
  logic centres_values_23_marks_last_s2_q;
  logic [6:0] select_453_s2_q;
  logic and_454_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      centres_values_23_grey_s2_q <= centres_values_23_grey_s1_q;
      centres_values_23_exists_s2_q <= centres_values_23_exists_s1_q;
      centres_values_23_marks_first_s2_q <= centres_values_23_marks_first_s1_q;
      centres_values_23_marks_last_s2_q <= centres_values_23_marks_last_s1_q;
      select_453_s2_q <= and_451 ? ({3'h0, cfg_bias_i} + {clipped[5], clipped}) : 7'h0;
      and_454_s2_q <= centres_values_23_firm_q & and_451;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign vote_o = select_453_s2_q;
  assign firm_o = and_454_s2_q;
  assign grey_o = centres_values_23_grey_s2_q;
  assign exists_o = centres_values_23_exists_s2_q;
  assign marks_first_o = centres_values_23_marks_first_s2_q;
  assign marks_last_o = centres_values_23_marks_last_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_392[0], sum_388[0], sum_381[0], sum_377[0]};

endmodule
