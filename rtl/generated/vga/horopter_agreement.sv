// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2537 bits, pipeline 1152 bits, memories 66448 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[9:3]} + 8'hff;
  logic [3:0] sum_1317;
  assign sum_1317 = {1'b0, cfg_width_i[9:7]} + 4'hf;
  logic [6:0] sum_1321;
  assign sum_1321 = {1'b0, cfg_width_i[9:4]} + 7'h7;
  logic [5:0] sum_1336;
  assign sum_1336 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_1773;
  assign difference_1773 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_1940;
  assign less_1940 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_1941;
  assign sum_1941 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_1959;
  assign not_1959 = ~cfg_prove_i;

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
  logic [2:0] select_312;
  assign select_312 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_314;
  assign select_314 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [8:0] select_317;
  assign select_317 = ({select_314, select_312} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:95
  logic [8:0] select_318;
  assign select_318 = select_312[0] ? averager_place_q : select_317;
  // hls/stages/census.hpp:40
  logic or_319;
  assign or_319 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:181
  logic and_325;
  assign and_325 = (~((~or_319) | (~select_312[0]))) & (select_318[8:6] < 3'h5);
  // hls/stages/census.hpp:40
  logic [2:0] select_330;
  assign select_330 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:181
  logic whole;
  assign whole = select_312[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:183
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_314 : 7'h0;
  // hls/stages/census.hpp:45
  logic equal_347;
  assign equal_347 = select_312 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_348;
  assign equal_348 = select_330 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_349;
  assign and_349 = equal_348 & and_325;
  // hls/stages/agreement.hpp:183
  logic and_351;
  assign and_351 = sample_pair_whole_q & (equal_347 & and_349);
  // hls/stages/agreement.hpp:352
  logic equal_370;
  assign equal_370 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:339
  logic not_371;
  assign not_371 = ~equal_370;
  // hls/stages/agreement.hpp:352
  logic equal_372;
  assign equal_372 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:410
  logic less_373;
  assign less_373 = run_highest_q < x_q;
  // hls/stages/agreement.hpp:414
  logic not_374;
  assign not_374 = ~less_373;
  // hls/stages/agreement.hpp:317
  logic and_375;
  assign and_375 = equal_372 & not_374;
  logic and_376;
  assign and_376 = not_371 & and_375;
  // hls/stages/census.hpp:40
  logic [5:0] select_403;
  assign select_403 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:183
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_403 : 6'h0;
  // hls/stages/agreement.hpp:675
  logic drew;
  assign drew = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:317
  logic and_461;
  assign and_461 = drew & not_374;
  logic [6:0] select_491;
  assign select_491 = equal_370 ? ({run_shift_q[5], run_shift_q} + x_q[6:0]) : x_q[6:0];
  // hls/stages/agreement.hpp:429
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:623
  logic [6:0] sum_1051;
  assign sum_1051 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:183
  logic [2:0] select_1062;
  assign select_1062 = sample_pair_whole_q ? (sample_last_q ? (select_330 + 3'h1) : select_330) : raster_at_y_q;
  logic [6:0] select_1064;
  assign select_1064 = sample_pair_whole_q ? (select_314 + {6'h0, equal_347}) : raster_at_column_q;
  logic [5:0] select_1067;
  assign select_1067 = sample_pair_whole_q ? (sample_last_q ? (select_403 + {5'h0, equal_348}) : select_403) : raster_at_row_q;
  logic select_1071;
  assign select_1071 = sample_pair_whole_q ? (sample_last_q ? (or_319 & (~raster_final_row_q)) : or_319) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_1073;
  assign select_1073 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:183
  logic select_1077;
  assign select_1077 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:263
  logic equal_1249;
  assign equal_1249 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:179
  logic [2:0] select_1250;
  assign select_1250 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1253;
  assign select_1253 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1256;
  assign select_1256 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1259;
  assign select_1259 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1262;
  assign select_1262 = ends_q ? following_shift_q : run_shift_q;
  logic select_1265;
  assign select_1265 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:264
  logic not_1266;
  assign not_1266 = ~equal_1249;
  // hls/stages/agreement.hpp:344
  logic not_1269;
  assign not_1269 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:352
  logic equal_1270;
  assign equal_1270 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:155
  logic or_1271;
  assign or_1271 = equal_1270 | equal_372;
  logic [2:0] select_1272;
  assign select_1272 = equal_370 ? {run_last_shift_q, {2{not_1269}}} : {1'b0, or_1271, equal_372};
  logic [7:0] select_1275;
  assign select_1275 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1276;
  assign select_1276 = equal_372 ? least_q : 7'h0;
  logic [7:0] select_1280;
  assign select_1280 = run_last_shift_q ? {1'b0, last_q} : (run_shift_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1282;
  assign select_1282 = equal_372 ? last_q : (equal_1270 ? last_q : 7'h0);
  logic [7:0] select_1288;
  assign select_1288 = equal_370 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_372 ? first_beats_q : (equal_1270 ? whole_beats_q : 8'h0));
  logic [5:0] select_1293;
  assign select_1293 = equal_370 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_372 ? (6'h0 - least_q[5:0]) : 6'h0);
  // hls/stages/agreement.hpp:138
  logic not_1295;
  assign not_1295 = ~drew;
  // hls/stages/agreement.hpp:155
  logic select_1299;
  assign select_1299 = equal_370 ? (next_last_shift_q & not_1269) : (equal_372 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:179
  logic [7:0] select_1302;
  assign select_1302 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1306;
  assign select_1306 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:270
  logic less_1313;
  assign less_1313 = 6'he < column[6:1];
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1316;
  assign select_1316 = and_351 ? (equal_1249 ? (less_1313 ? 7'h1e : column) : least_q) : least_q;
  // hls/stages/agreement.hpp:264
  logic [7:0] select_1319;
  assign select_1319 = equal_1249 ? (less_1313 ? {sum_1317, cfg_width_i[6:3]} : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:184
  logic [7:0] select_1323;
  assign select_1323 = and_351 ? (equal_1249 ? {sum_1321, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:320
  logic not_1324;
  assign not_1324 = ~ends_q;
  // hls/stages/agreement.hpp:179
  logic [5:0] select_1325;
  assign select_1325 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1327;
  assign select_1327 = and_351 ? (equal_1249 ? 7'h0 : {select_1325, not_1324}) : {select_1325, not_1324};
  // hls/stages/agreement.hpp:179
  logic and_1329;
  assign and_1329 = not_1324 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:280
  logic [6:0] sum_1332;
  assign sum_1332 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:264
  logic select_1334;
  assign select_1334 = equal_1249 ? ({sum_1332[6], cfg_height_i[8:3]} == {1'b0, sum_1332[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:538
  logic [5:0] sum_1479;
  assign sum_1479 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:148
  logic not_1835;
  assign not_1835 = ~run_shift_q[5];

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:802; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_376;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:803; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (equal_370 ? not_374 : (equal_372 ? not_374 : and_461));
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:804; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_491;
  logic right_codes_re;
  assign right_codes_re = s0_en & (equal_370 ? not_374 : and_375);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

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
      raster_at_x_q <= sample_pair_whole_q ? (select_312 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_1062;
      raster_at_column_q <= select_1064;
      raster_at_row_q <= select_1067;
      raster_at_live_q <= select_1071;
      raster_rows_left_q <= sample_pair_whole_q ? select_1073 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_1077;
      averager_place_q <= sample_pair_whole_q ? select_318 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= and_351 ? (equal_1249 ? 3'h1 : select_1250) : select_1250;
      run_lowest_q <= and_351 ? (equal_1249 ? 8'h0 : select_1253) : select_1253;
      run_highest_q <= and_351 ? (equal_1249 ? 8'h0 : select_1256) : select_1256;
      run_beats_q <= and_351 ? (equal_1249 ? 8'hc : select_1259) : select_1259;
      run_shift_q <= and_351 ? (equal_1249 ? 6'h0 : select_1262) : select_1262;
      run_last_shift_q <= and_351 ? (select_1265 & not_1266) : select_1265;
      following_phase_q <= drew ? {final_row_q, 1'b0, final_row_q} : select_1272;
      following_lowest_q <= drew ? 8'h0 : (equal_370 ? select_1275 : {1'b0, select_1276});
      following_highest_q <= drew ? 8'h0 : (equal_370 ? select_1280 : {1'b0, select_1282});
      following_beats_q <= drew ? 8'h3f : select_1288;
      following_shift_q <= drew ? 6'h0 : select_1293;
      following_last_shift_q <= not_1295 & select_1299;
      x_q <= and_351 ? (equal_1249 ? 8'h0 : select_1302) : select_1302;
      beats_left_q <= and_351 ? (equal_1249 ? 8'hc : select_1306) : select_1306;
      last_q <= and_351 ? (equal_1249 ? column : last_q) : last_q;
      least_q <= select_1316;
      first_beats_q <= and_351 ? select_1319 : first_beats_q;
      whole_beats_q <= select_1323;
      age_q <= select_1327;
      ends_q <= and_351 ? (and_1329 & not_1266) : and_1329;
      final_row_q <= and_351 ? select_1334 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1835}}, 1'b1} + run_beats_q;
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
  logic select_312_s1_q;
  logic [8:0] select_318_s1_q;
  logic and_325_s1_q;
  logic equal_331_s1_q;
  logic whole_s1_q;
  logic [6:0] column_s1_q;
  logic and_349_s1_q;
  logic and_351_s1_q;
  logic equal_354_s1_q;
  logic equal_370_s1_q;
  logic not_371_s1_q;
  logic equal_372_s1_q;
  logic less_373_s1_q;
  logic not_374_s1_q;
  logic and_376_s1_q;
  logic [5:0] row_s1_q;
  logic drew_s1_q;
  logic and_461_s1_q;
  logic [6:0] x_s1_2_q;
  logic and_515_s1_q;
  logic equal_521_s1_q;
  logic equal_588_s1_q;
  logic equal_825_s1_q;
  logic equal_889_s1_q;
  logic equal_912_s1_q;
  logic equal_915_s1_q;
  logic not_1053_s1_q;
  logic equal_1249_s1_q;
  logic not_1295_s1_q;
  logic less_1480_s1_q;
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
      select_312_s1_q <= select_312[0];
      select_318_s1_q <= select_318;
      and_325_s1_q <= and_325;
      equal_331_s1_q <= select_330 == 3'h0;
      whole_s1_q <= whole;
      column_s1_q <= column;
      and_349_s1_q <= and_349;
      and_351_s1_q <= and_351;
      equal_354_s1_q <= select_312 == 3'h1;
      equal_370_s1_q <= equal_370;
      not_371_s1_q <= not_371;
      equal_372_s1_q <= equal_372;
      less_373_s1_q <= less_373;
      not_374_s1_q <= not_374;
      and_376_s1_q <= and_376;
      row_s1_q <= row;
      drew_s1_q <= drew;
      and_461_s1_q <= and_461;
      x_s1_2_q <= x[6:0];
      and_515_s1_q <= age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q}));
      equal_521_s1_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_588_s1_q <= run_lowest_q == x_q;
      equal_825_s1_q <= run_lowest_q == x;
      equal_889_s1_q <= run_highest_q == x;
      equal_912_s1_q <= x_q == {1'b0, last_q};
      equal_915_s1_q <= run_phase_q == 3'h5;
      not_1053_s1_q <= ~({sum_1051, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1249_s1_q <= equal_1249;
      not_1295_s1_q <= not_1295;
      less_1480_s1_q <= {1'b0, sum_1479, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/census.hpp:98
  logic and_326;
  assign and_326 = sample_pair_whole_s1_q & and_325_s1_q;
  // hls/stages/agreement.hpp:385
  logic equal_465;
  assign equal_465 = row_q == 6'h0;
  logic [11:0] select_466;
  assign select_466 = equal_465 ? 12'h0 : left_rdata_q[11:0];
  logic not_467;
  assign not_467 = ~equal_465;
  logic and_468;
  assign and_468 = left_rdata_q[12] & not_467;
  logic and_469;
  assign and_469 = left_rdata_q[13] & not_467;
  logic and_470;
  assign and_470 = left_rdata_q[14] & not_467;
  logic and_471;
  assign and_471 = left_rdata_q[15] & not_467;
  logic equal_472;
  assign equal_472 = row_q[5:1] == 5'h0;
  logic [11:0] select_473;
  assign select_473 = equal_472 ? 12'h0 : left_rdata_q[27:16];
  logic not_474;
  assign not_474 = ~equal_472;
  logic and_475;
  assign and_475 = left_rdata_q[28] & not_474;
  logic and_476;
  assign and_476 = left_rdata_q[29] & not_474;
  logic and_477;
  assign and_477 = left_rdata_q[30] & not_474;
  logic and_478;
  assign and_478 = left_rdata_q[31] & not_474;
  logic less_479;
  assign less_479 = row_q < 6'h3;
  logic [11:0] select_480;
  assign select_480 = less_479 ? 12'h0 : left_rdata_q[43:32];
  logic not_481;
  assign not_481 = ~less_479;
  logic and_482;
  assign and_482 = left_rdata_q[44] & not_481;
  logic and_483;
  assign and_483 = left_rdata_q[45] & not_481;
  logic and_484;
  assign and_484 = left_rdata_q[46] & not_481;
  logic and_485;
  assign and_485 = left_rdata_q[47] & not_481;
  logic equal_486;
  assign equal_486 = row_q[5:2] == 4'h0;
  logic [11:0] select_487;
  assign select_487 = equal_486 ? 12'h0 : left_rdata_q[59:48];
  logic not_488;
  assign not_488 = ~equal_486;
  logic and_489;
  assign and_489 = left_rdata_q[60] & not_488;
  // hls/stages/agreement.hpp:386
  logic [11:0] select_494;
  assign select_494 = equal_465 ? 12'h0 : right_codes_rdata_q[11:0];
  logic and_495;
  assign and_495 = right_codes_rdata_q[12] & not_467;
  logic [11:0] select_496;
  assign select_496 = equal_472 ? 12'h0 : right_codes_rdata_q[24:13];
  logic and_497;
  assign and_497 = right_codes_rdata_q[25] & not_474;
  logic [11:0] select_498;
  assign select_498 = less_479 ? 12'h0 : right_codes_rdata_q[37:26];
  logic and_499;
  assign and_499 = right_codes_rdata_q[38] & not_481;
  logic [11:0] select_500;
  assign select_500 = equal_486 ? 12'h0 : right_codes_rdata_q[50:39];
  logic and_501;
  assign and_501 = right_codes_rdata_q[51] & not_488;
  logic less_502;
  assign less_502 = row_q < 6'h5;
  logic [11:0] select_503;
  assign select_503 = less_502 ? 12'h0 : right_codes_rdata_q[63:52];
  logic and_505;
  assign and_505 = right_codes_rdata_q[64] & (~less_502);
  logic less_506;
  assign less_506 = row_q[5:1] < 5'h3;
  logic [11:0] select_507;
  assign select_507 = less_506 ? 12'h0 : right_codes_rdata_q[76:65];
  logic and_509;
  assign and_509 = right_codes_rdata_q[77] & (~less_506);
  // hls/stages/agreement.hpp:337
  logic not_516;
  assign not_516 = ~equal_372_s1_q;
  // hls/stages/agreement.hpp:317
  logic and_517;
  assign and_517 = not_516 & and_461_s1_q;
  logic select_518;
  assign select_518 = equal_370_s1_q ? and_515_s1_q : and_517;
  // hls/stages/agreement.hpp:167
  logic and_527;
  assign and_527 = left_rdata_q[44] & not_374_s1_q;
  logic [11:0] a;
  assign a = less_373_s1_q ? 12'h0 : left_rdata_q[43:32];
  logic [11:0] b;
  assign b = less_373_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_533;
  assign not_533 = ~(a ^ b);
  logic [1:0] sum_535;
  assign sum_535 = {1'b0, not_533[2]} + ({1'b0, not_533[0]} + {1'b0, not_533[1]});
  logic [2:0] sum_538;
  assign sum_538 = {2'h0, not_533[5]} + ({2'h0, not_533[4]} + ({2'h0, not_533[3]} + {1'b0, sum_535}));
  logic [2:0] sum_539;
  assign sum_539 = {2'h0, not_533[6]} + sum_538;
  logic [3:0] sum_542;
  assign sum_542 = {3'h0, not_533[9]} + ({3'h0, not_533[8]} + ({3'h0, not_533[7]} + {1'b0, sum_539}));
  // hls/stages/agreement.hpp:167
  logic [11:0] a_2;
  assign a_2 = less_373_s1_q ? 12'h0 : left_rdata_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_373_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_552;
  assign not_552 = ~(a_2 ^ b_2);
  logic [1:0] sum_554;
  assign sum_554 = {1'b0, not_552[2]} + ({1'b0, not_552[0]} + {1'b0, not_552[1]});
  logic [2:0] sum_557;
  assign sum_557 = {2'h0, not_552[5]} + ({2'h0, not_552[4]} + ({2'h0, not_552[3]} + {1'b0, sum_554}));
  logic [2:0] sum_558;
  assign sum_558 = {2'h0, not_552[6]} + sum_557;
  logic [3:0] sum_561;
  assign sum_561 = {3'h0, not_552[9]} + ({3'h0, not_552[8]} + ({3'h0, not_552[7]} + {1'b0, sum_558}));
  // hls/stages/agreement.hpp:167
  logic and_566;
  assign and_566 = left_rdata_q[76] & not_374_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_373_s1_q ? 12'h0 : left_rdata_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_373_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_572;
  assign not_572 = ~(a_3 ^ b_3);
  logic [1:0] sum_574;
  assign sum_574 = {1'b0, not_572[2]} + ({1'b0, not_572[0]} + {1'b0, not_572[1]});
  logic [2:0] sum_577;
  assign sum_577 = {2'h0, not_572[5]} + ({2'h0, not_572[4]} + ({2'h0, not_572[3]} + {1'b0, sum_574}));
  logic [2:0] sum_578;
  assign sum_578 = {2'h0, not_572[6]} + sum_577;
  logic [3:0] sum_581;
  assign sum_581 = {3'h0, not_572[9]} + ({3'h0, not_572[8]} + ({3'h0, not_572[7]} + {1'b0, sum_578}));
  logic [11:0] not_593;
  assign not_593 = ~(a ^ b_2);
  logic [1:0] sum_595;
  assign sum_595 = {1'b0, not_593[2]} + ({1'b0, not_593[0]} + {1'b0, not_593[1]});
  logic [2:0] sum_598;
  assign sum_598 = {2'h0, not_593[5]} + ({2'h0, not_593[4]} + ({2'h0, not_593[3]} + {1'b0, sum_595}));
  logic [2:0] sum_599;
  assign sum_599 = {2'h0, not_593[6]} + sum_598;
  logic [3:0] sum_602;
  assign sum_602 = {3'h0, not_593[9]} + ({3'h0, not_593[8]} + ({3'h0, not_593[7]} + {1'b0, sum_599}));
  logic [11:0] not_608;
  assign not_608 = ~(a_2 ^ b_3);
  logic [1:0] sum_610;
  assign sum_610 = {1'b0, not_608[2]} + ({1'b0, not_608[0]} + {1'b0, not_608[1]});
  logic [2:0] sum_613;
  assign sum_613 = {2'h0, not_608[5]} + ({2'h0, not_608[4]} + ({2'h0, not_608[3]} + {1'b0, sum_610}));
  logic [2:0] sum_614;
  assign sum_614 = {2'h0, not_608[6]} + sum_613;
  logic [3:0] sum_617;
  assign sum_617 = {3'h0, not_608[9]} + ({3'h0, not_608[8]} + ({3'h0, not_608[7]} + {1'b0, sum_614}));
  // hls/stages/agreement.hpp:167
  logic [11:0] b_4;
  assign b_4 = less_373_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_626;
  assign not_626 = ~(a_3 ^ b_4);
  logic [1:0] sum_628;
  assign sum_628 = {1'b0, not_626[2]} + ({1'b0, not_626[0]} + {1'b0, not_626[1]});
  logic [2:0] sum_631;
  assign sum_631 = {2'h0, not_626[5]} + ({2'h0, not_626[4]} + ({2'h0, not_626[3]} + {1'b0, sum_628}));
  logic [2:0] sum_632;
  assign sum_632 = {2'h0, not_626[6]} + sum_631;
  logic [3:0] sum_635;
  assign sum_635 = {3'h0, not_626[9]} + ({3'h0, not_626[8]} + ({3'h0, not_626[7]} + {1'b0, sum_632}));
  // hls/stages/agreement.hpp:167
  logic [11:0] b_5;
  assign b_5 = less_373_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_650;
  assign not_650 = ~(a ^ b_5);
  logic [1:0] sum_652;
  assign sum_652 = {1'b0, not_650[2]} + ({1'b0, not_650[0]} + {1'b0, not_650[1]});
  logic [2:0] sum_655;
  assign sum_655 = {2'h0, not_650[5]} + ({2'h0, not_650[4]} + ({2'h0, not_650[3]} + {1'b0, sum_652}));
  logic [2:0] sum_656;
  assign sum_656 = {2'h0, not_650[6]} + sum_655;
  logic [3:0] sum_659;
  assign sum_659 = {3'h0, not_650[9]} + ({3'h0, not_650[8]} + ({3'h0, not_650[7]} + {1'b0, sum_656}));
  logic [11:0] not_665;
  assign not_665 = ~(a_2 ^ b);
  logic [1:0] sum_667;
  assign sum_667 = {1'b0, not_665[2]} + ({1'b0, not_665[0]} + {1'b0, not_665[1]});
  logic [2:0] sum_670;
  assign sum_670 = {2'h0, not_665[5]} + ({2'h0, not_665[4]} + ({2'h0, not_665[3]} + {1'b0, sum_667}));
  logic [2:0] sum_671;
  assign sum_671 = {2'h0, not_665[6]} + sum_670;
  logic [3:0] sum_674;
  assign sum_674 = {3'h0, not_665[9]} + ({3'h0, not_665[8]} + ({3'h0, not_665[7]} + {1'b0, sum_671}));
  logic [11:0] not_681;
  assign not_681 = ~(a_3 ^ b_2);
  logic [1:0] sum_683;
  assign sum_683 = {1'b0, not_681[2]} + ({1'b0, not_681[0]} + {1'b0, not_681[1]});
  logic [2:0] sum_686;
  assign sum_686 = {2'h0, not_681[5]} + ({2'h0, not_681[4]} + ({2'h0, not_681[3]} + {1'b0, sum_683}));
  logic [2:0] sum_687;
  assign sum_687 = {2'h0, not_681[6]} + sum_686;
  logic [3:0] sum_690;
  assign sum_690 = {3'h0, not_681[9]} + ({3'h0, not_681[8]} + ({3'h0, not_681[7]} + {1'b0, sum_687}));
  logic [11:0] not_705;
  assign not_705 = ~(a ^ b_3);
  logic [1:0] sum_707;
  assign sum_707 = {1'b0, not_705[2]} + ({1'b0, not_705[0]} + {1'b0, not_705[1]});
  logic [2:0] sum_710;
  assign sum_710 = {2'h0, not_705[5]} + ({2'h0, not_705[4]} + ({2'h0, not_705[3]} + {1'b0, sum_707}));
  logic [2:0] sum_711;
  assign sum_711 = {2'h0, not_705[6]} + sum_710;
  logic [3:0] sum_714;
  assign sum_714 = {3'h0, not_705[9]} + ({3'h0, not_705[8]} + ({3'h0, not_705[7]} + {1'b0, sum_711}));
  logic [11:0] not_720;
  assign not_720 = ~(a_2 ^ b_4);
  logic [1:0] sum_722;
  assign sum_722 = {1'b0, not_720[2]} + ({1'b0, not_720[0]} + {1'b0, not_720[1]});
  logic [2:0] sum_725;
  assign sum_725 = {2'h0, not_720[5]} + ({2'h0, not_720[4]} + ({2'h0, not_720[3]} + {1'b0, sum_722}));
  logic [2:0] sum_726;
  assign sum_726 = {2'h0, not_720[6]} + sum_725;
  logic [3:0] sum_729;
  assign sum_729 = {3'h0, not_720[9]} + ({3'h0, not_720[8]} + ({3'h0, not_720[7]} + {1'b0, sum_726}));
  // hls/stages/agreement.hpp:167
  logic [11:0] b_6;
  assign b_6 = less_373_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_738;
  assign not_738 = ~(a_3 ^ b_6);
  logic [1:0] sum_740;
  assign sum_740 = {1'b0, not_738[2]} + ({1'b0, not_738[0]} + {1'b0, not_738[1]});
  logic [2:0] sum_743;
  assign sum_743 = {2'h0, not_738[5]} + ({2'h0, not_738[4]} + ({2'h0, not_738[3]} + {1'b0, sum_740}));
  logic [2:0] sum_744;
  assign sum_744 = {2'h0, not_738[6]} + sum_743;
  logic [3:0] sum_747;
  assign sum_747 = {3'h0, not_738[9]} + ({3'h0, not_738[8]} + ({3'h0, not_738[7]} + {1'b0, sum_744}));
  // hls/stages/agreement.hpp:167
  logic [11:0] b_7;
  assign b_7 = less_373_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:395
  logic [11:0] not_767;
  assign not_767 = ~(a ^ b_7);
  logic [1:0] sum_769;
  assign sum_769 = {1'b0, not_767[2]} + ({1'b0, not_767[0]} + {1'b0, not_767[1]});
  logic [2:0] sum_772;
  assign sum_772 = {2'h0, not_767[5]} + ({2'h0, not_767[4]} + ({2'h0, not_767[3]} + {1'b0, sum_769}));
  logic [2:0] sum_773;
  assign sum_773 = {2'h0, not_767[6]} + sum_772;
  logic [3:0] sum_776;
  assign sum_776 = {3'h0, not_767[9]} + ({3'h0, not_767[8]} + ({3'h0, not_767[7]} + {1'b0, sum_773}));
  logic [11:0] not_782;
  assign not_782 = ~(a_2 ^ b_5);
  logic [1:0] sum_784;
  assign sum_784 = {1'b0, not_782[2]} + ({1'b0, not_782[0]} + {1'b0, not_782[1]});
  logic [2:0] sum_787;
  assign sum_787 = {2'h0, not_782[5]} + ({2'h0, not_782[4]} + ({2'h0, not_782[3]} + {1'b0, sum_784}));
  logic [2:0] sum_788;
  assign sum_788 = {2'h0, not_782[6]} + sum_787;
  logic [3:0] sum_791;
  assign sum_791 = {3'h0, not_782[9]} + ({3'h0, not_782[8]} + ({3'h0, not_782[7]} + {1'b0, sum_788}));
  logic [11:0] not_798;
  assign not_798 = ~(a_3 ^ b);
  logic [1:0] sum_800;
  assign sum_800 = {1'b0, not_798[2]} + ({1'b0, not_798[0]} + {1'b0, not_798[1]});
  logic [2:0] sum_803;
  assign sum_803 = {2'h0, not_798[5]} + ({2'h0, not_798[4]} + ({2'h0, not_798[3]} + {1'b0, sum_800}));
  logic [2:0] sum_804;
  assign sum_804 = {2'h0, not_798[6]} + sum_803;
  logic [3:0] sum_807;
  assign sum_807 = {3'h0, not_798[9]} + ({3'h0, not_798[8]} + ({3'h0, not_798[7]} + {1'b0, sum_804}));
  // hls/stages/agreement.hpp:529
  logic not_924;
  assign not_924 = ~(row_q[5:3] == 3'h0);
  // hls/stages/agreement.hpp:317
  logic and_1055;
  assign and_1055 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1053_s1_q);
  // hls/stages/agreement.hpp:260
  logic [5:0] or_1196;
  assign or_1196 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:264
  logic select_1339;
  assign select_1339 = equal_1249_s1_q ? (~({row_s1_q, 1'b0} < {sum_1336, cfg_height_i[3]})) : lower_half_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:146; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_318_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_326;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

  // Memory best_left, 80 x 22 and parity, DISTANCE 12, hls/stages/agreement.hpp:805; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [22:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 23'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = equal_370_s1_q ? x_s1_2_q : x_s1_q[6:0];
  logic best_left_re;
  assign best_left_re = s1_en & select_518;
  logic [22:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [21:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[21:0];
  logic best_left_read_q, best_left_error;
  always_ff @(posedge clk_i) best_left_read_q <= rst_ni & best_left_re;
  assign best_left_error = best_left_read_q & ^best_left_word_q;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s1_q[6:0];
  logic left_we;
  assign left_we = s1_en & and_376_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_489, select_487, and_485, and_484, and_483, and_482, select_480, and_478, and_477, and_476, and_475, select_473, and_471, and_470, and_469, and_468, select_466, fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_376_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_509, select_507, and_505, select_503, and_501, select_500, and_499, select_498, and_497, select_496, and_495, select_494, fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_351_s1_q ? (equal_1249_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_351_s1_q ? select_1339 : lower_half_q;
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
  logic select_312_s2_q;
  logic [8:0] select_318_s2_q;
  logic and_325_s2_q;
  logic and_326_s2_q;
  logic equal_331_s2_q;
  logic whole_s2_q;
  logic [6:0] column_s2_q;
  logic and_349_s2_q;
  logic and_351_s2_q;
  logic equal_354_s2_q;
  logic equal_370_s2_q;
  logic not_371_s2_q;
  logic equal_372_s2_q;
  logic less_373_s2_q;
  logic not_374_s2_q;
  logic equal_405_s2_q;
  logic drew_s2_q;
  logic left_rdata_s2_q;
  logic [6:0] x_s2_2_q;
  logic not_516_s2_q;
  logic select_518_s2_q;
  logic equal_521_s2_q;
  logic and_527_s2_q;
  logic and_528_s2_q;
  logic not_533_s2_q;
  logic [3:0] sum_543_s2_q;
  logic and_546_s2_q;
  logic and_547_s2_q;
  logic not_552_s2_q;
  logic [3:0] sum_562_s2_q;
  logic and_566_s2_q;
  logic and_567_s2_q;
  logic not_572_s2_q;
  logic [3:0] sum_582_s2_q;
  logic equal_588_s2_q;
  logic not_593_s2_q;
  logic [3:0] sum_603_s2_q;
  logic not_608_s2_q;
  logic [3:0] sum_618_s2_q;
  logic and_622_s2_q;
  logic not_626_s2_q;
  logic [3:0] sum_636_s2_q;
  logic and_646_s2_q;
  logic not_650_s2_q;
  logic [3:0] sum_660_s2_q;
  logic not_665_s2_q;
  logic [3:0] sum_675_s2_q;
  logic not_681_s2_q;
  logic [3:0] sum_691_s2_q;
  logic not_705_s2_q;
  logic [3:0] sum_715_s2_q;
  logic not_720_s2_q;
  logic [3:0] sum_730_s2_q;
  logic and_735_s2_q;
  logic not_738_s2_q;
  logic [3:0] sum_748_s2_q;
  logic and_764_s2_q;
  logic not_767_s2_q;
  logic [3:0] sum_777_s2_q;
  logic not_782_s2_q;
  logic [3:0] sum_792_s2_q;
  logic not_798_s2_q;
  logic [3:0] sum_808_s2_q;
  logic equal_825_s2_q;
  logic and_883_s2_q;
  logic equal_889_s2_q;
  logic equal_912_s2_q;
  logic equal_915_s2_q;
  logic and_926_s2_q;
  logic and_957_s2_q;
  logic and_1057_s2_q;
  logic equal_1197_s2_q;
  logic equal_1249_s2_q;
  logic not_1295_s2_q;
  logic and_1383_s2_q;
  logic less_1477_s2_q;
  logic less_1480_s2_q;
  logic equal_1742_s2_q;
  logic less_1753_s2_q;
  logic equal_1918_s2_q;
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
      select_312_s2_q <= select_312_s1_q;
      select_318_s2_q <= select_318_s1_q;
      and_325_s2_q <= and_325_s1_q;
      and_326_s2_q <= and_326;
      equal_331_s2_q <= equal_331_s1_q;
      whole_s2_q <= whole_s1_q;
      column_s2_q <= column_s1_q;
      and_349_s2_q <= and_349_s1_q;
      and_351_s2_q <= and_351_s1_q;
      equal_354_s2_q <= equal_354_s1_q;
      equal_370_s2_q <= equal_370_s1_q;
      not_371_s2_q <= not_371_s1_q;
      equal_372_s2_q <= equal_372_s1_q;
      less_373_s2_q <= less_373_s1_q;
      not_374_s2_q <= not_374_s1_q;
      equal_405_s2_q <= row_s1_q == 6'h0;
      drew_s2_q <= drew_s1_q;
      left_rdata_s2_q <= left_rdata_q[63];
      x_s2_2_q <= x_s1_2_q;
      not_516_s2_q <= not_516;
      select_518_s2_q <= select_518;
      equal_521_s2_q <= equal_521_s1_q;
      and_527_s2_q <= and_527;
      and_528_s2_q <= right_codes_rdata_q[38] & not_374_s1_q;
      not_533_s2_q <= not_533[11];
      sum_543_s2_q <= {3'h0, not_533[10]} + sum_542;
      and_546_s2_q <= left_rdata_q[60] & not_374_s1_q;
      and_547_s2_q <= right_codes_rdata_q[51] & not_374_s1_q;
      not_552_s2_q <= not_552[11];
      sum_562_s2_q <= {3'h0, not_552[10]} + sum_561;
      and_566_s2_q <= and_566;
      and_567_s2_q <= right_codes_rdata_q[64] & not_374_s1_q;
      not_572_s2_q <= not_572[11];
      sum_582_s2_q <= {3'h0, not_572[10]} + sum_581;
      equal_588_s2_q <= equal_588_s1_q;
      not_593_s2_q <= not_593[11];
      sum_603_s2_q <= {3'h0, not_593[10]} + sum_602;
      not_608_s2_q <= not_608[11];
      sum_618_s2_q <= {3'h0, not_608[10]} + sum_617;
      and_622_s2_q <= right_codes_rdata_q[77] & not_374_s1_q;
      not_626_s2_q <= not_626[11];
      sum_636_s2_q <= {3'h0, not_626[10]} + sum_635;
      and_646_s2_q <= right_codes_rdata_q[25] & not_374_s1_q;
      not_650_s2_q <= not_650[11];
      sum_660_s2_q <= {3'h0, not_650[10]} + sum_659;
      not_665_s2_q <= not_665[11];
      sum_675_s2_q <= {3'h0, not_665[10]} + sum_674;
      not_681_s2_q <= not_681[11];
      sum_691_s2_q <= {3'h0, not_681[10]} + sum_690;
      not_705_s2_q <= not_705[11];
      sum_715_s2_q <= {3'h0, not_705[10]} + sum_714;
      not_720_s2_q <= not_720[11];
      sum_730_s2_q <= {3'h0, not_720[10]} + sum_729;
      and_735_s2_q <= and_566 & (right_codes_rdata_q[90] & not_374_s1_q);
      not_738_s2_q <= not_738[11];
      sum_748_s2_q <= {3'h0, not_738[10]} + sum_747;
      and_764_s2_q <= and_527 & (right_codes_rdata_q[12] & not_374_s1_q);
      not_767_s2_q <= not_767[11];
      sum_777_s2_q <= {3'h0, not_767[10]} + sum_776;
      not_782_s2_q <= not_782[11];
      sum_792_s2_q <= {3'h0, not_782[10]} + sum_791;
      not_798_s2_q <= not_798[11];
      sum_808_s2_q <= {3'h0, not_798[10]} + sum_807;
      equal_825_s2_q <= equal_825_s1_q;
      and_883_s2_q <= equal_370_s1_q & and_515_s1_q;
      equal_889_s2_q <= equal_889_s1_q;
      equal_912_s2_q <= equal_912_s1_q;
      equal_915_s2_q <= equal_915_s1_q;
      and_926_s2_q <= left_rdata_q[61] & (left_rdata_q[62] & not_924);
      and_957_s2_q <= not_371_s1_q & and_517;
      and_1057_s2_q <= not_371_s1_q & (not_516 & and_1055);
      equal_1197_s2_q <= {column_s1_q[6], or_1196} == 7'h0;
      equal_1249_s2_q <= equal_1249_s1_q;
      not_1295_s2_q <= not_1295_s1_q;
      and_1383_s2_q <= left_rdata_q[61] & not_924;
      less_1477_s2_q <= 5'h4 < row_q[5:1];
      less_1480_s2_q <= less_1480_s1_q;
      equal_1742_s2_q <= row_s1_q[5:2] == 4'h0;
      less_1753_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_1918_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
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
  logic [11:0] select_329;
  assign select_329 = select_312_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:100
  logic [11:0] sum_333;
  assign sum_333 = select_329 + (equal_331_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:91
  logic [11:0] sum_335;
  assign sum_335 = {4'h0, sample_pair_pixel_1_q} + (select_312_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:100
  logic [11:0] sum_337;
  assign sum_337 = sum_335 + (equal_331_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:101
  logic and_341;
  assign and_341 = whole_s2_q & (averager_memory_rdata_q[24] | equal_331_s2_q);
  // hls/stages/agreement.hpp:181
  logic all_of_skin;
  assign all_of_skin = select_312_s2_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:102
  logic and_345;
  assign and_345 = all_of_skin & (averager_memory_rdata_q[25] | equal_331_s2_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_325_s2_q ? sum_333[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_325_s2_q ? sum_337[11:3] : 9'h0;
  logic and_362;
  assign and_362 = and_325_s2_q & and_341;
  // hls/stages/census.hpp:105
  logic select_364;
  assign select_364 = equal_354_s2_q ? and_362 : (averager_mask_q & and_362);
  // hls/stages/agreement.hpp:183
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_364;
  // hls/stages/census.hpp:126
  logic and_366;
  assign and_366 = and_325_s2_q & and_345;
  // hls/stages/census.hpp:105
  logic select_368;
  assign select_368 = equal_354_s2_q ? and_366 : (averager_of_skin_q & and_366);
  // hls/stages/agreement.hpp:395
  logic [3:0] column_2;
  assign column_2 = (and_527_s2_q & and_528_s2_q) ? ({3'h0, not_533_s2_q} + sum_543_s2_q) : 4'h0;
  logic [3:0] select_564;
  assign select_564 = (and_546_s2_q & and_547_s2_q) ? ({3'h0, not_552_s2_q} + sum_562_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_3;
  assign column_3 = {1'b0, column_2} + {1'b0, select_564};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_584;
  assign select_584 = (and_566_s2_q & and_567_s2_q) ? ({3'h0, not_572_s2_q} + sum_582_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_4;
  assign column_4 = {1'b0, column_3} + {2'h0, select_584};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_587;
  assign difference_587 = {2'h0, column_4} - (age_s2_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_590;
  assign sum_590 = difference_587 + (equal_588_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:395
  logic [3:0] column_5;
  assign column_5 = (and_527_s2_q & and_547_s2_q) ? ({3'h0, not_593_s2_q} + sum_603_s2_q) : 4'h0;
  logic [3:0] select_620;
  assign select_620 = (and_546_s2_q & and_567_s2_q) ? ({3'h0, not_608_s2_q} + sum_618_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_6;
  assign column_6 = {1'b0, column_5} + {1'b0, select_620};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_638;
  assign select_638 = (and_566_s2_q & and_622_s2_q) ? ({3'h0, not_626_s2_q} + sum_636_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_7;
  assign column_7 = {1'b0, column_6} + {2'h0, select_638};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_641;
  assign difference_641 = {2'h0, column_7} - (age_s2_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_643;
  assign sum_643 = difference_641 + (equal_588_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:438
  logic less_644;
  assign less_644 = sum_590 < sum_643;
  // hls/stages/agreement.hpp:395
  logic [3:0] column_8;
  assign column_8 = (and_527_s2_q & and_646_s2_q) ? ({3'h0, not_650_s2_q} + sum_660_s2_q) : 4'h0;
  logic [3:0] select_677;
  assign select_677 = (and_546_s2_q & and_528_s2_q) ? ({3'h0, not_665_s2_q} + sum_675_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_9;
  assign column_9 = {1'b0, column_8} + {1'b0, select_677};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_693;
  assign select_693 = (and_566_s2_q & and_547_s2_q) ? ({3'h0, not_681_s2_q} + sum_691_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_10;
  assign column_10 = {1'b0, column_9} + {2'h0, select_693};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_696;
  assign difference_696 = {2'h0, column_10} - (age_s2_q[1] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_698;
  assign sum_698 = difference_696 + (equal_588_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:438
  logic not_700;
  assign not_700 = ~less_644;
  logic [1:0] best;
  assign best = ((less_644 ? sum_643 : sum_590) < sum_698) ? 2'h3 : {not_700, less_644};
  // hls/stages/agreement.hpp:395
  logic [3:0] column_11;
  assign column_11 = (and_527_s2_q & and_567_s2_q) ? ({3'h0, not_705_s2_q} + sum_715_s2_q) : 4'h0;
  logic [3:0] select_732;
  assign select_732 = (and_546_s2_q & and_622_s2_q) ? ({3'h0, not_720_s2_q} + sum_730_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_12;
  assign column_12 = {1'b0, column_11} + {1'b0, select_732};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_750;
  assign select_750 = and_735_s2_q ? ({3'h0, not_738_s2_q} + sum_748_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_13;
  assign column_13 = {1'b0, column_12} + {2'h0, select_750};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_753;
  assign difference_753 = {2'h0, column_13} - (age_s2_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_755;
  assign sum_755 = difference_753 + (equal_588_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:438
  logic [7:0] select_757;
  assign select_757 = best[1] ? (best[0] ? sum_698 : sum_590) : (best[0] ? sum_643 : sum_755);
  logic [1:0] best_2;
  assign best_2 = (select_757 < sum_755) ? 2'h0 : best;
  // hls/stages/agreement.hpp:395
  logic [3:0] column_14;
  assign column_14 = and_764_s2_q ? ({3'h0, not_767_s2_q} + sum_777_s2_q) : 4'h0;
  logic [3:0] select_794;
  assign select_794 = (and_546_s2_q & and_646_s2_q) ? ({3'h0, not_782_s2_q} + sum_792_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [4:0] column_15;
  assign column_15 = {1'b0, column_14} + {1'b0, select_794};
  // hls/stages/agreement.hpp:395
  logic [3:0] select_810;
  assign select_810 = (and_566_s2_q & and_528_s2_q) ? ({3'h0, not_798_s2_q} + sum_808_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:423
  logic [5:0] column_16;
  assign column_16 = {1'b0, column_15} + {2'h0, select_810};
  // hls/stages/agreement.hpp:425
  logic [7:0] difference_813;
  assign difference_813 = {2'h0, column_16} - (age_s2_q[1] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_815;
  assign sum_815 = difference_813 + (equal_588_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:450
  logic [6:0] partner;
  assign partner = {run_shift_s2_q[5], run_shift_s2_q} + x_s2_2_q;
  // hls/stages/agreement.hpp:317
  logic [6:0] select_886;
  assign select_886 = equal_370_s2_q ? partner : (x_s2_q[6:0] + {best_left_rdata_q[13], best_left_rdata_q[13:8]});
  // hls/stages/agreement.hpp:183
  logic select_1110;
  assign select_1110 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_1112;
  assign select_1112 = sample_pair_whole_s2_q ? (and_349_s2_q ? select_364 : averager_mask_q) : averager_mask_q;
  logic select_1114;
  assign select_1114 = sample_pair_whole_s2_q ? (and_349_s2_q ? select_368 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1342;
  assign select_1342 = equal_370_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1343;
  assign select_1343 = equal_370_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1344;
  assign select_1344 = equal_370_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1345;
  assign select_1345 = equal_370_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1346;
  assign select_1346 = equal_370_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1347;
  assign select_1347 = equal_370_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1350;
  assign select_1350 = equal_370_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1351;
  assign select_1351 = equal_370_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1352;
  assign select_1352 = equal_370_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1353;
  assign select_1353 = equal_370_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1354;
  assign select_1354 = equal_370_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1355;
  assign select_1355 = equal_370_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1358;
  assign select_1358 = equal_370_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1359;
  assign select_1359 = equal_370_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1360;
  assign select_1360 = equal_370_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1361;
  assign select_1361 = equal_370_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1362;
  assign select_1362 = equal_370_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1363;
  assign select_1363 = equal_370_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1366;
  assign select_1366 = equal_370_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1367;
  assign select_1367 = equal_370_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1368;
  assign select_1368 = equal_370_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1369;
  assign select_1369 = equal_370_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1370;
  assign select_1370 = equal_370_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1371;
  assign select_1371 = equal_370_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1374;
  assign select_1374 = equal_370_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1375;
  assign select_1375 = equal_370_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1376;
  assign select_1376 = equal_370_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1377;
  assign select_1377 = equal_370_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1378;
  assign select_1378 = equal_370_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1379;
  assign select_1379 = equal_370_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/registration.hpp:158
  logic [16:0] select_1485;
  assign select_1485 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [13:0] select_1487;
  assign select_1487 = ($signed(10'h0) < $signed(select_1485[16:7])) ? 14'h7f : select_1485[13:0];
  // hls/stages/registration.hpp:153
  logic [9:0] select_1488;
  assign select_1488 = best_left_rdata_q[12] ? select_1487[9:0] : 10'h0;
  logic [8:0] difference_1490;
  assign difference_1490 = select_1488[9:1] - (best_left_rdata_q[13] ? select_1487[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1493;
  assign sum_1493 = (best_left_rdata_q[8] ? select_1487[13:1] : 13'h0) + (best_left_rdata_q[9] ? select_1487[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1494;
  assign select_1494 = best_left_rdata_q[10] ? select_1487[11:0] : 12'h0;
  logic [10:0] sum_1496;
  assign sum_1496 = select_1494[11:1] + (best_left_rdata_q[11] ? select_1487[10:0] : 11'h0);
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1497;
  assign sum_1497 = sum_1493[12:1] + {sum_1496, select_1494[0]};
  logic [9:0] sum_1498;
  assign sum_1498 = {difference_1490, select_1488[0]} + sum_1497[11:2];
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1499;
  assign sum_1499 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_1498[9]}}, sum_1498[9:2]};
  // hls/stages/registration.hpp:151
  logic [7:0] select_1502;
  assign select_1502 = ($signed(sum_1499[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1499[7:0];
  logic [7:0] slope;
  assign slope = ($signed(6'h0) < $signed(sum_1499[12:7])) ? 8'h7f : select_1502;
  logic [6:0] select_1504;
  assign select_1504 = best_left_rdata_q[8] ? slope[7:1] : 7'h0;
  logic [7:0] select_1505;
  assign select_1505 = best_left_rdata_q[9] ? slope : 8'h0;
  logic [8:0] sum_1506;
  assign sum_1506 = {{2{select_1504[6]}}, select_1504} + {select_1505[7], select_1505};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1507;
  assign select_1507 = best_left_rdata_q[10] ? slope : 8'h0;
  logic [7:0] select_1508;
  assign select_1508 = best_left_rdata_q[11] ? slope : 8'h0;
  logic [8:0] sum_1509;
  assign sum_1509 = {{2{select_1507[7]}}, select_1507[7:1]} + {select_1508[7], select_1508};
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1510;
  assign sum_1510 = {{3{sum_1506[8]}}, sum_1506[8:1]} + {sum_1509[8], sum_1509, select_1507[0]};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1511;
  assign select_1511 = best_left_rdata_q[12] ? slope : 8'h0;
  logic [7:0] select_1512;
  assign select_1512 = best_left_rdata_q[13] ? slope : 8'h0;
  logic [8:0] difference_1513;
  assign difference_1513 = {{2{select_1511[7]}}, select_1511[7:1]} - {select_1512[7], select_1512};
  // hls/stages/registration.hpp:57
  logic [23:0] select_1743;
  assign select_1743 = equal_1742_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:184
  logic [23:0] select_1745;
  assign select_1745 = and_351_s2_q ? (equal_1249_s2_q ? select_1743 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1746;
  assign select_1746 = equal_1742_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:184
  logic [27:0] select_1748;
  assign select_1748 = and_351_s2_q ? (equal_1249_s2_q ? select_1746 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1750;
  assign select_1750 = drew_s2_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1751;
  assign sum_1751 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1752;
  assign sum_1752 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

  // Memory census_memory, 80 x 78 and parity, DISTANCE 16, hls/stages/census.hpp:254; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [78:0] census_memory_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) census_memory_mem[i] = 79'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_351_s2_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory best_right, 80 x 15 and parity, DISTANCE 12, hls/stages/agreement.hpp:806; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [15:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 16'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = select_886;
  logic best_right_re;
  assign best_right_re = s2_en & select_518_s2_q;
  logic [15:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [14:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[14:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory seen_columns, 80 x 14 and parity, DISTANCE 12, hls/stages/agreement.hpp:837; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 15'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_957_s2_q;
  logic [14:0] seen_columns_word_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_word_q <= seen_columns_mem[seen_columns_raddr];
  end
  logic [13:0] seen_columns_rdata_q;
  assign seen_columns_rdata_q = seen_columns_word_q[13:0];
  logic seen_columns_read_q, seen_columns_error;
  always_ff @(posedge clk_i) seen_columns_read_q <= rst_ni & seen_columns_re;
  assign seen_columns_error = seen_columns_read_q & ^seen_columns_word_q;

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_318_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_326_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_345, and_341, sum_337, sum_333};
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
      sample_pair_pixel_0_q <= pixel_0_s2_q;
      sample_pair_pixel_1_q <= pixel_1_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_of_skin_q <= select_1110;
      averager_mask_q <= select_1112;
      averager_of_skin_q <= select_1114;
      registration_slope_row_q <= select_1745;
      registration_slope_change_q <= select_1748;
      registration_slope_q <= select_1750;
      registration_next_slope_row_q <= sum_1751;
      registration_next_slope_change_q <= sum_1752;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_329 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_335 : averager_running_1_q;
      sums_0_columns_values_0_q <= equal_370_s2_q ? {2'h0, column_13} : sums_0_columns_values_0_q;
      sums_0_columns_values_1_q <= select_1342;
      sums_0_columns_values_2_q <= select_1343;
      sums_0_columns_values_3_q <= select_1344;
      sums_0_columns_values_4_q <= select_1345;
      sums_0_columns_values_5_q <= select_1346;
      sums_0_columns_values_6_q <= select_1347;
      sums_0_sum_sums_values_0_q <= equal_370_s2_q ? sum_755 : sums_0_sum_sums_values_0_q;
      sums_1_columns_values_0_q <= equal_370_s2_q ? {2'h0, column_7} : sums_1_columns_values_0_q;
      sums_1_columns_values_1_q <= select_1350;
      sums_1_columns_values_2_q <= select_1351;
      sums_1_columns_values_3_q <= select_1352;
      sums_1_columns_values_4_q <= select_1353;
      sums_1_columns_values_5_q <= select_1354;
      sums_1_columns_values_6_q <= select_1355;
      sums_1_sum_sums_values_0_q <= equal_370_s2_q ? sum_643 : sums_1_sum_sums_values_0_q;
      sums_2_columns_values_0_q <= equal_370_s2_q ? {2'h0, column_4} : sums_2_columns_values_0_q;
      sums_2_columns_values_1_q <= select_1358;
      sums_2_columns_values_2_q <= select_1359;
      sums_2_columns_values_3_q <= select_1360;
      sums_2_columns_values_4_q <= select_1361;
      sums_2_columns_values_5_q <= select_1362;
      sums_2_columns_values_6_q <= select_1363;
      sums_2_sum_sums_values_0_q <= equal_370_s2_q ? sum_590 : sums_2_sum_sums_values_0_q;
      sums_3_columns_values_0_q <= equal_370_s2_q ? {2'h0, column_10} : sums_3_columns_values_0_q;
      sums_3_columns_values_1_q <= select_1366;
      sums_3_columns_values_2_q <= select_1367;
      sums_3_columns_values_3_q <= select_1368;
      sums_3_columns_values_4_q <= select_1369;
      sums_3_columns_values_5_q <= select_1370;
      sums_3_columns_values_6_q <= select_1371;
      sums_3_sum_sums_values_0_q <= equal_370_s2_q ? sum_698 : sums_3_sum_sums_values_0_q;
      sums_4_columns_values_0_q <= equal_370_s2_q ? {2'h0, column_16} : sums_4_columns_values_0_q;
      sums_4_columns_values_1_q <= select_1374;
      sums_4_columns_values_2_q <= select_1375;
      sums_4_columns_values_3_q <= select_1376;
      sums_4_columns_values_4_q <= select_1377;
      sums_4_columns_values_5_q <= select_1378;
      sums_4_columns_values_6_q <= select_1379;
      sums_4_sum_sums_values_0_q <= equal_370_s2_q ? sum_815 : sums_4_sum_sums_values_0_q;
    end
  end

  logic saturated_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic [5:0] run_shift_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic lower_half_s3_q;
  logic [6:0] column_s3_q;
  logic and_349_s3_q;
  logic and_351_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_354_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic and_369_s3_q;
  logic equal_370_s3_q;
  logic not_371_s3_q;
  logic equal_372_s3_q;
  logic less_373_s3_q;
  logic not_374_s3_q;
  logic equal_405_s3_q;
  logic drew_s3_q;
  logic left_rdata_s3_q;
  logic [6:0] x_s3_2_q;
  logic not_516_s3_q;
  logic [21:0] best_left_rdata_s3_q;
  logic equal_521_s3_q;
  logic [7:0] sum_590_s3_q;
  logic [7:0] sum_643_s3_q;
  logic [7:0] sum_698_s3_q;
  logic [7:0] sum_755_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_815_s3_q;
  logic equal_825_s3_q;
  logic and_883_s3_q;
  logic [6:0] partner_s3_q;
  logic equal_889_s3_q;
  logic equal_912_s3_q;
  logic equal_915_s3_q;
  logic and_926_s3_q;
  logic and_957_s3_q;
  logic and_1057_s3_q;
  logic equal_1197_s3_q;
  logic equal_1249_s3_q;
  logic not_1295_s3_q;
  logic and_1383_s3_q;
  logic less_1477_s3_q;
  logic less_1480_s3_q;
  logic [9:0] sum_1510_s3_q;
  logic select_1511_s3_q;
  logic [8:0] difference_1513_s3_q;
  logic less_1753_s3_q;
  logic equal_1918_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      saturated_s3_q <= saturated_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      run_shift_s3_q <= run_shift_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[0];
      lower_half_s3_q <= lower_half_s2_q;
      column_s3_q <= column_s2_q;
      and_349_s3_q <= and_349_s2_q;
      and_351_s3_q <= and_351_s2_q;
      grey_s3_q <= grey;
      equal_354_s3_q <= equal_354_s2_q;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      and_369_s3_q <= sample_pair_whole_s2_q & select_368;
      equal_370_s3_q <= equal_370_s2_q;
      not_371_s3_q <= not_371_s2_q;
      equal_372_s3_q <= equal_372_s2_q;
      less_373_s3_q <= less_373_s2_q;
      not_374_s3_q <= not_374_s2_q;
      equal_405_s3_q <= equal_405_s2_q;
      drew_s3_q <= drew_s2_q;
      left_rdata_s3_q <= left_rdata_s2_q;
      x_s3_2_q <= x_s2_2_q;
      not_516_s3_q <= not_516_s2_q;
      best_left_rdata_s3_q <= best_left_rdata_q;
      equal_521_s3_q <= equal_521_s2_q;
      sum_590_s3_q <= sum_590;
      sum_643_s3_q <= sum_643;
      sum_698_s3_q <= sum_698;
      sum_755_s3_q <= sum_755;
      best_2_s3_q <= best_2;
      sum_815_s3_q <= sum_815;
      equal_825_s3_q <= equal_825_s2_q;
      and_883_s3_q <= and_883_s2_q;
      partner_s3_q <= partner;
      equal_889_s3_q <= equal_889_s2_q;
      equal_912_s3_q <= equal_912_s2_q;
      equal_915_s3_q <= equal_915_s2_q;
      and_926_s3_q <= and_926_s2_q;
      and_957_s3_q <= and_957_s2_q;
      and_1057_s3_q <= and_1057_s2_q;
      equal_1197_s3_q <= equal_1197_s2_q;
      equal_1249_s3_q <= equal_1249_s2_q;
      not_1295_s3_q <= not_1295_s2_q;
      and_1383_s3_q <= and_1383_s2_q;
      less_1477_s3_q <= less_1477_s2_q;
      less_1480_s3_q <= less_1480_s2_q;
      sum_1510_s3_q <= sum_1510[10:1];
      select_1511_s3_q <= select_1511[0];
      difference_1513_s3_q <= difference_1513;
      less_1753_s3_q <= less_1753_s2_q;
      equal_1918_s3_q <= equal_1918_s2_q;
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
  assign total = {2'h0, grey_s3_q} + (equal_354_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:183
  logic [8:0] select_357;
  assign select_357 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_354_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:183
  logic [8:0] select_361;
  assign select_361 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:214
  logic less_378;
  assign less_378 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_379;
  assign less_379 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_380;
  assign less_380 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_381;
  assign less_381 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_382;
  assign less_382 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_383;
  assign less_383 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_384;
  assign less_384 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_385;
  assign less_385 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_386;
  assign less_386 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_387;
  assign less_387 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_388;
  assign less_388 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_389;
  assign less_389 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_390;
  assign less_390 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_391;
  assign less_391 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_392;
  assign less_392 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_393;
  assign less_393 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_394;
  assign less_394 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_395;
  assign less_395 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_396;
  assign less_396 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_397;
  assign less_397 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_398;
  assign less_398 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_399;
  assign less_399 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_400;
  assign less_400 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_401;
  assign less_401 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:259
  logic equal_402;
  assign equal_402 = column_s3_q == 7'h0;
  logic [3:0] select_406;
  assign select_406 = equal_405_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:260
  logic [4:0] select_407;
  assign select_407 = equal_402 ? {select_406, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_408;
  assign select_408 = equal_402 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:219
  logic and_409;
  assign and_409 = select_407[4] & select_408[3];
  // hls/stages/census.hpp:206
  logic and_411;
  assign and_411 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_413;
  assign and_413 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_411);
  // hls/stages/agreement.hpp:260
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_413;
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
  logic [9:0] difference_436;
  assign difference_436 = {1'b0, select_357} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_437;
  assign xor_437 = difference_436[8:0] ^ {9{difference_436[9]}};
  logic [9:0] sum_438;
  assign sum_438 = {9'h0, difference_436[9]} + {1'b0, xor_437};
  logic [9:0] difference_439;
  assign difference_439 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_440;
  assign xor_440 = difference_439[8:0] ^ {9{difference_439[9]}};
  logic [9:0] sum_441;
  assign sum_441 = {9'h0, difference_439[9]} + {1'b0, xor_440};
  logic [9:0] difference_443;
  assign difference_443 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_444;
  assign xor_444 = difference_443[8:0] ^ {9{difference_443[9]}};
  logic [9:0] sum_445;
  assign sum_445 = {9'h0, difference_443[9]} + {1'b0, xor_444};
  logic [10:0] sum_446;
  assign sum_446 = ({1'b0, sum_438} + {1'b0, sum_441}) + {1'b0, sum_445};
  logic [9:0] difference_447;
  assign difference_447 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_448;
  assign xor_448 = difference_447[8:0] ^ {9{difference_447[9]}};
  logic [9:0] sum_449;
  assign sum_449 = {9'h0, difference_447[9]} + {1'b0, xor_448};
  logic [9:0] difference_451;
  assign difference_451 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_452;
  assign xor_452 = difference_451[8:0] ^ {9{difference_451[9]}};
  logic [9:0] sum_453;
  assign sum_453 = {9'h0, difference_451[9]} + {1'b0, xor_452};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_446} + {2'h0, sum_449}) + {2'h0, sum_453};
  // hls/stages/agreement.hpp:430
  logic not_523;
  assign not_523 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_524;
  assign less_524 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:438
  logic [7:0] select_762;
  assign select_762 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_698_s3_q : sum_590_s3_q) : (best_2_s3_q[0] ? sum_643_s3_q : sum_755_s3_q);
  logic less_816;
  assign less_816 = select_762 < sum_815_s3_q;
  logic [1:0] select_817;
  assign select_817 = less_816 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:440
  logic [7:0] select_820;
  assign select_820 = select_817[1] ? (select_817[0] ? sum_698_s3_q : sum_590_s3_q) : (select_817[0] ? sum_643_s3_q : sum_755_s3_q);
  logic [7:0] of_best;
  assign of_best = less_816 ? sum_815_s3_q : select_820;
  logic [7:0] of_best_2;
  assign of_best_2 = (not_523 & (~less_524)) ? of_best : 8'h0;
  // hls/stages/agreement.hpp:442
  logic less_823;
  assign less_823 = $signed(run_shift_s3_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:445
  logic less_824;
  assign less_824 = best_left_rdata_s3_q[7:0] < of_best_2;
  logic or_826;
  assign or_826 = less_824 | equal_825_s3_q;
  // hls/stages/agreement.hpp:448
  logic [7:0] select_829;
  assign select_829 = less_823 ? (or_826 ? of_best_2 : best_left_rdata_s3_q[7:0]) : (less_824 ? of_best_2 : best_left_rdata_s3_q[7:0]);
  logic [5:0] select_833;
  assign select_833 = less_823 ? (or_826 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]) : (less_824 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]);
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_816, select_817} == 3'h4) ? 3'h3 : (({less_816, select_817} == 3'h0) ? 3'h1 : {less_816, select_817});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_840;
  assign sum_840 = near_best + 3'h1;
  logic [7:0] select_843;
  assign select_843 = sum_840[1] ? (sum_840[0] ? sum_698_s3_q : sum_590_s3_q) : (sum_840[0] ? sum_643_s3_q : sum_755_s3_q);
  logic [7:0] below;
  assign below = sum_840[2] ? sum_815_s3_q : select_843;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_845;
  assign sum_845 = near_best + 3'h7;
  logic [7:0] select_848;
  assign select_848 = sum_845[1] ? (sum_845[0] ? sum_698_s3_q : sum_590_s3_q) : (sum_845[0] ? sum_643_s3_q : sum_755_s3_q);
  logic [7:0] above;
  assign above = sum_845[2] ? sum_815_s3_q : select_848;
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/registration.hpp:26
  logic [7:0] select_854;
  assign select_854 = near_best[1] ? (near_best[0] ? sum_698_s3_q : sum_590_s3_q) : (near_best[0] ? sum_643_s3_q : sum_755_s3_q);
  logic [7:0] select_855;
  assign select_855 = near_best[2] ? sum_815_s3_q : select_854;
  logic [7:0] select_856;
  assign select_856 = rise[8] ? below : above;
  logic [8:0] fall;
  assign fall = {1'b0, select_855} - {1'b0, select_856};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [7:0] xor_859;
  assign xor_859 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_859};
  // hls/stages/agreement.hpp:452
  logic less_888;
  assign less_888 = best_right_rdata_q[7:0] < of_best_2;
  logic or_890;
  assign or_890 = less_888 | equal_889_s3_q;
  // hls/stages/agreement.hpp:453
  logic [7:0] select_893;
  assign select_893 = less_823 ? (or_890 ? of_best_2 : best_right_rdata_q[7:0]) : (less_888 ? of_best_2 : best_right_rdata_q[7:0]);
  logic [7:0] select_894;
  assign select_894 = equal_521_s3_q ? of_best_2 : select_893;
  logic [6:0] select_897;
  assign select_897 = less_823 ? (or_890 ? x_s3_2_q : best_right_rdata_q[14:8]) : (less_888 ? x_s3_2_q : best_right_rdata_q[14:8]);
  logic [6:0] select_898;
  assign select_898 = equal_521_s3_q ? x_s3_2_q : select_897;
  // hls/stages/agreement.hpp:142
  logic [7:0] select_899;
  assign select_899 = drew_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:564
  logic or_902;
  assign or_902 = select_899[7] | (~({select_899[5], select_899[3], select_899[1]} == 3'h0));
  // hls/stages/agreement.hpp:563
  logic or_905;
  assign or_905 = select_899[7] | (~({select_899[6], select_899[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:562
  logic or_908;
  assign or_908 = select_899[7] | (~(select_899[6:4] == 3'h0));
  // hls/stages/division.hpp:18
  logic [5:0] sum_910;
  assign sum_910 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:572
  logic or_913;
  assign or_913 = (~sum_910[5]) | equal_912_s3_q;
  // hls/stages/agreement.hpp:542
  logic and_914;
  assign and_914 = not_374_s3_q & or_913;
  // hls/stages/agreement.hpp:641
  logic equal_916;
  assign equal_916 = x_s3_q[5:4] == 2'h3;
  // hls/stages/agreement.hpp:317
  logic and_918;
  assign and_918 = equal_915_s3_q & (~equal_916);
  // hls/stages/agreement.hpp:170
  logic textured;
  assign textured = not_374_s3_q & and_926_s3_q;
  // hls/stages/agreement.hpp:530
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s3_q};
  // hls/stages/agreement.hpp:533
  logic [9:0] sum_935;
  assign sum_935 = {way[8], way} + 10'h1;
  logic and_937;
  assign and_937 = (and_926_s3_q & (8'hb6 < best_left_rdata_s3_q[7:0])) & ({{6{sum_935[9]}}, sum_935} < 16'h3);
  // hls/stages/agreement.hpp:170
  logic explained;
  assign explained = not_374_s3_q & and_937;
  // hls/stages/agreement.hpp:535
  logic and_945;
  assign and_945 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s3_q[13:8]));
  // hls/stages/agreement.hpp:170
  logic and_947;
  assign and_947 = and_937 & ((cfg_nearer_below_i & best_left_rdata_s3_q[13]) | and_945);
  logic and_959;
  assign and_959 = left_rdata_s3_q & not_374_s3_q;
  logic near;
  assign near = not_374_s3_q & and_947;
  // hls/stages/agreement.hpp:734
  logic or_961;
  assign or_961 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:736
  logic [17:0] select_963;
  assign select_963 = marks_first_s3_q ? 18'h1 : (or_961 ? {rows_passed_q[16:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:735
  logic [8:0] select_965;
  assign select_965 = or_961 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:743
  logic select_967;
  assign select_967 = cfg_compete_i ? (or_961 & select_963[17]) : (select_965[8] & select_963[9]);
  // hls/stages/agreement.hpp:185
  logic next_row;
  assign next_row = select_967 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:750
  logic [6:0] select_970;
  assign select_970 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_972;
  assign select_972 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_970});
  // hls/stages/agreement.hpp:760
  logic equal_973;
  assign equal_973 = seen_x_q == 3'h7;
  logic [7:0] select_975;
  assign select_975 = select_967 ? 8'h0 : (seen_column_q + {7'h0, equal_973});
  // hls/stages/agreement.hpp:763
  logic [12:0] index;
  assign index = select_972 + {5'h0, select_975};
  // hls/stages/agreement.hpp:734
  logic select_978;
  assign select_978 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:720
  logic [7:0] sum_979;
  assign sum_979 = {1'b0, select_978, 2'h0, select_978, 1'b0, {2{select_978}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:733
  logic not_980;
  assign not_980 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:185
  logic and_982;
  assign and_982 = not_980 & (began_q | select_967);
  // hls/stages/agreement.hpp:761
  logic [2:0] select_984;
  assign select_984 = select_967 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:762
  logic and_986;
  assign and_986 = and_982 & (select_984 == 3'h0);
  logic less_987;
  assign less_987 = select_975 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:624
  logic [7:0] sum_990;
  assign sum_990 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_990[7]}}, sum_990, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:720
  logic [7:0] sum_992;
  assign sum_992 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:542
  logic [5:0] select_993;
  assign select_993 = less_373_s3_q ? 6'h0 : seen_columns_rdata_q[13:8];
  logic [5:0] select_994;
  assign select_994 = less_373_s3_q ? 6'h0 : {seen_columns_rdata_q[7:6], seen_columns_rdata_q[4:2], seen_columns_rdata_q[0]};
  // hls/stages/agreement.hpp:600
  logic [1:0] sum_996;
  assign sum_996 = {1'b0, select_994[3]} + ({1'b0, textured} + {1'b0, select_994[0]});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, select_993[3]} + ({2'h0, select_993[0]} + {1'b0, sum_996});
  // hls/stages/agreement.hpp:542
  logic [7:0] select_1006;
  assign select_1006 = less_373_s3_q ? select_899 : (sum_910[5] ? select_899 : {select_899[6:0], 1'b0});
  // hls/stages/agreement.hpp:564
  logic or_1009;
  assign or_1009 = select_1006[7] | (~({select_1006[5], select_1006[3], select_1006[1]} == 3'h0));
  // hls/stages/agreement.hpp:601
  logic [1:0] sum_1026;
  assign sum_1026 = {1'b0, select_994[4]} + ({1'b0, explained} + {1'b0, select_994[1]});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, select_993[4]} + ({2'h0, select_993[1]} + {1'b0, sum_1026});
  // hls/stages/agreement.hpp:602
  logic [1:0] sum_1038;
  assign sum_1038 = {1'b0, select_994[5]} + ({1'b0, near} + {1'b0, select_994[2]});
  logic [2:0] near_2;
  assign near_2 = {2'h0, select_993[5]} + ({2'h0, select_993[2]} + {1'b0, sum_1038});
  // hls/stages/agreement.hpp:183
  logic [10:0] select_1089;
  assign select_1089 = sample_pair_whole_s3_q ? (and_349_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1091;
  assign select_1091 = sample_pair_whole_s3_q ? (and_349_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:184
  logic [8:0] select_1115;
  assign select_1115 = and_351_s3_q ? select_357 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1116;
  assign select_1116 = and_351_s3_q ? select_361 : census_columns_values_0_cell_0_right_q;
  logic select_1117;
  assign select_1117 = and_351_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_1118;
  assign select_1118 = and_351_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1119;
  assign select_1119 = and_351_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1120;
  assign select_1120 = and_351_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1121;
  assign select_1121 = and_351_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1122;
  assign select_1122 = and_351_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1123;
  assign select_1123 = and_351_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1124;
  assign select_1124 = and_351_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1125;
  assign select_1125 = and_351_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1126;
  assign select_1126 = and_351_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1127;
  assign select_1127 = and_351_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1128;
  assign select_1128 = and_351_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1129;
  assign select_1129 = and_351_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1130;
  assign select_1130 = and_351_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1131;
  assign select_1131 = and_351_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1132;
  assign select_1132 = and_351_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1133;
  assign select_1133 = and_351_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1134;
  assign select_1134 = and_351_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1135;
  assign select_1135 = and_351_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1136;
  assign select_1136 = and_351_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1137;
  assign select_1137 = and_351_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1138;
  assign select_1138 = and_351_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1139;
  assign select_1139 = and_351_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1140;
  assign select_1140 = and_351_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1141;
  assign select_1141 = and_351_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1142;
  assign select_1142 = and_351_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1143;
  assign select_1143 = and_351_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1144;
  assign select_1144 = and_351_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1145;
  assign select_1145 = and_351_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1146;
  assign select_1146 = and_351_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1147;
  assign select_1147 = and_351_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1148;
  assign select_1148 = and_351_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1149;
  assign select_1149 = and_351_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1150;
  assign select_1150 = and_351_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1151;
  assign select_1151 = and_351_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1152;
  assign select_1152 = and_351_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1153;
  assign select_1153 = and_351_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1154;
  assign select_1154 = and_351_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1155;
  assign select_1155 = and_351_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1156;
  assign select_1156 = and_351_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1157;
  assign select_1157 = and_351_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1158;
  assign select_1158 = and_351_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1159;
  assign select_1159 = and_351_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1160;
  assign select_1160 = and_351_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1161;
  assign select_1161 = and_351_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1162;
  assign select_1162 = and_351_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1163;
  assign select_1163 = and_351_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1164;
  assign select_1164 = and_351_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1165;
  assign select_1165 = and_351_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1166;
  assign select_1166 = and_351_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1167;
  assign select_1167 = and_351_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1168;
  assign select_1168 = and_351_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1169;
  assign select_1169 = and_351_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1170;
  assign select_1170 = and_351_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1172;
  assign difference_1172 = {1'b0, select_361} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1173;
  assign xor_1173 = difference_1172[8:0] ^ {9{difference_1172[9]}};
  logic [9:0] sum_1174;
  assign sum_1174 = {9'h0, difference_1172[9]} + {1'b0, xor_1173};
  logic [9:0] difference_1175;
  assign difference_1175 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1176;
  assign xor_1176 = difference_1175[8:0] ^ {9{difference_1175[9]}};
  logic [9:0] sum_1177;
  assign sum_1177 = {9'h0, difference_1175[9]} + {1'b0, xor_1176};
  logic [9:0] difference_1179;
  assign difference_1179 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1180;
  assign xor_1180 = difference_1179[8:0] ^ {9{difference_1179[9]}};
  logic [9:0] sum_1181;
  assign sum_1181 = {9'h0, difference_1179[9]} + {1'b0, xor_1180};
  logic [10:0] sum_1182;
  assign sum_1182 = ({1'b0, sum_1174} + {1'b0, sum_1177}) + {1'b0, sum_1181};
  logic [9:0] difference_1183;
  assign difference_1183 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1184;
  assign xor_1184 = difference_1183[8:0] ^ {9{difference_1183[9]}};
  logic [9:0] sum_1185;
  assign sum_1185 = {9'h0, difference_1183[9]} + {1'b0, xor_1184};
  logic [9:0] difference_1187;
  assign difference_1187 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1188;
  assign xor_1188 = difference_1187[8:0] ^ {9{difference_1187[9]}};
  logic [9:0] sum_1189;
  assign sum_1189 = {9'h0, difference_1187[9]} + {1'b0, xor_1188};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1217;
  assign difference_1217 = {1'b0, select_357} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1217[9]} + (difference_1217[8:0] ^ {9{difference_1217[9]}});
  logic [9:0] difference_1228;
  assign difference_1228 = {1'b0, select_361} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1228[9]} + (difference_1228[8:0] ^ {9{difference_1228[9]}});
  // hls/stages/agreement.hpp:184
  logic and_1382;
  assign and_1382 = and_351_s3_q & (equal_405_s3_q & equal_1249_s3_q);
  // hls/stages/agreement.hpp:317
  logic and_1387;
  assign and_1387 = not_371_s3_q & (not_516_s3_q & (drew_s3_q & (not_374_s3_q & and_1383_s3_q)));
  // hls/stages/agreement.hpp:170
  logic [8:0] select_1432;
  assign select_1432 = less_373_s3_q ? 9'h0 : (and_926_s3_q ? {and_937, cfg_explained_limit_i} : 9'h0);
  // hls/stages/agreement.hpp:317
  logic [8:0] select_1435;
  assign select_1435 = equal_370_s3_q ? 9'h0 : (equal_372_s3_q ? 9'h0 : (drew_s3_q ? select_1432 : 9'h0));
  // hls/stages/agreement.hpp:503
  logic [23:0] sum_1436;
  assign sum_1436 = counts_too_little_explained_q + {{15{select_1435[8]}}, select_1435};
  // hls/stages/agreement.hpp:537
  logic [9:0] select_1470;
  assign select_1470 = (left_rdata_s3_q & and_1383_s3_q) ? ({1'b0, and_947, 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:317
  logic [9:0] select_1473;
  assign select_1473 = equal_372_s3_q ? 10'h0 : (drew_s3_q ? (less_373_s3_q ? 10'h0 : select_1470) : 10'h0);
  logic [9:0] select_1474;
  assign select_1474 = equal_370_s3_q ? 10'h0 : select_1473;
  // hls/stages/agreement.hpp:508
  logic [23:0] select_1476;
  assign select_1476 = and_1382 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1474[9]}}, select_1474});
  // hls/stages/agreement.hpp:537
  logic and_1478;
  assign and_1478 = and_937 & less_1477_s3_q;
  // hls/stages/registration.hpp:73
  logic equal_1481;
  assign equal_1481 = {lower_half_s3_q, less_1480_s3_q} == 2'h3;
  logic equal_1482;
  assign equal_1482 = {lower_half_s3_q, less_1480_s3_q} == 2'h2;
  logic equal_1483;
  assign equal_1483 = {lower_half_s3_q, less_1480_s3_q} == 2'h1;
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1514;
  assign sum_1514 = {difference_1513_s3_q, select_1511_s3_q} + {sum_1510_s3_q[9], sum_1510_s3_q[9:1]};
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1515;
  assign difference_1515 = {{4{best_left_rdata_s3_q[21]}}, best_left_rdata_s3_q[21:14]} - {sum_1514[9], sum_1514, sum_1510_s3_q[0]};
  // hls/stages/registration.hpp:158
  logic [11:0] select_1517;
  assign select_1517 = ($signed(difference_1515[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1515;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1517[11:7])) ? 12'h7f : select_1517;
  // hls/stages/registration.hpp:73
  logic not_1557;
  assign not_1557 = ~equal_1481;
  logic not_1558;
  assign not_1558 = ~equal_1482;
  // hls/stages/agreement.hpp:170
  logic and_1563;
  assign and_1563 = not_374_s3_q & (and_1478 & (not_1557 & (not_1558 & (~equal_1483))));
  // hls/stages/agreement.hpp:317
  logic and_1566;
  assign and_1566 = not_371_s3_q & (not_516_s3_q & (drew_s3_q & and_1563));
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1568;
  assign select_1568 = and_1382 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1566});
  // hls/stages/agreement.hpp:317
  logic and_1573;
  assign and_1573 = drew_s3_q & (not_374_s3_q & (and_1478 & (not_1557 & (equal_1483 & not_1558))));
  logic and_1575;
  assign and_1575 = not_371_s3_q & (not_516_s3_q & and_1573);
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1577;
  assign select_1577 = and_1382 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1575});
  // hls/stages/agreement.hpp:317
  logic and_1581;
  assign and_1581 = drew_s3_q & (not_374_s3_q & (and_1478 & (equal_1482 & not_1557)));
  logic and_1583;
  assign and_1583 = not_371_s3_q & (not_516_s3_q & and_1581);
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1585;
  assign select_1585 = and_1382 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1583});
  // hls/stages/agreement.hpp:317
  logic and_1589;
  assign and_1589 = not_516_s3_q & (drew_s3_q & (not_374_s3_q & (and_1478 & equal_1481)));
  logic and_1590;
  assign and_1590 = not_371_s3_q & and_1589;
  // hls/stages/agreement.hpp:509
  logic [11:0] select_1592;
  assign select_1592 = and_1382 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1590});
  // hls/stages/registration.hpp:146
  logic less_1593;
  assign less_1593 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:170
  logic and_1594;
  assign and_1594 = and_1478 & less_1593;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1597;
  assign select_1597 = equal_372_s3_q ? 2'h0 : (drew_s3_q ? (less_373_s3_q ? 2'h0 : {and_1594, and_1478}) : 2'h0);
  logic [1:0] select_1598;
  assign select_1598 = equal_370_s3_q ? 2'h0 : select_1597;
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1599;
  assign sum_1599 = registration_counts_votes_0_down_q + {{13{select_1598[1]}}, select_1598};
  // hls/stages/registration.hpp:146
  logic [12:0] difference_1601;
  assign difference_1601 = 13'h0 - {residual[11], residual};
  logic less_1602;
  assign less_1602 = $signed(difference_1601) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:170
  logic and_1603;
  assign and_1603 = and_1478 & less_1602;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1606;
  assign select_1606 = equal_372_s3_q ? 2'h0 : (drew_s3_q ? (less_373_s3_q ? 2'h0 : {and_1603, and_1478}) : 2'h0);
  logic [1:0] select_1607;
  assign select_1607 = equal_370_s3_q ? 2'h0 : select_1606;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1608;
  assign sum_1608 = registration_counts_votes_0_up_q + {{13{select_1607[1]}}, select_1607};
  // hls/stages/registration.hpp:80
  logic not_1610;
  assign not_1610 = ~less_1480_s3_q;
  // hls/stages/registration.hpp:79
  logic and_1611;
  assign and_1611 = less_1593 & not_1610;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1614;
  assign select_1614 = drew_s3_q ? (less_373_s3_q ? 2'h0 : (and_1478 ? {and_1611, not_1610} : 2'h0)) : 2'h0;
  logic [1:0] select_1616;
  assign select_1616 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : select_1614);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1617;
  assign sum_1617 = registration_counts_votes_1_down_q + {{13{select_1616[1]}}, select_1616};
  // hls/stages/registration.hpp:79
  logic and_1619;
  assign and_1619 = less_1602 & not_1610;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1622;
  assign select_1622 = drew_s3_q ? (less_373_s3_q ? 2'h0 : (and_1478 ? {and_1619, not_1610} : 2'h0)) : 2'h0;
  logic [1:0] select_1624;
  assign select_1624 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : select_1622);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1625;
  assign sum_1625 = registration_counts_votes_1_up_q + {{13{select_1624[1]}}, select_1624};
  // hls/stages/registration.hpp:79
  logic and_1627;
  assign and_1627 = less_1480_s3_q & less_1593;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1629;
  assign select_1629 = less_373_s3_q ? 2'h0 : (and_1478 ? {and_1627, less_1480_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1632;
  assign select_1632 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : (drew_s3_q ? select_1629 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1633;
  assign sum_1633 = registration_counts_votes_2_down_q + {{13{select_1632[1]}}, select_1632};
  // hls/stages/registration.hpp:79
  logic and_1635;
  assign and_1635 = less_1480_s3_q & less_1602;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1637;
  assign select_1637 = less_373_s3_q ? 2'h0 : (and_1478 ? {and_1635, less_1480_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1640;
  assign select_1640 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : (drew_s3_q ? select_1637 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1641;
  assign sum_1641 = registration_counts_votes_2_up_q + {{13{select_1640[1]}}, select_1640};
  // hls/stages/registration.hpp:80
  logic not_1643;
  assign not_1643 = ~lower_half_s3_q;
  // hls/stages/agreement.hpp:170
  logic and_1644;
  assign and_1644 = less_1593 & not_1643;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1647;
  assign select_1647 = drew_s3_q ? (less_373_s3_q ? 2'h0 : (and_1478 ? {and_1644, not_1643} : 2'h0)) : 2'h0;
  logic [1:0] select_1649;
  assign select_1649 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : select_1647);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1650;
  assign sum_1650 = registration_counts_votes_3_down_q + {{13{select_1649[1]}}, select_1649};
  // hls/stages/agreement.hpp:170
  logic and_1652;
  assign and_1652 = less_1602 & not_1643;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1655;
  assign select_1655 = drew_s3_q ? (less_373_s3_q ? 2'h0 : (and_1478 ? {and_1652, not_1643} : 2'h0)) : 2'h0;
  logic [1:0] select_1657;
  assign select_1657 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : select_1655);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1658;
  assign sum_1658 = registration_counts_votes_3_up_q + {{13{select_1657[1]}}, select_1657};
  // hls/stages/agreement.hpp:170
  logic and_1660;
  assign and_1660 = lower_half_s3_q & less_1593;
  logic [1:0] select_1662;
  assign select_1662 = less_373_s3_q ? 2'h0 : (and_1478 ? {and_1660, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1665;
  assign select_1665 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : (drew_s3_q ? select_1662 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1666;
  assign sum_1666 = registration_counts_votes_4_down_q + {{13{select_1665[1]}}, select_1665};
  // hls/stages/agreement.hpp:170
  logic and_1668;
  assign and_1668 = lower_half_s3_q & less_1602;
  logic [1:0] select_1670;
  assign select_1670 = less_373_s3_q ? 2'h0 : (and_1478 ? {and_1668, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1673;
  assign select_1673 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : (drew_s3_q ? select_1670 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1674;
  assign sum_1674 = registration_counts_votes_4_up_q + {{13{select_1673[1]}}, select_1673};
  // hls/stages/registration.hpp:146
  logic less_1676;
  assign less_1676 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1677;
  assign and_1677 = not_1610 & less_1676;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1680;
  assign select_1680 = drew_s3_q ? (less_373_s3_q ? 2'h0 : (and_1478 ? {and_1677, not_1610} : 2'h0)) : 2'h0;
  logic [1:0] select_1682;
  assign select_1682 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : select_1680);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1683;
  assign sum_1683 = registration_counts_half_votes_0_down_q + {{13{select_1682[1]}}, select_1682};
  // hls/stages/registration.hpp:146
  logic less_1685;
  assign less_1685 = $signed(difference_1601) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1686;
  assign and_1686 = not_1610 & less_1685;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1689;
  assign select_1689 = drew_s3_q ? (less_373_s3_q ? 2'h0 : (and_1478 ? {and_1686, not_1610} : 2'h0)) : 2'h0;
  logic [1:0] select_1691;
  assign select_1691 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : select_1689);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1692;
  assign sum_1692 = registration_counts_half_votes_0_up_q + {{13{select_1691[1]}}, select_1691};
  // hls/stages/registration.hpp:79
  logic and_1694;
  assign and_1694 = less_1480_s3_q & less_1676;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1696;
  assign select_1696 = less_373_s3_q ? 2'h0 : (and_1478 ? {and_1694, less_1480_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1699;
  assign select_1699 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : (drew_s3_q ? select_1696 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1700;
  assign sum_1700 = registration_counts_half_votes_1_down_q + {{13{select_1699[1]}}, select_1699};
  // hls/stages/registration.hpp:79
  logic and_1702;
  assign and_1702 = less_1480_s3_q & less_1685;
  // hls/stages/agreement.hpp:170
  logic [1:0] select_1704;
  assign select_1704 = less_373_s3_q ? 2'h0 : (and_1478 ? {and_1702, less_1480_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1707;
  assign select_1707 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : (drew_s3_q ? select_1704 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1708;
  assign sum_1708 = registration_counts_half_votes_1_up_q + {{13{select_1707[1]}}, select_1707};
  // hls/stages/agreement.hpp:170
  logic and_1710;
  assign and_1710 = less_1676 & not_1643;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1713;
  assign select_1713 = drew_s3_q ? (less_373_s3_q ? 2'h0 : (and_1478 ? {and_1710, not_1643} : 2'h0)) : 2'h0;
  logic [1:0] select_1715;
  assign select_1715 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : select_1713);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1716;
  assign sum_1716 = registration_counts_half_votes_2_down_q + {{13{select_1715[1]}}, select_1715};
  // hls/stages/agreement.hpp:170
  logic and_1718;
  assign and_1718 = less_1685 & not_1643;
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1721;
  assign select_1721 = drew_s3_q ? (less_373_s3_q ? 2'h0 : (and_1478 ? {and_1718, not_1643} : 2'h0)) : 2'h0;
  logic [1:0] select_1723;
  assign select_1723 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : select_1721);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1724;
  assign sum_1724 = registration_counts_half_votes_2_up_q + {{13{select_1723[1]}}, select_1723};
  // hls/stages/agreement.hpp:170
  logic and_1726;
  assign and_1726 = lower_half_s3_q & less_1676;
  logic [1:0] select_1728;
  assign select_1728 = less_373_s3_q ? 2'h0 : (and_1478 ? {and_1726, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1731;
  assign select_1731 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : (drew_s3_q ? select_1728 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1732;
  assign sum_1732 = registration_counts_half_votes_3_down_q + {{13{select_1731[1]}}, select_1731};
  // hls/stages/agreement.hpp:170
  logic and_1734;
  assign and_1734 = lower_half_s3_q & less_1685;
  logic [1:0] select_1736;
  assign select_1736 = less_373_s3_q ? 2'h0 : (and_1478 ? {and_1734, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:317
  logic [1:0] select_1739;
  assign select_1739 = equal_370_s3_q ? 2'h0 : (equal_372_s3_q ? 2'h0 : (drew_s3_q ? select_1736 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1740;
  assign sum_1740 = registration_counts_half_votes_3_up_q + {{13{select_1739[1]}}, select_1739};
  // hls/stages/division.hpp:34
  logic [7:0] sum_1754;
  assign sum_1754 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:264
  logic [2:0] select_1756;
  assign select_1756 = less_1753_s3_q ? (sum_1754[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1758;
  assign select_1758 = equal_1249_s3_q ? (equal_405_s3_q ? 3'h0 : select_1756) : region_row_q;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1762;
  assign select_1762 = equal_370_s3_q ? select_899 : (equal_372_s3_q ? select_899 : (drew_s3_q ? select_1006 : 8'h1));
  // hls/stages/division.hpp:35
  logic [8:0] sum_1763;
  assign sum_1763 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1764;
  assign select_1764 = sum_910[5] ? {1'b1, sum_910[4:0], region_across_rest_q[2:0]} : sum_1763;
  // hls/stages/agreement.hpp:264
  logic [8:0] select_1768;
  assign select_1768 = equal_1249_s3_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_1771;
  assign select_1771 = equal_1249_s3_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  logic [8:0] select_1775;
  assign select_1775 = equal_405_s3_q ? {{2{difference_1773[6]}}, difference_1773} : (less_1753_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:184
  logic [8:0] select_1777;
  assign select_1777 = and_351_s3_q ? (equal_1249_s3_q ? select_1775 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:264
  logic [6:0] select_1779;
  assign select_1779 = equal_405_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1781;
  assign select_1781 = and_351_s3_q ? (equal_1249_s3_q ? select_1779 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1782;
  assign sum_1782 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1783;
  assign select_1783 = sum_1754[7] ? {1'b1, sum_1754[6:0], region_down_rest_q[0]} : sum_1782;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1754[7];
  // hls/stages/agreement.hpp:264
  logic select_1787;
  assign select_1787 = equal_1249_s3_q ? (equal_405_s3_q | (less_1753_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:142
  logic or_1792;
  assign or_1792 = segment_starts_q | not_1295_s3_q;
  // hls/stages/agreement.hpp:542
  logic select_1795;
  assign select_1795 = less_373_s3_q ? or_1792 : (sum_910[5] ? (equal_912_s3_q & or_913) : or_913);
  // hls/stages/agreement.hpp:317
  logic select_1798;
  assign select_1798 = equal_370_s3_q ? or_1792 : (equal_372_s3_q ? or_1792 : (drew_s3_q ? select_1795 : or_1792));
  // hls/stages/agreement.hpp:654
  logic equal_1800;
  assign equal_1800 = x_s3_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:656
  logic [7:0] select_1824;
  assign select_1824 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1826;
  assign select_1826 = equal_915_s3_q ? (equal_1800 ? select_1824 : hidden_for_q) : hidden_for_q;
  logic [7:0] select_1828;
  assign select_1828 = equal_372_s3_q ? hidden_for_q : (drew_s3_q ? hidden_for_q : select_1826);
  // hls/stages/agreement.hpp:144
  logic not_1830;
  assign not_1830 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:317
  logic select_1905;
  assign select_1905 = drew_s3_q ? (seen_columns_rdata_q[4] & not_374_s3_q) : centres_values_0_textured_q;
  logic select_1907;
  assign select_1907 = equal_370_s3_q ? centres_values_0_textured_q : (equal_372_s3_q ? centres_values_0_textured_q : select_1905);
  logic select_1909;
  assign select_1909 = drew_s3_q ? (seen_columns_rdata_q[5] & not_374_s3_q) : centres_values_0_of_skin_q;
  logic select_1911;
  assign select_1911 = equal_370_s3_q ? centres_values_0_of_skin_q : (equal_372_s3_q ? centres_values_0_of_skin_q : select_1909);
  logic select_1912;
  assign select_1912 = drew_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_1914;
  assign select_1914 = equal_370_s3_q ? centres_values_1_textured_q : (equal_372_s3_q ? centres_values_1_textured_q : select_1912);
  logic select_1915;
  assign select_1915 = drew_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_1917;
  assign select_1917 = equal_370_s3_q ? centres_values_1_of_skin_q : (equal_372_s3_q ? centres_values_1_of_skin_q : select_1915);
  // hls/stages/agreement.hpp:264
  logic [12:0] select_1921;
  assign select_1921 = equal_1249_s3_q ? (equal_1918_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:184
  logic [6:0] select_1924;
  assign select_1924 = and_351_s3_q ? (equal_1249_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:317
  logic and_1935;
  assign and_1935 = not_371_s3_q & (not_516_s3_q & (not_1295_s3_q & (equal_915_s3_q & equal_1800)));
  // hls/stages/agreement.hpp:759
  logic [2:0] select_1939;
  assign select_1939 = marks_first_s3_q ? 3'h0 : (select_967 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:185
  logic [7:0] select_1944;
  assign select_1944 = marks_first_s3_q ? (less_1940 ? {sum_1941, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:763
  logic and_1950;
  assign and_1950 = and_1057_s3_q & ({sum_992, index_2[5:0]} == {sum_979, index[5:0]});
  // hls/stages/agreement.hpp:317
  logic and_1996;
  assign and_1996 = not_1295_s3_q & (equal_915_s3_q & (equal_1800 & (cfg_prove_i & (~proven_q))));
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2022;
  assign sum_2022 = {1'b0, upper} + {1'b0, lower};
  logic less_2023;
  assign less_2023 = 11'h4 < sum_2022[13:3];
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};
  // hls/stages/registration.hpp:100
  logic less_2026;
  assign less_2026 = 11'he < left[12:2];
  // hls/stages/registration.hpp:119
  logic less_2028;
  assign less_2028 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_2029;
  assign or_2029 = (~less_2026) | less_2028;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:100
  logic less_2031;
  assign less_2031 = 11'he < right[12:2];
  // hls/stages/registration.hpp:119
  logic less_2033;
  assign less_2033 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic select_2035;
  assign select_2035 = less_2023 ? (or_2029 ? less_2028 : less_2033) : less_2033;
  logic or_2036;
  assign or_2036 = (~less_2031) | select_2035;
  // hls/stages/registration.hpp:100
  logic less_2037;
  assign less_2037 = 11'he < upper[12:2];
  // hls/stages/registration.hpp:119
  logic less_2039;
  assign less_2039 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/registration.hpp:104
  logic select_2040;
  assign select_2040 = or_2036 ? select_2035 : less_2039;
  logic select_2042;
  assign select_2042 = less_2023 ? select_2040 : (less_2026 ? select_2040 : less_2039);
  logic or_2043;
  assign or_2043 = (~less_2037) | select_2042;
  // hls/stages/registration.hpp:119
  logic less_2044;
  assign less_2044 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_2045;
  assign select_2045 = or_2043 ? select_2042 : less_2044;
  logic select_2048;
  assign select_2048 = less_2023 ? select_2045 : (less_2026 ? select_2045 : (less_2031 ? select_2045 : less_2044));
  // hls/stages/registration.hpp:101
  logic less_2049;
  assign less_2049 = 11'he < lower[12:2];
  // hls/stages/registration.hpp:104
  logic or_2051;
  assign or_2051 = select_2048 | (~less_2049);
  // hls/stages/registration.hpp:119
  logic less_2052;
  assign less_2052 = $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
  // hls/stages/registration.hpp:105
  logic select_2053;
  assign select_2053 = or_2051 ? select_2048 : less_2052;
  logic select_2056;
  assign select_2056 = less_2026 ? select_2053 : (less_2031 ? select_2053 : (less_2037 ? select_2053 : less_2052));
  // hls/stages/agreement.hpp:658
  logic and_2068;
  assign and_2068 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2069;
  assign or_2069 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2068;
  logic select_2070;
  assign select_2070 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2069 : and_2068;
  logic and_2071;
  assign and_2071 = (less_2037 & less_2049) & select_2070;
  logic or_2072;
  assign or_2072 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2071;
  logic select_2073;
  assign select_2073 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2072 : and_2071;
  logic or_2074;
  assign or_2074 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2073;
  logic select_2075;
  assign select_2075 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2074 : select_2073;
  logic select_2076;
  assign select_2076 = (less_2026 & less_2031) ? select_2075 : and_2071;
  logic or_2077;
  assign or_2077 = (less_2023 ? select_2053 : select_2056) | select_2076;
  // hls/stages/registration.hpp:119
  logic less_2078;
  assign less_2078 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  // hls/stages/agreement.hpp:658
  logic or_2079;
  assign or_2079 = less_2078 | or_2077;
  logic select_2080;
  assign select_2080 = or_2051 ? or_2077 : or_2079;
  // hls/stages/registration.hpp:119
  logic less_2081;
  assign less_2081 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2084;
  assign less_2084 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2087;
  assign less_2087 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:658
  logic and_2129;
  assign and_2129 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1824 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:317
  logic and_2133;
  assign and_2133 = not_1295_s3_q & (equal_915_s3_q & (equal_1800 & (cfg_prove_i & and_2129)));
  logic [11:0] select_2157;
  assign select_2157 = equal_915_s3_q ? (equal_1800 ? registration_counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2160;
  assign select_2160 = equal_370_s3_q ? 12'h0 : (equal_372_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2157));
  logic [11:0] select_2162;
  assign select_2162 = equal_915_s3_q ? (equal_1800 ? registration_counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2165;
  assign select_2165 = equal_370_s3_q ? 12'h0 : (equal_372_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2162));
  logic [11:0] select_2167;
  assign select_2167 = equal_915_s3_q ? (equal_1800 ? registration_counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2170;
  assign select_2170 = equal_370_s3_q ? 12'h0 : (equal_372_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2167));
  logic [11:0] select_2172;
  assign select_2172 = equal_915_s3_q ? (equal_1800 ? registration_counts_measured_3_q : 12'h0) : 12'h0;
  logic [11:0] select_2175;
  assign select_2175 = equal_370_s3_q ? 12'h0 : (equal_372_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2172));

  // Memory regions, 64 x 36 and parity, DISTANCE 12, hls/stages/agreement.hpp:822; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [36:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 37'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = drew_s3_q ? {region_row_q, or_908, or_905, or_902} : x_s3_q[5:0];
  logic regions_re;
  assign regions_re = s3_en & (not_371_s3_q & (not_516_s3_q & (drew_s3_q ? and_914 : and_918)));
  logic [36:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [35:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[35:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:841; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_979, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_986 & less_987);
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
  assign census_memory_waddr = column_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_351_s3_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_369_s3_q, whole_2_s3_q, select_361, select_357};
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

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = partner_s3_q;
  logic best_right_we;
  assign best_right_we = s3_en & and_883_s3_q;
  logic [14:0] best_right_wdata;
  assign best_right_wdata = {select_898, select_894};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {^best_right_wdata, best_right_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 7'd80) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd80) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s3_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_957_s3_q;
  logic [13:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[10:6], seen_columns_rdata_q[4:0], near, explained, and_959, textured};
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
    end else if (s3_en) begin
      census_filled_q <= and_351_s3_q ? {select_408[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_351_s3_q ? select_407 : rows_passed_above_q;
      counts_too_little_explained_q <= and_1382 ? 24'h0 : sum_1436;
      counts_too_much_hidden_q <= select_1476;
      registration_counts_measured_0_q <= select_1568;
      registration_counts_measured_1_q <= select_1577;
      registration_counts_measured_2_q <= select_1585;
      registration_counts_measured_3_q <= select_1592;
      registration_counts_votes_0_down_q <= and_1382 ? 15'h0 : sum_1599;
      registration_counts_votes_0_up_q <= and_1382 ? 15'h0 : sum_1608;
      registration_counts_votes_1_down_q <= and_1382 ? 15'h0 : sum_1617;
      registration_counts_votes_1_up_q <= and_1382 ? 15'h0 : sum_1625;
      registration_counts_votes_2_down_q <= and_1382 ? 15'h0 : sum_1633;
      registration_counts_votes_2_up_q <= and_1382 ? 15'h0 : sum_1641;
      registration_counts_votes_3_down_q <= and_1382 ? 15'h0 : sum_1650;
      registration_counts_votes_3_up_q <= and_1382 ? 15'h0 : sum_1658;
      registration_counts_votes_4_down_q <= and_1382 ? 15'h0 : sum_1666;
      registration_counts_votes_4_up_q <= and_1382 ? 15'h0 : sum_1674;
      registration_counts_half_votes_0_down_q <= and_1382 ? 15'h0 : sum_1683;
      registration_counts_half_votes_0_up_q <= and_1382 ? 15'h0 : sum_1692;
      registration_counts_half_votes_1_down_q <= and_1382 ? 15'h0 : sum_1700;
      registration_counts_half_votes_1_up_q <= and_1382 ? 15'h0 : sum_1708;
      registration_counts_half_votes_2_down_q <= and_1382 ? 15'h0 : sum_1716;
      registration_counts_half_votes_2_up_q <= and_1382 ? 15'h0 : sum_1724;
      registration_counts_half_votes_3_down_q <= and_1382 ? 15'h0 : sum_1732;
      registration_counts_half_votes_3_up_q <= and_1382 ? 15'h0 : sum_1740;
      region_row_q <= and_351_s3_q ? select_1758 : region_row_q;
      region_columns_q <= select_1762;
      region_across_rest_q <= drew_s3_q ? select_1764 : columns_begin_rest_q;
      region_across_back_q <= drew_s3_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_351_s3_q ? select_1768 : columns_begin_rest_q;
      columns_begin_back_q <= and_351_s3_q ? select_1771 : columns_begin_back_q;
      region_down_rest_q <= select_1777;
      region_down_back_q <= select_1781;
      region_down_next_q <= select_1783;
      region_fresh_q <= and_351_s3_q ? select_1787 : region_fresh_q;
      segment_starts_q <= select_1798;
      hidden_for_q <= equal_370_s3_q ? hidden_for_q : select_1828;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1830};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s3_q;
      centres_values_0_textured_q <= select_1907;
      centres_values_0_of_skin_q <= select_1911;
      centres_values_1_textured_q <= select_1914;
      centres_values_1_of_skin_q <= select_1917;
      map_row_q <= and_351_s3_q ? select_1921 : map_row_q;
      map_width_q <= select_1924;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_978;
      done_q <= not_980 & ((~begins_product_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      said_q <= and_1935;
      rows_passed_q <= select_963;
      columns_passed_q <= {select_965[7:0], or_961};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_982;
      seen_x_q <= select_984;
      seen_y_q <= select_1939;
      seen_column_q <= select_975;
      seen_rows_left_q <= select_1944;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_972;
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
      averager_total_0_q <= select_1089;
      averager_total_1_q <= select_1091;
      census_columns_values_0_cell_0_left_q <= select_1115;
      census_columns_values_0_cell_0_right_q <= select_1116;
      census_columns_values_0_cell_0_mask_q <= select_1117;
      census_columns_values_0_cell_1_left_q <= select_1118;
      census_columns_values_0_cell_1_right_q <= select_1119;
      census_columns_values_0_cell_1_mask_q <= select_1120;
      census_columns_values_0_cell_2_left_q <= select_1121;
      census_columns_values_0_cell_2_right_q <= select_1122;
      census_columns_values_0_cell_2_mask_q <= select_1123;
      census_columns_values_0_cell_2_of_skin_q <= select_1124;
      census_columns_values_0_cell_3_left_q <= select_1125;
      census_columns_values_0_cell_3_right_q <= select_1126;
      census_columns_values_0_cell_3_mask_q <= select_1127;
      census_columns_values_0_cell_4_left_q <= select_1128;
      census_columns_values_0_cell_4_right_q <= select_1129;
      census_columns_values_0_cell_4_mask_q <= select_1130;
      census_columns_values_1_cell_0_left_q <= select_1131;
      census_columns_values_1_cell_0_right_q <= select_1132;
      census_columns_values_1_cell_0_mask_q <= select_1133;
      census_columns_values_1_cell_1_left_q <= select_1134;
      census_columns_values_1_cell_1_right_q <= select_1135;
      census_columns_values_1_cell_1_mask_q <= select_1136;
      census_columns_values_1_cell_2_left_q <= select_1137;
      census_columns_values_1_cell_2_right_q <= select_1138;
      census_columns_values_1_cell_2_mask_q <= select_1139;
      census_columns_values_1_cell_2_of_skin_q <= select_1140;
      census_columns_values_1_cell_3_left_q <= select_1141;
      census_columns_values_1_cell_3_right_q <= select_1142;
      census_columns_values_1_cell_3_mask_q <= select_1143;
      census_columns_values_1_cell_4_left_q <= select_1144;
      census_columns_values_1_cell_4_right_q <= select_1145;
      census_columns_values_1_cell_4_mask_q <= select_1146;
      census_columns_values_2_cell_0_left_q <= select_1147;
      census_columns_values_2_cell_0_right_q <= select_1148;
      census_columns_values_2_cell_0_mask_q <= select_1149;
      census_columns_values_2_cell_1_left_q <= select_1150;
      census_columns_values_2_cell_1_right_q <= select_1151;
      census_columns_values_2_cell_1_mask_q <= select_1152;
      census_columns_values_2_cell_2_left_q <= select_1153;
      census_columns_values_2_cell_2_right_q <= select_1154;
      census_columns_values_2_cell_2_mask_q <= select_1155;
      census_columns_values_2_cell_3_left_q <= select_1156;
      census_columns_values_2_cell_3_right_q <= select_1157;
      census_columns_values_2_cell_3_mask_q <= select_1158;
      census_columns_values_2_cell_4_left_q <= select_1159;
      census_columns_values_2_cell_4_right_q <= select_1160;
      census_columns_values_2_cell_4_mask_q <= select_1161;
      census_columns_values_3_cell_0_mask_q <= select_1162;
      census_columns_values_3_cell_1_left_q <= select_1163;
      census_columns_values_3_cell_1_right_q <= select_1164;
      census_columns_values_3_cell_1_mask_q <= select_1165;
      census_columns_values_3_cell_2_mask_q <= select_1166;
      census_columns_values_3_cell_3_left_q <= select_1167;
      census_columns_values_3_cell_3_right_q <= select_1168;
      census_columns_values_3_cell_3_mask_q <= select_1169;
      census_columns_values_3_cell_4_mask_q <= select_1170;
      sharpness_last_mean_0_q <= and_351_s3_q ? select_357 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_351_s3_q ? select_361 : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic sample_pair_whole_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [5:0] x_s4_q;
  logic age_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic begins_product_s4_q;
  logic centres_values_1_textured_s4_q;
  logic centres_values_1_of_skin_s4_q;
  logic [6:0] column_s4_q;
  logic and_349_s4_q;
  logic and_351_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_354_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic equal_370_s4_q;
  logic not_371_s4_q;
  logic equal_372_s4_q;
  logic less_373_s4_q;
  logic not_374_s4_q;
  logic less_378_s4_q;
  logic less_379_s4_q;
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
  logic and_409_s4_q;
  logic and_434_s4_q;
  logic and_435_s4_q;
  logic [11:0] texture_s4_q;
  logic [6:0] x_s4_2_q;
  logic not_516_s4_q;
  logic [7:0] best_left_rdata_s4_q;
  logic equal_521_s4_q;
  logic select_817_s4_q;
  logic less_823_s4_q;
  logic less_824_s4_q;
  logic or_826_s4_q;
  logic [7:0] select_830_s4_q;
  logic [5:0] select_834_s4_q;
  logic equal_839_s4_q;
  logic rise_s4_q;
  logic [1:0] sum_851_s4_q;
  logic [7:0] twice_s4_q;
  logic [8:0] difference_863_s4_q;
  logic and_883_s4_q;
  logic or_902_s4_q;
  logic or_905_s4_q;
  logic or_908_s4_q;
  logic equal_915_s4_q;
  logic equal_916_s4_q;
  logic and_926_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_949_s4_q;
  logic and_956_s4_q;
  logic and_986_s4_q;
  logic less_987_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_992_s4_q;
  logic [2:0] textured_2_s4_q;
  logic equal_1001_s4_q;
  logic or_1009_s4_q;
  logic or_1012_s4_q;
  logic or_1015_s4_q;
  logic [2:0] explained_2_s4_q;
  logic [2:0] near_2_s4_q;
  logic and_1057_s4_q;
  logic [11:0] sum_1190_s4_q;
  logic equal_1197_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic not_1295_s4_q;
  logic and_1382_s4_q;
  logic and_1387_s4_q;
  logic equal_1405_s4_q;
  logic and_1478_s4_q;
  logic equal_1481_s4_q;
  logic equal_1482_s4_q;
  logic equal_1483_s4_q;
  logic [7:0] residual_s4_q;
  logic equal_1800_s4_q;
  logic less_1806_s4_q;
  logic and_1950_s4_q;
  logic and_1998_s4_q;
  logic less_2023_s4_q;
  logic less_2024_s4_q;
  logic less_2026_s4_q;
  logic or_2029_s4_q;
  logic less_2031_s4_q;
  logic or_2036_s4_q;
  logic less_2037_s4_q;
  logic or_2043_s4_q;
  logic select_2080_s4_q;
  logic or_2082_s4_q;
  logic less_2084_s4_q;
  logic less_2087_s4_q;
  logic select_2091_s4_q;
  logic and_2135_s4_q;
  logic [11:0] select_2160_s4_q;
  logic [11:0] select_2165_s4_q;
  logic [11:0] select_2170_s4_q;
  logic [11:0] select_2175_s4_q;
  logic and_2198_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s4_q <= x_s3_q[5:0];
      age_s4_q <= age_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      begins_product_s4_q <= begins_product_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      column_s4_q <= column_s3_q;
      and_349_s4_q <= and_349_s3_q;
      and_351_s4_q <= and_351_s3_q;
      grey_s4_q <= grey_s3_q;
      equal_354_s4_q <= equal_354_s3_q;
      grey_2_s4_q <= grey_2_s3_q;
      whole_2_s4_q <= whole_2_s3_q;
      equal_370_s4_q <= equal_370_s3_q;
      not_371_s4_q <= not_371_s3_q;
      equal_372_s4_q <= equal_372_s3_q;
      less_373_s4_q <= less_373_s3_q;
      not_374_s4_q <= not_374_s3_q;
      less_378_s4_q <= less_378;
      less_379_s4_q <= less_379;
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
      and_409_s4_q <= and_409;
      and_434_s4_q <= whole_22 & and_409;
      and_435_s4_q <= census_columns_values_1_cell_2_mask_q & and_409;
      texture_s4_q <= texture;
      x_s4_2_q <= x_s3_2_q;
      not_516_s4_q <= not_516_s3_q;
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      equal_521_s4_q <= equal_521_s3_q;
      select_817_s4_q <= select_817[0];
      less_823_s4_q <= less_823;
      less_824_s4_q <= less_824;
      or_826_s4_q <= or_826;
      select_830_s4_q <= equal_521_s3_q ? of_best_2 : select_829;
      select_834_s4_q <= equal_521_s3_q ? run_shift_s3_q : select_833;
      equal_839_s4_q <= {less_816, select_817} == near_best;
      rise_s4_q <= rise[8];
      sum_851_s4_q <= {less_816, select_817[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_863_s4_q <= {1'b0, twice} - (({twice, 1'b0} < size) ? {twice, 1'b0} : size);
      and_883_s4_q <= and_883_s3_q;
      or_902_s4_q <= or_902;
      or_905_s4_q <= or_905;
      or_908_s4_q <= or_908;
      equal_915_s4_q <= equal_915_s3_q;
      equal_916_s4_q <= equal_916;
      and_926_s4_q <= and_926_s3_q;
      textured_s4_q <= textured;
      explained_s4_q <= explained;
      and_949_s4_q <= not_374_s3_q & (left_rdata_s3_q & and_947);
      and_956_s4_q <= not_371_s3_q & (not_516_s3_q & (drew_s3_q & and_914));
      and_986_s4_q <= and_986;
      less_987_s4_q <= less_987;
      index_2_s4_q <= index_2[5:0];
      sum_992_s4_q <= sum_992;
      textured_2_s4_q <= textured_2;
      equal_1001_s4_q <= x_s3_q == 8'h0;
      or_1009_s4_q <= or_1009;
      or_1012_s4_q <= select_1006[7] | (~({select_1006[6], select_1006[3:2]} == 3'h0));
      or_1015_s4_q <= select_1006[7] | (~(select_1006[6:4] == 3'h0));
      explained_2_s4_q <= explained_2;
      near_2_s4_q <= near_2;
      and_1057_s4_q <= and_1057_s3_q;
      sum_1190_s4_q <= ({1'b0, sum_1182} + {2'h0, sum_1185}) + {2'h0, sum_1189};
      equal_1197_s4_q <= equal_1197_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      not_1295_s4_q <= not_1295_s3_q;
      and_1382_s4_q <= and_1382;
      and_1387_s4_q <= and_1387;
      equal_1405_s4_q <= x_s3_q[7:1] == 7'h0;
      and_1478_s4_q <= and_1478;
      equal_1481_s4_q <= equal_1481;
      equal_1482_s4_q <= equal_1482;
      equal_1483_s4_q <= equal_1483;
      residual_s4_q <= residual[7:0];
      equal_1800_s4_q <= equal_1800;
      less_1806_s4_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      and_1950_s4_q <= and_1950;
      and_1998_s4_q <= not_371_s3_q & (not_516_s3_q & and_1996);
      less_2023_s4_q <= less_2023;
      less_2024_s4_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2026_s4_q <= less_2026;
      or_2029_s4_q <= or_2029;
      less_2031_s4_q <= less_2031;
      or_2036_s4_q <= or_2036;
      less_2037_s4_q <= less_2037;
      or_2043_s4_q <= or_2043;
      select_2080_s4_q <= select_2080;
      or_2082_s4_q <= less_2081 | select_2080;
      less_2084_s4_q <= less_2084;
      less_2087_s4_q <= less_2087;
      select_2091_s4_q <= less_2049 ? or_2079 : select_2076;
      and_2135_s4_q <= not_371_s3_q & (not_516_s3_q & and_2133);
      select_2160_s4_q <= select_2160;
      select_2165_s4_q <= select_2165;
      select_2170_s4_q <= select_2170;
      select_2175_s4_q <= select_2175;
      and_2198_s4_q <= not_371_s3_q & (not_516_s3_q & (not_1295_s3_q & and_918));
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
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:201
  logic [12:0] sum_455;
  assign sum_455 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_457;
  assign sum_457 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_455});
  // hls/stages/census.hpp:223
  logic less_458;
  assign less_458 = 9'h4 < sum_457[13:5];
  logic and_459;
  assign and_459 = and_409_s4_q & less_458;
  // hls/stages/registration.hpp:28
  logic not_864;
  assign not_864 = ~difference_863_s4_q[8];
  logic [7:0] xor_865;
  assign xor_865 = twice_s4_q ^ {8{not_864}};
  logic [9:0] sum_866;
  assign sum_866 = {difference_863_s4_q[7:0], 1'b0, not_864} + {not_864, xor_865, not_864};
  logic not_867;
  assign not_867 = ~sum_866[9];
  logic [7:0] xor_868;
  assign xor_868 = twice_s4_q ^ {8{not_867}};
  logic [9:0] sum_869;
  assign sum_869 = {sum_866[8:0], not_867} + {not_867, xor_868, not_867};
  logic not_870;
  assign not_870 = ~sum_869[9];
  logic [7:0] xor_871;
  assign xor_871 = twice_s4_q ^ {8{not_870}};
  logic [9:0] sum_872;
  assign sum_872 = {sum_869[8:0], not_870} + {not_870, xor_871, not_870};
  logic not_873;
  assign not_873 = ~sum_872[9];
  logic [7:0] xor_874;
  assign xor_874 = twice_s4_q ^ {8{not_873}};
  logic [9:0] sum_875;
  assign sum_875 = {sum_872[8:0], not_873} + {not_873, xor_874, not_873};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_876;
  assign difference_876 = {sum_851_s4_q, select_817_s4_q, 5'h0} - {3'h0, difference_863_s4_q[8], sum_866[9], sum_869[9], sum_872[9], sum_875[9]};
  // hls/stages/agreement.hpp:446
  logic [7:0] select_877;
  assign select_877 = rise_s4_q ? difference_876 : {sum_851_s4_q, select_817_s4_q, difference_863_s4_q[8], sum_866[9], sum_869[9], sum_872[9], sum_875[9]};
  logic [7:0] select_878;
  assign select_878 = equal_839_s4_q ? select_877 : {sum_851_s4_q, select_817_s4_q, 5'h0};
  // hls/stages/agreement.hpp:448
  logic [7:0] select_881;
  assign select_881 = less_823_s4_q ? (or_826_s4_q ? select_878 : best_left_rdata_s4_q) : (less_824_s4_q ? select_878 : best_left_rdata_s4_q);
  logic [7:0] select_882;
  assign select_882 = equal_521_s4_q ? select_878 : select_881;
  // hls/stages/agreement.hpp:484
  logic [6:0] select_928;
  assign select_928 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:485
  logic [6:0] sum_929;
  assign sum_929 = {6'h0, textured_s4_q} + select_928;
  // hls/stages/agreement.hpp:575
  logic [11:0] sum_931;
  assign sum_931 = {5'h0, sum_929} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:484
  logic [6:0] select_939;
  assign select_939 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:485
  logic [6:0] sum_940;
  assign sum_940 = {6'h0, explained_s4_q} + select_939;
  // hls/stages/agreement.hpp:576
  logic [11:0] sum_942;
  assign sum_942 = {5'h0, sum_940} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:484
  logic [6:0] select_950;
  assign select_950 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:486
  logic [6:0] sum_951;
  assign sum_951 = {6'h0, and_949_s4_q} + select_950;
  // hls/stages/agreement.hpp:577
  logic [11:0] sum_953;
  assign sum_953 = {5'h0, sum_951} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:606
  logic [4:0] difference_1000;
  assign difference_1000 = {2'h0, textured_2_s4_q} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  logic [4:0] t;
  assign t = difference_1000 + (equal_1001_s4_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:612
  logic not_1016;
  assign not_1016 = ~region_row_s4_q[2];
  logic [2:0] select_1017;
  assign select_1017 = region_row_s4_q[1] ? {1'b0, not_1016, 1'b0} : {region_row_s4_q[2], 1'b0, not_1016};
  logic [5:0] select_1018;
  assign select_1018 = region_row_s4_q[0] ? {select_1017[2], 1'b0, select_1017[1], 1'b0, select_1017[0], 1'b0} : {1'b0, select_1017[2], 1'b0, select_1017[1], 1'b0, select_1017[0]};
  logic [11:0] select_1019;
  assign select_1019 = or_1015_s4_q ? {select_1018[5], 1'b0, select_1018[4], 1'b0, select_1018[3], 1'b0, select_1018[2], 1'b0, select_1018[1], 1'b0, select_1018[0], 1'b0} : {1'b0, select_1018[5], 1'b0, select_1018[4], 1'b0, select_1018[3], 1'b0, select_1018[2], 1'b0, select_1018[1], 1'b0, select_1018[0]};
  logic [23:0] select_1020;
  assign select_1020 = or_1012_s4_q ? {select_1019[11], 1'b0, select_1019[10], 1'b0, select_1019[9], 1'b0, select_1019[8], 1'b0, select_1019[7], 1'b0, select_1019[6], 1'b0, select_1019[5], 1'b0, select_1019[4], 1'b0, select_1019[3], 1'b0, select_1019[2], 1'b0, select_1019[1], 1'b0, select_1019[0], 1'b0} : {1'b0, select_1019[11], 1'b0, select_1019[10], 1'b0, select_1019[9], 1'b0, select_1019[8], 1'b0, select_1019[7], 1'b0, select_1019[6], 1'b0, select_1019[5], 1'b0, select_1019[4], 1'b0, select_1019[3], 1'b0, select_1019[2], 1'b0, select_1019[1], 1'b0, select_1019[0]};
  logic [47:0] select_1021;
  assign select_1021 = or_1009_s4_q ? {select_1020[23], 1'b0, select_1020[22], 1'b0, select_1020[21], 1'b0, select_1020[20], 1'b0, select_1020[19], 1'b0, select_1020[18], 1'b0, select_1020[17], 1'b0, select_1020[16], 1'b0, select_1020[15], 1'b0, select_1020[14], 1'b0, select_1020[13], 1'b0, select_1020[12], 1'b0, select_1020[11], 1'b0, select_1020[10], 1'b0, select_1020[9], 1'b0, select_1020[8], 1'b0, select_1020[7], 1'b0, select_1020[6], 1'b0, select_1020[5], 1'b0, select_1020[4], 1'b0, select_1020[3], 1'b0, select_1020[2], 1'b0, select_1020[1], 1'b0, select_1020[0], 1'b0} : {1'b0, select_1020[23], 1'b0, select_1020[22], 1'b0, select_1020[21], 1'b0, select_1020[20], 1'b0, select_1020[19], 1'b0, select_1020[18], 1'b0, select_1020[17], 1'b0, select_1020[16], 1'b0, select_1020[15], 1'b0, select_1020[14], 1'b0, select_1020[13], 1'b0, select_1020[12], 1'b0, select_1020[11], 1'b0, select_1020[10], 1'b0, select_1020[9], 1'b0, select_1020[8], 1'b0, select_1020[7], 1'b0, select_1020[6], 1'b0, select_1020[5], 1'b0, select_1020[4], 1'b0, select_1020[3], 1'b0, select_1020[2], 1'b0, select_1020[1], 1'b0, select_1020[0]};
  // hls/stages/agreement.hpp:607
  logic [4:0] difference_1030;
  assign difference_1030 = {2'h0, explained_2_s4_q} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_1030 + (equal_1001_s4_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:613
  logic [5:0] sum_1033;
  assign sum_1033 = {1'b0, e} + {2'h0, e[4:1]};
  logic is_seen;
  assign is_seen = (t[4:1] == 4'h0) ? (~((good_q & select_1021) == 48'h0)) : (~({sum_1033, e[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:608
  logic [4:0] difference_1042;
  assign difference_1042 = {2'h0, near_2_s4_q} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1042 + (equal_1001_s4_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:625
  logic and_1046;
  assign and_1046 = is_seen & ({1'b0, e[4:1]} < n);
  // hls/stages/agreement.hpp:183
  logic [8:0] select_1081;
  assign select_1081 = sample_pair_whole_s4_q ? (and_349_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1083;
  assign select_1083 = sample_pair_whole_s4_q ? (and_349_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1085;
  assign select_1085 = sample_pair_whole_s4_q ? (and_349_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1087;
  assign select_1087 = sample_pair_whole_s4_q ? (and_349_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1092;
  assign sum_1092 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_1093;
  assign difference_1093 = {1'b0, sum_1092[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1094;
  assign xor_1094 = {difference_1093[8:0], sum_1092[0]} ^ {10{difference_1093[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1093[9]} + {1'b0, xor_1094};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_354_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:183
  logic [13:0] select_1099;
  assign select_1099 = sample_pair_whole_s4_q ? (and_349_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1100;
  assign sum_1100 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_1101;
  assign difference_1101 = {1'b0, sum_1100[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1102;
  assign xor_1102 = {difference_1101[8:0], sum_1100[0]} ^ {10{difference_1101[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1101[9]} + {1'b0, xor_1102};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_354_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:183
  logic [13:0] select_1107;
  assign select_1107 = sample_pair_whole_s4_q ? (and_349_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:184
  logic [11:0] select_1192;
  assign select_1192 = and_351_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1193;
  assign select_1193 = and_351_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1194;
  assign select_1194 = and_351_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1195;
  assign select_1195 = and_351_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_1198;
  assign sum_1198 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1190_s4_q};
  logic [13:0] sum_1200;
  assign sum_1200 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1198});
  // hls/stages/census.hpp:225
  logic and_1202;
  assign and_1202 = and_434_s4_q & (9'h4 < sum_1200[13:5]);
  // hls/stages/census.hpp:226
  logic and_1203;
  assign and_1203 = and_434_s4_q & less_458;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1204;
  assign sum_1204 = census_left_misses_q + {{17{and_1203}}, and_1202, 1'b0, and_1202};
  // hls/stages/agreement.hpp:184
  logic [19:0] select_1206;
  assign select_1206 = and_351_s4_q ? (equal_1197_s4_q ? 20'h0 : sum_1204) : census_left_misses_q;
  // hls/stages/agreement.hpp:183
  logic [27:0] select_1211;
  assign select_1211 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:275
  logic and_1216;
  assign and_1216 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:261
  logic and_1222;
  assign and_1222 = and_1216 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1211[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1224;
  assign select_1224 = and_1222 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1226;
  assign select_1226 = equal_1197_s4_q ? {11'h0, select_1224} : (sharpness_sums_detail_0_q + {11'h0, select_1224});
  // hls/stages/agreement.hpp:261
  logic and_1233;
  assign and_1233 = and_1216 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1211[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1235;
  assign select_1235 = and_1233 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1237;
  assign select_1237 = equal_1197_s4_q ? {11'h0, select_1235} : (sharpness_sums_detail_1_q + {11'h0, select_1235});
  logic [8:0] select_1240;
  assign select_1240 = and_1222 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_1241;
  assign sum_1241 = (equal_1197_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1240};
  logic [8:0] select_1244;
  assign select_1244 = and_1233 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_1245;
  assign sum_1245 = (equal_1197_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1244};
  // hls/stages/agreement.hpp:508
  logic [13:0] select_1389;
  assign select_1389 = and_1382_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1387_s4_q});
  // hls/stages/agreement.hpp:317
  logic and_1392;
  assign and_1392 = not_371_s4_q & (not_516_s4_q & (begins_product_q & textured_s4_q));
  logic and_1397;
  assign and_1397 = not_371_s4_q & (not_516_s4_q & (begins_product_q & explained_s4_q));
  logic and_1402;
  assign and_1402 = not_371_s4_q & (not_516_s4_q & (begins_product_q & and_949_s4_q));
  // hls/stages/agreement.hpp:617
  logic not_1407;
  assign not_1407 = ~is_seen;
  // hls/stages/agreement.hpp:317
  logic and_1410;
  assign and_1410 = begins_product_q & ((~equal_1405_s4_q) & (centres_values_1_textured_s4_q & not_1407));
  logic and_1412;
  assign and_1412 = not_371_s4_q & (not_516_s4_q & and_1410);
  // hls/stages/agreement.hpp:643
  logic less_1415;
  assign less_1415 = region_row_s4_q < x_s4_q[5:3];
  logic [11:0] select_1416;
  assign select_1416 = less_1415 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1419;
  assign select_1419 = less_1415 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:644
  logic [12:0] sum_1420;
  assign sum_1420 = {1'b0, select_1419} + {3'h0, select_1419[11:2]};
  logic and_1422;
  assign and_1422 = (~(select_1416[11:4] == 8'h0)) & ({sum_1420, select_1419[1:0]} < {3'h0, select_1416});
  // hls/stages/agreement.hpp:317
  logic [11:0] select_1425;
  assign select_1425 = equal_915_s4_q ? (equal_916_s4_q ? 12'h0 : (and_1422 ? select_1416 : 12'h0)) : 12'h0;
  logic [11:0] select_1427;
  assign select_1427 = equal_372_s4_q ? 12'h0 : (begins_product_q ? 12'h0 : select_1425);
  logic [11:0] select_1428;
  assign select_1428 = equal_370_s4_q ? 12'h0 : select_1427;
  // hls/stages/agreement.hpp:508
  logic [13:0] select_1430;
  assign select_1430 = and_1382_s4_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1428});
  // hls/stages/agreement.hpp:170
  logic [8:0] select_1440;
  assign select_1440 = less_373_s4_q ? 9'h0 : (and_926_s4_q ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0);
  // hls/stages/agreement.hpp:317
  logic [20:0] select_1441;
  assign select_1441 = begins_product_q ? {{12{select_1440[8]}}, select_1440} : {1'b0, select_1425, 8'h0};
  logic [20:0] select_1443;
  assign select_1443 = equal_370_s4_q ? 21'h0 : (equal_372_s4_q ? 21'h0 : select_1441);
  // hls/stages/agreement.hpp:508
  logic [23:0] select_1445;
  assign select_1445 = and_1382_s4_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1443[20]}}, select_1443});
  // hls/stages/agreement.hpp:556
  logic [8:0] select_1447;
  assign select_1447 = and_926_s4_q ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1448;
  assign select_1448 = less_373_s4_q ? 8'h0 : select_1447[7:0];
  // hls/stages/agreement.hpp:170
  logic and_1449;
  assign and_1449 = not_374_s4_q & select_1447[8];
  // hls/stages/agreement.hpp:623
  logic [2:0] select_1452;
  assign select_1452 = centres_values_1_textured_s4_q ? (is_seen ? {3{and_1449}} : ({3{and_1449}} + 3'h1)) : {3{and_1449}};
  logic [2:0] select_1453;
  assign select_1453 = equal_1405_s4_q ? {3{and_1449}} : select_1452;
  // hls/stages/agreement.hpp:317
  logic [10:0] select_1455;
  assign select_1455 = equal_372_s4_q ? 11'h0 : (begins_product_q ? {select_1453, select_1448} : 11'h0);
  logic [10:0] select_1456;
  assign select_1456 = equal_370_s4_q ? 11'h0 : select_1455;
  // hls/stages/agreement.hpp:505
  logic [23:0] sum_1457;
  assign sum_1457 = counts_too_much_unproven_q + {{13{select_1456[10]}}, select_1456};
  // hls/stages/agreement.hpp:623
  logic [9:0] select_1460;
  assign select_1460 = centres_values_1_of_skin_s4_q ? ({1'b0, not_1407, 8'h0} - {2'h0, cfg_unproven_skin_limit_i}) : 10'h0;
  logic [9:0] select_1462;
  assign select_1462 = equal_1405_s4_q ? 10'h0 : (centres_values_1_textured_s4_q ? select_1460 : 10'h0);
  // hls/stages/agreement.hpp:317
  logic [9:0] select_1464;
  assign select_1464 = equal_372_s4_q ? 10'h0 : (begins_product_q ? select_1462 : 10'h0);
  logic [9:0] select_1465;
  assign select_1465 = equal_370_s4_q ? 10'h0 : select_1464;
  // hls/stages/agreement.hpp:506
  logic [23:0] sum_1466;
  assign sum_1466 = counts_too_much_unseen_skin_q + {{14{select_1465[9]}}, select_1465};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1521;
  assign select_1521 = equal_1482_s4_q ? 8'h0 : (equal_1483_s4_q ? 8'h0 : residual_s4_q);
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1524;
  assign select_1524 = less_373_s4_q ? 8'h0 : (and_1478_s4_q ? (equal_1481_s4_q ? 8'h0 : select_1521) : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1527;
  assign select_1527 = equal_370_s4_q ? 8'h0 : (equal_372_s4_q ? 8'h0 : (begins_product_q ? select_1524 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1528;
  assign sum_1528 = registration_counts_across_0_q + {{12{select_1527[7]}}, select_1527};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1531;
  assign select_1531 = equal_1482_s4_q ? 8'h0 : (equal_1483_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1534;
  assign select_1534 = less_373_s4_q ? 8'h0 : (and_1478_s4_q ? (equal_1481_s4_q ? 8'h0 : select_1531) : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1537;
  assign select_1537 = equal_370_s4_q ? 8'h0 : (equal_372_s4_q ? 8'h0 : (begins_product_q ? select_1534 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1538;
  assign sum_1538 = registration_counts_across_1_q + {{12{select_1537[7]}}, select_1537};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1541;
  assign select_1541 = equal_1481_s4_q ? 8'h0 : (equal_1482_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1544;
  assign select_1544 = begins_product_q ? (less_373_s4_q ? 8'h0 : (and_1478_s4_q ? select_1541 : 8'h0)) : 8'h0;
  logic [7:0] select_1546;
  assign select_1546 = equal_370_s4_q ? 8'h0 : (equal_372_s4_q ? 8'h0 : select_1544);
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1547;
  assign sum_1547 = registration_counts_across_2_q + {{12{select_1546[7]}}, select_1546};
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1551;
  assign select_1551 = less_373_s4_q ? 8'h0 : (and_1478_s4_q ? (equal_1481_s4_q ? residual_s4_q : 8'h0) : 8'h0);
  // hls/stages/agreement.hpp:317
  logic [7:0] select_1554;
  assign select_1554 = equal_370_s4_q ? 8'h0 : (equal_372_s4_q ? 8'h0 : (begins_product_q ? select_1551 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1555;
  assign sum_1555 = registration_counts_across_3_q + {{12{select_1554[7]}}, select_1554};
  // hls/stages/agreement.hpp:639
  logic and_1805;
  assign and_1805 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:646
  logic [12:0] sum_1809;
  assign sum_1809 = {1'b0, select_1419} + {2'h0, select_1419[11:1]};
  logic select_1812;
  assign select_1812 = (select_1416[11:3] == 9'h0) ? (and_1805 & (~less_1806_s4_q)) : (~({sum_1809, select_1419[0]} < {2'h0, select_1416}));
  // hls/stages/agreement.hpp:654
  logic [47:0] select_1813;
  assign select_1813 = equal_916_s4_q ? good_next_q : {select_1812, good_next_q[47:1]};
  // hls/stages/agreement.hpp:317
  logic [47:0] select_1815;
  assign select_1815 = equal_915_s4_q ? (equal_1800_s4_q ? select_1813 : good_q) : good_q;
  logic [47:0] select_1817;
  assign select_1817 = equal_372_s4_q ? good_q : (begins_product_q ? good_q : select_1815);
  logic [47:0] select_1820;
  assign select_1820 = begins_product_q ? good_next_q : (equal_915_s4_q ? select_1813 : good_next_q);
  logic [47:0] select_1822;
  assign select_1822 = equal_370_s4_q ? good_next_q : (equal_372_s4_q ? good_next_q : select_1820);
  // hls/stages/agreement.hpp:671
  logic [35:0] select_1841;
  assign select_1841 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:665
  logic [35:0] detail_left;
  assign detail_left = begins_product_s4_q ? 36'h0 : select_1841;
  // hls/stages/agreement.hpp:671
  logic [35:0] select_1844;
  assign select_1844 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:675
  logic [35:0] detail_right;
  assign detail_right = begins_product_s4_q ? 36'h0 : select_1844;
  // hls/stages/agreement.hpp:665
  logic [34:0] select_1846;
  assign select_1846 = begins_product_s4_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:675
  logic [34:0] select_1847;
  assign select_1847 = begins_product_s4_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:665
  logic [17:0] select_1848;
  assign select_1848 = begins_product_s4_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:675
  logic [17:0] select_1849;
  assign select_1849 = begins_product_s4_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:317
  logic [4:0] select_1850;
  assign select_1850 = begins_product_q ? {2'h0, textured_2_s4_q} : box_textured_columns_values_0_q;
  logic [4:0] select_1852;
  assign select_1852 = equal_370_s4_q ? box_textured_columns_values_0_q : (equal_372_s4_q ? box_textured_columns_values_0_q : select_1850);
  logic [4:0] select_1853;
  assign select_1853 = begins_product_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1855;
  assign select_1855 = equal_370_s4_q ? box_textured_columns_values_1_q : (equal_372_s4_q ? box_textured_columns_values_1_q : select_1853);
  logic [4:0] select_1856;
  assign select_1856 = begins_product_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1858;
  assign select_1858 = equal_370_s4_q ? box_textured_columns_values_2_q : (equal_372_s4_q ? box_textured_columns_values_2_q : select_1856);
  logic [4:0] select_1859;
  assign select_1859 = begins_product_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1861;
  assign select_1861 = equal_370_s4_q ? box_textured_columns_values_3_q : (equal_372_s4_q ? box_textured_columns_values_3_q : select_1859);
  logic [4:0] select_1862;
  assign select_1862 = begins_product_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1864;
  assign select_1864 = equal_370_s4_q ? box_textured_columns_values_4_q : (equal_372_s4_q ? box_textured_columns_values_4_q : select_1862);
  logic [4:0] select_1866;
  assign select_1866 = equal_372_s4_q ? box_textured_sum_sums_values_0_q : (begins_product_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1868;
  assign select_1868 = begins_product_q ? {2'h0, explained_2_s4_q} : box_explained_columns_values_0_q;
  logic [4:0] select_1870;
  assign select_1870 = equal_370_s4_q ? box_explained_columns_values_0_q : (equal_372_s4_q ? box_explained_columns_values_0_q : select_1868);
  logic [4:0] select_1871;
  assign select_1871 = begins_product_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1873;
  assign select_1873 = equal_370_s4_q ? box_explained_columns_values_1_q : (equal_372_s4_q ? box_explained_columns_values_1_q : select_1871);
  logic [4:0] select_1874;
  assign select_1874 = begins_product_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1876;
  assign select_1876 = equal_370_s4_q ? box_explained_columns_values_2_q : (equal_372_s4_q ? box_explained_columns_values_2_q : select_1874);
  logic [4:0] select_1877;
  assign select_1877 = begins_product_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1879;
  assign select_1879 = equal_370_s4_q ? box_explained_columns_values_3_q : (equal_372_s4_q ? box_explained_columns_values_3_q : select_1877);
  logic [4:0] select_1880;
  assign select_1880 = begins_product_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1882;
  assign select_1882 = equal_370_s4_q ? box_explained_columns_values_4_q : (equal_372_s4_q ? box_explained_columns_values_4_q : select_1880);
  logic [4:0] select_1884;
  assign select_1884 = equal_372_s4_q ? box_explained_sum_sums_values_0_q : (begins_product_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1886;
  assign select_1886 = begins_product_q ? {2'h0, near_2_s4_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_1888;
  assign select_1888 = equal_370_s4_q ? box_nearer_columns_values_0_q : (equal_372_s4_q ? box_nearer_columns_values_0_q : select_1886);
  logic [4:0] select_1889;
  assign select_1889 = begins_product_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1891;
  assign select_1891 = equal_370_s4_q ? box_nearer_columns_values_1_q : (equal_372_s4_q ? box_nearer_columns_values_1_q : select_1889);
  logic [4:0] select_1892;
  assign select_1892 = begins_product_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1894;
  assign select_1894 = equal_370_s4_q ? box_nearer_columns_values_2_q : (equal_372_s4_q ? box_nearer_columns_values_2_q : select_1892);
  logic [4:0] select_1895;
  assign select_1895 = begins_product_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1897;
  assign select_1897 = equal_370_s4_q ? box_nearer_columns_values_3_q : (equal_372_s4_q ? box_nearer_columns_values_3_q : select_1895);
  logic [4:0] select_1898;
  assign select_1898 = begins_product_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_1900;
  assign select_1900 = equal_370_s4_q ? box_nearer_columns_values_4_q : (equal_372_s4_q ? box_nearer_columns_values_4_q : select_1898);
  logic [4:0] select_1902;
  assign select_1902 = equal_372_s4_q ? box_nearer_sum_sums_values_0_q : (begins_product_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:763
  logic [1:0] select_1951;
  assign select_1951 = and_1950_s4_q ? {and_1046, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:764
  logic and_1952;
  assign and_1952 = proven_q & less_1940;
  // hls/stages/agreement.hpp:187
  logic select_1955;
  assign select_1955 = and_986_s4_q ? (less_987_s4_q ? (select_1951[0] & and_1952) : seen_q) : seen_q;
  logic select_1958;
  assign select_1958 = and_986_s4_q ? (less_987_s4_q ? (select_1951[1] & and_1952) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:317
  logic [13:0] select_1963;
  assign select_1963 = equal_915_s4_q ? (equal_1800_s4_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_1965;
  assign select_1965 = equal_372_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1963);
  logic [13:0] select_1968;
  assign select_1968 = equal_915_s4_q ? (equal_1800_s4_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_1970;
  assign select_1970 = equal_372_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1968);
  logic [13:0] select_1973;
  assign select_1973 = equal_915_s4_q ? (equal_1800_s4_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_1975;
  assign select_1975 = equal_372_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1973);
  logic [13:0] select_1978;
  assign select_1978 = equal_915_s4_q ? (equal_1800_s4_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_1980;
  assign select_1980 = equal_372_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1978);
  logic [13:0] select_1983;
  assign select_1983 = equal_915_s4_q ? (equal_1800_s4_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_1985;
  assign select_1985 = equal_372_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1983);
  logic [13:0] select_1988;
  assign select_1988 = equal_915_s4_q ? (equal_1800_s4_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic [13:0] select_1990;
  assign select_1990 = equal_372_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1988);
  // hls/stages/agreement.hpp:691
  logic not_1999;
  assign not_1999 = ~and_1805;
  // hls/stages/agreement.hpp:317
  logic and_2003;
  assign and_2003 = not_1295_s4_q & (equal_915_s4_q & (equal_1800_s4_q & (cfg_prove_i & not_1999)));
  // hls/stages/agreement.hpp:692
  logic or_2006;
  assign or_2006 = not_1959 | not_1999;
  // hls/stages/agreement.hpp:658
  logic or_2012;
  assign or_2012 = ($signed(24'h0) < $signed(counts_too_much_unproven_q)) | ($signed(24'h0) < $signed(counts_too_much_unseen_skin_q));
  logic select_2014;
  assign select_2014 = (less_1806_s4_q | or_2006) ? (~or_2006) : (($signed(24'h0) < $signed(counts_too_many_bad_q)) | or_2012);
  // hls/stages/agreement.hpp:317
  logic and_2017;
  assign and_2017 = not_1295_s4_q & (equal_915_s4_q & (equal_1800_s4_q & select_2014));
  // hls/stages/agreement.hpp:658
  logic select_2083;
  assign select_2083 = or_2043_s4_q ? select_2080_s4_q : or_2082_s4_q;
  logic or_2085;
  assign or_2085 = less_2084_s4_q | select_2083;
  logic select_2086;
  assign select_2086 = or_2036_s4_q ? select_2083 : or_2085;
  logic or_2088;
  assign or_2088 = less_2087_s4_q | select_2086;
  logic select_2093;
  assign select_2093 = less_2031_s4_q ? or_2085 : (less_2037_s4_q ? or_2082_s4_q : select_2091_s4_q);
  logic select_2095;
  assign select_2095 = less_2023_s4_q ? (less_2024_s4_q | (or_2029_s4_q ? select_2086 : or_2088)) : (less_2026_s4_q ? or_2088 : select_2093);
  // hls/stages/agreement.hpp:317
  logic and_2099;
  assign and_2099 = not_1295_s4_q & (equal_915_s4_q & (equal_1800_s4_q & (cfg_prove_i & select_2095)));
  // hls/stages/agreement.hpp:699
  logic and_2102;
  assign and_2102 = cfg_prove_i & and_1805;
  // hls/stages/agreement.hpp:700
  logic [36:0] sum_2103;
  assign sum_2103 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2105;
  assign less_2105 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:658
  logic or_2108;
  assign or_2108 = ({detail_left, 3'h0} < {sum_2103, detail_right[1:0]}) | (less_2105 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:317
  logic and_2112;
  assign and_2112 = not_1295_s4_q & (equal_915_s4_q & (equal_1800_s4_q & (and_2102 & or_2108)));
  // hls/stages/agreement.hpp:703
  logic [36:0] sum_2115;
  assign sum_2115 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2117;
  assign less_2117 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:658
  logic or_2118;
  assign or_2118 = ({detail_right, 3'h0} < {sum_2115, detail_left[1:0]}) | less_2117;
  // hls/stages/agreement.hpp:317
  logic and_2122;
  assign and_2122 = not_1295_s4_q & (equal_915_s4_q & (equal_1800_s4_q & (and_2102 & or_2118)));
  logic [19:0] select_2137;
  assign select_2137 = equal_915_s4_q ? (equal_1800_s4_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2139;
  assign select_2139 = equal_372_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2137);
  logic [19:0] select_2142;
  assign select_2142 = equal_915_s4_q ? (equal_1800_s4_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2144;
  assign select_2144 = equal_372_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2142);
  logic [19:0] select_2147;
  assign select_2147 = equal_915_s4_q ? (equal_1800_s4_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2149;
  assign select_2149 = equal_372_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2147);
  logic [19:0] select_2152;
  assign select_2152 = equal_915_s4_q ? (equal_1800_s4_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [19:0] select_2154;
  assign select_2154 = equal_372_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2152);
  logic [23:0] select_2177;
  assign select_2177 = equal_915_s4_q ? (equal_1800_s4_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2179;
  assign select_2179 = equal_372_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2177);
  logic [23:0] select_2182;
  assign select_2182 = equal_915_s4_q ? (equal_1800_s4_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2184;
  assign select_2184 = equal_372_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2182);
  logic [23:0] select_2187;
  assign select_2187 = equal_915_s4_q ? (equal_1800_s4_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2189;
  assign select_2189 = equal_372_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2187);
  logic [23:0] select_2192;
  assign select_2192 = equal_915_s4_q ? (equal_1800_s4_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2194;
  assign select_2194 = equal_372_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2192);
  logic [5:0] select_2201;
  assign select_2201 = begins_product_q ? 6'h0 : (equal_915_s4_q ? (equal_916_s4_q ? 6'h0 : x_s4_q) : 6'h0);
  logic [11:0] select_2206;
  assign select_2206 = begins_product_q ? 12'h0 : (equal_915_s4_q ? (equal_916_s4_q ? 12'h0 : select_1416) : 12'h0);
  logic [11:0] select_2211;
  assign select_2211 = begins_product_q ? 12'h0 : (equal_915_s4_q ? (equal_916_s4_q ? 12'h0 : select_1419) : 12'h0);
  // hls/stages/agreement.hpp:654
  logic [11:0] select_2215;
  assign select_2215 = equal_916_s4_q ? 12'h0 : (less_1415 ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:317
  logic [11:0] select_2217;
  assign select_2217 = begins_product_q ? 12'h0 : (equal_915_s4_q ? select_2215 : 12'h0);

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_351_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_459, and_435_s4_q, and_434_s4_q, and_409_s4_q, less_401_s4_q, less_400_s4_q, less_399_s4_q, less_398_s4_q, less_397_s4_q, less_396_s4_q, less_395_s4_q, less_394_s4_q, less_393_s4_q, less_392_s4_q, less_391_s4_q, less_390_s4_q, less_389_s4_q, less_388_s4_q, less_387_s4_q, less_386_s4_q, less_385_s4_q, less_384_s4_q, less_383_s4_q, less_382_s4_q, less_381_s4_q, less_380_s4_q, less_379_s4_q, less_378_s4_q};
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
      if (fresh_waddr >= 7'd80) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd80) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s4_2_q;
  logic best_left_we;
  assign best_left_we = s4_en & and_883_s4_q;
  logic [21:0] best_left_wdata;
  assign best_left_wdata = {select_882, select_834_s4_q, select_830_s4_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {^best_left_wdata, best_left_wdata};
  end
`ifndef SYNTHESIS
  logic [6:0] best_left_raddr_s2_sim;
  logic best_left_re_s2_sim;
  logic [6:0] best_left_raddr_s3_sim;
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
      if (best_left_waddr >= 7'd80) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 7'd80) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s4_q, or_908_s4_q, or_905_s4_q, or_902_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_956_s4_q;
  logic [35:0] regions_wdata;
  assign regions_wdata = {sum_953, sum_942, sum_931};
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
  assign map_waddr = {sum_992_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_1057_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_1046, is_seen};
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
    end else if (s4_en) begin
      census_left_misses_q <= select_1206;
      sharpness_sums_detail_0_q <= and_351_s4_q ? select_1226 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_351_s4_q ? select_1237 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_351_s4_q ? sum_1241 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_351_s4_q ? sum_1245 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1389;
      counts_textured_q <= and_1382_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_1392});
      counts_explained_q <= and_1382_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_1397});
      counts_nearer_q <= and_1382_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1402});
      counts_unproven_q <= and_1382_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1412});
      counts_regions_bad_q <= select_1430;
      counts_too_many_bad_q <= select_1445;
      counts_too_much_unproven_q <= and_1382_s4_q ? 24'h0 : sum_1457;
      counts_too_much_unseen_skin_q <= and_1382_s4_q ? 24'h0 : sum_1466;
      registration_counts_across_0_q <= and_1382_s4_q ? 20'h0 : sum_1528;
      registration_counts_across_1_q <= and_1382_s4_q ? 20'h0 : sum_1538;
      registration_counts_across_2_q <= and_1382_s4_q ? 20'h0 : sum_1547;
      registration_counts_across_3_q <= and_1382_s4_q ? 20'h0 : sum_1555;
      segment_textured_q <= select_928 + {6'h0, and_1392};
      segment_explained_q <= select_939 + {6'h0, and_1397};
      segment_nearer_q <= select_950 + {6'h0, and_1402};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_370_s4_q ? good_q : select_1817;
      good_next_q <= select_1822;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1846;
      addend_1_q <= select_1847;
      multiplier_0_q <= select_1848;
      multiplier_1_q <= select_1849;
      seen_q <= select_1955;
      nearer_q <= select_1958;
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
      averager_quarter_1_0_q <= select_1081;
      averager_quarter_1_1_q <= select_1083;
      averager_quarter_2_0_q <= select_1085;
      averager_quarter_2_1_q <= select_1087;
      averager_detail_0_q <= select_1099;
      averager_detail_1_q <= select_1107;
      census_changes_values_0_left_q <= and_351_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_351_s4_q ? sum_1190_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1192;
      census_changes_values_1_right_q <= select_1193;
      census_changes_values_2_left_q <= select_1194;
      census_changes_values_2_right_q <= select_1195;
      sharpness_last_mask_q <= and_351_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_351_s4_q ? select_1211[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_351_s4_q ? select_1211[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_1852;
      box_textured_columns_values_1_q <= select_1855;
      box_textured_columns_values_2_q <= select_1858;
      box_textured_columns_values_3_q <= select_1861;
      box_textured_columns_values_4_q <= select_1864;
      box_textured_sum_sums_values_0_q <= equal_370_s4_q ? box_textured_sum_sums_values_0_q : select_1866;
      box_explained_columns_values_0_q <= select_1870;
      box_explained_columns_values_1_q <= select_1873;
      box_explained_columns_values_2_q <= select_1876;
      box_explained_columns_values_3_q <= select_1879;
      box_explained_columns_values_4_q <= select_1882;
      box_explained_sum_sums_values_0_q <= equal_370_s4_q ? box_explained_sum_sums_values_0_q : select_1884;
      box_nearer_columns_values_0_q <= select_1888;
      box_nearer_columns_values_1_q <= select_1891;
      box_nearer_columns_values_2_q <= select_1894;
      box_nearer_columns_values_3_q <= select_1897;
      box_nearer_columns_values_4_q <= select_1900;
      box_nearer_sum_sums_values_0_q <= equal_370_s4_q ? box_nearer_sum_sums_values_0_q : select_1902;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_1935_s5_q;
  logic or_1960_s5_q;
  logic and_1961_s5_q;
  logic [13:0] select_1966_s5_q;
  logic [13:0] select_1971_s5_q;
  logic [13:0] select_1976_s5_q;
  logic [13:0] select_1981_s5_q;
  logic [13:0] select_1986_s5_q;
  logic [13:0] select_1991_s5_q;
  logic and_1998_s5_q;
  logic and_2005_s5_q;
  logic and_2019_s5_q;
  logic and_2101_s5_q;
  logic and_2114_s5_q;
  logic and_2124_s5_q;
  logic and_2135_s5_q;
  logic [19:0] select_2140_s5_q;
  logic [19:0] select_2145_s5_q;
  logic [19:0] select_2150_s5_q;
  logic [19:0] select_2155_s5_q;
  logic [11:0] select_2160_s5_q;
  logic [11:0] select_2165_s5_q;
  logic [11:0] select_2170_s5_q;
  logic [11:0] select_2175_s5_q;
  logic [23:0] select_2180_s5_q;
  logic [23:0] select_2185_s5_q;
  logic [23:0] select_2190_s5_q;
  logic [23:0] select_2195_s5_q;
  logic and_2198_s5_q;
  logic [5:0] select_2203_s5_q;
  logic [11:0] select_2208_s5_q;
  logic [11:0] select_2213_s5_q;
  logic [11:0] select_2219_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_1935_s5_q <= said_q;
      or_1960_s5_q <= not_1959 | select_1955;
      and_1961_s5_q <= cfg_prove_i & select_1958;
      select_1966_s5_q <= equal_370_s4_q ? 14'h0 : select_1965;
      select_1971_s5_q <= equal_370_s4_q ? 14'h0 : select_1970;
      select_1976_s5_q <= equal_370_s4_q ? 14'h0 : select_1975;
      select_1981_s5_q <= equal_370_s4_q ? 14'h0 : select_1980;
      select_1986_s5_q <= equal_370_s4_q ? 14'h0 : select_1985;
      select_1991_s5_q <= equal_370_s4_q ? 14'h0 : select_1990;
      and_1998_s5_q <= and_1998_s4_q;
      and_2005_s5_q <= not_371_s4_q & (not_516_s4_q & and_2003);
      and_2019_s5_q <= not_371_s4_q & (not_516_s4_q & and_2017);
      and_2101_s5_q <= not_371_s4_q & (not_516_s4_q & and_2099);
      and_2114_s5_q <= not_371_s4_q & (not_516_s4_q & and_2112);
      and_2124_s5_q <= not_371_s4_q & (not_516_s4_q & and_2122);
      and_2135_s5_q <= and_2135_s4_q;
      select_2140_s5_q <= equal_370_s4_q ? 20'h0 : select_2139;
      select_2145_s5_q <= equal_370_s4_q ? 20'h0 : select_2144;
      select_2150_s5_q <= equal_370_s4_q ? 20'h0 : select_2149;
      select_2155_s5_q <= equal_370_s4_q ? 20'h0 : select_2154;
      select_2160_s5_q <= select_2160_s4_q;
      select_2165_s5_q <= select_2165_s4_q;
      select_2170_s5_q <= select_2170_s4_q;
      select_2175_s5_q <= select_2175_s4_q;
      select_2180_s5_q <= equal_370_s4_q ? 24'h0 : select_2179;
      select_2185_s5_q <= equal_370_s4_q ? 24'h0 : select_2184;
      select_2190_s5_q <= equal_370_s4_q ? 24'h0 : select_2189;
      select_2195_s5_q <= equal_370_s4_q ? 24'h0 : select_2194;
      and_2198_s5_q <= and_2198_s4_q;
      select_2203_s5_q <= equal_370_s4_q ? 6'h0 : (equal_372_s4_q ? 6'h0 : select_2201);
      select_2208_s5_q <= equal_370_s4_q ? 12'h0 : (equal_372_s4_q ? 12'h0 : select_2206);
      select_2213_s5_q <= equal_370_s4_q ? 12'h0 : (equal_372_s4_q ? 12'h0 : select_2211);
      select_2219_s5_q <= equal_370_s4_q ? 12'h0 : (equal_372_s4_q ? 12'h0 : select_2217);
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (averager_memory_error | census_memory_error | fresh_error | left_error | right_codes_error | best_left_error | best_right_error | regions_error | seen_columns_error | map_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign pixel_1_o = pixel_1_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_1960_s5_q;
  assign marks_nearer_o = and_1961_s5_q;
  assign verdict_valid_o = and_1935_s5_q;
  assign verdict_supervised_o = {2'h0, select_1966_s5_q};
  assign verdict_textured_o = {2'h0, select_1971_s5_q};
  assign verdict_explained_o = {2'h0, select_1976_s5_q};
  assign verdict_nearer_o = {2'h0, select_1981_s5_q};
  assign verdict_unproven_o = {2'h0, select_1986_s5_q};
  assign verdict_regions_bad_o = {2'h0, select_1991_s5_q};
  assign verdict_unproven_yet_o = and_1998_s5_q;
  assign verdict_untextured_o = and_2005_s5_q;
  assign verdict_disagree_o = and_2019_s5_q;
  assign verdict_moved_o = and_2101_s5_q;
  assign verdict_unsharp_left_o = and_2114_s5_q;
  assign verdict_unsharp_right_o = and_2124_s5_q;
  assign verdict_hidden_o = and_2135_s5_q;
  assign verdict_across_0_o = select_2140_s5_q;
  assign verdict_across_1_o = select_2145_s5_q;
  assign verdict_across_2_o = select_2150_s5_q;
  assign verdict_across_3_o = select_2155_s5_q;
  assign verdict_measured_0_o = select_2160_s5_q;
  assign verdict_measured_1_o = select_2165_s5_q;
  assign verdict_measured_2_o = select_2170_s5_q;
  assign verdict_measured_3_o = select_2175_s5_q;
  assign verdict_detail_0_o = select_2180_s5_q;
  assign verdict_detail_1_o = select_2185_s5_q;
  assign verdict_contrast_0_o = select_2190_s5_q;
  assign verdict_contrast_1_o = select_2195_s5_q;
  assign region_valid_o = and_2198_s5_q;
  assign region_region_o = select_2203_s5_q;
  assign region_textured_o = select_2208_s5_q;
  assign region_explained_o = select_2213_s5_q;
  assign region_nearer_o = select_2219_s5_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_2022[2:0], sum_1510[0], sum_1506[0], sum_1498[1:0], sum_1497[1:0], sum_1493[0], detail_4[1:0], detail_3[1:0], sum_1200[4:0], sum_875[8:0], sum_457[4:0], cfg_width_i[2:0]};

endmodule
