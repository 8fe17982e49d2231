// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1867 bits, pipeline 635 bits, memories 70060 bits.
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
  logic [5:0] sum_2414;
  assign sum_2414 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_2760;
  assign difference_2760 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2964;
  assign less_2964 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2965;
  assign sum_2965 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_2983;
  assign not_2983 = ~cfg_prove_i;

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
  // hls/stages/census.hpp:115
  logic [8:0] select_325;
  assign select_325 = ({select_322, select_320} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_326;
  assign select_326 = select_320[0] ? averager_place_q : select_325;
  // hls/stages/census.hpp:41
  logic or_327;
  assign or_327 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:394
  logic and_333;
  assign and_333 = (~((~or_327) | (~select_320[0]))) & (select_326[8:6] < 3'h5);
  // hls/stages/census.hpp:41
  logic [2:0] select_338;
  assign select_338 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:394
  logic whole;
  assign whole = select_320[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:255
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_322 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_355;
  assign equal_355 = select_320 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_356;
  assign equal_356 = select_338 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_357;
  assign and_357 = equal_356 & and_333;
  // hls/stages/agreement.hpp:255
  logic and_359;
  assign and_359 = sample_pair_whole_q & (equal_355 & and_357);
  // hls/stages/agreement.hpp:181
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:598
  logic equal_379;
  assign equal_379 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:569
  logic or_380;
  assign or_380 = so | equal_379;
  logic not_381;
  assign not_381 = ~or_380;
  // hls/stages/agreement.hpp:589
  logic equal_382;
  assign equal_382 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:590
  logic equal_384;
  assign equal_384 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:567
  logic [7:0] sum_385;
  assign sum_385 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:569
  logic [7:0] select_386;
  assign select_386 = run_shift_q[5] ? x_q : sum_385;
  logic less_387;
  assign less_387 = {1'b0, last_q} < select_386;
  // hls/stages/agreement.hpp:209
  logic not_388;
  assign not_388 = ~less_387;
  // hls/stages/agreement.hpp:137
  logic and_389;
  assign and_389 = equal_384 & not_388;
  logic and_391;
  assign and_391 = not_381 & ((~equal_382) & and_389);
  // hls/stages/census.hpp:41
  logic [5:0] select_418;
  assign select_418 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:255
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_418 : 6'h0;
  // hls/stages/agreement.hpp:137
  logic select_475;
  assign select_475 = equal_382 ? not_388 : and_389;
  // hls/stages/agreement.hpp:788
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:137
  logic and_499;
  assign and_499 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_386)));
  logic and_500;
  assign and_500 = equal_382 & and_499;
  logic select_501;
  assign select_501 = or_380 ? not_388 : and_500;
  // hls/stages/agreement.hpp:793
  logic equal_504;
  assign equal_504 = {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:797
  logic or_506;
  assign or_506 = equal_504 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:809
  logic [6:0] right;
  assign right = sum_385[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:255
  logic [2:0] select_2067;
  assign select_2067 = sample_pair_whole_q ? (sample_last_q ? (select_338 + 3'h1) : select_338) : raster_at_y_q;
  logic [6:0] select_2069;
  assign select_2069 = sample_pair_whole_q ? (select_322 + {6'h0, equal_355}) : raster_at_column_q;
  logic [5:0] select_2072;
  assign select_2072 = sample_pair_whole_q ? (sample_last_q ? (select_418 + {5'h0, equal_356}) : select_418) : raster_at_row_q;
  logic select_2076;
  assign select_2076 = sample_pair_whole_q ? (sample_last_q ? (or_327 & (~raster_final_row_q)) : or_327) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2078;
  assign select_2078 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:255
  logic select_2082;
  assign select_2082 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:435
  logic equal_2323;
  assign equal_2323 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:440
  logic and_2324;
  assign and_2324 = and_359 & equal_2323;
  // hls/stages/agreement.hpp:498
  logic select_2327;
  assign select_2327 = (and_2324 | (~ends_cell_q)) ? and_2324 : ends_q;
  // hls/stages/agreement.hpp:504
  logic [2:0] now;
  assign now = select_2327 ? (and_2324 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:509
  logic [5:0] select_2331;
  assign select_2331 = select_2327 ? (and_2324 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2334;
  assign select_2334 = select_2327 ? (following_last_shift_q & (~and_2324)) : run_last_shift_q;
  // hls/stages/agreement.hpp:582
  logic and_2337;
  assign and_2337 = run_last_shift_q & equal_382;
  // hls/stages/agreement.hpp:591
  logic select_2339;
  assign select_2339 = equal_382 ? (~run_last_shift_q) : equal_384;
  // hls/stages/agreement.hpp:595
  logic equal_2340;
  assign equal_2340 = run_phase_q == 3'h1;
  logic not_2343;
  assign not_2343 = ~select_2339;
  // hls/stages/agreement.hpp:598
  logic equal_2345;
  assign equal_2345 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:582
  logic and_2346;
  assign and_2346 = final_row_q & so;
  // hls/stages/agreement.hpp:595
  logic [1:0] select_2347;
  assign select_2347 = equal_2345 ? 2'h1 : {2{and_2346}};
  logic [2:0] select_2349;
  assign select_2349 = (and_2337 | (select_2339 | equal_2340)) ? (equal_2340 ? 3'h2 : {not_2343, {2{select_2339}}}) : (equal_379 ? 3'h6 : {select_2347[0], select_2347});
  // hls/stages/agreement.hpp:582
  logic and_2352;
  assign and_2352 = select_2339 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:605
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2355;
  assign select_2355 = (plan_shift_q[5] & select_2339) ? value : 7'h0;
  logic [1:0] or_2356;
  assign or_2356 = {2{so}} | select_2355[5:4];
  // hls/stages/agreement.hpp:608
  logic [7:0] or_2360;
  assign or_2360 = (select_2339 ? plan_columns_q : 8'h0) | ((equal_2340 | equal_2345) ? whole_q : 8'h0);
  logic [1:0] or_2361;
  assign or_2361 = {2{and_2337}} | or_2360[3:2];
  // hls/stages/agreement.hpp:609
  logic [7:0] or_2363;
  assign or_2363 = {or_2360[7:4], or_2361, or_2360[1:0]} | (equal_379 ? drawn_q : 8'h0);
  logic [4:0] or_2364;
  assign or_2364 = {5{so}} | {or_2363[6], or_2363[3:0]};
  // hls/stages/agreement.hpp:615
  logic not_2368;
  assign not_2368 = ~run_shift_q[5];
  logic [7:0] select_2371;
  assign select_2371 = equal_382 ? ({{7{not_2368}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:498
  logic [6:0] select_2375;
  assign select_2375 = and_2324 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:501
  logic [7:0] select_2377;
  assign select_2377 = select_2327 ? {select_2375[6], select_2375} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2380;
  assign select_2380 = select_2327 ? (and_2324 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2388;
  assign select_2388 = and_359 ? (equal_2323 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2391;
  assign select_2391 = and_359 ? (equal_2323 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2394;
  assign select_2394 = and_359 ? (equal_2323 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:506
  logic select_2405;
  assign select_2405 = (ends_cell_q | select_2327) ? (~(now == 3'h6)) : (equal_382 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:501
  logic and_2409;
  assign and_2409 = (~select_2327) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:451
  logic [6:0] sum_2410;
  assign sum_2410 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:436
  logic select_2412;
  assign select_2412 = equal_2323 ? ({sum_2410[6], cfg_height_i[8:3]} == {1'b0, sum_2410[5:0]}) : final_row_q;

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1298; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
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

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:1299; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:1300; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory best_left, 80 x 46 and parity, DISTANCE 12, hls/stages/agreement.hpp:1301; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
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
      raster_at_y_q <= select_2067;
      raster_at_column_q <= select_2069;
      raster_at_row_q <= select_2072;
      raster_at_live_q <= select_2076;
      raster_rows_left_q <= sample_pair_whole_q ? select_2078 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2082;
      averager_place_q <= sample_pair_whole_q ? select_326 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= now;
      run_shift_q <= select_2331;
      run_last_shift_q <= select_2334;
      run_span_q <= select_2327 ? (and_2324 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2349;
      following_shift_q <= select_2339 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2352;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2355[6], or_2356, select_2355[3:0]};
      following_columns_q <= {or_2363[7], or_2364[4], or_2363[5:4], or_2364[3:0]};
      plan_shift_q <= equal_382 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2371;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2377;
      columns_left_q <= select_2380;
      last_q <= and_359 ? (equal_2323 ? column : last_q) : last_q;
      least_q <= select_2388;
      whole_q <= select_2391;
      drawn_q <= select_2394;
      age_q <= select_2327 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2327 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2405;
      ends_q <= and_2409;
      final_row_q <= and_359 ? select_2412 : final_row_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic sample_pair_whole_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [6:0] last_s1_q;
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
  logic select_1792_s1_q;
  logic equal_1801_s1_q;
  logic equal_2323_s1_q;
  logic and_2324_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      last_s1_q <= last_q;
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
      select_1792_s1_q <= or_506 ? equal_504 : ({x[7], last_q} == {1'b0, x[6:0]});
      equal_1801_s1_q <= run_phase_q == 3'h7;
      equal_2323_s1_q <= equal_2323;
      and_2324_s1_q <= and_2324;
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
  // hls/stages/census.hpp:119
  logic and_334;
  assign and_334 = sample_pair_whole_s1_q & and_333_s1_q;
  // hls/stages/agreement.hpp:641
  logic not_479;
  assign not_479 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:644
  logic and_480;
  assign and_480 = left_rdata_q[12] & not_479;
  logic and_481;
  assign and_481 = left_rdata_q[28] & not_479;
  logic and_482;
  assign and_482 = left_rdata_q[44] & not_479;
  logic and_483;
  assign and_483 = left_rdata_q[60] & not_479;
  // hls/stages/agreement.hpp:645
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
  // hls/stages/agreement.hpp:205
  logic and_514;
  assign and_514 = left_rdata_q[44] & not_388_s1_q;
  logic and_515;
  assign and_515 = right_codes_rdata_q[38] & not_388_s1_q;
  logic [11:0] select_516;
  assign select_516 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_517;
  assign select_517 = less_387_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_521;
  assign select_521 = and_514 ? (and_515 ? (~(select_516 ^ select_517)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_527;
  assign parity_527 = ^select_521[5:3];
  logic parity_530;
  assign parity_530 = ^select_521[8:6];
  logic parity_533;
  assign parity_533 = ^select_521[11:3];
  // hls/stages/agreement.hpp:205
  logic and_537;
  assign and_537 = left_rdata_q[60] & not_388_s1_q;
  logic and_538;
  assign and_538 = right_codes_rdata_q[51] & not_388_s1_q;
  logic [11:0] select_539;
  assign select_539 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_540;
  assign select_540 = less_387_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_544;
  assign select_544 = and_537 ? (and_538 ? (~(select_539 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_547;
  assign parity_547 = ^select_544[8:6];
  logic parity_550;
  assign parity_550 = ^select_544[11:9];
  // hls/stages/agreement.hpp:205
  logic and_554;
  assign and_554 = left_rdata_q[76] & not_388_s1_q;
  logic and_555;
  assign and_555 = right_codes_rdata_q[64] & not_388_s1_q;
  logic [11:0] select_556;
  assign select_556 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_557;
  assign select_557 = less_387_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_561;
  assign select_561 = and_554 ? (and_555 ? (~(select_556 ^ select_557)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
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
  // hls/stages/agreement.hpp:671
  logic or_593;
  assign or_593 = (select_521[1:0] == 2'h3) | (select_521[2] & (select_521[0] | select_521[1]));
  // hls/stages/agreement.hpp:673
  logic or_597;
  assign or_597 = (select_544[7:6] == 2'h3) | (select_544[8] & (select_544[6] | select_544[7]));
  logic or_601;
  assign or_601 = (select_544[10:9] == 2'h3) | (select_544[11] & (select_544[9] | select_544[10]));
  // hls/stages/agreement.hpp:671
  logic or_609;
  assign or_609 = (select_561[7:6] == 2'h3) | (select_561[8] & (~(select_561[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_613;
  assign or_613 = (select_561[1:0] == 2'h3) | (select_561[2] & (select_561[0] | select_561[1]));
  logic or_617;
  assign or_617 = (select_561[4:3] == 2'h3) | (select_561[5] & (select_561[3] | select_561[4]));
  // hls/stages/agreement.hpp:672
  logic parity_620;
  assign parity_620 = ^{or_617, or_613, or_609};
  // hls/stages/agreement.hpp:671
  logic or_624;
  assign or_624 = (select_544[4:3] == 2'h3) | (select_544[5] & (select_544[3] | select_544[4]));
  // hls/stages/agreement.hpp:673
  logic or_628;
  assign or_628 = (select_561[10:9] == 2'h3) | (select_561[11] & (select_561[9] | select_561[10]));
  logic or_632;
  assign or_632 = (select_544[1:0] == 2'h3) | (select_544[2] & (select_544[0] | select_544[1]));
  // hls/stages/agreement.hpp:672
  logic parity_635;
  assign parity_635 = ^{or_632, or_628, or_624};
  logic parity_638;
  assign parity_638 = ^{or_632, or_628, or_624, or_617, or_613, or_609, or_601, or_597, or_593};
  // hls/stages/agreement.hpp:673
  logic and_639;
  assign and_639 = parity_533 & parity_588;
  logic or_643;
  assign or_643 = (parity_527 & parity_530) | ((^select_521[11:9]) & (parity_527 | parity_530));
  logic and_646;
  assign and_646 = (^{select_544[11:6], select_521[2:0]}) & (parity_573 | parity_585);
  logic or_647;
  assign or_647 = (parity_573 & parity_585) | and_646;
  // hls/stages/agreement.hpp:671
  logic or_654;
  assign or_654 = (select_521[10:9] == 2'h3) | (select_521[11] & (select_521[9] | select_521[10]));
  // hls/stages/agreement.hpp:673
  logic or_658;
  assign or_658 = (select_521[4:3] == 2'h3) | (select_521[5] & (select_521[3] | select_521[4]));
  logic or_662;
  assign or_662 = (select_521[7:6] == 2'h3) | (select_521[8] & (select_521[6] | select_521[7]));
  // hls/stages/agreement.hpp:672
  logic parity_665;
  assign parity_665 = ^{or_662, or_658, or_654};
  // hls/stages/agreement.hpp:673
  logic or_669;
  assign or_669 = (parity_547 & parity_550) | ((^select_521[2:0]) & (parity_547 | parity_550));
  logic or_673;
  assign or_673 = (parity_567 & parity_570) | ((^select_561[8:6]) & (parity_567 | parity_570));
  logic or_677;
  assign or_677 = (parity_579 & parity_582) | ((^select_544[5:3]) & (parity_579 | parity_582));
  // hls/stages/agreement.hpp:672
  logic parity_680;
  assign parity_680 = ^{or_677, or_673, or_669};
  logic parity_683;
  assign parity_683 = ^{or_677, or_673, or_669, or_662, or_658, or_654, or_647, or_643, and_639};
  logic xor_684;
  assign xor_684 = parity_638 ^ parity_683;
  // hls/stages/agreement.hpp:673
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
  // hls/stages/agreement.hpp:672
  logic parity_711;
  assign parity_711 = ^{or_708, or_704, or_700};
  // hls/stages/agreement.hpp:673
  logic or_715;
  assign or_715 = (or_643 & or_647) | (and_639 & (or_643 | or_647));
  logic or_719;
  assign or_719 = (or_658 & or_662) | (or_654 & (or_658 | or_662));
  logic or_723;
  assign or_723 = (or_673 & or_677) | (or_669 & (or_673 | or_677));
  // hls/stages/agreement.hpp:672
  logic parity_726;
  assign parity_726 = ^{or_723, or_719, or_715};
  logic parity_729;
  assign parity_729 = ^{or_723, or_719, or_715, or_708, or_704, or_700, or_693, or_689, and_685};
  // hls/stages/agreement.hpp:673
  logic or_733;
  assign or_733 = (parity_711 & parity_726) | ((^{or_693, or_689, and_685}) & (parity_711 | parity_726));
  logic or_737;
  assign or_737 = (or_689 & or_693) | (and_685 & (or_689 | or_693));
  logic or_741;
  assign or_741 = (or_704 & or_708) | (or_700 & (or_704 | or_708));
  logic or_745;
  assign or_745 = (or_719 & or_723) | (or_715 & (or_719 | or_723));
  // hls/stages/agreement.hpp:672
  logic parity_750;
  assign parity_750 = ^{or_745, or_741, or_737, or_733};
  // hls/stages/agreement.hpp:673
  logic or_754;
  assign or_754 = (or_741 & or_745) | (or_737 & (or_741 | or_745));
  logic and_755;
  assign and_755 = or_733 & (^{or_745, or_741, or_737});
  // hls/stages/agreement.hpp:672
  logic xor_756;
  assign xor_756 = or_754 ^ and_755;
  // hls/stages/agreement.hpp:675
  logic and_757;
  assign and_757 = or_754 & and_755;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_758;
  assign select_758 = equal_382_s1_q ? {and_757, xor_756, parity_750, parity_729, xor_684, xor_589} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_380_s1_q ? 6'h0 : select_758;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_760;
  assign select_760 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_761;
  assign difference_761 = {1'b0, column_2} - {1'b0, select_760};
  logic [7:0] sum_763;
  assign sum_763 = {difference_761[6], difference_761} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:657
  logic [11:0] select_767;
  assign select_767 = and_514 ? (and_538 ? (~(select_539 ^ select_517)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_773;
  assign parity_773 = ^select_767[5:3];
  logic parity_776;
  assign parity_776 = ^select_767[8:6];
  logic parity_779;
  assign parity_779 = ^select_767[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_786;
  assign select_786 = and_537 ? (and_555 ? (~(select_556 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_789;
  assign parity_789 = ^select_786[8:6];
  logic parity_792;
  assign parity_792 = ^select_786[11:9];
  // hls/stages/agreement.hpp:205
  logic and_796;
  assign and_796 = right_codes_rdata_q[77] & not_388_s1_q;
  logic [11:0] select_797;
  assign select_797 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_801;
  assign select_801 = and_554 ? (and_796 ? (~(select_797 ^ select_557)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
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
  // hls/stages/agreement.hpp:671
  logic or_833;
  assign or_833 = (select_767[1:0] == 2'h3) | (select_767[2] & (select_767[0] | select_767[1]));
  // hls/stages/agreement.hpp:673
  logic or_837;
  assign or_837 = (select_786[7:6] == 2'h3) | (select_786[8] & (select_786[6] | select_786[7]));
  logic or_841;
  assign or_841 = (select_786[10:9] == 2'h3) | (select_786[11] & (select_786[9] | select_786[10]));
  // hls/stages/agreement.hpp:671
  logic or_849;
  assign or_849 = (select_801[7:6] == 2'h3) | (select_801[8] & (~(select_801[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_853;
  assign or_853 = (select_801[1:0] == 2'h3) | (select_801[2] & (select_801[0] | select_801[1]));
  logic or_857;
  assign or_857 = (select_801[4:3] == 2'h3) | (select_801[5] & (select_801[3] | select_801[4]));
  // hls/stages/agreement.hpp:672
  logic parity_860;
  assign parity_860 = ^{or_857, or_853, or_849};
  // hls/stages/agreement.hpp:671
  logic or_864;
  assign or_864 = (select_786[4:3] == 2'h3) | (select_786[5] & (select_786[3] | select_786[4]));
  // hls/stages/agreement.hpp:673
  logic or_868;
  assign or_868 = (select_801[10:9] == 2'h3) | (select_801[11] & (select_801[9] | select_801[10]));
  logic or_872;
  assign or_872 = (select_786[1:0] == 2'h3) | (select_786[2] & (select_786[0] | select_786[1]));
  // hls/stages/agreement.hpp:672
  logic parity_875;
  assign parity_875 = ^{or_872, or_868, or_864};
  logic parity_878;
  assign parity_878 = ^{or_872, or_868, or_864, or_857, or_853, or_849, or_841, or_837, or_833};
  // hls/stages/agreement.hpp:673
  logic and_879;
  assign and_879 = parity_779 & parity_828;
  logic or_883;
  assign or_883 = (parity_773 & parity_776) | ((^select_767[11:9]) & (parity_773 | parity_776));
  logic and_886;
  assign and_886 = (^{select_786[11:6], select_767[2:0]}) & (parity_813 | parity_825);
  logic or_887;
  assign or_887 = (parity_813 & parity_825) | and_886;
  // hls/stages/agreement.hpp:671
  logic or_894;
  assign or_894 = (select_767[10:9] == 2'h3) | (select_767[11] & (select_767[9] | select_767[10]));
  // hls/stages/agreement.hpp:673
  logic or_898;
  assign or_898 = (select_767[4:3] == 2'h3) | (select_767[5] & (select_767[3] | select_767[4]));
  logic or_902;
  assign or_902 = (select_767[7:6] == 2'h3) | (select_767[8] & (select_767[6] | select_767[7]));
  // hls/stages/agreement.hpp:672
  logic parity_905;
  assign parity_905 = ^{or_902, or_898, or_894};
  // hls/stages/agreement.hpp:673
  logic or_909;
  assign or_909 = (parity_789 & parity_792) | ((^select_767[2:0]) & (parity_789 | parity_792));
  logic or_913;
  assign or_913 = (parity_807 & parity_810) | ((^select_801[8:6]) & (parity_807 | parity_810));
  logic or_917;
  assign or_917 = (parity_819 & parity_822) | ((^select_786[5:3]) & (parity_819 | parity_822));
  // hls/stages/agreement.hpp:672
  logic parity_920;
  assign parity_920 = ^{or_917, or_913, or_909};
  logic parity_923;
  assign parity_923 = ^{or_917, or_913, or_909, or_902, or_898, or_894, or_887, or_883, and_879};
  logic xor_924;
  assign xor_924 = parity_878 ^ parity_923;
  // hls/stages/agreement.hpp:673
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
  // hls/stages/agreement.hpp:672
  logic parity_951;
  assign parity_951 = ^{or_948, or_944, or_940};
  // hls/stages/agreement.hpp:673
  logic or_955;
  assign or_955 = (or_883 & or_887) | (and_879 & (or_883 | or_887));
  logic or_959;
  assign or_959 = (or_898 & or_902) | (or_894 & (or_898 | or_902));
  logic or_963;
  assign or_963 = (or_913 & or_917) | (or_909 & (or_913 | or_917));
  // hls/stages/agreement.hpp:672
  logic parity_966;
  assign parity_966 = ^{or_963, or_959, or_955};
  logic parity_969;
  assign parity_969 = ^{or_963, or_959, or_955, or_948, or_944, or_940, or_933, or_929, and_925};
  // hls/stages/agreement.hpp:673
  logic or_973;
  assign or_973 = (parity_951 & parity_966) | ((^{or_933, or_929, and_925}) & (parity_951 | parity_966));
  logic or_977;
  assign or_977 = (or_929 & or_933) | (and_925 & (or_929 | or_933));
  logic or_981;
  assign or_981 = (or_944 & or_948) | (or_940 & (or_944 | or_948));
  logic or_985;
  assign or_985 = (or_959 & or_963) | (or_955 & (or_959 | or_963));
  // hls/stages/agreement.hpp:672
  logic parity_990;
  assign parity_990 = ^{or_985, or_981, or_977, or_973};
  // hls/stages/agreement.hpp:673
  logic or_994;
  assign or_994 = (or_981 & or_985) | (or_977 & (or_981 | or_985));
  logic and_995;
  assign and_995 = or_973 & (^{or_985, or_981, or_977});
  // hls/stages/agreement.hpp:672
  logic xor_996;
  assign xor_996 = or_994 ^ and_995;
  // hls/stages/agreement.hpp:675
  logic and_997;
  assign and_997 = or_994 & and_995;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_998;
  assign select_998 = equal_382_s1_q ? {and_997, xor_996, parity_990, parity_969, xor_924, xor_829} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_380_s1_q ? 6'h0 : select_998;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_1000;
  assign select_1000 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1001;
  assign difference_1001 = {1'b0, column_3} - {1'b0, select_1000};
  logic [7:0] sum_1003;
  assign sum_1003 = {difference_1001[6], difference_1001} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:205
  logic and_1004;
  assign and_1004 = right_codes_rdata_q[25] & not_388_s1_q;
  logic [11:0] select_1005;
  assign select_1005 = less_387_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1009;
  assign select_1009 = and_514 ? (and_1004 ? (~(select_1005 ^ select_517)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1015;
  assign parity_1015 = ^select_1009[5:3];
  logic parity_1018;
  assign parity_1018 = ^select_1009[8:6];
  logic parity_1021;
  assign parity_1021 = ^select_1009[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1028;
  assign select_1028 = and_537 ? (and_515 ? (~(select_516 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1031;
  assign parity_1031 = ^select_1028[8:6];
  logic parity_1034;
  assign parity_1034 = ^select_1028[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1041;
  assign select_1041 = and_554 ? (and_538 ? (~(select_539 ^ select_557)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
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
  // hls/stages/agreement.hpp:671
  logic or_1073;
  assign or_1073 = (select_1009[1:0] == 2'h3) | (select_1009[2] & (select_1009[0] | select_1009[1]));
  // hls/stages/agreement.hpp:673
  logic or_1077;
  assign or_1077 = (select_1028[7:6] == 2'h3) | (select_1028[8] & (select_1028[6] | select_1028[7]));
  logic or_1081;
  assign or_1081 = (select_1028[10:9] == 2'h3) | (select_1028[11] & (select_1028[9] | select_1028[10]));
  // hls/stages/agreement.hpp:671
  logic or_1089;
  assign or_1089 = (select_1041[7:6] == 2'h3) | (select_1041[8] & (~(select_1041[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_1093;
  assign or_1093 = (select_1041[1:0] == 2'h3) | (select_1041[2] & (select_1041[0] | select_1041[1]));
  logic or_1097;
  assign or_1097 = (select_1041[4:3] == 2'h3) | (select_1041[5] & (select_1041[3] | select_1041[4]));
  // hls/stages/agreement.hpp:672
  logic parity_1100;
  assign parity_1100 = ^{or_1097, or_1093, or_1089};
  // hls/stages/agreement.hpp:671
  logic or_1104;
  assign or_1104 = (select_1028[4:3] == 2'h3) | (select_1028[5] & (select_1028[3] | select_1028[4]));
  // hls/stages/agreement.hpp:673
  logic or_1108;
  assign or_1108 = (select_1041[10:9] == 2'h3) | (select_1041[11] & (select_1041[9] | select_1041[10]));
  logic or_1112;
  assign or_1112 = (select_1028[1:0] == 2'h3) | (select_1028[2] & (select_1028[0] | select_1028[1]));
  // hls/stages/agreement.hpp:672
  logic parity_1115;
  assign parity_1115 = ^{or_1112, or_1108, or_1104};
  logic parity_1118;
  assign parity_1118 = ^{or_1112, or_1108, or_1104, or_1097, or_1093, or_1089, or_1081, or_1077, or_1073};
  // hls/stages/agreement.hpp:673
  logic and_1119;
  assign and_1119 = parity_1021 & parity_1068;
  logic or_1123;
  assign or_1123 = (parity_1015 & parity_1018) | ((^select_1009[11:9]) & (parity_1015 | parity_1018));
  logic and_1126;
  assign and_1126 = (^{select_1028[11:6], select_1009[2:0]}) & (parity_1053 | parity_1065);
  logic or_1127;
  assign or_1127 = (parity_1053 & parity_1065) | and_1126;
  // hls/stages/agreement.hpp:671
  logic or_1134;
  assign or_1134 = (select_1009[10:9] == 2'h3) | (select_1009[11] & (select_1009[9] | select_1009[10]));
  // hls/stages/agreement.hpp:673
  logic or_1138;
  assign or_1138 = (select_1009[4:3] == 2'h3) | (select_1009[5] & (select_1009[3] | select_1009[4]));
  logic or_1142;
  assign or_1142 = (select_1009[7:6] == 2'h3) | (select_1009[8] & (select_1009[6] | select_1009[7]));
  // hls/stages/agreement.hpp:672
  logic parity_1145;
  assign parity_1145 = ^{or_1142, or_1138, or_1134};
  // hls/stages/agreement.hpp:673
  logic or_1149;
  assign or_1149 = (parity_1031 & parity_1034) | ((^select_1009[2:0]) & (parity_1031 | parity_1034));
  logic or_1153;
  assign or_1153 = (parity_1047 & parity_1050) | ((^select_1041[8:6]) & (parity_1047 | parity_1050));
  logic or_1157;
  assign or_1157 = (parity_1059 & parity_1062) | ((^select_1028[5:3]) & (parity_1059 | parity_1062));
  // hls/stages/agreement.hpp:672
  logic parity_1160;
  assign parity_1160 = ^{or_1157, or_1153, or_1149};
  logic parity_1163;
  assign parity_1163 = ^{or_1157, or_1153, or_1149, or_1142, or_1138, or_1134, or_1127, or_1123, and_1119};
  logic xor_1164;
  assign xor_1164 = parity_1118 ^ parity_1163;
  // hls/stages/agreement.hpp:673
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
  // hls/stages/agreement.hpp:672
  logic parity_1191;
  assign parity_1191 = ^{or_1188, or_1184, or_1180};
  // hls/stages/agreement.hpp:673
  logic or_1195;
  assign or_1195 = (or_1123 & or_1127) | (and_1119 & (or_1123 | or_1127));
  logic or_1199;
  assign or_1199 = (or_1138 & or_1142) | (or_1134 & (or_1138 | or_1142));
  logic or_1203;
  assign or_1203 = (or_1153 & or_1157) | (or_1149 & (or_1153 | or_1157));
  // hls/stages/agreement.hpp:672
  logic parity_1206;
  assign parity_1206 = ^{or_1203, or_1199, or_1195};
  logic parity_1209;
  assign parity_1209 = ^{or_1203, or_1199, or_1195, or_1188, or_1184, or_1180, or_1173, or_1169, and_1165};
  // hls/stages/agreement.hpp:673
  logic or_1213;
  assign or_1213 = (parity_1191 & parity_1206) | ((^{or_1173, or_1169, and_1165}) & (parity_1191 | parity_1206));
  logic or_1217;
  assign or_1217 = (or_1169 & or_1173) | (and_1165 & (or_1169 | or_1173));
  logic or_1221;
  assign or_1221 = (or_1184 & or_1188) | (or_1180 & (or_1184 | or_1188));
  logic or_1225;
  assign or_1225 = (or_1199 & or_1203) | (or_1195 & (or_1199 | or_1203));
  // hls/stages/agreement.hpp:672
  logic parity_1230;
  assign parity_1230 = ^{or_1225, or_1221, or_1217, or_1213};
  // hls/stages/agreement.hpp:673
  logic or_1234;
  assign or_1234 = (or_1221 & or_1225) | (or_1217 & (or_1221 | or_1225));
  logic and_1235;
  assign and_1235 = or_1213 & (^{or_1225, or_1221, or_1217});
  // hls/stages/agreement.hpp:672
  logic xor_1236;
  assign xor_1236 = or_1234 ^ and_1235;
  // hls/stages/agreement.hpp:675
  logic and_1237;
  assign and_1237 = or_1234 & and_1235;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1238;
  assign select_1238 = equal_382_s1_q ? {and_1237, xor_1236, parity_1230, parity_1209, xor_1164, xor_1069} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_380_s1_q ? 6'h0 : select_1238;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_1240;
  assign select_1240 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1241;
  assign difference_1241 = {1'b0, column_4} - {1'b0, select_1240};
  logic [7:0] sum_1243;
  assign sum_1243 = {difference_1241[6], difference_1241} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1251;
  assign select_1251 = and_514 ? (and_555 ? (~(select_556 ^ select_517)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1257;
  assign parity_1257 = ^select_1251[5:3];
  logic parity_1260;
  assign parity_1260 = ^select_1251[8:6];
  logic parity_1263;
  assign parity_1263 = ^select_1251[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1270;
  assign select_1270 = and_537 ? (and_796 ? (~(select_797 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1273;
  assign parity_1273 = ^select_1270[8:6];
  logic parity_1276;
  assign parity_1276 = ^select_1270[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] xor_1282;
  assign xor_1282 = (less_387_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_557;
  logic [11:0] select_1285;
  assign select_1285 = and_554 ? ((right_codes_rdata_q[90] & not_388_s1_q) ? (~xor_1282) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
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
  // hls/stages/agreement.hpp:671
  logic or_1317;
  assign or_1317 = (select_1251[1:0] == 2'h3) | (select_1251[2] & (select_1251[0] | select_1251[1]));
  // hls/stages/agreement.hpp:673
  logic or_1321;
  assign or_1321 = (select_1270[7:6] == 2'h3) | (select_1270[8] & (select_1270[6] | select_1270[7]));
  logic or_1325;
  assign or_1325 = (select_1270[10:9] == 2'h3) | (select_1270[11] & (select_1270[9] | select_1270[10]));
  // hls/stages/agreement.hpp:671
  logic or_1333;
  assign or_1333 = (select_1285[7:6] == 2'h3) | (select_1285[8] & (~(select_1285[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_1337;
  assign or_1337 = (select_1285[1:0] == 2'h3) | (select_1285[2] & (select_1285[0] | select_1285[1]));
  logic or_1341;
  assign or_1341 = (select_1285[4:3] == 2'h3) | (select_1285[5] & (select_1285[3] | select_1285[4]));
  // hls/stages/agreement.hpp:672
  logic parity_1344;
  assign parity_1344 = ^{or_1341, or_1337, or_1333};
  // hls/stages/agreement.hpp:671
  logic or_1348;
  assign or_1348 = (select_1270[4:3] == 2'h3) | (select_1270[5] & (select_1270[3] | select_1270[4]));
  // hls/stages/agreement.hpp:673
  logic or_1352;
  assign or_1352 = (select_1285[10:9] == 2'h3) | (select_1285[11] & (select_1285[9] | select_1285[10]));
  logic or_1356;
  assign or_1356 = (select_1270[1:0] == 2'h3) | (select_1270[2] & (select_1270[0] | select_1270[1]));
  // hls/stages/agreement.hpp:672
  logic parity_1359;
  assign parity_1359 = ^{or_1356, or_1352, or_1348};
  logic parity_1362;
  assign parity_1362 = ^{or_1356, or_1352, or_1348, or_1341, or_1337, or_1333, or_1325, or_1321, or_1317};
  // hls/stages/agreement.hpp:673
  logic and_1363;
  assign and_1363 = parity_1263 & parity_1312;
  logic or_1367;
  assign or_1367 = (parity_1257 & parity_1260) | ((^select_1251[11:9]) & (parity_1257 | parity_1260));
  logic and_1370;
  assign and_1370 = (^{select_1270[11:6], select_1251[2:0]}) & (parity_1297 | parity_1309);
  logic or_1371;
  assign or_1371 = (parity_1297 & parity_1309) | and_1370;
  // hls/stages/agreement.hpp:671
  logic or_1378;
  assign or_1378 = (select_1251[10:9] == 2'h3) | (select_1251[11] & (select_1251[9] | select_1251[10]));
  // hls/stages/agreement.hpp:673
  logic or_1382;
  assign or_1382 = (select_1251[4:3] == 2'h3) | (select_1251[5] & (select_1251[3] | select_1251[4]));
  logic or_1386;
  assign or_1386 = (select_1251[7:6] == 2'h3) | (select_1251[8] & (select_1251[6] | select_1251[7]));
  // hls/stages/agreement.hpp:672
  logic parity_1389;
  assign parity_1389 = ^{or_1386, or_1382, or_1378};
  // hls/stages/agreement.hpp:673
  logic or_1393;
  assign or_1393 = (parity_1273 & parity_1276) | ((^select_1251[2:0]) & (parity_1273 | parity_1276));
  logic or_1397;
  assign or_1397 = (parity_1291 & parity_1294) | ((^select_1285[8:6]) & (parity_1291 | parity_1294));
  logic or_1401;
  assign or_1401 = (parity_1303 & parity_1306) | ((^select_1270[5:3]) & (parity_1303 | parity_1306));
  // hls/stages/agreement.hpp:672
  logic parity_1404;
  assign parity_1404 = ^{or_1401, or_1397, or_1393};
  logic parity_1407;
  assign parity_1407 = ^{or_1401, or_1397, or_1393, or_1386, or_1382, or_1378, or_1371, or_1367, and_1363};
  logic xor_1408;
  assign xor_1408 = parity_1362 ^ parity_1407;
  // hls/stages/agreement.hpp:673
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
  // hls/stages/agreement.hpp:672
  logic parity_1435;
  assign parity_1435 = ^{or_1432, or_1428, or_1424};
  // hls/stages/agreement.hpp:673
  logic or_1439;
  assign or_1439 = (or_1367 & or_1371) | (and_1363 & (or_1367 | or_1371));
  logic or_1443;
  assign or_1443 = (or_1382 & or_1386) | (or_1378 & (or_1382 | or_1386));
  logic or_1447;
  assign or_1447 = (or_1397 & or_1401) | (or_1393 & (or_1397 | or_1401));
  // hls/stages/agreement.hpp:672
  logic parity_1450;
  assign parity_1450 = ^{or_1447, or_1443, or_1439};
  logic parity_1453;
  assign parity_1453 = ^{or_1447, or_1443, or_1439, or_1432, or_1428, or_1424, or_1417, or_1413, and_1409};
  // hls/stages/agreement.hpp:673
  logic or_1457;
  assign or_1457 = (parity_1435 & parity_1450) | ((^{or_1417, or_1413, and_1409}) & (parity_1435 | parity_1450));
  logic or_1461;
  assign or_1461 = (or_1413 & or_1417) | (and_1409 & (or_1413 | or_1417));
  logic or_1465;
  assign or_1465 = (or_1428 & or_1432) | (or_1424 & (or_1428 | or_1432));
  logic or_1469;
  assign or_1469 = (or_1443 & or_1447) | (or_1439 & (or_1443 | or_1447));
  // hls/stages/agreement.hpp:672
  logic parity_1474;
  assign parity_1474 = ^{or_1469, or_1465, or_1461, or_1457};
  // hls/stages/agreement.hpp:673
  logic or_1478;
  assign or_1478 = (or_1465 & or_1469) | (or_1461 & (or_1465 | or_1469));
  logic and_1479;
  assign and_1479 = or_1457 & (^{or_1469, or_1465, or_1461});
  // hls/stages/agreement.hpp:672
  logic xor_1480;
  assign xor_1480 = or_1478 ^ and_1479;
  // hls/stages/agreement.hpp:675
  logic and_1481;
  assign and_1481 = or_1478 & and_1479;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1482;
  assign select_1482 = equal_382_s1_q ? {and_1481, xor_1480, parity_1474, parity_1453, xor_1408, xor_1313} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_380_s1_q ? 6'h0 : select_1482;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_1484;
  assign select_1484 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1485;
  assign difference_1485 = {1'b0, column_5} - {1'b0, select_1484};
  logic [7:0] sum_1487;
  assign sum_1487 = {difference_1485[6], difference_1485} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:657
  logic [11:0] not_1491;
  assign not_1491 = ~((less_387_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_517);
  logic [11:0] select_1493;
  assign select_1493 = and_514 ? ((right_codes_rdata_q[12] & not_388_s1_q) ? not_1491 : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1499;
  assign parity_1499 = ^select_1493[5:3];
  logic parity_1502;
  assign parity_1502 = ^select_1493[8:6];
  logic parity_1505;
  assign parity_1505 = ^select_1493[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1512;
  assign select_1512 = and_537 ? (and_1004 ? (~(select_1005 ^ select_540)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1515;
  assign parity_1515 = ^select_1512[8:6];
  logic parity_1518;
  assign parity_1518 = ^select_1512[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1525;
  assign select_1525 = and_554 ? (and_515 ? (~(select_516 ^ select_557)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
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
  // hls/stages/agreement.hpp:671
  logic or_1557;
  assign or_1557 = (select_1493[1:0] == 2'h3) | (select_1493[2] & (select_1493[0] | select_1493[1]));
  // hls/stages/agreement.hpp:673
  logic or_1561;
  assign or_1561 = (select_1512[7:6] == 2'h3) | (select_1512[8] & (select_1512[6] | select_1512[7]));
  logic or_1565;
  assign or_1565 = (select_1512[10:9] == 2'h3) | (select_1512[11] & (select_1512[9] | select_1512[10]));
  // hls/stages/agreement.hpp:671
  logic or_1573;
  assign or_1573 = (select_1525[7:6] == 2'h3) | (select_1525[8] & (~(select_1525[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_1577;
  assign or_1577 = (select_1525[1:0] == 2'h3) | (select_1525[2] & (select_1525[0] | select_1525[1]));
  logic or_1581;
  assign or_1581 = (select_1525[4:3] == 2'h3) | (select_1525[5] & (select_1525[3] | select_1525[4]));
  // hls/stages/agreement.hpp:672
  logic parity_1584;
  assign parity_1584 = ^{or_1581, or_1577, or_1573};
  // hls/stages/agreement.hpp:671
  logic or_1588;
  assign or_1588 = (select_1512[4:3] == 2'h3) | (select_1512[5] & (select_1512[3] | select_1512[4]));
  // hls/stages/agreement.hpp:673
  logic or_1592;
  assign or_1592 = (select_1525[10:9] == 2'h3) | (select_1525[11] & (select_1525[9] | select_1525[10]));
  logic or_1596;
  assign or_1596 = (select_1512[1:0] == 2'h3) | (select_1512[2] & (select_1512[0] | select_1512[1]));
  // hls/stages/agreement.hpp:672
  logic parity_1599;
  assign parity_1599 = ^{or_1596, or_1592, or_1588};
  logic parity_1602;
  assign parity_1602 = ^{or_1596, or_1592, or_1588, or_1581, or_1577, or_1573, or_1565, or_1561, or_1557};
  // hls/stages/agreement.hpp:673
  logic and_1603;
  assign and_1603 = parity_1505 & parity_1552;
  logic or_1607;
  assign or_1607 = (parity_1499 & parity_1502) | ((^select_1493[11:9]) & (parity_1499 | parity_1502));
  logic and_1610;
  assign and_1610 = (^{select_1512[11:6], select_1493[2:0]}) & (parity_1537 | parity_1549);
  logic or_1611;
  assign or_1611 = (parity_1537 & parity_1549) | and_1610;
  // hls/stages/agreement.hpp:671
  logic or_1618;
  assign or_1618 = (select_1493[10:9] == 2'h3) | (select_1493[11] & (select_1493[9] | select_1493[10]));
  // hls/stages/agreement.hpp:673
  logic or_1622;
  assign or_1622 = (select_1493[4:3] == 2'h3) | (select_1493[5] & (select_1493[3] | select_1493[4]));
  logic or_1626;
  assign or_1626 = (select_1493[7:6] == 2'h3) | (select_1493[8] & (select_1493[6] | select_1493[7]));
  // hls/stages/agreement.hpp:672
  logic parity_1629;
  assign parity_1629 = ^{or_1626, or_1622, or_1618};
  // hls/stages/agreement.hpp:673
  logic or_1633;
  assign or_1633 = (parity_1515 & parity_1518) | ((^select_1493[2:0]) & (parity_1515 | parity_1518));
  logic or_1637;
  assign or_1637 = (parity_1531 & parity_1534) | ((^select_1525[8:6]) & (parity_1531 | parity_1534));
  logic or_1641;
  assign or_1641 = (parity_1543 & parity_1546) | ((^select_1512[5:3]) & (parity_1543 | parity_1546));
  // hls/stages/agreement.hpp:672
  logic parity_1644;
  assign parity_1644 = ^{or_1641, or_1637, or_1633};
  logic parity_1647;
  assign parity_1647 = ^{or_1641, or_1637, or_1633, or_1626, or_1622, or_1618, or_1611, or_1607, and_1603};
  logic xor_1648;
  assign xor_1648 = parity_1602 ^ parity_1647;
  // hls/stages/agreement.hpp:673
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
  // hls/stages/agreement.hpp:672
  logic parity_1675;
  assign parity_1675 = ^{or_1672, or_1668, or_1664};
  // hls/stages/agreement.hpp:673
  logic or_1679;
  assign or_1679 = (or_1607 & or_1611) | (and_1603 & (or_1607 | or_1611));
  logic or_1683;
  assign or_1683 = (or_1622 & or_1626) | (or_1618 & (or_1622 | or_1626));
  logic or_1687;
  assign or_1687 = (or_1637 & or_1641) | (or_1633 & (or_1637 | or_1641));
  // hls/stages/agreement.hpp:672
  logic parity_1690;
  assign parity_1690 = ^{or_1687, or_1683, or_1679};
  logic parity_1693;
  assign parity_1693 = ^{or_1687, or_1683, or_1679, or_1672, or_1668, or_1664, or_1657, or_1653, and_1649};
  // hls/stages/agreement.hpp:673
  logic or_1697;
  assign or_1697 = (parity_1675 & parity_1690) | ((^{or_1657, or_1653, and_1649}) & (parity_1675 | parity_1690));
  logic or_1701;
  assign or_1701 = (or_1653 & or_1657) | (and_1649 & (or_1653 | or_1657));
  logic or_1705;
  assign or_1705 = (or_1668 & or_1672) | (or_1664 & (or_1668 | or_1672));
  logic or_1709;
  assign or_1709 = (or_1683 & or_1687) | (or_1679 & (or_1683 | or_1687));
  // hls/stages/agreement.hpp:672
  logic parity_1714;
  assign parity_1714 = ^{or_1709, or_1705, or_1701, or_1697};
  // hls/stages/agreement.hpp:673
  logic or_1718;
  assign or_1718 = (or_1705 & or_1709) | (or_1701 & (or_1705 | or_1709));
  logic and_1719;
  assign and_1719 = or_1697 & (^{or_1709, or_1705, or_1701});
  // hls/stages/agreement.hpp:672
  logic xor_1720;
  assign xor_1720 = or_1718 ^ and_1719;
  // hls/stages/agreement.hpp:675
  logic and_1721;
  assign and_1721 = or_1718 & and_1719;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1722;
  assign select_1722 = equal_382_s1_q ? {and_1721, xor_1720, parity_1714, parity_1693, xor_1648, xor_1553} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_380_s1_q ? 6'h0 : select_1722;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_1724;
  assign select_1724 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1725;
  assign difference_1725 = {1'b0, column_6} - {1'b0, select_1724};
  logic [7:0] sum_1727;
  assign sum_1727 = {difference_1725[6], difference_1725} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:942
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:943
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:944
  logic [6:0] select_1787;
  assign select_1787 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:947
  logic and_1807;
  assign and_1807 = (or_380_s1_q & (left_rdata_q[61] & not_388_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:228
  logic or_1829;
  assign or_1829 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:392
  logic [6:0] select_1840;
  assign select_1840 = so_s1_q ? x_s1_q[6:0] : (or_380_s1_q ? (less_387_s1_q ? 7'h0 : select_1787) : 7'h0);
  // hls/stages/agreement.hpp:970
  logic [5:0] sum_1883;
  assign sum_1883 = {1'b0, last_s1_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:392
  logic and_2059;
  assign and_2059 = ((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & (~({sum_1883, last_s1_q[1:0]} < x_s1_q));
  // hls/stages/agreement.hpp:432
  logic [5:0] or_2201;
  assign or_2201 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:436
  logic select_2417;
  assign select_2417 = equal_2323_s1_q ? (~({row_s1_q, 1'b0} < {sum_2414, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:495
  logic and_2628;
  assign and_2628 = and_359_s1_q & (equal_2323_s1_q & (row_s1_q[5:2] == 4'h0));

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:226; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1302; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_380_s1_q ? select_1787 : right_s1_q;
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
      row_q <= and_359_s1_q ? (equal_2323_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_359_s1_q ? select_2417 : lower_half_q;
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
  logic select_1792_s2_q;
  logic equal_1801_s2_q;
  logic and_1808_s2_q;
  logic and_1811_s2_q;
  logic and_1815_s2_q;
  logic or_1829_s2_q;
  logic [6:0] select_1840_s2_q;
  logic less_1884_s2_q;
  logic equal_1924_s2_q;
  logic and_2061_s2_q;
  logic equal_2202_s2_q;
  logic equal_2323_s2_q;
  logic less_2557_s2_q;
  logic and_2629_s2_q;
  logic and_2631_s2_q;
  logic less_2738_s2_q;
  logic equal_2945_s2_q;
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
      select_1792_s2_q <= select_1792_s1_q;
      equal_1801_s2_q <= equal_1801_s1_q;
      and_1808_s2_q <= not_388_s1_q & and_1807;
      and_1811_s2_q <= (or_380_s1_q & (left_rdata_q[62] & not_388_s1_q)) & and_1807;
      and_1815_s2_q <= not_388_s1_q & (or_380_s1_q & (left_rdata_q[63] & not_388_s1_q));
      or_1829_s2_q <= or_1829;
      select_1840_s2_q <= select_1840;
      less_1884_s2_q <= {1'b0, sum_1883, last_s1_q[1]} < x_s1_q;
      equal_1924_s2_q <= x_s1_q == {1'b0, last_s1_q};
      and_2061_s2_q <= so_s1_q & (ends_cell_s1_q & and_2059);
      equal_2202_s2_q <= {column_s1_q[6], or_2201} == 7'h0;
      equal_2323_s2_q <= equal_2323_s1_q;
      less_2557_s2_q <= 5'h4 < row_q[5:1];
      and_2629_s2_q <= and_2324_s1_q & and_2628;
      and_2631_s2_q <= and_2324_s1_q & (~and_2628);
      less_2738_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2945_s2_q <= row_s1_q[5:3] == 3'h0;
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
  // hls/stages/census.hpp:112
  logic [11:0] select_337;
  assign select_337 = select_320_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_341;
  assign sum_341 = select_337 + (equal_339_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_343;
  assign sum_343 = {4'h0, sample_pair_pixel_1_q} + (select_320_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_345;
  assign sum_345 = sum_343 + (equal_339_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:122
  logic and_349;
  assign and_349 = whole_s2_q & (averager_memory_rdata_q[24] | equal_339_s2_q);
  // hls/stages/agreement.hpp:394
  logic all_of_skin;
  assign all_of_skin = select_320_s2_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_353;
  assign and_353 = all_of_skin & (averager_memory_rdata_q[25] | equal_339_s2_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_333_s2_q ? sum_341[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_333_s2_q ? sum_345[11:3] : 9'h0;
  logic and_370;
  assign and_370 = and_333_s2_q & and_349;
  // hls/stages/census.hpp:126
  logic select_372;
  assign select_372 = equal_362_s2_q ? and_370 : (averager_mask_q & and_370);
  // hls/stages/agreement.hpp:255
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_372;
  // hls/stages/census.hpp:206
  logic and_374;
  assign and_374 = and_333_s2_q & and_353;
  // hls/stages/census.hpp:126
  logic select_376;
  assign select_376 = equal_362_s2_q ? and_374 : (averager_of_skin_q & and_374);
  // hls/stages/agreement.hpp:787
  logic not_510;
  assign not_510 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_511;
  assign less_511 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:224
  logic and_513;
  assign and_513 = not_510 & (~less_511);
  // hls/stages/agreement.hpp:750
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
  // hls/stages/agreement.hpp:791
  logic [7:0] of_best;
  assign of_best = and_513 ? select_1731 : 8'h0;
  // hls/stages/agreement.hpp:798
  logic or_1734;
  assign or_1734 = select_508_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:803
  logic [5:0] select_1735;
  assign select_1735 = or_1734 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:751
  logic or_1737;
  assign or_1737 = less_1244 | (~less_1246);
  logic [2:0] select_1738;
  assign select_1738 = less_1730 ? {less_1728, 2'h0} : {1'b0, or_1737, less_1246};
  // hls/stages/agreement.hpp:803
  logic [2:0] select_1739;
  assign select_1739 = or_1734 ? select_1738 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1740;
  assign select_1740 = or_1734 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:800
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
  // hls/stages/agreement.hpp:803
  logic [7:0] select_1748;
  assign select_1748 = or_1734 ? (select_1744[1] ? select_1745 : select_1746) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:801
  logic [2:0] select_1749;
  assign select_1749 = equal_1741 ? 3'h2 : {not_1743, {2{equal_1742}}};
  logic [7:0] select_1750;
  assign select_1750 = select_1749[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1752;
  assign select_1752 = select_1749[1] ? select_1750 : (select_1749[0] ? select_1731 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:803
  logic [7:0] select_1754;
  assign select_1754 = or_1734 ? (select_1749[2] ? sums_3_sum_sums_values_0_q : select_1752) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1756;
  assign sum_1756 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1757;
  assign sum_1757 = {1'b0, before_v} + sum_1756;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1759;
  assign sum_1759 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1760;
  assign sum_1760 = {1'b0, before_v_2} + sum_1759;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1762;
  assign sum_1762 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1763;
  assign sum_1763 = {1'b0, before_v_3} + sum_1762;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1765;
  assign select_1765 = (sum_1760 < sum_1763) ? sum_1763 : sum_1760;
  logic [6:0] select_1767;
  assign select_1767 = (sum_1757 < select_1765) ? select_1765 : sum_1757;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1769;
  assign sum_1769 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1770;
  assign sum_1770 = {1'b0, before_v_4} + sum_1769;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1772;
  assign sum_1772 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1773;
  assign sum_1773 = {1'b0, before_v_5} + sum_1772;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1775;
  assign select_1775 = (sum_1770 < sum_1773) ? sum_1773 : sum_1770;
  // hls/stages/agreement.hpp:792
  logic [6:0] of_near;
  assign of_near = and_513 ? ((select_1767 < select_1775) ? select_1775 : select_1767) : 7'h0;
  // hls/stages/agreement.hpp:803
  logic or_1780;
  assign or_1780 = select_508_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:807
  logic [6:0] select_1781;
  assign select_1781 = or_1780 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1782;
  assign select_1782 = or_1780 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:812
  logic or_1794;
  assign or_1794 = select_1792_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:816
  logic [7:0] select_1795;
  assign select_1795 = or_1794 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1796;
  assign select_1796 = or_1794 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1798;
  assign or_1798 = select_1792_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:820
  logic [6:0] select_1799;
  assign select_1799 = or_1798 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1800;
  assign select_1800 = or_1798 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:970
  logic not_1802;
  assign not_1802 = ~equal_1801_s2_q;
  // hls/stages/agreement.hpp:228
  logic and_1812;
  assign and_1812 = not_388_s2_q & and_1811_s2_q;
  // hls/stages/agreement.hpp:950
  logic select_1818;
  assign select_1818 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:951
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:957
  logic [8:0] difference_1821;
  assign difference_1821 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:958
  logic [9:0] sum_1822;
  assign sum_1822 = {difference_1821[8], difference_1821} + 10'h1;
  // hls/stages/agreement.hpp:228
  logic and_1824;
  assign and_1824 = (and_1811_s2_q & select_1818) & ({{22{sum_1822[9]}}, sum_1822} < 32'h3);
  logic and_1825;
  assign and_1825 = not_388_s2_q & and_1824;
  logic and_1831;
  assign and_1831 = not_388_s2_q & (and_1824 & or_1829_s2_q);
  // hls/stages/agreement.hpp:137
  logic [8:0] select_1832;
  assign select_1832 = less_387_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_380_s2_q ? {select_1832, and_1831, and_1825, and_1815_s2_q, and_1812, and_1808_s2_q, not_388_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:392
  logic and_1834;
  assign and_1834 = ends_cell_s2_q & inside_v[0];
  logic and_1836;
  assign and_1836 = not_1802 & (so_s2_q & and_1834);
  // hls/stages/agreement.hpp:243
  logic right_2;
  assign right_2 = inside_v[0] & less_1884_s2_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:255
  logic select_2115;
  assign select_2115 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2117;
  assign select_2117 = sample_pair_whole_s2_q ? (and_357_s2_q ? select_372 : averager_mask_q) : averager_mask_q;
  logic select_2119;
  assign select_2119 = sample_pair_whole_s2_q ? (and_357_s2_q ? select_376 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/registration.hpp:76
  logic less_2504;
  assign less_2504 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:137
  logic [7:0] select_2506;
  assign select_2506 = or_380_s2_q ? (less_387_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2508;
  assign select_2508 = or_380_s2_q ? (less_387_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2510;
  assign select_2510 = or_380_s2_q ? (less_387_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2508} - {1'b0, select_2510};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2512;
  assign select_2512 = rise[8] ? select_2508 : select_2510;
  logic [8:0] difference_2513;
  assign difference_2513 = {1'b0, select_2506} - {1'b0, select_2512};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2513[8] ? 8'h0 : difference_2513[7:0];
  // hls/stages/registration.hpp:37
  logic not_2515;
  assign not_2515 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2504 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2515};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2517;
  assign xor_2517 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2517};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2523;
  assign select_2523 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2504 ? {taken, 1'b1} : {not_2515, select_2523, not_2515};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2525;
  assign sum_2525 = {left, 1'b1} + {taken_2, less_2504};
  // hls/stages/agreement.hpp:238
  logic [4:0] select_2527;
  assign select_2527 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;

  // Memory census_memory, 80 x 78 and parity, DISTANCE 16, hls/stages/census.hpp:334; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1303; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1836;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1329; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1836;
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
  assign best_right_wdata = {select_1800, select_1799, select_1796, select_1795};
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
      averager_running_of_skin_q <= select_2115;
      averager_mask_q <= select_2117;
      averager_of_skin_q <= select_2119;
      registration_displacement_over_q <= so_s2_q ? sum_2525[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2527;
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
  logic equal_1801_s3_q;
  logic not_1802_s3_q;
  logic [13:0] inside_v_s3_q;
  logic and_1836_s3_q;
  logic [6:0] select_1840_s3_q;
  logic and_1845_s3_q;
  logic right_2_s3_q;
  logic equal_1924_s3_q;
  logic textured_s3_q;
  logic and_2062_s3_q;
  logic equal_2202_s3_q;
  logic equal_2323_s3_q;
  logic and_2558_s3_q;
  logic less_2563_s3_q;
  logic and_2629_s3_q;
  logic and_2631_s3_q;
  logic less_2738_s3_q;
  logic equal_2945_s3_q;
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
      equal_1801_s3_q <= equal_1801_s2_q;
      not_1802_s3_q <= not_1802;
      inside_v_s3_q <= {inside_v[14:3], inside_v[1:0]};
      and_1836_s3_q <= and_1836;
      select_1840_s3_q <= select_1840_s2_q;
      and_1845_s3_q <= not_1802 & (so_s2_q ? and_1834 : (equal_379_s2_q & inside_v[4]));
      right_2_s3_q <= right_2;
      equal_1924_s3_q <= equal_1924_s2_q;
      textured_s3_q <= textured;
      and_2062_s3_q <= not_1802 & and_2061_s2_q;
      equal_2202_s3_q <= equal_2202_s2_q;
      equal_2323_s3_q <= equal_2323_s2_q;
      and_2558_s3_q <= inside_v[4] & less_2557_s2_q;
      less_2563_s3_q <= select_2508 < select_2510;
      and_2629_s3_q <= and_2629_s2_q;
      and_2631_s3_q <= and_2631_s2_q;
      less_2738_s3_q <= less_2738_s2_q;
      equal_2945_s3_q <= equal_2945_s2_q;
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
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey_s3_q} + (equal_362_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:255
  logic [8:0] select_365;
  assign select_365 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_362_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:255
  logic [8:0] select_369;
  assign select_369 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:294
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
  // hls/stages/census.hpp:295
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
  // hls/stages/agreement.hpp:431
  logic equal_417;
  assign equal_417 = column_s3_q == 7'h0;
  logic [3:0] select_421;
  assign select_421 = equal_420_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:432
  logic [4:0] select_422;
  assign select_422 = equal_417 ? {select_421, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_423;
  assign select_423 = equal_417 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_424;
  assign and_424 = select_422[4] & select_423[3];
  // hls/stages/census.hpp:286
  logic and_426;
  assign and_426 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_428;
  assign and_428 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_426);
  // hls/stages/agreement.hpp:432
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
  // hls/stages/census.hpp:270
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
  // hls/stages/agreement.hpp:186
  logic not_1841;
  assign not_1841 = ~so_s3_q;
  // hls/stages/agreement.hpp:392
  logic and_1842;
  assign and_1842 = not_1841 & inside_v_s3_q[4];
  // hls/stages/agreement.hpp:1082
  logic equal_1846;
  assign equal_1846 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1122
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:146
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1083
  logic [1:0] select_1849;
  assign select_1849 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1095
  logic [3:0] select_1851;
  assign select_1851 = equal_1846 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1849});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1852;
  assign sum_1852 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_1853;
  assign select_1853 = equal_1801_s3_q ? select_1851 : {sum_1852, lower_half_s3_q, registration_of_right_q};
  // hls/stages/agreement.hpp:1120
  logic equal_1854;
  assign equal_1854 = x_s3_q[5:0] == 6'h3e;
  logic equal_1856;
  assign equal_1856 = x_s3_q[5:0] == 6'h3d;
  logic equal_1858;
  assign equal_1858 = x_s3_q[5:0] == 6'h3c;
  logic equal_1860;
  assign equal_1860 = x_s3_q[5:0] == 6'h3b;
  logic equal_1862;
  assign equal_1862 = x_s3_q[5:0] == 6'h36;
  logic equal_1864;
  assign equal_1864 = x_s3_q[5:0] == 6'h35;
  logic equal_1866;
  assign equal_1866 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1122
  logic and_1870;
  assign and_1870 = (~equal_1860) & ((~equal_1862) & ((~equal_1864) & (~equal_1866)));
  // hls/stages/agreement.hpp:1083
  logic less_1874;
  assign less_1874 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:147
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:159
  logic or_1878;
  assign or_1878 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1095
  logic select_1881;
  assign select_1881 = equal_1846 ? ((~equal_1854) & ((~equal_1856) & ((~equal_1858) & and_1870))) : (less_1874 & (~or_1878));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1889;
  assign sum_1889 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1891;
  assign and_1891 = half_ends & ({{3{sum_1889[4]}}, sum_1889} < 8'h3);
  // hls/stages/agreement.hpp:392
  logic and_1892;
  assign and_1892 = so_s3_q & and_1891;
  // hls/stages/registration.hpp:253
  logic not_1895;
  assign not_1895 = ~lower_half_s3_q;
  logic [3:0] select_1896;
  assign select_1896 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1895, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1895};
  // hls/stages/agreement.hpp:190
  logic [7:0] select_1909;
  assign select_1909 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1004
  logic or_1912;
  assign or_1912 = select_1909[7] | (~({select_1909[5], select_1909[3], select_1909[1]} == 3'h0));
  // hls/stages/agreement.hpp:1003
  logic or_1915;
  assign or_1915 = select_1909[7] | (~({select_1909[6], select_1909[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1002
  logic or_1918;
  assign or_1918 = select_1909[7] | (~(select_1909[6:4] == 3'h0));
  // hls/stages/agreement.hpp:392
  logic [5:0] select_1919;
  assign select_1919 = equal_1801_s3_q ? x_s3_q[5:0] : {region_row_q, or_1918, or_1915, or_1912};
  // hls/stages/agreement.hpp:1082
  logic not_1920;
  assign not_1920 = ~equal_1846;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1922;
  assign sum_1922 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1012
  logic or_1925;
  assign or_1925 = (~sum_1922[5]) | equal_1924_s3_q;
  // hls/stages/agreement.hpp:392
  logic and_1928;
  assign and_1928 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & or_1925));
  // hls/stages/agreement.hpp:243
  logic explained;
  assign explained = inside_v_s3_q[0] & inside_v_s3_q[3];
  logic and_1942;
  assign and_1942 = inside_v_s3_q[0] & ({inside_v_s3_q[4], inside_v_s3_q[2]} == 2'h3);
  logic and_1949;
  assign and_1949 = inside_v_s3_q[0] & inside_v_s3_q[2];
  // hls/stages/agreement.hpp:975
  logic select_1950;
  assign select_1950 = slot_s3_q[2] ? shown_shown_q : inside_v_s3_q[3];
  // hls/stages/agreement.hpp:243
  logic shown;
  assign shown = inside_v_s3_q[0] & (shown_right_rdata_q[0] | select_1950);
  // hls/stages/agreement.hpp:975
  logic select_1953;
  assign select_1953 = slot_s3_q[2] ? shown_nearer_q : inside_v_s3_q[4];
  // hls/stages/agreement.hpp:243
  logic near;
  assign near = inside_v_s3_q[0] & (select_1950 ? select_1953 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1207
  logic or_1956;
  assign or_1956 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1209
  logic [17:0] select_1958;
  assign select_1958 = marks_first_s3_q ? 18'h1 : (or_1956 ? {rows_passed_q[16:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1208
  logic [8:0] select_1960;
  assign select_1960 = or_1956 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1216
  logic select_1962;
  assign select_1962 = cfg_compete_i ? (or_1956 & select_1958[17]) : (select_1960[8] & select_1958[9]);
  // hls/stages/agreement.hpp:411
  logic next_row;
  assign next_row = select_1962 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1223
  logic [6:0] select_1965;
  assign select_1965 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_1967;
  assign select_1967 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_1965});
  // hls/stages/agreement.hpp:1233
  logic equal_1968;
  assign equal_1968 = seen_x_q == 3'h7;
  logic [7:0] select_1970;
  assign select_1970 = select_1962 ? 8'h0 : (seen_column_q + {7'h0, equal_1968});
  // hls/stages/agreement.hpp:1240
  logic [12:0] index;
  assign index = select_1967 + {5'h0, select_1970};
  // hls/stages/agreement.hpp:1207
  logic select_1973;
  assign select_1973 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1193
  logic [7:0] sum_1974;
  assign sum_1974 = {1'b0, select_1973, 2'h0, select_1973, 1'b0, {2{select_1973}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1206
  logic not_1975;
  assign not_1975 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:411
  logic and_1977;
  assign and_1977 = not_1975 & (began_q | select_1962);
  // hls/stages/agreement.hpp:1234
  logic [2:0] select_1979;
  assign select_1979 = select_1962 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1239
  logic and_1981;
  assign and_1981 = and_1977 & (select_1979 == 3'h0);
  logic less_1982;
  assign less_1982 = select_1970 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1065
  logic [7:0] sum_1985;
  assign sum_1985 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1985[7]}}, sum_1985, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1193
  logic [7:0] sum_1987;
  assign sum_1987 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:988
  logic and_1988;
  assign and_1988 = seen_columns_rdata_q[14] & inside_v_s3_q[0];
  logic and_1989;
  assign and_1989 = seen_columns_rdata_q[10] & inside_v_s3_q[0];
  logic and_1990;
  assign and_1990 = seen_columns_rdata_q[5] & inside_v_s3_q[0];
  logic and_1991;
  assign and_1991 = seen_columns_rdata_q[0] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1041
  logic [1:0] sum_1993;
  assign sum_1993 = {1'b0, and_1990} + ({1'b0, textured_s3_q} + {1'b0, and_1991});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1988} + ({2'h0, and_1989} + {1'b0, sum_1993});
  // hls/stages/agreement.hpp:1048
  logic [2:0] select_1996;
  assign select_1996 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1997;
  assign difference_1997 = {1'b0, textured_2} - {1'b0, select_1996};
  // hls/stages/agreement.hpp:1046
  logic equal_1998;
  assign equal_1998 = x_s3_q == 8'h0;
  // hls/stages/agreement.hpp:1048
  logic [4:0] t;
  assign t = {difference_1997[3], difference_1997} + (equal_1998 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:988
  logic [7:0] select_2003;
  assign select_2003 = inside_v_s3_q[0] ? (sum_1922[5] ? select_1909 : {select_1909[6:0], 1'b0}) : select_1909;
  // hls/stages/agreement.hpp:1004
  logic or_2006;
  assign or_2006 = select_2003[7] | (~({select_2003[5], select_2003[3], select_2003[1]} == 3'h0));
  // hls/stages/agreement.hpp:988
  logic and_2023;
  assign and_2023 = seen_columns_rdata_q[16] & inside_v_s3_q[0];
  logic and_2024;
  assign and_2024 = seen_columns_rdata_q[12] & inside_v_s3_q[0];
  logic and_2025;
  assign and_2025 = seen_columns_rdata_q[8] & inside_v_s3_q[0];
  logic and_2026;
  assign and_2026 = seen_columns_rdata_q[3] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1043
  logic [1:0] sum_2028;
  assign sum_2028 = {1'b0, and_2025} + ({1'b0, shown} + {1'b0, and_2026});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2023} + ({2'h0, and_2024} + {1'b0, sum_2028});
  // hls/stages/agreement.hpp:1050
  logic [2:0] select_2031;
  assign select_2031 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2032;
  assign difference_2032 = {1'b0, shown_2} - {1'b0, select_2031};
  logic [4:0] around;
  assign around = {difference_2032[3], difference_2032} + (equal_1998 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1057
  logic [5:0] sum_2035;
  assign sum_2035 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:988
  logic and_2039;
  assign and_2039 = seen_columns_rdata_q[17] & inside_v_s3_q[0];
  logic and_2040;
  assign and_2040 = seen_columns_rdata_q[13] & inside_v_s3_q[0];
  logic and_2041;
  assign and_2041 = seen_columns_rdata_q[9] & inside_v_s3_q[0];
  logic and_2042;
  assign and_2042 = seen_columns_rdata_q[4] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1044
  logic [1:0] sum_2044;
  assign sum_2044 = {1'b0, and_2041} + ({1'b0, near} + {1'b0, and_2042});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2039} + ({2'h0, and_2040} + {1'b0, sum_2044});
  // hls/stages/agreement.hpp:1051
  logic [2:0] select_2047;
  assign select_2047 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2048;
  assign difference_2048 = {1'b0, near_2} - {1'b0, select_2047};
  logic [4:0] n;
  assign n = {difference_2048[3], difference_2048} + (equal_1998 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:255
  logic [10:0] select_2094;
  assign select_2094 = sample_pair_whole_s3_q ? (and_357_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2096;
  assign select_2096 = sample_pair_whole_s3_q ? (and_357_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:495
  logic [8:0] select_2120;
  assign select_2120 = and_359_s3_q ? select_365 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2121;
  assign select_2121 = and_359_s3_q ? select_369 : census_columns_values_0_cell_0_right_q;
  logic select_2122;
  assign select_2122 = and_359_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_2123;
  assign select_2123 = and_359_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2124;
  assign select_2124 = and_359_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2125;
  assign select_2125 = and_359_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2126;
  assign select_2126 = and_359_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2127;
  assign select_2127 = and_359_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2128;
  assign select_2128 = and_359_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2129;
  assign select_2129 = and_359_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2130;
  assign select_2130 = and_359_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2131;
  assign select_2131 = and_359_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2132;
  assign select_2132 = and_359_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2133;
  assign select_2133 = and_359_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2134;
  assign select_2134 = and_359_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2135;
  assign select_2135 = and_359_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2136;
  assign select_2136 = and_359_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2137;
  assign select_2137 = and_359_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2138;
  assign select_2138 = and_359_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2139;
  assign select_2139 = and_359_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2140;
  assign select_2140 = and_359_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2141;
  assign select_2141 = and_359_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2142;
  assign select_2142 = and_359_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2143;
  assign select_2143 = and_359_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2144;
  assign select_2144 = and_359_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2145;
  assign select_2145 = and_359_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2146;
  assign select_2146 = and_359_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2147;
  assign select_2147 = and_359_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2148;
  assign select_2148 = and_359_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2149;
  assign select_2149 = and_359_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2150;
  assign select_2150 = and_359_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2151;
  assign select_2151 = and_359_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2152;
  assign select_2152 = and_359_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2153;
  assign select_2153 = and_359_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2154;
  assign select_2154 = and_359_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2155;
  assign select_2155 = and_359_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2156;
  assign select_2156 = and_359_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2157;
  assign select_2157 = and_359_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2158;
  assign select_2158 = and_359_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2159;
  assign select_2159 = and_359_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2160;
  assign select_2160 = and_359_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2161;
  assign select_2161 = and_359_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2162;
  assign select_2162 = and_359_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2163;
  assign select_2163 = and_359_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2164;
  assign select_2164 = and_359_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2165;
  assign select_2165 = and_359_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2166;
  assign select_2166 = and_359_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2167;
  assign select_2167 = and_359_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2168;
  assign select_2168 = and_359_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2169;
  assign select_2169 = and_359_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2170;
  assign select_2170 = and_359_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2171;
  assign select_2171 = and_359_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2172;
  assign select_2172 = and_359_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2173;
  assign select_2173 = and_359_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2174;
  assign select_2174 = and_359_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2175;
  assign select_2175 = and_359_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2177;
  assign difference_2177 = {1'b0, select_369} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2178;
  assign xor_2178 = difference_2177[8:0] ^ {9{difference_2177[9]}};
  logic [9:0] sum_2179;
  assign sum_2179 = {9'h0, difference_2177[9]} + {1'b0, xor_2178};
  logic [9:0] difference_2180;
  assign difference_2180 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2181;
  assign xor_2181 = difference_2180[8:0] ^ {9{difference_2180[9]}};
  logic [9:0] sum_2182;
  assign sum_2182 = {9'h0, difference_2180[9]} + {1'b0, xor_2181};
  logic [9:0] difference_2184;
  assign difference_2184 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2185;
  assign xor_2185 = difference_2184[8:0] ^ {9{difference_2184[9]}};
  logic [9:0] sum_2186;
  assign sum_2186 = {9'h0, difference_2184[9]} + {1'b0, xor_2185};
  logic [10:0] sum_2187;
  assign sum_2187 = ({1'b0, sum_2179} + {1'b0, sum_2182}) + {1'b0, sum_2186};
  logic [9:0] difference_2188;
  assign difference_2188 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2189;
  assign xor_2189 = difference_2188[8:0] ^ {9{difference_2188[9]}};
  logic [9:0] sum_2190;
  assign sum_2190 = {9'h0, difference_2188[9]} + {1'b0, xor_2189};
  logic [9:0] difference_2192;
  assign difference_2192 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2193;
  assign xor_2193 = difference_2192[8:0] ^ {9{difference_2192[9]}};
  logic [9:0] sum_2194;
  assign sum_2194 = {9'h0, difference_2192[9]} + {1'b0, xor_2193};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2222;
  assign difference_2222 = {1'b0, select_365} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2222[9]} + (difference_2222[8:0] ^ {9{difference_2222[9]}});
  logic [9:0] difference_2233;
  assign difference_2233 = {1'b0, select_369} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2233[9]} + (difference_2233[8:0] ^ {9{difference_2233[9]}});
  // hls/stages/agreement.hpp:495
  logic and_2420;
  assign and_2420 = and_359_s3_q & (equal_420_s3_q & equal_2323_s3_q);
  // hls/stages/agreement.hpp:392
  logic and_2423;
  assign and_2423 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & inside_v_s3_q[1]));
  // hls/stages/agreement.hpp:988
  logic and_2444;
  assign and_2444 = seen_columns_rdata_q[15] & inside_v_s3_q[0];
  logic and_2445;
  assign and_2445 = seen_columns_rdata_q[11] & inside_v_s3_q[0];
  logic and_2446;
  assign and_2446 = seen_columns_rdata_q[7] & inside_v_s3_q[0];
  logic and_2447;
  assign and_2447 = seen_columns_rdata_q[2] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1042
  logic [1:0] sum_2449;
  assign sum_2449 = {1'b0, and_2446} + ({1'b0, explained} + {1'b0, and_2447});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2444} + ({2'h0, and_2445} + {1'b0, sum_2449});
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2452;
  assign select_2452 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2453;
  assign difference_2453 = {1'b0, explained_2} - {1'b0, select_2452};
  logic [4:0] e;
  assign e = {difference_2453[3], difference_2453} + (equal_1998 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1056
  logic [5:0] sum_2456;
  assign sum_2456 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:392
  logic and_2484;
  assign and_2484 = ends_cell_s3_q & (inside_v_s3_q[0] & (inside_v_s3_q[2:1] == 2'h3));
  // hls/stages/registration.hpp:83
  logic equal_2528;
  assign equal_2528 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:213
  logic [16:0] select_2530;
  assign select_2530 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2530[16:7])) ? 8'h7f : select_2530[7:0];
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2528 ? registration_slope_here_q : change;
  // hls/stages/registration.hpp:208
  logic [7:0] select_2534;
  assign select_2534 = inside_v_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2535;
  assign select_2535 = inside_v_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2536;
  assign difference_2536 = {{2{select_2534[7]}}, select_2534[7:1]} - {select_2535[7], select_2535};
  // hls/stages/registration.hpp:206
  logic [6:0] select_2537;
  assign select_2537 = inside_v_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2538;
  assign select_2538 = inside_v_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2539;
  assign sum_2539 = {{2{select_2537[6]}}, select_2537} + {select_2538[7], select_2538};
  // hls/stages/registration.hpp:207
  logic [7:0] select_2540;
  assign select_2540 = inside_v_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2541;
  assign select_2541 = inside_v_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2542;
  assign sum_2542 = {{2{select_2540[7]}}, select_2540[7:1]} + {select_2541[7], select_2541};
  // hls/stages/registration.hpp:209
  logic [10:0] sum_2543;
  assign sum_2543 = {{3{sum_2539[8]}}, sum_2539[8:1]} + {sum_2542[8], sum_2542, select_2540[0]};
  logic [9:0] sum_2544;
  assign sum_2544 = {difference_2536, select_2534[0]} + {sum_2543[10], sum_2543[10:2]};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2545;
  assign sum_2545 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_2544[9]}}, sum_2544[9:2]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2548;
  assign select_2548 = ($signed(sum_2545[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2545[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] select_2550;
  assign select_2550 = equal_2528 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2545[12:7])) ? 8'h7f : select_2548);
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2552;
  assign select_2552 = equal_1801_s3_q ? registration_slope_here_q : (so_s3_q ? select_2550 : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2553;
  assign equal_2553 = slot_s3_q == 3'h4;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2562;
  assign sum_2562 = inside_v_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2564;
  assign difference_2564 = {sum_2562, inside_v_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2565;
  assign select_2565 = less_2563_s3_q ? difference_2564 : {sum_2562, inside_v_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2566;
  assign select_2566 = ((inside_v_s3_q[13:11] == 3'h0) | (inside_v_s3_q[13:11] == 3'h4)) ? {sum_2562, inside_v_s3_q[11], 5'h0} : select_2565;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2566[7]}}, select_2566} - {sum_2544[9], sum_2544, sum_2543[1]};
  // hls/stages/registration.hpp:213
  logic [11:0] select_2569;
  assign select_2569 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2569[11:7])) ? 12'h7f : select_2569;
  // hls/stages/agreement.hpp:392
  logic select_2613;
  assign select_2613 = so_s3_q ? (equal_2553 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_2616;
  assign select_2616 = so_s3_q ? (equal_2528 ? inside_v_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:264
  logic [3:0] select_2621;
  assign select_2621 = (sum_1852 == 2'h2) ? (registration_fresh_q & (~select_1896)) : registration_fresh_q;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_2623;
  assign select_2623 = so_s3_q ? (and_1891 ? select_2621 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:237
  logic [3:0] select_2625;
  assign select_2625 = and_2420 ? 4'hf : (equal_1801_s3_q ? registration_fresh_q : select_2623);
  // hls/stages/registration.hpp:128
  logic [15:0] select_2632;
  assign select_2632 = and_2631_s3_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:131
  logic [23:0] select_2634;
  assign select_2634 = and_2629_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2632[15]}}, select_2632});
  // hls/stages/registration.hpp:129
  logic [15:0] select_2635;
  assign select_2635 = and_2631_s3_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2635[15]}}, select_2635};
  // hls/stages/registration.hpp:131
  logic [27:0] select_2637;
  assign select_2637 = and_2629_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:137
  logic and_2638;
  assign and_2638 = ends_cell_s3_q & so_s3_q;
  // hls/stages/registration.hpp:124
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_2638 ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:1083
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1849;
  // hls/stages/registration.hpp:253
  logic not_2646;
  assign not_2646 = ~quarter_2[1];
  logic [3:0] select_2647;
  assign select_2647 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2646, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2646};
  // hls/stages/agreement.hpp:392
  logic select_2735;
  assign select_2735 = equal_1801_s3_q ? shown_shown_q : (so_s3_q ? select_1950 : shown_shown_q);
  logic select_2737;
  assign select_2737 = equal_1801_s3_q ? shown_nearer_q : (so_s3_q ? select_1953 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2739;
  assign sum_2739 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:436
  logic [2:0] select_2741;
  assign select_2741 = less_2738_s3_q ? (sum_2739[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2743;
  assign select_2743 = equal_2323_s3_q ? (equal_420_s3_q ? 3'h0 : select_2741) : region_row_q;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2748;
  assign select_2748 = equal_1801_s3_q ? select_1909 : (so_s3_q ? (ends_cell_s3_q ? select_2003 : select_1909) : 8'h1);
  // hls/stages/agreement.hpp:190
  logic [8:0] select_2750;
  assign select_2750 = so_s3_q ? (and_2638 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2752;
  assign sum_2752 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2753;
  assign select_2753 = sum_1922[5] ? {1'b1, sum_1922[4:0], region_across_rest_q[2:0]} : sum_2752;
  // hls/stages/agreement.hpp:436
  logic [8:0] select_2755;
  assign select_2755 = equal_2323_s3_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_2758;
  assign select_2758 = equal_2323_s3_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  logic [8:0] select_2762;
  assign select_2762 = equal_420_s3_q ? {{2{difference_2760[6]}}, difference_2760} : (less_2738_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:495
  logic [8:0] select_2764;
  assign select_2764 = and_359_s3_q ? (equal_2323_s3_q ? select_2762 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:436
  logic [6:0] select_2766;
  assign select_2766 = equal_420_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2768;
  assign select_2768 = and_359_s3_q ? (equal_2323_s3_q ? select_2766 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2769;
  assign sum_2769 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2770;
  assign select_2770 = sum_2739[7] ? {1'b1, sum_2739[6:0], region_down_rest_q[0]} : sum_2769;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2739[7];
  // hls/stages/agreement.hpp:436
  logic select_2774;
  assign select_2774 = equal_2323_s3_q ? (equal_420_s3_q | (less_2738_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:190
  logic or_2779;
  assign or_2779 = segment_starts_q | not_1841;
  // hls/stages/agreement.hpp:988
  logic select_2782;
  assign select_2782 = inside_v_s3_q[0] ? (sum_1922[5] ? (equal_1924_s3_q & or_1925) : or_1925) : or_2779;
  // hls/stages/agreement.hpp:392
  logic select_2785;
  assign select_2785 = equal_1801_s3_q ? or_2779 : (so_s3_q ? (ends_cell_s3_q ? select_2782 : or_2779) : or_2779);
  // hls/stages/agreement.hpp:1095
  logic equal_2810;
  assign equal_2810 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:392
  logic [2:0] select_2861;
  assign select_2861 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_2863;
  assign select_2863 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2865;
  assign select_2865 = equal_1801_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_2863 : box_textured_columns_values_1_q);
  logic [2:0] select_2866;
  assign select_2866 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2868;
  assign select_2868 = equal_1801_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_2866 : box_textured_columns_values_2_q);
  logic [2:0] select_2869;
  assign select_2869 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2871;
  assign select_2871 = equal_1801_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_2869 : box_textured_columns_values_3_q);
  logic [2:0] select_2872;
  assign select_2872 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2874;
  assign select_2874 = equal_1801_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_2872 : box_textured_columns_values_4_q);
  logic [4:0] select_2876;
  assign select_2876 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_2879;
  assign select_2879 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_2881;
  assign select_2881 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2883;
  assign select_2883 = equal_1801_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_2881 : box_explained_columns_values_1_q);
  logic [2:0] select_2884;
  assign select_2884 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2886;
  assign select_2886 = equal_1801_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_2884 : box_explained_columns_values_2_q);
  logic [2:0] select_2887;
  assign select_2887 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2889;
  assign select_2889 = equal_1801_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_2887 : box_explained_columns_values_3_q);
  logic [2:0] select_2890;
  assign select_2890 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2892;
  assign select_2892 = equal_1801_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_2890 : box_explained_columns_values_4_q);
  logic [4:0] select_2894;
  assign select_2894 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2895;
  assign select_2895 = equal_1801_s3_q ? box_explained_sum_sums_values_0_q : select_2894;
  logic [2:0] select_2897;
  assign select_2897 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2899;
  assign select_2899 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2901;
  assign select_2901 = equal_1801_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_2899 : box_shown_columns_values_1_q);
  logic [2:0] select_2902;
  assign select_2902 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2904;
  assign select_2904 = equal_1801_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_2902 : box_shown_columns_values_2_q);
  logic [2:0] select_2905;
  assign select_2905 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2907;
  assign select_2907 = equal_1801_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_2905 : box_shown_columns_values_3_q);
  logic [2:0] select_2908;
  assign select_2908 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2910;
  assign select_2910 = equal_1801_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_2908 : box_shown_columns_values_4_q);
  logic [4:0] select_2912;
  assign select_2912 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_2915;
  assign select_2915 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2917;
  assign select_2917 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2919;
  assign select_2919 = equal_1801_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_2917 : box_nearer_columns_values_1_q);
  logic [2:0] select_2920;
  assign select_2920 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2922;
  assign select_2922 = equal_1801_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_2920 : box_nearer_columns_values_2_q);
  logic [2:0] select_2923;
  assign select_2923 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2925;
  assign select_2925 = equal_1801_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_2923 : box_nearer_columns_values_3_q);
  logic [2:0] select_2926;
  assign select_2926 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2928;
  assign select_2928 = equal_1801_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_2926 : box_nearer_columns_values_4_q);
  logic [4:0] select_2930;
  assign select_2930 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_2933;
  assign select_2933 = so_s3_q ? (ends_cell_s3_q ? and_1990 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2936;
  assign select_2936 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & inside_v_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_2938;
  assign select_2938 = equal_1801_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_2936 : centres_values_0_of_skin_q);
  logic select_2939;
  assign select_2939 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2941;
  assign select_2941 = equal_1801_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_2939 : centres_values_1_textured_q);
  logic select_2942;
  assign select_2942 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2944;
  assign select_2944 = equal_1801_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_2942 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:436
  logic [12:0] select_2948;
  assign select_2948 = equal_2323_s3_q ? (equal_2945_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2951;
  assign select_2951 = and_359_s3_q ? (equal_2323_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1232
  logic [2:0] select_2962;
  assign select_2962 = select_1962 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:411
  logic [7:0] select_2968;
  assign select_2968 = marks_first_s3_q ? (less_2964 ? {sum_2965, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1240
  logic and_2974;
  assign and_2974 = and_2062_s3_q & ({sum_1987, index_2[5:0]} == {sum_1974, index[5:0]});
  // hls/stages/registration.hpp:253
  logic not_3026;
  assign not_3026 = ~quarter[1];
  logic [3:0] select_3027;
  assign select_3027 = quarter[0] ? {quarter[1], 1'b0, not_3026, 1'b0} : {1'b0, quarter[1], 1'b0, not_3026};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:271; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1853;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & (equal_1801_s3_q ? (x_s3_q[6] & select_1881) : and_1892);
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1322; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1919;
  logic regions_re;
  assign regions_re = s3_en & (equal_1801_s3_q ? (x_s3_q[6] & not_1920) : and_1928);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1333; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1974, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_1981 & less_1982);
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
  assign shown_right_waddr = select_1840_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1845_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1842, not_1841};
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
  assign seen_columns_we = s3_en & and_1836_s3_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1949, textured_s3_q};
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
      registration_slope_here_q <= select_2552;
      registration_of_right_q <= equal_1801_s3_q ? registration_of_right_q : select_2613;
      registration_was_inside_q <= equal_1801_s3_q ? registration_was_inside_q : select_2616;
      registration_fresh_q <= select_2625;
      registration_slope_row_q <= select_2634;
      registration_slope_change_q <= select_2637;
      registration_slope_q <= so_s3_q ? column_7 : {registration_slope_row_q, 4'h0};
      shown_shown_q <= select_2735;
      shown_nearer_q <= select_2737;
      region_row_q <= and_359_s3_q ? select_2743 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_2748;
      region_across_rest_q <= select_2750;
      region_across_back_q <= so_s3_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2753;
      columns_begin_rest_q <= and_359_s3_q ? select_2755 : columns_begin_rest_q;
      columns_begin_back_q <= and_359_s3_q ? select_2758 : columns_begin_back_q;
      region_down_rest_q <= select_2764;
      region_down_back_q <= select_2768;
      region_down_next_q <= select_2770;
      region_fresh_q <= and_359_s3_q ? select_2774 : region_fresh_q;
      segment_starts_q <= select_2785;
      centres_values_0_textured_q <= equal_1801_s3_q ? centres_values_0_textured_q : select_2933;
      centres_values_0_of_skin_q <= select_2938;
      centres_values_1_textured_q <= select_2941;
      centres_values_1_of_skin_q <= select_2944;
      map_row_q <= and_359_s3_q ? select_2948 : map_row_q;
      map_width_q <= select_2951;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1973;
      done_q <= not_1975 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1801_s3_q & equal_2810;
      rows_passed_q <= select_1958;
      columns_passed_q <= {select_1960[7:0], or_1956};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_1977;
      seen_x_q <= select_1979;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_2962;
      seen_column_q <= select_1970;
      seen_rows_left_q <= select_2968;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_1967;
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
      averager_total_0_q <= select_2094;
      averager_total_1_q <= select_2096;
      census_columns_values_0_cell_0_left_q <= select_2120;
      census_columns_values_0_cell_0_right_q <= select_2121;
      census_columns_values_0_cell_0_mask_q <= select_2122;
      census_columns_values_0_cell_1_left_q <= select_2123;
      census_columns_values_0_cell_1_right_q <= select_2124;
      census_columns_values_0_cell_1_mask_q <= select_2125;
      census_columns_values_0_cell_2_left_q <= select_2126;
      census_columns_values_0_cell_2_right_q <= select_2127;
      census_columns_values_0_cell_2_mask_q <= select_2128;
      census_columns_values_0_cell_2_of_skin_q <= select_2129;
      census_columns_values_0_cell_3_left_q <= select_2130;
      census_columns_values_0_cell_3_right_q <= select_2131;
      census_columns_values_0_cell_3_mask_q <= select_2132;
      census_columns_values_0_cell_4_left_q <= select_2133;
      census_columns_values_0_cell_4_right_q <= select_2134;
      census_columns_values_0_cell_4_mask_q <= select_2135;
      census_columns_values_1_cell_0_left_q <= select_2136;
      census_columns_values_1_cell_0_right_q <= select_2137;
      census_columns_values_1_cell_0_mask_q <= select_2138;
      census_columns_values_1_cell_1_left_q <= select_2139;
      census_columns_values_1_cell_1_right_q <= select_2140;
      census_columns_values_1_cell_1_mask_q <= select_2141;
      census_columns_values_1_cell_2_left_q <= select_2142;
      census_columns_values_1_cell_2_right_q <= select_2143;
      census_columns_values_1_cell_2_mask_q <= select_2144;
      census_columns_values_1_cell_2_of_skin_q <= select_2145;
      census_columns_values_1_cell_3_left_q <= select_2146;
      census_columns_values_1_cell_3_right_q <= select_2147;
      census_columns_values_1_cell_3_mask_q <= select_2148;
      census_columns_values_1_cell_4_left_q <= select_2149;
      census_columns_values_1_cell_4_right_q <= select_2150;
      census_columns_values_1_cell_4_mask_q <= select_2151;
      census_columns_values_2_cell_0_left_q <= select_2152;
      census_columns_values_2_cell_0_right_q <= select_2153;
      census_columns_values_2_cell_0_mask_q <= select_2154;
      census_columns_values_2_cell_1_left_q <= select_2155;
      census_columns_values_2_cell_1_right_q <= select_2156;
      census_columns_values_2_cell_1_mask_q <= select_2157;
      census_columns_values_2_cell_2_left_q <= select_2158;
      census_columns_values_2_cell_2_right_q <= select_2159;
      census_columns_values_2_cell_2_mask_q <= select_2160;
      census_columns_values_2_cell_3_left_q <= select_2161;
      census_columns_values_2_cell_3_right_q <= select_2162;
      census_columns_values_2_cell_3_mask_q <= select_2163;
      census_columns_values_2_cell_4_left_q <= select_2164;
      census_columns_values_2_cell_4_right_q <= select_2165;
      census_columns_values_2_cell_4_mask_q <= select_2166;
      census_columns_values_3_cell_0_mask_q <= select_2167;
      census_columns_values_3_cell_1_left_q <= select_2168;
      census_columns_values_3_cell_1_right_q <= select_2169;
      census_columns_values_3_cell_1_mask_q <= select_2170;
      census_columns_values_3_cell_2_mask_q <= select_2171;
      census_columns_values_3_cell_3_left_q <= select_2172;
      census_columns_values_3_cell_3_right_q <= select_2173;
      census_columns_values_3_cell_3_mask_q <= select_2174;
      census_columns_values_3_cell_4_mask_q <= select_2175;
      sharpness_last_mean_0_q <= and_359_s3_q ? select_365 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_359_s3_q ? select_369 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1801_s3_q ? box_textured_columns_values_0_q : select_2861;
      box_textured_columns_values_1_q <= select_2865;
      box_textured_columns_values_2_q <= select_2868;
      box_textured_columns_values_3_q <= select_2871;
      box_textured_columns_values_4_q <= select_2874;
      box_textured_sum_sums_values_0_q <= equal_1801_s3_q ? box_textured_sum_sums_values_0_q : select_2876;
      box_explained_columns_values_0_q <= equal_1801_s3_q ? box_explained_columns_values_0_q : select_2879;
      box_explained_columns_values_1_q <= select_2883;
      box_explained_columns_values_2_q <= select_2886;
      box_explained_columns_values_3_q <= select_2889;
      box_explained_columns_values_4_q <= select_2892;
      box_explained_sum_sums_values_0_q <= select_2895;
      box_shown_columns_values_0_q <= equal_1801_s3_q ? box_shown_columns_values_0_q : select_2897;
      box_shown_columns_values_1_q <= select_2901;
      box_shown_columns_values_2_q <= select_2904;
      box_shown_columns_values_3_q <= select_2907;
      box_shown_columns_values_4_q <= select_2910;
      box_shown_sum_sums_values_0_q <= equal_1801_s3_q ? box_shown_sum_sums_values_0_q : select_2912;
      box_nearer_columns_values_0_q <= equal_1801_s3_q ? box_nearer_columns_values_0_q : select_2915;
      box_nearer_columns_values_1_q <= select_2919;
      box_nearer_columns_values_2_q <= select_2922;
      box_nearer_columns_values_3_q <= select_2925;
      box_nearer_columns_values_4_q <= select_2928;
      box_nearer_sum_sums_values_0_q <= equal_1801_s3_q ? box_nearer_sum_sums_values_0_q : select_2930;
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
  logic equal_1801_s4_q;
  logic not_1802_s4_q;
  logic equal_1846_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1852_s4_q;
  logic equal_1854_s4_q;
  logic equal_1856_s4_q;
  logic equal_1858_s4_q;
  logic equal_1860_s4_q;
  logic equal_1862_s4_q;
  logic equal_1864_s4_q;
  logic equal_1866_s4_q;
  logic less_1874_s4_q;
  logic or_1878_s4_q;
  logic equal_1898_s4_q;
  logic and_1908_s4_q;
  logic or_1912_s4_q;
  logic or_1915_s4_q;
  logic or_1918_s4_q;
  logic not_1920_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1942_s4_q;
  logic and_1947_s4_q;
  logic and_1981_s4_q;
  logic less_1982_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_1987_s4_q;
  logic equal_2001_s4_q;
  logic or_2006_s4_q;
  logic or_2009_s4_q;
  logic or_2012_s4_q;
  logic not_2037_s4_q;
  logic less_2051_s4_q;
  logic and_2062_s4_q;
  logic [11:0] sum_2195_s4_q;
  logic equal_2202_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2420_s4_q;
  logic and_2424_s4_q;
  logic not_2458_s4_q;
  logic and_2486_s4_q;
  logic equal_2528_s4_q;
  logic and_2556_s4_q;
  logic and_2558_s4_q;
  logic [11:0] residual_s4_q;
  logic equal_2649_s4_q;
  logic equal_2810_s4_q;
  logic and_2974_s4_q;
  logic and_2989_s4_q;
  logic equal_3029_s4_q;
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
      equal_1801_s4_q <= equal_1801_s3_q;
      not_1802_s4_q <= not_1802_s3_q;
      equal_1846_s4_q <= equal_1846;
      all_s4_q <= all;
      sum_1852_s4_q <= sum_1852;
      equal_1854_s4_q <= equal_1854;
      equal_1856_s4_q <= equal_1856;
      equal_1858_s4_q <= equal_1858;
      equal_1860_s4_q <= equal_1860;
      equal_1862_s4_q <= equal_1862;
      equal_1864_s4_q <= equal_1864;
      equal_1866_s4_q <= equal_1866;
      less_1874_s4_q <= less_1874;
      or_1878_s4_q <= or_1878;
      equal_1898_s4_q <= (registration_fresh_q & select_1896) == 4'h0;
      and_1908_s4_q <= not_1802_s3_q & and_1892;
      or_1912_s4_q <= or_1912;
      or_1915_s4_q <= or_1915;
      or_1918_s4_q <= or_1918;
      not_1920_s4_q <= not_1920;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1942_s4_q <= and_1942;
      and_1947_s4_q <= not_1802_s3_q & and_1928;
      and_1981_s4_q <= and_1981;
      less_1982_s4_q <= less_1982;
      index_2_s4_q <= index_2[5:0];
      sum_1987_s4_q <= sum_1987;
      equal_2001_s4_q <= t[4:1] == 4'h0;
      or_2006_s4_q <= or_2006;
      or_2009_s4_q <= select_2003[7] | (~({select_2003[6], select_2003[3:2]} == 3'h0));
      or_2012_s4_q <= select_2003[7] | (~(select_2003[6:4] == 3'h0));
      not_2037_s4_q <= ~({sum_2035, around[0]} < {2'h0, t});
      less_2051_s4_q <= {1'b0, around[4:1]} < n;
      and_2062_s4_q <= and_2062_s3_q;
      sum_2195_s4_q <= ({1'b0, sum_2187} + {2'h0, sum_2190}) + {2'h0, sum_2194};
      equal_2202_s4_q <= equal_2202_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2420_s4_q <= and_2420;
      and_2424_s4_q <= not_1802_s3_q & and_2423;
      not_2458_s4_q <= ~({sum_2456, e[0]} < {2'h0, t});
      and_2486_s4_q <= not_1802_s3_q & (so_s3_q & and_2484);
      equal_2528_s4_q <= equal_2528;
      and_2556_s4_q <= not_1802_s3_q & (so_s3_q & (half_ends & equal_2553));
      and_2558_s4_q <= and_2558_s3_q;
      residual_s4_q <= residual;
      equal_2649_s4_q <= (registration_fresh_q & select_2647) == 4'h0;
      equal_2810_s4_q <= equal_2810;
      and_2974_s4_q <= and_2974;
      and_2989_s4_q <= equal_1801_s3_q & (equal_2810 & (cfg_prove_i & (~proven_q)));
      equal_3029_s4_q <= (registration_fresh_q & select_3027) == 4'h0;
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
  // hls/stages/census.hpp:281
  logic [12:0] sum_470;
  assign sum_470 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_472;
  assign sum_472 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_470});
  // hls/stages/census.hpp:303
  logic less_473;
  assign less_473 = 9'h4 < sum_472[13:5];
  logic and_474;
  assign and_474 = and_424_s4_q & less_473;
  // hls/stages/registration.hpp:260
  logic equal_1900;
  assign equal_1900 = sum_1852_s4_q == 2'h0;
  // hls/stages/registration.hpp:258
  logic [6:0] down;
  assign down = sum_1852_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:260
  logic [13:0] select_1902;
  assign select_1902 = equal_1900 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1903;
  assign sum_1903 = (equal_1898_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1902[13]}}, select_1902};
  // hls/stages/registration.hpp:259
  logic [6:0] up;
  assign up = sum_1852_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:261
  logic [6:0] select_1906;
  assign select_1906 = equal_1900 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1907;
  assign sum_1907 = (equal_1898_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1906[6]}}, select_1906};
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1932;
  assign select_1932 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:882
  logic [6:0] sum_1933;
  assign sum_1933 = {6'h0, textured_s4_q} + select_1932;
  // hls/stages/agreement.hpp:1015
  logic [9:0] sum_1935;
  assign sum_1935 = {3'h0, sum_1933} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1937;
  assign select_1937 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:882
  logic [6:0] sum_1938;
  assign sum_1938 = {6'h0, explained_s4_q} + select_1937;
  // hls/stages/agreement.hpp:1016
  logic [9:0] sum_1940;
  assign sum_1940 = {3'h0, sum_1938} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1943;
  assign select_1943 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:883
  logic [6:0] sum_1944;
  assign sum_1944 = {6'h0, and_1942_s4_q} + select_1943;
  // hls/stages/agreement.hpp:1017
  logic [9:0] sum_1946;
  assign sum_1946 = {3'h0, sum_1944} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1055
  logic not_2013;
  assign not_2013 = ~region_row_s4_q[2];
  logic [2:0] select_2014;
  assign select_2014 = region_row_s4_q[1] ? {1'b0, not_2013, 1'b0} : {region_row_s4_q[2], 1'b0, not_2013};
  logic [5:0] select_2015;
  assign select_2015 = region_row_s4_q[0] ? {select_2014[2], 1'b0, select_2014[1], 1'b0, select_2014[0], 1'b0} : {1'b0, select_2014[2], 1'b0, select_2014[1], 1'b0, select_2014[0]};
  logic [11:0] select_2016;
  assign select_2016 = or_2012_s4_q ? {select_2015[5], 1'b0, select_2015[4], 1'b0, select_2015[3], 1'b0, select_2015[2], 1'b0, select_2015[1], 1'b0, select_2015[0], 1'b0} : {1'b0, select_2015[5], 1'b0, select_2015[4], 1'b0, select_2015[3], 1'b0, select_2015[2], 1'b0, select_2015[1], 1'b0, select_2015[0]};
  logic [23:0] select_2017;
  assign select_2017 = or_2009_s4_q ? {select_2016[11], 1'b0, select_2016[10], 1'b0, select_2016[9], 1'b0, select_2016[8], 1'b0, select_2016[7], 1'b0, select_2016[6], 1'b0, select_2016[5], 1'b0, select_2016[4], 1'b0, select_2016[3], 1'b0, select_2016[2], 1'b0, select_2016[1], 1'b0, select_2016[0], 1'b0} : {1'b0, select_2016[11], 1'b0, select_2016[10], 1'b0, select_2016[9], 1'b0, select_2016[8], 1'b0, select_2016[7], 1'b0, select_2016[6], 1'b0, select_2016[5], 1'b0, select_2016[4], 1'b0, select_2016[3], 1'b0, select_2016[2], 1'b0, select_2016[1], 1'b0, select_2016[0]};
  logic [47:0] select_2018;
  assign select_2018 = or_2006_s4_q ? {select_2017[23], 1'b0, select_2017[22], 1'b0, select_2017[21], 1'b0, select_2017[20], 1'b0, select_2017[19], 1'b0, select_2017[18], 1'b0, select_2017[17], 1'b0, select_2017[16], 1'b0, select_2017[15], 1'b0, select_2017[14], 1'b0, select_2017[13], 1'b0, select_2017[12], 1'b0, select_2017[11], 1'b0, select_2017[10], 1'b0, select_2017[9], 1'b0, select_2017[8], 1'b0, select_2017[7], 1'b0, select_2017[6], 1'b0, select_2017[5], 1'b0, select_2017[4], 1'b0, select_2017[3], 1'b0, select_2017[2], 1'b0, select_2017[1], 1'b0, select_2017[0], 1'b0} : {1'b0, select_2017[23], 1'b0, select_2017[22], 1'b0, select_2017[21], 1'b0, select_2017[20], 1'b0, select_2017[19], 1'b0, select_2017[18], 1'b0, select_2017[17], 1'b0, select_2017[16], 1'b0, select_2017[15], 1'b0, select_2017[14], 1'b0, select_2017[13], 1'b0, select_2017[12], 1'b0, select_2017[11], 1'b0, select_2017[10], 1'b0, select_2017[9], 1'b0, select_2017[8], 1'b0, select_2017[7], 1'b0, select_2017[6], 1'b0, select_2017[5], 1'b0, select_2017[4], 1'b0, select_2017[3], 1'b0, select_2017[2], 1'b0, select_2017[1], 1'b0, select_2017[0]};
  // hls/stages/agreement.hpp:988
  logic and_2022;
  assign and_2022 = good_known_q & (~((good_q & select_2018) == 48'h0));
  // hls/stages/agreement.hpp:1057
  logic is_seen;
  assign is_seen = equal_2001_s4_q ? and_2022 : not_2037_s4_q;
  // hls/stages/agreement.hpp:1066
  logic and_2052;
  assign and_2052 = is_seen & less_2051_s4_q;
  // hls/stages/agreement.hpp:255
  logic [8:0] select_2086;
  assign select_2086 = sample_pair_whole_s4_q ? (and_357_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2088;
  assign select_2088 = sample_pair_whole_s4_q ? (and_357_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2090;
  assign select_2090 = sample_pair_whole_s4_q ? (and_357_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2092;
  assign select_2092 = sample_pair_whole_s4_q ? (and_357_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2097;
  assign sum_2097 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2098;
  assign difference_2098 = {1'b0, sum_2097[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2099;
  assign xor_2099 = {difference_2098[8:0], sum_2097[0]} ^ {10{difference_2098[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2098[9]} + {1'b0, xor_2099};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_362_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_2104;
  assign select_2104 = sample_pair_whole_s4_q ? (and_357_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2105;
  assign sum_2105 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2106;
  assign difference_2106 = {1'b0, sum_2105[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2107;
  assign xor_2107 = {difference_2106[8:0], sum_2105[0]} ^ {10{difference_2106[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2106[9]} + {1'b0, xor_2107};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_362_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_2112;
  assign select_2112 = sample_pair_whole_s4_q ? (and_357_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:495
  logic [11:0] select_2197;
  assign select_2197 = and_359_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2198;
  assign select_2198 = and_359_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2199;
  assign select_2199 = and_359_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2200;
  assign select_2200 = and_359_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2203;
  assign sum_2203 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2195_s4_q};
  logic [13:0] sum_2205;
  assign sum_2205 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2203});
  // hls/stages/census.hpp:305
  logic and_2207;
  assign and_2207 = and_449_s4_q & (9'h4 < sum_2205[13:5]);
  // hls/stages/census.hpp:306
  logic and_2208;
  assign and_2208 = and_449_s4_q & less_473;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2209;
  assign sum_2209 = census_left_misses_q + {{17{and_2208}}, and_2207, 1'b0, and_2207};
  // hls/stages/agreement.hpp:495
  logic [19:0] select_2211;
  assign select_2211 = and_359_s4_q ? (equal_2202_s4_q ? 20'h0 : sum_2209) : census_left_misses_q;
  // hls/stages/agreement.hpp:255
  logic [27:0] select_2216;
  assign select_2216 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:355
  logic and_2221;
  assign and_2221 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:433
  logic and_2227;
  assign and_2227 = and_2221 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2216[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2229;
  assign select_2229 = and_2227 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2231;
  assign select_2231 = equal_2202_s4_q ? {11'h0, select_2229} : (sharpness_sums_detail_0_q + {11'h0, select_2229});
  // hls/stages/agreement.hpp:433
  logic and_2238;
  assign and_2238 = and_2221 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2216[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2240;
  assign select_2240 = and_2238 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2242;
  assign select_2242 = equal_2202_s4_q ? {11'h0, select_2240} : (sharpness_sums_detail_1_q + {11'h0, select_2240});
  logic [8:0] select_2245;
  assign select_2245 = and_2227 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2246;
  assign sum_2246 = (equal_2202_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2245};
  logic [8:0] select_2249;
  assign select_2249 = and_2238 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2250;
  assign sum_2250 = (equal_2202_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2249};
  // hls/stages/agreement.hpp:196
  logic equal_2252;
  assign equal_2252 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:369
  logic less_2253;
  assign less_2253 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:408
  logic less_2254;
  assign less_2254 = x_s4_q[4:0] < 5'h3;
  logic not_2255;
  assign not_2255 = ~x_s4_q[1];
  logic [2:0] select_2256;
  assign select_2256 = x_s4_q[0] ? {1'b0, not_2255, 1'b0} : {x_s4_q[1], 1'b0, not_2255};
  logic [5:0] select_2257;
  assign select_2257 = slot_s4_q[2] ? {select_2256[2], 1'b0, select_2256[1], 1'b0, select_2256[0], 1'b0} : {1'b0, select_2256[2], 1'b0, select_2256[1], 1'b0, select_2256[0]};
  logic [11:0] select_2258;
  assign select_2258 = slot_s4_q[1] ? {select_2257[5], 1'b0, select_2257[4], 1'b0, select_2257[3], 1'b0, select_2257[2], 1'b0, select_2257[1], 1'b0, select_2257[0], 1'b0} : {1'b0, select_2257[5], 1'b0, select_2257[4], 1'b0, select_2257[3], 1'b0, select_2257[2], 1'b0, select_2257[1], 1'b0, select_2257[0]};
  logic [23:0] select_2259;
  assign select_2259 = slot_s4_q[0] ? {select_2258[11], 1'b0, select_2258[10], 1'b0, select_2258[9], 1'b0, select_2258[8], 1'b0, select_2258[7], 1'b0, select_2258[6], 1'b0, select_2258[5], 1'b0, select_2258[4], 1'b0, select_2258[3], 1'b0, select_2258[2], 1'b0, select_2258[1], 1'b0, select_2258[0], 1'b0} : {1'b0, select_2258[11], 1'b0, select_2258[10], 1'b0, select_2258[9], 1'b0, select_2258[8], 1'b0, select_2258[7], 1'b0, select_2258[6], 1'b0, select_2258[5], 1'b0, select_2258[4], 1'b0, select_2258[3], 1'b0, select_2258[2], 1'b0, select_2258[1], 1'b0, select_2258[0]};
  // hls/stages/census.hpp:371
  logic and_2263;
  assign and_2263 = less_2254 & (~((sharpness_sums_contrast_1_q & select_2259) == 24'h0));
  // hls/stages/census.hpp:376
  logic [17:0] select_2265;
  assign select_2265 = (less_2253 & and_2263) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2265};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_2268;
  assign select_2268 = equal_2252 ? (less_2253 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:371
  logic and_2273;
  assign and_2273 = less_2254 & (~((sharpness_sums_contrast_0_q & select_2259) == 24'h0));
  // hls/stages/census.hpp:376
  logic [17:0] select_2275;
  assign select_2275 = (less_2253 & and_2273) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2275};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_2278;
  assign select_2278 = equal_2252 ? (less_2253 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2280;
  assign select_2280 = equal_2252 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2282;
  assign select_2282 = equal_2252 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2284;
  assign select_2284 = equal_2252 ? {sharpness_comparing_contrast_0_q[0], and_2273} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2286;
  assign select_2286 = equal_2252 ? {sharpness_comparing_contrast_1_q[0], and_2263} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:382
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:200
  logic select_2291;
  assign select_2291 = drew_q ? (equal_2252 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:382
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:200
  logic select_2295;
  assign select_2295 = drew_q ? (equal_2252 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:368
  logic equal_2296;
  assign equal_2296 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:384
  logic xor_2297;
  assign xor_2297 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2300;
  assign select_2300 = (equal_2296 | xor_2297) ? (five_times[0] & xor_2297) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:200
  logic select_2302;
  assign select_2302 = drew_q ? (equal_2252 ? select_2300 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:384
  logic xor_2303;
  assign xor_2303 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2306;
  assign select_2306 = (equal_2296 | xor_2303) ? (five_times_2[0] & xor_2303) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:200
  logic select_2308;
  assign select_2308 = drew_q ? (equal_2252 ? select_2306 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:385
  logic xor_2309;
  assign xor_2309 = sharpness_comparing_contrast_0_q[1] ^ and_2263;
  logic select_2312;
  assign select_2312 = (equal_2296 | xor_2309) ? (and_2263 & xor_2309) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:200
  logic select_2314;
  assign select_2314 = drew_q ? (equal_2252 ? select_2312 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:385
  logic xor_2315;
  assign xor_2315 = sharpness_comparing_contrast_1_q[1] ^ and_2273;
  logic select_2318;
  assign select_2318 = (equal_2296 | xor_2315) ? (and_2273 & xor_2315) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:200
  logic select_2320;
  assign select_2320 = drew_q ? (equal_2252 ? select_2318 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2426;
  assign select_2426 = and_2420_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2424_s4_q});
  // hls/stages/agreement.hpp:392
  logic and_2429;
  assign and_2429 = not_1802_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2434;
  assign and_2434 = not_1802_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2439;
  assign and_2439 = not_1802_s4_q & (drew_q & (ends_cell_s4_q & and_1942_s4_q));
  // hls/stages/agreement.hpp:1059
  logic not_2443;
  assign not_2443 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1060
  logic not_2460;
  assign not_2460 = ~(equal_2001_s4_q ? and_2022 : not_2458_s4_q);
  // hls/stages/agreement.hpp:392
  logic and_2463;
  assign and_2463 = ends_cell_s4_q & (not_2443 & (centres_values_1_textured_s4_q & not_2460));
  logic and_2465;
  assign and_2465 = not_1802_s4_q & (drew_q & and_2463);
  // hls/stages/agreement.hpp:1085
  logic less_2468;
  assign less_2468 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2469;
  assign select_2469 = less_2468 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2472;
  assign select_2472 = less_2468 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1086
  logic [10:0] sum_2473;
  assign sum_2473 = {1'b0, select_2472} + {3'h0, select_2472[9:2]};
  logic and_2475;
  assign and_2475 = (~(select_2469[9:4] == 6'h0)) & ({sum_2473, select_2472[1:0]} < {3'h0, select_2469});
  // hls/stages/agreement.hpp:1095
  logic [9:0] select_2478;
  assign select_2478 = x_s4_q[6] ? (equal_1846_s4_q ? 10'h0 : (and_2475 ? select_2469 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:392
  logic [9:0] select_2479;
  assign select_2479 = equal_1801_s4_q ? select_2478 : 10'h0;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2481;
  assign select_2481 = and_2420_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2479});
  logic [13:0] select_2488;
  assign select_2488 = and_2420_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2486_s4_q});
  // hls/stages/agreement.hpp:1064
  logic and_2490;
  assign and_2490 = not_2443 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:392
  logic and_2493;
  assign and_2493 = not_1802_s4_q & (drew_q & (ends_cell_s4_q & and_2490));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2495;
  assign select_2495 = and_2420_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2493});
  // hls/stages/agreement.hpp:1064
  logic and_2497;
  assign and_2497 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2460);
  // hls/stages/agreement.hpp:392
  logic and_2501;
  assign and_2501 = not_1802_s4_q & (drew_q & (ends_cell_s4_q & (not_2443 & and_2497)));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2503;
  assign select_2503 = and_2420_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2501});
  // hls/stages/registration.hpp:106
  logic [7:0] select_2573;
  assign select_2573 = equal_2528_s4_q ? (and_2558_s4_q ? residual_s4_q[7:0] : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2575;
  assign select_2575 = equal_1801_s4_q ? 8'h0 : (drew_q ? select_2573 : 8'h0);
  // hls/stages/registration.hpp:133
  logic [13:0] select_2577;
  assign select_2577 = and_2556_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2575[7]}}, select_2575});
  // hls/stages/agreement.hpp:392
  logic and_2580;
  assign and_2580 = not_1802_s4_q & (drew_q & (and_2558_s4_q & equal_2528_s4_q));
  // hls/stages/registration.hpp:133
  logic [5:0] select_2582;
  assign select_2582 = and_2556_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2580});
  // hls/stages/registration.hpp:106
  logic and_2584;
  assign and_2584 = and_2558_s4_q & ($signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2586;
  assign select_2586 = drew_q ? (equal_2528_s4_q ? {and_2584, and_2558_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2587;
  assign select_2587 = equal_1801_s4_q ? 2'h0 : select_2586;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2588;
  assign sum_2588 = registration_half_votes_down_q + {{5{select_2587[1]}}, select_2587};
  // hls/stages/registration.hpp:200
  logic [12:0] difference_2590;
  assign difference_2590 = 13'h0 - {residual_s4_q[11], residual_s4_q};
  // hls/stages/registration.hpp:106
  logic and_2592;
  assign and_2592 = and_2558_s4_q & ($signed(difference_2590) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2594;
  assign select_2594 = drew_q ? (equal_2528_s4_q ? {and_2592, and_2558_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2595;
  assign select_2595 = equal_1801_s4_q ? 2'h0 : select_2594;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2596;
  assign sum_2596 = registration_half_votes_up_q + {{5{select_2595[1]}}, select_2595};
  // hls/stages/registration.hpp:200
  logic less_2598;
  assign less_2598 = $signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2599;
  assign and_2599 = and_2558_s4_q & less_2598;
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2601;
  assign select_2601 = drew_q ? (equal_2528_s4_q ? {and_2599, and_2558_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2602;
  assign select_2602 = equal_1801_s4_q ? 2'h0 : select_2601;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2603;
  assign sum_2603 = registration_half_half_votes_down_q + {{5{select_2602[1]}}, select_2602};
  // hls/stages/registration.hpp:200
  logic less_2605;
  assign less_2605 = $signed(difference_2590) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2606;
  assign and_2606 = and_2558_s4_q & less_2605;
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2608;
  assign select_2608 = drew_q ? (equal_2528_s4_q ? {and_2606, and_2558_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2609;
  assign select_2609 = equal_1801_s4_q ? 2'h0 : select_2608;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2610;
  assign sum_2610 = registration_half_half_votes_up_q + {{5{select_2609[1]}}, select_2609};
  // hls/stages/agreement.hpp:392
  logic and_2644;
  assign and_2644 = equal_1801_s4_q & (x_s4_q[6] & (not_1920_s4_q & less_1874_s4_q));
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2651;
  assign select_2651 = or_1878_s4_q ? 12'h0 : (equal_2649_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2654;
  assign select_2654 = x_s4_q[6] ? (equal_1846_s4_q ? 12'h0 : (less_1874_s4_q ? select_2651 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2655;
  assign select_2655 = equal_1801_s4_q ? select_2654 : 12'h0;
  // hls/stages/registration.hpp:152
  logic and_2656;
  assign and_2656 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1095
  logic and_2659;
  assign and_2659 = not_1920_s4_q & (less_1874_s4_q & ({and_2656, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:392
  logic and_2661;
  assign and_2661 = equal_1801_s4_q & (x_s4_q[6] & and_2659);
  // hls/stages/registration.hpp:247
  logic [13:0] sum_2663;
  assign sum_2663 = {{2{select_2655[11]}}, select_2655} + (and_2661 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2666;
  assign select_2666 = or_1878_s4_q ? 12'h0 : (equal_2649_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2669;
  assign select_2669 = x_s4_q[6] ? (equal_1846_s4_q ? 12'h0 : (less_1874_s4_q ? select_2666 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2670;
  assign select_2670 = equal_1801_s4_q ? select_2669 : 12'h0;
  // hls/stages/registration.hpp:248
  logic [13:0] sum_2672;
  assign sum_2672 = {{2{select_2670[11]}}, select_2670} + (and_2661 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:149
  logic not_2674;
  assign not_2674 = ~all_s4_q;
  // hls/stages/agreement.hpp:1095
  logic and_2677;
  assign and_2677 = not_1920_s4_q & (less_1874_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2674, 1'b0}));
  // hls/stages/agreement.hpp:392
  logic and_2683;
  assign and_2683 = equal_1801_s4_q & (x_s4_q[6] & (not_1920_s4_q & (less_1874_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:241
  logic not_2684;
  assign not_2684 = ~and_2683;
  logic less_2685;
  assign less_2685 = $signed({9'h1, {2{not_2684}}, and_2683}) < $signed(registration_up_q[13:2]);
  logic select_2686;
  assign select_2686 = (equal_1801_s4_q & (x_s4_q[6] & and_2677)) ? less_2685 : registration_enough_q;
  // hls/stages/agreement.hpp:1095
  logic and_2690;
  assign and_2690 = x_s4_q[6] & (not_1920_s4_q & (less_1874_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:392
  logic and_2691;
  assign and_2691 = equal_1801_s4_q & and_2690;
  // hls/stages/registration.hpp:237
  logic less_2692;
  assign less_2692 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2694;
  assign less_2694 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1095
  logic and_2699;
  assign and_2699 = x_s4_q[6] & (not_1920_s4_q & (less_1874_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:392
  logic and_2700;
  assign and_2700 = equal_1801_s4_q & and_2699;
  // hls/stages/agreement.hpp:1095
  logic and_2707;
  assign and_2707 = x_s4_q[6] & (not_1920_s4_q & (less_1874_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:156
  logic equal_2710;
  assign equal_2710 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1095
  logic and_2713;
  assign and_2713 = not_1920_s4_q & (less_1874_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2710));
  // hls/stages/registration.hpp:239
  logic and_2717;
  assign and_2717 = (equal_1801_s4_q & (x_s4_q[6] & and_2713)) & (less_2694 | less_2692);
  // hls/stages/agreement.hpp:1095
  logic and_2722;
  assign and_2722 = not_1920_s4_q & (less_1874_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2710)));
  // hls/stages/registration.hpp:239
  logic and_2725;
  assign and_2725 = registration_votes_up_q & registration_other_down_q;
  logic select_2727;
  assign select_2727 = registration_votes_down_q ? (registration_other_up_q | and_2725) : and_2725;
  // hls/stages/registration.hpp:137
  logic and_2729;
  assign and_2729 = (equal_1801_s4_q & (x_s4_q[6] & and_2722)) & (registration_other_enough_q & select_2727);
  // hls/stages/registration.hpp:240
  logic or_2732;
  assign or_2732 = registration_moved_q | (registration_enough_q & (and_2717 | and_2729));
  // hls/stages/agreement.hpp:1132
  logic or_2790;
  assign or_2790 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1154
  logic equal_2792;
  assign equal_2792 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1160
  logic equal_2793;
  assign equal_2793 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1163
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1164
  logic select_2799;
  assign select_2799 = (equal_2792 & equal_2793) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1088
  logic [10:0] sum_2802;
  assign sum_2802 = {1'b0, select_2472} + {2'h0, select_2472[9:1]};
  logic select_2805;
  assign select_2805 = (select_2469[9:3] == 7'h0) ? ((~or_2790) & (~select_2799)) : (~({sum_2802, select_2472[0]} < {2'h0, select_2469}));
  // hls/stages/agreement.hpp:1095
  logic [47:0] select_2807;
  assign select_2807 = x_s4_q[6] ? (equal_1846_s4_q ? good_q : {select_2805, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:392
  logic select_2812;
  assign select_2812 = equal_1801_s4_q ? ((x_s4_q[6] & good_known_q) | equal_2810_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1154
  logic equal_2813;
  assign equal_2813 = x_s4_q[6:3] == 4'ha;
  logic equal_2815;
  assign equal_2815 = x_s4_q[6:3] == 4'h9;
  logic equal_2816;
  assign equal_2816 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2818;
  assign select_2818 = equal_2815 ? counts_skin_unproven_q : (equal_2816 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_2813 ? counts_nearer_q : select_2818;
  // hls/stages/agreement.hpp:1159
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1167
  logic select_2821;
  assign select_2821 = (equal_2813 & equal_2793) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1096
  logic not_2822;
  assign not_2822 = ~hidden_for_q[7];
  logic [7:0] select_2824;
  assign select_2824 = select_2821 ? (hidden_for_q + {7'h0, not_2822}) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2826;
  assign select_2826 = equal_1801_s4_q ? (equal_2810_s4_q ? select_2824 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2827;
  assign select_2827 = equal_2793 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1079
  logic [7:0] select_2829;
  assign select_2829 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2831;
  assign select_2831 = equal_2816 ? cfg_unproven_skin_limit_i : (equal_2792 ? cfg_unproven_limit_i : select_2829);
  logic [7:0] limit;
  assign limit = equal_2813 ? cfg_regions_limit_i : (equal_2815 ? cfg_hidden_limit_i : select_2831);
  // hls/stages/agreement.hpp:1167
  logic not_2834;
  assign not_2834 = ~x_s4_q[2];
  logic [3:0] select_2835;
  assign select_2835 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_2834, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_2834};
  logic [7:0] select_2836;
  assign select_2836 = x_s4_q[0] ? {select_2835[3], 1'b0, select_2835[2], 1'b0, select_2835[1], 1'b0, select_2835[0], 1'b0} : {1'b0, select_2835[3], 1'b0, select_2835[2], 1'b0, select_2835[1], 1'b0, select_2835[0]};
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2840;
  assign select_2840 = equal_2815 ? counts_skin_supervised_q : (equal_2816 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2813 ? counts_textured_q : select_2840;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2842;
  assign select_2842 = ((limit & select_2836) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2827} + {1'b0, select_2842};
  // hls/stages/agreement.hpp:392
  logic select_2847;
  assign select_2847 = equal_1801_s4_q ? (equal_2793 ? sum_3[0] : (product_rest_q | sum_3[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1165
  logic and_2852;
  assign and_2852 = too_much_q & (~(equal_2816 & equal_2793));
  // hls/stages/agreement.hpp:1166
  logic select_2857;
  assign select_2857 = (over[14] & equal_2793) ? (and_2852 | ((equal_2816 | equal_2815) | (x_s4_q[6:3] == 4'hf))) : and_2852;
  // hls/stages/agreement.hpp:1240
  logic [1:0] select_2975;
  assign select_2975 = and_2974_s4_q ? {and_2052, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1241
  logic and_2976;
  assign and_2976 = proven_q & less_2964;
  // hls/stages/agreement.hpp:413
  logic select_2979;
  assign select_2979 = and_1981_s4_q ? (less_1982_s4_q ? (select_2975[0] & and_2976) : seen_q) : seen_q;
  logic select_2982;
  assign select_2982 = and_1981_s4_q ? (less_1982_s4_q ? (select_2975[1] & and_2976) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1176
  logic not_2994;
  assign not_2994 = ~(or_2790 | not_2983);
  // hls/stages/agreement.hpp:392
  logic and_2998;
  assign and_2998 = equal_1801_s4_q & (equal_2810_s4_q & (not_2994 & (select_2799 | select_2857)));
  logic and_3001;
  assign and_3001 = equal_1801_s4_q & (equal_2810_s4_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:1098
  logic or_3004;
  assign or_3004 = select_2302 | (select_2314 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:392
  logic and_3011;
  assign and_3011 = equal_1801_s4_q & (equal_2810_s4_q & (not_2994 & (select_2308 | select_2320)));
  // hls/stages/agreement.hpp:1098
  logic and_3016;
  assign and_3016 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_2824 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:392
  logic and_3023;
  assign and_3023 = equal_1801_s4_q & (x_s4_q[6] & (not_1920_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1093
  logic [31:0] select_3031;
  assign select_3031 = equal_1866_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3029_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3032;
  assign select_3032 = equal_1864_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3031;
  logic [31:0] select_3033;
  assign select_3033 = equal_1862_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3032;
  logic [31:0] select_3034;
  assign select_3034 = equal_1860_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3033;
  logic [31:0] select_3035;
  assign select_3035 = equal_1858_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3034;
  logic [31:0] select_3036;
  assign select_3036 = equal_1856_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_3035;
  logic [31:0] select_3037;
  assign select_3037 = equal_1854_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_3036;
  // hls/stages/agreement.hpp:1091
  logic [9:0] select_3038;
  assign select_3038 = less_2468 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_3039;
  assign select_3039 = equal_1846_s4_q ? select_3037 : {2'h0, select_3038, select_2472, select_2469};

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
  assign registration_sums_waddr = {sum_1852_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1908_s4_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_1907, sum_1903};
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
  assign regions_waddr = {region_row_s4_q, or_1918_s4_q, or_1915_s4_q, or_1912_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1947_s4_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_1946, sum_1940, sum_1935};
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
  assign map_waddr = {sum_1987_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_2062_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2052, is_seen};
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
      census_left_misses_q <= select_2211;
      sharpness_sums_detail_0_q <= and_359_s4_q ? select_2231 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_359_s4_q ? select_2242 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_359_s4_q ? sum_2246 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_359_s4_q ? sum_2250 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2268 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2278 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2280 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2282 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2284 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2286 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2291;
      sharpness_comparing_carry_1_q <= select_2295;
      sharpness_comparing_less_detail_0_q <= select_2302;
      sharpness_comparing_less_detail_1_q <= select_2308;
      sharpness_comparing_less_contrast_0_q <= select_2314;
      sharpness_comparing_less_contrast_1_q <= select_2320;
      counts_supervised_q <= select_2426;
      counts_textured_q <= and_2420_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2429});
      counts_explained_q <= and_2420_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2434});
      counts_nearer_q <= and_2420_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2439});
      counts_unproven_q <= and_2420_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2465});
      counts_regions_bad_q <= select_2481;
      counts_skin_supervised_q <= select_2488;
      counts_skin_textured_q <= select_2495;
      counts_skin_unproven_q <= select_2503;
      registration_half_across_q <= select_2577;
      registration_half_measured_q <= select_2582;
      registration_half_votes_down_q <= and_2556_s4_q ? 7'h0 : sum_2588;
      registration_half_votes_up_q <= and_2556_s4_q ? 7'h0 : sum_2596;
      registration_half_half_votes_down_q <= and_2556_s4_q ? 7'h0 : sum_2603;
      registration_half_half_votes_up_q <= and_2556_s4_q ? 7'h0 : sum_2610;
      registration_down_q <= and_2644 ? sum_2663 : registration_down_q;
      registration_up_q <= and_2644 ? sum_2672 : registration_up_q;
      registration_enough_q <= select_2686;
      registration_votes_down_q <= and_2691 ? less_2692 : registration_votes_down_q;
      registration_votes_up_q <= and_2691 ? less_2694 : registration_votes_up_q;
      registration_other_enough_q <= and_2700 ? select_2686 : registration_other_enough_q;
      registration_other_down_q <= and_2700 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2700 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1801_s4_q & and_2707)) & or_2732;
      segment_textured_q <= select_1932 + {6'h0, and_2429};
      segment_explained_q <= select_1937 + {6'h0, and_2434};
      segment_nearer_q <= select_1943 + {6'h0, and_2439};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1801_s4_q ? select_2807 : good_q;
      good_known_q <= select_2812;
      hidden_for_q <= select_2826;
      product_q <= equal_1801_s4_q ? sum_3[14:1] : product_q;
      product_rest_q <= select_2847;
      disagree_q <= equal_1801_s4_q ? select_2799 : disagree_q;
      too_much_q <= equal_1801_s4_q ? select_2857 : too_much_q;
      hides_q <= equal_1801_s4_q ? select_2821 : hides_q;
      seen_q <= select_2979;
      nearer_q <= select_2982;
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
      averager_quarter_1_0_q <= select_2086;
      averager_quarter_1_1_q <= select_2088;
      averager_quarter_2_0_q <= select_2090;
      averager_quarter_2_1_q <= select_2092;
      averager_detail_0_q <= select_2104;
      averager_detail_1_q <= select_2112;
      census_changes_values_0_left_q <= and_359_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_359_s4_q ? sum_2195_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2197;
      census_changes_values_1_right_q <= select_2198;
      census_changes_values_2_left_q <= select_2199;
      census_changes_values_2_right_q <= select_2200;
      sharpness_last_mask_q <= and_359_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_359_s4_q ? select_2216[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_359_s4_q ? select_2216[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_2959_s5_q;
  logic or_2984_s5_q;
  logic and_2985_s5_q;
  logic and_2989_s5_q;
  logic and_2992_s5_q;
  logic and_2998_s5_q;
  logic and_3001_s5_q;
  logic and_3007_s5_q;
  logic and_3011_s5_q;
  logic and_3019_s5_q;
  logic and_3023_s5_q;
  logic [5:0] select_3025_s5_q;
  logic [31:0] select_3041_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_2959_s5_q <= said_q;
      or_2984_s5_q <= not_2983 | select_2979;
      and_2985_s5_q <= cfg_prove_i & select_2982;
      and_2989_s5_q <= and_2989_s4_q;
      and_2992_s5_q <= equal_1801_s4_q & (equal_2810_s4_q & (cfg_prove_i & or_2790));
      and_2998_s5_q <= and_2998;
      and_3001_s5_q <= and_3001;
      and_3007_s5_q <= equal_1801_s4_q & (equal_2810_s4_q & (not_2994 & or_3004));
      and_3011_s5_q <= and_3011;
      and_3019_s5_q <= equal_1801_s4_q & (equal_2810_s4_q & (cfg_prove_i & and_3016));
      and_3023_s5_q <= and_3023;
      select_3025_s5_q <= equal_1801_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3041_s5_q <= equal_1801_s4_q ? (x_s4_q[6] ? select_3039 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_2984_s5_q;
  assign marks_nearer_o = and_2985_s5_q;
  assign verdict_valid_o = and_2959_s5_q;
  assign verdict_unproven_yet_o = and_2989_s5_q;
  assign verdict_untextured_o = and_2992_s5_q;
  assign verdict_disagree_o = and_2998_s5_q;
  assign verdict_moved_o = and_3001_s5_q;
  assign verdict_unsharp_left_o = and_3007_s5_q;
  assign verdict_unsharp_right_o = and_3011_s5_q;
  assign verdict_hidden_o = and_3019_s5_q;
  assign frame_valid_o = and_3023_s5_q;
  assign frame_index_o = select_3025_s5_q;
  assign frame_word_o = select_3041_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_2543[0], sum_2539[0], sum_2525[0], detail_4[1:0], detail_3[1:0], sum_2205[4:0], sum_472[4:0], cfg_width_i[2:0]};

endmodule
