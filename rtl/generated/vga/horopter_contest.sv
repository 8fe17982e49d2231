// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Contest<horopter::hls::profiles::vga>, hls/stages/contest.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1037 bits, pipeline 62 bits, memories 0 bits.
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
  // hls/stages/contest.hpp:54
  logic or_271;
  assign or_271 = marks_first_i | row_ended_q;
  // hls/stages/contest.hpp:132
  logic [4:0] select_272;
  assign select_272 = or_271 ? 5'h0 : columns_q;
  // hls/stages/contest.hpp:147
  logic not_274;
  assign not_274 = ~(select_272 == 5'h18);
  // hls/stages/contest.hpp:132
  logic [11:0] select_282;
  assign select_282 = known_i ? cost_1_i : 12'hfff;
  logic [11:0] select_283;
  assign select_283 = or_271 ? 12'hfff : outside_values_5_q;
  logic [11:0] select_290;
  assign select_290 = known_i ? cost_2_i : 12'hfff;
  logic [11:0] select_291;
  assign select_291 = or_271 ? 12'hfff : outside_values_10_q;
  logic [11:0] select_297;
  assign select_297 = known_i ? cost_3_i : 12'hfff;
  logic [11:0] select_298;
  assign select_298 = or_271 ? 12'hfff : outside_values_14_q;
  logic [11:0] select_303;
  assign select_303 = known_i ? cost_4_i : 12'hfff;
  logic [11:0] select_304;
  assign select_304 = or_271 ? 12'hfff : outside_values_17_q;
  logic [11:0] select_308;
  assign select_308 = known_i ? cost_5_i : 12'hfff;
  logic [11:0] select_309;
  assign select_309 = or_271 ? 12'hfff : outside_values_19_q;
  logic [11:0] select_312;
  assign select_312 = known_i ? cost_6_i : 12'hfff;
  logic [11:0] select_313;
  assign select_313 = or_271 ? 12'hfff : outside_values_20_q;
  logic [11:0] select_316;
  assign select_316 = known_i ? cost_7_i : 12'hfff;
  logic [11:0] select_317;
  assign select_317 = or_271 ? 12'hfff : outside_values_21_q;
  logic [11:0] select_323;
  assign select_323 = known_i ? cost_9_i : 12'hfff;
  logic [11:0] select_324;
  assign select_324 = or_271 ? 12'hfff : inside_next_q;
  logic [11:0] select_330;
  assign select_330 = (known_i & (~(select_272 == 5'h0))) ? cost_10_i : 12'hfff;
  // hls/stages/contest.hpp:138
  logic [11:0] select_332;
  assign select_332 = (select_330 < inside_here_q) ? select_330 : inside_here_q;
  // hls/stages/contest.hpp:132
  logic [11:0] select_336;
  assign select_336 = known_i ? ((select_272[4:1] == 4'h0) ? 12'hfff : cost_11_i) : 12'hfff;
  // hls/stages/contest.hpp:145
  logic less_342;
  assign less_342 = (known_i ? ((select_272 < 5'h3) ? 12'hfff : cost_12_i) : 12'hfff) < seen_values_1_inside_q;
  // hls/stages/contest.hpp:132
  logic [11:0] select_346;
  assign select_346 = known_i ? ((select_272[4:2] == 3'h0) ? 12'hfff : cost_13_i) : 12'hfff;
  logic [11:0] select_351;
  assign select_351 = known_i ? ((select_272[4:1] < 4'h3) ? 12'hfff : cost_14_i) : 12'hfff;
  // hls/stages/contest.hpp:145
  logic less_357;
  assign less_357 = (known_i ? ((select_272 < 5'h9) ? 12'hfff : cost_15_i) : 12'hfff) < seen_values_7_inside_q;
  logic less_362;
  assign less_362 = (known_i ? ((select_272 < 5'hd) ? 12'hfff : cost_16_i) : 12'hfff) < seen_values_11_inside_q;
  // hls/stages/contest.hpp:132
  logic [11:0] select_366;
  assign select_366 = known_i ? ((select_272[4:1] < 4'h9) ? 12'hfff : cost_17_i) : 12'hfff;
  // hls/stages/contest.hpp:98
  logic less_370;
  assign less_370 = cost_10_i < cost_8_i;
  // hls/stages/contest.hpp:158
  logic [12:0] inner;
  assign inner = {1'b0, cost_9_i} - {1'b0, cost_8_i};
  // hls/stages/contest.hpp:159
  logic [13:0] difference_374;
  assign difference_374 = {{3{inner[12]}}, inner[12:2]} - {inner[12], inner};
  logic [12:0] difference_375;
  assign difference_375 = {1'b0, cost_7_i} - {1'b0, cost_8_i};
  logic [14:0] b;
  assign b = {difference_374[13], difference_374} + {{2{difference_375[12]}}, difference_375};
  // hls/stages/contest.hpp:158
  logic [12:0] inner_2;
  assign inner_2 = {1'b0, cost_9_i} - {1'b0, cost_10_i};
  // hls/stages/contest.hpp:159
  logic [13:0] difference_380;
  assign difference_380 = {{3{inner_2[12]}}, inner_2[12:2]} - {inner_2[12], inner_2};
  logic [12:0] difference_381;
  assign difference_381 = {1'b0, cost_11_i} - {1'b0, cost_10_i};
  logic [14:0] b_2;
  assign b_2 = {difference_380[13], difference_380} + {{2{difference_381[12]}}, difference_381};
  // hls/stages/contest.hpp:97
  logic [11:0] select_384;
  assign select_384 = (cost_11_i < cost_7_i) ? cost_11_i : cost_7_i;
  // hls/stages/contest.hpp:167
  logic [11:0] select_386;
  assign select_386 = (cost_17_i < cost_16_i) ? cost_17_i : cost_16_i;
  logic [11:0] select_388;
  assign select_388 = (cost_18_i < select_386) ? cost_18_i : select_386;
  logic [11:0] select_390;
  assign select_390 = (cost_15_i < cost_14_i) ? cost_15_i : cost_14_i;
  logic [11:0] select_392;
  assign select_392 = (cost_13_i < cost_12_i) ? cost_13_i : cost_12_i;
  logic [11:0] select_394;
  assign select_394 = (select_390 < select_392) ? select_390 : select_392;
  logic [11:0] select_396;
  assign select_396 = (select_388 < select_394) ? select_388 : select_394;
  logic [11:0] select_398;
  assign select_398 = (cost_5_i < cost_4_i) ? cost_5_i : cost_4_i;
  logic [11:0] select_400;
  assign select_400 = (cost_6_i < select_398) ? cost_6_i : select_398;
  logic [11:0] select_402;
  assign select_402 = (cost_3_i < cost_2_i) ? cost_3_i : cost_2_i;
  logic [11:0] select_404;
  assign select_404 = (cost_1_i < cost_0_i) ? cost_1_i : cost_0_i;
  logic [11:0] select_406;
  assign select_406 = (select_402 < select_404) ? select_402 : select_404;
  logic [11:0] select_408;
  assign select_408 = (select_400 < select_406) ? select_400 : select_406;
  // hls/stages/contest.hpp:96
  logic [11:0] far;
  assign far = (select_396 < select_408) ? select_396 : select_408;
  // hls/stages/contest.hpp:97
  logic [11:0] outside;
  assign outside = (select_384 < far) ? select_384 : far;
  // hls/stages/contest.hpp:98
  logic [11:0] select_413;
  assign select_413 = less_370 ? cost_10_i : cost_8_i;
  logic [11:0] inside_v;
  assign inside_v = (select_413 < cost_9_i) ? select_413 : cost_9_i;
  // hls/stages/contest.hpp:100
  logic [12:0] z;
  assign z = {1'b0, outside} - {1'b0, inside_v};
  // hls/stages/contest.hpp:153
  logic [14:0] select_418;
  assign select_418 = ($signed(b_2) < $signed({{2{z[12]}}, z})) ? b_2 : {{2{z[12]}}, z};
  // hls/stages/contest.hpp:101
  logic [14:0] z_2;
  assign z_2 = (less_370 & (cost_10_i < cost_9_i)) ? select_418 : {{2{z[12]}}, z};
  // hls/stages/contest.hpp:105
  logic or_431;
  assign or_431 = (outside < inside_v) | (~({1'b0, far} < ({1'b0, inside_v} + {5'h0, inside_v[11:4]})));
  // hls/stages/contest.hpp:132
  logic [11:0] select_437;
  assign select_437 = known_i ? ((select_272[4:3] == 2'h3) ? cost_18_i : 12'hfff) : 12'hfff;

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
      columns_q <= select_272 + {4'h0, not_274};
      outside_values_0_q <= known_i ? cost_0_i : 12'hfff;
      outside_values_1_q <= or_271 ? 12'hfff : outside_values_0_q;
      outside_values_2_q <= or_271 ? 12'hfff : outside_values_1_q;
      outside_values_3_q <= or_271 ? 12'hfff : outside_values_2_q;
      outside_values_4_q <= or_271 ? 12'hfff : outside_values_3_q;
      outside_values_5_q <= or_271 ? 12'hfff : outside_values_4_q;
      outside_values_6_q <= (select_282 < select_283) ? select_282 : select_283;
      outside_values_7_q <= or_271 ? 12'hfff : outside_values_6_q;
      outside_values_8_q <= or_271 ? 12'hfff : outside_values_7_q;
      outside_values_9_q <= or_271 ? 12'hfff : outside_values_8_q;
      outside_values_10_q <= or_271 ? 12'hfff : outside_values_9_q;
      outside_values_11_q <= (select_290 < select_291) ? select_290 : select_291;
      outside_values_12_q <= or_271 ? 12'hfff : outside_values_11_q;
      outside_values_13_q <= or_271 ? 12'hfff : outside_values_12_q;
      outside_values_14_q <= or_271 ? 12'hfff : outside_values_13_q;
      outside_values_15_q <= (select_297 < select_298) ? select_297 : select_298;
      outside_values_16_q <= or_271 ? 12'hfff : outside_values_15_q;
      outside_values_17_q <= or_271 ? 12'hfff : outside_values_16_q;
      outside_values_18_q <= (select_303 < select_304) ? select_303 : select_304;
      outside_values_19_q <= or_271 ? 12'hfff : outside_values_18_q;
      outside_values_20_q <= (select_308 < select_309) ? select_308 : select_309;
      outside_values_21_q <= (select_312 < select_313) ? select_312 : select_313;
      outside_values_22_q <= (select_316 < select_317) ? select_316 : select_317;
      outside_values_23_q <= or_271 ? 12'hfff : outside_values_22_q;
      outside_values_24_q <= or_271 ? 12'hfff : outside_values_23_q;
      inside_next_q <= known_i ? cost_8_i : 12'hfff;
      inside_here_q <= (select_323 < select_324) ? select_323 : select_324;
      seen_values_0_inside_q <= select_332;
      seen_values_0_hidden_q <= outside_values_24_q < select_332;
      seen_values_1_inside_q <= seen_values_0_inside_q;
      seen_values_1_hidden_q <= seen_values_0_hidden_q | (select_336 < seen_values_0_inside_q);
      seen_values_2_inside_q <= seen_values_1_inside_q;
      seen_values_2_hidden_q <= seen_values_1_hidden_q | less_342;
      seen_values_3_inside_q <= seen_values_2_inside_q;
      seen_values_3_hidden_q <= seen_values_2_hidden_q | (select_346 < seen_values_2_inside_q);
      seen_values_4_inside_q <= seen_values_3_inside_q;
      seen_values_4_hidden_q <= seen_values_3_hidden_q;
      seen_values_5_inside_q <= seen_values_4_inside_q;
      seen_values_5_hidden_q <= seen_values_4_hidden_q | (select_351 < seen_values_4_inside_q);
      seen_values_6_inside_q <= seen_values_5_inside_q;
      seen_values_6_hidden_q <= seen_values_5_hidden_q;
      seen_values_7_inside_q <= seen_values_6_inside_q;
      seen_values_7_hidden_q <= seen_values_6_hidden_q;
      seen_values_8_inside_q <= seen_values_7_inside_q;
      seen_values_8_hidden_q <= seen_values_7_hidden_q | less_357;
      seen_values_9_inside_q <= seen_values_8_inside_q;
      seen_values_9_hidden_q <= seen_values_8_hidden_q;
      seen_values_10_inside_q <= seen_values_9_inside_q;
      seen_values_10_hidden_q <= seen_values_9_hidden_q;
      seen_values_11_inside_q <= seen_values_10_inside_q;
      seen_values_11_hidden_q <= seen_values_10_hidden_q;
      seen_values_12_inside_q <= seen_values_11_inside_q;
      seen_values_12_hidden_q <= seen_values_11_hidden_q | less_362;
      seen_values_13_inside_q <= seen_values_12_inside_q;
      seen_values_13_hidden_q <= seen_values_12_hidden_q;
      seen_values_14_inside_q <= seen_values_13_inside_q;
      seen_values_14_hidden_q <= seen_values_13_hidden_q;
      seen_values_15_inside_q <= seen_values_14_inside_q;
      seen_values_15_hidden_q <= seen_values_14_hidden_q;
      seen_values_16_inside_q <= seen_values_15_inside_q;
      seen_values_16_hidden_q <= seen_values_15_hidden_q;
      seen_values_17_inside_q <= seen_values_16_inside_q;
      seen_values_17_hidden_q <= seen_values_16_hidden_q | (select_366 < seen_values_16_inside_q);
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
      centres_values_0_votes_q <= evident_i & or_431;
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
  logic and_372_s1_q;
  logic [14:0] b_s1_q;
  logic [14:0] z_2_s1_q;
  logic or_439_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      strong_v_s1_q <= strong_v_i;
      centres_values_23_votes_s1_q <= centres_values_23_votes_q;
      centres_values_23_grey_s1_q <= centres_values_23_grey_q;
      centres_values_23_exists_s1_q <= centres_values_23_exists_q;
      centres_values_23_marks_first_s1_q <= centres_values_23_marks_first_q;
      centres_values_23_marks_last_s1_q <= centres_values_23_marks_last_q;
      and_372_s1_q <= (cost_8_i < cost_9_i) & (~less_370);
      b_s1_q <= b;
      z_2_s1_q <= z_2;
      or_439_s1_q <= seen_values_22_hidden_q | (select_437 < seen_values_22_inside_q);
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
  // hls/stages/contest.hpp:103
  logic [14:0] z_3;
  assign z_3 = and_372_s1_q ? (($signed(b_s1_q) < $signed(z_2_s1_q)) ? b_s1_q : z_2_s1_q) : z_2_s1_q;
  // hls/stages/contest.hpp:57
  logic [5:0] select_426;
  assign select_426 = ($signed(z_3[14:3]) < $signed(12'hfe1)) ? 6'h21 : (($signed(7'h0) < $signed(z_3[14:8])) ? 6'h1f : z_3[8:3]);
  // hls/stages/contest.hpp:59
  logic [5:0] select_441;
  assign select_441 = ($signed(6'h38) < $signed(centres_values_23_clipped_q)) ? 6'h38 : centres_values_23_clipped_q;
  logic [5:0] clipped;
  assign clipped = or_439_s1_q ? select_441 : centres_values_23_clipped_q;
  // hls/stages/contest.hpp:61
  logic and_445;
  assign and_445 = centres_values_23_votes_s1_q & (~(clipped == 6'h0));

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
      centres_values_0_clipped_q <= select_426;
      centres_values_0_firm_q <= strong_v_s1_q & ($signed(z_3) < $signed(15'h7e01));
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
  logic [6:0] select_447_s2_q;
  logic and_448_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      centres_values_23_grey_s2_q <= centres_values_23_grey_s1_q;
      centres_values_23_exists_s2_q <= centres_values_23_exists_s1_q;
      centres_values_23_marks_first_s2_q <= centres_values_23_marks_first_s1_q;
      centres_values_23_marks_last_s2_q <= centres_values_23_marks_last_s1_q;
      select_447_s2_q <= and_445 ? ({3'h0, cfg_bias_i} + {clipped[5], clipped}) : 7'h0;
      and_448_s2_q <= centres_values_23_firm_q & and_445;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign vote_o = select_447_s2_q;
  assign firm_o = and_448_s2_q;
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

endmodule
