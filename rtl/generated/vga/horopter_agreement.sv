// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1867 bits, pipeline 631 bits, memories 70060 bits.
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
  output logic verdict_unproven_yet_o,
  output logic verdict_untextured_o,
  output logic verdict_disagree_o,
  output logic verdict_moved_o,
  output logic verdict_unsharp_left_o,
  output logic verdict_unsharp_right_o,
  output logic verdict_hidden_o,
  output logic frame_valid_o,
  output logic [5:0] frame_index_o,
  output logic [31:0] frame_word_o
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
  logic [5:0] sum_2412;
  assign sum_2412 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_2758;
  assign difference_2758 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2962;
  assign less_2962 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2963;
  assign sum_2963 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_2981;
  assign not_2981 = ~cfg_prove_i;

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
  logic [5:0] run_shift_q;
  logic run_last_shift_q;
  logic [7:0] run_span_q;
  logic [2:0] following_phase_q;
  logic [5:0] following_shift_q;
  logic following_last_shift_q;
  logic [7:0] following_span_q;
  logic [6:0] following_lowest_q;
  logic [7:0] following_columns_q;
  logic [5:0] plan_shift_q;
  logic [7:0] plan_span_q;
  logic [7:0] plan_columns_q;
  logic [7:0] x_q;
  logic [7:0] columns_left_q;
  logic [6:0] last_q;
  logic [6:0] least_q;
  logic [7:0] whole_q;
  logic [7:0] drawn_q;
  logic [6:0] age_q;
  logic [2:0] slot_q;
  logic ends_cell_q;
  logic ends_q;
  logic final_row_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_320;
  assign select_320 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_322;
  assign select_322 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [8:0] select_325;
  assign select_325 = ({select_322, select_320} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:95
  logic [8:0] select_326;
  assign select_326 = select_320[0] ? averager_place_q : select_325;
  // hls/stages/census.hpp:40
  logic or_327;
  assign or_327 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:213
  logic and_333;
  assign and_333 = (~((~or_327) | (~select_320[0]))) & (select_326[8:6] < 3'h5);
  // hls/stages/census.hpp:40
  logic [2:0] select_338;
  assign select_338 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:213
  logic whole;
  assign whole = select_320[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:215
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_322 : 7'h0;
  // hls/stages/census.hpp:45
  logic equal_355;
  assign equal_355 = select_320 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_356;
  assign equal_356 = select_338 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_357;
  assign and_357 = equal_356 & and_333;
  // hls/stages/agreement.hpp:215
  logic and_359;
  assign and_359 = sample_pair_whole_q & (equal_355 & and_357);
  // hls/stages/agreement.hpp:134
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:406
  logic equal_379;
  assign equal_379 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:391
  logic or_380;
  assign or_380 = so | equal_379;
  logic not_381;
  assign not_381 = ~or_380;
  // hls/stages/agreement.hpp:397
  logic equal_382;
  assign equal_382 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:398
  logic equal_384;
  assign equal_384 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:389
  logic [7:0] sum_385;
  assign sum_385 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:391
  logic [7:0] select_386;
  assign select_386 = run_shift_q[5] ? x_q : sum_385;
  logic less_387;
  assign less_387 = {1'b0, last_q} < select_386;
  // hls/stages/agreement.hpp:163
  logic not_388;
  assign not_388 = ~less_387;
  // hls/stages/agreement.hpp:554
  logic and_389;
  assign and_389 = equal_384 & not_388;
  logic and_391;
  assign and_391 = not_381 & ((~equal_382) & and_389);
  // hls/stages/census.hpp:40
  logic [5:0] select_418;
  assign select_418 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:215
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_418 : 6'h0;
  // hls/stages/agreement.hpp:554
  logic select_475;
  assign select_475 = equal_382 ? not_388 : and_389;
  // hls/stages/agreement.hpp:596
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:191
  logic and_499;
  assign and_499 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_386)));
  logic and_500;
  assign and_500 = equal_382 & and_499;
  logic select_501;
  assign select_501 = or_380 ? not_388 : and_500;
  // hls/stages/agreement.hpp:601
  logic equal_504;
  assign equal_504 = {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:605
  logic or_506;
  assign or_506 = equal_504 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:617
  logic [6:0] right;
  assign right = sum_385[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:746
  logic [5:0] sum_1881;
  assign sum_1881 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:215
  logic [2:0] select_2065;
  assign select_2065 = sample_pair_whole_q ? (sample_last_q ? (select_338 + 3'h1) : select_338) : raster_at_y_q;
  logic [6:0] select_2067;
  assign select_2067 = sample_pair_whole_q ? (select_322 + {6'h0, equal_355}) : raster_at_column_q;
  logic [5:0] select_2070;
  assign select_2070 = sample_pair_whole_q ? (sample_last_q ? (select_418 + {5'h0, equal_356}) : select_418) : raster_at_row_q;
  logic select_2074;
  assign select_2074 = sample_pair_whole_q ? (sample_last_q ? (or_327 & (~raster_final_row_q)) : or_327) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_2076;
  assign select_2076 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:215
  logic select_2080;
  assign select_2080 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:313
  logic equal_2321;
  assign equal_2321 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:318
  logic and_2322;
  assign and_2322 = and_359 & equal_2321;
  // hls/stages/agreement.hpp:368
  logic select_2325;
  assign select_2325 = (and_2322 | (~ends_cell_q)) ? and_2322 : ends_q;
  // hls/stages/agreement.hpp:374
  logic [2:0] now;
  assign now = select_2325 ? (and_2322 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:379
  logic [5:0] select_2329;
  assign select_2329 = select_2325 ? (and_2322 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2332;
  assign select_2332 = select_2325 ? (following_last_shift_q & (~and_2322)) : run_last_shift_q;
  // hls/stages/agreement.hpp:146
  logic and_2335;
  assign and_2335 = run_last_shift_q & equal_382;
  // hls/stages/agreement.hpp:399
  logic select_2337;
  assign select_2337 = equal_382 ? (~run_last_shift_q) : equal_384;
  // hls/stages/agreement.hpp:403
  logic equal_2338;
  assign equal_2338 = run_phase_q == 3'h1;
  logic not_2341;
  assign not_2341 = ~select_2337;
  // hls/stages/agreement.hpp:406
  logic equal_2343;
  assign equal_2343 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:146
  logic and_2344;
  assign and_2344 = final_row_q & so;
  // hls/stages/agreement.hpp:403
  logic [1:0] select_2345;
  assign select_2345 = equal_2343 ? 2'h1 : {2{and_2344}};
  logic [2:0] select_2347;
  assign select_2347 = (and_2335 | (select_2337 | equal_2338)) ? (equal_2338 ? 3'h2 : {not_2341, {2{select_2337}}}) : (equal_379 ? 3'h6 : {select_2345[0], select_2345});
  // hls/stages/agreement.hpp:146
  logic and_2350;
  assign and_2350 = select_2337 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:413
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2353;
  assign select_2353 = (plan_shift_q[5] & select_2337) ? value : 7'h0;
  logic [1:0] or_2354;
  assign or_2354 = {2{so}} | select_2353[5:4];
  // hls/stages/agreement.hpp:416
  logic [7:0] or_2358;
  assign or_2358 = (select_2337 ? plan_columns_q : 8'h0) | ((equal_2338 | equal_2343) ? whole_q : 8'h0);
  logic [1:0] or_2359;
  assign or_2359 = {2{and_2335}} | or_2358[3:2];
  // hls/stages/agreement.hpp:417
  logic [7:0] or_2361;
  assign or_2361 = {or_2358[7:4], or_2359, or_2358[1:0]} | (equal_379 ? drawn_q : 8'h0);
  logic [4:0] or_2362;
  assign or_2362 = {5{so}} | {or_2361[6], or_2361[3:0]};
  // hls/stages/agreement.hpp:423
  logic not_2366;
  assign not_2366 = ~run_shift_q[5];
  logic [7:0] select_2369;
  assign select_2369 = equal_382 ? ({{7{not_2366}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:368
  logic [6:0] select_2373;
  assign select_2373 = and_2322 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:371
  logic [7:0] select_2375;
  assign select_2375 = select_2325 ? {select_2373[6], select_2373} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2378;
  assign select_2378 = select_2325 ? (and_2322 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:365
  logic [6:0] select_2386;
  assign select_2386 = and_359 ? (equal_2321 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2389;
  assign select_2389 = and_359 ? (equal_2321 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2392;
  assign select_2392 = and_359 ? (equal_2321 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:376
  logic select_2403;
  assign select_2403 = (ends_cell_q | select_2325) ? (~(now == 3'h6)) : (equal_382 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:371
  logic and_2407;
  assign and_2407 = (~select_2325) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:329
  logic [6:0] sum_2408;
  assign sum_2408 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:314
  logic select_2410;
  assign select_2410 = equal_2321 ? ({sum_2408[6], cfg_height_i[8:3]} == {1'b0, sum_2408[5:0]}) : final_row_q;

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1070; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_391;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:1071; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (or_380 ? not_388 : select_475);
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:1072; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_382 ? sum_385[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_381 & select_475);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 46 and parity, DISTANCE 12, hls/stages/agreement.hpp:1073; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [46:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 47'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_380 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_501;
  logic [46:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [45:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[45:0];
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
      run_shift_q <= 6'h0;
      run_last_shift_q <= 1'b0;
      run_span_q <= 8'h0;
      following_phase_q <= 3'h0;
      following_shift_q <= 6'h0;
      following_last_shift_q <= 1'b0;
      following_span_q <= 8'h0;
      following_lowest_q <= 7'h0;
      following_columns_q <= 8'h0;
      plan_shift_q <= 6'h0;
      plan_span_q <= 8'h0;
      plan_columns_q <= 8'h0;
      x_q <= 8'h0;
      columns_left_q <= 8'h0;
      last_q <= 7'h0;
      least_q <= 7'h0;
      whole_q <= 8'h0;
      drawn_q <= 8'h0;
      age_q <= 7'h0;
      slot_q <= 3'h0;
      ends_cell_q <= 1'b1;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_320 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2065;
      raster_at_column_q <= select_2067;
      raster_at_row_q <= select_2070;
      raster_at_live_q <= select_2074;
      raster_rows_left_q <= sample_pair_whole_q ? select_2076 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2080;
      averager_place_q <= sample_pair_whole_q ? select_326 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= now;
      run_shift_q <= select_2329;
      run_last_shift_q <= select_2332;
      run_span_q <= select_2325 ? (and_2322 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2347;
      following_shift_q <= select_2337 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2350;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2353[6], or_2354, select_2353[3:0]};
      following_columns_q <= {or_2361[7], or_2362[4], or_2361[5:4], or_2362[3:0]};
      plan_shift_q <= equal_382 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2369;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2375;
      columns_left_q <= select_2378;
      last_q <= and_359 ? (equal_2321 ? column : last_q) : last_q;
      least_q <= select_2386;
      whole_q <= select_2389;
      drawn_q <= select_2392;
      age_q <= select_2325 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2325 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2403;
      ends_q <= and_2407;
      final_row_q <= and_359 ? select_2410 : final_row_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic sample_pair_whole_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [3:0] age_s1_q;
  logic [2:0] slot_s1_q;
  logic ends_cell_s1_q;
  logic select_320_s1_q;
  logic [8:0] select_326_s1_q;
  logic and_333_s1_q;
  logic equal_339_s1_q;
  logic whole_s1_q;
  logic [6:0] column_s1_q;
  logic and_357_s1_q;
  logic and_359_s1_q;
  logic equal_362_s1_q;
  logic so_s1_q;
  logic equal_379_s1_q;
  logic or_380_s1_q;
  logic equal_382_s1_q;
  logic less_387_s1_q;
  logic not_388_s1_q;
  logic and_391_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_501_s1_q;
  logic select_508_s1_q;
  logic and_1783_s1_q;
  logic [6:0] right_s1_q;
  logic select_1790_s1_q;
  logic equal_1799_s1_q;
  logic less_1882_s1_q;
  logic equal_1922_s1_q;
  logic not_2056_s1_q;
  logic equal_2321_s1_q;
  logic and_2322_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      age_s1_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s1_q <= slot_q;
      ends_cell_s1_q <= ends_cell_q;
      select_320_s1_q <= select_320[0];
      select_326_s1_q <= select_326;
      and_333_s1_q <= and_333;
      equal_339_s1_q <= select_338 == 3'h0;
      whole_s1_q <= whole;
      column_s1_q <= column;
      and_357_s1_q <= and_357;
      and_359_s1_q <= and_359;
      equal_362_s1_q <= select_320 == 3'h1;
      so_s1_q <= so;
      equal_379_s1_q <= equal_379;
      or_380_s1_q <= or_380;
      equal_382_s1_q <= equal_382;
      less_387_s1_q <= less_387;
      not_388_s1_q <= not_388;
      and_391_s1_q <= and_391;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_501_s1_q <= select_501;
      select_508_s1_q <= or_506 ? equal_504 : (~age_q[3]);
      and_1783_s1_q <= not_381 & and_500;
      right_s1_q <= right;
      select_1790_s1_q <= or_506 ? equal_504 : ({x[7], last_q} == {1'b0, x[6:0]});
      equal_1799_s1_q <= run_phase_q == 3'h7;
      less_1882_s1_q <= {1'b0, sum_1881, last_q[1]} < x_q;
      equal_1922_s1_q <= x_q == {1'b0, last_q};
      not_2056_s1_q <= ~({sum_1881, last_q[1:0]} < x_q);
      equal_2321_s1_q <= equal_2321;
      and_2322_s1_q <= and_2322;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  logic [5:0] middle_sum_columns_values_0_q;
  logic [5:0] middle_sum_columns_values_1_q;
  logic [5:0] middle_sum_columns_values_2_q;
  logic [5:0] middle_sum_columns_values_3_q;
  logic [5:0] middle_sum_columns_values_4_q;
  logic [5:0] middle_sum_columns_values_5_q;
  logic [5:0] middle_sum_columns_values_6_q;
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [5:0] sums_0_columns_values_0_q;
  logic [5:0] sums_0_columns_values_1_q;
  logic [5:0] sums_0_columns_values_2_q;
  logic [5:0] sums_0_columns_values_3_q;
  logic [5:0] sums_0_columns_values_4_q;
  logic [5:0] sums_0_columns_values_5_q;
  logic [5:0] sums_0_columns_values_6_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [5:0] sums_1_columns_values_0_q;
  logic [5:0] sums_1_columns_values_1_q;
  logic [5:0] sums_1_columns_values_2_q;
  logic [5:0] sums_1_columns_values_3_q;
  logic [5:0] sums_1_columns_values_4_q;
  logic [5:0] sums_1_columns_values_5_q;
  logic [5:0] sums_1_columns_values_6_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [5:0] sums_2_columns_values_0_q;
  logic [5:0] sums_2_columns_values_1_q;
  logic [5:0] sums_2_columns_values_2_q;
  logic [5:0] sums_2_columns_values_3_q;
  logic [5:0] sums_2_columns_values_4_q;
  logic [5:0] sums_2_columns_values_5_q;
  logic [5:0] sums_2_columns_values_6_q;
  logic [7:0] sums_2_sum_sums_values_0_q;
  logic [5:0] sums_3_columns_values_0_q;
  logic [5:0] sums_3_columns_values_1_q;
  logic [5:0] sums_3_columns_values_2_q;
  logic [5:0] sums_3_columns_values_3_q;
  logic [5:0] sums_3_columns_values_4_q;
  logic [5:0] sums_3_columns_values_5_q;
  logic [5:0] sums_3_columns_values_6_q;
  logic [7:0] sums_3_sum_sums_values_0_q;
  // hls/stages/census.hpp:98
  logic and_334;
  assign and_334 = sample_pair_whole_s1_q & and_333_s1_q;
  // hls/stages/agreement.hpp:449
  logic not_479;
  assign not_479 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:452
  logic and_480;
  assign and_480 = left_rdata_q[12] & not_479;
  logic and_481;
  assign and_481 = left_rdata_q[28] & not_479;
  logic and_482;
  assign and_482 = left_rdata_q[44] & not_479;
  logic and_483;
  assign and_483 = left_rdata_q[60] & not_479;
  // hls/stages/agreement.hpp:453
  logic and_487;
  assign and_487 = right_codes_rdata_q[12] & not_479;
  logic and_488;
  assign and_488 = right_codes_rdata_q[25] & not_479;
  logic and_489;
  assign and_489 = right_codes_rdata_q[38] & not_479;
  logic and_490;
  assign and_490 = right_codes_rdata_q[51] & not_479;
  logic and_491;
  assign and_491 = right_codes_rdata_q[64] & not_479;
  logic and_492;
  assign and_492 = right_codes_rdata_q[77] & not_479;
  // hls/stages/agreement.hpp:159
  logic and_514;
  assign and_514 = left_rdata_q[44] & not_388_s1_q;
  logic and_515;
  assign and_515 = right_codes_rdata_q[38] & not_388_s1_q;
  logic [11:0] select_516;
  assign select_516 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_517;
  assign select_517 = less_387_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_521;
  assign select_521 = and_514 ? (and_515 ? (~(select_516 ^ select_517)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_527;
  assign parity_527 = ^select_521[5:3];
  logic parity_530;
  assign parity_530 = ^select_521[8:6];
  logic parity_533;
  assign parity_533 = ^select_521[11:3];
  // hls/stages/agreement.hpp:159
  logic and_537;
  assign and_537 = left_rdata_q[60] & not_388_s1_q;
  logic and_538;
  assign and_538 = right_codes_rdata_q[51] & not_388_s1_q;
  logic [11:0] select_539;
  assign select_539 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_540;
  assign select_540 = less_387_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_544;
  assign select_544 = and_537 ? (and_538 ? (~(select_539 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_547;
  assign parity_547 = ^select_544[8:6];
  logic parity_550;
  assign parity_550 = ^select_544[11:9];
  // hls/stages/agreement.hpp:159
  logic and_554;
  assign and_554 = left_rdata_q[76] & not_388_s1_q;
  logic and_555;
  assign and_555 = right_codes_rdata_q[64] & not_388_s1_q;
  logic [11:0] select_556;
  assign select_556 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_557;
  assign select_557 = less_387_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_561;
  assign select_561 = and_554 ? (and_555 ? (~(select_556 ^ select_557)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_567;
  assign parity_567 = ^select_561[2:0];
  logic parity_570;
  assign parity_570 = ^select_561[5:3];
  logic parity_573;
  assign parity_573 = ^select_561[8:0];
  logic parity_579;
  assign parity_579 = ^select_561[11:9];
  logic parity_582;
  assign parity_582 = ^select_544[2:0];
  logic parity_585;
  assign parity_585 = ^{select_561[11:9], select_544[5:0]};
  logic parity_588;
  assign parity_588 = ^{select_561, select_544, select_521[2:0]};
  logic xor_589;
  assign xor_589 = parity_533 ^ parity_588;
  // hls/stages/agreement.hpp:479
  logic or_593;
  assign or_593 = (select_521[1:0] == 2'h3) | (select_521[2] & (select_521[0] | select_521[1]));
  // hls/stages/agreement.hpp:481
  logic or_597;
  assign or_597 = (select_544[7:6] == 2'h3) | (select_544[8] & (select_544[6] | select_544[7]));
  logic or_601;
  assign or_601 = (select_544[10:9] == 2'h3) | (select_544[11] & (select_544[9] | select_544[10]));
  // hls/stages/agreement.hpp:479
  logic or_609;
  assign or_609 = (select_561[7:6] == 2'h3) | (select_561[8] & (~(select_561[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_613;
  assign or_613 = (select_561[1:0] == 2'h3) | (select_561[2] & (select_561[0] | select_561[1]));
  logic or_617;
  assign or_617 = (select_561[4:3] == 2'h3) | (select_561[5] & (select_561[3] | select_561[4]));
  // hls/stages/agreement.hpp:480
  logic parity_620;
  assign parity_620 = ^{or_617, or_613, or_609};
  // hls/stages/agreement.hpp:479
  logic or_624;
  assign or_624 = (select_544[4:3] == 2'h3) | (select_544[5] & (select_544[3] | select_544[4]));
  // hls/stages/agreement.hpp:481
  logic or_628;
  assign or_628 = (select_561[10:9] == 2'h3) | (select_561[11] & (select_561[9] | select_561[10]));
  logic or_632;
  assign or_632 = (select_544[1:0] == 2'h3) | (select_544[2] & (select_544[0] | select_544[1]));
  // hls/stages/agreement.hpp:480
  logic parity_635;
  assign parity_635 = ^{or_632, or_628, or_624};
  logic parity_638;
  assign parity_638 = ^{or_632, or_628, or_624, or_617, or_613, or_609, or_601, or_597, or_593};
  // hls/stages/agreement.hpp:481
  logic and_639;
  assign and_639 = parity_533 & parity_588;
  logic or_643;
  assign or_643 = (parity_527 & parity_530) | ((^select_521[11:9]) & (parity_527 | parity_530));
  logic and_646;
  assign and_646 = (^{select_544[11:6], select_521[2:0]}) & (parity_573 | parity_585);
  logic or_647;
  assign or_647 = (parity_573 & parity_585) | and_646;
  // hls/stages/agreement.hpp:479
  logic or_654;
  assign or_654 = (select_521[10:9] == 2'h3) | (select_521[11] & (select_521[9] | select_521[10]));
  // hls/stages/agreement.hpp:481
  logic or_658;
  assign or_658 = (select_521[4:3] == 2'h3) | (select_521[5] & (select_521[3] | select_521[4]));
  logic or_662;
  assign or_662 = (select_521[7:6] == 2'h3) | (select_521[8] & (select_521[6] | select_521[7]));
  // hls/stages/agreement.hpp:480
  logic parity_665;
  assign parity_665 = ^{or_662, or_658, or_654};
  // hls/stages/agreement.hpp:481
  logic or_669;
  assign or_669 = (parity_547 & parity_550) | ((^select_521[2:0]) & (parity_547 | parity_550));
  logic or_673;
  assign or_673 = (parity_567 & parity_570) | ((^select_561[8:6]) & (parity_567 | parity_570));
  logic or_677;
  assign or_677 = (parity_579 & parity_582) | ((^select_544[5:3]) & (parity_579 | parity_582));
  // hls/stages/agreement.hpp:480
  logic parity_680;
  assign parity_680 = ^{or_677, or_673, or_669};
  logic parity_683;
  assign parity_683 = ^{or_677, or_673, or_669, or_662, or_658, or_654, or_647, or_643, and_639};
  logic xor_684;
  assign xor_684 = parity_638 ^ parity_683;
  // hls/stages/agreement.hpp:481
  logic and_685;
  assign and_685 = parity_638 & parity_683;
  logic or_689;
  assign or_689 = (parity_620 & parity_635) | ((^{or_601, or_597, or_593}) & (parity_620 | parity_635));
  logic or_693;
  assign or_693 = (parity_665 & parity_680) | ((^{or_647, or_643, and_639}) & (parity_665 | parity_680));
  logic or_700;
  assign or_700 = (or_597 & or_601) | (or_593 & (or_597 | or_601));
  logic or_704;
  assign or_704 = (or_613 & or_617) | (or_609 & (or_613 | or_617));
  logic or_708;
  assign or_708 = (or_628 & or_632) | (or_624 & (or_628 | or_632));
  // hls/stages/agreement.hpp:480
  logic parity_711;
  assign parity_711 = ^{or_708, or_704, or_700};
  // hls/stages/agreement.hpp:481
  logic or_715;
  assign or_715 = (or_643 & or_647) | (and_639 & (or_643 | or_647));
  logic or_719;
  assign or_719 = (or_658 & or_662) | (or_654 & (or_658 | or_662));
  logic or_723;
  assign or_723 = (or_673 & or_677) | (or_669 & (or_673 | or_677));
  // hls/stages/agreement.hpp:480
  logic parity_726;
  assign parity_726 = ^{or_723, or_719, or_715};
  logic parity_729;
  assign parity_729 = ^{or_723, or_719, or_715, or_708, or_704, or_700, or_693, or_689, and_685};
  // hls/stages/agreement.hpp:481
  logic or_733;
  assign or_733 = (parity_711 & parity_726) | ((^{or_693, or_689, and_685}) & (parity_711 | parity_726));
  logic or_737;
  assign or_737 = (or_689 & or_693) | (and_685 & (or_689 | or_693));
  logic or_741;
  assign or_741 = (or_704 & or_708) | (or_700 & (or_704 | or_708));
  logic or_745;
  assign or_745 = (or_719 & or_723) | (or_715 & (or_719 | or_723));
  // hls/stages/agreement.hpp:480
  logic parity_750;
  assign parity_750 = ^{or_745, or_741, or_737, or_733};
  // hls/stages/agreement.hpp:481
  logic or_754;
  assign or_754 = (or_741 & or_745) | (or_737 & (or_741 | or_745));
  logic and_755;
  assign and_755 = or_733 & (^{or_745, or_741, or_737});
  // hls/stages/agreement.hpp:480
  logic xor_756;
  assign xor_756 = or_754 ^ and_755;
  // hls/stages/agreement.hpp:483
  logic and_757;
  assign and_757 = or_754 & and_755;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_758;
  assign select_758 = equal_382_s1_q ? {and_757, xor_756, parity_750, parity_729, xor_684, xor_589} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_380_s1_q ? 6'h0 : select_758;
  // hls/stages/agreement.hpp:585
  logic [5:0] select_760;
  assign select_760 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_761;
  assign difference_761 = {1'b0, column_2} - {1'b0, select_760};
  logic [7:0] sum_763;
  assign sum_763 = {difference_761[6], difference_761} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:465
  logic [11:0] select_767;
  assign select_767 = and_514 ? (and_538 ? (~(select_539 ^ select_517)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_773;
  assign parity_773 = ^select_767[5:3];
  logic parity_776;
  assign parity_776 = ^select_767[8:6];
  logic parity_779;
  assign parity_779 = ^select_767[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_786;
  assign select_786 = and_537 ? (and_555 ? (~(select_556 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_789;
  assign parity_789 = ^select_786[8:6];
  logic parity_792;
  assign parity_792 = ^select_786[11:9];
  // hls/stages/agreement.hpp:159
  logic and_796;
  assign and_796 = right_codes_rdata_q[77] & not_388_s1_q;
  logic [11:0] select_797;
  assign select_797 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_801;
  assign select_801 = and_554 ? (and_796 ? (~(select_797 ^ select_557)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_807;
  assign parity_807 = ^select_801[2:0];
  logic parity_810;
  assign parity_810 = ^select_801[5:3];
  logic parity_813;
  assign parity_813 = ^select_801[8:0];
  logic parity_819;
  assign parity_819 = ^select_801[11:9];
  logic parity_822;
  assign parity_822 = ^select_786[2:0];
  logic parity_825;
  assign parity_825 = ^{select_801[11:9], select_786[5:0]};
  logic parity_828;
  assign parity_828 = ^{select_801, select_786, select_767[2:0]};
  logic xor_829;
  assign xor_829 = parity_779 ^ parity_828;
  // hls/stages/agreement.hpp:479
  logic or_833;
  assign or_833 = (select_767[1:0] == 2'h3) | (select_767[2] & (select_767[0] | select_767[1]));
  // hls/stages/agreement.hpp:481
  logic or_837;
  assign or_837 = (select_786[7:6] == 2'h3) | (select_786[8] & (select_786[6] | select_786[7]));
  logic or_841;
  assign or_841 = (select_786[10:9] == 2'h3) | (select_786[11] & (select_786[9] | select_786[10]));
  // hls/stages/agreement.hpp:479
  logic or_849;
  assign or_849 = (select_801[7:6] == 2'h3) | (select_801[8] & (~(select_801[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_853;
  assign or_853 = (select_801[1:0] == 2'h3) | (select_801[2] & (select_801[0] | select_801[1]));
  logic or_857;
  assign or_857 = (select_801[4:3] == 2'h3) | (select_801[5] & (select_801[3] | select_801[4]));
  // hls/stages/agreement.hpp:480
  logic parity_860;
  assign parity_860 = ^{or_857, or_853, or_849};
  // hls/stages/agreement.hpp:479
  logic or_864;
  assign or_864 = (select_786[4:3] == 2'h3) | (select_786[5] & (select_786[3] | select_786[4]));
  // hls/stages/agreement.hpp:481
  logic or_868;
  assign or_868 = (select_801[10:9] == 2'h3) | (select_801[11] & (select_801[9] | select_801[10]));
  logic or_872;
  assign or_872 = (select_786[1:0] == 2'h3) | (select_786[2] & (select_786[0] | select_786[1]));
  // hls/stages/agreement.hpp:480
  logic parity_875;
  assign parity_875 = ^{or_872, or_868, or_864};
  logic parity_878;
  assign parity_878 = ^{or_872, or_868, or_864, or_857, or_853, or_849, or_841, or_837, or_833};
  // hls/stages/agreement.hpp:481
  logic and_879;
  assign and_879 = parity_779 & parity_828;
  logic or_883;
  assign or_883 = (parity_773 & parity_776) | ((^select_767[11:9]) & (parity_773 | parity_776));
  logic and_886;
  assign and_886 = (^{select_786[11:6], select_767[2:0]}) & (parity_813 | parity_825);
  logic or_887;
  assign or_887 = (parity_813 & parity_825) | and_886;
  // hls/stages/agreement.hpp:479
  logic or_894;
  assign or_894 = (select_767[10:9] == 2'h3) | (select_767[11] & (select_767[9] | select_767[10]));
  // hls/stages/agreement.hpp:481
  logic or_898;
  assign or_898 = (select_767[4:3] == 2'h3) | (select_767[5] & (select_767[3] | select_767[4]));
  logic or_902;
  assign or_902 = (select_767[7:6] == 2'h3) | (select_767[8] & (select_767[6] | select_767[7]));
  // hls/stages/agreement.hpp:480
  logic parity_905;
  assign parity_905 = ^{or_902, or_898, or_894};
  // hls/stages/agreement.hpp:481
  logic or_909;
  assign or_909 = (parity_789 & parity_792) | ((^select_767[2:0]) & (parity_789 | parity_792));
  logic or_913;
  assign or_913 = (parity_807 & parity_810) | ((^select_801[8:6]) & (parity_807 | parity_810));
  logic or_917;
  assign or_917 = (parity_819 & parity_822) | ((^select_786[5:3]) & (parity_819 | parity_822));
  // hls/stages/agreement.hpp:480
  logic parity_920;
  assign parity_920 = ^{or_917, or_913, or_909};
  logic parity_923;
  assign parity_923 = ^{or_917, or_913, or_909, or_902, or_898, or_894, or_887, or_883, and_879};
  logic xor_924;
  assign xor_924 = parity_878 ^ parity_923;
  // hls/stages/agreement.hpp:481
  logic and_925;
  assign and_925 = parity_878 & parity_923;
  logic or_929;
  assign or_929 = (parity_860 & parity_875) | ((^{or_841, or_837, or_833}) & (parity_860 | parity_875));
  logic or_933;
  assign or_933 = (parity_905 & parity_920) | ((^{or_887, or_883, and_879}) & (parity_905 | parity_920));
  logic or_940;
  assign or_940 = (or_837 & or_841) | (or_833 & (or_837 | or_841));
  logic or_944;
  assign or_944 = (or_853 & or_857) | (or_849 & (or_853 | or_857));
  logic or_948;
  assign or_948 = (or_868 & or_872) | (or_864 & (or_868 | or_872));
  // hls/stages/agreement.hpp:480
  logic parity_951;
  assign parity_951 = ^{or_948, or_944, or_940};
  // hls/stages/agreement.hpp:481
  logic or_955;
  assign or_955 = (or_883 & or_887) | (and_879 & (or_883 | or_887));
  logic or_959;
  assign or_959 = (or_898 & or_902) | (or_894 & (or_898 | or_902));
  logic or_963;
  assign or_963 = (or_913 & or_917) | (or_909 & (or_913 | or_917));
  // hls/stages/agreement.hpp:480
  logic parity_966;
  assign parity_966 = ^{or_963, or_959, or_955};
  logic parity_969;
  assign parity_969 = ^{or_963, or_959, or_955, or_948, or_944, or_940, or_933, or_929, and_925};
  // hls/stages/agreement.hpp:481
  logic or_973;
  assign or_973 = (parity_951 & parity_966) | ((^{or_933, or_929, and_925}) & (parity_951 | parity_966));
  logic or_977;
  assign or_977 = (or_929 & or_933) | (and_925 & (or_929 | or_933));
  logic or_981;
  assign or_981 = (or_944 & or_948) | (or_940 & (or_944 | or_948));
  logic or_985;
  assign or_985 = (or_959 & or_963) | (or_955 & (or_959 | or_963));
  // hls/stages/agreement.hpp:480
  logic parity_990;
  assign parity_990 = ^{or_985, or_981, or_977, or_973};
  // hls/stages/agreement.hpp:481
  logic or_994;
  assign or_994 = (or_981 & or_985) | (or_977 & (or_981 | or_985));
  logic and_995;
  assign and_995 = or_973 & (^{or_985, or_981, or_977});
  // hls/stages/agreement.hpp:480
  logic xor_996;
  assign xor_996 = or_994 ^ and_995;
  // hls/stages/agreement.hpp:483
  logic and_997;
  assign and_997 = or_994 & and_995;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_998;
  assign select_998 = equal_382_s1_q ? {and_997, xor_996, parity_990, parity_969, xor_924, xor_829} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_380_s1_q ? 6'h0 : select_998;
  // hls/stages/agreement.hpp:585
  logic [5:0] select_1000;
  assign select_1000 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1001;
  assign difference_1001 = {1'b0, column_3} - {1'b0, select_1000};
  logic [7:0] sum_1003;
  assign sum_1003 = {difference_1001[6], difference_1001} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:159
  logic and_1004;
  assign and_1004 = right_codes_rdata_q[25] & not_388_s1_q;
  logic [11:0] select_1005;
  assign select_1005 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1009;
  assign select_1009 = and_514 ? (and_1004 ? (~(select_1005 ^ select_517)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1015;
  assign parity_1015 = ^select_1009[5:3];
  logic parity_1018;
  assign parity_1018 = ^select_1009[8:6];
  logic parity_1021;
  assign parity_1021 = ^select_1009[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1028;
  assign select_1028 = and_537 ? (and_515 ? (~(select_516 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1031;
  assign parity_1031 = ^select_1028[8:6];
  logic parity_1034;
  assign parity_1034 = ^select_1028[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1041;
  assign select_1041 = and_554 ? (and_538 ? (~(select_539 ^ select_557)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1047;
  assign parity_1047 = ^select_1041[2:0];
  logic parity_1050;
  assign parity_1050 = ^select_1041[5:3];
  logic parity_1053;
  assign parity_1053 = ^select_1041[8:0];
  logic parity_1059;
  assign parity_1059 = ^select_1041[11:9];
  logic parity_1062;
  assign parity_1062 = ^select_1028[2:0];
  logic parity_1065;
  assign parity_1065 = ^{select_1041[11:9], select_1028[5:0]};
  logic parity_1068;
  assign parity_1068 = ^{select_1041, select_1028, select_1009[2:0]};
  logic xor_1069;
  assign xor_1069 = parity_1021 ^ parity_1068;
  // hls/stages/agreement.hpp:479
  logic or_1073;
  assign or_1073 = (select_1009[1:0] == 2'h3) | (select_1009[2] & (select_1009[0] | select_1009[1]));
  // hls/stages/agreement.hpp:481
  logic or_1077;
  assign or_1077 = (select_1028[7:6] == 2'h3) | (select_1028[8] & (select_1028[6] | select_1028[7]));
  logic or_1081;
  assign or_1081 = (select_1028[10:9] == 2'h3) | (select_1028[11] & (select_1028[9] | select_1028[10]));
  // hls/stages/agreement.hpp:479
  logic or_1089;
  assign or_1089 = (select_1041[7:6] == 2'h3) | (select_1041[8] & (~(select_1041[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1093;
  assign or_1093 = (select_1041[1:0] == 2'h3) | (select_1041[2] & (select_1041[0] | select_1041[1]));
  logic or_1097;
  assign or_1097 = (select_1041[4:3] == 2'h3) | (select_1041[5] & (select_1041[3] | select_1041[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1100;
  assign parity_1100 = ^{or_1097, or_1093, or_1089};
  // hls/stages/agreement.hpp:479
  logic or_1104;
  assign or_1104 = (select_1028[4:3] == 2'h3) | (select_1028[5] & (select_1028[3] | select_1028[4]));
  // hls/stages/agreement.hpp:481
  logic or_1108;
  assign or_1108 = (select_1041[10:9] == 2'h3) | (select_1041[11] & (select_1041[9] | select_1041[10]));
  logic or_1112;
  assign or_1112 = (select_1028[1:0] == 2'h3) | (select_1028[2] & (select_1028[0] | select_1028[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1115;
  assign parity_1115 = ^{or_1112, or_1108, or_1104};
  logic parity_1118;
  assign parity_1118 = ^{or_1112, or_1108, or_1104, or_1097, or_1093, or_1089, or_1081, or_1077, or_1073};
  // hls/stages/agreement.hpp:481
  logic and_1119;
  assign and_1119 = parity_1021 & parity_1068;
  logic or_1123;
  assign or_1123 = (parity_1015 & parity_1018) | ((^select_1009[11:9]) & (parity_1015 | parity_1018));
  logic and_1126;
  assign and_1126 = (^{select_1028[11:6], select_1009[2:0]}) & (parity_1053 | parity_1065);
  logic or_1127;
  assign or_1127 = (parity_1053 & parity_1065) | and_1126;
  // hls/stages/agreement.hpp:479
  logic or_1134;
  assign or_1134 = (select_1009[10:9] == 2'h3) | (select_1009[11] & (select_1009[9] | select_1009[10]));
  // hls/stages/agreement.hpp:481
  logic or_1138;
  assign or_1138 = (select_1009[4:3] == 2'h3) | (select_1009[5] & (select_1009[3] | select_1009[4]));
  logic or_1142;
  assign or_1142 = (select_1009[7:6] == 2'h3) | (select_1009[8] & (select_1009[6] | select_1009[7]));
  // hls/stages/agreement.hpp:480
  logic parity_1145;
  assign parity_1145 = ^{or_1142, or_1138, or_1134};
  // hls/stages/agreement.hpp:481
  logic or_1149;
  assign or_1149 = (parity_1031 & parity_1034) | ((^select_1009[2:0]) & (parity_1031 | parity_1034));
  logic or_1153;
  assign or_1153 = (parity_1047 & parity_1050) | ((^select_1041[8:6]) & (parity_1047 | parity_1050));
  logic or_1157;
  assign or_1157 = (parity_1059 & parity_1062) | ((^select_1028[5:3]) & (parity_1059 | parity_1062));
  // hls/stages/agreement.hpp:480
  logic parity_1160;
  assign parity_1160 = ^{or_1157, or_1153, or_1149};
  logic parity_1163;
  assign parity_1163 = ^{or_1157, or_1153, or_1149, or_1142, or_1138, or_1134, or_1127, or_1123, and_1119};
  logic xor_1164;
  assign xor_1164 = parity_1118 ^ parity_1163;
  // hls/stages/agreement.hpp:481
  logic and_1165;
  assign and_1165 = parity_1118 & parity_1163;
  logic or_1169;
  assign or_1169 = (parity_1100 & parity_1115) | ((^{or_1081, or_1077, or_1073}) & (parity_1100 | parity_1115));
  logic or_1173;
  assign or_1173 = (parity_1145 & parity_1160) | ((^{or_1127, or_1123, and_1119}) & (parity_1145 | parity_1160));
  logic or_1180;
  assign or_1180 = (or_1077 & or_1081) | (or_1073 & (or_1077 | or_1081));
  logic or_1184;
  assign or_1184 = (or_1093 & or_1097) | (or_1089 & (or_1093 | or_1097));
  logic or_1188;
  assign or_1188 = (or_1108 & or_1112) | (or_1104 & (or_1108 | or_1112));
  // hls/stages/agreement.hpp:480
  logic parity_1191;
  assign parity_1191 = ^{or_1188, or_1184, or_1180};
  // hls/stages/agreement.hpp:481
  logic or_1195;
  assign or_1195 = (or_1123 & or_1127) | (and_1119 & (or_1123 | or_1127));
  logic or_1199;
  assign or_1199 = (or_1138 & or_1142) | (or_1134 & (or_1138 | or_1142));
  logic or_1203;
  assign or_1203 = (or_1153 & or_1157) | (or_1149 & (or_1153 | or_1157));
  // hls/stages/agreement.hpp:480
  logic parity_1206;
  assign parity_1206 = ^{or_1203, or_1199, or_1195};
  logic parity_1209;
  assign parity_1209 = ^{or_1203, or_1199, or_1195, or_1188, or_1184, or_1180, or_1173, or_1169, and_1165};
  // hls/stages/agreement.hpp:481
  logic or_1213;
  assign or_1213 = (parity_1191 & parity_1206) | ((^{or_1173, or_1169, and_1165}) & (parity_1191 | parity_1206));
  logic or_1217;
  assign or_1217 = (or_1169 & or_1173) | (and_1165 & (or_1169 | or_1173));
  logic or_1221;
  assign or_1221 = (or_1184 & or_1188) | (or_1180 & (or_1184 | or_1188));
  logic or_1225;
  assign or_1225 = (or_1199 & or_1203) | (or_1195 & (or_1199 | or_1203));
  // hls/stages/agreement.hpp:480
  logic parity_1230;
  assign parity_1230 = ^{or_1225, or_1221, or_1217, or_1213};
  // hls/stages/agreement.hpp:481
  logic or_1234;
  assign or_1234 = (or_1221 & or_1225) | (or_1217 & (or_1221 | or_1225));
  logic and_1235;
  assign and_1235 = or_1213 & (^{or_1225, or_1221, or_1217});
  // hls/stages/agreement.hpp:480
  logic xor_1236;
  assign xor_1236 = or_1234 ^ and_1235;
  // hls/stages/agreement.hpp:483
  logic and_1237;
  assign and_1237 = or_1234 & and_1235;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_1238;
  assign select_1238 = equal_382_s1_q ? {and_1237, xor_1236, parity_1230, parity_1209, xor_1164, xor_1069} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_380_s1_q ? 6'h0 : select_1238;
  // hls/stages/agreement.hpp:585
  logic [5:0] select_1240;
  assign select_1240 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1241;
  assign difference_1241 = {1'b0, column_4} - {1'b0, select_1240};
  logic [7:0] sum_1243;
  assign sum_1243 = {difference_1241[6], difference_1241} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1251;
  assign select_1251 = and_514 ? (and_555 ? (~(select_556 ^ select_517)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1257;
  assign parity_1257 = ^select_1251[5:3];
  logic parity_1260;
  assign parity_1260 = ^select_1251[8:6];
  logic parity_1263;
  assign parity_1263 = ^select_1251[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1270;
  assign select_1270 = and_537 ? (and_796 ? (~(select_797 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1273;
  assign parity_1273 = ^select_1270[8:6];
  logic parity_1276;
  assign parity_1276 = ^select_1270[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] xor_1282;
  assign xor_1282 = (less_387_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_557;
  logic [11:0] select_1285;
  assign select_1285 = and_554 ? ((right_codes_rdata_q[90] & not_388_s1_q) ? (~xor_1282) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1291;
  assign parity_1291 = ^select_1285[2:0];
  logic parity_1294;
  assign parity_1294 = ^select_1285[5:3];
  logic parity_1297;
  assign parity_1297 = ^select_1285[8:0];
  logic parity_1303;
  assign parity_1303 = ^select_1285[11:9];
  logic parity_1306;
  assign parity_1306 = ^select_1270[2:0];
  logic parity_1309;
  assign parity_1309 = ^{select_1285[11:9], select_1270[5:0]};
  logic parity_1312;
  assign parity_1312 = ^{select_1285, select_1270, select_1251[2:0]};
  logic xor_1313;
  assign xor_1313 = parity_1263 ^ parity_1312;
  // hls/stages/agreement.hpp:479
  logic or_1317;
  assign or_1317 = (select_1251[1:0] == 2'h3) | (select_1251[2] & (select_1251[0] | select_1251[1]));
  // hls/stages/agreement.hpp:481
  logic or_1321;
  assign or_1321 = (select_1270[7:6] == 2'h3) | (select_1270[8] & (select_1270[6] | select_1270[7]));
  logic or_1325;
  assign or_1325 = (select_1270[10:9] == 2'h3) | (select_1270[11] & (select_1270[9] | select_1270[10]));
  // hls/stages/agreement.hpp:479
  logic or_1333;
  assign or_1333 = (select_1285[7:6] == 2'h3) | (select_1285[8] & (~(select_1285[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1337;
  assign or_1337 = (select_1285[1:0] == 2'h3) | (select_1285[2] & (select_1285[0] | select_1285[1]));
  logic or_1341;
  assign or_1341 = (select_1285[4:3] == 2'h3) | (select_1285[5] & (select_1285[3] | select_1285[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1344;
  assign parity_1344 = ^{or_1341, or_1337, or_1333};
  // hls/stages/agreement.hpp:479
  logic or_1348;
  assign or_1348 = (select_1270[4:3] == 2'h3) | (select_1270[5] & (select_1270[3] | select_1270[4]));
  // hls/stages/agreement.hpp:481
  logic or_1352;
  assign or_1352 = (select_1285[10:9] == 2'h3) | (select_1285[11] & (select_1285[9] | select_1285[10]));
  logic or_1356;
  assign or_1356 = (select_1270[1:0] == 2'h3) | (select_1270[2] & (select_1270[0] | select_1270[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1359;
  assign parity_1359 = ^{or_1356, or_1352, or_1348};
  logic parity_1362;
  assign parity_1362 = ^{or_1356, or_1352, or_1348, or_1341, or_1337, or_1333, or_1325, or_1321, or_1317};
  // hls/stages/agreement.hpp:481
  logic and_1363;
  assign and_1363 = parity_1263 & parity_1312;
  logic or_1367;
  assign or_1367 = (parity_1257 & parity_1260) | ((^select_1251[11:9]) & (parity_1257 | parity_1260));
  logic and_1370;
  assign and_1370 = (^{select_1270[11:6], select_1251[2:0]}) & (parity_1297 | parity_1309);
  logic or_1371;
  assign or_1371 = (parity_1297 & parity_1309) | and_1370;
  // hls/stages/agreement.hpp:479
  logic or_1378;
  assign or_1378 = (select_1251[10:9] == 2'h3) | (select_1251[11] & (select_1251[9] | select_1251[10]));
  // hls/stages/agreement.hpp:481
  logic or_1382;
  assign or_1382 = (select_1251[4:3] == 2'h3) | (select_1251[5] & (select_1251[3] | select_1251[4]));
  logic or_1386;
  assign or_1386 = (select_1251[7:6] == 2'h3) | (select_1251[8] & (select_1251[6] | select_1251[7]));
  // hls/stages/agreement.hpp:480
  logic parity_1389;
  assign parity_1389 = ^{or_1386, or_1382, or_1378};
  // hls/stages/agreement.hpp:481
  logic or_1393;
  assign or_1393 = (parity_1273 & parity_1276) | ((^select_1251[2:0]) & (parity_1273 | parity_1276));
  logic or_1397;
  assign or_1397 = (parity_1291 & parity_1294) | ((^select_1285[8:6]) & (parity_1291 | parity_1294));
  logic or_1401;
  assign or_1401 = (parity_1303 & parity_1306) | ((^select_1270[5:3]) & (parity_1303 | parity_1306));
  // hls/stages/agreement.hpp:480
  logic parity_1404;
  assign parity_1404 = ^{or_1401, or_1397, or_1393};
  logic parity_1407;
  assign parity_1407 = ^{or_1401, or_1397, or_1393, or_1386, or_1382, or_1378, or_1371, or_1367, and_1363};
  logic xor_1408;
  assign xor_1408 = parity_1362 ^ parity_1407;
  // hls/stages/agreement.hpp:481
  logic and_1409;
  assign and_1409 = parity_1362 & parity_1407;
  logic or_1413;
  assign or_1413 = (parity_1344 & parity_1359) | ((^{or_1325, or_1321, or_1317}) & (parity_1344 | parity_1359));
  logic or_1417;
  assign or_1417 = (parity_1389 & parity_1404) | ((^{or_1371, or_1367, and_1363}) & (parity_1389 | parity_1404));
  logic or_1424;
  assign or_1424 = (or_1321 & or_1325) | (or_1317 & (or_1321 | or_1325));
  logic or_1428;
  assign or_1428 = (or_1337 & or_1341) | (or_1333 & (or_1337 | or_1341));
  logic or_1432;
  assign or_1432 = (or_1352 & or_1356) | (or_1348 & (or_1352 | or_1356));
  // hls/stages/agreement.hpp:480
  logic parity_1435;
  assign parity_1435 = ^{or_1432, or_1428, or_1424};
  // hls/stages/agreement.hpp:481
  logic or_1439;
  assign or_1439 = (or_1367 & or_1371) | (and_1363 & (or_1367 | or_1371));
  logic or_1443;
  assign or_1443 = (or_1382 & or_1386) | (or_1378 & (or_1382 | or_1386));
  logic or_1447;
  assign or_1447 = (or_1397 & or_1401) | (or_1393 & (or_1397 | or_1401));
  // hls/stages/agreement.hpp:480
  logic parity_1450;
  assign parity_1450 = ^{or_1447, or_1443, or_1439};
  logic parity_1453;
  assign parity_1453 = ^{or_1447, or_1443, or_1439, or_1432, or_1428, or_1424, or_1417, or_1413, and_1409};
  // hls/stages/agreement.hpp:481
  logic or_1457;
  assign or_1457 = (parity_1435 & parity_1450) | ((^{or_1417, or_1413, and_1409}) & (parity_1435 | parity_1450));
  logic or_1461;
  assign or_1461 = (or_1413 & or_1417) | (and_1409 & (or_1413 | or_1417));
  logic or_1465;
  assign or_1465 = (or_1428 & or_1432) | (or_1424 & (or_1428 | or_1432));
  logic or_1469;
  assign or_1469 = (or_1443 & or_1447) | (or_1439 & (or_1443 | or_1447));
  // hls/stages/agreement.hpp:480
  logic parity_1474;
  assign parity_1474 = ^{or_1469, or_1465, or_1461, or_1457};
  // hls/stages/agreement.hpp:481
  logic or_1478;
  assign or_1478 = (or_1465 & or_1469) | (or_1461 & (or_1465 | or_1469));
  logic and_1479;
  assign and_1479 = or_1457 & (^{or_1469, or_1465, or_1461});
  // hls/stages/agreement.hpp:480
  logic xor_1480;
  assign xor_1480 = or_1478 ^ and_1479;
  // hls/stages/agreement.hpp:483
  logic and_1481;
  assign and_1481 = or_1478 & and_1479;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_1482;
  assign select_1482 = equal_382_s1_q ? {and_1481, xor_1480, parity_1474, parity_1453, xor_1408, xor_1313} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_380_s1_q ? 6'h0 : select_1482;
  // hls/stages/agreement.hpp:585
  logic [5:0] select_1484;
  assign select_1484 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1485;
  assign difference_1485 = {1'b0, column_5} - {1'b0, select_1484};
  logic [7:0] sum_1487;
  assign sum_1487 = {difference_1485[6], difference_1485} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:465
  logic [11:0] not_1491;
  assign not_1491 = ~((less_387_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_517);
  logic [11:0] select_1493;
  assign select_1493 = and_514 ? ((right_codes_rdata_q[12] & not_388_s1_q) ? not_1491 : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1499;
  assign parity_1499 = ^select_1493[5:3];
  logic parity_1502;
  assign parity_1502 = ^select_1493[8:6];
  logic parity_1505;
  assign parity_1505 = ^select_1493[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1512;
  assign select_1512 = and_537 ? (and_1004 ? (~(select_1005 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1515;
  assign parity_1515 = ^select_1512[8:6];
  logic parity_1518;
  assign parity_1518 = ^select_1512[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1525;
  assign select_1525 = and_554 ? (and_515 ? (~(select_516 ^ select_557)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1531;
  assign parity_1531 = ^select_1525[2:0];
  logic parity_1534;
  assign parity_1534 = ^select_1525[5:3];
  logic parity_1537;
  assign parity_1537 = ^select_1525[8:0];
  logic parity_1543;
  assign parity_1543 = ^select_1525[11:9];
  logic parity_1546;
  assign parity_1546 = ^select_1512[2:0];
  logic parity_1549;
  assign parity_1549 = ^{select_1525[11:9], select_1512[5:0]};
  logic parity_1552;
  assign parity_1552 = ^{select_1525, select_1512, select_1493[2:0]};
  logic xor_1553;
  assign xor_1553 = parity_1505 ^ parity_1552;
  // hls/stages/agreement.hpp:479
  logic or_1557;
  assign or_1557 = (select_1493[1:0] == 2'h3) | (select_1493[2] & (select_1493[0] | select_1493[1]));
  // hls/stages/agreement.hpp:481
  logic or_1561;
  assign or_1561 = (select_1512[7:6] == 2'h3) | (select_1512[8] & (select_1512[6] | select_1512[7]));
  logic or_1565;
  assign or_1565 = (select_1512[10:9] == 2'h3) | (select_1512[11] & (select_1512[9] | select_1512[10]));
  // hls/stages/agreement.hpp:479
  logic or_1573;
  assign or_1573 = (select_1525[7:6] == 2'h3) | (select_1525[8] & (~(select_1525[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1577;
  assign or_1577 = (select_1525[1:0] == 2'h3) | (select_1525[2] & (select_1525[0] | select_1525[1]));
  logic or_1581;
  assign or_1581 = (select_1525[4:3] == 2'h3) | (select_1525[5] & (select_1525[3] | select_1525[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1584;
  assign parity_1584 = ^{or_1581, or_1577, or_1573};
  // hls/stages/agreement.hpp:479
  logic or_1588;
  assign or_1588 = (select_1512[4:3] == 2'h3) | (select_1512[5] & (select_1512[3] | select_1512[4]));
  // hls/stages/agreement.hpp:481
  logic or_1592;
  assign or_1592 = (select_1525[10:9] == 2'h3) | (select_1525[11] & (select_1525[9] | select_1525[10]));
  logic or_1596;
  assign or_1596 = (select_1512[1:0] == 2'h3) | (select_1512[2] & (select_1512[0] | select_1512[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1599;
  assign parity_1599 = ^{or_1596, or_1592, or_1588};
  logic parity_1602;
  assign parity_1602 = ^{or_1596, or_1592, or_1588, or_1581, or_1577, or_1573, or_1565, or_1561, or_1557};
  // hls/stages/agreement.hpp:481
  logic and_1603;
  assign and_1603 = parity_1505 & parity_1552;
  logic or_1607;
  assign or_1607 = (parity_1499 & parity_1502) | ((^select_1493[11:9]) & (parity_1499 | parity_1502));
  logic and_1610;
  assign and_1610 = (^{select_1512[11:6], select_1493[2:0]}) & (parity_1537 | parity_1549);
  logic or_1611;
  assign or_1611 = (parity_1537 & parity_1549) | and_1610;
  // hls/stages/agreement.hpp:479
  logic or_1618;
  assign or_1618 = (select_1493[10:9] == 2'h3) | (select_1493[11] & (select_1493[9] | select_1493[10]));
  // hls/stages/agreement.hpp:481
  logic or_1622;
  assign or_1622 = (select_1493[4:3] == 2'h3) | (select_1493[5] & (select_1493[3] | select_1493[4]));
  logic or_1626;
  assign or_1626 = (select_1493[7:6] == 2'h3) | (select_1493[8] & (select_1493[6] | select_1493[7]));
  // hls/stages/agreement.hpp:480
  logic parity_1629;
  assign parity_1629 = ^{or_1626, or_1622, or_1618};
  // hls/stages/agreement.hpp:481
  logic or_1633;
  assign or_1633 = (parity_1515 & parity_1518) | ((^select_1493[2:0]) & (parity_1515 | parity_1518));
  logic or_1637;
  assign or_1637 = (parity_1531 & parity_1534) | ((^select_1525[8:6]) & (parity_1531 | parity_1534));
  logic or_1641;
  assign or_1641 = (parity_1543 & parity_1546) | ((^select_1512[5:3]) & (parity_1543 | parity_1546));
  // hls/stages/agreement.hpp:480
  logic parity_1644;
  assign parity_1644 = ^{or_1641, or_1637, or_1633};
  logic parity_1647;
  assign parity_1647 = ^{or_1641, or_1637, or_1633, or_1626, or_1622, or_1618, or_1611, or_1607, and_1603};
  logic xor_1648;
  assign xor_1648 = parity_1602 ^ parity_1647;
  // hls/stages/agreement.hpp:481
  logic and_1649;
  assign and_1649 = parity_1602 & parity_1647;
  logic or_1653;
  assign or_1653 = (parity_1584 & parity_1599) | ((^{or_1565, or_1561, or_1557}) & (parity_1584 | parity_1599));
  logic or_1657;
  assign or_1657 = (parity_1629 & parity_1644) | ((^{or_1611, or_1607, and_1603}) & (parity_1629 | parity_1644));
  logic or_1664;
  assign or_1664 = (or_1561 & or_1565) | (or_1557 & (or_1561 | or_1565));
  logic or_1668;
  assign or_1668 = (or_1577 & or_1581) | (or_1573 & (or_1577 | or_1581));
  logic or_1672;
  assign or_1672 = (or_1592 & or_1596) | (or_1588 & (or_1592 | or_1596));
  // hls/stages/agreement.hpp:480
  logic parity_1675;
  assign parity_1675 = ^{or_1672, or_1668, or_1664};
  // hls/stages/agreement.hpp:481
  logic or_1679;
  assign or_1679 = (or_1607 & or_1611) | (and_1603 & (or_1607 | or_1611));
  logic or_1683;
  assign or_1683 = (or_1622 & or_1626) | (or_1618 & (or_1622 | or_1626));
  logic or_1687;
  assign or_1687 = (or_1637 & or_1641) | (or_1633 & (or_1637 | or_1641));
  // hls/stages/agreement.hpp:480
  logic parity_1690;
  assign parity_1690 = ^{or_1687, or_1683, or_1679};
  logic parity_1693;
  assign parity_1693 = ^{or_1687, or_1683, or_1679, or_1672, or_1668, or_1664, or_1657, or_1653, and_1649};
  // hls/stages/agreement.hpp:481
  logic or_1697;
  assign or_1697 = (parity_1675 & parity_1690) | ((^{or_1657, or_1653, and_1649}) & (parity_1675 | parity_1690));
  logic or_1701;
  assign or_1701 = (or_1653 & or_1657) | (and_1649 & (or_1653 | or_1657));
  logic or_1705;
  assign or_1705 = (or_1668 & or_1672) | (or_1664 & (or_1668 | or_1672));
  logic or_1709;
  assign or_1709 = (or_1683 & or_1687) | (or_1679 & (or_1683 | or_1687));
  // hls/stages/agreement.hpp:480
  logic parity_1714;
  assign parity_1714 = ^{or_1709, or_1705, or_1701, or_1697};
  // hls/stages/agreement.hpp:481
  logic or_1718;
  assign or_1718 = (or_1705 & or_1709) | (or_1701 & (or_1705 | or_1709));
  logic and_1719;
  assign and_1719 = or_1697 & (^{or_1709, or_1705, or_1701});
  // hls/stages/agreement.hpp:480
  logic xor_1720;
  assign xor_1720 = or_1718 ^ and_1719;
  // hls/stages/agreement.hpp:483
  logic and_1721;
  assign and_1721 = or_1718 & and_1719;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_1722;
  assign select_1722 = equal_382_s1_q ? {and_1721, xor_1720, parity_1714, parity_1693, xor_1648, xor_1553} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_380_s1_q ? 6'h0 : select_1722;
  // hls/stages/agreement.hpp:585
  logic [5:0] select_1724;
  assign select_1724 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1725;
  assign difference_1725 = {1'b0, column_6} - {1'b0, select_1724};
  logic [7:0] sum_1727;
  assign sum_1727 = {difference_1725[6], difference_1725} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:719
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:720
  logic [6:0] sum_1785;
  assign sum_1785 = x_s1_q[6:0] + {shift[5], shift};
  // hls/stages/agreement.hpp:723
  logic and_1805;
  assign and_1805 = (or_380_s1_q & (left_rdata_q[61] & not_388_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:182
  logic or_1827;
  assign or_1827 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:211
  logic [6:0] select_1838;
  assign select_1838 = so_s1_q ? x_s1_q[6:0] : (or_380_s1_q ? (less_387_s1_q ? 7'h0 : sum_1785) : 7'h0);
  logic and_2058;
  assign and_2058 = ends_cell_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_2056_s1_q);
  // hls/stages/agreement.hpp:310
  logic [5:0] or_2199;
  assign or_2199 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:314
  logic select_2415;
  assign select_2415 = equal_2321_s1_q ? (~({row_s1_q, 1'b0} < {sum_2412, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:365
  logic and_2626;
  assign and_2626 = and_359_s1_q & (equal_2321_s1_q & (row_s1_q[5:2] == 4'h0));

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:146; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_326_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_334;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1074; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_380_s1_q ? sum_1785 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_501_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s1_q[6:0];
  logic left_we;
  assign left_we = s1_en & and_391_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_483, left_rdata_q[59:45], and_482, left_rdata_q[43:29], and_481, left_rdata_q[27:13], and_480, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_391_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_492, right_codes_rdata_q[76:65], and_491, right_codes_rdata_q[63:52], and_490, right_codes_rdata_q[50:39], and_489, right_codes_rdata_q[37:26], and_488, right_codes_rdata_q[24:13], and_487, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_359_s1_q ? (equal_2321_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_359_s1_q ? select_2415 : lower_half_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    middle_sum_columns_values_0_q = 6'h0;
    middle_sum_columns_values_1_q = 6'h0;
    middle_sum_columns_values_2_q = 6'h0;
    middle_sum_columns_values_3_q = 6'h0;
    middle_sum_columns_values_4_q = 6'h0;
    middle_sum_columns_values_5_q = 6'h0;
    middle_sum_columns_values_6_q = 6'h0;
    middle_sum_sum_sums_values_0_q = 8'h0;
    sums_0_columns_values_0_q = 6'h0;
    sums_0_columns_values_1_q = 6'h0;
    sums_0_columns_values_2_q = 6'h0;
    sums_0_columns_values_3_q = 6'h0;
    sums_0_columns_values_4_q = 6'h0;
    sums_0_columns_values_5_q = 6'h0;
    sums_0_columns_values_6_q = 6'h0;
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_1_columns_values_0_q = 6'h0;
    sums_1_columns_values_1_q = 6'h0;
    sums_1_columns_values_2_q = 6'h0;
    sums_1_columns_values_3_q = 6'h0;
    sums_1_columns_values_4_q = 6'h0;
    sums_1_columns_values_5_q = 6'h0;
    sums_1_columns_values_6_q = 6'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_2_columns_values_0_q = 6'h0;
    sums_2_columns_values_1_q = 6'h0;
    sums_2_columns_values_2_q = 6'h0;
    sums_2_columns_values_3_q = 6'h0;
    sums_2_columns_values_4_q = 6'h0;
    sums_2_columns_values_5_q = 6'h0;
    sums_2_columns_values_6_q = 6'h0;
    sums_2_sum_sums_values_0_q = 8'h0;
    sums_3_columns_values_0_q = 6'h0;
    sums_3_columns_values_1_q = 6'h0;
    sums_3_columns_values_2_q = 6'h0;
    sums_3_columns_values_3_q = 6'h0;
    sums_3_columns_values_4_q = 6'h0;
    sums_3_columns_values_5_q = 6'h0;
    sums_3_columns_values_6_q = 6'h0;
    sums_3_sum_sums_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      middle_sum_columns_values_0_q <= column_2;
      middle_sum_columns_values_1_q <= middle_sum_columns_values_0_q;
      middle_sum_columns_values_2_q <= middle_sum_columns_values_1_q;
      middle_sum_columns_values_3_q <= middle_sum_columns_values_2_q;
      middle_sum_columns_values_4_q <= middle_sum_columns_values_3_q;
      middle_sum_columns_values_5_q <= middle_sum_columns_values_4_q;
      middle_sum_columns_values_6_q <= middle_sum_columns_values_5_q;
      middle_sum_sum_sums_values_0_q <= sum_763;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1003;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1243;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1487;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1727;
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
  logic [2:0] slot_s2_q;
  logic ends_cell_s2_q;
  logic lower_half_s2_q;
  logic select_320_s2_q;
  logic [8:0] select_326_s2_q;
  logic and_333_s2_q;
  logic and_334_s2_q;
  logic equal_339_s2_q;
  logic whole_s2_q;
  logic [6:0] column_s2_q;
  logic and_357_s2_q;
  logic and_359_s2_q;
  logic equal_362_s2_q;
  logic so_s2_q;
  logic equal_379_s2_q;
  logic or_380_s2_q;
  logic less_387_s2_q;
  logic not_388_s2_q;
  logic equal_420_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_508_s2_q;
  logic and_1783_s2_q;
  logic [6:0] right_s2_q;
  logic select_1790_s2_q;
  logic equal_1799_s2_q;
  logic and_1806_s2_q;
  logic and_1809_s2_q;
  logic and_1813_s2_q;
  logic or_1827_s2_q;
  logic [6:0] select_1838_s2_q;
  logic less_1882_s2_q;
  logic equal_1922_s2_q;
  logic and_2059_s2_q;
  logic equal_2200_s2_q;
  logic equal_2321_s2_q;
  logic less_2555_s2_q;
  logic and_2627_s2_q;
  logic and_2629_s2_q;
  logic less_2736_s2_q;
  logic equal_2943_s2_q;
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
      age_s2_q <= age_s1_q[2:1];
      slot_s2_q <= slot_s1_q;
      ends_cell_s2_q <= ends_cell_s1_q;
      lower_half_s2_q <= lower_half_q;
      select_320_s2_q <= select_320_s1_q;
      select_326_s2_q <= select_326_s1_q;
      and_333_s2_q <= and_333_s1_q;
      and_334_s2_q <= and_334;
      equal_339_s2_q <= equal_339_s1_q;
      whole_s2_q <= whole_s1_q;
      column_s2_q <= column_s1_q;
      and_357_s2_q <= and_357_s1_q;
      and_359_s2_q <= and_359_s1_q;
      equal_362_s2_q <= equal_362_s1_q;
      so_s2_q <= so_s1_q;
      equal_379_s2_q <= equal_379_s1_q;
      or_380_s2_q <= or_380_s1_q;
      less_387_s2_q <= less_387_s1_q;
      not_388_s2_q <= not_388_s1_q;
      equal_420_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_508_s2_q <= select_508_s1_q;
      and_1783_s2_q <= and_1783_s1_q;
      right_s2_q <= right_s1_q;
      select_1790_s2_q <= select_1790_s1_q;
      equal_1799_s2_q <= equal_1799_s1_q;
      and_1806_s2_q <= not_388_s1_q & and_1805;
      and_1809_s2_q <= (or_380_s1_q & (left_rdata_q[62] & not_388_s1_q)) & and_1805;
      and_1813_s2_q <= not_388_s1_q & (or_380_s1_q & (left_rdata_q[63] & not_388_s1_q));
      or_1827_s2_q <= or_1827;
      select_1838_s2_q <= select_1838;
      less_1882_s2_q <= less_1882_s1_q;
      equal_1922_s2_q <= equal_1922_s1_q;
      and_2059_s2_q <= so_s1_q & and_2058;
      equal_2200_s2_q <= {column_s1_q[6], or_2199} == 7'h0;
      equal_2321_s2_q <= equal_2321_s1_q;
      less_2555_s2_q <= 5'h4 < row_q[5:1];
      and_2627_s2_q <= and_2322_s1_q & and_2626;
      and_2629_s2_q <= and_2322_s1_q & (~and_2626);
      less_2736_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2943_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  // hls/stages/census.hpp:91
  logic [11:0] select_337;
  assign select_337 = select_320_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:100
  logic [11:0] sum_341;
  assign sum_341 = select_337 + (equal_339_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:91
  logic [11:0] sum_343;
  assign sum_343 = {4'h0, sample_pair_pixel_1_q} + (select_320_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:100
  logic [11:0] sum_345;
  assign sum_345 = sum_343 + (equal_339_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:101
  logic and_349;
  assign and_349 = whole_s2_q & (averager_memory_rdata_q[24] | equal_339_s2_q);
  // hls/stages/agreement.hpp:213
  logic all_of_skin;
  assign all_of_skin = select_320_s2_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:102
  logic and_353;
  assign and_353 = all_of_skin & (averager_memory_rdata_q[25] | equal_339_s2_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_333_s2_q ? sum_341[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_333_s2_q ? sum_345[11:3] : 9'h0;
  logic and_370;
  assign and_370 = and_333_s2_q & and_349;
  // hls/stages/census.hpp:105
  logic select_372;
  assign select_372 = equal_362_s2_q ? and_370 : (averager_mask_q & and_370);
  // hls/stages/agreement.hpp:215
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_372;
  // hls/stages/census.hpp:126
  logic and_374;
  assign and_374 = and_333_s2_q & and_353;
  // hls/stages/census.hpp:105
  logic select_376;
  assign select_376 = equal_362_s2_q ? and_374 : (averager_of_skin_q & and_374);
  // hls/stages/agreement.hpp:595
  logic not_510;
  assign not_510 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_511;
  assign less_511 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:178
  logic and_513;
  assign and_513 = not_510 & (~less_511);
  // hls/stages/agreement.hpp:558
  logic less_1244;
  assign less_1244 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1245;
  assign select_1245 = less_1244 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1246;
  assign less_1246 = middle_sum_sum_sums_values_0_q < select_1245;
  logic [7:0] select_1247;
  assign select_1247 = less_1246 ? select_1245 : middle_sum_sum_sums_values_0_q;
  logic less_1728;
  assign less_1728 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1729;
  assign select_1729 = less_1728 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1730;
  assign less_1730 = select_1247 < select_1729;
  logic [7:0] select_1731;
  assign select_1731 = less_1730 ? select_1729 : select_1247;
  // hls/stages/agreement.hpp:599
  logic [7:0] of_best;
  assign of_best = and_513 ? select_1731 : 8'h0;
  // hls/stages/agreement.hpp:606
  logic or_1734;
  assign or_1734 = select_508_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:611
  logic [5:0] select_1735;
  assign select_1735 = or_1734 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:559
  logic or_1737;
  assign or_1737 = less_1244 | (~less_1246);
  logic [2:0] select_1738;
  assign select_1738 = less_1730 ? {less_1728, 2'h0} : {1'b0, or_1737, less_1246};
  // hls/stages/agreement.hpp:611
  logic [2:0] select_1739;
  assign select_1739 = or_1734 ? select_1738 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1740;
  assign select_1740 = or_1734 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:608
  logic equal_1741;
  assign equal_1741 = select_1738 == 3'h1;
  logic equal_1742;
  assign equal_1742 = select_1738 == 3'h2;
  logic not_1743;
  assign not_1743 = ~equal_1742;
  logic [1:0] select_1744;
  assign select_1744 = equal_1741 ? 2'h0 : {not_1743, equal_1742};
  logic [7:0] select_1745;
  assign select_1745 = select_1744[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1746;
  assign select_1746 = select_1744[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:611
  logic [7:0] select_1748;
  assign select_1748 = or_1734 ? (select_1744[1] ? select_1745 : select_1746) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:609
  logic [2:0] select_1749;
  assign select_1749 = equal_1741 ? 3'h2 : {not_1743, {2{equal_1742}}};
  logic [7:0] select_1750;
  assign select_1750 = select_1749[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1752;
  assign select_1752 = select_1749[1] ? select_1750 : (select_1749[0] ? select_1731 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:611
  logic [7:0] select_1754;
  assign select_1754 = or_1734 ? (select_1749[2] ? sums_3_sum_sums_values_0_q : select_1752) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1756;
  assign sum_1756 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1757;
  assign sum_1757 = {1'b0, before_v} + sum_1756;
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1759;
  assign sum_1759 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1760;
  assign sum_1760 = {1'b0, before_v_2} + sum_1759;
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1762;
  assign sum_1762 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1763;
  assign sum_1763 = {1'b0, before_v_3} + sum_1762;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1765;
  assign select_1765 = (sum_1760 < sum_1763) ? sum_1763 : sum_1760;
  logic [6:0] select_1767;
  assign select_1767 = (sum_1757 < select_1765) ? select_1765 : sum_1757;
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1769;
  assign sum_1769 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1770;
  assign sum_1770 = {1'b0, before_v_4} + sum_1769;
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1772;
  assign sum_1772 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1773;
  assign sum_1773 = {1'b0, before_v_5} + sum_1772;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1775;
  assign select_1775 = (sum_1770 < sum_1773) ? sum_1773 : sum_1770;
  // hls/stages/agreement.hpp:600
  logic [6:0] of_near;
  assign of_near = and_513 ? ((select_1767 < select_1775) ? select_1775 : select_1767) : 7'h0;
  // hls/stages/agreement.hpp:611
  logic or_1780;
  assign or_1780 = select_508_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:615
  logic [6:0] select_1781;
  assign select_1781 = or_1780 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1782;
  assign select_1782 = or_1780 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:620
  logic or_1792;
  assign or_1792 = select_1790_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:624
  logic [7:0] select_1793;
  assign select_1793 = or_1792 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1794;
  assign select_1794 = or_1792 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1796;
  assign or_1796 = select_1790_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:628
  logic [6:0] select_1797;
  assign select_1797 = or_1796 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1798;
  assign select_1798 = or_1796 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:746
  logic not_1800;
  assign not_1800 = ~equal_1799_s2_q;
  // hls/stages/agreement.hpp:182
  logic and_1810;
  assign and_1810 = not_388_s2_q & and_1809_s2_q;
  // hls/stages/agreement.hpp:726
  logic select_1816;
  assign select_1816 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:727
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:733
  logic [8:0] difference_1819;
  assign difference_1819 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:734
  logic [9:0] sum_1820;
  assign sum_1820 = {difference_1819[8], difference_1819} + 10'h1;
  // hls/stages/agreement.hpp:182
  logic and_1822;
  assign and_1822 = (and_1809_s2_q & select_1816) & ({{22{sum_1820[9]}}, sum_1820} < 32'h3);
  logic and_1823;
  assign and_1823 = not_388_s2_q & and_1822;
  logic and_1829;
  assign and_1829 = not_388_s2_q & (and_1822 & or_1827_s2_q);
  // hls/stages/agreement.hpp:191
  logic [8:0] select_1830;
  assign select_1830 = less_387_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_380_s2_q ? {select_1830, and_1829, and_1823, and_1813_s2_q, and_1810, and_1806_s2_q, not_388_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:211
  logic and_1832;
  assign and_1832 = ends_cell_s2_q & inside_v[0];
  logic and_1834;
  assign and_1834 = not_1800 & (so_s2_q & and_1832);
  // hls/stages/agreement.hpp:197
  logic right_2;
  assign right_2 = inside_v[0] & less_1882_s2_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:215
  logic select_2113;
  assign select_2113 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2115;
  assign select_2115 = sample_pair_whole_s2_q ? (and_357_s2_q ? select_372 : averager_mask_q) : averager_mask_q;
  logic select_2117;
  assign select_2117 = sample_pair_whole_s2_q ? (and_357_s2_q ? select_376 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/registration.hpp:76
  logic less_2502;
  assign less_2502 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:191
  logic [7:0] select_2504;
  assign select_2504 = or_380_s2_q ? (less_387_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2506;
  assign select_2506 = or_380_s2_q ? (less_387_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2508;
  assign select_2508 = or_380_s2_q ? (less_387_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2506} - {1'b0, select_2508};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2510;
  assign select_2510 = rise[8] ? select_2506 : select_2508;
  logic [8:0] difference_2511;
  assign difference_2511 = {1'b0, select_2504} - {1'b0, select_2510};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2511[8] ? 8'h0 : difference_2511[7:0];
  // hls/stages/registration.hpp:37
  logic not_2513;
  assign not_2513 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2502 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2513};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2515;
  assign xor_2515 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2515};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2521;
  assign select_2521 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2502 ? {taken, 1'b1} : {not_2513, select_2521, not_2513};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2523;
  assign sum_2523 = {left, 1'b1} + {taken_2, less_2502};
  // hls/stages/agreement.hpp:192
  logic [4:0] select_2525;
  assign select_2525 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;

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
  assign census_memory_re = s2_en & and_359_s2_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1075; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1834;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1099; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1834;
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
  assign averager_memory_waddr = select_326_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_334_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_353, and_349, sum_345, sum_341};
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

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q;
  logic best_left_we;
  assign best_left_we = s2_en & and_1783_s2_q;
  logic [45:0] best_left_wdata;
  assign best_left_wdata = {select_1782, select_1781, select_1754, select_1748, select_1740, select_1739, select_1735};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {^best_left_wdata, best_left_wdata};
  end
`ifndef SYNTHESIS
  logic [6:0] best_left_raddr_s1_sim;
  logic best_left_re_s1_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s1_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s1_sim <= best_left_re;
      best_left_raddr_s1_sim <= best_left_raddr;
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
      if (best_left_waddr >= 7'd80) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 7'd80) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = right_s2_q;
  logic best_right_we;
  assign best_right_we = s2_en & and_1783_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_1798, select_1797, select_1794, select_1793};
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      sample_of_skin_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= pixel_0_s2_q;
      sample_pair_pixel_1_q <= pixel_1_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_of_skin_q <= select_2113;
      averager_mask_q <= select_2115;
      averager_of_skin_q <= select_2117;
      registration_displacement_over_q <= so_s2_q ? sum_2523[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2525;
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
    if (s2_en) begin
      averager_running_0_q <= sample_pair_whole_s2_q ? select_337 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_343 : averager_running_1_q;
    end
  end

  logic saturated_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic [6:0] column_s3_q;
  logic and_357_s3_q;
  logic and_359_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_362_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic and_377_s3_q;
  logic so_s3_q;
  logic equal_420_s3_q;
  logic equal_1799_s3_q;
  logic not_1800_s3_q;
  logic [13:0] inside_v_s3_q;
  logic and_1834_s3_q;
  logic [6:0] select_1838_s3_q;
  logic and_1843_s3_q;
  logic right_2_s3_q;
  logic equal_1922_s3_q;
  logic textured_s3_q;
  logic and_2060_s3_q;
  logic equal_2200_s3_q;
  logic equal_2321_s3_q;
  logic and_2556_s3_q;
  logic less_2561_s3_q;
  logic and_2627_s3_q;
  logic and_2629_s3_q;
  logic less_2736_s3_q;
  logic equal_2943_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      saturated_s3_q <= saturated_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[1];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      column_s3_q <= column_s2_q;
      and_357_s3_q <= and_357_s2_q;
      and_359_s3_q <= and_359_s2_q;
      grey_s3_q <= grey;
      equal_362_s3_q <= equal_362_s2_q;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      and_377_s3_q <= sample_pair_whole_s2_q & select_376;
      so_s3_q <= so_s2_q;
      equal_420_s3_q <= equal_420_s2_q;
      equal_1799_s3_q <= equal_1799_s2_q;
      not_1800_s3_q <= not_1800;
      inside_v_s3_q <= {inside_v[14:3], inside_v[1:0]};
      and_1834_s3_q <= and_1834;
      select_1838_s3_q <= select_1838_s2_q;
      and_1843_s3_q <= not_1800 & (so_s2_q ? and_1832 : (equal_379_s2_q & inside_v[4]));
      right_2_s3_q <= right_2;
      equal_1922_s3_q <= equal_1922_s2_q;
      textured_s3_q <= textured;
      and_2060_s3_q <= not_1800 & and_2059_s2_q;
      equal_2200_s3_q <= equal_2200_s2_q;
      equal_2321_s3_q <= equal_2321_s2_q;
      and_2556_s3_q <= inside_v[4] & less_2555_s2_q;
      less_2561_s3_q <= select_2506 < select_2508;
      and_2627_s3_q <= and_2627_s2_q;
      and_2629_s3_q <= and_2629_s2_q;
      less_2736_s3_q <= less_2736_s2_q;
      equal_2943_s3_q <= equal_2943_s2_q;
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
  logic [7:0] registration_slope_here_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [3:0] registration_fresh_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  logic [8:0] region_down_rest_q;
  logic [6:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic region_fresh_q;
  logic segment_starts_q;
  logic [2:0] box_textured_columns_values_0_q;
  logic [2:0] box_textured_columns_values_1_q;
  logic [2:0] box_textured_columns_values_2_q;
  logic [2:0] box_textured_columns_values_3_q;
  logic [2:0] box_textured_columns_values_4_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [2:0] box_explained_columns_values_0_q;
  logic [2:0] box_explained_columns_values_1_q;
  logic [2:0] box_explained_columns_values_2_q;
  logic [2:0] box_explained_columns_values_3_q;
  logic [2:0] box_explained_columns_values_4_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [2:0] box_shown_columns_values_0_q;
  logic [2:0] box_shown_columns_values_1_q;
  logic [2:0] box_shown_columns_values_2_q;
  logic [2:0] box_shown_columns_values_3_q;
  logic [2:0] box_shown_columns_values_4_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [2:0] box_nearer_columns_values_0_q;
  logic [2:0] box_nearer_columns_values_1_q;
  logic [2:0] box_nearer_columns_values_2_q;
  logic [2:0] box_nearer_columns_values_3_q;
  logic [2:0] box_nearer_columns_values_4_q;
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
  logic drew_q;
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
  assign total = {2'h0, grey_s3_q} + (equal_362_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_365;
  assign select_365 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_362_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_369;
  assign select_369 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:214
  logic less_393;
  assign less_393 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_394;
  assign less_394 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_395;
  assign less_395 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_396;
  assign less_396 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_397;
  assign less_397 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_398;
  assign less_398 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_399;
  assign less_399 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_400;
  assign less_400 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_401;
  assign less_401 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_402;
  assign less_402 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_403;
  assign less_403 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_404;
  assign less_404 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_405;
  assign less_405 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_406;
  assign less_406 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_407;
  assign less_407 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_408;
  assign less_408 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_409;
  assign less_409 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_410;
  assign less_410 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_411;
  assign less_411 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_412;
  assign less_412 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_413;
  assign less_413 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_414;
  assign less_414 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_415;
  assign less_415 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_416;
  assign less_416 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:309
  logic equal_417;
  assign equal_417 = column_s3_q == 7'h0;
  logic [3:0] select_421;
  assign select_421 = equal_420_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:310
  logic [4:0] select_422;
  assign select_422 = equal_417 ? {select_421, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_423;
  assign select_423 = equal_417 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:219
  logic and_424;
  assign and_424 = select_422[4] & select_423[3];
  // hls/stages/census.hpp:206
  logic and_426;
  assign and_426 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_428;
  assign and_428 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_426);
  // hls/stages/agreement.hpp:310
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_428;
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
  logic [9:0] difference_451;
  assign difference_451 = {1'b0, select_365} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_452;
  assign xor_452 = difference_451[8:0] ^ {9{difference_451[9]}};
  logic [9:0] sum_453;
  assign sum_453 = {9'h0, difference_451[9]} + {1'b0, xor_452};
  logic [9:0] difference_454;
  assign difference_454 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_455;
  assign xor_455 = difference_454[8:0] ^ {9{difference_454[9]}};
  logic [9:0] sum_456;
  assign sum_456 = {9'h0, difference_454[9]} + {1'b0, xor_455};
  logic [9:0] difference_458;
  assign difference_458 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_459;
  assign xor_459 = difference_458[8:0] ^ {9{difference_458[9]}};
  logic [9:0] sum_460;
  assign sum_460 = {9'h0, difference_458[9]} + {1'b0, xor_459};
  logic [10:0] sum_461;
  assign sum_461 = ({1'b0, sum_453} + {1'b0, sum_456}) + {1'b0, sum_460};
  logic [9:0] difference_462;
  assign difference_462 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_463;
  assign xor_463 = difference_462[8:0] ^ {9{difference_462[9]}};
  logic [9:0] sum_464;
  assign sum_464 = {9'h0, difference_462[9]} + {1'b0, xor_463};
  logic [9:0] difference_466;
  assign difference_466 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_467;
  assign xor_467 = difference_466[8:0] ^ {9{difference_466[9]}};
  logic [9:0] sum_468;
  assign sum_468 = {9'h0, difference_466[9]} + {1'b0, xor_467};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_461} + {2'h0, sum_464}) + {2'h0, sum_468};
  // hls/stages/agreement.hpp:139
  logic not_1839;
  assign not_1839 = ~so_s3_q;
  // hls/stages/agreement.hpp:211
  logic and_1840;
  assign and_1840 = not_1839 & inside_v_s3_q[4];
  // hls/stages/agreement.hpp:858
  logic equal_1844;
  assign equal_1844 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:898
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:139
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:859
  logic [1:0] select_1847;
  assign select_1847 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:871
  logic [3:0] select_1849;
  assign select_1849 = equal_1844 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1847});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1850;
  assign sum_1850 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:211
  logic [3:0] select_1851;
  assign select_1851 = equal_1799_s3_q ? select_1849 : {sum_1850, lower_half_s3_q, registration_of_right_q};
  // hls/stages/agreement.hpp:896
  logic equal_1852;
  assign equal_1852 = x_s3_q[5:0] == 6'h3e;
  logic equal_1854;
  assign equal_1854 = x_s3_q[5:0] == 6'h3d;
  logic equal_1856;
  assign equal_1856 = x_s3_q[5:0] == 6'h3c;
  logic equal_1858;
  assign equal_1858 = x_s3_q[5:0] == 6'h3b;
  logic equal_1860;
  assign equal_1860 = x_s3_q[5:0] == 6'h36;
  logic equal_1862;
  assign equal_1862 = x_s3_q[5:0] == 6'h35;
  logic equal_1864;
  assign equal_1864 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:898
  logic and_1868;
  assign and_1868 = (~equal_1858) & ((~equal_1860) & ((~equal_1862) & (~equal_1864)));
  // hls/stages/agreement.hpp:859
  logic less_1872;
  assign less_1872 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:140
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:152
  logic or_1876;
  assign or_1876 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:871
  logic select_1879;
  assign select_1879 = equal_1844 ? ((~equal_1852) & ((~equal_1854) & ((~equal_1856) & and_1868))) : (less_1872 & (~or_1876));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1887;
  assign sum_1887 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1889;
  assign and_1889 = half_ends & ({{3{sum_1887[4]}}, sum_1887} < 8'h3);
  // hls/stages/agreement.hpp:211
  logic and_1890;
  assign and_1890 = so_s3_q & and_1889;
  // hls/stages/registration.hpp:243
  logic not_1893;
  assign not_1893 = ~lower_half_s3_q;
  logic [3:0] select_1894;
  assign select_1894 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1893, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1893};
  // hls/stages/agreement.hpp:143
  logic [7:0] select_1907;
  assign select_1907 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:780
  logic or_1910;
  assign or_1910 = select_1907[7] | (~({select_1907[5], select_1907[3], select_1907[1]} == 3'h0));
  // hls/stages/agreement.hpp:779
  logic or_1913;
  assign or_1913 = select_1907[7] | (~({select_1907[6], select_1907[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:778
  logic or_1916;
  assign or_1916 = select_1907[7] | (~(select_1907[6:4] == 3'h0));
  // hls/stages/agreement.hpp:211
  logic [5:0] select_1917;
  assign select_1917 = equal_1799_s3_q ? x_s3_q[5:0] : {region_row_q, or_1916, or_1913, or_1910};
  // hls/stages/agreement.hpp:858
  logic not_1918;
  assign not_1918 = ~equal_1844;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1920;
  assign sum_1920 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:788
  logic or_1923;
  assign or_1923 = (~sum_1920[5]) | equal_1922_s3_q;
  // hls/stages/agreement.hpp:211
  logic and_1926;
  assign and_1926 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & or_1923));
  // hls/stages/agreement.hpp:197
  logic explained;
  assign explained = inside_v_s3_q[0] & inside_v_s3_q[3];
  logic and_1940;
  assign and_1940 = inside_v_s3_q[0] & ({inside_v_s3_q[4], inside_v_s3_q[2]} == 2'h3);
  logic and_1947;
  assign and_1947 = inside_v_s3_q[0] & inside_v_s3_q[2];
  // hls/stages/agreement.hpp:751
  logic select_1948;
  assign select_1948 = slot_s3_q[2] ? shown_shown_q : inside_v_s3_q[3];
  // hls/stages/agreement.hpp:197
  logic shown;
  assign shown = inside_v_s3_q[0] & (shown_right_rdata_q[0] | select_1948);
  // hls/stages/agreement.hpp:751
  logic select_1951;
  assign select_1951 = slot_s3_q[2] ? shown_nearer_q : inside_v_s3_q[4];
  // hls/stages/agreement.hpp:197
  logic near;
  assign near = inside_v_s3_q[0] & (select_1948 ? select_1951 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:983
  logic or_1954;
  assign or_1954 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:985
  logic [17:0] select_1956;
  assign select_1956 = marks_first_s3_q ? 18'h1 : (or_1954 ? {rows_passed_q[16:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:984
  logic [8:0] select_1958;
  assign select_1958 = or_1954 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:992
  logic select_1960;
  assign select_1960 = cfg_compete_i ? (or_1954 & select_1956[17]) : (select_1958[8] & select_1956[9]);
  // hls/stages/agreement.hpp:218
  logic next_row;
  assign next_row = select_1960 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:999
  logic [6:0] select_1963;
  assign select_1963 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_1965;
  assign select_1965 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_1963});
  // hls/stages/agreement.hpp:1009
  logic equal_1966;
  assign equal_1966 = seen_x_q == 3'h7;
  logic [7:0] select_1968;
  assign select_1968 = select_1960 ? 8'h0 : (seen_column_q + {7'h0, equal_1966});
  // hls/stages/agreement.hpp:1012
  logic [12:0] index;
  assign index = select_1965 + {5'h0, select_1968};
  // hls/stages/agreement.hpp:983
  logic select_1971;
  assign select_1971 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:969
  logic [7:0] sum_1972;
  assign sum_1972 = {1'b0, select_1971, 2'h0, select_1971, 1'b0, {2{select_1971}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:982
  logic not_1973;
  assign not_1973 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:218
  logic and_1975;
  assign and_1975 = not_1973 & (began_q | select_1960);
  // hls/stages/agreement.hpp:1010
  logic [2:0] select_1977;
  assign select_1977 = select_1960 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1011
  logic and_1979;
  assign and_1979 = and_1975 & (select_1977 == 3'h0);
  logic less_1980;
  assign less_1980 = select_1968 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:841
  logic [7:0] sum_1983;
  assign sum_1983 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1983[7]}}, sum_1983, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:969
  logic [7:0] sum_1985;
  assign sum_1985 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:764
  logic and_1986;
  assign and_1986 = seen_columns_rdata_q[14] & inside_v_s3_q[0];
  logic and_1987;
  assign and_1987 = seen_columns_rdata_q[10] & inside_v_s3_q[0];
  logic and_1988;
  assign and_1988 = seen_columns_rdata_q[5] & inside_v_s3_q[0];
  logic and_1989;
  assign and_1989 = seen_columns_rdata_q[0] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:817
  logic [1:0] sum_1991;
  assign sum_1991 = {1'b0, and_1988} + ({1'b0, textured_s3_q} + {1'b0, and_1989});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1986} + ({2'h0, and_1987} + {1'b0, sum_1991});
  // hls/stages/agreement.hpp:824
  logic [2:0] select_1994;
  assign select_1994 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1995;
  assign difference_1995 = {1'b0, textured_2} - {1'b0, select_1994};
  // hls/stages/agreement.hpp:822
  logic equal_1996;
  assign equal_1996 = x_s3_q == 8'h0;
  // hls/stages/agreement.hpp:824
  logic [4:0] t;
  assign t = {difference_1995[3], difference_1995} + (equal_1996 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:764
  logic [7:0] select_2001;
  assign select_2001 = inside_v_s3_q[0] ? (sum_1920[5] ? select_1907 : {select_1907[6:0], 1'b0}) : select_1907;
  // hls/stages/agreement.hpp:780
  logic or_2004;
  assign or_2004 = select_2001[7] | (~({select_2001[5], select_2001[3], select_2001[1]} == 3'h0));
  // hls/stages/agreement.hpp:764
  logic and_2021;
  assign and_2021 = seen_columns_rdata_q[16] & inside_v_s3_q[0];
  logic and_2022;
  assign and_2022 = seen_columns_rdata_q[12] & inside_v_s3_q[0];
  logic and_2023;
  assign and_2023 = seen_columns_rdata_q[8] & inside_v_s3_q[0];
  logic and_2024;
  assign and_2024 = seen_columns_rdata_q[3] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:819
  logic [1:0] sum_2026;
  assign sum_2026 = {1'b0, and_2023} + ({1'b0, shown} + {1'b0, and_2024});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2021} + ({2'h0, and_2022} + {1'b0, sum_2026});
  // hls/stages/agreement.hpp:826
  logic [2:0] select_2029;
  assign select_2029 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2030;
  assign difference_2030 = {1'b0, shown_2} - {1'b0, select_2029};
  logic [4:0] around;
  assign around = {difference_2030[3], difference_2030} + (equal_1996 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:833
  logic [5:0] sum_2033;
  assign sum_2033 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:764
  logic and_2037;
  assign and_2037 = seen_columns_rdata_q[17] & inside_v_s3_q[0];
  logic and_2038;
  assign and_2038 = seen_columns_rdata_q[13] & inside_v_s3_q[0];
  logic and_2039;
  assign and_2039 = seen_columns_rdata_q[9] & inside_v_s3_q[0];
  logic and_2040;
  assign and_2040 = seen_columns_rdata_q[4] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:820
  logic [1:0] sum_2042;
  assign sum_2042 = {1'b0, and_2039} + ({1'b0, near} + {1'b0, and_2040});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2037} + ({2'h0, and_2038} + {1'b0, sum_2042});
  // hls/stages/agreement.hpp:827
  logic [2:0] select_2045;
  assign select_2045 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2046;
  assign difference_2046 = {1'b0, near_2} - {1'b0, select_2045};
  logic [4:0] n;
  assign n = {difference_2046[3], difference_2046} + (equal_1996 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:215
  logic [10:0] select_2092;
  assign select_2092 = sample_pair_whole_s3_q ? (and_357_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2094;
  assign select_2094 = sample_pair_whole_s3_q ? (and_357_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:365
  logic [8:0] select_2118;
  assign select_2118 = and_359_s3_q ? select_365 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2119;
  assign select_2119 = and_359_s3_q ? select_369 : census_columns_values_0_cell_0_right_q;
  logic select_2120;
  assign select_2120 = and_359_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_2121;
  assign select_2121 = and_359_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2122;
  assign select_2122 = and_359_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2123;
  assign select_2123 = and_359_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2124;
  assign select_2124 = and_359_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2125;
  assign select_2125 = and_359_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2126;
  assign select_2126 = and_359_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2127;
  assign select_2127 = and_359_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2128;
  assign select_2128 = and_359_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2129;
  assign select_2129 = and_359_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2130;
  assign select_2130 = and_359_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2131;
  assign select_2131 = and_359_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2132;
  assign select_2132 = and_359_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2133;
  assign select_2133 = and_359_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2134;
  assign select_2134 = and_359_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2135;
  assign select_2135 = and_359_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2136;
  assign select_2136 = and_359_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2137;
  assign select_2137 = and_359_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2138;
  assign select_2138 = and_359_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2139;
  assign select_2139 = and_359_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2140;
  assign select_2140 = and_359_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2141;
  assign select_2141 = and_359_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2142;
  assign select_2142 = and_359_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2143;
  assign select_2143 = and_359_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2144;
  assign select_2144 = and_359_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2145;
  assign select_2145 = and_359_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2146;
  assign select_2146 = and_359_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2147;
  assign select_2147 = and_359_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2148;
  assign select_2148 = and_359_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2149;
  assign select_2149 = and_359_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2150;
  assign select_2150 = and_359_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2151;
  assign select_2151 = and_359_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2152;
  assign select_2152 = and_359_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2153;
  assign select_2153 = and_359_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2154;
  assign select_2154 = and_359_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2155;
  assign select_2155 = and_359_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2156;
  assign select_2156 = and_359_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2157;
  assign select_2157 = and_359_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2158;
  assign select_2158 = and_359_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2159;
  assign select_2159 = and_359_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2160;
  assign select_2160 = and_359_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2161;
  assign select_2161 = and_359_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2162;
  assign select_2162 = and_359_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2163;
  assign select_2163 = and_359_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2164;
  assign select_2164 = and_359_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2165;
  assign select_2165 = and_359_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2166;
  assign select_2166 = and_359_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2167;
  assign select_2167 = and_359_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2168;
  assign select_2168 = and_359_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2169;
  assign select_2169 = and_359_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2170;
  assign select_2170 = and_359_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2171;
  assign select_2171 = and_359_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2172;
  assign select_2172 = and_359_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2173;
  assign select_2173 = and_359_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_2175;
  assign difference_2175 = {1'b0, select_369} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2176;
  assign xor_2176 = difference_2175[8:0] ^ {9{difference_2175[9]}};
  logic [9:0] sum_2177;
  assign sum_2177 = {9'h0, difference_2175[9]} + {1'b0, xor_2176};
  logic [9:0] difference_2178;
  assign difference_2178 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2179;
  assign xor_2179 = difference_2178[8:0] ^ {9{difference_2178[9]}};
  logic [9:0] sum_2180;
  assign sum_2180 = {9'h0, difference_2178[9]} + {1'b0, xor_2179};
  logic [9:0] difference_2182;
  assign difference_2182 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2183;
  assign xor_2183 = difference_2182[8:0] ^ {9{difference_2182[9]}};
  logic [9:0] sum_2184;
  assign sum_2184 = {9'h0, difference_2182[9]} + {1'b0, xor_2183};
  logic [10:0] sum_2185;
  assign sum_2185 = ({1'b0, sum_2177} + {1'b0, sum_2180}) + {1'b0, sum_2184};
  logic [9:0] difference_2186;
  assign difference_2186 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2187;
  assign xor_2187 = difference_2186[8:0] ^ {9{difference_2186[9]}};
  logic [9:0] sum_2188;
  assign sum_2188 = {9'h0, difference_2186[9]} + {1'b0, xor_2187};
  logic [9:0] difference_2190;
  assign difference_2190 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2191;
  assign xor_2191 = difference_2190[8:0] ^ {9{difference_2190[9]}};
  logic [9:0] sum_2192;
  assign sum_2192 = {9'h0, difference_2190[9]} + {1'b0, xor_2191};
  // hls/stages/census.hpp:273
  logic [9:0] difference_2220;
  assign difference_2220 = {1'b0, select_365} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2220[9]} + (difference_2220[8:0] ^ {9{difference_2220[9]}});
  logic [9:0] difference_2231;
  assign difference_2231 = {1'b0, select_369} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2231[9]} + (difference_2231[8:0] ^ {9{difference_2231[9]}});
  // hls/stages/agreement.hpp:365
  logic and_2418;
  assign and_2418 = and_359_s3_q & (equal_420_s3_q & equal_2321_s3_q);
  // hls/stages/agreement.hpp:211
  logic and_2421;
  assign and_2421 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & inside_v_s3_q[1]));
  // hls/stages/agreement.hpp:764
  logic and_2442;
  assign and_2442 = seen_columns_rdata_q[15] & inside_v_s3_q[0];
  logic and_2443;
  assign and_2443 = seen_columns_rdata_q[11] & inside_v_s3_q[0];
  logic and_2444;
  assign and_2444 = seen_columns_rdata_q[7] & inside_v_s3_q[0];
  logic and_2445;
  assign and_2445 = seen_columns_rdata_q[2] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:818
  logic [1:0] sum_2447;
  assign sum_2447 = {1'b0, and_2444} + ({1'b0, explained} + {1'b0, and_2445});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2442} + ({2'h0, and_2443} + {1'b0, sum_2447});
  // hls/stages/agreement.hpp:825
  logic [2:0] select_2450;
  assign select_2450 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2451;
  assign difference_2451 = {1'b0, explained_2} - {1'b0, select_2450};
  logic [4:0] e;
  assign e = {difference_2451[3], difference_2451} + (equal_1996 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:832
  logic [5:0] sum_2454;
  assign sum_2454 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:211
  logic and_2482;
  assign and_2482 = ends_cell_s3_q & (inside_v_s3_q[0] & (inside_v_s3_q[2:1] == 2'h3));
  // hls/stages/registration.hpp:83
  logic equal_2526;
  assign equal_2526 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:206
  logic [16:0] select_2528;
  assign select_2528 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2528[16:7])) ? 8'h7f : select_2528[7:0];
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2526 ? registration_slope_here_q : change;
  // hls/stages/registration.hpp:201
  logic [7:0] select_2532;
  assign select_2532 = inside_v_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2533;
  assign select_2533 = inside_v_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2534;
  assign difference_2534 = {{2{select_2532[7]}}, select_2532[7:1]} - {select_2533[7], select_2533};
  // hls/stages/registration.hpp:199
  logic [6:0] select_2535;
  assign select_2535 = inside_v_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2536;
  assign select_2536 = inside_v_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2537;
  assign sum_2537 = {{2{select_2535[6]}}, select_2535} + {select_2536[7], select_2536};
  // hls/stages/registration.hpp:200
  logic [7:0] select_2538;
  assign select_2538 = inside_v_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2539;
  assign select_2539 = inside_v_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2540;
  assign sum_2540 = {{2{select_2538[7]}}, select_2538[7:1]} + {select_2539[7], select_2539};
  // hls/stages/registration.hpp:202
  logic [10:0] sum_2541;
  assign sum_2541 = {{3{sum_2537[8]}}, sum_2537[8:1]} + {sum_2540[8], sum_2540, select_2538[0]};
  logic [9:0] sum_2542;
  assign sum_2542 = {difference_2534, select_2532[0]} + {sum_2541[10], sum_2541[10:2]};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2543;
  assign sum_2543 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_2542[9]}}, sum_2542[9:2]};
  // hls/stages/registration.hpp:206
  logic [7:0] select_2546;
  assign select_2546 = ($signed(sum_2543[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2543[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] select_2548;
  assign select_2548 = equal_2526 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2543[12:7])) ? 8'h7f : select_2546);
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2550;
  assign select_2550 = equal_1799_s3_q ? registration_slope_here_q : (so_s3_q ? select_2548 : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2551;
  assign equal_2551 = slot_s3_q == 3'h4;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2560;
  assign sum_2560 = inside_v_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2562;
  assign difference_2562 = {sum_2560, inside_v_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2563;
  assign select_2563 = less_2561_s3_q ? difference_2562 : {sum_2560, inside_v_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2564;
  assign select_2564 = ((inside_v_s3_q[13:11] == 3'h0) | (inside_v_s3_q[13:11] == 3'h4)) ? {sum_2560, inside_v_s3_q[11], 5'h0} : select_2563;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2564[7]}}, select_2564} - {sum_2542[9], sum_2542, sum_2541[1]};
  // hls/stages/registration.hpp:206
  logic [11:0] select_2567;
  assign select_2567 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2567[11:7])) ? 12'h7f : select_2567;
  // hls/stages/agreement.hpp:211
  logic select_2611;
  assign select_2611 = so_s3_q ? (equal_2551 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_2614;
  assign select_2614 = so_s3_q ? (equal_2526 ? inside_v_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:254
  logic [3:0] select_2619;
  assign select_2619 = (sum_1850 == 2'h2) ? (registration_fresh_q & (~select_1894)) : registration_fresh_q;
  // hls/stages/agreement.hpp:211
  logic [3:0] select_2621;
  assign select_2621 = so_s3_q ? (and_1889 ? select_2619 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:227
  logic [3:0] select_2623;
  assign select_2623 = and_2418 ? 4'hf : (equal_1799_s3_q ? registration_fresh_q : select_2621);
  // hls/stages/registration.hpp:121
  logic [15:0] select_2630;
  assign select_2630 = and_2629_s3_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:124
  logic [23:0] select_2632;
  assign select_2632 = and_2627_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2630[15]}}, select_2630});
  // hls/stages/registration.hpp:122
  logic [15:0] select_2633;
  assign select_2633 = and_2629_s3_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2633[15]}}, select_2633};
  // hls/stages/registration.hpp:124
  logic [27:0] select_2635;
  assign select_2635 = and_2627_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:135
  logic and_2636;
  assign and_2636 = ends_cell_s3_q & so_s3_q;
  // hls/stages/registration.hpp:117
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_2636 ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:859
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1847;
  // hls/stages/registration.hpp:243
  logic not_2644;
  assign not_2644 = ~quarter_2[1];
  logic [3:0] select_2645;
  assign select_2645 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2644, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2644};
  // hls/stages/agreement.hpp:211
  logic select_2733;
  assign select_2733 = equal_1799_s3_q ? shown_shown_q : (so_s3_q ? select_1948 : shown_shown_q);
  logic select_2735;
  assign select_2735 = equal_1799_s3_q ? shown_nearer_q : (so_s3_q ? select_1951 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2737;
  assign sum_2737 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:314
  logic [2:0] select_2739;
  assign select_2739 = less_2736_s3_q ? (sum_2737[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2741;
  assign select_2741 = equal_2321_s3_q ? (equal_420_s3_q ? 3'h0 : select_2739) : region_row_q;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2746;
  assign select_2746 = equal_1799_s3_q ? select_1907 : (so_s3_q ? (ends_cell_s3_q ? select_2001 : select_1907) : 8'h1);
  // hls/stages/agreement.hpp:143
  logic [8:0] select_2748;
  assign select_2748 = so_s3_q ? (and_2636 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2750;
  assign sum_2750 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2751;
  assign select_2751 = sum_1920[5] ? {1'b1, sum_1920[4:0], region_across_rest_q[2:0]} : sum_2750;
  // hls/stages/agreement.hpp:314
  logic [8:0] select_2753;
  assign select_2753 = equal_2321_s3_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_2756;
  assign select_2756 = equal_2321_s3_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  logic [8:0] select_2760;
  assign select_2760 = equal_420_s3_q ? {{2{difference_2758[6]}}, difference_2758} : (less_2736_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:365
  logic [8:0] select_2762;
  assign select_2762 = and_359_s3_q ? (equal_2321_s3_q ? select_2760 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:314
  logic [6:0] select_2764;
  assign select_2764 = equal_420_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:365
  logic [6:0] select_2766;
  assign select_2766 = and_359_s3_q ? (equal_2321_s3_q ? select_2764 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2767;
  assign sum_2767 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2768;
  assign select_2768 = sum_2737[7] ? {1'b1, sum_2737[6:0], region_down_rest_q[0]} : sum_2767;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2737[7];
  // hls/stages/agreement.hpp:314
  logic select_2772;
  assign select_2772 = equal_2321_s3_q ? (equal_420_s3_q | (less_2736_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:143
  logic or_2777;
  assign or_2777 = segment_starts_q | not_1839;
  // hls/stages/agreement.hpp:764
  logic select_2780;
  assign select_2780 = inside_v_s3_q[0] ? (sum_1920[5] ? (equal_1922_s3_q & or_1923) : or_1923) : or_2777;
  // hls/stages/agreement.hpp:211
  logic select_2783;
  assign select_2783 = equal_1799_s3_q ? or_2777 : (so_s3_q ? (ends_cell_s3_q ? select_2780 : or_2777) : or_2777);
  // hls/stages/agreement.hpp:871
  logic equal_2808;
  assign equal_2808 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:211
  logic [2:0] select_2859;
  assign select_2859 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_2861;
  assign select_2861 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2863;
  assign select_2863 = equal_1799_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_2861 : box_textured_columns_values_1_q);
  logic [2:0] select_2864;
  assign select_2864 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2866;
  assign select_2866 = equal_1799_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_2864 : box_textured_columns_values_2_q);
  logic [2:0] select_2867;
  assign select_2867 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2869;
  assign select_2869 = equal_1799_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_2867 : box_textured_columns_values_3_q);
  logic [2:0] select_2870;
  assign select_2870 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2872;
  assign select_2872 = equal_1799_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_2870 : box_textured_columns_values_4_q);
  logic [4:0] select_2874;
  assign select_2874 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_2877;
  assign select_2877 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_2879;
  assign select_2879 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2881;
  assign select_2881 = equal_1799_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_2879 : box_explained_columns_values_1_q);
  logic [2:0] select_2882;
  assign select_2882 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2884;
  assign select_2884 = equal_1799_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_2882 : box_explained_columns_values_2_q);
  logic [2:0] select_2885;
  assign select_2885 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2887;
  assign select_2887 = equal_1799_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_2885 : box_explained_columns_values_3_q);
  logic [2:0] select_2888;
  assign select_2888 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2890;
  assign select_2890 = equal_1799_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_2888 : box_explained_columns_values_4_q);
  logic [4:0] select_2892;
  assign select_2892 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2893;
  assign select_2893 = equal_1799_s3_q ? box_explained_sum_sums_values_0_q : select_2892;
  logic [2:0] select_2895;
  assign select_2895 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2897;
  assign select_2897 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2899;
  assign select_2899 = equal_1799_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_2897 : box_shown_columns_values_1_q);
  logic [2:0] select_2900;
  assign select_2900 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2902;
  assign select_2902 = equal_1799_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_2900 : box_shown_columns_values_2_q);
  logic [2:0] select_2903;
  assign select_2903 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2905;
  assign select_2905 = equal_1799_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_2903 : box_shown_columns_values_3_q);
  logic [2:0] select_2906;
  assign select_2906 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2908;
  assign select_2908 = equal_1799_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_2906 : box_shown_columns_values_4_q);
  logic [4:0] select_2910;
  assign select_2910 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_2913;
  assign select_2913 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2915;
  assign select_2915 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2917;
  assign select_2917 = equal_1799_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_2915 : box_nearer_columns_values_1_q);
  logic [2:0] select_2918;
  assign select_2918 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2920;
  assign select_2920 = equal_1799_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_2918 : box_nearer_columns_values_2_q);
  logic [2:0] select_2921;
  assign select_2921 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2923;
  assign select_2923 = equal_1799_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_2921 : box_nearer_columns_values_3_q);
  logic [2:0] select_2924;
  assign select_2924 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2926;
  assign select_2926 = equal_1799_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_2924 : box_nearer_columns_values_4_q);
  logic [4:0] select_2928;
  assign select_2928 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_2931;
  assign select_2931 = so_s3_q ? (ends_cell_s3_q ? and_1988 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2934;
  assign select_2934 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & inside_v_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_2936;
  assign select_2936 = equal_1799_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_2934 : centres_values_0_of_skin_q);
  logic select_2937;
  assign select_2937 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2939;
  assign select_2939 = equal_1799_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_2937 : centres_values_1_textured_q);
  logic select_2940;
  assign select_2940 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2942;
  assign select_2942 = equal_1799_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_2940 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:314
  logic [12:0] select_2946;
  assign select_2946 = equal_2321_s3_q ? (equal_2943_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:365
  logic [6:0] select_2949;
  assign select_2949 = and_359_s3_q ? (equal_2321_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1008
  logic [2:0] select_2960;
  assign select_2960 = select_1960 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:218
  logic [7:0] select_2966;
  assign select_2966 = marks_first_s3_q ? (less_2962 ? {sum_2963, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1012
  logic and_2972;
  assign and_2972 = and_2060_s3_q & ({sum_1985, index_2[5:0]} == {sum_1972, index[5:0]});
  // hls/stages/registration.hpp:243
  logic not_3024;
  assign not_3024 = ~quarter[1];
  logic [3:0] select_3025;
  assign select_3025 = quarter[0] ? {quarter[1], 1'b0, not_3024, 1'b0} : {1'b0, quarter[1], 1'b0, not_3024};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:261; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1851;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & (equal_1799_s3_q ? (x_s3_q[6] & select_1879) : and_1890);
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1092; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1917;
  logic regions_re;
  assign regions_re = s3_en & (equal_1799_s3_q ? (x_s3_q[6] & not_1918) : and_1926);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1103; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1972, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_1979 & less_1980);
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
  assign census_memory_we = s3_en & and_359_s3_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_377_s3_q, whole_2_s3_q, select_369, select_365};
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

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1838_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1843_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1840, not_1839};
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
  assign seen_columns_waddr = x_s3_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_1834_s3_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1947, textured_s3_q};
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
      registration_slope_here_q <= 8'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      registration_fresh_q <= 4'hf;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 7'h0;
      region_down_next_q <= 9'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
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
      drew_q <= 1'b0;
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
      census_filled_q <= and_359_s3_q ? {select_423[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_359_s3_q ? select_422 : rows_passed_above_q;
      registration_slope_here_q <= select_2550;
      registration_of_right_q <= equal_1799_s3_q ? registration_of_right_q : select_2611;
      registration_was_inside_q <= equal_1799_s3_q ? registration_was_inside_q : select_2614;
      registration_fresh_q <= select_2623;
      registration_slope_row_q <= select_2632;
      registration_slope_change_q <= select_2635;
      registration_slope_q <= so_s3_q ? column_7 : {registration_slope_row_q, 4'h0};
      shown_shown_q <= select_2733;
      shown_nearer_q <= select_2735;
      region_row_q <= and_359_s3_q ? select_2741 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_2746;
      region_across_rest_q <= select_2748;
      region_across_back_q <= so_s3_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2751;
      columns_begin_rest_q <= and_359_s3_q ? select_2753 : columns_begin_rest_q;
      columns_begin_back_q <= and_359_s3_q ? select_2756 : columns_begin_back_q;
      region_down_rest_q <= select_2762;
      region_down_back_q <= select_2766;
      region_down_next_q <= select_2768;
      region_fresh_q <= and_359_s3_q ? select_2772 : region_fresh_q;
      segment_starts_q <= select_2783;
      centres_values_0_textured_q <= equal_1799_s3_q ? centres_values_0_textured_q : select_2931;
      centres_values_0_of_skin_q <= select_2936;
      centres_values_1_textured_q <= select_2939;
      centres_values_1_of_skin_q <= select_2942;
      map_row_q <= and_359_s3_q ? select_2946 : map_row_q;
      map_width_q <= select_2949;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1971;
      done_q <= not_1973 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1799_s3_q & equal_2808;
      rows_passed_q <= select_1956;
      columns_passed_q <= {select_1958[7:0], or_1954};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_1975;
      seen_x_q <= select_1977;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_2960;
      seen_column_q <= select_1968;
      seen_rows_left_q <= select_2966;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_1965;
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
    box_textured_columns_values_0_q = 3'h0;
    box_textured_columns_values_1_q = 3'h0;
    box_textured_columns_values_2_q = 3'h0;
    box_textured_columns_values_3_q = 3'h0;
    box_textured_columns_values_4_q = 3'h0;
    box_textured_sum_sums_values_0_q = 5'h0;
    box_explained_columns_values_0_q = 3'h0;
    box_explained_columns_values_1_q = 3'h0;
    box_explained_columns_values_2_q = 3'h0;
    box_explained_columns_values_3_q = 3'h0;
    box_explained_columns_values_4_q = 3'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_shown_columns_values_0_q = 3'h0;
    box_shown_columns_values_1_q = 3'h0;
    box_shown_columns_values_2_q = 3'h0;
    box_shown_columns_values_3_q = 3'h0;
    box_shown_columns_values_4_q = 3'h0;
    box_shown_sum_sums_values_0_q = 5'h0;
    box_nearer_columns_values_0_q = 3'h0;
    box_nearer_columns_values_1_q = 3'h0;
    box_nearer_columns_values_2_q = 3'h0;
    box_nearer_columns_values_3_q = 3'h0;
    box_nearer_columns_values_4_q = 3'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      averager_total_0_q <= select_2092;
      averager_total_1_q <= select_2094;
      census_columns_values_0_cell_0_left_q <= select_2118;
      census_columns_values_0_cell_0_right_q <= select_2119;
      census_columns_values_0_cell_0_mask_q <= select_2120;
      census_columns_values_0_cell_1_left_q <= select_2121;
      census_columns_values_0_cell_1_right_q <= select_2122;
      census_columns_values_0_cell_1_mask_q <= select_2123;
      census_columns_values_0_cell_2_left_q <= select_2124;
      census_columns_values_0_cell_2_right_q <= select_2125;
      census_columns_values_0_cell_2_mask_q <= select_2126;
      census_columns_values_0_cell_2_of_skin_q <= select_2127;
      census_columns_values_0_cell_3_left_q <= select_2128;
      census_columns_values_0_cell_3_right_q <= select_2129;
      census_columns_values_0_cell_3_mask_q <= select_2130;
      census_columns_values_0_cell_4_left_q <= select_2131;
      census_columns_values_0_cell_4_right_q <= select_2132;
      census_columns_values_0_cell_4_mask_q <= select_2133;
      census_columns_values_1_cell_0_left_q <= select_2134;
      census_columns_values_1_cell_0_right_q <= select_2135;
      census_columns_values_1_cell_0_mask_q <= select_2136;
      census_columns_values_1_cell_1_left_q <= select_2137;
      census_columns_values_1_cell_1_right_q <= select_2138;
      census_columns_values_1_cell_1_mask_q <= select_2139;
      census_columns_values_1_cell_2_left_q <= select_2140;
      census_columns_values_1_cell_2_right_q <= select_2141;
      census_columns_values_1_cell_2_mask_q <= select_2142;
      census_columns_values_1_cell_2_of_skin_q <= select_2143;
      census_columns_values_1_cell_3_left_q <= select_2144;
      census_columns_values_1_cell_3_right_q <= select_2145;
      census_columns_values_1_cell_3_mask_q <= select_2146;
      census_columns_values_1_cell_4_left_q <= select_2147;
      census_columns_values_1_cell_4_right_q <= select_2148;
      census_columns_values_1_cell_4_mask_q <= select_2149;
      census_columns_values_2_cell_0_left_q <= select_2150;
      census_columns_values_2_cell_0_right_q <= select_2151;
      census_columns_values_2_cell_0_mask_q <= select_2152;
      census_columns_values_2_cell_1_left_q <= select_2153;
      census_columns_values_2_cell_1_right_q <= select_2154;
      census_columns_values_2_cell_1_mask_q <= select_2155;
      census_columns_values_2_cell_2_left_q <= select_2156;
      census_columns_values_2_cell_2_right_q <= select_2157;
      census_columns_values_2_cell_2_mask_q <= select_2158;
      census_columns_values_2_cell_3_left_q <= select_2159;
      census_columns_values_2_cell_3_right_q <= select_2160;
      census_columns_values_2_cell_3_mask_q <= select_2161;
      census_columns_values_2_cell_4_left_q <= select_2162;
      census_columns_values_2_cell_4_right_q <= select_2163;
      census_columns_values_2_cell_4_mask_q <= select_2164;
      census_columns_values_3_cell_0_mask_q <= select_2165;
      census_columns_values_3_cell_1_left_q <= select_2166;
      census_columns_values_3_cell_1_right_q <= select_2167;
      census_columns_values_3_cell_1_mask_q <= select_2168;
      census_columns_values_3_cell_2_mask_q <= select_2169;
      census_columns_values_3_cell_3_left_q <= select_2170;
      census_columns_values_3_cell_3_right_q <= select_2171;
      census_columns_values_3_cell_3_mask_q <= select_2172;
      census_columns_values_3_cell_4_mask_q <= select_2173;
      sharpness_last_mean_0_q <= and_359_s3_q ? select_365 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_359_s3_q ? select_369 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1799_s3_q ? box_textured_columns_values_0_q : select_2859;
      box_textured_columns_values_1_q <= select_2863;
      box_textured_columns_values_2_q <= select_2866;
      box_textured_columns_values_3_q <= select_2869;
      box_textured_columns_values_4_q <= select_2872;
      box_textured_sum_sums_values_0_q <= equal_1799_s3_q ? box_textured_sum_sums_values_0_q : select_2874;
      box_explained_columns_values_0_q <= equal_1799_s3_q ? box_explained_columns_values_0_q : select_2877;
      box_explained_columns_values_1_q <= select_2881;
      box_explained_columns_values_2_q <= select_2884;
      box_explained_columns_values_3_q <= select_2887;
      box_explained_columns_values_4_q <= select_2890;
      box_explained_sum_sums_values_0_q <= select_2893;
      box_shown_columns_values_0_q <= equal_1799_s3_q ? box_shown_columns_values_0_q : select_2895;
      box_shown_columns_values_1_q <= select_2899;
      box_shown_columns_values_2_q <= select_2902;
      box_shown_columns_values_3_q <= select_2905;
      box_shown_columns_values_4_q <= select_2908;
      box_shown_sum_sums_values_0_q <= equal_1799_s3_q ? box_shown_sum_sums_values_0_q : select_2910;
      box_nearer_columns_values_0_q <= equal_1799_s3_q ? box_nearer_columns_values_0_q : select_2913;
      box_nearer_columns_values_1_q <= select_2917;
      box_nearer_columns_values_2_q <= select_2920;
      box_nearer_columns_values_3_q <= select_2923;
      box_nearer_columns_values_4_q <= select_2926;
      box_nearer_sum_sums_values_0_q <= equal_1799_s3_q ? box_nearer_sum_sums_values_0_q : select_2928;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic sample_pair_whole_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [7:0] x_s4_q;
  logic [2:0] slot_s4_q;
  logic ends_cell_s4_q;
  logic lower_half_s4_q;
  logic registration_of_right_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic centres_values_1_textured_s4_q;
  logic centres_values_1_of_skin_s4_q;
  logic [6:0] column_s4_q;
  logic and_357_s4_q;
  logic and_359_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_362_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_404_s4_q;
  logic less_405_s4_q;
  logic less_406_s4_q;
  logic less_407_s4_q;
  logic less_408_s4_q;
  logic less_409_s4_q;
  logic less_410_s4_q;
  logic less_411_s4_q;
  logic less_412_s4_q;
  logic less_413_s4_q;
  logic less_414_s4_q;
  logic less_415_s4_q;
  logic less_416_s4_q;
  logic and_424_s4_q;
  logic and_449_s4_q;
  logic and_450_s4_q;
  logic [11:0] texture_s4_q;
  logic equal_1799_s4_q;
  logic not_1800_s4_q;
  logic equal_1844_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1850_s4_q;
  logic equal_1852_s4_q;
  logic equal_1854_s4_q;
  logic equal_1856_s4_q;
  logic equal_1858_s4_q;
  logic equal_1860_s4_q;
  logic equal_1862_s4_q;
  logic equal_1864_s4_q;
  logic less_1872_s4_q;
  logic or_1876_s4_q;
  logic equal_1896_s4_q;
  logic and_1906_s4_q;
  logic or_1910_s4_q;
  logic or_1913_s4_q;
  logic or_1916_s4_q;
  logic not_1918_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1940_s4_q;
  logic and_1945_s4_q;
  logic and_1979_s4_q;
  logic less_1980_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_1985_s4_q;
  logic equal_1999_s4_q;
  logic or_2004_s4_q;
  logic or_2007_s4_q;
  logic or_2010_s4_q;
  logic not_2035_s4_q;
  logic less_2049_s4_q;
  logic and_2060_s4_q;
  logic [11:0] sum_2193_s4_q;
  logic equal_2200_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2418_s4_q;
  logic and_2422_s4_q;
  logic not_2456_s4_q;
  logic and_2484_s4_q;
  logic equal_2526_s4_q;
  logic and_2554_s4_q;
  logic and_2556_s4_q;
  logic [11:0] residual_s4_q;
  logic equal_2647_s4_q;
  logic equal_2808_s4_q;
  logic and_2972_s4_q;
  logic and_2987_s4_q;
  logic equal_3027_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s4_q <= x_s3_q;
      slot_s4_q <= slot_s3_q;
      ends_cell_s4_q <= ends_cell_s3_q;
      lower_half_s4_q <= lower_half_s3_q;
      registration_of_right_s4_q <= registration_of_right_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      column_s4_q <= column_s3_q;
      and_357_s4_q <= and_357_s3_q;
      and_359_s4_q <= and_359_s3_q;
      grey_s4_q <= grey_s3_q;
      equal_362_s4_q <= equal_362_s3_q;
      grey_2_s4_q <= grey_2_s3_q;
      whole_2_s4_q <= whole_2_s3_q;
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
      less_404_s4_q <= less_404;
      less_405_s4_q <= less_405;
      less_406_s4_q <= less_406;
      less_407_s4_q <= less_407;
      less_408_s4_q <= less_408;
      less_409_s4_q <= less_409;
      less_410_s4_q <= less_410;
      less_411_s4_q <= less_411;
      less_412_s4_q <= less_412;
      less_413_s4_q <= less_413;
      less_414_s4_q <= less_414;
      less_415_s4_q <= less_415;
      less_416_s4_q <= less_416;
      and_424_s4_q <= and_424;
      and_449_s4_q <= whole_22 & and_424;
      and_450_s4_q <= census_columns_values_1_cell_2_mask_q & and_424;
      texture_s4_q <= texture;
      equal_1799_s4_q <= equal_1799_s3_q;
      not_1800_s4_q <= not_1800_s3_q;
      equal_1844_s4_q <= equal_1844;
      all_s4_q <= all;
      sum_1850_s4_q <= sum_1850;
      equal_1852_s4_q <= equal_1852;
      equal_1854_s4_q <= equal_1854;
      equal_1856_s4_q <= equal_1856;
      equal_1858_s4_q <= equal_1858;
      equal_1860_s4_q <= equal_1860;
      equal_1862_s4_q <= equal_1862;
      equal_1864_s4_q <= equal_1864;
      less_1872_s4_q <= less_1872;
      or_1876_s4_q <= or_1876;
      equal_1896_s4_q <= (registration_fresh_q & select_1894) == 4'h0;
      and_1906_s4_q <= not_1800_s3_q & and_1890;
      or_1910_s4_q <= or_1910;
      or_1913_s4_q <= or_1913;
      or_1916_s4_q <= or_1916;
      not_1918_s4_q <= not_1918;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1940_s4_q <= and_1940;
      and_1945_s4_q <= not_1800_s3_q & and_1926;
      and_1979_s4_q <= and_1979;
      less_1980_s4_q <= less_1980;
      index_2_s4_q <= index_2[5:0];
      sum_1985_s4_q <= sum_1985;
      equal_1999_s4_q <= t[4:1] == 4'h0;
      or_2004_s4_q <= or_2004;
      or_2007_s4_q <= select_2001[7] | (~({select_2001[6], select_2001[3:2]} == 3'h0));
      or_2010_s4_q <= select_2001[7] | (~(select_2001[6:4] == 3'h0));
      not_2035_s4_q <= ~({sum_2033, around[0]} < {2'h0, t});
      less_2049_s4_q <= {1'b0, around[4:1]} < n;
      and_2060_s4_q <= and_2060_s3_q;
      sum_2193_s4_q <= ({1'b0, sum_2185} + {2'h0, sum_2188}) + {2'h0, sum_2192};
      equal_2200_s4_q <= equal_2200_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2418_s4_q <= and_2418;
      and_2422_s4_q <= not_1800_s3_q & and_2421;
      not_2456_s4_q <= ~({sum_2454, e[0]} < {2'h0, t});
      and_2484_s4_q <= not_1800_s3_q & (so_s3_q & and_2482);
      equal_2526_s4_q <= equal_2526;
      and_2554_s4_q <= not_1800_s3_q & (so_s3_q & (half_ends & equal_2551));
      and_2556_s4_q <= and_2556_s3_q;
      residual_s4_q <= residual;
      equal_2647_s4_q <= (registration_fresh_q & select_2645) == 4'h0;
      equal_2808_s4_q <= equal_2808;
      and_2972_s4_q <= and_2972;
      and_2987_s4_q <= equal_1799_s3_q & (equal_2808 & (cfg_prove_i & (~proven_q)));
      equal_3027_s4_q <= (registration_fresh_q & select_3025) == 4'h0;
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
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic [1:0] sharpness_comparing_contrast_0_q;
  logic [1:0] sharpness_comparing_contrast_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic sharpness_comparing_less_contrast_0_q;
  logic sharpness_comparing_less_contrast_1_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_explained_q;
  logic [13:0] counts_nearer_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
  logic [13:0] counts_skin_unproven_q;
  logic [13:0] registration_half_across_q;
  logic [5:0] registration_half_measured_q;
  logic [6:0] registration_half_votes_down_q;
  logic [6:0] registration_half_votes_up_q;
  logic [6:0] registration_half_half_votes_down_q;
  logic [6:0] registration_half_half_votes_up_q;
  logic [13:0] registration_down_q;
  logic [13:0] registration_up_q;
  logic registration_enough_q;
  logic registration_votes_down_q;
  logic registration_votes_up_q;
  logic registration_other_enough_q;
  logic registration_other_down_q;
  logic registration_other_up_q;
  logic registration_moved_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
  logic segment_started_q;
  logic [47:0] good_q;
  logic good_known_q;
  logic [7:0] hidden_for_q;
  logic [13:0] product_q;
  logic product_rest_q;
  logic disagree_q;
  logic too_much_q;
  logic hides_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:201
  logic [12:0] sum_470;
  assign sum_470 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_472;
  assign sum_472 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_470});
  // hls/stages/census.hpp:223
  logic less_473;
  assign less_473 = 9'h4 < sum_472[13:5];
  logic and_474;
  assign and_474 = and_424_s4_q & less_473;
  // hls/stages/registration.hpp:250
  logic equal_1898;
  assign equal_1898 = sum_1850_s4_q == 2'h0;
  // hls/stages/registration.hpp:248
  logic [6:0] down;
  assign down = sum_1850_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:250
  logic [13:0] select_1900;
  assign select_1900 = equal_1898 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1901;
  assign sum_1901 = (equal_1896_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1900[13]}}, select_1900};
  // hls/stages/registration.hpp:249
  logic [6:0] up;
  assign up = sum_1850_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:251
  logic [6:0] select_1904;
  assign select_1904 = equal_1898 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1905;
  assign sum_1905 = (equal_1896_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1904[6]}}, select_1904};
  // hls/stages/agreement.hpp:658
  logic [6:0] select_1930;
  assign select_1930 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:659
  logic [6:0] sum_1931;
  assign sum_1931 = {6'h0, textured_s4_q} + select_1930;
  // hls/stages/agreement.hpp:791
  logic [9:0] sum_1933;
  assign sum_1933 = {3'h0, sum_1931} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:658
  logic [6:0] select_1935;
  assign select_1935 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:659
  logic [6:0] sum_1936;
  assign sum_1936 = {6'h0, explained_s4_q} + select_1935;
  // hls/stages/agreement.hpp:792
  logic [9:0] sum_1938;
  assign sum_1938 = {3'h0, sum_1936} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:658
  logic [6:0] select_1941;
  assign select_1941 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:660
  logic [6:0] sum_1942;
  assign sum_1942 = {6'h0, and_1940_s4_q} + select_1941;
  // hls/stages/agreement.hpp:793
  logic [9:0] sum_1944;
  assign sum_1944 = {3'h0, sum_1942} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:831
  logic not_2011;
  assign not_2011 = ~region_row_s4_q[2];
  logic [2:0] select_2012;
  assign select_2012 = region_row_s4_q[1] ? {1'b0, not_2011, 1'b0} : {region_row_s4_q[2], 1'b0, not_2011};
  logic [5:0] select_2013;
  assign select_2013 = region_row_s4_q[0] ? {select_2012[2], 1'b0, select_2012[1], 1'b0, select_2012[0], 1'b0} : {1'b0, select_2012[2], 1'b0, select_2012[1], 1'b0, select_2012[0]};
  logic [11:0] select_2014;
  assign select_2014 = or_2010_s4_q ? {select_2013[5], 1'b0, select_2013[4], 1'b0, select_2013[3], 1'b0, select_2013[2], 1'b0, select_2013[1], 1'b0, select_2013[0], 1'b0} : {1'b0, select_2013[5], 1'b0, select_2013[4], 1'b0, select_2013[3], 1'b0, select_2013[2], 1'b0, select_2013[1], 1'b0, select_2013[0]};
  logic [23:0] select_2015;
  assign select_2015 = or_2007_s4_q ? {select_2014[11], 1'b0, select_2014[10], 1'b0, select_2014[9], 1'b0, select_2014[8], 1'b0, select_2014[7], 1'b0, select_2014[6], 1'b0, select_2014[5], 1'b0, select_2014[4], 1'b0, select_2014[3], 1'b0, select_2014[2], 1'b0, select_2014[1], 1'b0, select_2014[0], 1'b0} : {1'b0, select_2014[11], 1'b0, select_2014[10], 1'b0, select_2014[9], 1'b0, select_2014[8], 1'b0, select_2014[7], 1'b0, select_2014[6], 1'b0, select_2014[5], 1'b0, select_2014[4], 1'b0, select_2014[3], 1'b0, select_2014[2], 1'b0, select_2014[1], 1'b0, select_2014[0]};
  logic [47:0] select_2016;
  assign select_2016 = or_2004_s4_q ? {select_2015[23], 1'b0, select_2015[22], 1'b0, select_2015[21], 1'b0, select_2015[20], 1'b0, select_2015[19], 1'b0, select_2015[18], 1'b0, select_2015[17], 1'b0, select_2015[16], 1'b0, select_2015[15], 1'b0, select_2015[14], 1'b0, select_2015[13], 1'b0, select_2015[12], 1'b0, select_2015[11], 1'b0, select_2015[10], 1'b0, select_2015[9], 1'b0, select_2015[8], 1'b0, select_2015[7], 1'b0, select_2015[6], 1'b0, select_2015[5], 1'b0, select_2015[4], 1'b0, select_2015[3], 1'b0, select_2015[2], 1'b0, select_2015[1], 1'b0, select_2015[0], 1'b0} : {1'b0, select_2015[23], 1'b0, select_2015[22], 1'b0, select_2015[21], 1'b0, select_2015[20], 1'b0, select_2015[19], 1'b0, select_2015[18], 1'b0, select_2015[17], 1'b0, select_2015[16], 1'b0, select_2015[15], 1'b0, select_2015[14], 1'b0, select_2015[13], 1'b0, select_2015[12], 1'b0, select_2015[11], 1'b0, select_2015[10], 1'b0, select_2015[9], 1'b0, select_2015[8], 1'b0, select_2015[7], 1'b0, select_2015[6], 1'b0, select_2015[5], 1'b0, select_2015[4], 1'b0, select_2015[3], 1'b0, select_2015[2], 1'b0, select_2015[1], 1'b0, select_2015[0]};
  // hls/stages/agreement.hpp:764
  logic and_2020;
  assign and_2020 = good_known_q & (~((good_q & select_2016) == 48'h0));
  // hls/stages/agreement.hpp:833
  logic is_seen;
  assign is_seen = equal_1999_s4_q ? and_2020 : not_2035_s4_q;
  // hls/stages/agreement.hpp:842
  logic and_2050;
  assign and_2050 = is_seen & less_2049_s4_q;
  // hls/stages/agreement.hpp:215
  logic [8:0] select_2084;
  assign select_2084 = sample_pair_whole_s4_q ? (and_357_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2086;
  assign select_2086 = sample_pair_whole_s4_q ? (and_357_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2088;
  assign select_2088 = sample_pair_whole_s4_q ? (and_357_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2090;
  assign select_2090 = sample_pair_whole_s4_q ? (and_357_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_2095;
  assign sum_2095 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2096;
  assign difference_2096 = {1'b0, sum_2095[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_2097;
  assign xor_2097 = {difference_2096[8:0], sum_2095[0]} ^ {10{difference_2096[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2096[9]} + {1'b0, xor_2097};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_362_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_2102;
  assign select_2102 = sample_pair_whole_s4_q ? (and_357_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_2103;
  assign sum_2103 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2104;
  assign difference_2104 = {1'b0, sum_2103[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_2105;
  assign xor_2105 = {difference_2104[8:0], sum_2103[0]} ^ {10{difference_2104[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2104[9]} + {1'b0, xor_2105};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_362_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_2110;
  assign select_2110 = sample_pair_whole_s4_q ? (and_357_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:365
  logic [11:0] select_2195;
  assign select_2195 = and_359_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2196;
  assign select_2196 = and_359_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2197;
  assign select_2197 = and_359_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2198;
  assign select_2198 = and_359_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_2201;
  assign sum_2201 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2193_s4_q};
  logic [13:0] sum_2203;
  assign sum_2203 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2201});
  // hls/stages/census.hpp:225
  logic and_2205;
  assign and_2205 = and_449_s4_q & (9'h4 < sum_2203[13:5]);
  // hls/stages/census.hpp:226
  logic and_2206;
  assign and_2206 = and_449_s4_q & less_473;
  // hls/stages/census.hpp:227
  logic [19:0] sum_2207;
  assign sum_2207 = census_left_misses_q + {{17{and_2206}}, and_2205, 1'b0, and_2205};
  // hls/stages/agreement.hpp:365
  logic [19:0] select_2209;
  assign select_2209 = and_359_s4_q ? (equal_2200_s4_q ? 20'h0 : sum_2207) : census_left_misses_q;
  // hls/stages/agreement.hpp:215
  logic [27:0] select_2214;
  assign select_2214 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:275
  logic and_2219;
  assign and_2219 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:311
  logic and_2225;
  assign and_2225 = and_2219 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2214[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_2227;
  assign select_2227 = and_2225 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_2229;
  assign select_2229 = equal_2200_s4_q ? {11'h0, select_2227} : (sharpness_sums_detail_0_q + {11'h0, select_2227});
  // hls/stages/agreement.hpp:311
  logic and_2236;
  assign and_2236 = and_2219 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2214[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_2238;
  assign select_2238 = and_2236 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_2240;
  assign select_2240 = equal_2200_s4_q ? {11'h0, select_2238} : (sharpness_sums_detail_1_q + {11'h0, select_2238});
  logic [8:0] select_2243;
  assign select_2243 = and_2225 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2244;
  assign sum_2244 = (equal_2200_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2243};
  logic [8:0] select_2247;
  assign select_2247 = and_2236 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2248;
  assign sum_2248 = (equal_2200_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2247};
  // hls/stages/agreement.hpp:150
  logic equal_2250;
  assign equal_2250 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:289
  logic less_2251;
  assign less_2251 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:328
  logic less_2252;
  assign less_2252 = x_s4_q[4:0] < 5'h3;
  logic not_2253;
  assign not_2253 = ~x_s4_q[1];
  logic [2:0] select_2254;
  assign select_2254 = x_s4_q[0] ? {1'b0, not_2253, 1'b0} : {x_s4_q[1], 1'b0, not_2253};
  logic [5:0] select_2255;
  assign select_2255 = slot_s4_q[2] ? {select_2254[2], 1'b0, select_2254[1], 1'b0, select_2254[0], 1'b0} : {1'b0, select_2254[2], 1'b0, select_2254[1], 1'b0, select_2254[0]};
  logic [11:0] select_2256;
  assign select_2256 = slot_s4_q[1] ? {select_2255[5], 1'b0, select_2255[4], 1'b0, select_2255[3], 1'b0, select_2255[2], 1'b0, select_2255[1], 1'b0, select_2255[0], 1'b0} : {1'b0, select_2255[5], 1'b0, select_2255[4], 1'b0, select_2255[3], 1'b0, select_2255[2], 1'b0, select_2255[1], 1'b0, select_2255[0]};
  logic [23:0] select_2257;
  assign select_2257 = slot_s4_q[0] ? {select_2256[11], 1'b0, select_2256[10], 1'b0, select_2256[9], 1'b0, select_2256[8], 1'b0, select_2256[7], 1'b0, select_2256[6], 1'b0, select_2256[5], 1'b0, select_2256[4], 1'b0, select_2256[3], 1'b0, select_2256[2], 1'b0, select_2256[1], 1'b0, select_2256[0], 1'b0} : {1'b0, select_2256[11], 1'b0, select_2256[10], 1'b0, select_2256[9], 1'b0, select_2256[8], 1'b0, select_2256[7], 1'b0, select_2256[6], 1'b0, select_2256[5], 1'b0, select_2256[4], 1'b0, select_2256[3], 1'b0, select_2256[2], 1'b0, select_2256[1], 1'b0, select_2256[0]};
  // hls/stages/census.hpp:291
  logic and_2261;
  assign and_2261 = less_2252 & (~((sharpness_sums_contrast_1_q & select_2257) == 24'h0));
  // hls/stages/census.hpp:296
  logic [17:0] select_2263;
  assign select_2263 = (less_2251 & and_2261) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2263};
  // hls/stages/agreement.hpp:154
  logic [17:0] select_2266;
  assign select_2266 = equal_2250 ? (less_2251 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:291
  logic and_2271;
  assign and_2271 = less_2252 & (~((sharpness_sums_contrast_0_q & select_2257) == 24'h0));
  // hls/stages/census.hpp:296
  logic [17:0] select_2273;
  assign select_2273 = (less_2251 & and_2271) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2273};
  // hls/stages/agreement.hpp:154
  logic [17:0] select_2276;
  assign select_2276 = equal_2250 ? (less_2251 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2278;
  assign select_2278 = equal_2250 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2280;
  assign select_2280 = equal_2250 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2282;
  assign select_2282 = equal_2250 ? {sharpness_comparing_contrast_0_q[0], and_2271} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2284;
  assign select_2284 = equal_2250 ? {sharpness_comparing_contrast_1_q[0], and_2261} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:302
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:154
  logic select_2289;
  assign select_2289 = drew_q ? (equal_2250 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:302
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:154
  logic select_2293;
  assign select_2293 = drew_q ? (equal_2250 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:288
  logic equal_2294;
  assign equal_2294 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:304
  logic xor_2295;
  assign xor_2295 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2298;
  assign select_2298 = (equal_2294 | xor_2295) ? (five_times[0] & xor_2295) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:154
  logic select_2300;
  assign select_2300 = drew_q ? (equal_2250 ? select_2298 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:304
  logic xor_2301;
  assign xor_2301 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2304;
  assign select_2304 = (equal_2294 | xor_2301) ? (five_times_2[0] & xor_2301) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:154
  logic select_2306;
  assign select_2306 = drew_q ? (equal_2250 ? select_2304 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:305
  logic xor_2307;
  assign xor_2307 = sharpness_comparing_contrast_0_q[1] ^ and_2261;
  logic select_2310;
  assign select_2310 = (equal_2294 | xor_2307) ? (and_2261 & xor_2307) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:154
  logic select_2312;
  assign select_2312 = drew_q ? (equal_2250 ? select_2310 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:305
  logic xor_2313;
  assign xor_2313 = sharpness_comparing_contrast_1_q[1] ^ and_2271;
  logic select_2316;
  assign select_2316 = (equal_2294 | xor_2313) ? (and_2271 & xor_2313) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:154
  logic select_2318;
  assign select_2318 = drew_q ? (equal_2250 ? select_2316 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2424;
  assign select_2424 = and_2418_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2422_s4_q});
  // hls/stages/agreement.hpp:211
  logic and_2427;
  assign and_2427 = not_1800_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2432;
  assign and_2432 = not_1800_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2437;
  assign and_2437 = not_1800_s4_q & (drew_q & (ends_cell_s4_q & and_1940_s4_q));
  // hls/stages/agreement.hpp:835
  logic not_2441;
  assign not_2441 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:836
  logic not_2458;
  assign not_2458 = ~(equal_1999_s4_q ? and_2020 : not_2456_s4_q);
  // hls/stages/agreement.hpp:211
  logic and_2461;
  assign and_2461 = ends_cell_s4_q & (not_2441 & (centres_values_1_textured_s4_q & not_2458));
  logic and_2463;
  assign and_2463 = not_1800_s4_q & (drew_q & and_2461);
  // hls/stages/agreement.hpp:861
  logic less_2466;
  assign less_2466 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2467;
  assign select_2467 = less_2466 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2470;
  assign select_2470 = less_2466 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:862
  logic [10:0] sum_2471;
  assign sum_2471 = {1'b0, select_2470} + {3'h0, select_2470[9:2]};
  logic and_2473;
  assign and_2473 = (~(select_2467[9:4] == 6'h0)) & ({sum_2471, select_2470[1:0]} < {3'h0, select_2467});
  // hls/stages/agreement.hpp:871
  logic [9:0] select_2476;
  assign select_2476 = x_s4_q[6] ? (equal_1844_s4_q ? 10'h0 : (and_2473 ? select_2467 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:211
  logic [9:0] select_2477;
  assign select_2477 = equal_1799_s4_q ? select_2476 : 10'h0;
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2479;
  assign select_2479 = and_2418_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2477});
  logic [13:0] select_2486;
  assign select_2486 = and_2418_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2484_s4_q});
  // hls/stages/agreement.hpp:840
  logic and_2488;
  assign and_2488 = not_2441 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:211
  logic and_2491;
  assign and_2491 = not_1800_s4_q & (drew_q & (ends_cell_s4_q & and_2488));
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2493;
  assign select_2493 = and_2418_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2491});
  // hls/stages/agreement.hpp:840
  logic and_2495;
  assign and_2495 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2458);
  // hls/stages/agreement.hpp:211
  logic and_2499;
  assign and_2499 = not_1800_s4_q & (drew_q & (ends_cell_s4_q & (not_2441 & and_2495)));
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2501;
  assign select_2501 = and_2418_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2499});
  // hls/stages/registration.hpp:106
  logic [7:0] select_2571;
  assign select_2571 = equal_2526_s4_q ? (and_2556_s4_q ? residual_s4_q[7:0] : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2573;
  assign select_2573 = equal_1799_s4_q ? 8'h0 : (drew_q ? select_2571 : 8'h0);
  // hls/stages/registration.hpp:126
  logic [13:0] select_2575;
  assign select_2575 = and_2554_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2573[7]}}, select_2573});
  // hls/stages/agreement.hpp:211
  logic and_2578;
  assign and_2578 = not_1800_s4_q & (drew_q & (and_2556_s4_q & equal_2526_s4_q));
  // hls/stages/registration.hpp:126
  logic [5:0] select_2580;
  assign select_2580 = and_2554_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2578});
  // hls/stages/registration.hpp:106
  logic and_2582;
  assign and_2582 = and_2556_s4_q & ($signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2584;
  assign select_2584 = drew_q ? (equal_2526_s4_q ? {and_2582, and_2556_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2585;
  assign select_2585 = equal_1799_s4_q ? 2'h0 : select_2584;
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2586;
  assign sum_2586 = registration_half_votes_down_q + {{5{select_2585[1]}}, select_2585};
  // hls/stages/registration.hpp:193
  logic [12:0] difference_2588;
  assign difference_2588 = 13'h0 - {residual_s4_q[11], residual_s4_q};
  // hls/stages/registration.hpp:106
  logic and_2590;
  assign and_2590 = and_2556_s4_q & ($signed(difference_2588) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2592;
  assign select_2592 = drew_q ? (equal_2526_s4_q ? {and_2590, and_2556_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2593;
  assign select_2593 = equal_1799_s4_q ? 2'h0 : select_2592;
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2594;
  assign sum_2594 = registration_half_votes_up_q + {{5{select_2593[1]}}, select_2593};
  // hls/stages/registration.hpp:193
  logic less_2596;
  assign less_2596 = $signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2597;
  assign and_2597 = and_2556_s4_q & less_2596;
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2599;
  assign select_2599 = drew_q ? (equal_2526_s4_q ? {and_2597, and_2556_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2600;
  assign select_2600 = equal_1799_s4_q ? 2'h0 : select_2599;
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2601;
  assign sum_2601 = registration_half_half_votes_down_q + {{5{select_2600[1]}}, select_2600};
  // hls/stages/registration.hpp:193
  logic less_2603;
  assign less_2603 = $signed(difference_2588) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2604;
  assign and_2604 = and_2556_s4_q & less_2603;
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2606;
  assign select_2606 = drew_q ? (equal_2526_s4_q ? {and_2604, and_2556_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2607;
  assign select_2607 = equal_1799_s4_q ? 2'h0 : select_2606;
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2608;
  assign sum_2608 = registration_half_half_votes_up_q + {{5{select_2607[1]}}, select_2607};
  // hls/stages/agreement.hpp:211
  logic and_2642;
  assign and_2642 = equal_1799_s4_q & (x_s4_q[6] & (not_1918_s4_q & less_1872_s4_q));
  // hls/stages/agreement.hpp:861
  logic [11:0] select_2649;
  assign select_2649 = or_1876_s4_q ? 12'h0 : (equal_2647_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:871
  logic [11:0] select_2652;
  assign select_2652 = x_s4_q[6] ? (equal_1844_s4_q ? 12'h0 : (less_1872_s4_q ? select_2649 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:211
  logic [11:0] select_2653;
  assign select_2653 = equal_1799_s4_q ? select_2652 : 12'h0;
  // hls/stages/registration.hpp:145
  logic and_2654;
  assign and_2654 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:871
  logic and_2657;
  assign and_2657 = not_1918_s4_q & (less_1872_s4_q & ({and_2654, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:211
  logic and_2659;
  assign and_2659 = equal_1799_s4_q & (x_s4_q[6] & and_2657);
  // hls/stages/registration.hpp:237
  logic [13:0] sum_2661;
  assign sum_2661 = {{2{select_2653[11]}}, select_2653} + (and_2659 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:861
  logic [11:0] select_2664;
  assign select_2664 = or_1876_s4_q ? 12'h0 : (equal_2647_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:871
  logic [11:0] select_2667;
  assign select_2667 = x_s4_q[6] ? (equal_1844_s4_q ? 12'h0 : (less_1872_s4_q ? select_2664 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:211
  logic [11:0] select_2668;
  assign select_2668 = equal_1799_s4_q ? select_2667 : 12'h0;
  // hls/stages/registration.hpp:238
  logic [13:0] sum_2670;
  assign sum_2670 = {{2{select_2668[11]}}, select_2668} + (and_2659 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:142
  logic not_2672;
  assign not_2672 = ~all_s4_q;
  // hls/stages/agreement.hpp:871
  logic and_2675;
  assign and_2675 = not_1918_s4_q & (less_1872_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2672, 1'b0}));
  // hls/stages/agreement.hpp:211
  logic and_2681;
  assign and_2681 = equal_1799_s4_q & (x_s4_q[6] & (not_1918_s4_q & (less_1872_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:231
  logic not_2682;
  assign not_2682 = ~and_2681;
  logic less_2683;
  assign less_2683 = $signed({9'h1, {2{not_2682}}, and_2681}) < $signed(registration_up_q[13:2]);
  logic select_2684;
  assign select_2684 = (equal_1799_s4_q & (x_s4_q[6] & and_2675)) ? less_2683 : registration_enough_q;
  // hls/stages/agreement.hpp:871
  logic and_2688;
  assign and_2688 = x_s4_q[6] & (not_1918_s4_q & (less_1872_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:211
  logic and_2689;
  assign and_2689 = equal_1799_s4_q & and_2688;
  // hls/stages/registration.hpp:227
  logic less_2690;
  assign less_2690 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2692;
  assign less_2692 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:871
  logic and_2697;
  assign and_2697 = x_s4_q[6] & (not_1918_s4_q & (less_1872_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:211
  logic and_2698;
  assign and_2698 = equal_1799_s4_q & and_2697;
  // hls/stages/agreement.hpp:871
  logic and_2705;
  assign and_2705 = x_s4_q[6] & (not_1918_s4_q & (less_1872_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:149
  logic equal_2708;
  assign equal_2708 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:871
  logic and_2711;
  assign and_2711 = not_1918_s4_q & (less_1872_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2708));
  // hls/stages/registration.hpp:229
  logic and_2715;
  assign and_2715 = (equal_1799_s4_q & (x_s4_q[6] & and_2711)) & (less_2692 | less_2690);
  // hls/stages/agreement.hpp:871
  logic and_2720;
  assign and_2720 = not_1918_s4_q & (less_1872_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2708)));
  // hls/stages/registration.hpp:229
  logic and_2723;
  assign and_2723 = registration_votes_up_q & registration_other_down_q;
  logic select_2725;
  assign select_2725 = registration_votes_down_q ? (registration_other_up_q | and_2723) : and_2723;
  // hls/stages/registration.hpp:130
  logic and_2727;
  assign and_2727 = (equal_1799_s4_q & (x_s4_q[6] & and_2720)) & (registration_other_enough_q & select_2725);
  // hls/stages/registration.hpp:230
  logic or_2730;
  assign or_2730 = registration_moved_q | (registration_enough_q & (and_2715 | and_2727));
  // hls/stages/agreement.hpp:908
  logic or_2788;
  assign or_2788 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:930
  logic equal_2790;
  assign equal_2790 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:936
  logic equal_2791;
  assign equal_2791 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:939
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:940
  logic select_2797;
  assign select_2797 = (equal_2790 & equal_2791) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:864
  logic [10:0] sum_2800;
  assign sum_2800 = {1'b0, select_2470} + {2'h0, select_2470[9:1]};
  logic select_2803;
  assign select_2803 = (select_2467[9:3] == 7'h0) ? ((~or_2788) & (~select_2797)) : (~({sum_2800, select_2470[0]} < {2'h0, select_2467}));
  // hls/stages/agreement.hpp:871
  logic [47:0] select_2805;
  assign select_2805 = x_s4_q[6] ? (equal_1844_s4_q ? good_q : {select_2803, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:211
  logic select_2810;
  assign select_2810 = equal_1799_s4_q ? ((x_s4_q[6] & good_known_q) | equal_2808_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:930
  logic equal_2811;
  assign equal_2811 = x_s4_q[6:3] == 4'ha;
  logic equal_2813;
  assign equal_2813 = x_s4_q[6:3] == 4'h9;
  logic equal_2814;
  assign equal_2814 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:855
  logic [13:0] select_2816;
  assign select_2816 = equal_2813 ? counts_skin_unproven_q : (equal_2814 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_2811 ? counts_nearer_q : select_2816;
  // hls/stages/agreement.hpp:935
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:943
  logic select_2819;
  assign select_2819 = (equal_2811 & equal_2791) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:872
  logic not_2820;
  assign not_2820 = ~hidden_for_q[7];
  logic [7:0] select_2822;
  assign select_2822 = select_2819 ? (hidden_for_q + {7'h0, not_2820}) : 8'h0;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2824;
  assign select_2824 = equal_1799_s4_q ? (equal_2808_s4_q ? select_2822 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:943
  logic [13:0] select_2825;
  assign select_2825 = equal_2791 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:855
  logic [7:0] select_2827;
  assign select_2827 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2829;
  assign select_2829 = equal_2814 ? cfg_unproven_skin_limit_i : (equal_2790 ? cfg_unproven_limit_i : select_2827);
  logic [7:0] limit;
  assign limit = equal_2811 ? cfg_regions_limit_i : (equal_2813 ? cfg_hidden_limit_i : select_2829);
  // hls/stages/agreement.hpp:943
  logic not_2832;
  assign not_2832 = ~x_s4_q[2];
  logic [3:0] select_2833;
  assign select_2833 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_2832, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_2832};
  logic [7:0] select_2834;
  assign select_2834 = x_s4_q[0] ? {select_2833[3], 1'b0, select_2833[2], 1'b0, select_2833[1], 1'b0, select_2833[0], 1'b0} : {1'b0, select_2833[3], 1'b0, select_2833[2], 1'b0, select_2833[1], 1'b0, select_2833[0]};
  // hls/stages/agreement.hpp:855
  logic [13:0] select_2838;
  assign select_2838 = equal_2813 ? counts_skin_supervised_q : (equal_2814 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2811 ? counts_textured_q : select_2838;
  // hls/stages/agreement.hpp:943
  logic [13:0] select_2840;
  assign select_2840 = ((limit & select_2834) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2825} + {1'b0, select_2840};
  // hls/stages/agreement.hpp:211
  logic select_2845;
  assign select_2845 = equal_1799_s4_q ? (equal_2791 ? sum_3[0] : (product_rest_q | sum_3[0])) : product_rest_q;
  // hls/stages/agreement.hpp:941
  logic and_2850;
  assign and_2850 = too_much_q & (~(equal_2814 & equal_2791));
  // hls/stages/agreement.hpp:942
  logic select_2855;
  assign select_2855 = (over[14] & equal_2791) ? (and_2850 | ((equal_2814 | equal_2813) | (x_s4_q[6:3] == 4'hf))) : and_2850;
  // hls/stages/agreement.hpp:1012
  logic [1:0] select_2973;
  assign select_2973 = and_2972_s4_q ? {and_2050, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1013
  logic and_2974;
  assign and_2974 = proven_q & less_2962;
  // hls/stages/agreement.hpp:220
  logic select_2977;
  assign select_2977 = and_1979_s4_q ? (less_1980_s4_q ? (select_2973[0] & and_2974) : seen_q) : seen_q;
  logic select_2980;
  assign select_2980 = and_1979_s4_q ? (less_1980_s4_q ? (select_2973[1] & and_2974) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:952
  logic not_2992;
  assign not_2992 = ~(or_2788 | not_2981);
  // hls/stages/agreement.hpp:211
  logic and_2996;
  assign and_2996 = equal_1799_s4_q & (equal_2808_s4_q & (not_2992 & (select_2797 | select_2855)));
  logic and_2999;
  assign and_2999 = equal_1799_s4_q & (equal_2808_s4_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:874
  logic or_3002;
  assign or_3002 = select_2300 | (select_2312 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:211
  logic and_3009;
  assign and_3009 = equal_1799_s4_q & (equal_2808_s4_q & (not_2992 & (select_2306 | select_2318)));
  // hls/stages/agreement.hpp:874
  logic and_3014;
  assign and_3014 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_2822 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:211
  logic and_3021;
  assign and_3021 = equal_1799_s4_q & (x_s4_q[6] & (not_1918_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:869
  logic [31:0] select_3029;
  assign select_3029 = equal_1864_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3027_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3030;
  assign select_3030 = equal_1862_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3029;
  logic [31:0] select_3031;
  assign select_3031 = equal_1860_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3030;
  logic [31:0] select_3032;
  assign select_3032 = equal_1858_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3031;
  logic [31:0] select_3033;
  assign select_3033 = equal_1856_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3032;
  logic [31:0] select_3034;
  assign select_3034 = equal_1854_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_3033;
  logic [31:0] select_3035;
  assign select_3035 = equal_1852_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_3034;
  // hls/stages/agreement.hpp:867
  logic [9:0] select_3036;
  assign select_3036 = less_2466 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:871
  logic [31:0] select_3037;
  assign select_3037 = equal_1844_s4_q ? select_3035 : {2'h0, select_3036, select_2470, select_2467};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_359_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_474, and_450_s4_q, and_449_s4_q, and_424_s4_q, less_416_s4_q, less_415_s4_q, less_414_s4_q, less_413_s4_q, less_412_s4_q, less_411_s4_q, less_410_s4_q, less_409_s4_q, less_408_s4_q, less_407_s4_q, less_406_s4_q, less_405_s4_q, less_404_s4_q, less_403_s4_q, less_402_s4_q, less_401_s4_q, less_400_s4_q, less_399_s4_q, less_398_s4_q, less_397_s4_q, less_396_s4_q, less_395_s4_q, less_394_s4_q, less_393_s4_q};
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

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1850_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1906_s4_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_1905, sum_1901};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {^registration_sums_wdata, registration_sums_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && registration_sums_we) begin
      if (registration_sums_re && registration_sums_raddr == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_waddr >= 4'd12) $error("registration_sums: write outside, address %0d", registration_sums_waddr);
    end
    if (rst_ni && registration_sums_re && registration_sums_raddr >= 4'd12) $error("registration_sums: read outside, address %0d", registration_sums_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s4_q, or_1916_s4_q, or_1913_s4_q, or_1910_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1945_s4_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_1944, sum_1938, sum_1933};
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
  assign map_waddr = {sum_1985_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_2060_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2050, is_seen};
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
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      sharpness_comparing_product_0_q <= 3'h0;
      sharpness_comparing_product_1_q <= 3'h0;
      sharpness_comparing_contrast_0_q <= 2'h0;
      sharpness_comparing_contrast_1_q <= 2'h0;
      sharpness_comparing_carry_0_q <= 1'b0;
      sharpness_comparing_carry_1_q <= 1'b0;
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      sharpness_comparing_less_contrast_0_q <= 1'b0;
      sharpness_comparing_less_contrast_1_q <= 1'b0;
      counts_supervised_q <= 14'h0;
      counts_textured_q <= 14'h0;
      counts_explained_q <= 14'h0;
      counts_nearer_q <= 14'h0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_skin_supervised_q <= 14'h0;
      counts_skin_textured_q <= 14'h0;
      counts_skin_unproven_q <= 14'h0;
      registration_half_across_q <= 14'h0;
      registration_half_measured_q <= 6'h0;
      registration_half_votes_down_q <= 7'h0;
      registration_half_votes_up_q <= 7'h0;
      registration_half_half_votes_down_q <= 7'h0;
      registration_half_half_votes_up_q <= 7'h0;
      registration_down_q <= 14'h0;
      registration_up_q <= 14'h0;
      registration_enough_q <= 1'b0;
      registration_votes_down_q <= 1'b0;
      registration_votes_up_q <= 1'b0;
      registration_other_enough_q <= 1'b0;
      registration_other_down_q <= 1'b0;
      registration_other_up_q <= 1'b0;
      registration_moved_q <= 1'b0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      segment_started_q <= 1'b0;
      good_q <= 48'h0;
      good_known_q <= 1'b0;
      hidden_for_q <= 8'h0;
      product_q <= 14'h0;
      product_rest_q <= 1'b0;
      disagree_q <= 1'b0;
      too_much_q <= 1'b0;
      hides_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s4_en) begin
      census_left_misses_q <= select_2209;
      sharpness_sums_detail_0_q <= and_359_s4_q ? select_2229 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_359_s4_q ? select_2240 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_359_s4_q ? sum_2244 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_359_s4_q ? sum_2248 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2266 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2276 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2278 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2280 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2282 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2284 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2289;
      sharpness_comparing_carry_1_q <= select_2293;
      sharpness_comparing_less_detail_0_q <= select_2300;
      sharpness_comparing_less_detail_1_q <= select_2306;
      sharpness_comparing_less_contrast_0_q <= select_2312;
      sharpness_comparing_less_contrast_1_q <= select_2318;
      counts_supervised_q <= select_2424;
      counts_textured_q <= and_2418_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2427});
      counts_explained_q <= and_2418_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2432});
      counts_nearer_q <= and_2418_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2437});
      counts_unproven_q <= and_2418_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2463});
      counts_regions_bad_q <= select_2479;
      counts_skin_supervised_q <= select_2486;
      counts_skin_textured_q <= select_2493;
      counts_skin_unproven_q <= select_2501;
      registration_half_across_q <= select_2575;
      registration_half_measured_q <= select_2580;
      registration_half_votes_down_q <= and_2554_s4_q ? 7'h0 : sum_2586;
      registration_half_votes_up_q <= and_2554_s4_q ? 7'h0 : sum_2594;
      registration_half_half_votes_down_q <= and_2554_s4_q ? 7'h0 : sum_2601;
      registration_half_half_votes_up_q <= and_2554_s4_q ? 7'h0 : sum_2608;
      registration_down_q <= and_2642 ? sum_2661 : registration_down_q;
      registration_up_q <= and_2642 ? sum_2670 : registration_up_q;
      registration_enough_q <= select_2684;
      registration_votes_down_q <= and_2689 ? less_2690 : registration_votes_down_q;
      registration_votes_up_q <= and_2689 ? less_2692 : registration_votes_up_q;
      registration_other_enough_q <= and_2698 ? select_2684 : registration_other_enough_q;
      registration_other_down_q <= and_2698 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2698 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1799_s4_q & and_2705)) & or_2730;
      segment_textured_q <= select_1930 + {6'h0, and_2427};
      segment_explained_q <= select_1935 + {6'h0, and_2432};
      segment_nearer_q <= select_1941 + {6'h0, and_2437};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1799_s4_q ? select_2805 : good_q;
      good_known_q <= select_2810;
      hidden_for_q <= select_2824;
      product_q <= equal_1799_s4_q ? sum_3[14:1] : product_q;
      product_rest_q <= select_2845;
      disagree_q <= equal_1799_s4_q ? select_2797 : disagree_q;
      too_much_q <= equal_1799_s4_q ? select_2855 : too_much_q;
      hides_q <= equal_1799_s4_q ? select_2819 : hides_q;
      seen_q <= select_2977;
      nearer_q <= select_2980;
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
    if (s4_en) begin
      averager_quarter_1_0_q <= select_2084;
      averager_quarter_1_1_q <= select_2086;
      averager_quarter_2_0_q <= select_2088;
      averager_quarter_2_1_q <= select_2090;
      averager_detail_0_q <= select_2102;
      averager_detail_1_q <= select_2110;
      census_changes_values_0_left_q <= and_359_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_359_s4_q ? sum_2193_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2195;
      census_changes_values_1_right_q <= select_2196;
      census_changes_values_2_left_q <= select_2197;
      census_changes_values_2_right_q <= select_2198;
      sharpness_last_mask_q <= and_359_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_359_s4_q ? select_2214[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_359_s4_q ? select_2214[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_2957_s5_q;
  logic or_2982_s5_q;
  logic and_2983_s5_q;
  logic and_2987_s5_q;
  logic and_2990_s5_q;
  logic and_2996_s5_q;
  logic and_2999_s5_q;
  logic and_3005_s5_q;
  logic and_3009_s5_q;
  logic and_3017_s5_q;
  logic and_3021_s5_q;
  logic [5:0] select_3023_s5_q;
  logic [31:0] select_3039_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_2957_s5_q <= said_q;
      or_2982_s5_q <= not_2981 | select_2977;
      and_2983_s5_q <= cfg_prove_i & select_2980;
      and_2987_s5_q <= and_2987_s4_q;
      and_2990_s5_q <= equal_1799_s4_q & (equal_2808_s4_q & (cfg_prove_i & or_2788));
      and_2996_s5_q <= and_2996;
      and_2999_s5_q <= and_2999;
      and_3005_s5_q <= equal_1799_s4_q & (equal_2808_s4_q & (not_2992 & or_3002));
      and_3009_s5_q <= and_3009;
      and_3017_s5_q <= equal_1799_s4_q & (equal_2808_s4_q & (cfg_prove_i & and_3014));
      and_3021_s5_q <= and_3021;
      select_3023_s5_q <= equal_1799_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3039_s5_q <= equal_1799_s4_q ? (x_s4_q[6] ? select_3037 : 32'h0) : 32'h0;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (averager_memory_error | census_memory_error | fresh_error | left_error | right_codes_error | best_left_error | best_right_error | shown_right_error | registration_sums_error | regions_error | seen_columns_error | map_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign pixel_1_o = pixel_1_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_2982_s5_q;
  assign marks_nearer_o = and_2983_s5_q;
  assign verdict_valid_o = and_2957_s5_q;
  assign verdict_unproven_yet_o = and_2987_s5_q;
  assign verdict_untextured_o = and_2990_s5_q;
  assign verdict_disagree_o = and_2996_s5_q;
  assign verdict_moved_o = and_2999_s5_q;
  assign verdict_unsharp_left_o = and_3005_s5_q;
  assign verdict_unsharp_right_o = and_3009_s5_q;
  assign verdict_hidden_o = and_3017_s5_q;
  assign frame_valid_o = and_3021_s5_q;
  assign frame_index_o = select_3023_s5_q;
  assign frame_word_o = select_3039_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_2541[0], sum_2537[0], sum_2523[0], detail_4[1:0], detail_3[1:0], sum_2203[4:0], sum_472[4:0], cfg_width_i[2:0]};

endmodule
