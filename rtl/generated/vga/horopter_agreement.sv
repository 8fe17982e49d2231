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
  logic [5:0] sum_2418;
  assign sum_2418 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_2764;
  assign difference_2764 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2968;
  assign less_2968 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2969;
  assign sum_2969 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_2987;
  assign not_2987 = ~cfg_prove_i;

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
  logic [2:0] select_321;
  assign select_321 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_323;
  assign select_323 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [8:0] select_326;
  assign select_326 = ({select_323, select_321} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_327;
  assign select_327 = select_321[0] ? averager_place_q : select_326;
  // hls/stages/census.hpp:41
  logic or_328;
  assign or_328 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:394
  logic and_334;
  assign and_334 = (~((~or_328) | (~select_321[0]))) & (select_327[8:6] < 3'h5);
  // hls/stages/census.hpp:41
  logic [2:0] select_339;
  assign select_339 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:394
  logic whole;
  assign whole = select_321[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:255
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_323 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_356;
  assign equal_356 = select_321 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_357;
  assign equal_357 = select_339 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_358;
  assign and_358 = equal_357 & and_334;
  // hls/stages/agreement.hpp:255
  logic and_360;
  assign and_360 = sample_pair_whole_q & (equal_356 & and_358);
  // hls/stages/agreement.hpp:181
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:598
  logic equal_380;
  assign equal_380 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:569
  logic or_381;
  assign or_381 = so | equal_380;
  logic not_382;
  assign not_382 = ~or_381;
  // hls/stages/agreement.hpp:589
  logic equal_383;
  assign equal_383 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:590
  logic equal_385;
  assign equal_385 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:567
  logic [7:0] sum_386;
  assign sum_386 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:569
  logic [7:0] select_387;
  assign select_387 = run_shift_q[5] ? x_q : sum_386;
  logic less_388;
  assign less_388 = {1'b0, last_q} < select_387;
  // hls/stages/agreement.hpp:209
  logic not_389;
  assign not_389 = ~less_388;
  // hls/stages/agreement.hpp:137
  logic and_390;
  assign and_390 = equal_385 & not_389;
  logic and_392;
  assign and_392 = not_382 & ((~equal_383) & and_390);
  // hls/stages/census.hpp:41
  logic [5:0] select_419;
  assign select_419 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:255
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_419 : 6'h0;
  // hls/stages/agreement.hpp:137
  logic select_476;
  assign select_476 = equal_383 ? not_389 : and_390;
  // hls/stages/agreement.hpp:788
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:137
  logic and_500;
  assign and_500 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_387)));
  logic and_501;
  assign and_501 = equal_383 & and_500;
  logic select_502;
  assign select_502 = or_381 ? not_389 : and_501;
  // hls/stages/agreement.hpp:793
  logic equal_505;
  assign equal_505 = {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:797
  logic or_507;
  assign or_507 = equal_505 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:809
  logic [6:0] right;
  assign right = sum_386[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:255
  logic [2:0] select_2068;
  assign select_2068 = sample_pair_whole_q ? (sample_last_q ? (select_339 + 3'h1) : select_339) : raster_at_y_q;
  logic [6:0] select_2070;
  assign select_2070 = sample_pair_whole_q ? (select_323 + {6'h0, equal_356}) : raster_at_column_q;
  logic [5:0] select_2073;
  assign select_2073 = sample_pair_whole_q ? (sample_last_q ? (select_419 + {5'h0, equal_357}) : select_419) : raster_at_row_q;
  logic select_2077;
  assign select_2077 = sample_pair_whole_q ? (sample_last_q ? (or_328 & (~raster_final_row_q)) : or_328) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2079;
  assign select_2079 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:255
  logic select_2083;
  assign select_2083 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:435
  logic equal_2327;
  assign equal_2327 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:440
  logic and_2328;
  assign and_2328 = and_360 & equal_2327;
  // hls/stages/agreement.hpp:498
  logic select_2331;
  assign select_2331 = (and_2328 | (~ends_cell_q)) ? and_2328 : ends_q;
  // hls/stages/agreement.hpp:504
  logic [2:0] now;
  assign now = select_2331 ? (and_2328 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:509
  logic [5:0] select_2335;
  assign select_2335 = select_2331 ? (and_2328 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2338;
  assign select_2338 = select_2331 ? (following_last_shift_q & (~and_2328)) : run_last_shift_q;
  // hls/stages/agreement.hpp:582
  logic and_2341;
  assign and_2341 = run_last_shift_q & equal_383;
  // hls/stages/agreement.hpp:591
  logic select_2343;
  assign select_2343 = equal_383 ? (~run_last_shift_q) : equal_385;
  // hls/stages/agreement.hpp:595
  logic equal_2344;
  assign equal_2344 = run_phase_q == 3'h1;
  logic not_2347;
  assign not_2347 = ~select_2343;
  // hls/stages/agreement.hpp:598
  logic equal_2349;
  assign equal_2349 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:582
  logic and_2350;
  assign and_2350 = final_row_q & so;
  // hls/stages/agreement.hpp:595
  logic [1:0] select_2351;
  assign select_2351 = equal_2349 ? 2'h1 : {2{and_2350}};
  logic [2:0] select_2353;
  assign select_2353 = (and_2341 | (select_2343 | equal_2344)) ? (equal_2344 ? 3'h2 : {not_2347, {2{select_2343}}}) : (equal_380 ? 3'h6 : {select_2351[0], select_2351});
  // hls/stages/agreement.hpp:582
  logic and_2356;
  assign and_2356 = select_2343 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:605
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2359;
  assign select_2359 = (plan_shift_q[5] & select_2343) ? value : 7'h0;
  logic [1:0] or_2360;
  assign or_2360 = {2{so}} | select_2359[5:4];
  // hls/stages/agreement.hpp:608
  logic [7:0] or_2364;
  assign or_2364 = (select_2343 ? plan_columns_q : 8'h0) | ((equal_2344 | equal_2349) ? whole_q : 8'h0);
  logic [1:0] or_2365;
  assign or_2365 = {2{and_2341}} | or_2364[3:2];
  // hls/stages/agreement.hpp:609
  logic [7:0] or_2367;
  assign or_2367 = {or_2364[7:4], or_2365, or_2364[1:0]} | (equal_380 ? drawn_q : 8'h0);
  logic [4:0] or_2368;
  assign or_2368 = {5{so}} | {or_2367[6], or_2367[3:0]};
  // hls/stages/agreement.hpp:615
  logic not_2372;
  assign not_2372 = ~run_shift_q[5];
  logic [7:0] select_2375;
  assign select_2375 = equal_383 ? ({{7{not_2372}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:498
  logic [6:0] select_2379;
  assign select_2379 = and_2328 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:501
  logic [7:0] select_2381;
  assign select_2381 = select_2331 ? {select_2379[6], select_2379} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2384;
  assign select_2384 = select_2331 ? (and_2328 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2392;
  assign select_2392 = and_360 ? (equal_2327 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2395;
  assign select_2395 = and_360 ? (equal_2327 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2398;
  assign select_2398 = and_360 ? (equal_2327 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:506
  logic select_2409;
  assign select_2409 = (ends_cell_q | select_2331) ? (~(now == 3'h6)) : (equal_383 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:501
  logic and_2413;
  assign and_2413 = (~select_2331) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:451
  logic [6:0] sum_2414;
  assign sum_2414 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:436
  logic select_2416;
  assign select_2416 = equal_2327 ? ({sum_2414[6], cfg_height_i[8:3]} == {1'b0, sum_2414[5:0]}) : final_row_q;

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
  assign fresh_re = s0_en & and_392;
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
  assign left_re = s0_en & (or_381 ? not_389 : select_476);
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
  assign right_codes_raddr = equal_383 ? sum_386[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_382 & select_476);
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
  assign best_left_raddr = or_381 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_502;
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
      raster_at_x_q <= sample_pair_whole_q ? (select_321 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2068;
      raster_at_column_q <= select_2070;
      raster_at_row_q <= select_2073;
      raster_at_live_q <= select_2077;
      raster_rows_left_q <= sample_pair_whole_q ? select_2079 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2083;
      averager_place_q <= sample_pair_whole_q ? select_327 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= now;
      run_shift_q <= select_2335;
      run_last_shift_q <= select_2338;
      run_span_q <= select_2331 ? (and_2328 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2353;
      following_shift_q <= select_2343 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2356;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2359[6], or_2360, select_2359[3:0]};
      following_columns_q <= {or_2367[7], or_2368[4], or_2367[5:4], or_2368[3:0]};
      plan_shift_q <= equal_383 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2375;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2381;
      columns_left_q <= select_2384;
      last_q <= and_360 ? (equal_2327 ? column : last_q) : last_q;
      least_q <= select_2392;
      whole_q <= select_2395;
      drawn_q <= select_2398;
      age_q <= select_2331 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2331 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2409;
      ends_q <= and_2413;
      final_row_q <= and_360 ? select_2416 : final_row_q;
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
  logic select_321_s1_q;
  logic [8:0] select_327_s1_q;
  logic and_334_s1_q;
  logic equal_340_s1_q;
  logic whole_s1_q;
  logic [6:0] column_s1_q;
  logic and_358_s1_q;
  logic and_360_s1_q;
  logic equal_363_s1_q;
  logic so_s1_q;
  logic equal_380_s1_q;
  logic or_381_s1_q;
  logic equal_383_s1_q;
  logic less_388_s1_q;
  logic not_389_s1_q;
  logic and_392_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_502_s1_q;
  logic select_509_s1_q;
  logic and_1784_s1_q;
  logic [6:0] right_s1_q;
  logic select_1793_s1_q;
  logic equal_1802_s1_q;
  logic equal_2327_s1_q;
  logic and_2328_s1_q;
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
      select_321_s1_q <= select_321[0];
      select_327_s1_q <= select_327;
      and_334_s1_q <= and_334;
      equal_340_s1_q <= select_339 == 3'h0;
      whole_s1_q <= whole;
      column_s1_q <= column;
      and_358_s1_q <= and_358;
      and_360_s1_q <= and_360;
      equal_363_s1_q <= select_321 == 3'h1;
      so_s1_q <= so;
      equal_380_s1_q <= equal_380;
      or_381_s1_q <= or_381;
      equal_383_s1_q <= equal_383;
      less_388_s1_q <= less_388;
      not_389_s1_q <= not_389;
      and_392_s1_q <= and_392;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_502_s1_q <= select_502;
      select_509_s1_q <= or_507 ? equal_505 : (~age_q[3]);
      and_1784_s1_q <= not_382 & and_501;
      right_s1_q <= right;
      select_1793_s1_q <= or_507 ? equal_505 : ({x[7], last_q} == {1'b0, x[6:0]});
      equal_1802_s1_q <= run_phase_q == 3'h7;
      equal_2327_s1_q <= equal_2327;
      and_2328_s1_q <= and_2328;
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
  logic and_335;
  assign and_335 = sample_pair_whole_s1_q & and_334_s1_q;
  // hls/stages/agreement.hpp:641
  logic not_480;
  assign not_480 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:644
  logic and_481;
  assign and_481 = left_rdata_q[12] & not_480;
  logic and_482;
  assign and_482 = left_rdata_q[28] & not_480;
  logic and_483;
  assign and_483 = left_rdata_q[44] & not_480;
  logic and_484;
  assign and_484 = left_rdata_q[60] & not_480;
  // hls/stages/agreement.hpp:645
  logic and_488;
  assign and_488 = right_codes_rdata_q[12] & not_480;
  logic and_489;
  assign and_489 = right_codes_rdata_q[25] & not_480;
  logic and_490;
  assign and_490 = right_codes_rdata_q[38] & not_480;
  logic and_491;
  assign and_491 = right_codes_rdata_q[51] & not_480;
  logic and_492;
  assign and_492 = right_codes_rdata_q[64] & not_480;
  logic and_493;
  assign and_493 = right_codes_rdata_q[77] & not_480;
  // hls/stages/agreement.hpp:205
  logic and_515;
  assign and_515 = left_rdata_q[44] & not_389_s1_q;
  logic and_516;
  assign and_516 = right_codes_rdata_q[38] & not_389_s1_q;
  logic [11:0] select_517;
  assign select_517 = less_388_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_518;
  assign select_518 = less_388_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_522;
  assign select_522 = and_515 ? (and_516 ? (~(select_517 ^ select_518)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_528;
  assign parity_528 = ^select_522[5:3];
  logic parity_531;
  assign parity_531 = ^select_522[8:6];
  logic parity_534;
  assign parity_534 = ^select_522[11:3];
  // hls/stages/agreement.hpp:205
  logic and_538;
  assign and_538 = left_rdata_q[60] & not_389_s1_q;
  logic and_539;
  assign and_539 = right_codes_rdata_q[51] & not_389_s1_q;
  logic [11:0] select_540;
  assign select_540 = less_388_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_541;
  assign select_541 = less_388_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_545;
  assign select_545 = and_538 ? (and_539 ? (~(select_540 ^ select_541)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_548;
  assign parity_548 = ^select_545[8:6];
  logic parity_551;
  assign parity_551 = ^select_545[11:9];
  // hls/stages/agreement.hpp:205
  logic and_555;
  assign and_555 = left_rdata_q[76] & not_389_s1_q;
  logic and_556;
  assign and_556 = right_codes_rdata_q[64] & not_389_s1_q;
  logic [11:0] select_557;
  assign select_557 = less_388_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_558;
  assign select_558 = less_388_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_562;
  assign select_562 = and_555 ? (and_556 ? (~(select_557 ^ select_558)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_568;
  assign parity_568 = ^select_562[2:0];
  logic parity_571;
  assign parity_571 = ^select_562[5:3];
  logic parity_574;
  assign parity_574 = ^select_562[8:0];
  logic parity_580;
  assign parity_580 = ^select_562[11:9];
  logic parity_583;
  assign parity_583 = ^select_545[2:0];
  logic parity_586;
  assign parity_586 = ^{select_562[11:9], select_545[5:0]};
  logic parity_589;
  assign parity_589 = ^{select_562, select_545, select_522[2:0]};
  logic xor_590;
  assign xor_590 = parity_534 ^ parity_589;
  // hls/stages/agreement.hpp:671
  logic or_594;
  assign or_594 = (select_522[1:0] == 2'h3) | (select_522[2] & (select_522[0] | select_522[1]));
  // hls/stages/agreement.hpp:673
  logic or_598;
  assign or_598 = (select_545[7:6] == 2'h3) | (select_545[8] & (select_545[6] | select_545[7]));
  logic or_602;
  assign or_602 = (select_545[10:9] == 2'h3) | (select_545[11] & (select_545[9] | select_545[10]));
  // hls/stages/agreement.hpp:671
  logic or_610;
  assign or_610 = (select_562[7:6] == 2'h3) | (select_562[8] & (~(select_562[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_614;
  assign or_614 = (select_562[1:0] == 2'h3) | (select_562[2] & (select_562[0] | select_562[1]));
  logic or_618;
  assign or_618 = (select_562[4:3] == 2'h3) | (select_562[5] & (select_562[3] | select_562[4]));
  // hls/stages/agreement.hpp:672
  logic parity_621;
  assign parity_621 = ^{or_618, or_614, or_610};
  // hls/stages/agreement.hpp:671
  logic or_625;
  assign or_625 = (select_545[4:3] == 2'h3) | (select_545[5] & (select_545[3] | select_545[4]));
  // hls/stages/agreement.hpp:673
  logic or_629;
  assign or_629 = (select_562[10:9] == 2'h3) | (select_562[11] & (select_562[9] | select_562[10]));
  logic or_633;
  assign or_633 = (select_545[1:0] == 2'h3) | (select_545[2] & (select_545[0] | select_545[1]));
  // hls/stages/agreement.hpp:672
  logic parity_636;
  assign parity_636 = ^{or_633, or_629, or_625};
  logic parity_639;
  assign parity_639 = ^{or_633, or_629, or_625, or_618, or_614, or_610, or_602, or_598, or_594};
  // hls/stages/agreement.hpp:673
  logic and_640;
  assign and_640 = parity_534 & parity_589;
  logic or_644;
  assign or_644 = (parity_528 & parity_531) | ((^select_522[11:9]) & (parity_528 | parity_531));
  logic and_647;
  assign and_647 = (^{select_545[11:6], select_522[2:0]}) & (parity_574 | parity_586);
  logic or_648;
  assign or_648 = (parity_574 & parity_586) | and_647;
  // hls/stages/agreement.hpp:671
  logic or_655;
  assign or_655 = (select_522[10:9] == 2'h3) | (select_522[11] & (select_522[9] | select_522[10]));
  // hls/stages/agreement.hpp:673
  logic or_659;
  assign or_659 = (select_522[4:3] == 2'h3) | (select_522[5] & (select_522[3] | select_522[4]));
  logic or_663;
  assign or_663 = (select_522[7:6] == 2'h3) | (select_522[8] & (select_522[6] | select_522[7]));
  // hls/stages/agreement.hpp:672
  logic parity_666;
  assign parity_666 = ^{or_663, or_659, or_655};
  // hls/stages/agreement.hpp:673
  logic or_670;
  assign or_670 = (parity_548 & parity_551) | ((^select_522[2:0]) & (parity_548 | parity_551));
  logic or_674;
  assign or_674 = (parity_568 & parity_571) | ((^select_562[8:6]) & (parity_568 | parity_571));
  logic or_678;
  assign or_678 = (parity_580 & parity_583) | ((^select_545[5:3]) & (parity_580 | parity_583));
  // hls/stages/agreement.hpp:672
  logic parity_681;
  assign parity_681 = ^{or_678, or_674, or_670};
  logic parity_684;
  assign parity_684 = ^{or_678, or_674, or_670, or_663, or_659, or_655, or_648, or_644, and_640};
  logic xor_685;
  assign xor_685 = parity_639 ^ parity_684;
  // hls/stages/agreement.hpp:673
  logic and_686;
  assign and_686 = parity_639 & parity_684;
  logic or_690;
  assign or_690 = (parity_621 & parity_636) | ((^{or_602, or_598, or_594}) & (parity_621 | parity_636));
  logic or_694;
  assign or_694 = (parity_666 & parity_681) | ((^{or_648, or_644, and_640}) & (parity_666 | parity_681));
  logic or_701;
  assign or_701 = (or_598 & or_602) | (or_594 & (or_598 | or_602));
  logic or_705;
  assign or_705 = (or_614 & or_618) | (or_610 & (or_614 | or_618));
  logic or_709;
  assign or_709 = (or_629 & or_633) | (or_625 & (or_629 | or_633));
  // hls/stages/agreement.hpp:672
  logic parity_712;
  assign parity_712 = ^{or_709, or_705, or_701};
  // hls/stages/agreement.hpp:673
  logic or_716;
  assign or_716 = (or_644 & or_648) | (and_640 & (or_644 | or_648));
  logic or_720;
  assign or_720 = (or_659 & or_663) | (or_655 & (or_659 | or_663));
  logic or_724;
  assign or_724 = (or_674 & or_678) | (or_670 & (or_674 | or_678));
  // hls/stages/agreement.hpp:672
  logic parity_727;
  assign parity_727 = ^{or_724, or_720, or_716};
  logic parity_730;
  assign parity_730 = ^{or_724, or_720, or_716, or_709, or_705, or_701, or_694, or_690, and_686};
  // hls/stages/agreement.hpp:673
  logic or_734;
  assign or_734 = (parity_712 & parity_727) | ((^{or_694, or_690, and_686}) & (parity_712 | parity_727));
  logic or_738;
  assign or_738 = (or_690 & or_694) | (and_686 & (or_690 | or_694));
  logic or_742;
  assign or_742 = (or_705 & or_709) | (or_701 & (or_705 | or_709));
  logic or_746;
  assign or_746 = (or_720 & or_724) | (or_716 & (or_720 | or_724));
  // hls/stages/agreement.hpp:672
  logic parity_751;
  assign parity_751 = ^{or_746, or_742, or_738, or_734};
  // hls/stages/agreement.hpp:673
  logic or_755;
  assign or_755 = (or_742 & or_746) | (or_738 & (or_742 | or_746));
  logic and_756;
  assign and_756 = or_734 & (^{or_746, or_742, or_738});
  // hls/stages/agreement.hpp:672
  logic xor_757;
  assign xor_757 = or_755 ^ and_756;
  // hls/stages/agreement.hpp:675
  logic and_758;
  assign and_758 = or_755 & and_756;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_759;
  assign select_759 = equal_383_s1_q ? {and_758, xor_757, parity_751, parity_730, xor_685, xor_590} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_381_s1_q ? 6'h0 : select_759;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_761;
  assign select_761 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_762;
  assign difference_762 = {1'b0, column_2} - {1'b0, select_761};
  logic [7:0] sum_764;
  assign sum_764 = {difference_762[6], difference_762} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:657
  logic [11:0] select_768;
  assign select_768 = and_515 ? (and_539 ? (~(select_540 ^ select_518)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_774;
  assign parity_774 = ^select_768[5:3];
  logic parity_777;
  assign parity_777 = ^select_768[8:6];
  logic parity_780;
  assign parity_780 = ^select_768[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_787;
  assign select_787 = and_538 ? (and_556 ? (~(select_557 ^ select_541)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_790;
  assign parity_790 = ^select_787[8:6];
  logic parity_793;
  assign parity_793 = ^select_787[11:9];
  // hls/stages/agreement.hpp:205
  logic and_797;
  assign and_797 = right_codes_rdata_q[77] & not_389_s1_q;
  logic [11:0] select_798;
  assign select_798 = less_388_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_802;
  assign select_802 = and_555 ? (and_797 ? (~(select_798 ^ select_558)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_808;
  assign parity_808 = ^select_802[2:0];
  logic parity_811;
  assign parity_811 = ^select_802[5:3];
  logic parity_814;
  assign parity_814 = ^select_802[8:0];
  logic parity_820;
  assign parity_820 = ^select_802[11:9];
  logic parity_823;
  assign parity_823 = ^select_787[2:0];
  logic parity_826;
  assign parity_826 = ^{select_802[11:9], select_787[5:0]};
  logic parity_829;
  assign parity_829 = ^{select_802, select_787, select_768[2:0]};
  logic xor_830;
  assign xor_830 = parity_780 ^ parity_829;
  // hls/stages/agreement.hpp:671
  logic or_834;
  assign or_834 = (select_768[1:0] == 2'h3) | (select_768[2] & (select_768[0] | select_768[1]));
  // hls/stages/agreement.hpp:673
  logic or_838;
  assign or_838 = (select_787[7:6] == 2'h3) | (select_787[8] & (select_787[6] | select_787[7]));
  logic or_842;
  assign or_842 = (select_787[10:9] == 2'h3) | (select_787[11] & (select_787[9] | select_787[10]));
  // hls/stages/agreement.hpp:671
  logic or_850;
  assign or_850 = (select_802[7:6] == 2'h3) | (select_802[8] & (~(select_802[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_854;
  assign or_854 = (select_802[1:0] == 2'h3) | (select_802[2] & (select_802[0] | select_802[1]));
  logic or_858;
  assign or_858 = (select_802[4:3] == 2'h3) | (select_802[5] & (select_802[3] | select_802[4]));
  // hls/stages/agreement.hpp:672
  logic parity_861;
  assign parity_861 = ^{or_858, or_854, or_850};
  // hls/stages/agreement.hpp:671
  logic or_865;
  assign or_865 = (select_787[4:3] == 2'h3) | (select_787[5] & (select_787[3] | select_787[4]));
  // hls/stages/agreement.hpp:673
  logic or_869;
  assign or_869 = (select_802[10:9] == 2'h3) | (select_802[11] & (select_802[9] | select_802[10]));
  logic or_873;
  assign or_873 = (select_787[1:0] == 2'h3) | (select_787[2] & (select_787[0] | select_787[1]));
  // hls/stages/agreement.hpp:672
  logic parity_876;
  assign parity_876 = ^{or_873, or_869, or_865};
  logic parity_879;
  assign parity_879 = ^{or_873, or_869, or_865, or_858, or_854, or_850, or_842, or_838, or_834};
  // hls/stages/agreement.hpp:673
  logic and_880;
  assign and_880 = parity_780 & parity_829;
  logic or_884;
  assign or_884 = (parity_774 & parity_777) | ((^select_768[11:9]) & (parity_774 | parity_777));
  logic and_887;
  assign and_887 = (^{select_787[11:6], select_768[2:0]}) & (parity_814 | parity_826);
  logic or_888;
  assign or_888 = (parity_814 & parity_826) | and_887;
  // hls/stages/agreement.hpp:671
  logic or_895;
  assign or_895 = (select_768[10:9] == 2'h3) | (select_768[11] & (select_768[9] | select_768[10]));
  // hls/stages/agreement.hpp:673
  logic or_899;
  assign or_899 = (select_768[4:3] == 2'h3) | (select_768[5] & (select_768[3] | select_768[4]));
  logic or_903;
  assign or_903 = (select_768[7:6] == 2'h3) | (select_768[8] & (select_768[6] | select_768[7]));
  // hls/stages/agreement.hpp:672
  logic parity_906;
  assign parity_906 = ^{or_903, or_899, or_895};
  // hls/stages/agreement.hpp:673
  logic or_910;
  assign or_910 = (parity_790 & parity_793) | ((^select_768[2:0]) & (parity_790 | parity_793));
  logic or_914;
  assign or_914 = (parity_808 & parity_811) | ((^select_802[8:6]) & (parity_808 | parity_811));
  logic or_918;
  assign or_918 = (parity_820 & parity_823) | ((^select_787[5:3]) & (parity_820 | parity_823));
  // hls/stages/agreement.hpp:672
  logic parity_921;
  assign parity_921 = ^{or_918, or_914, or_910};
  logic parity_924;
  assign parity_924 = ^{or_918, or_914, or_910, or_903, or_899, or_895, or_888, or_884, and_880};
  logic xor_925;
  assign xor_925 = parity_879 ^ parity_924;
  // hls/stages/agreement.hpp:673
  logic and_926;
  assign and_926 = parity_879 & parity_924;
  logic or_930;
  assign or_930 = (parity_861 & parity_876) | ((^{or_842, or_838, or_834}) & (parity_861 | parity_876));
  logic or_934;
  assign or_934 = (parity_906 & parity_921) | ((^{or_888, or_884, and_880}) & (parity_906 | parity_921));
  logic or_941;
  assign or_941 = (or_838 & or_842) | (or_834 & (or_838 | or_842));
  logic or_945;
  assign or_945 = (or_854 & or_858) | (or_850 & (or_854 | or_858));
  logic or_949;
  assign or_949 = (or_869 & or_873) | (or_865 & (or_869 | or_873));
  // hls/stages/agreement.hpp:672
  logic parity_952;
  assign parity_952 = ^{or_949, or_945, or_941};
  // hls/stages/agreement.hpp:673
  logic or_956;
  assign or_956 = (or_884 & or_888) | (and_880 & (or_884 | or_888));
  logic or_960;
  assign or_960 = (or_899 & or_903) | (or_895 & (or_899 | or_903));
  logic or_964;
  assign or_964 = (or_914 & or_918) | (or_910 & (or_914 | or_918));
  // hls/stages/agreement.hpp:672
  logic parity_967;
  assign parity_967 = ^{or_964, or_960, or_956};
  logic parity_970;
  assign parity_970 = ^{or_964, or_960, or_956, or_949, or_945, or_941, or_934, or_930, and_926};
  // hls/stages/agreement.hpp:673
  logic or_974;
  assign or_974 = (parity_952 & parity_967) | ((^{or_934, or_930, and_926}) & (parity_952 | parity_967));
  logic or_978;
  assign or_978 = (or_930 & or_934) | (and_926 & (or_930 | or_934));
  logic or_982;
  assign or_982 = (or_945 & or_949) | (or_941 & (or_945 | or_949));
  logic or_986;
  assign or_986 = (or_960 & or_964) | (or_956 & (or_960 | or_964));
  // hls/stages/agreement.hpp:672
  logic parity_991;
  assign parity_991 = ^{or_986, or_982, or_978, or_974};
  // hls/stages/agreement.hpp:673
  logic or_995;
  assign or_995 = (or_982 & or_986) | (or_978 & (or_982 | or_986));
  logic and_996;
  assign and_996 = or_974 & (^{or_986, or_982, or_978});
  // hls/stages/agreement.hpp:672
  logic xor_997;
  assign xor_997 = or_995 ^ and_996;
  // hls/stages/agreement.hpp:675
  logic and_998;
  assign and_998 = or_995 & and_996;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_999;
  assign select_999 = equal_383_s1_q ? {and_998, xor_997, parity_991, parity_970, xor_925, xor_830} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_381_s1_q ? 6'h0 : select_999;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_1001;
  assign select_1001 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1002;
  assign difference_1002 = {1'b0, column_3} - {1'b0, select_1001};
  logic [7:0] sum_1004;
  assign sum_1004 = {difference_1002[6], difference_1002} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:205
  logic and_1005;
  assign and_1005 = right_codes_rdata_q[25] & not_389_s1_q;
  logic [11:0] select_1006;
  assign select_1006 = less_388_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1010;
  assign select_1010 = and_515 ? (and_1005 ? (~(select_1006 ^ select_518)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1016;
  assign parity_1016 = ^select_1010[5:3];
  logic parity_1019;
  assign parity_1019 = ^select_1010[8:6];
  logic parity_1022;
  assign parity_1022 = ^select_1010[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1029;
  assign select_1029 = and_538 ? (and_516 ? (~(select_517 ^ select_541)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1032;
  assign parity_1032 = ^select_1029[8:6];
  logic parity_1035;
  assign parity_1035 = ^select_1029[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1042;
  assign select_1042 = and_555 ? (and_539 ? (~(select_540 ^ select_558)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1048;
  assign parity_1048 = ^select_1042[2:0];
  logic parity_1051;
  assign parity_1051 = ^select_1042[5:3];
  logic parity_1054;
  assign parity_1054 = ^select_1042[8:0];
  logic parity_1060;
  assign parity_1060 = ^select_1042[11:9];
  logic parity_1063;
  assign parity_1063 = ^select_1029[2:0];
  logic parity_1066;
  assign parity_1066 = ^{select_1042[11:9], select_1029[5:0]};
  logic parity_1069;
  assign parity_1069 = ^{select_1042, select_1029, select_1010[2:0]};
  logic xor_1070;
  assign xor_1070 = parity_1022 ^ parity_1069;
  // hls/stages/agreement.hpp:671
  logic or_1074;
  assign or_1074 = (select_1010[1:0] == 2'h3) | (select_1010[2] & (select_1010[0] | select_1010[1]));
  // hls/stages/agreement.hpp:673
  logic or_1078;
  assign or_1078 = (select_1029[7:6] == 2'h3) | (select_1029[8] & (select_1029[6] | select_1029[7]));
  logic or_1082;
  assign or_1082 = (select_1029[10:9] == 2'h3) | (select_1029[11] & (select_1029[9] | select_1029[10]));
  // hls/stages/agreement.hpp:671
  logic or_1090;
  assign or_1090 = (select_1042[7:6] == 2'h3) | (select_1042[8] & (~(select_1042[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_1094;
  assign or_1094 = (select_1042[1:0] == 2'h3) | (select_1042[2] & (select_1042[0] | select_1042[1]));
  logic or_1098;
  assign or_1098 = (select_1042[4:3] == 2'h3) | (select_1042[5] & (select_1042[3] | select_1042[4]));
  // hls/stages/agreement.hpp:672
  logic parity_1101;
  assign parity_1101 = ^{or_1098, or_1094, or_1090};
  // hls/stages/agreement.hpp:671
  logic or_1105;
  assign or_1105 = (select_1029[4:3] == 2'h3) | (select_1029[5] & (select_1029[3] | select_1029[4]));
  // hls/stages/agreement.hpp:673
  logic or_1109;
  assign or_1109 = (select_1042[10:9] == 2'h3) | (select_1042[11] & (select_1042[9] | select_1042[10]));
  logic or_1113;
  assign or_1113 = (select_1029[1:0] == 2'h3) | (select_1029[2] & (select_1029[0] | select_1029[1]));
  // hls/stages/agreement.hpp:672
  logic parity_1116;
  assign parity_1116 = ^{or_1113, or_1109, or_1105};
  logic parity_1119;
  assign parity_1119 = ^{or_1113, or_1109, or_1105, or_1098, or_1094, or_1090, or_1082, or_1078, or_1074};
  // hls/stages/agreement.hpp:673
  logic and_1120;
  assign and_1120 = parity_1022 & parity_1069;
  logic or_1124;
  assign or_1124 = (parity_1016 & parity_1019) | ((^select_1010[11:9]) & (parity_1016 | parity_1019));
  logic and_1127;
  assign and_1127 = (^{select_1029[11:6], select_1010[2:0]}) & (parity_1054 | parity_1066);
  logic or_1128;
  assign or_1128 = (parity_1054 & parity_1066) | and_1127;
  // hls/stages/agreement.hpp:671
  logic or_1135;
  assign or_1135 = (select_1010[10:9] == 2'h3) | (select_1010[11] & (select_1010[9] | select_1010[10]));
  // hls/stages/agreement.hpp:673
  logic or_1139;
  assign or_1139 = (select_1010[4:3] == 2'h3) | (select_1010[5] & (select_1010[3] | select_1010[4]));
  logic or_1143;
  assign or_1143 = (select_1010[7:6] == 2'h3) | (select_1010[8] & (select_1010[6] | select_1010[7]));
  // hls/stages/agreement.hpp:672
  logic parity_1146;
  assign parity_1146 = ^{or_1143, or_1139, or_1135};
  // hls/stages/agreement.hpp:673
  logic or_1150;
  assign or_1150 = (parity_1032 & parity_1035) | ((^select_1010[2:0]) & (parity_1032 | parity_1035));
  logic or_1154;
  assign or_1154 = (parity_1048 & parity_1051) | ((^select_1042[8:6]) & (parity_1048 | parity_1051));
  logic or_1158;
  assign or_1158 = (parity_1060 & parity_1063) | ((^select_1029[5:3]) & (parity_1060 | parity_1063));
  // hls/stages/agreement.hpp:672
  logic parity_1161;
  assign parity_1161 = ^{or_1158, or_1154, or_1150};
  logic parity_1164;
  assign parity_1164 = ^{or_1158, or_1154, or_1150, or_1143, or_1139, or_1135, or_1128, or_1124, and_1120};
  logic xor_1165;
  assign xor_1165 = parity_1119 ^ parity_1164;
  // hls/stages/agreement.hpp:673
  logic and_1166;
  assign and_1166 = parity_1119 & parity_1164;
  logic or_1170;
  assign or_1170 = (parity_1101 & parity_1116) | ((^{or_1082, or_1078, or_1074}) & (parity_1101 | parity_1116));
  logic or_1174;
  assign or_1174 = (parity_1146 & parity_1161) | ((^{or_1128, or_1124, and_1120}) & (parity_1146 | parity_1161));
  logic or_1181;
  assign or_1181 = (or_1078 & or_1082) | (or_1074 & (or_1078 | or_1082));
  logic or_1185;
  assign or_1185 = (or_1094 & or_1098) | (or_1090 & (or_1094 | or_1098));
  logic or_1189;
  assign or_1189 = (or_1109 & or_1113) | (or_1105 & (or_1109 | or_1113));
  // hls/stages/agreement.hpp:672
  logic parity_1192;
  assign parity_1192 = ^{or_1189, or_1185, or_1181};
  // hls/stages/agreement.hpp:673
  logic or_1196;
  assign or_1196 = (or_1124 & or_1128) | (and_1120 & (or_1124 | or_1128));
  logic or_1200;
  assign or_1200 = (or_1139 & or_1143) | (or_1135 & (or_1139 | or_1143));
  logic or_1204;
  assign or_1204 = (or_1154 & or_1158) | (or_1150 & (or_1154 | or_1158));
  // hls/stages/agreement.hpp:672
  logic parity_1207;
  assign parity_1207 = ^{or_1204, or_1200, or_1196};
  logic parity_1210;
  assign parity_1210 = ^{or_1204, or_1200, or_1196, or_1189, or_1185, or_1181, or_1174, or_1170, and_1166};
  // hls/stages/agreement.hpp:673
  logic or_1214;
  assign or_1214 = (parity_1192 & parity_1207) | ((^{or_1174, or_1170, and_1166}) & (parity_1192 | parity_1207));
  logic or_1218;
  assign or_1218 = (or_1170 & or_1174) | (and_1166 & (or_1170 | or_1174));
  logic or_1222;
  assign or_1222 = (or_1185 & or_1189) | (or_1181 & (or_1185 | or_1189));
  logic or_1226;
  assign or_1226 = (or_1200 & or_1204) | (or_1196 & (or_1200 | or_1204));
  // hls/stages/agreement.hpp:672
  logic parity_1231;
  assign parity_1231 = ^{or_1226, or_1222, or_1218, or_1214};
  // hls/stages/agreement.hpp:673
  logic or_1235;
  assign or_1235 = (or_1222 & or_1226) | (or_1218 & (or_1222 | or_1226));
  logic and_1236;
  assign and_1236 = or_1214 & (^{or_1226, or_1222, or_1218});
  // hls/stages/agreement.hpp:672
  logic xor_1237;
  assign xor_1237 = or_1235 ^ and_1236;
  // hls/stages/agreement.hpp:675
  logic and_1238;
  assign and_1238 = or_1235 & and_1236;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1239;
  assign select_1239 = equal_383_s1_q ? {and_1238, xor_1237, parity_1231, parity_1210, xor_1165, xor_1070} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_381_s1_q ? 6'h0 : select_1239;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_1241;
  assign select_1241 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1242;
  assign difference_1242 = {1'b0, column_4} - {1'b0, select_1241};
  logic [7:0] sum_1244;
  assign sum_1244 = {difference_1242[6], difference_1242} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1252;
  assign select_1252 = and_515 ? (and_556 ? (~(select_557 ^ select_518)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1258;
  assign parity_1258 = ^select_1252[5:3];
  logic parity_1261;
  assign parity_1261 = ^select_1252[8:6];
  logic parity_1264;
  assign parity_1264 = ^select_1252[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1271;
  assign select_1271 = and_538 ? (and_797 ? (~(select_798 ^ select_541)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1274;
  assign parity_1274 = ^select_1271[8:6];
  logic parity_1277;
  assign parity_1277 = ^select_1271[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] xor_1283;
  assign xor_1283 = (less_388_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_558;
  logic [11:0] select_1286;
  assign select_1286 = and_555 ? ((right_codes_rdata_q[90] & not_389_s1_q) ? (~xor_1283) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1292;
  assign parity_1292 = ^select_1286[2:0];
  logic parity_1295;
  assign parity_1295 = ^select_1286[5:3];
  logic parity_1298;
  assign parity_1298 = ^select_1286[8:0];
  logic parity_1304;
  assign parity_1304 = ^select_1286[11:9];
  logic parity_1307;
  assign parity_1307 = ^select_1271[2:0];
  logic parity_1310;
  assign parity_1310 = ^{select_1286[11:9], select_1271[5:0]};
  logic parity_1313;
  assign parity_1313 = ^{select_1286, select_1271, select_1252[2:0]};
  logic xor_1314;
  assign xor_1314 = parity_1264 ^ parity_1313;
  // hls/stages/agreement.hpp:671
  logic or_1318;
  assign or_1318 = (select_1252[1:0] == 2'h3) | (select_1252[2] & (select_1252[0] | select_1252[1]));
  // hls/stages/agreement.hpp:673
  logic or_1322;
  assign or_1322 = (select_1271[7:6] == 2'h3) | (select_1271[8] & (select_1271[6] | select_1271[7]));
  logic or_1326;
  assign or_1326 = (select_1271[10:9] == 2'h3) | (select_1271[11] & (select_1271[9] | select_1271[10]));
  // hls/stages/agreement.hpp:671
  logic or_1334;
  assign or_1334 = (select_1286[7:6] == 2'h3) | (select_1286[8] & (~(select_1286[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_1338;
  assign or_1338 = (select_1286[1:0] == 2'h3) | (select_1286[2] & (select_1286[0] | select_1286[1]));
  logic or_1342;
  assign or_1342 = (select_1286[4:3] == 2'h3) | (select_1286[5] & (select_1286[3] | select_1286[4]));
  // hls/stages/agreement.hpp:672
  logic parity_1345;
  assign parity_1345 = ^{or_1342, or_1338, or_1334};
  // hls/stages/agreement.hpp:671
  logic or_1349;
  assign or_1349 = (select_1271[4:3] == 2'h3) | (select_1271[5] & (select_1271[3] | select_1271[4]));
  // hls/stages/agreement.hpp:673
  logic or_1353;
  assign or_1353 = (select_1286[10:9] == 2'h3) | (select_1286[11] & (select_1286[9] | select_1286[10]));
  logic or_1357;
  assign or_1357 = (select_1271[1:0] == 2'h3) | (select_1271[2] & (select_1271[0] | select_1271[1]));
  // hls/stages/agreement.hpp:672
  logic parity_1360;
  assign parity_1360 = ^{or_1357, or_1353, or_1349};
  logic parity_1363;
  assign parity_1363 = ^{or_1357, or_1353, or_1349, or_1342, or_1338, or_1334, or_1326, or_1322, or_1318};
  // hls/stages/agreement.hpp:673
  logic and_1364;
  assign and_1364 = parity_1264 & parity_1313;
  logic or_1368;
  assign or_1368 = (parity_1258 & parity_1261) | ((^select_1252[11:9]) & (parity_1258 | parity_1261));
  logic and_1371;
  assign and_1371 = (^{select_1271[11:6], select_1252[2:0]}) & (parity_1298 | parity_1310);
  logic or_1372;
  assign or_1372 = (parity_1298 & parity_1310) | and_1371;
  // hls/stages/agreement.hpp:671
  logic or_1379;
  assign or_1379 = (select_1252[10:9] == 2'h3) | (select_1252[11] & (select_1252[9] | select_1252[10]));
  // hls/stages/agreement.hpp:673
  logic or_1383;
  assign or_1383 = (select_1252[4:3] == 2'h3) | (select_1252[5] & (select_1252[3] | select_1252[4]));
  logic or_1387;
  assign or_1387 = (select_1252[7:6] == 2'h3) | (select_1252[8] & (select_1252[6] | select_1252[7]));
  // hls/stages/agreement.hpp:672
  logic parity_1390;
  assign parity_1390 = ^{or_1387, or_1383, or_1379};
  // hls/stages/agreement.hpp:673
  logic or_1394;
  assign or_1394 = (parity_1274 & parity_1277) | ((^select_1252[2:0]) & (parity_1274 | parity_1277));
  logic or_1398;
  assign or_1398 = (parity_1292 & parity_1295) | ((^select_1286[8:6]) & (parity_1292 | parity_1295));
  logic or_1402;
  assign or_1402 = (parity_1304 & parity_1307) | ((^select_1271[5:3]) & (parity_1304 | parity_1307));
  // hls/stages/agreement.hpp:672
  logic parity_1405;
  assign parity_1405 = ^{or_1402, or_1398, or_1394};
  logic parity_1408;
  assign parity_1408 = ^{or_1402, or_1398, or_1394, or_1387, or_1383, or_1379, or_1372, or_1368, and_1364};
  logic xor_1409;
  assign xor_1409 = parity_1363 ^ parity_1408;
  // hls/stages/agreement.hpp:673
  logic and_1410;
  assign and_1410 = parity_1363 & parity_1408;
  logic or_1414;
  assign or_1414 = (parity_1345 & parity_1360) | ((^{or_1326, or_1322, or_1318}) & (parity_1345 | parity_1360));
  logic or_1418;
  assign or_1418 = (parity_1390 & parity_1405) | ((^{or_1372, or_1368, and_1364}) & (parity_1390 | parity_1405));
  logic or_1425;
  assign or_1425 = (or_1322 & or_1326) | (or_1318 & (or_1322 | or_1326));
  logic or_1429;
  assign or_1429 = (or_1338 & or_1342) | (or_1334 & (or_1338 | or_1342));
  logic or_1433;
  assign or_1433 = (or_1353 & or_1357) | (or_1349 & (or_1353 | or_1357));
  // hls/stages/agreement.hpp:672
  logic parity_1436;
  assign parity_1436 = ^{or_1433, or_1429, or_1425};
  // hls/stages/agreement.hpp:673
  logic or_1440;
  assign or_1440 = (or_1368 & or_1372) | (and_1364 & (or_1368 | or_1372));
  logic or_1444;
  assign or_1444 = (or_1383 & or_1387) | (or_1379 & (or_1383 | or_1387));
  logic or_1448;
  assign or_1448 = (or_1398 & or_1402) | (or_1394 & (or_1398 | or_1402));
  // hls/stages/agreement.hpp:672
  logic parity_1451;
  assign parity_1451 = ^{or_1448, or_1444, or_1440};
  logic parity_1454;
  assign parity_1454 = ^{or_1448, or_1444, or_1440, or_1433, or_1429, or_1425, or_1418, or_1414, and_1410};
  // hls/stages/agreement.hpp:673
  logic or_1458;
  assign or_1458 = (parity_1436 & parity_1451) | ((^{or_1418, or_1414, and_1410}) & (parity_1436 | parity_1451));
  logic or_1462;
  assign or_1462 = (or_1414 & or_1418) | (and_1410 & (or_1414 | or_1418));
  logic or_1466;
  assign or_1466 = (or_1429 & or_1433) | (or_1425 & (or_1429 | or_1433));
  logic or_1470;
  assign or_1470 = (or_1444 & or_1448) | (or_1440 & (or_1444 | or_1448));
  // hls/stages/agreement.hpp:672
  logic parity_1475;
  assign parity_1475 = ^{or_1470, or_1466, or_1462, or_1458};
  // hls/stages/agreement.hpp:673
  logic or_1479;
  assign or_1479 = (or_1466 & or_1470) | (or_1462 & (or_1466 | or_1470));
  logic and_1480;
  assign and_1480 = or_1458 & (^{or_1470, or_1466, or_1462});
  // hls/stages/agreement.hpp:672
  logic xor_1481;
  assign xor_1481 = or_1479 ^ and_1480;
  // hls/stages/agreement.hpp:675
  logic and_1482;
  assign and_1482 = or_1479 & and_1480;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1483;
  assign select_1483 = equal_383_s1_q ? {and_1482, xor_1481, parity_1475, parity_1454, xor_1409, xor_1314} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_381_s1_q ? 6'h0 : select_1483;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_1485;
  assign select_1485 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1486;
  assign difference_1486 = {1'b0, column_5} - {1'b0, select_1485};
  logic [7:0] sum_1488;
  assign sum_1488 = {difference_1486[6], difference_1486} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:657
  logic [11:0] not_1492;
  assign not_1492 = ~((less_388_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_518);
  logic [11:0] select_1494;
  assign select_1494 = and_515 ? ((right_codes_rdata_q[12] & not_389_s1_q) ? not_1492 : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1500;
  assign parity_1500 = ^select_1494[5:3];
  logic parity_1503;
  assign parity_1503 = ^select_1494[8:6];
  logic parity_1506;
  assign parity_1506 = ^select_1494[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1513;
  assign select_1513 = and_538 ? (and_1005 ? (~(select_1006 ^ select_541)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1516;
  assign parity_1516 = ^select_1513[8:6];
  logic parity_1519;
  assign parity_1519 = ^select_1513[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1526;
  assign select_1526 = and_555 ? (and_516 ? (~(select_517 ^ select_558)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1532;
  assign parity_1532 = ^select_1526[2:0];
  logic parity_1535;
  assign parity_1535 = ^select_1526[5:3];
  logic parity_1538;
  assign parity_1538 = ^select_1526[8:0];
  logic parity_1544;
  assign parity_1544 = ^select_1526[11:9];
  logic parity_1547;
  assign parity_1547 = ^select_1513[2:0];
  logic parity_1550;
  assign parity_1550 = ^{select_1526[11:9], select_1513[5:0]};
  logic parity_1553;
  assign parity_1553 = ^{select_1526, select_1513, select_1494[2:0]};
  logic xor_1554;
  assign xor_1554 = parity_1506 ^ parity_1553;
  // hls/stages/agreement.hpp:671
  logic or_1558;
  assign or_1558 = (select_1494[1:0] == 2'h3) | (select_1494[2] & (select_1494[0] | select_1494[1]));
  // hls/stages/agreement.hpp:673
  logic or_1562;
  assign or_1562 = (select_1513[7:6] == 2'h3) | (select_1513[8] & (select_1513[6] | select_1513[7]));
  logic or_1566;
  assign or_1566 = (select_1513[10:9] == 2'h3) | (select_1513[11] & (select_1513[9] | select_1513[10]));
  // hls/stages/agreement.hpp:671
  logic or_1574;
  assign or_1574 = (select_1526[7:6] == 2'h3) | (select_1526[8] & (~(select_1526[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_1578;
  assign or_1578 = (select_1526[1:0] == 2'h3) | (select_1526[2] & (select_1526[0] | select_1526[1]));
  logic or_1582;
  assign or_1582 = (select_1526[4:3] == 2'h3) | (select_1526[5] & (select_1526[3] | select_1526[4]));
  // hls/stages/agreement.hpp:672
  logic parity_1585;
  assign parity_1585 = ^{or_1582, or_1578, or_1574};
  // hls/stages/agreement.hpp:671
  logic or_1589;
  assign or_1589 = (select_1513[4:3] == 2'h3) | (select_1513[5] & (select_1513[3] | select_1513[4]));
  // hls/stages/agreement.hpp:673
  logic or_1593;
  assign or_1593 = (select_1526[10:9] == 2'h3) | (select_1526[11] & (select_1526[9] | select_1526[10]));
  logic or_1597;
  assign or_1597 = (select_1513[1:0] == 2'h3) | (select_1513[2] & (select_1513[0] | select_1513[1]));
  // hls/stages/agreement.hpp:672
  logic parity_1600;
  assign parity_1600 = ^{or_1597, or_1593, or_1589};
  logic parity_1603;
  assign parity_1603 = ^{or_1597, or_1593, or_1589, or_1582, or_1578, or_1574, or_1566, or_1562, or_1558};
  // hls/stages/agreement.hpp:673
  logic and_1604;
  assign and_1604 = parity_1506 & parity_1553;
  logic or_1608;
  assign or_1608 = (parity_1500 & parity_1503) | ((^select_1494[11:9]) & (parity_1500 | parity_1503));
  logic and_1611;
  assign and_1611 = (^{select_1513[11:6], select_1494[2:0]}) & (parity_1538 | parity_1550);
  logic or_1612;
  assign or_1612 = (parity_1538 & parity_1550) | and_1611;
  // hls/stages/agreement.hpp:671
  logic or_1619;
  assign or_1619 = (select_1494[10:9] == 2'h3) | (select_1494[11] & (select_1494[9] | select_1494[10]));
  // hls/stages/agreement.hpp:673
  logic or_1623;
  assign or_1623 = (select_1494[4:3] == 2'h3) | (select_1494[5] & (select_1494[3] | select_1494[4]));
  logic or_1627;
  assign or_1627 = (select_1494[7:6] == 2'h3) | (select_1494[8] & (select_1494[6] | select_1494[7]));
  // hls/stages/agreement.hpp:672
  logic parity_1630;
  assign parity_1630 = ^{or_1627, or_1623, or_1619};
  // hls/stages/agreement.hpp:673
  logic or_1634;
  assign or_1634 = (parity_1516 & parity_1519) | ((^select_1494[2:0]) & (parity_1516 | parity_1519));
  logic or_1638;
  assign or_1638 = (parity_1532 & parity_1535) | ((^select_1526[8:6]) & (parity_1532 | parity_1535));
  logic or_1642;
  assign or_1642 = (parity_1544 & parity_1547) | ((^select_1513[5:3]) & (parity_1544 | parity_1547));
  // hls/stages/agreement.hpp:672
  logic parity_1645;
  assign parity_1645 = ^{or_1642, or_1638, or_1634};
  logic parity_1648;
  assign parity_1648 = ^{or_1642, or_1638, or_1634, or_1627, or_1623, or_1619, or_1612, or_1608, and_1604};
  logic xor_1649;
  assign xor_1649 = parity_1603 ^ parity_1648;
  // hls/stages/agreement.hpp:673
  logic and_1650;
  assign and_1650 = parity_1603 & parity_1648;
  logic or_1654;
  assign or_1654 = (parity_1585 & parity_1600) | ((^{or_1566, or_1562, or_1558}) & (parity_1585 | parity_1600));
  logic or_1658;
  assign or_1658 = (parity_1630 & parity_1645) | ((^{or_1612, or_1608, and_1604}) & (parity_1630 | parity_1645));
  logic or_1665;
  assign or_1665 = (or_1562 & or_1566) | (or_1558 & (or_1562 | or_1566));
  logic or_1669;
  assign or_1669 = (or_1578 & or_1582) | (or_1574 & (or_1578 | or_1582));
  logic or_1673;
  assign or_1673 = (or_1593 & or_1597) | (or_1589 & (or_1593 | or_1597));
  // hls/stages/agreement.hpp:672
  logic parity_1676;
  assign parity_1676 = ^{or_1673, or_1669, or_1665};
  // hls/stages/agreement.hpp:673
  logic or_1680;
  assign or_1680 = (or_1608 & or_1612) | (and_1604 & (or_1608 | or_1612));
  logic or_1684;
  assign or_1684 = (or_1623 & or_1627) | (or_1619 & (or_1623 | or_1627));
  logic or_1688;
  assign or_1688 = (or_1638 & or_1642) | (or_1634 & (or_1638 | or_1642));
  // hls/stages/agreement.hpp:672
  logic parity_1691;
  assign parity_1691 = ^{or_1688, or_1684, or_1680};
  logic parity_1694;
  assign parity_1694 = ^{or_1688, or_1684, or_1680, or_1673, or_1669, or_1665, or_1658, or_1654, and_1650};
  // hls/stages/agreement.hpp:673
  logic or_1698;
  assign or_1698 = (parity_1676 & parity_1691) | ((^{or_1658, or_1654, and_1650}) & (parity_1676 | parity_1691));
  logic or_1702;
  assign or_1702 = (or_1654 & or_1658) | (and_1650 & (or_1654 | or_1658));
  logic or_1706;
  assign or_1706 = (or_1669 & or_1673) | (or_1665 & (or_1669 | or_1673));
  logic or_1710;
  assign or_1710 = (or_1684 & or_1688) | (or_1680 & (or_1684 | or_1688));
  // hls/stages/agreement.hpp:672
  logic parity_1715;
  assign parity_1715 = ^{or_1710, or_1706, or_1702, or_1698};
  // hls/stages/agreement.hpp:673
  logic or_1719;
  assign or_1719 = (or_1706 & or_1710) | (or_1702 & (or_1706 | or_1710));
  logic and_1720;
  assign and_1720 = or_1698 & (^{or_1710, or_1706, or_1702});
  // hls/stages/agreement.hpp:672
  logic xor_1721;
  assign xor_1721 = or_1719 ^ and_1720;
  // hls/stages/agreement.hpp:675
  logic and_1722;
  assign and_1722 = or_1719 & and_1720;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1723;
  assign select_1723 = equal_383_s1_q ? {and_1722, xor_1721, parity_1715, parity_1694, xor_1649, xor_1554} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_381_s1_q ? 6'h0 : select_1723;
  // hls/stages/agreement.hpp:777
  logic [5:0] select_1725;
  assign select_1725 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1726;
  assign difference_1726 = {1'b0, column_6} - {1'b0, select_1725};
  logic [7:0] sum_1728;
  assign sum_1728 = {difference_1726[6], difference_1726} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:942
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:943
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:944
  logic [6:0] select_1788;
  assign select_1788 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:947
  logic and_1808;
  assign and_1808 = (or_381_s1_q & (left_rdata_q[61] & not_389_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:228
  logic or_1830;
  assign or_1830 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:392
  logic [6:0] select_1841;
  assign select_1841 = so_s1_q ? x_s1_q[6:0] : (or_381_s1_q ? (less_388_s1_q ? 7'h0 : select_1788) : 7'h0);
  // hls/stages/agreement.hpp:970
  logic [5:0] sum_1884;
  assign sum_1884 = {1'b0, last_s1_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:392
  logic and_2060;
  assign and_2060 = ((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & (~({sum_1884, last_s1_q[1:0]} < x_s1_q));
  // hls/stages/agreement.hpp:432
  logic [5:0] or_2202;
  assign or_2202 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:436
  logic select_2421;
  assign select_2421 = equal_2327_s1_q ? (~({row_s1_q, 1'b0} < {sum_2418, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:495
  logic and_2632;
  assign and_2632 = and_360_s1_q & (equal_2327_s1_q & (row_s1_q[5:2] == 4'h0));

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:226; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_327_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_335;
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
  assign best_right_raddr = or_381_s1_q ? select_1788 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_502_s1_q;
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
  assign left_we = s1_en & and_392_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_484, left_rdata_q[59:45], and_483, left_rdata_q[43:29], and_482, left_rdata_q[27:13], and_481, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_392_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_493, right_codes_rdata_q[76:65], and_492, right_codes_rdata_q[63:52], and_491, right_codes_rdata_q[50:39], and_490, right_codes_rdata_q[37:26], and_489, right_codes_rdata_q[24:13], and_488, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_360_s1_q ? (equal_2327_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_360_s1_q ? select_2421 : lower_half_q;
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
      middle_sum_sum_sums_values_0_q <= sum_764;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1004;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1244;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1488;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1728;
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
  logic select_321_s2_q;
  logic [8:0] select_327_s2_q;
  logic and_334_s2_q;
  logic and_335_s2_q;
  logic equal_340_s2_q;
  logic whole_s2_q;
  logic [6:0] column_s2_q;
  logic and_358_s2_q;
  logic and_360_s2_q;
  logic equal_363_s2_q;
  logic so_s2_q;
  logic equal_380_s2_q;
  logic or_381_s2_q;
  logic less_388_s2_q;
  logic not_389_s2_q;
  logic equal_421_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_509_s2_q;
  logic and_1784_s2_q;
  logic [6:0] right_s2_q;
  logic select_1793_s2_q;
  logic equal_1802_s2_q;
  logic and_1809_s2_q;
  logic and_1812_s2_q;
  logic and_1816_s2_q;
  logic or_1830_s2_q;
  logic [6:0] select_1841_s2_q;
  logic less_1885_s2_q;
  logic equal_1925_s2_q;
  logic and_2062_s2_q;
  logic equal_2203_s2_q;
  logic equal_2327_s2_q;
  logic less_2561_s2_q;
  logic and_2633_s2_q;
  logic and_2635_s2_q;
  logic less_2742_s2_q;
  logic equal_2949_s2_q;
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
      select_321_s2_q <= select_321_s1_q;
      select_327_s2_q <= select_327_s1_q;
      and_334_s2_q <= and_334_s1_q;
      and_335_s2_q <= and_335;
      equal_340_s2_q <= equal_340_s1_q;
      whole_s2_q <= whole_s1_q;
      column_s2_q <= column_s1_q;
      and_358_s2_q <= and_358_s1_q;
      and_360_s2_q <= and_360_s1_q;
      equal_363_s2_q <= equal_363_s1_q;
      so_s2_q <= so_s1_q;
      equal_380_s2_q <= equal_380_s1_q;
      or_381_s2_q <= or_381_s1_q;
      less_388_s2_q <= less_388_s1_q;
      not_389_s2_q <= not_389_s1_q;
      equal_421_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_509_s2_q <= select_509_s1_q;
      and_1784_s2_q <= and_1784_s1_q;
      right_s2_q <= right_s1_q;
      select_1793_s2_q <= select_1793_s1_q;
      equal_1802_s2_q <= equal_1802_s1_q;
      and_1809_s2_q <= not_389_s1_q & and_1808;
      and_1812_s2_q <= (or_381_s1_q & (left_rdata_q[62] & not_389_s1_q)) & and_1808;
      and_1816_s2_q <= not_389_s1_q & (or_381_s1_q & (left_rdata_q[63] & not_389_s1_q));
      or_1830_s2_q <= or_1830;
      select_1841_s2_q <= select_1841;
      less_1885_s2_q <= {1'b0, sum_1884, last_s1_q[1]} < x_s1_q;
      equal_1925_s2_q <= x_s1_q == {1'b0, last_s1_q};
      and_2062_s2_q <= so_s1_q & (ends_cell_s1_q & and_2060);
      equal_2203_s2_q <= {column_s1_q[6], or_2202} == 7'h0;
      equal_2327_s2_q <= equal_2327_s1_q;
      less_2561_s2_q <= 5'h4 < row_q[5:1];
      and_2633_s2_q <= and_2328_s1_q & and_2632;
      and_2635_s2_q <= and_2328_s1_q & (~and_2632);
      less_2742_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2949_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [11:0] select_338;
  assign select_338 = select_321_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_342;
  assign sum_342 = select_338 + (equal_340_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_344;
  assign sum_344 = {4'h0, sample_pair_pixel_1_q} + (select_321_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_346;
  assign sum_346 = sum_344 + (equal_340_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:122
  logic and_350;
  assign and_350 = whole_s2_q & (averager_memory_rdata_q[24] | equal_340_s2_q);
  // hls/stages/agreement.hpp:394
  logic all_of_skin;
  assign all_of_skin = select_321_s2_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_354;
  assign and_354 = all_of_skin & (averager_memory_rdata_q[25] | equal_340_s2_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_334_s2_q ? sum_342[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_334_s2_q ? sum_346[11:3] : 9'h0;
  logic and_371;
  assign and_371 = and_334_s2_q & and_350;
  // hls/stages/census.hpp:126
  logic select_373;
  assign select_373 = equal_363_s2_q ? and_371 : (averager_mask_q & and_371);
  // hls/stages/agreement.hpp:255
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_373;
  // hls/stages/census.hpp:206
  logic and_375;
  assign and_375 = and_334_s2_q & and_354;
  // hls/stages/census.hpp:126
  logic select_377;
  assign select_377 = equal_363_s2_q ? and_375 : (averager_of_skin_q & and_375);
  // hls/stages/agreement.hpp:787
  logic not_511;
  assign not_511 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_512;
  assign less_512 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:224
  logic and_514;
  assign and_514 = not_511 & (~less_512);
  // hls/stages/agreement.hpp:750
  logic less_1245;
  assign less_1245 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1246;
  assign select_1246 = less_1245 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1247;
  assign less_1247 = middle_sum_sum_sums_values_0_q < select_1246;
  logic [7:0] select_1248;
  assign select_1248 = less_1247 ? select_1246 : middle_sum_sum_sums_values_0_q;
  logic less_1729;
  assign less_1729 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1730;
  assign select_1730 = less_1729 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1731;
  assign less_1731 = select_1248 < select_1730;
  // hls/stages/agreement.hpp:791
  logic [7:0] of_best;
  assign of_best = and_514 ? (less_1731 ? select_1730 : select_1248) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic or_1735;
  assign or_1735 = select_509_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:803
  logic [5:0] select_1736;
  assign select_1736 = or_1735 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:751
  logic or_1738;
  assign or_1738 = less_1245 | (~less_1247);
  logic [2:0] select_1739;
  assign select_1739 = less_1731 ? {less_1729, 2'h0} : {1'b0, or_1738, less_1247};
  // hls/stages/agreement.hpp:803
  logic [2:0] select_1740;
  assign select_1740 = or_1735 ? select_1739 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1741;
  assign select_1741 = or_1735 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:800
  logic equal_1742;
  assign equal_1742 = select_1739 == 3'h1;
  logic equal_1743;
  assign equal_1743 = select_1739 == 3'h2;
  logic not_1744;
  assign not_1744 = ~equal_1743;
  logic [1:0] select_1745;
  assign select_1745 = equal_1742 ? 2'h0 : {not_1744, equal_1743};
  logic [7:0] select_1746;
  assign select_1746 = select_1745[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1747;
  assign select_1747 = select_1745[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:803
  logic [7:0] select_1749;
  assign select_1749 = or_1735 ? (select_1745[1] ? select_1746 : select_1747) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:801
  logic [2:0] select_1750;
  assign select_1750 = equal_1742 ? 3'h2 : {not_1744, {2{equal_1743}}};
  logic [7:0] select_1751;
  assign select_1751 = select_1750[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1752;
  assign select_1752 = select_1750[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic [7:0] select_1754;
  assign select_1754 = select_1750[2] ? sums_3_sum_sums_values_0_q : (select_1750[1] ? select_1751 : select_1752);
  // hls/stages/agreement.hpp:803
  logic [7:0] select_1755;
  assign select_1755 = or_1735 ? select_1754 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1757;
  assign sum_1757 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1758;
  assign sum_1758 = {1'b0, before_v} + sum_1757;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1760;
  assign sum_1760 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1761;
  assign sum_1761 = {1'b0, before_v_2} + sum_1760;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1763;
  assign sum_1763 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1764;
  assign sum_1764 = {1'b0, before_v_3} + sum_1763;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1766;
  assign select_1766 = (sum_1761 < sum_1764) ? sum_1764 : sum_1761;
  logic [6:0] select_1768;
  assign select_1768 = (sum_1758 < select_1766) ? select_1766 : sum_1758;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1770;
  assign sum_1770 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1771;
  assign sum_1771 = {1'b0, before_v_4} + sum_1770;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1773;
  assign sum_1773 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1774;
  assign sum_1774 = {1'b0, before_v_5} + sum_1773;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1776;
  assign select_1776 = (sum_1771 < sum_1774) ? sum_1774 : sum_1771;
  // hls/stages/agreement.hpp:792
  logic [6:0] of_near;
  assign of_near = and_514 ? ((select_1768 < select_1776) ? select_1776 : select_1768) : 7'h0;
  // hls/stages/agreement.hpp:803
  logic or_1781;
  assign or_1781 = select_509_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:807
  logic [6:0] select_1782;
  assign select_1782 = or_1781 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1783;
  assign select_1783 = or_1781 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:812
  logic or_1795;
  assign or_1795 = select_1793_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:816
  logic [7:0] select_1796;
  assign select_1796 = or_1795 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1797;
  assign select_1797 = or_1795 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1799;
  assign or_1799 = select_1793_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:820
  logic [6:0] select_1800;
  assign select_1800 = or_1799 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1801;
  assign select_1801 = or_1799 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:970
  logic not_1803;
  assign not_1803 = ~equal_1802_s2_q;
  // hls/stages/agreement.hpp:228
  logic and_1813;
  assign and_1813 = not_389_s2_q & and_1812_s2_q;
  // hls/stages/agreement.hpp:950
  logic select_1819;
  assign select_1819 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:951
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:957
  logic [8:0] difference_1822;
  assign difference_1822 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:958
  logic [9:0] sum_1823;
  assign sum_1823 = {difference_1822[8], difference_1822} + 10'h1;
  // hls/stages/agreement.hpp:228
  logic and_1825;
  assign and_1825 = (and_1812_s2_q & select_1819) & ({{22{sum_1823[9]}}, sum_1823} < 32'h3);
  logic and_1826;
  assign and_1826 = not_389_s2_q & and_1825;
  logic and_1832;
  assign and_1832 = not_389_s2_q & (and_1825 & or_1830_s2_q);
  // hls/stages/agreement.hpp:137
  logic [8:0] select_1833;
  assign select_1833 = less_388_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_381_s2_q ? {select_1833, and_1832, and_1826, and_1816_s2_q, and_1813, and_1809_s2_q, not_389_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:392
  logic and_1835;
  assign and_1835 = ends_cell_s2_q & inside_v[0];
  logic and_1837;
  assign and_1837 = not_1803 & (so_s2_q & and_1835);
  // hls/stages/agreement.hpp:243
  logic right_2;
  assign right_2 = inside_v[0] & less_1885_s2_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:255
  logic select_2116;
  assign select_2116 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2118;
  assign select_2118 = sample_pair_whole_s2_q ? (and_358_s2_q ? select_373 : averager_mask_q) : averager_mask_q;
  logic select_2120;
  assign select_2120 = sample_pair_whole_s2_q ? (and_358_s2_q ? select_377 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/registration.hpp:76
  logic less_2508;
  assign less_2508 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:137
  logic [7:0] select_2510;
  assign select_2510 = or_381_s2_q ? (less_388_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2512;
  assign select_2512 = or_381_s2_q ? (less_388_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2514;
  assign select_2514 = or_381_s2_q ? (less_388_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2512} - {1'b0, select_2514};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2516;
  assign select_2516 = rise[8] ? select_2512 : select_2514;
  logic [8:0] difference_2517;
  assign difference_2517 = {1'b0, select_2510} - {1'b0, select_2516};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2517[8] ? 8'h0 : difference_2517[7:0];
  // hls/stages/registration.hpp:37
  logic not_2519;
  assign not_2519 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2508 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2519};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2521;
  assign xor_2521 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2521};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2527;
  assign select_2527 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2508 ? {taken, 1'b1} : {not_2519, select_2527, not_2519};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2529;
  assign sum_2529 = {left, 1'b1} + {taken_2, less_2508};
  // hls/stages/agreement.hpp:238
  logic [4:0] select_2531;
  assign select_2531 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;

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
  assign census_memory_re = s2_en & and_360_s2_q;
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
  assign shown_right_re = s2_en & and_1837;
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
  assign seen_columns_re = s2_en & and_1837;
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
  assign averager_memory_waddr = select_327_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_335_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_354, and_350, sum_346, sum_342};
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
  assign best_left_we = s2_en & and_1784_s2_q;
  logic [45:0] best_left_wdata;
  assign best_left_wdata = {select_1783, select_1782, select_1755, select_1749, select_1741, select_1740, select_1736};
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
  assign best_right_we = s2_en & and_1784_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_1801, select_1800, select_1797, select_1796};
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
      averager_running_of_skin_q <= select_2116;
      averager_mask_q <= select_2118;
      averager_of_skin_q <= select_2120;
      registration_displacement_over_q <= so_s2_q ? sum_2529[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2531;
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_338 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_344 : averager_running_1_q;
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
  logic and_358_s3_q;
  logic and_360_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_363_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic and_378_s3_q;
  logic so_s3_q;
  logic equal_421_s3_q;
  logic equal_1802_s3_q;
  logic not_1803_s3_q;
  logic [13:0] inside_v_s3_q;
  logic and_1837_s3_q;
  logic [6:0] select_1841_s3_q;
  logic and_1846_s3_q;
  logic right_2_s3_q;
  logic equal_1925_s3_q;
  logic textured_s3_q;
  logic and_2063_s3_q;
  logic equal_2203_s3_q;
  logic equal_2327_s3_q;
  logic and_2562_s3_q;
  logic less_2567_s3_q;
  logic and_2633_s3_q;
  logic and_2635_s3_q;
  logic less_2742_s3_q;
  logic equal_2949_s3_q;
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
      and_358_s3_q <= and_358_s2_q;
      and_360_s3_q <= and_360_s2_q;
      grey_s3_q <= grey;
      equal_363_s3_q <= equal_363_s2_q;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      and_378_s3_q <= sample_pair_whole_s2_q & select_377;
      so_s3_q <= so_s2_q;
      equal_421_s3_q <= equal_421_s2_q;
      equal_1802_s3_q <= equal_1802_s2_q;
      not_1803_s3_q <= not_1803;
      inside_v_s3_q <= {inside_v[14:3], inside_v[1:0]};
      and_1837_s3_q <= and_1837;
      select_1841_s3_q <= select_1841_s2_q;
      and_1846_s3_q <= not_1803 & (so_s2_q ? and_1835 : (equal_380_s2_q & inside_v[4]));
      right_2_s3_q <= right_2;
      equal_1925_s3_q <= equal_1925_s2_q;
      textured_s3_q <= textured;
      and_2063_s3_q <= not_1803 & and_2062_s2_q;
      equal_2203_s3_q <= equal_2203_s2_q;
      equal_2327_s3_q <= equal_2327_s2_q;
      and_2562_s3_q <= inside_v[4] & less_2561_s2_q;
      less_2567_s3_q <= select_2512 < select_2514;
      and_2633_s3_q <= and_2633_s2_q;
      and_2635_s3_q <= and_2635_s2_q;
      less_2742_s3_q <= less_2742_s2_q;
      equal_2949_s3_q <= equal_2949_s2_q;
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
  logic [16:0] rows_passed_q;
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
  assign total = {2'h0, grey_s3_q} + (equal_363_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:255
  logic [8:0] select_366;
  assign select_366 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_363_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:255
  logic [8:0] select_370;
  assign select_370 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:294
  logic less_394;
  assign less_394 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_395;
  assign less_395 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_396;
  assign less_396 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_397;
  assign less_397 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_398;
  assign less_398 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_399;
  assign less_399 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_400;
  assign less_400 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_401;
  assign less_401 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_402;
  assign less_402 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_403;
  assign less_403 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_404;
  assign less_404 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_405;
  assign less_405 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_406;
  assign less_406 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_407;
  assign less_407 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_408;
  assign less_408 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_409;
  assign less_409 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_410;
  assign less_410 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_411;
  assign less_411 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_412;
  assign less_412 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_413;
  assign less_413 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_414;
  assign less_414 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_415;
  assign less_415 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_416;
  assign less_416 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_417;
  assign less_417 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:431
  logic equal_418;
  assign equal_418 = column_s3_q == 7'h0;
  logic [3:0] select_422;
  assign select_422 = equal_421_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:432
  logic [4:0] select_423;
  assign select_423 = equal_418 ? {select_422, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_424;
  assign select_424 = equal_418 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_425;
  assign and_425 = select_423[4] & select_424[3];
  // hls/stages/census.hpp:286
  logic and_427;
  assign and_427 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_429;
  assign and_429 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_427);
  // hls/stages/agreement.hpp:432
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_429;
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
  logic [9:0] difference_452;
  assign difference_452 = {1'b0, select_366} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_453;
  assign xor_453 = difference_452[8:0] ^ {9{difference_452[9]}};
  logic [9:0] sum_454;
  assign sum_454 = {9'h0, difference_452[9]} + {1'b0, xor_453};
  logic [9:0] difference_455;
  assign difference_455 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_456;
  assign xor_456 = difference_455[8:0] ^ {9{difference_455[9]}};
  logic [9:0] sum_457;
  assign sum_457 = {9'h0, difference_455[9]} + {1'b0, xor_456};
  logic [9:0] difference_459;
  assign difference_459 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_460;
  assign xor_460 = difference_459[8:0] ^ {9{difference_459[9]}};
  logic [9:0] sum_461;
  assign sum_461 = {9'h0, difference_459[9]} + {1'b0, xor_460};
  logic [10:0] sum_462;
  assign sum_462 = ({1'b0, sum_454} + {1'b0, sum_457}) + {1'b0, sum_461};
  logic [9:0] difference_463;
  assign difference_463 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_464;
  assign xor_464 = difference_463[8:0] ^ {9{difference_463[9]}};
  logic [9:0] sum_465;
  assign sum_465 = {9'h0, difference_463[9]} + {1'b0, xor_464};
  logic [9:0] difference_467;
  assign difference_467 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_468;
  assign xor_468 = difference_467[8:0] ^ {9{difference_467[9]}};
  logic [9:0] sum_469;
  assign sum_469 = {9'h0, difference_467[9]} + {1'b0, xor_468};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_462} + {2'h0, sum_465}) + {2'h0, sum_469};
  // hls/stages/agreement.hpp:186
  logic not_1842;
  assign not_1842 = ~so_s3_q;
  // hls/stages/agreement.hpp:392
  logic and_1843;
  assign and_1843 = not_1842 & inside_v_s3_q[4];
  // hls/stages/agreement.hpp:1082
  logic equal_1847;
  assign equal_1847 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1122
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:146
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1083
  logic [1:0] select_1850;
  assign select_1850 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1095
  logic [3:0] select_1852;
  assign select_1852 = equal_1847 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1850});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1853;
  assign sum_1853 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_1854;
  assign select_1854 = equal_1802_s3_q ? select_1852 : {sum_1853, lower_half_s3_q, registration_of_right_q};
  // hls/stages/agreement.hpp:1120
  logic equal_1855;
  assign equal_1855 = x_s3_q[5:0] == 6'h3e;
  logic equal_1857;
  assign equal_1857 = x_s3_q[5:0] == 6'h3d;
  logic equal_1859;
  assign equal_1859 = x_s3_q[5:0] == 6'h3c;
  logic equal_1861;
  assign equal_1861 = x_s3_q[5:0] == 6'h3b;
  logic equal_1863;
  assign equal_1863 = x_s3_q[5:0] == 6'h36;
  logic equal_1865;
  assign equal_1865 = x_s3_q[5:0] == 6'h35;
  logic equal_1867;
  assign equal_1867 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1122
  logic and_1871;
  assign and_1871 = (~equal_1861) & ((~equal_1863) & ((~equal_1865) & (~equal_1867)));
  // hls/stages/agreement.hpp:1083
  logic less_1875;
  assign less_1875 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:147
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:159
  logic or_1879;
  assign or_1879 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1095
  logic select_1882;
  assign select_1882 = equal_1847 ? ((~equal_1855) & ((~equal_1857) & ((~equal_1859) & and_1871))) : (less_1875 & (~or_1879));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1890;
  assign sum_1890 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1892;
  assign and_1892 = half_ends & ({{3{sum_1890[4]}}, sum_1890} < 8'h3);
  // hls/stages/agreement.hpp:392
  logic and_1893;
  assign and_1893 = so_s3_q & and_1892;
  // hls/stages/registration.hpp:253
  logic not_1896;
  assign not_1896 = ~lower_half_s3_q;
  logic [3:0] select_1897;
  assign select_1897 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1896, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1896};
  // hls/stages/agreement.hpp:190
  logic [7:0] select_1910;
  assign select_1910 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1004
  logic or_1913;
  assign or_1913 = select_1910[7] | (~({select_1910[5], select_1910[3], select_1910[1]} == 3'h0));
  // hls/stages/agreement.hpp:1003
  logic or_1916;
  assign or_1916 = select_1910[7] | (~({select_1910[6], select_1910[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1002
  logic or_1919;
  assign or_1919 = select_1910[7] | (~(select_1910[6:4] == 3'h0));
  // hls/stages/agreement.hpp:392
  logic [5:0] select_1920;
  assign select_1920 = equal_1802_s3_q ? x_s3_q[5:0] : {region_row_q, or_1919, or_1916, or_1913};
  // hls/stages/agreement.hpp:1082
  logic not_1921;
  assign not_1921 = ~equal_1847;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1923;
  assign sum_1923 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1012
  logic or_1926;
  assign or_1926 = (~sum_1923[5]) | equal_1925_s3_q;
  // hls/stages/agreement.hpp:392
  logic and_1929;
  assign and_1929 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & or_1926));
  // hls/stages/agreement.hpp:243
  logic explained;
  assign explained = inside_v_s3_q[0] & inside_v_s3_q[3];
  logic and_1943;
  assign and_1943 = inside_v_s3_q[0] & ({inside_v_s3_q[4], inside_v_s3_q[2]} == 2'h3);
  logic and_1950;
  assign and_1950 = inside_v_s3_q[0] & inside_v_s3_q[2];
  // hls/stages/agreement.hpp:975
  logic select_1951;
  assign select_1951 = slot_s3_q[2] ? shown_shown_q : inside_v_s3_q[3];
  // hls/stages/agreement.hpp:243
  logic shown;
  assign shown = inside_v_s3_q[0] & (shown_right_rdata_q[0] | select_1951);
  // hls/stages/agreement.hpp:975
  logic select_1954;
  assign select_1954 = slot_s3_q[2] ? shown_nearer_q : inside_v_s3_q[4];
  // hls/stages/agreement.hpp:243
  logic near;
  assign near = inside_v_s3_q[0] & (select_1951 ? select_1954 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1207
  logic or_1957;
  assign or_1957 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1209
  logic [16:0] select_1959;
  assign select_1959 = marks_first_s3_q ? 17'h1 : (or_1957 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1208
  logic [8:0] select_1961;
  assign select_1961 = or_1957 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1216
  logic select_1963;
  assign select_1963 = cfg_compete_i ? (or_1957 & select_1959[16]) : (select_1961[8] & select_1959[9]);
  // hls/stages/agreement.hpp:411
  logic next_row;
  assign next_row = select_1963 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1223
  logic [6:0] select_1966;
  assign select_1966 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_1968;
  assign select_1968 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_1966});
  // hls/stages/agreement.hpp:1233
  logic equal_1969;
  assign equal_1969 = seen_x_q == 3'h7;
  logic [7:0] select_1971;
  assign select_1971 = select_1963 ? 8'h0 : (seen_column_q + {7'h0, equal_1969});
  // hls/stages/agreement.hpp:1240
  logic [12:0] index;
  assign index = select_1968 + {5'h0, select_1971};
  // hls/stages/agreement.hpp:1207
  logic select_1974;
  assign select_1974 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1193
  logic [7:0] sum_1975;
  assign sum_1975 = {1'b0, select_1974, 2'h0, select_1974, 1'b0, {2{select_1974}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1206
  logic not_1976;
  assign not_1976 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:411
  logic and_1978;
  assign and_1978 = not_1976 & (began_q | select_1963);
  // hls/stages/agreement.hpp:1234
  logic [2:0] select_1980;
  assign select_1980 = select_1963 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1239
  logic and_1982;
  assign and_1982 = and_1978 & (select_1980 == 3'h0);
  logic less_1983;
  assign less_1983 = select_1971 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1065
  logic [7:0] sum_1986;
  assign sum_1986 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1986[7]}}, sum_1986, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1193
  logic [7:0] sum_1988;
  assign sum_1988 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:988
  logic and_1989;
  assign and_1989 = seen_columns_rdata_q[14] & inside_v_s3_q[0];
  logic and_1990;
  assign and_1990 = seen_columns_rdata_q[10] & inside_v_s3_q[0];
  logic and_1991;
  assign and_1991 = seen_columns_rdata_q[5] & inside_v_s3_q[0];
  logic and_1992;
  assign and_1992 = seen_columns_rdata_q[0] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1041
  logic [1:0] sum_1994;
  assign sum_1994 = {1'b0, and_1991} + ({1'b0, textured_s3_q} + {1'b0, and_1992});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1989} + ({2'h0, and_1990} + {1'b0, sum_1994});
  // hls/stages/agreement.hpp:1048
  logic [2:0] select_1997;
  assign select_1997 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1998;
  assign difference_1998 = {1'b0, textured_2} - {1'b0, select_1997};
  // hls/stages/agreement.hpp:1046
  logic equal_1999;
  assign equal_1999 = x_s3_q == 8'h0;
  // hls/stages/agreement.hpp:1048
  logic [4:0] t;
  assign t = {difference_1998[3], difference_1998} + (equal_1999 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:988
  logic [7:0] select_2004;
  assign select_2004 = inside_v_s3_q[0] ? (sum_1923[5] ? select_1910 : {select_1910[6:0], 1'b0}) : select_1910;
  // hls/stages/agreement.hpp:1004
  logic or_2007;
  assign or_2007 = select_2004[7] | (~({select_2004[5], select_2004[3], select_2004[1]} == 3'h0));
  // hls/stages/agreement.hpp:988
  logic and_2024;
  assign and_2024 = seen_columns_rdata_q[16] & inside_v_s3_q[0];
  logic and_2025;
  assign and_2025 = seen_columns_rdata_q[12] & inside_v_s3_q[0];
  logic and_2026;
  assign and_2026 = seen_columns_rdata_q[8] & inside_v_s3_q[0];
  logic and_2027;
  assign and_2027 = seen_columns_rdata_q[3] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1043
  logic [1:0] sum_2029;
  assign sum_2029 = {1'b0, and_2026} + ({1'b0, shown} + {1'b0, and_2027});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2024} + ({2'h0, and_2025} + {1'b0, sum_2029});
  // hls/stages/agreement.hpp:1050
  logic [2:0] select_2032;
  assign select_2032 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2033;
  assign difference_2033 = {1'b0, shown_2} - {1'b0, select_2032};
  logic [4:0] around;
  assign around = {difference_2033[3], difference_2033} + (equal_1999 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1057
  logic [5:0] sum_2036;
  assign sum_2036 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:988
  logic and_2040;
  assign and_2040 = seen_columns_rdata_q[17] & inside_v_s3_q[0];
  logic and_2041;
  assign and_2041 = seen_columns_rdata_q[13] & inside_v_s3_q[0];
  logic and_2042;
  assign and_2042 = seen_columns_rdata_q[9] & inside_v_s3_q[0];
  logic and_2043;
  assign and_2043 = seen_columns_rdata_q[4] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1044
  logic [1:0] sum_2045;
  assign sum_2045 = {1'b0, and_2042} + ({1'b0, near} + {1'b0, and_2043});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2040} + ({2'h0, and_2041} + {1'b0, sum_2045});
  // hls/stages/agreement.hpp:1051
  logic [2:0] select_2048;
  assign select_2048 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2049;
  assign difference_2049 = {1'b0, near_2} - {1'b0, select_2048};
  logic [4:0] n;
  assign n = {difference_2049[3], difference_2049} + (equal_1999 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:255
  logic [10:0] select_2095;
  assign select_2095 = sample_pair_whole_s3_q ? (and_358_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2097;
  assign select_2097 = sample_pair_whole_s3_q ? (and_358_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:495
  logic [8:0] select_2121;
  assign select_2121 = and_360_s3_q ? select_366 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2122;
  assign select_2122 = and_360_s3_q ? select_370 : census_columns_values_0_cell_0_right_q;
  logic select_2123;
  assign select_2123 = and_360_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_2124;
  assign select_2124 = and_360_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2125;
  assign select_2125 = and_360_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2126;
  assign select_2126 = and_360_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2127;
  assign select_2127 = and_360_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2128;
  assign select_2128 = and_360_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2129;
  assign select_2129 = and_360_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2130;
  assign select_2130 = and_360_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2131;
  assign select_2131 = and_360_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2132;
  assign select_2132 = and_360_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2133;
  assign select_2133 = and_360_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2134;
  assign select_2134 = and_360_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2135;
  assign select_2135 = and_360_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2136;
  assign select_2136 = and_360_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2137;
  assign select_2137 = and_360_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2138;
  assign select_2138 = and_360_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2139;
  assign select_2139 = and_360_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2140;
  assign select_2140 = and_360_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2141;
  assign select_2141 = and_360_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2142;
  assign select_2142 = and_360_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2143;
  assign select_2143 = and_360_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2144;
  assign select_2144 = and_360_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2145;
  assign select_2145 = and_360_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2146;
  assign select_2146 = and_360_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2147;
  assign select_2147 = and_360_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2148;
  assign select_2148 = and_360_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2149;
  assign select_2149 = and_360_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2150;
  assign select_2150 = and_360_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2151;
  assign select_2151 = and_360_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2152;
  assign select_2152 = and_360_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2153;
  assign select_2153 = and_360_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2154;
  assign select_2154 = and_360_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2155;
  assign select_2155 = and_360_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2156;
  assign select_2156 = and_360_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2157;
  assign select_2157 = and_360_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2158;
  assign select_2158 = and_360_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2159;
  assign select_2159 = and_360_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2160;
  assign select_2160 = and_360_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2161;
  assign select_2161 = and_360_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2162;
  assign select_2162 = and_360_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2163;
  assign select_2163 = and_360_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2164;
  assign select_2164 = and_360_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2165;
  assign select_2165 = and_360_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2166;
  assign select_2166 = and_360_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2167;
  assign select_2167 = and_360_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2168;
  assign select_2168 = and_360_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2169;
  assign select_2169 = and_360_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2170;
  assign select_2170 = and_360_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2171;
  assign select_2171 = and_360_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2172;
  assign select_2172 = and_360_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2173;
  assign select_2173 = and_360_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2174;
  assign select_2174 = and_360_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2175;
  assign select_2175 = and_360_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2176;
  assign select_2176 = and_360_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2178;
  assign difference_2178 = {1'b0, select_370} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2179;
  assign xor_2179 = difference_2178[8:0] ^ {9{difference_2178[9]}};
  logic [9:0] sum_2180;
  assign sum_2180 = {9'h0, difference_2178[9]} + {1'b0, xor_2179};
  logic [9:0] difference_2181;
  assign difference_2181 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2182;
  assign xor_2182 = difference_2181[8:0] ^ {9{difference_2181[9]}};
  logic [9:0] sum_2183;
  assign sum_2183 = {9'h0, difference_2181[9]} + {1'b0, xor_2182};
  logic [9:0] difference_2185;
  assign difference_2185 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2186;
  assign xor_2186 = difference_2185[8:0] ^ {9{difference_2185[9]}};
  logic [9:0] sum_2187;
  assign sum_2187 = {9'h0, difference_2185[9]} + {1'b0, xor_2186};
  logic [10:0] sum_2188;
  assign sum_2188 = ({1'b0, sum_2180} + {1'b0, sum_2183}) + {1'b0, sum_2187};
  logic [9:0] difference_2189;
  assign difference_2189 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2190;
  assign xor_2190 = difference_2189[8:0] ^ {9{difference_2189[9]}};
  logic [9:0] sum_2191;
  assign sum_2191 = {9'h0, difference_2189[9]} + {1'b0, xor_2190};
  logic [9:0] difference_2193;
  assign difference_2193 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2194;
  assign xor_2194 = difference_2193[8:0] ^ {9{difference_2193[9]}};
  logic [9:0] sum_2195;
  assign sum_2195 = {9'h0, difference_2193[9]} + {1'b0, xor_2194};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2224;
  assign difference_2224 = {1'b0, select_366} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2224[9]} + (difference_2224[8:0] ^ {9{difference_2224[9]}});
  logic [9:0] difference_2236;
  assign difference_2236 = {1'b0, select_370} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2236[9]} + (difference_2236[8:0] ^ {9{difference_2236[9]}});
  // hls/stages/agreement.hpp:495
  logic and_2424;
  assign and_2424 = and_360_s3_q & (equal_421_s3_q & equal_2327_s3_q);
  // hls/stages/agreement.hpp:392
  logic and_2427;
  assign and_2427 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & inside_v_s3_q[1]));
  // hls/stages/agreement.hpp:988
  logic and_2448;
  assign and_2448 = seen_columns_rdata_q[15] & inside_v_s3_q[0];
  logic and_2449;
  assign and_2449 = seen_columns_rdata_q[11] & inside_v_s3_q[0];
  logic and_2450;
  assign and_2450 = seen_columns_rdata_q[7] & inside_v_s3_q[0];
  logic and_2451;
  assign and_2451 = seen_columns_rdata_q[2] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1042
  logic [1:0] sum_2453;
  assign sum_2453 = {1'b0, and_2450} + ({1'b0, explained} + {1'b0, and_2451});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2448} + ({2'h0, and_2449} + {1'b0, sum_2453});
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2456;
  assign select_2456 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2457;
  assign difference_2457 = {1'b0, explained_2} - {1'b0, select_2456};
  logic [4:0] e;
  assign e = {difference_2457[3], difference_2457} + (equal_1999 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1056
  logic [5:0] sum_2460;
  assign sum_2460 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:392
  logic and_2488;
  assign and_2488 = ends_cell_s3_q & (inside_v_s3_q[0] & (inside_v_s3_q[2:1] == 2'h3));
  // hls/stages/registration.hpp:83
  logic equal_2532;
  assign equal_2532 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:213
  logic [16:0] select_2534;
  assign select_2534 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2534[16:7])) ? 8'h7f : select_2534[7:0];
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2532 ? registration_slope_here_q : change;
  // hls/stages/registration.hpp:208
  logic [7:0] select_2538;
  assign select_2538 = inside_v_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2539;
  assign select_2539 = inside_v_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2540;
  assign difference_2540 = {{2{select_2538[7]}}, select_2538[7:1]} - {select_2539[7], select_2539};
  // hls/stages/registration.hpp:206
  logic [6:0] select_2541;
  assign select_2541 = inside_v_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2542;
  assign select_2542 = inside_v_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2543;
  assign sum_2543 = {{2{select_2541[6]}}, select_2541} + {select_2542[7], select_2542};
  // hls/stages/registration.hpp:207
  logic [7:0] select_2544;
  assign select_2544 = inside_v_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2545;
  assign select_2545 = inside_v_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2546;
  assign sum_2546 = {{2{select_2544[7]}}, select_2544[7:1]} + {select_2545[7], select_2545};
  // hls/stages/registration.hpp:209
  logic [10:0] sum_2547;
  assign sum_2547 = {{3{sum_2543[8]}}, sum_2543[8:1]} + {sum_2546[8], sum_2546, select_2544[0]};
  logic [9:0] sum_2548;
  assign sum_2548 = {difference_2540, select_2538[0]} + {sum_2547[10], sum_2547[10:2]};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2549;
  assign sum_2549 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_2548[9]}}, sum_2548[9:2]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2552;
  assign select_2552 = ($signed(sum_2549[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2549[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] select_2554;
  assign select_2554 = equal_2532 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2549[12:7])) ? 8'h7f : select_2552);
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2556;
  assign select_2556 = equal_1802_s3_q ? registration_slope_here_q : (so_s3_q ? select_2554 : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2557;
  assign equal_2557 = slot_s3_q == 3'h4;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2566;
  assign sum_2566 = inside_v_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2568;
  assign difference_2568 = {sum_2566, inside_v_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2569;
  assign select_2569 = less_2567_s3_q ? difference_2568 : {sum_2566, inside_v_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2570;
  assign select_2570 = ((inside_v_s3_q[13:11] == 3'h0) | (inside_v_s3_q[13:11] == 3'h4)) ? {sum_2566, inside_v_s3_q[11], 5'h0} : select_2569;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2570[7]}}, select_2570} - {sum_2548[9], sum_2548, sum_2547[1]};
  // hls/stages/registration.hpp:213
  logic [11:0] select_2573;
  assign select_2573 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2573[11:7])) ? 12'h7f : select_2573;
  // hls/stages/agreement.hpp:392
  logic select_2617;
  assign select_2617 = so_s3_q ? (equal_2557 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_2620;
  assign select_2620 = so_s3_q ? (equal_2532 ? inside_v_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:264
  logic [3:0] select_2625;
  assign select_2625 = (sum_1853 == 2'h2) ? (registration_fresh_q & (~select_1897)) : registration_fresh_q;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_2627;
  assign select_2627 = so_s3_q ? (and_1892 ? select_2625 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:237
  logic [3:0] select_2629;
  assign select_2629 = and_2424 ? 4'hf : (equal_1802_s3_q ? registration_fresh_q : select_2627);
  // hls/stages/registration.hpp:128
  logic [15:0] select_2636;
  assign select_2636 = and_2635_s3_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:131
  logic [23:0] select_2638;
  assign select_2638 = and_2633_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2636[15]}}, select_2636});
  // hls/stages/registration.hpp:129
  logic [15:0] select_2639;
  assign select_2639 = and_2635_s3_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2639[15]}}, select_2639};
  // hls/stages/registration.hpp:131
  logic [27:0] select_2641;
  assign select_2641 = and_2633_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:137
  logic and_2642;
  assign and_2642 = ends_cell_s3_q & so_s3_q;
  // hls/stages/registration.hpp:124
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_2642 ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:1083
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1850;
  // hls/stages/registration.hpp:253
  logic not_2650;
  assign not_2650 = ~quarter_2[1];
  logic [3:0] select_2651;
  assign select_2651 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2650, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2650};
  // hls/stages/agreement.hpp:392
  logic select_2739;
  assign select_2739 = equal_1802_s3_q ? shown_shown_q : (so_s3_q ? select_1951 : shown_shown_q);
  logic select_2741;
  assign select_2741 = equal_1802_s3_q ? shown_nearer_q : (so_s3_q ? select_1954 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2743;
  assign sum_2743 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:436
  logic [2:0] select_2745;
  assign select_2745 = less_2742_s3_q ? (sum_2743[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2747;
  assign select_2747 = equal_2327_s3_q ? (equal_421_s3_q ? 3'h0 : select_2745) : region_row_q;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2752;
  assign select_2752 = equal_1802_s3_q ? select_1910 : (so_s3_q ? (ends_cell_s3_q ? select_2004 : select_1910) : 8'h1);
  // hls/stages/agreement.hpp:190
  logic [8:0] select_2754;
  assign select_2754 = so_s3_q ? (and_2642 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2756;
  assign sum_2756 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2757;
  assign select_2757 = sum_1923[5] ? {1'b1, sum_1923[4:0], region_across_rest_q[2:0]} : sum_2756;
  // hls/stages/agreement.hpp:436
  logic [8:0] select_2759;
  assign select_2759 = equal_2327_s3_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_2762;
  assign select_2762 = equal_2327_s3_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  logic [8:0] select_2766;
  assign select_2766 = equal_421_s3_q ? {{2{difference_2764[6]}}, difference_2764} : (less_2742_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:495
  logic [8:0] select_2768;
  assign select_2768 = and_360_s3_q ? (equal_2327_s3_q ? select_2766 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:436
  logic [6:0] select_2770;
  assign select_2770 = equal_421_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2772;
  assign select_2772 = and_360_s3_q ? (equal_2327_s3_q ? select_2770 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2773;
  assign sum_2773 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2774;
  assign select_2774 = sum_2743[7] ? {1'b1, sum_2743[6:0], region_down_rest_q[0]} : sum_2773;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2743[7];
  // hls/stages/agreement.hpp:436
  logic select_2778;
  assign select_2778 = equal_2327_s3_q ? (equal_421_s3_q | (less_2742_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:190
  logic or_2783;
  assign or_2783 = segment_starts_q | not_1842;
  // hls/stages/agreement.hpp:988
  logic select_2786;
  assign select_2786 = inside_v_s3_q[0] ? (sum_1923[5] ? (equal_1925_s3_q & or_1926) : or_1926) : or_2783;
  // hls/stages/agreement.hpp:392
  logic select_2789;
  assign select_2789 = equal_1802_s3_q ? or_2783 : (so_s3_q ? (ends_cell_s3_q ? select_2786 : or_2783) : or_2783);
  // hls/stages/agreement.hpp:1095
  logic equal_2814;
  assign equal_2814 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:392
  logic [2:0] select_2865;
  assign select_2865 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_2867;
  assign select_2867 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2869;
  assign select_2869 = equal_1802_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_2867 : box_textured_columns_values_1_q);
  logic [2:0] select_2870;
  assign select_2870 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2872;
  assign select_2872 = equal_1802_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_2870 : box_textured_columns_values_2_q);
  logic [2:0] select_2873;
  assign select_2873 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2875;
  assign select_2875 = equal_1802_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_2873 : box_textured_columns_values_3_q);
  logic [2:0] select_2876;
  assign select_2876 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2878;
  assign select_2878 = equal_1802_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_2876 : box_textured_columns_values_4_q);
  logic [4:0] select_2880;
  assign select_2880 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_2883;
  assign select_2883 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_2885;
  assign select_2885 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2887;
  assign select_2887 = equal_1802_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_2885 : box_explained_columns_values_1_q);
  logic [2:0] select_2888;
  assign select_2888 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2890;
  assign select_2890 = equal_1802_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_2888 : box_explained_columns_values_2_q);
  logic [2:0] select_2891;
  assign select_2891 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2893;
  assign select_2893 = equal_1802_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_2891 : box_explained_columns_values_3_q);
  logic [2:0] select_2894;
  assign select_2894 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2896;
  assign select_2896 = equal_1802_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_2894 : box_explained_columns_values_4_q);
  logic [4:0] select_2898;
  assign select_2898 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2899;
  assign select_2899 = equal_1802_s3_q ? box_explained_sum_sums_values_0_q : select_2898;
  logic [2:0] select_2901;
  assign select_2901 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2903;
  assign select_2903 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2905;
  assign select_2905 = equal_1802_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_2903 : box_shown_columns_values_1_q);
  logic [2:0] select_2906;
  assign select_2906 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2908;
  assign select_2908 = equal_1802_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_2906 : box_shown_columns_values_2_q);
  logic [2:0] select_2909;
  assign select_2909 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2911;
  assign select_2911 = equal_1802_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_2909 : box_shown_columns_values_3_q);
  logic [2:0] select_2912;
  assign select_2912 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2914;
  assign select_2914 = equal_1802_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_2912 : box_shown_columns_values_4_q);
  logic [4:0] select_2916;
  assign select_2916 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_2919;
  assign select_2919 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2921;
  assign select_2921 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2923;
  assign select_2923 = equal_1802_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_2921 : box_nearer_columns_values_1_q);
  logic [2:0] select_2924;
  assign select_2924 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2926;
  assign select_2926 = equal_1802_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_2924 : box_nearer_columns_values_2_q);
  logic [2:0] select_2927;
  assign select_2927 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2929;
  assign select_2929 = equal_1802_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_2927 : box_nearer_columns_values_3_q);
  logic [2:0] select_2930;
  assign select_2930 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2932;
  assign select_2932 = equal_1802_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_2930 : box_nearer_columns_values_4_q);
  logic [4:0] select_2934;
  assign select_2934 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_2937;
  assign select_2937 = so_s3_q ? (ends_cell_s3_q ? and_1991 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2940;
  assign select_2940 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & inside_v_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_2942;
  assign select_2942 = equal_1802_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_2940 : centres_values_0_of_skin_q);
  logic select_2943;
  assign select_2943 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2945;
  assign select_2945 = equal_1802_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_2943 : centres_values_1_textured_q);
  logic select_2946;
  assign select_2946 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2948;
  assign select_2948 = equal_1802_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_2946 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:436
  logic [12:0] select_2952;
  assign select_2952 = equal_2327_s3_q ? (equal_2949_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2955;
  assign select_2955 = and_360_s3_q ? (equal_2327_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1232
  logic [2:0] select_2966;
  assign select_2966 = select_1963 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:411
  logic [7:0] select_2972;
  assign select_2972 = marks_first_s3_q ? (less_2968 ? {sum_2969, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1240
  logic and_2978;
  assign and_2978 = and_2063_s3_q & ({sum_1988, index_2[5:0]} == {sum_1975, index[5:0]});
  // hls/stages/registration.hpp:253
  logic not_3030;
  assign not_3030 = ~quarter[1];
  logic [3:0] select_3031;
  assign select_3031 = quarter[0] ? {quarter[1], 1'b0, not_3030, 1'b0} : {1'b0, quarter[1], 1'b0, not_3030};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:271; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1854;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & (equal_1802_s3_q ? (x_s3_q[6] & select_1882) : and_1893);
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
  assign regions_raddr = select_1920;
  logic regions_re;
  assign regions_re = s3_en & (equal_1802_s3_q ? (x_s3_q[6] & not_1921) : and_1929);
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
  assign map_raddr = {sum_1975, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_1982 & less_1983);
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
  assign census_memory_we = s3_en & and_360_s3_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_378_s3_q, whole_2_s3_q, select_370, select_366};
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
  assign shown_right_waddr = select_1841_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1846_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1843, not_1842};
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
  assign seen_columns_we = s3_en & and_1837_s3_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1950, textured_s3_q};
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
      rows_passed_q <= 17'h0;
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
      census_filled_q <= and_360_s3_q ? {select_424[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_360_s3_q ? select_423 : rows_passed_above_q;
      registration_slope_here_q <= select_2556;
      registration_of_right_q <= equal_1802_s3_q ? registration_of_right_q : select_2617;
      registration_was_inside_q <= equal_1802_s3_q ? registration_was_inside_q : select_2620;
      registration_fresh_q <= select_2629;
      registration_slope_row_q <= select_2638;
      registration_slope_change_q <= select_2641;
      registration_slope_q <= so_s3_q ? column_7 : {registration_slope_row_q, 4'h0};
      shown_shown_q <= select_2739;
      shown_nearer_q <= select_2741;
      region_row_q <= and_360_s3_q ? select_2747 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_2752;
      region_across_rest_q <= select_2754;
      region_across_back_q <= so_s3_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2757;
      columns_begin_rest_q <= and_360_s3_q ? select_2759 : columns_begin_rest_q;
      columns_begin_back_q <= and_360_s3_q ? select_2762 : columns_begin_back_q;
      region_down_rest_q <= select_2768;
      region_down_back_q <= select_2772;
      region_down_next_q <= select_2774;
      region_fresh_q <= and_360_s3_q ? select_2778 : region_fresh_q;
      segment_starts_q <= select_2789;
      centres_values_0_textured_q <= equal_1802_s3_q ? centres_values_0_textured_q : select_2937;
      centres_values_0_of_skin_q <= select_2942;
      centres_values_1_textured_q <= select_2945;
      centres_values_1_of_skin_q <= select_2948;
      map_row_q <= and_360_s3_q ? select_2952 : map_row_q;
      map_width_q <= select_2955;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1974;
      done_q <= not_1976 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1802_s3_q & equal_2814;
      rows_passed_q <= select_1959;
      columns_passed_q <= {select_1961[7:0], or_1957};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_1978;
      seen_x_q <= select_1980;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_2966;
      seen_column_q <= select_1971;
      seen_rows_left_q <= select_2972;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_1968;
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
      averager_total_0_q <= select_2095;
      averager_total_1_q <= select_2097;
      census_columns_values_0_cell_0_left_q <= select_2121;
      census_columns_values_0_cell_0_right_q <= select_2122;
      census_columns_values_0_cell_0_mask_q <= select_2123;
      census_columns_values_0_cell_1_left_q <= select_2124;
      census_columns_values_0_cell_1_right_q <= select_2125;
      census_columns_values_0_cell_1_mask_q <= select_2126;
      census_columns_values_0_cell_2_left_q <= select_2127;
      census_columns_values_0_cell_2_right_q <= select_2128;
      census_columns_values_0_cell_2_mask_q <= select_2129;
      census_columns_values_0_cell_2_of_skin_q <= select_2130;
      census_columns_values_0_cell_3_left_q <= select_2131;
      census_columns_values_0_cell_3_right_q <= select_2132;
      census_columns_values_0_cell_3_mask_q <= select_2133;
      census_columns_values_0_cell_4_left_q <= select_2134;
      census_columns_values_0_cell_4_right_q <= select_2135;
      census_columns_values_0_cell_4_mask_q <= select_2136;
      census_columns_values_1_cell_0_left_q <= select_2137;
      census_columns_values_1_cell_0_right_q <= select_2138;
      census_columns_values_1_cell_0_mask_q <= select_2139;
      census_columns_values_1_cell_1_left_q <= select_2140;
      census_columns_values_1_cell_1_right_q <= select_2141;
      census_columns_values_1_cell_1_mask_q <= select_2142;
      census_columns_values_1_cell_2_left_q <= select_2143;
      census_columns_values_1_cell_2_right_q <= select_2144;
      census_columns_values_1_cell_2_mask_q <= select_2145;
      census_columns_values_1_cell_2_of_skin_q <= select_2146;
      census_columns_values_1_cell_3_left_q <= select_2147;
      census_columns_values_1_cell_3_right_q <= select_2148;
      census_columns_values_1_cell_3_mask_q <= select_2149;
      census_columns_values_1_cell_4_left_q <= select_2150;
      census_columns_values_1_cell_4_right_q <= select_2151;
      census_columns_values_1_cell_4_mask_q <= select_2152;
      census_columns_values_2_cell_0_left_q <= select_2153;
      census_columns_values_2_cell_0_right_q <= select_2154;
      census_columns_values_2_cell_0_mask_q <= select_2155;
      census_columns_values_2_cell_1_left_q <= select_2156;
      census_columns_values_2_cell_1_right_q <= select_2157;
      census_columns_values_2_cell_1_mask_q <= select_2158;
      census_columns_values_2_cell_2_left_q <= select_2159;
      census_columns_values_2_cell_2_right_q <= select_2160;
      census_columns_values_2_cell_2_mask_q <= select_2161;
      census_columns_values_2_cell_3_left_q <= select_2162;
      census_columns_values_2_cell_3_right_q <= select_2163;
      census_columns_values_2_cell_3_mask_q <= select_2164;
      census_columns_values_2_cell_4_left_q <= select_2165;
      census_columns_values_2_cell_4_right_q <= select_2166;
      census_columns_values_2_cell_4_mask_q <= select_2167;
      census_columns_values_3_cell_0_mask_q <= select_2168;
      census_columns_values_3_cell_1_left_q <= select_2169;
      census_columns_values_3_cell_1_right_q <= select_2170;
      census_columns_values_3_cell_1_mask_q <= select_2171;
      census_columns_values_3_cell_2_mask_q <= select_2172;
      census_columns_values_3_cell_3_left_q <= select_2173;
      census_columns_values_3_cell_3_right_q <= select_2174;
      census_columns_values_3_cell_3_mask_q <= select_2175;
      census_columns_values_3_cell_4_mask_q <= select_2176;
      sharpness_last_mean_0_q <= and_360_s3_q ? select_366 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_360_s3_q ? select_370 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1802_s3_q ? box_textured_columns_values_0_q : select_2865;
      box_textured_columns_values_1_q <= select_2869;
      box_textured_columns_values_2_q <= select_2872;
      box_textured_columns_values_3_q <= select_2875;
      box_textured_columns_values_4_q <= select_2878;
      box_textured_sum_sums_values_0_q <= equal_1802_s3_q ? box_textured_sum_sums_values_0_q : select_2880;
      box_explained_columns_values_0_q <= equal_1802_s3_q ? box_explained_columns_values_0_q : select_2883;
      box_explained_columns_values_1_q <= select_2887;
      box_explained_columns_values_2_q <= select_2890;
      box_explained_columns_values_3_q <= select_2893;
      box_explained_columns_values_4_q <= select_2896;
      box_explained_sum_sums_values_0_q <= select_2899;
      box_shown_columns_values_0_q <= equal_1802_s3_q ? box_shown_columns_values_0_q : select_2901;
      box_shown_columns_values_1_q <= select_2905;
      box_shown_columns_values_2_q <= select_2908;
      box_shown_columns_values_3_q <= select_2911;
      box_shown_columns_values_4_q <= select_2914;
      box_shown_sum_sums_values_0_q <= equal_1802_s3_q ? box_shown_sum_sums_values_0_q : select_2916;
      box_nearer_columns_values_0_q <= equal_1802_s3_q ? box_nearer_columns_values_0_q : select_2919;
      box_nearer_columns_values_1_q <= select_2923;
      box_nearer_columns_values_2_q <= select_2926;
      box_nearer_columns_values_3_q <= select_2929;
      box_nearer_columns_values_4_q <= select_2932;
      box_nearer_sum_sums_values_0_q <= equal_1802_s3_q ? box_nearer_sum_sums_values_0_q : select_2934;
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
  logic and_358_s4_q;
  logic and_360_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_363_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_417_s4_q;
  logic and_425_s4_q;
  logic and_450_s4_q;
  logic and_451_s4_q;
  logic [11:0] texture_s4_q;
  logic equal_1802_s4_q;
  logic not_1803_s4_q;
  logic equal_1847_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1853_s4_q;
  logic equal_1855_s4_q;
  logic equal_1857_s4_q;
  logic equal_1859_s4_q;
  logic equal_1861_s4_q;
  logic equal_1863_s4_q;
  logic equal_1865_s4_q;
  logic equal_1867_s4_q;
  logic less_1875_s4_q;
  logic or_1879_s4_q;
  logic equal_1899_s4_q;
  logic and_1909_s4_q;
  logic or_1913_s4_q;
  logic or_1916_s4_q;
  logic or_1919_s4_q;
  logic not_1921_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1943_s4_q;
  logic and_1948_s4_q;
  logic and_1982_s4_q;
  logic less_1983_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_1988_s4_q;
  logic equal_2002_s4_q;
  logic or_2007_s4_q;
  logic or_2010_s4_q;
  logic or_2013_s4_q;
  logic not_2038_s4_q;
  logic less_2052_s4_q;
  logic and_2063_s4_q;
  logic [11:0] sum_2196_s4_q;
  logic equal_2203_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2424_s4_q;
  logic and_2428_s4_q;
  logic not_2462_s4_q;
  logic and_2490_s4_q;
  logic equal_2532_s4_q;
  logic and_2560_s4_q;
  logic and_2562_s4_q;
  logic [11:0] residual_s4_q;
  logic equal_2653_s4_q;
  logic equal_2814_s4_q;
  logic and_2978_s4_q;
  logic and_2993_s4_q;
  logic equal_3033_s4_q;
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
      and_358_s4_q <= and_358_s3_q;
      and_360_s4_q <= and_360_s3_q;
      grey_s4_q <= grey_s3_q;
      equal_363_s4_q <= equal_363_s3_q;
      grey_2_s4_q <= grey_2_s3_q;
      whole_2_s4_q <= whole_2_s3_q;
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
      less_417_s4_q <= less_417;
      and_425_s4_q <= and_425;
      and_450_s4_q <= whole_22 & and_425;
      and_451_s4_q <= census_columns_values_1_cell_2_mask_q & and_425;
      texture_s4_q <= texture;
      equal_1802_s4_q <= equal_1802_s3_q;
      not_1803_s4_q <= not_1803_s3_q;
      equal_1847_s4_q <= equal_1847;
      all_s4_q <= all;
      sum_1853_s4_q <= sum_1853;
      equal_1855_s4_q <= equal_1855;
      equal_1857_s4_q <= equal_1857;
      equal_1859_s4_q <= equal_1859;
      equal_1861_s4_q <= equal_1861;
      equal_1863_s4_q <= equal_1863;
      equal_1865_s4_q <= equal_1865;
      equal_1867_s4_q <= equal_1867;
      less_1875_s4_q <= less_1875;
      or_1879_s4_q <= or_1879;
      equal_1899_s4_q <= (registration_fresh_q & select_1897) == 4'h0;
      and_1909_s4_q <= not_1803_s3_q & and_1893;
      or_1913_s4_q <= or_1913;
      or_1916_s4_q <= or_1916;
      or_1919_s4_q <= or_1919;
      not_1921_s4_q <= not_1921;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1943_s4_q <= and_1943;
      and_1948_s4_q <= not_1803_s3_q & and_1929;
      and_1982_s4_q <= and_1982;
      less_1983_s4_q <= less_1983;
      index_2_s4_q <= index_2[5:0];
      sum_1988_s4_q <= sum_1988;
      equal_2002_s4_q <= t[4:1] == 4'h0;
      or_2007_s4_q <= or_2007;
      or_2010_s4_q <= select_2004[7] | (~({select_2004[6], select_2004[3:2]} == 3'h0));
      or_2013_s4_q <= select_2004[7] | (~(select_2004[6:4] == 3'h0));
      not_2038_s4_q <= ~({sum_2036, around[0]} < {2'h0, t});
      less_2052_s4_q <= {1'b0, around[4:1]} < n;
      and_2063_s4_q <= and_2063_s3_q;
      sum_2196_s4_q <= ({1'b0, sum_2188} + {2'h0, sum_2191}) + {2'h0, sum_2195};
      equal_2203_s4_q <= equal_2203_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2424_s4_q <= and_2424;
      and_2428_s4_q <= not_1803_s3_q & and_2427;
      not_2462_s4_q <= ~({sum_2460, e[0]} < {2'h0, t});
      and_2490_s4_q <= not_1803_s3_q & (so_s3_q & and_2488);
      equal_2532_s4_q <= equal_2532;
      and_2560_s4_q <= not_1803_s3_q & (so_s3_q & (half_ends & equal_2557));
      and_2562_s4_q <= and_2562_s3_q;
      residual_s4_q <= residual;
      equal_2653_s4_q <= (registration_fresh_q & select_2651) == 4'h0;
      equal_2814_s4_q <= equal_2814;
      and_2978_s4_q <= and_2978;
      and_2993_s4_q <= equal_1802_s3_q & (equal_2814 & (cfg_prove_i & (~proven_q)));
      equal_3033_s4_q <= (registration_fresh_q & select_3031) == 4'h0;
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
  logic sharpness_before_last_mask_q;
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
  logic [12:0] sum_471;
  assign sum_471 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_473;
  assign sum_473 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_471});
  // hls/stages/census.hpp:303
  logic less_474;
  assign less_474 = 9'h4 < sum_473[13:5];
  logic and_475;
  assign and_475 = and_425_s4_q & less_474;
  // hls/stages/registration.hpp:260
  logic equal_1901;
  assign equal_1901 = sum_1853_s4_q == 2'h0;
  // hls/stages/registration.hpp:258
  logic [6:0] down;
  assign down = sum_1853_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:260
  logic [13:0] select_1903;
  assign select_1903 = equal_1901 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1904;
  assign sum_1904 = (equal_1899_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1903[13]}}, select_1903};
  // hls/stages/registration.hpp:259
  logic [6:0] up;
  assign up = sum_1853_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:261
  logic [6:0] select_1907;
  assign select_1907 = equal_1901 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1908;
  assign sum_1908 = (equal_1899_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1907[6]}}, select_1907};
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1933;
  assign select_1933 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:882
  logic [6:0] sum_1934;
  assign sum_1934 = {6'h0, textured_s4_q} + select_1933;
  // hls/stages/agreement.hpp:1015
  logic [9:0] sum_1936;
  assign sum_1936 = {3'h0, sum_1934} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1938;
  assign select_1938 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:882
  logic [6:0] sum_1939;
  assign sum_1939 = {6'h0, explained_s4_q} + select_1938;
  // hls/stages/agreement.hpp:1016
  logic [9:0] sum_1941;
  assign sum_1941 = {3'h0, sum_1939} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1944;
  assign select_1944 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:883
  logic [6:0] sum_1945;
  assign sum_1945 = {6'h0, and_1943_s4_q} + select_1944;
  // hls/stages/agreement.hpp:1017
  logic [9:0] sum_1947;
  assign sum_1947 = {3'h0, sum_1945} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1055
  logic not_2014;
  assign not_2014 = ~region_row_s4_q[2];
  logic [2:0] select_2015;
  assign select_2015 = region_row_s4_q[1] ? {1'b0, not_2014, 1'b0} : {region_row_s4_q[2], 1'b0, not_2014};
  logic [5:0] select_2016;
  assign select_2016 = region_row_s4_q[0] ? {select_2015[2], 1'b0, select_2015[1], 1'b0, select_2015[0], 1'b0} : {1'b0, select_2015[2], 1'b0, select_2015[1], 1'b0, select_2015[0]};
  logic [11:0] select_2017;
  assign select_2017 = or_2013_s4_q ? {select_2016[5], 1'b0, select_2016[4], 1'b0, select_2016[3], 1'b0, select_2016[2], 1'b0, select_2016[1], 1'b0, select_2016[0], 1'b0} : {1'b0, select_2016[5], 1'b0, select_2016[4], 1'b0, select_2016[3], 1'b0, select_2016[2], 1'b0, select_2016[1], 1'b0, select_2016[0]};
  logic [23:0] select_2018;
  assign select_2018 = or_2010_s4_q ? {select_2017[11], 1'b0, select_2017[10], 1'b0, select_2017[9], 1'b0, select_2017[8], 1'b0, select_2017[7], 1'b0, select_2017[6], 1'b0, select_2017[5], 1'b0, select_2017[4], 1'b0, select_2017[3], 1'b0, select_2017[2], 1'b0, select_2017[1], 1'b0, select_2017[0], 1'b0} : {1'b0, select_2017[11], 1'b0, select_2017[10], 1'b0, select_2017[9], 1'b0, select_2017[8], 1'b0, select_2017[7], 1'b0, select_2017[6], 1'b0, select_2017[5], 1'b0, select_2017[4], 1'b0, select_2017[3], 1'b0, select_2017[2], 1'b0, select_2017[1], 1'b0, select_2017[0]};
  logic [47:0] select_2019;
  assign select_2019 = or_2007_s4_q ? {select_2018[23], 1'b0, select_2018[22], 1'b0, select_2018[21], 1'b0, select_2018[20], 1'b0, select_2018[19], 1'b0, select_2018[18], 1'b0, select_2018[17], 1'b0, select_2018[16], 1'b0, select_2018[15], 1'b0, select_2018[14], 1'b0, select_2018[13], 1'b0, select_2018[12], 1'b0, select_2018[11], 1'b0, select_2018[10], 1'b0, select_2018[9], 1'b0, select_2018[8], 1'b0, select_2018[7], 1'b0, select_2018[6], 1'b0, select_2018[5], 1'b0, select_2018[4], 1'b0, select_2018[3], 1'b0, select_2018[2], 1'b0, select_2018[1], 1'b0, select_2018[0], 1'b0} : {1'b0, select_2018[23], 1'b0, select_2018[22], 1'b0, select_2018[21], 1'b0, select_2018[20], 1'b0, select_2018[19], 1'b0, select_2018[18], 1'b0, select_2018[17], 1'b0, select_2018[16], 1'b0, select_2018[15], 1'b0, select_2018[14], 1'b0, select_2018[13], 1'b0, select_2018[12], 1'b0, select_2018[11], 1'b0, select_2018[10], 1'b0, select_2018[9], 1'b0, select_2018[8], 1'b0, select_2018[7], 1'b0, select_2018[6], 1'b0, select_2018[5], 1'b0, select_2018[4], 1'b0, select_2018[3], 1'b0, select_2018[2], 1'b0, select_2018[1], 1'b0, select_2018[0]};
  // hls/stages/agreement.hpp:988
  logic and_2023;
  assign and_2023 = good_known_q & (~((good_q & select_2019) == 48'h0));
  // hls/stages/agreement.hpp:1057
  logic is_seen;
  assign is_seen = equal_2002_s4_q ? and_2023 : not_2038_s4_q;
  // hls/stages/agreement.hpp:1066
  logic and_2053;
  assign and_2053 = is_seen & less_2052_s4_q;
  // hls/stages/agreement.hpp:255
  logic [8:0] select_2087;
  assign select_2087 = sample_pair_whole_s4_q ? (and_358_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2089;
  assign select_2089 = sample_pair_whole_s4_q ? (and_358_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2091;
  assign select_2091 = sample_pair_whole_s4_q ? (and_358_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2093;
  assign select_2093 = sample_pair_whole_s4_q ? (and_358_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2098;
  assign sum_2098 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2099;
  assign difference_2099 = {1'b0, sum_2098[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2100;
  assign xor_2100 = {difference_2099[8:0], sum_2098[0]} ^ {10{difference_2099[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2099[9]} + {1'b0, xor_2100};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_363_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_2105;
  assign select_2105 = sample_pair_whole_s4_q ? (and_358_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2106;
  assign sum_2106 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2107;
  assign difference_2107 = {1'b0, sum_2106[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2108;
  assign xor_2108 = {difference_2107[8:0], sum_2106[0]} ^ {10{difference_2107[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2107[9]} + {1'b0, xor_2108};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_363_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_2113;
  assign select_2113 = sample_pair_whole_s4_q ? (and_358_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:495
  logic [11:0] select_2198;
  assign select_2198 = and_360_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2199;
  assign select_2199 = and_360_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2200;
  assign select_2200 = and_360_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2201;
  assign select_2201 = and_360_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2204;
  assign sum_2204 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2196_s4_q};
  logic [13:0] sum_2206;
  assign sum_2206 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2204});
  // hls/stages/census.hpp:305
  logic and_2208;
  assign and_2208 = and_450_s4_q & (9'h4 < sum_2206[13:5]);
  // hls/stages/census.hpp:306
  logic and_2209;
  assign and_2209 = and_450_s4_q & less_474;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2210;
  assign sum_2210 = census_left_misses_q + {{17{and_2209}}, and_2208, 1'b0, and_2208};
  // hls/stages/agreement.hpp:495
  logic [19:0] select_2212;
  assign select_2212 = and_360_s4_q ? (equal_2203_s4_q ? 20'h0 : sum_2210) : census_left_misses_q;
  // hls/stages/agreement.hpp:255
  logic [27:0] select_2217;
  assign select_2217 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:495
  logic select_2220;
  assign select_2220 = and_360_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2223;
  assign and_2223 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:433
  logic and_2229;
  assign and_2229 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2230;
  assign and_2230 = and_2223 & and_2229;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2217[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2232;
  assign select_2232 = and_2230 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2234;
  assign select_2234 = equal_2203_s4_q ? {11'h0, select_2232} : (sharpness_sums_detail_0_q + {11'h0, select_2232});
  // hls/stages/agreement.hpp:433
  logic and_2241;
  assign and_2241 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2242;
  assign and_2242 = and_2223 & and_2241;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2217[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2244;
  assign select_2244 = and_2242 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2246;
  assign select_2246 = equal_2203_s4_q ? {11'h0, select_2244} : (sharpness_sums_detail_1_q + {11'h0, select_2244});
  logic [8:0] select_2249;
  assign select_2249 = and_2230 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2250;
  assign sum_2250 = (equal_2203_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2249};
  logic [8:0] select_2253;
  assign select_2253 = and_2242 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2254;
  assign sum_2254 = (equal_2203_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2253};
  // hls/stages/agreement.hpp:196
  logic equal_2256;
  assign equal_2256 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2257;
  assign less_2257 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2258;
  assign less_2258 = x_s4_q[4:0] < 5'h3;
  logic not_2259;
  assign not_2259 = ~x_s4_q[1];
  logic [2:0] select_2260;
  assign select_2260 = x_s4_q[0] ? {1'b0, not_2259, 1'b0} : {x_s4_q[1], 1'b0, not_2259};
  logic [5:0] select_2261;
  assign select_2261 = slot_s4_q[2] ? {select_2260[2], 1'b0, select_2260[1], 1'b0, select_2260[0], 1'b0} : {1'b0, select_2260[2], 1'b0, select_2260[1], 1'b0, select_2260[0]};
  logic [11:0] select_2262;
  assign select_2262 = slot_s4_q[1] ? {select_2261[5], 1'b0, select_2261[4], 1'b0, select_2261[3], 1'b0, select_2261[2], 1'b0, select_2261[1], 1'b0, select_2261[0], 1'b0} : {1'b0, select_2261[5], 1'b0, select_2261[4], 1'b0, select_2261[3], 1'b0, select_2261[2], 1'b0, select_2261[1], 1'b0, select_2261[0]};
  logic [23:0] select_2263;
  assign select_2263 = slot_s4_q[0] ? {select_2262[11], 1'b0, select_2262[10], 1'b0, select_2262[9], 1'b0, select_2262[8], 1'b0, select_2262[7], 1'b0, select_2262[6], 1'b0, select_2262[5], 1'b0, select_2262[4], 1'b0, select_2262[3], 1'b0, select_2262[2], 1'b0, select_2262[1], 1'b0, select_2262[0], 1'b0} : {1'b0, select_2262[11], 1'b0, select_2262[10], 1'b0, select_2262[9], 1'b0, select_2262[8], 1'b0, select_2262[7], 1'b0, select_2262[6], 1'b0, select_2262[5], 1'b0, select_2262[4], 1'b0, select_2262[3], 1'b0, select_2262[2], 1'b0, select_2262[1], 1'b0, select_2262[0]};
  // hls/stages/census.hpp:372
  logic and_2267;
  assign and_2267 = less_2258 & (~((sharpness_sums_contrast_1_q & select_2263) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2269;
  assign select_2269 = (less_2257 & and_2267) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2269};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_2272;
  assign select_2272 = equal_2256 ? (less_2257 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2277;
  assign and_2277 = less_2258 & (~((sharpness_sums_contrast_0_q & select_2263) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2279;
  assign select_2279 = (less_2257 & and_2277) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2279};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_2282;
  assign select_2282 = equal_2256 ? (less_2257 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2284;
  assign select_2284 = equal_2256 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2286;
  assign select_2286 = equal_2256 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2288;
  assign select_2288 = equal_2256 ? {sharpness_comparing_contrast_0_q[0], and_2277} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2290;
  assign select_2290 = equal_2256 ? {sharpness_comparing_contrast_1_q[0], and_2267} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:200
  logic select_2295;
  assign select_2295 = drew_q ? (equal_2256 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:200
  logic select_2299;
  assign select_2299 = drew_q ? (equal_2256 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2300;
  assign equal_2300 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2301;
  assign xor_2301 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2304;
  assign select_2304 = (equal_2300 | xor_2301) ? (five_times[0] & xor_2301) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:200
  logic select_2306;
  assign select_2306 = drew_q ? (equal_2256 ? select_2304 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2307;
  assign xor_2307 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2310;
  assign select_2310 = (equal_2300 | xor_2307) ? (five_times_2[0] & xor_2307) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:200
  logic select_2312;
  assign select_2312 = drew_q ? (equal_2256 ? select_2310 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2313;
  assign xor_2313 = sharpness_comparing_contrast_0_q[1] ^ and_2267;
  logic select_2316;
  assign select_2316 = (equal_2300 | xor_2313) ? (and_2267 & xor_2313) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:200
  logic select_2318;
  assign select_2318 = drew_q ? (equal_2256 ? select_2316 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2319;
  assign xor_2319 = sharpness_comparing_contrast_1_q[1] ^ and_2277;
  logic select_2322;
  assign select_2322 = (equal_2300 | xor_2319) ? (and_2277 & xor_2319) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:200
  logic select_2324;
  assign select_2324 = drew_q ? (equal_2256 ? select_2322 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2430;
  assign select_2430 = and_2424_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2428_s4_q});
  // hls/stages/agreement.hpp:392
  logic and_2433;
  assign and_2433 = not_1803_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2438;
  assign and_2438 = not_1803_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2443;
  assign and_2443 = not_1803_s4_q & (drew_q & (ends_cell_s4_q & and_1943_s4_q));
  // hls/stages/agreement.hpp:1059
  logic not_2447;
  assign not_2447 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1060
  logic not_2464;
  assign not_2464 = ~(equal_2002_s4_q ? and_2023 : not_2462_s4_q);
  // hls/stages/agreement.hpp:392
  logic and_2467;
  assign and_2467 = ends_cell_s4_q & (not_2447 & (centres_values_1_textured_s4_q & not_2464));
  logic and_2469;
  assign and_2469 = not_1803_s4_q & (drew_q & and_2467);
  // hls/stages/agreement.hpp:1085
  logic less_2472;
  assign less_2472 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2473;
  assign select_2473 = less_2472 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2476;
  assign select_2476 = less_2472 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1086
  logic [10:0] sum_2477;
  assign sum_2477 = {1'b0, select_2476} + {3'h0, select_2476[9:2]};
  logic and_2479;
  assign and_2479 = (~(select_2473[9:4] == 6'h0)) & ({sum_2477, select_2476[1:0]} < {3'h0, select_2473});
  // hls/stages/agreement.hpp:1095
  logic [9:0] select_2482;
  assign select_2482 = x_s4_q[6] ? (equal_1847_s4_q ? 10'h0 : (and_2479 ? select_2473 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:392
  logic [9:0] select_2483;
  assign select_2483 = equal_1802_s4_q ? select_2482 : 10'h0;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2485;
  assign select_2485 = and_2424_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2483});
  logic [13:0] select_2492;
  assign select_2492 = and_2424_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2490_s4_q});
  // hls/stages/agreement.hpp:1064
  logic and_2494;
  assign and_2494 = not_2447 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:392
  logic and_2497;
  assign and_2497 = not_1803_s4_q & (drew_q & (ends_cell_s4_q & and_2494));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2499;
  assign select_2499 = and_2424_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2497});
  // hls/stages/agreement.hpp:1064
  logic and_2501;
  assign and_2501 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2464);
  // hls/stages/agreement.hpp:392
  logic and_2505;
  assign and_2505 = not_1803_s4_q & (drew_q & (ends_cell_s4_q & (not_2447 & and_2501)));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2507;
  assign select_2507 = and_2424_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2505});
  // hls/stages/registration.hpp:106
  logic [7:0] select_2577;
  assign select_2577 = equal_2532_s4_q ? (and_2562_s4_q ? residual_s4_q[7:0] : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2579;
  assign select_2579 = equal_1802_s4_q ? 8'h0 : (drew_q ? select_2577 : 8'h0);
  // hls/stages/registration.hpp:133
  logic [13:0] select_2581;
  assign select_2581 = and_2560_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2579[7]}}, select_2579});
  // hls/stages/agreement.hpp:392
  logic and_2584;
  assign and_2584 = not_1803_s4_q & (drew_q & (and_2562_s4_q & equal_2532_s4_q));
  // hls/stages/registration.hpp:133
  logic [5:0] select_2586;
  assign select_2586 = and_2560_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2584});
  // hls/stages/registration.hpp:106
  logic and_2588;
  assign and_2588 = and_2562_s4_q & ($signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2590;
  assign select_2590 = drew_q ? (equal_2532_s4_q ? {and_2588, and_2562_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2591;
  assign select_2591 = equal_1802_s4_q ? 2'h0 : select_2590;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2592;
  assign sum_2592 = registration_half_votes_down_q + {{5{select_2591[1]}}, select_2591};
  // hls/stages/registration.hpp:200
  logic [12:0] difference_2594;
  assign difference_2594 = 13'h0 - {residual_s4_q[11], residual_s4_q};
  // hls/stages/registration.hpp:106
  logic and_2596;
  assign and_2596 = and_2562_s4_q & ($signed(difference_2594) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2598;
  assign select_2598 = drew_q ? (equal_2532_s4_q ? {and_2596, and_2562_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2599;
  assign select_2599 = equal_1802_s4_q ? 2'h0 : select_2598;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2600;
  assign sum_2600 = registration_half_votes_up_q + {{5{select_2599[1]}}, select_2599};
  // hls/stages/registration.hpp:200
  logic less_2602;
  assign less_2602 = $signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2603;
  assign and_2603 = and_2562_s4_q & less_2602;
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2605;
  assign select_2605 = drew_q ? (equal_2532_s4_q ? {and_2603, and_2562_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2606;
  assign select_2606 = equal_1802_s4_q ? 2'h0 : select_2605;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2607;
  assign sum_2607 = registration_half_half_votes_down_q + {{5{select_2606[1]}}, select_2606};
  // hls/stages/registration.hpp:200
  logic less_2609;
  assign less_2609 = $signed(difference_2594) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2610;
  assign and_2610 = and_2562_s4_q & less_2609;
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2612;
  assign select_2612 = drew_q ? (equal_2532_s4_q ? {and_2610, and_2562_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2613;
  assign select_2613 = equal_1802_s4_q ? 2'h0 : select_2612;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2614;
  assign sum_2614 = registration_half_half_votes_up_q + {{5{select_2613[1]}}, select_2613};
  // hls/stages/agreement.hpp:392
  logic and_2648;
  assign and_2648 = equal_1802_s4_q & (x_s4_q[6] & (not_1921_s4_q & less_1875_s4_q));
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2655;
  assign select_2655 = or_1879_s4_q ? 12'h0 : (equal_2653_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2658;
  assign select_2658 = x_s4_q[6] ? (equal_1847_s4_q ? 12'h0 : (less_1875_s4_q ? select_2655 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2659;
  assign select_2659 = equal_1802_s4_q ? select_2658 : 12'h0;
  // hls/stages/registration.hpp:152
  logic and_2660;
  assign and_2660 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1095
  logic and_2663;
  assign and_2663 = not_1921_s4_q & (less_1875_s4_q & ({and_2660, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:392
  logic and_2665;
  assign and_2665 = equal_1802_s4_q & (x_s4_q[6] & and_2663);
  // hls/stages/registration.hpp:247
  logic [13:0] sum_2667;
  assign sum_2667 = {{2{select_2659[11]}}, select_2659} + (and_2665 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2670;
  assign select_2670 = or_1879_s4_q ? 12'h0 : (equal_2653_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2673;
  assign select_2673 = x_s4_q[6] ? (equal_1847_s4_q ? 12'h0 : (less_1875_s4_q ? select_2670 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2674;
  assign select_2674 = equal_1802_s4_q ? select_2673 : 12'h0;
  // hls/stages/registration.hpp:248
  logic [13:0] sum_2676;
  assign sum_2676 = {{2{select_2674[11]}}, select_2674} + (and_2665 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:149
  logic not_2678;
  assign not_2678 = ~all_s4_q;
  // hls/stages/agreement.hpp:1095
  logic and_2681;
  assign and_2681 = not_1921_s4_q & (less_1875_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2678, 1'b0}));
  // hls/stages/agreement.hpp:392
  logic and_2687;
  assign and_2687 = equal_1802_s4_q & (x_s4_q[6] & (not_1921_s4_q & (less_1875_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:241
  logic not_2688;
  assign not_2688 = ~and_2687;
  logic less_2689;
  assign less_2689 = $signed({9'h1, {2{not_2688}}, and_2687}) < $signed(registration_up_q[13:2]);
  logic select_2690;
  assign select_2690 = (equal_1802_s4_q & (x_s4_q[6] & and_2681)) ? less_2689 : registration_enough_q;
  // hls/stages/agreement.hpp:1095
  logic and_2694;
  assign and_2694 = x_s4_q[6] & (not_1921_s4_q & (less_1875_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:392
  logic and_2695;
  assign and_2695 = equal_1802_s4_q & and_2694;
  // hls/stages/registration.hpp:237
  logic less_2696;
  assign less_2696 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2698;
  assign less_2698 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1095
  logic and_2703;
  assign and_2703 = x_s4_q[6] & (not_1921_s4_q & (less_1875_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:392
  logic and_2704;
  assign and_2704 = equal_1802_s4_q & and_2703;
  // hls/stages/agreement.hpp:1095
  logic and_2711;
  assign and_2711 = x_s4_q[6] & (not_1921_s4_q & (less_1875_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:156
  logic equal_2714;
  assign equal_2714 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1095
  logic and_2717;
  assign and_2717 = not_1921_s4_q & (less_1875_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2714));
  // hls/stages/registration.hpp:239
  logic and_2721;
  assign and_2721 = (equal_1802_s4_q & (x_s4_q[6] & and_2717)) & (less_2698 | less_2696);
  // hls/stages/agreement.hpp:1095
  logic and_2726;
  assign and_2726 = not_1921_s4_q & (less_1875_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2714)));
  // hls/stages/registration.hpp:239
  logic and_2729;
  assign and_2729 = registration_votes_up_q & registration_other_down_q;
  logic select_2731;
  assign select_2731 = registration_votes_down_q ? (registration_other_up_q | and_2729) : and_2729;
  // hls/stages/registration.hpp:137
  logic and_2733;
  assign and_2733 = (equal_1802_s4_q & (x_s4_q[6] & and_2726)) & (registration_other_enough_q & select_2731);
  // hls/stages/registration.hpp:240
  logic or_2736;
  assign or_2736 = registration_moved_q | (registration_enough_q & (and_2721 | and_2733));
  // hls/stages/agreement.hpp:1132
  logic or_2794;
  assign or_2794 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1154
  logic equal_2796;
  assign equal_2796 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1160
  logic equal_2797;
  assign equal_2797 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1163
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1164
  logic select_2803;
  assign select_2803 = (equal_2796 & equal_2797) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1088
  logic [10:0] sum_2806;
  assign sum_2806 = {1'b0, select_2476} + {2'h0, select_2476[9:1]};
  logic select_2809;
  assign select_2809 = (select_2473[9:3] == 7'h0) ? ((~or_2794) & (~select_2803)) : (~({sum_2806, select_2476[0]} < {2'h0, select_2473}));
  // hls/stages/agreement.hpp:1095
  logic [47:0] select_2811;
  assign select_2811 = x_s4_q[6] ? (equal_1847_s4_q ? good_q : {select_2809, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:392
  logic select_2816;
  assign select_2816 = equal_1802_s4_q ? ((x_s4_q[6] & good_known_q) | equal_2814_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1154
  logic equal_2817;
  assign equal_2817 = x_s4_q[6:3] == 4'ha;
  logic equal_2819;
  assign equal_2819 = x_s4_q[6:3] == 4'h9;
  logic equal_2820;
  assign equal_2820 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2822;
  assign select_2822 = equal_2819 ? counts_skin_unproven_q : (equal_2820 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_2817 ? counts_nearer_q : select_2822;
  // hls/stages/agreement.hpp:1159
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1167
  logic select_2825;
  assign select_2825 = (equal_2817 & equal_2797) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1096
  logic not_2826;
  assign not_2826 = ~hidden_for_q[7];
  logic [7:0] select_2828;
  assign select_2828 = select_2825 ? (hidden_for_q + {7'h0, not_2826}) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2830;
  assign select_2830 = equal_1802_s4_q ? (equal_2814_s4_q ? select_2828 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2831;
  assign select_2831 = equal_2797 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1079
  logic [7:0] select_2833;
  assign select_2833 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2835;
  assign select_2835 = equal_2820 ? cfg_unproven_skin_limit_i : (equal_2796 ? cfg_unproven_limit_i : select_2833);
  logic [7:0] limit;
  assign limit = equal_2817 ? cfg_regions_limit_i : (equal_2819 ? cfg_hidden_limit_i : select_2835);
  // hls/stages/agreement.hpp:1167
  logic not_2838;
  assign not_2838 = ~x_s4_q[2];
  logic [3:0] select_2839;
  assign select_2839 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_2838, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_2838};
  logic [7:0] select_2840;
  assign select_2840 = x_s4_q[0] ? {select_2839[3], 1'b0, select_2839[2], 1'b0, select_2839[1], 1'b0, select_2839[0], 1'b0} : {1'b0, select_2839[3], 1'b0, select_2839[2], 1'b0, select_2839[1], 1'b0, select_2839[0]};
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2844;
  assign select_2844 = equal_2819 ? counts_skin_supervised_q : (equal_2820 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2817 ? counts_textured_q : select_2844;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2846;
  assign select_2846 = ((limit & select_2840) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2831} + {1'b0, select_2846};
  // hls/stages/agreement.hpp:392
  logic select_2851;
  assign select_2851 = equal_1802_s4_q ? (equal_2797 ? sum_3[0] : (product_rest_q | sum_3[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1165
  logic and_2856;
  assign and_2856 = too_much_q & (~(equal_2820 & equal_2797));
  // hls/stages/agreement.hpp:1166
  logic select_2861;
  assign select_2861 = (over[14] & equal_2797) ? (and_2856 | ((equal_2820 | equal_2819) | (x_s4_q[6:3] == 4'hf))) : and_2856;
  // hls/stages/agreement.hpp:1240
  logic [1:0] select_2979;
  assign select_2979 = and_2978_s4_q ? {and_2053, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1241
  logic and_2980;
  assign and_2980 = proven_q & less_2968;
  // hls/stages/agreement.hpp:413
  logic select_2983;
  assign select_2983 = and_1982_s4_q ? (less_1983_s4_q ? (select_2979[0] & and_2980) : seen_q) : seen_q;
  logic select_2986;
  assign select_2986 = and_1982_s4_q ? (less_1983_s4_q ? (select_2979[1] & and_2980) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1176
  logic not_2998;
  assign not_2998 = ~(or_2794 | not_2987);
  // hls/stages/agreement.hpp:392
  logic and_3002;
  assign and_3002 = equal_1802_s4_q & (equal_2814_s4_q & (not_2998 & (select_2803 | select_2861)));
  logic and_3005;
  assign and_3005 = equal_1802_s4_q & (equal_2814_s4_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:1098
  logic or_3008;
  assign or_3008 = select_2306 | (select_2318 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:392
  logic and_3015;
  assign and_3015 = equal_1802_s4_q & (equal_2814_s4_q & (not_2998 & (select_2312 | select_2324)));
  // hls/stages/agreement.hpp:1098
  logic and_3020;
  assign and_3020 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_2828 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:392
  logic and_3027;
  assign and_3027 = equal_1802_s4_q & (x_s4_q[6] & (not_1921_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1093
  logic [31:0] select_3035;
  assign select_3035 = equal_1867_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3033_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3036;
  assign select_3036 = equal_1865_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3035;
  logic [31:0] select_3037;
  assign select_3037 = equal_1863_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3036;
  logic [31:0] select_3038;
  assign select_3038 = equal_1861_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3037;
  logic [31:0] select_3039;
  assign select_3039 = equal_1859_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3038;
  logic [31:0] select_3040;
  assign select_3040 = equal_1857_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_3039;
  logic [31:0] select_3041;
  assign select_3041 = equal_1855_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_3040;
  // hls/stages/agreement.hpp:1091
  logic [9:0] select_3042;
  assign select_3042 = less_2472 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_3043;
  assign select_3043 = equal_1847_s4_q ? select_3041 : {2'h0, select_3042, select_2476, select_2473};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_360_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_475, and_451_s4_q, and_450_s4_q, and_425_s4_q, less_417_s4_q, less_416_s4_q, less_415_s4_q, less_414_s4_q, less_413_s4_q, less_412_s4_q, less_411_s4_q, less_410_s4_q, less_409_s4_q, less_408_s4_q, less_407_s4_q, less_406_s4_q, less_405_s4_q, less_404_s4_q, less_403_s4_q, less_402_s4_q, less_401_s4_q, less_400_s4_q, less_399_s4_q, less_398_s4_q, less_397_s4_q, less_396_s4_q, less_395_s4_q, less_394_s4_q};
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
  assign registration_sums_waddr = {sum_1853_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1909_s4_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_1908, sum_1904};
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
  assign regions_waddr = {region_row_s4_q, or_1919_s4_q, or_1916_s4_q, or_1913_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1948_s4_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_1947, sum_1941, sum_1936};
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
  assign map_waddr = {sum_1988_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_2063_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2053, is_seen};
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
      sharpness_before_last_mask_q <= 1'b0;
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
      census_left_misses_q <= select_2212;
      sharpness_before_last_mask_q <= select_2220;
      sharpness_sums_detail_0_q <= and_360_s4_q ? select_2234 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_360_s4_q ? select_2246 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_360_s4_q ? sum_2250 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_360_s4_q ? sum_2254 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2272 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2282 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2284 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2286 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2288 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2290 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2295;
      sharpness_comparing_carry_1_q <= select_2299;
      sharpness_comparing_less_detail_0_q <= select_2306;
      sharpness_comparing_less_detail_1_q <= select_2312;
      sharpness_comparing_less_contrast_0_q <= select_2318;
      sharpness_comparing_less_contrast_1_q <= select_2324;
      counts_supervised_q <= select_2430;
      counts_textured_q <= and_2424_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2433});
      counts_explained_q <= and_2424_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2438});
      counts_nearer_q <= and_2424_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2443});
      counts_unproven_q <= and_2424_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2469});
      counts_regions_bad_q <= select_2485;
      counts_skin_supervised_q <= select_2492;
      counts_skin_textured_q <= select_2499;
      counts_skin_unproven_q <= select_2507;
      registration_half_across_q <= select_2581;
      registration_half_measured_q <= select_2586;
      registration_half_votes_down_q <= and_2560_s4_q ? 7'h0 : sum_2592;
      registration_half_votes_up_q <= and_2560_s4_q ? 7'h0 : sum_2600;
      registration_half_half_votes_down_q <= and_2560_s4_q ? 7'h0 : sum_2607;
      registration_half_half_votes_up_q <= and_2560_s4_q ? 7'h0 : sum_2614;
      registration_down_q <= and_2648 ? sum_2667 : registration_down_q;
      registration_up_q <= and_2648 ? sum_2676 : registration_up_q;
      registration_enough_q <= select_2690;
      registration_votes_down_q <= and_2695 ? less_2696 : registration_votes_down_q;
      registration_votes_up_q <= and_2695 ? less_2698 : registration_votes_up_q;
      registration_other_enough_q <= and_2704 ? select_2690 : registration_other_enough_q;
      registration_other_down_q <= and_2704 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2704 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1802_s4_q & and_2711)) & or_2736;
      segment_textured_q <= select_1933 + {6'h0, and_2433};
      segment_explained_q <= select_1938 + {6'h0, and_2438};
      segment_nearer_q <= select_1944 + {6'h0, and_2443};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1802_s4_q ? select_2811 : good_q;
      good_known_q <= select_2816;
      hidden_for_q <= select_2830;
      product_q <= equal_1802_s4_q ? sum_3[14:1] : product_q;
      product_rest_q <= select_2851;
      disagree_q <= equal_1802_s4_q ? select_2803 : disagree_q;
      too_much_q <= equal_1802_s4_q ? select_2861 : too_much_q;
      hides_q <= equal_1802_s4_q ? select_2825 : hides_q;
      seen_q <= select_2983;
      nearer_q <= select_2986;
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
      averager_quarter_1_0_q <= select_2087;
      averager_quarter_1_1_q <= select_2089;
      averager_quarter_2_0_q <= select_2091;
      averager_quarter_2_1_q <= select_2093;
      averager_detail_0_q <= select_2105;
      averager_detail_1_q <= select_2113;
      census_changes_values_0_left_q <= and_360_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_360_s4_q ? sum_2196_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2198;
      census_changes_values_1_right_q <= select_2199;
      census_changes_values_2_left_q <= select_2200;
      census_changes_values_2_right_q <= select_2201;
      sharpness_last_mask_q <= and_360_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_360_s4_q ? select_2217[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_360_s4_q ? select_2217[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_2963_s5_q;
  logic or_2988_s5_q;
  logic and_2989_s5_q;
  logic and_2993_s5_q;
  logic and_2996_s5_q;
  logic and_3002_s5_q;
  logic and_3005_s5_q;
  logic and_3011_s5_q;
  logic and_3015_s5_q;
  logic and_3023_s5_q;
  logic and_3027_s5_q;
  logic [5:0] select_3029_s5_q;
  logic [31:0] select_3045_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_2963_s5_q <= said_q;
      or_2988_s5_q <= not_2987 | select_2983;
      and_2989_s5_q <= cfg_prove_i & select_2986;
      and_2993_s5_q <= and_2993_s4_q;
      and_2996_s5_q <= equal_1802_s4_q & (equal_2814_s4_q & (cfg_prove_i & or_2794));
      and_3002_s5_q <= and_3002;
      and_3005_s5_q <= and_3005;
      and_3011_s5_q <= equal_1802_s4_q & (equal_2814_s4_q & (not_2998 & or_3008));
      and_3015_s5_q <= and_3015;
      and_3023_s5_q <= equal_1802_s4_q & (equal_2814_s4_q & (cfg_prove_i & and_3020));
      and_3027_s5_q <= and_3027;
      select_3029_s5_q <= equal_1802_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3045_s5_q <= equal_1802_s4_q ? (x_s4_q[6] ? select_3043 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_2988_s5_q;
  assign marks_nearer_o = and_2989_s5_q;
  assign verdict_valid_o = and_2963_s5_q;
  assign verdict_unproven_yet_o = and_2993_s5_q;
  assign verdict_untextured_o = and_2996_s5_q;
  assign verdict_disagree_o = and_3002_s5_q;
  assign verdict_moved_o = and_3005_s5_q;
  assign verdict_unsharp_left_o = and_3011_s5_q;
  assign verdict_unsharp_right_o = and_3015_s5_q;
  assign verdict_hidden_o = and_3023_s5_q;
  assign frame_valid_o = and_3027_s5_q;
  assign frame_index_o = select_3029_s5_q;
  assign frame_word_o = select_3045_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_2547[0], sum_2543[0], sum_2529[0], detail_4[1:0], detail_3[1:0], sum_2206[4:0], sum_473[4:0], cfg_width_i[2:0]};

endmodule
