// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 6 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2567 bits, pipeline 1279 bits, memories 67008 bits.
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
  logic [6:0] sum_1367;
  assign sum_1367 = {1'b0, cfg_width_i[9:4]} + 7'h7;
  logic [5:0] sum_1382;
  assign sum_1382 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_1860;
  assign difference_1860 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2003;
  assign less_2003 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2004;
  assign sum_2004 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_2022;
  assign not_2022 = ~cfg_prove_i;

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
  // hls/stages/agreement.hpp:743
  logic drew;
  assign drew = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:377
  logic equal_377;
  assign equal_377 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:557
  logic or_378;
  assign or_378 = drew | equal_377;
  // hls/stages/agreement.hpp:435
  logic not_379;
  assign not_379 = ~or_378;
  // hls/stages/agreement.hpp:377
  logic equal_380;
  assign equal_380 = run_phase_q == 3'h3;
  logic equal_382;
  assign equal_382 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:567
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
  // hls/stages/agreement.hpp:454
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:181
  logic and_525;
  assign and_525 = equal_380 & (age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q})));
  logic select_526;
  assign select_526 = or_378 ? not_384 : and_525;
  // hls/stages/agreement.hpp:143
  logic not_943;
  assign not_943 = ~drew;
  // hls/stages/agreement.hpp:691
  logic [6:0] sum_1092;
  assign sum_1092 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:204
  logic [2:0] select_1102;
  assign select_1102 = sample_pair_whole_q ? (sample_last_q ? (select_336 + 3'h1) : select_336) : raster_at_y_q;
  logic [6:0] select_1104;
  assign select_1104 = sample_pair_whole_q ? (select_320 + {6'h0, equal_353}) : raster_at_column_q;
  logic [5:0] select_1107;
  assign select_1107 = sample_pair_whole_q ? (sample_last_q ? (select_414 + {5'h0, equal_354}) : select_414) : raster_at_row_q;
  logic select_1111;
  assign select_1111 = sample_pair_whole_q ? (sample_last_q ? (or_325 & (~raster_final_row_q)) : or_325) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_1113;
  assign select_1113 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:204
  logic select_1117;
  assign select_1117 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:285
  logic equal_1289;
  assign equal_1289 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:200
  logic [2:0] select_1290;
  assign select_1290 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1293;
  assign select_1293 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1296;
  assign select_1296 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1299;
  assign select_1299 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1302;
  assign select_1302 = ends_q ? following_shift_q : run_shift_q;
  logic select_1305;
  assign select_1305 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:286
  logic not_1306;
  assign not_1306 = ~equal_1289;
  // hls/stages/agreement.hpp:367
  logic not_1309;
  assign not_1309 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:377
  logic equal_1310;
  assign equal_1310 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:160
  logic or_1311;
  assign or_1311 = equal_1310 | equal_382;
  logic [2:0] select_1312;
  assign select_1312 = equal_380 ? {run_last_shift_q, {2{not_1309}}} : {1'b0, or_1311, equal_382};
  logic [2:0] select_1314;
  assign select_1314 = drew ? {{2{final_row_q}}, 1'b0} : (equal_377 ? 3'h5 : select_1312);
  logic [7:0] select_1316;
  assign select_1316 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1317;
  assign select_1317 = equal_382 ? least_q : 7'h0;
  logic [7:0] select_1319;
  assign select_1319 = equal_377 ? 8'h0 : (equal_380 ? select_1316 : {1'b0, select_1317});
  logic [7:0] select_1322;
  assign select_1322 = run_last_shift_q ? {1'b0, last_q} : (run_shift_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1324;
  assign select_1324 = equal_382 ? last_q : (equal_1310 ? last_q : 7'h0);
  logic [7:0] select_1326;
  assign select_1326 = equal_377 ? {1'b0, last_q} : (equal_380 ? select_1322 : {1'b0, select_1324});
  logic [7:0] select_1331;
  assign select_1331 = equal_380 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_382 ? first_beats_q : (equal_1310 ? whole_beats_q : 8'h0));
  logic [5:0] select_1337;
  assign select_1337 = equal_380 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_382 ? (6'h0 - least_q[5:0]) : 6'h0);
  logic select_1344;
  assign select_1344 = equal_380 ? (next_last_shift_q & not_1309) : (equal_382 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1348;
  assign select_1348 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1352;
  assign select_1352 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:292
  logic less_1359;
  assign less_1359 = 7'h1c < column;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1362;
  assign select_1362 = and_357 ? (equal_1289 ? (less_1359 ? 7'h1d : column) : least_q) : least_q;
  // hls/stages/agreement.hpp:286
  logic [7:0] select_1365;
  assign select_1365 = equal_1289 ? (less_1359 ? ({1'b0, cfg_width_i[9:3]} + 8'hf1) : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1369;
  assign select_1369 = and_357 ? (equal_1289 ? {sum_1367, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:342
  logic not_1370;
  assign not_1370 = ~ends_q;
  // hls/stages/agreement.hpp:200
  logic [5:0] select_1371;
  assign select_1371 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1373;
  assign select_1373 = and_357 ? (equal_1289 ? 7'h0 : {select_1371, not_1370}) : {select_1371, not_1370};
  // hls/stages/agreement.hpp:200
  logic and_1375;
  assign and_1375 = not_1370 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:302
  logic [6:0] sum_1378;
  assign sum_1378 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:286
  logic select_1380;
  assign select_1380 = equal_1289 ? ({sum_1378[6], cfg_height_i[8:3]} == {1'b0, sum_1378[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:601
  logic [5:0] sum_1567;
  assign sum_1567 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:153
  logic not_1912;
  assign not_1912 = ~run_shift_q[5];

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:871; read in stage 0, written in stage 5: 0 < 5 < 0 + DISTANCE.
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

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:872; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:873; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory best_left, 80 x 22 and parity, DISTANCE 12, hls/stages/agreement.hpp:874; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [22:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 23'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_378 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_526;
  logic [22:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [21:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[21:0];
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
      raster_at_y_q <= select_1102;
      raster_at_column_q <= select_1104;
      raster_at_row_q <= select_1107;
      raster_at_live_q <= select_1111;
      raster_rows_left_q <= sample_pair_whole_q ? select_1113 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_1117;
      averager_place_q <= sample_pair_whole_q ? select_324 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= and_357 ? (equal_1289 ? 3'h1 : select_1290) : select_1290;
      run_lowest_q <= and_357 ? (equal_1289 ? 8'h0 : select_1293) : select_1293;
      run_highest_q <= and_357 ? (equal_1289 ? 8'h0 : select_1296) : select_1296;
      run_beats_q <= and_357 ? (equal_1289 ? 8'hc : select_1299) : select_1299;
      run_shift_q <= and_357 ? (equal_1289 ? 6'h0 : select_1302) : select_1302;
      run_last_shift_q <= and_357 ? (select_1305 & not_1306) : select_1305;
      following_phase_q <= select_1314;
      following_lowest_q <= drew ? 8'h0 : select_1319;
      following_highest_q <= drew ? 8'h0 : select_1326;
      following_beats_q <= drew ? 8'h3f : (equal_377 ? whole_beats_q : select_1331);
      following_shift_q <= drew ? 6'h0 : (equal_377 ? 6'h0 : select_1337);
      following_last_shift_q <= not_943 & ((~equal_377) & select_1344);
      x_q <= and_357 ? (equal_1289 ? 8'h0 : select_1348) : select_1348;
      beats_left_q <= and_357 ? (equal_1289 ? 8'hc : select_1352) : select_1352;
      last_q <= and_357 ? (equal_1289 ? column : last_q) : last_q;
      least_q <= select_1362;
      first_beats_q <= and_357 ? select_1365 : first_beats_q;
      whole_beats_q <= select_1369;
      age_q <= select_1373;
      ends_q <= and_357 ? (and_1375 & not_1306) : and_1375;
      final_row_q <= and_357 ? select_1380 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1912}}, 1'b1} + run_beats_q;
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
  logic [1:0] age_s1_q;
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
  logic equal_529_s1_q;
  logic equal_596_s1_q;
  logic equal_833_s1_q;
  logic and_891_s1_q;
  logic equal_897_s1_q;
  logic equal_907_s1_q;
  logic not_943_s1_q;
  logic equal_963_s1_q;
  logic not_1094_s1_q;
  logic equal_1289_s1_q;
  logic less_1568_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      age_s1_q <= {age_q[6], age_q[4]};
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
      equal_529_s1_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_596_s1_q <= run_lowest_q == x_q;
      equal_833_s1_q <= run_lowest_q == x;
      and_891_s1_q <= not_379 & and_525;
      equal_897_s1_q <= run_highest_q == x;
      equal_907_s1_q <= run_phase_q == 3'h6;
      not_943_s1_q <= not_943;
      equal_963_s1_q <= x_q == {1'b0, last_q};
      not_1094_s1_q <= ~({sum_1092, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1289_s1_q <= equal_1289;
      less_1568_s1_q <= {1'b0, sum_1567, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:410
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
  // hls/stages/agreement.hpp:411
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
  logic and_535;
  assign and_535 = left_rdata_q[44] & not_384_s1_q;
  logic [11:0] a;
  assign a = less_383_s1_q ? 12'h0 : left_rdata_q[43:32];
  logic [11:0] b;
  assign b = less_383_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_541;
  assign not_541 = ~(a ^ b);
  logic [1:0] sum_543;
  assign sum_543 = {1'b0, not_541[2]} + ({1'b0, not_541[0]} + {1'b0, not_541[1]});
  logic [2:0] sum_546;
  assign sum_546 = {2'h0, not_541[5]} + ({2'h0, not_541[4]} + ({2'h0, not_541[3]} + {1'b0, sum_543}));
  logic [2:0] sum_547;
  assign sum_547 = {2'h0, not_541[6]} + sum_546;
  logic [3:0] sum_550;
  assign sum_550 = {3'h0, not_541[9]} + ({3'h0, not_541[8]} + ({3'h0, not_541[7]} + {1'b0, sum_547}));
  // hls/stages/agreement.hpp:170
  logic [11:0] a_2;
  assign a_2 = less_383_s1_q ? 12'h0 : left_rdata_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_560;
  assign not_560 = ~(a_2 ^ b_2);
  logic [1:0] sum_562;
  assign sum_562 = {1'b0, not_560[2]} + ({1'b0, not_560[0]} + {1'b0, not_560[1]});
  logic [2:0] sum_565;
  assign sum_565 = {2'h0, not_560[5]} + ({2'h0, not_560[4]} + ({2'h0, not_560[3]} + {1'b0, sum_562}));
  logic [2:0] sum_566;
  assign sum_566 = {2'h0, not_560[6]} + sum_565;
  logic [3:0] sum_569;
  assign sum_569 = {3'h0, not_560[9]} + ({3'h0, not_560[8]} + ({3'h0, not_560[7]} + {1'b0, sum_566}));
  // hls/stages/agreement.hpp:170
  logic and_574;
  assign and_574 = left_rdata_q[76] & not_384_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_383_s1_q ? 12'h0 : left_rdata_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_580;
  assign not_580 = ~(a_3 ^ b_3);
  logic [1:0] sum_582;
  assign sum_582 = {1'b0, not_580[2]} + ({1'b0, not_580[0]} + {1'b0, not_580[1]});
  logic [2:0] sum_585;
  assign sum_585 = {2'h0, not_580[5]} + ({2'h0, not_580[4]} + ({2'h0, not_580[3]} + {1'b0, sum_582}));
  logic [2:0] sum_586;
  assign sum_586 = {2'h0, not_580[6]} + sum_585;
  logic [3:0] sum_589;
  assign sum_589 = {3'h0, not_580[9]} + ({3'h0, not_580[8]} + ({3'h0, not_580[7]} + {1'b0, sum_586}));
  logic [11:0] not_601;
  assign not_601 = ~(a ^ b_2);
  logic [1:0] sum_603;
  assign sum_603 = {1'b0, not_601[2]} + ({1'b0, not_601[0]} + {1'b0, not_601[1]});
  logic [2:0] sum_606;
  assign sum_606 = {2'h0, not_601[5]} + ({2'h0, not_601[4]} + ({2'h0, not_601[3]} + {1'b0, sum_603}));
  logic [2:0] sum_607;
  assign sum_607 = {2'h0, not_601[6]} + sum_606;
  logic [3:0] sum_610;
  assign sum_610 = {3'h0, not_601[9]} + ({3'h0, not_601[8]} + ({3'h0, not_601[7]} + {1'b0, sum_607}));
  logic [11:0] not_616;
  assign not_616 = ~(a_2 ^ b_3);
  logic [1:0] sum_618;
  assign sum_618 = {1'b0, not_616[2]} + ({1'b0, not_616[0]} + {1'b0, not_616[1]});
  logic [2:0] sum_621;
  assign sum_621 = {2'h0, not_616[5]} + ({2'h0, not_616[4]} + ({2'h0, not_616[3]} + {1'b0, sum_618}));
  logic [2:0] sum_622;
  assign sum_622 = {2'h0, not_616[6]} + sum_621;
  logic [3:0] sum_625;
  assign sum_625 = {3'h0, not_616[9]} + ({3'h0, not_616[8]} + ({3'h0, not_616[7]} + {1'b0, sum_622}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_4;
  assign b_4 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_634;
  assign not_634 = ~(a_3 ^ b_4);
  logic [1:0] sum_636;
  assign sum_636 = {1'b0, not_634[2]} + ({1'b0, not_634[0]} + {1'b0, not_634[1]});
  logic [2:0] sum_639;
  assign sum_639 = {2'h0, not_634[5]} + ({2'h0, not_634[4]} + ({2'h0, not_634[3]} + {1'b0, sum_636}));
  logic [2:0] sum_640;
  assign sum_640 = {2'h0, not_634[6]} + sum_639;
  logic [3:0] sum_643;
  assign sum_643 = {3'h0, not_634[9]} + ({3'h0, not_634[8]} + ({3'h0, not_634[7]} + {1'b0, sum_640}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_5;
  assign b_5 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_658;
  assign not_658 = ~(a ^ b_5);
  logic [1:0] sum_660;
  assign sum_660 = {1'b0, not_658[2]} + ({1'b0, not_658[0]} + {1'b0, not_658[1]});
  logic [2:0] sum_663;
  assign sum_663 = {2'h0, not_658[5]} + ({2'h0, not_658[4]} + ({2'h0, not_658[3]} + {1'b0, sum_660}));
  logic [2:0] sum_664;
  assign sum_664 = {2'h0, not_658[6]} + sum_663;
  logic [3:0] sum_667;
  assign sum_667 = {3'h0, not_658[9]} + ({3'h0, not_658[8]} + ({3'h0, not_658[7]} + {1'b0, sum_664}));
  logic [11:0] not_673;
  assign not_673 = ~(a_2 ^ b);
  logic [1:0] sum_675;
  assign sum_675 = {1'b0, not_673[2]} + ({1'b0, not_673[0]} + {1'b0, not_673[1]});
  logic [2:0] sum_678;
  assign sum_678 = {2'h0, not_673[5]} + ({2'h0, not_673[4]} + ({2'h0, not_673[3]} + {1'b0, sum_675}));
  logic [2:0] sum_679;
  assign sum_679 = {2'h0, not_673[6]} + sum_678;
  logic [3:0] sum_682;
  assign sum_682 = {3'h0, not_673[9]} + ({3'h0, not_673[8]} + ({3'h0, not_673[7]} + {1'b0, sum_679}));
  logic [11:0] not_689;
  assign not_689 = ~(a_3 ^ b_2);
  logic [1:0] sum_691;
  assign sum_691 = {1'b0, not_689[2]} + ({1'b0, not_689[0]} + {1'b0, not_689[1]});
  logic [2:0] sum_694;
  assign sum_694 = {2'h0, not_689[5]} + ({2'h0, not_689[4]} + ({2'h0, not_689[3]} + {1'b0, sum_691}));
  logic [2:0] sum_695;
  assign sum_695 = {2'h0, not_689[6]} + sum_694;
  logic [3:0] sum_698;
  assign sum_698 = {3'h0, not_689[9]} + ({3'h0, not_689[8]} + ({3'h0, not_689[7]} + {1'b0, sum_695}));
  logic [11:0] not_713;
  assign not_713 = ~(a ^ b_3);
  logic [1:0] sum_715;
  assign sum_715 = {1'b0, not_713[2]} + ({1'b0, not_713[0]} + {1'b0, not_713[1]});
  logic [2:0] sum_718;
  assign sum_718 = {2'h0, not_713[5]} + ({2'h0, not_713[4]} + ({2'h0, not_713[3]} + {1'b0, sum_715}));
  logic [2:0] sum_719;
  assign sum_719 = {2'h0, not_713[6]} + sum_718;
  logic [3:0] sum_722;
  assign sum_722 = {3'h0, not_713[9]} + ({3'h0, not_713[8]} + ({3'h0, not_713[7]} + {1'b0, sum_719}));
  logic [11:0] not_728;
  assign not_728 = ~(a_2 ^ b_4);
  logic [1:0] sum_730;
  assign sum_730 = {1'b0, not_728[2]} + ({1'b0, not_728[0]} + {1'b0, not_728[1]});
  logic [2:0] sum_733;
  assign sum_733 = {2'h0, not_728[5]} + ({2'h0, not_728[4]} + ({2'h0, not_728[3]} + {1'b0, sum_730}));
  logic [2:0] sum_734;
  assign sum_734 = {2'h0, not_728[6]} + sum_733;
  logic [3:0] sum_737;
  assign sum_737 = {3'h0, not_728[9]} + ({3'h0, not_728[8]} + ({3'h0, not_728[7]} + {1'b0, sum_734}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_6;
  assign b_6 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_746;
  assign not_746 = ~(a_3 ^ b_6);
  logic [1:0] sum_748;
  assign sum_748 = {1'b0, not_746[2]} + ({1'b0, not_746[0]} + {1'b0, not_746[1]});
  logic [2:0] sum_751;
  assign sum_751 = {2'h0, not_746[5]} + ({2'h0, not_746[4]} + ({2'h0, not_746[3]} + {1'b0, sum_748}));
  logic [2:0] sum_752;
  assign sum_752 = {2'h0, not_746[6]} + sum_751;
  logic [3:0] sum_755;
  assign sum_755 = {3'h0, not_746[9]} + ({3'h0, not_746[8]} + ({3'h0, not_746[7]} + {1'b0, sum_752}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_7;
  assign b_7 = less_383_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_775;
  assign not_775 = ~(a ^ b_7);
  logic [1:0] sum_777;
  assign sum_777 = {1'b0, not_775[2]} + ({1'b0, not_775[0]} + {1'b0, not_775[1]});
  logic [2:0] sum_780;
  assign sum_780 = {2'h0, not_775[5]} + ({2'h0, not_775[4]} + ({2'h0, not_775[3]} + {1'b0, sum_777}));
  logic [2:0] sum_781;
  assign sum_781 = {2'h0, not_775[6]} + sum_780;
  logic [3:0] sum_784;
  assign sum_784 = {3'h0, not_775[9]} + ({3'h0, not_775[8]} + ({3'h0, not_775[7]} + {1'b0, sum_781}));
  logic [11:0] not_790;
  assign not_790 = ~(a_2 ^ b_5);
  logic [1:0] sum_792;
  assign sum_792 = {1'b0, not_790[2]} + ({1'b0, not_790[0]} + {1'b0, not_790[1]});
  logic [2:0] sum_795;
  assign sum_795 = {2'h0, not_790[5]} + ({2'h0, not_790[4]} + ({2'h0, not_790[3]} + {1'b0, sum_792}));
  logic [2:0] sum_796;
  assign sum_796 = {2'h0, not_790[6]} + sum_795;
  logic [3:0] sum_799;
  assign sum_799 = {3'h0, not_790[9]} + ({3'h0, not_790[8]} + ({3'h0, not_790[7]} + {1'b0, sum_796}));
  logic [11:0] not_806;
  assign not_806 = ~(a_3 ^ b);
  logic [1:0] sum_808;
  assign sum_808 = {1'b0, not_806[2]} + ({1'b0, not_806[0]} + {1'b0, not_806[1]});
  logic [2:0] sum_811;
  assign sum_811 = {2'h0, not_806[5]} + ({2'h0, not_806[4]} + ({2'h0, not_806[3]} + {1'b0, sum_808}));
  logic [2:0] sum_812;
  assign sum_812 = {2'h0, not_806[6]} + sum_811;
  logic [3:0] sum_815;
  assign sum_815 = {3'h0, not_806[9]} + ({3'h0, not_806[8]} + ({3'h0, not_806[7]} + {1'b0, sum_812}));
  // hls/stages/agreement.hpp:571
  logic [6:0] sum_892;
  assign sum_892 = x_s1_q[6:0] + {best_left_rdata_q[13], best_left_rdata_q[13:8]};
  // hls/stages/agreement.hpp:475
  logic [6:0] partner;
  assign partner = {run_shift_s1_q[5], run_shift_s1_q} + x_s1_2_q;
  // hls/stages/agreement.hpp:339
  logic and_1096;
  assign and_1096 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1094_s1_q);
  // hls/stages/agreement.hpp:282
  logic [5:0] or_1236;
  assign or_1236 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:286
  logic select_1385;
  assign select_1385 = equal_1289_s1_q ? (~({row_s1_q, 1'b0} < {sum_1382, cfg_height_i[3]})) : lower_half_q;

  // Memory best_right, 80 x 15 and parity, DISTANCE 12, hls/stages/agreement.hpp:875; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [15:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 16'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_378_s1_q ? sum_892 : partner;
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
      row_q <= and_357_s1_q ? (equal_1289_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_357_s1_q ? select_1385 : lower_half_q;
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
  logic [1:0] age_s2_q;
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
  logic left_rdata_s2_q;
  logic [6:0] x_s2_2_q;
  logic [21:0] best_left_rdata_s2_q;
  logic equal_529_s2_q;
  logic and_535_s2_q;
  logic and_536_s2_q;
  logic not_541_s2_q;
  logic [3:0] sum_551_s2_q;
  logic and_554_s2_q;
  logic and_555_s2_q;
  logic not_560_s2_q;
  logic [3:0] sum_570_s2_q;
  logic and_574_s2_q;
  logic and_575_s2_q;
  logic not_580_s2_q;
  logic [3:0] sum_590_s2_q;
  logic equal_596_s2_q;
  logic not_601_s2_q;
  logic [3:0] sum_611_s2_q;
  logic not_616_s2_q;
  logic [3:0] sum_626_s2_q;
  logic and_630_s2_q;
  logic not_634_s2_q;
  logic [3:0] sum_644_s2_q;
  logic and_654_s2_q;
  logic not_658_s2_q;
  logic [3:0] sum_668_s2_q;
  logic not_673_s2_q;
  logic [3:0] sum_683_s2_q;
  logic not_689_s2_q;
  logic [3:0] sum_699_s2_q;
  logic not_713_s2_q;
  logic [3:0] sum_723_s2_q;
  logic not_728_s2_q;
  logic [3:0] sum_738_s2_q;
  logic and_743_s2_q;
  logic not_746_s2_q;
  logic [3:0] sum_756_s2_q;
  logic and_772_s2_q;
  logic not_775_s2_q;
  logic [3:0] sum_785_s2_q;
  logic not_790_s2_q;
  logic [3:0] sum_800_s2_q;
  logic not_806_s2_q;
  logic [3:0] sum_816_s2_q;
  logic equal_833_s2_q;
  logic and_891_s2_q;
  logic [6:0] sum_892_s2_q;
  logic [6:0] partner_s2_q;
  logic equal_897_s2_q;
  logic equal_907_s2_q;
  logic and_911_s2_q;
  logic and_922_s2_q;
  logic not_943_s2_q;
  logic equal_963_s2_q;
  logic and_1096_s2_q;
  logic equal_1237_s2_q;
  logic equal_1289_s2_q;
  logic less_1566_s2_q;
  logic less_1568_s2_q;
  logic equal_1830_s2_q;
  logic less_1841_s2_q;
  logic equal_1984_s2_q;
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
      left_rdata_s2_q <= left_rdata_q[62];
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      equal_529_s2_q <= equal_529_s1_q;
      and_535_s2_q <= and_535;
      and_536_s2_q <= right_codes_rdata_q[38] & not_384_s1_q;
      not_541_s2_q <= not_541[11];
      sum_551_s2_q <= {3'h0, not_541[10]} + sum_550;
      and_554_s2_q <= left_rdata_q[60] & not_384_s1_q;
      and_555_s2_q <= right_codes_rdata_q[51] & not_384_s1_q;
      not_560_s2_q <= not_560[11];
      sum_570_s2_q <= {3'h0, not_560[10]} + sum_569;
      and_574_s2_q <= and_574;
      and_575_s2_q <= right_codes_rdata_q[64] & not_384_s1_q;
      not_580_s2_q <= not_580[11];
      sum_590_s2_q <= {3'h0, not_580[10]} + sum_589;
      equal_596_s2_q <= equal_596_s1_q;
      not_601_s2_q <= not_601[11];
      sum_611_s2_q <= {3'h0, not_601[10]} + sum_610;
      not_616_s2_q <= not_616[11];
      sum_626_s2_q <= {3'h0, not_616[10]} + sum_625;
      and_630_s2_q <= right_codes_rdata_q[77] & not_384_s1_q;
      not_634_s2_q <= not_634[11];
      sum_644_s2_q <= {3'h0, not_634[10]} + sum_643;
      and_654_s2_q <= right_codes_rdata_q[25] & not_384_s1_q;
      not_658_s2_q <= not_658[11];
      sum_668_s2_q <= {3'h0, not_658[10]} + sum_667;
      not_673_s2_q <= not_673[11];
      sum_683_s2_q <= {3'h0, not_673[10]} + sum_682;
      not_689_s2_q <= not_689[11];
      sum_699_s2_q <= {3'h0, not_689[10]} + sum_698;
      not_713_s2_q <= not_713[11];
      sum_723_s2_q <= {3'h0, not_713[10]} + sum_722;
      not_728_s2_q <= not_728[11];
      sum_738_s2_q <= {3'h0, not_728[10]} + sum_737;
      and_743_s2_q <= and_574 & (right_codes_rdata_q[90] & not_384_s1_q);
      not_746_s2_q <= not_746[11];
      sum_756_s2_q <= {3'h0, not_746[10]} + sum_755;
      and_772_s2_q <= and_535 & (right_codes_rdata_q[12] & not_384_s1_q);
      not_775_s2_q <= not_775[11];
      sum_785_s2_q <= {3'h0, not_775[10]} + sum_784;
      not_790_s2_q <= not_790[11];
      sum_800_s2_q <= {3'h0, not_790[10]} + sum_799;
      not_806_s2_q <= not_806[11];
      sum_816_s2_q <= {3'h0, not_806[10]} + sum_815;
      equal_833_s2_q <= equal_833_s1_q;
      and_891_s2_q <= and_891_s1_q;
      sum_892_s2_q <= sum_892;
      partner_s2_q <= partner;
      equal_897_s2_q <= equal_897_s1_q;
      equal_907_s2_q <= equal_907_s1_q;
      and_911_s2_q <= left_rdata_q[61] & (~(row_q[5:3] == 3'h0));
      and_922_s2_q <= left_rdata_q[63] & not_384_s1_q;
      not_943_s2_q <= not_943_s1_q;
      equal_963_s2_q <= equal_963_s1_q;
      and_1096_s2_q <= and_1096;
      equal_1237_s2_q <= {column_s1_q[6], or_1236} == 7'h0;
      equal_1289_s2_q <= equal_1289_s1_q;
      less_1566_s2_q <= 5'h4 < row_q[5:1];
      less_1568_s2_q <= less_1568_s1_q;
      equal_1830_s2_q <= row_s1_q[5:2] == 4'h0;
      less_1841_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_1984_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [23:0] registration_next_slope_row_q;
  logic [27:0] registration_next_slope_change_q;
  // hls/stages/census.hpp:98
  logic and_332;
  assign and_332 = sample_pair_whole_s2_q & and_331_s2_q;
  // hls/stages/agreement.hpp:420
  logic [3:0] column_2;
  assign column_2 = (and_535_s2_q & and_536_s2_q) ? ({3'h0, not_541_s2_q} + sum_551_s2_q) : 4'h0;
  logic [3:0] select_572;
  assign select_572 = (and_554_s2_q & and_555_s2_q) ? ({3'h0, not_560_s2_q} + sum_570_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_3;
  assign column_3 = {1'b0, column_2} + {1'b0, select_572};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_592;
  assign select_592 = (and_574_s2_q & and_575_s2_q) ? ({3'h0, not_580_s2_q} + sum_590_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_4;
  assign column_4 = {1'b0, column_3} + {2'h0, select_592};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_595;
  assign difference_595 = {2'h0, column_4} - (age_s2_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_598;
  assign sum_598 = difference_595 + (equal_596_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:420
  logic [3:0] column_5;
  assign column_5 = (and_535_s2_q & and_555_s2_q) ? ({3'h0, not_601_s2_q} + sum_611_s2_q) : 4'h0;
  logic [3:0] select_628;
  assign select_628 = (and_554_s2_q & and_575_s2_q) ? ({3'h0, not_616_s2_q} + sum_626_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_6;
  assign column_6 = {1'b0, column_5} + {1'b0, select_628};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_646;
  assign select_646 = (and_574_s2_q & and_630_s2_q) ? ({3'h0, not_634_s2_q} + sum_644_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_7;
  assign column_7 = {1'b0, column_6} + {2'h0, select_646};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_649;
  assign difference_649 = {2'h0, column_7} - (age_s2_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_651;
  assign sum_651 = difference_649 + (equal_596_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:463
  logic less_652;
  assign less_652 = sum_598 < sum_651;
  // hls/stages/agreement.hpp:420
  logic [3:0] column_8;
  assign column_8 = (and_535_s2_q & and_654_s2_q) ? ({3'h0, not_658_s2_q} + sum_668_s2_q) : 4'h0;
  logic [3:0] select_685;
  assign select_685 = (and_554_s2_q & and_536_s2_q) ? ({3'h0, not_673_s2_q} + sum_683_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_9;
  assign column_9 = {1'b0, column_8} + {1'b0, select_685};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_701;
  assign select_701 = (and_574_s2_q & and_555_s2_q) ? ({3'h0, not_689_s2_q} + sum_699_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_10;
  assign column_10 = {1'b0, column_9} + {2'h0, select_701};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_704;
  assign difference_704 = {2'h0, column_10} - (age_s2_q[1] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_706;
  assign sum_706 = difference_704 + (equal_596_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:463
  logic not_708;
  assign not_708 = ~less_652;
  logic [1:0] best;
  assign best = ((less_652 ? sum_651 : sum_598) < sum_706) ? 2'h3 : {not_708, less_652};
  // hls/stages/agreement.hpp:420
  logic [3:0] column_11;
  assign column_11 = (and_535_s2_q & and_575_s2_q) ? ({3'h0, not_713_s2_q} + sum_723_s2_q) : 4'h0;
  logic [3:0] select_740;
  assign select_740 = (and_554_s2_q & and_630_s2_q) ? ({3'h0, not_728_s2_q} + sum_738_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_12;
  assign column_12 = {1'b0, column_11} + {1'b0, select_740};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_758;
  assign select_758 = and_743_s2_q ? ({3'h0, not_746_s2_q} + sum_756_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_13;
  assign column_13 = {1'b0, column_12} + {2'h0, select_758};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_761;
  assign difference_761 = {2'h0, column_13} - (age_s2_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_763;
  assign sum_763 = difference_761 + (equal_596_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:463
  logic [7:0] select_765;
  assign select_765 = best[1] ? (best[0] ? sum_706 : sum_598) : (best[0] ? sum_651 : sum_763);
  logic [1:0] best_2;
  assign best_2 = (select_765 < sum_763) ? 2'h0 : best;
  // hls/stages/agreement.hpp:420
  logic [3:0] column_14;
  assign column_14 = and_772_s2_q ? ({3'h0, not_775_s2_q} + sum_785_s2_q) : 4'h0;
  logic [3:0] select_802;
  assign select_802 = (and_554_s2_q & and_654_s2_q) ? ({3'h0, not_790_s2_q} + sum_800_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_15;
  assign column_15 = {1'b0, column_14} + {1'b0, select_802};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_818;
  assign select_818 = (and_574_s2_q & and_536_s2_q) ? ({3'h0, not_806_s2_q} + sum_816_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_16;
  assign column_16 = {1'b0, column_15} + {2'h0, select_818};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_821;
  assign difference_821 = {2'h0, column_16} - (age_s2_q[1] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_823;
  assign sum_823 = difference_821 + (equal_596_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:591
  logic not_908;
  assign not_908 = ~equal_907_s2_q;
  // hls/stages/agreement.hpp:582
  logic and_912;
  assign and_912 = not_384_s2_q & and_911_s2_q;
  // hls/stages/agreement.hpp:574
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:578
  logic and_917;
  assign and_917 = (left_rdata_s2_q & (8'hb6 < best_left_rdata_s2_q[7:0])) & ($signed(9'h1fe) < $signed(way));
  logic and_918;
  assign and_918 = left_rdata_s2_q & and_911_s2_q;
  // hls/stages/agreement.hpp:582
  logic and_921;
  assign and_921 = not_384_s2_q & (and_911_s2_q ? (and_917 ? left_rdata_s2_q : and_918) : and_918);
  // hls/stages/agreement.hpp:578
  logic less_923;
  assign less_923 = $signed(way[8:1]) < $signed(8'h1);
  // hls/stages/agreement.hpp:582
  logic and_926;
  assign and_926 = not_384_s2_q & (and_911_s2_q & (and_917 & less_923));
  // hls/stages/agreement.hpp:580
  logic and_929;
  assign and_929 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s2_q[13:8]));
  // hls/stages/agreement.hpp:174
  logic and_931;
  assign and_931 = less_923 & ((cfg_nearer_below_i & best_left_rdata_s2_q[13]) | and_929);
  // hls/stages/agreement.hpp:582
  logic and_934;
  assign and_934 = not_384_s2_q & (and_911_s2_q & (and_917 & and_931));
  // hls/stages/agreement.hpp:181
  logic [5:0] select_935;
  assign select_935 = less_383_s2_q ? 6'h0 : best_left_rdata_s2_q[13:8];
  logic [11:0] select_936;
  assign select_936 = or_378_s2_q ? {select_935, and_934, and_926, and_922_s2_q, and_921, and_912, not_384_s2_q} : 12'h0;
  // hls/stages/agreement.hpp:339
  logic and_938;
  assign and_938 = not_908 & (drew_s2_q & select_936[0]);
  logic and_947;
  assign and_947 = not_908 & (drew_s2_q ? select_936[0] : (equal_377_s2_q & select_936[4]));
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1388;
  assign select_1388 = or_378_s2_q ? sums_0_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_13} : sums_0_columns_values_0_q);
  logic [7:0] select_1389;
  assign select_1389 = equal_380_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1391;
  assign select_1391 = equal_380_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1393;
  assign select_1393 = equal_380_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1395;
  assign select_1395 = equal_380_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1397;
  assign select_1397 = equal_380_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1399;
  assign select_1399 = equal_380_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1402;
  assign select_1402 = or_378_s2_q ? sums_0_sum_sums_values_0_q : (equal_380_s2_q ? sum_763 : sums_0_sum_sums_values_0_q);
  logic [7:0] select_1404;
  assign select_1404 = or_378_s2_q ? sums_1_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_7} : sums_1_columns_values_0_q);
  logic [7:0] select_1405;
  assign select_1405 = equal_380_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1407;
  assign select_1407 = equal_380_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1409;
  assign select_1409 = equal_380_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1411;
  assign select_1411 = equal_380_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1413;
  assign select_1413 = equal_380_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1415;
  assign select_1415 = equal_380_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1418;
  assign select_1418 = or_378_s2_q ? sums_1_sum_sums_values_0_q : (equal_380_s2_q ? sum_651 : sums_1_sum_sums_values_0_q);
  logic [7:0] select_1420;
  assign select_1420 = or_378_s2_q ? sums_2_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_4} : sums_2_columns_values_0_q);
  logic [7:0] select_1421;
  assign select_1421 = equal_380_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1423;
  assign select_1423 = equal_380_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1425;
  assign select_1425 = equal_380_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1427;
  assign select_1427 = equal_380_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1429;
  assign select_1429 = equal_380_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1431;
  assign select_1431 = equal_380_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1434;
  assign select_1434 = or_378_s2_q ? sums_2_sum_sums_values_0_q : (equal_380_s2_q ? sum_598 : sums_2_sum_sums_values_0_q);
  logic [7:0] select_1436;
  assign select_1436 = or_378_s2_q ? sums_3_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_10} : sums_3_columns_values_0_q);
  logic [7:0] select_1437;
  assign select_1437 = equal_380_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1439;
  assign select_1439 = equal_380_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1441;
  assign select_1441 = equal_380_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1443;
  assign select_1443 = equal_380_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1445;
  assign select_1445 = equal_380_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1447;
  assign select_1447 = equal_380_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1450;
  assign select_1450 = or_378_s2_q ? sums_3_sum_sums_values_0_q : (equal_380_s2_q ? sum_706 : sums_3_sum_sums_values_0_q);
  logic [7:0] select_1452;
  assign select_1452 = or_378_s2_q ? sums_4_columns_values_0_q : (equal_380_s2_q ? {2'h0, column_16} : sums_4_columns_values_0_q);
  logic [7:0] select_1453;
  assign select_1453 = equal_380_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1455;
  assign select_1455 = equal_380_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1457;
  assign select_1457 = equal_380_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1459;
  assign select_1459 = equal_380_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1461;
  assign select_1461 = equal_380_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1463;
  assign select_1463 = equal_380_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  logic [7:0] select_1466;
  assign select_1466 = or_378_s2_q ? sums_4_sum_sums_values_0_q : (equal_380_s2_q ? sum_823 : sums_4_sum_sums_values_0_q);
  // hls/stages/registration.hpp:158
  logic [16:0] select_1573;
  assign select_1573 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [13:0] select_1575;
  assign select_1575 = ($signed(10'h0) < $signed(select_1573[16:7])) ? 14'h7f : select_1573[13:0];
  // hls/stages/registration.hpp:153
  logic [9:0] select_1576;
  assign select_1576 = select_936[10] ? select_1575[9:0] : 10'h0;
  logic [8:0] difference_1578;
  assign difference_1578 = select_1576[9:1] - (select_936[11] ? select_1575[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1581;
  assign sum_1581 = (select_936[6] ? select_1575[13:1] : 13'h0) + (select_936[7] ? select_1575[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1582;
  assign select_1582 = select_936[8] ? select_1575[11:0] : 12'h0;
  logic [10:0] sum_1584;
  assign sum_1584 = select_1582[11:1] + (select_936[9] ? select_1575[10:0] : 11'h0);
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1585;
  assign sum_1585 = sum_1581[12:1] + {sum_1584, select_1582[0]};
  logic [9:0] sum_1586;
  assign sum_1586 = {difference_1578, select_1576[0]} + sum_1585[11:2];
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1587;
  assign sum_1587 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_1586[9]}}, sum_1586[9:2]};
  // hls/stages/registration.hpp:57
  logic [23:0] select_1831;
  assign select_1831 = equal_1830_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:205
  logic [23:0] select_1833;
  assign select_1833 = and_357_s2_q ? (equal_1289_s2_q ? select_1831 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1834;
  assign select_1834 = equal_1830_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:205
  logic [27:0] select_1836;
  assign select_1836 = and_357_s2_q ? (equal_1289_s2_q ? select_1834 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1838;
  assign select_1838 = drew_s2_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1839;
  assign sum_1839 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1840;
  assign sum_1840 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

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

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:876; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_938;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      registration_next_slope_row_q <= 24'h0;
      registration_next_slope_change_q <= 28'h0;
    end else if (s2_en) begin
      registration_slope_row_q <= select_1833;
      registration_slope_change_q <= select_1836;
      registration_slope_q <= select_1838;
      registration_next_slope_row_q <= sum_1839;
      registration_next_slope_change_q <= sum_1840;
    end
  end

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
      sums_0_columns_values_0_q <= select_1388;
      sums_0_columns_values_1_q <= or_378_s2_q ? sums_0_columns_values_1_q : select_1389;
      sums_0_columns_values_2_q <= or_378_s2_q ? sums_0_columns_values_2_q : select_1391;
      sums_0_columns_values_3_q <= or_378_s2_q ? sums_0_columns_values_3_q : select_1393;
      sums_0_columns_values_4_q <= or_378_s2_q ? sums_0_columns_values_4_q : select_1395;
      sums_0_columns_values_5_q <= or_378_s2_q ? sums_0_columns_values_5_q : select_1397;
      sums_0_columns_values_6_q <= or_378_s2_q ? sums_0_columns_values_6_q : select_1399;
      sums_0_sum_sums_values_0_q <= select_1402;
      sums_1_columns_values_0_q <= select_1404;
      sums_1_columns_values_1_q <= or_378_s2_q ? sums_1_columns_values_1_q : select_1405;
      sums_1_columns_values_2_q <= or_378_s2_q ? sums_1_columns_values_2_q : select_1407;
      sums_1_columns_values_3_q <= or_378_s2_q ? sums_1_columns_values_3_q : select_1409;
      sums_1_columns_values_4_q <= or_378_s2_q ? sums_1_columns_values_4_q : select_1411;
      sums_1_columns_values_5_q <= or_378_s2_q ? sums_1_columns_values_5_q : select_1413;
      sums_1_columns_values_6_q <= or_378_s2_q ? sums_1_columns_values_6_q : select_1415;
      sums_1_sum_sums_values_0_q <= select_1418;
      sums_2_columns_values_0_q <= select_1420;
      sums_2_columns_values_1_q <= or_378_s2_q ? sums_2_columns_values_1_q : select_1421;
      sums_2_columns_values_2_q <= or_378_s2_q ? sums_2_columns_values_2_q : select_1423;
      sums_2_columns_values_3_q <= or_378_s2_q ? sums_2_columns_values_3_q : select_1425;
      sums_2_columns_values_4_q <= or_378_s2_q ? sums_2_columns_values_4_q : select_1427;
      sums_2_columns_values_5_q <= or_378_s2_q ? sums_2_columns_values_5_q : select_1429;
      sums_2_columns_values_6_q <= or_378_s2_q ? sums_2_columns_values_6_q : select_1431;
      sums_2_sum_sums_values_0_q <= select_1434;
      sums_3_columns_values_0_q <= select_1436;
      sums_3_columns_values_1_q <= or_378_s2_q ? sums_3_columns_values_1_q : select_1437;
      sums_3_columns_values_2_q <= or_378_s2_q ? sums_3_columns_values_2_q : select_1439;
      sums_3_columns_values_3_q <= or_378_s2_q ? sums_3_columns_values_3_q : select_1441;
      sums_3_columns_values_4_q <= or_378_s2_q ? sums_3_columns_values_4_q : select_1443;
      sums_3_columns_values_5_q <= or_378_s2_q ? sums_3_columns_values_5_q : select_1445;
      sums_3_columns_values_6_q <= or_378_s2_q ? sums_3_columns_values_6_q : select_1447;
      sums_3_sum_sums_values_0_q <= select_1450;
      sums_4_columns_values_0_q <= select_1452;
      sums_4_columns_values_1_q <= or_378_s2_q ? sums_4_columns_values_1_q : select_1453;
      sums_4_columns_values_2_q <= or_378_s2_q ? sums_4_columns_values_2_q : select_1455;
      sums_4_columns_values_3_q <= or_378_s2_q ? sums_4_columns_values_3_q : select_1457;
      sums_4_columns_values_4_q <= or_378_s2_q ? sums_4_columns_values_4_q : select_1459;
      sums_4_columns_values_5_q <= or_378_s2_q ? sums_4_columns_values_5_q : select_1461;
      sums_4_columns_values_6_q <= or_378_s2_q ? sums_4_columns_values_6_q : select_1463;
      sums_4_sum_sums_values_0_q <= select_1466;
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
  logic or_378_s3_q;
  logic less_383_s3_q;
  logic equal_416_s3_q;
  logic [6:0] x_s3_2_q;
  logic [21:0] best_left_rdata_s3_q;
  logic equal_529_s3_q;
  logic [7:0] sum_598_s3_q;
  logic [7:0] sum_651_s3_q;
  logic [7:0] sum_706_s3_q;
  logic [7:0] sum_763_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_823_s3_q;
  logic equal_833_s3_q;
  logic and_891_s3_q;
  logic [6:0] sum_892_s3_q;
  logic [6:0] partner_s3_q;
  logic [14:0] best_right_rdata_s3_q;
  logic equal_897_s3_q;
  logic equal_907_s3_q;
  logic not_908_s3_q;
  logic [11:0] select_936_s3_q;
  logic and_938_s3_q;
  logic not_943_s3_q;
  logic and_947_s3_q;
  logic equal_963_s3_q;
  logic and_1097_s3_q;
  logic equal_1237_s3_q;
  logic equal_1289_s3_q;
  logic less_1566_s3_q;
  logic less_1568_s3_q;
  logic [7:0] sum_1587_s3_q;
  logic less_1588_s3_q;
  logic less_1589_s3_q;
  logic less_1841_s3_q;
  logic equal_1984_s3_q;
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
      age_s3_q <= age_s2_q[0];
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
      or_378_s3_q <= or_378_s2_q;
      less_383_s3_q <= less_383_s2_q;
      equal_416_s3_q <= equal_416_s2_q;
      x_s3_2_q <= x_s2_2_q;
      best_left_rdata_s3_q <= best_left_rdata_s2_q;
      equal_529_s3_q <= equal_529_s2_q;
      sum_598_s3_q <= sum_598;
      sum_651_s3_q <= sum_651;
      sum_706_s3_q <= sum_706;
      sum_763_s3_q <= sum_763;
      best_2_s3_q <= best_2;
      sum_823_s3_q <= sum_823;
      equal_833_s3_q <= equal_833_s2_q;
      and_891_s3_q <= and_891_s2_q;
      sum_892_s3_q <= sum_892_s2_q;
      partner_s3_q <= partner_s2_q;
      best_right_rdata_s3_q <= best_right_rdata_q;
      equal_897_s3_q <= equal_897_s2_q;
      equal_907_s3_q <= equal_907_s2_q;
      not_908_s3_q <= not_908;
      select_936_s3_q <= select_936;
      and_938_s3_q <= and_938;
      not_943_s3_q <= not_943_s2_q;
      and_947_s3_q <= and_947;
      equal_963_s3_q <= equal_963_s2_q;
      and_1097_s3_q <= not_908 & and_1096_s2_q;
      equal_1237_s3_q <= equal_1237_s2_q;
      equal_1289_s3_q <= equal_1289_s2_q;
      less_1566_s3_q <= less_1566_s2_q;
      less_1568_s3_q <= less_1568_s2_q;
      sum_1587_s3_q <= sum_1587[7:0];
      less_1588_s3_q <= $signed(6'h0) < $signed(sum_1587[12:7]);
      less_1589_s3_q <= $signed(sum_1587[12:7]) < $signed(6'h3f);
      less_1841_s3_q <= less_1841_s2_q;
      equal_1984_s3_q <= equal_1984_s2_q;
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
  // hls/stages/agreement.hpp:455
  logic not_531;
  assign not_531 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_532;
  assign less_532 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:463
  logic [7:0] select_770;
  assign select_770 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_706_s3_q : sum_598_s3_q) : (best_2_s3_q[0] ? sum_651_s3_q : sum_763_s3_q);
  logic less_824;
  assign less_824 = select_770 < sum_823_s3_q;
  logic [1:0] select_825;
  assign select_825 = less_824 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:465
  logic [7:0] select_828;
  assign select_828 = select_825[1] ? (select_825[0] ? sum_706_s3_q : sum_598_s3_q) : (select_825[0] ? sum_651_s3_q : sum_763_s3_q);
  logic [7:0] of_best;
  assign of_best = less_824 ? sum_823_s3_q : select_828;
  logic [7:0] of_best_2;
  assign of_best_2 = (not_531 & (~less_532)) ? of_best : 8'h0;
  // hls/stages/agreement.hpp:467
  logic less_831;
  assign less_831 = $signed(run_shift_s3_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:470
  logic less_832;
  assign less_832 = best_left_rdata_s3_q[7:0] < of_best_2;
  logic or_834;
  assign or_834 = less_832 | equal_833_s3_q;
  // hls/stages/agreement.hpp:473
  logic [7:0] select_837;
  assign select_837 = less_831 ? (or_834 ? of_best_2 : best_left_rdata_s3_q[7:0]) : (less_832 ? of_best_2 : best_left_rdata_s3_q[7:0]);
  logic [5:0] select_841;
  assign select_841 = less_831 ? (or_834 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]) : (less_832 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]);
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_824, select_825} == 3'h4) ? 3'h3 : (({less_824, select_825} == 3'h0) ? 3'h1 : {less_824, select_825});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_848;
  assign sum_848 = near_best + 3'h1;
  logic [7:0] select_851;
  assign select_851 = sum_848[1] ? (sum_848[0] ? sum_706_s3_q : sum_598_s3_q) : (sum_848[0] ? sum_651_s3_q : sum_763_s3_q);
  logic [7:0] below;
  assign below = sum_848[2] ? sum_823_s3_q : select_851;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_853;
  assign sum_853 = near_best + 3'h7;
  logic [7:0] select_856;
  assign select_856 = sum_853[1] ? (sum_853[0] ? sum_706_s3_q : sum_598_s3_q) : (sum_853[0] ? sum_651_s3_q : sum_763_s3_q);
  logic [7:0] above;
  assign above = sum_853[2] ? sum_823_s3_q : select_856;
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/registration.hpp:26
  logic [7:0] select_862;
  assign select_862 = near_best[1] ? (near_best[0] ? sum_706_s3_q : sum_598_s3_q) : (near_best[0] ? sum_651_s3_q : sum_763_s3_q);
  logic [7:0] select_863;
  assign select_863 = near_best[2] ? sum_823_s3_q : select_862;
  logic [7:0] select_864;
  assign select_864 = rise[8] ? below : above;
  logic [8:0] fall;
  assign fall = {1'b0, select_863} - {1'b0, select_864};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [7:0] xor_867;
  assign xor_867 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_867};
  // hls/stages/agreement.hpp:477
  logic less_896;
  assign less_896 = best_right_rdata_s3_q[7:0] < of_best_2;
  logic or_898;
  assign or_898 = less_896 | equal_897_s3_q;
  // hls/stages/agreement.hpp:478
  logic [7:0] select_901;
  assign select_901 = less_831 ? (or_898 ? of_best_2 : best_right_rdata_s3_q[7:0]) : (less_896 ? of_best_2 : best_right_rdata_s3_q[7:0]);
  logic [7:0] select_902;
  assign select_902 = equal_529_s3_q ? of_best_2 : select_901;
  logic [6:0] select_905;
  assign select_905 = less_831 ? (or_898 ? x_s3_2_q : best_right_rdata_s3_q[14:8]) : (less_896 ? x_s3_2_q : best_right_rdata_s3_q[14:8]);
  logic [6:0] select_906;
  assign select_906 = equal_529_s3_q ? x_s3_2_q : select_905;
  // hls/stages/agreement.hpp:181
  logic [14:0] select_940;
  assign select_940 = less_383_s3_q ? 15'h0 : {sum_892_s3_q, best_left_rdata_s3_q[21:14]};
  logic [14:0] select_941;
  assign select_941 = or_378_s3_q ? select_940 : 15'h0;
  // hls/stages/agreement.hpp:339
  logic and_944;
  assign and_944 = not_943_s3_q & select_936_s3_q[5];
  // hls/stages/agreement.hpp:186
  logic shown;
  assign shown = select_936_s3_q[0] & (shown_right_rdata_q[0] | select_936_s3_q[4]);
  logic near;
  assign near = select_936_s3_q[0] & (select_936_s3_q[4] ? select_936_s3_q[5] : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:204
  logic select_1150;
  assign select_1150 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_1152;
  assign select_1152 = sample_pair_whole_s3_q ? (and_355_s3_q ? select_370 : averager_mask_q) : averager_mask_q;
  logic select_1154;
  assign select_1154 = sample_pair_whole_s3_q ? (and_355_s3_q ? select_374 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/registration.hpp:151
  logic [7:0] slope;
  assign slope = less_1588_s3_q ? 8'h7f : (less_1589_s3_q ? 8'h80 : sum_1587_s3_q);
  logic [6:0] select_1592;
  assign select_1592 = select_936_s3_q[6] ? slope[7:1] : 7'h0;
  logic [7:0] select_1593;
  assign select_1593 = select_936_s3_q[7] ? slope : 8'h0;
  logic [8:0] sum_1594;
  assign sum_1594 = {{2{select_1592[6]}}, select_1592} + {select_1593[7], select_1593};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1595;
  assign select_1595 = select_936_s3_q[8] ? slope : 8'h0;
  logic [7:0] select_1596;
  assign select_1596 = select_936_s3_q[9] ? slope : 8'h0;
  logic [8:0] sum_1597;
  assign sum_1597 = {{2{select_1595[7]}}, select_1595[7:1]} + {select_1596[7], select_1596};
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1598;
  assign sum_1598 = {{3{sum_1594[8]}}, sum_1594[8:1]} + {sum_1597[8], sum_1597, select_1595[0]};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1599;
  assign select_1599 = select_936_s3_q[10] ? slope : 8'h0;
  logic [7:0] select_1600;
  assign select_1600 = select_936_s3_q[11] ? slope : 8'h0;
  logic [8:0] difference_1601;
  assign difference_1601 = {{2{select_1599[7]}}, select_1599[7:1]} - {select_1600[7], select_1600};
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1602;
  assign sum_1602 = {difference_1601, select_1599[0]} + {sum_1598[10], sum_1598[10:2]};
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1603;
  assign difference_1603 = {{4{select_941[7]}}, select_941[7:0]} - {sum_1602[9], sum_1602, sum_1598[1]};
  // hls/stages/registration.hpp:158
  logic [11:0] select_1605;
  assign select_1605 = ($signed(difference_1603[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1603;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1605[11:7])) ? 12'h7f : select_1605;
  // hls/stages/registration.hpp:146
  logic [12:0] difference_1689;
  assign difference_1689 = 13'h0 - {residual[11], residual};
  logic less_1773;
  assign less_1773 = $signed(difference_1689) < $signed({7'h0, cfg_moved_half_limit_i});

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

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:907; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s3_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s3_en & and_938_s3_q;
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
  assign best_right_we = s3_en & and_891_s3_q;
  logic [14:0] best_right_wdata;
  assign best_right_wdata = {select_906, select_902};
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

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = drew_s3_q ? x_s3_q[6:0] : select_941[14:8];
  logic shown_right_we;
  assign shown_right_we = s3_en & and_947_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_944, not_943_s3_q};
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      sample_of_skin_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
    end else if (s3_en) begin
      sample_pair_pixel_0_q <= pixel_0_s3_q;
      sample_pair_pixel_1_q <= pixel_1_s3_q;
      sample_of_skin_q <= mask_s3_q;
      averager_running_of_skin_q <= select_1150;
      averager_mask_q <= select_1152;
      averager_of_skin_q <= select_1154;
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
  logic equal_416_s4_q;
  logic [6:0] x_s4_2_q;
  logic [7:0] best_left_rdata_s4_q;
  logic equal_529_s4_q;
  logic select_825_s4_q;
  logic less_831_s4_q;
  logic less_832_s4_q;
  logic or_834_s4_q;
  logic [7:0] select_838_s4_q;
  logic [5:0] select_842_s4_q;
  logic equal_847_s4_q;
  logic rise_s4_q;
  logic [1:0] sum_859_s4_q;
  logic [7:0] twice_s4_q;
  logic [8:0] difference_871_s4_q;
  logic and_891_s4_q;
  logic equal_907_s4_q;
  logic not_908_s4_q;
  logic [5:0] select_936_s4_q;
  logic and_938_s4_q;
  logic not_943_s4_q;
  logic equal_963_s4_q;
  logic shown_s4_q;
  logic near_s4_q;
  logic and_1097_s4_q;
  logic equal_1237_s4_q;
  logic equal_1289_s4_q;
  logic less_1566_s4_q;
  logic less_1568_s4_q;
  logic [7:0] residual_s4_q;
  logic less_1690_s4_q;
  logic less_1773_s4_q;
  logic less_1841_s4_q;
  logic equal_1984_s4_q;
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
      equal_416_s4_q <= equal_416_s3_q;
      x_s4_2_q <= x_s3_2_q;
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      equal_529_s4_q <= equal_529_s3_q;
      select_825_s4_q <= select_825[0];
      less_831_s4_q <= less_831;
      less_832_s4_q <= less_832;
      or_834_s4_q <= or_834;
      select_838_s4_q <= equal_529_s3_q ? of_best_2 : select_837;
      select_842_s4_q <= equal_529_s3_q ? run_shift_s3_q : select_841;
      equal_847_s4_q <= {less_824, select_825} == near_best;
      rise_s4_q <= rise[8];
      sum_859_s4_q <= {less_824, select_825[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_871_s4_q <= {1'b0, twice} - (({twice, 1'b0} < size) ? {twice, 1'b0} : size);
      and_891_s4_q <= and_891_s3_q;
      equal_907_s4_q <= equal_907_s3_q;
      not_908_s4_q <= not_908_s3_q;
      select_936_s4_q <= select_936_s3_q[5:0];
      and_938_s4_q <= and_938_s3_q;
      not_943_s4_q <= not_943_s3_q;
      equal_963_s4_q <= equal_963_s3_q;
      shown_s4_q <= shown;
      near_s4_q <= near;
      and_1097_s4_q <= and_1097_s3_q;
      equal_1237_s4_q <= equal_1237_s3_q;
      equal_1289_s4_q <= equal_1289_s3_q;
      less_1566_s4_q <= less_1566_s3_q;
      less_1568_s4_q <= less_1568_s3_q;
      residual_s4_q <= residual[7:0];
      less_1690_s4_q <= $signed(difference_1689) < $signed({7'h0, cfg_moved_limit_i});
      less_1773_s4_q <= less_1773;
      less_1841_s4_q <= less_1841_s3_q;
      equal_1984_s4_q <= equal_1984_s3_q;
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
  // hls/stages/agreement.hpp:281
  logic equal_413;
  assign equal_413 = column_s4_q == 7'h0;
  logic [3:0] select_417;
  assign select_417 = equal_416_s4_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:282
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
  // hls/stages/agreement.hpp:282
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
  logic not_872;
  assign not_872 = ~difference_871_s4_q[8];
  logic [7:0] xor_873;
  assign xor_873 = twice_s4_q ^ {8{not_872}};
  logic [9:0] sum_874;
  assign sum_874 = {difference_871_s4_q[7:0], 1'b0, not_872} + {not_872, xor_873, not_872};
  logic not_875;
  assign not_875 = ~sum_874[9];
  logic [7:0] xor_876;
  assign xor_876 = twice_s4_q ^ {8{not_875}};
  logic [9:0] sum_877;
  assign sum_877 = {sum_874[8:0], not_875} + {not_875, xor_876, not_875};
  logic not_878;
  assign not_878 = ~sum_877[9];
  logic [7:0] xor_879;
  assign xor_879 = twice_s4_q ^ {8{not_878}};
  logic [9:0] sum_880;
  assign sum_880 = {sum_877[8:0], not_878} + {not_878, xor_879, not_878};
  logic not_881;
  assign not_881 = ~sum_880[9];
  logic [7:0] xor_882;
  assign xor_882 = twice_s4_q ^ {8{not_881}};
  logic [9:0] sum_883;
  assign sum_883 = {sum_880[8:0], not_881} + {not_881, xor_882, not_881};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_884;
  assign difference_884 = {sum_859_s4_q, select_825_s4_q, 5'h0} - {3'h0, difference_871_s4_q[8], sum_874[9], sum_877[9], sum_880[9], sum_883[9]};
  // hls/stages/agreement.hpp:471
  logic [7:0] select_885;
  assign select_885 = rise_s4_q ? difference_884 : {sum_859_s4_q, select_825_s4_q, difference_871_s4_q[8], sum_874[9], sum_877[9], sum_880[9], sum_883[9]};
  logic [7:0] select_886;
  assign select_886 = equal_847_s4_q ? select_885 : {sum_859_s4_q, select_825_s4_q, 5'h0};
  // hls/stages/agreement.hpp:473
  logic [7:0] select_889;
  assign select_889 = less_831_s4_q ? (or_834_s4_q ? select_886 : best_left_rdata_s4_q) : (less_832_s4_q ? select_886 : best_left_rdata_s4_q);
  logic [7:0] select_890;
  assign select_890 = equal_529_s4_q ? select_886 : select_889;
  // hls/stages/agreement.hpp:147
  logic [7:0] select_948;
  assign select_948 = drew_s4_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:628
  logic or_951;
  assign or_951 = select_948[7] | (~({select_948[5], select_948[3], select_948[1]} == 3'h0));
  // hls/stages/agreement.hpp:627
  logic or_954;
  assign or_954 = select_948[7] | (~({select_948[6], select_948[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:626
  logic or_957;
  assign or_957 = select_948[7] | (~(select_948[6:4] == 3'h0));
  // hls/stages/agreement.hpp:339
  logic [5:0] select_958;
  assign select_958 = equal_907_s4_q ? x_s4_q[5:0] : {region_row_q, or_957, or_954, or_951};
  // hls/stages/agreement.hpp:709
  logic equal_959;
  assign equal_959 = x_s4_q[5:4] == 2'h3;
  logic not_960;
  assign not_960 = ~equal_959;
  // hls/stages/division.hpp:18
  logic [5:0] sum_961;
  assign sum_961 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:636
  logic or_964;
  assign or_964 = (~sum_961[5]) | equal_963_s4_q;
  // hls/stages/agreement.hpp:339
  logic and_966;
  assign and_966 = drew_s4_q & (select_936_s4_q[0] & or_964);
  // hls/stages/agreement.hpp:186
  logic textured;
  assign textured = select_936_s4_q[0] & select_936_s4_q[2];
  logic explained;
  assign explained = select_936_s4_q[0] & select_936_s4_q[4];
  logic and_980;
  assign and_980 = select_936_s4_q[0] & ({select_936_s4_q[5], select_936_s4_q[3]} == 2'h3);
  logic and_987;
  assign and_987 = select_936_s4_q[0] & select_936_s4_q[3];
  // hls/stages/agreement.hpp:802
  logic or_992;
  assign or_992 = marks_first_s4_q | line_ended_q;
  // hls/stages/agreement.hpp:804
  logic [17:0] select_994;
  assign select_994 = marks_first_s4_q ? 18'h1 : (or_992 ? {rows_passed_q[16:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:803
  logic [8:0] select_996;
  assign select_996 = or_992 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:811
  logic select_998;
  assign select_998 = cfg_compete_i ? (or_992 & select_994[17]) : (select_996[8] & select_994[9]);
  // hls/stages/agreement.hpp:206
  logic next_row;
  assign next_row = select_998 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:818
  logic [6:0] select_1001;
  assign select_1001 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_1003;
  assign select_1003 = marks_first_s4_q ? 13'h0 : (seen_base_q + {6'h0, select_1001});
  // hls/stages/agreement.hpp:828
  logic equal_1004;
  assign equal_1004 = seen_x_q == 3'h7;
  logic [7:0] select_1006;
  assign select_1006 = select_998 ? 8'h0 : (seen_column_q + {7'h0, equal_1004});
  // hls/stages/agreement.hpp:831
  logic [12:0] index;
  assign index = select_1003 + {5'h0, select_1006};
  // hls/stages/agreement.hpp:802
  logic select_1009;
  assign select_1009 = marks_first_s4_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] sum_1010;
  assign sum_1010 = {1'b0, select_1009, 2'h0, select_1009, 1'b0, {2{select_1009}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:801
  logic not_1011;
  assign not_1011 = ~marks_first_s4_q;
  // hls/stages/agreement.hpp:206
  logic and_1013;
  assign and_1013 = not_1011 & (began_q | select_998);
  // hls/stages/agreement.hpp:829
  logic [2:0] select_1015;
  assign select_1015 = select_998 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:830
  logic and_1017;
  assign and_1017 = and_1013 & (select_1015 == 3'h0);
  logic less_1018;
  assign less_1018 = select_1006 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:692
  logic [7:0] sum_1021;
  assign sum_1021 = {2'h0, x_s4_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1021[7]}}, sum_1021, x_s4_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] sum_1023;
  assign sum_1023 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:606
  logic and_1024;
  assign and_1024 = seen_columns_rdata_q[14] & select_936_s4_q[0];
  logic and_1025;
  assign and_1025 = seen_columns_rdata_q[10] & select_936_s4_q[0];
  logic and_1026;
  assign and_1026 = seen_columns_rdata_q[5] & select_936_s4_q[0];
  logic and_1027;
  assign and_1027 = seen_columns_rdata_q[0] & select_936_s4_q[0];
  // hls/stages/agreement.hpp:665
  logic [1:0] sum_1029;
  assign sum_1029 = {1'b0, and_1026} + ({1'b0, textured} + {1'b0, and_1027});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1024} + ({2'h0, and_1025} + {1'b0, sum_1029});
  // hls/stages/agreement.hpp:672
  logic [4:0] difference_1033;
  assign difference_1033 = {2'h0, textured_2} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:670
  logic equal_1034;
  assign equal_1034 = x_s4_q == 8'h0;
  // hls/stages/agreement.hpp:672
  logic [4:0] t;
  assign t = difference_1033 + (equal_1034 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:606
  logic [7:0] select_1039;
  assign select_1039 = select_936_s4_q[0] ? (sum_961[5] ? select_948 : {select_948[6:0], 1'b0}) : select_948;
  // hls/stages/agreement.hpp:628
  logic or_1042;
  assign or_1042 = select_1039[7] | (~({select_1039[5], select_1039[3], select_1039[1]} == 3'h0));
  // hls/stages/agreement.hpp:606
  logic and_1058;
  assign and_1058 = seen_columns_rdata_q[16] & select_936_s4_q[0];
  logic and_1059;
  assign and_1059 = seen_columns_rdata_q[12] & select_936_s4_q[0];
  logic and_1060;
  assign and_1060 = seen_columns_rdata_q[8] & select_936_s4_q[0];
  logic and_1061;
  assign and_1061 = seen_columns_rdata_q[3] & select_936_s4_q[0];
  // hls/stages/agreement.hpp:667
  logic [1:0] sum_1063;
  assign sum_1063 = {1'b0, and_1060} + ({1'b0, shown_s4_q} + {1'b0, and_1061});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1058} + ({2'h0, and_1059} + {1'b0, sum_1063});
  // hls/stages/agreement.hpp:674
  logic [4:0] difference_1067;
  assign difference_1067 = {2'h0, shown_2} - (age_s4_q ? box_shown_columns_values_4_q : 5'h0);
  logic [4:0] around;
  assign around = difference_1067 + (equal_1034 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:681
  logic [5:0] sum_1070;
  assign sum_1070 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:606
  logic and_1074;
  assign and_1074 = seen_columns_rdata_q[17] & select_936_s4_q[0];
  logic and_1075;
  assign and_1075 = seen_columns_rdata_q[13] & select_936_s4_q[0];
  logic and_1076;
  assign and_1076 = seen_columns_rdata_q[9] & select_936_s4_q[0];
  logic and_1077;
  assign and_1077 = seen_columns_rdata_q[4] & select_936_s4_q[0];
  // hls/stages/agreement.hpp:668
  logic [1:0] sum_1079;
  assign sum_1079 = {1'b0, and_1076} + ({1'b0, near_s4_q} + {1'b0, and_1077});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1074} + ({2'h0, and_1075} + {1'b0, sum_1079});
  // hls/stages/agreement.hpp:675
  logic [4:0] difference_1083;
  assign difference_1083 = {2'h0, near_2} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1083 + (equal_1034 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:204
  logic [10:0] select_1129;
  assign select_1129 = sample_pair_whole_s4_q ? (and_355_s4_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1131;
  assign select_1131 = sample_pair_whole_s4_q ? (and_355_s4_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1155;
  assign select_1155 = and_357_s4_q ? select_363 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1156;
  assign select_1156 = and_357_s4_q ? select_367 : census_columns_values_0_cell_0_right_q;
  logic select_1157;
  assign select_1157 = and_357_s4_q ? whole_2_s4_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_1158;
  assign select_1158 = and_357_s4_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1159;
  assign select_1159 = and_357_s4_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1160;
  assign select_1160 = and_357_s4_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1161;
  assign select_1161 = and_357_s4_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1162;
  assign select_1162 = and_357_s4_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1163;
  assign select_1163 = and_357_s4_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1164;
  assign select_1164 = and_357_s4_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1165;
  assign select_1165 = and_357_s4_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1166;
  assign select_1166 = and_357_s4_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1167;
  assign select_1167 = and_357_s4_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1168;
  assign select_1168 = and_357_s4_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1169;
  assign select_1169 = and_357_s4_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1170;
  assign select_1170 = and_357_s4_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1171;
  assign select_1171 = and_357_s4_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1172;
  assign select_1172 = and_357_s4_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1173;
  assign select_1173 = and_357_s4_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1174;
  assign select_1174 = and_357_s4_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1175;
  assign select_1175 = and_357_s4_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1176;
  assign select_1176 = and_357_s4_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1177;
  assign select_1177 = and_357_s4_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1178;
  assign select_1178 = and_357_s4_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1179;
  assign select_1179 = and_357_s4_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1180;
  assign select_1180 = and_357_s4_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1181;
  assign select_1181 = and_357_s4_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1182;
  assign select_1182 = and_357_s4_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1183;
  assign select_1183 = and_357_s4_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1184;
  assign select_1184 = and_357_s4_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1185;
  assign select_1185 = and_357_s4_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1186;
  assign select_1186 = and_357_s4_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1187;
  assign select_1187 = and_357_s4_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1188;
  assign select_1188 = and_357_s4_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1189;
  assign select_1189 = and_357_s4_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1190;
  assign select_1190 = and_357_s4_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1191;
  assign select_1191 = and_357_s4_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1192;
  assign select_1192 = and_357_s4_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1193;
  assign select_1193 = and_357_s4_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1194;
  assign select_1194 = and_357_s4_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1195;
  assign select_1195 = and_357_s4_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1196;
  assign select_1196 = and_357_s4_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1197;
  assign select_1197 = and_357_s4_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1198;
  assign select_1198 = and_357_s4_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1199;
  assign select_1199 = and_357_s4_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1200;
  assign select_1200 = and_357_s4_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1201;
  assign select_1201 = and_357_s4_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1202;
  assign select_1202 = and_357_s4_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1203;
  assign select_1203 = and_357_s4_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1204;
  assign select_1204 = and_357_s4_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1205;
  assign select_1205 = and_357_s4_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1206;
  assign select_1206 = and_357_s4_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1207;
  assign select_1207 = and_357_s4_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1208;
  assign select_1208 = and_357_s4_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1209;
  assign select_1209 = and_357_s4_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1210;
  assign select_1210 = and_357_s4_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1212;
  assign difference_1212 = {1'b0, select_367} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1213;
  assign xor_1213 = difference_1212[8:0] ^ {9{difference_1212[9]}};
  logic [9:0] sum_1214;
  assign sum_1214 = {9'h0, difference_1212[9]} + {1'b0, xor_1213};
  logic [9:0] difference_1215;
  assign difference_1215 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1216;
  assign xor_1216 = difference_1215[8:0] ^ {9{difference_1215[9]}};
  logic [9:0] sum_1217;
  assign sum_1217 = {9'h0, difference_1215[9]} + {1'b0, xor_1216};
  logic [9:0] difference_1219;
  assign difference_1219 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1220;
  assign xor_1220 = difference_1219[8:0] ^ {9{difference_1219[9]}};
  logic [9:0] sum_1221;
  assign sum_1221 = {9'h0, difference_1219[9]} + {1'b0, xor_1220};
  logic [10:0] sum_1222;
  assign sum_1222 = ({1'b0, sum_1214} + {1'b0, sum_1217}) + {1'b0, sum_1221};
  logic [9:0] difference_1223;
  assign difference_1223 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1224;
  assign xor_1224 = difference_1223[8:0] ^ {9{difference_1223[9]}};
  logic [9:0] sum_1225;
  assign sum_1225 = {9'h0, difference_1223[9]} + {1'b0, xor_1224};
  logic [9:0] difference_1227;
  assign difference_1227 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1228;
  assign xor_1228 = difference_1227[8:0] ^ {9{difference_1227[9]}};
  logic [9:0] sum_1229;
  assign sum_1229 = {9'h0, difference_1227[9]} + {1'b0, xor_1228};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1257;
  assign difference_1257 = {1'b0, select_363} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1257[9]} + (difference_1257[8:0] ^ {9{difference_1257[9]}});
  logic [9:0] difference_1268;
  assign difference_1268 = {1'b0, select_367} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1268[9]} + (difference_1268[8:0] ^ {9{difference_1268[9]}});
  // hls/stages/agreement.hpp:205
  logic and_1468;
  assign and_1468 = and_357_s4_q & (equal_416_s4_q & equal_1289_s4_q);
  // hls/stages/agreement.hpp:339
  logic and_1471;
  assign and_1471 = not_908_s4_q & (drew_s4_q & (select_936_s4_q[0] & select_936_s4_q[1]));
  // hls/stages/agreement.hpp:606
  logic and_1488;
  assign and_1488 = seen_columns_rdata_q[15] & select_936_s4_q[0];
  logic and_1489;
  assign and_1489 = seen_columns_rdata_q[11] & select_936_s4_q[0];
  logic and_1490;
  assign and_1490 = seen_columns_rdata_q[7] & select_936_s4_q[0];
  logic and_1491;
  assign and_1491 = seen_columns_rdata_q[2] & select_936_s4_q[0];
  // hls/stages/agreement.hpp:666
  logic [1:0] sum_1493;
  assign sum_1493 = {1'b0, and_1490} + ({1'b0, explained} + {1'b0, and_1491});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_1488} + ({2'h0, and_1489} + {1'b0, sum_1493});
  // hls/stages/agreement.hpp:673
  logic [4:0] difference_1497;
  assign difference_1497 = {2'h0, explained_2} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_1497 + (equal_1034 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:680
  logic [5:0] sum_1500;
  assign sum_1500 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:600
  logic [9:0] select_1560;
  assign select_1560 = ({select_936_s4_q[3], select_936_s4_q[1]} == 2'h3) ? ({1'b0, select_936_s4_q[5], 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:339
  logic [9:0] select_1563;
  assign select_1563 = equal_907_s4_q ? 10'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1560 : 10'h0) : 10'h0);
  // hls/stages/agreement.hpp:533
  logic [23:0] select_1565;
  assign select_1565 = and_1468 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1563[9]}}, select_1563});
  // hls/stages/registration.hpp:73
  logic equal_1569;
  assign equal_1569 = {lower_half_s4_q, less_1568_s4_q} == 2'h3;
  logic equal_1570;
  assign equal_1570 = {lower_half_s4_q, less_1568_s4_q} == 2'h2;
  logic equal_1571;
  assign equal_1571 = {lower_half_s4_q, less_1568_s4_q} == 2'h1;
  logic not_1645;
  assign not_1645 = ~equal_1569;
  logic not_1646;
  assign not_1646 = ~equal_1570;
  // hls/stages/agreement.hpp:186
  logic and_1651;
  assign and_1651 = select_936_s4_q[4] & (less_1566_s4_q & (not_1645 & (not_1646 & (~equal_1571))));
  // hls/stages/agreement.hpp:339
  logic and_1654;
  assign and_1654 = not_908_s4_q & (drew_s4_q & (select_936_s4_q[0] & and_1651));
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1656;
  assign select_1656 = and_1468 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1654});
  // hls/stages/agreement.hpp:186
  logic and_1660;
  assign and_1660 = select_936_s4_q[4] & (less_1566_s4_q & (not_1645 & (equal_1571 & not_1646)));
  // hls/stages/agreement.hpp:339
  logic and_1663;
  assign and_1663 = not_908_s4_q & (drew_s4_q & (select_936_s4_q[0] & and_1660));
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1665;
  assign select_1665 = and_1468 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1663});
  // hls/stages/agreement.hpp:186
  logic and_1669;
  assign and_1669 = select_936_s4_q[0] & (select_936_s4_q[4] & (less_1566_s4_q & (equal_1570 & not_1645)));
  // hls/stages/agreement.hpp:339
  logic and_1671;
  assign and_1671 = not_908_s4_q & (drew_s4_q & and_1669);
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1673;
  assign select_1673 = and_1468 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1671});
  // hls/stages/agreement.hpp:186
  logic and_1676;
  assign and_1676 = select_936_s4_q[0] & (select_936_s4_q[4] & (less_1566_s4_q & equal_1569));
  // hls/stages/agreement.hpp:339
  logic and_1678;
  assign and_1678 = not_908_s4_q & (drew_s4_q & and_1676);
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1680;
  assign select_1680 = and_1468 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1678});
  // hls/stages/registration.hpp:146
  logic less_1681;
  assign less_1681 = $signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:186
  logic and_1682;
  assign and_1682 = less_1566_s4_q & less_1681;
  logic [1:0] select_1684;
  assign select_1684 = select_936_s4_q[0] ? (select_936_s4_q[4] ? {and_1682, less_1566_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1686;
  assign select_1686 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? select_1684 : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1687;
  assign sum_1687 = registration_counts_votes_0_down_q + {{13{select_1686[1]}}, select_1686};
  // hls/stages/agreement.hpp:186
  logic and_1691;
  assign and_1691 = less_1566_s4_q & less_1690_s4_q;
  logic [1:0] select_1693;
  assign select_1693 = select_936_s4_q[0] ? (select_936_s4_q[4] ? {and_1691, less_1566_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1695;
  assign select_1695 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? select_1693 : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1696;
  assign sum_1696 = registration_counts_votes_0_up_q + {{13{select_1695[1]}}, select_1695};
  // hls/stages/registration.hpp:80
  logic not_1698;
  assign not_1698 = ~less_1568_s4_q;
  // hls/stages/registration.hpp:79
  logic and_1699;
  assign and_1699 = less_1681 & not_1698;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1701;
  assign select_1701 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1699, not_1698} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1704;
  assign select_1704 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1701 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1705;
  assign sum_1705 = registration_counts_votes_1_down_q + {{13{select_1704[1]}}, select_1704};
  // hls/stages/registration.hpp:79
  logic and_1707;
  assign and_1707 = less_1690_s4_q & not_1698;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1709;
  assign select_1709 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1707, not_1698} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1712;
  assign select_1712 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1709 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1713;
  assign sum_1713 = registration_counts_votes_1_up_q + {{13{select_1712[1]}}, select_1712};
  // hls/stages/registration.hpp:79
  logic and_1715;
  assign and_1715 = less_1568_s4_q & less_1681;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1717;
  assign select_1717 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1715, less_1568_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1720;
  assign select_1720 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1717 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1721;
  assign sum_1721 = registration_counts_votes_2_down_q + {{13{select_1720[1]}}, select_1720};
  // hls/stages/registration.hpp:79
  logic and_1723;
  assign and_1723 = less_1568_s4_q & less_1690_s4_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1725;
  assign select_1725 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1723, less_1568_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1728;
  assign select_1728 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1725 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1729;
  assign sum_1729 = registration_counts_votes_2_up_q + {{13{select_1728[1]}}, select_1728};
  // hls/stages/registration.hpp:80
  logic not_1731;
  assign not_1731 = ~lower_half_s4_q;
  // hls/stages/agreement.hpp:186
  logic and_1732;
  assign and_1732 = less_1681 & not_1731;
  logic [1:0] select_1734;
  assign select_1734 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1732, not_1731} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1737;
  assign select_1737 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1734 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1738;
  assign sum_1738 = registration_counts_votes_3_down_q + {{13{select_1737[1]}}, select_1737};
  // hls/stages/agreement.hpp:186
  logic and_1740;
  assign and_1740 = less_1690_s4_q & not_1731;
  logic [1:0] select_1742;
  assign select_1742 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1740, not_1731} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1745;
  assign select_1745 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1742 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1746;
  assign sum_1746 = registration_counts_votes_3_up_q + {{13{select_1745[1]}}, select_1745};
  // hls/stages/agreement.hpp:186
  logic and_1748;
  assign and_1748 = lower_half_s4_q & less_1681;
  logic [1:0] select_1750;
  assign select_1750 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1748, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1753;
  assign select_1753 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1750 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1754;
  assign sum_1754 = registration_counts_votes_4_down_q + {{13{select_1753[1]}}, select_1753};
  // hls/stages/agreement.hpp:186
  logic and_1756;
  assign and_1756 = lower_half_s4_q & less_1690_s4_q;
  logic [1:0] select_1758;
  assign select_1758 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1756, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1761;
  assign select_1761 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1758 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1762;
  assign sum_1762 = registration_counts_votes_4_up_q + {{13{select_1761[1]}}, select_1761};
  // hls/stages/registration.hpp:146
  logic less_1764;
  assign less_1764 = $signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1765;
  assign and_1765 = not_1698 & less_1764;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1767;
  assign select_1767 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1765, not_1698} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1770;
  assign select_1770 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1767 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1771;
  assign sum_1771 = registration_counts_half_votes_0_down_q + {{13{select_1770[1]}}, select_1770};
  // hls/stages/registration.hpp:79
  logic and_1774;
  assign and_1774 = not_1698 & less_1773_s4_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1776;
  assign select_1776 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1774, not_1698} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1779;
  assign select_1779 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1776 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1780;
  assign sum_1780 = registration_counts_half_votes_0_up_q + {{13{select_1779[1]}}, select_1779};
  // hls/stages/registration.hpp:79
  logic and_1782;
  assign and_1782 = less_1568_s4_q & less_1764;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1784;
  assign select_1784 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1782, less_1568_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1787;
  assign select_1787 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1784 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1788;
  assign sum_1788 = registration_counts_half_votes_1_down_q + {{13{select_1787[1]}}, select_1787};
  // hls/stages/registration.hpp:79
  logic and_1790;
  assign and_1790 = less_1568_s4_q & less_1773_s4_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1792;
  assign select_1792 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1790, less_1568_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1795;
  assign select_1795 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1792 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1796;
  assign sum_1796 = registration_counts_half_votes_1_up_q + {{13{select_1795[1]}}, select_1795};
  // hls/stages/agreement.hpp:186
  logic and_1798;
  assign and_1798 = less_1764 & not_1731;
  logic [1:0] select_1800;
  assign select_1800 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1798, not_1731} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1803;
  assign select_1803 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1800 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1804;
  assign sum_1804 = registration_counts_half_votes_2_down_q + {{13{select_1803[1]}}, select_1803};
  // hls/stages/agreement.hpp:186
  logic and_1806;
  assign and_1806 = less_1773_s4_q & not_1731;
  logic [1:0] select_1808;
  assign select_1808 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1806, not_1731} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1811;
  assign select_1811 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1808 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1812;
  assign sum_1812 = registration_counts_half_votes_2_up_q + {{13{select_1811[1]}}, select_1811};
  // hls/stages/agreement.hpp:186
  logic and_1814;
  assign and_1814 = lower_half_s4_q & less_1764;
  logic [1:0] select_1816;
  assign select_1816 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1814, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1819;
  assign select_1819 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1816 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1820;
  assign sum_1820 = registration_counts_half_votes_3_down_q + {{13{select_1819[1]}}, select_1819};
  // hls/stages/agreement.hpp:186
  logic and_1822;
  assign and_1822 = lower_half_s4_q & less_1773_s4_q;
  logic [1:0] select_1824;
  assign select_1824 = select_936_s4_q[4] ? (less_1566_s4_q ? {and_1822, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1827;
  assign select_1827 = equal_907_s4_q ? 2'h0 : (drew_s4_q ? (select_936_s4_q[0] ? select_1824 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1828;
  assign sum_1828 = registration_counts_half_votes_3_up_q + {{13{select_1827[1]}}, select_1827};
  // hls/stages/division.hpp:34
  logic [7:0] sum_1842;
  assign sum_1842 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:286
  logic [2:0] select_1844;
  assign select_1844 = less_1841_s4_q ? (sum_1842[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1846;
  assign select_1846 = equal_1289_s4_q ? (equal_416_s4_q ? 3'h0 : select_1844) : region_row_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1850;
  assign sum_1850 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1851;
  assign select_1851 = sum_961[5] ? {1'b1, sum_961[4:0], region_across_rest_q[2:0]} : sum_1850;
  // hls/stages/agreement.hpp:286
  logic [8:0] select_1855;
  assign select_1855 = equal_1289_s4_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_1858;
  assign select_1858 = equal_1289_s4_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  logic [8:0] select_1862;
  assign select_1862 = equal_416_s4_q ? {{2{difference_1860[6]}}, difference_1860} : (less_1841_s4_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1864;
  assign select_1864 = and_357_s4_q ? (equal_1289_s4_q ? select_1862 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:286
  logic [6:0] select_1866;
  assign select_1866 = equal_416_s4_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1868;
  assign select_1868 = and_357_s4_q ? (equal_1289_s4_q ? select_1866 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1869;
  assign sum_1869 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1870;
  assign select_1870 = sum_1842[7] ? {1'b1, sum_1842[6:0], region_down_rest_q[0]} : sum_1869;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1842[7];
  // hls/stages/agreement.hpp:286
  logic select_1874;
  assign select_1874 = equal_1289_s4_q ? (equal_416_s4_q | (less_1841_s4_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:147
  logic or_1879;
  assign or_1879 = segment_starts_q | not_943_s4_q;
  // hls/stages/agreement.hpp:606
  logic select_1882;
  assign select_1882 = select_936_s4_q[0] ? (sum_961[5] ? (equal_963_s4_q & or_964) : or_964) : or_1879;
  // hls/stages/agreement.hpp:722
  logic equal_1886;
  assign equal_1886 = x_s4_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:724
  logic [7:0] select_1904;
  assign select_1904 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1906;
  assign select_1906 = equal_907_s4_q ? (equal_1886 ? select_1904 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:149
  logic not_1907;
  assign not_1907 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:339
  logic [4:0] select_1928;
  assign select_1928 = equal_907_s4_q ? box_textured_columns_values_0_q : (drew_s4_q ? {2'h0, textured_2} : box_textured_columns_values_0_q);
  logic [4:0] select_1929;
  assign select_1929 = drew_s4_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1931;
  assign select_1931 = drew_s4_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1933;
  assign select_1933 = drew_s4_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1935;
  assign select_1935 = drew_s4_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1938;
  assign select_1938 = equal_907_s4_q ? box_textured_sum_sums_values_0_q : (drew_s4_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1939;
  assign select_1939 = drew_s4_q ? {2'h0, explained_2} : box_explained_columns_values_0_q;
  logic [4:0] select_1941;
  assign select_1941 = drew_s4_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1943;
  assign select_1943 = drew_s4_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1945;
  assign select_1945 = drew_s4_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1947;
  assign select_1947 = drew_s4_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1950;
  assign select_1950 = equal_907_s4_q ? box_explained_sum_sums_values_0_q : (drew_s4_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1952;
  assign select_1952 = equal_907_s4_q ? box_shown_columns_values_0_q : (drew_s4_q ? {2'h0, shown_2} : box_shown_columns_values_0_q);
  logic [4:0] select_1953;
  assign select_1953 = drew_s4_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [4:0] select_1955;
  assign select_1955 = drew_s4_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [4:0] select_1957;
  assign select_1957 = drew_s4_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [4:0] select_1959;
  assign select_1959 = drew_s4_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [4:0] select_1962;
  assign select_1962 = equal_907_s4_q ? box_shown_sum_sums_values_0_q : (drew_s4_q ? around : box_shown_sum_sums_values_0_q);
  logic [4:0] select_1964;
  assign select_1964 = equal_907_s4_q ? box_nearer_columns_values_0_q : (drew_s4_q ? {2'h0, near_2} : box_nearer_columns_values_0_q);
  logic [4:0] select_1965;
  assign select_1965 = drew_s4_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1967;
  assign select_1967 = drew_s4_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1969;
  assign select_1969 = drew_s4_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1971;
  assign select_1971 = drew_s4_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_1974;
  assign select_1974 = equal_907_s4_q ? box_nearer_sum_sums_values_0_q : (drew_s4_q ? n : box_nearer_sum_sums_values_0_q);
  logic select_1976;
  assign select_1976 = equal_907_s4_q ? centres_values_0_textured_q : (drew_s4_q ? and_1026 : centres_values_0_textured_q);
  logic select_1978;
  assign select_1978 = drew_s4_q ? (seen_columns_rdata_q[6] & select_936_s4_q[0]) : centres_values_0_of_skin_q;
  logic select_1980;
  assign select_1980 = drew_s4_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_1982;
  assign select_1982 = drew_s4_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  // hls/stages/agreement.hpp:286
  logic [12:0] select_1987;
  assign select_1987 = equal_1289_s4_q ? (equal_1984_s4_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1990;
  assign select_1990 = and_357_s4_q ? (equal_1289_s4_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:827
  logic [2:0] select_2002;
  assign select_2002 = marks_first_s4_q ? 3'h0 : (select_998 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:206
  logic [7:0] select_2007;
  assign select_2007 = marks_first_s4_q ? (less_2003 ? {sum_2004, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:831
  logic and_2013;
  assign and_2013 = and_1097_s4_q & ({sum_1023, index_2[5:0]} == {sum_1010, index[5:0]});
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2058;
  assign sum_2058 = {1'b0, upper} + {1'b0, lower};
  logic less_2059;
  assign less_2059 = 11'h4 < sum_2058[13:3];
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};
  // hls/stages/registration.hpp:100
  logic less_2062;
  assign less_2062 = 11'he < left[12:2];
  // hls/stages/registration.hpp:119
  logic less_2064;
  assign less_2064 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_2065;
  assign or_2065 = (~less_2062) | less_2064;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:100
  logic less_2067;
  assign less_2067 = 11'he < right[12:2];
  // hls/stages/registration.hpp:119
  logic less_2069;
  assign less_2069 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic select_2071;
  assign select_2071 = less_2059 ? (or_2065 ? less_2064 : less_2069) : less_2069;
  logic or_2072;
  assign or_2072 = (~less_2067) | select_2071;
  // hls/stages/registration.hpp:100
  logic less_2073;
  assign less_2073 = 11'he < upper[12:2];
  // hls/stages/registration.hpp:119
  logic less_2075;
  assign less_2075 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/registration.hpp:104
  logic select_2076;
  assign select_2076 = or_2072 ? select_2071 : less_2075;
  logic select_2078;
  assign select_2078 = less_2059 ? select_2076 : (less_2062 ? select_2076 : less_2075);
  logic or_2079;
  assign or_2079 = (~less_2073) | select_2078;
  // hls/stages/registration.hpp:119
  logic less_2080;
  assign less_2080 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_2081;
  assign select_2081 = or_2079 ? select_2078 : less_2080;
  logic select_2084;
  assign select_2084 = less_2059 ? select_2081 : (less_2062 ? select_2081 : (less_2067 ? select_2081 : less_2080));
  // hls/stages/registration.hpp:101
  logic less_2085;
  assign less_2085 = 11'he < lower[12:2];
  // hls/stages/registration.hpp:104
  logic or_2087;
  assign or_2087 = select_2084 | (~less_2085);
  // hls/stages/registration.hpp:119
  logic less_2088;
  assign less_2088 = $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
  // hls/stages/registration.hpp:105
  logic select_2089;
  assign select_2089 = or_2087 ? select_2084 : less_2088;
  logic select_2092;
  assign select_2092 = less_2062 ? select_2089 : (less_2067 ? select_2089 : (less_2073 ? select_2089 : less_2088));
  // hls/stages/agreement.hpp:726
  logic and_2104;
  assign and_2104 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2105;
  assign or_2105 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2104;
  logic select_2106;
  assign select_2106 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2105 : and_2104;
  logic and_2107;
  assign and_2107 = (less_2073 & less_2085) & select_2106;
  logic or_2108;
  assign or_2108 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2107;
  logic select_2109;
  assign select_2109 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2108 : and_2107;
  logic or_2110;
  assign or_2110 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2109;
  logic select_2111;
  assign select_2111 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2110 : select_2109;
  logic select_2112;
  assign select_2112 = (less_2062 & less_2067) ? select_2111 : and_2107;
  logic or_2113;
  assign or_2113 = (less_2059 ? select_2089 : select_2092) | select_2112;
  // hls/stages/registration.hpp:119
  logic less_2114;
  assign less_2114 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  // hls/stages/agreement.hpp:726
  logic or_2115;
  assign or_2115 = less_2114 | or_2113;
  logic select_2116;
  assign select_2116 = or_2087 ? or_2113 : or_2115;
  // hls/stages/registration.hpp:119
  logic less_2117;
  assign less_2117 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2120;
  assign less_2120 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2123;
  assign less_2123 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:726
  logic and_2156;
  assign and_2156 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1904 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:339
  logic [11:0] select_2169;
  assign select_2169 = equal_907_s4_q ? (equal_1886 ? registration_counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2171;
  assign select_2171 = equal_907_s4_q ? (equal_1886 ? registration_counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2173;
  assign select_2173 = equal_907_s4_q ? (equal_1886 ? registration_counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2175;
  assign select_2175 = equal_907_s4_q ? (equal_1886 ? registration_counts_measured_3_q : 12'h0) : 12'h0;

  // Memory regions, 64 x 36 and parity, DISTANCE 12, hls/stages/agreement.hpp:892; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [36:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 37'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_958;
  logic regions_re;
  assign regions_re = s4_en & (equal_907_s4_q ? not_960 : and_966);
  logic [36:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [35:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[35:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:911; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1010, index[5:0]};
  logic map_re;
  assign map_re = s4_en & (and_1017 & less_1018);
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
  assign best_left_we = s4_en & and_891_s4_q;
  logic [21:0] best_left_wdata;
  assign best_left_wdata = {select_890, select_842_s4_q, select_838_s4_q};
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

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s4_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s4_en & and_938_s4_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near_s4_q, shown_s4_q, explained, and_987, textured};
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
      counts_too_much_hidden_q <= select_1565;
      registration_counts_measured_0_q <= select_1656;
      registration_counts_measured_1_q <= select_1665;
      registration_counts_measured_2_q <= select_1673;
      registration_counts_measured_3_q <= select_1680;
      registration_counts_votes_0_down_q <= and_1468 ? 15'h0 : sum_1687;
      registration_counts_votes_0_up_q <= and_1468 ? 15'h0 : sum_1696;
      registration_counts_votes_1_down_q <= and_1468 ? 15'h0 : sum_1705;
      registration_counts_votes_1_up_q <= and_1468 ? 15'h0 : sum_1713;
      registration_counts_votes_2_down_q <= and_1468 ? 15'h0 : sum_1721;
      registration_counts_votes_2_up_q <= and_1468 ? 15'h0 : sum_1729;
      registration_counts_votes_3_down_q <= and_1468 ? 15'h0 : sum_1738;
      registration_counts_votes_3_up_q <= and_1468 ? 15'h0 : sum_1746;
      registration_counts_votes_4_down_q <= and_1468 ? 15'h0 : sum_1754;
      registration_counts_votes_4_up_q <= and_1468 ? 15'h0 : sum_1762;
      registration_counts_half_votes_0_down_q <= and_1468 ? 15'h0 : sum_1771;
      registration_counts_half_votes_0_up_q <= and_1468 ? 15'h0 : sum_1780;
      registration_counts_half_votes_1_down_q <= and_1468 ? 15'h0 : sum_1788;
      registration_counts_half_votes_1_up_q <= and_1468 ? 15'h0 : sum_1796;
      registration_counts_half_votes_2_down_q <= and_1468 ? 15'h0 : sum_1804;
      registration_counts_half_votes_2_up_q <= and_1468 ? 15'h0 : sum_1812;
      registration_counts_half_votes_3_down_q <= and_1468 ? 15'h0 : sum_1820;
      registration_counts_half_votes_3_up_q <= and_1468 ? 15'h0 : sum_1828;
      region_row_q <= and_357_s4_q ? select_1846 : region_row_q;
      region_columns_q <= equal_907_s4_q ? select_948 : (drew_s4_q ? select_1039 : 8'h1);
      region_across_rest_q <= drew_s4_q ? select_1851 : columns_begin_rest_q;
      region_across_back_q <= drew_s4_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_357_s4_q ? select_1855 : columns_begin_rest_q;
      columns_begin_back_q <= and_357_s4_q ? select_1858 : columns_begin_back_q;
      region_down_rest_q <= select_1864;
      region_down_back_q <= select_1868;
      region_down_next_q <= select_1870;
      region_fresh_q <= and_357_s4_q ? select_1874 : region_fresh_q;
      segment_starts_q <= equal_907_s4_q ? or_1879 : (drew_s4_q ? select_1882 : or_1879);
      hidden_for_q <= select_1906;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1907};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s4_q;
      centres_values_0_textured_q <= select_1976;
      centres_values_0_of_skin_q <= equal_907_s4_q ? centres_values_0_of_skin_q : select_1978;
      centres_values_1_textured_q <= equal_907_s4_q ? centres_values_1_textured_q : select_1980;
      centres_values_1_of_skin_q <= equal_907_s4_q ? centres_values_1_of_skin_q : select_1982;
      map_row_q <= and_357_s4_q ? select_1987 : map_row_q;
      map_width_q <= select_1990;
      write_half_q <= marks_first_s4_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1009;
      done_q <= not_1011 & ((~begins_product_q) & (done_q | said_q));
      proven_q <= marks_first_s4_q ? done_q : proven_q;
      said_q <= equal_907_s4_q & equal_1886;
      rows_passed_q <= select_994;
      columns_passed_q <= {select_996[7:0], or_992};
      line_ended_q <= marks_last_s4_q;
      began_q <= and_1013;
      seen_x_q <= select_1015;
      seen_y_q <= select_2002;
      seen_column_q <= select_1006;
      seen_rows_left_q <= select_2007;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_1003;
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
      averager_total_0_q <= select_1129;
      averager_total_1_q <= select_1131;
      census_columns_values_0_cell_0_left_q <= select_1155;
      census_columns_values_0_cell_0_right_q <= select_1156;
      census_columns_values_0_cell_0_mask_q <= select_1157;
      census_columns_values_0_cell_1_left_q <= select_1158;
      census_columns_values_0_cell_1_right_q <= select_1159;
      census_columns_values_0_cell_1_mask_q <= select_1160;
      census_columns_values_0_cell_2_left_q <= select_1161;
      census_columns_values_0_cell_2_right_q <= select_1162;
      census_columns_values_0_cell_2_mask_q <= select_1163;
      census_columns_values_0_cell_2_of_skin_q <= select_1164;
      census_columns_values_0_cell_3_left_q <= select_1165;
      census_columns_values_0_cell_3_right_q <= select_1166;
      census_columns_values_0_cell_3_mask_q <= select_1167;
      census_columns_values_0_cell_4_left_q <= select_1168;
      census_columns_values_0_cell_4_right_q <= select_1169;
      census_columns_values_0_cell_4_mask_q <= select_1170;
      census_columns_values_1_cell_0_left_q <= select_1171;
      census_columns_values_1_cell_0_right_q <= select_1172;
      census_columns_values_1_cell_0_mask_q <= select_1173;
      census_columns_values_1_cell_1_left_q <= select_1174;
      census_columns_values_1_cell_1_right_q <= select_1175;
      census_columns_values_1_cell_1_mask_q <= select_1176;
      census_columns_values_1_cell_2_left_q <= select_1177;
      census_columns_values_1_cell_2_right_q <= select_1178;
      census_columns_values_1_cell_2_mask_q <= select_1179;
      census_columns_values_1_cell_2_of_skin_q <= select_1180;
      census_columns_values_1_cell_3_left_q <= select_1181;
      census_columns_values_1_cell_3_right_q <= select_1182;
      census_columns_values_1_cell_3_mask_q <= select_1183;
      census_columns_values_1_cell_4_left_q <= select_1184;
      census_columns_values_1_cell_4_right_q <= select_1185;
      census_columns_values_1_cell_4_mask_q <= select_1186;
      census_columns_values_2_cell_0_left_q <= select_1187;
      census_columns_values_2_cell_0_right_q <= select_1188;
      census_columns_values_2_cell_0_mask_q <= select_1189;
      census_columns_values_2_cell_1_left_q <= select_1190;
      census_columns_values_2_cell_1_right_q <= select_1191;
      census_columns_values_2_cell_1_mask_q <= select_1192;
      census_columns_values_2_cell_2_left_q <= select_1193;
      census_columns_values_2_cell_2_right_q <= select_1194;
      census_columns_values_2_cell_2_mask_q <= select_1195;
      census_columns_values_2_cell_3_left_q <= select_1196;
      census_columns_values_2_cell_3_right_q <= select_1197;
      census_columns_values_2_cell_3_mask_q <= select_1198;
      census_columns_values_2_cell_4_left_q <= select_1199;
      census_columns_values_2_cell_4_right_q <= select_1200;
      census_columns_values_2_cell_4_mask_q <= select_1201;
      census_columns_values_3_cell_0_mask_q <= select_1202;
      census_columns_values_3_cell_1_left_q <= select_1203;
      census_columns_values_3_cell_1_right_q <= select_1204;
      census_columns_values_3_cell_1_mask_q <= select_1205;
      census_columns_values_3_cell_2_mask_q <= select_1206;
      census_columns_values_3_cell_3_left_q <= select_1207;
      census_columns_values_3_cell_3_right_q <= select_1208;
      census_columns_values_3_cell_3_mask_q <= select_1209;
      census_columns_values_3_cell_4_mask_q <= select_1210;
      sharpness_last_mean_0_q <= and_357_s4_q ? select_363 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_357_s4_q ? select_367 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= select_1928;
      box_textured_columns_values_1_q <= equal_907_s4_q ? box_textured_columns_values_1_q : select_1929;
      box_textured_columns_values_2_q <= equal_907_s4_q ? box_textured_columns_values_2_q : select_1931;
      box_textured_columns_values_3_q <= equal_907_s4_q ? box_textured_columns_values_3_q : select_1933;
      box_textured_columns_values_4_q <= equal_907_s4_q ? box_textured_columns_values_4_q : select_1935;
      box_textured_sum_sums_values_0_q <= select_1938;
      box_explained_columns_values_0_q <= equal_907_s4_q ? box_explained_columns_values_0_q : select_1939;
      box_explained_columns_values_1_q <= equal_907_s4_q ? box_explained_columns_values_1_q : select_1941;
      box_explained_columns_values_2_q <= equal_907_s4_q ? box_explained_columns_values_2_q : select_1943;
      box_explained_columns_values_3_q <= equal_907_s4_q ? box_explained_columns_values_3_q : select_1945;
      box_explained_columns_values_4_q <= equal_907_s4_q ? box_explained_columns_values_4_q : select_1947;
      box_explained_sum_sums_values_0_q <= select_1950;
      box_shown_columns_values_0_q <= select_1952;
      box_shown_columns_values_1_q <= equal_907_s4_q ? box_shown_columns_values_1_q : select_1953;
      box_shown_columns_values_2_q <= equal_907_s4_q ? box_shown_columns_values_2_q : select_1955;
      box_shown_columns_values_3_q <= equal_907_s4_q ? box_shown_columns_values_3_q : select_1957;
      box_shown_columns_values_4_q <= equal_907_s4_q ? box_shown_columns_values_4_q : select_1959;
      box_shown_sum_sums_values_0_q <= select_1962;
      box_nearer_columns_values_0_q <= select_1964;
      box_nearer_columns_values_1_q <= equal_907_s4_q ? box_nearer_columns_values_1_q : select_1965;
      box_nearer_columns_values_2_q <= equal_907_s4_q ? box_nearer_columns_values_2_q : select_1967;
      box_nearer_columns_values_3_q <= equal_907_s4_q ? box_nearer_columns_values_3_q : select_1969;
      box_nearer_columns_values_4_q <= equal_907_s4_q ? box_nearer_columns_values_4_q : select_1971;
      box_nearer_sum_sums_values_0_q <= select_1974;
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
  logic equal_907_s5_q;
  logic not_908_s5_q;
  logic [2:0] select_936_s5_q;
  logic or_951_s5_q;
  logic or_954_s5_q;
  logic or_957_s5_q;
  logic equal_959_s5_q;
  logic textured_s5_q;
  logic explained_s5_q;
  logic and_980_s5_q;
  logic and_985_s5_q;
  logic and_1017_s5_q;
  logic less_1018_s5_q;
  logic [5:0] index_2_s5_q;
  logic [7:0] sum_1023_s5_q;
  logic equal_1037_s5_q;
  logic or_1042_s5_q;
  logic or_1045_s5_q;
  logic or_1048_s5_q;
  logic not_1072_s5_q;
  logic less_1086_s5_q;
  logic and_1097_s5_q;
  logic [11:0] sum_1230_s5_q;
  logic equal_1237_s5_q;
  logic [8:0] contrast_s5_q;
  logic [8:0] contrast_2_s5_q;
  logic and_1468_s5_q;
  logic and_1471_s5_q;
  logic equal_1486_s5_q;
  logic not_1502_s5_q;
  logic less_1566_s5_q;
  logic equal_1569_s5_q;
  logic equal_1570_s5_q;
  logic equal_1571_s5_q;
  logic [7:0] residual_s5_q;
  logic equal_1886_s5_q;
  logic and_2013_s5_q;
  logic and_2040_s5_q;
  logic less_2059_s5_q;
  logic less_2060_s5_q;
  logic less_2062_s5_q;
  logic or_2065_s5_q;
  logic less_2067_s5_q;
  logic or_2072_s5_q;
  logic less_2073_s5_q;
  logic or_2079_s5_q;
  logic select_2116_s5_q;
  logic or_2118_s5_q;
  logic less_2120_s5_q;
  logic less_2123_s5_q;
  logic select_2127_s5_q;
  logic and_2159_s5_q;
  logic [11:0] select_2169_s5_q;
  logic [11:0] select_2171_s5_q;
  logic [11:0] select_2173_s5_q;
  logic [11:0] select_2175_s5_q;
  logic and_2184_s5_q;
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
      equal_907_s5_q <= equal_907_s4_q;
      not_908_s5_q <= not_908_s4_q;
      select_936_s5_q <= {select_936_s4_q[4], select_936_s4_q[2], select_936_s4_q[0]};
      or_951_s5_q <= or_951;
      or_954_s5_q <= or_954;
      or_957_s5_q <= or_957;
      equal_959_s5_q <= equal_959;
      textured_s5_q <= textured;
      explained_s5_q <= explained;
      and_980_s5_q <= and_980;
      and_985_s5_q <= not_908_s4_q & and_966;
      and_1017_s5_q <= and_1017;
      less_1018_s5_q <= less_1018;
      index_2_s5_q <= index_2[5:0];
      sum_1023_s5_q <= sum_1023;
      equal_1037_s5_q <= t[4:1] == 4'h0;
      or_1042_s5_q <= or_1042;
      or_1045_s5_q <= select_1039[7] | (~({select_1039[6], select_1039[3:2]} == 3'h0));
      or_1048_s5_q <= select_1039[7] | (~(select_1039[6:4] == 3'h0));
      not_1072_s5_q <= ~({sum_1070, around[0]} < {2'h0, t});
      less_1086_s5_q <= {1'b0, around[4:1]} < n;
      and_1097_s5_q <= and_1097_s4_q;
      sum_1230_s5_q <= ({1'b0, sum_1222} + {2'h0, sum_1225}) + {2'h0, sum_1229};
      equal_1237_s5_q <= equal_1237_s4_q;
      contrast_s5_q <= contrast;
      contrast_2_s5_q <= contrast_2;
      and_1468_s5_q <= and_1468;
      and_1471_s5_q <= and_1471;
      equal_1486_s5_q <= x_s4_q[7:1] == 7'h0;
      not_1502_s5_q <= ~({sum_1500, e[0]} < {2'h0, t});
      less_1566_s5_q <= less_1566_s4_q;
      equal_1569_s5_q <= equal_1569;
      equal_1570_s5_q <= equal_1570;
      equal_1571_s5_q <= equal_1571;
      residual_s5_q <= residual_s4_q;
      equal_1886_s5_q <= equal_1886;
      and_2013_s5_q <= and_2013;
      and_2040_s5_q <= equal_907_s4_q & (equal_1886 & (cfg_prove_i & (~proven_q)));
      less_2059_s5_q <= less_2059;
      less_2060_s5_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2062_s5_q <= less_2062;
      or_2065_s5_q <= or_2065;
      less_2067_s5_q <= less_2067;
      or_2072_s5_q <= or_2072;
      less_2073_s5_q <= less_2073;
      or_2079_s5_q <= or_2079;
      select_2116_s5_q <= select_2116;
      or_2118_s5_q <= less_2117 | select_2116;
      less_2120_s5_q <= less_2120;
      less_2123_s5_q <= less_2123;
      select_2127_s5_q <= less_2085 ? or_2115 : select_2112;
      and_2159_s5_q <= equal_907_s4_q & (equal_1886 & (cfg_prove_i & and_2156));
      select_2169_s5_q <= select_2169;
      select_2171_s5_q <= select_2171;
      select_2173_s5_q <= select_2173;
      select_2175_s5_q <= select_2175;
      and_2184_s5_q <= equal_907_s4_q & not_960;
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
  // hls/stages/agreement.hpp:509
  logic [6:0] select_970;
  assign select_970 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:510
  logic [6:0] sum_971;
  assign sum_971 = {6'h0, textured_s5_q} + select_970;
  // hls/stages/agreement.hpp:639
  logic [11:0] sum_973;
  assign sum_973 = {5'h0, sum_971} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:509
  logic [6:0] select_975;
  assign select_975 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:510
  logic [6:0] sum_976;
  assign sum_976 = {6'h0, explained_s5_q} + select_975;
  // hls/stages/agreement.hpp:640
  logic [11:0] sum_978;
  assign sum_978 = {5'h0, sum_976} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:509
  logic [6:0] select_981;
  assign select_981 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:511
  logic [6:0] sum_982;
  assign sum_982 = {6'h0, and_980_s5_q} + select_981;
  // hls/stages/agreement.hpp:641
  logic [11:0] sum_984;
  assign sum_984 = {5'h0, sum_982} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:679
  logic not_1049;
  assign not_1049 = ~region_row_s5_q[2];
  logic [2:0] select_1050;
  assign select_1050 = region_row_s5_q[1] ? {1'b0, not_1049, 1'b0} : {region_row_s5_q[2], 1'b0, not_1049};
  logic [5:0] select_1051;
  assign select_1051 = region_row_s5_q[0] ? {select_1050[2], 1'b0, select_1050[1], 1'b0, select_1050[0], 1'b0} : {1'b0, select_1050[2], 1'b0, select_1050[1], 1'b0, select_1050[0]};
  logic [11:0] select_1052;
  assign select_1052 = or_1048_s5_q ? {select_1051[5], 1'b0, select_1051[4], 1'b0, select_1051[3], 1'b0, select_1051[2], 1'b0, select_1051[1], 1'b0, select_1051[0], 1'b0} : {1'b0, select_1051[5], 1'b0, select_1051[4], 1'b0, select_1051[3], 1'b0, select_1051[2], 1'b0, select_1051[1], 1'b0, select_1051[0]};
  logic [23:0] select_1053;
  assign select_1053 = or_1045_s5_q ? {select_1052[11], 1'b0, select_1052[10], 1'b0, select_1052[9], 1'b0, select_1052[8], 1'b0, select_1052[7], 1'b0, select_1052[6], 1'b0, select_1052[5], 1'b0, select_1052[4], 1'b0, select_1052[3], 1'b0, select_1052[2], 1'b0, select_1052[1], 1'b0, select_1052[0], 1'b0} : {1'b0, select_1052[11], 1'b0, select_1052[10], 1'b0, select_1052[9], 1'b0, select_1052[8], 1'b0, select_1052[7], 1'b0, select_1052[6], 1'b0, select_1052[5], 1'b0, select_1052[4], 1'b0, select_1052[3], 1'b0, select_1052[2], 1'b0, select_1052[1], 1'b0, select_1052[0]};
  logic [47:0] select_1054;
  assign select_1054 = or_1042_s5_q ? {select_1053[23], 1'b0, select_1053[22], 1'b0, select_1053[21], 1'b0, select_1053[20], 1'b0, select_1053[19], 1'b0, select_1053[18], 1'b0, select_1053[17], 1'b0, select_1053[16], 1'b0, select_1053[15], 1'b0, select_1053[14], 1'b0, select_1053[13], 1'b0, select_1053[12], 1'b0, select_1053[11], 1'b0, select_1053[10], 1'b0, select_1053[9], 1'b0, select_1053[8], 1'b0, select_1053[7], 1'b0, select_1053[6], 1'b0, select_1053[5], 1'b0, select_1053[4], 1'b0, select_1053[3], 1'b0, select_1053[2], 1'b0, select_1053[1], 1'b0, select_1053[0], 1'b0} : {1'b0, select_1053[23], 1'b0, select_1053[22], 1'b0, select_1053[21], 1'b0, select_1053[20], 1'b0, select_1053[19], 1'b0, select_1053[18], 1'b0, select_1053[17], 1'b0, select_1053[16], 1'b0, select_1053[15], 1'b0, select_1053[14], 1'b0, select_1053[13], 1'b0, select_1053[12], 1'b0, select_1053[11], 1'b0, select_1053[10], 1'b0, select_1053[9], 1'b0, select_1053[8], 1'b0, select_1053[7], 1'b0, select_1053[6], 1'b0, select_1053[5], 1'b0, select_1053[4], 1'b0, select_1053[3], 1'b0, select_1053[2], 1'b0, select_1053[1], 1'b0, select_1053[0]};
  logic not_1057;
  assign not_1057 = ~((good_q & select_1054) == 48'h0);
  // hls/stages/agreement.hpp:681
  logic is_seen;
  assign is_seen = equal_1037_s5_q ? not_1057 : not_1072_s5_q;
  // hls/stages/agreement.hpp:693
  logic and_1087;
  assign and_1087 = is_seen & less_1086_s5_q;
  // hls/stages/agreement.hpp:204
  logic [8:0] select_1121;
  assign select_1121 = sample_pair_whole_s5_q ? (and_355_s5_q ? grey_s5_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1123;
  assign select_1123 = sample_pair_whole_s5_q ? (and_355_s5_q ? grey_2_s5_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1125;
  assign select_1125 = sample_pair_whole_s5_q ? (and_355_s5_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1127;
  assign select_1127 = sample_pair_whole_s5_q ? (and_355_s5_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1132;
  assign sum_1132 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s5_q};
  logic [9:0] difference_1133;
  assign difference_1133 = {1'b0, sum_1132[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1134;
  assign xor_1134 = {difference_1133[8:0], sum_1132[0]} ^ {10{difference_1133[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1133[9]} + {1'b0, xor_1134};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_360_s5_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1139;
  assign select_1139 = sample_pair_whole_s5_q ? (and_355_s5_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1140;
  assign sum_1140 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s5_q};
  logic [9:0] difference_1141;
  assign difference_1141 = {1'b0, sum_1140[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1142;
  assign xor_1142 = {difference_1141[8:0], sum_1140[0]} ^ {10{difference_1141[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1141[9]} + {1'b0, xor_1142};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_360_s5_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1147;
  assign select_1147 = sample_pair_whole_s5_q ? (and_355_s5_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1232;
  assign select_1232 = and_357_s5_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1233;
  assign select_1233 = and_357_s5_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1234;
  assign select_1234 = and_357_s5_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1235;
  assign select_1235 = and_357_s5_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_1238;
  assign sum_1238 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1230_s5_q};
  logic [13:0] sum_1240;
  assign sum_1240 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1238});
  // hls/stages/census.hpp:225
  logic and_1242;
  assign and_1242 = and_445_s5_q & (9'h4 < sum_1240[13:5]);
  // hls/stages/census.hpp:226
  logic and_1243;
  assign and_1243 = and_445_s5_q & less_469;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1244;
  assign sum_1244 = census_left_misses_q + {{17{and_1243}}, and_1242, 1'b0, and_1242};
  // hls/stages/agreement.hpp:205
  logic [19:0] select_1246;
  assign select_1246 = and_357_s5_q ? (equal_1237_s5_q ? 20'h0 : sum_1244) : census_left_misses_q;
  // hls/stages/agreement.hpp:204
  logic [27:0] select_1251;
  assign select_1251 = sample_pair_whole_s5_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:275
  logic and_1256;
  assign and_1256 = whole_2_s5_q & (~(column_s5_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:283
  logic and_1262;
  assign and_1262 = and_1256 & (sharpness_last_mask_q & (7'h2 < contrast_s5_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1251[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1264;
  assign select_1264 = and_1262 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1266;
  assign select_1266 = equal_1237_s5_q ? {11'h0, select_1264} : (sharpness_sums_detail_0_q + {11'h0, select_1264});
  // hls/stages/agreement.hpp:283
  logic and_1273;
  assign and_1273 = and_1256 & (sharpness_last_mask_q & (7'h2 < contrast_2_s5_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1251[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1275;
  assign select_1275 = and_1273 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1277;
  assign select_1277 = equal_1237_s5_q ? {11'h0, select_1275} : (sharpness_sums_detail_1_q + {11'h0, select_1275});
  logic [8:0] select_1280;
  assign select_1280 = and_1262 ? contrast_s5_q : 9'h0;
  logic [23:0] sum_1281;
  assign sum_1281 = (equal_1237_s5_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1280};
  logic [8:0] select_1284;
  assign select_1284 = and_1273 ? contrast_2_s5_q : 9'h0;
  logic [23:0] sum_1285;
  assign sum_1285 = (equal_1237_s5_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1284};
  // hls/stages/agreement.hpp:533
  logic [13:0] select_1473;
  assign select_1473 = and_1468_s5_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1471_s5_q});
  // hls/stages/agreement.hpp:339
  logic and_1475;
  assign and_1475 = not_908_s5_q & (begins_product_q & textured_s5_q);
  logic and_1479;
  assign and_1479 = not_908_s5_q & (begins_product_q & explained_s5_q);
  logic and_1483;
  assign and_1483 = not_908_s5_q & (begins_product_q & and_980_s5_q);
  // hls/stages/agreement.hpp:680
  logic select_1503;
  assign select_1503 = equal_1037_s5_q ? not_1057 : not_1502_s5_q;
  // hls/stages/agreement.hpp:685
  logic not_1504;
  assign not_1504 = ~select_1503;
  // hls/stages/agreement.hpp:339
  logic and_1507;
  assign and_1507 = begins_product_q & ((~equal_1486_s5_q) & (centres_values_1_textured_s5_q & not_1504));
  logic and_1508;
  assign and_1508 = not_908_s5_q & and_1507;
  // hls/stages/agreement.hpp:711
  logic less_1511;
  assign less_1511 = region_row_s5_q < x_s5_q[5:3];
  logic [11:0] select_1512;
  assign select_1512 = less_1511 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1515;
  assign select_1515 = less_1511 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:712
  logic [12:0] sum_1516;
  assign sum_1516 = {1'b0, select_1515} + {3'h0, select_1515[11:2]};
  logic and_1518;
  assign and_1518 = (~(select_1512[11:4] == 8'h0)) & ({sum_1516, select_1515[1:0]} < {3'h0, select_1512});
  // hls/stages/agreement.hpp:722
  logic [11:0] select_1520;
  assign select_1520 = equal_959_s5_q ? 12'h0 : (and_1518 ? select_1512 : 12'h0);
  // hls/stages/agreement.hpp:339
  logic [11:0] select_1521;
  assign select_1521 = equal_907_s5_q ? select_1520 : 12'h0;
  // hls/stages/agreement.hpp:533
  logic [13:0] select_1523;
  assign select_1523 = and_1468_s5_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1521});
  // hls/stages/agreement.hpp:616
  logic [1:0] difference_1524;
  assign difference_1524 = 2'h0 - {1'b0, select_936_s5_q[2]};
  // hls/stages/agreement.hpp:620
  logic [9:0] select_1525;
  assign select_1525 = select_936_s5_q[1] ? {difference_1524, cfg_explained_limit_i} : 10'h0;
  // hls/stages/agreement.hpp:339
  logic [9:0] select_1527;
  assign select_1527 = begins_product_q ? (select_936_s5_q[0] ? select_1525 : 10'h0) : 10'h0;
  logic [9:0] select_1528;
  assign select_1528 = equal_907_s5_q ? 10'h0 : select_1527;
  // hls/stages/agreement.hpp:528
  logic [23:0] sum_1529;
  assign sum_1529 = counts_too_little_explained_q + {{14{select_1528[9]}}, select_1528};
  // hls/stages/agreement.hpp:186
  logic [8:0] select_1533;
  assign select_1533 = select_936_s5_q[0] ? (select_936_s5_q[1] ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0) : 9'h0;
  // hls/stages/agreement.hpp:339
  logic [8:0] select_1534;
  assign select_1534 = begins_product_q ? select_1533 : 9'h0;
  logic [20:0] select_1535;
  assign select_1535 = equal_907_s5_q ? {1'b0, select_1520, 8'h0} : {{12{select_1534[8]}}, select_1534};
  // hls/stages/agreement.hpp:533
  logic [23:0] select_1537;
  assign select_1537 = and_1468_s5_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1535[20]}}, select_1535});
  // hls/stages/agreement.hpp:620
  logic [8:0] select_1539;
  assign select_1539 = select_936_s5_q[1] ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1540;
  assign select_1540 = select_936_s5_q[0] ? select_1539[7:0] : 8'h0;
  // hls/stages/agreement.hpp:186
  logic and_1541;
  assign and_1541 = select_936_s5_q[0] & select_1539[8];
  // hls/stages/agreement.hpp:691
  logic [2:0] select_1544;
  assign select_1544 = centres_values_1_textured_s5_q ? (select_1503 ? {3{and_1541}} : ({3{and_1541}} + 3'h1)) : {3{and_1541}};
  logic [2:0] select_1545;
  assign select_1545 = equal_1486_s5_q ? {3{and_1541}} : select_1544;
  // hls/stages/agreement.hpp:339
  logic [10:0] select_1547;
  assign select_1547 = equal_907_s5_q ? 11'h0 : (begins_product_q ? {select_1545, select_1540} : 11'h0);
  // hls/stages/agreement.hpp:530
  logic [23:0] sum_1548;
  assign sum_1548 = counts_too_much_unproven_q + {{13{select_1547[10]}}, select_1547};
  // hls/stages/agreement.hpp:691
  logic [9:0] select_1551;
  assign select_1551 = centres_values_1_of_skin_s5_q ? ({1'b0, not_1504, 8'h0} - {2'h0, cfg_unproven_skin_limit_i}) : 10'h0;
  logic [9:0] select_1553;
  assign select_1553 = equal_1486_s5_q ? 10'h0 : (centres_values_1_textured_s5_q ? select_1551 : 10'h0);
  // hls/stages/agreement.hpp:339
  logic [9:0] select_1555;
  assign select_1555 = equal_907_s5_q ? 10'h0 : (begins_product_q ? select_1553 : 10'h0);
  // hls/stages/agreement.hpp:531
  logic [23:0] sum_1556;
  assign sum_1556 = counts_too_much_unseen_skin_q + {{14{select_1555[9]}}, select_1555};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1609;
  assign select_1609 = equal_1570_s5_q ? 8'h0 : (equal_1571_s5_q ? 8'h0 : residual_s5_q);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1612;
  assign select_1612 = select_936_s5_q[2] ? (less_1566_s5_q ? (equal_1569_s5_q ? 8'h0 : select_1609) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1614;
  assign select_1614 = begins_product_q ? (select_936_s5_q[0] ? select_1612 : 8'h0) : 8'h0;
  logic [7:0] select_1615;
  assign select_1615 = equal_907_s5_q ? 8'h0 : select_1614;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1616;
  assign sum_1616 = registration_counts_across_0_q + {{12{select_1615[7]}}, select_1615};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1619;
  assign select_1619 = equal_1570_s5_q ? 8'h0 : (equal_1571_s5_q ? residual_s5_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1622;
  assign select_1622 = select_936_s5_q[2] ? (less_1566_s5_q ? (equal_1569_s5_q ? 8'h0 : select_1619) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1624;
  assign select_1624 = begins_product_q ? (select_936_s5_q[0] ? select_1622 : 8'h0) : 8'h0;
  logic [7:0] select_1625;
  assign select_1625 = equal_907_s5_q ? 8'h0 : select_1624;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1626;
  assign sum_1626 = registration_counts_across_1_q + {{12{select_1625[7]}}, select_1625};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1629;
  assign select_1629 = equal_1569_s5_q ? 8'h0 : (equal_1570_s5_q ? residual_s5_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1631;
  assign select_1631 = select_936_s5_q[2] ? (less_1566_s5_q ? select_1629 : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1633;
  assign select_1633 = begins_product_q ? (select_936_s5_q[0] ? select_1631 : 8'h0) : 8'h0;
  logic [7:0] select_1634;
  assign select_1634 = equal_907_s5_q ? 8'h0 : select_1633;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1635;
  assign sum_1635 = registration_counts_across_2_q + {{12{select_1634[7]}}, select_1634};
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1639;
  assign select_1639 = select_936_s5_q[2] ? (less_1566_s5_q ? (equal_1569_s5_q ? residual_s5_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1641;
  assign select_1641 = begins_product_q ? (select_936_s5_q[0] ? select_1639 : 8'h0) : 8'h0;
  logic [7:0] select_1642;
  assign select_1642 = equal_907_s5_q ? 8'h0 : select_1641;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1643;
  assign sum_1643 = registration_counts_across_3_q + {{12{select_1642[7]}}, select_1642};
  // hls/stages/agreement.hpp:707
  logic and_1891;
  assign and_1891 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:708
  logic less_1892;
  assign less_1892 = $signed(24'h0) < $signed(counts_too_little_explained_q);
  // hls/stages/agreement.hpp:714
  logic [12:0] sum_1895;
  assign sum_1895 = {1'b0, select_1515} + {2'h0, select_1515[11:1]};
  logic select_1898;
  assign select_1898 = (select_1512[11:3] == 9'h0) ? (and_1891 & (~less_1892)) : (~({sum_1895, select_1515[0]} < {2'h0, select_1512}));
  // hls/stages/agreement.hpp:722
  logic [47:0] select_1899;
  assign select_1899 = equal_959_s5_q ? good_next_q : {select_1898, good_next_q[47:1]};
  // hls/stages/agreement.hpp:339
  logic [47:0] select_1901;
  assign select_1901 = equal_907_s5_q ? (equal_1886_s5_q ? select_1899 : good_q) : good_q;
  // hls/stages/agreement.hpp:739
  logic [35:0] select_1918;
  assign select_1918 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:733
  logic [35:0] detail_left;
  assign detail_left = begins_product_s5_q ? 36'h0 : select_1918;
  // hls/stages/agreement.hpp:739
  logic [35:0] select_1921;
  assign select_1921 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:743
  logic [35:0] detail_right;
  assign detail_right = begins_product_s5_q ? 36'h0 : select_1921;
  // hls/stages/agreement.hpp:733
  logic [34:0] select_1923;
  assign select_1923 = begins_product_s5_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:743
  logic [34:0] select_1924;
  assign select_1924 = begins_product_s5_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:733
  logic [17:0] select_1925;
  assign select_1925 = begins_product_s5_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:743
  logic [17:0] select_1926;
  assign select_1926 = begins_product_s5_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:831
  logic [1:0] select_2014;
  assign select_2014 = and_2013_s5_q ? {and_1087, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:832
  logic and_2015;
  assign and_2015 = proven_q & less_2003;
  // hls/stages/agreement.hpp:208
  logic select_2018;
  assign select_2018 = and_1017_s5_q ? (less_1018_s5_q ? (select_2014[0] & and_2015) : seen_q) : seen_q;
  logic select_2021;
  assign select_2021 = and_1017_s5_q ? (less_1018_s5_q ? (select_2014[1] & and_2015) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:339
  logic [13:0] select_2026;
  assign select_2026 = equal_907_s5_q ? (equal_1886_s5_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_2028;
  assign select_2028 = equal_907_s5_q ? (equal_1886_s5_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_2030;
  assign select_2030 = equal_907_s5_q ? (equal_1886_s5_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_2032;
  assign select_2032 = equal_907_s5_q ? (equal_1886_s5_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_2034;
  assign select_2034 = equal_907_s5_q ? (equal_1886_s5_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_2036;
  assign select_2036 = equal_907_s5_q ? (equal_1886_s5_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  // hls/stages/agreement.hpp:759
  logic not_2041;
  assign not_2041 = ~and_1891;
  // hls/stages/agreement.hpp:760
  logic or_2045;
  assign or_2045 = not_2022 | not_2041;
  // hls/stages/agreement.hpp:726
  logic or_2051;
  assign or_2051 = ($signed(24'h0) < $signed(counts_too_much_unproven_q)) | ($signed(24'h0) < $signed(counts_too_much_unseen_skin_q));
  logic select_2053;
  assign select_2053 = (less_1892 | or_2045) ? (~or_2045) : (($signed(24'h0) < $signed(counts_too_many_bad_q)) | or_2051);
  logic select_2119;
  assign select_2119 = or_2079_s5_q ? select_2116_s5_q : or_2118_s5_q;
  logic or_2121;
  assign or_2121 = less_2120_s5_q | select_2119;
  logic select_2122;
  assign select_2122 = or_2072_s5_q ? select_2119 : or_2121;
  logic or_2124;
  assign or_2124 = less_2123_s5_q | select_2122;
  logic select_2129;
  assign select_2129 = less_2067_s5_q ? or_2121 : (less_2073_s5_q ? or_2118_s5_q : select_2127_s5_q);
  logic select_2131;
  assign select_2131 = less_2059_s5_q ? (less_2060_s5_q | (or_2065_s5_q ? select_2122 : or_2124)) : (less_2062_s5_q ? or_2124 : select_2129);
  // hls/stages/agreement.hpp:767
  logic and_2135;
  assign and_2135 = cfg_prove_i & and_1891;
  // hls/stages/agreement.hpp:768
  logic [36:0] sum_2136;
  assign sum_2136 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2138;
  assign less_2138 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:726
  logic or_2141;
  assign or_2141 = ({detail_left, 3'h0} < {sum_2136, detail_right[1:0]}) | (less_2138 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:771
  logic [36:0] sum_2145;
  assign sum_2145 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2147;
  assign less_2147 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:726
  logic or_2148;
  assign or_2148 = ({detail_right, 3'h0} < {sum_2145, detail_left[1:0]}) | less_2147;
  // hls/stages/agreement.hpp:339
  logic [19:0] select_2161;
  assign select_2161 = equal_907_s5_q ? (equal_1886_s5_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2163;
  assign select_2163 = equal_907_s5_q ? (equal_1886_s5_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2165;
  assign select_2165 = equal_907_s5_q ? (equal_1886_s5_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2167;
  assign select_2167 = equal_907_s5_q ? (equal_1886_s5_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [23:0] select_2177;
  assign select_2177 = equal_907_s5_q ? (equal_1886_s5_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2179;
  assign select_2179 = equal_907_s5_q ? (equal_1886_s5_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2181;
  assign select_2181 = equal_907_s5_q ? (equal_1886_s5_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2183;
  assign select_2183 = equal_907_s5_q ? (equal_1886_s5_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  // hls/stages/agreement.hpp:722
  logic [11:0] select_2192;
  assign select_2192 = equal_959_s5_q ? 12'h0 : (less_1511 ? 12'h0 : regions_rdata_q[35:24]);

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
  assign regions_waddr = {region_row_s5_q, or_957_s5_q, or_954_s5_q, or_951_s5_q};
  logic regions_we;
  assign regions_we = s5_en & and_985_s5_q;
  logic [35:0] regions_wdata;
  assign regions_wdata = {sum_984, sum_978, sum_973};
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
  assign map_waddr = {sum_1023_s5_q, index_2_s5_q};
  logic map_we;
  assign map_we = s5_en & and_1097_s5_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_1087, is_seen};
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
      census_left_misses_q <= select_1246;
      sharpness_sums_detail_0_q <= and_357_s5_q ? select_1266 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_357_s5_q ? select_1277 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_357_s5_q ? sum_1281 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_357_s5_q ? sum_1285 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1473;
      counts_textured_q <= and_1468_s5_q ? 14'h0 : (counts_textured_q + {13'h0, and_1475});
      counts_explained_q <= and_1468_s5_q ? 14'h0 : (counts_explained_q + {13'h0, and_1479});
      counts_nearer_q <= and_1468_s5_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1483});
      counts_unproven_q <= and_1468_s5_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1508});
      counts_regions_bad_q <= select_1523;
      counts_too_little_explained_q <= and_1468_s5_q ? 24'h0 : sum_1529;
      counts_too_many_bad_q <= select_1537;
      counts_too_much_unproven_q <= and_1468_s5_q ? 24'h0 : sum_1548;
      counts_too_much_unseen_skin_q <= and_1468_s5_q ? 24'h0 : sum_1556;
      registration_counts_across_0_q <= and_1468_s5_q ? 20'h0 : sum_1616;
      registration_counts_across_1_q <= and_1468_s5_q ? 20'h0 : sum_1626;
      registration_counts_across_2_q <= and_1468_s5_q ? 20'h0 : sum_1635;
      registration_counts_across_3_q <= and_1468_s5_q ? 20'h0 : sum_1643;
      segment_textured_q <= select_970 + {6'h0, and_1475};
      segment_explained_q <= select_975 + {6'h0, and_1479};
      segment_nearer_q <= select_981 + {6'h0, and_1483};
      segment_started_q <= ~segment_starts_q;
      good_q <= select_1901;
      good_next_q <= equal_907_s5_q ? select_1899 : good_next_q;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1923;
      addend_1_q <= select_1924;
      multiplier_0_q <= select_1925;
      multiplier_1_q <= select_1926;
      seen_q <= select_2018;
      nearer_q <= select_2021;
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
      averager_quarter_1_0_q <= select_1121;
      averager_quarter_1_1_q <= select_1123;
      averager_quarter_2_0_q <= select_1125;
      averager_quarter_2_1_q <= select_1127;
      averager_detail_0_q <= select_1139;
      averager_detail_1_q <= select_1147;
      census_changes_values_0_left_q <= and_357_s5_q ? texture_s5_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_357_s5_q ? sum_1230_s5_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1232;
      census_changes_values_1_right_q <= select_1233;
      census_changes_values_2_left_q <= select_1234;
      census_changes_values_2_right_q <= select_1235;
      sharpness_last_mask_q <= and_357_s5_q ? whole_2_s5_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_357_s5_q ? select_1251[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_357_s5_q ? select_1251[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s6_q;
  logic [7:0] pixel_1_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic and_1998_s6_q;
  logic or_2023_s6_q;
  logic and_2024_s6_q;
  logic [13:0] select_2026_s6_q;
  logic [13:0] select_2028_s6_q;
  logic [13:0] select_2030_s6_q;
  logic [13:0] select_2032_s6_q;
  logic [13:0] select_2034_s6_q;
  logic [13:0] select_2036_s6_q;
  logic and_2040_s6_q;
  logic and_2044_s6_q;
  logic and_2055_s6_q;
  logic and_2134_s6_q;
  logic and_2144_s6_q;
  logic and_2151_s6_q;
  logic and_2159_s6_q;
  logic [19:0] select_2161_s6_q;
  logic [19:0] select_2163_s6_q;
  logic [19:0] select_2165_s6_q;
  logic [19:0] select_2167_s6_q;
  logic [11:0] select_2169_s6_q;
  logic [11:0] select_2171_s6_q;
  logic [11:0] select_2173_s6_q;
  logic [11:0] select_2175_s6_q;
  logic [23:0] select_2177_s6_q;
  logic [23:0] select_2179_s6_q;
  logic [23:0] select_2181_s6_q;
  logic [23:0] select_2183_s6_q;
  logic and_2184_s6_q;
  logic [5:0] select_2186_s6_q;
  logic [11:0] select_2188_s6_q;
  logic [11:0] select_2190_s6_q;
  logic [11:0] select_2193_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      pixel_1_s6_q <= pixel_1_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= line_ended_q;
      and_1998_s6_q <= said_q;
      or_2023_s6_q <= not_2022 | select_2018;
      and_2024_s6_q <= cfg_prove_i & select_2021;
      select_2026_s6_q <= select_2026;
      select_2028_s6_q <= select_2028;
      select_2030_s6_q <= select_2030;
      select_2032_s6_q <= select_2032;
      select_2034_s6_q <= select_2034;
      select_2036_s6_q <= select_2036;
      and_2040_s6_q <= and_2040_s5_q;
      and_2044_s6_q <= equal_907_s5_q & (equal_1886_s5_q & (cfg_prove_i & not_2041));
      and_2055_s6_q <= equal_907_s5_q & (equal_1886_s5_q & select_2053);
      and_2134_s6_q <= equal_907_s5_q & (equal_1886_s5_q & (cfg_prove_i & select_2131));
      and_2144_s6_q <= equal_907_s5_q & (equal_1886_s5_q & (and_2135 & or_2141));
      and_2151_s6_q <= equal_907_s5_q & (equal_1886_s5_q & (and_2135 & or_2148));
      and_2159_s6_q <= and_2159_s5_q;
      select_2161_s6_q <= select_2161;
      select_2163_s6_q <= select_2163;
      select_2165_s6_q <= select_2165;
      select_2167_s6_q <= select_2167;
      select_2169_s6_q <= select_2169_s5_q;
      select_2171_s6_q <= select_2171_s5_q;
      select_2173_s6_q <= select_2173_s5_q;
      select_2175_s6_q <= select_2175_s5_q;
      select_2177_s6_q <= select_2177;
      select_2179_s6_q <= select_2179;
      select_2181_s6_q <= select_2181;
      select_2183_s6_q <= select_2183;
      and_2184_s6_q <= and_2184_s5_q;
      select_2186_s6_q <= equal_907_s5_q ? (equal_959_s5_q ? 6'h0 : x_s5_q) : 6'h0;
      select_2188_s6_q <= equal_907_s5_q ? (equal_959_s5_q ? 12'h0 : select_1512) : 12'h0;
      select_2190_s6_q <= equal_907_s5_q ? (equal_959_s5_q ? 12'h0 : select_1515) : 12'h0;
      select_2193_s6_q <= equal_907_s5_q ? select_2192 : 12'h0;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (averager_memory_error | census_memory_error | fresh_error | left_error | right_codes_error | best_left_error | best_right_error | shown_right_error | regions_error | seen_columns_error | map_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s6_q;
  assign pixel_1_o = pixel_1_s6_q;
  assign saturated_o = saturated_s6_q;
  assign mask_o = mask_s6_q;
  assign marks_first_o = marks_first_s6_q;
  assign marks_last_o = marks_last_s6_q;
  assign marks_seen_o = or_2023_s6_q;
  assign marks_nearer_o = and_2024_s6_q;
  assign verdict_valid_o = and_1998_s6_q;
  assign verdict_supervised_o = {2'h0, select_2026_s6_q};
  assign verdict_textured_o = {2'h0, select_2028_s6_q};
  assign verdict_explained_o = {2'h0, select_2030_s6_q};
  assign verdict_nearer_o = {2'h0, select_2032_s6_q};
  assign verdict_unproven_o = {2'h0, select_2034_s6_q};
  assign verdict_regions_bad_o = {2'h0, select_2036_s6_q};
  assign verdict_unproven_yet_o = and_2040_s6_q;
  assign verdict_untextured_o = and_2044_s6_q;
  assign verdict_disagree_o = and_2055_s6_q;
  assign verdict_moved_o = and_2134_s6_q;
  assign verdict_unsharp_left_o = and_2144_s6_q;
  assign verdict_unsharp_right_o = and_2151_s6_q;
  assign verdict_hidden_o = and_2159_s6_q;
  assign verdict_across_0_o = select_2161_s6_q;
  assign verdict_across_1_o = select_2163_s6_q;
  assign verdict_across_2_o = select_2165_s6_q;
  assign verdict_across_3_o = select_2167_s6_q;
  assign verdict_measured_0_o = select_2169_s6_q;
  assign verdict_measured_1_o = select_2171_s6_q;
  assign verdict_measured_2_o = select_2173_s6_q;
  assign verdict_measured_3_o = select_2175_s6_q;
  assign verdict_detail_0_o = select_2177_s6_q;
  assign verdict_detail_1_o = select_2179_s6_q;
  assign verdict_contrast_0_o = select_2181_s6_q;
  assign verdict_contrast_1_o = select_2183_s6_q;
  assign region_valid_o = and_2184_s6_q;
  assign region_region_o = select_2186_s6_q;
  assign region_textured_o = select_2188_s6_q;
  assign region_explained_o = select_2190_s6_q;
  assign region_nearer_o = select_2193_s6_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_2058[2:0], sum_1598[0], sum_1594[0], sum_1586[1:0], sum_1585[1:0], sum_1581[0], detail_4[1:0], detail_3[1:0], sum_1240[4:0], sum_883[8:0], sum_468[4:0], cfg_width_i[2:0]};

endmodule
