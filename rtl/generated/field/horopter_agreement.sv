// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2523 bits, pipeline 1118 bits, memories 29120 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {2'h0, cfg_width_i[8:3]} + 8'hff;
  logic [3:0] sum_1327;
  assign sum_1327 = {2'h0, cfg_width_i[8:7]} + 4'hf;
  logic [5:0] sum_1331;
  assign sum_1331 = {1'b0, cfg_width_i[8:4]} + 6'h7;
  logic [5:0] sum_1346;
  assign sum_1346 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_1783;
  assign difference_1783 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_1981;
  assign less_1981 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_1982;
  assign sum_1982 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_1983;
  assign select_1983 = less_1981 ? {sum_1982, cfg_height_i[5:3]} : 8'h0;
  logic not_2018;
  assign not_2018 = ~cfg_prove_i;

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
  logic [2:0] select_314;
  assign select_314 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_316;
  assign select_316 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [7:0] select_319;
  assign select_319 = ({select_316, select_314} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:95
  logic [7:0] select_320;
  assign select_320 = select_314[0] ? averager_place_q : select_319;
  // hls/stages/census.hpp:40
  logic or_321;
  assign or_321 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:181
  logic and_327;
  assign and_327 = (~((~or_321) | (~select_314[0]))) & (select_320 < 8'hbd);
  // hls/stages/census.hpp:40
  logic [2:0] select_332;
  assign select_332 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:181
  logic whole;
  assign whole = select_314[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:183
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_316 : 6'h0;
  // hls/stages/census.hpp:45
  logic equal_349;
  assign equal_349 = select_314 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_350;
  assign equal_350 = select_332 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_351;
  assign and_351 = equal_350 & and_327;
  // hls/stages/agreement.hpp:183
  logic and_353;
  assign and_353 = sample_pair_whole_q & (equal_349 & and_351);
  // hls/stages/agreement.hpp:352
  logic equal_372;
  assign equal_372 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:339
  logic not_373;
  assign not_373 = ~equal_372;
  // hls/stages/agreement.hpp:352
  logic equal_374;
  assign equal_374 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:410
  logic less_375;
  assign less_375 = run_highest_q < x_q;
  // hls/stages/agreement.hpp:414
  logic not_376;
  assign not_376 = ~less_375;
  // hls/stages/agreement.hpp:317
  logic and_377;
  assign and_377 = equal_374 & not_376;
  logic and_378;
  assign and_378 = not_373 & and_377;
  // hls/stages/census.hpp:40
  logic [5:0] select_405;
  assign select_405 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:183
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_405 : 6'h0;
  // hls/stages/agreement.hpp:675
  logic drew;
  assign drew = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:317
  logic and_463;
  assign and_463 = drew & not_376;
  // hls/stages/agreement.hpp:429
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:125
  logic and_981;
  assign and_981 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:623
  logic [6:0] sum_1056;
  assign sum_1056 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:183
  logic [2:0] select_1072;
  assign select_1072 = sample_pair_whole_q ? (sample_last_q ? (select_332 + 3'h1) : select_332) : raster_at_y_q;
  logic [5:0] select_1074;
  assign select_1074 = sample_pair_whole_q ? (select_316 + {5'h0, equal_349}) : raster_at_column_q;
  logic [5:0] select_1077;
  assign select_1077 = sample_pair_whole_q ? (sample_last_q ? (select_405 + {5'h0, equal_350}) : select_405) : raster_at_row_q;
  logic select_1081;
  assign select_1081 = sample_pair_whole_q ? (sample_last_q ? (or_321 & (~raster_final_row_q)) : or_321) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_1083;
  assign select_1083 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:183
  logic select_1087;
  assign select_1087 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:263
  logic equal_1259;
  assign equal_1259 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:179
  logic [2:0] select_1260;
  assign select_1260 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1263;
  assign select_1263 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1266;
  assign select_1266 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1269;
  assign select_1269 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1272;
  assign select_1272 = ends_q ? following_shift_q : run_shift_q;
  logic select_1275;
  assign select_1275 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:264
  logic not_1276;
  assign not_1276 = ~equal_1259;
  // hls/stages/agreement.hpp:344
  logic not_1279;
  assign not_1279 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:352
  logic equal_1280;
  assign equal_1280 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:155
  logic or_1281;
  assign or_1281 = equal_1280 | equal_374;
  logic [2:0] select_1282;
  assign select_1282 = equal_372 ? {run_last_shift_q, {2{not_1279}}} : {1'b0, or_1281, equal_374};
  logic [7:0] select_1285;
  assign select_1285 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [5:0] select_1286;
  assign select_1286 = equal_374 ? least_q : 6'h0;
  logic [7:0] select_1290;
  assign select_1290 = run_last_shift_q ? {2'h0, last_q} : (run_shift_q[5] ? {2'h0, last_q} : next_highest_q);
  logic [5:0] select_1292;
  assign select_1292 = equal_374 ? last_q : (equal_1280 ? last_q : 6'h0);
  logic [6:0] select_1296;
  assign select_1296 = equal_1280 ? whole_beats_q : 7'h0;
  logic [7:0] select_1298;
  assign select_1298 = equal_372 ? (run_last_shift_q ? {1'b0, whole_beats_q} : next_beats_q) : (equal_374 ? first_beats_q : {1'b0, select_1296});
  logic [5:0] select_1303;
  assign select_1303 = equal_372 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_374 ? (6'h0 - least_q) : 6'h0);
  // hls/stages/agreement.hpp:138
  logic not_1305;
  assign not_1305 = ~drew;
  // hls/stages/agreement.hpp:155
  logic select_1309;
  assign select_1309 = equal_372 ? (next_last_shift_q & not_1279) : (equal_374 & (least_q == 6'h0));
  // hls/stages/agreement.hpp:179
  logic [7:0] select_1312;
  assign select_1312 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1316;
  assign select_1316 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:270
  logic less_1323;
  assign less_1323 = 5'he < column[5:1];
  // hls/stages/agreement.hpp:184
  logic [5:0] select_1326;
  assign select_1326 = and_353 ? (equal_1259 ? (less_1323 ? 6'h1e : column) : least_q) : least_q;
  // hls/stages/agreement.hpp:264
  logic [7:0] select_1329;
  assign select_1329 = equal_1259 ? (less_1323 ? {sum_1327, cfg_width_i[6:3]} : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1333;
  assign select_1333 = and_353 ? (equal_1259 ? {sum_1331, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:320
  logic not_1334;
  assign not_1334 = ~ends_q;
  // hls/stages/agreement.hpp:179
  logic [5:0] select_1335;
  assign select_1335 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1337;
  assign select_1337 = and_353 ? (equal_1259 ? 7'h0 : {select_1335, not_1334}) : {select_1335, not_1334};
  // hls/stages/agreement.hpp:179
  logic and_1339;
  assign and_1339 = not_1334 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:280
  logic [6:0] sum_1342;
  assign sum_1342 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:264
  logic select_1344;
  assign select_1344 = equal_1259 ? ({sum_1342[6], cfg_height_i[8:3]} == {1'b0, sum_1342[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:538
  logic [4:0] sum_1489;
  assign sum_1489 = {1'b0, last_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:148
  logic not_1845;
  assign not_1845 = ~run_shift_q[5];

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:802; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_378;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:803; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (equal_372 ? not_376 : (equal_374 ? not_376 : and_463));
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:804; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_372 ? (run_shift_q + x_q[5:0]) : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (equal_372 ? not_376 : and_377);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
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
      left_first_q <= and_981 ? left_first_q : marks_first_i;
      right_q <= (~and_981) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_981;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_314 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_1072;
      raster_at_column_q <= select_1074;
      raster_at_row_q <= select_1077;
      raster_at_live_q <= select_1081;
      raster_rows_left_q <= sample_pair_whole_q ? select_1083 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_1087;
      averager_place_q <= sample_pair_whole_q ? select_320 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= and_353 ? (equal_1259 ? 3'h1 : select_1260) : select_1260;
      run_lowest_q <= and_353 ? (equal_1259 ? 8'h0 : select_1263) : select_1263;
      run_highest_q <= and_353 ? (equal_1259 ? 8'h0 : select_1266) : select_1266;
      run_beats_q <= and_353 ? (equal_1259 ? 8'hc : select_1269) : select_1269;
      run_shift_q <= and_353 ? (equal_1259 ? 6'h0 : select_1272) : select_1272;
      run_last_shift_q <= and_353 ? (select_1275 & not_1276) : select_1275;
      following_phase_q <= drew ? {final_row_q, 1'b0, final_row_q} : select_1282;
      following_lowest_q <= drew ? 8'h0 : (equal_372 ? select_1285 : {2'h0, select_1286});
      following_highest_q <= drew ? 8'h0 : (equal_372 ? select_1290 : {2'h0, select_1292});
      following_beats_q <= drew ? 8'h3f : select_1298;
      following_shift_q <= drew ? 6'h0 : select_1303;
      following_last_shift_q <= not_1305 & select_1309;
      x_q <= and_353 ? (equal_1259 ? 8'h0 : select_1312) : select_1312;
      beats_left_q <= and_353 ? (equal_1259 ? 8'hc : select_1316) : select_1316;
      last_q <= and_353 ? (equal_1259 ? column : last_q) : last_q;
      least_q <= select_1326;
      first_beats_q <= and_353 ? select_1329 : first_beats_q;
      whole_beats_q <= select_1333;
      age_q <= select_1337;
      ends_q <= and_353 ? (and_1339 & not_1276) : and_1339;
      final_row_q <= and_353 ? select_1344 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1845}}, 1'b1} + run_beats_q;
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
  logic select_314_s1_q;
  logic [7:0] select_320_s1_q;
  logic and_327_s1_q;
  logic equal_333_s1_q;
  logic whole_s1_q;
  logic [5:0] column_s1_q;
  logic and_351_s1_q;
  logic and_353_s1_q;
  logic equal_356_s1_q;
  logic equal_372_s1_q;
  logic not_373_s1_q;
  logic equal_374_s1_q;
  logic less_375_s1_q;
  logic not_376_s1_q;
  logic and_378_s1_q;
  logic [5:0] row_s1_q;
  logic drew_s1_q;
  logic and_463_s1_q;
  logic [6:0] x_s1_2_q;
  logic and_517_s1_q;
  logic equal_523_s1_q;
  logic equal_590_s1_q;
  logic equal_827_s1_q;
  logic equal_891_s1_q;
  logic equal_914_s1_q;
  logic equal_917_s1_q;
  logic not_1058_s1_q;
  logic equal_1259_s1_q;
  logic not_1305_s1_q;
  logic less_1490_s1_q;
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
      select_314_s1_q <= select_314[0];
      select_320_s1_q <= select_320;
      and_327_s1_q <= and_327;
      equal_333_s1_q <= select_332 == 3'h0;
      whole_s1_q <= whole;
      column_s1_q <= column;
      and_351_s1_q <= and_351;
      and_353_s1_q <= and_353;
      equal_356_s1_q <= select_314 == 3'h1;
      equal_372_s1_q <= equal_372;
      not_373_s1_q <= not_373;
      equal_374_s1_q <= equal_374;
      less_375_s1_q <= less_375;
      not_376_s1_q <= not_376;
      and_378_s1_q <= and_378;
      row_s1_q <= row;
      drew_s1_q <= drew;
      and_463_s1_q <= and_463;
      x_s1_2_q <= x[6:0];
      and_517_s1_q <= age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q}));
      equal_523_s1_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      equal_590_s1_q <= run_lowest_q == x_q;
      equal_827_s1_q <= run_lowest_q == x;
      equal_891_s1_q <= run_highest_q == x;
      equal_914_s1_q <= x_q == {2'h0, last_q};
      equal_917_s1_q <= run_phase_q == 3'h5;
      not_1058_s1_q <= ~({sum_1056, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1259_s1_q <= equal_1259;
      not_1305_s1_q <= not_1305;
      less_1490_s1_q <= {2'h0, sum_1489, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/census.hpp:98
  logic and_328;
  assign and_328 = sample_pair_whole_s1_q & and_327_s1_q;
  // hls/stages/agreement.hpp:385
  logic equal_467;
  assign equal_467 = row_q == 6'h0;
  logic [11:0] select_468;
  assign select_468 = equal_467 ? 12'h0 : left_rdata_q[11:0];
  logic not_469;
  assign not_469 = ~equal_467;
  logic and_470;
  assign and_470 = left_rdata_q[12] & not_469;
  logic and_471;
  assign and_471 = left_rdata_q[13] & not_469;
  logic and_472;
  assign and_472 = left_rdata_q[14] & not_469;
  logic and_473;
  assign and_473 = left_rdata_q[15] & not_469;
  logic equal_474;
  assign equal_474 = row_q[5:1] == 5'h0;
  logic [11:0] select_475;
  assign select_475 = equal_474 ? 12'h0 : left_rdata_q[27:16];
  logic not_476;
  assign not_476 = ~equal_474;
  logic and_477;
  assign and_477 = left_rdata_q[28] & not_476;
  logic and_478;
  assign and_478 = left_rdata_q[29] & not_476;
  logic and_479;
  assign and_479 = left_rdata_q[30] & not_476;
  logic and_480;
  assign and_480 = left_rdata_q[31] & not_476;
  logic less_481;
  assign less_481 = row_q < 6'h3;
  logic [11:0] select_482;
  assign select_482 = less_481 ? 12'h0 : left_rdata_q[43:32];
  logic not_483;
  assign not_483 = ~less_481;
  logic and_484;
  assign and_484 = left_rdata_q[44] & not_483;
  logic and_485;
  assign and_485 = left_rdata_q[45] & not_483;
  logic and_486;
  assign and_486 = left_rdata_q[46] & not_483;
  logic and_487;
  assign and_487 = left_rdata_q[47] & not_483;
  logic equal_488;
  assign equal_488 = row_q[5:2] == 4'h0;
  logic [11:0] select_489;
  assign select_489 = equal_488 ? 12'h0 : left_rdata_q[59:48];
  logic not_490;
  assign not_490 = ~equal_488;
  logic and_491;
  assign and_491 = left_rdata_q[60] & not_490;
  // hls/stages/agreement.hpp:386
  logic [11:0] select_496;
  assign select_496 = equal_467 ? 12'h0 : right_codes_rdata_q[11:0];
  logic and_497;
  assign and_497 = right_codes_rdata_q[12] & not_469;
  logic [11:0] select_498;
  assign select_498 = equal_474 ? 12'h0 : right_codes_rdata_q[24:13];
  logic and_499;
  assign and_499 = right_codes_rdata_q[25] & not_476;
  logic [11:0] select_500;
  assign select_500 = less_481 ? 12'h0 : right_codes_rdata_q[37:26];
  logic and_501;
  assign and_501 = right_codes_rdata_q[38] & not_483;
  logic [11:0] select_502;
  assign select_502 = equal_488 ? 12'h0 : right_codes_rdata_q[50:39];
  logic and_503;
  assign and_503 = right_codes_rdata_q[51] & not_490;
  logic less_504;
  assign less_504 = row_q < 6'h5;
  logic [11:0] select_505;
  assign select_505 = less_504 ? 12'h0 : right_codes_rdata_q[63:52];
  logic and_507;
  assign and_507 = right_codes_rdata_q[64] & (~less_504);
  logic less_508;
  assign less_508 = row_q[5:1] < 5'h3;
  logic [11:0] select_509;
  assign select_509 = less_508 ? 12'h0 : right_codes_rdata_q[76:65];
  logic and_511;
  assign and_511 = right_codes_rdata_q[77] & (~less_508);
  // hls/stages/agreement.hpp:337
  logic not_518;
  assign not_518 = ~equal_374_s1_q;
  // hls/stages/agreement.hpp:317
  logic and_519;
  assign and_519 = not_518 & and_463_s1_q;
  logic select_520;
  assign select_520 = equal_372_s1_q ? and_517_s1_q : and_519;
  // hls/stages/agreement.hpp:167
  logic and_529;
  assign and_529 = left_rdata_q[44] & not_376_s1_q;
  logic [11:0] a;
  assign a = less_375_s1_q ? 12'h0 : left_rdata_q[43:32];
  logic [11:0] b;
  assign b = less_375_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_535;
  assign not_535 = ~(a ^ b);
  logic [1:0] sum_537;
  assign sum_537 = {1'b0, not_535[2]} + ({1'b0, not_535[0]} + {1'b0, not_535[1]});
  logic [2:0] sum_540;
  assign sum_540 = {2'h0, not_535[5]} + ({2'h0, not_535[4]} + ({2'h0, not_535[3]} + {1'b0, sum_537}));
  logic [2:0] sum_541;
  assign sum_541 = {2'h0, not_535[6]} + sum_540;
  logic [3:0] sum_544;
  assign sum_544 = {3'h0, not_535[9]} + ({3'h0, not_535[8]} + ({3'h0, not_535[7]} + {1'b0, sum_541}));
  // hls/stages/agreement.hpp:167
  logic [11:0] a_2;
  assign a_2 = less_375_s1_q ? 12'h0 : left_rdata_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_375_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_554;
  assign not_554 = ~(a_2 ^ b_2);
  logic [1:0] sum_556;
  assign sum_556 = {1'b0, not_554[2]} + ({1'b0, not_554[0]} + {1'b0, not_554[1]});
  logic [2:0] sum_559;
  assign sum_559 = {2'h0, not_554[5]} + ({2'h0, not_554[4]} + ({2'h0, not_554[3]} + {1'b0, sum_556}));
  logic [2:0] sum_560;
  assign sum_560 = {2'h0, not_554[6]} + sum_559;
  logic [3:0] sum_563;
  assign sum_563 = {3'h0, not_554[9]} + ({3'h0, not_554[8]} + ({3'h0, not_554[7]} + {1'b0, sum_560}));
  // hls/stages/agreement.hpp:167
  logic and_568;
  assign and_568 = left_rdata_q[76] & not_376_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_375_s1_q ? 12'h0 : left_rdata_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_375_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_574;
  assign not_574 = ~(a_3 ^ b_3);
  logic [1:0] sum_576;
  assign sum_576 = {1'b0, not_574[2]} + ({1'b0, not_574[0]} + {1'b0, not_574[1]});
  logic [2:0] sum_579;
  assign sum_579 = {2'h0, not_574[5]} + ({2'h0, not_574[4]} + ({2'h0, not_574[3]} + {1'b0, sum_576}));
  logic [2:0] sum_580;
  assign sum_580 = {2'h0, not_574[6]} + sum_579;
  logic [3:0] sum_583;
  assign sum_583 = {3'h0, not_574[9]} + ({3'h0, not_574[8]} + ({3'h0, not_574[7]} + {1'b0, sum_580}));
  logic [11:0] not_595;
  assign not_595 = ~(a ^ b_2);
  logic [1:0] sum_597;
  assign sum_597 = {1'b0, not_595[2]} + ({1'b0, not_595[0]} + {1'b0, not_595[1]});
  logic [2:0] sum_600;
  assign sum_600 = {2'h0, not_595[5]} + ({2'h0, not_595[4]} + ({2'h0, not_595[3]} + {1'b0, sum_597}));
  logic [2:0] sum_601;
  assign sum_601 = {2'h0, not_595[6]} + sum_600;
  logic [3:0] sum_604;
  assign sum_604 = {3'h0, not_595[9]} + ({3'h0, not_595[8]} + ({3'h0, not_595[7]} + {1'b0, sum_601}));
  logic [11:0] not_610;
  assign not_610 = ~(a_2 ^ b_3);
  logic [1:0] sum_612;
  assign sum_612 = {1'b0, not_610[2]} + ({1'b0, not_610[0]} + {1'b0, not_610[1]});
  logic [2:0] sum_615;
  assign sum_615 = {2'h0, not_610[5]} + ({2'h0, not_610[4]} + ({2'h0, not_610[3]} + {1'b0, sum_612}));
  logic [2:0] sum_616;
  assign sum_616 = {2'h0, not_610[6]} + sum_615;
  logic [3:0] sum_619;
  assign sum_619 = {3'h0, not_610[9]} + ({3'h0, not_610[8]} + ({3'h0, not_610[7]} + {1'b0, sum_616}));
  // hls/stages/agreement.hpp:167
  logic [11:0] b_4;
  assign b_4 = less_375_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_628;
  assign not_628 = ~(a_3 ^ b_4);
  logic [1:0] sum_630;
  assign sum_630 = {1'b0, not_628[2]} + ({1'b0, not_628[0]} + {1'b0, not_628[1]});
  logic [2:0] sum_633;
  assign sum_633 = {2'h0, not_628[5]} + ({2'h0, not_628[4]} + ({2'h0, not_628[3]} + {1'b0, sum_630}));
  logic [2:0] sum_634;
  assign sum_634 = {2'h0, not_628[6]} + sum_633;
  logic [3:0] sum_637;
  assign sum_637 = {3'h0, not_628[9]} + ({3'h0, not_628[8]} + ({3'h0, not_628[7]} + {1'b0, sum_634}));
  // hls/stages/agreement.hpp:167
  logic [11:0] b_5;
  assign b_5 = less_375_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_652;
  assign not_652 = ~(a ^ b_5);
  logic [1:0] sum_654;
  assign sum_654 = {1'b0, not_652[2]} + ({1'b0, not_652[0]} + {1'b0, not_652[1]});
  logic [2:0] sum_657;
  assign sum_657 = {2'h0, not_652[5]} + ({2'h0, not_652[4]} + ({2'h0, not_652[3]} + {1'b0, sum_654}));
  logic [2:0] sum_658;
  assign sum_658 = {2'h0, not_652[6]} + sum_657;
  logic [3:0] sum_661;
  assign sum_661 = {3'h0, not_652[9]} + ({3'h0, not_652[8]} + ({3'h0, not_652[7]} + {1'b0, sum_658}));
  logic [11:0] not_667;
  assign not_667 = ~(a_2 ^ b);
  logic [1:0] sum_669;
  assign sum_669 = {1'b0, not_667[2]} + ({1'b0, not_667[0]} + {1'b0, not_667[1]});
  logic [2:0] sum_672;
  assign sum_672 = {2'h0, not_667[5]} + ({2'h0, not_667[4]} + ({2'h0, not_667[3]} + {1'b0, sum_669}));
  logic [2:0] sum_673;
  assign sum_673 = {2'h0, not_667[6]} + sum_672;
  logic [3:0] sum_676;
  assign sum_676 = {3'h0, not_667[9]} + ({3'h0, not_667[8]} + ({3'h0, not_667[7]} + {1'b0, sum_673}));
  logic [11:0] not_683;
  assign not_683 = ~(a_3 ^ b_2);
  logic [1:0] sum_685;
  assign sum_685 = {1'b0, not_683[2]} + ({1'b0, not_683[0]} + {1'b0, not_683[1]});
  logic [2:0] sum_688;
  assign sum_688 = {2'h0, not_683[5]} + ({2'h0, not_683[4]} + ({2'h0, not_683[3]} + {1'b0, sum_685}));
  logic [2:0] sum_689;
  assign sum_689 = {2'h0, not_683[6]} + sum_688;
  logic [3:0] sum_692;
  assign sum_692 = {3'h0, not_683[9]} + ({3'h0, not_683[8]} + ({3'h0, not_683[7]} + {1'b0, sum_689}));
  logic [11:0] not_707;
  assign not_707 = ~(a ^ b_3);
  logic [1:0] sum_709;
  assign sum_709 = {1'b0, not_707[2]} + ({1'b0, not_707[0]} + {1'b0, not_707[1]});
  logic [2:0] sum_712;
  assign sum_712 = {2'h0, not_707[5]} + ({2'h0, not_707[4]} + ({2'h0, not_707[3]} + {1'b0, sum_709}));
  logic [2:0] sum_713;
  assign sum_713 = {2'h0, not_707[6]} + sum_712;
  logic [3:0] sum_716;
  assign sum_716 = {3'h0, not_707[9]} + ({3'h0, not_707[8]} + ({3'h0, not_707[7]} + {1'b0, sum_713}));
  logic [11:0] not_722;
  assign not_722 = ~(a_2 ^ b_4);
  logic [1:0] sum_724;
  assign sum_724 = {1'b0, not_722[2]} + ({1'b0, not_722[0]} + {1'b0, not_722[1]});
  logic [2:0] sum_727;
  assign sum_727 = {2'h0, not_722[5]} + ({2'h0, not_722[4]} + ({2'h0, not_722[3]} + {1'b0, sum_724}));
  logic [2:0] sum_728;
  assign sum_728 = {2'h0, not_722[6]} + sum_727;
  logic [3:0] sum_731;
  assign sum_731 = {3'h0, not_722[9]} + ({3'h0, not_722[8]} + ({3'h0, not_722[7]} + {1'b0, sum_728}));
  // hls/stages/agreement.hpp:167
  logic [11:0] b_6;
  assign b_6 = less_375_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_740;
  assign not_740 = ~(a_3 ^ b_6);
  logic [1:0] sum_742;
  assign sum_742 = {1'b0, not_740[2]} + ({1'b0, not_740[0]} + {1'b0, not_740[1]});
  logic [2:0] sum_745;
  assign sum_745 = {2'h0, not_740[5]} + ({2'h0, not_740[4]} + ({2'h0, not_740[3]} + {1'b0, sum_742}));
  logic [2:0] sum_746;
  assign sum_746 = {2'h0, not_740[6]} + sum_745;
  logic [3:0] sum_749;
  assign sum_749 = {3'h0, not_740[9]} + ({3'h0, not_740[8]} + ({3'h0, not_740[7]} + {1'b0, sum_746}));
  // hls/stages/agreement.hpp:167
  logic [11:0] b_7;
  assign b_7 = less_375_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_769;
  assign not_769 = ~(a ^ b_7);
  logic [1:0] sum_771;
  assign sum_771 = {1'b0, not_769[2]} + ({1'b0, not_769[0]} + {1'b0, not_769[1]});
  logic [2:0] sum_774;
  assign sum_774 = {2'h0, not_769[5]} + ({2'h0, not_769[4]} + ({2'h0, not_769[3]} + {1'b0, sum_771}));
  logic [2:0] sum_775;
  assign sum_775 = {2'h0, not_769[6]} + sum_774;
  logic [3:0] sum_778;
  assign sum_778 = {3'h0, not_769[9]} + ({3'h0, not_769[8]} + ({3'h0, not_769[7]} + {1'b0, sum_775}));
  logic [11:0] not_784;
  assign not_784 = ~(a_2 ^ b_5);
  logic [1:0] sum_786;
  assign sum_786 = {1'b0, not_784[2]} + ({1'b0, not_784[0]} + {1'b0, not_784[1]});
  logic [2:0] sum_789;
  assign sum_789 = {2'h0, not_784[5]} + ({2'h0, not_784[4]} + ({2'h0, not_784[3]} + {1'b0, sum_786}));
  logic [2:0] sum_790;
  assign sum_790 = {2'h0, not_784[6]} + sum_789;
  logic [3:0] sum_793;
  assign sum_793 = {3'h0, not_784[9]} + ({3'h0, not_784[8]} + ({3'h0, not_784[7]} + {1'b0, sum_790}));
  logic [11:0] not_800;
  assign not_800 = ~(a_3 ^ b);
  logic [1:0] sum_802;
  assign sum_802 = {1'b0, not_800[2]} + ({1'b0, not_800[0]} + {1'b0, not_800[1]});
  logic [2:0] sum_805;
  assign sum_805 = {2'h0, not_800[5]} + ({2'h0, not_800[4]} + ({2'h0, not_800[3]} + {1'b0, sum_802}));
  logic [2:0] sum_806;
  assign sum_806 = {2'h0, not_800[6]} + sum_805;
  logic [3:0] sum_809;
  assign sum_809 = {3'h0, not_800[9]} + ({3'h0, not_800[8]} + ({3'h0, not_800[7]} + {1'b0, sum_806}));
  // hls/stages/agreement.hpp:529
  logic not_926;
  assign not_926 = ~(row_q[5:3] == 3'h0);
  // hls/stages/agreement.hpp:317
  logic and_1060;
  assign and_1060 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1058_s1_q);
  // hls/stages/agreement.hpp:264
  logic select_1349;
  assign select_1349 = equal_1259_s1_q ? (~({row_s1_q, 1'b0} < {sum_1346, cfg_height_i[3]})) : lower_half_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:146; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_320_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_328;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory best_left, 47 x 22, DISTANCE 12, hls/stages/agreement.hpp:805; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 22'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = equal_372_s1_q ? x_s1_2_q[5:0] : x_s1_q[5:0];
  logic best_left_re;
  assign best_left_re = s1_en & select_520;
  logic [21:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_378_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_491, select_489, and_487, and_486, and_485, and_484, select_482, and_480, and_479, and_478, and_477, select_475, and_473, and_472, and_471, and_470, select_468, fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_378_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_511, select_509, and_507, select_505, and_503, select_502, and_501, select_500, and_499, select_498, and_497, select_496, fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_353_s1_q ? (equal_1259_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_353_s1_q ? select_1349 : lower_half_q;
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
  logic select_314_s2_q;
  logic [7:0] select_320_s2_q;
  logic and_327_s2_q;
  logic and_328_s2_q;
  logic equal_333_s2_q;
  logic whole_s2_q;
  logic [5:0] column_s2_q;
  logic and_351_s2_q;
  logic and_353_s2_q;
  logic equal_356_s2_q;
  logic equal_372_s2_q;
  logic not_373_s2_q;
  logic equal_374_s2_q;
  logic less_375_s2_q;
  logic not_376_s2_q;
  logic equal_407_s2_q;
  logic drew_s2_q;
  logic left_rdata_s2_q;
  logic [6:0] x_s2_2_q;
  logic not_518_s2_q;
  logic select_520_s2_q;
  logic equal_523_s2_q;
  logic and_529_s2_q;
  logic and_530_s2_q;
  logic not_535_s2_q;
  logic [3:0] sum_545_s2_q;
  logic and_548_s2_q;
  logic and_549_s2_q;
  logic not_554_s2_q;
  logic [3:0] sum_564_s2_q;
  logic and_568_s2_q;
  logic and_569_s2_q;
  logic not_574_s2_q;
  logic [3:0] sum_584_s2_q;
  logic equal_590_s2_q;
  logic not_595_s2_q;
  logic [3:0] sum_605_s2_q;
  logic not_610_s2_q;
  logic [3:0] sum_620_s2_q;
  logic and_624_s2_q;
  logic not_628_s2_q;
  logic [3:0] sum_638_s2_q;
  logic and_648_s2_q;
  logic not_652_s2_q;
  logic [3:0] sum_662_s2_q;
  logic not_667_s2_q;
  logic [3:0] sum_677_s2_q;
  logic not_683_s2_q;
  logic [3:0] sum_693_s2_q;
  logic not_707_s2_q;
  logic [3:0] sum_717_s2_q;
  logic not_722_s2_q;
  logic [3:0] sum_732_s2_q;
  logic and_737_s2_q;
  logic not_740_s2_q;
  logic [3:0] sum_750_s2_q;
  logic and_766_s2_q;
  logic not_769_s2_q;
  logic [3:0] sum_779_s2_q;
  logic not_784_s2_q;
  logic [3:0] sum_794_s2_q;
  logic not_800_s2_q;
  logic [3:0] sum_810_s2_q;
  logic equal_827_s2_q;
  logic and_885_s2_q;
  logic equal_891_s2_q;
  logic equal_914_s2_q;
  logic equal_917_s2_q;
  logic and_928_s2_q;
  logic and_959_s2_q;
  logic and_981_s2_q;
  logic and_1062_s2_q;
  logic equal_1207_s2_q;
  logic equal_1259_s2_q;
  logic not_1305_s2_q;
  logic and_1393_s2_q;
  logic less_1487_s2_q;
  logic less_1490_s2_q;
  logic equal_1752_s2_q;
  logic less_1763_s2_q;
  logic equal_1928_s2_q;
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
      select_314_s2_q <= select_314_s1_q;
      select_320_s2_q <= select_320_s1_q;
      and_327_s2_q <= and_327_s1_q;
      and_328_s2_q <= and_328;
      equal_333_s2_q <= equal_333_s1_q;
      whole_s2_q <= whole_s1_q;
      column_s2_q <= column_s1_q;
      and_351_s2_q <= and_351_s1_q;
      and_353_s2_q <= and_353_s1_q;
      equal_356_s2_q <= equal_356_s1_q;
      equal_372_s2_q <= equal_372_s1_q;
      not_373_s2_q <= not_373_s1_q;
      equal_374_s2_q <= equal_374_s1_q;
      less_375_s2_q <= less_375_s1_q;
      not_376_s2_q <= not_376_s1_q;
      equal_407_s2_q <= row_s1_q == 6'h0;
      drew_s2_q <= drew_s1_q;
      left_rdata_s2_q <= left_rdata_q[63];
      x_s2_2_q <= x_s1_2_q;
      not_518_s2_q <= not_518;
      select_520_s2_q <= select_520;
      equal_523_s2_q <= equal_523_s1_q;
      and_529_s2_q <= and_529;
      and_530_s2_q <= right_codes_rdata_q[38] & not_376_s1_q;
      not_535_s2_q <= not_535[11];
      sum_545_s2_q <= {3'h0, not_535[10]} + sum_544;
      and_548_s2_q <= left_rdata_q[60] & not_376_s1_q;
      and_549_s2_q <= right_codes_rdata_q[51] & not_376_s1_q;
      not_554_s2_q <= not_554[11];
      sum_564_s2_q <= {3'h0, not_554[10]} + sum_563;
      and_568_s2_q <= and_568;
      and_569_s2_q <= right_codes_rdata_q[64] & not_376_s1_q;
      not_574_s2_q <= not_574[11];
      sum_584_s2_q <= {3'h0, not_574[10]} + sum_583;
      equal_590_s2_q <= equal_590_s1_q;
      not_595_s2_q <= not_595[11];
      sum_605_s2_q <= {3'h0, not_595[10]} + sum_604;
      not_610_s2_q <= not_610[11];
      sum_620_s2_q <= {3'h0, not_610[10]} + sum_619;
      and_624_s2_q <= right_codes_rdata_q[77] & not_376_s1_q;
      not_628_s2_q <= not_628[11];
      sum_638_s2_q <= {3'h0, not_628[10]} + sum_637;
      and_648_s2_q <= right_codes_rdata_q[25] & not_376_s1_q;
      not_652_s2_q <= not_652[11];
      sum_662_s2_q <= {3'h0, not_652[10]} + sum_661;
      not_667_s2_q <= not_667[11];
      sum_677_s2_q <= {3'h0, not_667[10]} + sum_676;
      not_683_s2_q <= not_683[11];
      sum_693_s2_q <= {3'h0, not_683[10]} + sum_692;
      not_707_s2_q <= not_707[11];
      sum_717_s2_q <= {3'h0, not_707[10]} + sum_716;
      not_722_s2_q <= not_722[11];
      sum_732_s2_q <= {3'h0, not_722[10]} + sum_731;
      and_737_s2_q <= and_568 & (right_codes_rdata_q[90] & not_376_s1_q);
      not_740_s2_q <= not_740[11];
      sum_750_s2_q <= {3'h0, not_740[10]} + sum_749;
      and_766_s2_q <= and_529 & (right_codes_rdata_q[12] & not_376_s1_q);
      not_769_s2_q <= not_769[11];
      sum_779_s2_q <= {3'h0, not_769[10]} + sum_778;
      not_784_s2_q <= not_784[11];
      sum_794_s2_q <= {3'h0, not_784[10]} + sum_793;
      not_800_s2_q <= not_800[11];
      sum_810_s2_q <= {3'h0, not_800[10]} + sum_809;
      equal_827_s2_q <= equal_827_s1_q;
      and_885_s2_q <= equal_372_s1_q & and_517_s1_q;
      equal_891_s2_q <= equal_891_s1_q;
      equal_914_s2_q <= equal_914_s1_q;
      equal_917_s2_q <= equal_917_s1_q;
      and_928_s2_q <= left_rdata_q[61] & (left_rdata_q[62] & not_926);
      and_959_s2_q <= not_373_s1_q & and_519;
      and_981_s2_q <= sample_pair_whole_q;
      and_1062_s2_q <= not_373_s1_q & (not_518 & and_1060);
      equal_1207_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_1259_s2_q <= equal_1259_s1_q;
      not_1305_s2_q <= not_1305_s1_q;
      and_1393_s2_q <= left_rdata_q[61] & not_926;
      less_1487_s2_q <= 5'h4 < row_q[5:1];
      less_1490_s2_q <= less_1490_s1_q;
      equal_1752_s2_q <= row_s1_q[5:2] == 4'h0;
      less_1763_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_1928_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
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
  // hls/stages/census.hpp:91
  logic [11:0] select_331;
  assign select_331 = select_314_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:100
  logic [11:0] sum_335;
  assign sum_335 = select_331 + (equal_333_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:91
  logic [11:0] sum_337;
  assign sum_337 = {4'h0, sample_pair_pixel_1_q} + (select_314_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:100
  logic [11:0] sum_339;
  assign sum_339 = sum_337 + (equal_333_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:101
  logic and_343;
  assign and_343 = whole_s2_q & (averager_memory_rdata_q[24] | equal_333_s2_q);
  // hls/stages/agreement.hpp:181
  logic all_of_skin;
  assign all_of_skin = select_314_s2_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:102
  logic and_347;
  assign and_347 = all_of_skin & (averager_memory_rdata_q[25] | equal_333_s2_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_327_s2_q ? sum_335[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_327_s2_q ? sum_339[11:3] : 9'h0;
  logic and_364;
  assign and_364 = and_327_s2_q & and_343;
  // hls/stages/census.hpp:105
  logic select_366;
  assign select_366 = equal_356_s2_q ? and_364 : (averager_mask_q & and_364);
  // hls/stages/agreement.hpp:183
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_366;
  // hls/stages/census.hpp:126
  logic and_368;
  assign and_368 = and_327_s2_q & and_347;
  // hls/stages/census.hpp:105
  logic select_370;
  assign select_370 = equal_356_s2_q ? and_368 : (averager_of_skin_q & and_368);
  // hls/stages/agreement.hpp:395
  logic [3:0] column_2;
  assign column_2 = (and_529_s2_q & and_530_s2_q) ? ({3'h0, not_535_s2_q} + sum_545_s2_q) : 4'h0;
  logic [3:0] select_566;
  assign select_566 = (and_548_s2_q & and_549_s2_q) ? ({3'h0, not_554_s2_q} + sum_564_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_3;
  assign column_3 = {1'b0, column_2} + {1'b0, select_566};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_586;
  assign select_586 = (and_568_s2_q & and_569_s2_q) ? ({3'h0, not_574_s2_q} + sum_584_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_4;
  assign column_4 = {1'b0, column_3} + {2'h0, select_586};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_589;
  assign difference_589 = {2'h0, column_4} - (age_s2_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_592;
  assign sum_592 = difference_589 + (equal_590_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:395
  logic [3:0] column_5;
  assign column_5 = (and_529_s2_q & and_549_s2_q) ? ({3'h0, not_595_s2_q} + sum_605_s2_q) : 4'h0;
  logic [3:0] select_622;
  assign select_622 = (and_548_s2_q & and_569_s2_q) ? ({3'h0, not_610_s2_q} + sum_620_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_6;
  assign column_6 = {1'b0, column_5} + {1'b0, select_622};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_640;
  assign select_640 = (and_568_s2_q & and_624_s2_q) ? ({3'h0, not_628_s2_q} + sum_638_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_7;
  assign column_7 = {1'b0, column_6} + {2'h0, select_640};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_643;
  assign difference_643 = {2'h0, column_7} - (age_s2_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_645;
  assign sum_645 = difference_643 + (equal_590_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:438
  logic less_646;
  assign less_646 = sum_592 < sum_645;
  // hls/stages/agreement.hpp:395
  logic [3:0] column_8;
  assign column_8 = (and_529_s2_q & and_648_s2_q) ? ({3'h0, not_652_s2_q} + sum_662_s2_q) : 4'h0;
  logic [3:0] select_679;
  assign select_679 = (and_548_s2_q & and_530_s2_q) ? ({3'h0, not_667_s2_q} + sum_677_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_9;
  assign column_9 = {1'b0, column_8} + {1'b0, select_679};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_695;
  assign select_695 = (and_568_s2_q & and_549_s2_q) ? ({3'h0, not_683_s2_q} + sum_693_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_10;
  assign column_10 = {1'b0, column_9} + {2'h0, select_695};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_698;
  assign difference_698 = {2'h0, column_10} - (age_s2_q[1] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_700;
  assign sum_700 = difference_698 + (equal_590_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:438
  logic not_702;
  assign not_702 = ~less_646;
  logic [1:0] best;
  assign best = ((less_646 ? sum_645 : sum_592) < sum_700) ? 2'h3 : {not_702, less_646};
  // hls/stages/agreement.hpp:395
  logic [3:0] column_11;
  assign column_11 = (and_529_s2_q & and_569_s2_q) ? ({3'h0, not_707_s2_q} + sum_717_s2_q) : 4'h0;
  logic [3:0] select_734;
  assign select_734 = (and_548_s2_q & and_624_s2_q) ? ({3'h0, not_722_s2_q} + sum_732_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_12;
  assign column_12 = {1'b0, column_11} + {1'b0, select_734};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_752;
  assign select_752 = and_737_s2_q ? ({3'h0, not_740_s2_q} + sum_750_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_13;
  assign column_13 = {1'b0, column_12} + {2'h0, select_752};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_755;
  assign difference_755 = {2'h0, column_13} - (age_s2_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_757;
  assign sum_757 = difference_755 + (equal_590_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:438
  logic [7:0] select_759;
  assign select_759 = best[1] ? (best[0] ? sum_700 : sum_592) : (best[0] ? sum_645 : sum_757);
  logic [1:0] best_2;
  assign best_2 = (select_759 < sum_757) ? 2'h0 : best;
  // hls/stages/agreement.hpp:395
  logic [3:0] column_14;
  assign column_14 = and_766_s2_q ? ({3'h0, not_769_s2_q} + sum_779_s2_q) : 4'h0;
  logic [3:0] select_796;
  assign select_796 = (and_548_s2_q & and_648_s2_q) ? ({3'h0, not_784_s2_q} + sum_794_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_15;
  assign column_15 = {1'b0, column_14} + {1'b0, select_796};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_812;
  assign select_812 = (and_568_s2_q & and_530_s2_q) ? ({3'h0, not_800_s2_q} + sum_810_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_16;
  assign column_16 = {1'b0, column_15} + {2'h0, select_812};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_815;
  assign difference_815 = {2'h0, column_16} - (age_s2_q[1] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_817;
  assign sum_817 = difference_815 + (equal_590_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:450
  logic [5:0] partner;
  assign partner = run_shift_s2_q + x_s2_2_q[5:0];
  // hls/stages/agreement.hpp:317
  logic [5:0] select_888;
  assign select_888 = equal_372_s2_q ? partner : (x_s2_q[5:0] + best_left_rdata_q[13:8]);
  // hls/stages/agreement.hpp:183
  logic select_1120;
  assign select_1120 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_1122;
  assign select_1122 = sample_pair_whole_s2_q ? (and_351_s2_q ? select_366 : averager_mask_q) : averager_mask_q;
  logic select_1124;
  assign select_1124 = sample_pair_whole_s2_q ? (and_351_s2_q ? select_370 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1352;
  assign select_1352 = equal_372_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1353;
  assign select_1353 = equal_372_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1354;
  assign select_1354 = equal_372_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1355;
  assign select_1355 = equal_372_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1356;
  assign select_1356 = equal_372_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1357;
  assign select_1357 = equal_372_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1360;
  assign select_1360 = equal_372_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1361;
  assign select_1361 = equal_372_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1362;
  assign select_1362 = equal_372_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1363;
  assign select_1363 = equal_372_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1364;
  assign select_1364 = equal_372_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1365;
  assign select_1365 = equal_372_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1368;
  assign select_1368 = equal_372_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1369;
  assign select_1369 = equal_372_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1370;
  assign select_1370 = equal_372_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1371;
  assign select_1371 = equal_372_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1372;
  assign select_1372 = equal_372_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1373;
  assign select_1373 = equal_372_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1376;
  assign select_1376 = equal_372_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1377;
  assign select_1377 = equal_372_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1378;
  assign select_1378 = equal_372_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1379;
  assign select_1379 = equal_372_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1380;
  assign select_1380 = equal_372_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1381;
  assign select_1381 = equal_372_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1384;
  assign select_1384 = equal_372_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1385;
  assign select_1385 = equal_372_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1386;
  assign select_1386 = equal_372_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1387;
  assign select_1387 = equal_372_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1388;
  assign select_1388 = equal_372_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1389;
  assign select_1389 = equal_372_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/registration.hpp:158
  logic [16:0] select_1495;
  assign select_1495 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [13:0] select_1497;
  assign select_1497 = ($signed(10'h0) < $signed(select_1495[16:7])) ? 14'h7f : select_1495[13:0];
  // hls/stages/registration.hpp:153
  logic [9:0] select_1498;
  assign select_1498 = best_left_rdata_q[12] ? select_1497[9:0] : 10'h0;
  logic [8:0] difference_1500;
  assign difference_1500 = select_1498[9:1] - (best_left_rdata_q[13] ? select_1497[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1503;
  assign sum_1503 = (best_left_rdata_q[8] ? select_1497[13:1] : 13'h0) + (best_left_rdata_q[9] ? select_1497[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1504;
  assign select_1504 = best_left_rdata_q[10] ? select_1497[11:0] : 12'h0;
  logic [10:0] sum_1506;
  assign sum_1506 = select_1504[11:1] + (best_left_rdata_q[11] ? select_1497[10:0] : 11'h0);
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1507;
  assign sum_1507 = sum_1503[12:1] + {sum_1506, select_1504[0]};
  logic [9:0] sum_1508;
  assign sum_1508 = {difference_1500, select_1498[0]} + sum_1507[11:2];
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1509;
  assign sum_1509 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_1508[9]}}, sum_1508[9:2]};
  // hls/stages/registration.hpp:151
  logic [7:0] select_1512;
  assign select_1512 = ($signed(sum_1509[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1509[7:0];
  logic [7:0] slope;
  assign slope = ($signed(6'h0) < $signed(sum_1509[12:7])) ? 8'h7f : select_1512;
  logic [6:0] select_1514;
  assign select_1514 = best_left_rdata_q[8] ? slope[7:1] : 7'h0;
  logic [7:0] select_1515;
  assign select_1515 = best_left_rdata_q[9] ? slope : 8'h0;
  logic [8:0] sum_1516;
  assign sum_1516 = {{2{select_1514[6]}}, select_1514} + {select_1515[7], select_1515};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1517;
  assign select_1517 = best_left_rdata_q[10] ? slope : 8'h0;
  logic [7:0] select_1518;
  assign select_1518 = best_left_rdata_q[11] ? slope : 8'h0;
  logic [8:0] sum_1519;
  assign sum_1519 = {{2{select_1517[7]}}, select_1517[7:1]} + {select_1518[7], select_1518};
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1520;
  assign sum_1520 = {{3{sum_1516[8]}}, sum_1516[8:1]} + {sum_1519[8], sum_1519, select_1517[0]};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1521;
  assign select_1521 = best_left_rdata_q[12] ? slope : 8'h0;
  logic [7:0] select_1522;
  assign select_1522 = best_left_rdata_q[13] ? slope : 8'h0;
  logic [8:0] difference_1523;
  assign difference_1523 = {{2{select_1521[7]}}, select_1521[7:1]} - {select_1522[7], select_1522};
  // hls/stages/registration.hpp:57
  logic [23:0] select_1753;
  assign select_1753 = equal_1752_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:184
  logic [23:0] select_1755;
  assign select_1755 = and_353_s2_q ? (equal_1259_s2_q ? select_1753 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1756;
  assign select_1756 = equal_1752_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:184
  logic [27:0] select_1758;
  assign select_1758 = and_353_s2_q ? (equal_1259_s2_q ? select_1756 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1760;
  assign select_1760 = drew_s2_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1761;
  assign sum_1761 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1762;
  assign sum_1762 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:254; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = column_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_353_s2_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory best_right, 47 x 15, DISTANCE 12, hls/stages/agreement.hpp:806; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 15'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = select_888;
  logic best_right_re;
  assign best_right_re = s2_en & select_520_s2_q;
  logic [14:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory seen_columns, 47 x 14, DISTANCE 12, hls/stages/agreement.hpp:837; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [13:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 14'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_959_s2_q;
  logic [13:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_320_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_328_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_347, and_343, sum_339, sum_335};
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
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= left_pixel_q;
      sample_pair_pixel_1_q <= pixel_0_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_of_skin_q <= select_1120;
      averager_mask_q <= select_1122;
      averager_of_skin_q <= select_1124;
      registration_slope_row_q <= select_1755;
      registration_slope_change_q <= select_1758;
      registration_slope_q <= select_1760;
      registration_next_slope_row_q <= sum_1761;
      registration_next_slope_change_q <= sum_1762;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
    averager_running_0_q = 12'h0;
    averager_running_1_q = 12'h0;
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
      left_pixel_q <= and_981_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_331 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_337 : averager_running_1_q;
      sums_0_columns_values_0_q <= equal_372_s2_q ? {2'h0, column_13} : sums_0_columns_values_0_q;
      sums_0_columns_values_1_q <= select_1352;
      sums_0_columns_values_2_q <= select_1353;
      sums_0_columns_values_3_q <= select_1354;
      sums_0_columns_values_4_q <= select_1355;
      sums_0_columns_values_5_q <= select_1356;
      sums_0_columns_values_6_q <= select_1357;
      sums_0_sum_sums_values_0_q <= equal_372_s2_q ? sum_757 : sums_0_sum_sums_values_0_q;
      sums_1_columns_values_0_q <= equal_372_s2_q ? {2'h0, column_7} : sums_1_columns_values_0_q;
      sums_1_columns_values_1_q <= select_1360;
      sums_1_columns_values_2_q <= select_1361;
      sums_1_columns_values_3_q <= select_1362;
      sums_1_columns_values_4_q <= select_1363;
      sums_1_columns_values_5_q <= select_1364;
      sums_1_columns_values_6_q <= select_1365;
      sums_1_sum_sums_values_0_q <= equal_372_s2_q ? sum_645 : sums_1_sum_sums_values_0_q;
      sums_2_columns_values_0_q <= equal_372_s2_q ? {2'h0, column_4} : sums_2_columns_values_0_q;
      sums_2_columns_values_1_q <= select_1368;
      sums_2_columns_values_2_q <= select_1369;
      sums_2_columns_values_3_q <= select_1370;
      sums_2_columns_values_4_q <= select_1371;
      sums_2_columns_values_5_q <= select_1372;
      sums_2_columns_values_6_q <= select_1373;
      sums_2_sum_sums_values_0_q <= equal_372_s2_q ? sum_592 : sums_2_sum_sums_values_0_q;
      sums_3_columns_values_0_q <= equal_372_s2_q ? {2'h0, column_10} : sums_3_columns_values_0_q;
      sums_3_columns_values_1_q <= select_1376;
      sums_3_columns_values_2_q <= select_1377;
      sums_3_columns_values_3_q <= select_1378;
      sums_3_columns_values_4_q <= select_1379;
      sums_3_columns_values_5_q <= select_1380;
      sums_3_columns_values_6_q <= select_1381;
      sums_3_sum_sums_values_0_q <= equal_372_s2_q ? sum_700 : sums_3_sum_sums_values_0_q;
      sums_4_columns_values_0_q <= equal_372_s2_q ? {2'h0, column_16} : sums_4_columns_values_0_q;
      sums_4_columns_values_1_q <= select_1384;
      sums_4_columns_values_2_q <= select_1385;
      sums_4_columns_values_3_q <= select_1386;
      sums_4_columns_values_4_q <= select_1387;
      sums_4_columns_values_5_q <= select_1388;
      sums_4_columns_values_6_q <= select_1389;
      sums_4_sum_sums_values_0_q <= equal_372_s2_q ? sum_817 : sums_4_sum_sums_values_0_q;
    end
  end

  logic saturated_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic left_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic [5:0] run_shift_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic lower_half_s3_q;
  logic [5:0] column_s3_q;
  logic and_351_s3_q;
  logic and_353_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_356_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic and_371_s3_q;
  logic equal_372_s3_q;
  logic not_373_s3_q;
  logic equal_374_s3_q;
  logic less_375_s3_q;
  logic not_376_s3_q;
  logic equal_407_s3_q;
  logic drew_s3_q;
  logic left_rdata_s3_q;
  logic [6:0] x_s3_2_q;
  logic not_518_s3_q;
  logic [21:0] best_left_rdata_s3_q;
  logic equal_523_s3_q;
  logic [7:0] sum_592_s3_q;
  logic [7:0] sum_645_s3_q;
  logic [7:0] sum_700_s3_q;
  logic [7:0] sum_757_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_817_s3_q;
  logic equal_827_s3_q;
  logic and_885_s3_q;
  logic [5:0] partner_s3_q;
  logic equal_891_s3_q;
  logic equal_914_s3_q;
  logic equal_917_s3_q;
  logic and_928_s3_q;
  logic and_959_s3_q;
  logic and_981_s3_q;
  logic and_1062_s3_q;
  logic equal_1207_s3_q;
  logic equal_1259_s3_q;
  logic not_1305_s3_q;
  logic and_1393_s3_q;
  logic less_1487_s3_q;
  logic less_1490_s3_q;
  logic [9:0] sum_1520_s3_q;
  logic select_1521_s3_q;
  logic [8:0] difference_1523_s3_q;
  logic less_1763_s3_q;
  logic equal_1928_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      saturated_s3_q <= saturated_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      left_first_s3_q <= left_first_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      run_shift_s3_q <= run_shift_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[0];
      lower_half_s3_q <= lower_half_s2_q;
      column_s3_q <= column_s2_q;
      and_351_s3_q <= and_351_s2_q;
      and_353_s3_q <= and_353_s2_q;
      grey_s3_q <= grey;
      equal_356_s3_q <= equal_356_s2_q;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      and_371_s3_q <= sample_pair_whole_s2_q & select_370;
      equal_372_s3_q <= equal_372_s2_q;
      not_373_s3_q <= not_373_s2_q;
      equal_374_s3_q <= equal_374_s2_q;
      less_375_s3_q <= less_375_s2_q;
      not_376_s3_q <= not_376_s2_q;
      equal_407_s3_q <= equal_407_s2_q;
      drew_s3_q <= drew_s2_q;
      left_rdata_s3_q <= left_rdata_s2_q;
      x_s3_2_q <= x_s2_2_q;
      not_518_s3_q <= not_518_s2_q;
      best_left_rdata_s3_q <= best_left_rdata_q;
      equal_523_s3_q <= equal_523_s2_q;
      sum_592_s3_q <= sum_592;
      sum_645_s3_q <= sum_645;
      sum_700_s3_q <= sum_700;
      sum_757_s3_q <= sum_757;
      best_2_s3_q <= best_2;
      sum_817_s3_q <= sum_817;
      equal_827_s3_q <= equal_827_s2_q;
      and_885_s3_q <= and_885_s2_q;
      partner_s3_q <= partner;
      equal_891_s3_q <= equal_891_s2_q;
      equal_914_s3_q <= equal_914_s2_q;
      equal_917_s3_q <= equal_917_s2_q;
      and_928_s3_q <= and_928_s2_q;
      and_959_s3_q <= and_959_s2_q;
      and_981_s3_q <= and_981_s2_q;
      and_1062_s3_q <= and_1062_s2_q;
      equal_1207_s3_q <= equal_1207_s2_q;
      equal_1259_s3_q <= equal_1259_s2_q;
      not_1305_s3_q <= not_1305_s2_q;
      and_1393_s3_q <= and_1393_s2_q;
      less_1487_s3_q <= less_1487_s2_q;
      less_1490_s3_q <= less_1490_s2_q;
      sum_1520_s3_q <= sum_1520[10:1];
      select_1521_s3_q <= select_1521[0];
      difference_1523_s3_q <= difference_1523;
      less_1763_s3_q <= less_1763_s2_q;
      equal_1928_s3_q <= equal_1928_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
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
  logic [23:0] counts_too_little_explained_q;
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
  assign total = {2'h0, grey_s3_q} + (equal_356_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:183
  logic [8:0] select_359;
  assign select_359 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_356_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:183
  logic [8:0] select_363;
  assign select_363 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:214
  logic less_380;
  assign less_380 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_381;
  assign less_381 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_382;
  assign less_382 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_383;
  assign less_383 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_384;
  assign less_384 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_385;
  assign less_385 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_386;
  assign less_386 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_387;
  assign less_387 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_388;
  assign less_388 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_389;
  assign less_389 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_390;
  assign less_390 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_391;
  assign less_391 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_392;
  assign less_392 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_393;
  assign less_393 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_394;
  assign less_394 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_395;
  assign less_395 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_396;
  assign less_396 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_397;
  assign less_397 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_398;
  assign less_398 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_399;
  assign less_399 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_400;
  assign less_400 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_401;
  assign less_401 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_402;
  assign less_402 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_403;
  assign less_403 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:259
  logic equal_404;
  assign equal_404 = column_s3_q == 6'h0;
  logic [3:0] select_408;
  assign select_408 = equal_407_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:260
  logic [4:0] select_409;
  assign select_409 = equal_404 ? {select_408, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_410;
  assign select_410 = equal_404 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:219
  logic and_411;
  assign and_411 = select_409[4] & select_410[3];
  // hls/stages/census.hpp:206
  logic and_413;
  assign and_413 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_415;
  assign and_415 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_413);
  // hls/stages/agreement.hpp:260
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_415;
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
  logic [9:0] difference_438;
  assign difference_438 = {1'b0, select_359} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_439;
  assign xor_439 = difference_438[8:0] ^ {9{difference_438[9]}};
  logic [9:0] sum_440;
  assign sum_440 = {9'h0, difference_438[9]} + {1'b0, xor_439};
  logic [9:0] difference_441;
  assign difference_441 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_442;
  assign xor_442 = difference_441[8:0] ^ {9{difference_441[9]}};
  logic [9:0] sum_443;
  assign sum_443 = {9'h0, difference_441[9]} + {1'b0, xor_442};
  logic [9:0] difference_445;
  assign difference_445 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_446;
  assign xor_446 = difference_445[8:0] ^ {9{difference_445[9]}};
  logic [9:0] sum_447;
  assign sum_447 = {9'h0, difference_445[9]} + {1'b0, xor_446};
  logic [10:0] sum_448;
  assign sum_448 = ({1'b0, sum_440} + {1'b0, sum_443}) + {1'b0, sum_447};
  logic [9:0] difference_449;
  assign difference_449 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_450;
  assign xor_450 = difference_449[8:0] ^ {9{difference_449[9]}};
  logic [9:0] sum_451;
  assign sum_451 = {9'h0, difference_449[9]} + {1'b0, xor_450};
  logic [9:0] difference_453;
  assign difference_453 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_454;
  assign xor_454 = difference_453[8:0] ^ {9{difference_453[9]}};
  logic [9:0] sum_455;
  assign sum_455 = {9'h0, difference_453[9]} + {1'b0, xor_454};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_448} + {2'h0, sum_451}) + {2'h0, sum_455};
  // hls/stages/agreement.hpp:430
  logic not_525;
  assign not_525 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_526;
  assign less_526 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:438
  logic [7:0] select_764;
  assign select_764 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_700_s3_q : sum_592_s3_q) : (best_2_s3_q[0] ? sum_645_s3_q : sum_757_s3_q);
  logic less_818;
  assign less_818 = select_764 < sum_817_s3_q;
  logic [1:0] select_819;
  assign select_819 = less_818 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:440
  logic [7:0] select_822;
  assign select_822 = select_819[1] ? (select_819[0] ? sum_700_s3_q : sum_592_s3_q) : (select_819[0] ? sum_645_s3_q : sum_757_s3_q);
  logic [7:0] of_best;
  assign of_best = less_818 ? sum_817_s3_q : select_822;
  logic [7:0] of_best_2;
  assign of_best_2 = (not_525 & (~less_526)) ? of_best : 8'h0;
  // hls/stages/agreement.hpp:442
  logic less_825;
  assign less_825 = $signed(run_shift_s3_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:445
  logic less_826;
  assign less_826 = best_left_rdata_s3_q[7:0] < of_best_2;
  logic or_828;
  assign or_828 = less_826 | equal_827_s3_q;
  // hls/stages/agreement.hpp:448
  logic [7:0] select_831;
  assign select_831 = less_825 ? (or_828 ? of_best_2 : best_left_rdata_s3_q[7:0]) : (less_826 ? of_best_2 : best_left_rdata_s3_q[7:0]);
  logic [5:0] select_835;
  assign select_835 = less_825 ? (or_828 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]) : (less_826 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]);
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_818, select_819} == 3'h4) ? 3'h3 : (({less_818, select_819} == 3'h0) ? 3'h1 : {less_818, select_819});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_842;
  assign sum_842 = near_best + 3'h1;
  logic [7:0] select_845;
  assign select_845 = sum_842[1] ? (sum_842[0] ? sum_700_s3_q : sum_592_s3_q) : (sum_842[0] ? sum_645_s3_q : sum_757_s3_q);
  logic [7:0] below;
  assign below = sum_842[2] ? sum_817_s3_q : select_845;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_847;
  assign sum_847 = near_best + 3'h7;
  logic [7:0] select_850;
  assign select_850 = sum_847[1] ? (sum_847[0] ? sum_700_s3_q : sum_592_s3_q) : (sum_847[0] ? sum_645_s3_q : sum_757_s3_q);
  logic [7:0] above;
  assign above = sum_847[2] ? sum_817_s3_q : select_850;
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/registration.hpp:26
  logic [7:0] select_856;
  assign select_856 = near_best[1] ? (near_best[0] ? sum_700_s3_q : sum_592_s3_q) : (near_best[0] ? sum_645_s3_q : sum_757_s3_q);
  logic [7:0] select_857;
  assign select_857 = near_best[2] ? sum_817_s3_q : select_856;
  logic [7:0] select_858;
  assign select_858 = rise[8] ? below : above;
  logic [8:0] fall;
  assign fall = {1'b0, select_857} - {1'b0, select_858};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [7:0] xor_861;
  assign xor_861 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_861};
  // hls/stages/agreement.hpp:452
  logic less_890;
  assign less_890 = best_right_rdata_q[7:0] < of_best_2;
  logic or_892;
  assign or_892 = less_890 | equal_891_s3_q;
  // hls/stages/agreement.hpp:453
  logic [7:0] select_895;
  assign select_895 = less_825 ? (or_892 ? of_best_2 : best_right_rdata_q[7:0]) : (less_890 ? of_best_2 : best_right_rdata_q[7:0]);
  logic [7:0] select_896;
  assign select_896 = equal_523_s3_q ? of_best_2 : select_895;
  logic [6:0] select_899;
  assign select_899 = less_825 ? (or_892 ? x_s3_2_q : best_right_rdata_q[14:8]) : (less_890 ? x_s3_2_q : best_right_rdata_q[14:8]);
  logic [6:0] select_900;
  assign select_900 = equal_523_s3_q ? x_s3_2_q : select_899;
  // hls/stages/agreement.hpp:142
  logic [7:0] select_901;
  assign select_901 = drew_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:564
  logic or_904;
  assign or_904 = select_901[7] | (~({select_901[5], select_901[3], select_901[1]} == 3'h0));
  // hls/stages/agreement.hpp:563
  logic or_907;
  assign or_907 = select_901[7] | (~({select_901[6], select_901[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:562
  logic or_910;
  assign or_910 = select_901[7] | (~(select_901[6:4] == 3'h0));
  // hls/stages/division.hpp:18
  logic [5:0] sum_912;
  assign sum_912 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:572
  logic or_915;
  assign or_915 = (~sum_912[5]) | equal_914_s3_q;
  // hls/stages/agreement.hpp:542
  logic and_916;
  assign and_916 = not_376_s3_q & or_915;
  // hls/stages/agreement.hpp:641
  logic equal_918;
  assign equal_918 = x_s3_q[5:4] == 2'h3;
  // hls/stages/agreement.hpp:317
  logic and_920;
  assign and_920 = equal_917_s3_q & (~equal_918);
  // hls/stages/agreement.hpp:170
  logic textured;
  assign textured = not_376_s3_q & and_928_s3_q;
  // hls/stages/agreement.hpp:530
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s3_q};
  // hls/stages/agreement.hpp:533
  logic [9:0] sum_937;
  assign sum_937 = {way[8], way} + 10'h1;
  logic and_939;
  assign and_939 = (and_928_s3_q & (8'hb6 < best_left_rdata_s3_q[7:0])) & ({{6{sum_937[9]}}, sum_937} < 16'h3);
  // hls/stages/agreement.hpp:170
  logic explained;
  assign explained = not_376_s3_q & and_939;
  // hls/stages/agreement.hpp:535
  logic and_947;
  assign and_947 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s3_q[13:8]));
  // hls/stages/agreement.hpp:170
  logic and_949;
  assign and_949 = and_939 & ((cfg_nearer_below_i & best_left_rdata_s3_q[13]) | and_947);
  logic and_961;
  assign and_961 = left_rdata_s3_q & not_376_s3_q;
  logic near;
  assign near = not_376_s3_q & and_949;
  // hls/stages/agreement.hpp:730
  logic select_963;
  assign select_963 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:734
  logic select_964;
  assign select_964 = left_first_s3_q ? select_963 : read_half_q;
  logic or_965;
  assign or_965 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:735
  logic [8:0] select_966;
  assign select_966 = or_965 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:736
  logic [9:0] select_968;
  assign select_968 = left_first_s3_q ? 10'h1 : (or_965 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:739
  logic and_969;
  assign and_969 = select_966[8] & select_968[9];
  // hls/stages/agreement.hpp:185
  logic next_row;
  assign next_row = and_969 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:750
  logic [5:0] select_972;
  assign select_972 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_974;
  assign select_974 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_972});
  // hls/stages/agreement.hpp:760
  logic equal_975;
  assign equal_975 = seen_x_q == 3'h7;
  logic [7:0] select_977;
  assign select_977 = and_969 ? 8'h0 : (seen_column_q + {7'h0, equal_975});
  // hls/stages/agreement.hpp:763
  logic [10:0] index;
  assign index = select_974 + {3'h0, select_977};
  // hls/stages/agreement.hpp:720
  logic [11:0] sum_979;
  assign sum_979 = {1'b0, {2{select_964}}, 2'h0, {2{select_964}}, 1'b0, {2{select_964}}, 1'b0, select_964} + {1'b0, index};
  // hls/stages/agreement.hpp:733
  logic not_982;
  assign not_982 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:185
  logic and_984;
  assign and_984 = not_982 & (began_q | and_969);
  // hls/stages/agreement.hpp:761
  logic [2:0] select_986;
  assign select_986 = and_969 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:762
  logic and_988;
  assign and_988 = and_984 & (select_986 == 3'h0);
  logic less_989;
  assign less_989 = select_977 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:187
  logic and_990;
  assign and_990 = and_988 & less_989;
  logic and_991;
  assign and_991 = and_981_s3_q & and_990;
  // hls/stages/agreement.hpp:624
  logic [7:0] sum_995;
  assign sum_995 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_995[7], sum_995, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:720
  logic [11:0] sum_997;
  assign sum_997 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:542
  logic [5:0] select_998;
  assign select_998 = less_375_s3_q ? 6'h0 : seen_columns_rdata_q[13:8];
  logic [5:0] select_999;
  assign select_999 = less_375_s3_q ? 6'h0 : {seen_columns_rdata_q[7:6], seen_columns_rdata_q[4:2], seen_columns_rdata_q[0]};
  // hls/stages/agreement.hpp:600
  logic [1:0] sum_1001;
  assign sum_1001 = {1'b0, select_999[3]} + ({1'b0, textured} + {1'b0, select_999[0]});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, select_998[3]} + ({2'h0, select_998[0]} + {1'b0, sum_1001});
  // hls/stages/agreement.hpp:542
  logic [7:0] select_1011;
  assign select_1011 = less_375_s3_q ? select_901 : (sum_912[5] ? select_901 : {select_901[6:0], 1'b0});
  // hls/stages/agreement.hpp:564
  logic or_1014;
  assign or_1014 = select_1011[7] | (~({select_1011[5], select_1011[3], select_1011[1]} == 3'h0));
  // hls/stages/agreement.hpp:601
  logic [1:0] sum_1031;
  assign sum_1031 = {1'b0, select_999[4]} + ({1'b0, explained} + {1'b0, select_999[1]});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, select_998[4]} + ({2'h0, select_998[1]} + {1'b0, sum_1031});
  // hls/stages/agreement.hpp:602
  logic [1:0] sum_1043;
  assign sum_1043 = {1'b0, select_999[5]} + ({1'b0, near} + {1'b0, select_999[2]});
  logic [2:0] near_2;
  assign near_2 = {2'h0, select_998[5]} + ({2'h0, select_998[2]} + {1'b0, sum_1043});
  // hls/stages/agreement.hpp:183
  logic [10:0] select_1099;
  assign select_1099 = sample_pair_whole_s3_q ? (and_351_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1101;
  assign select_1101 = sample_pair_whole_s3_q ? (and_351_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:184
  logic [8:0] select_1125;
  assign select_1125 = and_353_s3_q ? select_359 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1126;
  assign select_1126 = and_353_s3_q ? select_363 : census_columns_values_0_cell_0_right_q;
  logic select_1127;
  assign select_1127 = and_353_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_1128;
  assign select_1128 = and_353_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1129;
  assign select_1129 = and_353_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1130;
  assign select_1130 = and_353_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1131;
  assign select_1131 = and_353_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1132;
  assign select_1132 = and_353_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1133;
  assign select_1133 = and_353_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1134;
  assign select_1134 = and_353_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1135;
  assign select_1135 = and_353_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1136;
  assign select_1136 = and_353_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1137;
  assign select_1137 = and_353_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1138;
  assign select_1138 = and_353_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1139;
  assign select_1139 = and_353_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1140;
  assign select_1140 = and_353_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1141;
  assign select_1141 = and_353_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1142;
  assign select_1142 = and_353_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1143;
  assign select_1143 = and_353_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1144;
  assign select_1144 = and_353_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1145;
  assign select_1145 = and_353_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1146;
  assign select_1146 = and_353_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1147;
  assign select_1147 = and_353_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1148;
  assign select_1148 = and_353_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1149;
  assign select_1149 = and_353_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1150;
  assign select_1150 = and_353_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1151;
  assign select_1151 = and_353_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1152;
  assign select_1152 = and_353_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1153;
  assign select_1153 = and_353_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1154;
  assign select_1154 = and_353_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1155;
  assign select_1155 = and_353_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1156;
  assign select_1156 = and_353_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1157;
  assign select_1157 = and_353_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1158;
  assign select_1158 = and_353_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1159;
  assign select_1159 = and_353_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1160;
  assign select_1160 = and_353_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1161;
  assign select_1161 = and_353_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1162;
  assign select_1162 = and_353_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1163;
  assign select_1163 = and_353_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1164;
  assign select_1164 = and_353_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1165;
  assign select_1165 = and_353_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1166;
  assign select_1166 = and_353_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1167;
  assign select_1167 = and_353_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1168;
  assign select_1168 = and_353_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1169;
  assign select_1169 = and_353_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1170;
  assign select_1170 = and_353_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1171;
  assign select_1171 = and_353_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1172;
  assign select_1172 = and_353_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1173;
  assign select_1173 = and_353_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1174;
  assign select_1174 = and_353_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1175;
  assign select_1175 = and_353_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1176;
  assign select_1176 = and_353_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1177;
  assign select_1177 = and_353_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1178;
  assign select_1178 = and_353_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1179;
  assign select_1179 = and_353_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1180;
  assign select_1180 = and_353_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1182;
  assign difference_1182 = {1'b0, select_363} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1183;
  assign xor_1183 = difference_1182[8:0] ^ {9{difference_1182[9]}};
  logic [9:0] sum_1184;
  assign sum_1184 = {9'h0, difference_1182[9]} + {1'b0, xor_1183};
  logic [9:0] difference_1185;
  assign difference_1185 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1186;
  assign xor_1186 = difference_1185[8:0] ^ {9{difference_1185[9]}};
  logic [9:0] sum_1187;
  assign sum_1187 = {9'h0, difference_1185[9]} + {1'b0, xor_1186};
  logic [9:0] difference_1189;
  assign difference_1189 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1190;
  assign xor_1190 = difference_1189[8:0] ^ {9{difference_1189[9]}};
  logic [9:0] sum_1191;
  assign sum_1191 = {9'h0, difference_1189[9]} + {1'b0, xor_1190};
  logic [10:0] sum_1192;
  assign sum_1192 = ({1'b0, sum_1184} + {1'b0, sum_1187}) + {1'b0, sum_1191};
  logic [9:0] difference_1193;
  assign difference_1193 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1194;
  assign xor_1194 = difference_1193[8:0] ^ {9{difference_1193[9]}};
  logic [9:0] sum_1195;
  assign sum_1195 = {9'h0, difference_1193[9]} + {1'b0, xor_1194};
  logic [9:0] difference_1197;
  assign difference_1197 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1198;
  assign xor_1198 = difference_1197[8:0] ^ {9{difference_1197[9]}};
  logic [9:0] sum_1199;
  assign sum_1199 = {9'h0, difference_1197[9]} + {1'b0, xor_1198};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1227;
  assign difference_1227 = {1'b0, select_359} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1227[9]} + (difference_1227[8:0] ^ {9{difference_1227[9]}});
  logic [9:0] difference_1238;
  assign difference_1238 = {1'b0, select_363} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1238[9]} + (difference_1238[8:0] ^ {9{difference_1238[9]}});
  // hls/stages/agreement.hpp:184
  logic and_1392;
  assign and_1392 = and_353_s3_q & (equal_407_s3_q & equal_1259_s3_q);
  // hls/stages/agreement.hpp:317
  logic and_1397;
  assign and_1397 = not_373_s3_q & (not_518_s3_q & (drew_s3_q & (not_376_s3_q & and_1393_s3_q)));
  // hls/stages/agreement.hpp:170
  logic [8:0] select_1442;
  assign select_1442 = less_375_s3_q ? 9'h0 : (and_928_s3_q ? {and_939, cfg_explained_limit_i} : 9'h0);
  // hls/stages/agreement.hpp:317
  logic [8:0] select_1445;
  assign select_1445 = equal_372_s3_q ? 9'h0 : (equal_374_s3_q ? 9'h0 : (drew_s3_q ? select_1442 : 9'h0));
  // hls/stages/agreement.hpp:503
  logic [23:0] sum_1446;
  assign sum_1446 = counts_too_little_explained_q + {{15{select_1445[8]}}, select_1445};
  // hls/stages/agreement.hpp:537
  logic [9:0] select_1480;
  assign select_1480 = (left_rdata_s3_q & and_1393_s3_q) ? ({1'b0, and_949, 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:317
  logic [9:0] select_1483;
  assign select_1483 = equal_374_s3_q ? 10'h0 : (drew_s3_q ? (less_375_s3_q ? 10'h0 : select_1480) : 10'h0);
  logic [9:0] select_1484;
  assign select_1484 = equal_372_s3_q ? 10'h0 : select_1483;
  // hls/stages/agreement.hpp:508
  logic [23:0] select_1486;
  assign select_1486 = and_1392 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1484[9]}}, select_1484});
  // hls/stages/agreement.hpp:537
  logic and_1488;
  assign and_1488 = and_939 & less_1487_s3_q;
  // hls/stages/registration.hpp:73
  logic equal_1491;
  assign equal_1491 = {lower_half_s3_q, less_1490_s3_q} == 2'h3;
  logic equal_1492;
  assign equal_1492 = {lower_half_s3_q, less_1490_s3_q} == 2'h2;
  logic equal_1493;
  assign equal_1493 = {lower_half_s3_q, less_1490_s3_q} == 2'h1;
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1524;
  assign sum_1524 = {difference_1523_s3_q, select_1521_s3_q} + {sum_1520_s3_q[9], sum_1520_s3_q[9:1]};
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1525;
  assign difference_1525 = {{4{best_left_rdata_s3_q[21]}}, best_left_rdata_s3_q[21:14]} - {sum_1524[9], sum_1524, sum_1520_s3_q[0]};
  // hls/stages/registration.hpp:158
  logic [11:0] select_1527;
  assign select_1527 = ($signed(difference_1525[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1525;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1527[11:7])) ? 12'h7f : select_1527;
  // hls/stages/registration.hpp:73
  logic not_1567;
  assign not_1567 = ~equal_1491;
  logic not_1568;
  assign not_1568 = ~equal_1492;
  // hls/stages/agreement.hpp:170
  logic and_1573;
  assign and_1573 = not_376_s3_q & (and_1488 & (not_1567 & (not_1568 & (~equal_1493))));
  // hls/stages/agreement.hpp:317
  logic and_1576;
  assign and_1576 = not_373_s3_q & (not_518_s3_q & (drew_s3_q & and_1573));
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1578;
  assign select_1578 = and_1392 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1576});
  // hls/stages/agreement.hpp:317
  logic and_1583;
  assign and_1583 = drew_s3_q & (not_376_s3_q & (and_1488 & (not_1567 & (equal_1493 & not_1568))));
  logic and_1585;
  assign and_1585 = not_373_s3_q & (not_518_s3_q & and_1583);
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1587;
  assign select_1587 = and_1392 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1585});
  // hls/stages/agreement.hpp:317
  logic and_1591;
  assign and_1591 = drew_s3_q & (not_376_s3_q & (and_1488 & (equal_1492 & not_1567)));
  logic and_1593;
  assign and_1593 = not_373_s3_q & (not_518_s3_q & and_1591);
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1595;
  assign select_1595 = and_1392 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1593});
  // hls/stages/agreement.hpp:317
  logic and_1599;
  assign and_1599 = not_518_s3_q & (drew_s3_q & (not_376_s3_q & (and_1488 & equal_1491)));
  logic and_1600;
  assign and_1600 = not_373_s3_q & and_1599;
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1602;
  assign select_1602 = and_1392 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1600});
  // hls/stages/registration.hpp:146
  logic less_1603;
  assign less_1603 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:170
  logic and_1604;
  assign and_1604 = and_1488 & less_1603;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1607;
  assign select_1607 = equal_374_s3_q ? 2'h0 : (drew_s3_q ? (less_375_s3_q ? 2'h0 : {and_1604, and_1488}) : 2'h0);
  logic [1:0] select_1608;
  assign select_1608 = equal_372_s3_q ? 2'h0 : select_1607;
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1609;
  assign sum_1609 = registration_counts_votes_0_down_q + {{13{select_1608[1]}}, select_1608};
  // hls/stages/registration.hpp:146
  logic [12:0] difference_1611;
  assign difference_1611 = 13'h0 - {residual[11], residual};
  logic less_1612;
  assign less_1612 = $signed(difference_1611) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:170
  logic and_1613;
  assign and_1613 = and_1488 & less_1612;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1616;
  assign select_1616 = equal_374_s3_q ? 2'h0 : (drew_s3_q ? (less_375_s3_q ? 2'h0 : {and_1613, and_1488}) : 2'h0);
  logic [1:0] select_1617;
  assign select_1617 = equal_372_s3_q ? 2'h0 : select_1616;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1618;
  assign sum_1618 = registration_counts_votes_0_up_q + {{13{select_1617[1]}}, select_1617};
  // hls/stages/registration.hpp:80
  logic not_1620;
  assign not_1620 = ~less_1490_s3_q;
  // hls/stages/registration.hpp:79
  logic and_1621;
  assign and_1621 = less_1603 & not_1620;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1624;
  assign select_1624 = drew_s3_q ? (less_375_s3_q ? 2'h0 : (and_1488 ? {and_1621, not_1620} : 2'h0)) : 2'h0;
  logic [1:0] select_1626;
  assign select_1626 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : select_1624);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1627;
  assign sum_1627 = registration_counts_votes_1_down_q + {{13{select_1626[1]}}, select_1626};
  // hls/stages/registration.hpp:79
  logic and_1629;
  assign and_1629 = less_1612 & not_1620;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1632;
  assign select_1632 = drew_s3_q ? (less_375_s3_q ? 2'h0 : (and_1488 ? {and_1629, not_1620} : 2'h0)) : 2'h0;
  logic [1:0] select_1634;
  assign select_1634 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : select_1632);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1635;
  assign sum_1635 = registration_counts_votes_1_up_q + {{13{select_1634[1]}}, select_1634};
  // hls/stages/registration.hpp:79
  logic and_1637;
  assign and_1637 = less_1490_s3_q & less_1603;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1639;
  assign select_1639 = less_375_s3_q ? 2'h0 : (and_1488 ? {and_1637, less_1490_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1642;
  assign select_1642 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : (drew_s3_q ? select_1639 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1643;
  assign sum_1643 = registration_counts_votes_2_down_q + {{13{select_1642[1]}}, select_1642};
  // hls/stages/registration.hpp:79
  logic and_1645;
  assign and_1645 = less_1490_s3_q & less_1612;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1647;
  assign select_1647 = less_375_s3_q ? 2'h0 : (and_1488 ? {and_1645, less_1490_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1650;
  assign select_1650 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : (drew_s3_q ? select_1647 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1651;
  assign sum_1651 = registration_counts_votes_2_up_q + {{13{select_1650[1]}}, select_1650};
  // hls/stages/registration.hpp:80
  logic not_1653;
  assign not_1653 = ~lower_half_s3_q;
  // hls/stages/agreement.hpp:170
  logic and_1654;
  assign and_1654 = less_1603 & not_1653;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1657;
  assign select_1657 = drew_s3_q ? (less_375_s3_q ? 2'h0 : (and_1488 ? {and_1654, not_1653} : 2'h0)) : 2'h0;
  logic [1:0] select_1659;
  assign select_1659 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : select_1657);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1660;
  assign sum_1660 = registration_counts_votes_3_down_q + {{13{select_1659[1]}}, select_1659};
  // hls/stages/agreement.hpp:170
  logic and_1662;
  assign and_1662 = less_1612 & not_1653;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1665;
  assign select_1665 = drew_s3_q ? (less_375_s3_q ? 2'h0 : (and_1488 ? {and_1662, not_1653} : 2'h0)) : 2'h0;
  logic [1:0] select_1667;
  assign select_1667 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : select_1665);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1668;
  assign sum_1668 = registration_counts_votes_3_up_q + {{13{select_1667[1]}}, select_1667};
  // hls/stages/agreement.hpp:170
  logic and_1670;
  assign and_1670 = lower_half_s3_q & less_1603;
  logic [1:0] select_1672;
  assign select_1672 = less_375_s3_q ? 2'h0 : (and_1488 ? {and_1670, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1675;
  assign select_1675 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : (drew_s3_q ? select_1672 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1676;
  assign sum_1676 = registration_counts_votes_4_down_q + {{13{select_1675[1]}}, select_1675};
  // hls/stages/agreement.hpp:170
  logic and_1678;
  assign and_1678 = lower_half_s3_q & less_1612;
  logic [1:0] select_1680;
  assign select_1680 = less_375_s3_q ? 2'h0 : (and_1488 ? {and_1678, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1683;
  assign select_1683 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : (drew_s3_q ? select_1680 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1684;
  assign sum_1684 = registration_counts_votes_4_up_q + {{13{select_1683[1]}}, select_1683};
  // hls/stages/registration.hpp:146
  logic less_1686;
  assign less_1686 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1687;
  assign and_1687 = not_1620 & less_1686;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1690;
  assign select_1690 = drew_s3_q ? (less_375_s3_q ? 2'h0 : (and_1488 ? {and_1687, not_1620} : 2'h0)) : 2'h0;
  logic [1:0] select_1692;
  assign select_1692 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : select_1690);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1693;
  assign sum_1693 = registration_counts_half_votes_0_down_q + {{13{select_1692[1]}}, select_1692};
  // hls/stages/registration.hpp:146
  logic less_1695;
  assign less_1695 = $signed(difference_1611) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1696;
  assign and_1696 = not_1620 & less_1695;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1699;
  assign select_1699 = drew_s3_q ? (less_375_s3_q ? 2'h0 : (and_1488 ? {and_1696, not_1620} : 2'h0)) : 2'h0;
  logic [1:0] select_1701;
  assign select_1701 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : select_1699);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1702;
  assign sum_1702 = registration_counts_half_votes_0_up_q + {{13{select_1701[1]}}, select_1701};
  // hls/stages/registration.hpp:79
  logic and_1704;
  assign and_1704 = less_1490_s3_q & less_1686;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1706;
  assign select_1706 = less_375_s3_q ? 2'h0 : (and_1488 ? {and_1704, less_1490_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1709;
  assign select_1709 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : (drew_s3_q ? select_1706 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1710;
  assign sum_1710 = registration_counts_half_votes_1_down_q + {{13{select_1709[1]}}, select_1709};
  // hls/stages/registration.hpp:79
  logic and_1712;
  assign and_1712 = less_1490_s3_q & less_1695;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1714;
  assign select_1714 = less_375_s3_q ? 2'h0 : (and_1488 ? {and_1712, less_1490_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1717;
  assign select_1717 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : (drew_s3_q ? select_1714 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1718;
  assign sum_1718 = registration_counts_half_votes_1_up_q + {{13{select_1717[1]}}, select_1717};
  // hls/stages/agreement.hpp:170
  logic and_1720;
  assign and_1720 = less_1686 & not_1653;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1723;
  assign select_1723 = drew_s3_q ? (less_375_s3_q ? 2'h0 : (and_1488 ? {and_1720, not_1653} : 2'h0)) : 2'h0;
  logic [1:0] select_1725;
  assign select_1725 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : select_1723);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1726;
  assign sum_1726 = registration_counts_half_votes_2_down_q + {{13{select_1725[1]}}, select_1725};
  // hls/stages/agreement.hpp:170
  logic and_1728;
  assign and_1728 = less_1695 & not_1653;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1731;
  assign select_1731 = drew_s3_q ? (less_375_s3_q ? 2'h0 : (and_1488 ? {and_1728, not_1653} : 2'h0)) : 2'h0;
  logic [1:0] select_1733;
  assign select_1733 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : select_1731);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1734;
  assign sum_1734 = registration_counts_half_votes_2_up_q + {{13{select_1733[1]}}, select_1733};
  // hls/stages/agreement.hpp:170
  logic and_1736;
  assign and_1736 = lower_half_s3_q & less_1686;
  logic [1:0] select_1738;
  assign select_1738 = less_375_s3_q ? 2'h0 : (and_1488 ? {and_1736, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1741;
  assign select_1741 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : (drew_s3_q ? select_1738 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1742;
  assign sum_1742 = registration_counts_half_votes_3_down_q + {{13{select_1741[1]}}, select_1741};
  // hls/stages/agreement.hpp:170
  logic and_1744;
  assign and_1744 = lower_half_s3_q & less_1695;
  logic [1:0] select_1746;
  assign select_1746 = less_375_s3_q ? 2'h0 : (and_1488 ? {and_1744, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1749;
  assign select_1749 = equal_372_s3_q ? 2'h0 : (equal_374_s3_q ? 2'h0 : (drew_s3_q ? select_1746 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1750;
  assign sum_1750 = registration_counts_half_votes_3_up_q + {{13{select_1749[1]}}, select_1749};
  // hls/stages/division.hpp:34
  logic [7:0] sum_1764;
  assign sum_1764 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:264
  logic [2:0] select_1766;
  assign select_1766 = less_1763_s3_q ? (sum_1764[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1768;
  assign select_1768 = equal_1259_s3_q ? (equal_407_s3_q ? 3'h0 : select_1766) : region_row_q;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1772;
  assign select_1772 = equal_372_s3_q ? select_901 : (equal_374_s3_q ? select_901 : (drew_s3_q ? select_1011 : 8'h1));
  // hls/stages/division.hpp:35
  logic [8:0] sum_1773;
  assign sum_1773 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1774;
  assign select_1774 = sum_912[5] ? {1'b1, sum_912[4:0], region_across_rest_q[2:0]} : sum_1773;
  // hls/stages/agreement.hpp:142
  logic [8:0] select_1775;
  assign select_1775 = drew_s3_q ? select_1774 : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/agreement.hpp:264
  logic [7:0] select_1778;
  assign select_1778 = equal_1259_s3_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_1781;
  assign select_1781 = equal_1259_s3_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  logic [8:0] select_1785;
  assign select_1785 = equal_407_s3_q ? {{2{difference_1783[6]}}, difference_1783} : (less_1763_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:184
  logic [8:0] select_1787;
  assign select_1787 = and_353_s3_q ? (equal_1259_s3_q ? select_1785 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:264
  logic [6:0] select_1789;
  assign select_1789 = equal_407_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1791;
  assign select_1791 = and_353_s3_q ? (equal_1259_s3_q ? select_1789 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1792;
  assign sum_1792 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1793;
  assign select_1793 = sum_1764[7] ? {1'b1, sum_1764[6:0], region_down_rest_q[0]} : sum_1792;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1764[7];
  // hls/stages/agreement.hpp:264
  logic select_1797;
  assign select_1797 = equal_1259_s3_q ? (equal_407_s3_q | (less_1763_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:142
  logic or_1802;
  assign or_1802 = segment_starts_q | not_1305_s3_q;
  // hls/stages/agreement.hpp:542
  logic select_1805;
  assign select_1805 = less_375_s3_q ? or_1802 : (sum_912[5] ? (equal_914_s3_q & or_915) : or_915);
  // hls/stages/agreement.hpp:317
  logic select_1808;
  assign select_1808 = equal_372_s3_q ? or_1802 : (equal_374_s3_q ? or_1802 : (drew_s3_q ? select_1805 : or_1802));
  // hls/stages/agreement.hpp:654
  logic equal_1810;
  assign equal_1810 = x_s3_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:656
  logic [7:0] select_1834;
  assign select_1834 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1836;
  assign select_1836 = equal_917_s3_q ? (equal_1810 ? select_1834 : hidden_for_q) : hidden_for_q;
  logic [7:0] select_1838;
  assign select_1838 = equal_374_s3_q ? hidden_for_q : (drew_s3_q ? hidden_for_q : select_1836);
  // hls/stages/agreement.hpp:144
  logic not_1840;
  assign not_1840 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:317
  logic select_1915;
  assign select_1915 = drew_s3_q ? (seen_columns_rdata_q[4] & not_376_s3_q) : centres_values_0_textured_q;
  logic select_1917;
  assign select_1917 = equal_372_s3_q ? centres_values_0_textured_q : (equal_374_s3_q ? centres_values_0_textured_q : select_1915);
  logic select_1919;
  assign select_1919 = drew_s3_q ? (seen_columns_rdata_q[5] & not_376_s3_q) : centres_values_0_of_skin_q;
  logic select_1921;
  assign select_1921 = equal_372_s3_q ? centres_values_0_of_skin_q : (equal_374_s3_q ? centres_values_0_of_skin_q : select_1919);
  logic select_1922;
  assign select_1922 = drew_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_1924;
  assign select_1924 = equal_372_s3_q ? centres_values_1_textured_q : (equal_374_s3_q ? centres_values_1_textured_q : select_1922);
  logic select_1925;
  assign select_1925 = drew_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_1927;
  assign select_1927 = equal_372_s3_q ? centres_values_1_of_skin_q : (equal_374_s3_q ? centres_values_1_of_skin_q : select_1925);
  // hls/stages/agreement.hpp:264
  logic [10:0] select_1931;
  assign select_1931 = equal_1259_s3_q ? (equal_1928_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:184
  logic [5:0] select_1934;
  assign select_1934 = and_353_s3_q ? (equal_1259_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:730
  logic xor_1935;
  assign xor_1935 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:187
  logic select_1937;
  assign select_1937 = and_981_s3_q ? (left_first_s3_q ? xor_1935 : write_half_q) : write_half_q;
  logic select_1939;
  assign select_1939 = and_981_s3_q ? (left_first_s3_q ? xor_1935 : select_1937) : write_half_q;
  logic select_1941;
  assign select_1941 = left_first_s3_q ? select_963 : (and_981_s3_q ? select_964 : read_half_q);
  logic and_1945;
  assign and_1945 = (~begins_product_q) & (done_q | said_q);
  // hls/stages/agreement.hpp:317
  logic and_1955;
  assign and_1955 = not_373_s3_q & (not_518_s3_q & (not_1305_s3_q & (equal_917_s3_q & equal_1810)));
  // hls/stages/agreement.hpp:187
  logic [9:0] select_1957;
  assign select_1957 = left_first_s3_q ? 10'h1 : (and_981_s3_q ? select_968 : rows_passed_q);
  logic [8:0] select_1960;
  assign select_1960 = left_first_s3_q ? {select_966[7:0], or_965} : (and_981_s3_q ? {select_966[7:0], or_965} : columns_passed_q);
  logic select_1963;
  assign select_1963 = left_first_s3_q ? marks_last_s3_q : (and_981_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_1967;
  assign select_1967 = and_981_s3_q ? (left_first_s3_q ? and_984 : (and_981_s3_q ? and_984 : began_q)) : began_q;
  logic [2:0] select_1969;
  assign select_1969 = left_first_s3_q ? select_986 : (and_981_s3_q ? select_986 : seen_x_q);
  // hls/stages/agreement.hpp:759
  logic [2:0] select_1974;
  assign select_1974 = left_first_s3_q ? 3'h0 : (and_969 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:187
  logic [2:0] select_1977;
  assign select_1977 = and_981_s3_q ? (left_first_s3_q ? 3'h0 : (and_981_s3_q ? select_1974 : seen_y_q)) : seen_y_q;
  logic [7:0] select_1979;
  assign select_1979 = left_first_s3_q ? select_977 : (and_981_s3_q ? select_977 : seen_column_q);
  // hls/stages/agreement.hpp:185
  logic [7:0] select_1985;
  assign select_1985 = left_first_s3_q ? select_1983 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:187
  logic [7:0] select_1987;
  assign select_1987 = left_first_s3_q ? select_1983 : (and_981_s3_q ? select_1985 : seen_rows_left_q);
  // hls/stages/agreement.hpp:185
  logic and_1992;
  assign and_1992 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:187
  logic select_1994;
  assign select_1994 = left_first_s3_q ? and_1992 : (and_981_s3_q ? and_1992 : at_cell_end_q);
  logic select_1997;
  assign select_1997 = left_first_s3_q ? next_row : (and_981_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_2000;
  assign select_2000 = left_first_s3_q ? 11'h0 : (and_981_s3_q ? select_974 : seen_base_q);
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2081;
  assign sum_2081 = {1'b0, upper} + {1'b0, lower};
  logic less_2082;
  assign less_2082 = 11'h4 < sum_2081[13:3];
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};
  // hls/stages/registration.hpp:100
  logic less_2085;
  assign less_2085 = 11'he < left[12:2];
  // hls/stages/registration.hpp:119
  logic less_2087;
  assign less_2087 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_2088;
  assign or_2088 = (~less_2085) | less_2087;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:100
  logic less_2090;
  assign less_2090 = 11'he < right[12:2];
  // hls/stages/registration.hpp:119
  logic less_2092;
  assign less_2092 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic select_2094;
  assign select_2094 = less_2082 ? (or_2088 ? less_2087 : less_2092) : less_2092;
  logic or_2095;
  assign or_2095 = (~less_2090) | select_2094;
  // hls/stages/registration.hpp:100
  logic less_2096;
  assign less_2096 = 11'he < upper[12:2];
  // hls/stages/registration.hpp:119
  logic less_2098;
  assign less_2098 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/registration.hpp:104
  logic select_2099;
  assign select_2099 = or_2095 ? select_2094 : less_2098;
  logic select_2101;
  assign select_2101 = less_2082 ? select_2099 : (less_2085 ? select_2099 : less_2098);
  logic or_2102;
  assign or_2102 = (~less_2096) | select_2101;
  // hls/stages/registration.hpp:119
  logic less_2103;
  assign less_2103 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_2104;
  assign select_2104 = or_2102 ? select_2101 : less_2103;
  logic select_2107;
  assign select_2107 = less_2082 ? select_2104 : (less_2085 ? select_2104 : (less_2090 ? select_2104 : less_2103));
  // hls/stages/registration.hpp:101
  logic less_2108;
  assign less_2108 = 11'he < lower[12:2];
  // hls/stages/registration.hpp:104
  logic or_2110;
  assign or_2110 = select_2107 | (~less_2108);
  // hls/stages/registration.hpp:119
  logic less_2111;
  assign less_2111 = $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
  // hls/stages/registration.hpp:105
  logic select_2112;
  assign select_2112 = or_2110 ? select_2107 : less_2111;
  logic select_2115;
  assign select_2115 = less_2085 ? select_2112 : (less_2090 ? select_2112 : (less_2096 ? select_2112 : less_2111));
  // hls/stages/agreement.hpp:658
  logic and_2127;
  assign and_2127 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2128;
  assign or_2128 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2127;
  logic select_2129;
  assign select_2129 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2128 : and_2127;
  logic and_2130;
  assign and_2130 = (less_2096 & less_2108) & select_2129;
  logic or_2131;
  assign or_2131 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2130;
  logic select_2132;
  assign select_2132 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2131 : and_2130;
  logic or_2133;
  assign or_2133 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2132;
  logic select_2134;
  assign select_2134 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2133 : select_2132;
  logic select_2135;
  assign select_2135 = (less_2085 & less_2090) ? select_2134 : and_2130;
  logic or_2136;
  assign or_2136 = (less_2082 ? select_2112 : select_2115) | select_2135;
  // hls/stages/registration.hpp:119
  logic less_2137;
  assign less_2137 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  // hls/stages/agreement.hpp:658
  logic or_2138;
  assign or_2138 = less_2137 | or_2136;
  logic select_2139;
  assign select_2139 = or_2110 ? or_2136 : or_2138;
  // hls/stages/registration.hpp:119
  logic less_2140;
  assign less_2140 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2143;
  assign less_2143 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2146;
  assign less_2146 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:658
  logic and_2188;
  assign and_2188 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1834 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:317
  logic and_2192;
  assign and_2192 = not_1305_s3_q & (equal_917_s3_q & (equal_1810 & (cfg_prove_i & and_2188)));
  logic [11:0] select_2216;
  assign select_2216 = equal_917_s3_q ? (equal_1810 ? registration_counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2219;
  assign select_2219 = equal_372_s3_q ? 12'h0 : (equal_374_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2216));
  logic [11:0] select_2221;
  assign select_2221 = equal_917_s3_q ? (equal_1810 ? registration_counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2224;
  assign select_2224 = equal_372_s3_q ? 12'h0 : (equal_374_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2221));
  logic [11:0] select_2226;
  assign select_2226 = equal_917_s3_q ? (equal_1810 ? registration_counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2229;
  assign select_2229 = equal_372_s3_q ? 12'h0 : (equal_374_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2226));
  logic [11:0] select_2231;
  assign select_2231 = equal_917_s3_q ? (equal_1810 ? registration_counts_measured_3_q : 12'h0) : 12'h0;
  logic [11:0] select_2234;
  assign select_2234 = equal_372_s3_q ? 12'h0 : (equal_374_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2231));

  // Memory regions, 64 x 36, DISTANCE 12, hls/stages/agreement.hpp:822; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = drew_s3_q ? {region_row_q, or_910, or_907, or_904} : x_s3_q[5:0];
  logic regions_re;
  assign regions_re = s3_en & (not_373_s3_q & (not_518_s3_q & (drew_s3_q ? and_916 : and_920)));
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:841; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_979;
  logic map_re;
  assign map_re = s3_en & (and_981_s3_q ? (left_first_s3_q ? and_990 : and_991) : and_991);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory census_memory, write
  logic [5:0] census_memory_waddr;
  assign census_memory_waddr = column_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_353_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_371_s3_q, whole_2_s3_q, select_363, select_359};
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

  // Memory best_right, write
  logic [5:0] best_right_waddr;
  assign best_right_waddr = partner_s3_q;
  logic best_right_we;
  assign best_right_we = s3_en & and_885_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_900, select_896};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 6'd47) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 6'd47) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [5:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s3_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_959_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[10:6], seen_columns_rdata_q[4:0], near, explained, and_961, textured};
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
      counts_too_little_explained_q <= 24'h0;
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
    end else if (s3_en) begin
      census_filled_q <= and_353_s3_q ? {select_410[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_353_s3_q ? select_409 : rows_passed_above_q;
      counts_too_little_explained_q <= and_1392 ? 24'h0 : sum_1446;
      counts_too_much_hidden_q <= select_1486;
      registration_counts_measured_0_q <= select_1578;
      registration_counts_measured_1_q <= select_1587;
      registration_counts_measured_2_q <= select_1595;
      registration_counts_measured_3_q <= select_1602;
      registration_counts_votes_0_down_q <= and_1392 ? 15'h0 : sum_1609;
      registration_counts_votes_0_up_q <= and_1392 ? 15'h0 : sum_1618;
      registration_counts_votes_1_down_q <= and_1392 ? 15'h0 : sum_1627;
      registration_counts_votes_1_up_q <= and_1392 ? 15'h0 : sum_1635;
      registration_counts_votes_2_down_q <= and_1392 ? 15'h0 : sum_1643;
      registration_counts_votes_2_up_q <= and_1392 ? 15'h0 : sum_1651;
      registration_counts_votes_3_down_q <= and_1392 ? 15'h0 : sum_1660;
      registration_counts_votes_3_up_q <= and_1392 ? 15'h0 : sum_1668;
      registration_counts_votes_4_down_q <= and_1392 ? 15'h0 : sum_1676;
      registration_counts_votes_4_up_q <= and_1392 ? 15'h0 : sum_1684;
      registration_counts_half_votes_0_down_q <= and_1392 ? 15'h0 : sum_1693;
      registration_counts_half_votes_0_up_q <= and_1392 ? 15'h0 : sum_1702;
      registration_counts_half_votes_1_down_q <= and_1392 ? 15'h0 : sum_1710;
      registration_counts_half_votes_1_up_q <= and_1392 ? 15'h0 : sum_1718;
      registration_counts_half_votes_2_down_q <= and_1392 ? 15'h0 : sum_1726;
      registration_counts_half_votes_2_up_q <= and_1392 ? 15'h0 : sum_1734;
      registration_counts_half_votes_3_down_q <= and_1392 ? 15'h0 : sum_1742;
      registration_counts_half_votes_3_up_q <= and_1392 ? 15'h0 : sum_1750;
      region_row_q <= and_353_s3_q ? select_1768 : region_row_q;
      region_columns_q <= select_1772;
      region_across_rest_q <= select_1775;
      region_across_back_q <= drew_s3_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_353_s3_q ? select_1778 : columns_begin_rest_q;
      columns_begin_back_q <= and_353_s3_q ? select_1781 : columns_begin_back_q;
      region_down_rest_q <= select_1787;
      region_down_back_q <= select_1791;
      region_down_next_q <= select_1793;
      region_fresh_q <= and_353_s3_q ? select_1797 : region_fresh_q;
      segment_starts_q <= select_1808;
      hidden_for_q <= equal_372_s3_q ? hidden_for_q : select_1838;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1840};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s3_q;
      centres_values_0_textured_q <= select_1917;
      centres_values_0_of_skin_q <= select_1921;
      centres_values_1_textured_q <= select_1924;
      centres_values_1_of_skin_q <= select_1927;
      map_row_q <= and_353_s3_q ? select_1931 : map_row_q;
      map_width_q <= select_1934;
      write_half_q <= select_1939;
      read_half_q <= and_981_s3_q ? select_1941 : read_half_q;
      done_q <= and_981_s3_q ? (not_982 & and_1945) : and_1945;
      said_q <= and_1955;
      rows_passed_q <= and_981_s3_q ? select_1957 : rows_passed_q;
      columns_passed_q <= and_981_s3_q ? select_1960 : columns_passed_q;
      line_ended_q <= and_981_s3_q ? select_1963 : line_ended_q;
      began_q <= select_1967;
      seen_x_q <= and_981_s3_q ? select_1969 : seen_x_q;
      seen_y_q <= select_1977;
      seen_column_q <= and_981_s3_q ? select_1979 : seen_column_q;
      seen_rows_left_q <= and_981_s3_q ? select_1987 : seen_rows_left_q;
      at_cell_end_q <= and_981_s3_q ? select_1994 : at_cell_end_q;
      was_next_row_q <= and_981_s3_q ? select_1997 : was_next_row_q;
      seen_base_q <= and_981_s3_q ? select_2000 : seen_base_q;
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      averager_total_0_q <= select_1099;
      averager_total_1_q <= select_1101;
      census_columns_values_0_cell_0_left_q <= select_1125;
      census_columns_values_0_cell_0_right_q <= select_1126;
      census_columns_values_0_cell_0_mask_q <= select_1127;
      census_columns_values_0_cell_1_left_q <= select_1128;
      census_columns_values_0_cell_1_right_q <= select_1129;
      census_columns_values_0_cell_1_mask_q <= select_1130;
      census_columns_values_0_cell_2_left_q <= select_1131;
      census_columns_values_0_cell_2_right_q <= select_1132;
      census_columns_values_0_cell_2_mask_q <= select_1133;
      census_columns_values_0_cell_2_of_skin_q <= select_1134;
      census_columns_values_0_cell_3_left_q <= select_1135;
      census_columns_values_0_cell_3_right_q <= select_1136;
      census_columns_values_0_cell_3_mask_q <= select_1137;
      census_columns_values_0_cell_4_left_q <= select_1138;
      census_columns_values_0_cell_4_right_q <= select_1139;
      census_columns_values_0_cell_4_mask_q <= select_1140;
      census_columns_values_1_cell_0_left_q <= select_1141;
      census_columns_values_1_cell_0_right_q <= select_1142;
      census_columns_values_1_cell_0_mask_q <= select_1143;
      census_columns_values_1_cell_1_left_q <= select_1144;
      census_columns_values_1_cell_1_right_q <= select_1145;
      census_columns_values_1_cell_1_mask_q <= select_1146;
      census_columns_values_1_cell_2_left_q <= select_1147;
      census_columns_values_1_cell_2_right_q <= select_1148;
      census_columns_values_1_cell_2_mask_q <= select_1149;
      census_columns_values_1_cell_2_of_skin_q <= select_1150;
      census_columns_values_1_cell_3_left_q <= select_1151;
      census_columns_values_1_cell_3_right_q <= select_1152;
      census_columns_values_1_cell_3_mask_q <= select_1153;
      census_columns_values_1_cell_4_left_q <= select_1154;
      census_columns_values_1_cell_4_right_q <= select_1155;
      census_columns_values_1_cell_4_mask_q <= select_1156;
      census_columns_values_2_cell_0_left_q <= select_1157;
      census_columns_values_2_cell_0_right_q <= select_1158;
      census_columns_values_2_cell_0_mask_q <= select_1159;
      census_columns_values_2_cell_1_left_q <= select_1160;
      census_columns_values_2_cell_1_right_q <= select_1161;
      census_columns_values_2_cell_1_mask_q <= select_1162;
      census_columns_values_2_cell_2_left_q <= select_1163;
      census_columns_values_2_cell_2_right_q <= select_1164;
      census_columns_values_2_cell_2_mask_q <= select_1165;
      census_columns_values_2_cell_3_left_q <= select_1166;
      census_columns_values_2_cell_3_right_q <= select_1167;
      census_columns_values_2_cell_3_mask_q <= select_1168;
      census_columns_values_2_cell_4_left_q <= select_1169;
      census_columns_values_2_cell_4_right_q <= select_1170;
      census_columns_values_2_cell_4_mask_q <= select_1171;
      census_columns_values_3_cell_0_mask_q <= select_1172;
      census_columns_values_3_cell_1_left_q <= select_1173;
      census_columns_values_3_cell_1_right_q <= select_1174;
      census_columns_values_3_cell_1_mask_q <= select_1175;
      census_columns_values_3_cell_2_mask_q <= select_1176;
      census_columns_values_3_cell_3_left_q <= select_1177;
      census_columns_values_3_cell_3_right_q <= select_1178;
      census_columns_values_3_cell_3_mask_q <= select_1179;
      census_columns_values_3_cell_4_mask_q <= select_1180;
      sharpness_last_mean_0_q <= and_353_s3_q ? select_359 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_353_s3_q ? select_363 : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic left_first_s4_q;
  logic sample_pair_whole_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [5:0] x_s4_q;
  logic age_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic begins_product_s4_q;
  logic centres_values_1_textured_s4_q;
  logic centres_values_1_of_skin_s4_q;
  logic done_s4_q;
  logic [5:0] column_s4_q;
  logic and_351_s4_q;
  logic and_353_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_356_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic equal_372_s4_q;
  logic not_373_s4_q;
  logic equal_374_s4_q;
  logic less_375_s4_q;
  logic not_376_s4_q;
  logic less_380_s4_q;
  logic less_381_s4_q;
  logic less_382_s4_q;
  logic less_383_s4_q;
  logic less_384_s4_q;
  logic less_385_s4_q;
  logic less_386_s4_q;
  logic less_387_s4_q;
  logic less_388_s4_q;
  logic less_389_s4_q;
  logic less_390_s4_q;
  logic less_391_s4_q;
  logic less_392_s4_q;
  logic less_393_s4_q;
  logic less_394_s4_q;
  logic less_395_s4_q;
  logic less_396_s4_q;
  logic less_397_s4_q;
  logic less_398_s4_q;
  logic less_399_s4_q;
  logic less_400_s4_q;
  logic less_401_s4_q;
  logic less_402_s4_q;
  logic less_403_s4_q;
  logic and_411_s4_q;
  logic and_436_s4_q;
  logic and_437_s4_q;
  logic [11:0] texture_s4_q;
  logic [5:0] x_s4_2_q;
  logic not_518_s4_q;
  logic [7:0] best_left_rdata_s4_q;
  logic equal_523_s4_q;
  logic select_819_s4_q;
  logic less_825_s4_q;
  logic less_826_s4_q;
  logic or_828_s4_q;
  logic [7:0] select_832_s4_q;
  logic [5:0] select_836_s4_q;
  logic equal_841_s4_q;
  logic rise_s4_q;
  logic [1:0] sum_853_s4_q;
  logic [7:0] twice_s4_q;
  logic [8:0] difference_865_s4_q;
  logic and_885_s4_q;
  logic or_904_s4_q;
  logic or_907_s4_q;
  logic or_910_s4_q;
  logic equal_917_s4_q;
  logic equal_918_s4_q;
  logic and_928_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_951_s4_q;
  logic and_958_s4_q;
  logic and_981_s4_q;
  logic and_988_s4_q;
  logic less_989_s4_q;
  logic [11:0] sum_997_s4_q;
  logic [2:0] textured_2_s4_q;
  logic equal_1006_s4_q;
  logic or_1014_s4_q;
  logic or_1017_s4_q;
  logic or_1020_s4_q;
  logic [2:0] explained_2_s4_q;
  logic [2:0] near_2_s4_q;
  logic and_1062_s4_q;
  logic [11:0] sum_1200_s4_q;
  logic equal_1207_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic not_1305_s4_q;
  logic and_1392_s4_q;
  logic and_1397_s4_q;
  logic equal_1415_s4_q;
  logic and_1488_s4_q;
  logic equal_1491_s4_q;
  logic equal_1492_s4_q;
  logic equal_1493_s4_q;
  logic [7:0] residual_s4_q;
  logic equal_1810_s4_q;
  logic less_1816_s4_q;
  logic and_2003_s4_q;
  logic less_2082_s4_q;
  logic less_2083_s4_q;
  logic less_2085_s4_q;
  logic or_2088_s4_q;
  logic less_2090_s4_q;
  logic or_2095_s4_q;
  logic less_2096_s4_q;
  logic or_2102_s4_q;
  logic select_2139_s4_q;
  logic or_2141_s4_q;
  logic less_2143_s4_q;
  logic less_2146_s4_q;
  logic select_2150_s4_q;
  logic and_2194_s4_q;
  logic [11:0] select_2219_s4_q;
  logic [11:0] select_2224_s4_q;
  logic [11:0] select_2229_s4_q;
  logic [11:0] select_2234_s4_q;
  logic and_2257_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      left_first_s4_q <= left_first_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s4_q <= x_s3_q[5:0];
      age_s4_q <= age_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      begins_product_s4_q <= begins_product_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      done_s4_q <= done_q;
      column_s4_q <= column_s3_q;
      and_351_s4_q <= and_351_s3_q;
      and_353_s4_q <= and_353_s3_q;
      grey_s4_q <= grey_s3_q;
      equal_356_s4_q <= equal_356_s3_q;
      grey_2_s4_q <= grey_2_s3_q;
      whole_2_s4_q <= whole_2_s3_q;
      equal_372_s4_q <= equal_372_s3_q;
      not_373_s4_q <= not_373_s3_q;
      equal_374_s4_q <= equal_374_s3_q;
      less_375_s4_q <= less_375_s3_q;
      not_376_s4_q <= not_376_s3_q;
      less_380_s4_q <= less_380;
      less_381_s4_q <= less_381;
      less_382_s4_q <= less_382;
      less_383_s4_q <= less_383;
      less_384_s4_q <= less_384;
      less_385_s4_q <= less_385;
      less_386_s4_q <= less_386;
      less_387_s4_q <= less_387;
      less_388_s4_q <= less_388;
      less_389_s4_q <= less_389;
      less_390_s4_q <= less_390;
      less_391_s4_q <= less_391;
      less_392_s4_q <= less_392;
      less_393_s4_q <= less_393;
      less_394_s4_q <= less_394;
      less_395_s4_q <= less_395;
      less_396_s4_q <= less_396;
      less_397_s4_q <= less_397;
      less_398_s4_q <= less_398;
      less_399_s4_q <= less_399;
      less_400_s4_q <= less_400;
      less_401_s4_q <= less_401;
      less_402_s4_q <= less_402;
      less_403_s4_q <= less_403;
      and_411_s4_q <= and_411;
      and_436_s4_q <= whole_22 & and_411;
      and_437_s4_q <= census_columns_values_1_cell_2_mask_q & and_411;
      texture_s4_q <= texture;
      x_s4_2_q <= x_s3_2_q[5:0];
      not_518_s4_q <= not_518_s3_q;
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      equal_523_s4_q <= equal_523_s3_q;
      select_819_s4_q <= select_819[0];
      less_825_s4_q <= less_825;
      less_826_s4_q <= less_826;
      or_828_s4_q <= or_828;
      select_832_s4_q <= equal_523_s3_q ? of_best_2 : select_831;
      select_836_s4_q <= equal_523_s3_q ? run_shift_s3_q : select_835;
      equal_841_s4_q <= {less_818, select_819} == near_best;
      rise_s4_q <= rise[8];
      sum_853_s4_q <= {less_818, select_819[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_865_s4_q <= {1'b0, twice} - (({twice, 1'b0} < size) ? {twice, 1'b0} : size);
      and_885_s4_q <= and_885_s3_q;
      or_904_s4_q <= or_904;
      or_907_s4_q <= or_907;
      or_910_s4_q <= or_910;
      equal_917_s4_q <= equal_917_s3_q;
      equal_918_s4_q <= equal_918;
      and_928_s4_q <= and_928_s3_q;
      textured_s4_q <= textured;
      explained_s4_q <= explained;
      and_951_s4_q <= not_376_s3_q & (left_rdata_s3_q & and_949);
      and_958_s4_q <= not_373_s3_q & (not_518_s3_q & (drew_s3_q & and_916));
      and_981_s4_q <= and_981_s3_q;
      and_988_s4_q <= and_988;
      less_989_s4_q <= less_989;
      sum_997_s4_q <= sum_997;
      textured_2_s4_q <= textured_2;
      equal_1006_s4_q <= x_s3_q == 8'h0;
      or_1014_s4_q <= or_1014;
      or_1017_s4_q <= select_1011[7] | (~({select_1011[6], select_1011[3:2]} == 3'h0));
      or_1020_s4_q <= select_1011[7] | (~(select_1011[6:4] == 3'h0));
      explained_2_s4_q <= explained_2;
      near_2_s4_q <= near_2;
      and_1062_s4_q <= and_1062_s3_q;
      sum_1200_s4_q <= ({1'b0, sum_1192} + {2'h0, sum_1195}) + {2'h0, sum_1199};
      equal_1207_s4_q <= equal_1207_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      not_1305_s4_q <= not_1305_s3_q;
      and_1392_s4_q <= and_1392;
      and_1397_s4_q <= and_1397;
      equal_1415_s4_q <= x_s3_q[7:1] == 7'h0;
      and_1488_s4_q <= and_1488;
      equal_1491_s4_q <= equal_1491;
      equal_1492_s4_q <= equal_1492;
      equal_1493_s4_q <= equal_1493;
      residual_s4_q <= residual[7:0];
      equal_1810_s4_q <= equal_1810;
      less_1816_s4_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      and_2003_s4_q <= and_1062_s3_q & (sum_997 == sum_979);
      less_2082_s4_q <= less_2082;
      less_2083_s4_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2085_s4_q <= less_2085;
      or_2088_s4_q <= or_2088;
      less_2090_s4_q <= less_2090;
      or_2095_s4_q <= or_2095;
      less_2096_s4_q <= less_2096;
      or_2102_s4_q <= or_2102;
      select_2139_s4_q <= select_2139;
      or_2141_s4_q <= less_2140 | select_2139;
      less_2143_s4_q <= less_2143;
      less_2146_s4_q <= less_2146;
      select_2150_s4_q <= less_2108 ? or_2138 : select_2135;
      and_2194_s4_q <= not_373_s3_q & (not_518_s3_q & and_2192);
      select_2219_s4_q <= select_2219;
      select_2224_s4_q <= select_2224;
      select_2229_s4_q <= select_2229;
      select_2234_s4_q <= select_2234;
      and_2257_s4_q <= not_373_s3_q & (not_518_s3_q & (not_1305_s3_q & and_920));
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
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
  logic [4:0] box_nearer_columns_values_0_q;
  logic [4:0] box_nearer_columns_values_1_q;
  logic [4:0] box_nearer_columns_values_2_q;
  logic [4:0] box_nearer_columns_values_3_q;
  logic [4:0] box_nearer_columns_values_4_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic proven_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:201
  logic [12:0] sum_457;
  assign sum_457 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_459;
  assign sum_459 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_457});
  // hls/stages/census.hpp:223
  logic less_460;
  assign less_460 = 9'h4 < sum_459[13:5];
  logic and_461;
  assign and_461 = and_411_s4_q & less_460;
  // hls/stages/registration.hpp:28
  logic not_866;
  assign not_866 = ~difference_865_s4_q[8];
  logic [7:0] xor_867;
  assign xor_867 = twice_s4_q ^ {8{not_866}};
  logic [9:0] sum_868;
  assign sum_868 = {difference_865_s4_q[7:0], 1'b0, not_866} + {not_866, xor_867, not_866};
  logic not_869;
  assign not_869 = ~sum_868[9];
  logic [7:0] xor_870;
  assign xor_870 = twice_s4_q ^ {8{not_869}};
  logic [9:0] sum_871;
  assign sum_871 = {sum_868[8:0], not_869} + {not_869, xor_870, not_869};
  logic not_872;
  assign not_872 = ~sum_871[9];
  logic [7:0] xor_873;
  assign xor_873 = twice_s4_q ^ {8{not_872}};
  logic [9:0] sum_874;
  assign sum_874 = {sum_871[8:0], not_872} + {not_872, xor_873, not_872};
  logic not_875;
  assign not_875 = ~sum_874[9];
  logic [7:0] xor_876;
  assign xor_876 = twice_s4_q ^ {8{not_875}};
  logic [9:0] sum_877;
  assign sum_877 = {sum_874[8:0], not_875} + {not_875, xor_876, not_875};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_878;
  assign difference_878 = {sum_853_s4_q, select_819_s4_q, 5'h0} - {3'h0, difference_865_s4_q[8], sum_868[9], sum_871[9], sum_874[9], sum_877[9]};
  // hls/stages/agreement.hpp:446
  logic [7:0] select_879;
  assign select_879 = rise_s4_q ? difference_878 : {sum_853_s4_q, select_819_s4_q, difference_865_s4_q[8], sum_868[9], sum_871[9], sum_874[9], sum_877[9]};
  logic [7:0] select_880;
  assign select_880 = equal_841_s4_q ? select_879 : {sum_853_s4_q, select_819_s4_q, 5'h0};
  // hls/stages/agreement.hpp:448
  logic [7:0] select_883;
  assign select_883 = less_825_s4_q ? (or_828_s4_q ? select_880 : best_left_rdata_s4_q) : (less_826_s4_q ? select_880 : best_left_rdata_s4_q);
  logic [7:0] select_884;
  assign select_884 = equal_523_s4_q ? select_880 : select_883;
  // hls/stages/agreement.hpp:484
  logic [5:0] select_930;
  assign select_930 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:485
  logic [5:0] sum_931;
  assign sum_931 = {5'h0, textured_s4_q} + select_930;
  // hls/stages/agreement.hpp:575
  logic [11:0] sum_933;
  assign sum_933 = {6'h0, sum_931} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:484
  logic [5:0] select_941;
  assign select_941 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:485
  logic [5:0] sum_942;
  assign sum_942 = {5'h0, explained_s4_q} + select_941;
  // hls/stages/agreement.hpp:576
  logic [11:0] sum_944;
  assign sum_944 = {6'h0, sum_942} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:484
  logic [5:0] select_952;
  assign select_952 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:486
  logic [5:0] sum_953;
  assign sum_953 = {5'h0, and_951_s4_q} + select_952;
  // hls/stages/agreement.hpp:577
  logic [11:0] sum_955;
  assign sum_955 = {6'h0, sum_953} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:606
  logic [4:0] difference_1005;
  assign difference_1005 = {2'h0, textured_2_s4_q} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  logic [4:0] t;
  assign t = difference_1005 + (equal_1006_s4_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:612
  logic not_1021;
  assign not_1021 = ~region_row_s4_q[2];
  logic [2:0] select_1022;
  assign select_1022 = region_row_s4_q[1] ? {1'b0, not_1021, 1'b0} : {region_row_s4_q[2], 1'b0, not_1021};
  logic [5:0] select_1023;
  assign select_1023 = region_row_s4_q[0] ? {select_1022[2], 1'b0, select_1022[1], 1'b0, select_1022[0], 1'b0} : {1'b0, select_1022[2], 1'b0, select_1022[1], 1'b0, select_1022[0]};
  logic [11:0] select_1024;
  assign select_1024 = or_1020_s4_q ? {select_1023[5], 1'b0, select_1023[4], 1'b0, select_1023[3], 1'b0, select_1023[2], 1'b0, select_1023[1], 1'b0, select_1023[0], 1'b0} : {1'b0, select_1023[5], 1'b0, select_1023[4], 1'b0, select_1023[3], 1'b0, select_1023[2], 1'b0, select_1023[1], 1'b0, select_1023[0]};
  logic [23:0] select_1025;
  assign select_1025 = or_1017_s4_q ? {select_1024[11], 1'b0, select_1024[10], 1'b0, select_1024[9], 1'b0, select_1024[8], 1'b0, select_1024[7], 1'b0, select_1024[6], 1'b0, select_1024[5], 1'b0, select_1024[4], 1'b0, select_1024[3], 1'b0, select_1024[2], 1'b0, select_1024[1], 1'b0, select_1024[0], 1'b0} : {1'b0, select_1024[11], 1'b0, select_1024[10], 1'b0, select_1024[9], 1'b0, select_1024[8], 1'b0, select_1024[7], 1'b0, select_1024[6], 1'b0, select_1024[5], 1'b0, select_1024[4], 1'b0, select_1024[3], 1'b0, select_1024[2], 1'b0, select_1024[1], 1'b0, select_1024[0]};
  logic [47:0] select_1026;
  assign select_1026 = or_1014_s4_q ? {select_1025[23], 1'b0, select_1025[22], 1'b0, select_1025[21], 1'b0, select_1025[20], 1'b0, select_1025[19], 1'b0, select_1025[18], 1'b0, select_1025[17], 1'b0, select_1025[16], 1'b0, select_1025[15], 1'b0, select_1025[14], 1'b0, select_1025[13], 1'b0, select_1025[12], 1'b0, select_1025[11], 1'b0, select_1025[10], 1'b0, select_1025[9], 1'b0, select_1025[8], 1'b0, select_1025[7], 1'b0, select_1025[6], 1'b0, select_1025[5], 1'b0, select_1025[4], 1'b0, select_1025[3], 1'b0, select_1025[2], 1'b0, select_1025[1], 1'b0, select_1025[0], 1'b0} : {1'b0, select_1025[23], 1'b0, select_1025[22], 1'b0, select_1025[21], 1'b0, select_1025[20], 1'b0, select_1025[19], 1'b0, select_1025[18], 1'b0, select_1025[17], 1'b0, select_1025[16], 1'b0, select_1025[15], 1'b0, select_1025[14], 1'b0, select_1025[13], 1'b0, select_1025[12], 1'b0, select_1025[11], 1'b0, select_1025[10], 1'b0, select_1025[9], 1'b0, select_1025[8], 1'b0, select_1025[7], 1'b0, select_1025[6], 1'b0, select_1025[5], 1'b0, select_1025[4], 1'b0, select_1025[3], 1'b0, select_1025[2], 1'b0, select_1025[1], 1'b0, select_1025[0]};
  // hls/stages/agreement.hpp:607
  logic [4:0] difference_1035;
  assign difference_1035 = {2'h0, explained_2_s4_q} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_1035 + (equal_1006_s4_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:613
  logic [5:0] sum_1038;
  assign sum_1038 = {1'b0, e} + {2'h0, e[4:1]};
  logic is_seen;
  assign is_seen = (t[4:1] == 4'h0) ? (~((good_q & select_1026) == 48'h0)) : (~({sum_1038, e[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:608
  logic [4:0] difference_1047;
  assign difference_1047 = {2'h0, near_2_s4_q} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1047 + (equal_1006_s4_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:625
  logic and_1051;
  assign and_1051 = is_seen & ({1'b0, e[4:1]} < n);
  // hls/stages/agreement.hpp:183
  logic [8:0] select_1091;
  assign select_1091 = sample_pair_whole_s4_q ? (and_351_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1093;
  assign select_1093 = sample_pair_whole_s4_q ? (and_351_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1095;
  assign select_1095 = sample_pair_whole_s4_q ? (and_351_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1097;
  assign select_1097 = sample_pair_whole_s4_q ? (and_351_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1102;
  assign sum_1102 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_1103;
  assign difference_1103 = {1'b0, sum_1102[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1104;
  assign xor_1104 = {difference_1103[8:0], sum_1102[0]} ^ {10{difference_1103[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1103[9]} + {1'b0, xor_1104};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_356_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:183
  logic [13:0] select_1109;
  assign select_1109 = sample_pair_whole_s4_q ? (and_351_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1110;
  assign sum_1110 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_1111;
  assign difference_1111 = {1'b0, sum_1110[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1112;
  assign xor_1112 = {difference_1111[8:0], sum_1110[0]} ^ {10{difference_1111[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1111[9]} + {1'b0, xor_1112};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_356_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:183
  logic [13:0] select_1117;
  assign select_1117 = sample_pair_whole_s4_q ? (and_351_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:184
  logic [11:0] select_1202;
  assign select_1202 = and_353_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1203;
  assign select_1203 = and_353_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1204;
  assign select_1204 = and_353_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1205;
  assign select_1205 = and_353_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_1208;
  assign sum_1208 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1200_s4_q};
  logic [13:0] sum_1210;
  assign sum_1210 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1208});
  // hls/stages/census.hpp:225
  logic and_1212;
  assign and_1212 = and_436_s4_q & (9'h4 < sum_1210[13:5]);
  // hls/stages/census.hpp:226
  logic and_1213;
  assign and_1213 = and_436_s4_q & less_460;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1214;
  assign sum_1214 = census_left_misses_q + {{17{and_1213}}, and_1212, 1'b0, and_1212};
  // hls/stages/agreement.hpp:184
  logic [19:0] select_1216;
  assign select_1216 = and_353_s4_q ? (equal_1207_s4_q ? 20'h0 : sum_1214) : census_left_misses_q;
  // hls/stages/agreement.hpp:183
  logic [27:0] select_1221;
  assign select_1221 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:275
  logic and_1226;
  assign and_1226 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:261
  logic and_1232;
  assign and_1232 = and_1226 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1221[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1234;
  assign select_1234 = and_1232 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1236;
  assign select_1236 = equal_1207_s4_q ? {11'h0, select_1234} : (sharpness_sums_detail_0_q + {11'h0, select_1234});
  // hls/stages/agreement.hpp:261
  logic and_1243;
  assign and_1243 = and_1226 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1221[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1245;
  assign select_1245 = and_1243 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1247;
  assign select_1247 = equal_1207_s4_q ? {11'h0, select_1245} : (sharpness_sums_detail_1_q + {11'h0, select_1245});
  logic [8:0] select_1250;
  assign select_1250 = and_1232 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_1251;
  assign sum_1251 = (equal_1207_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1250};
  logic [8:0] select_1254;
  assign select_1254 = and_1243 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_1255;
  assign sum_1255 = (equal_1207_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1254};
  // hls/stages/agreement.hpp:508
  logic [13:0] select_1399;
  assign select_1399 = and_1392_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1397_s4_q});
  // hls/stages/agreement.hpp:317
  logic and_1402;
  assign and_1402 = not_373_s4_q & (not_518_s4_q & (begins_product_q & textured_s4_q));
  logic and_1407;
  assign and_1407 = not_373_s4_q & (not_518_s4_q & (begins_product_q & explained_s4_q));
  logic and_1412;
  assign and_1412 = not_373_s4_q & (not_518_s4_q & (begins_product_q & and_951_s4_q));
  // hls/stages/agreement.hpp:617
  logic not_1417;
  assign not_1417 = ~is_seen;
  // hls/stages/agreement.hpp:317
  logic and_1420;
  assign and_1420 = begins_product_q & ((~equal_1415_s4_q) & (centres_values_1_textured_s4_q & not_1417));
  logic and_1422;
  assign and_1422 = not_373_s4_q & (not_518_s4_q & and_1420);
  // hls/stages/agreement.hpp:643
  logic less_1425;
  assign less_1425 = region_row_s4_q < x_s4_q[5:3];
  logic [11:0] select_1426;
  assign select_1426 = less_1425 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1429;
  assign select_1429 = less_1425 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:644
  logic [12:0] sum_1430;
  assign sum_1430 = {1'b0, select_1429} + {3'h0, select_1429[11:2]};
  logic and_1432;
  assign and_1432 = (~(select_1426[11:4] == 8'h0)) & ({sum_1430, select_1429[1:0]} < {3'h0, select_1426});
  // hls/stages/agreement.hpp:317
  logic [11:0] select_1435;
  assign select_1435 = equal_917_s4_q ? (equal_918_s4_q ? 12'h0 : (and_1432 ? select_1426 : 12'h0)) : 12'h0;
  logic [11:0] select_1437;
  assign select_1437 = equal_374_s4_q ? 12'h0 : (begins_product_q ? 12'h0 : select_1435);
  logic [11:0] select_1438;
  assign select_1438 = equal_372_s4_q ? 12'h0 : select_1437;
  // hls/stages/agreement.hpp:508
  logic [13:0] select_1440;
  assign select_1440 = and_1392_s4_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1438});
  // hls/stages/agreement.hpp:170
  logic [8:0] select_1450;
  assign select_1450 = less_375_s4_q ? 9'h0 : (and_928_s4_q ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0);
  // hls/stages/agreement.hpp:317
  logic [20:0] select_1451;
  assign select_1451 = begins_product_q ? {{12{select_1450[8]}}, select_1450} : {1'b0, select_1435, 8'h0};
  logic [20:0] select_1453;
  assign select_1453 = equal_372_s4_q ? 21'h0 : (equal_374_s4_q ? 21'h0 : select_1451);
  // hls/stages/agreement.hpp:508
  logic [23:0] select_1455;
  assign select_1455 = and_1392_s4_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1453[20]}}, select_1453});
  // hls/stages/agreement.hpp:556
  logic [8:0] select_1457;
  assign select_1457 = and_928_s4_q ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1458;
  assign select_1458 = less_375_s4_q ? 8'h0 : select_1457[7:0];
  // hls/stages/agreement.hpp:170
  logic and_1459;
  assign and_1459 = not_376_s4_q & select_1457[8];
  // hls/stages/agreement.hpp:623
  logic [2:0] select_1462;
  assign select_1462 = centres_values_1_textured_s4_q ? (is_seen ? {3{and_1459}} : ({3{and_1459}} + 3'h1)) : {3{and_1459}};
  logic [2:0] select_1463;
  assign select_1463 = equal_1415_s4_q ? {3{and_1459}} : select_1462;
  // hls/stages/agreement.hpp:317
  logic [10:0] select_1465;
  assign select_1465 = equal_374_s4_q ? 11'h0 : (begins_product_q ? {select_1463, select_1458} : 11'h0);
  logic [10:0] select_1466;
  assign select_1466 = equal_372_s4_q ? 11'h0 : select_1465;
  // hls/stages/agreement.hpp:505
  logic [23:0] sum_1467;
  assign sum_1467 = counts_too_much_unproven_q + {{13{select_1466[10]}}, select_1466};
  // hls/stages/agreement.hpp:623
  logic [9:0] select_1470;
  assign select_1470 = centres_values_1_of_skin_s4_q ? ({1'b0, not_1417, 8'h0} - {2'h0, cfg_unproven_skin_limit_i}) : 10'h0;
  logic [9:0] select_1472;
  assign select_1472 = equal_1415_s4_q ? 10'h0 : (centres_values_1_textured_s4_q ? select_1470 : 10'h0);
  // hls/stages/agreement.hpp:317
  logic [9:0] select_1474;
  assign select_1474 = equal_374_s4_q ? 10'h0 : (begins_product_q ? select_1472 : 10'h0);
  logic [9:0] select_1475;
  assign select_1475 = equal_372_s4_q ? 10'h0 : select_1474;
  // hls/stages/agreement.hpp:506
  logic [23:0] sum_1476;
  assign sum_1476 = counts_too_much_unseen_skin_q + {{14{select_1475[9]}}, select_1475};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1531;
  assign select_1531 = equal_1492_s4_q ? 8'h0 : (equal_1493_s4_q ? 8'h0 : residual_s4_q);
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1534;
  assign select_1534 = less_375_s4_q ? 8'h0 : (and_1488_s4_q ? (equal_1491_s4_q ? 8'h0 : select_1531) : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1537;
  assign select_1537 = equal_372_s4_q ? 8'h0 : (equal_374_s4_q ? 8'h0 : (begins_product_q ? select_1534 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1538;
  assign sum_1538 = registration_counts_across_0_q + {{12{select_1537[7]}}, select_1537};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1541;
  assign select_1541 = equal_1492_s4_q ? 8'h0 : (equal_1493_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1544;
  assign select_1544 = less_375_s4_q ? 8'h0 : (and_1488_s4_q ? (equal_1491_s4_q ? 8'h0 : select_1541) : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1547;
  assign select_1547 = equal_372_s4_q ? 8'h0 : (equal_374_s4_q ? 8'h0 : (begins_product_q ? select_1544 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1548;
  assign sum_1548 = registration_counts_across_1_q + {{12{select_1547[7]}}, select_1547};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1551;
  assign select_1551 = equal_1491_s4_q ? 8'h0 : (equal_1492_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1554;
  assign select_1554 = begins_product_q ? (less_375_s4_q ? 8'h0 : (and_1488_s4_q ? select_1551 : 8'h0)) : 8'h0;
  logic [7:0] select_1556;
  assign select_1556 = equal_372_s4_q ? 8'h0 : (equal_374_s4_q ? 8'h0 : select_1554);
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1557;
  assign sum_1557 = registration_counts_across_2_q + {{12{select_1556[7]}}, select_1556};
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1561;
  assign select_1561 = less_375_s4_q ? 8'h0 : (and_1488_s4_q ? (equal_1491_s4_q ? residual_s4_q : 8'h0) : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1564;
  assign select_1564 = equal_372_s4_q ? 8'h0 : (equal_374_s4_q ? 8'h0 : (begins_product_q ? select_1561 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1565;
  assign sum_1565 = registration_counts_across_3_q + {{12{select_1564[7]}}, select_1564};
  // hls/stages/agreement.hpp:639
  logic and_1815;
  assign and_1815 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:646
  logic [12:0] sum_1819;
  assign sum_1819 = {1'b0, select_1429} + {2'h0, select_1429[11:1]};
  logic select_1822;
  assign select_1822 = (select_1426[11:3] == 9'h0) ? (and_1815 & (~less_1816_s4_q)) : (~({sum_1819, select_1429[0]} < {2'h0, select_1426}));
  // hls/stages/agreement.hpp:654
  logic [47:0] select_1823;
  assign select_1823 = equal_918_s4_q ? good_next_q : {select_1822, good_next_q[47:1]};
  // hls/stages/agreement.hpp:317
  logic [47:0] select_1825;
  assign select_1825 = equal_917_s4_q ? (equal_1810_s4_q ? select_1823 : good_q) : good_q;
  logic [47:0] select_1827;
  assign select_1827 = equal_374_s4_q ? good_q : (begins_product_q ? good_q : select_1825);
  logic [47:0] select_1830;
  assign select_1830 = begins_product_q ? good_next_q : (equal_917_s4_q ? select_1823 : good_next_q);
  logic [47:0] select_1832;
  assign select_1832 = equal_372_s4_q ? good_next_q : (equal_374_s4_q ? good_next_q : select_1830);
  // hls/stages/agreement.hpp:671
  logic [35:0] select_1851;
  assign select_1851 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:665
  logic [35:0] detail_left;
  assign detail_left = begins_product_s4_q ? 36'h0 : select_1851;
  // hls/stages/agreement.hpp:671
  logic [35:0] select_1854;
  assign select_1854 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:675
  logic [35:0] detail_right;
  assign detail_right = begins_product_s4_q ? 36'h0 : select_1854;
  // hls/stages/agreement.hpp:665
  logic [34:0] select_1856;
  assign select_1856 = begins_product_s4_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:675
  logic [34:0] select_1857;
  assign select_1857 = begins_product_s4_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:665
  logic [17:0] select_1858;
  assign select_1858 = begins_product_s4_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:675
  logic [17:0] select_1859;
  assign select_1859 = begins_product_s4_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:317
  logic [4:0] select_1860;
  assign select_1860 = begins_product_q ? {2'h0, textured_2_s4_q} : box_textured_columns_values_0_q;
  logic [4:0] select_1862;
  assign select_1862 = equal_372_s4_q ? box_textured_columns_values_0_q : (equal_374_s4_q ? box_textured_columns_values_0_q : select_1860);
  logic [4:0] select_1863;
  assign select_1863 = begins_product_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1865;
  assign select_1865 = equal_372_s4_q ? box_textured_columns_values_1_q : (equal_374_s4_q ? box_textured_columns_values_1_q : select_1863);
  logic [4:0] select_1866;
  assign select_1866 = begins_product_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1868;
  assign select_1868 = equal_372_s4_q ? box_textured_columns_values_2_q : (equal_374_s4_q ? box_textured_columns_values_2_q : select_1866);
  logic [4:0] select_1869;
  assign select_1869 = begins_product_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1871;
  assign select_1871 = equal_372_s4_q ? box_textured_columns_values_3_q : (equal_374_s4_q ? box_textured_columns_values_3_q : select_1869);
  logic [4:0] select_1872;
  assign select_1872 = begins_product_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1874;
  assign select_1874 = equal_372_s4_q ? box_textured_columns_values_4_q : (equal_374_s4_q ? box_textured_columns_values_4_q : select_1872);
  logic [4:0] select_1876;
  assign select_1876 = equal_374_s4_q ? box_textured_sum_sums_values_0_q : (begins_product_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1878;
  assign select_1878 = begins_product_q ? {2'h0, explained_2_s4_q} : box_explained_columns_values_0_q;
  logic [4:0] select_1880;
  assign select_1880 = equal_372_s4_q ? box_explained_columns_values_0_q : (equal_374_s4_q ? box_explained_columns_values_0_q : select_1878);
  logic [4:0] select_1881;
  assign select_1881 = begins_product_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1883;
  assign select_1883 = equal_372_s4_q ? box_explained_columns_values_1_q : (equal_374_s4_q ? box_explained_columns_values_1_q : select_1881);
  logic [4:0] select_1884;
  assign select_1884 = begins_product_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1886;
  assign select_1886 = equal_372_s4_q ? box_explained_columns_values_2_q : (equal_374_s4_q ? box_explained_columns_values_2_q : select_1884);
  logic [4:0] select_1887;
  assign select_1887 = begins_product_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1889;
  assign select_1889 = equal_372_s4_q ? box_explained_columns_values_3_q : (equal_374_s4_q ? box_explained_columns_values_3_q : select_1887);
  logic [4:0] select_1890;
  assign select_1890 = begins_product_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1892;
  assign select_1892 = equal_372_s4_q ? box_explained_columns_values_4_q : (equal_374_s4_q ? box_explained_columns_values_4_q : select_1890);
  logic [4:0] select_1894;
  assign select_1894 = equal_374_s4_q ? box_explained_sum_sums_values_0_q : (begins_product_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1896;
  assign select_1896 = begins_product_q ? {2'h0, near_2_s4_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_1898;
  assign select_1898 = equal_372_s4_q ? box_nearer_columns_values_0_q : (equal_374_s4_q ? box_nearer_columns_values_0_q : select_1896);
  logic [4:0] select_1899;
  assign select_1899 = begins_product_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1901;
  assign select_1901 = equal_372_s4_q ? box_nearer_columns_values_1_q : (equal_374_s4_q ? box_nearer_columns_values_1_q : select_1899);
  logic [4:0] select_1902;
  assign select_1902 = begins_product_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1904;
  assign select_1904 = equal_372_s4_q ? box_nearer_columns_values_2_q : (equal_374_s4_q ? box_nearer_columns_values_2_q : select_1902);
  logic [4:0] select_1905;
  assign select_1905 = begins_product_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1907;
  assign select_1907 = equal_372_s4_q ? box_nearer_columns_values_3_q : (equal_374_s4_q ? box_nearer_columns_values_3_q : select_1905);
  logic [4:0] select_1908;
  assign select_1908 = begins_product_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_1910;
  assign select_1910 = equal_372_s4_q ? box_nearer_columns_values_4_q : (equal_374_s4_q ? box_nearer_columns_values_4_q : select_1908);
  logic [4:0] select_1912;
  assign select_1912 = equal_374_s4_q ? box_nearer_sum_sums_values_0_q : (begins_product_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:734
  logic select_1948;
  assign select_1948 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:187
  logic select_1950;
  assign select_1950 = left_first_s4_q ? done_s4_q : (and_981_s4_q ? select_1948 : proven_q);
  // hls/stages/agreement.hpp:763
  logic [1:0] select_2004;
  assign select_2004 = and_2003_s4_q ? {and_1051, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:764
  logic and_2005;
  assign and_2005 = select_1948 & less_1981;
  // hls/stages/agreement.hpp:187
  logic select_2008;
  assign select_2008 = and_988_s4_q ? (less_989_s4_q ? (select_2004[0] & and_2005) : seen_q) : seen_q;
  logic select_2010;
  assign select_2010 = left_first_s4_q ? select_2008 : (and_981_s4_q ? select_2008 : seen_q);
  logic select_2011;
  assign select_2011 = and_981_s4_q ? select_2010 : seen_q;
  logic select_2014;
  assign select_2014 = and_988_s4_q ? (less_989_s4_q ? (select_2004[1] & and_2005) : nearer_q) : nearer_q;
  logic select_2016;
  assign select_2016 = left_first_s4_q ? select_2014 : (and_981_s4_q ? select_2014 : nearer_q);
  logic select_2017;
  assign select_2017 = and_981_s4_q ? select_2016 : nearer_q;
  // hls/stages/agreement.hpp:317
  logic [13:0] select_2022;
  assign select_2022 = equal_917_s4_q ? (equal_1810_s4_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_2024;
  assign select_2024 = equal_374_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2022);
  logic [13:0] select_2027;
  assign select_2027 = equal_917_s4_q ? (equal_1810_s4_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_2029;
  assign select_2029 = equal_374_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2027);
  logic [13:0] select_2032;
  assign select_2032 = equal_917_s4_q ? (equal_1810_s4_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_2034;
  assign select_2034 = equal_374_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2032);
  logic [13:0] select_2037;
  assign select_2037 = equal_917_s4_q ? (equal_1810_s4_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_2039;
  assign select_2039 = equal_374_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2037);
  logic [13:0] select_2042;
  assign select_2042 = equal_917_s4_q ? (equal_1810_s4_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_2044;
  assign select_2044 = equal_374_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2042);
  logic [13:0] select_2047;
  assign select_2047 = equal_917_s4_q ? (equal_1810_s4_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic [13:0] select_2049;
  assign select_2049 = equal_374_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2047);
  logic and_2055;
  assign and_2055 = not_1305_s4_q & (equal_917_s4_q & (equal_1810_s4_q & (cfg_prove_i & (~proven_q))));
  // hls/stages/agreement.hpp:691
  logic not_2058;
  assign not_2058 = ~and_1815;
  // hls/stages/agreement.hpp:317
  logic and_2062;
  assign and_2062 = not_1305_s4_q & (equal_917_s4_q & (equal_1810_s4_q & (cfg_prove_i & not_2058)));
  // hls/stages/agreement.hpp:692
  logic or_2065;
  assign or_2065 = not_2018 | not_2058;
  // hls/stages/agreement.hpp:658
  logic or_2071;
  assign or_2071 = ($signed(24'h0) < $signed(counts_too_much_unproven_q)) | ($signed(24'h0) < $signed(counts_too_much_unseen_skin_q));
  logic select_2073;
  assign select_2073 = (less_1816_s4_q | or_2065) ? (~or_2065) : (($signed(24'h0) < $signed(counts_too_many_bad_q)) | or_2071);
  // hls/stages/agreement.hpp:317
  logic and_2076;
  assign and_2076 = not_1305_s4_q & (equal_917_s4_q & (equal_1810_s4_q & select_2073));
  // hls/stages/agreement.hpp:658
  logic select_2142;
  assign select_2142 = or_2102_s4_q ? select_2139_s4_q : or_2141_s4_q;
  logic or_2144;
  assign or_2144 = less_2143_s4_q | select_2142;
  logic select_2145;
  assign select_2145 = or_2095_s4_q ? select_2142 : or_2144;
  logic or_2147;
  assign or_2147 = less_2146_s4_q | select_2145;
  logic select_2152;
  assign select_2152 = less_2090_s4_q ? or_2144 : (less_2096_s4_q ? or_2141_s4_q : select_2150_s4_q);
  logic select_2154;
  assign select_2154 = less_2082_s4_q ? (less_2083_s4_q | (or_2088_s4_q ? select_2145 : or_2147)) : (less_2085_s4_q ? or_2147 : select_2152);
  // hls/stages/agreement.hpp:317
  logic and_2158;
  assign and_2158 = not_1305_s4_q & (equal_917_s4_q & (equal_1810_s4_q & (cfg_prove_i & select_2154)));
  // hls/stages/agreement.hpp:699
  logic and_2161;
  assign and_2161 = cfg_prove_i & and_1815;
  // hls/stages/agreement.hpp:700
  logic [36:0] sum_2162;
  assign sum_2162 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2164;
  assign less_2164 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:658
  logic or_2167;
  assign or_2167 = ({detail_left, 3'h0} < {sum_2162, detail_right[1:0]}) | (less_2164 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:317
  logic and_2171;
  assign and_2171 = not_1305_s4_q & (equal_917_s4_q & (equal_1810_s4_q & (and_2161 & or_2167)));
  // hls/stages/agreement.hpp:703
  logic [36:0] sum_2174;
  assign sum_2174 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2176;
  assign less_2176 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:658
  logic or_2177;
  assign or_2177 = ({detail_right, 3'h0} < {sum_2174, detail_left[1:0]}) | less_2176;
  // hls/stages/agreement.hpp:317
  logic and_2181;
  assign and_2181 = not_1305_s4_q & (equal_917_s4_q & (equal_1810_s4_q & (and_2161 & or_2177)));
  logic [19:0] select_2196;
  assign select_2196 = equal_917_s4_q ? (equal_1810_s4_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2198;
  assign select_2198 = equal_374_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2196);
  logic [19:0] select_2201;
  assign select_2201 = equal_917_s4_q ? (equal_1810_s4_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2203;
  assign select_2203 = equal_374_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2201);
  logic [19:0] select_2206;
  assign select_2206 = equal_917_s4_q ? (equal_1810_s4_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2208;
  assign select_2208 = equal_374_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2206);
  logic [19:0] select_2211;
  assign select_2211 = equal_917_s4_q ? (equal_1810_s4_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [19:0] select_2213;
  assign select_2213 = equal_374_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2211);
  logic [23:0] select_2236;
  assign select_2236 = equal_917_s4_q ? (equal_1810_s4_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2238;
  assign select_2238 = equal_374_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2236);
  logic [23:0] select_2241;
  assign select_2241 = equal_917_s4_q ? (equal_1810_s4_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2243;
  assign select_2243 = equal_374_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2241);
  logic [23:0] select_2246;
  assign select_2246 = equal_917_s4_q ? (equal_1810_s4_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2248;
  assign select_2248 = equal_374_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2246);
  logic [23:0] select_2251;
  assign select_2251 = equal_917_s4_q ? (equal_1810_s4_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2253;
  assign select_2253 = equal_374_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2251);
  logic [5:0] select_2260;
  assign select_2260 = begins_product_q ? 6'h0 : (equal_917_s4_q ? (equal_918_s4_q ? 6'h0 : x_s4_q) : 6'h0);
  logic [11:0] select_2265;
  assign select_2265 = begins_product_q ? 12'h0 : (equal_917_s4_q ? (equal_918_s4_q ? 12'h0 : select_1426) : 12'h0);
  logic [11:0] select_2270;
  assign select_2270 = begins_product_q ? 12'h0 : (equal_917_s4_q ? (equal_918_s4_q ? 12'h0 : select_1429) : 12'h0);
  // hls/stages/agreement.hpp:654
  logic [11:0] select_2274;
  assign select_2274 = equal_918_s4_q ? 12'h0 : (less_1425 ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:317
  logic [11:0] select_2276;
  assign select_2276 = begins_product_q ? 12'h0 : (equal_917_s4_q ? select_2274 : 12'h0);

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_353_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_461, and_437_s4_q, and_436_s4_q, and_411_s4_q, less_403_s4_q, less_402_s4_q, less_401_s4_q, less_400_s4_q, less_399_s4_q, less_398_s4_q, less_397_s4_q, less_396_s4_q, less_395_s4_q, less_394_s4_q, less_393_s4_q, less_392_s4_q, less_391_s4_q, less_390_s4_q, less_389_s4_q, less_388_s4_q, less_387_s4_q, less_386_s4_q, less_385_s4_q, less_384_s4_q, less_383_s4_q, less_382_s4_q, less_381_s4_q, less_380_s4_q};
  end
`ifndef SYNTHESIS
  logic [5:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [5:0] fresh_raddr_s2_sim;
  logic fresh_re_s2_sim;
  logic [5:0] fresh_raddr_s3_sim;
  logic fresh_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_re_s1_sim <= 1'b0;
      fresh_re_s2_sim <= 1'b0;
      fresh_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s1_sim <= fresh_re;
      fresh_raddr_s1_sim <= fresh_raddr;
      fresh_re_s2_sim <= fresh_re_s1_sim;
      fresh_raddr_s2_sim <= fresh_raddr_s1_sim;
      fresh_re_s3_sim <= fresh_re_s2_sim;
      fresh_raddr_s3_sim <= fresh_raddr_s2_sim;
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
      if (fresh_waddr >= 6'd47) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 6'd47) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s4_2_q;
  logic best_left_we;
  assign best_left_we = s4_en & and_885_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_884, select_836_s4_q, select_832_s4_q};
  end
`ifndef SYNTHESIS
  logic [5:0] best_left_raddr_s2_sim;
  logic best_left_re_s2_sim;
  logic [5:0] best_left_raddr_s3_sim;
  logic best_left_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s2_sim <= 1'b0;
      best_left_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s2_sim <= best_left_re;
      best_left_raddr_s2_sim <= best_left_raddr;
      best_left_re_s3_sim <= best_left_re_s2_sim;
      best_left_raddr_s3_sim <= best_left_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
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

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s4_q, or_910_s4_q, or_907_s4_q, or_904_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_958_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_955, sum_944, sum_933};
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
  assign map_waddr = sum_997_s4_q;
  logic map_we;
  assign map_we = s4_en & and_1062_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1051, is_seen};
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
    end else if (s4_en) begin
      census_left_misses_q <= select_1216;
      sharpness_sums_detail_0_q <= and_353_s4_q ? select_1236 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_353_s4_q ? select_1247 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_353_s4_q ? sum_1251 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_353_s4_q ? sum_1255 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1399;
      counts_textured_q <= and_1392_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_1402});
      counts_explained_q <= and_1392_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_1407});
      counts_nearer_q <= and_1392_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1412});
      counts_unproven_q <= and_1392_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1422});
      counts_regions_bad_q <= select_1440;
      counts_too_many_bad_q <= select_1455;
      counts_too_much_unproven_q <= and_1392_s4_q ? 24'h0 : sum_1467;
      counts_too_much_unseen_skin_q <= and_1392_s4_q ? 24'h0 : sum_1476;
      registration_counts_across_0_q <= and_1392_s4_q ? 20'h0 : sum_1538;
      registration_counts_across_1_q <= and_1392_s4_q ? 20'h0 : sum_1548;
      registration_counts_across_2_q <= and_1392_s4_q ? 20'h0 : sum_1557;
      registration_counts_across_3_q <= and_1392_s4_q ? 20'h0 : sum_1565;
      segment_textured_q <= select_930 + {5'h0, and_1402};
      segment_explained_q <= select_941 + {5'h0, and_1407};
      segment_nearer_q <= select_952 + {5'h0, and_1412};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_372_s4_q ? good_q : select_1827;
      good_next_q <= select_1832;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1856;
      addend_1_q <= select_1857;
      multiplier_0_q <= select_1858;
      multiplier_1_q <= select_1859;
      proven_q <= and_981_s4_q ? select_1950 : proven_q;
      seen_q <= select_2011;
      nearer_q <= select_2017;
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
      averager_quarter_1_0_q <= select_1091;
      averager_quarter_1_1_q <= select_1093;
      averager_quarter_2_0_q <= select_1095;
      averager_quarter_2_1_q <= select_1097;
      averager_detail_0_q <= select_1109;
      averager_detail_1_q <= select_1117;
      census_changes_values_0_left_q <= and_353_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_353_s4_q ? sum_1200_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1202;
      census_changes_values_1_right_q <= select_1203;
      census_changes_values_2_left_q <= select_1204;
      census_changes_values_2_right_q <= select_1205;
      sharpness_last_mask_q <= and_353_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_353_s4_q ? select_1221[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_353_s4_q ? select_1221[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_1862;
      box_textured_columns_values_1_q <= select_1865;
      box_textured_columns_values_2_q <= select_1868;
      box_textured_columns_values_3_q <= select_1871;
      box_textured_columns_values_4_q <= select_1874;
      box_textured_sum_sums_values_0_q <= equal_372_s4_q ? box_textured_sum_sums_values_0_q : select_1876;
      box_explained_columns_values_0_q <= select_1880;
      box_explained_columns_values_1_q <= select_1883;
      box_explained_columns_values_2_q <= select_1886;
      box_explained_columns_values_3_q <= select_1889;
      box_explained_columns_values_4_q <= select_1892;
      box_explained_sum_sums_values_0_q <= equal_372_s4_q ? box_explained_sum_sums_values_0_q : select_1894;
      box_nearer_columns_values_0_q <= select_1898;
      box_nearer_columns_values_1_q <= select_1901;
      box_nearer_columns_values_2_q <= select_1904;
      box_nearer_columns_values_3_q <= select_1907;
      box_nearer_columns_values_4_q <= select_1910;
      box_nearer_sum_sums_values_0_q <= equal_372_s4_q ? box_nearer_sum_sums_values_0_q : select_1912;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_1955_s5_q;
  logic or_2019_s5_q;
  logic and_2020_s5_q;
  logic [13:0] select_2025_s5_q;
  logic [13:0] select_2030_s5_q;
  logic [13:0] select_2035_s5_q;
  logic [13:0] select_2040_s5_q;
  logic [13:0] select_2045_s5_q;
  logic [13:0] select_2050_s5_q;
  logic and_2057_s5_q;
  logic and_2064_s5_q;
  logic and_2078_s5_q;
  logic and_2160_s5_q;
  logic and_2173_s5_q;
  logic and_2183_s5_q;
  logic and_2194_s5_q;
  logic [19:0] select_2199_s5_q;
  logic [19:0] select_2204_s5_q;
  logic [19:0] select_2209_s5_q;
  logic [19:0] select_2214_s5_q;
  logic [11:0] select_2219_s5_q;
  logic [11:0] select_2224_s5_q;
  logic [11:0] select_2229_s5_q;
  logic [11:0] select_2234_s5_q;
  logic [23:0] select_2239_s5_q;
  logic [23:0] select_2244_s5_q;
  logic [23:0] select_2249_s5_q;
  logic [23:0] select_2254_s5_q;
  logic and_2257_s5_q;
  logic [5:0] select_2262_s5_q;
  logic [11:0] select_2267_s5_q;
  logic [11:0] select_2272_s5_q;
  logic [11:0] select_2278_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_1955_s5_q <= said_q;
      or_2019_s5_q <= not_2018 | select_2011;
      and_2020_s5_q <= cfg_prove_i & select_2017;
      select_2025_s5_q <= equal_372_s4_q ? 14'h0 : select_2024;
      select_2030_s5_q <= equal_372_s4_q ? 14'h0 : select_2029;
      select_2035_s5_q <= equal_372_s4_q ? 14'h0 : select_2034;
      select_2040_s5_q <= equal_372_s4_q ? 14'h0 : select_2039;
      select_2045_s5_q <= equal_372_s4_q ? 14'h0 : select_2044;
      select_2050_s5_q <= equal_372_s4_q ? 14'h0 : select_2049;
      and_2057_s5_q <= not_373_s4_q & (not_518_s4_q & and_2055);
      and_2064_s5_q <= not_373_s4_q & (not_518_s4_q & and_2062);
      and_2078_s5_q <= not_373_s4_q & (not_518_s4_q & and_2076);
      and_2160_s5_q <= not_373_s4_q & (not_518_s4_q & and_2158);
      and_2173_s5_q <= not_373_s4_q & (not_518_s4_q & and_2171);
      and_2183_s5_q <= not_373_s4_q & (not_518_s4_q & and_2181);
      and_2194_s5_q <= and_2194_s4_q;
      select_2199_s5_q <= equal_372_s4_q ? 20'h0 : select_2198;
      select_2204_s5_q <= equal_372_s4_q ? 20'h0 : select_2203;
      select_2209_s5_q <= equal_372_s4_q ? 20'h0 : select_2208;
      select_2214_s5_q <= equal_372_s4_q ? 20'h0 : select_2213;
      select_2219_s5_q <= select_2219_s4_q;
      select_2224_s5_q <= select_2224_s4_q;
      select_2229_s5_q <= select_2229_s4_q;
      select_2234_s5_q <= select_2234_s4_q;
      select_2239_s5_q <= equal_372_s4_q ? 24'h0 : select_2238;
      select_2244_s5_q <= equal_372_s4_q ? 24'h0 : select_2243;
      select_2249_s5_q <= equal_372_s4_q ? 24'h0 : select_2248;
      select_2254_s5_q <= equal_372_s4_q ? 24'h0 : select_2253;
      and_2257_s5_q <= and_2257_s4_q;
      select_2262_s5_q <= equal_372_s4_q ? 6'h0 : (equal_374_s4_q ? 6'h0 : select_2260);
      select_2267_s5_q <= equal_372_s4_q ? 12'h0 : (equal_374_s4_q ? 12'h0 : select_2265);
      select_2272_s5_q <= equal_372_s4_q ? 12'h0 : (equal_374_s4_q ? 12'h0 : select_2270);
      select_2278_s5_q <= equal_372_s4_q ? 12'h0 : (equal_374_s4_q ? 12'h0 : select_2276);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_2019_s5_q;
  assign marks_nearer_o = and_2020_s5_q;
  assign verdict_valid_o = and_1955_s5_q;
  assign verdict_supervised_o = {2'h0, select_2025_s5_q};
  assign verdict_textured_o = {2'h0, select_2030_s5_q};
  assign verdict_explained_o = {2'h0, select_2035_s5_q};
  assign verdict_nearer_o = {2'h0, select_2040_s5_q};
  assign verdict_unproven_o = {2'h0, select_2045_s5_q};
  assign verdict_regions_bad_o = {2'h0, select_2050_s5_q};
  assign verdict_unproven_yet_o = and_2057_s5_q;
  assign verdict_untextured_o = and_2064_s5_q;
  assign verdict_disagree_o = and_2078_s5_q;
  assign verdict_moved_o = and_2160_s5_q;
  assign verdict_unsharp_left_o = and_2173_s5_q;
  assign verdict_unsharp_right_o = and_2183_s5_q;
  assign verdict_hidden_o = and_2194_s5_q;
  assign verdict_across_0_o = select_2199_s5_q;
  assign verdict_across_1_o = select_2204_s5_q;
  assign verdict_across_2_o = select_2209_s5_q;
  assign verdict_across_3_o = select_2214_s5_q;
  assign verdict_measured_0_o = select_2219_s5_q;
  assign verdict_measured_1_o = select_2224_s5_q;
  assign verdict_measured_2_o = select_2229_s5_q;
  assign verdict_measured_3_o = select_2234_s5_q;
  assign verdict_detail_0_o = select_2239_s5_q;
  assign verdict_detail_1_o = select_2244_s5_q;
  assign verdict_contrast_0_o = select_2249_s5_q;
  assign verdict_contrast_1_o = select_2254_s5_q;
  assign region_valid_o = and_2257_s5_q;
  assign region_region_o = select_2262_s5_q;
  assign region_textured_o = select_2267_s5_q;
  assign region_explained_o = select_2272_s5_q;
  assign region_nearer_o = select_2278_s5_q;
  assign valid_o = valid_s5_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{right[1:0], left[1:0], sum_2081[2:0], sum_1520[0], sum_1516[0], sum_1508[1:0], sum_1507[1:0], sum_1503[0], detail_4[1:0], detail_3[1:0], sum_1210[4:0], sum_877[8:0], sum_459[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
