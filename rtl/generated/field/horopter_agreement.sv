// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 6 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2553 bits, pipeline 1273 bits, memories 30671 bits.
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
  logic [5:0] sum_1422;
  assign sum_1422 = {1'b0, cfg_width_i[8:4]} + 6'h7;
  logic [5:0] sum_1437;
  assign sum_1437 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_1917;
  assign difference_1917 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2091;
  assign less_2091 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2092;
  assign sum_2092 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_2093;
  assign select_2093 = less_2091 ? {sum_2092, cfg_height_i[5:3]} : 8'h0;
  logic not_2128;
  assign not_2128 = ~cfg_prove_i;

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
  // hls/stages/agreement.hpp:787
  logic drew;
  assign drew = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:381
  logic equal_379;
  assign equal_379 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:590
  logic or_380;
  assign or_380 = drew | equal_379;
  // hls/stages/agreement.hpp:447
  logic not_381;
  assign not_381 = ~or_380;
  // hls/stages/agreement.hpp:381
  logic equal_382;
  assign equal_382 = run_phase_q == 3'h3;
  logic equal_384;
  assign equal_384 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:602
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
  // hls/stages/agreement.hpp:469
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:181
  logic and_527;
  assign and_527 = equal_382 & (age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q})));
  logic select_528;
  assign select_528 = or_380 ? not_386 : and_527;
  // hls/stages/agreement.hpp:488
  logic equal_531;
  assign equal_531 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:492
  logic or_533;
  assign or_533 = equal_531 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:143
  logic not_974;
  assign not_974 = ~drew;
  // hls/stages/agreement.hpp:130
  logic and_1057;
  assign and_1057 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:735
  logic [6:0] sum_1142;
  assign sum_1142 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:204
  logic [2:0] select_1157;
  assign select_1157 = sample_pair_whole_q ? (sample_last_q ? (select_338 + 3'h1) : select_338) : raster_at_y_q;
  logic [5:0] select_1159;
  assign select_1159 = sample_pair_whole_q ? (select_322 + {5'h0, equal_355}) : raster_at_column_q;
  logic [5:0] select_1162;
  assign select_1162 = sample_pair_whole_q ? (sample_last_q ? (select_416 + {5'h0, equal_356}) : select_416) : raster_at_row_q;
  logic select_1166;
  assign select_1166 = sample_pair_whole_q ? (sample_last_q ? (or_327 & (~raster_final_row_q)) : or_327) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_1168;
  assign select_1168 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:204
  logic select_1172;
  assign select_1172 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:289
  logic equal_1344;
  assign equal_1344 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:200
  logic [2:0] select_1345;
  assign select_1345 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1348;
  assign select_1348 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1351;
  assign select_1351 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1354;
  assign select_1354 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1357;
  assign select_1357 = ends_q ? following_shift_q : run_shift_q;
  logic select_1360;
  assign select_1360 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:290
  logic not_1361;
  assign not_1361 = ~equal_1344;
  // hls/stages/agreement.hpp:371
  logic not_1364;
  assign not_1364 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:381
  logic equal_1365;
  assign equal_1365 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:160
  logic or_1366;
  assign or_1366 = equal_1365 | equal_384;
  logic [2:0] select_1367;
  assign select_1367 = equal_382 ? {run_last_shift_q, {2{not_1364}}} : {1'b0, or_1366, equal_384};
  logic [2:0] select_1369;
  assign select_1369 = drew ? {{2{final_row_q}}, 1'b0} : (equal_379 ? 3'h5 : select_1367);
  logic [7:0] select_1371;
  assign select_1371 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [5:0] select_1372;
  assign select_1372 = equal_384 ? least_q : 6'h0;
  logic [7:0] select_1374;
  assign select_1374 = equal_379 ? 8'h0 : (equal_382 ? select_1371 : {2'h0, select_1372});
  logic [7:0] select_1377;
  assign select_1377 = run_last_shift_q ? {2'h0, last_q} : (run_shift_q[5] ? {2'h0, last_q} : next_highest_q);
  logic [5:0] select_1379;
  assign select_1379 = equal_384 ? last_q : (equal_1365 ? last_q : 6'h0);
  logic [7:0] select_1381;
  assign select_1381 = equal_379 ? {2'h0, last_q} : (equal_382 ? select_1377 : {2'h0, select_1379});
  logic [6:0] select_1384;
  assign select_1384 = equal_1365 ? whole_beats_q : 7'h0;
  logic [7:0] select_1386;
  assign select_1386 = equal_382 ? (run_last_shift_q ? {1'b0, whole_beats_q} : next_beats_q) : (equal_384 ? first_beats_q : {1'b0, select_1384});
  logic [5:0] select_1392;
  assign select_1392 = equal_382 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_384 ? (6'h0 - least_q) : 6'h0);
  logic select_1399;
  assign select_1399 = equal_382 ? (next_last_shift_q & not_1364) : (equal_384 & (least_q == 6'h0));
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1403;
  assign select_1403 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1407;
  assign select_1407 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:296
  logic less_1414;
  assign less_1414 = 6'h1c < column;
  // hls/stages/agreement.hpp:205
  logic [5:0] select_1417;
  assign select_1417 = and_359 ? (equal_1344 ? (less_1414 ? 6'h1d : column) : least_q) : least_q;
  // hls/stages/agreement.hpp:290
  logic [7:0] select_1420;
  assign select_1420 = equal_1344 ? (less_1414 ? ({2'h0, cfg_width_i[8:3]} + 8'hf1) : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1424;
  assign select_1424 = and_359 ? (equal_1344 ? {sum_1422, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:346
  logic not_1425;
  assign not_1425 = ~ends_q;
  // hls/stages/agreement.hpp:200
  logic [5:0] select_1426;
  assign select_1426 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1428;
  assign select_1428 = and_359 ? (equal_1344 ? 7'h0 : {select_1426, not_1425}) : {select_1426, not_1425};
  // hls/stages/agreement.hpp:200
  logic and_1430;
  assign and_1430 = not_1425 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:306
  logic [6:0] sum_1433;
  assign sum_1433 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:290
  logic select_1435;
  assign select_1435 = equal_1344 ? ({sum_1433[6], cfg_height_i[8:3]} == {1'b0, sum_1433[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:645
  logic [4:0] sum_1622;
  assign sum_1622 = {1'b0, last_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:153
  logic not_1969;
  assign not_1969 = ~run_shift_q[5];

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:916; read in stage 0, written in stage 5: 0 < 5 < 0 + DISTANCE.
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

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:917; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:918; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory best_left, 47 x 35, DISTANCE 12, hls/stages/agreement.hpp:919; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [34:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 35'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_380 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_528;
  logic [34:0] best_left_rdata_q;
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
      left_first_q <= and_1057 ? left_first_q : marks_first_i;
      right_q <= (~and_1057) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1057;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_320 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_1157;
      raster_at_column_q <= select_1159;
      raster_at_row_q <= select_1162;
      raster_at_live_q <= select_1166;
      raster_rows_left_q <= sample_pair_whole_q ? select_1168 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_1172;
      averager_place_q <= sample_pair_whole_q ? select_326 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= and_359 ? (equal_1344 ? 3'h1 : select_1345) : select_1345;
      run_lowest_q <= and_359 ? (equal_1344 ? 8'h0 : select_1348) : select_1348;
      run_highest_q <= and_359 ? (equal_1344 ? 8'h0 : select_1351) : select_1351;
      run_beats_q <= and_359 ? (equal_1344 ? 8'hc : select_1354) : select_1354;
      run_shift_q <= and_359 ? (equal_1344 ? 6'h0 : select_1357) : select_1357;
      run_last_shift_q <= and_359 ? (select_1360 & not_1361) : select_1360;
      following_phase_q <= select_1369;
      following_lowest_q <= drew ? 8'h0 : select_1374;
      following_highest_q <= drew ? 8'h0 : select_1381;
      following_beats_q <= drew ? 8'h3f : (equal_379 ? {1'b0, whole_beats_q} : select_1386);
      following_shift_q <= drew ? 6'h0 : (equal_379 ? 6'h0 : select_1392);
      following_last_shift_q <= not_974 & ((~equal_379) & select_1399);
      x_q <= and_359 ? (equal_1344 ? 8'h0 : select_1403) : select_1403;
      beats_left_q <= and_359 ? (equal_1344 ? 8'hc : select_1407) : select_1407;
      last_q <= and_359 ? (equal_1344 ? column : last_q) : last_q;
      least_q <= select_1417;
      first_beats_q <= and_359 ? select_1420 : first_beats_q;
      whole_beats_q <= select_1424;
      age_q <= select_1428;
      ends_q <= and_359 ? (and_1430 & not_1361) : and_1430;
      final_row_q <= and_359 ? select_1435 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1969}}, 1'b1} + run_beats_q;
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
  logic [2:0] age_s1_q;
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
  logic select_535_s1_q;
  logic equal_602_s1_q;
  logic and_925_s1_q;
  logic select_931_s1_q;
  logic equal_943_s1_q;
  logic not_974_s1_q;
  logic equal_1010_s1_q;
  logic not_1144_s1_q;
  logic equal_1344_s1_q;
  logic less_1623_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      age_s1_q <= {age_q[6], age_q[4:3]};
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
      select_535_s1_q <= or_533 ? equal_531 : (run_lowest_q == x);
      equal_602_s1_q <= run_lowest_q == x_q;
      and_925_s1_q <= not_381 & and_527;
      select_931_s1_q <= or_533 ? equal_531 : (run_highest_q == x);
      equal_943_s1_q <= run_phase_q == 3'h6;
      not_974_s1_q <= not_974;
      equal_1010_s1_q <= x_q == {2'h0, last_q};
      not_1144_s1_q <= ~({sum_1142, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1344_s1_q <= equal_1344;
      less_1623_s1_q <= {2'h0, sum_1622, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:414
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
  // hls/stages/agreement.hpp:415
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
  logic and_541;
  assign and_541 = left_rdata_q[44] & not_386_s1_q;
  logic [11:0] a;
  assign a = less_385_s1_q ? 12'h0 : left_rdata_q[43:32];
  logic [11:0] b;
  assign b = less_385_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_547;
  assign not_547 = ~(a ^ b);
  logic [1:0] sum_549;
  assign sum_549 = {1'b0, not_547[2]} + ({1'b0, not_547[0]} + {1'b0, not_547[1]});
  logic [2:0] sum_552;
  assign sum_552 = {2'h0, not_547[5]} + ({2'h0, not_547[4]} + ({2'h0, not_547[3]} + {1'b0, sum_549}));
  logic [2:0] sum_553;
  assign sum_553 = {2'h0, not_547[6]} + sum_552;
  logic [3:0] sum_556;
  assign sum_556 = {3'h0, not_547[9]} + ({3'h0, not_547[8]} + ({3'h0, not_547[7]} + {1'b0, sum_553}));
  // hls/stages/agreement.hpp:170
  logic [11:0] a_2;
  assign a_2 = less_385_s1_q ? 12'h0 : left_rdata_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_566;
  assign not_566 = ~(a_2 ^ b_2);
  logic [1:0] sum_568;
  assign sum_568 = {1'b0, not_566[2]} + ({1'b0, not_566[0]} + {1'b0, not_566[1]});
  logic [2:0] sum_571;
  assign sum_571 = {2'h0, not_566[5]} + ({2'h0, not_566[4]} + ({2'h0, not_566[3]} + {1'b0, sum_568}));
  logic [2:0] sum_572;
  assign sum_572 = {2'h0, not_566[6]} + sum_571;
  logic [3:0] sum_575;
  assign sum_575 = {3'h0, not_566[9]} + ({3'h0, not_566[8]} + ({3'h0, not_566[7]} + {1'b0, sum_572}));
  // hls/stages/agreement.hpp:170
  logic and_580;
  assign and_580 = left_rdata_q[76] & not_386_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_385_s1_q ? 12'h0 : left_rdata_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_586;
  assign not_586 = ~(a_3 ^ b_3);
  logic [1:0] sum_588;
  assign sum_588 = {1'b0, not_586[2]} + ({1'b0, not_586[0]} + {1'b0, not_586[1]});
  logic [2:0] sum_591;
  assign sum_591 = {2'h0, not_586[5]} + ({2'h0, not_586[4]} + ({2'h0, not_586[3]} + {1'b0, sum_588}));
  logic [2:0] sum_592;
  assign sum_592 = {2'h0, not_586[6]} + sum_591;
  logic [3:0] sum_595;
  assign sum_595 = {3'h0, not_586[9]} + ({3'h0, not_586[8]} + ({3'h0, not_586[7]} + {1'b0, sum_592}));
  logic [11:0] not_607;
  assign not_607 = ~(a ^ b_2);
  logic [1:0] sum_609;
  assign sum_609 = {1'b0, not_607[2]} + ({1'b0, not_607[0]} + {1'b0, not_607[1]});
  logic [2:0] sum_612;
  assign sum_612 = {2'h0, not_607[5]} + ({2'h0, not_607[4]} + ({2'h0, not_607[3]} + {1'b0, sum_609}));
  logic [2:0] sum_613;
  assign sum_613 = {2'h0, not_607[6]} + sum_612;
  logic [3:0] sum_616;
  assign sum_616 = {3'h0, not_607[9]} + ({3'h0, not_607[8]} + ({3'h0, not_607[7]} + {1'b0, sum_613}));
  logic [11:0] not_622;
  assign not_622 = ~(a_2 ^ b_3);
  logic [1:0] sum_624;
  assign sum_624 = {1'b0, not_622[2]} + ({1'b0, not_622[0]} + {1'b0, not_622[1]});
  logic [2:0] sum_627;
  assign sum_627 = {2'h0, not_622[5]} + ({2'h0, not_622[4]} + ({2'h0, not_622[3]} + {1'b0, sum_624}));
  logic [2:0] sum_628;
  assign sum_628 = {2'h0, not_622[6]} + sum_627;
  logic [3:0] sum_631;
  assign sum_631 = {3'h0, not_622[9]} + ({3'h0, not_622[8]} + ({3'h0, not_622[7]} + {1'b0, sum_628}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_4;
  assign b_4 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_640;
  assign not_640 = ~(a_3 ^ b_4);
  logic [1:0] sum_642;
  assign sum_642 = {1'b0, not_640[2]} + ({1'b0, not_640[0]} + {1'b0, not_640[1]});
  logic [2:0] sum_645;
  assign sum_645 = {2'h0, not_640[5]} + ({2'h0, not_640[4]} + ({2'h0, not_640[3]} + {1'b0, sum_642}));
  logic [2:0] sum_646;
  assign sum_646 = {2'h0, not_640[6]} + sum_645;
  logic [3:0] sum_649;
  assign sum_649 = {3'h0, not_640[9]} + ({3'h0, not_640[8]} + ({3'h0, not_640[7]} + {1'b0, sum_646}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_5;
  assign b_5 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_664;
  assign not_664 = ~(a ^ b_5);
  logic [1:0] sum_666;
  assign sum_666 = {1'b0, not_664[2]} + ({1'b0, not_664[0]} + {1'b0, not_664[1]});
  logic [2:0] sum_669;
  assign sum_669 = {2'h0, not_664[5]} + ({2'h0, not_664[4]} + ({2'h0, not_664[3]} + {1'b0, sum_666}));
  logic [2:0] sum_670;
  assign sum_670 = {2'h0, not_664[6]} + sum_669;
  logic [3:0] sum_673;
  assign sum_673 = {3'h0, not_664[9]} + ({3'h0, not_664[8]} + ({3'h0, not_664[7]} + {1'b0, sum_670}));
  logic [11:0] not_679;
  assign not_679 = ~(a_2 ^ b);
  logic [1:0] sum_681;
  assign sum_681 = {1'b0, not_679[2]} + ({1'b0, not_679[0]} + {1'b0, not_679[1]});
  logic [2:0] sum_684;
  assign sum_684 = {2'h0, not_679[5]} + ({2'h0, not_679[4]} + ({2'h0, not_679[3]} + {1'b0, sum_681}));
  logic [2:0] sum_685;
  assign sum_685 = {2'h0, not_679[6]} + sum_684;
  logic [3:0] sum_688;
  assign sum_688 = {3'h0, not_679[9]} + ({3'h0, not_679[8]} + ({3'h0, not_679[7]} + {1'b0, sum_685}));
  logic [11:0] not_695;
  assign not_695 = ~(a_3 ^ b_2);
  logic [1:0] sum_697;
  assign sum_697 = {1'b0, not_695[2]} + ({1'b0, not_695[0]} + {1'b0, not_695[1]});
  logic [2:0] sum_700;
  assign sum_700 = {2'h0, not_695[5]} + ({2'h0, not_695[4]} + ({2'h0, not_695[3]} + {1'b0, sum_697}));
  logic [2:0] sum_701;
  assign sum_701 = {2'h0, not_695[6]} + sum_700;
  logic [3:0] sum_704;
  assign sum_704 = {3'h0, not_695[9]} + ({3'h0, not_695[8]} + ({3'h0, not_695[7]} + {1'b0, sum_701}));
  logic [11:0] not_719;
  assign not_719 = ~(a ^ b_3);
  logic [1:0] sum_721;
  assign sum_721 = {1'b0, not_719[2]} + ({1'b0, not_719[0]} + {1'b0, not_719[1]});
  logic [2:0] sum_724;
  assign sum_724 = {2'h0, not_719[5]} + ({2'h0, not_719[4]} + ({2'h0, not_719[3]} + {1'b0, sum_721}));
  logic [2:0] sum_725;
  assign sum_725 = {2'h0, not_719[6]} + sum_724;
  logic [3:0] sum_728;
  assign sum_728 = {3'h0, not_719[9]} + ({3'h0, not_719[8]} + ({3'h0, not_719[7]} + {1'b0, sum_725}));
  logic [11:0] not_734;
  assign not_734 = ~(a_2 ^ b_4);
  logic [1:0] sum_736;
  assign sum_736 = {1'b0, not_734[2]} + ({1'b0, not_734[0]} + {1'b0, not_734[1]});
  logic [2:0] sum_739;
  assign sum_739 = {2'h0, not_734[5]} + ({2'h0, not_734[4]} + ({2'h0, not_734[3]} + {1'b0, sum_736}));
  logic [2:0] sum_740;
  assign sum_740 = {2'h0, not_734[6]} + sum_739;
  logic [3:0] sum_743;
  assign sum_743 = {3'h0, not_734[9]} + ({3'h0, not_734[8]} + ({3'h0, not_734[7]} + {1'b0, sum_740}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_6;
  assign b_6 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_752;
  assign not_752 = ~(a_3 ^ b_6);
  logic [1:0] sum_754;
  assign sum_754 = {1'b0, not_752[2]} + ({1'b0, not_752[0]} + {1'b0, not_752[1]});
  logic [2:0] sum_757;
  assign sum_757 = {2'h0, not_752[5]} + ({2'h0, not_752[4]} + ({2'h0, not_752[3]} + {1'b0, sum_754}));
  logic [2:0] sum_758;
  assign sum_758 = {2'h0, not_752[6]} + sum_757;
  logic [3:0] sum_761;
  assign sum_761 = {3'h0, not_752[9]} + ({3'h0, not_752[8]} + ({3'h0, not_752[7]} + {1'b0, sum_758}));
  // hls/stages/agreement.hpp:170
  logic [11:0] b_7;
  assign b_7 = less_385_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:424
  logic [11:0] not_781;
  assign not_781 = ~(a ^ b_7);
  logic [1:0] sum_783;
  assign sum_783 = {1'b0, not_781[2]} + ({1'b0, not_781[0]} + {1'b0, not_781[1]});
  logic [2:0] sum_786;
  assign sum_786 = {2'h0, not_781[5]} + ({2'h0, not_781[4]} + ({2'h0, not_781[3]} + {1'b0, sum_783}));
  logic [2:0] sum_787;
  assign sum_787 = {2'h0, not_781[6]} + sum_786;
  logic [3:0] sum_790;
  assign sum_790 = {3'h0, not_781[9]} + ({3'h0, not_781[8]} + ({3'h0, not_781[7]} + {1'b0, sum_787}));
  logic [11:0] not_796;
  assign not_796 = ~(a_2 ^ b_5);
  logic [1:0] sum_798;
  assign sum_798 = {1'b0, not_796[2]} + ({1'b0, not_796[0]} + {1'b0, not_796[1]});
  logic [2:0] sum_801;
  assign sum_801 = {2'h0, not_796[5]} + ({2'h0, not_796[4]} + ({2'h0, not_796[3]} + {1'b0, sum_798}));
  logic [2:0] sum_802;
  assign sum_802 = {2'h0, not_796[6]} + sum_801;
  logic [3:0] sum_805;
  assign sum_805 = {3'h0, not_796[9]} + ({3'h0, not_796[8]} + ({3'h0, not_796[7]} + {1'b0, sum_802}));
  logic [11:0] not_812;
  assign not_812 = ~(a_3 ^ b);
  logic [1:0] sum_814;
  assign sum_814 = {1'b0, not_812[2]} + ({1'b0, not_812[0]} + {1'b0, not_812[1]});
  logic [2:0] sum_817;
  assign sum_817 = {2'h0, not_812[5]} + ({2'h0, not_812[4]} + ({2'h0, not_812[3]} + {1'b0, sum_814}));
  logic [2:0] sum_818;
  assign sum_818 = {2'h0, not_812[6]} + sum_817;
  logic [3:0] sum_821;
  assign sum_821 = {3'h0, not_812[9]} + ({3'h0, not_812[8]} + ({3'h0, not_812[7]} + {1'b0, sum_818}));
  // hls/stages/agreement.hpp:504
  logic [5:0] partner;
  assign partner = run_shift_s1_q + x_s1_2_q[5:0];
  // hls/stages/agreement.hpp:610
  logic and_947;
  assign and_947 = left_rdata_q[61] & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:343
  logic and_1146;
  assign and_1146 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1144_s1_q);
  // hls/stages/agreement.hpp:290
  logic select_1440;
  assign select_1440 = equal_1344_s1_q ? (~({row_s1_q, 1'b0} < {sum_1437, cfg_height_i[3]})) : lower_half_q;

  // Memory best_right, 47 x 15, DISTANCE 12, hls/stages/agreement.hpp:920; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 15'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_380_s1_q ? (x_s1_q[5:0] + best_left_rdata_q[13:8]) : partner;
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
      row_q <= and_359_s1_q ? (equal_1344_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_359_s1_q ? select_1440 : lower_half_q;
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
  logic [2:0] age_s2_q;
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
  logic [6:0] x_s2_2_q;
  logic select_528_s2_q;
  logic [34:0] best_left_rdata_s2_q;
  logic select_535_s2_q;
  logic and_541_s2_q;
  logic and_542_s2_q;
  logic not_547_s2_q;
  logic [3:0] sum_557_s2_q;
  logic and_560_s2_q;
  logic and_561_s2_q;
  logic not_566_s2_q;
  logic [3:0] sum_576_s2_q;
  logic and_580_s2_q;
  logic and_581_s2_q;
  logic not_586_s2_q;
  logic [3:0] sum_596_s2_q;
  logic equal_602_s2_q;
  logic not_607_s2_q;
  logic [3:0] sum_617_s2_q;
  logic not_622_s2_q;
  logic [3:0] sum_632_s2_q;
  logic and_636_s2_q;
  logic not_640_s2_q;
  logic [3:0] sum_650_s2_q;
  logic and_660_s2_q;
  logic not_664_s2_q;
  logic [3:0] sum_674_s2_q;
  logic not_679_s2_q;
  logic [3:0] sum_689_s2_q;
  logic not_695_s2_q;
  logic [3:0] sum_705_s2_q;
  logic not_719_s2_q;
  logic [3:0] sum_729_s2_q;
  logic not_734_s2_q;
  logic [3:0] sum_744_s2_q;
  logic and_749_s2_q;
  logic not_752_s2_q;
  logic [3:0] sum_762_s2_q;
  logic and_778_s2_q;
  logic not_781_s2_q;
  logic [3:0] sum_791_s2_q;
  logic not_796_s2_q;
  logic [3:0] sum_806_s2_q;
  logic not_812_s2_q;
  logic [3:0] sum_822_s2_q;
  logic and_925_s2_q;
  logic [5:0] partner_s2_q;
  logic select_931_s2_q;
  logic equal_943_s2_q;
  logic and_948_s2_q;
  logic and_949_s2_q;
  logic and_951_s2_q;
  logic not_974_s2_q;
  logic equal_1010_s2_q;
  logic and_1057_s2_q;
  logic and_1146_s2_q;
  logic equal_1292_s2_q;
  logic equal_1344_s2_q;
  logic less_1621_s2_q;
  logic less_1623_s2_q;
  logic equal_1887_s2_q;
  logic less_1898_s2_q;
  logic equal_2041_s2_q;
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
      x_s2_2_q <= x_s1_2_q;
      select_528_s2_q <= select_528_s1_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_535_s2_q <= select_535_s1_q;
      and_541_s2_q <= and_541;
      and_542_s2_q <= right_codes_rdata_q[38] & not_386_s1_q;
      not_547_s2_q <= not_547[11];
      sum_557_s2_q <= {3'h0, not_547[10]} + sum_556;
      and_560_s2_q <= left_rdata_q[60] & not_386_s1_q;
      and_561_s2_q <= right_codes_rdata_q[51] & not_386_s1_q;
      not_566_s2_q <= not_566[11];
      sum_576_s2_q <= {3'h0, not_566[10]} + sum_575;
      and_580_s2_q <= and_580;
      and_581_s2_q <= right_codes_rdata_q[64] & not_386_s1_q;
      not_586_s2_q <= not_586[11];
      sum_596_s2_q <= {3'h0, not_586[10]} + sum_595;
      equal_602_s2_q <= equal_602_s1_q;
      not_607_s2_q <= not_607[11];
      sum_617_s2_q <= {3'h0, not_607[10]} + sum_616;
      not_622_s2_q <= not_622[11];
      sum_632_s2_q <= {3'h0, not_622[10]} + sum_631;
      and_636_s2_q <= right_codes_rdata_q[77] & not_386_s1_q;
      not_640_s2_q <= not_640[11];
      sum_650_s2_q <= {3'h0, not_640[10]} + sum_649;
      and_660_s2_q <= right_codes_rdata_q[25] & not_386_s1_q;
      not_664_s2_q <= not_664[11];
      sum_674_s2_q <= {3'h0, not_664[10]} + sum_673;
      not_679_s2_q <= not_679[11];
      sum_689_s2_q <= {3'h0, not_679[10]} + sum_688;
      not_695_s2_q <= not_695[11];
      sum_705_s2_q <= {3'h0, not_695[10]} + sum_704;
      not_719_s2_q <= not_719[11];
      sum_729_s2_q <= {3'h0, not_719[10]} + sum_728;
      not_734_s2_q <= not_734[11];
      sum_744_s2_q <= {3'h0, not_734[10]} + sum_743;
      and_749_s2_q <= and_580 & (right_codes_rdata_q[90] & not_386_s1_q);
      not_752_s2_q <= not_752[11];
      sum_762_s2_q <= {3'h0, not_752[10]} + sum_761;
      and_778_s2_q <= and_541 & (right_codes_rdata_q[12] & not_386_s1_q);
      not_781_s2_q <= not_781[11];
      sum_791_s2_q <= {3'h0, not_781[10]} + sum_790;
      not_796_s2_q <= not_796[11];
      sum_806_s2_q <= {3'h0, not_796[10]} + sum_805;
      not_812_s2_q <= not_812[11];
      sum_822_s2_q <= {3'h0, not_812[10]} + sum_821;
      and_925_s2_q <= and_925_s1_q;
      partner_s2_q <= partner;
      select_931_s2_q <= select_931_s1_q;
      equal_943_s2_q <= equal_943_s1_q;
      and_948_s2_q <= not_386_s1_q & and_947;
      and_949_s2_q <= left_rdata_q[62] & and_947;
      and_951_s2_q <= left_rdata_q[63] & not_386_s1_q;
      not_974_s2_q <= not_974_s1_q;
      equal_1010_s2_q <= equal_1010_s1_q;
      and_1057_s2_q <= sample_pair_whole_q;
      and_1146_s2_q <= and_1146;
      equal_1292_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_1344_s2_q <= equal_1344_s1_q;
      less_1621_s2_q <= 5'h4 < row_q[5:1];
      less_1623_s2_q <= less_1623_s1_q;
      equal_1887_s2_q <= row_s1_q[5:2] == 4'h0;
      less_1898_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2041_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic and_334;
  assign and_334 = sample_pair_whole_s2_q & and_333_s2_q;
  // hls/stages/agreement.hpp:424
  logic [3:0] column_2;
  assign column_2 = (and_541_s2_q & and_542_s2_q) ? ({3'h0, not_547_s2_q} + sum_557_s2_q) : 4'h0;
  logic [3:0] select_578;
  assign select_578 = (and_560_s2_q & and_561_s2_q) ? ({3'h0, not_566_s2_q} + sum_576_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_3;
  assign column_3 = {1'b0, column_2} + {1'b0, select_578};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_598;
  assign select_598 = (and_580_s2_q & and_581_s2_q) ? ({3'h0, not_586_s2_q} + sum_596_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_4;
  assign column_4 = {1'b0, column_3} + {2'h0, select_598};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_601;
  assign difference_601 = {2'h0, column_4} - (age_s2_q[2] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_604;
  assign sum_604 = difference_601 + (equal_602_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:424
  logic [3:0] column_5;
  assign column_5 = (and_541_s2_q & and_561_s2_q) ? ({3'h0, not_607_s2_q} + sum_617_s2_q) : 4'h0;
  logic [3:0] select_634;
  assign select_634 = (and_560_s2_q & and_581_s2_q) ? ({3'h0, not_622_s2_q} + sum_632_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_6;
  assign column_6 = {1'b0, column_5} + {1'b0, select_634};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_652;
  assign select_652 = (and_580_s2_q & and_636_s2_q) ? ({3'h0, not_640_s2_q} + sum_650_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_7;
  assign column_7 = {1'b0, column_6} + {2'h0, select_652};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_655;
  assign difference_655 = {2'h0, column_7} - (age_s2_q[2] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_657;
  assign sum_657 = difference_655 + (equal_602_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:478
  logic less_658;
  assign less_658 = sum_604 < sum_657;
  // hls/stages/agreement.hpp:424
  logic [3:0] column_8;
  assign column_8 = (and_541_s2_q & and_660_s2_q) ? ({3'h0, not_664_s2_q} + sum_674_s2_q) : 4'h0;
  logic [3:0] select_691;
  assign select_691 = (and_560_s2_q & and_542_s2_q) ? ({3'h0, not_679_s2_q} + sum_689_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_9;
  assign column_9 = {1'b0, column_8} + {1'b0, select_691};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_707;
  assign select_707 = (and_580_s2_q & and_561_s2_q) ? ({3'h0, not_695_s2_q} + sum_705_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_10;
  assign column_10 = {1'b0, column_9} + {2'h0, select_707};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_710;
  assign difference_710 = {2'h0, column_10} - (age_s2_q[2] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_712;
  assign sum_712 = difference_710 + (equal_602_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:478
  logic not_714;
  assign not_714 = ~less_658;
  logic [1:0] best;
  assign best = ((less_658 ? sum_657 : sum_604) < sum_712) ? 2'h3 : {not_714, less_658};
  // hls/stages/agreement.hpp:424
  logic [3:0] column_11;
  assign column_11 = (and_541_s2_q & and_581_s2_q) ? ({3'h0, not_719_s2_q} + sum_729_s2_q) : 4'h0;
  logic [3:0] select_746;
  assign select_746 = (and_560_s2_q & and_636_s2_q) ? ({3'h0, not_734_s2_q} + sum_744_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_12;
  assign column_12 = {1'b0, column_11} + {1'b0, select_746};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_764;
  assign select_764 = and_749_s2_q ? ({3'h0, not_752_s2_q} + sum_762_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_13;
  assign column_13 = {1'b0, column_12} + {2'h0, select_764};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_767;
  assign difference_767 = {2'h0, column_13} - (age_s2_q[2] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_769;
  assign sum_769 = difference_767 + (equal_602_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:478
  logic [7:0] select_771;
  assign select_771 = best[1] ? (best[0] ? sum_712 : sum_604) : (best[0] ? sum_657 : sum_769);
  logic [1:0] best_2;
  assign best_2 = (select_771 < sum_769) ? 2'h0 : best;
  // hls/stages/agreement.hpp:424
  logic [3:0] column_14;
  assign column_14 = and_778_s2_q ? ({3'h0, not_781_s2_q} + sum_791_s2_q) : 4'h0;
  logic [3:0] select_808;
  assign select_808 = (and_560_s2_q & and_660_s2_q) ? ({3'h0, not_796_s2_q} + sum_806_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [4:0] column_15;
  assign column_15 = {1'b0, column_14} + {1'b0, select_808};
  // hls/stages/agreement.hpp:424
  logic [3:0] select_824;
  assign select_824 = (and_580_s2_q & and_542_s2_q) ? ({3'h0, not_812_s2_q} + sum_822_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:461
  logic [5:0] column_16;
  assign column_16 = {1'b0, column_15} + {2'h0, select_824};
  // hls/stages/agreement.hpp:463
  logic [7:0] difference_827;
  assign difference_827 = {2'h0, column_16} - (age_s2_q[2] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_829;
  assign sum_829 = difference_827 + (equal_602_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_888;
  assign sum_888 = (age_s2_q[0] ? sums_2_columns_values_3_q[6:0] : 7'h0) + (sums_2_columns_values_1_q[6:0] + sums_2_columns_values_2_q[6:0]);
  logic [6:0] sum_891;
  assign sum_891 = (age_s2_q[0] ? sums_1_columns_values_3_q[6:0] : 7'h0) + (sums_1_columns_values_1_q[6:0] + sums_1_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:478
  logic less_892;
  assign less_892 = sum_888 < sum_891;
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_896;
  assign sum_896 = (age_s2_q[0] ? sums_3_columns_values_3_q[6:0] : 7'h0) + (sums_3_columns_values_1_q[6:0] + sums_3_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:478
  logic not_898;
  assign not_898 = ~less_892;
  logic [1:0] best_3;
  assign best_3 = ((less_892 ? sum_891 : sum_888) < sum_896) ? 2'h3 : {not_898, less_892};
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_903;
  assign sum_903 = (age_s2_q[0] ? sums_0_columns_values_3_q[6:0] : 7'h0) + (sums_0_columns_values_1_q[6:0] + sums_0_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:478
  logic [6:0] select_905;
  assign select_905 = best_3[1] ? (best_3[0] ? sum_896 : sum_888) : (best_3[0] ? sum_891 : sum_903);
  logic [1:0] best_4;
  assign best_4 = (select_905 < sum_903) ? 2'h0 : best_3;
  logic [6:0] select_910;
  assign select_910 = best_4[1] ? (best_4[0] ? sum_896 : sum_888) : (best_4[0] ? sum_891 : sum_903);
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_913;
  assign sum_913 = (age_s2_q[0] ? sums_4_columns_values_3_q[6:0] : 7'h0) + (sums_4_columns_values_1_q[6:0] + sums_4_columns_values_2_q[6:0]);
  // hls/stages/agreement.hpp:478
  logic less_914;
  assign less_914 = select_910 < sum_913;
  logic [1:0] select_915;
  assign select_915 = less_914 ? 2'h0 : best_4;
  // hls/stages/agreement.hpp:487
  logic [6:0] select_918;
  assign select_918 = select_915[1] ? (select_915[0] ? sum_896 : sum_888) : (select_915[0] ? sum_891 : sum_903);
  logic [6:0] of_near;
  assign of_near = less_914 ? sum_913 : select_918;
  // hls/stages/agreement.hpp:606
  logic [5:0] sum_936;
  assign sum_936 = x_s2_q[5:0] + best_left_rdata_s2_q[34:29];
  // hls/stages/agreement.hpp:621
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:622
  logic [9:0] sum_953;
  assign sum_953 = {way[8], way} + 10'h1;
  // hls/stages/agreement.hpp:613
  logic and_956;
  assign and_956 = ({{6{sum_953[9]}}, sum_953} < 16'h3) & (8'hb6 < best_left_rdata_s2_q[7:0]);
  // hls/stages/agreement.hpp:625
  logic and_961;
  assign and_961 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s2_q[13:8]));
  // hls/stages/agreement.hpp:174
  logic and_963;
  assign and_963 = and_956 & ((cfg_nearer_below_i & best_left_rdata_s2_q[13]) | and_961);
  // hls/stages/agreement.hpp:343
  logic [5:0] select_973;
  assign select_973 = drew_s2_q ? x_s2_q[5:0] : (or_380_s2_q ? (less_385_s2_q ? 6'h0 : sum_936) : 6'h0);
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1443;
  assign select_1443 = or_380_s2_q ? sums_0_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_13} : sums_0_columns_values_0_q);
  logic [7:0] select_1444;
  assign select_1444 = equal_382_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1446;
  assign select_1446 = equal_382_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1448;
  assign select_1448 = equal_382_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1450;
  assign select_1450 = equal_382_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1452;
  assign select_1452 = equal_382_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1454;
  assign select_1454 = equal_382_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1457;
  assign select_1457 = or_380_s2_q ? sums_0_sum_sums_values_0_q : (equal_382_s2_q ? sum_769 : sums_0_sum_sums_values_0_q);
  logic [7:0] select_1459;
  assign select_1459 = or_380_s2_q ? sums_1_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_7} : sums_1_columns_values_0_q);
  logic [7:0] select_1460;
  assign select_1460 = equal_382_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1462;
  assign select_1462 = equal_382_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1464;
  assign select_1464 = equal_382_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1466;
  assign select_1466 = equal_382_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1468;
  assign select_1468 = equal_382_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1470;
  assign select_1470 = equal_382_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1473;
  assign select_1473 = or_380_s2_q ? sums_1_sum_sums_values_0_q : (equal_382_s2_q ? sum_657 : sums_1_sum_sums_values_0_q);
  logic [7:0] select_1475;
  assign select_1475 = or_380_s2_q ? sums_2_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_4} : sums_2_columns_values_0_q);
  logic [7:0] select_1476;
  assign select_1476 = equal_382_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1478;
  assign select_1478 = equal_382_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1480;
  assign select_1480 = equal_382_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1482;
  assign select_1482 = equal_382_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1484;
  assign select_1484 = equal_382_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1486;
  assign select_1486 = equal_382_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1489;
  assign select_1489 = or_380_s2_q ? sums_2_sum_sums_values_0_q : (equal_382_s2_q ? sum_604 : sums_2_sum_sums_values_0_q);
  logic [7:0] select_1491;
  assign select_1491 = or_380_s2_q ? sums_3_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_10} : sums_3_columns_values_0_q);
  logic [7:0] select_1492;
  assign select_1492 = equal_382_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1494;
  assign select_1494 = equal_382_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1496;
  assign select_1496 = equal_382_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1498;
  assign select_1498 = equal_382_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1500;
  assign select_1500 = equal_382_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1502;
  assign select_1502 = equal_382_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1505;
  assign select_1505 = or_380_s2_q ? sums_3_sum_sums_values_0_q : (equal_382_s2_q ? sum_712 : sums_3_sum_sums_values_0_q);
  logic [7:0] select_1507;
  assign select_1507 = or_380_s2_q ? sums_4_columns_values_0_q : (equal_382_s2_q ? {2'h0, column_16} : sums_4_columns_values_0_q);
  logic [7:0] select_1508;
  assign select_1508 = equal_382_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1510;
  assign select_1510 = equal_382_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1512;
  assign select_1512 = equal_382_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1514;
  assign select_1514 = equal_382_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1516;
  assign select_1516 = equal_382_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1518;
  assign select_1518 = equal_382_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  logic [7:0] select_1521;
  assign select_1521 = or_380_s2_q ? sums_4_sum_sums_values_0_q : (equal_382_s2_q ? sum_829 : sums_4_sum_sums_values_0_q);

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

  // Memory near_right, 47 x 14, DISTANCE 12, hls/stages/agreement.hpp:921; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [13:0] near_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) near_right_mem[i] = 14'h0;
`endif
  logic [5:0] near_right_raddr;
  assign near_right_raddr = or_380_s2_q ? sum_936 : partner_s2_q;
  logic near_right_re;
  assign near_right_re = s2_en & select_528_s2_q;
  logic [13:0] near_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (near_right_re) near_right_rdata_q <= near_right_mem[near_right_raddr];
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
      sums_0_columns_values_0_q <= select_1443;
      sums_0_columns_values_1_q <= or_380_s2_q ? sums_0_columns_values_1_q : select_1444;
      sums_0_columns_values_2_q <= or_380_s2_q ? sums_0_columns_values_2_q : select_1446;
      sums_0_columns_values_3_q <= or_380_s2_q ? sums_0_columns_values_3_q : select_1448;
      sums_0_columns_values_4_q <= or_380_s2_q ? sums_0_columns_values_4_q : select_1450;
      sums_0_columns_values_5_q <= or_380_s2_q ? sums_0_columns_values_5_q : select_1452;
      sums_0_columns_values_6_q <= or_380_s2_q ? sums_0_columns_values_6_q : select_1454;
      sums_0_sum_sums_values_0_q <= select_1457;
      sums_1_columns_values_0_q <= select_1459;
      sums_1_columns_values_1_q <= or_380_s2_q ? sums_1_columns_values_1_q : select_1460;
      sums_1_columns_values_2_q <= or_380_s2_q ? sums_1_columns_values_2_q : select_1462;
      sums_1_columns_values_3_q <= or_380_s2_q ? sums_1_columns_values_3_q : select_1464;
      sums_1_columns_values_4_q <= or_380_s2_q ? sums_1_columns_values_4_q : select_1466;
      sums_1_columns_values_5_q <= or_380_s2_q ? sums_1_columns_values_5_q : select_1468;
      sums_1_columns_values_6_q <= or_380_s2_q ? sums_1_columns_values_6_q : select_1470;
      sums_1_sum_sums_values_0_q <= select_1473;
      sums_2_columns_values_0_q <= select_1475;
      sums_2_columns_values_1_q <= or_380_s2_q ? sums_2_columns_values_1_q : select_1476;
      sums_2_columns_values_2_q <= or_380_s2_q ? sums_2_columns_values_2_q : select_1478;
      sums_2_columns_values_3_q <= or_380_s2_q ? sums_2_columns_values_3_q : select_1480;
      sums_2_columns_values_4_q <= or_380_s2_q ? sums_2_columns_values_4_q : select_1482;
      sums_2_columns_values_5_q <= or_380_s2_q ? sums_2_columns_values_5_q : select_1484;
      sums_2_columns_values_6_q <= or_380_s2_q ? sums_2_columns_values_6_q : select_1486;
      sums_2_sum_sums_values_0_q <= select_1489;
      sums_3_columns_values_0_q <= select_1491;
      sums_3_columns_values_1_q <= or_380_s2_q ? sums_3_columns_values_1_q : select_1492;
      sums_3_columns_values_2_q <= or_380_s2_q ? sums_3_columns_values_2_q : select_1494;
      sums_3_columns_values_3_q <= or_380_s2_q ? sums_3_columns_values_3_q : select_1496;
      sums_3_columns_values_4_q <= or_380_s2_q ? sums_3_columns_values_4_q : select_1498;
      sums_3_columns_values_5_q <= or_380_s2_q ? sums_3_columns_values_5_q : select_1500;
      sums_3_columns_values_6_q <= or_380_s2_q ? sums_3_columns_values_6_q : select_1502;
      sums_3_sum_sums_values_0_q <= select_1505;
      sums_4_columns_values_0_q <= select_1507;
      sums_4_columns_values_1_q <= or_380_s2_q ? sums_4_columns_values_1_q : select_1508;
      sums_4_columns_values_2_q <= or_380_s2_q ? sums_4_columns_values_2_q : select_1510;
      sums_4_columns_values_3_q <= or_380_s2_q ? sums_4_columns_values_3_q : select_1512;
      sums_4_columns_values_4_q <= or_380_s2_q ? sums_4_columns_values_4_q : select_1514;
      sums_4_columns_values_5_q <= or_380_s2_q ? sums_4_columns_values_5_q : select_1516;
      sums_4_columns_values_6_q <= or_380_s2_q ? sums_4_columns_values_6_q : select_1518;
      sums_4_sum_sums_values_0_q <= select_1521;
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
  logic equal_379_s3_q;
  logic or_380_s3_q;
  logic less_385_s3_q;
  logic not_386_s3_q;
  logic equal_418_s3_q;
  logic [6:0] x_s3_2_q;
  logic [34:0] best_left_rdata_s3_q;
  logic select_535_s3_q;
  logic [7:0] sum_604_s3_q;
  logic [7:0] sum_657_s3_q;
  logic [7:0] sum_712_s3_q;
  logic [7:0] sum_769_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_829_s3_q;
  logic [6:0] of_near_s3_q;
  logic and_925_s3_q;
  logic [5:0] partner_s3_q;
  logic [14:0] best_right_rdata_s3_q;
  logic select_931_s3_q;
  logic equal_943_s3_q;
  logic and_948_s3_q;
  logic and_949_s3_q;
  logic and_951_s3_q;
  logic and_958_s3_q;
  logic and_965_s3_q;
  logic [5:0] select_973_s3_q;
  logic not_974_s3_q;
  logic equal_1010_s3_q;
  logic and_1057_s3_q;
  logic and_1146_s3_q;
  logic equal_1292_s3_q;
  logic equal_1344_s3_q;
  logic less_1621_s3_q;
  logic less_1623_s3_q;
  logic equal_1887_s3_q;
  logic less_1898_s3_q;
  logic equal_2041_s3_q;
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
      age_s3_q <= age_s2_q[1];
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
      equal_379_s3_q <= equal_379_s2_q;
      or_380_s3_q <= or_380_s2_q;
      less_385_s3_q <= less_385_s2_q;
      not_386_s3_q <= not_386_s2_q;
      equal_418_s3_q <= equal_418_s2_q;
      x_s3_2_q <= x_s2_2_q;
      best_left_rdata_s3_q <= best_left_rdata_s2_q;
      select_535_s3_q <= select_535_s2_q;
      sum_604_s3_q <= sum_604;
      sum_657_s3_q <= sum_657;
      sum_712_s3_q <= sum_712;
      sum_769_s3_q <= sum_769;
      best_2_s3_q <= best_2;
      sum_829_s3_q <= sum_829;
      of_near_s3_q <= of_near;
      and_925_s3_q <= and_925_s2_q;
      partner_s3_q <= partner_s2_q;
      best_right_rdata_s3_q <= best_right_rdata_q;
      select_931_s3_q <= select_931_s2_q;
      equal_943_s3_q <= equal_943_s2_q;
      and_948_s3_q <= and_948_s2_q;
      and_949_s3_q <= and_949_s2_q;
      and_951_s3_q <= and_951_s2_q;
      and_958_s3_q <= not_386_s2_q & (and_949_s2_q & and_956);
      and_965_s3_q <= not_386_s2_q & (and_949_s2_q & and_963);
      select_973_s3_q <= select_973;
      not_974_s3_q <= not_974_s2_q;
      equal_1010_s3_q <= equal_1010_s2_q;
      and_1057_s3_q <= and_1057_s2_q;
      and_1146_s3_q <= and_1146_s2_q;
      equal_1292_s3_q <= equal_1292_s2_q;
      equal_1344_s3_q <= equal_1344_s2_q;
      less_1621_s3_q <= less_1621_s2_q;
      less_1623_s3_q <= less_1623_s2_q;
      equal_1887_s3_q <= equal_1887_s2_q;
      less_1898_s3_q <= less_1898_s2_q;
      equal_2041_s3_q <= equal_2041_s2_q;
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
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [23:0] registration_next_slope_row_q;
  logic [27:0] registration_next_slope_change_q;
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
  // hls/stages/agreement.hpp:470
  logic not_537;
  assign not_537 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_538;
  assign less_538 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:170
  logic and_540;
  assign and_540 = not_537 & (~less_538);
  // hls/stages/agreement.hpp:478
  logic [7:0] select_776;
  assign select_776 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_712_s3_q : sum_604_s3_q) : (best_2_s3_q[0] ? sum_657_s3_q : sum_769_s3_q);
  logic less_830;
  assign less_830 = select_776 < sum_829_s3_q;
  logic [1:0] select_831;
  assign select_831 = less_830 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:486
  logic [7:0] select_834;
  assign select_834 = select_831[1] ? (select_831[0] ? sum_712_s3_q : sum_604_s3_q) : (select_831[0] ? sum_657_s3_q : sum_769_s3_q);
  logic [7:0] of_best;
  assign of_best = less_830 ? sum_829_s3_q : select_834;
  logic [7:0] of_best_2;
  assign of_best_2 = and_540 ? of_best : 8'h0;
  // hls/stages/agreement.hpp:493
  logic or_838;
  assign or_838 = select_535_s3_q | (best_left_rdata_s3_q[7:0] < of_best_2);
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_830, select_831} == 3'h4) ? 3'h3 : (({less_830, select_831} == 3'h0) ? 3'h1 : {less_830, select_831});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_846;
  assign sum_846 = near_best + 3'h1;
  logic [7:0] select_849;
  assign select_849 = sum_846[1] ? (sum_846[0] ? sum_712_s3_q : sum_604_s3_q) : (sum_846[0] ? sum_657_s3_q : sum_769_s3_q);
  logic [7:0] below;
  assign below = sum_846[2] ? sum_829_s3_q : select_849;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_851;
  assign sum_851 = near_best + 3'h7;
  logic [7:0] select_854;
  assign select_854 = sum_851[1] ? (sum_851[0] ? sum_712_s3_q : sum_604_s3_q) : (sum_851[0] ? sum_657_s3_q : sum_769_s3_q);
  logic [7:0] above;
  assign above = sum_851[2] ? sum_829_s3_q : select_854;
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/registration.hpp:26
  logic [7:0] select_860;
  assign select_860 = near_best[1] ? (near_best[0] ? sum_712_s3_q : sum_604_s3_q) : (near_best[0] ? sum_657_s3_q : sum_769_s3_q);
  logic [7:0] select_861;
  assign select_861 = near_best[2] ? sum_829_s3_q : select_860;
  logic [7:0] select_862;
  assign select_862 = rise[8] ? below : above;
  logic [8:0] fall;
  assign fall = {1'b0, select_861} - {1'b0, select_862};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [7:0] xor_865;
  assign xor_865 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_865};
  // hls/stages/agreement.hpp:487
  logic [6:0] of_near_2;
  assign of_near_2 = and_540 ? of_near_s3_q : 7'h0;
  // hls/stages/agreement.hpp:498
  logic or_922;
  assign or_922 = select_535_s3_q | (best_left_rdata_s3_q[28:22] < of_near_2);
  // hls/stages/agreement.hpp:507
  logic or_933;
  assign or_933 = select_931_s3_q | (best_right_rdata_s3_q[7:0] < of_best_2);
  // hls/stages/agreement.hpp:508
  logic [7:0] select_934;
  assign select_934 = or_933 ? of_best_2 : best_right_rdata_s3_q[7:0];
  logic [6:0] select_935;
  assign select_935 = or_933 ? x_s3_2_q : best_right_rdata_s3_q[14:8];
  // hls/stages/agreement.hpp:510
  logic or_940;
  assign or_940 = select_931_s3_q | (near_right_rdata_q[6:0] < of_near_2);
  // hls/stages/agreement.hpp:511
  logic [6:0] select_941;
  assign select_941 = or_940 ? of_near_2 : near_right_rdata_q[6:0];
  logic [6:0] select_942;
  assign select_942 = or_940 ? x_s3_2_q : near_right_rdata_q[13:7];
  // hls/stages/agreement.hpp:635
  logic not_944;
  assign not_944 = ~equal_943_s3_q;
  // hls/stages/agreement.hpp:618
  logic and_950;
  assign and_950 = not_386_s3_q & and_949_s3_q;
  // hls/stages/agreement.hpp:181
  logic [5:0] select_966;
  assign select_966 = less_385_s3_q ? 6'h0 : best_left_rdata_s3_q[13:8];
  logic [11:0] select_967;
  assign select_967 = or_380_s3_q ? {select_966, and_965_s3_q, and_958_s3_q, and_951_s3_q, and_950, and_948_s3_q, not_386_s3_q} : 12'h0;
  // hls/stages/agreement.hpp:343
  logic and_969;
  assign and_969 = not_944 & (drew_s3_q & select_967[0]);
  // hls/stages/agreement.hpp:621
  logic [8:0] way_2;
  assign way_2 = {2'h0, near_right_rdata_q[13:7]} - {1'b0, x_s3_q};
  // hls/stages/agreement.hpp:622
  logic [9:0] sum_976;
  assign sum_976 = {way_2[8], way_2} + 10'h1;
  // hls/stages/agreement.hpp:615
  logic and_979;
  assign and_979 = ({{6{sum_976[9]}}, sum_976} < 16'h3) & (6'h2a < best_left_rdata_s3_q[28:23]);
  // hls/stages/agreement.hpp:625
  logic and_982;
  assign and_982 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s3_q[34:29]));
  // hls/stages/agreement.hpp:174
  logic and_984;
  assign and_984 = and_979 & ((cfg_nearer_below_i & best_left_rdata_s3_q[34]) | and_982);
  // hls/stages/agreement.hpp:181
  logic and_991;
  assign and_991 = or_380_s3_q & (not_386_s3_q & (and_949_s3_q & and_979));
  // hls/stages/agreement.hpp:343
  logic and_994;
  assign and_994 = not_944 & (drew_s3_q ? select_967[0] : (equal_379_s3_q & and_991));
  // hls/stages/agreement.hpp:204
  logic select_1205;
  assign select_1205 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_1207;
  assign select_1207 = sample_pair_whole_s3_q ? (and_357_s3_q ? select_372 : averager_mask_q) : averager_mask_q;
  logic select_1209;
  assign select_1209 = sample_pair_whole_s3_q ? (and_357_s3_q ? select_376 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/registration.hpp:158
  logic [16:0] select_1630;
  assign select_1630 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [13:0] select_1632;
  assign select_1632 = ($signed(10'h0) < $signed(select_1630[16:7])) ? 14'h7f : select_1630[13:0];
  // hls/stages/registration.hpp:153
  logic [9:0] select_1633;
  assign select_1633 = select_967[10] ? select_1632[9:0] : 10'h0;
  logic [8:0] difference_1635;
  assign difference_1635 = select_1633[9:1] - (select_967[11] ? select_1632[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1638;
  assign sum_1638 = (select_967[6] ? select_1632[13:1] : 13'h0) + (select_967[7] ? select_1632[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1639;
  assign select_1639 = select_967[8] ? select_1632[11:0] : 12'h0;
  logic [10:0] sum_1641;
  assign sum_1641 = select_1639[11:1] + (select_967[9] ? select_1632[10:0] : 11'h0);
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1642;
  assign sum_1642 = sum_1638[12:1] + {sum_1641, select_1639[0]};
  logic [9:0] sum_1643;
  assign sum_1643 = {difference_1635, select_1633[0]} + sum_1642[11:2];
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1644;
  assign sum_1644 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_1643[9]}}, sum_1643[9:2]};
  // hls/stages/registration.hpp:151
  logic [7:0] select_1647;
  assign select_1647 = ($signed(sum_1644[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1644[7:0];
  logic [7:0] slope;
  assign slope = ($signed(6'h0) < $signed(sum_1644[12:7])) ? 8'h7f : select_1647;
  logic [6:0] select_1649;
  assign select_1649 = select_967[6] ? slope[7:1] : 7'h0;
  logic [7:0] select_1650;
  assign select_1650 = select_967[7] ? slope : 8'h0;
  logic [8:0] sum_1651;
  assign sum_1651 = {{2{select_1649[6]}}, select_1649} + {select_1650[7], select_1650};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1652;
  assign select_1652 = select_967[8] ? slope : 8'h0;
  logic [7:0] select_1653;
  assign select_1653 = select_967[9] ? slope : 8'h0;
  logic [8:0] sum_1654;
  assign sum_1654 = {{2{select_1652[7]}}, select_1652[7:1]} + {select_1653[7], select_1653};
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1655;
  assign sum_1655 = {{3{sum_1651[8]}}, sum_1651[8:1]} + {sum_1654[8], sum_1654, select_1652[0]};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1656;
  assign select_1656 = select_967[10] ? slope : 8'h0;
  logic [7:0] select_1657;
  assign select_1657 = select_967[11] ? slope : 8'h0;
  logic [8:0] difference_1658;
  assign difference_1658 = {{2{select_1656[7]}}, select_1656[7:1]} - {select_1657[7], select_1657};
  // hls/stages/registration.hpp:57
  logic [23:0] select_1888;
  assign select_1888 = equal_1887_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:205
  logic [23:0] select_1890;
  assign select_1890 = and_359_s3_q ? (equal_1344_s3_q ? select_1888 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1891;
  assign select_1891 = equal_1887_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:205
  logic [27:0] select_1893;
  assign select_1893 = and_359_s3_q ? (equal_1344_s3_q ? select_1891 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1895;
  assign select_1895 = drew_s3_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1896;
  assign sum_1896 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1897;
  assign sum_1897 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

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

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:922; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s3_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s3_en & and_969;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:953; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s3_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s3_en & and_969;
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
  assign best_right_we = s3_en & and_925_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_935, select_934};
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

  // Memory near_right, write
  logic [5:0] near_right_waddr;
  assign near_right_waddr = partner_s3_q;
  logic near_right_we;
  assign near_right_we = s3_en & and_925_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (near_right_we) near_right_mem[near_right_waddr] <= {select_942, select_941};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && near_right_we) begin
      if (near_right_re && near_right_raddr == near_right_waddr) begin
        $error("near_right: address %0d is read less than DISTANCE steps after its write", near_right_waddr);
      end
      if (near_right_waddr >= 6'd47) $error("near_right: write outside, address %0d", near_right_waddr);
    end
    if (rst_ni && near_right_re && near_right_raddr >= 6'd47) $error("near_right: read outside, address %0d", near_right_raddr);
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
      sample_pair_pixel_0_q <= left_pixel_q;
      sample_pair_pixel_1_q <= pixel_0_s3_q;
      sample_of_skin_q <= mask_s3_q;
      averager_running_of_skin_q <= select_1205;
      averager_mask_q <= select_1207;
      averager_of_skin_q <= select_1209;
      registration_slope_row_q <= select_1890;
      registration_slope_change_q <= select_1893;
      registration_slope_q <= select_1895;
      registration_next_slope_row_q <= sum_1896;
      registration_next_slope_change_q <= sum_1897;
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
      left_pixel_q <= and_1057_s3_q ? left_pixel_q : pixel_0_s3_q;
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
  logic or_380_s4_q;
  logic less_385_s4_q;
  logic equal_418_s4_q;
  logic [5:0] x_s4_2_q;
  logic [7:0] best_left_rdata_s4_q;
  logic select_831_s4_q;
  logic or_838_s4_q;
  logic [7:0] select_839_s4_q;
  logic [5:0] select_840_s4_q;
  logic equal_845_s4_q;
  logic rise_s4_q;
  logic [1:0] sum_857_s4_q;
  logic [7:0] twice_s4_q;
  logic [8:0] difference_869_s4_q;
  logic [6:0] select_923_s4_q;
  logic [5:0] select_924_s4_q;
  logic and_925_s4_q;
  logic equal_943_s4_q;
  logic not_944_s4_q;
  logic [5:0] select_967_s4_q;
  logic and_969_s4_q;
  logic [5:0] select_973_s4_q;
  logic not_974_s4_q;
  logic and_987_s4_q;
  logic and_991_s4_q;
  logic and_994_s4_q;
  logic equal_1010_s4_q;
  logic and_1057_s4_q;
  logic and_1147_s4_q;
  logic equal_1292_s4_q;
  logic equal_1344_s4_q;
  logic less_1621_s4_q;
  logic less_1623_s4_q;
  logic [9:0] sum_1655_s4_q;
  logic select_1656_s4_q;
  logic [8:0] difference_1658_s4_q;
  logic less_1898_s4_q;
  logic equal_2041_s4_q;
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
      or_380_s4_q <= or_380_s3_q;
      less_385_s4_q <= less_385_s3_q;
      equal_418_s4_q <= equal_418_s3_q;
      x_s4_2_q <= x_s3_2_q[5:0];
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      select_831_s4_q <= select_831[0];
      or_838_s4_q <= or_838;
      select_839_s4_q <= or_838 ? of_best_2 : best_left_rdata_s3_q[7:0];
      select_840_s4_q <= or_838 ? run_shift_s3_q : best_left_rdata_s3_q[13:8];
      equal_845_s4_q <= {less_830, select_831} == near_best;
      rise_s4_q <= rise[8];
      sum_857_s4_q <= {less_830, select_831[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_869_s4_q <= {1'b0, twice} - (({twice, 1'b0} < size) ? {twice, 1'b0} : size);
      select_923_s4_q <= or_922 ? of_near_2 : best_left_rdata_s3_q[28:22];
      select_924_s4_q <= or_922 ? run_shift_s3_q : best_left_rdata_s3_q[34:29];
      and_925_s4_q <= and_925_s3_q;
      equal_943_s4_q <= equal_943_s3_q;
      not_944_s4_q <= not_944;
      select_967_s4_q <= select_967[5:0];
      and_969_s4_q <= and_969;
      select_973_s4_q <= select_973_s3_q;
      not_974_s4_q <= not_974_s3_q;
      and_987_s4_q <= or_380_s3_q & (not_386_s3_q & (and_949_s3_q & and_984));
      and_991_s4_q <= and_991;
      and_994_s4_q <= and_994;
      equal_1010_s4_q <= equal_1010_s3_q;
      and_1057_s4_q <= and_1057_s3_q;
      and_1147_s4_q <= not_944 & and_1146_s3_q;
      equal_1292_s4_q <= equal_1292_s3_q;
      equal_1344_s4_q <= equal_1344_s3_q;
      less_1621_s4_q <= less_1621_s3_q;
      less_1623_s4_q <= less_1623_s3_q;
      sum_1655_s4_q <= sum_1655[10:1];
      select_1656_s4_q <= select_1656[0];
      difference_1658_s4_q <= difference_1658;
      less_1898_s4_q <= less_1898_s3_q;
      equal_2041_s4_q <= equal_2041_s3_q;
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
  // hls/stages/agreement.hpp:285
  logic equal_415;
  assign equal_415 = column_s4_q == 6'h0;
  logic [3:0] select_419;
  assign select_419 = equal_418_s4_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:286
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
  // hls/stages/agreement.hpp:286
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
  logic not_870;
  assign not_870 = ~difference_869_s4_q[8];
  logic [7:0] xor_871;
  assign xor_871 = twice_s4_q ^ {8{not_870}};
  logic [9:0] sum_872;
  assign sum_872 = {difference_869_s4_q[7:0], 1'b0, not_870} + {not_870, xor_871, not_870};
  logic not_873;
  assign not_873 = ~sum_872[9];
  logic [7:0] xor_874;
  assign xor_874 = twice_s4_q ^ {8{not_873}};
  logic [9:0] sum_875;
  assign sum_875 = {sum_872[8:0], not_873} + {not_873, xor_874, not_873};
  logic not_876;
  assign not_876 = ~sum_875[9];
  logic [7:0] xor_877;
  assign xor_877 = twice_s4_q ^ {8{not_876}};
  logic [9:0] sum_878;
  assign sum_878 = {sum_875[8:0], not_876} + {not_876, xor_877, not_876};
  logic not_879;
  assign not_879 = ~sum_878[9];
  logic [7:0] xor_880;
  assign xor_880 = twice_s4_q ^ {8{not_879}};
  logic [9:0] sum_881;
  assign sum_881 = {sum_878[8:0], not_879} + {not_879, xor_880, not_879};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_882;
  assign difference_882 = {sum_857_s4_q, select_831_s4_q, 5'h0} - {3'h0, difference_869_s4_q[8], sum_872[9], sum_875[9], sum_878[9], sum_881[9]};
  // hls/stages/agreement.hpp:496
  logic [7:0] select_883;
  assign select_883 = rise_s4_q ? difference_882 : {sum_857_s4_q, select_831_s4_q, difference_869_s4_q[8], sum_872[9], sum_875[9], sum_878[9], sum_881[9]};
  logic [7:0] select_884;
  assign select_884 = equal_845_s4_q ? select_883 : {sum_857_s4_q, select_831_s4_q, 5'h0};
  // hls/stages/agreement.hpp:498
  logic [7:0] select_885;
  assign select_885 = or_838_s4_q ? select_884 : best_left_rdata_s4_q;
  // hls/stages/agreement.hpp:343
  logic and_988;
  assign and_988 = not_974_s4_q & and_987_s4_q;
  // hls/stages/agreement.hpp:147
  logic [7:0] select_995;
  assign select_995 = drew_s4_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:672
  logic or_998;
  assign or_998 = select_995[7] | (~({select_995[5], select_995[3], select_995[1]} == 3'h0));
  // hls/stages/agreement.hpp:671
  logic or_1001;
  assign or_1001 = select_995[7] | (~({select_995[6], select_995[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:670
  logic or_1004;
  assign or_1004 = select_995[7] | (~(select_995[6:4] == 3'h0));
  // hls/stages/agreement.hpp:343
  logic [5:0] select_1005;
  assign select_1005 = equal_943_s4_q ? x_s4_q[5:0] : {region_row_q, or_1004, or_1001, or_998};
  // hls/stages/agreement.hpp:753
  logic equal_1006;
  assign equal_1006 = x_s4_q[5:4] == 2'h3;
  logic not_1007;
  assign not_1007 = ~equal_1006;
  // hls/stages/division.hpp:18
  logic [5:0] sum_1008;
  assign sum_1008 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:680
  logic or_1011;
  assign or_1011 = (~sum_1008[5]) | equal_1010_s4_q;
  // hls/stages/agreement.hpp:343
  logic and_1013;
  assign and_1013 = drew_s4_q & (select_967_s4_q[0] & or_1011);
  // hls/stages/agreement.hpp:186
  logic textured;
  assign textured = select_967_s4_q[0] & select_967_s4_q[2];
  logic explained;
  assign explained = select_967_s4_q[0] & select_967_s4_q[4];
  logic and_1027;
  assign and_1027 = select_967_s4_q[0] & ({select_967_s4_q[5], select_967_s4_q[3]} == 2'h3);
  logic and_1034;
  assign and_1034 = select_967_s4_q[0] & select_967_s4_q[3];
  logic shown;
  assign shown = select_967_s4_q[0] & (shown_right_rdata_q[0] | and_991_s4_q);
  logic near;
  assign near = select_967_s4_q[0] & (and_991_s4_q ? and_987_s4_q : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:842
  logic select_1039;
  assign select_1039 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:846
  logic select_1040;
  assign select_1040 = left_first_s4_q ? select_1039 : read_half_q;
  logic or_1041;
  assign or_1041 = left_first_s4_q | line_ended_q;
  // hls/stages/agreement.hpp:847
  logic [8:0] select_1042;
  assign select_1042 = or_1041 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:848
  logic [9:0] select_1044;
  assign select_1044 = left_first_s4_q ? 10'h1 : (or_1041 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:851
  logic and_1045;
  assign and_1045 = select_1042[8] & select_1044[9];
  // hls/stages/agreement.hpp:206
  logic next_row;
  assign next_row = and_1045 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:862
  logic [5:0] select_1048;
  assign select_1048 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1050;
  assign select_1050 = left_first_s4_q ? 11'h0 : (seen_base_q + {5'h0, select_1048});
  // hls/stages/agreement.hpp:872
  logic equal_1051;
  assign equal_1051 = seen_x_q == 3'h7;
  logic [7:0] select_1053;
  assign select_1053 = and_1045 ? 8'h0 : (seen_column_q + {7'h0, equal_1051});
  // hls/stages/agreement.hpp:875
  logic [10:0] index;
  assign index = select_1050 + {3'h0, select_1053};
  // hls/stages/agreement.hpp:832
  logic [11:0] sum_1055;
  assign sum_1055 = {1'b0, {2{select_1040}}, 2'h0, {2{select_1040}}, 1'b0, {2{select_1040}}, 1'b0, select_1040} + {1'b0, index};
  // hls/stages/agreement.hpp:845
  logic not_1058;
  assign not_1058 = ~left_first_s4_q;
  // hls/stages/agreement.hpp:206
  logic and_1060;
  assign and_1060 = not_1058 & (began_q | and_1045);
  // hls/stages/agreement.hpp:873
  logic [2:0] select_1062;
  assign select_1062 = and_1045 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:874
  logic and_1064;
  assign and_1064 = and_1060 & (select_1062 == 3'h0);
  logic less_1065;
  assign less_1065 = select_1053 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:208
  logic and_1066;
  assign and_1066 = and_1064 & less_1065;
  logic and_1067;
  assign and_1067 = and_1057_s4_q & and_1066;
  logic select_1069;
  assign select_1069 = and_1057_s4_q ? (left_first_s4_q ? and_1066 : and_1067) : and_1067;
  // hls/stages/agreement.hpp:736
  logic [7:0] sum_1071;
  assign sum_1071 = {2'h0, x_s4_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1071[7], sum_1071, x_s4_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:832
  logic [11:0] sum_1073;
  assign sum_1073 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:650
  logic and_1074;
  assign and_1074 = seen_columns_rdata_q[14] & select_967_s4_q[0];
  logic and_1075;
  assign and_1075 = seen_columns_rdata_q[10] & select_967_s4_q[0];
  logic and_1076;
  assign and_1076 = seen_columns_rdata_q[5] & select_967_s4_q[0];
  logic and_1077;
  assign and_1077 = seen_columns_rdata_q[0] & select_967_s4_q[0];
  // hls/stages/agreement.hpp:709
  logic [1:0] sum_1079;
  assign sum_1079 = {1'b0, and_1076} + ({1'b0, textured} + {1'b0, and_1077});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1074} + ({2'h0, and_1075} + {1'b0, sum_1079});
  // hls/stages/agreement.hpp:716
  logic [4:0] difference_1083;
  assign difference_1083 = {2'h0, textured_2} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:714
  logic equal_1084;
  assign equal_1084 = x_s4_q == 8'h0;
  // hls/stages/agreement.hpp:716
  logic [4:0] t;
  assign t = difference_1083 + (equal_1084 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:650
  logic [7:0] select_1089;
  assign select_1089 = select_967_s4_q[0] ? (sum_1008[5] ? select_995 : {select_995[6:0], 1'b0}) : select_995;
  // hls/stages/agreement.hpp:672
  logic or_1092;
  assign or_1092 = select_1089[7] | (~({select_1089[5], select_1089[3], select_1089[1]} == 3'h0));
  // hls/stages/agreement.hpp:650
  logic and_1108;
  assign and_1108 = seen_columns_rdata_q[16] & select_967_s4_q[0];
  logic and_1109;
  assign and_1109 = seen_columns_rdata_q[12] & select_967_s4_q[0];
  logic and_1110;
  assign and_1110 = seen_columns_rdata_q[8] & select_967_s4_q[0];
  logic and_1111;
  assign and_1111 = seen_columns_rdata_q[3] & select_967_s4_q[0];
  // hls/stages/agreement.hpp:711
  logic [1:0] sum_1113;
  assign sum_1113 = {1'b0, and_1110} + ({1'b0, shown} + {1'b0, and_1111});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1108} + ({2'h0, and_1109} + {1'b0, sum_1113});
  // hls/stages/agreement.hpp:718
  logic [4:0] difference_1117;
  assign difference_1117 = {2'h0, shown_2} - (age_s4_q ? box_shown_columns_values_4_q : 5'h0);
  logic [4:0] around;
  assign around = difference_1117 + (equal_1084 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:725
  logic [5:0] sum_1120;
  assign sum_1120 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:650
  logic and_1124;
  assign and_1124 = seen_columns_rdata_q[17] & select_967_s4_q[0];
  logic and_1125;
  assign and_1125 = seen_columns_rdata_q[13] & select_967_s4_q[0];
  logic and_1126;
  assign and_1126 = seen_columns_rdata_q[9] & select_967_s4_q[0];
  logic and_1127;
  assign and_1127 = seen_columns_rdata_q[4] & select_967_s4_q[0];
  // hls/stages/agreement.hpp:712
  logic [1:0] sum_1129;
  assign sum_1129 = {1'b0, and_1126} + ({1'b0, near} + {1'b0, and_1127});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1124} + ({2'h0, and_1125} + {1'b0, sum_1129});
  // hls/stages/agreement.hpp:719
  logic [4:0] difference_1133;
  assign difference_1133 = {2'h0, near_2} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1133 + (equal_1084 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:204
  logic [10:0] select_1184;
  assign select_1184 = sample_pair_whole_s4_q ? (and_357_s4_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1186;
  assign select_1186 = sample_pair_whole_s4_q ? (and_357_s4_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1210;
  assign select_1210 = and_359_s4_q ? select_365 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1211;
  assign select_1211 = and_359_s4_q ? select_369 : census_columns_values_0_cell_0_right_q;
  logic select_1212;
  assign select_1212 = and_359_s4_q ? whole_2_s4_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_1213;
  assign select_1213 = and_359_s4_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1214;
  assign select_1214 = and_359_s4_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1215;
  assign select_1215 = and_359_s4_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1216;
  assign select_1216 = and_359_s4_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1217;
  assign select_1217 = and_359_s4_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1218;
  assign select_1218 = and_359_s4_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1219;
  assign select_1219 = and_359_s4_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1220;
  assign select_1220 = and_359_s4_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1221;
  assign select_1221 = and_359_s4_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1222;
  assign select_1222 = and_359_s4_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1223;
  assign select_1223 = and_359_s4_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1224;
  assign select_1224 = and_359_s4_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1225;
  assign select_1225 = and_359_s4_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1226;
  assign select_1226 = and_359_s4_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1227;
  assign select_1227 = and_359_s4_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1228;
  assign select_1228 = and_359_s4_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1229;
  assign select_1229 = and_359_s4_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1230;
  assign select_1230 = and_359_s4_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1231;
  assign select_1231 = and_359_s4_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1232;
  assign select_1232 = and_359_s4_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1233;
  assign select_1233 = and_359_s4_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1234;
  assign select_1234 = and_359_s4_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1235;
  assign select_1235 = and_359_s4_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1236;
  assign select_1236 = and_359_s4_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1237;
  assign select_1237 = and_359_s4_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1238;
  assign select_1238 = and_359_s4_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1239;
  assign select_1239 = and_359_s4_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1240;
  assign select_1240 = and_359_s4_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1241;
  assign select_1241 = and_359_s4_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1242;
  assign select_1242 = and_359_s4_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1243;
  assign select_1243 = and_359_s4_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1244;
  assign select_1244 = and_359_s4_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1245;
  assign select_1245 = and_359_s4_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1246;
  assign select_1246 = and_359_s4_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1247;
  assign select_1247 = and_359_s4_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1248;
  assign select_1248 = and_359_s4_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1249;
  assign select_1249 = and_359_s4_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1250;
  assign select_1250 = and_359_s4_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1251;
  assign select_1251 = and_359_s4_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1252;
  assign select_1252 = and_359_s4_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1253;
  assign select_1253 = and_359_s4_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1254;
  assign select_1254 = and_359_s4_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1255;
  assign select_1255 = and_359_s4_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1256;
  assign select_1256 = and_359_s4_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1257;
  assign select_1257 = and_359_s4_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1258;
  assign select_1258 = and_359_s4_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1259;
  assign select_1259 = and_359_s4_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1260;
  assign select_1260 = and_359_s4_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1261;
  assign select_1261 = and_359_s4_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1262;
  assign select_1262 = and_359_s4_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1263;
  assign select_1263 = and_359_s4_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1264;
  assign select_1264 = and_359_s4_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1265;
  assign select_1265 = and_359_s4_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1267;
  assign difference_1267 = {1'b0, select_369} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1268;
  assign xor_1268 = difference_1267[8:0] ^ {9{difference_1267[9]}};
  logic [9:0] sum_1269;
  assign sum_1269 = {9'h0, difference_1267[9]} + {1'b0, xor_1268};
  logic [9:0] difference_1270;
  assign difference_1270 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1271;
  assign xor_1271 = difference_1270[8:0] ^ {9{difference_1270[9]}};
  logic [9:0] sum_1272;
  assign sum_1272 = {9'h0, difference_1270[9]} + {1'b0, xor_1271};
  logic [9:0] difference_1274;
  assign difference_1274 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1275;
  assign xor_1275 = difference_1274[8:0] ^ {9{difference_1274[9]}};
  logic [9:0] sum_1276;
  assign sum_1276 = {9'h0, difference_1274[9]} + {1'b0, xor_1275};
  logic [10:0] sum_1277;
  assign sum_1277 = ({1'b0, sum_1269} + {1'b0, sum_1272}) + {1'b0, sum_1276};
  logic [9:0] difference_1278;
  assign difference_1278 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1279;
  assign xor_1279 = difference_1278[8:0] ^ {9{difference_1278[9]}};
  logic [9:0] sum_1280;
  assign sum_1280 = {9'h0, difference_1278[9]} + {1'b0, xor_1279};
  logic [9:0] difference_1282;
  assign difference_1282 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1283;
  assign xor_1283 = difference_1282[8:0] ^ {9{difference_1282[9]}};
  logic [9:0] sum_1284;
  assign sum_1284 = {9'h0, difference_1282[9]} + {1'b0, xor_1283};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1312;
  assign difference_1312 = {1'b0, select_365} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1312[9]} + (difference_1312[8:0] ^ {9{difference_1312[9]}});
  logic [9:0] difference_1323;
  assign difference_1323 = {1'b0, select_369} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1323[9]} + (difference_1323[8:0] ^ {9{difference_1323[9]}});
  // hls/stages/agreement.hpp:205
  logic and_1523;
  assign and_1523 = and_359_s4_q & (equal_418_s4_q & equal_1344_s4_q);
  // hls/stages/agreement.hpp:343
  logic and_1526;
  assign and_1526 = not_944_s4_q & (drew_s4_q & (select_967_s4_q[0] & select_967_s4_q[1]));
  // hls/stages/agreement.hpp:650
  logic and_1543;
  assign and_1543 = seen_columns_rdata_q[15] & select_967_s4_q[0];
  logic and_1544;
  assign and_1544 = seen_columns_rdata_q[11] & select_967_s4_q[0];
  logic and_1545;
  assign and_1545 = seen_columns_rdata_q[7] & select_967_s4_q[0];
  logic and_1546;
  assign and_1546 = seen_columns_rdata_q[2] & select_967_s4_q[0];
  // hls/stages/agreement.hpp:710
  logic [1:0] sum_1548;
  assign sum_1548 = {1'b0, and_1545} + ({1'b0, explained} + {1'b0, and_1546});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_1543} + ({2'h0, and_1544} + {1'b0, sum_1548});
  // hls/stages/agreement.hpp:717
  logic [4:0] difference_1552;
  assign difference_1552 = {2'h0, explained_2} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_1552 + (equal_1084 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:724
  logic [5:0] sum_1555;
  assign sum_1555 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:644
  logic [9:0] select_1615;
  assign select_1615 = ({select_967_s4_q[3], select_967_s4_q[1]} == 2'h3) ? ({1'b0, select_967_s4_q[5], 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:343
  logic [9:0] select_1618;
  assign select_1618 = equal_943_s4_q ? 10'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1615 : 10'h0) : 10'h0);
  // hls/stages/agreement.hpp:566
  logic [23:0] select_1620;
  assign select_1620 = and_1523 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1618[9]}}, select_1618});
  // hls/stages/registration.hpp:73
  logic equal_1624;
  assign equal_1624 = {lower_half_s4_q, less_1623_s4_q} == 2'h3;
  logic equal_1625;
  assign equal_1625 = {lower_half_s4_q, less_1623_s4_q} == 2'h2;
  logic equal_1626;
  assign equal_1626 = {lower_half_s4_q, less_1623_s4_q} == 2'h1;
  // hls/stages/agreement.hpp:181
  logic [7:0] select_1628;
  assign select_1628 = or_380_s4_q ? (less_385_s4_q ? 8'h0 : best_left_rdata_s4_q) : 8'h0;
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1659;
  assign sum_1659 = {difference_1658_s4_q, select_1656_s4_q} + {sum_1655_s4_q[9], sum_1655_s4_q[9:1]};
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1660;
  assign difference_1660 = {{4{select_1628[7]}}, select_1628} - {sum_1659[9], sum_1659, sum_1655_s4_q[0]};
  // hls/stages/registration.hpp:158
  logic [11:0] select_1662;
  assign select_1662 = ($signed(difference_1660[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1660;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1662[11:7])) ? 12'h7f : select_1662;
  // hls/stages/registration.hpp:73
  logic not_1702;
  assign not_1702 = ~equal_1624;
  logic not_1703;
  assign not_1703 = ~equal_1625;
  // hls/stages/agreement.hpp:186
  logic and_1708;
  assign and_1708 = select_967_s4_q[4] & (less_1621_s4_q & (not_1702 & (not_1703 & (~equal_1626))));
  // hls/stages/agreement.hpp:343
  logic and_1711;
  assign and_1711 = not_944_s4_q & (drew_s4_q & (select_967_s4_q[0] & and_1708));
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1713;
  assign select_1713 = and_1523 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1711});
  // hls/stages/agreement.hpp:186
  logic and_1717;
  assign and_1717 = select_967_s4_q[4] & (less_1621_s4_q & (not_1702 & (equal_1626 & not_1703)));
  // hls/stages/agreement.hpp:343
  logic and_1720;
  assign and_1720 = not_944_s4_q & (drew_s4_q & (select_967_s4_q[0] & and_1717));
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1722;
  assign select_1722 = and_1523 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1720});
  // hls/stages/agreement.hpp:186
  logic and_1726;
  assign and_1726 = select_967_s4_q[0] & (select_967_s4_q[4] & (less_1621_s4_q & (equal_1625 & not_1702)));
  // hls/stages/agreement.hpp:343
  logic and_1728;
  assign and_1728 = not_944_s4_q & (drew_s4_q & and_1726);
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1730;
  assign select_1730 = and_1523 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1728});
  // hls/stages/agreement.hpp:186
  logic and_1733;
  assign and_1733 = select_967_s4_q[0] & (select_967_s4_q[4] & (less_1621_s4_q & equal_1624));
  // hls/stages/agreement.hpp:343
  logic and_1735;
  assign and_1735 = not_944_s4_q & (drew_s4_q & and_1733);
  // hls/stages/agreement.hpp:567
  logic [11:0] select_1737;
  assign select_1737 = and_1523 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1735});
  // hls/stages/registration.hpp:146
  logic less_1738;
  assign less_1738 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:186
  logic and_1739;
  assign and_1739 = less_1621_s4_q & less_1738;
  logic [1:0] select_1741;
  assign select_1741 = select_967_s4_q[0] ? (select_967_s4_q[4] ? {and_1739, less_1621_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1743;
  assign select_1743 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? select_1741 : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1744;
  assign sum_1744 = registration_counts_votes_0_down_q + {{13{select_1743[1]}}, select_1743};
  // hls/stages/registration.hpp:146
  logic [12:0] difference_1746;
  assign difference_1746 = 13'h0 - {residual[11], residual};
  logic less_1747;
  assign less_1747 = $signed(difference_1746) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:186
  logic and_1748;
  assign and_1748 = less_1621_s4_q & less_1747;
  logic [1:0] select_1750;
  assign select_1750 = select_967_s4_q[0] ? (select_967_s4_q[4] ? {and_1748, less_1621_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1752;
  assign select_1752 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? select_1750 : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1753;
  assign sum_1753 = registration_counts_votes_0_up_q + {{13{select_1752[1]}}, select_1752};
  // hls/stages/registration.hpp:80
  logic not_1755;
  assign not_1755 = ~less_1623_s4_q;
  // hls/stages/registration.hpp:79
  logic and_1756;
  assign and_1756 = less_1738 & not_1755;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1758;
  assign select_1758 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1756, not_1755} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1761;
  assign select_1761 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1758 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1762;
  assign sum_1762 = registration_counts_votes_1_down_q + {{13{select_1761[1]}}, select_1761};
  // hls/stages/registration.hpp:79
  logic and_1764;
  assign and_1764 = less_1747 & not_1755;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1766;
  assign select_1766 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1764, not_1755} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1769;
  assign select_1769 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1766 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1770;
  assign sum_1770 = registration_counts_votes_1_up_q + {{13{select_1769[1]}}, select_1769};
  // hls/stages/registration.hpp:79
  logic and_1772;
  assign and_1772 = less_1623_s4_q & less_1738;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1774;
  assign select_1774 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1772, less_1623_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1777;
  assign select_1777 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1774 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1778;
  assign sum_1778 = registration_counts_votes_2_down_q + {{13{select_1777[1]}}, select_1777};
  // hls/stages/registration.hpp:79
  logic and_1780;
  assign and_1780 = less_1623_s4_q & less_1747;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1782;
  assign select_1782 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1780, less_1623_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1785;
  assign select_1785 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1782 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1786;
  assign sum_1786 = registration_counts_votes_2_up_q + {{13{select_1785[1]}}, select_1785};
  // hls/stages/registration.hpp:80
  logic not_1788;
  assign not_1788 = ~lower_half_s4_q;
  // hls/stages/agreement.hpp:186
  logic and_1789;
  assign and_1789 = less_1738 & not_1788;
  logic [1:0] select_1791;
  assign select_1791 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1789, not_1788} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1794;
  assign select_1794 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1791 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1795;
  assign sum_1795 = registration_counts_votes_3_down_q + {{13{select_1794[1]}}, select_1794};
  // hls/stages/agreement.hpp:186
  logic and_1797;
  assign and_1797 = less_1747 & not_1788;
  logic [1:0] select_1799;
  assign select_1799 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1797, not_1788} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1802;
  assign select_1802 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1799 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1803;
  assign sum_1803 = registration_counts_votes_3_up_q + {{13{select_1802[1]}}, select_1802};
  // hls/stages/agreement.hpp:186
  logic and_1805;
  assign and_1805 = lower_half_s4_q & less_1738;
  logic [1:0] select_1807;
  assign select_1807 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1805, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1810;
  assign select_1810 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1807 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1811;
  assign sum_1811 = registration_counts_votes_4_down_q + {{13{select_1810[1]}}, select_1810};
  // hls/stages/agreement.hpp:186
  logic and_1813;
  assign and_1813 = lower_half_s4_q & less_1747;
  logic [1:0] select_1815;
  assign select_1815 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1813, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1818;
  assign select_1818 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1815 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1819;
  assign sum_1819 = registration_counts_votes_4_up_q + {{13{select_1818[1]}}, select_1818};
  // hls/stages/registration.hpp:146
  logic less_1821;
  assign less_1821 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1822;
  assign and_1822 = not_1755 & less_1821;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1824;
  assign select_1824 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1822, not_1755} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1827;
  assign select_1827 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1824 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1828;
  assign sum_1828 = registration_counts_half_votes_0_down_q + {{13{select_1827[1]}}, select_1827};
  // hls/stages/registration.hpp:146
  logic less_1830;
  assign less_1830 = $signed(difference_1746) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1831;
  assign and_1831 = not_1755 & less_1830;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1833;
  assign select_1833 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1831, not_1755} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1836;
  assign select_1836 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1833 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1837;
  assign sum_1837 = registration_counts_half_votes_0_up_q + {{13{select_1836[1]}}, select_1836};
  // hls/stages/registration.hpp:79
  logic and_1839;
  assign and_1839 = less_1623_s4_q & less_1821;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1841;
  assign select_1841 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1839, less_1623_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1844;
  assign select_1844 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1841 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1845;
  assign sum_1845 = registration_counts_half_votes_1_down_q + {{13{select_1844[1]}}, select_1844};
  // hls/stages/registration.hpp:79
  logic and_1847;
  assign and_1847 = less_1623_s4_q & less_1830;
  // hls/stages/agreement.hpp:186
  logic [1:0] select_1849;
  assign select_1849 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1847, less_1623_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1852;
  assign select_1852 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1849 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1853;
  assign sum_1853 = registration_counts_half_votes_1_up_q + {{13{select_1852[1]}}, select_1852};
  // hls/stages/agreement.hpp:186
  logic and_1855;
  assign and_1855 = less_1821 & not_1788;
  logic [1:0] select_1857;
  assign select_1857 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1855, not_1788} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1860;
  assign select_1860 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1857 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1861;
  assign sum_1861 = registration_counts_half_votes_2_down_q + {{13{select_1860[1]}}, select_1860};
  // hls/stages/agreement.hpp:186
  logic and_1863;
  assign and_1863 = less_1830 & not_1788;
  logic [1:0] select_1865;
  assign select_1865 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1863, not_1788} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1868;
  assign select_1868 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1865 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1869;
  assign sum_1869 = registration_counts_half_votes_2_up_q + {{13{select_1868[1]}}, select_1868};
  // hls/stages/agreement.hpp:186
  logic and_1871;
  assign and_1871 = lower_half_s4_q & less_1821;
  logic [1:0] select_1873;
  assign select_1873 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1871, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1876;
  assign select_1876 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1873 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1877;
  assign sum_1877 = registration_counts_half_votes_3_down_q + {{13{select_1876[1]}}, select_1876};
  // hls/stages/agreement.hpp:186
  logic and_1879;
  assign and_1879 = lower_half_s4_q & less_1830;
  logic [1:0] select_1881;
  assign select_1881 = select_967_s4_q[4] ? (less_1621_s4_q ? {and_1879, lower_half_s4_q} : 2'h0) : 2'h0;
  // hls/stages/agreement.hpp:343
  logic [1:0] select_1884;
  assign select_1884 = equal_943_s4_q ? 2'h0 : (drew_s4_q ? (select_967_s4_q[0] ? select_1881 : 2'h0) : 2'h0);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1885;
  assign sum_1885 = registration_counts_half_votes_3_up_q + {{13{select_1884[1]}}, select_1884};
  // hls/stages/division.hpp:34
  logic [7:0] sum_1899;
  assign sum_1899 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:290
  logic [2:0] select_1901;
  assign select_1901 = less_1898_s4_q ? (sum_1899[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1903;
  assign select_1903 = equal_1344_s4_q ? (equal_418_s4_q ? 3'h0 : select_1901) : region_row_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1907;
  assign sum_1907 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1908;
  assign select_1908 = sum_1008[5] ? {1'b1, sum_1008[4:0], region_across_rest_q[2:0]} : sum_1907;
  // hls/stages/agreement.hpp:147
  logic [8:0] select_1909;
  assign select_1909 = drew_s4_q ? select_1908 : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/agreement.hpp:290
  logic [7:0] select_1912;
  assign select_1912 = equal_1344_s4_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_1915;
  assign select_1915 = equal_1344_s4_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  logic [8:0] select_1919;
  assign select_1919 = equal_418_s4_q ? {{2{difference_1917[6]}}, difference_1917} : (less_1898_s4_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:205
  logic [8:0] select_1921;
  assign select_1921 = and_359_s4_q ? (equal_1344_s4_q ? select_1919 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:290
  logic [6:0] select_1923;
  assign select_1923 = equal_418_s4_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:205
  logic [6:0] select_1925;
  assign select_1925 = and_359_s4_q ? (equal_1344_s4_q ? select_1923 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1926;
  assign sum_1926 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1927;
  assign select_1927 = sum_1899[7] ? {1'b1, sum_1899[6:0], region_down_rest_q[0]} : sum_1926;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1899[7];
  // hls/stages/agreement.hpp:290
  logic select_1931;
  assign select_1931 = equal_1344_s4_q ? (equal_418_s4_q | (less_1898_s4_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:147
  logic or_1936;
  assign or_1936 = segment_starts_q | not_974_s4_q;
  // hls/stages/agreement.hpp:650
  logic select_1939;
  assign select_1939 = select_967_s4_q[0] ? (sum_1008[5] ? (equal_1010_s4_q & or_1011) : or_1011) : or_1936;
  // hls/stages/agreement.hpp:766
  logic equal_1943;
  assign equal_1943 = x_s4_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:768
  logic [7:0] select_1961;
  assign select_1961 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1963;
  assign select_1963 = equal_943_s4_q ? (equal_1943 ? select_1961 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:149
  logic not_1964;
  assign not_1964 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:343
  logic [4:0] select_1985;
  assign select_1985 = equal_943_s4_q ? box_textured_columns_values_0_q : (drew_s4_q ? {2'h0, textured_2} : box_textured_columns_values_0_q);
  logic [4:0] select_1986;
  assign select_1986 = drew_s4_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1988;
  assign select_1988 = drew_s4_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1990;
  assign select_1990 = drew_s4_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1992;
  assign select_1992 = drew_s4_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1995;
  assign select_1995 = equal_943_s4_q ? box_textured_sum_sums_values_0_q : (drew_s4_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1996;
  assign select_1996 = drew_s4_q ? {2'h0, explained_2} : box_explained_columns_values_0_q;
  logic [4:0] select_1998;
  assign select_1998 = drew_s4_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_2000;
  assign select_2000 = drew_s4_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_2002;
  assign select_2002 = drew_s4_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_2004;
  assign select_2004 = drew_s4_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_2007;
  assign select_2007 = equal_943_s4_q ? box_explained_sum_sums_values_0_q : (drew_s4_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_2009;
  assign select_2009 = equal_943_s4_q ? box_shown_columns_values_0_q : (drew_s4_q ? {2'h0, shown_2} : box_shown_columns_values_0_q);
  logic [4:0] select_2010;
  assign select_2010 = drew_s4_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [4:0] select_2012;
  assign select_2012 = drew_s4_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [4:0] select_2014;
  assign select_2014 = drew_s4_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [4:0] select_2016;
  assign select_2016 = drew_s4_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [4:0] select_2019;
  assign select_2019 = equal_943_s4_q ? box_shown_sum_sums_values_0_q : (drew_s4_q ? around : box_shown_sum_sums_values_0_q);
  logic [4:0] select_2021;
  assign select_2021 = equal_943_s4_q ? box_nearer_columns_values_0_q : (drew_s4_q ? {2'h0, near_2} : box_nearer_columns_values_0_q);
  logic [4:0] select_2022;
  assign select_2022 = drew_s4_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_2024;
  assign select_2024 = drew_s4_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_2026;
  assign select_2026 = drew_s4_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_2028;
  assign select_2028 = drew_s4_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_2031;
  assign select_2031 = equal_943_s4_q ? box_nearer_sum_sums_values_0_q : (drew_s4_q ? n : box_nearer_sum_sums_values_0_q);
  logic select_2033;
  assign select_2033 = equal_943_s4_q ? centres_values_0_textured_q : (drew_s4_q ? and_1076 : centres_values_0_textured_q);
  logic select_2035;
  assign select_2035 = drew_s4_q ? (seen_columns_rdata_q[6] & select_967_s4_q[0]) : centres_values_0_of_skin_q;
  logic select_2037;
  assign select_2037 = drew_s4_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2039;
  assign select_2039 = drew_s4_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  // hls/stages/agreement.hpp:290
  logic [10:0] select_2044;
  assign select_2044 = equal_1344_s4_q ? (equal_2041_s4_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:205
  logic [5:0] select_2047;
  assign select_2047 = and_359_s4_q ? (equal_1344_s4_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:842
  logic xor_2048;
  assign xor_2048 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:208
  logic select_2050;
  assign select_2050 = and_1057_s4_q ? (left_first_s4_q ? xor_2048 : write_half_q) : write_half_q;
  logic select_2052;
  assign select_2052 = and_1057_s4_q ? (left_first_s4_q ? xor_2048 : select_2050) : write_half_q;
  logic select_2054;
  assign select_2054 = left_first_s4_q ? select_1039 : (and_1057_s4_q ? select_1040 : read_half_q);
  logic and_2058;
  assign and_2058 = (~begins_product_q) & (done_q | said_q);
  logic [9:0] select_2067;
  assign select_2067 = left_first_s4_q ? 10'h1 : (and_1057_s4_q ? select_1044 : rows_passed_q);
  logic [8:0] select_2070;
  assign select_2070 = left_first_s4_q ? {select_1042[7:0], or_1041} : (and_1057_s4_q ? {select_1042[7:0], or_1041} : columns_passed_q);
  logic select_2073;
  assign select_2073 = left_first_s4_q ? marks_last_s4_q : (and_1057_s4_q ? marks_last_s4_q : line_ended_q);
  logic select_2076;
  assign select_2076 = left_first_s4_q ? and_1060 : (and_1057_s4_q ? and_1060 : began_q);
  logic [2:0] select_2079;
  assign select_2079 = left_first_s4_q ? select_1062 : (and_1057_s4_q ? select_1062 : seen_x_q);
  // hls/stages/agreement.hpp:871
  logic [2:0] select_2084;
  assign select_2084 = left_first_s4_q ? 3'h0 : (and_1045 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:208
  logic [2:0] select_2086;
  assign select_2086 = left_first_s4_q ? 3'h0 : (and_1057_s4_q ? select_2084 : seen_y_q);
  logic [7:0] select_2089;
  assign select_2089 = left_first_s4_q ? select_1053 : (and_1057_s4_q ? select_1053 : seen_column_q);
  // hls/stages/agreement.hpp:206
  logic [7:0] select_2095;
  assign select_2095 = left_first_s4_q ? select_2093 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:208
  logic [7:0] select_2097;
  assign select_2097 = left_first_s4_q ? select_2093 : (and_1057_s4_q ? select_2095 : seen_rows_left_q);
  // hls/stages/agreement.hpp:206
  logic and_2102;
  assign and_2102 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:208
  logic select_2104;
  assign select_2104 = left_first_s4_q ? and_2102 : (and_1057_s4_q ? and_2102 : at_cell_end_q);
  logic select_2107;
  assign select_2107 = left_first_s4_q ? next_row : (and_1057_s4_q ? next_row : was_next_row_q);
  logic [10:0] select_2110;
  assign select_2110 = left_first_s4_q ? 11'h0 : (and_1057_s4_q ? select_1050 : seen_base_q);
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2164;
  assign sum_2164 = {1'b0, upper} + {1'b0, lower};
  logic less_2165;
  assign less_2165 = 11'h4 < sum_2164[13:3];
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};
  // hls/stages/registration.hpp:100
  logic less_2168;
  assign less_2168 = 11'he < left[12:2];
  // hls/stages/registration.hpp:119
  logic less_2170;
  assign less_2170 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_2171;
  assign or_2171 = (~less_2168) | less_2170;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:100
  logic less_2173;
  assign less_2173 = 11'he < right[12:2];
  // hls/stages/registration.hpp:119
  logic less_2175;
  assign less_2175 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic select_2177;
  assign select_2177 = less_2165 ? (or_2171 ? less_2170 : less_2175) : less_2175;
  logic or_2178;
  assign or_2178 = (~less_2173) | select_2177;
  // hls/stages/registration.hpp:100
  logic less_2179;
  assign less_2179 = 11'he < upper[12:2];
  // hls/stages/registration.hpp:119
  logic less_2181;
  assign less_2181 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/registration.hpp:104
  logic select_2182;
  assign select_2182 = or_2178 ? select_2177 : less_2181;
  logic select_2184;
  assign select_2184 = less_2165 ? select_2182 : (less_2168 ? select_2182 : less_2181);
  logic or_2185;
  assign or_2185 = (~less_2179) | select_2184;
  // hls/stages/registration.hpp:119
  logic less_2186;
  assign less_2186 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_2187;
  assign select_2187 = or_2185 ? select_2184 : less_2186;
  logic select_2190;
  assign select_2190 = less_2165 ? select_2187 : (less_2168 ? select_2187 : (less_2173 ? select_2187 : less_2186));
  // hls/stages/registration.hpp:101
  logic less_2191;
  assign less_2191 = 11'he < lower[12:2];
  // hls/stages/registration.hpp:104
  logic or_2193;
  assign or_2193 = select_2190 | (~less_2191);
  // hls/stages/registration.hpp:119
  logic less_2194;
  assign less_2194 = $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
  // hls/stages/registration.hpp:105
  logic select_2195;
  assign select_2195 = or_2193 ? select_2190 : less_2194;
  logic select_2198;
  assign select_2198 = less_2168 ? select_2195 : (less_2173 ? select_2195 : (less_2179 ? select_2195 : less_2194));
  // hls/stages/agreement.hpp:770
  logic and_2210;
  assign and_2210 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2211;
  assign or_2211 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2210;
  logic select_2212;
  assign select_2212 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2211 : and_2210;
  logic and_2213;
  assign and_2213 = (less_2179 & less_2191) & select_2212;
  logic or_2214;
  assign or_2214 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2213;
  logic select_2215;
  assign select_2215 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2214 : and_2213;
  logic or_2216;
  assign or_2216 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2215;
  logic select_2217;
  assign select_2217 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2216 : select_2215;
  logic select_2218;
  assign select_2218 = (less_2168 & less_2173) ? select_2217 : and_2213;
  logic or_2219;
  assign or_2219 = (less_2165 ? select_2195 : select_2198) | select_2218;
  // hls/stages/registration.hpp:119
  logic less_2220;
  assign less_2220 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  // hls/stages/agreement.hpp:770
  logic or_2221;
  assign or_2221 = less_2220 | or_2219;
  logic select_2222;
  assign select_2222 = or_2193 ? or_2219 : or_2221;
  // hls/stages/registration.hpp:119
  logic less_2223;
  assign less_2223 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2226;
  assign less_2226 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2229;
  assign less_2229 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:770
  logic and_2262;
  assign and_2262 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1961 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:343
  logic [11:0] select_2275;
  assign select_2275 = equal_943_s4_q ? (equal_1943 ? registration_counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2277;
  assign select_2277 = equal_943_s4_q ? (equal_1943 ? registration_counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2279;
  assign select_2279 = equal_943_s4_q ? (equal_1943 ? registration_counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2281;
  assign select_2281 = equal_943_s4_q ? (equal_1943 ? registration_counts_measured_3_q : 12'h0) : 12'h0;

  // Memory regions, 64 x 36, DISTANCE 12, hls/stages/agreement.hpp:938; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1005;
  logic regions_re;
  assign regions_re = s4_en & (equal_943_s4_q ? not_1007 : and_1013);
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:957; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1055;
  logic map_re;
  assign map_re = s4_en & select_1069;
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
  assign best_left_we = s4_en & and_925_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_924_s4_q, select_923_s4_q, select_885, select_840_s4_q, select_839_s4_q};
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

  // Memory shown_right, write
  logic [5:0] shown_right_waddr;
  assign shown_right_waddr = select_973_s4_q;
  logic shown_right_we;
  assign shown_right_we = s4_en & and_994_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_988, not_974_s4_q};
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

  // Memory seen_columns, write
  logic [5:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s4_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s4_en & and_969_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1034, textured};
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
      counts_too_much_hidden_q <= select_1620;
      registration_counts_measured_0_q <= select_1713;
      registration_counts_measured_1_q <= select_1722;
      registration_counts_measured_2_q <= select_1730;
      registration_counts_measured_3_q <= select_1737;
      registration_counts_votes_0_down_q <= and_1523 ? 15'h0 : sum_1744;
      registration_counts_votes_0_up_q <= and_1523 ? 15'h0 : sum_1753;
      registration_counts_votes_1_down_q <= and_1523 ? 15'h0 : sum_1762;
      registration_counts_votes_1_up_q <= and_1523 ? 15'h0 : sum_1770;
      registration_counts_votes_2_down_q <= and_1523 ? 15'h0 : sum_1778;
      registration_counts_votes_2_up_q <= and_1523 ? 15'h0 : sum_1786;
      registration_counts_votes_3_down_q <= and_1523 ? 15'h0 : sum_1795;
      registration_counts_votes_3_up_q <= and_1523 ? 15'h0 : sum_1803;
      registration_counts_votes_4_down_q <= and_1523 ? 15'h0 : sum_1811;
      registration_counts_votes_4_up_q <= and_1523 ? 15'h0 : sum_1819;
      registration_counts_half_votes_0_down_q <= and_1523 ? 15'h0 : sum_1828;
      registration_counts_half_votes_0_up_q <= and_1523 ? 15'h0 : sum_1837;
      registration_counts_half_votes_1_down_q <= and_1523 ? 15'h0 : sum_1845;
      registration_counts_half_votes_1_up_q <= and_1523 ? 15'h0 : sum_1853;
      registration_counts_half_votes_2_down_q <= and_1523 ? 15'h0 : sum_1861;
      registration_counts_half_votes_2_up_q <= and_1523 ? 15'h0 : sum_1869;
      registration_counts_half_votes_3_down_q <= and_1523 ? 15'h0 : sum_1877;
      registration_counts_half_votes_3_up_q <= and_1523 ? 15'h0 : sum_1885;
      region_row_q <= and_359_s4_q ? select_1903 : region_row_q;
      region_columns_q <= equal_943_s4_q ? select_995 : (drew_s4_q ? select_1089 : 8'h1);
      region_across_rest_q <= select_1909;
      region_across_back_q <= drew_s4_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_359_s4_q ? select_1912 : columns_begin_rest_q;
      columns_begin_back_q <= and_359_s4_q ? select_1915 : columns_begin_back_q;
      region_down_rest_q <= select_1921;
      region_down_back_q <= select_1925;
      region_down_next_q <= select_1927;
      region_fresh_q <= and_359_s4_q ? select_1931 : region_fresh_q;
      segment_starts_q <= equal_943_s4_q ? or_1936 : (drew_s4_q ? select_1939 : or_1936);
      hidden_for_q <= select_1963;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1964};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s4_q;
      centres_values_0_textured_q <= select_2033;
      centres_values_0_of_skin_q <= equal_943_s4_q ? centres_values_0_of_skin_q : select_2035;
      centres_values_1_textured_q <= equal_943_s4_q ? centres_values_1_textured_q : select_2037;
      centres_values_1_of_skin_q <= equal_943_s4_q ? centres_values_1_of_skin_q : select_2039;
      map_row_q <= and_359_s4_q ? select_2044 : map_row_q;
      map_width_q <= select_2047;
      write_half_q <= select_2052;
      read_half_q <= and_1057_s4_q ? select_2054 : read_half_q;
      done_q <= and_1057_s4_q ? (not_1058 & and_2058) : and_2058;
      said_q <= equal_943_s4_q & equal_1943;
      rows_passed_q <= and_1057_s4_q ? select_2067 : rows_passed_q;
      columns_passed_q <= and_1057_s4_q ? select_2070 : columns_passed_q;
      line_ended_q <= and_1057_s4_q ? select_2073 : line_ended_q;
      began_q <= and_1057_s4_q ? select_2076 : began_q;
      seen_x_q <= and_1057_s4_q ? select_2079 : seen_x_q;
      seen_y_q <= and_1057_s4_q ? select_2086 : seen_y_q;
      seen_column_q <= and_1057_s4_q ? select_2089 : seen_column_q;
      seen_rows_left_q <= and_1057_s4_q ? select_2097 : seen_rows_left_q;
      at_cell_end_q <= and_1057_s4_q ? select_2104 : at_cell_end_q;
      was_next_row_q <= and_1057_s4_q ? select_2107 : was_next_row_q;
      seen_base_q <= and_1057_s4_q ? select_2110 : seen_base_q;
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
      averager_total_0_q <= select_1184;
      averager_total_1_q <= select_1186;
      census_columns_values_0_cell_0_left_q <= select_1210;
      census_columns_values_0_cell_0_right_q <= select_1211;
      census_columns_values_0_cell_0_mask_q <= select_1212;
      census_columns_values_0_cell_1_left_q <= select_1213;
      census_columns_values_0_cell_1_right_q <= select_1214;
      census_columns_values_0_cell_1_mask_q <= select_1215;
      census_columns_values_0_cell_2_left_q <= select_1216;
      census_columns_values_0_cell_2_right_q <= select_1217;
      census_columns_values_0_cell_2_mask_q <= select_1218;
      census_columns_values_0_cell_2_of_skin_q <= select_1219;
      census_columns_values_0_cell_3_left_q <= select_1220;
      census_columns_values_0_cell_3_right_q <= select_1221;
      census_columns_values_0_cell_3_mask_q <= select_1222;
      census_columns_values_0_cell_4_left_q <= select_1223;
      census_columns_values_0_cell_4_right_q <= select_1224;
      census_columns_values_0_cell_4_mask_q <= select_1225;
      census_columns_values_1_cell_0_left_q <= select_1226;
      census_columns_values_1_cell_0_right_q <= select_1227;
      census_columns_values_1_cell_0_mask_q <= select_1228;
      census_columns_values_1_cell_1_left_q <= select_1229;
      census_columns_values_1_cell_1_right_q <= select_1230;
      census_columns_values_1_cell_1_mask_q <= select_1231;
      census_columns_values_1_cell_2_left_q <= select_1232;
      census_columns_values_1_cell_2_right_q <= select_1233;
      census_columns_values_1_cell_2_mask_q <= select_1234;
      census_columns_values_1_cell_2_of_skin_q <= select_1235;
      census_columns_values_1_cell_3_left_q <= select_1236;
      census_columns_values_1_cell_3_right_q <= select_1237;
      census_columns_values_1_cell_3_mask_q <= select_1238;
      census_columns_values_1_cell_4_left_q <= select_1239;
      census_columns_values_1_cell_4_right_q <= select_1240;
      census_columns_values_1_cell_4_mask_q <= select_1241;
      census_columns_values_2_cell_0_left_q <= select_1242;
      census_columns_values_2_cell_0_right_q <= select_1243;
      census_columns_values_2_cell_0_mask_q <= select_1244;
      census_columns_values_2_cell_1_left_q <= select_1245;
      census_columns_values_2_cell_1_right_q <= select_1246;
      census_columns_values_2_cell_1_mask_q <= select_1247;
      census_columns_values_2_cell_2_left_q <= select_1248;
      census_columns_values_2_cell_2_right_q <= select_1249;
      census_columns_values_2_cell_2_mask_q <= select_1250;
      census_columns_values_2_cell_3_left_q <= select_1251;
      census_columns_values_2_cell_3_right_q <= select_1252;
      census_columns_values_2_cell_3_mask_q <= select_1253;
      census_columns_values_2_cell_4_left_q <= select_1254;
      census_columns_values_2_cell_4_right_q <= select_1255;
      census_columns_values_2_cell_4_mask_q <= select_1256;
      census_columns_values_3_cell_0_mask_q <= select_1257;
      census_columns_values_3_cell_1_left_q <= select_1258;
      census_columns_values_3_cell_1_right_q <= select_1259;
      census_columns_values_3_cell_1_mask_q <= select_1260;
      census_columns_values_3_cell_2_mask_q <= select_1261;
      census_columns_values_3_cell_3_left_q <= select_1262;
      census_columns_values_3_cell_3_right_q <= select_1263;
      census_columns_values_3_cell_3_mask_q <= select_1264;
      census_columns_values_3_cell_4_mask_q <= select_1265;
      sharpness_last_mean_0_q <= and_359_s4_q ? select_365 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_359_s4_q ? select_369 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= select_1985;
      box_textured_columns_values_1_q <= equal_943_s4_q ? box_textured_columns_values_1_q : select_1986;
      box_textured_columns_values_2_q <= equal_943_s4_q ? box_textured_columns_values_2_q : select_1988;
      box_textured_columns_values_3_q <= equal_943_s4_q ? box_textured_columns_values_3_q : select_1990;
      box_textured_columns_values_4_q <= equal_943_s4_q ? box_textured_columns_values_4_q : select_1992;
      box_textured_sum_sums_values_0_q <= select_1995;
      box_explained_columns_values_0_q <= equal_943_s4_q ? box_explained_columns_values_0_q : select_1996;
      box_explained_columns_values_1_q <= equal_943_s4_q ? box_explained_columns_values_1_q : select_1998;
      box_explained_columns_values_2_q <= equal_943_s4_q ? box_explained_columns_values_2_q : select_2000;
      box_explained_columns_values_3_q <= equal_943_s4_q ? box_explained_columns_values_3_q : select_2002;
      box_explained_columns_values_4_q <= equal_943_s4_q ? box_explained_columns_values_4_q : select_2004;
      box_explained_sum_sums_values_0_q <= select_2007;
      box_shown_columns_values_0_q <= select_2009;
      box_shown_columns_values_1_q <= equal_943_s4_q ? box_shown_columns_values_1_q : select_2010;
      box_shown_columns_values_2_q <= equal_943_s4_q ? box_shown_columns_values_2_q : select_2012;
      box_shown_columns_values_3_q <= equal_943_s4_q ? box_shown_columns_values_3_q : select_2014;
      box_shown_columns_values_4_q <= equal_943_s4_q ? box_shown_columns_values_4_q : select_2016;
      box_shown_sum_sums_values_0_q <= select_2019;
      box_nearer_columns_values_0_q <= select_2021;
      box_nearer_columns_values_1_q <= equal_943_s4_q ? box_nearer_columns_values_1_q : select_2022;
      box_nearer_columns_values_2_q <= equal_943_s4_q ? box_nearer_columns_values_2_q : select_2024;
      box_nearer_columns_values_3_q <= equal_943_s4_q ? box_nearer_columns_values_3_q : select_2026;
      box_nearer_columns_values_4_q <= equal_943_s4_q ? box_nearer_columns_values_4_q : select_2028;
      box_nearer_sum_sums_values_0_q <= select_2031;
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
  logic equal_943_s5_q;
  logic not_944_s5_q;
  logic [2:0] select_967_s5_q;
  logic or_998_s5_q;
  logic or_1001_s5_q;
  logic or_1004_s5_q;
  logic equal_1006_s5_q;
  logic textured_s5_q;
  logic explained_s5_q;
  logic and_1027_s5_q;
  logic and_1032_s5_q;
  logic and_1057_s5_q;
  logic and_1064_s5_q;
  logic less_1065_s5_q;
  logic [11:0] sum_1073_s5_q;
  logic equal_1087_s5_q;
  logic or_1092_s5_q;
  logic or_1095_s5_q;
  logic or_1098_s5_q;
  logic not_1122_s5_q;
  logic less_1136_s5_q;
  logic and_1147_s5_q;
  logic [11:0] sum_1285_s5_q;
  logic equal_1292_s5_q;
  logic [8:0] contrast_s5_q;
  logic [8:0] contrast_2_s5_q;
  logic and_1523_s5_q;
  logic and_1526_s5_q;
  logic equal_1541_s5_q;
  logic not_1557_s5_q;
  logic less_1621_s5_q;
  logic equal_1624_s5_q;
  logic equal_1625_s5_q;
  logic equal_1626_s5_q;
  logic [7:0] residual_s5_q;
  logic equal_1943_s5_q;
  logic and_2113_s5_q;
  logic less_2165_s5_q;
  logic less_2166_s5_q;
  logic less_2168_s5_q;
  logic or_2171_s5_q;
  logic less_2173_s5_q;
  logic or_2178_s5_q;
  logic less_2179_s5_q;
  logic or_2185_s5_q;
  logic select_2222_s5_q;
  logic or_2224_s5_q;
  logic less_2226_s5_q;
  logic less_2229_s5_q;
  logic select_2233_s5_q;
  logic and_2265_s5_q;
  logic [11:0] select_2275_s5_q;
  logic [11:0] select_2277_s5_q;
  logic [11:0] select_2279_s5_q;
  logic [11:0] select_2281_s5_q;
  logic and_2290_s5_q;
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
      equal_943_s5_q <= equal_943_s4_q;
      not_944_s5_q <= not_944_s4_q;
      select_967_s5_q <= {select_967_s4_q[4], select_967_s4_q[2], select_967_s4_q[0]};
      or_998_s5_q <= or_998;
      or_1001_s5_q <= or_1001;
      or_1004_s5_q <= or_1004;
      equal_1006_s5_q <= equal_1006;
      textured_s5_q <= textured;
      explained_s5_q <= explained;
      and_1027_s5_q <= and_1027;
      and_1032_s5_q <= not_944_s4_q & and_1013;
      and_1057_s5_q <= and_1057_s4_q;
      and_1064_s5_q <= and_1064;
      less_1065_s5_q <= less_1065;
      sum_1073_s5_q <= sum_1073;
      equal_1087_s5_q <= t[4:1] == 4'h0;
      or_1092_s5_q <= or_1092;
      or_1095_s5_q <= select_1089[7] | (~({select_1089[6], select_1089[3:2]} == 3'h0));
      or_1098_s5_q <= select_1089[7] | (~(select_1089[6:4] == 3'h0));
      not_1122_s5_q <= ~({sum_1120, around[0]} < {2'h0, t});
      less_1136_s5_q <= {1'b0, around[4:1]} < n;
      and_1147_s5_q <= and_1147_s4_q;
      sum_1285_s5_q <= ({1'b0, sum_1277} + {2'h0, sum_1280}) + {2'h0, sum_1284};
      equal_1292_s5_q <= equal_1292_s4_q;
      contrast_s5_q <= contrast;
      contrast_2_s5_q <= contrast_2;
      and_1523_s5_q <= and_1523;
      and_1526_s5_q <= and_1526;
      equal_1541_s5_q <= x_s4_q[7:1] == 7'h0;
      not_1557_s5_q <= ~({sum_1555, e[0]} < {2'h0, t});
      less_1621_s5_q <= less_1621_s4_q;
      equal_1624_s5_q <= equal_1624;
      equal_1625_s5_q <= equal_1625;
      equal_1626_s5_q <= equal_1626;
      residual_s5_q <= residual[7:0];
      equal_1943_s5_q <= equal_1943;
      and_2113_s5_q <= and_1147_s4_q & (sum_1073 == sum_1055);
      less_2165_s5_q <= less_2165;
      less_2166_s5_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2168_s5_q <= less_2168;
      or_2171_s5_q <= or_2171;
      less_2173_s5_q <= less_2173;
      or_2178_s5_q <= or_2178;
      less_2179_s5_q <= less_2179;
      or_2185_s5_q <= or_2185;
      select_2222_s5_q <= select_2222;
      or_2224_s5_q <= less_2223 | select_2222;
      less_2226_s5_q <= less_2226;
      less_2229_s5_q <= less_2229;
      select_2233_s5_q <= less_2191 ? or_2221 : select_2218;
      and_2265_s5_q <= equal_943_s4_q & (equal_1943 & (cfg_prove_i & and_2262));
      select_2275_s5_q <= select_2275;
      select_2277_s5_q <= select_2277;
      select_2279_s5_q <= select_2279;
      select_2281_s5_q <= select_2281;
      and_2290_s5_q <= equal_943_s4_q & not_1007;
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
  // hls/stages/agreement.hpp:542
  logic [5:0] select_1017;
  assign select_1017 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:543
  logic [5:0] sum_1018;
  assign sum_1018 = {5'h0, textured_s5_q} + select_1017;
  // hls/stages/agreement.hpp:683
  logic [11:0] sum_1020;
  assign sum_1020 = {6'h0, sum_1018} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:542
  logic [5:0] select_1022;
  assign select_1022 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:543
  logic [5:0] sum_1023;
  assign sum_1023 = {5'h0, explained_s5_q} + select_1022;
  // hls/stages/agreement.hpp:684
  logic [11:0] sum_1025;
  assign sum_1025 = {6'h0, sum_1023} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:542
  logic [5:0] select_1028;
  assign select_1028 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:544
  logic [5:0] sum_1029;
  assign sum_1029 = {5'h0, and_1027_s5_q} + select_1028;
  // hls/stages/agreement.hpp:685
  logic [11:0] sum_1031;
  assign sum_1031 = {6'h0, sum_1029} + (region_fresh_s5_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:723
  logic not_1099;
  assign not_1099 = ~region_row_s5_q[2];
  logic [2:0] select_1100;
  assign select_1100 = region_row_s5_q[1] ? {1'b0, not_1099, 1'b0} : {region_row_s5_q[2], 1'b0, not_1099};
  logic [5:0] select_1101;
  assign select_1101 = region_row_s5_q[0] ? {select_1100[2], 1'b0, select_1100[1], 1'b0, select_1100[0], 1'b0} : {1'b0, select_1100[2], 1'b0, select_1100[1], 1'b0, select_1100[0]};
  logic [11:0] select_1102;
  assign select_1102 = or_1098_s5_q ? {select_1101[5], 1'b0, select_1101[4], 1'b0, select_1101[3], 1'b0, select_1101[2], 1'b0, select_1101[1], 1'b0, select_1101[0], 1'b0} : {1'b0, select_1101[5], 1'b0, select_1101[4], 1'b0, select_1101[3], 1'b0, select_1101[2], 1'b0, select_1101[1], 1'b0, select_1101[0]};
  logic [23:0] select_1103;
  assign select_1103 = or_1095_s5_q ? {select_1102[11], 1'b0, select_1102[10], 1'b0, select_1102[9], 1'b0, select_1102[8], 1'b0, select_1102[7], 1'b0, select_1102[6], 1'b0, select_1102[5], 1'b0, select_1102[4], 1'b0, select_1102[3], 1'b0, select_1102[2], 1'b0, select_1102[1], 1'b0, select_1102[0], 1'b0} : {1'b0, select_1102[11], 1'b0, select_1102[10], 1'b0, select_1102[9], 1'b0, select_1102[8], 1'b0, select_1102[7], 1'b0, select_1102[6], 1'b0, select_1102[5], 1'b0, select_1102[4], 1'b0, select_1102[3], 1'b0, select_1102[2], 1'b0, select_1102[1], 1'b0, select_1102[0]};
  logic [47:0] select_1104;
  assign select_1104 = or_1092_s5_q ? {select_1103[23], 1'b0, select_1103[22], 1'b0, select_1103[21], 1'b0, select_1103[20], 1'b0, select_1103[19], 1'b0, select_1103[18], 1'b0, select_1103[17], 1'b0, select_1103[16], 1'b0, select_1103[15], 1'b0, select_1103[14], 1'b0, select_1103[13], 1'b0, select_1103[12], 1'b0, select_1103[11], 1'b0, select_1103[10], 1'b0, select_1103[9], 1'b0, select_1103[8], 1'b0, select_1103[7], 1'b0, select_1103[6], 1'b0, select_1103[5], 1'b0, select_1103[4], 1'b0, select_1103[3], 1'b0, select_1103[2], 1'b0, select_1103[1], 1'b0, select_1103[0], 1'b0} : {1'b0, select_1103[23], 1'b0, select_1103[22], 1'b0, select_1103[21], 1'b0, select_1103[20], 1'b0, select_1103[19], 1'b0, select_1103[18], 1'b0, select_1103[17], 1'b0, select_1103[16], 1'b0, select_1103[15], 1'b0, select_1103[14], 1'b0, select_1103[13], 1'b0, select_1103[12], 1'b0, select_1103[11], 1'b0, select_1103[10], 1'b0, select_1103[9], 1'b0, select_1103[8], 1'b0, select_1103[7], 1'b0, select_1103[6], 1'b0, select_1103[5], 1'b0, select_1103[4], 1'b0, select_1103[3], 1'b0, select_1103[2], 1'b0, select_1103[1], 1'b0, select_1103[0]};
  logic not_1107;
  assign not_1107 = ~((good_q & select_1104) == 48'h0);
  // hls/stages/agreement.hpp:725
  logic is_seen;
  assign is_seen = equal_1087_s5_q ? not_1107 : not_1122_s5_q;
  // hls/stages/agreement.hpp:737
  logic and_1137;
  assign and_1137 = is_seen & less_1136_s5_q;
  // hls/stages/agreement.hpp:204
  logic [8:0] select_1176;
  assign select_1176 = sample_pair_whole_s5_q ? (and_357_s5_q ? grey_s5_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1178;
  assign select_1178 = sample_pair_whole_s5_q ? (and_357_s5_q ? grey_2_s5_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1180;
  assign select_1180 = sample_pair_whole_s5_q ? (and_357_s5_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1182;
  assign select_1182 = sample_pair_whole_s5_q ? (and_357_s5_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1187;
  assign sum_1187 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s5_q};
  logic [9:0] difference_1188;
  assign difference_1188 = {1'b0, sum_1187[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1189;
  assign xor_1189 = {difference_1188[8:0], sum_1187[0]} ^ {10{difference_1188[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1188[9]} + {1'b0, xor_1189};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_362_s5_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1194;
  assign select_1194 = sample_pair_whole_s5_q ? (and_357_s5_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1195;
  assign sum_1195 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s5_q};
  logic [9:0] difference_1196;
  assign difference_1196 = {1'b0, sum_1195[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1197;
  assign xor_1197 = {difference_1196[8:0], sum_1195[0]} ^ {10{difference_1196[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1196[9]} + {1'b0, xor_1197};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_362_s5_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:204
  logic [13:0] select_1202;
  assign select_1202 = sample_pair_whole_s5_q ? (and_357_s5_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1287;
  assign select_1287 = and_359_s5_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1288;
  assign select_1288 = and_359_s5_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1289;
  assign select_1289 = and_359_s5_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1290;
  assign select_1290 = and_359_s5_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_1293;
  assign sum_1293 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1285_s5_q};
  logic [13:0] sum_1295;
  assign sum_1295 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1293});
  // hls/stages/census.hpp:225
  logic and_1297;
  assign and_1297 = and_447_s5_q & (9'h4 < sum_1295[13:5]);
  // hls/stages/census.hpp:226
  logic and_1298;
  assign and_1298 = and_447_s5_q & less_471;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1299;
  assign sum_1299 = census_left_misses_q + {{17{and_1298}}, and_1297, 1'b0, and_1297};
  // hls/stages/agreement.hpp:205
  logic [19:0] select_1301;
  assign select_1301 = and_359_s5_q ? (equal_1292_s5_q ? 20'h0 : sum_1299) : census_left_misses_q;
  // hls/stages/agreement.hpp:204
  logic [27:0] select_1306;
  assign select_1306 = sample_pair_whole_s5_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:275
  logic and_1311;
  assign and_1311 = whole_2_s5_q & (~(column_s5_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:287
  logic and_1317;
  assign and_1317 = and_1311 & (sharpness_last_mask_q & (7'h2 < contrast_s5_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1306[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1319;
  assign select_1319 = and_1317 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1321;
  assign select_1321 = equal_1292_s5_q ? {11'h0, select_1319} : (sharpness_sums_detail_0_q + {11'h0, select_1319});
  // hls/stages/agreement.hpp:287
  logic and_1328;
  assign and_1328 = and_1311 & (sharpness_last_mask_q & (7'h2 < contrast_2_s5_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1306[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1330;
  assign select_1330 = and_1328 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1332;
  assign select_1332 = equal_1292_s5_q ? {11'h0, select_1330} : (sharpness_sums_detail_1_q + {11'h0, select_1330});
  logic [8:0] select_1335;
  assign select_1335 = and_1317 ? contrast_s5_q : 9'h0;
  logic [23:0] sum_1336;
  assign sum_1336 = (equal_1292_s5_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1335};
  logic [8:0] select_1339;
  assign select_1339 = and_1328 ? contrast_2_s5_q : 9'h0;
  logic [23:0] sum_1340;
  assign sum_1340 = (equal_1292_s5_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1339};
  // hls/stages/agreement.hpp:566
  logic [13:0] select_1528;
  assign select_1528 = and_1523_s5_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1526_s5_q});
  // hls/stages/agreement.hpp:343
  logic and_1530;
  assign and_1530 = not_944_s5_q & (begins_product_q & textured_s5_q);
  logic and_1534;
  assign and_1534 = not_944_s5_q & (begins_product_q & explained_s5_q);
  logic and_1538;
  assign and_1538 = not_944_s5_q & (begins_product_q & and_1027_s5_q);
  // hls/stages/agreement.hpp:724
  logic select_1558;
  assign select_1558 = equal_1087_s5_q ? not_1107 : not_1557_s5_q;
  // hls/stages/agreement.hpp:729
  logic not_1559;
  assign not_1559 = ~select_1558;
  // hls/stages/agreement.hpp:343
  logic and_1562;
  assign and_1562 = begins_product_q & ((~equal_1541_s5_q) & (centres_values_1_textured_s5_q & not_1559));
  logic and_1563;
  assign and_1563 = not_944_s5_q & and_1562;
  // hls/stages/agreement.hpp:755
  logic less_1566;
  assign less_1566 = region_row_s5_q < x_s5_q[5:3];
  logic [11:0] select_1567;
  assign select_1567 = less_1566 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1570;
  assign select_1570 = less_1566 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:756
  logic [12:0] sum_1571;
  assign sum_1571 = {1'b0, select_1570} + {3'h0, select_1570[11:2]};
  logic and_1573;
  assign and_1573 = (~(select_1567[11:4] == 8'h0)) & ({sum_1571, select_1570[1:0]} < {3'h0, select_1567});
  // hls/stages/agreement.hpp:766
  logic [11:0] select_1575;
  assign select_1575 = equal_1006_s5_q ? 12'h0 : (and_1573 ? select_1567 : 12'h0);
  // hls/stages/agreement.hpp:343
  logic [11:0] select_1576;
  assign select_1576 = equal_943_s5_q ? select_1575 : 12'h0;
  // hls/stages/agreement.hpp:566
  logic [13:0] select_1578;
  assign select_1578 = and_1523_s5_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1576});
  // hls/stages/agreement.hpp:660
  logic [1:0] difference_1579;
  assign difference_1579 = 2'h0 - {1'b0, select_967_s5_q[2]};
  // hls/stages/agreement.hpp:664
  logic [9:0] select_1580;
  assign select_1580 = select_967_s5_q[1] ? {difference_1579, cfg_explained_limit_i} : 10'h0;
  // hls/stages/agreement.hpp:343
  logic [9:0] select_1582;
  assign select_1582 = begins_product_q ? (select_967_s5_q[0] ? select_1580 : 10'h0) : 10'h0;
  logic [9:0] select_1583;
  assign select_1583 = equal_943_s5_q ? 10'h0 : select_1582;
  // hls/stages/agreement.hpp:561
  logic [23:0] sum_1584;
  assign sum_1584 = counts_too_little_explained_q + {{14{select_1583[9]}}, select_1583};
  // hls/stages/agreement.hpp:186
  logic [8:0] select_1588;
  assign select_1588 = select_967_s5_q[0] ? (select_967_s5_q[1] ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0) : 9'h0;
  // hls/stages/agreement.hpp:343
  logic [8:0] select_1589;
  assign select_1589 = begins_product_q ? select_1588 : 9'h0;
  logic [20:0] select_1590;
  assign select_1590 = equal_943_s5_q ? {1'b0, select_1575, 8'h0} : {{12{select_1589[8]}}, select_1589};
  // hls/stages/agreement.hpp:566
  logic [23:0] select_1592;
  assign select_1592 = and_1523_s5_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1590[20]}}, select_1590});
  // hls/stages/agreement.hpp:664
  logic [8:0] select_1594;
  assign select_1594 = select_967_s5_q[1] ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1595;
  assign select_1595 = select_967_s5_q[0] ? select_1594[7:0] : 8'h0;
  // hls/stages/agreement.hpp:186
  logic and_1596;
  assign and_1596 = select_967_s5_q[0] & select_1594[8];
  // hls/stages/agreement.hpp:735
  logic [2:0] select_1599;
  assign select_1599 = centres_values_1_textured_s5_q ? (select_1558 ? {3{and_1596}} : ({3{and_1596}} + 3'h1)) : {3{and_1596}};
  logic [2:0] select_1600;
  assign select_1600 = equal_1541_s5_q ? {3{and_1596}} : select_1599;
  // hls/stages/agreement.hpp:343
  logic [10:0] select_1602;
  assign select_1602 = equal_943_s5_q ? 11'h0 : (begins_product_q ? {select_1600, select_1595} : 11'h0);
  // hls/stages/agreement.hpp:563
  logic [23:0] sum_1603;
  assign sum_1603 = counts_too_much_unproven_q + {{13{select_1602[10]}}, select_1602};
  // hls/stages/agreement.hpp:735
  logic [9:0] select_1606;
  assign select_1606 = centres_values_1_of_skin_s5_q ? ({1'b0, not_1559, 8'h0} - {2'h0, cfg_unproven_skin_limit_i}) : 10'h0;
  logic [9:0] select_1608;
  assign select_1608 = equal_1541_s5_q ? 10'h0 : (centres_values_1_textured_s5_q ? select_1606 : 10'h0);
  // hls/stages/agreement.hpp:343
  logic [9:0] select_1610;
  assign select_1610 = equal_943_s5_q ? 10'h0 : (begins_product_q ? select_1608 : 10'h0);
  // hls/stages/agreement.hpp:564
  logic [23:0] sum_1611;
  assign sum_1611 = counts_too_much_unseen_skin_q + {{14{select_1610[9]}}, select_1610};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1666;
  assign select_1666 = equal_1625_s5_q ? 8'h0 : (equal_1626_s5_q ? 8'h0 : residual_s5_q);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1669;
  assign select_1669 = select_967_s5_q[2] ? (less_1621_s5_q ? (equal_1624_s5_q ? 8'h0 : select_1666) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1671;
  assign select_1671 = begins_product_q ? (select_967_s5_q[0] ? select_1669 : 8'h0) : 8'h0;
  logic [7:0] select_1672;
  assign select_1672 = equal_943_s5_q ? 8'h0 : select_1671;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1673;
  assign sum_1673 = registration_counts_across_0_q + {{12{select_1672[7]}}, select_1672};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1676;
  assign select_1676 = equal_1625_s5_q ? 8'h0 : (equal_1626_s5_q ? residual_s5_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1679;
  assign select_1679 = select_967_s5_q[2] ? (less_1621_s5_q ? (equal_1624_s5_q ? 8'h0 : select_1676) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1681;
  assign select_1681 = begins_product_q ? (select_967_s5_q[0] ? select_1679 : 8'h0) : 8'h0;
  logic [7:0] select_1682;
  assign select_1682 = equal_943_s5_q ? 8'h0 : select_1681;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1683;
  assign sum_1683 = registration_counts_across_1_q + {{12{select_1682[7]}}, select_1682};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1686;
  assign select_1686 = equal_1624_s5_q ? 8'h0 : (equal_1625_s5_q ? residual_s5_q : 8'h0);
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1688;
  assign select_1688 = select_967_s5_q[2] ? (less_1621_s5_q ? select_1686 : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1690;
  assign select_1690 = begins_product_q ? (select_967_s5_q[0] ? select_1688 : 8'h0) : 8'h0;
  logic [7:0] select_1691;
  assign select_1691 = equal_943_s5_q ? 8'h0 : select_1690;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1692;
  assign sum_1692 = registration_counts_across_2_q + {{12{select_1691[7]}}, select_1691};
  // hls/stages/agreement.hpp:186
  logic [7:0] select_1696;
  assign select_1696 = select_967_s5_q[2] ? (less_1621_s5_q ? (equal_1624_s5_q ? residual_s5_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:343
  logic [7:0] select_1698;
  assign select_1698 = begins_product_q ? (select_967_s5_q[0] ? select_1696 : 8'h0) : 8'h0;
  logic [7:0] select_1699;
  assign select_1699 = equal_943_s5_q ? 8'h0 : select_1698;
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1700;
  assign sum_1700 = registration_counts_across_3_q + {{12{select_1699[7]}}, select_1699};
  // hls/stages/agreement.hpp:751
  logic and_1948;
  assign and_1948 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:752
  logic less_1949;
  assign less_1949 = $signed(24'h0) < $signed(counts_too_little_explained_q);
  // hls/stages/agreement.hpp:758
  logic [12:0] sum_1952;
  assign sum_1952 = {1'b0, select_1570} + {2'h0, select_1570[11:1]};
  logic select_1955;
  assign select_1955 = (select_1567[11:3] == 9'h0) ? (and_1948 & (~less_1949)) : (~({sum_1952, select_1570[0]} < {2'h0, select_1567}));
  // hls/stages/agreement.hpp:766
  logic [47:0] select_1956;
  assign select_1956 = equal_1006_s5_q ? good_next_q : {select_1955, good_next_q[47:1]};
  // hls/stages/agreement.hpp:343
  logic [47:0] select_1958;
  assign select_1958 = equal_943_s5_q ? (equal_1943_s5_q ? select_1956 : good_q) : good_q;
  // hls/stages/agreement.hpp:783
  logic [35:0] select_1975;
  assign select_1975 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:777
  logic [35:0] detail_left;
  assign detail_left = begins_product_s5_q ? 36'h0 : select_1975;
  // hls/stages/agreement.hpp:783
  logic [35:0] select_1978;
  assign select_1978 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:787
  logic [35:0] detail_right;
  assign detail_right = begins_product_s5_q ? 36'h0 : select_1978;
  // hls/stages/agreement.hpp:777
  logic [34:0] select_1980;
  assign select_1980 = begins_product_s5_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:787
  logic [34:0] select_1981;
  assign select_1981 = begins_product_s5_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:777
  logic [17:0] select_1982;
  assign select_1982 = begins_product_s5_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:787
  logic [17:0] select_1983;
  assign select_1983 = begins_product_s5_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:846
  logic select_2061;
  assign select_2061 = left_first_s5_q ? done_s5_q : proven_q;
  // hls/stages/agreement.hpp:208
  logic select_2063;
  assign select_2063 = left_first_s5_q ? done_s5_q : (and_1057_s5_q ? select_2061 : proven_q);
  // hls/stages/agreement.hpp:875
  logic [1:0] select_2114;
  assign select_2114 = and_2113_s5_q ? {and_1137, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:876
  logic and_2115;
  assign and_2115 = select_2061 & less_2091;
  // hls/stages/agreement.hpp:208
  logic select_2118;
  assign select_2118 = and_1064_s5_q ? (less_1065_s5_q ? (select_2114[0] & and_2115) : seen_q) : seen_q;
  logic select_2120;
  assign select_2120 = left_first_s5_q ? select_2118 : (and_1057_s5_q ? select_2118 : seen_q);
  logic select_2121;
  assign select_2121 = and_1057_s5_q ? select_2120 : seen_q;
  logic select_2124;
  assign select_2124 = and_1064_s5_q ? (less_1065_s5_q ? (select_2114[1] & and_2115) : nearer_q) : nearer_q;
  logic select_2126;
  assign select_2126 = left_first_s5_q ? select_2124 : (and_1057_s5_q ? select_2124 : nearer_q);
  logic select_2127;
  assign select_2127 = and_1057_s5_q ? select_2126 : nearer_q;
  // hls/stages/agreement.hpp:343
  logic [13:0] select_2132;
  assign select_2132 = equal_943_s5_q ? (equal_1943_s5_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_2134;
  assign select_2134 = equal_943_s5_q ? (equal_1943_s5_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_2136;
  assign select_2136 = equal_943_s5_q ? (equal_1943_s5_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_2138;
  assign select_2138 = equal_943_s5_q ? (equal_1943_s5_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_2140;
  assign select_2140 = equal_943_s5_q ? (equal_1943_s5_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_2142;
  assign select_2142 = equal_943_s5_q ? (equal_1943_s5_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  // hls/stages/agreement.hpp:803
  logic not_2147;
  assign not_2147 = ~and_1948;
  // hls/stages/agreement.hpp:804
  logic or_2151;
  assign or_2151 = not_2128 | not_2147;
  // hls/stages/agreement.hpp:770
  logic or_2157;
  assign or_2157 = ($signed(24'h0) < $signed(counts_too_much_unproven_q)) | ($signed(24'h0) < $signed(counts_too_much_unseen_skin_q));
  logic select_2159;
  assign select_2159 = (less_1949 | or_2151) ? (~or_2151) : (($signed(24'h0) < $signed(counts_too_many_bad_q)) | or_2157);
  logic select_2225;
  assign select_2225 = or_2185_s5_q ? select_2222_s5_q : or_2224_s5_q;
  logic or_2227;
  assign or_2227 = less_2226_s5_q | select_2225;
  logic select_2228;
  assign select_2228 = or_2178_s5_q ? select_2225 : or_2227;
  logic or_2230;
  assign or_2230 = less_2229_s5_q | select_2228;
  logic select_2235;
  assign select_2235 = less_2173_s5_q ? or_2227 : (less_2179_s5_q ? or_2224_s5_q : select_2233_s5_q);
  logic select_2237;
  assign select_2237 = less_2165_s5_q ? (less_2166_s5_q | (or_2171_s5_q ? select_2228 : or_2230)) : (less_2168_s5_q ? or_2230 : select_2235);
  // hls/stages/agreement.hpp:811
  logic and_2241;
  assign and_2241 = cfg_prove_i & and_1948;
  // hls/stages/agreement.hpp:812
  logic [36:0] sum_2242;
  assign sum_2242 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2244;
  assign less_2244 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:770
  logic or_2247;
  assign or_2247 = ({detail_left, 3'h0} < {sum_2242, detail_right[1:0]}) | (less_2244 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:815
  logic [36:0] sum_2251;
  assign sum_2251 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2253;
  assign less_2253 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:770
  logic or_2254;
  assign or_2254 = ({detail_right, 3'h0} < {sum_2251, detail_left[1:0]}) | less_2253;
  // hls/stages/agreement.hpp:343
  logic [19:0] select_2267;
  assign select_2267 = equal_943_s5_q ? (equal_1943_s5_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2269;
  assign select_2269 = equal_943_s5_q ? (equal_1943_s5_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2271;
  assign select_2271 = equal_943_s5_q ? (equal_1943_s5_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2273;
  assign select_2273 = equal_943_s5_q ? (equal_1943_s5_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [23:0] select_2283;
  assign select_2283 = equal_943_s5_q ? (equal_1943_s5_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2285;
  assign select_2285 = equal_943_s5_q ? (equal_1943_s5_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2287;
  assign select_2287 = equal_943_s5_q ? (equal_1943_s5_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2289;
  assign select_2289 = equal_943_s5_q ? (equal_1943_s5_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  // hls/stages/agreement.hpp:766
  logic [11:0] select_2298;
  assign select_2298 = equal_1006_s5_q ? 12'h0 : (less_1566 ? 12'h0 : regions_rdata_q[35:24]);

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
  assign regions_waddr = {region_row_s5_q, or_1004_s5_q, or_1001_s5_q, or_998_s5_q};
  logic regions_we;
  assign regions_we = s5_en & and_1032_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1031, sum_1025, sum_1020};
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
  assign map_waddr = sum_1073_s5_q;
  logic map_we;
  assign map_we = s5_en & and_1147_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1137, is_seen};
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
      census_left_misses_q <= select_1301;
      sharpness_sums_detail_0_q <= and_359_s5_q ? select_1321 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_359_s5_q ? select_1332 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_359_s5_q ? sum_1336 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_359_s5_q ? sum_1340 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1528;
      counts_textured_q <= and_1523_s5_q ? 14'h0 : (counts_textured_q + {13'h0, and_1530});
      counts_explained_q <= and_1523_s5_q ? 14'h0 : (counts_explained_q + {13'h0, and_1534});
      counts_nearer_q <= and_1523_s5_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1538});
      counts_unproven_q <= and_1523_s5_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1563});
      counts_regions_bad_q <= select_1578;
      counts_too_little_explained_q <= and_1523_s5_q ? 24'h0 : sum_1584;
      counts_too_many_bad_q <= select_1592;
      counts_too_much_unproven_q <= and_1523_s5_q ? 24'h0 : sum_1603;
      counts_too_much_unseen_skin_q <= and_1523_s5_q ? 24'h0 : sum_1611;
      registration_counts_across_0_q <= and_1523_s5_q ? 20'h0 : sum_1673;
      registration_counts_across_1_q <= and_1523_s5_q ? 20'h0 : sum_1683;
      registration_counts_across_2_q <= and_1523_s5_q ? 20'h0 : sum_1692;
      registration_counts_across_3_q <= and_1523_s5_q ? 20'h0 : sum_1700;
      segment_textured_q <= select_1017 + {5'h0, and_1530};
      segment_explained_q <= select_1022 + {5'h0, and_1534};
      segment_nearer_q <= select_1028 + {5'h0, and_1538};
      segment_started_q <= ~segment_starts_q;
      good_q <= select_1958;
      good_next_q <= equal_943_s5_q ? select_1956 : good_next_q;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1980;
      addend_1_q <= select_1981;
      multiplier_0_q <= select_1982;
      multiplier_1_q <= select_1983;
      proven_q <= and_1057_s5_q ? select_2063 : proven_q;
      seen_q <= select_2121;
      nearer_q <= select_2127;
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
      averager_quarter_1_0_q <= select_1176;
      averager_quarter_1_1_q <= select_1178;
      averager_quarter_2_0_q <= select_1180;
      averager_quarter_2_1_q <= select_1182;
      averager_detail_0_q <= select_1194;
      averager_detail_1_q <= select_1202;
      census_changes_values_0_left_q <= and_359_s5_q ? texture_s5_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_359_s5_q ? sum_1285_s5_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1287;
      census_changes_values_1_right_q <= select_1288;
      census_changes_values_2_left_q <= select_1289;
      census_changes_values_2_right_q <= select_1290;
      sharpness_last_mask_q <= and_359_s5_q ? whole_2_s5_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_359_s5_q ? select_1306[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_359_s5_q ? select_1306[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic and_2065_s6_q;
  logic or_2129_s6_q;
  logic and_2130_s6_q;
  logic [13:0] select_2132_s6_q;
  logic [13:0] select_2134_s6_q;
  logic [13:0] select_2136_s6_q;
  logic [13:0] select_2138_s6_q;
  logic [13:0] select_2140_s6_q;
  logic [13:0] select_2142_s6_q;
  logic and_2146_s6_q;
  logic and_2150_s6_q;
  logic and_2161_s6_q;
  logic and_2240_s6_q;
  logic and_2250_s6_q;
  logic and_2257_s6_q;
  logic and_2265_s6_q;
  logic [19:0] select_2267_s6_q;
  logic [19:0] select_2269_s6_q;
  logic [19:0] select_2271_s6_q;
  logic [19:0] select_2273_s6_q;
  logic [11:0] select_2275_s6_q;
  logic [11:0] select_2277_s6_q;
  logic [11:0] select_2279_s6_q;
  logic [11:0] select_2281_s6_q;
  logic [23:0] select_2283_s6_q;
  logic [23:0] select_2285_s6_q;
  logic [23:0] select_2287_s6_q;
  logic [23:0] select_2289_s6_q;
  logic and_2290_s6_q;
  logic [5:0] select_2292_s6_q;
  logic [11:0] select_2294_s6_q;
  logic [11:0] select_2296_s6_q;
  logic [11:0] select_2299_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      and_2065_s6_q <= said_q;
      or_2129_s6_q <= not_2128 | select_2121;
      and_2130_s6_q <= cfg_prove_i & select_2127;
      select_2132_s6_q <= select_2132;
      select_2134_s6_q <= select_2134;
      select_2136_s6_q <= select_2136;
      select_2138_s6_q <= select_2138;
      select_2140_s6_q <= select_2140;
      select_2142_s6_q <= select_2142;
      and_2146_s6_q <= equal_943_s5_q & (equal_1943_s5_q & (cfg_prove_i & (~proven_q)));
      and_2150_s6_q <= equal_943_s5_q & (equal_1943_s5_q & (cfg_prove_i & not_2147));
      and_2161_s6_q <= equal_943_s5_q & (equal_1943_s5_q & select_2159);
      and_2240_s6_q <= equal_943_s5_q & (equal_1943_s5_q & (cfg_prove_i & select_2237));
      and_2250_s6_q <= equal_943_s5_q & (equal_1943_s5_q & (and_2241 & or_2247));
      and_2257_s6_q <= equal_943_s5_q & (equal_1943_s5_q & (and_2241 & or_2254));
      and_2265_s6_q <= and_2265_s5_q;
      select_2267_s6_q <= select_2267;
      select_2269_s6_q <= select_2269;
      select_2271_s6_q <= select_2271;
      select_2273_s6_q <= select_2273;
      select_2275_s6_q <= select_2275_s5_q;
      select_2277_s6_q <= select_2277_s5_q;
      select_2279_s6_q <= select_2279_s5_q;
      select_2281_s6_q <= select_2281_s5_q;
      select_2283_s6_q <= select_2283;
      select_2285_s6_q <= select_2285;
      select_2287_s6_q <= select_2287;
      select_2289_s6_q <= select_2289;
      and_2290_s6_q <= and_2290_s5_q;
      select_2292_s6_q <= equal_943_s5_q ? (equal_1006_s5_q ? 6'h0 : x_s5_q) : 6'h0;
      select_2294_s6_q <= equal_943_s5_q ? (equal_1006_s5_q ? 12'h0 : select_1567) : 12'h0;
      select_2296_s6_q <= equal_943_s5_q ? (equal_1006_s5_q ? 12'h0 : select_1570) : 12'h0;
      select_2299_s6_q <= equal_943_s5_q ? select_2298 : 12'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s6_q;
  assign saturated_o = saturated_s6_q;
  assign mask_o = mask_s6_q;
  assign marks_first_o = marks_first_s6_q;
  assign marks_last_o = marks_last_s6_q;
  assign marks_seen_o = or_2129_s6_q;
  assign marks_nearer_o = and_2130_s6_q;
  assign verdict_valid_o = and_2065_s6_q;
  assign verdict_supervised_o = {2'h0, select_2132_s6_q};
  assign verdict_textured_o = {2'h0, select_2134_s6_q};
  assign verdict_explained_o = {2'h0, select_2136_s6_q};
  assign verdict_nearer_o = {2'h0, select_2138_s6_q};
  assign verdict_unproven_o = {2'h0, select_2140_s6_q};
  assign verdict_regions_bad_o = {2'h0, select_2142_s6_q};
  assign verdict_unproven_yet_o = and_2146_s6_q;
  assign verdict_untextured_o = and_2150_s6_q;
  assign verdict_disagree_o = and_2161_s6_q;
  assign verdict_moved_o = and_2240_s6_q;
  assign verdict_unsharp_left_o = and_2250_s6_q;
  assign verdict_unsharp_right_o = and_2257_s6_q;
  assign verdict_hidden_o = and_2265_s6_q;
  assign verdict_across_0_o = select_2267_s6_q;
  assign verdict_across_1_o = select_2269_s6_q;
  assign verdict_across_2_o = select_2271_s6_q;
  assign verdict_across_3_o = select_2273_s6_q;
  assign verdict_measured_0_o = select_2275_s6_q;
  assign verdict_measured_1_o = select_2277_s6_q;
  assign verdict_measured_2_o = select_2279_s6_q;
  assign verdict_measured_3_o = select_2281_s6_q;
  assign verdict_detail_0_o = select_2283_s6_q;
  assign verdict_detail_1_o = select_2285_s6_q;
  assign verdict_contrast_0_o = select_2287_s6_q;
  assign verdict_contrast_1_o = select_2289_s6_q;
  assign region_valid_o = and_2290_s6_q;
  assign region_region_o = select_2292_s6_q;
  assign region_textured_o = select_2294_s6_q;
  assign region_explained_o = select_2296_s6_q;
  assign region_nearer_o = select_2299_s6_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_2164[2:0], sum_1655[0], sum_1651[0], sum_1643[1:0], sum_1642[1:0], sum_1638[0], detail_4[1:0], detail_3[1:0], sum_1295[4:0], sum_881[8:0], sum_470[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
