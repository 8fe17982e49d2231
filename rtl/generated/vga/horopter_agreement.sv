// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 6 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2567 bits, pipeline 1318 bits, memories 69248 bits.
module horopter_agreement (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic [7:0] pixel_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic present_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [9:0] cfg_width_i,
  input  logic [8:0] cfg_height_i,
  input  logic cfg_compete_i,
  input  logic cfg_prove_i,
  input  logic signed [5:0] cfg_shift_lowest_i,
  input  logic signed [5:0] cfg_shift_highest_i,
  input  logic cfg_nearer_below_i,
  input  logic cfg_nearer_above_i,
  input  logic [7:0] cfg_explained_limit_i,
  input  logic [7:0] cfg_regions_limit_i,
  input  logic [7:0] cfg_unproven_limit_i,
  input  logic [7:0] cfg_unproven_skin_limit_i,
  input  logic [7:0] cfg_hidden_limit_i,
  input  logic [7:0] cfg_hidden_frames_i,
  input  logic [5:0] cfg_moved_limit_i,
  input  logic [5:0] cfg_moved_half_limit_i,
  input  logic signed [15:0] cfg_epipolar_slope_i,
  input  logic signed [15:0] cfg_epipolar_column_i,
  input  logic signed [15:0] cfg_epipolar_row_i,
  input  logic signed [15:0] cfg_epipolar_both_i,
  output logic parity_error_o,
  output logic valid_o,
  output logic [7:0] pixel_0_o,
  output logic [7:0] pixel_1_o,
  output logic saturated_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o,
  output logic verdict_valid_o,
  output logic [15:0] verdict_supervised_o,
  output logic [15:0] verdict_textured_o,
  output logic [15:0] verdict_explained_o,
  output logic [15:0] verdict_nearer_o,
  output logic [15:0] verdict_unproven_o,
  output logic [15:0] verdict_regions_bad_o,
  output logic verdict_unproven_yet_o,
  output logic verdict_untextured_o,
  output logic verdict_disagree_o,
  output logic verdict_moved_o,
  output logic verdict_unsharp_left_o,
  output logic verdict_unsharp_right_o,
  output logic verdict_hidden_o,
  output logic signed [19:0] verdict_across_0_o,
  output logic signed [19:0] verdict_across_1_o,
  output logic signed [19:0] verdict_across_2_o,
  output logic signed [19:0] verdict_across_3_o,
  output logic [11:0] verdict_measured_0_o,
  output logic [11:0] verdict_measured_1_o,
  output logic [11:0] verdict_measured_2_o,
  output logic [11:0] verdict_measured_3_o,
  output logic [23:0] verdict_detail_0_o,
  output logic [23:0] verdict_detail_1_o,
  output logic [23:0] verdict_contrast_0_o,
  output logic [23:0] verdict_contrast_1_o,
  output logic region_valid_o,
  output logic [5:0] region_region_o,
  output logic [11:0] region_textured_o,
  output logic [11:0] region_explained_o,
  output logic [11:0] region_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[9:3]} + 8'hff;
  logic [6:0] sum_1412;
  assign sum_1412 = {1'b0, cfg_width_i[9:4]} + 7'h7;
  logic [5:0] sum_1427;
  assign sum_1427 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_1907;
  assign difference_1907 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2050;
  assign less_2050 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2051;
  assign sum_2051 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_2069;
  assign not_2069 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [2:0] raster_at_x_q;
  logic [2:0] raster_at_y_q;
  logic [6:0] raster_at_column_q;
  logic [5:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [8:0] raster_rows_left_q;
  logic raster_row_ended_q;
  logic raster_final_row_q;
  logic [8:0] averager_place_q;
  logic averager_running_mask_q;
  logic [2:0] run_phase_q;
  logic [7:0] run_lowest_q;
  logic [7:0] run_highest_q;
  logic [7:0] run_beats_q;
  logic [5:0] run_shift_q;
  logic run_last_shift_q;
  logic [2:0] following_phase_q;
  logic [7:0] following_lowest_q;
  logic [7:0] following_highest_q;
  logic [7:0] following_beats_q;
  logic [5:0] following_shift_q;
  logic following_last_shift_q;
  logic [7:0] x_q;
  logic [7:0] beats_left_q;
  logic [6:0] last_q;
  logic [6:0] least_q;
  logic [7:0] first_beats_q;
  logic [7:0] whole_beats_q;
  logic [6:0] age_q;
  logic ends_q;
  logic final_row_q;
  logic [7:0] next_lowest_q;
  logic [7:0] next_highest_q;
  logic [7:0] next_beats_q;
  logic [5:0] next_shift_q;
  logic next_last_shift_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_318;
  assign select_318 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_320;
  assign select_320 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [8:0] select_323;
  assign select_323 = ({select_320, select_318} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:95
  logic [8:0] select_324;
  assign select_324 = select_318[0] ? averager_place_q : select_323;
  // hls/stages/census.hpp:40
  logic or_325;
  assign or_325 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:202
  logic and_331;
  assign and_331 = (~((~or_325) | (~select_318[0]))) & (select_324[8:6] < 3'h5);
  // hls/stages/census.hpp:40
  logic [2:0] select_336;
  assign select_336 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:202
  logic whole;
  assign whole = select_318[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:204
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_320 : 7'h0;
  // hls/stages/census.hpp:45
  logic equal_353;
  assign equal_353 = select_318 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_354;
  assign equal_354 = select_336 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_355;
  assign and_355 = equal_354 & and_331;
  // hls/stages/agreement.hpp:204
  logic and_357;
  assign and_357 = sample_pair_whole_q & (equal_353 & and_355);
  // hls/stages/agreement.hpp:787
  logic drew;
  assign drew = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:381
  logic equal_377;
  assign equal_377 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:590
  logic or_378;
  assign or_378 = drew | equal_377;
  // hls/stages/agreement.hpp:447
  logic not_379;
  assign not_379 = ~or_378;
  // hls/stages/agreement.hpp:381
  logic equal_380;
  assign equal_380 = run_phase_q == 3'h3;
  logic equal_382;
  assign equal_382 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:602
  logic less_383;
  assign less_383 = run_highest_q < x_q;
  logic not_384;
  assign not_384 = ~less_383;
  // hls/stages/agreement.hpp:181
  logic and_385;
  assign and_385 = equal_382 & not_384;
  logic and_387;
  assign and_387 = not_379 & ((~equal_380) & and_385);
  // hls/stages/census.hpp:40
  logic [5:0] select_414;
  assign select_414 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:204
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_414 : 6'h0;
  // hls/stages/agreement.hpp:181
  logic select_471;
  assign select_471 = equal_380 ? not_384 : and_385;
  logic [6:0] select_500;
  assign select_500 = equal_380 ? ({run_shift_q[5], run_shift_q} + x_q[6:0]) : x_q[6:0];
  // hls/stages/agreement.hpp:469
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:181
  logic and_525;
  assign and_525 = equal_380 & (age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q})));
  logic select_526;
  assign select_526 = or_378 ? not_384 : and_525;
  // hls/stages/agreement.hpp:488
  logic equal_529;
  assign equal_529 = {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:492
  logic or_531;
  assign or_531 = equal_529 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:143
  logic not_972;
  assign not_972 = ~drew;
  // hls/stages/agreement.hpp:735
  logic [6:0] sum_1137;
  assign sum_1137 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:204
  logic [2:0] select_1147;
  assign select_1147 = sample_pair_whole_q ? (sample_last_q ? (select_336 + 3'h1) : select_336) : raster_at_y_q;
  logic [6:0] select_1149;
  assign select_1149 = sample_pair_whole_q ? (select_320 + {6'h0, equal_353}) : raster_at_column_q;
  logic [5:0] select_1152;
  assign select_1152 = sample_pair_whole_q ? (sample_last_q ? (select_414 + {5'h0, equal_354}) : select_414) : raster_at_row_q;
  logic select_1156;
  assign select_1156 = sample_pair_whole_q ? (sample_last_q ? (or_325 & (~raster_final_row_q)) : or_325) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_1158;
  assign select_1158 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:204
  logic select_1162;
  assign select_1162 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:289
  logic equal_1334;
  assign equal_1334 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:200
  logic [2:0] select_1335;
  assign select_1335 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1338;
  assign select_1338 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1341;
  assign select_1341 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1344;
  assign select_1344 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1347;
  assign select_1347 = ends_q ? following_shift_q : run_shift_q;
  logic select_1350;
  assign select_1350 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:290
  logic not_1351;
  assign not_1351 = ~equal_1334;
  // hls/stages/agreement.hpp:371
  logic not_1354;
  assign not_1354 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:381
  logic equal_1355;
  assign equal_1355 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:160
  logic or_1356;
  assign or_1356 = equal_1355 | equal_382;
  logic [2:0] select_1357;
  assign select_1357 = equal_380 ? {run_last_shift_q, {2{not_1354}}} : {1'b0, or_1356, equal_382};
  logic [2:0] select_1359;
  assign select_1359 = drew ? {{2{final_row_q}}, 1'b0} : (equal_377 ? 3'h5 : select_1357);
  logic [7:0] select_1361;
  assign select_1361 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1362;
  assign select_1362 = equal_382 ? least_q : 7'h0;
  logic [7:0] select_1364;
  assign select_1364 = equal_377 ? 8'h0 : (equal_380 ? select_1361 : {1'b0, select_1362});
  logic [7:0] select_1367;
  assign select_1367 = run_last_shift_q ? {1'b0, last_q} : (run_shift_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1369;
  assign select_1369 = equal_382 ? last_q : (equal_1355 ? last_q : 7'h0);
  logic [7:0] select_1371;
  assign select_1371 = equal_377 ? {1'b0, last_q} : (equal_380 ? select_1367 : {1'b0, select_1369});
  logic [7:0] select_1376;
  assign select_1376 = equal_380 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_382 ? first_beats_q : (equal_1355 ? whole_beats_q : 8'h0));
  logic [5:0] select_1382;
  assign select_1382 = equal_380 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_382 ? (6'h0 - least_q[5:0]) : 6'h0);
  logic select_1389;
  assign select_1389 = equal_380 ? (next_last_shift_q & not_1354) : (equal_382 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1393;
  assign select_1393 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1397;
  assign select_1397 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:296
  logic less_1404;
  assign less_1404 = 7'h1c < column;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1407;
  assign select_1407 = and_357 ? (equal_1334 ? (less_1404 ? 7'h1d : column) : least_q) : least_q;
  // hls/stages/agreement.hpp:290
  logic [7:0] select_1410;
  assign select_1410 = equal_1334 ? (less_1404 ? ({1'b0, cfg_width_i[9:3]} + 8'hf1) : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1414;
  assign select_1414 = and_357 ? (equal_1334 ? {sum_1412, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:346
  logic not_1415;
  assign not_1415 = ~ends_q;
  // hls/stages/agreement.hpp:200
  logic [5:0] select_1416;
  assign select_1416 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1418;
  assign select_1418 = and_357 ? (equal_1334 ? 7'h0 : {select_1416, not_1415}) : {select_1416, not_1415};
  // hls/stages/agreement.hpp:200
  logic and_1420;
  assign and_1420 = not_1415 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:306
  logic [6:0] sum_1423;
  assign sum_1423 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:290
  logic select_1425;
  assign select_1425 = equal_1334 ? ({sum_1423[6], cfg_height_i[8:3]} == {1'b0, sum_1423[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:645
  logic [5:0] sum_1612;
  assign sum_1612 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:153
  logic not_1959;
  assign not_1959 = ~run_shift_q[5];

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:916; read in stage 0, written in stage 5: 0 < 5 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_387;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:917; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (or_378 ? not_384 : select_471);
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:918; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_500;
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_379 & select_471);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 35 and parity, DISTANCE 12, hls/stages/agreement.hpp:919; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 36'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_378 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_526;
  logic [35:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [34:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[34:0];
  logic best_left_read_q, best_left_error;
  always_ff @(posedge clk_i) best_left_read_q <= rst_ni & best_left_re;
  assign best_left_error = best_left_read_q & ^best_left_word_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 3'h0;
      raster_at_y_q <= 3'h0;
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 6'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      raster_final_row_q <= 1'b0;
      averager_place_q <= 9'h0;
      averager_running_mask_q <= 1'b0;
      run_phase_q <= 3'h0;
      run_lowest_q <= 8'h0;
      run_highest_q <= 8'h0;
      run_beats_q <= 8'h0;
      run_shift_q <= 6'h0;
      run_last_shift_q <= 1'b0;
      following_phase_q <= 3'h0;
      following_lowest_q <= 8'h0;
      following_highest_q <= 8'h0;
      following_beats_q <= 8'h0;
      following_shift_q <= 6'h0;
      following_last_shift_q <= 1'b0;
      x_q <= 8'h0;
      beats_left_q <= 8'h0;
      last_q <= 7'h0;
      least_q <= 7'h0;
      first_beats_q <= 8'h0;
      whole_beats_q <= 8'h0;
      age_q <= 7'h0;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
      next_lowest_q <= 8'h0;
      next_highest_q <= 8'h0;
      next_beats_q <= 8'h0;
      next_shift_q <= 6'h0;
      next_last_shift_q <= 1'b0;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_318 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_1147;
      raster_at_column_q <= select_1149;
      raster_at_row_q <= select_1152;
      raster_at_live_q <= select_1156;
      raster_rows_left_q <= sample_pair_whole_q ? select_1158 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_1162;
      averager_place_q <= sample_pair_whole_q ? select_324 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= and_357 ? (equal_1334 ? 3'h1 : select_1335) : select_1335;
      run_lowest_q <= and_357 ? (equal_1334 ? 8'h0 : select_1338) : select_1338;
      run_highest_q <= and_357 ? (equal_1334 ? 8'h0 : select_1341) : select_1341;
      run_beats_q <= and_357 ? (equal_1334 ? 8'hc : select_1344) : select_1344;
      run_shift_q <= and_357 ? (equal_1334 ? 6'h0 : select_1347) : select_1347;
      run_last_shift_q <= and_357 ? (select_1350 & not_1351) : select_1350;
      following_phase_q <= select_1359;
      following_lowest_q <= drew ? 8'h0 : select_1364;
      following_highest_q <= drew ? 8'h0 : select_1371;
      following_beats_q <= drew ? 8'h3f : (equal_377 ? whole_beats_q : select_1376);
      following_shift_q <= drew ? 6'h0 : (equal_377 ? 6'h0 : select_1382);
      following_last_shift_q <= not_972 & ((~equal_377) & select_1389);
      x_q <= and_357 ? (equal_1334 ? 8'h0 : select_1393) : select_1393;
      beats_left_q <= and_357 ? (equal_1334 ? 8'hc : select_1397) : select_1397;
      last_q <= and_357 ? (equal_1334 ? column : last_q) : last_q;
      least_q <= select_1407;
      first_beats_q <= and_357 ? select_1410 : first_beats_q;
      whole_beats_q <= select_1414;
      age_q <= select_1418;
      ends_q <= and_357 ? (and_1420 & not_1351) : and_1420;
      final_row_q <= and_357 ? select_1425 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1959}}, 1'b1} + run_beats_q;
      next_shift_q <= run_shift_q + 6'h1;
      next_last_shift_q <= {{3{run_shift_q[5]}}, run_shift_q} == ({2'h0, least_q} + 9'h1ff);
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic sample_pair_whole_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [2:0] age_s1_q;
  logic select_318_s1_q;
  logic [8:0] select_324_s1_q;
  logic and_331_s1_q;
  logic equal_337_s1_q;
  logic whole_s1_q;
  logic [6:0] column_s1_q;
  logic and_355_s1_q;
  logic and_357_s1_q;
  logic equal_360_s1_q;
  logic drew_s1_q;
  logic equal_377_s1_q;
  logic or_378_s1_q;
  logic equal_380_s1_q;
  logic less_383_s1_q;
  logic not_384_s1_q;
  logic and_387_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_526_s1_q;
  logic select_533_s1_q;
  logic equal_600_s1_q;
  logic and_923_s1_q;
  logic select_929_s1_q;
  logic equal_941_s1_q;
  logic not_972_s1_q;
  logic equal_1008_s1_q;
  logic not_1139_s1_q;
  logic equal_1334_s1_q;
  logic less_1613_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      age_s1_q <= {age_q[6], age_q[4:3]};
      select_318_s1_q <= select_318[0];
      select_324_s1_q <= select_324;
      and_331_s1_q <= and_331;
      equal_337_s1_q <= select_336 == 3'h0;
      whole_s1_q <= whole;
      column_s1_q <= column;
      and_355_s1_q <= and_355;
      and_357_s1_q <= and_357;
      equal_360_s1_q <= select_318 == 3'h1;
      drew_s1_q <= drew;
      equal_377_s1_q <= equal_377;
      or_378_s1_q <= or_378;
      equal_380_s1_q <= equal_380;
      less_383_s1_q <= less_383;
      not_384_s1_q <= not_384;
      and_387_s1_q <= and_387;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_526_s1_q <= select_526;
      select_533_s1_q <= or_531 ? equal_529 : (run_lowest_q == x);
      equal_600_s1_q <= run_lowest_q == x_q;
      and_923_s1_q <= not_379 & and_525;
      select_929_s1_q <= or_531 ? equal_529 : (run_highest_q == x);
      equal_941_s1_q <= run_phase_q == 3'h6;
      not_972_s1_q <= not_972;
      equal_1008_s1_q <= x_q == {1'b0, last_q};
      not_1139_s1_q <= ~({sum_1137, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1334_s1_q <= equal_1334;
      less_1613_s1_q <= {1'b0, sum_1612, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:414
  logic equal_474;
  assign equal_474 = row_q == 6'h0;
  logic [11:0] select_475;
  assign select_475 = equal_474 ? 12'h0 : left_rdata_q[11:0];
  logic not_476;
  assign not_476 = ~equal_474;
  logic and_477;
  assign and_477 = left_rdata_q[12] & not_476;
  logic and_478;
  assign and_478 = left_rdata_q[13] & not_476;
  logic and_479;
  assign and_479 = left_rdata_q[14] & not_476;
  logic and_480;
  assign and_480 = left_rdata_q[15] & not_476;
  logic equal_481;
  assign equal_481 = row_q[5:1] == 5'h0;
  logic [11:0] select_482;
  assign select_482 = equal_481 ? 12'h0 : left_rdata_q[27:16];
  logic not_483;
  assign not_483 = ~equal_481;
  logic and_484;
  assign and_484 = left_rdata_q[28] & not_483;
  logic and_485;
  assign and_485 = left_rdata_q[29] & not_483;
  logic and_486;
  assign and_486 = left_rdata_q[30] & not_483;
  logic and_487;
  assign and_487 = left_rdata_q[31] & not_483;
  logic less_488;
  assign less_488 = row_q < 6'h3;
  logic [11:0] select_489;
  assign select_489 = less_488 ? 12'h0 : left_rdata_q[43:32];
  logic not_490;
  assign not_490 = ~less_488;
  logic and_491;
  assign and_491 = left_rdata_q[44] & not_490;
  logic and_492;
  assign and_492 = left_rdata_q[45] & not_490;
  logic and_493;
  assign and_493 = left_rdata_q[46] & not_490;
  logic and_494;
  assign and_494 = left_rdata_q[47] & not_490;
  logic equal_495;
  assign equal_495 = row_q[5:2] == 4'h0;
  logic [11:0] select_496;
  assign select_496 = equal_495 ? 12'h0 : left_rdata_q[59:48];
  logic not_497;
  assign not_497 = ~equal_495;
  logic and_498;
  assign and_498 = left_rdata_q[60] & not_497;
  // hls/stages/agreement.hpp:415
  logic [11:0] select_503;
  assign select_503 = equal_474 ? 12'h0 : right_codes_rdata_q[11:0];
  logic and_504;
  assign and_504 = right_codes_rdata_q[12] & not_476;
  logic [11:0] select_505;
  assign select_505 = equal_481 ? 12'h0 : right_codes_rdata_q[24:13];
  logic and_506;
  assign and_506 = right_codes_rdata_q[25] & not_483;
  logic [11:0] select_507;
  assign select_507 = less_488 ? 12'h0 : right_codes_rdata_q[37:26];
  logic and_508;
  assign and_508 = right_codes_rdata_q[38] & not_490;
  logic [11:0] select_509;
  assign select_509 = equal_495 ? 12'h0 : right_codes_rdata_q[50:39];
  logic and_510;
  assign and_510 = right_codes_rdata_q[51] & not_497;
  logic less_511;
  assign less_511 = row_q < 6'h5;
  logic [11:0] select_512;
  assign select_512 = less_511 ? 12'h0 : right_codes_rdata_q[63:52];
  logic and_514;
  assign and_514 = right_codes_rdata_q[64] & (~less_511);
  logic less_515;
  assign less_515 = row_q[5:1] < 5'h3;
  logic [11:0] select_516;
  assign select_516 = less_515 ? 12'h0 : right_codes_rdata_q[76:65];
  logic and_518;
  assign and_518 = right_codes_rdata_q[77] & (~less_515);
  // hls/stages/agreement.hpp:170
  logic and_539;
  assign and_539 = left_rdata_q[44] & not_384_s1_q;
  logic [11:0] a;
  assign a = less_383_s1_q ? 12'h0 : left_rdata_q[43:32];
  logic [11:0] b;
  assign b = less_383_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_545;
  assign not_545 = ~(a ^ b);
  logic [1:0] sum_547;
  assign sum_547 = {1'b0, not_545[2]} + ({1'b0, not_545[0]} + {1'b0, not_545[1]});
  logic [2:0] sum_550;
  assign sum_550 = {2'h0, not_545[5]} + ({2'h0, not_545[4]} + ({2'h0, not_545[3]} + {1'b0, sum_547}));
  logic [2:0] sum_551;
  assign sum_551 = {2'h0, not_545[6]} + sum_550;
  logic [3:0] sum_554;
  assign sum_554 = {3'h0, not_545[9]} + ({3'h0, not_545[8]} + ({3'h0, not_545[7]} + {1'b0, sum_551}));
  // hls/stages/agreement.hpp:170
  logic [11:0] a_2;
  assign a_2 = less_383_s1_q ? 12'h0 : left_rdata_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_564;
  assign not_564 = ~(a_2 ^ b_2);
  logic [1:0] sum_566;
  assign sum_566 = {1'b0, not_564[2]} + ({1'b0, not_564[0]} + {1'b0, not_564[1]});
  logic [2:0] sum_569;
  assign sum_569 = {2'h0, not_564[5]} + ({2'h0, not_564[4]} + ({2'h0, not_564[3]} + {1'b0, sum_566}));
  logic [2:0] sum_570;
  assign sum_570 = {2'h0, not_564[6]} + sum_569;
  logic [3:0] sum_573;
  assign sum_573 = {3'h0, not_564[9]} + ({3'h0, not_564[8]} + ({3'h0, not_564[7]} + {1'b0, sum_570}));
  // hls/stages/agreement.hpp:170
  logic and_578;
  assign and_578 = left_rdata_q[76] & not_384_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_383_s1_q ? 12'h0 : left_rdata_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_584;
  assign not_584 = ~(a_3 ^ b_3);
  logic [1:0] sum_586;
  assign sum_586 = {1'b0, not_584[2]} + ({1'b0, not_584[0]} + {1'b0, not_584[1]});
  logic [2:0] sum_589;
  assign sum_589 = {2'h0, not_584[5]} + ({2'h0, not_584[4]} + ({2'h0, not_584[3]} + {1'b0, sum_586}));
  logic [2:0] sum_590;
  assign sum_590 = {2'h0, not_584[6]} + sum_589;
  logic [3:0] sum_593;
  assign sum_593 = {3'h0, not_584[9]} + ({3'h0, not_584[8]} + ({3'h0, not_584[7]} + {1'b0, sum_590}));
  logic [11:0] not_605;
  assign not_605 = ~(a ^ b_2);
  logic [1:0] sum_607;
  assign sum_607 = {1'b0, not_605[2]} + ({1'b0, not_605[0]} + {1'b0, not_605[1]});
  logic [2:0] sum_610;
  assign sum_610 = {2'h0, not_605[5]} + ({2'h0, not_605[4]} + ({2'h0, not_605[3]} + {1'b0, sum_607}));
  logic [2:0] sum_611;
  assign sum_611 = {2'h0, not_605[6]} + sum_610;
  logic [3:0] sum_614;
  assign sum_614 = {3'h0, not_605[9]} + ({3'h0, not_605[8]} + ({3'h0, not_605[7]} + {1'b0, sum_611}));
  logic [11:0] not_620;
  assign not_620 = ~(a_2 ^ b_3);
  logic [1:0] sum_622;
  assign sum_622 = {1'b0, not_620[2]} + ({1'b0, not_620[0]} + {1'b0, not_620[1]});
  logic [2:0] sum_625;
  assign sum_625 = {2'h0, not_620[5]} + ({2'h0, not_620[4]} + ({2'h0, not_620[3]} + {1'b0, sum_622}));
  logic [2:0] sum_626;
  assign sum_626 = {2'h0, not_620[6]} + sum_625;
  logic [3:0] sum_629;
  assign sum_629 = {3'h0, not_620[9]} + ({3'h0, not_620[8]} + ({3'h0, not_620[7]} + {1'b0, sum_626}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_4;
  assign b_4 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_638;
  assign not_638 = ~(a_3 ^ b_4);
  logic [1:0] sum_640;
  assign sum_640 = {1'b0, not_638[2]} + ({1'b0, not_638[0]} + {1'b0, not_638[1]});
  logic [2:0] sum_643;
  assign sum_643 = {2'h0, not_638[5]} + ({2'h0, not_638[4]} + ({2'h0, not_638[3]} + {1'b0, sum_640}));
  logic [2:0] sum_644;
  assign sum_644 = {2'h0, not_638[6]} + sum_643;
  logic [3:0] sum_647;
  assign sum_647 = {3'h0, not_638[9]} + ({3'h0, not_638[8]} + ({3'h0, not_638[7]} + {1'b0, sum_644}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_5;
  assign b_5 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_662;
  assign not_662 = ~(a ^ b_5);
  logic [1:0] sum_664;
  assign sum_664 = {1'b0, not_662[2]} + ({1'b0, not_662[0]} + {1'b0, not_662[1]});
  logic [2:0] sum_667;
  assign sum_667 = {2'h0, not_662[5]} + ({2'h0, not_662[4]} + ({2'h0, not_662[3]} + {1'b0, sum_664}));
  logic [2:0] sum_668;
  assign sum_668 = {2'h0, not_662[6]} + sum_667;
  logic [3:0] sum_671;
  assign sum_671 = {3'h0, not_662[9]} + ({3'h0, not_662[8]} + ({3'h0, not_662[7]} + {1'b0, sum_668}));
  logic [11:0] not_677;
  assign not_677 = ~(a_2 ^ b);
  logic [1:0] sum_679;
  assign sum_679 = {1'b0, not_677[2]} + ({1'b0, not_677[0]} + {1'b0, not_677[1]});
  logic [2:0] sum_682;
  assign sum_682 = {2'h0, not_677[5]} + ({2'h0, not_677[4]} + ({2'h0, not_677[3]} + {1'b0, sum_679}));
  logic [2:0] sum_683;
  assign sum_683 = {2'h0, not_677[6]} + sum_682;
  logic [3:0] sum_686;
  assign sum_686 = {3'h0, not_677[9]} + ({3'h0, not_677[8]} + ({3'h0, not_677[7]} + {1'b0, sum_683}));
  logic [11:0] not_693;
  assign not_693 = ~(a_3 ^ b_2);
  logic [1:0] sum_695;
  assign sum_695 = {1'b0, not_693[2]} + ({1'b0, not_693[0]} + {1'b0, not_693[1]});
  logic [2:0] sum_698;
  assign sum_698 = {2'h0, not_693[5]} + ({2'h0, not_693[4]} + ({2'h0, not_693[3]} + {1'b0, sum_695}));
  logic [2:0] sum_699;
  assign sum_699 = {2'h0, not_693[6]} + sum_698;
  logic [3:0] sum_702;
  assign sum_702 = {3'h0, not_693[9]} + ({3'h0, not_693[8]} + ({3'h0, not_693[7]} + {1'b0, sum_699}));
  logic [11:0] not_717;
  assign not_717 = ~(a ^ b_3);
  logic [1:0] sum_719;
  assign sum_719 = {1'b0, not_717[2]} + ({1'b0, not_717[0]} + {1'b0, not_717[1]});
  logic [2:0] sum_722;
  assign sum_722 = {2'h0, not_717[5]} + ({2'h0, not_717[4]} + ({2'h0, not_717[3]} + {1'b0, sum_719}));
  logic [2:0] sum_723;
  assign sum_723 = {2'h0, not_717[6]} + sum_722;
  logic [3:0] sum_726;
  assign sum_726 = {3'h0, not_717[9]} + ({3'h0, not_717[8]} + ({3'h0, not_717[7]} + {1'b0, sum_723}));
  logic [11:0] not_732;
  assign not_732 = ~(a_2 ^ b_4);
  logic [1:0] sum_734;
  assign sum_734 = {1'b0, not_732[2]} + ({1'b0, not_732[0]} + {1'b0, not_732[1]});
  logic [2:0] sum_737;
  assign sum_737 = {2'h0, not_732[5]} + ({2'h0, not_732[4]} + ({2'h0, not_732[3]} + {1'b0, sum_734}));
  logic [2:0] sum_738;
  assign sum_738 = {2'h0, not_732[6]} + sum_737;
  logic [3:0] sum_741;
  assign sum_741 = {3'h0, not_732[9]} + ({3'h0, not_732[8]} + ({3'h0, not_732[7]} + {1'b0, sum_738}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_6;
  assign b_6 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_750;
  assign not_750 = ~(a_3 ^ b_6);
  logic [1:0] sum_752;
  assign sum_752 = {1'b0, not_750[2]} + ({1'b0, not_750[0]} + {1'b0, not_750[1]});
  logic [2:0] sum_755;
  assign sum_755 = {2'h0, not_750[5]} + ({2'h0, not_750[4]} + ({2'h0, not_750[3]} + {1'b0, sum_752}));
  logic [2:0] sum_756;
  assign sum_756 = {2'h0, not_750[6]} + sum_755;
  logic [3:0] sum_759;
  assign sum_759 = {3'h0, not_750[9]} + ({3'h0, not_750[8]} + ({3'h0, not_750[7]} + {1'b0, sum_756}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_7;
  assign b_7 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_779;
  assign not_779 = ~(a ^ b_7);
  logic [1:0] sum_781;
  assign sum_781 = {1'b0, not_779[2]} + ({1'b0, not_779[0]} + {1'b0, not_779[1]});
  logic [2:0] sum_784;
  assign sum_784 = {2'h0, not_779[5]} + ({2'h0, not_779[4]} + ({2'h0, not_779[3]} + {1'b0, sum_781}));
  logic [2:0] sum_785;
  assign sum_785 = {2'h0, not_779[6]} + sum_784;
  logic [3:0] sum_788;
  assign sum_788 = {3'h0, not_779[9]} + ({3'h0, not_779[8]} + ({3'h0, not_779[7]} + {1'b0, sum_785}));
  logic [11:0] not_794;
  assign not_794 = ~(a_2 ^ b_5);
  logic [1:0] sum_796;
  assign sum_796 = {1'b0, not_794[2]} + ({1'b0, not_794[0]} + {1'b0, not_794[1]});
  logic [2:0] sum_799;
  assign sum_799 = {2'h0, not_794[5]} + ({2'h0, not_794[4]} + ({2'h0, not_794[3]} + {1'b0, sum_796}));
  logic [2:0] sum_800;
  assign sum_800 = {2'h0, not_794[6]} + sum_799;
  logic [3:0] sum_803;
  assign sum_803 = {3'h0, not_794[9]} + ({3'h0, not_794[8]} + ({3'h0, not_794[7]} + {1'b0, sum_800}));
  logic [11:0] not_810;
  assign not_810 = ~(a_3 ^ b);
  logic [1:0] sum_812;
  assign sum_812 = {1'b0, not_810[2]} + ({1'b0, not_810[0]} + {1'b0, not_810[1]});
  logic [2:0] sum_815;
  assign sum_815 = {2'h0, not_810[5]} + ({2'h0, not_810[4]} + ({2'h0, not_810[3]} + {1'b0, sum_812}));
  logic [2:0] sum_816;
  assign sum_816 = {2'h0, not_810[6]} + sum_815;
  logic [3:0] sum_819;
  assign sum_819 = {3'h0, not_810[9]} + ({3'h0, not_810[8]} + ({3'h0, not_810[7]} + {1'b0, sum_816}));
  // hls/stages/agreement.hpp:504
  logic [6:0] partner;
  assign partner = {run_shift_s1_q[5], run_shift_s1_q} + x_s1_2_q;
  // hls/stages/agreement.hpp:181
  logic [6:0] select_926;
  assign select_926 = or_378_s1_q ? (x_s1_q[6:0] + {best_left_rdata_q[13], best_left_rdata_q[13:8]}) : partner;
  // hls/stages/agreement.hpp:610
  logic and_945;
  assign and_945 = left_rdata_q[61] & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:343
  logic and_1141;
  assign and_1141 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1139_s1_q);
  // hls/stages/agreement.hpp:286
  logic [5:0] or_1281;
  assign or_1281 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:290
  logic select_1430;
  assign select_1430 = equal_1334_s1_q ? (~({row_s1_q, 1'b0} < {sum_1427, cfg_height_i[3]})) : lower_half_q;

  // Memory best_right, 80 x 15 and parity, DISTANCE 12, hls/stages/agreement.hpp:920; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [15:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 16'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = select_926;
  logic best_right_re;
  assign best_right_re = s1_en & select_526_s1_q;
  logic [15:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [14:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[14:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s1_q[6:0];
  logic left_we;
  assign left_we = s1_en & and_387_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_498, select_496, and_494, and_493, and_492, and_491, select_489, and_487, and_486, and_485, and_484, select_482, and_480, and_479, and_478, and_477, select_475, fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {^left_wdata, left_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 7'd80) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 7'd80) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [6:0] right_codes_waddr;
  assign right_codes_waddr = x_s1_q[6:0];
  logic right_codes_we;
  assign right_codes_we = s1_en & and_387_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_518, select_516, and_514, select_512, and_510, select_509, and_508, select_507, and_506, select_505, and_504, select_503, fresh_rdata_q[25], fresh_rdata_q[23:12]};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {^right_codes_wdata, right_codes_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 7'd80) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 7'd80) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 6'h0;
      lower_half_q <= 1'b0;
    end else if (s1_en) begin
      row_q <= and_357_s1_q ? (equal_1334_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_357_s1_q ? select_1430 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic sample_pair_whole_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [2:0] age_s2_q;
  logic lower_half_s2_q;
  logic select_318_s2_q;
  logic [8:0] select_324_s2_q;
  logic and_331_s2_q;
  logic equal_337_s2_q;
  logic whole_s2_q;
  logic [6:0] column_s2_q;
  logic and_355_s2_q;
  logic and_357_s2_q;
  logic equal_360_s2_q;
  logic drew_s2_q;
  logic equal_377_s2_q;
  logic or_378_s2_q;
  logic equal_380_s2_q;
  logic less_383_s2_q;
  logic not_384_s2_q;
  logic equal_416_s2_q;
  logic [6:0] x_s2_2_q;
  logic select_526_s2_q;
  logic [34:0] best_left_rdata_s2_q;
  logic select_533_s2_q;
  logic and_539_s2_q;
  logic and_540_s2_q;
  logic not_545_s2_q;
  logic [3:0] sum_555_s2_q;
  logic and_558_s2_q;
  logic and_559_s2_q;
  logic not_564_s2_q;
  logic [3:0] sum_574_s2_q;
  logic and_578_s2_q;
  logic and_579_s2_q;
  logic not_584_s2_q;
  logic [3:0] sum_594_s2_q;
  logic equal_600_s2_q;
  logic not_605_s2_q;
  logic [3:0] sum_615_s2_q;
  logic not_620_s2_q;
  logic [3:0] sum_630_s2_q;
  logic and_634_s2_q;
  logic not_638_s2_q;
  logic [3:0] sum_648_s2_q;
  logic and_658_s2_q;
  logic not_662_s2_q;
  logic [3:0] sum_672_s2_q;
  logic not_677_s2_q;
  logic [3:0] sum_687_s2_q;
  logic not_693_s2_q;
  logic [3:0] sum_703_s2_q;
  logic not_717_s2_q;
  logic [3:0] sum_727_s2_q;
  logic not_732_s2_q;
  logic [3:0] sum_742_s2_q;
  logic and_747_s2_q;
  logic not_750_s2_q;
  logic [3:0] sum_760_s2_q;
  logic and_776_s2_q;
  logic not_779_s2_q;
  logic [3:0] sum_789_s2_q;
  logic not_794_s2_q;
  logic [3:0] sum_804_s2_q;
  logic not_810_s2_q;
  logic [3:0] sum_820_s2_q;
  logic and_923_s2_q;
  logic [6:0] partner_s2_q;
  logic select_929_s2_q;
  logic equal_941_s2_q;
  logic and_946_s2_q;
  logic and_947_s2_q;
  logic and_949_s2_q;
  logic not_972_s2_q;
  logic equal_1008_s2_q;
  logic and_1141_s2_q;
  logic equal_1282_s2_q;
  logic equal_1334_s2_q;
  logic less_1611_s2_q;
  logic less_1613_s2_q;
  logic equal_1877_s2_q;
  logic less_1888_s2_q;
  logic equal_2031_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      age_s2_q <= age_s1_q;
      lower_half_s2_q <= lower_half_q;
      select_318_s2_q <= select_318_s1_q;
      select_324_s2_q <= select_324_s1_q;
      and_331_s2_q <= and_331_s1_q;
      equal_337_s2_q <= equal_337_s1_q;
      whole_s2_q <= whole_s1_q;
      column_s2_q <= column_s1_q;
      and_355_s2_q <= and_355_s1_q;
      and_357_s2_q <= and_357_s1_q;
      equal_360_s2_q <= equal_360_s1_q;
      drew_s2_q <= drew_s1_q;
      equal_377_s2_q <= equal_377_s1_q;
      or_378_s2_q <= or_378_s1_q;
      equal_380_s2_q <= equal_380_s1_q;
      less_383_s2_q <= less_383_s1_q;
      not_384_s2_q <= not_384_s1_q;
      equal_416_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      select_526_s2_q <= select_526_s1_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_533_s2_q <= select_533_s1_q;
      and_539_s2_q <= and_539;
      and_540_s2_q <= right_codes_rdata_q[38] & not_384_s1_q;
      not_545_s2_q <= not_545[11];
      sum_555_s2_q <= {3'h0, not_545[10]} + sum_554;
      and_558_s2_q <= left_rdata_q[60] & not_384_s1_q;
      and_559_s2_q <= right_codes_rdata_q[51] & not_384_s1_q;
      not_564_s2_q <= not_564[11];
      sum_574_s2_q <= {3'h0, not_564[10]} + sum_573;
      and_578_s2_q <= and_578;
      and_579_s2_q <= right_codes_rdata_q[64] & not_384_s1_q;
      not_584_s2_q <= not_584[11];
      sum_594_s2_q <= {3'h0, not_584[10]} + sum_593;
      equal_600_s2_q <= equal_600_s1_q;
      not_605_s2_q <= not_605[11];
      sum_615_s2_q <= {3'h0, not_605[10]} + sum_614;
      not_620_s2_q <= not_620[11];
      sum_630_s2_q <= {3'h0, not_620[10]} + sum_629;
      and_634_s2_q <= right_codes_rdata_q[77] & not_384_s1_q;
      not_638_s2_q <= not_638[11];
      sum_648_s2_q <= {3'h0, not_638[10]} + sum_647;
      and_658_s2_q <= right_codes_rdata_q[25] & not_384_s1_q;
      not_662_s2_q <= not_662[11];
      sum_672_s2_q <= {3'h0, not_662[10]} + sum_671;
      not_677_s2_q <= not_677[11];
      sum_687_s2_q <= {3'h0, not_677[10]} + sum_686;
      not_693_s2_q <= not_693[11];
      sum_703_s2_q <= {3'h0, not_693[10]} + sum_702;
      not_717_s2_q <= not_717[11];
      sum_727_s2_q <= {3'h0, not_717[10]} + sum_726;
      not_732_s2_q <= not_732[11];
      sum_742_s2_q <= {3'h0, not_732[10]} + sum_741;
      and_747_s2_q <= and_578 & (right_codes_rdata_q[90] & not_384_s1_q);
      not_750_s2_q <= not_750[11];
      sum_760_s2_q <= {3'h0, not_750[10]} + sum_759;
      and_776_s2_q <= and_539 & (right_codes_rdata_q[12] & not_384_s1_q);
      not_779_s2_q <= not_779[11];
      sum_789_s2_q <= {3'h0, not_779[10]} + sum_788;
      not_794_s2_q <= not_794[11];
      sum_804_s2_q <= {3'h0, not_794[10]} + sum_803;
      not_810_s2_q <= not_810[11];
      sum_820_s2_q <= {3'h0, not_810[10]} + sum_819;
      and_923_s2_q <= and_923_s1_q;
      partner_s2_q <= partner;
      select_929_s2_q <= select_929_s1_q;
      equal_941_s2_q <= equal_941_s1_q;
      and_946_s2_q <= not_384_s1_q & and_945;
      and_947_s2_q <= left_rdata_q[62] & and_945;
      and_949_s2_q <= left_rdata_q[63] & not_384_s1_q;
      not_972_s2_q <= not_972_s1_q;
      equal_1008_s2_q <= equal_1008_s1_q;
      and_1141_s2_q <= and_1141;
      equal_1282_s2_q <= {column_s1_q[6], or_1281} == 7'h0;
      equal_1334_s2_q <= equal_1334_s1_q;
      less_1611_s2_q <= 5'h4 < row_q[5:1];
      less_1613_s2_q <= less_1613_s1_q;
      equal_1877_s2_q <= row_s1_q[5:2] == 4'h0;
      less_1888_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2031_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_0_columns_values_0_q;
  logic [7:0] sums_0_columns_values_1_q;
  logic [7:0] sums_0_columns_values_2_q;
  logic [7:0] sums_0_columns_values_3_q;
  logic [7:0] sums_0_columns_values_4_q;
  logic [7:0] sums_0_columns_values_5_q;
  logic [7:0] sums_0_columns_values_6_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_1_columns_values_0_q;
  logic [7:0] sums_1_columns_values_1_q;
  logic [7:0] sums_1_columns_values_2_q;
  logic [7:0] sums_1_columns_values_3_q;
  logic [7:0] sums_1_columns_values_4_q;
  logic [7:0] sums_1_columns_values_5_q;
  logic [7:0] sums_1_columns_values_6_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_2_columns_values_0_q;
  logic [7:0] sums_2_columns_values_1_q;
  logic [7:0] sums_2_columns_values_2_q;
  logic [7:0] sums_2_columns_values_3_q;
  logic [7:0] sums_2_columns_values_4_q;
  logic [7:0] sums_2_columns_values_5_q;
  logic [7:0] sums_2_columns_values_6_q;
  logic [7:0] sums_2_sum_sums_values_0_q;
  logic [7:0] sums_3_columns_values_0_q;
  logic [7:0] sums_3_columns_values_1_q;
  logic [7:0] sums_3_columns_values_2_q;
  logic [7:0] sums_3_columns_values_3_q;
  logic [7:0] sums_3_columns_values_4_q;
  logic [7:0] sums_3_columns_values_5_q;
  logic [7:0] sums_3_columns_values_6_q;
  logic [7:0] sums_3_sum_sums_values_0_q;
  logic [7:0] sums_4_columns_values_0_q;
  logic [7:0] sums_4_columns_values_1_q;
  logic [7:0] sums_4_columns_values_2_q;
  logic [7:0] sums_4_columns_values_3_q;
  logic [7:0] sums_4_columns_values_4_q;
  logic [7:0] sums_4_columns_values_5_q;
  logic [7:0] sums_4_columns_values_6_q;
  logic [7:0] sums_4_sum_sums_values_0_q;
  // hls/stages/census.hpp:98
  logic and_332;
  assign and_332 = sample_pair_whole_s2_q & and_331_s2_q;
  // hls/stages/agreement.hpp:424
  logic [3:0] column_2;
  assign column_2 = (and_539_s2_q & and_540_s2_q) ? ({3'h0, not_545_s2_q} + sum_555_s2_q) : 4'h0;
  logic [3:0] select_576;
  assign select_576 = (and_558_s2_q & and_559_s2_q) ? ({3'h0, not_564_s2_q} + sum_574_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_3;
  assign column_3 = {1'b0, column_2} + {1'b0, select_576};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_596;
  assign select_596 = (and_578_s2_q & and_579_s2_q) ? ({3'h0, not_584_s2_q} + sum_594_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_4;
  assign column_4 = {1'b0, column_3} + {2'h0, select_596};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_599;
  assign difference_599 = {2'h0, column_4} - (age_s2_q[2] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_602;
  assign sum_602 = difference_599 + (equal_600_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:424
  logic [3:0] column_5;
  assign column_5 = (and_539_s2_q & and_559_s2_q) ? ({3'h0, not_605_s2_q} + sum_615_s2_q) : 4'h0;
  logic [3:0] select_632;
  assign select_632 = (and_558_s2_q & and_579_s2_q) ? ({3'h0, not_620_s2_q} + sum_630_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_6;
  assign column_6 = {1'b0, column_5} + {1'b0, select_632};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_650;
  assign select_650 = (and_578_s2_q & and_634_s2_q) ? ({3'h0, not_638_s2_q} + sum_648_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_7;
  assign column_7 = {1'b0, column_6} + {2'h0, select_650};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_653;
  assign difference_653 = {2'h0, column_7} - (age_s2_q[2] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_655;
  assign sum_655 = difference_653 + (equal_600_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:478
  logic less_656;
  assign less_656 = sum_602 < sum_655;
  // hls/stages/agreement.hpp:424
  logic [3:0] column_8;
  assign column_8 = (and_539_s2_q & and_658_s2_q) ? ({3'h0, not_662_s2_q} + sum_672_s2_q) : 4'h0;
  logic [3:0] select_689;
  assign select_689 = (and_558_s2_q & and_540_s2_q) ? ({3'h0, not_677_s2_q} + sum_687_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_9;
  assign column_9 = {1'b0, column_8} + {1'b0, select_689};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_705;
  assign select_705 = (and_578_s2_q & and_559_s2_q) ? ({3'h0, not_693_s2_q} + sum_703_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_10;
  assign column_10 = {1'b0, column_9} + {2'h0, select_705};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_708;
  assign difference_708 = {2'h0, column_10} - (age_s2_q[2] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_710;
  assign sum_710 = difference_708 + (equal_600_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:478
  logic not_712;
  assign not_712 = ~less_656;
  logic [1:0] best;
  assign best = ((less_656 ? sum_655 : sum_602) < sum_710) ? 2'h3 : {not_712, less_656};
  // hls/stages/agreement.hpp:424
  logic [3:0] column_11;
  assign column_11 = (and_539_s2_q & and_579_s2_q) ? ({3'h0, not_717_s2_q} + sum_727_s2_q) : 4'h0;
  logic [3:0] select_744;
  assign select_744 = (and_558_s2_q & and_634_s2_q) ? ({3'h0, not_732_s2_q} + sum_742_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_12;
  assign column_12 = {1'b0, column_11} + {1'b0, select_744};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_762;
  assign select_762 = and_747_s2_q ? ({3'h0, not_750_s2_q} + sum_760_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_13;
  assign column_13 = {1'b0, column_12} + {2'h0, select_762};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_765;
  assign difference_765 = {2'h0, column_13} - (age_s2_q[2] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_767;
  assign sum_767 = difference_765 + (equal_600_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:478
  logic [7:0] select_769;
  assign select_769 = best[1] ? (best[0] ? sum_710 : sum_602) : (best[0] ? sum_655 : sum_767);
  logic [1:0] best_2;
  assign best_2 = (select_769 < sum_767) ? 2'h0 : best;
  // hls/stages/agreement.hpp:424
  logic [3:0] column_14;
  assign column_14 = and_776_s2_q ? ({3'h0, not_779_s2_q} + sum_789_s2_q) : 4'h0;
  logic [3:0] select_806;
  assign select_806 = (and_558_s2_q & and_658_s2_q) ? ({3'h0, not_794_s2_q} + sum_804_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_15;
  assign column_15 = {1'b0, column_14} + {1'b0, select_806};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_822;
  assign select_822 = (and_578_s2_q & and_540_s2_q) ? ({3'h0, not_810_s2_q} + sum_820_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_16;
  assign column_16 = {1'b0, column_15} + {2'h0, select_822};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_825;
  assign difference_825 = {2'h0, column_16} - (age_s2_q[2] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_827;
  assign sum_827 = difference_825 + (equal_600_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_886;
  assign sum_886 = (age_s2_q[0] ? sums_2_columns_values_3_q[6:0] : 7'h0) + (sums_2_columns_values_1_q[6:0] + sums_2_columns_values_2_q[6:0]);
  logic [6:0] sum_889;
  assign sum_889 = (age_s2_q[0] ? sums_1_columns_values_3_q[6:0] : 7'h0) + (sums_1_columns_values_1_q[6:0] + sums_1_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:478
  logic less_890;
  assign less_890 = sum_886 < sum_889;
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_894;
  assign sum_894 = (age_s2_q[0] ? sums_3_columns_values_3_q[6:0] : 7'h0) + (sums_3_columns_values_1_q[6:0] + sums_3_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:478
  logic not_896;
  assign not_896 = ~less_890;
  logic [1:0] best_3;
  assign best_3 = ((less_890 ? sum_889 : sum_886) < sum_894) ? 2'h3 : {not_896, less_890};
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_901;
  assign sum_901 = (age_s2_q[0] ? sums_0_columns_values_3_q[6:0] : 7'h0) + (sums_0_columns_values_1_q[6:0] + sums_0_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:478
  logic [6:0] select_903;
  assign select_903 = best_3[1] ? (best_3[0] ? sum_894 : sum_886) : (best_3[0] ? sum_889 : sum_901);
  logic [1:0] best_4;
  assign best_4 = (select_903 < sum_901) ? 2'h0 : best_3;
  logic [6:0] select_908;
  assign select_908 = best_4[1] ? (best_4[0] ? sum_894 : sum_886) : (best_4[0] ? sum_889 : sum_901);
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_911;
  assign sum_911 = (age_s2_q[0] ? sums_4_columns_values_3_q[6:0] : 7'h0) + (sums_4_columns_values_1_q[6:0] + sums_4_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:478
  logic less_912;
  assign less_912 = select_908 < sum_911;
  logic [1:0] select_913;
  assign select_913 = less_912 ? 2'h0 : best_4;
  // hls/stages/agreement.hpp:487
  logic [6:0] select_916;
  assign select_916 = select_913[1] ? (select_913[0] ? sum_894 : sum_886) : (select_913[0] ? sum_889 : sum_901);
  logic [6:0] of_near;
  assign of_near = less_912 ? sum_911 : select_916;
  // hls/stages/agreement.hpp:606
  logic [6:0] sum_934;
  assign sum_934 = x_s2_q[6:0] + {best_left_rdata_s2_q[34], best_left_rdata_s2_q[34:29]};
  // hls/stages/agreement.hpp:621
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:622
  logic [9:0] sum_951;
  assign sum_951 = {way[8], way} + 10'h1;
  // hls/stages/agreement.hpp:613
  logic and_954;
  assign and_954 = ({{6{sum_951[9]}}, sum_951} < 16'h3) & (8'hb6 < best_left_rdata_s2_q[7:0]);
  // hls/stages/agreement.hpp:625
  logic and_959;
  assign and_959 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s2_q[13:8]));
  // hls/stages/agreement.hpp:174
  logic and_961;
  assign and_961 = and_954 & ((cfg_nearer_below_i & best_left_rdata_s2_q[13]) | and_959);
  // hls/stages/agreement.hpp:343
  logic [6:0] select_971;
  assign select_971 = drew_s2_q ? x_s2_q[6:0] : (or_378_s2_q ? (less_383_s2_q ? 7'h0 : sum_934) : 7'h0);
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1433;
  assign select_1433 = or_378_s2_q ? sums_0_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_13} : sums_0_columns_values_0_q);
  logic [7:0] select_1434;
  assign select_1434 = equal_380_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1436;
  assign select_1436 = equal_380_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1438;
  assign select_1438 = equal_380_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1440;
  assign select_1440 = equal_380_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1442;
  assign select_1442 = equal_380_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1444;
  assign select_1444 = equal_380_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1447;
  assign select_1447 = or_378_s2_q ? sums_0_sum_sums_values_0_q : (equal_380_s2_q ? sum_767 : sums_0_sum_sums_values_0_q);
  logic [7:0] select_1449;
  assign select_1449 = or_378_s2_q ? sums_1_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_7} : sums_1_columns_values_0_q);
  logic [7:0] select_1450;
  assign select_1450 = equal_380_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1452;
  assign select_1452 = equal_380_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1454;
  assign select_1454 = equal_380_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1456;
  assign select_1456 = equal_380_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1458;
  assign select_1458 = equal_380_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1460;
  assign select_1460 = equal_380_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1463;
  assign select_1463 = or_378_s2_q ? sums_1_sum_sums_values_0_q : (equal_380_s2_q ? sum_655 : sums_1_sum_sums_values_0_q);
  logic [7:0] select_1465;
  assign select_1465 = or_378_s2_q ? sums_2_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_4} : sums_2_columns_values_0_q);
  logic [7:0] select_1466;
  assign select_1466 = equal_380_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1468;
  assign select_1468 = equal_380_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1470;
  assign select_1470 = equal_380_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1472;
  assign select_1472 = equal_380_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1474;
  assign select_1474 = equal_380_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1476;
  assign select_1476 = equal_380_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1479;
  assign select_1479 = or_378_s2_q ? sums_2_sum_sums_values_0_q : (equal_380_s2_q ? sum_602 : sums_2_sum_sums_values_0_q);
  logic [7:0] select_1481;
  assign select_1481 = or_378_s2_q ? sums_3_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_10} : sums_3_columns_values_0_q);
  logic [7:0] select_1482;
  assign select_1482 = equal_380_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1484;
  assign select_1484 = equal_380_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1486;
  assign select_1486 = equal_380_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1488;
  assign select_1488 = equal_380_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1490;
  assign select_1490 = equal_380_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1492;
  assign select_1492 = equal_380_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1495;
  assign select_1495 = or_378_s2_q ? sums_3_sum_sums_values_0_q : (equal_380_s2_q ? sum_710 : sums_3_sum_sums_values_0_q);
  logic [7:0] select_1497;
  assign select_1497 = or_378_s2_q ? sums_4_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_16} : sums_4_columns_values_0_q);
  logic [7:0] select_1498;
  assign select_1498 = equal_380_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1500;
  assign select_1500 = equal_380_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1502;
  assign select_1502 = equal_380_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1504;
  assign select_1504 = equal_380_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1506;
  assign select_1506 = equal_380_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1508;
  assign select_1508 = equal_380_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  logic [7:0] select_1511;
  assign select_1511 = or_378_s2_q ? sums_4_sum_sums_values_0_q : (equal_380_s2_q ? sum_827 : sums_4_sum_sums_values_0_q);

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:146; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_324_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_332;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

  // Memory near_right, 80 x 14 and parity, DISTANCE 12, hls/stages/agreement.hpp:921; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] near_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) near_right_mem[i] = 15'h0;
`endif
  logic [6:0] near_right_raddr;
  assign near_right_raddr = or_378_s2_q ? sum_934 : partner_s2_q;
  logic near_right_re;
  assign near_right_re = s2_en & select_526_s2_q;
  logic [14:0] near_right_word_q;
  always_ff @(posedge clk_i) begin
    if (near_right_re) near_right_word_q <= near_right_mem[near_right_raddr];
  end
  logic [13:0] near_right_rdata_q;
  assign near_right_rdata_q = near_right_word_q[13:0];
  logic near_right_read_q, near_right_error;
  always_ff @(posedge clk_i) near_right_read_q <= rst_ni & near_right_re;
  assign near_right_error = near_right_read_q & ^near_right_word_q;

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_0_columns_values_0_q = 8'h0;
    sums_0_columns_values_1_q = 8'h0;
    sums_0_columns_values_2_q = 8'h0;
    sums_0_columns_values_3_q = 8'h0;
    sums_0_columns_values_4_q = 8'h0;
    sums_0_columns_values_5_q = 8'h0;
    sums_0_columns_values_6_q = 8'h0;
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_1_columns_values_0_q = 8'h0;
    sums_1_columns_values_1_q = 8'h0;
    sums_1_columns_values_2_q = 8'h0;
    sums_1_columns_values_3_q = 8'h0;
    sums_1_columns_values_4_q = 8'h0;
    sums_1_columns_values_5_q = 8'h0;
    sums_1_columns_values_6_q = 8'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_2_columns_values_0_q = 8'h0;
    sums_2_columns_values_1_q = 8'h0;
    sums_2_columns_values_2_q = 8'h0;
    sums_2_columns_values_3_q = 8'h0;
    sums_2_columns_values_4_q = 8'h0;
    sums_2_columns_values_5_q = 8'h0;
    sums_2_columns_values_6_q = 8'h0;
    sums_2_sum_sums_values_0_q = 8'h0;
    sums_3_columns_values_0_q = 8'h0;
    sums_3_columns_values_1_q = 8'h0;
    sums_3_columns_values_2_q = 8'h0;
    sums_3_columns_values_3_q = 8'h0;
    sums_3_columns_values_4_q = 8'h0;
    sums_3_columns_values_5_q = 8'h0;
    sums_3_columns_values_6_q = 8'h0;
    sums_3_sum_sums_values_0_q = 8'h0;
    sums_4_columns_values_0_q = 8'h0;
    sums_4_columns_values_1_q = 8'h0;
    sums_4_columns_values_2_q = 8'h0;
    sums_4_columns_values_3_q = 8'h0;
    sums_4_columns_values_4_q = 8'h0;
    sums_4_columns_values_5_q = 8'h0;
    sums_4_columns_values_6_q = 8'h0;
    sums_4_sum_sums_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      sums_0_columns_values_0_q <= select_1433;
      sums_0_columns_values_1_q <= or_378_s2_q ? sums_0_columns_values_1_q : select_1434;
      sums_0_columns_values_2_q <= or_378_s2_q ? sums_0_columns_values_2_q : select_1436;
      sums_0_columns_values_3_q <= or_378_s2_q ? sums_0_columns_values_3_q : select_1438;
      sums_0_columns_values_4_q <= or_378_s2_q ? sums_0_columns_values_4_q : select_1440;
      sums_0_columns_values_5_q <= or_378_s2_q ? sums_0_columns_values_5_q : select_1442;
      sums_0_columns_values_6_q <= or_378_s2_q ? sums_0_columns_values_6_q : select_1444;
      sums_0_sum_sums_values_0_q <= select_1447;
      sums_1_columns_values_0_q <= select_1449;
      sums_1_columns_values_1_q <= or_378_s2_q ? sums_1_columns_values_1_q : select_1450;
      sums_1_columns_values_2_q <= or_378_s2_q ? sums_1_columns_values_2_q : select_1452;
      sums_1_columns_values_3_q <= or_378_s2_q ? sums_1_columns_values_3_q : select_1454;
      sums_1_columns_values_4_q <= or_378_s2_q ? sums_1_columns_values_4_q : select_1456;
      sums_1_columns_values_5_q <= or_378_s2_q ? sums_1_columns_values_5_q : select_1458;
      sums_1_columns_values_6_q <= or_378_s2_q ? sums_1_columns_values_6_q : select_1460;
      sums_1_sum_sums_values_0_q <= select_1463;
      sums_2_columns_values_0_q <= select_1465;
      sums_2_columns_values_1_q <= or_378_s2_q ? sums_2_columns_values_1_q : select_1466;
      sums_2_columns_values_2_q <= or_378_s2_q ? sums_2_columns_values_2_q : select_1468;
      sums_2_columns_values_3_q <= or_378_s2_q ? sums_2_columns_values_3_q : select_1470;
      sums_2_columns_values_4_q <= or_378_s2_q ? sums_2_columns_values_4_q : select_1472;
      sums_2_columns_values_5_q <= or_378_s2_q ? sums_2_columns_values_5_q : select_1474;
      sums_2_columns_values_6_q <= or_378_s2_q ? sums_2_columns_values_6_q : select_1476;
      sums_2_sum_sums_values_0_q <= select_1479;
      sums_3_columns_values_0_q <= select_1481;
      sums_3_columns_values_1_q <= or_378_s2_q ? sums_3_columns_values_1_q : select_1482;
      sums_3_columns_values_2_q <= or_378_s2_q ? sums_3_columns_values_2_q : select_1484;
      sums_3_columns_values_3_q <= or_378_s2_q ? sums_3_columns_values_3_q : select_1486;
      sums_3_columns_values_4_q <= or_378_s2_q ? sums_3_columns_values_4_q : select_1488;
      sums_3_columns_values_5_q <= or_378_s2_q ? sums_3_columns_values_5_q : select_1490;
      sums_3_columns_values_6_q <= or_378_s2_q ? sums_3_columns_values_6_q : select_1492;
      sums_3_sum_sums_values_0_q <= select_1495;
      sums_4_columns_values_0_q <= select_1497;
      sums_4_columns_values_1_q <= or_378_s2_q ? sums_4_columns_values_1_q : select_1498;
      sums_4_columns_values_2_q <= or_378_s2_q ? sums_4_columns_values_2_q : select_1500;
      sums_4_columns_values_3_q <= or_378_s2_q ? sums_4_columns_values_3_q : select_1502;
      sums_4_columns_values_4_q <= or_378_s2_q ? sums_4_columns_values_4_q : select_1504;
      sums_4_columns_values_5_q <= or_378_s2_q ? sums_4_columns_values_5_q : select_1506;
      sums_4_columns_values_6_q <= or_378_s2_q ? sums_4_columns_values_6_q : select_1508;
      sums_4_sum_sums_values_0_q <= select_1511;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic [5:0] run_shift_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic lower_half_s3_q;
  logic select_318_s3_q;
  logic [8:0] select_324_s3_q;
  logic and_331_s3_q;
  logic and_332_s3_q;
  logic equal_337_s3_q;
  logic whole_s3_q;
  logic [6:0] column_s3_q;
  logic and_355_s3_q;
  logic and_357_s3_q;
  logic equal_360_s3_q;
  logic drew_s3_q;
  logic equal_377_s3_q;
  logic or_378_s3_q;
  logic less_383_s3_q;
  logic not_384_s3_q;
  logic equal_416_s3_q;
  logic [6:0] x_s3_2_q;
  logic [34:0] best_left_rdata_s3_q;
  logic select_533_s3_q;
  logic [7:0] sum_602_s3_q;
  logic [7:0] sum_655_s3_q;
  logic [7:0] sum_710_s3_q;
  logic [7:0] sum_767_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_827_s3_q;
  logic [6:0] of_near_s3_q;
  logic and_923_s3_q;
  logic [6:0] partner_s3_q;
  logic [14:0] best_right_rdata_s3_q;
  logic select_929_s3_q;
  logic equal_941_s3_q;
  logic and_946_s3_q;
  logic and_947_s3_q;
  logic and_949_s3_q;
  logic and_956_s3_q;
  logic and_963_s3_q;
  logic [6:0] select_971_s3_q;
  logic not_972_s3_q;
  logic equal_1008_s3_q;
  logic and_1141_s3_q;
  logic equal_1282_s3_q;
  logic equal_1334_s3_q;
  logic less_1611_s3_q;
  logic less_1613_s3_q;
  logic equal_1877_s3_q;
  logic less_1888_s3_q;
  logic equal_2031_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      run_shift_s3_q <= run_shift_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[1];
      lower_half_s3_q <= lower_half_s2_q;
      select_318_s3_q <= select_318_s2_q;
      select_324_s3_q <= select_324_s2_q;
      and_331_s3_q <= and_331_s2_q;
      and_332_s3_q <= and_332;
      equal_337_s3_q <= equal_337_s2_q;
      whole_s3_q <= whole_s2_q;
      column_s3_q <= column_s2_q;
      and_355_s3_q <= and_355_s2_q;
      and_357_s3_q <= and_357_s2_q;
      equal_360_s3_q <= equal_360_s2_q;
      drew_s3_q <= drew_s2_q;
      equal_377_s3_q <= equal_377_s2_q;
      or_378_s3_q <= or_378_s2_q;
      less_383_s3_q <= less_383_s2_q;
      not_384_s3_q <= not_384_s2_q;
      equal_416_s3_q <= equal_416_s2_q;
      x_s3_2_q <= x_s2_2_q;
      best_left_rdata_s3_q <= best_left_rdata_s2_q;
      select_533_s3_q <= select_533_s2_q;
      sum_602_s3_q <= sum_602;
      sum_655_s3_q <= sum_655;
      sum_710_s3_q <= sum_710;
      sum_767_s3_q <= sum_767;
      best_2_s3_q <= best_2;
      sum_827_s3_q <= sum_827;
      of_near_s3_q <= of_near;
      and_923_s3_q <= and_923_s2_q;
      partner_s3_q <= partner_s2_q;
      best_right_rdata_s3_q <= best_right_rdata_q;
      select_929_s3_q <= select_929_s2_q;
      equal_941_s3_q <= equal_941_s2_q;
      and_946_s3_q <= and_946_s2_q;
      and_947_s3_q <= and_947_s2_q;
      and_949_s3_q <= and_949_s2_q;
      and_956_s3_q <= not_384_s2_q & (and_947_s2_q & and_954);
      and_963_s3_q <= not_384_s2_q & (and_947_s2_q & and_961);
      select_971_s3_q <= select_971;
      not_972_s3_q <= not_972_s2_q;
      equal_1008_s3_q <= equal_1008_s2_q;
      and_1141_s3_q <= and_1141_s2_q;
      equal_1282_s3_q <= equal_1282_s2_q;
      equal_1334_s3_q <= equal_1334_s2_q;
      less_1611_s3_q <= less_1611_s2_q;
      less_1613_s3_q <= less_1613_s2_q;
      equal_1877_s3_q <= equal_1877_s2_q;
      less_1888_s3_q <= less_1888_s2_q;
      equal_2031_s3_q <= equal_2031_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [23:0] registration_next_slope_row_q;
  logic [27:0] registration_next_slope_change_q;
  // hls/stages/census.hpp:91
  logic [11:0] select_335;
  assign select_335 = select_318_s3_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:100
  logic [11:0] sum_339;
  assign sum_339 = select_335 + (equal_337_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:91
  logic [11:0] sum_341;
  assign sum_341 = {4'h0, sample_pair_pixel_1_q} + (select_318_s3_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:100
  logic [11:0] sum_343;
  assign sum_343 = sum_341 + (equal_337_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:101
  logic and_347;
  assign and_347 = whole_s3_q & (averager_memory_rdata_q[24] | equal_337_s3_q);
  // hls/stages/agreement.hpp:202
  logic all_of_skin;
  assign all_of_skin = select_318_s3_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:102
  logic and_351;
  assign and_351 = all_of_skin & (averager_memory_rdata_q[25] | equal_337_s3_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_331_s3_q ? sum_339[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_331_s3_q ? sum_343[11:3] : 9'h0;
  logic and_368;
  assign and_368 = and_331_s3_q & and_347;
  // hls/stages/census.hpp:105
  logic select_370;
  assign select_370 = equal_360_s3_q ? and_368 : (averager_mask_q & and_368);
  // hls/stages/agreement.hpp:204
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_370;
  // hls/stages/census.hpp:126
  logic and_372;
  assign and_372 = and_331_s3_q & and_351;
  // hls/stages/census.hpp:105
  logic select_374;
  assign select_374 = equal_360_s3_q ? and_372 : (averager_of_skin_q & and_372);
  // hls/stages/agreement.hpp:470
  logic not_535;
  assign not_535 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_536;
  assign less_536 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:170
  logic and_538;
  assign and_538 = not_535 & (~less_536);
  // hls/stages/agreement.hpp:478
  logic [7:0] select_774;
  assign select_774 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_710_s3_q : sum_602_s3_q) : (best_2_s3_q[0] ? sum_655_s3_q : sum_767_s3_q);
  logic less_828;
  assign less_828 = select_774 < sum_827_s3_q;
  logic [1:0] select_829;
  assign select_829 = less_828 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:486
  logic [7:0] select_832;
  assign select_832 = select_829[1] ? (select_829[0] ? sum_710_s3_q : sum_602_s3_q) : (select_829[0] ? sum_655_s3_q : sum_767_s3_q);
  logic [7:0] of_best;
  assign of_best = less_828 ? sum_827_s3_q : select_832;
  logic [7:0] of_best_2;
  assign of_best_2 = and_538 ? of_best : 8'h0;
  // hls/stages/agreement.hpp:493
  logic or_836;
  assign or_836 = select_533_s3_q | (best_left_rdata_s3_q[7:0] < of_best_2);
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_828, select_829} == 3'h4) ? 3'h3 : (({less_828, select_829} == 3'h0) ? 3'h1 : {less_828, select_829});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_844;
  assign sum_844 = near_best + 3'h1;
  logic [7:0] select_847;
  assign select_847 = sum_844[1] ? (sum_844[0] ? sum_710_s3_q : sum_602_s3_q) : (sum_844[0] ? sum_655_s3_q : sum_767_s3_q);
  logic [7:0] below;
  assign below = sum_844[2] ? sum_827_s3_q : select_847;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_849;
  assign sum_849 = near_best + 3'h7;
  logic [7:0] select_852;
  assign select_852 = sum_849[1] ? (sum_849[0] ? sum_710_s3_q : sum_602_s3_q) : (sum_849[0] ? sum_655_s3_q : sum_767_s3_q);
  logic [7:0] above;
  assign above = sum_849[2] ? sum_827_s3_q : select_852;
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/registration.hpp:26
  logic [7:0] select_858;
  assign select_858 = near_best[1] ? (near_best[0] ? sum_710_s3_q : sum_602_s3_q) : (near_best[0] ? sum_655_s3_q : sum_767_s3_q);
  logic [7:0] select_859;
  assign select_859 = near_best[2] ? sum_827_s3_q : select_858;
  logic [7:0] select_860;
  assign select_860 = rise[8] ? below : above;
  logic [8:0] fall;
  assign fall = {1'b0, select_859} - {1'b0, select_860};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [7:0] xor_863;
  assign xor_863 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_863};
  // hls/stages/agreement.hpp:487
  logic [6:0] of_near_2;
  assign of_near_2 = and_538 ? of_near_s3_q : 7'h0;
  // hls/stages/agreement.hpp:498
  logic or_920;
  assign or_920 = select_533_s3_q | (best_left_rdata_s3_q[28:22] < of_near_2);
  // hls/stages/agreement.hpp:507
  logic or_931;
  assign or_931 = select_929_s3_q | (best_right_rdata_s3_q[7:0] < of_best_2);
  // hls/stages/agreement.hpp:508
  logic [7:0] select_932;
  assign select_932 = or_931 ? of_best_2 : best_right_rdata_s3_q[7:0];
  logic [6:0] select_933;
  assign select_933 = or_931 ? x_s3_2_q : best_right_rdata_s3_q[14:8];
  // hls/stages/agreement.hpp:510
  logic or_938;
  assign or_938 = select_929_s3_q | (near_right_rdata_q[6:0] < of_near_2);
  // hls/stages/agreement.hpp:511
  logic [6:0] select_939;
  assign select_939 = or_938 ? of_near_2 : near_right_rdata_q[6:0];
  logic [6:0] select_940;
  assign select_940 = or_938 ? x_s3_2_q : near_right_rdata_q[13:7];
  // hls/stages/agreement.hpp:635
  logic not_942;
  assign not_942 = ~equal_941_s3_q;
  // hls/stages/agreement.hpp:618
  logic and_948;
  assign and_948 = not_384_s3_q & and_947_s3_q;
  // hls/stages/agreement.hpp:181
  logic [5:0] select_964;
  assign select_964 = less_383_s3_q ? 6'h0 : best_left_rdata_s3_q[13:8];
  logic [11:0] select_965;
  assign select_965 = or_378_s3_q ? {select_964, and_963_s3_q, and_956_s3_q, and_949_s3_q, and_948, and_946_s3_q, not_384_s3_q} : 12'h0;
  // hls/stages/agreement.hpp:343
  logic and_967;
  assign and_967 = not_942 & (drew_s3_q & select_965[0]);
  // hls/stages/agreement.hpp:621
  logic [8:0] way_2;
  assign way_2 = {2'h0, near_right_rdata_q[13:7]} - {1'b0, x_s3_q};
  // hls/stages/agreement.hpp:622
  logic [9:0] sum_974;
  assign sum_974 = {way_2[8], way_2} + 10'h1;
  // hls/stages/agreement.hpp:615
  logic and_977;
  assign and_977 = ({{6{sum_974[9]}}, sum_974} < 16'h3) & (6'h2a < best_left_rdata_s3_q[28:23]);
  // hls/stages/agreement.hpp:625
  logic and_980;
  assign and_980 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s3_q[34:29]));
  // hls/stages/agreement.hpp:174
  logic and_982;
  assign and_982 = and_977 & ((cfg_nearer_below_i & best_left_rdata_s3_q[34]) | and_980);
  // hls/stages/agreement.hpp:181
  logic and_989;
  assign and_989 = or_378_s3_q & (not_384_s3_q & (and_947_s3_q & and_977));
  // hls/stages/agreement.hpp:343
  logic and_992;
  assign and_992 = not_942 & (drew_s3_q ? select_965[0] : (equal_377_s3_q & and_989));
  // hls/stages/agreement.hpp:204
  logic select_1195;
  assign select_1195 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_1197;
  assign select_1197 = sample_pair_whole_s3_q ? (and_355_s3_q ? select_370 : averager_mask_q) : averager_mask_q;
  logic select_1199;
  assign select_1199 = sample_pair_whole_s3_q ? (and_355_s3_q ? select_374 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/registration.hpp:158
  logic [16:0] select_1620;
  assign select_1620 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [13:0] select_1622;
  assign select_1622 = ($signed(10'h0) < $signed(select_1620[16:7])) ? 14'h7f : select_1620[13:0];
  // hls/stages/registration.hpp:153
  logic [9:0] select_1623;
  assign select_1623 = select_965[10] ? select_1622[9:0] : 10'h0;
  logic [8:0] difference_1625;
  assign difference_1625 = select_1623[9:1] - (select_965[11] ? select_1622[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1628;
  assign sum_1628 = (select_965[6] ? select_1622[13:1] : 13'h0) + (select_965[7] ? select_1622[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1629;
  assign select_1629 = select_965[8] ? select_1622[11:0] : 12'h0;
  logic [10:0] sum_1631;
  assign sum_1631 = select_1629[11:1] + (select_965[9] ? select_1622[10:0] : 11'h0);
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1632;
  assign sum_1632 = sum_1628[12:1] + {sum_1631, select_1629[0]};
  logic [9:0] sum_1633;
  assign sum_1633 = {difference_1625, select_1623[0]} + sum_1632[11:2];
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1634;
  assign sum_1634 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_1633[9]}}, sum_1633[9:2]};
  // hls/stages/registration.hpp:151
  logic [7:0] select_1637;
  assign select_1637 = ($signed(sum_1634[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1634[7:0];
  logic [7:0] slope;
  assign slope = ($signed(6'h0) < $signed(sum_1634[12:7])) ? 8'h7f : select_1637;
  logic [6:0] select_1639;
  assign select_1639 = select_965[6] ? slope[7:1] : 7'h0;
  logic [7:0] select_1640;
  assign select_1640 = select_965[7] ? slope : 8'h0;
  logic [8:0] sum_1641;
  assign sum_1641 = {{2{select_1639[6]}}, select_1639} + {select_1640[7], select_1640};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1642;
  assign select_1642 = select_965[8] ? slope : 8'h0;
  logic [7:0] select_1643;
  assign select_1643 = select_965[9] ? slope : 8'h0;
  logic [8:0] sum_1644;
  assign sum_1644 = {{2{select_1642[7]}}, select_1642[7:1]} + {select_1643[7], select_1643};
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1645;
  assign sum_1645 = {{3{sum_1641[8]}}, sum_1641[8:1]} + {sum_1644[8], sum_1644, select_1642[0]};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1646;
  assign select_1646 = select_965[10] ? slope : 8'h0;
  logic [7:0] select_1647;
  assign select_1647 = select_965[11] ? slope : 8'h0;
  logic [8:0] difference_1648;
  assign difference_1648 = {{2{select_1646[7]}}, select_1646[7:1]} - {select_1647[7], select_1647};
  // hls/stages/registration.hpp:57
  logic [23:0] select_1878;
  assign select_1878 = equal_1877_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:205
  logic [23:0] select_1880;
  assign select_1880 = and_357_s3_q ? (equal_1334_s3_q ? select_1878 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1881;
  assign select_1881 = equal_1877_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:205
  logic [27:0] select_1883;
  assign select_1883 = and_357_s3_q ? (equal_1334_s3_q ? select_1881 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1885;
  assign select_1885 = drew_s3_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1886;
  assign sum_1886 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1887;
  assign sum_1887 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

  // Memory census_memory, 80 x 78 and parity, DISTANCE 16, hls/stages/census.hpp:254; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [78:0] census_memory_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) census_memory_mem[i] = 79'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s3_q;
  logic census_memory_re;
  assign census_memory_re = s3_en & and_357_s3_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:922; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s3_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s3_en & and_967;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:953; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s3_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s3_en & and_967;
  logic [18:0] seen_columns_word_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_word_q <= seen_columns_mem[seen_columns_raddr];
  end
  logic [17:0] seen_columns_rdata_q;
  assign seen_columns_rdata_q = seen_columns_word_q[17:0];
  logic seen_columns_read_q, seen_columns_error;
  always_ff @(posedge clk_i) seen_columns_read_q <= rst_ni & seen_columns_re;
  assign seen_columns_error = seen_columns_read_q & ^seen_columns_word_q;

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_324_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_332_s3_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_351, and_347, sum_343, sum_339};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {^averager_memory_wdata, averager_memory_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd320) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd320) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = partner_s3_q;
  logic best_right_we;
  assign best_right_we = s3_en & and_923_s3_q;
  logic [14:0] best_right_wdata;
  assign best_right_wdata = {select_933, select_932};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {^best_right_wdata, best_right_wdata};
  end
`ifndef SYNTHESIS
  logic [6:0] best_right_raddr_s2_sim;
  logic best_right_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      best_right_re_s2_sim <= best_right_re;
      best_right_raddr_s2_sim <= best_right_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s2_sim && best_right_raddr_s2_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 7'd80) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd80) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory near_right, write
  logic [6:0] near_right_waddr;
  assign near_right_waddr = partner_s3_q;
  logic near_right_we;
  assign near_right_we = s3_en & and_923_s3_q;
  logic [13:0] near_right_wdata;
  assign near_right_wdata = {select_940, select_939};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (near_right_we) near_right_mem[near_right_waddr] <= {^near_right_wdata, near_right_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && near_right_we) begin
      if (near_right_re && near_right_raddr == near_right_waddr) begin
        $error("near_right: address %0d is read less than DISTANCE steps after its write", near_right_waddr);
      end
      if (near_right_waddr >= 7'd80) $error("near_right: write outside, address %0d", near_right_waddr);
    end
    if (rst_ni && near_right_re && near_right_raddr >= 7'd80) $error("near_right: read outside, address %0d", near_right_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      sample_of_skin_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      registration_next_slope_row_q <= 24'h0;
      registration_next_slope_change_q <= 28'h0;
    end else if (s3_en) begin
      sample_pair_pixel_0_q <= pixel_0_s3_q;
      sample_pair_pixel_1_q <= pixel_1_s3_q;
      sample_of_skin_q <= mask_s3_q;
      averager_running_of_skin_q <= select_1195;
      averager_mask_q <= select_1197;
      averager_of_skin_q <= select_1199;
      registration_slope_row_q <= select_1880;
      registration_slope_change_q <= select_1883;
      registration_slope_q <= select_1885;
      registration_next_slope_row_q <= sum_1886;
      registration_next_slope_change_q <= sum_1887;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_running_0_q = 12'h0;
    averager_running_1_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      averager_running_0_q <= sample_pair_whole_s3_q ? select_335 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_341 : averager_running_1_q;
    end
  end

  logic saturated_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic sample_pair_whole_s4_q;
  logic [7:0] x_s4_q;
  logic age_s4_q;
  logic lower_half_s4_q;
  logic [6:0] column_s4_q;
  logic and_355_s4_q;
  logic and_357_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_360_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic and_375_s4_q;
  logic drew_s4_q;
  logic or_378_s4_q;
  logic less_383_s4_q;
  logic equal_416_s4_q;
  logic [6:0] x_s4_2_q;
  logic [7:0] best_left_rdata_s4_q;
  logic select_829_s4_q;
  logic or_836_s4_q;
  logic [7:0] select_837_s4_q;
  logic [5:0] select_838_s4_q;
  logic equal_843_s4_q;
  logic rise_s4_q;
  logic [1:0] sum_855_s4_q;
  logic [7:0] twice_s4_q;
  logic [8:0] difference_867_s4_q;
  logic [6:0] select_921_s4_q;
  logic [5:0] select_922_s4_q;
  logic and_923_s4_q;
  logic equal_941_s4_q;
  logic not_942_s4_q;
  logic [5:0] select_965_s4_q;
  logic and_967_s4_q;
  logic [6:0] select_971_s4_q;
  logic not_972_s4_q;
  logic and_985_s4_q;
  logic and_989_s4_q;
  logic and_992_s4_q;
  logic equal_1008_s4_q;
  logic and_1142_s4_q;
  logic equal_1282_s4_q;
  logic equal_1334_s4_q;
  logic less_1611_s4_q;
  logic less_1613_s4_q;
  logic [9:0] sum_1645_s4_q;
  logic select_1646_s4_q;
  logic [8:0] difference_1648_s4_q;
  logic less_1888_s4_q;
  logic equal_2031_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      saturated_s4_q <= saturated_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      x_s4_q <= x_s3_q;
      age_s4_q <= age_s3_q;
      lower_half_s4_q <= lower_half_s3_q;
      column_s4_q <= column_s3_q;
      and_355_s4_q <= and_355_s3_q;
      and_357_s4_q <= and_357_s3_q;
      grey_s4_q <= grey;
      equal_360_s4_q <= equal_360_s3_q;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      and_375_s4_q <= sample_pair_whole_s3_q & select_374;
      drew_s4_q <= drew_s3_q;
      or_378_s4_q <= or_378_s3_q;
      less_383_s4_q <= less_383_s3_q;
      equal_416_s4_q <= equal_416_s3_q;
      x_s4_2_q <= x_s3_2_q;
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      select_829_s4_q <= select_829[0];
      or_836_s4_q <= or_836;
      select_837_s4_q <= or_836 ? of_best_2 : best_left_rdata_s3_q[7:0];
      select_838_s4_q <= or_836 ? run_shift_s3_q : best_left_rdata_s3_q[13:8];
      equal_843_s4_q <= {less_828, select_829} == near_best;
      rise_s4_q <= rise[8];
      sum_855_s4_q <= {less_828, select_829[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_867_s4_q <= {1'b0, twice} - (({twice, 1'b0} < size) ? {twice, 1'b0} : size);
      select_921_s4_q <= or_920 ? of_near_2 : best_left_rdata_s3_q[28:22];
      select_922_s4_q <= or_920 ? run_shift_s3_q : best_left_rdata_s3_q[34:29];
      and_923_s4_q <= and_923_s3_q;
      equal_941_s4_q <= equal_941_s3_q;
      not_942_s4_q <= not_942;
      select_965_s4_q <= select_965[5:0];
      and_967_s4_q <= and_967;
      select_971_s4_q <= select_971_s3_q;
      not_972_s4_q <= not_972_s3_q;
      and_985_s4_q <= or_378_s3_q & (not_384_s3_q & (and_947_s3_q & and_982));
      and_989_s4_q <= and_989;
      and_992_s4_q <= and_992;
      equal_1008_s4_q <= equal_1008_s3_q;
      and_1142_s4_q <= not_942 & and_1141_s3_q;
      equal_1282_s4_q <= equal_1282_s3_q;
      equal_1334_s4_q <= equal_1334_s3_q;
      less_1611_s4_q <= less_1611_s3_q;
      less_1613_s4_q <= less_1613_s3_q;
      sum_1645_s4_q <= sum_1645[10:1];
      select_1646_s4_q <= select_1646[0];
      difference_1648_s4_q <= difference_1648;
      less_1888_s4_q <= less_1888_s3_q;
      equal_2031_s4_q <= equal_2031_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic [8:0] census_columns_values_0_cell_0_left_q;
  logic [8:0] census_columns_values_0_cell_0_right_q;
  logic census_columns_values_0_cell_0_mask_q;
  logic [8:0] census_columns_values_0_cell_1_left_q;
  logic [8:0] census_columns_values_0_cell_1_right_q;
  logic census_columns_values_0_cell_1_mask_q;
  logic [8:0] census_columns_values_0_cell_2_left_q;
  logic [8:0] census_columns_values_0_cell_2_right_q;
  logic census_columns_values_0_cell_2_mask_q;
  logic census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] census_columns_values_0_cell_3_left_q;
  logic [8:0] census_columns_values_0_cell_3_right_q;
  logic census_columns_values_0_cell_3_mask_q;
  logic [8:0] census_columns_values_0_cell_4_left_q;
  logic [8:0] census_columns_values_0_cell_4_right_q;
  logic census_columns_values_0_cell_4_mask_q;
  logic [8:0] census_columns_values_1_cell_0_left_q;
  logic [8:0] census_columns_values_1_cell_0_right_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic [8:0] census_columns_values_1_cell_1_left_q;
  logic [8:0] census_columns_values_1_cell_1_right_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic [8:0] census_columns_values_1_cell_2_left_q;
  logic [8:0] census_columns_values_1_cell_2_right_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] census_columns_values_1_cell_3_left_q;
  logic [8:0] census_columns_values_1_cell_3_right_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic [8:0] census_columns_values_1_cell_4_left_q;
  logic [8:0] census_columns_values_1_cell_4_right_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic [8:0] census_columns_values_2_cell_0_left_q;
  logic [8:0] census_columns_values_2_cell_0_right_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic [8:0] census_columns_values_2_cell_1_left_q;
  logic [8:0] census_columns_values_2_cell_1_right_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [8:0] census_columns_values_2_cell_2_left_q;
  logic [8:0] census_columns_values_2_cell_2_right_q;
  logic census_columns_values_2_cell_2_mask_q;
  logic [8:0] census_columns_values_2_cell_3_left_q;
  logic [8:0] census_columns_values_2_cell_3_right_q;
  logic census_columns_values_2_cell_3_mask_q;
  logic [8:0] census_columns_values_2_cell_4_left_q;
  logic [8:0] census_columns_values_2_cell_4_right_q;
  logic census_columns_values_2_cell_4_mask_q;
  logic census_columns_values_3_cell_0_mask_q;
  logic [8:0] census_columns_values_3_cell_1_left_q;
  logic [8:0] census_columns_values_3_cell_1_right_q;
  logic census_columns_values_3_cell_1_mask_q;
  logic census_columns_values_3_cell_2_mask_q;
  logic [8:0] census_columns_values_3_cell_3_left_q;
  logic [8:0] census_columns_values_3_cell_3_right_q;
  logic census_columns_values_3_cell_3_mask_q;
  logic census_columns_values_3_cell_4_mask_q;
  logic [3:0] census_filled_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
  logic [23:0] counts_too_much_hidden_q;
  logic [11:0] registration_counts_measured_0_q;
  logic [11:0] registration_counts_measured_1_q;
  logic [11:0] registration_counts_measured_2_q;
  logic [11:0] registration_counts_measured_3_q;
  logic [14:0] registration_counts_votes_0_down_q;
  logic [14:0] registration_counts_votes_0_up_q;
  logic [14:0] registration_counts_votes_1_down_q;
  logic [14:0] registration_counts_votes_1_up_q;
  logic [14:0] registration_counts_votes_2_down_q;
  logic [14:0] registration_counts_votes_2_up_q;
  logic [14:0] registration_counts_votes_3_down_q;
  logic [14:0] registration_counts_votes_3_up_q;
  logic [14:0] registration_counts_votes_4_down_q;
  logic [14:0] registration_counts_votes_4_up_q;
  logic [14:0] registration_counts_half_votes_0_down_q;
  logic [14:0] registration_counts_half_votes_0_up_q;
  logic [14:0] registration_counts_half_votes_1_down_q;
  logic [14:0] registration_counts_half_votes_1_up_q;
  logic [14:0] registration_counts_half_votes_2_down_q;
  logic [14:0] registration_counts_half_votes_2_up_q;
  logic [14:0] registration_counts_half_votes_3_down_q;
  logic [14:0] registration_counts_half_votes_3_up_q;
  logic [2:0] region_row_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  logic [8:0] region_down_rest_q;
  logic [6:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic region_fresh_q;
  logic segment_starts_q;
  logic [7:0] hidden_for_q;
  logic [7:0] next_hidden_for_q;
  logic [2:0] next_region_row_q;
  logic begins_product_q;
  logic [4:0] box_textured_columns_values_0_q;
  logic [4:0] box_textured_columns_values_1_q;
  logic [4:0] box_textured_columns_values_2_q;
  logic [4:0] box_textured_columns_values_3_q;
  logic [4:0] box_textured_columns_values_4_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [4:0] box_explained_columns_values_0_q;
  logic [4:0] box_explained_columns_values_1_q;
  logic [4:0] box_explained_columns_values_2_q;
  logic [4:0] box_explained_columns_values_3_q;
  logic [4:0] box_explained_columns_values_4_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [4:0] box_shown_columns_values_0_q;
  logic [4:0] box_shown_columns_values_1_q;
  logic [4:0] box_shown_columns_values_2_q;
  logic [4:0] box_shown_columns_values_3_q;
  logic [4:0] box_shown_columns_values_4_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [4:0] box_nearer_columns_values_0_q;
  logic [4:0] box_nearer_columns_values_1_q;
  logic [4:0] box_nearer_columns_values_2_q;
  logic [4:0] box_nearer_columns_values_3_q;
  logic [4:0] box_nearer_columns_values_4_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic proven_q;
  logic said_q;
  logic [17:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  logic began_q;
  logic [2:0] seen_x_q;
  logic [2:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey_s4_q} + (equal_360_s4_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:204
  logic [8:0] select_363;
  assign select_363 = sample_pair_whole_s4_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s4_q} + (equal_360_s4_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:204
  logic [8:0] select_367;
  assign select_367 = sample_pair_whole_s4_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:214
  logic less_389;
  assign less_389 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_390;
  assign less_390 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_391;
  assign less_391 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_392;
  assign less_392 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_393;
  assign less_393 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_394;
  assign less_394 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_395;
  assign less_395 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_396;
  assign less_396 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_397;
  assign less_397 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_398;
  assign less_398 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_399;
  assign less_399 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_400;
  assign less_400 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_401;
  assign less_401 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_402;
  assign less_402 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_403;
  assign less_403 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_404;
  assign less_404 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_405;
  assign less_405 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_406;
  assign less_406 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_407;
  assign less_407 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_408;
  assign less_408 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_409;
  assign less_409 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_410;
  assign less_410 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_411;
  assign less_411 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_412;
  assign less_412 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:285
  logic equal_413;
  assign equal_413 = column_s4_q == 7'h0;
  logic [3:0] select_417;
  assign select_417 = equal_416_s4_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:286
  logic [4:0] select_418;
  assign select_418 = equal_413 ? {select_417, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_419;
  assign select_419 = equal_413 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:219
  logic and_420;
  assign and_420 = select_418[4] & select_419[3];
  // hls/stages/census.hpp:206
  logic and_422;
  assign and_422 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s4_q);
  logic and_424;
  assign and_424 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_422);
  // hls/stages/agreement.hpp:286
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_424;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_q & whole_9;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_q & whole_16;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:190
  logic [9:0] difference_447;
  assign difference_447 = {1'b0, select_363} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_448;
  assign xor_448 = difference_447[8:0] ^ {9{difference_447[9]}};
  logic [9:0] sum_449;
  assign sum_449 = {9'h0, difference_447[9]} + {1'b0, xor_448};
  logic [9:0] difference_450;
  assign difference_450 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_451;
  assign xor_451 = difference_450[8:0] ^ {9{difference_450[9]}};
  logic [9:0] sum_452;
  assign sum_452 = {9'h0, difference_450[9]} + {1'b0, xor_451};
  logic [9:0] difference_454;
  assign difference_454 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_455;
  assign xor_455 = difference_454[8:0] ^ {9{difference_454[9]}};
  logic [9:0] sum_456;
  assign sum_456 = {9'h0, difference_454[9]} + {1'b0, xor_455};
  logic [10:0] sum_457;
  assign sum_457 = ({1'b0, sum_449} + {1'b0, sum_452}) + {1'b0, sum_456};
  logic [9:0] difference_458;
  assign difference_458 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_459;
  assign xor_459 = difference_458[8:0] ^ {9{difference_458[9]}};
  logic [9:0] sum_460;
  assign sum_460 = {9'h0, difference_458[9]} + {1'b0, xor_459};
  logic [9:0] difference_462;
  assign difference_462 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_463;
  assign xor_463 = difference_462[8:0] ^ {9{difference_462[9]}};
  logic [9:0] sum_464;
  assign sum_464 = {9'h0, difference_462[9]} + {1'b0, xor_463};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_457} + {2'h0, sum_460}) + {2'h0, sum_464};
  // hls/stages/registration.hpp:28
  logic not_868;
  assign not_868 = ~difference_867_s4_q[8];
  logic [7:0] xor_869;
  assign xor_869 = twice_s4_q ^ {8{not_868}};
  logic [9:0] sum_870;
  assign sum_870 = {difference_867_s4_q[7:0], 1'b0, not_868} + {not_868, xor_869, not_868};
  logic not_871;
  assign not_871 = ~sum_870[9];
  logic [7:0] xor_872;
  assign xor_872 = twice_s4_q ^ {8{not_871}};
  logic [9:0] sum_873;
  assign sum_873 = {sum_870[8:0], not_871} + {not_871, xor_872, not_871};
  logic not_874;
  assign not_874 = ~sum_873[9];
  logic [7:0] xor_875;
  assign xor_875 = twice_s4_q ^ {8{not_874}};
  logic [9:0] sum_876;
  assign sum_876 = {sum_873[8:0], not_874} + {not_874, xor_875, not_874};
  logic not_877;
  assign not_877 = ~sum_876[9];
  logic [7:0] xor_878;
  assign xor_878 = twice_s4_q ^ {8{not_877}};
  logic [9:0] sum_879;
  assign sum_879 = {sum_876[8:0], not_877} + {not_877, xor_878, not_877};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_880;
  assign difference_880 = {sum_855_s4_q, select_829_s4_q, 5'h0} - {3'h0, difference_867_s4_q[8], sum_870[9], sum_873[9], sum_876[9], sum_879[9]};
  // hls/stages/agreement.hpp:496
  logic [7:0] select_881;
  assign select_881 = rise_s4_q ? difference_880 : {sum_855_s4_q, select_829_s4_q, difference_867_s4_q[8], sum_870[9], sum_873[9], sum_876[9], sum_879[9]};
  logic [7:0] select_882;
  assign select_882 = equal_843_s4_q ? select_881 : {sum_855_s4_q, select_829_s4_q, 5'h0};
  // hls/stages/agreement.hpp:498
  logic [7:0] select_883;
  assign select_883 = or_836_s4_q ? select_882 : best_left_rdata_s4_q;
  // hls/stages/agreement.hpp:343
  logic and_986;
  assign and_986 = not_972_s4_q & and_985_s4_q;
  // hls/stages/agreement.hpp:147
  logic [7:0] select_993;
  assign select_993 = drew_s4_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:672
  logic or_996;
  assign or_996 = select_993[7] | (~({select_993[5], select_993[3], select_993[1]} == 3'h0));
  // hls/stages/agreement.hpp:671
  logic or_999;
  assign or_999 = select_993[7] | (~({select_993[6], select_993[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:670
  logic or_1002;
  assign or_1002 = select_993[7] | (~(select_993[6:4] == 3'h0));
  // hls/stages/agreement.hpp:343
  logic [5:0] select_1003;
  assign select_1003 = equal_941_s4_q ? x_s4_q[5:0] : {region_row_q, or_1002, or_999, or_996};
  // hls/stages/agreement.hpp:753
  logic equal_1004;
  assign equal_1004 = x_s4_q[5:4] == 2'h3;
  logic not_1005;
  assign not_1005 = ~equal_1004;
  // hls/stages/division.hpp:18
  logic [5:0] sum_1006;
  assign sum_1006 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:680
  logic or_1009;
  assign or_1009 = (~sum_1006[5]) | equal_1008_s4_q;
  // hls/stages/agreement.hpp:343
  logic and_1011;
  assign and_1011 = drew_s4_q & (select_965_s4_q[0] & or_1009);
  // hls/stages/agreement.hpp:186
  logic textured;
  assign textured = select_965_s4_q[0] & select_965_s4_q[2];
  logic explained;
  assign explained = select_965_s4_q[0] & select_965_s4_q[4];
  logic and_1025;
  assign and_1025 = select_965_s4_q[0] & ({select_965_s4_q[5], select_965_s4_q[3]} == 2'h3);
  logic and_1032;
  assign and_1032 = select_965_s4_q[0] & select_965_s4_q[3];
  logic shown;
  assign shown = select_965_s4_q[0] & (shown_right_rdata_q[0] | and_989_s4_q);
  logic near;
  assign near = select_965_s4_q[0] & (and_989_s4_q ? and_985_s4_q : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:846
  logic or_1037;
  assign or_1037 = marks_first_s4_q | line_ended_q;
  // hls/stages/agreement.hpp:848
  logic [17:0] select_1039;
  assign select_1039 = marks_first_s4_q ? 18'h1 : (or_1037 ? {rows_passed_q[16:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:847
  logic [8:0] select_1041;
  assign select_1041 = or_1037 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:855
  logic select_1043;
  assign select_1043 = cfg_compete_i ? (or_1037 & select_1039[17]) : (select_1041[8] & select_1039[9]);
  // hls/stages/agreement.hpp:206
  logic next_row;
  assign next_row = select_1043 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:862
  logic [6:0] select_1046;
  assign select_1046 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_1048;
  assign select_1048 = marks_first_s4_q ? 13'h0 : (seen_base_q + {6'h0, select_1046});
  // hls/stages/agreement.hpp:872
  logic equal_1049;
  assign equal_1049 = seen_x_q == 3'h7;
  logic [7:0] select_1051;
  assign select_1051 = select_1043 ? 8'h0 : (seen_column_q + {7'h0, equal_1049});
  // hls/stages/agreement.hpp:875
  logic [12:0] index;
  assign index = select_1048 + {5'h0, select_1051};
  // hls/stages/agreement.hpp:846
  logic select_1054;
  assign select_1054 = marks_first_s4_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:832
  logic [7:0] sum_1055;
  assign sum_1055 = {1'b0, select_1054, 2'h0, select_1054, 1'b0, {2{select_1054}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:845
  logic not_1056;
  assign not_1056 = ~marks_first_s4_q;
  // hls/stages/agreement.hpp:206
  logic and_1058;
  assign and_1058 = not_1056 & (began_q | select_1043);
  // hls/stages/agreement.hpp:873
  logic [2:0] select_1060;
  assign select_1060 = select_1043 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:874
  logic and_1062;
  assign and_1062 = and_1058 & (select_1060 == 3'h0);
  logic less_1063;
  assign less_1063 = select_1051 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:736
  logic [7:0] sum_1066;
  assign sum_1066 = {2'h0, x_s4_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1066[7]}}, sum_1066, x_s4_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:832
  logic [7:0] sum_1068;
  assign sum_1068 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:650
  logic and_1069;
  assign and_1069 = seen_columns_rdata_q[14] & select_965_s4_q[0];
  logic and_1070;
  assign and_1070 = seen_columns_rdata_q[10] & select_965_s4_q[0];
  logic and_1071;
  assign and_1071 = seen_columns_rdata_q[5] & select_965_s4_q[0];
  logic and_1072;
  assign and_1072 = seen_columns_rdata_q[0] & select_965_s4_q[0];
  // hls/stages/agreement.hpp:709
  logic [1:0] sum_1074;
  assign sum_1074 = {1'b0, and_1071} + ({1'b0, textured} + {1'b0, and_1072});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1069} + ({2'h0, and_1070} + {1'b0, sum_1074});
  // hls/stages/agreement.hpp:716
  logic [4:0] difference_1078;
  assign difference_1078 = {2'h0, textured_2} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:714
  logic equal_1079;
  assign equal_1079 = x_s4_q == 8'h0;
  // hls/stages/agreement.hpp:716
  logic [4:0] t;
  assign t = difference_1078 + (equal_1079 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:650
  logic [7:0] select_1084;
  assign select_1084 = select_965_s4_q[0] ? (sum_1006[5] ? select_993 : {select_993[6:0], 1'b0}) : select_993;
  // hls/stages/agreement.hpp:672
  logic or_1087;
  assign or_1087 = select_1084[7] | (~({select_1084[5], select_1084[3], select_1084[1]} == 3'h0));
  // hls/stages/agreement.hpp:650
  logic and_1103;
  assign and_1103 = seen_columns_rdata_q[16] & select_965_s4_q[0];
  logic and_1104;
  assign and_1104 = seen_columns_rdata_q[12] & select_965_s4_q[0];
  logic and_1105;
  assign and_1105 = seen_columns_rdata_q[8] & select_965_s4_q[0];
  logic and_1106;
  assign and_1106 = seen_columns_rdata_q[3] & select_965_s4_q[0];
  // hls/stages/agreement.hpp:711
  logic [1:0] sum_1108;
  assign sum_1108 = {1'b0, and_1105} + ({1'b0, shown} + {1'b0, and_1106});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1103} + ({2'h0, and_1104} + {1'b0, sum_1108});
  // hls/stages/agreement.hpp:718
  logic [4:0] difference_1112;
  assign difference_1112 = {2'h0, shown_2} - (age_s4_q ? box_shown_columns_values_4_q : 5'h0);
  logic [4:0] around;
  assign around = difference_1112 + (equal_1079 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:725
  logic [5:0] sum_1115;
  assign sum_1115 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:650
  logic and_1119;
  assign and_1119 = seen_columns_rdata_q[17] & select_965_s4_q[0];
  logic and_1120;
  assign and_1120 = seen_columns_rdata_q[13] & select_965_s4_q[0];
  logic and_1121;
  assign and_1121 = seen_columns_rdata_q[9] & select_965_s4_q[0];
  logic and_1122;
  assign and_1122 = seen_columns_rdata_q[4] & select_965_s4_q[0];
  // hls/stages/agreement.hpp:712
  logic [1:0] sum_1124;
  assign sum_1124 = {1'b0, and_1121} + ({1'b0, near} + {1'b0, and_1122});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1119} + ({2'h0, and_1120} + {1'b0, sum_1124});
  // hls/stages/agreement.hpp:719
  logic [4:0] difference_1128;
  assign difference_1128 = {2'h0, near_2} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1128 + (equal_1079 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:204
  logic [10:0] select_1174;
  assign select_1174 = sample_pair_whole_s4_q ? (and_355_s4_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1176;
  assign select_1176 = sample_pair_whole_s4_q ? (and_355_s4_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1200;
  assign select_1200 = and_357_s4_q ? select_363 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1201;
  assign select_1201 = and_357_s4_q ? select_367 : census_columns_values_0_cell_0_right_q;
  logic select_1202;
  assign select_1202 = and_357_s4_q ? whole_2_s4_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_1203;
  assign select_1203 = and_357_s4_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1204;
  assign select_1204 = and_357_s4_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1205;
  assign select_1205 = and_357_s4_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1206;
  assign select_1206 = and_357_s4_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1207;
  assign select_1207 = and_357_s4_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1208;
  assign select_1208 = and_357_s4_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1209;
  assign select_1209 = and_357_s4_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1210;
  assign select_1210 = and_357_s4_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1211;
  assign select_1211 = and_357_s4_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1212;
  assign select_1212 = and_357_s4_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1213;
  assign select_1213 = and_357_s4_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1214;
  assign select_1214 = and_357_s4_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1215;
  assign select_1215 = and_357_s4_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1216;
  assign select_1216 = and_357_s4_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1217;
  assign select_1217 = and_357_s4_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1218;
  assign select_1218 = and_357_s4_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1219;
  assign select_1219 = and_357_s4_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1220;
  assign select_1220 = and_357_s4_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1221;
  assign select_1221 = and_357_s4_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1222;
  assign select_1222 = and_357_s4_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1223;
  assign select_1223 = and_357_s4_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1224;
  assign select_1224 = and_357_s4_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1225;
  assign select_1225 = and_357_s4_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1226;
  assign select_1226 = and_357_s4_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1227;
  assign select_1227 = and_357_s4_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1228;
  assign select_1228 = and_357_s4_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1229;
  assign select_1229 = and_357_s4_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1230;
  assign select_1230 = and_357_s4_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1231;
  assign select_1231 = and_357_s4_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1232;
  assign select_1232 = and_357_s4_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1233;
  assign select_1233 = and_357_s4_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1234;
  assign select_1234 = and_357_s4_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1235;
  assign select_1235 = and_357_s4_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1236;
  assign select_1236 = and_357_s4_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1237;
  assign select_1237 = and_357_s4_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1238;
  assign select_1238 = and_357_s4_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1239;
  assign select_1239 = and_357_s4_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1240;
  assign select_1240 = and_357_s4_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1241;
  assign select_1241 = and_357_s4_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1242;
  assign select_1242 = and_357_s4_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1243;
  assign select_1243 = and_357_s4_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1244;
  assign select_1244 = and_357_s4_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1245;
  assign select_1245 = and_357_s4_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1246;
  assign select_1246 = and_357_s4_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1247;
  assign select_1247 = and_357_s4_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1248;
  assign select_1248 = and_357_s4_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1249;
  assign select_1249 = and_357_s4_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1250;
  assign select_1250 = and_357_s4_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1251;
  assign select_1251 = and_357_s4_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1252;
  assign select_1252 = and_357_s4_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1253;
  assign select_1253 = and_357_s4_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1254;
  assign select_1254 = and_357_s4_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1255;
  assign select_1255 = and_357_s4_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1257;
  assign difference_1257 = {1'b0, select_367} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1258;
  assign xor_1258 = difference_1257[8:0] ^ {9{difference_1257[9]}};
  logic [9:0] sum_1259;
  assign sum_1259 = {9'h0, difference_1257[9]} + {1'b0, xor_1258};
  logic [9:0] difference_1260;
  assign difference_1260 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1261;
  assign xor_1261 = difference_1260[8:0] ^ {9{difference_1260[9]}};
  logic [9:0] sum_1262;
  assign sum_1262 = {9'h0, difference_1260[9]} + {1'b0, xor_1261};
  logic [9:0] difference_1264;
  assign difference_1264 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1265;
  assign xor_1265 = difference_1264[8:0] ^ {9{difference_1264[9]}};
  logic [9:0] sum_1266;
  assign sum_1266 = {9'h0, difference_1264[9]} + {1'b0, xor_1265};
  logic [10:0] sum_1267;
  assign sum_1267 = ({1'b0, sum_1259} + {1'b0, sum_1262}) + {1'b0, sum_1266};
  logic [9:0] difference_1268;
  assign difference_1268 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1269;
  assign xor_1269 = difference_1268[8:0] ^ {9{difference_1268[9]}};
  logic [9:0] sum_1270;
  assign sum_1270 = {9'h0, difference_1268[9]} + {1'b0, xor_1269};
  logic [9:0] difference_1272;
  assign difference_1272 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1273;
  assign xor_1273 = difference_1272[8:0] ^ {9{difference_1272[9]}};
  logic [9:0] sum_1274;
  assign sum_1274 = {9'h0, difference_1272[9]} + {1'b0, xor_1273};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1302;
  assign difference_1302 = {1'b0, select_363} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1302[9]} + (difference_1302[8:0] ^ {9{difference_1302[9]}});
  logic [9:0] difference_1313;
  assign difference_1313 = {1'b0, select_367} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1313[9]} + (difference_1313[8:0] ^ {9{difference_1313[9]}});
  // hls/stages/agreement.hpp:205
  logic and_1513;
  assign and_1513 = and_357_s4_q & (equal_416_s4_q & equal_1334_s4_q);
  // hls/stages/agreement.hpp:343
  logic and_1516;
  assign and_1516 = not_942_s4_q & (drew_s4_q & (select_965_s4_q[0] & select_965_s4_q[1]));
  // hls/stages/agreement.hpp:650
  logic and_1533;
  assign and_1533 = seen_columns_rdata_q[15] & select_965_s4_q[0];
  logic and_1534;
  assign and_1534 = seen_columns_rdata_q[11] & select_965_s4_q[0];
  logic and_1535;
  assign and_1535 = seen_columns_rdata_q[7] & select_965_s4_q[0];
  logic and_1536;
  assign and_1536 = seen_columns_rdata_q[2] & select_965_s4_q[0];
  // hls/stages/agreement.hpp:710
  logic [1:0] sum_1538;
  assign sum_1538 = {1'b0, and_1535} + ({1'b0, explained} + {1'b0, and_1536});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_1533} + ({2'h0, and_1534} + {1'b0, sum_1538});
  // hls/stages/agreement.hpp:717
  logic [4:0] difference_1542;
  assign difference_1542 = {2'h0, explained_2} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_1542 + (equal_1079 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:724
  logic [5:0] sum_1545;
  assign sum_1545 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:644
  logic [9:0] select_1605;
  assign select_1605 = ({select_965_s4_q[3], select_965_s4_q[1]} == 2'h3) ? ({1'b0, select_965_s4_q[5], 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:343
  logic [9:0] select_1608;
  assign select_1608 = equal_941_s4_q ? 10'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1605 : 10'h0) : 10'h0);
  // hls/stages/agreement.hpp:566
  logic [23:0] select_1610;
  assign select_1610 = and_1513 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1608[9]}}, select_1608});
  // hls/stages/registration.hpp:73
  logic equal_1614;
  assign equal_1614 = {lower_half_s4_q, less_1613_s4_q} == 2'h3;
  logic equal_1615;
  assign equal_1615 = {lower_half_s4_q, less_1613_s4_q} == 2'h2;
  logic equal_1616;
  assign equal_1616 = {lower_half_s4_q, less_1613_s4_q} == 2'h1;
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1618;
  assign select_1618 = or_378_s4_q ? (less_383_s4_q ? 8'h0 : best_left_rdata_s4_q) : 8'h0;
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1649;
  assign sum_1649 = {difference_1648_s4_q, select_1646_s4_q} + {sum_1645_s4_q[9], sum_1645_s4_q[9:1]};
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1650;
  assign difference_1650 = {{4{select_1618[7]}}, select_1618} - {sum_1649[9], sum_1649, sum_1645_s4_q[0]};
  // hls/stages/registration.hpp:158
  logic [11:0] select_1652;
  assign select_1652 = ($signed(difference_1650[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1650;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1652[11:7])) ? 12'h7f : select_1652;
  // hls/stages/registration.hpp:73
  logic not_1692;
  assign not_1692 = ~equal_1614;
  logic not_1693;
  assign not_1693 = ~equal_1615;
  // hls/stages/agreement.hpp:186
  logic and_1698;
  assign and_1698 = select_965_s4_q[4] & (less_1611_s4_q & (not_1692 & (not_1693 & (~equal_1616))));
  // hls/stages/agreement.hpp:343
  logic and_1701;
  assign and_1701 = not_942_s4_q & (drew_s4_q & (select_965_s4_q[0] & and_1698));
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1703;
  assign select_1703 = and_1513 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1701});
  // hls/stages/agreement.hpp:186
  logic and_1707;
  assign and_1707 = select_965_s4_q[4] & (less_1611_s4_q & (not_1692 & (equal_1616 & not_1693)));
  // hls/stages/agreement.hpp:343
  logic and_1710;
  assign and_1710 = not_942_s4_q & (drew_s4_q & (select_965_s4_q[0] & and_1707));
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1712;
  assign select_1712 = and_1513 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1710});
  // hls/stages/agreement.hpp:186
  logic and_1716;
  assign and_1716 = select_965_s4_q[0] & (select_965_s4_q[4] & (less_1611_s4_q & (equal_1615 & not_1692)));
  // hls/stages/agreement.hpp:343
  logic and_1718;
  assign and_1718 = not_942_s4_q & (drew_s4_q & and_1716);
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1720;
  assign select_1720 = and_1513 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1718});
  // hls/stages/agreement.hpp:186
  logic and_1723;
  assign and_1723 = select_965_s4_q[0] & (select_965_s4_q[4] & (less_1611_s4_q & equal_1614));
  // hls/stages/agreement.hpp:343
  logic and_1725;
  assign and_1725 = not_942_s4_q & (drew_s4_q & and_1723);
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1727;
  assign select_1727 = and_1513 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1725});
  // hls/stages/registration.hpp:146
  logic less_1728;
  assign less_1728 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:186
  logic and_1729;
  assign and_1729 = less_1611_s4_q & less_1728;
  logic [1:0] select_1731;
  assign select_1731 = select_965_s4_q[0] ? (select_965_s4_q[4] ? {and_1729, less_1611_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1733;
  assign select_1733 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? select_1731 : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1734;
  assign sum_1734 = registration_counts_votes_0_down_q + {{13{select_1733[1]}}, select_1733};
  // hls/stages/registration.hpp:146
  logic [12:0] difference_1736;
  assign difference_1736 = 13'h0 - {residual[11], residual};
  logic less_1737;
  assign less_1737 = $signed(difference_1736) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:186
  logic and_1738;
  assign and_1738 = less_1611_s4_q & less_1737;
  logic [1:0] select_1740;
  assign select_1740 = select_965_s4_q[0] ? (select_965_s4_q[4] ? {and_1738, less_1611_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1742;
  assign select_1742 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? select_1740 : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1743;
  assign sum_1743 = registration_counts_votes_0_up_q + {{13{select_1742[1]}}, select_1742};
  // hls/stages/registration.hpp:80
  logic not_1745;
  assign not_1745 = ~less_1613_s4_q;
  // hls/stages/registration.hpp:79
  logic and_1746;
  assign and_1746 = less_1728 & not_1745;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1748;
  assign select_1748 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1746, not_1745} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1751;
  assign select_1751 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1748 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1752;
  assign sum_1752 = registration_counts_votes_1_down_q + {{13{select_1751[1]}}, select_1751};
  // hls/stages/registration.hpp:79
  logic and_1754;
  assign and_1754 = less_1737 & not_1745;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1756;
  assign select_1756 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1754, not_1745} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1759;
  assign select_1759 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1756 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1760;
  assign sum_1760 = registration_counts_votes_1_up_q + {{13{select_1759[1]}}, select_1759};
  // hls/stages/registration.hpp:79
  logic and_1762;
  assign and_1762 = less_1613_s4_q & less_1728;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1764;
  assign select_1764 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1762, less_1613_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1767;
  assign select_1767 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1764 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1768;
  assign sum_1768 = registration_counts_votes_2_down_q + {{13{select_1767[1]}}, select_1767};
  // hls/stages/registration.hpp:79
  logic and_1770;
  assign and_1770 = less_1613_s4_q & less_1737;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1772;
  assign select_1772 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1770, less_1613_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1775;
  assign select_1775 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1772 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1776;
  assign sum_1776 = registration_counts_votes_2_up_q + {{13{select_1775[1]}}, select_1775};
  // hls/stages/registration.hpp:80
  logic not_1778;
  assign not_1778 = ~lower_half_s4_q;
  // hls/stages/agreement.hpp:186
  logic and_1779;
  assign and_1779 = less_1728 & not_1778;
  logic [1:0] select_1781;
  assign select_1781 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1779, not_1778} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1784;
  assign select_1784 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1781 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1785;
  assign sum_1785 = registration_counts_votes_3_down_q + {{13{select_1784[1]}}, select_1784};
  // hls/stages/agreement.hpp:186
  logic and_1787;
  assign and_1787 = less_1737 & not_1778;
  logic [1:0] select_1789;
  assign select_1789 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1787, not_1778} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1792;
  assign select_1792 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1789 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1793;
  assign sum_1793 = registration_counts_votes_3_up_q + {{13{select_1792[1]}}, select_1792};
  // hls/stages/agreement.hpp:186
  logic and_1795;
  assign and_1795 = lower_half_s4_q & less_1728;
  logic [1:0] select_1797;
  assign select_1797 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1795, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1800;
  assign select_1800 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1797 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1801;
  assign sum_1801 = registration_counts_votes_4_down_q + {{13{select_1800[1]}}, select_1800};
  // hls/stages/agreement.hpp:186
  logic and_1803;
  assign and_1803 = lower_half_s4_q & less_1737;
  logic [1:0] select_1805;
  assign select_1805 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1803, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1808;
  assign select_1808 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1805 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1809;
  assign sum_1809 = registration_counts_votes_4_up_q + {{13{select_1808[1]}}, select_1808};
  // hls/stages/registration.hpp:146
  logic less_1811;
  assign less_1811 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1812;
  assign and_1812 = not_1745 & less_1811;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1814;
  assign select_1814 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1812, not_1745} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1817;
  assign select_1817 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1814 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1818;
  assign sum_1818 = registration_counts_half_votes_0_down_q + {{13{select_1817[1]}}, select_1817};
  // hls/stages/registration.hpp:146
  logic less_1820;
  assign less_1820 = $signed(difference_1736) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1821;
  assign and_1821 = not_1745 & less_1820;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1823;
  assign select_1823 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1821, not_1745} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1826;
  assign select_1826 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1823 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1827;
  assign sum_1827 = registration_counts_half_votes_0_up_q + {{13{select_1826[1]}}, select_1826};
  // hls/stages/registration.hpp:79
  logic and_1829;
  assign and_1829 = less_1613_s4_q & less_1811;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1831;
  assign select_1831 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1829, less_1613_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1834;
  assign select_1834 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1831 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1835;
  assign sum_1835 = registration_counts_half_votes_1_down_q + {{13{select_1834[1]}}, select_1834};
  // hls/stages/registration.hpp:79
  logic and_1837;
  assign and_1837 = less_1613_s4_q & less_1820;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1839;
  assign select_1839 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1837, less_1613_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1842;
  assign select_1842 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1839 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1843;
  assign sum_1843 = registration_counts_half_votes_1_up_q + {{13{select_1842[1]}}, select_1842};
  // hls/stages/agreement.hpp:186
  logic and_1845;
  assign and_1845 = less_1811 & not_1778;
  logic [1:0] select_1847;
  assign select_1847 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1845, not_1778} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1850;
  assign select_1850 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1847 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1851;
  assign sum_1851 = registration_counts_half_votes_2_down_q + {{13{select_1850[1]}}, select_1850};
  // hls/stages/agreement.hpp:186
  logic and_1853;
  assign and_1853 = less_1820 & not_1778;
  logic [1:0] select_1855;
  assign select_1855 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1853, not_1778} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1858;
  assign select_1858 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1855 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1859;
  assign sum_1859 = registration_counts_half_votes_2_up_q + {{13{select_1858[1]}}, select_1858};
  // hls/stages/agreement.hpp:186
  logic and_1861;
  assign and_1861 = lower_half_s4_q & less_1811;
  logic [1:0] select_1863;
  assign select_1863 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1861, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1866;
  assign select_1866 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1863 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1867;
  assign sum_1867 = registration_counts_half_votes_3_down_q + {{13{select_1866[1]}}, select_1866};
  // hls/stages/agreement.hpp:186
  logic and_1869;
  assign and_1869 = lower_half_s4_q & less_1820;
  logic [1:0] select_1871;
  assign select_1871 = select_965_s4_q[4] ? (less_1611_s4_q ? {and_1869, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1874;
  assign select_1874 = equal_941_s4_q ? 2'h0 : (drew_s4_q ? (select_965_s4_q[0] ? select_1871 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1875;
  assign sum_1875 = registration_counts_half_votes_3_up_q + {{13{select_1874[1]}}, select_1874};
  // hls/stages/division.hpp:34
  logic [7:0] sum_1889;
  assign sum_1889 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:290
  logic [2:0] select_1891;
  assign select_1891 = less_1888_s4_q ? (sum_1889[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1893;
  assign select_1893 = equal_1334_s4_q ? (equal_416_s4_q ? 3'h0 : select_1891) : region_row_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1897;
  assign sum_1897 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1898;
  assign select_1898 = sum_1006[5] ? {1'b1, sum_1006[4:0], region_across_rest_q[2:0]} : sum_1897;
  // hls/stages/agreement.hpp:290
  logic [8:0] select_1902;
  assign select_1902 = equal_1334_s4_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_1905;
  assign select_1905 = equal_1334_s4_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  logic [8:0] select_1909;
  assign select_1909 = equal_416_s4_q ? {{2{difference_1907[6]}}, difference_1907} : (less_1888_s4_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1911;
  assign select_1911 = and_357_s4_q ? (equal_1334_s4_q ? select_1909 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:290
  logic [6:0] select_1913;
  assign select_1913 = equal_416_s4_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1915;
  assign select_1915 = and_357_s4_q ? (equal_1334_s4_q ? select_1913 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1916;
  assign sum_1916 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1917;
  assign select_1917 = sum_1889[7] ? {1'b1, sum_1889[6:0], region_down_rest_q[0]} : sum_1916;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1889[7];
  // hls/stages/agreement.hpp:290
  logic select_1921;
  assign select_1921 = equal_1334_s4_q ? (equal_416_s4_q | (less_1888_s4_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:147
  logic or_1926;
  assign or_1926 = segment_starts_q | not_972_s4_q;
  // hls/stages/agreement.hpp:650
  logic select_1929;
  assign select_1929 = select_965_s4_q[0] ? (sum_1006[5] ? (equal_1008_s4_q & or_1009) : or_1009) : or_1926;
  // hls/stages/agreement.hpp:766
  logic equal_1933;
  assign equal_1933 = x_s4_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:768
  logic [7:0] select_1951;
  assign select_1951 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1953;
  assign select_1953 = equal_941_s4_q ? (equal_1933 ? select_1951 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:149
  logic not_1954;
  assign not_1954 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:343
  logic [4:0] select_1975;
  assign select_1975 = equal_941_s4_q ? box_textured_columns_values_0_q : (drew_s4_q ? {2'h0, textured_2} : box_textured_columns_values_0_q);
  logic [4:0] select_1976;
  assign select_1976 = drew_s4_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1978;
  assign select_1978 = drew_s4_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1980;
  assign select_1980 = drew_s4_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1982;
  assign select_1982 = drew_s4_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1985;
  assign select_1985 = equal_941_s4_q ? box_textured_sum_sums_values_0_q : (drew_s4_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1986;
  assign select_1986 = drew_s4_q ? {2'h0, explained_2} : box_explained_columns_values_0_q;
  logic [4:0] select_1988;
  assign select_1988 = drew_s4_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1990;
  assign select_1990 = drew_s4_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1992;
  assign select_1992 = drew_s4_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1994;
  assign select_1994 = drew_s4_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1997;
  assign select_1997 = equal_941_s4_q ? box_explained_sum_sums_values_0_q : (drew_s4_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1999;
  assign select_1999 = equal_941_s4_q ? box_shown_columns_values_0_q : (drew_s4_q ? {2'h0, shown_2} : box_shown_columns_values_0_q);
  logic [4:0] select_2000;
  assign select_2000 = drew_s4_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [4:0] select_2002;
  assign select_2002 = drew_s4_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [4:0] select_2004;
  assign select_2004 = drew_s4_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [4:0] select_2006;
  assign select_2006 = drew_s4_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [4:0] select_2009;
  assign select_2009 = equal_941_s4_q ? box_shown_sum_sums_values_0_q : (drew_s4_q ? around : box_shown_sum_sums_values_0_q);
  logic [4:0] select_2011;
  assign select_2011 = equal_941_s4_q ? box_nearer_columns_values_0_q : (drew_s4_q ? {2'h0, near_2} : box_nearer_columns_values_0_q);
  logic [4:0] select_2012;
  assign select_2012 = drew_s4_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_2014;
  assign select_2014 = drew_s4_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_2016;
  assign select_2016 = drew_s4_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_2018;
  assign select_2018 = drew_s4_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_2021;
  assign select_2021 = equal_941_s4_q ? box_nearer_sum_sums_values_0_q : (drew_s4_q ? n : box_nearer_sum_sums_values_0_q);
  logic select_2023;
  assign select_2023 = equal_941_s4_q ? centres_values_0_textured_q : (drew_s4_q ? and_1071 : centres_values_0_textured_q);
  logic select_2025;
  assign select_2025 = drew_s4_q ? (seen_columns_rdata_q[6] & select_965_s4_q[0]) : centres_values_0_of_skin_q;
  logic select_2027;
  assign select_2027 = drew_s4_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2029;
  assign select_2029 = drew_s4_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  // hls/stages/agreement.hpp:290
  logic [12:0] select_2034;
  assign select_2034 = equal_1334_s4_q ? (equal_2031_s4_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_2037;
  assign select_2037 = and_357_s4_q ? (equal_1334_s4_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:871
  logic [2:0] select_2048;
  assign select_2048 = select_1043 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:206
  logic [7:0] select_2054;
  assign select_2054 = marks_first_s4_q ? (less_2050 ? {sum_2051, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:875
  logic and_2060;
  assign and_2060 = and_1142_s4_q & ({sum_1068, index_2[5:0]} == {sum_1055, index[5:0]});
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2105;
  assign sum_2105 = {1'b0, upper} + {1'b0, lower};
  logic less_2106;
  assign less_2106 = 11'h4 < sum_2105[13:3];
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};
  // hls/stages/registration.hpp:100
  logic less_2109;
  assign less_2109 = 11'he < left[12:2];
  // hls/stages/registration.hpp:119
  logic less_2111;
  assign less_2111 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_2112;
  assign or_2112 = (~less_2109) | less_2111;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:100
  logic less_2114;
  assign less_2114 = 11'he < right[12:2];
  // hls/stages/registration.hpp:119
  logic less_2116;
  assign less_2116 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic select_2118;
  assign select_2118 = less_2106 ? (or_2112 ? less_2111 : less_2116) : less_2116;
  logic or_2119;
  assign or_2119 = (~less_2114) | select_2118;
  // hls/stages/registration.hpp:100
  logic less_2120;
  assign less_2120 = 11'he < upper[12:2];
  // hls/stages/registration.hpp:119
  logic less_2122;
  assign less_2122 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/registration.hpp:104
  logic select_2123;
  assign select_2123 = or_2119 ? select_2118 : less_2122;
  logic select_2125;
  assign select_2125 = less_2106 ? select_2123 : (less_2109 ? select_2123 : less_2122);
  logic or_2126;
  assign or_2126 = (~less_2120) | select_2125;
  // hls/stages/registration.hpp:119
  logic less_2127;
  assign less_2127 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_2128;
  assign select_2128 = or_2126 ? select_2125 : less_2127;
  logic select_2131;
  assign select_2131 = less_2106 ? select_2128 : (less_2109 ? select_2128 : (less_2114 ? select_2128 : less_2127));
  // hls/stages/registration.hpp:101
  logic less_2132;
  assign less_2132 = 11'he < lower[12:2];
  // hls/stages/registration.hpp:104
  logic or_2134;
  assign or_2134 = select_2131 | (~less_2132);
  // hls/stages/registration.hpp:119
  logic less_2135;
  assign less_2135 = $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
  // hls/stages/registration.hpp:105
  logic select_2136;
  assign select_2136 = or_2134 ? select_2131 : less_2135;
  logic select_2139;
  assign select_2139 = less_2109 ? select_2136 : (less_2114 ? select_2136 : (less_2120 ? select_2136 : less_2135));
  // hls/stages/agreement.hpp:770
  logic and_2151;
  assign and_2151 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2152;
  assign or_2152 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2151;
  logic select_2153;
  assign select_2153 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2152 : and_2151;
  logic and_2154;
  assign and_2154 = (less_2120 & less_2132) & select_2153;
  logic or_2155;
  assign or_2155 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2154;
  logic select_2156;
  assign select_2156 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2155 : and_2154;
  logic or_2157;
  assign or_2157 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2156;
  logic select_2158;
  assign select_2158 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2157 : select_2156;
  logic select_2159;
  assign select_2159 = (less_2109 & less_2114) ? select_2158 : and_2154;
  logic or_2160;
  assign or_2160 = (less_2106 ? select_2136 : select_2139) | select_2159;
  // hls/stages/registration.hpp:119
  logic less_2161;
  assign less_2161 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  // hls/stages/agreement.hpp:770
  logic or_2162;
  assign or_2162 = less_2161 | or_2160;
  logic select_2163;
  assign select_2163 = or_2134 ? or_2160 : or_2162;
  // hls/stages/registration.hpp:119
  logic less_2164;
  assign less_2164 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2167;
  assign less_2167 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2170;
  assign less_2170 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:770
  logic and_2203;
  assign and_2203 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1951 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:343
  logic [11:0] select_2216;
  assign select_2216 = equal_941_s4_q ? (equal_1933 ? registration_counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2218;
  assign select_2218 = equal_941_s4_q ? (equal_1933 ? registration_counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2220;
  assign select_2220 = equal_941_s4_q ? (equal_1933 ? registration_counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2222;
  assign select_2222 = equal_941_s4_q ? (equal_1933 ? registration_counts_measured_3_q : 12'h0) : 12'h0;

  // Memory regions, 64 x 36 and parity, DISTANCE 12, hls/stages/agreement.hpp:938; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [36:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 37'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1003;
  logic regions_re;
  assign regions_re = s4_en & (equal_941_s4_q ? not_1005 : and_1011);
  logic [36:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [35:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[35:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:957; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1055, index[5:0]};
  logic map_re;
  assign map_re = s4_en & (and_1062 & less_1063);
  logic [2:0] map_word_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_word_q <= map_mem[map_raddr];
  end
  logic [1:0] map_rdata_q;
  assign map_rdata_q = map_word_q[1:0];
  logic map_read_q, map_error;
  always_ff @(posedge clk_i) map_read_q <= rst_ni & map_re;
  assign map_error = map_read_q & ^map_word_q;

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s4_q;
  logic census_memory_we;
  assign census_memory_we = s4_en & and_357_s4_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_375_s4_q, whole_2_s4_q, select_367, select_363};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {^census_memory_wdata, census_memory_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd80) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd80) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s4_2_q;
  logic best_left_we;
  assign best_left_we = s4_en & and_923_s4_q;
  logic [34:0] best_left_wdata;
  assign best_left_wdata = {select_922_s4_q, select_921_s4_q, select_883, select_838_s4_q, select_837_s4_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {^best_left_wdata, best_left_wdata};
  end
`ifndef SYNTHESIS
  logic [6:0] best_left_raddr_s1_sim;
  logic best_left_re_s1_sim;
  logic [6:0] best_left_raddr_s2_sim;
  logic best_left_re_s2_sim;
  logic [6:0] best_left_raddr_s3_sim;
  logic best_left_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s1_sim <= 1'b0;
      best_left_re_s2_sim <= 1'b0;
      best_left_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s1_sim <= best_left_re;
      best_left_raddr_s1_sim <= best_left_raddr;
      best_left_re_s2_sim <= best_left_re_s1_sim;
      best_left_raddr_s2_sim <= best_left_raddr_s1_sim;
      best_left_re_s3_sim <= best_left_re_s2_sim;
      best_left_raddr_s3_sim <= best_left_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s1_sim && best_left_raddr_s1_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s2_sim && best_left_raddr_s2_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s3_sim && best_left_raddr_s3_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_waddr >= 7'd80) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 7'd80) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_971_s4_q;
  logic shown_right_we;
  assign shown_right_we = s4_en & and_992_s4_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_986, not_972_s4_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {^shown_right_wdata, shown_right_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 7'd80) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 7'd80) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s4_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s4_en & and_967_s4_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1032, textured};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {^seen_columns_wdata, seen_columns_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 7'd80) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 7'd80) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      counts_too_much_hidden_q <= 24'h0;
      registration_counts_measured_0_q <= 12'h0;
      registration_counts_measured_1_q <= 12'h0;
      registration_counts_measured_2_q <= 12'h0;
      registration_counts_measured_3_q <= 12'h0;
      registration_counts_votes_0_down_q <= 15'h0;
      registration_counts_votes_0_up_q <= 15'h0;
      registration_counts_votes_1_down_q <= 15'h0;
      registration_counts_votes_1_up_q <= 15'h0;
      registration_counts_votes_2_down_q <= 15'h0;
      registration_counts_votes_2_up_q <= 15'h0;
      registration_counts_votes_3_down_q <= 15'h0;
      registration_counts_votes_3_up_q <= 15'h0;
      registration_counts_votes_4_down_q <= 15'h0;
      registration_counts_votes_4_up_q <= 15'h0;
      registration_counts_half_votes_0_down_q <= 15'h0;
      registration_counts_half_votes_0_up_q <= 15'h0;
      registration_counts_half_votes_1_down_q <= 15'h0;
      registration_counts_half_votes_1_up_q <= 15'h0;
      registration_counts_half_votes_2_down_q <= 15'h0;
      registration_counts_half_votes_2_up_q <= 15'h0;
      registration_counts_half_votes_3_down_q <= 15'h0;
      registration_counts_half_votes_3_up_q <= 15'h0;
      region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 7'h0;
      region_down_next_q <= 9'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      hidden_for_q <= 8'h0;
      next_hidden_for_q <= 8'h0;
      next_region_row_q <= 3'h0;
      begins_product_q <= 1'b0;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      proven_q <= 1'b0;
      said_q <= 1'b0;
      rows_passed_q <= 18'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
      began_q <= 1'b0;
      seen_x_q <= 3'h0;
      seen_y_q <= 3'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 13'h0;
    end else if (s4_en) begin
      census_filled_q <= and_357_s4_q ? {select_419[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_357_s4_q ? select_418 : rows_passed_above_q;
      counts_too_much_hidden_q <= select_1610;
      registration_counts_measured_0_q <= select_1703;
      registration_counts_measured_1_q <= select_1712;
      registration_counts_measured_2_q <= select_1720;
      registration_counts_measured_3_q <= select_1727;
      registration_counts_votes_0_down_q <= and_1513 ? 15'h0 : sum_1734;
      registration_counts_votes_0_up_q <= and_1513 ? 15'h0 : sum_1743;
      registration_counts_votes_1_down_q <= and_1513 ? 15'h0 : sum_1752;
      registration_counts_votes_1_up_q <= and_1513 ? 15'h0 : sum_1760;
      registration_counts_votes_2_down_q <= and_1513 ? 15'h0 : sum_1768;
      registration_counts_votes_2_up_q <= and_1513 ? 15'h0 : sum_1776;
      registration_counts_votes_3_down_q <= and_1513 ? 15'h0 : sum_1785;
      registration_counts_votes_3_up_q <= and_1513 ? 15'h0 : sum_1793;
      registration_counts_votes_4_down_q <= and_1513 ? 15'h0 : sum_1801;
      registration_counts_votes_4_up_q <= and_1513 ? 15'h0 : sum_1809;
      registration_counts_half_votes_0_down_q <= and_1513 ? 15'h0 : sum_1818;
      registration_counts_half_votes_0_up_q <= and_1513 ? 15'h0 : sum_1827;
      registration_counts_half_votes_1_down_q <= and_1513 ? 15'h0 : sum_1835;
      registration_counts_half_votes_1_up_q <= and_1513 ? 15'h0 : sum_1843;
      registration_counts_half_votes_2_down_q <= and_1513 ? 15'h0 : sum_1851;
      registration_counts_half_votes_2_up_q <= and_1513 ? 15'h0 : sum_1859;
      registration_counts_half_votes_3_down_q <= and_1513 ? 15'h0 : sum_1867;
      registration_counts_half_votes_3_up_q <= and_1513 ? 15'h0 : sum_1875;
      region_row_q <= and_357_s4_q ? select_1893 : region_row_q;
      region_columns_q <= equal_941_s4_q ? select_993 : (drew_s4_q ? select_1084 : 8'h1);
      region_across_rest_q <= drew_s4_q ? select_1898 : columns_begin_rest_q;
      region_across_back_q <= drew_s4_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_357_s4_q ? select_1902 : columns_begin_rest_q;
      columns_begin_back_q <= and_357_s4_q ? select_1905 : columns_begin_back_q;
      region_down_rest_q <= select_1911;
      region_down_back_q <= select_1915;
      region_down_next_q <= select_1917;
      region_fresh_q <= and_357_s4_q ? select_1921 : region_fresh_q;
      segment_starts_q <= equal_941_s4_q ? or_1926 : (drew_s4_q ? select_1929 : or_1926);
      hidden_for_q <= select_1953;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1954};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s4_q;
      centres_values_0_textured_q <= select_2023;
      centres_values_0_of_skin_q <= equal_941_s4_q ? centres_values_0_of_skin_q : select_2025;
      centres_values_1_textured_q <= equal_941_s4_q ? centres_values_1_textured_q : select_2027;
      centres_values_1_of_skin_q <= equal_941_s4_q ? centres_values_1_of_skin_q : select_2029;
      map_row_q <= and_357_s4_q ? select_2034 : map_row_q;
      map_width_q <= select_2037;
      write_half_q <= marks_first_s4_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1054;
      done_q <= not_1056 & ((~begins_product_q) & (done_q | said_q));
      proven_q <= marks_first_s4_q ? done_q : proven_q;
      said_q <= equal_941_s4_q & equal_1933;
      rows_passed_q <= select_1039;
      columns_passed_q <= {select_1041[7:0], or_1037};
      line_ended_q <= marks_last_s4_q;
      began_q <= and_1058;
      seen_x_q <= select_1060;
      seen_y_q <= marks_first_s4_q ? 3'h0 : select_2048;
      seen_column_q <= select_1051;
      seen_rows_left_q <= select_2054;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_1048;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_total_0_q = 11'h0;
    averager_total_1_q = 11'h0;
    census_columns_values_0_cell_0_left_q = 9'h0;
    census_columns_values_0_cell_0_right_q = 9'h0;
    census_columns_values_0_cell_0_mask_q = 1'b0;
    census_columns_values_0_cell_1_left_q = 9'h0;
    census_columns_values_0_cell_1_right_q = 9'h0;
    census_columns_values_0_cell_1_mask_q = 1'b0;
    census_columns_values_0_cell_2_left_q = 9'h0;
    census_columns_values_0_cell_2_right_q = 9'h0;
    census_columns_values_0_cell_2_mask_q = 1'b0;
    census_columns_values_0_cell_2_of_skin_q = 1'b0;
    census_columns_values_0_cell_3_left_q = 9'h0;
    census_columns_values_0_cell_3_right_q = 9'h0;
    census_columns_values_0_cell_3_mask_q = 1'b0;
    census_columns_values_0_cell_4_left_q = 9'h0;
    census_columns_values_0_cell_4_right_q = 9'h0;
    census_columns_values_0_cell_4_mask_q = 1'b0;
    census_columns_values_1_cell_0_left_q = 9'h0;
    census_columns_values_1_cell_0_right_q = 9'h0;
    census_columns_values_1_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_1_left_q = 9'h0;
    census_columns_values_1_cell_1_right_q = 9'h0;
    census_columns_values_1_cell_1_mask_q = 1'b0;
    census_columns_values_1_cell_2_left_q = 9'h0;
    census_columns_values_1_cell_2_right_q = 9'h0;
    census_columns_values_1_cell_2_mask_q = 1'b0;
    census_columns_values_1_cell_2_of_skin_q = 1'b0;
    census_columns_values_1_cell_3_left_q = 9'h0;
    census_columns_values_1_cell_3_right_q = 9'h0;
    census_columns_values_1_cell_3_mask_q = 1'b0;
    census_columns_values_1_cell_4_left_q = 9'h0;
    census_columns_values_1_cell_4_right_q = 9'h0;
    census_columns_values_1_cell_4_mask_q = 1'b0;
    census_columns_values_2_cell_0_left_q = 9'h0;
    census_columns_values_2_cell_0_right_q = 9'h0;
    census_columns_values_2_cell_0_mask_q = 1'b0;
    census_columns_values_2_cell_1_left_q = 9'h0;
    census_columns_values_2_cell_1_right_q = 9'h0;
    census_columns_values_2_cell_1_mask_q = 1'b0;
    census_columns_values_2_cell_2_left_q = 9'h0;
    census_columns_values_2_cell_2_right_q = 9'h0;
    census_columns_values_2_cell_2_mask_q = 1'b0;
    census_columns_values_2_cell_3_left_q = 9'h0;
    census_columns_values_2_cell_3_right_q = 9'h0;
    census_columns_values_2_cell_3_mask_q = 1'b0;
    census_columns_values_2_cell_4_left_q = 9'h0;
    census_columns_values_2_cell_4_right_q = 9'h0;
    census_columns_values_2_cell_4_mask_q = 1'b0;
    census_columns_values_3_cell_0_mask_q = 1'b0;
    census_columns_values_3_cell_1_left_q = 9'h0;
    census_columns_values_3_cell_1_right_q = 9'h0;
    census_columns_values_3_cell_1_mask_q = 1'b0;
    census_columns_values_3_cell_2_mask_q = 1'b0;
    census_columns_values_3_cell_3_left_q = 9'h0;
    census_columns_values_3_cell_3_right_q = 9'h0;
    census_columns_values_3_cell_3_mask_q = 1'b0;
    census_columns_values_3_cell_4_mask_q = 1'b0;
    sharpness_last_mean_0_q = 9'h0;
    sharpness_last_mean_1_q = 9'h0;
    box_textured_columns_values_0_q = 5'h0;
    box_textured_columns_values_1_q = 5'h0;
    box_textured_columns_values_2_q = 5'h0;
    box_textured_columns_values_3_q = 5'h0;
    box_textured_columns_values_4_q = 5'h0;
    box_textured_sum_sums_values_0_q = 5'h0;
    box_explained_columns_values_0_q = 5'h0;
    box_explained_columns_values_1_q = 5'h0;
    box_explained_columns_values_2_q = 5'h0;
    box_explained_columns_values_3_q = 5'h0;
    box_explained_columns_values_4_q = 5'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_shown_columns_values_0_q = 5'h0;
    box_shown_columns_values_1_q = 5'h0;
    box_shown_columns_values_2_q = 5'h0;
    box_shown_columns_values_3_q = 5'h0;
    box_shown_columns_values_4_q = 5'h0;
    box_shown_sum_sums_values_0_q = 5'h0;
    box_nearer_columns_values_0_q = 5'h0;
    box_nearer_columns_values_1_q = 5'h0;
    box_nearer_columns_values_2_q = 5'h0;
    box_nearer_columns_values_3_q = 5'h0;
    box_nearer_columns_values_4_q = 5'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s4_en) begin
      averager_total_0_q <= select_1174;
      averager_total_1_q <= select_1176;
      census_columns_values_0_cell_0_left_q <= select_1200;
      census_columns_values_0_cell_0_right_q <= select_1201;
      census_columns_values_0_cell_0_mask_q <= select_1202;
      census_columns_values_0_cell_1_left_q <= select_1203;
      census_columns_values_0_cell_1_right_q <= select_1204;
      census_columns_values_0_cell_1_mask_q <= select_1205;
      census_columns_values_0_cell_2_left_q <= select_1206;
      census_columns_values_0_cell_2_right_q <= select_1207;
      census_columns_values_0_cell_2_mask_q <= select_1208;
      census_columns_values_0_cell_2_of_skin_q <= select_1209;
      census_columns_values_0_cell_3_left_q <= select_1210;
      census_columns_values_0_cell_3_right_q <= select_1211;
      census_columns_values_0_cell_3_mask_q <= select_1212;
      census_columns_values_0_cell_4_left_q <= select_1213;
      census_columns_values_0_cell_4_right_q <= select_1214;
      census_columns_values_0_cell_4_mask_q <= select_1215;
      census_columns_values_1_cell_0_left_q <= select_1216;
      census_columns_values_1_cell_0_right_q <= select_1217;
      census_columns_values_1_cell_0_mask_q <= select_1218;
      census_columns_values_1_cell_1_left_q <= select_1219;
      census_columns_values_1_cell_1_right_q <= select_1220;
      census_columns_values_1_cell_1_mask_q <= select_1221;
      census_columns_values_1_cell_2_left_q <= select_1222;
      census_columns_values_1_cell_2_right_q <= select_1223;
      census_columns_values_1_cell_2_mask_q <= select_1224;
      census_columns_values_1_cell_2_of_skin_q <= select_1225;
      census_columns_values_1_cell_3_left_q <= select_1226;
      census_columns_values_1_cell_3_right_q <= select_1227;
      census_columns_values_1_cell_3_mask_q <= select_1228;
      census_columns_values_1_cell_4_left_q <= select_1229;
      census_columns_values_1_cell_4_right_q <= select_1230;
      census_columns_values_1_cell_4_mask_q <= select_1231;
      census_columns_values_2_cell_0_left_q <= select_1232;
      census_columns_values_2_cell_0_right_q <= select_1233;
      census_columns_values_2_cell_0_mask_q <= select_1234;
      census_columns_values_2_cell_1_left_q <= select_1235;
      census_columns_values_2_cell_1_right_q <= select_1236;
      census_columns_values_2_cell_1_mask_q <= select_1237;
      census_columns_values_2_cell_2_left_q <= select_1238;
      census_columns_values_2_cell_2_right_q <= select_1239;
      census_columns_values_2_cell_2_mask_q <= select_1240;
      census_columns_values_2_cell_3_left_q <= select_1241;
      census_columns_values_2_cell_3_right_q <= select_1242;
      census_columns_values_2_cell_3_mask_q <= select_1243;
      census_columns_values_2_cell_4_left_q <= select_1244;
      census_columns_values_2_cell_4_right_q <= select_1245;
      census_columns_values_2_cell_4_mask_q <= select_1246;
      census_columns_values_3_cell_0_mask_q <= select_1247;
      census_columns_values_3_cell_1_left_q <= select_1248;
      census_columns_values_3_cell_1_right_q <= select_1249;
      census_columns_values_3_cell_1_mask_q <= select_1250;
      census_columns_values_3_cell_2_mask_q <= select_1251;
      census_columns_values_3_cell_3_left_q <= select_1252;
      census_columns_values_3_cell_3_right_q <= select_1253;
      census_columns_values_3_cell_3_mask_q <= select_1254;
      census_columns_values_3_cell_4_mask_q <= select_1255;
      sharpness_last_mean_0_q <= and_357_s4_q ? select_363 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_357_s4_q ? select_367 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= select_1975;
      box_textured_columns_values_1_q <= equal_941_s4_q ? box_textured_columns_values_1_q : select_1976;
      box_textured_columns_values_2_q <= equal_941_s4_q ? box_textured_columns_values_2_q : select_1978;
      box_textured_columns_values_3_q <= equal_941_s4_q ? box_textured_columns_values_3_q : select_1980;
      box_textured_columns_values_4_q <= equal_941_s4_q ? box_textured_columns_values_4_q : select_1982;
      box_textured_sum_sums_values_0_q <= select_1985;
      box_explained_columns_values_0_q <= equal_941_s4_q ? box_explained_columns_values_0_q : select_1986;
      box_explained_columns_values_1_q <= equal_941_s4_q ? box_explained_columns_values_1_q : select_1988;
      box_explained_columns_values_2_q <= equal_941_s4_q ? box_explained_columns_values_2_q : select_1990;
      box_explained_columns_values_3_q <= equal_941_s4_q ? box_explained_columns_values_3_q : select_1992;
      box_explained_columns_values_4_q <= equal_941_s4_q ? box_explained_columns_values_4_q : select_1994;
      box_explained_sum_sums_values_0_q <= select_1997;
      box_shown_columns_values_0_q <= select_1999;
      box_shown_columns_values_1_q <= equal_941_s4_q ? box_shown_columns_values_1_q : select_2000;
      box_shown_columns_values_2_q <= equal_941_s4_q ? box_shown_columns_values_2_q : select_2002;
      box_shown_columns_values_3_q <= equal_941_s4_q ? box_shown_columns_values_3_q : select_2004;
      box_shown_columns_values_4_q <= equal_941_s4_q ? box_shown_columns_values_4_q : select_2006;
      box_shown_sum_sums_values_0_q <= select_2009;
      box_nearer_columns_values_0_q <= select_2011;
      box_nearer_columns_values_1_q <= equal_941_s4_q ? box_nearer_columns_values_1_q : select_2012;
      box_nearer_columns_values_2_q <= equal_941_s4_q ? box_nearer_columns_values_2_q : select_2014;
      box_nearer_columns_values_3_q <= equal_941_s4_q ? box_nearer_columns_values_3_q : select_2016;
      box_nearer_columns_values_4_q <= equal_941_s4_q ? box_nearer_columns_values_4_q : select_2018;
      box_nearer_sum_sums_values_0_q <= select_2021;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic sample_pair_whole_s5_q;
  logic census_columns_values_1_cell_2_of_skin_s5_q;
  logic [5:0] x_s5_q;
  logic [2:0] region_row_s5_q;
  logic region_fresh_s5_q;
  logic begins_product_s5_q;
  logic centres_values_1_textured_s5_q;
  logic centres_values_1_of_skin_s5_q;
  logic [6:0] column_s5_q;
  logic and_355_s5_q;
  logic and_357_s5_q;
  logic [8:0] grey_s5_q;
  logic equal_360_s5_q;
  logic [8:0] grey_2_s5_q;
  logic whole_2_s5_q;
  logic less_389_s5_q;
  logic less_390_s5_q;
  logic less_391_s5_q;
  logic less_392_s5_q;
  logic less_393_s5_q;
  logic less_394_s5_q;
  logic less_395_s5_q;
  logic less_396_s5_q;
  logic less_397_s5_q;
  logic less_398_s5_q;
  logic less_399_s5_q;
  logic less_400_s5_q;
  logic less_401_s5_q;
  logic less_402_s5_q;
  logic less_403_s5_q;
  logic less_404_s5_q;
  logic less_405_s5_q;
  logic less_406_s5_q;
  logic less_407_s5_q;
  logic less_408_s5_q;
  logic less_409_s5_q;
  logic less_410_s5_q;
  logic less_411_s5_q;
  logic less_412_s5_q;
  logic and_420_s5_q;
  logic and_445_s5_q;
  logic and_446_s5_q;
  logic [11:0] texture_s5_q;
  logic equal_941_s5_q;
  logic not_942_s5_q;
  logic [2:0] select_965_s5_q;
  logic or_996_s5_q;
  logic or_999_s5_q;
  logic or_1002_s5_q;
  logic equal_1004_s5_q;
  logic textured_s5_q;
  logic explained_s5_q;
  logic and_1025_s5_q;
  logic and_1030_s5_q;
  logic and_1062_s5_q;
  logic less_1063_s5_q;
  logic [5:0] index_2_s5_q;
  logic [7:0] sum_1068_s5_q;
  logic equal_1082_s5_q;
  logic or_1087_s5_q;
  logic or_1090_s5_q;
  logic or_1093_s5_q;
  logic not_1117_s5_q;
  logic less_1131_s5_q;
  logic and_1142_s5_q;
  logic [11:0] sum_1275_s5_q;
  logic equal_1282_s5_q;
  logic [8:0] contrast_s5_q;
  logic [8:0] contrast_2_s5_q;
  logic and_1513_s5_q;
  logic and_1516_s5_q;
  logic equal_1531_s5_q;
  logic not_1547_s5_q;
  logic less_1611_s5_q;
  logic equal_1614_s5_q;
  logic equal_1615_s5_q;
  logic equal_1616_s5_q;
  logic [7:0] residual_s5_q;
  logic equal_1933_s5_q;
  logic and_2060_s5_q;
  logic and_2087_s5_q;
  logic less_2106_s5_q;
  logic less_2107_s5_q;
  logic less_2109_s5_q;
  logic or_2112_s5_q;
  logic less_2114_s5_q;
  logic or_2119_s5_q;
  logic less_2120_s5_q;
  logic or_2126_s5_q;
  logic select_2163_s5_q;
  logic or_2165_s5_q;
  logic less_2167_s5_q;
  logic less_2170_s5_q;
  logic select_2174_s5_q;
  logic and_2206_s5_q;
  logic [11:0] select_2216_s5_q;
  logic [11:0] select_2218_s5_q;
  logic [11:0] select_2220_s5_q;
  logic [11:0] select_2222_s5_q;
  logic and_2231_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_0_q;
      pixel_1_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      sample_pair_whole_s5_q <= sample_pair_whole_s4_q;
      census_columns_values_1_cell_2_of_skin_s5_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s5_q <= x_s4_q[5:0];
      region_row_s5_q <= region_row_q;
      region_fresh_s5_q <= region_fresh_q;
      begins_product_s5_q <= begins_product_q;
      centres_values_1_textured_s5_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s5_q <= centres_values_1_of_skin_q;
      column_s5_q <= column_s4_q;
      and_355_s5_q <= and_355_s4_q;
      and_357_s5_q <= and_357_s4_q;
      grey_s5_q <= grey_s4_q;
      equal_360_s5_q <= equal_360_s4_q;
      grey_2_s5_q <= grey_2_s4_q;
      whole_2_s5_q <= whole_2_s4_q;
      less_389_s5_q <= less_389;
      less_390_s5_q <= less_390;
      less_391_s5_q <= less_391;
      less_392_s5_q <= less_392;
      less_393_s5_q <= less_393;
      less_394_s5_q <= less_394;
      less_395_s5_q <= less_395;
      less_396_s5_q <= less_396;
      less_397_s5_q <= less_397;
      less_398_s5_q <= less_398;
      less_399_s5_q <= less_399;
      less_400_s5_q <= less_400;
      less_401_s5_q <= less_401;
      less_402_s5_q <= less_402;
      less_403_s5_q <= less_403;
      less_404_s5_q <= less_404;
      less_405_s5_q <= less_405;
      less_406_s5_q <= less_406;
      less_407_s5_q <= less_407;
      less_408_s5_q <= less_408;
      less_409_s5_q <= less_409;
      less_410_s5_q <= less_410;
      less_411_s5_q <= less_411;
      less_412_s5_q <= less_412;
      and_420_s5_q <= and_420;
      and_445_s5_q <= whole_22 & and_420;
      and_446_s5_q <= census_columns_values_1_cell_2_mask_q & and_420;
      texture_s5_q <= texture;
      equal_941_s5_q <= equal_941_s4_q;
      not_942_s5_q <= not_942_s4_q;
      select_965_s5_q <= {select_965_s4_q[4], select_965_s4_q[2], select_965_s4_q[0]};
      or_996_s5_q <= or_996;
      or_999_s5_q <= or_999;
      or_1002_s5_q <= or_1002;
      equal_1004_s5_q <= equal_1004;
      textured_s5_q <= textured;
      explained_s5_q <= explained;
      and_1025_s5_q <= and_1025;
      and_1030_s5_q <= not_942_s4_q & and_1011;
      and_1062_s5_q <= and_1062;
      less_1063_s5_q <= less_1063;
      index_2_s5_q <= index_2[5:0];
      sum_1068_s5_q <= sum_1068;
      equal_1082_s5_q <= t[4:1] == 4'h0;
      or_1087_s5_q <= or_1087;
      or_1090_s5_q <= select_1084[7] | (~({select_1084[6], select_1084[3:2]} == 3'h0));
      or_1093_s5_q <= select_1084[7] | (~(select_1084[6:4] == 3'h0));
      not_1117_s5_q <= ~({sum_1115, around[0]} < {2'h0, t});
      less_1131_s5_q <= {1'b0, around[4:1]} < n;
      and_1142_s5_q <= and_1142_s4_q;
      sum_1275_s5_q <= ({1'b0, sum_1267} + {2'h0, sum_1270}) + {2'h0, sum_1274};
      equal_1282_s5_q <= equal_1282_s4_q;
      contrast_s5_q <= contrast;
      contrast_2_s5_q <= contrast_2;
      and_1513_s5_q <= and_1513;
      and_1516_s5_q <= and_1516;
      equal_1531_s5_q <= x_s4_q[7:1] == 7'h0;
      not_1547_s5_q <= ~({sum_1545, e[0]} < {2'h0, t});
      less_1611_s5_q <= less_1611_s4_q;
      equal_1614_s5_q <= equal_1614;
      equal_1615_s5_q <= equal_1615;
      equal_1616_s5_q <= equal_1616;
      residual_s5_q <= residual[7:0];
      equal_1933_s5_q <= equal_1933;
      and_2060_s5_q <= and_2060;
      and_2087_s5_q <= equal_941_s4_q & (equal_1933 & (cfg_prove_i & (~proven_q)));
      less_2106_s5_q <= less_2106;
      less_2107_s5_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2109_s5_q <= less_2109;
      or_2112_s5_q <= or_2112;
      less_2114_s5_q <= less_2114;
      or_2119_s5_q <= or_2119;
      less_2120_s5_q <= less_2120;
      or_2126_s5_q <= or_2126;
      select_2163_s5_q <= select_2163;
      or_2165_s5_q <= less_2164 | select_2163;
      less_2167_s5_q <= less_2167;
      less_2170_s5_q <= less_2170;
      select_2174_s5_q <= less_2132 ? or_2162 : select_2159;
      and_2206_s5_q <= equal_941_s4_q & (equal_1933 & (cfg_prove_i & and_2203));
      select_2216_s5_q <= select_2216;
      select_2218_s5_q <= select_2218;
      select_2220_s5_q <= select_2220;
      select_2222_s5_q <= select_2222;
      and_2231_s5_q <= equal_941_s4_q & not_1005;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_quarter_1_0_q;
  logic [8:0] averager_quarter_1_1_q;
  logic [8:0] averager_quarter_2_0_q;
  logic [8:0] averager_quarter_2_1_q;
  logic [13:0] averager_detail_0_q;
  logic [13:0] averager_detail_1_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [19:0] census_left_misses_q;
  logic sharpness_last_mask_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_explained_q;
  logic [13:0] counts_nearer_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [23:0] counts_too_little_explained_q;
  logic [23:0] counts_too_many_bad_q;
  logic [23:0] counts_too_much_unproven_q;
  logic [23:0] counts_too_much_unseen_skin_q;
  logic [19:0] registration_counts_across_0_q;
  logic [19:0] registration_counts_across_1_q;
  logic [19:0] registration_counts_across_2_q;
  logic [19:0] registration_counts_across_3_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
  logic segment_started_q;
  logic [47:0] good_q;
  logic [47:0] good_next_q;
  logic [35:0] product_0_q;
  logic [35:0] product_1_q;
  logic [34:0] addend_0_q;
  logic [34:0] addend_1_q;
  logic [17:0] multiplier_0_q;
  logic [17:0] multiplier_1_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:201
  logic [12:0] sum_466;
  assign sum_466 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s5_q};
  logic [13:0] sum_468;
  assign sum_468 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_466});
  // hls/stages/census.hpp:223
  logic less_469;
  assign less_469 = 9'h4 < sum_468[13:5];
  logic and_470;
  assign and_470 = and_420_s5_q & less_469;
  // hls/stages/agreement.hpp:542
  logic [6:0] select_1015;
  assign select_1015 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:543
  logic [6:0] sum_1016;
  assign sum_1016 = {6'h0, textured_s5_q} + select_1015;
  // hls/stages/agreement.hpp:683
  logic [11:0] sum_1018;
  assign sum_1018 = {5'h0, sum_1016} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:542
  logic [6:0] select_1020;
  assign select_1020 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:543
  logic [6:0] sum_1021;
  assign sum_1021 = {6'h0, explained_s5_q} + select_1020;
  // hls/stages/agreement.hpp:684
  logic [11:0] sum_1023;
  assign sum_1023 = {5'h0, sum_1021} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:542
  logic [6:0] select_1026;
  assign select_1026 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:544
  logic [6:0] sum_1027;
  assign sum_1027 = {6'h0, and_1025_s5_q} + select_1026;
  // hls/stages/agreement.hpp:685
  logic [11:0] sum_1029;
  assign sum_1029 = {5'h0, sum_1027} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:723
  logic not_1094;
  assign not_1094 = ~region_row_s5_q[2];
  logic [2:0] select_1095;
  assign select_1095 = region_row_s5_q[1] ? {1'b0, not_1094, 1'b0} : {region_row_s5_q[2], 1'b0, not_1094};
  logic [5:0] select_1096;
  assign select_1096 = region_row_s5_q[0] ? {select_1095[2], 1'b0, select_1095[1], 1'b0, select_1095[0], 1'b0} : {1'b0, select_1095[2], 1'b0, select_1095[1], 1'b0, select_1095[0]};
  logic [11:0] select_1097;
  assign select_1097 = or_1093_s5_q ? {select_1096[5], 1'b0, select_1096[4], 1'b0, select_1096[3], 1'b0, select_1096[2], 1'b0, select_1096[1], 1'b0, select_1096[0], 1'b0} : {1'b0, select_1096[5], 1'b0, select_1096[4], 1'b0, select_1096[3], 1'b0, select_1096[2], 1'b0, select_1096[1], 1'b0, select_1096[0]};
  logic [23:0] select_1098;
  assign select_1098 = or_1090_s5_q ? {select_1097[11], 1'b0, select_1097[10], 1'b0, select_1097[9], 1'b0, select_1097[8], 1'b0, select_1097[7], 1'b0, select_1097[6], 1'b0, select_1097[5], 1'b0, select_1097[4], 1'b0, select_1097[3], 1'b0, select_1097[2], 1'b0, select_1097[1], 1'b0, select_1097[0], 1'b0} : {1'b0, select_1097[11], 1'b0, select_1097[10], 1'b0, select_1097[9], 1'b0, select_1097[8], 1'b0, select_1097[7], 1'b0, select_1097[6], 1'b0, select_1097[5], 1'b0, select_1097[4], 1'b0, select_1097[3], 1'b0, select_1097[2], 1'b0, select_1097[1], 1'b0, select_1097[0]};
  logic [47:0] select_1099;
  assign select_1099 = or_1087_s5_q ? {select_1098[23], 1'b0, select_1098[22], 1'b0, select_1098[21], 1'b0, select_1098[20], 1'b0, select_1098[19], 1'b0, select_1098[18], 1'b0, select_1098[17], 1'b0, select_1098[16], 1'b0, select_1098[15], 1'b0, select_1098[14], 1'b0, select_1098[13], 1'b0, select_1098[12], 1'b0, select_1098[11], 1'b0, select_1098[10], 1'b0, select_1098[9], 1'b0, select_1098[8], 1'b0, select_1098[7], 1'b0, select_1098[6], 1'b0, select_1098[5], 1'b0, select_1098[4], 1'b0, select_1098[3], 1'b0, select_1098[2], 1'b0, select_1098[1], 1'b0, select_1098[0], 1'b0} : {1'b0, select_1098[23], 1'b0, select_1098[22], 1'b0, select_1098[21], 1'b0, select_1098[20], 1'b0, select_1098[19], 1'b0, select_1098[18], 1'b0, select_1098[17], 1'b0, select_1098[16], 1'b0, select_1098[15], 1'b0, select_1098[14], 1'b0, select_1098[13], 1'b0, select_1098[12], 1'b0, select_1098[11], 1'b0, select_1098[10], 1'b0, select_1098[9], 1'b0, select_1098[8], 1'b0, select_1098[7], 1'b0, select_1098[6], 1'b0, select_1098[5], 1'b0, select_1098[4], 1'b0, select_1098[3], 1'b0, select_1098[2], 1'b0, select_1098[1], 1'b0, select_1098[0]};
  logic not_1102;
  assign not_1102 = ~((good_q & select_1099) == 48'h0);
  // hls/stages/agreement.hpp:725
  logic is_seen;
  assign is_seen = equal_1082_s5_q ? not_1102 : not_1117_s5_q;
  // hls/stages/agreement.hpp:737
  logic and_1132;
  assign and_1132 = is_seen & less_1131_s5_q;
  // hls/stages/agreement.hpp:204
  logic [8:0] select_1166;
  assign select_1166 = sample_pair_whole_s5_q ? (and_355_s5_q ? grey_s5_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1168;
  assign select_1168 = sample_pair_whole_s5_q ? (and_355_s5_q ? grey_2_s5_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1170;
  assign select_1170 = sample_pair_whole_s5_q ? (and_355_s5_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1172;
  assign select_1172 = sample_pair_whole_s5_q ? (and_355_s5_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1177;
  assign sum_1177 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s5_q};
  logic [9:0] difference_1178;
  assign difference_1178 = {1'b0, sum_1177[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1179;
  assign xor_1179 = {difference_1178[8:0], sum_1177[0]} ^ {10{difference_1178[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1178[9]} + {1'b0, xor_1179};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_360_s5_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1184;
  assign select_1184 = sample_pair_whole_s5_q ? (and_355_s5_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1185;
  assign sum_1185 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s5_q};
  logic [9:0] difference_1186;
  assign difference_1186 = {1'b0, sum_1185[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1187;
  assign xor_1187 = {difference_1186[8:0], sum_1185[0]} ^ {10{difference_1186[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1186[9]} + {1'b0, xor_1187};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_360_s5_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1192;
  assign select_1192 = sample_pair_whole_s5_q ? (and_355_s5_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1277;
  assign select_1277 = and_357_s5_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1278;
  assign select_1278 = and_357_s5_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1279;
  assign select_1279 = and_357_s5_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1280;
  assign select_1280 = and_357_s5_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_1283;
  assign sum_1283 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1275_s5_q};
  logic [13:0] sum_1285;
  assign sum_1285 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1283});
  // hls/stages/census.hpp:225
  logic and_1287;
  assign and_1287 = and_445_s5_q & (9'h4 < sum_1285[13:5]);
  // hls/stages/census.hpp:226
  logic and_1288;
  assign and_1288 = and_445_s5_q & less_469;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1289;
  assign sum_1289 = census_left_misses_q + {{17{and_1288}}, and_1287, 1'b0, and_1287};
  // hls/stages/agreement.hpp:205
  logic [19:0] select_1291;
  assign select_1291 = and_357_s5_q ? (equal_1282_s5_q ? 20'h0 : sum_1289) : census_left_misses_q;
  // hls/stages/agreement.hpp:204
  logic [27:0] select_1296;
  assign select_1296 = sample_pair_whole_s5_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:275
  logic and_1301;
  assign and_1301 = whole_2_s5_q & (~(column_s5_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:287
  logic and_1307;
  assign and_1307 = and_1301 & (sharpness_last_mask_q & (7'h2 < contrast_s5_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1296[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1309;
  assign select_1309 = and_1307 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1311;
  assign select_1311 = equal_1282_s5_q ? {11'h0, select_1309} : (sharpness_sums_detail_0_q + {11'h0, select_1309});
  // hls/stages/agreement.hpp:287
  logic and_1318;
  assign and_1318 = and_1301 & (sharpness_last_mask_q & (7'h2 < contrast_2_s5_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1296[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1320;
  assign select_1320 = and_1318 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1322;
  assign select_1322 = equal_1282_s5_q ? {11'h0, select_1320} : (sharpness_sums_detail_1_q + {11'h0, select_1320});
  logic [8:0] select_1325;
  assign select_1325 = and_1307 ? contrast_s5_q : 9'h0;
  logic [23:0] sum_1326;
  assign sum_1326 = (equal_1282_s5_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1325};
  logic [8:0] select_1329;
  assign select_1329 = and_1318 ? contrast_2_s5_q : 9'h0;
  logic [23:0] sum_1330;
  assign sum_1330 = (equal_1282_s5_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1329};
  // hls/stages/agreement.hpp:566
  logic [13:0] select_1518;
  assign select_1518 = and_1513_s5_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1516_s5_q});
  // hls/stages/agreement.hpp:343
  logic and_1520;
  assign and_1520 = not_942_s5_q & (begins_product_q & textured_s5_q);
  logic and_1524;
  assign and_1524 = not_942_s5_q & (begins_product_q & explained_s5_q);
  logic and_1528;
  assign and_1528 = not_942_s5_q & (begins_product_q & and_1025_s5_q);
  // hls/stages/agreement.hpp:724
  logic select_1548;
  assign select_1548 = equal_1082_s5_q ? not_1102 : not_1547_s5_q;
  // hls/stages/agreement.hpp:729
  logic not_1549;
  assign not_1549 = ~select_1548;
  // hls/stages/agreement.hpp:343
  logic and_1552;
  assign and_1552 = begins_product_q & ((~equal_1531_s5_q) & (centres_values_1_textured_s5_q & not_1549));
  logic and_1553;
  assign and_1553 = not_942_s5_q & and_1552;
  // hls/stages/agreement.hpp:755
  logic less_1556;
  assign less_1556 = region_row_s5_q < x_s5_q[5:3];
  logic [11:0] select_1557;
  assign select_1557 = less_1556 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1560;
  assign select_1560 = less_1556 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:756
  logic [12:0] sum_1561;
  assign sum_1561 = {1'b0, select_1560} + {3'h0, select_1560[11:2]};
  logic and_1563;
  assign and_1563 = (~(select_1557[11:4] == 8'h0)) & ({sum_1561, select_1560[1:0]} < {3'h0, select_1557});
  // hls/stages/agreement.hpp:766
  logic [11:0] select_1565;
  assign select_1565 = equal_1004_s5_q ? 12'h0 : (and_1563 ? select_1557 : 12'h0);
  // hls/stages/agreement.hpp:343
  logic [11:0] select_1566;
  assign select_1566 = equal_941_s5_q ? select_1565 : 12'h0;
  // hls/stages/agreement.hpp:566
  logic [13:0] select_1568;
  assign select_1568 = and_1513_s5_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1566});
  // hls/stages/agreement.hpp:660
  logic [1:0] difference_1569;
  assign difference_1569 = 2'h0 - {1'b0, select_965_s5_q[2]};
  // hls/stages/agreement.hpp:664
  logic [9:0] select_1570;
  assign select_1570 = select_965_s5_q[1] ? {difference_1569, cfg_explained_limit_i} : 10'h0;
  // hls/stages/agreement.hpp:343
  logic [9:0] select_1572;
  assign select_1572 = begins_product_q ? (select_965_s5_q[0] ? select_1570 : 10'h0) : 10'h0;
  logic [9:0] select_1573;
  assign select_1573 = equal_941_s5_q ? 10'h0 : select_1572;
  // hls/stages/agreement.hpp:561
  logic [23:0] sum_1574;
  assign sum_1574 = counts_too_little_explained_q + {{14{select_1573[9]}}, select_1573};
  // hls/stages/agreement.hpp:186
  logic [8:0] select_1578;
  assign select_1578 = select_965_s5_q[0] ? (select_965_s5_q[1] ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0) : 9'h0;
  // hls/stages/agreement.hpp:343
  logic [8:0] select_1579;
  assign select_1579 = begins_product_q ? select_1578 : 9'h0;
  logic [20:0] select_1580;
  assign select_1580 = equal_941_s5_q ? {1'b0, select_1565, 8'h0} : {{12{select_1579[8]}}, select_1579};
  // hls/stages/agreement.hpp:566
  logic [23:0] select_1582;
  assign select_1582 = and_1513_s5_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1580[20]}}, select_1580});
  // hls/stages/agreement.hpp:664
  logic [8:0] select_1584;
  assign select_1584 = select_965_s5_q[1] ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1585;
  assign select_1585 = select_965_s5_q[0] ? select_1584[7:0] : 8'h0;
  // hls/stages/agreement.hpp:186
  logic and_1586;
  assign and_1586 = select_965_s5_q[0] & select_1584[8];
  // hls/stages/agreement.hpp:735
  logic [2:0] select_1589;
  assign select_1589 = centres_values_1_textured_s5_q ? (select_1548 ? {3{and_1586}} : ({3{and_1586}} + 3'h1)) : {3{and_1586}};
  logic [2:0] select_1590;
  assign select_1590 = equal_1531_s5_q ? {3{and_1586}} : select_1589;
  // hls/stages/agreement.hpp:343
  logic [10:0] select_1592;
  assign select_1592 = equal_941_s5_q ? 11'h0 : (begins_product_q ? {select_1590, select_1585} : 11'h0);
  // hls/stages/agreement.hpp:563
  logic [23:0] sum_1593;
  assign sum_1593 = counts_too_much_unproven_q + {{13{select_1592[10]}}, select_1592};
  // hls/stages/agreement.hpp:735
  logic [9:0] select_1596;
  assign select_1596 = centres_values_1_of_skin_s5_q ? ({1'b0, not_1549, 8'h0} - {2'h0, cfg_unproven_skin_limit_i}) : 10'h0;
  logic [9:0] select_1598;
  assign select_1598 = equal_1531_s5_q ? 10'h0 : (centres_values_1_textured_s5_q ? select_1596 : 10'h0);
  // hls/stages/agreement.hpp:343
  logic [9:0] select_1600;
  assign select_1600 = equal_941_s5_q ? 10'h0 : (begins_product_q ? select_1598 : 10'h0);
  // hls/stages/agreement.hpp:564
  logic [23:0] sum_1601;
  assign sum_1601 = counts_too_much_unseen_skin_q + {{14{select_1600[9]}}, select_1600};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1656;
  assign select_1656 = equal_1615_s5_q ? 8'h0 : (equal_1616_s5_q ? 8'h0 : residual_s5_q);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1659;
  assign select_1659 = select_965_s5_q[2] ? (less_1611_s5_q ? (equal_1614_s5_q ? 8'h0 : select_1656) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1661;
  assign select_1661 = begins_product_q ? (select_965_s5_q[0] ? select_1659 : 8'h0) : 8'h0;
  logic [7:0] select_1662;
  assign select_1662 = equal_941_s5_q ? 8'h0 : select_1661;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1663;
  assign sum_1663 = registration_counts_across_0_q + {{12{select_1662[7]}}, select_1662};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1666;
  assign select_1666 = equal_1615_s5_q ? 8'h0 : (equal_1616_s5_q ? residual_s5_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1669;
  assign select_1669 = select_965_s5_q[2] ? (less_1611_s5_q ? (equal_1614_s5_q ? 8'h0 : select_1666) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1671;
  assign select_1671 = begins_product_q ? (select_965_s5_q[0] ? select_1669 : 8'h0) : 8'h0;
  logic [7:0] select_1672;
  assign select_1672 = equal_941_s5_q ? 8'h0 : select_1671;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1673;
  assign sum_1673 = registration_counts_across_1_q + {{12{select_1672[7]}}, select_1672};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1676;
  assign select_1676 = equal_1614_s5_q ? 8'h0 : (equal_1615_s5_q ? residual_s5_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1678;
  assign select_1678 = select_965_s5_q[2] ? (less_1611_s5_q ? select_1676 : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1680;
  assign select_1680 = begins_product_q ? (select_965_s5_q[0] ? select_1678 : 8'h0) : 8'h0;
  logic [7:0] select_1681;
  assign select_1681 = equal_941_s5_q ? 8'h0 : select_1680;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1682;
  assign sum_1682 = registration_counts_across_2_q + {{12{select_1681[7]}}, select_1681};
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1686;
  assign select_1686 = select_965_s5_q[2] ? (less_1611_s5_q ? (equal_1614_s5_q ? residual_s5_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1688;
  assign select_1688 = begins_product_q ? (select_965_s5_q[0] ? select_1686 : 8'h0) : 8'h0;
  logic [7:0] select_1689;
  assign select_1689 = equal_941_s5_q ? 8'h0 : select_1688;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1690;
  assign sum_1690 = registration_counts_across_3_q + {{12{select_1689[7]}}, select_1689};
  // hls/stages/agreement.hpp:751
  logic and_1938;
  assign and_1938 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:752
  logic less_1939;
  assign less_1939 = $signed(24'h0) < $signed(counts_too_little_explained_q);
  // hls/stages/agreement.hpp:758
  logic [12:0] sum_1942;
  assign sum_1942 = {1'b0, select_1560} + {2'h0, select_1560[11:1]};
  logic select_1945;
  assign select_1945 = (select_1557[11:3] == 9'h0) ? (and_1938 & (~less_1939)) : (~({sum_1942, select_1560[0]} < {2'h0, select_1557}));
  // hls/stages/agreement.hpp:766
  logic [47:0] select_1946;
  assign select_1946 = equal_1004_s5_q ? good_next_q : {select_1945, good_next_q[47:1]};
  // hls/stages/agreement.hpp:343
  logic [47:0] select_1948;
  assign select_1948 = equal_941_s5_q ? (equal_1933_s5_q ? select_1946 : good_q) : good_q;
  // hls/stages/agreement.hpp:783
  logic [35:0] select_1965;
  assign select_1965 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:777
  logic [35:0] detail_left;
  assign detail_left = begins_product_s5_q ? 36'h0 : select_1965;
  // hls/stages/agreement.hpp:783
  logic [35:0] select_1968;
  assign select_1968 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:787
  logic [35:0] detail_right;
  assign detail_right = begins_product_s5_q ? 36'h0 : select_1968;
  // hls/stages/agreement.hpp:777
  logic [34:0] select_1970;
  assign select_1970 = begins_product_s5_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:787
  logic [34:0] select_1971;
  assign select_1971 = begins_product_s5_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:777
  logic [17:0] select_1972;
  assign select_1972 = begins_product_s5_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:787
  logic [17:0] select_1973;
  assign select_1973 = begins_product_s5_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:875
  logic [1:0] select_2061;
  assign select_2061 = and_2060_s5_q ? {and_1132, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:876
  logic and_2062;
  assign and_2062 = proven_q & less_2050;
  // hls/stages/agreement.hpp:208
  logic select_2065;
  assign select_2065 = and_1062_s5_q ? (less_1063_s5_q ? (select_2061[0] & and_2062) : seen_q) : seen_q;
  logic select_2068;
  assign select_2068 = and_1062_s5_q ? (less_1063_s5_q ? (select_2061[1] & and_2062) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:343
  logic [13:0] select_2073;
  assign select_2073 = equal_941_s5_q ? (equal_1933_s5_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_2075;
  assign select_2075 = equal_941_s5_q ? (equal_1933_s5_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_2077;
  assign select_2077 = equal_941_s5_q ? (equal_1933_s5_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_2079;
  assign select_2079 = equal_941_s5_q ? (equal_1933_s5_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_2081;
  assign select_2081 = equal_941_s5_q ? (equal_1933_s5_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_2083;
  assign select_2083 = equal_941_s5_q ? (equal_1933_s5_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  // hls/stages/agreement.hpp:803
  logic not_2088;
  assign not_2088 = ~and_1938;
  // hls/stages/agreement.hpp:804
  logic or_2092;
  assign or_2092 = not_2069 | not_2088;
  // hls/stages/agreement.hpp:770
  logic or_2098;
  assign or_2098 = ($signed(24'h0) < $signed(counts_too_much_unproven_q)) | ($signed(24'h0) < $signed(counts_too_much_unseen_skin_q));
  logic select_2100;
  assign select_2100 = (less_1939 | or_2092) ? (~or_2092) : (($signed(24'h0) < $signed(counts_too_many_bad_q)) | or_2098);
  logic select_2166;
  assign select_2166 = or_2126_s5_q ? select_2163_s5_q : or_2165_s5_q;
  logic or_2168;
  assign or_2168 = less_2167_s5_q | select_2166;
  logic select_2169;
  assign select_2169 = or_2119_s5_q ? select_2166 : or_2168;
  logic or_2171;
  assign or_2171 = less_2170_s5_q | select_2169;
  logic select_2176;
  assign select_2176 = less_2114_s5_q ? or_2168 : (less_2120_s5_q ? or_2165_s5_q : select_2174_s5_q);
  logic select_2178;
  assign select_2178 = less_2106_s5_q ? (less_2107_s5_q | (or_2112_s5_q ? select_2169 : or_2171)) : (less_2109_s5_q ? or_2171 : select_2176);
  // hls/stages/agreement.hpp:811
  logic and_2182;
  assign and_2182 = cfg_prove_i & and_1938;
  // hls/stages/agreement.hpp:812
  logic [36:0] sum_2183;
  assign sum_2183 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2185;
  assign less_2185 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:770
  logic or_2188;
  assign or_2188 = ({detail_left, 3'h0} < {sum_2183, detail_right[1:0]}) | (less_2185 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:815
  logic [36:0] sum_2192;
  assign sum_2192 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2194;
  assign less_2194 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:770
  logic or_2195;
  assign or_2195 = ({detail_right, 3'h0} < {sum_2192, detail_left[1:0]}) | less_2194;
  // hls/stages/agreement.hpp:343
  logic [19:0] select_2208;
  assign select_2208 = equal_941_s5_q ? (equal_1933_s5_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2210;
  assign select_2210 = equal_941_s5_q ? (equal_1933_s5_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2212;
  assign select_2212 = equal_941_s5_q ? (equal_1933_s5_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2214;
  assign select_2214 = equal_941_s5_q ? (equal_1933_s5_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [23:0] select_2224;
  assign select_2224 = equal_941_s5_q ? (equal_1933_s5_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2226;
  assign select_2226 = equal_941_s5_q ? (equal_1933_s5_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2228;
  assign select_2228 = equal_941_s5_q ? (equal_1933_s5_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2230;
  assign select_2230 = equal_941_s5_q ? (equal_1933_s5_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  // hls/stages/agreement.hpp:766
  logic [11:0] select_2239;
  assign select_2239 = equal_1004_s5_q ? 12'h0 : (less_1556 ? 12'h0 : regions_rdata_q[35:24]);

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s5_q;
  logic fresh_we;
  assign fresh_we = s5_en & and_357_s5_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s5_q, and_470, and_446_s5_q, and_445_s5_q, and_420_s5_q, less_412_s5_q, less_411_s5_q, less_410_s5_q, less_409_s5_q, less_408_s5_q, less_407_s5_q, less_406_s5_q, less_405_s5_q, less_404_s5_q, less_403_s5_q, less_402_s5_q, less_401_s5_q, less_400_s5_q, less_399_s5_q, less_398_s5_q, less_397_s5_q, less_396_s5_q, less_395_s5_q, less_394_s5_q, less_393_s5_q, less_392_s5_q, less_391_s5_q, less_390_s5_q, less_389_s5_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {^fresh_wdata, fresh_wdata};
  end
`ifndef SYNTHESIS
  logic [6:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [6:0] fresh_raddr_s2_sim;
  logic fresh_re_s2_sim;
  logic [6:0] fresh_raddr_s3_sim;
  logic fresh_re_s3_sim;
  logic [6:0] fresh_raddr_s4_sim;
  logic fresh_re_s4_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_re_s1_sim <= 1'b0;
      fresh_re_s2_sim <= 1'b0;
      fresh_re_s3_sim <= 1'b0;
      fresh_re_s4_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s1_sim <= fresh_re;
      fresh_raddr_s1_sim <= fresh_raddr;
      fresh_re_s2_sim <= fresh_re_s1_sim;
      fresh_raddr_s2_sim <= fresh_raddr_s1_sim;
      fresh_re_s3_sim <= fresh_re_s2_sim;
      fresh_raddr_s3_sim <= fresh_raddr_s2_sim;
      fresh_re_s4_sim <= fresh_re_s3_sim;
      fresh_raddr_s4_sim <= fresh_raddr_s3_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && fresh_we) begin
      if (fresh_re && fresh_raddr == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s1_sim && fresh_raddr_s1_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s2_sim && fresh_raddr_s2_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s3_sim && fresh_raddr_s3_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s4_sim && fresh_raddr_s4_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_waddr >= 7'd80) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd80) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s5_q, or_1002_s5_q, or_999_s5_q, or_996_s5_q};
  logic regions_we;
  assign regions_we = s5_en & and_1030_s5_q;
  logic [35:0] regions_wdata;
  assign regions_wdata = {sum_1029, sum_1023, sum_1018};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {^regions_wdata, regions_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
    end
  end
`endif

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1068_s5_q, index_2_s5_q};
  logic map_we;
  assign map_we = s5_en & and_1142_s5_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_1132, is_seen};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {^map_wdata, map_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && map_we) begin
      if (map_re && map_raddr == map_waddr) begin
        $error("map: address %0d is read less than DISTANCE steps after its write", map_waddr);
      end
      if (map_waddr >= 14'd9600) $error("map: write outside, address %0d", map_waddr);
    end
    if (rst_ni && map_re && map_raddr >= 14'd9600) $error("map: read outside, address %0d", map_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_left_misses_q <= 20'h0;
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      counts_supervised_q <= 14'h0;
      counts_textured_q <= 14'h0;
      counts_explained_q <= 14'h0;
      counts_nearer_q <= 14'h0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_too_little_explained_q <= 24'h0;
      counts_too_many_bad_q <= 24'h0;
      counts_too_much_unproven_q <= 24'h0;
      counts_too_much_unseen_skin_q <= 24'h0;
      registration_counts_across_0_q <= 20'h0;
      registration_counts_across_1_q <= 20'h0;
      registration_counts_across_2_q <= 20'h0;
      registration_counts_across_3_q <= 20'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      segment_started_q <= 1'b0;
      good_q <= 48'h0;
      good_next_q <= 48'h0;
      product_0_q <= 36'h0;
      product_1_q <= 36'h0;
      addend_0_q <= 35'h0;
      addend_1_q <= 35'h0;
      multiplier_0_q <= 18'h0;
      multiplier_1_q <= 18'h0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s5_en) begin
      census_left_misses_q <= select_1291;
      sharpness_sums_detail_0_q <= and_357_s5_q ? select_1311 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_357_s5_q ? select_1322 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_357_s5_q ? sum_1326 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_357_s5_q ? sum_1330 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1518;
      counts_textured_q <= and_1513_s5_q ? 14'h0 : (counts_textured_q + {13'h0, and_1520});
      counts_explained_q <= and_1513_s5_q ? 14'h0 : (counts_explained_q + {13'h0, and_1524});
      counts_nearer_q <= and_1513_s5_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1528});
      counts_unproven_q <= and_1513_s5_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1553});
      counts_regions_bad_q <= select_1568;
      counts_too_little_explained_q <= and_1513_s5_q ? 24'h0 : sum_1574;
      counts_too_many_bad_q <= select_1582;
      counts_too_much_unproven_q <= and_1513_s5_q ? 24'h0 : sum_1593;
      counts_too_much_unseen_skin_q <= and_1513_s5_q ? 24'h0 : sum_1601;
      registration_counts_across_0_q <= and_1513_s5_q ? 20'h0 : sum_1663;
      registration_counts_across_1_q <= and_1513_s5_q ? 20'h0 : sum_1673;
      registration_counts_across_2_q <= and_1513_s5_q ? 20'h0 : sum_1682;
      registration_counts_across_3_q <= and_1513_s5_q ? 20'h0 : sum_1690;
      segment_textured_q <= select_1015 + {6'h0, and_1520};
      segment_explained_q <= select_1020 + {6'h0, and_1524};
      segment_nearer_q <= select_1026 + {6'h0, and_1528};
      segment_started_q <= ~segment_starts_q;
      good_q <= select_1948;
      good_next_q <= equal_941_s5_q ? select_1946 : good_next_q;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1970;
      addend_1_q <= select_1971;
      multiplier_0_q <= select_1972;
      multiplier_1_q <= select_1973;
      seen_q <= select_2065;
      nearer_q <= select_2068;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_quarter_1_0_q = 9'h0;
    averager_quarter_1_1_q = 9'h0;
    averager_quarter_2_0_q = 9'h0;
    averager_quarter_2_1_q = 9'h0;
    averager_detail_0_q = 14'h0;
    averager_detail_1_q = 14'h0;
    census_changes_values_0_left_q = 12'h0;
    census_changes_values_0_right_q = 12'h0;
    census_changes_values_1_left_q = 12'h0;
    census_changes_values_1_right_q = 12'h0;
    census_changes_values_2_left_q = 12'h0;
    census_changes_values_2_right_q = 12'h0;
    sharpness_last_mask_q = 1'b0;
    sharpness_last_detail_0_q = 14'h0;
    sharpness_last_detail_1_q = 14'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s5_en) begin
      averager_quarter_1_0_q <= select_1166;
      averager_quarter_1_1_q <= select_1168;
      averager_quarter_2_0_q <= select_1170;
      averager_quarter_2_1_q <= select_1172;
      averager_detail_0_q <= select_1184;
      averager_detail_1_q <= select_1192;
      census_changes_values_0_left_q <= and_357_s5_q ? texture_s5_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_357_s5_q ? sum_1275_s5_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1277;
      census_changes_values_1_right_q <= select_1278;
      census_changes_values_2_left_q <= select_1279;
      census_changes_values_2_right_q <= select_1280;
      sharpness_last_mask_q <= and_357_s5_q ? whole_2_s5_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_357_s5_q ? select_1296[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_357_s5_q ? select_1296[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s6_q;
  logic [7:0] pixel_1_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic and_2045_s6_q;
  logic or_2070_s6_q;
  logic and_2071_s6_q;
  logic [13:0] select_2073_s6_q;
  logic [13:0] select_2075_s6_q;
  logic [13:0] select_2077_s6_q;
  logic [13:0] select_2079_s6_q;
  logic [13:0] select_2081_s6_q;
  logic [13:0] select_2083_s6_q;
  logic and_2087_s6_q;
  logic and_2091_s6_q;
  logic and_2102_s6_q;
  logic and_2181_s6_q;
  logic and_2191_s6_q;
  logic and_2198_s6_q;
  logic and_2206_s6_q;
  logic [19:0] select_2208_s6_q;
  logic [19:0] select_2210_s6_q;
  logic [19:0] select_2212_s6_q;
  logic [19:0] select_2214_s6_q;
  logic [11:0] select_2216_s6_q;
  logic [11:0] select_2218_s6_q;
  logic [11:0] select_2220_s6_q;
  logic [11:0] select_2222_s6_q;
  logic [23:0] select_2224_s6_q;
  logic [23:0] select_2226_s6_q;
  logic [23:0] select_2228_s6_q;
  logic [23:0] select_2230_s6_q;
  logic and_2231_s6_q;
  logic [5:0] select_2233_s6_q;
  logic [11:0] select_2235_s6_q;
  logic [11:0] select_2237_s6_q;
  logic [11:0] select_2240_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      pixel_1_s6_q <= pixel_1_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= line_ended_q;
      and_2045_s6_q <= said_q;
      or_2070_s6_q <= not_2069 | select_2065;
      and_2071_s6_q <= cfg_prove_i & select_2068;
      select_2073_s6_q <= select_2073;
      select_2075_s6_q <= select_2075;
      select_2077_s6_q <= select_2077;
      select_2079_s6_q <= select_2079;
      select_2081_s6_q <= select_2081;
      select_2083_s6_q <= select_2083;
      and_2087_s6_q <= and_2087_s5_q;
      and_2091_s6_q <= equal_941_s5_q & (equal_1933_s5_q & (cfg_prove_i & not_2088));
      and_2102_s6_q <= equal_941_s5_q & (equal_1933_s5_q & select_2100);
      and_2181_s6_q <= equal_941_s5_q & (equal_1933_s5_q & (cfg_prove_i & select_2178));
      and_2191_s6_q <= equal_941_s5_q & (equal_1933_s5_q & (and_2182 & or_2188));
      and_2198_s6_q <= equal_941_s5_q & (equal_1933_s5_q & (and_2182 & or_2195));
      and_2206_s6_q <= and_2206_s5_q;
      select_2208_s6_q <= select_2208;
      select_2210_s6_q <= select_2210;
      select_2212_s6_q <= select_2212;
      select_2214_s6_q <= select_2214;
      select_2216_s6_q <= select_2216_s5_q;
      select_2218_s6_q <= select_2218_s5_q;
      select_2220_s6_q <= select_2220_s5_q;
      select_2222_s6_q <= select_2222_s5_q;
      select_2224_s6_q <= select_2224;
      select_2226_s6_q <= select_2226;
      select_2228_s6_q <= select_2228;
      select_2230_s6_q <= select_2230;
      and_2231_s6_q <= and_2231_s5_q;
      select_2233_s6_q <= equal_941_s5_q ? (equal_1004_s5_q ? 6'h0 : x_s5_q) : 6'h0;
      select_2235_s6_q <= equal_941_s5_q ? (equal_1004_s5_q ? 12'h0 : select_1557) : 12'h0;
      select_2237_s6_q <= equal_941_s5_q ? (equal_1004_s5_q ? 12'h0 : select_1560) : 12'h0;
      select_2240_s6_q <= equal_941_s5_q ? select_2239 : 12'h0;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (averager_memory_error | census_memory_error | fresh_error | left_error | right_codes_error | best_left_error | best_right_error | near_right_error | shown_right_error | regions_error | seen_columns_error | map_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s6_q;
  assign pixel_1_o = pixel_1_s6_q;
  assign saturated_o = saturated_s6_q;
  assign mask_o = mask_s6_q;
  assign marks_first_o = marks_first_s6_q;
  assign marks_last_o = marks_last_s6_q;
  assign marks_seen_o = or_2070_s6_q;
  assign marks_nearer_o = and_2071_s6_q;
  assign verdict_valid_o = and_2045_s6_q;
  assign verdict_supervised_o = {2'h0, select_2073_s6_q};
  assign verdict_textured_o = {2'h0, select_2075_s6_q};
  assign verdict_explained_o = {2'h0, select_2077_s6_q};
  assign verdict_nearer_o = {2'h0, select_2079_s6_q};
  assign verdict_unproven_o = {2'h0, select_2081_s6_q};
  assign verdict_regions_bad_o = {2'h0, select_2083_s6_q};
  assign verdict_unproven_yet_o = and_2087_s6_q;
  assign verdict_untextured_o = and_2091_s6_q;
  assign verdict_disagree_o = and_2102_s6_q;
  assign verdict_moved_o = and_2181_s6_q;
  assign verdict_unsharp_left_o = and_2191_s6_q;
  assign verdict_unsharp_right_o = and_2198_s6_q;
  assign verdict_hidden_o = and_2206_s6_q;
  assign verdict_across_0_o = select_2208_s6_q;
  assign verdict_across_1_o = select_2210_s6_q;
  assign verdict_across_2_o = select_2212_s6_q;
  assign verdict_across_3_o = select_2214_s6_q;
  assign verdict_measured_0_o = select_2216_s6_q;
  assign verdict_measured_1_o = select_2218_s6_q;
  assign verdict_measured_2_o = select_2220_s6_q;
  assign verdict_measured_3_o = select_2222_s6_q;
  assign verdict_detail_0_o = select_2224_s6_q;
  assign verdict_detail_1_o = select_2226_s6_q;
  assign verdict_contrast_0_o = select_2228_s6_q;
  assign verdict_contrast_1_o = select_2230_s6_q;
  assign region_valid_o = and_2231_s6_q;
  assign region_region_o = select_2233_s6_q;
  assign region_textured_o = select_2235_s6_q;
  assign region_explained_o = select_2237_s6_q;
  assign region_nearer_o = select_2240_s6_q;
  assign valid_o = valid_s6_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{right[1:0], left[1:0], sum_2105[2:0], sum_1645[0], sum_1641[0], sum_1633[1:0], sum_1632[1:0], sum_1628[0], detail_4[1:0], detail_3[1:0], sum_1285[4:0], sum_879[8:0], sum_468[4:0], cfg_width_i[2:0]};

endmodule
