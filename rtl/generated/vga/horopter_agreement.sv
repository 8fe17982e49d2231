// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2489 bits, pipeline 1149 bits, memories 55744 bits.
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
  logic [3:0] sum_1279;
  assign sum_1279 = {1'b0, cfg_width_i[9:7]} + 4'hf;
  logic [6:0] sum_1283;
  assign sum_1283 = {1'b0, cfg_width_i[9:4]} + 7'h7;
  logic [5:0] sum_1298;
  assign sum_1298 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_1724;
  assign difference_1724 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_1883;
  assign less_1883 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_1884;
  assign sum_1884 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_1902;
  assign not_1902 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
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
  logic [17:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_300;
  assign select_300 = marks_first_i ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_302;
  assign select_302 = marks_first_i ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [8:0] select_305;
  assign select_305 = ({select_302, select_300} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:95
  logic [8:0] select_306;
  assign select_306 = select_300[0] ? averager_place_q : select_305;
  // hls/stages/census.hpp:40
  logic or_307;
  assign or_307 = marks_first_i | raster_at_live_q;
  // hls/stages/agreement.hpp:174
  logic and_313;
  assign and_313 = (~((~or_307) | (~select_300[0]))) & (select_306[8:6] < 3'h5);
  // hls/stages/census.hpp:40
  logic [2:0] select_317;
  assign select_317 = marks_first_i ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:174
  logic whole;
  assign whole = select_300[0] ? (present_i & averager_running_mask_q) : present_i;
  // hls/stages/census.hpp:45
  logic equal_333;
  assign equal_333 = select_300 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_334;
  assign equal_334 = select_317 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_335;
  assign and_335 = equal_334 & and_313;
  // hls/stages/census.hpp:106
  logic and_336;
  assign and_336 = equal_333 & and_335;
  // hls/stages/agreement.hpp:334
  logic equal_351;
  assign equal_351 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:321
  logic not_352;
  assign not_352 = ~equal_351;
  // hls/stages/agreement.hpp:334
  logic equal_353;
  assign equal_353 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:392
  logic less_354;
  assign less_354 = run_highest_q < x_q;
  // hls/stages/agreement.hpp:396
  logic not_355;
  assign not_355 = ~less_354;
  // hls/stages/agreement.hpp:299
  logic and_356;
  assign and_356 = equal_353 & not_355;
  logic and_357;
  assign and_357 = not_352 & and_356;
  // hls/stages/census.hpp:40
  logic [5:0] row;
  assign row = marks_first_i ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:640
  logic drew;
  assign drew = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:299
  logic and_441;
  assign and_441 = drew & not_355;
  logic [6:0] select_471;
  assign select_471 = equal_351 ? ({run_shift_q[5], run_shift_q} + x_q[6:0]) : x_q[6:0];
  // hls/stages/agreement.hpp:411
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:698
  logic or_940;
  assign or_940 = marks_first_i | raster_row_ended_q;
  // hls/stages/agreement.hpp:700
  logic [17:0] select_942;
  assign select_942 = marks_first_i ? 18'h1 : (or_940 ? {rows_passed_q[16:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:699
  logic [8:0] select_944;
  assign select_944 = or_940 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:707
  logic select_946;
  assign select_946 = cfg_compete_i ? (or_940 & select_942[17]) : (select_944[8] & select_942[9]);
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1037;
  assign sum_1037 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/census.hpp:44
  logic [8:0] select_1054;
  assign select_1054 = marks_first_i ? cfg_height_i : (raster_rows_left_q - {8'h0, marks_last_i});
  // hls/stages/agreement.hpp:245
  logic equal_1211;
  assign equal_1211 = {last[7], select_302} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:173
  logic [2:0] select_1212;
  assign select_1212 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1215;
  assign select_1215 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1218;
  assign select_1218 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1221;
  assign select_1221 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1224;
  assign select_1224 = ends_q ? following_shift_q : run_shift_q;
  logic select_1227;
  assign select_1227 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:246
  logic not_1228;
  assign not_1228 = ~equal_1211;
  // hls/stages/agreement.hpp:326
  logic not_1231;
  assign not_1231 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:334
  logic equal_1232;
  assign equal_1232 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:153
  logic or_1233;
  assign or_1233 = equal_1232 | equal_353;
  logic [2:0] select_1234;
  assign select_1234 = equal_351 ? {run_last_shift_q, {2{not_1231}}} : {1'b0, or_1233, equal_353};
  logic [7:0] select_1237;
  assign select_1237 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1238;
  assign select_1238 = equal_353 ? least_q : 7'h0;
  logic [7:0] select_1242;
  assign select_1242 = run_last_shift_q ? {1'b0, last_q} : (run_shift_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1244;
  assign select_1244 = equal_353 ? last_q : (equal_1232 ? last_q : 7'h0);
  logic [7:0] select_1250;
  assign select_1250 = equal_351 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_353 ? first_beats_q : (equal_1232 ? whole_beats_q : 8'h0));
  logic [5:0] select_1255;
  assign select_1255 = equal_351 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_353 ? (6'h0 - least_q[5:0]) : 6'h0);
  // hls/stages/agreement.hpp:136
  logic not_1257;
  assign not_1257 = ~drew;
  // hls/stages/agreement.hpp:153
  logic select_1261;
  assign select_1261 = equal_351 ? (next_last_shift_q & not_1231) : (equal_353 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1264;
  assign select_1264 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1268;
  assign select_1268 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:252
  logic less_1275;
  assign less_1275 = 6'he < select_302[6:1];
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1278;
  assign select_1278 = and_336 ? (equal_1211 ? (less_1275 ? 7'h1e : select_302) : least_q) : least_q;
  // hls/stages/agreement.hpp:246
  logic [7:0] select_1281;
  assign select_1281 = equal_1211 ? (less_1275 ? {sum_1279, cfg_width_i[6:3]} : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1285;
  assign select_1285 = and_336 ? (equal_1211 ? {sum_1283, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:302
  logic not_1286;
  assign not_1286 = ~ends_q;
  // hls/stages/agreement.hpp:173
  logic [5:0] select_1287;
  assign select_1287 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1289;
  assign select_1289 = and_336 ? (equal_1211 ? 7'h0 : {select_1287, not_1286}) : {select_1287, not_1286};
  // hls/stages/agreement.hpp:173
  logic and_1291;
  assign and_1291 = not_1286 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:262
  logic [6:0] sum_1294;
  assign sum_1294 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:246
  logic select_1296;
  assign select_1296 = equal_1211 ? ({sum_1294[6], cfg_height_i[8:3]} == {1'b0, sum_1294[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:512
  logic [5:0] sum_1430;
  assign sum_1430 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:146
  logic not_1786;
  assign not_1786 = ~run_shift_q[5];

  // Memory fresh, 80 x 29, DISTANCE 12, hls/stages/agreement.hpp:765; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_357;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 80 x 77, DISTANCE 12, hls/stages/agreement.hpp:766; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (equal_351 ? not_355 : (equal_353 ? not_355 : and_441));
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 80 x 91, DISTANCE 12, hls/stages/agreement.hpp:767; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_471;
  logic right_codes_re;
  assign right_codes_re = s0_en & (equal_351 ? not_355 : and_356);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      rows_passed_q <= 18'h0;
      columns_passed_q <= 9'h0;
    end else if (s0_en) begin
      raster_at_x_q <= select_300 + 3'h1;
      raster_at_y_q <= marks_last_i ? (select_317 + 3'h1) : select_317;
      raster_at_column_q <= select_302 + {6'h0, equal_333};
      raster_at_row_q <= marks_last_i ? (row + {5'h0, equal_334}) : row;
      raster_at_live_q <= marks_last_i ? (or_307 & (~raster_final_row_q)) : or_307;
      raster_rows_left_q <= select_1054;
      raster_row_ended_q <= marks_last_i;
      raster_final_row_q <= raster_rows_left_q == 9'h1;
      averager_place_q <= select_306;
      averager_running_mask_q <= whole;
      run_phase_q <= and_336 ? (equal_1211 ? 3'h1 : select_1212) : select_1212;
      run_lowest_q <= and_336 ? (equal_1211 ? 8'h0 : select_1215) : select_1215;
      run_highest_q <= and_336 ? (equal_1211 ? 8'h0 : select_1218) : select_1218;
      run_beats_q <= and_336 ? (equal_1211 ? 8'hc : select_1221) : select_1221;
      run_shift_q <= and_336 ? (equal_1211 ? 6'h0 : select_1224) : select_1224;
      run_last_shift_q <= and_336 ? (select_1227 & not_1228) : select_1227;
      following_phase_q <= drew ? {final_row_q, 1'b0, final_row_q} : select_1234;
      following_lowest_q <= drew ? 8'h0 : (equal_351 ? select_1237 : {1'b0, select_1238});
      following_highest_q <= drew ? 8'h0 : (equal_351 ? select_1242 : {1'b0, select_1244});
      following_beats_q <= drew ? 8'h3f : select_1250;
      following_shift_q <= drew ? 6'h0 : select_1255;
      following_last_shift_q <= not_1257 & select_1261;
      x_q <= and_336 ? (equal_1211 ? 8'h0 : select_1264) : select_1264;
      beats_left_q <= and_336 ? (equal_1211 ? 8'hc : select_1268) : select_1268;
      last_q <= and_336 ? (equal_1211 ? select_302 : last_q) : last_q;
      least_q <= select_1278;
      first_beats_q <= and_336 ? select_1281 : first_beats_q;
      whole_beats_q <= select_1285;
      age_q <= select_1289;
      ends_q <= and_336 ? (and_1291 & not_1228) : and_1291;
      final_row_q <= and_336 ? select_1296 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1786}}, 1'b1} + run_beats_q;
      next_shift_q <= run_shift_q + 6'h1;
      next_last_shift_q <= {{3{run_shift_q[5]}}, run_shift_q} == ({2'h0, least_q} + 9'h1ff);
      rows_passed_q <= select_942;
      columns_passed_q <= {select_944[7:0], or_940};
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [1:0] age_s1_q;
  logic select_300_s1_q;
  logic [6:0] select_302_s1_q;
  logic and_313_s1_q;
  logic equal_318_s1_q;
  logic and_335_s1_q;
  logic and_336_s1_q;
  logic equal_339_s1_q;
  logic equal_351_s1_q;
  logic not_352_s1_q;
  logic equal_353_s1_q;
  logic less_354_s1_q;
  logic not_355_s1_q;
  logic and_357_s1_q;
  logic [5:0] row_s1_q;
  logic drew_s1_q;
  logic and_441_s1_q;
  logic [6:0] x_s1_2_q;
  logic and_495_s1_q;
  logic equal_501_s1_q;
  logic equal_568_s1_q;
  logic equal_805_s1_q;
  logic equal_869_s1_q;
  logic equal_892_s1_q;
  logic equal_895_s1_q;
  logic select_946_s1_q;
  logic not_1039_s1_q;
  logic equal_1211_s1_q;
  logic not_1257_s1_q;
  logic less_1431_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      age_s1_q <= {age_q[6], age_q[4]};
      select_300_s1_q <= select_300[0];
      select_302_s1_q <= select_302;
      and_313_s1_q <= and_313;
      equal_318_s1_q <= select_317 == 3'h0;
      and_335_s1_q <= and_335;
      and_336_s1_q <= and_336;
      equal_339_s1_q <= select_300 == 3'h1;
      equal_351_s1_q <= equal_351;
      not_352_s1_q <= not_352;
      equal_353_s1_q <= equal_353;
      less_354_s1_q <= less_354;
      not_355_s1_q <= not_355;
      and_357_s1_q <= and_357;
      row_s1_q <= row;
      drew_s1_q <= drew;
      and_441_s1_q <= and_441;
      x_s1_2_q <= x[6:0];
      and_495_s1_q <= age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q}));
      equal_501_s1_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_568_s1_q <= run_lowest_q == x_q;
      equal_805_s1_q <= run_lowest_q == x;
      equal_869_s1_q <= run_highest_q == x;
      equal_892_s1_q <= x_q == {1'b0, last_q};
      equal_895_s1_q <= run_phase_q == 3'h5;
      select_946_s1_q <= select_946;
      not_1039_s1_q <= ~({sum_1037, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1211_s1_q <= equal_1211;
      not_1257_s1_q <= not_1257;
      less_1431_s1_q <= {1'b0, sum_1430, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:367
  logic equal_445;
  assign equal_445 = row_q == 6'h0;
  logic [11:0] select_446;
  assign select_446 = equal_445 ? 12'h0 : left_rdata_q[11:0];
  logic not_447;
  assign not_447 = ~equal_445;
  logic and_448;
  assign and_448 = left_rdata_q[12] & not_447;
  logic and_449;
  assign and_449 = left_rdata_q[13] & not_447;
  logic and_450;
  assign and_450 = left_rdata_q[14] & not_447;
  logic and_451;
  assign and_451 = left_rdata_q[15] & not_447;
  logic equal_452;
  assign equal_452 = row_q[5:1] == 5'h0;
  logic [11:0] select_453;
  assign select_453 = equal_452 ? 12'h0 : left_rdata_q[27:16];
  logic not_454;
  assign not_454 = ~equal_452;
  logic and_455;
  assign and_455 = left_rdata_q[28] & not_454;
  logic and_456;
  assign and_456 = left_rdata_q[29] & not_454;
  logic and_457;
  assign and_457 = left_rdata_q[30] & not_454;
  logic and_458;
  assign and_458 = left_rdata_q[31] & not_454;
  logic less_459;
  assign less_459 = row_q < 6'h3;
  logic [11:0] select_460;
  assign select_460 = less_459 ? 12'h0 : left_rdata_q[43:32];
  logic not_461;
  assign not_461 = ~less_459;
  logic and_462;
  assign and_462 = left_rdata_q[44] & not_461;
  logic and_463;
  assign and_463 = left_rdata_q[45] & not_461;
  logic and_464;
  assign and_464 = left_rdata_q[46] & not_461;
  logic and_465;
  assign and_465 = left_rdata_q[47] & not_461;
  logic equal_466;
  assign equal_466 = row_q[5:2] == 4'h0;
  logic [11:0] select_467;
  assign select_467 = equal_466 ? 12'h0 : left_rdata_q[59:48];
  logic not_468;
  assign not_468 = ~equal_466;
  logic and_469;
  assign and_469 = left_rdata_q[60] & not_468;
  // hls/stages/agreement.hpp:368
  logic [11:0] select_474;
  assign select_474 = equal_445 ? 12'h0 : right_codes_rdata_q[11:0];
  logic and_475;
  assign and_475 = right_codes_rdata_q[12] & not_447;
  logic [11:0] select_476;
  assign select_476 = equal_452 ? 12'h0 : right_codes_rdata_q[24:13];
  logic and_477;
  assign and_477 = right_codes_rdata_q[25] & not_454;
  logic [11:0] select_478;
  assign select_478 = less_459 ? 12'h0 : right_codes_rdata_q[37:26];
  logic and_479;
  assign and_479 = right_codes_rdata_q[38] & not_461;
  logic [11:0] select_480;
  assign select_480 = equal_466 ? 12'h0 : right_codes_rdata_q[50:39];
  logic and_481;
  assign and_481 = right_codes_rdata_q[51] & not_468;
  logic less_482;
  assign less_482 = row_q < 6'h5;
  logic [11:0] select_483;
  assign select_483 = less_482 ? 12'h0 : right_codes_rdata_q[63:52];
  logic and_485;
  assign and_485 = right_codes_rdata_q[64] & (~less_482);
  logic less_486;
  assign less_486 = row_q[5:1] < 5'h3;
  logic [11:0] select_487;
  assign select_487 = less_486 ? 12'h0 : right_codes_rdata_q[76:65];
  logic and_489;
  assign and_489 = right_codes_rdata_q[77] & (~less_486);
  // hls/stages/agreement.hpp:319
  logic not_496;
  assign not_496 = ~equal_353_s1_q;
  // hls/stages/agreement.hpp:299
  logic and_497;
  assign and_497 = not_496 & and_441_s1_q;
  logic select_498;
  assign select_498 = equal_351_s1_q ? and_495_s1_q : and_497;
  // hls/stages/agreement.hpp:162
  logic and_507;
  assign and_507 = left_rdata_q[44] & not_355_s1_q;
  logic [11:0] a;
  assign a = less_354_s1_q ? 12'h0 : left_rdata_q[43:32];
  logic [11:0] b;
  assign b = less_354_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_513;
  assign not_513 = ~(a ^ b);
  logic [1:0] sum_515;
  assign sum_515 = {1'b0, not_513[2]} + ({1'b0, not_513[0]} + {1'b0, not_513[1]});
  logic [2:0] sum_518;
  assign sum_518 = {2'h0, not_513[5]} + ({2'h0, not_513[4]} + ({2'h0, not_513[3]} + {1'b0, sum_515}));
  logic [2:0] sum_519;
  assign sum_519 = {2'h0, not_513[6]} + sum_518;
  logic [3:0] sum_522;
  assign sum_522 = {3'h0, not_513[9]} + ({3'h0, not_513[8]} + ({3'h0, not_513[7]} + {1'b0, sum_519}));
  // hls/stages/agreement.hpp:162
  logic [11:0] a_2;
  assign a_2 = less_354_s1_q ? 12'h0 : left_rdata_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_354_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_532;
  assign not_532 = ~(a_2 ^ b_2);
  logic [1:0] sum_534;
  assign sum_534 = {1'b0, not_532[2]} + ({1'b0, not_532[0]} + {1'b0, not_532[1]});
  logic [2:0] sum_537;
  assign sum_537 = {2'h0, not_532[5]} + ({2'h0, not_532[4]} + ({2'h0, not_532[3]} + {1'b0, sum_534}));
  logic [2:0] sum_538;
  assign sum_538 = {2'h0, not_532[6]} + sum_537;
  logic [3:0] sum_541;
  assign sum_541 = {3'h0, not_532[9]} + ({3'h0, not_532[8]} + ({3'h0, not_532[7]} + {1'b0, sum_538}));
  // hls/stages/agreement.hpp:162
  logic and_546;
  assign and_546 = left_rdata_q[76] & not_355_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_354_s1_q ? 12'h0 : left_rdata_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_354_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_552;
  assign not_552 = ~(a_3 ^ b_3);
  logic [1:0] sum_554;
  assign sum_554 = {1'b0, not_552[2]} + ({1'b0, not_552[0]} + {1'b0, not_552[1]});
  logic [2:0] sum_557;
  assign sum_557 = {2'h0, not_552[5]} + ({2'h0, not_552[4]} + ({2'h0, not_552[3]} + {1'b0, sum_554}));
  logic [2:0] sum_558;
  assign sum_558 = {2'h0, not_552[6]} + sum_557;
  logic [3:0] sum_561;
  assign sum_561 = {3'h0, not_552[9]} + ({3'h0, not_552[8]} + ({3'h0, not_552[7]} + {1'b0, sum_558}));
  logic [11:0] not_573;
  assign not_573 = ~(a ^ b_2);
  logic [1:0] sum_575;
  assign sum_575 = {1'b0, not_573[2]} + ({1'b0, not_573[0]} + {1'b0, not_573[1]});
  logic [2:0] sum_578;
  assign sum_578 = {2'h0, not_573[5]} + ({2'h0, not_573[4]} + ({2'h0, not_573[3]} + {1'b0, sum_575}));
  logic [2:0] sum_579;
  assign sum_579 = {2'h0, not_573[6]} + sum_578;
  logic [3:0] sum_582;
  assign sum_582 = {3'h0, not_573[9]} + ({3'h0, not_573[8]} + ({3'h0, not_573[7]} + {1'b0, sum_579}));
  logic [11:0] not_588;
  assign not_588 = ~(a_2 ^ b_3);
  logic [1:0] sum_590;
  assign sum_590 = {1'b0, not_588[2]} + ({1'b0, not_588[0]} + {1'b0, not_588[1]});
  logic [2:0] sum_593;
  assign sum_593 = {2'h0, not_588[5]} + ({2'h0, not_588[4]} + ({2'h0, not_588[3]} + {1'b0, sum_590}));
  logic [2:0] sum_594;
  assign sum_594 = {2'h0, not_588[6]} + sum_593;
  logic [3:0] sum_597;
  assign sum_597 = {3'h0, not_588[9]} + ({3'h0, not_588[8]} + ({3'h0, not_588[7]} + {1'b0, sum_594}));
  // hls/stages/agreement.hpp:162
  logic [11:0] b_4;
  assign b_4 = less_354_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_606;
  assign not_606 = ~(a_3 ^ b_4);
  logic [1:0] sum_608;
  assign sum_608 = {1'b0, not_606[2]} + ({1'b0, not_606[0]} + {1'b0, not_606[1]});
  logic [2:0] sum_611;
  assign sum_611 = {2'h0, not_606[5]} + ({2'h0, not_606[4]} + ({2'h0, not_606[3]} + {1'b0, sum_608}));
  logic [2:0] sum_612;
  assign sum_612 = {2'h0, not_606[6]} + sum_611;
  logic [3:0] sum_615;
  assign sum_615 = {3'h0, not_606[9]} + ({3'h0, not_606[8]} + ({3'h0, not_606[7]} + {1'b0, sum_612}));
  // hls/stages/agreement.hpp:162
  logic [11:0] b_5;
  assign b_5 = less_354_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_630;
  assign not_630 = ~(a ^ b_5);
  logic [1:0] sum_632;
  assign sum_632 = {1'b0, not_630[2]} + ({1'b0, not_630[0]} + {1'b0, not_630[1]});
  logic [2:0] sum_635;
  assign sum_635 = {2'h0, not_630[5]} + ({2'h0, not_630[4]} + ({2'h0, not_630[3]} + {1'b0, sum_632}));
  logic [2:0] sum_636;
  assign sum_636 = {2'h0, not_630[6]} + sum_635;
  logic [3:0] sum_639;
  assign sum_639 = {3'h0, not_630[9]} + ({3'h0, not_630[8]} + ({3'h0, not_630[7]} + {1'b0, sum_636}));
  logic [11:0] not_645;
  assign not_645 = ~(a_2 ^ b);
  logic [1:0] sum_647;
  assign sum_647 = {1'b0, not_645[2]} + ({1'b0, not_645[0]} + {1'b0, not_645[1]});
  logic [2:0] sum_650;
  assign sum_650 = {2'h0, not_645[5]} + ({2'h0, not_645[4]} + ({2'h0, not_645[3]} + {1'b0, sum_647}));
  logic [2:0] sum_651;
  assign sum_651 = {2'h0, not_645[6]} + sum_650;
  logic [3:0] sum_654;
  assign sum_654 = {3'h0, not_645[9]} + ({3'h0, not_645[8]} + ({3'h0, not_645[7]} + {1'b0, sum_651}));
  logic [11:0] not_661;
  assign not_661 = ~(a_3 ^ b_2);
  logic [1:0] sum_663;
  assign sum_663 = {1'b0, not_661[2]} + ({1'b0, not_661[0]} + {1'b0, not_661[1]});
  logic [2:0] sum_666;
  assign sum_666 = {2'h0, not_661[5]} + ({2'h0, not_661[4]} + ({2'h0, not_661[3]} + {1'b0, sum_663}));
  logic [2:0] sum_667;
  assign sum_667 = {2'h0, not_661[6]} + sum_666;
  logic [3:0] sum_670;
  assign sum_670 = {3'h0, not_661[9]} + ({3'h0, not_661[8]} + ({3'h0, not_661[7]} + {1'b0, sum_667}));
  logic [11:0] not_685;
  assign not_685 = ~(a ^ b_3);
  logic [1:0] sum_687;
  assign sum_687 = {1'b0, not_685[2]} + ({1'b0, not_685[0]} + {1'b0, not_685[1]});
  logic [2:0] sum_690;
  assign sum_690 = {2'h0, not_685[5]} + ({2'h0, not_685[4]} + ({2'h0, not_685[3]} + {1'b0, sum_687}));
  logic [2:0] sum_691;
  assign sum_691 = {2'h0, not_685[6]} + sum_690;
  logic [3:0] sum_694;
  assign sum_694 = {3'h0, not_685[9]} + ({3'h0, not_685[8]} + ({3'h0, not_685[7]} + {1'b0, sum_691}));
  logic [11:0] not_700;
  assign not_700 = ~(a_2 ^ b_4);
  logic [1:0] sum_702;
  assign sum_702 = {1'b0, not_700[2]} + ({1'b0, not_700[0]} + {1'b0, not_700[1]});
  logic [2:0] sum_705;
  assign sum_705 = {2'h0, not_700[5]} + ({2'h0, not_700[4]} + ({2'h0, not_700[3]} + {1'b0, sum_702}));
  logic [2:0] sum_706;
  assign sum_706 = {2'h0, not_700[6]} + sum_705;
  logic [3:0] sum_709;
  assign sum_709 = {3'h0, not_700[9]} + ({3'h0, not_700[8]} + ({3'h0, not_700[7]} + {1'b0, sum_706}));
  // hls/stages/agreement.hpp:162
  logic [11:0] b_6;
  assign b_6 = less_354_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_718;
  assign not_718 = ~(a_3 ^ b_6);
  logic [1:0] sum_720;
  assign sum_720 = {1'b0, not_718[2]} + ({1'b0, not_718[0]} + {1'b0, not_718[1]});
  logic [2:0] sum_723;
  assign sum_723 = {2'h0, not_718[5]} + ({2'h0, not_718[4]} + ({2'h0, not_718[3]} + {1'b0, sum_720}));
  logic [2:0] sum_724;
  assign sum_724 = {2'h0, not_718[6]} + sum_723;
  logic [3:0] sum_727;
  assign sum_727 = {3'h0, not_718[9]} + ({3'h0, not_718[8]} + ({3'h0, not_718[7]} + {1'b0, sum_724}));
  // hls/stages/agreement.hpp:162
  logic [11:0] b_7;
  assign b_7 = less_354_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_747;
  assign not_747 = ~(a ^ b_7);
  logic [1:0] sum_749;
  assign sum_749 = {1'b0, not_747[2]} + ({1'b0, not_747[0]} + {1'b0, not_747[1]});
  logic [2:0] sum_752;
  assign sum_752 = {2'h0, not_747[5]} + ({2'h0, not_747[4]} + ({2'h0, not_747[3]} + {1'b0, sum_749}));
  logic [2:0] sum_753;
  assign sum_753 = {2'h0, not_747[6]} + sum_752;
  logic [3:0] sum_756;
  assign sum_756 = {3'h0, not_747[9]} + ({3'h0, not_747[8]} + ({3'h0, not_747[7]} + {1'b0, sum_753}));
  logic [11:0] not_762;
  assign not_762 = ~(a_2 ^ b_5);
  logic [1:0] sum_764;
  assign sum_764 = {1'b0, not_762[2]} + ({1'b0, not_762[0]} + {1'b0, not_762[1]});
  logic [2:0] sum_767;
  assign sum_767 = {2'h0, not_762[5]} + ({2'h0, not_762[4]} + ({2'h0, not_762[3]} + {1'b0, sum_764}));
  logic [2:0] sum_768;
  assign sum_768 = {2'h0, not_762[6]} + sum_767;
  logic [3:0] sum_771;
  assign sum_771 = {3'h0, not_762[9]} + ({3'h0, not_762[8]} + ({3'h0, not_762[7]} + {1'b0, sum_768}));
  logic [11:0] not_778;
  assign not_778 = ~(a_3 ^ b);
  logic [1:0] sum_780;
  assign sum_780 = {1'b0, not_778[2]} + ({1'b0, not_778[0]} + {1'b0, not_778[1]});
  logic [2:0] sum_783;
  assign sum_783 = {2'h0, not_778[5]} + ({2'h0, not_778[4]} + ({2'h0, not_778[3]} + {1'b0, sum_780}));
  logic [2:0] sum_784;
  assign sum_784 = {2'h0, not_778[6]} + sum_783;
  logic [3:0] sum_787;
  assign sum_787 = {3'h0, not_778[9]} + ({3'h0, not_778[8]} + ({3'h0, not_778[7]} + {1'b0, sum_784}));
  // hls/stages/agreement.hpp:504
  logic not_904;
  assign not_904 = ~(row_q[5:3] == 3'h0);
  // hls/stages/agreement.hpp:299
  logic and_1041;
  assign and_1041 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1039_s1_q);
  // hls/stages/agreement.hpp:242
  logic [5:0] or_1159;
  assign or_1159 = select_302_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:246
  logic select_1301;
  assign select_1301 = equal_1211_s1_q ? (~({row_s1_q, 1'b0} < {sum_1298, cfg_height_i[3]})) : lower_half_q;

  // Memory best_left, 80 x 22, DISTANCE 12, hls/stages/agreement.hpp:768; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 22'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = equal_351_s1_q ? x_s1_2_q : x_s1_q[6:0];
  logic best_left_re;
  assign best_left_re = s1_en & select_498;
  logic [21:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s1_q[6:0];
  logic left_we;
  assign left_we = s1_en & and_357_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_469, select_467, and_465, and_464, and_463, and_462, select_460, and_458, and_457, and_456, and_455, select_453, and_451, and_450, and_449, and_448, select_446, fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_357_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_489, select_487, and_485, select_483, and_481, select_480, and_479, select_478, and_477, select_476, and_475, select_474, fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_336_s1_q ? (equal_1211_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_336_s1_q ? select_1301 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [1:0] age_s2_q;
  logic lower_half_s2_q;
  logic select_300_s2_q;
  logic [6:0] select_302_s2_q;
  logic [8:0] select_306_s2_q;
  logic and_313_s2_q;
  logic equal_318_s2_q;
  logic whole_s2_q;
  logic and_335_s2_q;
  logic and_336_s2_q;
  logic equal_339_s2_q;
  logic equal_351_s2_q;
  logic not_352_s2_q;
  logic equal_353_s2_q;
  logic less_354_s2_q;
  logic not_355_s2_q;
  logic equal_385_s2_q;
  logic drew_s2_q;
  logic left_rdata_s2_q;
  logic [6:0] x_s2_2_q;
  logic not_496_s2_q;
  logic select_498_s2_q;
  logic equal_501_s2_q;
  logic and_507_s2_q;
  logic and_508_s2_q;
  logic not_513_s2_q;
  logic [3:0] sum_523_s2_q;
  logic and_526_s2_q;
  logic and_527_s2_q;
  logic not_532_s2_q;
  logic [3:0] sum_542_s2_q;
  logic and_546_s2_q;
  logic and_547_s2_q;
  logic not_552_s2_q;
  logic [3:0] sum_562_s2_q;
  logic equal_568_s2_q;
  logic not_573_s2_q;
  logic [3:0] sum_583_s2_q;
  logic not_588_s2_q;
  logic [3:0] sum_598_s2_q;
  logic and_602_s2_q;
  logic not_606_s2_q;
  logic [3:0] sum_616_s2_q;
  logic and_626_s2_q;
  logic not_630_s2_q;
  logic [3:0] sum_640_s2_q;
  logic not_645_s2_q;
  logic [3:0] sum_655_s2_q;
  logic not_661_s2_q;
  logic [3:0] sum_671_s2_q;
  logic not_685_s2_q;
  logic [3:0] sum_695_s2_q;
  logic not_700_s2_q;
  logic [3:0] sum_710_s2_q;
  logic and_715_s2_q;
  logic not_718_s2_q;
  logic [3:0] sum_728_s2_q;
  logic and_744_s2_q;
  logic not_747_s2_q;
  logic [3:0] sum_757_s2_q;
  logic not_762_s2_q;
  logic [3:0] sum_772_s2_q;
  logic not_778_s2_q;
  logic [3:0] sum_788_s2_q;
  logic equal_805_s2_q;
  logic and_863_s2_q;
  logic equal_869_s2_q;
  logic equal_892_s2_q;
  logic equal_895_s2_q;
  logic and_906_s2_q;
  logic and_937_s2_q;
  logic select_946_s2_q;
  logic and_1043_s2_q;
  logic equal_1160_s2_q;
  logic equal_1211_s2_q;
  logic not_1257_s2_q;
  logic and_1345_s2_q;
  logic less_1428_s2_q;
  logic less_1431_s2_q;
  logic equal_1693_s2_q;
  logic less_1704_s2_q;
  logic equal_1861_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      age_s2_q <= age_s1_q;
      lower_half_s2_q <= lower_half_q;
      select_300_s2_q <= select_300_s1_q;
      select_302_s2_q <= select_302_s1_q;
      select_306_s2_q <= averager_place_q;
      and_313_s2_q <= and_313_s1_q;
      equal_318_s2_q <= equal_318_s1_q;
      whole_s2_q <= averager_running_mask_q;
      and_335_s2_q <= and_335_s1_q;
      and_336_s2_q <= and_336_s1_q;
      equal_339_s2_q <= equal_339_s1_q;
      equal_351_s2_q <= equal_351_s1_q;
      not_352_s2_q <= not_352_s1_q;
      equal_353_s2_q <= equal_353_s1_q;
      less_354_s2_q <= less_354_s1_q;
      not_355_s2_q <= not_355_s1_q;
      equal_385_s2_q <= row_s1_q == 6'h0;
      drew_s2_q <= drew_s1_q;
      left_rdata_s2_q <= left_rdata_q[63];
      x_s2_2_q <= x_s1_2_q;
      not_496_s2_q <= not_496;
      select_498_s2_q <= select_498;
      equal_501_s2_q <= equal_501_s1_q;
      and_507_s2_q <= and_507;
      and_508_s2_q <= right_codes_rdata_q[38] & not_355_s1_q;
      not_513_s2_q <= not_513[11];
      sum_523_s2_q <= {3'h0, not_513[10]} + sum_522;
      and_526_s2_q <= left_rdata_q[60] & not_355_s1_q;
      and_527_s2_q <= right_codes_rdata_q[51] & not_355_s1_q;
      not_532_s2_q <= not_532[11];
      sum_542_s2_q <= {3'h0, not_532[10]} + sum_541;
      and_546_s2_q <= and_546;
      and_547_s2_q <= right_codes_rdata_q[64] & not_355_s1_q;
      not_552_s2_q <= not_552[11];
      sum_562_s2_q <= {3'h0, not_552[10]} + sum_561;
      equal_568_s2_q <= equal_568_s1_q;
      not_573_s2_q <= not_573[11];
      sum_583_s2_q <= {3'h0, not_573[10]} + sum_582;
      not_588_s2_q <= not_588[11];
      sum_598_s2_q <= {3'h0, not_588[10]} + sum_597;
      and_602_s2_q <= right_codes_rdata_q[77] & not_355_s1_q;
      not_606_s2_q <= not_606[11];
      sum_616_s2_q <= {3'h0, not_606[10]} + sum_615;
      and_626_s2_q <= right_codes_rdata_q[25] & not_355_s1_q;
      not_630_s2_q <= not_630[11];
      sum_640_s2_q <= {3'h0, not_630[10]} + sum_639;
      not_645_s2_q <= not_645[11];
      sum_655_s2_q <= {3'h0, not_645[10]} + sum_654;
      not_661_s2_q <= not_661[11];
      sum_671_s2_q <= {3'h0, not_661[10]} + sum_670;
      not_685_s2_q <= not_685[11];
      sum_695_s2_q <= {3'h0, not_685[10]} + sum_694;
      not_700_s2_q <= not_700[11];
      sum_710_s2_q <= {3'h0, not_700[10]} + sum_709;
      and_715_s2_q <= and_546 & (right_codes_rdata_q[90] & not_355_s1_q);
      not_718_s2_q <= not_718[11];
      sum_728_s2_q <= {3'h0, not_718[10]} + sum_727;
      and_744_s2_q <= and_507 & (right_codes_rdata_q[12] & not_355_s1_q);
      not_747_s2_q <= not_747[11];
      sum_757_s2_q <= {3'h0, not_747[10]} + sum_756;
      not_762_s2_q <= not_762[11];
      sum_772_s2_q <= {3'h0, not_762[10]} + sum_771;
      not_778_s2_q <= not_778[11];
      sum_788_s2_q <= {3'h0, not_778[10]} + sum_787;
      equal_805_s2_q <= equal_805_s1_q;
      and_863_s2_q <= equal_351_s1_q & and_495_s1_q;
      equal_869_s2_q <= equal_869_s1_q;
      equal_892_s2_q <= equal_892_s1_q;
      equal_895_s2_q <= equal_895_s1_q;
      and_906_s2_q <= left_rdata_q[61] & (left_rdata_q[62] & not_904);
      and_937_s2_q <= not_352_s1_q & and_497;
      select_946_s2_q <= select_946_s1_q;
      and_1043_s2_q <= not_352_s1_q & (not_496 & and_1041);
      equal_1160_s2_q <= {select_302_s1_q[6], or_1159} == 7'h0;
      equal_1211_s2_q <= equal_1211_s1_q;
      not_1257_s2_q <= not_1257_s1_q;
      and_1345_s2_q <= left_rdata_q[61] & not_904;
      less_1428_s2_q <= 5'h4 < row_q[5:1];
      less_1431_s2_q <= less_1431_s1_q;
      equal_1693_s2_q <= row_s1_q[5:2] == 4'h0;
      less_1704_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_1861_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic averager_running_of_skin_q;
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
  logic began_q;
  logic [2:0] seen_x_q;
  logic [2:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/census.hpp:91
  logic [11:0] select_316;
  assign select_316 = select_300_s2_q ? ({4'h0, pixel_0_s2_q} + averager_running_0_q) : {4'h0, pixel_0_s2_q};
  logic [11:0] sum_322;
  assign sum_322 = {4'h0, pixel_1_s2_q} + (select_300_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/agreement.hpp:174
  logic all_of_skin;
  assign all_of_skin = select_300_s2_q ? (mask_s2_q & averager_running_of_skin_q) : mask_s2_q;
  // hls/stages/agreement.hpp:377
  logic [3:0] column;
  assign column = (and_507_s2_q & and_508_s2_q) ? ({3'h0, not_513_s2_q} + sum_523_s2_q) : 4'h0;
  logic [3:0] select_544;
  assign select_544 = (and_526_s2_q & and_527_s2_q) ? ({3'h0, not_532_s2_q} + sum_542_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_2;
  assign column_2 = {1'b0, column} + {1'b0, select_544};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_564;
  assign select_564 = (and_546_s2_q & and_547_s2_q) ? ({3'h0, not_552_s2_q} + sum_562_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_3;
  assign column_3 = {1'b0, column_2} + {2'h0, select_564};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_567;
  assign difference_567 = {2'h0, column_3} - (age_s2_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_570;
  assign sum_570 = difference_567 + (equal_568_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:377
  logic [3:0] column_4;
  assign column_4 = (and_507_s2_q & and_527_s2_q) ? ({3'h0, not_573_s2_q} + sum_583_s2_q) : 4'h0;
  logic [3:0] select_600;
  assign select_600 = (and_526_s2_q & and_547_s2_q) ? ({3'h0, not_588_s2_q} + sum_598_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_5;
  assign column_5 = {1'b0, column_4} + {1'b0, select_600};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_618;
  assign select_618 = (and_546_s2_q & and_602_s2_q) ? ({3'h0, not_606_s2_q} + sum_616_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_6;
  assign column_6 = {1'b0, column_5} + {2'h0, select_618};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_621;
  assign difference_621 = {2'h0, column_6} - (age_s2_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_623;
  assign sum_623 = difference_621 + (equal_568_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:420
  logic less_624;
  assign less_624 = sum_570 < sum_623;
  // hls/stages/agreement.hpp:377
  logic [3:0] column_7;
  assign column_7 = (and_507_s2_q & and_626_s2_q) ? ({3'h0, not_630_s2_q} + sum_640_s2_q) : 4'h0;
  logic [3:0] select_657;
  assign select_657 = (and_526_s2_q & and_508_s2_q) ? ({3'h0, not_645_s2_q} + sum_655_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_8;
  assign column_8 = {1'b0, column_7} + {1'b0, select_657};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_673;
  assign select_673 = (and_546_s2_q & and_527_s2_q) ? ({3'h0, not_661_s2_q} + sum_671_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_9;
  assign column_9 = {1'b0, column_8} + {2'h0, select_673};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_676;
  assign difference_676 = {2'h0, column_9} - (age_s2_q[1] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_678;
  assign sum_678 = difference_676 + (equal_568_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:420
  logic not_680;
  assign not_680 = ~less_624;
  logic [1:0] best;
  assign best = ((less_624 ? sum_623 : sum_570) < sum_678) ? 2'h3 : {not_680, less_624};
  // hls/stages/agreement.hpp:377
  logic [3:0] column_10;
  assign column_10 = (and_507_s2_q & and_547_s2_q) ? ({3'h0, not_685_s2_q} + sum_695_s2_q) : 4'h0;
  logic [3:0] select_712;
  assign select_712 = (and_526_s2_q & and_602_s2_q) ? ({3'h0, not_700_s2_q} + sum_710_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_11;
  assign column_11 = {1'b0, column_10} + {1'b0, select_712};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_730;
  assign select_730 = and_715_s2_q ? ({3'h0, not_718_s2_q} + sum_728_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_12;
  assign column_12 = {1'b0, column_11} + {2'h0, select_730};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_733;
  assign difference_733 = {2'h0, column_12} - (age_s2_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_735;
  assign sum_735 = difference_733 + (equal_568_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:420
  logic [7:0] select_737;
  assign select_737 = best[1] ? (best[0] ? sum_678 : sum_570) : (best[0] ? sum_623 : sum_735);
  logic [1:0] best_2;
  assign best_2 = (select_737 < sum_735) ? 2'h0 : best;
  // hls/stages/agreement.hpp:377
  logic [3:0] column_13;
  assign column_13 = and_744_s2_q ? ({3'h0, not_747_s2_q} + sum_757_s2_q) : 4'h0;
  logic [3:0] select_774;
  assign select_774 = (and_526_s2_q & and_626_s2_q) ? ({3'h0, not_762_s2_q} + sum_772_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_14;
  assign column_14 = {1'b0, column_13} + {1'b0, select_774};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_790;
  assign select_790 = (and_546_s2_q & and_508_s2_q) ? ({3'h0, not_778_s2_q} + sum_788_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_15;
  assign column_15 = {1'b0, column_14} + {2'h0, select_790};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_793;
  assign difference_793 = {2'h0, column_15} - (age_s2_q[1] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_795;
  assign sum_795 = difference_793 + (equal_568_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:432
  logic [6:0] partner;
  assign partner = {run_shift_s2_q[5], run_shift_s2_q} + x_s2_2_q;
  // hls/stages/agreement.hpp:299
  logic [6:0] select_866;
  assign select_866 = equal_351_s2_q ? partner : (x_s2_q[6:0] + {best_left_rdata_q[13], best_left_rdata_q[13:8]});
  // hls/stages/agreement.hpp:176
  logic next_row;
  assign next_row = select_946_s2_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:714
  logic [6:0] select_949;
  assign select_949 = next_row ? cfg_width_i[9:3] : 7'h0;
  // hls/stages/agreement.hpp:724
  logic equal_952;
  assign equal_952 = seen_x_q == 3'h7;
  // hls/stages/census.hpp:31
  logic not_959;
  assign not_959 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1304;
  assign select_1304 = equal_351_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1305;
  assign select_1305 = equal_351_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1306;
  assign select_1306 = equal_351_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1307;
  assign select_1307 = equal_351_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1308;
  assign select_1308 = equal_351_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1309;
  assign select_1309 = equal_351_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1312;
  assign select_1312 = equal_351_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1313;
  assign select_1313 = equal_351_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1314;
  assign select_1314 = equal_351_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1315;
  assign select_1315 = equal_351_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1316;
  assign select_1316 = equal_351_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1317;
  assign select_1317 = equal_351_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1320;
  assign select_1320 = equal_351_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1321;
  assign select_1321 = equal_351_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1322;
  assign select_1322 = equal_351_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1323;
  assign select_1323 = equal_351_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1324;
  assign select_1324 = equal_351_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1325;
  assign select_1325 = equal_351_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1328;
  assign select_1328 = equal_351_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1329;
  assign select_1329 = equal_351_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1330;
  assign select_1330 = equal_351_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1331;
  assign select_1331 = equal_351_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1332;
  assign select_1332 = equal_351_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1333;
  assign select_1333 = equal_351_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1336;
  assign select_1336 = equal_351_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1337;
  assign select_1337 = equal_351_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1338;
  assign select_1338 = equal_351_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1339;
  assign select_1339 = equal_351_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1340;
  assign select_1340 = equal_351_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1341;
  assign select_1341 = equal_351_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/registration.hpp:158
  logic [16:0] select_1436;
  assign select_1436 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [13:0] select_1438;
  assign select_1438 = ($signed(10'h0) < $signed(select_1436[16:7])) ? 14'h7f : select_1436[13:0];
  // hls/stages/registration.hpp:153
  logic [9:0] select_1439;
  assign select_1439 = best_left_rdata_q[12] ? select_1438[9:0] : 10'h0;
  logic [8:0] difference_1441;
  assign difference_1441 = select_1439[9:1] - (best_left_rdata_q[13] ? select_1438[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1444;
  assign sum_1444 = (best_left_rdata_q[8] ? select_1438[13:1] : 13'h0) + (best_left_rdata_q[9] ? select_1438[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1445;
  assign select_1445 = best_left_rdata_q[10] ? select_1438[11:0] : 12'h0;
  logic [10:0] sum_1447;
  assign sum_1447 = select_1445[11:1] + (best_left_rdata_q[11] ? select_1438[10:0] : 11'h0);
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1448;
  assign sum_1448 = sum_1444[12:1] + {sum_1447, select_1445[0]};
  logic [9:0] sum_1449;
  assign sum_1449 = {difference_1441, select_1439[0]} + sum_1448[11:2];
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1450;
  assign sum_1450 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_1449[9]}}, sum_1449[9:2]};
  // hls/stages/registration.hpp:151
  logic [7:0] select_1453;
  assign select_1453 = ($signed(sum_1450[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1450[7:0];
  logic [7:0] slope;
  assign slope = ($signed(6'h0) < $signed(sum_1450[12:7])) ? 8'h7f : select_1453;
  logic [6:0] select_1455;
  assign select_1455 = best_left_rdata_q[8] ? slope[7:1] : 7'h0;
  logic [7:0] select_1456;
  assign select_1456 = best_left_rdata_q[9] ? slope : 8'h0;
  logic [8:0] sum_1457;
  assign sum_1457 = {{2{select_1455[6]}}, select_1455} + {select_1456[7], select_1456};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1458;
  assign select_1458 = best_left_rdata_q[10] ? slope : 8'h0;
  logic [7:0] select_1459;
  assign select_1459 = best_left_rdata_q[11] ? slope : 8'h0;
  logic [8:0] sum_1460;
  assign sum_1460 = {{2{select_1458[7]}}, select_1458[7:1]} + {select_1459[7], select_1459};
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1461;
  assign sum_1461 = {{3{sum_1457[8]}}, sum_1457[8:1]} + {sum_1460[8], sum_1460, select_1458[0]};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1462;
  assign select_1462 = best_left_rdata_q[12] ? slope : 8'h0;
  logic [7:0] select_1463;
  assign select_1463 = best_left_rdata_q[13] ? slope : 8'h0;
  logic [8:0] difference_1464;
  assign difference_1464 = {{2{select_1462[7]}}, select_1462[7:1]} - {select_1463[7], select_1463};
  // hls/stages/registration.hpp:57
  logic [23:0] select_1694;
  assign select_1694 = equal_1693_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1696;
  assign select_1696 = and_336_s2_q ? (equal_1211_s2_q ? select_1694 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/registration.hpp:58
  logic [27:0] select_1697;
  assign select_1697 = equal_1693_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:176
  logic [27:0] select_1699;
  assign select_1699 = and_336_s2_q ? (equal_1211_s2_q ? select_1697 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/registration.hpp:48
  logic [27:0] select_1701;
  assign select_1701 = drew_s2_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_1702;
  assign sum_1702 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_1703;
  assign sum_1703 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;
  // hls/stages/agreement.hpp:723
  logic [2:0] select_1881;
  assign select_1881 = select_946_s2_q ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1887;
  assign select_1887 = marks_first_s2_q ? (less_1883 ? {sum_1884, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory averager_memory, 320 x 26, DISTANCE 16, hls/stages/census.hpp:146; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_306_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_313_s2_q;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 80 x 78, DISTANCE 16, hls/stages/census.hpp:254; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = select_302_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_336_s2_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory best_right, 80 x 15, DISTANCE 12, hls/stages/agreement.hpp:769; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 15'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = select_866;
  logic best_right_re;
  assign best_right_re = s2_en & select_498_s2_q;
  logic [14:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory seen_columns, 80 x 12, DISTANCE 12, hls/stages/agreement.hpp:797; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [11:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 12'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_937_s2_q;
  logic [11:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_running_of_skin_q <= 1'b0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      registration_next_slope_row_q <= 24'h0;
      registration_next_slope_change_q <= 28'h0;
      began_q <= 1'b0;
      seen_x_q <= 3'h0;
      seen_y_q <= 3'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 13'h0;
    end else if (s2_en) begin
      averager_running_of_skin_q <= all_of_skin;
      registration_slope_row_q <= select_1696;
      registration_slope_change_q <= select_1699;
      registration_slope_q <= select_1701;
      registration_next_slope_row_q <= sum_1702;
      registration_next_slope_change_q <= sum_1703;
      began_q <= not_959 & (began_q | select_946_s2_q);
      seen_x_q <= select_946_s2_q ? 3'h0 : (seen_x_q + 3'h1);
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_1881;
      seen_column_q <= select_946_s2_q ? 8'h0 : (seen_column_q + {7'h0, equal_952});
      seen_rows_left_q <= select_1887;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_949});
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
      averager_running_0_q <= select_316;
      averager_running_1_q <= sum_322;
      sums_0_columns_values_0_q <= equal_351_s2_q ? {2'h0, column_12} : sums_0_columns_values_0_q;
      sums_0_columns_values_1_q <= select_1304;
      sums_0_columns_values_2_q <= select_1305;
      sums_0_columns_values_3_q <= select_1306;
      sums_0_columns_values_4_q <= select_1307;
      sums_0_columns_values_5_q <= select_1308;
      sums_0_columns_values_6_q <= select_1309;
      sums_0_sum_sums_values_0_q <= equal_351_s2_q ? sum_735 : sums_0_sum_sums_values_0_q;
      sums_1_columns_values_0_q <= equal_351_s2_q ? {2'h0, column_6} : sums_1_columns_values_0_q;
      sums_1_columns_values_1_q <= select_1312;
      sums_1_columns_values_2_q <= select_1313;
      sums_1_columns_values_3_q <= select_1314;
      sums_1_columns_values_4_q <= select_1315;
      sums_1_columns_values_5_q <= select_1316;
      sums_1_columns_values_6_q <= select_1317;
      sums_1_sum_sums_values_0_q <= equal_351_s2_q ? sum_623 : sums_1_sum_sums_values_0_q;
      sums_2_columns_values_0_q <= equal_351_s2_q ? {2'h0, column_3} : sums_2_columns_values_0_q;
      sums_2_columns_values_1_q <= select_1320;
      sums_2_columns_values_2_q <= select_1321;
      sums_2_columns_values_3_q <= select_1322;
      sums_2_columns_values_4_q <= select_1323;
      sums_2_columns_values_5_q <= select_1324;
      sums_2_columns_values_6_q <= select_1325;
      sums_2_sum_sums_values_0_q <= equal_351_s2_q ? sum_570 : sums_2_sum_sums_values_0_q;
      sums_3_columns_values_0_q <= equal_351_s2_q ? {2'h0, column_9} : sums_3_columns_values_0_q;
      sums_3_columns_values_1_q <= select_1328;
      sums_3_columns_values_2_q <= select_1329;
      sums_3_columns_values_3_q <= select_1330;
      sums_3_columns_values_4_q <= select_1331;
      sums_3_columns_values_5_q <= select_1332;
      sums_3_columns_values_6_q <= select_1333;
      sums_3_sum_sums_values_0_q <= equal_351_s2_q ? sum_678 : sums_3_sum_sums_values_0_q;
      sums_4_columns_values_0_q <= equal_351_s2_q ? {2'h0, column_15} : sums_4_columns_values_0_q;
      sums_4_columns_values_1_q <= select_1336;
      sums_4_columns_values_2_q <= select_1337;
      sums_4_columns_values_3_q <= select_1338;
      sums_4_columns_values_4_q <= select_1339;
      sums_4_columns_values_5_q <= select_1340;
      sums_4_columns_values_6_q <= select_1341;
      sums_4_sum_sums_values_0_q <= equal_351_s2_q ? sum_795 : sums_4_sum_sums_values_0_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic [5:0] run_shift_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic lower_half_s3_q;
  logic [6:0] select_302_s3_q;
  logic [8:0] select_306_s3_q;
  logic and_313_s3_q;
  logic equal_318_s3_q;
  logic whole_s3_q;
  logic and_335_s3_q;
  logic and_336_s3_q;
  logic equal_339_s3_q;
  logic equal_351_s3_q;
  logic not_352_s3_q;
  logic equal_353_s3_q;
  logic less_354_s3_q;
  logic not_355_s3_q;
  logic equal_385_s3_q;
  logic drew_s3_q;
  logic left_rdata_s3_q;
  logic [6:0] x_s3_2_q;
  logic not_496_s3_q;
  logic [21:0] best_left_rdata_s3_q;
  logic equal_501_s3_q;
  logic [7:0] sum_570_s3_q;
  logic [7:0] sum_623_s3_q;
  logic [7:0] sum_678_s3_q;
  logic [7:0] sum_735_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_795_s3_q;
  logic equal_805_s3_q;
  logic and_863_s3_q;
  logic [6:0] partner_s3_q;
  logic equal_869_s3_q;
  logic equal_892_s3_q;
  logic equal_895_s3_q;
  logic and_906_s3_q;
  logic and_937_s3_q;
  logic not_959_s3_q;
  logic and_1043_s3_q;
  logic equal_1160_s3_q;
  logic equal_1211_s3_q;
  logic not_1257_s3_q;
  logic and_1345_s3_q;
  logic less_1428_s3_q;
  logic less_1431_s3_q;
  logic [9:0] sum_1461_s3_q;
  logic select_1462_s3_q;
  logic [8:0] difference_1464_s3_q;
  logic less_1704_s3_q;
  logic equal_1861_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      run_shift_s3_q <= run_shift_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[0];
      lower_half_s3_q <= lower_half_s2_q;
      select_302_s3_q <= select_302_s2_q;
      select_306_s3_q <= select_306_s2_q;
      and_313_s3_q <= and_313_s2_q;
      equal_318_s3_q <= equal_318_s2_q;
      whole_s3_q <= whole_s2_q;
      and_335_s3_q <= and_335_s2_q;
      and_336_s3_q <= and_336_s2_q;
      equal_339_s3_q <= equal_339_s2_q;
      equal_351_s3_q <= equal_351_s2_q;
      not_352_s3_q <= not_352_s2_q;
      equal_353_s3_q <= equal_353_s2_q;
      less_354_s3_q <= less_354_s2_q;
      not_355_s3_q <= not_355_s2_q;
      equal_385_s3_q <= equal_385_s2_q;
      drew_s3_q <= drew_s2_q;
      left_rdata_s3_q <= left_rdata_s2_q;
      x_s3_2_q <= x_s2_2_q;
      not_496_s3_q <= not_496_s2_q;
      best_left_rdata_s3_q <= best_left_rdata_q;
      equal_501_s3_q <= equal_501_s2_q;
      sum_570_s3_q <= sum_570;
      sum_623_s3_q <= sum_623;
      sum_678_s3_q <= sum_678;
      sum_735_s3_q <= sum_735;
      best_2_s3_q <= best_2;
      sum_795_s3_q <= sum_795;
      equal_805_s3_q <= equal_805_s2_q;
      and_863_s3_q <= and_863_s2_q;
      partner_s3_q <= partner;
      equal_869_s3_q <= equal_869_s2_q;
      equal_892_s3_q <= equal_892_s2_q;
      equal_895_s3_q <= equal_895_s2_q;
      and_906_s3_q <= and_906_s2_q;
      and_937_s3_q <= and_937_s2_q;
      not_959_s3_q <= not_959;
      and_1043_s3_q <= and_1043_s2_q;
      equal_1160_s3_q <= equal_1160_s2_q;
      equal_1211_s3_q <= equal_1211_s2_q;
      not_1257_s3_q <= not_1257_s2_q;
      and_1345_s3_q <= and_1345_s2_q;
      less_1428_s3_q <= less_1428_s2_q;
      less_1431_s3_q <= less_1431_s2_q;
      sum_1461_s3_q <= sum_1461[10:1];
      select_1462_s3_q <= select_1462[0];
      difference_1464_s3_q <= difference_1464;
      less_1704_s3_q <= less_1704_s2_q;
      equal_1861_s3_q <= equal_1861_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
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
  logic centres_values_0_q;
  logic centres_values_1_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic proven_q;
  logic said_q;
  // hls/stages/census.hpp:100
  logic [11:0] sum_320;
  assign sum_320 = averager_running_0_q + (equal_318_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  logic [11:0] sum_324;
  assign sum_324 = averager_running_1_q + (equal_318_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:101
  logic and_328;
  assign and_328 = whole_s3_q & (averager_memory_rdata_q[24] | equal_318_s3_q);
  // hls/stages/census.hpp:102
  logic and_332;
  assign and_332 = averager_running_of_skin_q & (averager_memory_rdata_q[25] | equal_318_s3_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_313_s3_q ? sum_320[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_339_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey_2;
  assign grey_2 = and_313_s3_q ? sum_324[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_339_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:126
  logic and_345;
  assign and_345 = and_313_s3_q & and_328;
  // hls/stages/census.hpp:105
  logic whole_2;
  assign whole_2 = equal_339_s3_q ? and_345 : (averager_mask_q & and_345);
  // hls/stages/census.hpp:126
  logic and_348;
  assign and_348 = and_313_s3_q & and_332;
  // hls/stages/census.hpp:105
  logic select_350;
  assign select_350 = equal_339_s3_q ? and_348 : (averager_of_skin_q & and_348);
  // hls/stages/census.hpp:214
  logic less_359;
  assign less_359 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_360;
  assign less_360 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_361;
  assign less_361 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_362;
  assign less_362 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_363;
  assign less_363 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_364;
  assign less_364 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_365;
  assign less_365 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_366;
  assign less_366 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_367;
  assign less_367 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_368;
  assign less_368 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_369;
  assign less_369 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_370;
  assign less_370 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_371;
  assign less_371 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_372;
  assign less_372 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_373;
  assign less_373 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_374;
  assign less_374 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_375;
  assign less_375 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_376;
  assign less_376 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_377;
  assign less_377 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_378;
  assign less_378 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_379;
  assign less_379 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_380;
  assign less_380 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_381;
  assign less_381 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_382;
  assign less_382 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:241
  logic equal_383;
  assign equal_383 = select_302_s3_q == 7'h0;
  logic [3:0] select_386;
  assign select_386 = equal_385_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:242
  logic [4:0] select_387;
  assign select_387 = equal_383 ? {select_386, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_388;
  assign select_388 = equal_383 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:219
  logic and_389;
  assign and_389 = select_387[4] & select_388[3];
  // hls/stages/census.hpp:206
  logic and_391;
  assign and_391 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_393;
  assign and_393 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_391);
  // hls/stages/agreement.hpp:242
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_393;
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
  logic [9:0] difference_416;
  assign difference_416 = {1'b0, total[10:2]} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_417;
  assign xor_417 = difference_416[8:0] ^ {9{difference_416[9]}};
  logic [9:0] sum_418;
  assign sum_418 = {9'h0, difference_416[9]} + {1'b0, xor_417};
  logic [9:0] difference_419;
  assign difference_419 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_420;
  assign xor_420 = difference_419[8:0] ^ {9{difference_419[9]}};
  logic [9:0] sum_421;
  assign sum_421 = {9'h0, difference_419[9]} + {1'b0, xor_420};
  logic [9:0] difference_423;
  assign difference_423 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_424;
  assign xor_424 = difference_423[8:0] ^ {9{difference_423[9]}};
  logic [9:0] sum_425;
  assign sum_425 = {9'h0, difference_423[9]} + {1'b0, xor_424};
  logic [10:0] sum_426;
  assign sum_426 = ({1'b0, sum_418} + {1'b0, sum_421}) + {1'b0, sum_425};
  logic [9:0] difference_427;
  assign difference_427 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_428;
  assign xor_428 = difference_427[8:0] ^ {9{difference_427[9]}};
  logic [9:0] sum_429;
  assign sum_429 = {9'h0, difference_427[9]} + {1'b0, xor_428};
  logic [9:0] difference_431;
  assign difference_431 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_432;
  assign xor_432 = difference_431[8:0] ^ {9{difference_431[9]}};
  logic [9:0] sum_433;
  assign sum_433 = {9'h0, difference_431[9]} + {1'b0, xor_432};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_426} + {2'h0, sum_429}) + {2'h0, sum_433};
  // hls/stages/agreement.hpp:412
  logic not_503;
  assign not_503 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_504;
  assign less_504 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:420
  logic [7:0] select_742;
  assign select_742 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_678_s3_q : sum_570_s3_q) : (best_2_s3_q[0] ? sum_623_s3_q : sum_735_s3_q);
  logic less_796;
  assign less_796 = select_742 < sum_795_s3_q;
  logic [1:0] select_797;
  assign select_797 = less_796 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_800;
  assign select_800 = select_797[1] ? (select_797[0] ? sum_678_s3_q : sum_570_s3_q) : (select_797[0] ? sum_623_s3_q : sum_735_s3_q);
  logic [7:0] of_best;
  assign of_best = less_796 ? sum_795_s3_q : select_800;
  logic [7:0] of_best_2;
  assign of_best_2 = (not_503 & (~less_504)) ? of_best : 8'h0;
  // hls/stages/agreement.hpp:424
  logic less_803;
  assign less_803 = $signed(run_shift_s3_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:427
  logic less_804;
  assign less_804 = best_left_rdata_s3_q[7:0] < of_best_2;
  logic or_806;
  assign or_806 = less_804 | equal_805_s3_q;
  // hls/stages/agreement.hpp:430
  logic [7:0] select_809;
  assign select_809 = less_803 ? (or_806 ? of_best_2 : best_left_rdata_s3_q[7:0]) : (less_804 ? of_best_2 : best_left_rdata_s3_q[7:0]);
  logic [5:0] select_813;
  assign select_813 = less_803 ? (or_806 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]) : (less_804 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]);
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_796, select_797} == 3'h4) ? 3'h3 : (({less_796, select_797} == 3'h0) ? 3'h1 : {less_796, select_797});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_820;
  assign sum_820 = near_best + 3'h1;
  logic [7:0] select_823;
  assign select_823 = sum_820[1] ? (sum_820[0] ? sum_678_s3_q : sum_570_s3_q) : (sum_820[0] ? sum_623_s3_q : sum_735_s3_q);
  logic [7:0] below;
  assign below = sum_820[2] ? sum_795_s3_q : select_823;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_825;
  assign sum_825 = near_best + 3'h7;
  logic [7:0] select_828;
  assign select_828 = sum_825[1] ? (sum_825[0] ? sum_678_s3_q : sum_570_s3_q) : (sum_825[0] ? sum_623_s3_q : sum_735_s3_q);
  logic [7:0] above;
  assign above = sum_825[2] ? sum_795_s3_q : select_828;
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/registration.hpp:26
  logic [7:0] select_834;
  assign select_834 = near_best[1] ? (near_best[0] ? sum_678_s3_q : sum_570_s3_q) : (near_best[0] ? sum_623_s3_q : sum_735_s3_q);
  logic [7:0] select_835;
  assign select_835 = near_best[2] ? sum_795_s3_q : select_834;
  logic [7:0] select_836;
  assign select_836 = rise[8] ? below : above;
  logic [8:0] fall;
  assign fall = {1'b0, select_835} - {1'b0, select_836};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [7:0] xor_839;
  assign xor_839 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_839};
  // hls/stages/agreement.hpp:434
  logic less_868;
  assign less_868 = best_right_rdata_q[7:0] < of_best_2;
  logic or_870;
  assign or_870 = less_868 | equal_869_s3_q;
  // hls/stages/agreement.hpp:435
  logic [7:0] select_873;
  assign select_873 = less_803 ? (or_870 ? of_best_2 : best_right_rdata_q[7:0]) : (less_868 ? of_best_2 : best_right_rdata_q[7:0]);
  logic [7:0] select_874;
  assign select_874 = equal_501_s3_q ? of_best_2 : select_873;
  logic [6:0] select_877;
  assign select_877 = less_803 ? (or_870 ? x_s3_2_q : best_right_rdata_q[14:8]) : (less_868 ? x_s3_2_q : best_right_rdata_q[14:8]);
  logic [6:0] select_878;
  assign select_878 = equal_501_s3_q ? x_s3_2_q : select_877;
  // hls/stages/agreement.hpp:140
  logic [7:0] select_879;
  assign select_879 = drew_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:538
  logic or_882;
  assign or_882 = select_879[7] | (~({select_879[5], select_879[3], select_879[1]} == 3'h0));
  // hls/stages/agreement.hpp:537
  logic or_885;
  assign or_885 = select_879[7] | (~({select_879[6], select_879[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:536
  logic or_888;
  assign or_888 = select_879[7] | (~(select_879[6:4] == 3'h0));
  // hls/stages/division.hpp:18
  logic [5:0] sum_890;
  assign sum_890 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:546
  logic or_893;
  assign or_893 = (~sum_890[5]) | equal_892_s3_q;
  // hls/stages/agreement.hpp:516
  logic and_894;
  assign and_894 = not_355_s3_q & or_893;
  // hls/stages/agreement.hpp:606
  logic equal_896;
  assign equal_896 = x_s3_q[5:4] == 2'h3;
  // hls/stages/agreement.hpp:299
  logic and_898;
  assign and_898 = equal_895_s3_q & (~equal_896);
  // hls/stages/agreement.hpp:165
  logic textured;
  assign textured = not_355_s3_q & and_906_s3_q;
  // hls/stages/agreement.hpp:505
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s3_q};
  // hls/stages/agreement.hpp:507
  logic [9:0] sum_915;
  assign sum_915 = {way[8], way} + 10'h1;
  logic and_917;
  assign and_917 = (and_906_s3_q & (8'hb6 < best_left_rdata_s3_q[7:0])) & ({{6{sum_915[9]}}, sum_915} < 16'h3);
  // hls/stages/agreement.hpp:165
  logic explained;
  assign explained = not_355_s3_q & and_917;
  // hls/stages/agreement.hpp:509
  logic and_925;
  assign and_925 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s3_q[13:8]));
  // hls/stages/agreement.hpp:165
  logic and_927;
  assign and_927 = and_917 & ((cfg_nearer_below_i & best_left_rdata_s3_q[13]) | and_925);
  logic near;
  assign near = not_355_s3_q & and_927;
  // hls/stages/agreement.hpp:727
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:698
  logic select_957;
  assign select_957 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:684
  logic [7:0] sum_958;
  assign sum_958 = {1'b0, select_957, 2'h0, select_957, 1'b0, {2{select_957}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:726
  logic and_965;
  assign and_965 = began_q & (seen_x_q == 3'h0);
  logic less_966;
  assign less_966 = seen_column_q < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:589
  logic [7:0] sum_969;
  assign sum_969 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_969[7]}}, sum_969, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:684
  logic [7:0] sum_971;
  assign sum_971 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:516
  logic [3:0] select_972;
  assign select_972 = less_354_s3_q ? 4'h0 : seen_columns_rdata_q[11:8];
  logic and_973;
  assign and_973 = seen_columns_rdata_q[6] & not_355_s3_q;
  logic and_974;
  assign and_974 = seen_columns_rdata_q[3] & not_355_s3_q;
  logic and_975;
  assign and_975 = seen_columns_rdata_q[0] & not_355_s3_q;
  // hls/stages/agreement.hpp:569
  logic [1:0] sum_977;
  assign sum_977 = {1'b0, and_974} + ({1'b0, textured} + {1'b0, and_975});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, select_972[1]} + ({2'h0, and_973} + {1'b0, sum_977});
  // hls/stages/agreement.hpp:516
  logic [7:0] select_987;
  assign select_987 = less_354_s3_q ? select_879 : (sum_890[5] ? select_879 : {select_879[6:0], 1'b0});
  // hls/stages/agreement.hpp:538
  logic or_990;
  assign or_990 = select_987[7] | (~({select_987[5], select_987[3], select_987[1]} == 3'h0));
  // hls/stages/agreement.hpp:516
  logic and_1006;
  assign and_1006 = seen_columns_rdata_q[7] & not_355_s3_q;
  logic and_1007;
  assign and_1007 = seen_columns_rdata_q[4] & not_355_s3_q;
  logic and_1008;
  assign and_1008 = seen_columns_rdata_q[1] & not_355_s3_q;
  // hls/stages/agreement.hpp:570
  logic [1:0] sum_1010;
  assign sum_1010 = {1'b0, and_1007} + ({1'b0, explained} + {1'b0, and_1008});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, select_972[2]} + ({2'h0, and_1006} + {1'b0, sum_1010});
  // hls/stages/agreement.hpp:516
  logic and_1021;
  assign and_1021 = seen_columns_rdata_q[5] & not_355_s3_q;
  logic and_1022;
  assign and_1022 = seen_columns_rdata_q[2] & not_355_s3_q;
  // hls/stages/agreement.hpp:571
  logic [1:0] sum_1024;
  assign sum_1024 = {1'b0, and_1021} + ({1'b0, near} + {1'b0, and_1022});
  logic [2:0] near_2;
  assign near_2 = {2'h0, select_972[3]} + ({2'h0, select_972[0]} + {1'b0, sum_1024});
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1078;
  assign select_1078 = and_336_s3_q ? total[10:2] : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1079;
  assign select_1079 = and_336_s3_q ? total_2[10:2] : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1081;
  assign select_1081 = and_336_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1082;
  assign select_1082 = and_336_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1083;
  assign select_1083 = and_336_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1084;
  assign select_1084 = and_336_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1085;
  assign select_1085 = and_336_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1086;
  assign select_1086 = and_336_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1087;
  assign select_1087 = and_336_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1088;
  assign select_1088 = and_336_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1089;
  assign select_1089 = and_336_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1090;
  assign select_1090 = and_336_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1091;
  assign select_1091 = and_336_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1092;
  assign select_1092 = and_336_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1093;
  assign select_1093 = and_336_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1094;
  assign select_1094 = and_336_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1095;
  assign select_1095 = and_336_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1096;
  assign select_1096 = and_336_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1097;
  assign select_1097 = and_336_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1098;
  assign select_1098 = and_336_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1099;
  assign select_1099 = and_336_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1100;
  assign select_1100 = and_336_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1101;
  assign select_1101 = and_336_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1102;
  assign select_1102 = and_336_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1103;
  assign select_1103 = and_336_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1104;
  assign select_1104 = and_336_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1105;
  assign select_1105 = and_336_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1106;
  assign select_1106 = and_336_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1107;
  assign select_1107 = and_336_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1108;
  assign select_1108 = and_336_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1109;
  assign select_1109 = and_336_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1110;
  assign select_1110 = and_336_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1111;
  assign select_1111 = and_336_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1112;
  assign select_1112 = and_336_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1113;
  assign select_1113 = and_336_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1114;
  assign select_1114 = and_336_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1115;
  assign select_1115 = and_336_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1116;
  assign select_1116 = and_336_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1117;
  assign select_1117 = and_336_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1118;
  assign select_1118 = and_336_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1119;
  assign select_1119 = and_336_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1120;
  assign select_1120 = and_336_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1121;
  assign select_1121 = and_336_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1122;
  assign select_1122 = and_336_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1123;
  assign select_1123 = and_336_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1124;
  assign select_1124 = and_336_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1125;
  assign select_1125 = and_336_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1126;
  assign select_1126 = and_336_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1127;
  assign select_1127 = and_336_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1128;
  assign select_1128 = and_336_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1129;
  assign select_1129 = and_336_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1130;
  assign select_1130 = and_336_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1131;
  assign select_1131 = and_336_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1132;
  assign select_1132 = and_336_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1133;
  assign select_1133 = and_336_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1135;
  assign difference_1135 = {1'b0, total_2[10:2]} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1136;
  assign xor_1136 = difference_1135[8:0] ^ {9{difference_1135[9]}};
  logic [9:0] sum_1137;
  assign sum_1137 = {9'h0, difference_1135[9]} + {1'b0, xor_1136};
  logic [9:0] difference_1138;
  assign difference_1138 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1139;
  assign xor_1139 = difference_1138[8:0] ^ {9{difference_1138[9]}};
  logic [9:0] sum_1140;
  assign sum_1140 = {9'h0, difference_1138[9]} + {1'b0, xor_1139};
  logic [9:0] difference_1142;
  assign difference_1142 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1143;
  assign xor_1143 = difference_1142[8:0] ^ {9{difference_1142[9]}};
  logic [9:0] sum_1144;
  assign sum_1144 = {9'h0, difference_1142[9]} + {1'b0, xor_1143};
  logic [10:0] sum_1145;
  assign sum_1145 = ({1'b0, sum_1137} + {1'b0, sum_1140}) + {1'b0, sum_1144};
  logic [9:0] difference_1146;
  assign difference_1146 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1147;
  assign xor_1147 = difference_1146[8:0] ^ {9{difference_1146[9]}};
  logic [9:0] sum_1148;
  assign sum_1148 = {9'h0, difference_1146[9]} + {1'b0, xor_1147};
  logic [9:0] difference_1150;
  assign difference_1150 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1151;
  assign xor_1151 = difference_1150[8:0] ^ {9{difference_1150[9]}};
  logic [9:0] sum_1152;
  assign sum_1152 = {9'h0, difference_1150[9]} + {1'b0, xor_1151};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1179;
  assign difference_1179 = {1'b0, total[10:2]} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1179[9]} + (difference_1179[8:0] ^ {9{difference_1179[9]}});
  logic [9:0] difference_1190;
  assign difference_1190 = {1'b0, total_2[10:2]} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1190[9]} + (difference_1190[8:0] ^ {9{difference_1190[9]}});
  // hls/stages/agreement.hpp:176
  logic and_1344;
  assign and_1344 = and_336_s3_q & (equal_385_s3_q & equal_1211_s3_q);
  // hls/stages/agreement.hpp:299
  logic and_1349;
  assign and_1349 = not_352_s3_q & (not_496_s3_q & (drew_s3_q & (not_355_s3_q & and_1345_s3_q)));
  // hls/stages/agreement.hpp:165
  logic [8:0] select_1394;
  assign select_1394 = less_354_s3_q ? 9'h0 : (and_906_s3_q ? {and_917, cfg_explained_limit_i} : 9'h0);
  // hls/stages/agreement.hpp:299
  logic [8:0] select_1397;
  assign select_1397 = equal_351_s3_q ? 9'h0 : (equal_353_s3_q ? 9'h0 : (drew_s3_q ? select_1394 : 9'h0));
  // hls/stages/agreement.hpp:480
  logic [23:0] sum_1398;
  assign sum_1398 = counts_too_little_explained_q + {{15{select_1397[8]}}, select_1397};
  // hls/stages/agreement.hpp:511
  logic [9:0] select_1421;
  assign select_1421 = (left_rdata_s3_q & and_1345_s3_q) ? ({1'b0, and_927, 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:299
  logic [9:0] select_1424;
  assign select_1424 = equal_353_s3_q ? 10'h0 : (drew_s3_q ? (less_354_s3_q ? 10'h0 : select_1421) : 10'h0);
  logic [9:0] select_1425;
  assign select_1425 = equal_351_s3_q ? 10'h0 : select_1424;
  // hls/stages/agreement.hpp:484
  logic [23:0] select_1427;
  assign select_1427 = and_1344 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1425[9]}}, select_1425});
  // hls/stages/agreement.hpp:511
  logic and_1429;
  assign and_1429 = and_917 & less_1428_s3_q;
  // hls/stages/registration.hpp:73
  logic equal_1432;
  assign equal_1432 = {lower_half_s3_q, less_1431_s3_q} == 2'h3;
  logic equal_1433;
  assign equal_1433 = {lower_half_s3_q, less_1431_s3_q} == 2'h2;
  logic equal_1434;
  assign equal_1434 = {lower_half_s3_q, less_1431_s3_q} == 2'h1;
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1465;
  assign sum_1465 = {difference_1464_s3_q, select_1462_s3_q} + {sum_1461_s3_q[9], sum_1461_s3_q[9:1]};
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1466;
  assign difference_1466 = {{4{best_left_rdata_s3_q[21]}}, best_left_rdata_s3_q[21:14]} - {sum_1465[9], sum_1465, sum_1461_s3_q[0]};
  // hls/stages/registration.hpp:158
  logic [11:0] select_1468;
  assign select_1468 = ($signed(difference_1466[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1466;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1468[11:7])) ? 12'h7f : select_1468;
  // hls/stages/registration.hpp:73
  logic not_1508;
  assign not_1508 = ~equal_1432;
  logic not_1509;
  assign not_1509 = ~equal_1433;
  // hls/stages/agreement.hpp:165
  logic and_1514;
  assign and_1514 = not_355_s3_q & (and_1429 & (not_1508 & (not_1509 & (~equal_1434))));
  // hls/stages/agreement.hpp:299
  logic and_1517;
  assign and_1517 = not_352_s3_q & (not_496_s3_q & (drew_s3_q & and_1514));
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1519;
  assign select_1519 = and_1344 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1517});
  // hls/stages/agreement.hpp:299
  logic and_1524;
  assign and_1524 = drew_s3_q & (not_355_s3_q & (and_1429 & (not_1508 & (equal_1434 & not_1509))));
  logic and_1526;
  assign and_1526 = not_352_s3_q & (not_496_s3_q & and_1524);
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1528;
  assign select_1528 = and_1344 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1526});
  // hls/stages/agreement.hpp:299
  logic and_1532;
  assign and_1532 = drew_s3_q & (not_355_s3_q & (and_1429 & (equal_1433 & not_1508)));
  logic and_1534;
  assign and_1534 = not_352_s3_q & (not_496_s3_q & and_1532);
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1536;
  assign select_1536 = and_1344 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1534});
  // hls/stages/agreement.hpp:299
  logic and_1540;
  assign and_1540 = not_496_s3_q & (drew_s3_q & (not_355_s3_q & (and_1429 & equal_1432)));
  logic and_1541;
  assign and_1541 = not_352_s3_q & and_1540;
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1543;
  assign select_1543 = and_1344 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1541});
  // hls/stages/registration.hpp:146
  logic less_1544;
  assign less_1544 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:165
  logic and_1545;
  assign and_1545 = and_1429 & less_1544;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1548;
  assign select_1548 = equal_353_s3_q ? 2'h0 : (drew_s3_q ? (less_354_s3_q ? 2'h0 : {and_1545, and_1429}) : 2'h0);
  logic [1:0] select_1549;
  assign select_1549 = equal_351_s3_q ? 2'h0 : select_1548;
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1550;
  assign sum_1550 = registration_counts_votes_0_down_q + {{13{select_1549[1]}}, select_1549};
  // hls/stages/registration.hpp:146
  logic [12:0] difference_1552;
  assign difference_1552 = 13'h0 - {residual[11], residual};
  logic less_1553;
  assign less_1553 = $signed(difference_1552) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:165
  logic and_1554;
  assign and_1554 = and_1429 & less_1553;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1557;
  assign select_1557 = equal_353_s3_q ? 2'h0 : (drew_s3_q ? (less_354_s3_q ? 2'h0 : {and_1554, and_1429}) : 2'h0);
  logic [1:0] select_1558;
  assign select_1558 = equal_351_s3_q ? 2'h0 : select_1557;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1559;
  assign sum_1559 = registration_counts_votes_0_up_q + {{13{select_1558[1]}}, select_1558};
  // hls/stages/registration.hpp:80
  logic not_1561;
  assign not_1561 = ~less_1431_s3_q;
  // hls/stages/registration.hpp:79
  logic and_1562;
  assign and_1562 = less_1544 & not_1561;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1565;
  assign select_1565 = drew_s3_q ? (less_354_s3_q ? 2'h0 : (and_1429 ? {and_1562, not_1561} : 2'h0)) : 2'h0;
  logic [1:0] select_1567;
  assign select_1567 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : select_1565);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1568;
  assign sum_1568 = registration_counts_votes_1_down_q + {{13{select_1567[1]}}, select_1567};
  // hls/stages/registration.hpp:79
  logic and_1570;
  assign and_1570 = less_1553 & not_1561;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1573;
  assign select_1573 = drew_s3_q ? (less_354_s3_q ? 2'h0 : (and_1429 ? {and_1570, not_1561} : 2'h0)) : 2'h0;
  logic [1:0] select_1575;
  assign select_1575 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : select_1573);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1576;
  assign sum_1576 = registration_counts_votes_1_up_q + {{13{select_1575[1]}}, select_1575};
  // hls/stages/registration.hpp:79
  logic and_1578;
  assign and_1578 = less_1431_s3_q & less_1544;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1580;
  assign select_1580 = less_354_s3_q ? 2'h0 : (and_1429 ? {and_1578, less_1431_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1583;
  assign select_1583 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : (drew_s3_q ? select_1580 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1584;
  assign sum_1584 = registration_counts_votes_2_down_q + {{13{select_1583[1]}}, select_1583};
  // hls/stages/registration.hpp:79
  logic and_1586;
  assign and_1586 = less_1431_s3_q & less_1553;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1588;
  assign select_1588 = less_354_s3_q ? 2'h0 : (and_1429 ? {and_1586, less_1431_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1591;
  assign select_1591 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : (drew_s3_q ? select_1588 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1592;
  assign sum_1592 = registration_counts_votes_2_up_q + {{13{select_1591[1]}}, select_1591};
  // hls/stages/registration.hpp:80
  logic not_1594;
  assign not_1594 = ~lower_half_s3_q;
  // hls/stages/agreement.hpp:165
  logic and_1595;
  assign and_1595 = less_1544 & not_1594;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1598;
  assign select_1598 = drew_s3_q ? (less_354_s3_q ? 2'h0 : (and_1429 ? {and_1595, not_1594} : 2'h0)) : 2'h0;
  logic [1:0] select_1600;
  assign select_1600 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : select_1598);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1601;
  assign sum_1601 = registration_counts_votes_3_down_q + {{13{select_1600[1]}}, select_1600};
  // hls/stages/agreement.hpp:165
  logic and_1603;
  assign and_1603 = less_1553 & not_1594;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1606;
  assign select_1606 = drew_s3_q ? (less_354_s3_q ? 2'h0 : (and_1429 ? {and_1603, not_1594} : 2'h0)) : 2'h0;
  logic [1:0] select_1608;
  assign select_1608 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : select_1606);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1609;
  assign sum_1609 = registration_counts_votes_3_up_q + {{13{select_1608[1]}}, select_1608};
  // hls/stages/agreement.hpp:165
  logic and_1611;
  assign and_1611 = lower_half_s3_q & less_1544;
  logic [1:0] select_1613;
  assign select_1613 = less_354_s3_q ? 2'h0 : (and_1429 ? {and_1611, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1616;
  assign select_1616 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : (drew_s3_q ? select_1613 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1617;
  assign sum_1617 = registration_counts_votes_4_down_q + {{13{select_1616[1]}}, select_1616};
  // hls/stages/agreement.hpp:165
  logic and_1619;
  assign and_1619 = lower_half_s3_q & less_1553;
  logic [1:0] select_1621;
  assign select_1621 = less_354_s3_q ? 2'h0 : (and_1429 ? {and_1619, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1624;
  assign select_1624 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : (drew_s3_q ? select_1621 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1625;
  assign sum_1625 = registration_counts_votes_4_up_q + {{13{select_1624[1]}}, select_1624};
  // hls/stages/registration.hpp:146
  logic less_1627;
  assign less_1627 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1628;
  assign and_1628 = not_1561 & less_1627;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1631;
  assign select_1631 = drew_s3_q ? (less_354_s3_q ? 2'h0 : (and_1429 ? {and_1628, not_1561} : 2'h0)) : 2'h0;
  logic [1:0] select_1633;
  assign select_1633 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : select_1631);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1634;
  assign sum_1634 = registration_counts_half_votes_0_down_q + {{13{select_1633[1]}}, select_1633};
  // hls/stages/registration.hpp:146
  logic less_1636;
  assign less_1636 = $signed(difference_1552) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1637;
  assign and_1637 = not_1561 & less_1636;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1640;
  assign select_1640 = drew_s3_q ? (less_354_s3_q ? 2'h0 : (and_1429 ? {and_1637, not_1561} : 2'h0)) : 2'h0;
  logic [1:0] select_1642;
  assign select_1642 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : select_1640);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1643;
  assign sum_1643 = registration_counts_half_votes_0_up_q + {{13{select_1642[1]}}, select_1642};
  // hls/stages/registration.hpp:79
  logic and_1645;
  assign and_1645 = less_1431_s3_q & less_1627;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1647;
  assign select_1647 = less_354_s3_q ? 2'h0 : (and_1429 ? {and_1645, less_1431_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1650;
  assign select_1650 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : (drew_s3_q ? select_1647 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1651;
  assign sum_1651 = registration_counts_half_votes_1_down_q + {{13{select_1650[1]}}, select_1650};
  // hls/stages/registration.hpp:79
  logic and_1653;
  assign and_1653 = less_1431_s3_q & less_1636;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1655;
  assign select_1655 = less_354_s3_q ? 2'h0 : (and_1429 ? {and_1653, less_1431_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1658;
  assign select_1658 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : (drew_s3_q ? select_1655 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1659;
  assign sum_1659 = registration_counts_half_votes_1_up_q + {{13{select_1658[1]}}, select_1658};
  // hls/stages/agreement.hpp:165
  logic and_1661;
  assign and_1661 = less_1627 & not_1594;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1664;
  assign select_1664 = drew_s3_q ? (less_354_s3_q ? 2'h0 : (and_1429 ? {and_1661, not_1594} : 2'h0)) : 2'h0;
  logic [1:0] select_1666;
  assign select_1666 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : select_1664);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1667;
  assign sum_1667 = registration_counts_half_votes_2_down_q + {{13{select_1666[1]}}, select_1666};
  // hls/stages/agreement.hpp:165
  logic and_1669;
  assign and_1669 = less_1636 & not_1594;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1672;
  assign select_1672 = drew_s3_q ? (less_354_s3_q ? 2'h0 : (and_1429 ? {and_1669, not_1594} : 2'h0)) : 2'h0;
  logic [1:0] select_1674;
  assign select_1674 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : select_1672);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1675;
  assign sum_1675 = registration_counts_half_votes_2_up_q + {{13{select_1674[1]}}, select_1674};
  // hls/stages/agreement.hpp:165
  logic and_1677;
  assign and_1677 = lower_half_s3_q & less_1627;
  logic [1:0] select_1679;
  assign select_1679 = less_354_s3_q ? 2'h0 : (and_1429 ? {and_1677, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1682;
  assign select_1682 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : (drew_s3_q ? select_1679 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1683;
  assign sum_1683 = registration_counts_half_votes_3_down_q + {{13{select_1682[1]}}, select_1682};
  // hls/stages/agreement.hpp:165
  logic and_1685;
  assign and_1685 = lower_half_s3_q & less_1636;
  logic [1:0] select_1687;
  assign select_1687 = less_354_s3_q ? 2'h0 : (and_1429 ? {and_1685, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1690;
  assign select_1690 = equal_351_s3_q ? 2'h0 : (equal_353_s3_q ? 2'h0 : (drew_s3_q ? select_1687 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1691;
  assign sum_1691 = registration_counts_half_votes_3_up_q + {{13{select_1690[1]}}, select_1690};
  // hls/stages/division.hpp:34
  logic [7:0] sum_1705;
  assign sum_1705 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:246
  logic [2:0] select_1707;
  assign select_1707 = less_1704_s3_q ? (sum_1705[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1709;
  assign select_1709 = equal_1211_s3_q ? (equal_385_s3_q ? 3'h0 : select_1707) : region_row_q;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1713;
  assign select_1713 = equal_351_s3_q ? select_879 : (equal_353_s3_q ? select_879 : (drew_s3_q ? select_987 : 8'h1));
  // hls/stages/division.hpp:35
  logic [8:0] sum_1714;
  assign sum_1714 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1715;
  assign select_1715 = sum_890[5] ? {1'b1, sum_890[4:0], region_across_rest_q[2:0]} : sum_1714;
  // hls/stages/agreement.hpp:246
  logic [8:0] select_1719;
  assign select_1719 = equal_1211_s3_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_1722;
  assign select_1722 = equal_1211_s3_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  logic [8:0] select_1726;
  assign select_1726 = equal_385_s3_q ? {{2{difference_1724[6]}}, difference_1724} : (less_1704_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1728;
  assign select_1728 = and_336_s3_q ? (equal_1211_s3_q ? select_1726 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:246
  logic [6:0] select_1730;
  assign select_1730 = equal_385_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1732;
  assign select_1732 = and_336_s3_q ? (equal_1211_s3_q ? select_1730 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1733;
  assign sum_1733 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1734;
  assign select_1734 = sum_1705[7] ? {1'b1, sum_1705[6:0], region_down_rest_q[0]} : sum_1733;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1705[7];
  // hls/stages/agreement.hpp:246
  logic select_1738;
  assign select_1738 = equal_1211_s3_q ? (equal_385_s3_q | (less_1704_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:140
  logic or_1743;
  assign or_1743 = segment_starts_q | not_1257_s3_q;
  // hls/stages/agreement.hpp:516
  logic select_1746;
  assign select_1746 = less_354_s3_q ? or_1743 : (sum_890[5] ? (equal_892_s3_q & or_893) : or_893);
  // hls/stages/agreement.hpp:299
  logic select_1749;
  assign select_1749 = equal_351_s3_q ? or_1743 : (equal_353_s3_q ? or_1743 : (drew_s3_q ? select_1746 : or_1743));
  // hls/stages/agreement.hpp:619
  logic equal_1751;
  assign equal_1751 = x_s3_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:621
  logic [7:0] select_1775;
  assign select_1775 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1777;
  assign select_1777 = equal_895_s3_q ? (equal_1751 ? select_1775 : hidden_for_q) : hidden_for_q;
  logic [7:0] select_1779;
  assign select_1779 = equal_353_s3_q ? hidden_for_q : (drew_s3_q ? hidden_for_q : select_1777);
  // hls/stages/agreement.hpp:142
  logic not_1781;
  assign not_1781 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:299
  logic select_1856;
  assign select_1856 = equal_353_s3_q ? centres_values_0_q : (drew_s3_q ? and_974 : centres_values_0_q);
  logic select_1859;
  assign select_1859 = equal_353_s3_q ? centres_values_1_q : (drew_s3_q ? centres_values_0_q : centres_values_1_q);
  // hls/stages/agreement.hpp:246
  logic [12:0] select_1864;
  assign select_1864 = equal_1211_s3_q ? (equal_1861_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1867;
  assign select_1867 = and_336_s3_q ? (equal_1211_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:299
  logic and_1878;
  assign and_1878 = not_352_s3_q & (not_496_s3_q & (not_1257_s3_q & (equal_895_s3_q & equal_1751)));
  // hls/stages/agreement.hpp:727
  logic and_1893;
  assign and_1893 = and_1043_s3_q & ({sum_971, index_2[5:0]} == {sum_958, index[5:0]});
  // hls/stages/agreement.hpp:299
  logic and_1939;
  assign and_1939 = not_1257_s3_q & (equal_895_s3_q & (equal_1751 & (cfg_prove_i & (~proven_q))));
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_1963;
  assign sum_1963 = {1'b0, upper} + {1'b0, lower};
  logic less_1964;
  assign less_1964 = 11'h4 < sum_1963[13:3];
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};
  // hls/stages/registration.hpp:100
  logic less_1967;
  assign less_1967 = 11'he < left[12:2];
  // hls/stages/registration.hpp:119
  logic less_1969;
  assign less_1969 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_1970;
  assign or_1970 = (~less_1967) | less_1969;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:100
  logic less_1972;
  assign less_1972 = 11'he < right[12:2];
  // hls/stages/registration.hpp:119
  logic less_1974;
  assign less_1974 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic select_1976;
  assign select_1976 = less_1964 ? (or_1970 ? less_1969 : less_1974) : less_1974;
  logic or_1977;
  assign or_1977 = (~less_1972) | select_1976;
  // hls/stages/registration.hpp:100
  logic less_1978;
  assign less_1978 = 11'he < upper[12:2];
  // hls/stages/registration.hpp:119
  logic less_1980;
  assign less_1980 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/registration.hpp:104
  logic select_1981;
  assign select_1981 = or_1977 ? select_1976 : less_1980;
  logic select_1983;
  assign select_1983 = less_1964 ? select_1981 : (less_1967 ? select_1981 : less_1980);
  logic or_1984;
  assign or_1984 = (~less_1978) | select_1983;
  // hls/stages/registration.hpp:119
  logic less_1985;
  assign less_1985 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_1986;
  assign select_1986 = or_1984 ? select_1983 : less_1985;
  logic select_1989;
  assign select_1989 = less_1964 ? select_1986 : (less_1967 ? select_1986 : (less_1972 ? select_1986 : less_1985));
  // hls/stages/registration.hpp:101
  logic less_1990;
  assign less_1990 = 11'he < lower[12:2];
  // hls/stages/registration.hpp:104
  logic or_1992;
  assign or_1992 = select_1989 | (~less_1990);
  // hls/stages/registration.hpp:119
  logic less_1993;
  assign less_1993 = $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
  // hls/stages/registration.hpp:105
  logic select_1994;
  assign select_1994 = or_1992 ? select_1989 : less_1993;
  logic select_1997;
  assign select_1997 = less_1967 ? select_1994 : (less_1972 ? select_1994 : (less_1978 ? select_1994 : less_1993));
  // hls/stages/agreement.hpp:623
  logic and_2009;
  assign and_2009 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2010;
  assign or_2010 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2009;
  logic select_2011;
  assign select_2011 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2010 : and_2009;
  logic and_2012;
  assign and_2012 = (less_1978 & less_1990) & select_2011;
  logic or_2013;
  assign or_2013 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2012;
  logic select_2014;
  assign select_2014 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2013 : and_2012;
  logic or_2015;
  assign or_2015 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2014;
  logic select_2016;
  assign select_2016 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2015 : select_2014;
  logic select_2017;
  assign select_2017 = (less_1967 & less_1972) ? select_2016 : and_2012;
  logic or_2018;
  assign or_2018 = (less_1964 ? select_1994 : select_1997) | select_2017;
  // hls/stages/registration.hpp:119
  logic less_2019;
  assign less_2019 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  // hls/stages/agreement.hpp:623
  logic or_2020;
  assign or_2020 = less_2019 | or_2018;
  logic select_2021;
  assign select_2021 = or_1992 ? or_2018 : or_2020;
  // hls/stages/registration.hpp:119
  logic less_2022;
  assign less_2022 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2025;
  assign less_2025 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2028;
  assign less_2028 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:623
  logic and_2070;
  assign and_2070 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1775 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:299
  logic and_2074;
  assign and_2074 = not_1257_s3_q & (equal_895_s3_q & (equal_1751 & (cfg_prove_i & and_2070)));
  logic [11:0] select_2098;
  assign select_2098 = equal_895_s3_q ? (equal_1751 ? registration_counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2101;
  assign select_2101 = equal_351_s3_q ? 12'h0 : (equal_353_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2098));
  logic [11:0] select_2103;
  assign select_2103 = equal_895_s3_q ? (equal_1751 ? registration_counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2106;
  assign select_2106 = equal_351_s3_q ? 12'h0 : (equal_353_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2103));
  logic [11:0] select_2108;
  assign select_2108 = equal_895_s3_q ? (equal_1751 ? registration_counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2111;
  assign select_2111 = equal_351_s3_q ? 12'h0 : (equal_353_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2108));
  logic [11:0] select_2113;
  assign select_2113 = equal_895_s3_q ? (equal_1751 ? registration_counts_measured_3_q : 12'h0) : 12'h0;
  logic [11:0] select_2116;
  assign select_2116 = equal_351_s3_q ? 12'h0 : (equal_353_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2113));

  // Memory regions, 64 x 36, DISTANCE 12, hls/stages/agreement.hpp:782; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = drew_s3_q ? {region_row_q, or_888, or_885, or_882} : x_s3_q[5:0];
  logic regions_re;
  assign regions_re = s3_en & (not_352_s3_q & (not_496_s3_q & (drew_s3_q ? and_894 : and_898)));
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 9600 x 2, DISTANCE 16, hls/stages/agreement.hpp:801; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_958, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_965 & less_966);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_306_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_313_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_332, and_328, sum_324, sum_320};
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

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = select_302_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_336_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], select_350, whole_2, total_2[10:2], total[10:2]};
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
  assign best_right_we = s3_en & and_863_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_878, select_874};
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
  assign seen_columns_we = s3_en & and_937_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[8:0], near, explained, textured};
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
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
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
      centres_values_0_q <= 1'b0;
      centres_values_1_q <= 1'b0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      proven_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s3_en) begin
      averager_mask_q <= and_335_s3_q ? whole_2 : averager_mask_q;
      averager_of_skin_q <= and_335_s3_q ? select_350 : averager_of_skin_q;
      census_filled_q <= and_336_s3_q ? {select_388[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_336_s3_q ? select_387 : rows_passed_above_q;
      counts_too_little_explained_q <= and_1344 ? 24'h0 : sum_1398;
      counts_too_much_hidden_q <= select_1427;
      registration_counts_measured_0_q <= select_1519;
      registration_counts_measured_1_q <= select_1528;
      registration_counts_measured_2_q <= select_1536;
      registration_counts_measured_3_q <= select_1543;
      registration_counts_votes_0_down_q <= and_1344 ? 15'h0 : sum_1550;
      registration_counts_votes_0_up_q <= and_1344 ? 15'h0 : sum_1559;
      registration_counts_votes_1_down_q <= and_1344 ? 15'h0 : sum_1568;
      registration_counts_votes_1_up_q <= and_1344 ? 15'h0 : sum_1576;
      registration_counts_votes_2_down_q <= and_1344 ? 15'h0 : sum_1584;
      registration_counts_votes_2_up_q <= and_1344 ? 15'h0 : sum_1592;
      registration_counts_votes_3_down_q <= and_1344 ? 15'h0 : sum_1601;
      registration_counts_votes_3_up_q <= and_1344 ? 15'h0 : sum_1609;
      registration_counts_votes_4_down_q <= and_1344 ? 15'h0 : sum_1617;
      registration_counts_votes_4_up_q <= and_1344 ? 15'h0 : sum_1625;
      registration_counts_half_votes_0_down_q <= and_1344 ? 15'h0 : sum_1634;
      registration_counts_half_votes_0_up_q <= and_1344 ? 15'h0 : sum_1643;
      registration_counts_half_votes_1_down_q <= and_1344 ? 15'h0 : sum_1651;
      registration_counts_half_votes_1_up_q <= and_1344 ? 15'h0 : sum_1659;
      registration_counts_half_votes_2_down_q <= and_1344 ? 15'h0 : sum_1667;
      registration_counts_half_votes_2_up_q <= and_1344 ? 15'h0 : sum_1675;
      registration_counts_half_votes_3_down_q <= and_1344 ? 15'h0 : sum_1683;
      registration_counts_half_votes_3_up_q <= and_1344 ? 15'h0 : sum_1691;
      region_row_q <= and_336_s3_q ? select_1709 : region_row_q;
      region_columns_q <= select_1713;
      region_across_rest_q <= drew_s3_q ? select_1715 : columns_begin_rest_q;
      region_across_back_q <= drew_s3_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_336_s3_q ? select_1719 : columns_begin_rest_q;
      columns_begin_back_q <= and_336_s3_q ? select_1722 : columns_begin_back_q;
      region_down_rest_q <= select_1728;
      region_down_back_q <= select_1732;
      region_down_next_q <= select_1734;
      region_fresh_q <= and_336_s3_q ? select_1738 : region_fresh_q;
      segment_starts_q <= select_1749;
      hidden_for_q <= equal_351_s3_q ? hidden_for_q : select_1779;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1781};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s3_q;
      centres_values_0_q <= equal_351_s3_q ? centres_values_0_q : select_1856;
      centres_values_1_q <= equal_351_s3_q ? centres_values_1_q : select_1859;
      map_row_q <= and_336_s3_q ? select_1864 : map_row_q;
      map_width_q <= select_1867;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_957;
      done_q <= not_959_s3_q & ((~begins_product_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      said_q <= and_1878;
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
      averager_total_0_q <= and_335_s3_q ? total : averager_total_0_q;
      averager_total_1_q <= and_335_s3_q ? total_2 : averager_total_1_q;
      census_columns_values_0_cell_0_left_q <= select_1078;
      census_columns_values_0_cell_0_right_q <= select_1079;
      census_columns_values_0_cell_0_mask_q <= and_336_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_1081;
      census_columns_values_0_cell_1_right_q <= select_1082;
      census_columns_values_0_cell_1_mask_q <= select_1083;
      census_columns_values_0_cell_2_left_q <= select_1084;
      census_columns_values_0_cell_2_right_q <= select_1085;
      census_columns_values_0_cell_2_mask_q <= select_1086;
      census_columns_values_0_cell_2_of_skin_q <= select_1087;
      census_columns_values_0_cell_3_left_q <= select_1088;
      census_columns_values_0_cell_3_right_q <= select_1089;
      census_columns_values_0_cell_3_mask_q <= select_1090;
      census_columns_values_0_cell_4_left_q <= select_1091;
      census_columns_values_0_cell_4_right_q <= select_1092;
      census_columns_values_0_cell_4_mask_q <= select_1093;
      census_columns_values_1_cell_0_left_q <= select_1094;
      census_columns_values_1_cell_0_right_q <= select_1095;
      census_columns_values_1_cell_0_mask_q <= select_1096;
      census_columns_values_1_cell_1_left_q <= select_1097;
      census_columns_values_1_cell_1_right_q <= select_1098;
      census_columns_values_1_cell_1_mask_q <= select_1099;
      census_columns_values_1_cell_2_left_q <= select_1100;
      census_columns_values_1_cell_2_right_q <= select_1101;
      census_columns_values_1_cell_2_mask_q <= select_1102;
      census_columns_values_1_cell_2_of_skin_q <= select_1103;
      census_columns_values_1_cell_3_left_q <= select_1104;
      census_columns_values_1_cell_3_right_q <= select_1105;
      census_columns_values_1_cell_3_mask_q <= select_1106;
      census_columns_values_1_cell_4_left_q <= select_1107;
      census_columns_values_1_cell_4_right_q <= select_1108;
      census_columns_values_1_cell_4_mask_q <= select_1109;
      census_columns_values_2_cell_0_left_q <= select_1110;
      census_columns_values_2_cell_0_right_q <= select_1111;
      census_columns_values_2_cell_0_mask_q <= select_1112;
      census_columns_values_2_cell_1_left_q <= select_1113;
      census_columns_values_2_cell_1_right_q <= select_1114;
      census_columns_values_2_cell_1_mask_q <= select_1115;
      census_columns_values_2_cell_2_left_q <= select_1116;
      census_columns_values_2_cell_2_right_q <= select_1117;
      census_columns_values_2_cell_2_mask_q <= select_1118;
      census_columns_values_2_cell_3_left_q <= select_1119;
      census_columns_values_2_cell_3_right_q <= select_1120;
      census_columns_values_2_cell_3_mask_q <= select_1121;
      census_columns_values_2_cell_4_left_q <= select_1122;
      census_columns_values_2_cell_4_right_q <= select_1123;
      census_columns_values_2_cell_4_mask_q <= select_1124;
      census_columns_values_3_cell_0_mask_q <= select_1125;
      census_columns_values_3_cell_1_left_q <= select_1126;
      census_columns_values_3_cell_1_right_q <= select_1127;
      census_columns_values_3_cell_1_mask_q <= select_1128;
      census_columns_values_3_cell_2_mask_q <= select_1129;
      census_columns_values_3_cell_3_left_q <= select_1130;
      census_columns_values_3_cell_3_right_q <= select_1131;
      census_columns_values_3_cell_3_mask_q <= select_1132;
      census_columns_values_3_cell_4_mask_q <= select_1133;
      sharpness_last_mean_0_q <= and_336_s3_q ? total[10:2] : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_336_s3_q ? total_2[10:2] : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [5:0] x_s4_q;
  logic age_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic begins_product_s4_q;
  logic [6:0] select_302_s4_q;
  logic and_335_s4_q;
  logic and_336_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_339_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic equal_351_s4_q;
  logic not_352_s4_q;
  logic equal_353_s4_q;
  logic less_354_s4_q;
  logic not_355_s4_q;
  logic less_359_s4_q;
  logic less_360_s4_q;
  logic less_361_s4_q;
  logic less_362_s4_q;
  logic less_363_s4_q;
  logic less_364_s4_q;
  logic less_365_s4_q;
  logic less_366_s4_q;
  logic less_367_s4_q;
  logic less_368_s4_q;
  logic less_369_s4_q;
  logic less_370_s4_q;
  logic less_371_s4_q;
  logic less_372_s4_q;
  logic less_373_s4_q;
  logic less_374_s4_q;
  logic less_375_s4_q;
  logic less_376_s4_q;
  logic less_377_s4_q;
  logic less_378_s4_q;
  logic less_379_s4_q;
  logic less_380_s4_q;
  logic less_381_s4_q;
  logic less_382_s4_q;
  logic and_389_s4_q;
  logic and_414_s4_q;
  logic and_415_s4_q;
  logic [11:0] texture_s4_q;
  logic [6:0] x_s4_2_q;
  logic not_496_s4_q;
  logic [7:0] best_left_rdata_s4_q;
  logic equal_501_s4_q;
  logic select_797_s4_q;
  logic less_803_s4_q;
  logic less_804_s4_q;
  logic or_806_s4_q;
  logic [7:0] select_810_s4_q;
  logic [5:0] select_814_s4_q;
  logic equal_819_s4_q;
  logic rise_s4_q;
  logic [1:0] sum_831_s4_q;
  logic [7:0] twice_s4_q;
  logic [8:0] difference_843_s4_q;
  logic and_863_s4_q;
  logic or_882_s4_q;
  logic or_885_s4_q;
  logic or_888_s4_q;
  logic equal_895_s4_q;
  logic equal_896_s4_q;
  logic and_906_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_929_s4_q;
  logic and_936_s4_q;
  logic and_965_s4_q;
  logic less_966_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_971_s4_q;
  logic [2:0] textured_2_s4_q;
  logic equal_982_s4_q;
  logic or_990_s4_q;
  logic or_993_s4_q;
  logic or_996_s4_q;
  logic [2:0] explained_2_s4_q;
  logic [2:0] near_2_s4_q;
  logic and_1043_s4_q;
  logic [11:0] sum_1153_s4_q;
  logic equal_1160_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic not_1257_s4_q;
  logic and_1344_s4_q;
  logic and_1349_s4_q;
  logic or_1369_s4_q;
  logic and_1429_s4_q;
  logic equal_1432_s4_q;
  logic equal_1433_s4_q;
  logic equal_1434_s4_q;
  logic [7:0] residual_s4_q;
  logic equal_1751_s4_q;
  logic less_1757_s4_q;
  logic and_1893_s4_q;
  logic and_1941_s4_q;
  logic less_1964_s4_q;
  logic less_1965_s4_q;
  logic less_1967_s4_q;
  logic or_1970_s4_q;
  logic less_1972_s4_q;
  logic or_1977_s4_q;
  logic less_1978_s4_q;
  logic or_1984_s4_q;
  logic select_2021_s4_q;
  logic or_2023_s4_q;
  logic less_2025_s4_q;
  logic less_2028_s4_q;
  logic select_2032_s4_q;
  logic and_2076_s4_q;
  logic [11:0] select_2101_s4_q;
  logic [11:0] select_2106_s4_q;
  logic [11:0] select_2111_s4_q;
  logic [11:0] select_2116_s4_q;
  logic and_2139_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s4_q <= x_s3_q[5:0];
      age_s4_q <= age_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      begins_product_s4_q <= begins_product_q;
      select_302_s4_q <= select_302_s3_q;
      and_335_s4_q <= and_335_s3_q;
      and_336_s4_q <= and_336_s3_q;
      grey_s4_q <= grey;
      equal_339_s4_q <= equal_339_s3_q;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      equal_351_s4_q <= equal_351_s3_q;
      not_352_s4_q <= not_352_s3_q;
      equal_353_s4_q <= equal_353_s3_q;
      less_354_s4_q <= less_354_s3_q;
      not_355_s4_q <= not_355_s3_q;
      less_359_s4_q <= less_359;
      less_360_s4_q <= less_360;
      less_361_s4_q <= less_361;
      less_362_s4_q <= less_362;
      less_363_s4_q <= less_363;
      less_364_s4_q <= less_364;
      less_365_s4_q <= less_365;
      less_366_s4_q <= less_366;
      less_367_s4_q <= less_367;
      less_368_s4_q <= less_368;
      less_369_s4_q <= less_369;
      less_370_s4_q <= less_370;
      less_371_s4_q <= less_371;
      less_372_s4_q <= less_372;
      less_373_s4_q <= less_373;
      less_374_s4_q <= less_374;
      less_375_s4_q <= less_375;
      less_376_s4_q <= less_376;
      less_377_s4_q <= less_377;
      less_378_s4_q <= less_378;
      less_379_s4_q <= less_379;
      less_380_s4_q <= less_380;
      less_381_s4_q <= less_381;
      less_382_s4_q <= less_382;
      and_389_s4_q <= and_389;
      and_414_s4_q <= whole_22 & and_389;
      and_415_s4_q <= census_columns_values_1_cell_2_mask_q & and_389;
      texture_s4_q <= texture;
      x_s4_2_q <= x_s3_2_q;
      not_496_s4_q <= not_496_s3_q;
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      equal_501_s4_q <= equal_501_s3_q;
      select_797_s4_q <= select_797[0];
      less_803_s4_q <= less_803;
      less_804_s4_q <= less_804;
      or_806_s4_q <= or_806;
      select_810_s4_q <= equal_501_s3_q ? of_best_2 : select_809;
      select_814_s4_q <= equal_501_s3_q ? run_shift_s3_q : select_813;
      equal_819_s4_q <= {less_796, select_797} == near_best;
      rise_s4_q <= rise[8];
      sum_831_s4_q <= {less_796, select_797[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_843_s4_q <= {1'b0, twice} - (({twice, 1'b0} < size) ? {twice, 1'b0} : size);
      and_863_s4_q <= and_863_s3_q;
      or_882_s4_q <= or_882;
      or_885_s4_q <= or_885;
      or_888_s4_q <= or_888;
      equal_895_s4_q <= equal_895_s3_q;
      equal_896_s4_q <= equal_896;
      and_906_s4_q <= and_906_s3_q;
      textured_s4_q <= textured;
      explained_s4_q <= explained;
      and_929_s4_q <= not_355_s3_q & (left_rdata_s3_q & and_927);
      and_936_s4_q <= not_352_s3_q & (not_496_s3_q & (drew_s3_q & and_894));
      and_965_s4_q <= and_965;
      less_966_s4_q <= less_966;
      index_2_s4_q <= index_2[5:0];
      sum_971_s4_q <= sum_971;
      textured_2_s4_q <= textured_2;
      equal_982_s4_q <= x_s3_q == 8'h0;
      or_990_s4_q <= or_990;
      or_993_s4_q <= select_987[7] | (~({select_987[6], select_987[3:2]} == 3'h0));
      or_996_s4_q <= select_987[7] | (~(select_987[6:4] == 3'h0));
      explained_2_s4_q <= explained_2;
      near_2_s4_q <= near_2;
      and_1043_s4_q <= and_1043_s3_q;
      sum_1153_s4_q <= ({1'b0, sum_1145} + {2'h0, sum_1148}) + {2'h0, sum_1152};
      equal_1160_s4_q <= equal_1160_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      not_1257_s4_q <= not_1257_s3_q;
      and_1344_s4_q <= and_1344;
      and_1349_s4_q <= and_1349;
      or_1369_s4_q <= (x_s3_q[7:1] == 7'h0) | (~centres_values_1_q);
      and_1429_s4_q <= and_1429;
      equal_1432_s4_q <= equal_1432;
      equal_1433_s4_q <= equal_1433;
      equal_1434_s4_q <= equal_1434;
      residual_s4_q <= residual[7:0];
      equal_1751_s4_q <= equal_1751;
      less_1757_s4_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      and_1893_s4_q <= and_1893;
      and_1941_s4_q <= not_352_s3_q & (not_496_s3_q & and_1939);
      less_1964_s4_q <= less_1964;
      less_1965_s4_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_1967_s4_q <= less_1967;
      or_1970_s4_q <= or_1970;
      less_1972_s4_q <= less_1972;
      or_1977_s4_q <= or_1977;
      less_1978_s4_q <= less_1978;
      or_1984_s4_q <= or_1984;
      select_2021_s4_q <= select_2021;
      or_2023_s4_q <= less_2022 | select_2021;
      less_2025_s4_q <= less_2025;
      less_2028_s4_q <= less_2028;
      select_2032_s4_q <= less_1990 ? or_2020 : select_2017;
      and_2076_s4_q <= not_352_s3_q & (not_496_s3_q & and_2074);
      select_2101_s4_q <= select_2101;
      select_2106_s4_q <= select_2106;
      select_2111_s4_q <= select_2111;
      select_2116_s4_q <= select_2116;
      and_2139_s4_q <= not_352_s3_q & (not_496_s3_q & (not_1257_s3_q & and_898));
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
  logic [12:0] sum_435;
  assign sum_435 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_437;
  assign sum_437 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_435});
  // hls/stages/census.hpp:223
  logic less_438;
  assign less_438 = 9'h4 < sum_437[13:5];
  logic and_439;
  assign and_439 = and_389_s4_q & less_438;
  // hls/stages/registration.hpp:28
  logic not_844;
  assign not_844 = ~difference_843_s4_q[8];
  logic [7:0] xor_845;
  assign xor_845 = twice_s4_q ^ {8{not_844}};
  logic [9:0] sum_846;
  assign sum_846 = {difference_843_s4_q[7:0], 1'b0, not_844} + {not_844, xor_845, not_844};
  logic not_847;
  assign not_847 = ~sum_846[9];
  logic [7:0] xor_848;
  assign xor_848 = twice_s4_q ^ {8{not_847}};
  logic [9:0] sum_849;
  assign sum_849 = {sum_846[8:0], not_847} + {not_847, xor_848, not_847};
  logic not_850;
  assign not_850 = ~sum_849[9];
  logic [7:0] xor_851;
  assign xor_851 = twice_s4_q ^ {8{not_850}};
  logic [9:0] sum_852;
  assign sum_852 = {sum_849[8:0], not_850} + {not_850, xor_851, not_850};
  logic not_853;
  assign not_853 = ~sum_852[9];
  logic [7:0] xor_854;
  assign xor_854 = twice_s4_q ^ {8{not_853}};
  logic [9:0] sum_855;
  assign sum_855 = {sum_852[8:0], not_853} + {not_853, xor_854, not_853};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_856;
  assign difference_856 = {sum_831_s4_q, select_797_s4_q, 5'h0} - {3'h0, difference_843_s4_q[8], sum_846[9], sum_849[9], sum_852[9], sum_855[9]};
  // hls/stages/agreement.hpp:428
  logic [7:0] select_857;
  assign select_857 = rise_s4_q ? difference_856 : {sum_831_s4_q, select_797_s4_q, difference_843_s4_q[8], sum_846[9], sum_849[9], sum_852[9], sum_855[9]};
  logic [7:0] select_858;
  assign select_858 = equal_819_s4_q ? select_857 : {sum_831_s4_q, select_797_s4_q, 5'h0};
  // hls/stages/agreement.hpp:430
  logic [7:0] select_861;
  assign select_861 = less_803_s4_q ? (or_806_s4_q ? select_858 : best_left_rdata_s4_q) : (less_804_s4_q ? select_858 : best_left_rdata_s4_q);
  logic [7:0] select_862;
  assign select_862 = equal_501_s4_q ? select_858 : select_861;
  // hls/stages/agreement.hpp:464
  logic [6:0] select_908;
  assign select_908 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_909;
  assign sum_909 = {6'h0, textured_s4_q} + select_908;
  // hls/stages/agreement.hpp:549
  logic [11:0] sum_911;
  assign sum_911 = {5'h0, sum_909} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:464
  logic [6:0] select_919;
  assign select_919 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:465
  logic [6:0] sum_920;
  assign sum_920 = {6'h0, explained_s4_q} + select_919;
  // hls/stages/agreement.hpp:550
  logic [11:0] sum_922;
  assign sum_922 = {5'h0, sum_920} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:464
  logic [6:0] select_930;
  assign select_930 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:466
  logic [6:0] sum_931;
  assign sum_931 = {6'h0, and_929_s4_q} + select_930;
  // hls/stages/agreement.hpp:551
  logic [11:0] sum_933;
  assign sum_933 = {5'h0, sum_931} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:575
  logic [4:0] difference_981;
  assign difference_981 = {2'h0, textured_2_s4_q} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  logic [4:0] t;
  assign t = difference_981 + (equal_982_s4_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:581
  logic not_997;
  assign not_997 = ~region_row_s4_q[2];
  logic [2:0] select_998;
  assign select_998 = region_row_s4_q[1] ? {1'b0, not_997, 1'b0} : {region_row_s4_q[2], 1'b0, not_997};
  logic [5:0] select_999;
  assign select_999 = region_row_s4_q[0] ? {select_998[2], 1'b0, select_998[1], 1'b0, select_998[0], 1'b0} : {1'b0, select_998[2], 1'b0, select_998[1], 1'b0, select_998[0]};
  logic [11:0] select_1000;
  assign select_1000 = or_996_s4_q ? {select_999[5], 1'b0, select_999[4], 1'b0, select_999[3], 1'b0, select_999[2], 1'b0, select_999[1], 1'b0, select_999[0], 1'b0} : {1'b0, select_999[5], 1'b0, select_999[4], 1'b0, select_999[3], 1'b0, select_999[2], 1'b0, select_999[1], 1'b0, select_999[0]};
  logic [23:0] select_1001;
  assign select_1001 = or_993_s4_q ? {select_1000[11], 1'b0, select_1000[10], 1'b0, select_1000[9], 1'b0, select_1000[8], 1'b0, select_1000[7], 1'b0, select_1000[6], 1'b0, select_1000[5], 1'b0, select_1000[4], 1'b0, select_1000[3], 1'b0, select_1000[2], 1'b0, select_1000[1], 1'b0, select_1000[0], 1'b0} : {1'b0, select_1000[11], 1'b0, select_1000[10], 1'b0, select_1000[9], 1'b0, select_1000[8], 1'b0, select_1000[7], 1'b0, select_1000[6], 1'b0, select_1000[5], 1'b0, select_1000[4], 1'b0, select_1000[3], 1'b0, select_1000[2], 1'b0, select_1000[1], 1'b0, select_1000[0]};
  logic [47:0] select_1002;
  assign select_1002 = or_990_s4_q ? {select_1001[23], 1'b0, select_1001[22], 1'b0, select_1001[21], 1'b0, select_1001[20], 1'b0, select_1001[19], 1'b0, select_1001[18], 1'b0, select_1001[17], 1'b0, select_1001[16], 1'b0, select_1001[15], 1'b0, select_1001[14], 1'b0, select_1001[13], 1'b0, select_1001[12], 1'b0, select_1001[11], 1'b0, select_1001[10], 1'b0, select_1001[9], 1'b0, select_1001[8], 1'b0, select_1001[7], 1'b0, select_1001[6], 1'b0, select_1001[5], 1'b0, select_1001[4], 1'b0, select_1001[3], 1'b0, select_1001[2], 1'b0, select_1001[1], 1'b0, select_1001[0], 1'b0} : {1'b0, select_1001[23], 1'b0, select_1001[22], 1'b0, select_1001[21], 1'b0, select_1001[20], 1'b0, select_1001[19], 1'b0, select_1001[18], 1'b0, select_1001[17], 1'b0, select_1001[16], 1'b0, select_1001[15], 1'b0, select_1001[14], 1'b0, select_1001[13], 1'b0, select_1001[12], 1'b0, select_1001[11], 1'b0, select_1001[10], 1'b0, select_1001[9], 1'b0, select_1001[8], 1'b0, select_1001[7], 1'b0, select_1001[6], 1'b0, select_1001[5], 1'b0, select_1001[4], 1'b0, select_1001[3], 1'b0, select_1001[2], 1'b0, select_1001[1], 1'b0, select_1001[0]};
  // hls/stages/agreement.hpp:576
  logic [4:0] difference_1014;
  assign difference_1014 = {2'h0, explained_2_s4_q} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_1014 + (equal_982_s4_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:582
  logic [5:0] sum_1017;
  assign sum_1017 = {1'b0, e} + {2'h0, e[4:1]};
  logic is_seen;
  assign is_seen = (t[4:1] == 4'h0) ? (~((good_q & select_1002) == 48'h0)) : (~({sum_1017, e[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:577
  logic [4:0] difference_1028;
  assign difference_1028 = {2'h0, near_2_s4_q} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1028 + (equal_982_s4_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:590
  logic and_1032;
  assign and_1032 = is_seen & ({1'b0, e[4:1]} < n);
  // hls/stages/census.hpp:128
  logic [9:0] sum_1062;
  assign sum_1062 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_1063;
  assign difference_1063 = {1'b0, sum_1062[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1064;
  assign xor_1064 = {difference_1063[8:0], sum_1062[0]} ^ {10{difference_1063[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1063[9]} + {1'b0, xor_1064};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_339_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/census.hpp:128
  logic [9:0] sum_1069;
  assign sum_1069 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_1070;
  assign difference_1070 = {1'b0, sum_1069[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1071;
  assign xor_1071 = {difference_1070[8:0], sum_1069[0]} ^ {10{difference_1070[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1070[9]} + {1'b0, xor_1071};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_339_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1155;
  assign select_1155 = and_336_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1156;
  assign select_1156 = and_336_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1157;
  assign select_1157 = and_336_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1158;
  assign select_1158 = and_336_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_1161;
  assign sum_1161 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1153_s4_q};
  logic [13:0] sum_1163;
  assign sum_1163 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1161});
  // hls/stages/census.hpp:225
  logic and_1165;
  assign and_1165 = and_414_s4_q & (9'h4 < sum_1163[13:5]);
  // hls/stages/census.hpp:226
  logic and_1166;
  assign and_1166 = and_414_s4_q & less_438;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1167;
  assign sum_1167 = census_left_misses_q + {{17{and_1166}}, and_1165, 1'b0, and_1165};
  // hls/stages/agreement.hpp:176
  logic [19:0] select_1169;
  assign select_1169 = and_336_s4_q ? (equal_1160_s4_q ? 20'h0 : sum_1167) : census_left_misses_q;
  // hls/stages/census.hpp:275
  logic and_1178;
  assign and_1178 = whole_2_s4_q & (~(select_302_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:243
  logic and_1184;
  assign and_1184 = and_1178 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, detail};
  // hls/stages/census.hpp:276
  logic [12:0] select_1186;
  assign select_1186 = and_1184 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1188;
  assign select_1188 = equal_1160_s4_q ? {11'h0, select_1186} : (sharpness_sums_detail_0_q + {11'h0, select_1186});
  // hls/stages/agreement.hpp:243
  logic and_1195;
  assign and_1195 = and_1178 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, detail_2};
  // hls/stages/census.hpp:276
  logic [12:0] select_1197;
  assign select_1197 = and_1195 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1199;
  assign select_1199 = equal_1160_s4_q ? {11'h0, select_1197} : (sharpness_sums_detail_1_q + {11'h0, select_1197});
  logic [8:0] select_1202;
  assign select_1202 = and_1184 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_1203;
  assign sum_1203 = (equal_1160_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1202};
  logic [8:0] select_1206;
  assign select_1206 = and_1195 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_1207;
  assign sum_1207 = (equal_1160_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1206};
  // hls/stages/agreement.hpp:484
  logic [13:0] select_1351;
  assign select_1351 = and_1344_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1349_s4_q});
  // hls/stages/agreement.hpp:299
  logic and_1354;
  assign and_1354 = not_352_s4_q & (not_496_s4_q & (begins_product_q & textured_s4_q));
  logic and_1359;
  assign and_1359 = not_352_s4_q & (not_496_s4_q & (begins_product_q & explained_s4_q));
  logic and_1364;
  assign and_1364 = not_352_s4_q & (not_496_s4_q & (begins_product_q & and_929_s4_q));
  // hls/stages/agreement.hpp:584
  logic or_1370;
  assign or_1370 = is_seen | or_1369_s4_q;
  // hls/stages/agreement.hpp:299
  logic and_1374;
  assign and_1374 = not_352_s4_q & (not_496_s4_q & (begins_product_q & (~or_1370)));
  // hls/stages/agreement.hpp:608
  logic less_1377;
  assign less_1377 = region_row_s4_q < x_s4_q[5:3];
  logic [11:0] select_1378;
  assign select_1378 = less_1377 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1381;
  assign select_1381 = less_1377 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:609
  logic [12:0] sum_1382;
  assign sum_1382 = {1'b0, select_1381} + {3'h0, select_1381[11:2]};
  logic and_1384;
  assign and_1384 = (~(select_1378[11:4] == 8'h0)) & ({sum_1382, select_1381[1:0]} < {3'h0, select_1378});
  // hls/stages/agreement.hpp:299
  logic [11:0] select_1387;
  assign select_1387 = equal_895_s4_q ? (equal_896_s4_q ? 12'h0 : (and_1384 ? select_1378 : 12'h0)) : 12'h0;
  logic [11:0] select_1389;
  assign select_1389 = equal_353_s4_q ? 12'h0 : (begins_product_q ? 12'h0 : select_1387);
  logic [11:0] select_1390;
  assign select_1390 = equal_351_s4_q ? 12'h0 : select_1389;
  // hls/stages/agreement.hpp:484
  logic [13:0] select_1392;
  assign select_1392 = and_1344_s4_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1390});
  // hls/stages/agreement.hpp:165
  logic [8:0] select_1402;
  assign select_1402 = less_354_s4_q ? 9'h0 : (and_906_s4_q ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0);
  // hls/stages/agreement.hpp:299
  logic [20:0] select_1403;
  assign select_1403 = begins_product_q ? {{12{select_1402[8]}}, select_1402} : {1'b0, select_1387, 8'h0};
  logic [20:0] select_1405;
  assign select_1405 = equal_351_s4_q ? 21'h0 : (equal_353_s4_q ? 21'h0 : select_1403);
  // hls/stages/agreement.hpp:484
  logic [23:0] select_1407;
  assign select_1407 = and_1344_s4_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1405[20]}}, select_1405});
  // hls/stages/agreement.hpp:530
  logic [8:0] select_1409;
  assign select_1409 = and_906_s4_q ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1410;
  assign select_1410 = less_354_s4_q ? 8'h0 : select_1409[7:0];
  // hls/stages/agreement.hpp:165
  logic and_1411;
  assign and_1411 = not_355_s4_q & select_1409[8];
  // hls/stages/agreement.hpp:588
  logic [2:0] select_1413;
  assign select_1413 = or_1370 ? {3{and_1411}} : ({3{and_1411}} + 3'h1);
  // hls/stages/agreement.hpp:299
  logic [10:0] select_1415;
  assign select_1415 = equal_353_s4_q ? 11'h0 : (begins_product_q ? {select_1413, select_1410} : 11'h0);
  logic [10:0] select_1416;
  assign select_1416 = equal_351_s4_q ? 11'h0 : select_1415;
  // hls/stages/agreement.hpp:482
  logic [23:0] sum_1417;
  assign sum_1417 = counts_too_much_unproven_q + {{13{select_1416[10]}}, select_1416};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1472;
  assign select_1472 = equal_1433_s4_q ? 8'h0 : (equal_1434_s4_q ? 8'h0 : residual_s4_q);
  // hls/stages/agreement.hpp:165
  logic [7:0] select_1475;
  assign select_1475 = less_354_s4_q ? 8'h0 : (and_1429_s4_q ? (equal_1432_s4_q ? 8'h0 : select_1472) : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1478;
  assign select_1478 = equal_351_s4_q ? 8'h0 : (equal_353_s4_q ? 8'h0 : (begins_product_q ? select_1475 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1479;
  assign sum_1479 = registration_counts_across_0_q + {{12{select_1478[7]}}, select_1478};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1482;
  assign select_1482 = equal_1433_s4_q ? 8'h0 : (equal_1434_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:165
  logic [7:0] select_1485;
  assign select_1485 = less_354_s4_q ? 8'h0 : (and_1429_s4_q ? (equal_1432_s4_q ? 8'h0 : select_1482) : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1488;
  assign select_1488 = equal_351_s4_q ? 8'h0 : (equal_353_s4_q ? 8'h0 : (begins_product_q ? select_1485 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1489;
  assign sum_1489 = registration_counts_across_1_q + {{12{select_1488[7]}}, select_1488};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1492;
  assign select_1492 = equal_1432_s4_q ? 8'h0 : (equal_1433_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1495;
  assign select_1495 = begins_product_q ? (less_354_s4_q ? 8'h0 : (and_1429_s4_q ? select_1492 : 8'h0)) : 8'h0;
  logic [7:0] select_1497;
  assign select_1497 = equal_351_s4_q ? 8'h0 : (equal_353_s4_q ? 8'h0 : select_1495);
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1498;
  assign sum_1498 = registration_counts_across_2_q + {{12{select_1497[7]}}, select_1497};
  // hls/stages/agreement.hpp:165
  logic [7:0] select_1502;
  assign select_1502 = less_354_s4_q ? 8'h0 : (and_1429_s4_q ? (equal_1432_s4_q ? residual_s4_q : 8'h0) : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1505;
  assign select_1505 = equal_351_s4_q ? 8'h0 : (equal_353_s4_q ? 8'h0 : (begins_product_q ? select_1502 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1506;
  assign sum_1506 = registration_counts_across_3_q + {{12{select_1505[7]}}, select_1505};
  // hls/stages/agreement.hpp:604
  logic and_1756;
  assign and_1756 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:611
  logic [12:0] sum_1760;
  assign sum_1760 = {1'b0, select_1381} + {2'h0, select_1381[11:1]};
  logic select_1763;
  assign select_1763 = (select_1378[11:3] == 9'h0) ? (and_1756 & (~less_1757_s4_q)) : (~({sum_1760, select_1381[0]} < {2'h0, select_1378}));
  // hls/stages/agreement.hpp:619
  logic [47:0] select_1764;
  assign select_1764 = equal_896_s4_q ? good_next_q : {select_1763, good_next_q[47:1]};
  // hls/stages/agreement.hpp:299
  logic [47:0] select_1766;
  assign select_1766 = equal_895_s4_q ? (equal_1751_s4_q ? select_1764 : good_q) : good_q;
  logic [47:0] select_1768;
  assign select_1768 = equal_353_s4_q ? good_q : (begins_product_q ? good_q : select_1766);
  logic [47:0] select_1771;
  assign select_1771 = begins_product_q ? good_next_q : (equal_895_s4_q ? select_1764 : good_next_q);
  logic [47:0] select_1773;
  assign select_1773 = equal_351_s4_q ? good_next_q : (equal_353_s4_q ? good_next_q : select_1771);
  // hls/stages/agreement.hpp:636
  logic [35:0] select_1792;
  assign select_1792 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:630
  logic [35:0] detail_left;
  assign detail_left = begins_product_s4_q ? 36'h0 : select_1792;
  // hls/stages/agreement.hpp:636
  logic [35:0] select_1795;
  assign select_1795 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:640
  logic [35:0] detail_right;
  assign detail_right = begins_product_s4_q ? 36'h0 : select_1795;
  // hls/stages/agreement.hpp:630
  logic [34:0] select_1797;
  assign select_1797 = begins_product_s4_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:640
  logic [34:0] select_1798;
  assign select_1798 = begins_product_s4_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:630
  logic [17:0] select_1799;
  assign select_1799 = begins_product_s4_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:640
  logic [17:0] select_1800;
  assign select_1800 = begins_product_s4_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:299
  logic [4:0] select_1801;
  assign select_1801 = begins_product_q ? {2'h0, textured_2_s4_q} : box_textured_columns_values_0_q;
  logic [4:0] select_1803;
  assign select_1803 = equal_351_s4_q ? box_textured_columns_values_0_q : (equal_353_s4_q ? box_textured_columns_values_0_q : select_1801);
  logic [4:0] select_1804;
  assign select_1804 = begins_product_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1806;
  assign select_1806 = equal_351_s4_q ? box_textured_columns_values_1_q : (equal_353_s4_q ? box_textured_columns_values_1_q : select_1804);
  logic [4:0] select_1807;
  assign select_1807 = begins_product_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1809;
  assign select_1809 = equal_351_s4_q ? box_textured_columns_values_2_q : (equal_353_s4_q ? box_textured_columns_values_2_q : select_1807);
  logic [4:0] select_1810;
  assign select_1810 = begins_product_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1812;
  assign select_1812 = equal_351_s4_q ? box_textured_columns_values_3_q : (equal_353_s4_q ? box_textured_columns_values_3_q : select_1810);
  logic [4:0] select_1813;
  assign select_1813 = begins_product_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1815;
  assign select_1815 = equal_351_s4_q ? box_textured_columns_values_4_q : (equal_353_s4_q ? box_textured_columns_values_4_q : select_1813);
  logic [4:0] select_1817;
  assign select_1817 = equal_353_s4_q ? box_textured_sum_sums_values_0_q : (begins_product_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1819;
  assign select_1819 = begins_product_q ? {2'h0, explained_2_s4_q} : box_explained_columns_values_0_q;
  logic [4:0] select_1821;
  assign select_1821 = equal_351_s4_q ? box_explained_columns_values_0_q : (equal_353_s4_q ? box_explained_columns_values_0_q : select_1819);
  logic [4:0] select_1822;
  assign select_1822 = begins_product_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1824;
  assign select_1824 = equal_351_s4_q ? box_explained_columns_values_1_q : (equal_353_s4_q ? box_explained_columns_values_1_q : select_1822);
  logic [4:0] select_1825;
  assign select_1825 = begins_product_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1827;
  assign select_1827 = equal_351_s4_q ? box_explained_columns_values_2_q : (equal_353_s4_q ? box_explained_columns_values_2_q : select_1825);
  logic [4:0] select_1828;
  assign select_1828 = begins_product_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1830;
  assign select_1830 = equal_351_s4_q ? box_explained_columns_values_3_q : (equal_353_s4_q ? box_explained_columns_values_3_q : select_1828);
  logic [4:0] select_1831;
  assign select_1831 = begins_product_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1833;
  assign select_1833 = equal_351_s4_q ? box_explained_columns_values_4_q : (equal_353_s4_q ? box_explained_columns_values_4_q : select_1831);
  logic [4:0] select_1835;
  assign select_1835 = equal_353_s4_q ? box_explained_sum_sums_values_0_q : (begins_product_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1837;
  assign select_1837 = begins_product_q ? {2'h0, near_2_s4_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_1839;
  assign select_1839 = equal_351_s4_q ? box_nearer_columns_values_0_q : (equal_353_s4_q ? box_nearer_columns_values_0_q : select_1837);
  logic [4:0] select_1840;
  assign select_1840 = begins_product_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1842;
  assign select_1842 = equal_351_s4_q ? box_nearer_columns_values_1_q : (equal_353_s4_q ? box_nearer_columns_values_1_q : select_1840);
  logic [4:0] select_1843;
  assign select_1843 = begins_product_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1845;
  assign select_1845 = equal_351_s4_q ? box_nearer_columns_values_2_q : (equal_353_s4_q ? box_nearer_columns_values_2_q : select_1843);
  logic [4:0] select_1846;
  assign select_1846 = begins_product_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1848;
  assign select_1848 = equal_351_s4_q ? box_nearer_columns_values_3_q : (equal_353_s4_q ? box_nearer_columns_values_3_q : select_1846);
  logic [4:0] select_1849;
  assign select_1849 = begins_product_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_1851;
  assign select_1851 = equal_351_s4_q ? box_nearer_columns_values_4_q : (equal_353_s4_q ? box_nearer_columns_values_4_q : select_1849);
  logic [4:0] select_1853;
  assign select_1853 = equal_353_s4_q ? box_nearer_sum_sums_values_0_q : (begins_product_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:727
  logic [1:0] select_1894;
  assign select_1894 = and_1893_s4_q ? {and_1032, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:728
  logic and_1895;
  assign and_1895 = proven_q & less_1883;
  // hls/stages/agreement.hpp:179
  logic select_1898;
  assign select_1898 = and_965_s4_q ? (less_966_s4_q ? (select_1894[0] & and_1895) : seen_q) : seen_q;
  logic select_1901;
  assign select_1901 = and_965_s4_q ? (less_966_s4_q ? (select_1894[1] & and_1895) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:299
  logic [13:0] select_1906;
  assign select_1906 = equal_895_s4_q ? (equal_1751_s4_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_1908;
  assign select_1908 = equal_353_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1906);
  logic [13:0] select_1911;
  assign select_1911 = equal_895_s4_q ? (equal_1751_s4_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_1913;
  assign select_1913 = equal_353_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1911);
  logic [13:0] select_1916;
  assign select_1916 = equal_895_s4_q ? (equal_1751_s4_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_1918;
  assign select_1918 = equal_353_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1916);
  logic [13:0] select_1921;
  assign select_1921 = equal_895_s4_q ? (equal_1751_s4_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_1923;
  assign select_1923 = equal_353_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1921);
  logic [13:0] select_1926;
  assign select_1926 = equal_895_s4_q ? (equal_1751_s4_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_1928;
  assign select_1928 = equal_353_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1926);
  logic [13:0] select_1931;
  assign select_1931 = equal_895_s4_q ? (equal_1751_s4_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic [13:0] select_1933;
  assign select_1933 = equal_353_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1931);
  // hls/stages/agreement.hpp:656
  logic not_1942;
  assign not_1942 = ~and_1756;
  // hls/stages/agreement.hpp:299
  logic and_1946;
  assign and_1946 = not_1257_s4_q & (equal_895_s4_q & (equal_1751_s4_q & (cfg_prove_i & not_1942)));
  // hls/stages/agreement.hpp:657
  logic or_1949;
  assign or_1949 = not_1902 | not_1942;
  // hls/stages/agreement.hpp:623
  logic or_1954;
  assign or_1954 = ($signed(24'h0) < $signed(counts_too_many_bad_q)) | ($signed(24'h0) < $signed(counts_too_much_unproven_q));
  // hls/stages/agreement.hpp:299
  logic and_1956;
  assign and_1956 = equal_1751_s4_q & ((less_1757_s4_q | or_1949) ? (~or_1949) : or_1954);
  logic and_1960;
  assign and_1960 = not_352_s4_q & (not_496_s4_q & (not_1257_s4_q & (equal_895_s4_q & and_1956)));
  // hls/stages/agreement.hpp:623
  logic select_2024;
  assign select_2024 = or_1984_s4_q ? select_2021_s4_q : or_2023_s4_q;
  logic or_2026;
  assign or_2026 = less_2025_s4_q | select_2024;
  logic select_2027;
  assign select_2027 = or_1977_s4_q ? select_2024 : or_2026;
  logic or_2029;
  assign or_2029 = less_2028_s4_q | select_2027;
  logic select_2034;
  assign select_2034 = less_1972_s4_q ? or_2026 : (less_1978_s4_q ? or_2023_s4_q : select_2032_s4_q);
  logic select_2036;
  assign select_2036 = less_1964_s4_q ? (less_1965_s4_q | (or_1970_s4_q ? select_2027 : or_2029)) : (less_1967_s4_q ? or_2029 : select_2034);
  // hls/stages/agreement.hpp:299
  logic and_2040;
  assign and_2040 = not_1257_s4_q & (equal_895_s4_q & (equal_1751_s4_q & (cfg_prove_i & select_2036)));
  // hls/stages/agreement.hpp:663
  logic and_2043;
  assign and_2043 = cfg_prove_i & and_1756;
  // hls/stages/agreement.hpp:664
  logic [36:0] sum_2044;
  assign sum_2044 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2046;
  assign less_2046 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:623
  logic or_2049;
  assign or_2049 = ({detail_left, 3'h0} < {sum_2044, detail_right[1:0]}) | (less_2046 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:299
  logic and_2053;
  assign and_2053 = not_1257_s4_q & (equal_895_s4_q & (equal_1751_s4_q & (and_2043 & or_2049)));
  // hls/stages/agreement.hpp:667
  logic [36:0] sum_2056;
  assign sum_2056 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2058;
  assign less_2058 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:623
  logic or_2059;
  assign or_2059 = ({detail_right, 3'h0} < {sum_2056, detail_left[1:0]}) | less_2058;
  // hls/stages/agreement.hpp:299
  logic and_2063;
  assign and_2063 = not_1257_s4_q & (equal_895_s4_q & (equal_1751_s4_q & (and_2043 & or_2059)));
  logic [19:0] select_2078;
  assign select_2078 = equal_895_s4_q ? (equal_1751_s4_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2080;
  assign select_2080 = equal_353_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2078);
  logic [19:0] select_2083;
  assign select_2083 = equal_895_s4_q ? (equal_1751_s4_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2085;
  assign select_2085 = equal_353_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2083);
  logic [19:0] select_2088;
  assign select_2088 = equal_895_s4_q ? (equal_1751_s4_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2090;
  assign select_2090 = equal_353_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2088);
  logic [19:0] select_2093;
  assign select_2093 = equal_895_s4_q ? (equal_1751_s4_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [19:0] select_2095;
  assign select_2095 = equal_353_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2093);
  logic [23:0] select_2118;
  assign select_2118 = equal_895_s4_q ? (equal_1751_s4_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2120;
  assign select_2120 = equal_353_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2118);
  logic [23:0] select_2123;
  assign select_2123 = equal_895_s4_q ? (equal_1751_s4_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2125;
  assign select_2125 = equal_353_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2123);
  logic [23:0] select_2128;
  assign select_2128 = equal_895_s4_q ? (equal_1751_s4_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2130;
  assign select_2130 = equal_353_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2128);
  logic [23:0] select_2133;
  assign select_2133 = equal_895_s4_q ? (equal_1751_s4_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2135;
  assign select_2135 = equal_353_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2133);
  logic [5:0] select_2142;
  assign select_2142 = begins_product_q ? 6'h0 : (equal_895_s4_q ? (equal_896_s4_q ? 6'h0 : x_s4_q) : 6'h0);
  logic [11:0] select_2147;
  assign select_2147 = begins_product_q ? 12'h0 : (equal_895_s4_q ? (equal_896_s4_q ? 12'h0 : select_1378) : 12'h0);
  logic [11:0] select_2152;
  assign select_2152 = begins_product_q ? 12'h0 : (equal_895_s4_q ? (equal_896_s4_q ? 12'h0 : select_1381) : 12'h0);
  // hls/stages/agreement.hpp:619
  logic [11:0] select_2156;
  assign select_2156 = equal_896_s4_q ? 12'h0 : (less_1377 ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:299
  logic [11:0] select_2158;
  assign select_2158 = begins_product_q ? 12'h0 : (equal_895_s4_q ? select_2156 : 12'h0);

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = select_302_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_336_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_439, and_415_s4_q, and_414_s4_q, and_389_s4_q, less_382_s4_q, less_381_s4_q, less_380_s4_q, less_379_s4_q, less_378_s4_q, less_377_s4_q, less_376_s4_q, less_375_s4_q, less_374_s4_q, less_373_s4_q, less_372_s4_q, less_371_s4_q, less_370_s4_q, less_369_s4_q, less_368_s4_q, less_367_s4_q, less_366_s4_q, less_365_s4_q, less_364_s4_q, less_363_s4_q, less_362_s4_q, less_361_s4_q, less_360_s4_q, less_359_s4_q};
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
  assign best_left_we = s4_en & and_863_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_862, select_814_s4_q, select_810_s4_q};
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
  assign regions_waddr = {region_row_s4_q, or_888_s4_q, or_885_s4_q, or_882_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_936_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_933, sum_922, sum_911};
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
  assign map_waddr = {sum_971_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_1043_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1032, is_seen};
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
      census_left_misses_q <= select_1169;
      sharpness_sums_detail_0_q <= and_336_s4_q ? select_1188 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_336_s4_q ? select_1199 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_336_s4_q ? sum_1203 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_336_s4_q ? sum_1207 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1351;
      counts_textured_q <= and_1344_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_1354});
      counts_explained_q <= and_1344_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_1359});
      counts_nearer_q <= and_1344_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1364});
      counts_unproven_q <= and_1344_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1374});
      counts_regions_bad_q <= select_1392;
      counts_too_many_bad_q <= select_1407;
      counts_too_much_unproven_q <= and_1344_s4_q ? 24'h0 : sum_1417;
      registration_counts_across_0_q <= and_1344_s4_q ? 20'h0 : sum_1479;
      registration_counts_across_1_q <= and_1344_s4_q ? 20'h0 : sum_1489;
      registration_counts_across_2_q <= and_1344_s4_q ? 20'h0 : sum_1498;
      registration_counts_across_3_q <= and_1344_s4_q ? 20'h0 : sum_1506;
      segment_textured_q <= select_908 + {6'h0, and_1354};
      segment_explained_q <= select_919 + {6'h0, and_1359};
      segment_nearer_q <= select_930 + {6'h0, and_1364};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_351_s4_q ? good_q : select_1768;
      good_next_q <= select_1773;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1797;
      addend_1_q <= select_1798;
      multiplier_0_q <= select_1799;
      multiplier_1_q <= select_1800;
      seen_q <= select_1898;
      nearer_q <= select_1901;
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
      averager_quarter_1_0_q <= and_335_s4_q ? grey_s4_q : averager_quarter_1_0_q;
      averager_quarter_1_1_q <= and_335_s4_q ? grey_2_s4_q : averager_quarter_1_1_q;
      averager_quarter_2_0_q <= and_335_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q;
      averager_quarter_2_1_q <= and_335_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q;
      averager_detail_0_q <= and_335_s4_q ? detail : averager_detail_0_q;
      averager_detail_1_q <= and_335_s4_q ? detail_2 : averager_detail_1_q;
      census_changes_values_0_left_q <= and_336_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_336_s4_q ? sum_1153_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1155;
      census_changes_values_1_right_q <= select_1156;
      census_changes_values_2_left_q <= select_1157;
      census_changes_values_2_right_q <= select_1158;
      sharpness_last_mask_q <= and_336_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_336_s4_q ? detail : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_336_s4_q ? detail_2 : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_1803;
      box_textured_columns_values_1_q <= select_1806;
      box_textured_columns_values_2_q <= select_1809;
      box_textured_columns_values_3_q <= select_1812;
      box_textured_columns_values_4_q <= select_1815;
      box_textured_sum_sums_values_0_q <= equal_351_s4_q ? box_textured_sum_sums_values_0_q : select_1817;
      box_explained_columns_values_0_q <= select_1821;
      box_explained_columns_values_1_q <= select_1824;
      box_explained_columns_values_2_q <= select_1827;
      box_explained_columns_values_3_q <= select_1830;
      box_explained_columns_values_4_q <= select_1833;
      box_explained_sum_sums_values_0_q <= equal_351_s4_q ? box_explained_sum_sums_values_0_q : select_1835;
      box_nearer_columns_values_0_q <= select_1839;
      box_nearer_columns_values_1_q <= select_1842;
      box_nearer_columns_values_2_q <= select_1845;
      box_nearer_columns_values_3_q <= select_1848;
      box_nearer_columns_values_4_q <= select_1851;
      box_nearer_sum_sums_values_0_q <= equal_351_s4_q ? box_nearer_sum_sums_values_0_q : select_1853;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_1878_s5_q;
  logic or_1903_s5_q;
  logic and_1904_s5_q;
  logic [13:0] select_1909_s5_q;
  logic [13:0] select_1914_s5_q;
  logic [13:0] select_1919_s5_q;
  logic [13:0] select_1924_s5_q;
  logic [13:0] select_1929_s5_q;
  logic [13:0] select_1934_s5_q;
  logic and_1941_s5_q;
  logic and_1948_s5_q;
  logic and_1960_s5_q;
  logic and_2042_s5_q;
  logic and_2055_s5_q;
  logic and_2065_s5_q;
  logic and_2076_s5_q;
  logic [19:0] select_2081_s5_q;
  logic [19:0] select_2086_s5_q;
  logic [19:0] select_2091_s5_q;
  logic [19:0] select_2096_s5_q;
  logic [11:0] select_2101_s5_q;
  logic [11:0] select_2106_s5_q;
  logic [11:0] select_2111_s5_q;
  logic [11:0] select_2116_s5_q;
  logic [23:0] select_2121_s5_q;
  logic [23:0] select_2126_s5_q;
  logic [23:0] select_2131_s5_q;
  logic [23:0] select_2136_s5_q;
  logic and_2139_s5_q;
  logic [5:0] select_2144_s5_q;
  logic [11:0] select_2149_s5_q;
  logic [11:0] select_2154_s5_q;
  logic [11:0] select_2160_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_1878_s5_q <= said_q;
      or_1903_s5_q <= not_1902 | select_1898;
      and_1904_s5_q <= cfg_prove_i & select_1901;
      select_1909_s5_q <= equal_351_s4_q ? 14'h0 : select_1908;
      select_1914_s5_q <= equal_351_s4_q ? 14'h0 : select_1913;
      select_1919_s5_q <= equal_351_s4_q ? 14'h0 : select_1918;
      select_1924_s5_q <= equal_351_s4_q ? 14'h0 : select_1923;
      select_1929_s5_q <= equal_351_s4_q ? 14'h0 : select_1928;
      select_1934_s5_q <= equal_351_s4_q ? 14'h0 : select_1933;
      and_1941_s5_q <= and_1941_s4_q;
      and_1948_s5_q <= not_352_s4_q & (not_496_s4_q & and_1946);
      and_1960_s5_q <= and_1960;
      and_2042_s5_q <= not_352_s4_q & (not_496_s4_q & and_2040);
      and_2055_s5_q <= not_352_s4_q & (not_496_s4_q & and_2053);
      and_2065_s5_q <= not_352_s4_q & (not_496_s4_q & and_2063);
      and_2076_s5_q <= and_2076_s4_q;
      select_2081_s5_q <= equal_351_s4_q ? 20'h0 : select_2080;
      select_2086_s5_q <= equal_351_s4_q ? 20'h0 : select_2085;
      select_2091_s5_q <= equal_351_s4_q ? 20'h0 : select_2090;
      select_2096_s5_q <= equal_351_s4_q ? 20'h0 : select_2095;
      select_2101_s5_q <= select_2101_s4_q;
      select_2106_s5_q <= select_2106_s4_q;
      select_2111_s5_q <= select_2111_s4_q;
      select_2116_s5_q <= select_2116_s4_q;
      select_2121_s5_q <= equal_351_s4_q ? 24'h0 : select_2120;
      select_2126_s5_q <= equal_351_s4_q ? 24'h0 : select_2125;
      select_2131_s5_q <= equal_351_s4_q ? 24'h0 : select_2130;
      select_2136_s5_q <= equal_351_s4_q ? 24'h0 : select_2135;
      and_2139_s5_q <= and_2139_s4_q;
      select_2144_s5_q <= equal_351_s4_q ? 6'h0 : (equal_353_s4_q ? 6'h0 : select_2142);
      select_2149_s5_q <= equal_351_s4_q ? 12'h0 : (equal_353_s4_q ? 12'h0 : select_2147);
      select_2154_s5_q <= equal_351_s4_q ? 12'h0 : (equal_353_s4_q ? 12'h0 : select_2152);
      select_2160_s5_q <= equal_351_s4_q ? 12'h0 : (equal_353_s4_q ? 12'h0 : select_2158);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign pixel_1_o = pixel_1_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_1903_s5_q;
  assign marks_nearer_o = and_1904_s5_q;
  assign verdict_valid_o = and_1878_s5_q;
  assign verdict_supervised_o = {2'h0, select_1909_s5_q};
  assign verdict_textured_o = {2'h0, select_1914_s5_q};
  assign verdict_explained_o = {2'h0, select_1919_s5_q};
  assign verdict_nearer_o = {2'h0, select_1924_s5_q};
  assign verdict_unproven_o = {2'h0, select_1929_s5_q};
  assign verdict_regions_bad_o = {2'h0, select_1934_s5_q};
  assign verdict_unproven_yet_o = and_1941_s5_q;
  assign verdict_untextured_o = and_1948_s5_q;
  assign verdict_disagree_o = and_1960_s5_q;
  assign verdict_moved_o = and_2042_s5_q;
  assign verdict_unsharp_left_o = and_2055_s5_q;
  assign verdict_unsharp_right_o = and_2065_s5_q;
  assign verdict_hidden_o = and_2076_s5_q;
  assign verdict_across_0_o = select_2081_s5_q;
  assign verdict_across_1_o = select_2086_s5_q;
  assign verdict_across_2_o = select_2091_s5_q;
  assign verdict_across_3_o = select_2096_s5_q;
  assign verdict_measured_0_o = select_2101_s5_q;
  assign verdict_measured_1_o = select_2106_s5_q;
  assign verdict_measured_2_o = select_2111_s5_q;
  assign verdict_measured_3_o = select_2116_s5_q;
  assign verdict_detail_0_o = select_2121_s5_q;
  assign verdict_detail_1_o = select_2126_s5_q;
  assign verdict_contrast_0_o = select_2131_s5_q;
  assign verdict_contrast_1_o = select_2136_s5_q;
  assign region_valid_o = and_2139_s5_q;
  assign region_region_o = select_2144_s5_q;
  assign region_textured_o = select_2149_s5_q;
  assign region_explained_o = select_2154_s5_q;
  assign region_nearer_o = select_2160_s5_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_1963[2:0], sum_1461[0], sum_1457[0], sum_1449[1:0], sum_1448[1:0], sum_1444[0], detail_4[1:0], detail_3[1:0], sum_1163[4:0], sum_855[8:0], sum_437[4:0], cfg_width_i[2:0]};

endmodule
