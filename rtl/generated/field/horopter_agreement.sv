// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 6 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2553 bits, pipeline 1234 bits, memories 29402 bits.
module horopter_agreement (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic present_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [8:0] cfg_width_i,
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
  output logic valid_o,
  output logic [7:0] pixel_0_o,
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
  assign last = {2'h0, cfg_width_i[8:3]} + 8'hff;
  logic [5:0] sum_1377;
  assign sum_1377 = {1'b0, cfg_width_i[8:4]} + 6'h7;
  logic [5:0] sum_1392;
  assign sum_1392 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_1870;
  assign difference_1870 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2044;
  assign less_2044 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2045;
  assign sum_2045 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_2046;
  assign select_2046 = less_2044 ? {sum_2045, cfg_height_i[5:3]} : 8'h0;
  logic not_2081;
  assign not_2081 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic left_first_q;
  logic right_q;
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [2:0] raster_at_x_q;
  logic [2:0] raster_at_y_q;
  logic [5:0] raster_at_column_q;
  logic [5:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [8:0] raster_rows_left_q;
  logic raster_row_ended_q;
  logic raster_final_row_q;
  logic [7:0] averager_place_q;
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
  logic [5:0] last_q;
  logic [5:0] least_q;
  logic [7:0] first_beats_q;
  logic [6:0] whole_beats_q;
  logic [6:0] age_q;
  logic ends_q;
  logic final_row_q;
  logic [7:0] next_lowest_q;
  logic [7:0] next_highest_q;
  logic [7:0] next_beats_q;
  logic [5:0] next_shift_q;
  logic next_last_shift_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_320;
  assign select_320 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_322;
  assign select_322 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [7:0] select_325;
  assign select_325 = ({select_322, select_320} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:95
  logic [7:0] select_326;
  assign select_326 = select_320[0] ? averager_place_q : select_325;
  // hls/stages/census.hpp:40
  logic or_327;
  assign or_327 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:202
  logic and_333;
  assign and_333 = (~((~or_327) | (~select_320[0]))) & (select_326 < 8'hbd);
  // hls/stages/census.hpp:40
  logic [2:0] select_338;
  assign select_338 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:202
  logic whole;
  assign whole = select_320[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:204
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_322 : 6'h0;
  // hls/stages/census.hpp:45
  logic equal_355;
  assign equal_355 = select_320 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_356;
  assign equal_356 = select_338 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_357;
  assign and_357 = equal_356 & and_333;
  // hls/stages/agreement.hpp:204
  logic and_359;
  assign and_359 = sample_pair_whole_q & (equal_355 & and_357);
  // hls/stages/agreement.hpp:743
  logic drew;
  assign drew = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:377
  logic equal_379;
  assign equal_379 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:557
  logic or_380;
  assign or_380 = drew | equal_379;
  // hls/stages/agreement.hpp:435
  logic not_381;
  assign not_381 = ~or_380;
  // hls/stages/agreement.hpp:377
  logic equal_382;
  assign equal_382 = run_phase_q == 3'h3;
  logic equal_384;
  assign equal_384 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:567
  logic less_385;
  assign less_385 = run_highest_q < x_q;
  logic not_386;
  assign not_386 = ~less_385;
  // hls/stages/agreement.hpp:181
  logic and_387;
  assign and_387 = equal_384 & not_386;
  logic and_389;
  assign and_389 = not_381 & ((~equal_382) & and_387);
  // hls/stages/census.hpp:40
  logic [5:0] select_416;
  assign select_416 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:204
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_416 : 6'h0;
  // hls/stages/agreement.hpp:181
  logic select_473;
  assign select_473 = equal_382 ? not_386 : and_387;
  // hls/stages/agreement.hpp:454
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:181
  logic and_527;
  assign and_527 = equal_382 & (age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q})));
  logic select_528;
  assign select_528 = or_380 ? not_386 : and_527;
  // hls/stages/agreement.hpp:143
  logic not_945;
  assign not_945 = ~drew;
  // hls/stages/agreement.hpp:130
  logic and_1012;
  assign and_1012 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:691
  logic [6:0] sum_1097;
  assign sum_1097 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:204
  logic [2:0] select_1112;
  assign select_1112 = sample_pair_whole_q ? (sample_last_q ? (select_338 + 3'h1) : select_338) : raster_at_y_q;
  logic [5:0] select_1114;
  assign select_1114 = sample_pair_whole_q ? (select_322 + {5'h0, equal_355}) : raster_at_column_q;
  logic [5:0] select_1117;
  assign select_1117 = sample_pair_whole_q ? (sample_last_q ? (select_416 + {5'h0, equal_356}) : select_416) : raster_at_row_q;
  logic select_1121;
  assign select_1121 = sample_pair_whole_q ? (sample_last_q ? (or_327 & (~raster_final_row_q)) : or_327) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_1123;
  assign select_1123 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:204
  logic select_1127;
  assign select_1127 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:285
  logic equal_1299;
  assign equal_1299 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:200
  logic [2:0] select_1300;
  assign select_1300 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1303;
  assign select_1303 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1306;
  assign select_1306 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1309;
  assign select_1309 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1312;
  assign select_1312 = ends_q ? following_shift_q : run_shift_q;
  logic select_1315;
  assign select_1315 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:286
  logic not_1316;
  assign not_1316 = ~equal_1299;
  // hls/stages/agreement.hpp:367
  logic not_1319;
  assign not_1319 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:377
  logic equal_1320;
  assign equal_1320 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:160
  logic or_1321;
  assign or_1321 = equal_1320 | equal_384;
  logic [2:0] select_1322;
  assign select_1322 = equal_382 ? {run_last_shift_q, {2{not_1319}}} : {1'b0, or_1321, equal_384};
  logic [2:0] select_1324;
  assign select_1324 = drew ? {{2{final_row_q}}, 1'b0} : (equal_379 ? 3'h5 : select_1322);
  logic [7:0] select_1326;
  assign select_1326 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [5:0] select_1327;
  assign select_1327 = equal_384 ? least_q : 6'h0;
  logic [7:0] select_1329;
  assign select_1329 = equal_379 ? 8'h0 : (equal_382 ? select_1326 : {2'h0, select_1327});
  logic [7:0] select_1332;
  assign select_1332 = run_last_shift_q ? {2'h0, last_q} : (run_shift_q[5] ? {2'h0, last_q} : next_highest_q);
  logic [5:0] select_1334;
  assign select_1334 = equal_384 ? last_q : (equal_1320 ? last_q : 6'h0);
  logic [7:0] select_1336;
  assign select_1336 = equal_379 ? {2'h0, last_q} : (equal_382 ? select_1332 : {2'h0, select_1334});
  logic [6:0] select_1339;
  assign select_1339 = equal_1320 ? whole_beats_q : 7'h0;
  logic [7:0] select_1341;
  assign select_1341 = equal_382 ? (run_last_shift_q ? {1'b0, whole_beats_q} : next_beats_q) : (equal_384 ? first_beats_q : {1'b0, select_1339});
  logic [5:0] select_1347;
  assign select_1347 = equal_382 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_384 ? (6'h0 - least_q) : 6'h0);
  logic select_1354;
  assign select_1354 = equal_382 ? (next_last_shift_q & not_1319) : (equal_384 & (least_q == 6'h0));
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1358;
  assign select_1358 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1362;
  assign select_1362 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:292
  logic less_1369;
  assign less_1369 = 6'h1c < column;
  // hls/stages/agreement.hpp:205
  logic [5:0] select_1372;
  assign select_1372 = and_359 ? (equal_1299 ? (less_1369 ? 6'h1d : column) : least_q) : least_q;
  // hls/stages/agreement.hpp:286
  logic [7:0] select_1375;
  assign select_1375 = equal_1299 ? (less_1369 ? ({2'h0, cfg_width_i[8:3]} + 8'hf1) : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1379;
  assign select_1379 = and_359 ? (equal_1299 ? {sum_1377, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:342
  logic not_1380;
  assign not_1380 = ~ends_q;
  // hls/stages/agreement.hpp:200
  logic [5:0] select_1381;
  assign select_1381 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1383;
  assign select_1383 = and_359 ? (equal_1299 ? 7'h0 : {select_1381, not_1380}) : {select_1381, not_1380};
  // hls/stages/agreement.hpp:200
  logic and_1385;
  assign and_1385 = not_1380 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:302
  logic [6:0] sum_1388;
  assign sum_1388 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:286
  logic select_1390;
  assign select_1390 = equal_1299 ? ({sum_1388[6], cfg_height_i[8:3]} == {1'b0, sum_1388[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:601
  logic [4:0] sum_1577;
  assign sum_1577 = {1'b0, last_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:153
  logic not_1922;
  assign not_1922 = ~run_shift_q[5];

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:871; read in stage 0, written in stage 5: 0 < 5 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_389;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:872; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (or_380 ? not_386 : select_473);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:873; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_382 ? (run_shift_q + x_q[5:0]) : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_381 & select_473);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 22, DISTANCE 12, hls/stages/agreement.hpp:874; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 22'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_380 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_528;
  logic [21:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_first_q <= 1'b0;
      right_q <= 1'b0;
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 3'h0;
      raster_at_y_q <= 3'h0;
      raster_at_column_q <= 6'h0;
      raster_at_row_q <= 6'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      raster_final_row_q <= 1'b0;
      averager_place_q <= 8'h0;
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
      last_q <= 6'h0;
      least_q <= 6'h0;
      first_beats_q <= 8'h0;
      whole_beats_q <= 7'h0;
      age_q <= 7'h0;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
      next_lowest_q <= 8'h0;
      next_highest_q <= 8'h0;
      next_beats_q <= 8'h0;
      next_shift_q <= 6'h0;
      next_last_shift_q <= 1'b0;
    end else if (s0_en) begin
      left_first_q <= and_1012 ? left_first_q : marks_first_i;
      right_q <= (~and_1012) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1012;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_320 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_1112;
      raster_at_column_q <= select_1114;
      raster_at_row_q <= select_1117;
      raster_at_live_q <= select_1121;
      raster_rows_left_q <= sample_pair_whole_q ? select_1123 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_1127;
      averager_place_q <= sample_pair_whole_q ? select_326 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= and_359 ? (equal_1299 ? 3'h1 : select_1300) : select_1300;
      run_lowest_q <= and_359 ? (equal_1299 ? 8'h0 : select_1303) : select_1303;
      run_highest_q <= and_359 ? (equal_1299 ? 8'h0 : select_1306) : select_1306;
      run_beats_q <= and_359 ? (equal_1299 ? 8'hc : select_1309) : select_1309;
      run_shift_q <= and_359 ? (equal_1299 ? 6'h0 : select_1312) : select_1312;
      run_last_shift_q <= and_359 ? (select_1315 & not_1316) : select_1315;
      following_phase_q <= select_1324;
      following_lowest_q <= drew ? 8'h0 : select_1329;
      following_highest_q <= drew ? 8'h0 : select_1336;
      following_beats_q <= drew ? 8'h3f : (equal_379 ? {1'b0, whole_beats_q} : select_1341);
      following_shift_q <= drew ? 6'h0 : (equal_379 ? 6'h0 : select_1347);
      following_last_shift_q <= not_945 & ((~equal_379) & select_1354);
      x_q <= and_359 ? (equal_1299 ? 8'h0 : select_1358) : select_1358;
      beats_left_q <= and_359 ? (equal_1299 ? 8'hc : select_1362) : select_1362;
      last_q <= and_359 ? (equal_1299 ? column : last_q) : last_q;
      least_q <= select_1372;
      first_beats_q <= and_359 ? select_1375 : first_beats_q;
      whole_beats_q <= select_1379;
      age_q <= select_1383;
      ends_q <= and_359 ? (and_1385 & not_1316) : and_1385;
      final_row_q <= and_359 ? select_1390 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1922}}, 1'b1} + run_beats_q;
      next_shift_q <= run_shift_q + 6'h1;
      next_last_shift_q <= {{2{run_shift_q[5]}}, run_shift_q} == ({2'h0, least_q} + 8'hff);
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [1:0] age_s1_q;
  logic select_320_s1_q;
  logic [7:0] select_326_s1_q;
  logic and_333_s1_q;
  logic equal_339_s1_q;
  logic whole_s1_q;
  logic [5:0] column_s1_q;
  logic and_357_s1_q;
  logic and_359_s1_q;
  logic equal_362_s1_q;
  logic drew_s1_q;
  logic equal_379_s1_q;
  logic or_380_s1_q;
  logic equal_382_s1_q;
  logic less_385_s1_q;
  logic not_386_s1_q;
  logic and_389_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_528_s1_q;
  logic equal_531_s1_q;
  logic equal_598_s1_q;
  logic equal_835_s1_q;
  logic and_893_s1_q;
  logic equal_899_s1_q;
  logic equal_909_s1_q;
  logic not_945_s1_q;
  logic equal_965_s1_q;
  logic not_1099_s1_q;
  logic equal_1299_s1_q;
  logic less_1578_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      age_s1_q <= {age_q[6], age_q[4]};
      select_320_s1_q <= select_320[0];
      select_326_s1_q <= select_326;
      and_333_s1_q <= and_333;
      equal_339_s1_q <= select_338 == 3'h0;
      whole_s1_q <= whole;
      column_s1_q <= column;
      and_357_s1_q <= and_357;
      and_359_s1_q <= and_359;
      equal_362_s1_q <= select_320 == 3'h1;
      drew_s1_q <= drew;
      equal_379_s1_q <= equal_379;
      or_380_s1_q <= or_380;
      equal_382_s1_q <= equal_382;
      less_385_s1_q <= less_385;
      not_386_s1_q <= not_386;
      and_389_s1_q <= and_389;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_528_s1_q <= select_528;
      equal_531_s1_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      equal_598_s1_q <= run_lowest_q == x_q;
      equal_835_s1_q <= run_lowest_q == x;
      and_893_s1_q <= not_381 & and_527;
      equal_899_s1_q <= run_highest_q == x;
      equal_909_s1_q <= run_phase_q == 3'h6;
      not_945_s1_q <= not_945;
      equal_965_s1_q <= x_q == {2'h0, last_q};
      not_1099_s1_q <= ~({sum_1097, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1299_s1_q <= equal_1299;
      less_1578_s1_q <= {2'h0, sum_1577, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:410
  logic equal_476;
  assign equal_476 = row_q == 6'h0;
  logic [11:0] select_477;
  assign select_477 = equal_476 ? 12'h0 : left_rdata_q[11:0];
  logic not_478;
  assign not_478 = ~equal_476;
  logic and_479;
  assign and_479 = left_rdata_q[12] & not_478;
  logic and_480;
  assign and_480 = left_rdata_q[13] & not_478;
  logic and_481;
  assign and_481 = left_rdata_q[14] & not_478;
  logic and_482;
  assign and_482 = left_rdata_q[15] & not_478;
  logic equal_483;
  assign equal_483 = row_q[5:1] == 5'h0;
  logic [11:0] select_484;
  assign select_484 = equal_483 ? 12'h0 : left_rdata_q[27:16];
  logic not_485;
  assign not_485 = ~equal_483;
  logic and_486;
  assign and_486 = left_rdata_q[28] & not_485;
  logic and_487;
  assign and_487 = left_rdata_q[29] & not_485;
  logic and_488;
  assign and_488 = left_rdata_q[30] & not_485;
  logic and_489;
  assign and_489 = left_rdata_q[31] & not_485;
  logic less_490;
  assign less_490 = row_q < 6'h3;
  logic [11:0] select_491;
  assign select_491 = less_490 ? 12'h0 : left_rdata_q[43:32];
  logic not_492;
  assign not_492 = ~less_490;
  logic and_493;
  assign and_493 = left_rdata_q[44] & not_492;
  logic and_494;
  assign and_494 = left_rdata_q[45] & not_492;
  logic and_495;
  assign and_495 = left_rdata_q[46] & not_492;
  logic and_496;
  assign and_496 = left_rdata_q[47] & not_492;
  logic equal_497;
  assign equal_497 = row_q[5:2] == 4'h0;
  logic [11:0] select_498;
  assign select_498 = equal_497 ? 12'h0 : left_rdata_q[59:48];
  logic not_499;
  assign not_499 = ~equal_497;
  logic and_500;
  assign and_500 = left_rdata_q[60] & not_499;
  // hls/stages/agreement.hpp:411
  logic [11:0] select_505;
  assign select_505 = equal_476 ? 12'h0 : right_codes_rdata_q[11:0];
  logic and_506;
  assign and_506 = right_codes_rdata_q[12] & not_478;
  logic [11:0] select_507;
  assign select_507 = equal_483 ? 12'h0 : right_codes_rdata_q[24:13];
  logic and_508;
  assign and_508 = right_codes_rdata_q[25] & not_485;
  logic [11:0] select_509;
  assign select_509 = less_490 ? 12'h0 : right_codes_rdata_q[37:26];
  logic and_510;
  assign and_510 = right_codes_rdata_q[38] & not_492;
  logic [11:0] select_511;
  assign select_511 = equal_497 ? 12'h0 : right_codes_rdata_q[50:39];
  logic and_512;
  assign and_512 = right_codes_rdata_q[51] & not_499;
  logic less_513;
  assign less_513 = row_q < 6'h5;
  logic [11:0] select_514;
  assign select_514 = less_513 ? 12'h0 : right_codes_rdata_q[63:52];
  logic and_516;
  assign and_516 = right_codes_rdata_q[64] & (~less_513);
  logic less_517;
  assign less_517 = row_q[5:1] < 5'h3;
  logic [11:0] select_518;
  assign select_518 = less_517 ? 12'h0 : right_codes_rdata_q[76:65];
  logic and_520;
  assign and_520 = right_codes_rdata_q[77] & (~less_517);
  // hls/stages/agreement.hpp:170
  logic and_537;
  assign and_537 = left_rdata_q[44] & not_386_s1_q;
  logic [11:0] a;
  assign a = less_385_s1_q ? 12'h0 : left_rdata_q[43:32];
  logic [11:0] b;
  assign b = less_385_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_543;
  assign not_543 = ~(a ^ b);
  logic [1:0] sum_545;
  assign sum_545 = {1'b0, not_543[2]} + ({1'b0, not_543[0]} + {1'b0, not_543[1]});
  logic [2:0] sum_548;
  assign sum_548 = {2'h0, not_543[5]} + ({2'h0, not_543[4]} + ({2'h0, not_543[3]} + {1'b0, sum_545}));
  logic [2:0] sum_549;
  assign sum_549 = {2'h0, not_543[6]} + sum_548;
  logic [3:0] sum_552;
  assign sum_552 = {3'h0, not_543[9]} + ({3'h0, not_543[8]} + ({3'h0, not_543[7]} + {1'b0, sum_549}));
  // hls/stages/agreement.hpp:170
  logic [11:0] a_2;
  assign a_2 = less_385_s1_q ? 12'h0 : left_rdata_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_562;
  assign not_562 = ~(a_2 ^ b_2);
  logic [1:0] sum_564;
  assign sum_564 = {1'b0, not_562[2]} + ({1'b0, not_562[0]} + {1'b0, not_562[1]});
  logic [2:0] sum_567;
  assign sum_567 = {2'h0, not_562[5]} + ({2'h0, not_562[4]} + ({2'h0, not_562[3]} + {1'b0, sum_564}));
  logic [2:0] sum_568;
  assign sum_568 = {2'h0, not_562[6]} + sum_567;
  logic [3:0] sum_571;
  assign sum_571 = {3'h0, not_562[9]} + ({3'h0, not_562[8]} + ({3'h0, not_562[7]} + {1'b0, sum_568}));
  // hls/stages/agreement.hpp:170
  logic and_576;
  assign and_576 = left_rdata_q[76] & not_386_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_385_s1_q ? 12'h0 : left_rdata_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_582;
  assign not_582 = ~(a_3 ^ b_3);
  logic [1:0] sum_584;
  assign sum_584 = {1'b0, not_582[2]} + ({1'b0, not_582[0]} + {1'b0, not_582[1]});
  logic [2:0] sum_587;
  assign sum_587 = {2'h0, not_582[5]} + ({2'h0, not_582[4]} + ({2'h0, not_582[3]} + {1'b0, sum_584}));
  logic [2:0] sum_588;
  assign sum_588 = {2'h0, not_582[6]} + sum_587;
  logic [3:0] sum_591;
  assign sum_591 = {3'h0, not_582[9]} + ({3'h0, not_582[8]} + ({3'h0, not_582[7]} + {1'b0, sum_588}));
  logic [11:0] not_603;
  assign not_603 = ~(a ^ b_2);
  logic [1:0] sum_605;
  assign sum_605 = {1'b0, not_603[2]} + ({1'b0, not_603[0]} + {1'b0, not_603[1]});
  logic [2:0] sum_608;
  assign sum_608 = {2'h0, not_603[5]} + ({2'h0, not_603[4]} + ({2'h0, not_603[3]} + {1'b0, sum_605}));
  logic [2:0] sum_609;
  assign sum_609 = {2'h0, not_603[6]} + sum_608;
  logic [3:0] sum_612;
  assign sum_612 = {3'h0, not_603[9]} + ({3'h0, not_603[8]} + ({3'h0, not_603[7]} + {1'b0, sum_609}));
  logic [11:0] not_618;
  assign not_618 = ~(a_2 ^ b_3);
  logic [1:0] sum_620;
  assign sum_620 = {1'b0, not_618[2]} + ({1'b0, not_618[0]} + {1'b0, not_618[1]});
  logic [2:0] sum_623;
  assign sum_623 = {2'h0, not_618[5]} + ({2'h0, not_618[4]} + ({2'h0, not_618[3]} + {1'b0, sum_620}));
  logic [2:0] sum_624;
  assign sum_624 = {2'h0, not_618[6]} + sum_623;
  logic [3:0] sum_627;
  assign sum_627 = {3'h0, not_618[9]} + ({3'h0, not_618[8]} + ({3'h0, not_618[7]} + {1'b0, sum_624}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_4;
  assign b_4 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_636;
  assign not_636 = ~(a_3 ^ b_4);
  logic [1:0] sum_638;
  assign sum_638 = {1'b0, not_636[2]} + ({1'b0, not_636[0]} + {1'b0, not_636[1]});
  logic [2:0] sum_641;
  assign sum_641 = {2'h0, not_636[5]} + ({2'h0, not_636[4]} + ({2'h0, not_636[3]} + {1'b0, sum_638}));
  logic [2:0] sum_642;
  assign sum_642 = {2'h0, not_636[6]} + sum_641;
  logic [3:0] sum_645;
  assign sum_645 = {3'h0, not_636[9]} + ({3'h0, not_636[8]} + ({3'h0, not_636[7]} + {1'b0, sum_642}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_5;
  assign b_5 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_660;
  assign not_660 = ~(a ^ b_5);
  logic [1:0] sum_662;
  assign sum_662 = {1'b0, not_660[2]} + ({1'b0, not_660[0]} + {1'b0, not_660[1]});
  logic [2:0] sum_665;
  assign sum_665 = {2'h0, not_660[5]} + ({2'h0, not_660[4]} + ({2'h0, not_660[3]} + {1'b0, sum_662}));
  logic [2:0] sum_666;
  assign sum_666 = {2'h0, not_660[6]} + sum_665;
  logic [3:0] sum_669;
  assign sum_669 = {3'h0, not_660[9]} + ({3'h0, not_660[8]} + ({3'h0, not_660[7]} + {1'b0, sum_666}));
  logic [11:0] not_675;
  assign not_675 = ~(a_2 ^ b);
  logic [1:0] sum_677;
  assign sum_677 = {1'b0, not_675[2]} + ({1'b0, not_675[0]} + {1'b0, not_675[1]});
  logic [2:0] sum_680;
  assign sum_680 = {2'h0, not_675[5]} + ({2'h0, not_675[4]} + ({2'h0, not_675[3]} + {1'b0, sum_677}));
  logic [2:0] sum_681;
  assign sum_681 = {2'h0, not_675[6]} + sum_680;
  logic [3:0] sum_684;
  assign sum_684 = {3'h0, not_675[9]} + ({3'h0, not_675[8]} + ({3'h0, not_675[7]} + {1'b0, sum_681}));
  logic [11:0] not_691;
  assign not_691 = ~(a_3 ^ b_2);
  logic [1:0] sum_693;
  assign sum_693 = {1'b0, not_691[2]} + ({1'b0, not_691[0]} + {1'b0, not_691[1]});
  logic [2:0] sum_696;
  assign sum_696 = {2'h0, not_691[5]} + ({2'h0, not_691[4]} + ({2'h0, not_691[3]} + {1'b0, sum_693}));
  logic [2:0] sum_697;
  assign sum_697 = {2'h0, not_691[6]} + sum_696;
  logic [3:0] sum_700;
  assign sum_700 = {3'h0, not_691[9]} + ({3'h0, not_691[8]} + ({3'h0, not_691[7]} + {1'b0, sum_697}));
  logic [11:0] not_715;
  assign not_715 = ~(a ^ b_3);
  logic [1:0] sum_717;
  assign sum_717 = {1'b0, not_715[2]} + ({1'b0, not_715[0]} + {1'b0, not_715[1]});
  logic [2:0] sum_720;
  assign sum_720 = {2'h0, not_715[5]} + ({2'h0, not_715[4]} + ({2'h0, not_715[3]} + {1'b0, sum_717}));
  logic [2:0] sum_721;
  assign sum_721 = {2'h0, not_715[6]} + sum_720;
  logic [3:0] sum_724;
  assign sum_724 = {3'h0, not_715[9]} + ({3'h0, not_715[8]} + ({3'h0, not_715[7]} + {1'b0, sum_721}));
  logic [11:0] not_730;
  assign not_730 = ~(a_2 ^ b_4);
  logic [1:0] sum_732;
  assign sum_732 = {1'b0, not_730[2]} + ({1'b0, not_730[0]} + {1'b0, not_730[1]});
  logic [2:0] sum_735;
  assign sum_735 = {2'h0, not_730[5]} + ({2'h0, not_730[4]} + ({2'h0, not_730[3]} + {1'b0, sum_732}));
  logic [2:0] sum_736;
  assign sum_736 = {2'h0, not_730[6]} + sum_735;
  logic [3:0] sum_739;
  assign sum_739 = {3'h0, not_730[9]} + ({3'h0, not_730[8]} + ({3'h0, not_730[7]} + {1'b0, sum_736}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_6;
  assign b_6 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_748;
  assign not_748 = ~(a_3 ^ b_6);
  logic [1:0] sum_750;
  assign sum_750 = {1'b0, not_748[2]} + ({1'b0, not_748[0]} + {1'b0, not_748[1]});
  logic [2:0] sum_753;
  assign sum_753 = {2'h0, not_748[5]} + ({2'h0, not_748[4]} + ({2'h0, not_748[3]} + {1'b0, sum_750}));
  logic [2:0] sum_754;
  assign sum_754 = {2'h0, not_748[6]} + sum_753;
  logic [3:0] sum_757;
  assign sum_757 = {3'h0, not_748[9]} + ({3'h0, not_748[8]} + ({3'h0, not_748[7]} + {1'b0, sum_754}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_7;
  assign b_7 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:420
  logic [11:0] not_777;
  assign not_777 = ~(a ^ b_7);
  logic [1:0] sum_779;
  assign sum_779 = {1'b0, not_777[2]} + ({1'b0, not_777[0]} + {1'b0, not_777[1]});
  logic [2:0] sum_782;
  assign sum_782 = {2'h0, not_777[5]} + ({2'h0, not_777[4]} + ({2'h0, not_777[3]} + {1'b0, sum_779}));
  logic [2:0] sum_783;
  assign sum_783 = {2'h0, not_777[6]} + sum_782;
  logic [3:0] sum_786;
  assign sum_786 = {3'h0, not_777[9]} + ({3'h0, not_777[8]} + ({3'h0, not_777[7]} + {1'b0, sum_783}));
  logic [11:0] not_792;
  assign not_792 = ~(a_2 ^ b_5);
  logic [1:0] sum_794;
  assign sum_794 = {1'b0, not_792[2]} + ({1'b0, not_792[0]} + {1'b0, not_792[1]});
  logic [2:0] sum_797;
  assign sum_797 = {2'h0, not_792[5]} + ({2'h0, not_792[4]} + ({2'h0, not_792[3]} + {1'b0, sum_794}));
  logic [2:0] sum_798;
  assign sum_798 = {2'h0, not_792[6]} + sum_797;
  logic [3:0] sum_801;
  assign sum_801 = {3'h0, not_792[9]} + ({3'h0, not_792[8]} + ({3'h0, not_792[7]} + {1'b0, sum_798}));
  logic [11:0] not_808;
  assign not_808 = ~(a_3 ^ b);
  logic [1:0] sum_810;
  assign sum_810 = {1'b0, not_808[2]} + ({1'b0, not_808[0]} + {1'b0, not_808[1]});
  logic [2:0] sum_813;
  assign sum_813 = {2'h0, not_808[5]} + ({2'h0, not_808[4]} + ({2'h0, not_808[3]} + {1'b0, sum_810}));
  logic [2:0] sum_814;
  assign sum_814 = {2'h0, not_808[6]} + sum_813;
  logic [3:0] sum_817;
  assign sum_817 = {3'h0, not_808[9]} + ({3'h0, not_808[8]} + ({3'h0, not_808[7]} + {1'b0, sum_814}));
  // hls/stages/agreement.hpp:571
  logic [5:0] sum_894;
  assign sum_894 = x_s1_q[5:0] + best_left_rdata_q[13:8];
  // hls/stages/agreement.hpp:475
  logic [5:0] partner;
  assign partner = run_shift_s1_q + x_s1_2_q[5:0];
  // hls/stages/agreement.hpp:339
  logic and_1101;
  assign and_1101 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1099_s1_q);
  // hls/stages/agreement.hpp:286
  logic select_1395;
  assign select_1395 = equal_1299_s1_q ? (~({row_s1_q, 1'b0} < {sum_1392, cfg_height_i[3]})) : lower_half_q;

  // Memory best_right, 47 x 15, DISTANCE 12, hls/stages/agreement.hpp:875; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 15'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_380_s1_q ? sum_894 : partner;
  logic best_right_re;
  assign best_right_re = s1_en & select_528_s1_q;
  logic [14:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_389_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_500, select_498, and_496, and_495, and_494, and_493, select_491, and_489, and_488, and_487, and_486, select_484, and_482, and_481, and_480, and_479, select_477, fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 6'd47) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 6'd47) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [5:0] right_codes_waddr;
  assign right_codes_waddr = x_s1_q[5:0];
  logic right_codes_we;
  assign right_codes_we = s1_en & and_389_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_520, select_518, and_516, select_514, and_512, select_511, and_510, select_509, and_508, select_507, and_506, select_505, fresh_rdata_q[25], fresh_rdata_q[23:12]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 6'd47) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 6'd47) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 6'h0;
      lower_half_q <= 1'b0;
    end else if (s1_en) begin
      row_q <= and_359_s1_q ? (equal_1299_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_359_s1_q ? select_1395 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic left_first_s2_q;
  logic sample_pair_whole_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [1:0] age_s2_q;
  logic lower_half_s2_q;
  logic select_320_s2_q;
  logic [7:0] select_326_s2_q;
  logic and_333_s2_q;
  logic equal_339_s2_q;
  logic whole_s2_q;
  logic [5:0] column_s2_q;
  logic and_357_s2_q;
  logic and_359_s2_q;
  logic equal_362_s2_q;
  logic drew_s2_q;
  logic equal_379_s2_q;
  logic or_380_s2_q;
  logic equal_382_s2_q;
  logic less_385_s2_q;
  logic not_386_s2_q;
  logic equal_418_s2_q;
  logic left_rdata_s2_q;
  logic [6:0] x_s2_2_q;
  logic [21:0] best_left_rdata_s2_q;
  logic equal_531_s2_q;
  logic and_537_s2_q;
  logic and_538_s2_q;
  logic not_543_s2_q;
  logic [3:0] sum_553_s2_q;
  logic and_556_s2_q;
  logic and_557_s2_q;
  logic not_562_s2_q;
  logic [3:0] sum_572_s2_q;
  logic and_576_s2_q;
  logic and_577_s2_q;
  logic not_582_s2_q;
  logic [3:0] sum_592_s2_q;
  logic equal_598_s2_q;
  logic not_603_s2_q;
  logic [3:0] sum_613_s2_q;
  logic not_618_s2_q;
  logic [3:0] sum_628_s2_q;
  logic and_632_s2_q;
  logic not_636_s2_q;
  logic [3:0] sum_646_s2_q;
  logic and_656_s2_q;
  logic not_660_s2_q;
  logic [3:0] sum_670_s2_q;
  logic not_675_s2_q;
  logic [3:0] sum_685_s2_q;
  logic not_691_s2_q;
  logic [3:0] sum_701_s2_q;
  logic not_715_s2_q;
  logic [3:0] sum_725_s2_q;
  logic not_730_s2_q;
  logic [3:0] sum_740_s2_q;
  logic and_745_s2_q;
  logic not_748_s2_q;
  logic [3:0] sum_758_s2_q;
  logic and_774_s2_q;
  logic not_777_s2_q;
  logic [3:0] sum_787_s2_q;
  logic not_792_s2_q;
  logic [3:0] sum_802_s2_q;
  logic not_808_s2_q;
  logic [3:0] sum_818_s2_q;
  logic equal_835_s2_q;
  logic and_893_s2_q;
  logic [5:0] sum_894_s2_q;
  logic [5:0] partner_s2_q;
  logic equal_899_s2_q;
  logic equal_909_s2_q;
  logic and_913_s2_q;
  logic and_924_s2_q;
  logic not_945_s2_q;
  logic equal_965_s2_q;
  logic and_1012_s2_q;
  logic and_1101_s2_q;
  logic equal_1247_s2_q;
  logic equal_1299_s2_q;
  logic less_1576_s2_q;
  logic less_1578_s2_q;
  logic equal_1840_s2_q;
  logic less_1851_s2_q;
  logic equal_1994_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= sample_last_q;
      left_first_s2_q <= sample_pair_first_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      age_s2_q <= age_s1_q;
      lower_half_s2_q <= lower_half_q;
      select_320_s2_q <= select_320_s1_q;
      select_326_s2_q <= select_326_s1_q;
      and_333_s2_q <= and_333_s1_q;
      equal_339_s2_q <= equal_339_s1_q;
      whole_s2_q <= whole_s1_q;
      column_s2_q <= column_s1_q;
      and_357_s2_q <= and_357_s1_q;
      and_359_s2_q <= and_359_s1_q;
      equal_362_s2_q <= equal_362_s1_q;
      drew_s2_q <= drew_s1_q;
      equal_379_s2_q <= equal_379_s1_q;
      or_380_s2_q <= or_380_s1_q;
      equal_382_s2_q <= equal_382_s1_q;
      less_385_s2_q <= less_385_s1_q;
      not_386_s2_q <= not_386_s1_q;
      equal_418_s2_q <= row_s1_q == 6'h0;
      left_rdata_s2_q <= left_rdata_q[62];
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      equal_531_s2_q <= equal_531_s1_q;
      and_537_s2_q <= and_537;
      and_538_s2_q <= right_codes_rdata_q[38] & not_386_s1_q;
      not_543_s2_q <= not_543[11];
      sum_553_s2_q <= {3'h0, not_543[10]} + sum_552;
      and_556_s2_q <= left_rdata_q[60] & not_386_s1_q;
      and_557_s2_q <= right_codes_rdata_q[51] & not_386_s1_q;
      not_562_s2_q <= not_562[11];
      sum_572_s2_q <= {3'h0, not_562[10]} + sum_571;
      and_576_s2_q <= and_576;
      and_577_s2_q <= right_codes_rdata_q[64] & not_386_s1_q;
      not_582_s2_q <= not_582[11];
      sum_592_s2_q <= {3'h0, not_582[10]} + sum_591;
      equal_598_s2_q <= equal_598_s1_q;
      not_603_s2_q <= not_603[11];
      sum_613_s2_q <= {3'h0, not_603[10]} + sum_612;
      not_618_s2_q <= not_618[11];
      sum_628_s2_q <= {3'h0, not_618[10]} + sum_627;
      and_632_s2_q <= right_codes_rdata_q[77] & not_386_s1_q;
      not_636_s2_q <= not_636[11];
      sum_646_s2_q <= {3'h0, not_636[10]} + sum_645;
      and_656_s2_q <= right_codes_rdata_q[25] & not_386_s1_q;
      not_660_s2_q <= not_660[11];
      sum_670_s2_q <= {3'h0, not_660[10]} + sum_669;
      not_675_s2_q <= not_675[11];
      sum_685_s2_q <= {3'h0, not_675[10]} + sum_684;
      not_691_s2_q <= not_691[11];
      sum_701_s2_q <= {3'h0, not_691[10]} + sum_700;
      not_715_s2_q <= not_715[11];
      sum_725_s2_q <= {3'h0, not_715[10]} + sum_724;
      not_730_s2_q <= not_730[11];
      sum_740_s2_q <= {3'h0, not_730[10]} + sum_739;
      and_745_s2_q <= and_576 & (right_codes_rdata_q[90] & not_386_s1_q);
      not_748_s2_q <= not_748[11];
      sum_758_s2_q <= {3'h0, not_748[10]} + sum_757;
      and_774_s2_q <= and_537 & (right_codes_rdata_q[12] & not_386_s1_q);
      not_777_s2_q <= not_777[11];
      sum_787_s2_q <= {3'h0, not_777[10]} + sum_786;
      not_792_s2_q <= not_792[11];
      sum_802_s2_q <= {3'h0, not_792[10]} + sum_801;
      not_808_s2_q <= not_808[11];
      sum_818_s2_q <= {3'h0, not_808[10]} + sum_817;
      equal_835_s2_q <= equal_835_s1_q;
      and_893_s2_q <= and_893_s1_q;
      sum_894_s2_q <= sum_894;
      partner_s2_q <= partner;
      equal_899_s2_q <= equal_899_s1_q;
      equal_909_s2_q <= equal_909_s1_q;
      and_913_s2_q <= left_rdata_q[61] & (~(row_q[5:3] == 3'h0));
      and_924_s2_q <= left_rdata_q[63] & not_386_s1_q;
      not_945_s2_q <= not_945_s1_q;
      equal_965_s2_q <= equal_965_s1_q;
      and_1012_s2_q <= sample_pair_whole_q;
      and_1101_s2_q <= and_1101;
      equal_1247_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_1299_s2_q <= equal_1299_s1_q;
      less_1576_s2_q <= 5'h4 < row_q[5:1];
      less_1578_s2_q <= less_1578_s1_q;
      equal_1840_s2_q <= row_s1_q[5:2] == 4'h0;
      less_1851_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_1994_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic and_334;
  assign and_334 = sample_pair_whole_s2_q & and_333_s2_q;
  // hls/stages/agreement.hpp:420
  logic [3:0] column_2;
  assign column_2 = (and_537_s2_q & and_538_s2_q) ? ({3'h0, not_543_s2_q} + sum_553_s2_q) : 4'h0;
  logic [3:0] select_574;
  assign select_574 = (and_556_s2_q & and_557_s2_q) ? ({3'h0, not_562_s2_q} + sum_572_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_3;
  assign column_3 = {1'b0, column_2} + {1'b0, select_574};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_594;
  assign select_594 = (and_576_s2_q & and_577_s2_q) ? ({3'h0, not_582_s2_q} + sum_592_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_4;
  assign column_4 = {1'b0, column_3} + {2'h0, select_594};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_597;
  assign difference_597 = {2'h0, column_4} - (age_s2_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_600;
  assign sum_600 = difference_597 + (equal_598_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:420
  logic [3:0] column_5;
  assign column_5 = (and_537_s2_q & and_557_s2_q) ? ({3'h0, not_603_s2_q} + sum_613_s2_q) : 4'h0;
  logic [3:0] select_630;
  assign select_630 = (and_556_s2_q & and_577_s2_q) ? ({3'h0, not_618_s2_q} + sum_628_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_6;
  assign column_6 = {1'b0, column_5} + {1'b0, select_630};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_648;
  assign select_648 = (and_576_s2_q & and_632_s2_q) ? ({3'h0, not_636_s2_q} + sum_646_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_7;
  assign column_7 = {1'b0, column_6} + {2'h0, select_648};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_651;
  assign difference_651 = {2'h0, column_7} - (age_s2_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_653;
  assign sum_653 = difference_651 + (equal_598_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:463
  logic less_654;
  assign less_654 = sum_600 < sum_653;
  // hls/stages/agreement.hpp:420
  logic [3:0] column_8;
  assign column_8 = (and_537_s2_q & and_656_s2_q) ? ({3'h0, not_660_s2_q} + sum_670_s2_q) : 4'h0;
  logic [3:0] select_687;
  assign select_687 = (and_556_s2_q & and_538_s2_q) ? ({3'h0, not_675_s2_q} + sum_685_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_9;
  assign column_9 = {1'b0, column_8} + {1'b0, select_687};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_703;
  assign select_703 = (and_576_s2_q & and_557_s2_q) ? ({3'h0, not_691_s2_q} + sum_701_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_10;
  assign column_10 = {1'b0, column_9} + {2'h0, select_703};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_706;
  assign difference_706 = {2'h0, column_10} - (age_s2_q[1] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_708;
  assign sum_708 = difference_706 + (equal_598_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:463
  logic not_710;
  assign not_710 = ~less_654;
  logic [1:0] best;
  assign best = ((less_654 ? sum_653 : sum_600) < sum_708) ? 2'h3 : {not_710, less_654};
  // hls/stages/agreement.hpp:420
  logic [3:0] column_11;
  assign column_11 = (and_537_s2_q & and_577_s2_q) ? ({3'h0, not_715_s2_q} + sum_725_s2_q) : 4'h0;
  logic [3:0] select_742;
  assign select_742 = (and_556_s2_q & and_632_s2_q) ? ({3'h0, not_730_s2_q} + sum_740_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_12;
  assign column_12 = {1'b0, column_11} + {1'b0, select_742};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_760;
  assign select_760 = and_745_s2_q ? ({3'h0, not_748_s2_q} + sum_758_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_13;
  assign column_13 = {1'b0, column_12} + {2'h0, select_760};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_763;
  assign difference_763 = {2'h0, column_13} - (age_s2_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_765;
  assign sum_765 = difference_763 + (equal_598_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:463
  logic [7:0] select_767;
  assign select_767 = best[1] ? (best[0] ? sum_708 : sum_600) : (best[0] ? sum_653 : sum_765);
  logic [1:0] best_2;
  assign best_2 = (select_767 < sum_765) ? 2'h0 : best;
  // hls/stages/agreement.hpp:420
  logic [3:0] column_14;
  assign column_14 = and_774_s2_q ? ({3'h0, not_777_s2_q} + sum_787_s2_q) : 4'h0;
  logic [3:0] select_804;
  assign select_804 = (and_556_s2_q & and_656_s2_q) ? ({3'h0, not_792_s2_q} + sum_802_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [4:0] column_15;
  assign column_15 = {1'b0, column_14} + {1'b0, select_804};
  // hls/stages/agreement.hpp:420
  logic [3:0] select_820;
  assign select_820 = (and_576_s2_q & and_538_s2_q) ? ({3'h0, not_808_s2_q} + sum_818_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:448
  logic [5:0] column_16;
  assign column_16 = {1'b0, column_15} + {2'h0, select_820};
  // hls/stages/agreement.hpp:450
  logic [7:0] difference_823;
  assign difference_823 = {2'h0, column_16} - (age_s2_q[1] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_825;
  assign sum_825 = difference_823 + (equal_598_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:591
  logic not_910;
  assign not_910 = ~equal_909_s2_q;
  // hls/stages/agreement.hpp:582
  logic and_914;
  assign and_914 = not_386_s2_q & and_913_s2_q;
  // hls/stages/agreement.hpp:574
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:578
  logic and_919;
  assign and_919 = (left_rdata_s2_q & (8'hb6 < best_left_rdata_s2_q[7:0])) & ($signed(9'h1fe) < $signed(way));
  logic and_920;
  assign and_920 = left_rdata_s2_q & and_913_s2_q;
  // hls/stages/agreement.hpp:582
  logic and_923;
  assign and_923 = not_386_s2_q & (and_913_s2_q ? (and_919 ? left_rdata_s2_q : and_920) : and_920);
  // hls/stages/agreement.hpp:578
  logic less_925;
  assign less_925 = $signed(way[8:1]) < $signed(8'h1);
  // hls/stages/agreement.hpp:582
  logic and_928;
  assign and_928 = not_386_s2_q & (and_913_s2_q & (and_919 & less_925));
  // hls/stages/agreement.hpp:580
  logic and_931;
  assign and_931 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s2_q[13:8]));
  // hls/stages/agreement.hpp:174
  logic and_933;
  assign and_933 = less_925 & ((cfg_nearer_below_i & best_left_rdata_s2_q[13]) | and_931);
  // hls/stages/agreement.hpp:582
  logic and_936;
  assign and_936 = not_386_s2_q & (and_913_s2_q & (and_919 & and_933));
  // hls/stages/agreement.hpp:181
  logic [5:0] select_937;
  assign select_937 = less_385_s2_q ? 6'h0 : best_left_rdata_s2_q[13:8];
  logic [11:0] select_938;
  assign select_938 = or_380_s2_q ? {select_937, and_936, and_928, and_924_s2_q, and_923, and_914, not_386_s2_q} : 12'h0;
  // hls/stages/agreement.hpp:339
  logic and_940;
  assign and_940 = not_910 & (drew_s2_q & select_938[0]);
  logic and_949;
  assign and_949 = not_910 & (drew_s2_q ? select_938[0] : (equal_379_s2_q & select_938[4]));
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1398;
  assign select_1398 = or_380_s2_q ? sums_0_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_13} : sums_0_columns_values_0_q);
  logic [7:0] select_1399;
  assign select_1399 = equal_382_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1401;
  assign select_1401 = equal_382_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1403;
  assign select_1403 = equal_382_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1405;
  assign select_1405 = equal_382_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1407;
  assign select_1407 = equal_382_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1409;
  assign select_1409 = equal_382_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1412;
  assign select_1412 = or_380_s2_q ? sums_0_sum_sums_values_0_q : (equal_382_s2_q ? sum_765 : sums_0_sum_sums_values_0_q);
  logic [7:0] select_1414;
  assign select_1414 = or_380_s2_q ? sums_1_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_7} : sums_1_columns_values_0_q);
  logic [7:0] select_1415;
  assign select_1415 = equal_382_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1417;
  assign select_1417 = equal_382_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1419;
  assign select_1419 = equal_382_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1421;
  assign select_1421 = equal_382_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1423;
  assign select_1423 = equal_382_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1425;
  assign select_1425 = equal_382_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1428;
  assign select_1428 = or_380_s2_q ? sums_1_sum_sums_values_0_q : (equal_382_s2_q ? sum_653 : sums_1_sum_sums_values_0_q);
  logic [7:0] select_1430;
  assign select_1430 = or_380_s2_q ? sums_2_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_4} : sums_2_columns_values_0_q);
  logic [7:0] select_1431;
  assign select_1431 = equal_382_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1433;
  assign select_1433 = equal_382_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1435;
  assign select_1435 = equal_382_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1437;
  assign select_1437 = equal_382_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1439;
  assign select_1439 = equal_382_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1441;
  assign select_1441 = equal_382_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1444;
  assign select_1444 = or_380_s2_q ? sums_2_sum_sums_values_0_q : (equal_382_s2_q ? sum_600 : sums_2_sum_sums_values_0_q);
  logic [7:0] select_1446;
  assign select_1446 = or_380_s2_q ? sums_3_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_10} : sums_3_columns_values_0_q);
  logic [7:0] select_1447;
  assign select_1447 = equal_382_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1449;
  assign select_1449 = equal_382_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1451;
  assign select_1451 = equal_382_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1453;
  assign select_1453 = equal_382_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1455;
  assign select_1455 = equal_382_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1457;
  assign select_1457 = equal_382_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1460;
  assign select_1460 = or_380_s2_q ? sums_3_sum_sums_values_0_q : (equal_382_s2_q ? sum_708 : sums_3_sum_sums_values_0_q);
  logic [7:0] select_1462;
  assign select_1462 = or_380_s2_q ? sums_4_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_16} : sums_4_columns_values_0_q);
  logic [7:0] select_1463;
  assign select_1463 = equal_382_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1465;
  assign select_1465 = equal_382_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1467;
  assign select_1467 = equal_382_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1469;
  assign select_1469 = equal_382_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1471;
  assign select_1471 = equal_382_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1473;
  assign select_1473 = equal_382_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  logic [7:0] select_1476;
  assign select_1476 = or_380_s2_q ? sums_4_sum_sums_values_0_q : (equal_382_s2_q ? sum_825 : sums_4_sum_sums_values_0_q);
  // hls/stages/registration.hpp:158
  logic [16:0] select_1583;
  assign select_1583 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [13:0] select_1585;
  assign select_1585 = ($signed(10'h0) < $signed(select_1583[16:7])) ? 14'h7f : select_1583[13:0];
  // hls/stages/registration.hpp:153
  logic [9:0] select_1586;
  assign select_1586 = select_938[10] ? select_1585[9:0] : 10'h0;
  logic [8:0] difference_1588;
  assign difference_1588 = select_1586[9:1] - (select_938[11] ? select_1585[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1591;
  assign sum_1591 = (select_938[6] ? select_1585[13:1] : 13'h0) + (select_938[7] ? select_1585[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1592;
  assign select_1592 = select_938[8] ? select_1585[11:0] : 12'h0;
  logic [10:0] sum_1594;
  assign sum_1594 = select_1592[11:1] + (select_938[9] ? select_1585[10:0] : 11'h0);
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1595;
  assign sum_1595 = sum_1591[12:1] + {sum_1594, select_1592[0]};
  logic [9:0] sum_1596;
  assign sum_1596 = {difference_1588, select_1586[0]} + sum_1595[11:2];
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1597;
  assign sum_1597 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_1596[9]}}, sum_1596[9:2]};
  // hls/stages/registration.hpp:57
  logic [23:0] select_1841;
  assign select_1841 = equal_1840_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:205
  logic [23:0] select_1843;
  assign select_1843 = and_359_s2_q ? (equal_1299_s2_q ? select_1841 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1844;
  assign select_1844 = equal_1840_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:205
  logic [27:0] select_1846;
  assign select_1846 = and_359_s2_q ? (equal_1299_s2_q ? select_1844 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1848;
  assign select_1848 = drew_s2_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1849;
  assign sum_1849 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1850;
  assign sum_1850 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:146; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_326_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_334;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:876; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_940;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      registration_next_slope_row_q <= 24'h0;
      registration_next_slope_change_q <= 28'h0;
    end else if (s2_en) begin
      registration_slope_row_q <= select_1843;
      registration_slope_change_q <= select_1846;
      registration_slope_q <= select_1848;
      registration_next_slope_row_q <= sum_1849;
      registration_next_slope_change_q <= sum_1850;
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
      sums_0_columns_values_0_q <= select_1398;
      sums_0_columns_values_1_q <= or_380_s2_q ? sums_0_columns_values_1_q : select_1399;
      sums_0_columns_values_2_q <= or_380_s2_q ? sums_0_columns_values_2_q : select_1401;
      sums_0_columns_values_3_q <= or_380_s2_q ? sums_0_columns_values_3_q : select_1403;
      sums_0_columns_values_4_q <= or_380_s2_q ? sums_0_columns_values_4_q : select_1405;
      sums_0_columns_values_5_q <= or_380_s2_q ? sums_0_columns_values_5_q : select_1407;
      sums_0_columns_values_6_q <= or_380_s2_q ? sums_0_columns_values_6_q : select_1409;
      sums_0_sum_sums_values_0_q <= select_1412;
      sums_1_columns_values_0_q <= select_1414;
      sums_1_columns_values_1_q <= or_380_s2_q ? sums_1_columns_values_1_q : select_1415;
      sums_1_columns_values_2_q <= or_380_s2_q ? sums_1_columns_values_2_q : select_1417;
      sums_1_columns_values_3_q <= or_380_s2_q ? sums_1_columns_values_3_q : select_1419;
      sums_1_columns_values_4_q <= or_380_s2_q ? sums_1_columns_values_4_q : select_1421;
      sums_1_columns_values_5_q <= or_380_s2_q ? sums_1_columns_values_5_q : select_1423;
      sums_1_columns_values_6_q <= or_380_s2_q ? sums_1_columns_values_6_q : select_1425;
      sums_1_sum_sums_values_0_q <= select_1428;
      sums_2_columns_values_0_q <= select_1430;
      sums_2_columns_values_1_q <= or_380_s2_q ? sums_2_columns_values_1_q : select_1431;
      sums_2_columns_values_2_q <= or_380_s2_q ? sums_2_columns_values_2_q : select_1433;
      sums_2_columns_values_3_q <= or_380_s2_q ? sums_2_columns_values_3_q : select_1435;
      sums_2_columns_values_4_q <= or_380_s2_q ? sums_2_columns_values_4_q : select_1437;
      sums_2_columns_values_5_q <= or_380_s2_q ? sums_2_columns_values_5_q : select_1439;
      sums_2_columns_values_6_q <= or_380_s2_q ? sums_2_columns_values_6_q : select_1441;
      sums_2_sum_sums_values_0_q <= select_1444;
      sums_3_columns_values_0_q <= select_1446;
      sums_3_columns_values_1_q <= or_380_s2_q ? sums_3_columns_values_1_q : select_1447;
      sums_3_columns_values_2_q <= or_380_s2_q ? sums_3_columns_values_2_q : select_1449;
      sums_3_columns_values_3_q <= or_380_s2_q ? sums_3_columns_values_3_q : select_1451;
      sums_3_columns_values_4_q <= or_380_s2_q ? sums_3_columns_values_4_q : select_1453;
      sums_3_columns_values_5_q <= or_380_s2_q ? sums_3_columns_values_5_q : select_1455;
      sums_3_columns_values_6_q <= or_380_s2_q ? sums_3_columns_values_6_q : select_1457;
      sums_3_sum_sums_values_0_q <= select_1460;
      sums_4_columns_values_0_q <= select_1462;
      sums_4_columns_values_1_q <= or_380_s2_q ? sums_4_columns_values_1_q : select_1463;
      sums_4_columns_values_2_q <= or_380_s2_q ? sums_4_columns_values_2_q : select_1465;
      sums_4_columns_values_3_q <= or_380_s2_q ? sums_4_columns_values_3_q : select_1467;
      sums_4_columns_values_4_q <= or_380_s2_q ? sums_4_columns_values_4_q : select_1469;
      sums_4_columns_values_5_q <= or_380_s2_q ? sums_4_columns_values_5_q : select_1471;
      sums_4_columns_values_6_q <= or_380_s2_q ? sums_4_columns_values_6_q : select_1473;
      sums_4_sum_sums_values_0_q <= select_1476;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic left_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic [5:0] run_shift_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic lower_half_s3_q;
  logic select_320_s3_q;
  logic [7:0] select_326_s3_q;
  logic and_333_s3_q;
  logic and_334_s3_q;
  logic equal_339_s3_q;
  logic whole_s3_q;
  logic [5:0] column_s3_q;
  logic and_357_s3_q;
  logic and_359_s3_q;
  logic equal_362_s3_q;
  logic drew_s3_q;
  logic or_380_s3_q;
  logic less_385_s3_q;
  logic equal_418_s3_q;
  logic [6:0] x_s3_2_q;
  logic [21:0] best_left_rdata_s3_q;
  logic equal_531_s3_q;
  logic [7:0] sum_600_s3_q;
  logic [7:0] sum_653_s3_q;
  logic [7:0] sum_708_s3_q;
  logic [7:0] sum_765_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_825_s3_q;
  logic equal_835_s3_q;
  logic and_893_s3_q;
  logic [5:0] sum_894_s3_q;
  logic [5:0] partner_s3_q;
  logic [14:0] best_right_rdata_s3_q;
  logic equal_899_s3_q;
  logic equal_909_s3_q;
  logic not_910_s3_q;
  logic [11:0] select_938_s3_q;
  logic and_940_s3_q;
  logic not_945_s3_q;
  logic and_949_s3_q;
  logic equal_965_s3_q;
  logic and_1012_s3_q;
  logic and_1102_s3_q;
  logic equal_1247_s3_q;
  logic equal_1299_s3_q;
  logic less_1576_s3_q;
  logic less_1578_s3_q;
  logic [7:0] sum_1597_s3_q;
  logic less_1598_s3_q;
  logic less_1599_s3_q;
  logic less_1851_s3_q;
  logic equal_1994_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      left_first_s3_q <= left_first_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      run_shift_s3_q <= run_shift_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[0];
      lower_half_s3_q <= lower_half_s2_q;
      select_320_s3_q <= select_320_s2_q;
      select_326_s3_q <= select_326_s2_q;
      and_333_s3_q <= and_333_s2_q;
      and_334_s3_q <= and_334;
      equal_339_s3_q <= equal_339_s2_q;
      whole_s3_q <= whole_s2_q;
      column_s3_q <= column_s2_q;
      and_357_s3_q <= and_357_s2_q;
      and_359_s3_q <= and_359_s2_q;
      equal_362_s3_q <= equal_362_s2_q;
      drew_s3_q <= drew_s2_q;
      or_380_s3_q <= or_380_s2_q;
      less_385_s3_q <= less_385_s2_q;
      equal_418_s3_q <= equal_418_s2_q;
      x_s3_2_q <= x_s2_2_q;
      best_left_rdata_s3_q <= best_left_rdata_s2_q;
      equal_531_s3_q <= equal_531_s2_q;
      sum_600_s3_q <= sum_600;
      sum_653_s3_q <= sum_653;
      sum_708_s3_q <= sum_708;
      sum_765_s3_q <= sum_765;
      best_2_s3_q <= best_2;
      sum_825_s3_q <= sum_825;
      equal_835_s3_q <= equal_835_s2_q;
      and_893_s3_q <= and_893_s2_q;
      sum_894_s3_q <= sum_894_s2_q;
      partner_s3_q <= partner_s2_q;
      best_right_rdata_s3_q <= best_right_rdata_q;
      equal_899_s3_q <= equal_899_s2_q;
      equal_909_s3_q <= equal_909_s2_q;
      not_910_s3_q <= not_910;
      select_938_s3_q <= select_938;
      and_940_s3_q <= and_940;
      not_945_s3_q <= not_945_s2_q;
      and_949_s3_q <= and_949;
      equal_965_s3_q <= equal_965_s2_q;
      and_1012_s3_q <= and_1012_s2_q;
      and_1102_s3_q <= not_910 & and_1101_s2_q;
      equal_1247_s3_q <= equal_1247_s2_q;
      equal_1299_s3_q <= equal_1299_s2_q;
      less_1576_s3_q <= less_1576_s2_q;
      less_1578_s3_q <= less_1578_s2_q;
      sum_1597_s3_q <= sum_1597[7:0];
      less_1598_s3_q <= $signed(6'h0) < $signed(sum_1597[12:7]);
      less_1599_s3_q <= $signed(sum_1597[12:7]) < $signed(6'h3f);
      less_1851_s3_q <= less_1851_s2_q;
      equal_1994_s3_q <= equal_1994_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  // hls/stages/census.hpp:91
  logic [11:0] select_337;
  assign select_337 = select_320_s3_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:100
  logic [11:0] sum_341;
  assign sum_341 = select_337 + (equal_339_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:91
  logic [11:0] sum_343;
  assign sum_343 = {4'h0, sample_pair_pixel_1_q} + (select_320_s3_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:100
  logic [11:0] sum_345;
  assign sum_345 = sum_343 + (equal_339_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:101
  logic and_349;
  assign and_349 = whole_s3_q & (averager_memory_rdata_q[24] | equal_339_s3_q);
  // hls/stages/agreement.hpp:202
  logic all_of_skin;
  assign all_of_skin = select_320_s3_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:102
  logic and_353;
  assign and_353 = all_of_skin & (averager_memory_rdata_q[25] | equal_339_s3_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_333_s3_q ? sum_341[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_333_s3_q ? sum_345[11:3] : 9'h0;
  logic and_370;
  assign and_370 = and_333_s3_q & and_349;
  // hls/stages/census.hpp:105
  logic select_372;
  assign select_372 = equal_362_s3_q ? and_370 : (averager_mask_q & and_370);
  // hls/stages/agreement.hpp:204
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_372;
  // hls/stages/census.hpp:126
  logic and_374;
  assign and_374 = and_333_s3_q & and_353;
  // hls/stages/census.hpp:105
  logic select_376;
  assign select_376 = equal_362_s3_q ? and_374 : (averager_of_skin_q & and_374);
  // hls/stages/agreement.hpp:455
  logic not_533;
  assign not_533 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_534;
  assign less_534 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:463
  logic [7:0] select_772;
  assign select_772 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_708_s3_q : sum_600_s3_q) : (best_2_s3_q[0] ? sum_653_s3_q : sum_765_s3_q);
  logic less_826;
  assign less_826 = select_772 < sum_825_s3_q;
  logic [1:0] select_827;
  assign select_827 = less_826 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:465
  logic [7:0] select_830;
  assign select_830 = select_827[1] ? (select_827[0] ? sum_708_s3_q : sum_600_s3_q) : (select_827[0] ? sum_653_s3_q : sum_765_s3_q);
  logic [7:0] of_best;
  assign of_best = less_826 ? sum_825_s3_q : select_830;
  logic [7:0] of_best_2;
  assign of_best_2 = (not_533 & (~less_534)) ? of_best : 8'h0;
  // hls/stages/agreement.hpp:467
  logic less_833;
  assign less_833 = $signed(run_shift_s3_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:470
  logic less_834;
  assign less_834 = best_left_rdata_s3_q[7:0] < of_best_2;
  logic or_836;
  assign or_836 = less_834 | equal_835_s3_q;
  // hls/stages/agreement.hpp:473
  logic [7:0] select_839;
  assign select_839 = less_833 ? (or_836 ? of_best_2 : best_left_rdata_s3_q[7:0]) : (less_834 ? of_best_2 : best_left_rdata_s3_q[7:0]);
  logic [5:0] select_843;
  assign select_843 = less_833 ? (or_836 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]) : (less_834 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]);
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_826, select_827} == 3'h4) ? 3'h3 : (({less_826, select_827} == 3'h0) ? 3'h1 : {less_826, select_827});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_850;
  assign sum_850 = near_best + 3'h1;
  logic [7:0] select_853;
  assign select_853 = sum_850[1] ? (sum_850[0] ? sum_708_s3_q : sum_600_s3_q) : (sum_850[0] ? sum_653_s3_q : sum_765_s3_q);
  logic [7:0] below;
  assign below = sum_850[2] ? sum_825_s3_q : select_853;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_855;
  assign sum_855 = near_best + 3'h7;
  logic [7:0] select_858;
  assign select_858 = sum_855[1] ? (sum_855[0] ? sum_708_s3_q : sum_600_s3_q) : (sum_855[0] ? sum_653_s3_q : sum_765_s3_q);
  logic [7:0] above;
  assign above = sum_855[2] ? sum_825_s3_q : select_858;
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/registration.hpp:26
  logic [7:0] select_864;
  assign select_864 = near_best[1] ? (near_best[0] ? sum_708_s3_q : sum_600_s3_q) : (near_best[0] ? sum_653_s3_q : sum_765_s3_q);
  logic [7:0] select_865;
  assign select_865 = near_best[2] ? sum_825_s3_q : select_864;
  logic [7:0] select_866;
  assign select_866 = rise[8] ? below : above;
  logic [8:0] fall;
  assign fall = {1'b0, select_865} - {1'b0, select_866};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [7:0] xor_869;
  assign xor_869 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_869};
  // hls/stages/agreement.hpp:477
  logic less_898;
  assign less_898 = best_right_rdata_s3_q[7:0] < of_best_2;
  logic or_900;
  assign or_900 = less_898 | equal_899_s3_q;
  // hls/stages/agreement.hpp:478
  logic [7:0] select_903;
  assign select_903 = less_833 ? (or_900 ? of_best_2 : best_right_rdata_s3_q[7:0]) : (less_898 ? of_best_2 : best_right_rdata_s3_q[7:0]);
  logic [7:0] select_904;
  assign select_904 = equal_531_s3_q ? of_best_2 : select_903;
  logic [6:0] select_907;
  assign select_907 = less_833 ? (or_900 ? x_s3_2_q : best_right_rdata_s3_q[14:8]) : (less_898 ? x_s3_2_q : best_right_rdata_s3_q[14:8]);
  logic [6:0] select_908;
  assign select_908 = equal_531_s3_q ? x_s3_2_q : select_907;
  // hls/stages/agreement.hpp:181
  logic [13:0] select_942;
  assign select_942 = less_385_s3_q ? 14'h0 : {sum_894_s3_q, best_left_rdata_s3_q[21:14]};
  logic [13:0] select_943;
  assign select_943 = or_380_s3_q ? select_942 : 14'h0;
  // hls/stages/agreement.hpp:339
  logic and_946;
  assign and_946 = not_945_s3_q & select_938_s3_q[5];
  // hls/stages/agreement.hpp:186
  logic shown;
  assign shown = select_938_s3_q[0] & (shown_right_rdata_q[0] | select_938_s3_q[4]);
  logic near;
  assign near = select_938_s3_q[0] & (select_938_s3_q[4] ? select_938_s3_q[5] : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:204
  logic select_1160;
  assign select_1160 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_1162;
  assign select_1162 = sample_pair_whole_s3_q ? (and_357_s3_q ? select_372 : averager_mask_q) : averager_mask_q;
  logic select_1164;
  assign select_1164 = sample_pair_whole_s3_q ? (and_357_s3_q ? select_376 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/registration.hpp:151
  logic [7:0] slope;
  assign slope = less_1598_s3_q ? 8'h7f : (less_1599_s3_q ? 8'h80 : sum_1597_s3_q);
  logic [6:0] select_1602;
  assign select_1602 = select_938_s3_q[6] ? slope[7:1] : 7'h0;
  logic [7:0] select_1603;
  assign select_1603 = select_938_s3_q[7] ? slope : 8'h0;
  logic [8:0] sum_1604;
  assign sum_1604 = {{2{select_1602[6]}}, select_1602} + {select_1603[7], select_1603};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1605;
  assign select_1605 = select_938_s3_q[8] ? slope : 8'h0;
  logic [7:0] select_1606;
  assign select_1606 = select_938_s3_q[9] ? slope : 8'h0;
  logic [8:0] sum_1607;
  assign sum_1607 = {{2{select_1605[7]}}, select_1605[7:1]} + {select_1606[7], select_1606};
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1608;
  assign sum_1608 = {{3{sum_1604[8]}}, sum_1604[8:1]} + {sum_1607[8], sum_1607, select_1605[0]};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1609;
  assign select_1609 = select_938_s3_q[10] ? slope : 8'h0;
  logic [7:0] select_1610;
  assign select_1610 = select_938_s3_q[11] ? slope : 8'h0;
  logic [8:0] difference_1611;
  assign difference_1611 = {{2{select_1609[7]}}, select_1609[7:1]} - {select_1610[7], select_1610};
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1612;
  assign sum_1612 = {difference_1611, select_1609[0]} + {sum_1608[10], sum_1608[10:2]};
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1613;
  assign difference_1613 = {{4{select_943[7]}}, select_943[7:0]} - {sum_1612[9], sum_1612, sum_1608[1]};
  // hls/stages/registration.hpp:158
  logic [11:0] select_1615;
  assign select_1615 = ($signed(difference_1613[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1613;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1615[11:7])) ? 12'h7f : select_1615;
  // hls/stages/registration.hpp:146
  logic [12:0] difference_1699;
  assign difference_1699 = 13'h0 - {residual[11], residual};
  logic less_1783;
  assign less_1783 = $signed(difference_1699) < $signed({7'h0, cfg_moved_half_limit_i});

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:254; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = column_s3_q;
  logic census_memory_re;
  assign census_memory_re = s3_en & and_359_s3_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:907; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s3_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s3_en & and_940_s3_q;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_326_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_334_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_353, and_349, sum_345, sum_341};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 8'd189) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 8'd189) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory best_right, write
  logic [5:0] best_right_waddr;
  assign best_right_waddr = partner_s3_q;
  logic best_right_we;
  assign best_right_we = s3_en & and_893_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_908, select_904};
  end
`ifndef SYNTHESIS
  logic [5:0] best_right_raddr_s2_sim;
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
      if (best_right_waddr >= 6'd47) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 6'd47) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory shown_right, write
  logic [5:0] shown_right_waddr;
  assign shown_right_waddr = drew_s3_q ? x_s3_q[5:0] : select_943[13:8];
  logic shown_right_we;
  assign shown_right_we = s3_en & and_949_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_946, not_945_s3_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 6'd47) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 6'd47) $error("shown_right: read outside, address %0d", shown_right_raddr);
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
      sample_pair_pixel_0_q <= left_pixel_q;
      sample_pair_pixel_1_q <= pixel_0_s3_q;
      sample_of_skin_q <= mask_s3_q;
      averager_running_of_skin_q <= select_1160;
      averager_mask_q <= select_1162;
      averager_of_skin_q <= select_1164;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
    averager_running_0_q = 12'h0;
    averager_running_1_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      left_pixel_q <= and_1012_s3_q ? left_pixel_q : pixel_0_s3_q;
      averager_running_0_q <= sample_pair_whole_s3_q ? select_337 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_343 : averager_running_1_q;
    end
  end

  logic saturated_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic left_first_s4_q;
  logic sample_pair_whole_s4_q;
  logic [7:0] x_s4_q;
  logic age_s4_q;
  logic lower_half_s4_q;
  logic [5:0] column_s4_q;
  logic and_357_s4_q;
  logic and_359_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_362_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic and_377_s4_q;
  logic drew_s4_q;
  logic equal_418_s4_q;
  logic [5:0] x_s4_2_q;
  logic [7:0] best_left_rdata_s4_q;
  logic equal_531_s4_q;
  logic select_827_s4_q;
  logic less_833_s4_q;
  logic less_834_s4_q;
  logic or_836_s4_q;
  logic [7:0] select_840_s4_q;
  logic [5:0] select_844_s4_q;
  logic equal_849_s4_q;
  logic rise_s4_q;
  logic [1:0] sum_861_s4_q;
  logic [7:0] twice_s4_q;
  logic [8:0] difference_873_s4_q;
  logic and_893_s4_q;
  logic equal_909_s4_q;
  logic not_910_s4_q;
  logic [5:0] select_938_s4_q;
  logic and_940_s4_q;
  logic not_945_s4_q;
  logic equal_965_s4_q;
  logic shown_s4_q;
  logic near_s4_q;
  logic and_1012_s4_q;
  logic and_1102_s4_q;
  logic equal_1247_s4_q;
  logic equal_1299_s4_q;
  logic less_1576_s4_q;
  logic less_1578_s4_q;
  logic [7:0] residual_s4_q;
  logic less_1700_s4_q;
  logic less_1783_s4_q;
  logic less_1851_s4_q;
  logic equal_1994_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      saturated_s4_q <= saturated_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      left_first_s4_q <= left_first_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      x_s4_q <= x_s3_q;
      age_s4_q <= age_s3_q;
      lower_half_s4_q <= lower_half_s3_q;
      column_s4_q <= column_s3_q;
      and_357_s4_q <= and_357_s3_q;
      and_359_s4_q <= and_359_s3_q;
      grey_s4_q <= grey;
      equal_362_s4_q <= equal_362_s3_q;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      and_377_s4_q <= sample_pair_whole_s3_q & select_376;
      drew_s4_q <= drew_s3_q;
      equal_418_s4_q <= equal_418_s3_q;
      x_s4_2_q <= x_s3_2_q[5:0];
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      equal_531_s4_q <= equal_531_s3_q;
      select_827_s4_q <= select_827[0];
      less_833_s4_q <= less_833;
      less_834_s4_q <= less_834;
      or_836_s4_q <= or_836;
      select_840_s4_q <= equal_531_s3_q ? of_best_2 : select_839;
      select_844_s4_q <= equal_531_s3_q ? run_shift_s3_q : select_843;
      equal_849_s4_q <= {less_826, select_827} == near_best;
      rise_s4_q <= rise[8];
      sum_861_s4_q <= {less_826, select_827[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_873_s4_q <= {1'b0, twice} - (({twice, 1'b0} < size) ? {twice, 1'b0} : size);
      and_893_s4_q <= and_893_s3_q;
      equal_909_s4_q <= equal_909_s3_q;
      not_910_s4_q <= not_910_s3_q;
      select_938_s4_q <= select_938_s3_q[5:0];
      and_940_s4_q <= and_940_s3_q;
      not_945_s4_q <= not_945_s3_q;
      equal_965_s4_q <= equal_965_s3_q;
      shown_s4_q <= shown;
      near_s4_q <= near;
      and_1012_s4_q <= and_1012_s3_q;
      and_1102_s4_q <= and_1102_s3_q;
      equal_1247_s4_q <= equal_1247_s3_q;
      equal_1299_s4_q <= equal_1299_s3_q;
      less_1576_s4_q <= less_1576_s3_q;
      less_1578_s4_q <= less_1578_s3_q;
      residual_s4_q <= residual[7:0];
      less_1700_s4_q <= $signed(difference_1699) < $signed({7'h0, cfg_moved_limit_i});
      less_1783_s4_q <= less_1783;
      less_1851_s4_q <= less_1851_s3_q;
      equal_1994_s4_q <= equal_1994_s3_q;
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
  logic [6:0] region_across_back_q;
  logic [7:0] columns_begin_rest_q;
  logic [6:0] columns_begin_back_q;
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
  logic [10:0] map_row_q;
  logic [5:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic said_q;
  logic [9:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  logic began_q;
  logic [2:0] seen_x_q;
  logic [2:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [10:0] seen_base_q;
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey_s4_q} + (equal_362_s4_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:204
  logic [8:0] select_365;
  assign select_365 = sample_pair_whole_s4_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s4_q} + (equal_362_s4_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:204
  logic [8:0] select_369;
  assign select_369 = sample_pair_whole_s4_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:214
  logic less_391;
  assign less_391 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_392;
  assign less_392 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_393;
  assign less_393 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_394;
  assign less_394 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_395;
  assign less_395 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_396;
  assign less_396 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_397;
  assign less_397 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_398;
  assign less_398 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_399;
  assign less_399 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_400;
  assign less_400 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_401;
  assign less_401 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_402;
  assign less_402 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_403;
  assign less_403 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_404;
  assign less_404 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_405;
  assign less_405 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_406;
  assign less_406 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_407;
  assign less_407 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_408;
  assign less_408 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_409;
  assign less_409 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_410;
  assign less_410 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_411;
  assign less_411 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_412;
  assign less_412 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_413;
  assign less_413 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_414;
  assign less_414 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:281
  logic equal_415;
  assign equal_415 = column_s4_q == 6'h0;
  logic [3:0] select_419;
  assign select_419 = equal_418_s4_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:282
  logic [4:0] select_420;
  assign select_420 = equal_415 ? {select_419, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_421;
  assign select_421 = equal_415 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:219
  logic and_422;
  assign and_422 = select_420[4] & select_421[3];
  // hls/stages/census.hpp:206
  logic and_424;
  assign and_424 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s4_q);
  logic and_426;
  assign and_426 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_424);
  // hls/stages/agreement.hpp:282
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_426;
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
  logic [9:0] difference_449;
  assign difference_449 = {1'b0, select_365} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_450;
  assign xor_450 = difference_449[8:0] ^ {9{difference_449[9]}};
  logic [9:0] sum_451;
  assign sum_451 = {9'h0, difference_449[9]} + {1'b0, xor_450};
  logic [9:0] difference_452;
  assign difference_452 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_453;
  assign xor_453 = difference_452[8:0] ^ {9{difference_452[9]}};
  logic [9:0] sum_454;
  assign sum_454 = {9'h0, difference_452[9]} + {1'b0, xor_453};
  logic [9:0] difference_456;
  assign difference_456 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_457;
  assign xor_457 = difference_456[8:0] ^ {9{difference_456[9]}};
  logic [9:0] sum_458;
  assign sum_458 = {9'h0, difference_456[9]} + {1'b0, xor_457};
  logic [10:0] sum_459;
  assign sum_459 = ({1'b0, sum_451} + {1'b0, sum_454}) + {1'b0, sum_458};
  logic [9:0] difference_460;
  assign difference_460 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_461;
  assign xor_461 = difference_460[8:0] ^ {9{difference_460[9]}};
  logic [9:0] sum_462;
  assign sum_462 = {9'h0, difference_460[9]} + {1'b0, xor_461};
  logic [9:0] difference_464;
  assign difference_464 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_465;
  assign xor_465 = difference_464[8:0] ^ {9{difference_464[9]}};
  logic [9:0] sum_466;
  assign sum_466 = {9'h0, difference_464[9]} + {1'b0, xor_465};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_459} + {2'h0, sum_462}) + {2'h0, sum_466};
  // hls/stages/registration.hpp:28
  logic not_874;
  assign not_874 = ~difference_873_s4_q[8];
  logic [7:0] xor_875;
  assign xor_875 = twice_s4_q ^ {8{not_874}};
  logic [9:0] sum_876;
  assign sum_876 = {difference_873_s4_q[7:0], 1'b0, not_874} + {not_874, xor_875, not_874};
  logic not_877;
  assign not_877 = ~sum_876[9];
  logic [7:0] xor_878;
  assign xor_878 = twice_s4_q ^ {8{not_877}};
  logic [9:0] sum_879;
  assign sum_879 = {sum_876[8:0], not_877} + {not_877, xor_878, not_877};
  logic not_880;
  assign not_880 = ~sum_879[9];
  logic [7:0] xor_881;
  assign xor_881 = twice_s4_q ^ {8{not_880}};
  logic [9:0] sum_882;
  assign sum_882 = {sum_879[8:0], not_880} + {not_880, xor_881, not_880};
  logic not_883;
  assign not_883 = ~sum_882[9];
  logic [7:0] xor_884;
  assign xor_884 = twice_s4_q ^ {8{not_883}};
  logic [9:0] sum_885;
  assign sum_885 = {sum_882[8:0], not_883} + {not_883, xor_884, not_883};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_886;
  assign difference_886 = {sum_861_s4_q, select_827_s4_q, 5'h0} - {3'h0, difference_873_s4_q[8], sum_876[9], sum_879[9], sum_882[9], sum_885[9]};
  // hls/stages/agreement.hpp:471
  logic [7:0] select_887;
  assign select_887 = rise_s4_q ? difference_886 : {sum_861_s4_q, select_827_s4_q, difference_873_s4_q[8], sum_876[9], sum_879[9], sum_882[9], sum_885[9]};
  logic [7:0] select_888;
  assign select_888 = equal_849_s4_q ? select_887 : {sum_861_s4_q, select_827_s4_q, 5'h0};
  // hls/stages/agreement.hpp:473
  logic [7:0] select_891;
  assign select_891 = less_833_s4_q ? (or_836_s4_q ? select_888 : best_left_rdata_s4_q) : (less_834_s4_q ? select_888 : best_left_rdata_s4_q);
  logic [7:0] select_892;
  assign select_892 = equal_531_s4_q ? select_888 : select_891;
  // hls/stages/agreement.hpp:147
  logic [7:0] select_950;
  assign select_950 = drew_s4_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:628
  logic or_953;
  assign or_953 = select_950[7] | (~({select_950[5], select_950[3], select_950[1]} == 3'h0));
  // hls/stages/agreement.hpp:627
  logic or_956;
  assign or_956 = select_950[7] | (~({select_950[6], select_950[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:626
  logic or_959;
  assign or_959 = select_950[7] | (~(select_950[6:4] == 3'h0));
  // hls/stages/agreement.hpp:339
  logic [5:0] select_960;
  assign select_960 = equal_909_s4_q ? x_s4_q[5:0] : {region_row_q, or_959, or_956, or_953};
  // hls/stages/agreement.hpp:709
  logic equal_961;
  assign equal_961 = x_s4_q[5:4] == 2'h3;
  logic not_962;
  assign not_962 = ~equal_961;
  // hls/stages/division.hpp:18
  logic [5:0] sum_963;
  assign sum_963 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:636
  logic or_966;
  assign or_966 = (~sum_963[5]) | equal_965_s4_q;
  // hls/stages/agreement.hpp:339
  logic and_968;
  assign and_968 = drew_s4_q & (select_938_s4_q[0] & or_966);
  // hls/stages/agreement.hpp:186
  logic textured;
  assign textured = select_938_s4_q[0] & select_938_s4_q[2];
  logic explained;
  assign explained = select_938_s4_q[0] & select_938_s4_q[4];
  logic and_982;
  assign and_982 = select_938_s4_q[0] & ({select_938_s4_q[5], select_938_s4_q[3]} == 2'h3);
  logic and_989;
  assign and_989 = select_938_s4_q[0] & select_938_s4_q[3];
  // hls/stages/agreement.hpp:798
  logic select_994;
  assign select_994 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:802
  logic select_995;
  assign select_995 = left_first_s4_q ? select_994 : read_half_q;
  logic or_996;
  assign or_996 = left_first_s4_q | line_ended_q;
  // hls/stages/agreement.hpp:803
  logic [8:0] select_997;
  assign select_997 = or_996 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:804
  logic [9:0] select_999;
  assign select_999 = left_first_s4_q ? 10'h1 : (or_996 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:807
  logic and_1000;
  assign and_1000 = select_997[8] & select_999[9];
  // hls/stages/agreement.hpp:206
  logic next_row;
  assign next_row = and_1000 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:818
  logic [5:0] select_1003;
  assign select_1003 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1005;
  assign select_1005 = left_first_s4_q ? 11'h0 : (seen_base_q + {5'h0, select_1003});
  // hls/stages/agreement.hpp:828
  logic equal_1006;
  assign equal_1006 = seen_x_q == 3'h7;
  logic [7:0] select_1008;
  assign select_1008 = and_1000 ? 8'h0 : (seen_column_q + {7'h0, equal_1006});
  // hls/stages/agreement.hpp:831
  logic [10:0] index;
  assign index = select_1005 + {3'h0, select_1008};
  // hls/stages/agreement.hpp:788
  logic [11:0] sum_1010;
  assign sum_1010 = {1'b0, {2{select_995}}, 2'h0, {2{select_995}}, 1'b0, {2{select_995}}, 1'b0, select_995} + {1'b0, index};
  // hls/stages/agreement.hpp:801
  logic not_1013;
  assign not_1013 = ~left_first_s4_q;
  // hls/stages/agreement.hpp:206
  logic and_1015;
  assign and_1015 = not_1013 & (began_q | and_1000);
  // hls/stages/agreement.hpp:829
  logic [2:0] select_1017;
  assign select_1017 = and_1000 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:830
  logic and_1019;
  assign and_1019 = and_1015 & (select_1017 == 3'h0);
  logic less_1020;
  assign less_1020 = select_1008 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:208
  logic and_1021;
  assign and_1021 = and_1019 & less_1020;
  logic and_1022;
  assign and_1022 = and_1012_s4_q & and_1021;
  logic select_1024;
  assign select_1024 = and_1012_s4_q ? (left_first_s4_q ? and_1021 : and_1022) : and_1022;
  // hls/stages/agreement.hpp:692
  logic [7:0] sum_1026;
  assign sum_1026 = {2'h0, x_s4_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1026[7], sum_1026, x_s4_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:788
  logic [11:0] sum_1028;
  assign sum_1028 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:606
  logic and_1029;
  assign and_1029 = seen_columns_rdata_q[14] & select_938_s4_q[0];
  logic and_1030;
  assign and_1030 = seen_columns_rdata_q[10] & select_938_s4_q[0];
  logic and_1031;
  assign and_1031 = seen_columns_rdata_q[5] & select_938_s4_q[0];
  logic and_1032;
  assign and_1032 = seen_columns_rdata_q[0] & select_938_s4_q[0];
  // hls/stages/agreement.hpp:665
  logic [1:0] sum_1034;
  assign sum_1034 = {1'b0, and_1031} + ({1'b0, textured} + {1'b0, and_1032});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1029} + ({2'h0, and_1030} + {1'b0, sum_1034});
  // hls/stages/agreement.hpp:672
  logic [4:0] difference_1038;
  assign difference_1038 = {2'h0, textured_2} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:670
  logic equal_1039;
  assign equal_1039 = x_s4_q == 8'h0;
  // hls/stages/agreement.hpp:672
  logic [4:0] t;
  assign t = difference_1038 + (equal_1039 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:606
  logic [7:0] select_1044;
  assign select_1044 = select_938_s4_q[0] ? (sum_963[5] ? select_950 : {select_950[6:0], 1'b0}) : select_950;
  // hls/stages/agreement.hpp:628
  logic or_1047;
  assign or_1047 = select_1044[7] | (~({select_1044[5], select_1044[3], select_1044[1]} == 3'h0));
  // hls/stages/agreement.hpp:606
  logic and_1063;
  assign and_1063 = seen_columns_rdata_q[16] & select_938_s4_q[0];
  logic and_1064;
  assign and_1064 = seen_columns_rdata_q[12] & select_938_s4_q[0];
  logic and_1065;
  assign and_1065 = seen_columns_rdata_q[8] & select_938_s4_q[0];
  logic and_1066;
  assign and_1066 = seen_columns_rdata_q[3] & select_938_s4_q[0];
  // hls/stages/agreement.hpp:667
  logic [1:0] sum_1068;
  assign sum_1068 = {1'b0, and_1065} + ({1'b0, shown_s4_q} + {1'b0, and_1066});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1063} + ({2'h0, and_1064} + {1'b0, sum_1068});
  // hls/stages/agreement.hpp:674
  logic [4:0] difference_1072;
  assign difference_1072 = {2'h0, shown_2} - (age_s4_q ? box_shown_columns_values_4_q : 5'h0);
  logic [4:0] around;
  assign around = difference_1072 + (equal_1039 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:681
  logic [5:0] sum_1075;
  assign sum_1075 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:606
  logic and_1079;
  assign and_1079 = seen_columns_rdata_q[17] & select_938_s4_q[0];
  logic and_1080;
  assign and_1080 = seen_columns_rdata_q[13] & select_938_s4_q[0];
  logic and_1081;
  assign and_1081 = seen_columns_rdata_q[9] & select_938_s4_q[0];
  logic and_1082;
  assign and_1082 = seen_columns_rdata_q[4] & select_938_s4_q[0];
  // hls/stages/agreement.hpp:668
  logic [1:0] sum_1084;
  assign sum_1084 = {1'b0, and_1081} + ({1'b0, near_s4_q} + {1'b0, and_1082});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1079} + ({2'h0, and_1080} + {1'b0, sum_1084});
  // hls/stages/agreement.hpp:675
  logic [4:0] difference_1088;
  assign difference_1088 = {2'h0, near_2} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1088 + (equal_1039 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:204
  logic [10:0] select_1139;
  assign select_1139 = sample_pair_whole_s4_q ? (and_357_s4_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1141;
  assign select_1141 = sample_pair_whole_s4_q ? (and_357_s4_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1165;
  assign select_1165 = and_359_s4_q ? select_365 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1166;
  assign select_1166 = and_359_s4_q ? select_369 : census_columns_values_0_cell_0_right_q;
  logic select_1167;
  assign select_1167 = and_359_s4_q ? whole_2_s4_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_1168;
  assign select_1168 = and_359_s4_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1169;
  assign select_1169 = and_359_s4_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1170;
  assign select_1170 = and_359_s4_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1171;
  assign select_1171 = and_359_s4_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1172;
  assign select_1172 = and_359_s4_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1173;
  assign select_1173 = and_359_s4_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1174;
  assign select_1174 = and_359_s4_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1175;
  assign select_1175 = and_359_s4_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1176;
  assign select_1176 = and_359_s4_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1177;
  assign select_1177 = and_359_s4_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1178;
  assign select_1178 = and_359_s4_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1179;
  assign select_1179 = and_359_s4_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1180;
  assign select_1180 = and_359_s4_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1181;
  assign select_1181 = and_359_s4_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1182;
  assign select_1182 = and_359_s4_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1183;
  assign select_1183 = and_359_s4_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1184;
  assign select_1184 = and_359_s4_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1185;
  assign select_1185 = and_359_s4_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1186;
  assign select_1186 = and_359_s4_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1187;
  assign select_1187 = and_359_s4_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1188;
  assign select_1188 = and_359_s4_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1189;
  assign select_1189 = and_359_s4_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1190;
  assign select_1190 = and_359_s4_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1191;
  assign select_1191 = and_359_s4_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1192;
  assign select_1192 = and_359_s4_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1193;
  assign select_1193 = and_359_s4_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1194;
  assign select_1194 = and_359_s4_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1195;
  assign select_1195 = and_359_s4_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1196;
  assign select_1196 = and_359_s4_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1197;
  assign select_1197 = and_359_s4_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1198;
  assign select_1198 = and_359_s4_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1199;
  assign select_1199 = and_359_s4_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1200;
  assign select_1200 = and_359_s4_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1201;
  assign select_1201 = and_359_s4_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1202;
  assign select_1202 = and_359_s4_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1203;
  assign select_1203 = and_359_s4_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1204;
  assign select_1204 = and_359_s4_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1205;
  assign select_1205 = and_359_s4_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1206;
  assign select_1206 = and_359_s4_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1207;
  assign select_1207 = and_359_s4_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1208;
  assign select_1208 = and_359_s4_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1209;
  assign select_1209 = and_359_s4_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1210;
  assign select_1210 = and_359_s4_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1211;
  assign select_1211 = and_359_s4_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1212;
  assign select_1212 = and_359_s4_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1213;
  assign select_1213 = and_359_s4_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1214;
  assign select_1214 = and_359_s4_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1215;
  assign select_1215 = and_359_s4_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1216;
  assign select_1216 = and_359_s4_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1217;
  assign select_1217 = and_359_s4_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1218;
  assign select_1218 = and_359_s4_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1219;
  assign select_1219 = and_359_s4_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1220;
  assign select_1220 = and_359_s4_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1222;
  assign difference_1222 = {1'b0, select_369} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1223;
  assign xor_1223 = difference_1222[8:0] ^ {9{difference_1222[9]}};
  logic [9:0] sum_1224;
  assign sum_1224 = {9'h0, difference_1222[9]} + {1'b0, xor_1223};
  logic [9:0] difference_1225;
  assign difference_1225 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1226;
  assign xor_1226 = difference_1225[8:0] ^ {9{difference_1225[9]}};
  logic [9:0] sum_1227;
  assign sum_1227 = {9'h0, difference_1225[9]} + {1'b0, xor_1226};
  logic [9:0] difference_1229;
  assign difference_1229 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1230;
  assign xor_1230 = difference_1229[8:0] ^ {9{difference_1229[9]}};
  logic [9:0] sum_1231;
  assign sum_1231 = {9'h0, difference_1229[9]} + {1'b0, xor_1230};
  logic [10:0] sum_1232;
  assign sum_1232 = ({1'b0, sum_1224} + {1'b0, sum_1227}) + {1'b0, sum_1231};
  logic [9:0] difference_1233;
  assign difference_1233 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1234;
  assign xor_1234 = difference_1233[8:0] ^ {9{difference_1233[9]}};
  logic [9:0] sum_1235;
  assign sum_1235 = {9'h0, difference_1233[9]} + {1'b0, xor_1234};
  logic [9:0] difference_1237;
  assign difference_1237 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1238;
  assign xor_1238 = difference_1237[8:0] ^ {9{difference_1237[9]}};
  logic [9:0] sum_1239;
  assign sum_1239 = {9'h0, difference_1237[9]} + {1'b0, xor_1238};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1267;
  assign difference_1267 = {1'b0, select_365} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1267[9]} + (difference_1267[8:0] ^ {9{difference_1267[9]}});
  logic [9:0] difference_1278;
  assign difference_1278 = {1'b0, select_369} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1278[9]} + (difference_1278[8:0] ^ {9{difference_1278[9]}});
  // hls/stages/agreement.hpp:205
  logic and_1478;
  assign and_1478 = and_359_s4_q & (equal_418_s4_q & equal_1299_s4_q);
  // hls/stages/agreement.hpp:339
  logic and_1481;
  assign and_1481 = not_910_s4_q & (drew_s4_q & (select_938_s4_q[0] & select_938_s4_q[1]));
  // hls/stages/agreement.hpp:606
  logic and_1498;
  assign and_1498 = seen_columns_rdata_q[15] & select_938_s4_q[0];
  logic and_1499;
  assign and_1499 = seen_columns_rdata_q[11] & select_938_s4_q[0];
  logic and_1500;
  assign and_1500 = seen_columns_rdata_q[7] & select_938_s4_q[0];
  logic and_1501;
  assign and_1501 = seen_columns_rdata_q[2] & select_938_s4_q[0];
  // hls/stages/agreement.hpp:666
  logic [1:0] sum_1503;
  assign sum_1503 = {1'b0, and_1500} + ({1'b0, explained} + {1'b0, and_1501});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_1498} + ({2'h0, and_1499} + {1'b0, sum_1503});
  // hls/stages/agreement.hpp:673
  logic [4:0] difference_1507;
  assign difference_1507 = {2'h0, explained_2} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_1507 + (equal_1039 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:680
  logic [5:0] sum_1510;
  assign sum_1510 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:600
  logic [9:0] select_1570;
  assign select_1570 = ({select_938_s4_q[3], select_938_s4_q[1]} == 2'h3) ? ({1'b0, select_938_s4_q[5], 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:339
  logic [9:0] select_1573;
  assign select_1573 = equal_909_s4_q ? 10'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1570 : 10'h0) : 10'h0);
  // hls/stages/agreement.hpp:533
  logic [23:0] select_1575;
  assign select_1575 = and_1478 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1573[9]}}, select_1573});
  // hls/stages/registration.hpp:73
  logic equal_1579;
  assign equal_1579 = {lower_half_s4_q, less_1578_s4_q} == 2'h3;
  logic equal_1580;
  assign equal_1580 = {lower_half_s4_q, less_1578_s4_q} == 2'h2;
  logic equal_1581;
  assign equal_1581 = {lower_half_s4_q, less_1578_s4_q} == 2'h1;
  logic not_1655;
  assign not_1655 = ~equal_1579;
  logic not_1656;
  assign not_1656 = ~equal_1580;
  // hls/stages/agreement.hpp:186
  logic and_1661;
  assign and_1661 = select_938_s4_q[4] & (less_1576_s4_q & (not_1655 & (not_1656 & (~equal_1581))));
  // hls/stages/agreement.hpp:339
  logic and_1664;
  assign and_1664 = not_910_s4_q & (drew_s4_q & (select_938_s4_q[0] & and_1661));
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1666;
  assign select_1666 = and_1478 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1664});
  // hls/stages/agreement.hpp:186
  logic and_1670;
  assign and_1670 = select_938_s4_q[4] & (less_1576_s4_q & (not_1655 & (equal_1581 & not_1656)));
  // hls/stages/agreement.hpp:339
  logic and_1673;
  assign and_1673 = not_910_s4_q & (drew_s4_q & (select_938_s4_q[0] & and_1670));
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1675;
  assign select_1675 = and_1478 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1673});
  // hls/stages/agreement.hpp:186
  logic and_1679;
  assign and_1679 = select_938_s4_q[0] & (select_938_s4_q[4] & (less_1576_s4_q & (equal_1580 & not_1655)));
  // hls/stages/agreement.hpp:339
  logic and_1681;
  assign and_1681 = not_910_s4_q & (drew_s4_q & and_1679);
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1683;
  assign select_1683 = and_1478 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1681});
  // hls/stages/agreement.hpp:186
  logic and_1686;
  assign and_1686 = select_938_s4_q[0] & (select_938_s4_q[4] & (less_1576_s4_q & equal_1579));
  // hls/stages/agreement.hpp:339
  logic and_1688;
  assign and_1688 = not_910_s4_q & (drew_s4_q & and_1686);
  // hls/stages/agreement.hpp:534
  logic [11:0] select_1690;
  assign select_1690 = and_1478 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1688});
  // hls/stages/registration.hpp:146
  logic less_1691;
  assign less_1691 = $signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:186
  logic and_1692;
  assign and_1692 = less_1576_s4_q & less_1691;
  logic [1:0] select_1694;
  assign select_1694 = select_938_s4_q[0] ? (select_938_s4_q[4] ? {and_1692, less_1576_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1696;
  assign select_1696 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? select_1694 : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1697;
  assign sum_1697 = registration_counts_votes_0_down_q + {{13{select_1696[1]}}, select_1696};
  // hls/stages/agreement.hpp:186
  logic and_1701;
  assign and_1701 = less_1576_s4_q & less_1700_s4_q;
  logic [1:0] select_1703;
  assign select_1703 = select_938_s4_q[0] ? (select_938_s4_q[4] ? {and_1701, less_1576_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1705;
  assign select_1705 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? select_1703 : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1706;
  assign sum_1706 = registration_counts_votes_0_up_q + {{13{select_1705[1]}}, select_1705};
  // hls/stages/registration.hpp:80
  logic not_1708;
  assign not_1708 = ~less_1578_s4_q;
  // hls/stages/registration.hpp:79
  logic and_1709;
  assign and_1709 = less_1691 & not_1708;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1711;
  assign select_1711 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1709, not_1708} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1714;
  assign select_1714 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1711 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1715;
  assign sum_1715 = registration_counts_votes_1_down_q + {{13{select_1714[1]}}, select_1714};
  // hls/stages/registration.hpp:79
  logic and_1717;
  assign and_1717 = less_1700_s4_q & not_1708;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1719;
  assign select_1719 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1717, not_1708} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1722;
  assign select_1722 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1719 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1723;
  assign sum_1723 = registration_counts_votes_1_up_q + {{13{select_1722[1]}}, select_1722};
  // hls/stages/registration.hpp:79
  logic and_1725;
  assign and_1725 = less_1578_s4_q & less_1691;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1727;
  assign select_1727 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1725, less_1578_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1730;
  assign select_1730 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1727 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1731;
  assign sum_1731 = registration_counts_votes_2_down_q + {{13{select_1730[1]}}, select_1730};
  // hls/stages/registration.hpp:79
  logic and_1733;
  assign and_1733 = less_1578_s4_q & less_1700_s4_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1735;
  assign select_1735 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1733, less_1578_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1738;
  assign select_1738 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1735 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1739;
  assign sum_1739 = registration_counts_votes_2_up_q + {{13{select_1738[1]}}, select_1738};
  // hls/stages/registration.hpp:80
  logic not_1741;
  assign not_1741 = ~lower_half_s4_q;
  // hls/stages/agreement.hpp:186
  logic and_1742;
  assign and_1742 = less_1691 & not_1741;
  logic [1:0] select_1744;
  assign select_1744 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1742, not_1741} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1747;
  assign select_1747 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1744 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1748;
  assign sum_1748 = registration_counts_votes_3_down_q + {{13{select_1747[1]}}, select_1747};
  // hls/stages/agreement.hpp:186
  logic and_1750;
  assign and_1750 = less_1700_s4_q & not_1741;
  logic [1:0] select_1752;
  assign select_1752 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1750, not_1741} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1755;
  assign select_1755 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1752 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1756;
  assign sum_1756 = registration_counts_votes_3_up_q + {{13{select_1755[1]}}, select_1755};
  // hls/stages/agreement.hpp:186
  logic and_1758;
  assign and_1758 = lower_half_s4_q & less_1691;
  logic [1:0] select_1760;
  assign select_1760 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1758, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1763;
  assign select_1763 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1760 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1764;
  assign sum_1764 = registration_counts_votes_4_down_q + {{13{select_1763[1]}}, select_1763};
  // hls/stages/agreement.hpp:186
  logic and_1766;
  assign and_1766 = lower_half_s4_q & less_1700_s4_q;
  logic [1:0] select_1768;
  assign select_1768 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1766, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1771;
  assign select_1771 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1768 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1772;
  assign sum_1772 = registration_counts_votes_4_up_q + {{13{select_1771[1]}}, select_1771};
  // hls/stages/registration.hpp:146
  logic less_1774;
  assign less_1774 = $signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1775;
  assign and_1775 = not_1708 & less_1774;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1777;
  assign select_1777 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1775, not_1708} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1780;
  assign select_1780 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1777 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1781;
  assign sum_1781 = registration_counts_half_votes_0_down_q + {{13{select_1780[1]}}, select_1780};
  // hls/stages/registration.hpp:79
  logic and_1784;
  assign and_1784 = not_1708 & less_1783_s4_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1786;
  assign select_1786 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1784, not_1708} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1789;
  assign select_1789 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1786 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1790;
  assign sum_1790 = registration_counts_half_votes_0_up_q + {{13{select_1789[1]}}, select_1789};
  // hls/stages/registration.hpp:79
  logic and_1792;
  assign and_1792 = less_1578_s4_q & less_1774;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1794;
  assign select_1794 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1792, less_1578_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1797;
  assign select_1797 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1794 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1798;
  assign sum_1798 = registration_counts_half_votes_1_down_q + {{13{select_1797[1]}}, select_1797};
  // hls/stages/registration.hpp:79
  logic and_1800;
  assign and_1800 = less_1578_s4_q & less_1783_s4_q;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1802;
  assign select_1802 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1800, less_1578_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1805;
  assign select_1805 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1802 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1806;
  assign sum_1806 = registration_counts_half_votes_1_up_q + {{13{select_1805[1]}}, select_1805};
  // hls/stages/agreement.hpp:186
  logic and_1808;
  assign and_1808 = less_1774 & not_1741;
  logic [1:0] select_1810;
  assign select_1810 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1808, not_1741} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1813;
  assign select_1813 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1810 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1814;
  assign sum_1814 = registration_counts_half_votes_2_down_q + {{13{select_1813[1]}}, select_1813};
  // hls/stages/agreement.hpp:186
  logic and_1816;
  assign and_1816 = less_1783_s4_q & not_1741;
  logic [1:0] select_1818;
  assign select_1818 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1816, not_1741} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1821;
  assign select_1821 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1818 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1822;
  assign sum_1822 = registration_counts_half_votes_2_up_q + {{13{select_1821[1]}}, select_1821};
  // hls/stages/agreement.hpp:186
  logic and_1824;
  assign and_1824 = lower_half_s4_q & less_1774;
  logic [1:0] select_1826;
  assign select_1826 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1824, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1829;
  assign select_1829 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1826 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1830;
  assign sum_1830 = registration_counts_half_votes_3_down_q + {{13{select_1829[1]}}, select_1829};
  // hls/stages/agreement.hpp:186
  logic and_1832;
  assign and_1832 = lower_half_s4_q & less_1783_s4_q;
  logic [1:0] select_1834;
  assign select_1834 = select_938_s4_q[4] ? (less_1576_s4_q ? {and_1832, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:339
  logic [1:0] select_1837;
  assign select_1837 = equal_909_s4_q ? 2'h0 : (drew_s4_q ? (select_938_s4_q[0] ? select_1834 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1838;
  assign sum_1838 = registration_counts_half_votes_3_up_q + {{13{select_1837[1]}}, select_1837};
  // hls/stages/division.hpp:34
  logic [7:0] sum_1852;
  assign sum_1852 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:286
  logic [2:0] select_1854;
  assign select_1854 = less_1851_s4_q ? (sum_1852[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1856;
  assign select_1856 = equal_1299_s4_q ? (equal_418_s4_q ? 3'h0 : select_1854) : region_row_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1860;
  assign sum_1860 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1861;
  assign select_1861 = sum_963[5] ? {1'b1, sum_963[4:0], region_across_rest_q[2:0]} : sum_1860;
  // hls/stages/agreement.hpp:147
  logic [8:0] select_1862;
  assign select_1862 = drew_s4_q ? select_1861 : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/agreement.hpp:286
  logic [7:0] select_1865;
  assign select_1865 = equal_1299_s4_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_1868;
  assign select_1868 = equal_1299_s4_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  logic [8:0] select_1872;
  assign select_1872 = equal_418_s4_q ? {{2{difference_1870[6]}}, difference_1870} : (less_1851_s4_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1874;
  assign select_1874 = and_359_s4_q ? (equal_1299_s4_q ? select_1872 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:286
  logic [6:0] select_1876;
  assign select_1876 = equal_418_s4_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1878;
  assign select_1878 = and_359_s4_q ? (equal_1299_s4_q ? select_1876 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1879;
  assign sum_1879 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1880;
  assign select_1880 = sum_1852[7] ? {1'b1, sum_1852[6:0], region_down_rest_q[0]} : sum_1879;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1852[7];
  // hls/stages/agreement.hpp:286
  logic select_1884;
  assign select_1884 = equal_1299_s4_q ? (equal_418_s4_q | (less_1851_s4_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:147
  logic or_1889;
  assign or_1889 = segment_starts_q | not_945_s4_q;
  // hls/stages/agreement.hpp:606
  logic select_1892;
  assign select_1892 = select_938_s4_q[0] ? (sum_963[5] ? (equal_965_s4_q & or_966) : or_966) : or_1889;
  // hls/stages/agreement.hpp:722
  logic equal_1896;
  assign equal_1896 = x_s4_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:724
  logic [7:0] select_1914;
  assign select_1914 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1916;
  assign select_1916 = equal_909_s4_q ? (equal_1896 ? select_1914 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:149
  logic not_1917;
  assign not_1917 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:339
  logic [4:0] select_1938;
  assign select_1938 = equal_909_s4_q ? box_textured_columns_values_0_q : (drew_s4_q ? {2'h0, textured_2} : box_textured_columns_values_0_q);
  logic [4:0] select_1939;
  assign select_1939 = drew_s4_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1941;
  assign select_1941 = drew_s4_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1943;
  assign select_1943 = drew_s4_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1945;
  assign select_1945 = drew_s4_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1948;
  assign select_1948 = equal_909_s4_q ? box_textured_sum_sums_values_0_q : (drew_s4_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1949;
  assign select_1949 = drew_s4_q ? {2'h0, explained_2} : box_explained_columns_values_0_q;
  logic [4:0] select_1951;
  assign select_1951 = drew_s4_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1953;
  assign select_1953 = drew_s4_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1955;
  assign select_1955 = drew_s4_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1957;
  assign select_1957 = drew_s4_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1960;
  assign select_1960 = equal_909_s4_q ? box_explained_sum_sums_values_0_q : (drew_s4_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1962;
  assign select_1962 = equal_909_s4_q ? box_shown_columns_values_0_q : (drew_s4_q ? {2'h0, shown_2} : box_shown_columns_values_0_q);
  logic [4:0] select_1963;
  assign select_1963 = drew_s4_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [4:0] select_1965;
  assign select_1965 = drew_s4_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [4:0] select_1967;
  assign select_1967 = drew_s4_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [4:0] select_1969;
  assign select_1969 = drew_s4_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [4:0] select_1972;
  assign select_1972 = equal_909_s4_q ? box_shown_sum_sums_values_0_q : (drew_s4_q ? around : box_shown_sum_sums_values_0_q);
  logic [4:0] select_1974;
  assign select_1974 = equal_909_s4_q ? box_nearer_columns_values_0_q : (drew_s4_q ? {2'h0, near_2} : box_nearer_columns_values_0_q);
  logic [4:0] select_1975;
  assign select_1975 = drew_s4_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1977;
  assign select_1977 = drew_s4_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1979;
  assign select_1979 = drew_s4_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1981;
  assign select_1981 = drew_s4_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_1984;
  assign select_1984 = equal_909_s4_q ? box_nearer_sum_sums_values_0_q : (drew_s4_q ? n : box_nearer_sum_sums_values_0_q);
  logic select_1986;
  assign select_1986 = equal_909_s4_q ? centres_values_0_textured_q : (drew_s4_q ? and_1031 : centres_values_0_textured_q);
  logic select_1988;
  assign select_1988 = drew_s4_q ? (seen_columns_rdata_q[6] & select_938_s4_q[0]) : centres_values_0_of_skin_q;
  logic select_1990;
  assign select_1990 = drew_s4_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_1992;
  assign select_1992 = drew_s4_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  // hls/stages/agreement.hpp:286
  logic [10:0] select_1997;
  assign select_1997 = equal_1299_s4_q ? (equal_1994_s4_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:205
  logic [5:0] select_2000;
  assign select_2000 = and_359_s4_q ? (equal_1299_s4_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:798
  logic xor_2001;
  assign xor_2001 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:208
  logic select_2003;
  assign select_2003 = and_1012_s4_q ? (left_first_s4_q ? xor_2001 : write_half_q) : write_half_q;
  logic select_2005;
  assign select_2005 = and_1012_s4_q ? (left_first_s4_q ? xor_2001 : select_2003) : write_half_q;
  logic select_2007;
  assign select_2007 = left_first_s4_q ? select_994 : (and_1012_s4_q ? select_995 : read_half_q);
  logic and_2011;
  assign and_2011 = (~begins_product_q) & (done_q | said_q);
  logic [9:0] select_2020;
  assign select_2020 = left_first_s4_q ? 10'h1 : (and_1012_s4_q ? select_999 : rows_passed_q);
  logic [8:0] select_2023;
  assign select_2023 = left_first_s4_q ? {select_997[7:0], or_996} : (and_1012_s4_q ? {select_997[7:0], or_996} : columns_passed_q);
  logic select_2026;
  assign select_2026 = left_first_s4_q ? marks_last_s4_q : (and_1012_s4_q ? marks_last_s4_q : line_ended_q);
  logic select_2029;
  assign select_2029 = left_first_s4_q ? and_1015 : (and_1012_s4_q ? and_1015 : began_q);
  logic [2:0] select_2032;
  assign select_2032 = left_first_s4_q ? select_1017 : (and_1012_s4_q ? select_1017 : seen_x_q);
  // hls/stages/agreement.hpp:827
  logic [2:0] select_2037;
  assign select_2037 = left_first_s4_q ? 3'h0 : (and_1000 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:208
  logic [2:0] select_2039;
  assign select_2039 = left_first_s4_q ? 3'h0 : (and_1012_s4_q ? select_2037 : seen_y_q);
  logic [7:0] select_2042;
  assign select_2042 = left_first_s4_q ? select_1008 : (and_1012_s4_q ? select_1008 : seen_column_q);
  // hls/stages/agreement.hpp:206
  logic [7:0] select_2048;
  assign select_2048 = left_first_s4_q ? select_2046 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:208
  logic [7:0] select_2050;
  assign select_2050 = left_first_s4_q ? select_2046 : (and_1012_s4_q ? select_2048 : seen_rows_left_q);
  // hls/stages/agreement.hpp:206
  logic and_2055;
  assign and_2055 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:208
  logic select_2057;
  assign select_2057 = left_first_s4_q ? and_2055 : (and_1012_s4_q ? and_2055 : at_cell_end_q);
  logic select_2060;
  assign select_2060 = left_first_s4_q ? next_row : (and_1012_s4_q ? next_row : was_next_row_q);
  logic [10:0] select_2063;
  assign select_2063 = left_first_s4_q ? 11'h0 : (and_1012_s4_q ? select_1005 : seen_base_q);
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2117;
  assign sum_2117 = {1'b0, upper} + {1'b0, lower};
  logic less_2118;
  assign less_2118 = 11'h4 < sum_2117[13:3];
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};
  // hls/stages/registration.hpp:100
  logic less_2121;
  assign less_2121 = 11'he < left[12:2];
  // hls/stages/registration.hpp:119
  logic less_2123;
  assign less_2123 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_2124;
  assign or_2124 = (~less_2121) | less_2123;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:100
  logic less_2126;
  assign less_2126 = 11'he < right[12:2];
  // hls/stages/registration.hpp:119
  logic less_2128;
  assign less_2128 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic select_2130;
  assign select_2130 = less_2118 ? (or_2124 ? less_2123 : less_2128) : less_2128;
  logic or_2131;
  assign or_2131 = (~less_2126) | select_2130;
  // hls/stages/registration.hpp:100
  logic less_2132;
  assign less_2132 = 11'he < upper[12:2];
  // hls/stages/registration.hpp:119
  logic less_2134;
  assign less_2134 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/registration.hpp:104
  logic select_2135;
  assign select_2135 = or_2131 ? select_2130 : less_2134;
  logic select_2137;
  assign select_2137 = less_2118 ? select_2135 : (less_2121 ? select_2135 : less_2134);
  logic or_2138;
  assign or_2138 = (~less_2132) | select_2137;
  // hls/stages/registration.hpp:119
  logic less_2139;
  assign less_2139 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_2140;
  assign select_2140 = or_2138 ? select_2137 : less_2139;
  logic select_2143;
  assign select_2143 = less_2118 ? select_2140 : (less_2121 ? select_2140 : (less_2126 ? select_2140 : less_2139));
  // hls/stages/registration.hpp:101
  logic less_2144;
  assign less_2144 = 11'he < lower[12:2];
  // hls/stages/registration.hpp:104
  logic or_2146;
  assign or_2146 = select_2143 | (~less_2144);
  // hls/stages/registration.hpp:119
  logic less_2147;
  assign less_2147 = $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
  // hls/stages/registration.hpp:105
  logic select_2148;
  assign select_2148 = or_2146 ? select_2143 : less_2147;
  logic select_2151;
  assign select_2151 = less_2121 ? select_2148 : (less_2126 ? select_2148 : (less_2132 ? select_2148 : less_2147));
  // hls/stages/agreement.hpp:726
  logic and_2163;
  assign and_2163 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2164;
  assign or_2164 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2163;
  logic select_2165;
  assign select_2165 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2164 : and_2163;
  logic and_2166;
  assign and_2166 = (less_2132 & less_2144) & select_2165;
  logic or_2167;
  assign or_2167 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2166;
  logic select_2168;
  assign select_2168 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2167 : and_2166;
  logic or_2169;
  assign or_2169 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2168;
  logic select_2170;
  assign select_2170 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2169 : select_2168;
  logic select_2171;
  assign select_2171 = (less_2121 & less_2126) ? select_2170 : and_2166;
  logic or_2172;
  assign or_2172 = (less_2118 ? select_2148 : select_2151) | select_2171;
  // hls/stages/registration.hpp:119
  logic less_2173;
  assign less_2173 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  // hls/stages/agreement.hpp:726
  logic or_2174;
  assign or_2174 = less_2173 | or_2172;
  logic select_2175;
  assign select_2175 = or_2146 ? or_2172 : or_2174;
  // hls/stages/registration.hpp:119
  logic less_2176;
  assign less_2176 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2179;
  assign less_2179 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2182;
  assign less_2182 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:726
  logic and_2215;
  assign and_2215 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1914 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:339
  logic [11:0] select_2228;
  assign select_2228 = equal_909_s4_q ? (equal_1896 ? registration_counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2230;
  assign select_2230 = equal_909_s4_q ? (equal_1896 ? registration_counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2232;
  assign select_2232 = equal_909_s4_q ? (equal_1896 ? registration_counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2234;
  assign select_2234 = equal_909_s4_q ? (equal_1896 ? registration_counts_measured_3_q : 12'h0) : 12'h0;

  // Memory regions, 64 x 36, DISTANCE 12, hls/stages/agreement.hpp:892; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_960;
  logic regions_re;
  assign regions_re = s4_en & (equal_909_s4_q ? not_962 : and_968);
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:911; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1010;
  logic map_re;
  assign map_re = s4_en & select_1024;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory census_memory, write
  logic [5:0] census_memory_waddr;
  assign census_memory_waddr = column_s4_q;
  logic census_memory_we;
  assign census_memory_we = s4_en & and_359_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_377_s4_q, whole_2_s4_q, select_369, select_365};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 6'd47) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 6'd47) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s4_2_q;
  logic best_left_we;
  assign best_left_we = s4_en & and_893_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_892, select_844_s4_q, select_840_s4_q};
  end
`ifndef SYNTHESIS
  logic [5:0] best_left_raddr_s1_sim;
  logic best_left_re_s1_sim;
  logic [5:0] best_left_raddr_s2_sim;
  logic best_left_re_s2_sim;
  logic [5:0] best_left_raddr_s3_sim;
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
      if (best_left_waddr >= 6'd47) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 6'd47) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [5:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s4_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s4_en & and_940_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near_s4_q, shown_s4_q, explained, and_989, textured};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 6'd47) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 6'd47) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
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
      region_across_back_q <= 7'h0;
      columns_begin_rest_q <= 8'h0;
      columns_begin_back_q <= 7'h0;
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
      map_row_q <= 11'h0;
      map_width_q <= 6'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      said_q <= 1'b0;
      rows_passed_q <= 10'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
      began_q <= 1'b0;
      seen_x_q <= 3'h0;
      seen_y_q <= 3'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 11'h0;
    end else if (s4_en) begin
      census_filled_q <= and_359_s4_q ? {select_421[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_359_s4_q ? select_420 : rows_passed_above_q;
      counts_too_much_hidden_q <= select_1575;
      registration_counts_measured_0_q <= select_1666;
      registration_counts_measured_1_q <= select_1675;
      registration_counts_measured_2_q <= select_1683;
      registration_counts_measured_3_q <= select_1690;
      registration_counts_votes_0_down_q <= and_1478 ? 15'h0 : sum_1697;
      registration_counts_votes_0_up_q <= and_1478 ? 15'h0 : sum_1706;
      registration_counts_votes_1_down_q <= and_1478 ? 15'h0 : sum_1715;
      registration_counts_votes_1_up_q <= and_1478 ? 15'h0 : sum_1723;
      registration_counts_votes_2_down_q <= and_1478 ? 15'h0 : sum_1731;
      registration_counts_votes_2_up_q <= and_1478 ? 15'h0 : sum_1739;
      registration_counts_votes_3_down_q <= and_1478 ? 15'h0 : sum_1748;
      registration_counts_votes_3_up_q <= and_1478 ? 15'h0 : sum_1756;
      registration_counts_votes_4_down_q <= and_1478 ? 15'h0 : sum_1764;
      registration_counts_votes_4_up_q <= and_1478 ? 15'h0 : sum_1772;
      registration_counts_half_votes_0_down_q <= and_1478 ? 15'h0 : sum_1781;
      registration_counts_half_votes_0_up_q <= and_1478 ? 15'h0 : sum_1790;
      registration_counts_half_votes_1_down_q <= and_1478 ? 15'h0 : sum_1798;
      registration_counts_half_votes_1_up_q <= and_1478 ? 15'h0 : sum_1806;
      registration_counts_half_votes_2_down_q <= and_1478 ? 15'h0 : sum_1814;
      registration_counts_half_votes_2_up_q <= and_1478 ? 15'h0 : sum_1822;
      registration_counts_half_votes_3_down_q <= and_1478 ? 15'h0 : sum_1830;
      registration_counts_half_votes_3_up_q <= and_1478 ? 15'h0 : sum_1838;
      region_row_q <= and_359_s4_q ? select_1856 : region_row_q;
      region_columns_q <= equal_909_s4_q ? select_950 : (drew_s4_q ? select_1044 : 8'h1);
      region_across_rest_q <= select_1862;
      region_across_back_q <= drew_s4_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_359_s4_q ? select_1865 : columns_begin_rest_q;
      columns_begin_back_q <= and_359_s4_q ? select_1868 : columns_begin_back_q;
      region_down_rest_q <= select_1874;
      region_down_back_q <= select_1878;
      region_down_next_q <= select_1880;
      region_fresh_q <= and_359_s4_q ? select_1884 : region_fresh_q;
      segment_starts_q <= equal_909_s4_q ? or_1889 : (drew_s4_q ? select_1892 : or_1889);
      hidden_for_q <= select_1916;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1917};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s4_q;
      centres_values_0_textured_q <= select_1986;
      centres_values_0_of_skin_q <= equal_909_s4_q ? centres_values_0_of_skin_q : select_1988;
      centres_values_1_textured_q <= equal_909_s4_q ? centres_values_1_textured_q : select_1990;
      centres_values_1_of_skin_q <= equal_909_s4_q ? centres_values_1_of_skin_q : select_1992;
      map_row_q <= and_359_s4_q ? select_1997 : map_row_q;
      map_width_q <= select_2000;
      write_half_q <= select_2005;
      read_half_q <= and_1012_s4_q ? select_2007 : read_half_q;
      done_q <= and_1012_s4_q ? (not_1013 & and_2011) : and_2011;
      said_q <= equal_909_s4_q & equal_1896;
      rows_passed_q <= and_1012_s4_q ? select_2020 : rows_passed_q;
      columns_passed_q <= and_1012_s4_q ? select_2023 : columns_passed_q;
      line_ended_q <= and_1012_s4_q ? select_2026 : line_ended_q;
      began_q <= and_1012_s4_q ? select_2029 : began_q;
      seen_x_q <= and_1012_s4_q ? select_2032 : seen_x_q;
      seen_y_q <= and_1012_s4_q ? select_2039 : seen_y_q;
      seen_column_q <= and_1012_s4_q ? select_2042 : seen_column_q;
      seen_rows_left_q <= and_1012_s4_q ? select_2050 : seen_rows_left_q;
      at_cell_end_q <= and_1012_s4_q ? select_2057 : at_cell_end_q;
      was_next_row_q <= and_1012_s4_q ? select_2060 : was_next_row_q;
      seen_base_q <= and_1012_s4_q ? select_2063 : seen_base_q;
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
      averager_total_0_q <= select_1139;
      averager_total_1_q <= select_1141;
      census_columns_values_0_cell_0_left_q <= select_1165;
      census_columns_values_0_cell_0_right_q <= select_1166;
      census_columns_values_0_cell_0_mask_q <= select_1167;
      census_columns_values_0_cell_1_left_q <= select_1168;
      census_columns_values_0_cell_1_right_q <= select_1169;
      census_columns_values_0_cell_1_mask_q <= select_1170;
      census_columns_values_0_cell_2_left_q <= select_1171;
      census_columns_values_0_cell_2_right_q <= select_1172;
      census_columns_values_0_cell_2_mask_q <= select_1173;
      census_columns_values_0_cell_2_of_skin_q <= select_1174;
      census_columns_values_0_cell_3_left_q <= select_1175;
      census_columns_values_0_cell_3_right_q <= select_1176;
      census_columns_values_0_cell_3_mask_q <= select_1177;
      census_columns_values_0_cell_4_left_q <= select_1178;
      census_columns_values_0_cell_4_right_q <= select_1179;
      census_columns_values_0_cell_4_mask_q <= select_1180;
      census_columns_values_1_cell_0_left_q <= select_1181;
      census_columns_values_1_cell_0_right_q <= select_1182;
      census_columns_values_1_cell_0_mask_q <= select_1183;
      census_columns_values_1_cell_1_left_q <= select_1184;
      census_columns_values_1_cell_1_right_q <= select_1185;
      census_columns_values_1_cell_1_mask_q <= select_1186;
      census_columns_values_1_cell_2_left_q <= select_1187;
      census_columns_values_1_cell_2_right_q <= select_1188;
      census_columns_values_1_cell_2_mask_q <= select_1189;
      census_columns_values_1_cell_2_of_skin_q <= select_1190;
      census_columns_values_1_cell_3_left_q <= select_1191;
      census_columns_values_1_cell_3_right_q <= select_1192;
      census_columns_values_1_cell_3_mask_q <= select_1193;
      census_columns_values_1_cell_4_left_q <= select_1194;
      census_columns_values_1_cell_4_right_q <= select_1195;
      census_columns_values_1_cell_4_mask_q <= select_1196;
      census_columns_values_2_cell_0_left_q <= select_1197;
      census_columns_values_2_cell_0_right_q <= select_1198;
      census_columns_values_2_cell_0_mask_q <= select_1199;
      census_columns_values_2_cell_1_left_q <= select_1200;
      census_columns_values_2_cell_1_right_q <= select_1201;
      census_columns_values_2_cell_1_mask_q <= select_1202;
      census_columns_values_2_cell_2_left_q <= select_1203;
      census_columns_values_2_cell_2_right_q <= select_1204;
      census_columns_values_2_cell_2_mask_q <= select_1205;
      census_columns_values_2_cell_3_left_q <= select_1206;
      census_columns_values_2_cell_3_right_q <= select_1207;
      census_columns_values_2_cell_3_mask_q <= select_1208;
      census_columns_values_2_cell_4_left_q <= select_1209;
      census_columns_values_2_cell_4_right_q <= select_1210;
      census_columns_values_2_cell_4_mask_q <= select_1211;
      census_columns_values_3_cell_0_mask_q <= select_1212;
      census_columns_values_3_cell_1_left_q <= select_1213;
      census_columns_values_3_cell_1_right_q <= select_1214;
      census_columns_values_3_cell_1_mask_q <= select_1215;
      census_columns_values_3_cell_2_mask_q <= select_1216;
      census_columns_values_3_cell_3_left_q <= select_1217;
      census_columns_values_3_cell_3_right_q <= select_1218;
      census_columns_values_3_cell_3_mask_q <= select_1219;
      census_columns_values_3_cell_4_mask_q <= select_1220;
      sharpness_last_mean_0_q <= and_359_s4_q ? select_365 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_359_s4_q ? select_369 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= select_1938;
      box_textured_columns_values_1_q <= equal_909_s4_q ? box_textured_columns_values_1_q : select_1939;
      box_textured_columns_values_2_q <= equal_909_s4_q ? box_textured_columns_values_2_q : select_1941;
      box_textured_columns_values_3_q <= equal_909_s4_q ? box_textured_columns_values_3_q : select_1943;
      box_textured_columns_values_4_q <= equal_909_s4_q ? box_textured_columns_values_4_q : select_1945;
      box_textured_sum_sums_values_0_q <= select_1948;
      box_explained_columns_values_0_q <= equal_909_s4_q ? box_explained_columns_values_0_q : select_1949;
      box_explained_columns_values_1_q <= equal_909_s4_q ? box_explained_columns_values_1_q : select_1951;
      box_explained_columns_values_2_q <= equal_909_s4_q ? box_explained_columns_values_2_q : select_1953;
      box_explained_columns_values_3_q <= equal_909_s4_q ? box_explained_columns_values_3_q : select_1955;
      box_explained_columns_values_4_q <= equal_909_s4_q ? box_explained_columns_values_4_q : select_1957;
      box_explained_sum_sums_values_0_q <= select_1960;
      box_shown_columns_values_0_q <= select_1962;
      box_shown_columns_values_1_q <= equal_909_s4_q ? box_shown_columns_values_1_q : select_1963;
      box_shown_columns_values_2_q <= equal_909_s4_q ? box_shown_columns_values_2_q : select_1965;
      box_shown_columns_values_3_q <= equal_909_s4_q ? box_shown_columns_values_3_q : select_1967;
      box_shown_columns_values_4_q <= equal_909_s4_q ? box_shown_columns_values_4_q : select_1969;
      box_shown_sum_sums_values_0_q <= select_1972;
      box_nearer_columns_values_0_q <= select_1974;
      box_nearer_columns_values_1_q <= equal_909_s4_q ? box_nearer_columns_values_1_q : select_1975;
      box_nearer_columns_values_2_q <= equal_909_s4_q ? box_nearer_columns_values_2_q : select_1977;
      box_nearer_columns_values_3_q <= equal_909_s4_q ? box_nearer_columns_values_3_q : select_1979;
      box_nearer_columns_values_4_q <= equal_909_s4_q ? box_nearer_columns_values_4_q : select_1981;
      box_nearer_sum_sums_values_0_q <= select_1984;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic left_first_s5_q;
  logic sample_pair_whole_s5_q;
  logic census_columns_values_1_cell_2_of_skin_s5_q;
  logic [5:0] x_s5_q;
  logic [2:0] region_row_s5_q;
  logic region_fresh_s5_q;
  logic begins_product_s5_q;
  logic centres_values_1_textured_s5_q;
  logic centres_values_1_of_skin_s5_q;
  logic done_s5_q;
  logic [5:0] column_s5_q;
  logic and_357_s5_q;
  logic and_359_s5_q;
  logic [8:0] grey_s5_q;
  logic equal_362_s5_q;
  logic [8:0] grey_2_s5_q;
  logic whole_2_s5_q;
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
  logic less_413_s5_q;
  logic less_414_s5_q;
  logic and_422_s5_q;
  logic and_447_s5_q;
  logic and_448_s5_q;
  logic [11:0] texture_s5_q;
  logic equal_909_s5_q;
  logic not_910_s5_q;
  logic [2:0] select_938_s5_q;
  logic or_953_s5_q;
  logic or_956_s5_q;
  logic or_959_s5_q;
  logic equal_961_s5_q;
  logic textured_s5_q;
  logic explained_s5_q;
  logic and_982_s5_q;
  logic and_987_s5_q;
  logic and_1012_s5_q;
  logic and_1019_s5_q;
  logic less_1020_s5_q;
  logic [11:0] sum_1028_s5_q;
  logic equal_1042_s5_q;
  logic or_1047_s5_q;
  logic or_1050_s5_q;
  logic or_1053_s5_q;
  logic not_1077_s5_q;
  logic less_1091_s5_q;
  logic and_1102_s5_q;
  logic [11:0] sum_1240_s5_q;
  logic equal_1247_s5_q;
  logic [8:0] contrast_s5_q;
  logic [8:0] contrast_2_s5_q;
  logic and_1478_s5_q;
  logic and_1481_s5_q;
  logic equal_1496_s5_q;
  logic not_1512_s5_q;
  logic less_1576_s5_q;
  logic equal_1579_s5_q;
  logic equal_1580_s5_q;
  logic equal_1581_s5_q;
  logic [7:0] residual_s5_q;
  logic equal_1896_s5_q;
  logic and_2066_s5_q;
  logic less_2118_s5_q;
  logic less_2119_s5_q;
  logic less_2121_s5_q;
  logic or_2124_s5_q;
  logic less_2126_s5_q;
  logic or_2131_s5_q;
  logic less_2132_s5_q;
  logic or_2138_s5_q;
  logic select_2175_s5_q;
  logic or_2177_s5_q;
  logic less_2179_s5_q;
  logic less_2182_s5_q;
  logic select_2186_s5_q;
  logic and_2218_s5_q;
  logic [11:0] select_2228_s5_q;
  logic [11:0] select_2230_s5_q;
  logic [11:0] select_2232_s5_q;
  logic [11:0] select_2234_s5_q;
  logic and_2243_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      left_first_s5_q <= left_first_s4_q;
      sample_pair_whole_s5_q <= sample_pair_whole_s4_q;
      census_columns_values_1_cell_2_of_skin_s5_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s5_q <= x_s4_q[5:0];
      region_row_s5_q <= region_row_q;
      region_fresh_s5_q <= region_fresh_q;
      begins_product_s5_q <= begins_product_q;
      centres_values_1_textured_s5_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s5_q <= centres_values_1_of_skin_q;
      done_s5_q <= done_q;
      column_s5_q <= column_s4_q;
      and_357_s5_q <= and_357_s4_q;
      and_359_s5_q <= and_359_s4_q;
      grey_s5_q <= grey_s4_q;
      equal_362_s5_q <= equal_362_s4_q;
      grey_2_s5_q <= grey_2_s4_q;
      whole_2_s5_q <= whole_2_s4_q;
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
      less_413_s5_q <= less_413;
      less_414_s5_q <= less_414;
      and_422_s5_q <= and_422;
      and_447_s5_q <= whole_22 & and_422;
      and_448_s5_q <= census_columns_values_1_cell_2_mask_q & and_422;
      texture_s5_q <= texture;
      equal_909_s5_q <= equal_909_s4_q;
      not_910_s5_q <= not_910_s4_q;
      select_938_s5_q <= {select_938_s4_q[4], select_938_s4_q[2], select_938_s4_q[0]};
      or_953_s5_q <= or_953;
      or_956_s5_q <= or_956;
      or_959_s5_q <= or_959;
      equal_961_s5_q <= equal_961;
      textured_s5_q <= textured;
      explained_s5_q <= explained;
      and_982_s5_q <= and_982;
      and_987_s5_q <= not_910_s4_q & and_968;
      and_1012_s5_q <= and_1012_s4_q;
      and_1019_s5_q <= and_1019;
      less_1020_s5_q <= less_1020;
      sum_1028_s5_q <= sum_1028;
      equal_1042_s5_q <= t[4:1] == 4'h0;
      or_1047_s5_q <= or_1047;
      or_1050_s5_q <= select_1044[7] | (~({select_1044[6], select_1044[3:2]} == 3'h0));
      or_1053_s5_q <= select_1044[7] | (~(select_1044[6:4] == 3'h0));
      not_1077_s5_q <= ~({sum_1075, around[0]} < {2'h0, t});
      less_1091_s5_q <= {1'b0, around[4:1]} < n;
      and_1102_s5_q <= and_1102_s4_q;
      sum_1240_s5_q <= ({1'b0, sum_1232} + {2'h0, sum_1235}) + {2'h0, sum_1239};
      equal_1247_s5_q <= equal_1247_s4_q;
      contrast_s5_q <= contrast;
      contrast_2_s5_q <= contrast_2;
      and_1478_s5_q <= and_1478;
      and_1481_s5_q <= and_1481;
      equal_1496_s5_q <= x_s4_q[7:1] == 7'h0;
      not_1512_s5_q <= ~({sum_1510, e[0]} < {2'h0, t});
      less_1576_s5_q <= less_1576_s4_q;
      equal_1579_s5_q <= equal_1579;
      equal_1580_s5_q <= equal_1580;
      equal_1581_s5_q <= equal_1581;
      residual_s5_q <= residual_s4_q;
      equal_1896_s5_q <= equal_1896;
      and_2066_s5_q <= and_1102_s4_q & (sum_1028 == sum_1010);
      less_2118_s5_q <= less_2118;
      less_2119_s5_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2121_s5_q <= less_2121;
      or_2124_s5_q <= or_2124;
      less_2126_s5_q <= less_2126;
      or_2131_s5_q <= or_2131;
      less_2132_s5_q <= less_2132;
      or_2138_s5_q <= or_2138;
      select_2175_s5_q <= select_2175;
      or_2177_s5_q <= less_2176 | select_2175;
      less_2179_s5_q <= less_2179;
      less_2182_s5_q <= less_2182;
      select_2186_s5_q <= less_2144 ? or_2174 : select_2171;
      and_2218_s5_q <= equal_909_s4_q & (equal_1896 & (cfg_prove_i & and_2215));
      select_2228_s5_q <= select_2228;
      select_2230_s5_q <= select_2230;
      select_2232_s5_q <= select_2232;
      select_2234_s5_q <= select_2234;
      and_2243_s5_q <= equal_909_s4_q & not_962;
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
  logic [5:0] segment_textured_q;
  logic [5:0] segment_explained_q;
  logic [5:0] segment_nearer_q;
  logic segment_started_q;
  logic [47:0] good_q;
  logic [47:0] good_next_q;
  logic [35:0] product_0_q;
  logic [35:0] product_1_q;
  logic [34:0] addend_0_q;
  logic [34:0] addend_1_q;
  logic [17:0] multiplier_0_q;
  logic [17:0] multiplier_1_q;
  logic proven_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:201
  logic [12:0] sum_468;
  assign sum_468 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s5_q};
  logic [13:0] sum_470;
  assign sum_470 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_468});
  // hls/stages/census.hpp:223
  logic less_471;
  assign less_471 = 9'h4 < sum_470[13:5];
  logic and_472;
  assign and_472 = and_422_s5_q & less_471;
  // hls/stages/agreement.hpp:509
  logic [5:0] select_972;
  assign select_972 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:510
  logic [5:0] sum_973;
  assign sum_973 = {5'h0, textured_s5_q} + select_972;
  // hls/stages/agreement.hpp:639
  logic [11:0] sum_975;
  assign sum_975 = {6'h0, sum_973} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:509
  logic [5:0] select_977;
  assign select_977 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:510
  logic [5:0] sum_978;
  assign sum_978 = {5'h0, explained_s5_q} + select_977;
  // hls/stages/agreement.hpp:640
  logic [11:0] sum_980;
  assign sum_980 = {6'h0, sum_978} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:509
  logic [5:0] select_983;
  assign select_983 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:511
  logic [5:0] sum_984;
  assign sum_984 = {5'h0, and_982_s5_q} + select_983;
  // hls/stages/agreement.hpp:641
  logic [11:0] sum_986;
  assign sum_986 = {6'h0, sum_984} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:679
  logic not_1054;
  assign not_1054 = ~region_row_s5_q[2];
  logic [2:0] select_1055;
  assign select_1055 = region_row_s5_q[1] ? {1'b0, not_1054, 1'b0} : {region_row_s5_q[2], 1'b0, not_1054};
  logic [5:0] select_1056;
  assign select_1056 = region_row_s5_q[0] ? {select_1055[2], 1'b0, select_1055[1], 1'b0, select_1055[0], 1'b0} : {1'b0, select_1055[2], 1'b0, select_1055[1], 1'b0, select_1055[0]};
  logic [11:0] select_1057;
  assign select_1057 = or_1053_s5_q ? {select_1056[5], 1'b0, select_1056[4], 1'b0, select_1056[3], 1'b0, select_1056[2], 1'b0, select_1056[1], 1'b0, select_1056[0], 1'b0} : {1'b0, select_1056[5], 1'b0, select_1056[4], 1'b0, select_1056[3], 1'b0, select_1056[2], 1'b0, select_1056[1], 1'b0, select_1056[0]};
  logic [23:0] select_1058;
  assign select_1058 = or_1050_s5_q ? {select_1057[11], 1'b0, select_1057[10], 1'b0, select_1057[9], 1'b0, select_1057[8], 1'b0, select_1057[7], 1'b0, select_1057[6], 1'b0, select_1057[5], 1'b0, select_1057[4], 1'b0, select_1057[3], 1'b0, select_1057[2], 1'b0, select_1057[1], 1'b0, select_1057[0], 1'b0} : {1'b0, select_1057[11], 1'b0, select_1057[10], 1'b0, select_1057[9], 1'b0, select_1057[8], 1'b0, select_1057[7], 1'b0, select_1057[6], 1'b0, select_1057[5], 1'b0, select_1057[4], 1'b0, select_1057[3], 1'b0, select_1057[2], 1'b0, select_1057[1], 1'b0, select_1057[0]};
  logic [47:0] select_1059;
  assign select_1059 = or_1047_s5_q ? {select_1058[23], 1'b0, select_1058[22], 1'b0, select_1058[21], 1'b0, select_1058[20], 1'b0, select_1058[19], 1'b0, select_1058[18], 1'b0, select_1058[17], 1'b0, select_1058[16], 1'b0, select_1058[15], 1'b0, select_1058[14], 1'b0, select_1058[13], 1'b0, select_1058[12], 1'b0, select_1058[11], 1'b0, select_1058[10], 1'b0, select_1058[9], 1'b0, select_1058[8], 1'b0, select_1058[7], 1'b0, select_1058[6], 1'b0, select_1058[5], 1'b0, select_1058[4], 1'b0, select_1058[3], 1'b0, select_1058[2], 1'b0, select_1058[1], 1'b0, select_1058[0], 1'b0} : {1'b0, select_1058[23], 1'b0, select_1058[22], 1'b0, select_1058[21], 1'b0, select_1058[20], 1'b0, select_1058[19], 1'b0, select_1058[18], 1'b0, select_1058[17], 1'b0, select_1058[16], 1'b0, select_1058[15], 1'b0, select_1058[14], 1'b0, select_1058[13], 1'b0, select_1058[12], 1'b0, select_1058[11], 1'b0, select_1058[10], 1'b0, select_1058[9], 1'b0, select_1058[8], 1'b0, select_1058[7], 1'b0, select_1058[6], 1'b0, select_1058[5], 1'b0, select_1058[4], 1'b0, select_1058[3], 1'b0, select_1058[2], 1'b0, select_1058[1], 1'b0, select_1058[0]};
  logic not_1062;
  assign not_1062 = ~((good_q & select_1059) == 48'h0);
  // hls/stages/agreement.hpp:681
  logic is_seen;
  assign is_seen = equal_1042_s5_q ? not_1062 : not_1077_s5_q;
  // hls/stages/agreement.hpp:693
  logic and_1092;
  assign and_1092 = is_seen & less_1091_s5_q;
  // hls/stages/agreement.hpp:204
  logic [8:0] select_1131;
  assign select_1131 = sample_pair_whole_s5_q ? (and_357_s5_q ? grey_s5_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1133;
  assign select_1133 = sample_pair_whole_s5_q ? (and_357_s5_q ? grey_2_s5_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1135;
  assign select_1135 = sample_pair_whole_s5_q ? (and_357_s5_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1137;
  assign select_1137 = sample_pair_whole_s5_q ? (and_357_s5_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1142;
  assign sum_1142 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s5_q};
  logic [9:0] difference_1143;
  assign difference_1143 = {1'b0, sum_1142[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1144;
  assign xor_1144 = {difference_1143[8:0], sum_1142[0]} ^ {10{difference_1143[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1143[9]} + {1'b0, xor_1144};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_362_s5_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1149;
  assign select_1149 = sample_pair_whole_s5_q ? (and_357_s5_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1150;
  assign sum_1150 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s5_q};
  logic [9:0] difference_1151;
  assign difference_1151 = {1'b0, sum_1150[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1152;
  assign xor_1152 = {difference_1151[8:0], sum_1150[0]} ^ {10{difference_1151[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1151[9]} + {1'b0, xor_1152};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_362_s5_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1157;
  assign select_1157 = sample_pair_whole_s5_q ? (and_357_s5_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1242;
  assign select_1242 = and_359_s5_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1243;
  assign select_1243 = and_359_s5_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1244;
  assign select_1244 = and_359_s5_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1245;
  assign select_1245 = and_359_s5_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_1248;
  assign sum_1248 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1240_s5_q};
  logic [13:0] sum_1250;
  assign sum_1250 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1248});
  // hls/stages/census.hpp:225
  logic and_1252;
  assign and_1252 = and_447_s5_q & (9'h4 < sum_1250[13:5]);
  // hls/stages/census.hpp:226
  logic and_1253;
  assign and_1253 = and_447_s5_q & less_471;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1254;
  assign sum_1254 = census_left_misses_q + {{17{and_1253}}, and_1252, 1'b0, and_1252};
  // hls/stages/agreement.hpp:205
  logic [19:0] select_1256;
  assign select_1256 = and_359_s5_q ? (equal_1247_s5_q ? 20'h0 : sum_1254) : census_left_misses_q;
  // hls/stages/agreement.hpp:204
  logic [27:0] select_1261;
  assign select_1261 = sample_pair_whole_s5_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:275
  logic and_1266;
  assign and_1266 = whole_2_s5_q & (~(column_s5_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:283
  logic and_1272;
  assign and_1272 = and_1266 & (sharpness_last_mask_q & (7'h2 < contrast_s5_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1261[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1274;
  assign select_1274 = and_1272 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1276;
  assign select_1276 = equal_1247_s5_q ? {11'h0, select_1274} : (sharpness_sums_detail_0_q + {11'h0, select_1274});
  // hls/stages/agreement.hpp:283
  logic and_1283;
  assign and_1283 = and_1266 & (sharpness_last_mask_q & (7'h2 < contrast_2_s5_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1261[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1285;
  assign select_1285 = and_1283 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1287;
  assign select_1287 = equal_1247_s5_q ? {11'h0, select_1285} : (sharpness_sums_detail_1_q + {11'h0, select_1285});
  logic [8:0] select_1290;
  assign select_1290 = and_1272 ? contrast_s5_q : 9'h0;
  logic [23:0] sum_1291;
  assign sum_1291 = (equal_1247_s5_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1290};
  logic [8:0] select_1294;
  assign select_1294 = and_1283 ? contrast_2_s5_q : 9'h0;
  logic [23:0] sum_1295;
  assign sum_1295 = (equal_1247_s5_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1294};
  // hls/stages/agreement.hpp:533
  logic [13:0] select_1483;
  assign select_1483 = and_1478_s5_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1481_s5_q});
  // hls/stages/agreement.hpp:339
  logic and_1485;
  assign and_1485 = not_910_s5_q & (begins_product_q & textured_s5_q);
  logic and_1489;
  assign and_1489 = not_910_s5_q & (begins_product_q & explained_s5_q);
  logic and_1493;
  assign and_1493 = not_910_s5_q & (begins_product_q & and_982_s5_q);
  // hls/stages/agreement.hpp:680
  logic select_1513;
  assign select_1513 = equal_1042_s5_q ? not_1062 : not_1512_s5_q;
  // hls/stages/agreement.hpp:685
  logic not_1514;
  assign not_1514 = ~select_1513;
  // hls/stages/agreement.hpp:339
  logic and_1517;
  assign and_1517 = begins_product_q & ((~equal_1496_s5_q) & (centres_values_1_textured_s5_q & not_1514));
  logic and_1518;
  assign and_1518 = not_910_s5_q & and_1517;
  // hls/stages/agreement.hpp:711
  logic less_1521;
  assign less_1521 = region_row_s5_q < x_s5_q[5:3];
  logic [11:0] select_1522;
  assign select_1522 = less_1521 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1525;
  assign select_1525 = less_1521 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:712
  logic [12:0] sum_1526;
  assign sum_1526 = {1'b0, select_1525} + {3'h0, select_1525[11:2]};
  logic and_1528;
  assign and_1528 = (~(select_1522[11:4] == 8'h0)) & ({sum_1526, select_1525[1:0]} < {3'h0, select_1522});
  // hls/stages/agreement.hpp:722
  logic [11:0] select_1530;
  assign select_1530 = equal_961_s5_q ? 12'h0 : (and_1528 ? select_1522 : 12'h0);
  // hls/stages/agreement.hpp:339
  logic [11:0] select_1531;
  assign select_1531 = equal_909_s5_q ? select_1530 : 12'h0;
  // hls/stages/agreement.hpp:533
  logic [13:0] select_1533;
  assign select_1533 = and_1478_s5_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1531});
  // hls/stages/agreement.hpp:616
  logic [1:0] difference_1534;
  assign difference_1534 = 2'h0 - {1'b0, select_938_s5_q[2]};
  // hls/stages/agreement.hpp:620
  logic [9:0] select_1535;
  assign select_1535 = select_938_s5_q[1] ? {difference_1534, cfg_explained_limit_i} : 10'h0;
  // hls/stages/agreement.hpp:339
  logic [9:0] select_1537;
  assign select_1537 = begins_product_q ? (select_938_s5_q[0] ? select_1535 : 10'h0) : 10'h0;
  logic [9:0] select_1538;
  assign select_1538 = equal_909_s5_q ? 10'h0 : select_1537;
  // hls/stages/agreement.hpp:528
  logic [23:0] sum_1539;
  assign sum_1539 = counts_too_little_explained_q + {{14{select_1538[9]}}, select_1538};
  // hls/stages/agreement.hpp:186
  logic [8:0] select_1543;
  assign select_1543 = select_938_s5_q[0] ? (select_938_s5_q[1] ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0) : 9'h0;
  // hls/stages/agreement.hpp:339
  logic [8:0] select_1544;
  assign select_1544 = begins_product_q ? select_1543 : 9'h0;
  logic [20:0] select_1545;
  assign select_1545 = equal_909_s5_q ? {1'b0, select_1530, 8'h0} : {{12{select_1544[8]}}, select_1544};
  // hls/stages/agreement.hpp:533
  logic [23:0] select_1547;
  assign select_1547 = and_1478_s5_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1545[20]}}, select_1545});
  // hls/stages/agreement.hpp:620
  logic [8:0] select_1549;
  assign select_1549 = select_938_s5_q[1] ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1550;
  assign select_1550 = select_938_s5_q[0] ? select_1549[7:0] : 8'h0;
  // hls/stages/agreement.hpp:186
  logic and_1551;
  assign and_1551 = select_938_s5_q[0] & select_1549[8];
  // hls/stages/agreement.hpp:691
  logic [2:0] select_1554;
  assign select_1554 = centres_values_1_textured_s5_q ? (select_1513 ? {3{and_1551}} : ({3{and_1551}} + 3'h1)) : {3{and_1551}};
  logic [2:0] select_1555;
  assign select_1555 = equal_1496_s5_q ? {3{and_1551}} : select_1554;
  // hls/stages/agreement.hpp:339
  logic [10:0] select_1557;
  assign select_1557 = equal_909_s5_q ? 11'h0 : (begins_product_q ? {select_1555, select_1550} : 11'h0);
  // hls/stages/agreement.hpp:530
  logic [23:0] sum_1558;
  assign sum_1558 = counts_too_much_unproven_q + {{13{select_1557[10]}}, select_1557};
  // hls/stages/agreement.hpp:691
  logic [9:0] select_1561;
  assign select_1561 = centres_values_1_of_skin_s5_q ? ({1'b0, not_1514, 8'h0} - {2'h0, cfg_unproven_skin_limit_i}) : 10'h0;
  logic [9:0] select_1563;
  assign select_1563 = equal_1496_s5_q ? 10'h0 : (centres_values_1_textured_s5_q ? select_1561 : 10'h0);
  // hls/stages/agreement.hpp:339
  logic [9:0] select_1565;
  assign select_1565 = equal_909_s5_q ? 10'h0 : (begins_product_q ? select_1563 : 10'h0);
  // hls/stages/agreement.hpp:531
  logic [23:0] sum_1566;
  assign sum_1566 = counts_too_much_unseen_skin_q + {{14{select_1565[9]}}, select_1565};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1619;
  assign select_1619 = equal_1580_s5_q ? 8'h0 : (equal_1581_s5_q ? 8'h0 : residual_s5_q);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1622;
  assign select_1622 = select_938_s5_q[2] ? (less_1576_s5_q ? (equal_1579_s5_q ? 8'h0 : select_1619) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1624;
  assign select_1624 = begins_product_q ? (select_938_s5_q[0] ? select_1622 : 8'h0) : 8'h0;
  logic [7:0] select_1625;
  assign select_1625 = equal_909_s5_q ? 8'h0 : select_1624;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1626;
  assign sum_1626 = registration_counts_across_0_q + {{12{select_1625[7]}}, select_1625};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1629;
  assign select_1629 = equal_1580_s5_q ? 8'h0 : (equal_1581_s5_q ? residual_s5_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1632;
  assign select_1632 = select_938_s5_q[2] ? (less_1576_s5_q ? (equal_1579_s5_q ? 8'h0 : select_1629) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1634;
  assign select_1634 = begins_product_q ? (select_938_s5_q[0] ? select_1632 : 8'h0) : 8'h0;
  logic [7:0] select_1635;
  assign select_1635 = equal_909_s5_q ? 8'h0 : select_1634;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1636;
  assign sum_1636 = registration_counts_across_1_q + {{12{select_1635[7]}}, select_1635};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1639;
  assign select_1639 = equal_1579_s5_q ? 8'h0 : (equal_1580_s5_q ? residual_s5_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1641;
  assign select_1641 = select_938_s5_q[2] ? (less_1576_s5_q ? select_1639 : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1643;
  assign select_1643 = begins_product_q ? (select_938_s5_q[0] ? select_1641 : 8'h0) : 8'h0;
  logic [7:0] select_1644;
  assign select_1644 = equal_909_s5_q ? 8'h0 : select_1643;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1645;
  assign sum_1645 = registration_counts_across_2_q + {{12{select_1644[7]}}, select_1644};
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1649;
  assign select_1649 = select_938_s5_q[2] ? (less_1576_s5_q ? (equal_1579_s5_q ? residual_s5_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:339
  logic [7:0] select_1651;
  assign select_1651 = begins_product_q ? (select_938_s5_q[0] ? select_1649 : 8'h0) : 8'h0;
  logic [7:0] select_1652;
  assign select_1652 = equal_909_s5_q ? 8'h0 : select_1651;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1653;
  assign sum_1653 = registration_counts_across_3_q + {{12{select_1652[7]}}, select_1652};
  // hls/stages/agreement.hpp:707
  logic and_1901;
  assign and_1901 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:708
  logic less_1902;
  assign less_1902 = $signed(24'h0) < $signed(counts_too_little_explained_q);
  // hls/stages/agreement.hpp:714
  logic [12:0] sum_1905;
  assign sum_1905 = {1'b0, select_1525} + {2'h0, select_1525[11:1]};
  logic select_1908;
  assign select_1908 = (select_1522[11:3] == 9'h0) ? (and_1901 & (~less_1902)) : (~({sum_1905, select_1525[0]} < {2'h0, select_1522}));
  // hls/stages/agreement.hpp:722
  logic [47:0] select_1909;
  assign select_1909 = equal_961_s5_q ? good_next_q : {select_1908, good_next_q[47:1]};
  // hls/stages/agreement.hpp:339
  logic [47:0] select_1911;
  assign select_1911 = equal_909_s5_q ? (equal_1896_s5_q ? select_1909 : good_q) : good_q;
  // hls/stages/agreement.hpp:739
  logic [35:0] select_1928;
  assign select_1928 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:733
  logic [35:0] detail_left;
  assign detail_left = begins_product_s5_q ? 36'h0 : select_1928;
  // hls/stages/agreement.hpp:739
  logic [35:0] select_1931;
  assign select_1931 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:743
  logic [35:0] detail_right;
  assign detail_right = begins_product_s5_q ? 36'h0 : select_1931;
  // hls/stages/agreement.hpp:733
  logic [34:0] select_1933;
  assign select_1933 = begins_product_s5_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:743
  logic [34:0] select_1934;
  assign select_1934 = begins_product_s5_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:733
  logic [17:0] select_1935;
  assign select_1935 = begins_product_s5_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:743
  logic [17:0] select_1936;
  assign select_1936 = begins_product_s5_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:802
  logic select_2014;
  assign select_2014 = left_first_s5_q ? done_s5_q : proven_q;
  // hls/stages/agreement.hpp:208
  logic select_2016;
  assign select_2016 = left_first_s5_q ? done_s5_q : (and_1012_s5_q ? select_2014 : proven_q);
  // hls/stages/agreement.hpp:831
  logic [1:0] select_2067;
  assign select_2067 = and_2066_s5_q ? {and_1092, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:832
  logic and_2068;
  assign and_2068 = select_2014 & less_2044;
  // hls/stages/agreement.hpp:208
  logic select_2071;
  assign select_2071 = and_1019_s5_q ? (less_1020_s5_q ? (select_2067[0] & and_2068) : seen_q) : seen_q;
  logic select_2073;
  assign select_2073 = left_first_s5_q ? select_2071 : (and_1012_s5_q ? select_2071 : seen_q);
  logic select_2074;
  assign select_2074 = and_1012_s5_q ? select_2073 : seen_q;
  logic select_2077;
  assign select_2077 = and_1019_s5_q ? (less_1020_s5_q ? (select_2067[1] & and_2068) : nearer_q) : nearer_q;
  logic select_2079;
  assign select_2079 = left_first_s5_q ? select_2077 : (and_1012_s5_q ? select_2077 : nearer_q);
  logic select_2080;
  assign select_2080 = and_1012_s5_q ? select_2079 : nearer_q;
  // hls/stages/agreement.hpp:339
  logic [13:0] select_2085;
  assign select_2085 = equal_909_s5_q ? (equal_1896_s5_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_2087;
  assign select_2087 = equal_909_s5_q ? (equal_1896_s5_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_2089;
  assign select_2089 = equal_909_s5_q ? (equal_1896_s5_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_2091;
  assign select_2091 = equal_909_s5_q ? (equal_1896_s5_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_2093;
  assign select_2093 = equal_909_s5_q ? (equal_1896_s5_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_2095;
  assign select_2095 = equal_909_s5_q ? (equal_1896_s5_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  // hls/stages/agreement.hpp:759
  logic not_2100;
  assign not_2100 = ~and_1901;
  // hls/stages/agreement.hpp:760
  logic or_2104;
  assign or_2104 = not_2081 | not_2100;
  // hls/stages/agreement.hpp:726
  logic or_2110;
  assign or_2110 = ($signed(24'h0) < $signed(counts_too_much_unproven_q)) | ($signed(24'h0) < $signed(counts_too_much_unseen_skin_q));
  logic select_2112;
  assign select_2112 = (less_1902 | or_2104) ? (~or_2104) : (($signed(24'h0) < $signed(counts_too_many_bad_q)) | or_2110);
  logic select_2178;
  assign select_2178 = or_2138_s5_q ? select_2175_s5_q : or_2177_s5_q;
  logic or_2180;
  assign or_2180 = less_2179_s5_q | select_2178;
  logic select_2181;
  assign select_2181 = or_2131_s5_q ? select_2178 : or_2180;
  logic or_2183;
  assign or_2183 = less_2182_s5_q | select_2181;
  logic select_2188;
  assign select_2188 = less_2126_s5_q ? or_2180 : (less_2132_s5_q ? or_2177_s5_q : select_2186_s5_q);
  logic select_2190;
  assign select_2190 = less_2118_s5_q ? (less_2119_s5_q | (or_2124_s5_q ? select_2181 : or_2183)) : (less_2121_s5_q ? or_2183 : select_2188);
  // hls/stages/agreement.hpp:767
  logic and_2194;
  assign and_2194 = cfg_prove_i & and_1901;
  // hls/stages/agreement.hpp:768
  logic [36:0] sum_2195;
  assign sum_2195 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2197;
  assign less_2197 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:726
  logic or_2200;
  assign or_2200 = ({detail_left, 3'h0} < {sum_2195, detail_right[1:0]}) | (less_2197 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:771
  logic [36:0] sum_2204;
  assign sum_2204 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2206;
  assign less_2206 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:726
  logic or_2207;
  assign or_2207 = ({detail_right, 3'h0} < {sum_2204, detail_left[1:0]}) | less_2206;
  // hls/stages/agreement.hpp:339
  logic [19:0] select_2220;
  assign select_2220 = equal_909_s5_q ? (equal_1896_s5_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2222;
  assign select_2222 = equal_909_s5_q ? (equal_1896_s5_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2224;
  assign select_2224 = equal_909_s5_q ? (equal_1896_s5_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2226;
  assign select_2226 = equal_909_s5_q ? (equal_1896_s5_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [23:0] select_2236;
  assign select_2236 = equal_909_s5_q ? (equal_1896_s5_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2238;
  assign select_2238 = equal_909_s5_q ? (equal_1896_s5_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2240;
  assign select_2240 = equal_909_s5_q ? (equal_1896_s5_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2242;
  assign select_2242 = equal_909_s5_q ? (equal_1896_s5_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  // hls/stages/agreement.hpp:722
  logic [11:0] select_2251;
  assign select_2251 = equal_961_s5_q ? 12'h0 : (less_1521 ? 12'h0 : regions_rdata_q[35:24]);

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s5_q;
  logic fresh_we;
  assign fresh_we = s5_en & and_359_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s5_q, and_472, and_448_s5_q, and_447_s5_q, and_422_s5_q, less_414_s5_q, less_413_s5_q, less_412_s5_q, less_411_s5_q, less_410_s5_q, less_409_s5_q, less_408_s5_q, less_407_s5_q, less_406_s5_q, less_405_s5_q, less_404_s5_q, less_403_s5_q, less_402_s5_q, less_401_s5_q, less_400_s5_q, less_399_s5_q, less_398_s5_q, less_397_s5_q, less_396_s5_q, less_395_s5_q, less_394_s5_q, less_393_s5_q, less_392_s5_q, less_391_s5_q};
  end
`ifndef SYNTHESIS
  logic [5:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [5:0] fresh_raddr_s2_sim;
  logic fresh_re_s2_sim;
  logic [5:0] fresh_raddr_s3_sim;
  logic fresh_re_s3_sim;
  logic [5:0] fresh_raddr_s4_sim;
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
      if (fresh_waddr >= 6'd47) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 6'd47) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s5_q, or_959_s5_q, or_956_s5_q, or_953_s5_q};
  logic regions_we;
  assign regions_we = s5_en & and_987_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_986, sum_980, sum_975};
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
  logic [11:0] map_waddr;
  assign map_waddr = sum_1028_s5_q;
  logic map_we;
  assign map_we = s5_en & and_1102_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1092, is_seen};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && map_we) begin
      if (map_re && map_raddr == map_waddr) begin
        $error("map: address %0d is read less than DISTANCE steps after its write", map_waddr);
      end
      if (map_waddr >= 12'd3290) $error("map: write outside, address %0d", map_waddr);
    end
    if (rst_ni && map_re && map_raddr >= 12'd3290) $error("map: read outside, address %0d", map_raddr);
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
      segment_textured_q <= 6'h0;
      segment_explained_q <= 6'h0;
      segment_nearer_q <= 6'h0;
      segment_started_q <= 1'b0;
      good_q <= 48'h0;
      good_next_q <= 48'h0;
      product_0_q <= 36'h0;
      product_1_q <= 36'h0;
      addend_0_q <= 35'h0;
      addend_1_q <= 35'h0;
      multiplier_0_q <= 18'h0;
      multiplier_1_q <= 18'h0;
      proven_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s5_en) begin
      census_left_misses_q <= select_1256;
      sharpness_sums_detail_0_q <= and_359_s5_q ? select_1276 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_359_s5_q ? select_1287 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_359_s5_q ? sum_1291 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_359_s5_q ? sum_1295 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1483;
      counts_textured_q <= and_1478_s5_q ? 14'h0 : (counts_textured_q + {13'h0, and_1485});
      counts_explained_q <= and_1478_s5_q ? 14'h0 : (counts_explained_q + {13'h0, and_1489});
      counts_nearer_q <= and_1478_s5_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1493});
      counts_unproven_q <= and_1478_s5_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1518});
      counts_regions_bad_q <= select_1533;
      counts_too_little_explained_q <= and_1478_s5_q ? 24'h0 : sum_1539;
      counts_too_many_bad_q <= select_1547;
      counts_too_much_unproven_q <= and_1478_s5_q ? 24'h0 : sum_1558;
      counts_too_much_unseen_skin_q <= and_1478_s5_q ? 24'h0 : sum_1566;
      registration_counts_across_0_q <= and_1478_s5_q ? 20'h0 : sum_1626;
      registration_counts_across_1_q <= and_1478_s5_q ? 20'h0 : sum_1636;
      registration_counts_across_2_q <= and_1478_s5_q ? 20'h0 : sum_1645;
      registration_counts_across_3_q <= and_1478_s5_q ? 20'h0 : sum_1653;
      segment_textured_q <= select_972 + {5'h0, and_1485};
      segment_explained_q <= select_977 + {5'h0, and_1489};
      segment_nearer_q <= select_983 + {5'h0, and_1493};
      segment_started_q <= ~segment_starts_q;
      good_q <= select_1911;
      good_next_q <= equal_909_s5_q ? select_1909 : good_next_q;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1933;
      addend_1_q <= select_1934;
      multiplier_0_q <= select_1935;
      multiplier_1_q <= select_1936;
      proven_q <= and_1012_s5_q ? select_2016 : proven_q;
      seen_q <= select_2074;
      nearer_q <= select_2080;
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
      averager_quarter_1_0_q <= select_1131;
      averager_quarter_1_1_q <= select_1133;
      averager_quarter_2_0_q <= select_1135;
      averager_quarter_2_1_q <= select_1137;
      averager_detail_0_q <= select_1149;
      averager_detail_1_q <= select_1157;
      census_changes_values_0_left_q <= and_359_s5_q ? texture_s5_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_359_s5_q ? sum_1240_s5_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1242;
      census_changes_values_1_right_q <= select_1243;
      census_changes_values_2_left_q <= select_1244;
      census_changes_values_2_right_q <= select_1245;
      sharpness_last_mask_q <= and_359_s5_q ? whole_2_s5_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_359_s5_q ? select_1261[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_359_s5_q ? select_1261[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic and_2018_s6_q;
  logic or_2082_s6_q;
  logic and_2083_s6_q;
  logic [13:0] select_2085_s6_q;
  logic [13:0] select_2087_s6_q;
  logic [13:0] select_2089_s6_q;
  logic [13:0] select_2091_s6_q;
  logic [13:0] select_2093_s6_q;
  logic [13:0] select_2095_s6_q;
  logic and_2099_s6_q;
  logic and_2103_s6_q;
  logic and_2114_s6_q;
  logic and_2193_s6_q;
  logic and_2203_s6_q;
  logic and_2210_s6_q;
  logic and_2218_s6_q;
  logic [19:0] select_2220_s6_q;
  logic [19:0] select_2222_s6_q;
  logic [19:0] select_2224_s6_q;
  logic [19:0] select_2226_s6_q;
  logic [11:0] select_2228_s6_q;
  logic [11:0] select_2230_s6_q;
  logic [11:0] select_2232_s6_q;
  logic [11:0] select_2234_s6_q;
  logic [23:0] select_2236_s6_q;
  logic [23:0] select_2238_s6_q;
  logic [23:0] select_2240_s6_q;
  logic [23:0] select_2242_s6_q;
  logic and_2243_s6_q;
  logic [5:0] select_2245_s6_q;
  logic [11:0] select_2247_s6_q;
  logic [11:0] select_2249_s6_q;
  logic [11:0] select_2252_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      and_2018_s6_q <= said_q;
      or_2082_s6_q <= not_2081 | select_2074;
      and_2083_s6_q <= cfg_prove_i & select_2080;
      select_2085_s6_q <= select_2085;
      select_2087_s6_q <= select_2087;
      select_2089_s6_q <= select_2089;
      select_2091_s6_q <= select_2091;
      select_2093_s6_q <= select_2093;
      select_2095_s6_q <= select_2095;
      and_2099_s6_q <= equal_909_s5_q & (equal_1896_s5_q & (cfg_prove_i & (~proven_q)));
      and_2103_s6_q <= equal_909_s5_q & (equal_1896_s5_q & (cfg_prove_i & not_2100));
      and_2114_s6_q <= equal_909_s5_q & (equal_1896_s5_q & select_2112);
      and_2193_s6_q <= equal_909_s5_q & (equal_1896_s5_q & (cfg_prove_i & select_2190));
      and_2203_s6_q <= equal_909_s5_q & (equal_1896_s5_q & (and_2194 & or_2200));
      and_2210_s6_q <= equal_909_s5_q & (equal_1896_s5_q & (and_2194 & or_2207));
      and_2218_s6_q <= and_2218_s5_q;
      select_2220_s6_q <= select_2220;
      select_2222_s6_q <= select_2222;
      select_2224_s6_q <= select_2224;
      select_2226_s6_q <= select_2226;
      select_2228_s6_q <= select_2228_s5_q;
      select_2230_s6_q <= select_2230_s5_q;
      select_2232_s6_q <= select_2232_s5_q;
      select_2234_s6_q <= select_2234_s5_q;
      select_2236_s6_q <= select_2236;
      select_2238_s6_q <= select_2238;
      select_2240_s6_q <= select_2240;
      select_2242_s6_q <= select_2242;
      and_2243_s6_q <= and_2243_s5_q;
      select_2245_s6_q <= equal_909_s5_q ? (equal_961_s5_q ? 6'h0 : x_s5_q) : 6'h0;
      select_2247_s6_q <= equal_909_s5_q ? (equal_961_s5_q ? 12'h0 : select_1522) : 12'h0;
      select_2249_s6_q <= equal_909_s5_q ? (equal_961_s5_q ? 12'h0 : select_1525) : 12'h0;
      select_2252_s6_q <= equal_909_s5_q ? select_2251 : 12'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s6_q;
  assign saturated_o = saturated_s6_q;
  assign mask_o = mask_s6_q;
  assign marks_first_o = marks_first_s6_q;
  assign marks_last_o = marks_last_s6_q;
  assign marks_seen_o = or_2082_s6_q;
  assign marks_nearer_o = and_2083_s6_q;
  assign verdict_valid_o = and_2018_s6_q;
  assign verdict_supervised_o = {2'h0, select_2085_s6_q};
  assign verdict_textured_o = {2'h0, select_2087_s6_q};
  assign verdict_explained_o = {2'h0, select_2089_s6_q};
  assign verdict_nearer_o = {2'h0, select_2091_s6_q};
  assign verdict_unproven_o = {2'h0, select_2093_s6_q};
  assign verdict_regions_bad_o = {2'h0, select_2095_s6_q};
  assign verdict_unproven_yet_o = and_2099_s6_q;
  assign verdict_untextured_o = and_2103_s6_q;
  assign verdict_disagree_o = and_2114_s6_q;
  assign verdict_moved_o = and_2193_s6_q;
  assign verdict_unsharp_left_o = and_2203_s6_q;
  assign verdict_unsharp_right_o = and_2210_s6_q;
  assign verdict_hidden_o = and_2218_s6_q;
  assign verdict_across_0_o = select_2220_s6_q;
  assign verdict_across_1_o = select_2222_s6_q;
  assign verdict_across_2_o = select_2224_s6_q;
  assign verdict_across_3_o = select_2226_s6_q;
  assign verdict_measured_0_o = select_2228_s6_q;
  assign verdict_measured_1_o = select_2230_s6_q;
  assign verdict_measured_2_o = select_2232_s6_q;
  assign verdict_measured_3_o = select_2234_s6_q;
  assign verdict_detail_0_o = select_2236_s6_q;
  assign verdict_detail_1_o = select_2238_s6_q;
  assign verdict_contrast_0_o = select_2240_s6_q;
  assign verdict_contrast_1_o = select_2242_s6_q;
  assign region_valid_o = and_2243_s6_q;
  assign region_region_o = select_2245_s6_q;
  assign region_textured_o = select_2247_s6_q;
  assign region_explained_o = select_2249_s6_q;
  assign region_nearer_o = select_2252_s6_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_2117[2:0], sum_1608[0], sum_1604[0], sum_1596[1:0], sum_1595[1:0], sum_1591[0], detail_4[1:0], detail_3[1:0], sum_1250[4:0], sum_885[8:0], sum_470[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
