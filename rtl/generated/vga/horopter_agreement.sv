// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2485 bits, pipeline 1145 bits, memories 54864 bits.
module horopter_agreement (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic [7:0] pixel_1_i,
  input  logic saturated_i,
  input  logic mask_i,
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
  logic [3:0] sum_1259;
  assign sum_1259 = {1'b0, cfg_width_i[9:7]} + 4'hf;
  logic [6:0] sum_1263;
  assign sum_1263 = {1'b0, cfg_width_i[9:4]} + 7'h7;
  logic [5:0] sum_1278;
  assign sum_1278 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [7:0] limit;
  assign limit = {2'h0, cfg_moved_limit_i} + 8'hff;
  logic [6:0] difference_1704;
  assign difference_1704 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_1865;
  assign less_1865 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_1866;
  assign sum_1866 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_1884;
  assign not_1884 = ~cfg_prove_i;

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
  logic [2:0] select_295;
  assign select_295 = marks_first_i ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_297;
  assign select_297 = marks_first_i ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:92
  logic [8:0] select_300;
  assign select_300 = ({select_297, select_295} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:93
  logic [8:0] select_301;
  assign select_301 = select_295[0] ? averager_place_q : select_300;
  // hls/stages/census.hpp:40
  logic or_302;
  assign or_302 = marks_first_i | raster_at_live_q;
  // hls/stages/agreement.hpp:171
  logic and_308;
  assign and_308 = (~((~or_302) | (~select_295[0]))) & (select_301[8:6] < 3'h5);
  // hls/stages/census.hpp:40
  logic [2:0] select_312;
  assign select_312 = marks_first_i ? 3'h0 : raster_at_y_q;
  // hls/stages/census.hpp:45
  logic equal_324;
  assign equal_324 = select_295 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_325;
  assign equal_325 = select_312 == 3'h7;
  // hls/stages/census.hpp:102
  logic and_326;
  assign and_326 = equal_325 & and_308;
  // hls/stages/census.hpp:103
  logic and_327;
  assign and_327 = equal_324 & and_326;
  // hls/stages/agreement.hpp:333
  logic equal_339;
  assign equal_339 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:320
  logic not_340;
  assign not_340 = ~equal_339;
  // hls/stages/agreement.hpp:333
  logic equal_341;
  assign equal_341 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:390
  logic less_342;
  assign less_342 = run_highest_q < x_q;
  // hls/stages/agreement.hpp:394
  logic not_343;
  assign not_343 = ~less_342;
  // hls/stages/agreement.hpp:298
  logic and_344;
  assign and_344 = equal_341 & not_343;
  logic and_345;
  assign and_345 = not_340 & and_344;
  // hls/stages/census.hpp:40
  logic [5:0] row;
  assign row = marks_first_i ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:748
  logic drew;
  assign drew = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:298
  logic and_429;
  assign and_429 = drew & not_343;
  logic [6:0] select_456;
  assign select_456 = equal_339 ? ({run_shift_q[5], run_shift_q} + x_q[6:0]) : x_q[6:0];
  // hls/stages/agreement.hpp:409
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:818
  logic or_923;
  assign or_923 = marks_first_i | raster_row_ended_q;
  // hls/stages/agreement.hpp:820
  logic [17:0] select_925;
  assign select_925 = marks_first_i ? 18'h1 : (or_923 ? {rows_passed_q[16:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:819
  logic [8:0] select_927;
  assign select_927 = or_923 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:827
  logic select_929;
  assign select_929 = cfg_compete_i ? (or_923 & select_925[17]) : (select_927[8] & select_925[9]);
  // hls/stages/agreement.hpp:696
  logic [6:0] sum_1020;
  assign sum_1020 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/census.hpp:44
  logic [8:0] select_1037;
  assign select_1037 = marks_first_i ? cfg_height_i : (raster_rows_left_q - {8'h0, marks_last_i});
  // hls/stages/agreement.hpp:242
  logic equal_1191;
  assign equal_1191 = {last[7], select_297} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:170
  logic [2:0] select_1192;
  assign select_1192 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1195;
  assign select_1195 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1198;
  assign select_1198 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1201;
  assign select_1201 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1204;
  assign select_1204 = ends_q ? following_shift_q : run_shift_q;
  logic select_1207;
  assign select_1207 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:243
  logic not_1208;
  assign not_1208 = ~equal_1191;
  // hls/stages/agreement.hpp:325
  logic not_1211;
  assign not_1211 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:333
  logic equal_1212;
  assign equal_1212 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:150
  logic or_1213;
  assign or_1213 = equal_1212 | equal_341;
  logic [2:0] select_1214;
  assign select_1214 = equal_339 ? {run_last_shift_q, {2{not_1211}}} : {1'b0, or_1213, equal_341};
  logic [7:0] select_1217;
  assign select_1217 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1218;
  assign select_1218 = equal_341 ? least_q : 7'h0;
  logic [7:0] select_1222;
  assign select_1222 = run_last_shift_q ? {1'b0, last_q} : (run_shift_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1224;
  assign select_1224 = equal_341 ? last_q : (equal_1212 ? last_q : 7'h0);
  logic [7:0] select_1230;
  assign select_1230 = equal_339 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_341 ? first_beats_q : (equal_1212 ? whole_beats_q : 8'h0));
  logic [5:0] select_1235;
  assign select_1235 = equal_339 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_341 ? (6'h0 - least_q[5:0]) : 6'h0);
  // hls/stages/agreement.hpp:130
  logic not_1237;
  assign not_1237 = ~drew;
  // hls/stages/agreement.hpp:150
  logic select_1241;
  assign select_1241 = equal_339 ? (next_last_shift_q & not_1211) : (equal_341 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1244;
  assign select_1244 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1248;
  assign select_1248 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:249
  logic less_1255;
  assign less_1255 = 6'he < select_297[6:1];
  // hls/stages/agreement.hpp:173
  logic [6:0] select_1258;
  assign select_1258 = and_327 ? (equal_1191 ? (less_1255 ? 7'h1e : select_297) : least_q) : least_q;
  // hls/stages/agreement.hpp:243
  logic [7:0] select_1261;
  assign select_1261 = equal_1191 ? (less_1255 ? {sum_1259, cfg_width_i[6:3]} : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1265;
  assign select_1265 = and_327 ? (equal_1191 ? {sum_1263, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:301
  logic not_1266;
  assign not_1266 = ~ends_q;
  // hls/stages/agreement.hpp:170
  logic [5:0] select_1267;
  assign select_1267 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:173
  logic [6:0] select_1269;
  assign select_1269 = and_327 ? (equal_1191 ? 7'h0 : {select_1267, not_1266}) : {select_1267, not_1266};
  // hls/stages/agreement.hpp:170
  logic and_1271;
  assign and_1271 = not_1266 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:261
  logic [6:0] sum_1274;
  assign sum_1274 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:243
  logic select_1276;
  assign select_1276 = equal_1191 ? ({sum_1274[6], cfg_height_i[8:3]} == {1'b0, sum_1274[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:608
  logic [5:0] sum_1409;
  assign sum_1409 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:143
  logic not_1768;
  assign not_1768 = ~run_shift_q[5];

  // Memory fresh, 80 x 28, DISTANCE 12, hls/stages/agreement.hpp:885; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 28'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_345;
  logic [27:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 80 x 73, DISTANCE 12, hls/stages/agreement.hpp:886; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [72:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 73'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (equal_339 ? not_343 : (equal_341 ? not_343 : and_429));
  logic [72:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 80 x 91, DISTANCE 12, hls/stages/agreement.hpp:887; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_456;
  logic right_codes_re;
  assign right_codes_re = s0_en & (equal_339 ? not_343 : and_344);
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
      raster_at_x_q <= select_295 + 3'h1;
      raster_at_y_q <= marks_last_i ? (select_312 + 3'h1) : select_312;
      raster_at_column_q <= select_297 + {6'h0, equal_324};
      raster_at_row_q <= marks_last_i ? (row + {5'h0, equal_325}) : row;
      raster_at_live_q <= marks_last_i ? (or_302 & (~raster_final_row_q)) : or_302;
      raster_rows_left_q <= select_1037;
      raster_row_ended_q <= marks_last_i;
      raster_final_row_q <= raster_rows_left_q == 9'h1;
      averager_place_q <= select_301;
      run_phase_q <= and_327 ? (equal_1191 ? 3'h1 : select_1192) : select_1192;
      run_lowest_q <= and_327 ? (equal_1191 ? 8'h0 : select_1195) : select_1195;
      run_highest_q <= and_327 ? (equal_1191 ? 8'h0 : select_1198) : select_1198;
      run_beats_q <= and_327 ? (equal_1191 ? 8'hc : select_1201) : select_1201;
      run_shift_q <= and_327 ? (equal_1191 ? 6'h0 : select_1204) : select_1204;
      run_last_shift_q <= and_327 ? (select_1207 & not_1208) : select_1207;
      following_phase_q <= drew ? {final_row_q, 1'b0, final_row_q} : select_1214;
      following_lowest_q <= drew ? 8'h0 : (equal_339 ? select_1217 : {1'b0, select_1218});
      following_highest_q <= drew ? 8'h0 : (equal_339 ? select_1222 : {1'b0, select_1224});
      following_beats_q <= drew ? 8'h3f : select_1230;
      following_shift_q <= drew ? 6'h0 : select_1235;
      following_last_shift_q <= not_1237 & select_1241;
      x_q <= and_327 ? (equal_1191 ? 8'h0 : select_1244) : select_1244;
      beats_left_q <= and_327 ? (equal_1191 ? 8'hc : select_1248) : select_1248;
      last_q <= and_327 ? (equal_1191 ? select_297 : last_q) : last_q;
      least_q <= select_1258;
      first_beats_q <= and_327 ? select_1261 : first_beats_q;
      whole_beats_q <= select_1265;
      age_q <= select_1269;
      ends_q <= and_327 ? (and_1271 & not_1208) : and_1271;
      final_row_q <= and_327 ? select_1276 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1768}}, 1'b1} + run_beats_q;
      next_shift_q <= run_shift_q + 6'h1;
      next_last_shift_q <= {{3{run_shift_q[5]}}, run_shift_q} == ({2'h0, least_q} + 9'h1ff);
      rows_passed_q <= select_925;
      columns_passed_q <= {select_927[7:0], or_923};
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
  logic select_295_s1_q;
  logic [6:0] select_297_s1_q;
  logic and_308_s1_q;
  logic equal_313_s1_q;
  logic and_326_s1_q;
  logic and_327_s1_q;
  logic equal_330_s1_q;
  logic equal_339_s1_q;
  logic not_340_s1_q;
  logic equal_341_s1_q;
  logic less_342_s1_q;
  logic not_343_s1_q;
  logic and_345_s1_q;
  logic [5:0] row_s1_q;
  logic drew_s1_q;
  logic and_429_s1_q;
  logic [6:0] x_s1_2_q;
  logic and_480_s1_q;
  logic equal_486_s1_q;
  logic equal_553_s1_q;
  logic equal_790_s1_q;
  logic equal_854_s1_q;
  logic equal_877_s1_q;
  logic equal_880_s1_q;
  logic select_929_s1_q;
  logic not_1022_s1_q;
  logic equal_1191_s1_q;
  logic not_1237_s1_q;
  logic less_1410_s1_q;
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
      select_295_s1_q <= select_295[0];
      select_297_s1_q <= select_297;
      and_308_s1_q <= and_308;
      equal_313_s1_q <= select_312 == 3'h0;
      and_326_s1_q <= and_326;
      and_327_s1_q <= and_327;
      equal_330_s1_q <= select_295 == 3'h1;
      equal_339_s1_q <= equal_339;
      not_340_s1_q <= not_340;
      equal_341_s1_q <= equal_341;
      less_342_s1_q <= less_342;
      not_343_s1_q <= not_343;
      and_345_s1_q <= and_345;
      row_s1_q <= row;
      drew_s1_q <= drew;
      and_429_s1_q <= and_429;
      x_s1_2_q <= x[6:0];
      and_480_s1_q <= age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q}));
      equal_486_s1_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_553_s1_q <= run_lowest_q == x_q;
      equal_790_s1_q <= run_lowest_q == x;
      equal_854_s1_q <= run_highest_q == x;
      equal_877_s1_q <= x_q == {1'b0, last_q};
      equal_880_s1_q <= run_phase_q == 3'h5;
      select_929_s1_q <= select_929;
      not_1022_s1_q <= ~({sum_1020, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1191_s1_q <= equal_1191;
      not_1237_s1_q <= not_1237;
      less_1410_s1_q <= {1'b0, sum_1409, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:365
  logic equal_433;
  assign equal_433 = row_q == 6'h0;
  logic [11:0] select_434;
  assign select_434 = equal_433 ? 12'h0 : left_rdata_q[11:0];
  logic not_435;
  assign not_435 = ~equal_433;
  logic and_436;
  assign and_436 = left_rdata_q[12] & not_435;
  logic and_437;
  assign and_437 = left_rdata_q[13] & not_435;
  logic and_438;
  assign and_438 = left_rdata_q[14] & not_435;
  logic equal_439;
  assign equal_439 = row_q[5:1] == 5'h0;
  logic [11:0] select_440;
  assign select_440 = equal_439 ? 12'h0 : left_rdata_q[26:15];
  logic not_441;
  assign not_441 = ~equal_439;
  logic and_442;
  assign and_442 = left_rdata_q[27] & not_441;
  logic and_443;
  assign and_443 = left_rdata_q[28] & not_441;
  logic and_444;
  assign and_444 = left_rdata_q[29] & not_441;
  logic less_445;
  assign less_445 = row_q < 6'h3;
  logic [11:0] select_446;
  assign select_446 = less_445 ? 12'h0 : left_rdata_q[41:30];
  logic not_447;
  assign not_447 = ~less_445;
  logic and_448;
  assign and_448 = left_rdata_q[42] & not_447;
  logic and_449;
  assign and_449 = left_rdata_q[43] & not_447;
  logic and_450;
  assign and_450 = left_rdata_q[44] & not_447;
  logic equal_451;
  assign equal_451 = row_q[5:2] == 4'h0;
  logic [11:0] select_452;
  assign select_452 = equal_451 ? 12'h0 : left_rdata_q[56:45];
  logic not_453;
  assign not_453 = ~equal_451;
  logic and_454;
  assign and_454 = left_rdata_q[57] & not_453;
  // hls/stages/agreement.hpp:366
  logic [11:0] select_459;
  assign select_459 = equal_433 ? 12'h0 : right_codes_rdata_q[11:0];
  logic and_460;
  assign and_460 = right_codes_rdata_q[12] & not_435;
  logic [11:0] select_461;
  assign select_461 = equal_439 ? 12'h0 : right_codes_rdata_q[24:13];
  logic and_462;
  assign and_462 = right_codes_rdata_q[25] & not_441;
  logic [11:0] select_463;
  assign select_463 = less_445 ? 12'h0 : right_codes_rdata_q[37:26];
  logic and_464;
  assign and_464 = right_codes_rdata_q[38] & not_447;
  logic [11:0] select_465;
  assign select_465 = equal_451 ? 12'h0 : right_codes_rdata_q[50:39];
  logic and_466;
  assign and_466 = right_codes_rdata_q[51] & not_453;
  logic less_467;
  assign less_467 = row_q < 6'h5;
  logic [11:0] select_468;
  assign select_468 = less_467 ? 12'h0 : right_codes_rdata_q[63:52];
  logic and_470;
  assign and_470 = right_codes_rdata_q[64] & (~less_467);
  logic less_471;
  assign less_471 = row_q[5:1] < 5'h3;
  logic [11:0] select_472;
  assign select_472 = less_471 ? 12'h0 : right_codes_rdata_q[76:65];
  logic and_474;
  assign and_474 = right_codes_rdata_q[77] & (~less_471);
  // hls/stages/agreement.hpp:318
  logic not_481;
  assign not_481 = ~equal_341_s1_q;
  // hls/stages/agreement.hpp:298
  logic and_482;
  assign and_482 = not_481 & and_429_s1_q;
  logic select_483;
  assign select_483 = equal_339_s1_q ? and_480_s1_q : and_482;
  // hls/stages/agreement.hpp:159
  logic and_492;
  assign and_492 = left_rdata_q[42] & not_343_s1_q;
  logic [11:0] a;
  assign a = less_342_s1_q ? 12'h0 : left_rdata_q[41:30];
  logic [11:0] b;
  assign b = less_342_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_498;
  assign not_498 = ~(a ^ b);
  logic [1:0] sum_500;
  assign sum_500 = {1'b0, not_498[2]} + ({1'b0, not_498[0]} + {1'b0, not_498[1]});
  logic [2:0] sum_503;
  assign sum_503 = {2'h0, not_498[5]} + ({2'h0, not_498[4]} + ({2'h0, not_498[3]} + {1'b0, sum_500}));
  logic [2:0] sum_504;
  assign sum_504 = {2'h0, not_498[6]} + sum_503;
  logic [3:0] sum_507;
  assign sum_507 = {3'h0, not_498[9]} + ({3'h0, not_498[8]} + ({3'h0, not_498[7]} + {1'b0, sum_504}));
  // hls/stages/agreement.hpp:159
  logic [11:0] a_2;
  assign a_2 = less_342_s1_q ? 12'h0 : left_rdata_q[56:45];
  logic [11:0] b_2;
  assign b_2 = less_342_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_517;
  assign not_517 = ~(a_2 ^ b_2);
  logic [1:0] sum_519;
  assign sum_519 = {1'b0, not_517[2]} + ({1'b0, not_517[0]} + {1'b0, not_517[1]});
  logic [2:0] sum_522;
  assign sum_522 = {2'h0, not_517[5]} + ({2'h0, not_517[4]} + ({2'h0, not_517[3]} + {1'b0, sum_519}));
  logic [2:0] sum_523;
  assign sum_523 = {2'h0, not_517[6]} + sum_522;
  logic [3:0] sum_526;
  assign sum_526 = {3'h0, not_517[9]} + ({3'h0, not_517[8]} + ({3'h0, not_517[7]} + {1'b0, sum_523}));
  // hls/stages/agreement.hpp:159
  logic and_531;
  assign and_531 = left_rdata_q[72] & not_343_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_342_s1_q ? 12'h0 : left_rdata_q[71:60];
  logic [11:0] b_3;
  assign b_3 = less_342_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_537;
  assign not_537 = ~(a_3 ^ b_3);
  logic [1:0] sum_539;
  assign sum_539 = {1'b0, not_537[2]} + ({1'b0, not_537[0]} + {1'b0, not_537[1]});
  logic [2:0] sum_542;
  assign sum_542 = {2'h0, not_537[5]} + ({2'h0, not_537[4]} + ({2'h0, not_537[3]} + {1'b0, sum_539}));
  logic [2:0] sum_543;
  assign sum_543 = {2'h0, not_537[6]} + sum_542;
  logic [3:0] sum_546;
  assign sum_546 = {3'h0, not_537[9]} + ({3'h0, not_537[8]} + ({3'h0, not_537[7]} + {1'b0, sum_543}));
  logic [11:0] not_558;
  assign not_558 = ~(a ^ b_2);
  logic [1:0] sum_560;
  assign sum_560 = {1'b0, not_558[2]} + ({1'b0, not_558[0]} + {1'b0, not_558[1]});
  logic [2:0] sum_563;
  assign sum_563 = {2'h0, not_558[5]} + ({2'h0, not_558[4]} + ({2'h0, not_558[3]} + {1'b0, sum_560}));
  logic [2:0] sum_564;
  assign sum_564 = {2'h0, not_558[6]} + sum_563;
  logic [3:0] sum_567;
  assign sum_567 = {3'h0, not_558[9]} + ({3'h0, not_558[8]} + ({3'h0, not_558[7]} + {1'b0, sum_564}));
  logic [11:0] not_573;
  assign not_573 = ~(a_2 ^ b_3);
  logic [1:0] sum_575;
  assign sum_575 = {1'b0, not_573[2]} + ({1'b0, not_573[0]} + {1'b0, not_573[1]});
  logic [2:0] sum_578;
  assign sum_578 = {2'h0, not_573[5]} + ({2'h0, not_573[4]} + ({2'h0, not_573[3]} + {1'b0, sum_575}));
  logic [2:0] sum_579;
  assign sum_579 = {2'h0, not_573[6]} + sum_578;
  logic [3:0] sum_582;
  assign sum_582 = {3'h0, not_573[9]} + ({3'h0, not_573[8]} + ({3'h0, not_573[7]} + {1'b0, sum_579}));
  // hls/stages/agreement.hpp:159
  logic [11:0] b_4;
  assign b_4 = less_342_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_591;
  assign not_591 = ~(a_3 ^ b_4);
  logic [1:0] sum_593;
  assign sum_593 = {1'b0, not_591[2]} + ({1'b0, not_591[0]} + {1'b0, not_591[1]});
  logic [2:0] sum_596;
  assign sum_596 = {2'h0, not_591[5]} + ({2'h0, not_591[4]} + ({2'h0, not_591[3]} + {1'b0, sum_593}));
  logic [2:0] sum_597;
  assign sum_597 = {2'h0, not_591[6]} + sum_596;
  logic [3:0] sum_600;
  assign sum_600 = {3'h0, not_591[9]} + ({3'h0, not_591[8]} + ({3'h0, not_591[7]} + {1'b0, sum_597}));
  // hls/stages/agreement.hpp:159
  logic [11:0] b_5;
  assign b_5 = less_342_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_615;
  assign not_615 = ~(a ^ b_5);
  logic [1:0] sum_617;
  assign sum_617 = {1'b0, not_615[2]} + ({1'b0, not_615[0]} + {1'b0, not_615[1]});
  logic [2:0] sum_620;
  assign sum_620 = {2'h0, not_615[5]} + ({2'h0, not_615[4]} + ({2'h0, not_615[3]} + {1'b0, sum_617}));
  logic [2:0] sum_621;
  assign sum_621 = {2'h0, not_615[6]} + sum_620;
  logic [3:0] sum_624;
  assign sum_624 = {3'h0, not_615[9]} + ({3'h0, not_615[8]} + ({3'h0, not_615[7]} + {1'b0, sum_621}));
  logic [11:0] not_630;
  assign not_630 = ~(a_2 ^ b);
  logic [1:0] sum_632;
  assign sum_632 = {1'b0, not_630[2]} + ({1'b0, not_630[0]} + {1'b0, not_630[1]});
  logic [2:0] sum_635;
  assign sum_635 = {2'h0, not_630[5]} + ({2'h0, not_630[4]} + ({2'h0, not_630[3]} + {1'b0, sum_632}));
  logic [2:0] sum_636;
  assign sum_636 = {2'h0, not_630[6]} + sum_635;
  logic [3:0] sum_639;
  assign sum_639 = {3'h0, not_630[9]} + ({3'h0, not_630[8]} + ({3'h0, not_630[7]} + {1'b0, sum_636}));
  logic [11:0] not_646;
  assign not_646 = ~(a_3 ^ b_2);
  logic [1:0] sum_648;
  assign sum_648 = {1'b0, not_646[2]} + ({1'b0, not_646[0]} + {1'b0, not_646[1]});
  logic [2:0] sum_651;
  assign sum_651 = {2'h0, not_646[5]} + ({2'h0, not_646[4]} + ({2'h0, not_646[3]} + {1'b0, sum_648}));
  logic [2:0] sum_652;
  assign sum_652 = {2'h0, not_646[6]} + sum_651;
  logic [3:0] sum_655;
  assign sum_655 = {3'h0, not_646[9]} + ({3'h0, not_646[8]} + ({3'h0, not_646[7]} + {1'b0, sum_652}));
  logic [11:0] not_670;
  assign not_670 = ~(a ^ b_3);
  logic [1:0] sum_672;
  assign sum_672 = {1'b0, not_670[2]} + ({1'b0, not_670[0]} + {1'b0, not_670[1]});
  logic [2:0] sum_675;
  assign sum_675 = {2'h0, not_670[5]} + ({2'h0, not_670[4]} + ({2'h0, not_670[3]} + {1'b0, sum_672}));
  logic [2:0] sum_676;
  assign sum_676 = {2'h0, not_670[6]} + sum_675;
  logic [3:0] sum_679;
  assign sum_679 = {3'h0, not_670[9]} + ({3'h0, not_670[8]} + ({3'h0, not_670[7]} + {1'b0, sum_676}));
  logic [11:0] not_685;
  assign not_685 = ~(a_2 ^ b_4);
  logic [1:0] sum_687;
  assign sum_687 = {1'b0, not_685[2]} + ({1'b0, not_685[0]} + {1'b0, not_685[1]});
  logic [2:0] sum_690;
  assign sum_690 = {2'h0, not_685[5]} + ({2'h0, not_685[4]} + ({2'h0, not_685[3]} + {1'b0, sum_687}));
  logic [2:0] sum_691;
  assign sum_691 = {2'h0, not_685[6]} + sum_690;
  logic [3:0] sum_694;
  assign sum_694 = {3'h0, not_685[9]} + ({3'h0, not_685[8]} + ({3'h0, not_685[7]} + {1'b0, sum_691}));
  // hls/stages/agreement.hpp:159
  logic [11:0] b_6;
  assign b_6 = less_342_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_703;
  assign not_703 = ~(a_3 ^ b_6);
  logic [1:0] sum_705;
  assign sum_705 = {1'b0, not_703[2]} + ({1'b0, not_703[0]} + {1'b0, not_703[1]});
  logic [2:0] sum_708;
  assign sum_708 = {2'h0, not_703[5]} + ({2'h0, not_703[4]} + ({2'h0, not_703[3]} + {1'b0, sum_705}));
  logic [2:0] sum_709;
  assign sum_709 = {2'h0, not_703[6]} + sum_708;
  logic [3:0] sum_712;
  assign sum_712 = {3'h0, not_703[9]} + ({3'h0, not_703[8]} + ({3'h0, not_703[7]} + {1'b0, sum_709}));
  // hls/stages/agreement.hpp:159
  logic [11:0] b_7;
  assign b_7 = less_342_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_732;
  assign not_732 = ~(a ^ b_7);
  logic [1:0] sum_734;
  assign sum_734 = {1'b0, not_732[2]} + ({1'b0, not_732[0]} + {1'b0, not_732[1]});
  logic [2:0] sum_737;
  assign sum_737 = {2'h0, not_732[5]} + ({2'h0, not_732[4]} + ({2'h0, not_732[3]} + {1'b0, sum_734}));
  logic [2:0] sum_738;
  assign sum_738 = {2'h0, not_732[6]} + sum_737;
  logic [3:0] sum_741;
  assign sum_741 = {3'h0, not_732[9]} + ({3'h0, not_732[8]} + ({3'h0, not_732[7]} + {1'b0, sum_738}));
  logic [11:0] not_747;
  assign not_747 = ~(a_2 ^ b_5);
  logic [1:0] sum_749;
  assign sum_749 = {1'b0, not_747[2]} + ({1'b0, not_747[0]} + {1'b0, not_747[1]});
  logic [2:0] sum_752;
  assign sum_752 = {2'h0, not_747[5]} + ({2'h0, not_747[4]} + ({2'h0, not_747[3]} + {1'b0, sum_749}));
  logic [2:0] sum_753;
  assign sum_753 = {2'h0, not_747[6]} + sum_752;
  logic [3:0] sum_756;
  assign sum_756 = {3'h0, not_747[9]} + ({3'h0, not_747[8]} + ({3'h0, not_747[7]} + {1'b0, sum_753}));
  logic [11:0] not_763;
  assign not_763 = ~(a_3 ^ b);
  logic [1:0] sum_765;
  assign sum_765 = {1'b0, not_763[2]} + ({1'b0, not_763[0]} + {1'b0, not_763[1]});
  logic [2:0] sum_768;
  assign sum_768 = {2'h0, not_763[5]} + ({2'h0, not_763[4]} + ({2'h0, not_763[3]} + {1'b0, sum_765}));
  logic [2:0] sum_769;
  assign sum_769 = {2'h0, not_763[6]} + sum_768;
  logic [3:0] sum_772;
  assign sum_772 = {3'h0, not_763[9]} + ({3'h0, not_763[8]} + ({3'h0, not_763[7]} + {1'b0, sum_769}));
  // hls/stages/agreement.hpp:573
  logic not_889;
  assign not_889 = ~(row_q[5:3] == 3'h0);
  // hls/stages/agreement.hpp:298
  logic and_1024;
  assign and_1024 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1022_s1_q);
  // hls/stages/agreement.hpp:239
  logic [5:0] or_1139;
  assign or_1139 = select_297_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:243
  logic select_1281;
  assign select_1281 = equal_1191_s1_q ? (~({row_s1_q, 1'b0} < {sum_1278, cfg_height_i[3]})) : lower_half_q;

  // Memory best_left, 80 x 22, DISTANCE 12, hls/stages/agreement.hpp:888; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 22'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = equal_339_s1_q ? x_s1_2_q : x_s1_q[6:0];
  logic best_left_re;
  assign best_left_re = s1_en & select_483;
  logic [21:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s1_q[6:0];
  logic left_we;
  assign left_we = s1_en & and_345_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_454, select_452, and_450, and_449, and_448, select_446, and_444, and_443, and_442, select_440, and_438, and_437, and_436, select_434, fresh_rdata_q[27:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_345_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_474, select_472, and_470, select_468, and_466, select_465, and_464, select_463, and_462, select_461, and_460, select_459, fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_327_s1_q ? (equal_1191_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_327_s1_q ? select_1281 : lower_half_q;
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
  logic select_295_s2_q;
  logic [6:0] select_297_s2_q;
  logic [8:0] select_301_s2_q;
  logic and_308_s2_q;
  logic equal_313_s2_q;
  logic and_326_s2_q;
  logic and_327_s2_q;
  logic equal_330_s2_q;
  logic equal_339_s2_q;
  logic not_340_s2_q;
  logic equal_341_s2_q;
  logic less_342_s2_q;
  logic not_343_s2_q;
  logic equal_373_s2_q;
  logic drew_s2_q;
  logic [6:0] x_s2_2_q;
  logic not_481_s2_q;
  logic select_483_s2_q;
  logic equal_486_s2_q;
  logic and_492_s2_q;
  logic and_493_s2_q;
  logic not_498_s2_q;
  logic [3:0] sum_508_s2_q;
  logic and_511_s2_q;
  logic and_512_s2_q;
  logic not_517_s2_q;
  logic [3:0] sum_527_s2_q;
  logic and_531_s2_q;
  logic and_532_s2_q;
  logic not_537_s2_q;
  logic [3:0] sum_547_s2_q;
  logic equal_553_s2_q;
  logic not_558_s2_q;
  logic [3:0] sum_568_s2_q;
  logic not_573_s2_q;
  logic [3:0] sum_583_s2_q;
  logic and_587_s2_q;
  logic not_591_s2_q;
  logic [3:0] sum_601_s2_q;
  logic and_611_s2_q;
  logic not_615_s2_q;
  logic [3:0] sum_625_s2_q;
  logic not_630_s2_q;
  logic [3:0] sum_640_s2_q;
  logic not_646_s2_q;
  logic [3:0] sum_656_s2_q;
  logic not_670_s2_q;
  logic [3:0] sum_680_s2_q;
  logic not_685_s2_q;
  logic [3:0] sum_695_s2_q;
  logic and_700_s2_q;
  logic not_703_s2_q;
  logic [3:0] sum_713_s2_q;
  logic and_729_s2_q;
  logic not_732_s2_q;
  logic [3:0] sum_742_s2_q;
  logic not_747_s2_q;
  logic [3:0] sum_757_s2_q;
  logic not_763_s2_q;
  logic [3:0] sum_773_s2_q;
  logic equal_790_s2_q;
  logic and_848_s2_q;
  logic equal_854_s2_q;
  logic equal_877_s2_q;
  logic equal_880_s2_q;
  logic and_891_s2_q;
  logic and_921_s2_q;
  logic select_929_s2_q;
  logic and_1026_s2_q;
  logic equal_1140_s2_q;
  logic equal_1191_s2_q;
  logic not_1237_s2_q;
  logic and_1325_s2_q;
  logic less_1407_s2_q;
  logic less_1410_s2_q;
  logic equal_1675_s2_q;
  logic less_1684_s2_q;
  logic equal_1843_s2_q;
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
      select_295_s2_q <= select_295_s1_q;
      select_297_s2_q <= select_297_s1_q;
      select_301_s2_q <= averager_place_q;
      and_308_s2_q <= and_308_s1_q;
      equal_313_s2_q <= equal_313_s1_q;
      and_326_s2_q <= and_326_s1_q;
      and_327_s2_q <= and_327_s1_q;
      equal_330_s2_q <= equal_330_s1_q;
      equal_339_s2_q <= equal_339_s1_q;
      not_340_s2_q <= not_340_s1_q;
      equal_341_s2_q <= equal_341_s1_q;
      less_342_s2_q <= less_342_s1_q;
      not_343_s2_q <= not_343_s1_q;
      equal_373_s2_q <= row_s1_q == 6'h0;
      drew_s2_q <= drew_s1_q;
      x_s2_2_q <= x_s1_2_q;
      not_481_s2_q <= not_481;
      select_483_s2_q <= select_483;
      equal_486_s2_q <= equal_486_s1_q;
      and_492_s2_q <= and_492;
      and_493_s2_q <= right_codes_rdata_q[38] & not_343_s1_q;
      not_498_s2_q <= not_498[11];
      sum_508_s2_q <= {3'h0, not_498[10]} + sum_507;
      and_511_s2_q <= left_rdata_q[57] & not_343_s1_q;
      and_512_s2_q <= right_codes_rdata_q[51] & not_343_s1_q;
      not_517_s2_q <= not_517[11];
      sum_527_s2_q <= {3'h0, not_517[10]} + sum_526;
      and_531_s2_q <= and_531;
      and_532_s2_q <= right_codes_rdata_q[64] & not_343_s1_q;
      not_537_s2_q <= not_537[11];
      sum_547_s2_q <= {3'h0, not_537[10]} + sum_546;
      equal_553_s2_q <= equal_553_s1_q;
      not_558_s2_q <= not_558[11];
      sum_568_s2_q <= {3'h0, not_558[10]} + sum_567;
      not_573_s2_q <= not_573[11];
      sum_583_s2_q <= {3'h0, not_573[10]} + sum_582;
      and_587_s2_q <= right_codes_rdata_q[77] & not_343_s1_q;
      not_591_s2_q <= not_591[11];
      sum_601_s2_q <= {3'h0, not_591[10]} + sum_600;
      and_611_s2_q <= right_codes_rdata_q[25] & not_343_s1_q;
      not_615_s2_q <= not_615[11];
      sum_625_s2_q <= {3'h0, not_615[10]} + sum_624;
      not_630_s2_q <= not_630[11];
      sum_640_s2_q <= {3'h0, not_630[10]} + sum_639;
      not_646_s2_q <= not_646[11];
      sum_656_s2_q <= {3'h0, not_646[10]} + sum_655;
      not_670_s2_q <= not_670[11];
      sum_680_s2_q <= {3'h0, not_670[10]} + sum_679;
      not_685_s2_q <= not_685[11];
      sum_695_s2_q <= {3'h0, not_685[10]} + sum_694;
      and_700_s2_q <= and_531 & (right_codes_rdata_q[90] & not_343_s1_q);
      not_703_s2_q <= not_703[11];
      sum_713_s2_q <= {3'h0, not_703[10]} + sum_712;
      and_729_s2_q <= and_492 & (right_codes_rdata_q[12] & not_343_s1_q);
      not_732_s2_q <= not_732[11];
      sum_742_s2_q <= {3'h0, not_732[10]} + sum_741;
      not_747_s2_q <= not_747[11];
      sum_757_s2_q <= {3'h0, not_747[10]} + sum_756;
      not_763_s2_q <= not_763[11];
      sum_773_s2_q <= {3'h0, not_763[10]} + sum_772;
      equal_790_s2_q <= equal_790_s1_q;
      and_848_s2_q <= equal_339_s1_q & and_480_s1_q;
      equal_854_s2_q <= equal_854_s1_q;
      equal_877_s2_q <= equal_877_s1_q;
      equal_880_s2_q <= equal_880_s1_q;
      and_891_s2_q <= left_rdata_q[58] & (left_rdata_q[59] & not_889);
      and_921_s2_q <= not_340_s1_q & and_482;
      select_929_s2_q <= select_929_s1_q;
      and_1026_s2_q <= not_340_s1_q & (not_481 & and_1024);
      equal_1140_s2_q <= {select_297_s1_q[6], or_1139} == 7'h0;
      equal_1191_s2_q <= equal_1191_s1_q;
      not_1237_s2_q <= not_1237_s1_q;
      and_1325_s2_q <= left_rdata_q[58] & not_889;
      less_1407_s2_q <= 5'h4 < row_q[5:1];
      less_1410_s2_q <= less_1410_s1_q;
      equal_1675_s2_q <= row_s1_q[5:2] == 4'h0;
      less_1684_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_1843_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic averager_running_mask_q;
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
  logic [23:0] slope_row_q;
  logic [27:0] slope_change_q;
  logic [27:0] slope_q;
  logic [23:0] next_slope_row_q;
  logic [27:0] next_slope_change_q;
  logic began_q;
  logic [2:0] seen_x_q;
  logic [2:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/census.hpp:90
  logic [11:0] select_311;
  assign select_311 = select_295_s2_q ? ({4'h0, pixel_0_s2_q} + averager_running_0_q) : {4'h0, pixel_0_s2_q};
  logic [11:0] sum_317;
  assign sum_317 = {4'h0, pixel_1_s2_q} + (select_295_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/agreement.hpp:171
  logic whole;
  assign whole = select_295_s2_q ? (mask_s2_q & averager_running_mask_q) : mask_s2_q;
  // hls/stages/agreement.hpp:375
  logic [3:0] column;
  assign column = (and_492_s2_q & and_493_s2_q) ? ({3'h0, not_498_s2_q} + sum_508_s2_q) : 4'h0;
  logic [3:0] select_529;
  assign select_529 = (and_511_s2_q & and_512_s2_q) ? ({3'h0, not_517_s2_q} + sum_527_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_2;
  assign column_2 = {1'b0, column} + {1'b0, select_529};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_549;
  assign select_549 = (and_531_s2_q & and_532_s2_q) ? ({3'h0, not_537_s2_q} + sum_547_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_3;
  assign column_3 = {1'b0, column_2} + {2'h0, select_549};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_552;
  assign difference_552 = {2'h0, column_3} - (age_s2_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_555;
  assign sum_555 = difference_552 + (equal_553_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:375
  logic [3:0] column_4;
  assign column_4 = (and_492_s2_q & and_512_s2_q) ? ({3'h0, not_558_s2_q} + sum_568_s2_q) : 4'h0;
  logic [3:0] select_585;
  assign select_585 = (and_511_s2_q & and_532_s2_q) ? ({3'h0, not_573_s2_q} + sum_583_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_5;
  assign column_5 = {1'b0, column_4} + {1'b0, select_585};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_603;
  assign select_603 = (and_531_s2_q & and_587_s2_q) ? ({3'h0, not_591_s2_q} + sum_601_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_6;
  assign column_6 = {1'b0, column_5} + {2'h0, select_603};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_606;
  assign difference_606 = {2'h0, column_6} - (age_s2_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_608;
  assign sum_608 = difference_606 + (equal_553_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:418
  logic less_609;
  assign less_609 = sum_555 < sum_608;
  // hls/stages/agreement.hpp:375
  logic [3:0] column_7;
  assign column_7 = (and_492_s2_q & and_611_s2_q) ? ({3'h0, not_615_s2_q} + sum_625_s2_q) : 4'h0;
  logic [3:0] select_642;
  assign select_642 = (and_511_s2_q & and_493_s2_q) ? ({3'h0, not_630_s2_q} + sum_640_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_8;
  assign column_8 = {1'b0, column_7} + {1'b0, select_642};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_658;
  assign select_658 = (and_531_s2_q & and_512_s2_q) ? ({3'h0, not_646_s2_q} + sum_656_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_9;
  assign column_9 = {1'b0, column_8} + {2'h0, select_658};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_661;
  assign difference_661 = {2'h0, column_9} - (age_s2_q[1] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_663;
  assign sum_663 = difference_661 + (equal_553_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:418
  logic not_665;
  assign not_665 = ~less_609;
  logic [1:0] best;
  assign best = ((less_609 ? sum_608 : sum_555) < sum_663) ? 2'h3 : {not_665, less_609};
  // hls/stages/agreement.hpp:375
  logic [3:0] column_10;
  assign column_10 = (and_492_s2_q & and_532_s2_q) ? ({3'h0, not_670_s2_q} + sum_680_s2_q) : 4'h0;
  logic [3:0] select_697;
  assign select_697 = (and_511_s2_q & and_587_s2_q) ? ({3'h0, not_685_s2_q} + sum_695_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_11;
  assign column_11 = {1'b0, column_10} + {1'b0, select_697};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_715;
  assign select_715 = and_700_s2_q ? ({3'h0, not_703_s2_q} + sum_713_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_12;
  assign column_12 = {1'b0, column_11} + {2'h0, select_715};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_718;
  assign difference_718 = {2'h0, column_12} - (age_s2_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_720;
  assign sum_720 = difference_718 + (equal_553_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:418
  logic [7:0] select_722;
  assign select_722 = best[1] ? (best[0] ? sum_663 : sum_555) : (best[0] ? sum_608 : sum_720);
  logic [1:0] best_2;
  assign best_2 = (select_722 < sum_720) ? 2'h0 : best;
  // hls/stages/agreement.hpp:375
  logic [3:0] column_13;
  assign column_13 = and_729_s2_q ? ({3'h0, not_732_s2_q} + sum_742_s2_q) : 4'h0;
  logic [3:0] select_759;
  assign select_759 = (and_511_s2_q & and_611_s2_q) ? ({3'h0, not_747_s2_q} + sum_757_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_14;
  assign column_14 = {1'b0, column_13} + {1'b0, select_759};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_775;
  assign select_775 = (and_531_s2_q & and_493_s2_q) ? ({3'h0, not_763_s2_q} + sum_773_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_15;
  assign column_15 = {1'b0, column_14} + {2'h0, select_775};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_778;
  assign difference_778 = {2'h0, column_15} - (age_s2_q[1] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_780;
  assign sum_780 = difference_778 + (equal_553_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:430
  logic [6:0] partner;
  assign partner = {run_shift_s2_q[5], run_shift_s2_q} + x_s2_2_q;
  // hls/stages/agreement.hpp:298
  logic [6:0] select_851;
  assign select_851 = equal_339_s2_q ? partner : (x_s2_q[6:0] + {best_left_rdata_q[13], best_left_rdata_q[13:8]});
  // hls/stages/agreement.hpp:173
  logic next_row;
  assign next_row = select_929_s2_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:834
  logic [6:0] select_932;
  assign select_932 = next_row ? cfg_width_i[9:3] : 7'h0;
  // hls/stages/agreement.hpp:844
  logic equal_935;
  assign equal_935 = seen_x_q == 3'h7;
  // hls/stages/census.hpp:31
  logic not_942;
  assign not_942 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1284;
  assign select_1284 = equal_339_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1285;
  assign select_1285 = equal_339_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1286;
  assign select_1286 = equal_339_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1287;
  assign select_1287 = equal_339_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1288;
  assign select_1288 = equal_339_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1289;
  assign select_1289 = equal_339_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1292;
  assign select_1292 = equal_339_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1293;
  assign select_1293 = equal_339_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1294;
  assign select_1294 = equal_339_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1295;
  assign select_1295 = equal_339_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1296;
  assign select_1296 = equal_339_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1297;
  assign select_1297 = equal_339_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1300;
  assign select_1300 = equal_339_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1301;
  assign select_1301 = equal_339_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1302;
  assign select_1302 = equal_339_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1303;
  assign select_1303 = equal_339_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1304;
  assign select_1304 = equal_339_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1305;
  assign select_1305 = equal_339_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1308;
  assign select_1308 = equal_339_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1309;
  assign select_1309 = equal_339_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1310;
  assign select_1310 = equal_339_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1311;
  assign select_1311 = equal_339_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1312;
  assign select_1312 = equal_339_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1313;
  assign select_1313 = equal_339_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1316;
  assign select_1316 = equal_339_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1317;
  assign select_1317 = equal_339_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1318;
  assign select_1318 = equal_339_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1319;
  assign select_1319 = equal_339_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1320;
  assign select_1320 = equal_339_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1321;
  assign select_1321 = equal_339_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/agreement.hpp:637
  logic [16:0] select_1415;
  assign select_1415 = ($signed(slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : slope_change_q[27:11];
  logic [13:0] select_1417;
  assign select_1417 = ($signed(10'h0) < $signed(select_1415[16:7])) ? 14'h7f : select_1415[13:0];
  // hls/stages/agreement.hpp:632
  logic [9:0] select_1418;
  assign select_1418 = best_left_rdata_q[12] ? select_1417[9:0] : 10'h0;
  logic [8:0] difference_1420;
  assign difference_1420 = select_1418[9:1] - (best_left_rdata_q[13] ? select_1417[8:0] : 9'h0);
  // hls/stages/agreement.hpp:630
  logic [12:0] sum_1423;
  assign sum_1423 = (best_left_rdata_q[8] ? select_1417[13:1] : 13'h0) + (best_left_rdata_q[9] ? select_1417[12:0] : 13'h0);
  // hls/stages/agreement.hpp:631
  logic [11:0] select_1424;
  assign select_1424 = best_left_rdata_q[10] ? select_1417[11:0] : 12'h0;
  logic [10:0] sum_1426;
  assign sum_1426 = select_1424[11:1] + (best_left_rdata_q[11] ? select_1417[10:0] : 11'h0);
  // hls/stages/agreement.hpp:633
  logic [11:0] sum_1427;
  assign sum_1427 = sum_1423[12:1] + {sum_1426, select_1424[0]};
  logic [9:0] sum_1428;
  assign sum_1428 = {difference_1420, select_1418[0]} + sum_1427[11:2];
  // hls/stages/agreement.hpp:605
  logic [12:0] sum_1429;
  assign sum_1429 = {slope_q[27], slope_q[27:16]} + {{5{sum_1428[9]}}, sum_1428[9:2]};
  // hls/stages/agreement.hpp:630
  logic [7:0] select_1432;
  assign select_1432 = ($signed(sum_1429[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1429[7:0];
  logic [7:0] slope;
  assign slope = ($signed(6'h0) < $signed(sum_1429[12:7])) ? 8'h7f : select_1432;
  logic [6:0] select_1434;
  assign select_1434 = best_left_rdata_q[8] ? slope[7:1] : 7'h0;
  logic [7:0] select_1435;
  assign select_1435 = best_left_rdata_q[9] ? slope : 8'h0;
  logic [8:0] sum_1436;
  assign sum_1436 = {{2{select_1434[6]}}, select_1434} + {select_1435[7], select_1435};
  // hls/stages/agreement.hpp:631
  logic [7:0] select_1437;
  assign select_1437 = best_left_rdata_q[10] ? slope : 8'h0;
  logic [7:0] select_1438;
  assign select_1438 = best_left_rdata_q[11] ? slope : 8'h0;
  logic [8:0] sum_1439;
  assign sum_1439 = {{2{select_1437[7]}}, select_1437[7:1]} + {select_1438[7], select_1438};
  // hls/stages/agreement.hpp:633
  logic [10:0] sum_1440;
  assign sum_1440 = {{3{sum_1436[8]}}, sum_1436[8:1]} + {sum_1439[8], sum_1439, select_1437[0]};
  // hls/stages/agreement.hpp:632
  logic [7:0] select_1441;
  assign select_1441 = best_left_rdata_q[12] ? slope : 8'h0;
  logic [7:0] select_1442;
  assign select_1442 = best_left_rdata_q[13] ? slope : 8'h0;
  logic [8:0] difference_1443;
  assign difference_1443 = {{2{select_1441[7]}}, select_1441[7:1]} - {select_1442[7], select_1442};
  // hls/stages/agreement.hpp:256
  logic [23:0] select_1676;
  assign select_1676 = equal_1675_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : next_slope_row_q;
  // hls/stages/agreement.hpp:173
  logic [23:0] select_1678;
  assign select_1678 = and_327_s2_q ? (equal_1191_s2_q ? select_1676 : slope_row_q) : slope_row_q;
  // hls/stages/agreement.hpp:257
  logic [27:0] select_1679;
  assign select_1679 = equal_1675_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : next_slope_change_q;
  // hls/stages/agreement.hpp:173
  logic [27:0] select_1681;
  assign select_1681 = and_327_s2_q ? (equal_1191_s2_q ? select_1679 : slope_change_q) : slope_change_q;
  // hls/stages/agreement.hpp:137
  logic [23:0] sum_1764;
  assign sum_1764 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + slope_row_q;
  // hls/stages/agreement.hpp:138
  logic [27:0] sum_1765;
  assign sum_1765 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + slope_change_q;
  // hls/stages/agreement.hpp:843
  logic [2:0] select_1863;
  assign select_1863 = select_929_s2_q ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1869;
  assign select_1869 = marks_first_s2_q ? (less_1865 ? {sum_1866, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory averager_memory, 320 x 25, DISTANCE 16, hls/stages/census.hpp:139; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [24:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 25'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_301_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_308_s2_q;
  logic [24:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 80 x 76, DISTANCE 16, hls/stages/census.hpp:244; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [75:0] census_memory_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) census_memory_mem[i] = 76'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = select_297_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_327_s2_q;
  logic [75:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory best_right, 80 x 15, DISTANCE 12, hls/stages/agreement.hpp:889; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 15'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = select_851;
  logic best_right_re;
  assign best_right_re = s2_en & select_483_s2_q;
  logic [14:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory seen_columns, 80 x 12, DISTANCE 12, hls/stages/agreement.hpp:918; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [11:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 12'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_921_s2_q;
  logic [11:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_running_mask_q <= 1'b0;
      slope_row_q <= 24'h0;
      slope_change_q <= 28'h0;
      slope_q <= 28'h0;
      next_slope_row_q <= 24'h0;
      next_slope_change_q <= 28'h0;
      began_q <= 1'b0;
      seen_x_q <= 3'h0;
      seen_y_q <= 3'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 13'h0;
    end else if (s2_en) begin
      averager_running_mask_q <= whole;
      slope_row_q <= select_1678;
      slope_change_q <= select_1681;
      slope_q <= drew_s2_q ? (slope_change_q + slope_q) : {slope_row_q, 4'h0};
      next_slope_row_q <= sum_1764;
      next_slope_change_q <= sum_1765;
      began_q <= not_942 & (began_q | select_929_s2_q);
      seen_x_q <= select_929_s2_q ? 3'h0 : (seen_x_q + 3'h1);
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_1863;
      seen_column_q <= select_929_s2_q ? 8'h0 : (seen_column_q + {7'h0, equal_935});
      seen_rows_left_q <= select_1869;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_932});
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
      averager_running_0_q <= select_311;
      averager_running_1_q <= sum_317;
      sums_0_columns_values_0_q <= equal_339_s2_q ? {2'h0, column_12} : sums_0_columns_values_0_q;
      sums_0_columns_values_1_q <= select_1284;
      sums_0_columns_values_2_q <= select_1285;
      sums_0_columns_values_3_q <= select_1286;
      sums_0_columns_values_4_q <= select_1287;
      sums_0_columns_values_5_q <= select_1288;
      sums_0_columns_values_6_q <= select_1289;
      sums_0_sum_sums_values_0_q <= equal_339_s2_q ? sum_720 : sums_0_sum_sums_values_0_q;
      sums_1_columns_values_0_q <= equal_339_s2_q ? {2'h0, column_6} : sums_1_columns_values_0_q;
      sums_1_columns_values_1_q <= select_1292;
      sums_1_columns_values_2_q <= select_1293;
      sums_1_columns_values_3_q <= select_1294;
      sums_1_columns_values_4_q <= select_1295;
      sums_1_columns_values_5_q <= select_1296;
      sums_1_columns_values_6_q <= select_1297;
      sums_1_sum_sums_values_0_q <= equal_339_s2_q ? sum_608 : sums_1_sum_sums_values_0_q;
      sums_2_columns_values_0_q <= equal_339_s2_q ? {2'h0, column_3} : sums_2_columns_values_0_q;
      sums_2_columns_values_1_q <= select_1300;
      sums_2_columns_values_2_q <= select_1301;
      sums_2_columns_values_3_q <= select_1302;
      sums_2_columns_values_4_q <= select_1303;
      sums_2_columns_values_5_q <= select_1304;
      sums_2_columns_values_6_q <= select_1305;
      sums_2_sum_sums_values_0_q <= equal_339_s2_q ? sum_555 : sums_2_sum_sums_values_0_q;
      sums_3_columns_values_0_q <= equal_339_s2_q ? {2'h0, column_9} : sums_3_columns_values_0_q;
      sums_3_columns_values_1_q <= select_1308;
      sums_3_columns_values_2_q <= select_1309;
      sums_3_columns_values_3_q <= select_1310;
      sums_3_columns_values_4_q <= select_1311;
      sums_3_columns_values_5_q <= select_1312;
      sums_3_columns_values_6_q <= select_1313;
      sums_3_sum_sums_values_0_q <= equal_339_s2_q ? sum_663 : sums_3_sum_sums_values_0_q;
      sums_4_columns_values_0_q <= equal_339_s2_q ? {2'h0, column_15} : sums_4_columns_values_0_q;
      sums_4_columns_values_1_q <= select_1316;
      sums_4_columns_values_2_q <= select_1317;
      sums_4_columns_values_3_q <= select_1318;
      sums_4_columns_values_4_q <= select_1319;
      sums_4_columns_values_5_q <= select_1320;
      sums_4_columns_values_6_q <= select_1321;
      sums_4_sum_sums_values_0_q <= equal_339_s2_q ? sum_780 : sums_4_sum_sums_values_0_q;
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
  logic [6:0] select_297_s3_q;
  logic [8:0] select_301_s3_q;
  logic and_308_s3_q;
  logic equal_313_s3_q;
  logic and_326_s3_q;
  logic and_327_s3_q;
  logic equal_330_s3_q;
  logic equal_339_s3_q;
  logic not_340_s3_q;
  logic equal_341_s3_q;
  logic less_342_s3_q;
  logic not_343_s3_q;
  logic equal_373_s3_q;
  logic drew_s3_q;
  logic [6:0] x_s3_2_q;
  logic not_481_s3_q;
  logic [21:0] best_left_rdata_s3_q;
  logic equal_486_s3_q;
  logic [7:0] sum_555_s3_q;
  logic [7:0] sum_608_s3_q;
  logic [7:0] sum_663_s3_q;
  logic [7:0] sum_720_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_780_s3_q;
  logic equal_790_s3_q;
  logic and_848_s3_q;
  logic [6:0] partner_s3_q;
  logic equal_854_s3_q;
  logic equal_877_s3_q;
  logic equal_880_s3_q;
  logic and_891_s3_q;
  logic and_921_s3_q;
  logic not_942_s3_q;
  logic and_1026_s3_q;
  logic equal_1140_s3_q;
  logic equal_1191_s3_q;
  logic not_1237_s3_q;
  logic and_1325_s3_q;
  logic less_1407_s3_q;
  logic less_1410_s3_q;
  logic [9:0] sum_1440_s3_q;
  logic select_1441_s3_q;
  logic [8:0] difference_1443_s3_q;
  logic less_1684_s3_q;
  logic equal_1843_s3_q;
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
      select_297_s3_q <= select_297_s2_q;
      select_301_s3_q <= select_301_s2_q;
      and_308_s3_q <= and_308_s2_q;
      equal_313_s3_q <= equal_313_s2_q;
      and_326_s3_q <= and_326_s2_q;
      and_327_s3_q <= and_327_s2_q;
      equal_330_s3_q <= equal_330_s2_q;
      equal_339_s3_q <= equal_339_s2_q;
      not_340_s3_q <= not_340_s2_q;
      equal_341_s3_q <= equal_341_s2_q;
      less_342_s3_q <= less_342_s2_q;
      not_343_s3_q <= not_343_s2_q;
      equal_373_s3_q <= equal_373_s2_q;
      drew_s3_q <= drew_s2_q;
      x_s3_2_q <= x_s2_2_q;
      not_481_s3_q <= not_481_s2_q;
      best_left_rdata_s3_q <= best_left_rdata_q;
      equal_486_s3_q <= equal_486_s2_q;
      sum_555_s3_q <= sum_555;
      sum_608_s3_q <= sum_608;
      sum_663_s3_q <= sum_663;
      sum_720_s3_q <= sum_720;
      best_2_s3_q <= best_2;
      sum_780_s3_q <= sum_780;
      equal_790_s3_q <= equal_790_s2_q;
      and_848_s3_q <= and_848_s2_q;
      partner_s3_q <= partner;
      equal_854_s3_q <= equal_854_s2_q;
      equal_877_s3_q <= equal_877_s2_q;
      equal_880_s3_q <= equal_880_s2_q;
      and_891_s3_q <= and_891_s2_q;
      and_921_s3_q <= and_921_s2_q;
      not_942_s3_q <= not_942;
      and_1026_s3_q <= and_1026_s2_q;
      equal_1140_s3_q <= equal_1140_s2_q;
      equal_1191_s3_q <= equal_1191_s2_q;
      not_1237_s3_q <= not_1237_s2_q;
      and_1325_s3_q <= and_1325_s2_q;
      less_1407_s3_q <= less_1407_s2_q;
      less_1410_s3_q <= less_1410_s2_q;
      sum_1440_s3_q <= sum_1440[10:1];
      select_1441_s3_q <= select_1441[0];
      difference_1443_s3_q <= difference_1443;
      less_1684_s3_q <= less_1684_s2_q;
      equal_1843_s3_q <= equal_1843_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic [8:0] census_columns_values_0_cell_0_left_q;
  logic [8:0] census_columns_values_0_cell_0_right_q;
  logic census_columns_values_0_cell_0_mask_q;
  logic [8:0] census_columns_values_0_cell_1_left_q;
  logic [8:0] census_columns_values_0_cell_1_right_q;
  logic census_columns_values_0_cell_1_mask_q;
  logic [8:0] census_columns_values_0_cell_2_left_q;
  logic [8:0] census_columns_values_0_cell_2_right_q;
  logic census_columns_values_0_cell_2_mask_q;
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
  logic [11:0] counts_measured_0_q;
  logic [11:0] counts_measured_1_q;
  logic [11:0] counts_measured_2_q;
  logic [11:0] counts_measured_3_q;
  logic [14:0] counts_votes_0_up_q;
  logic [14:0] counts_votes_1_down_q;
  logic [14:0] counts_votes_1_up_q;
  logic [14:0] counts_votes_2_down_q;
  logic [14:0] counts_votes_2_up_q;
  logic [14:0] counts_votes_3_down_q;
  logic [14:0] counts_votes_3_up_q;
  logic [14:0] counts_votes_4_down_q;
  logic [14:0] counts_votes_4_up_q;
  logic [14:0] counts_half_votes_0_down_q;
  logic [14:0] counts_half_votes_0_up_q;
  logic [14:0] counts_half_votes_1_down_q;
  logic [14:0] counts_half_votes_1_up_q;
  logic [14:0] counts_half_votes_2_down_q;
  logic [14:0] counts_half_votes_2_up_q;
  logic [14:0] counts_half_votes_3_down_q;
  logic [14:0] counts_half_votes_3_up_q;
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
  // hls/stages/census.hpp:98
  logic [11:0] sum_315;
  assign sum_315 = averager_running_0_q + (equal_313_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  logic [11:0] sum_319;
  assign sum_319 = averager_running_1_q + (equal_313_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:99
  logic and_323;
  assign and_323 = averager_running_mask_q & (averager_memory_rdata_q[24] | equal_313_s3_q);
  // hls/stages/census.hpp:121
  logic [8:0] grey;
  assign grey = and_308_s3_q ? sum_315[11:3] : 9'h0;
  // hls/stages/census.hpp:122
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_330_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:121
  logic [8:0] grey_2;
  assign grey_2 = and_308_s3_q ? sum_319[11:3] : 9'h0;
  // hls/stages/census.hpp:122
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_330_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:121
  logic and_336;
  assign and_336 = and_308_s3_q & and_323;
  // hls/stages/census.hpp:102
  logic whole_2;
  assign whole_2 = equal_330_s3_q ? and_336 : (averager_mask_q & and_336);
  // hls/stages/census.hpp:206
  logic less_347;
  assign less_347 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_348;
  assign less_348 = census_memory_rdata_q[46:38] < census_columns_values_1_cell_2_left_q;
  logic less_349;
  assign less_349 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_350;
  assign less_350 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_351;
  assign less_351 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_352;
  assign less_352 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_353;
  assign less_353 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_354;
  assign less_354 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_355;
  assign less_355 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_356;
  assign less_356 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_357;
  assign less_357 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_358;
  assign less_358 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:207
  logic less_359;
  assign less_359 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_360;
  assign less_360 = census_memory_rdata_q[55:47] < census_columns_values_1_cell_2_right_q;
  logic less_361;
  assign less_361 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_362;
  assign less_362 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_363;
  assign less_363 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_364;
  assign less_364 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_365;
  assign less_365 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_366;
  assign less_366 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_367;
  assign less_367 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_368;
  assign less_368 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_369;
  assign less_369 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_370;
  assign less_370 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:238
  logic equal_371;
  assign equal_371 = select_297_s3_q == 7'h0;
  logic [3:0] select_374;
  assign select_374 = equal_373_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:239
  logic [4:0] select_375;
  assign select_375 = equal_371 ? {select_374, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:188
  logic [3:0] select_376;
  assign select_376 = equal_371 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:211
  logic and_377;
  assign and_377 = select_375[4] & select_376[3];
  // hls/stages/census.hpp:198
  logic and_379;
  assign and_379 = census_memory_rdata_q[37] & (census_memory_rdata_q[18] & whole_2);
  logic and_381;
  assign and_381 = census_memory_rdata_q[75] & (census_memory_rdata_q[56] & and_379);
  // hls/stages/agreement.hpp:239
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_381;
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
  // hls/stages/census.hpp:182
  logic [9:0] difference_404;
  assign difference_404 = {1'b0, total[10:2]} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_405;
  assign xor_405 = difference_404[8:0] ^ {9{difference_404[9]}};
  logic [9:0] sum_406;
  assign sum_406 = {9'h0, difference_404[9]} + {1'b0, xor_405};
  logic [9:0] difference_407;
  assign difference_407 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_408;
  assign xor_408 = difference_407[8:0] ^ {9{difference_407[9]}};
  logic [9:0] sum_409;
  assign sum_409 = {9'h0, difference_407[9]} + {1'b0, xor_408};
  logic [9:0] difference_411;
  assign difference_411 = {1'b0, census_memory_rdata_q[27:19]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_412;
  assign xor_412 = difference_411[8:0] ^ {9{difference_411[9]}};
  logic [9:0] sum_413;
  assign sum_413 = {9'h0, difference_411[9]} + {1'b0, xor_412};
  logic [10:0] sum_414;
  assign sum_414 = ({1'b0, sum_406} + {1'b0, sum_409}) + {1'b0, sum_413};
  logic [9:0] difference_415;
  assign difference_415 = {1'b0, census_memory_rdata_q[46:38]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_416;
  assign xor_416 = difference_415[8:0] ^ {9{difference_415[9]}};
  logic [9:0] sum_417;
  assign sum_417 = {9'h0, difference_415[9]} + {1'b0, xor_416};
  logic [9:0] difference_419;
  assign difference_419 = {1'b0, census_memory_rdata_q[65:57]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_420;
  assign xor_420 = difference_419[8:0] ^ {9{difference_419[9]}};
  logic [9:0] sum_421;
  assign sum_421 = {9'h0, difference_419[9]} + {1'b0, xor_420};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_414} + {2'h0, sum_417}) + {2'h0, sum_421};
  // hls/stages/agreement.hpp:410
  logic not_488;
  assign not_488 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_489;
  assign less_489 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:418
  logic [7:0] select_727;
  assign select_727 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_663_s3_q : sum_555_s3_q) : (best_2_s3_q[0] ? sum_608_s3_q : sum_720_s3_q);
  logic less_781;
  assign less_781 = select_727 < sum_780_s3_q;
  logic [1:0] select_782;
  assign select_782 = less_781 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:420
  logic [7:0] select_785;
  assign select_785 = select_782[1] ? (select_782[0] ? sum_663_s3_q : sum_555_s3_q) : (select_782[0] ? sum_608_s3_q : sum_720_s3_q);
  logic [7:0] of_best;
  assign of_best = less_781 ? sum_780_s3_q : select_785;
  logic [7:0] of_best_2;
  assign of_best_2 = (not_488 & (~less_489)) ? of_best : 8'h0;
  // hls/stages/agreement.hpp:422
  logic less_788;
  assign less_788 = $signed(run_shift_s3_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:425
  logic less_789;
  assign less_789 = best_left_rdata_s3_q[7:0] < of_best_2;
  logic or_791;
  assign or_791 = less_789 | equal_790_s3_q;
  // hls/stages/agreement.hpp:428
  logic [7:0] select_794;
  assign select_794 = less_788 ? (or_791 ? of_best_2 : best_left_rdata_s3_q[7:0]) : (less_789 ? of_best_2 : best_left_rdata_s3_q[7:0]);
  logic [5:0] select_798;
  assign select_798 = less_788 ? (or_791 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]) : (less_789 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]);
  // hls/stages/agreement.hpp:438
  logic [2:0] near_best;
  assign near_best = ({less_781, select_782} == 3'h4) ? 3'h3 : (({less_781, select_782} == 3'h0) ? 3'h1 : {less_781, select_782});
  // hls/stages/agreement.hpp:439
  logic [2:0] sum_805;
  assign sum_805 = near_best + 3'h1;
  logic [7:0] select_808;
  assign select_808 = sum_805[1] ? (sum_805[0] ? sum_663_s3_q : sum_555_s3_q) : (sum_805[0] ? sum_608_s3_q : sum_720_s3_q);
  logic [7:0] select_809;
  assign select_809 = sum_805[2] ? sum_780_s3_q : select_808;
  logic [2:0] sum_810;
  assign sum_810 = near_best + 3'h7;
  logic [7:0] select_813;
  assign select_813 = sum_810[1] ? (sum_810[0] ? sum_663_s3_q : sum_555_s3_q) : (sum_810[0] ? sum_608_s3_q : sum_720_s3_q);
  logic [7:0] select_814;
  assign select_814 = sum_810[2] ? sum_780_s3_q : select_813;
  logic [8:0] difference_815;
  assign difference_815 = {1'b0, select_809} - {1'b0, select_814};
  // hls/stages/agreement.hpp:440
  logic [7:0] select_819;
  assign select_819 = near_best[1] ? (near_best[0] ? sum_663_s3_q : sum_555_s3_q) : (near_best[0] ? sum_608_s3_q : sum_720_s3_q);
  logic [7:0] select_820;
  assign select_820 = near_best[2] ? sum_780_s3_q : select_819;
  logic [8:0] sum_821;
  assign sum_821 = {1'b0, select_809} + {1'b0, select_814};
  logic [9:0] difference_822;
  assign difference_822 = {1'b0, select_820, 1'b0} - {1'b0, sum_821};
  // hls/stages/agreement.hpp:442
  logic [8:0] twice;
  assign twice = difference_822[9] ? 9'h0 : difference_822[8:0];
  // hls/stages/agreement.hpp:441
  logic [7:0] xor_824;
  assign xor_824 = difference_815[7:0] ^ {8{difference_815[8]}};
  logic [8:0] size;
  assign size = {8'h0, difference_815[8]} + {1'b0, xor_824};
  // hls/stages/agreement.hpp:443
  logic [9:0] difference_828;
  assign difference_828 = {1'b0, twice} - (({1'b0, size[8:1]} < twice) ? {1'b0, size} : {twice, 1'b0});
  // hls/stages/agreement.hpp:432
  logic less_853;
  assign less_853 = best_right_rdata_q[7:0] < of_best_2;
  logic or_855;
  assign or_855 = less_853 | equal_854_s3_q;
  // hls/stages/agreement.hpp:433
  logic [7:0] select_858;
  assign select_858 = less_788 ? (or_855 ? of_best_2 : best_right_rdata_q[7:0]) : (less_853 ? of_best_2 : best_right_rdata_q[7:0]);
  logic [7:0] select_859;
  assign select_859 = equal_486_s3_q ? of_best_2 : select_858;
  logic [6:0] select_862;
  assign select_862 = less_788 ? (or_855 ? x_s3_2_q : best_right_rdata_q[14:8]) : (less_853 ? x_s3_2_q : best_right_rdata_q[14:8]);
  logic [6:0] select_863;
  assign select_863 = equal_486_s3_q ? x_s3_2_q : select_862;
  // hls/stages/agreement.hpp:134
  logic [7:0] select_864;
  assign select_864 = drew_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:646
  logic or_867;
  assign or_867 = select_864[7] | (~({select_864[5], select_864[3], select_864[1]} == 3'h0));
  // hls/stages/agreement.hpp:645
  logic or_870;
  assign or_870 = select_864[7] | (~({select_864[6], select_864[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:644
  logic or_873;
  assign or_873 = select_864[7] | (~(select_864[6:4] == 3'h0));
  // hls/stages/agreement.hpp:461
  logic [5:0] sum_875;
  assign sum_875 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:654
  logic or_878;
  assign or_878 = (~sum_875[5]) | equal_877_s3_q;
  // hls/stages/agreement.hpp:583
  logic and_879;
  assign and_879 = not_343_s3_q & or_878;
  // hls/stages/agreement.hpp:714
  logic equal_881;
  assign equal_881 = x_s3_q[5:4] == 2'h3;
  // hls/stages/agreement.hpp:298
  logic and_883;
  assign and_883 = equal_880_s3_q & (~equal_881);
  // hls/stages/agreement.hpp:162
  logic textured;
  assign textured = not_343_s3_q & and_891_s3_q;
  // hls/stages/agreement.hpp:574
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s3_q};
  // hls/stages/agreement.hpp:576
  logic [9:0] sum_900;
  assign sum_900 = {way[8], way} + 10'h1;
  logic and_902;
  assign and_902 = (and_891_s3_q & (8'hb6 < best_left_rdata_s3_q[7:0])) & ({{6{sum_900[9]}}, sum_900} < 16'h3);
  // hls/stages/agreement.hpp:162
  logic explained;
  assign explained = not_343_s3_q & and_902;
  // hls/stages/agreement.hpp:578
  logic and_910;
  assign and_910 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s3_q[13:8]));
  // hls/stages/agreement.hpp:162
  logic and_912;
  assign and_912 = and_902 & ((cfg_nearer_below_i & best_left_rdata_s3_q[13]) | and_910);
  logic near;
  assign near = not_343_s3_q & and_912;
  // hls/stages/agreement.hpp:847
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:818
  logic select_940;
  assign select_940 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:804
  logic [7:0] sum_941;
  assign sum_941 = {1'b0, select_940, 2'h0, select_940, 1'b0, {2{select_940}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:846
  logic and_948;
  assign and_948 = began_q & (seen_x_q == 3'h0);
  logic less_949;
  assign less_949 = seen_column_q < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:697
  logic [7:0] sum_952;
  assign sum_952 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_952[7]}}, sum_952, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:804
  logic [7:0] sum_954;
  assign sum_954 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:583
  logic [3:0] select_955;
  assign select_955 = less_342_s3_q ? 4'h0 : seen_columns_rdata_q[11:8];
  logic and_956;
  assign and_956 = seen_columns_rdata_q[6] & not_343_s3_q;
  logic and_957;
  assign and_957 = seen_columns_rdata_q[3] & not_343_s3_q;
  logic and_958;
  assign and_958 = seen_columns_rdata_q[0] & not_343_s3_q;
  // hls/stages/agreement.hpp:677
  logic [1:0] sum_960;
  assign sum_960 = {1'b0, and_957} + ({1'b0, textured} + {1'b0, and_958});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, select_955[1]} + ({2'h0, and_956} + {1'b0, sum_960});
  // hls/stages/agreement.hpp:583
  logic [7:0] select_970;
  assign select_970 = less_342_s3_q ? select_864 : (sum_875[5] ? select_864 : {select_864[6:0], 1'b0});
  // hls/stages/agreement.hpp:646
  logic or_973;
  assign or_973 = select_970[7] | (~({select_970[5], select_970[3], select_970[1]} == 3'h0));
  // hls/stages/agreement.hpp:583
  logic and_989;
  assign and_989 = seen_columns_rdata_q[7] & not_343_s3_q;
  logic and_990;
  assign and_990 = seen_columns_rdata_q[4] & not_343_s3_q;
  logic and_991;
  assign and_991 = seen_columns_rdata_q[1] & not_343_s3_q;
  // hls/stages/agreement.hpp:678
  logic [1:0] sum_993;
  assign sum_993 = {1'b0, and_990} + ({1'b0, explained} + {1'b0, and_991});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, select_955[2]} + ({2'h0, and_989} + {1'b0, sum_993});
  // hls/stages/agreement.hpp:583
  logic and_1004;
  assign and_1004 = seen_columns_rdata_q[5] & not_343_s3_q;
  logic and_1005;
  assign and_1005 = seen_columns_rdata_q[2] & not_343_s3_q;
  // hls/stages/agreement.hpp:679
  logic [1:0] sum_1007;
  assign sum_1007 = {1'b0, and_1004} + ({1'b0, near} + {1'b0, and_1005});
  logic [2:0] near_2;
  assign near_2 = {2'h0, select_955[3]} + ({2'h0, select_955[0]} + {1'b0, sum_1007});
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1060;
  assign select_1060 = and_327_s3_q ? total[10:2] : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1061;
  assign select_1061 = and_327_s3_q ? total_2[10:2] : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1063;
  assign select_1063 = and_327_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1064;
  assign select_1064 = and_327_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1065;
  assign select_1065 = and_327_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1066;
  assign select_1066 = and_327_s3_q ? census_memory_rdata_q[27:19] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1067;
  assign select_1067 = and_327_s3_q ? census_memory_rdata_q[36:28] : census_columns_values_0_cell_2_right_q;
  logic select_1068;
  assign select_1068 = and_327_s3_q ? census_memory_rdata_q[37] : census_columns_values_0_cell_2_mask_q;
  logic [8:0] select_1069;
  assign select_1069 = and_327_s3_q ? census_memory_rdata_q[46:38] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1070;
  assign select_1070 = and_327_s3_q ? census_memory_rdata_q[55:47] : census_columns_values_0_cell_3_right_q;
  logic select_1071;
  assign select_1071 = and_327_s3_q ? census_memory_rdata_q[56] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1072;
  assign select_1072 = and_327_s3_q ? census_memory_rdata_q[65:57] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1073;
  assign select_1073 = and_327_s3_q ? census_memory_rdata_q[74:66] : census_columns_values_0_cell_4_right_q;
  logic select_1074;
  assign select_1074 = and_327_s3_q ? census_memory_rdata_q[75] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1075;
  assign select_1075 = and_327_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1076;
  assign select_1076 = and_327_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1077;
  assign select_1077 = and_327_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1078;
  assign select_1078 = and_327_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1079;
  assign select_1079 = and_327_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1080;
  assign select_1080 = and_327_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1081;
  assign select_1081 = and_327_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1082;
  assign select_1082 = and_327_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1083;
  assign select_1083 = and_327_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic [8:0] select_1084;
  assign select_1084 = and_327_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1085;
  assign select_1085 = and_327_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1086;
  assign select_1086 = and_327_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1087;
  assign select_1087 = and_327_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1088;
  assign select_1088 = and_327_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1089;
  assign select_1089 = and_327_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1090;
  assign select_1090 = and_327_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1091;
  assign select_1091 = and_327_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1092;
  assign select_1092 = and_327_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1093;
  assign select_1093 = and_327_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1094;
  assign select_1094 = and_327_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1095;
  assign select_1095 = and_327_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1096;
  assign select_1096 = and_327_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1097;
  assign select_1097 = and_327_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1098;
  assign select_1098 = and_327_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1099;
  assign select_1099 = and_327_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1100;
  assign select_1100 = and_327_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1101;
  assign select_1101 = and_327_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1102;
  assign select_1102 = and_327_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1103;
  assign select_1103 = and_327_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1104;
  assign select_1104 = and_327_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1105;
  assign select_1105 = and_327_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1106;
  assign select_1106 = and_327_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1107;
  assign select_1107 = and_327_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1108;
  assign select_1108 = and_327_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1109;
  assign select_1109 = and_327_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1110;
  assign select_1110 = and_327_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1111;
  assign select_1111 = and_327_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1112;
  assign select_1112 = and_327_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1113;
  assign select_1113 = and_327_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:184
  logic [9:0] difference_1115;
  assign difference_1115 = {1'b0, total_2[10:2]} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1116;
  assign xor_1116 = difference_1115[8:0] ^ {9{difference_1115[9]}};
  logic [9:0] sum_1117;
  assign sum_1117 = {9'h0, difference_1115[9]} + {1'b0, xor_1116};
  logic [9:0] difference_1118;
  assign difference_1118 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1119;
  assign xor_1119 = difference_1118[8:0] ^ {9{difference_1118[9]}};
  logic [9:0] sum_1120;
  assign sum_1120 = {9'h0, difference_1118[9]} + {1'b0, xor_1119};
  logic [9:0] difference_1122;
  assign difference_1122 = {1'b0, census_memory_rdata_q[36:28]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1123;
  assign xor_1123 = difference_1122[8:0] ^ {9{difference_1122[9]}};
  logic [9:0] sum_1124;
  assign sum_1124 = {9'h0, difference_1122[9]} + {1'b0, xor_1123};
  logic [10:0] sum_1125;
  assign sum_1125 = ({1'b0, sum_1117} + {1'b0, sum_1120}) + {1'b0, sum_1124};
  logic [9:0] difference_1126;
  assign difference_1126 = {1'b0, census_memory_rdata_q[55:47]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1127;
  assign xor_1127 = difference_1126[8:0] ^ {9{difference_1126[9]}};
  logic [9:0] sum_1128;
  assign sum_1128 = {9'h0, difference_1126[9]} + {1'b0, xor_1127};
  logic [9:0] difference_1130;
  assign difference_1130 = {1'b0, census_memory_rdata_q[74:66]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1131;
  assign xor_1131 = difference_1130[8:0] ^ {9{difference_1130[9]}};
  logic [9:0] sum_1132;
  assign sum_1132 = {9'h0, difference_1130[9]} + {1'b0, xor_1131};
  // hls/stages/census.hpp:263
  logic [9:0] difference_1159;
  assign difference_1159 = {1'b0, total[10:2]} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1159[9]} + (difference_1159[8:0] ^ {9{difference_1159[9]}});
  logic [9:0] difference_1170;
  assign difference_1170 = {1'b0, total_2[10:2]} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1170[9]} + (difference_1170[8:0] ^ {9{difference_1170[9]}});
  // hls/stages/agreement.hpp:173
  logic and_1324;
  assign and_1324 = and_327_s3_q & (equal_373_s3_q & equal_1191_s3_q);
  // hls/stages/agreement.hpp:298
  logic and_1329;
  assign and_1329 = not_340_s3_q & (not_481_s3_q & (drew_s3_q & (not_343_s3_q & and_1325_s3_q)));
  // hls/stages/agreement.hpp:162
  logic [8:0] select_1374;
  assign select_1374 = less_342_s3_q ? 9'h0 : (and_891_s3_q ? {and_902, cfg_explained_limit_i} : 9'h0);
  // hls/stages/agreement.hpp:298
  logic [8:0] select_1377;
  assign select_1377 = equal_339_s3_q ? 9'h0 : (equal_341_s3_q ? 9'h0 : (drew_s3_q ? select_1374 : 9'h0));
  // hls/stages/agreement.hpp:544
  logic [23:0] sum_1378;
  assign sum_1378 = counts_too_little_explained_q + {{15{select_1377[8]}}, select_1377};
  // hls/stages/agreement.hpp:580
  logic [9:0] select_1400;
  assign select_1400 = and_1325_s3_q ? ({1'b0, and_912, 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:298
  logic [9:0] select_1403;
  assign select_1403 = equal_341_s3_q ? 10'h0 : (drew_s3_q ? (less_342_s3_q ? 10'h0 : select_1400) : 10'h0);
  logic [9:0] select_1404;
  assign select_1404 = equal_339_s3_q ? 10'h0 : select_1403;
  // hls/stages/agreement.hpp:554
  logic [23:0] select_1406;
  assign select_1406 = and_1324 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1404[9]}}, select_1404});
  // hls/stages/agreement.hpp:580
  logic and_1408;
  assign and_1408 = and_902 & less_1407_s3_q;
  // hls/stages/agreement.hpp:612
  logic equal_1411;
  assign equal_1411 = {lower_half_s3_q, less_1410_s3_q} == 2'h3;
  logic equal_1412;
  assign equal_1412 = {lower_half_s3_q, less_1410_s3_q} == 2'h2;
  logic equal_1413;
  assign equal_1413 = {lower_half_s3_q, less_1410_s3_q} == 2'h1;
  // hls/stages/agreement.hpp:633
  logic [9:0] sum_1444;
  assign sum_1444 = {difference_1443_s3_q, select_1441_s3_q} + {sum_1440_s3_q[9], sum_1440_s3_q[9:1]};
  // hls/stages/agreement.hpp:607
  logic [11:0] difference_1445;
  assign difference_1445 = {{4{best_left_rdata_s3_q[21]}}, best_left_rdata_s3_q[21:14]} - {sum_1444[9], sum_1444, sum_1440_s3_q[0]};
  // hls/stages/agreement.hpp:637
  logic [11:0] select_1447;
  assign select_1447 = ($signed(difference_1445[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1445;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1447[11:7])) ? 12'h7f : select_1447;
  // hls/stages/agreement.hpp:612
  logic not_1487;
  assign not_1487 = ~equal_1411;
  logic not_1488;
  assign not_1488 = ~equal_1412;
  // hls/stages/agreement.hpp:162
  logic and_1493;
  assign and_1493 = not_343_s3_q & (and_1408 & (not_1487 & (not_1488 & (~equal_1413))));
  // hls/stages/agreement.hpp:298
  logic and_1496;
  assign and_1496 = not_340_s3_q & (not_481_s3_q & (drew_s3_q & and_1493));
  logic and_1503;
  assign and_1503 = drew_s3_q & (not_343_s3_q & (and_1408 & (not_1487 & (equal_1413 & not_1488))));
  logic and_1505;
  assign and_1505 = not_340_s3_q & (not_481_s3_q & and_1503);
  logic and_1511;
  assign and_1511 = drew_s3_q & (not_343_s3_q & (and_1408 & (equal_1412 & not_1487)));
  logic and_1513;
  assign and_1513 = not_340_s3_q & (not_481_s3_q & and_1511);
  logic and_1519;
  assign and_1519 = not_481_s3_q & (drew_s3_q & (not_343_s3_q & (and_1408 & equal_1411)));
  logic and_1520;
  assign and_1520 = not_340_s3_q & and_1519;
  // hls/stages/agreement.hpp:625
  logic [12:0] difference_1531;
  assign difference_1531 = 13'h0 - {residual[11], residual};
  // hls/stages/agreement.hpp:162
  logic and_1533;
  assign and_1533 = and_1408 & ($signed(difference_1531) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1536;
  assign select_1536 = equal_341_s3_q ? 2'h0 : (drew_s3_q ? (less_342_s3_q ? 2'h0 : {and_1533, and_1408}) : 2'h0);
  logic [1:0] to_up;
  assign to_up = equal_339_s3_q ? 2'h0 : select_1536;
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1539;
  assign select_1539 = and_1324 ? 15'h0 : (counts_votes_0_up_q + {{13{to_up[1]}}, to_up});
  // hls/stages/agreement.hpp:619
  logic not_1540;
  assign not_1540 = ~less_1410_s3_q;
  // hls/stages/agreement.hpp:625
  logic less_1542;
  assign less_1542 = $signed(residual[7:0]) < $signed(limit);
  // hls/stages/agreement.hpp:618
  logic and_1543;
  assign and_1543 = not_1540 & less_1542;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1546;
  assign select_1546 = drew_s3_q ? (less_342_s3_q ? 2'h0 : (and_1408 ? {and_1543, not_1540} : 2'h0)) : 2'h0;
  logic [1:0] to_down_2;
  assign to_down_2 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : select_1546);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1550;
  assign select_1550 = and_1324 ? 15'h0 : (counts_votes_1_down_q + {{13{to_down_2[1]}}, to_down_2});
  // hls/stages/agreement.hpp:625
  logic less_1551;
  assign less_1551 = $signed(difference_1531) < $signed({{5{limit[7]}}, limit});
  // hls/stages/agreement.hpp:618
  logic and_1552;
  assign and_1552 = not_1540 & less_1551;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1555;
  assign select_1555 = drew_s3_q ? (less_342_s3_q ? 2'h0 : (and_1408 ? {and_1552, not_1540} : 2'h0)) : 2'h0;
  logic [1:0] to_up_2;
  assign to_up_2 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : select_1555);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1559;
  assign select_1559 = and_1324 ? 15'h0 : (counts_votes_1_up_q + {{13{to_up_2[1]}}, to_up_2});
  // hls/stages/agreement.hpp:618
  logic and_1560;
  assign and_1560 = less_1410_s3_q & less_1542;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1562;
  assign select_1562 = less_342_s3_q ? 2'h0 : (and_1408 ? {and_1560, less_1410_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_3;
  assign to_down_3 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : (drew_s3_q ? select_1562 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1567;
  assign select_1567 = and_1324 ? 15'h0 : (counts_votes_2_down_q + {{13{to_down_3[1]}}, to_down_3});
  // hls/stages/agreement.hpp:618
  logic and_1568;
  assign and_1568 = less_1410_s3_q & less_1551;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1570;
  assign select_1570 = less_342_s3_q ? 2'h0 : (and_1408 ? {and_1568, less_1410_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_3;
  assign to_up_3 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : (drew_s3_q ? select_1570 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1575;
  assign select_1575 = and_1324 ? 15'h0 : (counts_votes_2_up_q + {{13{to_up_3[1]}}, to_up_3});
  // hls/stages/agreement.hpp:619
  logic not_1576;
  assign not_1576 = ~lower_half_s3_q;
  // hls/stages/agreement.hpp:162
  logic and_1577;
  assign and_1577 = less_1542 & not_1576;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1580;
  assign select_1580 = drew_s3_q ? (less_342_s3_q ? 2'h0 : (and_1408 ? {and_1577, not_1576} : 2'h0)) : 2'h0;
  logic [1:0] to_down_4;
  assign to_down_4 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : select_1580);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1584;
  assign select_1584 = and_1324 ? 15'h0 : (counts_votes_3_down_q + {{13{to_down_4[1]}}, to_down_4});
  // hls/stages/agreement.hpp:162
  logic and_1585;
  assign and_1585 = less_1551 & not_1576;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1588;
  assign select_1588 = drew_s3_q ? (less_342_s3_q ? 2'h0 : (and_1408 ? {and_1585, not_1576} : 2'h0)) : 2'h0;
  logic [1:0] to_up_4;
  assign to_up_4 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : select_1588);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1592;
  assign select_1592 = and_1324 ? 15'h0 : (counts_votes_3_up_q + {{13{to_up_4[1]}}, to_up_4});
  // hls/stages/agreement.hpp:162
  logic and_1593;
  assign and_1593 = lower_half_s3_q & less_1542;
  logic [1:0] select_1595;
  assign select_1595 = less_342_s3_q ? 2'h0 : (and_1408 ? {and_1593, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_5;
  assign to_down_5 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : (drew_s3_q ? select_1595 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1600;
  assign select_1600 = and_1324 ? 15'h0 : (counts_votes_4_down_q + {{13{to_down_5[1]}}, to_down_5});
  // hls/stages/agreement.hpp:162
  logic and_1601;
  assign and_1601 = lower_half_s3_q & less_1551;
  logic [1:0] select_1603;
  assign select_1603 = less_342_s3_q ? 2'h0 : (and_1408 ? {and_1601, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_5;
  assign to_up_5 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : (drew_s3_q ? select_1603 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1608;
  assign select_1608 = and_1324 ? 15'h0 : (counts_votes_4_up_q + {{13{to_up_5[1]}}, to_up_5});
  // hls/stages/agreement.hpp:625
  logic less_1609;
  assign less_1609 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:618
  logic and_1610;
  assign and_1610 = not_1540 & less_1609;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1613;
  assign select_1613 = drew_s3_q ? (less_342_s3_q ? 2'h0 : (and_1408 ? {and_1610, not_1540} : 2'h0)) : 2'h0;
  logic [1:0] to_down_6;
  assign to_down_6 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : select_1613);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1617;
  assign select_1617 = and_1324 ? 15'h0 : (counts_half_votes_0_down_q + {{13{to_down_6[1]}}, to_down_6});
  // hls/stages/agreement.hpp:625
  logic less_1618;
  assign less_1618 = $signed(difference_1531) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:618
  logic and_1619;
  assign and_1619 = not_1540 & less_1618;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1622;
  assign select_1622 = drew_s3_q ? (less_342_s3_q ? 2'h0 : (and_1408 ? {and_1619, not_1540} : 2'h0)) : 2'h0;
  logic [1:0] to_up_6;
  assign to_up_6 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : select_1622);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1626;
  assign select_1626 = and_1324 ? 15'h0 : (counts_half_votes_0_up_q + {{13{to_up_6[1]}}, to_up_6});
  // hls/stages/agreement.hpp:618
  logic and_1627;
  assign and_1627 = less_1410_s3_q & less_1609;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1629;
  assign select_1629 = less_342_s3_q ? 2'h0 : (and_1408 ? {and_1627, less_1410_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_7;
  assign to_down_7 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : (drew_s3_q ? select_1629 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1634;
  assign select_1634 = and_1324 ? 15'h0 : (counts_half_votes_1_down_q + {{13{to_down_7[1]}}, to_down_7});
  // hls/stages/agreement.hpp:618
  logic and_1635;
  assign and_1635 = less_1410_s3_q & less_1618;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1637;
  assign select_1637 = less_342_s3_q ? 2'h0 : (and_1408 ? {and_1635, less_1410_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_7;
  assign to_up_7 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : (drew_s3_q ? select_1637 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1642;
  assign select_1642 = and_1324 ? 15'h0 : (counts_half_votes_1_up_q + {{13{to_up_7[1]}}, to_up_7});
  // hls/stages/agreement.hpp:162
  logic and_1643;
  assign and_1643 = less_1609 & not_1576;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1646;
  assign select_1646 = drew_s3_q ? (less_342_s3_q ? 2'h0 : (and_1408 ? {and_1643, not_1576} : 2'h0)) : 2'h0;
  logic [1:0] to_down_8;
  assign to_down_8 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : select_1646);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1650;
  assign select_1650 = and_1324 ? 15'h0 : (counts_half_votes_2_down_q + {{13{to_down_8[1]}}, to_down_8});
  // hls/stages/agreement.hpp:162
  logic and_1651;
  assign and_1651 = less_1618 & not_1576;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1654;
  assign select_1654 = drew_s3_q ? (less_342_s3_q ? 2'h0 : (and_1408 ? {and_1651, not_1576} : 2'h0)) : 2'h0;
  logic [1:0] to_up_8;
  assign to_up_8 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : select_1654);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1658;
  assign select_1658 = and_1324 ? 15'h0 : (counts_half_votes_2_up_q + {{13{to_up_8[1]}}, to_up_8});
  // hls/stages/agreement.hpp:162
  logic and_1659;
  assign and_1659 = lower_half_s3_q & less_1609;
  logic [1:0] select_1661;
  assign select_1661 = less_342_s3_q ? 2'h0 : (and_1408 ? {and_1659, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_9;
  assign to_down_9 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : (drew_s3_q ? select_1661 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1666;
  assign select_1666 = and_1324 ? 15'h0 : (counts_half_votes_3_down_q + {{13{to_down_9[1]}}, to_down_9});
  // hls/stages/agreement.hpp:162
  logic and_1667;
  assign and_1667 = lower_half_s3_q & less_1618;
  logic [1:0] select_1669;
  assign select_1669 = less_342_s3_q ? 2'h0 : (and_1408 ? {and_1667, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_9;
  assign to_up_9 = equal_339_s3_q ? 2'h0 : (equal_341_s3_q ? 2'h0 : (drew_s3_q ? select_1669 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1674;
  assign select_1674 = and_1324 ? 15'h0 : (counts_half_votes_3_up_q + {{13{to_up_9[1]}}, to_up_9});
  // hls/stages/agreement.hpp:477
  logic [7:0] sum_1685;
  assign sum_1685 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:243
  logic [2:0] select_1687;
  assign select_1687 = less_1684_s3_q ? (sum_1685[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1689;
  assign select_1689 = equal_1191_s3_q ? (equal_373_s3_q ? 3'h0 : select_1687) : region_row_q;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1693;
  assign select_1693 = equal_339_s3_q ? select_864 : (equal_341_s3_q ? select_864 : (drew_s3_q ? select_970 : 8'h1));
  // hls/stages/agreement.hpp:478
  logic [8:0] sum_1694;
  assign sum_1694 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/agreement.hpp:479
  logic [8:0] select_1695;
  assign select_1695 = sum_875[5] ? {1'b1, sum_875[4:0], region_across_rest_q[2:0]} : sum_1694;
  // hls/stages/agreement.hpp:243
  logic [8:0] select_1699;
  assign select_1699 = equal_1191_s3_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_1702;
  assign select_1702 = equal_1191_s3_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  logic [8:0] select_1706;
  assign select_1706 = equal_373_s3_q ? {{2{difference_1704[6]}}, difference_1704} : (less_1684_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1708;
  assign select_1708 = and_327_s3_q ? (equal_1191_s3_q ? select_1706 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:243
  logic [6:0] select_1710;
  assign select_1710 = equal_373_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:173
  logic [6:0] select_1712;
  assign select_1712 = and_327_s3_q ? (equal_1191_s3_q ? select_1710 : region_down_back_q) : region_down_back_q;
  // hls/stages/agreement.hpp:478
  logic [8:0] sum_1713;
  assign sum_1713 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/agreement.hpp:479
  logic [8:0] select_1714;
  assign select_1714 = sum_1685[7] ? {1'b1, sum_1685[6:0], region_down_rest_q[0]} : sum_1713;
  // hls/stages/agreement.hpp:461
  logic next;
  assign next = ~sum_1685[7];
  // hls/stages/agreement.hpp:243
  logic select_1718;
  assign select_1718 = equal_1191_s3_q ? (equal_373_s3_q | (less_1684_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:134
  logic or_1723;
  assign or_1723 = segment_starts_q | not_1237_s3_q;
  // hls/stages/agreement.hpp:583
  logic select_1726;
  assign select_1726 = less_342_s3_q ? or_1723 : (sum_875[5] ? (equal_877_s3_q & or_878) : or_878);
  // hls/stages/agreement.hpp:298
  logic select_1729;
  assign select_1729 = equal_339_s3_q ? or_1723 : (equal_341_s3_q ? or_1723 : (drew_s3_q ? select_1726 : or_1723));
  // hls/stages/agreement.hpp:727
  logic equal_1731;
  assign equal_1731 = x_s3_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:729
  logic [7:0] select_1755;
  assign select_1755 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1757;
  assign select_1757 = equal_880_s3_q ? (equal_1731 ? select_1755 : hidden_for_q) : hidden_for_q;
  logic [7:0] select_1759;
  assign select_1759 = equal_341_s3_q ? hidden_for_q : (drew_s3_q ? hidden_for_q : select_1757);
  // hls/stages/agreement.hpp:139
  logic not_1761;
  assign not_1761 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:298
  logic select_1838;
  assign select_1838 = equal_341_s3_q ? centres_values_0_q : (drew_s3_q ? and_957 : centres_values_0_q);
  logic select_1841;
  assign select_1841 = equal_341_s3_q ? centres_values_1_q : (drew_s3_q ? centres_values_0_q : centres_values_1_q);
  // hls/stages/agreement.hpp:243
  logic [12:0] select_1846;
  assign select_1846 = equal_1191_s3_q ? (equal_1843_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:173
  logic [6:0] select_1849;
  assign select_1849 = and_327_s3_q ? (equal_1191_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:298
  logic and_1860;
  assign and_1860 = not_340_s3_q & (not_481_s3_q & (not_1237_s3_q & (equal_880_s3_q & equal_1731)));
  // hls/stages/agreement.hpp:847
  logic and_1875;
  assign and_1875 = and_1026_s3_q & ({sum_954, index_2[5:0]} == {sum_941, index[5:0]});
  // hls/stages/agreement.hpp:298
  logic and_1921;
  assign and_1921 = not_1237_s3_q & (equal_880_s3_q & (equal_1731 & (cfg_prove_i & (~proven_q))));
  // hls/stages/agreement.hpp:785
  logic [12:0] upper;
  assign upper = {1'b0, counts_measured_0_q} + {1'b0, counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, counts_measured_2_q} + {1'b0, counts_measured_3_q};
  // hls/stages/agreement.hpp:789
  logic [13:0] sum_1945;
  assign sum_1945 = {1'b0, upper} + {1'b0, lower};
  logic less_1946;
  assign less_1946 = 11'h4 < sum_1945[13:3];
  // hls/stages/agreement.hpp:785
  logic [12:0] left;
  assign left = {1'b0, counts_measured_0_q} + {1'b0, counts_measured_2_q};
  // hls/stages/agreement.hpp:786
  logic less_1949;
  assign less_1949 = 11'he < left[12:2];
  // hls/stages/agreement.hpp:496
  logic less_1951;
  assign less_1951 = $signed(15'h0) < $signed(counts_votes_0_up_q);
  // hls/stages/agreement.hpp:790
  logic or_1952;
  assign or_1952 = (~less_1949) | less_1951;
  // hls/stages/agreement.hpp:785
  logic [12:0] right;
  assign right = {1'b0, counts_measured_1_q} + {1'b0, counts_measured_3_q};
  // hls/stages/agreement.hpp:786
  logic less_1954;
  assign less_1954 = 11'he < right[12:2];
  // hls/stages/agreement.hpp:496
  logic less_1956;
  assign less_1956 = $signed(15'h0) < $signed(counts_half_votes_0_up_q);
  // hls/stages/agreement.hpp:790
  logic select_1958;
  assign select_1958 = less_1946 ? (or_1952 ? less_1951 : less_1956) : less_1956;
  logic or_1959;
  assign or_1959 = (~less_1954) | select_1958;
  // hls/stages/agreement.hpp:786
  logic less_1960;
  assign less_1960 = 11'he < upper[12:2];
  // hls/stages/agreement.hpp:496
  logic less_1962;
  assign less_1962 = $signed(15'h0) < $signed(counts_half_votes_1_up_q);
  // hls/stages/agreement.hpp:790
  logic select_1963;
  assign select_1963 = or_1959 ? select_1958 : less_1962;
  logic select_1965;
  assign select_1965 = less_1946 ? select_1963 : (less_1949 ? select_1963 : less_1962);
  logic or_1966;
  assign or_1966 = (~less_1960) | select_1965;
  // hls/stages/agreement.hpp:496
  logic less_1967;
  assign less_1967 = $signed(15'h0) < $signed(counts_half_votes_2_up_q);
  // hls/stages/agreement.hpp:790
  logic select_1968;
  assign select_1968 = or_1966 ? select_1965 : less_1967;
  logic select_1971;
  assign select_1971 = less_1946 ? select_1968 : (less_1949 ? select_1968 : (less_1954 ? select_1968 : less_1967));
  // hls/stages/agreement.hpp:787
  logic less_1972;
  assign less_1972 = 11'he < lower[12:2];
  // hls/stages/agreement.hpp:790
  logic or_1974;
  assign or_1974 = select_1971 | (~less_1972);
  // hls/stages/agreement.hpp:496
  logic less_1975;
  assign less_1975 = $signed(15'h0) < $signed(counts_half_votes_3_up_q);
  // hls/stages/agreement.hpp:791
  logic select_1976;
  assign select_1976 = or_1974 ? select_1971 : less_1975;
  logic select_1979;
  assign select_1979 = less_1949 ? select_1976 : (less_1954 ? select_1976 : (less_1960 ? select_1976 : less_1975));
  // hls/stages/agreement.hpp:731
  logic and_1991;
  assign and_1991 = ($signed(15'h0) < $signed(counts_votes_3_up_q)) & ($signed(15'h0) < $signed(counts_votes_4_down_q));
  logic select_1993;
  assign select_1993 = ($signed(15'h0) < $signed(counts_votes_3_down_q)) ? (($signed(15'h0) < $signed(counts_votes_4_up_q)) | and_1991) : and_1991;
  logic and_1994;
  assign and_1994 = (less_1960 & less_1972) & select_1993;
  logic select_1996;
  assign select_1996 = ($signed(15'h0) < $signed(counts_votes_1_up_q)) ? (($signed(15'h0) < $signed(counts_votes_2_down_q)) | and_1994) : and_1994;
  logic select_1998;
  assign select_1998 = ($signed(15'h0) < $signed(counts_votes_1_down_q)) ? (($signed(15'h0) < $signed(counts_votes_2_up_q)) | select_1996) : select_1996;
  logic select_1999;
  assign select_1999 = (less_1949 & less_1954) ? select_1998 : and_1994;
  logic or_2000;
  assign or_2000 = (less_1946 ? select_1976 : select_1979) | select_1999;
  logic or_2002;
  assign or_2002 = ($signed(15'h0) < $signed(counts_half_votes_3_down_q)) | or_2000;
  logic select_2003;
  assign select_2003 = or_1974 ? or_2000 : or_2002;
  logic or_2005;
  assign or_2005 = ($signed(15'h0) < $signed(counts_half_votes_2_down_q)) | select_2003;
  logic and_2052;
  assign and_2052 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1755 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:298
  logic and_2056;
  assign and_2056 = not_1237_s3_q & (equal_880_s3_q & (equal_1731 & (cfg_prove_i & and_2052)));
  logic [11:0] select_2080;
  assign select_2080 = equal_880_s3_q ? (equal_1731 ? counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2083;
  assign select_2083 = equal_339_s3_q ? 12'h0 : (equal_341_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2080));
  logic [11:0] select_2085;
  assign select_2085 = equal_880_s3_q ? (equal_1731 ? counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2088;
  assign select_2088 = equal_339_s3_q ? 12'h0 : (equal_341_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2085));
  logic [11:0] select_2090;
  assign select_2090 = equal_880_s3_q ? (equal_1731 ? counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2093;
  assign select_2093 = equal_339_s3_q ? 12'h0 : (equal_341_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2090));
  logic [11:0] select_2095;
  assign select_2095 = equal_880_s3_q ? (equal_1731 ? counts_measured_3_q : 12'h0) : 12'h0;
  logic [11:0] select_2098;
  assign select_2098 = equal_339_s3_q ? 12'h0 : (equal_341_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2095));

  // Memory regions, 64 x 36, DISTANCE 12, hls/stages/agreement.hpp:902; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = drew_s3_q ? {region_row_q, or_873, or_870, or_867} : x_s3_q[5:0];
  logic regions_re;
  assign regions_re = s3_en & (not_340_s3_q & (not_481_s3_q & (drew_s3_q ? and_879 : and_883)));
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 9600 x 2, DISTANCE 16, hls/stages/agreement.hpp:922; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_941, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_948 & less_949);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_301_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_308_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_323, sum_319, sum_315};
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
  assign census_memory_waddr = select_297_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_327_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[56:0], whole_2, total_2[10:2], total[10:2]};
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
  assign best_right_we = s3_en & and_848_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_863, select_859};
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
  assign seen_columns_we = s3_en & and_921_s3_q;
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
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      counts_too_little_explained_q <= 24'h0;
      counts_too_much_hidden_q <= 24'h0;
      counts_measured_0_q <= 12'h0;
      counts_measured_1_q <= 12'h0;
      counts_measured_2_q <= 12'h0;
      counts_measured_3_q <= 12'h0;
      counts_votes_0_up_q <= 15'h0;
      counts_votes_1_down_q <= 15'h0;
      counts_votes_1_up_q <= 15'h0;
      counts_votes_2_down_q <= 15'h0;
      counts_votes_2_up_q <= 15'h0;
      counts_votes_3_down_q <= 15'h0;
      counts_votes_3_up_q <= 15'h0;
      counts_votes_4_down_q <= 15'h0;
      counts_votes_4_up_q <= 15'h0;
      counts_half_votes_0_down_q <= 15'h0;
      counts_half_votes_0_up_q <= 15'h0;
      counts_half_votes_1_down_q <= 15'h0;
      counts_half_votes_1_up_q <= 15'h0;
      counts_half_votes_2_down_q <= 15'h0;
      counts_half_votes_2_up_q <= 15'h0;
      counts_half_votes_3_down_q <= 15'h0;
      counts_half_votes_3_up_q <= 15'h0;
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
      averager_mask_q <= and_326_s3_q ? whole_2 : averager_mask_q;
      census_filled_q <= and_327_s3_q ? {select_376[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_327_s3_q ? select_375 : rows_passed_above_q;
      counts_too_little_explained_q <= and_1324 ? 24'h0 : sum_1378;
      counts_too_much_hidden_q <= select_1406;
      counts_measured_0_q <= and_1324 ? 12'h0 : (counts_measured_0_q + {11'h0, and_1496});
      counts_measured_1_q <= and_1324 ? 12'h0 : (counts_measured_1_q + {11'h0, and_1505});
      counts_measured_2_q <= and_1324 ? 12'h0 : (counts_measured_2_q + {11'h0, and_1513});
      counts_measured_3_q <= and_1324 ? 12'h0 : (counts_measured_3_q + {11'h0, and_1520});
      counts_votes_0_up_q <= select_1539;
      counts_votes_1_down_q <= select_1550;
      counts_votes_1_up_q <= select_1559;
      counts_votes_2_down_q <= select_1567;
      counts_votes_2_up_q <= select_1575;
      counts_votes_3_down_q <= select_1584;
      counts_votes_3_up_q <= select_1592;
      counts_votes_4_down_q <= select_1600;
      counts_votes_4_up_q <= select_1608;
      counts_half_votes_0_down_q <= select_1617;
      counts_half_votes_0_up_q <= select_1626;
      counts_half_votes_1_down_q <= select_1634;
      counts_half_votes_1_up_q <= select_1642;
      counts_half_votes_2_down_q <= select_1650;
      counts_half_votes_2_up_q <= select_1658;
      counts_half_votes_3_down_q <= select_1666;
      counts_half_votes_3_up_q <= select_1674;
      region_row_q <= and_327_s3_q ? select_1689 : region_row_q;
      region_columns_q <= select_1693;
      region_across_rest_q <= drew_s3_q ? select_1695 : columns_begin_rest_q;
      region_across_back_q <= drew_s3_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_327_s3_q ? select_1699 : columns_begin_rest_q;
      columns_begin_back_q <= and_327_s3_q ? select_1702 : columns_begin_back_q;
      region_down_rest_q <= select_1708;
      region_down_back_q <= select_1712;
      region_down_next_q <= select_1714;
      region_fresh_q <= and_327_s3_q ? select_1718 : region_fresh_q;
      segment_starts_q <= select_1729;
      hidden_for_q <= equal_339_s3_q ? hidden_for_q : select_1759;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1761};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s3_q;
      centres_values_0_q <= equal_339_s3_q ? centres_values_0_q : select_1838;
      centres_values_1_q <= equal_339_s3_q ? centres_values_1_q : select_1841;
      map_row_q <= and_327_s3_q ? select_1846 : map_row_q;
      map_width_q <= select_1849;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_940;
      done_q <= not_942_s3_q & ((~begins_product_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      said_q <= and_1860;
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
      averager_total_0_q <= and_326_s3_q ? total : averager_total_0_q;
      averager_total_1_q <= and_326_s3_q ? total_2 : averager_total_1_q;
      census_columns_values_0_cell_0_left_q <= select_1060;
      census_columns_values_0_cell_0_right_q <= select_1061;
      census_columns_values_0_cell_0_mask_q <= and_327_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_1063;
      census_columns_values_0_cell_1_right_q <= select_1064;
      census_columns_values_0_cell_1_mask_q <= select_1065;
      census_columns_values_0_cell_2_left_q <= select_1066;
      census_columns_values_0_cell_2_right_q <= select_1067;
      census_columns_values_0_cell_2_mask_q <= select_1068;
      census_columns_values_0_cell_3_left_q <= select_1069;
      census_columns_values_0_cell_3_right_q <= select_1070;
      census_columns_values_0_cell_3_mask_q <= select_1071;
      census_columns_values_0_cell_4_left_q <= select_1072;
      census_columns_values_0_cell_4_right_q <= select_1073;
      census_columns_values_0_cell_4_mask_q <= select_1074;
      census_columns_values_1_cell_0_left_q <= select_1075;
      census_columns_values_1_cell_0_right_q <= select_1076;
      census_columns_values_1_cell_0_mask_q <= select_1077;
      census_columns_values_1_cell_1_left_q <= select_1078;
      census_columns_values_1_cell_1_right_q <= select_1079;
      census_columns_values_1_cell_1_mask_q <= select_1080;
      census_columns_values_1_cell_2_left_q <= select_1081;
      census_columns_values_1_cell_2_right_q <= select_1082;
      census_columns_values_1_cell_2_mask_q <= select_1083;
      census_columns_values_1_cell_3_left_q <= select_1084;
      census_columns_values_1_cell_3_right_q <= select_1085;
      census_columns_values_1_cell_3_mask_q <= select_1086;
      census_columns_values_1_cell_4_left_q <= select_1087;
      census_columns_values_1_cell_4_right_q <= select_1088;
      census_columns_values_1_cell_4_mask_q <= select_1089;
      census_columns_values_2_cell_0_left_q <= select_1090;
      census_columns_values_2_cell_0_right_q <= select_1091;
      census_columns_values_2_cell_0_mask_q <= select_1092;
      census_columns_values_2_cell_1_left_q <= select_1093;
      census_columns_values_2_cell_1_right_q <= select_1094;
      census_columns_values_2_cell_1_mask_q <= select_1095;
      census_columns_values_2_cell_2_left_q <= select_1096;
      census_columns_values_2_cell_2_right_q <= select_1097;
      census_columns_values_2_cell_2_mask_q <= select_1098;
      census_columns_values_2_cell_3_left_q <= select_1099;
      census_columns_values_2_cell_3_right_q <= select_1100;
      census_columns_values_2_cell_3_mask_q <= select_1101;
      census_columns_values_2_cell_4_left_q <= select_1102;
      census_columns_values_2_cell_4_right_q <= select_1103;
      census_columns_values_2_cell_4_mask_q <= select_1104;
      census_columns_values_3_cell_0_mask_q <= select_1105;
      census_columns_values_3_cell_1_left_q <= select_1106;
      census_columns_values_3_cell_1_right_q <= select_1107;
      census_columns_values_3_cell_1_mask_q <= select_1108;
      census_columns_values_3_cell_2_mask_q <= select_1109;
      census_columns_values_3_cell_3_left_q <= select_1110;
      census_columns_values_3_cell_3_right_q <= select_1111;
      census_columns_values_3_cell_3_mask_q <= select_1112;
      census_columns_values_3_cell_4_mask_q <= select_1113;
      sharpness_last_mean_0_q <= and_327_s3_q ? total[10:2] : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_327_s3_q ? total_2[10:2] : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic [5:0] x_s4_q;
  logic age_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic begins_product_s4_q;
  logic [6:0] select_297_s4_q;
  logic and_326_s4_q;
  logic and_327_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_330_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic equal_339_s4_q;
  logic not_340_s4_q;
  logic equal_341_s4_q;
  logic less_342_s4_q;
  logic not_343_s4_q;
  logic less_347_s4_q;
  logic less_348_s4_q;
  logic less_349_s4_q;
  logic less_350_s4_q;
  logic less_351_s4_q;
  logic less_352_s4_q;
  logic less_353_s4_q;
  logic less_354_s4_q;
  logic less_355_s4_q;
  logic less_356_s4_q;
  logic less_357_s4_q;
  logic less_358_s4_q;
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
  logic and_377_s4_q;
  logic and_402_s4_q;
  logic and_403_s4_q;
  logic [11:0] texture_s4_q;
  logic [6:0] x_s4_2_q;
  logic not_481_s4_q;
  logic [7:0] best_left_rdata_s4_q;
  logic equal_486_s4_q;
  logic select_782_s4_q;
  logic less_788_s4_q;
  logic less_789_s4_q;
  logic or_791_s4_q;
  logic [7:0] select_795_s4_q;
  logic [5:0] select_799_s4_q;
  logic equal_804_s4_q;
  logic difference_815_s4_q;
  logic [1:0] sum_816_s4_q;
  logic [8:0] twice_s4_q;
  logic [9:0] difference_828_s4_q;
  logic and_848_s4_q;
  logic or_867_s4_q;
  logic or_870_s4_q;
  logic or_873_s4_q;
  logic equal_880_s4_q;
  logic equal_881_s4_q;
  logic and_891_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic near_s4_q;
  logic and_920_s4_q;
  logic and_948_s4_q;
  logic less_949_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_954_s4_q;
  logic [2:0] textured_2_s4_q;
  logic equal_965_s4_q;
  logic or_973_s4_q;
  logic or_976_s4_q;
  logic or_979_s4_q;
  logic [2:0] explained_2_s4_q;
  logic [2:0] near_2_s4_q;
  logic and_1026_s4_q;
  logic [11:0] sum_1133_s4_q;
  logic equal_1140_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic not_1237_s4_q;
  logic and_1324_s4_q;
  logic and_1329_s4_q;
  logic or_1349_s4_q;
  logic and_1408_s4_q;
  logic equal_1411_s4_q;
  logic equal_1412_s4_q;
  logic equal_1413_s4_q;
  logic [7:0] residual_s4_q;
  logic equal_1731_s4_q;
  logic less_1737_s4_q;
  logic and_1875_s4_q;
  logic and_1923_s4_q;
  logic less_1946_s4_q;
  logic less_1949_s4_q;
  logic or_1952_s4_q;
  logic less_1954_s4_q;
  logic or_1959_s4_q;
  logic less_1960_s4_q;
  logic or_1966_s4_q;
  logic select_2003_s4_q;
  logic or_2005_s4_q;
  logic less_2007_s4_q;
  logic less_2010_s4_q;
  logic select_2014_s4_q;
  logic and_2058_s4_q;
  logic [11:0] select_2083_s4_q;
  logic [11:0] select_2088_s4_q;
  logic [11:0] select_2093_s4_q;
  logic [11:0] select_2098_s4_q;
  logic and_2121_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      x_s4_q <= x_s3_q[5:0];
      age_s4_q <= age_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      begins_product_s4_q <= begins_product_q;
      select_297_s4_q <= select_297_s3_q;
      and_326_s4_q <= and_326_s3_q;
      and_327_s4_q <= and_327_s3_q;
      grey_s4_q <= grey;
      equal_330_s4_q <= equal_330_s3_q;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      equal_339_s4_q <= equal_339_s3_q;
      not_340_s4_q <= not_340_s3_q;
      equal_341_s4_q <= equal_341_s3_q;
      less_342_s4_q <= less_342_s3_q;
      not_343_s4_q <= not_343_s3_q;
      less_347_s4_q <= less_347;
      less_348_s4_q <= less_348;
      less_349_s4_q <= less_349;
      less_350_s4_q <= less_350;
      less_351_s4_q <= less_351;
      less_352_s4_q <= less_352;
      less_353_s4_q <= less_353;
      less_354_s4_q <= less_354;
      less_355_s4_q <= less_355;
      less_356_s4_q <= less_356;
      less_357_s4_q <= less_357;
      less_358_s4_q <= less_358;
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
      and_377_s4_q <= and_377;
      and_402_s4_q <= whole_22 & and_377;
      and_403_s4_q <= census_columns_values_1_cell_2_mask_q & and_377;
      texture_s4_q <= texture;
      x_s4_2_q <= x_s3_2_q;
      not_481_s4_q <= not_481_s3_q;
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      equal_486_s4_q <= equal_486_s3_q;
      select_782_s4_q <= select_782[0];
      less_788_s4_q <= less_788;
      less_789_s4_q <= less_789;
      or_791_s4_q <= or_791;
      select_795_s4_q <= equal_486_s3_q ? of_best_2 : select_794;
      select_799_s4_q <= equal_486_s3_q ? run_shift_s3_q : select_798;
      equal_804_s4_q <= {less_781, select_782} == near_best;
      difference_815_s4_q <= difference_815[8];
      sum_816_s4_q <= {less_781, select_782[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_828_s4_q <= difference_828;
      and_848_s4_q <= and_848_s3_q;
      or_867_s4_q <= or_867;
      or_870_s4_q <= or_870;
      or_873_s4_q <= or_873;
      equal_880_s4_q <= equal_880_s3_q;
      equal_881_s4_q <= equal_881;
      and_891_s4_q <= and_891_s3_q;
      textured_s4_q <= textured;
      explained_s4_q <= explained;
      near_s4_q <= near;
      and_920_s4_q <= not_340_s3_q & (not_481_s3_q & (drew_s3_q & and_879));
      and_948_s4_q <= and_948;
      less_949_s4_q <= less_949;
      index_2_s4_q <= index_2[5:0];
      sum_954_s4_q <= sum_954;
      textured_2_s4_q <= textured_2;
      equal_965_s4_q <= x_s3_q == 8'h0;
      or_973_s4_q <= or_973;
      or_976_s4_q <= select_970[7] | (~({select_970[6], select_970[3:2]} == 3'h0));
      or_979_s4_q <= select_970[7] | (~(select_970[6:4] == 3'h0));
      explained_2_s4_q <= explained_2;
      near_2_s4_q <= near_2;
      and_1026_s4_q <= and_1026_s3_q;
      sum_1133_s4_q <= ({1'b0, sum_1125} + {2'h0, sum_1128}) + {2'h0, sum_1132};
      equal_1140_s4_q <= equal_1140_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      not_1237_s4_q <= not_1237_s3_q;
      and_1324_s4_q <= and_1324;
      and_1329_s4_q <= and_1329;
      or_1349_s4_q <= (x_s3_q[7:1] == 7'h0) | (~centres_values_1_q);
      and_1408_s4_q <= and_1408;
      equal_1411_s4_q <= equal_1411;
      equal_1412_s4_q <= equal_1412;
      equal_1413_s4_q <= equal_1413;
      residual_s4_q <= residual[7:0];
      equal_1731_s4_q <= equal_1731;
      less_1737_s4_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      and_1875_s4_q <= and_1875;
      and_1923_s4_q <= not_340_s3_q & (not_481_s3_q & and_1921);
      less_1946_s4_q <= less_1946;
      less_1949_s4_q <= less_1949;
      or_1952_s4_q <= or_1952;
      less_1954_s4_q <= less_1954;
      or_1959_s4_q <= or_1959;
      less_1960_s4_q <= less_1960;
      or_1966_s4_q <= or_1966;
      select_2003_s4_q <= select_2003;
      or_2005_s4_q <= or_2005;
      less_2007_s4_q <= $signed(15'h0) < $signed(counts_half_votes_1_down_q);
      less_2010_s4_q <= $signed(15'h0) < $signed(counts_half_votes_0_down_q);
      select_2014_s4_q <= less_1972 ? or_2002 : select_1999;
      and_2058_s4_q <= not_340_s3_q & (not_481_s3_q & and_2056);
      select_2083_s4_q <= select_2083;
      select_2088_s4_q <= select_2088;
      select_2093_s4_q <= select_2093;
      select_2098_s4_q <= select_2098;
      and_2121_s4_q <= not_340_s3_q & (not_481_s3_q & (not_1237_s3_q & and_883));
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
  logic [19:0] counts_across_0_q;
  logic [19:0] counts_across_1_q;
  logic [19:0] counts_across_2_q;
  logic [19:0] counts_across_3_q;
  logic [14:0] counts_votes_0_down_q;
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
  // hls/stages/census.hpp:193
  logic [12:0] sum_423;
  assign sum_423 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_425;
  assign sum_425 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_423});
  // hls/stages/census.hpp:214
  logic less_426;
  assign less_426 = 9'h4 < sum_425[13:5];
  logic and_427;
  assign and_427 = and_377_s4_q & less_426;
  // hls/stages/agreement.hpp:443
  logic not_829;
  assign not_829 = ~difference_828_s4_q[9];
  logic [8:0] xor_830;
  assign xor_830 = twice_s4_q ^ {9{not_829}};
  logic [10:0] sum_831;
  assign sum_831 = {difference_828_s4_q[8:0], 1'b0, not_829} + {not_829, xor_830, not_829};
  logic not_832;
  assign not_832 = ~sum_831[10];
  logic [8:0] xor_833;
  assign xor_833 = twice_s4_q ^ {9{not_832}};
  logic [10:0] sum_834;
  assign sum_834 = {sum_831[9:0], not_832} + {not_832, xor_833, not_832};
  logic not_835;
  assign not_835 = ~sum_834[10];
  logic [8:0] xor_836;
  assign xor_836 = twice_s4_q ^ {9{not_835}};
  logic [10:0] sum_837;
  assign sum_837 = {sum_834[9:0], not_835} + {not_835, xor_836, not_835};
  logic not_838;
  assign not_838 = ~sum_837[10];
  logic [8:0] xor_839;
  assign xor_839 = twice_s4_q ^ {9{not_838}};
  logic [10:0] sum_840;
  assign sum_840 = {sum_837[9:0], not_838} + {not_838, xor_839, not_838};
  // hls/stages/agreement.hpp:446
  logic [7:0] difference_841;
  assign difference_841 = {sum_816_s4_q, select_782_s4_q, 5'h0} - {3'h0, difference_828_s4_q[9], sum_831[10], sum_834[10], sum_837[10], sum_840[10]};
  // hls/stages/agreement.hpp:426
  logic [7:0] select_842;
  assign select_842 = difference_815_s4_q ? difference_841 : {sum_816_s4_q, select_782_s4_q, difference_828_s4_q[9], sum_831[10], sum_834[10], sum_837[10], sum_840[10]};
  logic [7:0] select_843;
  assign select_843 = equal_804_s4_q ? select_842 : {sum_816_s4_q, select_782_s4_q, 5'h0};
  // hls/stages/agreement.hpp:428
  logic [7:0] select_846;
  assign select_846 = less_788_s4_q ? (or_791_s4_q ? select_843 : best_left_rdata_s4_q) : (less_789_s4_q ? select_843 : best_left_rdata_s4_q);
  logic [7:0] select_847;
  assign select_847 = equal_486_s4_q ? select_843 : select_846;
  // hls/stages/agreement.hpp:528
  logic [6:0] select_893;
  assign select_893 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:529
  logic [6:0] sum_894;
  assign sum_894 = {6'h0, textured_s4_q} + select_893;
  // hls/stages/agreement.hpp:657
  logic [11:0] sum_896;
  assign sum_896 = {5'h0, sum_894} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:528
  logic [6:0] select_904;
  assign select_904 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:529
  logic [6:0] sum_905;
  assign sum_905 = {6'h0, explained_s4_q} + select_904;
  // hls/stages/agreement.hpp:658
  logic [11:0] sum_907;
  assign sum_907 = {5'h0, sum_905} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:528
  logic [6:0] select_914;
  assign select_914 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:530
  logic [6:0] sum_915;
  assign sum_915 = {6'h0, near_s4_q} + select_914;
  // hls/stages/agreement.hpp:659
  logic [11:0] sum_917;
  assign sum_917 = {5'h0, sum_915} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:683
  logic [4:0] difference_964;
  assign difference_964 = {2'h0, textured_2_s4_q} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  logic [4:0] t;
  assign t = difference_964 + (equal_965_s4_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:689
  logic not_980;
  assign not_980 = ~region_row_s4_q[2];
  logic [2:0] select_981;
  assign select_981 = region_row_s4_q[1] ? {1'b0, not_980, 1'b0} : {region_row_s4_q[2], 1'b0, not_980};
  logic [5:0] select_982;
  assign select_982 = region_row_s4_q[0] ? {select_981[2], 1'b0, select_981[1], 1'b0, select_981[0], 1'b0} : {1'b0, select_981[2], 1'b0, select_981[1], 1'b0, select_981[0]};
  logic [11:0] select_983;
  assign select_983 = or_979_s4_q ? {select_982[5], 1'b0, select_982[4], 1'b0, select_982[3], 1'b0, select_982[2], 1'b0, select_982[1], 1'b0, select_982[0], 1'b0} : {1'b0, select_982[5], 1'b0, select_982[4], 1'b0, select_982[3], 1'b0, select_982[2], 1'b0, select_982[1], 1'b0, select_982[0]};
  logic [23:0] select_984;
  assign select_984 = or_976_s4_q ? {select_983[11], 1'b0, select_983[10], 1'b0, select_983[9], 1'b0, select_983[8], 1'b0, select_983[7], 1'b0, select_983[6], 1'b0, select_983[5], 1'b0, select_983[4], 1'b0, select_983[3], 1'b0, select_983[2], 1'b0, select_983[1], 1'b0, select_983[0], 1'b0} : {1'b0, select_983[11], 1'b0, select_983[10], 1'b0, select_983[9], 1'b0, select_983[8], 1'b0, select_983[7], 1'b0, select_983[6], 1'b0, select_983[5], 1'b0, select_983[4], 1'b0, select_983[3], 1'b0, select_983[2], 1'b0, select_983[1], 1'b0, select_983[0]};
  logic [47:0] select_985;
  assign select_985 = or_973_s4_q ? {select_984[23], 1'b0, select_984[22], 1'b0, select_984[21], 1'b0, select_984[20], 1'b0, select_984[19], 1'b0, select_984[18], 1'b0, select_984[17], 1'b0, select_984[16], 1'b0, select_984[15], 1'b0, select_984[14], 1'b0, select_984[13], 1'b0, select_984[12], 1'b0, select_984[11], 1'b0, select_984[10], 1'b0, select_984[9], 1'b0, select_984[8], 1'b0, select_984[7], 1'b0, select_984[6], 1'b0, select_984[5], 1'b0, select_984[4], 1'b0, select_984[3], 1'b0, select_984[2], 1'b0, select_984[1], 1'b0, select_984[0], 1'b0} : {1'b0, select_984[23], 1'b0, select_984[22], 1'b0, select_984[21], 1'b0, select_984[20], 1'b0, select_984[19], 1'b0, select_984[18], 1'b0, select_984[17], 1'b0, select_984[16], 1'b0, select_984[15], 1'b0, select_984[14], 1'b0, select_984[13], 1'b0, select_984[12], 1'b0, select_984[11], 1'b0, select_984[10], 1'b0, select_984[9], 1'b0, select_984[8], 1'b0, select_984[7], 1'b0, select_984[6], 1'b0, select_984[5], 1'b0, select_984[4], 1'b0, select_984[3], 1'b0, select_984[2], 1'b0, select_984[1], 1'b0, select_984[0]};
  // hls/stages/agreement.hpp:684
  logic [4:0] difference_997;
  assign difference_997 = {2'h0, explained_2_s4_q} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_997 + (equal_965_s4_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:690
  logic [5:0] sum_1000;
  assign sum_1000 = {1'b0, e} + {2'h0, e[4:1]};
  logic is_seen;
  assign is_seen = (t[4:1] == 4'h0) ? (~((good_q & select_985) == 48'h0)) : (~({sum_1000, e[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:685
  logic [4:0] difference_1011;
  assign difference_1011 = {2'h0, near_2_s4_q} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1011 + (equal_965_s4_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:698
  logic and_1015;
  assign and_1015 = is_seen & ({1'b0, e[4:1]} < n);
  // hls/stages/census.hpp:123
  logic [9:0] sum_1045;
  assign sum_1045 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_1046;
  assign difference_1046 = {1'b0, sum_1045[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:124
  logic [9:0] xor_1047;
  assign xor_1047 = {difference_1046[8:0], sum_1045[0]} ^ {10{difference_1046[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1046[9]} + {1'b0, xor_1047};
  // hls/stages/census.hpp:125
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_330_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/census.hpp:123
  logic [9:0] sum_1052;
  assign sum_1052 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_1053;
  assign difference_1053 = {1'b0, sum_1052[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:124
  logic [9:0] xor_1054;
  assign xor_1054 = {difference_1053[8:0], sum_1052[0]} ^ {10{difference_1053[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1053[9]} + {1'b0, xor_1054};
  // hls/stages/census.hpp:125
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_330_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:173
  logic [11:0] select_1135;
  assign select_1135 = and_327_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1136;
  assign select_1136 = and_327_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1137;
  assign select_1137 = and_327_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1138;
  assign select_1138 = and_327_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:194
  logic [12:0] sum_1141;
  assign sum_1141 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1133_s4_q};
  logic [13:0] sum_1143;
  assign sum_1143 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1141});
  // hls/stages/census.hpp:216
  logic and_1145;
  assign and_1145 = and_402_s4_q & (9'h4 < sum_1143[13:5]);
  // hls/stages/census.hpp:217
  logic and_1146;
  assign and_1146 = and_402_s4_q & less_426;
  // hls/stages/census.hpp:218
  logic [19:0] sum_1147;
  assign sum_1147 = census_left_misses_q + {{17{and_1146}}, and_1145, 1'b0, and_1145};
  // hls/stages/agreement.hpp:173
  logic [19:0] select_1149;
  assign select_1149 = and_327_s4_q ? (equal_1140_s4_q ? 20'h0 : sum_1147) : census_left_misses_q;
  // hls/stages/census.hpp:265
  logic and_1158;
  assign and_1158 = whole_2_s4_q & (~(select_297_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:240
  logic and_1164;
  assign and_1164 = and_1158 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:264
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, detail};
  // hls/stages/census.hpp:266
  logic [12:0] select_1166;
  assign select_1166 = and_1164 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:267
  logic [23:0] select_1168;
  assign select_1168 = equal_1140_s4_q ? {11'h0, select_1166} : (sharpness_sums_detail_0_q + {11'h0, select_1166});
  // hls/stages/agreement.hpp:240
  logic and_1175;
  assign and_1175 = and_1158 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:264
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, detail_2};
  // hls/stages/census.hpp:266
  logic [12:0] select_1177;
  assign select_1177 = and_1175 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:267
  logic [23:0] select_1179;
  assign select_1179 = equal_1140_s4_q ? {11'h0, select_1177} : (sharpness_sums_detail_1_q + {11'h0, select_1177});
  logic [8:0] select_1182;
  assign select_1182 = and_1164 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_1183;
  assign sum_1183 = (equal_1140_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1182};
  logic [8:0] select_1186;
  assign select_1186 = and_1175 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_1187;
  assign sum_1187 = (equal_1140_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1186};
  // hls/stages/agreement.hpp:554
  logic [13:0] select_1331;
  assign select_1331 = and_1324_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1329_s4_q});
  // hls/stages/agreement.hpp:298
  logic and_1334;
  assign and_1334 = not_340_s4_q & (not_481_s4_q & (begins_product_q & textured_s4_q));
  logic and_1339;
  assign and_1339 = not_340_s4_q & (not_481_s4_q & (begins_product_q & explained_s4_q));
  logic and_1344;
  assign and_1344 = not_340_s4_q & (not_481_s4_q & (begins_product_q & near_s4_q));
  // hls/stages/agreement.hpp:692
  logic or_1350;
  assign or_1350 = is_seen | or_1349_s4_q;
  // hls/stages/agreement.hpp:298
  logic and_1354;
  assign and_1354 = not_340_s4_q & (not_481_s4_q & (begins_product_q & (~or_1350)));
  // hls/stages/agreement.hpp:716
  logic less_1357;
  assign less_1357 = region_row_s4_q < x_s4_q[5:3];
  logic [11:0] select_1358;
  assign select_1358 = less_1357 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1361;
  assign select_1361 = less_1357 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:717
  logic [12:0] sum_1362;
  assign sum_1362 = {1'b0, select_1361} + {3'h0, select_1361[11:2]};
  logic and_1364;
  assign and_1364 = (~(select_1358[11:4] == 8'h0)) & ({sum_1362, select_1361[1:0]} < {3'h0, select_1358});
  // hls/stages/agreement.hpp:298
  logic [11:0] select_1367;
  assign select_1367 = equal_880_s4_q ? (equal_881_s4_q ? 12'h0 : (and_1364 ? select_1358 : 12'h0)) : 12'h0;
  logic [11:0] select_1369;
  assign select_1369 = equal_341_s4_q ? 12'h0 : (begins_product_q ? 12'h0 : select_1367);
  logic [11:0] select_1370;
  assign select_1370 = equal_339_s4_q ? 12'h0 : select_1369;
  // hls/stages/agreement.hpp:554
  logic [13:0] select_1372;
  assign select_1372 = and_1324_s4_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1370});
  // hls/stages/agreement.hpp:162
  logic [8:0] select_1382;
  assign select_1382 = less_342_s4_q ? 9'h0 : (and_891_s4_q ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0);
  // hls/stages/agreement.hpp:298
  logic [20:0] select_1383;
  assign select_1383 = begins_product_q ? {{12{select_1382[8]}}, select_1382} : {1'b0, select_1367, 8'h0};
  logic [20:0] select_1385;
  assign select_1385 = equal_339_s4_q ? 21'h0 : (equal_341_s4_q ? 21'h0 : select_1383);
  // hls/stages/agreement.hpp:554
  logic [23:0] select_1387;
  assign select_1387 = and_1324_s4_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1385[20]}}, select_1385});
  // hls/stages/agreement.hpp:596
  logic [8:0] select_1389;
  assign select_1389 = and_891_s4_q ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1390;
  assign select_1390 = less_342_s4_q ? 8'h0 : select_1389[7:0];
  // hls/stages/agreement.hpp:162
  logic and_1391;
  assign and_1391 = not_343_s4_q & select_1389[8];
  // hls/stages/agreement.hpp:696
  logic [2:0] select_1393;
  assign select_1393 = or_1350 ? {3{and_1391}} : ({3{and_1391}} + 3'h1);
  // hls/stages/agreement.hpp:298
  logic [10:0] select_1395;
  assign select_1395 = equal_341_s4_q ? 11'h0 : (begins_product_q ? {select_1393, select_1390} : 11'h0);
  logic [10:0] select_1396;
  assign select_1396 = equal_339_s4_q ? 11'h0 : select_1395;
  // hls/stages/agreement.hpp:546
  logic [23:0] sum_1397;
  assign sum_1397 = counts_too_much_unproven_q + {{13{select_1396[10]}}, select_1396};
  // hls/stages/agreement.hpp:619
  logic [7:0] select_1451;
  assign select_1451 = equal_1412_s4_q ? 8'h0 : (equal_1413_s4_q ? 8'h0 : residual_s4_q);
  // hls/stages/agreement.hpp:162
  logic [7:0] select_1454;
  assign select_1454 = less_342_s4_q ? 8'h0 : (and_1408_s4_q ? (equal_1411_s4_q ? 8'h0 : select_1451) : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1457;
  assign select_1457 = equal_339_s4_q ? 8'h0 : (equal_341_s4_q ? 8'h0 : (begins_product_q ? select_1454 : 8'h0));
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1459;
  assign select_1459 = and_1324_s4_q ? 20'h0 : (counts_across_0_q + {{12{select_1457[7]}}, select_1457});
  // hls/stages/agreement.hpp:619
  logic [7:0] select_1461;
  assign select_1461 = equal_1412_s4_q ? 8'h0 : (equal_1413_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:162
  logic [7:0] select_1464;
  assign select_1464 = less_342_s4_q ? 8'h0 : (and_1408_s4_q ? (equal_1411_s4_q ? 8'h0 : select_1461) : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1467;
  assign select_1467 = equal_339_s4_q ? 8'h0 : (equal_341_s4_q ? 8'h0 : (begins_product_q ? select_1464 : 8'h0));
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1469;
  assign select_1469 = and_1324_s4_q ? 20'h0 : (counts_across_1_q + {{12{select_1467[7]}}, select_1467});
  // hls/stages/agreement.hpp:619
  logic [7:0] select_1471;
  assign select_1471 = equal_1411_s4_q ? 8'h0 : (equal_1412_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1474;
  assign select_1474 = begins_product_q ? (less_342_s4_q ? 8'h0 : (and_1408_s4_q ? select_1471 : 8'h0)) : 8'h0;
  logic [7:0] select_1476;
  assign select_1476 = equal_339_s4_q ? 8'h0 : (equal_341_s4_q ? 8'h0 : select_1474);
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1478;
  assign select_1478 = and_1324_s4_q ? 20'h0 : (counts_across_2_q + {{12{select_1476[7]}}, select_1476});
  // hls/stages/agreement.hpp:162
  logic [7:0] select_1481;
  assign select_1481 = less_342_s4_q ? 8'h0 : (and_1408_s4_q ? (equal_1411_s4_q ? residual_s4_q : 8'h0) : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1484;
  assign select_1484 = equal_339_s4_q ? 8'h0 : (equal_341_s4_q ? 8'h0 : (begins_product_q ? select_1481 : 8'h0));
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1486;
  assign select_1486 = and_1324_s4_q ? 20'h0 : (counts_across_3_q + {{12{select_1484[7]}}, select_1484});
  // hls/stages/agreement.hpp:162
  logic and_1524;
  assign and_1524 = and_1408_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1526;
  assign select_1526 = begins_product_q ? (less_342_s4_q ? 2'h0 : {and_1524, and_1408_s4_q}) : 2'h0;
  logic [1:0] to_down;
  assign to_down = equal_339_s4_q ? 2'h0 : (equal_341_s4_q ? 2'h0 : select_1526);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1530;
  assign select_1530 = and_1324_s4_q ? 15'h0 : (counts_votes_0_down_q + {{13{to_down[1]}}, to_down});
  // hls/stages/agreement.hpp:712
  logic and_1736;
  assign and_1736 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:719
  logic [12:0] sum_1740;
  assign sum_1740 = {1'b0, select_1361} + {2'h0, select_1361[11:1]};
  logic select_1743;
  assign select_1743 = (select_1358[11:3] == 9'h0) ? (and_1736 & (~less_1737_s4_q)) : (~({sum_1740, select_1361[0]} < {2'h0, select_1358}));
  // hls/stages/agreement.hpp:727
  logic [47:0] select_1744;
  assign select_1744 = equal_881_s4_q ? good_next_q : {select_1743, good_next_q[47:1]};
  // hls/stages/agreement.hpp:298
  logic [47:0] select_1746;
  assign select_1746 = equal_880_s4_q ? (equal_1731_s4_q ? select_1744 : good_q) : good_q;
  logic [47:0] select_1748;
  assign select_1748 = equal_341_s4_q ? good_q : (begins_product_q ? good_q : select_1746);
  logic [47:0] select_1751;
  assign select_1751 = begins_product_q ? good_next_q : (equal_880_s4_q ? select_1744 : good_next_q);
  logic [47:0] select_1753;
  assign select_1753 = equal_339_s4_q ? good_next_q : (equal_341_s4_q ? good_next_q : select_1751);
  // hls/stages/agreement.hpp:744
  logic [35:0] select_1774;
  assign select_1774 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:738
  logic [35:0] detail_left;
  assign detail_left = begins_product_s4_q ? 36'h0 : select_1774;
  // hls/stages/agreement.hpp:744
  logic [35:0] select_1777;
  assign select_1777 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:748
  logic [35:0] detail_right;
  assign detail_right = begins_product_s4_q ? 36'h0 : select_1777;
  // hls/stages/agreement.hpp:738
  logic [34:0] select_1779;
  assign select_1779 = begins_product_s4_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:748
  logic [34:0] select_1780;
  assign select_1780 = begins_product_s4_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:738
  logic [17:0] select_1781;
  assign select_1781 = begins_product_s4_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:748
  logic [17:0] select_1782;
  assign select_1782 = begins_product_s4_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:298
  logic [4:0] select_1783;
  assign select_1783 = begins_product_q ? {2'h0, textured_2_s4_q} : box_textured_columns_values_0_q;
  logic [4:0] select_1785;
  assign select_1785 = equal_339_s4_q ? box_textured_columns_values_0_q : (equal_341_s4_q ? box_textured_columns_values_0_q : select_1783);
  logic [4:0] select_1786;
  assign select_1786 = begins_product_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1788;
  assign select_1788 = equal_339_s4_q ? box_textured_columns_values_1_q : (equal_341_s4_q ? box_textured_columns_values_1_q : select_1786);
  logic [4:0] select_1789;
  assign select_1789 = begins_product_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1791;
  assign select_1791 = equal_339_s4_q ? box_textured_columns_values_2_q : (equal_341_s4_q ? box_textured_columns_values_2_q : select_1789);
  logic [4:0] select_1792;
  assign select_1792 = begins_product_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1794;
  assign select_1794 = equal_339_s4_q ? box_textured_columns_values_3_q : (equal_341_s4_q ? box_textured_columns_values_3_q : select_1792);
  logic [4:0] select_1795;
  assign select_1795 = begins_product_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1797;
  assign select_1797 = equal_339_s4_q ? box_textured_columns_values_4_q : (equal_341_s4_q ? box_textured_columns_values_4_q : select_1795);
  logic [4:0] select_1799;
  assign select_1799 = equal_341_s4_q ? box_textured_sum_sums_values_0_q : (begins_product_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1801;
  assign select_1801 = begins_product_q ? {2'h0, explained_2_s4_q} : box_explained_columns_values_0_q;
  logic [4:0] select_1803;
  assign select_1803 = equal_339_s4_q ? box_explained_columns_values_0_q : (equal_341_s4_q ? box_explained_columns_values_0_q : select_1801);
  logic [4:0] select_1804;
  assign select_1804 = begins_product_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1806;
  assign select_1806 = equal_339_s4_q ? box_explained_columns_values_1_q : (equal_341_s4_q ? box_explained_columns_values_1_q : select_1804);
  logic [4:0] select_1807;
  assign select_1807 = begins_product_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1809;
  assign select_1809 = equal_339_s4_q ? box_explained_columns_values_2_q : (equal_341_s4_q ? box_explained_columns_values_2_q : select_1807);
  logic [4:0] select_1810;
  assign select_1810 = begins_product_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1812;
  assign select_1812 = equal_339_s4_q ? box_explained_columns_values_3_q : (equal_341_s4_q ? box_explained_columns_values_3_q : select_1810);
  logic [4:0] select_1813;
  assign select_1813 = begins_product_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1815;
  assign select_1815 = equal_339_s4_q ? box_explained_columns_values_4_q : (equal_341_s4_q ? box_explained_columns_values_4_q : select_1813);
  logic [4:0] select_1817;
  assign select_1817 = equal_341_s4_q ? box_explained_sum_sums_values_0_q : (begins_product_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1819;
  assign select_1819 = begins_product_q ? {2'h0, near_2_s4_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_1821;
  assign select_1821 = equal_339_s4_q ? box_nearer_columns_values_0_q : (equal_341_s4_q ? box_nearer_columns_values_0_q : select_1819);
  logic [4:0] select_1822;
  assign select_1822 = begins_product_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1824;
  assign select_1824 = equal_339_s4_q ? box_nearer_columns_values_1_q : (equal_341_s4_q ? box_nearer_columns_values_1_q : select_1822);
  logic [4:0] select_1825;
  assign select_1825 = begins_product_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1827;
  assign select_1827 = equal_339_s4_q ? box_nearer_columns_values_2_q : (equal_341_s4_q ? box_nearer_columns_values_2_q : select_1825);
  logic [4:0] select_1828;
  assign select_1828 = begins_product_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1830;
  assign select_1830 = equal_339_s4_q ? box_nearer_columns_values_3_q : (equal_341_s4_q ? box_nearer_columns_values_3_q : select_1828);
  logic [4:0] select_1831;
  assign select_1831 = begins_product_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_1833;
  assign select_1833 = equal_339_s4_q ? box_nearer_columns_values_4_q : (equal_341_s4_q ? box_nearer_columns_values_4_q : select_1831);
  logic [4:0] select_1835;
  assign select_1835 = equal_341_s4_q ? box_nearer_sum_sums_values_0_q : (begins_product_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:847
  logic [1:0] select_1876;
  assign select_1876 = and_1875_s4_q ? {and_1015, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:848
  logic and_1877;
  assign and_1877 = proven_q & less_1865;
  // hls/stages/agreement.hpp:176
  logic select_1880;
  assign select_1880 = and_948_s4_q ? (less_949_s4_q ? (select_1876[0] & and_1877) : seen_q) : seen_q;
  logic select_1883;
  assign select_1883 = and_948_s4_q ? (less_949_s4_q ? (select_1876[1] & and_1877) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:298
  logic [13:0] select_1888;
  assign select_1888 = equal_880_s4_q ? (equal_1731_s4_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_1890;
  assign select_1890 = equal_341_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1888);
  logic [13:0] select_1893;
  assign select_1893 = equal_880_s4_q ? (equal_1731_s4_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_1895;
  assign select_1895 = equal_341_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1893);
  logic [13:0] select_1898;
  assign select_1898 = equal_880_s4_q ? (equal_1731_s4_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_1900;
  assign select_1900 = equal_341_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1898);
  logic [13:0] select_1903;
  assign select_1903 = equal_880_s4_q ? (equal_1731_s4_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_1905;
  assign select_1905 = equal_341_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1903);
  logic [13:0] select_1908;
  assign select_1908 = equal_880_s4_q ? (equal_1731_s4_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_1910;
  assign select_1910 = equal_341_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1908);
  logic [13:0] select_1913;
  assign select_1913 = equal_880_s4_q ? (equal_1731_s4_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic [13:0] select_1915;
  assign select_1915 = equal_341_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_1913);
  // hls/stages/agreement.hpp:764
  logic not_1924;
  assign not_1924 = ~and_1736;
  // hls/stages/agreement.hpp:298
  logic and_1928;
  assign and_1928 = not_1237_s4_q & (equal_880_s4_q & (equal_1731_s4_q & (cfg_prove_i & not_1924)));
  // hls/stages/agreement.hpp:765
  logic or_1931;
  assign or_1931 = not_1884 | not_1924;
  // hls/stages/agreement.hpp:731
  logic or_1936;
  assign or_1936 = ($signed(24'h0) < $signed(counts_too_many_bad_q)) | ($signed(24'h0) < $signed(counts_too_much_unproven_q));
  // hls/stages/agreement.hpp:298
  logic and_1938;
  assign and_1938 = equal_1731_s4_q & ((less_1737_s4_q | or_1931) ? (~or_1931) : or_1936);
  logic and_1942;
  assign and_1942 = not_340_s4_q & (not_481_s4_q & (not_1237_s4_q & (equal_880_s4_q & and_1938)));
  // hls/stages/agreement.hpp:731
  logic select_2006;
  assign select_2006 = or_1966_s4_q ? select_2003_s4_q : or_2005_s4_q;
  logic or_2008;
  assign or_2008 = less_2007_s4_q | select_2006;
  logic select_2009;
  assign select_2009 = or_1959_s4_q ? select_2006 : or_2008;
  logic or_2011;
  assign or_2011 = less_2010_s4_q | select_2009;
  logic or_2013;
  assign or_2013 = ($signed(15'h0) < $signed(counts_votes_0_down_q)) | (or_1952_s4_q ? select_2009 : or_2011);
  logic select_2016;
  assign select_2016 = less_1954_s4_q ? or_2008 : (less_1960_s4_q ? or_2005_s4_q : select_2014_s4_q);
  logic select_2018;
  assign select_2018 = less_1946_s4_q ? or_2013 : (less_1949_s4_q ? or_2011 : select_2016);
  // hls/stages/agreement.hpp:298
  logic and_2022;
  assign and_2022 = not_1237_s4_q & (equal_880_s4_q & (equal_1731_s4_q & (cfg_prove_i & select_2018)));
  // hls/stages/agreement.hpp:771
  logic and_2025;
  assign and_2025 = cfg_prove_i & and_1736;
  // hls/stages/agreement.hpp:772
  logic [36:0] sum_2026;
  assign sum_2026 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2028;
  assign less_2028 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:731
  logic or_2031;
  assign or_2031 = ({detail_left, 3'h0} < {sum_2026, detail_right[1:0]}) | (less_2028 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:298
  logic and_2035;
  assign and_2035 = not_1237_s4_q & (equal_880_s4_q & (equal_1731_s4_q & (and_2025 & or_2031)));
  // hls/stages/agreement.hpp:775
  logic [36:0] sum_2038;
  assign sum_2038 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2040;
  assign less_2040 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:731
  logic or_2041;
  assign or_2041 = ({detail_right, 3'h0} < {sum_2038, detail_left[1:0]}) | less_2040;
  // hls/stages/agreement.hpp:298
  logic and_2045;
  assign and_2045 = not_1237_s4_q & (equal_880_s4_q & (equal_1731_s4_q & (and_2025 & or_2041)));
  logic [19:0] select_2060;
  assign select_2060 = equal_880_s4_q ? (equal_1731_s4_q ? counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2062;
  assign select_2062 = equal_341_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2060);
  logic [19:0] select_2065;
  assign select_2065 = equal_880_s4_q ? (equal_1731_s4_q ? counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2067;
  assign select_2067 = equal_341_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2065);
  logic [19:0] select_2070;
  assign select_2070 = equal_880_s4_q ? (equal_1731_s4_q ? counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2072;
  assign select_2072 = equal_341_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2070);
  logic [19:0] select_2075;
  assign select_2075 = equal_880_s4_q ? (equal_1731_s4_q ? counts_across_3_q : 20'h0) : 20'h0;
  logic [19:0] select_2077;
  assign select_2077 = equal_341_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2075);
  logic [23:0] select_2100;
  assign select_2100 = equal_880_s4_q ? (equal_1731_s4_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2102;
  assign select_2102 = equal_341_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2100);
  logic [23:0] select_2105;
  assign select_2105 = equal_880_s4_q ? (equal_1731_s4_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2107;
  assign select_2107 = equal_341_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2105);
  logic [23:0] select_2110;
  assign select_2110 = equal_880_s4_q ? (equal_1731_s4_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2112;
  assign select_2112 = equal_341_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2110);
  logic [23:0] select_2115;
  assign select_2115 = equal_880_s4_q ? (equal_1731_s4_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2117;
  assign select_2117 = equal_341_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2115);
  logic [5:0] select_2124;
  assign select_2124 = begins_product_q ? 6'h0 : (equal_880_s4_q ? (equal_881_s4_q ? 6'h0 : x_s4_q) : 6'h0);
  logic [11:0] select_2129;
  assign select_2129 = begins_product_q ? 12'h0 : (equal_880_s4_q ? (equal_881_s4_q ? 12'h0 : select_1358) : 12'h0);
  logic [11:0] select_2134;
  assign select_2134 = begins_product_q ? 12'h0 : (equal_880_s4_q ? (equal_881_s4_q ? 12'h0 : select_1361) : 12'h0);
  // hls/stages/agreement.hpp:727
  logic [11:0] select_2138;
  assign select_2138 = equal_881_s4_q ? 12'h0 : (less_1357 ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:298
  logic [11:0] select_2140;
  assign select_2140 = begins_product_q ? 12'h0 : (equal_880_s4_q ? select_2138 : 12'h0);

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = select_297_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_327_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {and_427, and_403_s4_q, and_402_s4_q, and_377_s4_q, less_370_s4_q, less_369_s4_q, less_368_s4_q, less_367_s4_q, less_366_s4_q, less_365_s4_q, less_364_s4_q, less_363_s4_q, less_362_s4_q, less_361_s4_q, less_360_s4_q, less_359_s4_q, less_358_s4_q, less_357_s4_q, less_356_s4_q, less_355_s4_q, less_354_s4_q, less_353_s4_q, less_352_s4_q, less_351_s4_q, less_350_s4_q, less_349_s4_q, less_348_s4_q, less_347_s4_q};
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
  assign best_left_we = s4_en & and_848_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_847, select_799_s4_q, select_795_s4_q};
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
  assign regions_waddr = {region_row_s4_q, or_873_s4_q, or_870_s4_q, or_867_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_920_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_917, sum_907, sum_896};
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
  assign map_waddr = {sum_954_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_1026_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1015, is_seen};
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
      counts_across_0_q <= 20'h0;
      counts_across_1_q <= 20'h0;
      counts_across_2_q <= 20'h0;
      counts_across_3_q <= 20'h0;
      counts_votes_0_down_q <= 15'h0;
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
      census_left_misses_q <= select_1149;
      sharpness_sums_detail_0_q <= and_327_s4_q ? select_1168 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_327_s4_q ? select_1179 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_327_s4_q ? sum_1183 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_327_s4_q ? sum_1187 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1331;
      counts_textured_q <= and_1324_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_1334});
      counts_explained_q <= and_1324_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_1339});
      counts_nearer_q <= and_1324_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1344});
      counts_unproven_q <= and_1324_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1354});
      counts_regions_bad_q <= select_1372;
      counts_too_many_bad_q <= select_1387;
      counts_too_much_unproven_q <= and_1324_s4_q ? 24'h0 : sum_1397;
      counts_across_0_q <= select_1459;
      counts_across_1_q <= select_1469;
      counts_across_2_q <= select_1478;
      counts_across_3_q <= select_1486;
      counts_votes_0_down_q <= select_1530;
      segment_textured_q <= select_893 + {6'h0, and_1334};
      segment_explained_q <= select_904 + {6'h0, and_1339};
      segment_nearer_q <= select_914 + {6'h0, and_1344};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_339_s4_q ? good_q : select_1748;
      good_next_q <= select_1753;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1779;
      addend_1_q <= select_1780;
      multiplier_0_q <= select_1781;
      multiplier_1_q <= select_1782;
      seen_q <= select_1880;
      nearer_q <= select_1883;
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
      averager_quarter_1_0_q <= and_326_s4_q ? grey_s4_q : averager_quarter_1_0_q;
      averager_quarter_1_1_q <= and_326_s4_q ? grey_2_s4_q : averager_quarter_1_1_q;
      averager_quarter_2_0_q <= and_326_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q;
      averager_quarter_2_1_q <= and_326_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q;
      averager_detail_0_q <= and_326_s4_q ? detail : averager_detail_0_q;
      averager_detail_1_q <= and_326_s4_q ? detail_2 : averager_detail_1_q;
      census_changes_values_0_left_q <= and_327_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_327_s4_q ? sum_1133_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1135;
      census_changes_values_1_right_q <= select_1136;
      census_changes_values_2_left_q <= select_1137;
      census_changes_values_2_right_q <= select_1138;
      sharpness_last_mask_q <= and_327_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_327_s4_q ? detail : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_327_s4_q ? detail_2 : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_1785;
      box_textured_columns_values_1_q <= select_1788;
      box_textured_columns_values_2_q <= select_1791;
      box_textured_columns_values_3_q <= select_1794;
      box_textured_columns_values_4_q <= select_1797;
      box_textured_sum_sums_values_0_q <= equal_339_s4_q ? box_textured_sum_sums_values_0_q : select_1799;
      box_explained_columns_values_0_q <= select_1803;
      box_explained_columns_values_1_q <= select_1806;
      box_explained_columns_values_2_q <= select_1809;
      box_explained_columns_values_3_q <= select_1812;
      box_explained_columns_values_4_q <= select_1815;
      box_explained_sum_sums_values_0_q <= equal_339_s4_q ? box_explained_sum_sums_values_0_q : select_1817;
      box_nearer_columns_values_0_q <= select_1821;
      box_nearer_columns_values_1_q <= select_1824;
      box_nearer_columns_values_2_q <= select_1827;
      box_nearer_columns_values_3_q <= select_1830;
      box_nearer_columns_values_4_q <= select_1833;
      box_nearer_sum_sums_values_0_q <= equal_339_s4_q ? box_nearer_sum_sums_values_0_q : select_1835;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_1860_s5_q;
  logic or_1885_s5_q;
  logic and_1886_s5_q;
  logic [13:0] select_1891_s5_q;
  logic [13:0] select_1896_s5_q;
  logic [13:0] select_1901_s5_q;
  logic [13:0] select_1906_s5_q;
  logic [13:0] select_1911_s5_q;
  logic [13:0] select_1916_s5_q;
  logic and_1923_s5_q;
  logic and_1930_s5_q;
  logic and_1942_s5_q;
  logic and_2024_s5_q;
  logic and_2037_s5_q;
  logic and_2047_s5_q;
  logic and_2058_s5_q;
  logic [19:0] select_2063_s5_q;
  logic [19:0] select_2068_s5_q;
  logic [19:0] select_2073_s5_q;
  logic [19:0] select_2078_s5_q;
  logic [11:0] select_2083_s5_q;
  logic [11:0] select_2088_s5_q;
  logic [11:0] select_2093_s5_q;
  logic [11:0] select_2098_s5_q;
  logic [23:0] select_2103_s5_q;
  logic [23:0] select_2108_s5_q;
  logic [23:0] select_2113_s5_q;
  logic [23:0] select_2118_s5_q;
  logic and_2121_s5_q;
  logic [5:0] select_2126_s5_q;
  logic [11:0] select_2131_s5_q;
  logic [11:0] select_2136_s5_q;
  logic [11:0] select_2142_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_1860_s5_q <= said_q;
      or_1885_s5_q <= not_1884 | select_1880;
      and_1886_s5_q <= cfg_prove_i & select_1883;
      select_1891_s5_q <= equal_339_s4_q ? 14'h0 : select_1890;
      select_1896_s5_q <= equal_339_s4_q ? 14'h0 : select_1895;
      select_1901_s5_q <= equal_339_s4_q ? 14'h0 : select_1900;
      select_1906_s5_q <= equal_339_s4_q ? 14'h0 : select_1905;
      select_1911_s5_q <= equal_339_s4_q ? 14'h0 : select_1910;
      select_1916_s5_q <= equal_339_s4_q ? 14'h0 : select_1915;
      and_1923_s5_q <= and_1923_s4_q;
      and_1930_s5_q <= not_340_s4_q & (not_481_s4_q & and_1928);
      and_1942_s5_q <= and_1942;
      and_2024_s5_q <= not_340_s4_q & (not_481_s4_q & and_2022);
      and_2037_s5_q <= not_340_s4_q & (not_481_s4_q & and_2035);
      and_2047_s5_q <= not_340_s4_q & (not_481_s4_q & and_2045);
      and_2058_s5_q <= and_2058_s4_q;
      select_2063_s5_q <= equal_339_s4_q ? 20'h0 : select_2062;
      select_2068_s5_q <= equal_339_s4_q ? 20'h0 : select_2067;
      select_2073_s5_q <= equal_339_s4_q ? 20'h0 : select_2072;
      select_2078_s5_q <= equal_339_s4_q ? 20'h0 : select_2077;
      select_2083_s5_q <= select_2083_s4_q;
      select_2088_s5_q <= select_2088_s4_q;
      select_2093_s5_q <= select_2093_s4_q;
      select_2098_s5_q <= select_2098_s4_q;
      select_2103_s5_q <= equal_339_s4_q ? 24'h0 : select_2102;
      select_2108_s5_q <= equal_339_s4_q ? 24'h0 : select_2107;
      select_2113_s5_q <= equal_339_s4_q ? 24'h0 : select_2112;
      select_2118_s5_q <= equal_339_s4_q ? 24'h0 : select_2117;
      and_2121_s5_q <= and_2121_s4_q;
      select_2126_s5_q <= equal_339_s4_q ? 6'h0 : (equal_341_s4_q ? 6'h0 : select_2124);
      select_2131_s5_q <= equal_339_s4_q ? 12'h0 : (equal_341_s4_q ? 12'h0 : select_2129);
      select_2136_s5_q <= equal_339_s4_q ? 12'h0 : (equal_341_s4_q ? 12'h0 : select_2134);
      select_2142_s5_q <= equal_339_s4_q ? 12'h0 : (equal_341_s4_q ? 12'h0 : select_2140);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign pixel_1_o = pixel_1_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_1885_s5_q;
  assign marks_nearer_o = and_1886_s5_q;
  assign verdict_valid_o = and_1860_s5_q;
  assign verdict_supervised_o = {2'h0, select_1891_s5_q};
  assign verdict_textured_o = {2'h0, select_1896_s5_q};
  assign verdict_explained_o = {2'h0, select_1901_s5_q};
  assign verdict_nearer_o = {2'h0, select_1906_s5_q};
  assign verdict_unproven_o = {2'h0, select_1911_s5_q};
  assign verdict_regions_bad_o = {2'h0, select_1916_s5_q};
  assign verdict_unproven_yet_o = and_1923_s5_q;
  assign verdict_untextured_o = and_1930_s5_q;
  assign verdict_disagree_o = and_1942_s5_q;
  assign verdict_moved_o = and_2024_s5_q;
  assign verdict_unsharp_left_o = and_2037_s5_q;
  assign verdict_unsharp_right_o = and_2047_s5_q;
  assign verdict_hidden_o = and_2058_s5_q;
  assign verdict_across_0_o = select_2063_s5_q;
  assign verdict_across_1_o = select_2068_s5_q;
  assign verdict_across_2_o = select_2073_s5_q;
  assign verdict_across_3_o = select_2078_s5_q;
  assign verdict_measured_0_o = select_2083_s5_q;
  assign verdict_measured_1_o = select_2088_s5_q;
  assign verdict_measured_2_o = select_2093_s5_q;
  assign verdict_measured_3_o = select_2098_s5_q;
  assign verdict_detail_0_o = select_2103_s5_q;
  assign verdict_detail_1_o = select_2108_s5_q;
  assign verdict_contrast_0_o = select_2113_s5_q;
  assign verdict_contrast_1_o = select_2118_s5_q;
  assign region_valid_o = and_2121_s5_q;
  assign region_region_o = select_2126_s5_q;
  assign region_textured_o = select_2131_s5_q;
  assign region_explained_o = select_2136_s5_q;
  assign region_nearer_o = select_2142_s5_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_1945[2:0], sum_1440[0], sum_1436[0], sum_1428[1:0], sum_1427[1:0], sum_1423[0], detail_4[1:0], detail_3[1:0], sum_1143[4:0], sum_840[9:0], sum_425[4:0], cfg_width_i[2:0]};

endmodule
